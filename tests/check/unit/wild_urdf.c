// The reader of robots on seeded mutations of an URDF and an SRDF, for the sanitizers: wild_urdf URDF SRDF COUNT SEED
//
// Pieces are taken out, put elsewhere, doubled, and bytes and words are written over. Each is refused with one line that
// names a line of the file, or becomes a machine.
#include <ctype.h>
#include <string.h>

#include "check.h"
#include "random.h"
#include "tests/programs/convert/machine.h"
#include "tests/programs/convert/read.h"

#define ROOM 65536

typedef struct text {
  const char *name;
  char bytes[ROOM];
  size_t size;
} text;

static bool load(text *t, const char *name) {
  char *bytes = read_whole(name, &t->size);
  const bool loaded = bytes != NULL && t->size < ROOM / 4;
  if (loaded) {
    memcpy(t->bytes, bytes, t->size);
  }
  t->name = name;
  free(bytes);
  return loaded;
}

// Puts a piece of more bytes in place of a number of those at a place.
static void replace(text *t, size_t at, size_t gone, const char *piece, size_t more) {
  memmove(t->bytes + at + more, t->bytes + at + gone, t->size - at - gone);
  memcpy(t->bytes + at, piece, more);
  t->size = t->size - gone + more;
}

static void mutate(text *t, random_state *random) {
  static const char *const words[] = {"<",          ">",
                                      "/>",         "\"",
                                      "'",          "&",
                                      "&#65;",      "&#x110000;",
                                      "-->",        "<!--",
                                      "<![CDATA[",  "]]>",
                                      "1e9",        "-1e99",
                                      "1e-320",     "0x1p3",
                                      "--",         "nan",
                                      "0",          "<link/>",
                                      "name",       "base",
                                      "upper",      "<?",
                                      "0 0 0",      "<!DOCTYPE a>",
                                      "\n",         "\xEF\xBB\xBF",
                                      "<joint",     "</robot>",
                                      "continuous", "fixed"};
  char piece[64];
  const size_t at = random_below(random, (uint32_t)t->size + 1), left = t->size - at;
  const size_t length = left < 1 ? 0 : 1 + random_below(random, left < 60 ? (uint32_t)left : 60);
  memcpy(piece, t->bytes + at, length);
  const size_t to = random_below(random, (uint32_t)(t->size - length) + 1);
  const char *word = words[random_below(random, sizeof words / sizeof words[0])];
  switch (random_below(random, 5)) {
    case 0: replace(t, at, length, "", 0); break;
    case 1: replace(t, to, 0, piece, length); break;
    case 2: replace(t, at, random_below(random, 2) * length, word, strlen(word)); break;
    case 3:
      if (left > 0) {
        t->bytes[at] = (char)(t->bytes[at] ^ (1 << random_below(random, 8)));
      }
      break;
    default:  // another digit: most of these are still robots
      for (size_t i = at; i < t->size; i++) {
        if (isdigit((unsigned char)t->bytes[i])) {
          t->bytes[i] = (char)('0' + random_below(random, 10));
          break;
        }
      }
  }
}

// A message is one line that begins with the file and a line of it.
static void check_problem(const xml_reader *r, const text *t) {
  const size_t length = strlen(t->name);
  unsigned long lines = 1;
  char *end;
  for (size_t i = 0; i < t->size; i++) {
    lines += t->bytes[i] == '\n' ? 1u : 0u;
  }
  CHECK_MSG(strncmp(r->problem, t->name, length) == 0 && r->problem[length] == ':', "'%s'", r->problem);
  const unsigned long line = strtoul(r->problem + length + 1, &end, 10);
  CHECK_MSG(line >= 1 && line <= lines && strncmp(end, ": ", 2) == 0 && strchr(end, '\n') == NULL, "'%s'", r->problem);
}

int main(int argc, char **argv) {
  static const machine_options how = {65536, -1, false, {-1, 0}};
  static text robot_text, pairs_text, urdf, srdf;
  static robot b;
  static machine m;
  unsigned long made = 0, refused = 0;
  if (argc != 5 || !load(&robot_text, argv[1]) || !load(&pairs_text, argv[2])) {
    return 2;
  }
  random_state random = random_seed(check_seed(strtoull(argv[4], NULL, 10)));
  const unsigned long count = strtoul(argv[3], NULL, 10);
  for (unsigned long i = 0; i < count; i++) {
    xml_reader r, pairs;
    check_trial(i, NULL, NULL);
    urdf = robot_text;
    srdf = pairs_text;
    for (unsigned k = random_below(&random, 3); k < 3; k++) {
      mutate(random_below(&random, 4) == 0 ? &srdf : &urdf, &random);
    }
    char *one = malloc(urdf.size + 1), *other = malloc(srdf.size + 1);
    memmove(one + 1, urdf.bytes, urdf.size);  // to the end of the memory, so that a look beyond it is seen
    memmove(other + 1, srdf.bytes, srdf.size);
    xml_open(&r, urdf.name, one + 1, urdf.size);
    xml_open(&pairs, srdf.name, other + 1, srdf.size);
    if (!robot_read(&b, &r) || (i % 4 == 0 && !machine_make(&m, &b, true, &how, &r))) {
      check_problem(&r, &urdf);
      refused++;
    } else if (!robot_read_pairs(&b, &pairs)) {
      check_problem(&pairs, &srdf);
      refused++;
    } else {
      CHECK(r.problem[0] == '\0' && pairs.problem[0] == '\0');
      made++;
    }
    machine_free(&m);
    memset(&m, 0, sizeof m);
    free(one);
    free(other);
  }
  CHECK(made > count / 10 && refused > count / 10);
  return check_done("wild_urdf");
}
