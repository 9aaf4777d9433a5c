// Hull with a table: only the vertices of the direction's cell are looked at, and the same one is found.
//
//   1. Scale d up, so that rotating it loses little, and rotate it into the shape's frame: local.
//   2. Find local's cell.
//   3. Baked: take the farthest of the cell's posed vertices, the first of equals.
//   4. Lazy: find the farthest of the cell's own vertices along local. Pose all within slack of it, and take the farthest
//      of those along d, the first of equals.
//
// Refinement moves to each vertex of the cell that is strictly farther along the exact direction.
//
// The vertex that a scan of all vertices finds is in the cell. With m for the largest component of local, and r for the
// core radius:
//   |d.x| + |d.y| + |d.z|  <= sqrt(3) |d|, |local| <= sqrt(3) m                       < 3.01 m
//   r < 2^28 + 5, and the largest component of d has 29 bits or more:                r < 1.74 m
//   a support is behind along local by at most |d.x| + |d.y| + |d.z| + sqrt(3) r      (gjk_hull.h)
//   a refined one by at most 2 sqrt(3) r more, since d is off by less than 1 per component
//   together                                                                         < 12.1 m < GJK_TABLE_SLACK m
#include "gjk_hull.h"
#include "gjk_hull_table.h"

// The vertices of a cell, at least one. gjk_collider_init has found that their numbers are below the hull's count.
typedef struct table_list {
  const uint16_t *next, *end;
} table_list;

// Step 2
static table_list list_of(const gjk_collider *c, const gjk_vec3 *local) {
  const gjk_hull_table *table = (const gjk_hull_table *)c->shape->user;
  const unsigned cell = gjk_table_cell(local, table->level);
  const table_list list = {&table->vertex[cell == 0 ? 0 : table->end[cell - 1]], &table->vertex[table->end[cell]]};
  //@ assert list.next < list.end;
  return list;
}

// The entry of the list whose vertex is farthest along d, the first of equals; *farthest = its product with d.
// Pre: products are below 2^63 in size.
static inline const uint16_t *farthest_listed(table_list list, const gjk_vec3 *vertices, const gjk_vec3 *d,
                                              int64_t *farthest) {
  const int32_t x = d->x, y = d->y, z = d->z;
  const gjk_vec3 *v = &vertices[*list.next];
  const uint16_t *next = list.next + 1, *after = next;  // one past the farthest so far
  int64_t most = gjk_mac32(gjk_mac32(gjk_mul32(v->x, x), v->y, y), v->z, z);
  while (next < list.end) {  // at most GJK_HULL_VERTICES_MAX
    v = &vertices[*next++];
    const int64_t along = gjk_mac32(gjk_mac32(gjk_mul32(v->x, x), v->y, y), v->z, z);
#if GJK_CONDITIONAL_MOVES
    GJK_KEEP_LARGER(most, after, along, next);
#else
    if (along > most) {
      after = next;
      most = along;
    }
#endif
  }
  *farthest = most;
  return after - 1;
}

// Step 3. Out of line, as the three below, so that none of them takes the stack of another.
GJK_OUT_OF_LINE static void find_posed(const gjk_collider *c, const gjk_vec3 *d, gjk_support *out) {
  const gjk_vec3 scaled = gjk_scale_direction(d);
  gjk_vec3 local;
  int64_t farthest;
  (void)gjk_hull_local_direction(c, &scaled, &local);
  out->vertex = *farthest_listed(list_of(c, &local), c->buffer, d, &farthest);
  out->offset = c->buffer[out->vertex];
}

// Step 4
GJK_OUT_OF_LINE static void find_lazy(const gjk_collider *c, const gjk_vec3 *direction, gjk_support *out) {
  const gjk_vec3 *vertices = c->shape->vertices;
  const gjk_vec3 d = gjk_scale_direction(direction);
  gjk_vec3 local;
  int64_t limit, farthest = 0;
  bool found = false;
  const int64_t slack = gjk_hull_local_direction(c, &d, &local);
  table_list list = list_of(c, &local);
  (void)farthest_listed(list, vertices, &local, &limit);
  limit -= slack;
  for (; list.next < list.end; list.next++) {  // at most GJK_HULL_VERTICES_MAX
    const gjk_vec3 *v = &vertices[*list.next];
    if (gjk_dot(v, &local) >= limit) {
      const gjk_vec3 offset = gjk_hull_pose_vertex(c, c->frame, v);
      const int64_t along = gjk_dot(&offset, &d);
      if (!found || along > farthest) {
        found = true;
        farthest = along;
        out->offset = offset;
        out->vertex = *list.next;
      }
    }
  }
}

// Refinement of a baked hull.
GJK_OUT_OF_LINE static bool move_posed(const gjk_collider *c, const gjk_vec3 *d, gjk_direction *direction,
                                       gjk_support *at) {
  const uint16_t before = at->vertex;
  const int64_t limit = gjk_dot(&at->offset, d) - gjk_hull_rounding_slack(c);
  gjk_vec3 local;
  (void)gjk_hull_local_direction(c, d, &local);
  direction->ties = 0;
  for (table_list list = list_of(c, &local); list.next < list.end; list.next++) {  // at most GJK_HULL_VERTICES_MAX
    const gjk_vec3 *v = &c->buffer[*list.next];
    if (*list.next != before && gjk_dot(v, d) >= limit) {
      gjk_hull_refine_to(direction, v, *list.next, at);
    }
  }
  return at->vertex != before;
}

// Refinement of a lazy hull.
GJK_OUT_OF_LINE static bool move_lazy(const gjk_collider *c, const gjk_vec3 *d, gjk_direction *direction,
                                      gjk_support *at) {
  const gjk_vec3 *vertices = c->shape->vertices;
  const uint16_t before = at->vertex;
  gjk_vec3 local;
  const int64_t slack = gjk_hull_local_direction(c, d, &local) + gjk_hull_rounding_slack(c);
  const int64_t limit = gjk_dot(&vertices[before], &local) - slack;
  direction->ties = 0;
  for (table_list list = list_of(c, &local); list.next < list.end; list.next++) {  // at most GJK_HULL_VERTICES_MAX
    const gjk_vec3 *v = &vertices[*list.next];
    if (*list.next != before && gjk_dot(v, &local) >= limit) {
      const gjk_vec3 offset = gjk_hull_pose_vertex(c, c->frame, v);
      gjk_hull_refine_to(direction, &offset, *list.next, at);
    }
  }
  return at->vertex != before;
}

static void support_table(const gjk_collider *c, const gjk_vec3 *d, gjk_support *out) {
  if (c->buffer != NULL) {
    find_posed(c, d, out);
  } else {
    find_lazy(c, d, out);
  }
}

static bool refine_table(const gjk_collider *c, const gjk_vec3 *d, gjk_direction *direction, gjk_support *at) {
  return c->buffer != NULL ? move_posed(c, d, direction, at) : move_lazy(c, d, direction, at);
}

static bool vertex_table(const gjk_collider *c, uint16_t number, gjk_vec3 *offset) {
  return gjk_hull_vertex(c, number, offset);
}

// A baked hull keeps the rotation as well, for step 1.
static void pose_table(gjk_collider *c, const gjk_vec3 rows[3]) {
  for (int i = 0; i < 3; i++) {
    c->frame[i] = rows[i];
  }
  gjk_hull_pose(c, rows);
}

static gjk_status measure_table(const gjk_shape *shape, gjk_extent *out) {
  const gjk_status status = gjk_hull_measure(shape, out);
  return status != GJK_OK ? status : gjk_table_measure((const gjk_hull_table *)shape->user, shape->count);
}

const gjk_shape_class gjk_class_table = {
    .measure = measure_table,
    .pose = pose_table,
    .support = support_table,
    .refine = refine_table,
    .vertex = vertex_table,
    .stalls = NULL,
    .close = NULL,
    .concave = NULL,
    .buffered = true,
    .count = 0,
    .kind = GJK_KIND_VERTICES,
};
