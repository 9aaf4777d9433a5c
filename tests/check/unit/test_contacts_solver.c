// Stacks, pyramids and walls under a solver that starts from last tick's impulses by the ids of contacts alone: they stand,
// come to rest, and still rest where they were after 2,400 ticks.
#include "solver/solver.h"

#include "check.h"

#define ONE GJK_Q16_ONE
#define TICKS 2400

// From here on a pile must rest: no body faster than AWAKE, in units or radians a second, none farther from here than DRIFT.
#define SETTLED 400
#define AWAKE 0.01
#define DRIFT (ONE / 500)

// How often a tick goes over all impulses. A stack of ten passes them on from body to body.
#define HIGH 60
#define BROAD 12

static const gjk_shape ground = GJK_BOX(20 * ONE, 20 * ONE, ONE), crate = GJK_BOX(ONE / 2, ONE / 2, ONE / 2),
                       brick = GJK_BOX(ONE / 2, ONE / 4, ONE / 5), half_brick = GJK_BOX(ONE / 4, ONE / 4, ONE / 5),
                       drum = GJK_CYLINDER(ONE / 2, ONE / 2),
                       cushion = GJK_ROUNDED_BOX(ONE * 2 / 5, ONE * 2 / 5, ONE * 2 / 5, ONE / 10);
static const gjk_vec3 corners[12] = {{32768, 0, -32768},  {16384, 28378, -32768},   {-16384, 28378, -32768},
                                     {-32768, 0, -32768}, {-16384, -28378, -32768}, {16384, -28378, -32768},
                                     {32768, 0, 32768},   {16384, 28378, 32768},    {-16384, 28378, 32768},
                                     {-32768, 0, 32768},  {-16384, -28378, 32768},  {16384, -28378, 32768}};
static const uint16_t around[36] = {5, 4, 3, 2, 1, 0, 6, 7, 8,  9, 10, 11, 0,  1,  7, 6, 1, 2,
                                    8, 7, 2, 3, 9, 8, 3, 4, 10, 9, 4,  5,  11, 10, 5, 0, 6, 11},
                      ends[8] = {6, 12, 16, 20, 24, 28, 32, 36};
static const gjk_hull_faces faces = {around, ends, 8};
static const gjk_shape prism = GJK_HULL_WITH_FACES(corners, 12, &faces);

static solver_world world;
static gjk_vec3 begin[SOLVER_BODIES_MAX];

static void add(const gjk_shape *shape, gjk_q16 hx, gjk_q16 hy, gjk_q16 hz, gjk_q16 x, gjk_q16 z) {
  const gjk_vec3 half = {hx, hy, hz};
  gjk_pose pose = GJK_POSE_IDENTITY;
  pose.position.x = x;
  pose.position.z = z;
  solver_add(&world, shape, half, &pose, false);
}

static void start(unsigned iterations) {
  const gjk_vec3 none = {0, 0, 0};
  gjk_pose pose = GJK_POSE_IDENTITY;
  pose.position.z = -ONE;
  solver_init(&world, iterations);
  solver_add(&world, &ground, none, &pose, true);
}

static void stack(const gjk_shape *shape) {
  for (int i = 0; i < 10; i++) {
    add(shape, ONE / 2, ONE / 2, ONE / 2, 0, ONE / 2 + i * ONE);
  }
}

static void pyramid(const gjk_shape *shape) {
  for (int row = 0; row < 9; row++) {
    for (int i = 0; i < 9 - row; i++) {
      add(shape, ONE / 2, ONE / 2, ONE / 2, (2 * i + row - 8) * (ONE / 2 + ONE / 40), ONE / 2 + row * ONE);
    }
  }
}

static void wall(const gjk_shape *shape) {
  for (int row = 0; row < 8; row++) {
    const gjk_q16 z = ONE / 5 + row * (2 * (ONE / 5));
    for (int i = 0; i < 6 - row % 2; i++) {
      add(shape, ONE / 2, ONE / 4, ONE / 5, (2 * i - 5 + row % 2) * (ONE / 2), z);
    }
    if (row % 2 == 1) {
      add(&half_brick, ONE / 4, ONE / 4, ONE / 5, -11 * (ONE / 4), z);
      add(&half_brick, ONE / 4, ONE / 4, ONE / 5, 11 * (ONE / 4), z);
    }
  }
}

static gjk_q16 farther(gjk_q16 most, gjk_q16 a, gjk_q16 b) {
  const gjk_q16 by = a < b ? b - a : a - b;
  return by > most ? by : most;
}

// The farthest that any body is from where it was when it had to be at rest.
static gjk_q16 drift(void) {
  gjk_q16 most = 0;
  for (unsigned i = 0; i < world.bodies; i++) {
    const gjk_vec3 *p = &world.body[i].pose.position;
    most = farther(farther(farther(most, p->x, begin[i].x), p->y, begin[i].y), p->z, begin[i].z);
  }
  return most;
}

static void run(const char *name) {
  solver_fix speed = 0;
  for (int tick = 0; tick < TICKS; tick++) {
    solver_step(&world);
    for (unsigned i = 0; i < world.bodies && tick == SETTLED; i++) {
      begin[i] = world.body[i].pose.position;
    }
    speed = tick >= SETTLED && solver_speed(&world) > speed ? solver_speed(&world) : speed;
  }
  const double unit = (double)SOLVER_ONE, later = (double)speed / unit, last = (double)solver_speed(&world) / unit;
  printf("%-8s %2u bodies: after tick %d at most %.6f a second, at last %.6f, drift %.5f; %lu of %lu points fresh\n",
         name, world.bodies - 1, SETTLED, later, last, drift() / 65536.0, world.fresh, world.points);
  CHECK_MSG(later <= AWAKE, "%s: %.6f", name, later);
  CHECK_MSG(last <= AWAKE / 10, "%s: %.6f", name, last);
  CHECK_MSG(drift() <= DRIFT, "%s: %.6f", name, drift() / 65536.0);
  CHECK_MSG(world.fresh * 1000 <= world.points, "%s: %lu of %lu points fresh", name, world.fresh, world.points);
  CHECK_MSG(world.points > (unsigned long)TICKS * 4 * (world.bodies - 1) / 5, "%s: %lu points", name, world.points);
}

typedef struct pile {
  const char *name;
  void (*make)(const gjk_shape *shape);
  const gjk_shape *shape;
  unsigned iterations;
  uint32_t hash;  // of how it ends, the same on every machine
} pile;

int main(void) {
  static const pile piles[] = {
      {.name = "crates", .make = stack, .shape = &crate, .iterations = HIGH, .hash = UINT32_C(0xDB507D69)},
      {.name = "drums", .make = stack, .shape = &drum, .iterations = HIGH, .hash = UINT32_C(0x5F5CEF9E)},
      {.name = "cushions", .make = stack, .shape = &cushion, .iterations = HIGH, .hash = UINT32_C(0x9354C1B8)},
      {.name = "prisms", .make = stack, .shape = &prism, .iterations = HIGH, .hash = UINT32_C(0x15082D32)},
      {.name = "pyramid", .make = pyramid, .shape = &crate, .iterations = BROAD, .hash = UINT32_C(0xA06DB968)},
      {.name = "wall", .make = wall, .shape = &brick, .iterations = BROAD, .hash = UINT32_C(0x6FB5C06B)},
  };
  const unsigned long count = check_trials(sizeof piles / sizeof piles[0]);
  for (unsigned long i = 0; i < count; i++) {
    start(piles[i].iterations);
    piles[i].make(piles[i].shape);
    run(piles[i].name);
    CHECK_MSG(solver_hash(&world) == piles[i].hash, "%s: 0x%08lX", piles[i].name, (unsigned long)solver_hash(&world));
  }
  return check_done("contacts_solver");
}
