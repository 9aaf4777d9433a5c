// A block of any content: what may be done with it before it is known to be sound.

// Values of CASE.
#define HEADER 1  // any header at all
#define INIT 2    // any bytes before, any configuration
#define OPEN 3    // any bytes but for the capacities

#if CASE == OPEN
#define MOTIONS 2
#endif
#include "scene_any.h"

// Too few for any configuration.
#define TOO_FEW 563

static const gjk_scene_bindings bindings;

static void any_config(gjk_scene_config *config) {
  config->bodies = any_uint32();
  config->parts = any_uint32();
  config->own_poses = any_uint32();
  config->pairs = any_uint32();
  config->box_margin = any_int32();
  config->detail = (uint8_t)any_uint16();
  config->persist = (uint8_t)any_uint16();
  config->retest_all = (uint8_t)any_uint16();
  config->pair_words = (uint8_t)any_uint16();
  config->workspace_cells = any_uint32();
  config->motions = any_uint32();
}

static void init(gjk_scene *scene) {
  gjk_scene_config config;
  const int32_t small = any_between(0, 1);
  any_config(&config);
  (void)gjk_scene_bytes(any_bool() ? &config : NULL);
  (void)gjk_scene_init(any_bool() ? scene : NULL, any_bool() ? &config : NULL, any_bool() ? &block : NULL,
                       (size_t)any_between(0, TOO_FEW), any_bool() ? shapes : NULL, any_uint16(),
                       any_bool() ? &bindings : NULL);
  //@ split small;
  config.bodies = small != 0 ? 1 : BODIES;
  config.parts = small != 0 ? 1 : PARTS;
  config.own_poses = small != 0 ? 0 : OWN_POSES;
  config.pairs = small != 0 ? 1 : PAIRS;
  (void)gjk_scene_init(scene, &config, &block, (size_t)any_between(0, sizeof block), shapes, any_uint16(),
                       any_bool() ? &bindings : NULL);
}

static void open(gjk_scene *scene) {
  gjk_scene *const any = any_bool() ? scene : NULL;
  if (gjk_scene_attach(any, any_bool() ? &block : NULL, (size_t)any_between(0, sizeof block),
                       any_bool() ? shapes : NULL, SHAPES, any_bool() ? &bindings : NULL) == GJK_OK) {
    (void)gjk_scene_seal(scene);
  }
  (void)gjk_scene_open(any, any_bool() ? &block : NULL, sizeof block, any_bool() ? shapes : NULL, SHAPES,
                       any_bool() ? &bindings : NULL);
}

int main(void) {
  gjk_scene scene;
  any_shapes();
  Frama_C_make_unknown((char *)&block, sizeof block);
#if CASE == HEADER
  (void)gjk_scene_attach(&scene, &block, (size_t)any_uint32(), shapes, any_uint16(), any_bool() ? &bindings : NULL);
#elif CASE == INIT
  init(&scene);
#else
  block.header.config.bodies = BODIES;
  block.header.config.parts = PARTS;
  block.header.config.own_poses = OWN_POSES;
  block.header.config.pairs = PAIRS;
  block.header.config.motions = MOTIONS;
  open(&scene);
#endif
  return 0;
}
