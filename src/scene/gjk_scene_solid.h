// What a scene asks about a part, whatever it is made of: a convex shape, many parts or, in the plane, ground.
#ifndef GJK_SRC_SCENE_SOLID_H
#define GJK_SRC_SCENE_SOLID_H

#include "gjk_scene_block.h"

#ifndef GJK_SCENE_OF_PLANE
#include "gjk_scene_travel.h"
#endif

#if GJK_SCENE_AXES == 3

// Queries of a pair. a, b: the parts; NULL: a collider that is no part. on_a, on_b: their posed colliders. Statuses and
// answers are those of the library's query that each is named after. A decision about concave parts names no proof.
gjk_status gjk_scene_ask_within(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b,
                                const gjk_collider *on_a, const gjk_collider *on_b, gjk_q16 distance, gjk_cache *cache,
                                gjk_decision *out);

// For a concave part distance and lower are set, and normal if it does not intersect.
gjk_status gjk_scene_ask_distance(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b,
                                  const gjk_collider *on_a, const gjk_collider *on_b, gjk_cache *cache,
                                  gjk_distance_result *out);
gjk_status gjk_scene_ask_depth(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b,
                               const gjk_collider *on_a, const gjk_collider *on_b, gjk_cache *cache,
                               gjk_distance_result *out);

// A is a part that stands. A collider that is no part moves, or a point does.
gjk_status gjk_scene_ask_cast(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_collider *on_a,
                              const gjk_collider *b, const gjk_cast_path *path, gjk_cast_result *out);
gjk_status gjk_scene_ask_ray(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_collider *on_a,
                             const gjk_vec3 *from, const gjk_vec3 *to, gjk_cast_result *out);

#else

// The queries of ground, if one of two is ground; otherwise NULL.
static inline const struct gjk_ground_queries *gjk_scene_ground_of(const gjk_collider *a, const gjk_collider *b) {
  const struct gjk_ground_queries *of_a = a->shape->type->ground;
  return of_a != NULL ? of_a : b->shape->type->ground;
}

static inline gjk_status gjk_scene_ask_within(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b,
                                              const gjk_collider *on_a, const gjk_collider *on_b, gjk_q16 distance,
                                              gjk_cache *cache, gjk_decision *out) {
  const struct gjk_ground_queries *ground = gjk_scene_ground_of(on_a, on_b);
  return ground != NULL ? ground->within(v, a, b, on_a, on_b, distance, out)
                        : gjk_within(on_a, on_b, distance, cache, out);
}

static inline gjk_status gjk_scene_ask_distance(const gjk_scene_view *v, const gjk_scene_part *a,
                                                const gjk_scene_part *b, const gjk_collider *on_a,
                                                const gjk_collider *on_b, gjk_cache *cache, gjk_distance_result *out) {
  const struct gjk_ground_queries *ground = gjk_scene_ground_of(on_a, on_b);
  return ground != NULL ? ground->distance(v, a, b, on_a, on_b, false, out) : gjk_distance(on_a, on_b, cache, out);
}

static inline gjk_status gjk_scene_ask_depth(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b,
                                             const gjk_collider *on_a, const gjk_collider *on_b, gjk_cache *cache,
                                             gjk_distance_result *out) {
  const struct gjk_ground_queries *ground = gjk_scene_ground_of(on_a, on_b);
  return ground != NULL ? ground->distance(v, a, b, on_a, on_b, true, out)
                        : gjk_scene_signed_distance(v->scene, on_a, on_b, cache, out);
}

static inline gjk_status gjk_scene_ask_cast(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_collider *on_a,
                                            const gjk_collider *b, const gjk_cast_path *path, gjk_cast_result *out) {
  const struct gjk_ground_queries *ground = on_a->shape->type->ground;
  return ground != NULL ? ground->cast(v, a, on_a, b, path, out) : gjk_cast(on_a, b, path, out);
}

static inline gjk_status gjk_scene_ask_ray(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_collider *on_a,
                                           const gjk_vec3 *from, const gjk_vec3 *to, gjk_cast_result *out) {
  const struct gjk_ground_queries *ground = on_a->shape->type->ground;
  return ground != NULL ? ground->ray(v, a, on_a, from, to, out) : gjk_cast_ray(on_a, from, to, out);
}

#endif

#endif
