// Reads cases from a stream, one at a time, in constant memory. The format:
//
//     # comment
//     case ID [free text]
//     A KIND ...               point | segment h | triangle (3 lines of x y z) | box hx hy hz
//                              | hull n (n lines of x y z) | sphere r | capsule r h
//                              | cylinder r h | cone r h | ellipsoid rx ry rz
//     A round r                optional, adds to the radius of a sphere or capsule
//     A faces m                optional, of a hull: m lines of vertex numbers from 0, up to GJK_FACE_CORNERS_MAX
//     A at x y z               optional, default 0 0 0
//     A turn x y z w           optional quaternion, default 0.0 0.0 0.0 1.0
//     B KIND ...               and so on
//
// Numbers as in number.h: lengths Q16.16, quaternions Q2.30. Blank lines, tabs and CRLF are fine, and so is a
// comment after the words of a line, except on the line of 'case'.
#ifndef CASE_PARSE_H
#define CASE_PARSE_H

#include "case.h"

#define CASE_LINE_MAX 1024

typedef struct case_reader {
  FILE *file;
  const char *name;      // of the file, for messages
  unsigned long line;    // number of the line in text
  unsigned long errors;  // messages written
  bool pending;          // text holds a line that is still to be read
  bool overlong;         // text is the beginning of a longer line
  bool failed;           // the rest of the present case is skipped
  char text[CASE_LINE_MAX];
} case_reader;

// The file stays the caller's; name must outlive the reader.
void case_reader_open(case_reader *reader, FILE *file, const char *name);

// The next well-formed case, in pair, whose storage is reused; zeroed at first. A malformed one is skipped up
// to the next line that begins with 'case', after one message 'FILE:LINE: expected ...' on standard error.
// False at the end of the file.
bool case_reader_next(case_reader *reader, case_pair *pair);

#endif
