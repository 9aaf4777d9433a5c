// Ground as a part of a scene: its class, which is that of a box until its queries are asked, and those for a pair in any order.
#include "gjk2/ground.h"

#include "../arith/gjk_memory.h"
#include "../arith/gjk_root.h"
#include "../plane/gjk2_facing.h"
#include "../plane/gjk2_line.h"
#include "gjk2_scene_names.h"
// What a scene asks, and the view of a block, under the plane's names.
#include "../ground/gjk2_ground_queries.h"
#include "../scene/gjk_scene_part.h"
#include "../scene/gjk_scene_solid.h"
#include "gjk2_scene_ground.h"

static const gjk2_ground *ground_of_shape(const gjk2_shape *shape) {
  return (const gjk2_ground *)shape->user;
}

// Colliders are bound by a scene alone, for the box: see gjk2_ground_bind.
static gjk_status refuse_ground(const gjk2_shape *shape, gjk2_extent *out) {
  (void)shape;
  (void)out;
  return GJK_ERROR_UNSUPPORTED;
}

// Keeps the rotation, as curved shapes do.
static void pose_ground(gjk2_collider *c, const gjk2_vec *rotation) {
  const gjk2_vec none = {0, 0};
  gjk2_copy(&c->frame[0], rotation);
  gjk2_copy(&c->frame[1], &none);
  gjk2_copy(&c->frame[2], &none);
}

// How far the box reaches along an axis of the world. Its half extents are whole, and posed vertices within 1 LSB.
//   |rotation| <= 2^30, |size| <= 2^28:  products <= 2^58
static int32_t box_reach(int32_t along, int32_t across, const gjk2_vec *size) {
  const int64_t reach =
      gjk_mac32(gjk_mul32((int32_t)gjk_magnitude32(along), size->x), (int32_t)gjk_magnitude32(across), size->y);
  return (int32_t)gjk_sar64(reach + (INT64_C(1) << 30) - 1, 30) + 1;
}

// A corner of the box in the world's axes, for bounds alone.
static void support_ground(const gjk2_collider *c, const gjk2_vec *d, gjk2_support *out) {
  const gjk2_vec *turn = &c->frame[0], *size = &c->shape->size;
  const int32_t x = box_reach(turn->x, turn->y, size), y = box_reach(turn->y, turn->x, size);
  out->offset.x = d->x < 0 ? -x : x;
  out->offset.y = d->y < 0 ? -y : y;
  out->vertex = 0;
}

// By how much more than the box's corner its posed vertices may be away from the centre, see box_reach; and 1 for the root.
#define GROUND_SLACK 3

// What gjk2_collider_init does for other shapes.
static gjk_status bind_ground(const gjk2_shape *shape, gjk2_collider *out) {
  const gjk2_ground *ground = ground_of_shape(shape);
  const gjk2_vec *half = &shape->size;
  const uint64_t room = (uint64_t)GJK2_RADIUS_MAX * (uint64_t)GJK2_RADIUS_MAX;
  if (GJK_SHAPES <= GJK_SHAPES_POINTS) {
    return GJK_ERROR_UNSUPPORTED;
  }
  if (ground == NULL || ground->type == NULL || ground->data == NULL) {
    return GJK_ERROR_NULL;
  }
  if (half->x < 0 || half->y < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  const uint64_t squared = (uint64_t)gjk_mac32(gjk_mul32(half->x, half->x), half->y, half->y);  // < 2^63
  if (squared > room) {
    return GJK_ERROR_SIZE;
  }
  out->shape = shape;
  out->buffer = NULL;
  gjk2_copy(&out->local_centre, &ground->centre);
  out->core_radius = (gjk_q16)gjk_isqrt64(squared) + GROUND_SLACK;
  out->radius = out->core_radius;
  out->count = 0;
  out->ordered = false;
  out->state = GJK2_STATE_INITIALISED;
  return GJK_OK;
}

static const gjk2_ground *ground_of_collider(const gjk2_collider *c) {
  return ground_of_shape(c->shape);
}

// A pair of ground and a body.
typedef struct ground_pair {
  const gjk2_ground *ground;
  const gjk2_collider *body;
  bool turned;  // the ground is the second of the two
} ground_pair;

// False: both are ground.
static bool set_ground_pair(const gjk2_collider *a, const gjk2_collider *b, ground_pair *out) {
  out->turned = !gjk2_scene_is_concave(a->shape);
  out->body = out->turned ? a : b;
  out->ground = ground_of_collider(out->turned ? b : a);
  return !gjk2_scene_is_concave(out->body->shape);
}

// The same, and where the ground is.
static bool place_ground_pair(const gjk2_scene_view *v, const gjk2_scene_part *a, const gjk2_scene_part *b,
                              const gjk2_collider *on_a, const gjk2_collider *on_b, ground_pair *out, gjk2_pose *pose) {
  const bool is_pair = set_ground_pair(on_a, on_b, out);
  if (is_pair) {
    gjk2_scene_part_pose(v, out->turned ? b : a, pose);
  }
  return is_pair;
}

static gjk_status ground_is_within(const gjk2_scene_view *v, const gjk2_scene_part *a, const gjk2_scene_part *b,
                                   const gjk2_collider *on_a, const gjk2_collider *on_b, gjk_q16 distance,
                                   gjk2_decision *out) {
  ground_pair p;
  gjk2_pose pose;
  out->yes = false;
  out->certificate.proof = GJK2_PROOF_NONE;  // its vertices would be those of a segment
  out->certificate.count = 0;
  return place_ground_pair(v, a, b, on_a, on_b, &p, &pose)
             ? gjk2_ground_within(p.ground, &pose, p.body, distance, &out->yes)
             : GJK_OK;
}

// The least distance of a contact, where the body overlaps. False: it does not, or has no contact.
static gjk_status depth_of_ground(const ground_pair *p, const gjk2_pose *pose, gjk2_distance_result *out, bool *found) {
  gjk2_chain_contact deepest;
  uint16_t count = 0;
  const gjk_status status = gjk2_ground_contacts(p->ground, pose, p->body, 0, &deepest, 1, &count);
  *found = (status == GJK_OK || status == GJK_ERROR_CAPACITY) && count > 0;
  if (*found) {
    out->distance = gjk2_line_least(&deepest.manifold);
    out->lower = out->distance;
    out->intersecting = true;
  }
  return status == GJK_ERROR_CAPACITY ? GJK_OK : status;
}

static gjk_status distance_of_ground(const gjk2_scene_view *v, const gjk2_scene_part *a, const gjk2_scene_part *b,
                                     const gjk2_collider *on_a, const gjk2_collider *on_b, bool depth,
                                     gjk2_distance_result *out) {
  ground_pair p;
  gjk2_pose pose;
  uint32_t segment;
  bool found = false;
  if (!place_ground_pair(v, a, b, on_a, on_b, &p, &pose)) {
    return GJK_ERROR_UNSUPPORTED;  // not reached: two grounds make no pair
  }
  gjk_status status = depth ? depth_of_ground(&p, &pose, out, &found) : GJK_OK;
  if (status == GJK_OK && found) {
    return status;
  }
  if (status == GJK_OK) {
    status = gjk2_ground_distance(p.ground, &pose, p.body, out, &segment, &found);
  }
  if (status != GJK_OK) {
    out->lower = depth ? -(on_a->radius + on_b->radius) : 0;
  } else if (!found) {
    out->distance = out->lower = GJK2_DISTANCE_MAX;
    out->intersecting = false;
  }
  return status;
}

static gjk_status cast_at_ground(const gjk2_scene_view *v, const gjk2_scene_part *a, const gjk2_collider *on_a,
                                 const gjk2_collider *b, const gjk2_cast_path *path, gjk2_cast_result *out) {
  gjk2_pose pose;
  uint32_t segment;
  gjk2_scene_part_pose(v, a, &pose);
  return gjk2_ground_cast_ahead(ground_of_collider(on_a), &pose, b, path, false, out, &segment);
}

static gjk_status ray_at_ground(const gjk2_scene_view *v, const gjk2_scene_part *a, const gjk2_collider *on_a,
                                const gjk2_vec *from, const gjk2_vec *to, gjk2_cast_result *out) {
  gjk2_pose pose;
  uint32_t segment;
  gjk2_scene_part_pose(v, a, &pose);
  return gjk2_ground_cast_ray(ground_of_collider(on_a), &pose, from, to, out, &segment);
}

static gjk_status way_to_ground(const gjk2_collider c[2], const gjk2_pose pose[2], const gjk2_cast_path *path,
                                bool ahead, gjk2_cast_result *out) {
  ground_pair p;
  gjk2_vec to;
  uint32_t segment;
  out->hit = false;
  if (!set_ground_pair(&c[0], &c[1], &p)) {
    return GJK_OK;
  }
  // The way of the ground's pose is that of its collider, which is at the middle of its box.
  const gjk2_vec *of_ground = p.turned ? path->to_b : path->to_a;
  if (of_ground != NULL) {
    gjk2_vec way;
    gjk2_scene_way(&c[p.turned ? 1 : 0].position, of_ground, &way);
    to = pose[p.turned ? 1 : 0].position;
    gjk2_scene_shift(&to, &way);
  }
  const gjk2_cast_path turned = {of_ground != NULL ? &to : NULL, p.turned ? path->to_a : path->to_b, path->margin};
  return gjk2_ground_cast_ahead(p.ground, &pose[p.turned ? 1 : 0], p.body, &turned, ahead, out, &segment);
}

// Turns a manifold of ground and body round.
static void turn_ground_manifold(gjk2_manifold *m) {
  const uint16_t of_a = m->feature_a;
  m->feature_a = m->feature_b;
  m->feature_b = of_a;
  m->normal.x = -m->normal.x;
  m->normal.y = -m->normal.y;
  for (unsigned i = 0; i < m->count; i++) {
    gjk2_contact *c = &m->contact[i];
    const gjk2_vec point = c->point_a;
    gjk2_copy(&c->point_a, &c->point_b);
    gjk2_copy(&c->point_b, &point);
    c->id = (uint16_t)((c->id & 255u) << 8 | c->id >> 8);
  }
}

static void clear_ground_manifold(gjk2_manifold *out) {
  out->count = 0;
  out->feature_a = out->feature_b = 0;
  gjk2_scene_no_normal(out);
}

static gjk_status manifold_of_ground(const gjk2_scene_view *v, const gjk2_scene_part *a, const gjk2_scene_part *b,
                                     const gjk2_collider *on_a, const gjk2_collider *on_b, gjk_q16 margin,
                                     unsigned most, gjk2_manifold *out) {
  ground_pair p;
  gjk2_pose pose;
  gjk2_chain_contact deepest;
  uint16_t count = 0;
  if (most < 1 || most > GJK2_CONTACTS_MAX) {
    return GJK_ERROR_RANGE;
  }
  if (!place_ground_pair(v, a, b, on_a, on_b, &p, &pose)) {
    clear_ground_manifold(out);
    return GJK_OK;
  }
  const gjk_q16 apart = margin < GJK2_RADIUS_MAX ? margin : GJK2_RADIUS_MAX;
  const gjk_status status = gjk2_ground_contacts(p.ground, &pose, p.body, apart, &deepest, 1, &count);
  if (status != GJK_OK && status != GJK_ERROR_CAPACITY) {
    return status;
  }
  clear_ground_manifold(out);
  if (count > 0) {
    deepest.manifold.feature_a = (uint16_t)(deepest.segment & UINT16_MAX);
    gjk2_facing_limit(&deepest.manifold, most);
    if (p.turned) {
      turn_ground_manifold(&deepest.manifold);
    }
    gjk_copy(out, &deepest.manifold, sizeof *out);
  }
  return GJK_OK;
}

static const struct gjk2_ground_queries ground_queries = {
    .bind = bind_ground,
    .within = ground_is_within,
    .distance = distance_of_ground,
    .manifold = manifold_of_ground,
    .cast = cast_at_ground,
    .ray = ray_at_ground,
    .way = way_to_ground,
    .impact = gjk2_scene_ground_impact,
};

const gjk2_shape_class gjk2_class_ground = {
    .measure = refuse_ground,
    .pose = pose_ground,
    .support = support_ground,
    .vertex = NULL,
    .adjacent = NULL,
    .depth = NULL,
    .touch = NULL,
    .ground = &ground_queries,
    .buffered = false,
    .count = 0,
};

gjk_status gjk2_scene_ground(const gjk2_scene *scene, gjk_body_id id, uint16_t part, const gjk2_ground **out,
                             gjk2_pose *pose) {
  gjk2_scene_view v;
  const gjk2_scene_part *p;
  gjk_status status = out == NULL || pose == NULL ? GJK_ERROR_NULL : gjk2_scene_view_of(scene, &v);
  status = status == GJK_OK ? gjk2_scene_find_part(&v, id, part, &p) : status;
  if (status != GJK_OK) {
    return status;
  }
  const gjk2_shape *shape = scene->shapes[p->shape];
  if (!gjk2_scene_is_concave(shape)) {
    return GJK_ERROR_UNSUPPORTED;
  }
  *out = (const gjk2_ground *)shape->user;
  gjk2_scene_part_pose(&v, p, pose);
  return GJK_OK;
}

gjk_status gjk2_scene_ground_contacts(const gjk2_scene *scene, const gjk2_report *report, gjk2_chain_contact *out,
                                      uint16_t capacity, uint16_t *count) {
  gjk2_scene_view v;
  const gjk2_scene_part *part[2];
  gjk2_collider on[2];
  ground_pair p;
  gjk2_pose pose;
  gjk_status status = report == NULL || out == NULL || count == NULL ? GJK_ERROR_NULL : gjk2_scene_view_of(scene, &v);
  status = status == GJK_OK ? gjk2_scene_find_part(&v, report->a, report->part_a, &part[0]) : status;
  status = status == GJK_OK ? gjk2_scene_find_part(&v, report->b, report->part_b, &part[1]) : status;
  if (status != GJK_OK) {
    return status;
  }
  gjk2_scene_part_placed(&v, part[0], &on[0]);
  gjk2_scene_part_placed(&v, part[1], &on[1]);
  if (!(gjk2_scene_is_concave(on[0].shape) || gjk2_scene_is_concave(on[1].shape)) ||
      !place_ground_pair(&v, part[0], part[1], &on[0], &on[1], &p, &pose)) {
    return GJK_ERROR_UNSUPPORTED;
  }
  const gjk_q16 margin = v.bodies[part[0]->body].margin + v.bodies[part[1]->body].margin;
  return gjk2_ground_contacts(p.ground, &pose, p.body, margin < GJK2_RADIUS_MAX ? margin : GJK2_RADIUS_MAX, out,
                              capacity, count);
}
