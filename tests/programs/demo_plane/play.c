// One side of a match on the level.
#include "play.h"

#include "print.h"

static void write_line(const play_link *link, const char *kind, uint32_t tick, uint64_t value) {
  link->write(kind);
  link->write(" ");
  print_hex(link->write, tick);
  link->write(" ");
  print_hex(link->write, value);
  link->write("\n");
}

// Reads a number of base 16 and the character after it.
static bool read_number(const play_link *link, char end, uint64_t *value) {
  *value = 0;
  for (int i = 0; i < 17; i++) {
    const int c = link->read();
    if (c == end) {
      return i > 0;
    }
    if (!((c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'))) {
      return false;
    }
    *value = *value << 4 | (uint64_t)(c <= '9' ? c - '0' : c - 'a' + 10);
  }
  return false;
}

// Tells the other side a number about a tick, and reads its number about the same.
static bool exchange(const play_link *link, const char *kind, uint32_t tick, uint64_t mine, uint64_t *theirs) {
  uint64_t heard;
  write_line(link, kind, tick, mine);
  return link->read() == kind[0] && link->read() == ' ' && read_number(link, ' ', &heard) && heard == tick &&
         read_number(link, '\n', theirs);
}

static uint8_t keys_at(const play_options *options, uint32_t tick) {
  uint32_t end = 0;
  for (unsigned i = 0; i < options->runs; i++) {
    end += options->run[i].ticks;
    if (tick < end) {
      return options->run[i].keys;
    }
  }
  return 0;
}

play_result play_match(const play_options *options, const play_link *link, flat_world *w, uint32_t *ticks) {
  level_start(w);
  for (*ticks = 0; *ticks < options->ticks; ++*ticks) {
    uint8_t keys[LEVEL_PLAYERS];
    uint64_t theirs;
    keys[options->player] = keys_at(options, *ticks);
    if (!exchange(link, "i", *ticks, keys[options->player], &theirs) || theirs > 7) {
      return PLAY_BROKEN;
    }
    keys[1 - options->player] = (uint8_t)theirs;
    level_tick(w, keys);
    if (!exchange(link, "h", *ticks, level_hash(w), &theirs)) {
      return PLAY_BROKEN;
    }
    if (theirs != level_hash(w)) {
      return PLAY_DIFFERENT;
    }
    if (options->after != NULL) {
      options->after(w, *ticks);
    }
  }
  return PLAY_SAME;
}
