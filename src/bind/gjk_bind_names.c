// Sizes of structures and values of constants, by name, for other languages.
#include "gjk/bind.h"
#include "gjk/draw.h"
#include "gjk/gjk.h"
#include "gjk/probe.h"
#include "gjk/slide.h"
#include "gjk2/draw.h"
#include "gjk2/gjk2.h"
#include "gjk2/probe.h"
#include "gjk2/slide.h"

typedef struct named_value {
  const char *name;
  int64_t value;
} named_value;

#define SIZE_OF(structure) \
  { #structure, (int64_t)sizeof(structure) }
#define VALUE_OF(constant) \
  { #constant, (int64_t)(constant) }

static const named_value structure_sizes[] = {
    SIZE_OF(gjk_body_id),
    SIZE_OF(gjk_progress),
    SIZE_OF(gjk_scene_stats),
    SIZE_OF(gjk_scene_hit),
    SIZE_OF(gjk_scene_filter),
    SIZE_OF(gjk_draw),
    SIZE_OF(gjk2_draw),
    SIZE_OF(gjk_cache),
    SIZE_OF(gjk_cast_path),
    SIZE_OF(gjk_cast_certificate),
    SIZE_OF(gjk_cast_result),
    SIZE_OF(gjk_certificate),
    SIZE_OF(gjk_aabb),
    SIZE_OF(gjk_collider),
    SIZE_OF(gjk_compound_part),
    SIZE_OF(gjk_compound_node),
    SIZE_OF(gjk_compound),
    SIZE_OF(gjk_contact),
    SIZE_OF(gjk_manifold),
    SIZE_OF(gjk_distance_result),
    SIZE_OF(gjk_effort),
    SIZE_OF(gjk_joint),
    SIZE_OF(gjk2_joint),
    SIZE_OF(gjk_vec3),
    SIZE_OF(gjk_unit3),
    SIZE_OF(gjk_quat),
    SIZE_OF(gjk_pose),
    SIZE_OF(gjk_height_field),
    SIZE_OF(gjk_hull),
    SIZE_OF(gjk_hull_volume),
    SIZE_OF(gjk_hull_simple),
    SIZE_OF(gjk_hull_report),
    SIZE_OF(gjk_motion),
    SIZE_OF(gjk_impact_setup),
    SIZE_OF(gjk_impact_result),
    SIZE_OF(gjk_decision),
    SIZE_OF(gjk_within_result),
    SIZE_OF(gjk_volume),
    SIZE_OF(gjk_inertia),
    SIZE_OF(gjk_mass),
    SIZE_OF(gjk_principal),
    SIZE_OF(gjk_mesh_triangle),
    SIZE_OF(gjk_mesh_node),
    SIZE_OF(gjk_mesh),
    SIZE_OF(gjk_mesh_report),
    SIZE_OF(gjk_parts),
    SIZE_OF(gjk_parts_room),
    SIZE_OF(gjk_parts_manifold),
    SIZE_OF(gjk_parts_pair),
    SIZE_OF(gjk_epa_vertex),
    SIZE_OF(gjk_epa_face),
    SIZE_OF(gjk_epa_horizon),
    SIZE_OF(gjk_epa_cell),
    SIZE_OF(gjk_workspace),
    SIZE_OF(gjk_penetration_result),
    SIZE_OF(gjk_part),
    SIZE_OF(gjk_body_setup),
    SIZE_OF(gjk_scene_config),
    SIZE_OF(gjk_scene_bindings),
    SIZE_OF(gjk_scene),
    SIZE_OF(gjk_body_state),
    SIZE_OF(gjk_report),
    SIZE_OF(gjk_hull_faces),
    SIZE_OF(gjk_hull_table),
    SIZE_OF(gjk_shape),
    SIZE_OF(gjk_slide_setup),
    SIZE_OF(gjk_slide_plane),
    SIZE_OF(gjk_slide_result),
    SIZE_OF(gjk_surface_contact),
    SIZE_OF(gjk2_cache),
    SIZE_OF(gjk2_cast_path),
    SIZE_OF(gjk2_cast_certificate),
    SIZE_OF(gjk2_cast_result),
    SIZE_OF(gjk2_certificate),
    SIZE_OF(gjk2_chain),
    SIZE_OF(gjk2_chain_range),
    SIZE_OF(gjk2_chain_contact),
    SIZE_OF(gjk2_aabb),
    SIZE_OF(gjk2_collider),
    SIZE_OF(gjk2_contact),
    SIZE_OF(gjk2_manifold),
    SIZE_OF(gjk2_distance_result),
    SIZE_OF(gjk2_effort),
    SIZE_OF(gjk2_vec),
    SIZE_OF(gjk2_unit),
    SIZE_OF(gjk2_rotation),
    SIZE_OF(gjk2_pose),
    SIZE_OF(gjk2_hull),
    SIZE_OF(gjk2_hull_report),
    SIZE_OF(gjk2_motion),
    SIZE_OF(gjk2_impact_setup),
    SIZE_OF(gjk2_impact_result),
    SIZE_OF(gjk2_decision),
    SIZE_OF(gjk2_within_result),
    SIZE_OF(gjk2_mass),
    SIZE_OF(gjk2_penetration_result),
    SIZE_OF(gjk2_part),
    SIZE_OF(gjk2_body_setup),
    SIZE_OF(gjk2_scene_config),
    SIZE_OF(gjk2_scene_bindings),
    SIZE_OF(gjk2_scene),
    SIZE_OF(gjk2_body_state),
    SIZE_OF(gjk2_report),
    SIZE_OF(gjk2_shape),
    SIZE_OF(gjk2_slide_setup),
    SIZE_OF(gjk2_slide_plane),
    SIZE_OF(gjk2_slide_result),
};

static const named_value constant_values[] = {
    VALUE_OF(GJK_JOINTS_MAX),
    VALUE_OF(GJK2_JOINTS_MAX),
    VALUE_OF(GJK_BODY_STATIC),
    VALUE_OF(GJK_BODY_KINEMATIC),
    VALUE_OF(GJK_BODY_DYNAMIC),
    VALUE_OF(GJK_DETAIL_TOUCH),
    VALUE_OF(GJK_DETAIL_DISTANCE),
    VALUE_OF(GJK_DETAIL_DEPTH),
    VALUE_OF(GJK_DETAIL_CONTACTS),
    VALUE_OF(GJK_DETAIL_SENSOR),
    VALUE_OF(GJK_DRAW_STATIC),
    VALUE_OF(GJK_DRAW_MOVING),
    VALUE_OF(GJK_DRAW_ASLEEP),
    VALUE_OF(GJK_DRAW_SENSOR),
    VALUE_OF(GJK_DRAW_BOX),
    VALUE_OF(GJK_DRAW_PAIR),
    VALUE_OF(GJK_DRAW_CONTACT),
    VALUE_OF(GJK_DRAW_NORMAL),
    VALUE_OF(GJK_DRAW_WAY),
    VALUE_OF(GJK_DRAW_SHAPES),
    VALUE_OF(GJK_DRAW_BOXES),
    VALUE_OF(GJK_DRAW_PAIRS),
    VALUE_OF(GJK_DRAW_DIRECTIONS),
    VALUE_OF(GJK_EVENT_BEGIN),
    VALUE_OF(GJK_EVENT_PERSIST),
    VALUE_OF(GJK_EVENT_END),
    VALUE_OF(GJK_EVENT_IMPACT),
    VALUE_OF(GJK_MOTION_NOT_KEPT),
    VALUE_OF(GJK_MOTION_KEPT),
    VALUE_OF(GJK_MOTION_FAST),
    VALUE_OF(GJK_SCENE_BODIES_MAX),
    VALUE_OF(GJK_SCENE_PAIRS_MAX),
    VALUE_OF(GJK_SCENE_PAIR_WORDS_MAX),
    VALUE_OF(GJK_SLIDE_PLANES),
    VALUE_OF(GJK_SLIDE_SKIN_MIN),
    VALUE_OF(GJK_SLIDE_CASTS),
    VALUE_OF(GJK_CAST_PROOF_NONE),
    VALUE_OF(GJK_CAST_PROOF_SPHERES),
    VALUE_OF(GJK_CAST_PROOF_BESIDE),
    VALUE_OF(GJK_CAST_PROOF_SHORT),
    VALUE_OF(GJK_CAST_PROOF_INSIDE),
    VALUE_OF(GJK_CAST_PROOF_FACET),
    VALUE_OF(GJK_CAST_PROOF_SWEPT),
    VALUE_OF(GJK_PROOF_NONE),
    VALUE_OF(GJK_PROOF_SPHERES),
    VALUE_OF(GJK_PROOF_DIRECTION),
    VALUE_OF(GJK_PROOF_NEAREST),
    VALUE_OF(GJK_PROOF_NEAR),
    VALUE_OF(GJK_PROOF_ENCLOSING),
    VALUE_OF(GJK_PROOF_FACET),
    VALUE_OF(GJK_PROOF_PLANE),
    VALUE_OF(GJK_COMPOUND_PARTS_MAX),
    VALUE_OF(GJK_COMPOUND_LIST_MAX),
    VALUE_OF(GJK_CONTACTS_MAX),
    VALUE_OF(GJK_DISTANCE_MAX),
    VALUE_OF(GJK_Q16_ONE),
    VALUE_OF(GJK_Q30_ONE),
    VALUE_OF(GJK_RADIUS_MAX),
    VALUE_OF(GJK_HULL_VERTICES_MAX),
    VALUE_OF(GJK_FACE_CORNERS_MAX),
    VALUE_OF(GJK_TABLE_LEVEL_MAX),
    VALUE_OF(GJK_ITERATIONS_MAX),
    VALUE_OF(GJK_HASH_BEGIN),
    VALUE_OF(GJK_HEIGHT_FIELD_SIDE_MAX),
    VALUE_OF(GJK_HEIGHT_FIELD_STEP_MAX),
    VALUE_OF(GJK_HEIGHT_HOLE),
    VALUE_OF(GJK_HULL_SOUND),
    VALUE_OF(GJK_HULL_FEW),
    VALUE_OF(GJK_HULL_NUMBER),
    VALUE_OF(GJK_HULL_BENT),
    VALUE_OF(GJK_HULL_TURN),
    VALUE_OF(GJK_HULL_BEYOND),
    VALUE_OF(GJK_HULL_OPEN),
    VALUE_OF(GJK_HULL_DOUBLED),
    VALUE_OF(GJK_HULL_LAYERS),
    VALUE_OF(GJK_HULL_POINTS_MAX),
    VALUE_OF(GJK_HULL_SIMPLE_MIN),
    VALUE_OF(GJK_IMPACT_TOLERANCE_MIN),
    VALUE_OF(GJK_IMPACT_MARGIN_MAX),
    VALUE_OF(GJK_ANSWER_NO),
    VALUE_OF(GJK_ANSWER_YES),
    VALUE_OF(GJK_ANSWER_OPEN),
    VALUE_OF(GJK_MESH_CONCAVE),
    VALUE_OF(GJK_MESH_FLAT),
    VALUE_OF(GJK_MESH_CONVEX),
    VALUE_OF(GJK_MESH_OPEN),
    VALUE_OF(GJK_MESH_SOUND),
    VALUE_OF(GJK_MESH_NUMBER_FAULT),
    VALUE_OF(GJK_MESH_COORDINATE),
    VALUE_OF(GJK_MESH_SIZE),
    VALUE_OF(GJK_MESH_SHIFT),
    VALUE_OF(GJK_MESH_BOX),
    VALUE_OF(GJK_MESH_EDGES),
    VALUE_OF(GJK_MESH_DEGENERATE),
    VALUE_OF(GJK_MESH_CROWDED),
    VALUE_OF(GJK_MESH_TURNED),
    VALUE_OF(GJK_MESH_TRIANGLES_MAX),
    VALUE_OF(GJK_MESH_VERTICES_MAX),
    VALUE_OF(GJK_MESH_COORDINATE_MAX),
    VALUE_OF(GJK_MESH_LEAF),
    VALUE_OF(GJK_PARTS_NONE),
    VALUE_OF(GJK_PARTS_TOLERANCE_MIN),
    VALUE_OF(GJK_EPA_CURVED_ITERATIONS_MAX),
    VALUE_OF(GJK_EPA_CURVED_CELLS),
    VALUE_OF(GJK_ROTATION_TOLERANCE),
    VALUE_OF(GJK_SCENE_BLOCK_VERSION),
    VALUE_OF(GJK_OK),
    VALUE_OF(GJK_ERROR_NULL),
    VALUE_OF(GJK_ERROR_SIZE),
    VALUE_OF(GJK_ERROR_NEGATIVE),
    VALUE_OF(GJK_ERROR_EMPTY),
    VALUE_OF(GJK_ERROR_CAPACITY),
    VALUE_OF(GJK_ERROR_OVERLAP),
    VALUE_OF(GJK_ERROR_ROTATION),
    VALUE_OF(GJK_ERROR_RANGE),
    VALUE_OF(GJK_ERROR_UNINITIALISED),
    VALUE_OF(GJK_ERROR_ITERATION_LIMIT),
    VALUE_OF(GJK_ERROR_UNPROVEN),
    VALUE_OF(GJK_ERROR_UNSUPPORTED),
    VALUE_OF(GJK_ERROR_BODY_ID),
    VALUE_OF(GJK_ERROR_BUSY),
    VALUE_OF(GJK_ERROR_CORRUPT),
    VALUE_OF(GJK_VERSION_MAJOR),
    VALUE_OF(GJK_VERSION_MINOR),
    VALUE_OF(GJK_VERSION_PATCH),
    VALUE_OF(GJK_BITS_VERSION),
    VALUE_OF(GJK2_CAST_PROOF_NONE),
    VALUE_OF(GJK2_CAST_PROOF_SPHERES),
    VALUE_OF(GJK2_CAST_PROOF_BESIDE),
    VALUE_OF(GJK2_CAST_PROOF_SHORT),
    VALUE_OF(GJK2_CAST_PROOF_INSIDE),
    VALUE_OF(GJK2_CAST_PROOF_FACET),
    VALUE_OF(GJK2_PROOF_NONE),
    VALUE_OF(GJK2_PROOF_CIRCLES),
    VALUE_OF(GJK2_PROOF_DIRECTION),
    VALUE_OF(GJK2_PROOF_NEAREST),
    VALUE_OF(GJK2_PROOF_NEAR),
    VALUE_OF(GJK2_PROOF_ENCLOSING),
    VALUE_OF(GJK2_PROOF_EDGE),
    VALUE_OF(GJK2_PROOF_LINE),
    VALUE_OF(GJK2_CONTACTS_MAX),
    VALUE_OF(GJK2_DISTANCE_MAX),
    VALUE_OF(GJK2_RADIUS_MAX),
    VALUE_OF(GJK2_POLYGON_VERTICES_MAX),
    VALUE_OF(GJK2_HULL_SOUND),
    VALUE_OF(GJK2_HULL_FEW),
    VALUE_OF(GJK2_HULL_REPEATED),
    VALUE_OF(GJK2_HULL_STRAIGHT),
    VALUE_OF(GJK2_HULL_TURN),
    VALUE_OF(GJK2_HULL_LAYERS),
    VALUE_OF(GJK2_IMPACT_TOLERANCE_MIN),
    VALUE_OF(GJK2_ANSWER_NO),
    VALUE_OF(GJK2_ANSWER_YES),
    VALUE_OF(GJK2_ANSWER_OPEN),
    VALUE_OF(GJK2_DEPTH_ITERATIONS_MAX),
    VALUE_OF(GJK2_ROTATION_TOLERANCE),
    VALUE_OF(GJK2_SCENE_BLOCK_VERSION),
};

// The loop ends with the name of the table at the latest, since no name holds a zero within.
static bool is_named(const named_value *entry, const char *name) {
  size_t i = 0;
  while (entry->name[i] != '\0' && entry->name[i] == name[i]) {
    i++;
  }
  return entry->name[i] == name[i];
}

// NULL: there is none of this name.
static const named_value *find_named(const named_value *table, size_t count, const char *name) {
  for (size_t i = 0; i < count; i++) {
    if (is_named(&table[i], name)) {
      return &table[i];
    }
  }
  return NULL;
}

size_t gjk_size_of(const char *structure) {
  if (structure == NULL) {
    return 0;
  }
  const named_value *found = find_named(structure_sizes, sizeof structure_sizes / sizeof structure_sizes[0], structure);
  return found != NULL ? (size_t)found->value : 0;
}

gjk_status gjk_constant(const char *name, int64_t *out) {
  if (name == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  const named_value *found = find_named(constant_values, sizeof constant_values / sizeof constant_values[0], name);
  if (found == NULL) {
    return GJK_ERROR_RANGE;
  }
  *out = found->value;
  return GJK_OK;
}
