// Making a mesh: the order of its triangles, its tree of boxes, its edges.
//
// 1. Check every triangle, and find the box of all.
// 2. Sort the triangles along a Z-order curve through their centres (Morton 1966).
// 3. Make the boxes of leaves, then level by level those above.
// 4. Look across each edge, by the tree.
#include "../arith/gjk_sort.h"
#include "gjk_mesh_tree.h"

// What the sort compares.
typedef struct sort_items {
  const gjk_vec3 *vertices;
  gjk_mesh_triangle *triangles;
  gjk_vec3 lower;
} sort_items;

// A quarter of the sum of three coordinates from the lower corner: below 3 2^31 / 4, so the differences fit.
static uint32_t place_along(int32_t a, int32_t b, int32_t c, int32_t lower) {
  const uint64_t x = (uint32_t)a - (uint32_t)lower, y = (uint32_t)b - (uint32_t)lower,
                 z = (uint32_t)c - (uint32_t)lower;
  const uint64_t sum = x + y + z;
  return (uint32_t)(sum >> 2);
}

static void place_on_curve(const sort_items *items, uint32_t i, uint32_t place[3]) {
  const uint32_t *corner = items->triangles[i].corner;
  const gjk_vec3 *a = &items->vertices[corner[0]], *b = &items->vertices[corner[1]], *c = &items->vertices[corner[2]];
  place[0] = place_along(a->x, b->x, c->x, items->lower.x);
  place[1] = place_along(a->y, b->y, c->y, items->lower.y);
  place[2] = place_along(a->z, b->z, c->z, items->lower.z);
}

// On the curve the axis decides in which two places differ by the highest bit, the first of equals (Chan 2002). The
// numbers decide where all are equal, so the order is one of all triangles.
static bool precedes_on_curve(const void *context, uint32_t i, uint32_t j) {
  const sort_items *items = (const sort_items *)context;
  uint32_t p[3], q[3], most = 0;
  unsigned axis = 3;
  place_on_curve(items, i, p);
  place_on_curve(items, j, q);
  for (unsigned k = 0; k < 3; k++) {
    const uint32_t bits = p[k] ^ q[k];
    if (bits > most && (bits ^ most) > most) {  // a higher highest bit
      most = bits;
      axis = k;
    }
  }
  if (axis < 3) {
    return p[axis] < q[axis];
  }
  const uint32_t *a = items->triangles[i].corner, *b = items->triangles[j].corner;
  return a[0] != b[0] ? a[0] < b[0] : a[1] != b[1] ? a[1] < b[1] : a[2] < b[2];
}

static void exchange_triangles(void *context, uint32_t i, uint32_t j) {
  gjk_mesh_triangle *triangles = ((sort_items *)context)->triangles;
  for (unsigned k = 0; k < 3; k++) {
    const uint32_t corner = triangles[i].corner[k];
    triangles[i].corner[k] = triangles[j].corner[k];
    triangles[j].corner[k] = corner;
  }
}

// Step 1.
static gjk_status check_triangles(const gjk_vec3 *vertices, uint32_t vertex_count, const gjk_mesh_triangle *triangles,
                                  uint32_t count, gjk_mesh *out) {
  gjk_triangle_start_box(&out->lower, &out->upper);
  for (uint32_t i = 0; i < count; i++) {
    unsigned corner;
    const gjk_mesh_fault fault = gjk_mesh_triangle_fault(vertices, vertex_count, &triangles[i], &corner);
    if (fault != GJK_MESH_SOUND) {
      return fault == GJK_MESH_SIZE ? GJK_ERROR_SIZE : GJK_ERROR_RANGE;
    }
    for (unsigned k = 0; k < 3; k++) {
      const gjk_vec3 *v = &vertices[GJK_MESH_NUMBER(triangles[i].corner[k])];
      gjk_triangle_widen(&out->lower, &out->upper, v);
    }
  }
  return GJK_OK;
}

// The least shift that leaves fewer than 2^16 steps.
static uint8_t shift_for(int32_t lower, int32_t upper) {
  const uint32_t length = (uint32_t)upper - (uint32_t)lower;  // at most 2^31
  return (uint8_t)(length >> 16 == 0 ? 0 : 16 - gjk_clz32(length));
}

static void join_nodes(const gjk_mesh_node *a, const gjk_mesh_node *b, gjk_mesh_node *out) {
  for (unsigned k = 0; k < 3; k++) {
    out->lower[k] = a->lower[k] < b->lower[k] ? a->lower[k] : b->lower[k];
    out->upper[k] = a->upper[k] > b->upper[k] ? a->upper[k] : b->upper[k];
  }
}

// The box of a leaf.
static void fill_leaf(const gjk_mesh *mesh, uint32_t leaf, gjk_mesh_node *out) {
  const uint32_t first = leaf * GJK_MESH_LEAF;
  gjk_vec3 lower, upper;
  gjk_triangle_start_box(&lower, &upper);
  for (uint32_t t = first; t < mesh->triangle_count && t - first < GJK_MESH_LEAF; t++) {
    for (unsigned k = 0; k < 3; k++) {
      const gjk_vec3 *v = &mesh->vertices[GJK_MESH_NUMBER(mesh->triangles[t].corner[k])];
      gjk_triangle_widen(&lower, &upper, v);
    }
  }
  gjk_mesh_steps_of(mesh, &lower, &upper, out);
}

// Step 3.
static void fill_tree(const gjk_mesh *mesh, gjk_mesh_node *nodes) {
  const uint32_t leaves = gjk_mesh_leaves(mesh->triangle_count);
  for (uint32_t leaf = 0; leaf < leaves; leaf++) {
    fill_leaf(mesh, leaf, &nodes[2 * leaf]);
  }
  for (unsigned level = 1; leaves > UINT32_C(1) << (level - 1); level++) {  // leaves < 2^25
    const uint32_t half = UINT32_C(1) << (level - 1);
    for (uint32_t leaf = 0; leaf + half < leaves; leaf += 2 * half) {
      const unsigned right = gjk_mesh_level(leaf + half, level - 1, leaves);
      join_nodes(&nodes[gjk_mesh_node_number(leaf, level - 1)], &nodes[gjk_mesh_node_number(leaf + half, right)],
                 &nodes[gjk_mesh_node_number(leaf, level)]);
    }
  }
}

// Step 4.
static void note_edges(const gjk_mesh *mesh, gjk_mesh_triangle *triangles) {
  for (uint32_t t = 0; t < mesh->triangle_count; t++) {
    for (unsigned i = 0; i < 3; i++) {
      gjk_mesh_across across;
      gjk_mesh_look_across(mesh, t, i, &across);
      triangles[t].corner[i] |= (uint32_t)across.kind << 28;
    }
  }
}

gjk_status gjk_mesh_build(const gjk_vec3 *vertices, uint32_t vertex_count, gjk_mesh_triangle *triangles,
                          uint32_t triangle_count, bool two_sided, gjk_mesh_node *nodes, uint32_t capacity,
                          gjk_mesh *out) {
  if (vertices == NULL || triangles == NULL || nodes == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  if (triangle_count == 0) {
    return GJK_ERROR_EMPTY;
  }
  if (triangle_count > GJK_MESH_TRIANGLES_MAX || vertex_count > GJK_MESH_VERTICES_MAX) {
    return GJK_ERROR_RANGE;
  }
  if (capacity < GJK_MESH_NODES(triangle_count)) {
    return GJK_ERROR_CAPACITY;
  }
  static const gjk_sort_order curve_order = {.before = precedes_on_curve, .exchange = exchange_triangles};
  gjk_mesh mesh;
  const gjk_status status = check_triangles(vertices, vertex_count, triangles, triangle_count, &mesh);
  if (status != GJK_OK) {
    return status;
  }
  for (uint32_t t = 0; t < triangle_count; t++) {
    for (unsigned k = 0; k < 3; k++) {
      triangles[t].corner[k] = GJK_MESH_NUMBER(triangles[t].corner[k]);
    }
  }
  sort_items items;
  items.vertices = vertices;
  items.triangles = triangles;
  gjk_set(&mesh.lower, &items.lower);
  gjk_sort(&curve_order, &items, triangle_count);  // Step 2
  out->vertices = vertices;
  out->triangles = triangles;
  out->nodes = nodes;
  out->vertex_count = vertex_count;
  out->triangle_count = triangle_count;
  gjk_set(&mesh.lower, &out->lower);
  gjk_set(&mesh.upper, &out->upper);
  out->shift[0] = shift_for(mesh.lower.x, mesh.upper.x);
  out->shift[1] = shift_for(mesh.lower.y, mesh.upper.y);
  out->shift[2] = shift_for(mesh.lower.z, mesh.upper.z);
  out->two_sided = two_sided;
  fill_tree(out, nodes);
  note_edges(out, triangles);
  return GJK_OK;
}
