// Casts and rays against ground: each segment near the way is asked, and the first hit that counts is reported.
//
// A long way is cut into pieces, so that no more segments are asked than those near it. A segment's hit is always that of
// the whole way. A hit lies in the piece of its fraction, so once one is found in the pieces so far, none is earlier.
// A segment is not asked where the body stays in front of its line, or its centre behind it, as far as the way counts.
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
  int64_t until_x, until_y;  // the way that counts: up to the first hit, within an LSB, or all of it
  gjk2_cast_result result[2];
  unsigned first;    // which one is the first hit so far; the other one is free
  bool found;        // there is one
  uint32_t segment;  // of it
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

// Is no hit of a segment to be expected that counts and is as early as the first? Of curved bodies always asked, which may have
// no answer.
//
//   |n.x| + |n.y| <= 2^28 + 4, a vertex of the body < 2^32.1 from p, the way < 2^32:  heights < 2^62
//   radius < 2^31 + 2^29:  times |n.x| + |n.y| < 2^60
static bool is_out_of_reach(const ground_cast *c, const gjk2_line *line) {
  const gjk2_shape *shape = c->body->shape;
  if (gjk2_is_curved(shape)) {
    return false;
  }
  const gjk2_vec n = gjk2_outward(gjk2_sub(line->q, line->p)), back = gjk2_negate(n);
  const int64_t along = n.x * c->until_x + n.y * c->until_y, falls = along < 0 ? along : 0;
  const int64_t x = (int64_t)c->start.x - line->p.x, y = (int64_t)c->start.y - line->p.y;
  const int64_t slack = c->found ? (EARLY + 1) * (int64_t)gjk2_norm1(n) : 0;
  const int64_t centre = n.x * x + n.y * y;
  if (centre < -slack && centre - falls + along < -slack) {
    return true;
  }
  gjk2_support lowest;
  shape->type->support(c->body, &back, &lowest);
  const int64_t radius = (int64_t)shape->convex_radius + c->path->margin;
  return centre + gjk2_dot(n, lowest.offset) + falls > radius * (int64_t)gjk2_norm1(n) + slack;
}

// Does a hit of a segment count? A normal that is not of a joint becomes the segment's own, as exact as that is.
static bool does_hit_count(const ground_cast *c, gjk2_line *line, gjk2_ground_edge *edge, gjk2_cast_result *hit) {
  const gjk2_vec n = gjk2_outward(gjk2_sub(line->q, line->p));
  if (!is_in_front_at(c, line, hit->fraction)) {
    return false;
  }
  if (hit->inside) {
    return true;
  }
  gjk2_ground_side side = GJK2_GROUND_OWN;
  if (!gjk2_ground_is_own(line, &hit->normal)) {
    gjk2_ground_set_neighbours(&c->walk, line, edge);
    side = gjk2_ground_side_of(line, &hit->normal);
  }
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
  return gjk2_line_cast(segment, c->body, &path, hit);
}

// Keeps the free result as the first hit, with the ground's own position in place of the segment's.
static void keep_ground_hit(ground_cast *c, const gjk2_collider *segment, uint32_t number) {
  c->first = 1 - c->first;
  gjk2_cast_result *hit = &c->result[c->first];
  const int64_t x = (int64_t)hit->rest_a.x - segment->position.x, y = (int64_t)hit->rest_a.y - segment->position.y;
  hit->rest_a.x = gjk_saturate(c->walk.position.x + x);
  hit->rest_a.y = gjk_saturate(c->walk.position.y + y);
  c->found = true;
  c->segment = number;
  c->until_x = gjk_sar64(c->x * hit->fraction, 30);  // |way| < 2^32:  the product < 2^62
  c->until_y = gjk_sar64(c->y * hit->fraction, 30);
}

// Does a hit come before the first one, or is there none?
static bool is_ground_hit_earlier(const ground_cast *c, const gjk2_cast_result *hit, uint32_t number) {
  const gjk_q30 first = c->result[c->first].fraction;
  return !c->found || hit->fraction < first || (hit->fraction == first && number < c->segment);
}

// Asks the segments near a box. Keeps the first hit.
static gjk_status ask_near(ground_cast *c, const gjk2_aabb *near) {
  gjk2_line line;
  gjk2_ground_edge edge;
  gjk_status open = GJK_OK;
  gjk2_ground_begin(&c->walk, near);
  while (gjk2_ground_next(&c->walk, &line, &edge)) {
    gjk2_cast_result *hit = &c->result[1 - c->first];
    gjk2_collider segment;
    if (c->body != NULL && (is_out_of_reach(c, &line) || (c->ahead && !gjk2_ground_is_ahead(&line, c->body, 0)))) {
      continue;
    }
    gjk2_line_collider(line.p, line.q, &segment);
    const gjk_status status = ask_segment(c, &segment, hit);
    if (status != GJK_OK) {
      open = status;
    } else if (hit->hit && is_ground_hit_earlier(c, hit, line.number) &&
               (c->body == NULL ? does_ray_count(c, &line) : does_hit_count(c, &line, &edge, hit))) {
      keep_ground_hit(c, &segment, line.number);
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
  const gjk_q16 most = c->path != NULL && c->path->margin <= GJK2_RADIUS_MAX ? c->path->margin : 0;
  gjk_status open = GJK_OK;
  unsigned pieces = 0;
  while (pieces < PIECES && longer >> pieces > size) {
    pieces++;
  }
  // In one piece fractions of polygons do not matter: what the box with its margin does not meet is not hit.
  const gjk_q16 margin = pieces == 0 && c->body != NULL && !gjk2_is_curved(c->body->shape) ? most : most + EARLY;
  for (unsigned i = 0; i < 1u << pieces; i++) {
    const gjk2_aabb from =
        gjk2_ground_box_at(box, margin, piece_of_way(c->x, i, pieces), piece_of_way(c->y, i, pieces));
    const gjk2_aabb to =
        gjk2_ground_box_at(box, margin, piece_of_way(c->x, i + 1, pieces), piece_of_way(c->y, i + 1, pieces));
    const gjk2_aabb near = gjk2_aabb_hull(&from, &to);
    const gjk_status status = ask_near(c, &near);
    open = status != GJK_OK ? status : open;
    if (c->found && (uint32_t)c->result[c->first].fraction >> (30 - pieces) <= i) {
      break;
    }
  }
  return open;
}

// By parts, see gjk2_copy.
static void copy_ground_hit(gjk2_cast_result *to, const gjk2_cast_result *from) {
  to->hit = from->hit;
  to->inside = from->inside;
  to->fraction = from->fraction;
  gjk2_copy(&to->point_a, &from->point_a);
  gjk2_copy(&to->point_b, &from->point_b);
  to->normal.x = from->normal.x;
  to->normal.y = from->normal.y;
  gjk2_copy(&to->rest_a, &from->rest_a);
  gjk2_copy(&to->rest_b, &from->rest_b);
  to->saturated = from->saturated;
  to->iterations = from->iterations;
  gjk2_copy(&to->certificate.direction, &from->certificate.direction);
  for (int i = 0; i < 3; i++) {
    to->certificate.a[i] = from->certificate.a[i];
    to->certificate.b[i] = from->certificate.b[i];
  }
  to->certificate.count = from->certificate.count;
  to->certificate.proof = from->certificate.proof;
}

// Runs a cast whose way is set. Writes out and segment after OK.
static gjk_status run_cast(ground_cast *c, const gjk2_aabb *box, gjk2_cast_result *out, uint32_t *segment) {
  c->found = false;
  c->first = 0;
  c->until_x = c->x;
  c->until_y = c->y;
  const gjk_status status = ask_pieces(c, box);
  if (status != GJK_OK) {
    return status;
  }
  if (!c->found) {
    out->hit = false;
    out->iterations = 0;
    out->certificate.proof = GJK2_CAST_PROOF_NONE;
    out->certificate.count = 0;
    return GJK_OK;
  }
  copy_ground_hit(out, &c->result[c->first]);
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
