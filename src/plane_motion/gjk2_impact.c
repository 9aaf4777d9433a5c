// The time of impact in the plane: conservative advancement with bounds along one direction.
//
//   1. Pose both shapes at the fraction, and measure their distance.
//   2. Stop if it is less than margin + tolerance: a hit.
//   3. The room is what it exceeds the margin by, less all that rounding may have added to it.
//   4. Bound by how much of the room each fraction of the way takes along the normal (gjk2_impact_bound.c). No contact comes
//      before the room is used up.
//   5. Advance so far. If that is beyond the end, there is no impact.
// Each step uses the room up to its bound, like Newton's iteration from below.
#include "gjk2_impact.h"

#include "../plane/gjk2_report.h"

// What may lie between the motion and what is measured of it, LSB Q8, beside the rotation's error and that of the normal:
//   vertices and half axes    3/4 sqrt(2) of each shape
//   positions                 1/2 sqrt(2) of each shape
//   the distance              1/2; of curved shapes 2 and each support point within 1 per component, instead of vertices
#define PLANE_IMPACT_ERROR 1040
#define PLANE_IMPACT_CURVED 384

// |v|, at most 1/8 and 1 too long. Any components.
static int64_t plane_length_above(const gjk2_vec *v) {
  const int64_t x = gjk_magnitude32(v->x), y = gjk_magnitude32(v->y);
  return x > y ? x + y / 2 + 1 : y + x / 2 + 1;  // sqrt(1 + t^2) <= 1 + t / 2 for 0 <= t <= 1
}

static gjk_status plane_mover_set(gjk2_mover *m, const gjk2_collider *c, const gjk2_motion *motion) {
  const gjk_status status = gjk2_sweep_set(&m->sweep, motion);
  if (status != GJK_OK) {
    return status;
  }
  m->posed.shape = c->shape;
  m->posed.buffer = NULL;
  gjk2_copy(&m->posed.local_centre, &c->local_centre);
  m->posed.core_radius = c->core_radius;
  m->posed.radius = c->radius;
  m->posed.count = c->count;
  m->posed.ordered = c->ordered;
  m->posed.state = GJK2_STATE_INITIALISED;
  const gjk2_vec *centre = &m->posed.local_centre;
  m->reach = (int64_t)c->core_radius + ((centre->x | centre->y) != 0 ? plane_length_above(centre) : 0);
  m->arc = m->sweep.angle != 0 ? gjk2_impact_arc(m->sweep.angle, m->reach) : 0;
  m->point = c->shape->type->count == 1;
  if (gjk2_impact_is_point(m)) {  // what gjk2_collider_pose makes of it
    const gjk2_vec none = {0, 0};
    gjk2_copy(&m->posed.frame[0], &none);
    gjk2_copy(&m->posed.frame[1], &none);
    m->posed.fraction[0] = 0;
    m->posed.fraction[1] = 0;
    m->posed.state = GJK2_STATE_POSED;
  }
  return GJK_OK;
}

static gjk_status plane_mover_pose(gjk2_mover *m, gjk_q30 fraction) {
  if (gjk2_impact_is_point(m)) {
    gjk2_sweep_place(&m->sweep, fraction, &m->pose.position);
    gjk2_copy(&m->posed.position, &m->pose.position);
    gjk2_copy(&m->posed.centre, &m->pose.position);
    return GJK_OK;
  }
  gjk2_sweep_pose(&m->sweep, fraction, &m->pose);
  return gjk2_collider_pose(&m->posed, &m->pose);
}

#if GJK2_IMPACT_TOUCHES
// A vertex of the feature. Of points the offsets stay 0.
static inline void plane_impact_name(const gjk2_collider *c, uint16_t number, gjk2_support *out) {
  out->vertex = number;
  if (c->count > 1) {
    (void)c->shape->type->vertex(c, number, &out->offset);
  } else {
    out->offset.x = 0;
    out->offset.y = 0;
  }
}

// Step 1 of a pair whose gap needs no search. Segments that are parallel are left to it: it ends at a feature of its own.
static inline bool plane_impact_touch(gjk2_impact *s) {
  const gjk2_collider *a = &s->a.posed, *b = &s->b.posed;
  gjk2_search *search = &s->search;
  const gjk2_certificate *names = &s->gap.certificate;
  if ((a->count > 1 && b->count > 1 && gjk2_cross(a->frame[0], b->frame[0]) == 0) ||
      !gjk2_touch_without_search(a, b, GJK2_TOUCH_GAP, &s->gap)) {
    return false;
  }
  s->open = false;
  s->nearest = !s->gap.intersecting;
  search->count = names->count;
  search->apex = search->first = &search->slot[0];
  search->last = &search->slot[1];
  for (unsigned i = 0; i < names->count; i++) {
    plane_impact_name(a, names->a[i], &search->slot[i].a);
    plane_impact_name(b, names->b[i], &search->slot[i].b);
  }
  return true;
}
#endif

// Step 1 for posed shapes. Of nearest features the points are left for later.
static void plane_impact_gap(gjk2_impact *s) {
  const gjk2_collider *a = &s->a.posed, *b = &s->b.posed;
  gjk2_search *search = &s->search;
  gjk2_distance_result *gap = &s->gap;
#if GJK2_IMPACT_TOUCHES
  s->touched = s->close && plane_impact_touch(s);
  if (s->touched) {
    return;
  }
#endif
  (void)gjk2_search_start(search, a, b, false, (uint32_t)(a->shape->convex_radius + b->shape->convex_radius));
  gjk2_outcome outcome = gjk2_search_run(search, GJK2_GOAL_DISTANCE, GJK2_NO_LIMIT);
  s->nearest = outcome == GJK2_OUTCOME_NEAREST && gjk2_search_is_exact(search);
  if (outcome == GJK2_OUTCOME_LIMIT) {
    outcome = gjk2_distance_settle(search, gap);
  }
  s->open = outcome == GJK2_OUTCOME_LIMIT;
  if (!s->nearest) {
    if (s->open) {
      gjk2_distance_stop(search, gap);
    } else {
      gjk2_distance_report(search, outcome, NULL, gap);
    }
    return;
  }
  gjk2_length length;
  gjk2_normal_set(&gap->normal, &length, &search->d);
  const int32_t distance =
      (int32_t)gjk2_round_distance(&length, GJK2_ROUND_NEAREST, (uint64_t)-search->base) - search->radius;
  gap->distance = distance > 0 ? distance : 0;
  gap->lower = gap->distance;
  gap->upper = gap->distance;
  gap->intersecting = false;
  gap->saturated = false;
}

// Step 1. Statuses: OK, RANGE, ROTATION.
static gjk_status plane_impact_measure(gjk2_impact *s, gjk_q30 fraction) {
  gjk_status status = plane_mover_pose(&s->a, fraction);
  status = status == GJK_OK ? plane_mover_pose(&s->b, fraction) : status;
  if (status == GJK_OK) {
    plane_impact_gap(s);
  }
  return status;
}

// Is the gap at most the margin?
static bool plane_is_at_margin(const gjk2_impact *s) {
  const gjk_q16 margin = s->setup->margin;
  return s->gap.intersecting || (margin > 0 && s->gap.lower <= margin);
}

static void plane_impact_report(gjk2_impact *s, gjk_q30 lower, gjk_q30 upper, gjk2_impact_result *out) {
  out->hit = true;
  out->overlap = upper == 0 && plane_is_at_margin(s);
  out->lower = lower;
  out->upper = upper;
  out->distance = s->gap.distance;
  if (!s->gap.intersecting) {
#if GJK2_IMPACT_TOUCHES
    if (s->touched) {
      (void)gjk2_touch_without_search(&s->a.posed, &s->b.posed, GJK2_TOUCH_POINTS, &s->gap);
      s->nearest = false;
    }
#endif
    if (s->nearest) {
      gjk2_distance_report(&s->search, GJK2_OUTCOME_NEAREST, NULL, &s->gap);
    }
    gjk2_copy(&out->point_a, &s->gap.point_a);
    gjk2_copy(&out->point_b, &s->gap.point_b);
    out->normal.x = s->gap.normal.x;
    out->normal.y = s->gap.normal.y;
  }
}

// Writes the pose at lower of a mover that is posed at a fraction.
static void plane_mover_end(const gjk2_mover *m, gjk_q30 posed, gjk_q30 lower, gjk2_pose *out) {
  if (lower != posed || gjk2_impact_is_point(m)) {
    gjk2_sweep_pose(&m->sweep, lower, out);
    return;
  }
  gjk2_copy(&out->position, &m->pose.position);
  out->rotation.c = m->pose.rotation.c;
  out->rotation.s = m->pose.rotation.s;
}

static void plane_impact_end(const gjk2_impact *s, gjk_q30 posed, gjk_q30 lower, uint32_t iterations,
                             gjk2_impact_result *out) {
  plane_mover_end(&s->a, posed, lower, &out->pose_a);
  plane_mover_end(&s->b, posed, lower, &out->pose_b);
  out->iterations = (uint8_t)iterations;
}

static void plane_impact_none(gjk_q30 lower, gjk2_impact_result *out) {
  out->hit = false;
  out->overlap = false;
  out->lower = lower;
  out->upper = GJK_Q30_ONE;
}

// Steps 1 to 5. Pre: the motions are set.
static gjk_status plane_impact_run(gjk2_impact *s, gjk2_impact_result *out) {
  const uint32_t most = s->setup->iterations != 0 ? s->setup->iterations : GJK_ITERATIONS_MAX;
  gjk_q30 lower = 0, at = 0;
  gjk_status result = GJK_ERROR_ITERATION_LIMIT;
  uint32_t i = 0;
  while (i < most) {
    const gjk_status status = plane_impact_measure(s, at);
    if (status != GJK_OK) {
      return status;
    }
    i++;
    if (s->gap.intersecting || s->gap.upper < (int64_t)s->setup->margin + s->setup->tolerance) {  // Step 2
      lower = plane_is_at_margin(s) ? lower : at;
      plane_impact_report(s, lower, at, out);
      plane_impact_end(s, at, lower, i, out);
      return GJK_OK;
    }
    lower = s->open && s->gap.lower <= s->setup->margin ? lower : at;
    if (s->open) {
      break;
    }
    const int64_t step = at == GJK_Q30_ONE ? 1 : gjk2_impact_advance(s);
    if (step > GJK_Q30_ONE - at) {  // Step 5
      lower = GJK_Q30_ONE;
      result = GJK_OK;
      break;
    }
    if (step == 0) {
      break;
    }
    at += (gjk_q30)step;
  }
  plane_impact_none(lower, out);
  plane_impact_end(s, at, lower, i, out);
  return result;
}

static bool plane_is_known(const gjk2_collider *c) {
  return c->state == GJK2_STATE_INITIALISED || c->state == GJK2_STATE_POSED;
}

static gjk_status plane_impact_check(const gjk2_collider *a, const gjk2_collider *b, const gjk2_impact_setup *setup) {
  if (!plane_is_known(a) || !plane_is_known(b)) {
    return GJK_ERROR_UNINITIALISED;
  }
  if (setup->margin < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  return setup->tolerance < GJK2_IMPACT_TOLERANCE_MIN ? GJK_ERROR_RANGE : GJK_OK;
}

gjk_status gjk2_time_of_impact(const gjk2_collider *a, const gjk2_motion *motion_a, const gjk2_collider *b,
                               const gjk2_motion *motion_b, const gjk2_impact_setup *setup, gjk2_impact_result *out) {
  gjk2_impact s;
  if (a == NULL || motion_a == NULL || b == NULL || motion_b == NULL || setup == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_status status = plane_impact_check(a, b, setup);
  status = status == GJK_OK ? plane_mover_set(&s.a, a, motion_a) : status;
  status = status == GJK_OK ? plane_mover_set(&s.b, b, motion_b) : status;
  if (status != GJK_OK) {
    return status;
  }
  s.setup = setup;
#if GJK2_IMPACT_TOUCHES
  // Their classes have 1, 2 and 4 vertices, triangles 3, all others none.
  s.close = (0x16u >> ((unsigned)a->shape->type->count * b->shape->type->count) & 1u) != 0;
#endif
  s.error = PLANE_IMPACT_ERROR + ((s.a.reach + s.b.reach) * 11 >> 23) +
            ((int64_t)(a->core_radius + b->core_radius) * 3 >> 23);
  s.half = gjk2_impact_step(INT64_C(1) << 23, (int64_t)((s.a.sweep.angle + s.b.sweep.angle + 2) >> 8) + 1);
  s.error += gjk2_is_curved(a->shape) || gjk2_is_curved(b->shape) ? PLANE_IMPACT_CURVED : 0;
  return plane_impact_run(&s, out);
}
