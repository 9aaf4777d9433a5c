// Solids: planes, volume, closed or not, inside or outside.
#include "solid.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "areas.h"
#include "exact/integer.h"

static int64_t magnitude(int64_t a) {
  return a < 0 ? -a : a;
}

static int64_t common_divisor(int64_t a, int64_t b) {
  while (b != 0) {
    const int64_t rest = a % b;
    a = b;
    b = rest;
  }
  return a;
}

solid_plane solid_plane_of(const int32_t a[3], const int32_t b[3], const int32_t c[3]) {
  solid_plane plane;
  int64_t divisor = 0;
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    // differences at most 2^29: two products at most 2^58
    plane.n[i] = (int64_t)(b[j] - a[j]) * (c[k] - a[k]) - (int64_t)(b[k] - a[k]) * (c[j] - a[j]);
    divisor = common_divisor(divisor, magnitude(plane.n[i]));
  }
  plane.d = 0;
  for (int i = 0; i < 3 && divisor > 0; i++) {
    plane.n[i] /= divisor;
    plane.d += (solid_wide)plane.n[i] * a[i];
  }
  return plane;
}

solid_wide solid_height(const solid_plane *plane, const int32_t x[3]) {
  return (solid_wide)plane->n[0] * x[0] + (solid_wide)plane->n[1] * x[1] + (solid_wide)plane->n[2] * x[2] - plane->d;
}

bool solid_is_apart(const int32_t low[3], const int32_t high[3], const int32_t lowest[3], const int32_t highest[3]) {
  return low[0] > highest[0] || low[1] > highest[1] || low[2] > highest[2] || high[0] < lowest[0] ||
         high[1] < lowest[1] || high[2] < lowest[2];
}

static int by_value(const void *a, const void *b) {
  const uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
  return (x > y) - (x < y);
}

// Has each edge as many opposites as there are of it? The first that has not goes to edge.
static bool is_closed(const mesh *m, uint64_t *edge) {
  const size_t edges = 3 * m->triangles;
  uint64_t *forth = solid_allocate(edges, sizeof forth[0]), *back = solid_allocate(edges, sizeof back[0]);
  for (size_t i = 0; i < edges; i++) {
    const uint64_t from = m->triangle[i / 3][i % 3], to = m->triangle[i / 3][(i + 1) % 3];
    forth[i] = from << 32 | to;
    back[i] = to << 32 | from;
  }
  qsort(forth, edges, sizeof forth[0], by_value);
  qsort(back, edges, sizeof back[0], by_value);
  bool closed = edges > 0;
  for (size_t i = 0; i < edges && closed; i++) {
    closed = forth[i] == back[i];
    *edge = forth[i] < back[i] ? forth[i] : back[i] >> 32 | back[i] << 32;
  }
  free(forth);
  free(back);
  return closed;
}

static solid_wide triangle_volume6(const solid *s, const uint32_t corner[3]) {
  const int32_t *a = s->point[corner[0]], *b = s->point[corner[1]], *c = s->point[corner[2]];
  solid_wide sum = 0;
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    sum += (solid_wide)a[i] * ((int64_t)b[j] * c[k] - (int64_t)b[k] * c[j]);  // at most 2^88
  }
  return sum;
}

// Puts points and triangles in an order that depends on the surface alone: then so does all that is made of them.
static int by_place(const void *a, const void *b) {
  const int32_t *p = a, *q = b;
  for (int j = 0; j < 3; j++) {
    if (p[j] != q[j]) {
      return p[j] < q[j] ? -1 : 1;
    }
  }
  return 0;
}

static int by_corners(const void *a, const void *b) {
  const uint32_t *p = a, *q = b;
  for (int j = 0; j < 3; j++) {
    if (p[j] != q[j]) {
      return p[j] < q[j] ? -1 : 1;
    }
  }
  return 0;
}

static void sort_surface(solid *s) {
  int32_t(*sorted)[3] = solid_allocate(s->points, sizeof sorted[0]);
  memcpy(sorted, s->point, s->points * sizeof sorted[0]);
  qsort(sorted, s->points, sizeof sorted[0], by_place);
  for (size_t t = 0; t < s->triangles; t++) {
    uint32_t corner[3];
    int first = 0;
    for (int i = 0; i < 3; i++) {
      const int32_t(*found)[3] = bsearch(s->point[s->triangle[t][i]], sorted, s->points, sizeof sorted[0], by_place);
      corner[i] = (uint32_t)(found - (const int32_t(*)[3])sorted);
      first = corner[i] < corner[first] ? i : first;
    }
    for (int i = 0; i < 3; i++) {
      s->triangle[t][i] = corner[(first + i) % 3];
    }
  }
  free(s->point);
  s->point = sorted;
  qsort(s->triangle, s->triangles, sizeof s->triangle[0], by_corners);
}

// If each triangle is there equally often, keeps one of each: the surface winds around the same points, once instead. Pre: in
// order.
static void drop_copies(solid *s) {
  size_t copies = 0;
  for (size_t i = 0, same; i < s->triangles; i += same) {
    for (same = 1; i + same < s->triangles && by_corners(s->triangle[i], s->triangle[i + same]) == 0; same++) {
    }
    if (copies > 0 && same != copies) {
      return;
    }
    copies = same;
  }
  for (size_t i = 0; i * copies < s->triangles; i++) {
    memmove(s->triangle[i], s->triangle[i * copies], sizeof s->triangle[i]);
  }
  s->triangles /= copies;
  s->volume6 /= (solid_wide)copies;
}

static bool shift_points(solid *s, const mesh *m) {
  int64_t low[3] = {INT32_MAX, INT32_MAX, INT32_MAX}, high[3] = {INT32_MIN, INT32_MIN, INT32_MIN};
  for (size_t i = 0; i < m->points; i++) {
    const int64_t x[3] = {m->point[i].x, m->point[i].y, m->point[i].z};
    for (int j = 0; j < 3; j++) {
      low[j] = x[j] < low[j] ? x[j] : low[j];
      high[j] = x[j] > high[j] ? x[j] : high[j];
    }
  }
  for (int j = 0; j < 3; j++) {
    if (high[j] - low[j] >= SOLID_EXTENT - (1 << 16)) {  // less, since rounding outwards takes room
      return false;
    }
    s->high[j] = (int32_t)(high[j] - low[j]);
  }
  s->origin.x = (gjk_q16)low[0];
  s->origin.y = (gjk_q16)low[1];
  s->origin.z = (gjk_q16)low[2];
  for (size_t i = 0; i < m->points; i++) {
    s->point[i][0] = (int32_t)(m->point[i].x - low[0]);
    s->point[i][1] = (int32_t)(m->point[i].y - low[1]);
    s->point[i][2] = (int32_t)(m->point[i].z - low[2]);
  }
  return true;
}

// The face of the file that a triangle is of, 0: unknown.
static unsigned long face_of(const mesh *m, size_t triangle) {
  return m->face == NULL ? 0 : m->face[triangle];
}

// Says which edge has no opposite, and of which faces it is.
static void tell_open(const mesh *m, uint64_t edge, char *problem, size_t room) {
  const gjk_vec3 a = m->point[edge >> 32], b = m->point[edge & UINT32_MAX];
  size_t found[2] = {0, 0}, count = 0;
  for (size_t i = 0; i < 3 * m->triangles && count < 2; i++) {
    const uint64_t from = m->triangle[i / 3][i % 3], to = m->triangle[i / 3][(i + 1) % 3];
    if ((from << 32 | to) == edge) {
      found[count++] = i / 3;
    }
  }
  const int told = snprintf(problem, room,
                            "not watertight, so no solid: the edge from (%ld %ld %ld) to (%ld %ld %ld) LSB of face %lu "
                            "has no opposite",
                            (long)a.x, (long)a.y, (long)a.z, (long)b.x, (long)b.y, (long)b.z, face_of(m, found[0]));
  if (count == 2 && told > 0 && (size_t)told < room) {
    snprintf(problem + told, room - (size_t)told, "; face %lu runs along it the same way", face_of(m, found[1]));
  }
}

// The face of the file with a triangle's three corners.
static unsigned long face_at(const mesh *m, const solid *s, size_t triangle) {
  for (size_t t = 0; t < m->triangles; t++) {
    unsigned same = 0;
    for (int i = 0; i < 9; i++) {
      const gjk_vec3 a = m->point[m->triangle[t][i / 3]];
      const int32_t *b = s->point[s->triangle[triangle][i % 3]];
      same += a.x - s->origin.x == b[0] && a.y - s->origin.y == b[1] && a.z - s->origin.z == b[2];
    }
    if (same == 3) {
      return face_of(m, t);
    }
  }
  return 0;
}

// Copies the triangles, turned outwards, in an order of their own.
static void take_triangles(solid *s, const mesh *m) {
  for (size_t t = 0; t < s->triangles; t++) {
    memcpy(s->triangle[t], m->triangle[t], sizeof s->triangle[t]);
    s->volume6 += triangle_volume6(s, s->triangle[t]);
  }
  const bool inwards = s->volume6 < 0;
  s->volume6 = inwards ? -s->volume6 : s->volume6;
  for (size_t t = 0; t < s->triangles; t++) {
    uint32_t *corner = s->triangle[t];
    if (inwards) {
      const uint32_t kept = corner[1];
      corner[1] = corner[2];
      corner[2] = kept;
    }
  }
  sort_surface(s);
  drop_copies(s);
  for (size_t t = 0; t < s->triangles; t++) {
    const uint32_t *corner = s->triangle[t];
    s->plane[t] = solid_plane_of(s->point[corner[0]], s->point[corner[1]], s->point[corner[2]]);
  }
}

bool solid_from_mesh(solid *s, const mesh *m, char *problem, size_t room) {
  uint64_t edge = 0;
  size_t triangle = 0;
  bool decided;
  memset(s, 0, sizeof *s);
  if (m->triangles == 0) {
    snprintf(problem, room, "no triangles, and a solid is made of them");
    return false;
  }
  if (m->triangles > SOLID_TRIANGLES_MAX) {
    snprintf(problem, room, "%zu triangles, and a solid takes %d", m->triangles, SOLID_TRIANGLES_MAX);
    return false;
  }
  if (!is_closed(m, &edge)) {
    tell_open(m, edge, problem, room);
    return false;
  }
  s->points = m->points;
  s->triangles = m->triangles;
  s->point = solid_allocate(m->points, sizeof s->point[0]);
  s->triangle = solid_allocate(m->triangles, sizeof s->triangle[0]);
  s->plane = solid_allocate(m->triangles, sizeof s->plane[0]);
  if (!shift_points(s, m)) {
    snprintf(problem, room, "the solid is 8191 units wide or more");
    return false;
  }
  take_triangles(s, m);
  if (!area_is_turned_one_way(s, &triangle, &decided)) {
    snprintf(problem, room,
             decided ? "beside face %lu a shell is turned inwards, with no other one around it"
                     : "face %lu crosses others in too many or too small pieces",
             face_at(m, s, triangle));
    return false;
  }
  if (s->volume6 == 0) {
    snprintf(problem, room, "the surface encloses no volume");
    return false;
  }
  return true;
}

void solid_free(solid *s) {
  free(s->point);
  free(s->triangle);
  free(s->plane);
  memset(s, 0, sizeof *s);
}

static int sign_of(solid_wide a) {
  return (a > 0) - (a < 0);
}

static exact_int exact_of(solid_wide a) {
  const exact_int high = exact_from((int64_t)(a >> 64)), half = exact_from((int64_t)1 << 32);
  const exact_int step = exact_mul(&high, &half), top = exact_mul(&step, &half);
  const exact_int middle = exact_from((int64_t)((uint64_t)a >> 32)), shifted = exact_mul(&middle, &half);
  const exact_int low = exact_from((int64_t)((uint64_t)a & UINT32_MAX)), bottom = exact_add(&shifted, &low);
  return exact_add(&top, &bottom);
}

// The sign of n . x / 2^shift - d.
static int side_of_plane(const solid_plane *plane, const solid_wide x[3], int shift) {
  exact_int sum = exact_of(-plane->d);
  const exact_int scale = exact_from((int64_t)1 << shift);
  sum = exact_mul(&sum, &scale);
  for (int i = 0; i < 3; i++) {
    const exact_int n = exact_from(plane->n[i]), at = exact_of(x[i]), product = exact_mul(&n, &at);
    sum = exact_add(&sum, &product);
  }
  return sum.sign;
}

// On which side of the line from a to b is (p, q), if it is moved by (e, e^2) for a tiny e? Coordinates of a and b times
// 2^shift. 0: a = b.
static int turn(const int32_t a[2], const int32_t b[2], solid_wide p, solid_wide q, int shift) {
  const int64_t along = (int64_t)b[0] - a[0], across = (int64_t)b[1] - a[1];
  const solid_wide scale = (solid_wide)1 << shift;
  // differences of points below 2^91, times less than 2^30: sums below 2^122
  const int sign = sign_of(along * (q - a[1] * scale) - across * (p - a[0] * scale));
  return sign != 0 ? sign : across != 0 ? sign_of(-across) : sign_of(along);
}

// Is the coordinate x / 2^shift farther than 1 from the range of three?
static bool is_aside(solid_wide x, int shift, int32_t a, int32_t b, int32_t c) {
  const solid_wide low = a < b ? (a < c ? a : c) : (b < c ? b : c), high = a > b ? (a > c ? a : c) : (b > c ? b : c);
  const solid_wide scale = (solid_wide)1 << shift;
  return x < (low - 1) * scale || x > (high + 1) * scale;
}

bool solid_cross(const solid *s, size_t t, const solid_ray *ray, long *winding) {
  const int axis = ray->axis, p = (axis + 1) % 3, q = (axis + 2) % 3, shift = ray->shift;
  const solid_wide *x = ray->x;
  const solid_plane *plane = &s->plane[t], *within = ray->within;
  const int32_t *a = s->point[s->triangle[t][0]], *b = s->point[s->triangle[t][1]], *c = s->point[s->triangle[t][2]];
  if (plane->n[axis] == 0 || is_aside(x[p], shift, a[p], b[p], c[p]) || is_aside(x[q], shift, a[q], b[q], c[q])) {
    return true;
  }
  const int32_t flat[3][2] = {{a[p], a[q]}, {b[p], b[q]}, {c[p], c[q]}};
  const int first = turn(flat[0], flat[1], x[p], x[q], shift);
  if (first != turn(flat[1], flat[2], x[p], x[q], shift) || first != turn(flat[2], flat[0], x[p], x[q], shift)) {
    return true;
  }
  const int side = side_of_plane(plane, x, shift), way = plane->n[axis] > 0 ? ray->sign : -ray->sign;
  if (side == 0 &&
      (within == NULL || within->n[0] * (solid_wide)plane->n[1] != within->n[1] * (solid_wide)plane->n[0] ||
       within->n[1] * (solid_wide)plane->n[2] != within->n[2] * (solid_wide)plane->n[1] ||
       within->n[2] * (solid_wide)plane->n[0] != within->n[0] * (solid_wide)plane->n[2])) {
    return false;
  }
  *winding += side == -way ? way : 0;
  return true;
}

bool solid_winding(const solid *s, const solid_wide x[3], int shift, int axis, int sign, const solid_plane *within,
                   long *out) {
  const solid_ray ray = {{x[0], x[1], x[2]}, within, shift, axis, sign};
  *out = 0;
  for (size_t t = 0; t < s->triangles; t++) {
    if (!solid_cross(s, t, &ray, out)) {
      return false;
    }
  }
  return true;
}
