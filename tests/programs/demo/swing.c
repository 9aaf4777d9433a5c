// The swing of the arm: each of its bodies as a hull about the axis, so that it turns about that in one motion.
#include "swing.h"

#include <math.h>
#include <string.h>

#include "exact/exact.h"

#define VERTICES 64

static bool begins(const char *name, const char *with) {
  return strncmp(name, with, strlen(with)) == 0;
}

bool swing_moves(const scene_body *body) {
  return (begins(body->name, "arm-") && strcmp(body->name, "arm-base") != 0) || begins(body->name, "gripper-") ||
         strcmp(body->name, "part") == 0;
}

static const scene_body *find_base(const scene *s) {
  for (size_t i = 0; i < s->bodies; i++) {
    if (strcmp(s->body[i].name, "arm-base") == 0) {
      return &s->body[i];
    }
  }
  return NULL;
}

// The posed body as a hull in the frame of the pivot. False: it has no vertices, or too many.
static bool about_pivot(const scene_body *body, gjk_vec3 pivot, gjk_vec3 vertices[VERTICES], gjk_shape *out) {
  const gjk_collider *c = &body->collider.collider;
  const unsigned count = exact_vertex_count(c);
  if (count == 0 || count > VERTICES) {
    return false;
  }
  for (unsigned i = 0; i < count; i++) {
    const exact_point at = exact_vertex(c, i);
    vertices[i].x = (gjk_q16)(at.x[0] - pivot.x);
    vertices[i].y = (gjk_q16)(at.x[1] - pivot.y);
    vertices[i].z = (gjk_q16)(at.x[2] - pivot.z);
  }
  const gjk_shape hull = GJK_ROUNDED_HULL(vertices, 0, 0);
  *out = hull;
  out->count = (uint16_t)count;
  out->convex_radius = c->shape->convex_radius;
  return true;
}

// When a body of the arm hits one that stands.
static bool hits(const scene_body *arm, const scene_body *other, gjk_vec3 pivot, gjk_impact_result *out) {
  const gjk_impact_setup setup = {0, GJK_IMPACT_TOLERANCE_MIN, 0};
  gjk_motion swing = {GJK_POSE_IDENTITY, GJK_POSE_IDENTITY, {0, 0, 0}};
  const gjk_motion still = {other->shape.pose, other->shape.pose, {0, 0, 0}};
  gjk_vec3 vertices[VERTICES];
  gjk_shape hull;
  gjk_collider a;
  memset(&a, 0, sizeof a);
  swing.from.position = swing.to.position = pivot;
  swing.spin.z = (gjk_q16)lround(SWING_ANGLE * 65536);
  return about_pivot(arm, pivot, vertices, &hull) && gjk_collider_init(&a, &hull, NULL, 0) == GJK_OK &&
         gjk_time_of_impact(&a, &swing, &other->collider.collider, &still, &setup, out) == GJK_OK && out->hit &&
         out->lower > 0;
}

void swing_find(const scene *s, scene_swing *out) {
  const scene_body *base = find_base(s);
  out->found = false;
  if (base == NULL) {
    return;
  }
  const gjk_vec3 pivot = base->collider.collider.centre;
  for (size_t a = 0; a < s->bodies; a++) {
    for (size_t b = 0; b < s->bodies; b++) {
      gjk_impact_result impact;
      if (!swing_moves(&s->body[a]) || swing_moves(&s->body[b]) || &s->body[b] == base ||
          !hits(&s->body[a], &s->body[b], pivot, &impact) || (out->found && impact.lower >= out->impact.lower)) {
        continue;
      }
      out->found = true;
      out->a = a;
      out->b = b;
      out->impact = impact;
    }
  }
  if (out->found) {
    // About the pivot: forth, turn, and back.
    const gjk_pose back = {{-pivot.x, -pivot.y, -pivot.z}, {0, 0, 0, GJK_Q30_ONE}};
    (void)gjk_pose_compose(&out->impact.pose_a, &back, &out->turn);
  }
}

gjk_pose swing_pose(const scene_swing *swing, const gjk_pose *start) {
  gjk_pose pose = *start;
  (void)gjk_pose_compose(&swing->turn, start, &pose);
  return pose;
}

double swing_degrees(const scene_swing *swing) {
  return fabs(SWING_ANGLE) * (180 / 3.14159265358979) * swing->impact.lower / GJK_Q30_ONE;
}
