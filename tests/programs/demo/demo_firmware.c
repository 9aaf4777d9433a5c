// Firmware: answers the demo's scene again on an emulated core.
#include "../../measure/target/count.h"
#include "demo_scene.h"

static uint32_t calibration;

static uint32_t instructions(void) {
  return count_instructions(board_ticks(), calibration);
}

int firmware_main(void) {
  calibration = count_calibrate();
  if (calibration == 0) {
    board_print("the counter does not count instructions\n");
    return 1;
  }
  return demo_firmware(board_print, instructions) == 0 ? 0 : 1;
}
