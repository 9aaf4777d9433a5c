(* From vertices to all points: what the contracts of plane.h say of the vertices of two polygons decides about every
   point of the two shapes. The definitions over Z are those of geometry.h and plane.h, name by name. *)
Require Import Reals Lra Psatz ZArith.

Section Vertices.

(* Vertex i of A is (ax i, ay i) relative to A's centre, one of na; those of B likewise. (x, y) is A's centre less B's. *)
Variables (na nb : nat) (ax ay bx bl : nat -> Z) (x y : Z).

Open Scope Z_scope.

Definition dot (x y u v : Z) := x * u + y * v.
Definition cross (x y u v : Z) := x * v - y * u.
Definition near_point (x y r : Z) := x * x + y * y <= r * r.
Definition foot (x y u v : Z) := dot x y (u - x) (v - y) < 0 /\ dot u v (u - x) (v - y) > 0.
Definition near_line (x y u v r : Z) :=
  cross x y u v * cross x y u v <= r * r * dot (u - x) (v - y) (u - x) (v - y).
Definition on_segment (x y u v : Z) := cross x y u v = 0 /\ dot x y u v <= 0.
Definition in_triangle (x y u v s t : Z) :=
  on_segment x y u v \/ on_segment u v s t \/ on_segment s t x y \/
  (cross x y u v > 0 /\ cross u v s t > 0 /\ cross s t x y > 0) \/
  (cross x y u v < 0 /\ cross u v s t < 0 /\ cross s t x y < 0).
Definition farther (s r square : Z) := s * s > r * r * square.
Definition beyond (dx dy x y r : Z) := dot dx dy x y < 0 /\ farther (- dot dx dy x y) r (dot dx dy dx dy).

Definition named (i j : nat) (wx wy : Z) :=
  (i < na)%nat /\ (j < nb)%nat /\ wx = x + ax i - bx j /\ wy = y + ay i - bl j.
Definition separated_by (r : Z) := exists dx dy, forall i j, (i < na)%nat -> (j < nb)%nat ->
  beyond dx dy (x + ax i - bx j) (y + ay i - bl j) r.
Definition enclosing := exists i j k l m n px py qx qy rx ry,
  named i j px py /\ named k l qx qy /\ named m n rx ry /\ in_triangle px py qx qy rx ry.
Definition near_vertex (r : Z) := exists i j px py, named i j px py /\ near_point px py r.
Definition near_edge (r : Z) := exists i j k l px py qx qy,
  named i j px py /\ named k l qx qy /\ foot px py qx qy /\ near_line px py qx qy r.
Definition behind (dx dy h : Z) := forall i j, (i < na)%nat -> (j < nb)%nat ->
  dot x y dx dy + dot (ax i) (ay i) dx dy + dot (bx j) (bl j) (- dx) (- dy) <= h.
Definition clear (dx dy h r : Z) := h < 0 /\ farther (- h) r (dot dx dy dx dy).
Definition of_vertex (x y dx dy h : Z) := dx = - x /\ dy = - y /\ h = - dot x y x y.
Definition of_edge (x y u v dx dy h : Z) := foot x y u v /\ dx = v - y /\ dy = - (u - x) /\ h = cross x y u v.
Definition feature (count : Z) (i j k l : nat) (dx dy h : Z) := (i < na)%nat /\ (j < nb)%nat /\
  (count = 1 -> of_vertex (x + ax i - bx j) (y + ay i - bl j) dx dy h) /\
  (count <> 1 -> (k < na)%nat /\ (l < nb)%nat /\ of_edge (x + ax i - bx j) (y + ay i - bl j)
    (x + ax k - bx l) (y + ay k - bl l) dx dy h).
Definition rounded (h square n : Z) :=
  (n = 0 \/ 4 * h * h >= (2 * n - 1) * (2 * n - 1) * square) /\ 4 * h * h < (2 * n + 1) * (2 * n + 1) * square.
Definition line_measures (r distance dx dy h : Z) :=
  behind dx dy h /\ clear dx dy h r /\ rounded (- h) (dot dx dy dx dy) (distance + r).
Definition same_sign (d u : Z) := (d = 0 -> u = 0) /\ (d > 0 -> 0 <= u) /\ (d < 0 -> u <= 0).
Definition along_unit (dx dy u v : Z) := same_sign dx u /\ same_sign dy v /\
  2 ^ 62 * (cross u v dx dy * cross u v dx dy) +
  (dot u v u v - 2 ^ 60) * (dot u v u v - 2 ^ 60) * dot dx dy dx dy <= 255 * 2 ^ 58 * dot dx dy dx dy.
Definition eighths (h square e : Z) := e * e * square <= 64 * (h * h).
Definition eighths_apart (e x y : Z) := 64 * (x * x + y * y) <= (e + 16) * (e + 16) /\
  (15 < e -> (e - 15) * (e - 15) <= 64 * (x * x + y * y)).
Definition as_far (h square r x y : Z) := exists e,
  0 <= e /\ eighths h square e /\ ~ eighths h square (e + 1) /\ eighths_apart (e - 8 * r) x y.
Definition measured (r distance count : Z) (i j k l : nat) (u v saturated gx gy : Z) := exists dx dy h,
  feature count i j k l dx dy h /\ line_measures r distance dx dy h /\ along_unit dx dy u v /\
  (saturated = 0 -> as_far (- h) (dot dx dy dx dy) r gx gy).

(* s is at most t times the root of n. *)
Definition at_most_root (s t n : Z) := (0 <= t /\ (s <= 0 \/ s * s <= t * t * n)) \/ (t < 0 /\ s < 0 /\ t * t * n <= s * s).
Definition enough (r depth u v : Z) := exists dx dy h, 0 < dot dx dy dx dy /\ behind dx dy h /\
  at_most_root h (depth - r) (dot dx dy dx dy) /\ along_unit dx dy u v.
Definition cleared (h r square : Z) := 0 <= h /\ r * r * square <= h * h.
Definition moves (dx dy h r tx ty : Z) := cleared (dot dx dy tx ty - h) r (dot dx dy dx dy).
Definition beside_vertex (n : nat) (vx vy : nat -> Z) (x y r : Z) := exists i, (i < n)%nat /\ near_point (x + vx i) (y + vy i) r.
Definition beside_edge (n : nat) (vx vy : nat -> Z) (x y r : Z) := exists i k, (i < n)%nat /\ (k < n)%nat /\
  foot (x + vx i) (y + vy i) (x + vx k) (y + vy k) /\ near_line (x + vx i) (y + vy i) (x + vx k) (y + vy k) r.
Definition parted (r tx ty : Z) := exists dx dy h, 0 < dot dx dy dx dy /\ behind dx dy h /\ moves dx dy h r tx ty.
Definition steps (t depth u : Z) := (0 <= u -> 2 ^ 30 * (t - 1) < depth * u <= 2 ^ 30 * t) /\
  (u < 0 -> 2 ^ 30 * t <= depth * u < 2 ^ 30 * (t + 1)).
Definition half_off (depth u g : Z) := (2 ^ 30 * g - depth * u + 1) / 2.
Definition overlap (depth u v gx gy : Z) :=
  half_off depth u gx * half_off depth u gx + half_off depth v gy * half_off depth v gy <=
  (3 * 2 ^ 29 + 2 * depth) * (3 * 2 ^ 29 + 2 * depth).
Definition stays_off (x tx r : Z) := (x > r /\ x - tx > r) \/ (x < - r /\ x - tx < - r).
Definition foot_off (x y tx ty r : Z) :=
  dot tx ty x y <= 0 \/ dot tx ty tx ty <= dot tx ty x y \/ farther (cross tx ty x y) r (dot tx ty tx ty).
Definition circles_pass (tx ty r : Z) := stays_off x tx r \/ stays_off y ty r \/
  (x * x + y * y > r * r /\ (x - tx) * (x - tx) + (y - ty) * (y - ty) > r * r /\ foot_off x y tx ty r).
Definition passing (tx ty r : Z) := exists dx dy h, behind dx dy h /\ clear dx dy h r /\ clear dx dy (h - dot dx dy tx ty) r.
Definition portion (num den f : Z) := f * den <= 2 ^ 30 * num < (f + 1) * den.
Definition entered_by (tx ty px py qx qy dx dy h f : Z) := dot dx dy tx ty <= h < 0 /\ dot dx dy px py = h /\
  dot dx dy qx qy = h /\ cross tx ty px py <= 0 <= cross tx ty qx qy /\ portion (- h) (- dot dx dy tx ty) f.
Definition entering (tx ty f : Z) := exists i j k l px py qx qy dx dy h,
  named i j px py /\ named k l qx qy /\ behind dx dy h /\ entered_by tx ty px py qx qy dx dy h f.
Definition moved (r depth u v : Z) := exists tx ty, steps tx depth u /\ steps ty depth v /\ parted r tx ty.

Open Scope R_scope.

(* The sum of f 0 to f (n - 1). A point of a hull is a mean of vertices with weights. *)
Fixpoint sum (n : nat) (f : nat -> R) := match n with O => 0 | S m => sum m f + f m end.
Definition in_hull (n : nat) (vx vy : nat -> Z) (u v : R) := exists w : nat -> R,
  (forall i, (i < n)%nat -> 0 <= w i) /\ sum n w = 1 /\
  u = sum n (fun i => w i * IZR (vx i)) /\ v = sum n (fun i => w i * IZR (vy i)).
(* A shape: all points within a radius of its hull. *)
Definition in_shape (n : nat) (vx vy : nat -> Z) (cx cy r u v : R) := exists s t,
  in_hull n vx vy s t /\ (u - cx - s) * (u - cx - s) + (v - cy - t) * (v - cy - t) <= r * r.
Definition square_apart (u v s t : R) := (u - s) * (u - s) + (v - t) * (v - t).

Lemma sum_ext n f g : (forall i, (i < n)%nat -> f i = g i) -> sum n f = sum n g.
Proof. induction n; simpl; intros H; [lra | rewrite IHn, H; auto with arith]. Qed.

Lemma sum_combine n a b c f g h :
  sum n (fun i => a * f i + b * g i + c * h i) = a * sum n f + b * sum n g + c * sum n h.
Proof. induction n; simpl; [lra | rewrite IHn; lra]. Qed.

Lemma mean_below n w f c : (forall i, (i < n)%nat -> 0 <= w i) -> (forall i, (i < n)%nat -> f i < c) ->
  sum n (fun i => w i * f i) <= c * sum n w /\ (0 < sum n w -> sum n (fun i => w i * f i) < c * sum n w).
Proof.
  intros W F. induction n; simpl; [lra |].
  destruct IHn as [A B]; auto with arith.
  assert (0 <= w n) by auto with arith. assert (f n < c) by auto with arith.
  assert (w n * f n <= w n * c) by nra. split; [lra |].
  intros P. destruct (Rtotal_order 0 (sum n w)) as [L | [E | G]].
  - specialize (B L). nra.
  - assert (0 < w n) by lra. nra.
  - assert (0 <= sum n w); [| lra].
    clear - W. induction n; simpl; [lra |]. assert (0 <= w n) by auto with arith.
    assert (0 <= sum n w) by (apply IHn; auto with arith). lra.
Qed.

(* A functional that is below c at every vertex is below c at every point. *)
Lemma hull_below n vx vy u v dx dy c : in_hull n vx vy u v ->
  (forall i, (i < n)%nat -> dx * IZR (vx i) + dy * IZR (vy i) < c) -> dx * u + dy * v < c.
Proof.
  intros (w & W & One & -> & ->) F.
  destruct (mean_below n w (fun i => dx * IZR (vx i) + dy * IZR (vy i)) c W F) as [_ B].
  rewrite One in B. specialize (B ltac:(lra)).
  rewrite (sum_ext n _ (fun i => dx * (w i * IZR (vx i)) + dy * (w i * IZR (vy i)) + 0 * w i)) in B
    by (intros; lra).
  rewrite sum_combine in B. lra.
Qed.

Lemma hull_mean n vx vy a b c p q r s t u : 0 <= a -> 0 <= b -> 0 <= c -> a + b + c = 1 ->
  in_hull n vx vy p q -> in_hull n vx vy r s -> in_hull n vx vy t u ->
  in_hull n vx vy (a * p + b * r + c * t) (a * q + b * s + c * u).
Proof.
  intros A B C One (w1 & W1 & O1 & -> & ->) (w2 & W2 & O2 & -> & ->) (w3 & W3 & O3 & -> & ->).
  exists (fun i => a * w1 i + b * w2 i + c * w3 i). repeat split.
  - intros i I. specialize (W1 i I). specialize (W2 i I). specialize (W3 i I). nra.
  - rewrite sum_combine. rewrite O1, O2, O3. lra.
  - rewrite <- sum_combine. apply sum_ext. intros. lra.
  - rewrite <- sum_combine. apply sum_ext. intros. lra.
Qed.

Lemma sum_single n k f : (k < n)%nat -> sum n (fun i => (if Nat.eqb i k then 1 else 0) * f i) = f k.
Proof.
  assert (Z : forall m, (m <= k)%nat -> sum m (fun i => (if Nat.eqb i k then 1 else 0) * f i) = 0).
  { induction m; simpl; intros; [lra |]. rewrite IHm by lia.
    replace (Nat.eqb m k) with false by (symmetry; apply Nat.eqb_neq; lia). lra. }
  induction n; simpl; intros L; [lia |]. destruct (Nat.eq_dec n k) as [-> | N].
  - rewrite Z, Nat.eqb_refl by lia. lra.
  - rewrite IHn by lia. replace (Nat.eqb n k) with false by (symmetry; apply Nat.eqb_neq; lia). lra.
Qed.

Lemma hull_vertex n vx vy k : (k < n)%nat -> in_hull n vx vy (IZR (vx k)) (IZR (vy k)).
Proof.
  intros L. exists (fun i => if Nat.eqb i k then 1 else 0). repeat split.
  - intros. destruct (Nat.eqb i k); lra.
  - rewrite (sum_ext n _ (fun i => (if Nat.eqb i k then 1 else 0) * 1)) by (intros; lra).
    apply (sum_single n k (fun _ => 1) L).
  - symmetry. apply (sum_single n k (fun i => IZR (vx i)) L).
  - symmetry. apply (sum_single n k (fun i => IZR (vy i)) L).
Qed.

(* A vector of length l at most r long along another. *)
Lemma cauchy l r dx dy u v : 0 <= l -> 0 <= r -> dx * dx + dy * dy = l * l -> u * u + v * v <= r * r ->
  dx * u + dy * v <= l * r.
Proof.
  intros L R D E. destruct (Rle_lt_dec (dx * u + dy * v) (l * r)) as [| G]; [assumption | exfalso].
  assert (0 <= l * r) by (apply Rmult_le_pos; assumption).
  assert (A : (l * r) * (l * r) < (dx * u + dy * v) * (dx * u + dy * v)) by (apply Rmult_le_0_lt_compat; assumption).
  assert (B : (dx * u + dy * v) * (dx * u + dy * v) <= (dx * dx + dy * dy) * (u * u + v * v)).
  { pose proof (Rle_0_sqr (dx * v - dy * u)) as S. unfold Rsqr in S. lra. }
  rewrite D in B. assert (C : (l * l) * (u * u + v * v) <= (l * l) * (r * r))
    by (apply Rmult_le_compat_l; [apply Rle_0_sqr | exact E]).
  lra.
Qed.

Variables (ra rb d : Z) (cx cy : Z).  (* both convex radii, the distance asked about, and the centre of B *)
Hypothesis radii : (0 <= ra /\ 0 <= rb /\ 0 <= d)%Z.

Definition in_a := in_shape na ax ay (IZR (cx + x)) (IZR (cy + y)) (IZR ra).
Definition in_b := in_shape nb bx bl (IZR cx) (IZR cy) (IZR rb).

(* `no`: every point of A is more than the distance away from every point of B. *)
Theorem apart : separated_by (ra + rb + d) -> forall u v s t, in_a u v -> in_b s t ->
  square_apart u v s t > IZR d * IZR d.
Proof.
  intros (dx & dy & H) u v s t (p & q & P & E) (p' & q' & P' & E').
  destruct radii as (RA & RB & D). apply IZR_le in RA, RB, D.
  set (l := sqrt (IZR dx * IZR dx + IZR dy * IZR dy)).
  assert (L : 0 <= l) by apply sqrt_pos.
  assert (LL : IZR dx * IZR dx + IZR dy * IZR dy = l * l) by (symmetry; apply sqrt_sqrt; nra).
  assert (V : forall i j, (i < na)%nat -> (j < nb)%nat ->
    IZR dx * IZR (ax i) + IZR dy * IZR (ay i) <
    - (IZR (ra + rb + d) * l) - IZR dx * IZR x - IZR dy * IZR y + IZR dx * IZR (bx j) + IZR dy * IZR (bl j)).
  { intros i j I J. destruct (H i j I J) as [B F]. unfold farther, dot in *.
    apply IZR_lt in B. apply Z.gt_lt, IZR_lt in F.
    repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR, ?opp_IZR in *. rewrite LL in F.
    set (h := IZR dx * (IZR x + IZR (ax i) - IZR (bx j)) + IZR dy * (IZR y + IZR (ay i) - IZR (bl j))) in *.
    set (r := IZR ra + IZR rb + IZR d) in *.
    assert (r * l < - h); [| unfold h in *; lra].
    destruct (Rlt_le_dec (r * l) (- h)) as [| G]; [assumption |].
    assert (- h * - h <= (r * l) * (r * l)) by nra. nra. }
  assert (V' : forall j, (j < nb)%nat -> - IZR dx * IZR (bx j) + - IZR dy * IZR (bl j) <
    - (IZR (ra + rb + d) * l) - IZR dx * IZR x - IZR dy * IZR y - IZR dx * p - IZR dy * q).
  { intros j J. pose proof (hull_below na ax ay p q _ _ _ P (fun i I => V i j I J)). lra. }
  pose proof (hull_below nb bx bl p' q' _ _ _ P' V') as W.
  rewrite !plus_IZR in *.
  pose proof (cauchy l (IZR ra) (IZR dx) (IZR dy) _ _ L RA LL E) as A.
  assert (E2 : (- (s - IZR cx - p')) * (- (s - IZR cx - p')) + (- (t - IZR cy - q')) * (- (t - IZR cy - q')) <=
    IZR rb * IZR rb) by nra.
  pose proof (cauchy l (IZR rb) (IZR dx) (IZR dy) _ _ L RB LL E2) as B.
  unfold square_apart. apply Rnot_le_gt. intros C.
  assert (C2 : (- (u - s)) * (- (u - s)) + (- (v - t)) * (- (v - t)) <= IZR d * IZR d) by nra.
  pose proof (cauchy l (IZR d) (IZR dx) (IZR dy) _ _ L D LL C2). nra.
Qed.

(* A point of A - B, without the radii. *)
Definition in_difference (u v : R) := exists p q s t, in_hull na ax ay p q /\ in_hull nb bx bl s t /\
  u = IZR x + p - s /\ v = IZR y + q - t.

Lemma named_in i j px py : named i j px py -> in_difference (IZR px) (IZR py).
Proof.
  intros (I & J & -> & ->). exists (IZR (ax i)), (IZR (ay i)), (IZR (bx j)), (IZR (bl j)).
  rewrite !minus_IZR, !plus_IZR. repeat split; auto using hull_vertex.
Qed.

Lemma difference_mean a b c p q r s t u : 0 <= a -> 0 <= b -> 0 <= c -> a + b + c = 1 ->
  in_difference p q -> in_difference r s -> in_difference t u ->
  in_difference (a * p + b * r + c * t) (a * q + b * s + c * u).
Proof.
  intros A B C One (p1 & q1 & s1 & t1 & H1 & G1 & -> & ->) (p2 & q2 & s2 & t2 & H2 & G2 & -> & ->)
    (p3 & q3 & s3 & t3 & H3 & G3 & -> & ->).
  exists (a * p1 + b * p2 + c * p3), (a * q1 + b * q2 + c * q3), (a * s1 + b * s2 + c * s3), (a * t1 + b * t2 + c * t3).
  split; [apply hull_mean; assumption |]. split; [apply hull_mean; assumption |].
  replace c with (1 - a - b) by lra. split; ring.
Qed.

Definition touch := exists u v s t, in_a u v /\ in_b s t /\ square_apart u v s t <= IZR d * IZR d.

Lemma difference_near u v r : (0 <= r <= ra + rb + d)%Z -> in_difference u v -> u * u + v * v <= IZR r * IZR r -> touch.
Proof.
  intros (R0 & R1) (p & q & s & t & P & Q & U & V) N.
  destruct radii as (RA & RB & D). apply IZR_le in RA, RB, D, R0, R1. rewrite !plus_IZR in R1.
  set (m := IZR ra + IZR rb + IZR d) in *.
  assert (M : u * u + v * v <= m * m) by nra.
  destruct (Req_dec m 0) as [Z | NZ].
  - assert (U0 : u * u + v * v = 0) by
      (pose proof (Rle_0_sqr u); pose proof (Rle_0_sqr v); unfold Rsqr in *; rewrite Z in M; lra).
    assert (u = 0) by (apply Rplus_sqr_eq_0_l with v; exact U0).
    assert (v = 0) by (apply Rplus_sqr_eq_0_l with u; rewrite Rplus_comm; exact U0).
    exists (IZR (cx + x) + p), (IZR (cy + y) + q), (IZR cx + s), (IZR cy + t).
    split; [exists p, q; split; [exact P | nra] |]. split; [exists s, t; split; [exact Q | nra] |].
    unfold square_apart. rewrite !plus_IZR.
    replace (IZR cx + IZR x + p - (IZR cx + s)) with u by lra.
    replace (IZR cy + IZR y + q - (IZR cy + t)) with v by lra. nra.
  - assert (0 < m) by (unfold m in *; lra). set (k := / m). assert (K : k * m = 1) by (apply Rinv_l; exact NZ).
    assert (0 < k) by (apply Rinv_0_lt_compat; assumption).
    assert (S : (k * u) * (k * u) + (k * v) * (k * v) <= 1).
    { replace ((k * u) * (k * u) + (k * v) * (k * v)) with ((k * k) * (u * u + v * v)) by ring.
      replace 1 with ((k * k) * (m * m)) by (replace ((k * k) * (m * m)) with ((k * m) * (k * m)) by ring; rewrite K; ring).
      apply Rmult_le_compat_l; [apply Rle_0_sqr | exact M]. }
    assert (scaled : forall e, 0 <= e -> (e * (k * u)) * (e * (k * u)) + (e * (k * v)) * (e * (k * v)) <= e * e).
    { intros e G. replace ((e * (k * u)) * (e * (k * u)) + (e * (k * v)) * (e * (k * v)))
        with ((e * e) * ((k * u) * (k * u) + (k * v) * (k * v))) by ring.
      rewrite <- (Rmult_1_r (e * e)) at 2. apply Rmult_le_compat_l; [apply Rle_0_sqr | exact S]. }
    exists (IZR (cx + x) + p - IZR ra * (k * u)), (IZR (cy + y) + q - IZR ra * (k * v)),
      (IZR cx + s + IZR rb * (k * u)), (IZR cy + t + IZR rb * (k * v)).
    split; [exists p, q; split; [exact P | pose proof (scaled _ RA); lra] |].
    split; [exists s, t; split; [exact Q | pose proof (scaled _ RB); lra] |].
    unfold square_apart. rewrite !plus_IZR.
    replace (IZR cx + IZR x + p - IZR ra * (k * u) - (IZR cx + s + IZR rb * (k * u))) with (IZR d * (k * u)).
    2: { assert (u = k * m * u) by (rewrite K; lra). unfold m in *. lra. }
    replace (IZR cy + IZR y + q - IZR ra * (k * v) - (IZR cy + t + IZR rb * (k * v))) with (IZR d * (k * v)).
    2: { assert (v = k * m * v) by (rewrite K; lra). unfold m in *. lra. }
    apply scaled. exact D.
Qed.

(* A point between two named vertices. *)
Lemma between_near p q u v r k : (0 <= r <= ra + rb + d)%Z -> in_difference p q -> in_difference u v -> 0 <= k <= 1 ->
  (p + k * (u - p)) * (p + k * (u - p)) + (q + k * (v - q)) * (q + k * (v - q)) <= IZR r * IZR r -> touch.
Proof.
  intros R P U K N. apply (difference_near ((1 - k) * p + k * u + 0 * u) ((1 - k) * q + k * v + 0 * v) r R).
  - apply difference_mean; auto; lra.
  - replace ((1 - k) * p + k * u + 0 * u) with (p + k * (u - p)) by ring.
    replace ((1 - k) * q + k * v + 0 * v) with (q + k * (v - q)) by ring. exact N.
Qed.

Lemma segment_near p q u v : in_difference p q -> in_difference u v ->
  p * v - q * u = 0 -> p * u + q * v <= 0 -> touch.
Proof.
  intros P U C D. set (e := (u - p) * (u - p) + (v - q) * (v - q)).
  assert (Z : (0 <= 0 <= ra + rb + d)%Z) by lia.
  destruct (Req_dec e 0) as [E | E].
  - assert (u - p = 0) by (apply Rplus_sqr_eq_0_l with (v - q); exact E).
    assert (v - q = 0) by (apply Rplus_sqr_eq_0_l with (u - p); rewrite Rplus_comm; exact E).
    replace u with p in * by lra. replace v with q in * by lra.
    apply (between_near p q p q 0 0 Z P P); lra.
  - assert (0 < e) by (pose proof (Rle_0_sqr (u - p)); pose proof (Rle_0_sqr (v - q)); unfold Rsqr, e in *; lra).
    set (k := (p * p + q * q - (p * u + q * v)) / e).
    assert (K : k * e = p * p + q * q - (p * u + q * v)) by (unfold k; field; exact E).
    assert (0 <= k <= 1) by (split; unfold e in *; nra).
    apply (between_near p q u v 0 k Z P U); [assumption |].
    assert (A : e * (p + k * (u - p)) = 0).
    { replace (e * (p + k * (u - p))) with (e * p + (k * e) * (u - p)) by ring. rewrite K. unfold e.
      replace (((u - p) * (u - p) + (v - q) * (v - q)) * p + (p * p + q * q - (p * u + q * v)) * (u - p))
        with ((p * v - q * u) * (v - q)) by ring. rewrite C. ring. }
    assert (B : e * (q + k * (v - q)) = 0).
    { replace (e * (q + k * (v - q))) with (e * q + (k * e) * (v - q)) by ring. rewrite K. unfold e.
      replace (((u - p) * (u - p) + (v - q) * (v - q)) * q + (p * p + q * q - (p * u + q * v)) * (v - q))
        with (- (p * v - q * u) * (u - p)) by ring. rewrite C. ring. }
    apply Rmult_integral in A, B. destruct A as [A | A]; [lra |]. destruct B as [B | B]; [lra |].
    rewrite A, B. lra.
Qed.

Lemma triangle_near p q u v s t : in_difference p q -> in_difference u v -> in_difference s t ->
  0 < p * v - q * u -> 0 < u * t - v * s -> 0 < s * q - t * p -> touch.
Proof.
  intros P U S A B C. set (m := p * v - q * u + (u * t - v * s) + (s * q - t * p)).
  assert (M : 0 < m) by (unfold m; lra). set (k := / m).
  assert (K : k * m = 1) by (apply Rinv_l; lra). assert (0 < k) by (apply Rinv_0_lt_compat; exact M).
  assert (Z : (0 <= 0 <= ra + rb + d)%Z) by lia.
  apply (difference_near (k * (u * t - v * s) * p + k * (s * q - t * p) * u + k * (p * v - q * u) * s)
    (k * (u * t - v * s) * q + k * (s * q - t * p) * v + k * (p * v - q * u) * t) 0 Z).
  - apply difference_mean; auto; try nra. rewrite <- K. unfold m. ring.
  - replace (k * (u * t - v * s) * p + k * (s * q - t * p) * u + k * (p * v - q * u) * s) with 0 by ring.
    replace (k * (u * t - v * s) * q + k * (s * q - t * p) * v + k * (p * v - q * u) * t) with 0 by ring. lra.
Qed.

(* The foot of the origin on an edge, if it lies within, is where the edge is nearest. *)
Lemma foot_near p q u v r : p * (u - p) + q * (v - q) < 0 -> 0 < u * (u - p) + v * (v - q) ->
  (p * v - q * u) * (p * v - q * u) <= r * r * ((u - p) * (u - p) + (v - q) * (v - q)) -> exists h, 0 <= h <= 1 /\
  (p + h * (u - p)) * (p + h * (u - p)) + (q + h * (v - q)) * (q + h * (v - q)) <= r * r.
Proof.
  intros F G N. set (e := (u - p) * (u - p) + (v - q) * (v - q)) in *. set (f := p * (u - p) + q * (v - q)) in *.
  assert (E : 0 < e) by (unfold e, f in *; lra).
  set (h := - f / e). assert (K : h * e = - f) by (unfold h; field; lra).
  exists h. split; [split; unfold e, f in *; nra |].
  apply Rmult_le_reg_l with (r := e); [exact E |].
  replace (e * ((p + h * (u - p)) * (p + h * (u - p)) + (q + h * (v - q)) * (q + h * (v - q))))
    with (e * (p * p + q * q) + 2 * (h * e) * f + (h * e) * (h * e)) by (unfold e, f; ring).
  rewrite K.
  replace (e * (p * p + q * q) + 2 * - f * f + - f * - f) with ((p * v - q * u) * (p * v - q * u))
    by (unfold e, f; ring). lra.
Qed.

(* `yes`: some points of A and of B are at most the distance apart. r is what the checker makes of the radius. *)
Theorem together r : (0 <= r <= ra + rb + d)%Z -> enclosing \/ near_vertex r \/ near_edge r -> touch.
Proof.
  intros R [H | [H | H]].
  - destruct H as (i & j & k & l & m & n & px & py & qx & qy & rx & ry & P & Q & S & T).
    apply named_in in P, Q, S.
    assert (segment : forall u v s t, in_difference (IZR u) (IZR v) -> in_difference (IZR s) (IZR t) ->
      on_segment u v s t -> touch).
    { intros u v s t U V (C & D). apply (segment_near (IZR u) (IZR v) (IZR s) (IZR t) U V).
      - rewrite <- !mult_IZR, <- minus_IZR. apply (f_equal IZR) in C. exact C.
      - rewrite <- !mult_IZR, <- plus_IZR. apply IZR_le in D. exact D. }
    destruct T as [T | [T | [T | [(A & B & C) | (A & B & C)]]]]; eauto.
    + unfold cross in *. apply Z.gt_lt, IZR_lt in A, B, C. rewrite !minus_IZR, !mult_IZR in *.
      apply (triangle_near _ _ _ _ _ _ P Q S); lra.
    + unfold cross in *. apply IZR_lt in A, B, C. rewrite !minus_IZR, !mult_IZR in *.
      apply (triangle_near _ _ _ _ _ _ P S Q); lra.
  - destruct H as (i & j & px & py & P & N). apply named_in in P.
    apply (difference_near _ _ r R P). unfold near_point in N. apply IZR_le in N.
    rewrite plus_IZR, !mult_IZR in N. exact N.
  - destruct H as (i & j & k & l & px & py & qx & qy & P & Q & (F & G) & N). apply named_in in P, Q.
    unfold near_line, dot, cross in *. apply IZR_le in N. apply IZR_lt in F. apply Z.gt_lt, IZR_lt in G.
    repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR in *.
    destruct (foot_near (IZR px) (IZR py) (IZR qx) (IZR qy) (IZR r) F G N) as (h & H & D).
    exact (between_near _ _ _ _ r h R P Q H D).
Qed.

(* A shape whose vertices are at most c from its centre lies within c and its radius r of it. *)
Lemma round_below n vx vy x0 y0 r c dx dy l u v : (0 <= c)%Z -> (0 <= r)%Z ->
  (forall i, (i < n)%nat -> vx i * vx i + vy i * vy i <= c * c)%Z -> in_shape n vx vy x0 y0 (IZR r) u v -> 0 <= l ->
  dx * dx + dy * dy = l * l -> dx * (u - x0) + dy * (v - y0) <= l * (IZR c + IZR r).
Proof.
  intros C R H (p & q & P & E) L LL. apply IZR_le in C, R.
  assert (V : dx * p + dy * q <= l * IZR c).
  { apply le_epsilon. intros e G. apply Rlt_le. apply (hull_below n vx vy p q _ _ _ P). intros k K. specialize (H k K).
    apply IZR_le in H. repeat rewrite ?mult_IZR, ?plus_IZR in H.
    pose proof (cauchy l (IZR c) dx dy _ _ L C LL H). lra. }
  pose proof (cauchy l (IZR r) dx dy _ _ L R LL E) as A. lra.
Qed.

(* B moved by (px, py): the circles are apart. *)
Lemma centres_apart ca cb px py : (0 <= ca /\ 0 <= cb)%Z ->
  (forall i, (i < na)%nat -> ax i * ax i + ay i * ay i <= ca * ca)%Z ->
  (forall j, (j < nb)%nat -> bx j * bx j + bl j * bl j <= cb * cb)%Z ->
  IZR (ca + cb + (ra + rb + d)) * IZR (ca + cb + (ra + rb + d)) <
    (IZR x - px) * (IZR x - px) + (IZR y - py) * (IZR y - py) ->
  forall u v s t, in_a u v -> in_b s t -> square_apart u v (s + px) (t + py) > IZR d * IZR d.
Proof.
  intros (CA & CB) HA HB F u v s t PA PB. destruct radii as (RA & RB & D).
  set (X := IZR x - px) in *. set (Y := IZR y - py) in *.
  set (l := sqrt (X * X + Y * Y)). assert (L : 0 <= l) by apply sqrt_pos.
  assert (Q : 0 <= X * X + Y * Y) by (pose proof (Rle_0_sqr X); pose proof (Rle_0_sqr Y); unfold Rsqr in *; lra).
  assert (LL : X * X + Y * Y = l * l) by (symmetry; apply sqrt_sqrt; exact Q).
  assert (LN : - X * - X + - Y * - Y = l * l) by lra.
  pose proof (round_below na ax ay _ _ ra ca (- X) (- Y) l u v CA RA HA PA L LN) as A.
  pose proof (round_below nb bx bl _ _ rb cb X Y l s t CB RB HB PB L LL) as B.
  apply IZR_le in D, CA, CB, RA, RB. repeat rewrite plus_IZR in *. rewrite LL in F.
  set (m := IZR ca + IZR cb + (IZR ra + IZR rb + IZR d)) in *.
  assert (M : m < l) by (apply Rnot_le_lt; intros G; pose proof (Rmult_le_compat _ _ _ _ L L G G); lra).
  apply Rnot_le_gt. intros C. unfold square_apart in C.
  pose proof (cauchy l (IZR d) X Y _ _ L D LL C) as W.
  assert (l * m < l * l) by (apply Rmult_lt_compat_l; [unfold m in *; lra | exact M]).
  assert (X * (IZR x - px) + Y * (IZR y - py) = l * l) by (unfold X, Y in *; lra). unfold m in *. lra.
Qed.

(* The circles: no vertex is farther than its core's radius from its centre. *)
Theorem circles_apart (ca cb : Z) : (0 <= ca /\ 0 <= cb)%Z ->
  (forall i, (i < na)%nat -> ax i * ax i + ay i * ay i <= ca * ca)%Z ->
  (forall j, (j < nb)%nat -> bx j * bx j + bl j * bl j <= cb * cb)%Z ->
  (x * x + y * y > (ca + cb + (ra + rb + d)) * (ca + cb + (ra + rb + d)))%Z ->
  forall u v s t, in_a u v -> in_b s t -> square_apart u v s t > IZR d * IZR d.
Proof.
  intros C HA HB F u v s t PA PB. apply Z.gt_lt, IZR_lt in F. repeat rewrite ?mult_IZR, ?(plus_IZR (x * x)) in F.
  pose proof (centres_apart ca cb 0 0 C HA HB ltac:(lra) u v s t PA PB) as W.
  replace (s + 0) with s in W by lra. replace (t + 0) with t in W by lra. exact W.
Qed.

(* A point of A - B at length m from the origin, with the radii taken off. *)
Lemma difference_exact u v m : in_difference u v -> u * u + v * v = m * m -> 0 < m -> IZR ra + IZR rb <= m ->
  exists e f s t, in_a e f /\ in_b s t /\ s - e = (m - IZR ra - IZR rb) * (- / m * u) /\ t - f = (m - IZR ra - IZR rb) * (- / m * v).
Proof.
  intros (p & q & s & t & P & Q & U & V) N M0 M.
  destruct radii as (RA & RB & D). apply IZR_le in RA, RB, D.
  set (k := / m). assert (K : k * m = 1) by (apply Rinv_l; lra).
  assert (S : (k * u) * (k * u) + (k * v) * (k * v) = 1).
  { replace ((k * u) * (k * u) + (k * v) * (k * v)) with ((k * k) * (u * u + v * v)) by ring. rewrite N.
    replace ((k * k) * (m * m)) with ((k * m) * (k * m)) by ring. rewrite K. ring. }
  assert (scaled : forall e, (e * (k * u)) * (e * (k * u)) + (e * (k * v)) * (e * (k * v)) = e * e).
  { intros e. replace ((e * (k * u)) * (e * (k * u)) + (e * (k * v)) * (e * (k * v)))
      with ((e * e) * ((k * u) * (k * u) + (k * v) * (k * v))) by ring. rewrite S. ring. }
  exists (IZR (cx + x) + p - IZR ra * (k * u)), (IZR (cy + y) + q - IZR ra * (k * v)),
    (IZR cx + s + IZR rb * (k * u)), (IZR cy + t + IZR rb * (k * v)).
  split; [exists p, q; split; [exact P | pose proof (scaled (IZR ra)); lra] |].
  split; [exists s, t; split; [exact Q | pose proof (scaled (IZR rb)); lra] |].
  rewrite !plus_IZR. assert (u = k * m * u) by (rewrite K; lra). assert (v = k * m * v) by (rewrite K; lra). fold k.
  split; lra.
Qed.

Lemma square_less a b : 0 <= b -> a * a < b * b -> a < b.
Proof. intros B H. apply Rnot_le_lt. intros C. pose proof (Rmult_le_compat b a b a B B C C). lra. Qed.

(* The feature has a point |h| / |d| from the origin. *)
Lemma feature_point count i j k m dx dy h l : feature count i j k m dx dy h -> (h < 0)%Z -> 0 < l ->
  IZR dx * IZR dx + IZR dy * IZR dy = l * l -> exists u v, in_difference u v /\ u * u + v * v = (- IZR h / l) * (- IZR h / l).
Proof.
  intros F H L LL. assert (scale : forall w, w * (l * l) = IZR h * IZR h -> w = (- IZR h / l) * (- IZR h / l)).
  { intros w W. replace ((- IZR h / l) * (- IZR h / l)) with (IZR h * IZR h / (l * l)) by (field; lra).
    rewrite <- W. field. lra. }
  destruct F as (I & J & V & E). pose (px := (x + ax i - bx j)%Z). pose (py := (y + ay i - bl j)%Z).
  assert (P : named i j px py) by (repeat split; assumption). apply named_in in P.
  destruct (Z.eq_dec count 1) as [one | edge].
  - destruct (V one) as (-> & -> & ->). fold px py in LL, scale |- *. clearbody px py. exists (IZR px), (IZR py). split; [exact P |]. apply scale. unfold dot.
    rewrite <- LL. rewrite !opp_IZR, plus_IZR, !mult_IZR. ring.
  - destruct (E edge) as (KA & MB & (F & G) & -> & -> & ->).
    pose (qx := (x + ax k - bx m)%Z). pose (qy := (y + ay k - bl m)%Z).
    assert (Q : named k m qx qy) by (repeat split; assumption). apply named_in in Q. fold px py qx qy in F, G, LL, scale |- *.
    clearbody px py qx qy. clear V E.
    unfold dot, cross in *. apply IZR_lt in F. apply Z.gt_lt, IZR_lt in G.
    repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR, ?opp_IZR in *.
    set (p := IZR px) in *. set (q := IZR py) in *. set (u := IZR qx) in *. set (v := IZR qy) in *.
    set (f := p * (u - p) + q * (v - q)) in *.
    assert (E : (u - p) * (u - p) + (v - q) * (v - q) = l * l) by (rewrite <- LL; ring).
    set (e := l * l) in *. assert (0 < e) by (apply Rmult_lt_0_compat; exact L).
    set (r := - f / e). assert (K : r * e = - f) by (unfold r; field; lra).
    assert (0 <= r <= 1) by (split; unfold f in *; nra).
    exists ((1 - r) * p + r * u + 0 * u), ((1 - r) * q + r * v + 0 * v). split.
    + apply difference_mean; auto; lra.
    + apply scale. replace (((1 - r) * p + r * u + 0 * u) * ((1 - r) * p + r * u + 0 * u) +
        ((1 - r) * q + r * v + 0 * v) * ((1 - r) * q + r * v + 0 * v))
        with (p * p + q * q + 2 * r * f + r * r * ((u - p) * (u - p) + (v - q) * (v - q))) by (unfold f; ring).
      rewrite E. replace ((p * p + q * q + 2 * r * f + r * r * e) * e)
        with (e * (p * p + q * q) + 2 * (r * e) * f + (r * e) * (r * e)) by ring.
      rewrite K. rewrite <- E. unfold f. ring.
Qed.

(* No point of A - B without the radii lies beyond the line that no vertex is beyond. *)
Lemma behind_all dx dy h p q p' q' : behind dx dy h -> in_hull na ax ay p q -> in_hull nb bx bl p' q' ->
  IZR dx * (IZR x + p - p') + IZR dy * (IZR y + q - q') <= IZR h.
Proof.
  intros B P P'. apply le_epsilon. intros e X. apply Rlt_le.
  assert (V : forall i j, (i < na)%nat -> (j < nb)%nat -> IZR dx * IZR (ax i) + IZR dy * IZR (ay i) <
    IZR h + e - IZR dx * IZR x - IZR dy * IZR y + IZR dx * IZR (bx j) + IZR dy * IZR (bl j)).
  { intros i j I J. specialize (B i j I J). unfold dot in B. apply IZR_le in B.
    repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR, ?opp_IZR in B. lra. }
  assert (Y : forall j, (j < nb)%nat -> - IZR dx * IZR (bx j) + - IZR dy * IZR (bl j) <
    IZR h + e - IZR dx * IZR x - IZR dy * IZR y - IZR dx * p - IZR dy * q).
  { intros j J. pose proof (hull_below na ax ay p q _ _ _ P (fun i I => V i j I J)). lra. }
  pose proof (hull_below nb bx bl p' q' _ _ _ P' Y). lra.
Qed.

(* Along a direction of length l the radii add at most that often to what points of the hulls are apart. *)
Lemma widened l dx dy h u v s t : 0 <= l -> IZR dx * IZR dx + IZR dy * IZR dy = l * l -> behind dx dy h -> in_a u v ->
  in_b s t -> IZR dx * (u - s) + IZR dy * (v - t) <= IZR h + l * (IZR ra + IZR rb).
Proof.
  intros L LL B (p & q & P & E) (p' & q' & P' & E'). destruct radii as (RA & RB & D). apply IZR_le in RA, RB.
  rewrite !plus_IZR in *. pose proof (behind_all dx dy h p q p' q' B P P') as V.
  pose proof (cauchy l (IZR ra) (IZR dx) (IZR dy) _ _ L RA LL E) as A1.
  assert (E2 : (- (s - IZR cx - p')) * (- (s - IZR cx - p')) + (- (t - IZR cy - q')) * (- (t - IZR cy - q')) <=
    IZR rb * IZR rb) by lra.
  pose proof (cauchy l (IZR rb) (IZR dx) (IZR dy) _ _ L RB LL E2) as A2. lra.
Qed.

(* A number c, the cosine times the length of a vector nearly 1 long, whose sine times its length is s. *)
Lemma unit_close k s t c : 0 < k <= 1 / 1024 -> 0 <= c -> t * t + s * s <= 255 / 256 * (k * k) -> c * c + s * s = 1 + 2 * t ->
  (c - 1) * (c - 1) + s * s <= k * k.
Proof.
  intros (K0 & K) C T N. pose proof (Rle_0_sqr t) as TT. pose proof (Rle_0_sqr s) as SS. unfold Rsqr in *.
  assert (KK : 0 < k * k) by (apply Rmult_lt_0_compat; exact K0).
  assert (T1 : - k <= t <= k).
  { split; apply Rnot_lt_le; intros X; [assert (Y : k < - t) by lra | assert (Y : k < t) by lra];
      pose proof (Rmult_le_0_lt_compat _ _ _ _ (Rlt_le _ _ K0) (Rlt_le _ _ K0) Y Y); lra. }
  assert (K3 : 0 < k * (k * k)) by (apply Rmult_lt_0_compat; assumption).
  assert (K4 : k * (k * k) <= 1 / 1024 * (k * k)) by (apply Rmult_le_compat_r; lra).
  assert (C1 : 1 - 2 * k <= c).
  { apply Rnot_lt_le. intros X. pose proof (Rmult_le_0_lt_compat _ _ _ _ C C X X) as Y.
    assert (k * k <= 1 / 1024 * k) by (apply Rmult_le_compat_r; lra). lra. }
  set (m := Rabs (c - 1)). set (a := Rabs t). assert (A : a * a = t * t) by (unfold a; rewrite <- Rabs_mult; apply Rabs_pos_eq; exact TT).
  assert (M : m * m = (c - 1) * (c - 1)) by (unfold m; rewrite <- Rabs_mult; apply Rabs_pos_eq; apply Rle_0_sqr).
  assert (A0 : 0 <= a) by apply Rabs_pos. assert (M0 : 0 <= m) by apply Rabs_pos.
  assert (A1 : a <= k) by (unfold a; apply Rabs_le; lra).
  assert (P : m * (2 - 2 * k) <= 2 * a + s * s).
  { apply Rle_trans with (m * (c + 1)); [apply Rmult_le_compat_l; lra |].
    replace (m * (c + 1)) with (Rabs (2 * t - s * s)).
    2: { unfold m. rewrite <- (Rabs_pos_eq (c + 1)) at 1 by lra. rewrite <- Rabs_mult. f_equal. lra. }
    unfold a. apply Rabs_le. pose proof (Rle_abs t). pose proof (Rle_abs (- t)). rewrite Rabs_Ropp in *. lra. }
  set (b := a + s * s / 2). assert (Q : m * (1 - k) <= b) by (unfold b; lra).
  assert (Q0 : 0 <= m * (1 - k)) by (apply Rmult_le_pos; lra).
  assert (R : (m * (1 - k)) * (m * (1 - k)) <= b * b) by (apply Rmult_le_compat; assumption).
  assert (S1 : s * s <= k * k) by lra.
  assert (S2 : a * (s * s) <= k * (k * k)) by (apply Rmult_le_compat; assumption).
  assert (S3 : (s * s) * (s * s) <= (k * k) * (k * k)) by (apply Rmult_le_compat; assumption).
  assert (S4 : (k * k) * (k * k) <= 1 / 1024 * (k * (k * k))).
  { replace ((k * k) * (k * k)) with (k * (k * (k * k))) by ring. apply Rmult_le_compat_r; lra. }
  assert (B : b * b <= t * t + 2 * (k * (k * k))).
  { unfold b. replace ((a + s * s / 2) * (a + s * s / 2)) with (a * a + a * (s * s) + (s * s) * (s * s) / 4) by field. lra. }
  assert (E : (1 - 2 * k) * (m * m) <= b * b).
  { apply Rle_trans with ((m * (1 - k)) * (m * (1 - k))); [| exact R].
    replace ((m * (1 - k)) * (m * (1 - k))) with ((1 - 2 * k) * (m * m) + (m * k) * (m * k)) by ring.
    pose proof (Rle_0_sqr (m * k)). unfold Rsqr in *. lra. }
  rewrite <- M. apply Rmult_le_reg_l with (1 - 2 * k); [lra |].
  assert (0 <= 2 * k * (s * s)) by (apply Rmult_le_pos; lra). lra.
Qed.

(* A normal of Q2.30 that the check takes is within 2^-28 of the direction. *)
Lemma unit_along dx dy u v l : along_unit dx dy u v -> 0 < l -> IZR dx * IZR dx + IZR dy * IZR dy = l * l ->
  (IZR u / 2 ^ 30 - IZR dx / l) * (IZR u / 2 ^ 30 - IZR dx / l) + (IZR v / 2 ^ 30 - IZR dy / l) * (IZR v / 2 ^ 30 - IZR dy / l) <=
  (1 / 2 ^ 28) * (1 / 2 ^ 28).
Proof.
  intros (SX & SY & H) L LL.
  assert (sign : forall a b, same_sign a b -> 0 <= IZR a * IZR b).
  { intros a b (Z & P & N). destruct (Z_dec a 0) as [[X | X] | X].
    - specialize (N X). apply IZR_lt in X. apply IZR_le in N. replace (IZR a * IZR b) with (- IZR a * - IZR b) by ring.
      apply Rmult_le_pos; lra.
    - specialize (P X). apply Z.gt_lt, IZR_lt in X. apply IZR_le in P. apply Rmult_le_pos; lra.
    - rewrite X. simpl. lra. }
  apply sign in SX, SY. clear sign. unfold cross, dot in H. apply IZR_le in H.
  repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR in H. rewrite LL in H.
  change (2 ^ 62)%Z with (2 ^ Z.of_nat 62)%Z in H. change (2 ^ 60)%Z with (2 ^ Z.of_nat 60)%Z in H.
  change (2 ^ 58)%Z with (2 ^ Z.of_nat 58)%Z in H. rewrite <- !pow_IZR in H.
  set (p := IZR u / 2 ^ 30). set (q := IZR v / 2 ^ 30). set (ex := IZR dx / l). set (ey := IZR dy / l).
  assert (U : IZR u = 2 ^ 30 * p) by (unfold p; field). assert (V : IZR v = 2 ^ 30 * q) by (unfold q; field).
  assert (X : IZR dx = l * ex) by (unfold ex; field; lra). assert (Y : IZR dy = l * ey) by (unfold ey; field; lra).
  rewrite U in H, SX. rewrite V in H, SY. rewrite X in H, SX. rewrite Y in H, SY.
  assert (E : ex * ex + ey * ey = 1).
  { apply Rmult_eq_reg_l with (l * l); [| apply Rgt_not_eq; apply Rmult_lt_0_compat; exact L].
    transitivity (IZR dx * IZR dx + IZR dy * IZR dy); [rewrite X, Y; ring | lra]. }
  clearbody p q ex ey. clear U V X Y LL.
  set (s := p * ey - q * ex). set (n := p * p + q * q). set (c := p * ex + q * ey).
  assert (C : 0 <= c).
  { apply Rmult_le_reg_l with (2 ^ 30 * l); [apply Rmult_lt_0_compat; [lra | exact L] |]. unfold c.
    replace (2 ^ 30 * l * (p * ex + q * ey)) with (l * ex * (2 ^ 30 * p) + l * ey * (2 ^ 30 * q)) by ring. lra. }
  assert (D : c * c + s * s = n).
  { unfold c, s, n. transitivity ((p * p + q * q) * (ex * ex + ey * ey)); [ring | rewrite E; ring]. }
  assert (G : 4 * (s * s) + (n - 1) * (n - 1) <= 255 / 2 ^ 62).
  { apply Rmult_le_reg_l with (2 ^ 120 * (l * l)).
    - apply Rmult_lt_0_compat; [lra | apply Rmult_lt_0_compat; exact L].
    - replace (2 ^ 120 * (l * l) * (255 / 2 ^ 62)) with (255 * 2 ^ 58 * (l * l)) by field.
      replace (2 ^ 120 * (l * l) * (4 * (s * s) + (n - 1) * (n - 1))) with
        (2 ^ 62 * ((2 ^ 30 * p * (l * ey) - 2 ^ 30 * q * (l * ex)) * (2 ^ 30 * p * (l * ey) - 2 ^ 30 * q * (l * ex))) +
        (2 ^ 30 * p * (2 ^ 30 * p) + 2 ^ 30 * q * (2 ^ 30 * q) - 2 ^ 60) *
        (2 ^ 30 * p * (2 ^ 30 * p) + 2 ^ 30 * q * (2 ^ 30 * q) - 2 ^ 60) * (l * l)) by (unfold s, n; ring). exact H. }
  replace ((p - ex) * (p - ex) + (q - ey) * (q - ey)) with ((c - 1) * (c - 1) + s * s).
  2: { unfold c, s. transitivity ((p * p + q * q) * (ex * ex + ey * ey) - 2 * (p * ex + q * ey) + 1); [ring |].
    rewrite E. transitivity (p * p + q * q - 2 * (p * ex + q * ey) + (ex * ex + ey * ey)); [rewrite E; ring | ring]. }
  apply (unit_close (1 / 2 ^ 28) s ((n - 1) / 2) c); [lra | exact C | lra | lra].
Qed.

(* Points that are checked are as far apart as the shapes, to 2 LSB. *)
Lemma far_points h r x1 y1 g l n : as_far (- h) n r x1 y1 -> 0 < l -> l * l = IZR n -> g * l = - IZR h -> 0 <= g -> IZR r < g ->
  g - IZR r - 2 <= sqrt (IZR x1 * IZR x1 + IZR y1 * IZR y1) <= g - IZR r + 2.
Proof.
  intros (e & E & A & B & P & Q) L LL G G0 R. unfold eighths in *. apply Z.nle_gt, IZR_lt in B. apply IZR_le in E, A, P.
  repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR, ?opp_IZR in *. rewrite <- LL, <- G in A, B. simpl in P.
  assert (cancel : forall a b, a * a * (l * l) <= b * b * (l * l) -> a * a <= b * b).
  { intros a b H. apply Rmult_le_reg_r with (l * l); [apply Rmult_lt_0_compat; exact L | exact H]. }
  assert (A1 : IZR e <= 8 * g).
  { apply Rnot_lt_le. intros X. assert (Y : IZR e * IZR e <= 8 * g * (8 * g)) by (apply cancel; lra).
    pose proof (Rmult_le_0_lt_compat (8 * g) (IZR e) (8 * g) (IZR e) ltac:(lra) ltac:(lra) X X). lra. }
  assert (B1 : 8 * g < IZR e + 1).
  { apply Rnot_le_lt. intros X. pose proof (Rmult_le_compat (IZR e + 1) (8 * g) (IZR e + 1) (8 * g) ltac:(lra) ltac:(lra) X X) as Y.
    apply (Rmult_le_compat_r (l * l)) in Y; [lra | apply Rlt_le, Rmult_lt_0_compat; exact L]. }
  set (D2 := IZR x1 * IZR x1 + IZR y1 * IZR y1) in *.
  assert (D0 : 0 <= D2) by (pose proof (Rle_0_sqr (IZR x1)); pose proof (Rle_0_sqr (IZR y1)); unfold Rsqr, D2 in *; lra).
  set (D := sqrt D2). assert (DD : D * D = D2) by (apply sqrt_sqrt; exact D0). assert (D1 : 0 <= D) by apply sqrt_pos.
  assert (DE : D2 = IZR x1 * IZR x1 + IZR y1 * IZR y1) by reflexivity. clearbody D2 D. clear cancel A B. split.
  - destruct (Z_lt_le_dec 15 (e - 8 * r)) as [H | H].
    + specialize (Q H). apply IZR_le in Q. apply IZR_lt in H. repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR in *.
      assert (IZR e - 8 * IZR r - 15 <= 8 * D); [| lra]. apply Rnot_lt_le. intros X.
      pose proof (Rmult_le_0_lt_compat (8 * D) (IZR e - 8 * IZR r - 15) (8 * D) (IZR e - 8 * IZR r - 15) ltac:(lra) ltac:(lra) X X). lra.
    + apply IZR_le in H. rewrite minus_IZR, mult_IZR in H. lra.
  - assert (8 * D <= IZR e - 8 * IZR r + 16); [| lra]. apply Rnot_lt_le. intros X.
    pose proof (Rmult_le_0_lt_compat (IZR e - 8 * IZR r + 16) (8 * D) (IZR e - 8 * IZR r + 16) (8 * D) ltac:(lra) ltac:(lra) X X). lra.
Qed.

(* A distance: the shapes have one, which rounds to what is checked, a tie up. Points of A and of B are so far apart along a
   direction of length 1, from which the normal (p, q) of Q2.30 is within 2^-28. The points that are reported, (gx, gy) apart,
   are as far apart, to 2 LSB, unless they are saturated. *)
Theorem distance_rounds count i1 j1 i2 j2 p q saturated gx gy :
  measured (ra + rb) d count i1 j1 i2 j2 p q saturated gx gy -> exists m ex ey,
  0 < m /\ IZR d - 1 / 2 <= m < IZR d + 1 / 2 /\ ex * ex + ey * ey = 1 /\
  (forall u v s t, in_a u v -> in_b s t -> m <= sqrt (square_apart u v s t)) /\
  (exists u v s t, in_a u v /\ in_b s t /\ s - u = m * ex /\ t - v = m * ey) /\
  square_apart (IZR p / 2 ^ 30) (IZR q / 2 ^ 30) ex ey <= (1 / 2 ^ 28) * (1 / 2 ^ 28) /\
  (saturated = 0%Z -> m - 2 <= sqrt (IZR gx * IZR gx + IZR gy * IZR gy) <= m + 2).
Proof.
  intros (dx & dy & h & F & (B & (H & C) & R1 & R2) & N & Far).
  pose proof radii as (RA & RB & D). apply IZR_le in RA, RB, D.
  set (l := sqrt (IZR dx * IZR dx + IZR dy * IZR dy)).
  assert (L0 : 0 <= l) by apply sqrt_pos.
  assert (LL : IZR dx * IZR dx + IZR dy * IZR dy = l * l).
  { symmetry. apply sqrt_sqrt. pose proof (Rle_0_sqr (IZR dx)). pose proof (Rle_0_sqr (IZR dy)). unfold Rsqr in *. lra. }
  pose proof H as H'. apply IZR_lt in H'. unfold farther, dot in *. apply Z.gt_lt, IZR_lt in C. apply IZR_lt in R2.
  repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR, ?opp_IZR in C.
  repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR, ?opp_IZR in R2. rewrite LL in C, R2.
  assert (L : 0 < l). { destruct L0 as [| E]; [assumption |]. rewrite <- E in R2. exfalso. nra. }
  set (g := - IZR h / l). assert (G : g * l = - IZR h) by (unfold g; field; lra).
  assert (G0 : 0 < g) by (apply Rdiv_lt_0_compat; lra).
  assert (cancel : forall a b, a * a * (l * l) < b * b * (l * l) -> a * a < b * b).
  { intros a b A. apply Rmult_lt_reg_r with (l * l); [apply Rmult_lt_0_compat; exact L | exact A]. }
  assert (M : IZR ra + IZR rb < g).
  { apply square_less; [lra |]. apply cancel. replace (g * g * (l * l)) with ((g * l) * (g * l)) by ring. rewrite G. lra. }
  assert (U : 2 * g < 2 * (IZR d + (IZR ra + IZR rb)) + 1).
  { apply square_less; [lra |]. apply cancel.
    replace (2 * g * (2 * g) * (l * l)) with (4 * (g * l) * (g * l)) by ring. rewrite G. simpl in *. lra. }
  assert (W : 2 * (IZR d + (IZR ra + IZR rb)) - 1 <= 2 * g).
  { destruct R1 as [R1 | R1].
    - apply (f_equal IZR) in R1. rewrite !plus_IZR in R1. lra.
    - apply Z.ge_le, IZR_le in R1. repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR, ?opp_IZR in R1. rewrite LL in R1.
      apply Rnot_lt_le. intros X. assert (0 <= 2 * g) by lra.
      pose proof (Rmult_le_0_lt_compat _ _ _ _ H0 H0 X X) as Y.
      apply (Rmult_lt_compat_r (l * l)) in Y; [| apply Rmult_lt_0_compat; exact L].
      replace (2 * g * (2 * g) * (l * l)) with (4 * (g * l) * (g * l)) in Y by ring. rewrite G in Y. lra. }
  assert (E : IZR dx / l * (IZR dx / l) + IZR dy / l * (IZR dy / l) = 1).
  { transitivity ((IZR dx * IZR dx + IZR dy * IZR dy) / (l * l)); [field; lra |]. rewrite LL. field. lra. }
  exists (g - (IZR ra + IZR rb)), (IZR dx / l), (IZR dy / l). split; [lra |]. split; [lra |]. split; [exact E |].
  assert (LN : l * l = IZR (dot dx dy dx dy)) by (unfold dot; rewrite plus_IZR, !mult_IZR; lra).
  split; [| split; [| split; [exact (unit_along dx dy p q l N L LL) |]]].
  - intros u v s t PA PB. pose proof (widened l dx dy h u v s t L0 LL B PA PB) as A1.
    assert (S : 0 <= square_apart u v s t).
    { pose proof (Rle_0_sqr (u - s)). pose proof (Rle_0_sqr (v - t)). unfold Rsqr, square_apart in *. lra. }
    set (n := sqrt (square_apart u v s t)). assert (N1 : n * n = square_apart u v s t) by (apply sqrt_sqrt; exact S).
    assert (N0 : 0 <= n) by apply sqrt_pos.
    assert (E3 : (- (u - s)) * (- (u - s)) + (- (v - t)) * (- (v - t)) <= n * n) by (unfold square_apart in N1; lra).
    pose proof (cauchy l n (IZR dx) (IZR dy) _ _ L0 N0 LL E3) as A3.
    apply Rmult_le_reg_l with l; [exact L |]. lra.
  - destruct (feature_point _ _ _ _ _ dx dy h l F H L LL) as (u & v & X & Y). fold g in Y.
    destruct X as (p1 & q1 & s1 & t1 & HA & HB & U1 & V1). pose proof (behind_all dx dy h p1 q1 s1 t1 B HA HB) as W1.
    rewrite <- U1, <- V1 in W1.
    (* The point is at most -g along the direction and g from the origin, so it is -g times the direction. *)
    assert (Z : (u + g * (IZR dx / l)) * (u + g * (IZR dx / l)) + (v + g * (IZR dy / l)) * (v + g * (IZR dy / l)) <= 0).
    { replace ((u + g * (IZR dx / l)) * (u + g * (IZR dx / l)) + (v + g * (IZR dy / l)) * (v + g * (IZR dy / l)))
        with (u * u + v * v + 2 * g * ((IZR dx * u + IZR dy * v) / l) +
          g * g * (IZR dx / l * (IZR dx / l) + IZR dy / l * (IZR dy / l))) by (field; lra).
      rewrite Y, E. assert (I : (IZR dx * u + IZR dy * v) / l <= - g).
      { apply Rmult_le_reg_r with l; [exact L |].
        replace ((IZR dx * u + IZR dy * v) / l * l) with (IZR dx * u + IZR dy * v) by (field; lra). lra. }
      assert (2 * g * ((IZR dx * u + IZR dy * v) / l) <= 2 * g * - g) by (apply Rmult_le_compat_l; lra). lra. }
    pose proof (Rle_0_sqr (u + g * (IZR dx / l))) as Z1. pose proof (Rle_0_sqr (v + g * (IZR dy / l))) as Z2. unfold Rsqr in Z1, Z2.
    assert (U2 : u + g * (IZR dx / l) = 0) by (apply Rplus_sqr_eq_0_l with (v + g * (IZR dy / l)); unfold Rsqr; lra).
    assert (V2 : v + g * (IZR dy / l) = 0) by (apply Rplus_sqr_eq_0_l with (u + g * (IZR dx / l)); unfold Rsqr; lra).
    assert (X : in_difference u v) by (exists p1, q1, s1, t1; auto).
    destruct (difference_exact u v g X Y G0 ltac:(lra)) as (e & f & s & t & A & Z0 & S & T).
    exists e, f, s, t. split; [exact A |]. split; [exact Z0 |]. rewrite S, T.
    replace u with (- g * (IZR dx / l)) by lra. replace v with (- g * (IZR dy / l)) by lra.
    split; field; lra.
  - intros S. pose proof (far_points h (ra + rb) gx gy g l _ (Far S) L LN G (Rlt_le _ _ G0)) as W2. rewrite plus_IZR in W2.
    apply W2. lra.
Qed.

(* A point (p, q) that is checked is within 1 LSB of its shape, of which (x1, y1) is the centre and r the radius. *)
Theorem point_near n vx vy x1 y1 p q r : beside_vertex n vx vy (x1 - p) (y1 - q) (r + 1) \/
  beside_edge n vx vy (x1 - p) (y1 - q) (r + 1) -> in_shape n vx vy (IZR x1) (IZR y1) (IZR r + 1) (IZR p) (IZR q).
Proof.
  intros [(i & I & H) | (i & k & I & K & (F & G) & H)].
  - exists (IZR (vx i)), (IZR (vy i)). split; [apply hull_vertex; exact I |]. unfold near_point in H. apply IZR_le in H.
    repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR in H. lra.
  - unfold near_line, dot, cross in *. apply IZR_le in H. apply IZR_lt in F. apply Z.gt_lt, IZR_lt in G.
    repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR in *.
    destruct (foot_near _ _ _ _ (IZR r + 1) F G H) as (h & (H0 & H1) & D).
    pose proof (hull_mean n vx vy (1 - h) h 0 _ _ _ _ _ _ ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)
      (hull_vertex n vx vy i I) (hull_vertex n vx vy k K) (hull_vertex n vx vy i I)) as M.
    eexists _, _. split; [exact M |]. eapply Rle_trans; [| exact D]. apply Req_le. ring.
Qed.

Lemma root_most s t n l : at_most_root s t n -> 0 <= l -> l * l = IZR n -> IZR s <= IZR t * l.
Proof.
  intros H L LL. destruct H as [(T & [S | S]) | (T & S & H)].
  - apply IZR_le in T, S. assert (0 <= IZR t * l) by (apply Rmult_le_pos; assumption). lra.
  - apply IZR_le in T, S. rewrite !mult_IZR, <- LL in S. apply Rnot_lt_le. intros G.
    assert (P : 0 <= IZR t * l) by (apply Rmult_le_pos; assumption). pose proof (Rmult_le_0_lt_compat _ _ _ _ P P G G). lra.
  - apply IZR_lt in T, S. apply IZR_le in H. rewrite !mult_IZR, <- LL in H. apply Rnot_lt_le. intros G.
    assert (P : 0 <= - IZR s) by lra. assert (Q : - IZR s < - IZR t * l) by lra.
    pose proof (Rmult_le_0_lt_compat _ _ _ _ P P Q Q). lra.
Qed.

(* The length of a direction. *)
Lemma length dx dy : (0 < dot dx dy dx dy)%Z -> exists l, 0 < l /\ IZR dx * IZR dx + IZR dy * IZR dy = l * l /\
  l * l = IZR (dot dx dy dx dy).
Proof.
  intros N. apply IZR_lt in N. exists (sqrt (IZR (dot dx dy dx dy))). split; [apply sqrt_lt_R0; exact N |].
  rewrite sqrt_sqrt by lra. split; [| reflexivity]. unfold dot. rewrite plus_IZR, !mult_IZR. reflexivity.
Qed.

(* A depth is enough: along some direction of length 1, from which the normal (p, q) of Q2.30 is within 2^-28, no point of A
   is more than that far beyond any point of B. *)
Theorem depth_enough p q : enough (ra + rb) d p q -> exists ex ey, ex * ex + ey * ey = 1 /\
  (forall u v s t, in_a u v -> in_b s t -> ex * (u - s) + ey * (v - t) <= IZR d) /\
  square_apart (IZR p / 2 ^ 30) (IZR q / 2 ^ 30) ex ey <= (1 / 2 ^ 28) * (1 / 2 ^ 28).
Proof.
  intros (dx & dy & h & N & B & A & W). destruct (length dx dy N) as (l & L & LL & LN).
  pose proof (root_most _ _ _ l A (Rlt_le _ _ L) LN) as R. rewrite minus_IZR, plus_IZR in R.
  exists (IZR dx / l), (IZR dy / l). split.
  { transitivity ((IZR dx * IZR dx + IZR dy * IZR dy) / (l * l)); [field; lra |]. rewrite LL. field. lra. }
  split; [| exact (unit_along dx dy p q l W L LL)].
  intros u v s t PA PB. pose proof (widened l dx dy h u v s t (Rlt_le _ _ L) LL B PA PB) as V.
  apply Rmult_le_reg_l with l; [exact L |].
  replace (l * (IZR dx / l * (u - s) + IZR dy / l * (v - t))) with (IZR dx * (u - s) + IZR dy * (v - t)) by (field; lra). lra.
Qed.

(* Moved by the depth along the normal (p, q) of Q2.30, each component rounded away from 0, B has no point within A: along
   some direction no point of A is beyond any of B. *)
Theorem move_parts depth p q : moved (ra + rb) depth p q -> exists tx ty dx dy, steps tx depth p /\ steps ty depth q /\
  0 < IZR dx * IZR dx + IZR dy * IZR dy /\ forall u v s t, in_a u v -> in_b s t ->
  IZR dx * (u - (s + IZR tx)) + IZR dy * (v - (t + IZR ty)) <= 0.
Proof.
  intros (tx & ty & SX & SY & dx & dy & h & N & B & G & C). destruct (length dx dy N) as (l & L & LL & LN).
  exists tx, ty, dx, dy. split; [exact SX |]. split; [exact SY |]. split; [rewrite LL; apply Rmult_lt_0_compat; exact L |].
  intros u v s t PA PB. pose proof (widened l dx dy h u v s t (Rlt_le _ _ L) LL B PA PB) as V.
  destruct radii as (RA & RB & D). apply IZR_le in RA, RB, G, C.
  rewrite !mult_IZR, plus_IZR, <- LN in C.
  assert (K : IZR (dot dx dy tx ty - h) = IZR dx * IZR tx + IZR dy * IZR ty - IZR h).
  { unfold dot. rewrite minus_IZR, plus_IZR, !mult_IZR. reflexivity. }
  rewrite K in G, C. set (k := IZR dx * IZR tx + IZR dy * IZR ty - IZR h) in *.
  assert (W : (IZR ra + IZR rb) * l <= k).
  { apply Rnot_lt_le. intros X. pose proof (Rmult_le_0_lt_compat _ _ _ _ G G X X). lra. }
  unfold k in W. lra.
Qed.

Lemma half_near depth u g : exists e, 0 <= e <= 1 /\
  2 ^ 30 * (IZR g - IZR depth * (IZR u / 2 ^ 30)) = 2 * IZR (half_off depth u g) - e.
Proof.
  set (k := (2 ^ 30 * g - depth * u)%Z). assert (K : half_off depth u g = ((k + 1) / 2)%Z) by reflexivity.
  exists (IZR (2 * half_off depth u g - k)). rewrite minus_IZR, mult_IZR. split.
  - rewrite <- mult_IZR, <- minus_IZR. rewrite K. pose proof (Z.div_mod (k + 1) 2 ltac:(lia)).
    pose proof (Z.mod_pos_bound (k + 1) 2 ltac:(lia)). split; apply IZR_le; lia.
  - unfold k. rewrite minus_IZR, !mult_IZR. assert (T30 : 2 ^ 30 = IZR (2 ^ 30)) by (rewrite pow_IZR; reflexivity).
    rewrite T30. field. rewrite <- T30. apply pow_nonzero. lra.
Qed.

(* The points of a depth are as far apart as the depth along the normal (p, q) of Q2.30, to 3 LSB and 2^-28 of it, rounded. *)
Theorem points_overlap depth p q gx gy : (0 <= depth)%Z -> overlap depth p q gx gy ->
  square_apart (IZR gx) (IZR gy) (IZR depth * (IZR p / 2 ^ 30)) (IZR depth * (IZR q / 2 ^ 30)) <=
  (3 + IZR depth / 2 ^ 28 + 1 / 2 ^ 29) * (3 + IZR depth / 2 ^ 28 + 1 / 2 ^ 29).
Proof.
  intros D H. apply IZR_le in D, H. assert (T29 : IZR (2 ^ 29) = 2 ^ 29) by (rewrite pow_IZR; reflexivity).
  repeat rewrite ?mult_IZR, ?plus_IZR in H. rewrite T29 in H.
  destruct (half_near depth p gx) as (e & E & X). destruct (half_near depth q gy) as (f & F & Y).
  set (u := IZR (half_off depth p gx)) in *. set (v := IZR (half_off depth q gy)) in *.
  set (m := 3 * 2 ^ 29 + 2 * IZR depth) in *. assert (M : 0 <= m) by (unfold m; lra).
  set (l := sqrt (u * u + v * v)). assert (L : 0 <= l) by apply sqrt_pos.
  assert (LL : u * u + v * v = l * l).
  { symmetry. apply sqrt_sqrt. pose proof (Rle_0_sqr u). pose proof (Rle_0_sqr v). unfold Rsqr in *. lra. }
  assert (LM : l <= m) by (apply Rnot_lt_le; intros G; pose proof (Rmult_le_0_lt_compat _ _ _ _ M M G G); lra).
  assert (EE : - e * - e + - f * - f <= 2 * 2).
  { assert (e * e <= 1 * 1) by (apply Rmult_le_compat; lra). assert (f * f <= 1 * 1) by (apply Rmult_le_compat; lra). lra. }
  pose proof (cauchy l 2 u v (- e) (- f) L ltac:(lra) LL EE) as C.
  set (a := IZR gx - IZR depth * (IZR p / 2 ^ 30)) in *. set (b := IZR gy - IZR depth * (IZR q / 2 ^ 30)) in *.
  assert (S : 2 ^ 30 * 2 ^ 30 * (a * a + b * b) <= (2 * m + 2) * (2 * m + 2)).
  { replace (2 ^ 30 * 2 ^ 30 * (a * a + b * b)) with ((2 ^ 30 * a) * (2 ^ 30 * a) + (2 ^ 30 * b) * (2 ^ 30 * b)) by ring.
    rewrite X, Y. assert (l * l <= m * m) by (apply Rmult_le_compat; assumption). lra. }
  unfold square_apart. fold a b. apply Rmult_le_reg_l with (2 ^ 30 * 2 ^ 30); [lra |].
  eapply Rle_trans; [exact S |]. apply Req_le. unfold m. field.
Qed.

Lemma clear_below dx dy h r l : clear dx dy h r -> (0 <= r)%Z -> 0 <= l -> IZR dx * IZR dx + IZR dy * IZR dy = l * l ->
  IZR r * l < - IZR h.
Proof.
  intros (H & F) R L LL. unfold farther, dot in F. apply IZR_lt in H. apply IZR_le in R. apply Z.gt_lt, IZR_lt in F.
  repeat rewrite ?mult_IZR, ?plus_IZR, ?opp_IZR in F. rewrite LL in F. apply Rnot_le_lt. intros G.
  assert (P : 0 <= - IZR h) by lra. pose proof (Rmult_le_compat _ _ _ _ P P G G). lra.
Qed.

(* A miss by a direction: B moves by (tx, ty), and stays more than the margin d away at each fraction f of that. *)
Theorem cast_passes tx ty : passing tx ty (ra + rb + d) -> forall f u v s t, 0 <= f <= 1 -> in_a u v -> in_b s t ->
  square_apart u v (s + f * IZR tx) (t + f * IZR ty) > IZR d * IZR d.
Proof.
  intros (dx & dy & h & B & C & E) f u v s t F PA PB. destruct radii as (RA & RB & D).
  set (l := sqrt (IZR dx * IZR dx + IZR dy * IZR dy)). assert (L : 0 <= l) by apply sqrt_pos.
  assert (Q : 0 <= IZR dx * IZR dx + IZR dy * IZR dy).
  { pose proof (Rle_0_sqr (IZR dx)). pose proof (Rle_0_sqr (IZR dy)). unfold Rsqr in *. lra. }
  assert (LL : IZR dx * IZR dx + IZR dy * IZR dy = l * l) by (symmetry; apply sqrt_sqrt; exact Q).
  pose proof (widened l dx dy h u v s t L LL B PA PB) as W.
  assert (R : (0 <= ra + rb + d)%Z) by lia.
  pose proof (clear_below dx dy _ _ l C R L LL) as C1. pose proof (clear_below dx dy _ _ l E R L LL) as E1.
  unfold dot in E1. apply IZR_le in RA, RB, D. repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR in *.
  apply Rnot_le_gt. intros N. unfold square_apart in N.
  assert (N2 : (- (u - (s + f * IZR tx))) * (- (u - (s + f * IZR tx))) +
    (- (v - (t + f * IZR ty))) * (- (v - (t + f * IZR ty))) <= IZR d * IZR d) by lra.
  pose proof (cauchy l (IZR d) (IZR dx) (IZR dy) _ _ L D LL N2) as A.
  set (m := IZR dx * IZR tx + IZR dy * IZR ty) in *. set (r := IZR ra + IZR rb + IZR d) in *.
  assert (K : (1 - f) * (r * l) + f * (r * l) < (1 - f) * - IZR h + f * - (IZR h - m)).
  { destruct (Rle_lt_dec f 0) as [Z | P].
    - replace f with 0 by lra. lra.
    - assert (f * (r * l) < f * - (IZR h - m)) by (apply Rmult_lt_compat_l; lra).
      assert ((1 - f) * (r * l) <= (1 - f) * - IZR h) by (apply Rmult_le_compat_l; lra). lra. }
  assert (J : (1 - f) * - IZR h + f * - (IZR h - m) = f * m - IZR h) by ring.
  assert (I : IZR dx * - (u - (s + f * IZR tx)) + IZR dy * - (v - (t + f * IZR ty)) =
    f * m - (IZR dx * (u - s) + IZR dy * (v - t))) by (unfold m; ring).
  assert (O : (1 - f) * (r * l) + f * (r * l) = l * (IZR ra + IZR rb) + l * IZR d) by (unfold r; ring). lra.
Qed.

(* A miss by the circles. *)
Theorem circles_miss ca cb tx ty : (0 <= ca /\ 0 <= cb)%Z ->
  (forall i, (i < na)%nat -> ax i * ax i + ay i * ay i <= ca * ca)%Z ->
  (forall j, (j < nb)%nat -> bx j * bx j + bl j * bl j <= cb * cb)%Z ->
  circles_pass tx ty (ca + cb + (ra + rb + d)) -> forall f u v s t, 0 <= f <= 1 -> in_a u v -> in_b s t ->
  square_apart u v (s + f * IZR tx) (t + f * IZR ty) > IZR d * IZR d.
Proof.
  intros C HA HB H f u v s t F PA PB. apply (centres_apart ca cb _ _ C HA HB); [| exact PA | exact PB].
  assert (R0 : (0 <= ca + cb + (ra + rb + d))%Z) by lia. apply IZR_le in R0.
  set (r := (ca + cb + (ra + rb + d))%Z) in *. clearbody r. clear - F H R0.
  assert (off : forall w z, stays_off w z r -> IZR r * IZR r < (IZR w - f * IZR z) * (IZR w - f * IZR z)).
  { intros w z [(A & B) | (A & B)].
    - apply Z.gt_lt, IZR_lt in A, B. rewrite minus_IZR in B. assert (G : IZR r < IZR w - f * IZR z).
      { replace (IZR w - f * IZR z) with ((1 - f) * IZR w + f * (IZR w - IZR z)) by ring.
        destruct (Rle_lt_dec f 0) as [Z | P]; [replace f with 0 by lra; lra |].
        assert (f * IZR r < f * (IZR w - IZR z)) by (apply Rmult_lt_compat_l; lra).
        assert ((1 - f) * IZR r <= (1 - f) * IZR w) by (apply Rmult_le_compat_l; lra). lra. }
      apply Rmult_le_0_lt_compat; lra.
    - apply IZR_lt in A, B. rewrite ?minus_IZR, ?opp_IZR in *. assert (G : IZR r < - (IZR w - f * IZR z)).
      { replace (- (IZR w - f * IZR z)) with ((1 - f) * - IZR w + f * - (IZR w - IZR z)) by ring.
        destruct (Rle_lt_dec f 0) as [Z | P]; [replace f with 0 by lra; lra |].
        assert (f * IZR r < f * - (IZR w - IZR z)) by (apply Rmult_lt_compat_l; lra).
        assert ((1 - f) * IZR r <= (1 - f) * - IZR w) by (apply Rmult_le_compat_l; lra). lra. }
      replace ((IZR w - f * IZR z) * (IZR w - f * IZR z)) with (- (IZR w - f * IZR z) * - (IZR w - f * IZR z)) by ring.
      apply Rmult_le_0_lt_compat; lra. }
  destruct H as [H | [H | (A & B & H)]].
  - pose proof (off _ _ H). pose proof (Rle_0_sqr (IZR y - f * IZR ty)). unfold Rsqr in *. lra.
  - pose proof (off _ _ H). pose proof (Rle_0_sqr (IZR x - f * IZR tx)). unfold Rsqr in *. lra.
  - clear off. apply Z.gt_lt, IZR_lt in A, B. rewrite !plus_IZR, !mult_IZR in A, B. rewrite !minus_IZR in B.
    set (n := IZR tx * IZR tx + IZR ty * IZR ty). set (m := IZR tx * IZR x + IZR ty * IZR y).
    assert (N : 0 <= n) by (pose proof (Rle_0_sqr (IZR tx)); pose proof (Rle_0_sqr (IZR ty)); unfold Rsqr, n in *; lra).
    set (g := (IZR x - f * IZR tx) * (IZR x - f * IZR tx) + (IZR y - f * IZR ty) * (IZR y - f * IZR ty)).
    assert (G : g = IZR x * IZR x + IZR y * IZR y - 2 * f * m + f * f * n) by (unfold g, m, n; ring).
    assert (FF : 0 <= f * f * n) by (apply Rmult_le_pos; [apply Rmult_le_pos |]; lra).
    unfold foot_off, farther, dot, cross in H. destruct H as [H | [H | H]].
    + apply IZR_le in H. rewrite plus_IZR, !mult_IZR in H. fold m in H.
      assert (0 <= f * - m) by (apply Rmult_le_pos; lra). lra.
    + apply IZR_le in H. rewrite !plus_IZR, !mult_IZR in H. fold m n in H.
      assert (I : g = (IZR x - IZR tx) * (IZR x - IZR tx) + (IZR y - IZR ty) * (IZR y - IZR ty) +
        2 * ((1 - f) * (m - n)) + (1 - f) * (1 - f) * n) by (rewrite G; unfold m, n; ring).
      assert (0 <= (1 - f) * (m - n)) by (apply Rmult_le_pos; lra).
      assert (0 <= (1 - f) * (1 - f) * n) by (apply Rmult_le_pos; [apply Rmult_le_pos |]; lra). lra.
    + apply Z.gt_lt, IZR_lt in H. rewrite !mult_IZR, plus_IZR, minus_IZR, !mult_IZR in H. fold n in H.
      set (c := IZR tx * IZR y - IZR ty * IZR x) in *.
      assert (I : g * n = (m - f * n) * (m - f * n) + c * c) by (unfold g, n, m, c; ring).
      pose proof (Rle_0_sqr (m - f * n)) as S. unfold Rsqr in S.
      apply Rnot_le_lt. intros W. pose proof (Rmult_le_compat_r n _ _ N W). lra.
Qed.

(* A hit later, of shapes without radius and margin: they meet at a fraction of the way that is f / 2^30, rounded down, and
   never before. *)
Theorem cast_enters tx ty f : (ra = 0 /\ rb = 0)%Z -> entering tx ty f -> exists g, 0 <= g <= 1 /\
  IZR f <= 2 ^ 30 * g < IZR f + 1 /\ (exists u v, in_a u v /\ in_b (u - g * IZR tx) (v - g * IZR ty)) /\
  forall e u v s t, 0 <= e < g -> in_a u v -> in_b s t -> square_apart u v (s + e * IZR tx) (t + e * IZR ty) > 0.
Proof.
  intros (ZA & ZB) (i & j & k & m & px & py & qx & qy & dx & dy & h & P & Q & B & (T & H) & HP & HQ & (SP & SQ) & F0 & F1).
  apply named_in in P, Q. unfold dot, cross in *. apply IZR_le in T, SP, SQ, F0. apply IZR_lt in H, F1.
  apply (f_equal IZR) in HP, HQ.
  repeat rewrite ?mult_IZR, ?plus_IZR, ?minus_IZR, ?opp_IZR in *.
  assert (T30 : 2 ^ 30 = IZR (2 ^ 30)) by (rewrite pow_IZR; reflexivity). rewrite <- T30 in F0, F1.
  set (n := - (IZR dx * IZR tx + IZR dy * IZR ty)) in *. assert (N : 0 < n) by (unfold n; lra).
  set (g := - IZR h / n). assert (G : g * n = - IZR h) by (unfold g; field; lra).
  assert (G0 : 0 < g) by (apply Rmult_lt_reg_r with n; lra).
  assert (G1 : g <= 1) by (apply Rmult_le_reg_r with n; [exact N |]; rewrite G; unfold n; lra).
  exists g. split; [lra |]. split.
  { split; [apply Rmult_le_reg_r with n | apply Rmult_lt_reg_r with n]; try exact N;
      replace (2 ^ 30 * g * n) with (2 ^ 30 * (g * n)) by ring; rewrite G; unfold n in *; lra. }
  split.
  - (* The point of the edge that lies on the line of the way. *)
    set (sp := IZR tx * IZR py - IZR ty * IZR px) in *. set (sq := IZR tx * IZR qy - IZR ty * IZR qx) in *.
    assert (X : exists w, 0 <= w <= 1 /\ (1 - w) * sp + w * sq = 0).
    { destruct (Req_dec (sq - sp) 0) as [Z | Z].
      - exists 0. split; lra.
      - exists (- sp / (sq - sp)). assert (0 < sq - sp) by lra. split.
        + split; [apply Rmult_le_reg_r with (sq - sp) | apply Rmult_le_reg_r with (sq - sp)]; try assumption;
            replace (- sp / (sq - sp) * (sq - sp)) with (- sp) by (field; lra); lra.
        + field. lra. }
    destruct X as (w & W & Z).
    pose proof (difference_mean (1 - w) w 0 _ _ _ _ _ _ ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) P Q P) as M.
    set (u := (1 - w) * IZR px + w * IZR qx + 0 * IZR px) in *. set (v := (1 - w) * IZR py + w * IZR qy + 0 * IZR py) in *.
    assert (C : IZR tx * v - IZR ty * u = 0) by (rewrite <- Z; unfold u, v, sp, sq; ring).
    assert (D : IZR dx * u + IZR dy * v = IZR h).
    { replace (IZR dx * u + IZR dy * v) with ((1 - w) * (IZR dx * IZR px + IZR dy * IZR py) +
        w * (IZR dx * IZR qx + IZR dy * IZR qy)) by (unfold u, v; ring). rewrite HP, HQ. ring. }
    assert (U : u = g * IZR tx).
    { apply Rmult_eq_reg_r with n; [| lra]. replace (g * IZR tx * n) with (g * n * IZR tx) by ring. rewrite G, <- D.
      replace (u * n) with (- (IZR dx * u + IZR dy * v) * IZR tx + IZR dy * (IZR tx * v - IZR ty * u)) by (unfold n; ring).
      rewrite C. ring. }
    assert (V : v = g * IZR ty).
    { apply Rmult_eq_reg_r with n; [| lra]. replace (g * IZR ty * n) with (g * n * IZR ty) by ring. rewrite G, <- D.
      replace (v * n) with (- (IZR dx * u + IZR dy * v) * IZR ty - IZR dx * (IZR tx * v - IZR ty * u)) by (unfold n; ring).
      rewrite C. ring. }
    destruct M as (p & q & s & t & HA & HB & U1 & V1).
    exists (IZR (cx + x) + p), (IZR (cy + y) + q). unfold in_a, in_b. rewrite ZA, ZB. split.
    + exists p, q. split; [exact HA | apply Req_le; ring].
    + exists s, t. split; [exact HB | apply Req_le].
      rewrite <- U, <- V, U1, V1, !plus_IZR. ring.
  - intros e u v s t E PA PB.
    destruct radii as (RA & RB & _).
    set (l := sqrt (IZR dx * IZR dx + IZR dy * IZR dy)). assert (L : 0 <= l) by apply sqrt_pos.
    assert (LL : IZR dx * IZR dx + IZR dy * IZR dy = l * l).
    { symmetry. apply sqrt_sqrt. pose proof (Rle_0_sqr (IZR dx)). pose proof (Rle_0_sqr (IZR dy)). unfold Rsqr in *. lra. }
    pose proof (widened l dx dy h u v s t L LL B PA PB) as W. rewrite ZA, ZB in W.
    unfold square_apart. set (a := u - (s + e * IZR tx)). set (b := v - (t + e * IZR ty)).
    assert (K : IZR dx * a + IZR dy * b <= IZR h + e * n).
    { replace (IZR dx * a + IZR dy * b) with (IZR dx * (u - s) + IZR dy * (v - t) + e * n) by (unfold a, b, n; ring). lra. }
    assert (J : e * n < g * n) by (apply Rmult_lt_compat_r; lra).
    pose proof (Rle_0_sqr a) as A2. pose proof (Rle_0_sqr b) as B2. unfold Rsqr in *.
    apply Rnot_le_gt. intros Z. assert (A0 : a = 0) by (apply Rplus_sqr_eq_0_l with b; unfold Rsqr; lra).
    assert (B0 : b = 0) by (apply Rplus_sqr_eq_0_l with a; unfold Rsqr; lra). rewrite A0, B0 in K. lra.
Qed.

End Vertices.

Print Assumptions apart.
Print Assumptions together.
Print Assumptions circles_apart.
Print Assumptions distance_rounds.
Print Assumptions point_near.
Print Assumptions depth_enough.
Print Assumptions move_parts.
Print Assumptions cast_passes.
Print Assumptions circles_miss.
Print Assumptions cast_enters.
Print Assumptions points_overlap.
