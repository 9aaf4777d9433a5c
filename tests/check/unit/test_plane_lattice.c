// The true ceiling of iterations in the plane, by exhaustive search: all convex polygons with corners on a small
// lattice, in all pairs, at all offsets that bring them together or near each other.
//
//   test_plane_lattice [SIDE STEP CORNERS]
//
// on a lattice of SIDE x SIDE points, offsets in whole steps of it, or with STEP 2 in halves, polygons of up to CORNERS
// corners. Without arguments: 3 x 3 in halves, then 4 x 4 up to 4 corners. A then comes in one of its eight turned and
// mirrored forms, which differ in nothing but the choice between equals.
//
// Prints the most iterations by numbers of corners, beside the proven bound. Every decision is compared with separating
// axes in plain integers.
#include "plane.h"

#define CORNERS_MAX 8
#define SIDE_MAX 6
#define SHAPES_MAX 40000

typedef struct lattice_shape {
  int count;
  plane_point corner[CORNERS_MAX];  // in order
  gjk2_vec vertices[CORNERS_MAX], buffer[CORNERS_MAX];
  gjk2_shape shape;
  gjk2_collider collider;
} lattice_shape;

// What was needed most by two numbers of corners.
typedef struct ceiling {
  unsigned long pairs;
  unsigned distance, intersect, signed_distance, warm;
} ceiling;

static lattice_shape *shapes;
static unsigned shape_count;
static ceiling most[CORNERS_MAX + 1][CORNERS_MAX + 1];
static unsigned long together, apart;

// The polygon that has just these corners, if they all are corners. Its lowest coordinates are 0.
static bool find_corners(const plane_point *chosen, int count, plane_point *hull) {
  plane_point points[CORNERS_MAX], corners[CORNERS_MAX + 2];
  int64_t x = chosen[0].x, y = chosen[0].y;
  for (int i = 0; i < count; i++) {
    points[i] = chosen[i];
    x = chosen[i].x < x ? chosen[i].x : x;
    y = chosen[i].y < y ? chosen[i].y : y;
  }
  const int found = count == 1 ? 1 : plane_hull(points, count, corners);
  if (count == 1) {
    corners[0] = chosen[0];
  }
  memcpy(hull, corners, (size_t)count * sizeof *hull);
  return x == 0 && y == 0 && found == count;
}

// Adds the polygon. Every second one gets its vertices clockwise, which the library takes for vertices in no order.
static void add_shape(const plane_point *corner, int count, int step) {
  const gjk2_pose identity = GJK2_POSE_IDENTITY;
  CHECK(shape_count < SHAPES_MAX);
  if (shape_count == SHAPES_MAX) {
    return;
  }
  lattice_shape *s = &shapes[shape_count++];
  s->count = count;
  for (int i = 0; i < count; i++) {
    s->corner[i].x = step * corner[i].x;
    s->corner[i].y = step * corner[i].y;
  }
  for (int i = 0; i < count; i++) {
    const plane_point *p = &s->corner[shape_count % 2 == 0 ? i : count - 1 - i];
    s->vertices[i].x = (gjk_q16)p->x;
    s->vertices[i].y = (gjk_q16)p->y;
  }
  s->shape = (gjk2_shape)GJK2_POLYGON(s->vertices, (uint16_t)count);
  CHECK(gjk2_collider_init(&s->collider, &s->shape, s->buffer, CORNERS_MAX) == GJK_OK);
  CHECK(gjk2_collider_pose(&s->collider, &identity) == GJK_OK);
}

// All polygons of count corners on the lattice, but for translation.
static void find_shapes(int side, int count, int step) {
  int index[CORNERS_MAX];
  plane_point chosen[CORNERS_MAX], corner[CORNERS_MAX];
  const int points = side * side;
  for (int i = 0; i < count; i++) {
    index[i] = i;
  }
  for (;;) {
    for (int i = 0; i < count; i++) {
      chosen[i].x = index[i] % side;
      chosen[i].y = index[i] / side;
    }
    if (find_corners(chosen, count, corner)) {
      add_shape(corner, count, step);
    }
    int last = count - 1;
    while (last >= 0 && index[last] == points - count + last) {
      last--;
    }
    if (last < 0) {
      return;
    }
    index[last]++;
    for (int i = last + 1; i < count; i++) {
      index[i] = index[i - 1] + 1;
    }
  }
}

static void project(const lattice_shape *s, int64_t x, int64_t y, int64_t *low, int64_t *high) {
  *low = *high = s->corner[0].x * x + s->corner[0].y * y;
  for (int i = 1; i < s->count; i++) {
    const int64_t along = s->corner[i].x * x + s->corner[i].y * y;
    *low = along < *low ? along : *low;
    *high = along > *high ? along : *high;
  }
}

// An axis and the range of B - A along it. They are apart along it at an offset of B beyond the range.
typedef struct axis {
  int64_t x, y, low, high;
} axis;

static void add_axis(const lattice_shape *a, const lattice_shape *b, int64_t x, int64_t y, axis *out) {
  int64_t low[2], high[2];
  project(a, x, y, &low[0], &high[0]);
  project(b, x, y, &low[1], &high[1]);
  out->x = x;
  out->y = y;
  out->low = low[1] - high[0];
  out->high = high[1] - low[0];
}

// The edges of both, what is straight across them, and the axes of the lattice, for two points.
static int find_axes(const lattice_shape *a, const lattice_shape *b, axis *out) {
  int count = 0;
  add_axis(a, b, 1, 0, &out[count++]);
  add_axis(a, b, 0, 1, &out[count++]);
  for (int side = 0; side < 2; side++) {
    const lattice_shape *s = side == 0 ? a : b;
    for (int i = 0; s->count > 1 && i < s->count; i++) {
      const plane_point p = s->corner[i], q = s->corner[(i + 1) % s->count];
      add_axis(a, b, q.y - p.y, p.x - q.x, &out[count++]);
      if (s->count == 2) {
        add_axis(a, b, q.x - p.x, q.y - p.y, &out[count++]);
      }
    }
  }
  return count;
}

static bool is_apart(const axis *axes, int count, int x, int y) {
  bool found = false;
  for (int i = 0; i < count && !found; i++) {
    const int64_t along = axes[i].x * x + axes[i].y * y;
    found = axes[i].low + along > 0 || axes[i].high + along < 0;
  }
  return found;
}

static void raise_to(unsigned *highest, unsigned iterations) {
  *highest = iterations > *highest ? iterations : *highest;
}

// Conditions are counted once a pair of shapes: so many calls of CHECK would cost more than the queries.
static bool check_offset(const lattice_shape *a, gjk2_collider *b, int x, int y, bool truth, gjk2_cache *cache,
                         ceiling *c) {
  const gjk2_vec at = {x, y};
  gjk2_decision decision;
  gjk2_distance_result cold, deep, warm;
  bool right = gjk2_collider_move(b, &at) == GJK_OK && gjk2_intersect(&a->collider, b, NULL, &decision) == GJK_OK &&
               gjk2_distance(&a->collider, b, NULL, &cold) == GJK_OK &&
               gjk2_distance(&a->collider, b, cache, &warm) == GJK_OK &&
               gjk2_signed_distance(&a->collider, b, NULL, &deep) == GJK_OK;
  right = right && decision.yes == truth && cold.intersecting == truth && warm.intersecting == truth &&
          deep.intersecting == truth && warm.distance == cold.distance && (truth || deep.distance == cold.distance);
  raise_to(&c->intersect, decision.iterations);
  raise_to(&c->distance, cold.iterations);
  raise_to(&c->warm, warm.iterations);
  raise_to(&c->signed_distance, deep.iterations);
  together += truth;
  apart += !truth;
  return right;
}

static void check_shapes(const lattice_shape *a, const lattice_shape *b, int reach) {
  static axis axes[2 + 2 * (CORNERS_MAX + 2)];
  gjk2_collider moved = b->collider;
  gjk2_cache cache = {0};
  ceiling *c = &most[a->count][b->count];
  const int count = find_axes(a, b, axes);
  bool right = true;
  for (int x = -reach; x <= reach; x++) {
    for (int y = -reach; y <= reach; y++) {
      right = check_offset(a, &moved, x, y, !is_apart(axes, count, x, y), &cache, c) && right;
    }
  }
  CHECK(right);
  c->pairs++;
}

static void show(int corners_most) {
  printf("corners         pairs   bound   distance   with a cache   intersect   signed distance\n");
  for (int n = 1; n <= corners_most; n++) {
    for (int m = 1; m <= corners_most; m++) {
      const ceiling *c = &most[n][m];
      const unsigned bound = GJK2_ITERATIONS_OF((unsigned)n, (unsigned)m);
      if (c->pairs > 0) {
        printf("%3d, %d%15lu%8u%11u%15u%12u%18u\n", n, m, c->pairs, bound, c->distance, c->warm, c->intersect,
               c->signed_distance);
        CHECK(c->distance <= bound);
        CHECK(c->warm <= bound);
        CHECK(c->intersect <= bound);
        CHECK(c->signed_distance <= bound);
      }
    }
  }
}

// Does no turned or mirrored form of the polygon come before it?
static bool is_first_form(const lattice_shape *s) {
  int64_t own = 0, least = INT64_MAX;
  for (int form = 0; form < 8; form++) {
    plane_point p[CORNERS_MAX];
    int64_t x = INT64_MAX, y = INT64_MAX, key = 0;
    for (int i = 0; i < s->count; i++) {
      const int64_t u = (form & 1) != 0 ? -s->corner[i].x : s->corner[i].x;
      const int64_t v = (form & 2) != 0 ? -s->corner[i].y : s->corner[i].y;
      p[i].x = (form & 4) != 0 ? v : u;
      p[i].y = (form & 4) != 0 ? u : v;
      x = p[i].x < x ? p[i].x : x;
      y = p[i].y < y ? p[i].y : y;
    }
    for (int i = 0; i < s->count; i++) {
      key |= INT64_C(1) << ((p[i].y - y) * SIDE_MAX + p[i].x - x);
    }
    own = form == 0 ? key : own;
    least = key < least ? key : least;
  }
  return own == least;
}

// whole: A comes in all its forms.
static void search(int side, int step, int corners_most, bool whole) {
  const unsigned every = (unsigned)(100 / check_trials(100));  // of the shapes of A
  shape_count = 0;
  for (int n = 1; n <= corners_most; n++) {
    find_shapes(side, n, step);
  }
  printf("%d x %d points, offsets of 1/%d: %u polygons\n", side, side, step, shape_count);
  for (unsigned a = 0; a < shape_count; a += every) {
    for (unsigned b = 0; b < shape_count && (whole || is_first_form(&shapes[a])); b++) {
      check_shapes(&shapes[a], &shapes[b], side * step);
    }
  }
}

int main(int argc, char **argv) {
  const int side = argc == 4 ? atoi(argv[1]) : 3, step = argc == 4 ? atoi(argv[2]) : 2;
  const int corners_most = argc == 4 ? atoi(argv[3]) : CORNERS_MAX;
  if ((argc != 1 && argc != 4) || side < 2 || side > SIDE_MAX || step < 1 || step > 2 || corners_most < 1 ||
      corners_most > CORNERS_MAX) {
    fputs("usage: test_plane_lattice [SIDE STEP CORNERS]\n", stderr);
    return 2;
  }
  shapes = calloc(SHAPES_MAX, sizeof *shapes);
  if (shapes == NULL) {
    return 2;
  }
  search(side, step, corners_most, argc == 4);
  if (argc == 1) {
    search(4, 1, 4, false);
  }
  show(corners_most);
  printf("%lu together, %lu apart\n", together, apart);
  CHECK(together > 0 && apart > 0);
  free(shapes);
  return check_done("plane lattice");
}
