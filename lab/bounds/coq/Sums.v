(* Sums of four, one inside the other: what an axis makes of four numbers, and what three axes make
   of 64. Everything that is proved of the forms (Fixed.v, Float.v) rests on these.
   SPDX-License-Identifier: Apache-2.0 *)
Require Import Reals Lra.
Open Scope R_scope.

Definition S4 (f : nat -> R) := f 0%nat + f 1%nat + f 2%nat + f 3%nat.
Definition sum3 (f : nat -> nat -> nat -> R) := S4 (fun l => S4 (fun m => S4 (fun n => f l m n))).

Lemma S4_ext f g : (forall i, f i = g i) -> S4 f = S4 g.
Proof. intro H; unfold S4; rewrite !H; reflexivity. Qed.

Lemma S4_le f g : (forall i, f i <= g i) -> S4 f <= S4 g.
Proof.
  intro H; unfold S4.
  pose proof (H 0%nat); pose proof (H 1%nat); pose proof (H 2%nat); pose proof (H 3%nat); lra.
Qed.

Lemma S4_abs f : Rabs (S4 f) <= S4 (fun i => Rabs (f i)).
Proof.
  unfold S4.
  pose proof (Rabs_triang (f 0%nat + f 1%nat + f 2%nat) (f 3%nat)).
  pose proof (Rabs_triang (f 0%nat + f 1%nat) (f 2%nat)).
  pose proof (Rabs_triang (f 0%nat) (f 1%nat)); lra.
Qed.

Lemma S4_nonneg f : (forall i, 0 <= f i) -> 0 <= S4 f.
Proof.
  intro H; unfold S4.
  pose proof (H 0%nat); pose proof (H 1%nat); pose proof (H 2%nat); pose proof (H 3%nat); lra.
Qed.

Lemma S4_plus f g : S4 (fun i => f i + g i) = S4 f + S4 g.
Proof. unfold S4; ring. Qed.

Lemma S4_minus f g : S4 (fun i => f i - g i) = S4 f - S4 g.
Proof. unfold S4; ring. Qed.

Lemma S4_scale c f : S4 (fun i => c * f i) = c * S4 f.
Proof. unfold S4; ring. Qed.

Lemma S4_scale_r c f : S4 (fun i => f i * c) = S4 f * c.
Proof. unfold S4; ring. Qed.

Lemma S4_const c : S4 (fun _ => c) = 4 * c.
Proof. unfold S4; ring. Qed.

Lemma S4_swap f : S4 (fun i => S4 (fun j => f i j)) = S4 (fun j => S4 (fun i => f i j)).
Proof. unfold S4; ring. Qed.

(** The sum of magnitudes of an axis, and what it makes of four errors of at most h. *)
Definition norm (w : nat -> R) := S4 (fun i => Rabs (w i)).

Lemma norm_nonneg w : 0 <= norm w.
Proof. apply S4_nonneg; intro; apply Rabs_pos. Qed.

Lemma axis_error w d g h :
  norm w <= g -> 0 <= h -> (forall i, Rabs (d i) <= h) -> Rabs (S4 (fun i => w i * d i)) <= g * h.
Proof.
  intros G H D.
  apply Rle_trans with (1 := S4_abs _).
  apply Rle_trans with (S4 (fun i => Rabs (w i) * h)).
  - apply S4_le; intro i; rewrite Rabs_mult.
    apply Rmult_le_compat_l; [apply Rabs_pos | apply D].
  - rewrite S4_scale_r; apply Rmult_le_compat_r; [exact H | exact G].
Qed.

Lemma axis_difference w d e g h :
  norm w <= g -> 0 <= h -> (forall i, Rabs (d i - e i) <= h) ->
  Rabs (S4 (fun i => w i * d i) - S4 (fun i => w i * e i)) <= g * h.
Proof.
  intros G H D.
  rewrite <- S4_minus, (S4_ext _ (fun i => w i * (d i - e i))) by (intro; ring).
  apply axis_error; assumption.
Qed.

Lemma norm_within w b n e : norm b <= n -> norm (fun i => w i - b i) <= e -> norm w <= n + e.
Proof.
  intros B E; apply Rle_trans with (norm b + norm (fun i => w i - b i)); [|lra].
  unfold norm; rewrite <- S4_plus; apply S4_le; intro i.
  replace (w i) with (b i + (w i - b i)) at 1 by ring; apply Rabs_triang.
Qed.

Lemma norm_of_error w b e : norm b <= 1 -> norm (fun i => w i - b i) <= e -> norm w <= 1 + e.
Proof. apply norm_within. Qed.

(** Three axes. *)
Lemma sum3_le f g : (forall l m n, f l m n <= g l m n) -> sum3 f <= sum3 g.
Proof. intro H; do 3 (apply S4_le; intro); apply H. Qed.

Lemma sum3_ext f g : (forall l m n, f l m n = g l m n) -> sum3 f = sum3 g.
Proof. intro H; do 3 (apply S4_ext; intro); apply H. Qed.

Lemma sum3_abs f : Rabs (sum3 f) <= sum3 (fun l m n => Rabs (f l m n)).
Proof.
  apply Rle_trans with (1 := S4_abs _); apply S4_le; intro l.
  apply Rle_trans with (1 := S4_abs _); apply S4_le; intro m; apply S4_abs.
Qed.

Lemma sum3_plus f g : sum3 (fun l m n => f l m n + g l m n) = sum3 f + sum3 g.
Proof.
  unfold sum3; rewrite <- S4_plus; apply S4_ext; intro l.
  rewrite <- S4_plus; apply S4_ext; intro m; apply S4_plus.
Qed.

Lemma sum3_minus f g : sum3 (fun l m n => f l m n - g l m n) = sum3 f - sum3 g.
Proof.
  unfold sum3; rewrite <- S4_minus; apply S4_ext; intro l.
  rewrite <- S4_minus; apply S4_ext; intro m; apply S4_minus.
Qed.

Lemma sum3_scale c f : sum3 (fun l m n => c * f l m n) = c * sum3 f.
Proof.
  unfold sum3; rewrite <- S4_scale; apply S4_ext; intro l.
  rewrite <- S4_scale; apply S4_ext; intro m; apply S4_scale.
Qed.

Lemma sum3_const c : sum3 (fun _ _ _ => c) = 64 * c.
Proof. unfold sum3, S4; ring. Qed.

Lemma sum3_product x y z : sum3 (fun l m n => x l * y m * z n) = S4 x * S4 y * S4 z.
Proof.
  unfold sum3.
  rewrite (S4_ext _ (fun l => x l * (S4 y * S4 z))); [rewrite S4_scale_r; ring|].
  intro l; rewrite (S4_ext _ (fun m => x l * y m * S4 z)) by (intro; apply S4_scale).
  rewrite S4_scale_r, S4_scale; ring.
Qed.

(** Eq. (1): the weights of three axes and 64 numbers, one axis inside the other. *)
Definition eq1 (s t u : nat -> R) (p : nat -> nat -> nat -> R) :=
  S4 (fun l => s l * S4 (fun m => t m * S4 (fun n => u n * p l m n))).

Lemma eq1_flat s t u p : eq1 s t u p = sum3 (fun l m n => s l * t m * u n * p l m n).
Proof.
  unfold eq1, sum3; apply S4_ext; intro l.
  rewrite <- S4_scale; apply S4_ext; intro m.
  rewrite <- !S4_scale; apply S4_ext; intro n; ring.
Qed.

(** How far 64 products of weights are from others, in all. *)
Definition distance (d b : nat -> nat -> nat -> R) :=
  sum3 (fun l m n => Rabs (d l m n - b l m n)).
Definition products (s t u : nat -> R) l m n := s l * t m * u n.

Lemma weighted_difference d b p a :
  distance d b <= a -> (forall l m n, Rabs (p l m n) <= 1) ->
  Rabs (sum3 (fun l m n => d l m n * p l m n) - sum3 (fun l m n => b l m n * p l m n)) <= a.
Proof.
  intros A P; rewrite <- sum3_minus.
  apply Rle_trans with (1 := sum3_abs _); apply Rle_trans with (2 := A).
  apply sum3_le; intros; rewrite <- Rmult_minus_distr_r, Rabs_mult.
  rewrite <- (Rmult_1_r (Rabs (d l m n - b l m n))) at 2.
  apply Rmult_le_compat_l; [apply Rabs_pos | apply P].
Qed.

Lemma distance_triangle d c b : distance d b <= distance d c + distance c b.
Proof.
  unfold distance; rewrite <- sum3_plus; apply sum3_le; intros.
  replace (d l m n - b l m n) with ((d l m n - c l m n) + (c l m n - b l m n)) by ring.
  apply Rabs_triang.
Qed.

Lemma sum3_norm s t u : sum3 (fun l m n => Rabs (products s t u l m n)) = norm s * norm t * norm u.
Proof.
  unfold norm; rewrite <- sum3_product; apply sum3_ext; intros; unfold products.
  rewrite !Rabs_mult; reflexivity.
Qed.

(** From the errors of three axes alone. *)
Lemma distance_of_axes s t u bs bt bu e :
  0 <= e -> norm bs <= 1 -> norm bt <= 1 -> norm bu <= 1 ->
  norm (fun i => s i - bs i) <= e -> norm (fun i => t i - bt i) <= e ->
  norm (fun i => u i - bu i) <= e ->
  distance (products s t u) (products bs bt bu) <= (1 + e) * (1 + e) * (1 + e) - 1.
Proof.
  intros E0 Bs Bt Bu Es Et Eu.
  pose proof (norm_of_error _ _ _ Bt Et) as T; pose proof (norm_of_error _ _ _ Bu Eu) as U.
  pose proof (norm_nonneg bs); pose proof (norm_nonneg bt); pose proof (norm_nonneg bu).
  pose proof (norm_nonneg t); pose proof (norm_nonneg u).
  set (x := fun i => s i - bs i) in *; set (y := fun i => t i - bt i) in *.
  set (z := fun i => u i - bu i) in *.
  pose proof (norm_nonneg x); pose proof (norm_nonneg y); pose proof (norm_nonneg z).
  apply Rle_trans with (norm x * norm t * norm u + norm bs * norm y * norm u + norm bs * norm bt * norm z).
  - rewrite <- !sum3_norm, <- !sum3_plus; apply sum3_le; intros; unfold products, x, y, z.
    replace (s l * t m * u n - bs l * bt m * bu n) with
      ((s l - bs l) * t m * u n + bs l * (t m - bt m) * u n + bs l * bt m * (u n - bu n)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _); apply Rplus_le_compat_r; apply Rabs_triang.
  - replace ((1 + e) * (1 + e) * (1 + e) - 1) with
      (e * (1 + e) * (1 + e) + 1 * e * (1 + e) + 1 * 1 * e) by ring.
    repeat apply Rplus_le_compat; repeat apply Rmult_le_compat; try assumption; try lra;
      repeat apply Rmult_le_pos; try assumption; lra.
Qed.
