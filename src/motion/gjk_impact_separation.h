// How far two moving shapes are apart along a direction, and how long they provably stay apart.
//
// The cores are posed at the start of a step. From there they move and turn rigidly by their motions, in real numbers.
// The direction stands still or turns steadily. It turns about an axis of its own, or with one of the shapes, whose
// extent along it then does not change. The separation at a fraction f is that of the cores' planes across the
// direction, B's less A's:
//   s(f) = n . (p_b - p_a) + min of n . v over v of B - max of n . u over u of A,   u, v relative to the poses' positions
// The gap of the cores is at least s. For each pair u, v the minimised function is smooth, so for fractions x < y
//   s(x + z (y - x)) >= (1 - z) s(x) + z s(y) - c z (1 - z)   with   c = (y - x)^2 / 2 times a bound of its second derivative
// That is the chord less a parabola. Where it is above the wanted separation, the shapes are farther apart than that.
//
// The bound times (y - x)^2, with the angle w by which a body turns between x and y, r for the distance of its farthest
// point from its pose's position, and k for the sine of the angle between an axis and n:
//   n stands still       k r w^2 of each body
//   n turns by v         k v^2 (|p_b - p_a| + r + r') + 2 k v (|way of p_b - p_a| + r w + r' w') + r w^2 + r' w'^2
//   n turns with a body  the same without its r
#ifndef GJK_SRC_IMPACT_SEPARATION_H
#define GJK_SRC_IMPACT_SEPARATION_H

#include "../shape/gjk_shape_class.h"
#include "gjk/certificate.h"
#include "gjk_motion.h"

// Hulls of up to this many vertices are baked in each pose, on the stack.
#if GJK_SHAPES >= GJK_SHAPES_POLYTOPES
#define GJK_MOVER_VERTICES 8
#else
#define GJK_MOVER_VERTICES 1
#endif

// A body of a query.
typedef struct gjk_mover {
  const gjk_motion *motion;
  const gjk_pose *own;  // the collider's pose in the frame of the body that moves; NULL: the body's own
  gjk_vec3 place;       // the position of the body that the collider is posed for
  uint32_t reach;       // of the core's points from the body's position, LSB, posing included
  uint32_t angle;       // it turns by this over the whole way, radians, Q16, rounded up; 0: nothing turns
  gjk_turning turning;
  gjk_collider collider;
  gjk_vec3 baked[GJK_MOVER_VERTICES];
} gjk_mover;

// The bodies of a query, A and B, and what stays as it is on the way.
typedef struct gjk_movers {
  gjk_mover mover[2];
  gjk_long3 from, to;  // p_b - p_a at the start and the end of the way, LSB
  uint64_t end, way;   // |to|, and how far both go on the whole way; LSB, or more
  bool near;           // components of from and to are surely int32; not used in builds for size
} gjk_movers;

// Fills in all but the movers, and their angles. Pre: their motions and turnings are set.
void gjk_movers_start(gjk_movers *of);

// The direction, and the fraction from which on it counts: both colliders are posed at start.
typedef struct gjk_separation {
  const gjk_movers *pair;
  gjk_unit3 n;  // from A to B
  gjk_q30 start;
  const gjk_turning *carrier;  // how the direction turns from there on; NULL: it stands still
  int64_t fall;                // an estimate: how much s would fall over the whole way at the rate of the start, Q8
} gjk_separation;

// A build for points alone has no carrier: their features are a vertex each.
static inline const gjk_turning *gjk_separation_carrier(const gjk_separation *s) {
  return GJK_SHAPES >= GJK_SHAPES_ROUND ? s->carrier : NULL;
}

// The last fraction up to which s is proven to be above target all the way from the start; the start itself if s is not
// above target there.
// above   s - target at the start, or less; below 0: not known.
// target  LSB, Q8, the errors of s included.
// enough  Stops early once s - target is at most that.
// The estimate of s->fall changes the answer and its cost, not what it proves.
// If the direction would turn too far away from the bodies, s->carrier becomes NULL.
gjk_q30 gjk_separation_holds(gjk_separation *s, int64_t above, int64_t target, int64_t enough);

// The bodies have spheres about the positions of their poses. Up to this fraction the spheres are surely more than
// target apart, along the direction from A to B at the start. 0 if they are not at the start. target as above.
gjk_q30 gjk_separation_of_spheres(const gjk_movers *pair, int64_t target);

// An estimate of s->fall for points of A and B that are nearest to each other at the start.
int64_t gjk_separation_fall(const gjk_separation *s, const gjk_vec3 *point_a, const gjk_vec3 *point_b);

// How the direction n across an edge of either body turns, at the rate of the start; both are posed there.
// nearest   names two different vertices of each
// False: the edges are nearly parallel, a body turns by a turn or more, or the direction stands still.
bool gjk_turning_of_edges(const gjk_mover mover[2], const gjk_certificate *nearest, const gjk_unit3 *n,
                          gjk_turning *out);

#endif
