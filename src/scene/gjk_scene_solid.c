// What a scene asks about a part, whatever it is made of.
#include "gjk_scene_solid.h"

#include "gjk_scene_concave.h"
#include "gjk_scene_part.h"

// A pair one of which is concave, where its parts are.
typedef struct solid_pair {
  gjk_pose pose[2];
  gjk_scene_solid a, b;
  const struct gjk_scene_concave *queries;
} solid_pair;

static void set_solid(const gjk_scene_view *v, const gjk_scene_part *part, const gjk_collider *on, gjk_pose *pose,
                      gjk_scene_solid *out) {
  out->collider = on;
  out->pose = pose;
  if (part != NULL) {
    gjk_scene_part_pose(v, part, pose);
  }
}

static bool is_any_concave(const gjk_collider *a, const gjk_collider *b) {
  return gjk_scene_is_concave(a->shape) || gjk_scene_is_concave(b->shape);
}

static void set_pair(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b,
                     const gjk_collider *on_a, const gjk_collider *on_b, solid_pair *out) {
  set_solid(v, a, on_a, &out->pose[0], &out->a);
  set_solid(v, b, on_b, &out->pose[1], &out->b);
  out->queries = gjk_scene_is_concave(on_a->shape) ? on_a->shape->type->concave : on_b->shape->type->concave;
}

GJK_OUT_OF_LINE static gjk_status within_concave(const gjk_scene_view *v, const gjk_scene_part *a,
                                                 const gjk_scene_part *b, const gjk_collider *on_a,
                                                 const gjk_collider *on_b, gjk_q16 distance, gjk_decision *out) {
  solid_pair p;
  set_pair(v, a, b, on_a, on_b, &p);
  const gjk_status status = p.queries->within(&p.a, &p.b, distance, out);
  out->certificate.proof = GJK_PROOF_NONE;  // its vertices are of the parts
  return status;
}

gjk_status gjk_scene_ask_within(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b,
                                const gjk_collider *on_a, const gjk_collider *on_b, gjk_q16 distance, gjk_cache *cache,
                                gjk_decision *out) {
  return is_any_concave(on_a, on_b) ? within_concave(v, a, b, on_a, on_b, distance, out)
                                    : gjk_within(on_a, on_b, distance, cache, out);
}

// depth: overlapping parts have one.
GJK_OUT_OF_LINE static gjk_status distance_of_concave(const gjk_scene_view *v, const gjk_scene_part *a,
                                                      const gjk_scene_part *b, const gjk_collider *on_a,
                                                      const gjk_collider *on_b, bool depth, gjk_distance_result *out) {
  solid_pair p;
  gjk_workspace workspace;
  set_pair(v, a, b, on_a, on_b, &p);
  if (depth) {
    gjk_scene_workspace(v->scene, &workspace);
  }
  return p.queries->distance(&p.a, &p.b, depth ? &workspace : NULL, out);
}

gjk_status gjk_scene_ask_distance(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b,
                                  const gjk_collider *on_a, const gjk_collider *on_b, gjk_cache *cache,
                                  gjk_distance_result *out) {
  return is_any_concave(on_a, on_b) ? distance_of_concave(v, a, b, on_a, on_b, false, out)
                                    : gjk_distance(on_a, on_b, cache, out);
}

gjk_status gjk_scene_ask_depth(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_scene_part *b,
                               const gjk_collider *on_a, const gjk_collider *on_b, gjk_cache *cache,
                               gjk_distance_result *out) {
  return is_any_concave(on_a, on_b) ? distance_of_concave(v, a, b, on_a, on_b, true, out)
                                    : gjk_scene_signed_distance(v->scene, on_a, on_b, cache, out);
}

GJK_OUT_OF_LINE static gjk_status cast_at_concave(const gjk_scene_view *v, const gjk_scene_part *a,
                                                  const gjk_collider *on_a, const gjk_collider *b,
                                                  const gjk_cast_path *path, gjk_cast_result *out) {
  solid_pair p;
  set_pair(v, a, NULL, on_a, b, &p);
  return p.queries->cast(&p.a, &p.b, path, out);
}

gjk_status gjk_scene_ask_cast(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_collider *on_a,
                              const gjk_collider *b, const gjk_cast_path *path, gjk_cast_result *out) {
  return gjk_scene_is_concave(on_a->shape) ? cast_at_concave(v, a, on_a, b, path, out) : gjk_cast(on_a, b, path, out);
}

GJK_OUT_OF_LINE static gjk_status ray_at_concave(const gjk_scene_view *v, const gjk_scene_part *a,
                                                 const gjk_collider *on_a, const gjk_vec3 *from, const gjk_vec3 *to,
                                                 gjk_cast_result *out) {
  gjk_pose pose;
  gjk_scene_solid solid;
  set_solid(v, a, on_a, &pose, &solid);
  return on_a->shape->type->concave->ray(&solid, from, to, out);
}

gjk_status gjk_scene_ask_ray(const gjk_scene_view *v, const gjk_scene_part *a, const gjk_collider *on_a,
                             const gjk_vec3 *from, const gjk_vec3 *to, gjk_cast_result *out) {
  return gjk_scene_is_concave(on_a->shape) ? ray_at_concave(v, a, on_a, from, to, out)
                                           : gjk_cast_ray(on_a, from, to, out);
}
