// A segment of ground with its neighbours, whatever the ground is made of.
#ifndef GJK2_SRC_LINE_H
#define GJK2_SRC_LINE_H

#include "gjk2/cast.h"
#include "gjk2/chain.h"
#include "gjk2_class.h"

// Its outside is to the right of the way from p to q.
typedef struct gjk2_line {
  uint32_t number;
  gjk2_vec p, q;           // world, not the same
  gjk2_vec before, after;  // the neighbours at p and at q, each from its first vertex to its last; not of an open end
  bool open_before, open_after;
} gjk2_line;

// Makes a collider of the segment from p to q; they may be the same. Its vertices are p, q and q again, exact.
// Pre: at most GJK2_RADIUS_MAX apart along each axis.
void gjk2_line_collider(gjk2_vec p, gjk2_vec q, gjk2_collider *out);

// As gjk2_cast of such a collider and a body.
gjk_status gjk2_line_cast(const gjk2_collider *line, const gjk2_collider *body, const gjk2_cast_path *path,
                          gjk2_cast_result *out);

// A body that is asked about segments, one after the other.
typedef struct gjk2_line_query {
  const gjk2_collider *body;
  gjk_q16 margin;
  int32_t reach;       // margin plus the body's convex radius
  gjk2_vec low, high;  // the body's box, enlarged by margin, relative to its centre
  // Is given each manifold that is found, with the number of its segment.
  void (*take)(void *user, uint32_t number, const gjk2_manifold *m);
  void *user;
} gjk2_line_query;

// Sets all but take and user. box: of the body. Pre: margin is from 0 to GJK2_RADIUS_MAX.
void gjk2_line_query_set(gjk2_line_query *query, const gjk2_collider *body, const gjk2_aabb *box, gjk_q16 margin);

// The contacts of the body with a segment, the joint where it begins, and an open end, as gjk2_chain_contacts has them.
// OK or ITERATION_LIMIT. Pre: a segment that may be near; its ends are below 3 2^28 from the body's centre along an axis.
gjk_status gjk2_line_contacts(const gjk2_line_query *query, const gjk2_line *line);

// The contacts that were found so far.
typedef struct gjk2_line_list {
  gjk2_chain_contact *out;
  uint16_t capacity;
  uint16_t count;
  bool overflows;
} gjk2_line_list;

// Appends to a gjk2_line_list. When there is no room the least deep ones go, of equals the last.
void gjk2_line_list_take(void *list, uint32_t number, const gjk2_manifold *m);

// The least distance of a manifold's contacts. Pre: it has one.
static inline gjk_q16 gjk2_line_least(const gjk2_manifold *m) {
  const gjk_q16 first = m->contact[0].distance;
  return m->count < 2 || first < m->contact[1].distance ? first : m->contact[1].distance;
}

#endif
