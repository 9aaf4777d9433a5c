// The readers of each format, and what they share: a text, line by line, word by word.
#ifndef READ_H
#define READ_H

#include "mesh.h"

// Most corners of one face in a file.
#define READ_CORNERS_MAX 4096

// The whole file, for free; NULL: it cannot be read.
char *read_whole(const char *name, size_t *bytes);

// A place in a text.
typedef struct read_text {
  mesh_file *file;
  size_t at;
} read_text;

// Moves behind the end of the line: a line feed, or a carriage return alone.
void read_past_line(read_text *text);

// Moves on to the next line that is not empty after comments ('#' to its end) are left out, and counts lines. False: the
// text ends. The line's words are then read by the functions below.
bool read_next_line(read_text *text);

// Is nothing left in the line?
bool read_line_ends(read_text *text);

// Takes a word if it comes next in the line, in lower case or upper case.
bool read_word(read_text *text, const char *word);

// The rest of a word before whitespace, for messages and keywords, bytes of 0 as '?'; false: the line ends.
bool read_any_word(read_text *text, char *out, size_t room);

// Numbers. False: the line ends; with a problem noted: something else comes next.
bool read_double(read_text *text, double *out);
bool read_integer(read_text *text, int64_t *out);

bool read_points(mesh *m, mesh_file *file);
bool read_obj(mesh *m, mesh_file *file);
bool read_off(mesh *m, mesh_file *file);
bool read_stl(mesh *m, mesh_file *file);
bool read_ply(mesh *m, mesh_file *file);

#endif
