// Writes the cases of files as inputs of the fuzzers of pairs and of casts: seeds FOLDER FILE...
#include <stdlib.h>

#include "case/parse.h"

static void write_u8(FILE *file, unsigned value) {
  fputc((int)(value & 0xFFu), file);
}

static void write_i32(FILE *file, int32_t value) {
  for (unsigned i = 0; i < 32; i += 8) {
    write_u8(file, (uint32_t)value >> i);
  }
}

static void write_vec3(FILE *file, gjk_vec3 v) {
  write_i32(file, v.x);
  write_i32(file, v.y);
  write_i32(file, v.z);
}

static void write_shape(FILE *file, const case_shape *shape) {
  const gjk_quat q = shape->pose.rotation;
  write_u8(file, (unsigned)shape->kind);
  write_vec3(file, shape->size);
  write_i32(file, shape->convex_radius);
  write_vec3(file, shape->pose.position);
  write_i32(file, q.x);
  write_i32(file, q.y);
  write_i32(file, q.z);
  write_i32(file, q.w);
  write_u8(file, shape->count > 0 ? (unsigned)shape->count - 1 : 0);
  for (size_t i = 0; i < shape->count; i++) {
    write_vec3(file, shape->vertices[i]);
  }
}

// As casts.c reads it. A shape that stands has no way, so that inputs for pairs stay as they are.
static void write_way(FILE *file, const case_shape *shape) {
  write_u8(file, shape->moves ? 2 : 0);
  write_vec3(file, shape->end.position);
}

int main(int argc, char **argv) {
  static case_pair pair;
  static case_reader reader;
  unsigned number = 0;
  for (int i = 2; i < argc; i++) {
    FILE *in = fopen(argv[i], "r");
    if (in == NULL) {
      perror(argv[i]);
      return 1;
    }
    case_reader_open(&reader, in, argv[i]);
    while (case_reader_next(&reader, &pair)) {
      char name[1024];
      snprintf(name, sizeof name, "%s/%u", argv[1], number++);
      FILE *out = fopen(name, "wb");
      if (out == NULL) {
        perror(name);
        return 1;
      }
      write_shape(out, &pair.a);
      write_shape(out, &pair.b);
      if (pair.a.moves || pair.b.moves) {
        write_way(out, &pair.a);
        write_way(out, &pair.b);
        write_u8(out, 1);
      }
      fclose(out);
    }
    fclose(in);
  }
  case_pair_free(&pair);
  return number == 0;
}
