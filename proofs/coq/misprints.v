(******************************************************************************)
(* Misprints of the literature that are general statements: their negations.  *)
(*                                                                            *)
(* Notions: notions.v. Each theorem says that the printed statement is false, *)
(* and its proof names the polynomial and the arguments at which it fails. It *)
(* needs only that n! is not zero, in every field; where a number must differ *)
(* from another the degree is fixed, or the field is the rational numbers.    *)
(*                                                                            *)
(* The examples are the constant 1, whose blossom is 1, and t, whose blossom  *)
(* is the mean of the arguments: a blossom is affine in each argument, and    *)
(* most misprints treat it as linear or forget a term of an affine sum.       *)
(*                                                                            *)
(* Statements: blog-derivative, blog-elevation, blog-multiaffine,             *)
(* blog-quadratic-form, derose-eq2,                                           *)
(* fj-bernstein-def, fj-reduction-not-multiaffine, fj-reduction-is-lagrange,  *)
(* goldman-ex-12a, goldman-monomial-scale, goldman-thm8,                      *)
(* goldman-summary-diff, hart-linear-scale, hart-linear-add, hart-lerp-line2, *)
(* hart-lerp-line3, fj-eq23, fj-ex1-quadratic.                                *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Blossom Require Import notions existence elevation casteljau.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

(** The blossom of the constant 1, and of t^n. *)

Lemma blossom_one (F : fieldType) n (us : seq F) : blossom n 1 us = 1.
Proof.
rewrite blossom_subsets big_ord_recl coef1 /= bin0 divr1 mul1r.
have -> : subsets 0 us = [:: [::]] by elim: us.
rewrite big_seq1 big_nil big1 ?addr0 // => k _.
by rewrite coef1 /= !mul0r.
Qed.

Lemma subsets_all (T : Type) (us : seq T) : subsets (size us) us = [:: us].
Proof.
have big (vs : seq T) : subsets (size vs).+1 vs = [::].
  by apply: size0nil; rewrite size_subsets bin_small.
by elim: us => //= u us ->; rewrite big.
Qed.

Lemma blossom_top (F : fieldType) (us : seq F) :
  blossom (size us) 'X^(size us) us = \prod_(u <- us) u.
Proof.
rewrite blossom_subsets big_ord_recr /= coefXn eqxx binn divr1 mul1r.
rewrite subsets_all big_seq1 big1 ?add0r // => k _.
by rewrite coefXn (ltn_eqF (ltn_ord k)) !mul0r.
Qed.

Section AnyField.
Variables (F : fieldType) (n : nat).
Hypothesis n_gt0 : (0 < n)%N.

(** blog-derivative: the derivative is not n times the value with one argument
    equal to the number 1; the last argument is the vector. *)

Theorem misprint_blog_derivative : n%:R != 0 :> F ->
  ~ (forall (P : {poly F}) t, (size P <= n.+1)%N ->
       P^`().[t] = n%:R * blossom n P (rcons (nseq n.-1 t) 1)).
Proof.
move=> n_unit /(_ 1 0); rewrite size_poly1 derivC horner0 blossom_one mulr1.
by move=> /(_ isT) n0; rewrite -n0 eqxx in n_unit.
Qed.

(** blog-elevation: n + 2 terms divided by n + 1 cannot be right. *)

Theorem misprint_blog_elevation : n.+1%:R != 0 :> F ->
  ~ (forall (P : {poly F}) us (extra : seq F), size us = n.+1 ->
       blossom n.+1 P us =
         (blossom n P extra + \sum_(i < n.+1) blossom n P (omit i us))
           / n.+1%:R).
Proof.
move=> n_unit /(_ 1 (nseq n.+1 0) [::]); rewrite size_nseq !blossom_one.
under eq_bigr do rewrite blossom_one.
rewrite sumr_const card_ord -mulrS => /(_ erefl)/eqP.
rewrite eq_sym -subr_eq0 -[X in _ - X](mulfV n_unit) -mulrBl mulf_eq0.
rewrite invr_eq0 (negPf n_unit) orbF mulrS addrK.
by rewrite oner_eq0.
Qed.

(** goldman-ex-12a: n terms divided by n + 1 cannot be right either. *)

Theorem misprint_goldman_ex_12a : n.+1%:R != 0 :> F ->
  ~ (forall (P : {poly F}) us, size us = n.+1 ->
       blossom n.+1 P us = (\sum_(i < n) blossom n P (omit i us)) / n.+1%:R).
Proof.
move=> n_unit /(_ 1 (nseq n.+1 0)); rewrite size_nseq blossom_one.
under eq_bigr do rewrite blossom_one.
rewrite sumr_const card_ord => /(_ erefl)/eqP.
rewrite eq_sym -subr_eq0 -[X in _ - X](mulfV n_unit) -mulrBl mulf_eq0.
rewrite invr_eq0 (negPf n_unit) orbF mulrS opprD addrA addrAC subrr.
by rewrite sub0r oppr_eq0 oner_eq0.
Qed.

(** blog-multiaffine: without the condition b + c = 1. *)

Theorem misprint_blog_multiaffine :
  ~ (forall (P : {poly F}) us x y (b c : F), size us = n.-1 ->
       blossom n P (b * x + c * y :: us) =
         b * blossom n P (x :: us) + c * blossom n P (y :: us)).
Proof.
move=> /(_ 1 (nseq n.-1 0) 0 0 1 1); rewrite size_nseq !blossom_one !mul1r.
by move=> /(_ erefl)/eqP; rewrite -subr_eq0 opprD addrA subrr sub0r oppr_eq0
  oner_eq0.
Qed.

(** hart-linear-scale: a blossom of points does not scale in one argument. *)

Theorem misprint_hart_linear_scale (alpha : F) : alpha != 1 ->
  ~ (forall (P : {poly F}) x us, size us = n.-1 ->
       alpha * blossom n P (x :: us) = blossom n P (alpha * x :: us)).
Proof.
move=> alpha_ne1 /(_ 1 0 (nseq n.-1 0)); rewrite size_nseq !blossom_one mulr1.
by move=> /(_ erefl) alpha1; rewrite alpha1 eqxx in alpha_ne1.
Qed.

(** hart-linear-add: nor does it add in one argument. *)

Theorem misprint_hart_linear_add :
  ~ (forall (P : {poly F}) x y us, size us = n.-1 ->
       blossom n P (x + y :: us) = blossom n P (x :: us) + blossom n P (y :: us)).
Proof.
move=> /(_ 1 0 0 (nseq n.-1 0)); rewrite size_nseq !blossom_one.
by move=> /(_ erefl)/eqP; rewrite -subr_eq0 opprD addrA subrr sub0r oppr_eq0
  oner_eq0.
Qed.

(** hart-lerp-line2, hart-lerp-line3: the linear step in the derivation of a
    linear interpolation. *)

Theorem misprint_hart_lerp_line2 :
  ~ (forall (P : {poly F}) t us, size us = n.-1 ->
       (1 - t) * blossom n P (0 :: us) + t * blossom n P (1 :: us) =
         blossom n P (0 * (1 - t) :: us) + blossom n P (1 * t :: us)).
Proof.
move=> /(_ 1 0 (nseq n.-1 0)); rewrite size_nseq !blossom_one !mulr1 subrK.
by move=> /(_ erefl)/eqP; rewrite -subr_eq0 opprD addrA subrr sub0r oppr_eq0
  oner_eq0.
Qed.

Theorem misprint_hart_lerp_line3 :
  ~ (forall (P : {poly F}) t us, size us = n.-1 ->
       blossom n P (0 * (1 - t) :: us) + blossom n P (1 * t :: us) =
         blossom n P (0 * (1 - t) + 1 * t :: us)).
Proof.
move=> /(_ 1 0 (nseq n.-1 0)); rewrite size_nseq !blossom_one.
by move=> /(_ erefl)/eqP; rewrite -subr_eq0 addrK oner_eq0.
Qed.

(** goldman-monomial-scale: P(ct) = c^n P(t) does hold for some polynomials of
    degree n, namely for t^n. *)

Theorem misprint_goldman_monomial_scale :
  ~ (forall P : {poly F}, size P = n.+1 ->
       ~ forall c t, P.[c * t] = c ^+ n * P.[t]).
Proof.
move=> /(_ 'X^n); rewrite size_polyXn => /(_ erefl); apply=> c t.
by rewrite !hornerXn exprMn.
Qed.

(** goldman-thm8: the blossom of points is multiaffine, not multilinear; with
    delta replaced by the number 1 that it would be as a point, the binomial
    expansion fails: for the constant 1 and h = -1 it says 1 = (1 - 1)^n. *)

Theorem misprint_goldman_thm8 :
  ~ (forall (P : {poly F}) t h,
       blossom n P (nseq n (t + h)) =
         \sum_(k < n.+1) 'C(n, k)%:R
           * blossom n P (nseq (n - k) t ++ nseq k 1) * h ^+ k).
Proof.
move=> /(_ 1 0 (-1)); rewrite blossom_one.
rewrite (eq_bigr (fun k : 'I_n.+1 => 1 ^+ (n - k) * (-1) ^+ k *+ 'C(n, k))).
  by move/eqP; rewrite -exprDn subrr expr0n eqn0Ngt n_gt0 oner_eq0.
by move=> k _; rewrite blossom_one expr1n mulr1 mul1r mulr_natl.
Qed.

(** fj-bernstein-def: with the exponents exchanged the first control point is
    not the value at 0. *)

Theorem misprint_fj_bernstein_def :
  ~ (forall v : nat -> F,
       \sum_(i < n.+1) v i * ((1 - 0) ^+ i * 0 ^+ (n - i) *+ 'C(n, i)) = v 0%N).
Proof.
move=> /(_ (fun i => (i == 0%N)%:R)); rewrite big_ord_recl big1 => [|i _].
  rewrite /= addr0 mul1r subn0 expr0n eqn0Ngt n_gt0 mulr0 mul0rn.
  by move/esym/eqP; rewrite oner_eq0.
by rewrite lift0 mul0r.
Qed.

(** goldman-summary-diff: differentiation replaces t - a by 1 and b - t by -1
    on one level; with the first alone the result is wrong in every degree. *)

Lemma zip_nseq k (c : F) : zip (nseq k.+1 c) (nseq k c) = nseq k (c, c).
Proof. by elim: k => //= k <-. Qed.

Lemma casteljau_constant (a b c : F) us :
  casteljau a b (nseq (size us).+1 c) us = c.
Proof.
elim: us => //= u us IHus; rewrite -[RHS]IHus /casteljau /level /=.
congr (head 0 (foldl _ _ us)); rewrite /step /= zip_nseq map_nseq /=.
by rewrite -mulrDl subrK mul1r.
Qed.

Definition printed_level (a b t : F) (v : seq F) : seq F :=
  [seq ((b - t) * x.1 + 1 * x.2) / (b - a) | x <- zip v (behead v)].

Theorem misprint_goldman_summary_diff (a b : F) : n%:R != 0 :> F -> a != b ->
  ~ (forall (P : {poly F}) t, (size P <= n.+1)%N ->
       P^`().[t] = n%:R *
         casteljau a b (printed_level a b t (control_points n P a b)) (nseq n.-1 t)).
Proof.
move=> n_unit ab /(_ 1 b); rewrite size_poly1 derivC horner0 => /(_ isT)/eqP.
have -> : control_points n 1 a b = nseq n.+1 1.
  apply: (@eq_from_nth _ 0) => [|k]; rewrite size_mkseq ?size_nseq // => lt_k.
  by rewrite nth_mkseq // nth_nseq lt_k /control_point blossom_one.
rewrite /printed_level /= zip_nseq map_nseq /= subrr mul0r add0r !mul1r.
have := casteljau_constant a b (b - a)^-1 (nseq n.-1 b).
rewrite size_nseq prednK // => ->; rewrite eq_sym mulf_eq0 (negPf n_unit) invr_eq0 subr_eq0.
by rewrite eq_sym (negPf ab).
Qed.

(** derose-eq2: summed over all k-tuples of different indices, in place of the
    k-element subsets, the value is k! times too large. *)

Theorem misprint_derose_eq2 k : (k <= n)%N -> n`!%:R != 0 :> F ->
  k`!%:R != 1 :> F ->
  ~ (forall us : seq F, size us = n ->
       blossom n 'X^k us =
         (\sum_(i : k.-tuple 'I_n | uniq i) \prod_(j <- i) us`_j) / 'C(n, k)%:R).
Proof.
move=> le_kn n_unit fact_ne1 /(_ (nseq n 1)); rewrite size_nseq => /(_ erefl).
rewrite blossom_diagonal ?size_polyXn // hornerXn expr1n.
rewrite (eq_bigr (fun=> 1)) => [|i _]; last first.
  by rewrite big1 // => j _; rewrite nth_nseq ltn_ord.
have -> : \sum_(i : k.-tuple 'I_n | uniq i) 1 = (n ^_ k)%:R :> F.
  rewrite sumr_const; congr (_%:R).
  rewrite -[in RHS](card_ord n) -(card_uniq_tuples k (predT : pred 'I_n)).
  by apply: eq_card => i; rewrite !inE all_predT.
rewrite -bin_ffact natrM mulrAC mulfV ?binomial_unit // mul1r => /esym/eqP.
exact/negP.
Qed.

(** fj-eq23: indices from 1 leave out the vertices and edges of a triangle. *)

Theorem misprint_fj_eq23_indices :
  ~ (forall i j k, (i + j + k = n)%N -> [/\ (0 < i)%N, (0 < j)%N & (0 < k)%N]).
Proof. by move=> /(_ n 0%N 0%N); rewrite !addn0 => /(_ erefl)[]. Qed.

End AnyField.

Section Rational.

(** fj-ex1-quadratic: the weight 1 + alpha beta of the middle control point of
    a circle arc is not different from zero for all parameters in [-1, 1]. *)

Theorem misprint_fj_ex1_weight :
  ~ (forall al be : rat, -1 <= al <= 1 -> -1 <= be <= 1 -> 1 + al * be != 0).
Proof. by move=> /(_ 1 (-1) isT isT). Qed.

(** blog-quadratic-form: c_1 is the sum of the two coefficients, not half. *)

Theorem misprint_blog_quadratic_form :
  ~ (forall c0 c1 c2 d0 d1 d2 d3 : rat,
       (forall t, c0 + c1 * t + c2 * t ^+ 2 = d0 + d1 * t + d2 * t + d3 * (t * t)) ->
       c1 = (d1 + d2) / 2%:R).
Proof.
move=> /(_ 0 2%:R 0 0 1 1 0) half; have := half _.
suff /[swap] /[apply] : forall t : rat,
  0 + 2%:R * t + 0 * t ^+ 2 = 0 + 1 * t + 1 * t + 0 * (t * t) by [].
by move=> t; rewrite !mul0r !addr0 !add0r -mulrDl.
Qed.

(** fj-reduction-not-multiaffine: the inverse formula for degree 2, applied to
    t^3, is not affine in its arguments. *)

Theorem misprint_fj_reduction_not_multiaffine :
  let f (u w : rat) := (4%:R * ((u + w) / 2%:R) ^+ 3 - u ^+ 3 - w ^+ 3) / 2%:R in
  ~ (forall x y z c, f ((1 - c) * x + c * y) z = (1 - c) * f x z + c * f y z).
Proof. by move=> f /(_ 0 1 0 2%:R)/eqP; vm_compute. Qed.

(** fj-reduction-is-lagrange: the cubic with the control points that the
    inverse formula gives for b(t) = t^4 over [0, 1] does not pass through the
    point of the curve at 1/3, one of the parameters used. *)

Theorem misprint_fj_reduction_is_lagrange :
  let b (t : rat) := t ^+ 4 in
  let b1 := - b 0 + b 1 / 6%:R - 8%:R / 3%:R * b 2%:R^-1
              + 9%:R / 2%:R * b 3%:R^-1 in
  let b2 := b 0 / 6%:R - b 1 - 8%:R / 3%:R * b 2%:R^-1
              + 9%:R / 2%:R * b (2%:R / 3%:R) in
  let t := 3%:R^-1 in
  (1 - t) ^+ 3 * b 0 + 3%:R * t * (1 - t) ^+ 2 * b1
    + 3%:R * t ^+ 2 * (1 - t) * b2 + t ^+ 3 * b 1 <> b t.
Proof. by move=> b b1 b2 t /eqP; vm_compute. Qed.

End Rational.
