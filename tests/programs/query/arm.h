// gjk-query --arm: edges of a machine that a file describes.
#ifndef ARM_H
#define ARM_H

#include <stdbool.h>
#include <stdio.h>

// What came of a file.
typedef struct arm_tally {
  unsigned long verdicts[3];  // by certify_verdict
  bool bad_input;
} arm_tally;

// Answers the edges of a file, one line each. name: for messages. certify: checks each by its certificate. A line that is
// not understood ends the file.
void arm_run(FILE *file, const char *name, bool certify, arm_tally *tally);

#endif
