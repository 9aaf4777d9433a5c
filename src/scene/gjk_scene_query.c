// Queries: boxes, rays, the nearest part.
#include "../arith/gjk_vector.h"
#include "gjk/distance.h"
#include "gjk_scene_part.h"
#include "gjk_scene_tree.h"

// Hits in order: a heap with the last on top while there are more than fit, sorted in the end.
typedef struct collection {
  gjk_scene_hit *hits;
  uint32_t capacity, kept, found;
  const gjk_scene_hit *after;
} collection;

static gjk_scene_hit hit_of(const gjk_scene_view *v, const gjk_scene_part *p, uint32_t fraction) {
  gjk_scene_hit hit;
  hit.body = gjk_scene_id_of(v, p->body);
  hit.part = p->number;
  hit.fraction = fraction;
  return hit;
}

// Does a come before b?
static bool before(const gjk_scene_hit *a, const gjk_scene_hit *b) {
  if (a->fraction != b->fraction) {
    return a->fraction < b->fraction;
  }
  return a->body.slot != b->body.slot ? a->body.slot < b->body.slot : a->part < b->part;
}

static void sift_hit(gjk_scene_hit *hits, uint32_t at, uint32_t count) {
  const gjk_scene_hit sinking = hits[at];
  for (uint32_t child = 2 * at + 1; child < count; child = 2 * at + 1) {  // at most log2 count iterations
    if (child + 1 < count && before(&hits[child], &hits[child + 1])) {
      child++;
    }
    if (!before(&sinking, &hits[child])) {
      break;
    }
    hits[at] = hits[child];
    at = child;
  }
  hits[at] = sinking;
}

static void make_heap(collection *c) {
  for (uint32_t i = c->kept / 2; i > 0; i--) {
    sift_hit(c->hits, i - 1, c->kept);
  }
}

static void collect(collection *c, const gjk_scene_view *v, uint32_t part, uint32_t fraction) {
  const gjk_scene_part *p = &v->parts[part];
  const gjk_scene_hit hit = hit_of(v, p, fraction);
  if (c->after != NULL && !before(c->after, &hit)) {
    return;
  }
  c->found++;
  if (c->kept < c->capacity) {
    c->hits[c->kept++] = hit;
    if (c->kept == c->capacity) {
      make_heap(c);
    }
  } else if (c->capacity > 0 && before(&hit, &c->hits[0])) {
    c->hits[0] = hit;
    sift_hit(c->hits, 0, c->kept);
  }
}

static void sort_hits(collection *c) {
  make_heap(c);
  for (uint32_t end = c->kept; end > 1; end--) {
    const gjk_scene_hit last = c->hits[0];
    c->hits[0] = c->hits[end - 1];
    c->hits[end - 1] = last;
    sift_hit(c->hits, 0, end - 1);
  }
}

static gjk_status open_query(const gjk_scene *scene, const void *question, const gjk_scene_hit *hits, uint32_t capacity,
                             const uint32_t *count, gjk_scene_view *v) {
  return question == NULL || count == NULL || (hits == NULL && capacity > 0) ? GJK_ERROR_NULL
                                                                             : gjk_scene_view_of(scene, v);
}

gjk_status gjk_scene_query_box(const gjk_scene *scene, const gjk_aabb *box, const gjk_scene_hit *after,
                               gjk_scene_hit *hits, uint32_t capacity, uint32_t *count) {
  gjk_scene_view v;
  gjk_scene_walk walk;
  const gjk_status status = open_query(scene, box, hits, capacity, count, &v);
  if (status != GJK_OK) {
    return status;
  }
  if (box->lower.x > box->upper.x || box->lower.y > box->upper.y || box->lower.z > box->upper.z) {
    return GJK_ERROR_RANGE;
  }
  collection c = {hits, capacity, 0, 0, after};
  gjk_scene_walk_start(&v, &walk);
  for (;;) {  // ends: as the walk
    const uint32_t part = gjk_scene_walk_meeting(&v, &walk, box);
    if (part == GJK_SCENE_NONE) {
      break;
    }
    if (gjk_aabb_meet(box, &v.parts[part].exact)) {
      collect(&c, &v, part, 0);
    }
  }
  sort_hits(&c);
  *count = c.found;
  return GJK_OK;
}

// A share of the way: over / under, 0 < under <= 2^32, |over| <= 2^32.
typedef struct share {
  int64_t over, under;
} share;

static bool less(const share *a, const share *b) {
  return gjk_sum_of_products_sign(a->over, b->under, -b->over, a->under) < 0;
}

static void set_share(share *s, int64_t over, int64_t under) {
  s->over = over;
  s->under = under;
}

// Narrows [enter, leave] to where the way is between the two planes of one axis. False: nowhere.
static bool clip_axis(gjk_q16 from, gjk_q16 to, gjk_q16 lower, gjk_q16 upper, share *enter, share *leave) {
  if (from == to) {
    return lower <= from && from <= upper;
  }
  const bool up = to > from;
  const int64_t length = up ? (int64_t)to - from : (int64_t)from - to;
  share in, out;
  set_share(&in, up ? (int64_t)lower - from : (int64_t)from - upper, length);
  set_share(&out, up ? (int64_t)upper - from : (int64_t)from - lower, length);
  if (less(enter, &in)) {
    set_share(enter, in.over, length);
  }
  if (less(&out, leave)) {
    set_share(leave, out.over, length);
  }
  return !less(leave, enter);
}

static bool cross_box(const gjk_vec3 *from, const gjk_vec3 *to, const gjk_aabb *box, share *enter) {
  share leave;
  set_share(enter, 0, 1);
  set_share(&leave, 1, 1);
  return clip_axis(from->x, to->x, box->lower.x, box->upper.x, enter, &leave) &&
         clip_axis(from->y, to->y, box->lower.y, box->upper.y, enter, &leave) &&
         clip_axis(from->z, to->z, box->lower.z, box->upper.z, enter, &leave);
}

// floor(2^30 over / under), bit by bit. Pre: 0 <= over <= under.
static uint32_t fraction_of(const share *s) {
  int64_t rest = s->over;
  uint32_t fraction = 0;
  if (rest == s->under) {
    return (uint32_t)GJK_Q30_ONE;
  }
  for (int i = 0; i < 30; i++) {
    //@ assert rest >= 0 && rest < 1LL << 32;
    rest *= 2;
    fraction *= 2;
    if (rest >= s->under) {
      rest -= s->under;
      fraction++;
    }
  }
  return fraction;
}

gjk_status gjk_scene_query_ray(const gjk_scene *scene, const gjk_vec3 *from, const gjk_vec3 *to,
                               const gjk_scene_hit *after, gjk_scene_hit *hits, uint32_t capacity, uint32_t *count) {
  gjk_scene_view v;
  gjk_scene_walk walk;
  const gjk_status status = to == NULL ? GJK_ERROR_NULL : open_query(scene, from, hits, capacity, count, &v);
  if (status != GJK_OK) {
    return status;
  }
  collection c = {hits, capacity, 0, 0, after};
  gjk_scene_walk_start(&v, &walk);
  for (uint32_t node = gjk_scene_walk_next(&walk); node != GJK_SCENE_NONE; node = gjk_scene_walk_next(&walk)) {
    share enter;
    const gjk_aabb *box = (node & GJK_SCENE_LEAF) != 0 ? &v.parts[node & ~GJK_SCENE_LEAF].exact : &v.nodes[node].box;
    if (cross_box(from, to, box, &enter)) {
      if ((node & GJK_SCENE_LEAF) != 0) {
        collect(&c, &v, node & ~GJK_SCENE_LEAF, fraction_of(&enter));
      } else {
        gjk_scene_walk_descend(&v, &walk, node);
      }
    }
  }
  sort_hits(&c);
  *count = c.found;
  return GJK_OK;
}

// A distance may be reported less than that of the boxes: of two curved shapes by up to 4 LSB, of shapes far apart by
// up to 2^-27 of itself. A box beyond best + BOX_SLACK + 2^-26 best holds nothing that counts, in whatever order the
// tree is gone through.
#define BOX_SLACK 6

typedef struct nearest_search {
  const gjk_collider *collider;
  gjk_aabb box;
  gjk_q16 best;  // what is farther is of no interest
  bool found;
  gjk_scene_hit hit;
} nearest_search;

static bool beyond(const nearest_search *s, const gjk_aabb *box) {
  return gjk_aabb_gap(&s->box, box) > (int64_t)s->best + s->best / (INT32_C(1) << 26) + BOX_SLACK;
}

// Where the query reaches its ceiling, the larger of the bounds that it and the boxes prove.
static gjk_q16 distance_of(const nearest_search *s, const gjk_collider *c, const gjk_aabb *box) {
  gjk_distance_result result;
  if (gjk_distance(s->collider, c, NULL, &result) == GJK_OK) {
    return result.distance;
  }
  const gjk_q16 gap = gjk_saturate(gjk_aabb_gap(&s->box, box));
  return result.lower > gap ? result.lower : gap;
}

static void try_part(const gjk_scene_view *v, uint32_t part, nearest_search *s) {
  const gjk_scene_part *p = &v->parts[part];
  gjk_collider c;
  if (beyond(s, &p->exact)) {
    return;
  }
  gjk_scene_part_collider(v, p, &c);
  const gjk_q16 distance = distance_of(s, &c, &p->exact);
  const gjk_scene_hit hit = hit_of(v, p, 0);
  if (distance < s->best || (distance == s->best && (!s->found || before(&hit, &s->hit)))) {
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
    if (beyond(&s, gjk_scene_node_box(&v, node))) {
      continue;
    }
    if ((node & GJK_SCENE_LEAF) == 0) {
      gjk_scene_walk_descend(&v, &walk, node);
      // The nearer child first.
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
