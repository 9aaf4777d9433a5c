// gjk-bench-report: prints the figures of a run as tables and writes them as a page.
#include <errno.h>
#include <string.h>

#include "page.h"
#include "text.h"

static int write_page(const table *t, const scene_table *scenes, const char *name) {
  FILE *file = fopen(name, "w");
  if (file == NULL) {
    fprintf(stderr, "%s: %s\n", name, strerror(errno));
    return 2;
  }
  page_write(file, t, scenes);
  const bool failed = ferror(file) != 0;
  if (fclose(file) != 0 || failed) {
    fprintf(stderr, "%s: cannot write the page\n", name);
    return 2;
  }
  return 0;
}

static FILE *open_table(const char *name) {
  FILE *file = fopen(name, "r");
  if (file == NULL) {
    fprintf(stderr, "%s: %s\n", name, strerror(errno));
  }
  return file;
}

static bool read_scenes(scene_table *out, const char *name) {
  FILE *file = open_table(name);
  if (file == NULL) {
    return false;
  }
  const bool good = scene_read(out, file, name);
  fclose(file);
  return good;
}

int main(int argc, char **argv) {
  static table t;
  static scene_table scenes;
  if (argc != 3 && argc != 4) {
    fprintf(stderr, "usage: gjk-bench-report RUN.csv PAGE.html [SCENES.csv]\n");
    return 2;
  }
  FILE *file = open_table(argv[1]);
  if (file == NULL) {
    return 2;
  }
  const bool good = table_read(&t, file, argv[1]) && (argc < 4 || read_scenes(&scenes, argv[3]));
  fclose(file);
  int result = 2;
  if (good) {
    text_write(stdout, &t);
    result = write_page(&t, argc > 3 ? &scenes : NULL, argv[2]);
  }
  table_free(&t);
  return result;
}
