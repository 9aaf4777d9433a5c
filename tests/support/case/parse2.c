// Reads cases from a stream: the grammar of pairs in the plane.
#include "parse2.h"

#include <string.h>

#include "lines.h"

// What was read of one shape.
typedef struct side2 {
  case2_shape *shape;
  char letter;
  bool kind, convex_radius, at, turn, to, turn_to, spin;  // seen
  int32_t own_radius, round_radius;                       // of a circle or capsule; of 'round'
} side2;

typedef struct kind2_name {
  const char *word, *numbers;
  case2_kind kind;
  unsigned char count;   // numbers after the word
  bool first_is_radius;  // the first number is a convex radius
} kind2_name;

static const kind2_name kind_names[] = {
    {.word = "point", .numbers = "nothing", .kind = CASE2_POINT},
    {.word = "segment", .numbers = "h after 'segment'", .kind = CASE2_SEGMENT, .count = 1},
    {.word = "triangle", .numbers = "nothing", .kind = CASE2_TRIANGLE},
    {.word = "box", .numbers = "hx hy after 'box'", .kind = CASE2_BOX, .count = 2},
    {.word = "circle", .numbers = "r after 'circle'", .kind = CASE2_POINT, .count = 1, .first_is_radius = true},
    {.word = "capsule", .numbers = "r h after 'capsule'", .kind = CASE2_SEGMENT, .count = 2, .first_is_radius = true},
    {.word = "ellipse", .numbers = "rx ry after 'ellipse'", .kind = CASE2_ELLIPSE, .count = 2},
};

static void set_vertex(void *shape, size_t i, const int32_t *number) {
  const gjk2_vec v = {number[0], number[1]};
  ((case2_shape *)shape)->vertices[i] = v;
}

static bool read_vertices(case_reader *reader, case2_shape *shape, size_t count) {
  case2_shape_set_count(shape, count);
  return case_read_points(reader, "x y", count, 2, set_vertex, shape);
}

static bool read_polygon(case_reader *reader, char *cursor, case2_shape *shape) {
  int32_t count;
  shape->kind = CASE2_POLYGON;
  return case_read_count(reader, cursor, "vertices", "polygon", GJK2_POLYGON_VERTICES_MAX, &count) &&
         read_vertices(reader, shape, (size_t)count);
}

static bool read_kind(case_reader *reader, char *cursor, side2 *into, const char *word) {
  int32_t number[2] = {0, 0};
  if (into->kind) {
    case_complain(reader, "expected one shape for %c, found another: '%s'", into->letter, word);
    return false;
  }
  into->kind = true;
  if (strcmp(word, "polygon") == 0) {
    return read_polygon(reader, cursor, into->shape);
  }
  for (size_t i = 0; i < sizeof kind_names / sizeof kind_names[0]; i++) {
    const kind2_name *name = &kind_names[i];
    if (strcmp(word, name->word) == 0) {
      into->shape->kind = name->kind;
      if (!case_read_numbers(reader, cursor, name->numbers, CASE_LENGTH_BITS, name->count, number)) {
        return false;
      }
      into->own_radius = name->first_is_radius ? number[0] : 0;
      into->shape->size.x = name->first_is_radius ? number[1] : number[0];
      into->shape->size.y = name->first_is_radius ? 0 : number[1];
      return name->kind != CASE2_TRIANGLE || read_vertices(reader, into->shape, 3);
    }
  }
  case_complain(
      reader,
      "expected point, segment, triangle, box, polygon, circle, capsule, ellipse, round, at, turn, to, turn-to or "
      "spin after '%c', "
      "found '%s'",
      into->letter, word);
  return false;
}

// Reads 'at' or 'to', or with other names 'turn' or 'turn-to', the rest of its line.
static bool read_two(case_reader *reader, char *cursor, bool *seen, char letter, const char *word, int bits,
                     int32_t n[2]) {
  char names[32];
  snprintf(names, sizeof names, "%s after '%s'", bits == CASE_LENGTH_BITS ? "x y" : "c s", word);
  return case_once(reader, seen, letter, word) && case_read_numbers(reader, cursor, names, bits, 2, n);
}

static bool read_vec(case_reader *reader, char *cursor, bool *seen, char letter, const char *word, gjk2_vec *out) {
  int32_t n[2];
  if (!read_two(reader, cursor, seen, letter, word, CASE_LENGTH_BITS, n)) {
    return false;
  }
  out->x = n[0];
  out->y = n[1];
  return true;
}

static bool read_rotation(case_reader *reader, char *cursor, bool *seen, char letter, const char *word,
                          gjk2_rotation *out) {
  int32_t n[2];
  if (!read_two(reader, cursor, seen, letter, word, CASE_ROTATION_BITS, n)) {
    return false;
  }
  out->c = n[0];
  out->s = n[1];
  return true;
}

static bool read_property(case_reader *reader, char *cursor, void *of) {
  side2 *into = of;
  case2_shape *shape = into->shape;
  const char *word = case_next_word(&cursor);
  word = word == NULL ? "" : word;
  if (strcmp(word, "round") == 0) {
    return case_once(reader, &into->convex_radius, into->letter, word) &&
           case_read_numbers(reader, cursor, "r after 'round'", CASE_LENGTH_BITS, 1, &into->round_radius);
  }
  if (strcmp(word, "at") == 0) {
    return read_vec(reader, cursor, &into->at, into->letter, word, &shape->pose.position);
  }
  if (strcmp(word, "turn") == 0) {
    return read_rotation(reader, cursor, &into->turn, into->letter, word, &shape->pose.rotation);
  }
  if (strcmp(word, "to") == 0) {
    return read_vec(reader, cursor, &into->to, into->letter, word, &shape->end.position);
  }
  if (strcmp(word, "turn-to") == 0) {
    return read_rotation(reader, cursor, &into->turn_to, into->letter, word, &shape->end.rotation);
  }
  if (strcmp(word, "spin") == 0) {
    return case_once(reader, &into->spin, into->letter, word) &&
           case_read_numbers(reader, cursor, "angle after 'spin'", CASE_LENGTH_BITS, 1, &shape->spin);
  }
  return read_kind(reader, cursor, into, word);
}

// Where no end of the way is given, it is the start.
static bool finish_side(case_reader *reader, const side2 *of, const char *id) {
  case2_shape *shape = of->shape;
  shape->end.position = of->to ? shape->end.position : shape->pose.position;
  shape->end.rotation = of->turn_to ? shape->end.rotation : shape->pose.rotation;
  shape->moves = of->to || of->turn_to;
  return case_add_radii(reader, of->kind, of->letter, id, of->own_radius, of->round_radius, &shape->convex_radius);
}

bool case2_read(case_reader *reader, case2_pair *pair) {
  side2 a = {.shape = &pair->a, .letter = 'A'}, b = {.shape = &pair->b, .letter = 'B'};
  case2_shape_reset(&pair->a);
  case2_shape_reset(&pair->b);
  return case_read_id(reader, pair->id) && case_read_sides(reader, read_property, &a, &b) &&
         finish_side(reader, &a, pair->id) && finish_side(reader, &b, pair->id);
}
