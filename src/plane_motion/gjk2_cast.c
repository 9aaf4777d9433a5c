// The cast query of the plane: where a shape that moves in a straight line first touches another.
//
//   1. Stop if the bounding circles do not meet on the way.
//   2. Shapes with a radius or margin, and curved ones: gjk2_advance.c.
//   3. Find the edge of A - B that the line of the way enters by, exactly (gjk2_entry.c). There may be none.
//   4. Its place on the way is the quotient of two integers. If it is beyond the end, the way ends before.
//   5. If it is before the start, find where the line leaves A - B: on the way or later, the shapes touch at the start.
//   6. Report the quotient, rounded down, and what follows from it.
#include "gjk2/cast.h"

#include "gjk2_cast_report.h"
#include "gjk2_entry.h"

// Step 5: does the line leave A - B after the start? Otherwise the last edge parts the shapes at the start, and ever more.
static bool plane_cast_leaves_later(gjk2_way *way, gjk2_entry *e) {
  gjk2_way_reverse(way);
  const bool found = gjk2_entry_find(way, e);
  gjk2_way_reverse(way);
  return found && e->along >= 0;
}

static void plane_cast_short(const gjk2_way *way, const gjk2_entry *e, gjk2_cast_result *out) {
  gjk2_cast_miss(way, GJK2_CAST_PROOF_SHORT, out);
  gjk2_copy(&out->certificate.direction, &e->n);
}

// Steps 3 to 6. Pre: two polygons, no radius, a way.
GJK_OUT_OF_LINE static void plane_cast_exact(gjk2_way *way, bool early, gjk2_cast_result *out) {
  gjk2_entry e;
  if (!gjk2_entry_find(way, &e)) {
    gjk2_cast_miss(way, GJK2_CAST_PROOF_BESIDE, out);
    out->certificate.count = 1;
    out->certificate.a[0] = e.p.a.vertex;
    out->certificate.b[0] = e.p.b.vertex;
    return;
  }
  if (e.along >= 0) {
    if (e.along > 0 && (GJK_SHAPES <= GJK_SHAPES_POINTS || !early || !plane_cast_leaves_later(way, &e))) {
      plane_cast_short(way, &e, out);
    } else {
      gjk2_cast_inside(way, NULL, out);
    }
    return;
  }
  gjk2_portion portion = {(uint64_t)-e.along, e.closing, 0, false};
  if (portion.num > portion.den) {
    plane_cast_short(way, &e, out);
    return;
  }
  gjk_divisor divisor = {0, 0};
  gjk2_ratio_set(&divisor, e.closing);
  portion.fraction = gjk2_ratio_by(&divisor, portion.num, portion.den, &portion.exact);
  gjk2_contact_place place = {&e.p, e.count == 2 ? &e.q : &e.p, 0, e.n};
  if (GJK_SHAPES >= GJK_SHAPES_ROUND && e.count == 2) {
    bool exact;
    place.weight = gjk2_ratio_by(&divisor, (uint64_t)-e.side_p, e.closing, &exact);
  }
  gjk2_cast_hit(way, &place, &portion, out);
}

gjk_status gjk2_cast(const gjk2_collider *a, const gjk2_collider *b, const gjk2_cast_path *path,
                     gjk2_cast_result *out) {
  gjk2_way way;
  const gjk_status status = gjk2_way_set(&way, a, b, path, out);
  if (status != GJK_OK) {
    return status;
  }
  bool early, late;
  const int64_t radius = (int64_t)a->shape->convex_radius + b->shape->convex_radius + path->margin;
  if (!gjk2_way_may_meet(&way, radius, &early, &late)) {
    gjk2_cast_miss(&way, GJK2_CAST_PROOF_SPHERES, out);
    return GJK_OK;
  }
  if (radius > 0 || (way.t.x | way.t.y) == 0 || gjk2_is_curved(a->shape) || gjk2_is_curved(b->shape)) {
    return gjk2_advance(&way, path->margin, early, late, out);
  }
  plane_cast_exact(&way, early, out);
  return GJK_OK;
}
