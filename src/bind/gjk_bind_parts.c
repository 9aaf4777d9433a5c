// Bodies of many parts, and the room that results need, by functions for other languages.
#include "gjk/bind.h"
#include "gjk/hull.h"

static gjk_status take_parts(const gjk_parts *parts, gjk_parts *out) {
  if (parts->data == NULL || out == NULL) {
    return GJK_ERROR_NULL;
  }
  *out = *parts;
  return GJK_OK;
}

gjk_status gjk_parts_of_compound(const gjk_compound *compound, gjk_parts *out) {
  const gjk_parts parts = GJK_PARTS_OF_COMPOUND(compound);
  return take_parts(&parts, out);
}

gjk_status gjk_parts_of_mesh(const gjk_mesh *mesh, gjk_parts *out) {
  const gjk_parts parts = GJK_PARTS_OF_MESH(mesh);
  return take_parts(&parts, out);
}

gjk_status gjk_parts_of_height_field(const gjk_height_field *field, gjk_parts *out) {
  const gjk_parts parts = GJK_PARTS_OF_HEIGHT_FIELD(field);
  return take_parts(&parts, out);
}

uint32_t gjk_compound_nodes(uint32_t parts) {
  return parts <= GJK_COMPOUND_PARTS_MAX ? GJK_COMPOUND_NODES(parts) : 0;
}

uint32_t gjk_mesh_nodes(uint32_t triangles) {
  return triangles > 0 && triangles <= GJK_MESH_TRIANGLES_MAX ? GJK_MESH_NODES(triangles) : 0;
}

uint32_t gjk_table_cells(uint8_t level) {
  return level <= GJK_TABLE_LEVEL_MAX ? (uint32_t)GJK_TABLE_CELLS(level) : 0;
}

uint32_t gjk_hull_workspace(uint32_t points) {
  return points <= GJK_HULL_POINTS_MAX ? GJK_HULL_WORKSPACE(points) : 0;
}

uint32_t gjk_hull_simplify_workspace(uint32_t points) {
  return points <= GJK_HULL_POINTS_MAX ? GJK_HULL_SIMPLIFY_WORKSPACE(points) : 0;
}
