// The fixed set of points, their hulls and mass properties and the hash of it all, without libc and with little RAM.
#include "hull_golden.h"

#include "gjk/gjk.h"
#include "gjk/hull.h"
#include "gjk/mass.h"
#include "gjk2/gjk2.h"
#include "gjk2/hull.h"
#include "gjk2/mass.h"
#include "golden_mix.h"

#define POINTS 14

static gjk_vec3 points[POINTS], vertices[POINTS];
static gjk2_vec flat[POINTS], fewer[2 * POINTS];
static uint32_t workspace[GJK_HULL_SIMPLIFY_WORKSPACE(POINTS) / 4];
static uint16_t corner[8 * POINTS], end[2 * POINTS];
static void mix_long(uint64_t value) {
  mix((uint32_t)(value & UINT32_MAX));
  mix((uint32_t)(value >> 32));
}

static void mix_mass(gjk_status status, const gjk_mass *m) {
  mix((uint32_t)status);
  if (status != GJK_OK) {
    return;
  }
  mix_long(m->volume.high);
  mix_long(m->volume.low);
  mix(m->mass);
  mix_vector(&m->centre);
  for (int i = 0; i < 3; i++) {
    mix((uint32_t)(int32_t)m->fraction[i]);
  }
  mix_long((uint64_t)m->inertia.xx);
  mix_long((uint64_t)m->inertia.yy);
  mix_long((uint64_t)m->inertia.zz);
  mix_long((uint64_t)m->inertia.yz);
  mix_long((uint64_t)m->inertia.zx);
  mix_long((uint64_t)m->inertia.xy);
}

static void mix_flat_mass(gjk_status status, const gjk2_mass *m) {
  mix((uint32_t)status);
  if (status != GJK_OK) {
    return;
  }
  mix_long(m->area);
  mix(m->mass);
  mix((uint32_t)m->centre.x);
  mix((uint32_t)m->centre.y);
  mix((uint32_t)(int32_t)m->fraction[0]);
  mix((uint32_t)(int32_t)m->fraction[1]);
  mix_long((uint64_t)m->inertia);
}

// A quarter of all coordinates is rounded to a coarse grid, so that points are coplanar, in line or repeated; every fifth
// set lies in a plane.
static uint16_t make_points(random_state *random) {
  const int32_t size = INT32_C(1) << (2 + random_below(random, 26));
  const int32_t grid = random_below(random, 2) == 0 ? size / 2 : 1;
  const int32_t thick = random_below(random, 5) == 0 ? 0 : size;
  const uint16_t count = (uint16_t)(1 + random_below(random, POINTS));
  for (uint32_t i = 0; i < count; i++) {
    const int32_t x = random_range(random, -size, size), y = random_range(random, -size, size),
                  z = random_range(random, -thick, thick);
    points[i].x = x / grid * grid;
    points[i].y = y / grid * grid;
    points[i].z = z / grid * grid;
    flat[i].x = points[i].x;
    flat[i].y = points[i].y;
  }
  return count;
}

static void mix_hull(const gjk_hull *hull, gjk_hull_faces *faces) {
  gjk_hull_volume volume = {0, 0};
  gjk_hull_report report;
  mix((uint32_t)gjk_hull_vertices(hull, vertices, POINTS));
  mix((uint32_t)gjk_hull_write_faces(hull, corner, 8 * POINTS, end, 2 * POINTS, faces));
  mix((uint32_t)gjk_hull_get_volume(hull, &volume));
  mix(hull->dimension);
  mix(hull->vertices);
  mix(hull->faces);
  mix(hull->edges);
  mix(hull->most_corners);
  mix_long(volume.high);
  mix_long(volume.low);
  for (uint32_t i = 0; i < hull->vertices; i++) {
    mix_vector(&vertices[i]);
  }
  for (uint32_t i = 0; i < faces->count; i++) {
    mix(end[i]);
  }
  for (uint32_t i = 0; faces->count > 0 && i < end[faces->count - 1u]; i++) {
    mix(corner[i]);
  }
  if (faces->count > 1) {  // sound, and with two corners exchanged
    mix((uint32_t)gjk_hull_check(vertices, hull->vertices, faces, &report));
    mix(report.fault);
    corner[2] = corner[1];
    mix((uint32_t)gjk_hull_check(vertices, hull->vertices, faces, &report));
    mix((uint32_t)report.fault << 16 | report.face);
  }
}

// A body of a hull and of a shape of another kind, and its principal axes.
static void add_shape(random_state *random, gjk_mass *body) {
  static const gjk_shape kinds[] = {GJK_POINT,          GJK_SEGMENT(0), GJK_BOX(0, 0, 0),
                                    GJK_CYLINDER(0, 0), GJK_CONE(0, 0), GJK_ELLIPSOID(0, 0, 0)};
  gjk_pose pose = GJK_POSE_IDENTITY;
  const gjk_quat q = {random_range(random, -1000, 1000), random_range(random, -1000, 1000),
                      random_range(random, -1000, 1000), random_range(random, 1, 1000)};
  gjk_mass part;
  gjk_principal axes;
  gjk_shape shape = kinds[random_below(random, sizeof kinds / sizeof kinds[0])];
  const int32_t size = INT32_C(1) << (2 + random_below(random, 24));
  shape.size.x = random_range(random, 1, size);
  shape.size.y = random_range(random, 1, size);
  shape.size.z = random_range(random, 1, size);
  shape.convex_radius = random_below(random, 2) == 0 ? random_range(random, 1, size) : 0;
  mix((uint32_t)gjk_quat_normalize(&q, &pose.rotation));
  pose.position.x = random_range(random, -size, size);
  pose.position.y = random_range(random, -size, size);
  pose.position.z = random_range(random, -size, size);
  const gjk_status status = gjk_mass_of_shape(&shape, &part);
  mix_mass(status, &part);
  if (status != GJK_OK) {
    return;
  }
  part.mass = 1 + random_below(random, 100000);
  mix_mass(gjk_mass_add(body, &part, &pose), body);
  const gjk_status found = gjk_mass_principal(body, &axes);
  mix((uint32_t)found);
  if (found == GJK_OK) {
    mix((uint32_t)axes.rotation.x);
    mix((uint32_t)axes.rotation.y);
    mix((uint32_t)axes.rotation.z);
    mix((uint32_t)axes.rotation.w);
    for (int i = 0; i < 3; i++) {
      mix_long((uint64_t)axes.moment[i]);
    }
  }
}

static void take_set(random_state *random) {
  const uint16_t count = make_points(random);
  gjk_hull hull;
  gjk_hull_faces faces = {corner, end, 0};
  gjk_mass body;
  const gjk_status status = gjk_hull_build(points, count, workspace, sizeof workspace, &hull);
  mix((uint32_t)status);
  if (status == GJK_OK) {
    mix_hull(&hull, &faces);
    mix_mass(gjk_mass_of_hull(&hull, &body), &body);
    mix((uint32_t)gjk_mass_set_density(&body, random_below(random, UINT32_MAX)));
    body.mass = body.mass == 0 ? 1 : body.mass;
    add_shape(random, &body);
  }
}

static void simplify_set(random_state *random) {
  const uint16_t count = make_points(random), most = (uint16_t)(4 + random_below(random, 6));
  gjk_hull_simple simple;
  const gjk_status status = gjk_hull_simplify(points, count, most, workspace, sizeof workspace, vertices, &simple);
  mix((uint32_t)status);
  if (status == GJK_OK) {
    mix(simple.vertices);
    mix(simple.excess);
    for (uint32_t i = 0; i < simple.vertices; i++) {
      mix_vector(&vertices[i]);
    }
  }
}

static void simplify_flat_set(uint16_t count) {
  gjk2_hull_simple simple;
  const gjk_status status = gjk2_hull_simplify(flat, count, 5, fewer, &simple);
  mix((uint32_t)status);
  if (status == GJK_OK) {
    mix(simple.vertices);
    mix(simple.excess);
    for (uint32_t i = 0; i < simple.vertices; i++) {
      mix((uint32_t)fewer[i].x);
      mix((uint32_t)fewer[i].y);
    }
  }
}

static void take_flat_set(random_state *random) {
  const uint16_t count = make_points(random);
  simplify_flat_set(count);
  gjk2_hull hull;
  gjk2_mass body = {0}, part;
  gjk2_pose pose = GJK2_POSE_IDENTITY;
  const gjk_status status = gjk2_hull_build(flat, count, flat, &hull);
  mix((uint32_t)status);
  if (status != GJK_OK) {
    return;
  }
  mix(hull.dimension);
  mix_long(hull.twice_area);
  for (uint32_t i = 0; i < hull.vertices; i++) {
    mix((uint32_t)flat[i].x);
    mix((uint32_t)flat[i].y);
  }
  const gjk2_shape polygon = GJK2_POLYGON(flat, hull.vertices);
  const gjk_status found = gjk2_mass_of_shape(&polygon, &part);
  mix_flat_mass(found, &part);
  part.mass = 1 + random_below(random, 100000);
  pose.position.x = random_range(random, -100000, 100000);
  if (found == GJK_OK) {
    mix_flat_mass(gjk2_mass_add(&body, &part, &pose), &body);
    pose.position.x = -pose.position.x;
    mix_flat_mass(gjk2_mass_add(&body, &part, &pose), &body);
  }
}

uint64_t hull_golden_hash(uint32_t sets) {
  random_state random = random_seed(2031);
  hash = FNV_START;
  for (uint32_t i = 0; i < sets; i++) {
    take_set(&random);
    simplify_set(&random);
    take_flat_set(&random);
  }
  return hash;
}
