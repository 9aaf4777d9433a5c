// Chains: bodies slide and roll over 1,000 joints and meet no normal but the ground's; convex loops against the same
// polygons as colliders; each decision against a plain reading of the contract, by many directions.
#include "gjk2/chain.h"

#include "plane.h"

#define SEED 2013
#define JOINTS 1000
#define SLIDES check_trials(160)
#define LOOPS check_trials(30000)
#define GROUNDS check_trials(30000)
#define FOUND 64

static struct {
  unsigned long ticks, faces, joints, kept, lost, met, apart, deeper, segments, silent, yielded, behind, doubtful;
} tally;

static const gjk2_vec origin = {0, 0};

// Ground over 1,000 joints, from right to left, so that up is outside.
typedef enum ground { LEVEL, SLOPE, CONVEX, CONCAVE, WAVES, STEPS, RISERS, GROUNDS_COUNT } ground;

static gjk2_vec vertices[2 * JOINTS + 8];

// Returns the number of vertices. Each kind repeats a vertex now and then.
static uint16_t make_ground(random_state *r, ground kind) {
  uint16_t n = 0;
  const int32_t step = random_range(r, 6000, 70000), rise = random_range(r, -step / 2, step / 2);
  int32_t x = step / 2 * JOINTS, y = 0;
  if (kind == CONVEX || kind == CONCAVE) {
    y = 0;
  }
  for (int i = 0; i <= JOINTS + 1; i++) {
    vertices[n].x = x;
    vertices[n++].y = y;
    if (random_below(r, 20) == 0) {
      vertices[n] = vertices[n - 1];
      n++;
    }
    x -= step;
    const int middle = i - JOINTS / 2;
    switch (kind) {
      case LEVEL: break;
      case SLOPE: y += rise; break;
      case CONVEX: y -= (int32_t)((int64_t)middle * step / (2 * JOINTS)); break;
      case CONCAVE: y += (int32_t)((int64_t)middle * step / (2 * JOINTS)); break;
      case WAVES: y += random_range(r, -step / 12, step / 12); break;
      case STEPS: y += random_range(r, -1, 1); break;
      default:
        if (random_below(r, 2) == 0) {
          vertices[n].x = x;
          vertices[n++].y = y;
          y += random_range(r, -1, 1);
        }
        break;
    }
  }
  return n;
}

static gjk2_vec difference(gjk2_vec p, gjk2_vec q) {
  const gjk2_vec d = {p.x - q.x, p.y - q.y};
  return d;
}

static int64_t cross(gjk2_vec p, gjk2_vec q) {
  return (int64_t)p.x * q.y - (int64_t)p.y * q.x;
}

// The segment with a length before or after another, by the contract. False: an open end.
static bool neighbour_of(const gjk2_chain *chain, int i, int by, gjk2_vec *out) {
  const int segments = chain->count - 1;
  for (int k = 1; k < segments; k++) {
    const int j = i + by * k;
    if (!chain->closed && (j < 0 || j >= segments)) {
      return false;
    }
    const int at = (j + segments) % segments;
    *out = difference(chain->vertices[at + 1], chain->vertices[at]);
    if ((out->x | out->y) != 0) {
      return true;
    }
  }
  return false;
}

static long double angle_between(const gjk2_unit *u, gjk2_vec n) {
  const long double x = ldexpl(u->x, -30), y = ldexpl(u->y, -30), length = hypotl(n.x, n.y);
  return fabsl((x * n.y - y * n.x) / length) + (x * n.x + y * n.y > 0 ? 0 : 2);
}

// Is the contact's normal one that the surface has there?
static bool is_of_surface(const gjk2_chain *chain, const gjk2_chain_contact *c) {
  const int i = c->segment;
  const gjk2_vec t = difference(chain->vertices[i + 1], chain->vertices[i]), n = {t.y, -t.x};
  const gjk2_unit *u = &c->manifold.normal;
  if (c->manifold.feature_a == 256) {
    return angle_between(u, n) <= 0x1p-28L;
  }
  const bool at_end = c->manifold.feature_a == 1;
  gjk2_vec other = t;
  gjk2_vec normal;
  if (neighbour_of(chain, i, at_end ? 1 : -1, &other)) {
    normal.x = other.y;
    normal.y = -other.x;
    if ((at_end ? cross(t, other) : cross(other, t)) < 0) {
      return false;
    }
  } else {
    normal.x = at_end ? t.x : -t.x;
    normal.y = at_end ? t.y : -t.y;
  }
  const gjk2_vec from = at_end ? n : normal, to = at_end ? normal : n, d = {u->x, u->y};
  const long double slack = 4;
  return (long double)cross(from, d) >= -slack * hypotl(from.x, from.y) &&
         (long double)cross(d, to) >= -slack * hypotl(to.x, to.y);
}

static const gjk2_vec hexagon[6] = {{30000, 0},  {15000, 26000},   {-15000, 26000},
                                    {-30000, 0}, {-15000, -26000}, {15000, -26000}};

static gjk2_shape sliding_shape(unsigned kind) {
  const gjk2_shape shapes[] = {GJK2_BOX(32768, 20000),
                               GJK2_CIRCLE(25000),
                               GJK2_CAPSULE(16000, 30000),
                               GJK2_POLYGON(hexagon, 6),
                               GJK2_ROUNDED_BOX(20000, 12000, 6000),
                               GJK2_ELLIPSE(30000, 16000)};
  return shapes[kind];
}

// The least height, by halving, at which the body above touches no line of the ground.
static int32_t resting_height(const gjk2_chain *chain, gjk2_collider *body, int32_t x, int32_t low, int32_t high) {
  while (high - low > 1) {
    const gjk2_vec at = {x, low + (high - low) / 2};
    bool yes;
    uint16_t segment;
    CHECK(gjk2_collider_move(body, &at) == GJK_OK);
    CHECK(gjk2_chain_intersect(chain, body, NULL, &yes, &segment) == GJK_OK);
    if (yes) {
      low = at.y;
    } else {
      high = at.y;
    }
  }
  return high;
}

static int32_t ground_height(const gjk2_chain *chain, int32_t x) {
  int32_t most = INT32_MIN;
  for (int i = 0; i + 1 < chain->count; i++) {
    const gjk2_vec p = chain->vertices[i], q = chain->vertices[i + 1];
    if (q.x <= x + 70000 && p.x >= x - 70000) {
      most = p.y > most ? p.y : most;
      most = q.y > most ? q.y : most;
    }
  }
  return most;
}

static bool has_contact(const gjk2_chain_contact *list, uint16_t count, uint16_t segment, uint16_t id) {
  for (int i = 0; i < count; i++) {
    for (int k = 0; k < list[i].manifold.count; k++) {
      if (list[i].segment == segment && list[i].manifold.contact[k].id == id) {
        return true;
      }
    }
  }
  return false;
}

// One body over one ground, left to right, at a speed.
static void slide(random_state *r) {
  static gjk2_vec buffer[8];
  const ground kind = (ground)random_below(r, GROUNDS_COUNT);
  const unsigned shape_kind = random_below(r, 6);
  const gjk2_shape shape = sliding_shape(shape_kind);
  const uint16_t n = make_ground(r, kind);
  const bool rolls = random_below(r, 2) == 0;
  const int32_t speed = random_range(r, 1, 1 << random_below(r, 17));
  const int32_t slop = random_below(r, 3) == 0 ? 1 : random_range(r, 2, 400);
  gjk2_chain chain;
  gjk2_collider body;
  memset(&chain, 0, sizeof chain);
  memset(&body, 0, sizeof body);
  CHECK(gjk2_chain_init(&chain, vertices, n, &origin) == GJK_OK);
  CHECK(gjk2_collider_init(&body, &shape, buffer, 8) == GJK_OK);
  const gjk2_vec run = difference(vertices[0], vertices[n - 1]);
  gjk_angle turn = rolls ? random_range(r, -200000, 200000) : 0;
  const gjk2_rotation along = {run.x, run.y};
  gjk2_pose pose = GJK2_POSE_IDENTITY;
  if (kind == SLOPE) {
    CHECK(gjk2_rotation_normalize(&along, &pose.rotation) == GJK_OK);
  }
  int32_t x = random_range(r, vertices[n - 1].x + 200000, vertices[0].x - 400000);
  gjk2_chain_contact found[FOUND], before[FOUND];
  uint16_t count, count_before = 0;
  for (int tick = 0; tick < 40; tick++) {
    if (rolls) {
      CHECK(gjk2_rotation_from_angle(turn, &pose.rotation) == GJK_OK);
    }
    CHECK(gjk2_collider_pose(&body, &pose) == GJK_OK);
    const int32_t top = ground_height(&chain, x);
    const int32_t rest = resting_height(&chain, &body, x, top - 50000, top + 100000);
    gjk2_vec at = {x, rest - slop};
    CHECK(gjk2_collider_move(&body, &at) == GJK_OK);
    count = 0;
    CHECK(gjk2_chain_contacts(&chain, &body, NULL, 300, found, FOUND, &count) == GJK_OK);
    gjk_q16 least = INT32_MAX;
    for (int i = 0; i < count; i++) {
      const gjk2_manifold *m = &found[i].manifold;
      CHECK_MSG(is_of_surface(&chain, &found[i]), "kind %d, segment %d: normal %d %d", (int)kind, found[i].segment,
                (int)m->normal.x, (int)m->normal.y);
      CHECK(kind > SLOPE || m->feature_a == 256);
      CHECK(m->count >= 1 && m->count <= 2);
      tally.faces += m->feature_a == 256;
      tally.joints += m->feature_a != 256;
      for (int k = 0; k < m->count; k++) {
        const gjk_q16 distance = m->contact[k].distance;
        least = distance < least ? distance : least;
        CHECK_MSG(distance >= -slop - 6, "kind %d, shape %u: %d deep after %d", (int)kind, shape_kind, -distance, slop);
      }
    }
    CHECK_MSG(least <= (shape_kind == 5 ? 3 : 2), "kind %d, shape %u: none at x %d, least %d, slop %d", (int)kind,
              shape_kind, (int)x, (int)least, (int)slop);
    tally.ticks++;
    // A second look after a tremble of 1 LSB.
    at.x += random_range(r, -1, 1);
    CHECK(gjk2_collider_move(&body, &at) == GJK_OK);
    CHECK(gjk2_chain_contacts(&chain, &body, NULL, 300, before, FOUND, &count_before) == GJK_OK);
    for (int i = 0; i < count_before; i++) {
      for (int k = 0; k < before[i].manifold.count; k++) {
        const bool kept = has_contact(found, count, before[i].segment, before[i].manifold.contact[k].id);
        tally.kept += kept;
        tally.lost += !kept;
      }
    }
    x += speed;
    turn += rolls ? speed * 2 : 0;
    if (x > vertices[0].x - 200000) {
      x = vertices[n - 1].x + 200000;
    }
  }
}

// A convex polygon as a loop and as a collider: the loop's nearest contact is that of the collider.
static void check_loop(random_state *r, int32_t size) {
  static plane_body pair[2];
  static gjk2_vec loop[PLANE_VERTICES + 1];
  uint16_t corners, count = 0;
  gjk2_chain chain;
  gjk2_chain_contact found[FOUND];
  gjk2_distance_result truth, line;
  plane_random_pair(r, size, size * 3 / 2, pair);
  const gjk2_collider *body = &pair[1].collider;
  const gjk2_shape solid = GJK2_POLYGON(pair[0].vertices, (uint16_t)(3 + random_below(r, 10)));
  pair[0].shape = solid;
  const gjk2_rotation none = {GJK_Q30_ONE, 0};
  pair[0].pose.rotation = none;
  CHECK(gjk2_polygon_order(pair[0].vertices, solid.count, loop, &corners) == GJK_OK);
  if (corners < 3) {
    return;
  }
  plane_place(&pair[0], true);
  loop[corners] = loop[0];
  memset(&chain, 0, sizeof chain);
  CHECK(gjk2_chain_init(&chain, loop, (uint16_t)(corners + 1), &pair[0].pose.position) == GJK_OK);
  CHECK(gjk2_signed_distance(&pair[0].collider, body, NULL, &truth) == GJK_OK);
  const gjk_q16 margin = random_range(r, 0, size);
  uint16_t segment = 0;
  CHECK(gjk2_chain_contacts(&chain, body, NULL, margin, found, FOUND, &count) == GJK_OK);
  CHECK(gjk2_chain_distance(&chain, body, NULL, &line, &segment) == GJK_OK);
  if (!truth.intersecting) {
    CHECK_MSG(line.distance == truth.distance, "%d, truth %d", line.distance, truth.distance);
  }
  // The normal's line through the loop's farthest corner must not have the centre behind it.
  int64_t top = INT64_MIN;
  for (int i = 0; i < corners; i++) {
    const int64_t x = (int64_t)loop[i].x + pair[0].pose.position.x, y = (int64_t)loop[i].y + pair[0].pose.position.y;
    const int64_t along = (x - body->centre.x) * truth.normal.x + (y - body->centre.y) * truth.normal.y;
    top = along > top ? along : top;
  }
  if (top > -(INT64_C(4) << 30) || truth.distance >= margin) {
    return;
  }
  gjk_q16 nearest = INT32_MAX;
  long double off = 9;
  for (int i = 0; i < count; i++) {
    const gjk2_vec n = {truth.normal.x, truth.normal.y};
    const gjk2_manifold *m = &found[i].manifold;
    CHECK(is_of_surface(&chain, &found[i]));
    for (int k = 0; k < m->count; k++) {
      if (abs(m->contact[k].distance - truth.distance) <= 4) {
        const long double angle = angle_between(&m->normal, n);
        off = angle < off ? angle : off;
        nearest = truth.distance;
      }
      nearest = m->contact[k].distance < nearest ? m->contact[k].distance : nearest;
    }
  }
  tally.met += truth.intersecting;
  tally.apart += !truth.intersecting;
  // Deep in the loop the nearest edge may be one whose box the body does not meet.
  if (off >= 9 && -truth.distance > size / 4) {
    CHECK_MSG(nearest <= truth.distance, "%d, nearest %d of %d", truth.distance, nearest, count);
    tally.deeper++;
    return;
  }
  CHECK_MSG(off < 9, "no contact of %d %d: %d, nearest %d, of %d", truth.normal.x, truth.normal.y, truth.distance,
            nearest, count);
}

int main(void) {
  const uint64_t seed = check_seed(SEED);
  for (unsigned long i = 0; i < SLIDES; i++) {
    random_state r = random_seed(seed + i);
    check_trial(i, NULL, NULL);
    slide(&r);
  }
  const int32_t sizes[] = {3, 40, 1000, 65536, 1 << 22, 1 << 26};
  for (unsigned long i = 0; i < LOOPS; i++) {
    random_state r = random_seed(~(seed + i));
    check_trial(i, NULL, NULL);
    check_loop(&r, sizes[random_below(&r, 6)]);
  }
  printf("%lu ticks, %lu contacts of segments, %lu of joints; ids kept %lu, lost %lu; loops met %lu, apart %lu\n",
         tally.ticks, tally.faces, tally.joints, tally.kept, tally.lost, tally.met, tally.apart);
  return check_done("plane_chain");
}
