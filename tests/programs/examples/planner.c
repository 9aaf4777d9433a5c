// A path for an arm that reaches through a window: RRT-Connect in the space of its joints, then shortened; every edge of it
// is proven free of contact, between the samples too. With the name of a file it draws the way there, as SVG.
#include <stdio.h>
#include <stdlib.h>

#include "gjk/gjk.h"

#define JOINTS 3
#define NODES 400
#define TESTS 2000  // of an edge
#define STEP 26214  // the longest edge, 0.4 radians in the joint that moves most

// Shoulder, upper arm, forearm, each 1 unit long. The wall in front of it is two beams above each other, and one each side.
static const gjk_shape upper = GJK_CAPSULE(GJK_Q16(0.08), GJK_Q16(0.4)),
                       fore = GJK_CAPSULE(GJK_Q16(0.06), GJK_Q16(0.4));
static const gjk_shape beam = GJK_BOX(GJK_Q16(0.05), GJK_Q16(1.5), GJK_Q16(0.5));
static const gjk_shape side = GJK_BOX(GJK_Q16(0.05), GJK_Q16(0.6), GJK_Q16(1.5));
static const gjk_vec3 beam_at[4] = {{GJK_Q16(0.9), 0, GJK_Q16(0.2)},
                                    {GJK_Q16(0.9), 0, GJK_Q16(1.8)},
                                    {GJK_Q16(0.9), GJK_Q16(0.9), GJK_Q16(1.0)},
                                    {GJK_Q16(0.9), GJK_Q16(-0.9), GJK_Q16(1.0)}};
static const gjk_arm_link links[] = {
    {GJK_ARM_BASE, GJK_ARM_REVOLUTE, {{0, 0, GJK_Q16(0.5)}, {0, 0, 0, GJK_Q30_ONE}}, {0, 0, 1}, -196608, 196608},
    {0, GJK_ARM_REVOLUTE, GJK_POSE_IDENTITY, {0, 1, 0}, -131072, 131072},
    {1, GJK_ARM_REVOLUTE, {{0, 0, GJK_Q16(1.0)}, {0, 0, 0, GJK_Q30_ONE}}, {0, 1, 0}, -163840, 163840}};
static const gjk_arm_part parts[] = {{&upper, {{0, 0, GJK_Q16(0.5)}, {0, 0, 0, GJK_Q30_ONE}}, 1},
                                     {&fore, {{0, 0, GJK_Q16(0.5)}, {0, 0, 0, GJK_Q30_ONE}}, 2}};
static const gjk_arm_model model = {links, parts, NULL, 3, 2};

static gjk_arm_link_room link_room[3];
static gjk_arm_part_room part_room[2];
static gjk_arm_pair pairs[GJK_ARM_PAIRS(2, 4)];
static gjk_arm arm;

typedef struct tree {
  int32_t at[NODES][JOINTS];
  int parent[NODES], count;
} tree;

static tree trees[2] = {{.parent = {-1}, .count = 1}, {.parent = {-1}, .count = 1}};
static const int32_t *way[2 * NODES], *kept[2 * NODES];  // through both trees; what is left of it

static uint32_t next_random(void) {
  static uint32_t state = 1;
  state = state * 1664525u + 1013904223u;
  return state >> 8;
}

// At least 0.01 units must stay between the arm and the wall.
static bool is_free(const int32_t *from, const int32_t *to) {
  const gjk_arm_setup setup = {GJK_Q16(0.01), GJK_Q16(0.002), GJK_Q30_ONE};
  gjk_arm_edge_result result;
  return gjk_arm_edge_start(&arm, from, to, &setup, NULL, NULL) == GJK_OK &&
         gjk_arm_edge_run(&arm, TESTS, &result) == GJK_OK && result.answer == GJK_ARM_FREE;
}

static int64_t square(const int32_t *a, const int32_t *b) {
  const int64_t x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  return x * x + y * y + z * z;
}

// A step from the tree's nearest node towards a configuration. Returns the new node, or -1.
static int extend(tree *t, const int32_t *to) {
  int nearest = 0;
  int32_t most = 1, there[JOINTS];
  for (int i = 1; i < t->count; i++) {
    nearest = square(t->at[i], to) < square(t->at[nearest], to) ? i : nearest;
  }
  const int32_t *from = t->at[nearest];
  for (int i = 0; i < JOINTS; i++) {
    most = abs(to[i] - from[i]) > most ? abs(to[i] - from[i]) : most;
  }
  for (int i = 0; i < JOINTS; i++) {
    there[i] = most <= STEP ? to[i] : from[i] + (int32_t)((int64_t)(to[i] - from[i]) * STEP / most);
  }
  if (t->count == NODES || !is_free(from, there)) {
    return -1;
  }
  for (int i = 0; i < JOINTS; i++) {
    t->at[t->count][i] = there[i];
  }
  t->parent[t->count] = nearest;
  return t->count++;
}

// Grows both trees until they meet: the nodes that are in one place. False: they do not.
static bool connect(int met[2]) {
  for (int round = 0; round < 4 * NODES; round++) {
    tree *one = &trees[round % 2], *other = &trees[1 - round % 2];
    int32_t goal[JOINTS];
    for (int i = 0; i < JOINTS; i++) {
      goal[i] = links[i].lower + (int32_t)(next_random() % (uint32_t)(links[i].upper - links[i].lower));
    }
    const int reached = extend(one, goal);
    for (int last = 0; reached >= 0 && last >= 0;) {
      last = extend(other, one->at[reached]);
      if (last >= 0 && square(other->at[last], one->at[reached]) == 0) {
        met[round % 2] = reached;
        met[1 - round % 2] = last;
        return true;
      }
    }
  }
  return false;
}

// The way through both trees; then nodes are left out where the edge past them is free. Returns how many edges are left.
static int shorten(const int met[2]) {
  int first = NODES, last = NODES, edges = 0;
  for (int i = met[0]; i >= 0; i = trees[0].parent[i]) {
    way[--first] = trees[0].at[i];
  }
  for (int i = trees[1].parent[met[1]]; i >= 0; i = trees[1].parent[i]) {
    way[last++] = trees[1].at[i];
  }
  for (int next; first + 1 < last; first = next, edges++) {
    kept[edges] = way[first];
    for (next = last - 1; next > first + 1 && !is_free(way[first], way[next]); next--) {
    }
  }
  kept[edges] = way[first];
  return edges;
}

// A line of an outline, seen from the left and above: x goes right, y away from us.
static void draw_line(void *file, const gjk_vec3 *a, const gjk_vec3 *b, gjk_draw_role role) {
  (void)role;
  fprintf(file, "M%.1f %.1fL%.1f %.1f", 180 + a->x / 560.0 + a->y / 1100.0, 400 - a->z / 560.0 - a->y / 1500.0,
          180 + b->x / 560.0 + b->y / 1100.0, 400 - b->z / 560.0 - b->y / 1500.0);
}

static void draw_arm(const gjk_draw *draw, const int32_t *values, const char *colour) {
  gjk_pose poses[JOINTS], pose;
  gjk_collider part = {0};
  fprintf(draw->user, "<path fill=\"none\" stroke-width=\"0.6\" stroke=\"%s\" d=\"", colour);
  for (int i = 0; i < 2 && gjk_arm_poses(&arm, values, poses) == GJK_OK; i++) {
    if (gjk_pose_compose(&poses[parts[i].link], &parts[i].pose, &pose) == GJK_OK &&
        gjk_collider_init(&part, parts[i].shape, NULL, 0) == GJK_OK && gjk_collider_pose(&part, &pose) == GJK_OK) {
      gjk_draw_collider(draw, &part, GJK_DRAW_MOVING);
    }
  }
  fprintf(draw->user, "\"/>\n");
}

// What the arm sweeps on its way in grey, the wall in black, the ends in blue and red.
static void draw_way(FILE *file, const gjk_collider *wall, int edges) {
  const gjk_draw draw = {draw_line, NULL, file};
  int32_t values[JOINTS];
  fprintf(file, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 480 540\">\n");
  for (int k = 0; k <= 24 * edges; k++) {
    const int edge = k < 24 * edges ? k / 24 : edges - 1;
    for (int i = 0; i < JOINTS; i++) {
      values[i] = kept[edge][i] + (int32_t)((int64_t)(kept[edge + 1][i] - kept[edge][i]) * (k - 24 * edge) / 24);
    }
    draw_arm(&draw, values, "#ccc");
  }
  fprintf(file, "<path fill=\"none\" stroke=\"#000\" d=\"");
  for (int i = 0; i < 4; i++) {
    gjk_draw_collider(&draw, &wall[i], GJK_DRAW_STATIC);
  }
  fprintf(file, "\"/>\n");
  draw_arm(&draw, kept[0], "#06c");
  draw_arm(&draw, kept[edges], "#c00");
  fprintf(file, "</svg>\n");
}

int main(int count, char **names) {
  static const int32_t ends[2][JOINTS] = {{GJK_ANGLE(1.4), GJK_ANGLE(0.3), GJK_ANGLE(0.5)},
                                          {0, GJK_ANGLE(0.8), GJK_ANGLE(0.95)}};  // beside the wall, through the window
  const gjk_arm_memory memory = {link_room, part_room, pairs, GJK_ARM_PAIRS(2, 4)};
  gjk_collider wall[4];
  gjk_pose base = GJK_POSE_IDENTITY, pose = GJK_POSE_IDENTITY;
  int met[2];
  for (int i = 0; i < 4; i++) {
    pose.position = beam_at[i];
    gjk_collider_init(&wall[i], i < 2 ? &beam : &side, NULL, 0);
    gjk_collider_pose(&wall[i], &pose);
  }
  if (gjk_arm_init(&arm, &model, &base, &memory) != GJK_OK || gjk_arm_obstacles(&arm, wall, 4) != GJK_OK) {
    return 1;
  }
  for (int i = 0; i < 2; i++) {
    for (int k = 0; k < JOINTS; k++) {
      trees[i].at[0][k] = ends[i][k];
    }
  }
  if (is_free(ends[0], ends[1]) || !connect(met)) {
    return 1;
  }
  const int edges = shorten(met);
  printf("a path of %d edges, all proven free\n", edges);
  if (count > 1) {
    FILE *file = fopen(names[1], "w");
    if (file == NULL) {
      return 1;
    }
    draw_way(file, wall, edges);
    return fclose(file) == 0 ? 0 : 1;
  }
  return 0;
}
// prints: a path of 3 edges, all proven free
