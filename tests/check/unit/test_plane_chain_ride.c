// Bodies under gravity ride over 1,000 joints of a chain at many speeds, the ground turned by any angle: boxes and the
// like slide, balls roll. No contact has a normal but the ground's, and no joint lifts or slows a body.
#include "gjk2/chain.h"
#include "plane.h"

#define SEED 2014
#define RIDES check_trials_least(120, 12)
#define JOINTS 1000
#define MARGIN_JOINTS 40  // at each end, so that bodies begin and end on the ground
#define SEGMENTS (JOINTS + 2 * MARGIN_JOINTS)
#define FOUND 64
#define GRAVITY 178.0  // LSB a tick, of 60 ticks a second and units of a metre
#define SOLVER_STEPS 12

typedef enum ground { LINE, ROUGH, HILLS, GROUNDS_COUNT } ground;

static const char *const ground_name[GROUNDS_COUNT] = {"line", "rough", "hills"};

static struct {
  unsigned long ticks, contacts, rides[GROUNDS_COUNT], crossed;
  double bump[GROUNDS_COUNT], slowed[GROUNDS_COUNT], deepest[GROUNDS_COUNT], height[GROUNDS_COUNT];
} tally;

typedef struct vec {
  double x, y;
} vec;

static vec scaled_sum(vec a, double s, vec b) {
  return (vec){a.x + s * b.x, a.y + s * b.y};
}

static double dot(vec a, vec b) {
  return a.x * b.x + a.y * b.y;
}

static double cross(vec a, vec b) {
  return a.x * b.y - a.y * b.x;
}

static const gjk2_vec hexagon[6] = {{30000, 0},  {15000, 26000},   {-15000, 26000},
                                    {-30000, 0}, {-15000, -26000}, {15000, -26000}};

// Shapes that lie flat, and how high their origin is then; the ball comes first.
static const struct {
  gjk2_shape shape;
  double height, inertia;  // by mass
} riders[] = {
    {.shape = GJK2_CIRCLE(25000), .height = 25000, .inertia = 25000.0 * 25000 / 2},
    {.shape = GJK2_BOX(32768, 20000), .height = 20000, .inertia = (32768.0 * 32768 + 20000.0 * 20000) / 3},
    {.shape = GJK2_CAPSULE(16000, 30000), .height = 16000, .inertia = 30000.0 * 30000 / 2},
    {.shape = GJK2_POLYGON(hexagon, 6), .height = 26000, .inertia = 30000.0 * 30000 / 2.4},
    {.shape = GJK2_ROUNDED_BOX(20000, 12000, 6000), .height = 18000, .inertia = 20000.0 * 20000 / 1.5},
};

typedef struct ride {
  ground kind;
  unsigned rider;
  gjk2_vec vertices[SEGMENTS + 1];
  gjk2_chain chain;
  gjk2_collider body;
  gjk2_vec buffer[8];
  vec along, normal;         // the way of the chain, and out of the ground; units
  double step, rise, speed;  // of a segment; along the way, LSB a tick
  vec at, velocity;          // of the body
  double turn, spin;         // radians, from lying flat
  unsigned first;            // the segment under the body
} ride;

static void show(const void *subject) {
  const ride *r = (const ride *)subject;
  printf("  %s, rider %u, step %.0f, speed %.0f, along (%.4f, %.4f)\n", ground_name[r->kind], r->rider, r->step,
         r->speed, r->along.x, r->along.y);
}

static void make_ground(random_state *random, ride *r) {
  const double angle = random_range(random, -314159, 314159) / 100000.0, size = random_range(random, 6000, 70000);
  const gjk2_vec way = {(int32_t)(size * cos(angle)), (int32_t)(size * sin(angle))};
  r->step = hypot(way.x, way.y);
  r->along.x = way.x / r->step;
  r->along.y = way.y / r->step;
  r->normal.x = r->along.y;  // the outside is to the right of the way
  r->normal.y = -r->along.x;
  const double wave = random_range(random, 60, 200) / 6.2831853;
  r->rise = r->kind == HILLS ? r->step * wave / 12 : 0;
  for (int i = 0; i <= SEGMENTS; i++) {
    const double lift = r->rise * sin(i / wave);
    const int32_t rough = r->kind == ROUGH ? 1 : 0;
    r->vertices[i].x = (i - SEGMENTS / 2) * way.x + (int32_t)(lift * r->normal.x) + random_range(random, -rough, rough);
    r->vertices[i].y = (i - SEGMENTS / 2) * way.y + (int32_t)(lift * r->normal.y) + random_range(random, -rough, rough);
  }
  const gjk2_vec origin = {0, 0};
  memset(&r->chain, 0, sizeof r->chain);
  CHECK(gjk2_chain_init(&r->chain, r->vertices, SEGMENTS + 1, &origin) == GJK_OK);
}

static vec vertex_of(const ride *r, unsigned i) {
  return (vec){r->vertices[i].x, r->vertices[i].y};
}

static void pose_body(ride *r) {
  const gjk2_rotation raw = {(int32_t)(-r->along.x * GJK_Q30_ONE), (int32_t)(-r->along.y * GJK_Q30_ONE)};
  gjk2_pose pose = GJK2_POSE_IDENTITY;
  gjk2_rotation flat, turn;
  CHECK(gjk2_rotation_normalize(&raw, &flat) == GJK_OK);
  CHECK(gjk2_rotation_from_angle((gjk_angle)lrint(remainder(r->turn, 6.283185307179586) * 65536), &turn) == GJK_OK);
  CHECK(gjk2_rotation_compose(&flat, &turn, &pose.rotation) == GJK_OK);
  pose.position.x = (int32_t)lrint(r->at.x);
  pose.position.y = (int32_t)lrint(r->at.y);
  CHECK(gjk2_collider_pose(&r->body, &pose) == GJK_OK);
}

// The segments within reach of the body.
static gjk2_chain_range range_near(ride *r, double reach) {
  while (r->first + 1 < SEGMENTS && dot(scaled_sum(vertex_of(r, r->first + 1), -1, r->at), r->along) < 0) {
    r->first++;
  }
  while (r->first > 0 && dot(scaled_sum(vertex_of(r, r->first), -1, r->at), r->along) > 0) {
    r->first--;
  }
  const int more = (int)(reach / r->step) + 2;
  const int from = (int)r->first > more ? (int)r->first - more : 0;
  const int to = (int)r->first + more < SEGMENTS ? (int)r->first + more : SEGMENTS - 1;
  return (gjk2_chain_range){(uint16_t)from, (uint16_t)(to - from + 1)};
}

// Is the normal one that the ground has within the range: no farther round than the normals of two of its segments?
static bool is_of_ground(const ride *r, const gjk2_chain_range *range, const gjk2_unit *unit) {
  const vec u = {ldexp(unit->x, -30), ldexp(unit->y, -30)};
  bool before = false, after = false;
  for (unsigned i = range->first; i < (unsigned)range->first + range->count; i++) {
    const vec way = scaled_sum(vertex_of(r, i + 1), -1, vertex_of(r, i)), n = {way.y, -way.x};
    const double side = cross(n, u) / hypot(n.x, n.y);
    before = before || side <= 0x1p-27;
    after = after || side >= -0x1p-27;
  }
  return before && after && dot(u, r->normal) > 0.5;
}

// The contacts' impulses, by Gauss and Seidel: along each normal so that the next tick ends at the surface; a ball grips.
static void solve(ride *r, const gjk2_chain_contact *found, unsigned count) {
  double pushed[2 * FOUND] = {0};
  for (int step = 0; step < SOLVER_STEPS; step++) {
    for (unsigned i = 0; i < count; i++) {
      const gjk2_manifold *m = &found[i].manifold;
      const vec n = {ldexp(m->normal.x, -30), ldexp(m->normal.y, -30)}, t = {-n.y, n.x};
      for (unsigned k = 0; k < m->count; k++) {
        const vec point = {m->contact[k].point_b.x, m->contact[k].point_b.y}, arm = scaled_sum(point, -1, r->at);
        const vec slip = {r->velocity.x - r->spin * arm.y, r->velocity.y + r->spin * arm.x};
        const double inertia = riders[r->rider].inertia, distance = m->contact[k].distance;
        const double wanted = distance > 0 ? -distance : -distance / 4;
        const double lever = cross(arm, n), old = pushed[2 * i + k];
        const double now = fmax(0, old + (wanted - dot(slip, n)) / (1 + lever * lever / inertia));
        pushed[2 * i + k] = now;
        r->velocity = scaled_sum(r->velocity, now - old, n);
        r->spin += (now - old) * lever / inertia;
        if (r->rider == 0 && now > 0) {
          const double grip = -dot(slip, t) / (1 + cross(arm, t) * cross(arm, t) / inertia);
          r->velocity = scaled_sum(r->velocity, grip, t);
          r->spin += grip * cross(arm, t) / inertia;
        }
      }
    }
  }
}

// One tick: contacts, impulses, motion.
static void tick(ride *r) {
  gjk2_chain_contact found[FOUND];
  uint16_t count = 0;
  r->velocity = scaled_sum(r->velocity, -GRAVITY, r->normal);
  if (r->kind == HILLS) {  // a motor, since hills slow it, and air
    r->velocity = scaled_sum(r->velocity, (r->speed - dot(r->velocity, r->along)) / 8, r->along);
    r->spin *= r->rider == 0 ? 1 : 0.95;
  }
  pose_body(r);
  const double fall = hypot(r->velocity.x, r->velocity.y) + fabs(r->spin) * r->body.radius;
  const gjk_q16 margin = 300 + (gjk_q16)(r->kind == HILLS ? fall : 4 * GRAVITY);
  const gjk2_chain_range range = range_near(r, r->body.radius + margin);
  CHECK(gjk2_chain_contacts(&r->chain, &r->body, &range, margin, found, FOUND, &count) == GJK_OK);
  gjk_q16 least = INT32_MAX;
  for (unsigned i = 0; i < count; i++) {
    const gjk2_manifold *m = &found[i].manifold;
    CHECK_MSG(is_of_ground(r, &range, &m->normal), "normal %d %d", (int)m->normal.x, (int)m->normal.y);
    CHECK(r->kind != LINE || m->feature_a == 256);
    for (unsigned k = 0; k < m->count; k++) {
      least = m->contact[k].distance < least ? m->contact[k].distance : least;
    }
  }
  solve(r, found, count);
  tally.contacts += count;
  tally.ticks++;
  // The solver is linear: a body that turns far as it lands may be as deep as half of its corners' way.
  CHECK_MSG(-(double)least <= (r->kind == HILLS ? 100 + fall / 2 : 32), "%d deep", (int)-least);
  tally.deepest[r->kind] = fmax(tally.deepest[r->kind], -(double)least);
  r->at = scaled_sum(r->at, 1, r->velocity);
  r->turn += r->spin;
}

static void note(double *worst, double x) {
  *worst = fmax(*worst, x);
}

static void run(random_state *random, ride *r) {
  const gjk2_shape *shape = &riders[r->rider].shape;
  const double height = riders[r->rider].height, goal = (SEGMENTS / 2 - MARGIN_JOINTS) * r->step;
  memset(&r->body, 0, sizeof r->body);
  CHECK(gjk2_collider_init(&r->body, shape, r->buffer, 8) == GJK_OK);
  // At most 4 segments a tick, and 55 units a second; either way.
  const double most = fmin(4 * r->step, r->kind == HILLS ? 20000 : 60000), least = r->step / 3,
               way = random_below(random, 2) == 0 ? 1 : -1;
  r->speed = way * (least + (most - least) * random_below(random, 1000) / 1000.0);
  const vec middle = vertex_of(r, SEGMENTS / 2);
  const double lift = r->kind == HILLS ? 2 * r->rise + r->body.radius : height;  // above all hills
  r->at = scaled_sum(scaled_sum(middle, -way * goal, r->along), lift, r->normal);
  const vec still = {0, 0};
  r->velocity = scaled_sum(still, r->speed, r->along);
  r->turn = 0;
  r->spin = r->rider == 0 ? r->speed / height : 0;
  r->first = SEGMENTS / 2;
  const unsigned most_ticks = (unsigned)(6 * goal / fabs(r->speed)) + 100;
  unsigned ticks = 0, begun = 0;
  for (; ticks < most_ticks && way * dot(scaled_sum(r->at, -1, middle), r->along) < goal; ticks++) {
    tick(r);
    begun = ticks == 0 ? r->first : begun;
    if (r->kind != HILLS) {
      const double lifts = dot(r->velocity, r->normal), rest = dot(scaled_sum(r->at, -1, middle), r->normal) - height;
      // A joint that is 2 LSB off turns the way by 2 / step at most, and the body by its own length at most.
      const double bump = r->kind == LINE ? 3 : 3 + 4 * fabs(r->speed) / r->step;
      CHECK_MSG(lifts <= bump, "lifted by %.2f a tick", lifts);
      CHECK_MSG(rest > -32 && rest < 8 + 4 * bump, "%.1f above", rest);
      note(&tally.bump[r->kind], lifts);
      note(&tally.height[r->kind], fabs(rest));
    }
  }
  CHECK_MSG(ticks < most_ticks, "it came to a stop after %u ticks", ticks);
  if (r->kind != HILLS) {
    const double slowed = fabs(dot(r->velocity, r->along) / r->speed - 1);
    CHECK_MSG(slowed < (r->kind == LINE ? 0.005 : 0.02), "slower by %.6f", slowed);
    note(&tally.slowed[r->kind], slowed);
  }
  tally.rides[r->kind]++;
  const unsigned crossed = r->first > begun ? r->first - begun : begun - r->first;
  CHECK_MSG(crossed + 8 >= JOINTS, "%u joints", crossed);
  tally.crossed += crossed;
}

int main(void) {
  static ride r;
  const uint64_t seed = check_seed(SEED);
  const unsigned kinds = GROUNDS_COUNT, shapes = sizeof riders / sizeof riders[0];
  for (unsigned long i = 0; i < RIDES; i++) {
    random_state random = random_seed(seed + i);
    r.kind = (ground)(i % kinds);
    r.rider = (unsigned)(i / kinds % (shapes + 1)) % shapes;  // two balls for one of each other
    check_trial(i, show, &r);
    make_ground(&random, &r);
    run(&random, &r);
  }
  printf("%lu ticks, %lu manifolds, %lu joints crossed\n", tally.ticks, tally.contacts, tally.crossed);
  for (int k = 0; k < GROUNDS_COUNT; k++) {
    printf("%s: %lu rides; lifted by %.3f LSB a tick, %.2f off in height, slowed by %.7f; %.0f deep at most\n",
           ground_name[k], tally.rides[k], tally.bump[k], tally.height[k], tally.slowed[k], tally.deepest[k]);
  }
  CHECK(tally.crossed > RIDES * (JOINTS - 8));
  CHECK(tally.contacts > tally.ticks / 2 && tally.ticks > 100 * RIDES);
  return check_done("plane_chain_ride");
}
