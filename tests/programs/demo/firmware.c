// The demo's scene on a device: answers every pair again and compares the bits with those of the host.
#include "demo_scene.h"

typedef struct line {
  char text[96];
  size_t length;
} line;

static void add_text(line *l, const char *text, size_t width) {
  size_t start = l->length;
  while (*text != '\0' && l->length < sizeof l->text - 2) {
    l->text[l->length++] = *text++;
  }
  while (l->length < start + width && l->length < sizeof l->text - 2) {
    l->text[l->length++] = ' ';
  }
}

static void add_number(line *l, uint32_t value, size_t width) {
  char digits[12];
  size_t at = sizeof digits - 1;
  digits[at] = '\0';
  do {
    digits[--at] = (char)('0' + value % 10);
    value /= 10;
  } while (value > 0 && at > 0);
  for (size_t used = sizeof digits - 1 - at; used < width; used++) {
    add_text(l, " ", 1);
  }
  add_text(l, &digits[at], 0);
}

static void end_line(line *l, void (*print)(const char *text)) {
  l->text[l->length++] = '\n';
  l->text[l->length] = '\0';
  print(l->text);
}

static bool same_numbers(int32_t ax, int32_t ay, int32_t az, int32_t bx, int32_t by, int32_t bz) {
  return ax == bx && ay == by && az == bz;
}

static bool same_points(const gjk_vec3 *a, const gjk_vec3 *b) {
  return same_numbers(a->x, a->y, a->z, b->x, b->y, b->z);
}

static bool same_bits(const gjk_distance_result *r, const demo_pair *pair) {
  if (r->intersecting != pair->intersecting || r->distance != pair->distance || r->iterations != pair->iterations) {
    return false;
  }
  return r->intersecting ||
         (same_points(&r->point_a, &pair->point_a) && same_points(&r->point_b, &pair->point_b) &&
          same_numbers(r->normal.x, r->normal.y, r->normal.z, pair->normal.x, pair->normal.y, pair->normal.z));
}

// False: the pair has no answer. spent: the instructions of the query alone.
static bool answer(const demo_pair *pair, uint32_t (*instructions)(void), gjk_distance_result *result,
                   uint32_t *spent) {
  static gjk_vec3 buffer[2][DEMO_HULL_VERTICES_MAX];
  gjk_collider a = {0}, b = {0};
  if (gjk_collider_init(&a, &pair->a, buffer[0], DEMO_HULL_VERTICES_MAX) != GJK_OK ||
      gjk_collider_init(&b, &pair->b, buffer[1], DEMO_HULL_VERTICES_MAX) != GJK_OK ||
      gjk_collider_pose(&a, &pair->pose_a) != GJK_OK || gjk_collider_pose(&b, &pair->pose_b) != GJK_OK) {
    return false;
  }
  uint32_t start = instructions();
  gjk_status status = gjk_distance(&a, &b, NULL, result);
  *spent = instructions() - start;
  return status == GJK_OK;
}

// Finds the arm's frames both ways. False: they differ from the host's, or from each other.
static bool arm_again(void (*print)(const char *text), uint32_t (*instructions)(void)) {
  static gjk_joint joints[ARM_JOINTS];
  static gjk_pose chain[ARM_JOINTS], composed[ARM_JOINTS];
  bool same = arm_make(joints);
  const uint32_t start = instructions();
  same = arm_frames(joints, chain) && same;
  const uint32_t between = instructions();
  same = arm_frames_composed(composed) && same;
  const uint32_t end = instructions();
  for (unsigned i = 0; i < ARM_JOINTS; i++) {
    const gjk_pose *a = &chain[i], *b = &demo_arm[i];
    same = same_points(&a->position, &b->position) && a->rotation.w == b->rotation.w &&
           same_numbers(a->rotation.x, a->rotation.y, a->rotation.z, b->rotation.x, b->rotation.y, b->rotation.z) &&
           same;
  }
  line l = {{0}, 0};
  add_text(&l, "the arm's ", 0);
  add_number(&l, ARM_JOINTS, 1);
  add_text(&l, same ? " joints, same bits: " : " joints, DIFFERENT: ", 0);
  add_number(&l, between - start, 1);
  add_text(&l, " instructions; composed one by one ", 0);
  add_number(&l, end - between, 1);
  end_line(&l, print);
  return same && arm_frames_near(chain, composed);
}

int demo_firmware(void (*print)(const char *text), uint32_t (*instructions)(void)) {
  unsigned differing = 0;
  uint32_t total = 0;
  for (unsigned i = 0; i < demo_pair_count; i++) {
    const demo_pair *pair = &demo_pairs[i];
    gjk_distance_result result;
    uint32_t spent = 0;
    bool same = answer(pair, instructions, &result, &spent) && same_bits(&result, pair);
    line l = {{0}, 0};
    add_number(&l, i + 1, 3);
    add_text(&l, "  ", 2);
    add_text(&l, pair->id, 36);
    add_text(&l, same ? "same bits " : "DIFFERENT ", 10);
    add_number(&l, spent, 8);
    add_text(&l, " instructions", 0);
    end_line(&l, print);
    differing += same ? 0 : 1;
    total += spent;
  }
  line summary = {{0}, 0};
  add_number(&summary, demo_pair_count, 1);
  add_text(&summary, " pairs: ", 0);
  add_number(&summary, demo_pair_count - differing, 1);
  add_text(&summary, " the same bits as on the host, ", 0);
  add_number(&summary, differing, 1);
  add_text(&summary, " different; mean ", 0);
  add_number(&summary, demo_pair_count > 0 ? total / demo_pair_count : 0, 1);
  add_text(&summary, " instructions", 0);
  end_line(&summary, print);
  return (int)differing + (arm_again(print, instructions) ? 0 : 1);
}
