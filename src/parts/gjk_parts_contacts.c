// The contacts of bodies of many parts: a manifold of each part that touches.
#include "../arith/gjk_memory.h"
#include "gjk_parts_both.h"
#include "gjk_parts_class.h"

// What a query has found: the manifolds of the least numbers, in order, and how many there are.
typedef struct collected_contacts {
  gjk_parts_manifold *manifolds;
  uint32_t capacity, count;
  gjk_status status;  // OK, CAPACITY or ITERATION_LIMIT, the worst so far
} collected_contacts;

// ITERATION_LIMIT says more than CAPACITY does: contacts are missing.
GJK_ONE_COPY static void note_status(collected_contacts *c, gjk_status status) {
  if (status != GJK_OK && c->status != GJK_ERROR_ITERATION_LIMIT) {
    c->status = status;
  }
}

static bool comes_later(const gjk_parts_manifold *m, const gjk_parts_manifold *other) {
  return m->part_of_b != other->part_of_b ? m->part_of_b > other->part_of_b : m->part > other->part;
}

// Puts a manifold in its place. One that no longer fits is dropped: the last in order.
static void insert_manifold(collected_contacts *c, const gjk_parts_manifold *m) {
  uint32_t at = c->count < c->capacity ? c->count : c->capacity;
  c->count++;
  if (at == c->capacity) {
    note_status(c, GJK_ERROR_CAPACITY);
    if (at == 0 || !comes_later(&c->manifolds[at - 1], m)) {
      return;
    }
    at--;
  }
  while (at > 0 && comes_later(&c->manifolds[at - 1], m)) {  // ends: at falls
    gjk_copy(&c->manifolds[at], &c->manifolds[at - 1], sizeof *m);
    at--;
  }
  gjk_copy(&c->manifolds[at], m, sizeof *m);
}

// What is asked of each part.
typedef struct contacts_question {
  gjk_q16 margin;
  unsigned most;
  const gjk_workspace *workspace;
} contacts_question;

// Asks the parts whose boxes are within the margin of B's. Pre: the region is B's.
static gjk_status collect_contacts(const gjk_parts_frame *frame, gjk_region *region, const gjk_collider *b,
                                   uint32_t number, const contacts_question *of, collected_contacts *out) {
  gjk_parts_walk walk;
  gjk_parts_room room;
  gjk_collider c;
  gjk_parts_manifold found;
  const gjk_parts_class *type = frame->parts->type;
  found.part_of_b = number;
  gjk_region_grow(region, of->margin);
  gjk_parts_walk_start(&walk);
  while (gjk_parts_next(frame, region, &walk, &found.part)) {  // ends: each part comes once
    gjk_status status = gjk_parts_place_in(frame, found.part, &room, &c);
    if (status != GJK_OK) {
      return status;
    }
    status = gjk_contacts(&c, b, of->margin, of->most, NULL, of->workspace, &found.manifold);
    if (status != GJK_OK && status != GJK_ERROR_CAPACITY && status != GJK_ERROR_ITERATION_LIMIT) {
      return status;  // not reached: both are posed
    }
    if (status != GJK_ERROR_ITERATION_LIMIT &&
        (found.manifold.count == 0 || (type->settle != NULL && !type->settle(frame, found.part, b, &found.manifold)))) {
      continue;
    }
    note_status(out, status);
    if (status != GJK_ERROR_ITERATION_LIMIT) {
      insert_manifold(out, &found);
    }
  }
  return GJK_OK;
}

// The arguments of both queries.
static gjk_status check_contacts(const contacts_question *of, const gjk_parts_manifold *manifolds, uint32_t capacity,
                                 const uint32_t *count) {
  if (count == NULL || (manifolds == NULL && capacity > 0)) {
    return GJK_ERROR_NULL;
  }
  if (of->margin < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  return of->most < 1 || of->most > GJK_CONTACTS_MAX ? GJK_ERROR_RANGE : GJK_OK;
}

gjk_status gjk_parts_contacts(const gjk_parts *a, const gjk_collider *b, gjk_q16 margin, unsigned most,
                              const gjk_workspace *workspace, gjk_parts_manifold *manifolds, uint32_t capacity,
                              uint32_t *count) {
  gjk_parts_frame frame;
  gjk_region region;
  const contacts_question of = {margin, most, workspace};
  collected_contacts found = {manifolds, capacity, 0, GJK_OK};
  gjk_status status = check_contacts(&of, manifolds, capacity, count);
  status = status == GJK_OK ? gjk_parts_open(&frame, &region, a, b) : status;
  status = status == GJK_OK ? collect_contacts(&frame, &region, b, 0, &of, &found) : status;
  if (status != GJK_OK) {
    return status;
  }
  *count = found.count;
  return found.status;
}

gjk_status gjk_parts_both_contacts(const gjk_parts *a, const gjk_parts *b, gjk_q16 margin, unsigned most,
                                   const gjk_workspace *workspace, gjk_parts_manifold *manifolds, uint32_t capacity,
                                   uint32_t *count) {
  gjk_parts_frame frame[2];
  gjk_parts_room room;
  gjk_collider c;
  gjk_region region;
  const contacts_question of = {margin, most, workspace};
  collected_contacts found = {manifolds, capacity, 0, GJK_OK};
  gjk_status status = check_contacts(&of, manifolds, capacity, count);
  status = status == GJK_OK ? gjk_parts_both_open(frame, a, b) : status;
  const uint32_t parts = status == GJK_OK ? gjk_parts_count(b) : 0;
  for (uint32_t i = 0; i < parts && status == GJK_OK; i++) {
    status = gjk_parts_both_part(frame, i, &room, &c, &region);
    if (gjk_parts_both_lacks(&status)) {
      continue;
    }
    status = status == GJK_OK ? collect_contacts(&frame[0], &region, &c, i, &of, &found) : status;
  }
  if (status != GJK_OK) {
    return status;
  }
  *count = found.count;
  return found.status;
}
