// Answers a case of the plane and prints the answer.
#include "answer2.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reference/reference2.h"

static gjk_q16 round_to_q16(double value) {
  return value >= 2147483647.0 ? INT32_MAX : value <= -2147483648.0 ? INT32_MIN : (gjk_q16)lround(value);
}

static gjk2_vec round_vec(const double v[2]) {
  const gjk2_vec out = {round_to_q16(v[0]), round_to_q16(v[1])};
  return out;
}

static gjk2_unit round_unit(const double v[2]) {
  const double one = (double)GJK_Q30_ONE;
  const gjk2_unit out = {round_to_q16(v[0] * one), round_to_q16(v[1] * one)};
  return out;
}

// A shape as the library posed it, for the reference. Returns memory to free.
static void *pose_for_reference(const case2_shape *shape, const case2_collider *posed, reference2_shape *out) {
  const gjk2_collider *c = &posed->collider;
  const gjk2_vec *listed = shape->kind == CASE2_TRIANGLE ? c->frame : posed->buffer;
  const unsigned half_axes = shape->kind == CASE2_BOX ? 2 : shape->kind == CASE2_SEGMENT ? 1 : 0;
  const size_t n = shape->kind == CASE2_ELLIPSE ? 0 : shape->count > 0 ? shape->count : (size_t)1 << half_axes;
  double(*point)[2] = calloc(n > 0 ? n : 1, sizeof *point);
  memset(out, 0, sizeof *out);
  for (size_t i = 0; i < n && point != NULL; i++) {
    point[i][0] = c->centre.x + (shape->count > 0 ? (double)listed[i].x : 0);
    point[i][1] = c->centre.y + (shape->count > 0 ? (double)listed[i].y : 0);
    for (unsigned k = 0; k < half_axes; k++) {
      point[i][0] += (i >> k & 1u) != 0 ? c->frame[k].x : -c->frame[k].x;
      point[i][1] += (i >> k & 1u) != 0 ? c->frame[k].y : -c->frame[k].y;
    }
  }
  const double x = shape->pose.rotation.c, y = shape->pose.rotation.s, length = hypot(x, y);
  const double axis[2][2] = {{x / length * shape->size.x, y / length * shape->size.x},
                             {-y / length * shape->size.y, x / length * shape->size.y}};
  memcpy(out->axis, axis, sizeof axis);
  out->centre[0] = c->centre.x;
  out->centre[1] = c->centre.y;
  out->point = (const double(*)[2])point;
  out->count = n;
  out->convex_radius = shape->convex_radius;
  return point;
}

// Asks the reference about the posed integers, so that only its arithmetic
// differs from the library.
static void answer_by_reference(const case_question *question, const case2_pair *pair, const case2_collider *a,
                                const case2_collider *b, case2_answer *answer) {
  reference2_shape of_a, of_b;
  reference2_result found;
  void *memory_a = pose_for_reference(&pair->a, a, &of_a), *memory_b = pose_for_reference(&pair->b, b, &of_b);
  reference2_query(&of_a, &of_b, &found);
  free(memory_a);
  free(memory_b);
  const uint16_t iterations = (uint16_t)found.iterations;
  if (question->ask == CASE_INTERSECT || question->ask == CASE_WITHIN) {
    const double limit = question->ask == CASE_WITHIN ? (double)question->within : 0.0;
    answer->decision.yes = found.intersecting || found.distance <= limit;
    answer->decision.iterations = iterations;
    return;
  }
  gjk2_distance_result *apart = &answer->distance;
  gjk2_penetration_result *deep = &answer->penetration;
  apart->intersecting = deep->intersecting = found.intersecting;
  apart->iterations = deep->iterations = iterations;
  apart->distance = found.intersecting ? 0 : round_to_q16(found.distance);
  apart->saturated = found.distance >= 2147483647.0;
  deep->depth = found.intersecting ? round_to_q16(ceil(-found.distance)) : 0;
  apart->point_a = deep->point_a = round_vec(found.a);
  apart->point_b = deep->point_b = round_vec(found.b);
  apart->normal = deep->normal = round_unit(found.normal);
}

static gjk_status find_penetration(const case_question *question, const gjk2_collider *a, const gjk2_collider *b,
                                   case2_answer *answer) {
  if (question->contacts) {
    gjk2_contacts(a, b, question->margin, GJK2_CONTACTS_MAX, NULL, &answer->manifold);
  }
  const gjk_status status = gjk2_penetration(a, b, NULL, &answer->penetration);
  answer->distance.intersecting = answer->penetration.intersecting;
  return status != GJK_OK || answer->penetration.intersecting ? status : gjk2_distance(a, b, NULL, &answer->distance);
}

static gjk_status find_within(const case_question *question, const gjk2_collider *a, const gjk2_collider *b,
                              case2_answer *answer) {
  if (question->iterations == 0) {
    return gjk2_within(a, b, question->within, NULL, &answer->decision);
  }
  gjk2_within_result found = {0};
  const gjk_status status = gjk2_within_until(a, b, question->within, question->iterations, NULL, &found);
  answer->open = found.answer == GJK2_ANSWER_OPEN;
  answer->decision = found.decision;
  return status;
}

void case2_answer_find(const case_question *question, const case2_pair *pair, case2_collider *a, case2_collider *b,
                       case2_answer *answer) {
  memset(answer, 0, sizeof *answer);
  answer->refused = 'A';
  answer->status = case2_collider_build(a, &pair->a, false);
  if (answer->status == GJK_OK) {
    answer->refused = 'B';
    answer->status = case2_collider_build(b, &pair->b, false);
  }
  if (answer->status != GJK_OK) {
    return;
  }
  answer->refused = 0;
  if (question->reference) {
    answer_by_reference(question, pair, a, b, answer);
    return;
  }
  switch (question->ask) {
    case CASE_DISTANCE: answer->status = gjk2_distance(&a->collider, &b->collider, NULL, &answer->distance); break;
    case CASE_PENETRATION: answer->status = find_penetration(question, &a->collider, &b->collider, answer); break;
    case CASE_INTERSECT: answer->status = gjk2_intersect(&a->collider, &b->collider, NULL, &answer->decision); break;
    case CASE_WITHIN: answer->status = find_within(question, &a->collider, &b->collider, answer); break;
  }
}

static const char *detail(gjk_status status) {
  switch (status) {
    case GJK_ERROR_ROTATION: return "not a unit; raw numbers are Q2.30: 1073741824 is 1.0";
    case GJK_ERROR_CAPACITY: return "the depth of a curved pair takes more than 1000 iterations";
    default: return case_status_detail(status);
  }
}

static void print_points(FILE *file, gjk2_vec a, gjk2_vec b, gjk2_unit n) {
  fprintf(file, " a=%ld,%ld b=%ld,%ld normal=%ld,%ld", (long)a.x, (long)a.y, (long)b.x, (long)b.y, (long)n.x,
          (long)n.y);
}

void case2_answer_print(FILE *file, const case_question *question, const case2_pair *pair, const case2_answer *answer) {
  const gjk2_distance_result *d = &answer->distance;
  const gjk2_penetration_result *p = &answer->penetration;
  fprintf(file, "%s ", pair->id);
  if (answer->status != GJK_OK) {
    const char side[4] = {answer->refused, ':', ' ', '\0'};
    fprintf(file, "error %s %s%s", gjk_status_name(answer->status), answer->refused != 0 ? side : "",
            detail(answer->status));
  } else if (question->ask == CASE_PENETRATION && p->intersecting) {
    fprintf(file, "intersecting depth=%ld", (long)p->depth);
    print_points(file, p->point_a, p->point_b, p->normal);
    fprintf(file, " iterations=%u", p->iterations);
  } else if (question->ask == CASE_INTERSECT || question->ask == CASE_WITHIN) {
    const char *yes = question->ask == CASE_WITHIN ? "within" : "intersecting";
    const char *no = answer->open ? "open" : question->ask == CASE_WITHIN ? "beyond" : "separated";
    fprintf(file, "%s iterations=%u", answer->decision.yes ? yes : no, answer->decision.iterations);
  } else if (d->intersecting) {
    fprintf(file, "intersecting iterations=%u", d->iterations);
  } else {
    fprintf(file, "separated distance=%ld", (long)d->distance);
    print_points(file, d->point_a, d->point_b, d->normal);
    fprintf(file, " iterations=%u%s", d->iterations, d->saturated ? " saturated" : "");
  }
}

void case2_contacts_print(FILE *file, const case2_answer *answer) {
  for (unsigned i = 0; i < answer->manifold.count; i++) {
    const gjk2_contact *c = &answer->manifold.contact[i];
    fprintf(file, "  contact a=%ld,%ld b=%ld,%ld distance=%ld id=%u\n", (long)c->point_a.x, (long)c->point_a.y,
            (long)c->point_b.x, (long)c->point_b.y, (long)c->distance, c->id);
  }
}
