// Prints certificates and posed vertices.
#include "proof.h"

#include "gjk/check.h"
#include "gjk2/check.h"
#include "src/plane/gjk2_class.h"
#include "src/shape/gjk_shape_class.h"

static const char *const names[] = {
    [GJK_PROOF_NONE] = "none",       [GJK_PROOF_SPHERES] = "spheres", [GJK_PROOF_DIRECTION] = "direction",
    [GJK_PROOF_NEAREST] = "nearest", [GJK_PROOF_NEAR] = "near",       [GJK_PROOF_ENCLOSING] = "enclosing",
    [GJK_PROOF_FACET] = "facet",     [GJK_PROOF_PLANE] = "plane"};
static const char *const names2[] = {
    [GJK2_PROOF_NONE] = "none",       [GJK2_PROOF_CIRCLES] = "circles", [GJK2_PROOF_DIRECTION] = "direction",
    [GJK2_PROOF_NEAREST] = "nearest", [GJK2_PROOF_NEAR] = "near",       [GJK2_PROOF_ENCLOSING] = "enclosing",
    [GJK2_PROOF_EDGE] = "edge",       [GJK2_PROOF_LINE] = "line"};

static void print_pairs(FILE *file, const uint16_t *of_a, const uint16_t *of_b, unsigned count) {
  for (unsigned i = 0; i < count; i++) {
    fprintf(file, "%sA%u-B%u", i == 0 ? " pairs=" : ",", of_a[i], of_b[i]);
  }
}

static void print_verdict(FILE *file, gjk_status status) {
  fprintf(file, status == GJK_OK ? " proven\n" : " unproven\n");
}

void proof_space(FILE *file, const case_question *question, const case_answer *answer, const gjk_collider *a,
                 const gjk_collider *b) {
  const bool decides = question->ask == CASE_INTERSECT || question->ask == CASE_WITHIN;
  const bool deep = question->ask == CASE_PENETRATION && answer->penetration.intersecting;
  const gjk_certificate *c = decides ? &answer->decision.certificate
                             : deep  ? &answer->penetration.certificate
                                     : &answer->distance.certificate;
  if (answer->status != GJK_OK) {
    return;
  }
  fprintf(file, "  proof %s", names[c->proof]);
  print_pairs(file, c->a, c->b, c->count);
  if (c->proof == GJK_PROOF_DIRECTION || c->proof == GJK_PROOF_PLANE) {
    fprintf(file, " direction=%ld,%ld,%ld", (long)c->direction.x, (long)c->direction.y, (long)c->direction.z);
  }
  print_verdict(
      file, decides ? gjk_check_decision(a, b, question->ask == CASE_WITHIN ? question->within : 0, &answer->decision)
            : deep  ? gjk_check_penetration(a, b, &answer->penetration)
                    : gjk_check_distance(a, b, &answer->distance));
}

void proof_plane(FILE *file, const case_question *question, const case2_answer *answer, const gjk2_collider *a,
                 const gjk2_collider *b) {
  const bool decides = question->ask == CASE_INTERSECT || question->ask == CASE_WITHIN;
  const bool deep = question->ask == CASE_PENETRATION && answer->penetration.intersecting;
  const gjk2_certificate *c = decides ? &answer->decision.certificate
                              : deep  ? &answer->penetration.certificate
                                      : &answer->distance.certificate;
  if (answer->status != GJK_OK) {
    return;
  }
  fprintf(file, "  proof %s", names2[c->proof]);
  print_pairs(file, c->a, c->b, c->count);
  if (c->proof == GJK2_PROOF_DIRECTION || c->proof == GJK2_PROOF_LINE) {
    fprintf(file, " direction=%ld,%ld", (long)c->direction.x, (long)c->direction.y);
  }
  print_verdict(
      file, decides ? gjk2_check_decision(a, b, question->ask == CASE_WITHIN ? question->within : 0, &answer->decision)
            : deep  ? gjk2_check_penetration(a, b, &answer->penetration)
                    : gjk2_check_distance(a, b, &answer->distance));
}

// Boxes, segments and points count their half axes.
void proof_posed(FILE *file, char name, const gjk_collider *c) {
  const gjk_shape *shape = c->shape;
  const unsigned listed = shape->vertices != NULL ? c->count : 1u << c->count;
  const unsigned count = shape->type->vertex == NULL ? 0 : listed;
  gjk_vec3 v = {0, 0, 0};
  fprintf(file, "  posed %c", name);
  for (unsigned i = 0; i < (count > 0 ? count : 1); i++) {
    if (count == 0 || shape->type->vertex(c, (uint16_t)i, &v)) {
      fprintf(file, " %ld,%ld,%ld", (long)c->centre.x + v.x, (long)c->centre.y + v.y, (long)c->centre.z + v.z);
    }
  }
  fputc('\n', file);
}

void proof_posed2(FILE *file, char name, const gjk2_collider *c) {
  const gjk2_shape *shape = c->shape;
  const unsigned count = shape->type->vertex == NULL ? 0 : c->count;
  gjk2_vec v = {0, 0};
  fprintf(file, "  posed %c", name);
  for (unsigned i = 0; i < (count > 0 ? count : 1); i++) {
    if (count == 0 || shape->type->vertex(c, (uint16_t)i, &v)) {
      fprintf(file, " %ld,%ld", (long)c->centre.x + v.x, (long)c->centre.y + v.y);
    }
  }
  fputc('\n', file);
}
