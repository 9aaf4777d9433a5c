// Meshes: the order of triangles, the tree, the edges, and what gjk_mesh_check says of sound and of forged ones.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "generate/surface.h"
#include "src/mesh/gjk_mesh_tree.h"

#define SEED UINT64_C(0x4D657368)

static struct { unsigned long walks, found, visited, edges[4], faults[GJK_MESH_TURNED + 1], forged, harmless; } tally;

static void show(const void *subject) {
  const surface *s = (const surface *)subject;
  printf("  %s, %lu triangles\n", surface_names[s->kind], (unsigned long)s->triangle_count);
}

static void random_box(random_state *random, const gjk_mesh *mesh, gjk_region *region) {
  const gjk_vec3 *v = &mesh->vertices[random_below(random, mesh->vertex_count)];
  const int32_t size = (int32_t)1 << random_below(random, 24);
  memset(region, 0, sizeof *region);
  region->box.lower.x = v->x - random_range(random, 0, size);
  region->box.lower.y = v->y - random_range(random, 0, size);
  region->box.lower.z = v->z - random_range(random, 0, size);
  region->box.upper.x = v->x + random_range(random, -size / 8, size);
  region->box.upper.y = v->y + random_range(random, -size / 8, size);
  region->box.upper.z = v->z + random_range(random, -size / 8, size);
}

// The walk finds every triangle whose box meets the region, once, and no other.
static void check_walk(random_state *random, const surface *s, unsigned char *seen) {
  const gjk_mesh *mesh = &s->mesh;
  gjk_region region;
  gjk_parts_walk walk;
  uint32_t number;
  gjk_vec3 corner[3];
  random_box(random, mesh, &region);
  memset(seen, 0, s->triangle_count);
  gjk_parts_walk_start(&walk);
  while (gjk_parts_class_mesh.next(mesh, &region, &walk, &number)) {
    CHECK_MSG(number < s->triangle_count && seen[number] == 0, "triangle %lu", (unsigned long)number);
    seen[number] = 1;
    tally.found++;
  }
  CHECK(!gjk_parts_class_mesh.next(mesh, &region, &walk, &number));
  for (uint32_t t = 0; t < s->triangle_count; t++) {
    CHECK(gjk_mesh_corners(mesh, t, corner));
    gjk_vec3 lower = corner[0], upper = corner[0];
    gjk_triangle_widen(&lower, &upper, &corner[1]);
    gjk_triangle_widen(&lower, &upper, &corner[2]);
    const gjk_vec3 *low = &region.box.lower, *high = &region.box.upper;
    const bool meets = lower.x <= high->x && low->x <= upper.x && lower.y <= high->y && low->y <= upper.y &&
                       lower.z <= high->z && low->z <= upper.z;
    CHECK_MSG(meets == (seen[t] != 0), "triangle %lu", (unsigned long)t);
  }
  tally.walks++;
}

__extension__ typedef __int128 wide;

// The determinant of three edges, straight.
static int side_of(const gjk_vec3 *a, const gjk_vec3 *b, const gjk_vec3 *c, const gjk_vec3 *p) {
  const wide ux = (int64_t)b->x - a->x, uy = (int64_t)b->y - a->y, uz = (int64_t)b->z - a->z;
  const wide vx = (int64_t)c->x - a->x, vy = (int64_t)c->y - a->y, vz = (int64_t)c->z - a->z;
  const wide wx = (int64_t)p->x - a->x, wy = (int64_t)p->y - a->y, wz = (int64_t)p->z - a->z;
  const wide d = (uy * vz - uz * vy) * wx + (uz * vx - ux * vz) * wy + (ux * vy - uy * vx) * wz;
  return (d > 0) - (d < 0);
}

// An edge's kind by all triangles. Folded ones are left to gjk_triangle_edge_of.
static void check_edges(const surface *s) {
  const gjk_mesh *mesh = &s->mesh;
  for (uint32_t t = 0; t < s->triangle_count; t++) {
    gjk_vec3 c[3], o[3];
    CHECK(gjk_mesh_corners(mesh, t, c));
    for (unsigned i = 0; i < 3; i++) {
      const gjk_vec3 *a = &c[i], *b = &c[(i + 1) % 3], *far = &c[(i + 2) % 3];
      unsigned expected = GJK_MESH_OPEN;
      for (uint32_t u = 0; u < s->triangle_count; u++) {
        CHECK(gjk_mesh_corners(mesh, u, o));
        for (unsigned k = 0; k < 3 && u != t; k++) {
          const gjk_vec3 *p = &o[k], *q = &o[(k + 1) % 3], *w = &o[(k + 2) % 3];
          const bool same = mesh->two_sided && gjk_same_place(p, a) && gjk_same_place(q, b);
          if ((gjk_same_place(p, b) && gjk_same_place(q, a)) || same) {
            const int side = side_of(a, b, far, w);
            const unsigned kind = side > 0   ? GJK_MESH_CONCAVE
                                  : side < 0 ? GJK_MESH_CONVEX
                                             : (unsigned)gjk_triangle_edge_of(a, b, far, w);
            CHECK(side != 0 || kind == GJK_MESH_FLAT || kind == GJK_MESH_CONVEX);
            expected = kind < expected ? kind : expected;
          }
        }
      }
      CHECK_MSG(GJK_MESH_EDGE(mesh->triangles[t].corner[i]) == expected, "triangle %lu edge %u: %u, %u expected",
                (unsigned long)t, i, (unsigned)GJK_MESH_EDGE(mesh->triangles[t].corner[i]), expected);
      tally.edges[expected]++;
    }
  }
}

// The same triangles in another order make the same mesh.
static void check_order(random_state *random, const surface *s) {
  const size_t bytes = s->triangle_count * sizeof *s->triangles, node_bytes = s->node_count * sizeof *s->nodes;
  gjk_mesh_triangle *triangles = malloc(bytes);
  gjk_mesh_node *nodes = malloc(node_bytes);
  gjk_mesh mesh;
  CHECK(triangles != NULL && nodes != NULL);
  memcpy(triangles, s->triangles, bytes);
  for (uint32_t i = s->triangle_count; i > 1; i--) {
    const uint32_t k = random_below(random, i);
    const gjk_mesh_triangle t = triangles[k];
    triangles[k] = triangles[i - 1];
    triangles[i - 1] = t;
  }
  CHECK(gjk_mesh_build(s->vertices, s->vertex_count, triangles, s->triangle_count, s->mesh.two_sided, nodes,
                       s->node_count, &mesh) == GJK_OK);
  CHECK(memcmp(triangles, s->triangles, bytes) == 0 && memcmp(nodes, s->nodes, node_bytes) == 0);
  free(triangles);
  free(nodes);
}

static void check_report(const surface *s) {
  gjk_mesh_report report;
  CHECK(gjk_mesh_check(&s->mesh, &report) == GJK_OK);
  const bool soup = s->kind == SURFACE_SOUP;
  CHECK_MSG(
      soup ? report.fault >= GJK_MESH_DEGENERATE || report.fault == GJK_MESH_SOUND : report.fault == GJK_MESH_SOUND,
      "fault %d at %lu", report.fault, (unsigned long)report.triangle);
  CHECK(report.edges[0] + report.edges[1] + report.edges[2] + report.edges[3] == 3 * s->triangle_count);
  CHECK((s->kind != SURFACE_CUBE && s->kind != SURFACE_BALL) || report.edges[GJK_MESH_OPEN] == 0);
  CHECK(s->kind != SURFACE_CUBE || report.edges[GJK_MESH_CONCAVE] == 0);
  if (s->kind == SURFACE_FLAT) {
    CHECK(report.edges[GJK_MESH_CONCAVE] == 0 && report.edges[GJK_MESH_CONVEX] == 0);
  }
}

// The faults that gjk_mesh_check finds where a sound mesh is changed; queries of any bytes read nothing outside.
static void check_forged(random_state *random, surface *s, unsigned char *seen) {
  const size_t triangle_bytes = s->triangle_count * sizeof *s->triangles, node_bytes = s->node_count * sizeof *s->nodes;
  const bool in_nodes = random_below(random, 2) == 0;
  unsigned char *bytes = in_nodes ? (unsigned char *)s->nodes : (unsigned char *)s->triangles;
  unsigned char *byte = &bytes[random_u64(random) % (in_nodes ? node_bytes : triangle_bytes)], before = *byte;
  const gjk_mesh mesh = s->mesh;
  gjk_mesh_report report, true_report;
  gjk_region region;
  gjk_parts_walk walk;
  uint32_t number;
  CHECK(gjk_mesh_check(&s->mesh, &true_report) == GJK_OK);
  *byte = (unsigned char)(before ^ (1 + random_below(random, 255)));
  if (random_below(random, 8) == 0) {
    s->mesh.shift[random_below(random, 3)] ^= (uint8_t)(1 + random_below(random, 255));
  }
  if (random_below(random, 8) == 0) {
    s->mesh.lower.x = (int32_t)random_u32(random);
  }
  CHECK(gjk_mesh_check(&s->mesh, &report) == GJK_OK);
  tally.faults[report.fault]++;
  tally.forged++;
  random_box(random, &s->mesh, &region);
  memset(seen, 0, s->triangle_count);
  gjk_parts_walk_start(&walk);
  while (gjk_parts_class_mesh.next(&s->mesh, &region, &walk, &number)) {
    CHECK(number < s->triangle_count && seen[number] == 0);
    seen[number] = 1;
  }
  CHECK(gjk_parts_class_mesh.guess(&s->mesh, &region) < s->triangle_count);
  if (report.fault == true_report.fault) {  // a box that is larger than it need be, or another mesh that is sound
    tally.harmless++;
  }
  *byte = before;
  s->mesh = mesh;
  CHECK(gjk_mesh_check(&s->mesh, &report) == GJK_OK && report.fault == true_report.fault);
}

static const gjk_vec3 tent[5] = {{0, 0, 0}, {60000, 0, 0}, {60000, 60000, 0}, {0, 60000, 0}, {30000, 30000, 9000}};

// Does the check find this fault? It writes all of the report: no edges where a fault keeps it from counting them.
static bool finds(const gjk_mesh *mesh, gjk_mesh_fault fault, gjk_mesh_report *report) {
  memset(report, 0x5A, sizeof *report);
  if (gjk_mesh_check(mesh, report) != GJK_OK || report->fault != (uint8_t)fault) {
    return false;
  }
  const uint32_t *edges = report->edges;
  const bool counted = fault == GJK_MESH_SOUND || fault >= GJK_MESH_DEGENERATE;
  CHECK(edges[0] + edges[1] + edges[2] + edges[3] == (counted ? 3 * mesh->triangle_count : 0));
  CHECK(edges[0] <= 3 * mesh->triangle_count && edges[1] <= 3 * mesh->triangle_count);
  CHECK(fault == GJK_MESH_BOX || report->node == 0);
  CHECK(fault != GJK_MESH_SOUND || (report->triangle == 0 && report->edge == 0));
  return true;
}

// Each fault, in a small mesh.
static void check_faults(void) {
  gjk_vec3 v[5];
  gjk_mesh_triangle t[5] = {{{0, 1, 4}}, {{1, 2, 4}}, {{2, 3, 4}}, {{3, 0, 4}}, {{0, 2, 1}}};
  gjk_mesh_node nodes[1];
  gjk_mesh mesh;
  gjk_mesh_report report;
  memcpy(v, tent, sizeof v);
  const gjk_mesh_triangle first = t[0];
  CHECK(gjk_mesh_build(v, 5, t, 4, false, nodes, 1, &mesh) == GJK_OK);
  CHECK(finds(&mesh, GJK_MESH_SOUND, &report));
  CHECK(report.edges[GJK_MESH_CONVEX] == 8 && report.edges[GJK_MESH_OPEN] == 4);
  const gjk_mesh_triangle kept = t[1];
  t[1].corner[1] = 5;
  CHECK(finds(&mesh, GJK_MESH_NUMBER_FAULT, &report) && report.triangle == 1 && report.edge == 1);
  t[1] = kept;
  t[1].corner[2] |= UINT32_C(1) << 31;
  CHECK(finds(&mesh, GJK_MESH_NUMBER_FAULT, &report) && report.edge == 2);
  t[1] = kept;
  const gjk_mesh_triangle third = t[2];
  t[2].corner[0] |= UINT32_C(1) << 30;
  CHECK(finds(&mesh, GJK_MESH_NUMBER_FAULT, &report) && report.triangle == 2 && report.edge == 0);
  t[2] = third;
  v[4].z = GJK_MESH_COORDINATE_MAX + 1;
  CHECK(finds(&mesh, GJK_MESH_COORDINATE, &report));
  v[4].z = GJK_RADIUS_MAX + 1;
  CHECK(finds(&mesh, GJK_MESH_SIZE, &report));
  v[4].z = 9001;
  CHECK(finds(&mesh, GJK_MESH_SHIFT, &report));
  v[4].z = tent[4].z;
  nodes[0].upper[1]--;
  CHECK(finds(&mesh, GJK_MESH_BOX, &report) && report.node == 0);
  nodes[0].upper[1]++;
  t[2].corner[0] ^= UINT32_C(1) << 28;
  CHECK(finds(&mesh, GJK_MESH_EDGES, &report) && report.triangle == 2 && report.edge == 0);
  t[2].corner[0] ^= UINT32_C(1) << 28;
  v[4].z = 0;
  v[4].x = v[4].y = 0;
  CHECK(gjk_mesh_build(v, 5, t, 4, false, nodes, 1, &mesh) == GJK_OK);
  CHECK(finds(&mesh, GJK_MESH_DEGENERATE, &report));
  memcpy(v, tent, sizeof v);
  t[4] = first;
  CHECK(gjk_mesh_build(v, 5, t, 5, false, nodes, 1, &mesh) == GJK_OK);
  CHECK(finds(&mesh, GJK_MESH_CROWDED, &report));
  const gjk_mesh_triangle turned[2] = {first, {{1, 4, 2}}};
  memcpy(t, turned, sizeof turned);
  CHECK(gjk_mesh_build(v, 5, t, 2, false, nodes, 1, &mesh) == GJK_OK);
  CHECK(finds(&mesh, GJK_MESH_TURNED, &report));
  CHECK(gjk_mesh_build(v, 5, t, 2, true, nodes, 1, &mesh) == GJK_OK);
  CHECK(finds(&mesh, GJK_MESH_SOUND, &report));
}

static void check_refusals(void) {
  gjk_vec3 v[5];
  gjk_mesh_triangle t[2] = {{{0, 1, 4}}, {{1, 2, 4}}};
  gjk_mesh_node nodes[1];
  gjk_mesh mesh;
  gjk_mesh_report report;
  memcpy(v, tent, sizeof v);
  CHECK(gjk_mesh_build(NULL, 5, t, 2, false, nodes, 1, &mesh) == GJK_ERROR_NULL);
  CHECK(gjk_mesh_build(v, 5, NULL, 2, false, nodes, 1, &mesh) == GJK_ERROR_NULL);
  CHECK(gjk_mesh_build(v, 5, t, 2, false, NULL, 1, &mesh) == GJK_ERROR_NULL);
  CHECK(gjk_mesh_build(v, 5, t, 2, false, nodes, 1, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_mesh_build(v, 5, t, 0, false, nodes, 1, &mesh) == GJK_ERROR_EMPTY);
  CHECK(gjk_mesh_build(v, 5, t, 2, false, nodes, 0, &mesh) == GJK_ERROR_CAPACITY);
  CHECK(gjk_mesh_build(v, 4, t, 2, false, nodes, 1, &mesh) == GJK_ERROR_RANGE);
  CHECK(gjk_mesh_build(v, 5, t, GJK_MESH_TRIANGLES_MAX + 1, false, nodes, 1, &mesh) == GJK_ERROR_RANGE);
  CHECK(gjk_mesh_build(v, 5, t, GJK_MESH_TRIANGLES_MAX, false, nodes, 1, &mesh) == GJK_ERROR_CAPACITY);
  CHECK(gjk_mesh_build(v, GJK_MESH_VERTICES_MAX, t, 2, false, nodes, 0, &mesh) == GJK_ERROR_CAPACITY);
  v[4].x = -GJK_MESH_COORDINATE_MAX - 1;
  CHECK(gjk_mesh_build(v, 5, t, 2, false, nodes, 1, &mesh) == GJK_ERROR_RANGE);
  v[4].x = -GJK_MESH_COORDINATE_MAX;
  CHECK(gjk_mesh_build(v, 5, t, 2, false, nodes, 1, &mesh) == GJK_ERROR_SIZE);
  CHECK(t[0].corner[2] == 4);
  CHECK(gjk_mesh_check(NULL, &report) == GJK_ERROR_NULL);
  memset(&mesh, 0, sizeof mesh);
  CHECK(gjk_mesh_check(&mesh, &report) == GJK_ERROR_NULL);
  const gjk_mesh empty = {v, t, nodes, 5, 0, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, false};
  CHECK(gjk_mesh_check(&empty, &report) == GJK_ERROR_EMPTY);
  CHECK(gjk_mesh_check(&empty, NULL) == GJK_ERROR_NULL);
  // Arrays that long there are none: what is refused is not read.
  gjk_mesh long_one = empty;
  long_one.triangle_count = GJK_MESH_TRIANGLES_MAX + 1;
  CHECK(gjk_mesh_check(&long_one, &report) == GJK_ERROR_RANGE);
  long_one.triangle_count = 2;
  long_one.vertex_count = GJK_MESH_VERTICES_MAX + 1;
  CHECK(gjk_mesh_check(&long_one, &report) == GJK_ERROR_RANGE);
  CHECK(gjk_mesh_build(v, GJK_MESH_VERTICES_MAX + 1, t, 2, false, nodes, 1, &mesh) == GJK_ERROR_RANGE);
}

// Triangles in one place, of vertices in the same places, are ordered by their numbers, whichever came first.
static void check_equals(random_state *random) {
  static const gjk_vec3 v[6] = {{0, 0, 0}, {900, 0, 0}, {0, 900, 0}, {0, 0, 0}, {900, 0, 0}, {0, 900, 0}};
  static const gjk_mesh_triangle sorted[] = {{{0, 1, 2}}, {{0, 1, 5}}, {{0, 4, 2}},
                                             {{0, 4, 5}}, {{3, 1, 2}}, {{3, 4, 5}}};
  enum { COUNT = sizeof sorted / sizeof *sorted };
  for (int trial = 0; trial < 100; trial++) {
    gjk_mesh_triangle t[COUNT];
    gjk_mesh_node node;
    gjk_mesh mesh;
    memcpy(t, sorted, sizeof t);
    for (uint32_t i = COUNT; i > 1; i--) {
      const uint32_t k = random_below(random, i);
      const gjk_mesh_triangle kept = t[k];
      t[k] = t[i - 1];
      t[i - 1] = kept;
    }
    CHECK(gjk_mesh_build(v, 6, t, COUNT, false, &node, 1, &mesh) == GJK_OK);
    for (uint32_t i = 0; i < 3 * COUNT; i++) {
      CHECK(GJK_MESH_NUMBER(t[i / 3].corner[i % 3]) == sorted[i / 3].corner[i % 3]);
    }
  }
}

static bool node_meets(const gjk_mesh_node *n, const gjk_mesh_node *steps) {
  bool meets = true;
  for (unsigned k = 0; k < 3; k++) {
    meets = meets && n->lower[k] <= steps->upper[k] && steps->lower[k] <= n->upper[k];
  }
  return meets;
}

// Nodes that a walk near one place looks at, counted by its rule.
static unsigned long count_visited(const gjk_mesh *mesh, const gjk_region *region) {
  const uint32_t leaves = gjk_mesh_leaves(mesh->triangle_count);
  unsigned long visited = 0;
  gjk_mesh_node steps;
  gjk_mesh_steps_of(mesh, &region->box.lower, &region->box.upper, &steps);
  for (uint32_t leaf = 0; leaf < leaves;) {
    unsigned level = 0;
    while (level < GJK_MESH_LEVEL_MAX && (leaf >> level & 1u) == 0) {
      level++;
    }
    level = gjk_mesh_level(leaf, level, leaves);
    while (visited++, node_meets(&mesh->nodes[gjk_mesh_node_number(leaf, level)], &steps) && level > 0) {
      level = gjk_mesh_level(leaf, level - 1, leaves);
    }
    leaf += UINT32_C(1) << level;
  }
  return visited;
}

// What a walk costs grows with what is near.
static void check_cost(random_state *random, uint32_t triangles) {
  surface s;
  unsigned long visited = 0, found = 0;
  surface_make(random, SURFACE_ROUGH, triangles, 40000, false, &s);
  for (int i = 0; i < 1000; i++) {
    const gjk_vec3 *v = &s.vertices[random_below(random, s.vertex_count)];
    gjk_region region = {0};
    gjk_parts_walk walk;
    uint32_t number;
    region.box.lower = region.box.upper = *v;
    region.box.lower.x -= 50000;
    region.box.lower.y -= 50000;
    region.box.upper.z += 50000;
    visited += count_visited(&s.mesh, &region);
    gjk_parts_walk_start(&walk);
    while (gjk_parts_class_mesh.next(&s.mesh, &region, &walk, &number)) {
      found++;
    }
  }
  printf("%lu triangles, %.2f bytes each beside the vertices: %.1f nodes visited for %.1f triangles found\n",
         (unsigned long)s.triangle_count,
         (double)(s.triangle_count * sizeof *s.triangles + s.node_count * sizeof *s.nodes) / s.triangle_count,
         (double)visited / 1000, (double)found / 1000);
  CHECK(visited < 1000 * 130);
  CHECK(found > 1000 * 4);
  surface_free(&s);
}

int main(int argc, char **argv) {
  const uint64_t seed = check_seed(SEED);
  unsigned char *seen = malloc(4000000);
  CHECK(seen != NULL && sizeof(gjk_mesh_triangle) == 12 && sizeof(gjk_mesh_node) == 12);
  check_faults();
  check_refusals();
  for (unsigned long i = 0; i < 120; i++) {
    random_state random = random_seed(seed + i);
    surface s;
    const uint32_t triangles = i < 40 ? 1 + (uint32_t)i : random_below(&random, 600) + 1;
    surface_make(&random, (surface_kind)(i % SURFACE_KINDS), triangles, random_below(&random, 2) ? 65536 : 7,
                 random_below(&random, 3) == 0, &s);
    check_trial(i, show, &s);
    for (int k = 0; k < 40; k++) {
      check_walk(&random, &s, seen);
    }
    check_edges(&s);
    check_order(&random, &s);
    check_report(&s);
    for (int k = 0; k < 20; k++) {
      check_forged(&random, &s, seen);
    }
    surface_free(&s);
  }
  random_state random = random_seed(seed);
  check_equals(&random);
  check_cost(&random, argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 40000);
  printf("%lu walks, %lu triangles found; edges: %lu concave, %lu flat, %lu convex, %lu open\n", tally.walks,
         tally.found, tally.edges[0], tally.edges[1], tally.edges[2], tally.edges[3]);
  printf("%lu forged, faults:", tally.forged);
  for (int k = 0; k <= GJK_MESH_TURNED; k++) {
    printf(" %lu", tally.faults[k]);
  }
  printf("; %lu with the same report\n", tally.harmless);
  CHECK(tally.found > 10 * tally.walks && tally.edges[0] > 100 && tally.edges[1] > 100 && tally.edges[2] > 100 &&
        tally.edges[3] > 100);
  CHECK(tally.faults[GJK_MESH_NUMBER_FAULT] > 100 && tally.faults[GJK_MESH_BOX] > 100 &&
        tally.faults[GJK_MESH_EDGES] > 5 && tally.harmless > 100);
  free(seen);
  return check_done("mesh");
}
