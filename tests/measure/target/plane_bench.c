// Makes pairs of the plane: shapes of 0.2 to 1 unit, 0.1 to 2 units apart, less than 0.1 unit apart (close), overlapping,
// or with two edges face to face, tilted by up to a degree and up to 0.05 units deep or 0.02 apart. Or one of them on a
// chain: a box tilted by up to a degree, a polygon turned any way.
#include "plane_bench.h"

#include "random.h"

const plane_family plane_families[] = {
    {"boxes apart: distance", PLANE_DISTANCE, PLANE_APART, 0, 0},
    {"8-gons apart: distance", PLANE_DISTANCE, PLANE_APART, 8, 0},
    {"8-gons close: intersect", PLANE_INTERSECT, PLANE_CLOSE, 8, 0},
    {"8-gons overlapping: depth", PLANE_DEPTH, PLANE_OVERLAPPING, 8, 0},
    {"8-gons face to face: contacts", PLANE_CONTACTS, PLANE_PRESSED, 8, 0},
    {"boxes apart: intersect", PLANE_INTERSECT, PLANE_APART, 0, 0},
    {"boxes close: intersect", PLANE_INTERSECT, PLANE_CLOSE, 0, 0},
    {"boxes close: distance", PLANE_DISTANCE, PLANE_CLOSE, 0, 0},
    {"boxes overlapping: intersect", PLANE_INTERSECT, PLANE_OVERLAPPING, 0, 0},
    {"boxes overlapping: depth", PLANE_DEPTH, PLANE_OVERLAPPING, 0, 0},
    {"boxes face to face: contacts", PLANE_CONTACTS, PLANE_PRESSED, 0, 0},
    {"boxes within the margin: contacts", PLANE_CONTACTS, PLANE_HOVERING, 0, 0},
    {"8-gons within the margin: contacts", PLANE_CONTACTS, PLANE_HOVERING, 8, 0},
    {"8-gons overlapping: intersect", PLANE_INTERSECT, PLANE_OVERLAPPING, 8, 0},
    {"32-gons apart: distance", PLANE_DISTANCE, PLANE_APART, 32, 0},
    {"32-gons overlapping: depth", PLANE_DEPTH, PLANE_OVERLAPPING, 32, 0},
    {"rounded boxes apart: distance", PLANE_DISTANCE, PLANE_APART, 0, 6554},
    {"8-gons apart: cast", PLANE_CAST, PLANE_APART, 8, 0},
    {"boxes apart: cast", PLANE_CAST, PLANE_APART, 0, 0},
    {"rounded boxes apart: cast", PLANE_CAST, PLANE_APART, 0, 6554},
    {"8-gon: ray", PLANE_RAY, PLANE_APART, 8, 0},
    {"8-gons apart: impact, straight", PLANE_STRAIGHT_IMPACT, PLANE_APART, 8, 0},
    {"8-gons apart: impact, turning", PLANE_IMPACT, PLANE_APART, 8, 0},
    {"boxes apart: impact, turning", PLANE_IMPACT, PLANE_APART, 0, 0},
    {"box above 64 segments: chain", PLANE_CHAIN, PLANE_ABOVE, 0, 0},
    {"box on a segment: chain", PLANE_CHAIN, PLANE_SEGMENT, 0, 0},
    {"box on a level joint: chain", PLANE_CHAIN, PLANE_LEVEL, 0, 0},
    {"box on a ridge: chain", PLANE_CHAIN, PLANE_RIDGE, 0, 0},
    {"box in a ditch: chain", PLANE_CHAIN, PLANE_DITCH, 0, 0},
    {"8-gon on a segment: chain", PLANE_CHAIN, PLANE_SEGMENT, 8, 0},
    {"8-gon on a level joint: chain", PLANE_CHAIN, PLANE_LEVEL, 8, 0},
    {"8-gon on a ridge: chain", PLANE_CHAIN, PLANE_RIDGE, 8, 0},
    {"8-gon in a ditch: chain", PLANE_CHAIN, PLANE_DITCH, 8, 0},
};
const unsigned plane_family_count = sizeof plane_families / sizeof plane_families[0];

#define VERTICES 32

static random_state random;
static gjk2_vec vertices[2][VERTICES], buffers[2][VERTICES];
static gjk2_shape shapes[2];
static gjk2_collider colliders[2];
static gjk2_pose poses[2];  // of pairs at random places

void plane_bench_start(void) {
  random = random_seed(13);
}

// Points of an ellipse at count angles in order, each in its share of the turn.
static void make_polygon(gjk2_vec *v, uint16_t count) {
  const gjk_q16 x = random_range(&random, 13107, 65536), y = random_range(&random, 13107, 65536);
  for (uint16_t i = 0; i < count; i++) {
    gjk2_rotation turn;
    const gjk_angle share = 411775 / count;
    (void)gjk2_rotation_from_angle(i * share + random_range(&random, 0, share * 2 / 3), &turn);
    v[i].x = (gjk_q16)((int64_t)x * turn.c >> 30);
    v[i].y = (gjk_q16)((int64_t)y * turn.s >> 30);
  }
}

static void make_body(const plane_family *family, int i) {
  const gjk_q16 x = random_range(&random, 13107, 65536), y = random_range(&random, 13107, 65536);
  const gjk2_shape box = GJK2_ROUNDED_BOX(x, y, family->radius);
  const gjk2_shape polygon = GJK2_ROUNDED_POLYGON(vertices[i], family->vertices, family->radius);
  if (family->vertices == 0) {
    shapes[i] = box;
  } else {
    make_polygon(vertices[i], family->vertices);
    shapes[i] = polygon;
  }
  colliders[i].state = 0;
  (void)gjk2_collider_init(&colliders[i], &shapes[i], buffers[i], VERTICES);
}

static gjk2_rotation random_turn(gjk_angle most) {
  gjk2_rotation turn;
  (void)gjk2_rotation_from_angle(random_range(&random, -most, most), &turn);
  return turn;
}

// The gap of the pair as it is posed; negative where it overlaps.
static gjk_q16 gap_now(void) {
  gjk2_distance_result now;
  (void)gjk2_signed_distance(&colliders[0], &colliders[1], NULL, &now);
  return now.distance;
}

static void place_randomly(const plane_family *family) {
  for (;;) {
    for (int i = 0; i < 2; i++) {
      gjk2_pose *pose = &poses[i];
      make_body(family, i);
      pose->rotation = random_turn(205887);
      pose->position.x = i == 0 ? 0 : random_range(&random, -200000, 200000);
      pose->position.y = i == 0 ? 0 : random_range(&random, -200000, 200000);
      (void)gjk2_collider_pose(&colliders[i], pose);
    }
    const gjk_q16 gap = gap_now();
    if (family->gap == PLANE_APART   ? gap > 6553 && gap < 131072
        : family->gap == PLANE_CLOSE ? gap > 0 && gap < 6553
                                     : gap < -1000) {
      return;
    }
  }
}

// The corner with this number of a box or polygon, and the next counterclockwise, shape frame.
static void edge_of(const plane_family *family, int i, unsigned number, gjk2_vec *p, gjk2_vec *q) {
  if (family->vertices != 0) {
    *p = vertices[i][number % family->vertices];
    *q = vertices[i][(number + 1) % family->vertices];
    return;
  }
  const gjk2_vec size = shapes[i].size;
  for (unsigned k = 0; k < 2; k++) {
    const unsigned at = (number + k) % 4;
    gjk2_vec *out = k == 0 ? p : q;
    out->x = at == 0 || at == 3 ? size.x : -size.x;
    out->y = at < 2 ? size.y : -size.y;
  }
}

// B's edge lies on A's, the other way round.
static void place_face_to_face(const plane_family *family) {
  gjk2_vec p[2], q[2];
  gjk2_rotation along[2];
  gjk2_pose pose[2];
  for (int i = 0; i < 2; i++) {
    make_body(family, i);
    edge_of(family, i, random_below(&random, 32), &p[i], &q[i]);
    const gjk2_rotation raw = {q[i].x - p[i].x, q[i].y - p[i].y};
    (void)gjk2_rotation_normalize(&raw, &along[i]);
  }
  const gjk2_rotation tilt = random_turn(1144);
  gjk2_rotation back;
  pose[0].rotation = random_turn(205887);
  pose[0].position.x = 0;
  pose[0].position.y = 0;
  (void)gjk2_rotation_compose(&pose[0].rotation, &along[0], &along[0]);  // of A's edge in the world
  (void)gjk2_rotation_invert(&along[1], &back);
  (void)gjk2_rotation_compose(&along[0], &back, &pose[1].rotation);
  (void)gjk2_rotation_compose(&tilt, &pose[1].rotation, &pose[1].rotation);
  pose[1].rotation.c = -pose[1].rotation.c;
  pose[1].rotation.s = -pose[1].rotation.s;
  // Middles of the edges meet, aside by up to 0.1 unit and apart by what the family says.
  const gjk2_vec half[2] = {{p[0].x / 2 + q[0].x / 2, p[0].y / 2 + q[0].y / 2},
                            {p[1].x / 2 + q[1].x / 2, p[1].y / 2 + q[1].y / 2}};
  gjk2_vec at[2];
  for (int i = 0; i < 2; i++) {
    (void)gjk2_rotation_apply(&pose[i].rotation, &half[i], &at[i]);
  }
  const gjk_q16 aside = random_range(&random, -6553, 6553);
  const gjk_q16 gap =
      family->gap == PLANE_PRESSED ? random_range(&random, -3276, -300) : random_range(&random, 400, 1310);
  pose[1].position.x = at[0].x - at[1].x + (gjk_q16)(((int64_t)along[0].c * aside + (int64_t)along[0].s * gap) >> 30);
  pose[1].position.y = at[0].y - at[1].y + (gjk_q16)(((int64_t)along[0].s * aside - (int64_t)along[0].c * gap) >> 30);
  for (int i = 0; i < 2; i++) {
    (void)gjk2_collider_pose(&colliders[i], &pose[i]);
  }
}

static gjk2_motion motions[2];

// The way of B, beyond A's centre, and how both turn meanwhile.
static void place_ways(const plane_family *family) {
  for (int i = 0; i < 2; i++) {
    motions[i].from = poses[i];
    motions[i].to = poses[i];
    motions[i].spin = 0;
    if (family->query == PLANE_IMPACT) {
      motions[i].to.rotation = random_turn(205887);
    }
  }
  gjk2_vec *to = &motions[1].to.position;
  to->x = -to->x + random_range(&random, -32768, 32768);
  to->y = -to->y + random_range(&random, -32768, 32768);
}

void plane_bench_next(const plane_family *family) {
  if (family->query == PLANE_CHAIN) {
    make_body(family, 1);
    const gjk2_rotation turn = random_turn(family->vertices == 0 ? 1144 : 205887);
    plane_bench_ground(&random, family->gap, &colliders[1], &turn);
  } else if (family->gap <= PLANE_OVERLAPPING) {
    place_randomly(family);
  } else {
    place_face_to_face(family);
  }
  if (family->query >= PLANE_CAST) {
    place_ways(family);
  }
}

static uint32_t run_motion(const plane_family *family) {
  static gjk2_cast_result cast;
  static gjk2_impact_result impact;
  static const gjk2_impact_setup setup = {.margin = 0, .tolerance = 327, .iterations = 0};  // 0.005 units
  const gjk2_collider *a = &colliders[0], *b = &colliders[1];
  const gjk2_cast_path path = {NULL, &motions[1].to.position, 0};
  switch (family->query) {
    case PLANE_CAST: (void)gjk2_cast(a, b, &path, &cast); return cast.iterations;
    case PLANE_RAY: (void)gjk2_cast_ray(a, &b->position, path.to_b, &cast); return cast.iterations;
    default: break;
  }
  (void)gjk2_time_of_impact(a, &motions[0], b, &motions[1], &setup, &impact);
  return impact.iterations;
}

uint32_t plane_bench_run(const plane_family *family) {
  static gjk2_decision decision;
  static gjk2_distance_result distance;
  static gjk2_penetration_result depth;
  static gjk2_manifold manifold;
  const gjk2_collider *a = &colliders[0], *b = &colliders[1];
  switch (family->query) {
    case PLANE_INTERSECT: (void)gjk2_intersect(a, b, NULL, &decision); return decision.iterations;
    case PLANE_DISTANCE: (void)gjk2_distance(a, b, NULL, &distance); return distance.iterations;
    case PLANE_DEPTH: (void)gjk2_penetration(a, b, NULL, &depth); return depth.iterations;
    case PLANE_CHAIN: return plane_bench_chain(b);
    case PLANE_CONTACTS: break;
    default: return run_motion(family);
  }
  (void)gjk2_contacts(a, b, 1311, 2, NULL, &manifold);
  return manifold.count;
}
