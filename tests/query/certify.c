// Checks the tool's answers.
#include "certify.h"

#include "../reference/accurate.h"

// Of curved shapes, and of centres so far apart that answers are 28 bits of the distance.
#define CURVED_TOLERANCE 2.0L
#define FAR_TOLERANCE (1.0L / 268435456.0L)

typedef enum verdict { CERTIFIED, UNCERTIFIED, WRONG } verdict;

// Without vertices to name there is no exact proof: compares with proven bounds of the real distance.
static verdict compare_bounds(const query_options *options, const case_pair *pair, const case_collider *a,
                              const case_collider *b, const query_answer *answer, const char **why) {
  accurate_result found;
  accurate_distance(pair, a, b, &found);
  long double tolerance = CURVED_TOLERANCE + FAR_TOLERANCE * (found.upper > 0 ? found.upper : 0);
  long double lower = found.lower - tolerance, upper = found.upper + tolerance;
  bool right;
  if (options->question != QUERY_DISTANCE) {
    long double limit = options->question == QUERY_WITHIN ? (long double)options->within : 0;
    right = answer->decision.yes ? lower <= limit : upper > limit;
  } else if (answer->distance.intersecting) {
    right = lower <= 0;
  } else {
    long double distance = (long double)answer->distance.distance;
    right = upper > 0 && lower <= distance + 0.5L && (distance - 0.5L <= upper || answer->distance.saturated);
  }
  *why = right ? "no exact check exists; inside the bounds of the accurate oracle"
               : "outside the bounds of the accurate oracle";
  return right ? UNCERTIFIED : WRONG;
}

// Checks an answer of the library's.
static verdict check(const query_options *options, const case_pair *pair, const case_collider *a,
                     const case_collider *b, const query_answer *answer, const char **why) {
  gjk_q16 limit = options->question == QUERY_WITHIN ? options->within : 0;
  gjk_status status = options->question == QUERY_DISTANCE
                          ? gjk_check_distance(&a->collider, &b->collider, &answer->distance)
                          : gjk_check_decision(&a->collider, &b->collider, limit, &answer->decision);
  if (status == GJK_ERROR_UNSUPPORTED) {
    return compare_bounds(options, pair, a, b, answer, why);
  }
  *why = "the certificate does not hold";
  return status == GJK_OK ? CERTIFIED : WRONG;
}

// An answer of the reference has no certificate of its own: that of the library's answer settles it.
static verdict check_reference(const query_options *options, const case_pair *pair, case_collider *a,
                               case_collider *b, const query_answer *answer, const char **why) {
  query_options proven_options = *options;
  query_answer proven;
  proven_options.reference = false;
  query_answer_case(&proven_options, pair, a, b, &proven);
  if (proven.status != GJK_OK || check(options, pair, a, b, &proven, why) != CERTIFIED) {
    return compare_bounds(options, pair, a, b, answer, why);
  }
  if (options->question != QUERY_DISTANCE) {
    *why = "the certified answer is the other one";
    return answer->decision.yes == proven.decision.yes ? CERTIFIED : WRONG;
  }
  if (answer->distance.intersecting != proven.distance.intersecting) {
    *why = proven.distance.intersecting ? "certified: they intersect" : "certified: they are separated";
    return WRONG;
  }
  int64_t error = (int64_t)answer->distance.distance - proven.distance.distance;
  *why = "more than 1 LSB from the certified distance";
  return error >= -1 && error <= 1 ? CERTIFIED : WRONG;
}

void certify_answer(FILE *file, certify_state *state, const query_options *options, const case_pair *pair,
                    case_collider *a, case_collider *b, const query_answer *answer) {
  const char *why = "";
  verdict found = WRONG;
  if (answer->refused != 0) {
    return;
  }
  if (answer->status != GJK_OK) {
    why = "no answer";
  } else if (options->reference) {
    found = check_reference(options, pair, a, b, answer, &why);
  } else {
    found = check(options, pair, a, b, answer, &why);
  }
  if (found == CERTIFIED) {
    state->certified++;
  } else if (found == UNCERTIFIED) {
    state->uncertified++;
    fprintf(file, " uncertified: %s", why);
  } else {
    state->wrong++;
    fprintf(file, " WRONG: %s", why);
  }
}
