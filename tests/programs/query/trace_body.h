// The bodies behind the panels of a trace: A, B, and their Minkowski difference A - B, as outlines and faces.
#ifndef QUERY_TRACE_BODY_H
#define QUERY_TRACE_BODY_H

#include "../demo/draw.h"
#include "trace.h"

// A body in units; of the difference the cores, without convex radii.
typedef struct trace_body {
  real3 outline[OUTLINE_POINTS];  // in order around it, as seen by the view
  real3 core[OUTLINE_POINTS];     // the same without the convex radius
  size_t outlines;                // points in outline, and in core
  bool round;                     // the convex radius is not 0
  real_face faces[FACES_MAX];     // of the core; none in the plane, and of curved or large bodies
  size_t face_count;
} trace_body;

typedef struct trace_bodies {
  trace_body a, b, difference;
  view camera;
} trace_bodies;

// Builds the bodies of a pair in space, seen in a fixed parallel projection.
void trace_bodies_space(const case_pair *pair, trace_bodies *out);

// The same in the plane. a and b: the posed colliders of the pair.
void trace_bodies_plane(const case2_pair *pair, const gjk2_collider *a, const gjk2_collider *b, trace_bodies *out);

#endif
