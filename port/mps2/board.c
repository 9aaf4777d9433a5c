// Start-up, semihosting and counter of a Cortex-M board under QEMU.
#include "board.h"

#define SYSTICK_CONTROL (*(volatile uint32_t *)0xE000E010)
#define SYSTICK_RELOAD (*(volatile uint32_t *)0xE000E014)
#define SYSTICK_CURRENT (*(volatile uint32_t *)0xE000E018)

#define SEMIHOSTING_WRITE0 0x04
#define SEMIHOSTING_EXIT_EXTENDED 0x20

void board_reset(void);

extern uint32_t board_data_load[], board_data_start[], board_data_end[], board_bss_start[], board_bss_end[];

static int32_t semihosting(uint32_t operation, const void *argument) {
  register uint32_t r0 __asm__("r0") = operation;
  register const void *r1 __asm__("r1") = argument;
  __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return (int32_t)r0;
}

void board_print(const char *text) {
  semihosting(SEMIHOSTING_WRITE0, text);
}

static void stop(uint32_t status) {
  const uint32_t application_exit[2] = {0x20026, status};
  semihosting(SEMIHOSTING_EXIT_EXTENDED, application_exit);
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
  return 0xFFFFFFu - SYSTICK_CURRENT;
}

void board_reset(void) {
  const uint32_t *from = board_data_load;
  for (uint32_t *to = board_data_start; to != board_data_end; to++, from++) {
    *(volatile uint32_t *)to = *from;
  }
  for (uint32_t *to = board_bss_start; to != board_bss_end; to++) {
    *(volatile uint32_t *)to = 0;
  }
  SYSTICK_RELOAD = 0xFFFFFF;
  SYSTICK_CURRENT = 0;
  SYSTICK_CONTROL = 5;
  stop((uint32_t)firmware_main());
}

static void fault(void) {
  board_print("fault\n");
  stop(4);
}

__attribute__((section(".vectors"), used)) static const void *const vectors[16] = {
    board_stack_high, (const void *)board_reset, (const void *)fault, (const void *)fault, (const void *)fault,
    (const void *)fault, (const void *)fault};
