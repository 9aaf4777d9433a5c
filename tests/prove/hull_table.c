// gjk_hull_table_make and gjk_hull_table_check at level CASE, and at levels that are none, on any vertices, capacity and
// table whose lists lie within entries, null pointers too.
#include "any.h"
#include "gjk/table.h"

#define VERTICES 5
#define ENTRIES 8

static gjk_vec3 vertices[VERTICES];
static uint16_t entries[ENTRIES], ends[GJK_TABLE_CELLS(GJK_TABLE_LEVEL_MAX)];

int main(void) {
  const gjk_vec3 *of = any_bool() ? vertices : NULL;
  const uint16_t count = (uint16_t)any_between(0, VERTICES);
  const uint8_t level = (uint8_t)(any_bool() ? CASE : any_between(GJK_TABLE_LEVEL_MAX + 1, UINT8_MAX));
  for (int i = 0; i < VERTICES; i++) {
    vertices[i] = any_position();
  }
  if (any_bool()) {
    (void)gjk_hull_table_make(of, count, level, any_bool() ? entries : NULL, (uint16_t)any_between(0, ENTRIES),
                              any_bool() ? ends : NULL);
    return 0;
  }
  const gjk_hull_table table = {any_bool() ? entries : NULL, any_bool() ? ends : NULL, level};
  for (int i = 0; i < ENTRIES; i++) {
    entries[i] = any_uint16();
  }
  for (int i = 0; i < GJK_TABLE_CELLS(GJK_TABLE_LEVEL_MAX); i++) {
    ends[i] = (uint16_t)any_between(0, ENTRIES);
  }
  (void)gjk_hull_table_check(of, count, any_bool() ? &table : NULL);
  return 0;
}
