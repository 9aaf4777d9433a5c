// gjk_scene_check: each way in which the header, bodies, parts or the tree of an otherwise sound block can be wrong,
// one at a time.
#include "scene_check.h"

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
  ACCEPTED(v.bodies[4].kind_detail = GJK_BODY_STATIC | GJK_DETAIL_SENSOR << 4);
  REFUSED(v.bodies[4].kind_detail = (GJK_DETAIL_SENSOR + 1) << 4; h->most_detail = GJK_DETAIL_CONTACTS);
  REFUSED(v.bodies[4].kind_detail = GJK_DETAIL_DEPTH << 4);
  REFUSED(v.bodies[4].margin = -1);
  REFUSED(v.bodies[4].margin = GJK_RADIUS_MAX + 1);
  // The box in the tree holds the exact one with the margin all round: that is all that box_margin left room for.
  const gjk_q16 room = part_of(4)->exact.lower.x - part_of(4)->enlarged.lower.x;
  CHECK(room > 0);
  ACCEPTED(v.bodies[4].margin = room);
  REFUSED(v.bodies[4].margin = room + 1);
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
  REFUSED(*enlarged = *exact; v.bodies[4].margin = 1);
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
  static const gjk_scene_config few = {2, 2, 1, 1, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 0, 0};
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
  static const gjk_scene_config large = {100, 100, 0, 1, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 0, 0};
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

// As many slots as bits.
static void test_full_word(void) {
  static const gjk_scene_config whole = {32, 32, 0, 1, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 0, 0};
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
    const gjk_scene_config full = {n, n, 0, 1, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 0, 0};
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

// A part that its body turned and that nothing posed since.
static void test_unposed(void) {
  const gjk_vec3 axis = {0, 0, ONE};
  gjk_pose pose = GJK_POSE_IDENTITY;
  build();
  restore();
  CHECK(gjk_quat_from_axis_angle(&axis, GJK_ANGLE(0.01), &pose.rotation) == GJK_OK);
  for (uint32_t slot = 2; slot < 6; slot++) {
    pose.position = v.bodies[slot].position;
    CHECK(gjk_scene_move(&scene, gjk_scene_id_of(&v, slot), &pose) == GJK_OK);
    CHECK((part_of(slot)->state & GJK_SCENE_UNPOSED) != 0);
    CHECK(gjk_scene_check(&scene) == GJK_OK);
  }
  CHECK(part_of(2)->pairs != GJK_SCENE_NONE);
  CHECK(part_of(5)->pairs == GJK_SCENE_NONE);
  memcpy(sound, block, sizeof block);
  // Its box must hold the part as it is now, and be held by the one in the tree.
  restore();
  part_of(5)->exact.upper.x = part_of(5)->centre.x;
  CHECK(gjk_scene_check(&scene) == GJK_ERROR_CORRUPT);
  restore();
  part_of(5)->exact.upper.x = part_of(5)->enlarged.upper.x + 1;
  CHECK(gjk_scene_check(&scene) == GJK_ERROR_CORRUPT);
  restore();
  part_of(5)->exact = part_of(5)->enlarged;
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  // With pairs it must be posed before any is tested: its body is in the list of those that moved.
  restore();
  part_of(0)->state |= GJK_SCENE_UNPOSED;
  CHECK(gjk_scene_check(&scene) == GJK_ERROR_CORRUPT);
  restore();
  part_of(9)->state |= GJK_SCENE_UNPOSED;
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  // Posed it is posed.
  restore();
  part_of(5)->state = (uint8_t)(part_of(5)->state & ~GJK_SCENE_UNPOSED);
  CHECK(gjk_scene_check(&scene) == GJK_ERROR_CORRUPT);
  // An update poses those with pairs. The others are saved as they are.
  restore();
  uint32_t pairs = 0;
  CHECK(gjk_scene_update_begin(&scene, &pairs) == GJK_OK);
  CHECK(pairs > 0);
  CHECK((part_of(2)->state & GJK_SCENE_UNPOSED) == 0);
  CHECK((part_of(5)->state & GJK_SCENE_UNPOSED) != 0);
  part_of(2)->state |= GJK_SCENE_UNPOSED;
  CHECK(gjk_scene_check(&scene) == GJK_ERROR_CORRUPT);
  part_of(2)->state = (uint8_t)(part_of(2)->state & ~GJK_SCENE_UNPOSED);
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  CHECK(opens());
  CHECK((part_of(5)->state & GJK_SCENE_UNPOSED) != 0);
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
  test_full_word();
  test_no_slot();
  test_deep_tree();
  test_unposed();
  return check_done("scene_check");
}
