// Surfaces as a line, as C.
#include "write_mesh.h"

#include <stdio.h>
#include <stdlib.h>

void built_mesh_free(built_mesh *s) {
  free(s->triangles);
  free(s->nodes);
}

bool built_mesh_of(built_mesh *s, const mesh *m, bool two_sided, char *problem, size_t room) {
  const uint32_t count = m->triangles <= GJK_MESH_TRIANGLES_MAX ? (uint32_t)m->triangles : 0;
  if (count == 0) {
    snprintf(problem, room, m->triangles == 0 ? "no triangles" : "too many triangles");
    return false;
  }
  const uint32_t nodes = GJK_MESH_NODES(count);
  s->triangles = malloc(count * sizeof s->triangles[0]);
  s->nodes = malloc(nodes * sizeof s->nodes[0]);
  if (s->triangles == NULL || s->nodes == NULL) {
    snprintf(problem, room, "out of memory");
    built_mesh_free(s);
    return false;
  }
  for (uint32_t i = 0; i < count; i++) {
    for (int k = 0; k < 3; k++) {
      s->triangles[i].corner[k] = m->triangle[i][k];
    }
  }
  const gjk_status status =
      gjk_mesh_build(m->point, (uint32_t)m->points, s->triangles, count, two_sided, s->nodes, nodes, &s->mesh);
  if (status != GJK_OK || gjk_mesh_check(&s->mesh, &s->report) != GJK_OK) {
    snprintf(problem, room,
             status == GJK_ERROR_SIZE ? "a triangle is longer than 4095 units along an axis"
                                      : "a point is more than 16384 units from the origin along an axis");
    built_mesh_free(s);
    return false;
  }
  return true;
}

const char *built_mesh_fault(unsigned fault) {
  switch (fault) {
    case GJK_MESH_SOUND: return "none";
    case GJK_MESH_DEGENERATE: return "a triangle without area";
    case GJK_MESH_CROWDED: return "an edge of more than two triangles";
    case GJK_MESH_TURNED: return "a triangle that is turned over against its neighbour";
    default: return "not as it was built";
  }
}

void write_mesh_info(const built_mesh *s, bool watertight) {
  const uint32_t *edges = s->report.edges;
  printf("triangles=%lu vertices=%lu convex=%lu flat=%lu concave=%lu open=%lu fault=%u watertight=%s\n",
         (unsigned long)s->mesh.triangle_count, (unsigned long)s->mesh.vertex_count,
         (unsigned long)edges[GJK_MESH_CONVEX], (unsigned long)edges[GJK_MESH_FLAT],
         (unsigned long)edges[GJK_MESH_CONCAVE], (unsigned long)edges[GJK_MESH_OPEN], s->report.fault,
         watertight ? "yes" : "no");
}

void write_mesh_source(const built_mesh *s, const char *name) {
  const gjk_mesh *made = &s->mesh;
  const unsigned long nodes = GJK_MESH_NODES(made->triangle_count);
  printf("// Made by gjk-convert: a surface of triangles, Q16.16.\n#include \"gjk/mesh.h\"\n\n");
  printf("static const gjk_vec3 %s_vertices[%lu] = {\n", name, (unsigned long)made->vertex_count);
  for (uint32_t i = 0; i < made->vertex_count; i++) {
    const gjk_vec3 *v = &made->vertices[i];
    printf("    {%ld, %ld, %ld},\n", (long)v->x, (long)v->y, (long)v->z);
  }
  printf("};\nstatic const gjk_mesh_triangle %s_triangles[%lu] = {\n", name, (unsigned long)made->triangle_count);
  for (uint32_t i = 0; i < made->triangle_count; i++) {
    const uint32_t *corner = made->triangles[i].corner;
    printf("    {{0x%08lX, 0x%08lX, 0x%08lX}},\n", (unsigned long)corner[0], (unsigned long)corner[1],
           (unsigned long)corner[2]);
  }
  printf("};\nstatic const gjk_mesh_node %s_nodes[%lu] = {\n", name, nodes);
  for (uint32_t i = 0; i < nodes; i++) {
    const uint16_t *low = made->nodes[i].lower, *high = made->nodes[i].upper;
    printf("    {{%u, %u, %u}, {%u, %u, %u}},\n", low[0], low[1], low[2], high[0], high[1], high[2]);
  }
  printf(
      "};\nconst gjk_mesh %s = {%s_vertices, %s_triangles, %s_nodes, %lu, %lu, {%ld, %ld, %ld}, {%ld, %ld, %ld}, "
      "{%u, %u, %u}, %s};\n",
      name, name, name, name, (unsigned long)made->vertex_count, (unsigned long)made->triangle_count,
      (long)made->lower.x, (long)made->lower.y, (long)made->lower.z, (long)made->upper.x, (long)made->upper.y,
      (long)made->upper.z, made->shift[0], made->shift[1], made->shift[2], made->two_sided ? "true" : "false");
}
