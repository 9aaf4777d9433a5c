// What a scene asks about a part, whatever it is made of: a convex shape, or many parts. In the plane all are convex.
#ifndef GJK_SRC_SCENE_SOLID_H
#define GJK_SRC_SCENE_SOLID_H

#include "gjk_scene_block.h"

#ifndef GJK_SCENE_OF_PLANE
#include "gjk_scene_travel.h"
#endif

#if GJK_SCENE_AXES == 3

// Queries of a pair. a, b: the parts; NULL: a collider that is no part. on_a, on_b: their posed colliders. Statuses and
// answers are those of the query of the library that each is named after; of concave parts a decision names no proof.
gjk_status gjk_scene_ask_within(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b,
                                const gjk_collider *on_a, const gjk_collider *on_b, gjk_q16 distance, gjk_cache *cache,
                                gjk_decision *out);

// Of a concave part distance, lower and, where it does not intersect, normal are set.
gjk_status gjk_scene_ask_distance(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b,
                                  const gjk_collider *on_a, const gjk_collider *on_b, gjk_cache *cache,
                                  gjk_distance_result *out);
gjk_status gjk_scene_ask_depth(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b,
                               const gjk_collider *on_a, const gjk_collider *on_b, gjk_cache *cache,
                               gjk_distance_result *out);

// A part that stands is A, and a collider that is no part moves, or a point does.
gjk_status gjk_scene_ask_cast(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_collider *on_a,
                              const gjk_collider *b, const gjk_cast_path *path, gjk_cast_result *out);
gjk_status gjk_scene_ask_ray(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_collider *on_a,
                             const gjk_vec3 *from, const gjk_vec3 *to, gjk_cast_result *out);

#else

static inline gjk_status gjk_scene_ask_within(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b,
                                              const gjk_collider *on_a, const gjk_collider *on_b, gjk_q16 distance,
                                              gjk_cache *cache, gjk_decision *out) {
  (void)v, (void)a, (void)b;
  return gjk_within(on_a, on_b, distance, cache, out);
}

static inline gjk_status gjk_scene_ask_distance(const gjk_scene_view *v, const gjk_scene_part *a,
                                                const gjk_scene_part *b, const gjk_collider *on_a,
                                                const gjk_collider *on_b, gjk_cache *cache, gjk_distance_result *out) {
  (void)v, (void)a, (void)b;
  return gjk_distance(on_a, on_b, cache, out);
}

static inline gjk_status gjk_scene_ask_depth(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b,
                                             const gjk_collider *on_a, const gjk_collider *on_b, gjk_cache *cache,
                                             gjk_distance_result *out) {
  (void)a, (void)b;
  return gjk_scene_signed_distance(v->scene, on_a, on_b, cache, out);
}

static inline gjk_status gjk_scene_ask_cast(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_collider *on_a,
                                            const gjk_collider *b, const gjk_cast_path *path, gjk_cast_result *out) {
  (void)v, (void)a;
  return gjk_cast(on_a, b, path, out);
}

static inline gjk_status gjk_scene_ask_ray(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_collider *on_a,
                                           const gjk_vec3 *from, const gjk_vec3 *to, gjk_cast_result *out) {
  (void)v, (void)a;
  return gjk_cast_ray(on_a, from, to, out);
}

#endif

#endif
