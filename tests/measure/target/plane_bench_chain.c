// Chains and a body on them, up to 0.05 units deep.
#include "plane_bench.h"

#define SEGMENTS 64

static gjk2_vec vertices[SEGMENTS + 1];
static gjk2_chain chain;

// Joints at multiples of 4 units along x, from the right: the middle one at x = 0. One segment slopes up to it, one down.
static void make_chain(random_state *random, plane_gap gap) {
  const gjk_q16 step = GJK_Q16(4.0), rise = random_range(random, 6554, GJK_Q16(2.0));
  const gjk_q16 left = gap == PLANE_RIDGE ? -rise : gap == PLANE_DITCH ? rise : 0;
  const unsigned segments = gap == PLANE_ABOVE ? SEGMENTS : 4;
  for (unsigned i = 0; i <= segments; i++) {
    vertices[i].x = ((gjk_q16)(segments / 2) - (gjk_q16)i) * step;
    vertices[i].y = i == segments / 2 ? 0 : left;
  }
  const gjk2_vec origin = {0, 0};
  (void)gjk2_chain_init(&chain, vertices, (uint16_t)(segments + 1), &origin);
}

void plane_bench_ground(random_state *random, plane_gap gap, gjk2_collider *body, const gjk2_rotation *turn) {
  gjk2_pose pose = {{0, GJK_Q16(6.0)}, *turn};
  gjk2_distance_result nearest;
  uint16_t segment;
  make_chain(random, gap);
  pose.position.x = gap == PLANE_SEGMENT ? GJK_Q16(2.0) : random_range(random, -6554, 6554);
  (void)gjk2_collider_pose(body, &pose);
  if (gap == PLANE_ABOVE) {
    return;
  }
  for (int i = 0; i < 40; i++) {
    (void)gjk2_chain_distance(&chain, body, NULL, &nearest, &segment);
    pose.position.y -= nearest.intersecting ? 0 : nearest.distance;
    (void)gjk2_collider_pose(body, &pose);
  }
  pose.position.y -= random_range(random, 300, 3276);
  (void)gjk2_collider_pose(body, &pose);
}

uint32_t plane_bench_chain(const gjk2_collider *body) {
  static gjk2_chain_contact contacts[4];
  uint16_t count = 0;
  (void)gjk2_chain_contacts(&chain, body, NULL, 1311, contacts, 4, &count);
  return count;
}
