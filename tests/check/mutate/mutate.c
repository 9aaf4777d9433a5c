// Makes small wrong changes of a C file, one at a time.
//
//   mutate list FILE           one line per mutant: FILE, its number, line, change, text of the line; tabs between;
//                              the change ends in (2) where it is the second such place of the line
//   mutate apply FILE NUMBER   the file with that change, on standard output
//
// Changed are function bodies and initialisers: comparisons (bound and sense), && and ||, + - * << >> & | ^, negations,
// integers by one, true and false, the first two arguments of a call; and statements go. Declarations of types, the
// preprocessor's lines, comments and strings stay. It reads the layout of this project: braces everywhere, binary
// operators between spaces.
#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TEXT_MAX (1 << 20)
#define TOKENS_MAX (1 << 17)

typedef struct token {
  int start, length;
  int line;
  int depth;  // of braces, 0 at file scope and in types
} token;

static char text[TEXT_MAX];
static int size;
static token tokens[TOKENS_MAX];
static int count;

// What to do with the mutants: list all, or apply one.
static const char *file_name;
static int wanted = -1, number;

static bool is_word(int c) {
  return isalnum(c) || c == '_';
}

static bool is(int t, const char *word) {
  return t >= 0 && t < count && (int)strlen(word) == tokens[t].length &&
         strncmp(text + tokens[t].start, word, strlen(word)) == 0;
}

static bool is_one_of(int t, const char *const *words) {
  for (; *words != NULL; words++) {
    if (is(t, *words)) {
      return true;
    }
  }
  return false;
}

// Skips what is not a token: white space, comments and preprocessor lines.
static int skip(int at, int *line) {
  for (;;) {
    const bool at_start = at == 0 || text[at - 1] == '\n';
    if (text[at] == '/' && text[at + 1] == '/') {
      at += (int)strcspn(text + at, "\n");
    } else if (at_start && text[at] == '#') {
      while (text[at] != '\0' && (text[at] != '\n' || text[at - 1] == '\\')) {
        *line += text[at++] == '\n';
      }
    } else if (isspace((unsigned char)text[at])) {
      *line += text[at++] == '\n';
    } else {
      return at;
    }
  }
}

static int token_length(int at) {
  static const char *const operators[] = {"<<=", ">>=", "...", "->", "++", "--", "<<", ">>", "<=", ">=", "==",
                                          "!=",  "&&",  "||",  "+=", "-=", "*=", "/=", "|=", "&=", "^=", NULL};
  if (is_word((unsigned char)text[at])) {
    int n = 1;
    while (is_word((unsigned char)text[at + n])) {
      n++;
    }
    return n;
  }
  if (text[at] == '"' || text[at] == '\'') {
    int n = 1;
    while (text[at + n] != text[at]) {
      n += text[at + n] == '\\' ? 2 : 1;
    }
    return n + 1;
  }
  for (int i = 0; operators[i] != NULL; i++) {
    if (strncmp(text + at, operators[i], strlen(operators[i])) == 0) {
      return (int)strlen(operators[i]);
    }
  }
  return 1;
}

// Does the brace at token t open a type or a linkage specification? A type has struct or enum, and perhaps a tag,
// before it.
static bool opens_type(int t) {
  static const char *const types[] = {"struct", "enum", "union", "extern", NULL};
  return is_one_of(t - 1, types) || is_one_of(t - 2, types);
}

static void tokenize(void) {
  int line = 1, depth = 0, type_depth = 0;
  for (int at = skip(0, &line); at < size; at = skip(at, &line)) {
    if (count == TOKENS_MAX) {
      fprintf(stderr, "mutate: %s has too many tokens\n", file_name);
      exit(2);
    }
    tokens[count].start = at;
    tokens[count].length = token_length(at);
    tokens[count].line = line;
    tokens[count].depth = type_depth > 0 ? 0 : depth;
    at += tokens[count].length;
    count++;
    if (is(count - 1, "{")) {
      type_depth += type_depth > 0 || opens_type(count - 1);
      depth += type_depth == 0;
    } else if (is(count - 1, "}")) {
      depth -= type_depth == 0;
      type_depth -= type_depth > 0;
    }
  }
}

static void print_line_of(int line) {
  const char *at = text;
  for (int i = 1; i < line; i++) {
    at = strchr(at, '\n') + 1;
  }
  at += strspn(at, " ");
  printf("%.*s\n", (int)strcspn(at, "\n"), at);
}

// How many times the same text has stood in its line before start.
static int times_before(int line, int start, int length) {
  int times = 0;
  for (int t = 0; t < count && tokens[t].line <= line && tokens[t].start < start; t++) {
    times += tokens[t].line == line && strncmp(text + tokens[t].start, text + start, (size_t)length) == 0;
  }
  return times;
}

// Prints length characters in one line: an end of a line, and the blanks after it, as one blank.
static void print_in_line(const char *at, int length) {
  for (int i = 0; i < length && at[i] != '\0'; i++) {
    if (at[i] != '\n') {
      putchar(at[i]);
    } else {
      putchar(' ');
      i += (int)strspn(at + i + 1, " ");
    }
  }
}

// Makes a mutant: the length characters from start become replacement. If they stand in the line more than once, the
// change says which one is meant, from the second on.
static void mutant(int line, int start, int length, const char *replacement) {
  if (wanted < 0) {
    const int before = times_before(line, start, length);
    printf("%s\t%d\t%d\t", file_name, number, line);
    print_in_line(text + start, length);
    printf(" => ");
    print_in_line(replacement, (int)strlen(replacement));
    if (before > 0) {
      printf(" (%d)", before + 1);
    }
    printf("\t");
    print_line_of(line);
  } else if (wanted == number) {
    printf("%.*s%s%s", start, text, replacement, text + start + length);
  }
  number++;
}

static void replace(int t, const char *replacement) {
  mutant(tokens[t].line, tokens[t].start, tokens[t].length, replacement);
}

static bool is_value_end(int t) {
  static const char *const words[] = {"return", "case", "sizeof", "else", NULL};
  const char last = t < 0 ? ' ' : text[tokens[t].start + tokens[t].length - 1];
  return (is_word((unsigned char)last) && !is_one_of(t, words)) || last == ')' || last == ']';
}

static bool is_binary(int t) {
  return is_value_end(t - 1) && text[tokens[t].start - 1] == ' ' &&
         isspace((unsigned char)text[tokens[t].start + tokens[t].length]);
}

static void mutate_operator(int t) {
  static const struct {
    const char *from, *to[2];
  } binary[] = {{"==", {"!=", NULL}}, {"!=", {"==", NULL}}, {"<", {"<=", ">="}},  {"<=", {"<", ">"}},
                {">", {">=", "<="}},  {">=", {">", "<"}},   {"&&", {"||", NULL}}, {"||", {"&&", NULL}},
                {"+", {"-", NULL}},   {"-", {"+", NULL}},   {"*", {"+", NULL}},   {"<<", {">>", NULL}},
                {">>", {"<<", NULL}}, {"&", {"|", NULL}},   {"|", {"&", NULL}},   {"^", {"|", NULL}},
                {"+=", {"-=", NULL}}, {"-=", {"+=", NULL}}, {"|=", {"&=", NULL}}, {"&=", {"|=", NULL}}};
  if (is_binary(t)) {
    for (size_t i = 0; i < sizeof binary / sizeof binary[0]; i++) {
      for (int k = 0; k < 2 && is(t, binary[i].from) && binary[i].to[k] != NULL; k++) {
        replace(t, binary[i].to[k]);
      }
    }
  } else if ((is(t, "-") && !is_value_end(t - 1)) || is(t, "!") || is(t, "~")) {
    replace(t, "");
  } else if (is(t, "++")) {
    replace(t, "--");
  }
}

static void mutate_number(int t) {
  const char *start = text + tokens[t].start;
  char *end;
  if (is(t, "true") || is(t, "false")) {
    replace(t, is(t, "true") ? "false" : "true");
    return;
  }
  if (!isdigit((unsigned char)*start)) {
    return;
  }
  const unsigned long long value = strtoull(start, &end, 0);
  const int suffix = tokens[t].length - (int)(end - start);
  for (int step = value > 0 ? -1 : 1; step <= 1; step += 2) {
    char changed[40];
    snprintf(changed, sizeof changed, "%llu%.*s", value + (unsigned long long)step, suffix, end);
    replace(t, changed);
  }
}

// The token that ends the expression at t on its level: a comma, closing bracket or semicolon.
static int end_of_part(int t) {
  for (int level = 0; t < count; t++) {
    if (is(t, "(") || is(t, "[") || is(t, "{")) {
      level++;
    } else if (level > 0 && (is(t, ")") || is(t, "]") || is(t, "}"))) {
      level--;
    } else if (level == 0 && (is(t, ",") || is(t, ")") || is(t, "]") || is(t, "}") || is(t, ";"))) {
      return t;
    }
  }
  return t;
}

static int end_of(int t) {
  return tokens[t].start + tokens[t].length;
}

// f(a, b ...) becomes f(b, a ...), unless their order cannot matter.
static void swap_arguments(int t) {
  static const char *const symmetric[] = {"gjk_mul32", "gjk_umul32",   "gjk_umulh32", "gjk_add", "gjk_dot",
                                          "multiply",  "multiply_q33", "sizeof",      NULL};
  static const char *const words[] = {"if", "while", "for", "switch", "return", NULL};
  if (!is(t + 1, "(") || !isalpha((unsigned char)text[tokens[t].start]) || is_one_of(t, symmetric) ||
      is_one_of(t, words)) {
    return;
  }
  const int comma = end_of_part(t + 2), last = is(comma, ",") ? end_of_part(comma + 1) : -1;
  if (last < 0) {
    return;
  }
  char swapped[512];
  const int a = tokens[t + 2].start, a_end = end_of(comma - 1), b = tokens[comma + 1].start, b_end = end_of(last - 1);
  snprintf(swapped, sizeof swapped, "%.*s, %.*s", b_end - b, text + b, a_end - a, text + a);
  if (strchr(swapped, '\n') == NULL) {
    mutant(tokens[t].line, a, b_end - a, swapped);
  }
}

// Removes an assignment or a call.
static void remove_statement(int t) {
  static const char *const before[] = {";", "{", "}", NULL};
  static const char *const second[] = {"(", ".", "->", "[", "=", "+=", "-=", "|=", "&=", "<<=", ">>=", NULL};
  static const char *const words[] = {"if", "while", "for", "switch", "return", NULL};
  const bool pointer = is(t, "*");
  if (!is_one_of(t - 1, before) || (!pointer && !isalpha((unsigned char)text[tokens[t].start])) ||
      (!pointer && !is_one_of(t + 1, second)) || is_one_of(t, words)) {
    return;
  }
  int end = t;
  while (end < count && !is(end, ";") && !is(end, "}") && !is(end, "{")) {
    end++;
  }
  if (!is(end, ";")) {
    return;  // an initialiser
  }
  const int start = tokens[t].start, length = end_of(end) - start;
  if (memchr(text + start, '\n', (size_t)length) == NULL) {
    mutant(tokens[t].line, start, length, ";");
  }
}

int main(int argc, char **argv) {
  const bool apply = argc == 4 && strcmp(argv[1], "apply") == 0;
  if (!apply && !(argc == 3 && strcmp(argv[1], "list") == 0)) {
    fprintf(stderr, "usage: mutate list FILE | mutate apply FILE NUMBER\n");
    return 2;
  }
  file_name = argv[2];
  wanted = apply ? atoi(argv[3]) : -1;
  FILE *file = fopen(file_name, "r");
  if (file == NULL) {
    perror(file_name);
    return 2;
  }
  size = (int)fread(text, 1, TEXT_MAX - 1, file);
  fclose(file);
  tokenize();
  for (int t = 0; t < count; t++) {
    if (tokens[t].depth > 0) {
      mutate_operator(t);
      mutate_number(t);
      swap_arguments(t);
      remove_statement(t);
    }
  }
  return wanted >= number ? 2 : 0;
}
