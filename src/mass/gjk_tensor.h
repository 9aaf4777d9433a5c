// Symmetric tensors of 64-bit entries, rotated by matrices in Q2.30.
#ifndef GJK_SRC_TENSOR_H
#define GJK_SRC_TENSOR_H

#include "../arith/gjk_vector.h"
#include "gjk/mass.h"

// The largest size of an entry of an inertia tensor, square LSB: a radius of gyration of 2^30 LSB.
#define GJK_INERTIA_MAX (INT64_C(1) << 60)

// out = R T R', for the rotation matrix with these rows, Q2.30. Each entry is within 12 of the exact one for the matrix as
// it is. The identity is exact. Pre: entries are at most GJK_INERTIA_MAX in size. T has no negative eigenvalue, or is
// not much larger along other axes for another reason: |out| <= 3 GJK_INERTIA_MAX.
void gjk_rotate_tensor(const gjk_vec3 rows[3], const gjk_inertia *t, gjk_inertia *out);

// Are all entries at most GJK_INERTIA_MAX in size?
bool gjk_tensor_fits(const gjk_inertia *t);

#endif
