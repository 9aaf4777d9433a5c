// What is nearest at a configuration, and how that changes with the joints.
#include "../arith/gjk_memory.h"
#include "../arith/gjk_rotation.h"
#include "../arith/gjk_unit.h"
#include "gjk/intersect.h"
#include "gjk_arm_body.h"
#include "gjk_arm_bound.h"
#include "gjk_arm_span.h"

// Does a pair's first test, of spheres, show it to be more than so much apart? 12: roundings of both centres.
static inline bool are_far(const gjk_arm *arm, const gjk_arm_pair *pair, const gjk_collider *obstacle, unsigned which,
                           int64_t most) {
  const gjk_arm_part_room *part = &arm->memory.parts[pair->part];
  const gjk_collider *other = obstacle != NULL ? obstacle : &arm->memory.parts[pair->other].collider;
  const gjk_vec3 *centre = obstacle != NULL ? &obstacle->centre : &arm->memory.parts[pair->other].at[which];
  return gjk_arm_balls_apart(&part->at[which], centre, most + part->collider.radius + other->radius + 12);
}

bool gjk_arm_surely_apart(const gjk_arm *arm, const gjk_arm_pair *pair, const gjk_collider *obstacle, unsigned which,
                          int64_t most) {
  const gjk_arm_search search = {most + GJK_ARM_SLACK_MAX, 0};
  gjk_arm_view view;
  gjk_unit3 kept = {0, 0, 0}, direction;
  int64_t gap;
  if (are_far(arm, pair, obstacle, which, most)) {
    return true;
  }
  gjk_arm_look(arm, pair, obstacle, which, which, &view);
  return most < INT32_MAX / 2 && gjk_arm_separate(&view, &search, &kept, &direction, &gap) == GJK_ARM_APART;
}

gjk_status gjk_arm_distance(gjk_arm *arm, const int32_t *values, gjk_q16 most, gjk_arm_distance_result *out) {
  const gjk_status status = most < 0 ? GJK_ERROR_NEGATIVE : gjk_arm_stand(arm, values, out);
  if (status != GJK_OK) {
    return status;
  }
  gjk_distance_result found;
  gjk_status best = GJK_ERROR_EMPTY;
  int64_t nearest = (int64_t)most + 1;
  for (uint32_t i = 0; i < arm->pair_count; i++) {
    const gjk_arm_pair *pair = &arm->memory.pairs[i];
    gjk_collider part, other;
    if (pair->frame != GJK_ARM_BODY && are_far(arm, pair, gjk_arm_obstacle(arm, pair), 0, nearest)) {
      continue;
    }
    if (pair->frame == GJK_ARM_BODY) {
      const gjk_status of_body = arm->type->nearest(arm, pair, &nearest, &best, out);
      if (of_body != GJK_OK) {
        return of_body;
      }
      continue;
    }
    if (gjk_arm_surely_apart(arm, pair, gjk_arm_obstacle(arm, pair), 0, nearest)) {
      continue;
    }
    const gjk_status of_pair = gjk_distance(gjk_arm_place(arm, pair, 0, &part, &other), &part, NULL, &found);
    if (found.lower < nearest) {
      nearest = found.lower;
      best = of_pair;
      gjk_arm_name(pair, GJK_PARTS_NONE, &out->pair);
      gjk_copy(&out->distance, &found, sizeof found);
      out->outside = arm->outside;
    }
  }
  return best;
}

// Is a pair within a distance? ITERATION_LIMIT: it is open.
static gjk_status near_pair(const gjk_arm *arm, const gjk_arm_pair *pair, gjk_q16 distance, bool *near,
                            uint32_t *piece) {
  gjk_collider part, other;
  gjk_decision decision;
  *near = false;
  *piece = GJK_PARTS_NONE;
  if (pair->frame == GJK_ARM_BODY) {
    return arm->type->near(arm, pair, 0, distance, near, piece);
  }
  if (gjk_arm_surely_apart(arm, pair, gjk_arm_obstacle(arm, pair), 0, distance)) {
    return GJK_OK;
  }
  const gjk_status status = gjk_within(gjk_arm_place(arm, pair, 0, &part, &other), &part, distance, NULL, &decision);
  *near = status == GJK_OK && decision.yes;
  return status;
}

gjk_status gjk_arm_near(gjk_arm *arm, const int32_t *values, gjk_q16 distance, bool *yes, gjk_arm_names *pair) {
  gjk_status status = distance < 0 ? GJK_ERROR_NEGATIVE : gjk_arm_stand(arm, values, yes);
  if (status != GJK_OK) {
    return status;
  }
  *yes = false;
  for (uint32_t i = 0; i < arm->pair_count; i++) {
    const gjk_arm_pair *of = &arm->memory.pairs[i];
    bool near;
    uint32_t piece;
    if (of->frame != GJK_ARM_BODY && are_far(arm, of, gjk_arm_obstacle(arm, of), 0, distance)) {
      continue;
    }
    const gjk_status of_pair = near_pair(arm, of, distance, &near, &piece);
    if (pair != NULL && (near || of_pair == GJK_ERROR_ITERATION_LIMIT) && (near || status == GJK_OK)) {
      gjk_arm_name(of, piece, pair);
    }
    if (near || (of_pair != GJK_OK && of_pair != GJK_ERROR_ITERATION_LIMIT)) {
      *yes = near;
      return of_pair;
    }
    status = of_pair != GJK_OK ? of_pair : status;
  }
  *yes = status != GJK_OK;
  return status;
}

// n . (z x (p - o)) of a revolute joint, n . z of a prismatic one: how fast p moves along n, Q16.
static int64_t speed_along(const gjk_arm *arm, unsigned number, const gjk_unit3 *n, const gjk_vec3 *p) {
  const gjk_arm_link *link = &arm->model->links[number];
  const gjk_arm_link_room *room = &arm->memory.links[number];
  gjk_quat unit = {link->axis.x, link->axis.y, link->axis.z, 0};
  (void)gjk_quat_normalize(&unit, &unit);  // not 0, as gjk_arm_init has seen
  const gjk_vec3 axis = {unit.x, unit.y, unit.z}, z = gjk_rotate(room->frame[0].rows, &axis);
  const gjk_vec3 *o = &room->frame[0].at;
  if (link->kind == GJK_ARM_PRISMATIC) {
    return gjk_sar64(gjk_along(n, &z) + (INT64_C(1) << 43), 44);
  }
  // The arm's own point is at most 2^27 and 2 LSB from o, and the point of the other link at most 2^28.
  const gjk_vec3 r = {gjk_saturate((int64_t)p->x - o->x), gjk_saturate((int64_t)p->y - o->y),
                      gjk_saturate((int64_t)p->z - o->z)};
  const gjk_vec3 normal = {n->x, n->y, n->z};
  gjk_long3 across;
  gjk_cross(&normal, &z, &across);  // Q60, (n x z) . r = n . (z x r)
  const gjk_vec3 lever = {(int32_t)gjk_sar64(across.x + (INT64_C(1) << 29), 30),
                          (int32_t)gjk_sar64(across.y + (INT64_C(1) << 29), 30),
                          (int32_t)gjk_sar64(across.z + (INT64_C(1) << 29), 30)};
  return gjk_sar64(gjk_dot(&lever, &r) + (INT64_C(1) << 29), 30);
}

// The links that move the named things, as bits. False: there is no such pair of things.
static bool movers(const gjk_arm *arm, const gjk_arm_names *names, uint32_t *part, uint32_t *other) {
  const gjk_arm_model *model = arm->model;
  const unsigned others = !names->obstacle                 ? model->part_count
                          : names->piece == GJK_PARTS_NONE ? arm->obstacle_count
                                                           : arm->body_count;
  if (names->part >= model->part_count || names->other >= others) {
    return false;
  }
  *part = arm->memory.links[model->parts[names->part].link].above;
  *other = names->obstacle ? 0 : arm->memory.links[model->parts[names->other].link].above;
  return true;
}

gjk_status gjk_arm_gradient(gjk_arm *arm, const int32_t *values, const gjk_arm_distance_result *nearest, gjk_q16 *out) {
  const gjk_status status = nearest == NULL ? GJK_ERROR_NULL : gjk_arm_stand(arm, values, out);
  uint32_t part, other;
  unsigned value = 0;
  if (status != GJK_OK) {
    return status;
  }
  if (nearest->distance.intersecting || !movers(arm, &nearest->pair, &part, &other)) {
    return GJK_ERROR_RANGE;
  }
  for (unsigned i = 0; i < arm->model->link_count; i++) {
    if (!gjk_arm_moves(arm, i)) {
      continue;
    }
    // The normal leads from the other thing to the part. A joint beneath both moves both alike.
    int64_t speed = 0;
    if (((part ^ other) >> i & 1u) != 0) {
      const bool moves_part = (part >> i & 1u) != 0;
      speed = speed_along(arm, i, &nearest->distance.normal,
                          moves_part ? &nearest->distance.point_b : &nearest->distance.point_a);
      speed = moves_part ? speed : -speed;
    }
    out[value++] = gjk_saturate(speed);
  }
  return GJK_OK;
}
