// Step 1 of gjk_contact_polygon.c for shapes with a list of vertices: triangle and hull. Corners are exact.
#include "gjk_polygon_kind.h"

// Corners of a hull at most this far behind its farthest vertex count as farthest: 4 LSB, Q30.
#define LEVEL_SLACK (INT64_C(4) << 30)

// Faces whose keys differ by less meet the direction equally well: their normals are within about a degree of each
// other. The first face stays then, so that rounding does not choose.
#define ALIKE_KEY 64

// Added to the key of a face with two farthest corners, which prefers it to every face with one: keys are below 2^22.
#define SHARES_EDGE (UINT32_C(1) << 23)

// Sums the normals of the triangles that make up the face.
//   edges       at most 2^29:             a normal at most 2^58
//   triangles   at most 12 - 2 = 10:      the sum below 2^62
static void set_polygon_normal(gjk_polygon *p) {
  gjk_long3 n = {0, 0, 0};
  for (unsigned i = 2; i < p->count; i++) {
    gjk_long3 part;
    gjk_triangle_normal(&p->corner[0], &p->corner[i - 1], &p->corner[i], &part);
    n.x += part.x;
    n.y += part.y;
    n.z += part.z;
  }
  //@ assert n.x > -(INT64_C(1) << 62) && n.x < INT64_C(1) << 62;
  //@ assert n.y > -(INT64_C(1) << 62) && n.y < INT64_C(1) << 62;
  //@ assert n.z > -(INT64_C(1) << 62) && n.z < INT64_C(1) << 62;
  p->normal = n;
}

// The side of the triangle that faces the direction; feature 1 is the one that its corners run clockwise on.
void gjk_polygon_from_triangle(const gjk_collider *c, const gjk_vec3 *position, gjk_polygon *out) {
  for (unsigned i = 0; i < 3; i++) {
    gjk_polygon_set_corner(out, i, position, &c->frame[i], i);
  }
  out->count = 3;
  set_polygon_normal(out);
  if (gjk_dot_sign(&out->normal, &out->direction) < 0) {
    gjk_polygon_set_corner(out, 1, position, &c->frame[2], 2);
    gjk_polygon_set_corner(out, 2, position, &c->frame[1], 1);
    gjk_polygon_negate(&out->normal);
    out->feature = 1;
  }
}

// Loads face i of a hull. Returns how many corners reach limit along the direction, at most 2.
static unsigned load_face(const gjk_collider *c, const gjk_vec3 *position, uint32_t i, int64_t limit,
                          gjk_polygon *out) {
  const gjk_hull_faces *faces = c->shape->faces;
  const uint16_t first = i == 0 ? 0 : faces->end[i - 1];
  unsigned farthest = 0;
  out->count = (uint8_t)(faces->end[i] - first);
  for (unsigned k = 0; k < out->count; k++) {
    gjk_vec3 offset;
    const uint16_t vertex = faces->corner[first + k];
    c->shape->type->vertex(c, vertex, &offset);
    gjk_polygon_set_corner(out, k, position, &offset, vertex);
    farthest += gjk_dot(&offset, &out->direction) >= limit ? 1 : 0;
  }
  out->feature = (uint16_t)i;
  return farthest < 2 ? farthest : 2;
}

// Is a face with a convex radius wide enough for its normal to count? Posing moves its corners by up to 1 LSB. That
// turns a face of width W by about 1 / W, and takes points at the radius off the surface by radius / (2 W^2).
//   W        at least size / length
//   2^root   from sqrt(radius) to 2 sqrt(radius)
// So size >= length 2^root leaves points within 1/2 LSB of the surface.
static bool is_broad(const gjk_polygon *p, gjk_q16 radius) {
  const uint64_t x = gjk_magnitude64(p->normal.x), y = gjk_magnitude64(p->normal.y), z = gjk_magnitude64(p->normal.z);
  const uint64_t size = x > y ? (x > z ? x : z) : (y > z ? y : z);
  uint32_t length = 0;
  for (unsigned i = 1; i < p->count; i++) {
    const uint32_t from_first = gjk_norm1(gjk_sub(p->corner[i], p->corner[0]));  // below 2^31
    length = from_first > length ? from_first : length;
  }
  const unsigned root = radius > 0 ? (33 - gjk_clz32((uint32_t)radius)) / 2 : 0;  // at most 15
  return radius == 0 || size >= (uint64_t)length << root;
}

// The face that meets the direction best among those with two farthest corners; without such, among those with one. Of
// faces that meet it equally well it is the first. A hull without faces offers its farthest vertex.
void gjk_polygon_from_hull(const gjk_collider *c, const gjk_vec3 *position, gjk_polygon *out) {
  const gjk_hull_faces *faces = c->shape->faces;
  uint32_t best = 0, best_face = 0;
  gjk_support found;
  if (faces == NULL || faces->count == 0) {
    return;
  }
  c->shape->type->support(c, &out->direction, &found);
  const int64_t limit = gjk_dot(&found.offset, &out->direction) - LEVEL_SLACK;
  for (uint32_t i = 0; i < faces->count; i++) {
    const unsigned farthest = load_face(c, position, i, limit, out);
    if (farthest > 0) {
      set_polygon_normal(out);
      const uint32_t key =
          is_broad(out, c->shape->convex_radius) ? gjk_polygon_alignment(&out->normal, &out->direction) : 0;
      const uint32_t score = key > 0 && farthest > 1 ? key + SHARES_EDGE : key;
      if (score > best + (best > 0 ? ALIKE_KEY : 0)) {
        best = score;
        best_face = i;
      }
    }
  }
  if (best > 0) {
    load_face(c, position, best_face, limit, out);
    set_polygon_normal(out);
  } else {
    out->count = 1;
    out->feature = found.vertex;
  }
}
