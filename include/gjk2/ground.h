// Ground of the plane as a shape: chains, height profiles and grids of tiles, each one part of a body however long it is.
//
//     static const int16_t level[] = {0, 0, 40, 120, 120};
//     static const gjk2_heights heights = {level, 5, GJK_Q16(1), 10};
//     static gjk2_ground ground;
//     static gjk2_shape ground_shape;
//     gjk2_ground_of_heights(&heights, &ground, &ground_shape);  // then &ground_shape goes into a scene's table of shapes
//
// Ground is made of segments. Each has an outside, to the right of the way from its first vertex to its last, and meets
// bodies from there alone, as gjk2/chain.h says: a segment counts for a body while the centre of its collider is in front
// of the segment's line or on it. So a body may jump up through a platform that it then stands on.
//
// Joints   Neighbours meet without a bump, and casts and impacts know them too: see gjk2_ground_cast.
// Scenes   A part of such a shape is like any other: its body may be static or move, turn, and have more parts. Updates,
//          rays, casts, sensors, fast bodies and gjk2_slide see it, by the queries below. Two of them never touch.
//          gjk2_scene_query_box and gjk2_scene_query_ray take it for its box. gjk2_scene_collider refuses it.
// Saves    hold the index of the shape. Peers need the same ground.
// Posing   rounds each vertex to the nearest LSB, unless the pose's rotation is the identity. A segment of 1 LSB may vanish.
// Hostile data never make a query read outside of them: a segment that is too long or too far away, as stated below, is
//          not there.
// Threads  queries only read.
// Links    a shape of ground links contacts, casts and times of impact; a program without one links none of it.
#ifndef GJK2_GROUND_H
#define GJK2_GROUND_H

#include "gjk2/cast.h"
#include "gjk2/chain.h"
#include "gjk2/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

// The class of shapes of ground, which GJK2_GROUND names.
extern const gjk2_shape_class gjk2_class_ground;

// No vertex of ground may be farther from its origin along an axis: 4096 units. Nor may |x| + |y| of a segment be more.
#define GJK2_GROUND_REACH GJK2_RADIUS_MAX

// What ground is made of, opaque: one constant per kind.
typedef struct gjk2_ground_class gjk2_ground_class;
extern const gjk2_ground_class gjk2_ground_chain;    // data: a gjk2_polyline
extern const gjk2_ground_class gjk2_ground_heights;  // data: a gjk2_heights
extern const gjk2_ground_class gjk2_ground_tiles;    // data: a gjk2_tiles

// Ground, in its own frame. As a constant it may be in flash.
typedef struct gjk2_ground {
  const gjk2_ground_class *type;  // its kind
  const void *data;               // the caller's, by kind; must outlive the ground
  gjk2_vec centre;                // of the box that holds it
} gjk2_ground;

// The shape of ground whose gjk2_ground and half extents are known, as a constant. A scene refuses one that names no ground
// (NULL). What else the calls below check is the caller's to know.
#define GJK2_GROUND(ground_pointer, half_x, half_y) \
  { &gjk2_class_ground, 0, 0, 1 ? (ground_pointer) : (const gjk2_ground *)0, GJK2_LENGTHS(half_x, half_y, 0), 0 }

// A box of an index, in units of 2^shift LSB from its corner.
typedef struct gjk2_index_box {
  uint16_t lower_x, lower_y, upper_x, upper_y;  // lower rounded down, upper up
} gjk2_index_box;

// Boxes over runs of 4, 16, 64 and so on segments of a chain, so that near segments are found in time that does not grow
// with the chain: 2.7 bytes a segment. gjk2_index_build fills it; as constants it may be in flash.
typedef struct gjk2_index {
  const gjk2_index_box *boxes;  // first those of 4 segments each, last the one of all
  uint16_t count;               // of boxes
  uint16_t segments;            // of the chain
  uint8_t shift;                // see gjk2_index_box
  gjk2_vec corner;              // the chain's least x and y
} gjk2_index;

// Boxes that an index of so many vertices takes at most, as a constant.
#define GJK2_INDEX_BOXES(vertices) ((vertices) / 3 + 8)

// A chain: segment i leads from vertex i to vertex i + 1, the outside to its right. Ground runs from right to left. A chain
// whose last vertex equals its first is closed. Vertices may repeat, lie in a line, and the chain may cross itself.
typedef struct gjk2_polyline {
  const gjk2_vec *vertices;  // count of them, fit for flash
  uint16_t count;            // vertices
  const gjk2_index *index;   // NULL: every query goes through all segments
} gjk2_polyline;

// A height profile: vertex i is at x = i width, y = heights[i] 2^shift LSB; the outside is above. Segment i is that between
// vertex i and vertex i + 1. Where a height is GJK2_HOLE there is no vertex, and the profile has open ends.
typedef struct gjk2_heights {
  const int16_t *heights;  // count of them, fit for flash
  uint16_t count;          // vertices
  gjk_q16 width;           // of a column, at least 1
  uint8_t shift;           // 0 to 13
} gjk2_heights;

// The height of a vertex that is not there.
#define GJK2_HOLE INT16_MIN

// The form of a tile. The surface runs from a height at the left side to one at the right side, with the solid below it.
// Heights are in quarters of the tile, 0 to 4; more counts as 4. Then the whole tile is turned counterclockwise by so many quarter turns.
typedef struct gjk2_tile {
  uint8_t left, right;  // heights
  uint8_t turns;        // modulo 4: 2 hangs from the ceiling
  bool one_way;         // the surface alone, without a solid
} gjk2_tile;

// A tile with its solid below the surface: (0, 0) is empty, (4, 4) full, (2, 2) half, and (0, 4) rises to the right.
#define GJK2_TILE(left, right) \
  { (left), (right), 0, false }
// A tile that hangs from above.
#define GJK2_TILE_CEILING(left, right) \
  { (right), (left), 2, false }
// A platform without a solid.
#define GJK2_TILE_ONE_WAY(left, right) \
  { (left), (right), 0, true }

// A grid of tiles, which counts as its merged outline: where solids share a side there is no surface, and surfaces in line
// are one segment, cut where a multiple of GJK2_TILE_RUN tiles ends. Cell (column, row) is number row columns + column; it
// begins at x = column size, y = row size.
//
// cells    the caller's, in flash or RAM. Each is an index into forms; an index beyond them is an empty tile. A cell may be
//          written between updates of a scene; then gjk2_scene_refilter of each body that has the grid tells the scene.
// Segment  4 cell + side names one by the tile where it begins: side 0 below, 1 right, 2 the surface, 3 left, turned.
typedef struct gjk2_tiles {
  const uint8_t *cells;    // columns rows of them
  uint16_t columns, rows;  // together at most 2^28 cells
  gjk_q16 size;            // of a tile, a multiple of 4 LSB, at least 4, at most GJK2_TILE_SIZE_MAX
  uint8_t form_count;      // of forms
  const gjk2_tile *forms;  // what the numbers in cells mean
} gjk2_tiles;

// At multiples of so many tiles runs are cut.
#define GJK2_TILE_RUN 8
// The largest tile: 128 units.
#define GJK2_TILE_SIZE_MAX ((gjk_q16)8388608)

// Make ground and its shape.
//
// data      kept, not copied. Cells of a grid may change later, all else must stay.
// out       the caller's, must outlive the shape.
// Statuses  NULL; EMPTY: no segment with a length, or a grid without cells; NEGATIVE: a width or size below 1; SIZE: a vertex
//           or a segment beyond GJK2_GROUND_REACH, a box of more than GJK2_RADIUS_MAX from its middle to a corner, a shift,
//           a tile's size, more than 2^28 tiles; CORRUPT: an index that is not that of the chain.
//           Nothing is written but after OK.
// Cost      one pass over all vertices; of a grid none.
gjk_status gjk2_ground_of_chain(const gjk2_polyline *data, gjk2_ground *out, gjk2_shape *shape);
gjk_status gjk2_ground_of_heights(const gjk2_heights *data, gjk2_ground *out, gjk2_shape *shape);
gjk_status gjk2_ground_of_tiles(const gjk2_tiles *data, gjk2_ground *out, gjk2_shape *shape);

// Makes the index of a chain, whose own index is not read.
//
// boxes     room for capacity boxes; GJK2_INDEX_BOXES(count) is enough.
// Statuses  NULL, CAPACITY, and those of gjk2_ground_of_chain; nothing is written but after OK.
gjk_status gjk2_index_build(const gjk2_polyline *chain, gjk2_index_box *boxes, uint16_t capacity, gjk2_index *out);

// Queries of ground at a pose, and of a body: a posed collider of any other kind. A is the ground, B the body.
//
// pose      of the ground. RANGE: farther than INT32_MAX - 2 GJK2_GROUND_REACH from the origin along an axis.
// Order     of equally near or early segments the one with the lowest number counts.
// Cost      that of the segments near the body; a grid's tiles near it are looked at, too.
// Statuses of every call: NULL, UNINITIALISED, ROTATION, RANGE; ITERATION_LIMIT: of curved bodies alone, and a segment that
//           could matter has no answer. Nothing is written then.

// Is a segment that counts at most distance away? As gjk2_within decides. NEGATIVE: distance.
gjk_status gjk2_ground_within(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_collider *body,
                              gjk_q16 distance, bool *yes);

// The distance to the nearest segment that counts, as gjk2_distance answers of it. found: there is one.
gjk_status gjk2_ground_distance(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_collider *body,
                                gjk2_distance_result *out, uint32_t *segment, bool *found);

// The contacts of a body, as gjk2_chain_contacts has them, in the order in which segments are found. CAPACITY: there are
// more, and the deepest are kept. NEGATIVE, RANGE: margin.
gjk_status gjk2_ground_contacts(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_collider *body,
                                gjk_q16 margin, gjk2_chain_contact *out, uint16_t capacity, uint16_t *count);

// Where a body that moves first meets ground, each segment as gjk2_cast answers of it. path: of A and of B, as there.
//
// Which hits count  The centre is in front of the segment's line, or on it, at the fraction of the hit. At the start an
//                   overlap counts. Else the body must come nearer along the normal, and that must be one of the surface:
//                   a segment's own, or at a convex joint or an open end one of those between. At a concave joint the
//                   segment's own normal takes the place of any other. So nothing that slides over joints is stopped.
gjk_status gjk2_ground_cast(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_collider *body,
                            const gjk2_cast_path *path, gjk2_cast_result *out, uint32_t *segment);

// Where a ray enters ground from the outside.
gjk_status gjk2_ground_cast_ray(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_vec *from,
                                const gjk2_vec *to, gjk2_cast_result *out, uint32_t *segment);

// Goes through the segments near a box in the world: all that share a point with it, and others whose boxes meet it.
//
// take      is called with each: its ends in the world, and its number.
typedef void gjk2_segment_function(void *user, const gjk2_vec *from, const gjk2_vec *to, uint32_t segment);
gjk_status gjk2_ground_visit(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_aabb *box,
                             gjk2_segment_function *take, void *user);

// Ground that a scene has as a part, and where, for the queries above.
// Statuses: BODY_ID, RANGE for a part that is not there, UNSUPPORTED for one that is not ground.
gjk_status gjk2_scene_ground(const gjk2_scene *scene, gjk_body_id id, uint16_t part, const gjk2_ground **out,
                             gjk2_pose *pose);

// All contacts of a reported pair of ground and a body at their current poses, at most the sum of their margins apart. A of
// each manifold is the ground, whichever of the pair it is. gjk2_scene_manifold, and so the manifold of a report, is the
// deepest of them, of equals the first, from the report's a to its b; its feature of the ground is the segment's
// number modulo 2^16.
//
// out, capacity, count  as in gjk2_ground_contacts.
// Statuses  as in gjk2_ground_contacts and gjk2_scene_manifold; UNSUPPORTED: none of the two is ground, or both are.
gjk_status gjk2_scene_ground_contacts(const gjk2_scene *scene, const gjk2_report *report, gjk2_chain_contact *out,
                                      uint16_t capacity, uint16_t *count);

#ifdef __cplusplus
}
#endif

#endif
