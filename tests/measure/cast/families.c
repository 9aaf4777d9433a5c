// Makes casts with their true answers: of polytopes by rational brute force, of balls against boxes in closed form.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cast.h"
#include "exact/cast.h"
#include "generate/cast.h"

const cast_family cast_families[] = {
    {.name = "ordinary", .made = {"ordinary_boxes", "ordinary_hulls"}},
    {.name = "graze", .made = {"graze_face", "graze_slope", "graze_hull", "edge_edge"}},
    {.name = "level", .made = {"parallel_faces", "parallel_hulls", "vertex_vertex", "vertex_sideways"}},
    {.name = "ends", .made = {"end_touch"}},
    {.name = "fast", .made = {"thin_wall", "bullet"}},
    {.name = "sizes", .made = {"tiny", "huge", "long_scale", "far_origin"}},
    {.name = "ball-1", .half = 0.5, .way = 4},
    {.name = "ball-500", .half = 250, .way = 1000},
    {.name = "ball-500-long", .half = 250, .way = 8000},
};
const size_t cast_family_count = sizeof cast_families / sizeof cast_families[0];

static void *allocate(size_t size) {
  void *memory = calloc(1, size);
  if (memory == NULL) {
    abort();
  }
  return memory;
}

static void set_solid(const gjk_collider *c, const gjk_vec3 *origin, cast_solid *out) {
  const gjk_vec3 *at = &c->centre;
  const int64_t centre[3] = {at->x, at->y, at->z}, zero[3] = {origin->x, origin->y, origin->z};
  out->count = exact_vertex_count(c);
  out->vertices = allocate(out->count * sizeof out->vertices[0]);
  out->radius = c->shape->convex_radius / CAST_LSB_PER_UNIT;
  for (int k = 0; k < 3; k++) {
    out->centre[k] = (double)(centre[k] - zero[k]) / CAST_LSB_PER_UNIT;
  }
  for (size_t i = 0; i < out->count; i++) {
    const exact_point v = exact_vertex(c, (unsigned)i);
    for (int k = 0; k < 3; k++) {
      out->vertices[i][k] = (double)(v.x[k] - centre[k]) / CAST_LSB_PER_UNIT;
    }
  }
}

static exact_point way_of(const case_pair *pair) {
  const gjk_vec3 *pa = &pair->a.pose.position, *qa = pair->a.moves ? &pair->a.end.position : pa;
  const gjk_vec3 *pb = &pair->b.pose.position, *qb = pair->b.moves ? &pair->b.end.position : pb;
  const exact_point way = {{((int64_t)qb->x - pb->x) - ((int64_t)qa->x - pa->x),
                            ((int64_t)qb->y - pb->y) - ((int64_t)qa->y - pa->y),
                            ((int64_t)qb->z - pb->z) - ((int64_t)qa->z - pa->z)}};
  return way;
}

// Does a centre leave int32 on its way?
static bool is_out_of_range(const cast_case *c) {
  const case_shape *a = &c->pair->a, *b = &c->pair->b;
  const gjk_cast_path path = {a->moves ? &a->end.position : NULL, b->moves ? &b->end.position : NULL, 0};
  gjk_cast_result result;
  return gjk_cast(&c->a->collider, &c->b->collider, &path, &result) == GJK_ERROR_RANGE;
}

// Poses the pair and fills all but the answer. False: it is out of range.
static bool set_case(cast_case *c) {
  if (case_collider_build(c->a, &c->pair->a, false) != GJK_OK ||
      case_collider_build(c->b, &c->pair->b, false) != GJK_OK || is_out_of_range(c)) {
    return false;
  }
  const exact_point way = way_of(c->pair);
  set_solid(&c->a->collider, &c->a->collider.centre, &c->solid[0]);
  set_solid(&c->b->collider, &c->a->collider.centre, &c->solid[1]);
  for (int k = 0; k < 3; k++) {
    c->way[k] = (double)way.x[k] / CAST_LSB_PER_UNIT;
  }
  return true;
}

// The exact answer. False: the shapes share a point at the start, or there is no oracle for so many vertices.
static bool answer_polytopes(cast_case *c) {
  static exact_difference difference;
  static const exact_point nowhere = {{0, 0, 0}};
  const exact_point way = way_of(c->pair);
  exact_cast_truth truth;
  if (!exact_difference_find(&c->a->collider, &c->b->collider, &difference)) {
    return false;
  }
  exact_cast_find(&difference, &nowhere, &way, &truth);
  c->hit = truth.hit;
  if (truth.hit && !truth.inside) {
    const exact_half_space *entry = &difference.all[truth.entry];
    long double along = 0, square = 0;
    for (int k = 0; k < 3; k++) {
      const long double n = (long double)entry->normal[k];
      along += n * (long double)way.x[k];
      square += n * n;
    }
    c->fraction = (double)((long double)truth.numerator / (long double)truth.denominator);
    c->rate = (double)fabsl(along / sqrtl(square));
  }
  return !truth.inside;
}

// The distance of a place from a box about the origin, and the unit vector from there. LSB.
static long double box_gap(const long double place[3], long double half, long double n[3]) {
  long double square = 0;
  for (int k = 0; k < 3; k++) {
    const long double beyond = fabsl(place[k]) - half;
    n[k] = beyond > 0 ? copysignl(beyond, place[k]) : 0;
    square += n[k] * n[k];
  }
  const long double length = sqrtl(square);
  for (int k = 0; k < 3; k++) {
    n[k] /= length;
  }
  return length;
}

// The answer about a ball by Newton's iteration on the distance in closed form.
static bool answer_ball(cast_case *c) {
  const gjk_vec3 *at = &c->pair->b.pose.position;
  const exact_point way = way_of(c->pair);
  const long double from[3] = {at->x, at->y, at->z};
  const long double half = c->pair->a.size.x, radius = c->pair->b.convex_radius;
  long double fraction = 0;
  c->hit = false;
  for (int round = 0; round < 200; round++) {
    long double place[3], n[3], rate = 0;
    for (int k = 0; k < 3; k++) {
      place[k] = from[k] + fraction * (long double)way.x[k];
    }
    const long double gap = box_gap(place, half, n) - radius;
    for (int k = 0; k < 3; k++) {
      rate -= n[k] * (long double)way.x[k];
    }
    if (round == 0 && gap <= 0) {
      return false;
    }
    const long double next = rate > 0 ? fraction + gap / rate : 2;
    if (next > 1) {
      return true;
    }
    c->hit = next <= fraction || gap < 1e-9L;
    c->fraction = (double)fraction;
    c->rate = (double)rate;
    if (c->hit) {
      return true;
    }
    fraction = next;
  }
  return false;
}

static double unit_of(random_state *random) {
  return random_u32(random) / 4294967296.0;
}

// A ball, a tenth of the box, whose way aims at a place about the box.
static void make_ball(const cast_family *family, random_state *random, case_pair *pair) {
  const int32_t half = (int32_t)(family->half * CAST_LSB_PER_UNIT);
  double direction[3], aim[3], length = 0;
  gjk_vec3 from, to;
  int32_t *const start[3] = {&from.x, &from.y, &from.z}, *const end[3] = {&to.x, &to.y, &to.z};
  case_shape_reset(&pair->a);
  case_shape_reset(&pair->b);
  pair->a.kind = CASE_BOX;
  pair->a.size.x = pair->a.size.y = pair->a.size.z = half;
  pair->b.convex_radius = half / 10 + random_range(random, 0, half);
  for (int k = 0; k < 3; k++) {
    direction[k] = 2 * unit_of(random) - 1;
    aim[k] = (4 * unit_of(random) - 2) * half;
    length += direction[k] * direction[k];
  }
  for (int k = 0; k < 3; k++) {
    const double reach = family->way * CAST_LSB_PER_UNIT * direction[k] / sqrt(length);
    *start[k] = (int32_t)(aim[k] - reach * 0.6);
    *end[k] = (int32_t)(aim[k] + reach * 0.4);
  }
  pair->b.pose.position = from;
  case_shape_move_to(&pair->b, &to);
}

static const generate_cast_family *find(const char *name) {
  for (unsigned i = 0; i < generate_cast_family_count; i++) {
    if (strcmp(generate_cast_families[i].name, name) == 0) {
      return &generate_cast_families[i];
    }
  }
  abort();
}

static void clear(cast_case *c) {
  free(c->solid[0].vertices);
  free(c->solid[1].vertices);
  c->solid[0].vertices = c->solid[1].vertices = NULL;
}

cast_case *cast_make(const cast_family *family, size_t count) {
  cast_case *cases = allocate(count * sizeof *cases);
  random_state random = random_seed(17);
  size_t kinds = 0;
  uint64_t seed = 1;
  while (kinds < 5 && family->made[kinds] != NULL) {
    kinds++;
  }
  for (size_t i = 0; i < count;) {
    cast_case *c = &cases[i];
    if (c->pair == NULL) {
      c->pair = allocate(sizeof *c->pair);
      c->a = allocate(sizeof *c->a);
      c->b = allocate(sizeof *c->b);
    }
    if (kinds > 0) {
      generate_cast(find(family->made[i % kinds]), seed++, c->pair);
    } else {
      make_ball(family, &random, c->pair);
    }
    if (set_case(c) && (kinds > 0 ? answer_polytopes(c) : answer_ball(c))) {
      i++;
    } else {
      clear(c);
    }
  }
  return cases;
}

void cast_release(cast_case *cases, size_t count) {
  for (size_t i = 0; i < count; i++) {
    clear(&cases[i]);
    case_pair_free(cases[i].pair);
    case_collider_free(cases[i].a);
    case_collider_free(cases[i].b);
    free(cases[i].pair);
    free(cases[i].a);
    free(cases[i].b);
  }
  free(cases);
}
