// Height fields against meshes of the same triangles: every query of any body answers the same, contacts bit for bit. Both find
// their triangles and edges by ways of their own.
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "gjk/height_field.h"
#include "gjk/mesh.h"
#include "gjk/surface.h"
#include "parts_answers.h"
#include "reference/random_shape.h"

#define SEED UINT64_C(0x4669656C)
#define TRIALS 150
#define BODIES 40
#define SIDE 20
#define FOUND 400
#define CELLS 1000

typedef enum relief { LEVEL, BENT, ROUGH, RIDGES, STAIRS, RELIEFS } relief;

static const char *const relief_name[RELIEFS] = {"level", "bent", "rough", "ridges", "stairs"};

typedef struct ground {
  relief kind;
  int16_t heights[SIDE * SIDE];
  gjk_height_field field;
  gjk_vec3 vertices[SIDE * SIDE];
  gjk_mesh_triangle triangles[2 * SIDE * SIDE];
  gjk_mesh_node nodes[GJK_MESH_NODES(2 * SIDE * SIDE)];
  gjk_mesh mesh;
  gjk_parts of_field, of_mesh;
  case_shape source;
  case_collider body;
  gjk_q16 margin;
} ground;

static struct { unsigned long bodies, contacts, none, hits, misses, impacts, deep, holes, flush, ridges; } tally;

static void show(const void *subject) {
  const ground *g = (const ground *)subject;
  const gjk_pose *p = &g->source.pose;
  printf("  %s, %u by %u, margin %ld, body kind %d at (%ld, %ld, %ld) turned (%ld, %ld, %ld, %ld)\n",
         relief_name[g->kind], g->field.columns, g->field.rows, (long)g->margin, (int)g->source.kind,
         (long)p->position.x, (long)p->position.y, (long)p->position.z, (long)p->rotation.x, (long)p->rotation.y,
         (long)p->rotation.z, (long)p->rotation.w);
}

static int32_t height_at(random_state *random, relief kind, int i, int j) {
  switch (kind) {
    case LEVEL: return 0;
    case BENT: return 2 * i * i + 3 * j * j - 4 * i * j;
    case ROUGH: return random_range(random, -600, 600);
    case RIDGES: return (i % 2 == 0 ? 900 : -900) + 2 * j;
    default: return j / 3 * 400;
  }
}

static void make_ground(random_state *random, ground *g) {
  const uint16_t columns = (uint16_t)(2 + random_below(random, SIDE - 1)),
                 rows = (uint16_t)(2 + random_below(random, SIDE - 1));
  const int32_t step = 1 << random_range(random, 9, 17);
  const gjk_height_field field = GJK_HEIGHT_FIELD(g->heights, columns, rows, step, step + step / 3, 1 + step / 1024);
  const bool holes = random_below(random, 3) == 0;
  uint32_t count = 0;
  g->kind = (relief)random_below(random, RELIEFS);
  g->field = field;
  for (int k = 0; k < columns * rows; k++) {
    const bool hole = holes && random_below(random, 10) == 0;
    const int32_t height = height_at(random, g->kind, k % columns, k / columns);
    g->heights[k] = (int16_t)(hole ? GJK_HEIGHT_HOLE : height);
    g->vertices[k].x = k % columns * field.step_x;
    g->vertices[k].y = k / columns * field.step_y;
    g->vertices[k].z = hole ? 0 : height * field.step_z;
  }
  for (uint32_t number = 0; number < 2 * (columns - 1u) * (rows - 1u); number++) {
    const uint32_t cell = number / 2, a = cell / (columns - 1u) * columns + cell % (columns - 1u);
    const gjk_mesh_triangle two[2] = {{{a, a + 1, a + columns + 1}}, {{a, a + columns + 1, a + columns}}};
    const uint32_t *corner = two[number % 2].corner;
    if (g->heights[corner[0]] == GJK_HEIGHT_HOLE || g->heights[corner[1]] == GJK_HEIGHT_HOLE ||
        g->heights[corner[2]] == GJK_HEIGHT_HOLE) {
      tally.holes++;
    } else {
      g->triangles[count++] = two[number % 2];
    }
  }
  g->of_field = (gjk_parts)GJK_PARTS_OF_HEIGHT_FIELD(&g->field);
  g->of_mesh = (gjk_parts)GJK_PARTS_OF_MESH(&g->mesh);
  g->of_field.pose.position = random_vector(random, random_below(random, 2) == 0 ? 0 : 1.0e9);
  if (random_below(random, 3) > 0) {
    g->of_field.pose.rotation = random_rotation(random);
  }
  g->of_mesh.pose = g->of_field.pose;
  g->mesh.triangle_count = 0;
  CHECK(count == 0 || gjk_mesh_build(g->vertices, (uint32_t)columns * rows, g->triangles, count, false, g->nodes,
                                     GJK_MESH_NODES(2 * SIDE * SIDE), &g->mesh) == GJK_OK);
  CHECK(gjk_height_field_check(&g->field) == (count > 0 ? GJK_OK : GJK_ERROR_EMPTY));
}

// The number in the field of a triangle of the mesh.
static uint32_t number_in_field(const ground *g, uint32_t triangle) {
  const uint32_t a = GJK_MESH_NUMBER(g->triangles[triangle].corner[0]),
                 b = GJK_MESH_NUMBER(g->triangles[triangle].corner[1]);
  const uint32_t columns = g->field.columns;
  return 2 * (a / columns * (columns - 1) + a % columns) + (b == a + 1 ? 0 : 1);
}

static void check_contacts(ground *g) {
  static gjk_surface_contact field[FOUND], mesh[FOUND];
  static gjk_epa_cell cells[CELLS];
  const gjk_workspace workspace = {cells, CELLS};
  const gjk_collider *b = &g->body.collider;
  uint16_t count[2] = {0, 0};
  const gjk_status status = gjk_surface_contacts(&g->of_field, b, g->margin, 4, &workspace, field, FOUND, &count[0]);
  CHECK(status == GJK_OK || status == GJK_ERROR_CAPACITY);
  CHECK(gjk_surface_contacts(&g->of_mesh, b, g->margin, 4, &workspace, mesh, FOUND, &count[1]) == status);
  CHECK_MSG(count[0] == count[1], "%u manifolds of the field, %u of the mesh", count[0], count[1]);
  CHECK(count[0] < FOUND);
  for (unsigned i = 0; i < count[1]; i++) {
    const uint32_t number = number_in_field(g, mesh[i].triangle);
    unsigned k = 0;
    while (k < count[0] && field[k].triangle != number) {
      k++;
    }
    CHECK_MSG(k < count[0] && same_manifold(&field[k].manifold, &mesh[i].manifold), "triangle %lu",
              (unsigned long)number);
  }
  tally.contacts += count[0];
  tally.none += count[0] == 0;
  tally.flush += g->kind == LEVEL && count[0] > 0;
  tally.ridges += g->kind == RIDGES && count[0] > 0;
}

static void check_still(ground *g) {
  static gjk_epa_cell cells[CELLS];
  const gjk_workspace workspace = {cells, CELLS};
  const gjk_collider *b = &g->body.collider;
  gjk_decision yes[2];
  gjk_distance_result gap[2];
  gjk_penetration_result depth[2];
  for (int i = 0; i < 2; i++) {
    const gjk_parts *a = i == 0 ? &g->of_field : &g->of_mesh;
    CHECK(gjk_parts_within(a, b, g->margin, NULL, &yes[i]) == GJK_OK);
    CHECK(gjk_parts_distance(a, b, NULL, &gap[i]) == GJK_OK);
    CHECK(gjk_parts_penetration(a, b, &workspace, NULL, &depth[i]) != GJK_ERROR_ITERATION_LIMIT);
  }
  CHECK(yes[0].yes == yes[1].yes && gap[0].intersecting == gap[1].intersecting && gap[0].distance == gap[1].distance);
  CHECK(depth[0].intersecting == gap[0].intersecting && depth[1].intersecting == gap[0].intersecting);
  CHECK(!gap[0].intersecting || depth[0].depth == depth[1].depth);
  tally.deep += gap[0].intersecting;
}

static void check_moving(random_state *random, ground *g) {
  const gjk_collider *b = &g->body.collider;
  const gjk_vec3 by = random_vector(random, 8.0 * g->field.step_x),
                 to = {b->position.x + by.x, b->position.y + by.y, b->position.z + by.z};
  const gjk_cast_path path = {NULL, &to, random_below(random, 2) == 0 ? 0 : g->margin};
  const gjk_impact_setup setup = {0, GJK_PARTS_TOLERANCE_MIN + 64, 0};
  gjk_motion motion[2];
  gjk_cast_result cast[2], ray[2];
  gjk_impact_result impact[2];
  memset(motion, 0, sizeof motion);
  motion[0].from = motion[0].to = g->of_field.pose;
  motion[1].from = motion[1].to = g->source.pose;
  motion[1].to.position = to;
  motion[1].to.rotation = random_rotation(random);
  for (int i = 0; i < 2; i++) {
    const gjk_parts *a = i == 0 ? &g->of_field : &g->of_mesh;
    CHECK(gjk_parts_cast(a, b, &path, NULL, &cast[i]) == GJK_OK);
    CHECK(gjk_parts_cast_ray(a, &b->position, &to, NULL, &ray[i]) == GJK_OK);
    CHECK(gjk_parts_time_of_impact(a, &motion[0], b, &motion[1], &setup, NULL, &impact[i]) == GJK_OK);
  }
  CHECK(cast[0].hit == cast[1].hit && (!cast[0].hit || cast[0].fraction == cast[1].fraction));
  CHECK(ray[0].hit == ray[1].hit && (!ray[0].hit || ray[0].fraction == ray[1].fraction));
  // The reach that an impact of parts is bounded with is the field's tallest there may be, not that of its triangles.
  CHECK_MSG(impact[0].hit == impact[1].hit, "impacts %ld and %ld", (long)impact[0].lower, (long)impact[1].lower);
  tally.hits += cast[0].hit;
  tally.misses += !cast[0].hit;
  tally.impacts += impact[0].hit;
}

// A body near the ground, or with a face flush on it.
static void place_body(random_state *random, ground *g) {
  static const case_kind kinds[] = {CASE_BOX, CASE_BOX, CASE_POINT, CASE_SEGMENT, CASE_HULL, CASE_CYLINDER};
  const int32_t step = g->field.step_x;
  const gjk_q16 reach = (gjk_q16)(step * 2 * random_unit(random)) + 3;
  gjk_parts_room room;
  gjk_collider triangle;
  random_shape(random, kinds[random_below(random, 6)], reach, &g->source);
  if (g->source.kind == CASE_POINT) {
    g->source.convex_radius = reach;
  }
  CHECK(gjk_parts_place(&g->of_mesh, random_below(random, g->mesh.triangle_count), &room, &triangle) == GJK_OK);
  const gjk_vec3 up = {0, 0, reach + random_range(random, -reach, 4)}, off = random_vector(random, reach);
  gjk_pose turn = g->of_field.pose;
  gjk_vec3 out;
  turn.position = triangle.centre;
  const bool flush = random_below(random, 2) == 0;
  const gjk_vec3 from = {flush ? step / 2 : off.x, flush ? step / 2 : off.y,
                         flush && g->source.kind == CASE_BOX ? g->source.size.z : up.z};
  CHECK(gjk_pose_apply(&turn, &from, &out) == GJK_OK);
  g->source.pose.position = out;
  g->source.pose.rotation = flush ? turn.rotation : random_rotation(random);
  case_collider_free(&g->body);
  CHECK(case_collider_build(&g->body, &g->source, false) == GJK_OK);
}

int main(void) {
  static ground g;
  const uint64_t seed = check_seed(SEED);
  const unsigned long trials = check_trials_least(TRIALS, 30);
  for (unsigned long i = 0; i < trials; i++) {
    random_state random = random_seed(seed + i);
    make_ground(&random, &g);
    for (int k = 0; k < BODIES && g.mesh.triangle_count > 0; k++) {
      g.margin = random_range(&random, 0, g.field.step_x / 4);
      place_body(&random, &g);
      check_trial(i, show, &g);
      check_contacts(&g);
      check_still(&g);
      if (k % 4 == 0) {
        check_moving(&random, &g);
      }
      tally.bodies++;
    }
  }
  check_trial(trials, NULL, NULL);
  printf("%lu bodies, %lu manifolds, %lu without, %lu overlap; casts %lu hit, %lu miss; %lu impacts; %lu holes\n",
         tally.bodies, tally.contacts, tally.none, tally.deep, tally.hits, tally.misses, tally.impacts, tally.holes);
  CHECK(tally.contacts > tally.bodies && tally.none > tally.bodies / 10 && tally.deep > tally.bodies / 10);
  CHECK(tally.hits > trials && tally.misses > trials && tally.impacts > trials && tally.holes > trials);
  CHECK(tally.flush > trials && tally.ridges > trials);
  case_collider_free(&g.body);
  case_shape_free(&g.source);
  return check_done("height_field");
}
