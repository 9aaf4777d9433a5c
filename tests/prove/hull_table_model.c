// Stands in for gjk_hull_table.c: the check of a table may find a fault, and does where a number could be no vertex. The
// driver hull_table.c shows what the check itself does.
#include "any.h"
#include "src/shape/gjk_hull_table.h"

#define VERTICES 5

gjk_status gjk_table_measure(const gjk_hull_table *table, uint16_t count) {
  (void)table;
  return count != VERTICES || any_bool() ? GJK_ERROR_RANGE : GJK_OK;
}
