// The queries of ground that a scene asks, which the class brings along, so that only programs that mention it link them.
#ifndef GJK2_SRC_GROUND_QUERIES_H
#define GJK2_SRC_GROUND_QUERIES_H

#include "../plane/gjk2_class.h"
#include "gjk2/ground.h"

struct gjk2_ground_queries {
  // Makes a collider of the box, not yet posed. Statuses as gjk2_collider_init.
  gjk_status (*bind)(const gjk2_shape *shape, gjk2_collider *out);

  // As the query of gjk2/ground.h that each is named after; the cast is gjk2_ground_cast_ahead.
  gjk_status (*within)(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_collider *body, gjk_q16 distance,
                       bool *yes);
  gjk_status (*distance)(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_collider *body,
                         gjk2_distance_result *out, uint32_t *segment, bool *found);
  gjk_status (*contacts)(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_collider *body, gjk_q16 margin,
                         gjk2_chain_contact *out, uint16_t capacity, uint16_t *count);
  gjk_status (*cast)(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_collider *body,
                     const gjk2_cast_path *path, bool ahead, gjk2_cast_result *out, uint32_t *segment);
  gjk_status (*ray)(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_vec *from, const gjk2_vec *to,
                    gjk2_cast_result *out, uint32_t *segment);
};

// As gjk2_ground_cast. ahead: segments count alone that all of the body is in front of at the start, so that it touches
// none of them.
gjk_status gjk2_ground_cast_ahead(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_collider *body,
                                  const gjk2_cast_path *path, bool ahead, gjk2_cast_result *out, uint32_t *segment);

#endif
