// Makes the families of pairs that costs are measured on.
#define _POSIX_C_SOURCE 200112L
#include "families.h"

#include "../measuring.h"
#include "case/case.h"
#include "generate/generate.h"
#include "generate/polytope.h"
#include "random.h"

const cost_family cost_families[] = {
    // name, query, A, B, vertices of their hulls, gap
    {"distance: boxes apart", COST_DISTANCE, COST_BOX, COST_BOX, 0, COST_APART},
    {"distance: 8-point hulls apart", COST_DISTANCE, COST_HULL, COST_HULL, 8, COST_APART},
    {"distance: 8-point hulls close", COST_DISTANCE, COST_HULL, COST_HULL, 8, COST_CLOSE},
    {"distance: 64-point hulls apart", COST_DISTANCE, COST_HULL, COST_HULL, 64, COST_APART},
    {"distance: 64-point hulls close", COST_DISTANCE, COST_HULL, COST_HULL, 64, COST_CLOSE},
    {"distance: 256-point hulls apart", COST_DISTANCE, COST_HULL, COST_HULL, 256, COST_APART},
    {"distance: capsules apart", COST_DISTANCE, COST_CAPSULE, COST_CAPSULE, 0, COST_APART},
    {"distance: sphere to 8-point hull", COST_DISTANCE, COST_SPHERE, COST_HULL, 8, COST_APART},
    {"intersect: boxes close", COST_INTERSECT, COST_BOX, COST_BOX, 0, COST_EITHER_SIDE},
    {"intersect: 8-point hulls close", COST_INTERSECT, COST_HULL, COST_HULL, 8, COST_EITHER_SIDE},
    {"intersect: 64-point hulls close", COST_INTERSECT, COST_HULL, COST_HULL, 64, COST_EITHER_SIDE},
    {"depth: boxes", COST_DEPTH, COST_BOX, COST_BOX, 0, COST_OVERLAPPING},
    {"depth: 8-point hulls", COST_DEPTH, COST_HULL, COST_HULL, 8, COST_OVERLAPPING},
    {"depth: 32-point hulls", COST_DEPTH, COST_HULL, COST_HULL, 32, COST_OVERLAPPING},
    {"depth: 64-point hulls", COST_DEPTH, COST_HULL, COST_HULL, 64, COST_OVERLAPPING},
    {"contacts: boxes", COST_CONTACTS, COST_BOX, COST_BOX, 0, COST_OVERLAPPING},
    {"contacts: boxes flush", COST_CONTACTS, COST_BOX, COST_BOX, 0, COST_FLUSH},
    {"contacts: boxes turned", COST_CONTACTS, COST_BOX, COST_BOX, 0, COST_TURNED},
    {"contacts: boxes yawed", COST_CONTACTS, COST_BOX, COST_BOX, 0, COST_YAWED},
    {"contacts: boxes lifted", COST_CONTACTS, COST_BOX, COST_BOX, 0, COST_LIFTED},
    {"contacts: boxes level", COST_CONTACTS, COST_BOX, COST_BOX, 0, COST_LEVEL},
    {"contacts: sphere on level box", COST_CONTACTS, COST_BOX, COST_SPHERE, 0, COST_LEVEL},
    {"contacts: capsule on level box", COST_CONTACTS, COST_BOX, COST_CAPSULE, 0, COST_LEVEL},
    {"contacts: sphere and box", COST_CONTACTS, COST_SPHERE, COST_BOX, 0, COST_OVERLAPPING},
    {"contacts: capsules", COST_CONTACTS, COST_CAPSULE, COST_CAPSULE, 0, COST_OVERLAPPING},
    {"posing: box", COST_POSE, COST_BOX, COST_BOX, 0, COST_APART},
    {"posing: 8-point hull", COST_POSE, COST_HULL, COST_HULL, 8, COST_APART},
    {"posing: 64-point hull", COST_POSE, COST_HULL, COST_HULL, 64, COST_APART},
    {"posing: 256-point hull", COST_POSE, COST_HULL, COST_HULL, 256, COST_APART},
};
const size_t cost_family_count = sizeof cost_families / sizeof cost_families[0];

// Cells enough for the depths of these families.
#define CELLS GJK_EPA_CELLS(1024)

#define REACH GJK_Q16(3.0)  // a pair's positions lie within this, along each axis
#define CLOSE GJK_Q16(0.1)  // closer is close
#define FARTHEST GJK_Q16(2.0)
#define STEP_PARTS 100  // one step moves B by its size over this, and turns it by up to a degree

static gjk_vec3 random_vector(random_state *random, int32_t size) {
  const gjk_vec3 v = {random_range(random, -size, size), random_range(random, -size, size),
                      random_range(random, -size, size)};
  return v;
}

static gjk_quat random_rotation(random_state *random, int32_t xyz, int32_t least_w) {
  const gjk_quat q = {random_range(random, -xyz, xyz), random_range(random, -xyz, xyz), random_range(random, -xyz, xyz),
                      random_range(random, least_w, 1001)};
  gjk_quat unit = {0, 0, 0, GJK_Q30_ONE};
  gjk_quat_normalize(&q, &unit);
  return unit;
}

static void make_vertices(random_state *random, unsigned count, case_shape *out) {
  case_shape_set_count(out, count);
  for (unsigned i = 0; i < count; i++) {
    out->vertices[i] = generate_vector(random, (0.8 + 0.2 * generate_unit(random)) * GJK_Q16_ONE);
  }
}

static void make_shape(random_state *random, cost_kind kind, unsigned vertices, case_shape *out) {
  static const case_kind kinds[] = {
      [COST_BOX] = CASE_BOX, [COST_HULL] = CASE_HULL, [COST_CAPSULE] = CASE_SEGMENT, [COST_SPHERE] = CASE_POINT};
  case_shape_reset(out);
  out->kind = kinds[kind];
  if (kind == COST_BOX) {
    out->size.x = random_range(random, GJK_Q16(0.2), GJK_Q16(1.0));
    out->size.y = random_range(random, GJK_Q16(0.2), GJK_Q16(1.0));
  }
  if (kind == COST_BOX || kind == COST_CAPSULE) {
    out->size.z = random_range(random, GJK_Q16(0.2), GJK_Q16(1.0));
  }
  if (kind == COST_HULL) {
    make_vertices(random, vertices, out);
  }
  if (kind == COST_CAPSULE || kind == COST_SPHERE) {
    out->convex_radius = random_range(random, GJK_Q16(0.1), GJK_Q16(0.5));
  }
  out->pose.rotation = random_rotation(random, 1000, -1000);
  out->pose.position = random_vector(random, REACH);
}

static void fail(gjk_status status) {
  fprintf(stderr, "cost: a pair cannot be made: %s\n", gjk_status_name(status));
  exit(1);
}

// The distance, or minus the depth.
static gjk_q16 signed_distance(const case_pair *pair) {
  static gjk_epa_cell cells[CELLS];
  static const gjk_workspace workspace = {cells, CELLS};
  static case_collider a, b;
  gjk_distance_result gap;
  gjk_status status = case_collider_build(&a, &pair->a, false);
  status = status == GJK_OK ? case_collider_build(&b, &pair->b, false) : status;
  status = status == GJK_OK ? gjk_signed_distance(&a.collider, &b.collider, NULL, &workspace, &gap) : status;
  if (status != GJK_OK) {
    fail(status);
  }
  return gap.intersecting && gap.distance == 0 ? -1 : gap.distance;
}

static bool is_in_family(cost_gap gap, size_t index, gjk_q16 distance) {
  switch (gap) {
    case COST_APART: return distance >= CLOSE && distance <= FARTHEST;
    case COST_CLOSE: return distance > 0 && distance < CLOSE;
    case COST_EITHER_SIDE: return index % 2 == 0 ? distance > 0 && distance < CLOSE : distance < 0 && distance > -CLOSE;
    case COST_OVERLAPPING: return distance < 0;
    case COST_LIFTED: return distance > 0 && distance <= GJK_Q16(0.02);
    case COST_FLUSH:
    case COST_TURNED:
    case COST_YAWED:
    case COST_LEVEL: return distance < 0 && distance > -CLOSE;
  }
  return 0;
}

// Where B was one step ago.
static void step_back(random_state *random, case_shape *b) {
  const gjk_vec3 by = generate_vector(random, GJK_Q16(1.0) / STEP_PARTS);
  const gjk_quat turn = random_rotation(random, 5, 1000);
  b->pose.position.x += by.x;
  b->pose.position.y += by.y;
  b->pose.position.z += by.z;
  gjk_quat_compose(&b->pose.rotation, &turn, &b->pose.rotation);
  gjk_quat_normalize(&b->pose.rotation, &b->pose.rotation);
}

static void set_vector(gjk_vec3 v, double out[3]) {
  out[0] = (double)v.x / COST_LSB_PER_UNIT;
  out[1] = (double)v.y / COST_LSB_PER_UNIT;
  out[2] = (double)v.z / COST_LSB_PER_UNIT;
}

static void set_place(const gjk_pose *pose, cost_place *out) {
  const gjk_quat q = pose->rotation;
  set_vector(pose->position, out->position);
  out->rotation[0] = (double)q.x / GJK_Q30_ONE;
  out->rotation[1] = (double)q.y / GJK_Q30_ONE;
  out->rotation[2] = (double)q.z / GJK_Q30_ONE;
  out->rotation[3] = (double)q.w / GJK_Q30_ONE;
}

static void set_solid(const case_shape *shape, const case_shape *before, cost_kind kind, cost_solid *out) {
  out->kind = kind;
  set_vector(shape->size, out->half);
  out->radius = (double)shape->convex_radius / COST_LSB_PER_UNIT;
  out->count = shape->count;
  out->vertices = shape->count > 0 ? measuring_allocate(shape->count, sizeof *out->vertices) : NULL;
  for (size_t i = 0; i < shape->count; i++) {
    set_vector(shape->vertices[i], out->vertices[i]);
  }
  set_place(&shape->pose, &out->at);
  set_place(&before->pose, &out->before);
}

// Puts B on the top of A, a box.
static void rest_on(random_state *random, cost_gap gap, case_shape *a, case_shape *b) {
  static const gjk_vec3 up = {0, 0, GJK_Q16_ONE}, aside = {GJK_Q16_ONE, 0, 0};
  const int32_t apart =
      gap == COST_LIFTED ? random_range(random, 200, GJK_Q16(0.01)) : -random_range(random, 2, GJK_Q16(0.002));
  gjk_pose on = GJK_POSE_IDENTITY, yaw = GJK_POSE_IDENTITY;
  on.position.x = random_range(random, -a->size.x / 2, a->size.x / 2);
  on.position.y = random_range(random, -a->size.y / 2, a->size.y / 2);
  on.position.z = a->size.z + (b->convex_radius > 0 ? b->convex_radius : b->size.z) + apart;
  if (gap == COST_LEVEL) {
    const gjk_pose level = GJK_POSE_IDENTITY;
    a->pose.rotation = level.rotation;
  } else if (gap != COST_FLUSH) {
    on.rotation = random_rotation(random, 1, 1000);
  }
  if (gap == COST_YAWED || gap == COST_LEVEL) {
    (void)gjk_quat_from_axis_angle(&up, random_range(random, 0, GJK_ANGLE(6.28)), &yaw.rotation);
  }
  if (b->kind == CASE_SEGMENT) {
    gjk_pose lying = GJK_POSE_IDENTITY;
    (void)gjk_quat_from_axis_angle(&aside, GJK_ANGLE(1.5707963), &lying.rotation);
    (void)gjk_quat_compose(&yaw.rotation, &lying.rotation, &yaw.rotation);
  }
  if (gjk_pose_compose(&on, &yaw, &on) != GJK_OK || gjk_pose_compose(&a->pose, &on, &b->pose) != GJK_OK) {
    fail(GJK_ERROR_RANGE);
  }
}

static void make_pair(const cost_family *family, random_state *random, size_t index, cost_pair *out) {
  out->shapes = measuring_allocate(1, sizeof *out->shapes);
  out->before = measuring_allocate(1, sizeof *out->before);
  do {
    make_shape(random, family->a, family->vertices, &out->shapes->a);
    make_shape(random, family->b, family->vertices, &out->shapes->b);
    if (family->gap >= COST_FLUSH) {
      rest_on(random, family->gap, &out->shapes->a, &out->shapes->b);
    }
  } while (!is_in_family(family->gap, index, signed_distance(out->shapes)));
  case_shape_copy(&out->before->a, &out->shapes->a);
  case_shape_copy(&out->before->b, &out->shapes->b);
  step_back(random, &out->before->b);
  set_solid(&out->shapes->a, &out->before->a, family->a, &out->solid[0]);
  set_solid(&out->shapes->b, &out->before->b, family->b, &out->solid[1]);
}

cost_pair *cost_pairs_make(const cost_family *family, uint64_t seed, size_t count) {
  cost_pair *pairs = measuring_allocate(count, sizeof *pairs);
  for (size_t i = 0; i < count; i++) {
    random_state random = random_seed((seed << 32) + i);
    make_pair(family, &random, i, &pairs[i]);
  }
  return pairs;
}

void cost_pairs_free(cost_pair *pairs, size_t count) {
  for (size_t i = 0; i < count; i++) {
    case_pair_free(pairs[i].shapes);
    case_pair_free(pairs[i].before);
    free(pairs[i].shapes);
    free(pairs[i].before);
    free(pairs[i].solid[0].vertices);
    free(pairs[i].solid[1].vertices);
  }
  free(pairs);
}
