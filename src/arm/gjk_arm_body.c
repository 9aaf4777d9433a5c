// Bodies of many parts as obstacles of an arm: see gjk_arm_body.h.
#include "gjk_arm_body.h"

#include "../arith/gjk_memory.h"
#include "../parts/gjk_parts_class.h"
#include "gjk/distance.h"
#include "gjk/intersect.h"
#include "gjk_arm_bound.h"
#include "gjk_arm_edge.h"

// The pieces of a body that are near a part.
typedef struct arm_pieces {
  gjk_parts_frame frame;
  gjk_region region;
  gjk_parts_walk walk;
  gjk_parts_room room;
  gjk_collider piece;  // the last one placed
} arm_pieces;

// A box around the part's spheres at both ends: it holds gjk_arm_box, but for the rounding of centres.
static void box_of_spheres(const gjk_arm *arm, unsigned number, unsigned start, unsigned end, gjk_aabb *out) {
  const gjk_arm_part_room *part = &arm->memory.parts[number];
  const gjk_vec3 *a = &part->at[start], *b = &part->at[end];
  const int64_t radius = (int64_t)part->collider.radius + 6;
  out->lower.x = gjk_saturate((a->x < b->x ? a->x : b->x) - radius);
  out->lower.y = gjk_saturate((a->y < b->y ? a->y : b->y) - radius);
  out->lower.z = gjk_saturate((a->z < b->z ? a->z : b->z) - radius);
  out->upper.x = gjk_saturate((a->x > b->x ? a->x : b->x) + radius);
  out->upper.y = gjk_saturate((a->y > b->y ? a->y : b->y) + radius);
  out->upper.z = gjk_saturate((a->z > b->z ? a->z : b->z) + radius);
}

// Step 1. Starts the walk through the pieces of a pair's body. *any: there may be some. 0 <= grow < 2^33.
static gjk_status arm_open(const gjk_arm *arm, const gjk_arm_pair *pair, unsigned start, unsigned end, int64_t grow,
                           arm_pieces *out, bool *any) {
  const gjk_parts *body = &arm->bodies[pair->other];
  gjk_aabb box;
  uint32_t number;
  const gjk_status status = gjk_parts_frame_set(&out->frame, body);
  if (status != GJK_OK) {
    return status;
  }
  box_of_spheres(arm, pair->part, start, end, &box);
  gjk_region_start(&out->region, out->frame.rows, &body->pose.position, &box, NULL);
  gjk_region_grow(&out->region, grow);
  gjk_parts_walk_start(&out->walk);
  *any = gjk_parts_next(&out->frame, &out->region, &out->walk, &number);
  if (*any) {
    gjk_arm_box(arm, pair->part, start, end, &box);
    gjk_region_start(&out->region, out->frame.rows, &body->pose.position, &box, NULL);
    gjk_region_grow(&out->region, grow);
    gjk_parts_walk_start(&out->walk);
  }
  return GJK_OK;
}

static bool next_piece(arm_pieces *pieces, bool any, uint32_t *number) {
  return any && gjk_parts_next(&pieces->frame, &pieces->region, &pieces->walk, number);
}

static gjk_status place_piece(arm_pieces *pieces, uint32_t number) {
  return gjk_parts_place_in(&pieces->frame, number, &pieces->room, &pieces->piece);
}

// Ends an edge at a body at fault.
static gjk_arm_found stop_at_fault(gjk_arm *arm, gjk_status status) {
  arm->fault = status;
  arm->state = GJK_ARM_STUCK;
  return GJK_ARM_OPEN;
}

// Step 2 for one piece. report: the proof is wanted.
static gjk_arm_found look_at_piece(gjk_arm *arm, uint32_t number, uint32_t piece, int64_t bend, bool report,
                                   arm_pieces *pieces) {
  gjk_arm_pair *pair = &arm->memory.pairs[number];
  const int64_t off = bend + pair->slack, margin = arm->setup.margin;
  const gjk_arm_search search = {margin + off, margin + arm->setup.tolerance};
  gjk_arm_view view;
  gjk_unit3 fresh = {0, 0, 0}, direction;
  int64_t gap;
  const gjk_status status = place_piece(pieces, piece);
  arm->tests++;
  if (status != GJK_OK) {
    return stop_at_fault(arm, status);
  }
  if (report && arm->proof == NULL && gjk_arm_spheres_apart(arm, pair, &pieces->piece, arm->gap + off)) {
    return GJK_ARM_APART;
  }
  gjk_arm_look(arm, pair, &pieces->piece, arm->first, arm->first ^ 1u, &view);
  const gjk_arm_found found =
      gjk_arm_separate(&view, &search, piece == pair->piece ? &pair->direction : &fresh, &direction, &gap);
  if (found == GJK_ARM_APART && report) {
    gjk_arm_prove(arm, number, piece, gjk_sar64(gap, 30) - off, &direction);
  }
  return found;
}

// The pair stays open because of a piece.
static gjk_arm_found stay_open(gjk_arm_pair *pair, uint32_t piece, gjk_arm_found found) {
  if (pair->piece != piece) {
    pair->piece = piece;
    pair->direction.x = pair->direction.y = pair->direction.z = 0;
  }
  return found;
}

static gjk_arm_found span_of_body(gjk_arm *arm, uint32_t number, int64_t bend, uint32_t left) {
  static const gjk_unit3 none = {0, 0, 0};
  gjk_arm_pair *pair = &arm->memory.pairs[number];
  arm_pieces pieces;
  bool any;
  uint32_t piece;
  if (!arm->within) {  // pieces within the part's own size count for the gap of a FREE answer
    const int64_t spare = (int64_t)arm->setup.margin + arm->memory.parts[pair->part].collider.radius;
    arm->spare = (gjk_q16)(spare < arm->gap ? spare : arm->gap);
  }
  gjk_status status = arm_open(arm, pair, arm->first, arm->first ^ 1u, arm->spare + bend + pair->slack, &pieces, &any);
  if (status != GJK_OK) {
    arm->tests++;
    return stop_at_fault(arm, status);
  }
  if (!arm->within) {
    arm->node = arm->item = 0;
    if (any && pair->piece != GJK_PARTS_NONE) {
      const gjk_arm_found found = look_at_piece(arm, number, pair->piece, bend, false, &pieces);
      if (found != GJK_ARM_APART) {
        return found;
      }
      left--;
    }
    arm->within = true;
  }
  pieces.walk.node = arm->node;
  pieces.walk.item = arm->item;
  for (; left > 0; left--) {
    if (!next_piece(&pieces, any, &piece)) {
      arm->within = false;
      arm->tests++;
      gjk_arm_prove(arm, number, GJK_PARTS_NONE, arm->spare, &none);
      return GJK_ARM_APART;
    }
    const gjk_arm_found found = look_at_piece(arm, number, piece, bend, true, &pieces);
    if (found != GJK_ARM_APART) {
      arm->within = false;
      return stay_open(pair, piece, found);
    }
  }
  arm->node = pieces.walk.node;
  arm->item = pieces.walk.item;
  return GJK_ARM_MORE;
}

static gjk_status near_body(const gjk_arm *arm, const gjk_arm_pair *pair, unsigned which, int64_t distance, bool *yes,
                            uint32_t *piece) {
  arm_pieces pieces;
  gjk_collider part;
  gjk_decision decision;
  bool any, placed = false;
  uint32_t number, limited = GJK_PARTS_NONE;
  *piece = GJK_PARTS_NONE;
  gjk_status status = arm_open(arm, pair, which, which, distance + GJK_ARM_SLACK_MAX, &pieces, &any);
  while (status == GJK_OK && next_piece(&pieces, any, &number)) {  // ends: each piece comes once
    if (number >= *piece) {
      continue;
    }
    status = place_piece(&pieces, number);
    if (status != GJK_OK || gjk_arm_surely_apart(arm, pair, &pieces.piece, which, distance)) {
      continue;
    }
    if (!placed) {
      gjk_arm_place_part(arm, pair->part, which, &part);
      placed = true;
    }
    status = gjk_within(&pieces.piece, &part, gjk_saturate(distance), NULL, &decision);
    if (status == GJK_ERROR_ITERATION_LIMIT) {
      limited = number < limited ? number : limited;
      status = GJK_OK;
    } else if (status == GJK_OK && decision.yes) {
      *piece = number;
    }
  }
  *yes = *piece != GJK_PARTS_NONE;
  if (status == GJK_OK && !*yes && limited != GJK_PARTS_NONE) {
    *piece = limited;
    status = GJK_ERROR_ITERATION_LIMIT;
  }
  return status;
}

static bool touches_piece(const gjk_arm *arm, const gjk_arm_pair *pair, unsigned which, uint32_t piece,
                          int64_t distance) {
  gjk_parts_room room;
  gjk_collider other, part;
  gjk_decision decision;
  if (gjk_parts_place(&arm->bodies[pair->other], piece, &room, &other) != GJK_OK) {
    return false;
  }
  gjk_arm_place_part(arm, pair->part, which, &part);
  return gjk_within(&other, &part, gjk_saturate(distance), NULL, &decision) != GJK_OK || decision.yes;
}

// Asks one piece. *mine: the piece of this pair that is nearest so far.
static gjk_status ask_piece(const gjk_arm *arm, const gjk_arm_pair *pair, uint32_t number, arm_pieces *pieces,
                            const gjk_collider *part, int64_t *nearest, uint32_t *mine, gjk_status *best,
                            gjk_arm_distance_result *out) {
  gjk_distance_result found;
  gjk_status status = place_piece(pieces, number);
  if (status != GJK_OK || gjk_arm_surely_apart(arm, pair, &pieces->piece, 0, *nearest)) {
    return status;
  }
  status = gjk_distance(&pieces->piece, part, NULL, &found);
  if (status != GJK_OK && status != GJK_ERROR_ITERATION_LIMIT) {
    return status;  // not reached: both are posed
  }
  if (found.lower < *nearest || (found.lower == *nearest && *mine != GJK_PARTS_NONE && number < *mine)) {
    *nearest = found.lower;
    *mine = number;
    *best = status;
    gjk_arm_name(pair, number, &out->pair);
    gjk_copy(&out->distance, &found, sizeof found);
    out->outside = arm->outside;
  }
  return GJK_OK;
}

// Grown by a distance, a region holds all pieces that gjk_distance reports within it: to 2^-28 of it where it is far.
static void grow_to_nearest(arm_pieces *pieces, int64_t nearest) {
  gjk_region_grow(&pieces->region, nearest + gjk_sar64(nearest, 26) + GJK_ARM_SLACK_MAX);
}

static gjk_status nearest_in_body(const gjk_arm *arm, const gjk_arm_pair *pair, int64_t *nearest, gjk_status *best,
                                  gjk_arm_distance_result *out) {
  arm_pieces pieces;
  gjk_collider part;
  bool any;
  uint32_t number, mine = GJK_PARTS_NONE;
  int64_t before = *nearest;
  gjk_status status = arm_open(arm, pair, 0, 0, before + gjk_sar64(before, 26) + GJK_ARM_SLACK_MAX, &pieces, &any);
  if (status != GJK_OK || !any) {
    return status;
  }
  gjk_arm_place_part(arm, pair->part, 0, &part);
  const uint32_t guess = pieces.frame.parts->type->guess(pieces.frame.parts->data, &pieces.region);
  if (place_piece(&pieces, guess) == GJK_OK) {  // a field of holes alone has none
    status = ask_piece(arm, pair, guess, &pieces, &part, nearest, &mine, best, out);
  }
  grow_to_nearest(&pieces, *nearest);
  while (status == GJK_OK && gjk_parts_next(&pieces.frame, &pieces.region, &pieces.walk, &number)) {
    if (number != guess) {
      before = *nearest;
      status = ask_piece(arm, pair, number, &pieces, &part, nearest, &mine, best, out);
      if (*nearest < before) {
        grow_to_nearest(&pieces, *nearest);
      }
    }
  }
  return status;
}

// Is a piece apart by more than gap and off along the direction of a proof?
static bool check_piece(const gjk_arm *arm, const gjk_arm_pair *pair, const gjk_arm_proof *proof, int64_t off,
                        int64_t gap, arm_pieces *pieces) {
  gjk_arm_view view;
  int64_t found;
  if (proof->piece >= gjk_parts_count(pieces->frame.parts) || !gjk_arm_is_direction(&proof->direction) ||
      place_piece(pieces, proof->piece) != GJK_OK) {
    return false;
  }
  gjk_arm_look(arm, pair, &pieces->piece, 0, 1, &view);
  return gjk_arm_gap(&view, &proof->direction, &found) && found > gjk_shl64(arm->setup.margin + off, 30) &&
         gjk_sar64(found, 30) - off >= gap;
}

static uint32_t check_pieces(const gjk_arm *arm, const gjk_arm_proof *proofs, uint32_t count, int64_t bend,
                             int64_t gap) {
  gjk_arm_pair *pair = &arm->memory.pairs[proofs->pair];
  const int64_t off = bend + pair->slack;
  arm_pieces pieces;
  bool any;
  uint32_t wanted, used = 0;
  if (arm_open(arm, pair, 0, 1, gap + off, &pieces, &any) != GJK_OK) {
    return 0;
  }
  bool more = next_piece(&pieces, any, &wanted);
  for (; used < count && proofs[used].pair == proofs->pair && proofs[used].from == proofs->from &&
         proofs[used].to == proofs->to;
       used++) {
    const gjk_arm_proof *proof = &proofs[used];
    if (proof->piece == GJK_PARTS_NONE) {
      pair->done = (uint32_t)proof->to >> (30 - GJK_ARM_DEPTH_MAX);
      return more ? 0 : used + 1;
    }
    if (!check_piece(arm, pair, proof, off, gap, &pieces)) {
      return 0;
    }
    // Pieces come in the order of the walk; those that need no proof here may have one.
    more = more && proof->piece == wanted ? next_piece(&pieces, any, &wanted) : more;
  }
  return used;
}

static const gjk_arm_body_class class_of_bodies = {.span = span_of_body,
                                                   .near = near_body,
                                                   .touches = touches_piece,
                                                   .nearest = nearest_in_body,
                                                   .check = check_pieces};

gjk_status gjk_arm_bodies(gjk_arm *arm, const gjk_parts *bodies, uint16_t count) {
  if (arm == NULL || (bodies == NULL && count > 0)) {
    return GJK_ERROR_NULL;
  }
  if (!gjk_arm_is_ready(arm)) {
    return GJK_ERROR_UNINITIALISED;
  }
  for (unsigned i = 0; i < count; i++) {
    gjk_parts_frame frame;
    const gjk_status status = gjk_parts_frame_set(&frame, &bodies[i]);
    if (status != GJK_OK) {
      return status;
    }
  }
  if (!gjk_arm_list(arm, arm->obstacle_count, count)) {
    return GJK_ERROR_CAPACITY;
  }
  arm->bodies = bodies;
  arm->type = &class_of_bodies;
  return GJK_OK;
}
