// Bodies of many parts on hostile data: compounds, meshes and height fields that were damaged after they were built, and
// some that were not. Queries must end, read nothing outside of the arrays, and return a status that they may return. Of a
// body that is sound, the nearest part must be that of a search of all.
#include <stdlib.h>
#include <string.h>

#include "hostile.h"
#include "parts_answers.h"

#define SHAPES 3
#define PARTS_MOST 12
#define TRIANGLES_MOST 40
#define VERTICES_MOST 24
#define SIDE_MOST 6
#define CELLS 64
#define MANIFOLDS 4

static fuzz_bytes bytes;

// A body with its arrays, each on the heap and as long as the body says, so that a sanitizer sees what is read beyond.
typedef struct body {
  gjk_parts parts;
  hostile_shape shape[SHAPES];
  gjk_compound compound;
  gjk_mesh mesh;
  gjk_height_field field;
  gjk_compound_part *part;
  gjk_compound_node *tree;
  gjk_vec3 *vertices;
  gjk_mesh_triangle *triangles;
  gjk_mesh_node *nodes;
  int16_t *heights;
  bool is_sound;
} body;

static body bodies[2];
static gjk_epa_cell cells[CELLS];

static uint32_t below(uint32_t most) {
  return fuzz_u8(&bytes) % most;
}

static gjk_pose any_pose(unsigned shift) {
  gjk_pose pose;
  pose.position = hostile_vec3(&bytes, shift);
  pose.rotation = hostile_quat(&bytes);
  return pose;
}

// Changes some bytes. Nothing there is a pointer or a truth value.
static void damage(void *block, size_t size) {
  const unsigned changes = below(4);
  for (unsigned i = 0; i < changes; i++) {
    const size_t at = (size_t)(fuzz_u8(&bytes) | (unsigned)fuzz_u8(&bytes) << 8) % size;
    ((uint8_t *)block)[at] = fuzz_u8(&bytes);
  }
}

static void make_compound(body *b, bool damaged) {
  const uint16_t count = (uint16_t)(1 + below(PARTS_MOST));
  const uint32_t nodes = GJK_COMPOUND_NODES((uint32_t)count);
  const unsigned shift = 4 + below(28);
  b->part = malloc(count * sizeof *b->part);
  b->tree = calloc(nodes, sizeof *b->tree);
  for (unsigned i = 0; i < SHAPES; i++) {
    hostile_make_shape(&bytes, &b->shape[i]);
  }
  for (unsigned i = 0; i < count; i++) {
    b->part[i].shape = &b->shape[below(SHAPES)].shape;
    b->part[i].pose = any_pose(shift);
  }
  memset(&b->compound, HOSTILE_POISON, sizeof b->compound);
  const gjk_status status = gjk_compound_build(MAYBE(b->part), count, MAYBE(b->tree),
                                               hostile_leaves_out(&bytes) ? nodes - 1 : nodes, &b->compound);
  hostile_check(status, status == GJK_ERROR_CAPACITY ? NULL : &b->compound, sizeof b->compound);
  b->is_sound = status == GJK_OK && !damaged;
  if (status != GJK_OK) {
    const gjk_compound forged = {b->part, b->tree, (uint32_t)fuzz_i32(&bytes), count, (uint16_t)nodes};
    b->compound = forged;
  }
  if (damaged) {
    damage(b->tree, nodes * sizeof *b->tree);
    b->part[below(count)].pose = any_pose(shift);
    b->compound.reach >>= below(33) % 32;
    b->compound.count = (uint16_t)(b->compound.count - below(b->compound.count));
    b->compound.node_count = (uint16_t)(b->compound.node_count - below(3) % b->compound.node_count);
  }
  const gjk_parts parts = GJK_PARTS_OF_COMPOUND(&b->compound);
  b->parts = parts;
}

static void check_mesh(body *b, bool built) {
  gjk_mesh_report report;
  memset(&report, HOSTILE_POISON, sizeof report);
  const gjk_status status = gjk_mesh_check(&b->mesh, &report);
  hostile_check(status, &report, sizeof report);
  const bool is_right = status == GJK_OK && (report.fault == GJK_MESH_SOUND || report.fault >= GJK_MESH_DEGENERATE);
  if (built && !is_right) {
    fuzz_fail("a mesh as it was built has a fault");
  }
  b->is_sound = is_right;
}

static void make_mesh(body *b, bool damaged) {
  const uint32_t vertices = 1 + below(VERTICES_MOST), triangles = 1 + below(TRIANGLES_MOST);
  const uint32_t nodes = GJK_MESH_NODES(triangles);
  const unsigned shift = below(32);
  b->vertices = malloc(vertices * sizeof *b->vertices);
  b->triangles = malloc(triangles * sizeof *b->triangles);
  b->nodes = calloc(nodes, sizeof *b->nodes);
  for (uint32_t i = 0; i < vertices; i++) {
    b->vertices[i] = hostile_vec3(&bytes, shift);
  }
  for (uint32_t i = 0; i < triangles; i++) {
    for (unsigned k = 0; k < 3; k++) {
      b->triangles[i].corner[k] = fuzz_u8(&bytes) % (hostile_leaves_out(&bytes) ? vertices + 1 : vertices);
    }
  }
  memset(&b->mesh, HOSTILE_POISON, sizeof b->mesh);
  const bool two_sided = below(2) == 0;
  const gjk_status status = gjk_mesh_build(MAYBE(b->vertices), vertices, MAYBE(b->triangles), triangles, two_sided,
                                           MAYBE(b->nodes), hostile_leaves_out(&bytes) ? nodes - 1 : nodes, &b->mesh);
  hostile_check(status, status == GJK_ERROR_CAPACITY ? NULL : &b->mesh, sizeof b->mesh);
  if (status != GJK_OK) {
    const gjk_mesh forged = {
        b->vertices, b->triangles,      b->nodes,          vertices,
        triangles,   fuzz_vec3(&bytes), fuzz_vec3(&bytes), {fuzz_u8(&bytes), fuzz_u8(&bytes), fuzz_u8(&bytes)},
        two_sided};
    b->mesh = forged;
  }
  if (damaged) {
    damage(b->vertices, vertices * sizeof *b->vertices);
    damage(b->triangles, triangles * sizeof *b->triangles);
    damage(b->nodes, nodes * sizeof *b->nodes);
    damage(&b->mesh.lower, sizeof b->mesh.lower);
    damage(&b->mesh.upper, sizeof b->mesh.upper);
    damage(b->mesh.shift, sizeof b->mesh.shift);
    b->mesh.triangle_count -= below(3) % triangles;
    b->mesh.vertex_count -= below(3) % vertices;
  }
  check_mesh(b, status == GJK_OK && !damaged);
  const gjk_parts parts = GJK_PARTS_OF_MESH(&b->mesh);
  b->parts = parts;
}

static void make_field(body *b) {
  const uint32_t columns = 1 + below(SIDE_MOST), rows = 1 + below(SIDE_MOST), count = columns * rows;
  b->heights = malloc(count * sizeof *b->heights);
  for (uint32_t i = 0; i < count; i++) {
    b->heights[i] = hostile_leaves_out(&bytes) || below(4) == 0 ? GJK_HEIGHT_HOLE
                                                                : (int16_t)(fuzz_u8(&bytes) << 8 | fuzz_u8(&bytes));
  }
  const gjk_height_field field = {MAYBE(b->heights),
                                  (uint16_t)columns,
                                  (uint16_t)rows,
                                  fuzz_i32(&bytes) >> below(32),
                                  fuzz_i32(&bytes) >> below(32),
                                  fuzz_i32(&bytes) >> below(32)};
  b->field = field;
  const gjk_status status = gjk_height_field_check(MAYBE(&b->field));
  hostile_check(status, NULL, 0);
  b->is_sound = status == GJK_OK;
  const gjk_parts parts = GJK_PARTS_OF_HEIGHT_FIELD(&b->field);
  b->parts = parts;
}

static void make_body(body *b) {
  const unsigned kind = below(8);
  const bool damaged = below(4) != 0;
  memset(b, 0, sizeof *b);
  if (kind < 3) {
    make_compound(b, damaged);
  } else if (kind < 6) {
    make_mesh(b, damaged);
  } else {
    make_field(b);
  }
  b->parts.pose = any_pose(below(32));
  if (hostile_leaves_out(&bytes)) {
    b->parts.data = NULL;
  }
}

static void free_body(body *b) {
  free(b->part);
  free(b->tree);
  free(b->vertices);
  free(b->triangles);
  free(b->nodes);
  free(b->heights);
}

// Is the answer that of the part it names, and is no other part nearer? Parts at holes do not count.
static void check_nearest(const body *a, const gjk_collider *b, uint32_t part, const gjk_distance_result *found) {
  const uint32_t count = gjk_parts_count(&a->parts);
  for (uint32_t i = 0; i < count; i++) {
    gjk_parts_room room;
    gjk_collider c;
    gjk_distance_result own;
    const gjk_status placed = gjk_parts_place(&a->parts, i, &room, &c);
    const gjk_status status = placed == GJK_OK ? gjk_distance(&c, b, NULL, &own) : placed;
    if (i == part && (status != GJK_OK || !same_distance(&own, found))) {
      fuzz_fail("an answer is not that of its part");
    }
    if (status == GJK_OK && (found->intersecting ? own.intersecting && i < part
                                                 : own.intersecting || own.distance < found->distance ||
                                                       (own.distance == found->distance && i < part))) {
      fuzz_fail("another part is nearer");
    }
  }
}

static void ask_distance(const body *a, const gjk_collider *b) {
  gjk_distance_result distance;
  uint32_t part = 0;
  memset(&distance, HOSTILE_POISON, sizeof distance);
  const gjk_status status = gjk_parts_distance(&a->parts, b, &part, &distance);
  hostile_check(status, &distance, sizeof distance);
  if (status == GJK_OK && a->is_sound) {
    check_nearest(a, b, part, &distance);
  }
}

static void ask_contacts(const gjk_parts *a, const gjk_collider *b, const gjk_parts *of_b, gjk_q16 margin) {
  const gjk_workspace workspace = {MAYBE(cells), fuzz_u8(&bytes) % (CELLS + 1)};
  const gjk_workspace *with = MAYBE(&workspace);
  const unsigned most = below(GJK_CONTACTS_MAX + 2), capacity = below(MANIFOLDS + 1);
  gjk_parts_manifold manifolds[MANIFOLDS];
  gjk_manifold together[MANIFOLDS];
  gjk_surface_contact on_surface[MANIFOLDS];
  uint32_t count;
  unsigned groups;
  uint16_t triangles;
  ASK(count, gjk_parts_contacts(a, b, margin, most, with, MAYBE(manifolds), capacity, &count));
  ASK(groups, gjk_parts_manifolds(a, b, margin, most, with, MAYBE(together), capacity, &groups));
  ASK(triangles, gjk_surface_contacts(a, b, margin, most, with, MAYBE(on_surface), (uint16_t)capacity, &triangles));
  ASK(count, gjk_parts_both_contacts(a, of_b, margin, most, with, MAYBE(manifolds), capacity, &count));
  ASK(groups, gjk_parts_both_manifolds(a, of_b, margin, most, with, MAYBE(together), capacity, &groups));
}

static void ask_places(const gjk_parts *a, const gjk_collider *b, const gjk_parts *of_b, gjk_q16 asked) {
  const gjk_workspace workspace = {cells, fuzz_u8(&bytes) % (CELLS + 1)};
  gjk_parts_room room;
  gjk_collider c;
  gjk_decision decision;
  gjk_distance_result distance;
  gjk_penetration_result depth;
  gjk_parts_pair pair;
  uint32_t part;
  hostile_check(gjk_parts_place(a, (uint32_t)fuzz_i32(&bytes) >> below(32), MAYBE(&room), &c), NULL, 0);
  ASK(decision, gjk_parts_intersect(a, b, MAYBE(&part), &decision));
  ASK(decision, gjk_parts_within(a, b, asked, MAYBE(&part), &decision));
  ASK(depth, gjk_parts_penetration(a, b, MAYBE(&workspace), MAYBE(&part), &depth));
  ASK(decision, gjk_parts_both_within(a, of_b, asked, MAYBE(&pair), &decision));
  ASK(distance, gjk_parts_both_distance(a, of_b, MAYBE(&pair), &distance));
  ASK(depth, gjk_parts_both_penetration(a, of_b, &workspace, MAYBE(&pair), &depth));
}

static gjk_motion any_motion(unsigned shift) {
  gjk_motion motion;
  motion.from = any_pose(shift);
  motion.to = any_pose(shift);
  motion.spin = hostile_vec3(&bytes, 8 + below(24));
  return motion;
}

static void ask_ways(const gjk_parts *a, const gjk_collider *b, const gjk_parts *of_b, gjk_q16 margin) {
  const unsigned shift = below(32);
  const gjk_vec3 to_a = hostile_vec3(&bytes, shift), to_b = hostile_vec3(&bytes, shift);
  const gjk_cast_path path = {MAYBE(&to_a), MAYBE(&to_b), margin};
  const gjk_motion motion_a = any_motion(shift), motion_b = any_motion(shift);
  const gjk_impact_setup setup = {margin, fuzz_i32(&bytes) >> below(32), (uint8_t)(1 + below(8))};
  gjk_cast_result cast;
  gjk_impact_result impact;
  gjk_parts_pair pair;
  uint32_t part;
  ASK(cast, gjk_parts_cast(a, b, MAYBE(&path), MAYBE(&part), &cast));
  ASK(cast, gjk_parts_cast_ahead(a, b, &path, MAYBE(&part), &cast));
  ASK(cast, gjk_parts_cast_ray(a, MAYBE(&to_a), MAYBE(&to_b), MAYBE(&part), &cast));
  ASK(cast, gjk_parts_both_cast(a, of_b, &path, MAYBE(&pair), &cast));
  ASK(impact, gjk_parts_time_of_impact(a, MAYBE(&motion_a), b, MAYBE(&motion_b), MAYBE(&setup), MAYBE(&part), &impact));
  ASK(impact, gjk_parts_impact_ahead(a, &motion_a, b, &motion_b, &setup, MAYBE(&part), &impact));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static hostile_shape shape;
  gjk_collider collider;
  bytes.at = data;
  bytes.end = data + size;
  make_body(&bodies[0]);
  make_body(&bodies[1]);
  memset(&collider, 0, sizeof collider);
  hostile_make_shape(&bytes, &shape);
  const gjk_pose pose = any_pose(below(32));
  if (gjk_collider_init(&collider, &shape.shape, NULL, 0) == GJK_OK) {
    (void)gjk_collider_pose(&collider, &pose);
  }
  const gjk_q16 margin = fuzz_i32(&bytes) >> below(32);
  const gjk_collider *b = MAYBE(&collider);
  const gjk_parts *one = MAYBE(&bodies[0].parts), *two = MAYBE(&bodies[1].parts);
  ask_distance(&bodies[0], &collider);
  ask_places(one, b, two, margin);
  ask_contacts(one, b, two, margin);
  ask_ways(one, b, two, margin);
  free_body(&bodies[0]);
  free_body(&bodies[1]);
  return 0;
}
