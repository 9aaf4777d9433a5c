// Makes a pair of shapes of the plane, queries, caches and forged answers from bytes. Every answer about polygons must
// pass the exact oracle, answers must agree, no forged value may pass the library's check, and points put in order must
// be the oracle's hull. With GJK_FUZZ_PRINT set, the pair is printed first, as a case of the query tool.
#include <stdlib.h>
#include <string.h>

#include "bytes.h"
#include "exact/claim2.h"
#include "generate/generate2.h"

#define VERTICES_MAX 24

static case2_pair pair;
static case2_collider a, b;
static exact2_pair exact;
static char why[160];

static void expect(bool holds, const char *what) {
  if (!holds) {
    case2_print(stderr, &pair);
    fprintf(stderr, "fuzz: %s\n", why);
    fuzz_fail(what);
  }
}

static gjk2_vec fuzz_vec2(fuzz_bytes *bytes) {
  gjk2_vec v;
  v.x = fuzz_i32(bytes);
  v.y = fuzz_i32(bytes);
  return v;
}

// A size, small or any.
static gjk_q16 fuzz_size(fuzz_bytes *bytes) {
  return (gjk_q16)((uint32_t)fuzz_i32(bytes) % (UINT32_C(1) << (fuzz_u8(bytes) % 29)));
}

static void fuzz_shape(fuzz_bytes *bytes, case2_shape *shape) {
  case2_shape_reset(shape);
  shape->kind = (case2_kind)(fuzz_u8(bytes) % (CASE2_ELLIPSE + 1));
  const unsigned bits = fuzz_u8(bytes) % 32;
  shape->size.x =
      shape->kind == CASE2_SEGMENT || shape->kind == CASE2_BOX || shape->kind == CASE2_ELLIPSE ? fuzz_size(bytes) : 0;
  shape->size.y = shape->kind == CASE2_BOX || shape->kind == CASE2_ELLIPSE ? fuzz_size(bytes) : 0;
  shape->convex_radius = fuzz_u8(bytes) % 3 == 0 ? fuzz_size(bytes) : 0;
  const gjk2_vec at = fuzz_vec2(bytes), turn = fuzz_vec2(bytes);
  const gjk2_rotation raw = {turn.x, turn.y};
  shape->pose.position.x = at.x >> bits;
  shape->pose.position.y = at.y >> bits;
  (void)gjk2_rotation_normalize(&raw, &shape->pose.rotation);  // of 0: stays the identity
  const size_t count = 1 + fuzz_u8(bytes) % VERTICES_MAX;
  if (shape->kind == CASE2_TRIANGLE || shape->kind == CASE2_POLYGON) {
    case2_shape_set_count(shape, shape->kind == CASE2_TRIANGLE ? 3 : count);
    for (size_t i = 0; i < shape->count; i++) {
      const gjk2_vec v = fuzz_vec2(bytes);
      shape->vertices[i].x = v.x >> bits;
      shape->vertices[i].y = v.y >> bits;
    }
  }
}

static gjk2_cache fuzz_cache2(fuzz_bytes *bytes) {
  gjk2_cache cache;
  for (int i = 0; i < 2; i++) {
    cache.direction[i] = (int16_t)(fuzz_u8(bytes) << 8 | fuzz_u8(bytes));
    cache.a[i] = fuzz_u8(bytes);
    cache.b[i] = fuzz_u8(bytes);
  }
  cache.count = fuzz_u8(bytes) % 4;
  return cache;
}

// The corners of a polygon in order, by the library and by the oracle.
static void check_order(const case2_shape *shape) {
  static exact2_hull hull;
  gjk2_vec ordered[VERTICES_MAX];
  exact2_point points[VERTICES_MAX];
  uint16_t count = 0;
  gjk_status status = gjk2_polygon_order(shape->vertices, (uint16_t)shape->count, ordered, &count);
  if (shape->count == 0) {
    expect(status == GJK_ERROR_NULL || status == GJK_ERROR_EMPTY, "status of gjk2_polygon_order of no points");
    return;
  }
  expect(status == GJK_OK || status == GJK_ERROR_SIZE, "status of gjk2_polygon_order");
  if (status != GJK_OK) {
    return;
  }
  for (size_t i = 0; i < shape->count; i++) {
    points[i].x = shape->vertices[i].x;
    points[i].y = shape->vertices[i].y;
  }
  exact2_hull_find(points, (unsigned)shape->count, &hull);
  expect(count == hull.count, "number of corners in order");
  unsigned lowest = 0;
  for (unsigned i = 1; i < hull.count; i++) {
    const exact2_point p = hull.vertex[i], q = hull.vertex[lowest];
    lowest = p.y < q.y || (p.y == q.y && p.x < q.x) ? i : lowest;
  }
  for (unsigned i = 0; i < hull.count; i++) {
    const exact2_point p = hull.vertex[(lowest + i) % hull.count];
    expect(ordered[i].x == p.x && ordered[i].y == p.y, "corners in order");
  }
}

static gjk2_distance_result check_distance(gjk2_cache *cache, bool certain) {
  gjk2_distance_result r;
  memset(&r, 0, sizeof r);
  expect(gjk2_distance(&a.collider, &b.collider, cache, &r) == GJK_OK, "status of gjk2_distance");
  if (certain) {
    expect(exact2_check_distance(&exact, &r, why, sizeof why), "gjk2_distance");
    const gjk_status status = gjk2_check_distance(&a.collider, &b.collider, &r);
    expect(status == (exact.far ? GJK_ERROR_UNSUPPORTED : GJK_OK), "gjk2_check_distance");
  }
  return r;
}

static gjk2_decision check_within(gjk_q16 distance, gjk2_cache *cache, bool certain) {
  gjk2_decision d;
  memset(&d, 0, sizeof d);
  expect(gjk2_within(&a.collider, &b.collider, distance, cache, &d) == GJK_OK, "status of gjk2_within");
  if (certain) {
    expect(exact2_check_decision(&exact, distance, &d, why, sizeof why), "gjk2_within");
  }
  return d;
}

static gjk2_penetration_result check_depth(gjk2_cache *cache, bool certain) {
  gjk2_penetration_result r;
  gjk2_distance_result line;
  memset(&r, 0, sizeof r);
  const gjk_status status = gjk2_penetration(&a.collider, &b.collider, cache, &r);
  expect(status == GJK_OK || (status == GJK_ERROR_CAPACITY && !certain), "status of gjk2_penetration");
  if (certain) {
    expect(exact2_check_penetration(&exact, &r, why, sizeof why), "gjk2_penetration");
  }
  const gjk_status same = gjk2_signed_distance(&a.collider, &b.collider, NULL, &line);
  expect(same == status || !certain, "status of gjk2_signed_distance");
  expect(!certain || line.intersecting == r.intersecting, "gjk2_signed_distance decides the same");
  expect(!certain || !r.intersecting || line.distance == -r.depth, "gjk2_signed_distance of an overlap");
  return r;
}

static void check_contacts(fuzz_bytes *bytes) {
  gjk2_manifold manifold;
  const gjk_q16 margin = fuzz_i32(bytes);
  const unsigned most = fuzz_u8(bytes) % 4;
  memset(&manifold, 0, sizeof manifold);
  const gjk_status status = gjk2_contacts(&a.collider, &b.collider, margin, most, NULL, &manifold);
  const gjk_status refused = margin < 0 ? GJK_ERROR_NEGATIVE : most < 1 || most > 2 ? GJK_ERROR_RANGE : GJK_OK;
  expect(status == refused || (refused == GJK_OK && status == GJK_ERROR_CAPACITY), "status of gjk2_contacts");
  expect(manifold.count <= most, "number of contacts");
  for (unsigned i = 0; i < manifold.count; i++) {
    expect(manifold.contact[i].distance <= margin, "a contact beyond the margin");
  }
}

// Changes a certificate by a field.
static void forge_certificate(fuzz_bytes *bytes, gjk2_certificate *c) {
  const int32_t value = fuzz_i32(bytes);
  switch (fuzz_u8(bytes) % 5) {
    case 0: c->a[(uint32_t)value % 3] = (uint16_t)((uint32_t)value / 3 % 32); break;
    case 1: c->b[(uint32_t)value % 3] = (uint16_t)((uint32_t)value / 3 % 32); break;
    case 2: c->count = (uint8_t)value; break;
    case 3: c->proof = (uint8_t)value; break;
    default: c->direction.x = value; c->direction.y = fuzz_i32(bytes);
  }
}

// Forged answers with other certificates: what the library's check lets pass is true. One that is far has no proof.
static void forge(fuzz_bytes *bytes, gjk_q16 asked, gjk2_decision d, gjk2_distance_result r,
                  gjk2_penetration_result p) {
  while (bytes->at < bytes->end) {
    const unsigned how = fuzz_u8(bytes);
    const int32_t value = fuzz_i32(bytes) >> (how & 31u);
    switch (how >> 5) {
      case 0: d.yes = !d.yes; break;
      case 1: r.distance = r.lower = r.upper = value; break;
      case 2: r.intersecting = !r.intersecting; break;
      case 3: p.depth = p.lower = p.upper = value; break;
      case 4: p.intersecting = !p.intersecting; break;
      case 5: forge_certificate(bytes, &d.certificate); break;
      case 6: forge_certificate(bytes, &r.certificate); break;
      default: forge_certificate(bytes, &p.certificate);
    }
    if (gjk2_check_decision(&a.collider, &b.collider, asked, &d) == GJK_OK) {
      const int64_t radii = exact.a.shape.radius + exact.b.shape.radius;
      expect(exact2_truth_within(&exact.truth, radii, asked) == d.yes, "a false decision is OK");
    }
    if (gjk2_check_distance(&a.collider, &b.collider, &r) == GJK_OK) {
      const int64_t most = exact.truth.distance < INT32_MAX ? exact.truth.distance : INT32_MAX;
      expect(r.intersecting == exact.truth.intersecting && r.distance == most, "a false distance is OK");
    }
    if (gjk2_check_penetration(&a.collider, &b.collider, &p) == GJK_OK) {
      expect(p.intersecting == exact.truth.intersecting && (!p.intersecting || p.depth == exact.truth.depth),
             "a false depth is OK");
    }
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz_bytes bytes = {data, data + size};
  strcpy(pair.id, "fuzz");
  fuzz_shape(&bytes, &pair.a);
  fuzz_shape(&bytes, &pair.b);
  why[0] = '\0';
  if (getenv("GJK_FUZZ_PRINT") != NULL) {
    case2_print(stdout, &pair);
    fflush(stdout);
  }
  check_order(&pair.a);
  if (case2_collider_build(&a, &pair.a, false) != GJK_OK || case2_collider_build(&b, &pair.b, false) != GJK_OK) {
    return 0;
  }
  const bool certain = exact2_pair_set(&a.collider, &b.collider, &exact);
  const gjk_q16 asked = fuzz_i32(&bytes) & INT32_MAX;
  gjk2_cache cache = fuzz_cache2(&bytes), other = fuzz_cache2(&bytes);
  const gjk2_distance_result cold = check_distance(NULL, certain), warm = check_distance(&cache, certain);
  expect(cold.intersecting == warm.intersecting && cold.distance == warm.distance, "distance with a cache");
  const gjk2_decision decision = check_within(asked, NULL, certain);
  expect(decision.yes == check_within(asked, &other, certain).yes, "gjk2_within with a cache");
  expect(check_within(0, NULL, certain).yes == cold.intersecting || !certain, "gjk2_within 0");
  const gjk2_penetration_result depth = check_depth(NULL, certain), again = check_depth(&cache, certain);
  expect(depth.intersecting == again.intersecting && (!depth.intersecting || depth.depth == again.depth),
         "depth with a cache");
  check_contacts(&bytes);
  if (certain) {
    forge(&bytes, asked, decision, cold, depth);
    exact2_pair_free(&exact);
    if (case2_collider_build(&b, &pair.b, true) == GJK_OK) {
      const gjk2_distance_result lazy = check_distance(NULL, false);
      expect(lazy.distance == cold.distance && lazy.intersecting == cold.intersecting, "lazy");
    }
  }
  return 0;
}
