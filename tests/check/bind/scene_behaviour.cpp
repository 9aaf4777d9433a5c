// What gjk_scene.hpp and gjk_parts.hpp do around the calls: memory of any size, full tables, wrong ids, saves, bodies of
// many parts, hulls, masses. Exits with 0 if all is as it should be.
#include <cstdio>
#include <utility>
#include <vector>

#include "gjk_parts.hpp"
#include "gjk_scene.hpp"

using namespace gjk::literals;

namespace {

constexpr gjk_shape slab = gjk::box(9_q16, 9_q16, 0.5_q16), crate = gjk::box(0.5_q16, 0.5_q16, 0.5_q16);
constexpr gjk_shape ball = gjk::sphere(0.5_q16);
constexpr const gjk_shape *shapes[] = {&slab, &crate, &ball};
constexpr gjk_part parts[] = {gjk::part(0), gjk::part(1), gjk::part(2), gjk::part(2, {{0, 0, 1_q16}, gjk::upright})};
constexpr gjk_vec3 cube[] = {{-1_q16, -1_q16, -1_q16}, {-1_q16, -1_q16, 1_q16}, {-1_q16, 1_q16, -1_q16},
                             {-1_q16, 1_q16, 1_q16},   {1_q16, -1_q16, -1_q16}, {1_q16, -1_q16, 1_q16},
                             {1_q16, 1_q16, -1_q16},   {1_q16, 1_q16, 1_q16},   {0, 0, 0}};

// What a body is made of may be no temporary: nothing may point to it afterwards.
template <typename Kind, typename = void>
constexpr bool has_parts = false;
template <typename Kind>
constexpr bool has_parts<Kind, decltype(void(gjk::parts(std::declval<Kind>())))> = true;
static_assert(has_parts<const gjk_mesh &> && has_parts<gjk_compound &> && has_parts<const gjk_height_field &>);
static_assert(!has_parts<gjk_mesh> && !has_parts<gjk_compound> && !has_parts<const gjk_height_field>);

int failed = 0;

void check(bool condition, const char *what) {
  if (!condition) {
    std::printf("failed: %s\n", what);
    failed++;
  }
}

constexpr gjk_pose at(gjk_q16 x, gjk_q16 y, gjk_q16 z) {
  return {{x, y, z}, gjk::upright};
}

gjk_body_setup of(size_t first, const gjk_pose &pose, size_t count = 1) {
  return gjk::body({parts + first, count}, pose, first == 0 ? GJK_BODY_STATIC : GJK_BODY_DYNAMIC);
}

gjk_scene_bindings with_contacts(gjk_manifold *manifolds) {
  gjk_scene_bindings bindings = {};
  bindings.details = &gjk_scene_contacts;
  bindings.manifolds = manifolds;
  bindings.motion = &gjk_scene_motion;
  return bindings;
}

void scenes() {
  gjk_manifold room[4];
  gjk_scene_config config = gjk::scene_config(4, GJK_DETAIL_CONTACTS);
  config.motions = 1;
  config.own_poses = 1;
  std::vector<uint32_t> block(gjk_scene_bytes(&config) / 4);
  auto scene = gjk::make_scene(config, block, shapes, with_contacts(room));
  check(static_cast<bool>(scene), "a scene");
  const auto floor = gjk::add(*scene, of(0, gjk::origin)), falling = gjk::add(*scene, of(1, at(0, 0, 0.9_q16)));
  check(floor && falling && *floor != *falling, "bodies");
  gjk_report reports[4];
  const auto progress = gjk::update(*scene, reports);
  check(progress && progress->reports == 1 && progress->reports_left == 0, "an update");
  check(reports[0].a == *floor && reports[0].manifold == room && room[0].count == 4, "its report");
  check(*gjk::manifolds(*scene, reports[0], room) == 1, "manifolds");
  check(gjk::stats(*scene)->manifolds == 1 && gjk::check(*scene) == GJK_OK, "statistics");
  check(gjk::remove(*scene, *falling) == GJK_OK, "removed");
  unsigned ends = 0;
  const auto count_ends = [&](const gjk_report &report) { ends += report.event == GJK_EVENT_END; };
  check(gjk::update_each(*scene, count_ends) == GJK_OK && ends == 1, "an end");
  const auto bullet = gjk::add(*scene, of(2, at(5_q16, 0, 5_q16)));
  check(gjk::set_motion(*scene, *bullet, GJK_MOTION_FAST) == GJK_OK, "a fast body");
  check(gjk::update(*scene, reports)->reports == 0, "nothing yet");
  check(gjk::move(*scene, *bullet, at(5_q16, 0, -5_q16)) == GJK_OK, "a way through the floor");
  check(gjk::update(*scene, reports)->reports == 1 && reports[0].event == GJK_EVENT_IMPACT, "an impact");
}

void queries() {
  const gjk_scene_config config = gjk::scene_config(4);
  std::vector<uint32_t> block(gjk_scene_bytes(&config) / 4);
  auto scene = gjk::make_scene(config, block, shapes);
  const auto floor = gjk::add(*scene, of(0, gjk::origin)), above = gjk::add(*scene, of(1, at(0, 0, 5_q16)));
  const gjk_vec3 from = {0, 0, 9_q16}, to = {0, 0, -9_q16};
  const auto ray = gjk::cast_ray(*scene, from, to);
  check(ray && ray->found && ray->hit.body == *above && ray->answer.point_a.z == 5.5_q16, "a ray");
  const gjk_scene_filter others = {UINT32_MAX, UINT32_MAX, *above, nullptr, nullptr};
  check(gjk::cast_ray(*scene, from, to, &others)->hit.body == *floor, "a ray that ignores a body");
  check(!gjk::cast_ray(*scene, from, {0, 0, 8_q16})->found, "a ray that is too short");
  gjk_scene_hit hits[1];
  check(*gjk::cast_ray_all(*scene, from, to, hits) == 2 && hits[0].body == *above, "two hits and room for one");
  check(*gjk::cast_ray_all(*scene, from, to, hits, nullptr, &ray->hit) == 1 && hits[0].body == *floor, "the other one");
  check(*gjk::cast_ray_all(*scene, from, to, {}) == 2, "no room");
  const auto probe = gjk::place(ball, at(4_q16, 0, 3_q16));
  check(gjk::cast(*scene, *probe, {4_q16, 0, 0})->hit.body == *floor, "a cast");
  check(*gjk::within(*scene, *probe, 9_q16, hits) == 2 && *gjk::within(*scene, *probe, 0, hits) == 0, "near");
  check(gjk::nearest(*scene, *probe, 9_q16)->distance == 2_q16 && !gjk::nearest(*scene, *probe, 1)->found, "nearest");
  check(gjk::nearest(*scene, *probe, -1).status() == GJK_ERROR_NEGATIVE, "a reach below 0");
  check(gjk::distance(*gjk::collider(*scene, *above), *probe)->distance > 0, "a part as a collider");
}

// Memory from none to just enough, tables that are full, ids that are none. Nothing changes the scene.
void refused() {
  gjk_scene_config config = gjk::scene_config(2);
  config.pairs = 1;
  const size_t words = gjk_scene_bytes(&config) / 4;
  std::vector<uint32_t> block(words);
  for (size_t size = 0; size < words; size += 1 + size / 8) {
    check(gjk::make_scene(config, {block.data(), size}, shapes).status() == GJK_ERROR_CAPACITY, "too small a block");
  }
  check(gjk::make_scene(config, {block.data(), words - 1}, shapes).status() == GJK_ERROR_CAPACITY, "a word too few");
  check(gjk::make_scene(gjk::scene_config(0), block, shapes).status() == GJK_ERROR_RANGE, "no bodies");
  check(gjk::make_scene(config, {}, shapes).status() == GJK_ERROR_NULL, "no block");
  auto scene = gjk::make_scene(config, block, shapes);
  check(gjk::add(*scene, gjk::body({})).status() == GJK_ERROR_NULL, "no parts");
  const auto first = gjk::add(*scene, of(2, gjk::origin)), second = gjk::add(*scene, of(2, at(0, 0, 0.5_q16)));
  const auto full = gjk::hash(*scene);
  check(gjk::add(*scene, of(2, gjk::origin)).status() == GJK_ERROR_CAPACITY, "no slot");
  check(gjk::add_at(*scene, 0, of(2, gjk::origin)).status() == GJK_ERROR_BODY_ID, "a slot that is taken");
  check(gjk::add_at(*scene, 2, of(2, gjk::origin)).status() == GJK_ERROR_CAPACITY, "a slot that is not there");
  check(gjk::move(*scene, *first, {{0, 0, 0}, {0, 0, 0, 5}}) == GJK_ERROR_ROTATION, "a pose that is none");
  check(gjk::set_shape(*scene, *first, 0, 3) == GJK_ERROR_RANGE, "a shape that is not there");
  check(gjk::set_motion(*scene, *first, GJK_MOTION_FAST) == GJK_ERROR_UNSUPPORTED, "motions are not bound");
  const gjk_body_id wrong[] = {{0, 0}, {0, 3}, {9, 1}, {1u << 20, 1}};
  for (const gjk_body_id &id : wrong) {
    check(gjk::move(*scene, id, gjk::origin) == GJK_ERROR_BODY_ID, "moved, by a wrong id");
    check(gjk::remove(*scene, id) == GJK_ERROR_BODY_ID && gjk::sleep(*scene, id) == GJK_ERROR_BODY_ID, "a wrong id");
    check(gjk::get(*scene, id).status() == GJK_ERROR_BODY_ID, "what is not there");
    check(gjk::collider(*scene, id).status() == GJK_ERROR_BODY_ID, "the collider of none");
  }
  check(gjk::hash(*scene).value_or(0) == full.value_or(1), "the scene is as it was");
  gjk_report one[1];
  check(gjk::update(*scene, {})->reports_left == 1 && gjk::hash(*scene).status() == GJK_ERROR_BUSY,
        "no room to report");
  check(gjk::move(*scene, *first, gjk::origin) == GJK_ERROR_BUSY, "a move within an update");
  check(gjk::update(*scene, one)->reports == 1 && gjk::update(*scene, one)->reports == 0, "the report, with room");
  check(gjk::remove(*scene, *second) == GJK_OK && gjk::sleep(*scene, *second) == GJK_ERROR_BODY_ID, "a stale id");
  // Two pairs and room for one.
  config.bodies = config.parts = 3;
  std::vector<uint32_t> larger(gjk_scene_bytes(&config) / 4);
  auto crowded = gjk::make_scene(config, larger, shapes);
  for (gjk_q16 z = 0; z < 1.5_q16; z += 0.5_q16) {
    check(static_cast<bool>(gjk::add(*crowded, of(2, at(0, 0, z)))), "a crowd");
  }
  check(gjk::update(*crowded, one).status() == GJK_ERROR_CAPACITY, "no room for pairs");
  check(gjk::remove(*crowded, {0, 1}) == GJK_OK && gjk::update(*crowded, one)->reports == 1, "an update after that");
}

void saves() {
  const gjk_scene_config config = gjk::scene_config(2);
  std::vector<uint32_t> block(gjk_scene_bytes(&config) / 4), copy;
  auto scene = gjk::make_scene(config, block, shapes);
  const auto id = gjk::add(*scene, of(1, gjk::origin));
  const auto before = gjk::hash(*scene);
  check(gjk::open_scene(block, shapes).status() == GJK_ERROR_CORRUPT, "a block that is not sealed");
  check(gjk::seal(*scene) == GJK_OK, "sealed");
  copy = block;
  check(gjk::move(*scene, *id, at(1, 0, 0)) == GJK_OK && *gjk::hash(*scene) != *before, "moved");
  const auto opened = gjk::open_scene(copy, shapes), attached = gjk::attach_scene(copy, shapes);
  check(opened && attached && *gjk::hash(*opened) == *before && *gjk::hash(*attached) == *before, "a save");
  check(gjk::open_scene(copy, {shapes, 1}).status() == GJK_ERROR_RANGE, "too few shapes");
  check(gjk::open_scene({copy.data(), copy.size() - 1}, shapes).status() == GJK_ERROR_CAPACITY,
        "a save that is cut off");
  for (size_t i = 0; i < copy.size(); i++) {
    copy[i] ^= 1;
    check(!gjk::open_scene(copy, shapes), "a damaged save");
    copy[i] ^= 1;
  }
}

void many_parts() {
  const gjk_compound_part pair[] = {{&slab, gjk::origin}, {&crate, at(0, 0, 1_q16)}};
  gjk_compound_node nodes[GJK_COMPOUND_NODES(2)];
  check(gjk::make_compound(pair, {nodes, 1}).status() == GJK_ERROR_CAPACITY, "a node too few");
  check(gjk::make_compound({}, nodes).status() == GJK_ERROR_NULL, "a compound of nothing");
  const auto compound = gjk::make_compound(pair, nodes);
  const gjk_parts body = gjk::parts(*compound);
  const auto probe = gjk::place(ball, at(0, 0, 3_q16));
  const auto gap = gjk::distance(body, *probe);
  gjk_parts_room room;
  const auto part = gjk::place(body, gap->part, room);
  check(gap && gap->part == 1 && gap->distance == 1_q16 && gjk::check(*part, *probe, *gap) == GJK_OK, "a distance");
  check(gjk::place(body, 2, room).status() == GJK_ERROR_RANGE, "a part that is not there");
  check(gjk::intersect(body, *probe)->part == GJK_PARTS_NONE && gjk::within(body, *probe, 1_q16)->part == 1,
        "decisions");
  const gjk_vec3 down = {0, 0, 0};
  check(gjk::cast(body, *probe, {nullptr, &down, 0})->part == 1, "a cast");
  check(gjk::cast_ray(body, {5_q16, 0, 5_q16}, {5_q16, 0, -5_q16})->part == 0, "a ray");
  const auto deep = gjk::place(ball, at(2_q16, 0, 0.8_q16));
  check(gjk::penetration(body, *deep)->part == 0, "a depth");
  gjk_parts_manifold touching[1];
  const auto both = gjk::contacts(body, *gjk::place(crate, at(0.9_q16, 0, 0.9_q16)), touching);
  check(both.status() == GJK_ERROR_CAPACITY && both.partial() == 2, "two manifolds and room for one");

  gjk_mesh_triangle faces[] = {{{0, 2, 6}}, {{0, 6, 4}}};
  gjk_mesh_node tree[GJK_MESH_NODES(2)];
  check(gjk::make_mesh({cube, 6}, faces, tree).status() == GJK_ERROR_RANGE, "a vertex that is not there");
  check(gjk::make_mesh(cube, faces, {}).status() == GJK_ERROR_NULL, "no nodes");
  check(gjk::make_mesh(cube, faces, {tree, 0}).status() == GJK_ERROR_CAPACITY, "a node too few of a mesh");
  const auto mesh = gjk::make_mesh(cube, faces, tree);
  check(mesh && gjk::check(*mesh)->fault == GJK_MESH_SOUND, "a mesh");
  gjk_manifold manifolds[2];
  const auto on_top = gjk::place(crate, at(0, 0, -0.6_q16));
  check(*gjk::manifolds(gjk::parts(*mesh), *on_top, manifolds) <= 2, "contacts of a surface");

  const int16_t heights[] = {0, 0, 0, 0};
  const gjk_height_field field = GJK_HEIGHT_FIELD(heights, 2, 2, 1_q16, 1_q16, 1), none = {nullptr, 2, 2, 1, 1, 1};
  check(gjk::check(field) == GJK_OK && gjk::check(none) == GJK_ERROR_NULL, "a height field");
  check(gjk::distance(gjk::parts(field), *probe)->distance == 2.5_q16, "the distance of ground");

  gjk_concave memory;
  const auto chair = gjk::concave(body, memory);
  check(chair && gjk::place(*chair).status() == GJK_ERROR_UNSUPPORTED, "a concave shape is no collider");
  const gjk_shape *const concave_shapes[] = {&*chair, &ball};
  const gjk_scene_config config = gjk::scene_config(2);
  std::vector<uint32_t> block(gjk_scene_bytes(&config) / 4);
  auto scene = gjk::make_scene(config, block, concave_shapes);
  gjk_report report[1];
  check(gjk::add(*scene, of(0, gjk::origin)) && gjk::add(*scene, of(1, at(0, 0, 1.9_q16))), "bodies");
  check(gjk::update(*scene, report)->reports == 1, "a concave body in a scene");
}

void solids() {
  std::vector<uint32_t> workspace(GJK_HULL_WORKSPACE(9) / 4);
  for (size_t words = 0; words < workspace.size(); words++) {
    check(!gjk::hull_build(cube, {workspace.data(), words}), "too small a workspace");
  }
  const auto hull = gjk::hull_build(cube, workspace);
  check(hull && hull->vertices == 8 && hull->faces == 6 && hull->corners == 24, "a hull");
  gjk_vec3 vertices[8];
  uint16_t corner[24], end[6];
  check(gjk::hull_vertices(*hull, {vertices, 7}) == GJK_ERROR_CAPACITY, "too few vertices");
  check(gjk::hull_vertices(*hull, vertices) == GJK_OK, "vertices");
  check(gjk::hull_faces(*hull, {corner, 23}, end).status() == GJK_ERROR_CAPACITY, "too few corners");
  check(gjk::hull_faces(*hull, corner, {end, 5}).status() == GJK_ERROR_CAPACITY, "too few faces");
  const auto faces = gjk::hull_faces(*hull, corner, end);
  check(faces && gjk::hull_check(vertices, *faces)->fault == GJK_HULL_SOUND, "faces");
  check(gjk::hull_check({vertices, 7}, *faces)->fault == GJK_HULL_NUMBER, "a vertex that is missing");
  check(gjk::hull_build({}, workspace).status() == GJK_ERROR_NULL, "no points");
  const gjk_vec3 far[] = {{INT32_MIN, 0, 0}, {INT32_MAX, 0, 0}};
  check(gjk::hull_build(far, workspace).status() == GJK_ERROR_SIZE, "points too far apart");
  std::vector<uint32_t> more(GJK_HULL_SIMPLIFY_WORKSPACE(9) / 4);
  gjk_vec3 simple[8];
  check(gjk::hull_simplify(cube, simple, more)->excess == 0, "a hull that is simple");
  check(gjk::hull_simplify(cube, {simple, 3}, more).status() == GJK_ERROR_RANGE, "three vertices");
  check(gjk::hull_simplify(cube, simple, {more.data(), more.size() - 1}).status() == GJK_ERROR_CAPACITY,
        "a word too few");

  const auto shape = gjk::hull(vertices, 0, &*faces);
  auto mass = gjk::mass(shape);
  check(mass && mass->volume.low == UINT64_C(8) << 48 && gjk::mass(*hull)->inertia.xx == mass->inertia.xx, "a mass");
  gjk_mass both = {};
  check(gjk::add(both, *mass) == GJK_ERROR_RANGE, "a part without a mass");
  check(gjk::set_density(*mass, UINT32_MAX) == GJK_ERROR_RANGE && gjk::set_density(*mass, 700_q16) == GJK_OK,
        "density");
  check(gjk::add(both, *mass, at(1_q16, 0, 0)) == GJK_OK && gjk::add(both, *mass, at(-1_q16, 0, 0)) == GJK_OK, "parts");
  const auto axes = gjk::principal(both);
  check(both.centre.x == 0 && axes && axes->moment[0] < axes->moment[1], "principal axes");
  check(gjk::mass(gjk::hull(vertices)).status() == GJK_ERROR_UNSUPPORTED, "a hull without faces");
}

}  // namespace

int main() {
  scenes();
  queries();
  refused();
  saves();
  many_parts();
  solids();
  return failed != 0;
}
