// Casts and rays against ground: each segment near the way is asked, and the first hit that counts is reported.
//
// A long way is cut into pieces, so that no more segments are asked than those near it. A segment's hit is always that of
// the whole way. A hit lies in the piece of its fraction, so once one is found in the pieces so far, none is earlier.
#include "../arith/gjk_memory.h"
#include "../plane/gjk2_measure.h"
#include "gjk2_ground_box.h"
#include "gjk2_ground_queries.h"
#include "gjk2_ground_way.h"

// By how much the gap at a reported fraction may exceed the margin, see gjk2/cast.h.
#define EARLY 8

// A way is cut into at most 2^PIECES pieces, each longer than the body and GRAIN.
#define PIECES 6
#define GRAIN (INT64_C(4) << 16)

typedef struct ground_cast {
  const gjk2_collider *body;  // NULL: a ray
  const gjk2_vec *from, *to;  // of a ray
  const gjk2_cast_path *path;
  gjk2_vec start;   // of the body's centre, or the ray
  int64_t x, y;     // the way of the body against the ground, below 2^32
  int64_t of_a[2];  // the way of the ground, below 2^32
  bool ahead;       // see gjk2_ground_cast_ahead
  gjk2_ground_walk walk;
  gjk2_cast_result first;  // the first hit so far
  uint32_t segment;        // of it
} ground_cast;

// n . way:  |n.x| + |n.y| <= 2^28 + 4
static int64_t along_way(const ground_cast *c, gjk2_vec n) {
  return n.x * c->x + n.y * c->y;
}

// Is the centre in front of the line, or on it, at a fraction?
static bool is_in_front_at(const ground_cast *c, const gjk2_line *line, gjk_q30 fraction) {
  const gjk2_vec n = gjk2_outward(gjk2_sub(line->q, line->p));
  const int64_t start = n.x * ((int64_t)c->start.x - line->p.x) + n.y * ((int64_t)c->start.y - line->p.y);
  return gjk_sum_of_products_sign_exact(start, GJK_Q30_ONE, along_way(c, n), fraction) >= 0;
}

// Does the body come nearer along a unit?  |unit| <= 2^30 + 2, |way| < 2^32.5:  the sum < 2^63
static bool comes_nearer(const ground_cast *c, const gjk2_unit *normal) {
  return normal->x * c->x + normal->y * c->y < 0;
}

// Does a hit of a segment count? A normal that is not of a joint becomes the segment's own, as exact as that is.
static bool does_hit_count(const ground_cast *c, const gjk2_line *line, gjk2_cast_result *hit) {
  const gjk2_vec n = gjk2_outward(gjk2_sub(line->q, line->p));
  if (!is_in_front_at(c, line, hit->fraction)) {
    return false;
  }
  if (hit->inside) {
    return true;
  }
  const gjk2_ground_side side = gjk2_ground_side_of(line, &hit->normal);
  if (side == GJK2_GROUND_BETWEEN) {
    return comes_nearer(c, &hit->normal);
  }
  if (side == GJK2_GROUND_OTHER || along_way(c, n) >= 0) {
    return false;
  }
  gjk2_length length;
  gjk2_normal_set(&hit->normal, &length, &n);
  return true;
}

// The same for a ray: a point has no other normal than the segment's.
static bool does_ray_count(const ground_cast *c, const gjk2_line *line) {
  return is_in_front_at(c, line, 0) && along_way(c, gjk2_outward(gjk2_sub(line->q, line->p))) < 0;
}

static gjk_status ask_segment(const ground_cast *c, const gjk2_collider *segment, gjk2_cast_result *hit) {
  if (c->body == NULL) {
    return gjk2_cast_ray(segment, c->from, c->to, hit);
  }
  // The ground is in range at both ends, so the segment is.
  const gjk2_vec to_a = {(int32_t)(segment->position.x + c->of_a[0]), (int32_t)(segment->position.y + c->of_a[1])};
  const gjk2_cast_path path = {c->path->to_a != NULL ? &to_a : NULL, c->path->to_b, c->path->margin};
  return gjk2_cast(segment, c->body, &path, hit);
}

// The ground's own position in place of the segment's.
static void put_rest_of_ground(ground_cast *c, const gjk2_collider *segment) {
  const int64_t x = (int64_t)c->first.rest_a.x - segment->position.x,
                y = (int64_t)c->first.rest_a.y - segment->position.y;
  c->first.rest_a.x = gjk_saturate(c->walk.position.x + x);
  c->first.rest_a.y = gjk_saturate(c->walk.position.y + y);
}

// Asks the segments near a box. Keeps the first hit.
static gjk_status ask_near(ground_cast *c, const gjk2_aabb *near) {
  gjk2_line line;
  gjk2_ground_edge edge;
  gjk_status open = GJK_OK;
  gjk2_ground_begin(&c->walk, near);
  while (gjk2_ground_next(&c->walk, &line, &edge)) {
    gjk2_cast_result hit;
    gjk2_collider segment;
    if (c->ahead && !gjk2_ground_is_ahead(&line, c->body, 0)) {
      continue;
    }
    gjk2_line_collider(line.p, line.q, &segment);
    const gjk_status status = ask_segment(c, &segment, &hit);
    if (status != GJK_OK) {
      open = status;
      continue;
    }
    if (hit.hit && c->body != NULL) {
      gjk2_ground_set_neighbours(&c->walk, &line, &edge);
    }
    if (!hit.hit || !(c->body == NULL ? does_ray_count(c, &line) : does_hit_count(c, &line, &hit))) {
      continue;
    }
    if (!c->first.hit || hit.fraction < c->first.fraction ||
        (hit.fraction == c->first.fraction && line.number < c->segment)) {
      gjk_copy(&c->first, &hit, sizeof hit);
      c->segment = line.number;
      put_rest_of_ground(c, &segment);
    }
  }
  return open;
}

// So much of a way:  |way| < 2^33, 0 <= i <= 2^PIECES
static int64_t piece_of_way(int64_t way, unsigned i, unsigned pieces) {
  return gjk_sar64(way * i, pieces);
}

// Asks piece after piece. box: of the body at the start.
static gjk_status ask_pieces(ground_cast *c, const gjk2_aabb *box) {
  const int64_t x = (int64_t)gjk_magnitude64(c->x), y = (int64_t)gjk_magnitude64(c->y), longer = x > y ? x : y;
  const int64_t size = ((int64_t)box->upper.x - box->lower.x) + ((int64_t)box->upper.y - box->lower.y) + GRAIN;
  const gjk_q16 margin = c->path != NULL && c->path->margin <= GJK2_RADIUS_MAX ? c->path->margin + EARLY : EARLY;
  gjk_status open = GJK_OK;
  unsigned pieces = 0;
  while (pieces < PIECES && longer >> pieces > size) {
    pieces++;
  }
  for (unsigned i = 0; i < 1u << pieces; i++) {
    const gjk2_aabb from =
        gjk2_ground_box_at(box, margin, piece_of_way(c->x, i, pieces), piece_of_way(c->y, i, pieces));
    const gjk2_aabb to =
        gjk2_ground_box_at(box, margin, piece_of_way(c->x, i + 1, pieces), piece_of_way(c->y, i + 1, pieces));
    const gjk2_aabb near = gjk2_aabb_hull(&from, &to);
    const gjk_status status = ask_near(c, &near);
    open = status != GJK_OK ? status : open;
    if (c->first.hit && (uint32_t)c->first.fraction >> (30 - pieces) <= i) {
      break;
    }
  }
  return open;
}

// Runs a cast whose way is set. Writes out and segment after OK.
static gjk_status run_cast(ground_cast *c, const gjk2_aabb *box, gjk2_cast_result *out, uint32_t *segment) {
  c->first.hit = false;
  const gjk_status status = ask_pieces(c, box);
  if (status != GJK_OK) {
    return status;
  }
  if (!c->first.hit) {
    out->hit = false;
    out->iterations = 0;
    out->certificate.proof = GJK2_CAST_PROOF_NONE;
    out->certificate.count = 0;
    return GJK_OK;
  }
  gjk_copy(out, &c->first, sizeof *out);
  *segment = c->segment;
  return GJK_OK;
}

static bool is_below_way(int64_t x) {
  return x > -(INT64_C(1) << 32) && x < INT64_C(1) << 32;
}

static bool stays_on_way(int32_t centre, int64_t way) {
  return centre + way >= INT32_MIN && centre + way <= INT32_MAX;
}

gjk_status gjk2_ground_cast_ahead(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_collider *body,
                                  const gjk2_cast_path *path, bool ahead, gjk2_cast_result *out, uint32_t *segment) {
  ground_cast c;
  gjk2_aabb box;
  gjk_status status =
      path == NULL || out == NULL || segment == NULL ? GJK_ERROR_NULL : gjk2_ground_place(ground, pose, &c.walk);
  status = status == GJK_OK ? gjk2_collider_aabb(body, &box) : status;
  if (status != GJK_OK) {
    return status;
  }
  if (path->margin < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  c.body = body;
  c.from = c.to = NULL;
  c.path = path;
  c.ahead = ahead;
  c.of_a[0] = c.of_a[1] = 0;
  if (path->to_a != NULL) {
    gjk2_ground_walk end;
    gjk2_pose at_end;
    gjk2_copy(&at_end.position, path->to_a);
    at_end.rotation = pose->rotation;
    status = gjk2_ground_place(ground, &at_end, &end);
    if (status != GJK_OK) {
      return status;
    }
    c.of_a[0] = (int64_t)path->to_a->x - pose->position.x;
    c.of_a[1] = (int64_t)path->to_a->y - pose->position.y;
  }
  const gjk2_vec *to = path->to_b != NULL ? path->to_b : &body->position;
  const int64_t x = (int64_t)to->x - body->position.x, y = (int64_t)to->y - body->position.y;
  c.start = body->centre;
  c.x = x - c.of_a[0];
  c.y = y - c.of_a[1];
  if (!stays_on_way(c.start.x, x) || !stays_on_way(c.start.y, y) || !is_below_way(c.x) || !is_below_way(c.y)) {
    return GJK_ERROR_RANGE;
  }
  return run_cast(&c, &box, out, segment);
}

gjk_status gjk2_ground_cast(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_collider *body,
                            const gjk2_cast_path *path, gjk2_cast_result *out, uint32_t *segment) {
  return gjk2_ground_cast_ahead(ground, pose, body, path, false, out, segment);
}

gjk_status gjk2_ground_cast_ray(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_vec *from,
                                const gjk2_vec *to, gjk2_cast_result *out, uint32_t *segment) {
  ground_cast c;
  const gjk_status status = from == NULL || to == NULL || out == NULL || segment == NULL
                                ? GJK_ERROR_NULL
                                : gjk2_ground_place(ground, pose, &c.walk);
  if (status != GJK_OK) {
    return status;
  }
  const gjk2_aabb box = {*from, *from};
  c.body = NULL;
  c.from = from;
  c.to = to;
  c.path = NULL;
  c.ahead = false;
  c.of_a[0] = c.of_a[1] = 0;
  c.start = *from;
  c.x = (int64_t)to->x - from->x;
  c.y = (int64_t)to->y - from->y;
  return run_cast(&c, &box, out, segment);
}
