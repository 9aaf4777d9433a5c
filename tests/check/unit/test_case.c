// The case model: numbers, reading back what was printed, building colliders.
#include <string.h>

#include "case/number.h"
#include "case/parse.h"
#include "check.h"
#include "random.h"

#define SEED 20240611u

typedef struct number_row {
  const char *text;
  int bits;
  bool good;
  int32_t value;
} number_row;

static const number_row numbers[] = {
    {"0", 16, true, 0},
    {"-1", 16, true, -1},
    {"+7", 16, true, 7},
    {"2147483647", 16, true, INT32_MAX},
    {"-2147483648", 16, true, INT32_MIN},
    {"2147483648", 16, false, 0},
    {"-2147483649", 16, false, 0},
    {"99999999999999999999999999", 16, false, 0},
    {"0000000000000000000000000012", 16, true, 12},
    {"1.0", 16, true, 65536},
    {"1.", 16, true, 65536},
    {".5", 16, true, 32768},
    {"-0.5", 16, true, -32768},
    {"0.7071067811865476", 30, true, 759250125},
    {"-2.0", 30, true, INT32_MIN},
    {"2.0", 30, false, 0},
    {"-32768.0", 16, true, INT32_MIN},
    {"32767.99999", 16, true, INT32_MAX},
    {"32767.999999", 16, false, 0},  // rounds to 2^31
    {"32768.0", 16, false, 0},
    {"1.5e1", 16, true, 983040},
    {"15.0E-1", 16, true, 98304},
    {"1.0e-99999", 16, true, 0},
    {"0.0e99999", 16, true, 0},
    {"1.0e999999", 16, false, 0},
    {"1.0e99999", 16, false, 0},
    // 2^-17, a tie, and its neighbours that no double can tell from it.
    {"0.00000762939453125", 16, true, 1},
    {"-0.00000762939453125", 16, true, -1},
    {"0.0000076293945312499999999999999999", 16, true, 0},
    {"0.0000076293945312500000000000000001", 16, true, 1},
    {"0.0000000000000000000000000000000000000000001", 16, true, 0},
    {"", 16, false, 0},
    {".", 16, false, 0},
    {"-", 16, false, 0},
    {"--1", 16, false, 0},
    {"1.2.3", 16, false, 0},
    {"1e5", 16, false, 0},
    {"1.0e", 16, false, 0},
    {"1.0e+", 16, false, 0},
    {"1.0e--2", 16, false, 0},
    {"1.0e 2", 16, false, 0},
    {"0x10", 16, false, 0},
    {"nan", 16, false, 0},
    {"inf", 16, false, 0},
    {"1,5", 16, false, 0},
};

static void test_numbers(void) {
  for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
    const number_row *row = &numbers[i];
    int32_t value = 12345;
    bool good = case_number_parse(row->text, row->bits, &value);
    CHECK_MSG(good == row->good, "'%s': %d %ld", row->text, good, (long)value);
    CHECK_MSG(value == (good ? row->value : 12345), "'%s': %d %ld", row->text, good, (long)value);
  }
}

// Every Q16.16 number has a finite decimal, and that reads back as itself.
static void test_decimals(random_state *random) {
  for (int i = 0; i < 20000; i++) {
    char text[64];
    int32_t number = (int32_t)(random_u32(random) - UINT32_C(0x80000000)) >> random_below(random, 31), value = 0;
    snprintf(text, sizeof text, "%.16f", number / 65536.0);
    CHECK_MSG(case_number_parse(text, 16, &value), "'%s': %ld for %ld", text, (long)value, (long)number);
    CHECK_MSG(value == number, "'%s': %ld for %ld", text, (long)value, (long)number);
  }
}

static int32_t any_number(random_state *random) {
  return (int32_t)(random_u32(random) >> random_below(random, 32)) - (int32_t)random_below(random, 1000);
}

static void random_case_shape(random_state *random, case_shape *shape) {
  case_shape_reset(shape);
  shape->kind = (case_kind)random_below(random, CASE_ELLIPSOID + 1);
  switch (shape->kind) {
    case CASE_POINT: break;
    case CASE_SEGMENT: shape->size.z = any_number(random); break;
    case CASE_TRIANGLE: case_shape_set_count(shape, 3); break;
    case CASE_HULL: case_shape_set_count(shape, 1 + random_below(random, 40)); break;
    case CASE_CYLINDER:
    case CASE_CONE:
      shape->size.x = shape->size.y = any_number(random);
      shape->size.z = any_number(random);
      break;
    default:
      shape->size.x = any_number(random);
      shape->size.y = any_number(random);
      shape->size.z = any_number(random);
      break;
  }
  for (size_t i = 0; i < shape->count; i++) {
    shape->vertices[i].x = any_number(random);
    shape->vertices[i].y = any_number(random);
    shape->vertices[i].z = any_number(random);
  }
  case_shape_set_faces(shape,
                       shape->kind == CASE_HULL && random_below(random, 2) == 0 ? 1 + random_below(random, 9) : 0);
  for (size_t i = 0, k = 0; i < shape->faces; i++) {
    for (uint32_t left = 1 + random_below(random, GJK_FACE_CORNERS_MAX); left > 0; left--) {
      shape->corners[k++] = (uint16_t)any_number(random);
    }
    shape->ends[i] = (uint16_t)k;
  }
  shape->convex_radius = random_below(random, 2) == 0 ? 0 : any_number(random);
  shape->pose.position.x = any_number(random);
  shape->pose.position.y = any_number(random);
  shape->pose.position.z = any_number(random);
  shape->pose.rotation.x = any_number(random);
  shape->pose.rotation.w = any_number(random);
}

static bool same_vec3(gjk_vec3 a, gjk_vec3 b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

static bool same_shape(const case_shape *a, const case_shape *b) {
  bool same = a->kind == b->kind && same_vec3(a->size, b->size) && a->convex_radius == b->convex_radius &&
              a->count == b->count && same_vec3(a->pose.position, b->pose.position) &&
              memcmp(&a->pose.rotation, &b->pose.rotation, sizeof a->pose.rotation) == 0;
  for (size_t i = 0; same && i < a->count; i++) {
    same = same_vec3(a->vertices[i], b->vertices[i]);
  }
  same = same && a->faces == b->faces;
  for (size_t i = 0; same && i < a->faces; i++) {
    same = a->ends[i] == b->ends[i];
  }
  return same && (a->faces == 0 || memcmp(a->corners, b->corners, a->ends[a->faces - 1] * sizeof a->corners[0]) == 0);
}

// What case_print writes, the reader reads; the reader's storage is that of the case before.
static void test_round_trip(random_state *random) {
  enum { CASES = 500 };
  random_state again = *random;
  case_pair written = {0}, read = {0};
  case_reader reader;
  FILE *file = tmpfile();
  CHECK(file != NULL);
  if (file == NULL) {
    return;
  }
  for (int i = 0; i < CASES; i++) {
    snprintf(written.id, sizeof written.id, "n%d", i);
    random_case_shape(random, &written.a);
    random_case_shape(random, &written.b);
    case_print(file, &written);
  }
  rewind(file);
  case_reader_open(&reader, file, "round trip");
  for (int i = 0; i < CASES; i++) {
    char id[16];
    snprintf(id, sizeof id, "n%d", i);
    random_case_shape(&again, &written.a);
    random_case_shape(&again, &written.b);
    bool found = case_reader_next(&reader, &read);
    CHECK_MSG(found, "case %d", i);
    CHECK_MSG(strcmp(read.id, id) == 0, "case %d", i);
    CHECK_MSG(same_shape(&written.a, &read.a), "case %d", i);
    CHECK_MSG(same_shape(&written.b, &read.b), "case %d", i);
  }
  CHECK(!case_reader_next(&reader, &read));
  CHECK(reader.errors == 0);
  case_pair_free(&written);
  case_pair_free(&read);
  fclose(file);
}

static void test_copy(random_state *random) {
  case_shape from = {0}, to = {0};
  for (int i = 0; i < 100; i++) {
    random_case_shape(random, &from);
    case_shape_copy(&to, &from);
    CHECK(same_shape(&from, &to));
    CHECK(from.count == 0 || from.vertices != to.vertices);
  }
  case_shape_free(&from);
  case_shape_free(&to);
}

static void test_build(void) {
  case_shape shape = {0};
  case_collider collider = {0};
  case_shape_reset(&shape);
  shape.kind = CASE_HULL;
  case_shape_set_count(&shape, GJK_HULL_VERTICES_MAX);
  memset(shape.vertices, 0, shape.count * sizeof shape.vertices[0]);
  CHECK(case_collider_build(&collider, &shape, false) == GJK_OK);
  CHECK(collider.collider.buffer != NULL);
  CHECK(case_collider_build(&collider, &shape, true) == GJK_OK);
  CHECK(collider.collider.buffer == NULL);
  case_shape_set_count(&shape, (size_t)GJK_HULL_VERTICES_MAX + 1);
  CHECK(case_collider_build(&collider, &shape, false) == GJK_ERROR_RANGE);
  case_shape_set_count(&shape, 0);
  CHECK(case_collider_build(&collider, &shape, false) == GJK_ERROR_EMPTY);
  shape.kind = CASE_POINT;
  shape.convex_radius = -1;
  CHECK(case_collider_build(&collider, &shape, false) == GJK_ERROR_NEGATIVE);
  shape.convex_radius = 0;
  shape.pose.rotation.x = GJK_Q30_ONE;
  CHECK(case_collider_build(&collider, &shape, false) == GJK_ERROR_ROTATION);
  case_collider_free(&collider);
  case_shape_free(&shape);
}

int main(void) {
  random_state random = random_seed(check_seed(SEED));
  test_numbers();
  test_decimals(&random);
  test_round_trip(&random);
  test_copy(&random);
  test_build();
  return check_done("case");
}
