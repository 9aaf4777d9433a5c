// Port for the bare-metal Cortex-M boards that QEMU emulates: micro:bit, and MPS2 images AN385, AN386, AN500, AN505.
#ifndef GJK_MPS2_PORT_H
#define GJK_MPS2_PORT_H

#include "../board/board.h"

#define GJK_ASSERT(condition) ((condition) ? (void)0 : board_assert_failed(#condition))

#endif
