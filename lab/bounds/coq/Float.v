(* binary32: sums in any order, of terms that are rounded or fused, and the product form over them.
   A rounding is off by at most eps of its magnitude and eta, which is for what underflows.
   SPDX-License-Identifier: Apache-2.0 *)
Require Import Reals Lra Lia Sums.
Open Scope R_scope.

Section Sums.
Variables (rnd : R -> R) (eps eta : R).
Hypotheses (Eps : 0 <= eps) (Eta : 0 <= eta).
Hypothesis Rnd : forall v, Rabs (rnd v - v) <= eps * Rabs v + eta.

Inductive sum := Term (v : R) | Plus (a b : sum) | Rounded (a : sum).

Fixpoint exact a := match a with Term v => v | Plus b c => exact b + exact c | Rounded b => exact b end.
Fixpoint computed a :=
  match a with Term v => v | Plus b c => computed b + computed c | Rounded b => rnd (computed b) end.
Fixpoint magnitude a :=
  match a with Term v => Rabs v | Plus b c => magnitude b + magnitude c | Rounded b => magnitude b end.
(** Roundings that a term meets at most, and those of all. *)
Fixpoint deep a := match a with Term _ => O | Plus b c => max (deep b) (deep c) | Rounded b => S (deep b) end.
Fixpoint count a := match a with Term _ => 0 | Plus b c => count b + count c | Rounded b => count b + 1 end.

Definition growth d := (1 + eps) ^ d.

Lemma growth_1 d : 1 <= growth d.
Proof. apply pow_R1_Rle; lra. Qed.

Lemma growth_le d d' : (d <= d')%nat -> growth d <= growth d'.
Proof. intro; apply Rle_pow; [lra | assumption]. Qed.

Lemma magnitude_pos a : 0 <= magnitude a.
Proof. induction a; simpl; [apply Rabs_pos | lra | assumption]. Qed.

Lemma count_pos a : 0 <= count a.
Proof. induction a; simpl; lra. Qed.

Lemma exact_magnitude a : Rabs (exact a) <= magnitude a.
Proof.
  induction a; simpl; [right; reflexivity | | assumption].
  pose proof (Rabs_triang (exact a1) (exact a2)); lra.
Qed.

Lemma one_rounding e m g c v x : Rabs x <= m -> 0 <= m -> 1 <= g -> 0 <= c ->
  Rabs (v - x) <= (g - 1) * m + c * g * eta -> e = Rabs (rnd v - x) ->
  e <= ((1 + eps) * g - 1) * m + (c + 1) * ((1 + eps) * g) * eta.
Proof.
  intros X M G C D ->.
  pose proof (Rnd v) as N.
  assert (V : Rabs v <= m + ((g - 1) * m + c * g * eta)).
  { apply Rle_trans with (Rabs x + Rabs (v - x)); [|lra].
    replace v with (x + (v - x)) at 1 by ring; apply Rabs_triang. }
  assert (T : Rabs (rnd v - x) <= Rabs (rnd v - v) + Rabs (v - x)).
  { replace (rnd v - x) with ((rnd v - v) + (v - x)) by ring; apply Rabs_triang. }
  apply (Rmult_le_compat_l eps) in V; [|exact Eps].
  assert (0 <= eta * ((1 + eps) * g - 1)).
  { apply Rmult_le_pos; [exact Eta|]. assert (0 <= eps * g) by (apply Rmult_le_pos; lra). lra. }
  apply Rle_trans with (eps * (m + ((g - 1) * m + c * g * eta)) + eta + ((g - 1) * m + c * g * eta)); [lra|].
  apply Rle_trans with (((1 + eps) * g - 1) * m + c * ((1 + eps) * g) * eta + eta); [right; ring|lra].
Qed.

Theorem sum_error a d : (deep a <= d)%nat ->
  Rabs (computed a - exact a) <= (growth d - 1) * magnitude a + count a * growth d * eta.
Proof.
  revert d; induction a as [v | b IHb c IHc | b IHb]; intros d D; simpl in *.
  - rewrite Rminus_diag_eq, Rabs_R0 by reflexivity.
    pose proof (growth_1 d); pose proof (Rabs_pos v).
    assert (0 <= (growth d - 1) * Rabs v) by (apply Rmult_le_pos; lra); lra.
  - pose proof (IHb d ltac:(lia)); pose proof (IHc d ltac:(lia)).
    replace (computed b + computed c - (exact b + exact c)) with
      ((computed b - exact b) + (computed c - exact c)) by ring.
    eapply Rle_trans; [apply Rabs_triang|]; lra.
  - destruct d as [|d]; [lia|].
    change (growth (S d)) with ((1 + eps) * growth d).
    apply (one_rounding _ _ _ _ (computed b) (exact b)); try reflexivity.
    + apply exact_magnitude.
    + apply magnitude_pos.
    + apply growth_1.
    + apply count_pos.
    + apply IHb; lia.
Qed.

(** The orders that the core has: one after the other, or by pairs; terms rounded by themselves, or
    fused with the addition behind them (by pairs, every second one). *)
Fixpoint sequence (fused : bool) (s : sum) (v : list R) : sum :=
  match v with
  | nil => s
  | cons a r => sequence fused (Rounded (Plus s (if fused then Term a else Rounded (Term a)))) r
  end.

Fixpoint pairs (fused : bool) (levels : nat) (v : nat -> R) : sum :=
  match levels with
  | O => Rounded (Term (v O))
  | S O => Rounded (Plus (Rounded (Term (v O))) (if fused then Term (v 1%nat) else Rounded (Term (v 1%nat))))
  | S (S _ as k) => Rounded (Plus (pairs fused k v) (pairs fused k (fun i => v (Nat.pow 2 k + i)%nat)))
  end.
End Sums.

Section Product.
Variables (rnd : R -> R) (eps eta : R).
Hypotheses (Eps : 0 <= eps) (Eta : 0 <= eta).
Hypothesis Rnd : forall v, Rabs (rnd v - v) <= eps * Rabs v + eta.
Variables (s t u bs bt bu : nat -> R) (e a : R) (P : nat -> nat -> nat -> R).
Hypotheses (E0 : 0 <= e) (Bs : norm bs <= 1) (Bt : norm bt <= 1) (Bu : norm bu <= 1).
Hypotheses (Es : norm (fun i => s i - bs i) <= e) (Et : norm (fun i => t i - bt i) <= e)
  (Eu : norm (fun i => u i - bu i) <= e).
Hypothesis A : distance (products s t u) (products bs bt bu) <= a.
Hypothesis Points : forall l m n, Rabs (P l m n) <= 1.

Let g := 1 + e.
Let d l m n := rnd (rnd (s l * t m) * u n).
Variables (order : sum) (deepest : nat) (roundings : R).
Hypothesis Terms : exact order = sum3 (fun l m n => d l m n * P l m n).
Hypothesis Magnitude : magnitude order = sum3 (fun l m n => Rabs (d l m n * P l m n)).
Hypotheses (Deep : (deep order <= deepest)%nat) (Count : count order <= roundings).

Let k := (1 + eps) * (1 + eps) - 1.
(* Two roundings of each product; 16 of its 64 roundings are shared. *)
Let r := a + k * (g * g * g) + (16 * (1 + eps) * g + 64) * eta.
Definition float_bound :=
  r + (growth eps deepest - 1) * (1 + r) + roundings * growth eps deepest * eta.

Lemma factors l m n : Rabs (d l m n - products s t u l m n) <=
  k * Rabs (products s t u l m n) + ((1 + eps) * eta * Rabs (u n) + eta).
Proof.
  unfold d, products; set (x := s l * t m); set (y := rnd x).
  pose proof (Rnd x) as R1; fold y in R1; pose proof (Rnd (y * u n)) as R2.
  assert (Y : Rabs (y * u n - x * u n) <= (eps * Rabs x + eta) * Rabs (u n)).
  { rewrite <- Rmult_minus_distr_r, Rabs_mult.
    apply Rmult_le_compat_r; [apply Rabs_pos | exact R1]. }
  assert (Z : Rabs (y * u n) <= Rabs (x * u n) + (eps * Rabs x + eta) * Rabs (u n)).
  { replace (y * u n) with (x * u n + (y * u n - x * u n)) at 1 by ring.
    eapply Rle_trans; [apply Rabs_triang|]; lra. }
  apply (Rmult_le_compat_l eps) in Z; [|exact Eps].
  replace (rnd (y * u n) - x * u n) with ((rnd (y * u n) - y * u n) + (y * u n - x * u n)) by ring.
  eapply Rle_trans; [apply Rabs_triang|].
  rewrite (Rabs_mult x (u n)) in *; unfold k.
  apply Rle_trans with (eps * (Rabs x * Rabs (u n) + (eps * Rabs x + eta) * Rabs (u n)) + eta
    + (eps * Rabs x + eta) * Rabs (u n)); [lra | right; ring].
Qed.

Lemma float_distance : distance d (products bs bt bu) <= r.
Proof.
  pose proof (norm_of_error _ _ _ Bs Es) as Gs; pose proof (norm_of_error _ _ _ Bt Et) as Gt.
  pose proof (norm_of_error _ _ _ Bu Eu) as Gu; fold g in Gs, Gt, Gu.
  pose proof (norm_nonneg s); pose proof (norm_nonneg t); pose proof (norm_nonneg u).
  assert (G0 : 0 <= g) by (unfold g; lra).
  assert (D : distance d (products s t u) <= k * (g * g * g) + (16 * (1 + eps) * g + 64) * eta).
  { apply Rle_trans with (k * sum3 (fun l m n => Rabs (products s t u l m n))
      + (sum3 (fun l m n => (fun _ => 1) l * (fun _ => (1 + eps) * eta) m * Rabs (u n))
         + sum3 (fun _ _ _ => eta))).
    - unfold distance; rewrite <- sum3_scale, <- !sum3_plus; apply sum3_le; intros.
      rewrite Rmult_1_l; apply factors.
    - rewrite sum3_norm, sum3_product, sum3_const, !S4_const; fold (norm u).
      assert (norm s * norm t * norm u <= g * g * g).
      { repeat apply Rmult_le_compat; try assumption; apply Rmult_le_pos; assumption. }
      assert (0 <= k) by (unfold k; assert (0 <= eps * eps) by (apply Rmult_le_pos; lra); lra).
      assert (0 <= (1 + eps) * eta) by (apply Rmult_le_pos; lra).
      assert ((1 + eps) * eta * norm u <= (1 + eps) * eta * g) by (apply Rmult_le_compat_l; lra).
      assert (k * (norm s * norm t * norm u) <= k * (g * g * g)) by (apply Rmult_le_compat_l; lra).
      lra. }
  pose proof (distance_triangle d (products s t u) (products bs bt bu)); unfold r; lra.
Qed.

Theorem float_product : Rabs (computed rnd order - eq1 bs bt bu P) <= float_bound.
Proof.
  pose proof float_distance as N.
  pose proof (sum_error rnd eps eta Eps Eta Rnd order deepest Deep) as S.
  pose proof (weighted_difference d (products bs bt bu) P r N Points) as W.
  assert (B1 : norm bs * norm bt * norm bu <= 1).
  { replace 1 with (1 * 1 * 1) by ring.
    repeat apply Rmult_le_compat; try assumption; try apply Rmult_le_pos; apply norm_nonneg. }
  assert (M : magnitude order <= 1 + r).
  { rewrite Magnitude.
    apply Rle_trans with (sum3 (fun l m n => Rabs (products bs bt bu l m n)) + distance d (products bs bt bu)).
    - unfold distance; rewrite <- sum3_plus; apply sum3_le; intros; rewrite Rabs_mult.
      apply Rle_trans with (Rabs (d l m n) * 1).
      { apply Rmult_le_compat_l; [apply Rabs_pos | apply Points]. }
      rewrite Rmult_1_r.
      replace (d l m n) with (products bs bt bu l m n + (d l m n - products bs bt bu l m n)) at 1 by ring.
      apply Rabs_triang.
    - rewrite sum3_norm; lra. }
  rewrite <- Terms in W; rewrite eq1_flat; unfold float_bound.
  change (fun l m n => bs l * bt m * bu n * P l m n) with (fun l m n => products bs bt bu l m n * P l m n).
  pose proof (growth_1 eps Eps deepest) as G1.
  assert (K : (growth eps deepest - 1) * magnitude order <= (growth eps deepest - 1) * (1 + r)).
  { apply Rmult_le_compat_l; lra. }
  assert (L : count order * growth eps deepest * eta <= roundings * growth eps deepest * eta).
  { apply Rmult_le_compat_r; [exact Eta|]; apply Rmult_le_compat_r; lra. }
  revert S W; unfold Rabs; repeat destruct Rcase_abs; lra.
Qed.
End Product.
