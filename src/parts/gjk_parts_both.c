// Two bodies of many parts: the parts of B are asked one after the other, each against A.
#include "gjk_parts_both.h"
#include "../arith/gjk_memory.h"
#include "gjk_parts_near.h"
#include "gjk_parts_nearest.h"

gjk_status gjk_parts_both_open(gjk_parts_frame frame[2], const gjk_parts *a, const gjk_parts *b) {
  const gjk_status status = gjk_parts_frame_set(&frame[0], a);
  return status == GJK_OK ? gjk_parts_frame_set(&frame[1], b) : status;
}

gjk_status gjk_parts_both_part(const gjk_parts_frame frame[2], uint32_t number, gjk_parts_room *room, gjk_collider *out,
                               gjk_region *region) {
  gjk_aabb box;
  gjk_status status = gjk_parts_place_in(&frame[1], number, room, out);
  status = status == GJK_OK ? gjk_collider_aabb(out, &box) : status;
  if (status == GJK_OK) {
    gjk_region_start(region, frame[0].rows, &frame[0].parts->pose.position, &box, NULL);
  }
  return status;
}

void gjk_parts_write_numbers(uint32_t a, uint32_t b, gjk_parts_pair *out) {
  if (out != NULL) {
    out->a = a;
    out->b = b;
  }
}

gjk_status gjk_parts_both_within(const gjk_parts *a, const gjk_parts *b, gjk_q16 distance, gjk_parts_pair *parts,
                                 gjk_decision *out) {
  gjk_parts_frame frame[2];
  gjk_parts_room room;
  gjk_collider c;
  gjk_region region;
  gjk_decision decision;
  uint32_t found = GJK_PARTS_NONE;
  bool limited = false;
  if (out == NULL) {
    return GJK_ERROR_NULL;
  }
  const gjk_status status = gjk_parts_both_open(frame, a, b);
  if (status != GJK_OK || distance < 0) {
    return status != GJK_OK ? status : GJK_ERROR_NEGATIVE;
  }
  const uint32_t count = gjk_parts_count(b);
  for (uint32_t i = 0; i < count; i++) {
    gjk_status of_part = gjk_parts_both_part(frame, i, &room, &c, &region);
    if (gjk_parts_both_lacks(&of_part)) {
      continue;
    }
    if (of_part == GJK_OK) {
      gjk_region_grow(&region, distance);
      of_part = gjk_parts_near(&frame[0], &region, &c, distance, &found, &decision);
    }
    limited = limited || of_part == GJK_ERROR_ITERATION_LIMIT;
    if (of_part != GJK_OK && of_part != GJK_ERROR_ITERATION_LIMIT) {
      return of_part;
    }
    if (found != GJK_PARTS_NONE) {
      gjk_parts_report_near(found, &decision, out);
      gjk_parts_write_numbers(found, i, parts);
      return GJK_OK;
    }
  }
  if (limited) {
    return GJK_ERROR_ITERATION_LIMIT;
  }
  gjk_parts_report_near(GJK_PARTS_NONE, NULL, out);
  gjk_parts_write_numbers(GJK_PARTS_NONE, GJK_PARTS_NONE, parts);
  return GJK_OK;
}

gjk_status gjk_parts_both_distance(const gjk_parts *a, const gjk_parts *b, gjk_parts_pair *parts,
                                   gjk_distance_result *out) {
  gjk_parts_frame frame[2];
  gjk_parts_room room;
  gjk_collider c;
  gjk_region region;
  gjk_parts_nearest nearest;
  if (out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_status status = gjk_parts_both_open(frame, a, b);
  if (status != GJK_OK) {
    return status;
  }
  const uint32_t count = gjk_parts_count(b);
  gjk_parts_nearest_start(&nearest);
  for (uint32_t i = 0; i < count && status == GJK_OK; i++) {
    status = gjk_parts_both_part(frame, i, &room, &c, &region);
    if (gjk_parts_both_lacks(&status)) {
      continue;
    }
    status = status == GJK_OK ? gjk_parts_nearest_ask(&nearest, &frame[0], &region, &c, i) : status;
  }
  for (uint32_t i = 0; nearest.limited && i < count && status == GJK_OK; i++) {
    status = gjk_parts_both_part(frame, i, &room, &c, &region);
    if (gjk_parts_both_lacks(&status)) {
      continue;
    }
    status = status == GJK_OK ? gjk_parts_nearest_bound(&nearest, &frame[0], &region, &c) : status;
  }
  if (status != GJK_OK || nearest.part == GJK_PARTS_NONE) {
    return status != GJK_OK ? status : GJK_ERROR_EMPTY;  // B has holes alone
  }
  gjk_parts_write_numbers(nearest.part, nearest.of_b, parts);
  status = gjk_parts_place_in(&frame[1], nearest.of_b, &room, &c);
  return status == GJK_OK ? gjk_parts_nearest_report(&nearest, &frame[0], &c, out) : status;
}
