// gjk/mass.h on any input: shapes of every kind, sizes, radii, faces of any corners; bodies, poses and densities of any
// content; null pointers too.
#include "gjk/mass.h"

#include "any.h"
#include "gjk/shape.h"
#include "src/arith/gjk_big.h"
#include "src/shape/gjk_shape_class.h"

// Values of CASE.
#define PLAIN 1
#define ROUND 2
#define FACES 3
#define ADD 4
#define PRINCIPAL 5

#define VERTICES 4
#define CORNERS 4

// What the classes measure, as tests/prove/shape.c shows: sizes at most GJK_RADIUS_MAX, or an error.
static gjk_status any_measure_of(const gjk_shape *shape, gjk_extent *out) {
  (void)shape;
  out->squared = (uint64_t)Frama_C_long_long_interval(0, INT64_C(1) << 58);
  return any_bool() ? GJK_OK : GJK_ERROR_SIZE;
}

static void check_mass(int status, const gjk_mass *m) {
  //@ split status;
  if (status == GJK_OK) {
    //@ assert \initialized(&m->volume.high) && \initialized(&m->volume.low) && \initialized(&m->mass);
    //@ assert \initialized(&m->centre.x) && \initialized(&m->centre.y) && \initialized(&m->centre.z);
    //@ assert \initialized(&m->inertia.xx) && \initialized(&m->inertia.xy) && \initialized(&m->fraction[2]);
  }
}

#if CASE == PLAIN || CASE == ROUND || CASE == FACES
static void any_mass_of(const gjk_shape *shape) {
  gjk_mass mass;
  const int status = gjk_mass_of_shape(any_bool() ? shape : NULL, any_bool() ? &mass : NULL);
  check_mass(status, &mass);
}

static void take_shape(unsigned kind, unsigned count, bool rounded) {
  static gjk_vec3 vertices[VERTICES];
  static uint16_t corner[CORNERS];
  static uint16_t end[1];
  const gjk_shape_class type = {.measure = any_measure_of, .count = (uint8_t)count, .kind = (uint8_t)kind};
  for (int i = 0; i < VERTICES; i++) {
    vertices[i] = any_vec3(GJK_RADIUS_MAX);
  }
  for (int i = 0; i < CORNERS; i++) {
    corner[i] = (uint16_t)any_between(0, VERTICES - 1);
  }
  end[0] = CORNERS;
  const gjk_hull_faces faces = {corner, end, 1};
  gjk_shape shape = {0};
  shape.type = &type;
  shape.vertices = vertices;
  shape.size.x = any_between(0, GJK_RADIUS_MAX);
  shape.size.y = any_between(0, GJK_RADIUS_MAX);
  shape.size.z = any_between(0, GJK_RADIUS_MAX);
  shape.convex_radius = rounded ? any_between(1, GJK_RADIUS_MAX) : 0;
  shape.count = (uint16_t)any_between(1, VERTICES);
  shape.faces = CASE == FACES ? &faces : NULL;
  any_mass_of(&shape);
}
#else
static gjk_mass any_mass(void) {
  gjk_mass m;
  m.volume.high = (uint64_t)any_int32() << 32 | (uint32_t)any_int32();
  m.volume.low = (uint64_t)any_int32() << 32 | (uint32_t)any_int32();
  m.mass = (uint32_t)any_int32();
  m.centre = any_position();
  m.fraction[0] = (int16_t)any_between(INT16_MIN, INT16_MAX);
  m.fraction[1] = (int16_t)any_between(INT16_MIN, INT16_MAX);
  m.fraction[2] = (int16_t)any_between(INT16_MIN, INT16_MAX);
  m.inertia.xx = Frama_C_long_long_interval(INT64_MIN, INT64_MAX);
  m.inertia.yy = Frama_C_long_long_interval(INT64_MIN, INT64_MAX);
  m.inertia.zz = Frama_C_long_long_interval(INT64_MIN, INT64_MAX);
  m.inertia.yz = Frama_C_long_long_interval(INT64_MIN, INT64_MAX);
  m.inertia.zx = Frama_C_long_long_interval(INT64_MIN, INT64_MAX);
  m.inertia.xy = Frama_C_long_long_interval(INT64_MIN, INT64_MAX);
  return m;
}
#endif

int main(void) {
#if CASE == PLAIN || CASE == ROUND
  take_shape(GJK_KIND_SMOOTH, 0, CASE == ROUND);
  take_shape(GJK_KIND_CONE, 3, CASE == ROUND);
  take_shape(GJK_KIND_CYLINDER, 3, CASE == ROUND);
  take_shape(GJK_KIND_AXES, (unsigned)any_between(0, 3), CASE == ROUND);
  take_shape(GJK_KIND_VERTICES, 0, CASE == ROUND);
#elif CASE == FACES
  take_shape(GJK_KIND_VERTICES, 0, false);
#elif CASE == ADD
  gjk_mass body = any_mass();
  const gjk_mass part = any_mass();
  const gjk_pose pose = any_pose();
  const int status = gjk_mass_add(any_bool() ? &body : NULL,
                                  any_bool()   ? &part
                                  : any_bool() ? &body
                                               : NULL,
                                  any_bool() ? &pose : NULL);
  check_mass(status, &body);
  (void)gjk_mass_set_density(any_bool() ? &body : NULL, (uint32_t)any_int32());
#else
  const gjk_mass body = any_mass();
  gjk_principal axes;
  const int status = gjk_mass_principal(any_bool() ? &body : NULL, any_bool() ? &axes : NULL);
  //@ split status;
  if (status == GJK_OK) {
    //@ assert \initialized(&axes.rotation.w) && \initialized(&axes.moment[2]);
  }
#endif
  return 0;
}
