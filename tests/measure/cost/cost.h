// What a query costs, by family of pairs: this library's and other libraries' methods of answering it.
//
// prepare makes what a user would keep between queries; it is not measured. run answers, again and again.
#ifndef COST_H
#define COST_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define COST_LSB_PER_UNIT 65536.0

// COST_POSE: poses A. Its answer is the x of A's centre.
// COST_CONTACTS: the answer is the number of contacts, and the sum of their distances.
typedef enum cost_query {
  COST_DISTANCE,
  COST_INTERSECT,
  COST_DEPTH,
  COST_CONTACTS,
  COST_POSE,
  COST_QUERIES
} cost_query;

// COST_COLD        both shapes posed already, nothing remembered
// COST_WARM        posed already; remembers the answer of the pose one step ago
// COST_POSED       poses both shapes, then as COST_COLD
// COST_POSED_WARM  poses both shapes, then as COST_WARM
typedef enum cost_mode { COST_COLD, COST_WARM, COST_POSED, COST_POSED_WARM, COST_MODES } cost_mode;

typedef enum cost_kind { COST_BOX, COST_HULL, COST_CAPSULE, COST_SPHERE } cost_kind;

// A pose in units; the rotation is a unit quaternion x, y, z, w.
typedef struct cost_place {
  double position[3], rotation[4];
} cost_place;

// A shape in its own frame, in units. The numbers are exactly the library's integers.
typedef struct cost_solid {
  cost_kind kind;
  double half[3];  // of a box; of a capsule half[2], along z
  double radius;   // of a sphere or capsule
  double (*vertices)[3];
  size_t count;
  cost_place at, before;  // now, and one step ago
} cost_solid;

struct case_pair;

// A pair of shapes: as the library takes them, and in units.
typedef struct cost_pair {
  struct case_pair *shapes, *before;  // before: one step ago
  cost_solid solid[2];
} cost_pair;

// Answers about a prepared pair: in units the distance or the depth, or 1 if the shapes touch and 0 if not.
typedef double cost_run(void *prepared);

// A way to answer.
//
// library  methods of one library compete; the cheapest that answers right is its best
// choose   how the method answers a query about such shapes, or NULL if it does not
typedef struct cost_method {
  const char *library, *name;
  cost_run *(*choose)(cost_kind a, cost_kind b, cost_query query, cost_mode mode);
  void *(*prepare)(const cost_pair *pair, cost_query query);
  void (*release)(void *prepared);
} cost_method;

// Lists of methods, each ended by NULL. Those of other libraries are linked if their package is installed.
typedef const cost_method *const cost_method_list[];

extern cost_method_list cost_gjk_methods;
extern cost_method_list cost_ccd_methods, cost_bullet_methods, cost_fcl_methods, cost_ode_methods;

#ifdef __cplusplus
}
#endif

#endif
