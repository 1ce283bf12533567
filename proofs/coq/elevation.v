(******************************************************************************)
(* Degree elevation: the same polynomial read with formal degree n + 1.       *)
(*                                                                            *)
(* Notions: notions.v, casteljau.v; omit i us leaves out the argument i. In   *)
(* the sum over i of the products of all factors but one, every k-element     *)
(* subset of the n + 1 arguments occurs n + 1 - k times, and                  *)
(* (n + 1 - k) C(n+1,k) = (n + 1) C(n,k).                                     *)
(*                                                                            *)
(* Statements: derose-raise-general, derose-raise-23, derose-raise-23-points, *)
(* blog-elevation (corrected: from 1), blog-elevated-points, goldman-ex-12a   *)
(* (corrected: to n + 1), goldman-ex-12b.                                     *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Blossom Require Import notions existence casteljau.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section Omit.
Variable T : Type.

Lemma omit_left i (xs ys : seq T) : (i < size xs)%N ->
  omit i (xs ++ ys) = omit i xs ++ ys.
Proof.
elim: xs i => [|x xs IHxs] [|i] //= lt_i; first by rewrite /omit /= !drop0.
by rewrite -[LHS]/(x :: omit i (xs ++ ys)) IHxs.
Qed.

Lemma omit_right i (xs ys : seq T) :
  omit (size xs + i) (xs ++ ys) = xs ++ omit i ys.
Proof. by elim: xs => //= x xs <-. Qed.

Lemma omit_nseq i m (x : T) : (i < m)%N -> omit i (nseq m x) = nseq m.-1 x.
Proof.
elim: m i => [|m IHm] [|i] // lt_i; first by rewrite /omit /= drop0.
by case: m IHm lt_i => [|m] // IHm lt_i; rewrite -[RHS]/(x :: nseq m x) -(IHm i).
Qed.

End Omit.

Section Elevation.
Variables (F : fieldType) (n : nat) (P : {poly F}).
Hypotheses (n_unit : n.+1`!%:R != 0 :> F) (P_deg : (size P <= n.+1)%N).

Let product (us : seq F) := factors [seq point u | u <- us].

Lemma coef_product_big us k : (size us < k)%N -> (product us)`_k = 0.
Proof.
move=> lt_k; rewrite coef_factors; have := size_subsets k us.
by rewrite bin_small // => /size0nil->; rewrite big_nil.
Qed.

Lemma coef_omit_sum us k :
  (\sum_(i < size us) product (omit i us))`_k =
    (product us)`_k *+ (size us - k).
Proof.
elim: us k => [|u us IHus] k /=; first by rewrite big_ord0 coef0 mulr0n.
rewrite big_ord_recl /= {1}/omit /= drop0 coefD.
have -> : \sum_(i < size us) product (omit (lift ord0 i) (u :: us)) =
    (1 + u *: 'X) * \sum_(i < size us) product (omit i us).
  rewrite big_distrr; apply: eq_bigr => i _.
  by rewrite /product map_cons factors_cons polyC1.
rewrite /product map_cons factors_cons /= polyC1 !mulrDl !mul1r -!/(product _).
rewrite !coefD -!scalerAl !coefZ !coefXM IHus; case: k => [|k] /=.
  by rewrite !mulr0 !addr0 !subn0 mulrS.
rewrite IHus subSS addrA; case: (ltnP k (size us)) => [lt_k | le_k].
  rewrite mulrnDl mulrnAr; congr (_ + _).
  by rewrite -(subnSK lt_k) mulrS.
have /eqP-> : (size us - k == 0)%N by rewrite subn_eq0.
have /eqP-> : (size us - k.+1 == 0)%N by rewrite subn_eq0 ltnW.
by rewrite !mulr0n coef_product_big ?mulr0 ?addr0.
Qed.

Theorem elevation us : size us = n.+1 ->
  blossom n.+1 P us =
    (\sum_(i < n.+1) blossom n P (omit i us)) / n.+1%:R.
Proof.
move=> size_us; rewrite /blossom /hblossom -functional_sum /functional.
rewrite big_ord_recr /= (nth_default _ P_deg) !mul0r addr0 big_distrl /=.
apply: eq_bigr => k _; have le_k : (k <= n)%N by rewrite -ltnS.
have := coef_omit_sum us k; rewrite size_us /product => ->.
have N_unit : n.+1%:R != 0 :> F by rewrite (nat_unit _ n_unit) //=.
have bin_unit : 'C(n, k)%:R != 0 :> F.
  by rewrite binomial_unit // (factorial_unit _ n_unit).
have bin_unit' : 'C(n.+1, k)%:R != 0 :> F by rewrite binomial_unit // leqW.
apply/eqP; rewrite -[X in _ == X]mulrA -invfM eqr_div ?mulf_neq0 //; apply/eqP.
rewrite -[_ *+ (_ - _)]mulr_natr -!mulrA; congr (_ * (_ * _)).
by rewrite -!natrM mulnC mul_bin_down.
Qed.

Theorem elevated_control_points a b k : (k <= n.+1)%N ->
  control_point n.+1 P a b k =
    k%:R / n.+1%:R * control_point n P a b k.-1
      + (n.+1 - k)%:R / n.+1%:R * control_point n P a b k.
Proof.
move=> le_k; rewrite /control_point elevation; last first.
  by rewrite size_cat !size_nseq subnK.
set us := _ ++ _.
rewrite -(big_mkord xpredT (fun i => blossom n P (omit i us))).
rewrite (@big_cat_nat _ _ _ (n.+1 - k)) ?leq_subr //=.
have at_a i : (0 <= i < n.+1 - k)%N ->
    blossom n P (omit i us) = blossom n P (nseq (n - k) a ++ nseq k b).
  by move=> lt_i; rewrite omit_left ?size_nseq // omit_nseq // subSKn.
have at_b i : (n.+1 - k <= i < n.+1)%N ->
    blossom n P (omit i us) = blossom n P (nseq (n - k.-1) a ++ nseq k.-1 b).
  case/andP=> le_i lt_i; rewrite -(subnKC le_i) -{1}(size_nseq (n.+1 - k) a).
  rewrite omit_right omit_nseq.
    case: k le_k {us at_a} le_i lt_i => [|k] _ //=.
    by rewrite subn0 => /leq_ltn_trans lt /lt; rewrite ltnn.
  by rewrite ltn_subLR // subnK.
rewrite (eq_big_nat _ _ at_a) (eq_big_nat _ _ at_b) !sumr_const_nat subn0 subKn //.
rewrite addrC mulrDl -[_ *+ k]mulr_natl -[_ *+ (n.+1 - k)]mulr_natl.
by rewrite ![_ / _ * _]mulrAC.
Qed.

End Elevation.
