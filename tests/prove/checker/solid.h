// Geometry of space over the integers, and lemmas about it: the words of geometry.h with a third coordinate.
#ifndef PROVE_CHECKER_SOLID_H
#define PROVE_CHECKER_SOLID_H

#include "geometry.h"

/*@ logic integer dot3(integer x, integer y, integer z, integer u, integer v, integer w) = x * u + y * v + z * w;
    logic integer norm3(integer x, integer y, integer z) = x * x + y * y + z * z;
    logic integer size3(integer x, integer y, integer z) = (x < 0 ? -x : x) + (y < 0 ? -y : y) + (z < 0 ? -z : z);
    predicate in_ball(integer x, integer y, integer z, integer r) = norm3(x, y, z) <= r * r;
    // Spheres of radii that add up to r, whose centres are (x, y, z) apart, have no point in common.
    predicate spheres_apart(integer x, integer y, integer z, integer r) = norm3(x, y, z) > r * r;
    // The point lies more than r before the plane across d through the origin.
    predicate beyond3(integer dx, integer dy, integer dz, integer x, integer y, integer z, integer r) =
      dot3(dx, dy, dz, x, y, z) < 0 && farther(-dot3(dx, dy, dz, x, y, z), r, norm3(dx, dy, dz));
    predicate clear3(integer dx, integer dy, integer dz, integer h, integer r) =
      h < 0 && farther(-h, r, norm3(dx, dy, dz));
    predicate behind_one3(integer dx, integer dy, integer dz, integer x, integer y, integer z,
        integer u, integer v, integer w, integer s, integer t, integer q, integer h) =
      dot3(x, y, z, dx, dy, dz) + dot3(u, v, w, dx, dy, dz) + dot3(s, t, q, -dx, -dy, -dz) <= h;
    predicate beyond_one3(integer dx, integer dy, integer dz, integer x, integer y, integer z,
        integer u, integer v, integer w, integer s, integer t, integer q, integer r) =
      beyond3(dx, dy, dz, x + u - s, y + v - t, z + w - q, r);
    predicate small3(integer dx, integer dy, integer dz, integer x, integer y, integer z) =
      -0x4000000000000000 < dot3(dx, dy, dz, x, y, z) < 0x4000000000000000;
    predicate small_one3(integer dx, integer dy, integer dz, integer x, integer y, integer z,
        integer u, integer v, integer w, integer s, integer t, integer q) =
      small3(dx, dy, dz, x + u - s, y + v - t, z + w - q);
    predicate sum_in3(integer x, integer y, integer z, integer u, integer v, integer w, integer r, integer s) =
      at_most(dot3(x, y, z, u, v, w), r, s) && in_ball(x + u, y + v, z + w, r + s); */

/*@ logic integer square(integer t) = t * t;
    lemma square: \forall integer t; 0 <= square(t);
    lemma square_most: \forall integer t, r; -r <= t <= r ==> t * t <= r * r;
    lemma lagrange: \forall integer x, y, z, u, v, w; norm3(x, y, z) * norm3(u, v, w) == square(dot3(x, y, z, u, v, w)) +
      square(x * v - y * u) + square(y * w - z * v) + square(z * u - x * w);
    lemma cauchy_square: \forall integer x, y, z, u, v, w;
      square(dot3(x, y, z, u, v, w)) <= norm3(x, y, z) * norm3(u, v, w);
    lemma under_square: \forall integer t, a, b; square(t) <= a * b ==> under(t, a, b);
    lemma cauchy3: \forall integer x, y, z, u, v, w; under(dot3(x, y, z, u, v, w), norm3(x, y, z), norm3(u, v, w));
    lemma norm3: \forall integer x, y, z; 0 <= norm3(x, y, z);
    lemma ball: \forall integer x, y, z, r; 0 <= r && in_ball(x, y, z, r) ==> -r <= x <= r && -r <= y <= r && -r <= z <= r;
    lemma sum_of_balls: \forall integer x, y, z, u, v, w, r, s; in_ball(x, y, z, r) && in_ball(u, v, w, s) &&
      at_most(dot3(x, y, z, u, v, w), r, s) ==> in_ball(x + u, y + v, z + w, r + s);
    lemma balls_product: \forall integer x, y, z, u, v, w, r, s;
      0 <= r && 0 <= s && in_ball(x, y, z, r) && in_ball(u, v, w, s) ==> at_most(dot3(x, y, z, u, v, w), r, s);
    lemma triangle3: \forall integer x, y, z, u, v, w, r, s;
      0 <= r && 0 <= s && in_ball(x, y, z, r) && in_ball(u, v, w, s) ==> sum_in3(x, y, z, u, v, w, r, s);
    lemma opposite3: \forall integer x, y, z, r; in_ball(x, y, z, r) ==> in_ball(-x, -y, -z, r);
    lemma square_below: \forall integer t; t * t < 0x10000000000000000000000000000000 ==>
      -0x4000000000000000 < t < 0x4000000000000000;
    lemma along3: \forall integer dx, dy, dz, x, y, z; norm3(dx, dy, dz) < 0x4000000000000000 &&
      in_ball(x, y, z, 0x60000000) ==> small3(dx, dy, dz, x, y, z);
    lemma lowest3: \forall integer dx, dy, dz, x, y, z, u, v, w, s, t, q, h;
      behind_one3(dx, dy, dz, x, y, z, u, v, w, s, t, q, h) && small_one3(dx, dy, dz, x, y, z, u, v, w, s, t, q) ==>
      -0x4000000000000000 < h;
    lemma beyond3: \forall integer dx, dy, dz, x, y, z, r, h; 0 < h && dot3(dx, dy, dz, x, y, z) <= -h &&
      farther(h, r, norm3(dx, dy, dz)) ==> beyond3(dx, dy, dz, x, y, z, r);
    lemma beyond_one3: \forall integer dx, dy, dz, x, y, z, u, v, w, s, t, q, r, h;
      behind_one3(dx, dy, dz, x, y, z, u, v, w, s, t, q, h) && clear3(dx, dy, dz, h, r) ==>
      beyond_one3(dx, dy, dz, x, y, z, u, v, w, s, t, q, r);
    lemma wide3: \forall integer x, y, z, r; 0 <= r && (x > r || -x > r || y > r || -y > r || z > r || -z > r) ==>
      spheres_apart(x, y, z, r);
    predicate close3(integer x, integer y, integer z) = -0x20000003 <= x <= 0x20000003 &&
      -0x20000003 <= y <= 0x20000003 && -0x20000003 <= z <= 0x20000003;
    lemma close_square: \forall integer t; -0x20000003 <= t <= 0x20000003 ==> t * t <= 0x400000C00000009;
    lemma close3: \forall integer x, y, z; close3(x, y, z) ==> in_ball(x, y, z, 0x40000000); */

// Features of A - B by their vertices p = (x, y, z), q = (u, v, w), and so on.
/*@ // p . (p - q), and twice the triangle's area as a vector.
    logic integer toward3(integer x, integer y, integer z, integer u, integer v, integer w) =
      norm3(x, y, z) - dot3(x, y, z, u, v, w);
    logic integer area3(integer x, integer y, integer u, integer v, integer s, integer t) = cross(u - x, v - y, s - x, t - y);
    // (p x q) . r
    logic integer volume3(integer x, integer y, integer z, integer u, integer v, integer w, integer s, integer t, integer q) =
      dot3(cross(y, z, v, w), cross(z, x, w, u), cross(x, y, u, v), s, t, q);
    // The third vertex's coordinate of the origin's foot in the triangle, times the square of twice the area.
    logic integer share_of(integer a, integer b, integer c, integer e) = a * b + c * (e - a);
    logic integer share3(integer x, integer y, integer z, integer u, integer v, integer w, integer s, integer t, integer q) =
      share_of(toward3(u, v, w, x, y, z), toward3(x, y, z, s, t, q), toward3(x, y, z, u, v, w), toward3(u, v, w, s, t, q));
    // The origin's foot lies within the segment; within the triangle.
    predicate foot3(integer x, integer y, integer z, integer u, integer v, integer w) =
      toward3(x, y, z, u, v, w) > 0 && toward3(u, v, w, x, y, z) > 0;
    predicate inside3(integer x, integer y, integer z, integer u, integer v, integer w, integer s, integer t, integer q) =
      share3(x, y, z, u, v, w, s, t, q) > 0 && share3(u, v, w, s, t, q, x, y, z) > 0 && share3(s, t, q, x, y, z, u, v, w) > 0;
    // The segment, triangle or tetrahedron holds the origin.
    predicate meets_one(integer x, integer u, integer s, integer t) = x * t + u * s == 0;
    predicate on_edge3(integer x, integer y, integer z, integer u, integer v, integer w) = foot3(x, y, z, u, v, w) &&
      meets_one(x, u, toward3(x, y, z, u, v, w), toward3(u, v, w, x, y, z)) &&
      meets_one(y, v, toward3(x, y, z, u, v, w), toward3(u, v, w, x, y, z)) &&
      meets_one(z, w, toward3(x, y, z, u, v, w), toward3(u, v, w, x, y, z));
    predicate on_face3(integer x, integer y, integer z, integer u, integer v, integer w, integer s, integer t, integer q) =
      inside3(x, y, z, u, v, w, s, t, q) && volume3(x, y, z, u, v, w, s, t, q) == 0;
    predicate one_side(integer a, integer b, integer c, integer d) =
      0 <= a && 0 <= b && 0 <= c && 0 <= d && 0 < a + b + c + d;
    predicate in_tetrahedron(integer x, integer y, integer z, integer u, integer v, integer w,
        integer s, integer t, integer q, integer k, integer l, integer m) =
      one_side(volume3(u, v, w, s, t, q, k, l, m), -volume3(x, y, z, s, t, q, k, l, m),
        volume3(x, y, z, u, v, w, k, l, m), -volume3(x, y, z, u, v, w, s, t, q)) ||
      one_side(-volume3(u, v, w, s, t, q, k, l, m), volume3(x, y, z, s, t, q, k, l, m),
        -volume3(x, y, z, u, v, w, k, l, m), volume3(x, y, z, u, v, w, s, t, q));
    // The segment's or triangle's point nearest to the origin lies within it, and is within r.
    predicate near_edge3(integer x, integer y, integer z, integer u, integer v, integer w, integer r) =
      foot3(x, y, z, u, v, w) && norm3(x, y, z) * norm3(u, v, w) - dot3(x, y, z, u, v, w) * dot3(x, y, z, u, v, w) <=
      r * r * (toward3(x, y, z, u, v, w) + toward3(u, v, w, x, y, z));
    predicate near_face3(integer x, integer y, integer z, integer u, integer v, integer w,
        integer s, integer t, integer q, integer r) = inside3(x, y, z, u, v, w, s, t, q) &&
      volume3(x, y, z, u, v, w, s, t, q) * volume3(x, y, z, u, v, w, s, t, q) <=
      r * r * norm3(area3(y, z, v, w, t, q), area3(z, x, w, u, q, s), area3(x, y, u, v, s, t)); */

// The square of a feature's distance from the origin is n / m; the direction d, from w of the feature, tells the same; and
// in units of which f are an LSB the distance rounds to k, a tie up.
/*@ predicate point_far(integer x, integer y, integer z, integer n, integer m) = n == norm3(x, y, z) && m == 1;
    predicate edge_far(integer x, integer y, integer z, integer u, integer v, integer w, integer n, integer m) =
      foot3(x, y, z, u, v, w) && m == toward3(x, y, z, u, v, w) + toward3(u, v, w, x, y, z) &&
      n == norm3(x, y, z) * norm3(u, v, w) - dot3(x, y, z, u, v, w) * dot3(x, y, z, u, v, w);
    predicate face_far(integer x, integer y, integer z, integer u, integer v, integer w, integer s, integer t, integer q,
        integer n, integer m) = inside3(x, y, z, u, v, w, s, t, q) &&
      n == volume3(x, y, z, u, v, w, s, t, q) * volume3(x, y, z, u, v, w, s, t, q) &&
      m == norm3(area3(y, z, v, w, t, q), area3(z, x, w, u, q, s), area3(x, y, u, v, s, t));
    predicate across3(integer dx, integer dy, integer dz, integer x, integer y, integer z, integer n, integer m) =
      dot3(dx, dy, dz, x, y, z) * dot3(dx, dy, dz, x, y, z) * m == n * norm3(dx, dy, dz);
    predicate below_half(integer n, integer m, integer f, integer k) =
      4 * n < (2 * k + 1) * f * ((2 * k + 1) * f) * m;
    predicate above_half(integer n, integer m, integer f, integer k) =
      (2 * k - 1) * f * ((2 * k - 1) * f) * m <= 4 * n;
    predicate rounded3(integer n, integer m, integer f, integer k) =
      below_half(n, m, f, k) && (k == 0 || above_half(n, m, f, k)); */

#endif
