// Bodies of many parts as parts of a scene: what their class brings along, so that only programs that mention the class
// link it.
#ifndef GJK_SRC_SCENE_CONCAVE_H
#define GJK_SRC_SCENE_CONCAVE_H

#include "gjk/cast.h"
#include "gjk/concave.h"
#include "gjk/impact.h"

// A part where it is asked.
typedef struct gjk_scene_solid {
  const gjk_collider *collider;  // posed. Of a concave part its box, whose shape and radius alone are read
  const gjk_pose *pose;          // of a concave part; otherwise not read
} gjk_scene_solid;

// The queries of a pair, at least one of which is concave. Answers are of a, then of b.
struct gjk_scene_concave {
  // Makes a collider of the box, not yet posed. Statuses as gjk_collider_init.
  gjk_status (*bind)(const gjk_shape *shape, gjk_collider *out);

  // As gjk_within. The certificate is of the parts.
  gjk_status (*within)(const gjk_scene_solid *a, const gjk_scene_solid *b, gjk_q16 distance, gjk_decision *out);

  // As gjk_signed_distance, for distance and lower alone; NULL for the workspace: as gjk_distance.
  gjk_status (*distance)(const gjk_scene_solid *a, const gjk_scene_solid *b, const gjk_workspace *workspace,
                         gjk_distance_result *out);

  // As gjk_scene_manifolds.
  gjk_status (*manifolds)(const gjk_scene_solid *a, const gjk_scene_solid *b, gjk_q16 margin, unsigned most,
                          const gjk_workspace *workspace, gjk_manifold *out, unsigned capacity, unsigned *count);

  // Where two first touch on their way, in any order: hit, inside and fraction, and hit, overlap and lower are set. ahead:
  // only parts count that the other one is in front of at the start. Two concave ones then meet nothing,
  // in an impact too. For an impact ahead holds the whole ways, of which the motions are a piece. NULL: every part counts.
  gjk_status (*way)(const gjk_scene_solid *a, const gjk_scene_solid *b, const gjk_cast_path *path, bool ahead,
                    gjk_cast_result *out);
  gjk_status (*impact)(const gjk_collider c[2], const gjk_motion motion[2], gjk_q16 margin, const gjk_motion *ahead,
                       gjk_impact_result *out);

  // As gjk_cast, and gjk_cast_ray: a is concave, b is not.
  gjk_status (*cast)(const gjk_scene_solid *a, const gjk_scene_solid *b, const gjk_cast_path *path,
                     gjk_cast_result *out);
  gjk_status (*ray)(const gjk_scene_solid *a, const gjk_vec3 *from, const gjk_vec3 *to, gjk_cast_result *out);
};

#endif
