// Port for an AVR under simavr: an 8-bit core with 16-bit int.
#ifndef GJK_AVR_PORT_H
#define GJK_AVR_PORT_H

#include "../board/board.h"

#define GJK_ASSERT(condition) ((condition) ? (void)0 : board_assert_failed(#condition))

#endif
