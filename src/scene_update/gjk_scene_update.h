// The steps of an update, as gjk_scene_update.c numbers them.
#ifndef GJK_SRC_SCENE_UPDATE_H
#define GJK_SRC_SCENE_UPDATE_H

#include "../scene/gjk_scene_pairs.h"

// Step 3: fills the queue with the pairs to be tested: those of bodies that moved, or all with retest_all.
void gjk_scene_fill_queue(gjk_scene_view *v);

// Step 4: tests at most this many pairs of the queue that are not tested yet, in order.
void gjk_scene_test_queue(gjk_scene_view *v, uint32_t tests);

// Steps 5 to 8: replaces the tested queue by the pairs to be reported, in the order of reports.
void gjk_scene_make_events(gjk_scene_view *v);

// Step 9: writes at most capacity reports, and sets progress. The last report ends the update.
void gjk_scene_write_reports(gjk_scene_view *v, gjk_report *reports, uint32_t capacity, gjk_progress *progress);

#endif
