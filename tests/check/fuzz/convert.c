// The readers of gjk-convert on any bytes; small solids that come out are decomposed.
#include <stdlib.h>
#include <string.h>

#include "bytes.h"
#include "tests/programs/convert/decompose.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

// The first byte picks the format.
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static const char *const names[] = {"f.obj", "f.stl", "f.ply", "f.off", "f.txt"};
  static const decompose_options usual = {-1, 0};
  if (size == 0) {
    return 0;
  }
  char problem[200];
  char *text = malloc(size);  // of just that size, so that a look beyond it is seen
  memcpy(text, data + 1, size - 1);
  mesh m = {NULL, NULL, NULL, 0, 0, 0, 0, 0, 0};
  mesh_file file = {names[data[0] % 5], text, size - 1, 65536, 0, "", NULL};
  const bool read = mesh_read(&m, &file);
  if (read == (file.problem[0] != '\0')) {
    fuzz_fail("a file that is refused without a message, or read with one");
  }
  if (read) {
    solid s;
    mesh_weld(&m);
    if (m.triangles <= 8 && solid_from_mesh(&s, &m, problem, sizeof problem)) {
      decomposition d;
      decompose(&s, &usual, &d);
      if (d.parts == 0 || !(d.excess.at_least <= d.excess.at_most)) {
        fuzz_fail("a solid without parts, or bounds that cross");
      }
      decompose_free(&d);
    }
    if (m.triangles <= 8) {
      solid_free(&s);
    }
  }
  mesh_free(&m);
  free(text);
  return 0;
}
