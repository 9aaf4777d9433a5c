// The distance of bodies of many parts.
//
// 1. Ask the part that the class guesses to be near.
// 2. Walk through the parts whose boxes are as near as the nearest part so far, and shrink the region with it.
// 3. Where a part has reached its ceiling (curved ones alone), walk again through the final region. The least lower bound of
//    the limited parts in it is one of all. That region depends on the answer alone, so the walk's order does not matter.
//
// Step 2 leaves out no part that would be reported. A part outside has a gap above the region's growth: the reported
// distance, 2^-26 of it and 4 LSB. A reported distance of d is at least (1 - 2^-27) times the gap, less 3.
#include "../query/gjk_distance.h"
#include "gjk_parts_nearest.h"

void gjk_parts_nearest_start(gjk_parts_nearest *n) {
  n->part = GJK_PARTS_NONE;
  n->of_b = GJK_PARTS_NONE;
  n->status = GJK_OK;
  n->limited = false;
  n->lower = GJK_DISTANCE_MAX;
}

// A distance at the end of its range is any that is larger: then the region is all there is.
static void grow_to(gjk_region *region, gjk_q16 distance) {
  const int64_t beyond = distance == GJK_DISTANCE_MAX ? INT64_C(1) << 34 : gjk_sar32(distance, 26) + 4;
  gjk_region_grow(region, distance + beyond);
}

// Is the trial a nearer part than the best one?
static bool is_nearer(const gjk_parts_nearest *n, const gjk_distance_result *trial, uint32_t number, uint32_t of_b) {
  if (n->part == GJK_PARTS_NONE) {
    return true;
  }
  if (trial->intersecting != n->intersecting) {
    return trial->intersecting;
  }
  if (trial->distance != n->distance) {
    return trial->distance < n->distance;
  }
  return of_b != n->of_b ? of_b < n->of_b : number < n->part;
}

// Asks one part. *nearer: it is the nearest now.
static gjk_status ask_part(gjk_parts_nearest *n, const gjk_parts_frame *frame, const gjk_collider *b, uint32_t number,
                           uint32_t of_b, bool *nearer) {
  gjk_parts_room room;
  gjk_collider c;
  gjk_distance_result trial;
  *nearer = false;
  gjk_status status = gjk_parts_place_in(frame, number, &room, &c);
  if (status != GJK_OK) {
    return status;
  }
  status = gjk_distance_with(&c, b, GJK_DISTANCE_ALONE, NULL, &trial);
  if (status != GJK_OK && status != GJK_ERROR_ITERATION_LIMIT) {
    return status;  // not reached: both are posed
  }
  n->limited = n->limited || status != GJK_OK;
  if (is_nearer(n, &trial, number, of_b)) {
    n->distance = trial.distance;
    n->intersecting = trial.intersecting;
    n->part = number;
    n->of_b = of_b;
    n->status = status;
    *nearer = true;
  }
  return GJK_OK;
}

gjk_status gjk_parts_nearest_ask(gjk_parts_nearest *n, const gjk_parts_frame *frame, gjk_region *region,
                                 const gjk_collider *b, uint32_t of_b) {
  gjk_parts_walk walk;
  gjk_status status = GJK_OK;
  uint32_t part, guess = GJK_PARTS_NONE;
  bool nearer;
  if (n->part == GJK_PARTS_NONE) {
    guess = frame->parts->type->guess(frame->parts->data, region);  // Step 1
    status = ask_part(n, frame, b, guess, of_b, &nearer);
  }
  if (status != GJK_OK) {
    return status;
  }
  grow_to(region, n->distance);
  gjk_parts_walk_start(&walk);
  while (gjk_parts_next(frame, region, &walk, &part)) {  // Step 2; ends: each part comes once
    if (part == guess || (n->intersecting && of_b == n->of_b && part > n->part)) {
      continue;
    }
    status = ask_part(n, frame, b, part, of_b, &nearer);
    if (status != GJK_OK) {
      return status;
    }
    if (nearer) {
      grow_to(region, n->distance);
    }
  }
  return GJK_OK;
}

gjk_status gjk_parts_nearest_bound(gjk_parts_nearest *n, const gjk_parts_frame *frame, gjk_region *region,
                                   const gjk_collider *b) {
  gjk_parts_walk walk;
  gjk_parts_room room;
  gjk_collider c;
  gjk_distance_result trial;
  uint32_t part;
  grow_to(region, n->distance);
  gjk_parts_walk_start(&walk);
  trial.lower = n->lower;
  while (gjk_parts_next(frame, region, &walk, &part)) {  // Step 3; ends: each part comes once
    gjk_status status = gjk_parts_place_in(frame, part, &room, &c);
    status = status == GJK_OK ? gjk_distance_with(&c, b, GJK_DISTANCE_ALONE, NULL, &trial) : status;
    if (status == GJK_ERROR_ITERATION_LIMIT) {
      n->lower = trial.lower < n->lower ? trial.lower : n->lower;
    } else if (status != GJK_OK) {
      return status;  // not reached: step 2 has placed each part
    }
  }
  return GJK_OK;
}

gjk_status gjk_parts_nearest_report(const gjk_parts_nearest *n, const gjk_parts_frame *frame, const gjk_collider *b,
                                    gjk_distance_result *out) {
  gjk_parts_room room;
  gjk_collider c;
  gjk_status status = gjk_parts_place_in(frame, n->part, &room, &c);
  status = status == GJK_OK ? gjk_distance(&c, b, NULL, out) : status;
  if (status != n->status) {
    return status;  // not reached: the same part had that status before
  }
  if (out->intersecting || !n->limited || (n->status == GJK_OK && n->lower >= out->distance)) {
    return GJK_OK;
  }
  out->lower = n->lower < out->lower ? n->lower : out->lower;
  out->certificate.proof = GJK_PROOF_NONE;
  out->certificate.count = 0;
  return GJK_ERROR_ITERATION_LIMIT;
}

gjk_status gjk_parts_distance(const gjk_parts *a, const gjk_collider *b, uint32_t *part, gjk_distance_result *out) {
  gjk_parts_frame frame;
  gjk_region region;
  gjk_parts_nearest nearest;
  if (out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_status status = gjk_parts_open(&frame, &region, a, b);
  if (status != GJK_OK) {
    return status;
  }
  gjk_parts_nearest_start(&nearest);
  status = gjk_parts_nearest_ask(&nearest, &frame, &region, b, 0);
  if (status == GJK_OK && nearest.limited) {
    status = gjk_parts_nearest_bound(&nearest, &frame, &region, b);
  }
  if (status != GJK_OK) {
    return status;
  }
  if (part != NULL) {
    *part = nearest.part;
  }
  return gjk_parts_nearest_report(&nearest, &frame, b, out);
}
