// A mesh of a million triangles, and patches cut out of it: the same answers, and no more triangles asked.
//
// So what a query asks grows with what is near, not with the mesh. The patches' own answers are compared with those of all
// their triangles in test_mesh_query.c.
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "gjk/surface.h"
#include "reference/random_shape.h"
#include "same.h"
#include "src/parts/gjk_parts_class.h"

#define SEED UINT64_C(0x4D696C6C)
#define SIDE 708u  // cells along an edge of the ground
#define PATCH 24u  // and of a patch
#define STEP 65536
#define BODIES 300
#define FOUND 64

typedef struct ground {
  gjk_vec3 *vertices;
  gjk_mesh_triangle *triangles;
  gjk_mesh_node *nodes;
  gjk_mesh mesh;
  gjk_parts parts;
} ground;

typedef struct answers {
  gjk_distance_result distance;
  gjk_decision within;
  gjk_penetration_result depth;
  gjk_cast_result cast, ray;
  gjk_surface_contact contact[FOUND];
  uint16_t contacts;
  unsigned long asked;
} answers;

static struct { unsigned long overlap, apart, hits, misses, contacts, asked, asked_of_patch; } tally;

// The class of meshes, which counts what it is asked for.
static gjk_parts_class counting;
static unsigned long asked;

static bool count_next(const void *data, const gjk_region *region, gjk_parts_walk *walk, uint32_t *number) {
  const bool found = gjk_parts_class_mesh.next(data, region, walk, number);
  asked += found;
  return found;
}

// A square of cells, side of them along each edge, whose vertices are heights of the whole ground from (column, row) on.
static void make_ground(const gjk_q16 *heights, uint32_t column, uint32_t row, uint32_t side, ground *out) {
  const uint32_t vertices = (side + 1) * (side + 1), triangles = 2 * side * side;
  out->vertices = malloc(vertices * sizeof *out->vertices);
  out->triangles = malloc(triangles * sizeof *out->triangles);
  out->nodes = malloc(GJK_MESH_NODES(triangles) * sizeof *out->nodes);
  CHECK(out->vertices != NULL && out->triangles != NULL && out->nodes != NULL);
  for (uint32_t i = 0; i < vertices; i++) {
    const uint32_t x = column + i % (side + 1), y = row + i / (side + 1);
    out->vertices[i] = (gjk_vec3){(gjk_q16)x * STEP, (gjk_q16)y * STEP, heights[y * (SIDE + 1) + x]};
  }
  for (uint32_t i = 0; i < side * side; i++) {
    const uint32_t a = i / side * (side + 1) + i % side, b = a + 1, c = a + side + 1, d = c + 1;
    out->triangles[2 * i] = (gjk_mesh_triangle){{a, b, d}};
    out->triangles[2 * i + 1] = (gjk_mesh_triangle){{a, d, c}};
  }
  CHECK(gjk_mesh_build(out->vertices, vertices, out->triangles, triangles, false, out->nodes, GJK_MESH_NODES(triangles),
                       &out->mesh) == GJK_OK);
  out->parts = (gjk_parts)GJK_PARTS_OF_MESH(&out->mesh);
  out->parts.type = &counting;
}

static void free_ground(ground *g) {
  free(g->vertices);
  free(g->triangles);
  free(g->nodes);
}

// What the queries answer of a body whose pose is at a position, and that moves.
static void ask(const ground *g, const gjk_collider *body, const gjk_vec3 *at, const gjk_vec3 *way, answers *out) {
  static gjk_epa_cell cells[500];
  const gjk_workspace workspace = {cells, 500};
  const gjk_vec3 from = body->centre;
  const gjk_vec3 to = {from.x + way->x, from.y + way->y, from.z + way->z};
  const gjk_vec3 goal = {at->x + way->x, at->y + way->y, at->z + way->z};
  const gjk_cast_path path = {NULL, &goal, 0};
  memset(out, 0, sizeof *out);
  asked = 0;
  CHECK(gjk_parts_distance(&g->parts, body, NULL, &out->distance) == GJK_OK);
  CHECK(gjk_parts_within(&g->parts, body, STEP / 2, NULL, &out->within) == GJK_OK);
  CHECK(gjk_parts_penetration(&g->parts, body, &workspace, NULL, &out->depth) == GJK_OK);
  CHECK(gjk_parts_cast(&g->parts, body, &path, NULL, &out->cast) == GJK_OK);
  CHECK(gjk_parts_cast_ray(&g->parts, &from, &to, NULL, &out->ray) == GJK_OK);
  CHECK(gjk_surface_contacts(&g->parts, body, 100, 4, &workspace, out->contact, FOUND, &out->contacts) == GJK_OK);
  out->asked = asked;
}

// Where a triangle is on the ground: a number that no other has, the same in a patch.
static uint64_t place_of(const ground *g, uint32_t triangle) {
  uint64_t x = 0, y = 0;
  for (unsigned i = 0; i < 3; i++) {
    const gjk_vec3 *v = &g->vertices[GJK_MESH_NUMBER(g->triangles[triangle].corner[i])];
    x += (uint64_t)v->x;
    y += (uint64_t)v->y;
  }
  return x << 32 | y;
}

static bool same_contacts(const ground *g, const answers *a, const ground *patch, const answers *b) {
  unsigned found = 0;
  for (unsigned i = 0; i < a->contacts; i++) {
    for (unsigned k = 0; k < b->contacts; k++) {
      found += place_of(g, a->contact[i].triangle) == place_of(patch, b->contact[k].triangle) &&
               same_manifold(&a->contact[i].manifold, &b->contact[k].manifold);
    }
  }
  return a->contacts == b->contacts && found == a->contacts;
}

// A body whose centre is at a place, to the LSB; its own origin may be far from it.
static void make_body(random_state *random, case_kind kind, const gjk_vec3 *at, case_shape *source,
                      case_collider *out) {
  random_shape(random, kind, random_range(random, STEP / 8, 2 * STEP), source);
  source->pose.position = (gjk_vec3){0, 0, 0};
  source->pose.rotation = random_rotation(random);
  CHECK(case_collider_build(out, source, false) == GJK_OK);
  const gjk_vec3 centre = out->collider.centre;
  source->pose.position = (gjk_vec3){at->x - centre.x, at->y - centre.y, at->z - centre.z};
  case_collider_free(out);
  CHECK(case_collider_build(out, source, false) == GJK_OK);
}

// Bodies near the middle of a patch, which reach no farther than its rim: the patch's rim has open edges, the ground not.
static void check_bodies(uint64_t seed, const gjk_q16 *heights, const ground *whole) {
  case_shape source = {0};
  case_collider body = {0};
  for (unsigned long i = 0; i < BODIES; i++) {
    static const case_kind kinds[] = {CASE_BOX, CASE_POINT, CASE_SEGMENT, CASE_HULL};
    static answers all, cut;
    random_state random = random_seed(seed + i);
    const uint32_t column = random_below(&random, SIDE - PATCH), row = random_below(&random, SIDE - PATCH);
    ground patch;
    check_trial(i, NULL, NULL);
    make_ground(heights, column, row, PATCH, &patch);
    const gjk_vec3 at = {(gjk_q16)(column + PATCH / 2) * STEP + random_range(&random, -STEP, STEP),
                         (gjk_q16)(row + PATCH / 2) * STEP + random_range(&random, -STEP, STEP),
                         random_range(&random, 0, 3 * STEP / 2)};
    const gjk_vec3 way = random_vector(&random, 4.0 * STEP);
    make_body(&random, kinds[i % 4], &at, &source, &body);
    ask(whole, &body.collider, &source.pose.position, &way, &all);
    ask(&patch, &body.collider, &source.pose.position, &way, &cut);
    CHECK_MSG(all.distance.intersecting == cut.distance.intersecting && all.distance.distance == cut.distance.distance,
              "%d apart, %d of the patch", (int)all.distance.distance, (int)cut.distance.distance);
    CHECK(all.within.yes == cut.within.yes && all.depth.depth == cut.depth.depth);
    CHECK(all.cast.hit == cut.cast.hit && (!all.cast.hit || all.cast.fraction == cut.cast.fraction));
    CHECK(all.ray.hit == cut.ray.hit && (!all.ray.hit || all.ray.fraction == cut.ray.fraction));
    CHECK_MSG(same_contacts(whole, &all, &patch, &cut), "%u contacts, %u of the patch", all.contacts, cut.contacts);
    tally.overlap += all.distance.intersecting;
    tally.apart += !all.distance.intersecting;
    tally.hits += all.cast.hit;
    tally.misses += !all.cast.hit;
    tally.contacts += all.contacts;
    tally.asked += all.asked;
    tally.asked_of_patch += cut.asked;
    free_ground(&patch);
    case_collider_free(&body);
  }
  case_shape_free(&source);
}

int main(void) {
  const uint64_t seed = check_seed(SEED);
  gjk_q16 *heights = malloc((SIDE + 1) * (SIDE + 1) * sizeof *heights);
  random_state random = random_seed(seed);
  ground whole;
  gjk_mesh_report report;
  counting = gjk_parts_class_mesh;
  counting.next = count_next;
  CHECK(heights != NULL);
  for (uint32_t i = 0; i < (SIDE + 1) * (SIDE + 1); i++) {
    heights[i] = random_range(&random, 0, STEP);
  }
  make_ground(heights, 0, 0, SIDE, &whole);
  CHECK(gjk_parts_count(&whole.parts) > 1000000);
  CHECK(gjk_mesh_check(&whole.mesh, &report) == GJK_OK && report.fault == GJK_MESH_SOUND);
  check_bodies(seed + 1, heights, &whole);
  printf("%lu bodies overlap, %lu are apart; %lu hit, %lu miss; %lu contacts; %lu triangles asked, %lu of patches\n",
         tally.overlap, tally.apart, tally.hits, tally.misses, tally.contacts, tally.asked, tally.asked_of_patch);
  CHECK(tally.overlap > BODIES / 5 && tally.apart > BODIES / 5 && tally.hits > BODIES / 5 &&
        tally.misses > BODIES / 20 && tally.contacts > BODIES / 4);
  // The boxes of the ground's tree have coarser steps than those of a patch.
  CHECK(tally.asked <= tally.asked_of_patch + tally.asked_of_patch / 20);
  free_ground(&whole);
  free(heights);
  return check_done("mesh_million");
}
