// Posed vertices against long double, for hulls at any distance from their own origin. Baked, lazy and moved colliders
// agree.
#include <math.h>
#include <string.h>

#include "check.h"
#include "gjk/gjk.h"
#include "random.h"
#include "same.h"
#include "src/shape/gjk_shape_class.h"

#define SEED 16384
#define ITERATIONS ((int)check_trials(20000))
#define VERTICES 6

// STATED: the largest error of a component that is promised, LSB. SEEN: the largest found must exceed it, or a smaller
// STATED could be promised.
#define STATED 0.75L
#define SEEN 0.6L

// The largest error of vertices, by the number of bits of the hull's distance from its origin in LSB.
static long double worst[32];

typedef struct real3 {
  long double x, y, z;
} real3;

// v turned by q / |q|: v + 2 (w t + u x t) / |q|^2 for q = u + w and t = u x v.
static real3 real_turned(const gjk_quat *q, const gjk_vec3 *v) {
  const long double x = q->x, y = q->y, z = q->z, w = q->w, two = 2 / (x * x + y * y + z * z + w * w);
  const long double a = y * v->z - z * v->y, b = z * v->x - x * v->z, c = x * v->y - y * v->x;
  return (real3){v->x + two * (w * a + y * c - z * b), v->y + two * (w * b + z * a - x * c),
                 v->z + two * (w * c + x * b - y * a)};
}

// A unit quaternion. Some are as far off unit length as poses accept, some turn about an axis.
static gjk_quat random_turn(random_state *random) {
  gjk_quat q = {random_range(random, -1000, 1000), random_range(random, -1000, 1000), random_range(random, -1000, 1000),
                random_range(random, 1, 1000)};
  const uint32_t kind = random_below(random, 8);
  q.x = kind == 0 ? 0 : q.x;
  q.y = kind <= 1 ? 0 : q.y;
  CHECK(gjk_quat_normalize(&q, &q) == GJK_OK);
  const int32_t off = random_range(random, -8000, 8000);
  if (kind >= 4) {
    q.x += (int32_t)((int64_t)q.x * off / GJK_Q30_ONE);
    q.y += (int32_t)((int64_t)q.y * off / GJK_Q30_ONE);
    q.z += (int32_t)((int64_t)q.z * off / GJK_Q30_ONE);
    q.w += (int32_t)((int64_t)q.w * off / GJK_Q30_ONE);
  }
  return q;
}

static gjk_vec3 random_about(random_state *random, gjk_vec3 middle, int32_t reach) {
  return (gjk_vec3){middle.x + random_range(random, -reach, reach), middle.y + random_range(random, -reach, reach),
                    middle.z + random_range(random, -reach, reach)};
}

static int32_t opposite(long double x) {
  return (int32_t)fminl(fmaxl(-x, -2147480000.0L), 2147480000.0L);
}

static long double error_of(const gjk_collider *c, const gjk_vec3 *offset, const gjk_pose *pose, const gjk_vec3 *v) {
  const real3 real = real_turned(&pose->rotation, v);
  const long double x = fabsl((long double)c->centre.x + offset->x - pose->position.x - real.x);
  const long double y = fabsl((long double)c->centre.y + offset->y - pose->position.y - real.y);
  const long double z = fabsl((long double)c->centre.z + offset->z - pose->position.z - real.z);
  return fmaxl(x, fmaxl(y, z));
}

static bool within_core(const gjk_collider *c, const gjk_vec3 *offset) {
  const int64_t x = offset->x, y = offset->y, z = offset->z;
  return x * x + y * y + z * z <= (int64_t)c->core_radius * c->core_radius;
}

static bool place(gjk_collider *c, const gjk_shape *shape, gjk_vec3 *buffer, const gjk_pose *pose) {
  memset(c, 0, sizeof *c);
  CHECK(gjk_collider_init(c, shape, buffer, VERTICES) == GJK_OK);
  return gjk_collider_pose(c, pose) == GJK_OK;
}

static void check_random_pose(random_state *random, int trial) {
  // A distance of at most 2^30 along each axis. In the last class it is so large that the turned centre only just fits.
  const unsigned bits = random_below(random, 32);
  const int32_t distance = bits == 31 ? INT32_C(1200000000) : INT32_C(1) << bits;
  const int32_t reach = random_below(random, 4) == 0 ? INT32_C(154000000) : INT32_C(1) << random_below(random, 28);
  const gjk_vec3 origin = {0, 0, 0};
  gjk_vec3 middle = random_about(random, origin, distance - reach > 0 ? distance - reach : 0), vertices[VERTICES];
  for (int i = 0; i < VERTICES; i++) {
    vertices[i] = random_about(random, middle, reach);
  }
  const gjk_shape hull = GJK_HULL(vertices, VERTICES), triangle = GJK_TRIANGLE(vertices);
  gjk_pose pose = GJK_POSE_IDENTITY;
  pose.rotation = random_turn(random);
  const real3 far = real_turned(&pose.rotation, &middle);
  pose.position.x = opposite(far.x) + random_range(random, -200, 200);
  pose.position.y = opposite(far.y) + random_range(random, -200, 200);
  pose.position.z = opposite(far.z) + random_range(random, -200, 200);
  gjk_collider baked, lazy, sheet;
  gjk_vec3 buffer[VERTICES];
  CHECK_MSG(place(&baked, &hull, buffer, &pose), "trial %d, seed %d", trial, SEED);
  CHECK_MSG(place(&lazy, &hull, NULL, &pose), "trial %d, seed %d", trial, SEED);
  CHECK_MSG(place(&sheet, &triangle, NULL, &pose), "trial %d, seed %d", trial, SEED);
  const gjk_vec3 elsewhere = random_about(random, pose.position, 1000);
  for (int moved = 0; moved < 2; moved++) {
    for (uint16_t i = 0; i < VERTICES; i++) {
      gjk_vec3 offset;
      const long double error = error_of(&baked, &buffer[i], &pose, &vertices[i]);
      worst[bits] = error > worst[bits] ? error : worst[bits];
      CHECK_MSG(error < STATED, "trial %d, seed %d, vertex %u, 2^%u LSB away: %.3Lf LSB off", trial, SEED, i, bits,
                error);
      CHECK_MSG(within_core(&baked, &buffer[i]), "trial %d, seed %d, vertex %u: beyond the radius", trial, SEED, i);
      CHECK_MSG(hull.type->vertex(&lazy, i, &offset), "trial %d, seed %d, lazy vertex %u", trial, SEED, i);
      CHECK_MSG(same_vec3(&offset, &buffer[i]), "trial %d, seed %d, lazy vertex %u", trial, SEED, i);
      if (i < 3) {
        const long double of_sheet = error_of(&sheet, &sheet.frame[i], &pose, &vertices[i]);
        CHECK_MSG(of_sheet < STATED, "trial %d, seed %d, triangle: %.3Lf LSB off", trial, SEED, of_sheet);
      }
    }
    CHECK_MSG(same_vec3(&lazy.centre, &baked.centre), "trial %d, seed %d", trial, SEED);
    pose.position = elsewhere;
    CHECK(gjk_collider_move(&baked, &elsewhere) == GJK_OK);
    CHECK(gjk_collider_move(&lazy, &elsewhere) == GJK_OK);
    CHECK(gjk_collider_move(&sheet, &elsewhere) == GJK_OK);
  }
}

// The identity rotation moves vertices without rounding, also for the farthest possible corners.
static void test_identity(void) {
  static const gjk_vec3 corners[3] = {{INT32_MAX, INT32_MIN, INT32_MAX},
                                      {INT32_MAX - 1000, INT32_MIN + 77, INT32_MAX - 3},
                                      {INT32_MAX - 1, INT32_MIN + 9, 2147483600}};
  const gjk_shape triangle = GJK_TRIANGLE(corners);
  const gjk_pose pose = {{-5, 7, -99}, {0, 0, 0, GJK_Q30_ONE}};
  gjk_collider c;
  CHECK(place(&c, &triangle, NULL, &pose));
  for (int i = 0; i < 3; i++) {
    CHECK((int64_t)c.centre.x + c.frame[i].x == (int64_t)corners[i].x - 5);
    CHECK((int64_t)c.centre.y + c.frame[i].y == (int64_t)corners[i].y + 7);
    CHECK((int64_t)c.centre.z + c.frame[i].z == (int64_t)corners[i].z - 99);
  }
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  long double most = 0;
  for (int i = 0; i < ITERATIONS; i++) {
    check_random_pose(&random, i);
  }
  test_identity();
  for (int i = 0; i < 32; i++) {
    most = worst[i] > most ? worst[i] : most;
    printf("within 2^%d LSB of the origin: vertices at most %.3Lf LSB off\n", i, worst[i]);
  }
  CHECK_MSG(ITERATIONS < 20000 || most > SEEN, "%.3Lf", most);
  return check_done("collider_pose");
}
