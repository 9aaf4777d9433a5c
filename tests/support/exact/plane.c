// A plane that no vertex of A - B lies beyond.
#include "plane.h"

#include <math.h>

static exact_int square(const exact_int *a) {
  return exact_mul(a, a);
}

void exact_plane_make(const exact_vector *normal, const exact_int *height, exact_plane *out) {
  out->normal = *normal;
  out->height = *height;
  out->squared = exact_from(0);
  for (int i = 0; i < 3; i++) {
    const exact_int term = square(&normal->x[i]);
    out->squared = exact_add(&out->squared, &term);
  }
}

void exact_plane_behind(const exact_feature *feature, exact_plane *out) {
  // With p the nearest point: point = p * denominator, and squared = p . p * denominator = point . p.
  const exact_int height = exact_negate(feature->squared);
  exact_vector normal;
  for (int i = 0; i < 3; i++) {
    normal.x[i] = exact_negate(feature->point.x[i]);
  }
  exact_plane_make(&normal, &height, out);
}

int exact_plane_compare(const exact_plane *plane, int64_t distance) {
  const exact_int d = exact_from(distance), d_squared = square(&d);
  if (plane->height.sign != d.sign) {
    return plane->height.sign < d.sign ? -1 : 1;
  }
  const exact_int mine = square(&plane->height), other = exact_mul(&d_squared, &plane->squared);
  return d.sign * exact_compare(&mine, &other);
}

double exact_plane_height(const exact_plane *plane) {
  return exact_to_double(&plane->height) / sqrt(exact_to_double(&plane->squared));
}

int64_t exact_plane_ceiling(const exact_plane *plane) {
  int64_t least = (int64_t)ceil(exact_plane_height(plane)) - 2;
  while (exact_plane_compare(plane, least) > 0) {  // 3 times at most: the double is off by less than 1
    least++;
  }
  return least;
}

int exact_plane_order(const exact_plane *a, const exact_plane *b) {
  const exact_int a_squared = square(&a->height), b_squared = square(&b->height);
  const exact_int first = exact_mul(&a_squared, &b->squared), second = exact_mul(&b_squared, &a->squared);
  return exact_compare(&first, &second);
}
