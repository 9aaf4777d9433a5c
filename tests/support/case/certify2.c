// Checks answers in the plane.
#include "certify2.h"

#include <math.h>

#include "exact/claim2.h"

// How far a curved answer may be from the reference, LSB, and for its rounding
// of large distances.
#define CURVED_TOLERANCE 4.0
#define FAR_TOLERANCE (1.0 / 134217728.0)

static double measured(const case_question *question, const case2_answer *answer) {
  const bool deep = question->ask == CASE_PENETRATION && answer->penetration.intersecting;
  return deep ? -(double)answer->penetration.depth : (double)answer->distance.distance;
}

// Shapes without vertices have no exact proof, so this compares with the
// reference.
static certify_verdict compare_curved(const case_question *question, const case2_pair *pair, case2_collider *a,
                                      case2_collider *b, const case2_answer *answer, char why[CERTIFY_WHY_MAX]) {
  case_question deep = {.ask = CASE_PENETRATION, .reference = true};
  case2_answer reference;
  case2_answer_find(&deep, pair, a, b, &reference);
  const double found = measured(&deep, &reference), tolerance = CURVED_TOLERANCE + FAR_TOLERANCE * fabs(found);
  bool right;
  if (question->ask == CASE_INTERSECT || question->ask == CASE_WITHIN) {
    const double limit = question->ask == CASE_WITHIN ? (double)question->within : 0;
    right = answer->decision.yes ? found <= limit + tolerance : found > limit - tolerance;
  } else if (question->ask == CASE_DISTANCE && answer->distance.intersecting) {
    right = found <= tolerance;
  } else {
    right = answer->distance.saturated || fabs(measured(question, answer) - found) <= tolerance;
  }
  snprintf(why, CERTIFY_WHY_MAX, "curved; the reference says %.0f", found);
  return right ? CERTIFY_UNCERTIFIED : CERTIFY_WRONG;
}

// Asks the library's own check. Its range is smaller than that of answers, so
// far pairs are left to the oracle.
static bool check_by_library(const case_question *question, const case2_collider *a, const case2_collider *b,
                             const case2_answer *answer, bool far, char why[CERTIFY_WHY_MAX]) {
  const gjk_q16 limit = question->ask == CASE_WITHIN ? question->within : 0;
  const gjk2_collider *of_a = &a->collider, *of_b = &b->collider;
  gjk_status status;
  if (question->ask == CASE_INTERSECT || question->ask == CASE_WITHIN) {
    status = gjk2_check_decision(of_a, of_b, limit, &answer->decision);
  } else if (question->ask == CASE_PENETRATION && answer->penetration.intersecting) {
    status = gjk2_check_penetration(of_a, of_b, &answer->penetration);
  } else {
    status = gjk2_check_distance(of_a, of_b, &answer->distance);
  }
  snprintf(why, CERTIFY_WHY_MAX, "the library's check: %s", gjk_status_name(status));
  return status == GJK_OK || (status == GJK_ERROR_UNSUPPORTED && far);
}

static bool check_by_oracle(const case_question *question, const exact2_pair *exact, const case2_answer *answer,
                            char why[CERTIFY_WHY_MAX]) {
  const gjk_q16 limit = question->ask == CASE_WITHIN ? question->within : 0;
  if (question->ask == CASE_INTERSECT || question->ask == CASE_WITHIN) {
    return exact2_check_decision(exact, limit, &answer->decision, why, CERTIFY_WHY_MAX);
  }
  if (question->ask == CASE_PENETRATION && answer->penetration.intersecting) {
    return exact2_check_penetration(exact, &answer->penetration, why, CERTIFY_WHY_MAX);
  }
  return exact2_check_distance(exact, &answer->distance, why, CERTIFY_WHY_MAX);
}

// Compares an answer of the reference with the truth.
static certify_verdict check_reference(const case_question *question, const exact2_pair *exact,
                                       const case2_answer *answer, char why[CERTIFY_WHY_MAX]) {
  const exact2_truth *truth = &exact->truth;
  const bool decision = question->ask == CASE_INTERSECT || question->ask == CASE_WITHIN;
  const gjk_q16 limit = question->ask == CASE_WITHIN ? question->within : 0;
  const bool within = exact2_truth_within(&exact->truth, exact->a.shape.radius + exact->b.shape.radius, limit);
  if (decision ? answer->decision.yes != within : answer->distance.intersecting != truth->intersecting) {
    snprintf(why, CERTIFY_WHY_MAX, "the other answer is proven");
    return CERTIFY_WRONG;
  }
  const int64_t proven = truth->intersecting ? -truth->depth : truth->distance;
  const bool measures = !decision && (question->ask == CASE_PENETRATION || !truth->intersecting);
  snprintf(why, CERTIFY_WHY_MAX, "the proven %s is %lld", truth->intersecting ? "depth" : "distance",
           (long long)(truth->depth + truth->distance));
  const bool right = !measures || answer->distance.saturated || fabs(measured(question, answer) - (double)proven) <= 1;
  return right ? CERTIFY_PROVEN : CERTIFY_WRONG;
}

certify_verdict certify2_answer(const case_question *question, const case2_pair *pair, case2_collider *a,
                                case2_collider *b, const case2_answer *answer, char why[CERTIFY_WHY_MAX]) {
  exact2_pair exact;
  if (answer->status != GJK_OK) {
    snprintf(why, CERTIFY_WHY_MAX, "no answer: %s", gjk_status_name(answer->status));
    return CERTIFY_WRONG;
  }
  if (answer->open) {
    snprintf(why, CERTIFY_WHY_MAX, "open after %u iterations", answer->decision.iterations);
    return CERTIFY_UNCERTIFIED;
  }
  if (!exact2_pair_set(&a->collider, &b->collider, &exact)) {
    return compare_curved(question, pair, a, b, answer, why);
  }
  certify_verdict verdict = CERTIFY_WRONG;
  if (question->reference) {
    verdict = check_reference(question, &exact, answer, why);
  } else if (check_by_library(question, a, b, answer, exact.far, why) &&
             check_by_oracle(question, &exact, answer, why)) {
    verdict = CERTIFY_PROVEN;
  }
  exact2_pair_free(&exact);
  return verdict;
}
