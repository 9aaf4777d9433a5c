// Lines and words of cases, as both grammars need them: parse.c of pairs in space, parse2.c of pairs in the plane.
//
// A function that expects something writes one message and returns false where it finds something else.
#ifndef CASE_LINES_H
#define CASE_LINES_H

#include "parse.h"

#define CASE_LENGTH_BITS 16
#define CASE_ROTATION_BITS 30
#define CASE_ID_MAX 64

// Writes 'FILE:LINE: ' and the message; the rest of the case is skipped.
void case_complain(case_reader *reader, const char *format, ...);

// Splits off the next word. NULL: the line ends, or a comment begins.
char *case_next_word(char **cursor);

// Reads the next line that has a word. False: the file ends.
bool case_next_line(case_reader *reader);

// Does the line begin a case, in space or in the plane?
bool case_begins(const case_reader *reader);

// Does the line begin a case of the plane?
bool case_begins_plane(const case_reader *reader);

// Expects the end of the line.
bool case_read_end(case_reader *reader, char *cursor);

// Expects count numbers, which messages call names, and the end of the line.
bool case_read_numbers(case_reader *reader, char *cursor, const char *names, int bits, size_t count, int32_t *out);

// Reads the next line of a list. False: the file or the case ends.
bool case_next_item(case_reader *reader, const char *names);

// Expects a count from 1 to most after a word, and the end of the line.
bool case_read_count(case_reader *reader, char *cursor, const char *listed, const char *after, int32_t most,
                     int32_t *count);

// Expects count lines of n numbers, and calls set for each. names: of the numbers.
bool case_read_points(case_reader *reader, const char *names, size_t count, size_t n,
                      void (*set)(void *shape, size_t i, const int32_t *number), void *shape);

// Marks a property of A or B as seen; a second one is an error.
bool case_once(case_reader *reader, bool *seen, char letter, const char *word);

// Expects a shape to have been read, and adds its own radius and that of 'round'. A negative one stays, so that the
// library refuses it.
bool case_add_radii(case_reader *reader, bool kind, char letter, const char *id, int32_t own, int32_t round,
                    int32_t *sum);

// Reads the line of 'case ID' or 'case2 ID', which is in text already.
bool case_read_id(case_reader *reader, char id[CASE_ID_MAX]);

// Reads the lines 'A ...' and 'B ...' up to the next case.
bool case_read_sides(case_reader *reader, bool (*property)(case_reader *reader, char *cursor, void *side), void *a,
                     void *b);

// What was read of one shape in space.
typedef struct case_side {
  case_shape *shape;                                             // reset by case_shape_reset
  char letter;                                                   // that its lines begin with
  bool kind, faces, convex_radius, at, turn, to, turn_to, spin;  // seen
  gjk_q16 own_radius, round_radius;                              // of a sphere or capsule; of 'round'
} case_side;

// Reads a line of a shape after its letter; side is a case_side. Then, after the last line, completes the shape. id: what
// the shape belongs to.
bool case_read_property(case_reader *reader, char *cursor, void *side);
bool case_finish_side(case_reader *reader, const case_side *side, const char *id);

#endif
