// AVR under simavr: an 8-bit core with 16-bit int, for tests. Text goes to the serial port, which simavr shows.
#include "../mps2/board.h"

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

void board_assert_failed(const char *condition) {
  board_print(condition);
  board_print("\n");
  cli();
  sleep_cpu();
}

int main(void) {
  UCSR0B = _BV(TXEN0);
  const int status = firmware_main();
  board_print(status == 0 ? "exit 0\n" : "exit 1\n");
  // Sleeping for good: simavr stops.
  cli();
  sleep_enable();
  sleep_cpu();
  return status;
}
