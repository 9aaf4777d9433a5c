// Forged answers.
#include "forge.h"

#include <math.h>
#include <string.h>

#include "exact/depth.h"
#include "place.h"
#include "polytope.h"

#define CELLS GJK_EPA_CELLS(64)

static gjk_epa_cell cells[CELLS];
static const gjk_workspace workspace = {cells, CELLS};

static unsigned count_of(case_kind kind) {
  static const unsigned count[] = {1, 2, 3, 8, 4};
  return count[kind];
}

// Hulls are tetrahedra.
static void make(random_state *random, case_kind kind, gjk_q16 reach, case_shape *out) {
  if (random_below(random, 4) == 0) {
    generate_sliver(random, kind, reach, out);
  } else {
    generate_polytope(random, kind, reach, out);
  }
  if (kind == CASE_HULL) {
    case_shape_set_count(out, 4);
  }
  if (kind == CASE_BOX && random_below(random, 2) == 0) {
    out->size.y = out->size.y / 16 + 1;  // a slab
  }
  out->convex_radius = random_below(random, 3) == 0 ? random_range(random, 0, reach) >> random_below(random, 16) : 0;
}

void forge_pair(random_state *random, unsigned most, case_pair *pair) {
  static const case_kind kinds[] = {CASE_POINT, CASE_SEGMENT, CASE_TRIANGLE, CASE_BOX, CASE_HULL};
  const gjk_q16 reach = INT32_C(1) << (3 + random_below(random, 24));
  case_kind a, b;
  do {
    a = kinds[random_below(random, 5)];
    b = kinds[random_below(random, 5)];
  } while (count_of(a) * count_of(b) > most);
  case_shape_reset(&pair->a);
  case_shape_reset(&pair->b);
  make(random, a, reach, &pair->a);
  make(random, b, reach, &pair->b);
  generate_apart(random, 0.7 * generate_unit(random), pair);
  const gjk_pose none = GJK_POSE_IDENTITY;
  if (random_below(random, 2) == 0) {
    pair->a.pose.rotation = pair->b.pose.rotation = none.rotation;
  }
  pair->b.pose.position.x -= pair->a.pose.position.x;
  pair->b.pose.position.y -= pair->a.pose.position.y;
  pair->b.pose.position.z -= pair->a.pose.position.z;
  pair->a.pose.position = none.position;
  if (random_below(random, 3) == 0) {
    generate_near(random, random_range(random, -3, 3) / 2, pair);
  }
  snprintf(pair->id, sizeof pair->id, "forged");
}

bool forge_true(const gjk_collider *a, const gjk_collider *b, forge_kind kind, gjk_q16 asked, forge_claim *out) {
  memset(out, 0, sizeof *out);
  out->kind = kind;
  out->asked = asked;
  switch (kind) {
    case FORGE_DECISION: return gjk_within(a, b, asked, NULL, &out->decision) == GJK_OK;
    case FORGE_DISTANCE: return gjk_distance(a, b, NULL, &out->distance) == GJK_OK;
    default: return gjk_penetration(a, b, NULL, &workspace, &out->penetration) == GJK_OK;
  }
}

static gjk_certificate *certificate_of(forge_claim *claim) {
  return claim->kind == FORGE_DECISION   ? &claim->decision.certificate
         : claim->kind == FORGE_DISTANCE ? &claim->distance.certificate
                                         : &claim->penetration.certificate;
}

// The values that belong to a feature or facet of the named pairs.
typedef struct fit {
  double a[3], b[3];  // where the nearest points of the cores are
  double normal[3];   // unit, from A to B; outwards for a facet
  double height;      // of the cores' plane over the origin; negative: their distance
} fit;

// Sets a point of a shape from its named vertices and their weights.
static void weigh(const gjk_collider *c, const uint16_t *named, unsigned count, const double weight[3], double out[3]) {
  out[0] = out[1] = out[2] = 0;
  for (unsigned i = 0; i < count; i++) {
    const exact_point p = exact_vertex(c, named[i]);
    for (int k = 0; k < 3; k++) {
      out[k] += weight[i] * (double)p.x[k];
    }
  }
}

static bool find_fit(const gjk_collider *a, const gjk_collider *b, const gjk_certificate *c, fit *out) {
  exact_point w[3] = {{{0}}};
  exact_feature feature;
  if (c->count < 1 || c->count > 3) {
    return false;
  }
  for (unsigned i = 0; i < c->count; i++) {
    if (c->a[i] >= exact_vertex_count(a) || c->b[i] >= exact_vertex_count(b)) {
      return false;
    }
    const exact_point p = exact_vertex(a, c->a[i]), q = exact_vertex(b, c->b[i]);
    w[i] = exact_subtract(&p, &q);
  }
  if (!exact_feature_make(w, c->count, &feature)) {
    return false;
  }
  double weight[3] = {0, 0, 0}, length = 0;
  exact_vector normal = feature.point;
  for (unsigned i = 0; i < c->count; i++) {
    weight[i] = exact_to_double(&feature.weight[i]) / exact_to_double(&feature.denominator);
  }
  weigh(a, c->a, c->count, weight, out->a);
  weigh(b, c->b, c->count, weight, out->b);
  if (c->proof == GJK_PROOF_FACET && c->count == 3) {
    const exact_point e = exact_subtract(&w[1], &w[0]), f = exact_subtract(&w[2], &w[0]);
    normal = exact_cross(&e, &f);
  }
  const double sign = c->proof == GJK_PROOF_FACET ? 1 : -1;
  for (int k = 0; k < 3; k++) {
    out->normal[k] = sign * exact_to_double(&normal.x[k]);
    length += out->normal[k] * out->normal[k];
  }
  if (c->proof == GJK_PROOF_PLANE) {
    const double d[3] = {c->direction.x, c->direction.y, c->direction.z};
    memcpy(out->normal, d, sizeof d);
    length = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  }
  if (length == 0) {
    return false;
  }
  const double height = sqrt(exact_to_double(&feature.squared) / exact_to_double(&feature.denominator));
  out->height = c->proof == GJK_PROOF_PLANE ? 0 : sign * height;
  for (int k = 0; k < 3; k++) {
    out->normal[k] /= sqrt(length);
  }
  return true;
}

static gjk_q16 rounded(double x) {
  return x >= 2147483647.0 ? INT32_MAX : x <= -2147483648.0 ? INT32_MIN : (gjk_q16)floor(x + 0.5);
}

// The points of the cores, moved out by the convex radii.
static void fit_points(const gjk_collider *a, const gjk_collider *b, const fit *f, gjk_vec3 *point_a, gjk_vec3 *point_b,
                       gjk_unit3 *normal) {
  const double p = a->shape->convex_radius, q = b->shape->convex_radius, *n = f->normal;
  const gjk_vec3 at_a = {rounded(f->a[0] + p * n[0]), rounded(f->a[1] + p * n[1]), rounded(f->a[2] + p * n[2])};
  const gjk_vec3 at_b = {rounded(f->b[0] - q * n[0]), rounded(f->b[1] - q * n[1]), rounded(f->b[2] - q * n[2])};
  const double one = (double)GJK_Q30_ONE;
  const gjk_unit3 unit = {rounded(n[0] * one), rounded(n[1] * one), rounded(n[2] * one)};
  *point_a = at_a;
  *point_b = at_b;
  *normal = unit;
}

void forge_fit(const gjk_collider *a, const gjk_collider *b, forge_claim *claim) {
  const gjk_certificate *c = certificate_of(claim);
  const double radius = (double)a->shape->convex_radius + b->shape->convex_radius;
  fit f;
  if (!find_fit(a, b, c, &f)) {
    return;
  }
  if (claim->kind == FORGE_DECISION) {
    claim->decision.yes = c->proof == GJK_PROOF_NEAR || c->proof == GJK_PROOF_ENCLOSING;
    claim->asked = rounded(-f.height - radius < 0 ? 0 : -f.height - radius);
  } else if (claim->kind == FORGE_DISTANCE) {
    gjk_distance_result *r = &claim->distance;
    r->intersecting = c->proof != GJK_PROOF_NEAREST;
    r->distance = r->lower = r->upper = r->intersecting ? 0 : rounded(-f.height - radius);
    r->saturated = false;
    fit_points(a, b, &f, &r->point_a, &r->point_b, &r->normal);
  } else {
    gjk_penetration_result *r = &claim->penetration;
    r->intersecting = true;
    r->depth = r->lower = r->upper = rounded(ceil(f.height + radius));
    fit_points(a, b, &f, &r->point_a, &r->point_b, &r->normal);
  }
}

// Changes a number by little or much: to any bits, the opposite, or 0.
static void change(uint32_t how, int32_t value, int32_t *x) {
  const uint32_t u = (uint32_t)*x, v = (uint32_t)value;
  uint32_t to = 0;
  switch (how % 6) {
    case 0: to = u + (v % 2 == 0 ? 1 : UINT32_MAX); break;
    case 1: to = u + v % 17 - 8; break;
    case 2: to = u + (uint32_t)(value / (INT32_C(1) << (how / 6 % 31))); break;
    case 3: to = v; break;
    case 4: to = 0 - u; break;
    default: break;
  }
  memcpy(x, &to, sizeof to);
}

static void edit_certificate(uint32_t field, uint32_t how, int32_t value, gjk_certificate *c) {
  int32_t *const direction[3] = {&c->direction.x, &c->direction.y, &c->direction.z};
  const uint32_t v = (uint32_t)value;
  uint16_t *const named = field % 2 == 0 ? c->a : c->b;
  switch (field % 8) {
    case 0: c->proof = (uint8_t)(v % 9); break;
    case 1: c->count = (uint8_t)(v % 6); break;
    case 2: change(how, value, direction[how % 3]); break;
    case 3: {  // two pairs change places
      const unsigned i = how % 4, k = v % 4;
      const uint16_t at_a = c->a[i], at_b = c->b[i];
      c->a[i] = c->a[k];
      c->b[i] = c->b[k];
      c->a[k] = at_a;
      c->b[k] = at_b;
      break;
    }
    case 4:
    case 5: {  // or of one shape alone
      const uint16_t at = named[how % 4];
      named[how % 4] = named[v % 4];
      named[v % 4] = at;
      break;
    }
    default: named[how % 4] = (uint16_t)(v % 9); break;
  }
}

void forge_edit(uint32_t field, uint32_t how, int32_t value, forge_claim *claim) {
  gjk_distance_result *d = &claim->distance;
  gjk_penetration_result *p = &claim->penetration;
  int32_t *const of_distance[] = {&d->distance,  &d->lower,     &d->upper,     &d->point_a.x,
                                  &d->point_a.y, &d->point_a.z, &d->point_b.x, &d->point_b.y,
                                  &d->point_b.z, &d->normal.x,  &d->normal.y,  &d->normal.z};
  int32_t *const of_depth[] = {&p->depth,     &p->lower,     &p->upper,     &p->point_a.x, &p->point_a.y, &p->point_a.z,
                               &p->point_b.x, &p->point_b.y, &p->point_b.z, &p->normal.x,  &p->normal.y,  &p->normal.z};
  const uint32_t which = field / 16 % 12;
  switch (field % 16) {
    case 0:
      claim->decision.yes = !claim->decision.yes;
      d->intersecting = !d->intersecting;
      p->intersecting = !p->intersecting;
      break;
    case 1: d->saturated = !d->saturated; break;
    case 2: change(how, value, &claim->asked); break;
    case 3:  // all three of them
      change(how, value, &d->distance);
      d->lower = d->upper = d->distance;
      change(how, value, &p->depth);
      p->lower = p->upper = p->depth;
      break;
    case 4:
    case 5:
    case 6:
    case 7: edit_certificate(field / 16, how, value, certificate_of(claim)); break;
    default:
      change(how, value, of_distance[which]);
      change(how, value, of_depth[which]);
      break;
  }
}

// The answer for B moved to another place, apart or overlapping. Its certificate names a facet of that A - B, which is
// also one of this A - B.
static bool borrow(random_state *random, const gjk_collider *a, const gjk_collider *b, forge_claim *out) {
  gjk_collider moved = *b;
  const double length = generate_unit(random) * 1.2 * ((double)a->radius + b->radius);
  const gjk_vec3 by = generate_vector(random, length);
  const gjk_vec3 to = {a->centre.x + by.x, a->centre.y + by.y, a->centre.z + by.z};
  return gjk_collider_move(&moved, &to) == GJK_OK &&
         forge_true(a, &moved, (forge_kind)random_below(random, FORGE_KINDS), out->asked, out);
}

static void invent(random_state *random, const gjk_collider *a, const gjk_collider *b, gjk_certificate *c) {
  c->proof = (uint8_t)random_below(random, 9);
  c->count = (uint8_t)(1 + random_below(random, 4));
  for (int i = 0; i < 4; i++) {
    c->a[i] = (uint16_t)random_below(random, exact_vertex_count(a));
    c->b[i] = (uint16_t)random_below(random, exact_vertex_count(b));
  }
  const int32_t size = random_below(random, 2) == 0 ? 1 : INT32_C(1) << 30;
  c->direction.x = random_range(random, -size, size);
  c->direction.y = random_range(random, -size, size);
  c->direction.z = random_range(random, -size, size);
}

void forge(random_state *random, const gjk_collider *a, const gjk_collider *b, const forge_claim *other,
           forge_claim *out) {
  const uint32_t way = random_below(random, 16);
  const forge_kind kind = (forge_kind)random_below(random, FORGE_KINDS);
  forge_claim lent;
  (void)forge_true(a, b, kind, random_range(random, 0, a->radius) >> random_below(random, 28), out);
  if (way < 5) {  // a certificate from elsewhere, of any kind of answer
    lent = *other;
    if (way < 3 && !borrow(random, a, b, &lent)) {
      lent = *other;
    }
    *certificate_of(out) = *certificate_of(&lent);
  } else if (way < 7) {
    invent(random, a, b, certificate_of(out));
  } else if (way == 7) {  // all of it from elsewhere
    *out = *other;
  }
  // A lie is better if the certificate is changed before the values are fitted to it.
  if (random_below(random, 4) == 0) {
    edit_certificate(random_u32(random), random_u32(random), (int32_t)random_below(random, 1000), certificate_of(out));
  }
  if (way < 10 && random_below(random, 4) != 0) {
    forge_fit(a, b, out);
  }
  for (uint32_t edits = random_below(random, 3); edits > 0; edits--) {
    forge_edit(random_u32(random), random_u32(random), random_range(random, INT32_MIN, INT32_MAX), out);
  }
}

gjk_status forge_check(const gjk_collider *a, const gjk_collider *b, const forge_claim *claim) {
  switch (claim->kind) {
    case FORGE_DECISION: return gjk_check_decision(a, b, claim->asked, &claim->decision);
    case FORGE_DISTANCE: return gjk_check_distance(a, b, &claim->distance);
    default: return gjk_check_penetration(a, b, &claim->penetration);
  }
}

static void print_values(FILE *file, gjk_q16 value, const gjk_vec3 *a, const gjk_vec3 *b, const gjk_unit3 *n) {
  fprintf(file, "%ld a=%ld,%ld,%ld b=%ld,%ld,%ld normal=%ld,%ld,%ld", (long)value, (long)a->x, (long)a->y, (long)a->z,
          (long)b->x, (long)b->y, (long)b->z, (long)n->x, (long)n->y, (long)n->z);
}

void forge_print(FILE *file, const forge_claim *claim) {
  forge_claim copy = *claim;
  const gjk_certificate *c = certificate_of(&copy);
  const gjk_distance_result *d = &claim->distance;
  const gjk_penetration_result *p = &claim->penetration;
  if (claim->kind == FORGE_DECISION) {
    fprintf(file, "claim within %ld: %d", (long)claim->asked, claim->decision.yes);
  } else if (claim->kind == FORGE_DISTANCE) {
    fprintf(file, "claim intersecting=%d saturated=%d distance=", d->intersecting, d->saturated);
    print_values(file, d->distance, &d->point_a, &d->point_b, &d->normal);
  } else {
    fprintf(file, "claim intersecting=%d depth=", p->intersecting);
    print_values(file, p->depth, &p->point_a, &p->point_b, &p->normal);
  }
  fprintf(file, " proof=%u direction=%ld,%ld,%ld pairs=", c->proof, (long)c->direction.x, (long)c->direction.y,
          (long)c->direction.z);
  for (unsigned i = 0; i < c->count && i < 4; i++) {
    fprintf(file, "(%u,%u)", c->a[i], c->b[i]);
  }
  fprintf(file, "\n");
}
