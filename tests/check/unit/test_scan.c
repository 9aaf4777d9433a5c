// Scans over vertices against a plain loop: every number of vertices up to 200, every size of vertices, ties.
//
// Each buffer ends where its vertices end, so that the address sanitizer sees a read beyond them. SCAN_REACH=1 checks
// gjk_reach_next too; its struct depends on the library's settings, so this program must then have the same.
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "random.h"
#include "src/shape/gjk_scan.h"

#ifndef SCAN_REACH
#define SCAN_REACH 0
#endif
#define SEED 6419
#define MOST 200
#define ROUNDS ((int)check_trials(40))

typedef enum family { ANY, GRID, ALIKE, EXTREME, FAMILIES } family;

typedef struct scan_case {
  gjk_vec3 *v;
  unsigned count, bits;
  gjk_vec3 d;
} scan_case;

// A component of at most 2^bits in size.
static int32_t component(random_state *random, family kind, unsigned bits) {
  const int32_t most = bits < 31 ? INT32_C(1) << bits : INT32_MAX;
  switch (kind) {
    case GRID: return most / 2 * random_range(random, -2, 2);
    case ALIKE: return most - random_range(random, 0, bits < 3 ? 1 : 5);
    case EXTREME: return random_below(random, 2) == 0 ? most : bits < 31 ? -most : INT32_MIN;
    case ANY:
    default: return random_range(random, -most, most);
  }
}

// Components of at most 2^d_bits in size.
static gjk_vec3 direction(random_state *random, family kind, unsigned d_bits) {
  const int32_t most = d_bits < 31 ? INT32_C(1) << d_bits : INT32_MAX;
  gjk_vec3 d = {0, 0, most};
  switch (kind) {
    case GRID:
      d.x = random_range(random, -1, 1) * most;
      d.y = random_range(random, -1, 1) * most;
      break;
    case EXTREME:
      d.x = random_below(random, 2) == 0 ? most : -most;
      d.y = random_below(random, 2) == 0 ? most - 1 : -most;
      break;
    case ALIKE:
      d.x = most - random_range(random, 0, 1);
      d.y = most - random_range(random, 0, 1);
      break;
    case ANY:
    default:
      d.x = random_range(random, -most, most);
      d.y = random_range(random, -most, most);
      break;
  }
  const gjk_vec3 turned[3] = {d, {d.z, d.x, d.y}, {d.y, -d.z, d.x}};
  return turned[random_below(random, 3)];
}

// The most bits of a direction, so that products are below 3 2^61.
static unsigned most_bits(unsigned bits) {
  return bits < 31 ? 31 : 30;
}

static scan_case scan_case_of(random_state *random, family kind, unsigned count, unsigned bits, unsigned d_bits) {
  scan_case s = {malloc(count * sizeof(gjk_vec3)), count, bits, direction(random, kind, d_bits)};
  if (s.v == NULL) {
    abort();
  }
  for (unsigned i = 0; i < count; i++) {
    s.v[i] = (gjk_vec3){component(random, kind, bits), component(random, kind, bits), component(random, kind, bits)};
  }
  return s;
}

static int64_t product(const scan_case *s, unsigned i) {
  return (int64_t)s->v[i].x * s->d.x + (int64_t)s->v[i].y * s->d.y + (int64_t)s->v[i].z * s->d.z;
}

// The first of the farthest. *tied: whether there are others.
static unsigned farthest(const scan_case *s, bool *tied) {
  unsigned best = 0;
  *tied = false;
  for (unsigned i = 1; i < s->count; i++) {
    if (product(s, i) > product(s, best)) {
      best = i;
      *tied = false;
    } else if (product(s, i) == product(s, best)) {
      *tied = true;
    }
  }
  return best;
}

static void print_case(const void *subject) {
  const scan_case *s = subject;
  printf("  %u vertices of %u bits, direction %ld %ld %ld\n", s->count, s->bits, (long)s->d.x, (long)s->d.y,
         (long)s->d.z);
}

static bool check_farthest(const scan_case *s) {
  bool tied;
  const unsigned expected = farthest(s, &tied);
  const long found = (long)(gjk_scan(s->v, s->v + s->count, s->bits, &s->d) - s->v);
  CHECK_MSG(found == (long)expected, "vertex %ld, not %u", found, expected);
  return tied;
}

#if SCAN_REACH

// Returns how many reach a limit that is slack behind the product of some vertex. Each must be found once, in order.
static unsigned check_reach(const scan_case *s, random_state *random) {
  const unsigned one = random_below(random, s->count);
  const bool large = s->bits == 31 || (!GJK_NARROW_MULTIPLY && random_below(random, 4) == 0);
  const int64_t most = large ? INT64_C(1) << 33 : INT64_C(4) << s->bits;
  const int64_t slack = random_below(random, 3) == 0
                            ? most
                            : (int64_t)(random_u64(random) % (uint64_t)most) * (int64_t)random_below(random, 2);
  gjk_reach reach;
  memset(&reach, 0x5A, sizeof reach);
  reach.next = s->v;
  reach.end = s->v + s->count;
  reach.d = &s->d;
  reach.limit = product(s, one) - slack;
  gjk_reach_start(&reach, s->bits);
  unsigned reached = 0;
  for (unsigned i = 0; i < s->count; i++) {
    if (product(s, i) >= product(s, one) - slack) {
      const gjk_vec3 *v = gjk_reach_next(&reach);
      CHECK_MSG(v == s->v + i, "vertex %u reaches the limit", i);
      reached++;
    }
  }
  CHECK(gjk_reach_next(&reach) == NULL);
  CHECK(gjk_reach_next(&reach) == NULL);
  return reached;
}

#endif

static void test_all_counts(void) {
  random_state random = random_seed(check_seed(SEED));
  unsigned long trial = 0, ties[FAMILIES] = {0}, scans[FAMILIES] = {0}, reached = 0, looked_at = 0;
  for (int round = 0; round < ROUNDS; round++) {
    for (unsigned count = 1; count <= MOST; count++) {
      const family kind = (family)random_below(&random, FAMILIES);
      const unsigned bits = 1 + (unsigned)(trial % 31), most = most_bits(bits);
      const unsigned d_bits = random_below(&random, 2) == 0 ? most : random_below(&random, most + 1);
      scan_case s = scan_case_of(&random, kind, count, bits, d_bits);
      check_trial(trial++, print_case, &s);
      ties[kind] += check_farthest(&s);
      scans[kind]++;
#if SCAN_REACH
      s.d = direction(&random, kind, random_below(&random, 2) == 0 ? most : 29);
      reached += check_reach(&s, &random);
      looked_at += count;
#endif
      check_trial(trial, NULL, NULL);
      free(s.v);
    }
  }
  // The mix must still have ties, and vertices on both sides of the limit.
  CHECK(ties[GRID] > scans[GRID] / 2 && ties[EXTREME] > scans[EXTREME] / 2);
  CHECK(ties[ANY] < scans[ANY] / 3);
  CHECK(!SCAN_REACH || (reached > looked_at / 4 && reached < looked_at * 3 / 4));
}

// Each vertex in turn is the farthest, by 1, or the first of two that are.
static void test_each_place(void) {
  random_state random = random_seed(check_seed(SEED));
  for (unsigned count = 1; count <= MOST; count++) {
    const unsigned bits = 1 + count % 30;
    scan_case s = scan_case_of(&random, ALIKE, count, bits, 30);
    s.d = (gjk_vec3){0, 1 << 30, 0};
    check_trial(count, print_case, &s);
    for (unsigned i = 0; i < count; i++) {
      for (unsigned k = 0; k < count; k++) {
        s.v[k].y = (INT32_C(1) << bits) - 1;
      }
      s.v[i].y++;
      CHECK(gjk_scan(s.v, s.v + count, bits, &s.d) == s.v + i);
      s.v[count - 1].y = s.v[i].y;
      CHECK(gjk_scan(s.v, s.v + count, bits, &s.d) == s.v + i);
    }
    check_trial(count, NULL, NULL);
    free(s.v);
  }
}

// One vertex is farther by little, though its leading bits say the contrary by as much as they can: what they lack adds
// up for it, and for the others it is 0. Directions nearly across the difference, of components that end in ones.
static void test_misleading_leading_bits(void) {
  random_state random = random_seed(check_seed(SEED));
  unsigned long farther = 0, trials = 0;
  for (int round = 0; round < ROUNDS * 500; round++) {
    const unsigned bits = 15 + random_below(&random, 16), count = 12 + random_below(&random, 30);
    const int32_t rest = (INT32_C(1) << (bits - random_below(&random, 2) - 13)) - 1, most = INT32_C(1) << bits;
    scan_case s = scan_case_of(&random, GRID, count, bits, 30);
    const int32_t x = 32767 - random_range(&random, 0, 3), y = -x / 2 - random_range(&random, 0, 8);
    const int32_t z = -x - y - random_range(&random, 0, 6);
    const gjk_vec3 d = {x * 65536 + 65535, y * 65536 + 65535, z * 65536 + 65535};
    const gjk_vec3 low = {-most, -most + rest, -most + rest}, high = {most - 1, most - 1 - rest, most - 1 - rest};
    s.d = d;
    for (unsigned i = 0; i < count; i++) {
      s.v[i] = low;
    }
    const unsigned one = random_below(&random, count);
    s.v[one] = high;
    check_trial((unsigned long)round, print_case, &s);
    bool tied;
    farther += farthest(&s, &tied) == one && one != 0;
    trials++;
    check_farthest(&s);
    check_trial((unsigned long)round, NULL, NULL);
    free(s.v);
  }
  CHECK(farther > trials / 10 && farther < trials * 9 / 10);
}

#if SCAN_REACH

// Leading bits also understate products the most where all lower bits are ones.
static void test_reach_of_understated(void) {
  random_state random = random_seed(check_seed(SEED));
  for (int round = 0; round < ROUNDS * 100; round++) {
    const unsigned bits = 15 + random_below(&random, 16);
    const int32_t unit = INT32_C(1) << (bits - 14);
    scan_case s = scan_case_of(&random, GRID, 12 + random_below(&random, 30), bits, 30);
    const int32_t x = random_range(&random, 32500, 32767), y = random_range(&random, 32500, 32767);
    s.d = (gjk_vec3){x * 65536 + 65535, y * 65536 + 65535, INT32_MAX};
    for (unsigned i = 0; i < s.count; i++) {
      s.v[i].x = random_range(&random, 16000, 16383) * unit + unit - 1;
      s.v[i].y = random_range(&random, 16000, 16383) * unit + unit - 1;
      s.v[i].z = random_range(&random, 16000, 16383) * unit + unit - 1;
    }
    check_trial((unsigned long)round, print_case, &s);
    check_reach(&s, &random);
    check_trial((unsigned long)round, NULL, NULL);
    free(s.v);
  }
}

#endif

int main(void) {
#if SCAN_REACH
  test_reach_of_understated();
#endif
  test_misleading_leading_bits();
  test_all_counts();
  test_each_place();
  return check_done(SCAN_REACH ? "scan, reach" : "scan");
}
