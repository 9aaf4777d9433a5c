// Games of scenes with concave bodies for tests.
#include "scene/concave_game.h"

#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "reference/random_shape.h"

#define FIRST_TIE (CONCAVE_BODIES + CONCAVE_MOVERS)
#define FIRST_SOLID (FIRST_TIE + GAME_TIES)
#define GRID 4
#define CRATES 12

static gjk_epa_cell cells[GJK_EPA_CELLS(64)];

static struct {
  concave_body body[GAME_TIES];
  gjk_mesh mesh[2];
  gjk_vec3 vertices[2][(GRID + 1) * (GRID + 1) + 1];
  gjk_mesh_triangle triangles[2][4 * GRID * GRID + 4];
  gjk_mesh_node nodes[2][GRID * GRID + 8];
  gjk_height_field field;
  int16_t heights[(GRID + 1) * (GRID + 1)];
  gjk_shape crate;
  gjk_compound compound[2];
  gjk_compound_part parts[2][CRATES];
  gjk_compound_node compound_nodes[2][GJK_COMPOUND_NODES(CRATES)];
  gjk_shape solid[GAME_SOLIDS];
  gjk_vec3 hull[8];
} ties;

// A flat grid at a height, with triangles twice, in a line, in a point, and one over all of it.
static void make_grid(random_state *random, unsigned k, int32_t size, gjk_vec3 off, bool two_sided) {
  uint32_t n = 0, t = 0;
  gjk_mesh_triangle *triangle = ties.triangles[k];
  for (int32_t j = 0; j <= GRID; j++) {
    for (int32_t i = 0; i <= GRID; i++) {
      ties.vertices[k][n++] = (gjk_vec3){off.x + (i - GRID / 2) * size, off.y + (j - GRID / 2) * size, off.z};
    }
  }
  for (uint32_t j = 0; j < GRID; j++) {
    for (uint32_t i = 0; i < GRID; i++) {
      const uint32_t a = j * (GRID + 1) + i, b = a + 1, c = a + GRID + 2, d = a + GRID + 1;
      triangle[t++] = (gjk_mesh_triangle){{a, b, c}};
      triangle[t++] = (gjk_mesh_triangle){{a, c, d}};
      if (random_below(random, 4) == 0) {
        triangle[t] = triangle[t - 1 - random_below(random, 2)];
        t++;
      }
    }
  }
  const uint32_t last = (GRID + 1) * (GRID + 1) - 1;
  if (random_below(random, 2) != 0) {
    triangle[t++] = (gjk_mesh_triangle){{0, GRID, last}};                           // over the others
    triangle[t++] = (gjk_mesh_triangle){{6, 7, 8}};                                 // in a line
    triangle[t++] = (gjk_mesh_triangle){{12, 12, 12}};                              // in a point
    triangle[t++] = (gjk_mesh_triangle){{last, GRID, random_below(random, last)}};  // turned over
  }
  CHECK(gjk_mesh_build(ties.vertices[k], n, triangle, t, two_sided, ties.nodes[k], GRID * GRID + 8, &ties.mesh[k]) ==
        GJK_OK);
}

static void make_field(random_state *random, int32_t size) {
  const gjk_height_field field = GJK_HEIGHT_FIELD(ties.heights, GRID + 1, GRID + 1, size, size, 1 + size / 100);
  for (unsigned k = 0; k < (GRID + 1) * (GRID + 1); k++) {
    const uint32_t how = random_below(random, 8);
    ties.heights[k] = how == 0 ? GJK_HEIGHT_HOLE : how == 1 ? (int16_t)random_range(random, -50, 50) : 0;
  }
  ties.heights[0] = ties.heights[1] = ties.heights[GRID + 2] = 0;
  ties.field = field;
}

// Equal crates face to face; and solids of all kinds.
static void make_compounds(random_state *random, int32_t size) {
  const gjk_pose identity = GJK_POSE_IDENTITY;
  ties.crate = (gjk_shape)GJK_BOX(size / 2, size / 2, size / 2);
  for (int32_t i = 0; i < CRATES; i++) {
    ties.parts[0][i] = (gjk_compound_part){&ties.crate, identity};
    ties.parts[0][i].pose.position = (gjk_vec3){(i % 3) * size, (i / 3 % 2) * size, (i / 6) * size};
    ties.parts[1][i] = (gjk_compound_part){&ties.solid[random_below(random, GAME_SOLIDS)], identity};
    ties.parts[1][i].pose.position = random_vector(random, 2.0 * size);
    ties.parts[1][i].pose.rotation = random_rotation(random);
  }
  const uint16_t count[2] = {(uint16_t)random_range(random, 2, CRATES), (uint16_t)random_range(random, 1, CRATES)};
  for (unsigned k = 0; k < 2; k++) {
    CHECK(gjk_compound_build(ties.parts[k], count[k], ties.compound_nodes[k], GJK_COMPOUND_NODES(CRATES),
                             &ties.compound[k]) == GJK_OK);
  }
}

static void make_solids(random_state *random, int32_t size) {
  for (unsigned k = 0; k < 8; k++) {
    ties.hull[k] = (gjk_vec3){random_range(random, -size, size), random_range(random, -size, size),
                              random_range(random, -size, size)};
  }
  const gjk_shape solids[GAME_SOLIDS] = {GJK_BOX(size / 2, size / 2, size / 2), GJK_CYLINDER(size / 2, size / 2),
                                         GJK_CONE(size / 2, size / 2), GJK_ELLIPSOID(size / 2, size / 3, size),
                                         GJK_HULL(ties.hull, 8)};
  memcpy(ties.solid, solids, sizeof solids);
}

static void make_ties(game *m, random_state *random) {
  const gjk_vec3 at = {0, 0, 0};
  // As far from its origin as a part may be.
  const gjk_vec3 far = {GJK_CONCAVE_REACH / 2 - 3 * m->size, GJK_CONCAVE_REACH / 2 - 3 * m->size, m->size};
  make_solids(random, m->size);
  make_grid(random, 0, m->size, at, random_below(random, 2) != 0);
  make_grid(random, 1, m->size, far, random_below(random, 2) != 0);
  make_field(random, m->size);
  make_compounds(random, m->size);
  const gjk_parts parts[GAME_TIES] = {GJK_PARTS_OF_MESH(&ties.mesh[0]), GJK_PARTS_OF_MESH(&ties.mesh[1]),
                                      GJK_PARTS_OF_HEIGHT_FIELD(&ties.field), GJK_PARTS_OF_COMPOUND(&ties.compound[0]),
                                      GJK_PARTS_OF_COMPOUND(&ties.compound[1])};
  for (unsigned i = 0; i < GAME_TIES; i++) {
    ties.body[i].parts = parts[i];
    CHECK(gjk_concave_init(&parts[i], &ties.body[i].concave, &ties.body[i].shape) == GJK_OK);
  }
}

void game_make(game *m, random_state *random) {
  memset(m->body, 0, sizeof m->body);
  m->size = 1 << random_range(random, 9, 17);
  m->lattice = random_below(random, 3) == 0;
  m->detail = (uint8_t)random_below(random, GJK_DETAIL_SENSOR);
  m->workspace.cells = cells;
  m->workspace.count = random_below(random, 3) == 0 ? random_below(random, 60) : sizeof cells / sizeof cells[0];
  m->middle = (gjk_vec3){0, 0, 0};
  if (random_below(random, 4) == 0) {  // at the ends of where concave parts may be
    const int32_t end = INT32_MAX - GJK_CONCAVE_REACH - 16 * m->size;
    m->middle = (gjk_vec3){random_below(random, 2) != 0 ? end : -end, random_below(random, 2) != 0 ? end : 0, -end};
  }
  concave_world_make(&m->world, random, m->size);
  make_ties(m, random);
  for (unsigned i = 0; i < GAME_SHAPES; i++) {
    m->shapes[i] = i < CONCAVE_BODIES ? &m->world.body[i].shape
                   : i < FIRST_TIE    ? &m->world.mover[i - CONCAVE_BODIES]
                   : i < FIRST_SOLID  ? &ties.body[i - FIRST_TIE].shape
                                      : &ties.solid[i - FIRST_SOLID];
  }
}

void game_free(game *m) {
  concave_world_free(&m->world);
}

bool game_is_concave(unsigned shape) {
  return shape < CONCAVE_BODIES || (shape >= FIRST_TIE && shape < FIRST_SOLID);
}

bool game_is_curved(unsigned shape) {
  return shape == FIRST_SOLID - 1 || (shape > FIRST_SOLID && shape < FIRST_SOLID + 4);
}

bool game_may_meet(const game *m, uint32_t a, uint32_t b) {
  const gjk_body_setup *p = &m->body[a].setup, *q = &m->body[b].setup;
  return (p->kind != GJK_BODY_STATIC || q->kind != GJK_BODY_STATIC) && (p->category & q->mask) != 0 &&
         (q->category & p->mask) != 0;
}

gjk_scene_config game_config(const game *m, uint32_t pairs, uint32_t more, uint8_t retest, gjk_q16 box_margin) {
  const gjk_scene_config config = {.bodies = GAME_BODIES + more,
                                   .parts = 2 * GAME_BODIES + more,
                                   .own_poses = 2 * GAME_BODIES + more,
                                   .pairs = pairs,
                                   .box_margin = box_margin,
                                   .detail = m->detail,
                                   .persist = 1,
                                   .retest_all = retest,
                                   .pair_words = 1,
                                   .workspace_cells = m->workspace.count,
                                   .motions = GAME_BODIES + more};
  return config;
}

gjk_status game_start(const game *m, const gjk_scene_config *config, game_scene *s) {
  const gjk_scene_bindings bindings = {.details = &gjk_scene_contacts,
                                       .workspace = &m->workspace,
                                       .manifolds = s->manifold,
                                       .motion = &gjk_scene_motion};
  memset(s->id, 0, sizeof s->id);
  s->bytes = gjk_scene_bytes(config);
  s->block = malloc(s->bytes);
  s->reports = 0;
  return gjk_scene_init(&s->scene, config, s->block, s->bytes, m->shapes, GAME_SHAPES, &bindings);
}

void game_end(game_scene *s) {
  free(s->block);
}

// A pose near the middle, or about another body's.
static gjk_pose draw_pose(const game *m, random_state *random) {
  gjk_pose pose = GJK_POSE_IDENTITY;
  gjk_vec3 off = random_vector(random, 5.0 * m->size * random_unit(random));
  if (m->lattice) {
    off = (gjk_vec3){random_range(random, -6, 6) * (m->size / 2), random_range(random, -6, 6) * (m->size / 2),
                     random_range(random, -4, 4) * (m->size / 2)};
    pose.rotation = random_below(random, 3) == 0 ? (gjk_quat){759250125, 0, 0, 759250125} : pose.rotation;
  } else {
    pose.rotation = random_rotation(random);
  }
  pose.position = (gjk_vec3){m->middle.x + off.x, m->middle.y + off.y, m->middle.z + off.z};
  return pose;
}

// The far mesh at a pose whose surface is near the middle.
static void bring_near(const game *m, uint16_t shape, gjk_pose *pose) {
  if (shape == FIRST_TIE + 1 && m->middle.x == 0) {
    const gjk_pose back = {{-ties.vertices[1][12].x, -ties.vertices[1][12].y, -ties.vertices[1][12].z},
                           {0, 0, 0, GJK_Q30_ONE}};
    gjk_pose there;
    if (gjk_pose_compose(pose, &back, &there) == GJK_OK) {
      *pose = there;
    }
  }
}

// Few of the concave bodies of many parts, whose pairs take long.
static uint16_t draw_shape(random_state *random) {
  const uint32_t how = random_below(random, 16);
  return (uint16_t)(how < 7    ? FIRST_TIE + random_below(random, GAME_TIES)
                    : how == 7 ? random_below(random, CONCAVE_BODIES)
                    : how < 11 ? CONCAVE_BODIES + random_below(random, CONCAVE_MOVERS)
                               : FIRST_SOLID + random_below(random, GAME_SOLIDS));
}

static void draw_setup(game *m, random_state *random, game_move *move) {
  gjk_body_setup *s = &move->setup;
  memset(move->parts, 0, sizeof move->parts);
  memset(s, 0, sizeof *s);
  s->part_count = random_below(random, 5) == 0 ? 2 : 1;
  for (unsigned i = 0; i < s->part_count; i++) {
    const gjk_pose identity = GJK_POSE_IDENTITY;
    move->parts[i].shape = draw_shape(random);
    move->parts[i].own_pose = random_below(random, 4) == 0;
    move->parts[i].pose = identity;
    if (move->parts[i].own_pose) {
      move->parts[i].pose.position = random_vector(random, 1.0 * m->size);
      move->parts[i].pose.rotation = random_rotation(random);
    }
  }
  s->pose = draw_pose(m, random);
  bring_near(m, move->parts[0].shape, &s->pose);
  s->kind = (uint8_t)(random_below(random, 4) == 0 ? GJK_BODY_STATIC : 1 + random_below(random, 2));
  s->detail = (uint8_t)random_below(random, 8);
  s->detail = s->detail > GJK_DETAIL_SENSOR ? GJK_DETAIL_TOUCH : s->detail;
  s->category = 1u << random_below(random, 3);
  s->mask = random_below(random, 4) == 0 ? 3 : 7;
  s->margin = random_below(random, 2) == 0 ? 0 : random_range(random, 0, m->size / 4);
}

// Where a body goes: a little way, with or without a turn, or anywhere.
static gjk_pose draw_way(const game *m, random_state *random, const game_body *b) {
  gjk_pose pose = b->setup.pose;
  const uint32_t how = random_below(random, 5);
  gjk_vec3 off = random_vector(random, m->size * (how == 0 ? 3.0 : 0.05));
  if (m->lattice) {
    off = (gjk_vec3){random_range(random, -2, 2) * (m->size / 2), random_range(random, -2, 2) * (m->size / 2),
                     random_range(random, -1, 1) * (m->size / 2)};
  }
  const gjk_vec3 *at = &pose.position, *middle = &m->middle;
  const int32_t far = 8 * m->size;
  if (how == 1 || abs(at->x - middle->x) > far || abs(at->y - middle->y) > far || abs(at->z - middle->z) > far) {
    pose = draw_pose(m, random);
    bring_near(m, b->parts[0].shape, &pose);
    return pose;
  }
  pose.position = (gjk_vec3){pose.position.x + off.x, pose.position.y + off.y, pose.position.z + off.z};
  if (how == 2) {
    pose.rotation = random_rotation(random);
  }
  return pose;
}

// Makes a move in the bodies of the game.
static void note_move(game *m, const game_move *move) {
  game_body *b = &m->body[move->slot];
  switch (move->what) {
    case GAME_ADD:
      b->there = true;
      b->setup = move->setup;
      memcpy(b->parts, move->parts, sizeof b->parts);
      b->asleep = false;
      b->motion = GJK_MOTION_NOT_KEPT;
      break;
    case GAME_REMOVE: b->there = false; break;
    case GAME_SHAPE: b->parts[move->part].shape = move->shape; break;
    case GAME_FILTER:
      b->setup.category = move->category;
      b->setup.mask = 7;
      break;
    case GAME_SLEEP: b->asleep = b->asleep || b->setup.kind == GJK_BODY_DYNAMIC; break;
    case GAME_WAKE: b->asleep = false; break;
    case GAME_MOTION: b->motion = move->motion; break;
    case GAME_MOVE:
    case GAME_TELEPORT:
    default:
      b->setup.pose = move->pose;
      b->asleep = false;
      break;
  }
}

static bool may_have_motion(const game_body *b) {
  return b->setup.kind != GJK_BODY_STATIC && b->setup.detail != GJK_DETAIL_SENSOR;
}

void game_draw(game *m, random_state *random, bool first) {
  m->moves = 0;
  for (uint32_t n = 0; n < (first ? GAME_BODIES : GAME_MOVES - 2); n++) {
    game_move *move = &m->move[m->moves];
    memset(move, 0, sizeof *move);
    move->slot = first ? n : random_below(random, GAME_BODIES);
    const game_body *b = &m->body[move->slot];
    const uint32_t how = random_below(random, 24);
    move->what = how < 13    ? GAME_MOVE
                 : how == 13 ? GAME_TELEPORT
                 : how == 14 ? GAME_REMOVE
                 : how == 15 ? GAME_SHAPE
                 : how == 16 ? GAME_FILTER
                 : how == 17 ? GAME_SLEEP
                 : how == 18 ? GAME_WAKE
                             : GAME_MOTION;
    move->what = b->there ? move->what : GAME_ADD;
    if (move->what == GAME_ADD) {
      draw_setup(m, random, move);
    } else if (move->what == GAME_MOTION && !may_have_motion(b)) {
      continue;
    } else {
      move->pose = draw_way(m, random, b);
    }
    move->part = (uint16_t)random_below(random, b->there ? b->setup.part_count : 1);
    move->shape = draw_shape(random);
    move->category = 1u << random_below(random, 3);
    move->motion = (uint8_t)random_below(random, 4);
    move->motion = move->motion > GJK_MOTION_FAST ? GJK_MOTION_FAST : move->motion;
    move->starts = b->motion == GJK_MOTION_NOT_KEPT || move->what == GAME_TELEPORT;
    note_move(m, move);
    move->from = b->setup.pose;
    m->moves++;
  }
}

static gjk_status play_move(const game_move *move, game_scene *s) {
  gjk_body_setup setup = move->setup;
  const gjk_body_id id = s->id[move->slot];
  gjk_status status = GJK_OK;
  switch (move->what) {
    case GAME_ADD:
      setup.parts = move->parts;
      return gjk_scene_add_at(&s->scene, move->slot, &setup, &s->id[move->slot]);
    case GAME_MOVE: return gjk_scene_move(&s->scene, id, &move->pose);
    case GAME_TELEPORT: return gjk_scene_teleport(&s->scene, id, &move->pose);
    case GAME_SHAPE: return gjk_scene_set_shape(&s->scene, id, move->part, move->shape);
    case GAME_FILTER: return gjk_scene_set_filter(&s->scene, id, move->category, 7);
    case GAME_SLEEP: status = gjk_scene_sleep(&s->scene, id); return status == GJK_ERROR_RANGE ? GJK_OK : status;
    case GAME_WAKE: return gjk_scene_wake(&s->scene, id);
    case GAME_MOTION: return gjk_scene_set_motion(&s->scene, id, move->motion);
    case GAME_REMOVE:
    default: return gjk_scene_remove(&s->scene, id);
  }
}

void game_play(const game *m, game_scene *s) {
  for (unsigned i = 0; i < m->moves; i++) {
    const gjk_status status = play_move(&m->move[i], s);
    CHECK_MSG(status == GJK_OK, "move %u of slot %u: %d", (unsigned)m->move[i].what, (unsigned)m->move[i].slot,
              (int)status);
  }
}

void game_rebuild(const game *m, game_scene *s) {
  for (uint32_t i = 0; i < GAME_BODIES; i++) {
    const uint32_t slot = GAME_BODIES - 1 - i;
    const game_body *b = &m->body[slot];
    if (b->there) {
      gjk_body_setup setup = b->setup;
      setup.parts = b->parts;
      CHECK(gjk_scene_add_at(&s->scene, slot, &setup, &s->id[slot]) == GJK_OK);
      CHECK(b->motion == GJK_MOTION_NOT_KEPT || gjk_scene_set_motion(&s->scene, s->id[slot], b->motion) == GJK_OK);
      CHECK(!b->asleep || gjk_scene_sleep(&s->scene, s->id[slot]) == GJK_OK);
    }
  }
}

gjk_status game_update(game_scene *s, uint32_t tests, uint32_t room) {
  gjk_progress progress;
  const gjk_scene_bindings kept = s->scene.bindings;
  gjk_status status;
  s->reports = 0;
  do {  // ends: each call tests a pair or writes a report
    s->scene.bindings.manifolds = &s->manifold[s->reports];
    const uint32_t left = GAME_REPORTS - s->reports;
    status = gjk_scene_update_slice(&s->scene, tests, &s->report[s->reports], room < left ? room : left, &progress);
    s->reports += status == GJK_OK ? progress.reports : 0;
  } while (status == GJK_OK && progress.pairs_left + progress.reports_left > 0 && s->reports < GAME_REPORTS);
  CHECK(s->reports < GAME_REPORTS);
  s->scene.bindings = kept;
  return status;
}
