// Queries: boxes, rays, the nearest part.
#include "../scene/gjk_scene_part.h"
#include "../scene/gjk_scene_solid.h"
#include "../scene/gjk_scene_tree.h"
#include "gjk_scene_hits.h"

gjk_status gjk_scene_query_box(const gjk_scene *scene, const gjk_aabb *box, const gjk_scene_hit *after,
                               gjk_scene_hit *hits, uint32_t capacity, uint32_t *count) {
  gjk_scene_view v;
  gjk_scene_walk walk;
  gjk_aabb room;
  const gjk_status status = gjk_scene_open_query(scene, box, hits, capacity, count, &v);
  if (status != GJK_OK) {
    return status;
  }
  if (gjk_aabb_is_empty(box)) {
    return GJK_ERROR_RANGE;
  }
  gjk_scene_hits c = {hits, capacity, 0, 0, after};
  gjk_scene_walk_start(&v, &walk);
  for (;;) {  // ends: the walk takes each node once
    const uint32_t part = gjk_scene_walk_meeting(&v, &walk, box);
    if (part == GJK_SCENE_NONE) {
      break;
    }
    const gjk_scene_part *p = &v.parts[part];
    if (gjk_aabb_meet(box, &p->exact) && gjk_aabb_meet(box, gjk_scene_part_box(&v, p, &room))) {
      gjk_scene_collect(&c, &v, part, 0);
    }
  }
  *count = gjk_scene_sort_hits(&c);
  return GJK_OK;
}

// An exact fraction of a ray's way: over / under.
//
// |over| <= 2^32, 0 < under <= 2^32
typedef struct way_fraction {
  int64_t over, under;
} way_fraction;

static bool is_less(const way_fraction *a, const way_fraction *b) {
  return gjk_sum_of_products_sign(a->over, b->under, -b->over, a->under) < 0;
}

static void set_fraction(way_fraction *f, int64_t over, int64_t under) {
  f->over = over;
  f->under = under;
}

// Narrows the part [enter, leave] of the way to what lies between the two planes of a box across one axis. False:
// nothing is left.
static bool clip_axis(gjk_q16 from, gjk_q16 to, gjk_q16 lower, gjk_q16 upper, way_fraction *enter,
                      way_fraction *leave) {
  if (from == to) {
    return lower <= from && from <= upper;
  }
  const bool up = to > from;
  const int64_t length = up ? (int64_t)to - from : (int64_t)from - to;
  way_fraction in, out;
  set_fraction(&in, up ? (int64_t)lower - from : (int64_t)from - upper, length);
  set_fraction(&out, up ? (int64_t)upper - from : (int64_t)from - lower, length);
  if (is_less(enter, &in)) {
    set_fraction(enter, in.over, length);
  }
  if (is_less(&out, leave)) {
    set_fraction(leave, out.over, length);
  }
  return !is_less(leave, enter);
}

// Does the segment between two points meet a box? Sets where it enters.
static bool cross_box(const gjk_vec3 *from, const gjk_vec3 *to, const gjk_aabb *box, way_fraction *enter) {
  way_fraction leave;
  set_fraction(enter, 0, 1);
  set_fraction(&leave, 1, 1);
  return clip_axis(from->x, to->x, box->lower.x, box->upper.x, enter, &leave) &&
         clip_axis(from->y, to->y, box->lower.y, box->upper.y, enter, &leave)
#if GJK_SCENE_AXES == 3
         && clip_axis(from->z, to->z, box->lower.z, box->upper.z, enter, &leave)
#endif
      ;
}

// floor(2^30 over / under), bit by bit. Pre: 0 <= over <= under.
static uint32_t in_q30(const way_fraction *f) {
  int64_t rest = f->over;
  uint32_t fraction = 0;
  if (rest == f->under) {
    return (uint32_t)GJK_Q30_ONE;
  }
  for (int i = 0; i < 30; i++) {
    //@ assert rest >= 0 && rest < 1LL << 32;
    rest *= 2;
    fraction *= 2;
    if (rest >= f->under) {
      rest -= f->under;
      fraction++;
    }
  }
  return fraction;
}

gjk_status gjk_scene_query_ray(const gjk_scene *scene, const gjk_vec3 *from, const gjk_vec3 *to,
                               const gjk_scene_hit *after, gjk_scene_hit *hits, uint32_t capacity, uint32_t *count) {
  gjk_scene_view v;
  gjk_scene_walk walk;
  const gjk_status status = to == NULL ? GJK_ERROR_NULL : gjk_scene_open_query(scene, from, hits, capacity, count, &v);
  if (status != GJK_OK) {
    return status;
  }
  gjk_scene_hits c = {hits, capacity, 0, 0, after};
  gjk_scene_walk_start(&v, &walk);
  for (uint32_t node = gjk_scene_walk_next(&walk); node != GJK_SCENE_NONE; node = gjk_scene_walk_next(&walk)) {
    way_fraction enter;
    gjk_aabb room;
    const gjk_aabb *box = (node & GJK_SCENE_LEAF) != 0 ? gjk_scene_part_box(&v, &v.parts[node & ~GJK_SCENE_LEAF], &room)
                                                       : &v.nodes[node].box;
    if (cross_box(from, to, box, &enter)) {
      if ((node & GJK_SCENE_LEAF) != 0) {
        gjk_scene_collect(&c, &v, node & ~GJK_SCENE_LEAF, in_q30(&enter));
      } else {
        gjk_scene_walk_descend(&v, &walk, node);
      }
    }
  }
  *count = gjk_scene_sort_hits(&c);
  return GJK_OK;
}

// By how much a reported distance may be less than the gap of the boxes, besides 2^-26 of it:
//
// two curved shapes   4
// shapes far apart    2^-27 of the distance, which grows by the 2^-26 above
//
// So a box beyond best + BOX_SLACK + 2^-26 best holds no part that counts. The answer does not depend on the order in
// which the tree is searched.
#define BOX_SLACK 6

typedef struct nearest_search {
  const gjk_collider *collider;
  gjk_aabb box;
  gjk_q16 best;  // the least distance found, or reach; parts farther away do not count
  bool found;
  gjk_scene_hit hit;
} nearest_search;

// Is all that a box holds too far away to count?
static bool is_beyond(const nearest_search *s, const gjk_aabb *box) {
  return gjk_aabb_gap(&s->box, box) > (int64_t)s->best + s->best / (INT32_C(1) << 26) + BOX_SLACK;
}

// The distance that counts for a part: where the query reaches its ceiling, the larger of two lower bounds.
static gjk_q16 distance_of(const gjk_scene_view *v, const gjk_scene_part *p, const nearest_search *s,
                           const gjk_collider *c, const gjk_aabb *box) {
  gjk_distance_result result;
  result.lower = 0;  // of data that were never checked no query sets it
  if (gjk_scene_ask_distance(v, NULL, p, s->collider, c, NULL, &result) == GJK_OK) {
    return result.distance;
  }
  const gjk_q16 gap = gjk_saturate(gjk_aabb_gap(&s->box, box));
  return result.lower > gap ? result.lower : gap;
}

static void try_part(const gjk_scene_view *v, uint32_t part, nearest_search *s) {
  const gjk_scene_part *p = &v->parts[part];
  gjk_collider c;
  gjk_aabb box;
  if (is_beyond(s, &p->exact)) {
    return;
  }
  gjk_scene_part_now(v, p, &c, &box);
  if (is_beyond(s, &box)) {
    return;
  }
  const gjk_q16 distance = distance_of(v, p, s, &c, &box);
  const gjk_scene_hit hit = gjk_scene_hit_of(v, p, 0);
  if (distance < s->best || (distance == s->best && (!s->found || gjk_scene_comes_before(&hit, &s->hit)))) {
    s->best = distance;
    s->found = true;
    s->hit = hit;
  }
}

gjk_status gjk_scene_query_nearest(const gjk_scene *scene, const gjk_collider *collider, gjk_q16 reach,
                                   const gjk_body_id *ignore, gjk_scene_hit *hit, gjk_q16 *distance, bool *found) {
  gjk_scene_view v;
  gjk_scene_walk walk;
  nearest_search s;
  s.collider = collider;
  s.best = reach;
  s.found = false;
  gjk_status status = hit == NULL || distance == NULL || found == NULL ? GJK_ERROR_NULL : gjk_scene_view_of(scene, &v);
  if (status == GJK_OK) {
    status = gjk_collider_aabb(collider, &s.box);
  }
  if (status == GJK_OK && reach < 0) {
    status = GJK_ERROR_NEGATIVE;
  }
  if (status != GJK_OK) {
    return status;
  }
  gjk_scene_walk_start(&v, &walk);
  for (uint32_t node = gjk_scene_walk_next(&walk); node != GJK_SCENE_NONE; node = gjk_scene_walk_next(&walk)) {
    if (is_beyond(&s, gjk_scene_node_box(&v, node))) {
      continue;
    }
    if ((node & GJK_SCENE_LEAF) == 0) {
      gjk_scene_walk_descend(&v, &walk, node);
      // The nearer child is searched first, which lowers best sooner.
      uint32_t *next = &walk.waiting[walk.count - 2];
      if (gjk_aabb_gap(&s.box, gjk_scene_node_box(&v, next[0])) <
          gjk_aabb_gap(&s.box, gjk_scene_node_box(&v, next[1]))) {
        const uint32_t nearer = next[0];
        next[0] = next[1];
        next[1] = nearer;
      }
      continue;
    }
    const uint32_t part = node & ~GJK_SCENE_LEAF;
    if (ignore == NULL || v.parts[part].body != ignore->slot ||
        v.bodies[ignore->slot].generation != ignore->generation) {
      try_part(&v, part, &s);
    }
  }
  *found = s.found;
  if (s.found) {
    *hit = s.hit;
    *distance = s.best;
  }
  return GJK_OK;
}
