// Compounds: what gjk_compound_build refuses and leaves alone, the shape of its trees, and bodies that are refused.
#include <string.h>

#include "check.h"
#include "generate/body.h"
#include "placed.h"

static const gjk_shape crate = GJK_BOX(GJK_Q16(1), GJK_Q16(1), GJK_Q16(1));
static const gjk_pose identity = GJK_POSE_IDENTITY;
static gjk_compound_part parts[40];
static gjk_compound_node nodes[GJK_COMPOUND_NODES(40)];

static void set_row(void) {
  memset(parts, 0, sizeof parts);
  for (int i = 0; i < 40; i++) {
    parts[i].shape = &crate;
    parts[i].pose = identity;
    parts[i].pose.position.x = i * GJK_Q16(2);
  }
}

static void refused(gjk_status expected, const gjk_compound_part *of, uint16_t count, gjk_compound_node *room,
                    uint32_t capacity) {
  gjk_compound c, before;
  memset(&c, 0x5A, sizeof c);
  before = c;
  CHECK(gjk_compound_build(of, count, room, capacity, &c) == expected);
  CHECK(memcmp(&c, &before, sizeof c) == 0);
}

static void check_refusals(void) {
  static const gjk_shape negative = GJK_BOX(-1, 1, 1), huge = GJK_SPHERE(GJK_RADIUS_MAX + 1);
  gjk_compound c;
  set_row();
  refused(GJK_ERROR_NULL, NULL, 3, nodes, 5);
  refused(GJK_ERROR_NULL, parts, 3, NULL, 5);
  CHECK(gjk_compound_build(parts, 3, nodes, 5, NULL) == GJK_ERROR_NULL);
  refused(GJK_ERROR_EMPTY, parts, 0, nodes, 5);
  refused(GJK_ERROR_SIZE, parts, GJK_COMPOUND_PARTS_MAX + 1, nodes, UINT32_MAX);
  for (uint16_t n = 1; n <= 40; n++) {
    const uint32_t needed = GJK_COMPOUND_NODES((uint32_t)n);
    refused(GJK_ERROR_CAPACITY, parts, n, nodes, needed - 1);
    CHECK(gjk_compound_build(parts, n, nodes, needed, &c) == GJK_OK && c.node_count == needed);
  }
  parts[7].shape = NULL;
  refused(GJK_ERROR_NULL, parts, 9, nodes, 17);
  parts[7].shape = &negative;
  refused(GJK_ERROR_NEGATIVE, parts, 9, nodes, 17);
  parts[7].shape = &huge;
  refused(GJK_ERROR_SIZE, parts, 9, nodes, 17);
  parts[7].shape = &crate;
  parts[7].pose.rotation.w = 0;
  refused(GJK_ERROR_ROTATION, parts, 9, nodes, 17);
}

// Each leaf once; a node's box holds those below it; the walk leads on.
static void check_tree(uint64_t seed, generate_body *body) {
  static bool seen[GENERATE_BODY_PARTS];
  const gjk_vec3 origin = {0, 0, 0};
  random_state random = random_seed(seed);
  const uint16_t count = (uint16_t)(1 + random_below(&random, GENERATE_BODY_PARTS));
  generate_body_make((generate_layout)random_below(&random, GENERATE_LAYOUTS), seed, count,
                     random_range(&random, 200, 4000 * 65536), &origin, body);
  const gjk_compound *c = &body->with_tree;
  uint32_t leaves = 0;
  memset(seen, 0, sizeof seen);
  CHECK(c->node_count == GJK_COMPOUND_NODES((uint32_t)count));
  for (uint32_t i = 0; i < c->node_count; i++) {
    const gjk_compound_node *n = &c->nodes[i];
    CHECK(n->skip > i && n->skip <= c->node_count);
    if (n->part != UINT16_MAX) {
      CHECK(n->part < count && !seen[n->part] && n->skip == i + 1);
      seen[n->part] = true;
      leaves++;
    }
    for (uint32_t j = i + 1; j < n->skip; j++) {
      const gjk_aabb *inner = &c->nodes[j].box, *outer = &n->box;
      CHECK(outer->lower.x <= inner->lower.x && outer->lower.y <= inner->lower.y && outer->lower.z <= inner->lower.z &&
            inner->upper.x <= outer->upper.x && inner->upper.y <= outer->upper.y && inner->upper.z <= outer->upper.z);
      CHECK(c->nodes[j].skip <= n->skip);
    }
  }
  CHECK(leaves == count);
}

// A body that is refused: by every query alike, and no output is touched.
static void check_body(const gjk_parts *a, const gjk_collider *b, gjk_status expected) {
  gjk_decision decision, decision_before;
  gjk_distance_result distance, distance_before;
  gjk_penetration_result depth;
  gjk_cast_result cast;
  gjk_parts_room room;
  gjk_collider c;
  uint32_t part = 77;
  const gjk_vec3 to = {0, 0, 0};
  const gjk_cast_path path = {NULL, &to, 0};
  memset(&decision, 0x5A, sizeof decision);
  memset(&distance, 0x5A, sizeof distance);
  memcpy(&decision_before, &decision, sizeof decision);
  memcpy(&distance_before, &distance, sizeof distance);
  CHECK(gjk_parts_intersect(a, b, &part, &decision) == expected);
  CHECK(gjk_parts_within(a, b, 5, &part, &decision) == expected);
  CHECK(gjk_parts_distance(a, b, &part, &distance) == expected);
  CHECK(gjk_parts_penetration(a, b, NULL, &part, &depth) == expected);
  CHECK(gjk_parts_contacts(a, b, 0, 4, NULL, NULL, 0, &part) == expected);
  CHECK(gjk_parts_cast(a, b, &path, &part, &cast) == expected);
  CHECK(b == NULL || b->shape == NULL || gjk_parts_cast_ray(a, &to, &to, &part, &cast) == expected);
  CHECK(b == NULL || b->shape == NULL || gjk_parts_place(a, 0, &room, &c) == expected);
  CHECK(part == 77 && memcmp(&decision, &decision_before, sizeof decision) == 0 &&
        memcmp(&distance, &distance_before, sizeof distance) == 0);
}

static void check_bodies(void) {
  gjk_compound c;
  gjk_collider never = {0};
  gjk_decision decision;
  gjk_parts_room room;
  set_row();
  CHECK(gjk_compound_build(parts, 12, nodes, 23, &c) == GJK_OK);
  gjk_collider b = posed(&crate, &identity);
  const gjk_parts good = GJK_PARTS_OF_COMPOUND(&c);
  gjk_parts bad = good;
  check_body(NULL, &b, GJK_ERROR_NULL);
  check_body(&good, NULL, GJK_ERROR_NULL);
  check_body(&good, &never, GJK_ERROR_UNINITIALISED);
  CHECK(gjk_parts_within(&good, &b, -1, NULL, &decision) == GJK_ERROR_NEGATIVE);
  CHECK(gjk_parts_distance(&good, &b, NULL, NULL) == GJK_ERROR_NULL);
  bad.type = NULL;
  check_body(&bad, &b, GJK_ERROR_NULL);
  bad = good;
  bad.data = NULL;
  check_body(&bad, &b, GJK_ERROR_NULL);
  bad = good;
  bad.pose.rotation.x = GJK_Q30_ONE;
  check_body(&bad, &b, GJK_ERROR_ROTATION);
  bad = good;
  bad.pose.position.y = (gjk_q16)(INT32_MAX - c.reach + 1);
  check_body(&bad, &b, GJK_ERROR_RANGE);
  bad.pose.position.y = (gjk_q16)(INT32_MAX - c.reach);
  CHECK(gjk_parts_intersect(&bad, &b, NULL, &decision) == GJK_OK && !decision.yes);
  c.count = 0;
  check_body(&good, &b, GJK_ERROR_EMPTY);
  CHECK(gjk_parts_count(&good) == 0 && gjk_parts_count(NULL) == 0);
  c.count = 12;
  CHECK(gjk_parts_count(&good) == 12 && gjk_parts_place(&good, 12, &room, &b) == GJK_ERROR_RANGE);
}

// Distances beyond the range are all its end, so they are equal: the part with the least number is reported, though another
// one is nearer. By a list and by a tree, with the nearest part first and last.
static void check_far_parts(void) {
  const gjk_pose there = {{GJK_Q16(30000), 0, 0}, {0, 0, 0, GJK_Q30_ONE}};
  const gjk_collider b = posed(&crate, &there);
  for (unsigned turn = 0; turn < 4; turn++) {
    const uint16_t count = turn < 2 ? 5 : 30;
    gjk_compound compound;
    gjk_distance_result result;
    gjk_parts_pair pair;
    uint32_t part;
    for (unsigned i = 0; i < count; i++) {
      parts[i].shape = &crate;
      parts[i].pose = identity;
      parts[i].pose.position.x = (turn % 2 == 0 ? (int32_t)i : (int32_t)(count - i)) * GJK_Q16(100);
    }
    CHECK(gjk_compound_build(parts, count, nodes, GJK_COMPOUND_NODES(40), &compound) == GJK_OK);
    gjk_parts body = GJK_PARTS_OF_COMPOUND(&compound);
    body.pose.position.x = -GJK_Q16(20000);
    CHECK(gjk_parts_distance(&body, &b, &part, &result) == GJK_OK);
    CHECK(result.distance == GJK_DISTANCE_MAX && result.saturated && part == 0);
    const gjk_compound_part one = {&crate, GJK_POSE_IDENTITY};
    gjk_compound_node node;
    gjk_compound single;
    CHECK(gjk_compound_build(&one, 1, &node, 1, &single) == GJK_OK);
    gjk_parts of_b = GJK_PARTS_OF_COMPOUND(&single);
    of_b.pose = there;
    CHECK(gjk_parts_both_distance(&body, &of_b, &pair, &result) == GJK_OK && pair.a == 0 && pair.b == 0);
    CHECK(gjk_parts_both_distance(&of_b, &body, &pair, &result) == GJK_OK && pair.a == 0 && pair.b == 0);
  }
}

int main(void) {
  static generate_body body;
  const uint64_t seed = check_seed(20260724);
  const unsigned long trials = check_trials(60);
  check_refusals();
  check_bodies();
  check_far_parts();
  for (unsigned long i = 0; i < trials; i++) {
    check_trial(i, generate_body_show, &body);
    check_tree(seed + i, &body);
  }
  generate_body_free(&body);
  return check_done("test_compound");
}
