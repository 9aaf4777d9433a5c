// Start-up, serial output and counter of QEMU's RISC-V board.
#include "../board/board.h"

#define UART_DATA (*(volatile uint8_t *)0x10000000)
#define TEST_FINISHER (*(volatile uint32_t *)0x100000)
#define FINISHER_PASS 0x5555u
#define FINISHER_FAIL 0x3333u

extern uint32_t board_bss_start[], board_bss_end[];

void board_reset(void);
void board_start(void);

void board_print(const char *text) {
  for (; *text != '\0'; text++) {
    UART_DATA = (uint8_t)*text;
  }
}

static void stop(uint32_t status) {
  TEST_FINISHER = status == 0 ? FINISHER_PASS : (status << 16) | FINISHER_FAIL;
  for (;;) {
  }
}

void board_assert_failed(const char *condition) {
  board_print("contract violated: ");
  board_print(condition);
  board_print("\n");
  stop(3);
}

uint32_t board_ticks(void) {
  uint32_t count;
  __asm__ volatile(".option push\n .option arch, +zicsr\n csrr %0, minstret\n .option pop\n" : "=r"(count));
  return count;
}

void board_reset(void) {
  for (volatile uint32_t *to = board_bss_start; to != board_bss_end; to++) {
    *to = 0;
  }
  stop((uint32_t)firmware_main());
}

__attribute__((section(".start"), naked, used)) void board_start(void) {
  __asm__ volatile("la sp, board_stack_high\n  j board_reset\n");
}
