// A walk over the segments of ground near a box, whatever the ground is made of.
#ifndef GJK2_SRC_GROUND_WALK_H
#define GJK2_SRC_GROUND_WALK_H

#include "../plane/gjk2_line.h"
#include "gjk2/ground.h"

// Levels of an index: 4^8 segments are more than any chain has.
#define GJK2_INDEX_LEVELS 8

// A segment in the ground's frame.
typedef struct gjk2_ground_edge {
  uint32_t number;
  gjk2_vec vertex[4];            // it leads from the second to the third; the first is before it, the last after it
  bool open_before, open_after;  // then there is no first or last
} gjk2_ground_edge;

// The columns and rows of a grid that a box meets, and where the walk is.
typedef struct gjk2_ground_cells {
  int32_t first_column, last_column, first_row, last_row;
  int32_t column, row;
  unsigned side;
  gjk2_vec low, high;  // the quarters of a tile that the box holds
  gjk2_vec from, to;   // ends of the segment that was found last, quarters of a tile
} gjk2_ground_cells;

typedef struct gjk2_ground_walk {
  const gjk2_ground *ground;
  gjk2_vec position;
  gjk2_vec turn;                      // a unit, Q2.30
  gjk2_aabb box;                      // what the walk is near, world
  gjk2_aabb near;                     // a box around that, ground frame
  uint32_t at, end;                   // segments of a chain or profile
  bool closed;                        // the chain
  uint16_t level[GJK2_INDEX_LEVELS];  // where each level of the chain's index begins
  gjk2_ground_cells cells;
} gjk2_ground_walk;

struct gjk2_ground_class {
  // Readies the walk, whose near is set.
  void (*begin)(gjk2_ground_walk *walk);
  // The next segment whose box meets near. False: there is none.
  bool (*next)(gjk2_ground_walk *walk, gjk2_ground_edge *out);
  // Sets the neighbours of the segment that next has found: vertex 0 and 3, open_before and open_after.
  void (*neighbours)(const gjk2_ground_walk *walk, gjk2_ground_edge *edge);
};

// Places a walk at a pose. NULL, ROTATION, RANGE or OK.
gjk_status gjk2_ground_place(const gjk2_ground *ground, const gjk2_pose *pose, gjk2_ground_walk *walk);

// Starts over near a box in the world. Pre: the walk is placed.
void gjk2_ground_begin(gjk2_ground_walk *walk, const gjk2_aabb *box);

// The next segment, in the world and in the ground's frame, if it is no longer and no farther than GJK2_GROUND_REACH allows.
// Its neighbours are not set.
bool gjk2_ground_next(gjk2_ground_walk *walk, gjk2_line *line, gjk2_ground_edge *edge);

// Sets the neighbours of the segment that was found last.
void gjk2_ground_set_neighbours(const gjk2_ground_walk *walk, gjk2_line *line, gjk2_ground_edge *edge);

// Does the box of a segment meet another?
static inline bool gjk2_ground_meets(const gjk2_aabb *box, gjk2_vec p, gjk2_vec q) {
  const gjk2_vec low = box->lower, high = box->upper;
  return !((p.x > high.x && q.x > high.x) || (p.x < low.x && q.x < low.x) || (p.y > high.y && q.y > high.y) ||
           (p.y < low.y && q.y < low.y));
}

// Is the centre of a body in front of a segment's line or on it?
static inline bool gjk2_ground_is_in_front(const gjk2_line *line, const gjk2_vec *centre) {
  // Components of the normal < 2^28 + 2, of the difference < 2^32:  their products' sum < 2^62
  const gjk2_vec n = gjk2_outward(gjk2_sub(line->q, line->p));
  return n.x * ((int64_t)centre->x - line->p.x) + n.y * ((int64_t)centre->y - line->p.y) >= 0;
}

#endif
