// Start-up, semihosting and counter of a Cortex-M board under QEMU.
#include "../board/board.h"

#define SYSTICK_CONTROL (*(volatile uint32_t *)0xE000E010)
#define SYSTICK_RELOAD (*(volatile uint32_t *)0xE000E014)
#define SYSTICK_CURRENT (*(volatile uint32_t *)0xE000E018)

#define COPROCESSOR_ACCESS (*(volatile uint32_t *)0xE000ED88)
#define COPROCESSOR_FPU (UINT32_C(15) << 20)

#define SYSTICK_PERIOD (UINT32_C(1) << 24)
#define SYSTICK_RUN 5u                       // on, from the processor's clock
#define SYSTICK_WRAPPED (UINT32_C(1) << 16)  // since the last look at SYSTICK_CONTROL

#define SEMIHOSTING_WRITE0 0x04
#define SEMIHOSTING_EXIT_EXTENDED 0x20
#define SEMIHOSTING_APPLICATION_EXIT 0x20026

void board_reset(void);

extern uint32_t board_data_load[], board_data_start[], board_data_end[], board_bss_start[], board_bss_end[];

static void semihosting(uint32_t operation, const void *argument) {
  register uint32_t r0 __asm__("r0") = operation;
  register const void *r1 __asm__("r1") = argument;
  __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

void board_print(const char *text) {
  semihosting(SEMIHOSTING_WRITE0, text);
}

static void stop(uint32_t status) {
  const uint32_t exit_block[2] = {SEMIHOSTING_APPLICATION_EXIT, status};
  semihosting(SEMIHOSTING_EXIT_EXTENDED, exit_block);
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
  static uint32_t wraps;
  uint32_t current = SYSTICK_CURRENT;
  if ((SYSTICK_CONTROL & SYSTICK_WRAPPED) != 0) {
    wraps++;
    current = SYSTICK_CURRENT;  // the first reading may be from before
  }
  return wraps * SYSTICK_PERIOD + (SYSTICK_PERIOD - 1 - current);
}

void board_reset(void) {
#ifdef BOARD_FPU  // firmware that uses floating point, which the library does not
  COPROCESSOR_ACCESS |= COPROCESSOR_FPU;
  __asm__ volatile("dsb\n isb\n" ::: "memory");
#endif
  const uint32_t *from = board_data_load;
  for (volatile uint32_t *to = board_data_start; to != board_data_end; to++, from++) {
    *to = *from;
  }
  for (volatile uint32_t *to = board_bss_start; to != board_bss_end; to++) {
    *to = 0;
  }
  SYSTICK_RELOAD = SYSTICK_PERIOD - 1;
  SYSTICK_CURRENT = 0;
  SYSTICK_CONTROL = SYSTICK_RUN;
  stop((uint32_t)firmware_main());
}

static void fault(void) {
  board_print("fault\n");
  stop(4);
}

typedef struct vector_table {
  uint32_t *stack;
  void (*reset)(void);
  void (*exceptions[14])(void);
} vector_table;

__attribute__((section(".vectors"), used)) static const vector_table vectors = {
    board_stack_high, board_reset, {fault, fault, fault, fault, fault}};
