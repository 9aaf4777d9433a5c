// Makes pairs of the plane. Each decision is proven by the exact oracle, from the same posed integers that all methods get.
#define _POSIX_C_SOURCE 200112L
#include "families.h"

#include "../measuring.h"
#include "exact/claim2.h"
#include "generate/shape2.h"
#include "generate/smallest2.h"

#define UNIT GJK_Q16_ONE
#define CLOSE (UNIT / 10)
#define DEGREE 1144

// Corners of an ellipse within reach, in order, each in its share of the turn.
static void make_polygon(random_state *random, unsigned count, gjk_q16 reach, case2_shape *out) {
  const double x = random_range(random, reach / 5, reach), y = random_range(random, reach / 5, reach);
  case2_shape_reset(out);
  out->kind = CASE2_POLYGON;
  case2_shape_set_count(out, count);
  for (unsigned i = 0; i < count; i++) {
    const double angle = (i + 0.67 * generate2_unit(random)) * 2 * acos(-1) / count;
    out->vertices[i].x = (gjk_q16)lrint(x * cos(angle));
    out->vertices[i].y = (gjk_q16)lrint(y * sin(angle));
  }
}

static void make_box(random_state *random, gjk_q16 reach, case2_shape *out) {
  case2_shape_reset(out);
  out->kind = CASE2_BOX;
  out->size.x = random_range(random, reach / 5, reach);
  out->size.y = random_range(random, reach / 5, reach);
}

// Boxes, and polygons of 3 to 8 corners.
static void make_shapes(random_state *random, gjk_q16 least, gjk_q16 most, case2_pair *pair) {
  for (int i = 0; i < 2; i++) {
    case2_shape *shape = i == 0 ? &pair->a : &pair->b;
    const gjk_q16 reach = random_range(random, least, most);
    if (random_below(random, 2) == 0) {
      make_box(random, reach, shape);
    } else {
      make_polygon(random, 3 + random_below(random, 6), reach, shape);
    }
  }
}

// Of sizes from least to most.
static void apart(const plane_family *family, random_state *random, size_t index, case2_pair *pair) {
  (void)index;
  make_shapes(random, family->least, family->most, pair);
  generate2_apart(random, 1.15 * generate2_unit(random), pair);
}

static void touching(const plane_family *family, random_state *random, size_t index, case2_pair *pair) {
  (void)index;
  make_shapes(random, family->least, family->most, pair);
  generate2_near(random, random_range(random, -3, 3), pair);
}

static void edges_or_slivers(const plane_family *family, random_state *random, size_t index, case2_pair *pair) {
  const char *name = strcmp(family->name, "edges") == 0 ? "edge-to-edge" : family->name;
  (void)index;
  for (unsigned i = 0; i < generate2_family_count; i++) {
    if (strcmp(generate2_families[i].name, name) == 0) {
      generate2_families[i].generate(random, pair);
    }
  }
}

// Of coordinates of `most` bits.
static void smallest(const plane_family *family, random_state *random, size_t index, case2_pair *pair) {
  (void)index;
  generate2_smallest_bits(random, (unsigned)family->most, pair);
}

#define FAMILY(name, generate, least, most) \
  { name, PLANE_INTERSECT, generate, CASE2_POLYGON, CASE2_POLYGON, least, most, false, false }

const plane_family plane_decision_families[] = {
    FAMILY("game", apart, UNIT / 2, 2 * UNIT),
    FAMILY("touching", touching, UNIT / 2, 2 * UNIT),
    FAMILY("large", touching, 20 * UNIT, 1000 * UNIT),
    FAMILY("edges", edges_or_slivers, 0, 0),
    FAMILY("slivers", edges_or_slivers, 0, 0),
    FAMILY("smallest-14", smallest, 0, 14),
    FAMILY("smallest-20", smallest, 0, 20),
    FAMILY("smallest-26", smallest, 0, 26),
};
const size_t plane_decision_family_count = sizeof plane_decision_families / sizeof plane_decision_families[0];

// The distance, or minus the depth.
static gjk_q16 gap_of(const case2_pair *pair) {
  static case2_collider a, b;
  gjk2_distance_result out;
  gjk_status status = case2_collider_build(&a, &pair->a, false);
  status = status == GJK_OK ? case2_collider_build(&b, &pair->b, false) : status;
  status = status == GJK_OK ? gjk2_signed_distance(&a.collider, &b.collider, NULL, &out) : status;
  if (status != GJK_OK) {
    fprintf(stderr, "gjk-plane: a pair cannot be made: %s\n", gjk_status_name(status));
    exit(1);
  }
  return out.distance;
}

// Boxes or 8-gons of 0.2 to 1 unit whose gap is from least to most.
static void corners(const plane_family *family, random_state *random, size_t index, case2_pair *pair) {
  gjk_q16 gap;
  (void)index;
  do {
    for (int i = 0; i < 2; i++) {
      case2_shape *shape = i == 0 ? &pair->a : &pair->b;
      if (family->a == CASE2_BOX) {
        make_box(random, UNIT, shape);
      } else {
        make_polygon(random, 8, UNIT, shape);
      }
      (void)gjk2_rotation_from_angle(random_range(random, -205887, 205887), &shape->pose.rotation);
      shape->pose.position = generate2_vector(random, 3.0 * UNIT * generate2_unit(random));
    }
    gap = gap_of(pair);
  } while (gap < family->least || gap > family->most);
}

// In turn apart and overlapping.
static void either_side(const plane_family *family, random_state *random, size_t index, case2_pair *pair) {
  plane_family side = *family;
  side.least = index % 2 == 0 ? 1 : family->least;
  side.most = index % 2 == 0 ? family->most : -1;
  corners(&side, random, index, pair);
}

// B is A turned half around the middle of an edge; then tilted by up to a degree, moved aside by up to 0.1 unit and
// 300 to 3,276 LSB into A.
static void face_to_face(const plane_family *family, random_state *random, size_t index, case2_pair *pair) {
  (void)family;
  (void)index;
  make_polygon(random, 8, UNIT, &pair->a);
  make_polygon(random, 8, UNIT, &pair->b);
  const gjk2_vec *v = pair->a.vertices, p = v[0], q = v[1];
  const double x = (p.x + q.x) / 2.0, y = (p.y + q.y) / 2.0, ex = q.x - p.x, ey = q.y - p.y, e = hypot(ex, ey);
  const double tilt = (generate2_unit(random) - 0.5) * 0.035, deep = random_range(random, 300, 3276);
  const double aside = (2 * generate2_unit(random) - 1) * CLOSE;
  for (int i = 0; i < 8; i++) {
    const double u = x - v[i].x, w = y - v[i].y;
    pair->b.vertices[i].x = (gjk_q16)lrint(x + u * cos(tilt) - w * sin(tilt) + (aside * ex - deep * ey) / e);
    pair->b.vertices[i].y = (gjk_q16)lrint(y + u * sin(tilt) + w * cos(tilt) + (aside * ey + deep * ex) / e);
  }
  (void)gjk2_rotation_from_angle(random_range(random, -205887, 205887), &pair->a.pose.rotation);
  pair->b.pose.rotation = pair->a.pose.rotation;
}

static void set_round(random_state *random, case2_kind kind, case2_shape *out) {
  case2_shape_reset(out);
  out->kind = kind;
  out->size.x = kind == CASE2_POINT ? 0 : random_range(random, UNIT / 5, UNIT);
  out->size.y = kind == CASE2_BOX ? random_range(random, UNIT / 5, UNIT) : 0;
  out->convex_radius = kind == CASE2_BOX ? 0 : random_range(random, UNIT / 5, UNIT / 2);
  (void)gjk2_rotation_from_angle(random_range(random, -205887, 205887), &out->pose.rotation);
}

// Shapes of 0.2 to 1 unit, turned at random, whose gap is from least to most.
static void kinds(const plane_family *family, random_state *random, size_t index, case2_pair *pair) {
  gjk_q16 gap;
  (void)index;
  do {
    set_round(random, family->a, &pair->a);
    set_round(random, family->b, &pair->b);
    pair->b.pose.position = generate2_vector(random, 3.0 * UNIT * generate2_unit(random));
    gap = gap_of(pair);
  } while (gap < family->least || gap > family->most);
}

// B stands on the upper side of A, 300 to 3,276 LSB deep and turned by up to the angle `most`.
static void on_box(const plane_family *family, random_state *random, size_t index, case2_pair *pair) {
  gjk_q16 gap, deep = random_range(random, 300, 3276);
  (void)index;
  set_round(random, CASE2_BOX, &pair->a);
  set_round(random, family->b, &pair->b);
  pair->a.pose.rotation.c = GJK_Q30_ONE;
  pair->a.pose.rotation.s = 0;
  (void)gjk2_rotation_from_angle(random_range(random, -family->most, family->most), &pair->b.pose.rotation);
  pair->b.pose.position.x = random_range(random, -pair->a.size.x, pair->a.size.x) / 2;
  pair->b.pose.position.y = 3 * UNIT;
  while ((gap = gap_of(pair)) > 0) {
    pair->b.pose.position.y -= gap;
  }
  pair->b.pose.position.y -= deep;
}

// A: corners of hills from the right to the left, two units apart. B stands on them.
static void on_chain(const plane_family *family, random_state *random, size_t index, case2_pair *pair) {
  gjk2_chain chain;
  gjk2_distance_result nearest;
  uint16_t segment;
  const gjk2_vec origin = {0, 0};
  static case2_collider b;
  (void)index;
  case2_shape_reset(&pair->a);
  pair->a.kind = CASE2_POLYGON;
  case2_shape_set_count(&pair->a, 17);
  for (int i = 0; i < 17; i++) {
    pair->a.vertices[i].x = (8 - i) * 2 * UNIT;
    pair->a.vertices[i].y = random_range(random, -UNIT / 4, UNIT / 4);
  }
  set_round(random, family->b, &pair->b);
  (void)gjk2_rotation_from_angle(random_range(random, -DEGREE, DEGREE), &pair->b.pose.rotation);
  pair->b.pose.position.x = random_range(random, -10 * UNIT, 10 * UNIT);
  pair->b.pose.position.y = 3 * UNIT;
  (void)gjk2_chain_init(&chain, pair->a.vertices, 17, &origin);
  do {
    (void)case2_collider_build(&b, &pair->b, false);
    (void)gjk2_chain_distance(&chain, &b.collider, NULL, &nearest, &segment);
    pair->b.pose.position.y -= nearest.distance;
  } while (nearest.distance > 0);
  pair->b.pose.position.y -= random_range(random, 300, 3276);
}

const plane_family plane_cost_families[] = {
    // name, query, maker, A, B, least, most, own, moved
    {"distance: boxes apart", PLANE_DISTANCE, corners, CASE2_BOX, CASE2_BOX, CLOSE, 2 * UNIT, false, true},
    {"distance: 8-gons apart", PLANE_DISTANCE, corners, CASE2_POLYGON, CASE2_POLYGON, CLOSE, 2 * UNIT, false, true},
    {"distance: circles", PLANE_DISTANCE, kinds, CASE2_POINT, CASE2_POINT, CLOSE, 2 * UNIT, true, false},
    {"distance: capsules", PLANE_DISTANCE, kinds, CASE2_SEGMENT, CASE2_SEGMENT, CLOSE, 2 * UNIT, true, true},
    {"distance: circle and box", PLANE_DISTANCE, kinds, CASE2_BOX, CASE2_POINT, CLOSE, 2 * UNIT, true, true},
    {"intersect: 8-gons close", PLANE_INTERSECT, either_side, CASE2_POLYGON, CASE2_POLYGON, -CLOSE, CLOSE, false,
     false},
    {"depth: 8-gons", PLANE_DEPTH, corners, CASE2_POLYGON, CASE2_POLYGON, -2 * UNIT, -1000, false, false},
    {"depth: circles", PLANE_DEPTH, kinds, CASE2_POINT, CASE2_POINT, -3276, -300, true, false},
    {"contacts: 8-gons face to face", PLANE_CONTACTS, face_to_face, CASE2_POLYGON, CASE2_POLYGON, 0, 0, false, true},
    {"contacts: circles", PLANE_CONTACTS, kinds, CASE2_POINT, CASE2_POINT, -3276, -300, true, false},
    {"contacts: circle on box", PLANE_CONTACTS, kinds, CASE2_BOX, CASE2_POINT, -3276, -300, true, true},
    {"contacts: capsules", PLANE_CONTACTS, kinds, CASE2_SEGMENT, CASE2_SEGMENT, -3276, -300, true, true},
    {"contacts: capsule on box", PLANE_CONTACTS, on_box, CASE2_BOX, CASE2_SEGMENT, 0, DEGREE, true, true},
    {"contacts: boxes flush", PLANE_CONTACTS, on_box, CASE2_BOX, CASE2_BOX, 0, 0, false, true},
    {"contacts: boxes tilted", PLANE_CONTACTS, on_box, CASE2_BOX, CASE2_BOX, 0, DEGREE, false, true},
    {"contacts: circle on a chain", PLANE_CHAIN, on_chain, CASE2_POLYGON, CASE2_POINT, 0, 0, true, false},
    {"contacts: box on a chain", PLANE_CHAIN, on_chain, CASE2_POLYGON, CASE2_BOX, 0, 0, true, false},
};
const size_t plane_cost_family_count = sizeof plane_cost_families / sizeof plane_cost_families[0];

static void set_solid(const exact2_posed *posed, const gjk2_collider *c, const gjk2_collider *a, plane_solid *out) {
  out->count = posed->hull.count;
  out->corner = measuring_allocate(out->count, sizeof *out->corner);
  out->centre[0] = (double)((int64_t)c->centre.x - a->centre.x) / PLANE_LSB_PER_UNIT;
  out->centre[1] = (double)((int64_t)c->centre.y - a->centre.y) / PLANE_LSB_PER_UNIT;
  for (size_t i = 0; i < out->count; i++) {
    out->corner[i][0] = (double)(posed->hull.point[i].x - c->centre.x) / PLANE_LSB_PER_UNIT;
    out->corner[i][1] = (double)(posed->hull.point[i].y - c->centre.y) / PLANE_LSB_PER_UNIT;
  }
}

// False: one of the shapes is flat or has more corners than other libraries take. own: no other is asked.
static bool set_pair(case2_pair *shapes, bool own, plane_pair *out) {
  exact2_pair exact;
  for (int i = 0; i < 2; i++) {
    out->collider[i] = measuring_allocate(1, sizeof **out->collider);
    if (case2_collider_build(out->collider[i], i == 0 ? &shapes->a : &shapes->b, false) != GJK_OK) {
      exit(1);
    }
  }
  if (own) {
    return true;
  }
  const gjk2_collider *a = &out->collider[0]->collider, *b = &out->collider[1]->collider;
  if (!exact2_pair_set(a, b, &exact)) {
    exit(1);
  }
  const unsigned n = exact.a.hull.count, m = exact.b.hull.count;
  const bool fits = n >= 3 && m >= 3 && n <= 8 && m <= 8;
  if (fits) {
    out->intersecting = exact.truth.intersecting;
    set_solid(&exact.a, a, a, &out->solid[0]);
    set_solid(&exact.b, b, a, &out->solid[1]);
  } else {
    case2_collider_free(out->collider[0]);
    case2_collider_free(out->collider[1]);
    free(out->collider[0]);
    free(out->collider[1]);
  }
  exact2_pair_free(&exact);
  return fits;
}

plane_pair *plane_pairs_make(const plane_family *family, uint64_t seed, size_t count) {
  plane_pair *pairs = measuring_allocate(count, sizeof *pairs);
  random_state random = random_seed(seed);
  for (size_t i = 0; i < count; i++) {
    bool made = false;
    while (!made) {
      // A collider points into its case, which stays until the end of the program.
      case2_pair *shapes = measuring_allocate(1, sizeof *shapes);
      case2_shape_reset(&shapes->a);
      case2_shape_reset(&shapes->b);
      family->generate(family, &random, i, shapes);
      made = set_pair(shapes, family->own, &pairs[i]);
      if (!made) {
        case2_pair_free(shapes);
        free(shapes);
      }
    }
  }
  return pairs;
}

void plane_pairs_free(plane_pair *pairs, size_t count) {
  for (size_t i = 0; i < count; i++) {
    for (int k = 0; k < 2; k++) {
      case2_collider_free(pairs[i].collider[k]);
      free(pairs[i].collider[k]);
      free(pairs[i].solid[k].corner);
    }
  }
  free(pairs);
}
