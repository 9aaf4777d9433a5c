// What a hull gives: its vertices, its faces for a shape, its volume.
#include "gjk_hull_facets.h"

gjk_status gjk_hull_vertices(const gjk_hull *hull, gjk_vec3 *out, uint16_t capacity) {
  if (hull == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  if (capacity < hull->vertices) {
    return GJK_ERROR_CAPACITY;
  }
  gjk_hull_work w;
  gjk_hull_work_of_hull(hull, &w);
  if (hull->dimension < 2) {
    out[0] = *gjk_hull_point(&w, 0);
    out[hull->vertices - 1] = *gjk_hull_point(&w, w.distinct - 1);
    return GJK_OK;
  }
  for (uint32_t point = 0; point < w.distinct; point++) {
    if (w.next[point] != GJK_HULL_NO_POINT) {
      out[w.next[point]] = *gjk_hull_point(&w, point);
    }
  }
  return GJK_OK;
}

// Faces as they are written.
typedef struct face_list {
  uint16_t *corner, *end;
  uint16_t corner_capacity, face_capacity, corners, faces;
  uint16_t begin;  // of the face that is being written
} face_list;

static bool add_face_corner(face_list *list, uint16_t vertex) {
  if (list->corners == list->corner_capacity) {
    return false;
  }
  list->corner[list->corners++] = vertex;
  return true;
}

static bool end_hull_face(face_list *list) {
  if (list->faces == list->face_capacity) {
    return false;
  }
  list->end[list->faces++] = list->corners;
  list->begin = list->corners;
  return true;
}

// Adds a corner to the face. A face that is full ends, and the next one begins with its first and its last corner.
static bool add_to_face(face_list *list, uint16_t vertex) {
  if (list->corners - list->begin == GJK_FACE_CORNERS_MAX) {
    const uint16_t first = list->corner[list->begin], last = list->corner[list->corners - 1];
    if (!end_hull_face(list) || !add_face_corner(list, first) || !add_face_corner(list, last)) {
      return false;
    }
  }
  return add_face_corner(list, vertex);
}

// Both sides of a polygon whose corners are numbered from 0 to count - 1 by w->order of the outline.
static bool write_flat_faces(const gjk_hull_work *w, const gjk_hull *hull, face_list *list) {
  for (unsigned side = 0; side < 2; side++) {
    for (uint32_t i = 0; i < hull->vertices; i++) {
      const uint32_t at = side == 0 ? i : hull->vertices - 1u - i;
      if (!add_to_face(list, (uint16_t)w->of[at])) {
        return false;
      }
    }
    if (!end_hull_face(list)) {
      return false;
    }
  }
  return true;
}

static bool write_facets(gjk_hull_work *w, face_list *list) {
  gjk_hull_facet facet = {0, {0, 0}, {0, 0}, true};
  uint16_t vertex;
  gjk_hull_clear_facets(w);
  while (gjk_hull_next_facet(w, &facet)) {              // each facet once
    while (gjk_hull_next_corner(w, &facet, &vertex)) {  // each corner once
      if (!add_to_face(list, vertex)) {
        return false;
      }
    }
    if (!end_hull_face(list)) {
      return false;
    }
  }
  return true;
}

gjk_status gjk_hull_write_faces(const gjk_hull *hull, uint16_t *corner, uint16_t corner_capacity, uint16_t *end,
                                uint16_t face_capacity, gjk_hull_faces *out) {
  if (hull == NULL || corner == NULL || end == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_hull_work w;
  gjk_hull_work_of_hull(hull, &w);
  face_list list = {NULL, NULL, corner_capacity, face_capacity, 0, 0, 0};
  list.corner = corner;
  list.end = end;
  const bool all =
      hull->dimension < 2 || (hull->dimension == 2 ? write_flat_faces(&w, hull, &list) : write_facets(&w, &list));
  if (!all) {
    return GJK_ERROR_CAPACITY;
  }
  out->corner = corner;
  out->end = end;
  out->count = list.faces;
  return GJK_OK;
}

// The tetrahedra from one vertex of the hull to each of its triangles fill it once.
gjk_status gjk_hull_get_volume(const gjk_hull *hull, gjk_hull_volume *six_times) {
  if (hull == NULL || six_times == NULL) {
    return GJK_ERROR_NULL;
  }
  gjk_hull_work w;
  gjk_hull_work_of_hull(hull, &w);
  uint64_t high = 0, low = 0;  // 2^31 high + low. All together are at most 6 times the box of the points, below 2^90
  for (uint32_t at = 0; at < w.triangles; at++) {
    if ((w.triangle[at].flags & GJK_HULL_SEEN) != 0) {
      continue;
    }
    gjk_hull_plane plane;
    gjk_hull_set_plane(&w, &w.triangle[at], &plane);
    uint32_t part;
    const int64_t height =
        -gjk_hull_height(&plane, gjk_hull_point(&w, 0), &part);  // -2^31 height' - part, not negative
    high += (uint64_t)height;
    low += part;  // below 2^48 in all
  }
  // 2^31 high - low, with high < 2^59 + 2^17
  const uint64_t borrow = (low + 0x7FFFFFFFu) >> 31;
  high -= borrow;
  low = (borrow << 31) - low;
  six_times->high = high >> 33;
  six_times->low = high << 31 | low;
  return GJK_OK;
}
