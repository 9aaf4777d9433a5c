// Wavefront OBJ and OFF: vertices, and faces by their numbers.
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "read.h"

static bool read_vertex(read_text *text, mesh *m) {
  double xyz[3];
  for (int i = 0; i < 3; i++) {
    if (!read_double(text, &xyz[i])) {
      return mesh_fail(text->file, "a vertex has three coordinates");
    }
  }
  return mesh_add_point(m, text->file, xyz);
}

// A corner: i, i/t, i/t/n or i//n, counted from 1, or back from -1.
static bool read_corner(read_text *text, const mesh *m, int64_t *out) {
  char word[80], *end;
  if (!read_any_word(text, word, sizeof word)) {
    return false;
  }
  errno = 0;
  const long long number = strtoll(word, &end, 10);
  if ((*end != '\0' && *end != '/') || end == word || errno != 0 || number == 0) {
    return mesh_fail(text->file, "'%s' is no corner of a face", word);
  }
  *out = number > 0 ? number - 1 : (int64_t)m->points + number;
  return true;
}

bool read_obj(mesh *m, mesh_file *file) {
  static int64_t corner[READ_CORNERS_MAX];
  read_text text = {file, 0};
  while (read_next_line(&text)) {
    if (read_word(&text, "v")) {
      if (!read_vertex(&text, m)) {
        return false;
      }
    } else if (read_word(&text, "f")) {
      size_t corners = 0;
      while (corners < READ_CORNERS_MAX && read_corner(&text, m, &corner[corners])) {
        corners++;
      }
      if (corners == READ_CORNERS_MAX && !read_line_ends(&text)) {
        return mesh_fail(file, "a face has 3 to %d corners", READ_CORNERS_MAX);
      }
      if (file->problem[0] != '\0' || !mesh_add_polygon(m, file, corner, corners)) {
        return false;
      }
    }
  }
  return true;
}

// A number that may stand on any line.
static bool read_count(read_text *text, int64_t *out) {
  while (!read_integer(text, out)) {
    if (text->file->problem[0] != '\0' || !read_next_line(text)) {
      return mesh_fail(text->file, "the file ends early");
    }
  }
  return true;
}

bool read_off(mesh *m, mesh_file *file) {
  static int64_t corner[READ_CORNERS_MAX];
  read_text text = {file, 0};
  int64_t vertices, faces, edges;
  if (!read_next_line(&text) || !read_word(&text, "OFF")) {
    return mesh_fail(file, "the file does not begin with OFF");
  }
  if (!read_count(&text, &vertices) || !read_count(&text, &faces) || !read_count(&text, &edges)) {
    return false;
  }
  if (vertices < 0 || faces < 0) {
    return mesh_fail(file, "a number of vertices or faces below 0");
  }
  for (int64_t i = 0; i < vertices; i++) {
    if (!read_next_line(&text) || !read_vertex(&text, m)) {
      return mesh_fail(file, "the file ends early");
    }
  }
  for (int64_t i = 0; i < faces; i++) {
    int64_t corners;
    if (!read_next_line(&text) || !read_integer(&text, &corners)) {
      return mesh_fail(file, "the file ends early");
    }
    if (corners < 3 || corners > READ_CORNERS_MAX) {
      return mesh_fail(file, "a face has 3 to %d corners", READ_CORNERS_MAX);
    }
    for (int64_t j = 0; j < corners; j++) {
      if (!read_integer(&text, &corner[j])) {
        return mesh_fail(file, "a face with fewer corners than it says");
      }
    }
    if (!mesh_add_polygon(m, file, corner, (size_t)corners)) {
      return false;
    }
  }
  return true;
}
