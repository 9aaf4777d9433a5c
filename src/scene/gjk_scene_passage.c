// What of the tree a box meets on a straight way.
#include "gjk_scene_passage.h"

#include "gjk_scene_part.h"

// A coordinate of a box at the end of int32 may stand for one farther out.
static void set_axis(gjk_scene_axis *a, gjk_q16 lower, gjk_q16 upper, int64_t grow, gjk_q16 from, gjk_q16 to) {
  const bool down = to < from;
  const int64_t low = (down ? ~(int64_t)upper : lower) - grow, high = (down ? ~(int64_t)lower : upper) + grow;
  a->mirror = down ? -1 : 0;
  a->lower = low > INT32_MIN ? (int32_t)low : INT32_MIN;
  a->upper = high < INT32_MAX ? (int32_t)high : INT32_MAX;
  a->length = gjk_scene_difference(from, to);
  a->leaving = low > INT32_MIN ? a->length : 0;
  a->scale = a->length != 0 ? gjk_clz32(a->length) : 0;
  a->inverse = UINT32_MAX / ((a->length << a->scale >> 16) + 1);
}

// A fraction of the way, Q30, rounded down.
//
// With n = 2^scale length and h the divisor above:  n < 2^16 h,  inverse <= 2^32 / h:
// x inverse / 2^32 <= 2^scale x / h' with h' = n / 2^16, so the result is at most 2^30 x / length.
// inverse >= 2^32 / h - 1 and h <= n / 2^16 + 1, h > 2^15:  it is less by at most 3 2^-16 of itself, and by 1.
// 2^scale x < 2^32, inverse < 2^17:  the product < 2^49
static uint32_t passage_fraction(const gjk_scene_axis *a, uint32_t x) {
  return (uint32_t)(gjk_umul32(x << a->scale, a->inverse) >> 18);
}

// Narrows the part of the way in which the box meets another one to what one axis leaves. False: nothing is left.
static inline bool narrow_passage(const gjk_scene_axis *a, gjk_q16 lower, gjk_q16 upper, uint32_t *in, uint32_t *out) {
  const int32_t near = (a->mirror != 0 ? upper : lower) ^ a->mirror, far = (a->mirror != 0 ? lower : upper) ^ a->mirror;
  if (far < a->lower) {
    return false;
  }
  if (near > a->upper) {
    const uint32_t enters = (uint32_t)near - (uint32_t)a->upper;
    if (enters > a->length) {
      return false;
    }
    *in = gjk_scene_larger(*in, passage_fraction(a, enters));
  }
  const uint32_t leaves = (uint32_t)far - (uint32_t)a->lower;
  if (leaves < a->leaving) {
    const uint32_t left = passage_fraction(a, leaves);
    const uint32_t end = left + (left >> 14) + 2;
    *out = end < *out ? end : *out;
  }
  return *in <= *out;
}

// Does the box meet another one before latest? Sets from where on.
static bool meets(const gjk_scene_passage *p, const gjk_aabb *box, uint32_t *in) {
  uint32_t out = p->latest;
  *in = 0;
  return narrow_passage(&p->axis[0], box->lower.x, box->upper.x, in, &out) &&
         narrow_passage(&p->axis[1], box->lower.y, box->upper.y, in, &out)
#if GJK_SCENE_AXES == 3
         && narrow_passage(&p->axis[2], box->lower.z, box->upper.z, in, &out)
#endif
      ;
}

static const gjk_aabb *box_of(const gjk_scene_view *v, uint32_t node) {
  return (node & GJK_SCENE_LEAF) != 0 ? &v->parts[node & ~GJK_SCENE_LEAF].exact : &v->nodes[node].box;
}

// Makes a node wait, if the box meets it.
static void push(const gjk_scene_view *v, gjk_scene_passage *p, uint32_t node) {
  uint32_t entered;
  if (meets(p, box_of(v, node), &entered)) {
    //@ assert p->count < GJK_SCENE_DEPTH;
    p->waiting[p->count] = node;
    p->entered[p->count] = entered;
    p->count++;
  }
}

static void aim_passage(gjk_scene_passage *p, const gjk_aabb *box, int64_t grow, const gjk_vec3 *from,
                        const gjk_vec3 *to) {
  set_axis(&p->axis[0], box->lower.x, box->upper.x, grow, from->x, to->x);
  set_axis(&p->axis[1], box->lower.y, box->upper.y, grow, from->y, to->y);
#if GJK_SCENE_AXES == 3
  set_axis(&p->axis[2], box->lower.z, box->upper.z, grow, from->z, to->z);
#endif
  p->latest = (uint32_t)GJK_Q30_ONE;
  p->count = 0;
}

void gjk_scene_passage_start(const gjk_scene_view *v, gjk_scene_passage *p, const gjk_aabb *box, int64_t grow,
                             const gjk_vec3 *from, const gjk_vec3 *to) {
  aim_passage(p, box, grow, from, to);
  if (v->header->root != GJK_SCENE_NONE) {
    push(v, p, v->header->root);
  }
}

void gjk_scene_passage_start_among(const gjk_scene_view *v, gjk_scene_passage *p, const gjk_aabb *box, int64_t grow,
                                   const gjk_vec3 *from, const gjk_vec3 *to, const uint32_t *parts, unsigned count) {
  aim_passage(p, box, grow, from, to);
  for (unsigned i = 0; i < count; i++) {
    push(v, p, parts[i] | GJK_SCENE_LEAF);
  }
}

// Makes those children of a node wait that the box meets, the one that it meets sooner on top.
static void descend(const gjk_scene_view *v, gjk_scene_passage *p, uint32_t node) {
  const unsigned before = p->count;
  push(v, p, v->nodes[node].child[1]);
  push(v, p, v->nodes[node].child[0]);
  if (p->count == before + 2 && p->entered[before] < p->entered[before + 1]) {
    const uint32_t sooner = p->waiting[before], entered = p->entered[before];
    p->waiting[before] = p->waiting[before + 1];
    p->entered[before] = p->entered[before + 1];
    p->waiting[before + 1] = sooner;
    p->entered[before + 1] = entered;
  }
}

uint32_t gjk_scene_passage_next(const gjk_scene_view *v, gjk_scene_passage *p, uint32_t *entered) {
  gjk_aabb room;
  while (p->count > 0) {  // ends: each node waits once
    const uint32_t node = p->waiting[--p->count];
    *entered = p->entered[p->count];
    if (*entered > p->latest) {
      continue;
    }
    if ((node & GJK_SCENE_LEAF) == 0) {
      descend(v, p, node);
      continue;
    }
    const uint32_t part = node & ~GJK_SCENE_LEAF;
    if ((v->parts[part].state & GJK_SCENE_UNPOSED) == 0 ||
        meets(p, gjk_scene_part_box(v, &v->parts[part], &room), entered)) {
      return part;
    }
  }
  return GJK_SCENE_NONE;
}
