// The expanding polytope's loop: support across the lowest face, until that is a facet.
#include "gjk_epa.h"

#include "../arith/gjk_unit.h"
#include "gjk_epa_hull.h"

// The bounds of a curved pair tell its depth when they are at most so far apart, LSB: those of a facet that is found
// are.
#define CURVED_WIDTH (2 * GJK_CURVED_ERROR + 2)

// The turn after which they are first looked at, a power of two.
#define FIRST_LOOK 32

// For curved shapes a face counts as a facet when their support lies no more than a quarter of an LSB beyond it.
#define CURVED_TOLERANCE(shift) ((UINT32_C(1) << (shift)) / 4)

// Places the support along the exact direction d. Is it beyond the origin there?
static bool support_beyond_origin(gjk_iteration *it, const gjk_vec3 *d) {
  gjk_support b;
  it->direction.d.x = d->x;  // one by one: GCC makes a copy of three on ARMv6-M a call of memcpy
  it->direction.d.y = d->y;
  it->direction.d.z = d->z;
  it->direction.exact = true;
  gjk_iteration_next(it, &b);
  return gjk_dot(d, &gjk_simplex_free(&it->simplex)->w) > 0;
}

// Places the support along n. Is it strictly beyond the plane across n through w?
static bool support_beyond(gjk_iteration *it, const gjk_long3 *n, const gjk_vec3 *w) {
  gjk_support b;
  const gjk_vertex *v = gjk_simplex_free(&it->simplex);
  gjk_search_direction_of(n, &it->direction);
  gjk_iteration_next(it, &b);
  gjk_vec3 step = gjk_sub(v->w, *w);
  if (gjk_dot_sign(n, &step) > 0) {
    return true;
  }
  gjk_direction direction;
  direction.n = n;
  direction.spanning = 3;
  direction.opposite = false;
  if (it->direction.exact || !gjk_iteration_refine(it, &direction, &b)) {
    return false;
  }
  step = gjk_sub(v->w, *w);
  return gjk_dot_sign(n, &step) > 0;
}

// A vector across e, of the same size or less. Pre: e != 0.
static gjk_vec3 across(const gjk_vec3 *e) {
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

static void normal_of(const gjk_simplex *s, gjk_long3 *n) {
  gjk_triangle_normal(&s->slot[s->order[0]].w, &s->slot[s->order[1]].w, &s->slot[s->order[2]].w, n);
}

static gjk_q16 curved_error(const gjk_iteration *it) {
  return gjk_pair_is_curved(it) ? GJK_CURVED_ERROR : 0;
}

// The triangle that holds the origin is a facet: the depth is 0.
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

// Adds vertices off what the simplex spans until it is a tetrahedron, with the origin still in it. Otherwise nothing
// lies on one side of what it spans: the shapes touch.
static gjk_epa_outcome complete_tetrahedron(gjk_iteration *it, gjk_facet *facet, bool *done, uint16_t *iterations) {
  static const gjk_vec3 x = {1, 0, 0};
  gjk_simplex *s = &it->simplex;
  const uint8_t count = s->count;
  *done = true;
  if (s->count == 1) {
    ++*iterations;
    if (!support_beyond_origin(it, &x)) {
      return GJK_EPA_TOUCHES;
    }
    s->count = 2;
  }
  if (s->count == 2) {
    const gjk_vec3 edge = gjk_sub(gjk_simplex_vertex(s, 1)->w, gjk_simplex_vertex(s, 0)->w), d = across(&edge);
    ++*iterations;
    if (!support_beyond_origin(it, &d)) {
      s->count = count;
      return GJK_EPA_TOUCHES;
    }
    s->count = 3;
  }
  if (s->count == 3) {
    gjk_long3 n;
    normal_of(s, &n);
    ++*iterations;
    if (!support_beyond(it, &n, &gjk_simplex_vertex(s, 0)->w)) {
      take_triangle(it, facet);
      return GJK_EPA_FACET;
    }
    s->count = 4;
  }
  *done = false;
  return GJK_EPA_FACET;
}

// How far a support along it->direction bounds the depth from above.
static gjk_q16 upper_bound(const gjk_iteration *it, const gjk_vec3 *w) {
  return gjk_depth_across(it, w) + curved_error(it);
}

// Considers a face of these corners, with the outward normal it->direction: exactly, or bound by how far a support has
// reached across it.
static void consider_face(gjk_iteration *it, const gjk_epa_hull *p, const uint16_t corner[3], gjk_q16 bound,
                          gjk_facet *facet) {
  gjk_simplex *s = &it->simplex;
  for (int i = 0; i < 3; i++) {
    gjk_epa_hull_load(p, corner[i], &s->slot[i]);
  }
  gjk_simplex_set(s, 3);
  gjk_facet_consider(facet, it, gjk_simplex_beyond(s) == 3, bound);
}

// The least height of a face, in LSB, rounded down: a lower bound of the depth.
static gjk_q16 lower_bound(const gjk_iteration *it, const gjk_epa_hull *p) {
  uint32_t least = GJK_HEIGHT_MAX;
  for (uint16_t i = 0; i < p->faces; i++) {
    gjk_long3 n;
    gjk_search_direction d;
    const uint16_t *corner = gjk_epa_hull_face(p, i)->corner;
    gjk_epa_hull_normal(p, corner, &n);
    gjk_search_direction_of(&n, &d);
    const uint32_t height = gjk_height(&d.d, gjk_epa_hull_vertex(p, corner[0]));
    least = height < least ? height : least;
  }
  return (gjk_q16)((least > GJK_HEIGHT_ERROR ? least - GJK_HEIGHT_ERROR : 0) >> it->shift) - curved_error(it);
}

// The facet's plane is exact, or for curved shapes known to within the tolerance and the error of their supports.
static gjk_q16 least_depth(const gjk_iteration *it, const gjk_facet *facet) {
  return !gjk_pair_is_curved(it) ? facet->depth : facet->depth - CURVED_WIDTH;
}

// Do the bounds of a curved pair tell its depth? That takes a look at every face, so it is asked when the turns have
// doubled, and after the last. The facet must cover the origin's projection: else its points do not tell where.
static bool told(const gjk_iteration *it, const gjk_epa_hull *p, const gjk_facet *facet, uint16_t turns,
                 gjk_q16 *lower) {
  if (!facet->found || !facet->covers || turns < FIRST_LOOK ||
      ((turns & (turns - 1u)) != 0 && turns < GJK_EPA_CURVED_ITERATIONS_MAX)) {
    return false;
  }
  *lower = lower_bound(it, p);
  return facet->depth - *lower <= CURVED_WIDTH;
}

// The face across which a support has reached least: a bound of the depth.
typedef struct bounding_face {
  uint32_t reached;  // in the frame; 0 for polytopes, whose last face counts
  uint16_t corner[3];
} bounding_face;

// Bounds the depth where the search ends without a facet.
static gjk_epa_outcome bound_by(gjk_iteration *it, const gjk_epa_hull *p, const bounding_face *face, gjk_facet *facet,
                                gjk_q16 *lower, uint16_t *iterations) {
  gjk_long3 n;
  *lower = lower_bound(it, p);
  gjk_epa_hull_normal(p, face->corner, &n);
  gjk_simplex_clear(&it->simplex);
  facet->set = false;
  ++*iterations;
  support_beyond(it, &n, gjk_epa_hull_vertex(p, face->corner[0]));
  consider_face(it, p, face->corner, upper_bound(it, &it->simplex.slot[0].w), facet);
  return GJK_EPA_FULL;
}

static gjk_epa_outcome expand(gjk_iteration *it, gjk_epa_hull *p, gjk_facet *facet, gjk_q16 *lower,
                              uint16_t *iterations) {
  const gjk_vertex *support = &it->simplex.slot[0];
  const bool curved = gjk_pair_is_curved(it);
  bounding_face least;
  least.reached = UINT32_MAX;
  // Each turn settles a face or adds a vertex, so there are fewer than there are cells, and of a curved pair at most
  // GJK_EPA_CURVED_ITERATIONS_MAX.
  for (uint16_t turns = 0;; turns++) {
    const uint16_t lowest = gjk_epa_hull_lowest(p);
    gjk_epa_face *face = gjk_epa_hull_face(p, lowest);
    const uint32_t key = face->height_key;
    if (key == GJK_HEIGHT_KEY_SETTLED || !gjk_facet_may_improve(facet, it->shift, key)) {
      *lower = least_depth(it, facet);
      return GJK_EPA_FACET;
    }
    if (curved && told(it, p, facet, turns, lower)) {
      return GJK_EPA_FACET;
    }
    if (curved && turns == GJK_EPA_CURVED_ITERATIONS_MAX) {
      return bound_by(it, p, &least, facet, lower, iterations);
    }
    gjk_long3 n;
    const gjk_vec3 *w = gjk_epa_hull_vertex(p, face->corner[0]);
    gjk_epa_hull_normal(p, face->corner, &n);
    gjk_simplex_clear(&it->simplex);
    facet->set = false;
    ++*iterations;
    const bool beyond = support_beyond(it, &n, w);
    const uint32_t reached = curved ? gjk_height(&it->direction.d, &support->w) : 0;
    if (reached <= least.reached) {
      least.reached = reached;
      for (int i = 0; i < 3; i++) {
        least.corner[i] = face->corner[i];
      }
    }
    if (!beyond || (curved && reached <= gjk_height(&it->direction.d, w) + CURVED_TOLERANCE(it->shift))) {
      consider_face(it, p, face->corner, curved ? upper_bound(it, &support->w) : -1, facet);
      face->height_key = GJK_HEIGHT_KEY_SETTLED;
    } else if (!gjk_epa_hull_add(p, lowest, support)) {
      return bound_by(it, p, &least, facet, lower, iterations);
    }
  }
}

// Without room for a polytope: one face of the tetrahedron, and how far A - B reaches beyond it.
static void bound_by_face(gjk_iteration *it, gjk_facet *facet) {
  gjk_simplex *s = &it->simplex;
  gjk_vertex corner[3];
  gjk_long3 n;
  // The fourth vertex was added strictly beyond the others, along their normal: outwards is the other way.
  for (int i = 0; i < 3; i++) {
    corner[i] = *gjk_simplex_vertex(s, i == 0 ? 0 : 3 - i);
  }
  normal_of(s, &n);
  n.x = -n.x;
  n.y = -n.y;
  n.z = -n.z;
  s->count = 3;
  support_beyond(it, &n, &corner[0].w);
  const gjk_q16 reached = upper_bound(it, &gjk_simplex_free(s)->w);
  for (int i = 0; i < 3; i++) {
    s->slot[i] = corner[i];
  }
  gjk_simplex_set(s, 3);
  gjk_facet_consider(facet, it, true, reached);
}

gjk_epa_outcome gjk_epa(gjk_iteration *it, const gjk_workspace *workspace, gjk_facet *facet, gjk_q16 *lower,
                        uint16_t *iterations) {
  bool done;
  gjk_epa_hull p;
  gjk_epa_outcome expansion = complete_tetrahedron(it, facet, &done, iterations);
  *lower = -curved_error(it);
  if (done) {
    return expansion;
  }
  if (!gjk_epa_hull_start(&p, workspace, &it->simplex, gjk_pair_is_curved(it))) {
    ++*iterations;
    bound_by_face(it, facet);
    return GJK_EPA_FULL;
  }
  expansion = expand(it, &p, facet, lower, iterations);
  //@ assert facet->found;
  // not reached: lower > depth: the polytope lies within A - B, and the errors of curved supports are added on both
  // sides
  if (*lower > facet->depth) {
    *lower = least_depth(it, facet);
  }
  return *lower == facet->depth ? GJK_EPA_FACET : expansion;
}
