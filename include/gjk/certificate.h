// Certificates: why an answer is right, in integers that anyone can check.
//
// A number names a vertex. For a hull or triangle it is the index. For a box or point, bits 0, 1 and 2 are set for the
// plus side of the half axes x, y and z. For a segment, bit 0 is set for plus z. A pair (a[i], b[i]) stands for the
// point a - b of the Minkowski difference of the two cores.
#ifndef GJK_CERTIFICATE_H
#define GJK_CERTIFICATE_H

#include "gjk/collider.h"

#ifdef __cplusplus
extern "C" {
#endif

// What a certificate proves.
typedef enum gjk_proof {
  GJK_PROOF_NONE = 0,   // curved shapes: there are no vertices to name
  GJK_PROOF_SPHERES,    // apart: the bounding spheres are
  GJK_PROOF_DIRECTION,  // apart: every a - b lies behind the plane across direction, at the asked distance
  GJK_PROOF_NEAREST,    // the pairs span the feature nearest to the origin: no vertex lies before its plane
  GJK_PROOF_NEAR,       // together: the pairs span a feature that comes within the asked distance
  GJK_PROOF_ENCLOSING,  // together: the pairs span a point, segment, triangle or tetrahedron with the origin in it
  GJK_PROOF_FACET,      // depth: three pairs span a plane, outwards by (w1 - w0) x (w2 - w0), that no a - b lies beyond
  GJK_PROOF_PLANE       // depth 0 of the cores: across direction, no a - b lies beyond the origin
} gjk_proof;

// Why an answer is right, see gjk_proof.
typedef struct gjk_certificate {
  gjk_vec3 direction;   // GJK_PROOF_DIRECTION, GJK_PROOF_PLANE: from A to B; the first is shorter than 2^31
  uint16_t a[4], b[4];  // numbers of vertices of A and B, in pairs
  uint8_t count;        // pairs in use
  uint8_t proof;        // a gjk_proof
} gjk_certificate;

#ifdef __cplusplus
}
#endif

#endif
