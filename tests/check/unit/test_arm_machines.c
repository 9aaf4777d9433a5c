// Edges of machines of any make against the truth in double: trees of revolute, prismatic and fixed joints, parts of all
// kinds at poses of their own, long thin links, several turns, bases far from the origin, no motion at all.
#include "gjk/arm.h"

#include <math.h>

#include "arm/arm_truth.h"
#include "check.h"
#include "random_vec.h"

#define EDGES 4000
#define LINKS 6
#define PARTS 8
#define OBSTACLES 5
#define PROOFS_MAX 60000

static struct {
  gjk_arm_link links[LINKS];
  gjk_arm_part parts[PARTS];
  uint32_t never[LINKS];
  gjk_arm_model model;
  gjk_shape shapes[PARTS + OBSTACLES];
  gjk_vec3 points[PARTS + OBSTACLES][10];
  gjk_collider obstacles[OBSTACLES];
  gjk_arm_link_room link_room[LINKS];
  gjk_arm_part_room part_room[PARTS];
  gjk_arm_pair pairs[GJK_ARM_PAIRS(PARTS, OBSTACLES)];
  gjk_arm_memory memory;
  gjk_arm arm;
  int32_t from[LINKS], to[LINKS];
} machine;

static gjk_arm_proof proofs[PROOFS_MAX];
static uint32_t proof_count;

static void take(void *user, const gjk_arm_proof *proof) {
  (void)user;
  if (proof_count < PROOFS_MAX) {
    proofs[proof_count] = *proof;
  }
  proof_count++;
}

static gjk_pose any_pose(random_state *random, int32_t most) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  const gjk_vec3 axis = random_in_cube(random, 99);
  pose.position = random_in_cube(random, most);
  (void)gjk_quat_from_axis_angle(&axis, random_range(random, -300000, 300000), &pose.rotation);
  return pose;
}

// A shape of any kind, about size large; thin: 100 times as long as thick.
static gjk_shape any_shape(random_state *random, int32_t size, gjk_vec3 points[10]) {
  const bool thin = random_below(random, 4) == 0;
  const int32_t x = random_range(random, size / 4, size),
                y = thin ? size / 100 + 1 : random_range(random, size / 4, size);
  for (unsigned i = 0; i < 10; i++) {
    points[i] = random_in_cube(random, size);
    points[i].y = thin ? points[i].y / 100 : points[i].y;
    points[i].z = thin ? points[i].z / 100 : points[i].z;
  }
  const gjk_shape shapes[] = {GJK_HULL(points, 10), GJK_ROUNDED_HULL(points, 10, y / 4),
                              GJK_BOX(x, y, y),     GJK_SPHERE(x),
                              GJK_CAPSULE(y, x),    GJK_TRIANGLE(points),
                              GJK_CYLINDER(y, x),   GJK_CONE(x, y)};
  // The curved kinds are rare, since their decisions take a while.
  return shapes[random_below(random, random_below(random, 4) == 0 ? 8 : 6)];
}

static unsigned make_links(random_state *random, int32_t size) {
  const unsigned links = 1 + random_below(random, LINKS);
  unsigned value = 0;
  for (unsigned i = 0; i < links; i++) {
    gjk_arm_link *link = &machine.links[i];
    const unsigned kind = random_below(random, 8);
    link->parent = (uint8_t)(i == 0 || random_below(random, 8) == 0 ? GJK_ARM_BASE
                             : random_below(random, 3) == 0         ? random_below(random, i)
                                                                    : i - 1);
    link->kind = kind < 5 || i == 0 ? GJK_ARM_REVOLUTE : kind < 7 ? GJK_ARM_PRISMATIC : GJK_ARM_FIXED;
    link->fixed = any_pose(random, size);
    link->axis = random_in_cube(random, 1000);
    link->axis.x = (link->axis.y | link->axis.z) == 0 ? 1 : link->axis.x;
    link->lower = -100000;
    link->upper = 100000;
    machine.never[i] = random_below(random, 3) == 0 ? random_u32(random) : 0;
    if (link->kind != GJK_ARM_FIXED) {
      const int32_t far = link->kind == GJK_ARM_PRISMATIC ? size : 60000;
      machine.from[value] = random_range(random, -far, far);
      machine.to[value] = random_below(random, 4) == 0 ? machine.from[value] : random_range(random, -far, far);
      if (link->kind == GJK_ARM_REVOLUTE && random_below(random, 30) == 0) {
        machine.to[value] = random_range(random, -1200000, 1200000);  // some three turns
      }
      value++;
    }
  }
  return links;
}

static bool make_machine(random_state *random) {
  const int32_t size = INT32_C(1) << (10 + random_below(random, 12));
  const unsigned links = make_links(random, size), parts = 1 + random_below(random, PARTS);
  gjk_pose base = any_pose(random, random_below(random, 3) == 0 ? INT32_C(1) << 30 : size);
  const gjk_vec3 *at = &base.position;
  for (unsigned i = 0; i < parts; i++) {
    const gjk_pose identity = GJK_POSE_IDENTITY;
    machine.shapes[i] = any_shape(random, size / 2, machine.points[i]);
    machine.parts[i].shape = &machine.shapes[i];
    machine.parts[i].pose = random_below(random, 2) == 0 ? identity : any_pose(random, size / 2);
    machine.parts[i].link = (uint8_t)random_below(random, links);
  }
  const gjk_arm_model model = {machine.links, machine.parts, random_below(random, 2) == 0 ? NULL : machine.never,
                               (uint8_t)links, (uint16_t)parts};
  const gjk_arm_memory memory = {machine.link_room, machine.part_room, machine.pairs, GJK_ARM_PAIRS(PARTS, OBSTACLES)};
  machine.model = model;
  if (gjk_arm_init(&machine.arm, &machine.model, &base, &memory) != GJK_OK) {
    return false;
  }
  const unsigned obstacles = random_below(random, OBSTACLES + 1);
  for (unsigned i = 0; i < obstacles; i++) {
    const bool far = random_below(random, 10) == 0;
    gjk_pose pose = any_pose(random, far ? INT32_MAX : 4 * size);
    if (!far) {
      pose.position.x += at->x;
      pose.position.y += at->y;
      pose.position.z += at->z;
    }
    machine.shapes[PARTS + i] = any_shape(random, size, machine.points[PARTS + i]);
    if (gjk_collider_init(&machine.obstacles[i], &machine.shapes[PARTS + i], NULL, 0) != GJK_OK ||
        gjk_collider_pose(&machine.obstacles[i], &pose) != GJK_OK) {
      return false;
    }
  }
  return gjk_arm_obstacles(&machine.arm, machine.obstacles, (uint16_t)obstacles) == GJK_OK;
}

static unsigned long answers[3], samples_sum;

static void check_edge(const gjk_arm_setup *setup) {
  gjk_arm_edge_result result = {.answer = GJK_ARM_UNSETTLED};
  const int32_t *from = machine.from, *to = machine.to;
  unsigned samples = 0;
  proof_count = 0;
  CHECK(gjk_arm_edge_start(&machine.arm, from, to, setup, take, NULL) == GJK_OK);
  CHECK(gjk_arm_edge_run(&machine.arm, 1000000, &result) == GJK_OK);
  answers[result.answer]++;
  const double lower = result.lower / (double)GJK_Q30_ONE, upper = result.upper / (double)GJK_Q30_ONE;
  const double close = (double)setup->margin + setup->tolerance;
  if (proof_count <= PROOFS_MAX) {
    CHECK(gjk_check_edge(&machine.arm, from, to, setup, &result, proofs, proof_count) == GJK_OK);
  }
  CHECK(lower == 0 || arm_truth_edge(&machine.arm, from, to, 0, lower, setup->margin, &samples) != ARM_TRUTH_TOUCH);
  if (result.answer == GJK_ARM_FREE) {
    CHECK(result.gap >= setup->margin);
    CHECK(arm_truth_edge(&machine.arm, from, to, 0, 1, result.gap - 1.0, &samples) != ARM_TRUTH_TOUCH);
  } else {
    CHECK(result.answer == GJK_ARM_TOUCH);
    CHECK(arm_truth_pair(&machine.arm, from, to, upper, &result.pair) <= close + ARM_TRUTH_ERROR);
    CHECK(result.lower <= result.upper && result.upper - result.lower <= setup->resolution + 1024);
  }
  samples_sum += samples;
}

static void check_poses(random_state *random) {
  gjk_pose poses[LINKS], truth;
  (void)random;
  CHECK(gjk_arm_poses(&machine.arm, machine.to, poses) == GJK_OK);
  for (unsigned i = 0; i < machine.model.link_count; i++) {
    arm_truth_pose(&machine.arm, machine.from, machine.to, 1, i, &truth);
    CHECK(labs((long)poses[i].position.x - truth.position.x) <= 2);
    CHECK(labs((long)poses[i].position.y - truth.position.y) <= 2);
    CHECK(labs((long)poses[i].position.z - truth.position.z) <= 2);
    const int sign = (double)poses[i].rotation.w * truth.rotation.w + (double)poses[i].rotation.x * truth.rotation.x +
                                 (double)poses[i].rotation.y * truth.rotation.y +
                                 (double)poses[i].rotation.z * truth.rotation.z <
                             0
                         ? -1
                         : 1;
    CHECK(labs((long)poses[i].rotation.x - sign * truth.rotation.x) < 64);
    CHECK(labs((long)poses[i].rotation.w - sign * truth.rotation.w) < 64);
  }
}

static unsigned long gradients;

// How fast the point moves along the normal as the joint's value rises, and how far it is from the joint's origin. In double.
static double speed_of(unsigned link, const gjk_vec3 *p, const gjk_unit3 *normal, double *lever) {
  const gjk_vec3 *axis = &machine.links[link].axis;
  const double length = sqrt((double)axis->x * axis->x + (double)axis->y * axis->y + (double)axis->z * axis->z);
  gjk_pose pose;
  arm_truth_pose(&machine.arm, machine.from, machine.from, 0, link, &pose);
  const double q[4] = {pose.rotation.x / 1073741824.0, pose.rotation.y / 1073741824.0, pose.rotation.z / 1073741824.0,
                       pose.rotation.w / 1073741824.0};
  const double a[3] = {axis->x / length, axis->y / length, axis->z / length};
  // z = a + 2 q x (q x a + w a)
  const double t[3] = {q[1] * a[2] - q[2] * a[1] + q[3] * a[0], q[2] * a[0] - q[0] * a[2] + q[3] * a[1],
                       q[0] * a[1] - q[1] * a[0] + q[3] * a[2]};
  const double z[3] = {a[0] + 2 * (q[1] * t[2] - q[2] * t[1]), a[1] + 2 * (q[2] * t[0] - q[0] * t[2]),
                       a[2] + 2 * (q[0] * t[1] - q[1] * t[0])};
  const double r[3] = {(double)p->x - pose.position.x, (double)p->y - pose.position.y, (double)p->z - pose.position.z};
  const double n[3] = {normal->x / 1073741824.0, normal->y / 1073741824.0, normal->z / 1073741824.0};
  *lever = sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
  if (machine.links[link].kind == GJK_ARM_PRISMATIC) {
    return 65536 * (n[0] * z[0] + n[1] * z[1] + n[2] * z[2]);
  }
  return n[0] * (z[1] * r[2] - z[2] * r[1]) + n[1] * (z[2] * r[0] - z[0] * r[2]) + n[2] * (z[0] * r[1] - z[1] * r[0]);
}

static bool is_above(unsigned link, unsigned below) {
  while (below != link && machine.links[below].parent != GJK_ARM_BASE) {
    below = machine.links[below].parent;
  }
  return below == link;
}

// The distance after the value has changed by a step.
static double moved_gap(unsigned value, int32_t step, const gjk_arm_names *pair) {
  int32_t moved[LINKS];
  for (unsigned k = 0; k < machine.arm.value_count; k++) {
    moved[k] = machine.from[k];
  }
  moved[value] += step;
  return arm_truth_pair(&machine.arm, moved, moved, 0, pair);
}

// A slope against the derivative along the normal; and against differences of distances, whose one-sided slopes may differ.
static void check_slope(const gjk_arm_distance_result *here, unsigned link, unsigned value, gjk_q16 slope) {
  const bool part = is_above(link, machine.parts[here->pair.part].link);
  const bool other = !here->pair.obstacle && is_above(link, machine.parts[here->pair.other].link);
  const gjk_distance_result *d = &here->distance;
  double lever = 0;
  const double speed = part == other ? 0
                       : part        ? speed_of(link, &d->point_b, &d->normal, &lever)
                                     : -speed_of(link, &d->point_a, &d->normal, &lever);
  CHECK_MSG(fabs(slope - speed) <= 3 + lever / 67108864 + 0.9, "%ld, not %g", (long)slope, speed);
  const double step = 256, angle = step / 65536, gap = d->distance;
  const double before = moved_gap(value, -256, &here->pair), after = moved_gap(value, 256, &here->pair);
  const double slopes[2] = {(gap - before) / angle, (after - gap) / angle};
  // Distances are off by up to 8; over the step the points move by lever angle, which bends a distance by its square.
  const bool turns = machine.links[link].kind == GJK_ARM_REVOLUTE;
  const double way = turns ? (lever + 10) * angle : step;
  const double slack = 8 / angle + (way * way / (gap - way) + way) / angle * 2;
  if (way < gap / 4) {
    CHECK(slope >= fmin(slopes[0], slopes[1]) - slack && slope <= fmax(slopes[0], slopes[1]) + slack);
    gradients += part != other ? 1u : 0u;
  }
}

static void check_gradient(void) {
  gjk_arm_distance_result here;
  gjk_q16 gradient[LINKS];
  unsigned value = 0;
  if (gjk_arm_distance(&machine.arm, machine.from, GJK_DISTANCE_MAX, &here) != GJK_OK || here.distance.intersecting ||
      here.distance.saturated) {
    return;
  }
  CHECK(fabs(here.distance.distance - arm_truth_gap(&machine.arm, machine.from, machine.from, 0, 1e12)) <=
        ARM_TRUTH_ERROR);
  CHECK(gjk_arm_gradient(&machine.arm, machine.from, &here, gradient) == GJK_OK);
  for (unsigned i = 0; i < machine.model.link_count; i++) {
    if (machine.links[i].kind != GJK_ARM_FIXED) {
      check_slope(&here, i, value, gradient[value]);
      value++;
    }
  }
}

int main(void) {
  random_state random = random_seed(check_seed(3102));
  const unsigned long edges = check_trials(EDGES);
  for (unsigned long i = 0; i < edges; i++) {
    check_trial(i, NULL, NULL);
    if (!make_machine(&random)) {
      CHECK(false);
      continue;
    }
    const gjk_arm_setup setup = {random_below(&random, 2) == 0 ? 0 : random_range(&random, 0, 3000),
                                 GJK_ARM_TOLERANCE_MIN + (gjk_q16)random_below(&random, 3) * 200,
                                 random_below(&random, 2) == 0 ? GJK_Q30_ONE : 1 << 22};
    check_edge(&setup);
    check_poses(&random);
    check_gradient();
  }
  printf("%lu free, %lu touch, %lu samples an edge, %lu slopes\n", answers[GJK_ARM_FREE], answers[GJK_ARM_TOUCH],
         samples_sum / edges, gradients);
  CHECK(edges < 100 ||
        (answers[GJK_ARM_FREE] > edges / 8 && answers[GJK_ARM_TOUCH] > edges / 8 && gradients > edges / 2));
  return check_done("arm machines");
}
