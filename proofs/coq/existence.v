(******************************************************************************)
(* Every polynomial of degree at most n has a blossom of formal degree n.     *)
(*                                                                            *)
(* Notions: notions.v. The hypothesis n! != 0 says that n! can be divided by; *)
(* it holds for every n over the rationals, the reals, the complex numbers.   *)
(*                                                                            *)
(* The product of the factors 1 + u X of the arguments has as coefficient of  *)
(* X^k the elementary symmetric function: the sum over all k-element subsets  *)
(* of the products of their members. The product is symmetric in the          *)
(* arguments, and each factor is linear in its pair. On the diagonal it is    *)
(* (w + t X)^n, with coefficients C(n,k) t^k w^(n-k), and the functional      *)
(* divides by C(n,k).                                                         *)
(*                                                                            *)
(* Statements: derose-thm1-exist, derose-eq2 and derose-eq3 (corrected:       *)
(* subsets), derose-linearity, goldman-prop1, goldman-thm2, goldman-hunique   *)
(* (existence), goldman-axiom-sym, -affine, -diag, goldman-haxioms,           *)
(* goldman-ex-1.                                                              *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Blossom Require Import notions.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

(** Pascal's triangle, under a sum. *)

Lemma pascal_sum (W : zmodType) (T : nat -> W) m :
  \sum_(j < m.+2) T j *+ 'C(m.+1, j) =
    \sum_(j < m.+1) T j *+ 'C(m, j) + \sum_(j < m.+1) T j.+1 *+ 'C(m, j).
Proof.
rewrite big_ord_recl; under eq_bigr do rewrite lift0 binS mulrnDr.
rewrite big_split addrA; congr (_ + _); rewrite [RHS]big_ord_recl !bin0.
rewrite big_ord_recr /= bin_small // mulr0n addr0; congr (_ + _).
Qed.

Section Existence.
Variable F : fieldType.
Implicit Types (P Q : {poly F}) (us vs : seq F) (ws : seq (F * F)).

(** The functional is linear in both of its polynomials. *)

Lemma functionalD n P Q R :
  functional n P (Q + R) = functional n P Q + functional n P R.
Proof.
rewrite /functional -big_split /=; apply: eq_bigr => k _.
by rewrite coefD mulrDr mulrDl.
Qed.

Lemma functionalZ n P a Q : functional n P (a *: Q) = a * functional n P Q.
Proof.
rewrite /functional big_distrr /=; apply: eq_bigr => k _.
by rewrite coefZ mulrCA -!mulrA.
Qed.

Lemma functional0 n P : functional n P 0 = 0.
Proof. by rewrite -[0](scale0r 0) functionalZ mul0r. Qed.

Lemma functional_sum n P I (r : seq I) (p : pred I) (Q : I -> {poly F}) :
  functional n P (\sum_(i <- r | p i) Q i) =
    \sum_(i <- r | p i) functional n P (Q i).
Proof.
by apply: (big_morph _ (functionalD n P)); rewrite functional0.
Qed.

Lemma functional_linear n (a b : F) P Q R :
  functional n (a *: P + b *: Q) R =
    a * functional n P R + b * functional n Q R.
Proof.
rewrite /functional !big_distrr -big_split; apply: eq_bigr => k _ /=.
by rewrite coefD !coefZ mulrDl mulrDl !mulrA.
Qed.

(** The product of the factors is symmetric and linear in each pair. *)

Lemma factors_cat ws ws' : factors (ws ++ ws') = factors ws * factors ws'.
Proof. exact: big_cat. Qed.

Lemma factors_cons w ws : factors (w :: ws) = (w.2%:P + w.1 *: 'X) * factors ws.
Proof. exact: big_cons. Qed.

Lemma factors_nil : factors [::] = 1 :> {poly F}.
Proof. exact: big_nil. Qed.

Lemma factors_nseq m (w : F * F) : factors (nseq m w) = (w.2%:P + w.1 *: 'X) ^+ m.
Proof. by rewrite /factors big_nseq -Monoid.iteropE. Qed.

Lemma factors_insert ws w ws' :
  factors (ws ++ w :: ws') = (w.2%:P + w.1 *: 'X) * factors (ws ++ ws').
Proof. by rewrite !factors_cat factors_cons mulrCA. Qed.

Lemma factors_combination ws (x y : F * F) (a b : F) ws' :
  factors (ws ++ (a * x.1 + b * y.1, a * x.2 + b * y.2) :: ws') =
    a *: factors (ws ++ x :: ws') + b *: factors (ws ++ y :: ws').
Proof.
rewrite !factors_insert !scalerAl -mulrDl /=; congr (_ * _).
by rewrite polyCD !polyCM scalerDl !scalerDr !scalerA !mul_polyC addrACA.
Qed.

Lemma hblossom_perm n P ws ws' :
  perm_eq ws ws' -> hblossom n P ws = hblossom n P ws'.
Proof. by move=> eq_ws; rewrite /hblossom /factors (perm_big _ eq_ws). Qed.

Lemma blossom_perm n P us vs :
  perm_eq us vs -> blossom n P us = blossom n P vs.
Proof. by move=> eq_us; apply/hblossom_perm/perm_map. Qed.

Lemma hblossom_combination n P ws (x y : F * F) (a b : F) ws' :
  hblossom n P (ws ++ (a * x.1 + b * y.1, a * x.2 + b * y.2) :: ws') =
    a * hblossom n P (ws ++ x :: ws') + b * hblossom n P (ws ++ y :: ws').
Proof. by rewrite /hblossom factors_combination functionalD !functionalZ. Qed.

Lemma blossom_combination n P us x y a b vs : a + b = 1 ->
  blossom n P (us ++ (a * x + b * y) :: vs) =
    a * blossom n P (us ++ x :: vs) + b * blossom n P (us ++ y :: vs).
Proof.
move=> ab1; rewrite /blossom !map_cat !map_cons -hblossom_combination.
by rewrite /point /= !mulr1 ab1.
Qed.

(** The coefficients are invertible where n! is. *)

Lemma factorial_unit n m :
  (m <= n)%N -> n`!%:R != 0 :> F -> m`!%:R != 0 :> F.
Proof.
move=> le_mn; rewrite -(bin_fact le_mn) natrM natrM !mulf_eq0 !negb_or.
by case/andP=> _ /andP[].
Qed.

Lemma binomial_unit n m :
  (m <= n)%N -> n`!%:R != 0 :> F -> 'C(n, m)%:R != 0 :> F.
Proof.
by move=> le_mn; rewrite -(bin_fact le_mn) natrM mulf_eq0 negb_or => /andP[].
Qed.

Lemma nat_unit n m :
  (0 < m <= n)%N -> n`!%:R != 0 :> F -> m%:R != 0 :> F.
Proof.
case/andP=> m_gt0 le_mn /(factorial_unit le_mn).
by rewrite -(prednK m_gt0) factS natrM mulf_eq0 negb_or => /andP[].
Qed.

(** The coefficients of a power of one factor. *)

Lemma coef_factor_power (t w : F) m k :
  ((w%:P + t *: 'X) ^+ m)`_k = (t ^+ k * w ^+ (m - k)) *+ 'C(m, k).
Proof.
rewrite exprDn coef_sum.
have term (i : 'I_m.+1) :
  ((w%:P ^+ (m - i) * (t *: 'X) ^+ i) *+ 'C(m, i))`_k =
    if k == i then (t ^+ k * w ^+ (m - k)) *+ 'C(m, k) else 0.
  rewrite coefMn exprZn -polyC_exp -scalerAr coefZ coefCM coefXn.
  by case: eqP => [-> | _] /=; rewrite ?mulr1 // !mulr0 mul0rn.
rewrite (eq_bigr _ (fun i _ => term i)) -big_mkcond /=.
case: (ltnP k m.+1) => [lt_km | lt_mk].
  by rewrite (big_pred1 (Ordinal lt_km)) // => i; rewrite eq_sym.
by rewrite bin_small // mulr0n big1.
Qed.

Theorem hblossom_diagonal n P t w : n`!%:R != 0 :> F ->
  hblossom n P (nseq n (t, w)) = homogenized n P t w.
Proof.
move=> n_unit; rewrite /hblossom /functional factors_nseq.
apply: eq_bigr => k _; rewrite coef_factor_power /= mulrnAr -mulr_natr mulrA.
by rewrite mulfK // binomial_unit // -ltnS.
Qed.

Lemma homogenized1 n P t : (size P <= n.+1)%N -> homogenized n P t 1 = P.[t].
Proof.
move=> P_deg; rewrite (horner_coef_wide t P_deg).
by apply: eq_bigr => k _; rewrite expr1n mulr1.
Qed.

Theorem blossom_diagonal n P t : n`!%:R != 0 :> F -> (size P <= n.+1)%N ->
  blossom n P (nseq n t) = P.[t].
Proof.
by move=> ? ?; rewrite /blossom map_nseq hblossom_diagonal ?homogenized1.
Qed.

(** Existence: Theorem 1 of DeRose, Theorem 2 of Goldman. *)

Theorem blossom_exists n P : n`!%:R != 0 :> F -> (size P <= n.+1)%N ->
  is_blossom n P (blossom n P).
Proof.
move=> n_unit P_deg; split=> [us vs _ | us vs x y a _ | t].
- exact: blossom_perm.
- by apply: blossom_combination; rewrite subrK.
- exact: blossom_diagonal.
Qed.

Theorem hblossom_exists n P : n`!%:R != 0 :> F ->
  is_hblossom n P (hblossom n P).
Proof.
move=> n_unit; split=> [us vs _ | us vs x y a b _ | [t w]].
- exact: hblossom_perm.
- exact: hblossom_combination.
- exact: hblossom_diagonal.
Qed.

(** Linearity in the polynomial. *)

Theorem hblossom_linear n (a b : F) P Q ws :
  hblossom n (a *: P + b *: Q) ws = a * hblossom n P ws + b * hblossom n Q ws.
Proof. exact: functional_linear. Qed.

Theorem blossom_linear n (a b : F) P Q us :
  blossom n (a *: P + b *: Q) us = a * blossom n P us + b * blossom n Q us.
Proof. exact: hblossom_linear. Qed.

(** The elementary symmetric functions: Proposition 1 of Goldman, equations
    (2) and (3) of DeRose, with subsets. *)

Lemma coef_factors us k :
  (factors [seq point u | u <- us])`_k =
    \sum_(S <- subsets k us) \prod_(u <- S) u.
Proof.
elim: us k => [|u us IHus] k.
  rewrite factors_nil coef1; case: k => [|k] /=; last by rewrite big_nil.
  by rewrite big_seq1 big_nil.
rewrite /= factors_cons mulrDl mul1r coefD IHus -scalerAl coefZ coefXM.
case: k => [|k]; first by rewrite mulr0 addr0.
rewrite [subsets _ _]/= big_cat big_map addrC IHus big_distrr; congr (_ + _).
by apply: eq_bigr => S _; rewrite big_cons.
Qed.

Theorem blossom_subsets n P us :
  blossom n P us =
    \sum_(k < n.+1) P`_k * (\sum_(S <- subsets k us) \prod_(u <- S) u)
                    / 'C(n, k)%:R.
Proof. by apply: eq_bigr => k _; rewrite coef_factors. Qed.

Theorem size_subsets (T : Type) k (xs : seq T) :
  size (subsets k xs) = 'C(size xs, k).
Proof.
elim: xs k => [|x xs IHxs] [|k] //=; first by rewrite IHxs !bin0.
by rewrite size_cat size_map !IHxs addnC -binS.
Qed.

End Existence.
