// The check that parts enclose a solid, against claims that are nearly right.
#include "solid_boxes.h"

enum { SIDE = 300, CELL = 100, PARTS = 27 };

static bool is_enclosed(const solid *s, const part *p, size_t parts) {
  enclose_report report;
  const bool enclosed = enclose_check(s, p, parts, &report);
  CHECK(enclosed == (report.problem[0] == '\0'));
  enclose_free(&report);
  return enclosed;
}

static part cell_part(int n, int32_t less, int axis, bool high) {
  int32_t low[3], top[3];
  for (int j = 0; j < 3; j++) {
    const int at = j == 0 ? n % 3 : j == 1 ? n / 3 % 3 : n / 9;
    low[j] = at * CELL + (j == axis && !high ? less : 0);
    top[j] = (at + 1) * CELL - (j == axis && high ? less : 0);
  }
  return boxes_part(low, top);
}

// A cube of 27 boxes: all; each left out; each side of each drawn in by 1 LSB, or pushed out.
static void test_cube(void) {
  const boxes b = boxes_of("###/###/### ###/###/### ###/###/###", CELL);
  solid s = boxes_solid(&b);
  part all[PARTS], but[PARTS];
  for (int n = 0; n < PARTS; n++) {
    all[n] = cell_part(n, 0, 0, false);
    CHECK(enclose_is_inside(&s, &all[n]));
  }
  CHECK(is_enclosed(&s, all, PARTS));
  for (int n = 0; n < PARTS; n++) {
    size_t count = 0;
    for (int i = 0; i < PARTS; i++) {
      but[count] = all[i];
      count += i != n;
    }
    CHECK_MSG(!is_enclosed(&s, but, count), "without part %d\n", n);  // 13: a hole that no triangle touches
    for (int side = 0; side < 6; side++) {
      memcpy(but, all, sizeof but);
      but[n] = cell_part(n, 1, side / 2, side % 2 == 1);
      CHECK_MSG(!is_enclosed(&s, but, PARTS), "part %d less by 1 at side %d\n", n, side);
      part_free(&but[n]);
      but[n] = cell_part(n, -1, side / 2, side % 2 == 1);
      CHECK_MSG(is_enclosed(&s, but, PARTS), "part %d more by 1 at side %d\n", n, side);
      part_free(&but[n]);
    }
  }
  CHECK(!is_enclosed(&s, all, 0));
  for (int n = 0; n < PARTS; n++) {
    part_free(&all[n]);
  }
  solid_free(&s);
}

// A box with a bubble: around it parts may end, elsewhere not. Where the bubble has no part, none is missed.
static void test_bubble(void) {
  const boxes b = boxes_of("###/###/### ###/#.#/### ###/###/###", CELL);
  solid s = boxes_solid(&b);
  part around[PARTS];
  size_t count = 0;
  for (int n = 0; n < PARTS; n++) {
    if (n != 13) {
      around[count++] = cell_part(n, 0, 0, false);
    }
  }
  CHECK(is_enclosed(&s, around, count));
  for (size_t n = 0; n < count; n++) {
    const part kept = around[n];
    around[n] = around[count - 1];
    CHECK(!is_enclosed(&s, around, count - 1));
    around[n] = kept;
  }
  const int32_t low[3] = {CELL, CELL, CELL}, high[3] = {2 * CELL, 2 * CELL, 2 * CELL};
  part bubble = boxes_part(low, high);
  CHECK(!enclose_is_inside(&s, &bubble));
  part_free(&bubble);
  for (size_t n = 0; n < count; n++) {
    part_free(&around[n]);
  }
  solid_free(&s);
}

// Two halves of a turned box: drawn apart by 1 LSB, or overlapping.
static void test_turned(void) {
  boxes b = boxes_of("##", CELL);
  const int32_t turn[3][3] = {{2, -2, 1}, {1, 2, 2}, {-2, -1, 2}};
  memcpy(b.turn, turn, sizeof turn);
  solid s = boxes_solid(&b);
  for (int gap = -2; gap <= 2; gap++) {
    part half[2];
    for (int k = 0; k < 2; k++) {
      int32_t point[8][3];
      for (int i = 0; i < 8; i++) {
        const int at[3] = {(i & 1) + k, i >> 1 & 1, i >> 2 & 1};
        const gjk_vec3 x = boxes_corner(&b, at);
        const bool middle = at[0] == 1 && k == 1;
        point[i][0] = x.x - s.origin.x + (middle ? gap : 0);
        point[i][1] = x.y - s.origin.y;
        point[i][2] = x.z - s.origin.z;
      }
      CHECK(part_build(&half[k], point, 8));
    }
    // The cut moved along x by the gap, an edge of the box no longer straight: only closed cuts enclose it.
    CHECK_MSG(is_enclosed(&s, half, 2) == (gap == 0) || gap < 0, "gap %d\n", gap);
    CHECK(!is_enclosed(&s, half, 1));
    CHECK(!is_enclosed(&s, half + 1, 1));
    part_free(&half[0]);
    part_free(&half[1]);
  }
  solid_free(&s);
}

// Parts whose planes and points are not one thing.
static void test_forged(void) {
  const boxes b = boxes_of("##/#.", CELL);
  solid s = boxes_solid(&b);
  const int32_t low[2][3] = {{0, 0, 0}, {0, CELL, 0}}, high[2][3] = {{2 * CELL, CELL, CELL}, {CELL, 2 * CELL, CELL}};
  part p[2] = {boxes_part(low[0], high[0]), boxes_part(low[1], high[1])};
  CHECK(is_enclosed(&s, p, 2));
  for (unsigned f = 0; f < p[1].faces; f++) {
    p[1].plane[f].d += 1;
    CHECK(!is_enclosed(&s, p, 2));
    p[1].plane[f].d -= 2;
    CHECK(!is_enclosed(&s, p, 2));
    p[1].plane[f].d += 1;
  }
  for (unsigned i = 0; i < p[1].points; i++) {
    for (int j = 0; j < 3; j++) {
      p[1].point[i][j] += 1;
      CHECK(!is_enclosed(&s, p, 2));
      p[1].point[i][j] -= 1;
    }
  }
  p[1].faces--;
  CHECK(!is_enclosed(&s, p, 2));
  p[1].faces++;
  p[0].high[0]--;
  CHECK(!is_enclosed(&s, p, 2));
  p[0].high[0]++;
  const uint16_t kept = p[1].corner[0];
  p[1].corner[0] = p[1].corner[1];
  CHECK(!is_enclosed(&s, p, 2));
  p[1].corner[0] = 99;
  CHECK(!is_enclosed(&s, p, 2));
  p[1].corner[0] = kept;
  CHECK(is_enclosed(&s, p, 2));
  part_free(&p[0]);
  part_free(&p[1]);
  solid_free(&s);
}

// Random solids, decomposed, then spoiled: a part left out is missed, unless another one has all of it; so is a corner moved inwards.
static void test_spoiled(uint64_t seed) {
  random_state random = random_seed(seed);
  unsigned long refused = 0, count = 0;
  for (unsigned long i = 0; i < 30; i++) {
    const boxes b = boxes_random(&random, 4, i % 2 == 1);
    check_trial(i, boxes_print, &b);
    solid s = boxes_solid(&b);
    const decompose_options usual = {-1, 0};
    decomposition d;
    decompose(&s, &usual, &d);
    for (size_t n = 0; n < d.parts && d.parts > 1; n++) {
      const part kept = d.part[n];
      d.part[n] = d.part[d.parts - 1];
      CHECK(!is_enclosed(&s, d.part, d.parts - 1));  // the parts of an exact decomposition do not overlap
      d.part[n] = kept;
    }
    const size_t n = random_below(&random, (uint32_t)d.parts);
    part *p = &d.part[n];
    int32_t(*point)[3] = malloc(p->points * sizeof point[0]);
    memcpy(point, p->point, p->points * sizeof point[0]);
    const unsigned corner = random_below(&random, p->points);
    for (int j = 0; j < 3; j++) {
      point[corner][j] += point[corner][j] == p->low[j] ? 1 : point[corner][j] == p->high[j] ? -1 : 0;
    }
    part less;
    if (part_build(&less, point, p->points) && less.volume6 < p->volume6) {
      const part kept = *p;
      *p = less;
      count++;
      refused += !is_enclosed(&s, d.part, d.parts);
      part_free(&less);
      *p = kept;
    }
    free(point);
    decompose_free(&d);
    solid_free(&s);
  }
  // The volume of parts that do not overlap is the solid's, so with any less of it they cannot enclose it.
  CHECK_MSG(refused == count && count > 20, "%lu of %lu refused\n", refused, count);
}

int main(void) {
  const uint64_t seed = check_seed(4711);
  test_cube();
  test_bubble();
  test_turned();
  test_forged();
  test_spoiled(seed);
  return check_done("enclose");
}
