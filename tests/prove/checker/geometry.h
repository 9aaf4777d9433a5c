// Geometry of the plane over the integers, and lemmas about it.
#ifndef PROVE_CHECKER_GEOMETRY_H
#define PROVE_CHECKER_GEOMETRY_H

#include "operators.h"

/*@ predicate in_disc(integer x, integer y, integer r) = x * x + y * y <= r * r;
    logic integer dot(integer x, integer y, integer u, integer v) = x * u + y * v;
    logic integer cross(integer x, integer y, integer u, integer v) = x * v - y * u;
    predicate dot_fits(integer x, integer y, integer u, integer v) =
      -0x8000000000000000 <= x * u + y * v <= 0x7fffffffffffffff;
    predicate cross_fits(integer x, integer y, integer u, integer v) =
      -0x8000000000000000 <= x * v - y * u <= 0x7fffffffffffffff;

    // The point is within r of the origin.
    predicate near_point(integer x, integer y, integer r) = x * x + y * y <= r * r;
    // The origin's foot lies within the segment, and is within r of it.
    predicate foot(integer x, integer y, integer u, integer v) =
      dot(x, y, u - x, v - y) < 0 && dot(u, v, u - x, v - y) > 0;
    predicate near_line(integer x, integer y, integer u, integer v, integer r) =
      cross(x, y, u, v) * cross(x, y, u, v) <= r * r * dot(u - x, v - y, u - x, v - y);
    // The segment holds the origin.
    predicate on_segment(integer x, integer y, integer u, integer v) =
      cross(x, y, u, v) == 0 && dot(x, y, u, v) <= 0;
    // The triangle holds the origin.
    predicate in_triangle(integer x, integer y, integer u, integer v, integer s, integer t) =
      on_segment(x, y, u, v) || on_segment(u, v, s, t) || on_segment(s, t, x, y) ||
      (cross(x, y, u, v) > 0 && cross(u, v, s, t) > 0 && cross(s, t, x, y) > 0) ||
      (cross(x, y, u, v) < 0 && cross(u, v, s, t) < 0 && cross(s, t, x, y) < 0); */

/*@ lemma disc: \forall integer x, y, r; 0 <= r && in_disc(x, y, r) ==> -r <= x <= r && -r <= y <= r; */

/*@ predicate longer(integer m, integer square) = 0 <= m && m * m >= square;
    predicate shorter(integer m, integer square) = 0 <= m && m * m <= square;
    predicate farther(integer s, integer r, integer square) = s * s > r * r * square;
    predicate reaches(integer h, integer square, integer x, integer rest) = h * h >= x * square + rest;
    lemma reaches: \forall integer h, r, square; reaches(h, square, r * r, 1) <==> farther(h, r, square);
    lemma half_fits: \forall integer x, y; 0 <= y <= x < 0x80000000 ==> 0 <= x + down(y, 1) + 1 < 0xffffffff;
    lemma half_square: \forall integer x, y, h;
      0 <= y <= x && 2 * h <= y && y < 2 * h + 2 ==> longer(x + h + 1, x * x + y * y);
    predicate half_value(integer x, integer y) = (uint32_t)(1 + (uint32_t)(x + down(y, 1))) == x + down(y, 1) + 1;
    predicate half_longer(integer x, integer y) = longer(x + down(y, 1) + 1, x * x + y * y);
    lemma half_value: \forall integer x, y; 0 <= y <= x < 0x80000000 ==> half_value(x, y);
    lemma half_longer: \forall integer x, y; 0 <= y <= x ==> half_longer(x, y);
    lemma monotonic: \forall integer x, y, z; 0 <= x <= y && 0 <= z ==> x * z <= y * z;
    lemma far: \forall integer s, m, r, square; 0 <= r && longer(m, square) && s > m * r ==> farther(s, r, square);
    lemma close: \forall integer s, m, r, square;
      0 <= r && 0 <= s && shorter(m, square) && s <= m * r ==> !farther(s, r, square); */

/*@ predicate small(integer dx, integer dy, integer x, integer y) =
      -0x4000000000000000 < dot(dx, dy, x, y) < 0x4000000000000000;
    predicate under(integer t, integer d, integer p) = t * t <= d * p;
    predicate at_most(integer t, integer r, integer s) = t <= r * s;
    predicate sum_in(integer x, integer y, integer u, integer v, integer r, integer s) =
      at_most(dot(x, y, u, v), r, s) && in_disc(x + u, y + v, r + s); */

// The point lies more than r before the line across d through the origin.
/*@ predicate beyond(integer dx, integer dy, integer x, integer y, integer r) =
      dot(dx, dy, x, y) < 0 && farther(-dot(dx, dy, x, y), r, dot(dx, dy, dx, dy));
    lemma beyond: \forall integer dx, dy, x, y, r, h;
      0 < h && dot(dx, dy, x, y) <= -h && farther(h, r, dot(dx, dy, dx, dy)) ==> beyond(dx, dy, x, y, r);
    predicate behind_one(integer dx, integer dy, integer x, integer y, integer u, integer v, integer s, integer t, integer h) =
      dot(x, y, dx, dy) + dot(u, v, dx, dy) + dot(s, t, -dx, -dy) <= h;
    predicate beyond_one(integer dx, integer dy, integer x, integer y, integer u, integer v, integer s, integer t, integer r) =
      beyond(dx, dy, x + u - s, y + v - t, r);
    predicate clear(integer dx, integer dy, integer h, integer r) = h < 0 && farther(-h, r, dot(dx, dy, dx, dy));
    lemma beyond_one: \forall integer dx, dy, x, y, u, v, s, t, r, h;
      behind_one(dx, dy, x, y, u, v, s, t, h) && clear(dx, dy, h, r) ==> beyond_one(dx, dy, x, y, u, v, s, t, r);
    lemma cauchy: \forall integer x, y, u, v; under(dot(x, y, u, v), dot(x, y, x, y), dot(u, v, u, v));
    lemma under_products: \forall integer t, a, b, r, s;
      0 <= r && 0 <= s && 0 <= a <= r * r && 0 <= b <= s * s && under(t, a, b) ==> at_most(t, r, s);
    lemma squares: \forall integer x, y; 0 <= dot(x, y, x, y);
    lemma sum_of_discs: \forall integer x, y, u, v, r, s; in_disc(x, y, r) && in_disc(u, v, s) &&
      at_most(dot(x, y, u, v), r, s) ==> in_disc(x + u, y + v, r + s);
    lemma discs_product: \forall integer x, y, u, v, r, s;
      0 <= r && 0 <= s && in_disc(x, y, r) && in_disc(u, v, s) ==> at_most(dot(x, y, u, v), r, s);
    lemma triangle: \forall integer x, y, u, v, r, s;
      0 <= r && 0 <= s && in_disc(x, y, r) && in_disc(u, v, s) ==> sum_in(x, y, u, v, r, s);
    lemma along: \forall integer dx, dy, x, y; dot(dx, dy, dx, dy) < 0x4000000000000000 && in_disc(x, y, 0x60000000) ==>
      small(dx, dy, x, y);
    predicate small_one(integer dx, integer dy, integer x, integer y, integer u, integer v, integer s, integer t) =
      small(dx, dy, x + u - s, y + v - t);
    lemma lowest: \forall integer dx, dy, x, y, u, v, s, t, h; behind_one(dx, dy, x, y, u, v, s, t, h) &&
      small_one(dx, dy, x, y, u, v, s, t) ==> -0x4000000000000000 < h;
    lemma opposite: \forall integer x, y, r; in_disc(x, y, r) ==> in_disc(-x, -y, r);
    lemma widened: \forall integer x, y, r, s; 0 <= r <= s && in_disc(x, y, r) ==> in_disc(x, y, s);
    lemma reach: \forall integer t, d, p, r; 0 <= d && under(t, d, p) && 0 <= r && p <= r * r ==> !farther(t, r, d);
    lemma point: \forall integer x, y, r;
      0 <= r && !farther(dot(x, y, x, y), r, dot(x, y, x, y)) && dot(x, y, x, y) > 0 ==> near_point(x, y, r); */

// The line of an edge between points in reach: what its direction d = (v - y, -(u - x)) and cross product obey.
/*@ predicate edge_line(integer x, integer y, integer u, integer v) =
      cross(x, y, u, v) == dot(v - y, -(u - x), x, y) && small(v - y, -(u - x), x, y) && cross_fits(x, y, u, v) &&
      0 <= dot(u - x, v - y, u - x, v - y) < 0x4000000000000000 &&
      dot(v - y, -(u - x), v - y, -(u - x)) == dot(u - x, v - y, u - x, v - y) &&
      !farther(cross(x, y, u, v), 0x60000000, dot(u - x, v - y, u - x, v - y));
    lemma edge_line: \forall integer x, y, u, v; in_disc(x, y, 0x60000000) &&
      -0x40000000 <= u - x <= 0x40000000 && -0x40000000 <= v - y <= 0x40000000 ==> edge_line(x, y, u, v); */

// Circles of radii that add up to r, whose centres are (x, y) apart, have no point in common.
/*@ predicate circles_apart(integer x, integer y, integer r) = x * x + y * y > r * r;
    lemma wide_x: \forall integer x, y, r; 0 <= r && (x > r || -x > r) ==> circles_apart(x, y, r);
    lemma wide_y: \forall integer x, y, r; 0 <= r && (y > r || -y > r) ==> circles_apart(x, y, r);
    predicate close_centres(integer x, integer y) = -0x20000003 <= x <= 0x20000003 && -0x20000003 <= y <= 0x20000003;
    lemma close_centres: \forall integer x, y; close_centres(x, y) ==> in_disc(x, y, 0x40000000); */

/*@ predicate near_size(integer x, integer y, integer u, integer v, integer r) = near_line(x, y, u, v, r) <==>
      !farther(cross(x, y, u, v) < 0 ? -cross(x, y, u, v) : cross(x, y, u, v), r, dot(u - x, v - y, u - x, v - y));
    lemma near_size: \forall integer x, y, u, v, r; near_size(x, y, u, v, r); */

// h / |d| rounds to n, a tie up, where square is |d|^2.
/*@ predicate rounded(integer h, integer square, integer n) =
      (n == 0 || 4 * h * h >= (2 * n - 1) * (2 * n - 1) * square) && 4 * h * h < (2 * n + 1) * (2 * n + 1) * square;
    predicate half(integer h, integer square, integer x, integer rest) =
      reaches(h, square, x, rest) <==> 4 * h * h >= (4 * x + 1) * square;
    lemma half: \forall integer h, square, x, rest; square <= 4 * rest < square + 4 ==> half(h, square, x, rest);
    predicate rounded_by(integer h, integer square, integer n, integer x) = rounded(h, square, n) <==>
      (n == 0 || 4 * h * h >= (4 * (x - n) + 1) * square) && 4 * h * h < (4 * (x + n) + 1) * square;
    lemma rounded: \forall integer h, square, n, x; x == n * n ==> rounded_by(h, square, n, x); */

// d . w = h is the line across the vertex (x, y), or the line of the edge that has the origin's foot.
/*@ predicate of_vertex(integer x, integer y, integer dx, integer dy, integer h) =
      dx == -x && dy == -y && h == -dot(x, y, x, y);
    predicate of_edge(integer x, integer y, integer u, integer v, integer dx, integer dy, integer h) =
      foot(x, y, u, v) && dx == v - y && dy == -(u - x) && h == cross(x, y, u, v); */

// A line that the checker takes: d . w = h.
/*@ predicate line(integer dx, integer dy, integer h) = -0x60000000 <= dx <= 0x60000000 && -0x60000000 <= dy <= 0x60000000 &&
      -0x4000000000000000 < h < 0 && dot(dx, dy, dx, dy) < 0x4000000000000000 &&
      !farther(-h, 0x60000000, dot(dx, dy, dx, dy));
    predicate line_of_point(integer x, integer y) = line(-x, -y, -dot(x, y, x, y));
    predicate line_of_edge(integer x, integer y, integer u, integer v) = line(v - y, -(u - x), cross(x, y, u, v));
    lemma line_of_point: \forall integer x, y; in_disc(x, y, 0x60000000) && 0 < dot(x, y, x, y) &&
      -0x60000000 <= x <= 0x60000000 && -0x60000000 <= y <= 0x60000000 ==> line_of_point(x, y);
    lemma line_of_edge: \forall integer x, y, u, v; edge_line(x, y, u, v) && cross(x, y, u, v) < 0 &&
      -0x40000000 <= u - x <= 0x40000000 && -0x40000000 <= v - y <= 0x40000000 ==> line_of_edge(x, y, u, v); */

// s is at most t times the root of n.
/*@ predicate at_most_root(integer s, integer t, integer n) =
      (0 <= t && (s <= 0 || s * s <= t * t * n)) || (t < 0 && s < 0 && t * t * n <= s * s); */

// On a way that moves by t there a coordinate of the centres' difference stays more than r away from 0.
/*@ predicate stays_off(integer x, integer t, integer r) = (x > r && x - t > r) || (x < -r && x - t < -r); */

#endif
