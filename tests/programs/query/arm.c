// Answers the edges of a machine.
#include "arm.h"

#include <stdlib.h>

#include "arm_file.h"
#include "case/certify.h"

#define ARM_PAIRS GJK_ARM_PAIRS(ARM_PARTS, ARM_OBSTACLES)

// A machine in memory.
typedef struct arm_machine {
  arm_file file;
  gjk_arm arm;
  gjk_arm_model model;
  gjk_arm_link_room link_room[GJK_ARM_LINKS_MAX];
  gjk_arm_part_room part_room[ARM_PARTS];
  gjk_arm_pair pairs[ARM_PAIRS];
  case_collider parts[ARM_PARTS], obstacles[ARM_OBSTACLES];
  gjk_collider posed[ARM_OBSTACLES];
  gjk_arm_proof *proofs;
  size_t proof_count, proof_capacity;
} arm_machine;

static void take_proof(void *user, const gjk_arm_proof *proof) {
  arm_machine *m = user;
  if (m->proof_count == m->proof_capacity) {
    m->proof_capacity = m->proof_capacity == 0 ? 256 : 2 * m->proof_capacity;
    gjk_arm_proof *larger = realloc(m->proofs, m->proof_capacity * sizeof *larger);
    if (larger == NULL) {
      fprintf(stderr, "gjk-query: no memory for a certificate\n");
      exit(2);
    }
    m->proofs = larger;
  }
  m->proofs[m->proof_count++] = *proof;
}

// Builds what the file has described so far.
static gjk_status build(arm_machine *m) {
  arm_file *f = &m->file;
  const gjk_arm_model model = {f->links, f->parts, f->never, (uint8_t)f->link_count, (uint16_t)f->part_count};
  const gjk_arm_memory memory = {m->link_room, m->part_room, m->pairs, ARM_PAIRS};
  m->model = model;
  for (unsigned i = 0; i < f->part_count; i++) {
    const gjk_status status = case_collider_build(&m->parts[i], &f->part_shapes[i], false);
    if (status != GJK_OK) {
      return status;
    }
    f->parts[i].shape = &m->parts[i].shape;
    f->parts[i].pose = f->part_shapes[i].pose;
  }
  for (unsigned i = 0; i < f->obstacle_count; i++) {
    const gjk_status status = case_collider_build(&m->obstacles[i], &f->obstacle_shapes[i], false);
    if (status != GJK_OK) {
      return status;
    }
    m->posed[i] = m->obstacles[i].collider;
  }
  const gjk_status status = gjk_arm_init(&m->arm, &m->model, &f->base, &memory);
  return status == GJK_OK ? gjk_arm_obstacles(&m->arm, m->posed, (uint16_t)f->obstacle_count) : status;
}

static void print_touch(const arm_machine *m, const gjk_arm_edge_result *result) {
  const arm_file *f = &m->file;
  const char *other =
      result->pair.obstacle ? f->obstacle_names[result->pair.other] : f->link_names[f->parts[result->pair.other].link];
  printf(" touch lower=%ld upper=%ld a=%s b=%s", (long)result->lower, (long)result->upper,
         f->link_names[f->parts[result->pair.part].link], other);
}

static void answer(arm_machine *m, bool certify, arm_tally *tally) {
  const arm_edge *edge = &m->file.edge;
  gjk_arm_edge_result result = {.answer = GJK_ARM_UNSETTLED};
  gjk_status status = build(m);
  m->proof_count = 0;
  if (status == GJK_OK) {
    status = gjk_arm_edge_start(&m->arm, edge->from, edge->to, &edge->setup, certify ? take_proof : NULL, m);
  }
  if (status == GJK_OK) {
    status = gjk_arm_edge_run(&m->arm, UINT32_MAX, &result);
  }
  printf("%s", edge->id);
  if (status != GJK_OK && status != GJK_ERROR_ITERATION_LIMIT) {
    printf(" error %s\n", gjk_status_name(status));
    return;
  }
  if (result.answer == GJK_ARM_FREE) {
    printf(" free gap=%ld", (long)result.gap);
  } else if (result.answer == GJK_ARM_TOUCH) {
    print_touch(m, &result);
  } else {
    printf(" unsettled lower=%ld", (long)result.lower);
  }
  printf(" tests=%lu%s", (unsigned long)result.tests, result.outside ? " outside" : "");
  if (certify) {
    const bool proven = gjk_check_edge(&m->arm, edge->from, edge->to, &edge->setup, &result, m->proofs,
                                       (uint32_t)m->proof_count) == GJK_OK;
    tally->verdicts[proven ? CERTIFY_PROVEN : CERTIFY_WRONG]++;
    printf("%s", proven ? "" : " WRONG: not proven");
  }
  putchar('\n');
}

void arm_run(FILE *file, const char *name, bool certify, arm_tally *tally) {
  static arm_machine m;
  arm_file_open(&m.file, file, name);
  while (arm_file_next(&m.file)) {
    answer(&m, certify, tally);
  }
  tally->bad_input = tally->bad_input || m.file.reader.errors > 0;
  for (unsigned i = 0; i < ARM_PARTS; i++) {
    case_collider_free(&m.parts[i]);
  }
  for (unsigned i = 0; i < ARM_OBSTACLES; i++) {
    case_collider_free(&m.obstacles[i]);
  }
  arm_file_close(&m.file);
  free(m.proofs);
  m.proofs = NULL;
  m.proof_capacity = 0;
}
