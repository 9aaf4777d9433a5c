// The pile of two sides, under the solver of demo_plane.
#include "pile.h"

#include "tests/programs/demo_plane/flat_solver.h"

#define ONE GJK_Q16_ONE
#define BODIES 200
#define COLUMNS 18

static flat_world worlds[2];
static int32_t shown[BODIES * 7];

// From the top of the right wall over the floor to the top of the left one.
static const gjk2_vec trough[] = {
    {PAGE_PILE_WIDTH * ONE, PAGE_PILE_HEIGHT *ONE}, {PAGE_PILE_WIDTH * ONE, 0}, {0, 0}, {0, PAGE_PILE_HEIGHT *ONE}};

static void add_body(flat_world *w, unsigned i) {
  const unsigned row = i / COLUMNS;
  const int32_t aside = (int32_t)(row % 2) * ONE / 5;
  const gjk2_vec at = {ONE * 3 / 5 + (int32_t)(i % COLUMNS) * (ONE * 7 / 10) + aside,
                       ONE + (int32_t)row * (ONE * 4 / 5)};
  const int32_t half = ONE / 5 + (int32_t)(i * 7 % 5) * (ONE / 40);
  const int32_t square = (int32_t)((int64_t)half * half / ONE);
  if (i % 3 == 1) {
    const gjk2_shape ball = GJK2_CIRCLE(half);
    w->body[flat_add(w, &ball, at, 0, 3 * square, square / 2)].bounce = ONE / 4;
  } else {
    const int32_t high = i % 3 == 0 ? half : half * 3 / 4;
    const gjk2_shape crate = GJK2_BOX(half, high);
    const int32_t mass = (int32_t)((int64_t)4 * half * high / ONE);
    const int32_t inertia = (int32_t)(((int64_t)half * half + (int64_t)high * high) / 3 / ONE);
    (void)flat_add(w, &crate, at, (int32_t)(i * 37 % 11) * (ONE / 16), mass, inertia);
  }
}

void page_pile_start(int side, unsigned bodies) {
  static const flat_world empty;
  const gjk2_vec origin = {0, 0};
  flat_world *w = &worlds[side];
  *w = empty;
  flat_add_chain(w, trough, 4, origin, INT32_MAX);
  for (unsigned i = 0; i < bodies && i < BODIES; i++) {
    add_body(w, i);
  }
}

void page_pile_push(int side, int32_t x, int32_t y) {
  flat_world *w = &worlds[side];
  for (unsigned i = 0; i < w->bodies; i++) {
    flat_body *b = &w->body[i];
    const int64_t dx = (int64_t)b->pose.position.x - x, dy = (int64_t)b->pose.position.y - y;
    if (dx * dx + dy * dy < (int64_t)4 * ONE * ONE) {
      b->velocity.x += (int32_t)(dx * 3);
      b->velocity.y += (int32_t)(8 * ONE + dy);
    }
  }
}

static uint64_t mix(uint64_t hash, int32_t value) {
  return (hash ^ (uint32_t)value) * UINT64_C(0x100000001b3);
}

uint64_t page_pile_tick(int side) {
  flat_world *w = &worlds[side];
  uint64_t hash = UINT64_C(0xcbf29ce484222325);
  flat_step(w);
  for (unsigned i = 0; i < w->bodies; i++) {
    const flat_body *b = &w->body[i];
    const int32_t values[] = {b->pose.position.x, b->pose.position.y, b->angle, b->velocity.x, b->velocity.y, b->spin};
    for (unsigned k = 0; k < sizeof values / sizeof values[0]; k++) {
      hash = mix(hash, values[k]);
    }
  }
  return hash;
}

void page_pile_flip(int side, unsigned body) {
  worlds[side].body[body].pose.position.x ^= 1;
}

const int32_t *page_pile_bodies(int side) {
  const flat_world *w = &worlds[side];
  for (unsigned i = 0; i < w->bodies; i++) {
    const flat_body *b = &w->body[i];
    const bool ball = b->shape.convex_radius > 0;
    int32_t *out = &shown[7 * i];
    out[0] = ball;
    out[1] = ball ? b->shape.convex_radius : b->shape.size.x;
    out[2] = ball ? b->shape.convex_radius : b->shape.size.y;
    out[3] = b->pose.position.x;
    out[4] = b->pose.position.y;
    out[5] = b->pose.rotation.c;
    out[6] = b->pose.rotation.s;
  }
  return shown;
}

void *page_pile_state(int side) {
  return &worlds[side];
}

uint32_t page_pile_bytes(void) {
  return sizeof worlds[0];
}
