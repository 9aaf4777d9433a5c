// Move and slide: how a character gets through a scene. It goes as far as it can, slides along what it meets, climbs
// low steps and stands on the ground.
//
// A slide consists of casts of gjk/probe.h. So it is as exact as they are, passes through nothing however far it goes,
// and depends on poses alone. It changes neither the scene nor the collider.
#ifndef GJK_SLIDE_H
#define GJK_SLIDE_H

#include "gjk/probe.h"

#ifdef __cplusplus
extern "C" {
#endif

// Lengths Q16.16.
typedef struct gjk_slide_setup {
  gjk_unit3 up;                    // Q2.30, a unit vector within 2^-16 (ROTATION)
  gjk_q30 slope;                   // the least cosine between up and the normal of ground to stand on: 0 to GJK_Q30_ONE
  gjk_q16 skin;                    // the gap kept from everything: GJK_SLIDE_SKIN_MIN to one unit
  gjk_q16 step;                    // the highest step to climb, from 0 (none) to GJK_RADIUS_MAX
  gjk_q16 reach;                   // how far below to look for ground, from 0 (not at all) to GJK_RADIUS_MAX
  bool snap;                       // true: the collider goes down to that ground
  const gjk_scene_filter *filter;  // what counts; NULL: all. Use it to leave out the character's own body
} gjk_slide_setup;

// What a slide meets.
typedef struct gjk_slide_plane {
  gjk_scene_hit part;  // its fraction is that of the cast that met it
  gjk_unit3 normal;    // away from it, Q2.30
} gjk_slide_plane;

// Where the collider gets, and what it met.
typedef struct gjk_slide_result {
  gjk_vec3 position;                        // of the collider's pose, where it gets
  gjk_vec3 left;                            // rest of the way, if stuck or once GJK_SLIDE_PLANES are met
  gjk_slide_plane plane[GJK_SLIDE_PLANES];  // planes that it slid along, in this order
  uint8_t count;                            // number of planes
  bool on_ground;                           // it stands on something
  gjk_slide_plane ground;                   // set if on_ground
  bool stepped;                             // it climbed a step
  bool stuck;     // it overlaps something at the start, or after ITERATION_LIMIT may do so, and was not moved
  uint8_t casts;  // number of casts that it took
} gjk_slide_result;

// Moves a collider towards to.
//
// collider  posed; of any kind, but meant for capsules and boxes. If it touches something, or is nearer to it than
//           skin, it first moves away.
// to        its position at the end if nothing is in the way: less than 2^29 LSB away along each axis (RANGE).
// out       the caller's.
// Cost      at most GJK_SLIDE_CASTS casts.
// Statuses  NULL, UNINITIALISED, RANGE (setup, way, or the centre leaves int32), ROTATION: out is as it was.
//           ITERATION_LIMIT: a cast against a curved shape reached its ceiling. out is set; the collider stopped before
//           that shape.
gjk_status gjk_slide(const gjk_scene *scene, const gjk_collider *collider, const gjk_vec3 *to,
                     const gjk_slide_setup *setup, gjk_slide_result *out);

#ifdef __cplusplus
}
#endif

#endif
