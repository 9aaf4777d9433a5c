// PLY: a header that says what follows, as text or as bytes of either order.
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "read.h"

enum { ELEMENTS_MAX = 8, PROPERTIES_MAX = 32 };

typedef enum ply_type {
  PLY_NONE,
  PLY_INT8,
  PLY_UINT8,
  PLY_INT16,
  PLY_UINT16,
  PLY_INT32,
  PLY_UINT32,
  PLY_FLOAT,
  PLY_DOUBLE
} ply_type;

typedef struct ply_property {
  ply_type type, count;  // count: PLY_NONE, or the type of a list's length
  char name[24];
} ply_property;

typedef struct ply_element {
  char name[24];
  int64_t count;
  ply_property property[PROPERTIES_MAX];
  unsigned properties;
} ply_element;

typedef struct ply_reader {
  mesh_file *file;
  mesh *m;
  read_text text;
  enum { PLY_TEXT, PLY_LITTLE, PLY_BIG } form;
  ply_element element[ELEMENTS_MAX];
  unsigned elements;
} ply_reader;

static ply_type type_named(const char *name) {
  static const struct {
    const char *name;
    ply_type type;
  } types[] = {{"char", PLY_INT8},   {"int8", PLY_INT8},     {"uchar", PLY_UINT8},   {"uint8", PLY_UINT8},
               {"short", PLY_INT16}, {"int16", PLY_INT16},   {"ushort", PLY_UINT16}, {"uint16", PLY_UINT16},
               {"int", PLY_INT32},   {"int32", PLY_INT32},   {"uint", PLY_UINT32},   {"uint32", PLY_UINT32},
               {"float", PLY_FLOAT}, {"float32", PLY_FLOAT}, {"double", PLY_DOUBLE}, {"float64", PLY_DOUBLE}};
  for (size_t i = 0; i < sizeof types / sizeof types[0]; i++) {
    if (strcmp(types[i].name, name) == 0) {
      return types[i].type;
    }
  }
  return PLY_NONE;
}

static unsigned size_of(ply_type type) {
  static const unsigned char sizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[type];
}

static bool read_property(ply_reader *r) {
  char word[24];
  if (r->elements == 0 || r->element[r->elements - 1].properties == PROPERTIES_MAX) {
    return mesh_fail(r->file, "a property of no element, or too many of them");
  }
  ply_element *e = &r->element[r->elements - 1];
  ply_property *p = &e->property[e->properties++];
  p->count = PLY_NONE;
  if (read_word(&r->text, "list")) {
    p->count = read_any_word(&r->text, word, sizeof word) ? type_named(word) : PLY_NONE;
    if (p->count == PLY_NONE || p->count >= PLY_FLOAT) {
      return mesh_fail(r->file, "a list without an integer type of its length");
    }
  }
  p->type = read_any_word(&r->text, word, sizeof word) ? type_named(word) : PLY_NONE;
  if (p->type == PLY_NONE || !read_any_word(&r->text, p->name, sizeof p->name)) {
    return mesh_fail(r->file, "a property without a type and a name");
  }
  return true;
}

static bool read_element(ply_reader *r) {
  if (r->elements == ELEMENTS_MAX) {
    return mesh_fail(r->file, "too many elements");
  }
  ply_element *e = &r->element[r->elements++];
  e->properties = 0;
  return (read_any_word(&r->text, e->name, sizeof e->name) && read_integer(&r->text, &e->count) && e->count >= 0) ||
         mesh_fail(r->file, "an element without a name and a number");
}

// Is there something of each element in the file, and a place of each vertex?
static bool check_elements(ply_reader *r) {
  for (unsigned i = 0; i < r->elements; i++) {
    const ply_element *e = &r->element[i];
    unsigned axes = 0;
    for (unsigned n = 0; n < e->properties; n++) {
      const ply_property *p = &e->property[n];
      if (p->count == PLY_NONE && p->name[1] == '\0' && p->name[0] >= 'x' && p->name[0] <= 'z') {
        axes |= 1U << (p->name[0] - 'x');
      }
    }
    if (e->properties == 0 || (strcmp(e->name, "vertex") == 0 && axes != 7)) {
      return mesh_fail(r->file, e->properties == 0 ? "element %s without properties" : "element %s without x, y and z",
                       e->name);
    }
  }
  return true;
}

static bool read_format(ply_reader *r) {
  r->form = read_word(&r->text, "ascii")                  ? PLY_TEXT
            : read_word(&r->text, "binary_little_endian") ? PLY_LITTLE
                                                          : PLY_BIG;
  return r->form != PLY_BIG || read_word(&r->text, "binary_big_endian") || mesh_fail(r->file, "an unknown format");
}

static bool read_header(ply_reader *r) {
  if (!read_next_line(&r->text) || !read_word(&r->text, "ply")) {
    return mesh_fail(r->file, "the file does not begin with ply");
  }
  while (read_next_line(&r->text)) {
    if (read_word(&r->text, "end_header")) {
      return check_elements(r);
    }
    if ((read_word(&r->text, "format") && !read_format(r)) || (read_word(&r->text, "element") && !read_element(r)) ||
        (read_word(&r->text, "property") && !read_property(r))) {
      return false;
    }
  }
  return mesh_fail(r->file, "the header has no end");
}

static double number_of(ply_type type, uint64_t word) {
  const uint32_t low = (uint32_t)word;
  float single;
  double number;
  memcpy(&single, &low, sizeof single);
  memcpy(&number, &word, sizeof number);
  switch (type) {
    case PLY_INT8: return (double)(word < 128 ? (int)word : (int)word - 256);
    case PLY_INT16: return (double)(word < 32768 ? (int)word : (int)word - 65536);
    case PLY_INT32: return word < UINT64_C(2147483648) ? (double)word : (double)word - 4294967296.0;
    case PLY_FLOAT: return single;
    case PLY_DOUBLE: return number;
    default: return (double)word;
  }
}

// One value, as text or as bytes.
static bool read_value(ply_reader *r, ply_type type, double *out) {
  if (r->form == PLY_TEXT) {
    while (!read_double(&r->text, out)) {
      if (r->file->problem[0] != '\0' || !read_next_line(&r->text)) {
        return mesh_fail(r->file, "the file ends early");
      }
    }
    return true;
  }
  const unsigned size = size_of(type);
  uint64_t word = 0;
  if (r->file->bytes - r->text.at < size) {
    return mesh_fail(r->file, "the file ends early");
  }
  for (unsigned i = 0; i < size; i++) {
    const unsigned char byte = (unsigned char)r->file->text[r->text.at + i];
    word |= (uint64_t)byte << 8 * (r->form == PLY_LITTLE ? i : size - 1 - i);
  }
  r->text.at += size;
  *out = number_of(type, word);
  return true;
}

// A list: the face's corners, if that is what it holds.
static bool read_list(ply_reader *r, const ply_element *e, const ply_property *p) {
  static int64_t corner[READ_CORNERS_MAX];
  double length, value;
  if (!read_value(r, p->count, &length)) {
    return false;
  }
  if (!(length >= 0 && length <= READ_CORNERS_MAX) || length != (int)length) {
    return mesh_fail(r->file, "a list of less than 0 or more than %d values", READ_CORNERS_MAX);
  }
  for (int i = 0; i < (int)length; i++) {
    if (!read_value(r, p->type, &value)) {
      return false;
    }
    corner[i] = value >= 0 && value < 4294967296.0 && floor(value) == value ? (int64_t)value : -1;
  }
  const bool face = strcmp(e->name, "face") == 0 && strncmp(p->name, "vertex_ind", 10) == 0;
  return !face || mesh_add_polygon(r->m, r->file, corner, (size_t)length);
}

static bool read_one(ply_reader *r, const ply_element *e) {
  double xyz[3] = {0, 0, 0};
  for (unsigned i = 0; i < e->properties; i++) {
    const ply_property *p = &e->property[i];
    double value;
    if (p->count != PLY_NONE) {
      if (!read_list(r, e, p)) {
        return false;
      }
      continue;
    }
    if (!read_value(r, p->type, &value)) {
      return false;
    }
    if (p->name[1] == '\0' && p->name[0] >= 'x' && p->name[0] <= 'z') {
      xyz[p->name[0] - 'x'] = value;
    }
  }
  return strcmp(e->name, "vertex") != 0 || mesh_add_point(r->m, r->file, xyz);
}

bool read_ply(mesh *m, mesh_file *file) {
  static ply_reader r;
  memset(&r, 0, sizeof r);
  r.file = r.text.file = file;
  r.m = m;
  if (!read_header(&r)) {
    return false;
  }
  if (r.form != PLY_TEXT) {
    read_past_line(&r.text);
  }
  for (unsigned i = 0; i < r.elements; i++) {
    for (int64_t j = 0; j < r.element[i].count; j++) {
      if (!read_one(&r, &r.element[i])) {
        return r.form != PLY_TEXT && mesh_fail_at(file, r.element[i].name, (long)j);
      }
    }
  }
  return true;
}
