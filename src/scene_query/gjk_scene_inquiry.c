// A cast or ray against the shapes of a scene.
#include "gjk_scene_inquiry.h"

#include "../scene/gjk_scene_part.h"
#include "gjk_scene_filter.h"

// Asks the next part that the way may meet. False: there is none left. A cast without an answer counts as a hit where the
// boxes meet, which no cast hits before.
static bool ask_next(const gjk_scene_view *v, const gjk_scene_inquiry *inquiry, gjk_scene_passage *passage,
                     uint32_t *part, gjk_status *status, gjk_cast_result *result) {
  uint32_t entered;
  gjk_collider c;
  gjk_aabb box;
  *part = gjk_scene_passage_next(v, passage, &entered);
  if (*part == GJK_SCENE_NONE) {
    return false;
  }
  result->hit = false;
  *status = GJK_OK;
  if (gjk_scene_accepts(v, inquiry->filter, *part)) {
    gjk_scene_part_now(v, &v->parts[*part], &c, &box);
    *status = inquiry->ask(inquiry, v, &v->parts[*part], &c, result);
    if (*status != GJK_OK) {
      result->hit = true;
      result->fraction = (gjk_q30)entered;
    }
  }
  return true;
}

// Copies a result by parts, which needs no memcpy.
static void copy_result(const gjk_cast_result *from, gjk_cast_result *to) {
  to->hit = from->hit;
  to->inside = from->inside;
  to->fraction = from->fraction;
  to->point_a = from->point_a;
  to->point_b = from->point_b;
  to->normal = from->normal;
  to->rest_a = from->rest_a;
  to->rest_b = from->rest_b;
  to->saturated = from->saturated;
  to->iterations = from->iterations;
  to->certificate.direction = from->certificate.direction;
  for (int i = 0; i < 3; i++) {
    to->certificate.a[i] = from->certificate.a[i];
    to->certificate.b[i] = from->certificate.b[i];
  }
  to->certificate.count = from->certificate.count;
  to->certificate.proof = from->certificate.proof;
}

gjk_status gjk_scene_find_first(const gjk_scene_view *v, const gjk_scene_inquiry *inquiry, gjk_scene_passage *passage,
                                gjk_scene_hit *hit, gjk_cast_result *result, bool *found) {
  gjk_status status, of_hit = GJK_OK;
  gjk_cast_result trial;
  gjk_scene_hit first;
  uint32_t part;
  *found = false;
  while (ask_next(v, inquiry, passage, &part, &status, &trial)) {  // ends: each part comes once
    if (!trial.hit) {
      continue;
    }
    const gjk_scene_hit here = gjk_scene_hit_of(v, &v->parts[part], (uint32_t)trial.fraction);
    if (!*found || gjk_scene_comes_before(&here, &first)) {
      *found = true;
      first = here;
      of_hit = status;
      passage->latest = here.fraction;
      if (status == GJK_OK) {
        copy_result(&trial, result);
      }
    }
  }
  if (*found) {
    *hit = first;
  }
  return of_hit;
}

void gjk_scene_find_all(const gjk_scene_view *v, const gjk_scene_inquiry *inquiry, gjk_scene_passage *passage,
                        gjk_scene_hits *hits) {
  gjk_status status;
  gjk_cast_result trial;
  uint32_t part;
  while (ask_next(v, inquiry, passage, &part, &status, &trial)) {  // ends: each part comes once
    if (trial.hit) {
      gjk_scene_collect(hits, v, part, (uint32_t)trial.fraction);
    }
  }
}
