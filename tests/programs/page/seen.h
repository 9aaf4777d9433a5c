// What a scene of the library sees of a side's pile: boxes, pairs that are near, and contacts, as the lines of gjk2/draw.h.
#ifndef PAGE_SEEN_H
#define PAGE_SEEN_H

#include <stdint.h>

// Puts a side's bodies and trough into a scene, updates and draws it. The pile stays as it is. Returns how many records
// are in page_seen_records. What has no room there is left out.
uint32_t page_seen_look(int side);

// Of each line and point its gjk_draw_role, then x and y of both ends, Q16.16, alike for a point. Stays until the next look.
const int32_t *page_seen_records(void);

#endif
