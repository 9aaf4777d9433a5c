// gjk_scene_check: each way in which a block can be wrong, one at a time, in an otherwise sound one.
//
// The wrong value goes where src/scene/gjk_scene_block.h says that the field is.
#include <string.h>

#include "check.h"
#include "gjk/gjk.h"
#include "src/scene/gjk_scene_block.h"

#define ONE GJK_Q16_ONE
#define WORDS 8192

static const gjk_shape crate = GJK_BOX(ONE / 2, ONE / 2, ONE / 2);
static const gjk_shape *const shapes[] = {&crate, NULL};
static const gjk_scene_config config = {40, 60, 5, 30, GJK_Q16(0.1), GJK_DETAIL_TOUCH, 0, 0, 0, 0};

static uint32_t sound[WORDS], block[WORDS];
static gjk_scene scene;
static gjk_scene_view v;

static gjk_body_id add(gjk_q16 x, uint16_t parts) {
  static const gjk_part part[3] = {{0, false, GJK_POSE_IDENTITY},
                                   {0, true, {{0, 3 * ONE, 0}, {0, 0, 0, GJK_Q30_ONE}}},
                                   {0, true, {{0, 6 * ONE, 0}, {0, 0, 0, GJK_Q30_ONE}}}};
  gjk_body_setup setup = {GJK_POSE_IDENTITY, part, parts, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, 1, 0, 0};
  gjk_body_id body = {0, 0};
  setup.pose.position.x = x;
  CHECK(gjk_scene_add(&scene, &setup, &body) == GJK_OK);
  return body;
}

static void update(void) {
  gjk_report reports[30];
  gjk_progress progress;
  CHECK(gjk_scene_update(&scene, reports, 30, &progress) == GJK_OK);
  CHECK(progress.reports_left == 0);
}

// Bodies in slots 0 to 35: three that touch, one of three parts, the others alone; every pool has a record that was given
// back. Slot 34 is free again, slots from 36 on never were taken.
static void build(void) {
  gjk_body_id bodies[36];
  CHECK(gjk_scene_init(&scene, &config, block, sizeof block, shapes, 2, NULL) == GJK_OK);
  for (int i = 0; i < 36; i++) {
    const gjk_q16 x = i < 3 ? i * (ONE / 2) : 10 * i * ONE;
    bodies[i] = add(x, i == 3 || i == 34 ? 3 : 1);
  }
  gjk_pose away = GJK_POSE_IDENTITY;
  away.position.x = 9 * 10 * ONE;
  CHECK(gjk_scene_teleport(&scene, bodies[35], &away) == GJK_OK);  // a pair for one update
  update();
  away.position.x = -99 * ONE;
  CHECK(gjk_scene_teleport(&scene, bodies[35], &away) == GJK_OK);
  CHECK(gjk_scene_remove(&scene, bodies[34]) == GJK_OK);
  update();
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  memcpy(sound, block, sizeof block);
}

// The sound block again, found.
static void restore(void) {
  memcpy(block, sound, sizeof block);
  CHECK(gjk_scene_view_of(&scene, &v) == GJK_OK);
}

static bool opens(void) {
  gjk_scene opened;
  return gjk_scene_seal(&scene) == GJK_OK &&
         gjk_scene_open(&opened, block, sizeof block, shapes, 2, NULL) != GJK_ERROR_CORRUPT;
}

// The check refuses it; and so does opening it, sealed afresh, wherever it comes so far.
#define REFUSED(...)                                                             \
  do {                                                                           \
    restore();                                                                   \
    __VA_ARGS__;                                                                 \
    CHECK_MSG(gjk_scene_check(&scene) == GJK_ERROR_CORRUPT, "%s", #__VA_ARGS__); \
    CHECK_MSG(!opens(), "%s", #__VA_ARGS__);                                     \
  } while (0)

#define ACCEPTED(...)                                                 \
  do {                                                                \
    restore();                                                        \
    __VA_ARGS__;                                                      \
    CHECK_MSG(gjk_scene_check(&scene) == GJK_OK, "%s", #__VA_ARGS__); \
  } while (0)

// The first part of a slot, the node above it, and the pair of two slots.
static gjk_scene_part *part_of(uint32_t slot) {
  return &v.parts[v.bodies[slot].first];
}

static uint32_t pair_of(uint32_t a, uint32_t b) {
  for (uint32_t i = 0; i < v.header->pairs.fresh; i++) {
    if ((v.pairs[i].state & GJK_SCENE_PAIR_LIVE) != 0 && v.parts[v.pairs[i].ends.linked.part[0]].body == a &&
        v.parts[v.pairs[i].ends.linked.part[1]].body == b) {
      return i;
    }
  }
  CHECK(false);
  return 0;
}

static void test_header(void) {
  restore();
  gjk_scene_header *h = v.header;
  REFUSED(h->magic ^= 1);
  REFUSED(h->version++);
  REFUSED(h->order = UINT32_C(0x04030201));
  REFUSED(h->config.bodies = 0);
  REFUSED(h->config.detail = GJK_DETAIL_CONTACTS + 1);
  REFUSED(h->bytes += 4);
  REFUSED(h->queue_at += 4);
  REFUSED(h->slots_at += 4);
  gjk_scene attached;
  gjk_scene_pool *const pools[] = {&h->bodies, &h->parts, &h->nodes, &h->own_poses, &h->pairs};
  for (unsigned i = 0; i < 5; i++) {
    REFUSED(pools[i]->at += 4);
    REFUSED(pools[i]->capacity++);
    REFUSED(pools[i]->count = pools[i]->fresh + 1);
    CHECK(gjk_scene_attach(&attached, block, sizeof block, shapes, 2, NULL) == GJK_ERROR_CORRUPT);
    REFUSED(pools[i]->fresh = pools[i]->capacity + 1);
    CHECK(gjk_scene_attach(&attached, block, sizeof block, shapes, 2, NULL) == GJK_ERROR_CORRUPT);
  }
  // The block must hold what its header says.
  restore();
  gjk_scene opened;
  CHECK(gjk_scene_attach(&opened, block, h->bytes, shapes, 2, NULL) == GJK_OK);
  CHECK(gjk_scene_attach(&opened, block, h->bytes - 1, shapes, 2, NULL) == GJK_ERROR_CAPACITY);
  CHECK(gjk_scene_attach(&opened, block, sizeof *h, shapes, 2, NULL) == GJK_ERROR_CAPACITY);
  CHECK(gjk_scene_attach(&opened, block, sizeof *h - 1, shapes, 2, NULL) == GJK_ERROR_CAPACITY);
}

static void test_free_lists(void) {
  restore();
  gjk_scene_header *h = v.header;
  gjk_scene_pool *const pools[] = {&h->parts, &h->nodes, &h->own_poses, &h->pairs};
  for (unsigned i = 0; i < 4; i++) {
    CHECK_MSG(pools[i]->free != GJK_SCENE_NONE, "pool %u: %lu of %lu", i, (unsigned long)pools[i]->count,
              (unsigned long)pools[i]->fresh);
    CHECK_MSG(pools[i]->count < pools[i]->fresh, "pool %u: %lu of %lu", i, (unsigned long)pools[i]->count,
              (unsigned long)pools[i]->fresh);
    REFUSED(pools[i]->free = GJK_SCENE_NONE);
    REFUSED(pools[i]->free = pools[i]->fresh);
  }
  REFUSED(h->parts.free = v.bodies[5].first);
  REFUSED(h->nodes.free = part_of(5)->parent);
  REFUSED(h->pairs.free = pair_of(0, 1));
  // In use, in the place of another.
  const uint32_t third = v.parts[part_of(3)->next].next;
  CHECK(v.parts[third].number == 2);
  CHECK(third < h->own_poses.fresh);
  CHECK(v.own_poses[third].next != part_of(3)->next);
  REFUSED(v.own_poses[third].next = GJK_SCENE_NONE; h->own_poses.free = v.parts[third].own_pose);
  // One too many, or in a ring.
  REFUSED(v.parts[h->parts.free].next = h->parts.free);
  REFUSED(*(uint32_t *)&v.nodes[h->nodes.free] = h->nodes.free);
  // A record that is neither in the list nor in use.
  REFUSED(h->parts.free = v.parts[h->parts.free].next; h->parts.count++);
  REFUSED(v.parts[h->parts.free].state = GJK_SCENE_LIVE; h->parts.free = v.parts[h->parts.free].next; h->parts.count++);
  REFUSED(h->nodes.free = v.nodes[h->nodes.free].child[0]; h->nodes.count++);
  REFUSED(h->own_poses.free = v.own_poses[h->own_poses.free].next; h->own_poses.count++);
  REFUSED(h->pairs.free = v.pairs[h->pairs.free].ends.linked.part[0]; h->pairs.count++);
}

static void test_bodies(void) {
  restore();
  gjk_scene_header *h = v.header;
  REFUSED(v.slots[0] |= 1);                                           // taken, and free
  REFUSED(v.slots[1] &= ~UINT32_C(4));                                // slot 34, neither taken nor free
  ACCEPTED(v.slots[1] &= ~UINT32_C(4); v.bodies[34].generation = 0);  // used up
  REFUSED(h->lowest = 2);
  ACCEPTED(h->lowest = 0);
  REFUSED(h->lowest = 3);
  REFUSED(v.bodies[36].generation = 2);  // never taken
  REFUSED(v.bodies[36].generation = 1; v.slots[1] &= ~UINT32_C(16));
  // What follows the last body is none.
  const gjk_body_id beyond = {h->config.bodies, 1};
  gjk_body_state state;
  restore();
  v.bodies[beyond.slot].generation = beyond.generation;
  CHECK(gjk_scene_get(&scene, beyond, &state) == GJK_ERROR_BODY_ID);
  REFUSED(v.bodies[34].first = 0);  // free, with a part
  // No slots, free.
  REFUSED(v.slots[1] |= UINT32_C(1) << 8);
  REFUSED(v.slots[1] |= UINT32_C(1) << 31);
  REFUSED(h->bodies.count--);
  REFUSED(v.bodies[4].kind_detail = GJK_BODY_DYNAMIC + 1);
  ACCEPTED(v.bodies[4].kind_detail = GJK_BODY_STATIC | GJK_DETAIL_DISTANCE << 4; h->most_detail = GJK_DETAIL_DISTANCE);
  REFUSED(v.bodies[4].kind_detail = GJK_BODY_STATIC | GJK_DETAIL_DISTANCE << 4);
  ACCEPTED(h->most_detail = GJK_DETAIL_CONTACTS);
  REFUSED(h->most_detail = GJK_DETAIL_CONTACTS + 1);
  REFUSED(h->config.detail = GJK_DETAIL_DISTANCE);
  REFUSED(v.bodies[4].kind_detail = GJK_DETAIL_DEPTH << 4);
  REFUSED(v.bodies[4].margin = -1);
  ACCEPTED(v.bodies[4].margin = GJK_RADIUS_MAX);
  REFUSED(v.bodies[4].margin = GJK_RADIUS_MAX + 1);
  REFUSED(v.bodies[4].rotation.w = 5);
}

static void test_parts(void) {
  restore();
  REFUSED(v.bodies[4].first = v.header->parts.free);
  REFUSED(v.bodies[4].first = v.header->parts.fresh);
  REFUSED(v.bodies[4].first = v.bodies[5].first);
  REFUSED(v.bodies[4].first = GJK_SCENE_NONE);
  REFUSED(v.bodies[4].first = GJK_SCENE_NONE; v.bodies[4].parts = 0);
  REFUSED(v.bodies[3].parts = 2);
  REFUSED(part_of(3)->number = 1);
  REFUSED(part_of(3)->next = v.bodies[3].first);
  REFUSED(part_of(3)->state |= GJK_SCENE_MARK);
  ACCEPTED(part_of(3)->state |= GJK_SCENE_PAIRS_STALE);
  // Not what posing gives.
  REFUSED(part_of(4)->core_radius++);
  for (int i = 0; i < 3; i++) {
    REFUSED(part_of(4)->frame[i].x++);
    REFUSED(part_of(4)->frame[i].y++);
    REFUSED(part_of(4)->frame[i].z++);
    REFUSED(part_of(4)->fraction[i]++);
  }
  gjk_vec3 *const corners[] = {&part_of(4)->centre, &part_of(4)->local_centre, &part_of(4)->exact.lower,
                               &part_of(4)->exact.upper};
  for (int i = 0; i < 4; i++) {
    REFUSED(corners[i]->x++);
    REFUSED(corners[i]->y++);
    REFUSED(corners[i]->z++);
  }
  REFUSED(v.bodies[4].position.y++);
  gjk_scene_part *const second = &v.parts[part_of(3)->next];
  CHECK(second->own_pose != GJK_SCENE_NONE);
  REFUSED(second->own_pose = v.header->own_poses.fresh);
  REFUSED(second->own_pose = v.header->own_poses.free);
  REFUSED(second->own_pose = v.parts[second->next].own_pose);
  REFUSED(second->own_pose = GJK_SCENE_NONE);
  REFUSED(v.own_poses[second->own_pose].pose.position.y = INT32_MAX);  // still a pose, but not of the part
  REFUSED(v.bodies[3].position.y = INT32_MAX);                         // parts with a pose of their own leave int32
  REFUSED(v.own_poses[second->own_pose].pose.rotation.w = 5);
  // The exact box sticks out of the enlarged one, on each side.
  gjk_aabb *const exact = &part_of(4)->exact, *const enlarged = &part_of(4)->enlarged;
  REFUSED(exact->lower.x = enlarged->lower.x - 1);
  REFUSED(exact->lower.y = enlarged->lower.y - 1);
  REFUSED(exact->lower.z = enlarged->lower.z - 1);
  REFUSED(exact->upper.x = enlarged->upper.x + 1);
  REFUSED(exact->upper.y = enlarged->upper.y + 1);
  REFUSED(exact->upper.z = enlarged->upper.z + 1);
  ACCEPTED(*enlarged = *exact);
  // A shape that the table doesn't have is the caller's mistake.
  restore();
  part_of(4)->shape = 2;
  CHECK(gjk_scene_check(&scene) == GJK_ERROR_RANGE);
  part_of(4)->shape = 1;  // NULL
  CHECK(gjk_scene_check(&scene) == GJK_ERROR_RANGE);
  part_of(4)->shape = 0;
  CHECK(gjk_scene_check(&scene) == GJK_OK);
}

// Parts that cannot be posed again: shape or body would leave the world, or the table has another shape.
static void test_poses(void) {
  static const gjk_vec3 corners[4] = {{0, 0, 0}, {ONE, 0, 0}, {0, ONE, 0}, {0, 0, ONE}};
  static const gjk_shape rock = GJK_HULL(corners, 4), wrong = GJK_BOX(-1, 1, 1);
  static const gjk_shape *const rocks[] = {&rock}, *const wrongs[] = {&wrong};
  static const gjk_scene_config few = {2, 2, 1, 1, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 0};
  static const gjk_part part[2] = {{0, false, GJK_POSE_IDENTITY}, {0, true, {{0, 3 * ONE, 0}, {0, 0, 0, GJK_Q30_ONE}}}};
  static uint32_t memory[500];
  gjk_scene small;
  gjk_body_id body[2];
  gjk_scene_view view;
  CHECK(gjk_scene_init(&small, &few, memory, sizeof memory, rocks, 1, NULL) == GJK_OK);
  for (int i = 0; i < 2; i++) {
    gjk_body_setup setup = {GJK_POSE_IDENTITY, &part[i], 1, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, 1, 0, 0};
    CHECK(gjk_scene_add(&small, &setup, &body[i]) == GJK_OK);
  }
  CHECK(gjk_scene_view_of(&small, &view) == GJK_OK);
  CHECK(gjk_scene_check(&small) == GJK_OK);
  for (int i = 0; i < 2; i++) {
    view.bodies[body[i].slot].position.y = INT32_MAX;
    CHECK(gjk_scene_check(&small) == GJK_ERROR_CORRUPT);
    view.bodies[body[i].slot].position.y = 0;
    CHECK(gjk_scene_check(&small) == GJK_OK);
  }
  CHECK(gjk_scene_attach(&small, memory, sizeof memory, wrongs, 1, NULL) == GJK_OK);
  CHECK(gjk_scene_check(&small) == GJK_ERROR_CORRUPT);
}

static void test_moved(void) {
  restore();
  REFUSED(v.header->moved = v.header->config.bodies);
  REFUSED(v.header->moved = 4);
  REFUSED(v.bodies[4].flags = GJK_SCENE_MOVED);
  ACCEPTED(v.header->moved = 4; v.bodies[4].flags = GJK_SCENE_MOVED; v.bodies[4].next_moved = GJK_SCENE_NONE);
  REFUSED(v.header->moved = 4; v.bodies[4].flags = GJK_SCENE_MOVED; v.bodies[4].next_moved = 4);
  // A slot that was never taken, without and with parts.
  gjk_scene_body *const never = &v.bodies[36];
  ACCEPTED(never->first = 0);
  ACCEPTED(v.header->moved = 36; never->flags = GJK_SCENE_MOVED; never->next_moved = never->first = GJK_SCENE_NONE);
  REFUSED(v.header->moved = 36; never->flags = GJK_SCENE_MOVED; never->next_moved = GJK_SCENE_NONE; never->first = 99);
}

// Puts a copy of a node in the place of it in the tree.
static void put_node(uint32_t from, uint32_t to) {
  const gjk_scene_node *const n = &v.nodes[from];
  gjk_scene_node *const above = &v.nodes[n->parent];
  above->child[above->child[0] == from ? 0 : 1] = to;
  for (int i = 0; i < 2; i++) {
    const uint32_t child = n->child[i];
    *((child & GJK_SCENE_LEAF) != 0 ? &v.parts[child & ~GJK_SCENE_LEAF].parent : &v.nodes[child].parent) = to;
  }
  v.nodes[to] = *n;
}

static void test_tree(void) {
  restore();
  gjk_scene_header *h = v.header;
  gjk_scene_node *const n = &v.nodes[part_of(5)->parent], *const root = &v.nodes[h->root];
  REFUSED(h->root = GJK_SCENE_NONE);
  REFUSED(h->root = h->nodes.free);
  REFUSED(h->root = h->nodes.fresh);
  REFUSED(h->root = GJK_SCENE_LEAF | h->parts.free);
  REFUSED(h->root = part_of(5)->parent);  // has a parent
  REFUSED(h->root = GJK_SCENE_LEAF | v.bodies[5].first);
  REFUSED(root->parent = part_of(5)->parent);
  REFUSED(put_node(part_of(5)->parent, h->nodes.fresh));
  REFUSED(n->child[0] = n->child[1]);
  REFUSED(n->child[1] = n->child[0]);
  for (int i = 0; i < 2; i++) {
    REFUSED(root->child[i] = h->nodes.free);
    REFUSED(root->child[i] = h->nodes.fresh);
    REFUSED(root->child[i] = GJK_SCENE_LEAF | h->parts.free);
    REFUSED(root->child[i] = GJK_SCENE_LEAF | v.bodies[5].first);
    restore();
    // A child's box sticks out of its parent's.
    gjk_aabb *const inner = &v.nodes[root->child[i]].box;
    REFUSED(inner->lower.y = root->box.lower.y - 1);
    REFUSED(inner->upper.x = root->box.upper.x + 1);
  }
  REFUSED(part_of(5)->parent = h->root);
  REFUSED(root->height++);
  REFUSED(root->height--);
  for (int i = 0; i < 2; i++) {  // not balanced, to either side
    REFUSED(v.nodes[root->child[i]].height += 2; root->height += 2);
    REFUSED(v.nodes[root->child[i]].height -= 3; root->height = 0; root->height = root->height + 1);
  }
  REFUSED(n->box.lower.x = INT32_MAX);
  REFUSED(root->box.upper.z = v.nodes[root->child[0]].box.upper.z - 1);
  // A part that is in no node, and a node that is in no tree.
  REFUSED(h->root = root->child[0]; v.nodes[h->root].parent = GJK_SCENE_NONE);
  REFUSED(v.nodes[h->nodes.free].height = 1; h->nodes.free = v.nodes[h->nodes.free].child[0]; h->nodes.count++);
}

// Heights that promise a deeper tree than any: the check ends before its list of waiting nodes does.
static void test_deep_tree(void) {
  static const gjk_scene_config large = {100, 100, 0, 1, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 0};
  CHECK(gjk_scene_init(&scene, &large, block, sizeof block, shapes, 2, NULL) == GJK_OK);
  for (int i = 0; i < 100; i++) {
    add(10 * i * ONE, 1);
  }
  CHECK(gjk_scene_view_of(&scene, &v) == GJK_OK);
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  CHECK(v.header->nodes.fresh == 99);
  const gjk_aabb box = v.nodes[v.header->root].box;
  for (uint32_t i = 0; i < 99; i++) {
    v.nodes[i].box = box;
    v.nodes[i].height = 60 - (i + 1) / 2;
    v.nodes[i].parent = i == 0 ? GJK_SCENE_NONE : i % 2 != 0 ? i - 1 : i - 2;
    v.nodes[i].child[0] = i + 2 - i % 2 < 99 ? i + 2 : 0;
    v.nodes[i].child[1] = i + 1 < 99 ? i + 1 : 0;
  }
  v.header->root = 0;
  CHECK(gjk_scene_check(&scene) == GJK_ERROR_CORRUPT);
}

static void test_pairs(void) {
  restore();
  gjk_scene_header *h = v.header;
  // Slots 0, 1 and 2 touch each other: part 1 is second in one pair and first in another.
  gjk_scene_pair *const p = &v.pairs[pair_of(0, 1)], *const q = &v.pairs[pair_of(1, 2)],
                        *const r = &v.pairs[pair_of(0, 2)];
  ACCEPTED(p->state = (uint8_t)((p->state & 31u) | 4u << GJK_SCENE_PAIR_CACHED));
  REFUSED(p->state = (uint8_t)((p->state & 31u) | 5u << GJK_SCENE_PAIR_CACHED));
  // That deep; where no depth is asked for, or none was found.
  ACCEPTED(p->gap = -1; h->most_detail = h->config.detail = GJK_DETAIL_DEPTH);
  ACCEPTED(p->gap = -1; h->most_detail = h->config.detail = GJK_DETAIL_DEPTH; p->outcome = GJK_SCENE_PENDING);
  for (unsigned detail = GJK_DETAIL_TOUCH; detail <= GJK_DETAIL_CONTACTS; detail++) {
    if (detail != GJK_DETAIL_DEPTH) {
      ACCEPTED(h->most_detail = h->config.detail = (uint8_t)detail);
      REFUSED(h->most_detail = h->config.detail = (uint8_t)detail; p->gap = -1);
    }
  }
  REFUSED(h->most_detail = h->config.detail = GJK_DETAIL_DEPTH; p->gap = -1; p->outcome = GJK_SCENE_COLD;
          p->state = (uint8_t)((p->state & ~GJK_SCENE_PAIR_NEAR) | GJK_SCENE_PAIR_NEAR_NOW));
  REFUSED(p->gap = -1; p->state = (uint8_t)(p->state & ~GJK_SCENE_PAIR_NEAR));
  ACCEPTED(p->gap = 0; p->state = (uint8_t)(p->state & ~GJK_SCENE_PAIR_NEAR));
  ACCEPTED(p->outcome = GJK_SCENE_COLD | GJK_SCENE_UNSETTLED);
  REFUSED(p->outcome = GJK_SCENE_OUTCOMES);
  ACCEPTED(p->outcome = GJK_SCENE_PENDING);
  REFUSED(p->outcome = GJK_SCENE_PENDING | GJK_SCENE_UNSETTLED);
  REFUSED(p->state = (uint8_t)(p->state | GJK_SCENE_PAIR_QUEUED));
  REFUSED(v.pairs[h->pairs.free].state = GJK_SCENE_PAIR_NEAR);  // near, but not there
  REFUSED(p->ends.linked.part[0] = h->parts.free);
  REFUSED(p->ends.linked.part[1] = h->parts.fresh);
  REFUSED(p->ends.linked.part[0] = p->ends.linked.part[1]);
  REFUSED(const uint32_t a = p->ends.linked.part[0]; p->ends.linked.part[0] = p->ends.linked.part[1];
          p->ends.linked.part[1] = a);
  // Lists that do not lead back.
  for (int i = 0; i < 2; i++) {
    REFUSED(p->ends.linked.next[i] = p->ends.linked.next[i] == GJK_SCENE_NONE ? 2 * pair_of(0, 2) + 1 : GJK_SCENE_NONE);
    REFUSED(p->ends.linked.previous[i] =
                p->ends.linked.previous[i] == GJK_SCENE_NONE ? 2 * pair_of(0, 2) + 1 : GJK_SCENE_NONE);
    REFUSED(p->ends.linked.next[i] = 2 * h->pairs.free);
    REFUSED(p->ends.linked.previous[i] = 2 * h->pairs.free);
  }
  REFUSED(part_of(0)->pairs = GJK_SCENE_NONE);
  REFUSED(part_of(0)->pairs = 2 * h->pairs.free);
  REFUSED(part_of(9)->pairs = 2 * h->pairs.free);  // of a part without pairs
  REFUSED(part_of(9)->pairs = part_of(0)->pairs);
  REFUSED(part_of(9)->pairs = 2 * h->pairs.fresh);
  // A ring, with the list's head in it or not.
  const uint32_t part = v.bodies[9].first;
  for (int headed = 0; headed < 2; headed++) {
    restore();
    const uint32_t index = h->pairs.free, link = 2 * index;
    gjk_scene_pair *const s = &v.pairs[index];
    h->pairs.free = s->ends.linked.part[0];
    h->pairs.count++;
    *s = *p;
    s->ends.linked.part[0] = part;
    s->ends.linked.part[1] = v.bodies[10].first;
    s->ends.linked.next[0] = s->ends.linked.previous[0] = headed != 0 ? link : GJK_SCENE_NONE;
    s->ends.linked.next[1] = s->ends.linked.previous[1] = GJK_SCENE_NONE;
    v.parts[part].pairs = link;
    v.parts[s->ends.linked.part[1]].pairs = link + 1;
    CHECK(gjk_scene_check(&scene) == (headed != 0 ? GJK_ERROR_CORRUPT : GJK_OK));
    s->ends.linked.next[0] = s->ends.linked.previous[0] = link;
    v.parts[part].pairs = GJK_SCENE_NONE;
    CHECK(gjk_scene_check(&scene) == GJK_ERROR_CORRUPT);
  }
  CHECK(q != r);
}

// Pairs whose end is still to be reported.
static void test_gone(void) {
  restore();
  const gjk_body_id first = gjk_scene_id_of(&v, 0);
  CHECK(gjk_scene_remove(&scene, first) == GJK_OK);
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  gjk_scene_header *h = v.header;
  memcpy(sound, block, sizeof block);
  const uint32_t gone = h->gone, second = v.pairs[gone].ends.linked.previous[0], other = pair_of(1, 2);
  CHECK(second != GJK_SCENE_NONE);
  CHECK(v.pairs[second].ends.linked.previous[0] == GJK_SCENE_NONE);
  REFUSED(h->gone = second);
  REFUSED(h->gone = GJK_SCENE_NONE);
  REFUSED(h->gone = other);
  REFUSED(h->gone = h->pairs.fresh);
  REFUSED(v.pairs[second].ends.linked.previous[0] = gone);
  REFUSED(v.pairs[gone].state = GJK_SCENE_PAIR_LIVE | GJK_SCENE_PAIR_GONE);
  REFUSED(v.pairs[other].ends.linked.next[0] = 2 * gone);
  REFUSED(v.pairs[other].ends.linked.next[1] = 2 * gone);
  REFUSED(v.pairs[other].ends.linked.previous[0] = 2 * gone);
  REFUSED(v.pairs[other].ends.linked.previous[1] = 2 * gone);
}

// A sound block in which slots 0 to 2 have moved apart, and their update has begun. Returns how many pairs it tests.
static uint32_t begin_update(void) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  uint32_t pairs = 0;
  build();
  pose.position.y = 1;
  for (uint32_t slot = 0; slot < 3; slot++) {
    pose.position.x = (gjk_q16)slot * (3 * ONE);
    CHECK(gjk_scene_move(&scene, gjk_scene_id_of(&v, slot), &pose) == GJK_OK);
  }
  memcpy(sound, block, sizeof block);
  REFUSED(v.header->phase = GJK_SCENE_REPORTING + 1);
  REFUSED(v.header->queued = 1);
  restore();
  CHECK(gjk_scene_update_begin(&scene, &pairs) == GJK_OK);
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  memcpy(sound, block, sizeof block);
  return pairs;
}

static void test_testing(void) {
  CHECK(begin_update() == 3);
  gjk_scene_header *h = v.header;
  gjk_scene_pair *const first = &v.pairs[v.queue[0]], *const last = &v.pairs[v.queue[2]];
  ACCEPTED(h->next_test = 1; first->outcome = GJK_SCENE_COLD);
  ACCEPTED(last->outcome = GJK_SCENE_COLD);
  REFUSED(h->next_test = 1);  // not tested
  REFUSED(h->next_test = 3; first->outcome = last->outcome = GJK_SCENE_COLD);
  REFUSED(h->next_test = 4);
  REFUSED(h->queued = h->pairs.capacity + 1);
  REFUSED(v.queue[2] = h->pairs.free);
  REFUSED(v.queue[0] = h->pairs.fresh);
  // As deep as this update's test says, where it was done.
  restore();
  h->most_detail = h->config.detail = GJK_DETAIL_DEPTH;
  first->gap = -1;
  memcpy(sound, block, sizeof block);
  ACCEPTED((void)0);
  REFUSED(first->state = (uint8_t)(first->state & ~GJK_SCENE_PAIR_NEAR));
  REFUSED(first->outcome = GJK_SCENE_COLD);
  ACCEPTED(first->outcome = GJK_SCENE_COLD; first->state |= GJK_SCENE_PAIR_NEAR_NOW);
  REFUSED(first->state = (uint8_t)((first->state & ~GJK_SCENE_PAIR_NEAR) | GJK_SCENE_PAIR_NEAR_NOW));
  // Twice, not flagged, flagged but not in the queue.
  REFUSED(v.queue[2] = v.queue[0]);
  REFUSED(first->state = (uint8_t)(first->state & ~GJK_SCENE_PAIR_QUEUED));
  REFUSED(h->queued = 2);
  ACCEPTED(h->queued = 2; last->state = (uint8_t)(last->state & ~GJK_SCENE_PAIR_QUEUED));
  // Refused blocks are as they were, too.
  restore();
  v.queue[2] = v.queue[0];
  memcpy(sound, block, sizeof block);
  CHECK(gjk_scene_check(&scene) == GJK_ERROR_CORRUPT);
  CHECK(memcmp(sound, block, sizeof block) == 0);
}

// An update of no pairs.
static void test_testing_none(void) {
  static const gjk_scene_config empty = {1, 1, 0, 1, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 0};
  uint32_t pairs = 1;
  CHECK(gjk_scene_init(&scene, &empty, block, sizeof block, shapes, 2, NULL) == GJK_OK);
  CHECK(gjk_scene_update_begin(&scene, &pairs) == GJK_OK);
  CHECK(pairs == 0);
  CHECK(gjk_scene_check(&scene) == GJK_OK);
}

static void test_reporting(void) {
  gjk_report report;
  gjk_progress progress;
  CHECK(begin_update() == 3);
  CHECK(gjk_scene_update(&scene, &report, 1, &progress) == GJK_OK);
  CHECK(progress.reports_left == 2);
  gjk_scene_header *h = v.header;
  memcpy(sound, block, sizeof block);
  ACCEPTED((void)0);
  REFUSED(h->next_report = 4);
  ACCEPTED(h->next_report = 0; h->queued = 1; v.queue[0] = v.queue[1]);
  REFUSED(h->phase = GJK_SCENE_IDLE; h->queued = 1; v.queue[0] = v.queue[1]);
  ACCEPTED(h->next_report = 3);
  ACCEPTED(v.queue[0] = h->pairs.fresh);  // reported already
  ACCEPTED(v.queue[0] = v.queue[1]);
  REFUSED(v.queue[1] = h->pairs.fresh);
  REFUSED(v.queue[2] = v.queue[1]);
  gjk_scene_pair *const next = &v.pairs[v.queue[1]];
  REFUSED(next->outcome = 0);
  ACCEPTED(next->outcome = GJK_EVENT_BEGIN);
  REFUSED(next->outcome = GJK_EVENT_END + 1);
  REFUSED(next->state |= GJK_SCENE_PAIR_QUEUED);
}

// Pairs whose end is being reported, of a body that was removed.
static void test_reporting_gone(void) {
  gjk_report report;
  gjk_progress progress;
  build();
  CHECK(gjk_scene_remove(&scene, gjk_scene_id_of(&v, 0)) == GJK_OK);
  CHECK(gjk_scene_update(&scene, &report, 1, &progress) == GJK_OK);
  CHECK(progress.reports_left == 1);
  memcpy(sound, block, sizeof block);
  gjk_scene_header *h = v.header;
  gjk_scene_pair *const gone = &v.pairs[v.queue[1]];
  ACCEPTED((void)0);
  REFUSED(h->gone = v.queue[1]; gone->ends.linked.previous[0] = GJK_SCENE_NONE);
  REFUSED(h->gone = v.queue[1]; gone->ends.linked.previous[0] = GJK_SCENE_NONE; h->next_report = 2);
  REFUSED(h->next_report = 2);  // never reported
  REFUSED(gone->outcome = GJK_EVENT_BEGIN);
  // Tested, as if it had parts.
  const uint32_t other = pair_of(1, 2);
  REFUSED(h->phase = GJK_SCENE_TESTING; h->next_test = 0; h->gone = v.queue[1]; h->queued = 1; v.queue[0] = h->gone;
          gone->ends.linked.previous[0] = GJK_SCENE_NONE; gone->state |= GJK_SCENE_PAIR_QUEUED);
  ACCEPTED(h->phase = GJK_SCENE_TESTING; h->next_test = 0; h->gone = v.queue[1]; h->queued = 1; v.queue[0] = other;
           gone->ends.linked.previous[0] = GJK_SCENE_NONE; v.pairs[other].state |= GJK_SCENE_PAIR_QUEUED);
}

// As many slots as bits.
static void test_full_word(void) {
  static const gjk_scene_config whole = {32, 32, 0, 1, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 0};
  CHECK(gjk_scene_init(&scene, &whole, block, sizeof block, shapes, 2, NULL) == GJK_OK);
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  block[gjk_scene_bytes(&whole) / 4] = UINT32_MAX;  // what follows the block is no part of it
  CHECK(gjk_scene_check(&scene) == GJK_OK);
}

// No slot is free, of as many as bits or of one, and that is known.
static void test_no_slot(void) {
  static const gjk_part part = {0, false, GJK_POSE_IDENTITY};
  const gjk_body_setup more = {GJK_POSE_IDENTITY, &part, 1, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, 1, 0, 0};
  gjk_body_id body;
  for (uint32_t n = 1; n <= 32; n += 31) {
    const gjk_scene_config full = {n, n, 0, 1, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 0};
    CHECK(gjk_scene_init(&scene, &full, block, sizeof block, shapes, 2, NULL) == GJK_OK);
    for (uint32_t i = 0; i < n; i++) {
      add((gjk_q16)i * 10 * ONE, 1);
    }
    CHECK(gjk_scene_add(&scene, &more, &body) == GJK_ERROR_CAPACITY);
    CHECK(gjk_scene_check(&scene) == GJK_OK);
    gjk_scene_header *h = scene.block;
    h->lowest++;
    CHECK(gjk_scene_check(&scene) == GJK_ERROR_CORRUPT);
  }
}

int main(void) {
  build();
  test_header();
  test_free_lists();
  test_bodies();
  test_parts();
  test_poses();
  test_moved();
  test_tree();
  test_pairs();
  test_gone();
  test_testing();
  test_reporting();
  test_reporting_gone();
  test_full_word();
  test_testing_none();
  test_no_slot();
  test_deep_tree();
  return check_done("scene_check");
}
