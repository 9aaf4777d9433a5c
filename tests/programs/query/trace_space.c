// Traces a search in space, by the steps of src/gjk.
//
// gjk_search is called with a limit that is one iteration higher each time. After a call:
//   LIMIT                  the vertex found is in the feature, as its last vertex
//   ENCLOSING              the same, if the call scanned for a vertex at all; else the feature alone told it
//   NEAREST, SEPARATED     the vertex found stands in the free slot, and the feature is as it was
//   NEAR                   the same, if the call scanned
#include "src/gjk/gjk_search.h"
#include "trace.h"

static void set_point(trace_point *out, gjk_vec3 v) {
  out->x[0] = v.x;
  out->x[1] = v.y;
  out->x[2] = v.z;
}

static void add_offset(trace_point *out, const gjk_collider *c, gjk_vec3 offset) {
  out->x[0] = (int64_t)c->centre.x + offset.x;
  out->x[1] = (int64_t)c->centre.y + offset.y;
  out->x[2] = (int64_t)c->centre.z + offset.z;
}

// A component of the pair's frame in LSB.
static int64_t from_frame(const gjk_iteration *it, int32_t x) {
  return it->shift < 0 ? x * (INT64_C(1) << -it->shift) : x / (INT64_C(1) << it->shift);
}

// The vertex of A - B in a slot. B's support point is found by its number; of a curved shape it is A's less w.
static void set_vertex(const trace *t, const gjk_iteration *it, const gjk_vertex *from, trace_vertex *out) {
  const gjk_shape_class *type = it->b->shape->type;
  gjk_vec3 b = {0, 0, 0};
  out->number_a = from->a.vertex;
  out->number_b = from->b;
  add_offset(&out->a, it->a, from->a.offset);
  if (type->vertex != NULL && type->vertex(it->b, from->b, &b)) {
    add_offset(&out->b, it->b, b);
  } else {
    out->b.x[0] = out->a.x[0] - from_frame(it, from->w.x);
    out->b.x[1] = out->a.x[1] - from_frame(it, from->w.y);
    out->b.x[2] = out->a.x[2] - from_frame(it, from->w.z);
  }
  trace_complete_vertex(t, out);
}

static void set_simplex(const trace *t, const gjk_iteration *it, trace_simplex *out) {
  out->count = it->simplex.count;
  for (unsigned i = 0; i < out->count; i++) {
    set_vertex(t, it, &it->simplex.slot[it->simplex.order[i]], &out->vertex[i]);
  }
}

// Records the iteration that the last call made. before: the simplex it began with.
static void add_iteration(trace *t, const gjk_iteration *it, gjk_outcome outcome, const trace_simplex *before) {
  const gjk_simplex *s = &it->simplex;
  const bool added = outcome == GJK_OUTCOME_LIMIT || outcome == GJK_OUTCOME_ENCLOSING;
  trace_iteration *out = &t->iteration[t->count];
  set_point(&out->direction, it->direction.d);
  out->rounded = !it->direction.exact;
  out->before = *before;
  set_vertex(t, it, &s->slot[s->order[added ? s->count - 1u : s->count]], &out->found);
  out->recalled = t->count >= GJK_PLAIN_ITERATIONS && !t->curved;
  t->count++;
  if (out->found.name == 0) {
    out->found.name = t->count;
  }
  set_simplex(t, it, &out->after);
}

static trace_reason reason_of(gjk_outcome outcome) {
  switch (outcome) {
    case GJK_OUTCOME_NEAREST: return TRACE_NEAREST;
    case GJK_OUTCOME_ENCLOSING: return TRACE_ENCLOSING;
    case GJK_OUTCOME_SEPARATED: return TRACE_SEPARATED;
    case GJK_OUTCOME_NEAR: return TRACE_NEAR;
    case GJK_OUTCOME_LIMIT: break;
  }
  return TRACE_LIMIT;
}

// The goal that the query of the question searches for, and the radius that it adds.
static gjk_goal goal_of(const case_question *question, int64_t *radius) {
  switch (question->ask) {
    case CASE_DISTANCE: return GJK_GOAL_DISTANCE;
    case CASE_PENETRATION: return GJK_GOAL_SIGNED;
    case CASE_WITHIN: *radius += question->within; break;
    case CASE_INTERSECT: break;
  }
  return GJK_GOAL_WITHIN;
}

void trace_space(const case_question *question, const gjk_collider *a, const gjk_collider *b, trace *out) {
  static gjk_iteration it;
  gjk_outcome outcome = GJK_OUTCOME_LIMIT;
  trace_start(out, 3, (int64_t)a->shape->convex_radius + b->shape->convex_radius);
  const gjk_goal goal = goal_of(question, &out->radius);
  if (!gjk_iteration_start(&it, a, b, goal, out->radius)) {
    out->reason = TRACE_SPHERES;
    return;
  }
  out->curved = gjk_pair_is_curved(&it);
  const unsigned asked = question->ask == CASE_WITHIN && question->iterations > 0 ? question->iterations : UINT8_MAX;
  const unsigned ceiling = gjk_search_limit(&it), limit = asked < ceiling ? asked : ceiling;
  while (outcome == GJK_OUTCOME_LIMIT && it.iterations < limit) {
    const unsigned before = it.iterations;
    trace_simplex simplex;
    set_simplex(out, &it, &simplex);
    outcome = gjk_search(&it, goal, NULL, before + 1);
    if (it.iterations > before) {
      add_iteration(out, &it, outcome, &simplex);
    }
  }
  // A closed form does not look at the radii, which the query then does.
  const bool touching =
      outcome == GJK_OUTCOME_NEAREST && goal != GJK_GOAL_SIGNED && it.radius > 0 && gjk_iteration_near(&it);
  out->reason = touching ? TRACE_NEAR : reason_of(outcome);
}
