// Rotations and poses have the same bits everywhere: a hash over seeded calls.
#include "check.h"
#include "gjk/pose.h"
#include "random.h"

#define SEED 2026
#define CALLS 20000

// A changed bit is a changed contract: a commit that changes this hash says why.
#define POSE_HASH UINT64_C(0x67935E41BAF22143)

static uint64_t hash = UINT64_C(0xCBF29CE484222325);

// FNV-1a over whole words.
static void mix(int32_t value) {
  hash = (hash ^ (uint32_t)value) * UINT64_C(0x100000001B3);
}

static void mix_quat(const gjk_quat *q) {
  mix(q->x);
  mix(q->y);
  mix(q->z);
  mix(q->w);
}

static void mix_vec3(const gjk_vec3 *v) {
  mix(v->x);
  mix(v->y);
  mix(v->z);
}

static gjk_vec3 any_vector(random_state *random) {
  const unsigned shift = random_below(random, 31);
  return (gjk_vec3){random_range(random, INT32_MIN, INT32_MAX) >> shift,
                    random_range(random, INT32_MIN, INT32_MAX) >> shift,
                    random_range(random, INT32_MIN, INT32_MAX) >> shift};
}

static void call_all(random_state *random) {
  const gjk_vec3 axis = any_vector(random), v = any_vector(random);
  gjk_pose p = GJK_POSE_IDENTITY, q = GJK_POSE_IDENTITY, out = GJK_POSE_IDENTITY;
  gjk_vec3 moved = {0, 0, 0};
  mix(gjk_quat_from_axis_angle(&axis, (gjk_q16)random_u32(random), &p.rotation));
  mix_quat(&p.rotation);
  mix(gjk_quat_from_euler((gjk_q16)random_u32(random), (gjk_q16)random_u32(random), (gjk_q16)random_u32(random),
                          &q.rotation));
  mix_quat(&q.rotation);
  p.position = any_vector(random);
  q.position = any_vector(random);
  mix(gjk_pose_compose(&p, &q, &out));
  mix_quat(&out.rotation);
  mix_vec3(&out.position);
  mix(gjk_pose_invert(&p, &out));
  mix_quat(&out.rotation);
  mix_vec3(&out.position);
  mix(gjk_pose_apply(&p, &v, &moved));
  mix_vec3(&moved);
}

int main(void) {
  const uint64_t seed = check_seed(SEED);
  random_state random = random_seed(seed);
  for (int i = 0; i < CALLS; i++) {
    call_all(&random);
  }
  CHECK_MSG(hash == POSE_HASH || seed != SEED, "0x%016llX", (unsigned long long)hash);
  return check_done("pose_bits");
}
