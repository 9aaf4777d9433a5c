// Names and prints what a search did.
#include "trace.h"

#include <string.h>

// A word, and a sentence.
static const char *const reasons[][2] = {
    [TRACE_NEAREST] = {"nearest", "no vertex of A - B is nearer to the origin than the simplex"},
    [TRACE_ENCLOSING] = {"enclosing", "the origin lies in the simplex, so A and B share a point"},
    [TRACE_SEPARATED] = {"separated", "all of A - B lies beyond the origin, along the direction"},
    [TRACE_NEAR] = {"near", "the simplex is as near to the origin as was asked"},
    [TRACE_LIMIT] = {"limit", "the iterations did not settle it"},
    [TRACE_SPHERES] = {"spheres", "the bounding spheres are apart"},
    [TRACE_CIRCLES] = {"circles", "the bounding circles are apart"}};

void trace_start(trace *t, unsigned dimensions, int64_t radius) {
  memset(t, 0, sizeof *t);
  t->dimensions = dimensions;
  t->radius = radius;
}

const char *trace_reason_text(const trace *t) {
  return reasons[t->reason][1];
}

void trace_complete_vertex(const trace *t, trace_vertex *vertex) {
  for (int k = 0; k < 3; k++) {
    vertex->w.x[k] = vertex->a.x[k] - vertex->b.x[k];
  }
  vertex->name = 0;
  for (unsigned i = t->count; i > 0; i--) {
    const trace_vertex *earlier = &t->iteration[i - 1].found;
    const bool same = earlier->number_a == vertex->number_a && earlier->number_b == vertex->number_b;
    if (same && memcmp(&earlier->w, &vertex->w, sizeof vertex->w) == 0) {
      vertex->name = earlier->name;
    }
  }
}

void trace_simplex_text(const trace_simplex *simplex, char *text, size_t size) {
  size_t length = 0;
  snprintf(text, size, "-");
  for (unsigned i = 0; i < simplex->count && length < size; i++) {
    const trace_vertex *v = &simplex->vertex[i];
    const char *comma = i > 0 ? "," : "";
    length +=
        (size_t)(v->name > 0 ? snprintf(text + length, size - length, "%sw%u", comma, v->name)
                             : snprintf(text + length, size - length, "%sA%u-B%u", comma, v->number_a, v->number_b));
  }
}

static void print_point(FILE *file, const trace *t, const char *name, const trace_point *p) {
  fprintf(file, " %s=", name);
  for (unsigned k = 0; k < t->dimensions; k++) {
    fprintf(file, "%s%lld", k > 0 ? "," : "", (long long)p->x[k]);
  }
}

static void print_support(FILE *file, const trace *t, char letter, unsigned number, const trace_point *p) {
  char name[24] = {letter, '\0'};
  if (!t->curved) {
    snprintf(name, sizeof name, "%c%u", letter, number);
  }
  print_point(file, t, name, p);
}

void trace_print(FILE *file, const trace *t) {
  for (unsigned i = 0; i < t->count; i++) {
    const trace_iteration *it = &t->iteration[i];
    char name[16], before[64], after[64];
    snprintf(name, sizeof name, "w%u", it->found.name);
    trace_simplex_text(&it->before, before, sizeof before);
    trace_simplex_text(&it->after, after, sizeof after);
    fprintf(file, "  iteration %u", i + 1);
    print_point(file, t, it->rounded ? "rounded" : "d", &it->direction);
    print_support(file, t, 'A', it->found.number_a, &it->found.a);
    print_support(file, t, 'B', it->found.number_b, &it->found.b);
    print_point(file, t, name, &it->found.w);
    fprintf(file, " before=%s after=%s%s\n", before, after, it->recalled ? " recalled" : "");
  }
  if (t->walk > 0) {
    fprintf(file, "  walk %u: the query takes a shorter way, along the border of A - B or by a closed form\n", t->walk);
  }
  fprintf(file, "  stop %s: %s\n", reasons[t->reason][0], reasons[t->reason][1]);
}
