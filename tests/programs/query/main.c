// gjk-query: reads cases and answers each of them in a line.
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "case/answer.h"
#include "case/certify.h"
#include "case/certify2.h"
#include "case/number.h"
#include "case/parse.h"
#include "trace_picture.h"

enum { TITLE_MAX = 160 };

enum { EXIT_ANSWERED = 0, EXIT_UNPROVEN = 1, EXIT_INPUT = 2 };

static const char help[] =
    "usage: gjk-query [OPTION]... [FILE]...\n"
    "Answers cases about two convex shapes, one line each. Reads standard input without a FILE, or for '-'.\n"
    "\n"
    "  --distance    how far apart, and where (default)\n"
    "  --intersect   do they share a point?\n"
    "  --within R    are they at most R apart?\n"
    "  --iterations N    with --within: after N iterations, 1 to 255, it may be open\n"
    "  --penetration how deep they overlap, which way out, and where; else as --distance\n"
    "  --contacts [MARGIN]\n"
    "                as --penetration, and the points where they touch, or are at most MARGIN (default 0) apart\n"
    "  --reference   the double-precision reference answers instead of the library\n"
    "  --certify     check each answer in exact integers; says so where it can't or where an answer is wrong\n"
    "  --trace       below each answer a line for each iteration of the search, and why it stopped; of a depth the\n"
    "                search that finds the overlap\n"
    "  --trace-svg FILE\n"
    "                draws that: a panel for each iteration, the shapes and their Minkowski difference\n"
    "  --help        this text\n"
    "\n"
    "A case, lengths in Q16.16, quaternions, cosines and sines in Q2.30; with a decimal point\n"
    "a number is in units instead:\n"
    "\n"
    "  # comment\n"
    "  case ID [free text]\n"
    "  A KIND ...      point | segment h | triangle (3 lines of x y z) | box hx hy hz\n"
    "                  | hull n (n lines of x y z) | sphere r | capsule r h\n"
    "                  | cylinder r h | cone r h | ellipsoid rx ry rz\n"
    "                  (long axes along local z, h the half length; a cone's apex at +h)\n"
    "  A round r       optional convex radius\n"
    "  A faces m       optional, of a hull, for --contacts: m lines of vertex numbers from 0, each face's\n"
    "                  counterclockwise seen from outside\n"
    "  A at x y z      optional, default 0 0 0\n"
    "  A turn x y z w  optional quaternion, default 0.0 0.0 0.0 1.0\n"
    "  B KIND ...      and so on\n"
    "\n"
    "A case of the plane; its answers have two coordinates:\n"
    "\n"
    "  case2 ID [free text]\n"
    "  A KIND ...      point | segment h | triangle (3 lines of x y) | box hx hy | polygon n (n lines of x y)\n"
    "                  | circle r | capsule r h | ellipse rx ry (long axes along local x)\n"
    "  A round r       optional convex radius\n"
    "  A at x y        optional, default 0 0\n"
    "  A turn c s      optional cosine and sine, default 1.0 0.0\n"
    "  B KIND ...      and so on\n"
    "\n"
    "Answers, in the order of the cases, in raw integers:\n"
    "\n"
    "  ID separated distance=D a=x,y,z b=x,y,z normal=x,y,z iterations=N [saturated]\n"
    "  ID separated iterations=N     (--intersect)\n"
    "  ID intersecting iterations=N\n"
    "  ID intersecting depth=D a=x,y,z b=x,y,z normal=x,y,z iterations=N     (--penetration)\n"
    "    contact a=x,y,z b=x,y,z distance=D id=N     (--contacts) a line per point below; D negative: its depth\n"
    "  ID within iterations=N        (--within; or 'beyond'; with --iterations 'open', where they do not settle it)\n"
    "  ID error STATUS_NAME detail   a pair that the library refuses\n"
    "  ... uncertified: WHY          (--certify) curved: no exact check exists, but accurate bounds agree\n"
    "  ... WRONG: WHY                (--certify) the check failed\n"
    "\n"
    "Below an answer, with --trace:\n"
    "\n"
    "  iteration N d=x,y,z An=x,y,z Bn=x,y,z wN=x,y,z before=w1,... after=w1,...\n"
    "                  the direction ('rounded=' where it is), the vertices of A and B farthest along and against it,\n"
    "                  their difference, named by the iteration that found it first, the simplex before and after\n"
    "  walk N: TEXT    in the plane: the query itself walks along the border of A - B, N iterations in all\n"
    "  stop REASON: TEXT\n"
    "\n"
    "Exit status: 0 all answered; 1 a check failed; 2 a malformed line (skipped with its case, and named on\n"
    "standard error), a file that can't be read, a wrong option, or an output that can't be written.\n";

typedef struct tool {
  case_question question;
  bool certify;              // each answer is checked
  bool trace;                // what the search did is printed below each answer
  const char *picture_name;  // the file in which it is drawn; NULL: none
  trace_picture picture;
  case_reader reader;
  case_pair pair;
  case_collider a, b;
  case2_pair pair2;  // of the plane
  case2_collider a2, b2;
  unsigned long verdicts[3];  // by certify_verdict
  bool bad_input;
} tool;

// Writes nothing if the answer is proven.
static void print_verdict(tool *t, certify_verdict verdict, const char *why) {
  t->verdicts[verdict]++;
  if (verdict != CERTIFY_PROVEN) {
    printf(" %s: %s", verdict == CERTIFY_WRONG ? "WRONG" : "uncertified", why);
  }
}

// An answer in space or in the plane, as a picture's title needs it.
typedef struct summary {
  const char *id;
  gjk_status status;
  bool yes, open;     // of a decision
  bool intersecting;  // of a distance
  gjk_q16 distance;
} summary;

static void write_title(const tool *t, const summary *s, char title[TITLE_MAX]) {
  const bool within = t->question.ask == CASE_WITHIN;
  const char *yes = within ? "within" : "intersecting", *no = s->open ? "open" : within ? "beyond" : "separated";
  if (s->status != GJK_OK) {
    snprintf(title, TITLE_MAX, "%s: %s", s->id, gjk_status_name(s->status));
  } else if (within || t->question.ask == CASE_INTERSECT) {
    snprintf(title, TITLE_MAX, "%s: %s", s->id, s->yes ? yes : no);
  } else if (s->intersecting) {
    snprintf(title, TITLE_MAX, "%s: intersecting", s->id);
  } else {
    snprintf(title, TITLE_MAX, "%s: separated, distance %ld LSB = %.5g units", s->id, (long)s->distance,
             s->distance / 65536.0);
  }
}

// Prints and draws what the search did.
static void show_trace(tool *t, const trace *steps, const trace_bodies *bodies, const char *title) {
  if (t->trace) {
    trace_print(stdout, steps);
  }
  if (t->picture_name != NULL) {
    trace_picture_add(&t->picture, title, steps, bodies);
  }
}

static void trace_pair(tool *t, const case_answer *answer) {
  static trace steps;
  static trace_bodies bodies;
  char title[TITLE_MAX];
  const summary said = {.id = t->pair.id,
                        .status = answer->status,
                        .yes = answer->decision.yes,
                        .open = answer->open,
                        .intersecting = answer->distance.intersecting,
                        .distance = answer->distance.distance};
  write_title(t, &said, title);
  trace_space(&t->question, &t->a.collider, &t->b.collider, &steps);
  trace_bodies_space(&t->pair, &bodies);
  show_trace(t, &steps, &bodies, title);
}

static void trace_pair2(tool *t, const case2_answer *answer) {
  static trace steps;
  static trace_bodies bodies;
  char title[TITLE_MAX];
  const summary said = {.id = t->pair2.id,
                        .status = answer->status,
                        .yes = answer->decision.yes,
                        .open = answer->open,
                        .intersecting = answer->distance.intersecting,
                        .distance = answer->distance.distance};
  write_title(t, &said, title);
  trace_plane(&t->question, &t->a2.collider, &t->b2.collider, &steps);
  trace_bodies_plane(&t->pair2, &t->a2.collider, &t->b2.collider, &bodies);
  show_trace(t, &steps, &bodies, title);
}

static bool is_traced(const tool *t) {
  return t->trace || t->picture_name != NULL;
}

static void answer_pair(tool *t) {
  case_answer answer;
  char why[CERTIFY_WHY_MAX];
  case_answer_find(&t->question, &t->pair, &t->a, &t->b, &answer);
  case_answer_print(stdout, &t->question, &t->pair, &answer);
  if (t->certify && answer.refused == 0) {
    print_verdict(t, certify_answer(&t->question, &t->pair, &t->a, &t->b, &answer, why), why);
  }
  putchar('\n');
  case_contacts_print(stdout, &answer);
  if (is_traced(t) && answer.refused == 0) {
    trace_pair(t, &answer);
  }
}

static void answer_pair2(tool *t) {
  case2_answer answer;
  char why[CERTIFY_WHY_MAX];
  case2_answer_find(&t->question, &t->pair2, &t->a2, &t->b2, &answer);
  case2_answer_print(stdout, &t->question, &t->pair2, &answer);
  if (t->certify && answer.refused == 0) {
    print_verdict(t, certify2_answer(&t->question, &t->pair2, &t->a2, &t->b2, &answer, why), why);
  }
  putchar('\n');
  case2_contacts_print(stdout, &answer);
  if (is_traced(t) && answer.refused == 0) {
    trace_pair2(t, &answer);
  }
}

static void run_stream(tool *t, FILE *file, const char *name) {
  case_found found;
  case_reader_open(&t->reader, file, name);
  while ((found = case_reader_next_any(&t->reader, &t->pair, &t->pair2)) != CASE_FOUND_NONE) {
    if (found == CASE_FOUND_PLANE) {
      answer_pair2(t);
    } else {
      answer_pair(t);
    }
  }
  if (t->reader.errors > 0) {
    t->bad_input = true;
  }
}

static void run_file(tool *t, const char *name) {
  if (strcmp(name, "-") == 0) {
    run_stream(t, stdin, "standard input");
    return;
  }
  FILE *file = fopen(name, "r");
  if (file == NULL) {
    fprintf(stderr, "%s: %s\n", name, strerror(errno));
    t->bad_input = true;
    return;
  }
  run_stream(t, file, name);
  fclose(file);
}

// The exit status; a failure if a part of the output could not be written.
static int written(int status) {
  if (fflush(stdout) == 0 && ferror(stdout) == 0) {
    return status;
  }
  fprintf(stderr, "gjk-query: cannot write the answers: %s\n", strerror(errno));
  return EXIT_INPUT;
}

static void refuse(const char *what, const char *word) {
  fprintf(stderr, "gjk-query: %s '%s'; see gjk-query --help\n", what, word);
  exit(EXIT_INPUT);
}

static uint8_t read_iterations(const char *number) {
  int32_t iterations;
  if (!case_number_parse(number, 0, &iterations) || iterations < 1 || iterations > UINT8_MAX) {
    refuse("expected a number from 1 to 255 after --iterations, found", number);
  }
  return (uint8_t)iterations;
}

// Reads the options, and moves the names of the files to the front of argv. Returns their number.
static int read_options(int argc, char **argv, tool *t) {
  int files = 0;
  bool only_files = false;
  for (int i = 1; i < argc; i++) {
    const char *word = argv[i];
    if (only_files || word[0] != '-' || strcmp(word, "-") == 0) {
      argv[files++] = argv[i];
    } else if (strcmp(word, "--") == 0) {
      only_files = true;
    } else if (strcmp(word, "--help") == 0) {
      fputs(help, stdout);
      exit(written(EXIT_ANSWERED));
    } else if (strcmp(word, "--distance") == 0) {
      t->question.ask = CASE_DISTANCE;
    } else if (strcmp(word, "--intersect") == 0) {
      t->question.ask = CASE_INTERSECT;
    } else if (strcmp(word, "--penetration") == 0) {
      t->question.ask = CASE_PENETRATION;
    } else if (strcmp(word, "--contacts") == 0) {
      t->question.ask = CASE_PENETRATION;
      t->question.contacts = true;
      if (i + 1 < argc && case_number_parse(argv[i + 1], 16, &t->question.margin)) {
        i++;
      }
      if (t->question.margin < 0) {
        refuse("expected a margin of 0 or more after --contacts, found", argv[i]);
      }
    } else if (strcmp(word, "--within") == 0) {
      const char *number = i + 1 < argc ? argv[++i] : "";
      t->question.ask = CASE_WITHIN;
      if (!case_number_parse(number, 16, &t->question.within) || t->question.within < 0) {
        refuse("expected a distance of 0 or more after --within, found", number);
      }
    } else if (strcmp(word, "--iterations") == 0) {
      const char *number = i + 1 < argc ? argv[++i] : "";
      t->question.iterations = read_iterations(number);
    } else if (strcmp(word, "--reference") == 0) {
      t->question.reference = true;
    } else if (strcmp(word, "--certify") == 0) {
      t->certify = true;
    } else if (strcmp(word, "--trace") == 0) {
      t->trace = true;
    } else if (strcmp(word, "--trace-svg") == 0) {
      t->picture_name = i + 1 < argc ? argv[++i] : "";
      if (t->picture_name[0] == '\0') {
        refuse("expected the name of a file after", word);
      }
    } else {
      refuse("unknown option", word);
    }
  }
  return files;
}

int main(int argc, char **argv) {
  static tool t;
  int files = read_options(argc, argv, &t);
  if (t.picture_name != NULL && !trace_picture_open(&t.picture)) {
    refuse("cannot draw", t.picture_name);
  }
  if (files == 0) {
    run_stream(&t, stdin, "standard input");
  }
  for (int i = 0; i < files; i++) {
    run_file(&t, argv[i]);
  }
  if (t.certify) {
    fprintf(stderr, "certify: %lu certified, %lu uncertified, %lu wrong\n", t.verdicts[CERTIFY_PROVEN],
            t.verdicts[CERTIFY_UNCERTIFIED], t.verdicts[CERTIFY_WRONG]);
  }
  if (t.picture_name != NULL && !trace_picture_close(&t.picture, t.picture_name)) {
    fprintf(stderr, "gjk-query: cannot write %s: %s\n", t.picture_name, strerror(errno));
    t.bad_input = true;
  }
  case_pair_free(&t.pair);
  case_collider_free(&t.a);
  case_collider_free(&t.b);
  case2_pair_free(&t.pair2);
  case2_collider_free(&t.a2);
  case2_collider_free(&t.b2);
  return written(t.bad_input ? EXIT_INPUT : t.verdicts[CERTIFY_WRONG] > 0 ? EXIT_UNPROVEN : EXIT_ANSWERED);
}
