// Queries of meshes and height fields through gjk/parts.h: the very answers that asking every triangle gives, at any pose.
// Turned vertices are shared. A body that slides over flat ground of either kind meets its normal alone.
#include <math.h>
#include <string.h>

#include "check.h"
#include "generate/surface.h"
#include "gjk/height_field.h"
#include "gjk/surface.h"
#include "reference/random_shape.h"

#define SEED UINT64_C(0x4D517279)
#define SIDE 24
#define FOUND 200

static struct { unsigned long bodies, near, hits, rays, holes, slides, manifolds; } tally;

typedef struct trial {
  gjk_parts parts;
  case_shape source;
  case_collider body;
} trial;

static void show(const void *subject) {
  const trial *t = (const trial *)subject;
  const gjk_quat *q = &t->source.pose.rotation;
  printf("  body kind %d at (%d, %d, %d) turned (%d, %d, %d, %d)\n", (int)t->source.kind,
         (int)t->source.pose.position.x, (int)t->source.pose.position.y, (int)t->source.pose.position.z, (int)q->x,
         (int)q->y, (int)q->z, (int)q->w);
}

static void make_body(random_state *random, trial *t, int32_t step, gjk_vec3 near) {
  static const case_kind kinds[] = {CASE_BOX, CASE_POINT, CASE_SEGMENT, CASE_HULL};
  random_shape(random, kinds[random_below(random, 4)], 1 + (gjk_q16)(step * 3 * random_unit(random)), &t->source);
  const gjk_vec3 off = random_vector(random, 4.0 * step * random_unit(random));
  t->source.pose.position = (gjk_vec3){near.x + off.x, near.y + off.y, near.z + off.z};
  t->source.pose.rotation = random_rotation(random);
  case_collider_free(&t->body);
  CHECK(case_collider_build(&t->body, &t->source, false) == GJK_OK);
}

// Every triangle, one after the other.
static void check_all(random_state *random, trial *t, int32_t step) {
  const gjk_collider *b = &t->body.collider;
  const gjk_q16 margin = random_range(random, 0, 2 * step);
  const gjk_vec3 off = random_vector(random, 20.0 * step), at = t->source.pose.position;
  const gjk_vec3 to = {at.x + off.x, at.y + off.y, at.z + off.z};
  const gjk_cast_path path = {NULL, &to, 0};
  gjk_distance_result best, d, found;
  gjk_cast_result first, c, ray, hit;
  gjk_decision decision, answer;
  uint32_t nearest = GJK_PARTS_NONE, within = GJK_PARTS_NONE, meets = GJK_PARTS_NONE, enters = GJK_PARTS_NONE, part;
  memset(&best, 0, sizeof best);
  memset(&first, 0, sizeof first);
  memset(&ray, 0, sizeof ray);
  for (uint32_t i = 0; i < gjk_parts_count(&t->parts); i++) {
    gjk_parts_room room;
    gjk_collider triangle;
    const gjk_status status = gjk_parts_place(&t->parts, i, &room, &triangle);
    if (status == GJK_ERROR_RANGE) {
      tally.holes++;
      continue;
    }
    CHECK(status == GJK_OK && gjk_distance(&triangle, b, NULL, &d) == GJK_OK);
    if (nearest == GJK_PARTS_NONE || (d.intersecting && !best.intersecting) ||
        (d.intersecting == best.intersecting && d.distance < best.distance)) {
      nearest = i;
      best = d;
    }
    CHECK(gjk_within(&triangle, b, margin, NULL, &decision) == GJK_OK);
    within = decision.yes && within == GJK_PARTS_NONE ? i : within;
    CHECK(gjk_cast(&triangle, b, &path, &c) == GJK_OK);
    if (c.hit && (meets == GJK_PARTS_NONE || c.fraction < first.fraction)) {
      meets = i;
      first = c;
    }
    CHECK(gjk_cast_ray(&triangle, &at, &to, &c) == GJK_OK);
    if (c.hit && (enters == GJK_PARTS_NONE || c.fraction < ray.fraction)) {
      enters = i;
      ray = c;
    }
  }
  memset(&found, 0, sizeof found);
  CHECK(gjk_parts_distance(&t->parts, b, &part, &found) == GJK_OK);
  CHECK_MSG(part == nearest && found.distance == best.distance && found.intersecting == best.intersecting,
            "triangle %lu at %d, expected %lu at %d", (unsigned long)part, (int)found.distance, (unsigned long)nearest,
            (int)best.distance);
  CHECK(best.intersecting || (memcmp(&found.point_a, &best.point_a, sizeof found.point_a) == 0 &&
                              memcmp(&found.normal, &best.normal, sizeof found.normal) == 0));
  CHECK(gjk_parts_within(&t->parts, b, margin, &part, &answer) == GJK_OK && part == within &&
        answer.yes == (within != GJK_PARTS_NONE));
  CHECK(gjk_parts_intersect(&t->parts, b, &part, &answer) == GJK_OK && answer.yes == best.intersecting &&
        (!answer.yes || part == nearest));
  CHECK(gjk_parts_cast(&t->parts, b, &path, &part, &hit) == GJK_OK);
  CHECK_MSG(part == meets && hit.hit == (meets != GJK_PARTS_NONE) && (!hit.hit || hit.fraction == first.fraction),
            "cast meets %lu, expected %lu", (unsigned long)part, (unsigned long)meets);
  CHECK(gjk_parts_cast_ray(&t->parts, &at, &to, &part, &hit) == GJK_OK);
  CHECK_MSG(part == enters && hit.hit == (enters != GJK_PARTS_NONE) && (!hit.hit || hit.fraction == ray.fraction),
            "ray enters %lu, expected %lu", (unsigned long)part, (unsigned long)enters);
  tally.bodies++;
  tally.near += within != GJK_PARTS_NONE;
  tally.hits += meets != GJK_PARTS_NONE;
  tally.rays += enters != GJK_PARTS_NONE;
}

static void pose_randomly(random_state *random, gjk_parts *parts) {
  parts->pose.position = random_vector(random, random_below(random, 2) ? 100000 : 1.0e9);
  if (random_below(random, 4) != 0) {
    parts->pose.rotation = random_rotation(random);
  }
}

static void check_meshes(uint64_t seed, trial *t) {
  for (unsigned long i = 0; i < 60; i++) {
    random_state random = random_seed(seed + i);
    const int32_t step = 1 << random_range(&random, 3, 18);
    surface s;
    surface_make(&random, (surface_kind)(i % SURFACE_KINDS), 1 + random_below(&random, 200), step, false, &s);
    t->parts = (gjk_parts)GJK_PARTS_OF_MESH(&s.mesh);
    pose_randomly(&random, &t->parts);
    for (int k = 0; k < 6; k++) {
      gjk_parts_room room;
      gjk_collider triangle;
      CHECK(gjk_parts_place(&t->parts, random_below(&random, s.triangle_count), &room, &triangle) == GJK_OK);
      make_body(&random, t, step, triangle.centre);
      check_trial(i, show, t);
      check_all(&random, t, step);
    }
    surface_free(&s);
  }
}

static void check_fields(uint64_t seed, trial *t) {
  static int16_t heights[SIDE * SIDE];
  for (unsigned long i = 0; i < 40; i++) {
    random_state random = random_seed(seed + i);
    const uint16_t columns = (uint16_t)(2 + random_below(&random, SIDE - 1)),
                   rows = (uint16_t)(2 + random_below(&random, 9));
    const int32_t step = 1 << random_range(&random, 3, 18);
    const gjk_height_field field = GJK_HEIGHT_FIELD(heights, columns, rows, step, 1 + step / 2, 1 + step / 4096);
    for (unsigned k = 0; k < (unsigned)columns * rows; k++) {
      const bool hole = i % 3 == 0 && k > 3 && random_below(&random, 8) == 0;
      heights[k] = hole ? GJK_HEIGHT_HOLE : (int16_t)random_range(&random, -2000, 2000);
    }
    const gjk_status status = gjk_height_field_check(&field);
    CHECK(status == GJK_OK || (i % 3 == 0 && status == GJK_ERROR_EMPTY));
    t->parts = (gjk_parts)GJK_PARTS_OF_HEIGHT_FIELD(&field);
    CHECK(gjk_parts_count(&t->parts) == 2u * (columns - 1u) * (rows - 1u));
    pose_randomly(&random, &t->parts);
    for (int k = 0; k < 6 && status == GJK_OK; k++) {
      gjk_parts_room room;
      gjk_collider triangle;
      if (gjk_parts_place(&t->parts, random_below(&random, gjk_parts_count(&t->parts)), &room, &triangle) == GJK_OK) {
        make_body(&random, t, step, triangle.centre);
        check_trial(i, show, t);
        check_all(&random, t, step);
      }
    }
  }
}

// The largest and smallest fields that there may be, and what is just beyond.
static void check_limits(void) {
  static int16_t heights[2 * (GJK_HEIGHT_FIELD_SIDE_MAX + 1)];
  static const struct {
    uint16_t columns, rows;
    gjk_q16 step_x, step_y, step_z;
    bool right;
  } limits[] = {
      {2, 2, 1, 1, 1, true},
      {1, 2, 1, 1, 1, false},
      {2, 1, 1, 1, 1, false},
      {2, 2, 0, 1, 1, false},
      {2, 2, 1, 0, 1, false},
      {2, 2, 1, 1, 0, false},
      {2, 2, GJK_RADIUS_MAX, GJK_RADIUS_MAX, GJK_HEIGHT_FIELD_STEP_MAX, true},
      {2, 2, GJK_RADIUS_MAX + 1, 1, 1, false},
      {2, 2, 1, GJK_RADIUS_MAX + 1, 1, false},
      {2, 2, 1, 1, GJK_HEIGHT_FIELD_STEP_MAX + 1, false},
      {GJK_HEIGHT_FIELD_SIDE_MAX, 2, INT32_C(1) << 15, 1, 1, true},
      {2, GJK_HEIGHT_FIELD_SIDE_MAX, 1, INT32_C(1) << 15, 1, true},
      {GJK_HEIGHT_FIELD_SIDE_MAX + 1, 2, 1, 1, 1, false},
      {2, GJK_HEIGHT_FIELD_SIDE_MAX + 1, 1, 1, 1, false},
      {5, 2, INT32_C(1) << 28, 1, 1, false},  // a step beyond GJK_RADIUS_MAX
      {9, 2, INT32_C(1) << 27, 1, 1, true},   // 16384 units long
      {2, 9, 1, (INT32_C(1) << 27) + 1, 1, false},
  };
  for (unsigned i = 0; i < sizeof limits / sizeof *limits; i++) {
    const gjk_height_field field = GJK_HEIGHT_FIELD(heights, limits[i].columns, limits[i].rows, limits[i].step_x,
                                                    limits[i].step_y, limits[i].step_z);
    const gjk_parts parts = GJK_PARTS_OF_HEIGHT_FIELD(&field);
    const uint32_t count = 2 * (limits[i].columns - UINT32_C(1)) * (limits[i].rows - UINT32_C(1));
    CHECK_MSG(gjk_height_field_check(&field) == (limits[i].right ? GJK_OK : GJK_ERROR_RANGE), "limit %u", i);
    CHECK(gjk_parts_count(&parts) == (limits[i].right ? count : 0));
  }
}

static void check_refusals(void) {
  static int16_t heights[9];
  const gjk_height_field good = GJK_HEIGHT_FIELD(heights, 3, 3, 10, 10, 1);
  gjk_height_field bad = good;
  CHECK(gjk_height_field_check(&good) == GJK_OK && gjk_height_field_check(NULL) == GJK_ERROR_NULL);
  bad.columns = 1;
  CHECK(gjk_height_field_check(&bad) == GJK_ERROR_RANGE);
  bad = good;
  bad.step_x = 0;
  CHECK(gjk_height_field_check(&bad) == GJK_ERROR_RANGE);
  bad = good;
  bad.step_y = INT32_C(1) << 29;
  CHECK(gjk_height_field_check(&bad) == GJK_ERROR_RANGE);
  bad = good;
  bad.step_z = GJK_HEIGHT_FIELD_STEP_MAX + 1;
  CHECK(gjk_height_field_check(&bad) == GJK_ERROR_RANGE);
  const gjk_parts parts = GJK_PARTS_OF_HEIGHT_FIELD(&bad);
  static const gjk_shape ball = GJK_SPHERE(100);
  const gjk_pose pose = GJK_POSE_IDENTITY;
  gjk_collider body;
  gjk_decision decision;
  gjk_surface_contact contact[2];
  uint16_t count = 7;
  CHECK(gjk_collider_init(&body, &ball, NULL, 0) == GJK_OK && gjk_collider_pose(&body, &pose) == GJK_OK);
  CHECK(gjk_parts_intersect(&parts, &body, NULL, &decision) == GJK_ERROR_EMPTY);
  const gjk_parts sound = GJK_PARTS_OF_HEIGHT_FIELD(&good);
  CHECK(gjk_surface_contacts(&sound, &body, -1, 4, NULL, contact, 2, &count) == GJK_ERROR_NEGATIVE);
  CHECK(gjk_surface_contacts(&sound, &body, GJK_RADIUS_MAX + 1, 4, NULL, contact, 2, &count) == GJK_ERROR_RANGE);
  CHECK(gjk_surface_contacts(&sound, &body, 0, 9, NULL, contact, 2, &count) == GJK_ERROR_RANGE);
  CHECK(gjk_surface_contacts(&sound, &body, 0, 4, NULL, NULL, 2, &count) == GJK_ERROR_NULL && count == 7);
  CHECK(gjk_surface_contacts(&sound, &body, 0, 4, NULL, contact, 1, &count) == GJK_ERROR_CAPACITY && count == 1);
  CHECK(gjk_surface_contacts(&sound, &body, 0, 4, NULL, NULL, 0, &count) == GJK_ERROR_CAPACITY && count == 0);
}

// Slides over flat ground, an LSB or more into it, at any angle: every normal is the ground's.
static void check_slides(uint64_t seed) {
  static const gjk_vec3 hull[6] = {{30000, 0, -9000}, {-15000, 26000, -9000}, {-15000, -26000, -9000},
                                   {30000, 0, 9000},  {-15000, 26000, 9000},  {-15000, -26000, 9000}};
  static const gjk_shape shapes[] = {GJK_BOX(30000, 20000, 10000), GJK_SPHERE(25000), GJK_CAPSULE(9000, 30000),
                                     GJK_HULL(hull, 6), GJK_CYLINDER(20000, 9000)};
  static const gjk_q16 lowest[] = {10000, 25000, 39000, 9000, 9000};
  static gjk_epa_cell cells[2000];
  const gjk_workspace workspace = {cells, 2000};
  for (unsigned long i = 0; i < 60; i++) {
    random_state random = random_seed(seed + i);
    const unsigned kind = (unsigned)(i % 5);
    surface s;
    surface_make(&random, SURFACE_FLAT, 3200, random_range(&random, 6000, 50000), false, &s);
    // Level ground, which the same turn as the body's tilts.
    for (uint32_t k = 0; k < s.vertex_count; k++) {
      s.vertices[k].z = 0;
    }
    CHECK(gjk_mesh_build(s.vertices, s.vertex_count, s.triangles, s.triangle_count, false, s.nodes, s.node_count,
                         &s.mesh) == GJK_OK);
    const gjk_parts ground = GJK_PARTS_OF_MESH(&s.mesh);
    gjk_collider body;
    gjk_pose pose = GJK_POSE_IDENTITY;
    const int32_t sink = random_range(&random, 0, 60);
    const gjk_vec3 axis = {0, 0, 1}, way = random_vector(&random, random_range(&random, 100, 20000));
    CHECK(gjk_quat_from_axis_angle(&axis, random_range(&random, -200000, 200000), &pose.rotation) == GJK_OK);
    CHECK(gjk_collider_init(&body, &shapes[kind], NULL, 0) == GJK_OK);
    check_trial(i, NULL, NULL);
    for (int tick = 0; tick < 40; tick++) {
      static gjk_surface_contact found[FOUND];
      uint16_t count = 0;
      pose.position.x = tick * way.x % (s.mesh.upper.x - 40000 > 0 ? s.mesh.upper.x - 40000 : 1);
      pose.position.y = tick * way.y % (s.mesh.upper.y - 40000 > 0 ? s.mesh.upper.y - 40000 : 1);
      pose.position.z = lowest[kind] - sink;
      CHECK(gjk_collider_pose(&body, &pose) == GJK_OK);
      CHECK(gjk_surface_contacts(&ground, &body, 200, 4, &workspace, found, FOUND, &count) == GJK_OK);
      CHECK_MSG(count > 0, "kind %u at (%d, %d)", kind, (int)pose.position.x, (int)pose.position.y);
      gjk_q16 least = 1000;
      for (unsigned k = 0; k < count; k++) {
        const gjk_unit3 *n = &found[k].manifold.normal;
        CHECK_MSG(abs(n->x) <= 2 && abs(n->y) <= 2 && n->z > GJK_Q30_ONE - 4, "kind %u: normal (%d, %d, %d)", kind,
                  (int)n->x, (int)n->y, (int)n->z);
        for (unsigned c = 0; c < found[k].manifold.count; c++) {
          least = found[k].manifold.contact[c].distance < least ? found[k].manifold.contact[c].distance : least;
        }
      }
      CHECK_MSG(abs(least + sink) <= 4, "kind %u, %d deep, %d expected", kind, (int)-least, (int)sink);
      tally.slides++;
      tally.manifolds += count;
    }
    surface_free(&s);
  }
}

int main(void) {
  static trial t;
  const uint64_t seed = check_seed(SEED);
  check_limits();
  check_refusals();
  check_meshes(seed, &t);
  check_fields(seed + 1000, &t);
  check_slides(seed + 2000);
  case_collider_free(&t.body);
  case_shape_free(&t.source);
  printf(
      "%lu bodies, %lu near, %lu hit on their way, %lu by their ray; %lu triangles at holes; %lu ticks of slides, %lu "
      "manifolds\n",
      tally.bodies, tally.near, tally.hits, tally.rays, tally.holes, tally.slides, tally.manifolds);
  CHECK(tally.near > tally.bodies / 10 && tally.near < tally.bodies && tally.hits > tally.bodies / 10 &&
        tally.rays > tally.bodies / 20 && tally.holes > 100);
  return check_done("mesh_query");
}
