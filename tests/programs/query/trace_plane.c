// Traces a search in the plane, by the steps of src/plane/gjk2_search.c.
//
// gjk2_search_run is called with a limit that is one iteration higher each
// time. After a call:
//   LIMIT, ENCLOSING     the vertex found is the one of the simplex that lies
//   farthest along the direction of the scan;
//                        if the call did not scan, the feature alone told it
//   NEAREST, SEPARATED   the vertex found is the spare one, and the feature is
//   as it was NEAR                 the call did not scan
#include <string.h>

#include "src/plane/gjk2_search.h"
#include "trace.h"

static int64_t in_lsb(const gjk2_search *s, int32_t x) {
  return x * (INT64_C(1) << s->far);
}

// B's support point is found by its number; of a curved shape it is A's less w.
static void set_vertex(const trace *t, const gjk2_search *s, const gjk2_vertex *from, trace_vertex *out) {
  const gjk2_shape_class *type = s->b->shape->type;
  gjk2_vec b = {0, 0};
  memset(out, 0, sizeof *out);
  out->number_a = from->a.vertex;
  out->number_b = from->b.vertex;
  out->a.x[0] = (int64_t)s->a->centre.x + from->a.offset.x;
  out->a.x[1] = (int64_t)s->a->centre.y + from->a.offset.y;
  if (type->vertex != NULL && type->vertex(s->b, from->b.vertex, &b)) {
    out->b.x[0] = (int64_t)s->b->centre.x + b.x;
    out->b.x[1] = (int64_t)s->b->centre.y + b.y;
  } else {
    out->b.x[0] = out->a.x[0] - in_lsb(s, from->w.x);
    out->b.x[1] = out->a.x[1] - in_lsb(s, from->w.y);
  }
  trace_complete_vertex(t, out);
}

static void set_simplex(const trace *t, const gjk2_search *s, trace_simplex *out) {
  out->count = s->count;
  for (unsigned i = 0; i < out->count; i++) {
    set_vertex(t, s, gjk2_search_vertex(s, i), &out->vertex[i]);
  }
}

// The vertex that the last scan found.
static const gjk2_vertex *found_vertex(const gjk2_search *s, gjk2_outcome outcome) {
  if (outcome == GJK2_OUTCOME_LIMIT || outcome == GJK2_OUTCOME_ENCLOSING) {
    for (unsigned i = 0; i < s->count; i++) {
      const gjk2_vertex *v = gjk2_search_vertex(s, i);
      if (gjk2_dot(s->d, v->w) == s->along) {
        return v;
      }
    }
  }
  return s->spare;
}

// Records the iteration that the last call made. before: the simplex it began
// with.
static void add_iteration(trace *t, const gjk2_search *s, gjk2_outcome outcome, const trace_simplex *before) {
  trace_iteration *out = &t->iteration[t->count];
  memset(out, 0, sizeof *out);
  out->direction.x[0] = s->d.x;
  out->direction.x[1] = s->d.y;
  out->before = *before;
  set_vertex(t, s, found_vertex(s, outcome), &out->found);
  t->count++;
  if (out->found.name == 0) {
    out->found.name = t->count;
  }
  set_simplex(t, s, &out->after);
}

// The goal that the query of the question searches for, and the radius that it
// adds.
static gjk2_goal goal_of(const case_question *question, int64_t *radius) {
  switch (question->ask) {
    case CASE_DISTANCE: return GJK2_GOAL_DISTANCE;
    case CASE_PENETRATION: return GJK2_GOAL_SIGNED;
    case CASE_WITHIN: *radius += question->within; break;
    case CASE_INTERSECT: break;
  }
  return GJK2_GOAL_WITHIN;
}

static trace_reason reason_of(gjk2_outcome outcome) {
  switch (outcome) {
    case GJK2_OUTCOME_NEAREST: return TRACE_NEAREST;
    case GJK2_OUTCOME_ENCLOSING: return TRACE_ENCLOSING;
    case GJK2_OUTCOME_SEPARATED: return TRACE_SEPARATED;
    case GJK2_OUTCOME_NEAR: return TRACE_NEAR;
    case GJK2_OUTCOME_LIMIT: break;
  }
  return TRACE_LIMIT;
}

// The iterations of the query itself, which runs to the limit in one go.
static unsigned whole_search(const gjk2_collider *a, const gjk2_collider *b, gjk2_goal goal, int64_t radius,
                             uint32_t limit) {
  static gjk2_search s;
  (void)gjk2_search_start(&s, a, b, false, (uint32_t)radius);
  gjk2_search_aim(&s, NULL);
  s.walks = s.walks && limit == gjk2_search_limit(&s);
  (void)gjk2_search_run(&s, goal, limit);
  return s.iterations;
}

// The same of the query that is asked, which may take a shorter way.
static unsigned whole_query(const case_question *question, const gjk2_collider *a, const gjk2_collider *b,
                            gjk2_goal goal, int64_t radius, uint32_t limit) {
  gjk2_distance_result gap;
  gjk2_within_result within;
  gjk2_decision decision;
  switch (question->ask) {
    case CASE_DISTANCE: return gjk2_distance(a, b, NULL, &gap) == GJK_OK ? gap.iterations : limit;
    case CASE_INTERSECT: return gjk2_intersect(a, b, NULL, &decision) == GJK_OK ? decision.iterations : limit;
    case CASE_WITHIN:
      return gjk2_within_until(a, b, question->within, (uint8_t)question->iterations, NULL, &within) == GJK_OK
                 ? within.decision.iterations
                 : limit;
    case CASE_PENETRATION: break;
  }
  return whole_search(a, b, goal, radius, limit);
}

void trace_plane(const case_question *question, const gjk2_collider *a, const gjk2_collider *b, trace *out) {
  static gjk2_search s;
  gjk2_outcome outcome = GJK2_OUTCOME_LIMIT;
  trace_start(out, 2, (int64_t)a->shape->convex_radius + b->shape->convex_radius);
  const gjk2_goal goal = goal_of(question, &out->radius);
  if (!gjk2_search_start(&s, a, b, goal == GJK2_GOAL_WITHIN, (uint32_t)out->radius)) {
    out->reason = TRACE_CIRCLES;
    return;
  }
  gjk2_search_aim(&s, NULL);
  s.walks = false;
  out->curved = s.curved;
  const uint32_t ceiling = gjk2_search_limit(&s);
  const uint32_t asked = question->ask == CASE_WITHIN && question->iterations > 0 ? question->iterations : ceiling;
  const uint32_t limit = asked < ceiling ? asked : ceiling;
  while (outcome == GJK2_OUTCOME_LIMIT && s.iterations < limit && out->count < TRACE_ITERATIONS_MAX) {
    const unsigned before = s.iterations;
    trace_simplex simplex;
    set_simplex(out, &s, &simplex);
    outcome = gjk2_search_run(&s, goal, before + UINT32_C(1));
    if (s.iterations > before) {
      add_iteration(out, &s, outcome, &simplex);
    }
  }
  out->reason = reason_of(outcome);
  const unsigned whole = whole_query(question, a, b, goal, out->radius, limit);
  out->walk = whole != s.iterations ? whole : 0;
}
