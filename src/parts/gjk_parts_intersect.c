// Yes-or-no queries of bodies of many parts.
//
// The parts that B's box meets, grown by the distance, are asked one after the other. Once one is near, only parts of lower
// numbers are asked. So the least number is found in any order, and the walk above is all that it costs.
#include "../arith/gjk_memory.h"
#include "gjk_parts_near.h"

gjk_status gjk_parts_near(const gjk_parts_frame *frame, const gjk_region *region, const gjk_collider *b,
                          gjk_q16 distance, uint32_t *part, gjk_decision *out) {
  gjk_parts_walk walk;
  gjk_parts_room room;
  gjk_collider c;
  gjk_decision trial;
  uint32_t number;
  bool limited = false;
  *part = GJK_PARTS_NONE;
  gjk_parts_walk_start(&walk);
  while (gjk_parts_next(frame, region, &walk, &number)) {  // ends: each part comes once
    if (number >= *part) {
      continue;
    }
    gjk_status status = gjk_parts_place_in(frame, number, &room, &c);
    status = status == GJK_OK ? gjk_within(&c, b, distance, NULL, &trial) : status;
    if (status == GJK_ERROR_ITERATION_LIMIT) {
      limited = true;
    } else if (status != GJK_OK) {
      return status;
    } else if (trial.yes) {
      *part = number;
      gjk_copy(out, &trial, sizeof *out);
    }
  }
  return *part == GJK_PARTS_NONE && limited ? GJK_ERROR_ITERATION_LIMIT : GJK_OK;
}

void gjk_parts_report_near(uint32_t found, const gjk_decision *of_part, gjk_decision *out) {
  if (found != GJK_PARTS_NONE) {
    gjk_copy(out, of_part, sizeof *out);
    return;
  }
  out->yes = false;
  out->iterations = 0;
  out->certificate.proof = GJK_PROOF_NONE;
  out->certificate.count = 0;
}

gjk_status gjk_parts_within(const gjk_parts *a, const gjk_collider *b, gjk_q16 distance, uint32_t *part,
                            gjk_decision *out) {
  gjk_parts_frame frame;
  gjk_region region;
  gjk_decision decision;
  uint32_t found;
  if (out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_status status = gjk_parts_open(&frame, &region, a, b);
  if (status != GJK_OK || distance < 0) {
    return status != GJK_OK ? status : GJK_ERROR_NEGATIVE;
  }
  gjk_region_grow(&region, distance);
  status = gjk_parts_near(&frame, &region, b, distance, &found, &decision);
  if (status == GJK_OK) {
    gjk_parts_report_near(found, &decision, out);
    if (part != NULL) {
      *part = found;
    }
  }
  return status;
}

gjk_status gjk_parts_intersect(const gjk_parts *a, const gjk_collider *b, uint32_t *part, gjk_decision *out) {
  return gjk_parts_within(a, b, 0, part, out);
}
