// Powers of 2 by constants.
#ifndef PROVE_CHECKER_SCALES_H
#define PROVE_CHECKER_SCALES_H

#include "space.h"

/*@ lemma scale_8: scale(8) == 0x100;
    lemma scale_16: scale(16) == 0x10000;
    lemma scale_29: scale(29) == 0x20000000;
    lemma scale_33: scale(33) == 0x200000000; */

#endif
