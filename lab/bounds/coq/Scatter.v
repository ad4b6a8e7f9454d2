(* Scatter, the transpose of `affine`: a gradient among 64 banks, one axis after the other. A bank gets
   the difference of two cumulative products, each rounded; differences are exact where nothing
   saturates, which the B-spline never does.
   SPDX-License-Identifier: Apache-2.0 *)
Require Import Reals Lra Sums Programs Certified.
Open Scope R_scope.

Section Scatter.
Variables (e a bound : R) (s t u bs bt bu : nat -> R) (P : nat -> nat -> nat -> R) (g : R).
Variables (point share : R -> R) (given half : R).
Hypothesis V : vertex e a s t u bs bt bu P.
Hypotheses (Ones : S4 s = 1) (Onet : S4 t = 1) (Oneu : S4 u = 1).
Hypothesis G : Rabs g <= 1.
Hypotheses (Given : rounds point given) (Half : rounds share half).

Let H0 : 0 <= half. Proof. apply (rounds_pos _ _ Half). Qed.
Let E0 : 0 <= e.
Proof. apply Rle_trans with (2 := weights_s _ _ _ _ _ _ _ _ _ V); apply norm_nonneg. Qed.
Let k := 1 + e.
Let Ks : norm s <= k. Proof. destruct V; apply norm_of_error with bs; assumption. Qed.
Let Kt : norm t <= k. Proof. destruct V; apply norm_of_error with bt; assumption. Qed.
Let Ku : norm u <= k. Proof. destruct V; apply norm_of_error with bu; assumption. Qed.

(** Each of three roundings moves something from a bank to the next. *)
Lemma expansion w v : S4 w = 1 -> norm (fun b => expanded share w v b - w b * v) <= 6 * half.
Proof.
  unfold norm, S4, expanded; intro W.
  pose proof (Half (w 0%nat * v)) as A; pose proof (Half ((w 0%nat + w 1%nat) * v)) as B.
  pose proof (Half ((w 0%nat + w 1%nat + w 2%nat) * v)) as C.
  set (x := share (w 0%nat * v)) in *; set (y := share ((w 0%nat + w 1%nat) * v)) in *.
  set (z := share ((w 0%nat + w 1%nat + w 2%nat) * v)) in *.
  replace (y - x - w 1%nat * v) with ((y - (w 0%nat + w 1%nat) * v) - (x - w 0%nat * v)) by ring.
  replace (z - y - w 2%nat * v) with
    ((z - (w 0%nat + w 1%nat + w 2%nat) * v) - (y - (w 0%nat + w 1%nat) * v)) by ring.
  replace (v - z - w 3%nat * v) with (- (z - (w 0%nat + w 1%nat + w 2%nat) * v))
    by (replace (w 3%nat) with (1 - w 0%nat - w 1%nat - w 2%nat) by lra; ring).
  revert A B C; generalize (x - w 0%nat * v), (y - (w 0%nat + w 1%nat) * v),
    (z - (w 0%nat + w 1%nat + w 2%nat) * v); intros p q r A B C.
  rewrite Rabs_Ropp.
  pose proof (Rabs_triang q (- p)) as D; pose proof (Rabs_triang r (- q)) as F; rewrite Rabs_Ropp in D, F.
  unfold Rminus; lra.
Qed.

Let v0 := point g.
Let x := expanded share s v0.
Let y l := expanded share t (x l).
Let z l m := expanded share u (y l m).

Definition scatter_bound := a + given * (k * k * k) + half * (6 * (k * k) + 24 * k + 96).

Theorem scatter_certified : scatter_bound <= bound ->
  distance (scatter_program s t u g point share) (fun l m n => g * products bs bt bu l m n) <= bound.
Proof.
  intro B; apply Rle_trans with (2 := B).
  assert (K : 0 <= k) by (unfold k; lra).
  assert (Ns := norm_nonneg s); assert (Nt := norm_nonneg t); assert (Nu := norm_nonneg u).
  (* along u, of 16 parts *)
  assert (D1 : distance z (fun l m n => u n * y l m) <= 96 * half).
  { unfold distance, sum3.
    apply Rle_trans with (S4 (fun _ => S4 (fun _ => 6 * half))).
    - apply S4_le; intro l; apply S4_le; intro m; apply (expansion u (y l m) Oneu).
    - rewrite !S4_const; lra. }
  (* along t, of four *)
  assert (D2 : distance (fun l m n => u n * y l m) (fun l m n => u n * (t m * x l)) <= 24 * k * half).
  { apply Rle_trans with (norm u * (4 * (6 * half))).
    - unfold distance, sum3.
      apply Rle_trans with (S4 (fun _ => 6 * half * norm u)).
      + apply S4_le; intro l.
        apply Rle_trans with (norm (fun m => y l m - t m * x l) * norm u).
        * unfold norm at 1; rewrite <- S4_scale_r; right; apply S4_ext; intro m.
          unfold norm; rewrite <- S4_scale; apply S4_ext; intro n.
          rewrite <- Rabs_mult; f_equal; ring.
        * apply Rmult_le_compat_r; [exact Nu|]; apply (expansion t (x l) Onet).
      + rewrite S4_const; right; ring.
    - apply Rle_trans with (k * (4 * (6 * half))); [|right; ring].
      apply Rmult_le_compat_r; lra. }
  (* along s, of one *)
  assert (D3 : distance (fun l m n => u n * (t m * x l)) (fun l m n => products s t u l m n * v0)
    <= 6 * (k * k) * half).
  { apply Rle_trans with (sum3 (fun l m n => Rabs (x l - s l * v0) * Rabs (t m) * Rabs (u n))).
    - apply sum3_le; intros; unfold products; rewrite <- !Rabs_mult; right; f_equal; ring.
    - rewrite (sum3_product (fun l => Rabs (x l - s l * v0)) (fun m => Rabs (t m)) (fun n => Rabs (u n))).
      change (norm (fun l => x l - s l * v0) * norm t * norm u <= 6 * (k * k) * half).
      apply Rle_trans with (6 * half * k * k); [|right; ring].
      repeat apply Rmult_le_compat; try assumption; try apply Rmult_le_pos; try apply norm_nonneg;
        try assumption; apply (expansion s v0 Ones). }
  (* the gradient itself *)
  assert (D4 : distance (fun l m n => products s t u l m n * v0) (fun l m n => products s t u l m n * g)
    <= given * (k * k * k)).
  { apply Rle_trans with (sum3 (fun l m n => given * Rabs (products s t u l m n))).
    - apply sum3_le; intros; rewrite <- Rmult_minus_distr_l, Rabs_mult, Rmult_comm.
      apply Rmult_le_compat_r; [apply Rabs_pos | apply Given].
    - rewrite sum3_scale, sum3_norm; apply Rmult_le_compat_l; [apply (rounds_pos _ _ Given)|].
      repeat apply Rmult_le_compat; try assumption; apply Rmult_le_pos; assumption. }
  (* and the weights *)
  assert (D5 : distance (fun l m n => products s t u l m n * g) (fun l m n => g * products bs bt bu l m n) <= a).
  { destruct V; apply Rle_trans with (2 := weights_all); apply sum3_le; intros.
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
