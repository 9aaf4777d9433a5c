// Reads lines and words of cases.
#include "lines.h"

#include <errno.h>
#include <stdarg.h>
#include <string.h>

#include "number.h"

void case_complain(case_reader *reader, const char *format, ...) {
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

char *case_next_word(char **cursor) {
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

bool case_next_line(case_reader *reader) {
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

// Is the first word of the line this one?
static bool begins_with(const case_reader *reader, const char *word) {
  const char *found = skip_blanks(reader->text);
  const size_t length = strlen(word);
  return strncmp(found, word, length) == 0 && (found[length] == '\0' || is_blank(found[length]));
}

bool case_begins_plane(const case_reader *reader) {
  return begins_with(reader, "case2");
}

bool case_begins(const case_reader *reader) {
  return begins_with(reader, "case") || case_begins_plane(reader);
}

bool case_read_end(case_reader *reader, char *cursor) {
  const char *word = case_next_word(&cursor);
  if (word != NULL) {
    case_complain(reader, "expected the end of the line, found '%s'", word);
    return false;
  }
  if (reader->overlong) {
    case_complain(reader, "expected a line of at most %d characters", CASE_LINE_MAX - 1);
    return false;
  }
  return true;
}

bool case_read_numbers(case_reader *reader, char *cursor, const char *names, int bits, size_t count, int32_t *out) {
  for (size_t i = 0; i < count; i++) {
    const char *word = case_next_word(&cursor);
    if (word == NULL) {
      case_complain(reader, "expected %s: %lu of %lu numbers found", names, (unsigned long)i, (unsigned long)count);
      return false;
    }
    if (!case_number_parse(word, bits, &out[i])) {
      case_complain(reader, "expected %s: a raw 32-bit integer, or with a decimal point a value from %s, found '%s'",
                    names, bits == CASE_ROTATION_BITS ? "-2.0 to below 2.0" : "-32768.0 to below 32768.0", word);
      return false;
    }
  }
  return case_read_end(reader, cursor);
}

bool case_next_item(case_reader *reader, const char *names) {
  if (!case_next_line(reader)) {
    case_complain(reader, "expected %s, found the end of the file", names);
    return false;
  }
  if (case_begins(reader)) {
    case_complain(reader, "expected %s, found '%s'", names, case_begins_plane(reader) ? "case2" : "case");
    reader->pending = true;
    return false;
  }
  return true;
}

bool case_read_count(case_reader *reader, char *cursor, const char *listed, const char *after, int32_t most,
                     int32_t *count) {
  char *word = case_next_word(&cursor);
  if (word == NULL || strchr(word, '.') != NULL || !case_number_parse(word, 0, count) || *count < 1 || *count > most) {
    case_complain(reader, "expected a number of %s from 1 to %ld, found '%s'", listed, (long)most, after,
                  word == NULL ? "" : word);
    return false;
  }
  return case_read_end(reader, cursor);
}

bool case_read_points(case_reader *reader, const char *names, size_t count, size_t n,
                      void (*set)(void *shape, size_t i, const int32_t *number), void *shape) {
  for (size_t i = 0; i < count; i++) {
    char what[64];
    int32_t number[3];
    snprintf(what, sizeof what, "vertex %lu of %lu, %s", (unsigned long)(i + 1), (unsigned long)count, names);
    if (!case_next_item(reader, what) || !case_read_numbers(reader, reader->text, what, CASE_LENGTH_BITS, n, number)) {
      return false;
    }
    set(shape, i, number);
  }
  return true;
}

bool case_once(case_reader *reader, bool *seen, char letter, const char *word) {
  if (*seen) {
    case_complain(reader, "expected '%c %s' only once", letter, word);
    return false;
  }
  *seen = true;
  return true;
}

bool case_add_radii(case_reader *reader, bool kind, char letter, const char *id, int32_t own, int32_t round,
                    int32_t *sum) {
  const int64_t both = (int64_t)own + round;
  if (!kind) {
    case_complain(reader, "expected '%c KIND ...' before the end of case %s", letter, id);
    return false;
  }
  *sum = own < round ? own : round;
  if (*sum >= 0 && both > INT32_MAX) {
    case_complain(reader, "expected a radius and 'round' of %c that add up to less than 32768.0", letter);
    return false;
  }
  *sum = *sum < 0 ? *sum : (int32_t)both;
  return true;
}

bool case_read_id(case_reader *reader, char id[CASE_ID_MAX]) {
  char *cursor = reader->text;
  const char *keyword = case_next_word(&cursor), *word = skip_blanks(cursor);
  size_t length = 0;
  while (word[length] != '\0' && !is_blank(word[length])) {
    length++;
  }
  if (length == 0 || length >= CASE_ID_MAX) {
    case_complain(reader, "expected '%s ID' with an ID of 1 to %d characters", keyword, CASE_ID_MAX - 1);
    return false;
  }
  memcpy(id, word, length);
  id[length] = '\0';
  return true;
}

bool case_read_sides(case_reader *reader, bool (*property)(case_reader *reader, char *cursor, void *side), void *a,
                     void *b) {
  while (case_next_line(reader)) {
    if (case_begins(reader)) {
      reader->pending = true;
      break;
    }
    char *cursor = reader->text;
    const char *word = case_next_word(&cursor);
    const bool is_a = word != NULL && strcmp(word, "A") == 0;
    const bool is_b = word != NULL && strcmp(word, "B") == 0;
    if (!is_a && !is_b) {
      case_complain(reader, "expected 'A ...', 'B ...' or 'case ID', found '%s'", word);
      return false;
    }
    if (!property(reader, cursor, is_a ? a : b)) {
      return false;
    }
  }
  return !reader->failed;
}
