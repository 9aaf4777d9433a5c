// Firmware: answers the demo's scene again on an emulated core.
#include "../../measure/target/count.h"
#include "demo_scene.h"

static uint32_t instructions(void) {
  return count_since(0);
}

int firmware_main(void) {
  return count_prepare() && demo_firmware(board_print, instructions) == 0 ? 0 : 1;
}
