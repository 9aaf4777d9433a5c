// What a cast with a radius or margin knows of its way so far, and the faces of A - B that it looks at.
#ifndef GJK2_SRC_ADVANCE_FACE_H
#define GJK2_SRC_ADVANCE_FACE_H

#include "gjk2_cast_report.h"

// On processors with 64-bit registers, the direction of a touched corner's circle is tried first.
#if GJK_64_BIT && !GJK_SMALL
#define GJK2_DIRECT true
#else
#define GJK2_DIRECT false
#endif

// What is nearest at a place: a vertex p or an edge from p to q of A - B, and the direction from it.
typedef struct gjk2_face {
  gjk2_vec n;
  gjk2_span p, q;
  unsigned count;  // 1 or 2
} gjk2_face;

// Is it an edge? A build for circles alone has none.
static inline bool gjk2_face_is_edge(const gjk2_face *face) {
  return GJK_SHAPES >= GJK_SHAPES_ROUND && face->count == 2;
}

// A cast on its way.
typedef struct gjk2_advancing {
  gjk2_way *way;
  int64_t radius;  // convex radii and margin, and of curved shapes the error of their supports
  gjk_q16 margin;
  bool curved;
  bool point;        // A - B is a vertex alone, that of two circles
  bool centred;      // A - B is the same on both sides of the centres' difference
  bool nearest;      // the last gap's feature is exactly the nearest
  bool open;         // the last distance is only bounded
  bool late;         // polygons: whether the way ends before contact is open
  bool raw;          // the face's direction, from a vertex, has its exact length
  gjk_q30 fraction;  // no contact before
  gjk_q30 at;        // where foot is known, else -1
  int64_t foot;      // on the face's edge, gjk2_cast_foot
  gjk2_face face;    // of the last place that was looked at
  gjk2_distance_result gap;
} gjk2_advancing;

// Measures the gap at a fraction. Returns whether it is at most the margin: exact of polygons.
bool gjk2_face_is_near(gjk2_advancing *s, gjk_q30 fraction);

// Takes the direction, and of polygons the feature, from the last gap. An edge's normal is exact.
void gjk2_face_of_gap(const gjk2_advancing *s, gjk2_face *face);

// Finds whether the shapes intersect at a fraction, and the certificate; or the face.
// Pre: polygons. False: in a far frame it may be open.
bool gjk2_face_find(gjk2_advancing *s, gjk_q30 fraction);

// What that does for a vertex alone, where it is near. False: it is not, or the shapes intersect.
bool gjk2_face_at_vertex(gjk2_advancing *s);

// For a gap of less than an LSB that rounding the place of the fraction has closed: finds the face nearest to the exact
// place, by GJK from the face's first vertex, which is near. At the ceiling, which no known case reaches, it is another
// face.
void gjk2_face_touch(gjk2_advancing *s);

// Is a place within radius of the face? from: its vertex p. Exact for a radius below 2^29. False: or the place is far from p.
bool gjk2_face_is_within(const gjk2_advancing *s, const gjk2_face *face, const gjk2_long *from);

// Does the way come within radius of the face? Exact. False: it is not known. Pre: the radius is below 2^29.
bool gjk2_face_is_met(const gjk2_advancing *s, const gjk2_face *face);

// Loads a vertex of A - B by its numbers.
void gjk2_face_load(const gjk2_way *way, uint16_t a, uint16_t b, gjk2_span *out);

// Makes a direction a unit vector.
void gjk2_face_shorten(gjk2_vec *n);

#endif
