// What an arm asks of bodies of many parts. gjk_arm_bodies sets it, so other programs link none of it.
//
//   1. A box in the world holds the part at both ends of a span, and grows by the wanted gap, bend and slack. Pieces
//      outside the box are farther apart than that gap along an axis of the body, on the whole span.
//   2. The body's tree finds the pieces inside. Each is tested as an obstacle.
//   3. If all are apart, so is the pair. The first piece that is not ends the search, and is tested first next time.
#ifndef GJK_SRC_ARM_BODY_H
#define GJK_SRC_ARM_BODY_H

#include "gjk_arm_span.h"

struct gjk_arm_body_class {
  // Searches the open pair with this number on the arm's span. Makes at most `left` tests, counts them, and reports
  // proofs. MORE: the search is not done. A piece that cannot be placed sets the arm's fault.
  gjk_arm_found (*span)(gjk_arm *arm, uint32_t number, int64_t bend, uint32_t left);

  // Is a piece within a distance of the part, posed at the frames with number which? *piece: the least number of such a
  // piece. ITERATION_LIMIT: there is none, and *piece is the least number of an open one. Other statuses: of a body at
  // fault.
  gjk_status (*near)(const gjk_arm *arm, const gjk_arm_pair *pair, unsigned which, int64_t distance, bool *yes,
                     uint32_t *piece);

  // The same for one piece. False also if there is no such piece, or it is at fault.
  bool (*touches)(const gjk_arm *arm, const gjk_arm_pair *pair, unsigned which, uint32_t piece, int64_t distance);

  // If a piece is nearer than *nearest, writes it to out, and its distance and status to *nearest and *best.
  gjk_status (*nearest)(const gjk_arm *arm, const gjk_arm_pair *pair, int64_t *nearest, gjk_status *best,
                        gjk_arm_distance_result *out);

  // Checks those of the first proofs that belong to one pair and span. Returns how many these are; 0: refused. Sets the
  // pair's done if they prove its whole span. gap: by how much pieces must be apart, at least margin. Pre: the frames
  // are set.
  uint32_t (*check)(const gjk_arm *arm, const gjk_arm_proof *proofs, uint32_t count, int64_t bend, int64_t gap);
};

#endif
