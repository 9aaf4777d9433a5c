// Hulls with a table answer with the same bits as without: the same vertex for every direction, baked and lazy, and so
// the same queries. Tables that cannot be read are refused, and those that lack a vertex are not proven.
#include <math.h>
#include <string.h>

#include "check.h"
#include "gjk/gjk.h"
#include "parts_answers.h"
#include "random_vec.h"
#include "src/shape/gjk_hull_table.h"
#include "src/shape/gjk_shape_class.h"

#define SEED 4711
#define VERTICES 4096
#define ENTRIES 65535

typedef enum family { BALL, BLOCK, PLATE, LINE, LATTICE, PRISM, TINY, HUGE_BALL, REPEATED, POINT, FAMILIES } family;

static gjk_vec3 vertices[2][VERTICES], buffers[2][2][VERTICES];
static uint16_t entries[2][ENTRIES], ends[2][GJK_TABLE_CELLS(GJK_TABLE_LEVEL_MAX)];
static gjk_hull_table tables[2];
static gjk_shape plain[2], tabled[2];

// The colliders of a hull: without and with a table, baked and lazy.
typedef struct four {
  gjk_collider baked, lazy, baked_table, lazy_table;
} four;

static gjk_vec3 on_sphere(random_state *random, double radius) {
  for (;;) {
    const gjk_vec3 v = random_in_cube(random, INT32_C(1) << 20);
    const double length = sqrt((double)v.x * v.x + (double)v.y * v.y + (double)v.z * v.z);
    if (length > 1000 && length <= 1 << 20) {
      return (gjk_vec3){(int32_t)(v.x / length * radius), (int32_t)(v.y / length * radius),
                        (int32_t)(v.z / length * radius)};
    }
  }
}

static gjk_vec3 random_vertex(random_state *random, family of, unsigned i, unsigned count) {
  const double turn = 6.283185307179586 * (double)(i / 2) / (double)((count + 1) / 2);
  gjk_vec3 v = random_in_cube(random, 50000);
  switch (of) {
    case BALL: return on_sphere(random, 60000.0);
    case PLATE: v.z = 700; return v;
    case LINE: v.y = v.z = 2 * v.x; return v;
    case LATTICE:
      v = random_in_cube(random, 3);
      v.x *= 5000;
      v.y *= 5000;
      v.z *= 5000;
      return v;
    case PRISM:
      v.x = (int32_t)(40000 * cos(turn));
      v.y = (int32_t)(40000 * sin(turn));
      v.z = i % 2 == 0 ? -9000 : 9000;
      return v;
    case TINY: return random_in_cube(random, 4);
    case HUGE_BALL: return on_sphere(random, 4094.0 * 65536);
    case REPEATED: return i < 8 ? v : vertices[0][random_below(random, 8)];
    case POINT: v.x = v.y = v.z = -5; return v;
    case BLOCK:
    case FAMILIES: break;
  }
  return v;
}

// Makes hull number k: its vertices, the table, the shapes.
static void make_hull(random_state *random, family of, unsigned count, uint8_t level, int k) {
  const int32_t away = k == 0 && random_below(random, 3) == 0 ? INT32_C(1800000000) : 0;
  for (unsigned i = 0; i < count; i++) {
    vertices[k][i] = random_vertex(random, of, i, count);
    if (of == REPEATED && k == 1) {
      vertices[1][i] = vertices[1][i < 8 ? i : random_below(random, 8)];
    }
  }
  for (unsigned i = 0; i < count; i++) {
    vertices[k][i].x += away;
    vertices[k][i].z -= away;
  }
  while (gjk_hull_table_make(vertices[k], (uint16_t)count, level, entries[k], ENTRIES, ends[k]) != GJK_OK &&
         level > 0) {
    level--;  // GJK_ERROR_CAPACITY
  }
  const gjk_hull_table table = {entries[k], ends[k], level};
  const gjk_shape hull = GJK_ROUNDED_HULL(vertices[k], 0, 0), with = GJK_HULL_WITH_TABLE(vertices[k], 0, &tables[k]);
  tables[k] = table;
  plain[k] = hull;
  tabled[k] = with;
  plain[k].count = tabled[k].count = (uint16_t)count;
}

static gjk_pose random_pose(random_state *random) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  const gjk_quat q = {random_range(random, -1000, 1000), random_range(random, -1000, 1000),
                      random_range(random, -1000, 1000), random_range(random, 1, 1000)};
  if (random_below(random, 4) != 0) {
    CHECK(gjk_quat_normalize(&q, &pose.rotation) == GJK_OK);
  }
  return pose;
}

static bool place_four(four *f, int k, const gjk_pose *pose) {
  return gjk_collider_init(&f->baked, &plain[k], buffers[k][0], VERTICES) == GJK_OK &&
         gjk_collider_init(&f->lazy, &plain[k], NULL, 0) == GJK_OK &&
         gjk_collider_init(&f->baked_table, &tabled[k], buffers[k][1], VERTICES) == GJK_OK &&
         gjk_collider_init(&f->lazy_table, &tabled[k], NULL, 0) == GJK_OK &&
         gjk_collider_pose(&f->baked, pose) == GJK_OK && gjk_collider_pose(&f->lazy, pose) == GJK_OK &&
         gjk_collider_pose(&f->baked_table, pose) == GJK_OK && gjk_collider_pose(&f->lazy_table, pose) == GJK_OK;
}

// Any direction, one along an axis or a face's diagonal, or across two edges of the posed hull, so that many are equal.
static gjk_vec3 random_direction(random_state *random, const gjk_collider *baked) {
  gjk_vec3 d = {0, 0, 0};
  while ((d.x | d.y | d.z) == 0) {
    const gjk_vec3 *v[3];
    gjk_long3 n;
    gjk_search_direction rounded;
    switch (random_below(random, 4)) {
      case 0: d = random_in_cube(random, 1); break;
      case 1: d = random_in_cube(random, INT32_C(1) << random_below(random, 31)); break;
      case 2: d = on_sphere(random, 1073741823.0); break;
      default:
        for (int i = 0; i < 3; i++) {
          v[i] = &baked->buffer[random_below(random, baked->count)];
        }
        gjk_triangle_normal(v[0], v[1], v[2], &n);
        gjk_search_direction_of(&n, &rounded);
        d = rounded.d;
    }
  }
  return d;
}

static bool same_support(const gjk_support *a, const gjk_support *b) {
  return a->vertex == b->vertex && a->offset.x == b->offset.x && a->offset.y == b->offset.y &&
         a->offset.z == b->offset.z;
}

static gjk_support support_of(const gjk_collider *c, const gjk_vec3 *d) {
  gjk_support found = {{0, 0, 0}, 0};
  c->shape->type->support(c, d, &found);
  return found;
}

// Number of vertices that are as far along d as the farthest.
static unsigned farthest_count(const gjk_collider *baked, const gjk_vec3 *d) {
  const gjk_support found = support_of(baked, d);
  unsigned equal = 0;
  for (unsigned i = 0; i < baked->count; i++) {
    equal += gjk_dot(&baked->buffer[i], d) == gjk_dot(&found.offset, d);
  }
  return equal;
}

static void check_support(const four *f, const gjk_vec3 *d) {
  const gjk_support baked = support_of(&f->baked, d), lazy = support_of(&f->lazy, d);
  const gjk_support baked_table = support_of(&f->baked_table, d), lazy_table = support_of(&f->lazy_table, d);
  CHECK(same_support(&baked, &lazy));
  CHECK(same_support(&baked, &baked_table));
  CHECK(same_support(&baked, &lazy_table));
}

// Both refine along the exact normal of three far points, which d rounds. Returns whether that moved the support.
static bool check_refine(random_state *random, const four *f) {
  const gjk_vec3 a = random_in_cube(random, INT32_C(1) << 29), b = random_in_cube(random, INT32_C(1) << 29),
                 c = random_in_cube(random, INT32_C(1) << 29);
  const gjk_collider *const colliders[4] = {&f->baked, &f->lazy, &f->baked_table, &f->lazy_table};
  gjk_long3 n;
  gjk_search_direction rounded;
  gjk_support found[4];
  bool moved[4];
  gjk_triangle_normal(&a, &b, &c, &n);
  // Some normals nearly along an axis of the hull, where its faces are.
  if (random_below(random, 2) == 0) {
    n.x = random_range(random, -3, 3);
    n.y = random_range(random, -3, 3);
    n.z = n.z < 0 ? -(INT64_C(1) << 61) - 1 : (INT64_C(1) << 61) + 1;
  }
  gjk_search_direction_of(&n, &rounded);
  if (rounded.exact) {
    return false;
  }
  for (int i = 0; i < 4; i++) {
    gjk_direction direction = {&a, &b, &n, 0, 0, 3, false, NULL, 0};
    found[i] = support_of(colliders[i], &rounded.d);
    moved[i] = colliders[i]->shape->type->refine(colliders[i], &rounded.d, &direction, &found[i]);
    CHECK(moved[i] == moved[0]);
    CHECK(same_support(&found[i], &found[0]));
  }
  return moved[0];
}

static void check_distance(const gjk_collider *a, const gjk_collider *b, const gjk_distance_result *expected) {
  gjk_distance_result gap;
  CHECK(gjk_distance(a, b, NULL, &gap) == GJK_OK);
  CHECK(same_distance(&gap, expected));
  CHECK(gjk_check_distance(a, b, &gap) == GJK_OK);
}

// Returns whether the hulls are apart.
static bool check_query(random_state *random, four *a, four *b) {
  const int64_t radii = (int64_t)a->baked.radius + b->baked.radius;
  const gjk_vec3 away = on_sphere(random, (double)radii * random_below(random, 100) / 80);
  const gjk_vec3 delta = gjk_sub(b->baked.position, b->baked.centre);
  const gjk_vec3 centre = a->baked.centre;
  const gjk_vec3 place = {gjk_saturate((int64_t)centre.x + delta.x + away.x),
                          gjk_saturate((int64_t)centre.y + delta.y + away.y),
                          gjk_saturate((int64_t)centre.z + delta.z + away.z)};
  gjk_collider *const moved[4] = {&b->baked, &b->lazy, &b->baked_table, &b->lazy_table};
  gjk_distance_result gap;
  for (int i = 0; i < 4; i++) {
    if (gjk_collider_move(moved[i], &place) != GJK_OK) {
      return false;
    }
  }
  CHECK(gjk_distance(&a->baked, &b->baked, NULL, &gap) == GJK_OK);
  check_distance(&a->baked_table, &b->baked_table, &gap);
  check_distance(&a->lazy_table, &b->lazy_table, &gap);
  check_distance(&a->baked_table, &b->lazy, &gap);
  return !gap.intersecting;
}

static void check_answers(random_state *random) {
  static const unsigned counts[] = {1, 2, 4, 7, 20, 64, 256, 1024, 4096};
  unsigned long ties = 0, moved = 0, apart = 0, queries = 0, directions = 0, listed = 0, whole = 0;
  for (unsigned i = 0; i < check_trials_least(1080, 60); i++) {
    check_trial(i, NULL, NULL);
    const family of = (family)(i % FAMILIES);
    const unsigned size = counts[i / FAMILIES % (sizeof counts / sizeof counts[0])];
    if (size >= 1024 && (i / FAMILIES / 9 % 6 != 0 || (of != BALL && of != BLOCK && of != PRISM))) {
      continue;
    }
    uint8_t level = (uint8_t)random_below(random, size > 64 ? 4 : 5);
    four a = {0}, b = {0};
    make_hull(random, of, size, level, 0);
    make_hull(random, (family)random_below(random, TINY), 64, 1, 1);
    CHECK(gjk_hull_table_check(vertices[0], (uint16_t)size, &tables[0]) == GJK_OK);
    level = tables[0].level;
    for (unsigned cell = 0; cell < (unsigned)GJK_TABLE_CELLS(level); cell++) {
      const unsigned entries_of = ends[0][cell] - (cell == 0 ? 0u : ends[0][cell - 1]);
      whole += entries_of == size;
      listed += entries_of < size;
    }
    const gjk_pose pose = random_pose(random), other = random_pose(random);
    if (!place_four(&a, 0, &pose) || !place_four(&b, 1, &other)) {
      continue;
    }
    for (unsigned k = 0; k < 60; k++) {
      const gjk_vec3 d = random_direction(random, &a.baked);
      check_support(&a, &d);
      directions++;
      ties += size < 1024 && farthest_count(&a.baked, &d) > 1;
      moved += check_refine(random, &a);
    }
    for (unsigned k = 0; k < 4; k++) {
      queries++;
      apart += check_query(random, &a, &b);
    }
  }
  printf("hull_table: %lu directions, %lu with equals, %lu refined; %lu of %lu pairs apart; %lu cells, %lu whole\n",
         directions, ties, moved, apart, queries, listed + whole, whole);
  CHECK(ties > directions / 10);
  CHECK(moved > directions / 1000);
  CHECK(apart > queries / 5 && apart < queries * 4 / 5);
  CHECK(listed > 0 && whole > 0);
}

// The cell of a direction holds it, and neighbours of corners and axes go where the header says.
static void check_cells(random_state *random) {
  for (unsigned i = 0; i < check_trials(200000); i++) {
    const unsigned level = random_below(random, GJK_TABLE_LEVEL_MAX + 1);
    gjk_vec3 d = random_in_cube(random, INT32_C(1) << random_below(random, 31));
    if (random_below(random, 4) == 0) {
      d = random_in_cube(random, 1 << level);  // corners of cells
    }
    if ((d.x | d.y | d.z) == 0) {
      continue;
    }
    const unsigned cell = gjk_table_cell(&d, level);
    const uint32_t along[3] = {gjk_magnitude32(d.x), gjk_magnitude32(d.y), gjk_magnitude32(d.z)};
    const unsigned major = cell >> 2 * level >> 3;
    CHECK(cell < (unsigned)GJK_TABLE_CELLS(level));
    CHECK((cell >> 2 * level & 7u) == ((d.x < 0 ? 1u : 0u) | (d.y < 0 ? 2u : 0u) | (d.z < 0 ? 4u : 0u)));
    for (unsigned axis = 0; axis < 2; axis++) {
      const uint64_t rest = along[(major + 1 + axis) % 3];
      uint64_t part = 0;
      for (unsigned k = 0; k < level; k++) {
        part = part << 1 | (cell >> (2 * (level - 1 - k) + 1 - axis) & 1u);
      }
      CHECK(along[major] >= rest);
      CHECK(part * along[major] <= rest << level && rest << level <= (part + 1) * along[major]);
    }
  }
  const gjk_vec3 least = {INT32_MIN, INT32_MIN, INT32_MIN}, x = {1, 0, 0}, y = {0, -1, 0}, z = {0, 0, 1};
  CHECK(gjk_table_cell(&least, 4) == (7u << 8 | 0xFFu));
  CHECK(gjk_table_cell(&x, 2) == 0);
  CHECK(gjk_table_cell(&y, 2) == ((8u | 2u) << 4));
  CHECK(gjk_table_cell(&z, 2) == (16u << 4));
}

static gjk_status init_with(const gjk_hull_table *table) {
  gjk_collider c = {0};
  gjk_shape shape = tabled[0];
  shape.user = table;
  return gjk_collider_init(&c, &shape, NULL, 0);
}

static void check_statuses(random_state *random) {
  make_hull(random, BALL, 64, 1, 0);
  const unsigned cells = GJK_TABLE_CELLS(1);
  const uint16_t used = ends[0][cells - 1];
  static uint16_t other[ENTRIES], other_end[GJK_TABLE_CELLS(1)];
  gjk_hull_table table = tables[0];
  CHECK(gjk_hull_table_make(NULL, 64, 1, other, ENTRIES, other_end) == GJK_ERROR_NULL);
  CHECK(gjk_hull_table_make(vertices[0], 64, 1, NULL, ENTRIES, other_end) == GJK_ERROR_NULL);
  CHECK(gjk_hull_table_make(vertices[0], 64, 1, other, ENTRIES, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_hull_table_make(vertices[0], 0, 1, other, ENTRIES, other_end) == GJK_ERROR_EMPTY);
  CHECK(gjk_hull_table_make(vertices[0], 64, GJK_TABLE_LEVEL_MAX + 1, other, ENTRIES, other_end) == GJK_ERROR_RANGE);
  CHECK(gjk_hull_table_make(vertices[0], 64, 1, other, (uint16_t)(used - 1), other_end) == GJK_ERROR_CAPACITY);
  CHECK(gjk_hull_table_make(vertices[0], 64, 1, other, (uint16_t)(used + 64), other_end) == GJK_OK);
  CHECK(memcmp(other, entries[0], used * sizeof *other) == 0 && memcmp(other_end, ends[0], sizeof other_end) == 0);

  CHECK(init_with(&table) == GJK_OK);
  CHECK(init_with(NULL) == GJK_ERROR_NULL);
  table.vertex = NULL;
  CHECK(init_with(&table) == GJK_ERROR_NULL);
  table = tables[0];
  table.end = NULL;
  CHECK(init_with(&table) == GJK_ERROR_NULL);
  table = tables[0];
  table.level = GJK_TABLE_LEVEL_MAX + 1;
  CHECK(init_with(&table) == GJK_ERROR_RANGE);
  table = tables[0];
  CHECK(gjk_hull_table_check(NULL, 64, &table) == GJK_ERROR_NULL);
  CHECK(gjk_hull_table_check(vertices[0], 64, NULL) == GJK_ERROR_NULL);

  table.vertex = other;
  table.end = other_end;
  CHECK(init_with(&table) == GJK_OK);
  CHECK(gjk_hull_table_check(vertices[0], 64, &table) == GJK_OK);
  unsigned last = used - 1u;  // of a cell with two vertices or more
  for (unsigned cell = cells - 1; ends[0][cell] - ends[0][cell - 1] < 2; cell--) {
    last = ends[0][cell - 1] - 1u;
  }
  const uint16_t number = other[last];
  other[last] = 64;  // no vertex
  CHECK(init_with(&table) == GJK_ERROR_RANGE);
  CHECK(gjk_hull_table_check(vertices[0], 64, &table) == GJK_ERROR_RANGE);
  other[last] = other[last - 1];  // does not rise
  CHECK(init_with(&table) == GJK_ERROR_RANGE);
  other[last] = number;
  other_end[5] = (uint16_t)(other_end[6] + 1);  // the ends fall
  CHECK(init_with(&table) == GJK_ERROR_RANGE);
  other_end[5] = ends[0][5];

  // A cell may not be empty. A vertex that is missing is a fault, whichever it is; one more is none.
  for (unsigned i = 0; i < used; i++) {
    bool alone = false;
    memcpy(other_end, ends[0], sizeof other_end);
    memcpy(other, entries[0], i * sizeof *other);
    memcpy(&other[i], &entries[0][i + 1], (used - i - 1) * sizeof *other);
    for (unsigned cell = 0; cell < cells; cell++) {
      other_end[cell] = (uint16_t)(other_end[cell] - (ends[0][cell] > i));
      alone = alone || (ends[0][cell] == i + 1 && (cell == 0 ? 0 : ends[0][cell - 1]) == i);
    }
    CHECK(init_with(&table) == (alone ? GJK_ERROR_RANGE : GJK_OK));
    CHECK(gjk_hull_table_check(vertices[0], 64, &table) == (alone ? GJK_ERROR_RANGE : GJK_ERROR_UNPROVEN));
  }
  for (unsigned cell = 0; cell < cells; cell++) {  // every vertex in every cell
    for (unsigned i = 0; i < 64; i++) {
      other[cell * 64 + i] = (uint16_t)i;
    }
    other_end[cell] = (uint16_t)(cell * 64 + 64);
  }
  CHECK(init_with(&table) == GJK_OK);
  CHECK(gjk_hull_table_check(vertices[0], 64, &table) == GJK_OK);
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  check_cells(&random);
  check_statuses(&random);
  check_answers(&random);
  return check_done("hull_table");
}
