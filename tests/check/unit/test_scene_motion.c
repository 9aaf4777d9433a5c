// Rays and casts against the shapes of a scene, and the parts within a distance, against a search of all parts: what is
// found, its order, any buffer, filters; and that history, posing and the tree do not matter.
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "scene/world.h"
#include "scene_hits.h"

// The test of the plane has included the plane's.
#ifndef WORLD_OF_PLANE
#include "gjk/probe.h"
#define AXES 3
#define TRIANGLE(corners) GJK_TRIANGLE(corners)
#else
#define AXES 2
#define TRIANGLE(corners) GJK2_POLYGON(corners, 3)
#endif

#ifndef TEST_NAME
#define TEST_NAME "scene_motion"
#endif

#define HITS (WORLD_BODIES * WORLD_PARTS)
#define WORLDS check_trials(40)
#define QUERIES 30
#define SEED 7740

static world w;
static unsigned long found_by_rays, found_by_casts, found_within, missed, filtered, open_queries;

// One question to a scene: a ray, a cast or the parts within a distance.
typedef enum kind { RAY, CAST, WITHIN, KINDS } kind;

typedef struct question {
  kind kind;
  gjk_vec3 from, to;
  gjk_collider collider;
  gjk_q16 margin;
  gjk_scene_filter filter;
  bool filters;
} question;

static bool accept(void *user, gjk_body_id body, uint32_t user_of_body, uint16_t part) {
  const uint32_t *salt = user;
  return w.bodies[body.slot].setup.user == user_of_body && ((user_of_body ^ *salt ^ part) & 3u) != 0;
}

static bool passes(const question *q, const world_body *b, uint16_t part) {
  const gjk_scene_filter *f = &q->filter;
  return !q->filters || ((f->category & b->setup.mask) != 0 && (b->setup.category & f->mask) != 0 &&
                         !(f->ignore.slot == b->id.slot && f->ignore.generation == b->id.generation) &&
                         (f->accept == NULL || f->accept(f->user, b->id, b->setup.user, part)));
}

// Does the part answer the question, and where? *open: the query reached its ceiling.
static bool ask_part(const question *q, const gjk_collider *part, uint32_t *fraction, gjk_cast_result *result,
                     bool *open) {
  gjk_decision decision = {0};
  const gjk_cast_path path = {NULL, &q->to, q->margin};
  gjk_status status;
  *fraction = 0;
  if (q->kind == WITHIN) {
    status = gjk_within(&q->collider, part, q->margin, NULL, &decision);
    *open = *open || status != GJK_OK;
    return decision.yes;
  }
  status = q->kind == RAY ? gjk_cast_ray(part, &q->from, &q->to, result) : gjk_cast(part, &q->collider, &path, result);
  *open = *open || status != GJK_OK;
  *fraction = status == GJK_OK && result->hit ? (uint32_t)result->fraction : 0;
  return status == GJK_OK && result->hit;
}

// What the scene must find, in order. first: the result of the first hit.
static uint32_t search(const question *q, gjk_scene_hit *hits, gjk_cast_result *first, bool *open) {
  uint32_t count = 0;
  *open = false;
  for (uint32_t i = 0; i < w.options.bodies; i++) {
    const world_body *b = &w.bodies[i];
    for (uint16_t k = 0; b->id.generation != 0 && k < b->setup.part_count; k++) {
      gjk_scene_hit hit = {b->id, k, 0, b->setup.user};
      gjk_cast_result result;
      if (!passes(q, b, k)) {
        filtered++;
      } else if (ask_part(q, &b->colliders[k], &hit.fraction, &result, open)) {
        hits[count++] = hit;
        if (q->kind != WITHIN && (count == 1 || order_hits(&hit, &hits[0]) < 0)) {
          *first = result;
          const gjk_scene_hit other = hits[0];
          hits[0] = hit;
          hits[count - 1] = count == 1 ? hit : other;
        }
      } else {
        missed++;
      }
    }
  }
  qsort(hits, count, sizeof hits[0], order_hits);
  return count;
}

static gjk_status ask(const question *q, const gjk_scene_hit *after, gjk_scene_hit *hits, uint32_t capacity,
                      uint32_t *count) {
  const gjk_scene_filter *filter = q->filters ? &q->filter : NULL;
  switch (q->kind) {
    case RAY: return gjk_scene_cast_ray_all(&w.scene, &q->from, &q->to, filter, after, hits, capacity, count);
    case CAST:
      return gjk_scene_cast_all(&w.scene, &q->collider, &q->to, q->margin, filter, after, hits, capacity, count);
    default: return gjk_scene_query_within(&w.scene, &q->collider, q->margin, filter, after, hits, capacity, count);
  }
}

// The nearest hit is the first of all, with the result of its own cast.
static void check_nearest(const question *q, const gjk_scene_hit *expected, uint32_t wanted,
                          const gjk_cast_result *first) {
  const gjk_scene_filter *filter = q->filters ? &q->filter : NULL;
  gjk_scene_hit hit = {{7, 7}, 7, 7, 7};
  gjk_cast_result result;
  bool found = wanted == 0;
  memset(&result, 0x5A, sizeof result);
  const gjk_cast_result untouched = result;
  const gjk_status status =
      q->kind == RAY ? gjk_scene_cast_ray(&w.scene, &q->from, &q->to, filter, &hit, &result, &found)
                     : gjk_scene_cast(&w.scene, &q->collider, &q->to, q->margin, filter, &hit, &result, &found);
  CHECK(status == GJK_OK);
  CHECK(found == (wanted > 0));
  if (wanted == 0) {
    CHECK(hit.body.slot == 7 && hit.part == 7 && hit.fraction == 7);
    CHECK(memcmp(&result, &untouched, sizeof result) == 0);
  } else {
    CHECK(same_hits(&hit, expected, 1));
    CHECK(result.hit && result.inside == first->inside && result.fraction == first->fraction);
    CHECK(result.inside || memcmp(&result.point_a, &first->point_a, sizeof result.point_a) == 0);
    CHECK(memcmp(&result.rest_b, &first->rest_b, sizeof result.rest_b) == 0);
    CHECK(memcmp(&result.normal, &first->normal, sizeof result.normal) == 0);
    CHECK(result.certificate.proof == first->certificate.proof && result.certificate.count == first->certificate.count);
    CHECK(result.certificate.count == 0 || result.certificate.count == 3 ||
          memcmp(&result.certificate.direction, &first->certificate.direction, sizeof result.certificate.direction) ==
              0);
    for (int i = 0; i < result.certificate.count; i++) {
      CHECK(result.certificate.a[i] == first->certificate.a[i] && result.certificate.b[i] == first->certificate.b[i]);
    }
  }
}

static void check_question(const question *q) {
  static gjk_scene_hit expected[HITS], hits[HITS], few[3];
  gjk_cast_result first;
  uint32_t count, rest;
  bool open;
  const uint32_t wanted = search(q, expected, &first, &open);
  CHECK(ask(q, NULL, hits, HITS, &count) == GJK_OK);
  if (open) {  // what the ceiling left open counts as met
    CHECK(count >= wanted);
    open_queries++;
    return;
  }
  CHECK_MSG(count == wanted, "kind %d: %u found, %u expected", (int)q->kind, count, wanted);
  CHECK(same_hits(hits, expected, wanted < count ? wanted : count));
  for (uint32_t at = 0; at < wanted; at += 3) {
    const uint32_t here = wanted - at < 3 ? wanted - at : 3;
    CHECK(ask(q, at == 0 ? NULL : &expected[at - 1], few, 3, &rest) == GJK_OK);
    CHECK(rest == wanted - at);
    CHECK(same_hits(few, &expected[at], here));
  }
  CHECK(ask(q, NULL, NULL, 0, &rest) == GJK_OK && rest == wanted);
  if (q->kind != WITHIN) {
    check_nearest(q, expected, wanted, &first);
  }
  *(q->kind == RAY ? &found_by_rays : q->kind == CAST ? &found_by_casts : &found_within) += wanted;
}

static gjk_vec3 random_vector(random_state *random, int32_t size) {
  gjk_vec3 v = {random_range(random, -size, size), random_range(random, -size, size)
#ifndef WORLD_OF_PLANE
                                                       ,
                random_range(random, -size, size)
#endif
  };
  return v;
}

// Ways of any length, some that stand still, along an axis, from the middle of a part, or to it.
static question random_question(random_state *random) {
  question q = {0};
  const int32_t reach = w.options.reach * 2;
  const uint32_t how = random_below(random, 6);
  const world_body *b = &w.bodies[random_below(random, w.options.bodies)];
  q.kind = (kind)random_below(random, KINDS);
  q.from = random_vector(random, reach);
  q.to = random_vector(random, how == 0 ? INT32_MAX / 2 : reach);
  if (how == 1) {
    q.to = q.from;
  } else if (how == 2) {
    q.to = q.from;
    q.to.y = random_range(random, -reach, reach);
  } else if (how >= 4 && b->id.generation != 0) {
    *(how == 4 ? &q.from : &q.to) = b->colliders[0].centre;
  }
  const gjk_vec3 turn = random_vector(random, 2000);
  gjk_pose pose = GJK_POSE_IDENTITY;
  memcpy(&pose.rotation, &turn, sizeof turn < sizeof pose.rotation ? sizeof turn : sizeof pose.rotation);
  pose.rotation = random_below(random, 2) == 0 || gjk_quat_normalize(&pose.rotation, &pose.rotation) != GJK_OK
                      ? (gjk_pose)GJK_POSE_IDENTITY.rotation
                      : pose.rotation;
  pose.position = q.from;
  CHECK(gjk_collider_init(&q.collider, world_shapes[random_below(random, WORLD_SHAPES)], NULL, 0) == GJK_OK);
  CHECK(gjk_collider_pose(&q.collider, &pose) == GJK_OK);
  q.margin = random_below(random, 2) == 0 ? 0 : random_range(random, 0, GJK_Q16(0.5));
  if (q.kind == WITHIN && how < 2) {  // some of the world, nearly all of it, and all of what there may be
    q.margin = how == 0 ? random_range(random, 0, 2 * reach) : INT32_MAX - random_range(random, 0, 1) * 3 * reach;
  }
  q.filters = random_below(random, 3) == 0;
  static uint32_t salt;
  salt = random_u32(random);
  q.filter.category = random_below(random, 2) == 0 ? UINT32_MAX : random_below(random, 16);
  q.filter.mask = random_below(random, 2) == 0 ? UINT32_MAX : random_below(random, 16);
  q.filter.ignore = b->id;
  q.filter.accept = random_below(random, 2) == 0 ? accept : NULL;
  q.filter.user = &salt;
  return q;
}

static void check_world(random_state *random, void *block, size_t bytes, const world_options *options) {
  static gjk_report reports[WORLD_REPORTS];
  gjk_progress progress;
  if (!world_start(&w, options, block, bytes)) {
    CHECK(false);
    return;
  }
  for (unsigned i = 0; i < 300; i++) {
    CHECK(world_change(&w, random));
    if (i % 60 == 59) {
      CHECK(gjk_scene_update(&w.scene, reports, WORLD_REPORTS, &progress) == GJK_OK);
    }
  }
  for (unsigned i = 0; i < QUERIES; i++) {
    const question q = random_question(random);
    check_question(&q);
    CHECK(world_change(&w, random));
  }
}

static gjk_vec3 along_axis(int axis, int32_t length) {
  gjk_vec3 v = {0};
  switch (axis) {
    case 0: v.x = length; break;
    case 1: v.y = length; break;
#ifndef WORLD_OF_PLANE
    default: v.z = length; break;
#endif
  }
  return v;
}

// What each call refuses, with outputs untouched.
static void check_statuses(void) {
  const gjk_vec3 from = w.bodies[0].setup.pose.position;
  gjk_vec3 far = from;
  gjk_collider c, unposed = {0};
  gjk_pose pose = GJK_POSE_IDENTITY;
  gjk_scene_hit hit = {{7, 7}, 7, 7, 7};
  gjk_cast_result result;
  bool found = true;
  uint32_t count = 7;
  gjk_collider_init(&c, world_shapes[8], NULL, 0);  // whose centre is not its origin
  CHECK(gjk_collider_pose(&c, &pose) == GJK_OK);
  const gjk_scene *s = &w.scene;
  CHECK(gjk_scene_cast_ray(NULL, &from, &far, NULL, &hit, &result, &found) == GJK_ERROR_NULL);
  CHECK(gjk_scene_cast_ray(s, NULL, &far, NULL, &hit, &result, &found) == GJK_ERROR_NULL);
  CHECK(gjk_scene_cast_ray(s, &from, NULL, NULL, &hit, &result, &found) == GJK_ERROR_NULL);
  CHECK(gjk_scene_cast_ray(s, &from, &far, NULL, NULL, &result, &found) == GJK_ERROR_NULL);
  CHECK(gjk_scene_cast_ray(s, &from, &far, NULL, &hit, NULL, &found) == GJK_ERROR_NULL);
  CHECK(gjk_scene_cast_ray(s, &from, &far, NULL, &hit, &result, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_scene_cast_ray_all(s, NULL, &far, NULL, NULL, &hit, 1, &count) == GJK_ERROR_NULL);
  CHECK(gjk_scene_cast_ray_all(s, &from, NULL, NULL, NULL, &hit, 1, &count) == GJK_ERROR_NULL);
  CHECK(gjk_scene_cast_ray_all(s, &from, &far, NULL, NULL, NULL, 1, &count) == GJK_ERROR_NULL);
  CHECK(gjk_scene_cast_ray_all(s, &from, &far, NULL, NULL, &hit, 1, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_scene_cast(s, NULL, &far, 0, NULL, &hit, &result, &found) == GJK_ERROR_NULL);
  CHECK(gjk_scene_cast(s, &c, NULL, 0, NULL, &hit, &result, &found) == GJK_ERROR_NULL);
  CHECK(gjk_scene_cast(s, &unposed, &from, 0, NULL, &hit, &result, &found) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk_scene_cast(s, &c, &from, -1, NULL, &hit, &result, &found) == GJK_ERROR_NEGATIVE);
  CHECK(gjk_scene_cast_all(s, &c, &from, -1, NULL, NULL, &hit, 1, &count) == GJK_ERROR_NEGATIVE);
  CHECK(gjk_scene_cast_all(s, &unposed, &from, 0, NULL, NULL, &hit, 1, &count) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk_scene_query_within(s, &c, -1, NULL, NULL, &hit, 1, &count) == GJK_ERROR_NEGATIVE);
  CHECK(gjk_scene_query_within(s, &unposed, 0, NULL, NULL, &hit, 1, &count) == GJK_ERROR_UNINITIALISED);
  CHECK(gjk_scene_query_within(s, NULL, 0, NULL, NULL, &hit, 1, &count) == GJK_ERROR_NULL);
  CHECK(gjk_scene_query_within(NULL, &c, 0, NULL, NULL, &hit, 1, &count) == GJK_ERROR_NULL);
  CHECK(gjk_scene_query_within(s, &c, 0, NULL, NULL, NULL, 1, &count) == GJK_ERROR_NULL);
  CHECK(gjk_scene_query_within(s, &c, 0, NULL, NULL, &hit, 1, NULL) == GJK_ERROR_NULL);
  CHECK(gjk_scene_query_within(s, &c, INT32_MIN, NULL, NULL, &hit, 1, &count) == GJK_ERROR_NEGATIVE);
  for (int axis = 0; axis < AXES; axis++) {  // a centre that lies ahead of its position would leave int32
    const gjk_vec3 ahead = along_axis(axis, 999), corners[3] = {ahead, ahead, ahead};
    const gjk_shape triangle = TRIANGLE(corners);
    CHECK(gjk_collider_init(&c, &triangle, NULL, 0) == GJK_OK && gjk_collider_pose(&c, &pose) == GJK_OK);
    far = along_axis(axis, INT32_MAX);
    CHECK(gjk_scene_cast(s, &c, &far, 0, NULL, &hit, &result, &found) == GJK_ERROR_RANGE);
    CHECK(gjk_scene_cast_all(s, &c, &far, 0, NULL, NULL, &hit, 1, &count) == GJK_ERROR_RANGE);
  }
  CHECK(found && count == 7 && hit.part == 7);
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  for (unsigned i = 0; i < WORLDS; i++) {
    check_trial(i, NULL, NULL);
    const world_options options = {.bodies = 4 + random_below(&random, WORLD_BODIES - 3),
                                   .reach = random_below(&random, 4) == 0 ? GJK_Q16(100) : GJK_Q16(2.5),
                                   .box_margin = random_below(&random, 2) == 0 ? 0 : GJK_Q16(0.5),
                                   .margins = random_below(&random, 2) == 0};
    const gjk_scene_config config = world_config(&options);
    const size_t bytes = gjk_scene_bytes(&config);
    void *block = malloc(bytes);
    check_world(&random, block, bytes, &options);
    if (i == 0) {
      check_statuses();
    }
    free(block);
  }
  printf("rays %lu, casts %lu, within %lu; missed %lu, filtered %lu, open %lu\n", found_by_rays, found_by_casts,
         found_within, missed, filtered, open_queries);
  CHECK((missed > 1000 && filtered > 100) || !check_is_full());
  CHECK((found_by_rays > 100 && found_by_casts > 100 && found_within > 50) || world_is_tight() || !check_is_full());
  CHECK(open_queries == 0 || world_is_tight());
  return check_done(TEST_NAME);
}
