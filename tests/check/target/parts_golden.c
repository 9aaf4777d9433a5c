// The fixed set of queries of bodies of many parts and of surfaces and its hash, without libc and with little RAM.
#include "parts_golden.h"

#include "gjk/gjk.h"
#include "golden_mix.h"

#define PARTS 12
#define SIDE 5
#define VERTICES 8
#define CELLS 40
#define FOUND 3

static gjk_vec3 hulls[4][VERTICES], corners[(SIDE + 1) * (SIDE + 1)];
static gjk_shape shapes[4];
static gjk_compound_part parts[PARTS];
static gjk_compound_node nodes[GJK_COMPOUND_NODES(PARTS)];
static gjk_compound compound;
static gjk_mesh_triangle triangles[2 * SIDE * SIDE];
static gjk_mesh_node mesh_nodes[GJK_MESH_NODES(2 * SIDE * SIDE)];
static gjk_mesh mesh;
static int16_t heights[(SIDE + 1) * (SIDE + 1)];
static gjk_height_field field;
static gjk_parts body, other;
static gjk_shape visitor_shape;
static gjk_vec3 visitor_vertices[VERTICES];
static gjk_collider visitor;
static gjk_epa_cell cells[CELLS];

static void mix_decision(gjk_status status, uint32_t part, const gjk_decision *out) {
  mix((uint32_t)status);
  if (status == GJK_OK) {
    mix(part);
    mix((uint32_t)out->yes);
  }
}

static void mix_distance(gjk_status status, uint32_t part, const gjk_distance_result *out) {
  mix((uint32_t)status);
  if (status != GJK_OK && status != GJK_ERROR_ITERATION_LIMIT) {
    return;
  }
  mix(part);
  mix((uint32_t)out->distance);
  mix((uint32_t)out->lower);
  mix((uint32_t)out->intersecting);
  if (!out->intersecting) {
    mix_vector(&out->point_a);
    mix_vector(&out->point_b);
    mix_unit(&out->normal);
  }
}

static void mix_depth(gjk_status status, uint32_t part, const gjk_penetration_result *out) {
  mix((uint32_t)status);
  if (status != GJK_OK && status != GJK_ERROR_CAPACITY) {
    return;
  }
  mix(part);
  mix((uint32_t)out->intersecting);
  if (out->intersecting) {
    mix((uint32_t)out->depth);
    mix((uint32_t)out->lower);
    mix_vector(&out->point_a);
    mix_vector(&out->point_b);
    mix_unit(&out->normal);
  }
}

static void mix_manifold(uint32_t part, const gjk_manifold *m) {
  mix(part);
  mix(m->count);
  mix_unit(&m->normal);
  mix_contacts_of(m);
}

static void mix_cast(gjk_status status, uint32_t part, const gjk_cast_result *out) {
  mix((uint32_t)status);
  if (status != GJK_OK && status != GJK_ERROR_ITERATION_LIMIT) {
    return;
  }
  mix(part);
  mix((uint32_t)out->hit);
  if (status == GJK_OK && out->hit) {
    mix((uint32_t)out->inside);
    mix((uint32_t)out->fraction);
    mix_unit(&out->normal);
    mix_vector(&out->rest_a);
    mix_vector(&out->rest_b);
  }
}

static void mix_impact(gjk_status status, uint32_t part, const gjk_impact_result *out) {
  mix((uint32_t)status);
  if (status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT) {
    mix(part);
    mix((uint32_t)out->hit);
    mix((uint32_t)out->overlap);
    mix((uint32_t)out->lower);
    mix((uint32_t)out->upper);
  }
}

// Every third is not turned.
static void turn(random_state *random, gjk_quat *out) {
  const gjk_quat q = {random_range(random, -1000, 1000), random_range(random, -1000, 1000),
                      random_range(random, -1000, 1000), random_range(random, 1, 1000)};
  if (random_below(random, 3) != 0) {
    mix((uint32_t)gjk_quat_normalize(&q, out));
  }
}

// A shape of one of seven kinds, of about that size; every fourth has a convex radius.
static void make_shape(random_state *random, int32_t size, gjk_vec3 *vertices, gjk_shape *out) {
  static const gjk_shape kinds[] = {
      GJK_POINT,      GJK_SEGMENT(0),     GJK_BOX(0, 0, 0), GJK_BOX(0, 0, 0),       GJK_BOX(0, 0, 0),
      GJK_HULL(0, 0), GJK_CYLINDER(0, 0), GJK_CONE(0, 0),   GJK_ELLIPSOID(0, 0, 0),
  };
  *out = kinds[random_below(random, sizeof kinds / sizeof kinds[0])];
  out->size.x = random_range(random, 1, size);
  out->size.y = random_range(random, 1, size);
  out->size.z = random_range(random, 1, size);
  out->vertices = vertices;
  out->count = VERTICES;
  for (unsigned i = 0; i < VERTICES; i++) {
    vertices[i] = random_in_cube(random, size);
  }
  out->convex_radius = random_below(random, 4) == 0 ? random_range(random, 0, size / 2) : 0;
}

// Every third compound is a row of equal parts: ties.
static void make_compound(random_state *random, int32_t size) {
  static const gjk_pose still = GJK_POSE_IDENTITY;
  const uint16_t count = (uint16_t)(1 + random_below(random, PARTS));
  const bool row = random_below(random, 3) == 0;
  for (unsigned i = 0; i < 4; i++) {
    make_shape(random, size / 3 + 1, hulls[i], &shapes[i]);
  }
  for (unsigned i = 0; i < count; i++) {
    parts[i].shape = &shapes[row ? 0 : random_below(random, 4)];
    parts[i].pose = still;
    if (row) {
      parts[i].pose.position.x = (int32_t)i * 2 * shapes[0].size.x;
    } else {
      parts[i].pose.position = random_in_cube(random, size);
      turn(random, &parts[i].pose.rotation);
    }
  }
  mix((uint32_t)gjk_compound_build(parts, count, nodes, sizeof nodes / sizeof nodes[0], &compound));
  const gjk_parts made = GJK_PARTS_OF_COMPOUND(&compound);
  body = made;
}

// Heights of ground that is level, gentle or rough.
static int32_t height_of(random_state *random, unsigned kind, unsigned i, unsigned j) {
  return kind == 0 ? 0 : kind == 1 ? (int32_t)(i * i + 3 * j) : random_range(random, -20, 20);
}

static void make_mesh(random_state *random, int32_t size) {
  const unsigned kind = random_below(random, 3);
  const int32_t step = size / SIDE + 1, rise = step / 32 + 1;
  uint32_t count = 0;
  for (unsigned j = 0; j <= SIDE; j++) {
    for (unsigned i = 0; i <= SIDE; i++) {
      gjk_vec3 *v = &corners[j * (SIDE + 1) + i];
      v->x = (int32_t)i * step;
      v->y = (int32_t)j * step;
      v->z = height_of(random, kind, i, j) * rise;
    }
  }
  for (uint32_t k = 0; k < (uint32_t)SIDE * SIDE; k++) {
    const uint32_t a = k / SIDE * (SIDE + 1) + k % SIDE, b = a + 1, c = a + SIDE + 2, d = a + SIDE + 1;
    const gjk_mesh_triangle first = {{a, b, c}}, second = {{a, c, d}};
    triangles[count++] = first;
    triangles[count++] = random_below(random, 8) == 0 ? first : second;  // some twice
  }
  mix((uint32_t)gjk_mesh_build(corners, (SIDE + 1) * (SIDE + 1), triangles, count, random_below(random, 3) == 0,
                               mesh_nodes, sizeof mesh_nodes / sizeof mesh_nodes[0], &mesh));
  for (uint32_t i = 0; i < count; i++) {
    mix(triangles[i].corner[0]);
    mix(triangles[i].corner[1]);
    mix(triangles[i].corner[2]);
  }
  const gjk_parts made = GJK_PARTS_OF_MESH(&mesh);
  body = made;
}

static void make_field(random_state *random, int32_t size) {
  const unsigned kind = random_below(random, 3);
  const int32_t step = size / SIDE + 1;
  const gjk_height_field made =
      GJK_HEIGHT_FIELD(heights, SIDE + 1, SIDE + 1, step, step, (step < 100000 ? step : 100000) / 32 + 1);
  field = made;
  for (unsigned k = 0; k < (SIDE + 1) * (SIDE + 1); k++) {
    const int32_t height = height_of(random, kind, k % (SIDE + 1), k / (SIDE + 1));
    heights[k] = (int16_t)(random_below(random, 20) == 0 ? GJK_HEIGHT_HOLE : height);
  }
  mix((uint32_t)gjk_height_field_check(&field));
  const gjk_parts of = GJK_PARTS_OF_HEIGHT_FIELD(&field);
  body = of;
}

// Makes the other body the compound, where it is not the body itself and has few parts.
static bool set_other(random_state *random) {
  const gjk_parts made = GJK_PARTS_OF_COMPOUND(&compound);
  if (body.data == &compound || compound.count == 0 || compound.count > 4) {
    return false;
  }
  other = made;
  other.pose.position = body.pose.position;
  turn(random, &other.pose.rotation);
  return true;
}

// The last small compound as A against the body as B.
static void query_both(random_state *random, int32_t size) {
  const gjk_workspace workspace = {cells, random_below(random, CELLS + 1)};
  gjk_parts_pair pair = {0, 0};
  gjk_decision decision;
  gjk_distance_result distance;
  gjk_penetration_result depth;
  if (!set_other(random)) {
    return;
  }
  gjk_status status = gjk_parts_both_within(&other, &body, size / 8, &pair, &decision);
  mix_decision(status, pair.a ^ pair.b << 16, &decision);
  status = gjk_parts_both_distance(&other, &body, &pair, &distance);
  mix_distance(status, pair.a ^ pair.b << 16, &distance);
  status = gjk_parts_both_penetration(&other, &body, &workspace, &pair, &depth);
  mix_depth(status, pair.a ^ pair.b << 16, &depth);
}

static void query_still(random_state *random, int32_t size) {
  const gjk_workspace workspace = {cells, random_below(random, CELLS + 1)};
  gjk_decision decision;
  gjk_distance_result distance;
  gjk_penetration_result depth;
  uint32_t part = 0;
  gjk_status status = gjk_parts_intersect(&body, &visitor, &part, &decision);
  mix_decision(status, part, &decision);
  status = gjk_parts_within(&body, &visitor, size / 8, &part, &decision);
  mix_decision(status, part, &decision);
  status = gjk_parts_distance(&body, &visitor, &part, &distance);
  mix_distance(status, part, &distance);
  status = gjk_parts_penetration(&body, &visitor, &workspace, &part, &depth);
  mix_depth(status, part, &depth);
  query_both(random, size);
}

static void query_contacts(random_state *random, int32_t size) {
  static gjk_parts_manifold of_parts[FOUND];
  static gjk_surface_contact of_surface[FOUND];
  static gjk_manifold together[FOUND];
  const gjk_workspace workspace = {cells, random_below(random, CELLS + 1)};
  uint32_t count = 0;
  uint16_t few = 0;
  unsigned groups = 0;
  mix((uint32_t)gjk_parts_contacts(&body, &visitor, size / 32, 4, &workspace, of_parts, FOUND, &count));
  mix(count);
  for (unsigned i = 0; i < count && i < FOUND; i++) {
    mix_manifold(of_parts[i].part, &of_parts[i].manifold);
  }
  mix((uint32_t)gjk_parts_manifolds(&body, &visitor, size / 32, 4, &workspace, together, FOUND, &groups));
  for (unsigned i = 0; i < groups; i++) {
    mix_manifold(i, &together[i]);
  }
  mix((uint32_t)gjk_surface_contacts(&body, &visitor, size / 32, 4, &workspace, of_surface, FOUND, &few));
  mix(few);
  for (unsigned i = 0; i < few; i++) {
    mix_manifold(of_surface[i].triangle, &of_surface[i].manifold);
  }
}

static void query_motion(random_state *random, int32_t size) {
  static const gjk_motion rest = {.from = GJK_POSE_IDENTITY, .to = GJK_POSE_IDENTITY};
  const gjk_vec3 to = random_in_cube(random, 3 * size), to_a = random_in_cube(random, size);
  const bool moves = random_below(random, 2) == 0, wide = random_below(random, 2) == 0;
  const gjk_cast_path path = {moves ? &to_a : NULL, &to, wide ? size / 16 : 0};
  gjk_motion motion[2] = {rest, rest};
  gjk_cast_result cast;
  gjk_impact_result impact;
  uint32_t part = 0;
  gjk_parts_pair pair = {0, 0};
  gjk_status status = gjk_parts_cast(&body, &visitor, &path, &part, &cast);
  mix_cast(status, part, &cast);
  status = gjk_parts_cast_ray(&body, &visitor.position, &to, &part, &cast);
  mix_cast(status, part, &cast);
  if (set_other(random)) {
    status = gjk_parts_both_cast(&other, &body, &path, &pair, &cast);
    mix_cast(status, pair.a ^ pair.b << 16, &cast);
  }
  if (random_below(random, 4) == 0) {
    const gjk_impact_setup setup = {0, GJK_PARTS_TOLERANCE_MIN + 64 + size / 1024, (uint8_t)random_below(random, 12)};
    motion[0].from = body.pose;
    motion[0].to = body.pose;
    turn(random, &motion[0].to.rotation);
    motion[1].from.position = visitor.position;
    motion[1].to.position = to;
    turn(random, &motion[1].to.rotation);
    status = gjk_parts_time_of_impact(&body, &motion[0], &visitor, &motion[1], &setup, &part, &impact);
    mix_impact(status, part, &impact);
  }
}

// What is asked of a body and of a visitor near it.
typedef void query_visitor(random_state *random, int32_t size);

static void query_body(random_state *random, query_visitor *query) {
  static const gjk_pose still = GJK_POSE_IDENTITY;
  const int32_t size = INT32_C(1) << (6 + random_below(random, 20));
  const unsigned kind = random_below(random, 3);
  gjk_pose pose = still;
  if (kind == 0) {
    make_compound(random, size);
  } else if (kind == 1) {
    make_mesh(random, size);
  } else {
    make_field(random, size);
  }
  body.pose.position = random_in_cube(random, random_below(random, 4) == 0 ? INT32_C(1) << 30 : size);
  turn(random, &body.pose.rotation);
  make_shape(random, size / 4 + 1, visitor_vertices, &visitor_shape);
  mix((uint32_t)gjk_collider_init(&visitor, &visitor_shape, NULL, 0));
  for (unsigned k = 0; k < 3; k++) {
    const gjk_vec3 off = random_in_cube(random, size);
    pose.position.x = body.pose.position.x + off.x;
    pose.position.y = body.pose.position.y + off.y;
    pose.position.z = body.pose.position.z + off.z / (k == 0 ? 1 : 8);
    turn(random, &pose.rotation);
    mix((uint32_t)gjk_collider_pose(&visitor, &pose));
    query(random, size);
  }
}

static uint64_t hash_of(uint32_t bodies, query_visitor *query) {
  random_state random = random_seed(2029);
  hash = FNV_START;
  compound.count = 0;
  for (uint32_t i = 0; i < bodies; i++) {
    query_body(&random, query);
  }
  return hash;
}

uint64_t parts_golden_hash(uint32_t bodies) {
  return hash_of(bodies, query_still);
}

uint64_t parts_contacts_golden_hash(uint32_t bodies) {
  return hash_of(bodies, query_contacts);
}

uint64_t parts_motion_golden_hash(uint32_t bodies) {
  return hash_of(bodies, query_motion);
}
