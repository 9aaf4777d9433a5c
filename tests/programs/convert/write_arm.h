// What gjk-convert writes of machines.
#ifndef WRITE_ARM_H
#define WRITE_ARM_H

#include "machine.h"

// A line: links=L values=V parts=P vertices=N never=K, K pairs of links.
void write_arm_info(const machine *m);

// Constants for flash: a gjk_arm_model and all that it points to.
void write_arm_source(const machine *m, const char *name);

// A machine for gjk-query --arm, to which obstacles and edges are to be added.
void write_arm_case(const machine *m);

#endif
