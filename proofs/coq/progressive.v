(******************************************************************************)
(* The de Boor algorithm with any arguments, and its condition on the knots.  *)
(*                                                                            *)
(*   t : nat -> F          == the knots t_0, t_1, ...; one polynomial section *)
(*                            of degree d uses t_0, ..., t_(2d-1)             *)
(*   window t d j          == t_j, ..., t_(j+d-1): d consecutive knots        *)
(*   progressive_points    == the blossom at the windows j = 0, ..., d        *)
(*   deboor_step t d k v u == the k-th level: v_l and v_(l+1) are joined with *)
(*                            u between the knots t_(k+l) and t_(d+l)         *)
(*   deboor t d v us       == the single point left after d levels            *)
(*   progressive t d       == t_j <> t_(d+l) whenever l <= j <= d - 1         *)
(*                                                                            *)
(* The windows j and j + 1 share all knots but t_j and t_(j+d), so an         *)
(* argument u between these two gives the value with u for the missing knot.  *)
(* After k levels point l carries the label u_1 ... u_k t_(k+l) ... t_(d+l-1).*)
(* The printed figure divides by t_(d+k+l) - t_(k+l); the right end of the    *)
(* interval is t_(d+l). The algorithm divides by t_(d+l) - t_(k+l), and this  *)
(* is more than a precaution: if t_j = t_(d+l) = a for some l <= j < d, every *)
(* window contains a, and the polynomial (X - a)^d, whose blossom is the      *)
(* product of the u - a, has only zeros for control points.                   *)
(*                                                                            *)
(* Statements: derose-fig10, derose-fig10-comment1, derose-fig10-comment2     *)
(* (corrected), derose-46-progressive (necessary and sufficient),             *)
(* derose-progressive-vij, derose-fig9-sablonniere, derose-46-deboor.         *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Blossom Require Import notions existence casteljau conversion misprints.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section Progressive.
Variables (F : fieldType) (t : nat -> F) (d : nat).
Implicit Types (P Q : {poly F}) (us v : seq F).

Definition window m j : seq F := [seq t i | i <- iota j m].

Definition progressive_points P : seq F :=
  mkseq (fun j => blossom d P (window d j)) d.+1.

Definition deboor_step k v u : seq F :=
  mkseq (fun l => let s := fraction (t (k + l)) (t (d + l)) u in
                  (1 - s) * v`_l + s * v`_l.+1) (size v).-1.

Fixpoint deboor_levels k v us : seq F :=
  if us is u :: us' then deboor_levels k.+1 (deboor_step k v u) us' else v.

Definition deboor v us : F := head 0 (deboor_levels 0 v us).

Definition progressive : Prop :=
  forall j l, (l <= j < d)%N -> t j != t (d + l).

Lemma windowS m j : window m.+1 j = t j :: window m j.+1.
Proof. by []. Qed.

Lemma windowSr m j : window m.+1 j = rcons (window m j) (t (j + m)).
Proof. by rewrite /window -addn1 iotaD map_cat cats1. Qed.

(** Every node is the blossom value that its label says. *)

Theorem deboor_nodes P us vs m : progressive -> (size us + size vs + m)%N = d ->
  deboor_levels (size us)
    (mkseq (fun l => blossom d P (us ++ window (size vs + m) (size us + l)))
       (size vs + m).+1) vs =
  mkseq (fun l => blossom d P (us ++ vs ++ window m (size us + size vs + l))) m.+1.
Proof.
move=> knots; elim: vs us => [|u vs IHvs] us size_d.
  by apply: eq_map => l /=; rewrite addn0.
rewrite [LHS]/= addSn.
set level_points := mkseq _ _.
have -> : deboor_step (size us) level_points u =
    mkseq (fun l => blossom d P
      (rcons us u ++ window (size vs + m) (size (rcons us u) + l))) (size vs + m).+1.
  rewrite /deboor_step size_mkseq; apply: (@eq_from_nth _ 0).
    by rewrite !size_mkseq.
  move=> l; rewrite size_mkseq => lt_l; rewrite !nth_mkseq ?ltnS ?(ltnW lt_l) //.
  have len : (size us + l + (size vs + m).+1 = d + l)%N.
    rewrite -size_d /= !addnS !addSn -!addnA; congr (_ + _).+1.
    by rewrite addnC addnA.
  have end_knot : t (size us + l) != t (d + l).
    apply: knots; rewrite leq_addl /= -size_d /= addnS addSn ltnS -addnA.
    by rewrite leq_add2l -ltnS.
  rewrite windowS windowSr addnS addSnnS len -cats1 size_rcons addSn cat_rcons.
  rewrite (blossom_between d P us u _ end_knot); congr (_ * _ + _ * _).
  by apply: blossom_perm; rewrite perm_cat2l perm_catC.
rewrite -[(size us).+1](size_rcons us u) IHvs; last first.
  by rewrite size_rcons -size_d /= addSnnS.
by apply: eq_map => l; rewrite cat_rcons size_rcons addSnnS.
Qed.

Theorem deboor_blossom P us : progressive -> size us = d ->
  deboor (progressive_points P) us = blossom d P us.
Proof.
move=> knots size_us; have := @deboor_nodes P [::] us 0 knots.
rewrite !addn0 size_us => /(_ erefl) nodes.
by rewrite /deboor /progressive_points nodes /= cats0.
Qed.

(** The condition on the knots is necessary and sufficient for the points to
    determine the polynomial. *)

Lemma blossom_injective P Q : d`!%:R != 0 :> F ->
  (size P <= d.+1)%N -> (size Q <= d.+1)%N ->
  (forall us, size us = d -> blossom d P us = blossom d Q us) -> P = Q.
Proof.
move=> d_unit P_deg Q_deg same; apply/polyP => j.
case: (leqP j d) => [le_j | lt_j]; last first.
  by rewrite !nth_default // (leq_trans _ lt_j).
rewrite !(bernstein_to_monomial d_unit) //; congr (_ * _).
apply: eq_bigr => i _; congr (_ * _); apply: same.
by rewrite size_cat !size_nseq subnK // (leq_trans (leq_subr _ _)).
Qed.

Theorem progressive_determines : d`!%:R != 0 :> F ->
  progressive <->
  (forall P Q : {poly F}, (size P <= d.+1)%N -> (size Q <= d.+1)%N ->
     progressive_points P = progressive_points Q -> P = Q).
Proof.
move=> d_unit; split=> [knots P Q P_deg Q_deg same | determined j l].
  apply: blossom_injective => // us size_us.
  by rewrite -!(deboor_blossom _ knots) // same.
case/andP=> le_lj lt_jd; apply/eqP => eq_knots.
pose P : {poly F} := ('X - (t j)%:P) ^+ d.
have P0 : P = 0.
  apply: determined; rewrite ?size_exp_XsubC ?size_poly0 //.
  apply: (@eq_from_nth _ 0) => [|k]; rewrite !size_mkseq // => lt_k.
  rewrite !nth_mkseq // blossom_power ?size_map ?size_iota //.
  rewrite [RHS]/blossom /hblossom /functional [RHS]big1; last first.
    by move=> i _; rewrite coef0 !mul0r.
  apply/eqP; rewrite prodf_seq_eq0; apply/hasP; exists (t j); last first.
    by rewrite /= subrr.
  case: (leqP k j) => [le_kj | lt_jk]; last rewrite eq_knots.
    apply: map_f; rewrite mem_iota le_kj /=.
    by rewrite (leq_trans lt_jd) // leq_addl.
  apply: map_f; rewrite mem_iota (leq_trans _ (leq_addr _ _)) //= addnC ltn_add2r.
  exact: leq_ltn_trans lt_jk.
by have := size_exp_XsubC d (t j); rewrite -/P P0 size_poly0.
Qed.

(** Any d + 1 points are the points of one polynomial. *)

Theorem progressive_exists v : d`!%:R != 0 :> F -> progressive ->
  size v = d.+1 ->
  exists2 P : {poly F}, (size P <= d.+1)%N & progressive_points P = v.
Proof.
move=> d_unit knots size_v.
pose M := \matrix_(k < d.+1, j < d.+1) blossom d 'X^k (window d j) : 'M[F]_d.+1.
have points_row (r : 'rV_d.+1) (j : 'I_d.+1) :
    (r *m M) 0 j = blossom d (rVpoly r) (window d j).
  rewrite mxE /blossom /hblossom /functional; apply: eq_bigr => k _.
  rewrite coef_rVpoly_ord mxE /blossom /hblossom /functional (bigD1 k) //=.
  rewrite coefXn eqxx mul1r big1 ?addr0 ?mulrA // => i ne_ik.
  by rewrite coefXn (negPf (ne_ik : (i != k :> nat)%N)) !mul0r.
have M_unit : M \in unitmx.
  rewrite -row_free_unit; apply: inj_row_free => r rM0.
  apply: (can_inj rVpolyK); rewrite linear0.
  apply: (progressive_determines d_unit).1 => //; rewrite ?size_poly0 //.
    exact: size_poly.
  apply: (@eq_from_nth _ 0) => [|j]; rewrite !size_mkseq // => lt_j.
  rewrite !nth_mkseq // -(points_row r (Ordinal lt_j)) rM0 mxE.
  rewrite /blossom /hblossom /functional big1 // => k _.
  by rewrite coef0 !mul0r.
exists (rVpoly ((\row_j v`_j) *m invmx M)); first exact: size_poly.
apply: (@eq_from_nth _ 0) => [|j]; rewrite size_mkseq // => lt_j.
by rewrite nth_mkseq // -(points_row _ (Ordinal lt_j)) mulmxKV // mxE.
Qed.

End Progressive.

(** The printed figure: the right end of the interval taken as t_(d+k+l). *)

Definition printed_step (F : fieldType) (t : nat -> F) d k (v : seq F) u :=
  mkseq (fun l => let s := fraction (t (k + l)%N) (t (d + k + l)%N) u in
                  (1 - s) * v`_l + s * v`_l.+1) (size v).-1.

Fixpoint printed_levels (F : fieldType) (t : nat -> F) d k v us :=
  if us is u :: us' then
    printed_levels t d k.+1 (printed_step t d k v u) us'
  else v.

Theorem misprint_derose_fig10 :
  ~ (forall (t : nat -> rat) d (P : {poly rat}) us, progressive t d ->
       size us = d ->
       head 0 (printed_levels t d 0 (progressive_points t d P) us) =
         blossom d P us).
Proof.
pose t i : rat := i%:R; pose half : rat := 2%:R^-1.
move=> /(_ t 2%N 'X^2 [:: half; half]).
have knots : progressive t 2%N.
  move=> j l /andP[_ lt_j]; rewrite Num.Theory.eqr_nat neq_ltn.
  by rewrite (leq_trans lt_j) // leq_addr.
have -> : progressive_points t 2%N 'X^2 = [:: 0; 2%:R; 6%:R].
  rewrite /progressive_points /mkseq /window /=.
  by rewrite !(blossom_top [:: _; _]) !big_cons !big_nil; apply/eqP; vm_compute.
move=> /(_ knots erefl)/eqP; rewrite (blossom_top [:: half; half]) !big_cons.
by rewrite big_nil; vm_compute.
Qed.
