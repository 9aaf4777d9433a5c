#include "flat_solver.h"

#define ONE GJK_Q16_ONE
#define MARGIN (ONE / 50)    // contacts are asked for this far apart
#define SLOP (ONE / 200)     // bodies rest this deep in each other
#define PUSH 12              // 1/5 of a depth is undone in a tick
#define PUSH_MOST (3 * ONE)  // the fastest that a depth is undone
#define SLOWEST_BOUNCE (2 * ONE)
#define FASTEST (14 * ONE)
#define GRAVITY (18 * ONE)
#ifndef ITERATIONS
#define ITERATIONS 12
#endif
#define GROUND_CONTACTS 12

// a b / 2^16 and a b / 2^30, towards 0. Pre: the result fits.
static int32_t times(int32_t a, int32_t b) {
  return (int32_t)((int64_t)a * b / ONE);
}

static int32_t along(int32_t a, gjk_q30 unit) {
  return (int32_t)((int64_t)a * unit / GJK_Q30_ONE);
}

static int32_t limited(int64_t x, int32_t most) {
  return (int32_t)(x > most ? most : x < -most ? -most : x);
}

// The moment of a direction about the origin of an arm.
static int32_t moment(gjk2_vec arm, gjk2_unit d) {
  return (int32_t)(((int64_t)arm.x * d.y - (int64_t)arm.y * d.x) / GJK_Q30_ONE);
}

static void place(flat_body *b) {
  if (b->inverse_inertia != 0) {
    (void)gjk2_rotation_from_angle(b->angle, &b->pose.rotation);
  }
  (void)gjk2_collider_pose(&b->collider, &b->pose);
  (void)gjk2_collider_aabb(&b->collider, &b->box);
}

unsigned flat_add(flat_world *w, const gjk2_shape *shape, gjk2_vec at, gjk_angle angle, int32_t mass, int32_t inertia) {
  flat_body *b = &w->body[w->bodies];
  b->shape = *shape;
  b->pose.position = at;
  b->angle = angle;
  (void)gjk2_rotation_from_angle(angle, &b->pose.rotation);
  b->inverse_mass = mass > 0 ? (int32_t)(((int64_t)ONE << 16) / mass) : 0;
  b->inverse_inertia = inertia > 0 ? (int32_t)(((int64_t)b->inverse_mass << 16) / inertia) : 0;
  b->friction = ONE / 2;
  (void)gjk2_collider_init(&b->collider, &b->shape, b->buffer, FLAT_VERTICES);
  place(b);
  return w->bodies++;
}

void flat_add_chain(flat_world *w, const gjk2_vec *vertices, uint16_t count, gjk2_vec at, gjk_q16 deepest) {
  flat_chain *c = &w->chain[w->chains++];
  (void)gjk2_chain_init(&c->chain, vertices, count, &at);
  c->deepest = deepest;
}

// The speed of B's point from A's along a direction. a: NULL for a chain.
static int32_t speed_along(const flat_body *a, const flat_body *b, const flat_point *p, gjk2_unit d) {
  int32_t speed = along(b->velocity.x, d.x) + along(b->velocity.y, d.y) + times(b->spin, moment(p->arm_b, d));
  if (a != NULL) {
    speed -= along(a->velocity.x, d.x) + along(a->velocity.y, d.y) + times(a->spin, moment(p->arm_a, d));
  }
  return speed;
}

static void push_body(flat_body *b, gjk2_vec arm, gjk2_unit d, int32_t impulse) {
  const int32_t change = times(impulse, b->inverse_mass);
  b->velocity.x += along(change, d.x);
  b->velocity.y += along(change, d.y);
  b->spin += times(times(moment(arm, d), impulse), b->inverse_inertia);
}

static void push(flat_body *a, flat_body *b, const flat_point *p, gjk2_unit d, int32_t impulse) {
  push_body(b, p->arm_b, d, impulse);
  if (a != NULL) {
    push_body(a, p->arm_a, d, -impulse);
  }
}

// What mass resists an impulse along a direction, at most 256.
static int32_t mass_along(const flat_body *a, const flat_body *b, const flat_point *p, gjk2_unit d) {
  const int32_t of_b = moment(p->arm_b, d);
  int64_t inverse = (int64_t)b->inverse_mass + times(times(of_b, of_b), b->inverse_inertia);
  if (a != NULL) {
    const int32_t of_a = moment(p->arm_a, d);
    inverse += (int64_t)a->inverse_mass + times(times(of_a, of_a), a->inverse_inertia);
  }
  return (int32_t)(((int64_t)ONE << 16) / (inverse > 256 ? inverse : 256));
}

static gjk2_unit across(gjk2_unit normal) {
  const gjk2_unit left = {-normal.y, normal.x};
  return left;
}

static flat_body *body_of(flat_world *w, uint16_t number) {
  return number < FLAT_BODIES ? &w->body[number] : NULL;
}

// Step 2
static void warm_start(flat_world *w, flat_point *p) {
  const flat_point *last = w->point[1 - w->now];
  for (unsigned i = 0; i < w->points[1 - w->now]; i++) {
    if (last[i].a == p->a && last[i].b == p->b && last[i].segment == p->segment && last[i].id == p->id) {
      p->impulse = last[i].impulse;
      p->impulse_across = last[i].impulse_across;
    }
  }
}

static void add_points(flat_world *w, uint16_t a, uint16_t b, uint16_t segment, const gjk2_manifold *m) {
  flat_body *of_a = body_of(w, a), *of_b = &w->body[b];
  for (unsigned k = 0; k < m->count && w->points[w->now] < FLAT_POINTS; k++) {
    const gjk2_contact *c = &m->contact[k];
    flat_point *p = &w->point[w->now][w->points[w->now]++];
    const flat_point zero = {0};
    *p = zero;
    p->a = a;
    p->b = b;
    p->segment = segment;
    p->id = c->id;
    p->normal = m->normal;
    p->arm_b.x = c->point_b.x - of_b->pose.position.x;
    p->arm_b.y = c->point_b.y - of_b->pose.position.y;
    if (of_a != NULL) {
      p->arm_a.x = c->point_a.x - of_a->pose.position.x;
      p->arm_a.y = c->point_a.y - of_a->pose.position.y;
    }
    p->mass = mass_along(of_a, of_b, p, p->normal);
    p->mass_across = mass_along(of_a, of_b, p, across(p->normal));
    p->target = c->distance > 0 ? -c->distance * FLAT_RATE : 0;
    if (c->distance < -SLOP) {
      p->target = limited((int64_t)(-SLOP - c->distance) * PUSH, PUSH_MOST);
    }
    const int32_t speed = speed_along(of_a, of_b, p, p->normal);
    const int32_t bounce = of_a != NULL && of_a->bounce > of_b->bounce ? of_a->bounce : of_b->bounce;
    if (speed < -SLOWEST_BOUNCE && times(-speed, bounce) > p->target) {
      p->target = times(-speed, bounce);
    }
    of_b->grounded = of_b->grounded || m->normal.y > GJK_Q30_ONE / 2;
    if (of_a != NULL) {
      of_a->grounded = of_a->grounded || m->normal.y < -GJK_Q30_ONE / 2;
    }
    warm_start(w, p);
  }
}

static bool boxes_meet(const gjk2_aabb *a, const gjk2_aabb *b) {
  return a->lower.x - MARGIN <= b->upper.x && b->lower.x - MARGIN <= a->upper.x && a->lower.y - MARGIN <= b->upper.y &&
         b->lower.y - MARGIN <= a->upper.y;
}

// Step 1
static void find_contacts(flat_world *w) {
  static gjk2_chain_contact ground[GROUND_CONTACTS];
  for (uint16_t b = 0; b < w->bodies; b++) {
    flat_body *of_b = &w->body[b];
    for (uint16_t a = 0; a < b; a++) {
      gjk2_manifold m;
      if (of_b->inverse_mass + w->body[a].inverse_mass != 0 && boxes_meet(&of_b->box, &w->body[a].box) &&
          gjk2_contacts(&w->body[a].collider, &of_b->collider, MARGIN, 2, NULL, &m) == GJK_OK) {
        add_points(w, a, b, 0, &m);
        w->met += m.count;
      }
    }
    for (uint16_t c = 0; c < w->chains && of_b->inverse_mass != 0; c++) {
      uint16_t count = 0;
      (void)gjk2_chain_contacts(&w->chain[c].chain, &of_b->collider, NULL, MARGIN, ground, GROUND_CONTACTS, &count);
      for (uint16_t i = 0; i < count; i++) {
        const gjk2_manifold *m = &ground[i].manifold;
        if (m->contact[0].distance >= -w->chain[c].deepest) {
          add_points(w, (uint16_t)(FLAT_BODIES + c), b, (uint16_t)ground[i].segment, m);
          w->met_ground += m->count;
        }
      }
    }
  }
}

// Step 3
static void solve(flat_world *w, flat_point *p) {
  flat_body *a = body_of(w, p->a), *b = &w->body[p->b];
  const gjk2_unit left = across(p->normal);
  const int32_t before = p->impulse;
  const int32_t wanted = before + times(p->target - speed_along(a, b, p, p->normal), p->mass);
  p->impulse = wanted > 0 ? wanted : 0;
  push(a, b, p, p->normal, p->impulse - before);
  const int32_t friction = a != NULL && a->friction < b->friction ? a->friction : b->friction;
  const int32_t before_across = p->impulse_across;
  p->impulse_across =
      limited((int64_t)before_across - times(speed_along(a, b, p, left), p->mass_across), times(p->impulse, friction));
  push(a, b, p, left, p->impulse_across - before_across);
}

// Step 4
static void move(flat_body *b) {
  b->velocity.x = limited(b->velocity.x, FASTEST);
  b->velocity.y = limited(b->velocity.y, FASTEST);
  b->spin = limited(b->spin, FASTEST);
  b->pose.position.x += b->velocity.x / FLAT_RATE;
  b->pose.position.y += b->velocity.y / FLAT_RATE;
  b->angle += b->spin / FLAT_RATE;
  place(b);
}

void flat_step(flat_world *w) {
  w->now = 1 - w->now;
  w->points[w->now] = 0;
  for (unsigned i = 0; i < w->bodies; i++) {
    w->body[i].grounded = false;
    w->body[i].velocity.y -= w->body[i].inverse_mass != 0 ? GRAVITY / FLAT_RATE : 0;
  }
  find_contacts(w);
  for (unsigned i = 0; i < w->points[w->now]; i++) {
    flat_point *p = &w->point[w->now][i];
    push(body_of(w, p->a), &w->body[p->b], p, p->normal, p->impulse);
    push(body_of(w, p->a), &w->body[p->b], p, across(p->normal), p->impulse_across);
  }
  for (unsigned k = 0; k < ITERATIONS; k++) {
    for (unsigned i = 0; i < w->points[w->now]; i++) {
      solve(w, &w->point[w->now][i]);
    }
  }
  for (unsigned i = 0; i < w->bodies; i++) {
    if (w->body[i].inverse_mass != 0) {
      move(&w->body[i]);
    }
  }
}
