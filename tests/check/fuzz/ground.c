// Ground of the plane of any make: chains that fold back and cross themselves, profiles with holes, grids; also as constants
// that no call has checked, with an index of any content. Calls must end, keep to their memory and return a status that
// they may. A search of all segments judges distances; an index changes no answer.
#include <stdlib.h>
#include <string.h>

#include "gjk2/gjk2.h"
#include "gjk2/ground.h"
#include "gjk2/slide.h"
#include "hostile.h"

#define VERTICES 40u
#define CELLS 12u
#define FORMS 5u
#define CONTACTS 8
#define WORDS 2000

static fuzz_bytes bytes;
static gjk2_vec *vertices;
static int16_t *heights;
static uint8_t *cells;
static gjk2_index_box *boxes;
static gjk2_tile forms[FORMS];
static gjk2_polyline chain;
static gjk2_index chain_index;
static gjk2_heights profile;
static gjk2_tiles tiles;
static gjk2_ground ground;
static gjk2_shape ground_shape;
static gjk2_pose at;

static uint32_t below(uint32_t most) {
  return fuzz_u8(&bytes) % most;
}

static gjk2_vec any_vec(unsigned shift) {
  gjk2_vec v;
  v.x = fuzz_i32(&bytes) >> shift;
  v.y = fuzz_i32(&bytes) >> shift;
  return v;
}

// All on the heap and as long as said, so that a sanitizer sees what is read beyond.
static void *room_for(size_t count, size_t size) {
  return malloc(count > 0 ? count * size : 1);
}

static void make_chain(void) {
  const uint32_t count = below(VERTICES + 1);
  const unsigned shift = 3 + below(29);
  vertices = room_for(count, sizeof *vertices);
  for (uint32_t i = 0; i < count; i++) {  // some come again: segments without a length, or back the same way
    vertices[i] = i > 0 && below(4) == 0 ? vertices[i - 1 - below(i < 3 ? i : 3)] : any_vec(shift);
  }
  chain.vertices = MAYBE(vertices);
  chain.count = (uint16_t)count;
  chain.index = NULL;
  boxes = room_for(GJK2_INDEX_BOXES(count), sizeof *boxes);
  ASK(chain_index, gjk2_index_build(MAYBE(&chain), boxes, GJK2_INDEX_BOXES(count), &chain_index));
}

static void make_profile(void) {
  const uint32_t count = below(VERTICES + 1);
  heights = room_for(count, sizeof *heights);
  for (uint32_t i = 0; i < count; i++) {
    heights[i] = below(8) == 0 ? GJK2_HOLE : (int16_t)(fuzz_i32(&bytes) >> 16);
  }
  profile.heights = MAYBE(heights);
  profile.count = (uint16_t)count;
  profile.width = fuzz_i32(&bytes) >> below(32);
  profile.shift = (uint8_t)below(16);
}

static void make_tiles(void) {
  const uint32_t columns = below(CELLS + 1), rows = below(CELLS + 1);
  cells = room_for(columns * rows, 1);
  for (uint32_t i = 0; i < columns * rows; i++) {
    cells[i] = (uint8_t)below(FORMS + 2);
  }
  for (uint32_t i = 0; i < FORMS; i++) {
    const gjk2_tile form = {(uint8_t)below(6), (uint8_t)below(6), fuzz_u8(&bytes), below(4) == 0};
    forms[i] = form;
  }
  tiles.cells = MAYBE(cells);
  tiles.columns = (uint16_t)columns;
  tiles.rows = (uint16_t)rows;
  tiles.size = below(2) == 0 ? 4 << below(24) : fuzz_i32(&bytes) >> below(32);
  tiles.form_count = (uint8_t)below(FORMS + 1);
  tiles.forms = MAYBE(forms);
}

// Ground as a constant, which nothing has checked.
static void forge(unsigned kind) {
  ground.type = MAYBE(kind == 0 ? &gjk2_ground_chain : kind == 1 ? &gjk2_ground_heights : &gjk2_ground_tiles);
  ground.data = kind == 0 ? (void *)&chain : kind == 1 ? (void *)&profile : (void *)&tiles;
  ground.centre = any_vec(below(32));
  const gjk2_shape shape = GJK2_GROUND(&ground, fuzz_i32(&bytes) >> below(32), fuzz_i32(&bytes) >> below(32));
  ground_shape = shape;
  if (kind == 0 && below(2) == 0) {  // an index of another chain
    chain.index = &chain_index;
    chain_index.boxes = boxes;
    chain_index.corner = any_vec(below(32));
    chain_index.shift = (uint8_t)below(20);
    for (unsigned i = below(8); i > 0; i--) {
      boxes[below(GJK2_INDEX_BOXES(chain.count))].lower_x = (uint16_t)fuzz_i32(&bytes);
    }
  }
}

// Makes ground. True: it is checked, and all its segments are there.
static bool make_ground(void) {
  const unsigned kind = below(3);
  make_chain();
  make_profile();
  make_tiles();
  if (below(4) == 0) {
    forge(kind);
    return false;
  }
  memset(&ground, HOSTILE_POISON, sizeof ground);
  const gjk_status status = kind == 0   ? gjk2_ground_of_chain(&chain, &ground, &ground_shape)
                            : kind == 1 ? gjk2_ground_of_heights(&profile, &ground, &ground_shape)
                                        : gjk2_ground_of_tiles(&tiles, &ground, &ground_shape);
  hostile_check(status, &ground, sizeof ground);
  if (status != GJK_OK) {
    forge(kind);
  }
  return status == GJK_OK;
}

static gjk_status make_body(gjk2_collider *body, gjk2_vec *buffer) {
  static gjk2_shape shape;
  static gjk2_vec corner[5];
  const unsigned shift = below(32);
  const gjk_q16 x = (gjk_q16)((uint32_t)fuzz_i32(&bytes) >> (3 + below(29))), radius = below(2) == 0 ? 0 : x / 3;
  const gjk2_rotation raw = {fuzz_i32(&bytes), fuzz_i32(&bytes)};
  gjk2_pose pose = GJK2_POSE_IDENTITY;
  for (int i = 0; i < 5; i++) {
    corner[i] = any_vec(5 + shift % 27);
  }
  const gjk2_shape kinds[] = {GJK2_CIRCLE(x), GJK2_CAPSULE(radius, x), GJK2_ROUNDED_BOX(x, x / 2, radius),
                              GJK2_ROUNDED_POLYGON(corner, 5, radius), GJK2_ELLIPSE(x / 2 + 1, x / 3 + 1)};
  shape = kinds[below(5)];
  (void)gjk2_rotation_normalize(&raw, &pose.rotation);  // of 0: stays the identity
  pose.position = any_vec(shift);
  const gjk_status status = gjk2_collider_init(body, &shape, buffer, 5);
  return status == GJK_OK ? gjk2_collider_pose(body, &pose) : status;
}

// The nearest segment in front, by a search of all.
typedef struct nearest {
  const gjk2_collider *body;
  bool found;
  gjk_q16 distance;
  uint32_t segments;
} nearest;

static void look_at(void *user, const gjk2_vec *from, const gjk2_vec *to, uint32_t segment) {
  nearest *n = user;
  const gjk2_vec ends[2] = {*from, *to};
  const gjk2_shape line = GJK2_POLYGON(ends, 2);
  const gjk2_pose origin = GJK2_POSE_IDENTITY;
  const gjk2_vec c = n->body->centre;
  gjk2_collider collider;
  gjk2_distance_result gap;
  (void)segment;
  n->segments++;
  // Segments are below 2^29, differences below 2^33.
  const int64_t side =
      ((int64_t)to->x - from->x) * ((int64_t)c.y - from->y) - ((int64_t)to->y - from->y) * ((int64_t)c.x - from->x);
  if (side > 0) {
    return;  // the centre is to the left
  }
  if (gjk2_collider_init(&collider, &line, NULL, 0) == GJK_OK && gjk2_collider_pose(&collider, &origin) == GJK_OK &&
      gjk2_distance(&collider, n->body, NULL, &gap) == GJK_OK && (!n->found || gap.distance < n->distance)) {
    n->found = true;
    n->distance = gap.distance;
  }
}

static void check_distance(const gjk2_collider *body, bool exact) {
  const gjk2_aabb everywhere = {{INT32_MIN, INT32_MIN}, {INT32_MAX, INT32_MAX}};
  nearest all = {body, false, 0, 0};
  gjk2_distance_result gap;
  uint32_t segment = 0;
  bool found = false, yes = false;
  const gjk_status status = gjk2_ground_distance(&ground, &at, body, &gap, &segment, &found);
  const gjk_status seen = gjk2_ground_visit(&ground, &at, &everywhere, look_at, &all);
  if (status != GJK_OK || !exact) {
    return;
  }
  if (seen != GJK_OK || found != all.found || (found && gap.distance != all.distance)) {
    fuzz_fail("not the nearest segment");
  }
  if (found && gap.distance < INT32_MAX &&
      (gjk2_ground_within(&ground, &at, body, gap.distance + 1, &yes) != GJK_OK || !yes)) {
    fuzz_fail("the nearest segment is not within its distance");
  }
  if (found && gap.distance > 0 && (gjk2_ground_within(&ground, &at, body, gap.distance - 1, &yes) != GJK_OK || yes)) {
    fuzz_fail("a segment is nearer than the nearest");
  }
}

static uint64_t mix(uint64_t hash, int32_t value) {
  return (hash ^ (uint32_t)value) * UINT64_C(0x100000001B3);
}

// Asks every query. The hash of what they answer.
static uint64_t ask_all(const gjk2_collider *body, const gjk2_vec *to, const gjk2_vec *from, gjk_q16 margin) {
  const gjk2_cast_path path = {NULL, to, margin}, moving = {from, to, margin};
  gjk2_chain_contact contact[CONTACTS];
  gjk2_cast_result hit;
  uint32_t segment = 0;
  uint16_t count = 0;
  bool yes = false;
  uint64_t hash = 7;
  gjk_status status = gjk2_ground_within(&ground, &at, body, margin, &yes);
  hostile_check(status, NULL, 0);
  hash = mix(mix(hash, status), yes);
  status = gjk2_ground_contacts(&ground, &at, body, margin, contact, CONTACTS, &count);
  hostile_check(status, NULL, 0);
  hash = mix(mix(hash, status), count);
  for (unsigned i = 0; i < count; i++) {
    hash = mix(mix(hash, (int32_t)contact[i].segment), contact[i].manifold.contact[0].distance);
  }
  ASK(hit, gjk2_ground_cast(&ground, &at, body, &moving, &hit, &segment));
  memset(&hit, 0, sizeof hit);
  status = gjk2_ground_cast(&ground, &at, body, &path, &hit, &segment);
  hash = mix(mix(mix(hash, status), hit.hit), hit.hit ? hit.fraction : 0);
  memset(&hit, 0, sizeof hit);
  status = gjk2_ground_cast_ray(&ground, &at, from, to, &hit, &segment);
  hostile_check(status, NULL, 0);
  return mix(mix(mix(hash, status), hit.hit), hit.hit ? (int32_t)segment : 0);
}

static void play(const gjk2_collider *body, const gjk2_vec *to, gjk_q16 margin) {
  static uint32_t block[WORDS];
  static const gjk2_shape ball = GJK2_CIRCLE(30000);
  const gjk2_shape *const shapes[] = {&ground_shape, &ball};
  const gjk2_scene_config config = {.bodies = 3, .parts = 3, .pairs = 6, .detail = GJK_DETAIL_CONTACTS, .motions = 2};
  gjk2_manifold manifolds[8];
  const gjk2_scene_bindings bindings = {
      .details = &gjk2_scene_contacts, .manifolds = manifolds, .motion = &gjk2_scene_motion};
  const gjk2_slide_setup gait = {{0, GJK_Q30_ONE}, GJK_Q30_ONE / 2, 64, GJK_Q16(0.2), GJK_Q16(0.1), true, NULL};
  const gjk2_part part[2] = {{.shape = 0}, {.shape = 1}};
  gjk2_body_setup setup = {at, &part[0], 1, GJK_BODY_KINEMATIC, 0, 1, 1, 7, margin & 0xFFFF};
  gjk2_report reports[8];
  gjk2_slide_result slid;
  gjk2_cast_result hit;
  gjk_scene_hit met;
  gjk_progress progress;
  gjk2_scene scene;
  gjk_body_id id[2];
  bool found;
  if (gjk2_scene_init(&scene, &config, block, sizeof block, shapes, 2, &bindings) != GJK_OK) {
    fuzz_fail("a scene");
  }
  hostile_check(gjk2_scene_add(&scene, &setup, &id[0]), NULL, 0);
  setup.parts = &part[1];
  setup.kind = GJK_BODY_DYNAMIC;
  setup.pose.position = body->position;
  if (gjk2_scene_add(&scene, &setup, &id[1]) != GJK_OK) {
    return;
  }
  (void)gjk2_scene_set_motion(&scene, id[1], GJK_MOTION_FAST);
  for (int i = 0; i < 3; i++) {
    hostile_check(gjk2_scene_update(&scene, reports, 8, &progress), NULL, 0);
    setup.pose.position = *to;
    (void)gjk2_scene_move(&scene, id[1], &setup.pose);
  }
  hostile_check(gjk2_scene_cast_ray(&scene, &body->position, to, NULL, &met, &hit, &found), NULL, 0);
  hostile_check(gjk2_slide(&scene, body, to, &gait, &slid), NULL, 0);
  if (gjk2_scene_check(&scene) != GJK_OK) {
    fuzz_fail("a scene with ground is corrupt");
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  bytes.at = data;
  bytes.end = data + size;
  const bool checked = make_ground();
  const bool turned = below(3) == 0;
  const gjk2_rotation raw = {fuzz_i32(&bytes), fuzz_i32(&bytes)}, upright = {GJK_Q30_ONE, 0};
  at.rotation = upright;
  at.position = any_vec(below(32));
  if (turned && gjk2_rotation_normalize(&raw, &at.rotation) != GJK_OK) {
    at.rotation = raw;
  }
  gjk2_vec buffer[5];
  gjk2_collider body;
  if (make_body(&body, buffer) == GJK_OK) {
    const unsigned shift = below(32);
    const gjk2_vec to = any_vec(shift), from = any_vec(shift);
    const gjk_q16 margin = fuzz_i32(&bytes) >> below(32);
    const bool far = body.shape->type == &gjk2_class_ellipse || body.centre.x > 1 << 28 || body.centre.x < -(1 << 28) ||
                     body.centre.y > 1 << 28 || body.centre.y < -(1 << 28) || at.position.x > 1 << 28 ||
                     at.position.x < -(1 << 28) || at.position.y > 1 << 28 || at.position.y < -(1 << 28);
    check_distance(&body, !far && chain.index == NULL);  // a forged index may hide segments
    const uint64_t hash = ask_all(&body, &to, &from, margin);
    if (checked && ground.type == &gjk2_ground_chain && chain_index.boxes == boxes) {
      chain.index = &chain_index;
      if (gjk2_ground_of_chain(&chain, &ground, &ground_shape) != GJK_OK) {
        fuzz_fail("an index that was made is refused");
      }
      if (ask_all(&body, &to, &from, margin) != hash) {
        fuzz_fail("an index changes an answer");
      }
    }
    play(&body, &to, margin);
  }
  free(vertices);
  free(heights);
  free(cells);
  free(boxes);
  return 0;
}
