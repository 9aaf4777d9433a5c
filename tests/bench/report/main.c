// gjk-bench-report: prints the figures of a run as tables and writes them as a page.
#include <errno.h>
#include <string.h>

#include "page.h"
#include "text.h"

static int write_page(const table *t, const char *name) {
  FILE *file = fopen(name, "w");
  if (file == NULL) {
    fprintf(stderr, "%s: %s\n", name, strerror(errno));
    return 2;
  }
  page_write(file, t);
  const bool failed = ferror(file) != 0;
  if (fclose(file) != 0 || failed) {
    fprintf(stderr, "%s: cannot write the page\n", name);
    return 2;
  }
  return 0;
}

int main(int argc, char **argv) {
  static table t;
  if (argc != 3) {
    fprintf(stderr, "usage: gjk-bench-report RUN.csv PAGE.html\n");
    return 2;
  }
  FILE *file = fopen(argv[1], "r");
  if (file == NULL) {
    fprintf(stderr, "%s: %s\n", argv[1], strerror(errno));
    return 2;
  }
  const bool good = table_read(&t, file, argv[1]);
  fclose(file);
  int result = 2;
  if (good) {
    text_write(stdout, &t);
    result = write_page(&t, argv[2]);
  }
  table_free(&t);
  return result;
}
