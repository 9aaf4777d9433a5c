// Firmware: instructions and stack per query on an emulated core, one line per family.
#include "bench.h"
#include "mps2/board.h"
#include "print.h"

#define LOOP 1000u
#define PAINT 0x5AA5C33Cu

// Ticks of LOOP rounds of a loop that has eight instructions more than an empty one.
static uint32_t time_loop(bool filled) {
  const uint32_t start = board_ticks();
  for (unsigned i = 0; i < LOOP; i++) {
    if (filled) {
      __asm__ volatile("nop\n nop\n nop\n nop\n nop\n nop\n nop\n nop\n");
    } else {
      __asm__ volatile("");
    }
  }
  return board_ticks() - start;
}

static uint32_t ticks_per_8000;  // instructions

static uint32_t instructions(uint32_t ticks) {
  return (uint32_t)((uint64_t)ticks * 8000u / ticks_per_8000);
}

// Paints the free stack but for the last 16 words above its end, which this function may be using itself.
static void paint_stack(uintptr_t top) {
  for (volatile uint32_t *p = board_stack_low; (uintptr_t)p < top - 64; p++) {
    *p = PAINT;
  }
}

// Bytes of stack below top that were written since it was painted.
static uint32_t painted_depth(uintptr_t top) {
  const volatile uint32_t *p = board_stack_low;
  while ((uintptr_t)p < top && *p == PAINT) {
    p++;
  }
  return (uint32_t)(top - (uintptr_t)p);
}

static void field(const char *name, uint32_t value) {
  board_print(name);
  print_decimal(board_print, value);
}

static void measure(const bench_family *family) {
  uint64_t sum = 0;
  uint32_t worst = 0, rounds = 0, most_rounds = 0, stack = 0;
  bench_start();
  for (int i = 0; i < BENCH_PAIRS; i++) {
    bench_next(family);
    volatile uint32_t here = 0;
    paint_stack((uintptr_t)&here);
    const uint32_t start = board_ticks();
    const unsigned used = bench_run(family);
    const uint32_t count = instructions((board_ticks() - start) & 0xFFFFFFu);
    const uint32_t depth = painted_depth((uintptr_t)&here);
    sum += count;
    worst = count > worst ? count : worst;
    rounds += used;
    most_rounds = used > most_rounds ? used : most_rounds;
    stack = depth > stack ? depth : stack;
  }
  board_print(family->name);
  field(", mean ", (uint32_t)(sum / BENCH_PAIRS));
  field(", worst ", worst);
  field(", rounds x 100 ", rounds * 100 / BENCH_PAIRS);
  field(", most ", most_rounds);
  field(", stack ", stack);
  board_print("\n");
}

int firmware_main(void) {
  ticks_per_8000 = time_loop(true) - time_loop(false);
  for (unsigned i = 0; i < bench_family_count; i++) {
    measure(&bench_families[i]);
  }
  return 0;
}
