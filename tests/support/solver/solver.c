// A small solver for rigid bodies.
#include "solver.h"

// Contact points up to this far apart, Q16.16, are used. Bodies may stay SLOP deep in each other; an eighth of more is
// undone in a tick.
#define MARGIN SOLVER_MARGIN
#define SLOP 131
#define UNDO 8

#define GRAVITY (10 * SOLVER_ONE)

// Friction holds up to 5/8 of the normal impulse.
#define FRICTION(impulse) ((impulse) / 8 * 5)

static gjk_epa_cell cells[GJK_EPA_CELLS(64)];
static const gjk_workspace workspace = {cells, sizeof cells / sizeof cells[0]};

// a * b, truncated, which takes energy out and never adds any. Pre: |a b| < 2^63.
static solver_fix mul(solver_fix a, solver_fix b) {
  return a * b / SOLVER_ONE;
}

static solver_vec vec_add(solver_vec a, solver_vec b) {
  const solver_vec sum = {a.x + b.x, a.y + b.y, a.z + b.z};
  return sum;
}

static solver_vec vec_sub(solver_vec a, solver_vec b) {
  const solver_vec difference = {a.x - b.x, a.y - b.y, a.z - b.z};
  return difference;
}

static solver_vec vec_scale(solver_fix factor, solver_vec a) {
  const solver_vec scaled = {mul(factor, a.x), mul(factor, a.y), mul(factor, a.z)};
  return scaled;
}

static solver_fix vec_dot(solver_vec a, solver_vec b) {
  return (a.x * b.x + a.y * b.y + a.z * b.z) / SOLVER_ONE;
}

static solver_vec vec_cross(solver_vec a, solver_vec b) {
  const solver_vec out = {(a.y * b.z - a.z * b.y) / SOLVER_ONE, (a.z * b.x - a.x * b.z) / SOLVER_ONE,
                          (a.x * b.y - a.y * b.x) / SOLVER_ONE};
  return out;
}

static solver_fix from_q16(int64_t a) {
  return a * (SOLVER_ONE / GJK_Q16_ONE);
}

// Rounded to the nearest.
static gjk_q16 to_q16(solver_fix a) {
  const solver_fix unit = SOLVER_ONE / GJK_Q16_ONE;
  return (gjk_q16)((a < 0 ? a - unit / 2 : a + unit / 2) / unit);
}

static solver_vec vec_from_q16(gjk_vec3 a) {
  const solver_vec out = {from_q16(a.x), from_q16(a.y), from_q16(a.z)};
  return out;
}

static solver_vec vec_from_unit(gjk_unit3 a) {
  const solver_fix unit = GJK_Q30_ONE / SOLVER_ONE;
  const solver_vec out = {a.x / unit, a.y / unit, a.z / unit};
  return out;
}

void solver_init(solver_world *w, unsigned iterations) {
  w->iterations = iterations;
  w->bodies = 0;
  w->pairs[0] = 0;
  w->pairs[1] = 0;
  w->now = 0;
  w->damping = 0;
  w->manifolds = NULL;
  w->user = NULL;
  w->points = 0;
  w->fresh = 0;
}

static solver_fix inverse(solver_fix a) {
  return a > 0 ? SOLVER_ONE * SOLVER_ONE / a : 0;
}

// The inertia of a solid box of these half extents.
static void set_mass(solver_body *b, gjk_vec3 half) {
  const solver_vec h = vec_from_q16(half);
  const solver_fix mass = 8 * mul(mul(h.x, h.y), h.z), xx = mul(h.x, h.x), yy = mul(h.y, h.y), zz = mul(h.z, h.z);
  const solver_vec third = {inverse(mul(mass, yy + zz) / 3), inverse(mul(mass, zz + xx) / 3),
                            inverse(mul(mass, xx + yy) / 3)};
  b->inverse_mass = inverse(mass);
  b->inverse_inertia = third;
}

// Sets collider, box and inertia from position and rotation.
static void place(solver_body *b) {
  b->pose.position.x = to_q16(b->position.x);
  b->pose.position.y = to_q16(b->position.y);
  b->pose.position.z = to_q16(b->position.z);
  (void)gjk_collider_pose(&b->collider, &b->pose);
  (void)gjk_collider_aabb(&b->collider, &b->box);
  b->box.lower.x -= MARGIN;
  b->box.lower.y -= MARGIN;
  b->box.lower.z -= MARGIN;
  const gjk_quat *q = &b->pose.rotation;
  const solver_fix unit = GJK_Q30_ONE / SOLVER_ONE, x = q->x / unit, y = q->y / unit, z = q->z / unit, w = q->w / unit;
  const solver_vec turned[3] = {
      {SOLVER_ONE - 2 * (mul(y, y) + mul(z, z)), 2 * (mul(x, y) - mul(z, w)), 2 * (mul(x, z) + mul(y, w))},
      {2 * (mul(x, y) + mul(z, w)), SOLVER_ONE - 2 * (mul(x, x) + mul(z, z)), 2 * (mul(y, z) - mul(x, w))},
      {2 * (mul(x, z) - mul(y, w)), 2 * (mul(y, z) + mul(x, w)), SOLVER_ONE - 2 * (mul(x, x) + mul(y, y))}};
  for (unsigned i = 0; i < 3; i++) {
    const solver_vec *row = &turned[i], *own = &b->inverse_inertia;
    const solver_vec scaled = {mul(row->x, own->x), mul(row->y, own->y), mul(row->z, own->z)};
    b->inverse_in_world[i].x = vec_dot(scaled, turned[0]);
    b->inverse_in_world[i].y = vec_dot(scaled, turned[1]);
    b->inverse_in_world[i].z = vec_dot(scaled, turned[2]);
  }
}

unsigned solver_add(solver_world *w, const gjk_shape *shape, gjk_vec3 half, const gjk_pose *pose, bool fixed) {
  solver_body *b = &w->body[w->bodies];
  const solver_vec zero = {0, 0, 0};
  const gjk_collider blank = {0};
  b->collider = blank;
  (void)gjk_collider_init(&b->collider, shape, NULL, 0);
  b->pose = *pose;
  b->position = vec_from_q16(pose->position);
  b->velocity = zero;
  b->spin = zero;
  b->inverse_mass = 0;
  b->inverse_inertia = zero;
  if (!fixed) {
    set_mass(b, half);
  }
  place(b);
  return w->bodies++;
}

static solver_vec turn_inertia(const solver_body *b, solver_vec a) {
  const solver_vec out = {vec_dot(b->inverse_in_world[0], a), vec_dot(b->inverse_in_world[1], a),
                          vec_dot(b->inverse_in_world[2], a)};
  return out;
}

static void push(solver_world *w, const solver_pair *p, const solver_axis *k, solver_fix impulse) {
  solver_body *a = &w->body[p->a], *b = &w->body[p->b];
  a->velocity = vec_sub(a->velocity, vec_scale(mul(a->inverse_mass, impulse), k->axis));
  a->spin = vec_sub(a->spin, vec_scale(impulse, k->turn_a));
  b->velocity = vec_add(b->velocity, vec_scale(mul(b->inverse_mass, impulse), k->axis));
  b->spin = vec_add(b->spin, vec_scale(impulse, k->turn_b));
}

// The speed at which B's point leaves A's along an axis.
static solver_fix speed_along(const solver_world *w, const solver_pair *p, const solver_axis *k) {
  const solver_body *a = &w->body[p->a], *b = &w->body[p->b];
  return vec_dot(vec_sub(b->velocity, a->velocity), k->axis) + vec_dot(b->spin, k->moment_b) -
         vec_dot(a->spin, k->moment_a);
}

static solver_fix magnitude(solver_fix a) {
  return a < 0 ? -a : a;
}

// The square root of a, by Newton's iteration. Pre: 0 < a < 2^62.
static solver_fix root(solver_fix a) {
  solver_fix x = (solver_fix)1 << 31;
  for (int i = 0; i < 64; i++) {
    const solver_fix next = (x + a / x) / 2;
    if (next >= x) {
      break;
    }
    x = next;
  }
  return x;
}

// Two tangents that turn as little as possible when the normal turns.
static void set_axes(solver_vec normal, solver_vec axis[3]) {
  const solver_vec x = {SOLVER_ONE, 0, 0}, z = {0, 0, SOLVER_ONE};
  const solver_vec across = vec_cross(normal, magnitude(normal.x) < SOLVER_ONE / 8 * 5 ? x : z);
  const solver_fix length = root(across.x * across.x + across.y * across.y + across.z * across.z);
  axis[0] = normal;
  axis[1] = vec_scale(inverse(length), across);
  axis[2] = vec_cross(axis[1], normal);
}

static void set_point(const solver_world *w, const solver_pair *p, const gjk_contact *c, const solver_vec axis[3],
                      solver_point *point) {
  const solver_body *a = &w->body[p->a], *b = &w->body[p->b];
  const solver_vec sum = vec_add(vec_from_q16(c->point_a), vec_from_q16(c->point_b));
  const solver_vec middle = {sum.x / 2, sum.y / 2, sum.z / 2};
  const solver_vec arm_a = vec_sub(middle, a->position), arm_b = vec_sub(middle, b->position);
  point->id = c->id;
  for (unsigned i = 0; i < 3; i++) {
    solver_axis *k = &point->along[i];
    k->axis = axis[i];
    k->moment_a = vec_cross(arm_a, axis[i]);
    k->moment_b = vec_cross(arm_b, axis[i]);
    k->turn_a = turn_inertia(a, k->moment_a);
    k->turn_b = turn_inertia(b, k->moment_b);
    k->mass =
        inverse(a->inverse_mass + b->inverse_mass + vec_dot(k->moment_a, k->turn_a) + vec_dot(k->moment_b, k->turn_b));
    k->impulse = 0;
  }
  const gjk_q16 deep = -c->distance;
  point->bias = deep <= 0 ? SOLVER_RATE * from_q16(deep) : deep > SLOP ? SOLVER_RATE * from_q16(deep - SLOP) / UNDO : 0;
}

static bool is_of_bodies(const solver_pair *p, uint16_t a, uint16_t b) {
  return p->a == a && p->b == b;
}

// Takes over the impulses of the tick before, found by id alone.
static void warm(solver_world *w, solver_pair *p, unsigned *from) {
  const unsigned before = 1 - w->now;
  unsigned k = *from;
  while (k < w->pairs[before] &&
         (w->pair[before][k].a < p->a || (w->pair[before][k].a == p->a && w->pair[before][k].b < p->b))) {
    k++;
  }
  *from = k;
  if (k == w->pairs[before] || !is_of_bodies(&w->pair[before][k], p->a, p->b)) {
    return;
  }
  for (unsigned i = 0; i < p->count; i++) {
    bool found = false;
    for (unsigned n = k; n < w->pairs[before] && is_of_bodies(&w->pair[before][n], p->a, p->b); n++) {
      const solver_pair *old = &w->pair[before][n];
      // Ids of manifolds put together are of parts, whatever the features.
      const bool same = w->manifolds != NULL || (old->feature_a == p->feature_a && old->feature_b == p->feature_b);
      for (unsigned j = 0; j < old->count && same; j++) {
        if (old->point[j].id == p->point[i].id) {
          found = true;
          for (unsigned axis = 0; axis < 3; axis++) {
            p->point[i].along[axis].impulse = old->point[j].along[axis].impulse;
          }
        }
      }
    }
    w->points++;
    w->fresh += !found;
  }
}

static bool boxes_meet(const gjk_aabb *a, const gjk_aabb *b) {
  return a->lower.x <= b->upper.x && b->lower.x <= a->upper.x && a->lower.y <= b->upper.y && b->lower.y <= a->upper.y &&
         a->lower.z <= b->upper.z && b->lower.z <= a->upper.z;
}

static unsigned find_manifolds(const solver_world *w, uint16_t a, uint16_t b, gjk_manifold *out) {
  if (w->manifolds != NULL) {
    return w->manifolds(w->user, a, b, out, SOLVER_MANIFOLDS_MAX);
  }
  return gjk_contacts(&w->body[a].collider, &w->body[b].collider, MARGIN, SOLVER_POINTS_MAX, NULL, &workspace, out) ==
             GJK_OK &&
         out->count > 0;
}

static void meet(solver_world *w, uint16_t a, uint16_t b, unsigned *from) {
  gjk_manifold found[SOLVER_MANIFOLDS_MAX];
  const unsigned count = w->pairs[w->now] < SOLVER_PAIRS_MAX ? find_manifolds(w, a, b, found) : 0;
  for (unsigned n = 0; n < count && w->pairs[w->now] < SOLVER_PAIRS_MAX; n++) {
    const gjk_manifold *m = &found[n];
    solver_pair *p = &w->pair[w->now][w->pairs[w->now]++];
    p->a = a;
    p->b = b;
    p->feature_a = m->feature_a;
    p->feature_b = m->feature_b;
    p->count = m->count;
    solver_vec axis[3];
    set_axes(vec_from_unit(m->normal), axis);
    for (unsigned i = 0; i < m->count; i++) {
      set_point(w, p, &m->contact[i], axis, &p->point[i]);
    }
    warm(w, p, from);
  }
}

static void find_pairs(solver_world *w) {
  unsigned from = 0;
  w->now = 1 - w->now;
  w->pairs[w->now] = 0;
  for (unsigned a = 0; a < w->bodies; a++) {
    for (unsigned b = a + 1; b < w->bodies; b++) {
      if ((w->body[a].inverse_mass != 0 || w->body[b].inverse_mass != 0) &&
          boxes_meet(&w->body[a].box, &w->body[b].box)) {
        meet(w, (uint16_t)a, (uint16_t)b, &from);
      }
    }
  }
}

static solver_fix clamp(solver_fix a, solver_fix low, solver_fix high) {
  return a < low ? low : a > high ? high : a;
}

// Applies an impulse along an axis, within limits, that brings the speed there to the wanted one.
static void solve_axis(solver_world *w, const solver_pair *p, solver_axis *k, solver_fix wanted, solver_fix low,
                       solver_fix high) {
  const solver_fix before = k->impulse;
  k->impulse = clamp(before + mul(k->mass, wanted - speed_along(w, p, k)), low, high);
  push(w, p, k, k->impulse - before);
}

static void solve(solver_world *w) {
  solver_pair *pairs = w->pair[w->now];
  const unsigned count = w->pairs[w->now];
  for (unsigned i = 0; i < count; i++) {
    for (unsigned n = 0; n < pairs[i].count; n++) {
      for (unsigned k = 0; k < 3; k++) {
        push(w, &pairs[i], &pairs[i].point[n].along[k], pairs[i].point[n].along[k].impulse);
      }
    }
  }
  for (unsigned iteration = 0; iteration < w->iterations; iteration++) {
    for (unsigned i = 0; i < count; i++) {
      for (unsigned n = 0; n < pairs[i].count; n++) {
        solver_point *point = &pairs[i].point[n];
        const solver_fix hold = FRICTION(point->along[0].impulse);
        solve_axis(w, &pairs[i], &point->along[1], 0, -hold, hold);
        solve_axis(w, &pairs[i], &point->along[2], 0, -hold, hold);
        solve_axis(w, &pairs[i], &point->along[0], point->bias, 0, INT64_MAX);
      }
    }
  }
}

// Turns a body by its spin for a tick: the quaternion has half the angle.
static void turn(solver_body *b) {
  const solver_fix scale = GJK_Q30_ONE / SOLVER_ONE;
  const gjk_quat step = {(gjk_q30)(b->spin.x * scale / (2 * SOLVER_RATE)),
                         (gjk_q30)(b->spin.y * scale / (2 * SOLVER_RATE)),
                         (gjk_q30)(b->spin.z * scale / (2 * SOLVER_RATE)), GJK_Q30_ONE};
  gjk_quat unit;
  if ((step.x | step.y | step.z) != 0 && gjk_quat_normalize(&step, &unit) == GJK_OK) {
    (void)gjk_quat_compose(&unit, &b->pose.rotation, &b->pose.rotation);
  }
}

void solver_step(solver_world *w) {
  find_pairs(w);
  for (unsigned i = 0; i < w->bodies; i++) {
    solver_body *b = &w->body[i];
    b->velocity.z -= b->inverse_mass != 0 ? GRAVITY / SOLVER_RATE : 0;
  }
  solve(w);
  for (unsigned i = 0; i < w->bodies; i++) {
    solver_body *b = &w->body[i];
    if (b->inverse_mass == 0) {
      continue;
    }
    if (w->damping > 0) {
      b->spin = vec_sub(b->spin, vec_scale(SOLVER_ONE >> w->damping, b->spin));
    }
    b->position.x += b->velocity.x / SOLVER_RATE;
    b->position.y += b->velocity.y / SOLVER_RATE;
    b->position.z += b->velocity.z / SOLVER_RATE;
    turn(b);
    place(b);
  }
}

static solver_fix largest(solver_fix most, solver_vec a) {
  most = magnitude(a.x) > most ? magnitude(a.x) : most;
  most = magnitude(a.y) > most ? magnitude(a.y) : most;
  return magnitude(a.z) > most ? magnitude(a.z) : most;
}

solver_fix solver_speed(const solver_world *w) {
  solver_fix most = 0;
  for (unsigned i = 0; i < w->bodies; i++) {
    most = largest(largest(most, w->body[i].velocity), w->body[i].spin);
  }
  return most;
}

static uint32_t mix(uint32_t hash, int64_t value) {
  const uint64_t bits = (uint64_t)value;
  for (unsigned i = 0; i < 64; i += 8) {
    hash = (hash ^ (uint32_t)(bits >> i & 0xFFu)) * UINT32_C(16777619);
  }
  return hash;
}

static uint32_t mix_vec(uint32_t hash, solver_vec a) {
  return mix(mix(mix(hash, a.x), a.y), a.z);
}

uint32_t solver_hash(const solver_world *w) {
  uint32_t hash = UINT32_C(2166136261);
  for (unsigned i = 0; i < w->bodies; i++) {
    const solver_body *b = &w->body[i];
    const gjk_quat *q = &b->pose.rotation;
    hash = mix_vec(mix_vec(mix_vec(hash, b->position), b->velocity), b->spin);
    hash = mix(mix(mix(mix(hash, q->x), q->y), q->z), q->w);
  }
  return hash;
}
