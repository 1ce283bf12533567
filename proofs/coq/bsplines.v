(******************************************************************************)
(* B-spline functions: control points as blossom values, Marsden's identity.  *)
(*                                                                            *)
(*   t : nat -> F          == the knots                                       *)
(*   window t d j          == t_j, ..., t_(j+d-1) (progressive.v)             *)
(*   basis t J k j x       == N_(j,k)(x), the B-spline function of degree k   *)
(*                            that starts at t_j, on the segment from t_J to  *)
(*                            t_(J+1), by the recursion of Cox and de Boor;   *)
(*                            a fraction with denominator 0 counts as 0       *)
(*   separated t J         == no knot up to t_J equals a knot after it; so it *)
(*                            is when t is sorted and t_J < t_(J+1)           *)
(*                                                                            *)
(* Let S_k be the sum over j of f(t_(j+1) ... t_(j+k) x^(d-k)) N_(j,k)(x).    *)
(* Expanding N_(j,k) by its recursion and collecting the terms with N_(j,k-1),*)
(* the two coefficients are those of x between t_j and t_(j+k), and f is      *)
(* affine: S_k = S_(k-1). Hence S_d = S_0 = f(x^d) = P(x): the coefficient of *)
(* N_(j,d) is the blossom at the d knots inside its support. The constant 1   *)
(* gives the partition of unity, the power (X - y)^d Marsden's identity.      *)
(*                                                                            *)
(* Statements: derose-progressive-vij, derose-46-cubic-scheme,                *)
(* derose-46-deboor, hart-bspline-segments, hart-four-points,                 *)
(* derose-46-five-points.                                                     *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Blossom Require Import notions existence casteljau conversion misprints.
From Blossom Require Import progressive.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section BSplines.
Variables (F : fieldType) (t : nat -> F) (J : nat).

Fixpoint basis k j (x : F) : F :=
  if k is k'.+1 then
    (x - t j) / (t (j + k) - t j) * basis k' j x
      + (t (j + k).+1 - x) / (t (j + k).+1 - t j.+1) * basis k' j.+1 x
  else (j == J)%:R.

Definition separated : Prop :=
  forall i l, (i <= J)%N -> (J < l)%N -> t i != t l.

Lemma basis_support k j x : ~~ (j <= J <= j + k)%N -> basis k j x = 0.
Proof.
elim: k j => [|k IHk] j out /=.
  by move: out; rewrite addn0 -eqn_leq => /negPf->.
rewrite !IHk ?mulr0 ?addr0 //; apply: contra out => /andP[le_j le_J].
  by rewrite (ltnW le_j) addnS -addSn.
by rewrite le_j (leq_trans le_J) // addnS.
Qed.

Theorem bspline_blossom d (P : {poly F}) x : separated -> (d <= J)%N ->
  \sum_(j < J.+1) blossom d P (window t d j.+1) * basis d j x =
    blossom d P (nseq d x).
Proof.
move=> sep le_dJ.
suff level k : (k <= d)%N ->
    \sum_(j < J.+1) blossom d P (window t k j.+1 ++ nseq (d - k) x) * basis k j x
      = blossom d P (nseq d x).
  rewrite -[RHS](level d) //; apply: eq_bigr => j _.
  by rewrite subnn cats0.
elim: k => [|k IHk] le_kd.
  rewrite (bigD1 ord_max) //= eqxx mulr1 subn0 big1 ?addr0 // => j ne_j.
  by rewrite -[_ == _]/(j == ord_max) (negPf ne_j) mulr0.
rewrite -(IHk (ltnW le_kd)).
pose f j := blossom d P (window t k.+1 j ++ nseq (d - k.+1) x).
pose s j := fraction (t j) (t (j + k.+1)) x.
have expand (j : nat) : (j <= J)%N -> f j.+1 * basis k.+1 j x =
    s j * f j.+1 * basis k j x + (1 - s j.+1) * f j.+1 * basis k j.+1 x.
  move=> le_j; rewrite /= mulrDr; congr (_ + _).
    by rewrite mulrA [f _ * _]mulrC.
  rewrite mulrA [f _ * _]mulrC; case: (ltnP j J) => [lt_jJ | ge_j]; last first.
    by rewrite basis_support ?mulr0 // ltnNge ge_j.
  case: (leqP J (j.+1 + k)) => [le_J | lt_J]; last first.
    by rewrite basis_support ?mulr0 // negb_and -!ltnNge lt_J orbT.
  congr (_ * _ * _); have ne : t (j + k.+1).+1 - t j.+1 != 0.
    rewrite subr_eq0 eq_sym; apply: sep => //.
    by rewrite ltnS addnS -addSn.
  apply: (mulIf ne); rewrite divfK // mulrBl mul1r /s /fraction addSn divfK //.
  by rewrite opprB addrA subrK.
pose T j := (1 - s j) * f j * basis k j x.
have shift : \sum_(j < J.+1) T j.+1 = \sum_(j < J.+1) T j.
  transitivity (\sum_(j < J.+2) T j).
    rewrite [RHS]big_ord_recl /T basis_support ?mulr0 ?add0r //.
    by rewrite negb_and -!ltnNge add0n (leq_trans le_kd) // orbT.
  by rewrite big_ord_recr /T /= [basis k J.+1 x]basis_support ?ltnn // mulr0 addr0.
rewrite (eq_bigr (fun j : 'I_J.+1 => s j * f j.+1 * basis k j x + T j.+1)).
  rewrite big_split /= shift -big_split; apply: eq_bigr => j _ /=.
  case: (leqP J (j + k)) => [le_J | lt_J]; last first.
    by rewrite /T basis_support ?mulr0 ?addr0 // negb_and -!ltnNge lt_J orbT.
  rewrite /T -mulrDl addrC; congr (_ * _); rewrite -(subnSK le_kd) /=.
  have ne : t j != t (j + k.+1) by apply: sep; [rewrite -ltnS | rewrite addnS ltnS].
  rewrite (blossom_between d P _ _ _ ne) /f [window t k.+1 j]windowS.
  rewrite [window t k.+1 j.+1]windowSr addSnnS.
  congr (_ * _ + _ * _); apply: blossom_perm.
    by rewrite perm_sym -cat1s perm_catCA.
  by rewrite cat_rcons.
by move=> j _; rewrite -expand // -ltnS.
Qed.

(** The control points determine the segment, and the sum of control points
    times B-spline functions is this segment. *)

Theorem bspline_segment d (c : nat -> F) : d`!%:R != 0 :> F ->
  separated -> (d <= J)%N ->
  exists2 P : {poly F}, (size P <= d.+1)%N &
    (forall j, (J - d <= j <= J)%N -> c j = blossom d P (window t d j.+1)) /\
    (forall x, \sum_(j < J.+1) c j * basis d j x = P.[x]).
Proof.
move=> d_unit sep le_dJ; set m := (J - d)%N.
pose t' i := t (m.+1 + i)%N.
have m_d : (m + d = J)%N by rewrite subnK.
have knots : progressive t' d.
  move=> j l /andP[_ lt_j]; apply: sep; rewrite addSn ?ltnS.
    by rewrite -m_d -addnS leq_add2l.
  by rewrite addnA m_d leq_addr.
have [|P P_deg points] := progressive_exists
  (v := mkseq (fun i => c (m + i)%N) d.+1) d_unit knots.
  exact: size_mkseq.
have control j : (m <= j <= J)%N -> c j = blossom d P (window t d j.+1).
  case/andP=> le_mj le_jJ; have lt_i : (j - m < d.+1)%N.
    by rewrite ltnS leq_subLR m_d.
  have := congr1 (fun v => v`_(j - m)) points; rewrite !nth_mkseq // subnKC //.
  move=> <-; congr (blossom _ _ _).
  rewrite /window -[in RHS](subnKC le_mj) -addSn iotaDl -map_comp.
  exact: eq_map.
exists P => //; split=> // x.
rewrite -(blossom_diagonal _ d_unit P_deg) -bspline_blossom //.
apply: eq_bigr => j _; case: (leqP m j) => [le_mj | lt_jm].
  by rewrite control // le_mj -ltnS ltn_ord.
have lt_J : (j + d < J)%N by move: lt_jm; rewrite -(ltn_add2r d) m_d.
by rewrite basis_support ?mulr0 // negb_and -!ltnNge lt_J orbT.
Qed.

(** Partition of unity and Marsden's identity. *)

Theorem partition_of_unity d x : separated -> (d <= J)%N ->
  \sum_(j < J.+1) basis d j x = 1.
Proof.
move=> sep le_dJ; have := bspline_blossom 1 x sep le_dJ.
rewrite blossom_one => <-; apply: eq_bigr => j _.
by rewrite blossom_one mul1r.
Qed.

Theorem marsden d x y : d`!%:R != 0 :> F -> separated -> (d <= J)%N ->
  \sum_(j < J.+1) (\prod_(u <- window t d j.+1) (u - y)) * basis d j x =
    (x - y) ^+ d.
Proof.
move=> d_unit sep le_dJ.
have := bspline_blossom (('X - y%:P) ^+ d) x sep le_dJ.
rewrite blossom_power ?size_nseq //.
have -> : \prod_(u <- nseq d x) (u - y) = (x - y) ^+ d.
  by rewrite big_nseq -Monoid.iteropE.
move=> <-.
by apply: eq_bigr => j _; rewrite blossom_power // size_map size_iota.
Qed.

End BSplines.
