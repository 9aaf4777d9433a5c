// Ground of the plane: chains, height profiles and grids of tiles. The outline of a grid against the solids of its tiles,
// quarter by quarter. Each query against the same asked of every segment alone, two-sided, with the contract read plainly.
#include "gjk2/ground.h"

#include "filled.h"
#include "placed2.h"
#include "plane.h"

#define SEED 2311
#define GRIDS check_trials_least(1500, 60)
#define ASKED check_trials_least(6000, 300)
#define LINES 4096
#define FOUND 256

static struct {
  unsigned long pieces, surfaces, near, far, ahead, behind, contacts, hits, misses, rays, ends, turned, skipped,
      grazing, outlines;
} tally;

typedef struct line {
  gjk2_vec p, q;
  uint32_t number;
} line;

static line lines[LINES];
static unsigned line_count;

static void take_line(void *user, const gjk2_vec *from, const gjk2_vec *to, uint32_t segment) {
  (void)user;
  if (line_count < LINES) {
    lines[line_count].p = *from;
    lines[line_count].q = *to;
    lines[line_count].number = segment;
  }
  line_count++;
}

static const gjk2_aabb everywhere = {{INT32_MIN, INT32_MIN}, {INT32_MAX, INT32_MAX}};

static void list_lines(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_aabb *box) {
  line_count = 0;
  CHECK(gjk2_ground_visit(ground, pose, box, take_line, NULL) == GJK_OK);
  CHECK(line_count <= LINES);
}

// A grid at random.
#define COLUMNS 20
#define ROWS 6
#define FORMS 24

static uint8_t cells[COLUMNS * ROWS];
static gjk2_tile forms[FORMS];
static gjk2_tiles grid;
static gjk2_ground ground;
static gjk2_shape shape;

static void make_grid(random_state *r, bool one_way) {
  static const gjk2_tile common[] = {GJK2_TILE(0, 0), GJK2_TILE(4, 4), GJK2_TILE(2, 2), GJK2_TILE(0, 4),
                                     GJK2_TILE(4, 0), GJK2_TILE(0, 2), GJK2_TILE(2, 4), GJK2_TILE_CEILING(2, 2)};
  const uint32_t empty = random_below(r, 80), full = empty + random_below(r, 100 - empty);
  for (unsigned i = 0; i < FORMS; i++) {
    forms[i].left = (uint8_t)random_below(r, 6);
    forms[i].right = (uint8_t)random_below(r, 6);
    forms[i].turns = (uint8_t)random_below(r, 6);
    forms[i].one_way = one_way && random_below(r, 5) == 0;
    if (i < sizeof common / sizeof common[0]) {
      forms[i] = common[i];
    }
  }
  grid.columns = (uint16_t)(1 + random_below(r, COLUMNS));
  grid.rows = (uint16_t)(1 + random_below(r, ROWS));
  grid.size = 4 * random_range(r, 1000, 40000);
  grid.cells = cells;
  grid.forms = forms;
  grid.form_count = FORMS;
  for (unsigned i = 0; i < COLUMNS * ROWS; i++) {
    const uint32_t lot = random_below(r, 100);
    cells[i] = (uint8_t)(lot < empty ? 0 : lot < full ? 1 : random_below(r, FORMS + 2));
  }
  CHECK(gjk2_ground_of_tiles(&grid, &ground, &shape) == GJK_OK);
}

// Is a point, in 64ths of a tile, in a solid? It lies on no side.
static bool is_in_solid(int x, int y) {
  const int column = x >= 0 ? x / 64 : -1, row = y >= 0 ? y / 64 : -1;
  if (column < 0 || row < 0 || column >= grid.columns || row >= grid.rows) {
    return false;
  }
  const uint8_t number = cells[row * grid.columns + column];
  if (number >= FORMS || forms[number].one_way) {
    return false;
  }
  const gjk2_tile *f = &forms[number];
  int u = x - 64 * column, v = y - 64 * row;
  for (unsigned i = 0; i < (f->turns & 3u); i++) {  // turn the point back
    const int w = v;
    v = 64 - u;
    u = w;
  }
  const int left = f->left < 4 ? f->left : 4, right = f->right < 4 ? f->right : 4;
  return 64 * v < 16 * (left * (64 - u) + right * u);
}

// How many of the lines hold a piece of an axis' side, from (x, y), a quarter long, in this direction?
static unsigned lines_with_piece(int x, int y, int dx, int dy) {
  const int32_t quarter = grid.size / 4;
  unsigned count = 0;
  for (unsigned i = 0; i < line_count; i++) {
    const gjk2_vec p = lines[i].p, q = lines[i].q;
    const int64_t way_x = (int64_t)q.x - p.x, way_y = (int64_t)q.y - p.y;
    const int64_t from_x = (int64_t)x * quarter - p.x, from_y = (int64_t)y * quarter - p.y;
    const int64_t to_x = from_x + dx * quarter, to_y = from_y + dy * quarter;
    const bool in_line =
        way_x * from_y == way_y * from_x && way_x * to_y == way_y * to_x && way_x * dx + way_y * dy > 0;
    const int64_t start = from_x * way_x + from_y * way_y, end = to_x * way_x + to_y * way_y;
    count += in_line && start >= 0 && end <= way_x * way_x + way_y * way_y;
  }
  return count;
}

// The pieces of sides along x and y are those with solid on the left and none on the right.
static void check_pieces(bool one_way) {
  for (int y = 0; y <= 4 * grid.rows; y++) {
    for (int x = 0; x < 4 * grid.columns; x++) {
      const bool above = is_in_solid(16 * x + 8, 16 * y + 1), below = is_in_solid(16 * x + 8, 16 * y - 1);
      if (y % 4 != 0 && above != below) {
        continue;  // a flat surface within a tile, or a slope near its end
      }
      CHECK(lines_with_piece(x, y, 1, 0) == (above && !below ? 1 : 0) || one_way || y % 4 != 0);
      CHECK(lines_with_piece(x + 1, y, -1, 0) == (below && !above ? 1 : 0) || one_way || y % 4 != 0);
      tally.pieces += above != below;
    }
  }
  for (int x = 0; x <= 4 * grid.columns; x++) {
    for (int y = 0; y < 4 * grid.rows; y++) {
      const bool right = is_in_solid(16 * x + 1, 16 * y + 8), left = is_in_solid(16 * x - 1, 16 * y + 8);
      if (x % 4 == 0 && !one_way) {
        CHECK(lines_with_piece(x, y, 0, 1) == (left && !right ? 1 : 0));
        CHECK_MSG(lines_with_piece(x, y + 1, 0, -1) == (right && !left ? 1 : 0), "(%d, %d): %u, %ux%u", x, y,
                  lines_with_piece(x, y + 1, 0, -1), grid.columns, grid.rows);
      }
    }
  }
}

// Each line has a tile with a solid on its left.
static void check_sides(void) {
  const double eighth = grid.size / 8.0;
  for (unsigned i = 0; i < line_count; i++) {
    const double way_x = lines[i].q.x - (double)lines[i].p.x, way_y = lines[i].q.y - (double)lines[i].p.y;
    const double at = 0.4571, x = (lines[i].p.x + at * way_x) / eighth, y = (lines[i].p.y + at * way_y) / eighth;
    const double length = hypot(way_x, way_y) * 64;
    // A 64th of an eighth of a tile away, at a place that is no tile's corner.
    const double left_x = x - way_y / length, left_y = y + way_x / length;
    const int number = cells[(int)(left_y / 8) * grid.columns + (int)(left_x / 8)];
    CHECK(left_x > 0 && left_y > 0 && (int)(left_x / 8) < grid.columns && (int)(left_y / 8) < grid.rows);
    CHECK(number < FORMS && !forms[number].one_way);
    tally.surfaces++;
  }
}

// Does a segment whose box meets another share a point with that? Then corners of it are on both sides of its line.
static bool crosses(gjk2_vec p, gjk2_vec q, const gjk2_aabb *box) {
  int left = 0, right = 0;
  for (int i = 0; i < 4; i++) {
    const gjk2_vec c = {i % 2 == 0 ? box->lower.x : box->upper.x, i < 2 ? box->lower.y : box->upper.y};
    const int64_t side = ((int64_t)q.x - p.x) * ((int64_t)c.y - p.y) - ((int64_t)q.y - p.y) * ((int64_t)c.x - p.x);
    left += side > 0;
    right += side < 0;
  }
  return left < 4 && right < 4;
}

// The segments near a box are all that share a point with it, and others whose boxes meet it.
static void check_near(random_state *r, const gjk2_pose *pose) {
  static line all[LINES];
  list_lines(&ground, pose, &everywhere);
  const unsigned count = line_count;
  memcpy(all, lines, count * sizeof all[0]);
  for (int trial = 0; trial < 4 && count > 0; trial++) {
    const line *at = &all[random_below(r, count)];
    const int32_t size = random_range(r, 0, 1 << random_below(r, 24));
    const gjk2_aabb box = {{at->p.x - random_range(r, 0, size), at->p.y - random_range(r, 0, size)},
                           {at->p.x + random_range(r, 0, size), at->p.y + random_range(r, 0, size)}};
    unsigned expected = 0;
    list_lines(&ground, pose, &box);
    for (unsigned i = 0; i < count; i++) {
      const gjk2_vec p = all[i].p, q = all[i].q;
      const bool meets = !((p.x > box.upper.x && q.x > box.upper.x) || (p.x < box.lower.x && q.x < box.lower.x) ||
                           (p.y > box.upper.y && q.y > box.upper.y) || (p.y < box.lower.y && q.y < box.lower.y));
      bool found = false;
      for (unsigned k = 0; k < line_count; k++) {
        found = found || (lines[k].number == all[i].number &&
                          plane_compare(&(plane_point){lines[k].p.x, lines[k].p.y}, &(plane_point){p.x, p.y}) == 0 &&
                          lines[k].q.x == q.x && lines[k].q.y == q.y);
      }
      CHECK_MSG(found ? meets : !(meets && crosses(p, q, &box)), "segment %u (%d, %d)-(%d, %d), found %d",
                all[i].number, p.x, p.y, q.x, q.y, found);
      expected += found;
      tally.near += meets;
      tally.far += !meets;
    }
    CHECK(line_count == expected);
  }
}

static gjk2_pose any_pose(random_state *r) {
  gjk2_pose pose = GJK2_POSE_IDENTITY;
  pose.position = plane_random_vec(r, 1000000);
  if (random_below(r, 2) == 0) {
    pose.rotation = plane_random_rotation(r);
    tally.turned++;
  }
  return pose;
}

static void check_grids(random_state *random) {
  const gjk2_pose identity = GJK2_POSE_IDENTITY;
  for (unsigned long i = 0; i < GRIDS; i++) {
    check_trial(i, NULL, NULL);
    const bool one_way = random_below(random, 3) == 0;
    make_grid(random, one_way);
    list_lines(&ground, &identity, &everywhere);
    check_pieces(one_way);
    if (!one_way) {
      check_sides();
    }
    const gjk2_pose pose = any_pose(random);
    check_near(random, &pose);
  }
}

// Chains and profiles.
#define VERTICES 400

static gjk2_vec vertices[VERTICES];
static int16_t heights[VERTICES];
static gjk2_index_box boxes[GJK2_INDEX_BOXES(VERTICES)];
static gjk2_index chain_index;
static gjk2_polyline polyline;
static gjk2_heights profile;
static gjk2_chain chain;

static void make_chain(random_state *r, bool indexed) {
  const gjk2_vec origin = {0, 0};
  const int32_t step = random_range(r, 2, 40000);
  uint16_t n = (uint16_t)(2 + random_below(r, 1 + random_below(r, VERTICES - 2)));
  vertices[0].x = vertices[0].y = 0;
  for (unsigned i = 1; i < n; i++) {
    vertices[i].x = vertices[i - 1].x - random_range(r, i % 7 == 0 ? -step : 0, step);
    vertices[i].y = vertices[i - 1].y + random_range(r, -step, step);
    if (random_below(r, 20) == 0) {
      vertices[i] = vertices[i - 1];
    }
  }
  vertices[1].x -= 1;
  if (n > 4 && random_below(r, 3) == 0) {
    vertices[n - 1] = vertices[0];
  }
  memset(&chain, 0, sizeof chain);
  CHECK(gjk2_chain_init(&chain, vertices, n, &origin) == GJK_OK);
  polyline.vertices = vertices;
  polyline.count = n;
  polyline.index = NULL;
  if (indexed) {
    CHECK(gjk2_index_build(&polyline, boxes, sizeof boxes / sizeof boxes[0], &chain_index) == GJK_OK);
    polyline.index = &chain_index;
  }
  CHECK(gjk2_ground_of_chain(&polyline, &ground, &shape) == GJK_OK);
}

static void make_profile(random_state *r) {
  const int32_t rough = random_range(r, 1, 4000);
  profile.count = (uint16_t)(2 + random_below(r, VERTICES - 2));
  profile.width = random_range(r, 1, 60000);
  profile.shift = (uint8_t)random_below(r, 5);
  profile.heights = heights;
  for (unsigned i = 0; i < profile.count; i++) {
    heights[i] = (int16_t)(i > 1 && random_below(r, 12) == 0 ? GJK2_HOLE : random_range(r, -rough, rough));
  }
  CHECK(gjk2_ground_of_heights(&profile, &ground, &shape) == GJK_OK);
}

static bool is_front(const line *l, gjk2_vec c) {
  return ((int64_t)l->q.y - l->p.y) * ((int64_t)c.x - l->p.x) - ((int64_t)l->q.x - l->p.x) * ((int64_t)c.y - l->p.y) >=
         0;
}

static plane_body body;

// A segment as a triangle, posed where it is.
static gjk2_vec corners[3];
static const gjk2_shape segment_shape = GJK2_TRIANGLE(corners);

static void set_segment(const line *l, gjk2_collider *out) {
  const gjk2_pose identity = GJK2_POSE_IDENTITY;
  corners[0] = l->p;
  corners[1] = corners[2] = l->q;
  *out = posed2(&segment_shape, &identity);
}

static void check_distances(random_state *r, const gjk2_pose *pose) {
  gjk2_distance_result best = {.distance = 0}, result;
  gjk2_decision decision;
  uint32_t nearest = 0, segment;
  bool any = false, yes, found, touches = false;
  const gjk_q16 reach = random_range(r, 0, 1 << random_below(r, 18));
  for (unsigned i = 0; i < line_count; i++) {
    gjk2_collider c;
    if (!is_front(&lines[i], body.collider.centre)) {
      tally.behind++;
      continue;
    }
    tally.ahead++;
    set_segment(&lines[i], &c);
    CHECK(gjk2_distance(&c, &body.collider, NULL, &result) == GJK_OK);
    CHECK(gjk2_within(&c, &body.collider, reach, NULL, &decision) == GJK_OK);
    touches = touches || decision.yes;
    if (!any || result.distance < best.distance || (result.distance == best.distance && lines[i].number < nearest)) {
      best = result;
      nearest = lines[i].number;
    }
    any = true;
  }
  CHECK(gjk2_ground_within(&ground, pose, &body.collider, reach, &yes) == GJK_OK);
  CHECK(yes == touches);
  CHECK(gjk2_ground_distance(&ground, pose, &body.collider, &result, &segment, &found) == GJK_OK);
  CHECK(found == any);
  if (any) {
    CHECK_MSG(result.distance == best.distance && segment == nearest, "%d of %u, %d of %u", result.distance, segment,
              best.distance, nearest);
    CHECK(result.intersecting == best.intersecting);
  }
}

// Of a chain at no rotation the contacts are those of gjk2_chain_contacts.
static void check_chain_contacts(random_state *r) {
  static gjk2_chain_contact of_chain[FOUND], of_ground[FOUND];
  gjk2_pose pose = GJK2_POSE_IDENTITY;
  uint16_t count = 0, expected = 0;
  const gjk_q16 margin = random_range(r, 0, 5000);
  pose.position = plane_random_vec(r, 1000000);
  gjk2_vec at = vertices[random_below(r, polyline.count)];
  body.pose.position.x = at.x + pose.position.x + random_range(r, -60000, 60000);
  body.pose.position.y = at.y + pose.position.y + random_range(r, -60000, 60000);
  CHECK(gjk2_collider_pose(&body.collider, &body.pose) == GJK_OK);
  CHECK(gjk2_chain_move(&chain, &pose.position) == GJK_OK);
  const uint16_t room = (uint16_t)(random_below(r, 4) == 0 ? random_below(r, 3) : FOUND);
  const gjk_status status = gjk2_chain_contacts(&chain, &body.collider, NULL, margin, of_chain, room, &expected);
  CHECK(gjk2_ground_contacts(&ground, &pose, &body.collider, margin, of_ground, room, &count) == status);
  CHECK(count == expected);
  for (unsigned i = 0; i < count; i++) {
    const gjk2_manifold *m = &of_ground[i].manifold, *n = &of_chain[i].manifold;
    CHECK(of_ground[i].segment == of_chain[i].segment && m->count == n->count && m->normal.x == n->normal.x &&
          m->normal.y == n->normal.y && m->feature_a == n->feature_a && m->feature_b == n->feature_b);
    for (unsigned k = 0; k < m->count; k++) {
      CHECK(m->contact[k].distance == n->contact[k].distance && m->contact[k].id == n->contact[k].id);
    }
    tally.contacts += m->count;
  }
}

// The first hit, two-sided, of those that come nearer and whose centre is in front then. Ghosts of joints are left to the
// query: its hit is one of these, and those before it are of no normal of the surface.
static void check_cast(random_state *r, const gjk2_pose *pose) {
  gjk2_cast_result hit, of_segment;
  uint32_t segment = 0;
  const gjk2_vec way = plane_random_vec(r, 400000);
  const gjk2_vec to = {body.pose.position.x + way.x, body.pose.position.y + way.y};
  const gjk2_cast_path path = {NULL, &to, random_below(r, 2) == 0 ? 0 : random_range(r, 0, 3000)};
  CHECK(gjk2_ground_cast(&ground, pose, &body.collider, &path, &hit, &segment) == GJK_OK);
  bool reported = false;
  for (unsigned i = 0; i < line_count; i++) {
    gjk2_collider c;
    set_segment(&lines[i], &c);
    CHECK(gjk2_cast(&c, &body.collider, &path, &of_segment) == GJK_OK);
    if (!of_segment.hit) {
      continue;
    }
    const double f = of_segment.fraction / (double)GJK_Q30_ONE;
    const double nx = (double)lines[i].q.y - lines[i].p.y, ny = (double)lines[i].p.x - lines[i].q.x;
    const double side = nx * (body.collider.centre.x + f * way.x - lines[i].p.x) +
                        ny * (body.collider.centre.y + f * way.y - lines[i].p.y);
    const double doubt = 1e-6 * hypot(nx, ny), nearer = nx * way.x + ny * way.y;
    const double along = of_segment.normal.x * -ny + of_segment.normal.y * nx;
    const bool own = fabs(along) < 16 * (fabs(nx) + fabs(ny));
    if (hit.hit && lines[i].number == segment && of_segment.fraction == hit.fraction) {
      reported = true;
      CHECK(side > -doubt);
      CHECK(of_segment.inside || nearer < 0 || !own);
    }
    // A hit from the front on the segment itself is met, or something before it.
    if (side > doubt && own && (nearer < 0 || of_segment.inside) && !of_segment.inside) {
      CHECK_MSG(hit.hit && hit.fraction <= of_segment.fraction, "segment %u at %.9f", lines[i].number, f);
    }
    if (side < -doubt) {
      tally.skipped++;
    }
    tally.grazing += nearer >= 0;
  }
  CHECK(reported == hit.hit);
  tally.hits += hit.hit;
  tally.misses += !hit.hit;
}

static void check_ray(random_state *r, const gjk2_pose *pose) {
  gjk2_cast_result hit, of_segment;
  uint32_t segment = 0, first = 0;
  const gjk2_vec from = body.pose.position;
  const gjk2_vec to = {from.x + random_range(r, -600000, 600000), from.y + random_range(r, -600000, 600000)};
  bool any = false;
  gjk_q30 fraction = 0;
  CHECK(gjk2_ground_cast_ray(&ground, pose, &from, &to, &hit, &segment) == GJK_OK);
  for (unsigned i = 0; i < line_count; i++) {
    gjk2_collider c;
    const int64_t nearer = ((int64_t)lines[i].q.y - lines[i].p.y) * ((int64_t)to.x - from.x) -
                           ((int64_t)lines[i].q.x - lines[i].p.x) * ((int64_t)to.y - from.y);
    set_segment(&lines[i], &c);
    CHECK(gjk2_cast_ray(&c, &from, &to, &of_segment) == GJK_OK);
    if (of_segment.hit && nearer < 0 && is_front(&lines[i], from) &&
        (!any || of_segment.fraction < fraction || (of_segment.fraction == fraction && lines[i].number < first))) {
      any = true;
      fraction = of_segment.fraction;
      first = lines[i].number;
    }
  }
  CHECK(hit.hit == any && (!any || (hit.fraction == fraction && segment == first)));
  tally.rays += any;
}

static void check_queries(random_state *random) {
  for (unsigned long i = 0; i < ASKED; i++) {
    check_trial(i, NULL, NULL);
    const uint32_t kind = random_below(random, 4);
    if (kind < 2) {
      make_chain(random, kind == 1);
    } else if (kind == 2) {
      make_profile(random);
    } else {
      make_grid(random, random_below(random, 2) == 0);
    }
    const gjk2_pose pose = any_pose(random);
    check_near(random, &pose);
    list_lines(&ground, &pose, &everywhere);
    if (line_count == 0) {
      continue;
    }
    plane_random_shape(random, 1 << (8 + random_below(random, 9)), &body);
    body.pose.rotation = plane_random_rotation(random);
    const line *at = &lines[random_below(random, line_count)];
    const int32_t spread = random_below(random, 3) == 0 ? 4000000 : 60000;
    body.pose.position.x = at->p.x + random_range(random, -spread, spread);
    body.pose.position.y = at->p.y + random_range(random, -spread, spread);
    plane_place(&body, true);
    if (gjk2_is_curved(body.collider.shape)) {
      continue;
    }
    check_distances(random, &pose);
    check_cast(random, &pose);
    check_ray(random, &pose);
    if (kind < 2) {
      check_chain_contacts(random);
    }
  }
}

// The outline of a grid as closed chains, one after the other. False: two solids meet at a corner alone, or there is no room.
#define LOOPS 24

static unsigned find_loops(gjk2_polyline loops[LOOPS]) {
  static gjk2_vec room[2 * LINES];
  static bool taken[LINES];
  unsigned count = 0, used = 0;
  memset(taken, 0, sizeof taken);
  for (unsigned i = 0; i < line_count; i++) {
    for (unsigned k = 0; k < line_count; k++) {
      const gjk2_vec at = lines[i].p, p = lines[k].p, q = lines[k].q;
      const int64_t turn = ((int64_t)q.x - p.x) * ((int64_t)at.y - p.y) - ((int64_t)q.y - p.y) * ((int64_t)at.x - p.x);
      const int64_t to_p = ((int64_t)p.x - at.x) * ((int64_t)p.x - q.x) + ((int64_t)p.y - at.y) * ((int64_t)p.y - q.y);
      const int64_t to_q = ((int64_t)q.x - at.x) * ((int64_t)q.x - p.x) + ((int64_t)q.y - at.y) * ((int64_t)q.y - p.y);
      // It is the same line's start, or its predecessor's end, alone.
      if (i != k && turn == 0 && to_p >= 0 && to_q > 0) {
        return 0;
      }
    }
  }
  for (unsigned first = 0; first < line_count; first++) {
    if (taken[first]) {
      continue;
    }
    if (count == LOOPS) {
      return 0;
    }
    unsigned at = first;
    loops[count].vertices = &room[used];
    loops[count].index = NULL;
    loops[count].count = 1;
    room[used++] = lines[first].p;
    do {
      unsigned next = 0;
      taken[at] = true;
      while (next < line_count && (lines[next].p.x != lines[at].q.x || lines[next].p.y != lines[at].q.y)) {
        next++;
      }
      CHECK(next < line_count);
      room[used++] = lines[at].q;
      loops[count].count++;
      at = next < line_count ? next : first;
    } while (at != first);
    count++;
  }
  return count;
}

static int compare_contacts(const void *p, const void *q) {
  const gjk2_contact *a = (const gjk2_contact *)p, *b = (const gjk2_contact *)q;
  const int32_t x[5] = {a->distance, a->point_a.x, a->point_a.y, a->point_b.x, a->point_b.y};
  const int32_t y[5] = {b->distance, b->point_a.x, b->point_a.y, b->point_b.x, b->point_b.y};
  for (int i = 0; i < 5; i++) {
    if (x[i] != y[i]) {
      return x[i] < y[i] ? -1 : 1;
    }
  }
  return 0;
}

static unsigned list_contacts(const gjk2_ground *of, const gjk2_pose *pose, gjk_q16 margin, gjk2_contact *out) {
  static gjk2_chain_contact found[FOUND];
  unsigned n = 0;
  uint16_t count = 0;
  CHECK(gjk2_ground_contacts(of, pose, &body.collider, margin, found, FOUND, &count) == GJK_OK);
  for (unsigned i = 0; i < count; i++) {
    for (unsigned k = 0; k < found[i].manifold.count; k++) {
      out[n++] = found[i].manifold.contact[k];
    }
  }
  return n;
}

// A grid has the contacts of its outline as chains: so its joints are those of the outline.
static void check_outlines(random_state *random) {
  const gjk2_pose identity = GJK2_POSE_IDENTITY;
  for (unsigned long i = 0; i < GRIDS; i++) {
    static gjk2_polyline loops[LOOPS];
    static gjk2_contact of_grid[4 * FOUND], of_loops[4 * FOUND * LOOPS];
    check_trial(i, NULL, NULL);
    make_grid(random, false);
    list_lines(&ground, &identity, &everywhere);
    const unsigned count = find_loops(loops);
    for (int trial = 0; trial < 6 && count > 0; trial++) {
      const line *at = &lines[random_below(random, line_count)];
      const int32_t size = grid.size;
      plane_random_shape(random, random_range(random, 1, size), &body);
      body.pose.rotation = plane_random_rotation(random);
      body.pose.position.x = at->p.x + random_range(random, -size, size);
      body.pose.position.y = at->p.y + random_range(random, -size, size);
      plane_place(&body, true);
      const gjk_q16 margin = random_range(random, 0, size / 8);
      const unsigned n = list_contacts(&ground, &identity, margin, of_grid);
      unsigned m = 0;
      for (unsigned k = 0; k < count; k++) {
        gjk2_ground loop;
        gjk2_shape made;
        CHECK(gjk2_ground_of_chain(&loops[k], &loop, &made) == GJK_OK);
        m += list_contacts(&loop, &identity, margin, &of_loops[m]);
      }
      qsort(of_grid, n, sizeof of_grid[0], compare_contacts);
      qsort(of_loops, m, sizeof of_loops[0], compare_contacts);
      CHECK_MSG(n == m, "%u and %u contacts", n, m);
      for (unsigned k = 0; k < n && k < m; k++) {
        CHECK(compare_contacts(&of_grid[k], &of_loops[k]) == 0);
      }
      tally.outlines += n > 0;
    }
  }
}

static void check_statuses(void) {
  const gjk2_pose identity = GJK2_POSE_IDENTITY;
  gjk2_pose far = identity, bent = identity;
  gjk2_ground out = {NULL, NULL, {0, 0}};
  gjk2_shape made;
  gjk2_collider c;
  uint32_t segment;
  bool yes;
  static const gjk2_vec one[2] = {{5, 5}, {5, 5}}, wide[2] = {{GJK_Q16(3000), GJK_Q16(2000)}, {0, 0}},
                        two[2] = {{GJK_Q16(1), 0}, {0, 0}};
  static const int16_t flat[3] = {0, 0, GJK2_HOLE}, holes[2] = {GJK2_HOLE, 0};
  static const uint8_t cell[4] = {1, 1, 1, 1};
  static const gjk2_tile full[2] = {GJK2_TILE(0, 0), GJK2_TILE(4, 4)};
  gjk2_polyline p = {one, 2, NULL};
  gjk2_heights h = {flat, 3, 100, 0};
  gjk2_tiles t = {cell, 2, 2, 400, 2, full};
  static gjk2_index_box room[4];
  gjk2_index small;
  CHECK(gjk2_ground_of_chain(NULL, &out, &made) == GJK_ERROR_NULL);
  CHECK(gjk2_ground_of_chain(&p, &out, &made) == GJK_ERROR_EMPTY);
  p.vertices = wide;
  CHECK(gjk2_ground_of_chain(&p, &out, &made) == GJK_ERROR_SIZE);
  p.vertices = two;
  CHECK(gjk2_index_build(&p, room, 3, &small) == GJK_ERROR_CAPACITY);
  CHECK(out.type == NULL);
  CHECK(gjk2_ground_of_chain(&p, &out, &made) == GJK_OK);
  CHECK(gjk2_collider_init(&c, &made, NULL, 0) == GJK_ERROR_UNSUPPORTED);
  CHECK(gjk2_ground_of_heights(&h, &out, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_ground_of_heights(&h, &out, &made) == GJK_OK);
  h.heights = holes;
  h.count = 2;
  CHECK(gjk2_ground_of_heights(&h, &out, &made) == GJK_ERROR_EMPTY);
  h.width = 0;
  CHECK(gjk2_ground_of_heights(&h, &out, &made) == GJK_ERROR_NEGATIVE);
  h.width = 1;
  h.shift = 14;
  CHECK(gjk2_ground_of_heights(&h, &out, &made) == GJK_ERROR_SIZE);
  CHECK(gjk2_ground_of_tiles(&t, &out, &made) == GJK_OK);
  t.size = 402;
  CHECK(gjk2_ground_of_tiles(&t, &out, &made) == GJK_ERROR_SIZE);
  t.size = 0;
  CHECK(gjk2_ground_of_tiles(&t, &out, &made) == GJK_ERROR_NEGATIVE);
  t.columns = 0;
  CHECK(gjk2_ground_of_tiles(&t, &out, &made) == GJK_ERROR_EMPTY);
  CHECK(gjk2_ground_of_chain(&p, &out, &made) == GJK_OK);
  plane_body point;
  point.shape = (gjk2_shape)GJK2_POINT;
  CHECK(gjk2_collider_init(&point.collider, &point.shape, NULL, 0) == GJK_OK);
  CHECK(gjk2_ground_within(&out, &identity, &point.collider, 0, &yes) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk2_collider_pose(&point.collider, &identity) == GJK_OK);
  CHECK(gjk2_ground_within(&out, &identity, &point.collider, -1, &yes) == GJK_ERROR_NEGATIVE);
  CHECK(gjk2_ground_within(&out, &identity, &point.collider, 0, &yes) == GJK_OK && yes);
  far.position.x = INT32_MAX;
  bent.rotation.c = 0;
  CHECK(gjk2_ground_within(&out, &far, &point.collider, 0, &yes) == GJK_ERROR_RANGE);
  CHECK(gjk2_ground_within(&out, &bent, &point.collider, 0, &yes) == GJK_ERROR_ROTATION);
  gjk2_cast_result hit;
  const gjk2_vec to = {0, -100};
  const gjk2_cast_path path = {NULL, &to, -1};
  CHECK(gjk2_ground_cast(&out, &identity, &point.collider, &path, &hit, &segment) == GJK_ERROR_NEGATIVE);
  CHECK(gjk2_ground_cast(&out, &identity, &point.collider, NULL, &hit, &segment) == GJK_ERROR_NULL);
  const gjk2_cast_path down = {NULL, &to, 0};
  gjk2_ground without[2] = {out, out};
  without[0].type = NULL;
  without[1].data = NULL;
  for (unsigned i = 0; i < 4; i++) {
    const gjk2_ground *bad = i < 2 ? &without[i] : i == 2 ? NULL : &out;
    const gjk2_pose *pose = i < 3 ? &identity : NULL;
    CHECK(gjk2_ground_within(bad, pose, &point.collider, 0, &yes) == GJK_ERROR_NULL);
    CHECK(gjk2_ground_cast(bad, pose, &point.collider, &down, &hit, &segment) == GJK_ERROR_NULL);
  }
}

// What the makers refuse; only OK writes.
static void check_makers(void) {
  static const gjk2_vec two[2] = {{GJK_Q16(1), 0}, {0, 0}}, apart[5] = {{GJK_Q16(3000), GJK_Q16(3000)},
                                                                        {GJK_Q16(1000), GJK_Q16(1000)},
                                                                        {0, 0},
                                                                        {GJK_Q16(-1000), GJK_Q16(-1000)},
                                                                        {GJK_Q16(-3000), GJK_Q16(-3000)}};
  static const int16_t hill[3] = {0, INT16_MAX, 0};
  static const uint8_t cell[1] = {0};
  static const gjk2_tile empty[1] = {GJK2_TILE(0, 0)};
  gjk2_index_box room[GJK2_INDEX_BOXES(2)];
  gjk2_ground out;
  gjk2_shape made;
  gjk2_index index, other;
  gjk2_polyline p = {two, 2, &index};
  gjk2_heights h = {hill, 1, GJK2_GROUND_REACH, 13};
  gjk2_tiles t = {cell, 1, 1, 4, 1, empty};
  memset(&out, POISON, sizeof out);
  memset(&made, POISON, sizeof made);
  memset(&index, POISON, sizeof index);
  CHECK(gjk2_index_build(&p, NULL, 9, &index) == GJK_ERROR_NULL &&
        gjk2_index_build(&p, room, 9, NULL) == GJK_ERROR_NULL);
  p.count = 0;
  CHECK(gjk2_index_build(&p, room, 9, &index) == GJK_ERROR_EMPTY && is_untouched(&index, sizeof index));
  CHECK(gjk2_ground_of_chain(&p, &out, &made) == GJK_ERROR_EMPTY);
  p.count = 2;
  CHECK(gjk2_index_build(&p, room, GJK2_INDEX_BOXES(2), &index) == GJK_OK);
  other = index;
  p.index = &other;
  other.corner.x++;
  CHECK(gjk2_ground_of_chain(&p, &out, &made) == GJK_ERROR_CORRUPT);
  other = index;
  other.segments++;
  CHECK(gjk2_ground_of_chain(&p, &out, &made) == GJK_ERROR_CORRUPT);
  other = index;
  room[0].upper_x--;
  CHECK(gjk2_ground_of_chain(&p, &out, &made) == GJK_ERROR_CORRUPT);
  room[0].upper_x++;
  CHECK(gjk2_ground_of_chain(&p, NULL, &made) == GJK_ERROR_NULL &&
        gjk2_ground_of_chain(&p, &out, NULL) == GJK_ERROR_NULL);
  // Each vertex and segment is within its limit, the box's corner is not.
  p.vertices = apart;
  p.count = 5;
  p.index = NULL;
  CHECK(gjk2_ground_of_chain(&p, &out, &made) == GJK_ERROR_SIZE);
  // Heights of 2^28: no vertex, and one beside a vertex within. A column beyond the last that fits.
  h.heights = hill + 1;
  CHECK(gjk2_ground_of_heights(&h, &out, &made) == GJK_ERROR_SIZE);
  h.heights = hill;
  h.count = 2;
  CHECK(gjk2_ground_of_heights(&h, &out, &made) == GJK_ERROR_SIZE);
  h.shift = 0;
  h.width = GJK2_GROUND_REACH + 1;
  CHECK(gjk2_ground_of_heights(&h, &out, &made) == GJK_ERROR_SIZE);
  h.heights = NULL;
  CHECK(gjk2_ground_of_heights(&h, &out, &made) == GJK_ERROR_NULL);
  CHECK(gjk2_ground_of_tiles(&t, NULL, &made) == GJK_ERROR_NULL &&
        gjk2_ground_of_tiles(&t, &out, NULL) == GJK_ERROR_NULL);
  t.cells = NULL;
  CHECK(gjk2_ground_of_tiles(&t, &out, &made) == GJK_ERROR_NULL);
  t.cells = cell;
  t.forms = NULL;
  CHECK(gjk2_ground_of_tiles(&t, &out, &made) == GJK_ERROR_NULL &&
        gjk2_ground_of_tiles(NULL, &out, &made) == GJK_ERROR_NULL);
  CHECK(is_untouched(&out, sizeof out) && is_untouched(&made, sizeof made));
}

static void take_none(void *user, const gjk2_vec *from, const gjk2_vec *to, uint32_t segment) {
  (void)from, (void)to, (void)segment;
  ++*(unsigned *)user;
}

// What the queries refuse; nothing is written then.
static void check_query_statuses(void) {
  static const gjk2_vec two[2] = {{GJK_Q16(1), 0}, {0, 0}};
  const gjk2_pose identity = GJK2_POSE_IDENTITY, far = {{0, INT32_MIN}, {GJK_Q30_ONE, 0}};
  const gjk2_polyline p = {two, 2, NULL};
  const gjk2_vec down = {0, -100}, below = {0, INT32_MIN};
  const gjk2_cast_path path = {NULL, &down, 0}, sinks = {&below, NULL, 0};
  const gjk2_aabb box = {{0, 0}, {1, 1}};
  gjk2_ground level;
  gjk2_shape made;
  plane_body point, raw;
  gjk2_distance_result away;
  gjk2_chain_contact contact;
  gjk2_cast_result hit;
  uint32_t segment;
  uint16_t count;
  bool found;
  unsigned seen = 0;
  CHECK(gjk2_ground_of_chain(&p, &level, &made) == GJK_OK);
  point.shape = raw.shape = (gjk2_shape)GJK2_POINT;
  CHECK(gjk2_collider_init(&point.collider, &point.shape, NULL, 0) == GJK_OK);
  CHECK(gjk2_collider_init(&raw.collider, &raw.shape, NULL, 0) == GJK_OK);
  CHECK(gjk2_collider_pose(&point.collider, &identity) == GJK_OK);
  const gjk2_collider *dot = &point.collider;
  memset(&away, POISON, sizeof away);
  memset(&contact, POISON, sizeof contact);
  memset(&hit, POISON, sizeof hit);
  memset(&segment, POISON, sizeof segment);
  memset(&count, POISON, sizeof count);
  memset(&found, 0, sizeof found);
  CHECK(gjk2_ground_within(&level, &identity, dot, 0, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_ground_distance(&level, &identity, dot, NULL, &segment, &found) == GJK_ERROR_NULL);
  CHECK(gjk2_ground_distance(&level, &identity, dot, &away, NULL, &found) == GJK_ERROR_NULL);
  CHECK(gjk2_ground_distance(&level, &identity, dot, &away, &segment, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_ground_distance(&level, &far, dot, &away, &segment, &found) == GJK_ERROR_RANGE);
  CHECK(gjk2_ground_distance(&level, &identity, &raw.collider, &away, &segment, &found) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk2_ground_contacts(&level, &identity, dot, 0, NULL, 1, &count) == GJK_ERROR_NULL);
  CHECK(gjk2_ground_contacts(&level, &identity, dot, 0, &contact, 1, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_ground_contacts(&level, &identity, dot, -1, &contact, 1, &count) == GJK_ERROR_NEGATIVE);
  CHECK(gjk2_ground_contacts(&level, &identity, dot, GJK2_RADIUS_MAX + 1, &contact, 1, &count) == GJK_ERROR_RANGE);
  CHECK(gjk2_ground_contacts(&level, &far, dot, -1, &contact, 1, &count) == GJK_ERROR_RANGE);
  CHECK(gjk2_ground_cast(&level, &identity, dot, &path, NULL, &segment) == GJK_ERROR_NULL);
  CHECK(gjk2_ground_cast(&level, &identity, dot, &path, &hit, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_ground_cast(&level, &identity, dot, &sinks, &hit, &segment) == GJK_ERROR_RANGE);
  CHECK(gjk2_ground_cast(&level, &identity, &raw.collider, &path, &hit, &segment) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk2_ground_cast_ray(&level, &identity, NULL, &down, &hit, &segment) == GJK_ERROR_NULL);
  CHECK(gjk2_ground_cast_ray(&level, &identity, &down, NULL, &hit, &segment) == GJK_ERROR_NULL);
  CHECK(gjk2_ground_cast_ray(&level, &identity, &down, &down, NULL, &segment) == GJK_ERROR_NULL);
  CHECK(gjk2_ground_cast_ray(&level, &identity, &down, &down, &hit, NULL) == GJK_ERROR_NULL);
  CHECK(gjk2_ground_cast_ray(&level, &far, &down, &down, &hit, &segment) == GJK_ERROR_RANGE);
  CHECK(gjk2_ground_visit(&level, &identity, NULL, take_none, &seen) == GJK_ERROR_NULL);
  CHECK(gjk2_ground_visit(&level, &identity, &box, NULL, &seen) == GJK_ERROR_NULL);
  CHECK(gjk2_ground_visit(&level, &far, &box, take_none, &seen) == GJK_ERROR_RANGE && seen == 0);
  CHECK(gjk2_ground_visit(&level, &identity, &box, take_none, &seen) == GJK_OK && seen == 1);
  CHECK(is_untouched(&away, sizeof away) && is_untouched(&contact, sizeof contact) && is_untouched(&hit, sizeof hit));
  CHECK(is_untouched(&segment, sizeof segment) && is_untouched(&count, sizeof count) && !found);
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  check_statuses();
  check_makers();
  check_query_statuses();
  check_grids(&random);
  check_queries(&random);
  check_outlines(&random);
  printf(
      "%lu pieces, %lu surfaces, %lu segments near, %lu far, %lu in front, %lu behind, %lu contacts, %lu hits, %lu "
      "misses, "
      "%lu from behind, %lu rays\n",
      tally.pieces, tally.surfaces, tally.near, tally.far, tally.ahead, tally.behind, tally.contacts, tally.hits,
      tally.misses, tally.skipped, tally.rays);
  CHECK(tally.pieces > 1000 && tally.surfaces > 500 && tally.near > 500 && tally.far > 500 && tally.ahead > 500 &&
        tally.behind > 500 && tally.contacts > 50 && tally.hits > 20 && tally.misses > 20 && tally.skipped > 20 &&
        tally.rays > 5 && tally.turned > 20 && tally.outlines > 20);
  return check_done("plane ground");
}
