// Reads cases from a stream, one at a time, in constant memory. The format:
//
//     # comment
//     case ID [free text]
//     A KIND ...               point | segment h | triangle (3 lines of x y z) | box hx hy hz
//                              | hull n (n lines of x y z) | sphere r | capsule r h
//                              | cylinder r h | cone r h | ellipsoid rx ry rz
//     A round r                optional convex radius, adds to that of a sphere or capsule
//     A faces m                optional, of a hull: m lines of vertex numbers from 0, up to GJK_FACE_CORNERS_MAX
//     A at x y z               optional, default 0 0 0
//     A turn x y z w           optional quaternion, default 0.0 0.0 0.0 1.0
//     A to x y z               optional, of casts and impacts: where it moves to, default where it is
//     A turn-to x y z w        optional, of impacts: how it is turned there, default as before
//     A spin x y z             optional, of impacts: angle times axis over the whole way, Q16.16 radians
//     B KIND ...               and so on
//
// and of a pair in the plane:
//
//     case2 ID [free text]
//     A KIND ...               point | segment h | triangle (3 lines of x y) | box hx hy
//                              | polygon n (n lines of x y) | circle r | capsule r h | ellipse rx ry; the axis of a segment or capsule is local x
//     A round r                optional convex radius, adds to that of a circle or capsule
//     A at x y                 optional, default 0 0
//     A turn c s               optional cosine and sine, default 1.0 0.0
//     A to x y                 optional, of casts and impacts: where it moves to, default where it is
//     A turn-to c s            optional, of impacts: how it is turned there, default as before
//     A spin angle             optional, of impacts: over the whole way, Q16.16 radians
//     B KIND ...               and so on
//
// Numbers are written as number.h says: lengths in Q16.16, quaternions, cosines and sines in Q2.30. Blank lines, tabs and CRLF are
// allowed. So is a comment at the end of any line but that of 'case'.
#ifndef CASE_PARSE_H
#define CASE_PARSE_H

#include "case.h"
#include "case2.h"

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

// Starts to read file, which stays the caller's. name is printed in messages and must outlive the reader.
void case_reader_open(case_reader *reader, FILE *file, const char *name);

// Reads the next well-formed case into pair and returns true; false at the end of the file. pair is zeroed before the
// first call; later calls use its memory again. A malformed case gets one message 'FILE:LINE: expected ...' on standard
// error and is skipped, up to the next line that begins a case.
bool case_reader_next(case_reader *reader, case_pair *pair);

// The same for a reader of both: plane gets the pairs of the plane, and what was found is returned.
typedef enum case_found { CASE_FOUND_NONE, CASE_FOUND_SPACE, CASE_FOUND_PLANE } case_found;
case_found case_reader_next_any(case_reader *reader, case_pair *pair, case2_pair *plane);

#endif
