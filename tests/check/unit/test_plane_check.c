// gjk2_check_decision, _distance and _penetration: every answer of a query is proven, and no forged one.
#include "plane.h"

#define SEED 2003
#define TRIALS check_trials(30000)

static struct { unsigned long proven, refused, survived; } tally;

// Changes a number by something between 1 and about 2^bits, up or down.
static int32_t changed(random_state *r, int32_t x, unsigned bits, int32_t least) {
  const int32_t by = least + (int32_t)random_below(r, UINT32_C(1) << random_below(r, bits));
  return random_below(r, 2) == 0 ? (int32_t)((uint32_t)x + (uint32_t)by) : (int32_t)((uint32_t)x - (uint32_t)by);
}

static void forge_certificate(random_state *r, gjk2_certificate *c) {
  switch (random_below(r, 5)) {
    case 0: c->a[random_below(r, 3)] = (uint16_t)random_below(r, 70); break;
    case 1: c->b[random_below(r, 3)] = (uint16_t)random_below(r, 70000); break;
    case 2: c->count = (uint8_t)random_below(r, 6); break;
    case 3: c->proof = (uint8_t)random_below(r, 12); break;
    default: c->direction.x = (int32_t)random_u32(r); c->direction.y = (int32_t)random_u32(r);
  }
}

static void count(gjk_status status) {
  CHECK(status == GJK_OK || status == GJK_ERROR_UNPROVEN);
  tally.refused += status != GJK_OK;
  tally.survived += status == GJK_OK;
}

// A forged decision: the wrong answer is refused whatever its certificate.
static void forge_decision(random_state *r, const gjk2_collider *a, const gjk2_collider *b, gjk_q16 asked,
                           const gjk2_decision *right) {
  gjk2_decision forged = *right;
  for (int i = 0; i < 3; i++) {
    forge_certificate(r, &forged.certificate);
    count(gjk2_check_decision(a, b, asked, &forged));
    forged.yes = !right->yes;
    CHECK(gjk2_check_decision(a, b, asked, &forged) == GJK_ERROR_UNPROVEN);
    forged.yes = right->yes;
  }
}

static void forge_distance(random_state *r, const gjk2_collider *a, const gjk2_collider *b,
                           const gjk2_distance_result *right) {
  for (int i = 0; i < 8; i++) {
    gjk2_distance_result forged = *right;
    const bool apart = !right->intersecting;
    switch (apart ? i : 0) {
      case 0: forged.distance = forged.lower = forged.upper = changed(r, right->distance, 20, 1); break;
      case 1: forged.lower = changed(r, right->lower, 20, 1); break;
      case 2: forged.upper = changed(r, right->upper, 20, 1); break;
      case 3: forged.point_a.x = changed(r, right->point_a.x, 20, 5); break;
      case 4: forged.point_b.y = changed(r, right->point_b.y, 20, 5); break;
      case 5: forged.normal.x = changed(r, right->normal.x, 30, 20); break;
      case 6: forged.normal.y = -right->normal.y | 64; break;
      default:
        forged.intersecting = true;
        forged.distance = forged.lower = forged.upper = 0;
        break;
    }
    const bool tangential = apart && (i == 3 || i == 4);  // parallel edges have other nearest points
    const gjk_status status = gjk2_check_distance(a, b, &forged);
    CHECK_MSG(status == GJK_ERROR_UNPROVEN || (tangential && status == GJK_OK), "field %d", i);
    forge_certificate(r, &forged.certificate);
    const gjk_status both = gjk2_check_distance(a, b, &forged);
    CHECK_MSG(both == GJK_ERROR_UNPROVEN || (tangential && both == GJK_OK), "field %d and certificate", i);
    forged = *right;
    forge_certificate(r, &forged.certificate);
    count(gjk2_check_distance(a, b, &forged));
  }
}

static void forge_penetration(random_state *r, const gjk2_collider *a, const gjk2_collider *b,
                              const gjk2_penetration_result *right) {
  for (int i = 0; i < 6; i++) {
    gjk2_penetration_result forged = *right;
    switch (right->intersecting ? i : 5) {
      case 0: forged.depth = forged.lower = forged.upper = changed(r, right->depth, 20, 1); break;
      case 1: forged.lower = changed(r, right->lower, 20, 1); break;
      case 2: forged.normal.x = changed(r, right->normal.x, 30, 20); break;
      case 3:
        forged.point_a.x = changed(r, right->point_a.x, 20, 9);
        forged.point_b.x = changed(r, right->point_b.x, 5, 9);
        break;
      case 4:
        forged.normal.x = -right->normal.x;
        forged.normal.y = -right->normal.y;
        break;
      default:
        forged.intersecting = !right->intersecting;
        forged.depth = forged.lower = forged.upper = right->intersecting ? 0 : (gjk_q16)random_below(r, 1000);
        forged.normal.x = GJK_Q30_ONE;
        forged.normal.y = 0;
        forged.point_a = forged.point_b = a->centre;
        break;
    }
    const bool slides = right->intersecting && i == 3;
    const gjk_status status = gjk2_check_penetration(a, b, &forged);
    CHECK_MSG(status == GJK_ERROR_UNPROVEN || (slides && status == GJK_OK), "field %d", i);
    forged = *right;
    forge_certificate(r, &forged.certificate);
    count(gjk2_check_penetration(a, b, &forged));
  }
}

static void check_pair(random_state *r, const gjk2_collider *a, const gjk2_collider *b) {
  gjk2_decision decision = {0};
  gjk2_distance_result distance = {0};
  gjk2_penetration_result depth = {0};
  gjk2_cache cache;
  for (unsigned i = 0; i < sizeof cache; i++) {
    ((uint8_t *)&cache)[i] = (uint8_t)random_below(r, random_below(r, 2) == 0 ? 4 : 256);
  }
  const gjk_q16 asked = random_below(r, 2) == 0 ? 0 : (gjk_q16)random_below(r, UINT32_C(1) << random_below(r, 30));
  for (int warm = 0; warm < 2; warm++) {
    CHECK(gjk2_within(a, b, asked, warm ? &cache : NULL, &decision) == GJK_OK);
    CHECK(gjk2_check_decision(a, b, asked, &decision) == GJK_OK);
    CHECK(gjk2_distance(a, b, warm ? &cache : NULL, &distance) == GJK_OK);
    CHECK_MSG(gjk2_check_distance(a, b, &distance) == GJK_OK, "proof %d", distance.certificate.proof);
    CHECK(gjk2_penetration(a, b, warm ? &cache : NULL, &depth) == GJK_OK);
    CHECK_MSG(gjk2_check_penetration(a, b, &depth) == GJK_OK, "proof %d, depth %d", depth.certificate.proof,
              depth.depth);
    tally.proven += 3;
  }
  gjk2_decision touching;
  CHECK(gjk2_intersect(a, b, NULL, &touching) == GJK_OK);
  forge_decision(r, a, b, asked, &decision);
  if (touching.certificate.proof != GJK2_PROOF_CIRCLES) {
    forge_distance(r, a, b, &distance);
    forge_penetration(r, a, b, &depth);
  }
}

int main(void) {
  static plane_body pair[2];
  const uint64_t seed = check_seed(SEED);
  for (unsigned long i = 0; i < TRIALS; i++) {
    random_state r = random_seed(seed + i);
    check_trial(i, plane_print, pair);
    plane_any_pair(&r, 3, pair);
    check_pair(&r, &pair[0].collider, &pair[1].collider);
  }
  printf("proven %lu; forged certificates refused %lu, as good %lu\n", tally.proven, tally.refused, tally.survived);
  CHECK(tally.refused > TRIALS && tally.survived > TRIALS);
  return check_done("plane_check");
}
