(* Scatter, the transpose of `affine`: a gradient among 64 banks, one axis after the other. A bank gets
   the difference of two cumulative products, each rounded; differences are exact where nothing
   saturates, which the B-spline never does.
   SPDX-License-Identifier: Apache-2.0 *)
Require Import Reals Lra Lia List Sums Programs Certified.
Open Scope R_scope.

(** Weights and functions of three axes that a bound is about: how large the sum of the magnitudes of
    the functions is, of the errors of the weights, and of those of the products of three. *)
Record weighted (ns nt nu es et eu a : R) (s t u bs bt bu : nat -> R) : Prop := {
  size_s : norm bs <= ns; size_t : norm bt <= nt; size_u : norm bu <= nu;
  error_s : norm (fun i => s i - bs i) <= es;
  error_t : norm (fun i => t i - bt i) <= et;
  error_u : norm (fun i => u i - bu i) <= eu;
  error_all : distance (products s t u) (products bs bt bu) <= a }.

(** Half the derivatives of B-splines: what an axis has along which the derivative is wanted. *)
Lemma slopes_size (d : nat -> R) x : 0 <= x <= 1 ->
  d 0%nat = (- (1 / 2) + x - 1 / 2 * x * x) / 2 -> d 1%nat = (-2 * x + 3 / 2 * x * x) / 2 ->
  d 2%nat = (1 / 2 + x - 3 / 2 * x * x) / 2 -> d 3%nat = 1 / 2 * x * x / 2 -> norm d <= 3 / 4.
Proof.
  intros [L U] D0 D1 D2 D3; unfold norm, S4; rewrite D0, D1, D2, D3.
  assert (N : x * x <= x).
  { rewrite <- (Rmult_1_r x) at 3; apply Rmult_le_compat_l; lra. }
  pose proof (Rle_0_sqr (1 - x)) as A; pose proof (Rle_0_sqr x) as B; pose proof (Rle_0_sqr (2 * x - 1)) as C.
  unfold Rsqr in A, B, C; ring_simplify in A; ring_simplify in C.
  replace (x ^ 2) with (x * x) in A, C by ring.
  rewrite (Rabs_left1 ((- (1 / 2) + x - 1 / 2 * x * x) / 2)), (Rabs_left1 ((-2 * x + 3 / 2 * x * x) / 2)),
    !Rabs_pos_eq; lra.
Qed.

Section Expansion.
Variables (share : R -> R) (half : R).
Hypothesis Half : rounds share half.

(** Each of three roundings moves something from a bank to the next. *)
Lemma expansion to_one w v : S4 w = total to_one ->
  norm (fun b => expanded share to_one w v b - w b * v) <= 6 * half.
Proof.
  unfold norm, S4, expanded; intro W.
  pose proof (Half (w 0%nat * v)) as A; pose proof (Half ((w 0%nat + w 1%nat) * v)) as B.
  pose proof (Half ((w 0%nat + w 1%nat + w 2%nat) * v)) as C.
  set (x := share (w 0%nat * v)) in *; set (y := share ((w 0%nat + w 1%nat) * v)) in *.
  set (z := share ((w 0%nat + w 1%nat + w 2%nat) * v)) in *.
  replace (y - x - w 1%nat * v) with ((y - (w 0%nat + w 1%nat) * v) - (x - w 0%nat * v)) by ring.
  replace (z - y - w 2%nat * v) with
    ((z - (w 0%nat + w 1%nat + w 2%nat) * v) - (y - (w 0%nat + w 1%nat) * v)) by ring.
  replace ((if to_one then v else 0) - z - w 3%nat * v) with (- (z - (w 0%nat + w 1%nat + w 2%nat) * v))
    by (replace (w 3%nat) with (total to_one - w 0%nat - w 1%nat - w 2%nat) by lra;
        destruct to_one; simpl; ring).
  revert A B C; generalize (x - w 0%nat * v), (y - (w 0%nat + w 1%nat) * v),
    (z - (w 0%nat + w 1%nat + w 2%nat) * v); intros p q r A B C.
  rewrite Rabs_Ropp.
  pose proof (Rabs_triang q (- p)) as D; pose proof (Rabs_triang r (- q)) as F; rewrite Rabs_Ropp in D, F.
  unfold Rminus; lra.
Qed.

(** A layer of 16 points: one expansion along t, and four along u. *)
Lemma layer one_t one_u t u ku h : norm u <= ku -> S4 t = total one_t -> S4 u = total one_u ->
  S4 (fun m => S4 (fun n => Rabs (expanded share one_u u (expanded share one_t t h m) n - u n * (t m * h))))
  <= half * (6 * ku + 24).
Proof.
  intros Ku Total_t Total_u; assert (Nu := norm_nonneg u); assert (H0 := rounds_pos _ _ Half).
  pose (p m := expanded share one_t t h m).
  apply Rle_trans with (S4 (fun m => 6 * half + Rabs (p m - t m * h) * norm u)).
  - apply S4_le; intro m; fold (p m).
    apply Rle_trans with (S4 (fun n => Rabs (expanded share one_u u (p m) n - u n * p m)
      + Rabs (p m - t m * h) * Rabs (u n))).
    + apply S4_le; intro n; rewrite <- Rabs_mult.
      replace (expanded share one_u u (p m) n - u n * (t m * h)) with
        ((expanded share one_u u (p m) n - u n * p m) + (p m - t m * h) * u n) by ring.
      apply Rabs_triang.
    + rewrite S4_plus, S4_scale; apply Rplus_le_compat_r; apply (expansion one_u u (p m) Total_u).
  - rewrite S4_plus, S4_const, S4_scale_r.
    change (S4 (fun m => Rabs (p m - t m * h))) with (norm (fun m => p m - t m * h)).
    assert (E := expansion one_t t h Total_t).
    change (norm (fun b => expanded share one_t t h b - t b * h)) with (norm (fun m => p m - t m * h)) in E.
    assert (norm (fun m => p m - t m * h) * norm u <= 6 * half * ku).
    { apply Rmult_le_compat; try assumption; apply norm_nonneg. }
    lra.
Qed.

End Expansion.

Section Scatter.
Variables (ns nt nu es et eu a bound : R) (one_s one_t one_u : bool) (s t u bs bt bu : nat -> R) (g : R).
Variables (point share : R -> R) (given half : R).
Hypothesis V : weighted ns nt nu es et eu a s t u bs bt bu.
Hypotheses (Total_s : S4 s = total one_s) (Total_t : S4 t = total one_t) (Total_u : S4 u = total one_u).
Hypothesis G : Rabs g <= 1.
Hypotheses (Given : rounds point given) (Half : rounds share half).

Let H0 : 0 <= half. Proof. apply (rounds_pos _ _ Half). Qed.
Let I0 : 0 <= given. Proof. apply (rounds_pos _ _ Given). Qed.
Let ks := ns + es.
Let kt := nt + et.
Let ku := nu + eu.
Let Ks : norm s <= ks. Proof. destruct V; apply norm_within with bs; assumption. Qed.
Let Kt : norm t <= kt. Proof. destruct V; apply norm_within with bt; assumption. Qed.
Let Ku : norm u <= ku. Proof. destruct V; apply norm_within with bu; assumption. Qed.

Let v0 := point g.
Let x := expanded share one_s s v0.
Let y l := expanded share one_t t (x l).
Let z l m := expanded share one_u u (y l m).

Definition along_s_bound := a + given * (ks * kt * ku) + half * (6 * (kt * ku)).
Definition scatter_bound := a + given * (ks * kt * ku) + half * (6 * (kt * ku) + 24 * ku + 96).

(** What is expanded along s, with the weights that come behind it, is near the product of all three. *)
Lemma along_s : distance (fun l m n => u n * (t m * x l)) (fun l m n => g * products bs bt bu l m n) <= along_s_bound.
Proof.
  assert (Ns := norm_nonneg s); assert (Nt := norm_nonneg t); assert (Nu := norm_nonneg u).
  assert (K : 0 <= ku) by lra; assert (L : 0 <= kt) by lra.
  (* along s, of one *)
  assert (D3 : distance (fun l m n => u n * (t m * x l)) (fun l m n => products s t u l m n * v0)
    <= 6 * (kt * ku) * half).
  { apply Rle_trans with (sum3 (fun l m n => Rabs (x l - s l * v0) * Rabs (t m) * Rabs (u n))).
    - apply sum3_le; intros; unfold products; rewrite <- !Rabs_mult; right; f_equal; ring.
    - rewrite (sum3_product (fun l => Rabs (x l - s l * v0)) (fun m => Rabs (t m)) (fun n => Rabs (u n))).
      change (norm (fun l => x l - s l * v0) * norm t * norm u <= 6 * (kt * ku) * half).
      apply Rle_trans with (6 * half * kt * ku); [|right; ring].
      repeat apply Rmult_le_compat; try assumption; try apply Rmult_le_pos; try apply norm_nonneg;
        try assumption; apply (expansion share half Half one_s s v0 Total_s). }
  (* the gradient itself *)
  assert (D4 : distance (fun l m n => products s t u l m n * v0) (fun l m n => products s t u l m n * g)
    <= given * (ks * kt * ku)).
  { apply Rle_trans with (sum3 (fun l m n => given * Rabs (products s t u l m n))).
    - apply sum3_le; intros; rewrite <- Rmult_minus_distr_l, Rabs_mult, Rmult_comm.
      apply Rmult_le_compat_r; [apply Rabs_pos | apply Given].
    - rewrite sum3_scale, sum3_norm; apply Rmult_le_compat_l; [apply (rounds_pos _ _ Given)|].
      repeat apply Rmult_le_compat; try assumption; apply Rmult_le_pos; assumption. }
  (* and the weights *)
  assert (D5 : distance (fun l m n => products s t u l m n * g) (fun l m n => g * products bs bt bu l m n) <= a).
  { destruct V as [_ _ _ _ _ _ A]; apply Rle_trans with (2 := A); apply sum3_le; intros.
    replace (products s t u l m n * g - g * products bs bt bu l m n) with
      ((products s t u l m n - products bs bt bu l m n) * g) by ring.
    rewrite Rabs_mult; rewrite <- (Rmult_1_r (Rabs (products s t u l m n - products bs bt bu l m n))) at 2.
    apply Rmult_le_compat_l; [apply Rabs_pos | exact G]. }
  pose proof (distance_triangle (fun l m n => u n * (t m * x l)) (fun l m n => products s t u l m n * v0)
    (fun l m n => g * products bs bt bu l m n)).
  pose proof (distance_triangle (fun l m n => products s t u l m n * v0)
    (fun l m n => products s t u l m n * g) (fun l m n => g * products bs bt bu l m n)).
  unfold along_s_bound; lra.
Qed.

Theorem scatter_certified : scatter_bound <= bound ->
  distance (scatter_program one_s one_t one_u s t u g point share) (fun l m n => g * products bs bt bu l m n)
    <= bound.
Proof.
  intro B; apply Rle_trans with (2 := B).
  assert (D : distance z (fun l m n => u n * (t m * x l)) <= 4 * (half * (6 * ku + 24))).
  { unfold distance, sum3; rewrite <- S4_const; apply S4_le; intro l.
    apply (layer share half Half one_t one_u t u ku (x l)); assumption. }
  change (distance z (fun l m n => g * products bs bt bu l m n) <= scatter_bound).
  pose proof (distance_triangle z (fun l m n => u n * (t m * x l)) (fun l m n => g * products bs bt bu l m n)).
  pose proof along_s.
  unfold scatter_bound; unfold along_s_bound in *; lra.
Qed.
End Scatter.

(** Rows: parts of the vertices of a row are summed for each layer along s, and the sums are expanded along
    t and u, whose weights the row shares. *)

(** The sum of f over 0 to d - 1, and of f over a list. *)
Fixpoint under (d : nat) (f : nat -> R) : R := match d with O => 0 | S k => under k f + f k end.
Definition over {A} (f : A -> R) (vertices : list A) : R := List.fold_right (fun v rest => f v + rest) 0 vertices.

Lemma over_cons {A} (f : A -> R) v rest : over f (v :: rest) = f v + over f rest.
Proof. reflexivity. Qed.

Lemma over_le {A} (f : A -> R) c vertices :
  Forall (fun v => f v <= c) vertices -> over f vertices <= INR (length vertices) * c.
Proof.
  induction 1 as [|v rest H _ I]; [unfold over; simpl; lra|].
  change (length (v :: rest)) with (S (length rest)); rewrite over_cons, S_INR; lra.
Qed.

Lemma under_le d f g : (forall i, f i <= g i) -> under d f <= under d g.
Proof. intro H; induction d as [|d I]; simpl; [lra|]; specialize (H d); lra. Qed.

Lemma under_plus d f g : under d (fun i => f i + g i) = under d f + under d g.
Proof. induction d as [|d I]; simpl; [ring|]; rewrite I; ring. Qed.

Lemma under_const d c : under d (fun _ => c) = INR d * c.
Proof. induction d as [|d I]; [simpl; ring|]; rewrite S_INR; simpl under; rewrite I; ring. Qed.

Lemma under_over {A} d (f : A -> nat -> R) vertices :
  under d (fun i => over (fun v => f v i) vertices) = over (fun v => under d (f v)) vertices.
Proof.
  induction vertices as [|v rest I]; simpl; [rewrite under_const; ring|].
  change (under d (fun i => f v i + over (fun w => f w i) rest) = under d (f v) + over (fun w => under d (f w)) rest).
  rewrite under_plus, I; reflexivity.
Qed.

(** A vertex adds its four numbers to the layers from its cell on. *)
Definition placed (o : nat) (f : nat -> R) (i : nat) : R :=
  if andb (Nat.leb o i) (Nat.ltb i (o + 4)) then f (i - o)%nat else 0.

Lemma placed_outside o f d : (d <= o)%nat -> under d (placed o f) = 0.
Proof.
  intro H; induction d as [|d I]; simpl; [reflexivity|]; rewrite I by lia.
  unfold placed; replace (Nat.leb o d) with false by (symmetry; apply Nat.leb_gt; lia); simpl; ring.
Qed.

Lemma placed_after o f k : under (o + 4 + k) (placed o f) = S4 f.
Proof.
  induction k as [|k I].
  - replace (o + 4 + 0)%nat with (S (S (S (S o)))) by lia; simpl under; rewrite placed_outside by lia.
    unfold placed, S4.
    replace (Nat.leb o o) with true by (symmetry; apply Nat.leb_le; lia).
    replace (Nat.leb o (S o)) with true by (symmetry; apply Nat.leb_le; lia).
    replace (Nat.leb o (S (S o))) with true by (symmetry; apply Nat.leb_le; lia).
    replace (Nat.leb o (S (S (S o)))) with true by (symmetry; apply Nat.leb_le; lia).
    replace (Nat.ltb o (o + 4)) with true by (symmetry; apply Nat.ltb_lt; lia).
    replace (Nat.ltb (S o) (o + 4)) with true by (symmetry; apply Nat.ltb_lt; lia).
    replace (Nat.ltb (S (S o)) (o + 4)) with true by (symmetry; apply Nat.ltb_lt; lia).
    replace (Nat.ltb (S (S (S o))) (o + 4)) with true by (symmetry; apply Nat.ltb_lt; lia).
    cbn [andb].
    replace (o - o)%nat with 0%nat by lia; replace (S o - o)%nat with 1%nat by lia.
    replace (S (S o) - o)%nat with 2%nat by lia; replace (S (S (S o)) - o)%nat with 3%nat by lia; ring.
  - replace (o + 4 + S k)%nat with (S (o + 4 + k)) by lia; simpl under; rewrite I.
    unfold placed; replace (Nat.ltb (o + 4 + k) (o + 4)) with false by (symmetry; apply Nat.ltb_ge; lia).
    rewrite Bool.andb_false_r; ring.
Qed.

Lemma placed_sum o f d : (o + 4 <= d)%nat -> under d (placed o f) = S4 f.
Proof. intro H; replace d with (o + 4 + (d - (o + 4)))%nat by lia; apply placed_after. Qed.

(** A vertex of a row: the layer of its cell, its weights and functions of s, and its gradient. *)
Record in_row := { cell : nat; weights : nat -> R; functions : nat -> R; gradient : R }.

Section Rows.
Variables (ns nt nu es et eu a bound : R) (one_s one_t one_u : bool) (t u bt bu : nat -> R).
Variables (point share : R -> R) (given half : R) (d : nat) (vertices : list in_row).

Definition good (v : in_row) := (cell v + 4 <= d)%nat /\ S4 (weights v) = total one_s /\ Rabs (gradient v) <= 1 /\
  weighted ns nt nu es et eu a (weights v) t u (functions v) bt bu.

Hypothesis Good : List.Forall good vertices.
Hypotheses (Total_t : S4 t = total one_t) (Total_u : S4 u = total one_u).
Hypotheses (Given : rounds point given) (Half : rounds share half).

Definition row_sum i := over (fun v => placed (cell v) (expanded share one_s (weights v) (point (gradient v))) i) vertices.
Definition row_program i m n := expanded share one_u u (expanded share one_t t (row_sum i) m) n.
Definition row_exact i m n :=
  over (fun v => placed (cell v) (fun l => gradient v * products (functions v) bt bu l m n) i) vertices.
Definition row_distance := under d (fun i => S4 (fun m => S4 (fun n => Rabs (row_program i m n - row_exact i m n)))).
Let ks := ns + es.
Let kt := nt + et.
Let ku := nu + eu.
Definition row_bound := INR (length vertices) * (a + given * (ks * kt * ku) + half * (6 * (kt * ku)))
  + INR d * (half * (6 * ku + 24)).

Let part v l m n := u n * (t m * expanded share one_s (weights v) (point (gradient v)) l)
  - gradient v * products (functions v) bt bu l m n.

Lemma parts i m n : u n * (t m * row_sum i) - row_exact i m n =
  over (fun v => placed (cell v) (fun l => part v l m n) i) vertices.
Proof.
  unfold row_sum, row_exact; clear Good; induction vertices as [|v rest I]; [unfold over; simpl; ring|].
  rewrite !over_cons, <- I; unfold placed, part.
  destruct (andb (Nat.leb (cell v) i) (Nat.ltb i (cell v + 4))); ring.
Qed.

Lemma parts_of_a_layer i :
  S4 (fun m => S4 (fun n => Rabs (u n * (t m * row_sum i) - row_exact i m n))) <=
  over (fun v => placed (cell v) (fun l => S4 (fun m => S4 (fun n => Rabs (part v l m n)))) i) vertices.
Proof.
  apply Rle_trans with (S4 (fun m => S4 (fun n => over (fun v => placed (cell v) (fun l => Rabs (part v l m n)) i) vertices))).
  - apply S4_le; intro m; apply S4_le; intro n; rewrite parts; clear Good.
    induction vertices as [|v rest I]; [unfold over; simpl; rewrite Rabs_R0; lra|]; rewrite !over_cons.
    apply Rle_trans with (1 := Rabs_triang _ _); apply Rplus_le_compat; [|exact I].
    unfold placed; destruct (andb (Nat.leb (cell v) i) (Nat.ltb i (cell v + 4))); [|rewrite Rabs_R0]; lra.
  - clear Good; right; induction vertices as [|v rest I]; [unfold over, S4; simpl; ring|].
    rewrite over_cons, (S4_ext _ (fun m => S4 (fun n => placed (cell v) (fun l => Rabs (part v l m n)) i)
      + S4 (fun n => over (fun w => placed (cell w) (fun l => Rabs (part w l m n)) i) rest)))
      by (intro m; apply S4_plus).
    rewrite S4_plus, I; f_equal; unfold placed.
    destruct (andb (Nat.leb (cell v) i) (Nat.ltb i (cell v + 4))); [reflexivity|unfold S4; ring].
Qed.

Lemma row_certified : norm u <= ku -> row_distance <= row_bound.
Proof.
  intro Ku; unfold row_distance, row_bound.
  apply Rle_trans with (under d (fun i => over (fun v => placed (cell v)
    (fun l => S4 (fun m => S4 (fun n => Rabs (part v l m n)))) i) vertices + half * (6 * ku + 24))).
  - apply under_le; intro i.
    pose proof (layer share half Half one_t one_u t u ku (row_sum i) Ku Total_t Total_u) as L.
    pose proof (parts_of_a_layer i) as P.
    apply Rle_trans with (S4 (fun m => S4 (fun n => Rabs (row_program i m n - u n * (t m * row_sum i))))
      + S4 (fun m => S4 (fun n => Rabs (u n * (t m * row_sum i) - row_exact i m n)))).
    + rewrite <- S4_plus; apply S4_le; intro m; rewrite <- S4_plus; apply S4_le; intro n.
      replace (row_program i m n - row_exact i m n) with
        ((row_program i m n - u n * (t m * row_sum i)) + (u n * (t m * row_sum i) - row_exact i m n)) by ring.
      apply Rabs_triang.
    + unfold row_program; lra.
  - rewrite under_plus, under_const, under_over; apply Rplus_le_compat_r.
    apply over_le; apply Forall_impl with (2 := Good); intros v (C & S & B & W).
    apply Rle_trans with (S4 (fun l => S4 (fun m => S4 (fun n => Rabs (part v l m n))))).
    + right; apply (placed_sum (cell v) (fun l => S4 (fun m => S4 (fun n => Rabs (part v l m n)))) d C).
    + apply (along_s ns nt nu es et eu a one_s (weights v) t u (functions v) bt bu (gradient v) point share
        given half W S B Given Half).
Qed.

(** A row of vertices that has no more layers than they have by themselves is off by no more than they are. *)
Theorem rows_certified : norm u <= ku -> (d <= 4 * length vertices)%nat ->
  scatter_bound ns nt nu es et eu a given half <= bound -> row_distance <= INR (length vertices) * bound.
Proof.
  intros Ku D B; apply Rle_trans with (1 := row_certified Ku); unfold row_bound.
  assert (H := rounds_pos _ _ Half); assert (N := norm_nonneg u).
  assert (L : INR d <= 4 * INR (length vertices)).
  { replace 4 with (INR 4) by (simpl; ring); rewrite <- mult_INR; apply le_INR, D. }
  assert (P : 0 <= half * (6 * ku + 24)) by (apply Rmult_le_pos; lra).
  apply Rle_trans with (INR (length vertices) * scatter_bound ns nt nu es et eu a given half).
  - unfold scatter_bound; fold ks kt ku.
    assert (INR d * (half * (6 * ku + 24)) <= 4 * INR (length vertices) * (half * (6 * ku + 24)))
      by (apply Rmult_le_compat_r; assumption).
    lra.
  - apply Rmult_le_compat_l; [apply pos_INR | exact B].
Qed.
End Rows.
