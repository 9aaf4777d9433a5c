// Hulls of points for JavaScript.
#include "../gjk_allocate.h"
#include "gjk/hull.h"
#include "gjk_wasm_shape.h"

// Writes vertices and faces into a new block. NULL: no memory, or more corners than a shape can have.
static gjk_wasm_shape *write_shape(const gjk_hull *hull) {
  // A facet of k corners is cut into at most (k - 2) / (GJK_FACE_CORNERS_MAX - 2) more faces, two corners each.
  const uint32_t cuts = hull->corners / (GJK_FACE_CORNERS_MAX - 2);
  const uint32_t corners = hull->dimension < 2 ? 0 : hull->corners + 2 * cuts, faces = hull->faces + cuts;
  const uint16_t corner_room = (uint16_t)(corners < UINT16_MAX ? corners : UINT16_MAX);
  const uint16_t face_room = (uint16_t)(faces < UINT16_MAX ? faces : UINT16_MAX);
  const size_t vertices = 2 * (size_t)hull->vertices * sizeof(gjk_vec3);
  gjk_wasm_shape *made =
      gjk_port_allocate(sizeof *made + vertices + ((size_t)corner_room + face_room) * sizeof(uint16_t));
  if (made == NULL) {
    return gjk_wasm_fails(GJK_ERROR_CAPACITY);
  }
  uint16_t *corner = (uint16_t *)(made->vertices + 2 * (size_t)hull->vertices);
  gjk_status status = gjk_hull_vertices(hull, made->vertices, hull->vertices);
  if (status == GJK_OK && corners > 0) {
    status = gjk_hull_write_faces(hull, corner, corner_room, corner + corner_room, face_room, &made->faces);
  }
  if (status != GJK_OK) {
    gjk_port_release(made);
    return gjk_wasm_fails(status);
  }
  const gjk_shape shape =
      GJK_ROUNDED_HULL_WITH_FACES(made->vertices, hull->vertices, corners > 0 ? &made->faces : NULL, 0);
  made->shape = shape;
  return made;
}

gjk_collider *gjk_wasm_hull_build(const int32_t *points, unsigned count, int32_t convex_radius) {
  if (count == 0 || count > GJK_HULL_POINTS_MAX) {
    return gjk_wasm_fails(count == 0 ? GJK_ERROR_EMPTY : GJK_ERROR_RANGE);
  }
  gjk_hull hull;
  void *workspace = gjk_port_allocate(GJK_HULL_WORKSPACE(count));
  if (workspace == NULL) {
    return gjk_wasm_fails(GJK_ERROR_CAPACITY);
  }
  // The three numbers of a point are a gjk_vec3.
  const gjk_status status =
      gjk_hull_build((const gjk_vec3 *)points, (uint16_t)count, workspace, GJK_HULL_WORKSPACE(count), &hull);
  gjk_wasm_shape *made = status == GJK_OK ? write_shape(&hull) : gjk_wasm_fails(status);
  gjk_port_release(workspace);
  if (made == NULL) {
    return NULL;
  }
  made->shape.convex_radius = convex_radius;
  return gjk_wasm_finish(made);
}

static int32_t address(const void *pointer) {
  return (int32_t)(uintptr_t)pointer;
}

void gjk_wasm_polyhedron(const gjk_collider *collider) {
  const gjk_shape *shape = collider->shape;
  const gjk_hull_faces *faces = shape->faces;
  gjk_wasm_begin();
  gjk_wasm_put(address(shape->vertices));
  gjk_wasm_put(shape->count);
  gjk_wasm_put(faces != NULL ? faces->count : 0);
  gjk_wasm_put(faces != NULL ? address(faces->corner) : 0);
  gjk_wasm_put(faces != NULL ? address(faces->end) : 0);
}
