// The most expensive pairs that a search has found. Each takes the recorded iterations, and its answer is proven.
//
//   test_worst [FILE]    default: tests/data/worst.txt, from the top folder
#include <string.h>

#include "case/certify.h"
#include "case/parse.h"
#include "check.h"
#include "iterations.h"
#include "reference/accurate.h"

#define CASES 23

// Reads the '# iterations N ...' comments of the file, in order. Returns their number.
static size_t read_iterations(FILE *file, unsigned *iterations, size_t most) {
  char line[CASE_LINE_MAX];
  size_t count = 0;
  while (count < most && fgets(line, sizeof line, file) != NULL) {
    count += sscanf(line, "# iterations %u", &iterations[count]) == 1;
  }
  return count;
}

// At the ceiling on iterations a distance has proven bounds. Of curved shapes they hold for the support points, which
// are up to 2 LSB off the real surface.
static void check_limit(const case_pair *pair, const case_collider *a, const case_collider *b,
                        const gjk_distance_result *result) {
  accurate_result truth;
  accurate_distance(pair, a, b, &truth);
  CHECK_MSG(result->lower - 2 <= truth.upper, "%s: %ld to %ld, but %.2Lf to %.2Lf", pair->id, (long)result->lower,
            (long)result->upper, truth.lower, truth.upper);
  CHECK_MSG(result->upper + 2 >= truth.lower, "%s: %ld to %ld, but %.2Lf to %.2Lf", pair->id, (long)result->lower,
            (long)result->upper, truth.lower, truth.upper);
}

// How many steps the search takes among the vertices that it has seen.
static unsigned count_recalls(const gjk_collider *a, const gjk_collider *b, gjk_goal goal) {
  gjk_iteration it;
  it.recalls = 0;
  if (gjk_iteration_start(&it, a, b, goal, (int64_t)a->shape->convex_radius + b->shape->convex_radius)) {
    gjk_search(&it, goal, NULL, GJK_NO_LIMIT);
  }
  return it.iterations > GJK_PLAIN_ITERATIONS && !gjk_pair_is_curved(&it) ? it.recalls : 0;
}

// Checks a case. Returns whether it reached the ceiling on iterations.
static bool check_case(const case_pair *pair, case_collider *a, case_collider *b, unsigned iterations) {
  case_question question = {.ask = CASE_DISTANCE};
  case_answer answer;
  char why[CERTIFY_WHY_MAX] = "";
  if (strstr(pair->id, "-intersect-") != NULL) {
    question.ask = CASE_INTERSECT;
  }
  case_answer_find(&question, pair, a, b, &answer);
  const unsigned used = question.ask == CASE_DISTANCE ? answer.distance.iterations : answer.decision.iterations;
  CHECK_MSG(used == iterations, "%s: %u iterations, not the recorded %u", pair->id, used, iterations);
  const unsigned recalls =
      count_recalls(&a->collider, &b->collider, question.ask == CASE_DISTANCE ? GJK_GOAL_DISTANCE : GJK_GOAL_WITHIN);
  printf("%s: %u iterations, %u steps among seen vertices\n", pair->id, used, recalls);
  CHECK_MSG(recalls < GJK_RECALLS_MAX, "%s: %u steps", pair->id, recalls);
  const bool limit = answer.status == GJK_ERROR_ITERATION_LIMIT;
  CHECK_MSG(used <= iterations_bound(&a->collider, &b->collider), "%s: %u iterations", pair->id, used);
  if (limit) {
    CHECK_MSG(pair->a.kind > CASE_HULL || pair->b.kind > CASE_HULL, "%s: a polytope at the ceiling", pair->id);
    CHECK_MSG(used == GJK_ITERATIONS_MAX, "%s: %u iterations", pair->id, used);
    if (question.ask == CASE_DISTANCE) {
      check_limit(pair, a, b, &answer.distance);
    }
  } else {
    CHECK_MSG(certify_answer(&question, pair, a, b, &answer, why) != CERTIFY_WRONG, "%s: %s", pair->id, why);
  }
  return limit;
}

static void run(FILE *file, const char *name) {
  static unsigned iterations[CASES + 1];
  static case_reader reader;
  static case_pair pair;
  static case_collider a, b;
  const size_t known = read_iterations(file, iterations, CASES + 1);
  size_t count = 0;
  unsigned limits = 0;
  rewind(file);
  case_reader_open(&reader, file, name);
  while (count < known && case_reader_next(&reader, &pair)) {
    limits += check_case(&pair, &a, &b, iterations[count]);
    count++;
  }
  printf("%lu cases, %u at the ceiling of %d iterations\n", (unsigned long)count, limits, GJK_ITERATIONS_MAX);
  CHECK(known == CASES);
  CHECK(count == CASES);
  CHECK(reader.errors == 0);
  case_pair_release(&pair, &a, &b);
}

int main(int argc, char **argv) {
  const char *name = argc > 1 ? argv[1] : "tests/data/worst.txt";
  FILE *file = fopen(name, "r");
  CHECK_MSG(file != NULL, "%s", name);
  if (file != NULL) {
    run(file, name);
    fclose(file);
  }
  return check_done("worst");
}
