// A strict reader of XML.
#include "xml.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void xml_open(xml_reader *r, const char *name, const char *text, size_t bytes) {
  memset(r, 0, sizeof *r);
  r->name = name;
  r->text = text;
  r->bytes = bytes;
  r->at = bytes >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;  // UTF-8's byte order mark
  r->line = 1;
}

bool xml_fail(xml_reader *r, unsigned long line, const char *format, ...) {
  if (r->problem[0] == '\0') {
    const int length = snprintf(r->problem, sizeof r->problem, "%.200s:%lu: ", r->name, line);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(r->problem + length, sizeof r->problem - (size_t)length, format, arguments);
    va_end(arguments);
    for (char *c = r->problem; *c != '\0'; c++) {  // names of a file may have any bytes; a message is one line
      *c = (unsigned char)*c < ' ' || *c == 127 ? '?' : *c;
    }
  }
  return false;
}

static bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

static bool is_name(char c, bool first) {
  const bool letter =
      (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == ':' || (unsigned char)c >= 128;
  return letter || (!first && ((c >= '0' && c <= '9') || c == '-' || c == '.'));
}

// What comes next; a byte of 0 at the end.
static char look(const xml_reader *r) {
  return r->at < r->bytes ? r->text[r->at] : '\0';
}

static void advance(xml_reader *r, size_t bytes) {
  for (; bytes > 0 && r->at < r->bytes; bytes--) {
    r->line += r->text[r->at++] == '\n' ? 1u : 0u;
  }
}

static void skip_space(xml_reader *r) {
  while (r->at < r->bytes && is_space(r->text[r->at])) {
    advance(r, 1);
  }
}

static bool comes(const xml_reader *r, const char *word) {
  const size_t length = strlen(word);
  return r->bytes - r->at >= length && memcmp(r->text + r->at, word, length) == 0;
}

// Passes over all up to and with a word. False: it does not come.
static bool skip_past(xml_reader *r, const char *word, const char *what) {
  const unsigned long line = r->line;
  while (r->at < r->bytes && !comes(r, word)) {
    advance(r, 1);
  }
  if (r->at == r->bytes) {
    return xml_fail(r, line, "%s does not end", what);
  }
  advance(r, strlen(word));
  return true;
}

static bool same(xml_piece a, xml_piece b) {
  return a.length == b.length && memcmp(a.text, b.text, a.length) == 0;
}

// At most 60 bytes of a piece, for "%.*s".
static int shown(xml_piece piece) {
  return (int)(piece.length < 60 ? piece.length : 60);
}

static bool read_name(xml_reader *r, xml_piece *name, const char *what) {
  const xml_piece piece = {r->text + r->at, 0};
  *name = piece;
  while (r->at < r->bytes && is_name(look(r), name->length == 0)) {
    name->length++;
    r->at++;
  }
  return name->length > 0 || xml_fail(r, r->line, "expected the name of %s", what);
}

static bool read_attribute(xml_reader *r) {
  xml_attribute attribute;
  if (r->attributes == XML_ATTRIBUTES_MAX) {
    return xml_fail(r, r->line, "an element has more than %d attributes", XML_ATTRIBUTES_MAX);
  }
  if (!read_name(r, &attribute.name, "an attribute")) {
    return false;
  }
  skip_space(r);
  if (look(r) != '=') {
    return xml_fail(r, r->line, "expected '=' after attribute '%.*s'", shown(attribute.name), attribute.name.text);
  }
  advance(r, 1);
  skip_space(r);
  const char quote = look(r);
  if (quote != '"' && quote != '\'') {
    return xml_fail(r, r->line, "the value of '%.*s' is not quoted", shown(attribute.name), attribute.name.text);
  }
  const unsigned long line = r->line;
  advance(r, 1);
  attribute.value.text = r->text + r->at;
  while (r->at < r->bytes && look(r) != quote && look(r) != '<') {
    advance(r, 1);
  }
  if (look(r) != quote || r->at == r->bytes) {
    return xml_fail(r, line, "the value of '%.*s' does not end", shown(attribute.name), attribute.name.text);
  }
  attribute.value.length = (size_t)(r->text + r->at - attribute.value.text);
  advance(r, 1);
  for (unsigned i = 0; i < r->attributes; i++) {
    if (same(r->attribute[i].name, attribute.name)) {
      return xml_fail(r, line, "attribute '%.*s' is there twice", shown(attribute.name), attribute.name.text);
    }
  }
  r->attribute[r->attributes++] = attribute;
  return true;
}

// After '<'.
static bool read_begin(xml_reader *r) {
  xml_piece name;
  if (!read_name(r, &name, "an element")) {
    return false;
  }
  if (r->depth == XML_DEPTH_MAX) {
    return xml_fail(r, r->line, "elements in each other deeper than %d", XML_DEPTH_MAX);
  }
  if (r->depth == 0 && r->root) {
    return xml_fail(r, r->line, "a second element beside the document's");
  }
  r->root = true;
  r->began[r->depth] = r->line;
  r->open[r->depth++] = name;
  r->attributes = 0;
  for (;;) {
    const bool space = is_space(look(r));
    skip_space(r);
    if (comes(r, "/>") || comes(r, ">")) {
      r->empty = look(r) == '/';
      advance(r, r->empty ? 2 : 1);
      return true;
    }
    if (!space || r->at == r->bytes) {
      return xml_fail(r, r->began[r->depth - 1], "the tag of '%.*s' does not end", shown(name), name.text);
    }
    if (!read_attribute(r)) {
      return false;
    }
  }
}

// After '</'.
static bool read_end(xml_reader *r) {
  const unsigned long line = r->line;
  xml_piece name;
  if (!read_name(r, &name, "an element that ends")) {
    return false;
  }
  if (r->depth == 0) {
    return xml_fail(r, line, "'%.*s' ends, and was not begun", shown(name), name.text);
  }
  const xml_piece begun = r->open[r->depth - 1];
  if (!same(name, begun)) {
    return xml_fail(r, line, "'%.*s' ends where '%.*s' of line %lu is open", shown(name), name.text, shown(begun),
                    begun.text, r->began[r->depth - 1]);
  }
  skip_space(r);
  if (look(r) != '>') {
    return xml_fail(r, line, "the end of '%.*s' does not end", shown(name), name.text);
  }
  advance(r, 1);
  r->depth--;
  return true;
}

typedef enum xml_event { XML_BEGIN, XML_END, XML_OVER } xml_event;

// Passes over text up to the next '<'. Outside of the document's element there is none.
static bool skip_text(xml_reader *r) {
  while (r->at < r->bytes && look(r) != '<') {
    if (r->depth == 0 && !is_space(look(r))) {
      return xml_fail(r, r->line, "text outside of the document's element");
    }
    advance(r, 1);
  }
  return true;
}

// The next begin or end of an element. OVER: the document ends, or there is a problem.
static xml_event next_event(xml_reader *r) {
  if (r->empty) {
    r->empty = false;
    r->depth--;
    return XML_END;
  }
  bool fine = skip_text(r);
  while (fine && r->at < r->bytes) {
    if (comes(r, "<!--")) {
      advance(r, 4);
      fine = skip_past(r, "-->", "a comment");
    } else if (comes(r, "<?")) {
      fine = skip_past(r, "?>", "a declaration");
    } else if (comes(r, "<![CDATA[") && r->depth > 0) {
      fine = skip_past(r, "]]>", "CDATA");
    } else if (comes(r, "<!")) {
      fine = xml_fail(r, r->line, "a declaration that is not understood");
    } else if (comes(r, "</")) {
      advance(r, 2);
      return read_end(r) ? XML_END : XML_OVER;
    } else {
      advance(r, 1);
      return read_begin(r) ? XML_BEGIN : XML_OVER;
    }
    fine = fine && skip_text(r);
  }
  if (fine && r->depth > 0) {
    const xml_piece open = r->open[r->depth - 1];
    xml_fail(r, r->began[r->depth - 1], "'%.*s' does not end", shown(open), open.text);
  } else if (fine && !r->root) {
    xml_fail(r, r->line, "no element");
  }
  return XML_OVER;
}

bool xml_next_child(xml_reader *r, unsigned depth) {
  while (r->problem[0] == '\0') {
    const xml_event event = next_event(r);
    if (event == XML_OVER || (event == XML_END && r->depth < depth)) {
      return false;
    }
    if (event == XML_BEGIN && r->depth == depth + 1) {
      return true;
    }
  }
  return false;
}

bool xml_is(const xml_reader *r, const char *name) {
  const xml_piece wanted = {name, strlen(name)};
  return same(r->open[r->depth - 1], wanted);
}

unsigned long xml_line(const xml_reader *r) {
  return r->began[r->depth - 1];
}

// A code point in UTF-8. Returns how many bytes.
static size_t encode(unsigned long code, char out[4]) {
  if (code < 0x80) {
    out[0] = (char)code;
    return 1;
  }
  const size_t more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  for (size_t i = more; i > 0; i--) {
    out[i] = (char)(0x80 | (code & 0x3F));
    code >>= 6;
  }
  out[0] = (char)((more == 1 ? 0xC0 : more == 2 ? 0xE0 : 0xF0) | code);
  return more + 1;
}

// The digits of a number in some base. False: others, none, or beyond Unicode.
static bool read_code(xml_piece digits, unsigned base, unsigned long *code) {
  *code = 0;
  for (size_t i = 0; i < digits.length; i++) {
    const char c = digits.text[i];
    const unsigned digit = c >= '0' && c <= '9'   ? (unsigned)(c - '0')
                           : c >= 'a' && c <= 'f' ? (unsigned)(c - 'a') + 10
                           : c >= 'A' && c <= 'F' ? (unsigned)(c - 'A') + 10
                                                  : base;
    *code = *code * base + digit;  // below 2^21 times 16
    if (digit >= base || *code > 0x10FFFF) {
      return false;
    }
  }
  return digits.length > 0 && *code > 0;
}

// What a reference, the piece between '&' and ';', stands for. Returns how many bytes; 0: it is not known.
static size_t resolve(xml_piece reference, char out[4]) {
  static const struct {
    const char *name;
    char c;
  } known[] = {{"lt", '<'}, {"gt", '>'}, {"amp", '&'}, {"quot", '"'}, {"apos", '\''}};
  for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
    const xml_piece name = {known[i].name, strlen(known[i].name)};
    if (same(reference, name)) {
      out[0] = known[i].c;
      return 1;
    }
  }
  if (reference.length < 2 || reference.text[0] != '#') {
    return 0;
  }
  const bool hex = reference.text[1] == 'x';
  const xml_piece digits = {reference.text + (hex ? 2 : 1), reference.length - (hex ? 2 : 1)};
  unsigned long code;
  return read_code(digits, hex ? 16 : 10, &code) ? encode(code, out) : 0;
}

bool xml_value(xml_reader *r, const char *name, char *out, size_t room) {
  const xml_piece wanted = {name, strlen(name)};
  const xml_attribute *found = NULL;
  for (unsigned i = 0; i < r->attributes; i++) {
    found = same(r->attribute[i].name, wanted) ? &r->attribute[i] : found;
  }
  size_t length = 0;
  for (size_t i = 0; found != NULL && i < found->value.length;) {
    const char *at = found->value.text + i;
    char bytes[4] = {is_space(*at) ? ' ' : *at, 0, 0, 0};
    size_t count = *at != '\0';
    const char *end = *at == '&' ? memchr(at, ';', found->value.length - i) : at;
    if (*at == '&') {
      const xml_piece reference = {at + 1, end != NULL ? (size_t)(end - at) - 1 : 0};
      count = end != NULL ? resolve(reference, bytes) : 0;
    }
    if (count == 0) {
      return xml_fail(r, xml_line(r), "a reference or byte in '%s' that is not understood", name);
    }
    if (length + count >= room) {
      return xml_fail(r, xml_line(r), "'%s' is longer than %zu bytes", name, room - 1);
    }
    memcpy(out + length, bytes, count);
    length += count;
    i += (size_t)(end - at) + 1;
  }
  out[length] = '\0';
  return found != NULL;
}
