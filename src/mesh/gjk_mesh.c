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

GJK_ONE_COPY static int32_t grown_end(int32_t x, int64_t by) {
  return gjk_saturate((int64_t)x + by);
}

// The region's box, grown.
static void grow_box(const gjk_region *region, int64_t by, gjk_region *out) {
  const gjk_aabb *box = &region->box;
  out->moves = false;
  out->box.lower.x = grown_end(box->lower.x, -by);
  out->box.lower.y = grown_end(box->lower.y, -by);
  out->box.lower.z = grown_end(box->lower.z, -by);
  out->box.upper.x = grown_end(box->upper.x, by);
  out->box.upper.y = grown_end(box->upper.y, by);
  out->box.upper.z = grown_end(box->upper.z, by);
}

// The most triangles that a guess looks at.
#define GUESS_MAX 16

// Of the triangles whose boxes meet that of the region, grown until there are some, the one that is nearest to it. It grows
// by a fifth of its own size or so first, or by what lies between it and the mesh, then by twice as much each time. Nodes of
// the tree do not lead there: those that a step of the Z-order curve crosses are large.
static uint32_t guess_in_mesh(const void *data, const gjk_region *region) {
  const gjk_mesh *m = mesh_of(data);
  const gjk_aabb *box = &region->box;
  const int64_t size = (int64_t)box->upper.x - box->lower.x + box->upper.y - box->lower.y + box->upper.z - box->lower.z;
  gjk_region grown;
  uint32_t best = 0, number;
  int64_t least = INT64_MAX;
  for (int64_t by = gjk_box_gap(&m->lower, &m->upper, region) + gjk_sar64(size, 4) + 1;
       by < INT64_C(1) << 34 && least == INT64_MAX; by *= 2) {  // ends: at most 34 times
    gjk_parts_walk walk;
    gjk_vec3 corner[3];
    grow_box(region, by, &grown);
    gjk_parts_walk_start(&walk);
    for (unsigned i = 0; i < GUESS_MAX && gjk_mesh_next(m, &grown, &walk, &number, corner); i++) {
      const int64_t distance = gjk_triangle_distance(corner, region);
      if (distance < least) {
        least = distance;
        best = number;
      }
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

static gjk_status local_in_mesh(const void *data, uint32_t number, gjk_parts_room *room, gjk_parts_local *out) {
  gjk_vec3 corner[3];
  if (!gjk_mesh_corners(mesh_of(data), number, corner)) {
    return GJK_ERROR_RANGE;
  }
  gjk_triangle_local(corner, room, out);
  return GJK_OK;
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
    .settle = gjk_surface_settle,
    .meet = gjk_surface_meet,
    .edges = edges_in_mesh,
};
