(* From vertices to all points, in space: what the contracts of space.h and space_cast.h say of the vertices of two polytopes
   decides about every point of the two shapes. The definitions over Z are those of these headers, geometry.h and solid.h;
   at_most_root is hull.v's. *)
Require Import Reals Lra Psatz ZArith.
Require hull.

(* The sum of a triangle's shares is the square of twice its area; they weigh its vertices to where the normal meets it. *)
Section Triangle.

Open Scope R_scope.

Variables (x y z u v w s t q : R).
Let dot (x y z u v w : R) := x * u + y * v + z * w.
Let toward (x y z u v w : R) := x * x + y * y + z * z - dot x y z u v w.
Definition share (x y z u v w s t q : R) := toward u v w x y z * toward x y z s t q +
  toward x y z u v w * (toward u v w s t q - toward u v w x y z).
Definition area (x y u v s t : R) := (u - x) * (t - y) - (v - y) * (s - x).
Definition volume := (y * w - z * v) * s + (z * u - x * w) * t + (x * v - y * u) * q.
Let p1 := share u v w s t q x y z.
Let p2 := share s t q x y z u v w.
Let p3 := share x y z u v w s t q.
Let nx := area y z v w t q.
Let ny := area z x w u q s.
Let nz := area x y u v s t.

Lemma shares_sum : p1 + p2 + p3 = nx * nx + ny * ny + nz * nz.
Proof. unfold p1, p2, p3, nx, ny, nz, share, area, toward, dot. ring. Qed.

Lemma shares_mean : p1 * x + p2 * u + p3 * s = volume * nx /\ p1 * y + p2 * v + p3 * t = volume * ny /\
  p1 * z + p2 * w + p3 * q = volume * nz.
Proof. unfold p1, p2, p3, nx, ny, nz, volume, share, area, toward, dot. repeat split; ring. Qed.
End Triangle.

Ltac reals H := repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR, ?opp_IZR in H.

(* Lengths of vectors, and how far a line moves away from a point when both are rounded. *)
Section Vectors.

Open Scope R_scope.

Definition len (x y z : R) := sqrt (x * x + y * y + z * z).

Lemma square_less a b : 0 <= b -> a * a < b * b -> a < b.
Proof. intros B H. apply Rnot_le_lt. intros C. pose proof (Rmult_le_compat b a b a B B C C). lra. Qed.

Lemma square_most a b : 0 <= b -> a * a <= b * b -> a <= b.
Proof. intros B H. apply Rnot_lt_le. intros C. pose proof (Rmult_le_0_lt_compat b a b a B B C C). lra. Qed.

Lemma squares x y z : 0 <= x * x + y * y + z * z.
Proof. pose proof (Rle_0_sqr x). pose proof (Rle_0_sqr y). pose proof (Rle_0_sqr z). unfold Rsqr in *. lra. Qed.

Lemma len_pos x y z : 0 <= len x y z.
Proof. apply sqrt_pos. Qed.

Lemma len_square x y z : len x y z * len x y z = x * x + y * y + z * z.
Proof. apply sqrt_sqrt, squares. Qed.

Lemma len_most x y z r : 0 <= r -> x * x + y * y + z * z <= r * r -> len x y z <= r.
Proof. intros R H. apply square_most; [exact R |]. rewrite len_square. exact H. Qed.

Lemma len_equal x y z r : 0 <= r -> x * x + y * y + z * z = r * r -> len x y z = r.
Proof. intros R H. unfold len. rewrite H. apply sqrt_square, R. Qed.

Lemma product_square a b : a * b * (a * b) = a * a * (b * b).
Proof. ring. Qed.

Lemma len_dot x y z u v w : x * u + y * v + z * w <= len x y z * len u v w.
Proof.
  apply square_most; [apply Rmult_le_pos; apply len_pos |]. rewrite product_square, !len_square.
  pose proof (squares (x * v - y * u) (y * w - z * v) (z * u - x * w)). lra.
Qed.

Lemma len_cross x y z u v w : len (y * w - z * v) (z * u - x * w) (x * v - y * u) <= len x y z * len u v w.
Proof.
  apply len_most; [apply Rmult_le_pos; apply len_pos |]. rewrite product_square, !len_square.
  pose proof (Rle_0_sqr (x * u + y * v + z * w)). unfold Rsqr in *. lra.
Qed.

Lemma len_sum x y z u v w : len (x + u) (y + v) (z + w) <= len x y z + len u v w.
Proof.
  pose proof (len_pos x y z). pose proof (len_pos u v w). pose proof (len_dot x y z u v w).
  pose proof (len_square x y z). pose proof (len_square u v w). apply len_most; lra.
Qed.

Lemma len_scale k x y z : len (k * x) (k * y) (k * z) = Rabs k * len x y z.
Proof.
  apply len_equal; [apply Rmult_le_pos; [apply Rabs_pos | apply len_pos] |]. rewrite (product_square (Rabs k)), len_square.
  pose proof (Rsqr_abs k). unfold Rsqr in *. rewrite <- H. ring.
Qed.

Lemma len_coordinates x y z : Rabs x <= len x y z /\ Rabs y <= len x y z /\ Rabs z <= len x y z.
Proof.
  assert (M : forall c, c * c <= x * x + y * y + z * z -> Rabs c <= len x y z).
  { intros c H. apply square_most; [apply len_pos |]. rewrite len_square. pose proof (Rsqr_abs c). unfold Rsqr in *. lra. }
  pose proof (Rle_0_sqr x). pose proof (Rle_0_sqr y). pose proof (Rle_0_sqr z). unfold Rsqr in *.
  repeat split; apply M; lra.
Qed.

(* Each coordinate at most c: the root of 3 is below 7 / 4. *)
Lemma len_box x y z c : - c <= x <= c -> - c <= y <= c -> - c <= z <= c -> len x y z <= 7 / 4 * c.
Proof.
  intros X Y Z. assert (S : forall a, - c <= a <= c -> a * a <= c * c).
  { intros a A. assert (0 <= (c - a) * (c + a)) by (apply Rmult_le_pos; lra). lra. }
  pose proof (S x X). pose proof (S y Y). pose proof (S z Z). apply len_most; [lra |].
  replace (7 / 4 * c * (7 / 4 * c)) with (3 * (c * c) + / 16 * (c * c)) by field. pose proof (Rle_0_sqr c). unfold Rsqr in *. lra.
Qed.

(* The point (G u, G v, G w) of a line that is nearest to (x, y, z). *)
Lemma foot_line x y z u v w : 0 < len u v w -> exists G, Rabs G * len u v w <= len x y z /\
  len u v w * len (x - G * u) (y - G * v) (z - G * w) = len (v * z - w * y) (w * x - u * z) (u * y - v * x).
Proof.
  intros L. pose proof (len_square u v w) as N. set (l := len u v w) in *. set (m := x * u + y * v + z * w).
  assert (L2 : 0 < l * l) by (apply Rmult_lt_0_compat; exact L).
  exists (m / (l * l)). set (G := m / (l * l)). assert (K : G * (l * l) = m) by (unfold G; field; lra). split.
  - apply square_most; [apply len_pos |]. rewrite product_square, len_square. apply Rmult_le_reg_r with (l * l); [exact L2 |].
    pose proof (Rsqr_abs G) as A. unfold Rsqr in A. rewrite <- A.
    replace (G * G * (l * l) * (l * l)) with (G * (l * l) * (G * (l * l))) by ring. rewrite K, N. unfold m.
    pose proof (squares (x * v - y * u) (y * w - z * v) (z * u - x * w)). lra.
  - symmetry. apply len_equal; [apply Rmult_le_pos; [lra | apply len_pos] |]. rewrite (product_square l), len_square.
    transitivity (l * l * (x * x + y * y + z * z) - m * m); [rewrite N; unfold m; ring |].
    transitivity (l * l * (x * x + y * y + z * z) - 2 * (G * (l * l)) * m + G * (l * l) * (G * (u * u + v * v + w * w)));
      [rewrite <- N, K; replace (G * (l * l)) with m by (symmetry; exact K); ring | unfold m; ring].
Qed.

(* What is across a line does not change along it. *)
Lemma cross_along x y z u v w G :
  len (v * z - w * y) (w * x - u * z) (u * y - v * x) <= len u v w * len (x - G * u) (y - G * v) (z - G * w).
Proof.
  replace (v * z - w * y) with (v * (z - G * w) - w * (y - G * v)) by ring.
  replace (w * x - u * z) with (w * (x - G * u) - u * (z - G * w)) by ring.
  replace (u * y - v * x) with (u * (y - G * v) - v * (x - G * u)) by ring. apply len_cross.
Qed.

(* A line along (u, v, w) at most k from (x, y, z): rounded, they are (e, f, g) and (a, b, c), and at most k + 9 apart. *)
Lemma line_moved x y z u v w a b c e f g k : len (a - x) (b - y) (c - z) <= 7 / 4 -> len (e - u) (f - v) (g - w) <= 7 / 4 ->
  len x y z <= 7 / 4 * (2 ^ 29 + 1) -> 2 ^ 28 - 3 <= len u v w ->
  len (v * z - w * y) (w * x - u * z) (u * y - v * x) <= len u v w * k ->
  len (f * c - g * b) (g * a - e * c) (e * b - f * a) <= len e f g * (k + 9).
Proof.
  intros O T X U K. destruct (foot_line x y z u v w) as (G & GU & E); [lra |]. rewrite <- E in K.
  apply Rmult_le_reg_l in K; [| lra]. pose proof (Rabs_pos G) as G0.
  assert (GG : Rabs G <= 4) by (apply Rnot_lt_le; intros B;
    pose proof (Rmult_le_compat 4 (Rabs G) (2 ^ 28 - 3) (len u v w)); lra).
  assert (D : len (a - G * e) (b - G * f) (c - G * g) <= k + 9).
  { pose proof (len_sum (x - G * u + (a - x)) (y - G * v + (b - y)) (z - G * w + (c - z))
      (- G * (e - u)) (- G * (f - v)) (- G * (g - w))) as A.
    pose proof (len_sum (x - G * u) (y - G * v) (z - G * w) (a - x) (b - y) (c - z)) as B.
    rewrite len_scale, Rabs_Ropp in A.
    replace (x - G * u + (a - x) + - G * (e - u)) with (a - G * e) in A by ring.
    replace (y - G * v + (b - y) + - G * (f - v)) with (b - G * f) in A by ring.
    replace (z - G * w + (c - z) + - G * (g - w)) with (c - G * g) in A by ring.
    pose proof (Rmult_le_compat_l _ _ _ G0 T). lra. }
  pose proof (cross_along a b c e f g G). pose proof (Rmult_le_compat_l _ _ _ (len_pos e f g) D). lra.
Qed.

(* A vector is at most as long as its rounded one, and 7 / 4. *)
Lemma len_near x y z a b c : len (a - x) (b - y) (c - z) <= 7 / 4 -> len a b c <= len x y z + 7 / 4.
Proof.
  intros H. pose proof (len_sum x y z (a - x) (b - y) (c - z)) as S. replace (x + (a - x)) with a in S by ring.
  replace (y + (b - y)) with b in S by ring. replace (z + (c - z)) with c in S by ring. lra.
Qed.

(* The square of what is across is over that of scaled vectors. *)
Lemma across_scaled j k x y z u v w : 0 < j -> 0 < k ->
  len (k * v * (j * z) - k * w * (j * y)) (k * w * (j * x) - k * u * (j * z)) (k * u * (j * y) - k * v * (j * x)) =
  j * k * len (v * z - w * y) (w * x - u * z) (u * y - v * x).
Proof.
  intros J K. rewrite <- (Rabs_pos_eq (j * k)) by (apply Rlt_le, Rmult_lt_0_compat; assumption). rewrite <- len_scale.
  f_equal; ring.
Qed.

End Vectors.

Section Vertices.

(* Vertex i of A is (ax i, ay i, az i) relative to A's centre, one of na; those of B likewise. (x, y, z) is A's centre less
   B's. *)
Variables (na nb : nat) (ax ay az bx bl bz : nat -> Z) (x y z : Z).

Open Scope Z_scope.

Definition dot3 (x y z u v w : Z) := x * u + y * v + z * w.
Definition norm3 (x y z : Z) := x * x + y * y + z * z.
Definition farther (s r square : Z) := s * s > r * r * square.
Definition beyond3 (dx dy dz x y z r : Z) := dot3 dx dy dz x y z < 0 /\ farther (- dot3 dx dy dz x y z) r (norm3 dx dy dz).
Definition separated_by3 (r : Z) := exists dx dy dz, forall i j, (i < na)%nat -> (j < nb)%nat ->
  beyond3 dx dy dz (x + ax i - bx j) (y + ay i - bl j) (z + az i - bz j) r.
Definition spheres_apart (x y z r : Z) := norm3 x y z > r * r.
Definition cross (x y u v : Z) := x * v - y * u.
Definition in_ball (x y z r : Z) := norm3 x y z <= r * r.
Definition toward3 (x y z u v w : Z) := norm3 x y z - dot3 x y z u v w.
Definition area3 (x y u v s t : Z) := cross (u - x) (v - y) (s - x) (t - y).
Definition volume3 (x y z u v w s t q : Z) := dot3 (cross y z v w) (cross z x w u) (cross x y u v) s t q.
Definition share_of (a b c e : Z) := a * b + c * (e - a).
Definition share3 (x y z u v w s t q : Z) :=
  share_of (toward3 u v w x y z) (toward3 x y z s t q) (toward3 x y z u v w) (toward3 u v w s t q).
Definition foot3 (x y z u v w : Z) := toward3 x y z u v w > 0 /\ toward3 u v w x y z > 0.
Definition inside3 (x y z u v w s t q : Z) :=
  share3 x y z u v w s t q > 0 /\ share3 u v w s t q x y z > 0 /\ share3 s t q x y z u v w > 0.
Definition meets_one (x u s t : Z) := x * t + u * s = 0.
Definition on_edge3 (x y z u v w : Z) := foot3 x y z u v w /\
  meets_one x u (toward3 x y z u v w) (toward3 u v w x y z) /\ meets_one y v (toward3 x y z u v w) (toward3 u v w x y z) /\
  meets_one z w (toward3 x y z u v w) (toward3 u v w x y z).
Definition on_face3 (x y z u v w s t q : Z) := inside3 x y z u v w s t q /\ volume3 x y z u v w s t q = 0.
Definition one_side (a b c d : Z) := 0 <= a /\ 0 <= b /\ 0 <= c /\ 0 <= d /\ 0 < a + b + c + d.
Definition in_tetrahedron (x y z u v w s t q k l m : Z) :=
  one_side (volume3 u v w s t q k l m) (- volume3 x y z s t q k l m)
    (volume3 x y z u v w k l m) (- volume3 x y z u v w s t q) \/
  one_side (- volume3 u v w s t q k l m) (volume3 x y z s t q k l m)
    (- volume3 x y z u v w k l m) (volume3 x y z u v w s t q).
Definition near_edge3 (x y z u v w r : Z) := foot3 x y z u v w /\
  norm3 x y z * norm3 u v w - dot3 x y z u v w * dot3 x y z u v w <= r * r * (toward3 x y z u v w + toward3 u v w x y z).
Definition near_face3 (x y z u v w s t q r : Z) := inside3 x y z u v w s t q /\
  volume3 x y z u v w s t q * volume3 x y z u v w s t q <=
  r * r * norm3 (area3 y z v w t q) (area3 z x w u q s) (area3 x y u v s t).
Definition point_far (x y z n m : Z) := n = norm3 x y z /\ m = 1.
Definition edge_far (x y z u v w n m : Z) := foot3 x y z u v w /\ m = toward3 x y z u v w + toward3 u v w x y z /\
  n = norm3 x y z * norm3 u v w - dot3 x y z u v w * dot3 x y z u v w.
Definition face_far (x y z u v w s t q n m : Z) := inside3 x y z u v w s t q /\
  n = volume3 x y z u v w s t q * volume3 x y z u v w s t q /\
  m = norm3 (area3 y z v w t q) (area3 z x w u q s) (area3 x y u v s t).
Definition across3 (dx dy dz x y z n m : Z) := dot3 dx dy dz x y z * dot3 dx dy dz x y z * m = n * norm3 dx dy dz.
Definition below_half (n m f k : Z) := 4 * n < (2 * k + 1) * f * ((2 * k + 1) * f) * m.
Definition above_half (n m f k : Z) := (2 * k - 1) * f * ((2 * k - 1) * f) * m <= 4 * n.
Definition rounded3 (n m f k : Z) := below_half n m f k /\ (k = 0 \/ above_half n m f k).

(* The same in the frame, of f units an LSB, where A's centre less B's is (x, y, z). *)
Definition seat (x f p q : Z) := x + f * (p - q).
Definition named3 (x y z f : Z) (i j : nat) (wx wy wz : Z) := (i < na)%nat /\ (j < nb)%nat /\
  wx = seat x f (ax i) (bx j) /\ wy = seat y f (ay i) (bl j) /\ wz = seat z f (az i) (bz j).
Definition point_within (x y z f r : Z) := exists i j tx ty tz, named3 x y z f i j tx ty tz /\ in_ball tx ty tz r.
Definition edge_within (x y z f r : Z) := exists i j k l tx ty tz ux uy uz,
  named3 x y z f i j tx ty tz /\ named3 x y z f k l ux uy uz /\ near_edge3 tx ty tz ux uy uz r.
Definition face_within (x y z f r : Z) := exists i j k l m n tx ty tz ux uy uz vx vy vz, named3 x y z f i j tx ty tz /\
  named3 x y z f k l ux uy uz /\ named3 x y z f m n vx vy vz /\ near_face3 tx ty tz ux uy uz vx vy vz r.
Definition edge_holds (x y z f : Z) := exists i j k l tx ty tz ux uy uz,
  named3 x y z f i j tx ty tz /\ named3 x y z f k l ux uy uz /\ on_edge3 tx ty tz ux uy uz.
Definition face_holds (x y z f : Z) := exists i j k l m n tx ty tz ux uy uz vx vy vz, named3 x y z f i j tx ty tz /\
  named3 x y z f k l ux uy uz /\ named3 x y z f m n vx vy vz /\ on_face3 tx ty tz ux uy uz vx vy vz.
Definition cell_holds (x y z f : Z) := exists i j k l m n o p tx ty tz ux uy uz vx vy vz wx wy wz,
  named3 x y z f i j tx ty tz /\ named3 x y z f k l ux uy uz /\ named3 x y z f m n vx vy vz /\
  named3 x y z f o p wx wy wz /\ in_tetrahedron tx ty tz ux uy uz vx vy vz wx wy wz.
Definition enclosing3 (x y z f : Z) := point_within x y z f 0 \/ edge_holds x y z f \/ face_holds x y z f \/ cell_holds x y z f.
Definition near3 (x y z f r : Z) := point_within x y z f r \/ edge_within x y z f r \/ face_within x y z f r.
Definition radius_framed (radius r f : Z) := 0 <= radius <= f * r.
Definition reached3 (x y z f r : Z) := enclosing3 x y z f \/ near3 x y z f r.
Definition together3 (r : Z) := exists f s, 1 <= f /\ radius_framed s r f /\ reached3 (f * x) (f * y) (f * z) f s.
Definition support3 (f dx dy dz wx wy wz : Z) := forall i j, (i < na)%nat -> (j < nb)%nat ->
  f * (dot3 dx dy dz x y z + dot3 dx dy dz (ax i) (ay i) (az i) - dot3 dx dy dz (bx j) (bl j) (bz j)) <= dot3 dx dy dz wx wy wz.
Definition beyond_scaled (dx dy dz x y z f r : Z) := beyond3 dx dy dz x y z (f * r).
Definition point_measures (x y z f n m : Z) := exists i j tx ty tz, named3 x y z f i j tx ty tz /\ point_far tx ty tz n m.
Definition edge_measures (x y z f n m : Z) := exists i j k l tx ty tz ux uy uz,
  named3 x y z f i j tx ty tz /\ named3 x y z f k l ux uy uz /\ edge_far tx ty tz ux uy uz n m.
Definition face_measures (x y z f n m : Z) := exists i j k l o p tx ty tz ux uy uz vx vy vz, named3 x y z f i j tx ty tz /\
  named3 x y z f k l ux uy uz /\ named3 x y z f o p vx vy vz /\ face_far tx ty tz ux uy uz vx vy vz n m.
Definition feature_measures (x y z f n m : Z) := point_measures x y z f n m \/ edge_measures x y z f n m \/
  face_measures x y z f n m.
Definition measured3 (r distance : Z) := exists f n m dx dy dz wx wy wz, 1 <= f /\ feature_measures (f * x) (f * y) (f * z) f n m /\
  support3 f dx dy dz wx wy wz /\ beyond_scaled dx dy dz wx wy wz f r /\
  across3 dx dy dz wx wy wz n m /\ rounded3 n m f (distance + r).
Definition enough3 (r depth : Z) := exists f dx dy dz wx wy wz, 1 <= f /\ 0 < norm3 dx dy dz /\ support3 f dx dy dz wx wy wz /\
  hull.at_most_root (dot3 dx dy dz wx wy wz) ((depth - r) * f) (norm3 dx dy dz).

(* Casts: B moves by (tx, ty, tz), A stands. Spheres pass off an axis or off the line of the way, the vectors from their
   leading bits: w is q v / p, rounded down. *)
Definition stays_off (x tx r : Z) := (x > r /\ x - tx > r) \/ (x < - r /\ x - tx < - r).
Definition leads (v p q w : Z) := p * w <= q * v < p * (w + 1).
Definition led3 (x y z p q a b c : Z) := 1 <= p /\ 1 <= q /\ leads x p q a /\ leads y p q b /\ leads z p q c.
Definition within29 (a b c : Z) := - 2 ^ 29 <= a <= 2 ^ 29 /\ - 2 ^ 29 <= b <= 2 ^ 29 /\ - 2 ^ 29 <= c <= 2 ^ 29.
Definition across_norm (u v w a b c : Z) := norm3 (cross v w b c) (cross w u c a) (cross u v a b).
Definition off_line (x y z tx ty tz r : Z) := exists p q g h a b c u v w s, led3 x y z p q a b c /\ within29 a b c /\
  led3 tx ty tz g h u v w /\ (2 ^ 28 - 1) * (2 ^ 28 - 1) <= norm3 u v w /\ leads r p q s /\ 0 <= s /\
  (s + 12) * (s + 12) * norm3 u v w < across_norm u v w a b c.
Definition spheres_pass3 (tx ty tz r : Z) :=
  stays_off x tx r \/ stays_off y ty r \/ stays_off z tz r \/ off_line x y z tx ty tz r.

Open Scope R_scope.

(* The sum of f 0 to f (n - 1). A point of a hull is a mean of vertices with weights. *)
Fixpoint sum (n : nat) (f : nat -> R) := match n with O => 0 | S m => sum m f + f m end.
Definition in_hull (n : nat) (vx vy vz : nat -> Z) (u v w : R) := exists k : nat -> R,
  (forall i, (i < n)%nat -> 0 <= k i) /\ sum n k = 1 /\ u = sum n (fun i => k i * IZR (vx i)) /\
  v = sum n (fun i => k i * IZR (vy i)) /\ w = sum n (fun i => k i * IZR (vz i)).
(* A shape: all points within a radius of its hull. *)
Definition in_shape (n : nat) (vx vy vz : nat -> Z) (cx cy cz r u v w : R) := exists s t q, in_hull n vx vy vz s t q /\
  (u - cx - s) * (u - cx - s) + (v - cy - t) * (v - cy - t) + (w - cz - q) * (w - cz - q) <= r * r.
Definition square_apart (u v w s t q : R) := (u - s) * (u - s) + (v - t) * (v - t) + (w - q) * (w - q).

Lemma sum_combine n a b c f g h :
  sum n (fun i => a * f i + b * g i + c * h i) = a * sum n f + b * sum n g + c * sum n h.
Proof. induction n; simpl; [lra | rewrite IHn; lra]. Qed.

Lemma sum_ext n f g : (forall i, (i < n)%nat -> f i = g i) -> sum n f = sum n g.
Proof. induction n; simpl; intros H; [lra | rewrite IHn, H; auto with arith]. Qed.

Lemma mean_below n w f c : (forall i, (i < n)%nat -> 0 <= w i) -> (forall i, (i < n)%nat -> f i < c) ->
  0 <= sum n w /\ sum n (fun i => w i * f i) <= c * sum n w /\ (0 < sum n w -> sum n (fun i => w i * f i) < c * sum n w).
Proof.
  intros W F. induction n; simpl; [lra |]. destruct IHn as (N & A & B); auto with arith.
  assert (W0 : 0 <= w n) by auto with arith. assert (F0 : f n < c) by auto with arith.
  assert (w n * f n <= w n * c) by nra. split; [lra |]. split; [lra |]. intros P.
  destruct (Rle_lt_or_eq_dec _ _ N) as [L | E].
  - specialize (B L). nra.
  - assert (0 < w n) by lra. nra.
Qed.

(* A functional that is below c at every vertex is below c at every point. *)
Lemma hull_below n vx vy vz u v w dx dy dz c : in_hull n vx vy vz u v w ->
  (forall i, (i < n)%nat -> dx * IZR (vx i) + dy * IZR (vy i) + dz * IZR (vz i) < c) -> dx * u + dy * v + dz * w < c.
Proof.
  intros (k & K & One & -> & -> & ->) F.
  destruct (mean_below n k (fun i => dx * IZR (vx i) + dy * IZR (vy i) + dz * IZR (vz i)) c K F) as (_ & _ & M).
  rewrite One in M. specialize (M ltac:(lra)). rewrite <- sum_combine.
  rewrite (sum_ext n _ (fun i => k i * (dx * IZR (vx i) + dy * IZR (vy i) + dz * IZR (vz i)))) by (intros; ring). lra.
Qed.

(* A vector of length l at most r long along another. *)
Lemma cauchy3 l r dx dy dz u v w : 0 <= l -> 0 <= r -> dx * dx + dy * dy + dz * dz = l * l ->
  u * u + v * v + w * w <= r * r -> dx * u + dy * v + dz * w <= l * r.
Proof.
  intros L R D E. apply Rnot_lt_le. intros G. assert (P : 0 <= l * r) by (apply Rmult_le_pos; assumption).
  pose proof (Rmult_le_0_lt_compat _ _ _ _ P P G G) as A.
  assert (B : (dx * u + dy * v + dz * w) * (dx * u + dy * v + dz * w) <=
    (dx * dx + dy * dy + dz * dz) * (u * u + v * v + w * w)).
  { pose proof (Rle_0_sqr (dx * v - dy * u)). pose proof (Rle_0_sqr (dy * w - dz * v)).
    pose proof (Rle_0_sqr (dz * u - dx * w)). unfold Rsqr in *. lra. }
  rewrite D in B. assert (C : (l * l) * (u * u + v * v + w * w) <= (l * l) * (r * r))
    by (apply Rmult_le_compat_l; [apply Rle_0_sqr | exact E]). lra.
Qed.

Lemma norm_len u v w : IZR (norm3 u v w) = len (IZR u) (IZR v) (IZR w) * len (IZR u) (IZR v) (IZR w).
Proof. rewrite len_square. unfold norm3. rewrite !plus_IZR, !mult_IZR. reflexivity. Qed.

Lemma across_len u v w a b c : let l := len (IZR v * IZR c - IZR w * IZR b) (IZR w * IZR a - IZR u * IZR c)
  (IZR u * IZR b - IZR v * IZR a) in IZR (across_norm u v w a b c) = l * l.
Proof. unfold across_norm. rewrite norm_len. unfold cross. rewrite !minus_IZR, !mult_IZR. reflexivity. Qed.

Lemma leads_real v p q w : (1 <= p)%Z -> leads v p q w -> IZR w <= IZR q / IZR p * IZR v < IZR w + 1.
Proof.
  intros P (A & B). apply IZR_le in P, A. apply IZR_lt in B. reals A. reals B.
  assert (E : IZR q / IZR p * IZR v * IZR p = IZR q * IZR v) by (field; lra).
  split; [apply Rmult_le_reg_r with (IZR p) | apply Rmult_lt_reg_r with (IZR p)]; lra.
Qed.

Lemma led_real l m n p q a b c : led3 l m n p q a b c -> exists k, k = IZR q / IZR p /\ 0 < k /\
  len (k * IZR l - IZR a) (k * IZR m - IZR b) (k * IZR n - IZR c) <= 7 / 4 /\
  len (IZR a - k * IZR l) (IZR b - k * IZR m) (IZR c - k * IZR n) <= 7 / 4.
Proof.
  intros (P & Q & X & Y & Z). apply (leads_real _ _ _ _ P) in X, Y, Z. apply IZR_le in P, Q.
  exists (IZR q / IZR p). split; [reflexivity |]. split; [apply Rdiv_lt_0_compat; lra |].
  split; (eapply Rle_trans; [apply (len_box _ _ _ 1); lra | lra]).
Qed.

Lemma within_len a b c : within29 a b c -> len (IZR a) (IZR b) (IZR c) <= 7 / 4 * 2 ^ 29.
Proof.
  intros ((A & A') & (B & B') & (C & C')). apply IZR_le in A, A', B, B', C, C'.
  assert (E : 2 ^ 29 = IZR (2 ^ 29)) by (rewrite pow_IZR; reflexivity).
  assert (E' : - 2 ^ 29 = IZR (- 2 ^ 29)) by (rewrite opp_IZR, <- E; reflexivity).
  apply len_box; rewrite E', E; split; assumption.
Qed.

Lemma long_len u v w : ((2 ^ 28 - 1) * (2 ^ 28 - 1) <= norm3 u v w)%Z -> 2 ^ 28 - 1 <= len (IZR u) (IZR v) (IZR w).
Proof.
  intros H. apply IZR_le in H. rewrite norm_len, mult_IZR in H. replace (IZR (2 ^ 28 - 1)) with (2 ^ 28 - 1) in H.
  - apply square_most; [apply len_pos | exact H].
  - rewrite minus_IZR, pow_IZR. reflexivity.
Qed.

(* Off the line: no fraction of the way brings the centres r together. *)
Lemma off_line_far tx ty tz r f : (0 <= r)%Z -> off_line x y z tx ty tz r ->
  IZR r < len (IZR x - f * IZR tx) (IZR y - f * IZR ty) (IZR z - f * IZR tz).
Proof.
  intros R (p & q & g & h & a & b & c & u & v & w & s & O & WO & T & WT & S & S0 & H). apply Rnot_le_lt. intros N.
  pose proof (leads_real _ _ _ _ (proj1 O) S) as (_ & S1). destruct (led_real _ _ _ _ _ _ _ _ O) as (j & E & J & O1 & O2).
  rewrite <- E in S1. clear E.
  destruct (led_real _ _ _ _ _ _ _ _ T) as (k & _ & K & T1 & T2). apply within_len in WO. apply long_len in WT.
  pose proof (len_near _ _ _ _ _ _ O1) as X. pose proof (len_near _ _ _ _ _ _ T2) as U.
  apply IZR_le in R, S0. apply IZR_lt in H. reals H. rewrite norm_len, across_len in H.
  assert (L : len (IZR u) (IZR v) (IZR w) * (j * IZR r + 9) < len (IZR u) (IZR v) (IZR w) * (IZR s + 12))
    by (apply Rmult_lt_compat_l; lra).
  assert (M := line_moved _ _ _ _ _ _ _ _ _ _ _ _ (j * IZR r) O2 T2 ltac:(lra) ltac:(lra)).
  rewrite across_scaled in M by assumption.
  pose proof (cross_along (IZR x) (IZR y) (IZR z) (IZR tx) (IZR ty) (IZR tz) f) as C.
  pose proof (Rmult_le_compat_l _ _ _ (len_pos (IZR tx) (IZR ty) (IZR tz)) N) as C2.
  rewrite len_scale, (Rabs_pos_eq k) in M by lra. assert (JK : 0 <= j * k) by (apply Rmult_le_pos; lra).
  pose proof (Rmult_le_compat_l _ _ _ JK (Rle_trans _ _ _ C C2)) as C3. specialize (M ltac:(lra)).
  apply (Rlt_irrefl ((IZR s + 12) * len (IZR u) (IZR v) (IZR w) * ((IZR s + 12) * len (IZR u) (IZR v) (IZR w)))).
  rewrite (product_square (IZR s + 12)) at 1. eapply Rlt_le_trans; [exact H |].
  apply Rmult_le_compat; try apply len_pos; lra.
Qed.

Variables (ra rb d : Z) (cx cy cz : Z).  (* both convex radii, the distance asked about, and the centre of B *)
Hypothesis radii : (0 <= ra /\ 0 <= rb /\ 0 <= d)%Z.

Definition in_a := in_shape na ax ay az (IZR (cx + x)) (IZR (cy + y)) (IZR (cz + z)) (IZR ra).
Definition in_b := in_shape nb bx bl bz (IZR cx) (IZR cy) (IZR cz) (IZR rb).

(* Along a direction of length l the radii add at most that often to what points of the hulls are apart. *)
Lemma widened l dx dy dz u v w s t q p p' p'' o o' o'' :
  0 <= l -> dx * dx + dy * dy + dz * dz = l * l ->
  (u - IZR (cx + x) - p) * (u - IZR (cx + x) - p) + (v - IZR (cy + y) - p') * (v - IZR (cy + y) - p') +
    (w - IZR (cz + z) - p'') * (w - IZR (cz + z) - p'') <= IZR ra * IZR ra ->
  (s - IZR cx - o) * (s - IZR cx - o) + (t - IZR cy - o') * (t - IZR cy - o') +
    (q - IZR cz - o'') * (q - IZR cz - o'') <= IZR rb * IZR rb ->
  dx * (u - s) + dy * (v - t) + dz * (w - q) <=
    dx * (IZR x + p - o) + dy * (IZR y + p' - o') + dz * (IZR z + p'' - o'') + l * (IZR ra + IZR rb).
Proof.
  intros L LL E E'. destruct radii as (RA & RB & D). apply IZR_le in RA, RB. rewrite !plus_IZR in *.
  pose proof (cauchy3 l (IZR ra) dx dy dz _ _ _ L RA LL E) as A.
  assert (E2 : (- (s - IZR cx - o)) * (- (s - IZR cx - o)) + (- (t - IZR cy - o')) * (- (t - IZR cy - o')) +
    (- (q - IZR cz - o'')) * (- (q - IZR cz - o'')) <= IZR rb * IZR rb) by lra.
  pose proof (cauchy3 l (IZR rb) dx dy dz _ _ _ L RB LL E2) as B. lra.
Qed.

(* If A - B without the radii is more than m = ra + rb + d behind the origin along a direction of length l, then every point
   of A is more than d away from every point of B. *)
Lemma behind_apart l dx dy dz u v w s t q p p' p'' o o' o'' :
  0 < l -> dx * dx + dy * dy + dz * dz = l * l ->
  dx * (IZR x + p - o) + dy * (IZR y + p' - o') + dz * (IZR z + p'' - o'') < - (l * (IZR ra + IZR rb + IZR d)) ->
  (u - IZR (cx + x) - p) * (u - IZR (cx + x) - p) + (v - IZR (cy + y) - p') * (v - IZR (cy + y) - p') +
    (w - IZR (cz + z) - p'') * (w - IZR (cz + z) - p'') <= IZR ra * IZR ra ->
  (s - IZR cx - o) * (s - IZR cx - o) + (t - IZR cy - o') * (t - IZR cy - o') +
    (q - IZR cz - o'') * (q - IZR cz - o'') <= IZR rb * IZR rb ->
  square_apart u v w s t q > IZR d * IZR d.
Proof.
  intros L LL W E E'. destruct radii as (RA & RB & D). apply IZR_le in D. assert (L0 : 0 <= l) by lra.
  pose proof (widened l dx dy dz _ _ _ _ _ _ _ _ _ _ _ _ L0 LL E E') as A.
  unfold square_apart. apply Rnot_le_gt. intros C.
  assert (C2 : (- (u - s)) * (- (u - s)) + (- (v - t)) * (- (v - t)) + (- (w - q)) * (- (w - q)) <= IZR d * IZR d) by lra.
  pose proof (cauchy3 l (IZR d) dx dy dz _ _ _ L0 D LL C2). lra.
Qed.

(* `no`, by a direction: every point of A is more than the distance away from every point of B. *)
Theorem apart3 : separated_by3 (ra + rb + d) -> forall u v w s t q, in_a u v w -> in_b s t q ->
  square_apart u v w s t q > IZR d * IZR d.
Proof.
  intros (dx & dy & dz & H) u v w s t q (p & p' & p'' & P & E) (o & o' & o'' & O & E').
  pose proof radii as (RA & RB & D). apply IZR_le in RA, RB, D.
  set (l := sqrt (IZR dx * IZR dx + IZR dy * IZR dy + IZR dz * IZR dz)).
  assert (N : 0 <= IZR dx * IZR dx + IZR dy * IZR dy + IZR dz * IZR dz).
  { pose proof (Rle_0_sqr (IZR dx)). pose proof (Rle_0_sqr (IZR dy)). pose proof (Rle_0_sqr (IZR dz)). unfold Rsqr in *. lra. }
  assert (L0 : 0 <= l) by apply sqrt_pos.
  assert (LL : IZR dx * IZR dx + IZR dy * IZR dy + IZR dz * IZR dz = l * l) by (symmetry; apply sqrt_sqrt; exact N).
  set (m := IZR ra + IZR rb + IZR d) in *.
  assert (V : forall i j, (i < na)%nat -> (j < nb)%nat ->
    IZR dx * IZR (ax i) + IZR dy * IZR (ay i) + IZR dz * IZR (az i) <
    - (l * m) - IZR dx * IZR x - IZR dy * IZR y - IZR dz * IZR z + IZR dx * IZR (bx j) + IZR dy * IZR (bl j) +
    IZR dz * IZR (bz j)).
  { intros i j I J. destruct (H i j I J) as [B F]. unfold farther, dot3, norm3 in *.
    apply IZR_lt in B. apply Z.gt_lt, IZR_lt in F.
    repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR, ?opp_IZR in B.
    repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR, ?opp_IZR in F. rewrite LL in F. fold m in F.
    set (h := IZR dx * (IZR x + IZR (ax i) - IZR (bx j)) + IZR dy * (IZR y + IZR (ay i) - IZR (bl j)) +
      IZR dz * (IZR z + IZR (az i) - IZR (bz j))) in *.
    assert (l * m < - h); [| unfold h in *; lra].
    apply Rnot_le_lt. intros G. assert (0 <= - h) by lra.
    pose proof (Rmult_le_compat _ _ _ _ H0 H0 G G). lra. }
  assert (L : 0 < l).
  { destruct L0 as [| Zero]; [assumption |]. exfalso. rewrite <- Zero in *.
    assert (X : IZR dx = 0 /\ IZR dy = 0 /\ IZR dz = 0).
    { pose proof (Rle_0_sqr (IZR dx)). pose proof (Rle_0_sqr (IZR dy)). pose proof (Rle_0_sqr (IZR dz)). unfold Rsqr in *.
      repeat split; apply Rsqr_0_uniq; unfold Rsqr; lra. }
    destruct X as (X & Y & Z). rewrite X, Y, Z in *.
    assert (B0 : forall j, (j < nb)%nat -> False).
    { intros j J. pose proof (hull_below na ax ay az p p' p'' 0 0 0 _ P (fun i I => V i j I J)). lra. }
    pose proof (hull_below nb bx bl bz o o' o'' 0 0 0 0 O (fun j J => False_ind _ (B0 j J))). lra. }
  assert (V' : forall j, (j < nb)%nat ->
    - IZR dx * IZR (bx j) + - IZR dy * IZR (bl j) + - IZR dz * IZR (bz j) <
    - (l * m) - IZR dx * IZR x - IZR dy * IZR y - IZR dz * IZR z - IZR dx * p - IZR dy * p' - IZR dz * p'').
  { intros j J. pose proof (hull_below na ax ay az p p' p'' _ _ _ _ P (fun i I => V i j I J)). lra. }
  pose proof (hull_below nb bx bl bz o o' o'' _ _ _ _ O V') as W.
  apply (behind_apart l (IZR dx) (IZR dy) (IZR dz) u v w s t q p p' p'' o o' o'' L LL); try assumption.
  fold m. lra.
Qed.

(* B moved by (px, py, pz): the spheres are apart. *)
Lemma centres_apart3 ca cb px py pz : (0 <= ca /\ 0 <= cb)%Z ->
  (forall i, (i < na)%nat -> norm3 (ax i) (ay i) (az i) <= ca * ca)%Z ->
  (forall j, (j < nb)%nat -> norm3 (bx j) (bl j) (bz j) <= cb * cb)%Z ->
  IZR (ca + cb + (ra + rb + d)) < len (IZR x - px) (IZR y - py) (IZR z - pz) ->
  forall u v w s t q, in_a u v w -> in_b s t q -> square_apart u v w (s + px) (t + py) (q + pz) > IZR d * IZR d.
Proof.
  intros (CA & CB) HA HB M u v w s t q (p & p' & p'' & P & E) (o & o' & o'' & O & E').
  destruct radii as (RA & RB & D). unfold norm3 in *. apply IZR_le in CA, CB, RA, RB, D. reals M.
  set (X := IZR x - px) in *. set (Y := IZR y - py) in *. set (Z := IZR z - pz) in *.
  pose proof (len_pos X Y Z) as L. pose proof (eq_sym (len_square X Y Z)) as LL. set (l := len X Y Z) in *.
  assert (LN : - X * - X + - Y * - Y + - Z * - Z = l * l) by lra.
  assert (A : - X * p + - Y * p' + - Z * p'' <= l * IZR ca).
  { apply le_epsilon. intros e G. apply Rlt_le. apply (hull_below na ax ay az _ _ _ _ _ _ _ P). intros k K.
    specialize (HA k K). apply IZR_le in HA. reals HA. pose proof (cauchy3 l (IZR ca) _ _ _ _ _ _ L CA LN HA). lra. }
  assert (B : X * o + Y * o' + Z * o'' <= l * IZR cb).
  { apply le_epsilon. intros e G. apply Rlt_le. apply (hull_below nb bx bl bz _ _ _ _ _ _ _ O). intros k K.
    specialize (HB k K). apply IZR_le in HB. reals HB. pose proof (cauchy3 l (IZR cb) _ _ _ _ _ _ L CB LL HB). lra. }
  pose proof (widened l (- X) (- Y) (- Z) _ _ _ _ _ _ _ _ _ _ _ _ L LN E E') as W.
  apply Rnot_le_gt. intros C. unfold square_apart in C. pose proof (cauchy3 l (IZR d) _ _ _ _ _ _ L D LL C) as V.
  assert (l * (IZR ca + IZR cb + (IZR ra + IZR rb + IZR d)) < l * l) by (apply Rmult_lt_compat_l; lra).
  assert (X * (IZR x - px) + Y * (IZR y - py) + Z * (IZR z - pz) = l * l) by (unfold X, Y, Z in *; lra). lra.
Qed.

(* `no`, by the spheres: no vertex is farther than its core's radius from its centre. *)
Theorem spheres_apart3 (ca cb : Z) : (0 <= ca /\ 0 <= cb)%Z ->
  (forall i, (i < na)%nat -> norm3 (ax i) (ay i) (az i) <= ca * ca)%Z ->
  (forall j, (j < nb)%nat -> norm3 (bx j) (bl j) (bz j) <= cb * cb)%Z ->
  spheres_apart x y z (ca + cb + (ra + rb + d)) ->
  forall u v w s t q, in_a u v w -> in_b s t q -> square_apart u v w s t q > IZR d * IZR d.
Proof.
  intros C HA HB F u v w s t q PA PB. unfold spheres_apart in F. apply Z.gt_lt, IZR_lt in F.
  rewrite norm_len, mult_IZR in F. apply square_less in F; [| apply len_pos].
  pose proof (centres_apart3 ca cb 0 0 0 C HA HB) as A. rewrite !Rminus_0_r in A.
  specialize (A F u v w s t q PA PB). rewrite !Rplus_0_r in A. exact A.
Qed.

Lemma mean_above f r a b : 0 <= f <= 1 -> r < a -> r < b -> r < (1 - f) * a + f * b.
Proof.
  intros F A B. destruct (Rle_lt_dec f 0) as [Z | P]; [replace f with 0 by lra; lra |].
  pose proof (Rmult_lt_compat_l f _ _ P B). pose proof (Rmult_le_compat_l (1 - f) r a). lra.
Qed.

(* Beyond r at either end of the way on one side of an axis, beyond r at each fraction of it. *)
Lemma stays_beyond w t r f : (0 <= r)%Z -> 0 <= f <= 1 -> stays_off w t r -> IZR r < Rabs (IZR w - f * IZR t).
Proof.
  intros R F [(A & B) | (A & B)].
  - apply Z.gt_lt, IZR_lt in A, B. rewrite minus_IZR in B. pose proof (mean_above f _ _ _ F A B).
    pose proof (Rle_abs (IZR w - f * IZR t)). lra.
  - apply IZR_lt in A, B. rewrite minus_IZR, opp_IZR in B. rewrite opp_IZR in A.
    pose proof (mean_above f (IZR r) (- IZR w) (- (IZR w - IZR t)) F ltac:(lra) ltac:(lra)).
    pose proof (Rle_abs (- (IZR w - f * IZR t))). rewrite Rabs_Ropp in *. lra.
Qed.

(* A miss by the spheres: B moves by (tx, ty, tz), and stays more than the margin d away at each fraction f of that. *)
Theorem spheres_miss3 ca cb tx ty tz : (0 <= ca /\ 0 <= cb)%Z ->
  (forall i, (i < na)%nat -> norm3 (ax i) (ay i) (az i) <= ca * ca)%Z ->
  (forall j, (j < nb)%nat -> norm3 (bx j) (bl j) (bz j) <= cb * cb)%Z ->
  spheres_pass3 tx ty tz (ca + cb + (ra + rb + d)) -> forall f u v w s t q, 0 <= f <= 1 -> in_a u v w -> in_b s t q ->
  square_apart u v w (s + f * IZR tx) (t + f * IZR ty) (q + f * IZR tz) > IZR d * IZR d.
Proof.
  intros C HA HB H f u v w s t q F PA PB. apply (centres_apart3 ca cb _ _ _ C HA HB); [| exact PA | exact PB].
  assert (R : (0 <= ca + cb + (ra + rb + d))%Z) by lia.
  pose proof (len_coordinates (IZR x - f * IZR tx) (IZR y - f * IZR ty) (IZR z - f * IZR tz)) as (X & Y & Z).
  destruct H as [H | [H | [H | H]]]; [| | | exact (off_line_far _ _ _ _ f R H)];
    pose proof (stays_beyond _ _ _ f R F H); lra.
Qed.

(* A point of f (A - B), without the radii: with weights, since a feature's point is a mean of up to four vertices. *)
Definition in_difference (f u v w : R) := exists p p' p'' o o' o'', in_hull na ax ay az p p' p'' /\ in_hull nb bx bl bz o o' o'' /\
  u = f * (IZR x + p - o) /\ v = f * (IZR y + p' - o') /\ w = f * (IZR z + p'' - o'').

Lemma sum_single n k f : (k < n)%nat -> sum n (fun i => (if Nat.eqb i k then 1 else 0) * f i) = f k.
Proof.
  assert (Z : forall m, (m <= k)%nat -> sum m (fun i => (if Nat.eqb i k then 1 else 0) * f i) = 0).
  { induction m; simpl; intros; [lra |]. rewrite IHm by lia.
    replace (Nat.eqb m k) with false by (symmetry; apply Nat.eqb_neq; lia). lra. }
  induction n; simpl; intros L; [lia |]. destruct (Nat.eq_dec n k) as [-> | N].
  - rewrite Z, Nat.eqb_refl by lia. lra.
  - rewrite IHn by lia. replace (Nat.eqb n k) with false by (symmetry; apply Nat.eqb_neq; lia). lra.
Qed.

Lemma hull_vertex n vx vy vz k : (k < n)%nat -> in_hull n vx vy vz (IZR (vx k)) (IZR (vy k)) (IZR (vz k)).
Proof.
  intros L. exists (fun i => if Nat.eqb i k then 1 else 0). repeat split.
  - intros. destruct (Nat.eqb i k); lra.
  - rewrite (sum_ext n _ (fun i => (if Nat.eqb i k then 1 else 0) * 1)) by (intros; lra).
    apply (sum_single n k (fun _ => 1) L).
  - symmetry. apply (sum_single n k (fun i => IZR (vx i)) L).
  - symmetry. apply (sum_single n k (fun i => IZR (vy i)) L).
  - symmetry. apply (sum_single n k (fun i => IZR (vz i)) L).
Qed.

Lemma hull_between n vx vy vz a b p p' p'' q q' q'' : 0 <= a -> 0 <= b -> a + b = 1 -> in_hull n vx vy vz p p' p'' ->
  in_hull n vx vy vz q q' q'' -> in_hull n vx vy vz (a * p + b * q) (a * p' + b * q') (a * p'' + b * q'').
Proof.
  intros A B One (k & K & O1 & -> & -> & ->) (m & M & O2 & -> & -> & ->).
  exists (fun i => a * k i + b * m i + 0 * k i). repeat split.
  - intros i I. specialize (K i I). specialize (M i I). nra.
  - rewrite sum_combine, O1, O2. lra.
  - rewrite <- (Rplus_0_r (a * _ + b * _)), <- (Rmult_0_l (sum n (fun i => k i * IZR (vx i)))), <- sum_combine.
    apply sum_ext. intros. ring.
  - rewrite <- (Rplus_0_r (a * _ + b * _)), <- (Rmult_0_l (sum n (fun i => k i * IZR (vy i)))), <- sum_combine.
    apply sum_ext. intros. ring.
  - rewrite <- (Rplus_0_r (a * _ + b * _)), <- (Rmult_0_l (sum n (fun i => k i * IZR (vz i)))), <- sum_combine.
    apply sum_ext. intros. ring.
Qed.

Lemma difference_between f a b u v w s t q : 0 <= a -> 0 <= b -> a + b = 1 -> in_difference f u v w -> in_difference f s t q ->
  in_difference f (a * u + b * s) (a * v + b * t) (a * w + b * q).
Proof.
  intros A B One (p1 & p2 & p3 & o1 & o2 & o3 & P & O & -> & -> & ->) (k1 & k2 & k3 & m1 & m2 & m3 & K & M & -> & -> & ->).
  exists (a * p1 + b * k1), (a * p2 + b * k2), (a * p3 + b * k3), (a * o1 + b * m1), (a * o2 + b * m2), (a * o3 + b * m3).
  split; [apply hull_between; assumption |]. split; [apply hull_between; assumption |].
  replace b with (1 - a) by lra. repeat split; ring.
Qed.

(* A mean by weights that do not add up to 1. *)
Lemma difference_mean f a b u v w s t q : 0 <= a -> 0 <= b -> 0 < a + b -> in_difference f u v w -> in_difference f s t q ->
  in_difference f ((a * u + b * s) / (a + b)) ((a * v + b * t) / (a + b)) ((a * w + b * q) / (a + b)).
Proof.
  intros A B C U S. set (k := / (a + b)). assert (K : 0 < k) by (apply Rinv_0_lt_compat; exact C).
  assert (One : k * a + k * b = 1) by (rewrite <- Rmult_plus_distr_l; apply Rinv_l; lra).
  replace ((a * u + b * s) / (a + b)) with (k * a * u + k * b * s) by (unfold k; field; lra).
  replace ((a * v + b * t) / (a + b)) with (k * a * v + k * b * t) by (unfold k; field; lra).
  replace ((a * w + b * q) / (a + b)) with (k * a * w + k * b * q) by (unfold k; field; lra).
  apply difference_between; try assumption; nra.
Qed.

Lemma difference_mean3 f a b c u v w s t q k l m : 0 <= a -> 0 <= b -> 0 <= c -> 0 < a + b + c ->
  in_difference f u v w -> in_difference f s t q -> in_difference f k l m ->
  in_difference f ((a * u + b * s + c * k) / (a + b + c)) ((a * v + b * t + c * l) / (a + b + c))
    ((a * w + b * q + c * m) / (a + b + c)).
Proof.
  intros A B C One U S K. destruct (Req_dec (a + b) 0) as [Z | N].
  - assert (a = 0) by lra. assert (b = 0) by lra. subst a b.
    replace ((0 * u + 0 * s + c * k) / (0 + 0 + c)) with k by (field; lra).
    replace ((0 * v + 0 * t + c * l) / (0 + 0 + c)) with l by (field; lra).
    replace ((0 * w + 0 * q + c * m) / (0 + 0 + c)) with m by (field; lra). exact K.
  - assert (P : 0 < a + b) by lra. pose proof (difference_mean f a b u v w s t q A B P U S) as M.
    pose proof (difference_mean f (a + b) c _ _ _ k l m ltac:(lra) C One M K) as D.
    replace ((a * u + b * s + c * k) / (a + b + c)) with (((a + b) * ((a * u + b * s) / (a + b)) + c * k) / (a + b + c))
      by (field; lra).
    replace ((a * v + b * t + c * l) / (a + b + c)) with (((a + b) * ((a * v + b * t) / (a + b)) + c * l) / (a + b + c))
      by (field; lra).
    replace ((a * w + b * q + c * m) / (a + b + c)) with (((a + b) * ((a * w + b * q) / (a + b)) + c * m) / (a + b + c))
      by (field; lra). exact D.
Qed.

Lemma named_in f i j wx wy wz : named3 (f * x) (f * y) (f * z) f i j wx wy wz ->
  in_difference (IZR f) (IZR wx) (IZR wy) (IZR wz).
Proof.
  intros (I & J & -> & -> & ->). exists (IZR (ax i)), (IZR (ay i)), (IZR (az i)), (IZR (bx j)), (IZR (bl j)), (IZR (bz j)).
  unfold seat. rewrite !plus_IZR, !mult_IZR, !minus_IZR. split; [apply hull_vertex; exact I |].
  split; [apply hull_vertex; exact J |]. repeat split; ring.
Qed.

Definition touch := exists u v w s t q, in_a u v w /\ in_b s t q /\ square_apart u v w s t q <= IZR d * IZR d.

Lemma square_zero u v w : u * u + v * v + w * w <= 0 -> u = 0 /\ v = 0 /\ w = 0.
Proof.
  intros H. pose proof (Rle_0_sqr u). pose proof (Rle_0_sqr v). pose proof (Rle_0_sqr w). unfold Rsqr in *.
  repeat split; apply Rsqr_0_uniq; unfold Rsqr; lra.
Qed.

(* A point of f (A - B) at most f m from the origin, m for the radii and the distance. *)
Lemma difference_near f u v w r : (1 <= f)%Z -> (0 <= r <= f * (ra + rb + d))%Z -> in_difference (IZR f) u v w ->
  u * u + v * v + w * w <= IZR r * IZR r -> touch.
Proof.
  intros F (R0 & R1) (p & p' & p'' & o & o' & o'' & P & O & U & V & W) N.
  destruct radii as (RA & RB & D). apply IZR_le in F, RA, RB, D, R0, R1. rewrite mult_IZR, !plus_IZR in R1.
  set (m := IZR ra + IZR rb + IZR d) in *. set (u1 := IZR x + p - o) in *. set (v1 := IZR y + p' - o') in *.
  set (w1 := IZR z + p'' - o'') in *. simpl in F.
  assert (M : u1 * u1 + v1 * v1 + w1 * w1 <= m * m).
  { assert (G : 0 < IZR f * IZR f) by nra. apply Rmult_le_reg_l with (IZR f * IZR f); [exact G |].
    replace (IZR f * IZR f * (u1 * u1 + v1 * v1 + w1 * w1)) with (u * u + v * v + w * w) by (rewrite U, V, W; ring).
    pose proof (Rmult_le_compat _ _ _ _ R0 R0 R1 R1). lra. }
  destruct (Req_dec m 0) as [Z | NZ].
  - destruct (square_zero u1 v1 w1) as (U0 & V0 & W0); [rewrite Z in M; lra |].
    exists (IZR (cx + x) + p), (IZR (cy + y) + p'), (IZR (cz + z) + p''), (IZR cx + o), (IZR cy + o'), (IZR cz + o'').
    pose proof (Rle_0_sqr (IZR ra)). pose proof (Rle_0_sqr (IZR rb)). pose proof (Rle_0_sqr (IZR d)). unfold Rsqr in *.
    split; [exists p, p', p''; split; [exact P | rewrite !plus_IZR; lra] |].
    split; [exists o, o', o''; split; [exact O | lra] |]. unfold square_apart. rewrite !plus_IZR.
    replace (IZR cx + IZR x + p - (IZR cx + o)) with u1 by (unfold u1; ring).
    replace (IZR cy + IZR y + p' - (IZR cy + o')) with v1 by (unfold v1; ring).
    replace (IZR cz + IZR z + p'' - (IZR cz + o'')) with w1 by (unfold w1; ring). rewrite U0, V0, W0. lra.
  - assert (0 < m) by (unfold m in *; lra). set (k := / m). assert (K : k * m = 1) by (apply Rinv_l; exact NZ).
    assert (0 < k) by (apply Rinv_0_lt_compat; assumption).
    assert (S : (k * u1) * (k * u1) + (k * v1) * (k * v1) + (k * w1) * (k * w1) <= 1).
    { replace ((k * u1) * (k * u1) + (k * v1) * (k * v1) + (k * w1) * (k * w1))
        with ((k * k) * (u1 * u1 + v1 * v1 + w1 * w1)) by ring.
      replace 1 with ((k * k) * (m * m)) by (replace ((k * k) * (m * m)) with ((k * m) * (k * m)) by ring; rewrite K; ring).
      apply Rmult_le_compat_l; [apply Rle_0_sqr | exact M]. }
    assert (scaled : forall e, (e * (k * u1)) * (e * (k * u1)) + (e * (k * v1)) * (e * (k * v1)) +
      (e * (k * w1)) * (e * (k * w1)) <= e * e).
    { intros e. replace ((e * (k * u1)) * (e * (k * u1)) + (e * (k * v1)) * (e * (k * v1)) + (e * (k * w1)) * (e * (k * w1)))
        with ((e * e) * ((k * u1) * (k * u1) + (k * v1) * (k * v1) + (k * w1) * (k * w1))) by ring.
      rewrite <- (Rmult_1_r (e * e)) at 2. apply Rmult_le_compat_l; [apply Rle_0_sqr | exact S]. }
    exists (IZR (cx + x) + p - IZR ra * (k * u1)), (IZR (cy + y) + p' - IZR ra * (k * v1)),
      (IZR (cz + z) + p'' - IZR ra * (k * w1)), (IZR cx + o + IZR rb * (k * u1)), (IZR cy + o' + IZR rb * (k * v1)),
      (IZR cz + o'' + IZR rb * (k * w1)).
    split; [exists p, p', p''; split; [exact P | rewrite !plus_IZR; pose proof (scaled (IZR ra)); lra] |].
    split; [exists o, o', o''; split; [exact O | pose proof (scaled (IZR rb)); lra] |].
    unfold square_apart. rewrite !plus_IZR.
    replace (IZR cx + IZR x + p - IZR ra * (k * u1) - (IZR cx + o + IZR rb * (k * u1))) with (IZR d * (k * u1)).
    2: { assert (u1 = k * m * u1) by (rewrite K; lra). unfold u1, m in *. lra. }
    replace (IZR cy + IZR y + p' - IZR ra * (k * v1) - (IZR cy + o' + IZR rb * (k * v1))) with (IZR d * (k * v1)).
    2: { assert (v1 = k * m * v1) by (rewrite K; lra). unfold v1, m in *. lra. }
    replace (IZR cz + IZR z + p'' - IZR ra * (k * w1) - (IZR cz + o'' + IZR rb * (k * w1))) with (IZR d * (k * w1)).
    2: { assert (w1 = k * m * w1) by (rewrite K; lra). unfold w1, m in *. lra. }
    apply scaled.
Qed.

Ltac real_of H := unfold share3, share_of, toward3, volume3, area3, cross, norm3, dot3 in H;
  repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR, ?opp_IZR in H.

(* The point of f (A - B) that a feature has nearest to the origin: its square is n / m. *)
Lemma feature_point3 f n m : feature_measures (f * x) (f * y) (f * z) f n m ->
  (0 < m)%Z /\ exists u v w, in_difference (IZR f) u v w /\ (u * u + v * v + w * w) * IZR m = IZR n.
Proof.
  intros [H | [H | H]].
  - destruct H as (i & j & u & v & w & N & (E & ->)). apply named_in in N. split; [lia |].
    exists (IZR u), (IZR v), (IZR w). split; [exact N |]. apply (f_equal IZR) in E. real_of E. lra.
  - destruct H as (i & j & k & l & px & py & pz & qx & qy & qz & P & Q & (T & T') & -> & E).
    apply named_in in P, Q. split; [lia |]. apply Z.gt_lt, IZR_lt in T, T'. apply (f_equal IZR) in E.
    real_of T. real_of T'. real_of E. unfold toward3, norm3, dot3. rewrite !plus_IZR, !minus_IZR, !plus_IZR, !mult_IZR.
    set (p := IZR px) in *. set (p' := IZR py) in *. set (p'' := IZR pz) in *.
    set (u := IZR qx) in *. set (v := IZR qy) in *. set (w := IZR qz) in *. clearbody p p' p'' u v w. rewrite E. clear E.
    set (a := p * p + p' * p' + p'' * p'' - (p * u + p' * v + p'' * w)) in *.
    set (b := u * u + v * v + w * w - (u * p + v * p' + w * p'')) in *.
    pose proof (difference_mean _ b a _ _ _ _ _ _ ltac:(lra) ltac:(lra) ltac:(lra) P Q) as M.
    eexists _, _, _. split; [exact M |].
    transitivity (((b * p + a * u) * (b * p + a * u) + (b * p' + a * v) * (b * p' + a * v) +
      (b * p'' + a * w) * (b * p'' + a * w)) / (b + a)); [field; lra |].
    replace ((b * p + a * u) * (b * p + a * u) + (b * p' + a * v) * (b * p' + a * v) + (b * p'' + a * w) * (b * p'' + a * w))
      with ((b + a) * ((p * p + p' * p' + p'' * p'') * (u * u + v * v + w * w) -
        (p * u + p' * v + p'' * w) * (p * u + p' * v + p'' * w))) by (unfold a, b; ring).
    field. lra.
  - destruct H as (i & j & k & l & o & e & px & py & pz & qx & qy & qz & sx & sy & sz & P & Q & S & (A & B & C) & N & M).
    apply named_in in P, Q, S. apply Z.gt_lt, IZR_lt in A, B, C. apply (f_equal IZR) in N. pose proof M as M'.
    apply (f_equal IZR) in M. real_of A. real_of B. real_of C. real_of N. real_of M.
    pose proof (shares_sum (IZR px) (IZR py) (IZR pz) (IZR qx) (IZR qy) (IZR qz) (IZR sx) (IZR sy) (IZR sz)) as E.
    destruct (shares_mean (IZR px) (IZR py) (IZR pz) (IZR qx) (IZR qy) (IZR qz) (IZR sx) (IZR sy) (IZR sz)) as (X & Y & Z).
    set (p1 := share _ _ _ _ _ _ (IZR px) (IZR py) (IZR pz)) in *. set (p2 := share _ _ _ _ _ _ (IZR qx) (IZR qy) (IZR qz)) in *.
    set (p3 := share _ _ _ _ _ _ (IZR sx) (IZR sy) (IZR sz)) in *.
    assert (P3 : 0 < p3) by exact A. assert (P1 : 0 < p1) by exact B. assert (P2 : 0 < p2) by exact C. clear A B C.
    set (h := volume _ _ _ _ _ _ _ _ _) in *. set (nx := area (IZR py) _ _ _ _ _) in *. set (ny := area (IZR pz) _ _ _ _ _) in *.
    set (nz := area (IZR px) _ _ _ _ _) in *.
    assert (N' : IZR n = h * h) by exact N. assert (M1 : IZR m = nx * nx + ny * ny + nz * nz) by exact M. clear N M M'.
    clearbody p1 p2 p3 h nx ny nz. assert (G : 0 < IZR m) by lra. split; [apply lt_IZR; exact G |].
    pose proof (difference_mean3 _ p1 p2 p3 _ _ _ _ _ _ _ _ _ ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) P Q S) as W.
    rewrite X, Y, Z, E, <- M1 in W. eexists _, _, _. split; [exact W |]. rewrite N'.
    transitivity (h * h * (nx * nx + ny * ny + nz * nz) / IZR m); [field; lra |]. rewrite <- M1. field. lra.
Qed.

(* `yes`: some points of A and of B are at most the distance apart. *)
Theorem touching3 : together3 (ra + rb + d) -> touch.
Proof.
  intros (f & r & F & (R0 & R1) & H).
  assert (R : (0 <= r <= f * (ra + rb + d))%Z) by lia.
  assert (O : (0 <= 0 <= f * (ra + rb + d))%Z) by lia.
  assert (point : forall s, (0 <= s <= f * (ra + rb + d))%Z -> point_within (f * x) (f * y) (f * z) f s -> touch).
  { intros s S (i & j & u & v & w & N & B). apply named_in in N. apply (difference_near f _ _ _ s F S N).
    unfold in_ball, norm3 in B. apply IZR_le in B. repeat rewrite ?mult_IZR, ?plus_IZR in B. exact B. }
  assert (feature : forall s n m, (0 <= s <= f * (ra + rb + d))%Z -> feature_measures (f * x) (f * y) (f * z) f n m ->
    (n <= s * s * m)%Z -> touch).
  { intros s n m S M N. destruct (feature_point3 f n m M) as (G & u & v & w & D & E).
    apply (difference_near f u v w s F S D). apply IZR_lt in G. apply IZR_le in N. rewrite !mult_IZR in N. simpl in G.
    apply Rmult_le_reg_r with (IZR m); lra. }
  destruct H as [[H | [H | [H | H]]] | [H | [H | H]]].
  - exact (point 0%Z O H).
  - destruct H as (i & j & k & l & px & py & pz & qx & qy & qz & P & Q & (T & T') & X & Y & Z).
    apply named_in in P, Q. apply Z.gt_lt, IZR_lt in T, T'. unfold meets_one in X, Y, Z. apply (f_equal IZR) in X, Y, Z.
    rewrite plus_IZR, !mult_IZR in X, Y, Z. simpl in T, T'.
    set (a := IZR (toward3 px py pz qx qy qz)) in *. set (b := IZR (toward3 qx qy qz px py pz)) in *. clearbody a b.
    pose proof (difference_mean _ b a _ _ _ _ _ _ ltac:(lra) ltac:(lra) ltac:(lra) P Q) as M.
    replace (b * IZR px + a * IZR qx) with 0 in M by lra. replace (b * IZR py + a * IZR qy) with 0 in M by lra.
    replace (b * IZR pz + a * IZR qz) with 0 in M by lra. apply (difference_near f _ _ _ 0 F O M).
    replace (0 / (b + a)) with 0 by (field; lra). lra.
  - destruct H as (i & j & k & l & m & n & px & py & pz & qx & qy & qz & sx & sy & sz & P & Q & S & In & V).
    eapply (feature 0%Z 0%Z); [exact O | right; right | simpl; apply Z.le_refl].
    exists i, j, k, l, m, n, px, py, pz, qx, qy, qz, sx, sy, sz. split; [exact P |]. split; [exact Q |]. split; [exact S |].
    split; [exact In |]. rewrite V. split; reflexivity.
  - destruct H as (i & j & k & l & m & n & o & e & px & py & pz & qx & qy & qz & sx & sy & sz & tx & ty & tz & P & Q & S & T & V).
    apply named_in in P, Q, S, T. unfold in_tetrahedron, one_side in V.
    set (a := volume3 qx qy qz sx sy sz tx ty tz) in *. set (b := volume3 px py pz sx sy sz tx ty tz) in *.
    set (c := volume3 px py pz qx qy qz tx ty tz) in *. set (g := volume3 px py pz qx qy qz sx sy sz) in *.
    assert (X : (a * px - b * qx + c * sx - g * tx = 0)%Z) by (unfold a, b, c, g, volume3, dot3, cross; ring).
    assert (Y : (a * py - b * qy + c * sy - g * ty = 0)%Z) by (unfold a, b, c, g, volume3, dot3, cross; ring).
    assert (Z : (a * pz - b * qz + c * sz - g * tz = 0)%Z) by (unfold a, b, c, g, volume3, dot3, cross; ring).
    clearbody a b c g. apply (f_equal IZR) in X, Y, Z.
    repeat rewrite ?minus_IZR, ?plus_IZR, ?mult_IZR in X. repeat rewrite ?minus_IZR, ?plus_IZR, ?mult_IZR in Y.
    repeat rewrite ?minus_IZR, ?plus_IZR, ?mult_IZR in Z.
    assert (mean : forall a b c g, 0 <= a -> 0 <= b -> 0 <= c -> 0 <= g -> 0 < a + b + c + g ->
      a * IZR px + b * IZR qx + c * IZR sx + g * IZR tx = 0 -> a * IZR py + b * IZR qy + c * IZR sy + g * IZR ty = 0 ->
      a * IZR pz + b * IZR qz + c * IZR sz + g * IZR tz = 0 -> touch).
    { clear - radii P Q S T F O. intros a b c g A B C G One X Y Z. destruct (Req_dec (a + b + c) 0) as [E | N].
      - assert (a = 0) by lra. assert (b = 0) by lra. assert (c = 0) by lra. subst a b c.
        apply (difference_near f _ _ _ 0 F O T). assert (IZR tx = 0) by nra. assert (IZR ty = 0) by nra.
        assert (IZR tz = 0) by nra. rewrite H, H0, H1. simpl. lra.
      - pose proof (difference_mean3 _ a b c _ _ _ _ _ _ _ _ _ A B C ltac:(lra) P Q S) as M.
        pose proof (difference_mean _ (a + b + c) g _ _ _ _ _ _ ltac:(lra) G One M T) as D.
        apply (difference_near f _ _ _ 0 F O D).
        assert (zero : forall p q s t, a * p + b * q + c * s + g * t = 0 ->
          ((a + b + c) * ((a * p + b * q + c * s) / (a + b + c)) + g * t) / (a + b + c + g) = 0).
        { intros p q s t W. replace ((a + b + c) * ((a * p + b * q + c * s) / (a + b + c)) + g * t) with (a * p + b * q + c * s + g * t)
            by (field; lra). rewrite W. field. lra. }
        rewrite !zero by assumption. lra. }
    destruct V as [(A & B & C & G & E) | (A & B & C & G & E)]; apply IZR_le in A, B, C, G; apply IZR_lt in E;
      rewrite !plus_IZR, !opp_IZR in E.
    + rewrite opp_IZR in B, G. apply (mean (IZR a) (- IZR b) (IZR c) (- IZR g)); lra.
    + rewrite opp_IZR in A, C. apply (mean (- IZR a) (IZR b) (- IZR c) (IZR g)); lra.
  - exact (point r R H).
  - destruct H as (i & j & k & l & px & py & pz & qx & qy & qz & P & Q & T & N). eapply (feature r); [exact R | right; left | exact N].
    exists i, j, k, l, px, py, pz, qx, qy, qz. split; [exact P |]. split; [exact Q |]. split; [exact T |]. split; reflexivity.
  - destruct H as (i & j & k & l & m & n & px & py & pz & qx & qy & qz & sx & sy & sz & P & Q & S & In & N).
    eapply (feature r); [exact R | right; right | exact N].
    exists i, j, k, l, m, n, px, py, pz, qx, qy, qz, sx, sy, sz. split; [exact P |]. split; [exact Q |]. split; [exact S |].
    split; [exact In |]. split; reflexivity.
Qed.

(* A point of A - B at length m from the origin, with the radii taken off. *)
Lemma difference_exact3 u v w m : in_difference 1 u v w -> u * u + v * v + w * w = m * m -> 0 < m -> IZR ra + IZR rb <= m ->
  exists e f g s t q, in_a e f g /\ in_b s t q /\ square_apart e f g s t q = (m - IZR ra - IZR rb) * (m - IZR ra - IZR rb).
Proof.
  intros (p & p' & p'' & o & o' & o'' & P & O & U & V & W) N M0 M.
  destruct radii as (RA & RB & D). apply IZR_le in RA, RB, D.
  set (k := / m). assert (K : k * m = 1) by (apply Rinv_l; lra).
  assert (S : (k * u) * (k * u) + (k * v) * (k * v) + (k * w) * (k * w) = 1).
  { replace ((k * u) * (k * u) + (k * v) * (k * v) + (k * w) * (k * w)) with ((k * k) * (u * u + v * v + w * w)) by ring.
    rewrite N. replace ((k * k) * (m * m)) with ((k * m) * (k * m)) by ring. rewrite K. ring. }
  assert (scaled : forall e, (e * (k * u)) * (e * (k * u)) + (e * (k * v)) * (e * (k * v)) + (e * (k * w)) * (e * (k * w)) = e * e).
  { intros e. replace ((e * (k * u)) * (e * (k * u)) + (e * (k * v)) * (e * (k * v)) + (e * (k * w)) * (e * (k * w)))
      with ((e * e) * ((k * u) * (k * u) + (k * v) * (k * v) + (k * w) * (k * w))) by ring. rewrite S. ring. }
  exists (IZR (cx + x) + p - IZR ra * (k * u)), (IZR (cy + y) + p' - IZR ra * (k * v)), (IZR (cz + z) + p'' - IZR ra * (k * w)),
    (IZR cx + o + IZR rb * (k * u)), (IZR cy + o' + IZR rb * (k * v)), (IZR cz + o'' + IZR rb * (k * w)).
  split; [exists p, p', p''; split; [exact P | pose proof (scaled (IZR ra)); lra] |].
  split; [exists o, o', o''; split; [exact O | pose proof (scaled (IZR rb)); lra] |].
  unfold square_apart. rewrite !plus_IZR.
  replace (IZR cx + IZR x + p - IZR ra * (k * u) - (IZR cx + o + IZR rb * (k * u))) with ((m - IZR ra - IZR rb) * (k * u)).
  2: { assert (u = k * m * u) by (rewrite K; lra). lra. }
  replace (IZR cy + IZR y + p' - IZR ra * (k * v) - (IZR cy + o' + IZR rb * (k * v))) with ((m - IZR ra - IZR rb) * (k * v)).
  2: { assert (v = k * m * v) by (rewrite K; lra). lra. }
  replace (IZR cz + IZR z + p'' - IZR ra * (k * w) - (IZR cz + o'' + IZR rb * (k * w))) with ((m - IZR ra - IZR rb) * (k * w)).
  2: { assert (w = k * m * w) by (rewrite K; lra). lra. }
  apply scaled.
Qed.

(* No point of f (A - B) lies before w along d. *)
Lemma support_all f dx dy dz wx wy wz : support3 f dx dy dz wx wy wz -> forall a a' a'' b b' b'',
  in_hull na ax ay az a a' a'' -> in_hull nb bx bl bz b b' b'' ->
  IZR f * (IZR dx * (IZR x + a - b) + IZR dy * (IZR y + a' - b') + IZR dz * (IZR z + a'' - b'')) <= IZR (dot3 dx dy dz wx wy wz).
Proof.
  intros B a a' a'' b b' b'' HA HB. set (e := IZR (dot3 dx dy dz wx wy wz)). apply le_epsilon. intros c Pc. apply Rlt_le.
  assert (V1 : forall i j, (i < na)%nat -> (j < nb)%nat ->
    IZR f * IZR dx * IZR (ax i) + IZR f * IZR dy * IZR (ay i) + IZR f * IZR dz * IZR (az i) <
    e + c - IZR f * (IZR dx * IZR x + IZR dy * IZR y + IZR dz * IZR z) +
    IZR f * (IZR dx * IZR (bx j) + IZR dy * IZR (bl j) + IZR dz * IZR (bz j))).
  { intros i j I J. specialize (B i j I J). apply IZR_le in B. fold e in B. unfold dot3 in B.
    repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR in B. lra. }
  assert (V2 : forall j, (j < nb)%nat ->
    - (IZR f * IZR dx) * IZR (bx j) + - (IZR f * IZR dy) * IZR (bl j) + - (IZR f * IZR dz) * IZR (bz j) <
    e + c - IZR f * (IZR dx * IZR x + IZR dy * IZR y + IZR dz * IZR z) -
    (IZR f * IZR dx * a + IZR f * IZR dy * a' + IZR f * IZR dz * a'')).
  { intros j J. pose proof (hull_below na ax ay az a a' a'' _ _ _ _ HA (fun i I => V1 i j I J)). lra. }
  pose proof (hull_below nb bx bl bz b b' b'' _ _ _ _ HB V2). lra.
Qed.

(* A distance: the shapes have one, which rounds to what is checked, a tie up. *)
Theorem distance_rounds3 : measured3 (ra + rb) d -> exists m, 0 < m /\ IZR d - 1 / 2 <= m < IZR d + 1 / 2 /\
  (forall u v w s t q, in_a u v w -> in_b s t q -> m <= sqrt (square_apart u v w s t q)) /\
  (exists u v w s t q, in_a u v w /\ in_b s t q /\ sqrt (square_apart u v w s t q) = m).
Proof.
  intros (f & n & m & dx & dy & dz & wx & wy & wz & F & H & B & (E & C) & A & (R2 & R1)).
  pose proof radii as (RA & RB & D). apply IZR_le in RA, RB, D.
  destruct (feature_point3 f n m H) as (M & u0 & v0 & w0 & (p & p' & p'' & o & o' & o'' & P & O & -> & -> & ->) & N).
  set (u := IZR x + p - o) in *. set (v := IZR y + p' - o') in *. set (w := IZR z + p'' - o'') in *.
  apply IZR_lt in M. apply IZR_le in F. simpl in F, M. apply IZR_lt in E. unfold farther, across3, below_half in *.
  apply Z.gt_lt, IZR_lt in C. apply (f_equal IZR) in A. apply IZR_lt in R2.
  rewrite !mult_IZR in A. rewrite !mult_IZR, opp_IZR, !plus_IZR in C.
  repeat rewrite ?mult_IZR, ?plus_IZR in R2.
  set (e := IZR (dot3 dx dy dz wx wy wz)) in *. set (g := sqrt (u * u + v * v + w * w)).
  assert (S0 : 0 <= u * u + v * v + w * w).
  { pose proof (Rle_0_sqr u). pose proof (Rle_0_sqr v). pose proof (Rle_0_sqr w). unfold Rsqr in *. lra. }
  assert (G0 : 0 <= g) by apply sqrt_pos. assert (G : g * g = u * u + v * v + w * w) by (apply sqrt_sqrt; exact S0).
  assert (GN : IZR f * g * (IZR f * g) * IZR m = IZR n) by (rewrite <- N; transitivity (IZR f * IZR f * (g * g) * IZR m); [ring | rewrite G; ring]).
  set (l := sqrt (IZR (norm3 dx dy dz))).
  assert (L1 : 0 <= IZR (norm3 dx dy dz)) by (apply IZR_le; unfold norm3; nia).
  assert (L0 : 0 <= l) by apply sqrt_pos. assert (LL : l * l = IZR (norm3 dx dy dz)) by (apply sqrt_sqrt; exact L1).
  rewrite <- LL in A, C. set (r := IZR ra + IZR rb) in *.
  assert (L : 0 < l). { destruct L0 as [| Z]; [assumption |]. rewrite <- Z in A. exfalso.
    assert (Q : e * e * IZR m = 0) by (rewrite A; ring). assert (0 < e * e) by nra. assert (0 < e * e * IZR m) by (apply Rmult_lt_0_compat; assumption). lra. }
  assert (FG : 0 <= IZR f * g) by (apply Rmult_le_pos; lra).
  assert (EE : e * e = IZR f * g * l * (IZR f * g * l)).
  { apply Rmult_eq_reg_r with (IZR m); [| lra]. rewrite A, <- GN. ring. }
  assert (EG : - e = IZR f * g * l).
  { apply Rsqr_inj; [lra | apply Rmult_le_pos; lra |]. unfold Rsqr. rewrite <- EE. ring. }
  assert (RG : r < g).
  { assert (X : IZR f * r * l < IZR f * g * l).
    { rewrite <- EG. apply square_less; [lra |].
      replace (IZR f * r * l * (IZR f * r * l)) with (IZR f * r * (IZR f * r) * (l * l)) by ring. exact C. }
    apply Rmult_lt_reg_r in X; [| exact L]. apply Rmult_lt_reg_l in X; [exact X | lra]. }
  assert (halves : forall t, t * IZR f * (t * IZR f) * IZR m - 4 * IZR n = IZR f * IZR f * IZR m * (t * t - 2 * g * (2 * g))).
  { intros t. rewrite <- GN. ring. }
  assert (FM : 0 < IZR f * IZR f * IZR m) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat |]; lra).
  assert (U : 2 * g < 2 * (IZR d + r) + 1).
  { apply square_less; [unfold r; lra |]. apply Rmult_lt_reg_l with (IZR f * IZR f * IZR m); [exact FM |].
    pose proof (halves (2 * (IZR d + r) + 1)). unfold r in *. simpl in R2. lra. }
  assert (W : 2 * (IZR d + r) - 1 <= 2 * g).
  { destruct R1 as [R1 | R1].
    - apply (f_equal IZR) in R1. rewrite !plus_IZR in R1. simpl in R1. unfold r. lra.
    - unfold above_half in R1. apply IZR_le in R1. repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR in R1. simpl in R1.
      apply Rnot_lt_le. intros X. assert (Z : 0 <= 2 * g) by lra. pose proof (Rmult_le_0_lt_compat _ _ _ _ Z Z X X) as Y.
      apply (Rmult_lt_compat_l (IZR f * IZR f * IZR m)) in Y; [| exact FM].
      pose proof (halves (2 * (IZR d + r) - 1)). unfold r in *. lra. }
  exists (g - r). split; [lra |]. split; [lra |]. split.
  - intros u1 v1 w1 s t q (a & a' & a'' & HA & E1) (b & b' & b'' & HB & E2).
    pose proof (support_all f dx dy dz wx wy wz B _ _ _ _ _ _ HA HB) as V. fold e in V.
    assert (V3 : IZR dx * (IZR x + a - b) + IZR dy * (IZR y + a' - b') + IZR dz * (IZR z + a'' - b'') <= - (g * l)).
    { apply Rmult_le_reg_l with (IZR f); [lra |]. lra. }
    assert (LD : IZR dx * IZR dx + IZR dy * IZR dy + IZR dz * IZR dz = l * l).
    { rewrite LL. unfold norm3. rewrite !plus_IZR, !mult_IZR. reflexivity. }
    assert (S : 0 <= square_apart u1 v1 w1 s t q).
    { pose proof (Rle_0_sqr (u1 - s)). pose proof (Rle_0_sqr (v1 - t)). pose proof (Rle_0_sqr (w1 - q)). unfold Rsqr, square_apart in *. lra. }
    set (k := sqrt (square_apart u1 v1 w1 s t q)). assert (K : k * k = square_apart u1 v1 w1 s t q) by (apply sqrt_sqrt; exact S).
    assert (K0 : 0 <= k) by apply sqrt_pos.
    pose proof (widened l (IZR dx) (IZR dy) (IZR dz) _ _ _ _ _ _ _ _ _ _ _ _ L0 LD E1 E2) as A1.
    assert (E4 : (- (u1 - s)) * (- (u1 - s)) + (- (v1 - t)) * (- (v1 - t)) + (- (w1 - q)) * (- (w1 - q)) <= k * k)
      by (unfold square_apart in K; lra).
    pose proof (cauchy3 l k (IZR dx) (IZR dy) (IZR dz) _ _ _ L0 K0 LD E4) as A3.
    apply Rmult_le_reg_l with l; [exact L |]. unfold r. lra.
  - assert (X : in_difference 1 u v w) by (exists p, p', p'', o, o', o''; repeat split; try assumption; unfold u, v, w; lra).
    destruct (difference_exact3 u v w g X (eq_sym G) ltac:(unfold r in *; lra) ltac:(unfold r in *; lra)) as (e1 & e2 & e3 & s & t & q & IA & IB & S).
    exists e1, e2, e3, s, t, q. split; [exact IA |]. split; [exact IB |]. rewrite S.
    replace (g - IZR ra - IZR rb) with (g - r) by (unfold r; lra). apply sqrt_square. lra.
Qed.

(* A depth is enough: along some direction of length 1 no point of A is more than that far beyond any point of B. So B moved
   that far along the direction leaves no point of A beyond one of B. *)
Theorem depth_enough3 : enough3 (ra + rb) d -> exists ux uy uz, ux * ux + uy * uy + uz * uz = 1 /\
  forall u v w s t q, in_a u v w -> in_b s t q -> ux * (u - s) + uy * (v - t) + uz * (w - q) <= IZR d.
Proof.
  intros (f & dx & dy & dz & wx & wy & wz & F & N & B & A). pose proof radii as (RA & RB & D). apply IZR_le in RA, RB, D, F.
  apply IZR_lt in N. simpl in F. set (l := sqrt (IZR (norm3 dx dy dz))). assert (L0 : 0 <= l) by apply sqrt_pos.
  assert (LL : l * l = IZR (norm3 dx dy dz)) by (apply sqrt_sqrt; lra).
  assert (L : 0 < l). { destruct L0 as [| Z]; [assumption |]. exfalso. rewrite <- Z in LL. lra. }
  assert (LD : IZR dx * IZR dx + IZR dy * IZR dy + IZR dz * IZR dz = l * l).
  { rewrite LL. unfold norm3. rewrite !plus_IZR, !mult_IZR. reflexivity. }
  pose proof (hull.root_most _ _ _ l A L0 LL) as R. rewrite mult_IZR, minus_IZR, plus_IZR in R.
  exists (IZR dx / l), (IZR dy / l), (IZR dz / l). split.
  { transitivity ((IZR dx * IZR dx + IZR dy * IZR dy + IZR dz * IZR dz) / (l * l)); [field; lra |]. rewrite LD. field. lra. }
  intros u v w s t q (a & a' & a'' & HA & E1) (b & b' & b'' & HB & E2).
  pose proof (support_all f dx dy dz wx wy wz B _ _ _ _ _ _ HA HB) as V.
  assert (V3 : IZR dx * (IZR x + a - b) + IZR dy * (IZR y + a' - b') + IZR dz * (IZR z + a'' - b'') <=
    (IZR d - (IZR ra + IZR rb)) * l).
  { apply Rmult_le_reg_l with (IZR f); [lra |]. lra. }
  pose proof (widened l (IZR dx) (IZR dy) (IZR dz) _ _ _ _ _ _ _ _ _ _ _ _ L0 LD E1 E2) as A1.
  apply Rmult_le_reg_l with l; [exact L |].
  replace (l * (IZR dx / l * (u - s) + IZR dy / l * (v - t) + IZR dz / l * (w - q)))
    with (IZR dx * (u - s) + IZR dy * (v - t) + IZR dz * (w - q)) by (field; lra). lra.
Qed.

End Vertices.

(* B swept along its way: each vertex moved back, and the same moved ahead. *)
Definition swept (nb : nat) (v : nat -> Z) (back ahead : Z) (j : nat) : Z :=
  if Nat.ltb j nb then (v j + back)%Z else (v (j - nb)%nat + ahead)%Z.

Section Swept.

Open Scope R_scope.

Lemma pick_low (T : Type) n i (a b : T) : (i < n)%nat -> (if Nat.ltb i n then a else b) = a.
Proof. intros L. destruct (Nat.ltb_spec i n); [reflexivity | lia]. Qed.

Lemma pick_high (T : Type) n i (a : T) (b : nat -> T) : (if Nat.ltb (n + i) n then a else b (n + i - n)%nat) = b i.
Proof. destruct (Nat.ltb_spec (n + i) n); [lia |]. f_equal. lia. Qed.

Lemma sum_twice n f : sum (2 * n) f = sum n f + sum n (fun i => f (n + i)%nat).
Proof.
  replace (2 * n)%nat with (n + n)%nat by lia. assert (A : forall m, sum (n + m) f = sum n f + sum m (fun i => f (n + i)%nat)).
  { induction m; [rewrite Nat.add_0_r; simpl; lra | rewrite Nat.add_succ_r; simpl; rewrite IHm; lra]. }
  apply A.
Qed.

Lemma sum_swept n v back ahead k : sum (2 * n) (fun j => k j * IZR (swept n v back ahead j)) =
  sum n (fun i => (k i + k (n + i)%nat) * IZR (v i)) + IZR back * sum n k + IZR ahead * sum n (fun i => k (n + i)%nat).
Proof.
  rewrite sum_twice.
  rewrite (sum_ext n _ (fun i => 1 * (k i * IZR (v i)) + IZR back * k i + 0 * 0))
    by (intros; unfold swept; rewrite pick_low, plus_IZR by assumption; ring).
  rewrite (sum_ext n (fun i => k (n + i)%nat * IZR (swept n v back ahead (n + i)))
    (fun i => 1 * (k (n + i)%nat * IZR (v i)) + IZR ahead * k (n + i)%nat + 0 * 0))
    by (intros; unfold swept; rewrite (pick_high Z n i _ (fun j => v j + ahead)%Z), plus_IZR; ring).
  rewrite (sum_ext n (fun i => (k i + k (n + i)%nat) * IZR (v i))
    (fun i => 1 * (k i * IZR (v i)) + 1 * (k (n + i)%nat * IZR (v i)) + 0 * 0))
    by (intros; ring).
  rewrite !sum_combine. ring.
Qed.

(* A and B as above; the swept shape has B's vertices (px, py, pz) back and, all of the way further, ahead. Its centre is B's
   less that, so that A's centre less it is (x, y, z) with (px, py, pz). *)
Variables (na nb : nat) (ax ay az bx bl bz : nat -> Z) (x y z px py pz tx ty tz ra rb d cx cy cz : Z).
Hypothesis radii : (0 <= ra /\ 0 <= rb /\ 0 <= d)%Z.

Notation sx := (swept nb bx px (px + tx)).
Notation sl := (swept nb bl py (py + ty)).
Notation sz := (swept nb bz pz (pz + tz)).
Notation of_a := (in_a na ax ay az x y z ra cx cy cz).
Notation of_b := (in_b nb bx bl bz rb cx cy cz).
Notation of_swept := (in_b (2 * nb) sx sl sz rb (cx - px) (cy - py) (cz - pz)).

Lemma a_back : in_a na ax ay az (x + px) (y + py) (z + pz) ra (cx - px) (cy - py) (cz - pz) = of_a.
Proof. unfold in_a. f_equal; f_equal; ring. Qed.

Lemma hull_swept s t q f : 0 <= f <= 1 -> in_hull nb bx bl bz s t q ->
  in_hull (2 * nb) sx sl sz (s + IZR px + f * IZR tx) (t + IZR py + f * IZR ty) (q + IZR pz + f * IZR tz).
Proof.
  intros F (k & K & One & -> & -> & ->). set (g := fun j => if Nat.ltb j nb then (1 - f) * k j else f * k (j - nb)%nat).
  assert (G0 : forall i, (i < nb)%nat -> g i = (1 - f) * k i + 0 * 0 + 0 * 0)
    by (intros i I; unfold g; rewrite pick_low by exact I; ring).
  assert (G1 : forall i, (i < nb)%nat -> g (nb + i)%nat = f * k i + 0 * 0 + 0 * 0)
    by (intros i I; unfold g; rewrite (pick_high R nb i _ (fun j => f * k j)); ring).
  pose proof (sum_ext nb _ _ G0) as S0. pose proof (sum_ext nb _ _ G1) as S1. rewrite sum_combine, One in S0, S1.
  assert (point : forall v back t, sum nb (fun i => k i * IZR (v i)) + IZR back + f * IZR t =
    sum (2 * nb) (fun j => g j * IZR (swept nb v back (back + t) j))).
  { intros v back e. rewrite sum_swept, S0, S1, plus_IZR.
    rewrite (sum_ext nb (fun i => (g i + g (nb + i)%nat) * IZR (v i)) (fun i => k i * IZR (v i))).
    - ring.
    - intros i I. rewrite G0, G1 by exact I. ring. }
  exists g. split; [| split; [rewrite sum_twice, S0, S1; ring | repeat split; apply point]].
  intros i I. unfold g. destruct (Nat.ltb_spec i nb); apply Rmult_le_pos; try apply K; try lra; lia.
Qed.

Lemma hull_unswept s t q : in_hull (2 * nb) sx sl sz s t q -> exists f, 0 <= f <= 1 /\
  in_hull nb bx bl bz (s - IZR px - f * IZR tx) (t - IZR py - f * IZR ty) (q - IZR pz - f * IZR tz).
Proof.
  intros (k & K & One & -> & -> & ->). rewrite sum_twice in One. set (f := sum nb (fun i => k (nb + i)%nat)) in *.
  assert (pos : forall n g, (forall i, (i < n)%nat -> 0 <= g i) -> 0 <= sum n g).
  { induction n; simpl; intros g G; [lra |]. apply Rplus_le_le_0_compat; auto with arith. }
  exists f. split.
  { split; [apply pos; intros; apply K; lia |]. assert (0 <= sum nb k) by (apply pos; intros; apply K; lia). lra. }
  exists (fun i => k i + k (nb + i)%nat). split; [intros i I; apply Rplus_le_le_0_compat; apply K; lia |]. split.
  - rewrite (sum_ext nb _ (fun i => 1 * k i + 1 * k (nb + i)%nat + 0 * 0)) by (intros; ring). rewrite sum_combine. fold f. lra.
  - rewrite !sum_swept, !plus_IZR. fold f. replace (sum nb k) with (1 - f) by lra. repeat split; ring.
Qed.

Lemma b_swept s t q f : 0 <= f <= 1 -> of_b s t q -> of_swept (s + f * IZR tx) (t + f * IZR ty) (q + f * IZR tz).
Proof.
  intros F (o & o' & o'' & O & E). eexists _, _, _. split; [exact (hull_swept _ _ _ f F O) |]. rewrite !minus_IZR.
  eapply Rle_trans; [apply Req_le | exact E]. ring.
Qed.

(* `no` of the swept shape, by a direction: A and B stay more than the margin apart on all of the way. *)
Theorem swept_apart3 : separated_by3 na (2 * nb) ax ay az sx sl sz (x + px) (y + py) (z + pz) (ra + rb + d) ->
  forall f u v w s t q, 0 <= f <= 1 -> of_a u v w -> of_b s t q ->
  square_apart u v w (s + f * IZR tx) (t + f * IZR ty) (q + f * IZR tz) > IZR d * IZR d.
Proof.
  intros H f u v w s t q F PA PB. rewrite <- a_back in PA. apply (b_swept _ _ _ f F) in PB.
  exact (apart3 _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ radii H _ _ _ _ _ _ PA PB).
Qed.

(* `no` of the swept shape, by the spheres. *)
Theorem swept_spheres3 ca cs : (0 <= ca /\ 0 <= cs)%Z ->
  (forall i, (i < na)%nat -> norm3 (ax i) (ay i) (az i) <= ca * ca)%Z ->
  (forall j, (j < 2 * nb)%nat -> norm3 (sx j) (sl j) (sz j) <= cs * cs)%Z ->
  spheres_apart (x + px) (y + py) (z + pz) (ca + cs + (ra + rb + d)) ->
  forall f u v w s t q, 0 <= f <= 1 -> of_a u v w -> of_b s t q ->
  square_apart u v w (s + f * IZR tx) (t + f * IZR ty) (q + f * IZR tz) > IZR d * IZR d.
Proof.
  intros C HA HB H f u v w s t q F PA PB. rewrite <- a_back in PA. apply (b_swept _ _ _ f F) in PB.
  exact (spheres_apart3 _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ radii ca cs C HA HB H _ _ _ _ _ _ PA PB).
Qed.

(* `yes` of the swept shape: somewhere on the way A and B touch. *)
Theorem swept_touches3 :
  together3 na (2 * nb) ax ay az sx sl sz (x + px) (y + py) (z + pz) (ra + rb + d) ->
  exists f u v w s t q, 0 <= f <= 1 /\ of_a u v w /\ of_b s t q /\
  square_apart u v w (s + f * IZR tx) (t + f * IZR ty) (q + f * IZR tz) <= IZR d * IZR d.
Proof.
  intros H. destruct (touching3 _ _ _ _ _ _ _ _ _ _ _ _ _ _ (cx - px) (cy - py) (cz - pz) radii H)
    as (u & v & w & s & t & q & PA & (o & o' & o'' & O & E) & T). rewrite a_back in PA.
  destruct (hull_unswept _ _ _ O) as (f & F & O').
  exists f, u, v, w, (s - f * IZR tx), (t - f * IZR ty), (q - f * IZR tz). split; [exact F |]. split; [exact PA |]. split.
  - eexists _, _, _. split; [exact O' |]. rewrite !minus_IZR in E. eapply Rle_trans; [apply Req_le | exact E]. ring.
  - eapply Rle_trans; [apply Req_le | exact T]. unfold square_apart. ring.
Qed.
End Swept.

Print Assumptions apart3.
Print Assumptions spheres_apart3.
Print Assumptions spheres_miss3.
Print Assumptions touching3.
Print Assumptions distance_rounds3.
Print Assumptions depth_enough3.
Print Assumptions swept_apart3.
Print Assumptions swept_spheres3.
Print Assumptions swept_touches3.
