// gjk-query: reads cases and answers each of them in a line.
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "arm.h"
#include "case/answer.h"
#include "case/certify.h"
#include "case/certify2.h"
#include "case/number.h"
#include "case/parse.h"
#include "help.h"
#include "motion.h"
#include "trace_picture.h"

enum { TITLE_MAX = 160 };

enum { EXIT_ANSWERED = 0, EXIT_UNPROVEN = 1, EXIT_INPUT = 2 };

typedef struct tool {
  case_question question;
  motion_question motion;    // instead of question, if it asks
  bool arms;                 // files describe machines and their edges
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

static void answer_motion(tool *t) {
  motion_answer answer;
  char why[CERTIFY_WHY_MAX];
  motion_find(&t->motion, &t->pair, &t->a, &t->b, &answer);
  motion_print(stdout, &t->motion, &t->pair, &answer);
  if (t->certify && answer.refused == 0) {
    print_verdict(t, motion_certify(&t->motion, &t->pair, &t->a, &t->b, &answer, why), why);
  }
  putchar('\n');
}

static void answer_motion2(tool *t) {
  motion2_answer answer;
  char why[CERTIFY_WHY_MAX];
  motion2_find(&t->motion, &t->pair2, &t->a2, &t->b2, &answer);
  motion2_print(stdout, &t->motion, &t->pair2, &answer);
  if (t->certify && answer.refused == 0) {
    print_verdict(t, motion2_certify(&t->motion, &t->pair2, &t->a2, &t->b2, &answer, why), why);
  }
  putchar('\n');
}

// Answers a file of machines.
static void run_arms(tool *t, FILE *file, const char *name) {
  arm_tally tally = {{0, 0, 0}, false};
  arm_run(file, name, t->certify, &tally);
  for (unsigned i = 0; i < 3; i++) {
    t->verdicts[i] += tally.verdicts[i];
  }
  t->bad_input = t->bad_input || tally.bad_input;
}

static void run_stream(tool *t, FILE *file, const char *name) {
  case_found found;
  if (t->arms) {
    run_arms(t, file, name);
    return;
  }
  case_reader_open(&t->reader, file, name);
  while ((found = case_reader_next_any(&t->reader, &t->pair, &t->pair2)) != CASE_FOUND_NONE) {
    const bool plane = found == CASE_FOUND_PLANE, moves = t->motion.ask != MOTION_NONE;
    void (*const answer)(tool *) =
        plane ? (moves ? answer_motion2 : answer_pair2) : (moves ? answer_motion : answer_pair);
    answer(t);
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

// Takes the number after an option, if there is one. Returns the index of the last word taken.
static int read_margin(int argc, char **argv, int i, gjk_q16 *margin) {
  const char *option = argv[i];
  if (i + 1 < argc && case_number_parse(argv[i + 1], 16, margin)) {
    i++;
  }
  if (*margin < 0) {
    fprintf(stderr, "gjk-query: expected a margin of 0 or more after %s, found '%s'; see gjk-query --help\n", option,
            argv[i]);
    exit(EXIT_INPUT);
  }
  return i;
}

// The options about motion. Returns the index of the last word taken; i - 1 if it is another option.
static int read_motion(int argc, char **argv, int i, motion_question *motion) {
  const char *word = argv[i];
  if (strcmp(word, "--cast") == 0 || strcmp(word, "--impact") == 0) {
    motion->ask = word[2] == 'c' ? MOTION_CAST : MOTION_IMPACT;
    return read_margin(argc, argv, i, &motion->margin);
  }
  if (strcmp(word, "--ray") == 0) {
    motion->ask = MOTION_RAY;
    return i;
  }
  if (strcmp(word, "--tolerance") == 0) {
    const char *number = i + 1 < argc ? argv[i + 1] : "";
    if (!case_number_parse(number, 16, &motion->tolerance) || motion->tolerance <= 0) {
      refuse("expected a tolerance above 0 after --tolerance, found", number);
    }
    return i + 1;
  }
  return i - 1;
}

static uint8_t read_iterations(const char *number) {
  int32_t iterations;
  if (!case_number_parse(number, 0, &iterations) || iterations < 1 || iterations > UINT8_MAX) {
    refuse("expected a number from 1 to 255 after --iterations, found", number);
  }
  return (uint8_t)iterations;
}

// The last question counts.
static void ask_at_rest(tool *t, case_ask ask) {
  t->question.ask = ask;
  t->motion.ask = MOTION_NONE;
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
      help_print(stdout);
      exit(written(EXIT_ANSWERED));
    } else if (strcmp(word, "--distance") == 0) {
      ask_at_rest(t, CASE_DISTANCE);
    } else if (strcmp(word, "--intersect") == 0) {
      ask_at_rest(t, CASE_INTERSECT);
    } else if (strcmp(word, "--penetration") == 0) {
      ask_at_rest(t, CASE_PENETRATION);
    } else if (strcmp(word, "--contacts") == 0) {
      ask_at_rest(t, CASE_PENETRATION);
      t->question.contacts = true;
      i = read_margin(argc, argv, i, &t->question.margin);
    } else if (strcmp(word, "--within") == 0) {
      const char *number = i + 1 < argc ? argv[++i] : "";
      ask_at_rest(t, CASE_WITHIN);
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
    } else if (strcmp(word, "--arm") == 0) {
      t->arms = true;
    } else if (strcmp(word, "--trace") == 0) {
      t->trace = true;
    } else if (strcmp(word, "--trace-svg") == 0) {
      t->picture_name = i + 1 < argc ? argv[++i] : "";
      if (t->picture_name[0] == '\0') {
        refuse("expected the name of a file after", word);
      }
    } else {
      const int last = read_motion(argc, argv, i, &t->motion);
      if (last < i) {
        refuse("unknown option", word);
      }
      i = last;
    }
  }
  if (t->motion.ask != MOTION_NONE && (t->question.reference || is_traced(t))) {
    refuse("casts and impacts have no", t->question.reference ? "--reference" : "--trace");
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
