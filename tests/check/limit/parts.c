// Bodies of many parts and surfaces: what a low ceiling on iterations leaves of every query. test_limit.sh builds it with low
// ceilings and with the usual one, and compares what it prints, a line for each question:
//
//   number question status hit value lower upper
//
// hit: yes, intersecting, hit, or how many manifolds. value, lower, upper: distance, depth or fraction and its bounds. Of a
// status that leaves outputs as they were it is checked that it does.
//
// With the name of such a file as an argument: at no fraction before an impact's lower one do the shapes touch, by the distance
// at the fraction just before it.
#include <stdio.h>
#include <string.h>

#include "filled.h"
#include "gjk/gjk.h"
#include "random.h"

#define BODIES 150
#define VISITORS 4
#define PARTS 14
#define SIDE 5
#define VERTICES 10
#define FOUND 60
#define CELLS 400

static gjk_vec3 hull[VERTICES], corners[(SIDE + 1) * (SIDE + 1)];
static gjk_shape shapes[6];
static gjk_compound_part parts[PARTS];
static gjk_compound_node nodes[GJK_COMPOUND_NODES(PARTS)];
static gjk_compound compound;
static gjk_mesh_triangle triangles[2 * SIDE * SIDE];
static gjk_mesh_node mesh_nodes[GJK_MESH_NODES(2 * SIDE * SIDE)];
static gjk_mesh mesh;
static int16_t heights[(SIDE + 1) * (SIDE + 1)];
static const gjk_height_field *field;
static gjk_parts body, chair;
static gjk_collider visitor;
static gjk_epa_cell cells[CELLS];
static const gjk_workspace workspace = {cells, CELLS};
static unsigned failures, question;
static gjk_q30 claimed[BODIES * VISITORS + 1];  // the lower fractions of the file

static void expect(bool holds, const char *what) {
  if (!holds) {
    printf("failed: question %u, %s\n", question, what);
    failures++;
  }
}

static void print_answer(const char *name, gjk_status status, unsigned hit, gjk_q16 value, gjk_q16 lower,
                         gjk_q16 upper) {
  printf("%u %s %d %u %ld %ld %ld\n", question, name, (int)status, hit, (long)value, (long)lower, (long)upper);
}

static gjk_vec3 random_vector(random_state *random, int32_t size) {
  gjk_vec3 v;
  v.x = random_range(random, -size, size);
  v.y = random_range(random, -size, size);
  v.z = random_range(random, -size, size);
  return v;
}

static void turn(random_state *random, gjk_quat *out) {
  gjk_quat q = {0, 0, 0, 0};
  q.x = random_range(random, -1000, 1000);
  q.y = random_range(random, -1000, 1000);
  q.z = random_range(random, -1000, 1000);
  q.w = random_range(random, 1, 1000);
  if (random_below(random, 3) != 0) {
    expect(gjk_quat_normalize(&q, out) == GJK_OK, "rotation");
  }
}

static void make_shapes(random_state *random, int32_t size) {
  const gjk_shape kinds[6] = {
      GJK_HULL(hull, VERTICES),         GJK_BOX(size, size / 2 + 1, size / 3 + 1),
      GJK_CYLINDER(size / 2 + 1, size), GJK_ELLIPSOID(size, size / 2 + 1, size / 5 + 1),
      GJK_CONE(size / 2 + 1, size),     GJK_ROUNDED_BOX(size, size / 2 + 1, size / 3 + 1, size / 9)};
  for (unsigned i = 0; i < VERTICES; i++) {
    hull[i] = random_vector(random, size);
  }
  memcpy(shapes, kinds, sizeof shapes);
}

static void make_compound(random_state *random, int32_t size) {
  const gjk_pose still = GJK_POSE_IDENTITY;
  const uint16_t count = (uint16_t)(1 + random_below(random, PARTS));
  for (unsigned i = 0; i < count; i++) {
    parts[i].shape = &shapes[random_below(random, 6)];
    parts[i].pose = still;
    parts[i].pose.position = random_vector(random, 4 * size);
    turn(random, &parts[i].pose.rotation);
  }
  expect(gjk_compound_build(parts, count, nodes, sizeof nodes / sizeof nodes[0], &compound) == GJK_OK, "compound");
  const gjk_parts made = GJK_PARTS_OF_COMPOUND(&compound);
  chair = made;
}

static void make_surface(random_state *random, int32_t size, bool of_heights) {
  static gjk_height_field made_field;
  const gjk_height_field flat = GJK_HEIGHT_FIELD(heights, SIDE + 1, SIDE + 1, size, size, size / 512 + 1);
  uint32_t count = 0;
  made_field = flat;
  field = &made_field;
  for (unsigned k = 0; k < (SIDE + 1) * (SIDE + 1); k++) {
    heights[k] = (int16_t)random_range(random, -250, 250);
    corners[k].x = (int32_t)(k % (SIDE + 1)) * size;
    corners[k].y = (int32_t)(k / (SIDE + 1)) * size;
    corners[k].z = heights[k] * (size / 512 + 1);
  }
  for (uint32_t k = 0; k < (uint32_t)SIDE * SIDE; k++) {
    const uint32_t a = k / SIDE * (SIDE + 1) + k % SIDE, b = a + 1, c = a + SIDE + 2, d = a + SIDE + 1;
    const gjk_mesh_triangle two[2] = {{{a, b, c}}, {{a, c, d}}};
    triangles[count++] = two[0];
    triangles[count++] = two[1];
  }
  expect(gjk_mesh_build(corners, (SIDE + 1) * (SIDE + 1), triangles, count, false, mesh_nodes,
                        sizeof mesh_nodes / sizeof mesh_nodes[0], &mesh) == GJK_OK,
         "mesh");
  const gjk_parts of_mesh = GJK_PARTS_OF_MESH(&mesh), of_field = GJK_PARTS_OF_HEIGHT_FIELD(field);
  body = of_heights ? of_field : of_mesh;
}

// Is what a query may write as it was?
static void expect_untouched(const void *out, size_t size, uint32_t part) {
  expect(part == 77 && is_filled(out, size, 0x5A), "an output is touched");
}

static void ask_near(const char *name, const gjk_parts *b, gjk_q16 distance) {
  gjk_decision out;
  gjk_parts_pair pair = {77, 77};
  memset(&out, 0x5A, sizeof out);
  const gjk_status status = b == NULL ? gjk_parts_within(&body, &visitor, distance, &pair.a, &out)
                                      : gjk_parts_both_within(&body, b, distance, &pair, &out);
  if (status != GJK_OK) {
    expect(status == GJK_ERROR_ITERATION_LIMIT, "within");
    expect_untouched(&out, sizeof out, pair.a);
  }
  print_answer(name, status, status == GJK_OK && out.yes, 0, 0, 0);
}

static void ask_distance(const char *name, const gjk_parts *b) {
  gjk_distance_result out;
  gjk_parts_pair pair = {77, 77};
  const gjk_status status =
      b == NULL ? gjk_parts_distance(&body, &visitor, &pair.a, &out) : gjk_parts_both_distance(&body, b, &pair, &out);
  expect(status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT, "distance");
  expect(pair.a != 77 || gjk_parts_count(&body) > 77, "a part is named");
  print_answer(name, status, out.intersecting, out.distance, out.lower, out.upper);
}

static void ask_depth(const char *name, const gjk_parts *b) {
  gjk_penetration_result out;
  gjk_parts_pair pair = {77, 77};
  memset(&out, 0x5A, sizeof out);
  const gjk_status status = b == NULL ? gjk_parts_penetration(&body, &visitor, &workspace, &pair.a, &out)
                                      : gjk_parts_both_penetration(&body, b, &workspace, &pair, &out);
  const bool answered = status == GJK_OK || status == GJK_ERROR_CAPACITY;
  if (!answered) {
    expect(status == GJK_ERROR_ITERATION_LIMIT, "depth");
    expect_untouched(&out, sizeof out, pair.a);
  }
  const bool deep = answered && out.intersecting;
  print_answer(name, status, deep, deep ? out.depth : 0, deep ? out.lower : 0, deep ? out.upper : 0);
}

static void ask_contacts(gjk_q16 margin) {
  static gjk_parts_manifold of_parts[FOUND];
  static gjk_surface_contact of_surface[FOUND];
  uint32_t count = 0;
  uint16_t few = 0;
  gjk_status status = gjk_parts_contacts(&body, &visitor, margin, 4, &workspace, of_parts, FOUND, &count);
  expect(count <= FOUND, "room");
  print_answer("contacts", status, count, 0, 0, 0);
  for (unsigned i = 0; i < count; i++) {
    print_answer("of_part", status, of_parts[i].part, of_parts[i].manifold.count,
                 of_parts[i].manifold.contact[0].distance, of_parts[i].manifold.normal.x);
  }
  status = gjk_surface_contacts(&body, &visitor, margin, 4, &workspace, of_surface, FOUND, &few);
  if (status != GJK_ERROR_UNSUPPORTED) {
    print_answer("surface", status, few, 0, 0, 0);
    for (unsigned i = 0; i < few; i++) {
      print_answer("of_triangle", status, of_surface[i].triangle, of_surface[i].manifold.count,
                   of_surface[i].manifold.contact[0].distance, of_surface[i].manifold.normal.x);
    }
  }
}

static void ask_cast(const char *name, const gjk_parts *b, const gjk_cast_path *path) {
  gjk_cast_result out;
  gjk_parts_pair pair = {77, 77};
  const gjk_status status = b == NULL ? gjk_parts_cast(&body, &visitor, path, &pair.a, &out)
                                      : gjk_parts_both_cast(&body, b, path, &pair, &out);
  expect(status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT, "cast");
  expect(status == GJK_OK || (!out.hit && pair.a != GJK_PARTS_NONE), "an open cast");
  const gjk_q30 fraction = status != GJK_OK || out.hit ? out.fraction : GJK_Q30_ONE;
  print_answer(name, status, out.hit, fraction, fraction, fraction);
}

// Are both apart just before the lower fraction of the file?
static void check_claim(const gjk_motion motion[2]) {
  gjk_parts moved = body;
  gjk_collider guest = visitor;
  gjk_pose pose;
  gjk_distance_result gap;
  const gjk_q30 before = claimed[question] - 1;
  if (before >= 0) {
    expect(gjk_motion_pose(&motion[0], before, &moved.pose) == GJK_OK &&
               gjk_motion_pose(&motion[1], before, &pose) == GJK_OK && gjk_collider_pose(&guest, &pose) == GJK_OK &&
               gjk_parts_distance(&moved, &guest, NULL, &gap) == GJK_OK && !gap.intersecting,
           "a lower fraction beyond the impact");
  }
}

static void read_claims(const char *name) {
  FILE *file = fopen(name, "r");
  char line[200];
  unsigned number;
  long lower;
  expect(file != NULL, "a file");
  while (file != NULL && fgets(line, sizeof line, file) != NULL) {
    if (sscanf(line, "%u impact %*d %*u %*d %ld", &number, &lower) == 2 && number <= BODIES * VISITORS) {
      claimed[number] = (gjk_q30)lower;
    }
  }
  if (file != NULL) {
    fclose(file);
  }
}

// The same motions of two bodies.
static void ask_impact_of_both(const gjk_motion motion[2], const gjk_impact_setup *setup) {
  const gjk_impact_setup rough = {0, setup->tolerance + 16, 0};
  gjk_impact_result out;
  gjk_parts_pair pair = {77, 77};
  gjk_parts moved = body, other = chair;
  gjk_distance_result gap;
  const gjk_status status = gjk_parts_both_time_of_impact(&body, &motion[0], &chair, &motion[1], &rough, &pair, &out);
  expect(status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT, "both_impact");
  expect(status == GJK_OK || (!out.hit && out.upper == GJK_Q30_ONE && pair.b != 77), "an open impact of both");
  expect(out.lower >= 0 && out.lower <= out.upper, "bounds of an impact of both");
  print_answer("both_impact", status, out.hit, out.lower, out.lower, out.upper);
  if (status == GJK_ERROR_ITERATION_LIMIT && out.lower > 0) {
    const gjk_status posed = gjk_motion_pose(&motion[0], out.lower - 1, &moved.pose),
                     of_other = gjk_motion_pose(&motion[1], out.lower - 1, &other.pose),
                     measured = gjk_parts_both_distance(&moved, &other, NULL, &gap);
    expect(posed == GJK_OK && of_other == GJK_OK, "poses of both");
    expect(measured == GJK_ERROR_ITERATION_LIMIT || (measured == GJK_OK && !gap.intersecting),
           "a lower fraction of both beyond the impact");
  }
}

static void ask_impact(random_state *random, const gjk_vec3 *to, int32_t size) {
  static const gjk_motion rest = {.from = GJK_POSE_IDENTITY, .to = GJK_POSE_IDENTITY};
  const gjk_impact_setup setup = {0, GJK_PARTS_TOLERANCE_MIN + size / 512, 0};
  gjk_motion motion[2] = {rest, rest};
  gjk_impact_result out;
  uint32_t part = 77;
  motion[0].from = body.pose;
  motion[0].to = body.pose;
  turn(random, &motion[0].to.rotation);
  motion[1].from.position = visitor.position;
  motion[1].to.position = *to;
  turn(random, &motion[1].to.rotation);
  const gjk_status status = gjk_parts_time_of_impact(&body, &motion[0], &visitor, &motion[1], &setup, &part, &out);
  expect(status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT, "impact");
  expect(status == GJK_OK || (!out.hit && out.upper == GJK_Q30_ONE && part != 77), "an open impact");
  expect(out.lower >= 0 && out.lower <= out.upper, "bounds of an impact");
  print_answer("impact", status, out.hit, out.lower, out.lower, out.upper);
  check_claim(motion);
  if (body.data != &compound) {
    ask_impact_of_both(motion, &setup);
  }
}

static void ask_all(random_state *random, int32_t size) {
  gjk_vec3 to = random_vector(random, 2 * size);
  const bool wide = random_below(random, 2) == 0;
  to.x += body.pose.position.x;
  to.y += body.pose.position.y;
  to.z += body.pose.position.z;
  const gjk_cast_path path = {.to_b = &to, .margin = wide ? size / 8 : 0}, of_body = {.to_a = &to};
  ask_near("intersect", NULL, 0);
  ask_near("within", NULL, size);
  ask_distance("distance", NULL);
  ask_depth("depth", NULL);
  ask_contacts(size / 8);
  ask_cast("cast", NULL, &path);
  ask_impact(random, &to, size);
  if (body.data != &compound) {
    ask_near("both_within", &chair, size);
    ask_distance("both_distance", &chair);
    ask_depth("both_depth", &chair);
    ask_cast("both_cast", &chair, &of_body);
  }
}

int main(int argc, char **argv) {
  random_state random = random_seed(15);
  if (argc > 1) {
    read_claims(argv[1]);
  }
  for (unsigned i = 0; i < BODIES && failures < 10; i++) {
    const int32_t size = INT32_C(1) << (7 + random_below(&random, 14));
    const gjk_pose still = GJK_POSE_IDENTITY;
    make_shapes(&random, size);
    make_compound(&random, size);
    make_surface(&random, size, i % 4 == 3);
    body = i % 4 < 2 ? chair : body;
    body.pose.position = random_vector(&random, 10 * size);
    chair.pose.position = body.pose.position;
    turn(&random, &body.pose.rotation);
    for (unsigned k = 0; k < VISITORS; k++) {
      const gjk_vec3 off = random_vector(&random, 3 * size);
      const int32_t middle = body.data == &compound ? 0 : SIDE * size / 2;
      gjk_pose pose = still;
      gjk_parts_room room;
      gjk_collider part;
      expect(gjk_parts_place(&body, random_below(&random, gjk_parts_count(&body)), &room, &part) == GJK_OK, "part");
      pose.position.x = middle > 0 ? part.centre.x + off.x / 3 : body.pose.position.x + off.x;
      pose.position.y = middle > 0 ? part.centre.y + off.y / 3 : body.pose.position.y + off.y;
      pose.position.z = middle > 0 ? part.centre.z + off.z / 3 : body.pose.position.z + off.z;
      turn(&random, &pose.rotation);
      expect(gjk_collider_init(&visitor, &shapes[random_below(&random, 6)], NULL, 0) == GJK_OK &&
                 gjk_collider_pose(&visitor, &pose) == GJK_OK,
             "visitor");
      question++;
      ask_all(&random, size);
    }
  }
  return failures > 0;
}
