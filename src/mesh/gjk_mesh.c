// The class of meshes: their triangles as parts of a body.
#include "gjk_mesh_tree.h"

static const gjk_mesh *mesh_of(const void *data) {
  return (const gjk_mesh *)data;
}

static uint32_t count_of_mesh(const void *data) {
  const gjk_mesh *m = mesh_of(data);
  return m->vertices == NULL || m->triangles == NULL || m->nodes == NULL || m->triangle_count > GJK_MESH_TRIANGLES_MAX
             ? 0
             : m->triangle_count;
}

static uint32_t reach_of_mesh(const void *data) {
  return gjk_triangle_reach(&mesh_of(data)->lower, &mesh_of(data)->upper);
}

// Down to a leaf, always to the nearer one of two nodes; there the first triangle whose box is nearest.
static uint32_t guess_in_mesh(const void *data, const gjk_region *region) {
  const gjk_mesh *m = mesh_of(data);
  const uint32_t leaves = gjk_mesh_leaves(m->triangle_count);
  uint32_t leaf = 0, best = 0;
  unsigned level = gjk_mesh_level(0, GJK_MESH_LEVEL_MAX, leaves);
  while (level > 0) {
    const uint32_t right = leaf + (UINT32_C(1) << (level - 1));
    const unsigned right_level = gjk_mesh_level(right, level - 1, leaves);
    level--;
    if (gjk_mesh_node_gap(m, gjk_mesh_node_number(right, right_level), region) <
        gjk_mesh_node_gap(m, gjk_mesh_node_number(leaf, level), region)) {
      leaf = right;
      level = right_level;
    }
  }
  int64_t least = INT64_MAX;
  for (uint32_t t = leaf * GJK_MESH_LEAF; t < m->triangle_count && t < (leaf + 1) * GJK_MESH_LEAF; t++) {
    gjk_vec3 corner[3];
    const int64_t gap = gjk_mesh_corners(m, t, corner) ? gjk_triangle_gap(corner, region) : INT64_MAX;
    if (gap < least) {
      least = gap;
      best = t;
    }
  }
  return best;
}

static bool next_in_mesh(const void *data, const gjk_region *region, gjk_parts_walk *walk, uint32_t *number) {
  gjk_vec3 corner[3];
  return gjk_mesh_next(mesh_of(data), region, walk, number, corner);
}

static gjk_status place_in_mesh(const gjk_parts_frame *frame, uint32_t number, gjk_parts_room *room,
                                gjk_collider *out) {
  gjk_vec3 corner[3];
  return gjk_mesh_corners(mesh_of(frame->parts->data), number, corner) ? gjk_triangle_place(frame, corner, room, out)
                                                                       : GJK_ERROR_RANGE;
}

static void local_in_mesh(const void *data, uint32_t number, gjk_parts_room *room, gjk_parts_local *out) {
  gjk_vec3 corner[3];
  if (!gjk_mesh_corners(mesh_of(data), number, corner)) {
    corner[0].x = corner[0].y = corner[0].z = 0;
    gjk_set(&corner[0], &corner[1]);
    gjk_set(&corner[0], &corner[2]);
  }
  gjk_triangle_local(corner, room, out);
}

static unsigned edges_in_mesh(const void *data, uint32_t number) {
  const gjk_mesh *m = mesh_of(data);
  const uint32_t *corner = m->triangles[number].corner;
  return GJK_TRIANGLE_EDGES(GJK_MESH_EDGE(corner[0]), GJK_MESH_EDGE(corner[1]), GJK_MESH_EDGE(corner[2])) |
         (m->two_sided ? GJK_TRIANGLE_TWO_SIDED : 0u);
}

const gjk_parts_class gjk_parts_class_mesh = {
    .count = count_of_mesh,
    .reach = reach_of_mesh,
    .guess = guess_in_mesh,
    .next = next_in_mesh,
    .place = place_in_mesh,
    .local = local_in_mesh,
    .edges = edges_in_mesh,
    .contacts = gjk_surface_contacts,
};
