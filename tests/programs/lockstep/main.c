// lockstep PLAYER TICKS [DIVERGE]: one side of a lockstep match; the link is standard input and output.
//
// Exit status: 0 if both sides were the same after every tick, 1 if they differed, 2 if the link broke.
#include <stdio.h>
#include <stdlib.h>

#include "peer.h"

static void write_text(const char *text) {
  fputs(text, stdout);
}

// Sends what was written before this side waits.
static int read_character(void) {
  fflush(stdout);
  return getchar();
}

static void say(const char *text) {
  fputs(text, stderr);
}

int main(int argc, char **argv) {
  const peer_link link = {write_text, read_character};
  peer_options options = {0, 0, 0};
  if (argc < 3) {
    fputs("usage: lockstep PLAYER TICKS [DIVERGE]\n", stderr);
    return 2;
  }
  options.player = (unsigned)strtoul(argv[1], NULL, 10);
  options.ticks = (uint32_t)strtoul(argv[2], NULL, 10);
  options.diverge = argc > 3 ? (uint32_t)strtoul(argv[3], NULL, 10) : 0;
  const peer_result result = peer_play(&options, &link, say);
  fflush(stdout);
  return (int)result;
}
