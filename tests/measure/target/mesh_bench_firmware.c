// Counts the instructions of contacts, distances and rays with a mesh of 10,082 triangles, and with the same ground as a height
// field.
#include "mesh_bench.h"

#include "count.h"
#include "print.h"

static void print_line(const char *name, bool field, uint32_t total, uint32_t most, unsigned manifolds,
                       uint32_t distance, uint32_t ray, unsigned hits) {
  board_print(name);
  board_print(field ? " on a height field: " : " on a mesh: ");
  print_decimal(board_print, total / MESH_BENCH_BODIES);
  board_print(" instructions for contacts, at most ");
  print_decimal(board_print, most);
  board_print(", ");
  print_decimal(board_print, manifolds * 10 / MESH_BENCH_BODIES);
  board_print(" tenths of a manifold; 1 unit above, distance ");
  print_decimal(board_print, distance / MESH_BENCH_BODIES);
  board_print(", ray ");
  print_decimal(board_print, ray / MESH_BENCH_BODIES);
  board_print(", which hit ");
  print_decimal(board_print, hits);
  board_print("\n");
}

int firmware_main(void) {
  static const char *const name[MESH_BENCH_KINDS] = {"turned box", "level box", "ball"};
  const uint32_t calibration = count_calibrate();
  if (calibration == 0 || !mesh_bench_make()) {
    board_print("the counter does not count instructions, or there is no mesh\n");
    return 1;
  }
  for (int field = 0; field < 2; field++) {
    for (int kind = 0; kind < MESH_BENCH_KINDS; kind++) {
      uint32_t total = 0, most = 0, distance = 0, ray = 0;
      unsigned manifolds = 0, hits = 0;
      for (unsigned i = 0; i < MESH_BENCH_BODIES; i++) {
        gjk_collider body;
        mesh_bench_place((mesh_bench_kind)kind, i, &body);
        uint32_t start = board_ticks();
        manifolds += mesh_bench_contacts(&body, field != 0);
        const uint32_t instructions = count_instructions(board_ticks() - start, calibration);
        total += instructions;
        most = instructions > most ? instructions : most;
        gjk_vec3 up = {body.position.x, body.position.y, body.position.z + GJK_Q16_ONE};
        (void)gjk_collider_move(&body, &up);
        start = board_ticks();
        (void)mesh_bench_distance(&body, field != 0);
        distance += count_instructions(board_ticks() - start, calibration);
        start = board_ticks();
        hits += mesh_bench_ray(&body, field != 0);
        ray += count_instructions(board_ticks() - start, calibration);
      }
      print_line(name[kind], field != 0, total, most, manifolds, distance, ray, hits);
    }
  }
  return 0;
}
