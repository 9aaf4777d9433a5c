// The help of gjk-query.
#ifndef QUERY_HELP_H
#define QUERY_HELP_H

#include <stdio.h>

void help_print(FILE *file);

#endif
