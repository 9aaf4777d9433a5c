// Bodies of many convex parts, hulls of points and masses for C++17, in the caller's memory: gjk/parts.h, gjk/compound.h,
// gjk/mesh.h, gjk/height_field.h, gjk/concave.h, gjk/hull.h, gjk/mass.h.
//
//     gjk_compound_node nodes[GJK_COMPOUND_NODES(2)];
//     const auto chair = gjk::make_compound(parts, nodes);
//     if (chair) {
//       const gjk_parts body = gjk::parts(*chair);
//       if (auto gap = gjk::distance(body, ball)) use(gap->part, gap->distance);
//     }
#ifndef GJK_PARTS_HPP
#define GJK_PARTS_HPP

#include "gjk.hpp"
#include "gjk/compound.h"
#include "gjk/concave.h"
#include "gjk/height_field.h"
#include "gjk/hull.h"
#include "gjk/mass.h"
#include "gjk/mesh.h"

namespace gjk {

// What bodies are made of. Spans, and what they hold, must outlive it.

inline result<gjk_compound> make_compound(span<const gjk_compound_part> parts, span<gjk_compound_node> nodes) {
  return result<gjk_compound>::of(
      [&](auto *out) { return gjk_compound_build(parts.data(), parts.count(), nodes.data(), nodes.room(), out); });
}

// triangles: three numbers of vertices each; they are put into the mesh's order.
inline result<gjk_mesh> make_mesh(span<const gjk_vec3> vertices, span<gjk_mesh_triangle> triangles,
                                  span<gjk_mesh_node> nodes, bool two_sided = false) {
  return result<gjk_mesh>::of([&](auto *out) {
    return gjk_mesh_build(vertices.data(), vertices.count32(), triangles.data(), triangles.count32(), two_sided,
                          nodes.data(), nodes.count32(), out);
  });
}

inline result<gjk_mesh_report> check(const gjk_mesh &mesh) {
  return result<gjk_mesh_report>::of([&](auto *out) { return gjk_mesh_check(&mesh, out); });
}

[[nodiscard]] inline gjk_status check(const gjk_height_field &field) { return gjk_height_field_check(&field); }

// A body at a pose. What it is made of must outlive it, so a temporary does not compile.
inline gjk_parts parts(const gjk_compound &compound, const gjk_pose &pose = origin) {
  return {&gjk_parts_class_compound, &compound, pose};
}
inline gjk_parts parts(const gjk_mesh &mesh, const gjk_pose &pose = origin) {
  return {&gjk_parts_class_mesh, &mesh, pose};
}
inline gjk_parts parts(const gjk_height_field &field, const gjk_pose &pose = origin) {
  return {&gjk_parts_class_height_field, &field, pose};
}
gjk_parts parts(const gjk_compound &&, const gjk_pose & = origin) = delete;
gjk_parts parts(const gjk_mesh &&, const gjk_pose & = origin) = delete;
gjk_parts parts(const gjk_height_field &&, const gjk_pose & = origin) = delete;

// A shape for scenes alone, of a body whose pose does not count. memory must outlive it.
inline result<gjk_shape> concave(const gjk_parts &body, gjk_concave &memory) {
  return result<gjk_shape>::of([&](auto *out) { return gjk_concave_init(&body, &memory, out); });
}

// The collider of one part. room must outlive it.
inline result<gjk_collider> place(const gjk_parts &body, uint32_t number, gjk_parts_room &room) {
  return result<gjk_collider>::of([&](auto *out) { return gjk_parts_place(&body, number, &room, out); });
}

// Queries of a body as A.

// The answer of a pair's query, with the number of the part that it is of, or GJK_PARTS_NONE.
template <typename Answer>
struct of_part : Answer {
  uint32_t part;
};

inline result<of_part<gjk_decision>> intersect(const gjk_parts &a, const gjk_collider &b) {
  return result<of_part<gjk_decision>>::of([&](auto *out) { return gjk_parts_intersect(&a, &b, &out->part, out); });
}

inline result<of_part<gjk_decision>> within(const gjk_parts &a, const gjk_collider &b, gjk_q16 most) {
  return result<of_part<gjk_decision>>::of([&](auto *out) { return gjk_parts_within(&a, &b, most, &out->part, out); });
}

inline result<of_part<gjk_distance_result>> distance(const gjk_parts &a, const gjk_collider &b) {
  return result<of_part<gjk_distance_result>>::of(
      [&](auto *out) { return gjk_parts_distance(&a, &b, &out->part, out); });
}

inline result<of_part<gjk_penetration_result>> penetration(const gjk_parts &a, const gjk_collider &b,
                                                           const gjk_workspace &memory = no_workspace) {
  return result<of_part<gjk_penetration_result>>::of(
      [&](auto *out) { return gjk_parts_penetration(&a, &b, &memory, &out->part, out); });
}

// The contacts of each part: how many manifolds there are, of which the first stand in room.
inline result<uint32_t> contacts(const gjk_parts &a, const gjk_collider &b, span<gjk_parts_manifold> room,
                                 gjk_q16 margin = 0, unsigned most = 4, const gjk_workspace &memory = no_workspace) {
  return result<uint32_t>::of(
      [&](auto *out) { return gjk_parts_contacts(&a, &b, margin, most, &memory, room.data(), room.count32(), out); });
}

// The contacts of all parts, put together by their normals, for a solver: how many manifolds there are in room.
inline result<unsigned> manifolds(const gjk_parts &a, const gjk_collider &b, span<gjk_manifold> room,
                                  gjk_q16 margin = 0, unsigned most = 4, const gjk_workspace &memory = no_workspace) {
  return result<unsigned>::of(
      [&](auto *out) { return gjk_parts_manifolds(&a, &b, margin, most, &memory, room.data(), room.count(), out); });
}

inline result<of_part<gjk_cast_result>> cast(const gjk_parts &a, const gjk_collider &b, const gjk_cast_path &path) {
  return result<of_part<gjk_cast_result>>::of(
      [&](auto *out) { return gjk_parts_cast(&a, &b, &path, &out->part, out); });
}

inline result<of_part<gjk_cast_result>> cast_ray(const gjk_parts &a, const gjk_vec3 &from, const gjk_vec3 &to) {
  return result<of_part<gjk_cast_result>>::of(
      [&](auto *out) { return gjk_parts_cast_ray(&a, &from, &to, &out->part, out); });
}

// Hulls of points.

// workspace: at least GJK_HULL_WORKSPACE(points) bytes. It holds the hull, and points must outlive that.
inline result<gjk_hull> hull_build(span<const gjk_vec3> points, span<uint32_t> workspace) {
  return result<gjk_hull>::of([&](auto *out) {
    return gjk_hull_build(points.data(), points.count(), workspace.data(), 4 * workspace.size(), out);
  });
}

[[nodiscard]] inline gjk_status hull_vertices(const gjk_hull &hull, span<gjk_vec3> room) {
  return gjk_hull_vertices(&hull, room.data(), room.room());
}

// Room for the corners of all faces, and for their ends. The faces point into both.
inline result<gjk_hull_faces> hull_faces(const gjk_hull &hull, span<uint16_t> corner, span<uint16_t> end) {
  return result<gjk_hull_faces>::of([&](auto *out) {
    return gjk_hull_write_faces(&hull, corner.data(), corner.room(), end.data(), end.room(), out);
  });
}

// room: of as many vertices as are wanted. workspace: at least GJK_HULL_SIMPLIFY_WORKSPACE(points) bytes.
inline result<gjk_hull_simple> hull_simplify(span<const gjk_vec3> points, span<gjk_vec3> room,
                                             span<uint32_t> workspace) {
  return result<gjk_hull_simple>::of([&](auto *out) {
    return gjk_hull_simplify(points.data(), points.count(), room.room(), workspace.data(), 4 * workspace.size(),
                             room.data(), out);
  });
}

inline result<gjk_hull_report> hull_check(span<const gjk_vec3> vertices, const gjk_hull_faces &faces) {
  return result<gjk_hull_report>::of(
      [&](auto *out) { return gjk_hull_check(vertices.data(), vertices.count(), &faces, out); });
}

// Masses.

inline result<gjk_mass> mass(const gjk_shape &shape) {
  return result<gjk_mass>::of([&](auto *out) { return gjk_mass_of_shape(&shape, out); });
}

inline result<gjk_mass> mass(const gjk_hull &hull) {
  return result<gjk_mass>::of([&](auto *out) { return gjk_mass_of_hull(&hull, out); });
}

[[nodiscard]] inline gjk_status set_density(gjk_mass &body, uint32_t density) {
  return gjk_mass_set_density(&body, density);
}

// Adds a part at a pose to a body, which begins as {}.
[[nodiscard]] inline gjk_status add(gjk_mass &body, const gjk_mass &part, const gjk_pose &pose = origin) {
  return gjk_mass_add(&body, &part, &pose);
}

inline result<gjk_principal> principal(const gjk_mass &body) {
  return result<gjk_principal>::of([&](auto *out) { return gjk_mass_principal(&body, out); });
}

}  // namespace gjk

#endif
