// Casts, rays and times of impact in space; motion2.c makes those of the plane of this source.
#include <string.h>

#include "case/answer.h"
#include "exact/cast_claim.h"
#include "exact/clearance.h"
#include "motion.h"

// The most poses on the way that are looked at to check a time of impact.
#define POSES 20000

// What posing and distances may round, LSB, but for what grows with the bodies.
#define ROUNDING 8

static bool is_ray(const case_pair *pair) {
  return pair->b.kind == CASE_POINT && pair->b.convex_radius == 0 && !pair->a.moves;
}

static gjk_q16 tolerance_of(const motion_question *question) {
  return question->tolerance > 0 ? question->tolerance : GJK_IMPACT_TOLERANCE_MIN;
}

static gjk_status find_impact(const motion_question *question, const case_pair *pair, const case_collider *a,
                              const case_collider *b, gjk_impact_result *out) {
  const gjk_motion motion_a = case_motion(&pair->a), motion_b = case_motion(&pair->b);
  const gjk_impact_setup setup = {.margin = question->margin, .tolerance = tolerance_of(question)};
  return gjk_time_of_impact(&a->collider, &motion_a, &b->collider, &motion_b, &setup, out);
}

void motion_find(const motion_question *question, const case_pair *pair, case_collider *a, case_collider *b,
                 motion_answer *answer) {
  const gjk_cast_path path = case_path(pair, question->margin);
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
  switch (question->ask) {
    case MOTION_RAY:
      answer->is_no_ray = !is_ray(pair);
      answer->status = answer->is_no_ray
                           ? GJK_ERROR_UNSUPPORTED
                           : gjk_cast_ray(&a->collider, &pair->b.pose.position, &pair->b.end.position, &answer->cast);
      break;
    case MOTION_IMPACT: answer->status = find_impact(question, pair, a, b, &answer->impact); break;
    default: answer->status = gjk_cast(&a->collider, &b->collider, &path, &answer->cast); break;
  }
}

static void print_error(FILE *file, const char *id, const motion_answer *answer) {
  const gjk_status status = answer->status;
  fprintf(file, "%s error %s ", id, gjk_status_name(status));
  if (answer->refused != 0) {
    fprintf(file, "%c: %s", answer->refused, case_status_detail(status));
  } else if (answer->is_no_ray) {
    fprintf(file, "not a ray: B must be a point, and A must stand");
  } else if (status == GJK_ERROR_RANGE) {
    fprintf(file, "a centre leaves the world on its way, or the way of one against the other is too long");
  } else {
    fprintf(file, "%s", case_status_detail(status));
  }
}

#ifndef MOTION_OF_PLANE
static void print_vector(FILE *file, const char *name, const gjk_vec3 *v) {
  fprintf(file, " %s=%ld,%ld,%ld", name, (long)v->x, (long)v->y, (long)v->z);
}

static void print_normal(FILE *file, const gjk_unit3 *n) {
  fprintf(file, " normal=%ld,%ld,%ld", (long)n->x, (long)n->y, (long)n->z);
}
#endif

static void print_touch(FILE *file, const gjk_vec3 *a, const gjk_vec3 *b, const gjk_unit3 *normal) {
  print_vector(file, "a", a);
  print_vector(file, "b", b);
  print_normal(file, normal);
}

static void print_cast(FILE *file, const case_pair *pair, gjk_status status, const gjk_cast_result *r) {
  if (status == GJK_ERROR_ITERATION_LIMIT) {
    fprintf(file, "%s open fraction=%ld", pair->id, (long)r->fraction);
    print_vector(file, "at", &r->rest_b);
  } else if (r->hit) {
    fprintf(file, "%s hit fraction=%ld", pair->id, (long)r->fraction);
    print_touch(file, &r->point_a, &r->point_b, &r->normal);
    print_vector(file, "at", &r->rest_b);
    if (pair->a.moves) {
      print_vector(file, "a-at", &r->rest_a);
    }
  } else {
    fprintf(file, "%s miss", pair->id);
  }
  fprintf(file, " iterations=%u%s", r->iterations, r->hit && r->saturated ? " saturated" : "");
}

static void print_impact(FILE *file, const case_pair *pair, gjk_status status, const gjk_impact_result *r) {
  if (status == GJK_ERROR_ITERATION_LIMIT) {
    fprintf(file, "%s open lower=%ld", pair->id, (long)r->lower);
  } else if (r->hit) {
    fprintf(file, "%s hit lower=%ld upper=%ld distance=%ld", pair->id, (long)r->lower, (long)r->upper,
            (long)r->distance);
    if (!r->overlap) {
      print_touch(file, &r->point_a, &r->point_b, &r->normal);
      print_vector(file, "at", &r->pose_b.position);
    }
  } else {
    fprintf(file, "%s miss", pair->id);
  }
  fprintf(file, "%s iterations=%u", r->overlap ? " overlap" : "", r->iterations);
}

void motion_print(FILE *file, const motion_question *question, const case_pair *pair, const motion_answer *answer) {
  const bool open = answer->status == GJK_ERROR_ITERATION_LIMIT;
  if (answer->refused != 0 || (answer->status != GJK_OK && !open)) {
    print_error(file, pair->id, answer);
  } else if (question->ask == MOTION_IMPACT) {
    print_impact(file, pair, answer->status, &answer->impact);
  } else {
    print_cast(file, pair, answer->status, &answer->cast);
  }
}

// Proves a cast of polytopes by its certificate, and by the oracle where it has few enough vertices. A ray has the
// certificate of its point's cast.
static certify_verdict certify_cast(const motion_question *question, const case_pair *pair, const gjk_collider *a,
                                    const gjk_collider *b, const gjk_cast_result *r, char why[CERTIFY_WHY_MAX]) {
  static exact_cast exact;
  const gjk_cast_path path = case_path(pair, question->margin);
  const gjk_status status = gjk_check_cast(a, b, &path, r);
  snprintf(why, CERTIFY_WHY_MAX, "the library's check: %s", gjk_status_name(status));
  if (status != GJK_OK) {
    return status == GJK_ERROR_UNSUPPORTED ? CERTIFY_UNCERTIFIED : CERTIFY_WRONG;
  }
  if (exact_cast_set(a, b, &path, &exact)) {
    return exact_check_cast(&exact, r, why, CERTIFY_WHY_MAX) ? CERTIFY_PROVEN : CERTIFY_WRONG;
  }
  const bool round = a->shape->convex_radius != 0 || b->shape->convex_radius != 0 || path.margin != 0;
  snprintf(why, CERTIFY_WHY_MAX, "a radius or margin: hit or miss is proven, the fraction is not");
  return round && r->hit ? CERTIFY_UNCERTIFIED : CERTIFY_PROVEN;
}

// The gap at a fraction, by a distance query. False: there is none.
static bool gap_at(const case_pair *pair, case_collider *a, case_collider *b, gjk_q30 fraction,
                   gjk_distance_result *out) {
  const gjk_motion motion_a = case_motion(&pair->a), motion_b = case_motion(&pair->b);
  gjk_pose at_a, at_b;
  return gjk_motion_pose(&motion_a, fraction, &at_a) == GJK_OK &&
         gjk_motion_pose(&motion_b, fraction, &at_b) == GJK_OK && gjk_collider_pose(&a->collider, &at_a) == GJK_OK &&
         gjk_collider_pose(&b->collider, &at_b) == GJK_OK &&
         gjk_distance(&a->collider, &b->collider, NULL, out) == GJK_OK;
}

typedef struct moving {
  const case_pair *pair;
  case_collider *a, *b;
} moving;

static bool measure(void *user, gjk_q30 fraction, int64_t *out) {
  const moving *m = user;
  gjk_distance_result gap;
  const bool found = gap_at(m->pair, m->a, m->b, fraction, &gap);
  *out = found ? gap.distance - (gap.intersecting ? 1 : 0) : 0;
  return found;
}

// At upper the gap is as told. Before lower it is above the margin on the whole way, but for what posing and distances round.
static certify_verdict certify_impact(const motion_question *question, const case_pair *pair, case_collider *a,
                                      case_collider *b, const gjk_impact_result *r, char why[CERTIFY_WHY_MAX]) {
  const gjk_motion motion_a = case_motion(&pair->a), motion_b = case_motion(&pair->b);
  const double reach_a = clearance_reach(&a->collider), reach_b = clearance_reach(&b->collider);
  const double rounding = ROUNDING + (reach_a + reach_b) / (1 << 24);
  moving bodies = {pair, a, b};
  clearance c = {.gap = measure, .user = &bodies, .most = POSES};
  gjk_distance_result gap;
  if (r->lower < 0 || r->lower > r->upper || r->upper > GJK_Q30_ONE) {
    snprintf(why, CERTIFY_WHY_MAX, "bounds out of order");
    return CERTIFY_WRONG;
  }
  if (r->hit) {
    const int64_t most = (int64_t)question->margin + (r->overlap ? 0 : tolerance_of(question));
    if (!gap_at(pair, a, b, r->upper, &gap) || gap.distance != r->distance || gap.distance > most) {
      snprintf(why, CERTIFY_WHY_MAX, "the gap at upper is %ld", (long)gap.distance);
      return CERTIFY_WRONG;
    }
  }
  c.speed = clearance_speed(&motion_a, reach_a, &motion_b, reach_b);
  c.least = question->margin;
  c.between = question->margin - rounding;
  const clearance_outcome outcome = r->overlap ? CLEARANCE_PROVEN : clearance_search(&c, r->lower);
  if (outcome == CLEARANCE_TOUCHED) {
    snprintf(why, CERTIFY_WHY_MAX, "the gap at %ld, before lower, is %ld", (long)c.at, (long)c.last);
    return CERTIFY_WRONG;
  }
  snprintf(why, CERTIFY_WHY_MAX,
           outcome == CLEARANCE_PROVEN ? "%u distances bound the gap before lower, to what posing rounds"
                                       : "%u distances agree, but do not bound the gap on the whole way",
           c.measured);
  return CERTIFY_UNCERTIFIED;
}

certify_verdict motion_certify(const motion_question *question, const case_pair *pair, case_collider *a,
                               case_collider *b, const motion_answer *answer, char why[CERTIFY_WHY_MAX]) {
  const bool open = answer->status == GJK_ERROR_ITERATION_LIMIT;
  if (answer->status != GJK_OK && !open) {
    snprintf(why, CERTIFY_WHY_MAX, "no answer: %s", gjk_status_name(answer->status));
    return answer->is_no_ray || answer->status == GJK_ERROR_RANGE ? CERTIFY_UNCERTIFIED : CERTIFY_WRONG;
  }
  if (open && question->ask != MOTION_IMPACT) {
    snprintf(why, CERTIFY_WHY_MAX, "open");
    return CERTIFY_UNCERTIFIED;
  }
  return question->ask == MOTION_IMPACT ? certify_impact(question, pair, a, b, &answer->impact, why)
                                        : certify_cast(question, pair, &a->collider, &b->collider, &answer->cast, why);
}
