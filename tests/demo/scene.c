// Reads a scene and answers its cases.
#include "scene.h"

#include <string.h>

#include "../case/parse.h"

// A body moved by more than this is apart from any other: both radii are at most 4095 units.
#define PARTING_MAX ((gjk_q16)(16384 * 65536))

static bool same_vec3(gjk_vec3 a, gjk_vec3 b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

static bool same_shape(const case_shape *a, const case_shape *b) {
  const gjk_quat *p = &a->pose.rotation, *q = &b->pose.rotation;
  if (a->kind != b->kind || !same_vec3(a->size, b->size) || a->round != b->round || a->count != b->count ||
      !same_vec3(a->pose.position, b->pose.position) || p->x != q->x || p->y != q->y || p->z != q->z ||
      p->w != q->w) {
    return false;
  }
  for (size_t i = 0; i < a->count; i++) {
    if (!same_vec3(a->vertices[i], b->vertices[i])) {
      return false;
    }
  }
  return true;
}

// The body of a shape, made when it is new; SCENE_BODIES_MAX when there is no room.
static size_t find_body(scene *s, const case_shape *shape, const char *name, size_t length) {
  size_t i = 0;
  while (i < s->bodies && !same_shape(&s->body[i].shape, shape)) {
    i++;
  }
  if (i == s->bodies && i < SCENE_BODIES_MAX) {
    scene_body *body = &s->body[s->bodies++];
    memcpy(body->name, name, length);
    case_shape_copy(&body->shape, shape);
    case_collider_build(&body->collider, &body->shape, false);
  }
  return i;
}

static bool try_move(const scene_body *a, const scene_body *b, int axis, gjk_q16 step,
                     gjk_distance_result *out) {
  gjk_collider moved = b->collider.collider;
  gjk_vec3 to = moved.position;
  gjk_q16 *coordinate = axis == 0 ? &to.x : axis == 1 ? &to.y : &to.z;
  int64_t target = (int64_t)*coordinate + step;
  if (target < INT32_MIN || target > INT32_MAX) {
    return false;
  }
  *coordinate = (gjk_q16)target;
  return gjk_collider_move(&moved, &to) == GJK_OK &&
         gjk_distance(&a->collider.collider, &moved, NULL, out) == GJK_OK && !out->intersecting;
}

gjk_q16 scene_part(const scene_body *a, const scene_body *b, gjk_distance_result *out) {
  if (gjk_distance(&a->collider.collider, &b->collider.collider, NULL, out) == GJK_OK && !out->intersecting) {
    return 0;
  }
  for (gjk_q16 step = 1; step < PARTING_MAX; step += (step + 3) / 4) {
    for (int axis = 2; axis >= 0; axis--) {
      if (try_move(a, b, axis, step, out) || try_move(a, b, axis, -step, out)) {
        return step;
      }
    }
  }
  return PARTING_MAX;
}

static void relate(scene *s, scene_pair *pair) {
  scene_body *a = &s->body[pair->a], *b = &s->body[pair->b];
  gjk_distance_result parted = pair->answer;
  pair->relation = SCENE_APART;
  if (pair->answer.intersecting) {
    pair->relation = scene_part(a, b, &parted) == 1 ? SCENE_TOUCHING : SCENE_OVERLAPPING;
  }
  pair->mark_a = parted.point_a;
  pair->mark_b = parted.point_b;
  if (pair->relation == SCENE_OVERLAPPING) {
    a->overlapping = b->overlapping = true;
  }
}

static bool add_pair(scene *s, const case_pair *source, case_collider *a, case_collider *b) {
  const case_question question = {CASE_DISTANCE, 0, false};
  char why[CERTIFY_WHY_MAX];
  case_answer answer;
  case_answer_find(&question, source, a, b, &answer);
  if (answer.status != GJK_OK) {
    case_answer_print(stderr, &question, source, &answer);
    fputc('\n', stderr);
    return false;
  }
  const char *colon = strchr(source->id, ':');
  size_t length = colon == NULL ? strlen(source->id) : (size_t)(colon - source->id);
  const char *second = colon == NULL ? source->id : colon + 1;
  size_t body_a = find_body(s, &source->a, source->id, length);
  size_t body_b = find_body(s, &source->b, second, strlen(second));
  if (s->pairs == SCENE_PAIRS_MAX || body_a == SCENE_BODIES_MAX || body_b == SCENE_BODIES_MAX) {
    fprintf(stderr, "%s: a scene holds at most %d pairs of %d bodies\n", source->id, SCENE_PAIRS_MAX,
            SCENE_BODIES_MAX);
    return false;
  }
  scene_pair *pair = &s->pair[s->pairs++];
  pair->a = body_a;
  pair->b = body_b;
  pair->answer = answer.distance;
  pair->verdict = certify_answer(&question, source, a, b, &answer, why);
  relate(s, pair);
  return true;
}

bool scene_read(scene *s, FILE *file, const char *name) {
  case_reader reader;
  case_pair pair = {0};
  case_collider a = {0}, b = {0};
  bool good = true;
  case_reader_open(&reader, file, name);
  while (case_reader_next(&reader, &pair)) {
    good = add_pair(s, &pair, &a, &b) && good;
  }
  case_pair_free(&pair);
  case_collider_free(&a);
  case_collider_free(&b);
  return good && reader.errors == 0;
}

const char *scene_relation_name(scene_relation relation) {
  return relation == SCENE_APART ? "apart" : relation == SCENE_TOUCHING ? "touching" : "overlapping";
}

const char *scene_verdict_name(certify_verdict verdict) {
  return verdict == CERTIFY_PROVEN ? "proven" : verdict == CERTIFY_WRONG ? "WRONG" : "curved";
}

void scene_free(scene *s) {
  for (size_t i = 0; i < s->bodies; i++) {
    case_shape_free(&s->body[i].shape);
    case_collider_free(&s->body[i].collider);
  }
}
