// Answers a case and prints the answer.
#include "answer.h"

#include <math.h>
#include <string.h>

#include "reference/reference.h"

// Cells enough for pairs of so many vertices, also of curved shapes.
#define VERTICES 4096
#define CELLS (GJK_EPA_CELLS(VERTICES) + VERTICES)

static gjk_q16 round_to_q16(double value) {
  return value >= 2147483647.0 ? INT32_MAX : value <= -2147483648.0 ? INT32_MIN : (gjk_q16)lround(value);
}

static gjk_vec3 round_vec3(const double v[3]) {
  gjk_vec3 out = {round_to_q16(v[0]), round_to_q16(v[1]), round_to_q16(v[2])};
  return out;
}

static gjk_unit3 round_unit(const double v[3]) {
  const double unit = (double)GJK_Q30_ONE;
  const gjk_unit3 out = {round_to_q16(v[0] * unit), round_to_q16(v[1] * unit), round_to_q16(v[2] * unit)};
  return out;
}

static void report_penetration(const reference_result *found, gjk_penetration_result *out) {
  out->intersecting = found->intersecting;
  out->iterations = (uint16_t)found->iterations;
  if (found->intersecting) {
    out->depth = out->lower = out->upper = round_to_q16(ceil(-found->distance));
    out->point_a = round_vec3(found->a);
    out->point_b = round_vec3(found->b);
    out->normal = round_unit(found->normal);
  }
}

// Asks the reference about the posed integers, so that only its arithmetic differs from the library.
static void answer_by_reference(const case_question *question, const case_pair *pair, const case_collider *a,
                                const case_collider *b, case_answer *answer) {
  reference_result found;
  const bool deep = question->ask == CASE_PENETRATION;
  if (deep) {
    reference_signed_posed(pair, a, b, &found);
    report_penetration(&found, &answer->penetration);
  } else {
    reference_query_posed(pair, a, b, &found);
  }
  uint8_t iterations = (uint8_t)(found.iterations > 255 ? 255 : found.iterations);
  answer->status = GJK_OK;
  if (question->ask != CASE_DISTANCE && !deep) {
    double limit = question->ask == CASE_WITHIN ? (double)question->within : 0.0;
    answer->decision.yes = found.intersecting || found.distance <= limit;
    answer->decision.iterations = iterations;
    return;
  }
  gjk_distance_result *out = &answer->distance;
  out->intersecting = found.intersecting;
  out->iterations = iterations;
  if (!found.intersecting) {
    out->distance = out->lower = out->upper = round_to_q16(found.distance);
    out->point_a = round_vec3(found.a);
    out->point_b = round_vec3(found.b);
    out->normal = round_unit(found.normal);
    out->saturated = found.distance >= 2147483647.5;
  }
}

// Asks for the depth if the shapes overlap, else for the distance; and for the contacts on demand.
static gjk_status find_penetration(const case_question *question, const gjk_collider *a, const gjk_collider *b,
                                   case_answer *answer) {
  static gjk_epa_cell cells[CELLS];
  static const gjk_workspace workspace = {cells, CELLS};
  if (question->contacts) {
    gjk_contacts(a, b, question->margin, GJK_CONTACTS_MAX, NULL, &workspace, &answer->manifold);
  }
  const gjk_status status = gjk_penetration(a, b, NULL, &workspace, &answer->penetration);
  answer->distance.intersecting = answer->penetration.intersecting;
  return status != GJK_OK || answer->penetration.intersecting ? status : gjk_distance(a, b, NULL, &answer->distance);
}

void case_answer_find(const case_question *question, const case_pair *pair, case_collider *a, case_collider *b,
                      case_answer *answer) {
  memset(answer, 0, sizeof *answer);
  answer->refused = 'A';
  answer->status = case_collider_build(a, &pair->a, false);
  if (answer->status == GJK_OK) {
    answer->refused = 'B';
    answer->status = case_collider_build(b, &pair->b, false);
  }
  if (answer->status != GJK_OK) {
    return;
  }
  answer->refused = 0;
  if (question->reference) {
    answer_by_reference(question, pair, a, b, answer);
  } else if (question->ask == CASE_DISTANCE) {
    answer->status = gjk_distance(&a->collider, &b->collider, NULL, &answer->distance);
  } else if (question->ask == CASE_PENETRATION) {
    answer->status = find_penetration(question, &a->collider, &b->collider, answer);
  } else if (question->ask == CASE_INTERSECT) {
    answer->status = gjk_intersect(&a->collider, &b->collider, NULL, &answer->decision);
  } else if (question->iterations == 0) {
    answer->status = gjk_within(&a->collider, &b->collider, question->within, NULL, &answer->decision);
  } else {
    gjk_within_result found = {0};
    answer->status = gjk_within_until(&a->collider, &b->collider, question->within, question->iterations, NULL, &found);
    answer->open = found.answer == GJK_ANSWER_OPEN;
    answer->decision = found.decision;
  }
}

const char *case_status_detail(gjk_status status) {
  switch (status) {
    case GJK_ERROR_SIZE: return "larger than 4095 units about the centre of its bounding box";
    case GJK_ERROR_NEGATIVE: return "a negative radius or half extent";
    case GJK_ERROR_EMPTY: return "no vertices, or no extent";
    case GJK_ERROR_ROTATION: return "not a unit quaternion; raw numbers are Q2.30: 1073741824 is 1.0";
    case GJK_ERROR_RANGE: return "its centre is not within -32768.0 to 32768.0";
    case GJK_ERROR_ITERATION_LIMIT: return "not settled within the ceiling on iterations";
    case GJK_ERROR_CAPACITY:
      return "the EPA hull takes more than 4096 vertices, or of a curved pair EPA more than 1000 iterations";
    default: return "refused";
  }
}

static void print_error(FILE *file, const case_pair *pair, const case_answer *answer) {
  fprintf(file, "%s error %s ", pair->id, gjk_status_name(answer->status));
  if (answer->refused != 0) {
    fprintf(file, "%c: ", answer->refused);
  }
  fprintf(file, "%s", case_status_detail(answer->status));
}

void case_answer_print(FILE *file, const case_question *question, const case_pair *pair, const case_answer *answer) {
  const gjk_distance_result *d = &answer->distance;
  const gjk_penetration_result *p = &answer->penetration;
  if (answer->status != GJK_OK) {
    print_error(file, pair, answer);
  } else if (question->ask == CASE_PENETRATION && p->intersecting) {
    fprintf(file, "%s intersecting depth=%ld a=%ld,%ld,%ld b=%ld,%ld,%ld normal=%ld,%ld,%ld iterations=%u", pair->id,
            (long)p->depth, (long)p->point_a.x, (long)p->point_a.y, (long)p->point_a.z, (long)p->point_b.x,
            (long)p->point_b.y, (long)p->point_b.z, (long)p->normal.x, (long)p->normal.y, (long)p->normal.z,
            p->iterations);
  } else if (question->ask == CASE_INTERSECT || question->ask == CASE_WITHIN) {
    const char *yes = question->ask == CASE_WITHIN ? "within" : "intersecting";
    const char *no = answer->open ? "open" : question->ask == CASE_WITHIN ? "beyond" : "separated";
    fprintf(file, "%s %s iterations=%u", pair->id, answer->decision.yes ? yes : no, answer->decision.iterations);
  } else if (d->intersecting) {
    fprintf(file, "%s intersecting iterations=%u", pair->id, d->iterations);
  } else {
    fprintf(file, "%s separated distance=%ld a=%ld,%ld,%ld b=%ld,%ld,%ld normal=%ld,%ld,%ld iterations=%u%s", pair->id,
            (long)d->distance, (long)d->point_a.x, (long)d->point_a.y, (long)d->point_a.z, (long)d->point_b.x,
            (long)d->point_b.y, (long)d->point_b.z, (long)d->normal.x, (long)d->normal.y, (long)d->normal.z,
            d->iterations, d->saturated ? " saturated" : "");
  }
}

void case_contacts_print(FILE *file, const case_answer *answer) {
  for (unsigned i = 0; i < answer->manifold.count; i++) {
    const gjk_contact *c = &answer->manifold.contact[i];
    fprintf(file, "  contact a=%ld,%ld,%ld b=%ld,%ld,%ld distance=%ld id=%u\n", (long)c->point_a.x, (long)c->point_a.y,
            (long)c->point_a.z, (long)c->point_b.x, (long)c->point_b.y, (long)c->point_b.z, (long)c->distance, c->id);
  }
}
