// Chains: bodies slide and roll over 1,000 joints and meet no normal but the ground's; convex loops against the same
// polygons as colliders; each decision against a plain reading of the contract, by many directions.
#include "gjk2/chain.h"

#include "placed2.h"
#include "plane.h"

#define SEED 2013
#define JOINTS 1000
#define SLIDES check_trials(160)
#define LOOPS check_trials(30000)
#define GROUNDS check_trials(30000)
#define FOUND 64

static struct { unsigned long ticks, faces, joints, kept, lost, met, apart, deeper, segments, silent, behind; } tally;

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
  return (gjk2_vec){p.x - q.x, p.y - q.y};
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
  const int i = (int)c->segment;
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

// Is each point on the body opposite the one on the ground, by its distance along the normal?
static bool points_are_opposite(const gjk2_chain_contact *c) {
  bool opposite = true;
  for (int k = 0; k < c->manifold.count; k++) {
    const gjk2_contact *p = &c->manifold.contact[k];
    const long double x = ldexpl((long double)c->manifold.normal.x * p->distance, -30);
    const long double y = ldexpl((long double)c->manifold.normal.y * p->distance, -30);
    opposite = opposite && fabsl((long double)p->point_b.x - p->point_a.x - x) <= 4 &&
               fabsl((long double)p->point_b.y - p->point_a.y - y) <= 4;
  }
  return opposite;
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
  gjk2_chain chain = {0};
  gjk2_collider body = {0};
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
      CHECK(m->count >= 1 && m->count <= 2 && points_are_opposite(&found[i]));
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
        const bool kept = has_contact(found, count, (uint16_t)before[i].segment, before[i].manifold.contact[k].id);
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
  gjk2_chain chain = {0};
  gjk2_chain_contact found[FOUND];
  gjk2_distance_result truth, line;
  plane_random_pair(r, size, size * 3 / 2, pair);
  const gjk2_collider *body = &pair[1].collider;
  const gjk2_shape solid = GJK2_POLYGON(pair[0].vertices, (uint16_t)(3 + random_below(r, 10)));
  pair[0].shape = solid;
  pair[0].pose.rotation = (gjk2_rotation){GJK_Q30_ONE, 0};
  CHECK(gjk2_polygon_order(pair[0].vertices, solid.count, loop, &corners) == GJK_OK);
  if (corners < 3) {
    return;
  }
  plane_place(&pair[0], true);
  loop[corners] = loop[0];
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
    CHECK(is_of_surface(&chain, &found[i]) && points_are_opposite(&found[i]));
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
  if (off >= 9 && -truth.distance > size / 8) {
    CHECK_MSG(nearest <= truth.distance, "%d, nearest %d of %d", truth.distance, nearest, count);
    tally.deeper++;
    return;
  }
  CHECK_MSG(off < 9, "no contact of %d %d: %d, nearest %d, of %d", truth.normal.x, truth.normal.y, truth.distance,
            nearest, count);
}

// How far a body with vertices reaches along n / |n| from p.
static long double reach_of(const gjk2_collider *body, long double nx, long double ny, plane_point p) {
  plane_point v[PLANE_VERTICES];
  const int n = plane_vertices(body, v);
  const long double length = hypotl(nx, ny);
  long double least = INFINITY;
  for (int i = 0; i < n; i++) {
    const long double along = ((v[i].x - p.x) * nx + (v[i].y - p.y) * ny) / length;
    least = along < least ? along : least;
  }
  return least - body->shape->convex_radius;
}

static plane_point placed(const gjk2_chain *chain, int i) {
  return (plane_point){(int64_t)chain->vertices[i].x + chain->position.x,
                       (int64_t)chain->vertices[i].y + chain->position.y};
}

static bool same_contact(const gjk2_chain_contact *p, const gjk2_chain_contact *q) {
  bool same = p->segment == q->segment && p->manifold.count == q->manifold.count &&
              p->manifold.normal.x == q->manifold.normal.x && p->manifold.normal.y == q->manifold.normal.y &&
              p->manifold.feature_a == q->manifold.feature_a && p->manifold.feature_b == q->manifold.feature_b;
  for (int k = 0; k < p->manifold.count && same; k++) {
    const gjk2_contact *a = &p->manifold.contact[k], *b = &q->manifold.contact[k];
    same = a->id == b->id && a->distance == b->distance && a->point_a.x == b->point_a.x &&
           a->point_a.y == b->point_a.y && a->point_b.x == b->point_b.x && a->point_b.y == b->point_b.y;
  }
  return same;
}

static gjk_q16 least_of(const gjk2_chain_contact *c) {
  const gjk2_contact *k = c->manifold.contact;
  return c->manifold.count == 1 || k[0].distance < k[1].distance ? k[0].distance : k[1].distance;
}

// Room for fewer: the deepest are kept, of equals the first, in order.
static void check_capacity(const gjk2_chain *chain, const gjk2_collider *body, gjk_q16 margin,
                           const gjk2_chain_contact *all, uint16_t count) {
  gjk2_chain_contact some[FOUND];
  for (uint16_t capacity = 0; capacity <= count + 1; capacity++) {
    uint16_t kept = 999, k = 0;
    const gjk_status status = gjk2_chain_contacts(chain, body, NULL, margin, some, capacity, &kept);
    CHECK(status == (capacity < count ? GJK_ERROR_CAPACITY : GJK_OK));
    CHECK(kept == (capacity < count ? capacity : count));
    for (uint16_t i = 0; i < count; i++) {
      int before = 0;
      for (uint16_t j = 0; j < count; j++) {
        before += least_of(&all[j]) < least_of(&all[i]) || (least_of(&all[j]) == least_of(&all[i]) && j < i);
      }
      if (before < capacity) {
        CHECK(k < kept && same_contact(&some[k], &all[i]));
        k++;
      }
    }
  }
}

static void check_ranges(random_state *r, const gjk2_chain *chain, const gjk2_collider *body, gjk_q16 margin,
                         const gjk2_chain_contact *all, uint16_t count) {
  const uint16_t segments = (uint16_t)(chain->count - 1), cut = (uint16_t)random_below(r, segments + 1u);
  const gjk2_chain_range parts[2] = {{0, cut}, {cut, (uint16_t)(segments - cut)}};
  uint16_t k = 0;
  for (int i = 0; i < 2; i++) {
    gjk2_chain_contact some[FOUND];
    uint16_t n;
    CHECK(gjk2_chain_contacts(chain, body, &parts[i], margin, some, FOUND, &n) == GJK_OK);
    for (uint16_t j = 0; j < n; j++, k++) {
      CHECK(k < count && same_contact(&some[j], &all[k]));
    }
  }
  CHECK(k == count);
}

// A chain of a few vertices in any order, crossing itself, with tips and repeated vertices, and any body.
static void check_any(random_state *r, int32_t size) {
  static plane_body pair[2];
  gjk2_vec v[14];
  gjk2_chain chain = {0};
  gjk2_chain_contact found[FOUND];
  uint16_t n = (uint16_t)random_range(r, 3, 12), count = 0;
  plane_random_pair(r, size, size, pair);
  const gjk2_collider *body = &pair[1].collider;
  for (int i = 0; i < n; i++) {
    v[i] = plane_random_vec(r, size);
    if (i > 0 && random_below(r, 5) == 0) {
      v[i] = v[i - 1 - (int)random_below(r, 2) * (i > 1)];
    }
  }
  if (random_below(r, 2) == 0) {
    v[n] = v[0];
    n++;
  }
  const gjk_q16 margin = random_range(r, 0, size);
  const gjk_status status = gjk2_chain_init(&chain, v, n, &body->centre);
  CHECK(status == GJK_OK || status == GJK_ERROR_EMPTY);
  if (status != GJK_OK) {
    return;
  }
  CHECK(gjk2_chain_contacts(&chain, body, NULL, margin, found, FOUND, &count) == GJK_OK);
  for (uint16_t i = 0; i < count; i++) {
    const gjk2_manifold *m = &found[i].manifold;
    const int s = (int)found[i].segment;
    const plane_point p = placed(&chain, s), q = placed(&chain, s + 1), c = {body->centre.x, body->centre.y};
    const bool face = m->feature_a == 256;
    CHECK(i == 0 || (int)found[i - 1].segment <= s);
    CHECK(is_of_surface(&chain, &found[i]) && points_are_opposite(&found[i]));
    CHECK(!face || plane_cross(p, q, c) <= 0);
    const long double nx = m->normal.x, ny = m->normal.y;
    const long double reach = reach_of(body, face ? q.y - p.y : nx, face ? p.x - q.x : ny, m->feature_a == 1 ? q : p);
    const gjk_q16 least = least_of(&found[i]);
    const long double slack = 4 + ldexpl(size, -26);
    CHECK_MSG(face ? least >= reach - slack : fabsl(least - reach) <= slack, "%Lf, %d", reach, least);
    CHECK(least <= margin);
    // An edge of the body is named by its lower vertex, then its higher one.
    CHECK(face || (m->contact[0].id & 255) != 255 || (m->feature_b & 255) < m->feature_b >> 8);
    tally.faces += face;
    tally.joints += !face;
  }
  if (random_below(r, 8) == 0) {
    check_capacity(&chain, body, margin, found, count);
    check_ranges(r, &chain, body, margin, found, count);
  }
}

// A body in a room, a clockwise convex loop: each wall that a corner is behind, and across from, has a contact that deep.
static void check_room(random_state *r, int32_t size) {
  static plane_body pair[2];
  gjk2_vec loop[PLANE_VERTICES + 1];
  gjk2_chain chain = {0};
  gjk2_chain_contact found[FOUND];
  uint16_t corners, count = 0;
  plane_random_pair(r, size, size / 2, pair);
  const gjk2_collider *body = &pair[1].collider;
  CHECK(gjk2_polygon_order(pair[0].vertices, (uint16_t)(3 + random_below(r, 10)), loop, &corners) == GJK_OK);
  if (corners < 3) {
    return;
  }
  for (int i = 0; i < corners / 2; i++) {
    const gjk2_vec v = loop[i];
    loop[i] = loop[corners - 1 - i];
    loop[corners - 1 - i] = v;
  }
  loop[corners] = loop[0];
  CHECK(gjk2_chain_init(&chain, loop, (uint16_t)(corners + 1), &pair[0].pose.position) == GJK_OK);
  CHECK(gjk2_chain_contacts(&chain, body, NULL, 0, found, FOUND, &count) == GJK_OK);
  plane_point v[PLANE_VERTICES];
  const int n = plane_vertices(body, v);
  gjk2_aabb box;
  CHECK(gjk2_collider_aabb(body, &box) == GJK_OK);
  for (int s = 0; s < corners; s++) {
    const plane_point p = placed(&chain, s), q = placed(&chain, s + 1), c = {body->centre.x, body->centre.y};
    const long double nx = q.y - p.y, ny = p.x - q.x, reach = reach_of(body, nx, ny, p);
    bool across = false,
         meets = !((p.x < box.lower.x && q.x < box.lower.x) || (p.x > box.upper.x && q.x > box.upper.x) ||
                   (p.y < box.lower.y && q.y < box.lower.y) || (p.y > box.upper.y && q.y > box.upper.y));
    for (int i = 0; i < n; i++) {
      const int64_t height = (v[i].x - p.x) * (q.y - p.y) + (v[i].y - p.y) * (p.x - q.x);
      const long double at = ((v[i].x - p.x) * -ny + (v[i].y - p.y) * nx) / (nx * nx + ny * ny);
      across = across || (height / hypotl(nx, ny) - body->shape->convex_radius <= reach + 1e-9L && at >= 0 && at <= 1);
    }
    const gjk2_chain_contact *own = NULL;
    for (uint16_t i = 0; i < count; i++) {
      own = (int)found[i].segment == s && found[i].manifold.feature_a == 256 ? &found[i] : own;
      CHECK(found[i].manifold.feature_a == 256);
    }
    const bool front = plane_cross(p, q, c) <= 0;
    CHECK(own == NULL || front);
    tally.behind += !front;
    if (front && across && meets && reach < -1) {
      tally.segments++;
      CHECK_MSG(own != NULL && fabsl(least_of(own) - reach) <= 4, "wall %d: %Lf", s, reach);
    } else {
      tally.silent += own == NULL;
    }
  }
}

// A floor, a wall at its left, a ledge, open ends: what the contract says in words.
static void check_words(void) {
  static const gjk2_vec line[] = {{100000, 0}, {0, 0}, {0, 50000}, {-80000, 50000}};
  const gjk2_shape shape = GJK2_BOX(10000, 10000), ball = GJK2_CIRCLE(10000);
  gjk2_chain chain = {0};
  gjk2_chain_contact c[8];
  uint16_t n = 0;
  CHECK(gjk2_chain_init(&chain, line, 4, &origin) == GJK_OK);
  gjk2_collider box = placed2(&shape, 0, 0), circle = placed2(&ball, 0, 0);
  const struct {
    gjk2_vec at;
    bool round;
    uint16_t count;
    struct {
      uint16_t segment, feature;
      uint8_t points;
      gjk_q16 least;
    } expected[2];
  } cases[] = {
      {{50000, 9900}, false, 1, {{0, 256, 2, -100}}},                    // on the floor
      {{9800, 9900}, false, 2, {{0, 256, 2, -100}, {1, 256, 2, -200}}},  // in the corner
      {{50000, -100}, false, 0, {{0}}},                                  // its centre in the floor
      {{50000, 0}, false, 1, {{0, 256, 2, -10000}}},                     // its centre on the line
      {{-7000, 59900}, false, 1, {{2, 256, 2, -100}}},                   // over the ledge by a part
      {{9800, 59900}, false, 1, {{2, 256, 1, -100}}},                    // almost off it
      {{9950, 59900}, false, 1, {{1, 256, 1, -50}}},                     // sooner off it to the side
      {{3000, 59000}, true, 1, {{2, 0, 1, -513}}},                       // a ball over the ledge's joint
      {{-80000 - 6000, 57000}, true, 1, {{2, 1, 1, -780}}},              // and over its open end
      {{100000 + 6000, 7000}, true, 1, {{0, 0, 1, -780}}},               // and over the floor's
      {{100000 + 6000, -7000}, true, 0, {{0}}},                          // behind it
      {{-20000, 30000}, false, 0, {{0}}},                                // inside
  };
  for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    gjk2_collider *body = cases[i].round ? &circle : &box;
    CHECK(gjk2_collider_move(body, &cases[i].at) == GJK_OK);
    CHECK(gjk2_chain_contacts(&chain, body, NULL, 0, c, 8, &n) == GJK_OK);
    CHECK_MSG(n == cases[i].count, "%d", n);
    for (uint16_t k = 0; k < n && k < cases[i].count; k++) {
      CHECK_MSG(c[k].segment == cases[i].expected[k].segment, "%d", c[k].segment);
      CHECK_MSG(c[k].manifold.feature_a == cases[i].expected[k].feature, "%d", c[k].manifold.feature_a);
      CHECK_MSG(c[k].manifold.count == cases[i].expected[k].points, "case %u: %d", i, c[k].manifold.count);
      CHECK_MSG(least_of(&c[k]) == cases[i].expected[k].least, "%d", least_of(&c[k]));
    }
  }
  bool yes;
  uint16_t segment = 9;
  gjk2_distance_result d;
  const gjk2_vec above = {50000, 12000}, inside = {-20000, 30000};
  CHECK(gjk2_collider_move(&box, &above) == GJK_OK);
  CHECK(gjk2_chain_intersect(&chain, &box, NULL, &yes, &segment) == GJK_OK && !yes && segment == 9);
  CHECK(gjk2_chain_distance(&chain, &box, NULL, &d, &segment) == GJK_OK && d.distance == 2000 && segment == 0);
  CHECK(gjk2_collider_move(&box, &inside) == GJK_OK);
  CHECK(gjk2_chain_distance(&chain, &box, NULL, &d, &segment) == GJK_OK && d.distance == 10000 && segment == 1);
  const gjk2_vec lifted = {0, 2001};
  CHECK(gjk2_chain_move(&chain, &lifted) == GJK_OK);
  CHECK(gjk2_collider_move(&box, &above) == GJK_OK);
  CHECK(gjk2_chain_intersect(&chain, &box, NULL, &yes, &segment) == GJK_OK && yes && segment == 0);
}

// A chain that turns back on itself: its tip has all directions of half a turn.
static void check_tip(void) {
  static const gjk2_vec blade[] = {{0, 0}, {100000, 0}, {0, 0}};
  const gjk2_shape ball = GJK2_CIRCLE(10000), box = GJK2_BOX(10000, 10000);
  const gjk2_vec places[] = {{106000, 3000}, {106000, -3000}, {110000, 0}, {50000, 9000}, {50000, -9000}};
  const struct {
    uint16_t segment, feature;
    gjk_q16 least;
  } expected[] = {{1, 0, -3292}, {1, 0, -3292}, {1, 0, 0}, {1, 256, -1000}, {0, 256, -1000}};
  gjk2_chain chain = {0};
  gjk2_chain_contact c[4];
  CHECK(gjk2_chain_init(&chain, blade, 3, &origin) == GJK_OK);
  for (int kind = 0; kind < 2; kind++) {
    gjk2_collider body = placed2(kind == 0 ? &ball : &box, 0, 0);
    for (int i = kind == 0 ? 0 : 3; i < 5; i++) {
      uint16_t n = 0;
      CHECK(gjk2_collider_move(&body, &places[i]) == GJK_OK);
      CHECK(gjk2_chain_contacts(&chain, &body, NULL, 0, c, 4, &n) == GJK_OK);
      CHECK_MSG(n == 1 && c[0].segment == expected[i].segment && c[0].manifold.feature_a == expected[i].feature &&
                    least_of(&c[0]) == expected[i].least,
                "kind %d, place %d: %d contacts, segment %d, feature %d, %d deep", kind, i, n, c[0].segment,
                c[0].manifold.feature_a, (int)least_of(&c[0]));
    }
  }
}

// What just touches: a body whose box ends where a joint or the whole chain does; an ellipse beyond an open end.
static void check_limits(void) {
  static const gjk2_vec ridge[] = {{100000, 0}, {0, 50000}, {-100000, 0}};
  const gjk2_shape point = GJK2_POINT, oval = GJK2_ELLIPSE(10000, 10000);
  const gjk2_vec above = {0, 50100}, left = {-100000, 0}, right = {100000, 0}, beside = {100000 + 9000, 3000};
  gjk2_chain chain = {0};
  gjk2_chain_contact c[4];
  uint16_t n = 0, segment = 9;
  bool yes = false;
  CHECK(gjk2_chain_init(&chain, ridge, 3, &origin) == GJK_OK);
  gjk2_collider body = placed2(&point, above.x, above.y);
  CHECK(gjk2_chain_contacts(&chain, &body, NULL, 100, c, 4, &n) == GJK_OK);
  CHECK(n == 1 && c[0].segment == 1 && c[0].manifold.feature_a == 0 && least_of(&c[0]) == 100);
  CHECK(gjk2_chain_contacts(&chain, &body, NULL, 99, c, 4, &n) == GJK_OK && n == 0);
  CHECK(gjk2_collider_move(&body, &left) == GJK_OK);
  CHECK(gjk2_chain_intersect(&chain, &body, NULL, &yes, &segment) == GJK_OK && yes && segment == 1);
  CHECK(gjk2_collider_move(&body, &right) == GJK_OK);
  CHECK(gjk2_chain_intersect(&chain, &body, NULL, &yes, &segment) == GJK_OK && yes && segment == 0);
  body = placed2(&oval, beside.x, beside.y);
  CHECK(gjk2_chain_contacts(&chain, &body, NULL, 0, c, 4, &n) == GJK_OK);
  CHECK(n == 1 && c[0].segment == 0 && c[0].manifold.feature_a == 0 && is_of_surface(&chain, &c[0]));
  CHECK(points_are_opposite(&c[0]));
  CHECK_MSG(abs(least_of(&c[0]) + 513) <= 3, "%d", (int)least_of(&c[0]));
}

// An ellipse over a joint that turns by less than its normal may err has a contact, at its distance but for rounding.
static void check_flat_joint(random_state *r) {
  static const gjk2_vec flat[3] = {{INT32_C(1) << 26, -1}, {0, 0}, {-(INT32_C(1) << 26), -1}};
  const gjk2_shape ellipse = GJK2_ELLIPSE(random_range(r, 100, 3000), random_range(r, 100, 3000));
  const gjk2_pose pose = {origin, plane_random_rotation(r)};
  gjk2_collider c = posed2(&ellipse, &pose);
  gjk2_chain chain = {0};
  gjk2_aabb box;
  CHECK(gjk2_chain_init(&chain, flat, 3, &origin) == GJK_OK && gjk2_collider_aabb(&c, &box) == GJK_OK);
  for (int32_t x = -900; x <= 900; x++) {
    const gjk2_vec at = {x, 5 - box.lower.y};
    gjk2_chain_contact found[4];
    gjk2_distance_result gap;
    uint16_t count = 0, segment;
    gjk_q16 least = INT32_MAX;
    CHECK(gjk2_collider_move(&c, &at) == GJK_OK);
    CHECK(gjk2_chain_contacts(&chain, &c, NULL, 20, found, 4, &count) == GJK_OK && count > 0);
    CHECK(gjk2_chain_distance(&chain, &c, NULL, &gap, &segment) == GJK_OK);
    for (unsigned i = 0; i < count; i++) {
      const gjk_q16 own = least_of(&found[i]);
      least = own < least ? own : least;
    }
    CHECK(least <= gap.distance + 2 && least >= gap.distance - 2);
  }
}

static void check_arguments(void) {
  static const gjk2_vec line[] = {{100, 0}, {0, 0}, {0, 0}}, long_line[] = {{GJK2_RADIUS_MAX + 1, 0}, {0, 0}};
  const gjk2_shape ball = GJK2_CIRCLE(10);
  const gjk2_vec far = {INT32_MAX - 99, 0};
  gjk2_pose pose = GJK2_POSE_IDENTITY;
  gjk2_chain chain, raw;
  gjk2_collider body = {0}, unposed;
  gjk2_chain_contact out;
  gjk2_distance_result d;
  uint16_t n = 77, segment;
  bool yes;
  memset(&chain, 0, sizeof chain);
  memset(&raw, 0, sizeof raw);
  CHECK(gjk2_collider_init(&body, &ball, NULL, 0) == GJK_OK);
  unposed = body;
  CHECK(gjk2_collider_pose(&body, &pose) == GJK_OK);
  CHECK(gjk2_chain_init(NULL, line, 2, &origin) == GJK_ERROR_NULL);
  CHECK(gjk2_chain_init(&chain, NULL, 2, &origin) == GJK_ERROR_NULL);
  CHECK(gjk2_chain_init(&chain, line, 2, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_chain_init(&chain, line, 0, &origin) == GJK_ERROR_EMPTY);
  CHECK(gjk2_chain_init(&chain, line, 1, &origin) == GJK_ERROR_EMPTY);
  CHECK(gjk2_chain_init(&chain, line + 1, 2, &origin) == GJK_ERROR_EMPTY);
  CHECK(gjk2_chain_init(&chain, long_line, 2, &origin) == GJK_ERROR_SIZE);
  CHECK(gjk2_chain_init(&chain, line, 2, &far) == GJK_ERROR_RANGE);
  static const gjk2_vec upright[] = {{0, 100}, {0, 0}}, tall[] = {{0, GJK2_RADIUS_MAX + 1}, {0, 0}};
  static const gjk2_vec back[] = {{0, 0}, {GJK2_RADIUS_MAX + 1, 0}}, below[] = {{0, 0}, {-100, -100}};
  const gjk2_vec high = {0, INT32_MAX - 99}, low = {0, INT32_MIN + 99}, left = {INT32_MIN + 99, 0};
  CHECK(gjk2_chain_init(&chain, upright, 2, &high) == GJK_ERROR_RANGE);
  CHECK(gjk2_chain_init(&chain, below, 2, &low) == GJK_ERROR_RANGE);
  CHECK(gjk2_chain_init(&chain, below, 2, &left) == GJK_ERROR_RANGE);
  CHECK(gjk2_chain_init(&chain, tall, 2, &origin) == GJK_ERROR_SIZE);
  CHECK(gjk2_chain_init(&chain, back, 2, &origin) == GJK_ERROR_SIZE);
  static const gjk2_vec longest[] = {{0, 0}, {GJK2_RADIUS_MAX, -GJK2_RADIUS_MAX}, {0, 0}};
  gjk2_chain other = {0};
  CHECK(gjk2_chain_init(&other, longest, 3, &origin) == GJK_OK && other.closed);
  CHECK(memcmp(&chain, &raw, sizeof chain) == 0);
  CHECK(gjk2_chain_move(&chain, &origin) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk2_chain_init(&chain, line, 3, &origin) == GJK_OK);
  CHECK(gjk2_chain_move(NULL, &origin) == GJK_ERROR_NULL);
  CHECK(gjk2_chain_move(&chain, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_chain_move(&chain, &far) == GJK_ERROR_RANGE);
  const gjk2_chain_range whole = {0, 2}, beyond = {1, 2}, flat = {1, 1}, none = {2, 0};
  CHECK(gjk2_chain_contacts(NULL, &body, NULL, 0, &out, 1, &n) == GJK_ERROR_NULL);
  CHECK(gjk2_chain_contacts(&chain, NULL, NULL, 0, &out, 1, &n) == GJK_ERROR_NULL);
  CHECK(gjk2_chain_contacts(&chain, &body, NULL, 0, NULL, 1, &n) == GJK_ERROR_NULL);
  CHECK(gjk2_chain_contacts(&chain, &body, NULL, 0, &out, 1, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_chain_contacts(&raw, &body, NULL, 0, &out, 1, &n) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk2_chain_contacts(&chain, &unposed, NULL, 0, &out, 1, &n) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk2_chain_contacts(&chain, &body, NULL, -1, &out, 1, &n) == GJK_ERROR_NEGATIVE);
  CHECK(gjk2_chain_contacts(&chain, &body, NULL, GJK2_RADIUS_MAX + 1, &out, 1, &n) == GJK_ERROR_RANGE);
  CHECK(gjk2_chain_contacts(&chain, &body, &beyond, 0, &out, 1, &n) == GJK_ERROR_RANGE);
  CHECK(n == 77);
  CHECK(gjk2_chain_contacts(&chain, &body, &whole, GJK2_RADIUS_MAX, &out, 1, &n) == GJK_OK && n == 1);
  CHECK(gjk2_chain_contacts(&chain, &body, &none, 0, &out, 1, &n) == GJK_OK && n == 0);
  CHECK(gjk2_chain_intersect(&chain, &body, NULL, NULL, &segment) == GJK_ERROR_NULL);
  CHECK(gjk2_chain_intersect(&chain, &body, NULL, &yes, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_chain_intersect(&chain, &body, &beyond, &yes, &segment) == GJK_ERROR_RANGE);
  CHECK(gjk2_chain_intersect(&raw, &body, NULL, &yes, &segment) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk2_chain_distance(&chain, &body, NULL, NULL, &segment) == GJK_ERROR_NULL);
  CHECK(gjk2_chain_distance(&chain, &body, NULL, &d, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_chain_distance(&chain, &unposed, NULL, &d, &segment) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk2_chain_distance(&chain, &body, &flat, &d, &segment) == GJK_ERROR_EMPTY);
  CHECK(gjk2_chain_distance(&chain, &body, &whole, &d, &segment) == GJK_OK && d.intersecting && segment == 0);
}

int main(void) {
  const uint64_t seed = check_seed(SEED);
  for (unsigned long i = 0; i < SLIDES; i++) {
    random_state r = random_seed(seed + i);
    check_trial(i, NULL, NULL);
    slide(&r);
  }
  const int32_t sizes[] = {3, 40, 1000, 65536, 1 << 22, 1 << 26};
  check_words();
  check_tip();
  check_limits();
  check_arguments();
  for (unsigned long i = 0; i < GROUNDS; i++) {
    random_state r = random_seed(~(seed + i) << 20);
    check_trial(i, NULL, NULL);
    check_any(&r, sizes[random_below(&r, 6)]);
    check_room(&r, sizes[random_below(&r, 6)]);
    if (i < 20) {
      check_flat_joint(&r);
    }
  }
  for (unsigned long i = 0; i < LOOPS; i++) {
    random_state r = random_seed(~(seed + i));
    check_trial(i, NULL, NULL);
    check_loop(&r, sizes[random_below(&r, 6)]);
  }
  printf(
      "%lu ticks, %lu contacts of segments, %lu of joints; ids kept %lu, lost %lu; loops met %lu, apart %lu, deeper "
      "%lu; walls %lu, silent %lu, behind %lu\n",
      tally.ticks, tally.faces, tally.joints, tally.kept, tally.lost, tally.met, tally.apart, tally.deeper,
      tally.segments, tally.silent, tally.behind);
  CHECK(tally.lost * 200 <= tally.kept);
  CHECK(tally.joints * 100 > tally.faces && tally.faces > LOOPS / 4);
  CHECK(tally.met > LOOPS / 20 && tally.apart > LOOPS / 20 && tally.deeper * 10 < tally.met);
  CHECK(tally.segments > GROUNDS / 10 && tally.silent > GROUNDS / 10 && tally.behind > GROUNDS / 100);
  return check_done("plane_chain");
}
