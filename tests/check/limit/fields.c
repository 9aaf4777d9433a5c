// Which fields each query writes after each status. test_limit.sh builds it with low ceilings on iterations and with
// the usual one.
//
// Each question is asked twice, with outputs that are filled with different bytes. A valid field must then be the same
// in both; after an error, a field that is not valid must be as it was. The tables below repeat what the public headers
// say.
#include <stdio.h>
#include <string.h>

#include "filled.h"
#include "gjk/contacts.h"
#include "gjk/gjk.h"
#include "random.h"

#define PAIRS 1500
#define VERTICES 24
#define CELLS GJK_EPA_CELLS(256)

typedef union answer {
  gjk_decision decision;
  gjk_within_result within;
  gjk_distance_result distance;
  gjk_penetration_result penetration;
  gjk_manifold manifold;
} answer;

// A pair and what is asked about it.
typedef struct question {
  gjk_collider a, b;
  const gjk_collider *first;
  gjk_q16 distance;
  gjk_effort effort;
  gjk_workspace workspace;
  unsigned most;
} question;

typedef struct field {
  const char *name;
  size_t offset, size;
} field;

#define FIELD(type, member) \
  { .name = #member, .offset = offsetof(type, member), .size = sizeof(((type *)0)->member) }

// Each field of a table is a bit of the masks below it, in the order of the table.
static const field of_decision[] = {FIELD(gjk_decision, yes), FIELD(gjk_decision, iterations),
                                    FIELD(gjk_decision, certificate.proof), FIELD(gjk_decision, certificate.count)};
enum { YES = 1, ITERATIONS = 2, DECISION = 15 };

static const field of_within[] = {FIELD(gjk_within_result, answer), FIELD(gjk_within_result, decision.yes),
                                  FIELD(gjk_within_result, decision.iterations),
                                  FIELD(gjk_within_result, decision.certificate.proof),
                                  FIELD(gjk_within_result, decision.certificate.count)};
enum { ANSWER = 1, ANSWER_ITERATIONS = 4, WITHIN = 31 };

static const field of_distance[] = {FIELD(gjk_distance_result, distance),
                                    FIELD(gjk_distance_result, lower),
                                    FIELD(gjk_distance_result, upper),
                                    FIELD(gjk_distance_result, intersecting),
                                    FIELD(gjk_distance_result, saturated),
                                    FIELD(gjk_distance_result, iterations),
                                    FIELD(gjk_distance_result, point_a),
                                    FIELD(gjk_distance_result, point_b),
                                    FIELD(gjk_distance_result, normal),
                                    FIELD(gjk_distance_result, certificate.proof),
                                    FIELD(gjk_distance_result, certificate.count)};
enum { BOUNDS = 2 | 4 | 32, PLACES = 64 | 128 | 256, DISTANCE = 2047 };

static const field of_penetration[] = {FIELD(gjk_penetration_result, depth),
                                       FIELD(gjk_penetration_result, lower),
                                       FIELD(gjk_penetration_result, upper),
                                       FIELD(gjk_penetration_result, point_a),
                                       FIELD(gjk_penetration_result, point_b),
                                       FIELD(gjk_penetration_result, normal),
                                       FIELD(gjk_penetration_result, intersecting),
                                       FIELD(gjk_penetration_result, iterations),
                                       FIELD(gjk_penetration_result, certificate.proof),
                                       FIELD(gjk_penetration_result, certificate.count)};
enum { APART = 64 | 128 | 256 | 512, PENETRATION = 1023 };

static const field of_manifold[] = {FIELD(gjk_manifold, normal), FIELD(gjk_manifold, count),
                                    FIELD(gjk_manifold, feature_a), FIELD(gjk_manifold, feature_b)};
enum { MANIFOLD = 15 };

static gjk_status ask_intersect(const question *q, answer *out) {
  return gjk_intersect(q->first, &q->b, NULL, &out->decision);
}

static unsigned valid_decision(gjk_status status, const answer *out) {
  (void)out;
  return status == GJK_OK ? DECISION : status == GJK_ERROR_ITERATION_LIMIT ? ITERATIONS : 0;
}

static gjk_status ask_within(const question *q, answer *out) {
  return gjk_within(q->first, &q->b, q->distance, NULL, &out->decision);
}

static gjk_status ask_within_until(const question *q, answer *out) {
  return gjk_within_until(q->first, &q->b, q->distance, q->effort.iterations, NULL, &out->within);
}

static unsigned valid_within(gjk_status status, const answer *out) {
  if (status != GJK_OK && status != GJK_ERROR_ITERATION_LIMIT) {
    return 0;
  }
  return out->within.answer == GJK_ANSWER_OPEN ? ANSWER | ANSWER_ITERATIONS : WITHIN;
}

static gjk_status ask_distance(const question *q, answer *out) {
  return gjk_distance(q->first, &q->b, NULL, &out->distance);
}

static unsigned valid_distance(gjk_status status, const answer *out) {
  if (status != GJK_OK && status != GJK_ERROR_ITERATION_LIMIT) {
    return 0;
  }
  return out->distance.intersecting ? DISTANCE & ~PLACES : DISTANCE;
}

static gjk_status ask_until(const question *q, answer *out) {
  return gjk_distance_until(q->first, &q->b, &q->effort, NULL, &out->distance);
}

static gjk_status ask_penetration(const question *q, answer *out) {
  return gjk_penetration(q->first, &q->b, NULL, &q->workspace, &out->penetration);
}

static unsigned valid_penetration(gjk_status status, const answer *out) {
  if (status != GJK_OK && status != GJK_ERROR_CAPACITY) {
    return 0;
  }
  return out->penetration.intersecting ? PENETRATION : APART;
}

static gjk_status ask_signed(const question *q, answer *out) {
  return gjk_signed_distance(q->first, &q->b, NULL, &q->workspace, &out->distance);
}

static unsigned valid_signed(gjk_status status, const answer *out) {
  (void)out;
  return status == GJK_OK || status == GJK_ERROR_CAPACITY ? DISTANCE : status == GJK_ERROR_ITERATION_LIMIT ? BOUNDS : 0;
}

static gjk_status ask_contacts(const question *q, answer *out) {
  return gjk_contacts(q->first, &q->b, q->distance, q->most, NULL, &q->workspace, &out->manifold);
}

static unsigned valid_manifold(gjk_status status, const answer *out) {
  (void)out;
  return status == GJK_OK || status == GJK_ERROR_CAPACITY ? MANIFOLD : 0;
}

#define TABLE(table) .fields = (table), .count = sizeof(table) / sizeof(table)[0]

static const struct query {
  const char *name;
  gjk_status (*ask)(const question *, answer *);
  unsigned (*valid)(gjk_status, const answer *);
  const field *fields;
  size_t count;
} queries[] = {{.name = "gjk_intersect", .ask = ask_intersect, .valid = valid_decision, TABLE(of_decision)},
               {.name = "gjk_within", .ask = ask_within, .valid = valid_decision, TABLE(of_decision)},
               {.name = "gjk_within_until", .ask = ask_within_until, .valid = valid_within, TABLE(of_within)},
               {.name = "gjk_distance", .ask = ask_distance, .valid = valid_distance, TABLE(of_distance)},
               {.name = "gjk_distance_until", .ask = ask_until, .valid = valid_distance, TABLE(of_distance)},
               {.name = "gjk_penetration", .ask = ask_penetration, .valid = valid_penetration, TABLE(of_penetration)},
               {.name = "gjk_signed_distance", .ask = ask_signed, .valid = valid_signed, TABLE(of_distance)},
               {.name = "gjk_contacts", .ask = ask_contacts, .valid = valid_manifold, TABLE(of_manifold)}};

#define QUERIES (sizeof queries / sizeof queries[0])
#define STATUSES 16

static unsigned long seen[QUERIES][STATUSES];

// Compares the pairs and the direction of a certificate, as far as its proof uses them.
static bool same_proof(const gjk_certificate *p, const gjk_certificate *q) {
  const size_t named = p->count * sizeof p->a[0];
  const bool directed = p->proof == GJK_PROOF_DIRECTION || p->proof == GJK_PROOF_PLANE;
  return p->count <= 4 && memcmp(p->a, q->a, named) == 0 && memcmp(p->b, q->b, named) == 0 &&
         (!directed || memcmp(&p->direction, &q->direction, sizeof p->direction) == 0);
}

static bool same_named(size_t query, unsigned valid, const answer *p, const answer *q) {
  switch (query) {
    case 0:
    case 1: return (valid & YES) == 0 || same_proof(&p->decision.certificate, &q->decision.certificate);
    case 2: return valid != WITHIN || same_proof(&p->within.decision.certificate, &q->within.decision.certificate);
    case 5: return valid == 0 || same_proof(&p->penetration.certificate, &q->penetration.certificate);
    case 7:
      for (unsigned i = 0; valid != 0 && i < p->manifold.count; i++) {
        const gjk_contact *c = &p->manifold.contact[i], *d = &q->manifold.contact[i];
        if (memcmp(&c->point_a, &d->point_a, sizeof c->point_a) != 0 ||
            memcmp(&c->point_b, &d->point_b, sizeof c->point_b) != 0 || c->distance != d->distance || c->id != d->id) {
          return false;
        }
      }
      return true;
    default:
      return (valid & DISTANCE & ~(BOUNDS | PLACES)) == 0 ||
             same_proof(&p->distance.certificate, &q->distance.certificate);
  }
}

// The bounds must hold the distance, which is known where the usual ceiling settles it.
static bool check_one(size_t i, const question *q) {
  const struct query *query = &queries[i];
  answer out[2];
  memset(&out[0], 0xA5, sizeof out[0]);
  memset(&out[1], 0x5A, sizeof out[1]);
  const gjk_status status = query->ask(q, &out[0]);
  if (query->ask(q, &out[1]) != status) {
    return false;
  }
  seen[i][-(int)status]++;
  // Reads a value only where it was written, which the comparison below shows.
  const unsigned valid = query->valid(status, &out[0]);
  for (size_t k = 0; k < query->count; k++) {
    const field *f = &query->fields[k];
    const char *p = (const char *)&out[0] + f->offset, *r = (const char *)&out[1] + f->offset;
    const bool same = memcmp(p, r, f->size) == 0;
    const bool untouched = is_filled(p, f->size, 0xA5) && is_filled(r, f->size, 0x5A);
    if ((valid >> k & 1u) != 0 ? !same : status != GJK_OK && status != GJK_ERROR_CAPACITY && !untouched) {
      printf("failed: %s, %s: %s\n", query->name, gjk_status_name(status), f->name);
      return false;
    }
  }
  if (valid == 0 && !(is_filled(&out[0], sizeof out[0], 0xA5) && is_filled(&out[1], sizeof out[1], 0x5A))) {
    printf("failed: %s, %s: something is written\n", query->name, gjk_status_name(status));
    return false;
  }
  if (!same_named(i, valid, &out[0], &out[1])) {
    printf("failed: %s, %s: what is named\n", query->name, gjk_status_name(status));
    return false;
  }
  return true;
}

static gjk_vec3 vertices[2][VERTICES];
static gjk_shape shapes[2];

static void make(random_state *random, int i, int32_t size, gjk_collider *collider) {
  const gjk_shape kinds[] = {
      GJK_HULL(vertices[i], VERTICES), GJK_ROUNDED_BOX(size, size / 2 + 1, size / 3 + 1, size / 9),
      GJK_CYLINDER(size / 2 + 1, size), GJK_ELLIPSOID(size, size / 2 + 1, size / 5 + 1), GJK_CONE(size / 4 + 1, size)};
  const gjk_quat q = {random_range(random, -1000, 1000), random_range(random, -1000, 1000),
                      random_range(random, -1000, 1000), random_range(random, -1000, 1001)};
  gjk_pose pose = GJK_POSE_IDENTITY;
  shapes[i] = kinds[random_below(random, 5)];
  for (int k = 0; k < VERTICES; k++) {
    vertices[i][k].x = random_range(random, -size, size);
    vertices[i][k].y = random_range(random, -size, size);
    vertices[i][k].z = random_range(random, -size, size);
  }
  (void)gjk_quat_normalize(&q, &pose.rotation);
  pose.position.x = random_range(random, -2 * size, 2 * size);
  pose.position.y = random_range(random, -2 * size, 2 * size);
  pose.position.z = random_range(random, -2 * size, 2 * size);
  memset(collider, 0, sizeof *collider);
  (void)gjk_collider_init(collider, &shapes[i], NULL, 0);
  (void)gjk_collider_pose(collider, &pose);
}

// Asks all queries about a pair, and about what is not a pair.
static bool check_pair(question *q) {
  static const gjk_collider unposed;
  bool right = true;
  for (size_t i = 0; i < QUERIES; i++) {
    question wrong = *q;
    wrong.first = NULL;
    right = check_one(i, &wrong) && right;
    wrong.first = &unposed;
    right = check_one(i, &wrong) && right;
    wrong.first = &wrong.a;
    right = check_one(i, &wrong) && right;
    wrong.distance = -1;
    wrong.effort.error = -1;
    right = check_one(i, &wrong) && right;
    wrong.distance = 0;
    wrong.most = 0;
    right = check_one(i, &wrong) && right;
  }
  return right;
}

int main(void) {
  static gjk_epa_cell cells[CELLS];
  random_state random = random_seed(11);
  unsigned failures = 0;
  for (int i = 0; i < PAIRS && failures < 5; i++) {
    const int32_t size = INT32_C(1) << (4 + random_below(&random, 22));
    question q;
    memset(&q, 0, sizeof q);
    make(&random, 0, size, &q.a);
    make(&random, 1, size, &q.b);
    q.distance = random_range(&random, 0, size);
    q.effort.iterations = (uint8_t)(i % 2 == 0 ? 0 : random_range(&random, 1, 3));
    q.workspace.cells = cells;
    q.workspace.count = i % 4 == 0 ? random_below(&random, 60) : CELLS;
    q.most = 4;
    if (!check_pair(&q)) {
      printf("pair %d of seed 11\n", i);
      failures++;
    }
  }
  for (size_t i = 0; i < QUERIES; i++) {
    printf("%s", queries[i].name);
    for (int status = 0; status < STATUSES; status++) {
      if (seen[i][status] > 0) {
        printf(" %s %lu", gjk_status_name((gjk_status)-status), seen[i][status]);
      }
    }
    printf("\n");
  }
  return failures > 0;
}
