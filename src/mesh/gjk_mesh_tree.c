// The walk through a mesh's tree, and what lies across an edge.
#include "gjk_mesh_tree.h"

uint16_t gjk_mesh_step(int32_t x, int32_t lower, int32_t upper, unsigned shift) {
  x = x < lower ? lower : x > upper ? upper : x;
  const uint32_t steps = ((uint32_t)x - (uint32_t)lower) >> (shift & 31u);
  return steps > UINT16_MAX ? UINT16_MAX : (uint16_t)steps;
}

void gjk_mesh_steps_of(const gjk_mesh *mesh, const gjk_vec3 *lower, const gjk_vec3 *upper, gjk_mesh_node *out) {
  const gjk_vec3 *low = &mesh->lower, *high = &mesh->upper;
  out->lower[0] = gjk_mesh_step(lower->x, low->x, high->x, mesh->shift[0]);
  out->lower[1] = gjk_mesh_step(lower->y, low->y, high->y, mesh->shift[1]);
  out->lower[2] = gjk_mesh_step(lower->z, low->z, high->z, mesh->shift[2]);
  out->upper[0] = gjk_mesh_step(upper->x, low->x, high->x, mesh->shift[0]);
  out->upper[1] = gjk_mesh_step(upper->y, low->y, high->y, mesh->shift[1]);
  out->upper[2] = gjk_mesh_step(upper->z, low->z, high->z, mesh->shift[2]);
}

// The last coordinate of a step.
static int32_t step_end(int32_t lower, uint16_t step, unsigned shift) {
  return gjk_int32((uint32_t)lower + (((uint32_t)step + 1) << (shift & 31u)) - 1);
}

static int32_t step_begin(int32_t lower, uint16_t step, unsigned shift) {
  return gjk_int32((uint32_t)lower + ((uint32_t)step << (shift & 31u)));
}

static void box_of_node(const gjk_mesh *mesh, uint32_t number, gjk_aabb *box) {
  const gjk_mesh_node *node = &mesh->nodes[number];
  const gjk_vec3 *low = &mesh->lower;
  box->lower.x = step_begin(low->x, node->lower[0], mesh->shift[0]);
  box->lower.y = step_begin(low->y, node->lower[1], mesh->shift[1]);
  box->lower.z = step_begin(low->z, node->lower[2], mesh->shift[2]);
  box->upper.x = step_end(low->x, node->upper[0], mesh->shift[0]);
  box->upper.y = step_end(low->y, node->upper[1], mesh->shift[1]);
  box->upper.z = step_end(low->z, node->upper[2], mesh->shift[2]);
}

static bool steps_meet(const gjk_mesh_node *a, const gjk_mesh_node *b) {
  return a->lower[0] <= b->upper[0] && b->lower[0] <= a->upper[0] && a->lower[1] <= b->upper[1] &&
         b->lower[1] <= a->upper[1] && a->lower[2] <= b->upper[2] && b->lower[2] <= a->upper[2];
}

static bool is_on_way(const gjk_mesh *mesh, uint32_t number, const gjk_region *region) {
  gjk_aabb box;
  box_of_node(mesh, number, &box);
  return gjk_region_meets_on_way(region, &box);
}

// steps: those of the region's box.
static inline bool node_meets(const gjk_mesh *mesh, uint32_t number, const gjk_mesh_node *steps,
                              const gjk_region *region) {
  return steps_meet(&mesh->nodes[number], steps) && (!region->moves || is_on_way(mesh, number, region));
}

static bool is_outside(const gjk_mesh *mesh, const gjk_region *region) {
  return gjk_box_gap(&mesh->lower, &mesh->upper, region) > 0;
}

// Finds the next leaf whose box meets a region that does not move, from leaf walk->node on. False: there is none.
static bool next_leaf_in_order(const gjk_mesh *mesh, const gjk_region *region, const gjk_mesh_node *steps,
                               gjk_parts_walk *walk) {
  const uint32_t leaves = gjk_mesh_leaves(mesh->triangle_count);
  uint32_t leaf = walk->node;
  unsigned level = 0;
  bool found = false;
  while (leaf < leaves && !found) {
    // The highest level that begins here: after a node that was left out, or at the start.
    while (level < GJK_MESH_LEVEL_MAX && (leaf >> level & 1u) == 0) {
      level++;
    }
    level = gjk_mesh_level(leaf, level, leaves);
    while (node_meets(mesh, gjk_mesh_node_number(leaf, level), steps, region)) {
      if (level == 0) {
        walk->item = leaf * GJK_MESH_LEAF;
        found = true;
        break;
      }
      level = gjk_mesh_level(leaf, level - 1, leaves);
    }
    leaf += UINT32_C(1) << level;
  }
  walk->node = found ? leaf : leaves;
  return found;
}

// By how much the middle of one node lies above that of another one, LSB, within a step.
//   less than the mesh is long, at most 2^31; of data that were never checked modulo 2^32
static int32_t rise_of_node(const gjk_mesh *mesh, const gjk_mesh_node *from, const gjk_mesh_node *to, unsigned axis) {
  const int32_t steps = (int32_t)to->lower[axis] + to->upper[axis] - from->lower[axis] - from->upper[axis];
  return gjk_shl32(gjk_sar32(steps, 1), mesh->shift[axis] & 31u);
}

// Does a way come to the second of two nodes first?
static bool second_is_first(const gjk_mesh *mesh, const gjk_region *region, uint32_t first, uint32_t second) {
  const gjk_mesh_node *a = &mesh->nodes[first], *b = &mesh->nodes[second];
  const int32_t rise[3] = {rise_of_node(mesh, a, b, 0), rise_of_node(mesh, a, b, 1), rise_of_node(mesh, a, b, 2)};
  return gjk_region_comes_back(region, rise);
}

// As next_leaf_in_order for a region that moves, from near to far. Of two halves that the region meets, the one that the way
// comes to first is next, and the other is put off: bit l of walk->node is 1 while a half of level l or below is.
static bool next_mesh_leaf_on_way(const gjk_mesh *mesh, const gjk_region *region, const gjk_mesh_node *steps,
                                  gjk_parts_walk *walk) {
  const uint32_t leaves = gjk_mesh_leaves(mesh->triangle_count);
  uint32_t leaf = walk->item == 0 ? 0 : (walk->item - 1) / GJK_MESH_LEAF;
  unsigned level = walk->item == 0 ? gjk_mesh_level(0, GJK_MESH_LEVEL_MAX, leaves) : 0;
  bool meets = walk->item == 0 && node_meets(mesh, gjk_mesh_node_number(0, level), steps, region);
  while (level > 0 || !meets) {  // ends: each node comes once
    if (!meets) {
      if (walk->node == 0) {
        return false;
      }
      while (level < GJK_MESH_LEVEL_MAX && (walk->node >> level & 1u) == 0) {
        level++;
      }
      walk->node &= walk->node - 1;
      leaf = (leaf >> level ^ 1u) << level;
      level = gjk_mesh_level(leaf, level, leaves);
      meets = steps_meet(&mesh->nodes[gjk_mesh_node_number(leaf, level)], steps);  // across the way it did
      continue;
    }
    const uint32_t middle = leaf + (UINT32_C(1) << (level - 1)), left = gjk_mesh_node_number(leaf, level - 1);
    const unsigned level_right = gjk_mesh_level(middle, level - 1, leaves);
    const uint32_t right = gjk_mesh_node_number(middle, level_right);
    const bool meets_left = node_meets(mesh, left, steps, region);
    const bool meets_right = node_meets(mesh, right, steps, region);
    const bool goes_right = meets_right && (!meets_left || second_is_first(mesh, region, left, right));
    walk->node |= meets_left && meets_right ? UINT32_C(1) << (level - 1) : 0;
    meets = meets_left || meets_right;
    leaf = goes_right ? middle : leaf;
    level = goes_right ? level_right : level - 1;
  }
  walk->item = leaf * GJK_MESH_LEAF;
  return true;
}

// Finds the next leaf whose box meets the region; false: there is none.
static bool next_leaf(const gjk_mesh *mesh, const gjk_region *region, gjk_parts_walk *walk) {
  gjk_mesh_node steps;
  gjk_mesh_steps_of(mesh, &region->box.lower, &region->box.upper, &steps);
  const bool found = (walk->item != 0 || !is_outside(mesh, region)) &&
                     (region->moves ? next_mesh_leaf_on_way(mesh, region, &steps, walk)
                                    : next_leaf_in_order(mesh, region, &steps, walk));
  walk->item = found ? walk->item : mesh->triangle_count;
  return found;
}

bool gjk_mesh_corners(const gjk_mesh *mesh, uint32_t triangle, gjk_vec3 corner[3]) {
  const uint32_t *number = mesh->triangles[triangle].corner;
  for (unsigned i = 0; i < 3; i++) {
    const uint32_t k = GJK_MESH_NUMBER(number[i]);
    if (k >= mesh->vertex_count) {
      return false;
    }
    gjk_set(&mesh->vertices[k], &corner[i]);
  }
  return true;
}

// Do a triangle's corners say that it is apart from a box, or that it has a corner that is no vertex?
static bool is_left_out(const gjk_mesh *mesh, uint32_t triangle, const gjk_aabb *box) {
  const uint32_t *number = mesh->triangles[triangle].corner;
  const uint32_t a = GJK_MESH_NUMBER(number[0]), b = GJK_MESH_NUMBER(number[1]), c = GJK_MESH_NUMBER(number[2]);
  const gjk_vec3 *v = mesh->vertices;
  return a >= mesh->vertex_count || b >= mesh->vertex_count || c >= mesh->vertex_count ||
         gjk_triangle_is_apart(box, &v[a], &v[b], &v[c]);
}

bool gjk_mesh_next(const gjk_mesh *mesh, const gjk_region *region, gjk_parts_walk *walk, uint32_t *triangle,
                   gjk_vec3 corner[3]) {
  for (;;) {  // ends: each triangle once
    if ((walk->item % GJK_MESH_LEAF == 0 || walk->item >= mesh->triangle_count) && !next_leaf(mesh, region, walk)) {
      return false;
    }
    const uint32_t t = walk->item++;
    if (!is_left_out(mesh, t, &region->box) && gjk_mesh_corners(mesh, t, corner) &&
        (!region->moves || gjk_triangle_meets_on_way(region, corner))) {
      *triangle = t;
      return true;
    }
  }
}

void gjk_mesh_look_across(const gjk_mesh *mesh, uint32_t triangle, unsigned i, gjk_mesh_across *out) {
  gjk_vec3 corner[3], other[3];
  gjk_parts_walk walk;
  uint32_t t;
  out->opposite = 0;
  out->same = 0;
  out->kind = GJK_MESH_OPEN;
  if (!gjk_mesh_corners(mesh, triangle, corner)) {
    return;  // not reached: a precondition
  }
  const gjk_vec3 *a = &corner[i], *b = &corner[gjk_next(i)], *c = &corner[gjk_next(gjk_next(i))];
  // The edge's middle lies in the box of each triangle that has the edge.
  const gjk_vec3 middle = {(int32_t)gjk_sar64((int64_t)a->x + b->x, 1), (int32_t)gjk_sar64((int64_t)a->y + b->y, 1),
                           (int32_t)gjk_sar64((int64_t)a->z + b->z, 1)};
  gjk_region region;
  gjk_set(&middle, &region.box.lower);
  gjk_set(&middle, &region.box.upper);
  region.moves = false;
  gjk_parts_walk_start(&walk);
  while (gjk_mesh_next(mesh, &region, &walk, &t, other)) {
    for (unsigned k = 0; k < 3 && t != triangle; k++) {
      const gjk_vec3 *p = &other[k], *q = &other[gjk_next(k)];
      const bool opposite = gjk_same_place(p, b) && gjk_same_place(q, a);
      const bool same = gjk_same_place(p, a) && gjk_same_place(q, b);
      out->opposite += opposite ? 1u : 0u;
      out->same += same ? 1u : 0u;
      if (opposite || (same && mesh->two_sided)) {
        const gjk_mesh_edge kind = gjk_triangle_edge_of(a, b, c, &other[gjk_next(gjk_next(k))]);
        out->kind = kind < out->kind ? kind : out->kind;
      }
    }
  }
}

// Pre: low <= high.
static bool is_too_long(int32_t low, int32_t high) {
  return (uint32_t)high - (uint32_t)low > (uint32_t)GJK_RADIUS_MAX;
}

gjk_mesh_fault gjk_mesh_triangle_fault(const gjk_vec3 *vertices, uint32_t vertex_count,
                                       const gjk_mesh_triangle *triangle, unsigned *corner) {
  const int32_t most = GJK_MESH_COORDINATE_MAX;
  gjk_vec3 lower, upper;
  gjk_triangle_start_box(&lower, &upper);
  for (unsigned i = 0; i < 3; i++) {
    const uint32_t number = GJK_MESH_NUMBER(triangle->corner[i]);
    *corner = i;
    if (number >= vertex_count) {
      return GJK_MESH_NUMBER_FAULT;
    }
    const gjk_vec3 *v = &vertices[number];
    if (v->x > most || v->x < -most || v->y > most || v->y < -most || v->z > most || v->z < -most) {
      return GJK_MESH_COORDINATE;
    }
    gjk_triangle_widen(&lower, &upper, v);
    if (is_too_long(lower.x, upper.x) || is_too_long(lower.y, upper.y) || is_too_long(lower.z, upper.z)) {
      return GJK_MESH_SIZE;
    }
  }
  *corner = 0;
  return GJK_MESH_SOUND;
}
