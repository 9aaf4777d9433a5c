// Ground of the plane as a shape: chains, height profiles and grids of tiles, each one part of a body however long it
// is.
//
//     static const int16_t level[] = {0, 0, 40, 120, 120};
//     static const gjk2_heights heights = {level, 5, GJK_Q16(1), 10};
//     static gjk2_ground ground;
//     static gjk2_shape ground_shape;
//     gjk2_ground_of_heights(&heights, &ground, &ground_shape);  // then &ground_shape goes into a scene's table of
//                                                                shapes
//
// Ground is made of segments. The outside of a segment lies to its right, seen from its first vertex to its second. A
// segment meets bodies only from there, as gjk2/chain.h says. It counts for a body while the centre of the body's
// collider is in front of the segment's line or on it. So a body may jump up through a platform and then stand on it.
//
// Joints   Neighbours meet without a bump, for casts and impacts too: see gjk2_ground_cast.
// Scenes   A part with such a shape is like any other. Its body may be static or move, may turn, and may have more
//          parts. Updates, rays, casts, sensors, fast bodies and gjk2_slide see it, by the queries below. Two grounds
//          never touch. gjk2_scene_query_box and gjk2_scene_query_ray treat ground as its box. gjk2_scene_collider
//          refuses it.
// Saves    hold the index of the shape. Peers need the same ground.
// Posing   rounds each vertex to the nearest LSB, unless the pose's rotation is the identity. A segment of 1 LSB may
//          vanish.
// Hostile  data never make a query read beyond them. A segment beyond the limits below counts as missing.
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

// The largest |x| and |y| of a vertex of ground in its own frame, and the largest |x| + |y| of a segment: 4095 units.
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

// The constant shape of ground whose gjk2_ground and half extents are known. A scene refuses one without a ground
// (NULL). The caller answers for all else that the calls below check.
#define GJK2_GROUND(ground_pointer, half_x, half_y) \
  { &gjk2_class_ground, 0, 0, 1 ? (ground_pointer) : (const gjk2_ground *)0, GJK2_LENGTHS(half_x, half_y, 0), 0 }

// A box of an index, in units of 2^shift LSB from its corner.
typedef struct gjk2_index_box {
  uint16_t lower_x, lower_y, upper_x, upper_y;  // lower rounded down, upper up
} gjk2_index_box;

// Boxes over runs of 4, 16, 64 and so on segments of a chain: 2.7 bytes a segment. With an index, the time to find
// nearby segments does not grow with the chain. gjk2_index_build fills it; as a constant it may be in flash.
typedef struct gjk2_index {
  const gjk2_index_box *boxes;  // first those of 4 segments each, last the one of all
  uint16_t count;               // number of boxes
  uint16_t segments;            // number of segments of the chain
  uint8_t shift;                // see gjk2_index_box
  gjk2_vec corner;              // the chain's least x and y
} gjk2_index;

// The most boxes that the index of a chain of this many vertices takes, as a constant.
#define GJK2_INDEX_BOXES(vertices) ((vertices) / 3 + 8)

// A chain. Segment i leads from vertex i to vertex i + 1, and its outside lies to its right. So ground runs from right
// to left. A chain whose last vertex equals its first is closed. Vertices may repeat or lie in a line, and the chain
// may cross itself.
typedef struct gjk2_polyline {
  const gjk2_vec *vertices;  // count vertices, fit for flash
  uint16_t count;            // number of vertices
  const gjk2_index *index;   // NULL: every query goes through all segments
} gjk2_polyline;

// A height profile. Vertex i is at x = i width, y = heights[i] 2^shift LSB, and the outside is above. Segment i lies
// between vertices i and i + 1. A height of GJK2_HOLE is no vertex, and leaves open ends beside it.
typedef struct gjk2_heights {
  const int16_t *heights;  // count heights, fit for flash
  uint16_t count;          // number of vertices
  gjk_q16 width;           // of a column, Q16.16, at least 1 LSB
  uint8_t shift;           // 0 to 13
} gjk2_heights;

// The height of a vertex that is not there.
#define GJK2_HOLE INT16_MIN

// The form of a tile. The surface runs from height left at the left side to height right at the right side, above the
// solid. Heights are in quarters of the tile, 0 to 4; more counts as 4. Finally the whole tile turns counterclockwise
// by turns.
typedef struct gjk2_tile {
  uint8_t left, right;  // heights
  uint8_t turns;        // quarter turns, modulo 4: 2 hangs from the ceiling
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

// A grid of tiles. Its merged outline is the surface, so there is none where solids share a side. Surfaces in line are
// one segment, cut at multiples of GJK2_TILE_RUN tiles.
//
// cells    the caller's, in flash or RAM. Cell (column, row) is number row columns + column, and begins at x = column
//          size, y = row size. Each is an index into forms; an index from form_count on is an empty tile.
// Changes  A cell may be written between updates of a scene. Then call gjk2_scene_refilter for each body with the grid.
// Segment  4 cell + side names a segment by the tile where it begins. Sides are named before the tile is turned: 0
//          below, 1 right, 2 the surface, 3 left.
typedef struct gjk2_tiles {
  const uint8_t *cells;    // columns times rows cells
  uint16_t columns, rows;  // together at most 2^28 cells
  gjk_q16 size;            // of a tile, Q16.16: a multiple of 4 LSB, from 4 LSB to GJK2_TILE_SIZE_MAX
  uint8_t form_count;      // number of forms
  const gjk2_tile *forms;  // what the numbers in cells mean
} gjk2_tiles;

// The most tiles in one segment: runs are cut at multiples of this number.
#define GJK2_TILE_RUN 8
// The largest tile: 128 units.
#define GJK2_TILE_SIZE_MAX ((gjk_q16)8388608)

// Makes ground and its shape.
//
// data      the caller's, must outlive the shape; not copied. Only the cells of a grid may change later.
// out       the caller's, must outlive the shape.
// Statuses  NULL. EMPTY: no segment has a length, or a grid has no cells. NEGATIVE: a width or size below 1.
//           SIZE: a vertex or a segment is beyond GJK2_GROUND_REACH. Or a corner of the box is more than
//           GJK2_RADIUS_MAX from its middle. Or a shift or a tile's size is out of range, or there are more than 2^28
//           tiles. CORRUPT: an index that is not that of the chain. Only OK writes anything.
// Cost      one pass over all vertices; a grid takes none.
gjk_status gjk2_ground_of_chain(const gjk2_polyline *data, gjk2_ground *out, gjk2_shape *shape);
gjk_status gjk2_ground_of_heights(const gjk2_heights *data, gjk2_ground *out, gjk2_shape *shape);
gjk_status gjk2_ground_of_tiles(const gjk2_tiles *data, gjk2_ground *out, gjk2_shape *shape);

// Makes the index of a chain. chain->index is not read.
//
// boxes     room for capacity boxes; GJK2_INDEX_BOXES(count) is enough.
// Statuses  NULL, CAPACITY, and those of gjk2_ground_of_chain. Only OK writes anything.
gjk_status gjk2_index_build(const gjk2_polyline *chain, gjk2_index_box *boxes, uint16_t capacity, gjk2_index *out);

// Queries of ground at a pose and a body. A is the ground, B the body: a posed collider of any other kind.
//
// pose      of the ground. RANGE: farther than INT32_MAX - 2 GJK2_GROUND_REACH from the origin along an axis.
// Order     of equally near or early segments, the one with the lowest number is reported.
// Cost      that of the segments near the body; in a grid also a look at each tile near it.
// Statuses of every call: NULL, UNINITIALISED, ROTATION, RANGE. ITERATION_LIMIT: a curved body, and a segment that
// could matter reached a ceiling; nothing is written then, except that contacts may stand in out, uncounted.

// Is a segment that counts for the body at most distance away? As gjk2_within decides. NEGATIVE: distance.
gjk_status gjk2_ground_within(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_collider *body,
                              gjk_q16 distance, bool *yes);

// The distance to the nearest segment that counts for the body, as gjk2_distance gives it. found: there is one.
gjk_status gjk2_ground_distance(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_collider *body,
                                gjk2_distance_result *out, uint32_t *segment, bool *found);

// The contacts of a body, as gjk2_chain_contacts gives them, in the order in which segments are found. CAPACITY: there
// are more than capacity, and the deepest are kept. NEGATIVE, RANGE: margin.
gjk_status gjk2_ground_contacts(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_collider *body,
                                gjk_q16 margin, gjk2_chain_contact *out, uint16_t capacity, uint16_t *count);

// Where a body that moves first meets ground, as gjk2_cast of each segment. path is for A and B, as there.
//
// Which hits count  The body's centre must be in front of the segment's line, or on it, at the fraction of the hit. An
//                   overlap at the start counts. Otherwise the body must come nearer along the normal, and the normal
//                   must be one of the surface. That is a segment's own, or one between at a convex joint or an open
//                   end. At a concave joint the segment's own normal replaces any other. So nothing that slides over
//                   joints is stopped.
gjk_status gjk2_ground_cast(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_collider *body,
                            const gjk2_cast_path *path, gjk2_cast_result *out, uint32_t *segment);

// Where a ray enters ground from the outside.
gjk_status gjk2_ground_cast_ray(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_vec *from,
                                const gjk2_vec *to, gjk2_cast_result *out, uint32_t *segment);

// Goes through the segments near a box in the world: all that share a point with it, and others whose boxes meet it.
//
// take      is called for each segment, with its ends in the world and its number.
typedef void gjk2_segment_function(void *user, const gjk2_vec *from, const gjk2_vec *to, uint32_t segment);
gjk_status gjk2_ground_visit(const gjk2_ground *ground, const gjk2_pose *pose, const gjk2_aabb *box,
                             gjk2_segment_function *take, void *user);

// The ground of a scene's part, and its pose, for the queries above.
// Statuses: BODY_ID, RANGE for a part that is not there, UNSUPPORTED for one that is not ground.
gjk_status gjk2_scene_ground(const gjk2_scene *scene, gjk_body_id id, uint16_t part, const gjk2_ground **out,
                             gjk2_pose *pose);

// All contacts of a reported pair of ground and a body, at their current poses, at most the sum of their margins apart.
//
// Sides     A of each manifold is the ground, whichever of the pair it is.
// Manifold  That of gjk2_scene_manifold and of the report is the deepest of these, and the first among equals. It leads
//           from the report's a to its b. Its feature of the ground is the segment's number modulo 2^16.
// out, capacity, count  as in gjk2_ground_contacts.
// Statuses  as in gjk2_ground_contacts and gjk2_scene_manifold. UNSUPPORTED: neither of the two is ground, or both are.
gjk_status gjk2_scene_ground_contacts(const gjk2_scene *scene, const gjk2_report *report, gjk2_chain_contact *out,
                                      uint16_t capacity, uint16_t *count);

#ifdef __cplusplus
}
#endif

#endif
