// A machine, obstacles and edges as a file describes them:
//
//     # comment
//     link NAME PARENT KIND    KIND: fixed | revolute | prismatic; PARENT: a link before, or base
//     L at x y z               optional, as are turn (a quaternion), axis (default 0 0 1) and limits (lower upper)
//     part LINK
//     P KIND ...               a shape on the link, as of A in a case: P at, P turn, P round
//     never LINK LINK          parts of these are never tested
//     base                     optional: B at, B turn: where the machine stands
//     obstacle NAME
//     O KIND ...               a shape in the world
//     edge ID
//     E from v ...             a value for each joint that moves
//     E to v ...
//     E margin m               optional, as is tolerance t
#ifndef ARM_FILE_H
#define ARM_FILE_H

#include "case/lines.h"
#include "gjk/arm.h"

#define ARM_PARTS 64
#define ARM_OBSTACLES 128

typedef enum arm_block { ARM_NOTHING, ARM_LINK, ARM_PART, ARM_PLACE, ARM_OBSTACLE, ARM_EDGE } arm_block;

typedef struct arm_edge {
  char id[CASE_ID_MAX];
  int32_t from[GJK_ARM_LINKS_MAX], to[GJK_ARM_LINKS_MAX];
  bool has_from, has_to;
  gjk_arm_setup setup;
} arm_edge;

typedef struct arm_file {
  case_reader reader;
  arm_block block;
  case_side side;
  gjk_arm_link links[GJK_ARM_LINKS_MAX];
  char link_names[GJK_ARM_LINKS_MAX][CASE_ID_MAX];
  gjk_arm_part parts[ARM_PARTS];
  case_shape part_shapes[ARM_PARTS], obstacle_shapes[ARM_OBSTACLES];
  char obstacle_names[ARM_OBSTACLES][CASE_ID_MAX];
  uint32_t never[GJK_ARM_LINKS_MAX];
  unsigned link_count, part_count, obstacle_count;
  gjk_pose base;
  arm_edge edge;
} arm_file;

// Starts to read. *file is zeroed first.
void arm_file_open(arm_file *file, FILE *stream, const char *name);

// Reads up to the end of the next edge. False: there is none; reader.errors tells whether the file was understood.
bool arm_file_next(arm_file *file);

void arm_file_close(arm_file *file);

#endif
