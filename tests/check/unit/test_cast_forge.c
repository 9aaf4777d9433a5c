// gjk_check_cast and forged results: each field of a proven cast, changed by an LSB or more, and certificates that name other
// proofs, vertices that don't exist, and directions that are too long.
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "random.h"

// The test of the plane has included the plane's.
#ifndef TEST_NAME
#include "gjk/cast.h"
#include "gjk/gjk.h"
#include "src/motion/gjk_spheres.h"
#define TEST_NAME "cast_forge"
#define SPACE 1
#endif

#include "placed.h"

#define SEED 5150
#define TRIALS check_trials(6000)
#define AXES (SPACE ? 3 : 2)
#define CORNERS 6

typedef struct trial {
  gjk_vec3 corners[2][CORNERS];
  gjk_shape shape[2];
  gjk_collider collider[2];
  gjk_pose pose[2];
  gjk_vec3 to[2];
  gjk_cast_path path;
  gjk_cast_result result;
} trial;

// Components of a result, which a hit later on the way proves one by one.
typedef struct field {
  size_t offset;
  int count;
} field;

#define OF(member, components) \
  { .offset = offsetof(gjk_cast_result, member), .count = (components) }
static const field fields[] = {OF(fraction, 1),  OF(point_a, AXES), OF(point_b, AXES),
                               OF(normal, AXES), OF(rest_a, AXES),  OF(rest_b, AXES)};

static struct { unsigned long proven, hits, inside, rounded, fields, certificates, ways, fewer, by_corners[4]; } tally;

static int64_t size_of(int64_t x) {
  return x < 0 ? -x : x;
}

static gjk_vec3 spread(random_state *random, int32_t most) {
#if SPACE
  const gjk_vec3 v = {random_range(random, -most, most), random_range(random, -most, most),
                      random_range(random, -most, most)};
#else
  const gjk_vec3 v = {random_range(random, -most, most), random_range(random, -most, most)};
#endif
  return v;
}

// Leaves axes of a vector: 2 for a plane that the way lies in, 1 for its line.
static gjk_vec3 flattened(gjk_vec3 v, int axes) {
  if (axes < 2) {
    v.y = 0;
  }
#if SPACE
  if (axes < 3) {
    v.z = 0;
  }
#endif
  return v;
}

static gjk_shape random_shape(random_state *random, gjk_vec3 *corners, int32_t size, gjk_q16 radius, int axes) {
  const uint32_t kind = axes < AXES ? 2 + random_below(random, 3) : random_below(random, 5);
  for (int i = 0; i < CORNERS; i++) {
    corners[i] = flattened(spread(random, size), axes);
  }
#if SPACE
  const gjk_shape shapes[] = {GJK_ROUNDED_BOX(size, size / 2, size / 3, radius), GJK_CAPSULE(size, radius),
                              GJK_SPHERE(radius), GJK_ROUNDED_TRIANGLE(corners, radius),
                              GJK_ROUNDED_HULL(corners, CORNERS, radius)};
#else
  const gjk_shape shapes[] = {GJK2_ROUNDED_BOX(size, size / 2, radius), GJK2_CAPSULE(size, radius), GJK2_CIRCLE(radius),
                              GJK2_ROUNDED_TRIANGLE(corners, radius), GJK2_ROUNDED_POLYGON(corners, CORNERS, radius)};
#endif
  return shapes[kind];
}

static void make(random_state *random, trial *t) {
  static const int32_t sizes[] = {9, 1000, 70000, 30000000};
  const int32_t size = sizes[random_below(random, 4)];
  const bool rounded = random_below(random, 3) == 0;
  const int axes = random_below(random, 4) != 0 ? AXES : random_below(random, 4) != 0 ? 2 : 1;
  for (int i = 0; i < 2; i++) {
    const gjk_q16 radius = rounded && random_below(random, 2) == 0 ? random_range(random, 1, size) : 0;
    gjk_pose pose = GJK_POSE_IDENTITY;
    t->shape[i] = random_shape(random, t->corners[i], size, radius, axes);
    pose.position = flattened(spread(random, i == 0 ? 99 : random_below(random, 4) == 0 ? size : 4 * size), axes);
#if SPACE
    const gjk_quat any = {random_range(random, -9, 9), random_range(random, -9, 9), random_range(random, -9, 9), 5};
#else
    const gjk_quat any = {random_range(random, -9, 9), 5};
#endif
    if (axes == AXES && random_below(random, 2) == 0) {
      CHECK(gjk_quat_normalize(&any, &pose.rotation) == GJK_OK);
    }
    t->pose[i] = pose;
    t->collider[i] = posed(&t->shape[i], &pose);
    t->to[i] = flattened(spread(random, i == 0 ? size : 2 * size), axes);
  }
  t->path = (gjk_cast_path){random_below(random, 3) == 0 ? &t->to[0] : NULL, &t->to[1],
                            rounded ? random_range(random, 0, size / 4) : 0};
}

static gjk_status status_of(const trial *t, const gjk_cast_result *r) {
  return gjk_check_cast(&t->collider[0], &t->collider[1], &t->path, r);
}

static void refuse(const trial *t, const gjk_cast_result *wrong, const char *what) {
  CHECK_MSG(status_of(t, wrong) == GJK_ERROR_UNPROVEN, "%s", what);
}

// Each field of a hit that the check looks at.
static void forge_fields(random_state *random, const trial *t, bool rounded) {
  const gjk_cast_result *right = &t->result;
  gjk_cast_result wrong = *right;
  for (size_t i = 0; i < sizeof fields / sizeof fields[0]; i++) {
    const bool points = i == 1 || i == 2;
    // In space a radius leaves the fields to queries at rest; in the plane the fraction has room.
    if ((right->inside && SPACE && points) || (rounded && ((SPACE && !right->inside) || i == 0))) {
      continue;
    }
    for (int k = 0; k < fields[i].count; k++) {
      int32_t value;
      char *at = (char *)&wrong + fields[i].offset + (size_t)k * sizeof value;
      wrong = *right;
      memcpy(&value, at, sizeof value);
      value += random_below(random, 2) == 0 ? 1 : -1;
      memcpy(at, &value, sizeof value);
      CHECK_MSG(status_of(t, &wrong) == GJK_ERROR_UNPROVEN, "field %u, component %d", (unsigned)i, k);
      tally.fields++;
    }
  }
  wrong = *right;
  wrong.saturated = !right->saturated;
  if (!rounded || right->inside || !SPACE) {
    refuse(t, &wrong, "saturated");
  }
  if (rounded && !right->inside) {
    wrong = *right;
    wrong.fraction = GJK_Q30_ONE + 1;
    refuse(t, &wrong, "fraction above 1");
    wrong.fraction = -1;
    refuse(t, &wrong, "fraction below 0");
  }
}

// Certificates that prove nothing. A miss may have another proof that is right as well, so there only the end is asked for.
static void forge_certificate(random_state *random, const trial *t, bool rounded, bool apart) {
  const gjk_cast_result *right = &t->result;
  const bool named = right->certificate.count > 0, swept = SPACE && rounded;
  gjk_cast_result wrong = *right;
  if (apart || (swept && !right->inside)) {
    return;  // settled without a certificate
  }
  for (uint8_t proof = 0; proof < 8; proof++) {
    wrong = *right;
    wrong.certificate.proof = proof;
    const gjk_status status = status_of(t, &wrong);
    CHECK(proof == right->certificate.proof || (swept && proof != 0) || !right->hit ? status != GJK_ERROR_UNSUPPORTED
                                                                                    : status == GJK_ERROR_UNPROVEN);
    tally.certificates++;
  }
  if (right->inside) {
    return;
  }
  for (unsigned i = 0; i < right->certificate.count; i++) {
    wrong = *right;
    wrong.certificate.a[i] = (uint16_t)(60000 + random_below(random, 5000));
    refuse(t, &wrong, "no such vertex of A");
    wrong = *right;
    wrong.certificate.b[i] = (uint16_t)(60000 + random_below(random, 5000));
    refuse(t, &wrong, "no such vertex of B");
  }
  for (uint8_t count = 0; count < 7; count++) {
    wrong = *right;
    wrong.certificate.count = count;
    const bool same = count == right->certificate.count;
    CHECK_MSG(same || !right->hit || status_of(t, &wrong) == GJK_ERROR_UNPROVEN || (!SPACE && count < 3), "%u corners",
              count);
  }
  if (named) {
    tally.by_corners[right->certificate.count]++;
  }
  // Directions longer than any that is reported.
  const gjk_vec3 was = right->certificate.direction;
  const bool directed = !SPACE || right->certificate.count < 3;
  for (int k = 0; k < AXES && directed; k++) {
    int32_t component;
    wrong = *right;
    memcpy(&component, (const char *)&was + (size_t)k * sizeof component, sizeof component);
    for (int i = 0; i < 3; i++) {
      const int32_t tried[] = {component < 0 ? INT32_MIN : INT32_MAX, component < 0 ? -1900000000 : 1900000000,
                               component + (size_of(component) < 100 ? 1 : component / 3)};
      memcpy((char *)&wrong.certificate.direction + (size_t)k * sizeof component, &tried[i], sizeof component);
      CHECK_MSG(!right->hit || i == 2 || status_of(t, &wrong) == GJK_ERROR_UNPROVEN, "direction, component %d: %ld", k,
                (long)tried[i]);
      (void)status_of(t, &wrong);
    }
  }
}

static gjk_vec3 part_of(const gjk_vec3 *from, const gjk_vec3 *to, int64_t numerator, int64_t denominator) {
  gjk_vec3 v = *from;
  v.x += (gjk_q16)(((int64_t)to->x - from->x) * numerator / denominator);
  v.y += (gjk_q16)(((int64_t)to->y - from->y) * numerator / denominator);
#if SPACE
  v.z += (gjk_q16)(((int64_t)to->z - from->z) * numerator / denominator);
#endif
  return v;
}

// A true hit is not one of another way: of one that ends before, of one that leads away, and from a start beyond.
static void forge_way(const trial *t) {
  const gjk_cast_result *r = &t->result;
  const gjk_vec3 *from = &t->collider[1].position, *to = t->path.to_b;
  const gjk_vec3 early = part_of(from, to, r->fraction / 2, GJK_Q30_ONE), away = part_of(from, to, -1, 1);
  const gjk_cast_path ends = {NULL, &early, t->path.margin}, leaves = {NULL, &away, t->path.margin};
  const gjk_collider *a = &t->collider[0], *b = &t->collider[1];
  gjk_collider later = *b;
  gjk_cast_result there;
  CHECK(gjk_check_cast(a, b, &ends, r) != GJK_OK);
  CHECK(gjk_check_cast(a, b, &leaves, r) != GJK_OK);
  const gjk_vec3 beyond = part_of(from, to, 3, 1), end = part_of(&beyond, to, 2, 1);
  const gjk_cast_path on = {NULL, &end, t->path.margin};
  CHECK(gjk_collider_move(&later, &beyond) == GJK_OK && gjk_cast(a, &later, &on, &there) == GJK_OK);
  // The same fraction may be one there as well, of another facet.
  CHECK(gjk_check_cast(a, &later, &on, r) != GJK_OK || (there.hit && !there.inside));
  tally.ways++;
}

// What holds for fewer of a shape's corners is no claim about all of them, unless it is the same. With a radius the fraction
// is not proven.
static void forge_fewer(random_state *random, const trial *t, bool rounded) {
  for (int i = 0; i < 2; i++) {
    gjk_shape few = t->shape[i];
    gjk_collider pair[2] = {t->collider[0], t->collider[1]};
    gjk_cast_result claim = {0};
    if (few.vertices == NULL || few.count < CORNERS) {
      continue;
    }
    few.count = (uint16_t)(1 + random_below(random, CORNERS - 1));
    pair[i] = posed(&few, &t->pose[i]);
    CHECK(gjk_cast(&pair[0], &pair[1], &t->path, &claim) == GJK_OK);
    if (claim.hit != t->result.hit || claim.inside != t->result.inside ||
        (!rounded && claim.fraction != t->result.fraction)) {
      refuse(t, &claim, "fewer corners");
      tally.fewer++;
    }
  }
}

// Is a miss proven without a certificate? A short way names a facet also where the spheres alone would do.
static bool is_apart(const trial *t, int64_t radius) {
#if SPACE
  gjk_way way;
  return !t->result.hit && gjk_way_set(&way, &t->collider[0], &t->collider[1], &t->path) == GJK_OK &&
         gjk_spheres_part(&t->collider[0], &t->collider[1], &way, radius);
#else
  (void)radius;
  return t->result.certificate.proof == GJK2_CAST_PROOF_SPHERES;
#endif
}

static void check(random_state *random, trial *t) {
  memset(&t->result, 0, sizeof t->result);
  CHECK(gjk_cast(&t->collider[0], &t->collider[1], &t->path, &t->result) == GJK_OK);
  const gjk_cast_result *r = &t->result;
  const int64_t radius = (int64_t)t->shape[0].convex_radius + t->shape[1].convex_radius + t->path.margin;
  if (status_of(t, r) != GJK_OK) {
    // In the plane a hit that grazes may have no line to show for it.
    CHECK(!SPACE && radius > 0 && r->hit && status_of(t, r) == GJK_ERROR_UNPROVEN);
    return;
  }
  const bool apart = is_apart(t, radius);
#if SPACE
  CHECK(apart || r->certificate.proof != GJK_CAST_PROOF_SPHERES);
#endif
  gjk_cast_result wrong = *r;
  tally.proven++;
  tally.hits += r->hit;
  tally.inside += r->inside;
  tally.rounded += radius > 0;
  wrong.hit = !r->hit;
  refuse(t, &wrong, "hit or miss");
  if (r->hit) {
    wrong = *r;
    wrong.inside = !r->inside;
    refuse(t, &wrong, "inside");
    forge_fields(random, t, radius > 0);
    if (!r->inside && r->fraction > 4 && t->path.to_a == NULL) {
      forge_way(t);
    }
  }
  forge_certificate(random, t, radius > 0, apart);
  forge_fewer(random, t, radius > 0);
}

#if SPACE
// Boxes 800 LSB apart, and claims of a miss at the ends of what holds: one that touches where it ends or starts is none, and
// directions are at most 2^30 long.
static void check_ends(void) {
  static const gjk_shape box = GJK_BOX(100, 100, 100);
  const gjk_collider a = placed_at(&box, 0, 0, 0), b = placed_at(&box, 1000, 0, 0), beside = placed_at(&box, 200, 0, 0);
  const gjk_vec3 touch = {200, 0, 0}, short_of = {201, 0, 0}, from = {1000, 0, 0};
  const gjk_cast_path touching = {NULL, &touch, 0}, missing = {NULL, &short_of, 0}, away = {NULL, &from, 0};
  gjk_cast_result claim;
  CHECK(gjk_cast(&a, &b, &missing, &claim) == GJK_OK && !claim.hit);
  claim.certificate.proof = GJK_CAST_PROOF_SHORT;
  claim.certificate.count = 0;
  claim.certificate.direction = (gjk_vec3){1, 0, 0};
  CHECK(gjk_check_cast(&a, &b, &missing, &claim) == GJK_OK);
  CHECK(gjk_check_cast(&a, &b, &touching, &claim) == GJK_ERROR_UNPROVEN);
  CHECK(gjk_check_cast(&a, &beside, &away, &claim) == GJK_ERROR_UNPROVEN);
  for (int32_t aside = 0; aside <= 1 << 20; aside += 1 << 20) {
    claim.certificate.direction = (gjk_vec3){INT32_C(1) << 30, aside, 0};
    CHECK(gjk_check_cast(&a, &b, &missing, &claim) == (aside == 0 ? GJK_OK : GJK_ERROR_UNPROVEN));
  }
}
#endif

int main(void) {
#if SPACE
  check_ends();
#endif
  random_state random = random_seed(check_seed(SEED));
  const unsigned long trials = TRIALS;
  static trial t;
  for (unsigned long i = 0; i < trials; i++) {
    check_trial(i, NULL, NULL);
    make(&random, &t);
    check(&random, &t);
  }
  printf(
      "%lu proven: %lu hits, %lu at the start, %lu with a radius; forged: %lu fields, %lu proofs; by corners %lu %lu "
      "%lu; %lu of fewer corners\n",
      tally.proven, tally.hits, tally.inside, tally.rounded, tally.fields, tally.certificates, tally.by_corners[1],
      tally.by_corners[2], tally.by_corners[3], tally.fewer);
  CHECK(tally.proven > trials * 9 / 10 && tally.hits > trials / 6 && tally.hits < trials * 5 / 6);
  CHECK(tally.ways > trials / 20 && tally.fewer > trials / 20 && tally.inside > trials / 50 &&
        tally.rounded > trials / 10);
  CHECK(trials < 1000 ||
        (tally.by_corners[1] > 10 && tally.by_corners[2] > 20 && (tally.by_corners[3] > 20 || !SPACE)));
  return check_done(TEST_NAME);
}
