// Reads a machine and its edges.
#include "arm_file.h"

#include <string.h>

void arm_file_open(arm_file *file, FILE *stream, const char *name) {
  const gjk_pose identity = GJK_POSE_IDENTITY;
  memset(file, 0, sizeof *file);
  file->base = identity;
  case_reader_open(&file->reader, stream, name);
}

void arm_file_close(arm_file *file) {
  for (unsigned i = 0; i < ARM_PARTS; i++) {
    case_shape_free(&file->part_shapes[i]);
  }
  for (unsigned i = 0; i < ARM_OBSTACLES; i++) {
    case_shape_free(&file->obstacle_shapes[i]);
  }
}

// The last word that a message names.
static bool expect(case_reader *reader, const char *what, const char *found) {
  case_complain(reader, "expected %s, found '%s'", what, found == NULL ? "" : found);
  return false;
}

static bool read_name(arm_file *f, char **cursor, const char *what, char name[CASE_ID_MAX]) {
  const char *word = case_next_word(cursor);
  if (word == NULL || strlen(word) >= CASE_ID_MAX) {
    return expect(&f->reader, what, word);
  }
  strcpy(name, word);
  return true;
}

// Reads the name of a link that is there.
static bool read_link_name(arm_file *f, char **cursor, unsigned *link) {
  char name[CASE_ID_MAX];
  if (!read_name(f, cursor, "the name of a link", name)) {
    return false;
  }
  for (*link = 0; *link < f->link_count; (*link)++) {
    if (strcmp(f->link_names[*link], name) == 0) {
      return true;
    }
  }
  return expect(&f->reader, "the name of a link above", name);
}

static unsigned count_values(const arm_file *f) {
  unsigned count = 0;
  for (unsigned i = 0; i < f->link_count; i++) {
    count += f->links[i].kind != GJK_ARM_FIXED ? 1u : 0u;
  }
  return count;
}

static bool begin_link(arm_file *f, char *cursor) {
  static const char *const kinds[] = {"fixed", "revolute", "prismatic"};
  const gjk_arm_link plain = {GJK_ARM_BASE, GJK_ARM_FIXED, GJK_POSE_IDENTITY, {0, 0, 1}, INT32_MIN, INT32_MAX};
  unsigned parent = GJK_ARM_BASE;
  char *rest;
  if (f->link_count == GJK_ARM_LINKS_MAX) {
    return expect(&f->reader, "at most 32 links", "link");
  }
  if (!read_name(f, &cursor, "the name of the link", f->link_names[f->link_count])) {
    return false;
  }
  rest = cursor + strspn(cursor, " \t");
  const bool on_base = strncmp(rest, "base", 4) == 0 && strchr(" \t", rest[4]) != NULL;
  if (on_base) {
    (void)case_next_word(&cursor);
  } else if (!read_link_name(f, &cursor, &parent)) {
    return false;
  }
  const char *word = case_next_word(&cursor);
  for (unsigned i = 0; word != NULL && i < 3; i++) {
    if (strcmp(word, kinds[i]) == 0) {
      f->links[f->link_count] = plain;
      f->links[f->link_count].parent = (uint8_t)parent;
      f->links[f->link_count].kind = (uint8_t)i;
      f->link_count++;
      return case_read_end(&f->reader, cursor);
    }
  }
  return expect(&f->reader, "fixed, revolute or prismatic", word);
}

static bool read_pose(arm_file *f, const char *word, char *cursor, gjk_pose *pose, bool *done) {
  int32_t n[4];
  *done = true;
  if (strcmp(word, "at") == 0) {
    if (!case_read_numbers(&f->reader, cursor, "x y z after 'at'", CASE_LENGTH_BITS, 3, n)) {
      return false;
    }
    const gjk_vec3 position = {n[0], n[1], n[2]};
    pose->position = position;
    return true;
  }
  if (strcmp(word, "turn") == 0) {
    if (!case_read_numbers(&f->reader, cursor, "x y z w after 'turn'", CASE_ROTATION_BITS, 4, n)) {
      return false;
    }
    const gjk_quat rotation = {n[0], n[1], n[2], n[3]};
    pose->rotation = rotation;
    return true;
  }
  *done = false;
  return true;
}

static bool read_link_line(arm_file *f, char *cursor) {
  gjk_arm_link *link = &f->links[f->link_count - 1];
  const char *word = case_next_word(&cursor);
  int32_t n[3];
  bool done;
  if (word == NULL) {
    return expect(&f->reader, "at, turn, axis or limits after 'L'", word);
  }
  if (!read_pose(f, word, cursor, &link->fixed, &done) || done) {
    return f->reader.errors == 0;
  }
  if (strcmp(word, "axis") == 0) {
    if (!case_read_numbers(&f->reader, cursor, "x y z after 'axis'", CASE_LENGTH_BITS, 3, n)) {
      return false;
    }
    link->axis.x = n[0];
    link->axis.y = n[1];
    link->axis.z = n[2];
    return true;
  }
  if (strcmp(word, "limits") == 0) {
    if (!case_read_numbers(&f->reader, cursor, "lower upper after 'limits'", CASE_LENGTH_BITS, 2, n)) {
      return false;
    }
    link->lower = n[0];
    link->upper = n[1];
    return true;
  }
  return expect(&f->reader, "at, turn, axis or limits after 'L'", word);
}

static void begin_side(arm_file *f, case_shape *shape, char letter) {
  const case_side side = {.shape = shape, .letter = letter};
  case_shape_reset(shape);
  f->side = side;
}

static bool begin_part(arm_file *f, char *cursor) {
  unsigned link;
  if (f->part_count == ARM_PARTS) {
    return expect(&f->reader, "at most 64 parts", "part");
  }
  if (!read_link_name(f, &cursor, &link) || !case_read_end(&f->reader, cursor)) {
    return false;
  }
  f->parts[f->part_count].link = (uint8_t)link;
  begin_side(f, &f->part_shapes[f->part_count++], 'P');
  return true;
}

static bool begin_obstacle(arm_file *f, char *cursor) {
  if (f->obstacle_count == ARM_OBSTACLES) {
    return expect(&f->reader, "at most 128 obstacles", "obstacle");
  }
  if (!read_name(f, &cursor, "the name of the obstacle", f->obstacle_names[f->obstacle_count]) ||
      !case_read_end(&f->reader, cursor)) {
    return false;
  }
  begin_side(f, &f->obstacle_shapes[f->obstacle_count++], 'O');
  return true;
}

static bool read_never(arm_file *f, char *cursor) {
  unsigned a, b;
  if (!read_link_name(f, &cursor, &a) || !read_link_name(f, &cursor, &b)) {
    return false;
  }
  f->never[a] |= UINT32_C(1) << b;
  return case_read_end(&f->reader, cursor);
}

static bool begin_edge(arm_file *f, char *cursor) {
  memset(&f->edge, 0, sizeof f->edge);
  f->edge.setup.tolerance = GJK_ARM_TOLERANCE_MIN;
  return read_name(f, &cursor, "the edge's ID", f->edge.id) && case_read_end(&f->reader, cursor);
}

static bool read_edge_line(arm_file *f, char *cursor) {
  const char *word = case_next_word(&cursor);
  arm_edge *edge = &f->edge;
  if (word != NULL && strcmp(word, "from") == 0) {
    edge->has_from = true;
    return case_read_numbers(&f->reader, cursor, "a value for each joint that moves, after 'from'", CASE_LENGTH_BITS,
                             count_values(f), edge->from);
  }
  if (word != NULL && strcmp(word, "to") == 0) {
    edge->has_to = true;
    return case_read_numbers(&f->reader, cursor, "a value for each joint that moves, after 'to'", CASE_LENGTH_BITS,
                             count_values(f), edge->to);
  }
  if (word != NULL && (strcmp(word, "margin") == 0 || strcmp(word, "tolerance") == 0)) {
    return case_read_numbers(&f->reader, cursor, "a length", CASE_LENGTH_BITS, 1,
                             word[0] == 'm' ? &edge->setup.margin : &edge->setup.tolerance);
  }
  return expect(&f->reader, "from, to, margin or tolerance after 'E'", word);
}

// Completes the block that ends here. *edge: it was an edge.
static bool finish_block(arm_file *f, bool *edge) {
  const arm_block block = f->block;
  *edge = block == ARM_EDGE;
  f->block = ARM_NOTHING;
  if (block == ARM_PART) {
    return case_finish_side(&f->reader, &f->side, f->link_names[f->parts[f->part_count - 1].link]);
  }
  if (block == ARM_OBSTACLE) {
    return case_finish_side(&f->reader, &f->side, f->obstacle_names[f->obstacle_count - 1]);
  }
  if (block == ARM_EDGE && (!f->edge.has_from || !f->edge.has_to)) {
    return expect(&f->reader, "'E from ...' and 'E to ...'", f->edge.id);
  }
  return true;
}

static bool begin_block(arm_file *f, const char *word, char *cursor) {
  static const struct {
    const char *word;
    arm_block block;
    bool (*begin)(arm_file *f, char *cursor);
  } blocks[] = {{"link", ARM_LINK, begin_link},
                {"part", ARM_PART, begin_part},
                {"never", ARM_NOTHING, read_never},
                {"base", ARM_PLACE, NULL},
                {"obstacle", ARM_OBSTACLE, begin_obstacle},
                {"edge", ARM_EDGE, begin_edge}};
  for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++) {
    if (strcmp(word, blocks[i].word) == 0) {
      f->block = blocks[i].block;
      return blocks[i].begin != NULL ? blocks[i].begin(f, cursor) : case_read_end(&f->reader, cursor);
    }
  }
  return expect(&f->reader, "link, part, never, base, obstacle, edge, or a line of the last of these", word);
}

// Is it a line of the block at hand?
static bool continues(const arm_file *f, const char *word) {
  static const char letters[] = {0, 'L', 'P', 'B', 'O', 'E'};
  return word[0] == letters[f->block] && word[1] == '\0';
}

static bool read_line(arm_file *f, char *cursor) {
  bool done;
  switch (f->block) {
    case ARM_LINK: return read_link_line(f, cursor);
    case ARM_EDGE: return read_edge_line(f, cursor);
    case ARM_PLACE: {
      const char *word = case_next_word(&cursor);
      return word != NULL && read_pose(f, word, cursor, &f->base, &done) && done
                 ? true
                 : f->reader.errors == 0 && expect(&f->reader, "at or turn after 'B'", word);
    }
    default: return case_read_property(&f->reader, cursor, &f->side);
  }
}

// Copies the line's first word, up to the room there is.
static void peek(const arm_file *f, char word[CASE_ID_MAX]) {
  const char *text = f->reader.text + strspn(f->reader.text, " \t\r\v\f");
  const size_t length = strcspn(text, " \t\r\v\f"), kept = length < CASE_ID_MAX - 1 ? length : CASE_ID_MAX - 1;
  memcpy(word, text, kept);
  word[kept] = '\0';
}

bool arm_file_next(arm_file *f) {
  bool edge = false;
  while (f->reader.errors == 0 && case_next_line(&f->reader)) {
    char word[CASE_ID_MAX], *cursor = f->reader.text;
    peek(f, word);
    if (continues(f, word)) {
      (void)case_next_word(&cursor);
      if (!read_line(f, cursor)) {
        return false;
      }
    } else if (!finish_block(f, &edge)) {
      return false;
    } else if (edge) {
      f->reader.pending = true;  // the line is looked at again
      return true;
    } else {
      (void)case_next_word(&cursor);
      if (!begin_block(f, word, cursor)) {
        return false;
      }
    }
  }
  return f->reader.errors == 0 && finish_block(f, &edge) && edge;
}
