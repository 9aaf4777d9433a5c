// Which part is within a distance of B.
#ifndef GJK_SRC_PARTS_NEAR_H
#define GJK_SRC_PARTS_NEAR_H

#include "gjk_parts_class.h"

// The part with the least number within a distance of B, or GJK_PARTS_NONE; out is set where there is one. Statuses as
// gjk_parts_within. Pre: what is within the distance meets the region.
gjk_status gjk_parts_near(const gjk_parts_frame *frame, const gjk_region *region, const gjk_collider *b,
                          gjk_q16 distance, uint32_t *part, gjk_decision *out);

// Writes the answer of the part, or no if none was found.
void gjk_parts_report_near(uint32_t found, const gjk_decision *of_part, gjk_decision *out);

#endif
