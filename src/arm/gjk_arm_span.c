// Searches a direction along which a pair is apart at both ends of a span.
//
// It is GJK on the hull of the differences P - S at both ends, with these steps:
//
//   1. Spheres: the direction between the centres at the middle of the chords shows most pairs apart.
//   2. Take the direction that last parted the pair, else that of step 1.
//   3. Support points of both ends along it. The lower one is w; it is beyond what is wanted: APART.
//   4. Add w to the simplex. It is no nearer to the origin, or the origin lies in the simplex: not apart.
//   5. The next direction goes from the origin to the simplex's feature. Is that feature nearer than what is wanted: not
//      apart, since the feature is a part of the hull. Else on from 3.
//
// Nothing depends on where the search ends but which spans are halved: what it proves is the gap of step 3, which is computed
// from the direction alone. So vertices may be rounded, and the number of rounds is limited.
#include "gjk_arm_span.h"

#include "../arith/gjk_rotation.h"
#include "../arith/gjk_unit.h"
#include "../gjk/gjk_simplex.h"
#include "../shape/gjk_scan.h"

// The most rounds of a search.
#define ARM_ROUNDS 16

// Beyond this the view is along an axis. At most 2^28 more, P and S stay within 2^31; the other end is at most 2^28 off.
#define ARM_FAR (INT32_C(1) << 30)

// *out = the product of the transposed matrix a and b, Q30.
static void relative_rows(const gjk_vec3 a[3], const gjk_vec3 b[3], gjk_vec3 out[3]) {
  const gjk_vec3 columns[3] = {{b[0].x, b[1].x, b[2].x}, {b[0].y, b[1].y, b[2].y}, {b[0].z, b[1].z, b[2].z}};
  const gjk_vec3 x = gjk_rotate_back(a, &columns[0]), y = gjk_rotate_back(a, &columns[1]);
  const gjk_vec3 z = gjk_rotate_back(a, &columns[2]);
  const gjk_vec3 rows[3] = {{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}};
  for (unsigned i = 0; i < 3; i++) {
    out[i] = rows[i];
  }
}

// a - b within ARM_FAR. Where it is not, *axis gets its sign.
static int32_t bounded(int32_t a, int32_t b, int32_t *axis) {
  const int64_t difference = (int64_t)a - b;
  if (difference >= ARM_FAR || difference <= -ARM_FAR) {
    *axis = difference > 0 ? 1 : -1;
    return difference > 0 ? ARM_FAR : -ARM_FAR;
  }
  return (int32_t)difference;
}

// a - b, each component within ARM_FAR.
static gjk_vec3 bounded_way(const gjk_vec3 *a, const gjk_vec3 *b, gjk_vec3 *axis) {
  const gjk_vec3 way = {bounded(a->x, b->x, &axis->x), bounded(a->y, b->y, &axis->y), bounded(a->z, b->z, &axis->z)};
  return way;
}

void gjk_arm_look(const gjk_arm *arm, const gjk_arm_pair *pair, const gjk_collider *obstacle, unsigned start,
                  unsigned end, gjk_arm_view *out) {
  const gjk_arm_part_room *part = &arm->memory.parts[pair->part];
  out->arm = arm;
  out->pair = pair;
  out->frame[0] = start;
  out->frame[1] = end;
  out->part = part;
  out->axis.x = out->axis.y = out->axis.z = 0;
  if (obstacle != NULL) {
    out->other = obstacle;
    out->centre[0] = bounded_way(&part->at[start], &obstacle->centre, &out->axis);
    out->centre[1] = bounded_way(&part->at[end], &obstacle->centre, &out->axis);
    return;
  }
  const gjk_arm_part_room *other = &arm->memory.parts[pair->other];
  out->other = &other->collider;
  for (unsigned i = 0; i < 2; i++) {
    const unsigned which = out->frame[i];
    const gjk_vec3 away = gjk_sub(part->at[which], other->at[which]);  // at most 2^28
    out->centre[i] = gjk_rotate_back(arm->memory.links[pair->frame].frame[which].rows, &away);
  }
}

// May P be looked at along an axis alone?
static bool is_far(const gjk_arm_view *view) {
  return (view->axis.x | view->axis.y | view->axis.z) != 0;
}

// Sets the rest of a view.
static void look_closely(gjk_arm_view *view) {
  const gjk_arm *arm = view->arm;
  const gjk_arm_link_room *link = &arm->memory.links[arm->model->parts[view->pair->part].link];
  for (unsigned end = 0; end < 2; end++) {
    const unsigned which = view->frame[end];
    const gjk_vec3 *at = &link->frame[which].at, *centre = &view->other->centre;
    if (view->pair->frame >= GJK_ARM_BODY) {
      view->rows[end] = link->frame[which].rows;
      // Where the centre is not far, the origin is at most GJK_ARM_REACH_MAX farther: below 2^31.
      view->origin[end] = is_far(view) ? bounded_way(at, centre, &view->axis) : gjk_sub(*at, *centre);
    } else {
      const gjk_arm_link_room *base = &arm->memory.links[view->pair->frame];
      const gjk_vec3 away = gjk_sub(*at, base->frame[which].at);  // both are within GJK_ARM_REACH_MAX of the base
      relative_rows(base->frame[which].rows, link->frame[which].rows, view->turned[end]);
      view->rows[end] = view->turned[end];
      view->origin[end] = gjk_sub(gjk_rotate_back(base->frame[which].rows, &away), *centre);
    }
  }
}

// The reach of both spheres, and what the roundings of centres may take: the gap of supports is no smaller.
static int64_t spheres_of(const gjk_collider *part, const gjk_collider *other) {
  return (int64_t)part->radius + other->radius + 6;
}

bool gjk_arm_spheres_apart(const gjk_arm *arm, const gjk_arm_pair *pair, const gjk_collider *other, int64_t gap) {
  const gjk_arm_part_room *part = &arm->memory.parts[pair->part];
  return gjk_arm_balls_apart(&part->middle, &other->centre, spheres_of(&part->collider, other) + gap + part->half);
}

// Both convex radii, LSB: below 2^29.
static int64_t radii_of(const gjk_arm_view *view) {
  return (int64_t)view->part->collider.shape->convex_radius + view->other->shape->convex_radius;
}

// The point of P that is farthest along d, in its link's frame. Pre: d != 0, |d| <= 2^31.
static gjk_vec3 support_of_part(const gjk_arm_part_room *part, const gjk_vec3 *d) {
  const gjk_collider *c = &part->collider;
  if (part->scanned) {
    const unsigned bits = 32 - gjk_clz32((uint32_t)part->reach);  // reach is at least 1
    return *gjk_scan(c->shape->vertices, c->shape->vertices + c->shape->count, bits, d);
  }
  gjk_support support;
  c->shape->type->support(c, d, &support);
  return gjk_add(support.offset, c->centre);
}

void gjk_arm_box(const gjk_arm *arm, unsigned number, unsigned start, unsigned end, gjk_aabb *out) {
  const gjk_arm_part_room *part = &arm->memory.parts[number];
  const gjk_q16 radius = part->collider.shape->convex_radius;
  const gjk_arm_frame *frames = arm->memory.links[arm->model->parts[number].link].frame;
  int64_t low[3], high[3];
  for (unsigned axis = 0; axis < 3; axis++) {
    int64_t least = INT64_MAX, most = INT64_MIN;
    for (unsigned i = 0; i < 2; i++) {
      const gjk_arm_frame *frame = &frames[i == 0 ? start : end];
      const gjk_vec3 *d = &frame->rows[axis], *o = &frame->at, back = gjk_negate(*d);
      const gjk_vec3 far = support_of_part(part, d), near = support_of_part(part, &back);
      const int32_t at = gjk_component(o, axis);
      const int64_t above = at + gjk_sar64(gjk_dot(d, &far), 30) + 1 + radius;
      const int64_t below = at + gjk_sar64(gjk_dot(d, &near), 30) - radius;
      most = above > most ? above : most;
      least = below < least ? below : least;
    }
    low[axis] = least;
    high[axis] = most;
  }
  out->lower.x = gjk_saturate(low[0]);
  out->lower.y = gjk_saturate(low[1]);
  out->lower.z = gjk_saturate(low[2]);
  out->upper.x = gjk_saturate(high[0]);
  out->upper.y = gjk_saturate(high[1]);
  out->upper.z = gjk_saturate(high[2]);
}

// The point of S that is farthest along n, from its centre.
static gjk_vec3 support_of_other(const gjk_arm_view *view, const gjk_unit3 *n) {
  const gjk_vec3 direction = {n->x, n->y, n->z};
  if (view->pair->frame < GJK_ARM_BODY) {
    const gjk_vec3 point = support_of_part(&view->arm->memory.parts[view->pair->other], &direction);
    return gjk_sub(point, view->other->centre);
  }
  gjk_support support;
  view->other->shape->type->support(view->other, &direction, &support);
  return support.offset;
}

// The gap at one end, Q30, less what the convex radii and S take. *local: the point of P, in its link's frame.
//   |origin| < sqrt(3) (2^30 + 2^27), |point| <= 2^27, times 2^30:  below 2^61.2
static int64_t height_of_part(const gjk_arm_view *view, unsigned end, const gjk_unit3 *n, gjk_vec3 *local) {
  const gjk_vec3 direction = {n->x, n->y, n->z};
  const gjk_vec3 toward = gjk_negate(gjk_rotate_back(view->rows[end], &direction));
  *local = support_of_part(view->part, &toward);
  return gjk_along(n, &view->origin[end]) - gjk_dot(&toward, local);
}

// Step 3. *w: the lower difference, if it is wanted.
static int64_t arm_lower_end(const gjk_arm_view *view, const gjk_unit3 *n, gjk_vec3 *w) {
  const gjk_vec3 of_other = support_of_other(view, n);
  gjk_vec3 local, at_end;
  unsigned end = 0;
  int64_t height = height_of_part(view, 0, n, &local);
  if (view->frame[0] != view->frame[1]) {
    const int64_t there = height_of_part(view, 1, n, &at_end);
    if (there < height) {
      height = there;
      local = at_end;
      end = 1;
    }
  }
  if (w != NULL) {
    *w = gjk_sub(gjk_add(gjk_rotate(view->rows[end], &local), view->origin[end]), of_other);
  }
  return height - gjk_along(n, &of_other) - gjk_shl64(radii_of(view), 30);  // radii below 2^29
}

// Is the view not far, or the direction along its axis?
static bool may_look_along(const gjk_arm_view *view, const gjk_unit3 *n) {
  const gjk_vec3 *axis = &view->axis;
  if (!is_far(view)) {
    return true;
  }
  return (axis->x != 0 && n->y == 0 && n->z == 0) || (axis->y != 0 && n->x == 0 && n->z == 0) ||
         (axis->z != 0 && n->x == 0 && n->y == 0);
}

bool gjk_arm_gap(gjk_arm_view *view, const gjk_unit3 *direction, int64_t *gap) {
  look_closely(view);
  if (!may_look_along(view, direction)) {
    return false;
  }
  *gap = arm_lower_end(view, direction, NULL);
  return true;
}

// The direction along which a far view is looked at.
static gjk_unit3 far_direction(const gjk_vec3 *axis) {
  const gjk_unit3 x = {axis->x * GJK_Q30_ONE, 0, 0}, y = {0, axis->y * GJK_Q30_ONE, 0};
  const gjk_unit3 z = {0, 0, axis->z * GJK_Q30_ONE};
  return axis->x != 0 ? x : axis->y != 0 ? y : z;
}

// The middle of the chord between the centres.
static gjk_vec3 middle_of(const gjk_arm_view *view) {
  const gjk_vec3 *a = &view->centre[0], *b = &view->centre[1];
  const gjk_vec3 middle = {gjk_sar32(a->x, 1) + gjk_sar32(b->x, 1), gjk_sar32(a->y, 1) + gjk_sar32(b->y, 1),
                           gjk_sar32(a->z, 1) + gjk_sar32(b->z, 1)};
  return middle;
}

// Step 1: the direction along middle. Pre: middle is not 0.
static gjk_unit3 along_middle(const gjk_vec3 *middle) {
  const gjk_vec3 half = {gjk_sar32(middle->x, 1), gjk_sar32(middle->y, 1), gjk_sar32(middle->z, 1)};
  const uint32_t size = gjk_magnitude32(middle->x) | gjk_magnitude32(middle->y) | gjk_magnitude32(middle->z);
  return gjk_unit(size >> 29 != 0 ? &half : middle);
}

// Step 1: the gap of the spheres along n, Q30.
static int64_t spheres_gap(const gjk_arm_view *view, const gjk_unit3 *n) {
  const int64_t a = gjk_along(n, &view->centre[0]), b = gjk_along(n, &view->centre[1]);
  return (a <= b ? a : b) - gjk_shl64(spheres_of(&view->part->collider, view->other), 30);
}

// In units of 2^coarse, a difference is below 2^30 and an edge below 2^31 in length; see gjk_simplex.h.
//   coarse 0   components of origins below 2^27, points of P and S below 2^27 and 2^28:     |w| < 2^29.3, edges 2^30.3
//   coarse 2   components of w below 2^30 + 2^28 + 2^27, a quarter of them:                 |w| < 2^29.1, edges 2^30.1
static unsigned coarseness(const gjk_arm_view *view) {
  const gjk_vec3 *a = &view->origin[0], *b = &view->origin[1];
  const uint32_t size = gjk_magnitude32(a->x) | gjk_magnitude32(a->y) | gjk_magnitude32(a->z) | gjk_magnitude32(b->x) |
                        gjk_magnitude32(b->y) | gjk_magnitude32(b->z);
  return size >> 27 != 0 ? 2 : 0;
}

// Steps 4 and 5. False: not apart; *gap, LSB, is that of the feature, less than any if it holds the origin. Else *n is the
// next direction.
static bool next_direction(const gjk_arm_view *view, gjk_simplex *s, const gjk_vec3 *w, unsigned coarse, gjk_unit3 *n,
                           int64_t *gap) {
  gjk_search_direction direction;
  gjk_vertex *added = gjk_simplex_free(s);
  added->w.x = gjk_sar32(w->x, coarse);
  added->w.y = gjk_sar32(w->y, coarse);
  added->w.z = gjk_sar32(w->z, coarse);
  const gjk_step step = gjk_simplex_add(s);
  *gap = INT64_MIN;
  if (step == GJK_STEP_ENCLOSING || !gjk_simplex_direction(s, &direction)) {
    return false;
  }
  const gjk_unit3 back = gjk_unit(&direction.d);
  *gap = gjk_sar64(gjk_shl64(-gjk_along(&back, &gjk_simplex_vertex(s, 0)->w), coarse), 30) - radii_of(view);
  n->x = -back.x;
  n->y = -back.y;
  n->z = -back.z;
  return step == GJK_STEP_NEARER;
}

// Steps 3 to 5, from *n on.
static gjk_arm_found part_hulls(const gjk_arm_view *view, const gjk_arm_search *search, gjk_unit3 *n, int64_t *gap) {
  const int64_t least = gjk_shl64(search->wanted, 30);
  const unsigned coarse = coarseness(view);
  gjk_simplex simplex;
  gjk_simplex_clear(&simplex);
  for (unsigned round = 0; round < ARM_ROUNDS; round++) {
    gjk_vec3 w;
    int64_t of_feature;
    *gap = arm_lower_end(view, n, &w);
    if (*gap > least) {
      return GJK_ARM_APART;
    }
    if (!next_direction(view, &simplex, &w, coarse, n, &of_feature) || of_feature <= search->wanted) {
      return of_feature <= search->near ? GJK_ARM_CLOSE : GJK_ARM_OPEN;
    }
  }
  return GJK_ARM_OPEN;
}

// Is a search not worth its while? The centre of a shape mostly lies in it, so that a search finds no gap above the distance
// of the centres. The answer does not depend on it, but for what is UNSETTLED. gap: of the spheres, Q30.
static bool is_hopeless(const gjk_arm_view *view, const gjk_arm_search *search, int64_t gap) {
  const int64_t radii = (int64_t)view->part->collider.radius + view->other->radius;
  return search->wanted > 4 * search->near && gjk_sar64(gap, 30) + radii < search->wanted;
}

gjk_arm_found gjk_arm_separate(gjk_arm_view *view, const gjk_arm_search *search, gjk_unit3 *kept, gjk_unit3 *direction,
                               int64_t *gap) {
  const gjk_vec3 middle = middle_of(view);
  const bool apart = (middle.x | middle.y | middle.z) != 0;
  gjk_unit3 n = {GJK_Q30_ONE, 0, 0};
  if (is_far(view)) {
    look_closely(view);
    n = far_direction(&view->axis);
    *gap = arm_lower_end(view, &n, NULL);
    *direction = n;
    return *gap > gjk_shl64(search->wanted, 30) ? GJK_ARM_APART : GJK_ARM_OPEN;
  }
  // Step 1
  if (apart) {
    n = along_middle(&middle);
    *gap = spheres_gap(view, &n);
    if (*gap > gjk_shl64(search->wanted, 30)) {
      *direction = n;
      return GJK_ARM_APART;
    }
    if (is_hopeless(view, search, *gap)) {
      return GJK_ARM_OPEN;
    }
  }
  // Step 2
  if ((kept->x | kept->y | kept->z) != 0) {
    n = *kept;
  }
  look_closely(view);
  const gjk_arm_found found = part_hulls(view, search, &n, gap);
  if (found == GJK_ARM_APART) {
    *kept = n;
    *direction = n;
  }
  return found;
}
