// Checks depths and contacts of a pair against the exact oracle and against each other.
#include "overlap.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "exact/depth.h"
#include "parts_answers.h"

// Enough for the product of the vertices of the largest hulls, and for most curved pairs.
#define CELLS GJK_EPA_CELLS(24 * 24)

// Most directions for brute force: a fraction of a millisecond.
#define QUICK_DIRECTIONS 1500

// How far, in LSB, two answers about curved shapes may differ, each within 3; and a point of one answer from another
// answer.
#define CURVED_APART 6

// A pair and its answers while they are judged.
typedef struct subject {
  const gjk_collider *a, *b;
  bool certain;  // polytopes and their rounded forms: exact
  bool far;
  gjk_penetration_result depth;  // in all the room there is
  gjk_status status;
  char *why;
  size_t n;
} subject;

static gjk_epa_cell cells[CELLS];
static const gjk_workspace roomy = {cells, CELLS};

static int64_t magnitude(int64_t x) {
  return x < 0 ? -x : x;
}

static bool is_answer(const subject *s, gjk_status status) {
  return status == GJK_OK || (!s->certain && (status == GJK_ERROR_CAPACITY || status == GJK_ERROR_ITERATION_LIMIT));
}

// Are both the same answer, to within what curved shapes leave open?
static bool is_depth(const subject *s, const gjk_penetration_result *other) {
  return other->intersecting == s->depth.intersecting &&
         (!other->intersecting || s->depth.depth == other->depth || !s->certain);
}

static const char *check_depth(subject *s) {
  exact_overlap overlap;
  gjk_penetration_result *r = &s->depth;
  if (s->certain && !exact_check_penetration(s->a, s->b, r, s->why, s->n)) {
    return "gjk_penetration";
  }
  if (s->certain && gjk_check_penetration(s->a, s->b, r) != GJK_OK) {
    return "gjk_check_penetration";
  }
  if (s->certain && !s->far && exact_depth_work(s->a, s->b) <= QUICK_DIRECTIONS &&
      exact_overlap_find(s->a, s->b, &overlap)) {
    snprintf(s->why, s->n, "by brute force %d, depth %ld", overlap.intersecting, (long)overlap.depth);
    if (overlap.intersecting != r->intersecting || (r->intersecting && overlap.depth != r->depth)) {
      return "depth, by brute force";
    }
  }
  const bool bounded = r->lower >= 0 && r->lower <= r->depth && r->depth <= r->upper;
  const bool closed = !s->certain || (r->lower == r->depth && r->depth == r->upper);
  return r->intersecting && !(bounded && closed) ? "bounds of the depth" : NULL;
}

static const char *check_cache(const subject *s, gjk_cache *cache) {
  gjk_penetration_result r;
  const gjk_status status = gjk_penetration(s->a, s->b, cache, &roomy, &r);
  if (!is_answer(s, status)) {
    return "status of gjk_penetration with a cache";
  }
  if (status == GJK_OK && s->status == GJK_OK && !is_depth(s, &r)) {
    return "gjk_penetration with a cache";
  }
  return s->certain && !exact_check_penetration(s->a, s->b, &r, s->why, s->n) ? "certificate with a cache" : NULL;
}

// With so few cells the answer may be bounds. They must hold the depth, and the upper one must part the shapes. Behind
// the cells the memory ends, so that a sanitizer notices any more.
static const char *check_small(const subject *s, uint32_t count) {
  gjk_workspace small = {count > 0 ? malloc(count * sizeof(gjk_epa_cell)) : NULL, count};
  gjk_penetration_result r;
  const gjk_status status = gjk_penetration(s->a, s->b, NULL, &small, &r);
  free(small.cells);
  if (status != GJK_ERROR_CAPACITY) {
    return !is_answer(s, status)                                                         ? "status with few cells"
           : status == GJK_OK && !is_depth(s, &r)                                        ? "depth with few cells"
           : status == GJK_OK && s->status == GJK_OK && !same_penetration(&s->depth, &r) ? "answer with few cells"
                                                                                         : NULL;
  }
  snprintf(s->why, s->n, "%ld to %ld, depth %ld", (long)r.lower, (long)r.upper, (long)s->depth.depth);
  const gjk_q16 slack = s->certain ? 0 : CURVED_APART;
  if (!r.intersecting || !s->depth.intersecting || r.depth != r.upper || r.lower < 0 ||
      r.lower > (int64_t)s->depth.upper + slack || r.upper < (int64_t)s->depth.lower - slack ||
      (s->certain && (r.lower > s->depth.depth || r.upper < s->depth.depth))) {
    return "bounds with few cells";
  }
  return s->certain && !exact_check_move(s->a, s->b, &r, s->why, s->n) ? "move by the upper bound" : NULL;
}

// The signed distance must be what the two queries that it stands for have said.
static gjk_q16 signed_distance(const subject *s, const gjk_distance_result *gap) {
  return s->depth.intersecting ? -s->depth.depth : gap->distance;
}

static const char *check_signed(const subject *s, const gjk_distance_result *gap) {
  gjk_distance_result r;
  const gjk_status status = gjk_signed_distance(s->a, s->b, NULL, &roomy, &r);
  snprintf(s->why, s->n, "signed %ld, gap %ld, depth %ld", (long)r.distance, (long)gap->distance, (long)s->depth.depth);
  if (status != s->status) {
    return "status of gjk_signed_distance";
  }
  if (status == GJK_ERROR_ITERATION_LIMIT) {
    return NULL;
  }
  const int64_t off = magnitude((int64_t)r.distance - signed_distance(s, gap));
  const bool same = s->certain
                        ? off == 0 && r.intersecting == s->depth.intersecting && r.intersecting == gap->intersecting
                        : off <= CURVED_APART;
  return status == GJK_OK && !same ? "gjk_signed_distance" : NULL;
}

static bool is_cut(const gjk_vec3 *p) {
  const gjk_q16 c[3] = {p->x, p->y, p->z};
  for (int i = 0; i < 3; i++) {
    if (c[i] == INT32_MAX || c[i] == INT32_MIN) {
      return true;
    }
  }
  return false;
}

// How far a point is from the surface; negative inside.
static bool surface_distance(const gjk_collider *shape, const gjk_vec3 *point, int64_t *out) {
  static const gjk_shape point_shape = GJK_POINT;
  gjk_collider at = {0};
  gjk_pose pose = GJK_POSE_IDENTITY;
  gjk_distance_result r;
  pose.position = *point;
  if (gjk_collider_init(&at, &point_shape, NULL, 0) != GJK_OK || gjk_collider_pose(&at, &pose) != GJK_OK ||
      gjk_signed_distance(shape, &at, NULL, &roomy, &r) != GJK_OK) {
    return false;
  }
  *out = r.distance;
  return true;
}

static double along_normal(const gjk_manifold *m, const gjk_contact *c) {
  return (((double)c->point_b.x - c->point_a.x) * m->normal.x + ((double)c->point_b.y - c->point_a.y) * m->normal.y +
          ((double)c->point_b.z - c->point_a.z) * m->normal.z) /
         GJK_Q30_ONE;
}

static bool same_point(const gjk_vec3 *p, const gjk_vec3 *q) {
  return p->x == q->x && p->y == q->y && p->z == q->z;
}

static const char *check_contact(const subject *s, const gjk_manifold *m, unsigned i, gjk_q16 margin) {
  const gjk_contact *c = &m->contact[i];
  int64_t off_a = 0, off_b = 0;
  const int64_t off_most = s->certain ? 2 : 2 + CURVED_APART;
  for (unsigned k = 0; k < i; k++) {
    if (m->contact[k].id == c->id) {
      return "an id twice";
    }
  }
  if (c->distance > margin) {
    return "a contact beyond the margin";
  }
  if (s->far || is_cut(&c->point_a) || is_cut(&c->point_b)) {
    return NULL;
  }
  const double gap = along_normal(m, c);
  snprintf(s->why, s->n, "contact %u at %ld, its points %.3f apart", i, (long)c->distance, gap);
  // Points of a curved depth lie between its bounds, which are at most 6 apart.
  const double between = s->depth.intersecting ? (double)s->depth.upper - s->depth.lower : 0;
  const double slack = !s->certain                                  ? fmax(5.001, 3.001 + between)
                       : same_point(&c->point_a, &s->depth.point_a) ? 3.001
                                                                    : 2.001;
  if (fabs(gap - c->distance) > slack + fabs(gap) / (1 << 28)) {
    return "gap of a contact";
  }
  if (!surface_distance(s->a, &c->point_a, &off_a) || !surface_distance(s->b, &c->point_b, &off_b)) {
    return s->certain ? "a point that cannot be measured" : NULL;
  }
  snprintf(s->why, s->n, "contact %u: %ld and %ld off the surfaces", i, (long)off_a, (long)off_b);
  return magnitude(off_a) > off_most || magnitude(off_b) > off_most ? "a contact off the surfaces" : NULL;
}

// How far the nearest or deepest contact may be from the signed distance, by gjk/contacts.h: more where most has left
// points out, since then one stays that is about as deep.
#define LEAST_OFF 2
#define LEAST_OFF_OF_SOME 6

// The nearest or deepest contact must be as far apart as the signed distance.
static const char *check_contacts(const subject *s, const gjk_distance_result *gap, gjk_q16 margin, unsigned most) {
  gjk_manifold m;
  const gjk_status status = gjk_contacts(s->a, s->b, margin, most, NULL, &roomy, &m);
  const int64_t distance = signed_distance(s, gap), slack = s->certain ? 0 : CURVED_APART;
  int64_t least = GJK_DISTANCE_MAX;
  if (status != s->status) {
    return "status of gjk_contacts";
  }
  snprintf(s->why, s->n, "%u of %u contacts within %ld, distance %ld", m.count, most, (long)margin, (long)distance);
  if (status == GJK_ERROR_ITERATION_LIMIT) {
    return NULL;
  }
  if (m.count > most || (m.count > 0 && distance - slack > margin) || (m.count == 0 && distance + slack <= margin)) {
    return "number of contacts";
  }
  for (unsigned i = 0; i < m.count && status == GJK_OK; i++) {
    const char *wrong = check_contact(s, &m, i, margin);
    if (wrong != NULL) {
      return wrong;
    }
    least = m.contact[i].distance < least ? m.contact[i].distance : least;
  }
  snprintf(s->why, s->n, "the least contact is %ld, the distance %ld", (long)least, (long)distance);
  const int64_t off = (m.count < most ? LEAST_OFF : LEAST_OFF_OF_SOME) + slack;
  return status == GJK_OK && m.count > 0 && magnitude(least - distance) > off ? "the least contact" : NULL;
}

const char *fuzz_check_overlap(const gjk_collider *a, const gjk_collider *b, const gjk_distance_result *gap,
                               fuzz_bytes *bytes, char *why, size_t n) {
  subject s;
  memset(&s, 0, sizeof s);
  s.a = a;
  s.b = b;
  s.certain = exact_vertex_count(a) > 0 && exact_vertex_count(b) > 0;
  s.far = exact_is_far(a, b);
  s.why = why;
  s.n = n;
  s.status = gjk_penetration(a, b, NULL, &roomy, &s.depth);
  if (!is_answer(&s, s.status)) {
    return "status of gjk_penetration";
  }
  if (s.status == GJK_ERROR_ITERATION_LIMIT) {
    return NULL;
  }
  gjk_cache cache = fuzz_cache(bytes);
  const uint32_t few = fuzz_u8(bytes);
  const gjk_q16 margin = (fuzz_i32(bytes) & INT32_MAX) >> (fuzz_u8(bytes) % 31);
  const unsigned most = 1 + fuzz_u8(bytes) % GJK_CONTACTS_MAX;
  const char *wrong = check_depth(&s);
  wrong = wrong != NULL ? wrong : check_cache(&s, &cache);
  wrong = wrong != NULL ? wrong : check_small(&s, few);
  wrong = wrong != NULL ? wrong : check_signed(&s, gap);
  return wrong != NULL ? wrong : check_contacts(&s, gap, margin, most);
}
