// Firmware: instructions and stack per cast, one line per family: NAME|mean|worst|iterations x 100|bytes of stack
//
// A is about the origin, B or a ray comes from 3 units away. Fails if an answer is not proven.
#include "count.h"
#include "gjk/gjk.h"
#include "paint.h"
#include "random.h"

#define CAST_WAYS 200

// What B is.
typedef enum cast_mover { CAST_RAY, CAST_SAME, CAST_BALL } cast_mover;

// How the cast ends.
typedef enum cast_end {
  CAST_HITS,    // not at the start
  CAST_FAR,     // a miss by the bounding spheres
  CAST_PASSES,  // another miss, on a way of 6 units
  CAST_STOPS    // a miss on a way of half a unit, too short to arrive
} cast_end;

typedef struct cast_family {
  const char *name;
  uint16_t vertices;  // of each hull; 0: boxes
  cast_mover mover;
  cast_end end;
} cast_family;

static const cast_family cast_families[] = {
    {.name = "ray hits 8-point hull", .vertices = 8, .mover = CAST_RAY, .end = CAST_HITS},
    {.name = "ray misses 8-point hull by the spheres", .vertices = 8, .mover = CAST_RAY, .end = CAST_FAR},
    {.name = "ray passes 8-point hull", .vertices = 8, .mover = CAST_RAY, .end = CAST_PASSES},
    {.name = "ray hits box", .mover = CAST_RAY, .end = CAST_HITS},
    {.name = "ray hits 64-point hull", .vertices = 64, .mover = CAST_RAY, .end = CAST_HITS},
    {.name = "8-point hulls hit", .vertices = 8, .mover = CAST_SAME, .end = CAST_HITS},
    {.name = "8-point hulls miss by the spheres", .vertices = 8, .mover = CAST_SAME, .end = CAST_FAR},
    {.name = "8-point hulls pass", .vertices = 8, .mover = CAST_SAME, .end = CAST_PASSES},
    {.name = "8-point hulls stop before", .vertices = 8, .mover = CAST_SAME, .end = CAST_STOPS},
    {.name = "64-point hulls hit", .vertices = 64, .mover = CAST_SAME, .end = CAST_HITS},
    {.name = "boxes hit", .mover = CAST_SAME, .end = CAST_HITS},
    {.name = "boxes pass", .mover = CAST_SAME, .end = CAST_PASSES},
    {.name = "boxes stop before", .mover = CAST_SAME, .end = CAST_STOPS},
    {.name = "ball hits box", .mover = CAST_BALL, .end = CAST_HITS},
    {.name = "ball passes box", .mover = CAST_BALL, .end = CAST_PASSES},
};

#define VERTICES 64

static random_state random;
static gjk_vec3 vertices[2][VERTICES], buffers[2][VERTICES];
static gjk_shape shapes[2];
static gjk_collider colliders[2];
static gjk_vec3 to;
static gjk_cast_result result;

static gjk_vec3 random_vector(int32_t size) {
  gjk_vec3 v;
  v.x = random_range(&random, -size, size);
  v.y = random_range(&random, -size, size);
  v.z = random_range(&random, -size, size);
  return v;
}

// A vector of least/10 to 1 times size.
static gjk_vec3 shell_vector(int32_t size, int64_t least) {
  for (;;) {
    const gjk_vec3 v = random_vector(size);
    const int64_t squared = (int64_t)v.x * v.x + (int64_t)v.y * v.y + (int64_t)v.z * v.z;
    const int64_t whole = (int64_t)size * size;
    if (squared <= whole && squared >= whole / 100 * (least * least)) {
      return v;
    }
  }
}

static void make_body(const cast_family *family, int i, const gjk_vec3 *position) {
  const gjk_shape hull = GJK_HULL(vertices[i], 0), box = GJK_BOX(0, 0, 0), ball = GJK_SPHERE(GJK_Q16(0.5));
  const bool is_ball = i == 1 && family->mover == CAST_BALL;
  shapes[i] = is_ball ? ball : family->vertices != 0 ? hull : box;
  if (!is_ball) {
    shapes[i].count = family->vertices;
    for (unsigned k = 0; k < family->vertices; k++) {
      vertices[i][k] = shell_vector(GJK_Q16_ONE, 8);
    }
    shapes[i].size.x = random_range(&random, GJK_Q16(0.2), GJK_Q16(1.0));
    shapes[i].size.y = random_range(&random, GJK_Q16(0.2), GJK_Q16(1.0));
    shapes[i].size.z = random_range(&random, GJK_Q16(0.2), GJK_Q16(1.0));
  }
  const gjk_quat q = {random_range(&random, -1000, 1000), random_range(&random, -1000, 1000),
                      random_range(&random, -1000, 1000), random_range(&random, -1000, 1001)};
  gjk_pose pose = GJK_POSE_IDENTITY;
  gjk_quat_normalize(&q, &pose.rotation);
  pose.position = *position;
  colliders[i].state = 0;
  gjk_collider_init(&colliders[i], &shapes[i], buffers[i], VERTICES);
  gjk_collider_pose(&colliders[i], &pose);
}

static void cast(const cast_family *family) {
  const gjk_cast_path path = {NULL, &to, 0};
  if (family->mover == CAST_RAY) {
    gjk_cast_ray(&colliders[0], &colliders[1].position, &to, &result);
  } else {
    gjk_cast(&colliders[0], &colliders[1], &path, &result);
  }
}

static bool is_in_family(const cast_family *family) {
  const bool far = result.certificate.proof == GJK_CAST_PROOF_SPHERES;
  switch (family->end) {
    case CAST_HITS: return result.hit && !result.inside;
    case CAST_FAR: return far;
    case CAST_PASSES: return !result.hit && !far && result.certificate.proof != GJK_CAST_PROOF_SHORT;
    case CAST_STOPS: return !result.hit && !far;
  }
  return false;
}

// Makes the next cast of a family. False: its answer is not proven.
static bool next_cast(const cast_family *family) {
  static const gjk_vec3 origin = {0, 0, 0};
  for (;;) {
    const gjk_vec3 from = shell_vector(GJK_Q16(3.0), 9), aim = shell_vector(GJK_Q16(2.0), 1);
    make_body(family, 0, &origin);
    make_body(family, 1, &from);
    // From B through the aim; a twelfth of that where the way is short.
    const int32_t part = family->end == CAST_STOPS ? 12 : 1;
    to.x = from.x + 2 * (aim.x - from.x) / part;
    to.y = from.y + 2 * (aim.y - from.y) / part;
    to.z = from.z + 2 * (aim.z - from.z) / part;
    cast(family);
    if (is_in_family(family)) {
      const gjk_cast_path path = {NULL, &to, 0};
      return family->mover == CAST_RAY || gjk_check_cast(&colliders[0], &colliders[1], &path, &result) == GJK_OK;
    }
  }
}

// Asks. Returns the iterations.
COUNTED uint32_t run(const cast_family *family) {
  cast(family);
  return result.iterations;
}

// Asks, and returns the instructions. Its variables stay in registers, so that none are counted that move them.
COUNTED uint32_t count_run(const cast_family *family, uint32_t *iterations) {
  const uint32_t start = board_ticks();
  const uint32_t more = run(family);
  const uint32_t count = count_since(start);
  *iterations += more;
  return count;
}

static bool measure(const cast_family *family) {
  count_tally t = {0, 0, 0};
  uint32_t iterations = 0, stack = 0, unproven = 0;
  random = random_seed(51);
  for (unsigned i = 0; i < CAST_WAYS; i++) {
    unproven += !next_cast(family);
    const uintptr_t top = paint_stack();
    count_add(&t, count_run(family, &iterations));
    const uint32_t depth = painted_depth(top);
    stack = depth > stack ? depth : stack;
  }
  count_line(family->name, &t);
  count_field(iterations * 100 / CAST_WAYS);
  count_field(stack);
  board_print("\n");
  return unproven == 0;
}

int firmware_main(void) {
  if (!count_prepare()) {
    return 1;
  }
  for (unsigned i = 0; i < sizeof cast_families / sizeof cast_families[0]; i++) {
    if (!measure(&cast_families[i])) {
      board_print("an answer is not proven\n");
      return 1;
    }
  }
  return 0;
}
