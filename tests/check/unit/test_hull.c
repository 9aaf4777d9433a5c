// Hulls: statuses, every dimension, faces for shapes, point sets that break builders with tolerances, as many points as fit,
// every size of workspace, and the check. test_hull_exact.c proves hulls of random families.
#include "filled.h"
#include "hull_points.h"

#include "gjk/collider.h"

static hull_points p;
static hull_output out, again;

// Is the output the hull of the points? Its faces are sound, and no point is beyond any of them.
static void check_output(const hull_points *points, const hull_output *o) {
  static gjk_vec3 all[2 * HULL_POINTS];
  gjk_hull_report report;
  if (o->hull.dimension < 2) {
    CHECK(o->faces.count == 0);
    return;
  }
  memcpy(all, o->vertex, o->hull.vertices * sizeof all[0]);
  memcpy(all + o->hull.vertices, points->point, points->count * sizeof all[0]);
  CHECK(gjk_hull_check(all, (uint16_t)(o->hull.vertices + points->count), &o->faces, &report) == GJK_OK);
  CHECK(o->faces.count <= GJK_HULL_FACES_MAX(o->hull.vertices));
  CHECK(o->faces.end[o->faces.count - 1] <= GJK_HULL_CORNERS_MAX(o->hull.vertices));
  CHECK_MSG(report.fault == GJK_HULL_SOUND, "fault %d of face %d, corner %d, vertex %d", report.fault, report.face,
            report.corner, report.vertex);
}

static void make(unsigned dimension, unsigned vertices, unsigned faces, unsigned edges) {
  static random_state random = {77};
  check_trial(0, hull_points_print, &p);
  hull_output_make(&p, &out);
  CHECK_MSG(out.hull.dimension == dimension && out.hull.vertices == vertices && out.hull.faces == faces &&
                out.hull.edges == edges,
            "%d-D, %d vertices, %ld faces, %ld edges", out.hull.dimension, out.hull.vertices, (long)out.hull.faces,
            (long)out.hull.edges);
  check_output(&p, &out);
  for (unsigned i = 0; i < 5; i++) {
    hull_points_shuffle(&p, &random);
    hull_output_make(&p, &again);
    CHECK(hull_output_equal(&out, &again));
  }
}

// A grid of n points a side, filled.
static void make_grid(int32_t nx, int32_t ny, int32_t nz, int32_t step) {
  p.count = 0;
  for (int32_t x = 0; x < nx; x++) {
    for (int32_t y = 0; y < ny; y++) {
      for (int32_t z = 0; z < nz; z++) {
        hull_points_add(&p, x * step, y * step, z * step);
      }
    }
  }
}

static void test_dimensions(void) {
  make_grid(1, 1, 1, 0);
  make(0, 1, 0, 0);
  p.point[0].x = INT32_MIN;
  make(0, 1, 0, 0);
  make_grid(1, 1, 1, 0);
  for (unsigned i = 0; i < 9; i++) {  // repeated points
    hull_points_add(&p, 0, 0, 0);
  }
  make(0, 1, 0, 0);
  make_grid(1, 5, 1, 7);
  make(1, 2, 0, 1);
  make_grid(4, 1, 6, 9);
  make(2, 4, 2, 4);
  p.count = 0;
  hull_points_add(&p, 0, 0, 0);
  hull_points_add(&p, 5, 1, 0);
  hull_points_add(&p, 1, 5, 3);
  make(2, 3, 2, 3);
  hull_points_add(&p, 3, 3, 1);  // above the edge's middle by half an LSB
  make(3, 4, 4, 6);
}

static void test_lattices(void) {
  make_grid(2, 2, 2, GJK_Q16_ONE);
  make(3, 8, 6, 12);
  CHECK(out.volume.high == 0 && out.volume.low == UINT64_C(6) << 48);
  make_grid(10, 10, 10, 1000);
  make(3, 8, 6, 12);
  make_grid(2, 2, 2, 2 * GJK_RADIUS_MAX);  // the largest
  make(3, 8, 6, 12);
  // 6 (2 GJK_RADIUS_MAX)^3
  CHECK(out.volume.high == UINT64_C(0x2FF7008) && out.volume.low == UINT64_C(0xFFD0000000000000));
  for (unsigned i = 0; i < p.count; i++) {  // anywhere in int32
    p.point[i].x -= INT32_MAX;
    p.point[i].y += INT32_MAX - 2 * GJK_RADIUS_MAX;
  }
  make(3, 8, 6, 12);
  for (unsigned i = 0; i < 8; i++) {  // each corner eight times
    for (unsigned j = 0; j < 7; j++) {
      hull_points_add(&p, p.point[i].x, p.point[i].y, p.point[i].z);
    }
  }
  make(3, 8, 6, 12);
}

// Prisms over polygons of n corners: two facets of n corners, which are cut for shapes.
static void test_prisms(void) {
  for (int32_t n = 3; n <= 60; n++) {
    p.count = 0;
    for (int32_t i = 0; i < n; i++) {  // on a parabola, all corners extreme
      hull_points_add(&p, 1000 * i, i * i * 10, -500);
      hull_points_add(&p, 1000 * i, i * i * 10, 500);
    }
    make(3, 2u * (unsigned)n, (unsigned)n + 2, 3u * (unsigned)n);
    CHECK(out.hull.most_corners == (n < 4 ? 4 : n));
    uint16_t most = 0, begin = 0;
    for (unsigned i = 0; i < out.faces.count; i++) {
      const uint16_t corners = (uint16_t)(out.end[i] - begin);
      most = corners > most ? corners : most;
      begin = out.end[i];
    }
    CHECK(most == (n < 4 ? 4 : n < GJK_FACE_CORNERS_MAX ? n : GJK_FACE_CORNERS_MAX));
    // A facet of n corners gives the least number of faces of at most 12 that share a corner.
    CHECK(out.faces.count == (unsigned)n + 2u * (unsigned)((n - 2 + 9) / 10));
    const gjk_shape shape = GJK_HULL_WITH_FACES(out.vertex, out.hull.vertices, &out.faces);
    gjk_collider collider = {0};
    CHECK(gjk_collider_init(&collider, &shape, NULL, 0) == GJK_OK);
  }
}

// Points of a sphere, rounded; of a dome flat by few LSB; of two clusters; of a cylinder with caps.
static void test_hostile(void) {
  random_state random = random_seed(check_seed(991));
  for (unsigned long trial = 0; trial < check_trials(400); trial++) {
    const unsigned family = (unsigned)(trial % 5);
    const int32_t reach = INT32_C(1) << random_range(&random, 2, 27);
    check_trial(trial, hull_points_print, &p);
    p.count = 0;
    for (unsigned n = 4 + random_below(&random, 120); p.count < n;) {
      int32_t x = random_range(&random, -reach, reach), y = random_range(&random, -reach, reach);
      int32_t z = random_range(&random, -reach, reach);
      if (family == 1) {  // within an LSB of a plane that leans
        z = (x / 2 + y / 4) + random_range(&random, 0, 1);
      } else if (family == 2) {  // within an LSB of a line
        y = x / 3 + random_range(&random, 0, 1);
        z = x / 5 + random_range(&random, 0, 1);
      } else if (family == 3) {  // two clusters far apart
        x = x / 1024 + (p.count % 2 == 0 ? -reach : reach);
        y /= 1024;
        z /= 1024;
      } else if (family == 4) {  // on the surface of a box, most of them coplanar with many
        const int32_t side = random_below(&random, 2) == 0 ? -reach : reach;
        const unsigned axis = random_below(&random, 3);
        x = axis == 0 ? side : x;
        y = axis == 1 ? side : y;
        z = axis == 2 ? side : z;
      }
      hull_points_add(&p, x, y, z);
    }
    hull_output_make(&p, &out);
    check_output(&p, &out);
    hull_points_shuffle(&p, &random);
    hull_output_make(&p, &again);
    CHECK(hull_output_equal(&out, &again));
  }
}

static void test_statuses(void) {
  static uint32_t workspace[GJK_HULL_WORKSPACE(8) / 4 + 1];
  const size_t bytes = GJK_HULL_WORKSPACE(8);
  uint16_t corner[24], end[6];
  gjk_vec3 vertex[8];
  gjk_hull_faces faces = {NULL, NULL, 99};
  gjk_hull hull, before;
  gjk_hull_volume volume;
  make_grid(2, 2, 2, 4);
  memset(&hull, 0xA5, sizeof hull);
  before = hull;
  CHECK(gjk_hull_build(NULL, 8, workspace, bytes, &hull) == GJK_ERROR_NULL);
  CHECK(gjk_hull_build(p.point, 8, NULL, bytes, &hull) == GJK_ERROR_NULL);
  CHECK(gjk_hull_build(p.point, 8, workspace, bytes, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_hull_build(p.point, 0, workspace, bytes, &hull) == GJK_ERROR_EMPTY);
  CHECK(gjk_hull_build(p.point, 8, workspace, bytes - 1, &hull) == GJK_ERROR_CAPACITY);
  CHECK(gjk_hull_build(p.point, 8, (char *)workspace + 2, bytes, &hull) == GJK_ERROR_RANGE);
  p.point[3].y = 2 * GJK_RADIUS_MAX + 1;
  CHECK(gjk_hull_build(p.point, 8, workspace, bytes, &hull) == GJK_ERROR_SIZE);
  CHECK(memcmp(&hull, &before, sizeof hull) == 0);
  p.point[3].y = 4;
  CHECK(gjk_hull_build(p.point, 8, workspace, bytes, &hull) == GJK_OK);
  CHECK(gjk_hull_vertices(NULL, vertex, 8) == GJK_ERROR_NULL);
  CHECK(gjk_hull_vertices(&hull, NULL, 8) == GJK_ERROR_NULL);
  CHECK(gjk_hull_vertices(&hull, vertex, 7) == GJK_ERROR_CAPACITY);
  CHECK(gjk_hull_vertices(&hull, vertex, 8) == GJK_OK);
  CHECK(gjk_hull_get_volume(NULL, &volume) == GJK_ERROR_NULL && gjk_hull_get_volume(&hull, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_hull_write_faces(NULL, corner, 24, end, 6, &faces) == GJK_ERROR_NULL);
  CHECK(gjk_hull_write_faces(&hull, NULL, 24, end, 6, &faces) == GJK_ERROR_NULL);
  CHECK(gjk_hull_write_faces(&hull, corner, 24, NULL, 6, &faces) == GJK_ERROR_NULL);
  CHECK(gjk_hull_write_faces(&hull, corner, 24, end, 6, NULL) == GJK_ERROR_NULL);
  for (uint16_t corners = 0; corners < 24; corners++) {
    CHECK(gjk_hull_write_faces(&hull, corner, corners, end, 6, &faces) == GJK_ERROR_CAPACITY);
  }
  for (uint16_t count = 0; count < 6; count++) {
    CHECK(gjk_hull_write_faces(&hull, corner, 24, end, count, &faces) == GJK_ERROR_CAPACITY);
  }
  CHECK(faces.count == 99);
  CHECK(gjk_hull_write_faces(&hull, corner, 24, end, 6, &faces) == GJK_OK && faces.count == 6);
}

// Facets of 30 corners, flat or of a prism: room for one number too few is refused at any size, what is needed is enough,
// and nothing beyond the room is touched.
static void test_rooms(void) {
  enum { SIDES = 30, ROOM = 6 * 2 * SIDES };
  static uint32_t workspace[GJK_HULL_WORKSPACE(2 * SIDES) / 4];
  gjk_vec3 point[2 * SIDES];
  uint16_t corner[ROOM], end[ROOM];
  for (uint16_t levels = 1; levels <= 2; levels++) {
    gjk_hull hull;
    gjk_hull_faces faces;
    for (int32_t i = 0; i < levels * SIDES; i++) {
      const int32_t x = i % SIDES;
      point[i] = (gjk_vec3){x, x * x, i / SIDES};
    }
    CHECK(gjk_hull_build(point, (uint16_t)(levels * SIDES), workspace, sizeof workspace, &hull) == GJK_OK);
    CHECK(gjk_hull_write_faces(&hull, corner, ROOM, end, ROOM, &faces) == GJK_OK);
    const uint16_t count = faces.count, corners = faces.end[count - 1];
    CHECK_MSG(count == (levels == 1 ? 6 : SIDES + 6), "%u faces", count);  // 3 pieces of each of two facets
    for (unsigned room = 0; room <= (unsigned)corners + count; room++) {
      const bool of_corners = room <= corners;
      const uint16_t given = (uint16_t)(of_corners ? room : room - corners), needed = of_corners ? corners : count;
      uint16_t *const list = of_corners ? corner : end;
      memset(corner, POISON, sizeof corner);
      memset(end, POISON, sizeof end);
      memset(&faces, POISON, sizeof faces);
      const gjk_status status =
          gjk_hull_write_faces(&hull, corner, of_corners ? given : ROOM, end, of_corners ? ROOM : given, &faces);
      CHECK_MSG(status == (given < needed ? GJK_ERROR_CAPACITY : GJK_OK), "%u levels, room %u: %s", levels, room,
                gjk_status_name(status));
      CHECK(is_untouched(&list[given], (ROOM - given) * sizeof *list));
      CHECK(status == GJK_OK ? faces.count == count : is_untouched(&faces, sizeof faces));
    }
  }
}

// 65,535 points: a lattice under a paraboloid, all of them extreme, whose squares are facets; and 27 places again and again.
static void test_many(void) {
  static gjk_vec3 point[GJK_HULL_POINTS_MAX], vertex[GJK_HULL_POINTS_MAX];
  static uint32_t workspace[GJK_HULL_WORKSPACE(GJK_HULL_POINTS_MAX) / 4];
  static uint16_t corner[GJK_HULL_POINTS_MAX], end[GJK_HULL_POINTS_MAX];
  gjk_hull hull;
  gjk_hull_faces faces;
  gjk_hull_volume volume;
  for (int32_t i = 0; i < GJK_HULL_POINTS_MAX; i++) {
    const int32_t k = (int32_t)((int64_t)i * 40507 % GJK_HULL_POINTS_MAX), x = k % 255, y = k / 255;
    point[i].x = x;
    point[i].y = y;
    point[i].z = x * x + y * y;
  }
  CHECK(gjk_hull_build(point, GJK_HULL_POINTS_MAX, workspace, sizeof workspace, &hull) == GJK_OK);
  CHECK(hull.dimension == 3 && hull.vertices == GJK_HULL_POINTS_MAX);
  CHECK(hull.faces - hull.edges + hull.vertices == 2);
  // Below, the four corners of each square of the lattice are in one plane. Each side of the lattice is a facet, a polygon
  // within a parabola, and so are its four corners, above.
  CHECK_MSG(hull.faces == 254 * 256 + 5, "%lu faces", (unsigned long)hull.faces);
  CHECK(gjk_hull_vertices(&hull, vertex, GJK_HULL_POINTS_MAX) == GJK_OK);
  for (uint32_t i = 0; i < GJK_HULL_POINTS_MAX; i++) {
    CHECK(vertex[i].x == (int32_t)(i / 257) && vertex[i].y == (int32_t)(i % 257));
  }
  CHECK(gjk_hull_write_faces(&hull, corner, GJK_HULL_POINTS_MAX, end, GJK_HULL_POINTS_MAX, &faces) ==
        GJK_ERROR_CAPACITY);
  for (uint32_t i = 0; i < GJK_HULL_POINTS_MAX; i++) {
    point[i].x = (int32_t)(i % 3) * 1000;
    point[i].y = (int32_t)(i / 3 % 3) * 1000;
    point[i].z = (int32_t)(i / 9 % 3) * 1000;
  }
  CHECK(gjk_hull_build(point, GJK_HULL_POINTS_MAX, workspace, sizeof workspace, &hull) == GJK_OK);
  CHECK(hull.vertices == 8 && hull.faces == 6 && hull.edges == 12 && gjk_hull_get_volume(&hull, &volume) == GJK_OK &&
        volume.low == UINT64_C(48000000000) && volume.high == 0);
}

// A workspace of 40 bytes a point and 40 is enough, and nothing beyond it is touched; any smaller one is refused, and then
// nothing is.
static void test_workspaces(void) {
  static uint32_t workspace[GJK_HULL_WORKSPACE(64) / 4 + 8];
  random_state random = random_seed(check_seed(4));
  CHECK(GJK_HULL_WORKSPACE(64) == 2600 && GJK_HULL_WORKSPACE(0) == 40);
  for (uint16_t count = 1; count <= 64; count++) {
    const size_t need = GJK_HULL_WORKSPACE(count);
    gjk_hull hull;
    p.count = 0;
    while (p.count < count) {  // near a sphere
      const int32_t x = random_range(&random, -100, 100), y = random_range(&random, -100, 100);
      const int32_t z = random_range(&random, -100, 100), squared = x * x + y * y + z * z;
      if (squared > 9000 && squared < 10000) {
        hull_points_add(&p, x, y, z);
      }
    }
    memset(workspace, POISON, sizeof workspace);
    hull.vertices = 4711;
    hull.faces = 4712;
    for (size_t bytes = 0; bytes < need; bytes++) {
      CHECK(gjk_hull_build(p.point, count, workspace, bytes, &hull) == GJK_ERROR_CAPACITY);
    }
    CHECK(hull.vertices == 4711 && hull.faces == 4712 && is_untouched(workspace, sizeof workspace));
    CHECK(gjk_hull_build(p.point, count, workspace, need, &hull) == GJK_OK);
    CHECK(is_untouched(workspace + need / 4, sizeof workspace - need));
  }
}

// The fault that the check finds in faces of a cube.
static unsigned fault_of(gjk_hull_faces faces, uint16_t face, uint16_t corner) {
  gjk_hull_report report;
  CHECK(gjk_hull_check(out.vertex, out.hull.vertices, &faces, &report) == GJK_OK);
  CHECK_MSG(report.fault == GJK_HULL_SOUND || (report.face == face && report.corner == corner),
            "fault %d of face %d, corner %d", report.fault, report.face, report.corner);
  return report.fault;
}

// Each fault in the faces of a cube, and what the check calls it.
static void test_faults(void) {
  gjk_hull_report report;
  uint16_t corner[48], end[12], swapped;
  make_grid(2, 2, 2, 4);
  hull_output_make(&p, &out);
  gjk_hull_faces faces = {corner, end, 6};
  CHECK(gjk_hull_check(NULL, 8, &faces, &report) == GJK_ERROR_NULL);
  CHECK(gjk_hull_check(out.vertex, 8, NULL, &report) == GJK_ERROR_NULL);
  CHECK(gjk_hull_check(out.vertex, 8, &faces, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_hull_check(out.vertex, 0, &faces, &report) == GJK_ERROR_EMPTY);
  const gjk_hull_faces none = {NULL, NULL, 1}, empty = {NULL, NULL, 0};
  CHECK(gjk_hull_check(out.vertex, 8, &none, &report) == GJK_ERROR_NULL);
  CHECK(fault_of(empty, 0, 0) == GJK_HULL_FEW);
  memcpy(corner, out.corner, 24 * sizeof corner[0]);
  memcpy(end, out.end, 6 * sizeof end[0]);
  CHECK(fault_of(faces, 0, 0) == GJK_HULL_SOUND);
  corner[9] = 8;
  CHECK(fault_of(faces, 2, 1) == GJK_HULL_NUMBER);
  corner[9] = out.corner[9];
  end[3] = (uint16_t)(end[2] + 2);
  CHECK(fault_of(faces, 3, 0) == GJK_HULL_FEW);
  end[3] = (uint16_t)(end[2] - 1);
  CHECK(fault_of(faces, 3, 0) == GJK_HULL_FEW);
  end[3] = out.end[3];
  uint16_t other = 0;  // a corner that is not in the face's plane
  while (other == corner[4] || other == corner[5] || other == corner[6] || other == corner[7]) {
    other++;
  }
  corner[7] = other;
  CHECK(fault_of(faces, 1, 3) == GJK_HULL_BENT);
  corner[7] = out.corner[7];
  swapped = corner[5];
  corner[5] = corner[6];  // a face that crosses itself
  corner[6] = swapped;
  CHECK(gjk_hull_check(out.vertex, 8, &faces, &report) == GJK_OK && report.fault == GJK_HULL_TURN && report.face == 1);
  memcpy(corner, out.corner, 24 * sizeof corner[0]);
  corner[16] = out.corner[19];  // a face the other way round
  corner[17] = out.corner[18];
  corner[18] = out.corner[17];
  corner[19] = out.corner[16];
  CHECK(fault_of(faces, 4, 0) == GJK_HULL_BEYOND);
  memcpy(corner, out.corner, 24 * sizeof corner[0]);
  faces.count = 5;  // a face is missing
  CHECK(gjk_hull_check(out.vertex, 8, &faces, &report) == GJK_OK && report.fault == GJK_HULL_OPEN);
  faces.count = 7;  // a face twice
  memcpy(corner + 24, out.corner, 4 * sizeof corner[0]);
  end[6] = 28;
  CHECK(fault_of(faces, 0, 0) == GJK_HULL_DOUBLED);
  // The other diagonal of a square: two triangles instead of a face are sound, all four are not.
  faces.count = 7;
  memmove(corner, out.corner + 4, 20 * sizeof corner[0]);
  for (unsigned i = 0; i < 5; i++) {
    end[i] = (uint16_t)(4 * (i + 1));
  }
  const uint16_t *square = out.corner;
  const uint16_t triangles[6] = {square[0], square[1], square[2], square[0], square[2], square[3]};
  memcpy(corner + 20, triangles, sizeof triangles);
  end[5] = 23;
  end[6] = 26;
  CHECK(fault_of(faces, 0, 0) == GJK_HULL_SOUND);
  out.vertex[7].x += 2 * GJK_RADIUS_MAX;
  CHECK(gjk_hull_check(out.vertex, 8, &faces, &report) == GJK_ERROR_SIZE);
}

// A surface laid twice over a tetrahedron whose edges carry points in their middles: each edge differs, all faces hold,
// only going around a vertex shows it.
static void test_layers(void) {
  gjk_hull_report report;
  const gjk_vec3 vertex[10] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {2, 0, 0},
                               {0, 2, 0}, {0, 0, 2}, {2, 2, 0}, {2, 0, 2}, {0, 2, 2}};
  const uint16_t corner[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3,   // once
                             0, 5, 4, 5, 2, 7, 4, 7, 1, 4, 5, 7,   // z = 0, in four
                             0, 4, 6, 4, 1, 8, 6, 8, 3, 6, 4, 8,   // y = 0
                             0, 6, 5, 6, 3, 9, 5, 9, 2, 5, 6, 9,   // x = 0
                             1, 7, 8, 7, 2, 9, 8, 9, 3, 8, 7, 9};  // the rest
  uint16_t end[20];
  for (uint16_t i = 0; i < 20; i++) {
    end[i] = (uint16_t)(3 * (i + 1));
  }
  const gjk_hull_faces once = {corner, end, 4}, fine = {corner + 12, end, 16}, both = {corner, end, 20};
  CHECK(gjk_hull_check(vertex, 10, &once, &report) == GJK_OK && report.fault == GJK_HULL_SOUND);
  CHECK(gjk_hull_check(vertex, 10, &fine, &report) == GJK_OK);
  CHECK_MSG(report.fault == GJK_HULL_SOUND, "fault %d of face %d, corner %d", report.fault, report.face, report.corner);
  CHECK(gjk_hull_check(vertex, 10, &both, &report) == GJK_OK && report.fault == GJK_HULL_LAYERS);
}

int main(void) {
  test_dimensions();
  test_lattices();
  test_prisms();
  test_hostile();
  test_statuses();
  test_rooms();
  test_many();
  test_workspaces();
  test_faults();
  test_layers();
  return check_done("hull");
}
