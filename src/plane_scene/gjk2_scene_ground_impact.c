// Times of impact with ground: each segment near the way is asked as a triangle of its own, at the ground's poses.
#include "../arith/gjk_memory.h"
#include "../ground/gjk2_ground_box.h"
#include "../ground/gjk2_ground_way.h"
#include "../plane/gjk2_measure.h"
#include "gjk2/pose.h"
#include "gjk2_scene_ground.h"

typedef struct ground_impact {
  const gjk2_ground *ground;
  const gjk2_collider *body;
  unsigned at;  // of the ground among the two
  const gjk2_motion *motion, *ahead;
  gjk2_impact_setup setup;
  gjk2_impact_query *query;
} ground_impact;

// Poses a copy of the body.
static gjk_status pose_copy(const gjk2_collider *body, const gjk2_pose *pose, gjk2_collider *out) {
  gjk_copy(out, body, sizeof *out);
  return gjk2_collider_pose(out, pose);
}

static bool same_rotation(const gjk2_pose *a, const gjk2_pose *b) {
  return a->rotation.c == b->rotation.c && a->rotation.s == b->rotation.s;
}

// A box that holds every place of the body relative to the ground, seen from where the ground begins.
static gjk2_aabb reach_of_way(const ground_impact *g) {
  const gjk2_motion *body = &g->motion[1 - g->at], *ground = &g->motion[g->at];
  // 2^28 + 2^28 + 2^29 and some:  below 2^31
  const int64_t around =
      (int64_t)gjk2_length_bound(g->body->local_centre) + g->body->radius + g->setup.margin + g->setup.tolerance + 8;
  const int64_t x = (int64_t)ground->to.position.x - ground->from.position.x;
  const int64_t y = (int64_t)ground->to.position.y - ground->from.position.y;
  // Where the ground turns, any of it may come by.
  const int64_t all = same_rotation(&ground->from, &ground->to) ? 0 : UINT32_MAX;
  const gjk2_aabb from = {body->from.position, body->from.position}, to = {body->to.position, body->to.position};
  const gjk2_aabb seen = gjk2_ground_box_at(&to, 0, -x, -y);
  gjk2_aabb box = gjk2_aabb_hull(&from, &seen);
  box.lower.x = gjk_saturate(box.lower.x - around - all);
  box.lower.y = gjk_saturate(box.lower.y - around - all);
  box.upper.x = gjk_saturate(box.upper.x + around + all);
  box.upper.y = gjk_saturate(box.upper.y + around + all);
  return box;
}

// The segment where the ground is at another pose. Neighbours turn with it; rounding of their ways does not matter.
static bool line_at(const gjk2_line *line, const gjk2_ground_edge *edge, const gjk2_pose *pose, gjk2_line *out) {
  gjk2_vec far;
  bool placed = gjk2_pose_apply(pose, &edge->vertex[1], &out->p) == GJK_OK &&
                gjk2_pose_apply(pose, &edge->vertex[2], &out->q) == GJK_OK;
  out->number = line->number;
  out->open_before = line->open_before;
  out->open_after = line->open_after;
  if (placed && !out->open_before) {
    placed = gjk2_pose_apply(pose, &edge->vertex[0], &far) == GJK_OK;
    out->before = gjk2_sub(out->p, far);
  }
  if (placed && !out->open_after) {
    placed = gjk2_pose_apply(pose, &edge->vertex[3], &far) == GJK_OK;
    out->after = gjk2_sub(far, out->q);
  }
  return placed && !gjk2_equal(out->p, out->q);
}

// Does an impact count? As of gjk2_ground_cast, with the poses at lower.
static bool does_impact_count(const ground_impact *g, const gjk2_line *line, const gjk2_ground_edge *edge,
                              const gjk2_impact_result *hit) {
  gjk2_collider body;
  gjk2_line there;
  const gjk2_pose *of_ground = g->at == 0 ? &hit->pose_a : &hit->pose_b;
  const gjk2_pose *of_body = g->at == 0 ? &hit->pose_b : &hit->pose_a;
  if (!line_at(line, edge, of_ground, &there) || pose_copy(g->body, of_body, &body) != GJK_OK) {
    return true;  // not reached: both were there
  }
  if (!gjk2_ground_is_in_front(&there, &body.centre)) {
    return false;
  }
  if (hit->overlap || hit->distance <= 0) {
    return true;
  }
  const gjk2_unit normal = {g->at == 0 ? hit->normal.x : -hit->normal.x, g->at == 0 ? hit->normal.y : -hit->normal.y};
  return gjk2_ground_side_of(&there, &normal) != GJK2_GROUND_OTHER;
}

// Is the body in front of a segment, where both begin?
static bool begins_ahead(const ground_impact *g, const gjk2_line *line, const gjk2_ground_edge *edge) {
  gjk2_collider body;
  gjk2_line there;
  return line_at(line, edge, &g->ahead[g->at].from, &there) &&
         pose_copy(g->body, &g->ahead[1 - g->at].from, &body) == GJK_OK &&
         gjk2_ground_is_ahead(&there, &body, g->setup.tolerance);
}

static gjk_status impact_of_segment(const ground_impact *g, const gjk2_ground_edge *edge, gjk2_impact_result *out) {
  const gjk2_vec vertices[3] = {edge->vertex[1], edge->vertex[2], edge->vertex[2]};
  const gjk2_shape shape = GJK2_TRIANGLE(vertices);
  gjk2_collider segment;
  const gjk_status status = gjk2_collider_init(&segment, &shape, NULL, 0);
  const gjk2_collider *a = g->at == 0 ? &segment : g->body, *b = g->at == 0 ? g->body : &segment;
  return status == GJK_OK ? g->query(a, &g->motion[0], b, &g->motion[1], &g->setup, out) : status;
}

// Asks all segments near the way. Where one reaches its ceiling, its lower fraction counts as an impact.
static gjk_status find_first_impact(const ground_impact *g, gjk2_ground_walk *walk, gjk2_impact_result *out) {
  const gjk2_aabb box = reach_of_way(g);
  gjk_status of_first = GJK_OK;
  gjk2_line line;
  gjk2_ground_edge edge;
  bool found = false;
  gjk2_ground_begin(walk, &box);
  while (gjk2_ground_next(walk, &line, &edge)) {
    gjk2_impact_result hit;
    hit.hit = hit.overlap = false;
    hit.lower = 0;
    gjk2_ground_set_neighbours(walk, &line, &edge);
    if (g->ahead != NULL && !begins_ahead(g, &line, &edge)) {
      continue;
    }
    const gjk_status status = impact_of_segment(g, &edge, &hit);
    if (status != GJK_OK && status != GJK_ERROR_ITERATION_LIMIT) {
      return status;
    }
    if (status == GJK_OK && !(hit.hit && does_impact_count(g, &line, &edge, &hit))) {
      continue;
    }
    if (!found || hit.lower < out->lower) {
      out->hit = status == GJK_OK;
      out->overlap = hit.overlap;
      out->lower = hit.lower;
      of_first = status;
      found = true;
    }
  }
  out->hit = found && out->hit;
  return of_first;
}

gjk_status gjk2_scene_ground_impact(const gjk2_collider c[2], const gjk2_motion motion[2], gjk_q16 margin,
                                    const gjk2_motion *ahead, gjk2_impact_query *query, gjk2_impact_result *out) {
  ground_impact g;
  gjk2_ground_walk walk;
  out->hit = false;
  g.at = c[0].shape->type->ground != NULL ? 0 : 1;
  g.body = &c[1 - g.at];
  if (g.body->shape->type->ground != NULL) {
    return GJK_OK;
  }
  g.ground = (const gjk2_ground *)c[g.at].shape->user;
  g.motion = motion;
  g.ahead = ahead;
  g.setup.margin = margin;
  g.setup.tolerance = GJK2_IMPACT_TOLERANCE_MIN;
  g.setup.iterations = 0;
  g.query = query;
  const gjk_status status = gjk2_ground_place(g.ground, &motion[g.at].from, &walk);
  return status == GJK_OK ? find_first_impact(&g, &walk, out) : status;
}
