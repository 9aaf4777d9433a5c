// What gjk/parts.h answers about two parts of a game, without a scene.
#include "scene/concave_solid.h"

#include <string.h>

#include "check.h"

void solid_set(const game *m, const game_scene *s, uint32_t slot, uint16_t part, concave_solid *out) {
  const game_body *b = &m->body[slot];
  const gjk_body_id id = s->id[slot];
  out->shape = b->parts[part].shape;
  out->many = game_is_concave(out->shape);
  out->margin = b->setup.margin;
  CHECK(gjk_scene_parts(&s->scene, id, part, &out->parts) == (out->many ? GJK_OK : GJK_ERROR_UNSUPPORTED));
  CHECK(gjk_scene_collider(&s->scene, id, part, &out->collider) == (out->many ? GJK_ERROR_UNSUPPORTED : GJK_OK));
}

bool solid_order(const concave_solid **a, const concave_solid **b) {
  const concave_solid *first = *a, *second = *b;
  const bool turned =
      second->many && (!first->many || gjk_parts_count(&first->parts) < gjk_parts_count(&second->parts));
  *a = turned ? second : first;
  *b = turned ? first : second;
  return turned;
}

gjk_status solid_within(const concave_solid *a, const concave_solid *b, gjk_decision *out) {
  const gjk_q16 margin = a->margin + b->margin;
  solid_order(&a, &b);
  return b->many ? gjk_parts_both_within(&a->parts, &b->parts, margin, NULL, out)
                 : gjk_parts_within(&a->parts, &b->collider, margin, NULL, out);
}

gjk_status solid_distance(const concave_solid *a, const concave_solid *b, gjk_distance_result *out) {
  solid_order(&a, &b);
  return b->many ? gjk_parts_both_distance(&a->parts, &b->parts, NULL, out)
                 : gjk_parts_distance(&a->parts, &b->collider, NULL, out);
}

gjk_status solid_depth(const concave_solid *a, const concave_solid *b, const gjk_workspace *workspace,
                       gjk_penetration_result *out) {
  solid_order(&a, &b);
  return b->many ? gjk_parts_both_penetration(&a->parts, &b->parts, workspace, NULL, out)
                 : gjk_parts_penetration(&a->parts, &b->collider, workspace, NULL, out);
}

static void turn_round(gjk_manifold *m) {
  const uint16_t feature = m->feature_a;
  m->feature_a = m->feature_b;
  m->feature_b = feature;
  m->normal = (gjk_unit3){-m->normal.x, -m->normal.y, -m->normal.z};
  for (unsigned i = 0; i < m->count; i++) {
    const gjk_vec3 point = m->contact[i].point_a;
    m->contact[i].point_a = m->contact[i].point_b;
    m->contact[i].point_b = point;
  }
}

gjk_status solid_manifolds(const concave_solid *a, const concave_solid *b, const gjk_workspace *workspace,
                           gjk_manifold out[GJK_PARTS_MANIFOLDS_MAX], unsigned *count) {
  const gjk_q16 margin = a->margin + b->margin;
  const bool turned = solid_order(&a, &b);
  *count = 0;
  const gjk_status status =
      b->many
          ? gjk_parts_both_manifolds(&a->parts, &b->parts, margin, 4, workspace, out, GJK_PARTS_MANIFOLDS_MAX, count)
          : gjk_parts_manifolds(&a->parts, &b->collider, margin, 4, workspace, out, GJK_PARTS_MANIFOLDS_MAX, count);
  for (unsigned i = 0; i < *count && turned; i++) {
    turn_round(&out[i]);
  }
  return status;
}

// A convex part at a pose of its own.
static void pose_convex(const game *m, concave_solid *solid, const gjk_pose *pose) {
  CHECK(gjk_collider_init(&solid->collider, m->shapes[solid->shape], NULL, 0) == GJK_OK);
  CHECK(gjk_collider_pose(&solid->collider, pose) == GJK_OK);
}

static void pose_solid(const game *m, concave_solid *solid, const gjk_pose *body, const gjk_part *part) {
  gjk_pose pose = *body;
  CHECK(!part->own_pose || gjk_pose_compose(body, &part->pose, &pose) == GJK_OK);
  solid->parts.pose = pose;
  if (!solid->many) {
    pose_convex(m, solid, &pose);
  }
}

void traveller_set(const game *m, const game_scene *s, uint32_t slot, uint16_t part, const gjk_pose *from,
                   concave_traveller *out) {
  const gjk_part *p = &m->body[slot].parts[part];
  const gjk_pose *to = &m->body[slot].setup.pose;
  const bool turns = memcmp(&from->rotation, &to->rotation, sizeof from->rotation) != 0;
  solid_set(m, s, slot, part, &out->at);
  out->moves = turns || memcmp(&from->position, &to->position, sizeof from->position) != 0;
  out->turns = turns && (p->own_pose || m->shapes[p->shape]->type != &gjk_class_point);
  out->arcs = turns && p->own_pose;
  out->motion = (gjk_motion){*from, *to, {0, 0, 0}};
  if (p->own_pose) {
    CHECK(gjk_pose_compose(from, &p->pose, &out->motion.from) == GJK_OK);
    CHECK(gjk_pose_compose(to, &p->pose, &out->motion.to) == GJK_OK);
  }
  pose_solid(m, &out->at, from, p);
}

static gjk_status cast_travellers(const concave_traveller *p, const concave_traveller *q, bool ahead,
                                  gjk_cast_result *out) {
  const gjk_cast_path path = {p->moves ? &p->motion.to.position : NULL, q->moves ? &q->motion.to.position : NULL, 0};
  if (!p->at.many) {
    return gjk_cast(&p->at.collider, &q->at.collider, &path, out);
  }
  if (q->at.many) {
    return ahead ? GJK_OK : gjk_parts_both_cast(&p->at.parts, &q->at.parts, &path, NULL, out);
  }
  return ahead ? gjk_parts_cast_ahead(&p->at.parts, &q->at.collider, &path, NULL, out)
               : gjk_parts_cast(&p->at.parts, &q->at.collider, &path, NULL, out);
}

static gjk_status turn_travellers(const concave_traveller *p, const concave_traveller *q, bool ahead,
                                  gjk_impact_result *out) {
  // Those of a scene: the first that is enough.
  static const gjk_q16 tolerances[2][4] = {{GJK_PARTS_TOLERANCE_MIN, 48, 96, 144},
                                           {GJK_PARTS_BOTH_TOLERANCE_MIN, 64, 160, 576}};
  gjk_status status = GJK_ERROR_RANGE;
  if (!p->at.many) {
    const gjk_impact_setup setup = {0, GJK_IMPACT_TOLERANCE_MIN, 0};
    return gjk_time_of_impact(&p->at.collider, &p->motion, &q->at.collider, &q->motion, &setup, out);
  }
  if (q->at.many && ahead) {
    return GJK_OK;
  }
  for (unsigned i = 0; i < 4 && status == GJK_ERROR_RANGE; i++) {
    const gjk_impact_setup setup = {0, tolerances[q->at.many][i], 0};
    if (q->at.many) {
      status = gjk_parts_both_time_of_impact(&p->at.parts, &p->motion, &q->at.parts, &q->motion, &setup, NULL, out);
    } else if (ahead) {
      status = gjk_parts_impact_ahead(&p->at.parts, &p->motion, &q->at.collider, &q->motion, &setup, NULL, out);
    } else {
      status = gjk_parts_time_of_impact(&p->at.parts, &p->motion, &q->at.collider, &q->motion, &setup, NULL, out);
    }
  }
  return status;
}

gjk_status traveller_meet(const concave_traveller *a, const concave_traveller *b, bool ahead, concave_meeting *out) {
  const concave_solid *first = &a->at, *second = &b->at;
  const bool turned = solid_order(&first, &second);
  const concave_traveller *p = turned ? b : a, *q = turned ? a : b;
  gjk_cast_result cast;
  gjk_impact_result impact;
  gjk_status status;
  cast.hit = impact.hit = false;
  if (a->turns || b->turns) {
    status = turn_travellers(p, q, ahead, &impact);
    out->hit = impact.hit;
    out->fraction = impact.hit ? impact.lower : 0;
    out->at_start = impact.hit && impact.lower == 0;
  } else {
    status = cast_travellers(p, q, ahead, &cast);
    out->hit = cast.hit;
    out->fraction = cast.hit ? cast.fraction : 0;
    out->at_start = cast.hit && cast.inside;
  }
  return status;
}

bool traveller_together(const game *m, const concave_traveller *a, const gjk_motion *of_a, uint32_t slot_a,
                        uint16_t part_a, const concave_traveller *b, const gjk_motion *of_b, uint32_t slot_b,
                        uint16_t part_b, gjk_q30 fraction) {
  concave_solid p = a->at, q = b->at;
  const concave_solid *first = &p, *second = &q;
  gjk_pose at;
  gjk_decision decision;
  CHECK(gjk_motion_pose(of_a, fraction, &at) == GJK_OK);
  pose_solid(m, &p, &at, &m->body[slot_a].parts[part_a]);
  CHECK(gjk_motion_pose(of_b, fraction, &at) == GJK_OK);
  pose_solid(m, &q, &at, &m->body[slot_b].parts[part_b]);
  p.margin = q.margin = 0;
  solid_order(&first, &second);
  const gjk_status status =
      first->many ? solid_within(first, second, &decision) : gjk_intersect(&p.collider, &q.collider, NULL, &decision);
  return status == GJK_OK && decision.yes;
}
