// EPA: a polytope inside A - B, around the origin, expands until its lowest face is the nearest facet of A - B.
//
//   Step 1   Complete the simplex, which holds the origin, to a tetrahedron, by support scans off what it spans. If
//            nothing lies there: TOUCHES for a vertex or edge, FACET of depth 0 for a triangle.
//   Step 2   Start the hull from the tetrahedron. If there is no room: FULL, with a bound of the depth from one face.
//   Then each iteration:
//   Step 3   Take the lowest face that is not settled, by its height key. If there is none, or it cannot be as low as
//            the candidate, the candidate is the nearest facet: FACET. For polytopes, if the key does not tell, compare
//            their heights exactly. A face that is higher, or as high and no better, is settled without a scan.
//   Step 4   For a curved pair: if the bounds of the depth are close, FACET. At the limit on iterations go to step 8.
//   Step 5   Support scan: w is the vertex of A - B farthest along the outward normal of the face.
//   Step 6   If w is not strictly beyond the face (for a curved pair, by a quarter of an LSB), the face lies in the
//            surface of A - B. Settle the face and offer it as a candidate.
//   Step 7   Otherwise add w to the hull in place of all faces that see it. If there is no room, go to step 8.
//   Step 8   FULL. The lowest face bounds the depth from below, the support that reached least from above.
//
// Each iteration settles a face or adds a vertex, so there are fewer than there are cells.
#include "gjk_epa.h"

#include "../arith/gjk_unit.h"
#include "gjk_epa_hull.h"

// A curved pair's bounds of the depth are close at this width, LSB. Those of a candidate that is found are.
#define CURVED_WIDTH (2 * GJK_CURVED_ERROR + 2)

// The bounds are computed from this iteration on, a power of two.
#define FIRST_BOUNDS 32

// Step 6: a quarter of an LSB in the frame.
#define CURVED_TOLERANCE(shift) ((UINT32_C(1) << (shift)) / 4)

// Scans along the exact direction d into the free slot. Is the support strictly beyond the origin?
static bool support_beyond_origin(gjk_iteration *it, const gjk_vec3 *d) {
  gjk_support b;
  it->direction.d.x = d->x;  // one by one: on ARMv6-M GCC turns the copy of three into a call of memcpy
  it->direction.d.y = d->y;
  it->direction.d.z = d->z;
  it->direction.exact = true;
  gjk_iteration_next(it, &b);
  return gjk_dot(d, &gjk_simplex_free(&it->simplex)->w) > 0;
}

// Scans along n into the free slot: exactly, or along it->direction, which is n, rounded. Is the support strictly beyond the
// plane across n through w?
static bool support_beyond(gjk_iteration *it, const gjk_long3 *n, const gjk_vec3 *w, bool exactly) {
  gjk_support b;
  const gjk_vertex *v = gjk_simplex_free(&it->simplex);
  gjk_iteration_next(it, &b);
  gjk_vec3 step = gjk_sub(v->w, *w);
  if (gjk_dot_sign(n, &step) > 0) {
    return true;
  }
  gjk_direction direction;
  direction.n = n;
  direction.spanning = 3;
  direction.opposite = false;
  direction.level = NULL;
  if (!exactly || it->direction.exact || !gjk_iteration_refine(it, &direction, &b)) {
    return false;
  }
  step = gjk_sub(v->w, *w);
  return gjk_dot_sign(n, &step) > 0;
}

// A vector at right angles to e, no longer than e and not 0. Pre: e != 0.
static gjk_vec3 vector_across(const gjk_vec3 *e) {
  const uint32_t x = gjk_magnitude32(e->x), y = gjk_magnitude32(e->y), z = gjk_magnitude32(e->z);
  gjk_vec3 d = {0, e->z, -e->y};
  if (z <= x && z <= y) {
    d.x = e->y;
    d.y = -e->x;
    d.z = 0;
  } else if (y <= x) {
    d.x = -e->z;
    d.y = 0;
    d.z = e->x;
  }
  return d;
}

static void simplex_normal(const gjk_simplex *s, gjk_long3 *n) {
  gjk_triangle_normal(&s->slot[s->order[0]].w, &s->slot[s->order[1]].w, &s->slot[s->order[2]].w, n);
}

// How far a support of the pair may be off, LSB.
static gjk_q16 curved_error(const gjk_iteration *it) {
  return gjk_pair_is_curved(it) ? GJK_CURVED_ERROR : 0;
}

// Takes the simplex, a triangle that holds the origin, for the facet: the depth is 0.
static void take_triangle(gjk_iteration *it, gjk_facet *facet) {
  gjk_simplex *s = &it->simplex;
  for (int i = 0; i < 3; i++) {
    facet->corner[i] = *gjk_simplex_vertex(s, i);
  }
  facet->direction = it->direction;
  facet->normal = gjk_unit(&it->direction.d);
  facet->set = false;
  facet->depth = curved_error(it);
  facet->found = true;
  facet->covers = true;
}

// Step 1. False: *outcome is the answer. Each vertex added lies off what the others span: the simplex keeps the origin.
static bool complete_tetrahedron(gjk_iteration *it, gjk_facet *facet, uint16_t *iterations, gjk_epa_outcome *outcome) {
  static const gjk_vec3 x = {1, 0, 0};
  gjk_simplex *s = &it->simplex;
  const uint8_t count = s->count;
  *outcome = GJK_EPA_TOUCHES;
  if (GJK_SHAPES <= GJK_SHAPES_POINTS) {
    it->direction.d = x;
    return false;
  }
  if (s->count == 1) {
    ++*iterations;
    if (!support_beyond_origin(it, &x)) {
      return false;
    }
    s->count = 2;
  }
  if (s->count == 2) {
    const gjk_vec3 edge = gjk_sub(gjk_simplex_vertex(s, 1)->w, gjk_simplex_vertex(s, 0)->w), d = vector_across(&edge);
    ++*iterations;
    if (!support_beyond_origin(it, &d)) {
      s->count = count;
      return false;
    }
    s->count = 3;
  }
  if (s->count == 3) {
    gjk_long3 n;
    simplex_normal(s, &n);
    gjk_search_direction_of(&n, &it->direction);
    ++*iterations;
    if (GJK_SHAPES <= GJK_SHAPES_BOXES || !support_beyond(it, &n, &gjk_simplex_vertex(s, 0)->w, true)) {
      take_triangle(it, facet);
      *outcome = GJK_EPA_FACET;
      return false;
    }
    s->count = 4;
  }
  return true;
}

// An upper bound of the depth, by the support w along it->direction.
static gjk_q16 upper_bound(const gjk_iteration *it, const gjk_vec3 *w) {
  return gjk_depth_across(it, w) + curved_error(it);
}

// The same by a support scan into the free slot. The scan is along it->direction as it is: a support along the normal that
// it was rounded from reaches less far along it, by up to 1 LSB.
static gjk_q16 scan_upper_bound(gjk_iteration *it, uint16_t *iterations) {
  gjk_support b;
  ++*iterations;
  gjk_iteration_next(it, &b);
  return upper_bound(it, &gjk_simplex_free(&it->simplex)->w);
}

// Offers the face of these corners as a candidate; it->direction is its outward normal. bound: see gjk_facet_consider.
static void offer_face(gjk_iteration *it, const gjk_epa_hull *p, const uint16_t corner[3], gjk_q16 bound,
                       gjk_facet *facet) {
  gjk_simplex *s = &it->simplex;
  for (int i = 0; i < 3; i++) {
    gjk_epa_hull_load(p, corner[i], &s->slot[i]);
  }
  // Mostly the projection lies strictly inside.
  gjk_facet_consider(facet, it, gjk_simplex_set(s, 3) || gjk_simplex_beyond(s) == 3, bound);
}

// A lower bound of the depth, in LSB: the height of the lowest face, less all errors.
static gjk_q16 lower_bound(const gjk_iteration *it, const gjk_epa_hull *p) {
  uint32_t least = GJK_HEIGHT_MAX;
  for (uint16_t i = 0; i < p->faces; i++) {
    gjk_long3 n;
    gjk_search_direction d;
    gjk_epa_hull_plane(p, i, &n, &d);
    const uint32_t height = gjk_height(&d.d, gjk_epa_hull_vertex(p, gjk_epa_hull_face(p, i)->corner[0]));
    least = height < least ? height : least;
  }
  return (gjk_q16)((least > GJK_HEIGHT_ERROR ? least - GJK_HEIGHT_ERROR : 0) >> it->shift) - curved_error(it);
}

// A lower bound of the depth by the nearest facet. Of polytopes its depth is exact; of a curved pair within
// CURVED_WIDTH: the error of the supports on both sides, the tolerance of step 6 and rounding.
static gjk_q16 least_depth(const gjk_iteration *it, const gjk_facet *facet) {
  return !gjk_pair_is_curved(it) ? facet->depth : facet->depth - CURVED_WIDTH;
}

// Step 4: are the bounds of the depth close? The lower one takes the height of every face, so it is computed whenever
// the iterations have doubled, and after the last. A candidate that does not cover the origin's projection has no
// witness points, so it does not count.
static bool bounds_are_close(const gjk_iteration *it, const gjk_epa_hull *p, const gjk_facet *facet, uint16_t iteration,
                             gjk_q16 *lower) {
  if (!facet->found || !facet->covers || iteration < FIRST_BOUNDS ||
      ((iteration & (iteration - 1u)) != 0 && iteration < GJK_EPA_CURVED_ITERATIONS_MAX)) {
    return false;
  }
  *lower = lower_bound(it, p);
  return facet->depth - *lower <= CURVED_WIDTH;
}

// The face beyond which a support reached least: an upper bound of the depth.
typedef struct bounding_face {
  uint32_t reached;  // height of the support; 0 for polytopes, of which the last face counts
  uint16_t corner[3];
} bounding_face;

// Step 8: FULL, with the bounds.
static gjk_epa_outcome bound_depth_by_hull(gjk_iteration *it, const gjk_epa_hull *p, const bounding_face *face,
                                           gjk_facet *facet, gjk_q16 *lower, uint16_t *iterations) {
  gjk_long3 n;
  *lower = lower_bound(it, p);
  gjk_epa_hull_normal(p, face->corner, &n);
  gjk_search_direction_of(&n, &it->direction);
  gjk_simplex_clear(&it->simplex);
  facet->set = false;
  offer_face(it, p, face->corner, scan_upper_bound(it, iterations), facet);
  return GJK_EPA_FULL;
}

// Step 3 of polytopes: is the face lower than the candidate? 0: as low, but the candidate does not cover the projection and
// the face may. -1: neither, and the face is settled. Exact.
static int is_lower(gjk_iteration *it, const gjk_epa_hull *p, uint16_t face, gjk_facet *facet) {
  gjk_long3 n;
  const uint16_t *corner = gjk_epa_hull_face(p, face)->corner;
  if (!facet->found) {
    return 1;
  }
  gjk_epa_hull_plane(p, face, &n, &it->direction);
  for (int i = 0; i < 3; i++) {
    gjk_epa_hull_load(p, corner[i], &it->simplex.slot[i]);
  }
  facet->set = false;
  const int sign = gjk_facet_compare(facet, it);
  return sign < 0 ? 1 : sign == 0 && !facet->covers ? 0 : -1;
}

// Steps 3 to 8.
static gjk_epa_outcome expand(gjk_iteration *it, gjk_epa_hull *p, gjk_facet *facet, gjk_q16 *lower,
                              uint16_t *iterations) {
  const gjk_vertex *support = &it->simplex.slot[0];
  const bool curved = gjk_pair_is_curved(it);
  bounding_face least;
  least.reached = UINT32_MAX;
  for (uint16_t iteration = 0;; iteration++) {
    // Step 3: the lowest face.
    const uint16_t lowest = gjk_epa_hull_lowest(p);
    gjk_epa_face *face = gjk_epa_hull_face(p, lowest);
    const uint32_t key = face->height_key;
    if (key == GJK_HEIGHT_KEY_SETTLED ||
        !(curved ? gjk_facet_may_improve(facet, it->shift, key) : gjk_facet_may_tie(facet, key))) {
      *lower = least_depth(it, facet);
      return GJK_EPA_FACET;
    }
    const int better = curved ? 0 : is_lower(it, p, lowest, facet);
    if (better < 0) {
      face->height_key = GJK_HEIGHT_KEY_SETTLED;
      continue;
    }
    // Step 4: a curved pair may end.
    if (curved && bounds_are_close(it, p, facet, iteration, lower)) {
      return GJK_EPA_FACET;
    }
    if (curved && iteration == GJK_EPA_CURVED_ITERATIONS_MAX) {
      return bound_depth_by_hull(it, p, &least, facet, lower, iterations);
    }
    // Step 5: the support scan.
    gjk_long3 n;
    const gjk_vec3 *w = gjk_epa_hull_vertex(p, face->corner[0]);
    gjk_epa_hull_plane(p, lowest, &n, &it->direction);
    gjk_simplex_clear(&it->simplex);
    facet->set = false;
    ++*iterations;
    const bool beyond = support_beyond(it, &n, w, !curved);  // the support of a curved pair bounds the depth too
    const uint32_t reached = curved ? gjk_height(&it->direction.d, &support->w) : 0;
    if (reached <= least.reached) {
      least.reached = reached;
      for (int i = 0; i < 3; i++) {
        least.corner[i] = face->corner[i];
      }
    }
    // Step 6: the face is settled. Step 7: the vertex is added.
    if (!beyond || (curved && reached <= gjk_height(&it->direction.d, w) + CURVED_TOLERANCE(it->shift))) {
      facet->found = facet->found && better <= 0;
      offer_face(it, p, face->corner, curved ? upper_bound(it, &support->w) : -1, facet);
      face->height_key = GJK_HEIGHT_KEY_SETTLED;
    } else if (!gjk_epa_hull_add(p, lowest, support)) {
      return bound_depth_by_hull(it, p, &least, facet, lower, iterations);
    }
  }
}

// Step 2 without room for a hull: bounds the depth by the support beyond one face of the tetrahedron.
static gjk_epa_outcome bound_depth_by_tetrahedron(gjk_iteration *it, gjk_facet *facet, uint16_t *iterations) {
  gjk_simplex *s = &it->simplex;
  gjk_vertex corner[3];
  gjk_long3 n;
  // The fourth vertex lies strictly beyond the others, along their normal; outwards of their face is the opposite.
  for (int i = 0; i < 3; i++) {
    corner[i] = *gjk_simplex_vertex(s, i == 0 ? 0 : 3 - i);
  }
  simplex_normal(s, &n);
  n.x = -n.x;
  n.y = -n.y;
  n.z = -n.z;
  s->count = 3;
  gjk_search_direction_of(&n, &it->direction);
  const gjk_q16 reached = scan_upper_bound(it, iterations);
  for (int i = 0; i < 3; i++) {
    s->slot[i] = corner[i];
  }
  gjk_simplex_set(s, 3);
  gjk_facet_consider(facet, it, true, reached);
  return GJK_EPA_FULL;
}

gjk_epa_outcome gjk_epa(gjk_iteration *it, const gjk_workspace *workspace, gjk_facet *facet, gjk_q16 *lower,
                        uint16_t *iterations) {
  gjk_epa_hull p;
  gjk_epa_outcome outcome;
  *lower = -curved_error(it);
  // Of points, segments and boxes gjk_box_sat has left those A - B that are flat.
  const bool has_inside = complete_tetrahedron(it, facet, iterations, &outcome);
  if (GJK_SHAPES <= GJK_SHAPES_BOXES || !has_inside) {
    return outcome;
  }
  if (!gjk_epa_hull_start(&p, workspace, &it->simplex, gjk_pair_is_curved(it))) {
    return bound_depth_by_tetrahedron(it, facet, iterations);
  }
  outcome = expand(it, &p, facet, lower, iterations);
  //@ assert facet->found;
  // not reached: lower > depth: the hull lies within A - B, and both bounds allow for the errors of curved supports
  if (*lower > facet->depth) {
    *lower = least_depth(it, facet);
  }
  return outcome;
}
