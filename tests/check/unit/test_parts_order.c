// Walks of a way through bodies of many parts: each part that the region meets comes once, from near to far, whichever way it
// leads. And where casts and rays meet several parts at one fraction, the lowest number is found: against every part. Manifolds
// of all parts do not depend on the tree.
#include <string.h>

#include "check.h"
#include "gjk/gjk.h"
#include "parts_answers.h"
#include "placed.h"
#include "random.h"
#include "src/mesh/gjk_triangle.h"

#define SEED 7742
#define STEP GJK_Q16(1.0)
#define PARTS 70
#define SIDE 12  // cells of a field and of a mesh along one side
#define WAYS check_trials(200)

static const gjk_shape crate = GJK_BOX(STEP / 2, STEP / 2, STEP / 2), small = GJK_BOX(STEP / 4, STEP / 4, STEP / 4);
static gjk_compound_part parts[PARTS];
static gjk_compound_node nodes[GJK_COMPOUND_NODES(PARTS)], other_nodes[GJK_COMPOUND_NODES(PARTS)];
static gjk_compound compound, same_parts;
static gjk_vec3 vertices[(SIDE + 1) * (SIDE + 1)];
static gjk_mesh_triangle triangles[2 * SIDE * SIDE];
static gjk_mesh_node mesh_nodes[GJK_MESH_NODES(2 * SIDE * SIDE)];
static gjk_mesh mesh;
static int16_t heights[(SIDE + 1) * (SIDE + 1)];
static gjk_height_field field;
static unsigned long ties, hits, misses, walked, asked, touching, crowds;

static gjk_vec3 lattice(random_state *random, int32_t from, int32_t to, int32_t step) {
  return (gjk_vec3){random_range(random, from, to) * step, random_range(random, from, to) * step,
                    random_range(random, from, to) * step};
}

// Crates on a lattice, some at one place.
static gjk_parts crates(random_state *random, uint16_t count) {
  gjk_parts body = GJK_PARTS_OF_COMPOUND(&compound);
  for (uint16_t i = 0; i < count; i++) {
    parts[i] = (gjk_compound_part){&crate, GJK_POSE_IDENTITY};
    parts[i].pose.position = lattice(random, -3, 3, STEP);
  }
  CHECK(gjk_compound_build(parts, count, nodes, GJK_COMPOUND_NODES(PARTS), &compound) == GJK_OK);
  return body;
}

// Ground of steps, so many triangles of it; flat where steps is 0.
static gjk_parts ground(random_state *random, uint32_t count, int32_t steps) {
  gjk_parts body = GJK_PARTS_OF_MESH(&mesh);
  for (uint32_t j = 0; j <= SIDE; j++) {
    for (uint32_t i = 0; i <= SIDE; i++) {
      gjk_vec3 *v = &vertices[j * (SIDE + 1) + i];
      v->x = ((int32_t)i - SIDE / 2) * STEP;
      v->y = ((int32_t)j - SIDE / 2) * STEP;
      v->z = random_range(random, 0, steps) * STEP;
    }
  }
  for (uint32_t t = 0; t < count; t++) {
    const uint32_t cell = t / 2, a = cell / SIDE * (SIDE + 1) + cell % SIDE, far = a + SIDE + 2;
    triangles[t].corner[0] = a;
    triangles[t].corner[1] = t % 2 == 0 ? a + 1 : far;
    triangles[t].corner[2] = t % 2 == 0 ? far : far - 1;
  }
  CHECK(gjk_mesh_build(vertices, (SIDE + 1) * (SIDE + 1), triangles, count, false, mesh_nodes,
                       GJK_MESH_NODES(2 * SIDE * SIDE), &mesh) == GJK_OK);
  return body;
}

static gjk_parts heights_of(random_state *random, uint16_t columns, uint16_t rows, int32_t steps) {
  gjk_parts body = GJK_PARTS_OF_HEIGHT_FIELD(&field);
  for (unsigned i = 0; i < (unsigned)columns * rows; i++) {
    heights[i] = random_below(random, 30) == 0 ? GJK_HEIGHT_HOLE : (int16_t)(random_range(random, 0, steps) * 64);
  }
  memset(&field, 0, sizeof field);
  field.heights = heights;
  field.columns = columns;
  field.rows = rows;
  field.step_x = field.step_y = STEP;
  field.step_z = STEP / 64;
  body.pose.position.x = -SIDE / 2 * STEP;
  body.pose.position.y = -SIDE / 2 * STEP;
  return body;
}

// The corners of a part, or its box.
static bool part_meets(const gjk_parts *body, uint32_t number, const gjk_region *region) {
  gjk_parts_room room;
  gjk_parts_local local;
  if (body->data == &compound) {
    for (uint32_t i = 0; i < compound.node_count; i++) {
      if (compound.nodes[i].part == number) {
        return gjk_region_meets(region, &compound.nodes[i].box);
      }
    }
    return false;
  }
  return body->type->local(body->data, number, &room, &local) == GJK_OK && gjk_triangle_meets(region, room.vertices);
}

// Each part that the region meets comes once, and no other.
static void check_walk(const gjk_parts *body, const gjk_vec3 *from, const gjk_vec3 *to) {
  static bool seen[2 * SIDE * SIDE];
  gjk_parts_frame frame;
  gjk_region region;
  gjk_parts_walk walk;
  uint32_t number, count = gjk_parts_count(body);
  const gjk_aabb start = {*from, *from};
  const gjk_long3 way = {(int64_t)to->x - from->x, (int64_t)to->y - from->y, (int64_t)to->z - from->z};
  memset(seen, 0, sizeof seen);
  CHECK(gjk_parts_frame_set(&frame, body) == GJK_OK);
  gjk_region_start(&region, frame.rows, &body->pose.position, &start, &way);
  gjk_region_grow(&region, STEP / 2);
  gjk_parts_walk_start(&walk);
  while (gjk_parts_next(&frame, &region, &walk, &number) && number < count && !seen[number]) {
    seen[number] = true;
    walked++;
  }
  CHECK(!gjk_parts_next(&frame, &region, &walk, &number));  // as it was, at its end
  for (uint32_t i = 0; i < count; i++) {
    CHECK_MSG(seen[i] == part_meets(body, i, &region), "part %u of %u", (unsigned)i, (unsigned)count);
  }
}

// collider NULL: a ray. Ties go to a part that overlaps at the start, then to the lowest number.
static void check_first(const gjk_parts *body, const gjk_collider *b, const gjk_vec3 *from, const gjk_vec3 *to) {
  const gjk_cast_path path = {NULL, to, 0};
  gjk_cast_result best = {0}, trial, answer;
  gjk_parts_room room;
  gjk_collider part;
  uint32_t first = GJK_PARTS_NONE, found;
  unsigned equals = 0;
  for (uint32_t i = 0; i < gjk_parts_count(body); i++) {
    if (gjk_parts_place(body, i, &room, &part) != GJK_OK) {
      continue;  // a hole
    }
    CHECK((b == NULL ? gjk_cast_ray(&part, from, to, &trial) : gjk_cast(&part, b, &path, &trial)) == GJK_OK);
    const bool sooner = trial.hit && (first == GJK_PARTS_NONE || trial.fraction < best.fraction);
    equals = sooner ? 1 : trial.hit && trial.fraction == best.fraction ? equals + 1 : equals;
    if (sooner || (trial.hit && trial.fraction == best.fraction && trial.inside && !best.inside)) {
      first = i;
      best = trial;
    }
  }
  memset(&answer, 0x5A, sizeof answer);
  CHECK((b == NULL ? gjk_parts_cast_ray(body, from, to, &found, &answer)
                   : gjk_parts_cast(body, b, &path, &found, &answer)) == GJK_OK);
  CHECK_MSG(found == first, "part %ld, not %ld, of %u equals", (long)found, (long)first, equals);
  CHECK(same_cast(&answer, &best));
  ties += equals > 1 ? 1 : 0;
  hits += answer.hit ? 1 : 0;
  misses += answer.hit ? 0 : 1;
}

// Ways from lattice point to lattice point, in any direction, along an axis or a diagonal.
static void check_body(random_state *random, const gjk_parts *body) {
  static const gjk_pose identity = GJK_POSE_IDENTITY;
  for (unsigned i = 0; i < 8; i++) {
    const int32_t half = STEP / 2;
    gjk_vec3 from = lattice(random, -12, 12, half), to = lattice(random, -12, 12, half);
    const uint32_t how = random_below(random, 5);
    gjk_pose pose = identity;
    if (how > 0) {  // along an axis, or level
      to.x = how == 1 || how == 2 ? from.x : to.x;
      to.y = how == 1 || how == 3 ? from.y : to.y;
      to.z = how == 2 || how == 3 || how == 4 ? from.z : to.z;
    }
    pose.position = from;
    const gjk_collider c = posed(&small, &pose);
    check_walk(body, &from, &to);
    check_first(body, i % 2 == 0 ? NULL : &c, &from, &to);
  }
}

// Where parts stand in a row along axis x or y, in an order of numbers that is not theirs, the walk goes along the row.
// slack: by how much it may go back, in leaves of several parts. Of a way that is cut in the middle the row's first half is left.
static void check_row(const gjk_parts *body, bool x, int32_t aside, int32_t slack) {
  gjk_parts_frame frame;
  gjk_parts_room room;
  gjk_collider part;
  CHECK(gjk_parts_frame_set(&frame, body) == GJK_OK);
  for (int k = 0; k < 2; k++) {
    const int32_t far = (k == 0 ? 100 : -100) * STEP;
    const gjk_vec3 from = {x ? -far : aside, x ? aside : -far, 0};
    const gjk_long3 way = {x ? 2 * (int64_t)far : 0, x ? 0 : 2 * (int64_t)far, 0};
    const gjk_aabb start = {from, from};
    gjk_region region;
    gjk_parts_walk walk;
    uint32_t number, count = 0;
    int32_t last = -1000 * STEP;
    gjk_region_start(&region, frame.rows, &body->pose.position, &start, &way);
    gjk_parts_walk_start(&walk);
    while (gjk_parts_next(&frame, &region, &walk, &number)) {
      CHECK(gjk_parts_place(body, number, &room, &part) == GJK_OK);
      const int32_t at = x ? part.centre.x : part.centre.y, along = far > 0 ? at : -at;
      CHECK_MSG(along >= last - slack, "%ld after %ld", (long)along, (long)last);
      last = along;
      count++;
    }
    CHECK(count > 0);
    asked += count;
    gjk_region_cut(&region, GJK_Q30_ONE / 2);
    gjk_parts_walk_start(&walk);
    for (; gjk_parts_next(&frame, &region, &walk, &number); count--) {
      CHECK(gjk_parts_place(body, number, &room, &part) == GJK_OK);
      CHECK((far > 0 ? 1 : -1) * (x ? part.centre.x : part.centre.y) < STEP + slack);
    }
    CHECK(count > 0);
  }
}

static void check_rows(random_state *random) {
  gjk_parts row = crates(random, PARTS);
  for (uint16_t count = GJK_COMPOUND_LIST_MAX + 1; count <= PARTS; count++) {
    for (uint16_t i = 0; i < count; i++) {
      const int32_t at = ((int32_t)(i * 71u % count) - count / 2) * STEP;
      parts[i].pose.position.x = count % 2 == 0 ? at : 0;
      parts[i].pose.position.y = count % 2 == 0 ? 0 : at;
      parts[i].pose.position.z = 0;
    }
    CHECK(gjk_compound_build(parts, count, nodes, GJK_COMPOUND_NODES(PARTS), &compound) == GJK_OK);
    check_row(&row, count % 2 == 0, 0, 0);
  }
  row = heights_of(random, SIDE + 1, SIDE, 0);
  check_row(&row, true, STEP / 4, 0);
  check_row(&row, false, STEP / 4, 0);
  row = ground(random, 2 * SIDE, 0);
  check_row(&row, true, STEP / 4 - SIDE / 2 * STEP, STEP);
}

// The same parts with the same numbers, in the tree of another order.
static gjk_parts in_another_tree(random_state *random) {
  static gjk_compound_part shuffled[PARTS];
  uint16_t number[PARTS];
  gjk_parts body = GJK_PARTS_OF_COMPOUND(&same_parts);
  for (uint16_t i = 0; i < compound.count; i++) {
    const uint32_t at = random_below(random, i + 1u);
    number[i] = number[at];
    number[at] = i;
  }
  for (uint16_t i = 0; i < compound.count; i++) {
    shuffled[i] = parts[number[i]];
  }
  CHECK(gjk_compound_build(shuffled, compound.count, other_nodes, GJK_COMPOUND_NODES(PARTS), &same_parts) == GJK_OK);
  for (uint32_t i = 0; i < same_parts.node_count; i++) {
    other_nodes[i].part = other_nodes[i].part < compound.count ? number[other_nodes[i].part] : other_nodes[i].part;
  }
  same_parts.parts = parts;
  return body;
}

static bool same_manifolds(const gjk_manifold *a, unsigned count_a, const gjk_manifold *b, unsigned count_b) {
  bool same = count_a == count_b;
  for (unsigned i = 0; same && i < count_a; i++) {
    same = same_manifold(&a[i], &b[i]);
  }
  return same;
}

// A box on crates, flush or turned, and crates on crates. The large one meets more parts than are put in order at once.
static void check_manifolds(random_state *random) {
  static const gjk_shape slab = GJK_BOX(4 * STEP, 4 * STEP, 3 * STEP);
  gjk_manifold of[2][GJK_PARTS_MANIFOLDS_MAX];
  unsigned count[2];
  gjk_decision near;
  gjk_collider part, b;
  gjk_parts_room room;
  gjk_pose pose = GJK_POSE_IDENTITY;
  const gjk_parts body = crates(random, (uint16_t)random_range(random, 1, PARTS));
  const gjk_parts same = in_another_tree(random);
  const unsigned capacity = 1 + random_below(random, GJK_PARTS_MANIFOLDS_MAX);
  unsigned met = 0;
  pose.position = lattice(random, -4, 4, STEP);
  if (random_below(random, 2) == 0) {
    const gjk_vec3 axis = {random_range(random, -9, 9), random_range(random, -9, 9), 10};
    CHECK(gjk_quat_from_axis_angle(&axis, random_range(random, -100000000, 100000000), &pose.rotation) == GJK_OK);
  }
  CHECK(gjk_collider_init(&b, random_below(random, 2) == 0 ? &slab : &crate, NULL, 0) == GJK_OK);
  CHECK(gjk_collider_pose(&b, &pose) == GJK_OK);
  for (unsigned i = 0; i < 2; i++) {
    count[i] = 0;
    CHECK(gjk_parts_manifolds(i == 0 ? &body : &same, &b, STEP / 16, 4, NULL, of[i], capacity, &count[i]) >= 0);
  }
  CHECK_MSG(same_manifolds(of[0], count[0], of[1], count[1]), "%u and %u manifolds of %u parts", count[0], count[1],
            (unsigned)compound.count);
  touching += count[0] > 0 ? 1 : 0;
  for (uint32_t i = 0; i < compound.count; i++) {
    CHECK(gjk_parts_place(&body, i, &room, &part) == GJK_OK && gjk_within(&part, &b, STEP / 16, NULL, &near) == GJK_OK);
    met += near.yes ? 1 : 0;
  }
  crowds += met > 32 ? 1 : 0;
  for (unsigned i = 0; i < 2; i++) {
    gjk_parts moved = i == 0 ? body : same;
    moved.pose = pose;
    count[i] = 0;
    CHECK(gjk_parts_both_manifolds(&moved, i == 0 ? &same : &body, 0, 4, NULL, of[i], capacity, &count[i]) >= 0);
  }
  CHECK(same_manifolds(of[0], count[0], of[1], count[1]));
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  check_rows(&random);
  for (unsigned long i = 0; i < WAYS; i++) {
    check_trial(i, NULL, NULL);
    const int32_t steps = random_range(&random, 0, 3);
    gjk_parts body = crates(&random, (uint16_t)random_range(&random, 1, PARTS));
    check_body(&random, &body);
    body = ground(&random, (uint32_t)random_range(&random, 1, 2 * SIDE * SIDE), steps);
    check_body(&random, &body);
    body = heights_of(&random, (uint16_t)random_range(&random, 2, SIDE + 1),
                      (uint16_t)random_range(&random, 2, SIDE + 1), steps);
    check_body(&random, &body);
    check_manifolds(&random);
  }
  printf("%lu with manifolds, %lu with more than 32 parts\n", touching, crowds);
  CHECK((touching > WAYS / 4 && crowds > WAYS / 40) || !check_is_full());
  printf("%lu hits, %lu with equals; %lu misses; %lu and %lu parts walked\n", hits, ties, misses, walked, asked);
  CHECK((ties > hits / 4 && misses > hits / 20) || !check_is_full());
  return check_done("parts_order");
}
