// Reads cases of the plane; the format is in parse.h.
#ifndef CASE_PARSE2_H
#define CASE_PARSE2_H

#include "parse.h"

// Reads a case whose first line is in text. False: it is malformed, and was named.
bool case2_read(case_reader *reader, case2_pair *pair);

#endif
