// Rays, casts and distances against the shapes of a scene of the plane.
//
// These queries see the current poses, even between updates. Each tests only the parts whose boxes, enlarged by a
// margin, meet the way. The answer does not depend on the tree.
//
// Threads  several queries of one scene may run at once.
// Statuses of every call: NULL for a pointer that is missing; CORRUPT for a handle whose block is not a scene's.
#ifndef GJK2_PROBE_H
#define GJK2_PROBE_H

#include "gjk2/cast.h"
#include "gjk2/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

// Finds the part that the segment between two points enters first, by (fraction, slot, part).
//
// filter    which parts count; NULL: all.
// found     whether there is one. Only then hit and result are written. result is that of gjk2_cast_ray for that part.
// Statuses  ITERATION_LIMIT: the cast of the first hit reached its ceiling. hit holds a fraction before which nothing
//           is met, and the part that may be met there; result is not written.
gjk_status gjk2_scene_cast_ray(const gjk2_scene *scene, const gjk2_vec *from, const gjk2_vec *to,
                               const gjk_scene_filter *filter, gjk_scene_hit *hit, gjk2_cast_result *result,
                               bool *found);

// Finds all parts that the segment meets, in the order of (fraction, slot, part), with the fractions of gjk2_cast_ray.
// If a cast reaches its ceiling, it reports the part at a fraction before which the part is not met. after, hits and
// count are as in gjk2_scene_query_box.
gjk_status gjk2_scene_cast_ray_all(const gjk2_scene *scene, const gjk2_vec *from, const gjk2_vec *to,
                                   const gjk_scene_filter *filter, const gjk_scene_hit *after, gjk_scene_hit *hits,
                                   uint32_t capacity, uint32_t *count);

// As gjk2_scene_cast_ray, for a collider that moves in a straight line to the position to. result is that of gjk2_cast
// with the part as A, which stands still.
//
// collider  posed.
// margin    the gap at which shapes count as touching.
// Statuses  UNINITIALISED, NEGATIVE (margin), RANGE (the centre leaves int32), and those of gjk2_scene_cast_ray.
gjk_status gjk2_scene_cast(const gjk2_scene *scene, const gjk2_collider *collider, const gjk2_vec *to, gjk_q16 margin,
                           const gjk_scene_filter *filter, gjk_scene_hit *hit, gjk2_cast_result *result, bool *found);

// As gjk2_scene_cast_ray_all, for a collider.
gjk_status gjk2_scene_cast_all(const gjk2_scene *scene, const gjk2_collider *collider, const gjk2_vec *to,
                               gjk_q16 margin, const gjk_scene_filter *filter, const gjk_scene_hit *after,
                               gjk_scene_hit *hits, uint32_t capacity, uint32_t *count);

// Finds the parts that are at most reach away from a posed collider, in the order of (slot, part). With reach 0 these
// are the parts that share a point with it. gjk2_within decides; if it reaches its ceiling, the part counts as near.
// after, hits and count are as in gjk2_scene_query_box. Statuses: UNINITIALISED, NEGATIVE (reach).
gjk_status gjk2_scene_query_within(const gjk2_scene *scene, const gjk2_collider *collider, gjk_q16 reach,
                                   const gjk_scene_filter *filter, const gjk_scene_hit *after, gjk_scene_hit *hits,
                                   uint32_t capacity, uint32_t *count);

#ifdef __cplusplus
}
#endif

#endif
