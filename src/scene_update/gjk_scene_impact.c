// Parts on their way: how far they reach, and where two of them first touch.
//
// A cast where neither part turns, else a time of impact. A part that turns away from its body's origin runs along an arc,
// in pieces (see ARC).
#include "gjk_scene_impact.h"

#ifndef GJK_SCENE_OF_PLANE
#include "../scene/gjk_scene_travel.h"
#endif

// A part whose origin is r away from its body's runs along an arc. gjk_time_of_impact takes a straight line: with an
// angle w that is off by at most r w^2 / 8. So the way is cut into 2^n pieces, each of which takes w / 2^n. Deviations of
// more than ARC are cut further, up to 2^ARC_PIECES pieces; what is left of them is a margin.
#define ARC 16
#define ARC_PIECES 6

static uint32_t length_of(const gjk_vec3 *offset) {
  const gjk_vec3 origin = gjk_scene_equal_vec3(0);
  return gjk_scene_distance_bound(offset, &origin);
}

// How far the origin of a part is from that of its body at most.
GJK_ONE_COPY static uint32_t arm_of(const gjk_scene_view *v, const gjk_scene_part *p) {
  const uint32_t own_pose = p->own_pose;
  return own_pose == GJK_SCENE_NONE ? 0 : length_of(&v->own_poses[own_pose].pose.position);
}

// 2^32 + 2^32 + 2^29 + 8 < 2^34
int64_t gjk_scene_reach_of(const gjk_scene_view *v, const gjk_scene_part *p) {
  const gjk_shape *shape = v->scene->shapes[p->shape];
  return (int64_t)arm_of(v, p) + length_of(gjk_scene_local_centre(p, shape)) + p->core_radius + shape->convex_radius +
         8;
}

bool gjk_scene_turns_with(const gjk_scene_view *v, const gjk_scene_mover *m, const gjk_scene_part *p) {
  return m->turns && (p->own_pose != GJK_SCENE_NONE || !gjk_scene_is_point(v->scene->shapes[p->shape]));
}

// The pose of a part where its body is at this one.
static gjk_pose part_pose(const gjk_scene_view *v, const gjk_scene_part *p, const gjk_pose *body) {
  const uint32_t own_pose = p->own_pose;
  gjk_pose pose = *body;
  if (own_pose != GJK_SCENE_NONE) {
    (void)gjk_pose_compose(body, &v->own_poses[own_pose].pose, &pose);
  }
  return pose;
}

void gjk_scene_at_start(const gjk_scene_view *v, const gjk_scene_mover *m, const gjk_scene_part *p, gjk_collider *c) {
  gjk_aabb box;
  if (m->moves) {
    (void)gjk_scene_part_at(v, p, &m->from, c);  // cannot fail: the body was there
  } else {
    gjk_scene_part_now(v, p, c, &box);
  }
}

// Where a collider's position goes: as that of its body, and not beyond int32, because the body was taken there.
static gjk_vec3 end_of(const gjk_scene_mover *m, const gjk_collider *c) {
  gjk_vec3 way, to = c->position;
  gjk_scene_way(&m->from.position, &m->to.position, &way);
  gjk_scene_shift(&to, &way);
  return to;
}

#if GJK_SCENE_AXES == 2

// The queries of ground, if one of two is ground; otherwise NULL.
static const struct gjk_ground_queries *ground_code(const gjk_collider c[2]) {
  const struct gjk_ground_queries *code = c[0].shape->type->ground;
  return code != NULL ? code : c[1].shape->type->ground;
}

#else

// The code of concave parts, if one of two is concave; otherwise NULL.
static const struct gjk_scene_concave *concave_code(const gjk_collider c[2]) {
  const struct gjk_scene_concave *code = c[0].shape->type->concave;
  return code != NULL ? code : c[1].shape->type->concave;
}

#endif

// What two parts are asked on their way, whatever they are made of. ahead: see gjk_scene_concave.
static gjk_status ask_way(const gjk_scene_view *v, const gjk_scene_mover m[2], const gjk_scene_part *const p[2],
                          const gjk_collider c[2], const gjk_cast_path *path, bool ahead, gjk_cast_result *out) {
#if GJK_SCENE_AXES == 3
  if (concave_code(c) != NULL) {
    const gjk_pose from_a = part_pose(v, p[0], &m[0].from), from_b = part_pose(v, p[1], &m[1].from);
    const gjk_scene_solid a = {&c[0], &from_a}, b = {&c[1], &from_b};
    return concave_code(c)->way(&a, &b, path, ahead, out);
  }
#endif
#if GJK_SCENE_AXES == 2
  if (ground_code(c) != NULL) {
    const gjk_pose from[2] = {part_pose(v, p[0], &m[0].from), part_pose(v, p[1], &m[1].from)};
    return ground_code(c)->way(c, from, path, ahead, out);
  }
#endif
  (void)v, (void)m, (void)p, (void)ahead;
  return gjk_cast(&c[0], &c[1], path, out);
}

// motion: of a piece of the way. ahead: the whole way, or NULL, see gjk_scene_concave.
static gjk_status ask_impact_of(const gjk_collider c[2], const gjk_motion motion[2], gjk_q16 margin,
                                const gjk_motion *ahead, gjk_impact_result *out) {
  const gjk_impact_setup setup = {margin, GJK_SCENE_TOLERANCE, 0};
#if GJK_SCENE_AXES == 3
  if (concave_code(c) != NULL) {
    return concave_code(c)->impact(c, motion, margin, ahead, out);
  }
#endif
#if GJK_SCENE_AXES == 2
  if (ground_code(c) != NULL) {
    return ground_code(c)->impact(c, motion, margin, ahead, gjk_time_of_impact, out);
  }
#endif
  (void)ahead;
  return gjk_time_of_impact(&c[0], &motion[0], &c[1], &motion[1], &setup, out);
}

// Neither part turns.
static gjk_scene_impact cast_parts(const gjk_scene_view *v, const gjk_scene_mover m[2],
                                   const gjk_scene_part *const p[2], bool ahead) {
  gjk_collider c[2];
  gjk_vec3 to[2];
  gjk_cast_result result;
  gjk_scene_impact found = {false, false, false, 0};
  for (int i = 0; i < 2; i++) {
    gjk_scene_at_start(v, &m[i], p[i], &c[i]);
    to[i] = end_of(&m[i], &c[i]);
  }
  const gjk_cast_path path = {m[0].moves ? &to[0] : NULL, m[1].moves ? &to[1] : NULL, 0};
  found.unproven = ask_way(v, m, p, c, &path, ahead, &result) != GJK_OK;
  found.hit = found.unproven || result.hit;
  if (!found.unproven && result.hit) {
    found.at_start = result.inside;
    found.fraction = (uint32_t)result.fraction;
  }
  return found;
}

// By how much the straight line between the ends of a part's arc is off at most, rounded up: r w^2 / 8, with the turn t
// as a chord, w <= t pi / 2.
//
// t <= 2 (1 + 2^-15) or, unbounded, 2^32 - 1 in Q30; t^2 < 2^34 2^-30 = 16; (pi / 2)^2 / 8 < 5 / 16
static uint64_t sagitta(uint32_t arm, uint32_t turn) {
  const uint32_t squared = (uint32_t)(gjk_umul32(turn, turn) >> 36) + 1;  // in 2^-24:  < 2^28 + 1
  return ((gjk_umul32(arm, squared) >> 24) * 5 >> 4) + 2;
}

// A part turns: pieces of the way, one after the other. *found is set of the first that has an impact.
static void turn_parts(const gjk_scene_view *v, const gjk_scene_mover m[2], const gjk_scene_part *const p[2],
                       bool ahead, gjk_scene_impact *found) {
  uint64_t off[2] = {0, 0};
  unsigned cuts = 0;
  gjk_collider c[2];
  gjk_motion body[2], way[2];
  for (int i = 0; i < 2; i++) {
    const uint32_t arm = arm_of(v, p[i]);
    gjk_scene_part_load(v, p[i], &c[i]);
    body[i].from = m[i].from;
    body[i].to = m[i].to;
    gjk_scene_no_spin(&body[i]);
    way[i].from = part_pose(v, p[i], &m[i].from);
    way[i].to = part_pose(v, p[i], &m[i].to);
    gjk_scene_no_spin(&way[i]);
    if (arm != 0 && m[i].turns) {
      off[i] = sagitta(arm, gjk_scene_rotation_bound(&m[i].from.rotation, &m[i].to.rotation));
    }
  }
  while (cuts < ARC_PIECES && (off[0] + off[1]) >> 2 * cuts > ARC) {
    cuts++;
  }
  const uint64_t left = off[0] + off[1] == 0 ? 0 : ((off[0] + off[1]) >> 2 * cuts) + 2;
  if (left > GJK_RADIUS_MAX) {
    found->hit = found->unproven = true;  // not reached: a sagitta is below 5 2^32, and is cut by 2^12
    return;
  }
  gjk_pose at[2];
  at[0] = m[0].from;
  at[1] = m[1].from;
  for (uint32_t piece = 0; piece < UINT32_C(1) << cuts && !found->hit; piece++) {
    gjk_impact_result result;
    gjk_motion part[2];
    gjk_pose next[2];
    for (int i = 0; i < 2; i++) {
      next[i] = body[i].to;
      if (m[i].moves && piece + 1 < UINT32_C(1) << cuts) {
        (void)gjk_motion_pose(&body[i], (gjk_q30)((piece + 1) << (30 - cuts)), &next[i]);  // rotations are units
      }
      part[i].from = part_pose(v, p[i], &at[i]);
      part[i].to = part_pose(v, p[i], &next[i]);
      gjk_scene_no_spin(&part[i]);
      at[i] = next[i];
    }
    const gjk_status status = ask_impact_of(c, part, (gjk_q16)left, ahead ? way : NULL, &result);
    const bool limit = status == GJK_ERROR_ITERATION_LIMIT;
    found->unproven = status != GJK_OK;
    found->hit = status != GJK_OK || result.hit;
    if (found->hit) {
      const uint32_t lower = limit || status == GJK_OK ? (uint32_t)result.lower : 0;
      found->fraction = (piece << (30 - cuts)) + (lower >> cuts);
      found->at_start = status == GJK_OK && found->fraction == 0;
    }
  }
}

static void ask_parts(const gjk_scene_view *v, const gjk_scene_mover m[2], const gjk_scene_part *const p[2], bool ahead,
                      gjk_scene_impact *found) {
  const gjk_scene_impact none = {false, false, false, 0};
  *found = none;
  if (gjk_scene_turns_with(v, &m[0], p[0]) || gjk_scene_turns_with(v, &m[1], p[1])) {
    turn_parts(v, m, p, ahead, found);
  } else {
    *found = cast_parts(v, m, p, ahead);
  }
}

static bool is_one_concave(const gjk_scene_view *v, const gjk_scene_part *const p[2]) {
  return gjk_scene_is_concave(v->scene->shapes[p[0]->shape]) || gjk_scene_is_concave(v->scene->shapes[p[1]->shape]);
}

void gjk_scene_find_impact(const gjk_scene_view *v, const gjk_scene_mover m[2], const gjk_scene_part *const p[2],
                           gjk_scene_impact *out) {
  ask_parts(v, m, p, false, out);
}

void gjk_scene_find_impact_ahead(const gjk_scene_view *v, const gjk_scene_mover m[2], const gjk_scene_part *const p[2],
                                 gjk_scene_impact *out) {
  out->hit = false;
  if (is_one_concave(v, p)) {
    ask_parts(v, m, p, true, out);
  }
}
