// The contacts of a body with one triangle of a surface, by normals that the surface has there.
//
//   1. Set the triangle's plane, seen from the side of the body. If more than half of the body's height along the
//      normal is behind the plane, there are no contacts, unless the surface has two sides.
//   2. Clip triangle and body along the plane's normal. If a deepest point of the body lies over the triangle, and the body
//      has not come around it, the contacts found are the answer.
//   3. Otherwise ask for the signed distance, and for the edge or corner with which the triangle meets its normal.
//   4. The surface has that normal there if every triangle at the edge or corner lies behind the plane across it (the
//      polar cone of the surface). Then the contacts along it are the answer.
//   5. If not, and a triangle across the normal keeps the body farther out than this one does, that triangle answers
//      for both. Otherwise the contacts of step 2 stay, if there are any: they have the triangle's own normal.
//   6. If there are none, the body may get none from any triangle. A body that touches the triangle, or is curved and
//      so has rough normals, lies over neither side in the groove of a concave edge. A body apart may lie over neither
//      side of an edge that is flat up to the rounding of its corners. Unless the body lies over a triangle at that
//      edge or corner, the nearest points of step 3 are taken with the triangle's normal.
#include "../arith/gjk_unit.h"
#include "../query/gjk_manifold.h"
#include "gjk/intersect.h"
#include "gjk/mesh.h"
#include "gjk_surface_face.h"

// A corner this far beyond the plane across a normal still counts as in that plane. The slack is Q30, for each LSB of
// the corner's distance |x| + |y| + |z|. Normals are reported within 2^-28, and rounded outward; those of curved shapes
// are rough.
#define NORMAL_SLACK 8
#define NORMAL_SLACK_CURVED (INT32_C(1) << 20)

typedef struct surface_query {
  const gjk_parts_frame *frame;
  const gjk_collider *body;
  gjk_q16 margin;
  unsigned most;
  int32_t slack;     // of normals
  gjk_cache *cache;  // of gjk_within for all triangles
  const gjk_workspace *workspace;
  gjk_manifold *out;
  gjk_surface_face face;
  gjk_collider triangle;
  gjk_candidates candidates;  // along the triangle's own normal, once they are found
  bool found;
  bool over;                    // the deepest point lies over the triangle
  bool touches;                 // the body is known to share a point with the triangle
  bool limited;                 // a curved body reached its ceiling where the answer depends on it
  gjk_distance_result nearest;  // from step 3 on
  unsigned first, last;         // the edge's corners that meet its normal, or the corner twice
} surface_query;

// A body that is behind the plane in part may have come around the triangle, and not touch it.
static bool touches(surface_query *q, const gjk_collider *triangle) {
  gjk_decision decision;
  const gjk_status status = gjk_intersect(triangle, q->body, NULL, &decision);
  q->limited = q->limited || status != GJK_OK;
  return status != GJK_OK || decision.yes;
}

static bool is_above_or_touches(surface_query *q) {
  return q->face.height >= 0 || q->touches || touches(q, &q->triangle);
}

static void keep(surface_query *q, const gjk_distance_result *nearest) {
  gjk_manifold_keep(&q->candidates, nearest, q->most, q->out);
}

static void find_along(surface_query *q, const gjk_unit3 *normal) {
  q->out->normal = *normal;
  gjk_manifold_find(&q->triangle, q->body, q->margin, &q->candidates, q->out);
}

static void find_on_face(surface_query *q) {
  if (!q->found) {
    find_along(q, &q->face.unit);
    q->found = true;
  }
}

// Is one of the candidates as deep as the body is?
static bool reaches_deepest(const surface_query *q) {
  const gjk_q16 most = q->face.height + GJK_FACE_LEVEL;
  for (unsigned i = 0; i < q->candidates.count; i++) {
    if (q->candidates.candidate[i].distance <= most) {
      return true;
    }
  }
  return false;
}

// Where the deepest point lies over the triangle, it is likely to touch, or is as near as it is high. A direction that keeps
// the body off one triangle is likely to keep it off the next. A limit of iterations is left to gjk_signed_distance.
static bool is_within_margin(surface_query *q) {
  const gjk_q16 height = q->face.height;
  gjk_decision decision;
  q->touches = q->over && height < 0 && (gjk_face_is_pierced(q->body, &q->face) || touches(q, &q->triangle));
  if (q->touches || (q->over && height >= 0 && height <= q->margin - 2 * GJK_FACE_LEVEL)) {
    return true;
  }
  return gjk_within(&q->triangle, q->body, q->margin, q->cache, &decision) != GJK_OK || decision.yes;
}

// Step 2. False: no deepest point of the body lies over the triangle.
static bool meets_face(surface_query *q) {
  if (!q->over && gjk_face_is_pointed(q->body, &q->face)) {
    return false;
  }
  find_on_face(q);
  const bool reached = reaches_deepest(q);
  if ((!q->over && !reached) || !is_above_or_touches(q)) {
    return false;
  }
  if (reached) {
    keep(q, NULL);
  } else if (q->face.height <= q->margin) {
    const gjk_q16 height = q->face.height, radius = q->body->shape->convex_radius;
    q->nearest.distance = height;
    gjk_face_move_deepest(q->body, &q->face, -radius, &q->nearest.point_b);
    gjk_face_move_deepest(q->body, &q->face, -radius - height, &q->nearest.point_a);  // the core's height: below 2^31
    keep(q, &q->nearest);
  }
  return true;
}

// How far p is beyond the plane across the normal of step 3 at v: above 0, at least by the slack.
static bool is_beyond_plane(const surface_query *q, const gjk_vec3 *v, const gjk_vec3 *p) {
  const gjk_vec3 step = gjk_sub(*p, *v);
  return gjk_along(&q->nearest.normal, &step) > (int64_t)gjk_norm1(step) * q->slack;  // below 2^33 2^20
}

// Step 3: bit i is set if the triangle meets the normal with its corner i.
static unsigned corners_that_meet(const surface_query *q) {
  const gjk_vec3 *corner = q->face.corner, *top = &corner[0];
  unsigned bits = 0;
  for (unsigned i = 1; i < 3; i++) {
    const gjk_vec3 step = gjk_sub(corner[i], *top);
    top = gjk_along(&q->nearest.normal, &step) > 0 ? &corner[i] : top;
  }
  for (unsigned i = 0; i < 3; i++) {
    bits |= is_beyond_plane(q, &corner[i], top) ? 0u : 1u << i;
  }
  return bits;
}

// Which of the triangle's edges has these two corners.
static unsigned edge_with(unsigned bits) {
  return bits == 3 ? 0 : bits == 6 ? 1 : 2;
}

static bool has_corner(const gjk_surface_face *f, const gjk_vec3 *local) {
  return gjk_same_place(&f->local[0], local) || gjk_same_place(&f->local[1], local) ||
         gjk_same_place(&f->local[2], local);
}

// The other triangles at the edge or corner of step 3, one after the other.
typedef struct ring_walk {
  gjk_region region;
  gjk_parts_walk walk;
} ring_walk;

// Corners of the triangle are less than 2^29 apart.
static void ring_start(const surface_query *q, ring_walk *ring) {
  const gjk_vec3 *p = &q->face.local[q->first], *r = &q->face.local[q->last];
  gjk_aabb *box = &ring->region.box;
  ring->region.moves = false;
  box->lower.x = p->x + gjk_sar32(r->x - p->x, 1);
  box->lower.y = p->y + gjk_sar32(r->y - p->y, 1);
  box->lower.z = p->z + gjk_sar32(r->z - p->z, 1);
  gjk_set(&box->lower, &box->upper);
  gjk_parts_walk_start(&ring->walk);
}

// Ends: each triangle comes once.
static bool ring_next(const surface_query *q, ring_walk *ring, gjk_surface_face *other) {
  uint32_t number;
  while (gjk_parts_next(q->frame, &ring->region, &ring->walk, &number)) {
    if (number != q->face.number) {
      gjk_face_find(q->frame, number, other);
      if (has_corner(other, &q->face.local[q->first]) && has_corner(other, &q->face.local[q->last]) &&
          gjk_face_turn(q->frame, q->body, other)) {
        return true;
      }
    }
  }
  return false;
}

// For a body that overlaps a triangle only one that it overlaps as well can answer.
static bool answers(surface_query *q, const gjk_surface_face *other) {
  gjk_parts_room room;
  gjk_collider triangle;
  return q->nearest.distance > 0 ||
         (gjk_triangle_collider(other->world, &room, &triangle) == GJK_OK && touches(q, &triangle));
}

// Steps 4 and 5. *answered: a triangle across the normal answers.
static bool has_normal(surface_query *q, bool *answered) {
  const gjk_vec3 *at = &q->face.corner[q->first];
  ring_walk ring;
  gjk_surface_face other;
  bool has = true;
  ring_start(q, &ring);
  while ((has || !*answered) && ring_next(q, &ring, &other)) {
    if (is_beyond_plane(q, at, &other.corner[0]) || is_beyond_plane(q, at, &other.corner[1]) ||
        is_beyond_plane(q, at, &other.corner[2])) {
      has = false;
      *answered = gjk_face_set(q->frame, q->body, &other) && other.height > q->face.height && answers(q, &other);
    }
  }
  return has;
}

// Does the deepest point lie over some triangle at the edge or corner?
static bool is_over_ring(surface_query *q) {
  ring_walk ring;
  gjk_surface_face other;
  ring_start(q, &ring);
  while (ring_next(q, &ring, &other)) {
    if (gjk_face_set(q->frame, q->body, &other) && gjk_face_is_over(&other, &other.deepest) && answers(q, &other)) {
      return true;
    }
  }
  return false;
}

// Step 6: the nearest points of both, with the triangle's normal.
static void keep_nearest(surface_query *q) {
  const gjk_q16 height = q->face.height;
  q->nearest.distance = height > q->nearest.distance ? height : q->nearest.distance;
  if (q->nearest.distance <= q->margin) {
    keep(q, &q->nearest);
  }
}

// Steps 3 to 6 without a distance. False: it is needed.
//
// It is where the triangle has a convex or an open edge, so that it may have normals that are not its own. A corner alone does
// not count: where it has a normal that none of this triangle's edges has, other triangles there have such edges.
static bool is_settled(surface_query *q) {
  // Convex and open are the two kinds with this bit.
  const unsigned ridge = GJK_TRIANGLE_EDGES(GJK_MESH_CONVEX, GJK_MESH_CONVEX, GJK_MESH_CONVEX);
  if ((q->face.edges & (ridge | GJK_TRIANGLE_TWO_SIDED)) != 0 || gjk_is_curved(q->body->shape)) {
    return false;
  }
  find_on_face(q);
  if (q->candidates.count == 0) {
    return q->face.height >= 0 && !gjk_face_is_nearly_over(q->body, &q->face);
  }
  if (is_above_or_touches(q)) {
    keep(q, NULL);
  }
  return true;
}

// Steps 3 to 5: has the surface the normal there? If it is the triangle's own but for rounding, makes it that.
static bool settle_normal(surface_query *q, bool *answered) {
  const gjk_unit3 *n = &q->nearest.normal;
  const gjk_vec3 normal = {n->x, n->y, n->z};
  const unsigned bits = corners_that_meet(q);
  const bool in_front = gjk_along(&q->face.unit, &normal) > 0;
  const unsigned ridge = in_front ? GJK_MESH_CONVEX : GJK_MESH_CONCAVE;
  unsigned edge = ridge;
  if (bits == 7 && in_front) {
    q->nearest.normal = q->face.unit;
    return true;
  }
  q->first = q->last = bits >> 1;  // of one corner 0, 1 or 2
  if ((bits & (bits - 1)) != 0) {
    q->first = edge_with(bits);
    q->last = gjk_next(q->first);
    edge = GJK_TRIANGLE_EDGE(q->face.edges, q->first);
  }
  if (!in_front && (q->face.edges & GJK_TRIANGLE_TWO_SIDED) == 0) {
    return false;
  }
  return edge == ridge ? has_normal(q, answered) : edge == GJK_MESH_OPEN;
}

// Steps 3 to 6.
static gjk_status meet_beside(surface_query *q) {
  bool answered = false;
  if (is_settled(q)) {
    return GJK_OK;
  }
  const gjk_status status = gjk_signed_distance(&q->triangle, q->body, NULL, q->workspace, &q->nearest);
  if ((status != GJK_OK && status != GJK_ERROR_CAPACITY) || q->nearest.distance > q->margin) {
    return status;
  }
  if (settle_normal(q, &answered)) {
    find_along(q, &q->nearest.normal);
    keep(q, &q->nearest);
  } else if (!answered) {
    find_on_face(q);
    const bool together = q->nearest.distance <= 0;
    if (q->candidates.count > 0 && (together || q->face.height >= 0)) {
      keep(q, NULL);
    } else if ((together || gjk_is_curved(q->body->shape) || gjk_face_is_nearly_over(q->body, &q->face)) &&
               !is_over_ring(q)) {
      keep_nearest(q);
    }
  }
  return status;
}

gjk_status gjk_surface_meet(const gjk_parts_frame *frame, uint32_t number, const gjk_collider *b, gjk_q16 margin,
                            unsigned most, gjk_cache *cache, const gjk_workspace *workspace, gjk_manifold *out) {
  surface_query q;
  gjk_parts_room room;
  q.frame = frame;
  q.body = b;
  q.margin = margin;
  q.most = most;
  q.slack = gjk_is_curved(b->shape) ? NORMAL_SLACK_CURVED : NORMAL_SLACK;
  q.cache = cache;
  q.workspace = workspace;
  q.out = out;
  q.candidates.count = 0;
  q.found = false;
  q.limited = false;
  out->count = 0;
  out->feature_a = 0;
  out->feature_b = 0;
  gjk_face_find(frame, number, &q.face);
  if (!gjk_face_turn(frame, b, &q.face) || gjk_face_is_aside(b, margin, &q.face) || !gjk_face_set(frame, b, &q.face) ||
      q.face.height > margin + GJK_FACE_LEVEL) {
    return GJK_OK;
  }
  q.over = gjk_face_is_over(&q.face, &q.face.deepest);
  gjk_status status = gjk_triangle_collider(q.face.world, &room, &q.triangle);
  if (status != GJK_OK || !is_within_margin(&q)) {
    return status;
  }
  if (!meets_face(&q)) {
    status = meet_beside(&q);
  }
  if (q.limited) {
    out->count = 0;
    status = GJK_ERROR_ITERATION_LIMIT;
  }
  return status;
}

// The contacts that the triangle alone has tell how far apart they may be.
bool gjk_surface_settle(const gjk_parts_frame *frame, uint32_t number, const gjk_collider *b, gjk_manifold *m) {
  gjk_q16 margin = 0;
  for (unsigned i = 0; i < m->count; i++) {
    margin = m->contact[i].distance > margin ? m->contact[i].distance : margin;
  }
  const unsigned most = m->count;
  margin = margin < GJK_RADIUS_MAX ? margin : GJK_RADIUS_MAX;
  const gjk_status status = most == 0 ? GJK_OK : gjk_surface_meet(frame, number, b, margin, most, NULL, NULL, m);
  return (status == GJK_OK || status == GJK_ERROR_CAPACITY) && m->count > 0;
}
