// One side of a lockstep match.
#include "peer.h"

#include "print.h"
#include "random.h"

#define FIELDS 16
#define LINE 120

static const char *const field_names[FIELDS] = {
    "generation", "position.x", "position.y", "position.z", "rotation.x", "rotation.y", "rotation.z", "rotation.w",
    "category",   "mask",       "user",       "margin",     "asleep",     "step.x",     "step.y",     "step.z"};

// Of near pairs the distance + 1, of others 0, by slots and parts.
typedef uint32_t near_table[MATCH_BODIES][MATCH_BODIES][2][2];

static match game;
static near_table here, there;

static void write_line(const peer_link *link, const char *kind, const uint64_t *numbers, unsigned count) {
  link->write(kind);
  for (unsigned i = 0; i < count; i++) {
    link->write(" ");
    print_hex(link->write, numbers[i]);
  }
  link->write("\n");
}

// Reads the next line: its letter, and count numbers. False: it is another line.
static bool read_line(const peer_link *link, char *kind, uint64_t *numbers, unsigned most, unsigned *count) {
  int c = link->read();
  *kind = (char)(c > 0 ? c : 0);
  *count = 0;
  c = link->read();
  for (unsigned length = 0; c != '\n' && length < LINE; length++) {
    if (c == ' ' && *count < most) {
      numbers[(*count)++] = 0;
    } else if (*count > 0 && ((c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'))) {
      numbers[*count - 1] = numbers[*count - 1] << 4 | (uint64_t)(c <= '9' ? c - '0' : c - 'a' + 10);
    } else {
      return false;
    }
    c = link->read();
  }
  return c == '\n';
}

// Tells the other side a number about a tick, and reads its number about the same.
static bool exchange(const peer_link *link, const char *kind, uint32_t tick, uint64_t mine, uint64_t *theirs) {
  const uint64_t said[2] = {tick, mine};
  uint64_t heard[2];
  char letter;
  unsigned count;
  write_line(link, kind, said, 2);
  if (!read_line(link, &letter, heard, 2, &count) || letter != kind[0] || count != 2 || heard[0] != tick) {
    return false;
  }
  *theirs = heard[1];
  return true;
}

static bool body_fields(uint32_t slot, uint32_t fields[FIELDS]) {
  gjk_scene scene;
  gjk_body_state s;
  const match_body *b = &game.bodies[slot];
  if (!match_scene(&game, &scene) || gjk_scene_get(&scene, b->id, &s) != GJK_OK) {
    return false;
  }
  const uint32_t values[FIELDS] = {b->id.generation,
                                   (uint32_t)s.pose.position.x,
                                   (uint32_t)s.pose.position.y,
                                   (uint32_t)s.pose.position.z,
                                   (uint32_t)s.pose.rotation.x,
                                   (uint32_t)s.pose.rotation.y,
                                   (uint32_t)s.pose.rotation.z,
                                   (uint32_t)s.pose.rotation.w,
                                   s.category,
                                   s.mask,
                                   s.user,
                                   (uint32_t)s.margin,
                                   s.asleep,
                                   (uint32_t)b->step.x,
                                   (uint32_t)b->step.y,
                                   (uint32_t)b->step.z};
  for (int i = 0; i < FIELDS; i++) {
    fields[i] = values[i];
  }
  return true;
}

// Calls a function for each near pair of the game; stops when it returns false.
static void each_near(bool (*function)(void *user, const gjk_report *pair), void *user) {
  gjk_scene scene;
  gjk_report pair;
  uint32_t cursor = 0;
  bool found = match_scene(&game, &scene);
  while (found && gjk_scene_next_near(&scene, &cursor, &pair, &found) == GJK_OK && found && function(user, &pair)) {
  }
}

// A distance as a number that is never 0.
static uint32_t code_of(gjk_q16 distance) {
  return (uint32_t)distance + (UINT32_C(1) << 31);
}

static int64_t distance_of(uint32_t code) {
  return (int64_t)code - (INT64_C(1) << 31);
}

static bool write_pair(void *user, const gjk_report *pair) {
  const uint64_t numbers[5] = {pair->a.slot, pair->part_a, pair->b.slot, pair->part_b, code_of(pair->distance)};
  write_line(user, "p", numbers, 5);
  return true;
}

static bool note_pair(void *user, const gjk_report *pair) {
  (void)user;
  here[pair->a.slot][pair->b.slot][pair->part_a][pair->part_b] = code_of(pair->distance);
  return true;
}

static void describe(const peer_link *link) {
  uint32_t fields[FIELDS];
  for (uint32_t slot = 0; slot < MATCH_BODIES; slot++) {
    for (uint32_t i = 0; i < FIELDS && body_fields(slot, fields); i++) {
      const uint64_t numbers[3] = {slot, i, fields[i]};
      write_line(link, "b", numbers, 3);
    }
  }
  union {  // write_pair only reads it
    const peer_link *in;
    void *out;
  } user;
  user.in = link;
  each_near(write_pair, user.out);
  write_line(link, "e", NULL, 0);
}

static void say_number(void (*say)(const char *), const char *before, int64_t value) {
  say(before);
  say(value < 0 ? "-" : "");
  print_decimal(say, (uint32_t)(value < 0 ? -value : value));
}

static void say_pairs(void (*say)(const char *)) {
  unsigned differing = 0;
  each_near(note_pair, NULL);
  for (uint32_t i = 0; i < MATCH_BODIES * MATCH_BODIES * 4; i++) {
    const uint32_t a = i / 4 / MATCH_BODIES, b = i / 4 % MATCH_BODIES, part_a = i / 2 % 2, part_b = i % 2;
    const uint32_t mine = here[a][b][part_a][part_b], theirs = there[a][b][part_a][part_b];
    if (mine != theirs && differing++ < 3) {
      say_number(say, "  pair of body ", a);
      say_number(say, " part ", part_a);
      say_number(say, " and body ", b);
      say_number(say, " part ", part_b);
      if (mine == 0 || theirs == 0) {
        say(mine != 0 ? ": near here, not there\n" : ": near there, not here\n");
      } else {
        say_number(say, ": distance ", distance_of(mine));
        say_number(say, " here, ", distance_of(theirs));
        say(" there\n");
      }
    }
  }
  say_number(say, "  pairs that differ: ", differing);
  say("\n");
}

// Reads the other side's description and names what differs from this side.
static bool judge(const peer_link *link, void (*say)(const char *)) {
  uint32_t fields[FIELDS];
  uint64_t n[5];
  unsigned count, differing = 0;
  char kind;
  while (read_line(link, &kind, n, 5, &count) && kind != 'e') {  // ends: with the other side
    if (kind == 'p' && count == 5 && n[0] < MATCH_BODIES && n[2] < MATCH_BODIES && n[1] < 2 && n[3] < 2) {
      there[n[0]][n[2]][n[1]][n[3]] = (uint32_t)n[4];
    } else if (kind != 'b' || count != 3 || n[0] >= MATCH_BODIES || n[1] >= FIELDS) {
      return false;
    } else if (body_fields((uint32_t)n[0], fields) && fields[n[1]] != (uint32_t)n[2] && differing++ < 3) {
      say_number(say, "  body ", (int64_t)n[0]);
      say(" ");
      say(field_names[n[1]]);
      say_number(say, ": ", (int32_t)fields[n[1]]);
      say_number(say, " here, ", (int32_t)(uint32_t)n[2]);
      say(" there\n");
    }
  }
  say_number(say, "  fields of bodies that differ: ", differing);
  say("\n");
  say_pairs(say);
  return kind == 'e';
}

static bool find_apart(void *user, const gjk_report *pair) {
  gjk_report *found = user;
  *found = *pair;
  return pair->distance <= 100 || pair->distance > 3000;
}

// Moves a body of a pair that has a distance by about 700 LSB without telling the other side. False: there is no such
// pair at this tick.
static bool nudge(void) {
  gjk_report pair = {.distance = 0};
  gjk_scene scene;
  gjk_body_state state;
  each_near(find_apart, &pair);
  if (pair.distance <= 100 || pair.distance > 3000 || !match_scene(&game, &scene) ||
      gjk_scene_get(&scene, pair.a, &state) != GJK_OK) {
    return false;
  }
  state.pose.position.x += 500;
  state.pose.position.y += 300;
  state.pose.position.z -= 400;
  return gjk_scene_move(&scene, pair.a, &state.pose) == GJK_OK;
}

// A player's input: each bit is set a quarter of the time.
static match_input think(unsigned player, uint32_t tick) {
  random_state random = random_seed(tick * UINT64_C(2) + player);
  const uint32_t any = random_u32(&random);
  return (match_input)(any & any >> 8 & 0xFFu);
}

peer_result peer_play(const peer_options *options, const peer_link *link, void (*say)(const char *)) {
  bool nudged = options->diverge == 0;
  if (!match_start(&game)) {
    return PEER_BROKEN;
  }
  for (uint32_t tick = 0; tick < options->ticks; tick++) {
    const match_input mine = think(options->player, tick);
    uint64_t theirs, hash;
    if (!exchange(link, "i", tick, mine, &theirs)) {
      return PEER_BROKEN;
    }
    if (!nudged && tick >= options->diverge) {
      nudged = nudge();
    }
    const match_input input = (match_input)theirs;
    if (!match_tick(&game, options->player == 0 ? mine : input, options->player == 0 ? input : mine) ||
        !exchange(link, "h", tick, match_hash(&game), &hash)) {
      return PEER_BROKEN;
    }
    if (hash != match_hash(&game)) {
      if (options->player != 0) {
        describe(link);
        return PEER_DIFFERENT;
      }
      say_number(say, "The two differ after tick ", tick);
      say(":\n");
      return judge(link, say) ? PEER_DIFFERENT : PEER_BROKEN;
    }
  }
  if (options->player == 0) {
    say_number(say, "", options->ticks);
    say(" ticks, the same hash after each\n");
  }
  return PEER_SAME;
}
