// The update: finds which pairs of parts are near, and reports what changed.
//
// 1. Check that the bindings have what the details asked for need. Otherwise nothing is done.
// 2. Match the pairs to the boxes: make those whose enlarged boxes came to meet, drop those whose boxes parted
//    (gjk_scene_pairs.c). Where there is no room for them, the update does not begin.
// 3. Fill the queue with the pairs of the bodies that moved. No other pair can have changed (gjk_scene_queue.c).
// 4. Test the pairs in the queue, in slices or by several threads (gjk_scene_narrow_phase.c).
//    Then sweep the fast bodies (gjk_scene_motion.c).
// 5. Start the statistics of this update (gjk_scene_events.c).
// 6. Turn what the tests found into events: begin, persist, end. Pairs that rest near may persist, and pairs that are
//    gone end. The pairs with an event replace the queue.
// 7. Forget which bodies moved, and how far. Kept motions start from where their bodies are now.
// 8. Sort the events into the order of reports.
// 9. Report, as many as fit in each call. Pairs that were kept only for their report are dropped (gjk_scene_report.c).
//    Impacts follow.
//
// header.phase says how far an update has come: IDLE before step 2, TESTING until all pairs are tested, REPORTING until
// all events are reported.
#include "gjk_scene_update.h"

// Step 1.
static gjk_status check_details(const gjk_scene_view *v) {
  const uint32_t most = v->header->most_detail;
  const bool lacking = gjk_scene_lacks(v->scene->bindings.details, most) ||
                       (most > GJK_DETAIL_DISTANCE && !gjk_scene_has_workspace(v->scene));
  return lacking || (v->header->kept > 0 && v->scene->bindings.motion == NULL) ? GJK_ERROR_UNSUPPORTED : GJK_OK;
}

// Steps 1 to 3, unless an update is under way.
static gjk_status begin(gjk_scene_view *v) {
  gjk_scene_header *h = v->header;
  const gjk_status able = check_details(v);
  if (able != GJK_OK) {
    return able;
  }
  h->sealed = 0;
  if (h->phase != GJK_SCENE_IDLE) {
    return GJK_OK;
  }
  const gjk_status status = gjk_scene_pairs_match(v);  // Step 2
  if (status == GJK_OK) {
    gjk_scene_fill_queue(v);  // Step 3
    if (h->kept > 0) {
      v->scene->bindings.motion->prepare(v);
    }
    h->phase = GJK_SCENE_TESTING;
  }
  return status;
}

gjk_status gjk_scene_update_slice(gjk_scene *scene, uint32_t tests, gjk_report *reports, uint32_t capacity,
                                  gjk_progress *progress) {
  gjk_scene_view v;
  gjk_status status = gjk_scene_view_of(scene, &v);
  if (status == GJK_OK && (progress == NULL || (reports == NULL && capacity > 0))) {
    status = GJK_ERROR_NULL;
  }
  if (status == GJK_OK) {
    status = begin(&v);
  }
  if (status != GJK_OK) {
    return status;
  }
  progress->reports = 0;
  progress->pairs_left = 0;
  if (v.header->kept > 0) {
    scene->bindings.motion->update(&v, tests, reports, capacity, progress);
    return GJK_OK;
  }
  if (v.header->phase == GJK_SCENE_TESTING) {
    gjk_scene_test_queue(&v, tests);  // Step 4
    progress->pairs_left = v.header->queued - v.header->next_test;
    progress->reports_left = 0;
    if (progress->pairs_left > 0) {
      return GJK_OK;
    }
    gjk_scene_make_events(&v);  // Steps 5 to 8
  }
  gjk_scene_write_reports(&v, reports, capacity, progress);  // Step 9
  return GJK_OK;
}

gjk_status gjk_scene_update(gjk_scene *scene, gjk_report *reports, uint32_t capacity, gjk_progress *progress) {
  return gjk_scene_update_slice(scene, UINT32_MAX, reports, capacity, progress);
}

gjk_status gjk_scene_update_each(gjk_scene *scene, gjk_report_function *function, void *user) {
  gjk_report report;
  gjk_progress progress = {0, 0, 0};
  if (function == NULL) {
    return GJK_ERROR_NULL;
  }
  do {  // ends: each call but the last writes a report
    const gjk_status status = gjk_scene_update(scene, &report, 1, &progress);
    if (status != GJK_OK) {
      return status;
    }
    if (progress.reports > 0) {
      function(user, &report);
    }
  } while (progress.reports_left > 0);
  return GJK_OK;
}

gjk_status gjk_scene_update_begin(gjk_scene *scene, uint32_t *pairs) {
  gjk_scene_view v;
  gjk_status status = gjk_scene_view_of(scene, &v);
  if (status == GJK_OK && pairs == NULL) {
    status = GJK_ERROR_NULL;
  }
  if (status == GJK_OK) {
    status = v.header->phase == GJK_SCENE_REPORTING ? GJK_ERROR_BUSY : begin(&v);
  }
  if (status == GJK_OK) {
    *pairs = v.header->queued;
  }
  return status;
}

gjk_status gjk_scene_test_pairs(gjk_scene *scene, uint32_t first, uint32_t end) {
  gjk_scene_view v;
  const gjk_status status = gjk_scene_view_of(scene, &v);
  if (status != GJK_OK) {
    return status;
  }
  if (v.header->phase != GJK_SCENE_TESTING || first > end || end > v.header->queued) {
    return GJK_ERROR_RANGE;
  }
  const gjk_status able = check_details(&v);
  if (able != GJK_OK) {
    return able;
  }
  for (uint32_t i = first; i < end; i++) {  // Step 4, for these pairs
    gjk_scene_narrow_phase(&v, &v.pairs[v.queue[i]]);
  }
  return GJK_OK;
}

gjk_status gjk_scene_get_stats(const gjk_scene *scene, gjk_scene_stats *out) {
  gjk_scene_view v;
  gjk_status status = gjk_scene_view_of(scene, &v);
  if (status == GJK_OK && out == NULL) {
    status = GJK_ERROR_NULL;
  }
  if (status == GJK_OK) {
    const gjk_scene_counters *s = &v.header->stats;
    out->bodies = v.header->bodies.count;
    out->parts = v.header->parts.count;
    out->pairs = s->pairs;
    out->refused = s->refused;
    out->resting = s->resting;
    out->filtered = s->filtered;
    out->motion = s->motion;
    out->boxes = s->boxes;
    out->direction = s->direction;
    out->warm = s->warm;
    out->cold = s->cold;
    out->begun = s->begun;
    out->persisting = s->persisting;
    out->ended = s->ended;
    out->unsettled = s->unsettled;
    out->updates = v.header->updates;
    out->measured = s->measured;
    out->manifolds = s->manifolds;
  }
  return status;
}
