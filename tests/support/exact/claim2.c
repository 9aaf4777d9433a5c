// Judges answers in the plane.
#include "claim2.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

#include "refuse.h"

__extension__ typedef __int128 wide;

#define FAR (INT64_C(1) << 30)
// Relative errors of far pairs: of distances, and of points.
#define FAR_DISTANCE 28
#define FAR_POINT 27

// Points.

static exact2_point world(const gjk2_collider *c, int64_t x, int64_t y) {
  const exact2_point p = {c->centre.x + x, c->centre.y + y};
  return p;
}

bool exact2_posed_set(const gjk2_collider *c, exact2_posed *out) {
  const gjk2_shape_class *type = c->shape->type;
  const gjk2_vec *listed = type == &gjk2_class_triangle ? c->frame : c->buffer;
  const bool axes = type == &gjk2_class_box || type == &gjk2_class_segment || type == &gjk2_class_point;
  if (!axes && ((type != &gjk2_class_polygon && type != &gjk2_class_triangle) || listed == NULL)) {
    return false;
  }
  const unsigned half_axes = type == &gjk2_class_box ? 2 : type == &gjk2_class_segment ? 1 : 0;
  const unsigned n = axes ? 1u << half_axes : c->shape->count;
  out->point = malloc(n * sizeof *out->point);
  assert(out->point != NULL);
  for (unsigned i = 0; i < n; i++) {
    int64_t x = axes ? 0 : listed[i].x, y = axes ? 0 : listed[i].y;
    for (unsigned k = 0; k < half_axes; k++) {
      x += (i >> k & 1u) != 0 ? c->frame[k].x : -c->frame[k].x;
      y += (i >> k & 1u) != 0 ? c->frame[k].y : -c->frame[k].y;
    }
    out->point[i] = world(c, x, y);
  }
  out->shape.point = out->point;
  out->shape.count = n;
  out->own_hull = malloc(sizeof *out->own_hull);
  assert(out->own_hull != NULL);
  exact2_hull_find(out->point, n, out->own_hull);
  out->shape.radius = c->shape->convex_radius;
  out->hull.point = out->own_hull->vertex;
  out->hull.count = out->own_hull->count;
  out->hull.radius = out->shape.radius;
  return true;
}

void exact2_posed_free(exact2_posed *posed) {
  free(posed->point);
  free(posed->own_hull);
}

bool exact2_is_far(const gjk2_collider *a, const gjk2_collider *b) {
  const wide x = (wide)a->centre.x - b->centre.x, y = (wide)a->centre.y - b->centre.y;
  return x * x + y * y > (wide)FAR * FAR;
}

bool exact2_pair_set(const gjk2_collider *a, const gjk2_collider *b, exact2_pair *out) {
  if (!exact2_posed_set(a, &out->a)) {
    return false;
  }
  if (!exact2_posed_set(b, &out->b)) {
    exact2_posed_free(&out->a);
    return false;
  }
  out->far = exact2_is_far(a, b);
  exact2_find(&out->a.hull, &out->b.hull, &out->truth);
  return true;
}

void exact2_pair_free(exact2_pair *pair) {
  exact2_posed_free(&pair->a);
  exact2_posed_free(&pair->b);
}

// Certificates. Their vertices and directions are in a frame of near pairs: |w|
// < 2^31, so products are below 2^64.

static wide dot(exact2_point p, exact2_point q) {
  return (wide)p.x * q.x + (wide)p.y * q.y;
}

static wide cross(exact2_point p, exact2_point q) {
  return (wide)p.x * q.y - (wide)p.y * q.x;
}

static exact2_point minus(exact2_point p, exact2_point q) {
  const exact2_point out = {p.x - q.x, p.y - q.y};
  return out;
}

// The vertices of A - B that a certificate names. False: there is none of a
// number.
static bool name_vertices(const exact2_pair *pair, const gjk2_certificate *c, exact2_point w[3]) {
  if (c->count > 3) {
    return false;
  }
  for (unsigned i = 0; i < c->count; i++) {
    if (c->a[i] >= pair->a.shape.count || c->b[i] >= pair->b.shape.count) {
      return false;
    }
    w[i] = minus(pair->a.point[c->a[i]], pair->b.point[c->b[i]]);
  }
  return true;
}

// The largest n . w of all w of A - B.
static wide farthest(const exact2_pair *pair, exact2_point n) {
  const exact2_shape *a = &pair->a.hull, *b = &pair->b.hull;
  wide of_a = dot(n, a->point[0]), of_b = dot(n, b->point[0]);
  for (unsigned i = 1; i < a->count; i++) {
    const wide along = dot(n, a->point[i]);
    of_a = along > of_a ? along : of_a;
  }
  for (unsigned i = 1; i < b->count; i++) {
    const wide along = dot(n, b->point[i]);
    of_b = along < of_b ? along : of_b;
  }
  return of_a - of_b;
}

// Is the edge w, or the vertex w[0], with the origin's projection inside, the
// nearest feature of A - B?
static bool is_nearest(const exact2_pair *pair, const exact2_point w[3], unsigned count) {
  exact2_point toward = {-w[0].x, -w[0].y};
  if (count == 2) {
    const exact2_point e = minus(w[1], w[0]);
    const wide area = cross(e, w[0]);
    if (area == 0 || dot(w[0], e) > 0 || dot(w[1], e) < 0) {
      return false;
    }
    toward.x = area > 0 ? e.y : -e.y;
    toward.y = area > 0 ? -e.x : e.x;
  }
  return (count == 1 || count == 2) && dot(toward, w[0]) < 0 && farthest(pair, toward) <= dot(toward, w[0]);
}

// Does the vertex or edge come within radius of the origin?
static bool is_near(const exact2_point w[3], unsigned count, int64_t radius) {
  const exact2_point origin = {0, 0};
  const exact2_shape feature = {w, count, 0}, point = {&origin, 1, 0};
  return (count == 1 || count == 2) && exact2_within(&feature, &point, radius);
}

// Do the vertices span a point, segment or triangle with the origin in it?
static bool is_enclosing(const exact2_point w[3], unsigned count) {
  const exact2_point origin = {0, 0};
  const exact2_shape simplex = {w, count, 0}, point = {&origin, 1, 0};
  return count >= 1 && exact2_within(&simplex, &point, 0);
}

// Is the whole of A - B more than radius from the origin, measured along
// direction?
static bool is_parted(const exact2_pair *pair, exact2_point direction, int64_t radius) {
  const wide along = -farthest(pair, direction);  // < 2^63
  return along > 0 && along * along > (wide)radius * radius * dot(direction, direction);
}

// Are the bounding circles of the colliders' cores more than radius apart?
// Asked of circles about the points' box.
static bool certificate_holds(const exact2_pair *pair, const gjk2_certificate *c, int64_t radius, bool apart) {
  const exact2_point direction = {c->direction.x, c->direction.y};
  exact2_point w[3];
  if (!name_vertices(pair, c, w)) {
    return false;
  }
  switch ((gjk2_proof)c->proof) {
    case GJK2_PROOF_CIRCLES: return apart;
    case GJK2_PROOF_DIRECTION: return apart && is_parted(pair, direction, radius);
    case GJK2_PROOF_NEAREST: return is_nearest(pair, w, c->count) && is_near(w, c->count, radius) != apart;
    case GJK2_PROOF_NEAR: return !apart && is_near(w, c->count, radius);
    case GJK2_PROOF_ENCLOSING: return !apart && is_enclosing(w, c->count);
    default: return false;
  }
}

static int64_t radii(const exact2_pair *pair) {
  return pair->a.shape.radius + pair->b.shape.radius;
}

// Fields.

static bool close_to(int64_t found, int64_t exact, bool far) {
  const int64_t error = far ? exact >> FAR_DISTANCE : 0;
  const int64_t most = exact + error < INT32_MAX ? exact + error : INT32_MAX;
  const int64_t least = exact - error < INT32_MAX ? exact - error : INT32_MAX;
  return found >= least && found <= most;
}

// Is the unit vector within 2^-28 of the direction's?
static bool is_along(gjk2_unit unit, exact2_point direction) {
  const long double x = (long double)direction.x, y = (long double)direction.y, length = hypotl(x, y);
  const long double one = (long double)GJK_Q30_ONE, most = 4;
  return hypotl((long double)unit.x - one * x / length, (long double)unit.y - one * y / length) <= most;
}

static bool touches(const exact2_posed *posed, gjk2_vec point, int64_t error) {
  const exact2_point p = {point.x, point.y};
  const exact2_shape alone = {&p, 1, 0};
  return exact2_within(&alone, &posed->hull, error);
}

bool exact2_check_distance(const exact2_pair *pair, const gjk2_distance_result *r, char *why, size_t n) {
  const exact2_truth *truth = &pair->truth;
  if (r->intersecting != truth->intersecting) {
    return refuse(why, n, truth->intersecting ? "they intersect" : "they are apart");
  }
  if (!pair->far && !certificate_holds(pair, &r->certificate, radii(pair), !truth->intersecting)) {
    return refuse(why, n, "the certificate, proof %u of %u", r->certificate.proof, r->certificate.count);
  }
  if (!close_to(r->distance, truth->distance, pair->far) || r->lower != r->distance || r->upper != r->distance) {
    return refuse(why, n, "the distance is %lld", (long long)truth->distance);
  }
  if (r->intersecting || r->saturated) {
    return true;
  }
  const int64_t error = pair->far ? truth->distance >> FAR_POINT : 0;
  const long double gap = hypotl((long double)r->point_b.x - r->point_a.x, (long double)r->point_b.y - r->point_a.y);
  if (!touches(&pair->a, r->point_a, 1 + error) || !touches(&pair->b, r->point_b, 1 + error)) {
    return refuse(why, n, "a point is more than 1 LSB from its shape");
  }
  if (fabsl(gap - (long double)r->distance) > 2 + (long double)error) {
    return refuse(why, n, "the points are %.2Lf apart", gap);
  }
  return pair->far || is_along(r->normal, truth->direction) ? true : refuse(why, n, "the normal");
}

bool exact2_check_decision(const exact2_pair *pair, gjk_q16 distance, const gjk2_decision *d, char *why, size_t n) {
  const bool within = exact2_truth_within(&pair->truth, radii(pair), distance);
  if (pair->far) {  // right unless the distance is that near to the one asked
                    // about
    const int64_t error = pair->truth.distance >> FAR_DISTANCE, off = pair->truth.distance - distance;
    return d->yes == within || (off >= -error - 1 && off <= error + 1) || refuse(why, n, "the decision");
  }
  if (d->yes != within) {
    return refuse(why, n, within ? "they are within" : "they are beyond");
  }
  return certificate_holds(pair, &d->certificate, radii(pair) + distance, !within) ||
         refuse(why, n, "the certificate, proof %u of %u", d->certificate.proof, d->certificate.count);
}

// depth times a component of the normal, rounded away from 0.
static int64_t away(gjk_q16 depth, gjk_q30 component) {
  const int64_t product = (int64_t)depth * component, one = GJK_Q30_ONE;
  return product >= 0 ? (product + one - 1) / one : -((-product + one - 1) / one);
}

// Is B, moved, apart from A or just touching?
static bool is_way_out(const exact2_pair *pair, const gjk2_penetration_result *r) {
  const int64_t x = away(r->depth, r->normal.x), y = away(r->depth, r->normal.y);
  exact2_shape moved = pair->b.hull;
  exact2_point *point = malloc(moved.count * sizeof *point);
  exact2_truth truth;
  assert(point != NULL);
  for (unsigned i = 0; i < moved.count; i++) {
    point[i].x = pair->b.hull.point[i].x + x;
    point[i].y = pair->b.hull.point[i].y + y;
  }
  moved.point = point;
  exact2_find(&pair->a.hull, &moved, &truth);
  free(point);
  return truth.depth == 0;
}

// The least k with k |n| >= height.
static bool rounds_up_to(wide height, exact2_point n, int64_t k) {
  const wide square = dot(n, n);
  return (wide)k * k * square >= height * height && (k == 0 || (wide)(k - 1) * (k - 1) * square < height * height);
}

static bool depth_certificate_holds(const exact2_pair *pair, const gjk2_penetration_result *r) {
  const gjk2_certificate *c = &r->certificate;
  const exact2_point direction = {c->direction.x, c->direction.y};
  exact2_point w[3];
  if (!name_vertices(pair, c, w)) {
    return false;
  }
  if (c->proof == GJK2_PROOF_EDGE && c->count == 2) {
    const exact2_point e = minus(w[1], w[0]), outward = {e.y, -e.x};
    return (e.x != 0 || e.y != 0) && farthest(pair, outward) == dot(outward, w[0]) &&
           rounds_up_to(dot(outward, w[0]), outward, r->depth - radii(pair));
  }
  if (c->proof == GJK2_PROOF_LINE) {
    return (direction.x != 0 || direction.y != 0) && farthest(pair, direction) == 0 && r->depth == radii(pair);
  }
  return certificate_holds(pair, c, radii(pair), false);
}

bool exact2_check_penetration(const exact2_pair *pair, const gjk2_penetration_result *r, char *why, size_t n) {
  const exact2_truth *truth = &pair->truth;
  if (r->intersecting != truth->intersecting) {
    return refuse(why, n, truth->intersecting ? "they intersect" : "they are apart");
  }
  if (!r->intersecting) {
    return pair->far || certificate_holds(pair, &r->certificate, radii(pair), true) ||
           refuse(why, n, "the certificate");
  }
  if (r->depth != truth->depth || r->lower != r->depth || r->upper != r->depth) {
    return refuse(why, n, "the depth is %lld", (long long)truth->depth);
  }
  if (!depth_certificate_holds(pair, r)) {
    return refuse(why, n, "the certificate, proof %u of %u", r->certificate.proof, r->certificate.count);
  }
  if (!is_way_out(pair, r)) {
    return refuse(why, n, "moved by it they still overlap");
  }
  if (!touches(&pair->a, r->point_a, 1) || !touches(&pair->b, r->point_b, 1)) {
    return refuse(why, n, "a point is more than 1 LSB from its shape");
  }
  const long double one = (long double)GJK_Q30_ONE, depth = (long double)r->depth;
  const long double x = (long double)r->point_b.x - r->point_a.x + depth * r->normal.x / one;
  const long double y = (long double)r->point_b.y - r->point_a.y + depth * r->normal.y / one;
  if (hypotl(x, y) > 3 + ldexpl(depth, -28)) {
    return refuse(why, n, "the points miss each other by %.2Lf", hypotl(x, y));
  }
  const long double length = hypotl((long double)r->normal.x, (long double)r->normal.y) / one;
  return fabsl(length - 1) <= ldexpl(1, -28) ? true : refuse(why, n, "the normal is %.12Lf long", length);
}
