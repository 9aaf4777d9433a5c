// Random bodies of many parts: compounds, with their tree and without.
#ifndef GENERATE_BODY_H
#define GENERATE_BODY_H

#include "case/case.h"
#include "random.h"

#define GENERATE_BODY_PARTS 200

typedef enum generate_layout {
  GENERATE_SCATTERED,  // polytopes of all kinds and sizes, anywhere in a cube
  GENERATE_CURVED,     // the same, half of them curved
  GENERATE_ROW,        // equal crates in a row, which share their faces
  GENERATE_PILE,       // all parts at one place: every box meets
  GENERATE_LAYOUTS
} generate_layout;

typedef struct generate_body {
  uint64_t seed;
  generate_layout layout;
  uint16_t count;
  case_shape source[GENERATE_BODY_PARTS];
  case_collider part[GENERATE_BODY_PARTS];  // holds the shapes
  gjk_compound_part parts[GENERATE_BODY_PARTS];
  gjk_compound_node nodes[2 * GENERATE_BODY_PARTS], list[GENERATE_BODY_PARTS];
  gjk_compound with_tree, without;  // without: a list of boxes, whatever the number of parts
  gjk_parts tree, flat;             // bodies of both, at one pose
} generate_body;

// Makes the body that seed stands for, of count parts within about spread LSB of its position. body: zeroed before its first
// use; its memory is used again.
void generate_body_make(generate_layout layout, uint64_t seed, uint16_t count, gjk_q16 spread, const gjk_vec3 *position,
                        generate_body *body);

void generate_body_free(generate_body *body);

// Makes shape a convex shape whose nearest points are likely to be within a few sizes of some part of the body.
void generate_visitor(random_state *random, const generate_body *body, gjk_q16 spread, bool curved, case_shape *shape);

// For check_trial.
void generate_body_show(const void *body);

#endif
