// How far is a ball from a chair? A body of several convex parts may be concave; queries take it as A and name the part.
#include <stdio.h>

#include "gjk/gjk.h"

static const gjk_shape seat = GJK_BOX(GJK_Q16(0.5), GJK_Q16(0.5), GJK_Q16(0.1));
static const gjk_shape back = GJK_BOX(GJK_Q16(0.1), GJK_Q16(0.5), GJK_Q16(0.5));
static const gjk_shape ball = GJK_SPHERE(GJK_Q16(0.25));
static const gjk_compound_part parts[] = {{&seat, GJK_POSE_IDENTITY},
                                          {&back, {{GJK_Q16(-0.5), 0, GJK_Q16(0.5)}, {0, 0, 0, GJK_Q30_ONE}}}};

int main(void) {
  const gjk_pose beside = {{GJK_Q16(0.25), 0, GJK_Q16(0.5)}, {0, 0, 0, GJK_Q30_ONE}};
  gjk_compound_node nodes[GJK_COMPOUND_NODES(2)];
  gjk_compound chair;
  gjk_collider b = {0};
  gjk_distance_result gap;
  uint32_t part;

  if (gjk_compound_build(parts, 2, nodes, GJK_COMPOUND_NODES(2), &chair) != GJK_OK ||
      gjk_collider_init(&b, &ball, NULL, 0) != GJK_OK || gjk_collider_pose(&b, &beside) != GJK_OK) {
    return 1;
  }
  const gjk_parts body = GJK_PARTS_OF_COMPOUND(&chair);
  if (gjk_parts_distance(&body, &b, &part, &gap) != GJK_OK) {
    return 1;
  }
  printf("part %u, gap %ld LSB\n", (unsigned)part, (long)gap.distance);
  return 0;
}
// prints: part 0, gap 9830 LSB
