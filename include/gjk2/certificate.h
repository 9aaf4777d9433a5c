// Certificates of the plane: why an answer is right, in integers that anyone can check.
//
// A number names a vertex. For a polygon or triangle it is the index. For a box, segment or point, bits 0 and 1 are set
// for the plus side of the half axes x and y. A pair (a[i], b[i]) stands for the point a - b of the Minkowski
// difference of the two cores.
#ifndef GJK2_CERTIFICATE_H
#define GJK2_CERTIFICATE_H

#include "gjk2/collider.h"

#ifdef __cplusplus
extern "C" {
#endif

// What a certificate proves.
typedef enum gjk2_proof {
  GJK2_PROOF_NONE = 0,   // curved shapes: there are no vertices to name
  GJK2_PROOF_CIRCLES,    // apart: the bounding circles are
  GJK2_PROOF_DIRECTION,  // apart: every a - b lies behind the line across direction, at the asked distance
  GJK2_PROOF_NEAREST,    // one pair or two span the feature nearest to the origin: no vertex lies before its line
  GJK2_PROOF_NEAR,       // together: one pair or two span a feature that comes within the asked distance
  GJK2_PROOF_ENCLOSING,  // together: the pairs span a point, segment or triangle with the origin in it
  GJK2_PROOF_EDGE,       // depth: two pairs span a line that no a - b lies beyond, outwards to the right of w0 -> w1
  GJK2_PROOF_LINE        // depth 0 of the cores: across direction, no a - b lies beyond the origin
} gjk2_proof;

// Why an answer is right, see gjk2_proof.
typedef struct gjk2_certificate {
  gjk2_vec direction;   // GJK2_PROOF_DIRECTION, GJK2_PROOF_LINE: from A to B; the first is shorter than 2^31
  uint16_t a[3], b[3];  // numbers of vertices of A and B, in pairs
  uint8_t count;        // pairs in use
  uint8_t proof;        // a gjk2_proof
} gjk2_certificate;

#ifdef __cplusplus
}
#endif

#endif
