(* The forms as programs of the core: what is rounded, in which order. Fixed.v and Float.v say
   what follows for any rounding; here roundings are those of the core.
   SPDX-License-Identifier: Apache-2.0 *)
Require Import Reals Lra ZArith Gappa.Gappa_library Sums Fixed Float.
From Flocq Require Import Core Relative.
Open Scope R_scope.

(** Half up, to multiples of 2^e: floor(y / 2^e + 1/2). *)
Definition half (e : Z) : R := float2R (Float2 1 (e - 1)).
Definition half_up (e : Z) (y : R) := rounding_fixed rndDN e (y + half e).

Lemma half_bpow e : half e = bpow radix2 (e - 1).
Proof. unfold half, float2R, F2R; simpl; ring. Qed.

Lemma half_pos e : 0 <= half e.
Proof. rewrite half_bpow; apply bpow_ge_0. Qed.

Lemma half_up_error e y : Rabs (half_up e y - y) <= half e.
Proof.
  unfold half_up, round, scaled_mantissa, cexp, FIX_exp, F2R; simpl.
  set (z := (y + half e) * bpow radix2 (- e)).
  assert (B : bpow radix2 e = 2 * half e).
  { rewrite half_bpow; replace e with (1 + (e - 1))%Z at 1 by ring; rewrite bpow_plus; reflexivity. }
  assert (Y : z * bpow radix2 e = y + half e).
  { unfold z; rewrite Rmult_assoc, <- bpow_plus; replace (- e + e)%Z with 0%Z by ring.
    simpl; ring. }
  pose proof (Zfloor_lb z) as L; pose proof (Zfloor_ub z) as U; pose proof (half_pos e) as H.
  pose proof (bpow_ge_0 radix2 e) as P.
  apply (Rmult_le_compat_r _ _ _ P) in L.
  apply Rlt_le, (Rmult_le_compat_r _ _ _ P) in U.
  rewrite Rmult_plus_distr_r, Rmult_1_l in U; rewrite Y in L, U; rewrite B in *.
  apply Rabs_le; lra.
Qed.

(** A number that is on the grid already. *)
Definition exactly (y : R) := y.

Lemma exactly_error y : Rabs (exactly y - y) <= 0.
Proof. unfold exactly, Rminus; rewrite Rplus_opp_r, Rabs_R0; apply Rle_refl. Qed.

(** binary32, to nearest, ties to even, subnormals included. *)
Definition eps : R := float2R (Float2 1 (-24)).
Definition eta : R := float2R (Float2 1 (-150)).
Definition nearest (y : R) := rounding_float rndNE 24 (-149) y.

Lemma eps_pos : 0 <= eps.
Proof. unfold eps, float2R, F2R; simpl; lra. Qed.

Lemma eta_pos : 0 <= eta.
Proof. unfold eta, float2R, F2R; simpl; lra. Qed.

Lemma nearest_error y : Rabs (nearest y - y) <= eps * Rabs y + eta.
Proof.
  destruct (error_N_FLT radix2 (-149) 24 ltac:(reflexivity) (fun x => negb (Z.even x)) y)
    as (a & b & A & B & _ & E).
  unfold nearest; change (round radix2 (FLT_exp (-149) 24) rndNE y) with
    (round radix2 (FLT_exp (-149) 24) (Znearest (fun x => negb (Z.even x))) y).
  rewrite E; replace (y * (1 + a) + b - y) with (a * y + b) by ring.
  eapply Rle_trans; [apply Rabs_triang|]; rewrite Rabs_mult.
  apply Rplus_le_compat.
  - apply Rmult_le_compat_r; [apply Rabs_pos|]; apply Rle_trans with (1 := A).
    unfold eps, u_ro, float2R, F2R; simpl; lra.
  - apply Rle_trans with (1 := B); unfold eta, float2R, F2R; simpl; lra.
Qed.

Section Programs.
Variables (s t u : nat -> R) (P : nat -> nat -> nat -> R).

(** One axis after the other. *)
Definition factored_program (point narrow out : R -> R) :=
  out (S4 (fun l => s l * narrow (S4 (fun m => t m * narrow (S4 (fun n => u n * point (P l m n))))))).

(** The sum of ((B_l B_m) B_n) P. *)
Definition product_program (weight point out : R -> R) :=
  out (sum3 (fun l m n => weight (weight (s l * t m) * u n) * point (P l m n))).
End Programs.

(** What a part v gives each bank of an axis, and a gradient the banks of three (scatter). The weights
    of an axis sum to 1, or to 0 where the derivative along it is wanted. *)
Definition total (to_one : bool) : R := if to_one then 1 else 0.
Definition expanded (share : R -> R) (to_one : bool) (w : nat -> R) (v : R) (b : nat) :=
  let c0 := share (w 0%nat * v) in
  let c1 := share ((w 0%nat + w 1%nat) * v) in
  let c2 := share ((w 0%nat + w 1%nat + w 2%nat) * v) in
  let c3 := if to_one then v else 0 in
  match b with 0%nat => c0 | 1%nat => c1 - c0 | 2%nat => c2 - c1 | _ => c3 - c2 end.
Definition scatter_program (one_s one_t one_u : bool) (s t u : nat -> R) (g : R) (point share : R -> R)
    (l m n : nat) :=
  expanded share one_u u (expanded share one_t t (expanded share one_s s (point g) l) m) n.

(** binary32: 64 terms in the order of the banks, `v` of each; weights and points are those of the
    banks. *)
Definition in_sequence (fused : bool) (v : nat -> R) := sequence fused (Term 0) (List.map v (List.seq 0 64)).
Definition in_pairs (fused : bool) (v : nat -> R) := pairs fused 6 v.
Definition float_terms (s t u : nat -> R) (P : nat -> nat -> nat -> R) (i : nat) :=
  let l := Nat.div i 16 in let m := Nat.modulo (Nat.div i 4) 4 in let n := Nat.modulo i 4 in
  nearest (nearest (s l * t m) * u n) * P l m n.

Lemma sequence_exact fused v : exact (in_sequence fused v) = sum3 (fun l m n => v (16 * l + 4 * m + n)%nat).
Proof. destruct fused; cbn -[Rplus]; unfold sum3, S4; cbn -[Rplus]; ring. Qed.

Lemma pairs_exact fused v : exact (in_pairs fused v) = sum3 (fun l m n => v (16 * l + 4 * m + n)%nat).
Proof. destruct fused; cbn -[Rplus]; unfold sum3, S4; cbn -[Rplus]; ring. Qed.

Lemma sequence_magnitude fused v :
  magnitude (in_sequence fused v) = sum3 (fun l m n => Rabs (v (16 * l + 4 * m + n)%nat)).
Proof. destruct fused; cbn -[Rplus]; unfold sum3, S4; cbn -[Rplus]; rewrite Rabs_R0; ring. Qed.

Lemma pairs_magnitude fused v :
  magnitude (in_pairs fused v) = sum3 (fun l m n => Rabs (v (16 * l + 4 * m + n)%nat)).
Proof. destruct fused; cbn -[Rplus]; unfold sum3, S4; cbn -[Rplus]; ring. Qed.
