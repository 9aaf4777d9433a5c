// Is a mesh sound? One fault after the other, each by integers alone.
#include "../arith/gjk_memory.h"
#include "gjk_mesh_tree.h"

static bool note_fault(gjk_mesh_report *report, gjk_mesh_fault fault, uint32_t triangle, unsigned edge, uint32_t node) {
  report->fault = (uint8_t)fault;
  report->triangle = triangle;
  report->edge = (uint8_t)edge;
  report->node = node;
  return true;
}

static bool has_wrong_triangle(const gjk_mesh *mesh, gjk_mesh_report *report, gjk_mesh_fault asked) {
  for (uint32_t t = 0; t < mesh->triangle_count; t++) {
    const gjk_mesh_triangle *triangle = &mesh->triangles[t];
    unsigned corner;
    const gjk_mesh_fault fault = gjk_mesh_triangle_fault(mesh->vertices, mesh->vertex_count, triangle, &corner);
    if (fault == asked) {
      return note_fault(report, asked, t, corner, 0);
    }
    for (unsigned i = 0; i < 3 && asked == GJK_MESH_NUMBER_FAULT; i++) {
      if (triangle->corner[i] >> 30 != 0) {
        return note_fault(report, asked, t, i, 0);
      }
    }
  }
  return false;
}

// Pre: the box was found so far from the triangles.
static bool has_wrong_steps(const gjk_mesh *mesh, gjk_mesh_report *report) {
  gjk_vec3 lower, upper, corner[3];
  gjk_triangle_start_box(&lower, &upper);
  for (uint32_t t = 0; t < mesh->triangle_count; t++) {
    (void)gjk_mesh_corners(mesh, t, corner);
    for (unsigned k = 0; k < 3; k++) {
      gjk_triangle_widen(&lower, &upper, &corner[k]);
    }
  }
  const bool right = gjk_same_place(&lower, &mesh->lower) && gjk_same_place(&upper, &mesh->upper) &&
                     mesh->shift[0] < 32 && mesh->shift[1] < 32 && mesh->shift[2] < 32 &&
                     ((uint32_t)upper.x - (uint32_t)lower.x) >> mesh->shift[0] <= UINT16_MAX &&
                     ((uint32_t)upper.y - (uint32_t)lower.y) >> mesh->shift[1] <= UINT16_MAX &&
                     ((uint32_t)upper.z - (uint32_t)lower.z) >> mesh->shift[2] <= UINT16_MAX;
  return !right && note_fault(report, GJK_MESH_SHIFT, 0, 0, 0);
}

static bool holds(const gjk_mesh_node *node, const gjk_mesh_node *inner) {
  return node->lower[0] <= inner->lower[0] && node->lower[1] <= inner->lower[1] && node->lower[2] <= inner->lower[2] &&
         node->upper[0] >= inner->upper[0] && node->upper[1] >= inner->upper[1] && node->upper[2] >= inner->upper[2];
}

// Every node on the way down to a triangle's leaf holds the triangle.
static bool has_wrong_box(const gjk_mesh *mesh, gjk_mesh_report *report) {
  const uint32_t leaves = gjk_mesh_leaves(mesh->triangle_count);
  for (uint32_t t = 0; t < mesh->triangle_count; t++) {
    const uint32_t leaf = t / GJK_MESH_LEAF;
    gjk_vec3 corner[3], lower, upper;
    gjk_mesh_node steps;
    (void)gjk_mesh_corners(mesh, t, corner);
    gjk_set(&corner[0], &lower);
    gjk_set(&corner[0], &upper);
    gjk_triangle_widen(&lower, &upper, &corner[1]);
    gjk_triangle_widen(&lower, &upper, &corner[2]);
    gjk_mesh_steps_of(mesh, &lower, &upper, &steps);
    for (unsigned level = 0; level == 0 || leaves > UINT32_C(1) << (level - 1); level++) {  // leaves < 2^25
      const uint32_t first = leaf >> level << level;
      const uint32_t node = gjk_mesh_node_number(first, gjk_mesh_level(first, level, leaves));
      if (!holds(&mesh->nodes[node], &steps)) {
        return note_fault(report, GJK_MESH_BOX, t, 0, node);
      }
    }
  }
  return false;
}

static bool is_flat_line(const gjk_vec3 corner[3]) {
  gjk_long3 n;
  gjk_triangle_normal(&corner[0], &corner[1], &corner[2], &n);
  return n.x == 0 && n.y == 0 && n.z == 0;
}

// The first of each fault that edges can have, in their order. Pre: boxes are right.
static void check_edges(const gjk_mesh *mesh, gjk_mesh_report *report) {
  uint32_t edges[4];
  gjk_zero(edges, sizeof edges);
  for (uint32_t t = 0; t < mesh->triangle_count; t++) {
    gjk_vec3 corner[3];
    (void)gjk_mesh_corners(mesh, t, corner);
    if (is_flat_line(corner) && (report->fault == GJK_MESH_SOUND || report->fault > GJK_MESH_DEGENERATE)) {
      (void)note_fault(report, GJK_MESH_DEGENERATE, t, 0, 0);
    }
    for (unsigned i = 0; i < 3; i++) {
      gjk_mesh_across across;
      gjk_mesh_look_across(mesh, t, i, &across);
      edges[across.kind]++;
      gjk_mesh_fault fault = GJK_MESH_SOUND;
      if (GJK_MESH_EDGE(mesh->triangles[t].corner[i]) != (uint32_t)across.kind) {
        fault = GJK_MESH_EDGES;
      } else if (across.opposite + across.same > 1) {
        fault = GJK_MESH_CROWDED;
      } else if (across.same != 0 && !mesh->two_sided) {
        fault = GJK_MESH_TURNED;
      }
      if (fault != GJK_MESH_SOUND && (report->fault == GJK_MESH_SOUND || fault < report->fault)) {
        (void)note_fault(report, fault, t, i, 0);
      }
    }
  }
  for (unsigned k = 0; k < 4 && report->fault != GJK_MESH_EDGES; k++) {
    report->edges[k] = edges[k];
  }
}

gjk_status gjk_mesh_check(const gjk_mesh *mesh, gjk_mesh_report *out) {
  if (mesh == NULL || out == NULL || mesh->vertices == NULL || mesh->triangles == NULL || mesh->nodes == NULL) {
    return GJK_ERROR_NULL;
  }
  if (mesh->triangle_count == 0) {
    return GJK_ERROR_EMPTY;
  }
  if (mesh->triangle_count > GJK_MESH_TRIANGLES_MAX || mesh->vertex_count > GJK_MESH_VERTICES_MAX) {
    return GJK_ERROR_RANGE;
  }
  (void)note_fault(out, GJK_MESH_SOUND, 0, 0, 0);
  for (unsigned k = 0; k < 4; k++) {
    out->edges[k] = 0;
  }
  if (!has_wrong_triangle(mesh, out, GJK_MESH_NUMBER_FAULT) && !has_wrong_triangle(mesh, out, GJK_MESH_COORDINATE) &&
      !has_wrong_triangle(mesh, out, GJK_MESH_SIZE) && !has_wrong_steps(mesh, out) && !has_wrong_box(mesh, out)) {
    check_edges(mesh, out);
  }
  return GJK_OK;
}
