// Edges of an arm of seven joints against the truth in double, whose verdicts are sure: distances at samples and a bound of the
// speed. Also: certificates, slices, reversed and split edges, ends.
#include "gjk/arm.h"

#include <math.h>
#include <string.h>

#include "arm/arm_truth.h"
#include "arm/seven.h"
#include "check.h"

#define EDGES 240
#define PROOFS_MAX 20000

static seven machine;

// A certificate as it is taken.
typedef struct taken {
  gjk_arm_proof proof[PROOFS_MAX];
  unsigned count;
} taken;

static taken whole, sliced;

static void take(void *user, const gjk_arm_proof *proof) {
  taken *t = user;
  if (t->count < PROOFS_MAX) {
    t->proof[t->count] = *proof;
  }
  t->count++;
}

static double least_spare = 1e300;

static const gjk_arm_setup exact = {0, GJK_ARM_TOLERANCE_MIN, 0};

static gjk_arm_edge_result run(const int32_t *from, const int32_t *to, const gjk_arm_setup *setup, taken *proofs) {
  gjk_arm_edge_result result = {.answer = GJK_ARM_UNSETTLED};
  if (proofs != NULL) {
    proofs->count = 0;
  }
  CHECK(gjk_arm_edge_start(&machine.arm, from, to, setup, proofs != NULL ? take : NULL, proofs) == GJK_OK);
  CHECK(gjk_arm_edge_run(&machine.arm, 1000000, &result) == GJK_OK);
  return result;
}

static bool equal_results(const gjk_arm_edge_result *a, const gjk_arm_edge_result *b) {
  return a->answer == b->answer && a->lower == b->lower && a->upper == b->upper && a->tests == b->tests &&
         a->outside == b->outside && (a->answer != GJK_ARM_FREE || a->gap == b->gap) &&
         (a->answer != GJK_ARM_TOUCH ||
          (a->pair.part == b->pair.part && a->pair.other == b->pair.other && a->pair.obstacle == b->pair.obstacle));
}

// Is each answer what the truth allows?
static void check_answer(const int32_t *from, const int32_t *to, const gjk_arm_setup *setup,
                         const gjk_arm_edge_result *result) {
  const double one = GJK_Q30_ONE, lower = result->lower / one, upper = result->upper / one;
  unsigned samples;
  CHECK(result->answer != GJK_ARM_UNSETTLED);
  const arm_truth near = arm_truth_edge(&machine.arm, from, to, 0, 1, setup->margin, &samples);
  if (result->answer == GJK_ARM_FREE) {
    CHECK(near != ARM_TRUTH_TOUCH);
    CHECK(result->gap >= setup->margin && result->lower == GJK_Q30_ONE && result->upper == GJK_Q30_ONE);
    CHECK(arm_truth_edge(&machine.arm, from, to, 0, 1, result->gap - 1.0, &samples) != ARM_TRUTH_TOUCH);
  } else {
    const double hit = arm_truth_pair(&machine.arm, from, to, upper, &result->pair);
    CHECK(hit <= (double)setup->margin + setup->tolerance + ARM_TRUTH_ERROR);
    CHECK(lower <= upper && upper - lower <= (setup->resolution + 1024) / one);
    CHECK(lower == 0 || arm_truth_edge(&machine.arm, from, to, 0, lower, setup->margin, &samples) != ARM_TRUTH_TOUCH);
    CHECK(arm_truth_edge(&machine.arm, from, to, 0, 1, (double)setup->margin + setup->tolerance + 2 * ARM_TRUTH_ERROR,
                         &samples) != ARM_TRUTH_FREE);
  }
  if (near == ARM_TRUTH_TOUCH) {
    CHECK(result->answer == GJK_ARM_TOUCH);
  }
}

// How far vertices in a frame reach along a direction of the world. side: 1 farthest, -1 least far.
static double extent_of(const arm_truth_frame *frame, const gjk_vec3 *vertices, unsigned count, const double n[3],
                        int side) {
  double most = -1e300;
  for (unsigned i = 0; i < count; i++) {
    const double local[3] = {vertices[i].x, vertices[i].y, vertices[i].z};
    double v[3];
    arm_truth_turn(frame->q, local, v);
    const double along =
        side * (n[0] * (v[0] + frame->p[0]) + n[1] * (v[1] + frame->p[1]) + n[2] * (v[2] + frame->p[2]));
    most = along > most ? along : most;
  }
  return side * most;
}

// The farthest that an obstacle reaches along a direction: its posed integers, in real arithmetic.
static double obstacle_extent(const gjk_collider *c, const double n[3]) {
  const double centre = n[0] * c->centre.x + n[1] * c->centre.y + n[2] * c->centre.z;
  double most = 0;
  if (c->buffer != NULL) {
    most = -1e300;
    for (unsigned i = 0; i < c->count; i++) {
      const double along = n[0] * c->buffer[i].x + n[1] * c->buffer[i].y + n[2] * c->buffer[i].z;
      most = along > most ? along : most;
    }
  }
  for (unsigned i = 0; c->buffer == NULL && i < c->count; i++) {
    const gjk_vec3 *axis = &c->frame[i];
    const double along = n[0] * axis->x + n[1] * axis->y + n[2] * axis->z;
    most += along < 0 ? -along : along;
  }
  return centre + most + c->shape->convex_radius;
}

// Proofs hold for the motion in real numbers, without any allowance: at any fraction of its span the pair is farther apart
// than the margin along the direction that the proof names, and the gap of a FREE answer is not undercut.
static void check_proofs(random_state *random, const int32_t *from, const int32_t *to, const gjk_arm_setup *setup,
                         const gjk_arm_edge_result *result) {
  for (unsigned i = 0; i < 60 && whole.count > 0; i++) {
    const gjk_arm_proof *p = &whole.proof[random_below(random, whole.count)];
    const gjk_arm_pair *pair = &machine.pairs[p->pair];
    const double share = random_below(random, 5) == 0 ? random_below(random, 2) : random_below(random, 1000) / 1000.0;
    arm_truth_frame frames[GJK_ARM_LINKS_MAX];
    arm_truth_frames(&machine.arm, from, to, (p->from + share * (p->to - p->from)) / GJK_Q30_ONE, frames);
    const double x = p->direction.x, y = p->direction.y, z = p->direction.z, length = sqrt(x * x + y * y + z * z);
    const double local[3] = {x / length, y / length, z / length};
    double n[3] = {local[0], local[1], local[2]}, other;
    if (pair->frame == GJK_ARM_BASE) {
      other = obstacle_extent(&machine.obstacles[pair->other], n);
    } else {
      const unsigned link = machine.parts[pair->other].link;
      arm_truth_turn(frames[pair->frame].q, local, n);
      other = extent_of(&frames[link], machine.points[pair->other], SEVEN_POINTS, n, 1);
    }
    const unsigned link = machine.parts[pair->part].link;
    const double gap = extent_of(&frames[link], machine.points[pair->part], SEVEN_POINTS, n, -1) - other;
    CHECK_MSG(gap > setup->margin, "%g above the margin", gap - setup->margin);
    CHECK(result->answer != GJK_ARM_FREE || gap > result->gap - 1e-3);
    least_spare = gap - setup->margin < least_spare ? gap - setup->margin : least_spare;
  }
}

// The same edge, sliced anywhere: same answer, same proofs.
static void check_slices(random_state *random, const int32_t *from, const int32_t *to, const gjk_arm_setup *setup,
                         const gjk_arm_edge_result *result) {
  gjk_arm_edge_result part = {.answer = GJK_ARM_UNSETTLED};
  const uint32_t fixed = random_below(random, 4);
  gjk_q30 before = 0;
  sliced.count = 0;
  CHECK(gjk_arm_edge_start(&machine.arm, from, to, setup, take, &sliced) == GJK_OK);
  for (unsigned i = 0; i < 100000 && part.answer == GJK_ARM_UNSETTLED; i++) {
    CHECK(gjk_arm_edge_run(&machine.arm, fixed != 0 ? fixed : random_below(random, 50), &part) == GJK_OK);
    CHECK(part.lower >= before && part.lower <= result->lower);
    before = part.lower;
  }
  CHECK(equal_results(result, &part));
  CHECK(sliced.count == whole.count && memcmp(sliced.proof, whole.proof, whole.count * sizeof whole.proof[0]) == 0);
  CHECK(gjk_arm_edge_run(&machine.arm, 0, &part) == GJK_OK && equal_results(result, &part));
}

// Ends, the way back, and both halves.
static void check_relatives(const int32_t *from, const int32_t *to, const gjk_arm_setup *setup,
                            const gjk_arm_edge_result *result) {
  const gjk_q16 close = setup->margin + setup->tolerance;
  bool near;
  gjk_arm_names pair;
  const gjk_arm_edge_result back = run(to, from, setup, NULL);
  unsigned samples;
  // Between margin and tolerance either answer is right.
  const bool sure =
      arm_truth_edge(&machine.arm, from, to, 0, 1, setup->margin, &samples) == ARM_TRUTH_TOUCH ||
      arm_truth_edge(&machine.arm, from, to, 0, 1, close + 2 * ARM_TRUTH_ERROR, &samples) == ARM_TRUTH_FREE;
  CHECK(!sure || back.answer == result->answer);
  for (unsigned end = 0; end < 2; end++) {
    CHECK(gjk_arm_near(&machine.arm, end == 0 ? from : to, setup->margin, &near, &pair) == GJK_OK);
    CHECK(!near || result->answer == GJK_ARM_TOUCH);
    CHECK(!near || end == 1 || result->upper <= setup->resolution);
  }
  int32_t middle[SEVEN_JOINTS];
  bool even = true;
  for (unsigned i = 0; i < SEVEN_JOINTS; i++) {
    even = even && (to[i] - from[i]) % 2 == 0;
    middle[i] = from[i] + (to[i] - from[i]) / 2;
  }
  const gjk_arm_edge_result left = run(from, middle, setup, NULL), right = run(middle, to, setup, NULL);
  CHECK(!even || !sure ||
        (left.answer == GJK_ARM_TOUCH || right.answer == GJK_ARM_TOUCH) == (result->answer == GJK_ARM_TOUCH));
}

// One field of the certificate or the answer is forged: it must be refused.
static void check_forged(random_state *random, const int32_t *from, const int32_t *to, const gjk_arm_setup *setup,
                         const gjk_arm_edge_result *result) {
  gjk_arm_edge_result said = *result;
  gjk_arm *arm = &machine.arm;
  CHECK(gjk_check_edge(arm, from, to, setup, result, whole.proof, whole.count) == GJK_OK);
  if (whole.count == 0) {
    return;
  }
  const unsigned number = random_below(random, whole.count);
  const gjk_arm_proof honest = whole.proof[number];
  gjk_arm_proof *p = &whole.proof[number];
  const gjk_q30 length = p->to - p->from;
#define REFUSED() (gjk_check_edge(arm, from, to, setup, &said, whole.proof, whole.count) == GJK_ERROR_UNPROVEN)
  p->from += length;
  CHECK(REFUSED());
  *p = honest;
  p->from -= 1;
  CHECK(REFUSED());
  *p = honest;
  p->to += length;
  CHECK(REFUSED());
  *p = honest;
  p->to -= length / 2;
  CHECK(p->to >= result->lower || REFUSED());
  *p = honest;
  p->direction.x = -p->direction.x;
  p->direction.y = -p->direction.y;
  p->direction.z = -p->direction.z;
  CHECK(REFUSED());
  *p = honest;
  p->direction.x = p->direction.x / 2;
  p->direction.y = p->direction.y / 2;
  p->direction.z = p->direction.z / 2;
  CHECK(REFUSED());
  *p = honest;
  p->pair = (p->pair + 1) % arm->pair_count;
  CHECK(REFUSED());
  p->pair = arm->pair_count;
  CHECK(REFUSED());
  *p = honest;
  // A proof left out, where the claim needs it.
  memmove(p, p + 1, (whole.count - number - 1) * sizeof *p);
  const bool needed = honest.from < result->lower;
  CHECK(!needed || gjk_check_edge(arm, from, to, setup, &said, whole.proof, whole.count - 1) == GJK_ERROR_UNPROVEN);
  memmove(p + 1, p, (whole.count - number - 1) * sizeof *p);
  *p = honest;
  // The answer.
  if (result->answer == GJK_ARM_FREE) {
    const double fraction = random_below(random, 1024) / 1024.0;
    said.gap = (gjk_q16)(arm_truth_gap(arm, from, to, fraction, 1e9) + ARM_TRUTH_ERROR);
    CHECK(REFUSED());
    said = *result;
    said.answer = GJK_ARM_TOUCH;
    said.pair.part = machine.memory.pairs[0].part;
    said.pair.other = machine.memory.pairs[0].other;
    said.pair.obstacle = false;
    CHECK(REFUSED());
    said = *result;
    said.lower -= 1024;
    CHECK(REFUSED());
  } else {
    // What is proven to the very end may be called free: a touch there was within the tolerance.
    said.answer = GJK_ARM_FREE;
    said.gap = setup->margin;
    CHECK(result->lower == GJK_Q30_ONE || REFUSED());
    said.lower = said.upper = GJK_Q30_ONE;
    CHECK(result->lower == GJK_Q30_ONE || REFUSED());
    said = *result;
    said.pair.part = (uint16_t)(said.pair.part + 1);
    gjk_arm_names names = said.pair;
    const bool exists = names.part < SEVEN_PARTS;
    const double gap = exists ? arm_truth_pair(arm, from, to, result->upper / (double)GJK_Q30_ONE, &names) : 1e9;
    CHECK(gap < setup->margin + setup->tolerance + ARM_TRUTH_ERROR || REFUSED());
    said = *result;
    said.lower = said.upper + 1024;
    CHECK(REFUSED());
    said = *result;
    said.upper = result->upper - 1;
    CHECK(REFUSED());
  }
  said = *result;
  said.answer = (gjk_arm_answer)3;
  CHECK(REFUSED());
#undef REFUSED
}

static void check_random(uint64_t seed) {
  random_state random = random_seed(seed);
  const gjk_pose base = GJK_POSE_IDENTITY;
  unsigned free = 0, touch = 0, self = 0;
  CHECK(seven_make(&machine, &base));
  const unsigned long edges = check_trials(EDGES);
  for (unsigned long i = 0; i < edges; i++) {
    int32_t from[SEVEN_JOINTS], to[SEVEN_JOINTS];
    gjk_arm_setup setup = exact;
    check_trial(i, NULL, NULL);
    if (i % 8 == 0) {
      CHECK(seven_surround(&machine, &random, random_below(&random, SEVEN_OBSTACLES + 1)));
    }
    bool near = true;
    for (unsigned tries = 0; near && tries < 30; tries++) {
      seven_any(&random, from);
      CHECK(gjk_arm_near(&machine.arm, from, 1000, &near, NULL) == GJK_OK);
    }
    seven_beside(&random, from, random_range(&random, 0, 196608), to);
    setup.margin = random_below(&random, 2) == 0 ? 0 : random_range(&random, 0, 2000);
    setup.tolerance += random_below(&random, 2) == 0 ? 0 : random_range(&random, 0, 300);
    setup.resolution = random_below(&random, 3) == 0 ? GJK_Q30_ONE : random_range(&random, 0, 1 << 24);
    const gjk_arm_edge_result result = run(from, to, &setup, &whole);
    const gjk_arm_edge_result silent = run(from, to, &setup, NULL);
    CHECK(equal_results(&result, &silent));
    CHECK(whole.count <= PROOFS_MAX);
    free += result.answer == GJK_ARM_FREE;
    touch += result.answer == GJK_ARM_TOUCH;
    self += result.answer == GJK_ARM_TOUCH && !result.pair.obstacle;
    check_answer(from, to, &setup, &result);
    check_proofs(&random, from, to, &setup, &result);
    check_slices(&random, from, to, &setup, &result);
    check_forged(&random, from, to, &setup, &result);
    check_relatives(from, to, &setup, &result);
  }
  printf("%u free, %u touch, %u of them by themselves; proofs by %.3g LSB and more\n", free, touch, self, least_spare);
  CHECK(edges < 50 || (free > edges / 6 && touch > edges / 6 && self > 0));
}

// The same bits as on every other machine.
static void check_bits(void) {
  uint64_t hash;
  CHECK(seven_hash(&machine, &hash));
  CHECK_MSG(hash == SEVEN_HASH, "0x%llX", (unsigned long long)hash);
}

int main(void) {
  check_bits();
  check_random(check_seed(3101));
  return check_done("arm");
}
