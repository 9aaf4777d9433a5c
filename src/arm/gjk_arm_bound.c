// Bounds of an arm's motion, with all roundings.
//
// Which motion   A pair is a part P that moves against another thing S: an obstacle, or a part of another link. P is looked at
//   from S, in a frame where S stands still: the world, or the frame of S's link. Only joints on the way from S to P
//   move P there. Let joint 1 be the one next to S, joint n the one next to P, in this order.
//
// Second order   Let w_k be the change of joint k over the edge, and t run from 0 to 1. A point p of P has
//     p'' = sum over j, k of w_j w_k d2p / dq_j dq_k,       and with j <= k, since joint k is beyond joint j:
//     d2p / dq_j dq_k = z_j x dp / dq_k   where j is revolute with axis z_j;  0 where j is prismatic
//     |dp / dq_k| <= R_k                  where k is revolute;  1 where k is prismatic
//   R_k is the largest distance that p can have from joint k's origin: offsets, extensions and P's reach beyond k. So
//     |p''| <= M = sum over k of w_k R_k (a_k + 2 sum over j < k of a_j),   a_j = w_j where j is revolute, else 0.
//   Let c(t) be the point that divides the chord from p(t0) to p(t1), t1 = t0 + h, as t divides the span. Between t0 and
//   t1, p is at most M h^2 / 8 from c. (The error of linear interpolation; Rolle's theorem along any direction.)
//
// Apart          Let n be any direction, and g(t) the gap of S and P along n at t, as if P were posed there. All points
//   of P on the chords are at least min(g(t0), g(t1)) beyond S along n. So on the whole span the gap is at least
//     min(g(t0), g(t1)) - M h^2 / 8 - slack.
//   This holds for any n. So a search for n may round as it likes; only g is computed with care.
//
// Pieces         A box that holds P at both ends holds all chords. Let a piece of a body be more than d + M h^2 / 8 + slack
//   from the box, along an axis. Then it is more than d from P on the whole span.
//
// Slack          What rounding may add to g at an end, LSB; D is the sum of the lengths from S's frame to P's farthest
//   point, N the number of joints from the base to either:
//     positions of frames, each to the nearest      sqrt(3)/2 for P's link, and for S's link
//     P's frame as seen from S's, to the nearest    sqrt(3)/2, not from the world
//     together                                      1 seen from the world, 3 else
//     support points of a part                      3, as gjk_collider.c has it; 0 where it is not turned or moved in
//                                                   its link's frame
//     curved parts                                  2, counted as 3
//     curved obstacles                              2
//     bodies, whose pieces may be curved            2
//     rotations of N joints and the base            (N + 1) 2^-26 D, as gjk/joint.h states, from either end
//     a matrix of them, entries to the nearest      3 (1/2) 2^-30 D
//     the product of two matrices, not from the world    the same twice
//     n turned into P's frame, each to the nearest  sqrt(3)/2 2^-30 D
//     together                                      < (N + 2) 2^-26 D, less than 2 ((N + 2) D >> 26) / 2 + 1
//     n is not of length 1                          2^-29 of what g is compared with, which is below 2^30:  2
//     shifts that round down                        1
//   The motion itself is exact: at any step values have GJK_ARM_DEPTH_MAX bits below the LSB.
#include "gjk_arm_bound.h"

// How a part moves as seen from a frame.
typedef struct arm_motion {
  uint64_t bend;    // M, LSB
  uint64_t reach;   // D, LSB
  unsigned joints;  // N
} arm_motion;

// ceil(x / 2^16). Pre: x < 2^64 - 2^16.
static uint64_t up16(uint64_t x) {
  return (x + 65535) >> 16;
}

// Joint k is the next one towards S: its part in M. reach becomes the distance from its parent's origin, or from its own.
//   ways of joints beyond   at most 32 joints of change 2^29, and turns of 2^24 with reach 2^28, Q16:   *speed < 2^37
//   *bend                   turn 2^24 times 2^38, Q16, summed to 2^24 in all:                           below 2^48
static void pass_joint(const gjk_arm *arm, unsigned link, uint64_t reach, uint64_t *speed, uint64_t *bend) {
  const gjk_arm_link_room *room = &arm->memory.links[link];
  const uint8_t kind = arm->model->links[link].kind;
  if (kind == GJK_ARM_REVOLUTE) {
    const uint64_t own = up16(room->change * reach);
    *bend += up16(room->change * (own + 2 * *speed));
    *speed += own;
  } else if (kind == GJK_ARM_PRISMATIC) {
    *speed += room->change;
  }
}

// The motion of a point at most reach from the origin of link's frame, as seen from the frame of another link or the base.
// Pre: both links are within the range, as start_range checks.
static void bound_motion(const gjk_arm *arm, unsigned frame, unsigned link, int32_t reach, arm_motion *out) {
  const uint32_t mine = arm->memory.links[link].above;
  const uint32_t other = frame == GJK_ARM_BASE ? 0 : arm->memory.links[frame].above;
  uint64_t distance = (uint64_t)reach, speed = 0;
  out->bend = 0;
  for (uint32_t way = mine & ~other; way != 0;) {  // from P's link down to the last one before the way to S
    const unsigned i = 31 - gjk_clz32(way);
    way &= ~(UINT32_C(1) << i);
    pass_joint(arm, i, distance, &speed, &out->bend);
    distance += arm->memory.links[i].joint.reach + (uint64_t)arm->memory.links[i].extent;
  }
  for (uint32_t way = other & ~mine; way != 0;) {  // on to S's link, against the order of the joints
    const uint32_t lowest = way & (~way + 1);
    const unsigned i = 31 - gjk_clz32(lowest);
    way &= ~lowest;
    distance += arm->memory.links[i].joint.reach + (uint64_t)arm->memory.links[i].extent;
    pass_joint(arm, i, distance, &speed, &out->bend);
  }
  out->joints = 0;
  for (uint32_t way = mine | other; way != 0; way &= way - 1) {
    out->joints++;
  }
  out->reach = distance;
}

// The slack of a pair but for S, as the head of this file has it. reach: of a part from the origin of S's frame.
static int32_t slack_of(const gjk_arm *arm, const gjk_arm_pair *pair, const arm_motion *motion, int32_t reach) {
  const uint64_t turned = ((motion->joints + 2) * (motion->reach + (uint64_t)reach)) >> 26;  // below 34 2^29 / 2^26
  return (int32_t)((pair->frame >= GJK_ARM_BODY ? 1u : 3u) + arm->memory.parts[pair->part].slack + (unsigned)turned +
                   1 + 2 + 1);
}

static inline uint32_t largest(uint32_t a, uint32_t b) {
  return a > b ? a : b;
}

// Sets what the joints do on the edge, and whether a value is outside its limits.
static void set_changes(gjk_arm *arm) {
  unsigned value = 0;
  arm->outside = false;
  for (unsigned i = 0; i < arm->model->link_count; i++) {
    const gjk_arm_link *link = &arm->model->links[i];
    gjk_arm_link_room *room = &arm->memory.links[i];
    room->change = 0;
    room->extent = 0;
    if (arm->from != NULL && gjk_arm_moves(arm, i)) {  // NULL: no joint moves
      const int32_t a = arm->from[value], b = arm->to[value];
      room->change = (uint32_t)gjk_magnitude64((int64_t)b - a);
      if (link->kind == GJK_ARM_PRISMATIC) {
        room->extent = largest(gjk_magnitude32(a), gjk_magnitude32(b));
      }
      arm->outside = arm->outside || a < link->lower || a > link->upper || b < link->lower || b > link->upper;
      value++;
    }
  }
}

// Is the link, with a point at most reach away, within the range, and its world within int32?
static bool link_in_range(const gjk_arm *arm, unsigned link, int32_t reach) {
  const gjk_vec3 *p = &arm->base.position;
  uint64_t distance = (uint64_t)reach, turn = 0;
  for (uint32_t way = arm->memory.links[link].above, i = 0; way != 0; way >>= 1, i++) {
    if ((way & 1u) != 0) {
      distance += arm->memory.links[i].joint.reach + (uint64_t)arm->memory.links[i].extent;  // below 2^38 at the end
      turn += arm->model->links[i].kind == GJK_ARM_REVOLUTE ? arm->memory.links[i].change : 0;
    }
  }
  const uint64_t farthest =
      distance + largest(largest(gjk_magnitude32(p->x), gjk_magnitude32(p->y)), gjk_magnitude32(p->z));
  return distance <= (uint64_t)GJK_ARM_REACH_MAX && turn <= (uint64_t)GJK_ARM_TURN_MAX && farthest < INT32_MAX - 8;
}

static gjk_status set_range(gjk_arm *arm, const int32_t *from, const int32_t *to) {
  bool in_range = true;
  arm->from = from;
  arm->to = to;
  set_changes(arm);
  for (unsigned i = 0; i < arm->model->link_count; i++) {
    int32_t reach = 0;  // of the link's parts
    for (unsigned k = 0; k < arm->model->part_count; k++) {
      const bool farther = arm->model->parts[k].link == i && arm->memory.parts[k].reach > reach;
      reach = farther ? arm->memory.parts[k].reach : reach;
    }
    in_range = in_range && link_in_range(arm, i, reach);
  }
  return in_range ? GJK_OK : GJK_ERROR_RANGE;
}

gjk_status gjk_arm_stand(gjk_arm *arm, const int32_t *values, const void *out) {
  if (arm == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  if (!gjk_arm_is_ready(arm)) {
    return GJK_ERROR_UNINITIALISED;
  }
  if (values == NULL && arm->value_count > 0) {
    return GJK_ERROR_NULL;
  }
  arm->state = GJK_ARM_READY;
  const gjk_status status = set_range(arm, values, values);
  if (status == GJK_OK) {
    gjk_arm_set_frames(arm, 0, 0);
  }
  return status;
}

gjk_status gjk_arm_set_edge(gjk_arm *arm, const int32_t *from, const int32_t *to) {
  arm->state = GJK_ARM_READY;
  const gjk_status status = set_range(arm, from, to);
  arm_motion motion = {0, 0, 0};
  int32_t slack = 0;
  for (uint32_t i = 0; status == GJK_OK && i < arm->pair_count; i++) {
    gjk_arm_pair *pair = &arm->memory.pairs[i];
    const gjk_arm_part_room *part = &arm->memory.parts[pair->part];
    const unsigned link = arm->model->parts[pair->part].link;
    if (pair->frame < GJK_ARM_BODY) {
      const gjk_arm_part_room *other = &arm->memory.parts[pair->other];
      bound_motion(arm, pair->frame, link, part->reach, &motion);
      slack = slack_of(arm, pair, &motion, other->reach) + other->slack;
    } else if (i == arm->self_count || pair[-1].part != pair->part) {
      bound_motion(arm, GJK_ARM_BASE, link, part->reach, &motion);
      slack = slack_of(arm, pair, &motion, 0);
    }
    pair->bend = motion.bend;
    pair->slack = slack;
    if (pair->frame == GJK_ARM_BODY ||
        (pair->frame == GJK_ARM_BASE && gjk_is_curved(arm->obstacles[pair->other].shape))) {
      pair->slack += 2;
    }
  }
  return status;
}

int64_t gjk_arm_bend(const gjk_arm_pair *pair, unsigned depth) {
  const unsigned n = 3 + 2 * depth;
  const uint64_t bend = (pair->bend + ((UINT64_C(1) << n) - 1)) >> n;
  return bend <= UINT64_C(1) << 28 ? (int64_t)bend : -1;
}
