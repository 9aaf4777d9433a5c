// Firmware: instructions of queries of a box against compounds of crates in rows, with a tree and without: one line per query
// and number of parts.
#include "count.h"
#include "gjk/gjk.h"

#ifndef PARTS_BENCH_PARTS  // of boards with little memory fewer
#define PARTS_BENCH_PARTS 128
#endif

// What is asked.
typedef enum parts_bench_query {
  PARTS_BENCH_INTERSECT,
  PARTS_BENCH_DISTANCE,
  PARTS_BENCH_CONTACTS,
  PARTS_BENCH_CAST,
  PARTS_BENCH_EACH_DISTANCE,  // no body: each part posed before, asked by gjk_distance
  PARTS_BENCH_QUERIES
} parts_bench_query;

#define ROW 8

static const gjk_shape crate = GJK_BOX(GJK_Q16(0.5), GJK_Q16(0.5), GJK_Q16(0.5));
static const gjk_shape box = GJK_BOX(GJK_Q16(0.4), GJK_Q16(0.3), GJK_Q16(0.2));
static gjk_compound_part parts[PARTS_BENCH_PARTS];
static gjk_compound_node nodes[GJK_COMPOUND_NODES(PARTS_BENCH_PARTS)], list[PARTS_BENCH_PARTS];
static gjk_compound compound;
static gjk_collider each[PARTS_BENCH_PARTS];
static gjk_parts body;
static unsigned parts_made;

// Makes a compound of count crates, as a tree or as a list.
COUNTED void make(unsigned count, bool tree) {
  const gjk_pose identity = GJK_POSE_IDENTITY;
  const gjk_pose turned = {{GJK_Q16(3), GJK_Q16(-2), GJK_Q16(1)}, {0, 0, 410903207, 992008094}};  // 45 degrees about z
  const gjk_parts of = GJK_PARTS_OF_COMPOUND(&compound);
  gjk_parts_room room;
  for (unsigned i = 0; i < count; i++) {
    parts[i].shape = &crate;
    parts[i].pose = identity;
    parts[i].pose.position.x = (gjk_q16)(i % ROW) * GJK_Q16(1.5);
    parts[i].pose.position.y = (gjk_q16)(i / ROW) * GJK_Q16(1.5);
  }
  gjk_compound_build(parts, (uint16_t)count, nodes, GJK_COMPOUND_NODES(PARTS_BENCH_PARTS), &compound);
  for (unsigned i = 0; i < compound.node_count; i++) {
    if (nodes[i].part != UINT16_MAX) {
      list[nodes[i].part] = nodes[i];
      list[nodes[i].part].skip = (uint16_t)(nodes[i].part + 1);
    }
  }
  if (!tree) {
    compound.nodes = list;
    compound.node_count = compound.count;
  }
  body = of;
  body.pose = turned;
  parts_made = count;
  for (unsigned i = 0; i < count; i++) {
    gjk_parts_place(&body, i, &room, &each[i]);
  }
}

// Asks at one of 8 places of the box. Returns a number of the answer.
COUNTED uint32_t ask(parts_bench_query query, unsigned place) {
  static gjk_parts_manifold manifolds[4];
  const gjk_pose at = {{GJK_Q16(3) + (gjk_q16)place * GJK_Q16(0.7), (gjk_q16)place * GJK_Q16(0.4),
                        query == PARTS_BENCH_CAST       ? GJK_Q16(6)
                        : query == PARTS_BENCH_CONTACTS ? GJK_Q16(1.69)
                                                        : GJK_Q16(2)},
                       {0, 0, 0, GJK_Q30_ONE}};
  gjk_collider b;
  gjk_decision decision;
  gjk_distance_result distance;
  gjk_cast_result cast;
  uint32_t answer = 0;
  gjk_collider_init(&b, &box, NULL, 0);
  gjk_collider_pose(&b, &at);
  switch (query) {
    case PARTS_BENCH_INTERSECT: gjk_parts_intersect(&body, &b, &answer, &decision); break;
    case PARTS_BENCH_DISTANCE: gjk_parts_distance(&body, &b, &answer, &distance); break;
    case PARTS_BENCH_CONTACTS: gjk_parts_contacts(&body, &b, GJK_Q16(0.05), 4, NULL, manifolds, 4, &answer); break;
    case PARTS_BENCH_CAST: {
      const gjk_vec3 to = {at.position.x, at.position.y, GJK_Q16(-6)};
      const gjk_cast_path path = {NULL, &to, 0};
      gjk_parts_cast(&body, &b, &path, &answer, &cast);
      break;
    }
    default: {
      gjk_q16 least = INT32_MAX;
      for (unsigned i = 0; i < parts_made; i++) {
        gjk_distance(&each[i], &b, NULL, &distance);
        if (distance.distance < least) {
          least = distance.distance;
          answer = i;
        }
      }
    }
  }
  return answer;
}

int firmware_main(void) {
  static const char *const names[PARTS_BENCH_QUERIES] = {"intersect", "distance", "contacts", "cast",
                                                         "distance of each part posed before"};
  static const unsigned counts[] = {8, 32, 128};
  if (!count_prepare()) {
    return 1;
  }
  for (unsigned k = 0; k < 3 && counts[k] <= PARTS_BENCH_PARTS; k++) {
    for (int tree = 1; tree >= 0; tree--) {
      make(counts[k], tree == 1);
      for (int query = 0; query < PARTS_BENCH_QUERIES; query++) {
        uint32_t sum = 0;
        for (unsigned place = 0; place < 8; place++) {
          const uint32_t start = board_ticks();
          (void)ask((parts_bench_query)query, place);
          sum += count_since(start);
        }
        print_decimal(board_print, counts[k]);
        board_print(tree == 1 ? " parts, tree, " : " parts, list, ");
        board_print(names[query]);
        board_print(": ");
        print_decimal(board_print, sum / 8);
        board_print(" instructions\n");
      }
    }
  }
  return 0;
}
