// The depth of bodies of many parts: that of the deepest part.
//
// All parts whose boxes B's box meets are asked; none can be left out, since a box tells nothing of a depth.
#include "../arith/gjk_memory.h"
#include "gjk_parts_both.h"
#include "gjk_parts_deepest.h"

void gjk_parts_deepest_start(gjk_parts_deepest *d) {
  d->best = 0;
  d->part = GJK_PARTS_NONE;
  d->of_b = GJK_PARTS_NONE;
  d->status = GJK_OK;
  d->lower = 0;
}

// Is the trial deeper than the best one?
static bool is_deeper(const gjk_parts_deepest *d, const gjk_penetration_result *trial, uint32_t part, uint32_t of_b) {
  const gjk_penetration_result *best = &d->result[d->best];
  if (d->part == GJK_PARTS_NONE) {
    return true;
  }
  if (trial->depth != best->depth) {
    return trial->depth > best->depth;
  }
  return of_b != d->of_b ? of_b < d->of_b : part < d->part;
}

gjk_status gjk_parts_deepest_ask(gjk_parts_deepest *d, const gjk_parts_frame *frame, const gjk_region *region,
                                 const gjk_collider *b, uint32_t number, const gjk_workspace *workspace) {
  gjk_parts_walk walk;
  gjk_parts_room room;
  gjk_collider c;
  uint32_t part;
  gjk_parts_walk_start(&walk);
  while (gjk_parts_next(frame, region, &walk, &part)) {  // ends: each part comes once
    gjk_penetration_result *trial = &d->result[1 - d->best];
    gjk_status status = gjk_parts_place_in(frame, part, &room, &c);
    if (status != GJK_OK) {
      return status;
    }
    status = gjk_penetration(&c, b, NULL, workspace, trial);
    if (status != GJK_OK && status != GJK_ERROR_CAPACITY) {
      return status;
    }
    if (!trial->intersecting) {
      continue;
    }
    d->lower = trial->lower > d->lower ? trial->lower : d->lower;
    if (is_deeper(d, trial, part, number)) {
      d->best = 1 - d->best;
      d->part = part;
      d->of_b = number;
      d->status = status;
    }
  }
  return GJK_OK;
}

gjk_status gjk_parts_deepest_report(const gjk_parts_deepest *d, gjk_penetration_result *out) {
  if (d->part == GJK_PARTS_NONE) {
    out->intersecting = false;
    out->iterations = 0;
    out->certificate.proof = GJK_PROOF_NONE;
    out->certificate.count = 0;
    return GJK_OK;
  }
  gjk_copy(out, &d->result[d->best], sizeof *out);
  out->lower = d->lower;
  return d->status;
}

gjk_status gjk_parts_penetration(const gjk_parts *a, const gjk_collider *b, const gjk_workspace *workspace,
                                 uint32_t *part, gjk_penetration_result *out) {
  gjk_parts_frame frame;
  gjk_region region;
  gjk_parts_deepest deepest;
  if (out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_status status = gjk_parts_open(&frame, &region, a, b);
  if (status == GJK_OK) {
    gjk_parts_deepest_start(&deepest);
    status = gjk_parts_deepest_ask(&deepest, &frame, &region, b, 0, workspace);
  }
  if (status != GJK_OK) {
    return status;
  }
  if (part != NULL) {
    *part = deepest.part;
  }
  return gjk_parts_deepest_report(&deepest, out);
}

gjk_status gjk_parts_both_penetration(const gjk_parts *a, const gjk_parts *b, const gjk_workspace *workspace,
                                      gjk_parts_pair *parts, gjk_penetration_result *out) {
  gjk_parts_frame frame[2];
  gjk_parts_room room;
  gjk_collider c;
  gjk_region region;
  gjk_parts_deepest deepest;
  if (out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_status status = gjk_parts_both_open(frame, a, b);
  const uint32_t count = status == GJK_OK ? gjk_parts_count(b) : 0;
  gjk_parts_deepest_start(&deepest);
  for (uint32_t i = 0; i < count && status == GJK_OK; i++) {
    status = gjk_parts_both_part(frame, i, &room, &c, &region);
    if (gjk_parts_both_lacks(&status)) {
      continue;
    }
    status = status == GJK_OK ? gjk_parts_deepest_ask(&deepest, &frame[0], &region, &c, i, workspace) : status;
  }
  if (status != GJK_OK) {
    return status;
  }
  gjk_parts_write_numbers(deepest.part, deepest.of_b, parts);
  return gjk_parts_deepest_report(&deepest, out);
}
