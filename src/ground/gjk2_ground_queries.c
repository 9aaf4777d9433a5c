// Is ground near, how far is it, and where does a body touch it? Each segment is asked as a collider of its own.
#include "gjk2_ground_queries.h"

#include "../arith/gjk_memory.h"
#include "gjk2/distance.h"
#include "gjk2/intersect.h"
#include "gjk2_ground_way.h"

// Places a walk for a query of a body. Statuses of all of them.
static gjk_status open_query(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_collider *body,
                             const void *out, gjk2_ground_walk *walk, gjk2_aabb *box) {
  if (out == NULL) {
    return GJK_ERROR_NULL;
  }
  const gjk_status status = gjk2_ground_place(ground, pose, walk);
  return status == GJK_OK ? gjk2_collider_aabb(body, box) : status;
}

gjk_status gjk2_ground_within(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_collider *body,
                              gjk_q16 distance, bool *yes) {
  gjk2_ground_walk walk;
  gjk2_aabb box;
  gjk_status status = open_query(ground, pose, body, yes, &walk, &box), open = GJK_OK;
  if (status != GJK_OK || distance < 0) {
    return status != GJK_OK ? status : GJK_ERROR_NEGATIVE;
  }
  const gjk2_aabb near = gjk2_ground_box_at(&box, distance, 0, 0);
  gjk2_line line;
  gjk2_ground_edge edge;
  gjk2_decision decision;
  decision.yes = false;
  gjk2_ground_begin(&walk, &near);
  while (!decision.yes && gjk2_ground_next(&walk, &line, &edge)) {
    gjk2_collider segment;
    if (!gjk2_ground_is_in_front(&line, &body->centre)) {
      continue;
    }
    gjk2_line_collider(line.p, line.q, &segment);
    status = gjk2_within(&segment, body, distance, NULL, &decision);
    if (status != GJK_OK) {
      open = status;
      decision.yes = false;
    }
  }
  if (decision.yes || open == GJK_OK) {
    *yes = decision.yes;
    return GJK_OK;
  }
  return open;
}

// The nearest segment so far.
typedef struct nearest_segment {
  bool found;
  uint32_t segment;
  gjk2_distance_result result;
} nearest_segment;

// Asks all segments near a box.
static gjk_status find_nearest(gjk2_ground_walk *walk, const gjk2_aabb *near, const gjk2_collider *body,
                               nearest_segment *best) {
  gjk2_line line;
  gjk2_ground_edge edge;
  gjk_status open = GJK_OK;
  best->found = false;
  gjk2_ground_begin(walk, near);
  while (gjk2_ground_next(walk, &line, &edge)) {
    gjk2_collider segment;
    gjk2_distance_result result;
    if (!gjk2_ground_is_in_front(&line, &body->centre)) {
      continue;
    }
    gjk2_line_collider(line.p, line.q, &segment);
    const gjk_status status = gjk2_distance(&segment, body, NULL, &result);
    if (status != GJK_OK) {
      open = status;
    } else if (!best->found || result.distance < best->result.distance ||
               (result.distance == best->result.distance && line.number < best->segment)) {
      best->found = true;
      best->segment = line.number;
      gjk_copy(&best->result, &result, sizeof result);
    }
  }
  return open;
}

// Does a box hold all that ground can reach?
static bool holds_all(const gjk2_aabb *box, const gjk2_ground_walk *walk) {
  const int64_t far = 2 * (int64_t)GJK2_GROUND_REACH;
  const gjk2_vec at = walk->position;
  return box->lower.x <= at.x - far && box->lower.y <= at.y - far && box->upper.x >= at.x + far &&
         box->upper.y >= at.y + far;
}

// A box around the body grows until a segment in it is no farther than it grew: then none outside of it is nearer.
gjk_status gjk2_ground_distance(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_collider *body,
                                gjk2_distance_result *out, uint32_t *segment, bool *found) {
  gjk2_ground_walk walk;
  gjk2_aabb box;
  nearest_segment best;
  gjk_status status =
      segment == NULL || found == NULL ? GJK_ERROR_NULL : open_query(ground, pose, body, out, &walk, &box);
  if (status != GJK_OK) {
    return status;
  }
  gjk_q16 reach = body->radius / 4 + 64;
  for (;;) {  // ends: reach doubles up to INT32_MAX, where the box holds all
    const gjk2_aabb near = gjk2_ground_box_at(&box, reach, 0, 0);
    status = find_nearest(&walk, &near, body, &best);
    // A distance is rounded, so one that was not found may be an LSB less than its box is away.
    if ((best.found && best.result.distance < reach - 1) || reach == INT32_MAX || holds_all(&near, &walk)) {
      break;
    }
    reach = reach > INT32_MAX / 4 ? INT32_MAX : 4 * reach;
  }
  if (status != GJK_OK) {
    return status;
  }
  *found = best.found;
  if (best.found) {
    *segment = best.segment;
    gjk_copy(out, &best.result, sizeof *out);
  }
  return GJK_OK;
}

gjk_status gjk2_ground_contacts(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_collider *body,
                                gjk_q16 margin, gjk2_chain_contact *out, uint16_t capacity, uint16_t *count) {
  gjk2_ground_walk walk;
  gjk2_aabb box;
  gjk_status status = count == NULL ? GJK_ERROR_NULL : open_query(ground, pose, body, out, &walk, &box);
  if (status != GJK_OK || margin < 0 || margin > GJK2_RADIUS_MAX) {
    return status != GJK_OK ? status : margin < 0 ? GJK_ERROR_NEGATIVE : GJK_ERROR_RANGE;
  }
  gjk2_line_list found = {out, capacity, 0, false};
  gjk2_line_query query;
  gjk2_line line;
  gjk2_ground_edge edge;
  const gjk2_aabb near = gjk2_ground_box_at(&box, margin, 0, 0);
  gjk2_line_query_set(&query, body, &box, margin);
  query.take = gjk2_line_list_take;
  query.user = &found;
  gjk2_ground_begin(&walk, &near);
  while (status == GJK_OK && gjk2_ground_next(&walk, &line, &edge)) {
    gjk2_ground_set_neighbours(&walk, &line, &edge);
    status = gjk2_line_contacts(&query, &line);
  }
  if (status == GJK_OK) {
    *count = found.count;
    status = found.overflows ? GJK_ERROR_CAPACITY : GJK_OK;
  }
  return status;
}

gjk_status gjk2_ground_visit(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_aabb *box,
                             gjk2_segment_function *take, void *user) {
  gjk2_ground_walk walk;
  gjk2_line line;
  gjk2_ground_edge edge;
  const gjk_status status = box == NULL || take == NULL ? GJK_ERROR_NULL : gjk2_ground_place(ground, pose, &walk);
  if (status != GJK_OK) {
    return status;
  }
  gjk2_ground_begin(&walk, box);
  while (gjk2_ground_next(&walk, &line, &edge)) {
    take(user, &line.p, &line.q, line.number);
  }
  return GJK_OK;
}
