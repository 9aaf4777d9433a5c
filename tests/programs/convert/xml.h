// A strict reader of XML, element by element, for descriptions of robots.
//
// Comments, processing instructions, CDATA and text are skipped. References in values are the five named ones and
// numbers.
// Refused, with the line: what is not well-formed, DOCTYPE, elements in each other deeper than XML_DEPTH_MAX.
#ifndef XML_H
#define XML_H

#include <stdbool.h>
#include <stddef.h>

enum { XML_DEPTH_MAX = 64, XML_ATTRIBUTES_MAX = 32, XML_PROBLEM = 400 };

// A piece of the text.
typedef struct xml_piece {
  const char *text;
  size_t length;
} xml_piece;

typedef struct xml_attribute {
  xml_piece name, value;  // the value as it stands in the file
} xml_attribute;

typedef struct xml_reader {
  const char *name, *text;  // of the file
  size_t bytes, at;
  unsigned long line;
  xml_piece open[XML_DEPTH_MAX];  // elements that are open, and where they began
  unsigned long began[XML_DEPTH_MAX];
  unsigned depth;
  xml_attribute attribute[XML_ATTRIBUTES_MAX];  // of the element that began last
  unsigned attributes;
  bool empty;                 // it ends where it begins
  bool root;                  // one has begun
  char problem[XML_PROBLEM];  // the message, with file and line; empty: none
} xml_reader;

// text: bytes of it, which stay the caller's.
void xml_open(xml_reader *r, const char *name, const char *text, size_t bytes);

// Moves to the next element within the one at this depth: those deeper are passed over. False: that element ends, or
// there is a problem. So the document's element is the child at depth 0.
bool xml_next_child(xml_reader *r, unsigned depth);

// Is the element that began last called so?
bool xml_is(const xml_reader *r, const char *name);

// The line where it began.
unsigned long xml_line(const xml_reader *r);

// Copies the value of an attribute of the element that began last, references replaced. False: it has none, or there
// is a problem: longer than room - 1.
bool xml_value(xml_reader *r, const char *name, char *out, size_t room);

// Notes the first problem, as printf does, behind the file's name and a line. Returns false.
bool xml_fail(xml_reader *r, unsigned long line, const char *format, ...);

#endif
