// Casts and rays of bodies of many parts.
#include "gjk_parts_both.h"
#include "gjk_parts_first.h"

// Both passes over the parts of A, and the answer.
static gjk_status cast_against(const gjk_parts_frame *frame, const gjk_parts_cast_question *of, uint32_t *part,
                               gjk_cast_result *out) {
  gjk_parts_first first;
  gjk_parts_first_start(&first);
  gjk_status status = gjk_parts_first_ask(&first, frame, of, false);
  if (status == GJK_OK && first.limited) {
    status = gjk_parts_first_ask(&first, frame, of, true);
  }
  if (status != GJK_OK) {
    return status;
  }
  if (part != NULL) {
    *part = first.part;
  }
  return gjk_parts_first_report(&first, out);
}

// The way of A's position, and whether parts stay within int32 on it.
static gjk_status set_way_of_a(const gjk_parts_frame *frame, const gjk_cast_path *path, gjk_parts_cast_question *of) {
  const gjk_vec3 *at = &frame->parts->pose.position, *to = path->to_a != NULL ? path->to_a : at;
  of->moves_a = path->to_a != NULL;
  of->way_a.x = (int64_t)to->x - at->x;
  of->way_a.y = (int64_t)to->y - at->y;
  of->way_a.z = (int64_t)to->z - at->z;
  of->margin = path->margin;
  of->from = NULL;
  if (path->margin < 0) {
    return GJK_ERROR_NEGATIVE;
  }
  return gjk_parts_has_room(frame->parts, to) ? GJK_OK : GJK_ERROR_RANGE;
}

gjk_status gjk_parts_cast(const gjk_parts *a, const gjk_collider *b, const gjk_cast_path *path, uint32_t *part,
                          gjk_cast_result *out) {
  gjk_parts_frame frame;
  gjk_parts_cast_question of;
  gjk_status status = out == NULL ? GJK_ERROR_NULL : gjk_check_pair(b, b, path);
  status = status == GJK_OK ? gjk_parts_frame_set(&frame, a) : status;
  status = status == GJK_OK ? set_way_of_a(&frame, path, &of) : status;
  if (status != GJK_OK) {
    return status;
  }
  of.b = b;
  of.to = path->to_b;
  of.number = 0;
  return cast_against(&frame, &of, part, out);
}

gjk_status gjk_parts_cast_ray(const gjk_parts *a, const gjk_vec3 *from, const gjk_vec3 *to, uint32_t *part,
                              gjk_cast_result *out) {
  static const gjk_cast_path still = {NULL, NULL, 0};
  gjk_parts_frame frame;
  gjk_parts_cast_question of;
  gjk_status status = from == NULL || to == NULL || out == NULL ? GJK_ERROR_NULL : gjk_parts_frame_set(&frame, a);
  status = status == GJK_OK ? set_way_of_a(&frame, &still, &of) : status;
  if (status != GJK_OK) {
    return status;
  }
  of.b = NULL;
  of.from = from;
  of.to = to;
  of.number = 0;
  return cast_against(&frame, &of, part, out);
}

// Where a coordinate of B's own pose goes when that of one of its parts goes from `from` to `to`.
GJK_ONE_COPY static gjk_q16 as_body(gjk_q16 body, gjk_q16 from, gjk_q16 to, bool *saturated) {
  return gjk_saturate_noting((int64_t)body - from + to, saturated);
}

// One pass over the parts of B.
static gjk_status pass_over_b(const gjk_parts_frame frame[2], const gjk_cast_path *path, gjk_parts_first *first,
                              const gjk_parts_cast_question *of, bool bound) {
  const gjk_parts *b = frame[1].parts;
  const gjk_vec3 *at = &b->pose.position, *end = path->to_b != NULL ? path->to_b : at;
  const uint32_t count = gjk_parts_count(b);
  for (uint32_t i = 0; i < count; i++) {
    gjk_parts_room room;
    gjk_collider c;
    gjk_vec3 to;
    bool outside = false;
    const uint32_t before_part = first->part, before_b = first->of_b;
    gjk_status status = gjk_parts_place_in(&frame[1], i, &room, &c);
    if (gjk_parts_both_lacks(&status)) {
      continue;
    }
    if (status == GJK_OK) {
      to.x = as_body(end->x, at->x, c.position.x, &outside);  // B's reach allows it
      to.y = as_body(end->y, at->y, c.position.y, &outside);
      to.z = as_body(end->z, at->z, c.position.z, &outside);
      gjk_parts_cast_question own;
      own.b = &c;
      own.from = NULL;
      own.to = path->to_b != NULL ? &to : NULL;
      own.way_a.x = of->way_a.x;
      own.way_a.y = of->way_a.y;
      own.way_a.z = of->way_a.z;
      own.moves_a = of->moves_a;
      own.margin = of->margin;
      own.number = i;
      status = gjk_parts_first_ask(first, &frame[0], &own, bound);
    }
    if (status != GJK_OK) {
      return status;
    }
    if (first->part != before_part || first->of_b != before_b) {
      gjk_cast_result *best = &first->result[first->best];
      best->rest_b.x = as_body(at->x, c.position.x, best->rest_b.x, &best->saturated);
      best->rest_b.y = as_body(at->y, c.position.y, best->rest_b.y, &best->saturated);
      best->rest_b.z = as_body(at->z, c.position.z, best->rest_b.z, &best->saturated);
    }
  }
  return GJK_OK;
}

gjk_status gjk_parts_both_cast(const gjk_parts *a, const gjk_parts *b, const gjk_cast_path *path, gjk_parts_pair *parts,
                               gjk_cast_result *out) {
  gjk_parts_frame frame[2];
  gjk_parts_cast_question of;
  gjk_parts_first first;
  gjk_status status = path == NULL || out == NULL ? GJK_ERROR_NULL : gjk_parts_both_open(frame, a, b);
  status = status == GJK_OK ? set_way_of_a(&frame[0], path, &of) : status;
  if (status == GJK_OK && path->to_b != NULL && !gjk_parts_has_room(b, path->to_b)) {
    status = GJK_ERROR_RANGE;
  }
  gjk_parts_first_start(&first);
  status = status == GJK_OK ? pass_over_b(frame, path, &first, &of, false) : status;
  if (status == GJK_OK && first.limited) {
    status = pass_over_b(frame, path, &first, &of, true);
  }
  if (status != GJK_OK) {
    return status;
  }
  gjk_parts_write_numbers(first.part, first.of_b, parts);
  return gjk_parts_first_report(&first, out);
}
