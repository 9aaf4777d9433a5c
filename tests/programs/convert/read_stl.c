// STL: triangles by their corners' coordinates, as text or as 32-bit floats, little-endian.
#include <stdlib.h>
#include <string.h>

#include "read.h"

static uint32_t little32(const char *bytes) {
  uint32_t word = 0;
  for (int i = 3; i >= 0; i--) {
    word = word << 8 | (unsigned char)bytes[i];
  }
  return word;
}

static double little_float(const char *bytes) {
  const uint32_t word = little32(bytes);
  float value;
  memcpy(&value, &word, sizeof value);
  return value;
}

// The last three points are a triangle.
static bool add_triangle(mesh *m, mesh_file *file) {
  const int64_t last = (int64_t)m->points - 1, corner[3] = {last - 2, last - 1, last};
  return mesh_add_polygon(m, file, corner, 3);
}

static bool read_binary(mesh *m, mesh_file *file, uint32_t triangles) {
  for (uint32_t t = 0; t < triangles; t++) {
    const char *corner = file->text + 84 + 50 * (size_t)t + 12;
    for (int i = 0; i < 3; i++, corner += 12) {
      const double xyz[3] = {little_float(corner), little_float(corner + 4), little_float(corner + 8)};
      if (!mesh_add_point(m, file, xyz)) {
        return mesh_fail_at(file, "triangle", (long)t);
      }
    }
    if (!add_triangle(m, file)) {
      return false;
    }
  }
  return true;
}

static bool read_text_stl(mesh *m, mesh_file *file) {
  read_text text = {file, 0};
  unsigned corners = 0;
  bool ended = false;
  if (!read_next_line(&text) || !read_word(&text, "solid") || memchr(file->text, '\0', file->bytes) != NULL) {
    file->line = 0;
    return mesh_fail(file, "neither STL as text, which begins with solid, nor as bytes of the length it says");
  }
  while (read_next_line(&text)) {
    if (read_word(&text, "vertex")) {
      double xyz[3];
      for (int i = 0; i < 3; i++) {
        if (!read_double(&text, &xyz[i])) {
          return mesh_fail(file, "a vertex has three coordinates");
        }
      }
      if (!mesh_add_point(m, file, xyz)) {
        return false;
      }
      corners++;
    } else if (read_word(&text, "endloop")) {
      if (corners != 3 || !add_triangle(m, file)) {
        return mesh_fail(file, "a loop of other than 3 corners");
      }
      corners = 0;
    }
    ended = corners == 0 && (ended || read_word(&text, "endsolid")) && !read_word(&text, "facet");
  }
  return ended || mesh_fail(file, "the file ends without endsolid");
}

bool read_stl(mesh *m, mesh_file *file) {
  const uint32_t triangles = file->bytes >= 84 ? little32(file->text + 80) : 0;
  if (file->bytes >= 84 && file->bytes == 84 + 50 * (size_t)triangles) {
    return read_binary(m, file, triangles);
  }
  return read_text_stl(m, file);
}
