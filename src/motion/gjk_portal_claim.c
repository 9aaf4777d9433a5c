// The portal that a certificate of a cast names: loaded, and does the way enter A - B there?
#include "gjk_portal.h"

// Does the line pass through the corners? Pre: n . t != 0, so that three span no plane along the line.
static bool holds_line(gjk_portal *p) {
  const gjk_corner *c = p->corner;
  gjk_long3 v;
  gjk_portal_lateral(p, &c[0].u, &v);
  if (p->count == 1) {
    return gjk_portal_is_zero(&v);
  }
  if (p->count == 2) {
    gjk_long3 across, other;
    const gjk_vec3 e = gjk_sub(c[1].u, c[0].u);
    gjk_portal_cross(p, &e, &across);
    gjk_portal_lateral(p, &c[1].u, &other);
    p->axis = gjk_portal_main_axis(&across);
    const int64_t first = gjk_portal_component(&v, p->axis), second = gjk_portal_component(&other, p->axis);
    return !gjk_portal_is_zero(&across) && gjk_portal_turn(&v, &c[0].u, &c[1].u) == 0 && (first <= 0 || second <= 0) &&
           (first >= 0 || second >= 0);
  }
  const int side = gjk_portal_turn(&v, &c[0].u, &c[1].u), side2 = gjk_portal_turn(&v, &c[0].u, &c[2].u);
  gjk_portal_lateral(p, &c[1].u, &v);
  return side >= 0 && side2 <= 0 && gjk_portal_turn(&v, &c[1].u, &c[2].u) >= 0;
}

bool gjk_portal_load(gjk_portal *p, const gjk_cast_certificate *certificate) {
  const unsigned count = certificate->count;
  for (unsigned i = 0; i < count; i++) {
    gjk_vec3 a, b;
    gjk_corner *c = &p->corner[count == 3 && i > 0 ? 3 - i : i];
    if (!p->a->shape->type->vertex(p->a, certificate->a[i], &a) ||
        !p->b->shape->type->vertex(p->b, certificate->b[i], &b)) {
      return false;
    }
    gjk_portal_scale(p, &a, &b, &c->u);
    c->a = certificate->a[i];
    c->b = certificate->b[i];
  }
  p->count = (uint8_t)count;
  if (count == 3) {
    gjk_portal_set_plane(p);
  } else {
    p->n.x = certificate->direction.x;
    p->n.y = certificate->direction.y;
    p->n.z = certificate->direction.z;
  }
  gjk_portal_set_direction(p);
  return true;
}

bool gjk_portal_is_entry(gjk_portal *p) {
  const gjk_corner *c = p->corner;
  for (unsigned i = 1; i < p->count; i++) {
    const gjk_vec3 step = gjk_sub(c[i].u, c[0].u);
    if (gjk_dot_sign(&p->n, &step) != 0) {
      return false;
    }
  }
  return gjk_portal_side(p, NULL, &p->way) < 0 && gjk_portal_side(p, &c[0].u, &p->start) < 0 &&
         gjk_portal_side(p, &c[0].u, &p->goal) >= 0 && holds_line(p);
}
