// The depth of a pair with a curved shape: the steps of gjk2_curved_depth.h.
#include "gjk2_curved_depth.h"

#include "gjk2/penetration.h"

// Chords that await their turn.
#define WAITING 8

// How often the vertices around the foot are brought nearer to each other.
#define FOOT_STEPS 24

typedef struct arc_bounds {
  gjk2_search *s;
  gjk2_edge *edge;
  int64_t best;   // the least distance of a line, LSB, rounded up
  int64_t lower;  // of this pass's settled chords
  uint16_t iterations;
} arc_bounds;

// Step 2: the line through w across n, beside the chord's ends, is a candidate.
static void compare_line(arc_bounds *o, gjk2_vec n, const gjk2_vertex *w, const gjk2_vertex *p, const gjk2_vertex *q) {
  gjk2_length length;
  const int64_t height = gjk2_dot(n, w->w);
  gjk2_length_set(&length, n);
  const int64_t distance = height > 0 ? gjk2_round_distance(&length, GJK2_ROUND_UP, (uint64_t)height) : 0;
  if (distance < o->best) {
    o->best = distance;
    gjk2_copy_length(&o->edge->length, &length);
    o->edge->height = height > 0 ? height : 0;
    gjk2_copy_vertex(&o->edge->p, p);
    gjk2_copy_vertex(&o->edge->q, q);
    o->s->d = n;
  }
}

static bool chord_gains_nothing(gjk2_vec n, const gjk2_vertex *p, const gjk2_vertex *x) {
  return gjk2_dot(n, gjk2_sub(x->w, p->w)) <= (int64_t)(gjk2_norm1(n) >> 3);
}

// Settles the chord if it can be: step 1, and step 3 for x, the farthest point across it.
typedef enum arc_state { ARC_SETTLED, ARC_OPEN, ARC_SPENT } arc_state;

static arc_state settle(arc_bounds *o, const gjk2_vertex *p, const gjk2_vertex *q, int64_t tolerance, gjk2_vertex *x) {
  const gjk2_vec n = gjk2_outward(gjk2_sub(q->w, p->w));
  if ((n.x | n.y) == 0) {
    return ARC_SETTLED;
  }
  const int64_t height = gjk2_cross(p->w, q->w);
  gjk2_length length;
  gjk2_length_set(&length, n);
  const int64_t distance = height > 0 ? gjk2_round_distance(&length, GJK2_ROUND_DOWN, (uint64_t)height) : 0;
  if (distance + tolerance < o->best) {
    if (o->iterations >= GJK2_DEPTH_ITERATIONS_MAX) {
      return ARC_SPENT;
    }
    o->iterations++;
    gjk2_search_scan(o->s, n, x);
    compare_line(o, n, x, p, q);
    if (!chord_gains_nothing(n, p, x) && distance + tolerance < o->best) {
      return ARC_OPEN;
    }
  }
  o->lower = distance < o->lower ? distance : o->lower;
  return ARC_SETTLED;
}

// Steps 1 to 3 for the arc from start to end. False: out of iterations.
static bool settle_arc(arc_bounds *o, const gjk2_vertex *start, const gjk2_vertex *end, int64_t tolerance) {
  gjk2_vertex waiting[WAITING], p, x;
  unsigned count = 1;
  gjk2_copy_vertex(&p, start);
  gjk2_copy_vertex(&waiting[0], end);
  while (count > 0) {  // each turn settles a chord or takes an iteration
    const arc_state found = settle(o, &p, &waiting[count - 1], tolerance, &x);
    if (found == ARC_SPENT) {
      return false;
    }
    if (found == ARC_SETTLED) {
      gjk2_copy_vertex(&p, &waiting[--count]);
    } else {
      count -= count == WAITING ? 1u : 0u;
      gjk2_copy_vertex(&waiting[count++], &x);
    }
  }
  return true;
}

// Brings p and q, on both sides of the origin's foot along d, nearer to each other and to the surface.
static void approach_foot(arc_bounds *o) {
  gjk2_edge *edge = o->edge;
  gjk2_vertex x;
  for (int i = 0; i < FOOT_STEPS; i++) {  // not reached: the ceiling
    const gjk2_vec n = gjk2_outward(gjk2_sub(edge->q.w, edge->p.w));
    if ((n.x | n.y) == 0) {
      return;
    }
    gjk2_search_scan(o->s, n, &x);
    if (chord_gains_nothing(n, &edge->p, &x)) {
      return;
    }
    if (gjk2_cross(o->s->d, x.w) > 0) {
      gjk2_copy_vertex(&edge->q, &x);
    } else {
      gjk2_copy_vertex(&edge->p, &x);
    }
  }
}

bool gjk2_curved_depth(gjk2_search *s, gjk2_edge *edge, int64_t *lower, uint16_t *iterations) {
  static const int8_t axis[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  const int32_t unit = INT32_C(1) << 29;
  arc_bounds o = {s, edge, INT64_MAX, 0, *iterations};
  gjk2_vertex *corner = s->slot;  // the simplex is not needed any more
  for (int i = 0; i < 4; i++) {
    const gjk2_vec d = {axis[i][0] * unit, axis[i][1] * unit};
    gjk2_search_scan(s, d, &corner[i]);
  }
  for (int i = 0; i < 4; i++) {
    const gjk2_vec d = {axis[i][0] * unit, axis[i][1] * unit};
    compare_line(&o, d, &corner[i], &corner[(i + 3) & 3], &corner[(i + 1) & 3]);
  }
  o.iterations = (uint16_t)(o.iterations + 4);
  *lower = 0;
  bool settled_all = true;
  // At most 16 passes, the last with a tolerance of 1.
  for (int64_t tolerance = (o.best >> 2) + 1; tolerance > 0 && settled_all;
       tolerance = tolerance > 4 ? tolerance >> 2 : (tolerance > 1 ? 1 : 0)) {
    o.lower = o.best;
    for (int i = 0; i < 4 && settled_all; i++) {
      settled_all = settle_arc(&o, &corner[i], &corner[(i + 1) & 3], tolerance);
    }
    *lower = settled_all ? o.lower : *lower;
  }
  *iterations = o.iterations;
  approach_foot(&o);
  return settled_all;
}
