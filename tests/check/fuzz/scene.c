// Makes operations on a scene from bytes. Its reports must be those of a search of all pairs, and its block must pass
// its own check. Blocks are damaged, too.
#include <stdlib.h>
#include <string.h>

#include "bytes.h"
#include "scene/session.h"

#define OPERATIONS_MAX 96
#define REPORTS 64

static session s;

static random_state fuzz_random(fuzz_bytes *bytes) {
  const uint64_t low = fuzz_u8(bytes);
  return random_seed(low | (uint64_t)fuzz_u8(bytes) << 8);
}

static void expect(bool holds, const char *what) {
  if (!holds) {
    fuzz_fail(what);
  }
}

static uint64_t hash(void) {
  uint64_t value = 0;
  expect(gjk_scene_hash(&s.now.scene, &value) == GJK_OK, "gjk_scene_hash");
  return value;
}

static void carry(void) {
  const uint64_t before = hash();
  expect(session_move(&s, false), "a sealed block cannot be opened");
  expect(hash() == before, "the hash of an opened block");
}

// Whatever a block holds, the check must end; a block that passes it must be usable. Some copies are in the middle of an
// update: some pairs are tested, some bodies swept, some reports written.
static void damage(fuzz_bytes *bytes) {
  static gjk_report reports[REPORTS];
  const gjk_scene_bindings *bindings = &s.now.scene.bindings;
  uint32_t *block = malloc(s.bytes);
  gjk_scene scene = s.now.scene;
  gjk_progress progress = {0, 0, 0};
  memcpy(block, s.now.scene.block, s.bytes);
  scene.block = block;
  scene.bindings.manifolds = NULL;
  const unsigned tests = fuzz_u8(bytes), written = tests / 16;
  if (tests % 2 != 0) {
    (void)gjk_scene_update_slice(&scene, tests < 128 ? tests / 2 : UINT32_MAX, reports, written, &progress);
  }
  const unsigned words = 1 + fuzz_u8(bytes) % 4;
  for (unsigned i = 0; i < words; i++) {
    const uint32_t at = (uint32_t)fuzz_i32(bytes) % (uint32_t)(s.bytes / sizeof *block);
    block[at] = fuzz_u8(bytes) % 2 == 0 ? block[at] + fuzz_u8(bytes) : (uint32_t)fuzz_i32(bytes);
  }
  if (gjk_scene_attach(&scene, block, s.bytes, world_shapes, WORLD_SHAPES, bindings) == GJK_OK &&
      gjk_scene_check(&scene) == GJK_OK) {
    scene.bindings.manifolds = NULL;
    (void)gjk_scene_update(&scene, reports, REPORTS, &progress);
    uint64_t value;
    (void)gjk_scene_hash(&scene, &value);
    if (gjk_scene_seal(&scene) == GJK_OK) {
      (void)gjk_scene_open(&scene, block, s.bytes, world_shapes, WORLD_SHAPES, NULL);
    }
  }
  free(block);
}

static void operate(fuzz_bytes *bytes) {
  const unsigned what = fuzz_u8(bytes) % 16;
  random_state random;
  switch (what) {
    case 0:
    case 1:
      random = fuzz_random(bytes);
      expect(session_update(&s, &random), "reports, or the block after an update");
      break;
    case 2: session_keep(&s); break;
    case 3: carry(); break;
    case 4: expect(session_move(&s, true), "a copy of the block cannot be used"); break;
    case 5: damage(bytes); break;
    default:
      random = fuzz_random(bytes);
      expect(world_change(&s.now, &random), "the status of a change");
      break;
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz_bytes bytes = {data, data + size};
  random_state random = fuzz_random(&bytes);
  const world_options options = session_options(&random);
  expect(session_start(&s, &options), "a scene cannot be made");
  for (int i = 0; i < OPERATIONS_MAX && bytes.at < bytes.end; i++) {
    operate(&bytes);
    expect(gjk_scene_check(&s.now.scene) == GJK_OK, "gjk_scene_check");
  }
  random = random_seed(size);
  expect(session_update(&s, &random), "reports, or the block, at the end");
  session_end(&s);
  return 0;
}
