// What the readers of text share, and which reader a file gets.
#include "read.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"

char *read_whole(const char *name, size_t *bytes) {
  FILE *f = fopen(name, "rb");
  if (f == NULL) {
    return NULL;
  }
  size_t room = 0;
  char *text = NULL;
  *bytes = 0;
  for (;;) {
    if (*bytes == room) {
      room = room == 0 ? 65536 : 2 * room;
      text = solid_need(realloc(text, room));
    }
    const size_t got = fread(text + *bytes, 1, room - *bytes, f);
    *bytes += got;
    if (got == 0) {
      break;
    }
  }
  if (ferror(f)) {
    free(text);
    text = NULL;
  }
  fclose(f);
  return text;
}

static bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

// Does a line end here? Lines end in a line feed, or in a carriage return alone.
static bool is_end(const mesh_file *f, size_t at) {
  return f->text[at] == '\n' || (f->text[at] == '\r' && (at + 1 == f->bytes || f->text[at + 1] != '\n'));
}

// Is the rest of the line empty? A backslash before its end continues it on the next one. Moves to what comes next.
bool read_line_ends(read_text *text) {
  const mesh_file *f = text->file;
  for (; text->at < f->bytes; text->at++) {
    const char c = f->text[text->at];
    if (c == '\\') {
      size_t next = text->at + 1;
      while (next < f->bytes && is_space(f->text[next]) && !is_end(f, next)) {
        next++;
      }
      if (next < f->bytes && is_end(f, next)) {
        text->file->line++;
        text->at = next;
        continue;
      }
    }
    if (c == '#') {
      while (text->at < f->bytes && !is_end(f, text->at)) {
        text->at++;
      }
    }
    if (text->at == f->bytes || is_end(f, text->at)) {
      return true;
    }
    if (!is_space(c)) {
      return false;
    }
  }
  return true;
}

void read_past_line(read_text *text) {
  const mesh_file *f = text->file;
  while (text->at < f->bytes && !is_end(f, text->at)) {
    text->at++;
  }
  text->at += text->at < f->bytes ? 1 : 0;
}

bool read_next_line(read_text *text) {
  const mesh_file *f = text->file;
  if (text->at > 0 || f->line > 0) {
    read_past_line(text);
  } else if (f->bytes >= 3 && memcmp(f->text, "\xEF\xBB\xBF", 3) == 0) {
    text->at = 3;  // UTF-8's byte order mark
  }
  for (text->file->line++; read_line_ends(text); text->file->line++) {
    if (text->at >= f->bytes) {
      return false;
    }
    text->at++;
  }
  return true;
}

static size_t word_length(const read_text *text) {
  const mesh_file *f = text->file;
  size_t end = text->at;
  while (end < f->bytes && !is_space(f->text[end]) && !is_end(f, end)) {
    end++;
  }
  return end - text->at;
}

static char lower(char c) {
  return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

bool read_word(read_text *text, const char *word) {
  if (read_line_ends(text)) {
    return false;
  }
  const size_t length = word_length(text);
  bool same = length == strlen(word);
  for (size_t i = 0; i < length && same; i++) {
    same = lower(text->file->text[text->at + i]) == lower(word[i]);
  }
  if (!same) {
    return false;
  }
  text->at += length;
  return true;
}

bool read_any_word(read_text *text, char *out, size_t room) {
  if (read_line_ends(text)) {
    return false;
  }
  const size_t length = word_length(text), kept = length < room ? length : room - 1;
  for (size_t i = 0; i < kept; i++) {  // a byte of 0 would end the word early, and hide what follows
    const char c = text->file->text[text->at + i];
    out[i] = c == '\0' ? '?' : c;
  }
  out[kept] = '\0';
  text->at += length;
  return true;
}

bool read_double(read_text *text, double *out) {
  char word[80], *end;
  if (!read_any_word(text, word, sizeof word)) {
    return false;
  }
  *out = strtod(word, &end);
  return (*end == '\0' && isfinite(*out)) || mesh_fail(text->file, "'%s' is not a number", word);
}

bool read_integer(read_text *text, int64_t *out) {
  char word[80], *end;
  if (!read_any_word(text, word, sizeof word)) {
    return false;
  }
  errno = 0;
  *out = strtoll(word, &end, 10);
  return (*end == '\0' && errno == 0) || mesh_fail(text->file, "'%s' is not an integer", word);
}

// Points: three integers a line, raw LSB. A line of a word and a number may head them, for example "hull 8".
bool read_points(mesh *m, mesh_file *file) {
  read_text text = {file, 0};
  file->scale = 1;
  while (read_next_line(&text)) {
    char head[16];
    const char c = file->text[text.at];
    if (m->points == 0 && c >= 'a' && c <= 'z') {
      int64_t count;
      if (!read_any_word(&text, head, sizeof head) || !read_integer(&text, &count)) {
        return mesh_fail(file, "a line of points has three integers");
      }
      continue;
    }
    int64_t lsb[3];
    for (int i = 0; i < 3; i++) {
      if (!read_integer(&text, &lsb[i])) {
        return mesh_fail(file, "a line of points has three integers");
      }
    }
    if (!read_line_ends(&text)) {
      return mesh_fail(file, "a line of points has three integers");
    }
    const double xyz[3] = {(double)lsb[0], (double)lsb[1], (double)lsb[2]};
    if (!mesh_add_point(m, file, xyz)) {
      return false;
    }
  }
  return true;
}

bool mesh_read(mesh *m, mesh_file *file) {
  static const struct {
    const char *end;
    bool (*read)(mesh *m, mesh_file *file);
  } formats[] = {{".obj", read_obj}, {".stl", read_stl}, {".ply", read_ply}, {".off", read_off}, {".txt", read_points}};
  const size_t length = strlen(file->name);
  file->line = 0;
  for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++) {
    bool same = length >= 4;
    for (size_t j = 0; same && j < 4; j++) {
      same = lower(file->name[length - 4 + j]) == formats[i].end[j];
    }
    if (same) {
      return formats[i].read(m, file) && (m->points > 0 || mesh_fail(file, "no points"));
    }
  }
  return mesh_fail(file, "unknown kind of file: .obj, .stl, .ply, .off and .txt are known");
}
