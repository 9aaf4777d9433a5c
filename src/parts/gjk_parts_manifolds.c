// The contacts of bodies of many parts, put together by their normals: few manifolds, whatever the number of parts.
//
// 1. Ask each part whose box is near for its contacts, the lowest numbers first. A surface gives those that it has as a whole.
// 2. Its manifold joins the one whose normal is nearest to its own, if that is within the angle. Otherwise it begins
//    another one, in the place of the one that is least deep where there is no room.
// 3. Contacts in one place count once: neighbours share the points of the edge between them. Ids are made different.
// 4. Of more contacts than a manifold holds gjk_reduce keeps some; in the end of each, as many as are wanted.
// 5. Order the manifolds by their depth.
//
// Steps 2 to 4 depend on which part comes first, and walks have orders of their own. So step 1 takes the parts in the
// order of their numbers, NUMBERS_AT_ONCE at a time: what is kept depends on shapes, poses and numbers alone.
#include "../arith/gjk_memory.h"
#include "../contact/gjk_reduce.h"
#include "gjk_parts_both.h"
#include "gjk_parts_class.h"

// The cosine of 3 degrees, Q30.
#define NORMALS_ALIKE INT32_C(1072270337)

// Contacts so near along each axis are in one place, LSB: points of both neighbours are within 4 of the edge.
#define ONE_PLACE 8

// By how much the deeper one of two in one place has to be deeper to take it, LSB: more than rounding.
#define PLACE_DEEPER 4

// How many numbers of parts a walk puts in order. Of more parts, another walk finds the next ones.
#define NUMBERS_AT_ONCE 32

typedef struct joined_contacts {
  gjk_manifold *manifolds;
  unsigned capacity, count, most;
  gjk_q16 margin;
  const gjk_workspace *workspace;
  gjk_status status;  // OK, CAPACITY or ITERATION_LIMIT, the worst so far
} joined_contacts;

static gjk_q16 least_gap_of(const gjk_manifold *m) {
  gjk_q16 least = m->contact[0].distance;
  for (unsigned i = 1; i < m->count; i++) {
    least = m->contact[i].distance < least ? m->contact[i].distance : least;
  }
  return least;
}

// The product of two unit vectors, Q30: |each| <= 2^30 (1 + 2^-28), so the sum is below 2^61.
static int64_t cosine_of(const gjk_unit3 *a, const gjk_unit3 *b) {
  return gjk_sar64(gjk_mac32(gjk_mac32(gjk_mul32(a->x, b->x), a->y, b->y), a->z, b->z), 30);
}

// Step 2: the manifold that it joins, or capacity.
static unsigned find_alike(const joined_contacts *j, const gjk_manifold *m) {
  int64_t best = NORMALS_ALIKE - 1;
  unsigned found = j->capacity;
  for (unsigned i = 0; i < j->count; i++) {
    const int64_t cosine = cosine_of(&j->manifolds[i].normal, &m->normal);
    if (cosine > best) {
      best = cosine;
      found = i;
    }
  }
  return found;
}

static bool is_near_along(gjk_q16 a, gjk_q16 b) {
  const int64_t apart = (int64_t)a - b;
  return apart <= ONE_PLACE && apart >= -ONE_PLACE;
}

static bool is_same_place(const gjk_contact *a, const gjk_contact *b) {
  return is_near_along(a->point_a.x, b->point_a.x) && is_near_along(a->point_a.y, b->point_a.y) &&
         is_near_along(a->point_a.z, b->point_a.z);
}

static bool has_id(const gjk_candidates *c, uint16_t id) {
  for (unsigned i = 0; i < c->count; i++) {
    if (c->candidate[i].id == id) {
      return true;
    }
  }
  return false;
}

// Step 3. Pre: there are less than GJK_CANDIDATES_MAX.
static void add_contact(gjk_candidates *c, const gjk_contact *contact) {
  for (unsigned i = 0; i < c->count; i++) {
    gjk_contact *other = &c->candidate[i];
    if (is_same_place(other, contact)) {
      const int64_t deeper = (int64_t)other->distance - contact->distance;
      if (deeper > PLACE_DEEPER || (deeper >= -PLACE_DEEPER && contact->id < other->id)) {
        const uint16_t id = contact->id < other->id && !has_id(c, contact->id) ? contact->id : other->id;
        gjk_copy(other, contact, sizeof *other);
        other->id = id;
      }
      return;
    }
  }
  gjk_contact *added = &c->candidate[c->count];
  gjk_copy(added, contact, sizeof *added);
  while (has_id(c, added->id)) {  // ends: there are fewer contacts than ids
    added->id = (uint16_t)(added->id + 1u);
  }
  c->count++;
}

// Step 4: writes at most `most` of the contacts.
static void keep_contacts(const gjk_candidates *c, unsigned most, gjk_manifold *out) {
  uint8_t keep[GJK_CONTACTS_MAX];
  const bool reduced = c->count > most;
  if (reduced) {
    gjk_reduce(c, &out->normal, most, keep);
  }
  out->count = (uint8_t)(reduced ? most : c->count);
  for (unsigned i = 0; i < out->count; i++) {
    gjk_copy(&out->contact[i], &c->candidate[reduced ? keep[i] : i], sizeof out->contact[i]);
  }
}

static void add_all(gjk_candidates *c, const gjk_manifold *m) {
  for (unsigned i = 0; i < m->count; i++) {
    add_contact(c, &m->contact[i]);
  }
}

// The deeper one gives the normal and the features.
GJK_OUT_OF_LINE static void join_manifold(gjk_manifold *to, const gjk_manifold *m) {
  gjk_candidates c;
  c.count = 0;
  add_all(&c, to);
  add_all(&c, m);
  if (least_gap_of(m) < least_gap_of(to)) {
    to->normal = m->normal;
    to->feature_a = m->feature_a;
    to->feature_b = m->feature_b;
  }
  keep_contacts(&c, GJK_CONTACTS_MAX, to);
}

GJK_OUT_OF_LINE static void reduce_manifold(gjk_manifold *m, unsigned most) {
  gjk_candidates c;
  c.count = 0;
  add_all(&c, m);
  keep_contacts(&c, most, m);
}

// Step 2.
static void take_manifold(joined_contacts *j, const gjk_manifold *m) {
  unsigned at = find_alike(j, m);
  if (at < j->capacity) {
    join_manifold(&j->manifolds[at], m);
    return;
  }
  at = j->count;
  if (at == j->capacity) {
    at = 0;
    for (unsigned i = 1; i < j->count; i++) {
      at = least_gap_of(&j->manifolds[i]) > least_gap_of(&j->manifolds[at]) ? i : at;
    }
    if (least_gap_of(m) >= least_gap_of(&j->manifolds[at])) {
      return;
    }
  } else {
    j->count++;
  }
  gjk_copy(&j->manifolds[at], m, sizeof *m);
}

// What of an id tells a part from others: the numbers of both parts, mixed to 16 bits. 0 for numbers 0.
static uint16_t mark_of(uint32_t part, uint32_t of_b) {
  const uint32_t mixed = part * UINT32_C(0x9E3779B1) ^ of_b * UINT32_C(0x85EBCA6B);
  return (uint16_t)(mixed >> 16 ^ (mixed & 0xFFFFu));
}

// Numbers of parts, ascending.
typedef struct part_numbers {
  uint32_t number[NUMBERS_AT_ONCE];
  unsigned count;
} part_numbers;

// Step 1: the lowest numbers from `from` on of parts that the region meets. Returns whether there are more.
static bool find_numbers(const gjk_parts_frame *frame, const gjk_region *region, uint32_t from, part_numbers *out) {
  gjk_parts_walk walk;
  uint32_t number;
  bool more = false;
  out->count = 0;
  gjk_parts_walk_start(&walk);
  while (gjk_parts_next(frame, region, &walk, &number)) {  // ends: each part comes once
    if (number < from) {
      continue;
    }
    const bool full = out->count == NUMBERS_AT_ONCE;
    more = more || full;
    if (full && number > out->number[NUMBERS_AT_ONCE - 1]) {
      continue;
    }
    unsigned at = full ? NUMBERS_AT_ONCE - 1 : out->count++;
    for (; at > 0 && out->number[at - 1] > number; at--) {
      out->number[at] = out->number[at - 1];
    }
    out->number[at] = number;
  }
  return more;
}

// Steps 1 to 4 for one part.
static gjk_status join_part(const gjk_parts_frame *frame, uint32_t number, const gjk_collider *b, uint32_t of_b,
                            gjk_cache *cache, joined_contacts *j) {
  gjk_parts_room room;
  gjk_collider c;
  gjk_manifold m;
  gjk_status status;
  const gjk_parts_class *type = frame->parts->type;
  m.count = 0;
  if (type->meet != NULL) {
    status = type->meet(frame, number, b, j->margin, GJK_CONTACTS_MAX, cache, j->workspace, &m);
  } else {
    status = gjk_parts_place_in(frame, number, &room, &c);
    status = status == GJK_OK ? gjk_contacts(&c, b, j->margin, GJK_CONTACTS_MAX, NULL, j->workspace, &m) : status;
  }
  if (status != GJK_OK && status != GJK_ERROR_CAPACITY && status != GJK_ERROR_ITERATION_LIMIT) {
    return status;
  }
  j->status = status == GJK_OK || j->status == GJK_ERROR_ITERATION_LIMIT ? j->status : status;
  if (status == GJK_ERROR_ITERATION_LIMIT || m.count == 0) {
    return GJK_OK;
  }
  const uint16_t mark = mark_of(number, of_b);
  for (unsigned i = 0; i < m.count; i++) {
    m.contact[i].id = (uint16_t)(m.contact[i].id ^ mark);
  }
  take_manifold(j, &m);
  return GJK_OK;
}

// For one collider. Pre: the region is that of b.
static gjk_status join_parts(const gjk_parts_frame *frame, gjk_region *region, const gjk_collider *b, uint32_t of_b,
                             joined_contacts *j) {
  part_numbers n;
  gjk_cache cache;
  uint32_t from = 0;
  bool more = true;
  gjk_status status = GJK_OK;
  gjk_zero(&cache, sizeof cache);
  gjk_region_grow(region, j->margin);
  while (more && status == GJK_OK) {  // ends: from rises
    more = find_numbers(frame, region, from, &n);
    for (unsigned i = 0; i < n.count && status == GJK_OK; i++) {
      status = join_part(frame, n.number[i], b, of_b, &cache, j);
      from = n.number[i] + 1;  // numbers are below 2^32 - 1
    }
  }
  return status;
}

// Steps 4 and 5.
static void finish_manifolds(joined_contacts *j) {
  for (unsigned i = 0; i < j->count; i++) {
    if (j->manifolds[i].count > j->most) {
      reduce_manifold(&j->manifolds[i], j->most);
    }
    for (unsigned k = i; k > 0 && least_gap_of(&j->manifolds[k]) < least_gap_of(&j->manifolds[k - 1]); k--) {
      gjk_manifold between;
      gjk_copy(&between, &j->manifolds[k], sizeof between);
      gjk_copy(&j->manifolds[k], &j->manifolds[k - 1], sizeof between);
      gjk_copy(&j->manifolds[k - 1], &between, sizeof between);
    }
  }
}

static gjk_status check_manifolds(const joined_contacts *j, const unsigned *count) {
  if (count == NULL || j->manifolds == NULL) {
    return GJK_ERROR_NULL;
  }
  if (j->margin < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  return j->most < 1 || j->most > GJK_CONTACTS_MAX || j->capacity < 1 || j->capacity > GJK_PARTS_MANIFOLDS_MAX ||
                 j->margin > GJK_RADIUS_MAX
             ? GJK_ERROR_RANGE
             : GJK_OK;
}

static gjk_status report_manifolds(joined_contacts *j, gjk_status status, unsigned *count) {
  if (status != GJK_OK) {
    return status;
  }
  finish_manifolds(j);
  *count = j->count;
  return j->status;
}

gjk_status gjk_parts_manifolds(const gjk_parts *a, const gjk_collider *b, gjk_q16 margin, unsigned most,
                               const gjk_workspace *workspace, gjk_manifold *out, unsigned capacity, unsigned *count) {
  gjk_parts_frame frame;
  gjk_region region;
  joined_contacts j = {out, capacity, 0, most, margin, workspace, GJK_OK};
  gjk_status status = check_manifolds(&j, count);
  status = status == GJK_OK ? gjk_parts_open(&frame, &region, a, b) : status;
  status = status == GJK_OK ? join_parts(&frame, &region, b, 0, &j) : status;
  return report_manifolds(&j, status, count);
}

gjk_status gjk_parts_both_manifolds(const gjk_parts *a, const gjk_parts *b, gjk_q16 margin, unsigned most,
                                    const gjk_workspace *workspace, gjk_manifold *out, unsigned capacity,
                                    unsigned *count) {
  gjk_parts_frame frame[2];
  gjk_parts_room room;
  gjk_collider c;
  gjk_region region;
  joined_contacts j = {out, capacity, 0, most, margin, workspace, GJK_OK};
  gjk_status status = check_manifolds(&j, count);
  status = status == GJK_OK ? gjk_parts_both_open(frame, a, b) : status;
  const uint32_t parts = status == GJK_OK ? gjk_parts_count(b) : 0;
  for (uint32_t i = 0; i < parts && status == GJK_OK; i++) {
    status = gjk_parts_both_part(frame, i, &room, &c, &region);
    if (gjk_parts_both_lacks(&status)) {
      continue;
    }
    status = status == GJK_OK ? join_parts(&frame[0], &region, &c, i, &j) : status;
  }
  return report_manifolds(&j, status, count);
}
