(* Scatter, the transpose of `affine`: a gradient among 64 banks, one axis after the other. A bank gets
   the difference of two cumulative products, each rounded; differences are exact where nothing
   saturates, which the B-spline never does.
   SPDX-License-Identifier: Apache-2.0 *)
Require Import Reals Lra Sums Programs Certified.
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

Let v0 := point g.
Let x := expanded share one_s s v0.
Let y l := expanded share one_t t (x l).
Let z l m := expanded share one_u u (y l m).

Definition scatter_bound := a + given * (ks * kt * ku) + half * (6 * (kt * ku) + 24 * ku + 96).

Theorem scatter_certified : scatter_bound <= bound ->
  distance (scatter_program one_s one_t one_u s t u g point share) (fun l m n => g * products bs bt bu l m n)
    <= bound.
Proof.
  intro B; apply Rle_trans with (2 := B).
  assert (Ns := norm_nonneg s); assert (Nt := norm_nonneg t); assert (Nu := norm_nonneg u).
  assert (K : 0 <= ku) by lra; assert (L : 0 <= kt) by lra.
  (* along u, of 16 parts *)
  assert (D1 : distance z (fun l m n => u n * y l m) <= 96 * half).
  { unfold distance, sum3.
    apply Rle_trans with (S4 (fun _ => S4 (fun _ => 6 * half))).
    - apply S4_le; intro l; apply S4_le; intro m; apply (expansion one_u u (y l m) Total_u).
    - rewrite !S4_const; lra. }
  (* along t, of four *)
  assert (D2 : distance (fun l m n => u n * y l m) (fun l m n => u n * (t m * x l)) <= 24 * ku * half).
  { apply Rle_trans with (norm u * (4 * (6 * half))).
    - unfold distance, sum3.
      apply Rle_trans with (S4 (fun _ => 6 * half * norm u)).
      + apply S4_le; intro l.
        apply Rle_trans with (norm (fun m => y l m - t m * x l) * norm u).
        * unfold norm at 1; rewrite <- S4_scale_r; right; apply S4_ext; intro m.
          unfold norm; rewrite <- S4_scale; apply S4_ext; intro n.
          rewrite <- Rabs_mult; f_equal; ring.
        * apply Rmult_le_compat_r; [exact Nu|]; apply (expansion one_t t (x l) Total_t).
      + rewrite S4_const; right; ring.
    - apply Rle_trans with (ku * (4 * (6 * half))); [|right; ring].
      apply Rmult_le_compat_r; lra. }
  (* along s, of one *)
  assert (D3 : distance (fun l m n => u n * (t m * x l)) (fun l m n => products s t u l m n * v0)
    <= 6 * (kt * ku) * half).
  { apply Rle_trans with (sum3 (fun l m n => Rabs (x l - s l * v0) * Rabs (t m) * Rabs (u n))).
    - apply sum3_le; intros; unfold products; rewrite <- !Rabs_mult; right; f_equal; ring.
    - rewrite (sum3_product (fun l => Rabs (x l - s l * v0)) (fun m => Rabs (t m)) (fun n => Rabs (u n))).
      change (norm (fun l => x l - s l * v0) * norm t * norm u <= 6 * (kt * ku) * half).
      apply Rle_trans with (6 * half * kt * ku); [|right; ring].
      repeat apply Rmult_le_compat; try assumption; try apply Rmult_le_pos; try apply norm_nonneg;
        try assumption; apply (expansion one_s s v0 Total_s). }
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
  change (distance z (fun l m n => g * products bs bt bu l m n) <= scatter_bound).
  pose proof (distance_triangle z (fun l m n => u n * y l m) (fun l m n => g * products bs bt bu l m n)).
  pose proof (distance_triangle (fun l m n => u n * y l m) (fun l m n => u n * (t m * x l))
    (fun l m n => g * products bs bt bu l m n)).
  pose proof (distance_triangle (fun l m n => u n * (t m * x l)) (fun l m n => products s t u l m n * v0)
    (fun l m n => g * products bs bt bu l m n)).
  pose proof (distance_triangle (fun l m n => products s t u l m n * v0)
    (fun l m n => products s t u l m n * g) (fun l m n => g * products bs bt bu l m n)).
  unfold scatter_bound; lra.
Qed.
End Scatter.
