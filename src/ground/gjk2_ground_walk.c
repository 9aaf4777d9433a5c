// Walks over ground: from a box in the world to the ground's frame, and from there back.
#include "gjk2_ground_walk.h"

#include "../plane/gjk2_rotation.h"
#include "gjk2_ground_box.h"

// How far rounding may take a box that is turned back: 1 LSB its centre, 1 its half extents, and 1 a vertex that was posed.
#define TURN_SLACK 4

gjk_status gjk2_ground_place(const gjk2_ground *ground, const gjk2_pose *pose, gjk2_ground_walk *walk) {
  const gjk2_vec origin = {0, 0};
  int64_t rotated[2];
  if (ground == NULL || pose == NULL || ground->type == NULL || ground->data == NULL) {
    return GJK_ERROR_NULL;
  }
  if (!gjk2_rotation_with_point(&pose->rotation, &origin, &walk->turn, rotated)) {
    return GJK_ERROR_ROTATION;
  }
  if (!gjk2_ground_has_room(&pose->position)) {
    return GJK_ERROR_RANGE;
  }
  walk->ground = ground;
  gjk2_copy(&walk->position, &pose->position);
  return GJK_OK;
}

static bool is_turned(const gjk2_ground_walk *walk) {
  return walk->turn.x != GJK_Q30_ONE;
}

// A coordinate relative to the ground, within what any vertex reaches at any rotation.
static int32_t clip_coordinate(int32_t x, int32_t position) {
  const int64_t far = 2 * (int64_t)GJK2_GROUND_REACH, at = (int64_t)x - position;
  return (int32_t)(at > far ? far : at < -far ? -far : at);
}

// |vector| per axis after a turn, rounded up:  |turn| <= 2^30 + 1, components <= 2^30:  the sum < 2^62
static int32_t turned_extent(const gjk2_vec *turn, int32_t along, int32_t across) {
  const int32_t c = (int32_t)gjk_magnitude32(turn->x), s = (int32_t)gjk_magnitude32(turn->y);
  return (int32_t)gjk_sar64(gjk_mac32(gjk_mul32(c, along), s, across), 30) + TURN_SLACK;
}

void gjk2_ground_begin(gjk2_ground_walk *walk, const gjk2_aabb *box) {
  gjk2_vec low = {clip_coordinate(box->lower.x, walk->position.x), clip_coordinate(box->lower.y, walk->position.y)};
  gjk2_vec high = {clip_coordinate(box->upper.x, walk->position.x), clip_coordinate(box->upper.y, walk->position.y)};
  if (is_turned(walk)) {
    // Components are at most 2 GJK2_GROUND_REACH = 2^29 in size. So sums are at most 2^30, and turned boxes below 2^30.5.
    const gjk2_vec middle = {(int32_t)gjk_sar64((int64_t)low.x + high.x, 1),
                             (int32_t)gjk_sar64((int64_t)low.y + high.y, 1)};
    const gjk2_vec half = gjk2_sub(high, middle), centre = gjk2_rotate_back(&walk->turn, middle);
    const int32_t x = turned_extent(&walk->turn, half.x, half.y), y = turned_extent(&walk->turn, half.y, half.x);
    low.x = centre.x - x;
    low.y = centre.y - y;
    high.x = centre.x + x;
    high.y = centre.y + y;
  }
  gjk2_copy(&walk->box.lower, &box->lower);
  gjk2_copy(&walk->box.upper, &box->upper);
  gjk2_copy(&walk->near.lower, &low);
  gjk2_copy(&walk->near.upper, &high);
  walk->ground->type->begin(walk);
}

static gjk2_vec placed_vertex(const gjk2_ground_walk *walk, gjk2_vec v) {
  static const int8_t whole[2] = {0, 0};
  return gjk2_add(is_turned(walk) ? gjk2_rotate_onto(&walk->turn, v, whole) : v, walk->position);
}

// The neighbour from one vertex to the next, in the world. False: it is not there.
static bool place_neighbour(const gjk2_ground_walk *walk, gjk2_vec from, gjk2_vec to, gjk2_vec *way) {
  if (!gjk2_ground_fits(from) || !gjk2_ground_fits(to) || !gjk2_ground_fits_segment(from, to)) {
    return false;
  }
  *way = gjk2_sub(placed_vertex(walk, to), placed_vertex(walk, from));
  return true;
}

bool gjk2_ground_next(gjk2_ground_walk *walk, gjk2_line *line, gjk2_ground_edge *edge) {
  while (walk->ground->type->next(walk, edge)) {  // ends: each segment comes once
    const gjk2_vec p = edge->vertex[1], q = edge->vertex[2];
    if (!gjk2_ground_fits(p) || !gjk2_ground_fits(q) || !gjk2_ground_fits_segment(p, q)) {
      continue;
    }
    line->number = edge->number;
    line->p = placed_vertex(walk, p);
    line->q = placed_vertex(walk, q);
    if (gjk2_equal(line->p, line->q) || !gjk2_ground_meets(&walk->box, line->p, line->q)) {
      continue;
    }
    return true;
  }
  return false;
}

void gjk2_ground_set_neighbours(const gjk2_ground_walk *walk, gjk2_line *line, gjk2_ground_edge *edge) {
  const gjk2_vec *v = edge->vertex;
  walk->ground->type->neighbours(walk, edge);
  line->open_before = edge->open_before || !place_neighbour(walk, v[0], v[1], &line->before);
  line->open_after = edge->open_after || !place_neighbour(walk, v[2], v[3], &line->after);
}
