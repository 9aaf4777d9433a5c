// Runs of scenes with an int of 16 bits include this first: their drivers ask for intervals of 32 bits.
#ifndef PROVE_WIDE_ANY_H
#define PROVE_WIDE_ANY_H

#include "__fc_builtin.h"

#define Frama_C_unsigned_int_interval Frama_C_unsigned_long_interval

#endif
