// gjk/compound.h: a list and a tree of any parts; and each function of the class on nodes of any content, any region.
#include "gjk/compound.h"

#include "colliders.h"
#include "src/parts/gjk_parts_class.h"

// Values of CASE.
#define LIST 1
#define TREE 2
#define CLASS 3

#if CASE == TREE
#define PARTS (GJK_COMPOUND_LIST_MAX + 1)
#else
#define PARTS 3
#endif
#define NODES GJK_COMPOUND_NODES(PARTS)

static gjk_shape shape;
static gjk_compound_part parts[PARTS];
static gjk_compound_node nodes[NODES];

static void any_parts(void) {
  shape.type = &polytope;
  for (int i = 0; i < PARTS; i++) {
    parts[i].shape = any_bool() ? &shape : NULL;
    parts[i].pose = any_pose();
  }
}

#if CASE != CLASS
static void build(int32_t count, uint32_t capacity) {
  gjk_compound c;
  const int status = gjk_compound_build(any_bool() ? parts : NULL, (uint16_t)count, any_bool() ? nodes : NULL, capacity,
                                        any_bool() ? &c : NULL);
  //@ split status;
  if (status == GJK_OK) {
    //@ assert c.count >= 1 && c.count <= PARTS && c.node_count <= NODES;
    check_size(c.reach, UINT32_MAX);
    for (int i = 0; i < c.node_count; i++) {
      //@ assert nodes[i].skip > i && nodes[i].skip <= NODES;
      //@ assert nodes[i].part < PARTS || nodes[i].part == UINT16_MAX;
      check_size(nodes[i].box.lower.x ^ nodes[i].box.upper.z, INT64_C(1) << 31);
    }
  }
}
#else
static void any_nodes(void) {
  for (int i = 0; i < NODES; i++) {
    nodes[i].box.lower = any_position();
    nodes[i].box.upper = any_position();
    nodes[i].skip = any_uint16();
    nodes[i].part = any_uint16();
  }
}

static void use_class(const gjk_compound *c) {
  const gjk_parts_class *type = &gjk_parts_class_compound;
  const gjk_parts body = {type, c, any_pose()};
  gjk_parts_frame frame;
  gjk_region region;
  gjk_parts_walk walk;
  gjk_parts_room room;
  gjk_parts_local local;
  gjk_collider out;
  uint32_t number;
  const uint32_t count = type->count(c);
  if (count == 0) {
    return;
  }
  (void)type->reach(c);
  frame.parts = &body;
  region.box.lower = any_position();
  region.box.upper = any_position();
  for (int i = 0; i < 3; i++) {
    region.lower[i] = Frama_C_long_long_interval(-(INT64_C(1) << 34), INT64_C(1) << 34);
    region.upper[i] = Frama_C_long_long_interval(-(INT64_C(1) << 34), INT64_C(1) << 34);
    region.way[i] = Frama_C_long_long_interval(-(INT64_C(1) << 34), INT64_C(1) << 34);
  }
  region.moves = any_bool();
  const uint32_t guess = type->guess(c, &region);
  //@ assert guess < count;
  (void)type->place(&frame, guess, &room, &out);
  gjk_parts_walk_start(&walk);
  while (type->next(c, &region, &walk, &number)) {
    (void)type->place(&frame, number, &room, &out);
    const int status = type->local(c, number, &room, &local);
    //@ split status;
    if (status == GJK_OK) {
      check_size(local.own->position.x, INT64_C(1) << 31);
    }
  }
}
#endif

int main(void) {
  any_parts();
#if CASE == CLASS
  any_nodes();
  for (int32_t count = 0; count <= PARTS; count++) {
    const gjk_compound c = {any_bool() ? parts : NULL, any_bool() ? nodes : NULL, (uint32_t)any_int32(),
                            (uint16_t)count, (uint16_t)any_between(0, NODES)};
    use_class(&c);
  }
#else
  for (int32_t count = CASE == TREE ? PARTS : 0; count <= PARTS; count++) {
    build(count, (uint32_t)any_between(0, NODES));
  }
#endif
  return 0;
}
