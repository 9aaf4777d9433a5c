// Decomposition: solids of grid cells come out exactly, with the fewest parts where those are known, in any orientation
// and in any order of points and triangles; approximate ones reach as far as they say.
#include <math.h>

#include "solid_boxes.h"

static const decompose_options usual = {-1, 0};

static solid_wide volume_of(const decomposition *d) {
  solid_wide sum = 0;
  for (size_t i = 0; i < d->parts; i++) {
    sum += d->part[i].volume6;
  }
  return sum;
}

static bool is_in_parts(const decomposition *d, const int32_t x[3]) {
  for (size_t i = 0; i < d->parts; i++) {
    if (part_has(&d->part[i], x)) {
      return true;
    }
  }
  return false;
}

// The fewest convex parts of each, by reasoning about its notches: a plane resolves at most the two or four that lie in it.
static void test_known(void) {
  static const struct {
    const char *name, *cells;
    size_t parts;
  } known[] = {
      {"box", "##/##", 1},
      {"L", "###/#../#..", 2},
      {"U", "###/#.#/#.#", 3},
      {"T", "###/.#./.#.", 2},
      {"cross", ".#./###/.#.", 3},
      {"S", "##./.##", 2},
      {"staircase", "###/##./#..", 3},
      {"ring", "###/#.#/###", 4},
      {"comb of three teeth", "#####/#.#.#/#.#.#", 4},
      {"H", "#.#/###/#.#", 3},
      {"arms along three axes", ".../.#./... .#./###/.#. .../.#./...", 5},
      {"cube without a corner", "##/## ##/#.", 3},
      {"two boxes apart", "#.#", 2},
      {"bubble", "###/###/### ###/#.#/### ###/###/###", 6},
  };
  for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
    const boxes b = boxes_of(known[i].cells, 100);
    solid s = boxes_solid(&b);
    decomposition d;
    decompose(&s, &usual, &d);
    CHECK_MSG(d.parts == known[i].parts, "%s: %zu parts, expected %zu\n", known[i].name, d.parts, known[i].parts);
    CHECK_MSG(d.enclosed && d.excess.at_most == 0 && volume_of(&d) == s.volume6, "%s: %s\n", known[i].name, d.problem);
    decompose_free(&d);
    solid_free(&s);
  }
}

// Each cell's middle is in a part, or in none.
static void check_cells(const boxes *b, const solid *s, const decomposition *d) {
  for (int x = 0; x < b->n[0]; x++) {
    for (int y = 0; y < b->n[1]; y++) {
      for (int z = 0; z < b->n[2]; z++) {
        const int low[3] = {x, y, z}, high[3] = {x + 1, y + 1, z + 1};
        const gjk_vec3 p = boxes_corner(b, low), q = boxes_corner(b, high);
        const int32_t twice[3] = {p.x + q.x - 2 * s->origin.x, p.y + q.y - 2 * s->origin.y,
                                  p.z + q.z - 2 * s->origin.z};
        const int32_t middle[3] = {twice[0] / 2, twice[1] / 2, twice[2] / 2};
        if (twice[0] % 2 == 0 && twice[1] % 2 == 0 && twice[2] % 2 == 0) {
          CHECK(is_in_parts(d, middle) == b->full[x][y][z]);
        }
      }
    }
  }
}

static void test_random(uint64_t seed) {
  random_state random = random_seed(seed);
  unsigned long notched = 0, several = 0, turned = 0;
  const unsigned long count = check_trials(300);
  for (unsigned long i = 0; i < count; i++) {
    const boxes b = boxes_random(&random, 4, i % 2 == 1);
    check_trial(i, boxes_print, &b);
    solid s = boxes_solid(&b);
    decomposition d;
    decompose(&s, &usual, &d);
    CHECK_MSG(d.enclosed, "%s\n", d.problem);
    CHECK_MSG(d.excess.at_most == 0, "excess %Lg of %zu parts\n", d.excess.at_most, d.parts);
    CHECK(volume_of(&d) == s.volume6);
    CHECK(d.parts <= d.notches + 2 || d.parts <= 8);
    check_cells(&b, &s, &d);
    notched += d.notches > 0;
    several += d.parts > 3;
    turned += b.turn[0][0] != 1;
    decompose_free(&d);
    solid_free(&s);
  }
  CHECK(!check_is_full() || (notched > count / 3 && several > count / 8 && turned > count / 4));
}

// The same surface with its points and triangles in another order gives the same parts.
static void test_order(uint64_t seed) {
  random_state random = random_seed(seed);
  for (unsigned long i = 0; i < check_trials(40); i++) {
    const boxes b = boxes_random(&random, 3, i % 2 == 1);
    check_trial(i, boxes_print, &b);
    mesh m = boxes_mesh(&b), other = boxes_mesh(&b);
    for (size_t n = m.points; n > 1; n--) {
      const uint32_t k = random_below(&random, (uint32_t)n);
      const gjk_vec3 kept = other.point[n - 1];
      other.point[n - 1] = other.point[k];
      other.point[k] = kept;
      for (size_t t = 0; t < 3 * m.triangles; t++) {
        uint32_t *corner = &other.triangle[t / 3][t % 3];
        *corner = *corner == k ? (uint32_t)n - 1 : *corner == n - 1 ? k : *corner;
      }
    }
    for (size_t n = m.triangles; n > 1; n--) {
      const uint32_t k = random_below(&random, (uint32_t)n), by = random_below(&random, 3);
      uint32_t kept[3];
      memcpy(kept, other.triangle[n - 1], sizeof kept);
      memcpy(other.triangle[n - 1], other.triangle[k], sizeof kept);
      for (unsigned c = 0; c < 3; c++) {
        other.triangle[k][c] = kept[(c + by) % 3];
      }
    }
    char problem[200];
    solid s, t;
    decomposition d, e;
    CHECK(solid_from_mesh(&s, &m, problem, sizeof problem) && solid_from_mesh(&t, &other, problem, sizeof problem));
    decompose(&s, &usual, &d);
    decompose(&t, &usual, &e);
    bool same = d.parts == e.parts;
    for (size_t n = 0; n < d.parts && same; n++) {
      same = d.part[n].points == e.part[n].points &&
             memcmp(d.part[n].point, e.part[n].point, d.part[n].points * sizeof d.part[n].point[0]) == 0;
    }
    CHECK(same);
    decompose_free(&d);
    decompose_free(&e);
    solid_free(&s);
    solid_free(&t);
    mesh_free(&m);
    mesh_free(&other);
  }
}

// A second copy of a mesh, moved.
static mesh doubled(const mesh *m, int32_t x, int32_t y, int32_t z) {
  mesh both = {0};
  both.points = 2 * m->points;
  both.triangles = 2 * m->triangles;
  both.point = solid_allocate(both.points, sizeof both.point[0]);
  both.triangle = solid_allocate(both.triangles, sizeof both.triangle[0]);
  for (size_t i = 0; i < both.points; i++) {
    both.point[i] = m->point[i % m->points];
    if (i >= m->points) {
      both.point[i].x += x;
      both.point[i].y += y;
      both.point[i].z += z;
    }
  }
  for (size_t t = 0; t < both.triangles; t++) {
    for (int c = 0; c < 3; c++) {
      both.triangle[t][c] = m->triangle[t % m->triangles][c] + (t < m->triangles ? 0 : (uint32_t)m->points);
    }
  }
  return both;
}

// The tree finds the triangles that a ray crosses: the same answer as from all triangles, for points on their planes as well.
static void check_inside(const solid *s, random_state *random) {
  nearest_tree tree;
  nearest_build(&tree, s);
  unsigned in = 0;
  for (int i = 0; i < 400; i++) {
    long double x[3];
    solid_wide at[3];
    long winding = 0;
    for (int j = 0; j < 3; j++) {
      const int32_t step = random_range(random, 0, 2 * s->high[j] / 25);
      x[j] = i % 2 == 0 ? step * 12.5L : (long double)random_range(random, -9, s->high[j] + 9);
      at[j] = (solid_wide)(x[j] * 0x1p24L);
    }
    const bool inside = !solid_winding(s, at, 24, 0, 1, NULL, &winding) || winding != 0;
    CHECK(nearest_is_inside(&tree, x) == inside);
    in += inside;
  }
  CHECK_MSG(in > 40 && in < 400, "%u of 400\n", in);
  nearest_free(&tree);
}

// Two shells that cross: where both are the surface winds twice, which volumes of parts must not count. The union comes out
// exactly.
static void test_doubled(uint64_t seed) {
  random_state random = random_seed(seed);
  static const struct {
    const char *name, *cells;
    int32_t move[3];
  } known[] = {
      {"ring aside", "###/#.#/###", {100, 200, 0}},
      {"ring across", "###/#.#/###", {100, 200, 100}},
      {"ring by a half", "###/#.#/###", {200, 0, 0}},
      {"U aside", "###/#.#/#.#", {100, 100, 0}},
      {"bubble", "###/###/### ###/#.#/### ###/###/###", {100, 50, 150}},
      {"box", "##/##", {100, 100, 100}},
  };
  for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
    const boxes b = boxes_of(known[i].cells, 400);
    const int32_t *move = known[i].move;
    mesh one = boxes_mesh(&b), both = doubled(&one, move[0], move[1], move[2]);
    char problem[200];
    solid s;
    decomposition d;
    CHECK_MSG(solid_from_mesh(&s, &both, problem, sizeof problem), "%s: %s\n", known[i].name, problem);
    check_inside(&s, &random);
    decompose(&s, &usual, &d);
    CHECK_MSG(d.enclosed && d.excess.at_most == 0, "%s: excess %Lg of %zu parts\n", known[i].name, d.excess.at_most,
              d.parts);
    CHECK(volume_of(&d) <= s.volume6);
    decompose_free(&d);
    solid_free(&s);
    mesh_free(&one);
    mesh_free(&both);
  }
}

// One part is the hull. How far it reaches beyond: a U's, half its opening; an L's, to where its hull is as far from one leg as from
// the other; a box with a bubble in it, to the bubble's middle; a plate with a groove, to the groove's edges.
static void test_excess(void) {
  static const struct {
    const char *name, *cells;
    long double excess;
  } known[] = {
      {"U", "###/#.#/#.#", 600}, {"L", "###/#../#..", 1200}, {"bubble", "###/###/### ###/#.#/### ###/###/###", 600},
      {"box", "##", 0},          {"apart", "#...#", 1800},
  };
  const decompose_options one = {-1, 1};
  for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
    const boxes b = boxes_of(known[i].cells, 1200);
    solid s = boxes_solid(&b);
    decomposition d;
    decompose(&s, &one, &d);
    // Of the L: the hull's slope runs from (3, 1) to (1, 3), its middle (2, 2) is 1 from both legs.
    CHECK_MSG(d.parts == 1 && d.enclosed && d.excess.at_least <= known[i].excess + 0.01L &&
                  d.excess.at_most >= known[i].excess - 0.01L,
              "%s: %Lg to %Lg, expected %Lg\n", known[i].name, d.excess.at_least, d.excess.at_most, known[i].excess);
    CHECK_MSG(d.excess.at_most <= d.excess.at_least * 1.02L + 0.2L, "%s: %Lg to %Lg\n", known[i].name,
              d.excess.at_least, d.excess.at_most);
    decompose_free(&d);
    solid_free(&s);
  }
}

int main(void) {
  const uint64_t seed = check_seed(20261122);
  test_known();
  test_doubled(seed + 2);
  test_excess();
  test_random(seed);
  test_order(seed + 1);
  return check_done("decompose");
}
