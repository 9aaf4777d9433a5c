// Bodies of many parts as parts of a scene: their class, which is that of a box until its queries are asked.
#include "gjk_scene_concave.h"

#include "../arith/gjk_memory.h"
#include "../parts/gjk_parts_ahead.h"
#include "gjk_scene_part.h"

static const gjk_concave *concave_of(const gjk_shape *shape) {
  return (const gjk_concave *)shape->user;
}

// The half extents and the middle of a box.
static gjk_status measure_box(const gjk_shape *shape, gjk_extent *out) {
  const gjk_vec3 *half = &shape->size;
  if (half->x < 0 || half->y < 0 || half->z < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  if (half->x > GJK_RADIUS_MAX || half->y > GJK_RADIUS_MAX || half->z > GJK_RADIUS_MAX) {
    return GJK_ERROR_SIZE;
  }
  out->centre = concave_of(shape)->centre;
  out->squared = (uint64_t)gjk_dot(half, half);  // < 3 2^56
  return GJK_OK;
}

static gjk_status refuse_shape(const gjk_shape *shape, gjk_extent *out) {
  (void)shape;
  (void)out;
  return GJK_ERROR_UNSUPPORTED;
}

// |row| <= 2^30, |size| < 2^28:  the product < 2^58
GJK_ONE_COPY static int32_t turned_half(int32_t row, gjk_q16 size) {
  return (int32_t)gjk_sar64(gjk_mul32(row, size) + (INT64_C(1) << 29), 30);
}

// The half axes of the box, as those of a box.
static void pose_concave(gjk_collider *c, const gjk_vec3 rows[3]) {
  const gjk_vec3 *size = &c->shape->size;
  const gjk_vec3 x = {turned_half(rows[0].x, size->x), turned_half(rows[1].x, size->x),
                      turned_half(rows[2].x, size->x)};
  const gjk_vec3 y = {turned_half(rows[0].y, size->y), turned_half(rows[1].y, size->y),
                      turned_half(rows[2].y, size->y)};
  const gjk_vec3 z = {turned_half(rows[0].z, size->z), turned_half(rows[1].z, size->z),
                      turned_half(rows[2].z, size->z)};
  c->frame[0] = x;
  c->frame[1] = y;
  c->frame[2] = z;
}

// The corner of the box, for its bounds.
static void support_concave(const gjk_collider *c, const gjk_vec3 *d, gjk_support *out) {
  gjk_vec3 at = {0, 0, 0};
  for (unsigned i = 0; i < 3; i++) {
    at = gjk_dot(&c->frame[i], d) < 0 ? gjk_sub(at, c->frame[i]) : gjk_add(at, c->frame[i]);
  }
  out->offset = at;
  out->vertex = 0;
}

// Never called: a query is asked of the parts. That there is one tells that skips by the box do not answer.
static bool stalls_concave(const gjk_vec3 *d, const gjk_vec3 *from, const gjk_vec3 *to, int shift, bool late) {
  (void)d, (void)from, (void)to, (void)shift;
  return late;
}

#define CONCAVE_CLASS(measure_parts, queries_of_parts)                                                            \
  {                                                                                                               \
    .measure = (measure_parts), .pose = pose_concave, .support = support_concave, .refine = NULL, .vertex = NULL, \
    .stalls = stalls_concave, .close = NULL, .concave = (queries_of_parts), .buffered = false, .count = 3,        \
    .kind = GJK_KIND_AXES,                                                                                        \
  }

// What gjk_collider_init measures for gjk_concave_bind, where the public class refuses.
static const gjk_shape_class class_of_box = CONCAVE_CLASS(measure_box, NULL);

// A constant may name no body, or one without parts.
static gjk_status bind_concave(const gjk_shape *shape, gjk_collider *out) {
  gjk_shape box;
  if (shape->user == NULL) {
    return GJK_ERROR_NULL;
  }
  if (gjk_parts_count(&concave_of(shape)->parts) == 0) {
    return GJK_ERROR_EMPTY;
  }
  gjk_copy(&box, shape, sizeof box);
  box.type = &class_of_box;
  const gjk_status status = gjk_collider_init(out, &box, NULL, 0);
  out->shape = shape;
  return status;
}

// A body of many parts where a solid is.
static void set_parts(const gjk_scene_solid *solid, gjk_parts *out) {
  const gjk_parts *unturned = &concave_of(solid->collider->shape)->parts;
  out->type = unturned->type;
  out->data = unturned->data;
  gjk_copy(&out->pose, solid->pose, sizeof out->pose);
}

static bool is_solid_concave(const gjk_scene_solid *solid) {
  return gjk_scene_is_concave(solid->collider->shape);
}

// Two solids in the order in which the queries of gjk/parts.h take them: A is concave; where both are, B is the one with
// fewer parts.
typedef struct ordered_pair {
  gjk_parts a, b;
  const gjk_collider *convex;  // B; NULL: both are concave
  bool turned;                 // A is the second of the two
} ordered_pair;

static void order_pair(const gjk_scene_solid *a, const gjk_scene_solid *b, ordered_pair *out) {
  out->turned = !is_solid_concave(a);
  out->convex = NULL;
  if (out->turned || !is_solid_concave(b)) {
    set_parts(out->turned ? b : a, &out->a);
    out->convex = out->turned ? a->collider : b->collider;
    return;
  }
  set_parts(a, &out->a);
  set_parts(b, &out->b);
  if (gjk_parts_count(&out->a) < gjk_parts_count(&out->b)) {
    out->turned = true;
    set_parts(b, &out->a);
    set_parts(a, &out->b);
  }
}

static gjk_status concave_within(const gjk_scene_solid *a, const gjk_scene_solid *b, gjk_q16 distance,
                                 gjk_decision *out) {
  ordered_pair p;
  order_pair(a, b, &p);
  return p.convex != NULL ? gjk_parts_within(&p.a, p.convex, distance, NULL, out)
                          : gjk_parts_both_within(&p.a, &p.b, distance, NULL, out);
}

// Minus the depth of the deepest part, if one overlaps. Sets *found then.
static gjk_status concave_depth(const ordered_pair *p, const gjk_workspace *workspace, gjk_distance_result *out,
                                bool *found) {
  gjk_penetration_result deepest;
  deepest.intersecting = false;
  const gjk_status status = p->convex != NULL ? gjk_parts_penetration(&p->a, p->convex, workspace, NULL, &deepest)
                                              : gjk_parts_both_penetration(&p->a, &p->b, workspace, NULL, &deepest);
  *found = (status == GJK_OK || status == GJK_ERROR_CAPACITY) && deepest.intersecting;
  if (*found) {
    out->distance = -deepest.depth;
    out->intersecting = true;
  }
  return status;
}

static gjk_status concave_distance(const gjk_scene_solid *a, const gjk_scene_solid *b, const gjk_workspace *workspace,
                                   gjk_distance_result *out) {
  ordered_pair p;
  gjk_status of_depth = GJK_OK;
  order_pair(a, b, &p);
  if (workspace != NULL) {
    bool found;
    of_depth = concave_depth(&p, workspace, out, &found);
    if (found) {
      return of_depth;
    }
  }
  const gjk_status status =
      p.convex != NULL ? gjk_parts_distance(&p.a, p.convex, NULL, out) : gjk_parts_both_distance(&p.a, &p.b, NULL, out);
  // A depth that was not found is no distance of 0. It is at most as large as spheres around both have room for.
  if (of_depth == GJK_ERROR_ITERATION_LIMIT && (status == GJK_OK ? out->intersecting : out->lower <= 0)) {
    out->lower = -(a->collider->radius + b->collider->radius);  // each at most 2^28 + 4
    return of_depth;
  }
  return status;
}

// Turns a manifold round: of B, then of A.
static void turn_manifold(gjk_manifold *m) {
  const uint16_t of_a = m->feature_a;
  m->feature_a = m->feature_b;
  m->feature_b = of_a;
  m->normal.x = -m->normal.x;
  m->normal.y = -m->normal.y;
  m->normal.z = -m->normal.z;
  for (unsigned i = 0; i < m->count; i++) {
    gjk_contact *c = &m->contact[i];
    const gjk_vec3 point = c->point_a;
    c->point_a = c->point_b;
    c->point_b = point;
  }
}

static gjk_status find_manifolds(const ordered_pair *p, gjk_q16 margin, unsigned most, const gjk_workspace *workspace,
                                 gjk_manifold *out, unsigned capacity, unsigned *count) {
  return p->convex != NULL ? gjk_parts_manifolds(&p->a, p->convex, margin, most, workspace, out, capacity, count)
                           : gjk_parts_both_manifolds(&p->a, &p->b, margin, most, workspace, out, capacity, count);
}

// However few are wanted, as many compete: a manifold that is left out for want of room loses its contacts, also where it
// would be the deepest in the end. So what is found does not depend on the room there is.
static gjk_status concave_manifolds(const gjk_scene_solid *a, const gjk_scene_solid *b, gjk_q16 margin, unsigned most,
                                    const gjk_workspace *workspace, gjk_manifold *out, unsigned capacity,
                                    unsigned *count) {
  ordered_pair p;
  gjk_manifold competing[GJK_PARTS_MANIFOLDS_MAX];
  unsigned found = 0;
  order_pair(a, b, &p);
  const gjk_q16 apart = margin < GJK_RADIUS_MAX ? margin : GJK_RADIUS_MAX;
  const gjk_status status = find_manifolds(&p, apart, most, workspace, competing, GJK_PARTS_MANIFOLDS_MAX, &found);
  if (status != GJK_OK && status != GJK_ERROR_CAPACITY) {
    return status;
  }
  *count = found < capacity ? found : capacity;
  for (unsigned i = 0; i < *count; i++) {
    if (p.turned) {
      turn_manifold(&competing[i]);
    }
    gjk_copy(&out[i], &competing[i], sizeof out[i]);
  }
  return status;
}

static gjk_status concave_way(const gjk_scene_solid *a, const gjk_scene_solid *b, const gjk_cast_path *path, bool ahead,
                              gjk_cast_result *out) {
  ordered_pair p;
  order_pair(a, b, &p);
  const gjk_cast_path of = {p.turned ? path->to_b : path->to_a, p.turned ? path->to_a : path->to_b, path->margin};
  out->hit = false;
  if (p.convex != NULL) {
    return ahead ? gjk_parts_cast_ahead(&p.a, p.convex, &of, NULL, out)
                 : gjk_parts_cast(&p.a, p.convex, &of, NULL, out);
  }
  return ahead ? GJK_OK : gjk_parts_both_cast(&p.a, &p.b, &of, NULL, out);
}

// The tolerances of impacts, in the order in which they are tried: the farther the parts reach, the more is needed. The last
// ones pay for parts 2^29 LSB away, and a B that reaches 2^28 LSB, or of two concave bodies 2^29 too.
#define TOLERANCES 4
static const gjk_q16 tolerances[2][TOLERANCES] = {{GJK_PARTS_TOLERANCE_MIN, 48, 96, 144},
                                                  {GJK_PARTS_BOTH_TOLERANCE_MIN, 64, 160, 576}};

static gjk_status concave_impact(const gjk_collider c[2], const gjk_motion motion[2], gjk_q16 margin,
                                 const gjk_motion *ahead, gjk_impact_result *out) {
  const gjk_scene_solid of_a = {&c[0], &motion[0].from}, of_b = {&c[1], &motion[1].from};
  ordered_pair p;
  gjk_status status = GJK_ERROR_RANGE;
  order_pair(&of_a, &of_b, &p);
  const bool both = p.convex == NULL;
  const unsigned i = p.turned ? 1 : 0, k = 1 - i;
  out->hit = false;
  if (both && ahead != NULL) {
    return GJK_OK;
  }
  for (unsigned n = 0; n < TOLERANCES && status == GJK_ERROR_RANGE; n++) {
    const gjk_impact_setup setup = {margin, tolerances[both][n], 0};
    if (both) {
      status = gjk_parts_both_time_of_impact(&p.a, &motion[i], &p.b, &motion[k], &setup, NULL, out);
    } else if (ahead != NULL) {
      status =
          gjk_parts_impact_ahead_of(&p.a, &motion[i], p.convex, &motion[k], &ahead[i], &ahead[k], &setup, NULL, out);
    } else {
      status = gjk_parts_time_of_impact(&p.a, &motion[i], p.convex, &motion[k], &setup, NULL, out);
    }
  }
  return status;
}

static gjk_status concave_cast(const gjk_scene_solid *a, const gjk_scene_solid *b, const gjk_cast_path *path,
                               gjk_cast_result *out) {
  gjk_parts of_a;
  set_parts(a, &of_a);
  return gjk_parts_cast(&of_a, b->collider, path, NULL, out);
}

static gjk_status concave_ray(const gjk_scene_solid *a, const gjk_vec3 *from, const gjk_vec3 *to,
                              gjk_cast_result *out) {
  gjk_parts of_a;
  set_parts(a, &of_a);
  return gjk_parts_cast_ray(&of_a, from, to, NULL, out);
}

static const struct gjk_scene_concave queries_of_concave = {
    .bind = bind_concave,
    .within = concave_within,
    .distance = concave_distance,
    .manifolds = concave_manifolds,
    .way = concave_way,
    .impact = concave_impact,
    .cast = concave_cast,
    .ray = concave_ray,
};

const gjk_shape_class gjk_class_concave = CONCAVE_CLASS(refuse_shape, &queries_of_concave);
