// The cast against ground that scenes ask.
#ifndef GJK2_SRC_GROUND_QUERIES_H
#define GJK2_SRC_GROUND_QUERIES_H

#include "../plane/gjk2_class.h"
#include "gjk2/ground.h"

// As gjk2_ground_cast. ahead: only segments count that the whole body is in front of at the start, so it touches none
// of them.
gjk_status gjk2_ground_cast_ahead(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_collider *body,
                                  const gjk2_cast_path *path, bool ahead, gjk2_cast_result *out, uint32_t *segment);

#endif
