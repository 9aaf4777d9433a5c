// The reader of robots on any bytes: URDF, then SRDF after a line of '%'. Robots without meshes become machines.
#include <stdlib.h>
#include <string.h>

#include "bytes.h"
#include "tests/programs/convert/machine.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static bool has_mesh(const robot *b) {
  bool found = false;
  for (unsigned i = 0; i < b->shapes; i++) {
    found = found || b->shape[i].geometry == ROBOT_MESH;
  }
  return found;
}

// A message is one line that begins with the file and a line of it.
static void check_problem(const xml_reader *r, bool fine, const char *name, const char *text, size_t size) {
  const size_t length = strlen(name);
  unsigned long lines = 1;
  char *end;
  if (fine == (r->problem[0] != '\0') || strchr(r->problem, '\n') != NULL) {
    fuzz_fail("what is refused has no message of one line, or what is taken has one");
  }
  for (size_t i = 0; i < size; i++) {
    lines += text[i] == '\n';
  }
  if (!fine && (strncmp(r->problem, name, length) != 0 || r->problem[length] != ':' ||
                strtoul(r->problem + length + 1, &end, 10) - 1 >= lines || strncmp(end, ": ", 2) != 0)) {
    fuzz_fail("a message does not name a line of the file");
  }
}

static void make(machine *m, robot *b, bool pairs, xml_reader *r, const char *text, size_t size) {
  static const machine_options how = {65536, -1, false, {-1, 0}};
  const bool made = machine_make(m, b, pairs, &how, r);
  check_problem(r, made, "f.urdf", text, size);
  if (made && (m->links == 0 || m->links > GJK_ARM_LINKS_MAX || m->parts != b->shapes)) {
    fuzz_fail("a machine without links, or without some of its parts");
  }
  machine_free(m);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static robot b;
  static machine m;
  char *text = malloc(size + 1);  // of just that size, so that a look beyond it is seen
  memcpy(text, data, size);
  size_t first = 0;
  while (first < size && !(text[first] == '%' && (first + 1 == size || text[first + 1] == '\n'))) {
    first++;
  }
  const size_t second = first + 2 < size ? first + 2 : size;
  char *urdf = malloc(first + (first == 0)), *srdf = malloc(size - second + (size == second));
  memcpy(urdf, text, first);
  memcpy(srdf, text + second, size - second);
  free(text);
  xml_reader r, pairs;
  xml_open(&r, "f.urdf", urdf, first);
  const bool read = robot_read(&b, &r);
  check_problem(&r, read, "f.urdf", urdf, first);
  if (read) {
    xml_open(&pairs, "f.srdf", srdf, size - second);
    const bool known = robot_read_pairs(&b, &pairs);
    check_problem(&pairs, known, "f.srdf", srdf, size - second);
    if (!has_mesh(&b) && b.links <= 12 && b.shapes <= 12) {
      make(&m, &b, known, &r, urdf, first);
    }
  }
  free(urdf);
  free(srdf);
  return 0;
}
