// Cases: their numbers, reading what was printed, building colliders.
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
    {.text = "0", .bits = 16, .good = true},
    {.text = "-1", .bits = 16, .good = true, .value = -1},
    {.text = "+7", .bits = 16, .good = true, .value = 7},
    {.text = "2147483647", .bits = 16, .good = true, .value = INT32_MAX},
    {.text = "-2147483648", .bits = 16, .good = true, .value = INT32_MIN},
    {.text = "2147483648", .bits = 16},
    {.text = "-2147483649", .bits = 16},
    {.text = "99999999999999999999999999", .bits = 16},
    {.text = "0000000000000000000000000012", .bits = 16, .good = true, .value = 12},
    {.text = "1.0", .bits = 16, .good = true, .value = 65536},
    {.text = "1.", .bits = 16, .good = true, .value = 65536},
    {.text = ".5", .bits = 16, .good = true, .value = 32768},
    {.text = "-0.5", .bits = 16, .good = true, .value = -32768},
    {.text = "0.7071067811865476", .bits = 30, .good = true, .value = 759250125},
    {.text = "-2.0", .bits = 30, .good = true, .value = INT32_MIN},
    {.text = "2.0", .bits = 30},
    {.text = "-32768.0", .bits = 16, .good = true, .value = INT32_MIN},
    {.text = "32767.99999", .bits = 16, .good = true, .value = INT32_MAX},
    {.text = "32767.999999", .bits = 16},  // rounds to 2^31
    {.text = "32768.0", .bits = 16},
    {.text = "1.5e1", .bits = 16, .good = true, .value = 983040},
    {.text = "15.0E-1", .bits = 16, .good = true, .value = 98304},
    {.text = "1.0e-99999", .bits = 16, .good = true},
    {.text = "0.0e99999", .bits = 16, .good = true},
    {.text = "1.0e999999", .bits = 16},
    {.text = "1.0e99999", .bits = 16},
    // 2^-17 is a tie. Its neighbours here differ from it by less than a double can tell.
    {.text = "0.00000762939453125", .bits = 16, .good = true, .value = 1},
    {.text = "-0.00000762939453125", .bits = 16, .good = true, .value = -1},
    {.text = "0.0000076293945312499999999999999999", .bits = 16, .good = true},
    {.text = "0.0000076293945312500000000000000001", .bits = 16, .good = true, .value = 1},
    {.text = "0.0000000000000000000000000000000000000000001", .bits = 16, .good = true},
    {.text = "", .bits = 16},
    {.text = ".", .bits = 16},
    {.text = "-", .bits = 16},
    {.text = "--1", .bits = 16},
    {.text = "1.2.3", .bits = 16},
    {.text = "1e5", .bits = 16},
    {.text = "1.0e", .bits = 16},
    {.text = "1.0e+", .bits = 16},
    {.text = "1.0e--2", .bits = 16},
    {.text = "1.0e 2", .bits = 16},
    {.text = "0x10", .bits = 16},
    {.text = "nan", .bits = 16},
    {.text = "inf", .bits = 16},
    {.text = "1,5", .bits = 16},
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

// Every Q16.16 number has a finite decimal. Reading that decimal gives the number again.
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
  shape->end = shape->pose;
  if (random_below(random, 2) == 0) {
    const gjk_vec3 to = {any_number(random), any_number(random), any_number(random)};
    case_shape_move_to(shape, &to);
    shape->end.rotation.y = random_below(random, 2) == 0 ? any_number(random) : 0;
  }
  shape->spin.y = random_below(random, 2) == 0 ? any_number(random) : 0;
}

static bool same_vec3(gjk_vec3 a, gjk_vec3 b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

static bool same_shape(const case_shape *a, const case_shape *b) {
  bool same = a->kind == b->kind && same_vec3(a->size, b->size) && a->convex_radius == b->convex_radius &&
              a->count == b->count && same_vec3(a->pose.position, b->pose.position) &&
              memcmp(&a->pose.rotation, &b->pose.rotation, sizeof a->pose.rotation) == 0;
  same = same && a->moves == b->moves && same_vec3(a->end.position, b->end.position) && same_vec3(a->spin, b->spin) &&
         memcmp(&a->end.rotation, &b->end.rotation, sizeof a->end.rotation) == 0;
  for (size_t i = 0; same && i < a->count; i++) {
    same = same_vec3(a->vertices[i], b->vertices[i]);
  }
  same = same && a->faces == b->faces;
  for (size_t i = 0; same && i < a->faces; i++) {
    same = a->ends[i] == b->ends[i];
  }
  return same && (a->faces == 0 || memcmp(a->corners, b->corners, a->ends[a->faces - 1] * sizeof a->corners[0]) == 0);
}

// The reader reads what case_print writes. It uses the memory of the case before again.
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

static void random_case2_shape(random_state *random, case2_shape *shape) {
  case2_shape_reset(shape);
  shape->kind = (case2_kind)random_below(random, CASE2_ELLIPSE + 1);
  switch (shape->kind) {
    case CASE2_BOX:
    case CASE2_ELLIPSE: shape->size.y = any_number(random);  // fall through
    case CASE2_SEGMENT: shape->size.x = any_number(random); break;
    case CASE2_TRIANGLE:
    case CASE2_POLYGON:
      case2_shape_set_count(shape, shape->kind == CASE2_TRIANGLE ? 3 : 1 + random_below(random, 40));
      for (size_t i = 0; i < shape->count; i++) {
        shape->vertices[i].x = any_number(random);
        shape->vertices[i].y = any_number(random);
      }
      break;
    default: break;
  }
  shape->convex_radius = random_below(random, 2) == 0 ? 0 : any_number(random);
  shape->pose.position.x = any_number(random);
  shape->pose.position.y = any_number(random);
  shape->pose.rotation.c = any_number(random);
  shape->pose.rotation.s = any_number(random);
  shape->end = shape->pose;
  if (random_below(random, 2) == 0) {
    const gjk2_vec to = {any_number(random), any_number(random)};
    case2_shape_move_to(shape, &to);
    shape->end.rotation.c = random_below(random, 2) == 0 ? any_number(random) : shape->pose.rotation.c;
  }
  shape->spin = random_below(random, 2) == 0 ? any_number(random) : 0;
}

static bool same_vec(gjk2_vec a, gjk2_vec b) {
  return a.x == b.x && a.y == b.y;
}

static bool same_shape2(const case2_shape *a, const case2_shape *b) {
  bool same = a->kind == b->kind && same_vec(a->size, b->size) && a->convex_radius == b->convex_radius &&
              a->count == b->count && same_vec(a->pose.position, b->pose.position) &&
              a->pose.rotation.c == b->pose.rotation.c && a->pose.rotation.s == b->pose.rotation.s;
  same = same && a->moves == b->moves && same_vec(a->end.position, b->end.position) && a->spin == b->spin &&
         a->end.rotation.c == b->end.rotation.c && a->end.rotation.s == b->end.rotation.s;
  for (size_t i = 0; same && i < a->count; i++) {
    same = same_vec(a->vertices[i], b->vertices[i]);
  }
  return same;
}

// The same of cases of the plane, every second one in a file with cases in space.
static void test_round_trip_of_plane(random_state *random) {
  enum { CASES = 500 };
  random_state again = *random;
  case2_pair written = {0}, read = {0};
  case_pair space = {.id = "space"}, space_read = {0};
  case_reader reader;
  FILE *file = tmpfile();
  CHECK(file != NULL);
  if (file == NULL) {
    return;
  }
  case_shape_reset(&space.a);
  case_shape_reset(&space.b);
  for (int i = 0; i < CASES; i++) {
    snprintf(written.id, sizeof written.id, "n%d", i);
    random_case2_shape(random, &written.a);
    random_case2_shape(random, &written.b);
    case2_print(file, &written);
    case_print(file, &space);
  }
  rewind(file);
  case_reader_open(&reader, file, "round trip");
  for (int i = 0; i < CASES; i++) {
    char id[16];
    snprintf(id, sizeof id, "n%d", i);
    random_case2_shape(&again, &written.a);
    random_case2_shape(&again, &written.b);
    CHECK_MSG(case_reader_next_any(&reader, &space_read, &read) == CASE_FOUND_PLANE, "case %d", i);
    CHECK_MSG(strcmp(read.id, id) == 0, "case %d", i);
    CHECK_MSG(same_shape2(&written.a, &read.a) && same_shape2(&written.b, &read.b), "case %d", i);
    CHECK_MSG(case_reader_next_any(&reader, &space_read, &read) == CASE_FOUND_SPACE, "case %d", i);
    CHECK(strcmp(space_read.id, "space") == 0);
  }
  CHECK(case_reader_next_any(&reader, &space_read, &read) == CASE_FOUND_NONE && reader.errors == 0);
  rewind(file);
  case_reader_open(&reader, file, "in space alone");
  CHECK(case_reader_next(&reader, &space_read) && reader.errors == 1);  // the first case, of the plane, is named
  case2_pair_free(&written);
  case2_pair_free(&read);
  case_pair_free(&space);
  case_pair_free(&space_read);
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
  test_round_trip_of_plane(&random);
  test_copy(&random);
  test_build();
  return check_done("case");
}
