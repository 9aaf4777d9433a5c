// gjk_scene_check: each way in which the pairs or the update of an otherwise sound block can be wrong, one at a time.
#include "scene_check.h"

static void test_pairs(void) {
  restore();
  gjk_scene_header *h = v.header;
  // Slots 0, 1 and 2 touch each other: part 1 is second in one pair and first in another.
  gjk_scene_pair *const p = &v.pairs[pair_of(0, 1)], *const q = &v.pairs[pair_of(1, 2)],
                        *const r = &v.pairs[pair_of(0, 2)];
  ACCEPTED(p->state = (uint8_t)((p->state & 31u) | 4u << GJK_SCENE_PAIR_CACHED));
  REFUSED(p->state = (uint8_t)((p->state & 31u) | 5u << GJK_SCENE_PAIR_CACHED));
  // That deep; where no depth is asked for, or none was found.
  ACCEPTED(p->gap = -1; h->most_detail = h->config.detail = GJK_DETAIL_DEPTH);
  ACCEPTED(p->gap = -1; h->most_detail = h->config.detail = GJK_DETAIL_DEPTH; p->outcome = GJK_SCENE_PENDING);
  for (unsigned detail = GJK_DETAIL_TOUCH; detail <= GJK_DETAIL_CONTACTS; detail++) {
    if (detail != GJK_DETAIL_DEPTH) {
      const uint8_t asked = (uint8_t)(GJK_BODY_DYNAMIC | detail << 4);
      ACCEPTED(h->most_detail = (uint8_t)detail; v.bodies[0].kind_detail = asked);
      REFUSED(h->most_detail = (uint8_t)detail; v.bodies[0].kind_detail = asked; p->gap = -1);
    }
  }
  ACCEPTED(h->most_detail = h->config.detail = GJK_DETAIL_DISTANCE);
  REFUSED(h->most_detail = h->config.detail = GJK_DETAIL_CONTACTS);  // without room for caches
  REFUSED(h->most_detail = h->config.detail = GJK_DETAIL_DEPTH; p->gap = -1; p->outcome = GJK_SCENE_COLD;
          p->state = (uint8_t)((p->state & ~GJK_SCENE_PAIR_NEAR) | GJK_SCENE_PAIR_NEAR_NOW));
  REFUSED(p->gap = -1; p->state = (uint8_t)(p->state & ~GJK_SCENE_PAIR_NEAR));
  ACCEPTED(p->gap = 0; p->state = (uint8_t)(p->state & ~GJK_SCENE_PAIR_NEAR));
  ACCEPTED(p->outcome = GJK_SCENE_COLD | GJK_SCENE_UNSETTLED);
  REFUSED(p->outcome = GJK_SCENE_OUTCOMES);
  REFUSED(p->outcome = GJK_SCENE_COLD | GJK_SCENE_NO_FLAG);
  ACCEPTED(p->outcome = GJK_SCENE_PENDING);
  REFUSED(p->outcome = GJK_SCENE_PENDING | GJK_SCENE_UNSETTLED);
  REFUSED(p->state = (uint8_t)(p->state | GJK_SCENE_PAIR_QUEUED));
  REFUSED(v.pairs[h->pairs.free].state = GJK_SCENE_PAIR_NEAR);  // near, but not there
  REFUSED(p->ends.linked.part[0] = h->parts.free);
  REFUSED(p->ends.linked.part[1] = h->parts.fresh);
  REFUSED(p->ends.linked.part[0] = p->ends.linked.part[1]);
  REFUSED(const uint32_t a = p->ends.linked.part[0]; p->ends.linked.part[0] = p->ends.linked.part[1];
          p->ends.linked.part[1] = a);
  // Lists that do not lead back.
  for (int i = 0; i < 2; i++) {
    REFUSED(p->ends.linked.next[i] = p->ends.linked.next[i] == GJK_SCENE_NONE ? 2 * pair_of(0, 2) + 1 : GJK_SCENE_NONE);
    REFUSED(p->ends.linked.previous[i] =
                p->ends.linked.previous[i] == GJK_SCENE_NONE ? 2 * pair_of(0, 2) + 1 : GJK_SCENE_NONE);
    REFUSED(p->ends.linked.next[i] = 2 * h->pairs.free);
    REFUSED(p->ends.linked.previous[i] = 2 * h->pairs.free);
  }
  REFUSED(part_of(0)->pairs = GJK_SCENE_NONE);
  REFUSED(part_of(0)->pairs = 2 * h->pairs.free);
  REFUSED(part_of(9)->pairs = 2 * h->pairs.free);  // of a part without pairs
  REFUSED(part_of(9)->pairs = part_of(0)->pairs);
  REFUSED(part_of(9)->pairs = 2 * h->pairs.fresh);
  // A ring, with the list's head in it or not.
  const uint32_t part = v.bodies[9].first;
  for (int headed = 0; headed < 2; headed++) {
    restore();
    const uint32_t index = h->pairs.free, link = 2 * index;
    gjk_scene_pair *const s = &v.pairs[index];
    h->pairs.free = s->ends.linked.part[0];
    h->pairs.count++;
    *s = *p;
    s->ends.linked.part[0] = part;
    s->ends.linked.part[1] = v.bodies[10].first;
    s->ends.linked.next[0] = s->ends.linked.previous[0] = headed != 0 ? link : GJK_SCENE_NONE;
    s->ends.linked.next[1] = s->ends.linked.previous[1] = GJK_SCENE_NONE;
    v.parts[part].pairs = link;
    v.parts[s->ends.linked.part[1]].pairs = link + 1;
    CHECK(gjk_scene_check(&scene) == (headed != 0 ? GJK_ERROR_CORRUPT : GJK_OK));
    s->ends.linked.next[0] = s->ends.linked.previous[0] = link;
    v.parts[part].pairs = GJK_SCENE_NONE;
    CHECK(gjk_scene_check(&scene) == GJK_ERROR_CORRUPT);
  }
  CHECK(q != r);
}

// Pairs whose end is still to be reported.
static void test_gone(void) {
  restore();
  const gjk_body_id first = gjk_scene_id_of(&v, 0);
  CHECK(gjk_scene_remove(&scene, first) == GJK_OK);
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  gjk_scene_header *h = v.header;
  memcpy(sound, block, sizeof block);
  const uint32_t gone = h->gone, second = v.pairs[gone].ends.linked.previous[0], other = pair_of(1, 2);
  CHECK(second != GJK_SCENE_NONE);
  CHECK(v.pairs[second].ends.linked.previous[0] == GJK_SCENE_NONE);
  REFUSED(h->gone = second);
  REFUSED(h->gone = GJK_SCENE_NONE);
  REFUSED(h->gone = other);
  REFUSED(h->gone = h->pairs.fresh);
  REFUSED(v.pairs[second].ends.linked.previous[0] = gone);
  REFUSED(v.pairs[gone].state = GJK_SCENE_PAIR_LIVE | GJK_SCENE_PAIR_GONE);
  REFUSED(v.pairs[other].ends.linked.next[0] = 2 * gone);
  REFUSED(v.pairs[other].ends.linked.next[1] = 2 * gone);
  REFUSED(v.pairs[other].ends.linked.previous[0] = 2 * gone);
  REFUSED(v.pairs[other].ends.linked.previous[1] = 2 * gone);
}

// A sound block in which slots 0 to 2 have moved apart, and their update has begun. Returns how many pairs it tests.
static uint32_t begin_update(void) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  uint32_t pairs = 0;
  build();
  pose.position.y = 1;
  for (uint32_t slot = 0; slot < 3; slot++) {
    pose.position.x = (gjk_q16)slot * (3 * ONE);
    CHECK(gjk_scene_teleport(&scene, gjk_scene_id_of(&v, slot), &pose) == GJK_OK);
  }
  memcpy(sound, block, sizeof block);
  REFUSED(v.header->phase = GJK_SCENE_REPORTING + 1);
  REFUSED(v.header->queued = 1);
  restore();
  CHECK(gjk_scene_update_begin(&scene, &pairs) == GJK_OK);
  CHECK(gjk_scene_check(&scene) == GJK_OK);
  memcpy(sound, block, sizeof block);
  return pairs;
}

static void test_testing(void) {
  CHECK(begin_update() == 3);
  gjk_scene_header *h = v.header;
  gjk_scene_pair *const first = &v.pairs[v.queue[0]], *const last = &v.pairs[v.queue[2]];
  ACCEPTED(h->next_test = 1; first->outcome = GJK_SCENE_COLD);
  ACCEPTED(last->outcome = GJK_SCENE_COLD);
  REFUSED(h->next_test = 1);  // not tested
  REFUSED(h->next_test = 3; first->outcome = last->outcome = GJK_SCENE_COLD);
  REFUSED(h->next_test = 4);
  REFUSED(h->queued = h->pairs.capacity + 1);
  REFUSED(v.queue[2] = h->pairs.free);
  REFUSED(v.queue[0] = h->pairs.fresh);
  // As deep as this update's test says, where it was done.
  restore();
  h->most_detail = h->config.detail = GJK_DETAIL_DEPTH;
  first->gap = -1;
  memcpy(sound, block, sizeof block);
  ACCEPTED((void)0);
  REFUSED(first->state = (uint8_t)(first->state & ~GJK_SCENE_PAIR_NEAR));
  REFUSED(first->outcome = GJK_SCENE_COLD);
  ACCEPTED(first->outcome = GJK_SCENE_COLD; first->state |= GJK_SCENE_PAIR_NEAR_NOW);
  REFUSED(first->state = (uint8_t)((first->state & ~GJK_SCENE_PAIR_NEAR) | GJK_SCENE_PAIR_NEAR_NOW));
  // Twice, not flagged, flagged but not in the queue.
  REFUSED(v.queue[2] = v.queue[0]);
  REFUSED(first->state = (uint8_t)(first->state & ~GJK_SCENE_PAIR_QUEUED));
  REFUSED(h->queued = 2);
  ACCEPTED(h->queued = 2; last->state = (uint8_t)(last->state & ~GJK_SCENE_PAIR_QUEUED));
  // Refused blocks are as they were, too.
  restore();
  v.queue[2] = v.queue[0];
  memcpy(sound, block, sizeof block);
  CHECK(gjk_scene_check(&scene) == GJK_ERROR_CORRUPT);
  CHECK(memcmp(sound, block, sizeof block) == 0);
}

// An update of no pairs.
static void test_testing_none(void) {
  static const gjk_scene_config empty = {1, 1, 0, 1, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 0, 0};
  uint32_t pairs = 1;
  CHECK(gjk_scene_init(&scene, &empty, block, sizeof block, shapes, 2, NULL) == GJK_OK);
  CHECK(gjk_scene_update_begin(&scene, &pairs) == GJK_OK);
  CHECK(pairs == 0);
  CHECK(gjk_scene_check(&scene) == GJK_OK);
}

static void test_reporting(void) {
  gjk_report report;
  gjk_progress progress;
  CHECK(begin_update() == 3);
  CHECK(gjk_scene_update(&scene, &report, 1, &progress) == GJK_OK);
  CHECK(progress.reports_left == 2);
  gjk_scene_header *h = v.header;
  memcpy(sound, block, sizeof block);
  ACCEPTED((void)0);
  REFUSED(h->next_report = 4);
  ACCEPTED(h->next_report = 0; h->queued = 1; v.queue[0] = v.queue[1]);
  REFUSED(h->phase = GJK_SCENE_IDLE; h->queued = 1; v.queue[0] = v.queue[1]);
  ACCEPTED(h->next_report = 3);
  ACCEPTED(v.queue[0] = h->pairs.fresh);  // reported already
  ACCEPTED(v.queue[0] = v.queue[1]);
  REFUSED(v.queue[1] = h->pairs.fresh);
  REFUSED(v.queue[2] = v.queue[1]);
  gjk_scene_pair *const next = &v.pairs[v.queue[1]];
  REFUSED(next->outcome = 0);
  ACCEPTED(next->outcome = GJK_EVENT_BEGIN);
  REFUSED(next->outcome = GJK_EVENT_END + 1);
  REFUSED(next->state |= GJK_SCENE_PAIR_QUEUED);
}

// Pairs whose end is being reported, of a body that was removed.
static void test_reporting_gone(void) {
  gjk_report report;
  gjk_progress progress;
  build();
  CHECK(gjk_scene_remove(&scene, gjk_scene_id_of(&v, 0)) == GJK_OK);
  CHECK(gjk_scene_update(&scene, &report, 1, &progress) == GJK_OK);
  CHECK(progress.reports_left == 1);
  memcpy(sound, block, sizeof block);
  gjk_scene_header *h = v.header;
  gjk_scene_pair *const gone = &v.pairs[v.queue[1]];
  ACCEPTED((void)0);
  REFUSED(h->gone = v.queue[1]; gone->ends.linked.previous[0] = GJK_SCENE_NONE);
  REFUSED(h->gone = v.queue[1]; gone->ends.linked.previous[0] = GJK_SCENE_NONE; h->next_report = 2);
  REFUSED(h->next_report = 2);  // never reported
  REFUSED(gone->outcome = GJK_EVENT_BEGIN);
  // Tested, as if it had parts.
  const uint32_t other = pair_of(1, 2);
  REFUSED(h->phase = GJK_SCENE_TESTING; h->next_test = 0; h->gone = v.queue[1]; h->queued = 1; v.queue[0] = h->gone;
          gone->ends.linked.previous[0] = GJK_SCENE_NONE; gone->state |= GJK_SCENE_PAIR_QUEUED);
  ACCEPTED(h->phase = GJK_SCENE_TESTING; h->next_test = 0; h->gone = v.queue[1]; h->queued = 1; v.queue[0] = other;
           gone->ends.linked.previous[0] = GJK_SCENE_NONE; v.pairs[other].state |= GJK_SCENE_PAIR_QUEUED);
}

// A body whose motion is kept, in an update that has not swept it yet: what it names must be no part. Reports would read it.
static void test_kept(void) {
  static const gjk_scene_config moving = {2, 2, 0, 8, 0, GJK_DETAIL_TOUCH, 0, 0, 0, 0, 2};
  static const gjk_scene_bindings bindings = {.motion = &gjk_scene_motion};
  const gjk_part part = {0, false, GJK_POSE_IDENTITY};
  const gjk_body_setup setup = {GJK_POSE_IDENTITY, &part, 1, GJK_BODY_DYNAMIC, GJK_DETAIL_TOUCH, 1, 1, 0, 0};
  const gjk_pose ahead = {{2 * ONE, 0, 0}, {0, 0, 0, GJK_Q30_ONE}};
  gjk_body_id body, other;
  gjk_report report;
  gjk_progress progress;
  CHECK(gjk_scene_init(&scene, &moving, block, sizeof block, shapes, 2, &bindings) == GJK_OK);
  CHECK(gjk_scene_add(&scene, &setup, &body) == GJK_OK);
  CHECK(gjk_scene_add(&scene, &setup, &other) == GJK_OK);
  CHECK(gjk_scene_set_motion(&scene, body, GJK_MOTION_FAST) == GJK_OK);
  CHECK(gjk_scene_teleport(&scene, other, &ahead) == GJK_OK);
  CHECK(gjk_scene_move(&scene, body, &ahead) == GJK_OK);
  CHECK(gjk_scene_update_slice(&scene, 0, NULL, 0, &progress) == GJK_OK);
  CHECK(progress.pairs_left == 2);
  CHECK(gjk_scene_view_of(&scene, &v) == GJK_OK);
  memcpy(sound, block, sizeof block);
  ACCEPTED((void)0);
  REFUSED(v.kept[0].other = v.header->parts.fresh);
  REFUSED(v.kept[0].other = GJK_SCENE_NONE - 1);
  REFUSED(v.kept[0].other = 1);  // a part, but nothing met it
  REFUSED(v.kept[0].other = v.header->parts.fresh; v.kept[0].state = GJK_SCENE_SWEPT);
  ACCEPTED(v.kept[0].other = 1; v.kept[0].state = GJK_SCENE_SWEPT);
  // Swept, while the pairs are reported.
  restore();
  CHECK(gjk_scene_update(&scene, &report, 0, &progress) == GJK_OK);
  CHECK(v.header->phase == GJK_SCENE_REPORTING);
  CHECK(v.kept[0].other == 1);
  memcpy(sound, block, sizeof block);
  ACCEPTED((void)0);
  REFUSED(v.kept[0].other = v.header->parts.fresh);
  REFUSED(v.kept[0].other = v.header->parts.fresh; v.kept[0].state = 0);
  // Done: what it met is not read again.
  restore();
  CHECK(gjk_scene_update_each(&scene, scene_ignore, NULL) == GJK_OK);
  CHECK(v.header->phase == GJK_SCENE_IDLE);
  memcpy(sound, block, sizeof block);
  ACCEPTED(v.kept[0].other = v.header->parts.fresh);
}

int main(void) {
  build();
  test_kept();
  build();
  test_pairs();
  test_gone();
  test_testing();
  test_reporting();
  test_reporting_gone();
  test_testing_none();
  return check_done("scene_check_update");
}
