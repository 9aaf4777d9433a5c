// gjk_hull_table_make and gjk_hull_table_check on any vertices, capacity, table and level, null pointers too.
#include "any.h"
#include "gjk/table.h"

#define VERTICES 5
#define ENTRIES 8

enum { MAKE, CHECK };

static gjk_vec3 vertices[VERTICES];
static uint16_t entries[ENTRIES], ends[GJK_TABLE_CELLS(GJK_TABLE_LEVEL_MAX)];

int main(void) {
  const gjk_vec3 *of = any_bool() ? vertices : NULL;
  const uint16_t count = (uint16_t)any_between(0, VERTICES);
  const uint8_t level = (uint8_t)any_between(0, UINT8_MAX);
  for (int i = 0; i < VERTICES; i++) {
    vertices[i] = any_position();
  }
  if (CASE == MAKE) {
    (void)gjk_hull_table_make(of, count, level, any_bool() ? entries : NULL, (uint16_t)any_between(0, ENTRIES),
                              any_bool() ? ends : NULL);
  } else {
    const gjk_hull_table table = {any_bool() ? entries : NULL, any_bool() ? ends : NULL, level};
    for (int i = 0; i < ENTRIES; i++) {
      entries[i] = any_uint16();
    }
    for (int i = 0; i < GJK_TABLE_CELLS(GJK_TABLE_LEVEL_MAX); i++) {
      ends[i] = (uint16_t)any_between(0, ENTRIES);
    }
    (void)gjk_hull_table_check(of, count, any_bool() ? &table : NULL);
  }
  return 0;
}
