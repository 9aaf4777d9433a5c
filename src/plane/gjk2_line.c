// Segments of ground as colliders, and the list of contacts with them.
#include "gjk2_line.h"

#include "gjk2_measure.h"

void gjk2_line_collider(gjk2_vec p, gjk2_vec q, gjk2_collider *out) {
  static const gjk2_shape segment = {&gjk2_class_triangle, 0, 0, 0, {0, 0}, 0, 3};
  const gjk2_vec middle = {(int32_t)gjk_sar64((int64_t)p.x + q.x, 1), (int32_t)gjk_sar64((int64_t)p.y + q.y, 1)};
  out->shape = &segment;
  out->buffer = NULL;
  gjk2_copy(&out->position, &middle);
  gjk2_copy(&out->centre, &middle);
  out->local_centre.x = 0;
  out->local_centre.y = 0;
  out->frame[0] = gjk2_sub(p, middle);
  out->frame[1] = gjk2_sub(q, middle);
  gjk2_copy(&out->frame[2], &out->frame[1]);
  // The middle is rounded down, so q is the farther end.
  out->core_radius = (gjk_q16)gjk2_length_bound(out->frame[1]) + 1;
  out->radius = out->core_radius;
  out->state = GJK2_STATE_POSED;
  out->count = 3;
  out->fraction[0] = 0;
  out->fraction[1] = 0;
  out->ordered = false;
}

static void copy_manifold(gjk2_manifold *to, const gjk2_manifold *from) {
  to->normal.x = from->normal.x;
  to->normal.y = from->normal.y;
  to->count = from->count;
  to->feature_a = from->feature_a;
  to->feature_b = from->feature_b;
  for (unsigned i = 0; i < from->count; i++) {
    gjk2_copy(&to->contact[i].point_a, &from->contact[i].point_a);
    gjk2_copy(&to->contact[i].point_b, &from->contact[i].point_b);
    to->contact[i].distance = from->contact[i].distance;
    to->contact[i].id = from->contact[i].id;
  }
}

void gjk2_line_list_take(void *list, uint32_t number, const gjk2_manifold *m) {
  gjk2_line_list *found = (gjk2_line_list *)list;
  gjk2_chain_contact *out = found->out;
  if (found->count == found->capacity) {
    uint16_t least = 0;
    found->overflows = true;
    for (uint16_t i = 1; i < found->count; i++) {
      least = gjk2_line_least(&out[i].manifold) >= gjk2_line_least(&out[least].manifold) ? i : least;
    }
    if (found->capacity == 0 || gjk2_line_least(m) >= gjk2_line_least(&out[least].manifold)) {
      return;
    }
    found->count--;
    for (uint16_t i = least; i < found->count; i++) {
      out[i].segment = out[i + 1].segment;
      copy_manifold(&out[i].manifold, &out[i + 1].manifold);
    }
  }
  out[found->count].segment = number;
  copy_manifold(&out[found->count].manifold, m);
  found->count++;
}
