// The contacts of a body with a segment of ground and the joints at its ends, from the outside:
//
//   1. Find the joints at its ends: convex ones and open ends have directions of their own, a wedge.
//   2. Its own contacts: the body's deepest corner along the segment's normal, and the edge with which it faces it.
//      They stand unless a way out along a wedge or along a convex neighbour's normal is shorter.
//   3. The contact of the joint where it begins, and of an open end: along the direction strictly within the wedge with
//      the shortest way out, where that is shorter than along both normals.
//
// Everything is relative to the body's centre. The body's radius, margin and a segment are each at most 2^28 along an
// axis, so the ends of a segment are below 3 2^28, and less than 2^30 from every point of the body:
//   |segment| <= 2^28.5, |b - v| <= 2^30.5:   products below 2^59
#include "gjk2_chain_reach.h"
#include "gjk2_facing.h"
#include "gjk2_hull.h"
#include "gjk2_line.h"
#include "gjk2_measure.h"

// The joint at one end of a segment.
typedef struct line_joint {
  gjk2_vec at;
  bool convex;                 // it has a wedge
  bool concave;                // strictly; others are straight
  bool open;                   // an end of the ground; neighbour is where the surface would turn back
  gjk2_vec neighbour;          // the neighbour's normal
  gjk2_vec neighbour_segment;  // from its first vertex to its last
} line_joint;

typedef struct line_segment {
  const gjk2_line *line;
  gjk2_vec p, q, along, normal;
  line_joint before, after;
} line_segment;

// Step 1. The ground turns left at a convex joint. Where it turns back in the same line it counts as convex, a tip.
GJK_ONE_COPY static void find_joint(const line_segment *s, bool at_end, line_joint *out) {
  const gjk2_line *line = s->line;
  gjk2_copy(&out->at, at_end ? &s->q : &s->p);
  out->open = at_end ? line->open_after : line->open_before;
  if (out->open) {
    out->convex = true;
    out->concave = false;
    out->neighbour = at_end ? s->along : gjk2_negate(s->along);
    return;
  }
  gjk2_copy(&out->neighbour_segment, at_end ? &line->after : &line->before);
  const int64_t turn =
      at_end ? gjk2_cross(s->along, out->neighbour_segment) : gjk2_cross(out->neighbour_segment, s->along);
  out->convex = turn > 0 || (turn == 0 && gjk2_dot(s->along, out->neighbour_segment) < 0);
  out->concave = turn < 0;
  out->neighbour = gjk2_outward(out->neighbour_segment);
}

static void find_segment(const gjk2_line_query *query, const gjk2_line *line, line_segment *out) {
  out->line = line;
  out->p = gjk2_sub(line->p, query->body->centre);
  out->q = gjk2_sub(line->q, query->body->centre);
  out->along = gjk2_sub(out->q, out->p);
  out->normal = gjk2_outward(out->along);
  find_joint(out, false, &out->before);
  find_joint(out, true, &out->after);
}

static bool is_in_reach(const gjk2_line_query *query, const gjk2_chain_aim *aim) {
  return aim->height <= 0 || gjk2_is_within(aim->height, aim->d, query->reach);
}

// The wedge at one end of a segment: from one normal to the other, counterclockwise.
GJK_ONE_COPY static void wedge_of(const line_segment *s, bool at_end, gjk2_vec *from, gjk2_vec *to) {
  gjk2_copy(from, at_end ? &s->normal : &s->before.neighbour);
  gjk2_copy(to, at_end ? &s->after.neighbour : &s->normal);
}

static bool find_in_wedge(const gjk2_line_query *query, const line_segment *s, bool at_end, gjk2_chain_aim *best) {
  gjk2_vec from, to;
  wedge_of(s, at_end, &from, &to);
  return gjk2_chain_find_in_wedge(query->body, &from, &to, at_end ? &s->after.at : &s->before.at, best);
}

// Is d within 20 degrees of the normal?
static bool is_near_normal(const gjk2_vec *d, const gjk2_vec *normal) {
  const int64_t along = gjk2_dot(*d, *normal);
  return along > 0 && gjk_magnitude64(gjk2_cross(*d, *normal)) <= ((uint64_t)along >> 10) * 373;
}

// Is a vertex within the box?
static bool is_in_box(const gjk2_line_query *query, gjk2_vec v) {
  return v.x >= query->low.x && v.x <= query->high.x && v.y >= query->low.y && v.y <= query->high.y;
}

// May the body meet the neighbour at a joint? Its box must meet the neighbour's; of a convex one its centre must be in
// front as well.
static bool may_meet_neighbour(const gjk2_line_query *query, const line_segment *s, bool at_end) {
  const line_joint *joint = at_end ? &s->after : &s->before;
  const gjk2_vec v = joint->at, low = query->low, high = query->high;
  if (joint->open || (joint->convex && gjk2_dot(joint->neighbour, v) > 0)) {
    return false;
  }
  const gjk2_vec w = at_end ? gjk2_add(v, joint->neighbour_segment) : gjk2_sub(v, joint->neighbour_segment);
  return (v.x <= high.x || w.x <= high.x) && (v.x >= low.x || w.x >= low.x) && (v.y <= high.y || w.y <= high.y) &&
         (v.y >= low.y || w.y >= low.y);
}

// Step 2. Is a way out at one end of the segment shorter than along its own normal? level: normals within 20 degrees
// don't count, since the segment faces an edge, or the body is curved and what it reaches along them differs by little.
static bool yields_at(const gjk2_line_query *query, const line_segment *s, bool at_end, const gjk2_chain_aim *own,
                      bool level) {
  const line_joint *joint = at_end ? &s->after : &s->before;
  gjk2_chain_aim other;
  if (!joint->convex) {
    return false;
  }
  if (!gjk2_is_curved(query->body->shape) && is_in_box(query, joint->at)) {
    if (find_in_wedge(query, s, at_end, &other) && gjk2_chain_is_farther(&other, own) &&
        !(level && is_near_normal(&other.d, &s->normal))) {
      return true;
    }
  }
  if (!may_meet_neighbour(query, s, at_end) || (level && is_near_normal(&joint->neighbour, &s->normal))) {
    return false;
  }
  gjk2_chain_aim_along(query->body, &joint->neighbour, &joint->at, &other);
  return gjk2_chain_is_farther(&other, own);
}

// Is a point of the body that lies beyond one end of the segment the segment's? It is where the neighbour cannot meet the
// body; and behind a concave joint where it lies across from neither. along: of the neighbour, how far the point lies on
// its side of the joint.
static bool is_own_beyond(const gjk2_line_query *query, const line_segment *s, bool at_end, int64_t along) {
  const line_joint *joint = at_end ? &s->after : &s->before;
  return !joint->open && ((joint->concave && along < 0) || !may_meet_neighbour(query, s, at_end));
}

// Does a point of the body lie across from the segment, or is it the segment's beyond an end?
static bool lies_across(const gjk2_line_query *query, const line_segment *s, gjk2_vec b) {
  const gjk2_vec from_p = gjk2_sub(b, s->p), from_q = gjk2_sub(b, s->q);
  if (gjk2_dot(s->along, from_p) < 0) {
    return is_own_beyond(query, s, false, s->before.open ? 0 : -gjk2_dot(s->before.neighbour_segment, from_p));
  }
  if (gjk2_dot(s->along, from_q) > 0) {
    return is_own_beyond(query, s, true, s->after.open ? 0 : gjk2_dot(s->after.neighbour_segment, from_q));
  }
  return true;
}

// v moved along a unit by a length. Pre: |by| < 2^31, and it arrives within int32.
static gjk2_vec relative_moved(gjk2_vec v, const gjk2_unit *unit, int64_t by) {
  const int64_t half = INT64_C(1) << 29;
  const int32_t length = (int32_t)by;
  const gjk2_vec to = {v.x + (int32_t)gjk_sar64(gjk_mac32(half, unit->x, length), 30),
                       v.y + (int32_t)gjk_sar64(gjk_mac32(half, unit->y, length), 30)};
  return to;
}

// Moves a deepest corner that is not across from the segment to where the body's edge spans the segment, if it is
// parallel to it. False: it is not, or lies beyond one end.
static bool move_across(const gjk2_line_query *query, const line_segment *s, gjk2_chain_aim *own) {
  const gjk2_collider *body = query->body;
  gjk2_support corner, other;
  if (gjk2_is_curved(body->shape)) {
    return false;
  }
  gjk2_hull_corner(body, gjk2_negate(s->normal), &corner);  // the last of equals counterclockwise: that towards p
  if (!gjk2_hull_neighbour(body, &corner, false, &other)) {
    return false;
  }
  const gjk2_vec at = gjk2_add(corner.offset, other.offset);
  if (gjk2_dot(other.offset, s->normal) != 0 || gjk2_dot(s->along, gjk2_sub(corner.offset, s->q)) > 0 ||
      gjk2_dot(s->along, gjk2_sub(at, s->p)) < 0) {
    return false;
  }
  // Across from p: the height is the same all along the edge.
  gjk2_unit unit;
  const int64_t core = gjk2_chain_measure(own, &unit);
  own->at = relative_moved(s->p, &unit, core);
  return true;
}

// v moved along a unit by a length, in the world.
static gjk2_vec moved(const gjk2_line_query *query, gjk2_vec v, const gjk2_unit *unit, int64_t by) {
  const gjk2_vec *centre = &query->body->centre, to = relative_moved(v, unit, by);
  const gjk2_vec world = {gjk_saturate((int64_t)centre->x + to.x), gjk_saturate((int64_t)centre->y + to.y)};
  return world;
}

// Step 2
static void add_segment(const gjk2_line_query *query, const line_segment *s) {
  const gjk2_collider *body = query->body;
  gjk2_chain_aim own;
  gjk2_manifold m;
  gjk2_collider line;
  gjk2_chain_aim_along(query->body, &s->normal, &s->p, &own);
  if (gjk2_dot(s->normal, s->p) > 0 || !is_in_reach(query, &own)) {  // the centre is behind
    return;
  }
  const bool across = lies_across(query, s, own.at) || move_across(query, s, &own);
  const int64_t core = gjk2_chain_measure(&own, &m.normal);
  const gjk_q16 radius = body->shape->convex_radius, distance = (gjk_q16)(core - radius);
  m.feature_a = 0;
  m.feature_b = 0;
  m.count = 0;
  gjk2_line_collider(s->line->p, s->line->q, &line);
  uint16_t id;
  bool level = gjk2_facing_contacts(&line, body, query->margin, -1, -1, &m, &id);
  if (across && gjk2_facing_lacks(&m, distance)) {
    const gjk2_vec point_a = moved(query, own.at, &m.normal, -core);
    const gjk2_vec point_b = moved(query, own.at, &m.normal, -(int64_t)radius);
    gjk2_facing_admit(&m, distance, &point_a, &point_b, id);
  }
  level = level || gjk2_is_curved(body->shape);
  if (m.count > 0 && !yields_at(query, s, false, &own, level) && !yields_at(query, s, true, &own, level)) {
    query->take(query->user, s->line->number, &m);
  }
}

// Step 3 for a polygon. False: no contact.
static bool meet_joint(const gjk2_line_query *query, const line_segment *s, bool at_end, gjk2_manifold *m) {
  const line_joint *joint = at_end ? &s->after : &s->before;
  const gjk2_vec v = joint->at;
  gjk2_chain_aim best, end;
  if (!find_in_wedge(query, s, at_end, &best) || !is_in_reach(query, &best)) {
    return false;
  }
  if (gjk2_dot(s->normal, v) <= 0) {  // the centre is in front
    gjk2_chain_aim_along(query->body, &s->normal, &v, &end);
    if (!gjk2_chain_is_farther(&best, &end)) {
      return false;
    }
  }
  if (may_meet_neighbour(query, s, at_end)) {
    gjk2_chain_aim_along(query->body, &joint->neighbour, &v, &end);
    if (!gjk2_chain_is_farther(&best, &end)) {
      return false;
    }
  }
  const int64_t distance = gjk2_chain_measure(&best, &m->normal) - query->body->shape->convex_radius;
  m->feature_b = best.feature;
  m->contact[0].id = best.id;
  m->contact[0].distance = (gjk_q16)distance;
  m->contact[0].point_b = moved(query, v, &m->normal, distance);
  return true;
}

// The same for a curved body: it meets the joint where turning either normal into the wedge lets it reach farther. The
// direction is that of its distance from v, or the normal next to it: it may err by more than a flat wedge is wide.
static gjk_status meet_joint_curved(const gjk2_line_query *query, gjk2_vec v, const gjk2_vec *from, const gjk2_vec *to,
                                    bool *meets, gjk2_manifold *m) {
  const gjk2_vec world = gjk2_add(v, query->body->centre);
  gjk2_collider vertex;
  gjk2_distance_result nearest;
  gjk2_chain_aim first, last;
  gjk2_chain_aim_along(query->body, from, &v, &first);
  gjk2_chain_aim_along(query->body, to, &v, &last);
  *meets = gjk2_cross(*from, gjk2_sub(first.at, v)) > 0 && gjk2_cross(gjk2_sub(last.at, v), *to) > 0;
  if (!*meets) {
    return GJK_OK;
  }
  gjk2_line_collider(world, world, &vertex);
  const gjk_status status = gjk2_signed_distance(&vertex, query->body, NULL, &nearest);
  if (status != GJK_OK && status != GJK_ERROR_CAPACITY) {
    return status;
  }
  const gjk2_vec d = {nearest.normal.x, nearest.normal.y};
  int64_t distance = nearest.distance;
  m->normal = nearest.normal;
  if (!gjk2_chain_is_in_wedge(from, to, &d)) {
    const bool behind_first = gjk2_cross(*from, d) <= 0 && gjk2_dot(*from, d) > 0;
    distance = gjk2_chain_measure(behind_first ? &first : &last, &m->normal) - query->body->shape->convex_radius;
  }
  *meets = distance <= query->margin;
  m->feature_b = 0;
  m->contact[0].id = 0;
  m->contact[0].distance = (gjk_q16)distance;
  m->contact[0].point_b = moved(query, v, &m->normal, distance);
  return GJK_OK;
}

// Step 3
static gjk_status add_joint(const gjk2_line_query *query, const line_segment *s, bool at_end) {
  const line_joint *joint = at_end ? &s->after : &s->before;
  gjk2_vec from, to;
  gjk2_manifold m;
  wedge_of(s, at_end, &from, &to);
  const bool in_front =
      gjk2_dot(s->normal, joint->at) <= 0 || (!joint->open && gjk2_dot(joint->neighbour, joint->at) <= 0);
  if (!joint->convex || !in_front || !is_in_box(query, joint->at)) {
    return GJK_OK;
  }
  bool meets = false;
  gjk_status status = GJK_OK;
  m.contact[0].id = 0;
  if (gjk2_is_curved(query->body->shape)) {
    status = meet_joint_curved(query, joint->at, &from, &to, &meets, &m);
  } else {
    meets = meet_joint(query, s, at_end, &m);
  }
  if (meets) {
    m.count = 1;
    m.feature_a = at_end ? 1 : 0;
    m.contact[0].id = (uint16_t)(m.contact[0].id | (at_end ? 256u : 0u));
    m.contact[0].point_a = gjk2_add(joint->at, query->body->centre);
    query->take(query->user, s->line->number, &m);
  }
  return status;
}

void gjk2_line_query_set(gjk2_line_query *query, const gjk2_collider *body, const gjk2_aabb *box, gjk_q16 margin) {
  const gjk2_vec *centre = &body->centre;
  query->body = body;
  query->margin = margin;
  query->reach = margin + body->shape->convex_radius;
  // Components are below 2^30.
  query->low.x = box->lower.x - centre->x - margin;
  query->low.y = box->lower.y - centre->y - margin;
  query->high.x = box->upper.x - centre->x + margin;
  query->high.y = box->upper.y - centre->y + margin;
}

gjk_status gjk2_line_contacts(const gjk2_line_query *query, const gjk2_line *line) {
  line_segment s;
  find_segment(query, line, &s);
  add_segment(query, &s);
  const gjk_status status = add_joint(query, &s, false);
  return status == GJK_OK && s.after.open ? add_joint(query, &s, true) : status;
}
