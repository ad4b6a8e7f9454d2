(* What is left to show of a form in a format: that its bound, a number, holds for the formula of
   its errors. The rest is proved here, of the programs of Programs.v.
   SPDX-License-Identifier: Apache-2.0 *)
Require Import Reals Lra Lia Gappa.Gappa_library Sums Fixed Float Programs.
From Flocq Require Import Core.
Open Scope R_scope.

(** Comparisons of numbers m 2^e. *)
Ltac numbers := repeat split; unfold float2R, F2R; simpl; lra.

(** Weights, functions and points that a bound is about: errors of the weights of an axis, of the
    products of three; |P| <= 1. *)
Record vertex (e a : R) (s t u bs bt bu : nat -> R) (P : nat -> nat -> nat -> R) : Prop := {
  functions_s : norm bs <= 1; functions_t : norm bt <= 1; functions_u : norm bu <= 1;
  weights_s : norm (fun i => s i - bs i) <= e;
  weights_t : norm (fun i => t i - bt i) <= e;
  weights_u : norm (fun i => u i - bu i) <= e;
  weights_all : distance (products s t u) (products bs bt bu) <= a;
  small_points : forall l m n, Rabs (P l m n) <= 1 }.

Definition rounds (r : R -> R) (h : R) := forall y, Rabs (r y - y) <= h.

Lemma rounds_pos r h : rounds r h -> 0 <= h.
Proof. intro H; apply Rle_trans with (2 := H 0); apply Rabs_pos. Qed.

Section Certified.
Variables (e a bound : R) (s t u bs bt bu : nat -> R) (P : nat -> nat -> nat -> R).
Variables (point weight narrow out : R -> R) (given unit2 half last : R).
Hypothesis V : vertex e a s t u bs bt bu P.
Hypotheses (Given : rounds point given) (Half : rounds narrow half) (Last : rounds out last)
  (Unit : rounds weight unit2).

Let E0 : 0 <= e.
Proof. apply Rle_trans with (2 := weights_s _ _ _ _ _ _ _ _ _ V); apply norm_nonneg. Qed.

Theorem factored_certified : factored_bound e given half last a <= bound ->
  Rabs (factored_program s t u P point narrow out - eq1 bs bt bu P) <= bound.
Proof.
  intro B; apply Rle_trans with (2 := B); destruct V.
  apply (factored s t u bs bt bu e (fun l m n => point (P l m n)) P given half last) with
    (x := fun l m => narrow (S4 (fun n => u n * point (P l m n))))
    (y := fun l => narrow (S4 (fun m => t m * narrow (S4 (fun n => u n * point (P l m n))))));
    try assumption; intros; try apply Given; try apply Half; try apply Last.
  - apply (rounds_pos _ _ Half).
  - apply (rounds_pos _ _ Given).
Qed.

Let c l m := weight (s l * t m).
Let d l m n := weight (weight (s l * t m) * u n).

Let product_of r : distance d (products bs bt bu) <= r -> product_bound given last r <= bound ->
  Rabs (product_program s t u P weight point out - eq1 bs bt bu P) <= bound.
Proof.
  intros R B; apply Rle_trans with (2 := B); destruct V.
  apply (product bs bt bu (fun l m n => point (P l m n)) P given last) with (d := d); try assumption.
  - apply (rounds_pos _ _ Given).
  - intros; apply Given.
  - apply Last.
Qed.

Theorem product_by_triple : product_bound given last (product_distance e unit2 a) <= bound ->
  Rabs (product_program s t u P weight point out - eq1 bs bt bu P) <= bound.
Proof.
  apply product_of; destruct V.
  apply (by_triple s t u bs bt bu e) with (c := c); try assumption; try apply (rounds_pos _ _ Unit);
    intros; apply Unit.
Qed.

Theorem product_by_pair r : pair_distance bs bt c <= r ->
  product_bound given last (product_distance_of_pair e unit2 r) <= bound ->
  Rabs (product_program s t u P weight point out - eq1 bs bt bu P) <= bound.
Proof.
  intro R; apply product_of; destruct V.
  apply (by_pair u bs bt bu e) with (c := c); try assumption; intros; apply Unit.
Qed.
End Certified.

(** binary32 in four orders. *)
Definition float_program (tree fused : bool) s t u P :=
  computed nearest ((if tree then in_pairs fused else in_sequence fused) (float_terms s t u P)).
Definition float_depth (tree fused : bool) := (if tree then 7 else if fused then 64 else 65)%nat.
Definition float_count (tree fused : bool) := if tree then (if fused then 95 else 127) else if fused then 64 else 128.

Lemma index f : sum3 (fun l m n => (fun i => f (Nat.div i 16) (Nat.modulo (Nat.div i 4) 4) (Nat.modulo i 4))
  (16 * l + 4 * m + n)%nat) = sum3 f.
Proof. reflexivity. Qed.

Theorem float_certified (tree fused : bool) e a bound s t u bs bt bu P : vertex e a s t u bs bt bu P ->
  float_bound eps eta e a (float_depth tree fused) (float_count tree fused) <= bound ->
  Rabs (float_program tree fused s t u P - eq1 bs bt bu P) <= bound.
Proof.
  intros V B; apply Rle_trans with (2 := B).
  assert (E0 : 0 <= e) by (apply Rle_trans with (2 := weights_s _ _ _ _ _ _ _ _ _ V); apply norm_nonneg).
  assert (P1 : 0 <= eps) by apply eps_pos.
  assert (P2 : 0 <= eta) by apply eta_pos.
  pose (d := fun l m n => nearest (nearest (s l * t m) * u n)).
  pose (v := float_terms s t u P).
  destruct V; unfold float_program.
  apply (float_product nearest eps eta P1 P2 nearest_error s t u bs bt bu e a P); try assumption.
  - change (sum3 (fun l m n => d l m n * P l m n)) with
      (sum3 (fun l m n => v (16 * l + 4 * m + n)%nat)).
    destruct tree; [apply pairs_exact | apply sequence_exact].
  - change (sum3 (fun l m n => Rabs (d l m n * P l m n))) with
      (sum3 (fun l m n => Rabs (v (16 * l + 4 * m + n)%nat))).
    destruct tree; [apply pairs_magnitude | apply sequence_magnitude].
  - destruct tree, fused; cbv [float_depth in_pairs in_sequence]; simpl; lia.
  - destruct tree, fused; cbv [float_count in_pairs in_sequence]; simpl; lra.
Qed.

(** A result that is rounded to binary32 at last, and is no larger than 1. *)
Lemma small_result y : Rabs y <= 1 -> Rabs (nearest y - y) <= float2R (Float2 1 (-25)).
Proof.
  intro Y; unfold nearest.
  assert (V : Valid_rnd rndNE) by apply valid_rnd_N.
  assert (G : Prec_gt_0 24) by reflexivity.
  assert (Z0 : forall r, r = y -> 0 <= float2R (Float2 1 (-25)) -> Rabs (r - y) <= float2R (Float2 1 (-25))).
  { intros r -> H; unfold Rminus; rewrite Rplus_opp_r, Rabs_R0; exact H. }
  assert (H0 : 0 <= float2R (Float2 1 (-25))) by numbers.
  destruct (Req_dec y 0) as [-> | N]; [apply Z0; [apply round_0; exact V | exact H0]|].
  destruct (Rle_lt_or_eq_dec _ _ Y) as [L | L].
  - apply Rle_trans with (/ 2 * ulp radix2 (FLT_exp (-149) 24) y).
    + apply error_le_half_ulp; apply FLT_exp_valid; exact G.
    + rewrite ulp_neq_0 by exact N.
      apply Rle_trans with (/ 2 * bpow radix2 (-24)); [|simpl; numbers].
      apply Rmult_le_compat_l; [lra|]; apply bpow_le; unfold cexp, FLT_exp.
      pose proof (mag_le_bpow radix2 y 0 N L); lia.
  - apply Z0; [|exact H0]; apply round_generic; [exact V|].
    unfold Rabs in L; destruct Rcase_abs in L.
    + replace y with (- bpow radix2 0) by (simpl; lra).
      apply generic_format_opp, generic_format_bpow; unfold FLT_exp; simpl; lia.
    + replace y with (bpow radix2 0) by (simpl; lra).
      apply generic_format_bpow; unfold FLT_exp; simpl; lia.
Qed.

Lemma rounded_at_last y q a b : Rabs (y - q) <= a -> Rabs y <= 1 -> a + float2R (Float2 1 (-25)) <= b ->
  Rabs (nearest y - q) <= b.
Proof.
  intros A Y B; pose proof (small_result y Y).
  replace (nearest y - q) with ((nearest y - y) + (y - q)) by ring.
  eapply Rle_trans; [apply Rabs_triang|]; lra.
Qed.

(** The weights of an axis by Horner's rule, `r` what rounds a step and `m` what rounds its product;
    and the functions themselves. *)
Definition horner_weight (r m : R -> R) c0 c1 c2 c3 x :=
  r (c0 + m (x * r (c1 + m (x * r (c2 + m (x * c3)))))) * 1.
Definition horner_exact c0 c1 c2 c3 x := (c0 + x * (c1 + x * (c2 + x * c3))) * 1.

(** B-splines are not negative and sum to 1. *)
Lemma bspline_norm (f : nat -> R) x : 0 <= x <= 1 ->
  f 0%nat = (1 - x) * (1 - x) * (1 - x) / 6 -> f 1%nat = (4 - 6 * x * x + 3 * x * x * x) / 6 ->
  f 2%nat = (1 + 3 * x + 3 * x * x - 3 * x * x * x) / 6 -> f 3%nat = x * x * x / 6 -> norm f <= 1.
Proof.
  intros [L U] F0 F1 F2 F3; unfold norm, S4; rewrite F0, F1, F2, F3.
  assert (N : 0 <= x * x) by nra.
  assert (X : 0 <= x * x * x) by (apply Rmult_le_pos; lra).
  assert (Y : 0 <= (1 - x) * (1 - x) * (1 - x)) by (repeat apply Rmult_le_pos; lra).
  assert (Z : 0 <= x * x * (1 - x)) by (apply Rmult_le_pos; lra).
  rewrite !Rabs_pos_eq; nra.
Qed.

Lemma whole_vertex e s t u bs bt bu P : 0 <= e -> norm bs <= 1 -> norm bt <= 1 -> norm bu <= 1 ->
  norm (fun i => s i - bs i) <= e -> norm (fun i => t i - bt i) <= e -> norm (fun i => u i - bu i) <= e ->
  (forall l m n, Rabs (P l m n) <= 1) -> forall a, (1 + e) * (1 + e) * (1 + e) - 1 <= a ->
  vertex e a s t u bs bt bu P.
Proof.
  intros E0 Bs Bt Bu Es Et Eu Points a A; constructor; try assumption.
  apply Rle_trans with (2 := A); apply distance_of_axes; assumption.
Qed.
