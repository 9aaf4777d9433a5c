// Depths, casts and times of impact of surfaces against every triangle by the pair's query; the certificates of what is
// reported, and that changed answers are refused. Duplicated triangles, thin ones and soups among them. Then what is refused,
// which leaves all outputs as they were.
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "generate/surface.h"
#include "gjk/check.h"
#include "gjk/height_field.h"
#include "gjk/surface.h"
#include "parts_answers.h"
#include "parts_brute.h"
#include "placed.h"
#include "reference/random_shape.h"

#define SEED UINT64_C(0x42727574)
#define TRIALS 90
#define BODIES 6
#define CELLS 1000

typedef struct trial {
  surface ground;
  gjk_parts parts;
  case_shape source;
  case_collider body;
} trial;

static gjk_epa_cell cells[CELLS];
static struct { unsigned long deep, apart, ties, hits, misses, starts, impacts, free_ways, overlaps, refused; } tally;

static void show(const void *subject) {
  const trial *t = (const trial *)subject;
  const gjk_pose *p = &t->source.pose;
  printf("  %s, %lu triangles, body kind %d at (%ld, %ld, %ld) turned (%ld, %ld, %ld, %ld)\n",
         surface_names[t->ground.kind], (unsigned long)t->ground.triangle_count, (int)t->source.kind,
         (long)p->position.x, (long)p->position.y, (long)p->position.z, (long)p->rotation.x, (long)p->rotation.y,
         (long)p->rotation.z, (long)p->rotation.w);
}

static void make_body(random_state *random, trial *t, int32_t step) {
  static const case_kind kinds[] = {CASE_BOX, CASE_POINT, CASE_SEGMENT, CASE_HULL};
  gjk_parts_room room;
  gjk_collider triangle;
  CHECK(gjk_parts_place(&t->parts, random_below(random, t->ground.triangle_count), &room, &triangle) == GJK_OK);
  random_shape(random, kinds[random_below(random, 4)], 1 + (gjk_q16)(step * 2 * random_unit(random)), &t->source);
  const gjk_vec3 off = random_vector(random, 3.0 * step * random_unit(random) * random_unit(random));
  t->source.pose.position.x = triangle.centre.x + off.x;
  t->source.pose.position.y = triangle.centre.y + off.y;
  t->source.pose.position.z = triangle.centre.z + off.z;
  t->source.pose.rotation = random_rotation(random);
  case_collider_free(&t->body);
  CHECK(case_collider_build(&t->body, &t->source, false) == GJK_OK);
}

static void check_depth(random_state *random, const trial *t) {
  const gjk_workspace workspace = {cells, random_below(random, 2) == 0 ? CELLS : random_below(random, 60)};
  const gjk_collider *b = &t->body.collider;
  gjk_parts_room room;
  gjk_collider c;
  gjk_penetration_result best, answer;
  uint32_t part;
  gjk_status of_best;
  const uint32_t deepest = brute_depth(&t->parts, b, &workspace, &best, &of_best, &tally.ties);
  CHECK(gjk_parts_penetration(&t->parts, b, &workspace, &part, &answer) == of_best);
  CHECK(part == deepest && answer.intersecting == (deepest != GJK_PARTS_NONE));
  CHECK(deepest == GJK_PARTS_NONE || same_penetration(&answer, &best));
  tally.deep += deepest != GJK_PARTS_NONE;
  tally.apart += deepest == GJK_PARTS_NONE;
  if (deepest != GJK_PARTS_NONE && of_best == GJK_OK) {
    CHECK(gjk_parts_place(&t->parts, part, &room, &c) == GJK_OK);
    answer.lower = answer.depth;
    CHECK(gjk_check_penetration(&c, b, &answer) == GJK_OK);
    answer.depth++;
    CHECK(gjk_check_penetration(&c, b, &answer) == GJK_ERROR_UNPROVEN);
    tally.refused++;
  }
}

static void check_distance(const trial *t) {
  const gjk_collider *b = &t->body.collider;
  gjk_parts_room room;
  gjk_collider c;
  gjk_distance_result answer;
  uint32_t part;
  CHECK(gjk_parts_distance(&t->parts, b, &part, &answer) == GJK_OK);
  CHECK(gjk_parts_place(&t->parts, part, &room, &c) == GJK_OK);
  CHECK(gjk_check_distance(&c, b, &answer) == GJK_OK);
  if (!answer.intersecting) {
    answer.distance--;
    CHECK(gjk_check_distance(&c, b, &answer) == GJK_ERROR_UNPROVEN);
    tally.refused++;
  }
}

// A cast of both, with a margin or without.
static void check_cast(random_state *random, const trial *t, int32_t step) {
  const gjk_collider *b = &t->body.collider;
  const gjk_vec3 by = random_vector(random, 8.0 * step), more = random_vector(random, 4.0 * step);
  const gjk_vec3 *at = &t->parts.pose.position;
  const gjk_vec3 to = {b->position.x + by.x, b->position.y + by.y, b->position.z + by.z};
  const gjk_vec3 to_a = {at->x + more.x, at->y + more.y, at->z + more.z};
  const gjk_cast_path path = {random_below(random, 2) == 0 ? &to_a : NULL, &to,
                              random_below(random, 2) == 0 ? 0 : step / 8};
  gjk_parts_room room;
  gjk_collider c;
  gjk_cast_result best, answer;
  uint32_t part;
  const uint32_t first = brute_cast(&t->parts, b, &path, &best);
  if (first != GJK_PARTS_NONE) {
    gjk_vec3 end;
    gjk_cast_result claim = best;
    CHECK(gjk_parts_place(&t->parts, first, &room, &c) == GJK_OK);
    const gjk_cast_path own = brute_path(&t->parts, &c, &path, &end);
    CHECK(gjk_check_cast(&c, b, &own, &claim) == GJK_OK);
    if (!claim.inside && path.margin == 0 && t->source.convex_radius == 0) {
      claim.fraction++;
      CHECK(gjk_check_cast(&c, b, &own, &claim) == GJK_ERROR_UNPROVEN);
      tally.refused++;
    }
  }
  CHECK(gjk_parts_cast(&t->parts, b, &path, &part, &answer) == GJK_OK);
  CHECK_MSG(part == first && answer.hit == (first != GJK_PARTS_NONE), "triangle %ld not %ld", (long)part, (long)first);
  CHECK(!answer.hit || same_cast(&answer, &best));
  tally.hits += answer.hit && !answer.inside;
  tally.starts += answer.hit && answer.inside;
  tally.misses += !answer.hit;
}

// The gap at a fraction of both ways: by brute force over the triangles.
static gjk_distance_result gap_at(trial *t, const gjk_motion motion[2], gjk_q30 fraction) {
  trial moved = *t;
  gjk_parts_room room;
  gjk_collider c;
  gjk_pose pose;
  gjk_distance_result least = {0}, one;
  least.distance = GJK_DISTANCE_MAX;
  CHECK(gjk_motion_pose(&motion[0], fraction, &moved.parts.pose) == GJK_OK);
  CHECK(gjk_motion_pose(&motion[1], fraction, &pose) == GJK_OK);
  CHECK(gjk_collider_pose(&moved.body.collider, &pose) == GJK_OK);
  for (uint32_t i = 0; i < t->ground.triangle_count; i++) {
    CHECK(gjk_parts_place(&moved.parts, i, &room, &c) == GJK_OK);
    CHECK(gjk_distance(&c, &moved.body.collider, NULL, &one) == GJK_OK);
    if (one.distance < least.distance || one.intersecting) {
      least = one;
    }
    if (one.intersecting) {
      break;
    }
  }
  return least;
}

static void check_impact(random_state *random, trial *t, int32_t step) {
  const gjk_impact_setup setup = {random_below(random, 2) == 0 ? 0 : step / 16, 256 + step / 256, 0};
  const gjk_vec3 by = random_vector(random, 6.0 * step), drift = random_vector(random, 2.0 * step);
  gjk_motion motion[2];
  gjk_impact_result best, answer;
  uint32_t part;
  bool limited;
  memset(motion, 0, sizeof motion);
  motion[0].from = motion[0].to = t->parts.pose;
  if (random_below(random, 2) == 0) {
    motion[0].to.position.x += drift.x;
    motion[0].to.position.y += drift.y;
    motion[0].to.position.z += drift.z;
  }
  motion[1].from = motion[1].to = t->source.pose;
  motion[1].to.position.x += by.x;
  motion[1].to.position.y += by.y;
  motion[1].to.position.z += by.z;
  if (random_below(random, 2) == 0) {
    motion[0].to.rotation = random_rotation(random);
  }
  if (random_below(random, 2) == 0) {
    motion[1].spin = random_vector(random, 300000);
  }
  const uint32_t first = brute_impact(&t->parts, motion, &t->body.collider, &setup, &best, &limited);
  CHECK(!limited);
  CHECK(gjk_parts_time_of_impact(&t->parts, &motion[0], &t->body.collider, &motion[1], &setup, &part, &answer) ==
        GJK_OK);
  CHECK_MSG(part == first && answer.hit == (first != GJK_PARTS_NONE), "triangle %ld not %ld", (long)part, (long)first);
  CHECK(!answer.hit || same_impact(&answer, &best));
  tally.impacts += answer.hit && !answer.overlap;
  tally.overlaps += answer.overlap;
  tally.free_ways += !answer.hit;
  if (answer.hit) {
    const gjk_distance_result gap = gap_at(t, motion, answer.upper);
    CHECK_MSG(gap.intersecting || gap.distance <= setup.margin + setup.tolerance + 8, "gap %ld", (long)gap.distance);
    CHECK(answer.overlap || !gap.intersecting);
  }
  for (int k = 0; k < 3 && answer.lower > 0; k++) {
    const gjk_q30 before = (gjk_q30)((double)(answer.lower - 1) * (k == 0 ? 1 : random_unit(random)));
    const gjk_distance_result gap = gap_at(t, motion, before);
    CHECK_MSG(!gap.intersecting && gap.distance >= setup.margin, "gap %ld before", (long)gap.distance);
  }
}

// Every query that is refused leaves what it may write as it was.
static void refuse(const gjk_parts *a, const gjk_collider *b, gjk_status expected) {
  const gjk_vec3 to = {0, 0, 0};
  const gjk_cast_path path = {NULL, &to, 0};
  const gjk_impact_setup setup = {0, 4096, 0};
  gjk_motion motion[2];
  union {
    gjk_decision decision;
    gjk_distance_result distance;
    gjk_penetration_result depth;
    gjk_cast_result cast;
    gjk_impact_result impact;
  } out, before;
  gjk_surface_contact contact;
  uint32_t part = 77;
  uint16_t count = 77;
  memset(motion, 0, sizeof motion);
  motion[1].from.rotation.w = motion[1].to.rotation.w = GJK_Q30_ONE;
  motion[0] = motion[1];
  if (a != NULL) {
    motion[0].from = motion[0].to = a->pose;
  }
  memset(&out, 0x5A, sizeof out);
  before = out;
  CHECK(gjk_parts_intersect(a, b, &part, &out.decision) == expected);
  CHECK(gjk_parts_within(a, b, 5, &part, &out.decision) == expected);
  CHECK(gjk_parts_distance(a, b, &part, &out.distance) == expected);
  CHECK(gjk_parts_penetration(a, b, NULL, &part, &out.depth) == expected);
  CHECK(gjk_parts_contacts(a, b, 0, 4, NULL, NULL, 0, &part) == expected);
  CHECK(gjk_surface_contacts(a, b, 0, 4, NULL, &contact, 1, &count) == expected);
  CHECK(gjk_parts_cast(a, b, &path, &part, &out.cast) == expected);
  if (b != NULL && b->shape != NULL) {
    CHECK(gjk_parts_cast_ray(a, &to, &to, &part, &out.cast) == expected);
    CHECK(gjk_parts_time_of_impact(a, &motion[0], b, &motion[1], &setup, &part, &out.impact) == expected);
  }
  CHECK(part == 77 && count == 77 && memcmp(&out, &before, sizeof out) == 0);
}

static void check_refusals(gjk_parts good) {
  static const gjk_shape crate = GJK_BOX(GJK_Q16(1), GJK_Q16(1), GJK_Q16(1));
  static const gjk_pose identity = GJK_POSE_IDENTITY;
  gjk_collider never = {0};
  gjk_parts bad = good;
  const gjk_collider b = posed(&crate, &identity);
  refuse(NULL, &b, GJK_ERROR_NULL);
  refuse(&good, NULL, GJK_ERROR_NULL);
  refuse(&good, &never, GJK_ERROR_UNINITIALISED);
  bad.type = NULL;
  refuse(&bad, &b, GJK_ERROR_NULL);
  bad = good;
  bad.data = NULL;
  refuse(&bad, &b, GJK_ERROR_NULL);
  bad = good;
  bad.pose.rotation.x = bad.pose.rotation.y = GJK_Q30_ONE;
  refuse(&bad, &b, GJK_ERROR_ROTATION);
  bad = good;
  bad.pose.position.z = INT32_MIN + 5;
  refuse(&bad, &b, GJK_ERROR_RANGE);
}

// A triangle longer than there may be, of data that was never checked, has no contacts.
static void check_too_long(void) {
  static const gjk_shape crate = GJK_BOX(GJK_Q16(1), GJK_Q16(1), GJK_Q16(1));
  static const gjk_pose identity = GJK_POSE_IDENTITY;
  gjk_vec3 corners[3] = {{-100000, -100000, 0}, {100000, -100000, 0}, {0, 100000, 0}};
  gjk_mesh_triangle triangle = {{0, 1, 2}};
  gjk_mesh_node node;
  gjk_mesh mesh;
  gjk_surface_contact found;
  CHECK(gjk_mesh_build(corners, 3, &triangle, 1, false, &node, 1, &mesh) == GJK_OK);
  const gjk_collider b = posed(&crate, &identity);
  const gjk_parts parts = GJK_PARTS_OF_MESH(&mesh);
  for (int k = 0; k < 7; k++) {
    static const int32_t far = GJK_MESH_COORDINATE_MAX;
    const gjk_vec3 good = corners[k / 2 % 3];
    uint16_t count = 77;
    if (k < 6) {
      corners[k / 2].x = k % 2 == 0 ? far : good.x;
      corners[k / 2].y = k % 2 == 0 ? good.y : k / 2 == 2 ? far : -far;
    }
    CHECK(gjk_surface_contacts(&parts, &b, 0, 4, NULL, &found, 1, &count) == GJK_OK && count == (k < 6 ? 0 : 1));
    corners[k / 2 % 3] = good;
  }
}

static void check_all_refusals(void) {
  static const gjk_vec3 corners[3] = {{0, 0, 0}, {100000, 0, 0}, {0, 100000, 0}};
  static int16_t heights[4];
  static const gjk_shape crate = GJK_BOX(GJK_Q16(1), GJK_Q16(1), GJK_Q16(1));
  const gjk_height_field field = GJK_HEIGHT_FIELD(heights, 2, 2, 100000, 100000, 16);
  gjk_height_field none = field;
  const gjk_compound_part of_one = {&crate, GJK_POSE_IDENTITY};
  gjk_mesh_triangle triangle = {{0, 1, 2}};
  gjk_mesh_node mesh_node;
  gjk_compound_node node;
  gjk_compound compound;
  gjk_mesh mesh;
  uint16_t count = 77;
  const gjk_pose identity = GJK_POSE_IDENTITY;
  CHECK(gjk_mesh_build(corners, 3, &triangle, 1, false, &mesh_node, 1, &mesh) == GJK_OK);
  CHECK(gjk_compound_build(&of_one, 1, &node, 1, &compound) == GJK_OK);
  const gjk_collider b = posed(&crate, &identity);
  const gjk_parts of_mesh = GJK_PARTS_OF_MESH(&mesh), of_field = GJK_PARTS_OF_HEIGHT_FIELD(&field);
  const gjk_parts of_none = GJK_PARTS_OF_HEIGHT_FIELD(&none), of_compound = GJK_PARTS_OF_COMPOUND(&compound);
  check_refusals(of_mesh);
  check_refusals(of_field);
  none.step_z = 0;
  refuse(&of_none, &b, GJK_ERROR_EMPTY);
  const gjk_mesh good = mesh;
  mesh.nodes = NULL;
  refuse(&of_mesh, &b, GJK_ERROR_EMPTY);
  mesh = good;
  mesh.triangles = NULL;
  refuse(&of_mesh, &b, GJK_ERROR_EMPTY);
  mesh = good;
  mesh.vertices = NULL;
  refuse(&of_mesh, &b, GJK_ERROR_EMPTY);
  mesh = good;
  mesh.triangle_count = GJK_MESH_TRIANGLES_MAX + 1;
  refuse(&of_mesh, &b, GJK_ERROR_EMPTY);
  // A box that leaves no room in int32 at any position.
  for (int k = 0; k < 3; k++) {
    const int32_t lowest[3] = {k == 0 ? INT32_MIN : 0, k == 1 ? INT32_MIN : 0, k == 2 ? INT32_MIN : 0};
    mesh = good;
    mesh.lower.x = lowest[0];
    mesh.lower.y = lowest[1];
    mesh.lower.z = lowest[2];
    refuse(&of_mesh, &b, GJK_ERROR_RANGE);
  }
  CHECK(gjk_surface_contacts(&of_compound, &b, 0, 4, NULL, NULL, 0, &count) == GJK_ERROR_UNSUPPORTED && count == 77);
}

int main(void) {
  static trial t;
  const uint64_t seed = check_seed(SEED);
  const unsigned long trials = check_trials_least(TRIALS, 36);
  check_all_refusals();
  check_too_long();
  for (unsigned long i = 0; i < trials; i++) {
    random_state random = random_seed(seed + i);
    const int32_t step = 1 << random_range(&random, 5, 18);
    surface_make(&random, (surface_kind)(i % SURFACE_KINDS), 1 + random_below(&random, 80), step,
                 random_below(&random, 2) == 0, &t.ground);
    t.parts = (gjk_parts)GJK_PARTS_OF_MESH(&t.ground.mesh);
    t.parts.pose.position = random_vector(&random, random_below(&random, 2) == 0 ? 100000 : 1.0e9);
    if (random_below(&random, 3) > 0) {
      t.parts.pose.rotation = random_rotation(&random);
    }
    for (int k = 0; k < BODIES; k++) {
      make_body(&random, &t, step);
      check_trial(i, show, &t);
      check_depth(&random, &t);
      check_distance(&t);
      check_cast(&random, &t, step);
      check_impact(&random, &t, step);
    }
    surface_free(&t.ground);
  }
  check_trial(trials, NULL, NULL);
  printf(
      "depths %lu, apart %lu, ties %lu; casts %lu hit, %lu at the start, %lu miss; impacts %lu, %lu at the start, %lu "
      "free; %lu forged\n",
      tally.deep, tally.apart, tally.ties, tally.hits, tally.starts, tally.misses, tally.impacts, tally.overlaps,
      tally.free_ways, tally.refused);
  CHECK(tally.deep > trials && tally.apart > trials && tally.ties > trials / 4);
  CHECK(tally.hits > trials / 2 && tally.misses > trials / 2 && tally.starts > trials / 2);
  CHECK(tally.impacts > trials / 2 && tally.free_ways > trials / 2 && tally.overlaps > trials / 2);
  CHECK(tally.refused > trials);
  case_collider_free(&t.body);
  case_shape_free(&t.source);
  return check_done("surface_brute");
}
