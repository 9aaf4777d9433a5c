// Casts, rays and times of impact in the plane: the source that space has, under the plane's names.
#include <string.h>

#include "case/answer.h"
#include "exact/cast2.h"
#include "exact/cast_claim.h"
#include "exact/clearance.h"
#include "motion.h"

// Tells motion.c that it is the plane's.
#define MOTION_OF_PLANE

#define CASE_POINT CASE2_POINT
#undef GJK_IMPACT_TOLERANCE_MIN
#define GJK_IMPACT_TOLERANCE_MIN GJK2_IMPACT_TOLERANCE_MIN
#define case_collider case2_collider
#define case_collider_build case2_collider_build
#define case_motion case2_motion
#define case_pair case2_pair
#define case_path case2_path
#define clearance_reach clearance2_reach
#define clearance_speed clearance2_speed
#define exact_cast exact2_cast
#define exact_cast_set exact2_cast_set
#define exact_check_cast exact2_check_cast
#define gjk_cast gjk2_cast
#define gjk_cast_path gjk2_cast_path
#define gjk_cast_ray gjk2_cast_ray
#define gjk_cast_result gjk2_cast_result
#define gjk_check_cast gjk2_check_cast
#define gjk_collider gjk2_collider
#define gjk_collider_pose gjk2_collider_pose
#define gjk_distance gjk2_distance
#define gjk_distance_result gjk2_distance_result
#define gjk_impact_result gjk2_impact_result
#define gjk_impact_setup gjk2_impact_setup
#define gjk_motion gjk2_motion
#define gjk_motion_pose gjk2_motion_pose
#define gjk_pose gjk2_pose
#define gjk_time_of_impact gjk2_time_of_impact
#define gjk_unit3 gjk2_unit
#define gjk_vec3 gjk2_vec
#define motion_answer motion2_answer
#define motion_certify motion2_certify
#define motion_find motion2_find
#define motion_print motion2_print

static void print_vector(FILE *file, const char *name, const gjk2_vec *v) {
  fprintf(file, " %s=%ld,%ld", name, (long)v->x, (long)v->y);
}

static void print_normal(FILE *file, const gjk2_unit *n) {
  fprintf(file, " normal=%ld,%ld", (long)n->x, (long)n->y);
}

#include "motion.c"
