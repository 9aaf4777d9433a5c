// Contracts that stand in for a function's body under Eva: a precondition becomes one obligation per call. What the
// bodies do is shown by tests/prove/primitives.c.
#ifndef PROVE_CONTRACTS_H
#define PROVE_CONTRACTS_H

#include <stdint.h>

#include "gjk/collider.h"
#include "src/arith/gjk_vector.h"

// Shorter than 2^31. The components of two such vectors' cross product are below 2^62: tests/prove/lengths.c.
#define SHORT(x, y, z) ((x) * (x) + (y) * (y) + (z) * (z) < 0x4000000000000000)

/*@ requires fits: -0x80000000 <= a.x + b.x <= 0x7fffffff && -0x80000000 <= a.y + b.y <= 0x7fffffff &&
      -0x80000000 <= a.z + b.z <= 0x7fffffff;
    assigns \result \from a, b;
    ensures \result.x == a.x + b.x && \result.y == a.y + b.y && \result.z == a.z + b.z; */
static inline gjk_vec3 gjk_add(gjk_vec3 a, gjk_vec3 b);

/*@ requires fits: -0x7fffffff <= a.x - b.x <= 0x7fffffff && -0x7fffffff <= a.y - b.y <= 0x7fffffff &&
      -0x7fffffff <= a.z - b.z <= 0x7fffffff;
    assigns \result \from a, b;
    ensures \result.x == a.x - b.x && \result.x >= -0x7fffffff;
    ensures \result.y == a.y - b.y && \result.y >= -0x7fffffff;
    ensures \result.z == a.z - b.z && \result.z >= -0x7fffffff; */
static inline gjk_vec3 gjk_sub(gjk_vec3 a, gjk_vec3 b);

/*@ requires positive: x != 0;
    assigns \result \from x;
    ensures \result <= 31;
    ensures x >= 0x80000000 ==> \result == 0;
    ensures x >= 0x40000000 ==> \result <= 1;
    ensures x >= 0x20000000 ==> \result <= 2;
    ensures x >= 0x10000000 ==> \result <= 3;
    ensures x >= 0x8000 ==> \result <= 16;
    ensures x < 0x80000000 ==> \result >= 1;
    ensures x < 0x40000000 ==> \result >= 2;
    ensures x < 0x20000000 ==> \result >= 3; */
static inline unsigned gjk_clz32(uint32_t x);

/*@ requires positive: x != 0;
    assigns \result \from x;
    ensures \result <= 63;
    ensures x >= 0x8000000000000000 ==> \result == 0;
    ensures x >= 0x4000000000000000 ==> \result <= 1;
    ensures x >= 0x1000000000000000 ==> \result <= 3;
    ensures x >= 0x40000000 ==> \result <= 33;
    ensures x < 0x8000000000000000 ==> \result >= 1; */
static inline unsigned gjk_clz64(uint64_t x);

/*@ requires fits: a.x > -0x80000000 && a.y > -0x80000000 && a.z > -0x80000000;
    assigns \result \from a;
    ensures \result.x == -a.x && \result.y == -a.y && \result.z == -a.z; */
static inline gjk_vec3 gjk_negate(gjk_vec3 a);

// The products, however they are made.
/*@ assigns \result \from a, b;
    ensures \result == a * b; */
static inline int64_t gjk_mul32(int32_t a, int32_t b);

/*@ assigns \result \from a, b;
    ensures \result == a * b; */
static inline uint64_t gjk_umul32(uint32_t a, uint32_t b);

/*@ requires fits: -0x7fffffffffffffff - 1 <= sum + a * b <= 0x7fffffffffffffff;
    assigns \result \from sum, a, b;
    ensures \result == sum + a * b; */
static inline int64_t gjk_mac32(int64_t sum, int32_t a, int32_t b);

/*@ requires set_a: \initialized(&a->x) && \initialized(&a->y) && \initialized(&a->z);
    requires set_b: \initialized(&b->x) && \initialized(&b->y) && \initialized(&b->z);
    requires fits_xy: -0x7fffffffffffffff - 1 <= a->x * b->x + a->y * b->y <= 0x7fffffffffffffff;
    requires fits: -0x7fffffffffffffff - 1 <= a->x * b->x + a->y * b->y + a->z * b->z <= 0x7fffffffffffffff;
    assigns \result \from *a, *b;
    ensures \result == a->x * b->x + a->y * b->y + a->z * b->z;
    ensures a == b ==> \result >= 0;
    ensures a == b && (a->x != 0 || a->y != 0 || a->z != 0) ==> \result > 0; */
static inline int64_t gjk_dot(const gjk_vec3 *a, const gjk_vec3 *b);

/*@ requires set_a: \initialized(&a->x) && \initialized(&a->y) && \initialized(&a->z);
    requires set_b: \initialized(&b->x) && \initialized(&b->y) && \initialized(&b->z);
    requires short: SHORT(a->x, a->y, a->z) && SHORT(b->x, b->y, b->z);
    assigns out->x, out->y, out->z \from *a, *b;
    ensures \initialized(&out->x) && \initialized(&out->y) && \initialized(&out->z);
    ensures out->x == a->y * b->z - a->z * b->y && -0x4000000000000000 < out->x < 0x4000000000000000;
    ensures out->y == a->z * b->x - a->x * b->z && -0x4000000000000000 < out->y < 0x4000000000000000;
    ensures out->z == a->x * b->y - a->y * b->x && -0x4000000000000000 < out->z < 0x4000000000000000; */
static inline void gjk_cross(const gjk_vec3 *a, const gjk_vec3 *b, gjk_long3 *out);

// Shown for every x by tests/prove/exhaust.c: 2^63 / x.
/*@ requires normal: x >= 0x80000000;
    assigns \result \from x;
    ensures 0x7fffffff <= \result; */
uint32_t gjk_reciprocal(uint32_t x);

// Shown for every x by tests/prove/exhaust.c: 2^46 / sqrt(x).
/*@ requires normal: x >= 0x40000000;
    assigns \result \from x;
    ensures 0x3fffffff <= \result <= 0x7fffffff; */
uint32_t gjk_reciprocal_root(uint32_t x);

// Shown for every x by tests/prove/exhaust.c: 2^46 / sqrt(x), of src/plane/gjk2_measure_inline.h.
/*@ requires normal: x >= 0x40000000;
    assigns \result \from x;
    ensures 0x3fffffff <= \result <= 0x7fffffff; */
static uint32_t gjk2_inverse_root(uint32_t x);

// Its root is at most 3/2 too large, so that a component is at most 1 too large; the assertion beside the code checks
// it.
/*@ requires set: \initialized(&d->x) && \initialized(&d->y) && \initialized(&d->z);
    requires fits: d->x * d->x + d->y * d->y + d->z * d->z <= 0x3fffffffffffffff;
    requires nonzero: d->x != 0 || d->y != 0 || d->z != 0;
    assigns \result \from *d;
    ensures -0x40000001 <= \result.x <= 0x40000001;
    ensures -0x40000001 <= \result.y <= 0x40000001;
    ensures -0x40000001 <= \result.z <= 0x40000001; */
gjk_unit3 gjk_unit(const gjk_vec3 *d);

// The cross product of two edges shorter than 2^31.
/*@ requires edges: SHORT(b->x - a->x, b->y - a->y, b->z - a->z) && SHORT(c->x - a->x, c->y - a->y, c->z - a->z);
    assigns out->x, out->y, out->z \from *a, *b, *c;
    ensures \initialized(&out->x) && \initialized(&out->y) && \initialized(&out->z);
    ensures -0x4000000000000000 < out->x < 0x4000000000000000;
    ensures -0x4000000000000000 < out->y < 0x4000000000000000;
    ensures -0x4000000000000000 < out->z < 0x4000000000000000; */
static inline void gjk_triangle_normal(const gjk_vec3 *a, const gjk_vec3 *b, const gjk_vec3 *c, gjk_long3 *out);

// Shown by tests/prove/facet.c.
/*@ requires positive: along > 0 ==> squared > 0;
    assigns \result \from along, squared;
    ensures \result <= 0x3fffff; */
uint32_t gjk_height_key(int64_t along, int64_t squared);

// Byte by byte, which Eva does not follow. A driver of what copies other things than colliders defines PROVE_COPY_BODY; one
// of what copies whole objects by their type's size, and needs their values after it, PROVE_COPY_WHOLE: an assignment.
#ifdef PROVE_COPY_WHOLE
#define PROVE_COPY_BODY
#include "src/arith/gjk_memory.h"
#define gjk_copy(to, from, bytes) \
  ((void)sizeof(char[(bytes) == sizeof *(to) && sizeof *(to) == sizeof *(from) ? 1 : -1]), (void)(*(to) = *(from)))
#endif
#ifndef PROVE_COPY_BODY
/*@ requires set: \initialized(&((gjk_collider *)from)->shape) && \initialized(&((gjk_collider *)from)->centre.x);
    requires whole: bytes == sizeof(gjk_collider);
    assigns *(gjk_collider *)to \from *(gjk_collider *)from;
    ensures \initialized((gjk_collider *)to);
    ensures ((gjk_collider *)to)->shape == ((gjk_collider *)from)->shape; */
static void gjk_copy(void *to, const void *from, size_t bytes);
#endif

#endif
