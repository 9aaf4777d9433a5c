// Start-up's end, serial output and exit of an AVR under simavr, which shows what the serial port says and stops when
// the core sleeps with interrupts off.
#include "../board/board.h"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

void board_print(const char *text) {
  for (; *text != '\0'; text++) {
    while ((UCSR0A & _BV(UDRE0)) == 0) {
    }
    UDR0 = (uint8_t)*text;
  }
}

// There is no exit status: the runner reads the last line.
static void stop(int status) {
  board_print(status == 0 ? "exit 0\n" : "exit 1\n");
  cli();
  sleep_enable();
  sleep_cpu();
}

void board_assert_failed(const char *condition) {
  board_print("contract violated: ");
  board_print(condition);
  board_print("\n");
  stop(3);
}

int main(void) {
  UCSR0B = _BV(TXEN0);
  stop(firmware_main());
  return 0;
}
