// Makes the arm of seven joints, in integers alone, so that it is the same on every target.
#include "seven.h"

#include "gjk/number.h"

#include "fnv.h"

// A link of the arm: where its joint is, in the link before, and the capsule-like body on it, in thousandths of a unit.
typedef struct seven_link {
  int16_t x, y, z;    // the joint's place
  int16_t quarter;    // turns of the frame about x, in quarters
  int16_t low, high;  // the body's ends along the joint's axis
  int16_t radius;
  int16_t limit;  // of the angle, in hundredths of a radian
} seven_link;

static const seven_link plan[SEVEN_LINKS] = {
    {0, 0, 330, 0, -140, 20, 75, 290}, {0, 0, 0, -1, -75, 75, 70, 176},       {0, -310, 0, 1, -180, 30, 65, 290},
    {80, 0, 0, 1, -70, 70, 62, 290},   {-80, 380, 0, -1, -270, -40, 55, 290}, {0, 0, 0, 1, -60, 60, 58, 290},
    {88, 0, 0, 1, -40, 60, 50, 290},   {0, 0, 107, 0, 0, 60, 45, 0},
};

static gjk_q16 milli(int32_t thousandths) {
  return (gjk_q16)((int64_t)thousandths * 65536 / 1000);
}

// Points on a capsule-like body along z, moved by (dx, 0, 0): rings of twelve.
static void make_points(random_state *random, gjk_vec3 *out, gjk_q16 low, gjk_q16 high, gjk_q16 radius, gjk_q16 dx) {
  for (unsigned i = 0; i < SEVEN_POINTS; i++) {
    const unsigned ring = i / 12;
    const gjk_angle angle = (gjk_angle)((i % 12) * 34315 + ring * 17157);
    const gjk_q16 r = (ring == 0 || ring == 3 ? radius * 7 / 10 : radius) - (gjk_q16)random_below(random, 200);
    const gjk_q16 z = ring == 0 ? low - radius / 2 : ring == 1 ? low : ring == 2 ? high : high + radius / 2;
    gjk_q30 sine, cosine;
    gjk_sine_and_cosine(angle, &sine, &cosine);
    out[i].x = (gjk_q16)(((int64_t)r * cosine) >> 30) + dx;
    out[i].y = (gjk_q16)(((int64_t)r * sine) >> 30);
    out[i].z = z;
  }
}

bool seven_make(seven *s, const gjk_pose *base) {
  const gjk_pose identity = GJK_POSE_IDENTITY;
  const gjk_vec3 x = {GJK_Q16_ONE, 0, 0}, z = {0, 0, GJK_Q16_ONE};
  random_state random = random_seed(7);
  bool made = true;
  for (unsigned i = 0; i < SEVEN_LINKS; i++) {
    const seven_link *p = &plan[i];
    gjk_arm_link *link = &s->links[i];
    link->parent = (uint8_t)(i == 0 ? GJK_ARM_BASE : i - 1);
    link->kind = i < SEVEN_JOINTS ? GJK_ARM_REVOLUTE : GJK_ARM_FIXED;
    link->fixed = identity;
    link->fixed.position.x = milli(p->x);
    link->fixed.position.y = milli(p->y);
    link->fixed.position.z = milli(p->z);
    made = made && gjk_quat_from_axis_angle(&x, p->quarter * GJK_ANGLE(1.5707963), &link->fixed.rotation) == GJK_OK;
    link->axis = z;
    link->upper = p->limit * 655;
    link->lower = -link->upper;
    make_points(&random, s->points[i], milli(p->low), milli(p->high), milli(p->radius), 0);
    s->never[i] = 0;
  }
  // Fingers.
  make_points(&random, s->points[8], milli(70), milli(130), milli(12), milli(35));
  make_points(&random, s->points[9], milli(70), milli(130), milli(12), milli(-35));
  for (unsigned i = 0; i < SEVEN_PARTS; i++) {
    const gjk_shape hull = GJK_HULL(s->points[i], SEVEN_POINTS);
    s->shapes[i] = hull;
    s->parts[i].shape = &s->shapes[i];
    s->parts[i].pose = identity;
    s->parts[i].link = (uint8_t)(i < SEVEN_LINKS ? i : SEVEN_LINKS - 1);
  }
  // Links whose bodies meet at the wrist or the shoulder whatever the joints do.
  s->never[2] = 1u << 0 | 1u << 4;
  s->never[4] = 1u << 6;
  s->never[5] = 1u << 7;
  s->never[3] = 1u << 5 | 1u << 1;
  s->model.links = s->links;
  s->model.parts = s->parts;
  s->model.never = s->never;
  s->model.link_count = SEVEN_LINKS;
  s->model.part_count = SEVEN_PARTS;
  s->memory.links = s->link_room;
  s->memory.parts = s->part_room;
  s->memory.pairs = s->pairs;
  s->memory.pair_capacity = SEVEN_PAIRS;
  return made && gjk_arm_init(&s->arm, &s->model, base, &s->memory) == GJK_OK;
}

bool seven_surround(seven *s, random_state *random, unsigned count) {
  const gjk_vec3 *base = &s->arm.base.position;
  bool made = true;
  for (unsigned i = 0; i < count; i++) {
    gjk_shape *shape = &s->obstacle_shapes[i];
    gjk_pose pose = GJK_POSE_IDENTITY;
    gjk_vec3 axis = {random_range(random, -99, 99), random_range(random, -99, 99), random_range(random, 1, 99)};
    const gjk_q16 most = milli(150);
    for (unsigned k = 0; k < 16; k++) {
      s->obstacle_points[i][k].x = random_range(random, -most, most);
      s->obstacle_points[i][k].y = random_range(random, -most, most);
      s->obstacle_points[i][k].z = random_range(random, -most, most);
    }
    const gjk_shape ball = GJK_SPHERE(random_range(random, milli(20), most));
    const gjk_shape box = GJK_BOX(random_range(random, milli(20), most), random_range(random, milli(20), most),
                                  random_range(random, milli(20), most));
    const gjk_shape hull = GJK_HULL(s->obstacle_points[i], 16);
    const unsigned kind = random_below(random, 4);
    *shape = kind == 0 ? ball : kind == 1 ? hull : box;
    do {  // not in the column that the base stands in
      pose.position.x = random_range(random, milli(-900), milli(900));
      pose.position.y = random_range(random, milli(-900), milli(900));
    } while ((int64_t)pose.position.x * pose.position.x + (int64_t)pose.position.y * pose.position.y <
             (int64_t)milli(350) * milli(350));
    pose.position.z = random_range(random, milli(-200), milli(1200));
    pose.position.x += base->x;
    pose.position.y += base->y;
    pose.position.z += base->z;
    made = made && gjk_quat_from_axis_angle(&axis, random_range(random, -200000, 200000), &pose.rotation) == GJK_OK &&
           gjk_collider_init(&s->obstacles[i], shape, s->obstacle_posed[i], 16) == GJK_OK &&
           gjk_collider_pose(&s->obstacles[i], &pose) == GJK_OK;
  }
  return made && gjk_arm_obstacles(&s->arm, s->obstacles, (uint16_t)count) == GJK_OK;
}

void seven_any(random_state *random, int32_t values[SEVEN_JOINTS]) {
  for (unsigned i = 0; i < SEVEN_JOINTS; i++) {
    values[i] = random_range(random, -plan[i].limit * 600, plan[i].limit * 600);
  }
}

void seven_beside(random_state *random, const int32_t from[SEVEN_JOINTS], int32_t far, int32_t to[SEVEN_JOINTS]) {
  int32_t d[SEVEN_JOINTS];
  uint64_t square = 0;
  for (unsigned i = 0; i < SEVEN_JOINTS; i++) {
    d[i] = random_range(random, -30000, 30000);
    square += (uint64_t)((int64_t)d[i] * d[i]);
  }
  uint32_t length = 1;
  while ((uint64_t)length * length < square) {
    length++;
  }
  for (unsigned i = 0; i < SEVEN_JOINTS; i++) {
    to[i] = from[i] + (int32_t)((int64_t)d[i] * far / (int32_t)length);
  }
}

// What goes into the hash.
static void add_number(uint64_t *hash, int64_t number) {
  *hash = fnv_word(fnv_word(*hash, (uint32_t)((uint64_t)number & UINT32_MAX)), (uint32_t)((uint64_t)number >> 32));
}

static void take_proof(void *user, const gjk_arm_proof *proof) {
  uint64_t *hash = user;
  add_number(hash, proof->from);
  add_number(hash, proof->to);
  add_number(hash, proof->direction.x);
  add_number(hash, proof->direction.y);
  add_number(hash, proof->direction.z);
  add_number(hash, proof->pair);
}

static bool hash_edge(seven *s, const int32_t *from, const int32_t *to, const gjk_arm_setup *setup, uint64_t *hash) {
  gjk_arm_edge_result result;
  if (gjk_arm_edge_start(&s->arm, from, to, setup, take_proof, hash) != GJK_OK ||
      gjk_arm_edge_run(&s->arm, 1000000, &result) != GJK_OK) {
    return false;
  }
  add_number(hash, result.answer);
  add_number(hash, result.lower);
  add_number(hash, result.upper);
  add_number(hash, result.tests);
  add_number(hash, result.answer == GJK_ARM_FREE ? result.gap : result.pair.part * 65536 + result.pair.other);
  return true;
}

static bool hash_still(seven *s, const int32_t *values, uint64_t *hash) {
  gjk_arm_distance_result nearest;
  gjk_q16 gradient[SEVEN_JOINTS];
  if (gjk_arm_distance(&s->arm, values, GJK_DISTANCE_MAX, &nearest) != GJK_OK) {
    return false;
  }
  add_number(hash, nearest.distance.distance);
  add_number(hash, nearest.pair.part * 65536 + nearest.pair.other);
  if (!nearest.distance.intersecting) {
    if (gjk_arm_gradient(&s->arm, values, &nearest, gradient) != GJK_OK) {
      return false;
    }
    for (unsigned i = 0; i < SEVEN_JOINTS; i++) {
      add_number(hash, gradient[i]);
    }
  }
  return true;
}

bool seven_hash(seven *s, uint64_t *hash) {
  const gjk_pose base = {{GJK_Q16(100.0), GJK_Q16(-3.0), 77}, {0, 0, 0, GJK_Q30_ONE}};
  const gjk_arm_setup setup = {500, 100, 1 << 20};
  random_state random = random_seed(77);
  bool done = seven_make(s, &base);
  *hash = FNV_START;
  for (unsigned i = 0; done && i < 24; i++) {
    int32_t from[SEVEN_JOINTS], to[SEVEN_JOINTS];
    seven_any(&random, from);
    seven_beside(&random, from, 98304, to);
    done = (i % 4 != 0 || seven_surround(s, &random, 12)) && hash_edge(s, from, to, &setup, hash) &&
           hash_still(s, from, hash);
  }
  return done;
}
