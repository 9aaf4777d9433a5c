// Pairs that other libraries' users reported as wrong, against answers computed in rational arithmetic: distances and
// depths.
//
//   test_trackers [FILE]    default: tests/data/trackers.txt, from the top folder
#include <math.h>
#include <string.h>

#include "case/parse.h"
#include "check.h"
#include "exact/depth.h"

#define CASES 33
#define CELLS GJK_EPA_CELLS(512)

// Half the height of the prisms over flat pairs. It is larger than every depth within the plane.
#define PRISM 40000000

// The answer that the file states for a case: '# exact separated DISTANCE | touching | intersecting DEPTH', in LSB.
typedef struct truth {
  char word[16];
  double number;
} truth;

// Reads the 'exact' comments of the file, in order. Returns their number.
static size_t read_truths(FILE *file, truth *truths, size_t most) {
  char line[CASE_LINE_MAX];
  size_t count = 0;
  while (count < most && fgets(line, sizeof line, file) != NULL) {
    truth *t = &truths[count];
    t->number = 0;
    count += sscanf(line, "# exact %15s %lf", t->word, &t->number) >= 1;
  }
  return count;
}

static void expect(bool holds, const case_pair *pair, const char *what) {
  CHECK_MSG(holds, "%s: %s", pair->id, what);
  if (!holds) {
    case_print(stdout, pair);
  }
}

static bool decides(const gjk_collider *a, const gjk_collider *b, gjk_q16 distance, bool yes) {
  gjk_decision d;
  gjk_cache cache = {0};
  char why[128];
  for (int pass = 0; pass < 2; pass++) {  // cold, then warm
    if (gjk_within(a, b, distance, &cache, &d) != GJK_OK || d.yes != yes ||
        !exact_check_decision(a, b, distance, &d, why, sizeof why) ||
        gjk_check_decision(a, b, distance, &d) != GJK_OK) {
      return false;
    }
  }
  return distance > 0 || (gjk_intersect(a, b, NULL, &d) == GJK_OK && d.yes == yes);
}

// The depth is that of the file, rounded up. The signed distance agrees with it.
static void check_depth(const case_pair *pair, const gjk_collider *a, const gjk_collider *b, gjk_q16 depth) {
  static gjk_epa_cell cells[CELLS];
  static const gjk_workspace workspace = {cells, CELLS};
  gjk_penetration_result r;
  gjk_distance_result s;
  char why[200] = "";
  const bool answered = gjk_penetration(a, b, NULL, &workspace, &r) == GJK_OK;
  expect(answered && r.intersecting && r.depth == depth, pair, "depth");
  expect(answered && exact_check_penetration(a, b, &r, why, sizeof why), pair, why);
  expect(answered && gjk_check_penetration(a, b, &r) == GJK_OK, pair, "gjk_check_penetration");
  expect(gjk_signed_distance(a, b, NULL, &workspace, &s) == GJK_OK && s.intersecting && s.distance == -depth, pair,
         "signed distance");
}

// Do all vertices lie in one plane across z?
static bool is_flat(const gjk_collider *a, const gjk_collider *b) {
  const gjk_collider *c[2] = {a, b};
  const int64_t z = exact_vertex(a, 0).x[2];
  for (int k = 0; k < 2; k++) {
    for (unsigned i = 0; i < exact_vertex_count(c[k]); i++) {
      if (exact_vertex(c[k], i).x[2] != z) {
        return false;
      }
    }
  }
  return true;
}

// Makes the prism over a flat hull.
static void raise_prism(const case_shape *flat, case_shape *prism) {
  case_shape_copy(prism, flat);
  case_shape_set_count(prism, 2 * flat->count);
  for (size_t i = 0; i < flat->count; i++) {
    gjk_vec3 *below = &prism->vertices[i], *above = &prism->vertices[flat->count + i];
    *below = *above = flat->vertices[i];
    below->z -= PRISM;
    above->z += PRISM;
  }
}

// For a flat pair the file states the depth within its plane, which the prisms over it have. The pair itself has depth
// 0: across the plane.
static void check_flat(const case_pair *pair, const gjk_collider *a, const gjk_collider *b, gjk_q16 depth) {
  case_pair prisms = {{0}, {0}, {0}};
  case_collider prism_a = {0}, prism_b = {0};
  check_depth(pair, a, b, 0);
  expect(pair->a.kind == CASE_HULL && pair->b.kind == CASE_HULL && depth < PRISM, pair, "hulls");
  raise_prism(a->shape->vertices == pair->a.vertices ? &pair->a : &pair->b, &prisms.a);
  raise_prism(a->shape->vertices == pair->a.vertices ? &pair->b : &pair->a, &prisms.b);
  const bool built = case_pair_build(&prisms, false, &prism_a, &prism_b);
  expect(built, pair, "the prisms can be posed");
  if (built) {
    check_depth(&prisms, &prism_a.collider, &prism_b.collider, depth);
  }
  case_pair_release(&prisms, &prism_a, &prism_b);
}

static void check_one_way(const case_pair *pair, const gjk_collider *a, const gjk_collider *b, const truth *t) {
  const bool separated = strcmp(t->word, "separated") == 0;
  const gjk_q16 distance = separated ? (gjk_q16)floor(t->number + 0.5) : 0;
  gjk_distance_result r;
  char why[128] = "";
  const bool answered = gjk_distance(a, b, NULL, &r) == GJK_OK;
  expect(answered, pair, "status");
  if (!answered) {
    return;
  }
  expect(r.intersecting != separated, pair, t->word);
  expect(r.distance == distance, pair, "distance");
  expect(exact_check_distance(a, b, &r, why, sizeof why), pair, why);
  expect(gjk_check_distance(a, b, &r) == GJK_OK, pair, "gjk_check_distance");
  expect(decides(a, b, 0, !separated), pair, "intersect");
  if (separated) {  // the file gives enough digits to tell on which side of an integer the distance lies
    const gjk_q16 within = (gjk_q16)ceil(t->number);
    expect(decides(a, b, within, true), pair, "within the distance");
    expect(decides(a, b, within - 1, false), pair, "within less than the distance");
  } else if (is_flat(a, b)) {
    check_flat(pair, a, b, (gjk_q16)ceil(t->number));
  } else {
    check_depth(pair, a, b, (gjk_q16)ceil(t->number));
  }
}

static void check_case(const case_pair *pair, case_collider *a, case_collider *b, const truth *t) {
  const bool built = case_pair_build(pair, false, a, b);
  expect(built, pair, "the pair can be posed");
  if (built) {
    check_one_way(pair, &a->collider, &b->collider, t);
    check_one_way(pair, &b->collider, &a->collider, t);
  }
}

// Brute force checks the file where the shapes are small, so that a typing error in it would show.
static unsigned check_truth(const case_pair *pair, const gjk_collider *a, const gjk_collider *b, const truth *t) {
  exact_truth brute;
  if (exact_vertex_count(a) * exact_vertex_count(b) > EXACT_BRUTE_MAX) {
    return 0;
  }
  exact_brute(a, b, &brute);
  const bool separated = !exact_truth_within(&brute, a, b, 0);
  expect(separated == (strcmp(t->word, "separated") == 0), pair, "brute force, decision");
  expect(exact_truth_distance(&brute, a, b) == (separated ? (int64_t)floor(t->number + 0.5) : 0), pair,
         "brute force, distance");
  exact_overlap overlap;
  const double depth = is_flat(a, b) ? 0 : t->number;
  expect(exact_overlap_find(a, b, &overlap) && overlap.intersecting != separated, pair, "all directions, decision");
  expect(separated || overlap.depth == (int64_t)ceil(depth), pair, "all directions, depth");
  return 1;
}

static void run(FILE *file, const char *name) {
  static truth truths[CASES + 1];
  static case_reader reader;
  case_pair pair = {0};
  case_collider a = {0}, b = {0};
  const size_t known = read_truths(file, truths, CASES + 1);
  size_t count = 0;
  unsigned by_brute = 0;
  rewind(file);
  case_reader_open(&reader, file, name);
  while (count < known && case_reader_next(&reader, &pair)) {
    check_case(&pair, &a, &b, &truths[count]);
    by_brute += check_truth(&pair, &a.collider, &b.collider, &truths[count]);
    count++;
  }
  printf("%lu cases, %u also by brute force\n", (unsigned long)count, by_brute);
  CHECK(known == CASES);
  CHECK(count == CASES);
  CHECK(reader.errors == 0);
  CHECK(by_brute >= CASES / 3);
  case_pair_release(&pair, &a, &b);
}

int main(int argc, char **argv) {
  const char *name = argc > 1 ? argv[1] : "tests/data/trackers.txt";
  FILE *file = fopen(name, "r");
  CHECK_MSG(file != NULL, "%s", name);
  if (file != NULL) {
    run(file, name);
    fclose(file);
  }
  return check_done("trackers");
}
