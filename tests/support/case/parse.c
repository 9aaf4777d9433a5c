// Reads cases from a stream: lines, words, and the grammar of parse.h.
#include "parse.h"

#include <errno.h>
#include <stdarg.h>
#include <string.h>

#include "number.h"

#define LENGTH_BITS 16
#define QUATERNION_BITS 30

// What was read of one shape.
typedef struct side {
  case_shape *shape;
  char letter;
  bool kind, faces, convex_radius, at, turn;  // seen
  gjk_q16 own_radius, round_radius;           // of a sphere or capsule; of 'round'
} side;

static void complain(case_reader *reader, const char *format, ...) {
  va_list arguments;
  fprintf(stderr, "%s:%lu: ", reader->name, reader->line);
  va_start(arguments, format);
  vfprintf(stderr, format, arguments);
  va_end(arguments);
  fputc('\n', stderr);
  reader->errors++;
  reader->failed = true;
}

static bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

static const char *skip_blanks(const char *text) {
  while (is_blank(*text)) {
    text++;
  }
  return text;
}

// Splits off the next word. NULL: the line ends, or a comment begins.
static char *next_word(char **cursor) {
  char *word = *cursor + (skip_blanks(*cursor) - *cursor);
  char *end = word;
  if (*word == '\0' || *word == '#') {
    *cursor = word;
    return NULL;
  }
  while (*end != '\0' && !is_blank(*end)) {
    end++;
  }
  *cursor = *end == '\0' ? end : end + 1;
  *end = '\0';
  return word;
}

// Reads one line into text without its end. A byte 0 becomes '?', which no number contains. False: the file ends.
static bool read_line(case_reader *reader) {
  size_t length = 0;
  int c = getc(reader->file);
  if (c == EOF) {
    return false;
  }
  reader->line++;
  reader->overlong = false;
  for (; c != EOF && c != '\n'; c = getc(reader->file)) {
    if (length < CASE_LINE_MAX - 1) {
      reader->text[length++] = (char)(c == '\0' ? '?' : c);
    } else {
      reader->overlong = true;
    }
  }
  reader->text[length] = '\0';
  if (reader->line == 1 && strncmp(reader->text, "\xEF\xBB\xBF", 3) == 0) {
    memmove(reader->text, reader->text + 3, length - 2);  // a byte order mark
  }
  return true;
}

// Reads the next line that has a word. False: the file ends.
static bool next_line(case_reader *reader) {
  if (reader->pending) {
    reader->pending = false;
    return true;
  }
  while (read_line(reader)) {
    const char *word = skip_blanks(reader->text);
    if (*word != '\0' && *word != '#') {
      return true;
    }
  }
  if (ferror(reader->file)) {
    fprintf(stderr, "%s: cannot be read%s: %s\n", reader->name, reader->line > 0 ? " to its end" : "", strerror(errno));
    reader->errors++;
    reader->failed = true;
  }
  return false;
}

static bool begins_case(const case_reader *reader) {
  const char *word = skip_blanks(reader->text);
  return strncmp(word, "case", 4) == 0 && (word[4] == '\0' || is_blank(word[4]));
}

// Expects the end of the line.
static bool read_end(case_reader *reader, char *cursor) {
  const char *word = next_word(&cursor);
  if (word != NULL) {
    complain(reader, "expected the end of the line, found '%s'", word);
    return false;
  }
  if (reader->overlong) {
    complain(reader, "expected a line of at most %d characters", CASE_LINE_MAX - 1);
    return false;
  }
  return true;
}

// Expects count numbers, which messages call names, and the end of the line.
static bool read_numbers(case_reader *reader, char *cursor, const char *names, int bits, size_t count, int32_t *out) {
  for (size_t i = 0; i < count; i++) {
    const char *word = next_word(&cursor);
    if (word == NULL) {
      complain(reader, "expected %s: %lu of %lu numbers found", names, (unsigned long)i, (unsigned long)count);
      return false;
    }
    if (!case_number_parse(word, bits, &out[i])) {
      complain(reader, "expected %s: a raw 32-bit integer, or with a decimal point a value from %s, found '%s'", names,
               bits == QUATERNION_BITS ? "-2.0 to below 2.0" : "-32768.0 to below 32768.0", word);
      return false;
    }
  }
  return read_end(reader, cursor);
}

// Reads the next line of a list. False: the file or the case ends.
static bool next_item(case_reader *reader, const char *names) {
  if (!next_line(reader)) {
    complain(reader, "expected %s, found the end of the file", names);
    return false;
  }
  if (begins_case(reader)) {
    complain(reader, "expected %s, found 'case'", names);
    reader->pending = true;
    return false;
  }
  return true;
}

static bool read_vertices(case_reader *reader, case_shape *shape, size_t count) {
  case_shape_set_count(shape, count);
  for (size_t i = 0; i < count; i++) {
    char names[64];
    int32_t v[3];
    snprintf(names, sizeof names, "vertex %lu of %lu, x y z", (unsigned long)(i + 1), (unsigned long)count);
    if (!next_item(reader, names) || !read_numbers(reader, reader->text, names, LENGTH_BITS, 3, v)) {
      return false;
    }
    shape->vertices[i].x = v[0];
    shape->vertices[i].y = v[1];
    shape->vertices[i].z = v[2];
  }
  return true;
}

// Expects a count from 1 to most after a word, and the end of the line.
static bool read_count(case_reader *reader, char *cursor, const char *listed, const char *after, int32_t most,
                       int32_t *count) {
  char *word = next_word(&cursor);
  if (word == NULL || strchr(word, '.') != NULL || !case_number_parse(word, 0, count) || *count < 1 || *count > most) {
    complain(reader, "expected a number of %s from 1 to %ld, found '%s'", listed, (long)most, after,
             word == NULL ? "" : word);
    return false;
  }
  return read_end(reader, cursor);
}

static bool read_hull(case_reader *reader, char *cursor, case_shape *shape) {
  int32_t count;
  return read_count(reader, cursor, "vertices", "hull", GJK_HULL_VERTICES_MAX, &count) &&
         read_vertices(reader, shape, (size_t)count);
}

// Reads the corners of one face, the numbers on a line. They follow those of the faces before.
static bool read_face(case_reader *reader, case_shape *shape, size_t face) {
  char *cursor = reader->text, *word;
  const uint16_t first = face == 0 ? 0 : shape->ends[face - 1];
  uint16_t end = first;
  while ((word = next_word(&cursor)) != NULL) {
    int32_t number;
    if (end - first == GJK_FACE_CORNERS_MAX || strchr(word, '.') != NULL || !case_number_parse(word, 0, &number) ||
        number < 0 || number > UINT16_MAX) {
      complain(reader, "expected face %lu: up to %d vertex numbers, found '%s'", (unsigned long)(face + 1),
               GJK_FACE_CORNERS_MAX, word);
      return false;
    }
    shape->corners[end++] = (uint16_t)number;
  }
  shape->ends[face] = end;
  return read_end(reader, cursor);
}

// Most faces: the numbers of their corners must fit 16 bits.
#define FACES_MAX (UINT16_MAX / GJK_FACE_CORNERS_MAX)

static bool read_faces(case_reader *reader, char *cursor, case_shape *shape) {
  int32_t count;
  if (!read_count(reader, cursor, "faces", "faces", FACES_MAX, &count)) {
    return false;
  }
  case_shape_set_faces(shape, (size_t)count);
  for (size_t i = 0; i < shape->faces; i++) {
    if (!next_item(reader, "the vertex numbers of a face") || !read_face(reader, shape, i)) {
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
static void set_size(side *into, const kind_name *name, const int32_t number[3]) {
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

static bool read_kind(case_reader *reader, char *cursor, side *into, const char *word) {
  int32_t number[3] = {0, 0, 0};
  if (into->kind) {
    complain(reader, "expected one shape for %c, found another: '%s'", into->letter, word);
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
      if (!read_numbers(reader, cursor, name->numbers, LENGTH_BITS, name->count, number)) {
        return false;
      }
      set_size(into, name, number);
      return name->kind != CASE_TRIANGLE || read_vertices(reader, into->shape, 3);
    }
  }
  complain(reader,
           "expected point, segment, triangle, box, hull, sphere, capsule, cylinder, cone, ellipsoid, "
           "round, faces, at or turn after '%c', found '%s'",
           into->letter, word);
  return false;
}

// Marks a property as seen; a second one is an error.
static bool once(case_reader *reader, bool *seen, const side *into, const char *word) {
  if (*seen) {
    complain(reader, "expected '%c %s' only once", into->letter, word);
    return false;
  }
  *seen = true;
  return true;
}

static bool read_property(case_reader *reader, char *cursor, side *into) {
  const char *word = next_word(&cursor);
  int32_t n[4];
  if (word == NULL) {
    word = "";
  }
  if (strcmp(word, "round") == 0) {
    return once(reader, &into->convex_radius, into, word) &&
           read_numbers(reader, cursor, "r after 'round'", LENGTH_BITS, 1, &into->round_radius);
  }
  if (strcmp(word, "faces") == 0) {
    return once(reader, &into->faces, into, word) && read_faces(reader, cursor, into->shape);
  }
  if (strcmp(word, "at") == 0) {
    gjk_vec3 *position = &into->shape->pose.position;
    if (!once(reader, &into->at, into, word) || !read_numbers(reader, cursor, "x y z after 'at'", LENGTH_BITS, 3, n)) {
      return false;
    }
    position->x = n[0];
    position->y = n[1];
    position->z = n[2];
    return true;
  }
  if (strcmp(word, "turn") == 0) {
    gjk_quat *rotation = &into->shape->pose.rotation;
    if (!once(reader, &into->turn, into, word) ||
        !read_numbers(reader, cursor, "x y z w after 'turn'", QUATERNION_BITS, 4, n)) {
      return false;
    }
    rotation->x = n[0];
    rotation->y = n[1];
    rotation->z = n[2];
    rotation->w = n[3];
    return true;
  }
  return read_kind(reader, cursor, into, word);
}

// Adds the convex radii of the shape and of 'round'. A negative one stays, so that the library refuses it.
static bool finish_side(case_reader *reader, const side *of, const char *id) {
  int64_t sum = (int64_t)of->own_radius + of->round_radius;
  if (!of->kind) {
    complain(reader, "expected '%c KIND ...' before the end of case %s", of->letter, id);
    return false;
  }
  if (of->faces && of->shape->kind != CASE_HULL) {
    complain(reader, "expected '%c hull ...' with '%c faces' in case %s", of->letter, of->letter, id);
    return false;
  }
  if (of->own_radius < 0 || of->round_radius < 0) {
    sum = of->own_radius < of->round_radius ? of->own_radius : of->round_radius;
  }
  if (sum > INT32_MAX) {
    complain(reader, "expected a radius and 'round' of %c that add up to less than 32768.0", of->letter);
    return false;
  }
  of->shape->convex_radius = (gjk_q16)sum;
  return true;
}

// Reads the line of 'case', which is in text already.
static bool read_header(case_reader *reader, case_pair *pair) {
  char *cursor = reader->text;
  next_word(&cursor);
  const char *id = skip_blanks(cursor);
  size_t length = 0;
  while (id[length] != '\0' && !is_blank(id[length])) {
    length++;
  }
  if (length == 0 || length >= sizeof pair->id) {
    complain(reader, "expected 'case ID' with an ID of 1 to %d characters", (int)sizeof pair->id - 1);
    return false;
  }
  memcpy(pair->id, id, length);
  pair->id[length] = '\0';
  return true;
}

// Reads the lines of a case, up to the next one.
static bool read_case(case_reader *reader, case_pair *pair) {
  side a = {&pair->a, 'A', false, false, false, false, false, 0, 0};
  side b = {&pair->b, 'B', false, false, false, false, false, 0, 0};
  case_shape_reset(&pair->a);
  case_shape_reset(&pair->b);
  if (!read_header(reader, pair)) {
    return false;
  }
  while (next_line(reader)) {
    if (begins_case(reader)) {
      reader->pending = true;
      break;
    }
    char *cursor = reader->text;
    const char *word = next_word(&cursor);
    bool is_a = word != NULL && strcmp(word, "A") == 0;
    bool is_b = word != NULL && strcmp(word, "B") == 0;
    if (!is_a && !is_b) {
      complain(reader, "expected 'A ...', 'B ...' or 'case ID', found '%s'", word);
      return false;
    }
    if (!read_property(reader, cursor, is_a ? &a : &b)) {
      return false;
    }
  }
  return !reader->failed && finish_side(reader, &a, pair->id) && finish_side(reader, &b, pair->id);
}

void case_reader_open(case_reader *reader, FILE *file, const char *name) {
  memset(reader, 0, sizeof *reader);
  reader->file = file;
  reader->name = name;
}

bool case_reader_next(case_reader *reader, case_pair *pair) {
  reader->failed = false;
  while (next_line(reader)) {
    if (!begins_case(reader)) {
      if (!reader->failed) {
        complain(reader, "expected 'case ID'");
      }
      continue;
    }
    reader->failed = false;
    if (read_case(reader, pair)) {
      return true;
    }
  }
  return false;
}
