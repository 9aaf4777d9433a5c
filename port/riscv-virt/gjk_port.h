// Port for QEMU's bare-metal RISC-V board.
#ifndef GJK_RISCV_VIRT_PORT_H
#define GJK_RISCV_VIRT_PORT_H

#include "../board/board.h"

#define GJK_ASSERT(condition) ((condition) ? (void)0 : board_assert_failed(#condition))

#endif
