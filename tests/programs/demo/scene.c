// Reads a scene and answers its cases.
#include "scene.h"

#include <string.h>

#include "case/parse.h"

// Cells enough for depths of bodies of up to 64 vertices, also curved ones.
#define VERTICES 1024
#define CELLS (GJK_EPA_CELLS(VERTICES) + VERTICES)

// The error that a depth of curved bodies may have, LSB.
#define CURVED_TOUCH 3

static bool same_vec3(gjk_vec3 a, gjk_vec3 b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

static bool same_shape(const case_shape *a, const case_shape *b) {
  const gjk_quat *p = &a->pose.rotation, *q = &b->pose.rotation;
  if (a->kind != b->kind || !same_vec3(a->size, b->size) || a->convex_radius != b->convex_radius ||
      a->count != b->count || !same_vec3(a->pose.position, b->pose.position) || p->x != q->x || p->y != q->y ||
      p->z != q->z || p->w != q->w) {
    return false;
  }
  for (size_t i = 0; i < a->count; i++) {
    if (!same_vec3(a->vertices[i], b->vertices[i])) {
      return false;
    }
  }
  return true;
}

// The body of a shape, made if it is new; SCENE_BODIES_MAX if there is no room.
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

gjk_unit3 scene_direction(const scene_body *a, const scene_body *b) {
  static gjk_epa_cell cells[CELLS];
  static const gjk_workspace workspace = {cells, CELLS};
  static const gjk_unit3 none = {0, 0, 0};
  gjk_distance_result r;
  const gjk_status status = gjk_signed_distance(&a->collider.collider, &b->collider.collider, NULL, &workspace, &r);
  return status == GJK_OK || status == GJK_ERROR_CAPACITY ? r.normal : none;
}

static void relate(scene *s, scene_pair *pair) {
  const bool curved = pair->verdict != CERTIFY_PROVEN;
  if (!pair->answer.intersecting) {
    pair->relation = SCENE_APART;
    pair->mark_a = pair->answer.point_a;
    pair->mark_b = pair->answer.point_b;
    return;
  }
  pair->relation = pair->overlap.depth <= (curved ? CURVED_TOUCH : 0) ? SCENE_TOUCHING : SCENE_OVERLAPPING;
  pair->mark_a = pair->overlap.point_a;
  pair->mark_b = pair->overlap.point_b;
  if (pair->relation == SCENE_OVERLAPPING) {
    s->body[pair->a].overlapping = s->body[pair->b].overlapping = true;
  }
}

// Answers a question about the pair and adds the verdict on the answer. False, with a message, if it is refused.
static bool ask(case_ask about, const case_pair *source, case_collider *a, case_collider *b, case_answer *answer,
                certify_verdict *verdict) {
  const case_question question = {.ask = about, .contacts = about == CASE_PENETRATION};
  char why[CERTIFY_WHY_MAX];
  case_answer_find(&question, source, a, b, answer);
  if (answer->status != GJK_OK) {
    case_answer_print(stderr, &question, source, answer);
    fputc('\n', stderr);
    return false;
  }
  const certify_verdict found = certify_answer(&question, source, a, b, answer, why);
  *verdict = found > *verdict ? found : *verdict;
  return true;
}

static bool add_pair(scene *s, const case_pair *source, case_collider *a, case_collider *b) {
  certify_verdict verdict = CERTIFY_PROVEN;
  case_answer answer, deep = {0};
  if (!ask(CASE_DISTANCE, source, a, b, &answer, &verdict) ||
      (answer.distance.intersecting && !ask(CASE_PENETRATION, source, a, b, &deep, &verdict))) {
    return false;
  }
  const char *colon = strchr(source->id, ':');
  size_t length = colon == NULL ? strlen(source->id) : (size_t)(colon - source->id);
  const char *second = colon == NULL ? source->id : colon + 1;
  size_t body_a = find_body(s, &source->a, source->id, length);
  size_t body_b = find_body(s, &source->b, second, strlen(second));
  if (s->pairs == SCENE_PAIRS_MAX || body_a == SCENE_BODIES_MAX || body_b == SCENE_BODIES_MAX) {
    fprintf(stderr, "%s: a scene holds at most %d pairs of %d bodies\n", source->id, SCENE_PAIRS_MAX, SCENE_BODIES_MAX);
    return false;
  }
  scene_pair *pair = &s->pair[s->pairs++];
  pair->a = body_a;
  pair->b = body_b;
  pair->answer = answer.distance;
  pair->overlap = deep.penetration;
  pair->manifold = deep.manifold;
  pair->verdict = verdict;
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
