// What queries of a body of many parts must find: each part by itself, by the pair's query. Of equals the first.
#ifndef PARTS_BRUTE_H
#define PARTS_BRUTE_H

#include <string.h>

#include "check.h"
#include "gjk/gjk.h"
#include "src/motion/gjk_impact.h"
#include "src/parts/gjk_parts_class.h"

// The deepest part, its answer and its status; lower: of all. ties: how many were as deep as the deepest before them.
static inline uint32_t brute_depth(const gjk_parts *a, const gjk_collider *b, const gjk_workspace *workspace,
                                   gjk_penetration_result *best, gjk_status *of_best, unsigned long *ties) {
  gjk_parts_room room;
  gjk_collider c;
  gjk_penetration_result one;
  uint32_t deepest = GJK_PARTS_NONE;
  gjk_q16 lower = 0;
  memset(best, 0, sizeof *best);
  *of_best = GJK_OK;
  for (uint32_t i = 0; i < gjk_parts_count(a); i++) {
    CHECK(gjk_parts_place(a, i, &room, &c) == GJK_OK);
    const gjk_status status = gjk_penetration(&c, b, NULL, workspace, &one);
    CHECK(status == GJK_OK || status == GJK_ERROR_CAPACITY);
    if (!one.intersecting) {
      continue;
    }
    CHECK(status != GJK_OK || gjk_check_penetration(&c, b, &one) != GJK_ERROR_UNPROVEN);
    lower = one.lower > lower ? one.lower : lower;
    *ties += deepest != GJK_PARTS_NONE && one.depth == best->depth;
    if (deepest == GJK_PARTS_NONE || one.depth > best->depth) {
      deepest = i;
      *of_best = status;
      *best = one;
    }
  }
  best->lower = lower;
  return deepest;
}

static inline bool brute_comes_first(const gjk_cast_result *one, const gjk_cast_result *best, uint32_t part) {
  return one->hit && (part == GJK_PARTS_NONE || one->fraction < best->fraction ||
                      (one->fraction == best->fraction && one->inside && !best->inside));
}

// A part's own way, which starts at its own place: the body's, moved along. to: what the way of the part points to.
static inline gjk_cast_path brute_path(const gjk_parts *a, const gjk_collider *part, const gjk_cast_path *path,
                                       gjk_vec3 *to) {
  gjk_cast_path own = *path;
  if (path->to_a != NULL) {
    to->x = path->to_a->x - a->pose.position.x + part->position.x;
    to->y = path->to_a->y - a->pose.position.y + part->position.y;
    to->z = path->to_a->z - a->pose.position.z + part->position.z;
    own.to_a = to;
  }
  return own;
}

// The part that is met first, and its answer.
static inline uint32_t brute_cast(const gjk_parts *a, const gjk_collider *b, const gjk_cast_path *path,
                                  gjk_cast_result *best) {
  gjk_parts_room room;
  gjk_collider c;
  gjk_cast_result one;
  uint32_t first = GJK_PARTS_NONE;
  memset(best, 0, sizeof *best);
  for (uint32_t i = 0; i < gjk_parts_count(a); i++) {
    gjk_vec3 to;
    CHECK(gjk_parts_place(a, i, &room, &c) == GJK_OK);
    const gjk_cast_path own = brute_path(a, &c, path, &to);
    CHECK(gjk_cast(&c, b, &own, &one) == GJK_OK);
    if (brute_comes_first(&one, best, first)) {
      CHECK(gjk_check_cast(&c, b, &own, &one) != GJK_ERROR_UNPROVEN);
      first = i;
      *best = one;
    }
  }
  return first;
}

// The same of times of impact. limited: some part reached its ceiling.
static inline uint32_t brute_impact(const gjk_parts *a, const gjk_motion motion[2], const gjk_collider *b,
                                    const gjk_impact_setup *setup, gjk_impact_result *best, bool *limited) {
  gjk_parts_room room;
  gjk_parts_local local;
  gjk_collider c;
  gjk_impact_result one;
  uint32_t first = GJK_PARTS_NONE;
  memset(best, 0, sizeof *best);
  *limited = false;
  for (uint32_t i = 0; i < gjk_parts_count(a); i++) {
    a->type->local(a->data, i, &room, &local);
    CHECK(gjk_collider_init(&c, local.shape, NULL, 0) == GJK_OK);
    const gjk_carried of[2] = {{&c, &motion[0], local.own, a->type->reach(a->data)}, {b, &motion[1], NULL, 0}};
    const gjk_status status = gjk_impact_of_carried(of, setup, gjk_pose_compose, &one);
    CHECK(status == GJK_OK || status == GJK_ERROR_ITERATION_LIMIT);
    *limited = *limited || status != GJK_OK;
    if (status == GJK_OK && one.hit &&
        (first == GJK_PARTS_NONE || one.lower < best->lower ||
         (one.lower == best->lower && one.overlap && !best->overlap))) {
      first = i;
      *best = one;
    }
  }
  return first;
}

#endif
