// Checks answers.
#include "certify.h"

#include "../reference/accurate.h"

// Of curved shapes, and of centres so far apart that answers are 28 bits of the distance.
#define CURVED_TOLERANCE 2.0L
#define FAR_TOLERANCE (1.0L / 268435456.0L)

// Without vertices to name there is no exact proof: compares with proven bounds of the real distance.
static certify_verdict compare_bounds(const case_question *question, const case_pair *pair, const case_collider *a,
                              const case_collider *b, const case_answer *answer, const char **why) {
  accurate_result found;
  accurate_distance(pair, a, b, &found);
  long double tolerance = CURVED_TOLERANCE + FAR_TOLERANCE * (found.upper > 0 ? found.upper : 0);
  long double lower = found.lower - tolerance, upper = found.upper + tolerance;
  bool right;
  if (question->ask != CASE_DISTANCE) {
    long double limit = question->ask == CASE_WITHIN ? (long double)question->within : 0;
    right = answer->decision.yes ? lower <= limit : upper > limit;
  } else if (answer->distance.intersecting) {
    right = lower <= 0;
  } else {
    long double distance = (long double)answer->distance.distance;
    right = upper > 0 && lower <= distance + 0.5L && (distance - 0.5L <= upper || answer->distance.saturated);
  }
  *why = right ? "no exact check exists; inside the bounds of the accurate oracle"
               : "outside the bounds of the accurate oracle";
  return right ? CERTIFY_UNCERTIFIED : CERTIFY_WRONG;
}

// Checks an answer of the library's.
static certify_verdict check(const case_question *question, const case_pair *pair, const case_collider *a,
                     const case_collider *b, const case_answer *answer, const char **why) {
  gjk_q16 limit = question->ask == CASE_WITHIN ? question->within : 0;
  gjk_status status = question->ask == CASE_DISTANCE
                          ? gjk_check_distance(&a->collider, &b->collider, &answer->distance)
                          : gjk_check_decision(&a->collider, &b->collider, limit, &answer->decision);
  if (status == GJK_ERROR_UNSUPPORTED) {
    return compare_bounds(question, pair, a, b, answer, why);
  }
  *why = "the certificate does not hold";
  return status == GJK_OK ? CERTIFY_PROVEN : CERTIFY_WRONG;
}

// An answer of the reference has no certificate of its own: that of the library's answer settles it.
static certify_verdict check_reference(const case_question *question, const case_pair *pair, case_collider *a,
                               case_collider *b, const case_answer *answer, const char **why) {
  case_question of_library = *question;
  case_answer proven;
  of_library.reference = false;
  case_answer_find(&of_library, pair, a, b, &proven);
  if (proven.status != GJK_OK || check(question, pair, a, b, &proven, why) != CERTIFY_PROVEN) {
    return compare_bounds(question, pair, a, b, answer, why);
  }
  if (question->ask != CASE_DISTANCE) {
    *why = "the certified answer is the other one";
    return answer->decision.yes == proven.decision.yes ? CERTIFY_PROVEN : CERTIFY_WRONG;
  }
  if (answer->distance.intersecting != proven.distance.intersecting) {
    *why = proven.distance.intersecting ? "certified: they intersect" : "certified: they are separated";
    return CERTIFY_WRONG;
  }
  int64_t error = (int64_t)answer->distance.distance - proven.distance.distance;
  *why = "more than 1 LSB from the certified distance";
  return error >= -1 && error <= 1 ? CERTIFY_PROVEN : CERTIFY_WRONG;
}

certify_verdict certify_answer(const case_question *question, const case_pair *pair, case_collider *a,
                               case_collider *b, const case_answer *answer, const char **why) {
  if (answer->status != GJK_OK) {
    *why = "no answer";
    return CERTIFY_WRONG;
  }
  return question->reference ? check_reference(question, pair, a, b, answer, why)
                            : check(question, pair, a, b, answer, why);
}
