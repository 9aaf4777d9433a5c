// The best candidate for the nearest facet.
#include "gjk_facet.h"

#include "../arith/gjk_unit.h"

// The height of the plane through w with the outward unit normal u.
static uint32_t height_along(const gjk_unit3 *u, const gjk_vec3 *w) {
  const int64_t along = gjk_sar64(gjk_along(u, w), 30);
  // not reached: GJK_HEIGHT_MAX: the reach is below 2^30, and at least 8 more than |w|, since core radii have slack
  return along <= 0 ? 0 : along < GJK_HEIGHT_MAX ? (uint32_t)along : GJK_HEIGHT_MAX;
}

uint32_t gjk_height(const gjk_vec3 *d, const gjk_vec3 *w) {
  const gjk_unit3 u = gjk_unit(d);
  return height_along(&u, w);
}

// The highest key that a plane of at most this height may have.
static uint32_t highest_key(uint32_t height) {
  return gjk_height_key(height + GJK_HEIGHT_ERROR, 1) + GJK_HEIGHT_KEY_ERROR;
}

bool gjk_facet_may_improve(const gjk_facet *best, int shift, uint32_t key) {
  if (!best->found) {
    return true;
  }
  // A better plane has at most this depth: less than a candidate that covers, no more than one that does not.
  const gjk_q16 deepest = best->covers ? best->depth - 1 : best->depth;
  return deepest >= 0 && key <= highest_key((uint32_t)deepest << shift);
}

bool gjk_facet_may_tie(const gjk_facet *best, uint32_t key) {
  return !best->found || key <= highest_key(height_along(&best->normal, &best->corner[0].w) + GJK_HEIGHT_ERROR);
}

int gjk_facet_compare(gjk_facet *best, gjk_iteration *it) {
  gjk_simplex *s = &it->simplex;
  const gjk_vec3 *one = &best->corner[0].w;
  gjk_long3 n;
  gjk_triangle_normal(one, &best->corner[1].w, &best->corner[2].w, &n);
  // Mostly it is the same plane, of another triangle of the facet.
  unsigned level = 0;
  for (gjk_vec3 step = gjk_sub(s->slot[0].w, *one); gjk_dot_sign(&n, &step) == 0;) {
    if (++level == 3) {
      return 0;
    }
    step = gjk_sub(s->slot[level].w, *one);
  }
  const uint32_t height = gjk_height(&it->direction.d, &s->slot[0].w), of_best = height_along(&best->normal, one);
  if (height + 2 * GJK_HEIGHT_ERROR < of_best || height > of_best + 2 * GJK_HEIGHT_ERROR) {
    return height < of_best ? -1 : 1;
  }
  gjk_u192 numerator, denominator, numerator_of_best, denominator_of_best;
  gjk_simplex_set(s, 3);
  gjk_simplex_squared_distance(s, &numerator, &denominator);
  for (int i = 0; i < 3; i++) {
    s->slot[i].w = best->corner[i].w;
  }
  gjk_simplex_set(s, 3);
  gjk_simplex_squared_distance(s, &numerator_of_best, &denominator_of_best);
  return gjk_u192_compare_quotients(&numerator, &denominator, &numerator_of_best, &denominator_of_best);
}

// The depth of the plane through w. triangle: of the simplex's triangle, whose rounded normal is it->direction;
// otherwise of the plane across it->direction. normal: it->direction as a unit vector. The height
// settles most depths, even with its error.
static gjk_q16 exact_depth(const gjk_iteration *it, const gjk_unit3 *normal, const gjk_vec3 *w, bool triangle) {
  const gjk_vec3 *d = &it->direction.d;
  const uint32_t height = height_along(normal, w);  // at most 2^30 - 1
  const uint32_t least = height > GJK_HEIGHT_ERROR ? height - GJK_HEIGHT_ERROR : 0, most = height + GJK_HEIGHT_ERROR;
  gjk_q16 low = gjk_height_to_lsb(least, it->shift);
  const gjk_q16 high = gjk_height_to_lsb(most, it->shift);
  //@ assert low >= 0 && low <= (INT32_C(1) << 30) + 4;
  //@ assert high >= 0 && high <= (INT32_C(1) << 30) + 4;
  const int32_t exact = !GJK_SMALL && low < high && triangle ? gjk_simplex_along_axis(&it->simplex) : -1;
  //@ assert exact >= -1 && exact <= (INT32_C(1) << 30) + 4;
  if (low == high || exact >= 0) {
    return exact >= 0 ? gjk_sar32(exact, (unsigned)it->shift) : low;  // a multiple of 2^shift
  }
  gjk_u192 numerator, denominator;
  if (triangle) {
    gjk_simplex_squared_distance(&it->simplex, &numerator, &denominator);
  } else {
    gjk_u192 along;
    gjk_u192_set(&along, gjk_magnitude64(gjk_dot(d, w)));  // not negative, or the height is 0
    gjk_u192_multiply(&numerator, &along, &along);
    gjk_u192_set(&denominator, (uint64_t)gjk_dot(d, d));
  }
  // high - low <= 11:  4 comparisons
  low = (gjk_q16)gjk_round_distance(&numerator, &denominator, low, high, (unsigned)it->shift, GJK_ROUND_UP);
  //@ assert low >= 0 && low <= (INT32_C(1) << 30) + 4;
  return low;
}

gjk_q16 gjk_depth_across(const gjk_iteration *it, const gjk_vec3 *w) {
  const gjk_unit3 normal = gjk_unit(&it->direction.d);
  return gjk_dot(&it->direction.d, w) <= 0 ? 0 : exact_depth(it, &normal, w, false);
}

void gjk_facet_consider(gjk_facet *best, gjk_iteration *it, bool covers, gjk_q16 bound) {
  const gjk_unit3 normal = gjk_unit(&it->direction.d);
  const gjk_q16 depth = bound < 0 ? exact_depth(it, &normal, &it->simplex.slot[0].w, true) : bound;
  best->set = false;
  // Supports of a curved pair along one direction may differ by GJK_CURVED_ERROR. Each bound holds, so the least does.
  const gjk_q16 slack = !gjk_pair_is_curved(it) ? 0 : GJK_CURVED_ERROR,
                least = best->found && best->depth < depth ? best->depth : depth;
  bool better = !best->found || depth < best->depth;
  if (best->found && covers != best->covers) {
    better = covers ? depth <= best->depth + slack : depth + slack < best->depth;
  }
  best->depth = least;
  if (!better) {
    return;
  }
  best->found = true;
  best->covers = covers;
  best->direction = it->direction;
  best->normal = normal;
  best->set = true;
  for (int i = 0; i < 3; i++) {
    best->corner[i] = it->simplex.slot[i];
  }
}

void gjk_facet_load(const gjk_facet *facet, gjk_iteration *it) {
  gjk_simplex *s = &it->simplex;
  const bool ready = facet->set && facet->covers;
  it->direction = facet->direction;
  for (int i = 0; i < 3; i++) {
    gjk_vertex *v = &s->slot[i];
    if (!ready) {
      *v = facet->corner[i];
    }
    if (!gjk_pair_is_curved(it)) {
      it->a->shape->type->vertex(it->a, v->a.vertex, &v->a.offset);
    }
  }
  if (ready) {
    return;
  }
  gjk_simplex_set(s, 3);
  // Those of gjk_box_sat, and of an A - B that is flat, cover it.
  if (GJK_SHAPES <= GJK_SHAPES_BOXES || gjk_simplex_beyond(s) == 3) {
    return;
  }
  // The corners do not cover the projection. Add them until none makes the feature strictly nearer.
  gjk_vertex corner[3];
  for (int i = 0; i < 3; i++) {
    corner[i] = s->slot[i];
  }
  gjk_simplex_clear(s);
  bool nearer = true;
  for (int pass = 0; pass < 4 && nearer; pass++) {  // not reached: 4: of three corners, the last that is added stays
    nearer = false;
    for (int i = 0; i < 3; i++) {
      *gjk_simplex_free(s) = corner[i];
      // not reached: 3: the projection is outside the triangle, so the nearest feature has two corners at most
      nearer = (s->count < 3 && gjk_simplex_add(s) == GJK_STEP_NEARER) || nearer;
    }
  }
}
