// What gjk/parts.h answers about two parts of a game, without a scene.
#ifndef CONCAVE_SOLID_H
#define CONCAVE_SOLID_H

#include "scene/concave_game.h"

typedef struct concave_solid {
  bool many;  // parts, else collider
  gjk_parts parts;
  gjk_collider collider;
  uint16_t shape;
  gjk_q16 margin;
} concave_solid;

// A part as a scene says that it stands.
void solid_set(const game *m, const game_scene *s, uint32_t slot, uint16_t part, concave_solid *out);

// Puts two in the order in which they are asked: A is concave, and of two concave ones has more parts. Whether it turned them.
bool solid_order(const concave_solid **a, const concave_solid **b);

// Queries of two, in the order of a scene. One at least is concave, but for casts and impacts.
gjk_status solid_within(const concave_solid *a, const concave_solid *b, gjk_decision *out);
gjk_status solid_distance(const concave_solid *a, const concave_solid *b, gjk_distance_result *out);
gjk_status solid_depth(const concave_solid *a, const concave_solid *b, const gjk_workspace *workspace,
                       gjk_penetration_result *out);
gjk_status solid_manifolds(const concave_solid *a, const concave_solid *b, const gjk_workspace *workspace,
                           gjk_manifold out[GJK_PARTS_MANIFOLDS_MAX], unsigned *count);

// One part on its way.
typedef struct concave_traveller {
  concave_solid at;   // where it is at the start
  gjk_motion motion;  // of the part
  bool moves, turns;  // of its body, and of the part
  bool arcs;          // it turns about a point that is not its own
} concave_traveller;

// A part on the way of its body.
void traveller_set(const game *m, const game_scene *s, uint32_t slot, uint16_t part, const gjk_pose *from,
                   concave_traveller *out);

// Where two first meet, where neither runs along an arc.
typedef struct concave_meeting {
  bool hit, at_start;
  gjk_q30 fraction;
} concave_meeting;

// ahead: parts alone that were in front at the start.
gjk_status traveller_meet(const concave_traveller *a, const concave_traveller *b, bool ahead, concave_meeting *out);

// Do two share a point at a fraction of the ways of their bodies?
bool traveller_together(const game *m, const concave_traveller *a, const gjk_motion *of_a, uint32_t slot_a,
                        uint16_t part_a, const concave_traveller *b, const gjk_motion *of_b, uint32_t slot_b,
                        uint16_t part_b, gjk_q30 fraction);

#endif
