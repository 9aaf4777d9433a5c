// Names under which worlds (world.h) and sessions (session.h) are compiled for the plane.
#ifndef PLANE_NAMES_H
#define PLANE_NAMES_H

// What the names below must not change is included first.
#include "gjk/cast.h"
#include "gjk/gjk.h"
#include "gjk/impact.h"
#include "gjk/scene.h"
#include "gjk2/gjk2.h"
#include "src/plane_scene/gjk2_scene_names.h"

#define gjk_contacts gjk2_contacts
#define gjk_signed_distance gjk2_signed_distance
#define gjk_scene_contacts gjk2_scene_contacts
#define gjk_scene_depth gjk2_scene_depth
#define gjk_scene_manifold gjk2_scene_manifold
#define gjk_quat_compose gjk2_rotation_compose
#define gjk_quat_normalize gjk2_rotation_normalize
#undef GJK_POSE_IDENTITY
#define GJK_POSE_IDENTITY GJK2_POSE_IDENTITY

#define world_body plane_world_body
#define world_list plane_world_list
#define world_options plane_world_options
#define world_tally plane_world_tally
#define world_expected plane_world_expected
#define world_shapes plane_world_shapes
#define world_manifolds plane_world_manifolds
#define world_cells plane_world_cells
#define world_is_tight plane_world_is_tight
#define world_config plane_world_config
#define world_start plane_world_start
#define world_bindings plane_world_bindings
#define world_change plane_world_change
#define world_random_setup plane_world_random_setup
#define world_add_at plane_world_add_at
#define world_expect plane_world_expect
#define world_sort plane_world_sort
#define world_write_words plane_world_write_words
#define world_same plane_world_same
#define world_predicate plane_world_predicate
#define session_start plane_session_start
#define session_end plane_session_end
#define session_options plane_session_options
#define session_update plane_session_update
#define session_change plane_session_change
#define session_keep plane_session_keep
#define session_move plane_session_move

#endif
