(* Fixed point: `factored` (and `affine`, whose bits are those of `factored` with its own last weight)
   and the product form. A rounding is whatever is off by at most half a unit; sums are exact.
   SPDX-License-Identifier: Apache-2.0 *)
Require Import Reals Lra Sums.
Open Scope R_scope.

Section Forms.
Variables (s t u bs bt bu : nat -> R) (e : R).  (* weights, functions, error of an axis *)
Variables (p P : nat -> nat -> nat -> R).  (* points rounded and as given *)
Variables (given half out : R).  (* what rounds points, narrowed sums, the result *)
Hypotheses (E0 : 0 <= e) (H0 : 0 <= half) (I0 : 0 <= given).
Hypotheses (Bs : norm bs <= 1) (Bt : norm bt <= 1) (Bu : norm bu <= 1).
Hypotheses (Es : norm (fun i => s i - bs i) <= e) (Et : norm (fun i => t i - bt i) <= e)
  (Eu : norm (fun i => u i - bu i) <= e).
Hypothesis Points : forall l m n, Rabs (P l m n) <= 1.
Hypothesis Rounded : forall l m n, Rabs (p l m n - P l m n) <= given.

Let g := 1 + e.
Let Gs : norm s <= g. Proof. apply norm_of_error with bs; assumption. Qed.
Let Gt : norm t <= g. Proof. apply norm_of_error with bt; assumption. Qed.
Let Gu : norm u <= g. Proof. apply norm_of_error with bu; assumption. Qed.

(** One axis after the other, each sum but the last narrowed to a point. *)
Definition factored_bound a := a + given * (g * g * g) + half * (g * g + g) + out.

Theorem factored (a : R) (x : nat -> nat -> R) (y : nat -> R) (q : R) :
  distance (products s t u) (products bs bt bu) <= a ->
  (forall l m, Rabs (x l m - S4 (fun n => u n * p l m n)) <= half) ->
  (forall l, Rabs (y l - S4 (fun m => t m * x l m)) <= half) ->
  Rabs (q - S4 (fun l => s l * y l)) <= out ->
  Rabs (q - eq1 bs bt bu P) <= factored_bound a.
Proof.
  intros A X Y Q.
  assert (G : 0 <= g) by (unfold g; lra).
  assert (M : forall b, 0 <= b -> 0 <= g * b) by (intros; apply Rmult_le_pos; assumption).
  assert (D1 : Rabs (S4 (fun l => s l * y l) - S4 (fun l => s l * S4 (fun m => t m * x l m))) <= g * half)
    by (apply axis_difference; assumption).
  assert (D2 : Rabs (S4 (fun l => s l * S4 (fun m => t m * x l m)) - eq1 s t u p) <= g * (g * half)).
  { apply axis_difference; auto; intro l; apply axis_difference; auto. }
  assert (D3 : Rabs (eq1 s t u p - eq1 s t u P) <= g * (g * (g * given))).
  { do 2 (apply axis_difference; auto; intro); apply axis_difference; auto. }
  assert (D4 : Rabs (eq1 s t u P - eq1 bs bt bu P) <= a).
  { rewrite !eq1_flat; apply (weighted_difference (products s t u) (products bs bt bu)); assumption. }
  assert (T : forall d1 d2 d3 d4 d5 d6 : R, Rabs (d1 - d6) <=
    Rabs (d1 - d2) + Rabs (d2 - d3) + Rabs (d3 - d4) + Rabs (d4 - d5) + Rabs (d5 - d6)).
  { intros; unfold Rabs; repeat destruct Rcase_abs; lra. }
  pose proof (T q _ _ _ _ _ : Rabs (q - eq1 bs bt bu P) <= Rabs (q - S4 (fun l => s l * y l))
    + Rabs (S4 (fun l => s l * y l) - S4 (fun l => s l * S4 (fun m => t m * x l m)))
    + Rabs (S4 (fun l => s l * S4 (fun m => t m * x l m)) - eq1 s t u p)
    + Rabs (eq1 s t u p - eq1 s t u P) + Rabs (eq1 s t u P - eq1 bs bt bu P)).
  unfold factored_bound.
  replace (given * (g * g * g) + half * (g * g + g)) with
    (g * half + g * (g * half) + g * (g * (g * given))) by ring.
  lra.
Qed.

(** Products of weights, rounded twice, then 64 exact terms. *)
Variable unit2 : R.  (* half a unit of a weight *)
Hypothesis U0 : 0 <= unit2.
Variables (c : nat -> nat -> R) (d : nat -> nat -> nat -> R).
Hypothesis C : forall l m, Rabs (c l m - s l * t m) <= unit2.
Hypothesis D : forall l m n, Rabs (d l m n - c l m * u n) <= unit2.

Definition pair_distance := S4 (fun l => S4 (fun m => Rabs (c l m - bs l * bt m))).

(** From the errors of two axes, or of three, alone. *)
Definition pair_of_axes := 16 * unit2 + (g * g - 1).
Definition product_distance a := a + 16 * unit2 * g + 64 * unit2.
Definition product_distance_of_pair r := 64 * unit2 + r * g + e.
Definition product_bound r := r + (1 + r) * given + out.

Lemma last_rounding : distance d (fun l m n => c l m * u n) <= 64 * unit2.
Proof. rewrite <- sum3_const; apply sum3_le; exact D. Qed.

Lemma by_triple a : distance (products s t u) (products bs bt bu) <= a ->
  distance d (products bs bt bu) <= product_distance a.
Proof.
  intro A; pose proof last_rounding as D1.
  assert (D2 : distance (fun l m n => c l m * u n) (products s t u) <= 16 * unit2 * g).
  { apply Rle_trans with (sum3 (fun l m n => (fun _ : nat => unit2) l * (fun _ : nat => 1) m * Rabs (u n))).
    - apply sum3_le; intros; unfold products; rewrite <- Rmult_minus_distr_r, Rabs_mult, Rmult_1_r.
      apply Rmult_le_compat_r; [apply Rabs_pos | apply C].
    - rewrite sum3_product, !S4_const; fold (norm u).
      apply Rle_trans with (16 * unit2 * norm u); [right; ring|].
      apply Rmult_le_compat_l; lra. }
  pose proof (distance_triangle d (fun l m n => c l m * u n) (products bs bt bu)).
  pose proof (distance_triangle (fun l m n => c l m * u n) (products s t u) (products bs bt bu)).
  unfold product_distance; lra.
Qed.

Lemma by_pair r : pair_distance <= r -> distance d (products bs bt bu) <= product_distance_of_pair r.
Proof.
  intro R; pose proof last_rounding as D1.
  pose proof (norm_nonneg bs); pose proof (norm_nonneg bt); pose proof (norm_nonneg u).
  assert (R0 : 0 <= pair_distance).
  { apply S4_nonneg; intro; apply S4_nonneg; intro; apply Rabs_pos. }
  assert (D2 : distance (fun l m n => c l m * u n) (products bs bt bu)
    <= pair_distance * norm u + norm bs * norm bt * norm (fun i => u i - bu i)).
  { apply Rle_trans with (sum3 (fun l m n => Rabs (c l m - bs l * bt m) * Rabs (u n))
      + sum3 (fun l m n => Rabs (bs l) * Rabs (bt m) * Rabs (u n - bu n))).
    - unfold distance; rewrite <- sum3_plus; apply sum3_le; intros; unfold products.
      rewrite <- !Rabs_mult.
      replace (c l m * u n - bs l * bt m * bu n) with
        ((c l m - bs l * bt m) * u n + bs l * bt m * (u n - bu n)) by ring.
      apply Rabs_triang.
    - rewrite (sum3_product (fun l => Rabs (bs l)) (fun m => Rabs (bt m)) (fun n => Rabs (u n - bu n))).
      apply Rplus_le_compat_r; right; unfold sum3, pair_distance, norm.
      rewrite <- S4_scale_r; apply S4_ext; intro l.
      rewrite <- S4_scale_r; apply S4_ext; intro m; apply S4_scale. }
  assert (D3 : pair_distance * norm u <= r * g) by (apply Rmult_le_compat; lra).
  assert (D4 : norm bs * norm bt * norm (fun i => u i - bu i) <= 1 * 1 * e).
  { repeat apply Rmult_le_compat; try assumption; try apply Rmult_le_pos; try assumption; apply norm_nonneg. }
  pose proof (distance_triangle d (fun l m n => c l m * u n) (products bs bt bu)).
  unfold product_distance_of_pair; lra.
Qed.

Theorem product (r q : R) : distance d (products bs bt bu) <= r ->
  Rabs (q - sum3 (fun l m n => d l m n * p l m n)) <= out ->
  Rabs (q - eq1 bs bt bu P) <= product_bound r.
Proof.
  intros N Q.
  assert (R0 : norm bs * norm bt * norm bu <= 1).
  { replace 1 with (1 * 1 * 1) by ring.
    repeat apply Rmult_le_compat; try assumption; try apply Rmult_le_pos; apply norm_nonneg. }
  assert (M : sum3 (fun l m n => Rabs (d l m n)) <= 1 + r).
  { apply Rle_trans with (sum3 (fun l m n => Rabs (products bs bt bu l m n)) + distance d (products bs bt bu)).
    - unfold distance; rewrite <- sum3_plus; apply sum3_le; intros.
      replace (d l m n) with (products bs bt bu l m n + (d l m n - products bs bt bu l m n)) at 1 by ring.
      apply Rabs_triang.
    - rewrite sum3_norm; lra. }
  assert (D1 : Rabs (sum3 (fun l m n => d l m n * p l m n) - sum3 (fun l m n => d l m n * P l m n))
    <= (1 + r) * given).
  { rewrite <- sum3_minus; apply Rle_trans with (1 := sum3_abs _).
    apply Rle_trans with (given * sum3 (fun l m n => Rabs (d l m n))).
    - rewrite <- sum3_scale; apply sum3_le; intros.
      rewrite <- Rmult_minus_distr_l, Rabs_mult, Rmult_comm.
      apply Rmult_le_compat_r; [apply Rabs_pos | apply Rounded].
    - rewrite (Rmult_comm (1 + r)); apply Rmult_le_compat_l; assumption. }
  pose proof (weighted_difference d (products bs bt bu) P r N Points) as D2.
  rewrite eq1_flat; unfold product_bound.
  change (fun l m n => bs l * bt m * bu n * P l m n) with (fun l m n => products bs bt bu l m n * P l m n).
  revert Q D1 D2; unfold Rabs; repeat destruct Rcase_abs; lra.
Qed.
End Forms.
