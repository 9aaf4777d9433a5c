// Checks answers.
#include "certify.h"

#include <math.h>

#include "exact/depth.h"
#include "reference/accurate.h"

// Tolerances: of curved shapes, and of centres so far apart that answers hold 27 bits of the distance.
#define CURVED_TOLERANCE 2.0L
#define DEPTH_TOLERANCE 3.0L
#define FAR_TOLERANCE (1.0L / 134217728.0L)

// Rounds to one digit, and drops the sign of a zero.
static long double to_a_tenth(long double x) {
  return rintl(10 * x) / 10 + 0.0L;
}

// Shapes without vertices have no exact proof, so this compares with proven bounds of the real distance.
static certify_verdict compare_bounds(const case_question *question, const case_pair *pair, const case_collider *a,
                                      const case_collider *b, const case_answer *answer, char why[CERTIFY_WHY_MAX]) {
  accurate_result found;
  const bool deep = question->ask == CASE_PENETRATION;
  if (deep) {
    accurate_signed(pair, a, b, &found);
  } else {
    accurate_distance(pair, a, b, &found);
  }
  long double tolerance =
      (deep ? DEPTH_TOLERANCE : CURVED_TOLERANCE) + FAR_TOLERANCE * (found.upper > 0 ? found.upper : 0);
  long double lower = found.lower - tolerance, upper = found.upper + tolerance;
  bool right;
  if (deep && answer->penetration.intersecting) {
    long double depth = (long double)answer->penetration.depth;  // rounded up
    right = lower <= 1 - depth && -depth <= upper;
  } else if (question->ask != CASE_DISTANCE && !deep) {
    long double limit = question->ask == CASE_WITHIN ? (long double)question->within : 0;
    right = answer->decision.yes ? lower <= limit : upper > limit;
  } else if (answer->distance.intersecting) {
    right = lower <= 0;
  } else {
    long double distance = (long double)answer->distance.distance;
    right = upper > 0 && lower <= distance + 0.5L && (distance - 0.5L <= upper || answer->distance.saturated);
  }
  snprintf(why, CERTIFY_WHY_MAX, "curved; the accurate bounds are %.1Lf to %.1Lf", to_a_tenth(found.lower),
           to_a_tenth(found.upper));
  return right ? CERTIFY_UNCERTIFIED : CERTIFY_WRONG;
}

// Most directions that are tried for a single case.
#define BRUTE_DIRECTIONS 100000

// Checks the certificate, and where the shapes are small, that no other direction is nearer.
static bool check_penetration(const gjk_collider *a, const gjk_collider *b, const gjk_penetration_result *result,
                              char why[CERTIFY_WHY_MAX]) {
  exact_overlap truth;
  const gjk_status status = gjk_check_penetration(a, b, result);
  if (status != GJK_OK) {
    snprintf(why, CERTIFY_WHY_MAX, "the library's check: %s", gjk_status_name(status));
    return false;
  }
  if (!exact_check_penetration(a, b, result, why, CERTIFY_WHY_MAX)) {
    return false;
  }
  if (exact_depth_work(a, b) > BRUTE_DIRECTIONS || !exact_overlap_find(a, b, &truth)) {
    return true;
  }
  snprintf(why, CERTIFY_WHY_MAX, "brute force knows of depth %ld", (long)truth.depth);
  return truth.intersecting && truth.depth == result->depth;
}

// Asks the library's own check. Its range is smaller than that of answers, so far pairs are left to the oracle.
static bool check_by_library(const case_question *question, const case_collider *a, const case_collider *b,
                             const case_answer *answer, char why[CERTIFY_WHY_MAX]) {
  gjk_q16 limit = question->ask == CASE_WITHIN ? question->within : 0;
  gjk_status status = question->ask == CASE_DISTANCE
                          ? gjk_check_distance(&a->collider, &b->collider, &answer->distance)
                          : gjk_check_decision(&a->collider, &b->collider, limit, &answer->decision);
  snprintf(why, CERTIFY_WHY_MAX, "the library's check: %s", gjk_status_name(status));
  return status == GJK_OK || (status == GJK_ERROR_UNSUPPORTED && exact_is_far(&a->collider, &b->collider));
}

static bool check_by_oracle(const case_question *question, const case_collider *a, const case_collider *b,
                            const case_answer *answer, char why[CERTIFY_WHY_MAX]) {
  gjk_q16 limit = question->ask == CASE_WITHIN ? question->within : 0;
  if (question->ask == CASE_DISTANCE) {
    return exact_check_distance(&a->collider, &b->collider, &answer->distance, why, CERTIFY_WHY_MAX);
  }
  return exact_check_decision(&a->collider, &b->collider, limit, &answer->decision, why, CERTIFY_WHY_MAX);
}

// Checks an answer of the library's.
static certify_verdict check(const case_question *question, const case_pair *pair, const case_collider *a,
                             const case_collider *b, const case_answer *answer, char why[CERTIFY_WHY_MAX]) {
  if (answer->status != GJK_OK) {
    snprintf(why, CERTIFY_WHY_MAX, "no answer: %s", gjk_status_name(answer->status));
    return CERTIFY_WRONG;
  }
  if (answer->open) {
    snprintf(why, CERTIFY_WHY_MAX, "open after %u iterations", answer->decision.iterations);
    return CERTIFY_UNCERTIFIED;
  }
  if (exact_vertex_count(&a->collider) == 0 || exact_vertex_count(&b->collider) == 0) {
    return compare_bounds(question, pair, a, b, answer, why);
  }
  if (question->ask == CASE_PENETRATION) {
    const case_question distance = {.ask = CASE_DISTANCE};
    if (!answer->penetration.intersecting) {
      return check(&distance, pair, a, b, answer, why);
    }
    return check_penetration(&a->collider, &b->collider, &answer->penetration, why) ? CERTIFY_PROVEN : CERTIFY_WRONG;
  }
  return check_by_library(question, a, b, answer, why) && check_by_oracle(question, a, b, answer, why) ? CERTIFY_PROVEN
                                                                                                       : CERTIFY_WRONG;
}

// Checks an answer of the reference. It has no certificate, so the certificate of the library's answer settles it.
static certify_verdict check_reference(const case_question *question, const case_pair *pair, case_collider *a,
                                       case_collider *b, const case_answer *answer, char why[CERTIFY_WHY_MAX]) {
  case_question of_library = *question;
  case_answer proven;
  of_library.reference = false;
  case_answer_find(&of_library, pair, a, b, &proven);
  if (check(question, pair, a, b, &proven, why) != CERTIFY_PROVEN) {
    return compare_bounds(question, pair, a, b, answer, why);
  }
  bool same =
      answer->distance.intersecting == proven.distance.intersecting && answer->decision.yes == proven.decision.yes;
  int64_t error = (int64_t)answer->distance.distance - proven.distance.distance + answer->penetration.depth -
                  proven.penetration.depth;
  if (!same) {
    snprintf(why, CERTIFY_WHY_MAX, "the other answer is proven");
  } else if (proven.penetration.intersecting) {
    snprintf(why, CERTIFY_WHY_MAX, "the proven depth is %ld", (long)proven.penetration.depth);
  } else {
    snprintf(why, CERTIFY_WHY_MAX, "the proven distance is %ld", (long)proven.distance.distance);
  }
  return same && error >= -1 && error <= 1 ? CERTIFY_PROVEN : CERTIFY_WRONG;
}

certify_verdict certify_answer(const case_question *question, const case_pair *pair, case_collider *a, case_collider *b,
                               const case_answer *answer, char why[CERTIFY_WHY_MAX]) {
  return question->reference ? check_reference(question, pair, a, b, answer, why)
                             : check(question, pair, a, b, answer, why);
}
