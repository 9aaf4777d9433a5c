// A cast or ray against the shapes of a scene.
//
// The parts are taken in the order in which the way meets their boxes, as far as the tree knows it. Each is asked, and of
// the first hits the nearest one, or all in order, are kept.
#ifndef GJK_SRC_SCENE_INQUIRY_H
#define GJK_SRC_SCENE_INQUIRY_H

#include "../scene/gjk_scene_passage.h"
#include "gjk_scene_hits.h"

#ifndef GJK_SCENE_OF_PLANE
#include "../scene/gjk_scene_travel.h"
#endif

// What is asked of each part.
typedef struct gjk_scene_inquiry {
  gjk_status (*ask)(const struct gjk_scene_inquiry *inquiry, const gjk_scene_view *v, const gjk_scene_part *part,
                    const gjk_collider *on, gjk_cast_result *out);  // on: the part's
  const gjk_collider *collider;                                     // that is cast; of a ray NULL
  const gjk_vec3 *from, *to;
  gjk_q16 margin;
  const gjk_scene_filter *filter;
} gjk_scene_inquiry;

// The parts near a box that a filter may let through, found once for several casts with it.
typedef struct gjk_scene_vicinity {
  gjk_aabb box;
  uint32_t part[GJK_SCENE_NEAR];
  unsigned count;
  bool whole;  // these are all of them
} gjk_scene_vicinity;

// Fills in the parts of a vicinity whose box is set.
void gjk_scene_look_round(const gjk_scene_view *v, const gjk_scene_filter *filter, gjk_scene_vicinity *near);

// As gjk_scene_cast. If the way stays in the box of near, the tree is not walked. Pre: arguments that gjk_scene_cast
// takes; a way and a margin below 2^30.
gjk_status gjk_scene_cast_near(const gjk_scene *scene, const gjk_scene_vicinity *near, const gjk_collider *collider,
                               const gjk_vec3 *to, gjk_q16 margin, const gjk_scene_filter *filter, gjk_scene_hit *hit,
                               gjk_cast_result *result, bool *found);

// Finds the first hit in the order of (fraction, slot, part). ITERATION_LIMIT: its cast reached the ceiling; then result
// is not written.
gjk_status gjk_scene_find_first(const gjk_scene_view *v, const gjk_scene_inquiry *inquiry, gjk_scene_passage *passage,
                                gjk_scene_hit *hit, gjk_cast_result *result, bool *found);

// Collects all hits.
void gjk_scene_find_all(const gjk_scene_view *v, const gjk_scene_inquiry *inquiry, gjk_scene_passage *passage,
                        gjk_scene_hits *hits);

#endif
