(* From vertices to all points, in space: what the contract of space.h says of the vertices of two polytopes decides about
   every point of the two shapes. The definitions over Z are those of geometry.h, solid.h and space.h, name by name. *)
Require Import Reals Lra Psatz ZArith.

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

Lemma sum_ext n f g : (forall i, f i = g i) -> sum n f = sum n g.
Proof. intros H. induction n; simpl; [lra | rewrite IHn, H; lra]. Qed.

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

Variables (ra rb d : Z) (cx cy cz : Z).  (* both convex radii, the distance asked about, and the centre of B *)
Hypothesis radii : (0 <= ra /\ 0 <= rb /\ 0 <= d)%Z.

Definition in_a := in_shape na ax ay az (IZR (cx + x)) (IZR (cy + y)) (IZR (cz + z)) (IZR ra).
Definition in_b := in_shape nb bx bl bz (IZR cx) (IZR cy) (IZR cz) (IZR rb).

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
  intros L LL W E E'. destruct radii as (RA & RB & D). apply IZR_le in RA, RB, D. rewrite !plus_IZR in *.
  assert (L0 : 0 <= l) by lra.
  pose proof (cauchy3 l (IZR ra) dx dy dz _ _ _ L0 RA LL E) as A.
  assert (E2 : (- (s - IZR cx - o)) * (- (s - IZR cx - o)) + (- (t - IZR cy - o')) * (- (t - IZR cy - o')) +
    (- (q - IZR cz - o'')) * (- (q - IZR cz - o'')) <= IZR rb * IZR rb) by lra.
  pose proof (cauchy3 l (IZR rb) dx dy dz _ _ _ L0 RB LL E2) as B.
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

(* `no`, by the spheres: no vertex is farther than its core's radius from its centre. *)
Theorem spheres_apart3 (ca cb : Z) : (0 <= ca /\ 0 <= cb)%Z ->
  (forall i, (i < na)%nat -> norm3 (ax i) (ay i) (az i) <= ca * ca)%Z ->
  (forall j, (j < nb)%nat -> norm3 (bx j) (bl j) (bz j) <= cb * cb)%Z ->
  spheres_apart x y z (ca + cb + (ra + rb + d)) ->
  forall u v w s t q, in_a u v w -> in_b s t q -> square_apart u v w s t q > IZR d * IZR d.
Proof.
  intros (CA & CB) HA HB F u v w s t q (p & p' & p'' & P & E) (o & o' & o'' & O & E').
  pose proof radii as (RA & RB & D). unfold spheres_apart, norm3 in *.
  apply IZR_le in CA, CB, RA, RB, D. apply Z.gt_lt, IZR_lt in F. repeat rewrite ?mult_IZR, ?plus_IZR in F.
  set (l := sqrt (IZR x * IZR x + IZR y * IZR y + IZR z * IZR z)).
  assert (N : 0 <= IZR x * IZR x + IZR y * IZR y + IZR z * IZR z).
  { pose proof (Rle_0_sqr (IZR x)). pose proof (Rle_0_sqr (IZR y)). pose proof (Rle_0_sqr (IZR z)). unfold Rsqr in *. lra. }
  assert (L0 : 0 <= l) by apply sqrt_pos.
  assert (LL : IZR x * IZR x + IZR y * IZR y + IZR z * IZR z = l * l) by (symmetry; apply sqrt_sqrt; exact N).
  set (m := IZR ra + IZR rb + IZR d) in *. rewrite LL in F.
  assert (M : IZR ca + IZR cb + m < l).
  { apply Rnot_le_lt. intros G. pose proof (Rmult_le_compat _ _ _ _ L0 L0 G G). lra. }
  assert (L : 0 < l) by (unfold m in *; lra).
  assert (A : - IZR x * p + - IZR y * p' + - IZR z * p'' <= l * IZR ca).
  { apply le_epsilon. intros e G. apply Rlt_le. apply (hull_below na ax ay az _ _ _ _ _ _ _ P). intros k K.
    specialize (HA k K). apply IZR_le in HA. repeat rewrite ?mult_IZR, ?plus_IZR in HA.
    pose proof (cauchy3 l (IZR ca) (- IZR x) (- IZR y) (- IZR z) _ _ _ L0 CA ltac:(rewrite <- LL; ring) HA). lra. }
  assert (B : IZR x * o + IZR y * o' + IZR z * o'' <= l * IZR cb).
  { apply le_epsilon. intros e G. apply Rlt_le. apply (hull_below nb bx bl bz _ _ _ _ _ _ _ O). intros k K.
    specialize (HB k K). apply IZR_le in HB. repeat rewrite ?mult_IZR, ?plus_IZR in HB.
    pose proof (cauchy3 l (IZR cb) (IZR x) (IZR y) (IZR z) _ _ _ L0 CB LL HB). lra. }
  apply (behind_apart l (- IZR x) (- IZR y) (- IZR z) u v w s t q p p' p'' o o' o'' L); try assumption.
  - rewrite <- LL. ring.
  - fold m. pose proof (Rmult_lt_compat_l l _ _ L M). lra.
Qed.

End Vertices.

Print Assumptions apart3.
Print Assumptions spheres_apart3.
