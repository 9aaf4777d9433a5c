// Start-up, serial output and counter of QEMU's RISC-V board; its face is that of the Cortex-M boards.
#include "../mps2/board.h"

#define UART_DATA (*(volatile uint8_t *)0x10000000)
#define TEST_FINISHER (*(volatile uint32_t *)0x100000)

extern uint32_t board_bss_start[], board_bss_end[];

void board_print(const char *text) {
  for (; *text != '\0'; text++) {
    UART_DATA = (uint8_t)*text;
  }
}

static void stop(uint32_t status) {
  TEST_FINISHER = status == 0 ? 0x5555u : (status << 16) | 0x3333u;
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
  __asm__ volatile(".insn i 0x73, 2, %0, x0, -1278" : "=r"(count));  // csrr of minstret, for any assembler
  return count;
}

__attribute__((used)) static void reset(void) {
  for (uint32_t *to = board_bss_start; to != board_bss_end; to++) {
    *(volatile uint32_t *)to = 0;
  }
  stop((uint32_t)firmware_main());
}

__attribute__((section(".start"), naked, used)) void board_start(void) {
  __asm__ volatile("la sp, board_stack_high\n  j reset\n");
}
