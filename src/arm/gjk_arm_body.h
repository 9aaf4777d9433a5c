// What an arm asks of bodies of many parts. gjk_arm_bodies sets it, so other programs link none of it.
//
//   1. A box of the world holds the part at both ends of a span. It is grown by the gap wanted, by bend and slack. Pieces
//      outside are farther apart than that gap along an axis of the body, on the whole span.
//   2. The pieces inside, which the body's tree finds, are looked at as obstacles.
//   3. All are apart: the pair is. The first one that is not ends the search; it is asked first next time.
#ifndef GJK_SRC_ARM_BODY_H
#define GJK_SRC_ARM_BODY_H

#include "gjk_arm_span.h"

struct gjk_arm_body_class {
  // Searches the open pair with this number on the span of the arm, by at most left tests, which it counts. It reports
  // proofs. MORE: it is not done. A piece that cannot be placed sets the arm's fault.
  gjk_arm_found (*span)(gjk_arm *arm, uint32_t number, int64_t bend, uint32_t left);

  // Is a piece within a distance of the part, posed at the frames with number which? *piece: the least number of one that is.
  // ITERATION_LIMIT: none is, and *piece is the least number of an open one. Other statuses: of a body at fault.
  gjk_status (*near)(const gjk_arm *arm, const gjk_arm_pair *pair, unsigned which, int64_t distance, bool *yes,
                     uint32_t *piece);

  // The same of one piece. False: there is none, or it is at fault.
  bool (*touches)(const gjk_arm *arm, const gjk_arm_pair *pair, unsigned which, uint32_t piece, int64_t distance);

  // Takes a piece that is nearer than *nearest into out, and its distance and status.
  gjk_status (*nearest)(const gjk_arm *arm, const gjk_arm_pair *pair, int64_t *nearest, gjk_status *best,
                        gjk_arm_distance_result *out);

  // Checks the first proofs of count, as far as they belong to one pair and span; the frames are set. How many; 0: refused.
  // Sets the pair's done if they show all of its span. gap: what pieces must be apart by, at least margin.
  uint32_t (*check)(const gjk_arm *arm, const gjk_arm_proof *proofs, uint32_t count, int64_t bend, int64_t gap);
};

#endif
