// Hulls, tables, mass properties and the functions of gjk/bind.h on hostile input: points, faces, tables, tensors and names
// of any content. A hull of points must pass its own check and hold every point.
#include <stdlib.h>
#include <string.h>

#include "hostile.h"

#define POINTS_MOST 40
#define CORNERS_MOST (8 * POINTS_MOST)
#define FACES_MOST (2 * POINTS_MOST)
#define ENTRIES_MOST 200
#define NAME_MOST 40

static fuzz_bytes bytes;

static uint32_t below(uint32_t most) {
  return fuzz_u8(&bytes) % most;
}

static uint64_t any_uint64(void) {
  return (uint64_t)(uint32_t)fuzz_i32(&bytes) << 32 | (uint32_t)fuzz_i32(&bytes);
}

// On the heap and as long as said, so that a sanitizer sees what is read beyond.
static gjk_vec3 *any_points(uint16_t count) {
  gjk_vec3 *points = malloc((count > 0 ? count : 1u) * sizeof *points);
  const unsigned shift = below(32);
  for (unsigned i = 0; i < count; i++) {
    const bool again = i > 0 && below(8) == 0;
    points[i] = again ? points[below(i)] : hostile_vec3(&bytes, shift);
  }
  return points;
}

static gjk_mass any_mass(void) {
  const unsigned shift = below(64);
  gjk_mass m;
  m.volume.high = any_uint64();
  m.volume.low = any_uint64();
  m.mass = (uint32_t)fuzz_i32(&bytes) >> below(32);
  m.centre = fuzz_vec3(&bytes);
  int64_t *const entries[6] = {&m.inertia.xx, &m.inertia.yy, &m.inertia.zz,
                               &m.inertia.yz, &m.inertia.zx, &m.inertia.xy};
  for (int i = 0; i < 6; i++) {
    *entries[i] = (int64_t)any_uint64() >> shift;
  }
  for (int i = 0; i < 3; i++) {
    m.fraction[i] = (int16_t)fuzz_i32(&bytes);
  }
  return m;
}

// The check of faces finds nothing wrong, with all points beside the vertices: none lies beyond a face. The mass of the hull
// and that of a shape with these faces are the same.
static void check_hull(const gjk_hull *hull, const gjk_vec3 *points, uint16_t count) {
  gjk_vec3 *vertices = malloc((hull->vertices + (size_t)count) * sizeof *vertices);
  uint16_t corner[CORNERS_MOST], end[FACES_MOST];
  gjk_hull_faces faces;
  gjk_hull_report report;
  gjk_hull_volume volume;
  gjk_mass of_hull, of_shape;
  if (gjk_hull_vertices(hull, vertices, (uint16_t)(hull->vertices - 1u)) != GJK_ERROR_CAPACITY ||
      gjk_hull_vertices(hull, vertices, hull->vertices) != GJK_OK ||
      gjk_hull_write_faces(hull, corner, CORNERS_MOST, end, FACES_MOST, &faces) != GJK_OK ||
      gjk_hull_get_volume(hull, &volume) != GJK_OK || gjk_mass_of_hull(hull, &of_hull) != GJK_OK) {
    fuzz_fail("a hull cannot be written");
  }
  if (hull->dimension >= 2) {
    const gjk_shape shape = {&gjk_class_hull, vertices, NULL, NULL, {0, 0, 0}, 0, hull->vertices, &faces};
    memcpy(vertices + hull->vertices, points, count * sizeof *points);
    if (gjk_hull_check(vertices, (uint16_t)(hull->vertices + count), &faces, &report) != GJK_OK ||
        report.fault != GJK_HULL_SOUND) {
      fuzz_fail("a hull's faces are not sound");
    }
    const gjk_status status = gjk_mass_of_shape(&shape, &of_shape);
    if (status != GJK_ERROR_SIZE &&
        (status != GJK_OK || memcmp(&of_shape.inertia, &of_hull.inertia, sizeof of_hull.inertia) != 0)) {
      fuzz_fail("the inertia of a hull and of its shape");
    }
  }
  free(vertices);
}

static void build_hulls(void) {
  const uint16_t count = (uint16_t)below(POINTS_MOST + 1);
  gjk_vec3 *points = any_points(count);
  const size_t size = GJK_HULL_WORKSPACE(count), simple_size = GJK_HULL_SIMPLIFY_WORKSPACE(count);
  const bool short_of_room = hostile_leaves_out(&bytes);
  uint32_t *workspace = malloc(short_of_room ? size - 1 : size), *room = malloc(simple_size);
  const uint16_t most = (uint16_t)below(12);
  gjk_vec3 *vertices = malloc((most > 0 ? most : 1u) * sizeof *vertices);
  gjk_hull hull;
  gjk_hull_simple simple;
  memset(&hull, HOSTILE_POISON, sizeof hull);
  const gjk_status status =
      gjk_hull_build(MAYBE(points), count, MAYBE(workspace), short_of_room ? size - 1 : size, &hull);
  hostile_check(status, status == GJK_ERROR_CAPACITY ? NULL : &hull, sizeof hull);
  if (status == GJK_OK) {
    check_hull(&hull, points, count);
  }
  ASK(simple,
      gjk_hull_simplify(MAYBE(points), count, most, MAYBE(room), simple_size - below(2), MAYBE(vertices), &simple));
  free(vertices);
  free(room);
  free(workspace);
  free(points);
}

// Faces and tables of any content.
static void check_forged(void) {
  const uint16_t count = (uint16_t)below(POINTS_MOST + 1);
  const uint8_t level = (uint8_t)below(3);
  const uint32_t cells = gjk_table_cells(level), entries = 1 + below(ENTRIES_MOST);
  gjk_vec3 *points = any_points(count);
  uint16_t *entry = malloc(entries * sizeof *entry), *end = malloc(cells * sizeof *end);
  hostile_shape shape;
  gjk_hull_report report;
  gjk_mass mass;
  for (uint32_t i = 0; i < entries; i++) {
    entry[i] = (uint16_t)below(count + 1u);
  }
  for (uint32_t i = 0; i < cells; i++) {
    end[i] = (uint16_t)(i * entries / cells + below(2));
    end[i] = (uint16_t)(end[i] > entries ? entries : end[i]);
  }
  const gjk_hull_table table = {MAYBE(entry), MAYBE(end),
                                hostile_leaves_out(&bytes) ? (uint8_t)(GJK_TABLE_LEVEL_MAX + 1) : level};
  hostile_check(gjk_hull_table_check(MAYBE(points), count, MAYBE(&table)), NULL, 0);
  hostile_check(gjk_hull_table_make(MAYBE(points), count, level, MAYBE(entry), (uint16_t)entries, MAYBE(end)), NULL, 0);
  hostile_make_shape(&bytes, &shape);
  ASK(report,
      gjk_hull_check(MAYBE(shape.vertices), (uint16_t)below(HOSTILE_VERTICES + 1), MAYBE(shape.shape.faces), &report));
  ASK(mass, gjk_mass_of_shape(MAYBE(&shape.shape), &mass));
  free(end);
  free(entry);
  free(points);
}

static void add_masses(void) {
  gjk_mass body = any_mass();
  const gjk_mass part = any_mass(), before = body;
  gjk_pose pose;
  gjk_principal axes;
  pose.position = fuzz_vec3(&bytes);
  pose.rotation = hostile_quat(&bytes);
  ASK(axes, gjk_mass_principal(MAYBE(&part), &axes));
  gjk_status status = gjk_mass_add(MAYBE(&body), MAYBE(&part), MAYBE(&pose));
  status = status == GJK_OK ? status : gjk_mass_set_density(MAYBE(&body), (uint32_t)fuzz_i32(&bytes));
  hostile_check(status, NULL, 0);
  if (status != GJK_OK && memcmp(&body, &before, sizeof body) != 0) {
    fuzz_fail("an error changed a body");
  }
}

static void bind_all(void) {
  const gjk_q16 x = fuzz_i32(&bytes) >> below(32), y = fuzz_i32(&bytes) >> below(32), z = fuzz_i32(&bytes) >> below(32);
  const gjk_q16 radius = fuzz_i32(&bytes) >> below(32);
  hostile_shape from;
  gjk_shape shape;
  int64_t value;
  char *name = malloc(NAME_MOST + 1);
  hostile_make_shape(&bytes, &from);
  const uint16_t count = (uint16_t)below(HOSTILE_VERTICES + 1);
  const gjk_vec3 *vertices = MAYBE(from.vertices);
  ASK(shape, gjk_shape_point(radius, &shape));
  ASK(shape, gjk_shape_segment(x, radius, &shape));
  ASK(shape, gjk_shape_triangle(vertices, radius, &shape));
  ASK(shape, gjk_shape_box(x, y, z, radius, &shape));
  ASK(shape, gjk_shape_cylinder(x, y, radius, &shape));
  ASK(shape, gjk_shape_cone(x, y, radius, &shape));
  ASK(shape, gjk_shape_ellipsoid(x, y, z, radius, &shape));
  ASK(shape, gjk_shape_custom(MAYBE(from.shape.support), MAYBE(&from), x, radius, &shape));
  ASK(shape, gjk_shape_hull(vertices, count, MAYBE(from.shape.faces), radius, &shape));
  (void)gjk_compound_nodes((uint32_t)x);
  (void)gjk_mesh_nodes((uint32_t)y);
  (void)gjk_table_cells((uint8_t)z);
  (void)gjk_hull_workspace((uint32_t)x);
  (void)gjk_hull_simplify_workspace((uint32_t)y);
  const uint32_t length = below(NAME_MOST + 1);
  for (uint32_t i = 0; i < length; i++) {
    name[i] = (char)fuzz_u8(&bytes);
  }
  name[length] = '\0';
  (void)gjk_size_of(MAYBE(name));
  ASK(value, gjk_constant(MAYBE(name), &value));
  free(name);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  bytes.at = data;
  bytes.end = data + size;
  build_hulls();
  check_forged();
  add_masses();
  bind_all();
  return 0;
}
