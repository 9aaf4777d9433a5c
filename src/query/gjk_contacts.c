// The contact manifold: the region that two shapes share where they meet, as a few pairs of points.
//
//   1. Ask gjk_signed_distance for the normal, the distance and the nearest points. Beyond margin there is no contact.
//      Where boxes meet with a face, the points are asked for only if step 4 needs them, which it rarely does.
//   2. Find the polygon with which each shape meets the normal: a face, an edge or a corner (gjk_contact_polygon.c).
//   3. Clip the two polygons: the corners of the region that they share are the candidates (gjk_clip.c).
//   4. Admit the nearest points of step 1 unless a candidate is as near.
//   5. Keep at most `most` candidates (gjk_reduce.c).
//
// What is rounded:
//   step 1   the points, each within 1 LSB of its shape; a depth, up to the next LSB
//   step 2   the move of a face or edge by its convex radius: below 3 LSB
//   step 3   points of edges, points across from a corner, and gaps: to the nearest LSB
// Together a contact point is within 4 LSB of its shape; tests/check/unit/test_contacts.c finds none beyond 3.
#include "gjk/contacts.h"

#include "../contact/gjk_reduce.h"
#include "gjk_distance.h"
#include "gjk_manifold.h"

// Centres farther apart than this along an axis skip steps 2 and 3: the nearest points are the one contact. Otherwise
// coordinates relative to A's centre are below 2^29 + 2^28.
#define REACH (INT32_C(1) << 29)

// Step 4 admits the nearest points when every candidate is farther by more than this, LSB. There are candidates only
// within REACH, so distance + SLACK fits.
#define SLACK 2

GJK_ONE_COPY static bool is_coordinate_within_reach(int32_t a, int32_t b) {
  const int64_t x = (int64_t)a - b;
  return x <= REACH && x >= -REACH;
}

static bool is_within_reach(const gjk_vec3 *a, const gjk_vec3 *b) {
  return is_coordinate_within_reach(a->x, b->x) && is_coordinate_within_reach(a->y, b->y) &&
         is_coordinate_within_reach(a->z, b->z);
}

// Steps 2 and 3. Also sets out's features, and without candidates the id of the one that step 4 admits.
static void clip_polygons(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin, gjk_candidates *candidates,
                          gjk_manifold *out) {
  const gjk_vec3 origin = {0, 0, 0}, to_b = {out->normal.x, out->normal.y, out->normal.z}, to_a = gjk_negate(to_b);
  const gjk_vec3 delta = gjk_sub(b->centre, a->centre);
  //@ assert delta.x >= -REACH && delta.x <= REACH;
  //@ assert delta.y >= -REACH && delta.y <= REACH;
  //@ assert delta.z >= -REACH && delta.z <= REACH;
  gjk_polygon of_a, of_b;
  gjk_contact_polygon(a, &origin, &to_b, &of_a);
  gjk_contact_polygon(b, &delta, &to_a, &of_b);
  out->feature_a = of_a.feature;
  out->feature_b = of_b.feature;
  if (of_a.count > 1 && of_b.count > 1) {
    gjk_clip(&of_a, &of_b, &a->centre, margin, candidates);
  }
  if (candidates->count == 0) {
    candidates->candidate[0].id = gjk_contact_id(gjk_feature_of(&of_a), gjk_feature_of(&of_b));
  }
}

// The squared distance of two points, in units of 16 LSB^2.
//   points   less than 2^31 apart:   |v| < 2^29 + 2, the square below 2^61
static int64_t squared_between(const gjk_vec3 *p, const gjk_vec3 *q) {
  const int64_t x = (int64_t)p->x - q->x, y = (int64_t)p->y - q->y, z = (int64_t)p->z - q->z;
  const gjk_vec3 v = {(int32_t)gjk_sar64(x, 2), (int32_t)gjk_sar64(y, 2), (int32_t)gjk_sar64(z, 2)};
  return gjk_dot(&v, &v);
}

// Step 4. The nearest points may lie beside the flat parts, where a shape is curved or has a convex radius. Those of
// crossing edges are the only contact. They replace the candidate that is closest to them.
static void admit_nearest(const gjk_distance_result *nearest, gjk_candidates *candidates) {
  unsigned next = 0;
  int64_t least = INT64_MAX;
  // Points have no candidates.
  for (unsigned i = 0; GJK_SHAPES >= GJK_SHAPES_ROUND && i < candidates->count; i++) {
    const gjk_contact *candidate = &candidates->candidate[i];
    if (candidate->distance <= nearest->distance + SLACK) {
      return;
    }
    const int64_t squared = squared_between(&candidate->point_a, &nearest->point_a) +
                            squared_between(&candidate->point_b, &nearest->point_b);
    if (squared < least) {
      least = squared;
      next = i;
    }
  }
  gjk_contact *candidate = &candidates->candidate[next];
  candidate->point_a = nearest->point_a;
  candidate->point_b = nearest->point_b;
  candidate->distance = nearest->distance;
  candidates->count = candidates->count == 0 ? 1 : candidates->count;
}

void gjk_manifold_find(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin, gjk_candidates *candidates,
                       gjk_manifold *out) {
  candidates->count = 0;
  candidates->candidate[0].id = gjk_contact_id(GJK_FEATURE_CORNER, GJK_FEATURE_CORNER);
  if (GJK_SHAPES >= GJK_SHAPES_ROUND && is_within_reach(&a->centre, &b->centre)) {
    clip_polygons(a, b, margin, candidates, out);
  }
}

void gjk_manifold_keep(gjk_candidates *candidates, const gjk_distance_result *nearest, unsigned most,
                       gjk_manifold *out) {
  uint8_t keep[GJK_CONTACTS_MAX];
  if (nearest != NULL) {
    admit_nearest(nearest, candidates);
  }
  const bool reduced = GJK_SHAPES >= GJK_SHAPES_ROUND && candidates->count > most;
  if (reduced) {
    gjk_reduce(candidates, &out->normal, most, keep);
  }
  out->count = (uint8_t)(reduced ? most : candidates->count);
  for (unsigned i = 0; i < out->count; i++) {
    out->contact[i] = candidates->candidate[reduced ? keep[i] : i];
  }
}

// Is a candidate as near as the nearest points?
static bool is_nearest_known(const gjk_candidates *candidates, gjk_q16 distance) {
  for (unsigned i = 0; i < candidates->count; i++) {
    if (candidates->candidate[i].distance <= distance + SLACK) {
      return true;
    }
  }
  return false;
}

// Steps 2 to 5. False: step 4 needs the nearest points, and they are not set.
GJK_OUT_OF_LINE static bool find_contacts(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin, unsigned most,
                                          const gjk_distance_result *nearest, bool points, gjk_manifold *out) {
  gjk_candidates candidates;
  gjk_manifold_find(a, b, margin, &candidates, out);
  if (!GJK_SMALL && !points && !is_nearest_known(&candidates, nearest->distance)) {
    return false;
  }
  gjk_manifold_keep(&candidates, GJK_SMALL || points ? nearest : NULL, most, out);
  return true;
}

gjk_status gjk_contacts(const gjk_collider *a, const gjk_collider *b, gjk_q16 margin, unsigned most, gjk_cache *cache,
                        const gjk_workspace *workspace, gjk_manifold *out) {
  gjk_status status = gjk_check_pair(a, b, out);
  if (status != GJK_OK || margin < 0 || most < 1 || most > GJK_CONTACTS_MAX) {
    return status != GJK_OK ? status : margin < 0 ? GJK_ERROR_NEGATIVE : GJK_ERROR_RANGE;
  }
  gjk_distance_result nearest;
  bool points = false;
  status = gjk_signed_distance_along(a, b, cache, workspace, &points, &nearest);
  if (status != GJK_OK && status != GJK_ERROR_CAPACITY) {
    return status;
  }
  out->normal = nearest.normal;
  out->feature_a = 0;
  out->feature_b = 0;
  out->count = 0;
  if (nearest.distance <= margin && !find_contacts(a, b, margin, most, &nearest, points, out) &&
      GJK_SHAPES >= GJK_SHAPES_BOXES && !GJK_SMALL) {
    status = gjk_signed_distance(a, b, cache, workspace, &nearest);
    (void)find_contacts(a, b, margin, most, &nearest, true, out);
  }
  return status;
}
