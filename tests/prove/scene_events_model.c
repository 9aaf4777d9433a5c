// Stands in for src/scene_update/gjk_scene_events.c and gjk_scene_report.c where bodies are swept: any events, and any
// reports of them, as tests/prove/scene_ops.c shows.
#include "scene_any.h"
#include "src/scene_update/gjk_scene_update.h"

void gjk_scene_make_events(gjk_scene_view *v) {
  gjk_scene_header *h = v->header;
  for (int i = 0; i < PAIRS; i++) {
    any_pair(&v->pairs[i]);
    v->queue[i] = any_below(PAIRS);
  }
  Frama_C_make_unknown((char *)&h->stats, sizeof h->stats);
  h->queued = any_below(PAIRS + 1);
  h->next_report = 0;
  h->gone = GJK_SCENE_NONE;
  h->moved = GJK_SCENE_NONE;
  h->phase = GJK_SCENE_REPORTING;
}

void gjk_scene_write_reports(gjk_scene_view *v, gjk_report *reports, uint32_t capacity, gjk_progress *progress) {
  gjk_scene_header *h = v->header;
  const int32_t ends = any_between(0, 1);
  //@ split ends;
  //@ assert progress->reports == 0;
  progress->reports = Frama_C_unsigned_long_interval(0, capacity);
  progress->reports_left = ends != 0 ? 0 : any_below(PAIRS) + 1;
  h->next_report = any_below(PAIRS + 1);
  if (ends != 0) {
    h->updates++;
    h->queued = 0;
    h->phase = GJK_SCENE_IDLE;
  }
}
