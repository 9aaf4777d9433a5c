// Bodies of several parts against long double, and principal axes by what is left of the products of inertia.
#include <math.h>
#include <string.h>

#include "check.h"
#include "gjk/mass.h"
#include "gjk/pose.h"
#include "random.h"

typedef long double real;

static gjk_quat random_rotation(random_state *random) {
  gjk_quat q;
  do {
    q.x = random_range(random, -1000000, 1000000);
    q.y = random_range(random, -1000000, 1000000);
    q.z = random_range(random, -1000000, 1000000);
    q.w = random_range(random, -1000000, 1000000);
  } while (gjk_quat_normalize(&q, &q) != GJK_OK);
  return q;
}

static void matrix_of(const gjk_quat *q, real m[3][3]) {
  const real n = (real)q->x * q->x + (real)q->y * q->y + (real)q->z * q->z + (real)q->w * q->w;
  const real x = q->x, y = q->y, z = q->z, w = q->w;
  const real own[3][3] = {{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
                          {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
                          {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}};
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      m[i][j] = own[i][j] / n;
    }
  }
}

static void entries(const gjk_inertia *t, real m[3][3]) {
  m[0][0] = (real)t->xx;
  m[1][1] = (real)t->yy;
  m[2][2] = (real)t->zz;
  m[1][2] = m[2][1] = (real)t->yz;
  m[0][2] = m[2][0] = (real)t->zx;
  m[0][1] = m[1][0] = (real)t->xy;
}

// out = R T R'
static void rotate(real r[3][3], real t[3][3], real turned[3][3]) {
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      turned[i][j] = 0;
      for (int k = 0; k < 9; k++) {
        turned[i][j] += r[i][k / 3] * t[k / 3][k % 3] * r[j][k % 3];
      }
    }
  }
}

// A body in real numbers: mass, mass times centre, inertia about the origin of the frame.
typedef struct sum {
  real mass, first[3], inertia[3][3];
} sum;

static real at_of(const gjk_mass *m, int i) {
  const int32_t at[3] = {m->centre.x, m->centre.y, m->centre.z};
  return at[i] + (real)m->fraction[i] / 65536;
}

static void add_real(sum *s, const gjk_mass *part, const gjk_pose *pose) {
  real r[3][3], t[3][3], turned[3][3], at[3];
  const int32_t position[3] = {pose->position.x, pose->position.y, pose->position.z};
  matrix_of(&pose->rotation, r);
  entries(&part->inertia, t);
  rotate(r, t, turned);
  real squared = 0;
  for (int i = 0; i < 3; i++) {
    at[i] = position[i];
    for (int j = 0; j < 3; j++) {
      at[i] += r[i][j] * at_of(part, j);
    }
    squared += at[i] * at[i];
  }
  s->mass += part->mass;
  for (int i = 0; i < 3; i++) {
    s->first[i] += part->mass * at[i];
    for (int j = 0; j < 3; j++) {
      s->inertia[i][j] += part->mass * (turned[i][j] + (i == j ? squared : 0) - at[i] * at[j]);
    }
  }
}

static real largest_of(real t[3][3]) {
  real most = 0;
  for (int i = 0; i < 9; i++) {
    most = fmaxl(most, fabsl(t[i / 3][i % 3]));
  }
  return most;
}

static void check_sum(const sum *s, const gjk_mass *m, int parts, real span) {
  real centre[3], squared = 0, own[3][3];
  for (int i = 0; i < 3; i++) {
    centre[i] = s->first[i] / s->mass;
    squared += centre[i] * centre[i];
    CHECK_MSG(fabsl(at_of(m, i) - centre[i]) <= parts * 0x1p-8L, "centre %d off by %Lg", i, at_of(m, i) - centre[i]);
    CHECK(m->fraction[i] >= -32768 && m->fraction[i] <= 32767);
  }
  entries(&m->inertia, own);
  const real allowed = parts * (12 + 0x1p-26L * (largest_of(own) + span * span));
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      const real want = s->inertia[i][j] / s->mass - (i == j ? squared : 0) + centre[i] * centre[j];
      CHECK_MSG(fabsl(own[i][j] - want) <= allowed, "inertia %d %d: %Lf, not %Lf", i, j, own[i][j], want);
    }
  }
}

static void random_part(random_state *random, int32_t size, gjk_mass *part) {
  const int32_t a = 1 + (int32_t)random_below(random, (uint32_t)size),
                b = 1 + (int32_t)random_below(random, (uint32_t)size),
                c = 1 + (int32_t)random_below(random, (uint32_t)size);
  const gjk_vec3 v[4] = {{a, 0, b}, {-c, a, b}, {-b, -a, -c}, {a, b, c}};
  static const uint16_t corner[12] = {0, 1, 2, 0, 3, 1, 1, 3, 2, 0, 2, 3}, end[4] = {3, 6, 9, 12};
  static const uint16_t turned[12] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
  const gjk_hull_faces faces = {corner, end, 4}, other = {turned, end, 4};
  const gjk_shape box = GJK_BOX(a, b, c), capsule = GJK_CAPSULE(a, b), cone = GJK_CONE(a, b),
                  hull = GJK_HULL_WITH_FACES(v, 4, &faces), opposite = GJK_HULL_WITH_FACES(v, 4, &other);
  const gjk_shape *const shape[4] = {&box, &capsule, &cone, &hull};
  const uint32_t kind = random_below(random, 4);
  if (gjk_mass_of_shape(shape[kind], part) != GJK_OK) {
    CHECK(kind == 3 && gjk_mass_of_shape(&opposite, part) == GJK_OK);
  }
  part->mass = 1 + random_below(random, 1u << (1 + random_below(random, 27)));
}

static void test_random_bodies(uint64_t seed) {
  random_state random = random_seed(seed);
  for (unsigned long trial = 0; trial < 2000; trial++) {
    const int32_t size = INT32_C(2) << random_below(&random, 26), reach = INT32_C(1) << random_below(&random, 29);
    gjk_mass body = {0};
    sum s = {0};
    const int32_t offset = random_below(&random, 2) == 0 ? 0 : random_range(&random, -1000000000, 1000000000);
    check_trial(trial, NULL, NULL);
    const int parts = 1 + (int)random_below(&random, 6);
    uint64_t volume = 0;
    for (int i = 0; i < parts; i++) {
      gjk_mass part;
      gjk_pose pose = GJK_POSE_IDENTITY;
      random_part(&random, size, &part);
      pose.rotation = random_rotation(&random);
      pose.position.x = offset + random_range(&random, -reach, reach);
      pose.position.y = random_range(&random, -reach, reach);
      pose.position.z = random_range(&random, -reach, reach) - offset;
      CHECK(gjk_mass_add(&body, &part, &pose) == GJK_OK);
      // Reals about the body's first place, so that long double resolves them.
      gjk_pose near = pose;
      near.position.x -= offset;
      near.position.z += offset;
      add_real(&s, &part, &near);
      volume += part.volume.low;
    }
    CHECK(body.volume.low == volume);
    CHECK((real)body.mass == s.mass);
    body.centre.x -= offset;
    body.centre.z += offset;
    check_sum(&s, &body, parts, 2 * (real)reach + 4 * (real)size);
  }
}

// A box from eight of its octants, and a lone part at the identity: exact.
static void test_octants(void) {
  const gjk_shape octant = GJK_BOX(1000, 700, 3000), box = GJK_BOX(2000, 1400, 6000), capsule = GJK_CAPSULE(77, 991);
  gjk_mass part, whole, body = {0}, alone;
  memset(&alone, 0, sizeof alone);
  CHECK(gjk_mass_of_shape(&octant, &part) == GJK_OK && gjk_mass_of_shape(&box, &whole) == GJK_OK);
  part.mass = 5;
  for (unsigned i = 0; i < 8; i++) {
    gjk_pose pose = GJK_POSE_IDENTITY;
    pose.position.x = (i & 1) != 0 ? 1000 : -1000;
    pose.position.y = (i & 2) != 0 ? 700 : -700;
    pose.position.z = (i & 4) != 0 ? 3000 : -3000;
    CHECK(gjk_mass_add(&body, &part, &pose) == GJK_OK);
  }
  CHECK(body.mass == 40 && body.volume.low == whole.volume.low && body.volume.high == 0);
  CHECK(body.centre.x == 0 && body.centre.y == 0 && body.centre.z == 0);
  CHECK(llabs(body.inertia.xx - whole.inertia.xx) <= 8 && llabs(body.inertia.zz - whole.inertia.zz) <= 8);
  const gjk_pose identity = GJK_POSE_IDENTITY;
  CHECK(gjk_mass_of_shape(&capsule, &part) == GJK_OK);
  part.mass = 3;
  CHECK(gjk_mass_add(&alone, &part, &identity) == GJK_OK &&
        memcmp(&alone.inertia, &part.inertia, sizeof part.inertia) == 0);
  CHECK(alone.mass == 3 && alone.volume.low == part.volume.low);
}

static void test_refusals(void) {
  const gjk_shape cube = GJK_BOX(10, 10, 10);
  gjk_mass body = {0}, part, kept;
  gjk_pose pose = GJK_POSE_IDENTITY;
  CHECK(gjk_mass_of_shape(&cube, &part) == GJK_OK);
  CHECK(gjk_mass_add(&body, &part, &pose) == GJK_ERROR_RANGE);  // no mass
  part.mass = UINT32_MAX;
  CHECK(gjk_mass_add(NULL, &part, &pose) == GJK_ERROR_NULL && gjk_mass_add(&body, NULL, &pose) == GJK_ERROR_NULL);
  CHECK(gjk_mass_add(&body, &part, NULL) == GJK_ERROR_NULL && gjk_mass_add(&part, &part, &pose) == GJK_ERROR_OVERLAP);
  pose.rotation.w = 0;
  CHECK(gjk_mass_add(&body, &part, &pose) == GJK_ERROR_ROTATION && body.mass == 0);
  pose.rotation.w = GJK_Q30_ONE;
  CHECK(gjk_mass_add(&body, &part, &pose) == GJK_OK && body.mass == UINT32_MAX);
  part.mass = 1;
  kept = body;
  CHECK(gjk_mass_add(&body, &part, &pose) == GJK_ERROR_RANGE);  // 2^32 in all
  body.mass--;
  pose.position.x = (INT32_C(1) << 30) + 1;
  CHECK(gjk_mass_add(&body, &part, &pose) == GJK_ERROR_RANGE);  // too far apart
  part.centre.x = 1;
  pose.position.x = INT32_MAX;
  body.centre.x = INT32_MAX;
  CHECK(gjk_mass_add(&body, &part, &pose) == GJK_ERROR_RANGE);  // outside int32
  part.centre.x = 0;
  CHECK(gjk_mass_add(&body, &part, &pose) == GJK_OK && body.mass == UINT32_MAX && body.centre.x == INT32_MAX);
  pose.position.x = body.centre.x = INT32_MIN;
  body.mass--;
  part.centre.x = -1;
  CHECK(gjk_mass_add(&body, &part, &pose) == GJK_ERROR_RANGE);  // on the other side
  part.centre.x = 0;
  CHECK(gjk_mass_add(&body, &part, &pose) == GJK_OK && body.mass == UINT32_MAX && body.centre.x == INT32_MIN);
  body = kept;
  body.mass = 1;
  part.inertia.xx = (INT64_C(1) << 60) + 1;
  pose.position.x = 0;
  CHECK(gjk_mass_add(&body, &part, &pose) == GJK_ERROR_RANGE);
  part.inertia.xx--;
  pose.position.y = INT32_C(1) << 30;
  CHECK(gjk_mass_add(&body, &part, &pose) == GJK_OK);  // 2^59 and 2^58 together
  kept = body;
  body.inertia.xx = part.inertia.xx;
  CHECK(gjk_mass_add(&body, &part, &pose) == GJK_ERROR_RANGE);  // each fits, not their sum
  body = kept;
  gjk_principal axes;
  CHECK(gjk_mass_principal(NULL, &axes) == GJK_ERROR_NULL && gjk_mass_principal(&body, NULL) == GJK_ERROR_NULL);
  body.inertia.yz = -(INT64_C(1) << 60) - 1;
  CHECK(gjk_mass_principal(&body, &axes) == GJK_ERROR_RANGE && gjk_mass_add(&body, &part, &pose) == GJK_ERROR_RANGE);
}

// The residual: products of inertia in the frame of the axes as they are rounded, and the moments. *turned: by the
// quaternion's angle. Returns the larger residual in parts of what is allowed.
static real check_axes(const gjk_inertia *t, gjk_principal *axes) {
  gjk_mass m = {0};
  real r[3][3], own[3][3], seen[3][3], back[3][3];
  m.inertia = *t;
  CHECK(gjk_mass_principal(&m, axes) == GJK_OK);
  matrix_of(&axes->rotation, r);
  for (int i = 0; i < 9; i++) {
    back[i % 3][i / 3] = r[i / 3][i % 3];
  }
  entries(t, own);
  rotate(back, own, seen);
  const real largest = largest_of(own),
             products = fmaxl(fmaxl(fabsl(seen[0][1]), fabsl(seen[1][2])), fabsl(seen[0][2]));
  // The view of the tensor is off by 12, in a unit of the scaled tensor, and by the matrix.
  CHECK_MSG(products <= fmaxl(0x1p-26L * largest, 8) + 0x1p-28L * largest, "product %Lg of %Lg", products, largest);
  for (int i = 0; i < 3; i++) {
    CHECK_MSG(fabsl(seen[i][i] - (real)axes->moment[i]) <= fmaxl(0x1p-27L * largest, 2), "moment %Lg of %Lg",
              seen[i][i] - (real)axes->moment[i], largest);
  }
  const real n = (real)axes->rotation.x * axes->rotation.x + (real)axes->rotation.y * axes->rotation.y +
                 (real)axes->rotation.z * axes->rotation.z + (real)axes->rotation.w * axes->rotation.w;
  CHECK(fabsl(n / 0x1p60L - 1) < 0x1p-28L);
  return products / fmaxl(0x1p-26L * largest, 8);
}

static bool is_identity(const gjk_quat *q) {
  return q->x == 0 && q->y == 0 && q->z == 0 && q->w == GJK_Q30_ONE;
}

static void test_principal(uint64_t seed) {
  random_state random = random_seed(seed);
  gjk_principal axes;
  real worst = 0;
  unsigned turned = 0;
  for (unsigned long trial = 0; trial < 20000; trial++) {
    // Any symmetric tensor, of moments near and far from each other.
    const int64_t size = INT64_C(1) << random_below(&random, 60);
    const uint32_t kind = random_below(&random, 5);
    real moment[3], r[3][3], diagonal[3][3] = {{0}}, full[3][3];
    check_trial(trial, NULL, NULL);
    for (int i = 0; i < 3; i++) {
      moment[i] = (real)size * (real)random_u32(&random) / 0x1p32L;
    }
    moment[1] = kind == 1 ? moment[0] : kind == 2 ? moment[0] * (1 + 1e-7L) : moment[1];
    moment[2] = kind == 3 ? moment[1] : kind == 4 ? moment[0] + moment[1] : moment[2] / 2;
    const gjk_quat q = random_rotation(&random);
    matrix_of(&q, r);
    for (int i = 0; i < 3; i++) {
      diagonal[i][i] = fminl(moment[i], (real)size);
    }
    rotate(r, diagonal, full);
    const gjk_inertia t = {(int64_t)full[0][0], (int64_t)full[1][1], (int64_t)full[2][2],
                           (int64_t)full[1][2], (int64_t)full[0][2], (int64_t)full[0][1]};
    worst = fmaxl(worst, check_axes(&t, &axes));
    turned += !is_identity(&axes.rotation);
  }
  CHECK_MSG(turned > 10000 && turned < 20000, "%u", turned);
  printf("largest product of inertia left: %.3Lf of what is allowed\n", worst);
}

// Equal moments, small tensors and diagonal ones: the identity. A quarter of a turn is not taken for nothing.
static void test_ties(void) {
  static const gjk_inertia tied[] = {{0, 0, 0, 0, 0, 0},
                                     {1, 1, 1, 0, 0, 0},
                                     {5, 1, 3, 2, -1, 1},
                                     {INT64_C(1) << 60, INT64_C(1) << 60, INT64_C(1) << 60, 0, 0, 0},
                                     {INT64_C(1) << 60, 1, 2, 0, 0, 0},
                                     {900, 5000000000, 1, 0, 0, 0},
                                     {INT64_C(1) << 40, INT64_C(1) << 40, INT64_C(1) << 40, 5, -7, 8}};
  gjk_principal axes;
  for (unsigned i = 0; i < sizeof tied / sizeof tied[0]; i++) {
    check_trial(i, NULL, NULL);
    check_axes(&tied[i], &axes);
    CHECK(is_identity(&axes.rotation));
    CHECK(axes.moment[0] == tied[i].xx && axes.moment[1] == tied[i].yy && axes.moment[2] == tied[i].zz);
  }
  const gjk_inertia swapped = {100000, 100000, 5000, 0, 0, 40000};  // 45 degrees about z
  check_axes(&swapped, &axes);
  CHECK(axes.moment[0] == 140000 && axes.moment[1] == 60000 && axes.moment[2] == 5000);
  const gjk_inertia alike = {100000, 200000, 400000,
                             30000,  30000,  -30000};  // of equal products that about x goes first
  const gjk_quat bits = {-63256374, 55102226, 158329527, 1058685809};
  check_axes(&alike, &axes);
  CHECK(memcmp(&axes.rotation, &bits, sizeof bits) == 0);
  CHECK(axes.moment[0] == 87281 && axes.moment[1] == 206185 && axes.moment[2] == 406534);
  const gjk_shape cube = GJK_BOX(65536, 65536, 65536);
  gjk_mass m;
  CHECK(gjk_mass_of_shape(&cube, &m) == GJK_OK && gjk_mass_principal(&m, &axes) == GJK_OK);
  CHECK(is_identity(&axes.rotation) && axes.moment[0] == m.inertia.xx);
}

int main(void) {
  const uint64_t seed = check_seed(1871);
  test_random_bodies(seed);
  test_octants();
  test_refusals();
  test_principal(seed);
  test_ties();
  return check_done("mass add");
}
