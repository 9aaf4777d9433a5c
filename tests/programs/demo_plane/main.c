// gjk-demo-plane PLAYER INPUTS TICKS [PICTURE]: one side of a match on the level; the link is standard input and output.
//
// INPUTS has lines PLAYER TICKS KEYS; of them this side reads its player's alone. Exit status: 0 if both sides were the
// same after every tick, 1 if they differed, 2 if the link broke or a file is bad.
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "picture.h"
#include "play.h"

#define RUNS 256

static void write_text(const char *text) {
  fputs(text, stdout);
}

// Sends what was written before this side waits.
static int read_character(void) {
  fflush(stdout);
  return getchar();
}

static uint8_t keys_of(const char *text) {
  return (uint8_t)((strchr(text, 'L') != NULL ? LEVEL_LEFT : 0) | (strchr(text, 'R') != NULL ? LEVEL_RIGHT : 0) |
                   (strchr(text, 'J') != NULL ? LEVEL_JUMP : 0));
}

// Reads the runs of a player. Negative: the file is bad.
static int read_runs(const char *name, unsigned player, play_run runs[RUNS]) {
  FILE *file = fopen(name, "r");
  char line[128], keys[8];
  unsigned of, ticks;
  int count = 0;
  if (file == NULL) {
    fprintf(stderr, "%s: %s\n", name, strerror(errno));
    return -1;
  }
  while (fgets(line, sizeof line, file) != NULL && count >= 0) {
    if (line[0] == '#' || line[0] == '\n') {
      continue;
    }
    if (sscanf(line, "%u %u %7[LRJ-]", &of, &ticks, keys) != 3 || of >= LEVEL_PLAYERS || ticks > UINT16_MAX ||
        count == RUNS) {
      fprintf(stderr, "%s: bad line: %s", name, line);
      count = -1;
    } else if (of == player) {
      runs[count].ticks = (uint16_t)ticks;
      runs[count++].keys = keys_of(keys);
    }
  }
  fclose(file);
  return count;
}

static int draw(const char *name, const flat_world *w, uint32_t ticks) {
  FILE *file = fopen(name, "w");
  if (file == NULL) {
    fprintf(stderr, "%s: %s\n", name, strerror(errno));
    return 2;
  }
  picture_draw(file, w, ticks, level_hash(w));
  const bool failed = ferror(file) != 0;
  return fclose(file) != 0 || failed ? 2 : 0;
}

int main(int argc, char **argv) {
  static const play_link link = {write_text, read_character};
  static play_run runs[RUNS];
  static flat_world world;
  if (argc < 4 || (strcmp(argv[1], "0") != 0 && strcmp(argv[1], "1") != 0)) {
    fputs("usage: gjk-demo-plane PLAYER INPUTS TICKS [PICTURE]\n", stderr);
    return 2;
  }
  const unsigned player = argv[1][0] == '1';
  const int count = read_runs(argv[2], player, runs);
  const play_options options = {player, (uint32_t)strtoul(argv[3], NULL, 10), runs, (unsigned)count,
                                argc > 4 ? picture_note : NULL};
  if (count < 0) {
    return 2;
  }
  uint32_t ticks;
  const play_result result = play_match(&options, &link, &world, &ticks);
  fflush(stdout);
  if (player == 0) {
    fprintf(stderr, "%u ticks, %s; end 0x%016llx, %u contact points of pairs, %u of ground\n", (unsigned)ticks,
            result == PLAY_SAME        ? "the same hash after each"
            : result == PLAY_DIFFERENT ? "then they differ"
                                       : "then the link broke",
            (unsigned long long)level_hash(&world), (unsigned)world.met, (unsigned)world.met_ground);
  }
  return result == PLAY_SAME && argc > 4 ? draw(argv[4], &world, ticks) : (int)result;
}
