#include "clearance.h"

#include <math.h>

typedef struct interval {
  gjk_q30 from, to;
  int64_t gap_from, gap_to;
} interval;

static bool measure(clearance *c, gjk_q30 fraction, int64_t *out) {
  c->at = fraction;
  c->measured++;
  const bool found = c->gap(c->user, fraction, out);
  c->last = found ? *out : 0;
  return found;
}

clearance_outcome clearance_search(clearance *c, gjk_q30 limit) {
  interval stack[40];
  int depth = 1;
  interval whole = {0, limit, 0, 0};
  c->measured = 0;
  if (limit == 0) {
    return CLEARANCE_PROVEN;
  }
  if (!measure(c, limit, &whole.gap_to) || !measure(c, 0, &whole.gap_from)) {
    return CLEARANCE_OPEN;
  }
  if ((double)whole.gap_from < c->least) {
    return CLEARANCE_TOUCHED;
  }
  stack[0] = whole;
  while (depth > 0) {
    const interval now = stack[--depth];
    const double apart = (double)(now.gap_from + now.gap_to) - c->speed * ((double)now.to - now.from) / GJK_Q30_ONE;
    int64_t gap;
    if (apart / 2 > c->between || now.to - now.from <= 1) {
      continue;
    }
    const gjk_q30 middle = now.from + (now.to - now.from) / 2;
    if (c->measured >= c->most || !measure(c, middle, &gap)) {
      return CLEARANCE_OPEN;
    }
    if ((double)gap < c->least) {
      return CLEARANCE_TOUCHED;
    }
    const interval left = {now.from, middle, now.gap_from, gap}, right = {middle, now.to, gap, now.gap_to};
    stack[depth++] = right;  // intervals halve, so at most 31 deep
    stack[depth++] = left;
  }
  return CLEARANCE_PROVEN;
}

static double length_of(double x, double y, double z) {
  return sqrt(x * x + y * y + z * z);
}

double clearance_reach(const gjk_collider *c) {
  return length_of(c->local_centre.x, c->local_centre.y, c->local_centre.z) + c->radius + 2;
}

double clearance2_reach(const gjk2_collider *c) {
  return length_of(c->local_centre.x, c->local_centre.y, 0) + c->radius + 2;
}

// The angle over the whole way, radians, rounded up.
static double angle_of(const gjk_motion *m) {
  if ((m->spin.x | m->spin.y | m->spin.z) != 0) {
    return length_of(m->spin.x, m->spin.y, m->spin.z) / 65536 * (1 + 1e-9);
  }
  const gjk_quat *p = &m->from.rotation, *q = &m->to.rotation;
  const double dot = (double)p->x * q->x + (double)p->y * q->y + (double)p->z * q->z + (double)p->w * q->w;
  const double cosine = fabs(dot) / (double)(UINT64_C(1) << 60);
  return 2 * acos(cosine < 1 ? cosine : 1) + 1e-3;  // quaternions may be off by 2^-15 of their length
}

static double angle2_of(const gjk2_motion *m) {
  if (m->spin != 0) {
    return fabs((double)m->spin) / 65536 * (1 + 1e-9);
  }
  const gjk2_rotation *p = &m->from.rotation, *q = &m->to.rotation;
  const double sine = (double)p->c * q->s - (double)p->s * q->c, cosine = (double)p->c * q->c + (double)p->s * q->s;
  return fabs(atan2(sine, cosine)) + 1e-6;
}

double clearance_speed(const gjk_motion *a, double reach_a, const gjk_motion *b, double reach_b) {
  const gjk_vec3 *p = &a->from.position, *q = &a->to.position, *u = &b->from.position, *v = &b->to.position;
  const double x = ((double)v->x - u->x) - ((double)q->x - p->x), y = ((double)v->y - u->y) - ((double)q->y - p->y),
               z = ((double)v->z - u->z) - ((double)q->z - p->z);
  return length_of(x, y, z) + angle_of(a) * reach_a + angle_of(b) * reach_b;
}

double clearance2_speed(const gjk2_motion *a, double reach_a, const gjk2_motion *b, double reach_b) {
  const gjk2_vec *p = &a->from.position, *q = &a->to.position, *u = &b->from.position, *v = &b->to.position;
  const double x = ((double)v->x - u->x) - ((double)q->x - p->x), y = ((double)v->y - u->y) - ((double)q->y - p->y);
  return length_of(x, y, 0) + angle2_of(a) * reach_a + angle2_of(b) * reach_b;
}
