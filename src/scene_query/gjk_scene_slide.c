// Move and slide.
//
// 1. Free the start: where something is nearer than the skin, go away from it; where it touches, go up by the skin.
// 2. Cast along the way, with the skin as margin. Go to where the cast rests, and a little farther away from the plane.
// 3. Clip what is left of the way by all planes so far: along the last one where that leads into none, else along the
//    line of two, else nowhere. Go on at 2, up to GJK_SLIDE_PLANES times.
// 4. Step: if a plane was met that is too steep, do 2 and 3 once more from step higher up, then go down again. The result
//    counts if it stands on something and got farther.
// 5. Look for ground: cast down by reach.
//
// A cast that starts nearer than its margin tells that, but not what is met later. It is repeated with smaller margins.
// So rounding, which may bring it nearer to a plane than the skin by an LSB, never stops it.
#include "../arith/gjk_memory.h"
#include "../scene/gjk_scene_part.h"
#include "../scene/gjk_scene_solid.h"
#include "gjk_scene_inquiry.h"

#ifndef GJK_SCENE_OF_PLANE
#include "../scene/gjk_scene_travel.h"
#endif
#ifndef GJK_SCENE_OF_PLANE
#include "../arith/gjk_unit.h"
#endif

// Half of margins that a cast is tried with, before it is tried with 0.
#define MARGINS 3

typedef struct slider {
  const gjk_scene *scene;
  const gjk_slide_setup *setup;
  gjk_collider collider;  // where it is
  gjk_scene_vicinity near;
  gjk_slide_result *out;
  gjk_status status;  // OK, or ITERATION_LIMIT: it has to stop
} slider;

// A cast of the slider.
typedef struct answer {
  bool found;
  gjk_scene_hit hit;
  gjk_cast_result result;
} answer;

// v . n, Q30.  |v| < 2^31, |n| <= 2^30 (1 + 2^-16):  < 2^62
static int64_t along_unit(const gjk_unit3 *n, const gjk_vec3 *v) {
#if GJK_SCENE_AXES == 3
  return gjk_mac32(gjk_mac32(gjk_mul32(n->x, v->x), n->y, v->y), n->z, v->z);
#else
  return gjk_mac32(gjk_mul32(n->x, v->x), n->y, v->y);
#endif
}

// v . w.  Each component < 2^30:  < 2^62
static int64_t dot_of(const gjk_vec3 *v, const gjk_vec3 *w) {
#if GJK_SCENE_AXES == 3
  return gjk_mac32(gjk_mac32(gjk_mul32(v->x, w->x), v->y, w->y), v->z, w->z);
#else
  return gjk_mac32(gjk_mul32(v->x, w->x), v->y, w->y);
#endif
}

static int32_t sign_of(int32_t x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

// How far a length along a unit vector leads along one of its components, rounded away from 0.
static int32_t component_of(gjk_q30 n, int64_t length) {
  const int64_t whole = gjk_sar64(n * length + (n * length > 0 ? GJK_Q30_ONE - 1 : 0), 30);
  return (int32_t)whole;
}

// The vector of a length along a unit vector, each component rounded away from 0. Pre: 0 <= length < 2^31.
static gjk_vec3 length_along(const gjk_unit3 *n, int64_t length) {
  gjk_vec3 v;
  v.x = component_of(n->x, length);
  v.y = component_of(n->y, length);
#if GJK_SCENE_AXES == 3
  v.z = component_of(n->z, length);
#endif
  return v;
}

static gjk_vec3 moved_by(const gjk_vec3 *v, const gjk_vec3 *w) {
  gjk_vec3 s = *v;
  gjk_scene_shift(&s, w);
  return s;
}

static gjk_vec3 turned_round(const gjk_vec3 *v) {
  const gjk_vec3 origin = gjk_scene_equal_vec3(0);
  gjk_vec3 w;
  gjk_scene_way(v, &origin, &w);
  return w;
}

// Takes the slider to a place, if that is in range.
static void go_there(slider *s, const gjk_vec3 *position) {
  (void)gjk_collider_move(&s->collider, position);
}

// Casts the slider along a way.
static void cast_slider(slider *s, const gjk_vec3 *way, gjk_q16 margin, answer *a) {
  const gjk_vec3 to = moved_by(&s->collider.position, way);
  a->found = false;
  s->out->casts++;
  const gjk_status status = gjk_scene_cast_near(s->scene, &s->near, &s->collider, &to, margin, s->setup->filter,
                                                &a->hit, &a->result, &a->found);
  if (status != GJK_OK) {
    s->status = status;
  }
}

// The same with the largest margin for which it does not start inside; inside only if it touches.
static void cast_free(slider *s, const gjk_vec3 *way, answer *a) {
  gjk_q16 margin = s->setup->skin;
  for (int i = 0; i <= MARGINS; i++) {
    cast_slider(s, way, i < MARGINS ? margin : 0, a);
    if (s->status != GJK_OK || !a->found || !a->result.inside) {
      return;
    }
    margin /= 2;
  }
}

static void put_component(gjk_vec3 *v, int axis, int32_t x) {
  if (axis == 0) {
    v->x = x;
  }
  if (axis == 1) {
    v->y = x;
  }
#if GJK_SCENE_AXES == 3
  if (axis == 2) {
    v->z = x;
  }
#endif
}

// Step 1, where it touches or overlaps another one: up, or else along an axis of the world, by a little more than the skin.
// False: no such way leads out.
static bool leave(slider *s, const gjk_scene_view *v, const gjk_scene_part *part, const gjk_collider *other) {
  const gjk_q16 skin = s->setup->skin, far = skin + 2;
  for (int i = 0; i <= 2 * GJK_SCENE_AXES; i++) {
    gjk_decision decision;
    gjk_collider moved;
    gjk_copy(&moved, &s->collider, sizeof moved);
    gjk_vec3 away = gjk_scene_equal_vec3(0);
    if (i == 0) {
      away = length_along(&s->setup->up, far);
    } else {
      put_component(&away, (i - 1) / 2, i % 2 != 0 ? far : -far);
    }
    const gjk_vec3 place = moved_by(&s->collider.position, &away);
    (void)gjk_collider_move(&moved, &place);
    if (gjk_scene_ask_within(v, part, NULL, other, &moved, skin, NULL, &decision) == GJK_OK && !decision.yes) {
      gjk_copy(&s->collider, &moved, sizeof moved);
      return true;
    }
  }
  return false;
}

// Step 1, a try: goes away from what is nearer than the skin, one after the other. Returns whether nothing is left.
static bool go_away(slider *s) {
  const gjk_vec3 nowhere = gjk_scene_equal_vec3(0);
  answer a;
  for (int i = 0; i < GJK_SLIDE_PLANES; i++) {
    gjk_scene_view v;
    gjk_aabb box;
    gjk_collider other;
    gjk_distance_result apart;
    cast_slider(s, &nowhere, s->setup->skin, &a);
    if (s->status != GJK_OK || !a.found) {
      return s->status == GJK_OK;
    }
    (void)gjk_scene_view_of(s->scene, &v);  // cannot fail: it was hit
    const gjk_scene_part *part = &v.parts[gjk_scene_part_of(&v, &v.bodies[a.hit.body.slot], a.hit.part)];
    gjk_scene_part_now(&v, part, &other, &box);
    if (gjk_scene_ask_distance(&v, part, NULL, &other, &s->collider, NULL, &apart) != GJK_OK || apart.intersecting) {
      if (!leave(s, &v, part, &other)) {
        return false;
      }
    } else {
      const gjk_q16 lacking = s->setup->skin - apart.distance;
      const gjk_vec3 away = length_along(&apart.normal, lacking > 0 ? lacking + 2 : 2);
      const gjk_vec3 place = moved_by(&s->collider.position, &away);
      go_there(s, &place);
    }
  }
  return false;
}

// Step 1. Returns whether it is free. Between two things that leave no room for the skin it stays as near as it is.
static bool free_start(slider *s) {
  const gjk_vec3 nowhere = gjk_scene_equal_vec3(0);
  gjk_vec3 start;
  answer a;
  a.found = true;
  gjk_copy(&start, &s->collider.position, sizeof start);
  if (go_away(s)) {
    return true;
  }
  for (int i = 0; i < 2 && s->status == GJK_OK; i++) {
    cast_slider(s, &nowhere, 0, &a);
    if (!a.found) {
      break;
    }
    go_there(s, &start);
  }
  return s->status == GJK_OK && !a.found;
}

// Clips a way by one plane: what leads into it is taken away, and a little more.
static gjk_vec3 clip_way(const gjk_vec3 *way, const gjk_unit3 *n) {
  const int64_t into = along_unit(n, way);
  if (into >= 0) {
    return *way;
  }
  const gjk_vec3 off = length_along(n, -gjk_sar64(into, 30));  // |into| < 2^61:  < 2^31
  gjk_vec3 clipped = moved_by(way, &off);
  clipped.x += sign_of(n->x);
  clipped.y += sign_of(n->y);
#if GJK_SCENE_AXES == 3
  clipped.z += sign_of(n->z);
#endif
  return clipped;
}

// Does a way lead into none of the planes? By less than 2 LSB does not count: the skin is wider.
static bool leads_out(const gjk_slide_result *out, const gjk_vec3 *way) {
  for (unsigned i = 0; i < out->count; i++) {
    if (along_unit(&out->plane[i].normal, way) < -(INT64_C(2) << 30)) {
      return false;
    }
  }
  return true;
}

#if GJK_SCENE_AXES == 3
// The line of two planes. False: they are all but parallel.
static bool line_of(const gjk_unit3 *m, const gjk_unit3 *n, gjk_unit3 *out) {
  // Components of products < 2^61, of the difference >> 31:  < 2^31; the length < 2^30
  const gjk_vec3 d = {(int32_t)gjk_sar64(gjk_mul32(m->y, n->z) - gjk_mul32(m->z, n->y), 31),
                      (int32_t)gjk_sar64(gjk_mul32(m->z, n->x) - gjk_mul32(m->x, n->z), 31),
                      (int32_t)gjk_sar64(gjk_mul32(m->x, n->y) - gjk_mul32(m->y, n->x), 31)};
  if (gjk_scene_is_below(&d, 16)) {
    return false;
  }
  *out = gjk_unit(&d);
  return true;
}
#endif

// Step 3: what is left of a way. Out of line: elsewhere GCC copies its result by memcpy for Cortex-M0.
GJK_OUT_OF_LINE static gjk_vec3 slide_on(const gjk_slide_result *out, const gjk_vec3 *way) {
  for (unsigned i = out->count; i > 0; i--) {
    const gjk_vec3 along_one = clip_way(way, &out->plane[i - 1].normal);
    if (leads_out(out, &along_one)) {
      return along_one;
    }
  }
#if GJK_SCENE_AXES == 3
  for (unsigned i = 1; i < out->count; i++) {
    gjk_unit3 line;
    for (unsigned k = 0; k < i; k++) {
      if (line_of(&out->plane[i].normal, &out->plane[k].normal, &line)) {
        const int64_t length = gjk_sar64(along_unit(&line, way), 30);
        const gjk_vec3 there = length_along(&line, length < 0 ? -length : length);
        const gjk_vec3 along_two = length < 0 ? turned_round(&there) : there;
        if (leads_out(out, &along_two)) {
          return along_two;
        }
      }
    }
  }
#endif
  return gjk_scene_equal_vec3(0);
}

static void set_slide_plane(const answer *a, gjk_slide_plane *out) {
  out->part = a->hit;
  out->normal = a->result.normal;
}

// Goes to where a cast rests, 1 or 2 LSB farther away from what it met.
static void go_to_rest(slider *s, const answer *a) {
  gjk_vec3 place = a->result.rest_b;
  place.x += sign_of(a->result.normal.x);
  place.y += sign_of(a->result.normal.y);
#if GJK_SCENE_AXES == 3
  place.z += sign_of(a->result.normal.z);
#endif
  go_there(s, &place);
}

static bool is_steep(const gjk_slide_setup *setup, const gjk_unit3 *normal) {
#if GJK_SCENE_AXES == 3
  const gjk_vec3 up = {setup->up.x, setup->up.y, setup->up.z};
#else
  const gjk_vec3 up = {setup->up.x, setup->up.y};
#endif
  return gjk_sar64(along_unit(normal, &up), 30) < setup->slope;
}

// Steps 2 and 3. Writes planes, count and left.
static void slide_along(slider *s, gjk_vec3 way) {
  gjk_slide_result *out = s->out;
  const gjk_vec3 first = way;
  answer a;
  out->count = 0;
  while (!gjk_scene_is_zero(&way) && out->count < GJK_SLIDE_PLANES) {  // ends: each turn adds a plane, or is the last
    const gjk_vec3 end = moved_by(&s->collider.position, &way);
    cast_free(s, &way, &a);
    if (s->status != GJK_OK || (a.found && a.result.inside)) {
      break;
    }
    if (!a.found) {
      go_there(s, &end);
      gjk_scene_set_zero(&way);
      break;
    }
    go_to_rest(s, &a);
    set_slide_plane(&a, &out->plane[out->count++]);
    gjk_scene_way(&s->collider.position, &end, &way);
    way = slide_on(out, &way);
    // Back from where it came would make it swing in corners.
    const gjk_vec3 back = turned_round(&first);
    if (gjk_scene_is_below(&way, 2) || dot_of(&way, &back) > 0) {
      gjk_scene_set_zero(&way);
    }
  }
  out->left = way;
}

// Step 4. Is tried from the place where it started.
static void climb(slider *s, const gjk_vec3 *start, const gjk_vec3 *way) {
  gjk_slide_result *out = s->out;
  gjk_slide_result low;
  const gjk_vec3 up = length_along(&s->setup->up, s->setup->step);
  gjk_vec3 place, higher, gone, gone_low;
  answer a;
  gjk_copy(&place, &s->collider.position, sizeof place);
  gjk_copy(&low, out, sizeof low);
  go_there(s, start);
  cast_free(s, &up, &a);
  if (s->status == GJK_OK && !(a.found && a.result.inside)) {
    const gjk_vec3 top = moved_by(start, &up);
    if (a.found) {
      go_to_rest(s, &a);
    } else {
      go_there(s, &top);
    }
    gjk_scene_way(start, &s->collider.position, &higher);
    slide_along(s, *way);
    const gjk_vec3 down = turned_round(&higher);
    if (s->status == GJK_OK) {
      cast_free(s, &down, &a);
    }
    if (s->status == GJK_OK && a.found && !a.result.inside && !is_steep(s->setup, &a.result.normal)) {
      go_to_rest(s, &a);
      gjk_scene_way(start, &s->collider.position, &gone);
      gjk_scene_way(start, &place, &gone_low);
      if (dot_of(&gone, way) > dot_of(&gone_low, way)) {
        out->stepped = true;
        return;
      }
    }
  }
  const uint8_t casts = out->casts;
  s->status = s->status == GJK_ERROR_ITERATION_LIMIT ? GJK_OK : s->status;
  gjk_copy(out, &low, sizeof low);
  out->casts = casts;
  go_there(s, &place);
}

// Step 5.
static void find_ground(slider *s) {
  const gjk_vec3 up = length_along(&s->setup->up, s->setup->reach), down = turned_round(&up);
  answer a;
  cast_free(s, &down, &a);
  if (s->status == GJK_OK && a.found && !a.result.inside && !is_steep(s->setup, &a.result.normal)) {
    s->out->on_ground = true;
    set_slide_plane(&a, &s->out->ground);
    if (s->setup->snap) {
      go_to_rest(s, &a);
    }
  }
}

// May it be a component of a unit vector?
static bool may_be_component(gjk_q30 x) {
  return x >= -GJK_Q30_ONE - 65536 && x <= GJK_Q30_ONE + 65536;
}

static bool is_unit(const gjk_unit3 *n) {
#if GJK_SCENE_AXES == 3
  const gjk_vec3 v = {n->x, n->y, n->z};
  const bool parts = may_be_component(n->x) && may_be_component(n->y) && may_be_component(n->z);
#else
  const gjk_vec3 v = {n->x, n->y};
  const bool parts = may_be_component(n->x) && may_be_component(n->y);
#endif
  const int64_t squared = parts ? along_unit(n, &v) : 0;  // Q60
  const int64_t one = INT64_C(1) << 60, slack = INT64_C(1) << 45;
  return squared > one - slack && squared < one + slack;
}

static gjk_status check_slide(const gjk_slide_setup *s) {
  if (s->slope < 0 || s->slope > GJK_Q30_ONE || s->skin < GJK_SLIDE_SKIN_MIN || s->skin > GJK_Q16_ONE || s->step < 0 ||
      s->step > GJK_RADIUS_MAX || s->reach < 0 || s->reach > GJK_RADIUS_MAX) {
    return GJK_ERROR_RANGE;
  }
  return is_unit(&s->up) ? GJK_OK : GJK_ERROR_ROTATION;
}

gjk_status gjk_slide(const gjk_scene *scene, const gjk_collider *collider, const gjk_vec3 *to,
                     const gjk_slide_setup *setup, gjk_slide_result *out) {
  gjk_scene_view v;
  gjk_aabb box;
  gjk_vec3 way, goal;
  slider s;
  gjk_status status = to == NULL || setup == NULL || out == NULL ? GJK_ERROR_NULL : gjk_scene_view_of(scene, &v);
  if (status == GJK_OK) {
    status = gjk_collider_aabb(collider, &box);
  }
  if (status == GJK_OK) {
    status = check_slide(setup);
  }
  if (status != GJK_OK) {
    return status;
  }
  goal = *to;  // which may be a part of out
  // Both within 2^30: then the way and all steps stay in int32.
  gjk_scene_way(&collider->position, to, &way);
  if (!gjk_scene_is_below(&collider->position, 30) || !gjk_scene_is_below(to, 30) || !gjk_scene_is_below(&way, 29) ||
      !gjk_scene_is_below(&collider->centre, 30)) {
    return GJK_ERROR_RANGE;
  }
  s.scene = scene;
  s.setup = setup;
  gjk_copy(&s.collider, collider, sizeof s.collider);
  s.out = out;
  s.status = GJK_OK;
  out->count = 0;
  out->casts = 0;
  out->on_ground = out->stepped = false;
  gjk_scene_set_zero(&out->left);
  // Every cast stays in that box, save of one that is shoved far from where it starts.
  const gjk_q16 most = setup->step > setup->reach ? setup->step : setup->reach;
  gjk_copy(&s.near.box, &box, sizeof box);
  gjk_scene_grow(&s.near.box, most + 2 * setup->skin + 2 * GJK_SCENE_EARLY, &way, 1);
  gjk_scene_look_round(&v, setup->filter, &s.near);
  out->stuck = !free_start(&s);
  if (out->stuck) {
    out->position = collider->position;
    gjk_copy(&out->left, &way, sizeof way);
  } else {
    gjk_vec3 start;
    bool steep = false;
    gjk_copy(&start, &s.collider.position, sizeof start);
    gjk_scene_way(&start, &goal, &way);
    slide_along(&s, way);
    for (unsigned i = 0; i < out->count; i++) {
      steep = steep || is_steep(setup, &out->plane[i].normal);
    }
    if (s.status == GJK_OK && steep && setup->step > 0) {
      climb(&s, &start, &way);
    }
    if (s.status == GJK_OK && setup->reach > 0) {
      find_ground(&s);
    }
    gjk_copy(&out->position, &s.collider.position, sizeof out->position);
  }
  return s.status;
}
