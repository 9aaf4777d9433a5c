// Port for an AVR under simavr: an 8-bit core with 16-bit int.
#ifndef GJK_AVR_PORT_H
#define GJK_AVR_PORT_H

#include "../board/board.h"

#define GJK_ASSERT(condition) ((condition) ? (void)0 : board_assert_failed(#condition))

// It multiplies 8 bits; four products of 16 bits are the better way to 64.
#ifndef GJK_NARROW_MULTIPLY
#define GJK_NARROW_MULTIPLY 1
#endif

#endif
