// The level: its ground, its bodies, and what keys do.
#include "level.h"

#define ONE GJK_Q16_ONE
#define AT(x, y) \
  { (x) * (ONE / 64), (y) * (ONE / 64) }

// From the top of the right wall over the hills to the top of the left one.
static const gjk2_vec hills[] = {
    AT(2048, 512), AT(2048, 64),  AT(2032, 64),  AT(2016, 64),  AT(2000, 64),  AT(1984, 64),  AT(1968, 64),
    AT(1952, 64),  AT(1936, 64),  AT(1920, 64),  AT(1904, 64),  AT(1888, 64),  AT(1872, 64),  AT(1856, 64),
    AT(1840, 65),  AT(1824, 66),  AT(1808, 69),  AT(1792, 72),  AT(1776, 77),  AT(1760, 82),  AT(1744, 87),
    AT(1728, 93),  AT(1712, 98),  AT(1696, 104), AT(1680, 109), AT(1664, 113), AT(1648, 117), AT(1632, 119),
    AT(1616, 121), AT(1600, 122), AT(1584, 122), AT(1568, 122), AT(1552, 122), AT(1536, 122), AT(1520, 122),
    AT(1504, 122), AT(1488, 122), AT(1472, 122), AT(1456, 122), AT(1440, 122), AT(1424, 122), AT(1408, 122),
    AT(1392, 122), AT(1376, 122), AT(1360, 122), AT(1344, 122), AT(1328, 122), AT(1312, 122), AT(1296, 122),
    AT(1280, 122), AT(1264, 122), AT(1248, 122), AT(1248, 64),  AT(1232, 64),  AT(1216, 64),  AT(1200, 64),
    AT(1184, 64),  AT(1168, 64),  AT(1152, 64),  AT(1136, 64),  AT(1120, 64),  AT(1104, 64),  AT(1088, 64),
    AT(1072, 64),  AT(1056, 64),  AT(1040, 64),  AT(1024, 64),  AT(1008, 64),  AT(992, 64),   AT(976, 64),
    AT(960, 64),   AT(944, 64),   AT(928, 64),   AT(912, 64),   AT(896, 64),   AT(880, 64),   AT(864, 64),
    AT(848, 64),   AT(832, 64),   AT(816, 66),   AT(800, 71),   AT(784, 80),   AT(768, 91),   AT(752, 104),
    AT(736, 118),  AT(720, 132),  AT(704, 146),  AT(688, 157),  AT(672, 166),  AT(656, 171),  AT(640, 173),
    AT(624, 171),  AT(608, 166),  AT(592, 157),  AT(576, 146),  AT(560, 132),  AT(544, 118),  AT(528, 104),
    AT(512, 91),   AT(496, 80),   AT(480, 71),   AT(464, 66),   AT(448, 64),   AT(432, 64),   AT(416, 64),
    AT(400, 64),   AT(384, 64),   AT(368, 64),   AT(352, 64),   AT(336, 64),   AT(320, 64),   AT(304, 64),
    AT(288, 64),   AT(272, 64),   AT(256, 64),   AT(240, 64),   AT(224, 64),   AT(208, 64),   AT(192, 64),
    AT(176, 64),   AT(160, 64),   AT(144, 64),   AT(128, 64),   AT(112, 64),   AT(96, 64),    AT(80, 64),
    AT(64, 64),    AT(48, 64),    AT(32, 64),    AT(16, 64),    AT(0, 64),     AT(0, 512),
};

// Thin platforms, arched a little, that let through what comes from below.
static const gjk2_vec low_platform[] = {AT(104, 0), AT(78, 6), AT(52, 8), AT(26, 6), AT(0, 0)};
static const gjk2_vec high_platform[] = {AT(192, 20), AT(144, 14), AT(96, 9), AT(48, 4), AT(0, 0)};

// A rock, counterclockwise and closed.
static const gjk2_vec rock[] = {AT(0, 60),   AT(-10, 24), AT(20, 0),  AT(90, -14), AT(150, 10),
                                AT(170, 50), AT(120, 66), AT(84, 52), AT(46, 76),  AT(0, 60)};

static const gjk2_vec gem[] = {AT(26, 0), AT(13, 22), AT(-13, 22), AT(-26, 0), AT(-13, -22), AT(13, -22)};
static const gjk2_vec wedge[] = {AT(-28, -16), AT(28, -16), AT(0, 32)};

static gjk2_vec at(int32_t x64, int32_t y64) {
  const gjk2_vec v = AT(x64, y64);
  return v;
}

static void add_chains(flat_world *w) {
  flat_add_chain(w, hills, sizeof hills / sizeof hills[0], at(0, 0), INT32_MAX);
  flat_add_chain(w, low_platform, 5, at(14 * 64 + 20, 230), ONE / 4);
  flat_add_chain(w, high_platform, 5, at(21 * 64, 270), ONE / 4);
  flat_add_chain(w, rock, 10, at(8 * 64 + 10, 300), INT32_MAX);
}

static void add_player(flat_world *w, int32_t x64) {
  const gjk2_shape shape = GJK2_CAPSULE(ONE * 3 / 10, ONE * 7 / 20);
  const gjk2_rotation upright = {0, GJK_Q30_ONE};
  const unsigned i = flat_add(w, &shape, at(x64, 120), 0, ONE, 0);
  w->body[i].friction = 0;
  w->body[i].pose.rotation = upright;
}

static void add_ball(flat_world *w, gjk_q16 radius, gjk2_vec where) {
  const gjk2_shape shape = GJK2_CIRCLE(radius);
  const int32_t squared = (int32_t)((int64_t)radius * radius / ONE);
  const unsigned i = flat_add(w, &shape, where, 0, 3 * squared, squared / 2);
  w->body[i].bounce = ONE / 2;
}

void level_start(flat_world *w) {
  const gjk2_shape crate = GJK2_BOX(ONE * 3 / 8, ONE * 3 / 8), gems = GJK2_POLYGON(gem, 6),
                   wedges = GJK2_POLYGON(wedge, 3), sledge = GJK2_ROUNDED_BOX(ONE / 2, ONE / 8, ONE / 8);
  w->bodies = 0;
  w->chains = 0;
  w->points[0] = 0;
  w->points[1] = 0;
  w->now = 0;
  w->met = 0;
  w->met_ground = 0;
  add_chains(w);
  add_player(w, 2 * 64);
  add_player(w, 30 * 64);
  for (int32_t row = 0; row < 3; row++) {
    for (int32_t i = 0; i + row < 3; i++) {
      (void)flat_add(w, &crate, at(15 * 64 + 50 * i + 25 * row, 88 + 48 * row), 0, ONE * 9 / 16, ONE * 3 / 32);
    }
  }
  add_ball(w, ONE * 2 / 5, at(21 * 64, 170));
  add_ball(w, ONE * 3 / 10, at(23 * 64, 160));
  add_ball(w, ONE / 4, at(22 * 64, 330));
  add_ball(w, ONE / 2, at(10 * 64, 430));
  (void)flat_add(w, &gems, at(10 * 64 + 10, 200), 0, ONE * 2 / 5, ONE / 14);
  (void)flat_add(w, &gems, at(27 * 64, 160), ONE / 5, ONE * 2 / 5, ONE / 14);
  (void)flat_add(w, &wedges, at(24 * 64, 170), 0, ONE * 2 / 5, ONE / 10);
  (void)flat_add(w, &sledge, at(5 * 64, 100), 0, ONE * 5 / 8, ONE / 6);
}

// A player turns towards its speed by as much as its feet allow.
static void steer(flat_body *player, uint8_t keys) {
  const int32_t wanted = ((keys & LEVEL_RIGHT) != 0 ? 5 * ONE : 0) - ((keys & LEVEL_LEFT) != 0 ? 5 * ONE : 0);
  const int32_t most = player->grounded ? ONE / 2 : ONE / 8;
  const int32_t change = wanted - player->velocity.x;
  player->velocity.x += change > most ? most : change < -most ? -most : change;
  if ((keys & LEVEL_JUMP) != 0 && player->grounded) {
    player->velocity.y = 9 * ONE;
  }
}

void level_tick(flat_world *w, const uint8_t keys[LEVEL_PLAYERS]) {
  for (unsigned i = 0; i < LEVEL_PLAYERS; i++) {
    steer(&w->body[i], keys[i]);
  }
  flat_step(w);
}

static uint64_t mix(uint64_t hash, int32_t value) {
  return (hash ^ (uint32_t)value) * UINT64_C(0x100000001b3);
}

uint64_t level_hash(const flat_world *w) {
  uint64_t hash = UINT64_C(0xcbf29ce484222325);
  for (unsigned i = 0; i < w->bodies; i++) {
    const flat_body *b = &w->body[i];
    const int32_t values[] = {b->pose.position.x, b->pose.position.y, b->pose.rotation.c, b->pose.rotation.s,
                              b->angle,           b->velocity.x,      b->velocity.y,      b->spin};
    for (unsigned k = 0; k < sizeof values / sizeof values[0]; k++) {
      hash = mix(hash, values[k]);
    }
  }
  return mix(mix(hash, (int32_t)(w->met & INT32_MAX)), (int32_t)(w->met_ground & INT32_MAX));
}
