(* `nested`: a polynomial of the cell, formed by three contractions, then Horner's rule along three
   axes. Each of its roundings is off by at most `half`.
   SPDX-License-Identifier: Apache-2.0 *)
Require Import Reals Lra Sums.
Open Scope R_scope.

(** Powers of a centred coordinate. *)
Definition power (x : R) (k : nat) := match k with 0%nat => 1 | 1%nat => x | 2%nat => x * x | _ => x * x * x end.
Definition at_power (x : R) (c : nat -> R) := S4 (fun k => power x k * c k).

Lemma power_1 x k : Rabs x <= 1 -> Rabs (power x k) <= 1.
Proof.
  intro X; pose proof (Rabs_pos x); assert (X2 : Rabs x * Rabs x <= 1).
  { rewrite <- (Rmult_1_r 1) at 1; apply Rmult_le_compat; assumption. }
  destruct k as [|[|[|k]]]; simpl; rewrite ?Rabs_mult, ?Rabs_R1; try lra.
  rewrite <- (Rmult_1_r 1); apply Rmult_le_compat; try assumption.
  apply Rmult_le_pos; assumption.
Qed.

Lemma power_norm x : Rabs x <= 1 -> norm (power x) <= 4.
Proof.
  intro X; unfold norm; apply Rle_trans with (S4 (fun _ => 1)); [|rewrite S4_const; lra].
  apply S4_le; intro; apply power_1; exact X.
Qed.

(** Three steps of Horner's rule, each rounded. *)
Definition steps (half x : R) (c : nat -> R) (v : R) := exists v2 v1,
  Rabs (v2 - (c 2%nat + x * c 3%nat)) <= half /\ Rabs (v1 - (c 1%nat + x * v2)) <= half /\
  Rabs (v - (c 0%nat + x * v1)) <= half.

Lemma horner half x c v : Rabs x <= 1 -> steps half x c v -> Rabs (v - at_power x c) <= 3 * half.
Proof.
  intros X (v2 & v1 & H2 & H1 & H0).
  assert (H : 0 <= half) by (apply Rle_trans with (2 := H0); apply Rabs_pos).
  assert (M : forall d e, Rabs d <= e -> Rabs (x * d) <= e).
  { intros d e D; rewrite Rabs_mult, <- (Rmult_1_l e).
    apply Rmult_le_compat; try apply Rabs_pos; assumption. }
  pose proof (M _ _ (M _ _ H2)) as B2; pose proof (M _ _ H1) as B1.
  unfold at_power, S4; simpl.
  replace (v - (1 * c 0%nat + x * c 1%nat + x * x * c 2%nat + x * x * x * c 3%nat)) with
    ((v - (c 0%nat + x * v1)) + (x * (v1 - (c 1%nat + x * v2)) + x * (x * (v2 - (c 2%nat + x * c 3%nat)))))
    by ring.
  revert H0 B1 B2; unfold Rabs; repeat destruct Rcase_abs; lra.
Qed.

Section Nested.
Variables (ms mt mu : nat -> nat -> R).  (* [power][function], as formed *)
Variables (x y z : R) (bs bt bu : nat -> R) (e a given half out : R) (p P : nat -> nat -> nat -> R).
Let w (m : nat -> nat -> R) v i := at_power v (fun k => m k i).
Hypotheses (X : Rabs x <= 1) (Y : Rabs y <= 1) (Z : Rabs z <= 1) (E0 : 0 <= e) (H0 : 0 <= half) (I0 : 0 <= given).
Hypotheses (Bs : norm bs <= 1) (Bt : norm bt <= 1) (Bu : norm bu <= 1).
Hypotheses (Es : norm (fun i => w ms x i - bs i) <= e) (Et : norm (fun i => w mt y i - bt i) <= e)
  (Eu : norm (fun i => w mu z i - bu i) <= e).
Hypothesis A : distance (products (w ms x) (w mt y) (w mu z)) (products bs bt bu) <= a.
Hypothesis Points : forall l m n, Rabs (P l m n) <= 1.
Hypothesis Rounded : forall l m n, Rabs (p l m n - P l m n) <= given.
Variables (c1 c2 c3 : nat -> nat -> nat -> R) (f : nat -> nat -> R) (h : nat -> R) (v q : R).
Hypothesis C1 : forall l m k, Rabs (c1 l m k - S4 (fun n => mu k n * p l m n)) <= half.
Hypothesis C2 : forall l j k, Rabs (c2 l j k - S4 (fun m => mt j m * c1 l m k)) <= half.
Hypothesis C3 : forall i j k, Rabs (c3 i j k - S4 (fun l => ms i l * c2 l j k)) <= half.
Hypothesis F : forall i j, steps half z (fun k => c3 i j k) (f i j).
Hypothesis H : forall i, steps half y (fun j => f i j) (h i).
Hypothesis V : steps half x h v.
Hypothesis Q : Rabs (q - v) <= out.

Let g := 1 + e.
Definition nested_bound := a + given * (g * g * g) + half * (4 * g * g + 16 * g + 64 + 48 + 12 + 3) + out.

Let four v := at_power v.
Let px := power_norm x X. Let py := power_norm y Y. Let pz := power_norm z Z.

(* What is rounded on one axis, seen behind the axes after it. *)
Let along (b : R) (u u' : nat -> nat -> nat -> R) (B0 : 0 <= b)
  (B : forall i j k, Rabs (u i j k - u' i j k) <= b) :
  Rabs (eq1 (power x) (power y) (power z) u - eq1 (power x) (power y) (power z) u') <= 64 * b.
Proof.
  replace (64 * b) with (4 * (4 * (4 * b))) by ring.
  do 3 (apply axis_difference; [assumption | lra | intro]); apply B.
Qed.

Lemma by_horner : Rabs (v - eq1 (power x) (power y) (power z) c3) <= 63 * half.
Proof.
  pose proof (horner half x h v X V) as HV.
  assert (HH : Rabs (at_power x h - S4 (fun i => power x i * at_power y (f i))) <= 4 * (3 * half)).
  { apply axis_difference; [apply px | lra | intro i; apply (horner half y (fun j => f i j) (h i) Y (H i))]. }
  assert (HF : Rabs (S4 (fun i => power x i * at_power y (f i)) - eq1 (power x) (power y) (power z) c3)
    <= 4 * (4 * (3 * half))).
  { do 2 (apply axis_difference; [assumption | lra | intro]).
    apply (horner half z (fun k => c3 i i0 k) (f i i0) Z (F i i0)). }
  revert HV HH HF; unfold Rabs; repeat destruct Rcase_abs; lra.
Qed.

(* Powers of an axis and its matrix are the weights of that axis. *)
Let inner (m : nat -> nat -> R) r (d : nat -> R) :
  S4 (fun k => power r k * S4 (fun i => m k i * d i)) = S4 (fun i => w m r i * d i).
Proof. unfold w, at_power, S4; ring. Qed.

Lemma by_third : Rabs (eq1 (power x) (power y) (power z) c3 - eq1 (w ms x) (power y) (power z) c2) <= 64 * half.
Proof.
  replace (eq1 (w ms x) (power y) (power z) c2) with
    (eq1 (power x) (power y) (power z) (fun i j k => S4 (fun l => ms i l * c2 l j k))).
  - apply along; [assumption | apply C3].
  - unfold eq1; rewrite <- (inner ms x); apply S4_ext; intro i; f_equal.
    unfold S4; ring.
Qed.

Let Gs : norm (w ms x) <= g. Proof. apply norm_of_error with bs; assumption. Qed.
Let Gt : norm (w mt y) <= g. Proof. apply norm_of_error with bt; assumption. Qed.
Let Gu : norm (w mu z) <= g. Proof. apply norm_of_error with bu; assumption. Qed.
Let G0 : 0 <= g. Proof. unfold g; lra. Qed.
Let M0 b : 0 <= b -> 0 <= g * b. Proof. apply Rmult_le_pos, G0. Qed.

Lemma by_second : Rabs (eq1 (w ms x) (power y) (power z) c2 - eq1 (w ms x) (w mt y) (power z) c1)
  <= g * (16 * half).
Proof.
  unfold eq1; apply axis_difference; [apply Gs | lra | intro l].
  rewrite <- (inner mt y).
  replace (16 * half) with (4 * (4 * half)) by ring.
  rewrite (S4_ext (fun k => power y k * S4 (fun i => mt k i * S4 (fun n => power z n * c1 l i n)))
    (fun j => power y j * S4 (fun k => power z k * S4 (fun m => mt j m * c1 l m k)))).
  - do 2 (apply axis_difference; [assumption | lra | intro]); apply C2.
  - intro j; f_equal; unfold S4; ring.
Qed.

Lemma by_first : Rabs (eq1 (w ms x) (w mt y) (power z) c1 - eq1 (w ms x) (w mt y) (w mu z) p)
  <= g * (g * (4 * half)).
Proof.
  unfold eq1.
  apply axis_difference; [apply Gs | apply M0; lra | intro l].
  apply axis_difference; [apply Gt | lra | intro m].
  rewrite <- (inner mu z); apply axis_difference; [apply pz | lra | intro k]; apply C1.
Qed.

Lemma by_points : Rabs (eq1 (w ms x) (w mt y) (w mu z) p - eq1 (w ms x) (w mt y) (w mu z) P)
  <= g * (g * (g * given)).
Proof.
  apply axis_difference; [apply Gs | do 2 apply M0; lra | intro].
  apply axis_difference; [apply Gt | apply M0; lra | intro].
  apply axis_difference; [apply Gu | lra | intro]; apply Rounded.
Qed.

Theorem nested : Rabs (q - eq1 bs bt bu P) <= nested_bound.
Proof.
  pose proof by_horner as K1; pose proof by_third as K2; pose proof by_second as K3.
  pose proof by_first as K4; pose proof by_points as K5.
  assert (K6 : Rabs (eq1 (w ms x) (w mt y) (w mu z) P - eq1 bs bt bu P) <= a).
  { rewrite !eq1_flat; apply (weighted_difference (products (w ms x) (w mt y) (w mu z)) (products bs bt bu));
      assumption. }
  assert (T : forall d1 d2 d3 d4 d5 d6 d7 : R, Rabs (d1 - d7) <=
    Rabs (d1 - d2) + Rabs (d2 - d3) + Rabs (d3 - d4) + Rabs (d4 - d5) + Rabs (d5 - d6) + Rabs (d6 - d7)).
  { intros; unfold Rabs; repeat destruct Rcase_abs; lra. }
  assert (K0 : Rabs (q - eq1 bs bt bu P) <= Rabs (q - v) + Rabs (v - eq1 bs bt bu P)).
  { unfold Rabs; repeat destruct Rcase_abs; lra. }
  pose proof (T v (eq1 (power x) (power y) (power z) c3) (eq1 (w ms x) (power y) (power z) c2)
    (eq1 (w ms x) (w mt y) (power z) c1) (eq1 (w ms x) (w mt y) (w mu z) p)
    (eq1 (w ms x) (w mt y) (w mu z) P) (eq1 bs bt bu P)).
  unfold nested_bound.
  replace (given * (g * g * g) + half * (4 * g * g + 16 * g + 64 + 48 + 12 + 3)) with
    (63 * half + 64 * half + g * (16 * half) + g * (g * (4 * half)) + g * (g * (g * given))) by ring.
  lra.
Qed.
End Nested.
