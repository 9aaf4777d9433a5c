// Reads cases from a stream: the grammar of pairs in space.
#include "parse.h"

#include <string.h>

#include "lines.h"
#include "number.h"
#include "parse2.h"

static void set_vertex(void *shape, size_t i, const int32_t *number) {
  const gjk_vec3 v = {number[0], number[1], number[2]};
  ((case_shape *)shape)->vertices[i] = v;
}

static bool read_vertices(case_reader *reader, case_shape *shape, size_t count) {
  case_shape_set_count(shape, count);
  return case_read_points(reader, "x y z", count, 3, set_vertex, shape);
}

static bool read_hull(case_reader *reader, char *cursor, case_shape *shape) {
  int32_t count;
  return case_read_count(reader, cursor, "vertices", "hull", GJK_HULL_VERTICES_MAX, &count) &&
         read_vertices(reader, shape, (size_t)count);
}

// Reads the corners of one face, the numbers on a line. They follow those of the faces before.
static bool read_face(case_reader *reader, case_shape *shape, size_t face) {
  char *cursor = reader->text, *word;
  const uint16_t first = face == 0 ? 0 : shape->ends[face - 1];
  uint16_t end = first;
  while ((word = case_next_word(&cursor)) != NULL) {
    int32_t number;
    if (end - first == GJK_FACE_CORNERS_MAX || strchr(word, '.') != NULL || !case_number_parse(word, 0, &number) ||
        number < 0 || number > UINT16_MAX) {
      case_complain(reader, "expected face %lu: up to %d vertex numbers, found '%s'", (unsigned long)(face + 1),
                    GJK_FACE_CORNERS_MAX, word);
      return false;
    }
    shape->corners[end++] = (uint16_t)number;
  }
  shape->ends[face] = end;
  return case_read_end(reader, cursor);
}

// Most faces: the numbers of their corners must fit 16 bits.
#define FACES_MAX (UINT16_MAX / GJK_FACE_CORNERS_MAX)

static bool read_faces(case_reader *reader, char *cursor, case_shape *shape) {
  int32_t count;
  if (!case_read_count(reader, cursor, "faces", "faces", FACES_MAX, &count)) {
    return false;
  }
  case_shape_set_faces(shape, (size_t)count);
  for (size_t i = 0; i < shape->faces; i++) {
    if (!case_next_item(reader, "the vertex numbers of a face") || !read_face(reader, shape, i)) {
      shape->faces = 0;
      return false;
    }
  }
  return true;
}

typedef struct kind_name {
  const char *word, *numbers;
  case_kind kind;
  unsigned char count;   // numbers after the word
  bool first_is_radius;  // the first number is a convex radius
} kind_name;

static const kind_name kind_names[] = {
    {.word = "point", .numbers = "nothing", .kind = CASE_POINT},
    {.word = "segment", .numbers = "h after 'segment'", .kind = CASE_SEGMENT, .count = 1},
    {.word = "triangle", .numbers = "nothing", .kind = CASE_TRIANGLE},
    {.word = "box", .numbers = "hx hy hz after 'box'", .kind = CASE_BOX, .count = 3},
    {.word = "sphere", .numbers = "r after 'sphere'", .kind = CASE_POINT, .count = 1, .first_is_radius = true},
    {.word = "capsule", .numbers = "r h after 'capsule'", .kind = CASE_SEGMENT, .count = 2, .first_is_radius = true},
    {.word = "cylinder", .numbers = "r h after 'cylinder'", .kind = CASE_CYLINDER, .count = 2},
    {.word = "cone", .numbers = "r h after 'cone'", .kind = CASE_CONE, .count = 2},
    {.word = "ellipsoid", .numbers = "rx ry rz after 'ellipsoid'", .kind = CASE_ELLIPSOID, .count = 3},
};

// Sets the fields of a case from the numbers in the order of its line.
static void set_size(case_side *into, const kind_name *name, const int32_t number[3]) {
  gjk_vec3 *size = &into->shape->size;
  switch (name->kind) {
    case CASE_SEGMENT: size->z = number[name->count - 1]; break;
    case CASE_CYLINDER:
    case CASE_CONE:
      size->x = size->y = number[0];
      size->z = number[1];
      break;
    case CASE_BOX:
    case CASE_ELLIPSOID:
      size->x = number[0];
      size->y = number[1];
      size->z = number[2];
      break;
    default: break;
  }
  into->own_radius = name->first_is_radius ? number[0] : 0;
}

static bool read_kind(case_reader *reader, char *cursor, case_side *into, const char *word) {
  int32_t number[3] = {0, 0, 0};
  if (into->kind) {
    case_complain(reader, "expected one shape for %c, found another: '%s'", into->letter, word);
    return false;
  }
  into->kind = true;
  if (strcmp(word, "hull") == 0) {
    into->shape->kind = CASE_HULL;
    return read_hull(reader, cursor, into->shape);
  }
  for (size_t i = 0; i < sizeof kind_names / sizeof kind_names[0]; i++) {
    const kind_name *name = &kind_names[i];
    if (strcmp(word, name->word) == 0) {
      into->shape->kind = name->kind;
      if (!case_read_numbers(reader, cursor, name->numbers, CASE_LENGTH_BITS, name->count, number)) {
        return false;
      }
      set_size(into, name, number);
      return name->kind != CASE_TRIANGLE || read_vertices(reader, into->shape, 3);
    }
  }
  case_complain(reader,
                "expected point, segment, triangle, box, hull, sphere, capsule, cylinder, cone, ellipsoid, "
                "round, faces, at, turn, to, turn-to or spin after '%c', found '%s'",
                into->letter, word);
  return false;
}

// Reads 'at', 'to' or 'spin', the rest of its line.
static bool read_vec3(case_reader *reader, char *cursor, bool *seen, char letter, const char *word, gjk_vec3 *out) {
  int32_t n[3];
  char names[32];
  snprintf(names, sizeof names, "x y z after '%s'", word);
  if (!case_once(reader, seen, letter, word) || !case_read_numbers(reader, cursor, names, CASE_LENGTH_BITS, 3, n)) {
    return false;
  }
  out->x = n[0];
  out->y = n[1];
  out->z = n[2];
  return true;
}

// Reads 'turn' or 'turn-to'.
static bool read_quat(case_reader *reader, char *cursor, bool *seen, char letter, const char *word, gjk_quat *out) {
  int32_t n[4];
  char names[32];
  snprintf(names, sizeof names, "x y z w after '%s'", word);
  if (!case_once(reader, seen, letter, word) || !case_read_numbers(reader, cursor, names, CASE_ROTATION_BITS, 4, n)) {
    return false;
  }
  out->x = n[0];
  out->y = n[1];
  out->z = n[2];
  out->w = n[3];
  return true;
}

bool case_read_property(case_reader *reader, char *cursor, void *of) {
  case_side *into = of;
  case_shape *shape = into->shape;
  const char *word = case_next_word(&cursor);
  if (word == NULL) {
    word = "";
  }
  if (strcmp(word, "round") == 0) {
    return case_once(reader, &into->convex_radius, into->letter, word) &&
           case_read_numbers(reader, cursor, "r after 'round'", CASE_LENGTH_BITS, 1, &into->round_radius);
  }
  if (strcmp(word, "faces") == 0) {
    return case_once(reader, &into->faces, into->letter, word) && read_faces(reader, cursor, shape);
  }
  if (strcmp(word, "at") == 0) {
    return read_vec3(reader, cursor, &into->at, into->letter, word, &shape->pose.position);
  }
  if (strcmp(word, "turn") == 0) {
    return read_quat(reader, cursor, &into->turn, into->letter, word, &shape->pose.rotation);
  }
  if (strcmp(word, "to") == 0) {
    return read_vec3(reader, cursor, &into->to, into->letter, word, &shape->end.position);
  }
  if (strcmp(word, "turn-to") == 0) {
    return read_quat(reader, cursor, &into->turn_to, into->letter, word, &shape->end.rotation);
  }
  if (strcmp(word, "spin") == 0) {
    return read_vec3(reader, cursor, &into->spin, into->letter, word, &shape->spin);
  }
  return read_kind(reader, cursor, into, word);
}

bool case_finish_side(case_reader *reader, const case_side *of, const char *id) {
  int32_t sum;
  if (!case_add_radii(reader, of->kind, of->letter, id, of->own_radius, of->round_radius, &sum)) {
    return false;
  }
  if (of->faces && of->shape->kind != CASE_HULL) {
    case_complain(reader, "expected '%c hull ...' with '%c faces' in case %s", of->letter, of->letter, id);
    return false;
  }
  case_shape *shape = of->shape;
  shape->convex_radius = sum;
  shape->end.position = of->to ? shape->end.position : shape->pose.position;
  shape->end.rotation = of->turn_to ? shape->end.rotation : shape->pose.rotation;
  shape->moves = of->to || of->turn_to;
  return true;
}

// Reads the lines of a case, up to the next one.
static bool read_case(case_reader *reader, case_pair *pair) {
  case_side a = {.shape = &pair->a, .letter = 'A'}, b = {.shape = &pair->b, .letter = 'B'};
  case_shape_reset(&pair->a);
  case_shape_reset(&pair->b);
  return case_read_id(reader, pair->id) && case_read_sides(reader, case_read_property, &a, &b) &&
         case_finish_side(reader, &a, pair->id) && case_finish_side(reader, &b, pair->id);
}

void case_reader_open(case_reader *reader, FILE *file, const char *name) {
  memset(reader, 0, sizeof *reader);
  reader->file = file;
  reader->name = name;
}

case_found case_reader_next_any(case_reader *reader, case_pair *pair, case2_pair *plane) {
  reader->failed = false;
  while (case_next_line(reader)) {
    const bool of_plane = case_begins_plane(reader);
    if (!case_begins(reader) || (of_plane && plane == NULL)) {
      if (!reader->failed) {
        case_complain(reader, "expected 'case ID'");
      }
      continue;
    }
    reader->failed = false;
    if (of_plane ? case2_read(reader, plane) : read_case(reader, pair)) {
      return of_plane ? CASE_FOUND_PLANE : CASE_FOUND_SPACE;
    }
  }
  return CASE_FOUND_NONE;
}

bool case_reader_next(case_reader *reader, case_pair *pair) {
  return case_reader_next_any(reader, pair, NULL) == CASE_FOUND_SPACE;
}
