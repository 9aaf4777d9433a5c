// The search for the part that is met first on a straight way.
//
// 1. The region is what B's box covers on its way against A, grown by the margin and by how early a fraction may be.
// 2. Cast each part in it. The way ends at the first hit so far.
// 3. Where curved parts have reached their ceiling, go through what is left of the way again. Of those that do so there, the
//    one that is free for the shortest part of the way is reported, if that is less than the first hit's. What is left of
//    the way depends on that hit alone, so the walk's order does not matter.
#include "gjk_parts_first.h"

#include "../arith/gjk_memory.h"

void gjk_parts_first_start(gjk_parts_first *f) {
  f->best = 0;
  f->part = GJK_PARTS_NONE;
  f->of_b = GJK_PARTS_NONE;
  f->status = GJK_OK;
  f->limited = false;
}

// x + way, and whether it stays within int32.
static gjk_q16 carried(gjk_q16 x, int64_t way) {
  return gjk_saturate(x + way);
}

static void carry_point(const gjk_vec3 *from, const gjk_long3 *way, gjk_vec3 *to) {
  to->x = carried(from->x, way->x);
  to->y = carried(from->y, way->y);
  to->z = carried(from->z, way->z);
}

// Is x out of reach for a part of a way, all of which are below 2^32?
static bool too_long(int64_t x) {
  return gjk_magnitude64(x) >> 32 != 0;
}

static bool leaves_int32(gjk_q16 centre, int64_t way) {
  const int64_t end = centre + way;
  return end < INT32_MIN || end > INT32_MAX;
}

// Step 1. RANGE: as of gjk_cast.
static gjk_status start_region(gjk_region *region, const gjk_parts_frame *frame, const gjk_parts_cast_question *of) {
  gjk_aabb box;
  const gjk_vec3 *from = of->b != NULL ? &of->b->position : of->from, *to = of->to != NULL ? of->to : from;
  const gjk_long3 of_b = {(int64_t)to->x - from->x, (int64_t)to->y - from->y, (int64_t)to->z - from->z};
  const gjk_long3 way = {of_b.x - of->way_a.x, of_b.y - of->way_a.y, of_b.z - of->way_a.z};
  const gjk_vec3 *centre = of->b != NULL ? &of->b->centre : from;
  if (too_long(way.x) || too_long(way.y) || too_long(way.z) || leaves_int32(centre->x, of_b.x) ||
      leaves_int32(centre->y, of_b.y) || leaves_int32(centre->z, of_b.z)) {
    return GJK_ERROR_RANGE;
  }
  if (of->b != NULL) {
    (void)gjk_collider_aabb(of->b, &box);  // posed, so it cannot fail
  } else {
    box.lower = *from;
    box.upper = *from;
  }
  gjk_region_start(region, frame->rows, &frame->parts->pose.position, &box, &way);
  gjk_region_grow(region, (int64_t)of->margin + GJK_PARTS_EARLY);
  return GJK_OK;
}

// Leaves of the region what may be met no later than the best so far. A fraction is rounded down: one step more.
static void cut_region(gjk_region *region, const gjk_parts_first *f) {
  if (f->part != GJK_PARTS_NONE) {
    const gjk_q30 fraction = f->result[f->best].fraction;
    gjk_region_cut(region, fraction < GJK_Q30_ONE ? fraction + 1 : fraction);
  }
}

// Casts one part. rest_a becomes the position of A's pose.
static gjk_status cast_part(const gjk_parts_frame *frame, const gjk_parts_cast_question *of, uint32_t part,
                            gjk_cast_result *out) {
  gjk_parts_room room;
  gjk_collider c;
  gjk_vec3 to_a;
  gjk_status status = gjk_parts_place_in(frame, part, &room, &c);
  if (status != GJK_OK) {
    return status;
  }
  if (of->b == NULL) {
    status = gjk_cast_ray(&c, of->from, of->to, out);
  } else {
    carry_point(&c.position, &of->way_a, &to_a);  // A's reach allows it
    const gjk_cast_path path = {of->moves_a ? &to_a : NULL, of->to, of->margin};
    status = gjk_cast(&c, of->b, &path, out);
  }
  if (status == GJK_ERROR_ITERATION_LIMIT || (status == GJK_OK && out->hit)) {  // set by no other status
    const gjk_vec3 *at = &frame->parts->pose.position;
    const gjk_long3 back = {(int64_t)at->x - c.position.x, (int64_t)at->y - c.position.y,
                            (int64_t)at->z - c.position.z};
    carry_point(&out->rest_a, &back, &out->rest_a);
  }
  return status;
}

// Does a trial come before the best so far? A part that is only known to be free up to a fraction has to be met before. Of
// parts that are met at the start one that overlaps there tells more.
static bool is_sooner(const gjk_parts_first *f, const gjk_cast_result *trial, gjk_status status, uint32_t part,
                      uint32_t of_b) {
  const gjk_cast_result *best = &f->result[f->best];
  if (f->part == GJK_PARTS_NONE) {
    return true;
  }
  if (trial->fraction != best->fraction) {
    return trial->fraction < best->fraction;
  }
  if (status != f->status) {
    return status == GJK_OK;
  }
  if (status == GJK_OK && trial->inside != best->inside) {
    return trial->inside;
  }
  return of_b != f->of_b ? of_b < f->of_b : part < f->part;
}

gjk_status gjk_parts_first_ask(gjk_parts_first *f, const gjk_parts_frame *frame, const gjk_parts_cast_question *of,
                               bool bound) {
  gjk_region region;
  gjk_parts_walk walk;
  uint32_t part;
  gjk_status status = start_region(&region, frame, of);
  if (status != GJK_OK) {
    return status;
  }
  cut_region(&region, f);
  gjk_parts_walk_start(&walk);
  while (gjk_parts_next(frame, &region, &walk, &part)) {  // ends: each part comes once
    gjk_cast_result *trial = &f->result[1 - f->best];
    status = cast_part(frame, of, part, trial);
    if (status != GJK_OK && status != GJK_ERROR_ITERATION_LIMIT) {
      return status;
    }
    const bool limited = status != GJK_OK;
    f->limited = f->limited || limited;
    if (limited == bound && (limited || trial->hit) && is_sooner(f, trial, status, part, of->number)) {
      f->best = 1 - f->best;
      f->part = part;
      f->of_b = of->number;
      f->status = status;
      if (!bound) {
        cut_region(&region, f);
      }
    }
  }
  return GJK_OK;
}

gjk_status gjk_parts_first_report(const gjk_parts_first *f, gjk_cast_result *out) {
  if (f->part == GJK_PARTS_NONE) {
    out->hit = false;
    out->iterations = 0;
    out->certificate.proof = GJK_CAST_PROOF_NONE;
    out->certificate.count = 0;
  } else {
    gjk_copy(out, &f->result[f->best], sizeof *out);
  }
  return f->status;
}
