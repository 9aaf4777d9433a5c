#include "surface.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

const char *const surface_names[SURFACE_KINDS] = {"flat", "bent", "rough", "cube", "ball", "soup"};

static void reserve(surface *s, uint32_t vertices, uint32_t triangles) {
  s->vertices = calloc(vertices, sizeof *s->vertices);
  s->triangles = calloc(triangles, sizeof *s->triangles);
  s->node_count = GJK_MESH_NODES(triangles);
  s->nodes = calloc(s->node_count, sizeof *s->nodes);
  if (s->vertices == NULL || s->triangles == NULL || s->nodes == NULL) {
    abort();
  }
}

static void add_triangle(surface *s, uint32_t a, uint32_t b, uint32_t c) {
  const gjk_mesh_triangle t = {{a, b, c}};
  s->triangles[s->triangle_count++] = t;
}

static void add_square(random_state *random, surface *s, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
  if (random_below(random, 2) == 0) {
    add_triangle(s, a, b, c);
    add_triangle(s, a, c, d);
  } else {
    add_triangle(s, a, b, d);
    add_triangle(s, b, c, d);
  }
}

static void make_grid(random_state *random, surface *s, uint32_t triangles, int32_t step) {
  const uint32_t side = (uint32_t)sqrt(triangles / 2.0) + 1, half = side / 2;
  reserve(s, (side + 1) * (side + 1), 2 * side * side);
  const double wave = random_range(random, 20, 60) / 6.2831853;
  const int32_t tilt_x = s->kind == SURFACE_FLAT ? random_range(random, -step, step) * (int)random_below(random, 2) : 0;
  const int32_t tilt_y = s->kind == SURFACE_FLAT ? random_range(random, -step, step) * (int)random_below(random, 2) : 0;
  for (uint32_t j = 0; j <= side; j++) {
    for (uint32_t i = 0; i <= side; i++) {
      gjk_vec3 *v = &s->vertices[s->vertex_count++];
      const int32_t x = (int32_t)i - (int32_t)half, y = (int32_t)j - (int32_t)half;
      v->x = x * step;
      v->y = y * step;
      v->z = x * tilt_x + y * tilt_y;
      v->z += s->kind == SURFACE_BENT    ? (int32_t)lrint(step * wave / 8 * (sin(x / wave) + cos(y / wave)))
              : s->kind == SURFACE_ROUGH ? random_range(random, -step / 2, step / 2)
                                         : 0;
    }
  }
  for (uint32_t j = 0; j < side; j++) {
    for (uint32_t i = 0; i < side; i++) {
      const uint32_t a = j * (side + 1) + i;
      add_square(random, s, a, a + 1, a + side + 2, a + side + 1);
    }
  }
}

// Six grids, whose vertices along the edges repeat: places count, not numbers.
static void make_cube(random_state *random, surface *s, uint32_t triangles, int32_t step) {
  const uint32_t side = (uint32_t)sqrt(triangles / 12.0) + 1;
  reserve(s, 6 * (side + 1) * (side + 1), 12 * side * side);
  for (unsigned face = 0; face < 6; face++) {
    const unsigned axis = face / 2;
    const bool minus = face % 2 != 0;
    const uint32_t first = s->vertex_count;
    for (uint32_t j = 0; j <= side; j++) {
      for (uint32_t i = 0; i <= side; i++) {
        int32_t p[3];
        const int32_t along = (int32_t)(2 * i) - (int32_t)side, across = (int32_t)(2 * j) - (int32_t)side;
        p[axis] = minus ? -(int32_t)side : (int32_t)side;
        p[(axis + 1) % 3] = minus ? across : along;
        p[(axis + 2) % 3] = minus ? along : across;
        const gjk_vec3 v = {p[0] * (step / 2), p[1] * (step / 2), p[2] * (step / 2)};
        s->vertices[s->vertex_count++] = v;
      }
    }
    for (uint32_t j = 0; j < side; j++) {
      for (uint32_t i = 0; i < side; i++) {
        const uint32_t a = first + j * (side + 1) + i;
        add_square(random, s, a, a + 1, a + side + 2, a + side + 1);
      }
    }
  }
}

// Each of eight faces is a triangle of rows.
static void make_ball(surface *s, uint32_t triangles, int32_t step) {
  const uint32_t side = (uint32_t)sqrt(triangles / 8.0) + 1;
  const double radius = step * (double)side / 1.5;
  reserve(s, 8 * (side + 1) * (side + 2) / 2, 8 * side * side);
  for (unsigned face = 0; face < 8; face++) {
    const double x = (face & 1) != 0 ? -1 : 1, y = (face & 2) != 0 ? -1 : 1, z = (face & 4) != 0 ? -1 : 1;
    const bool turned = x * y * z < 0;
    const uint32_t first = s->vertex_count;
    for (uint32_t j = 0; j <= side; j++) {
      for (uint32_t i = 0; i + j <= side; i++) {
        const double a = (double)i / side, b = (double)j / side, c = 1 - a - b,
                     scale = radius / sqrt(a * a + b * b + c * c);
        const gjk_vec3 v = {(int32_t)lrint(x * a * scale), (int32_t)lrint(y * b * scale),
                            i + j == side ? 0 : (int32_t)lrint(z * c * scale)};
        s->vertices[s->vertex_count++] = v;
      }
    }
    uint32_t row = first;
    for (uint32_t j = 0; j < side; j++) {
      const uint32_t length = side + 1 - j, next = row + length;
      for (uint32_t i = 0; i + 1 < length; i++) {
        const uint32_t p = row + i, q = row + i + 1, r = next + i;
        add_triangle(s, p, turned ? r : q, turned ? q : r);
        if (i + 2 < length) {
          add_triangle(s, q, turned ? r : r + 1, turned ? r + 1 : r);
        }
      }
      row = next;
    }
  }
}

static void make_soup(random_state *random, surface *s, uint32_t triangles, int32_t step) {
  const int32_t spread = (int32_t)(cbrt(triangles) * step) + 1;
  reserve(s, 3 * triangles, triangles);
  for (uint32_t t = 0; t < triangles; t++) {
    const gjk_vec3 at = {random_range(random, -spread, spread), random_range(random, -spread, spread),
                         random_range(random, -spread, spread)};
    const int32_t size = random_below(random, 4) == 0 ? 1 + step / 1000 : step;
    for (unsigned k = 0; k < 3; k++) {
      const gjk_vec3 v = {at.x + random_range(random, -size, size), at.y + random_range(random, -size, size),
                          at.z + random_range(random, -size, size)};
      s->vertices[s->vertex_count++] = v;
    }
    const uint32_t a = s->vertex_count - 3;
    switch (random_below(random, 12)) {
      case 0: add_triangle(s, a, a, a + 1); break;
      case 1: add_triangle(s, a, a + 1, random_below(random, a + 3)); break;
      case 2: s->triangles[s->triangle_count++] = s->triangles[random_below(random, t + 1)]; break;
      default: add_triangle(s, a, a + 1, a + 2);
    }
  }
  // The second kind may be too long.
  for (uint32_t t = 0; t < triangles; t++) {
    uint32_t *corner = s->triangles[t].corner;
    corner[2] = (int64_t)spread * 2 + 2 * (int64_t)step > GJK_RADIUS_MAX ? corner[0] : corner[2];
  }
}

void surface_make(random_state *random, surface_kind kind, uint32_t triangles, int32_t step, bool two_sided,
                  surface *out) {
  memset(out, 0, sizeof *out);
  out->kind = kind;
  switch (kind) {
    case SURFACE_CUBE: make_cube(random, out, triangles, step); break;
    case SURFACE_BALL: make_ball(out, triangles, step); break;
    case SURFACE_SOUP: make_soup(random, out, triangles, step); break;
    default: make_grid(random, out, triangles, step);
  }
  for (uint32_t i = out->triangle_count; i > 1; i--) {  // in any order
    const uint32_t k = random_below(random, i);
    const gjk_mesh_triangle t = out->triangles[k];
    out->triangles[k] = out->triangles[i - 1];
    out->triangles[i - 1] = t;
  }
  CHECK(gjk_mesh_build(out->vertices, out->vertex_count, out->triangles, out->triangle_count, two_sided, out->nodes,
                       out->node_count, &out->mesh) == GJK_OK);
}

void surface_free(surface *s) {
  free(s->vertices);
  free(s->triangles);
  free(s->nodes);
  memset(s, 0, sizeof *s);
}
