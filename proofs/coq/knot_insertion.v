(******************************************************************************)
(* Knot insertion: Boehm's algorithm, and refinement by repetition.           *)
(*                                                                            *)
(*   t, window t d j       == the knots, and t_j, ..., t_(j+d-1)              *)
(*   insert t J x          == the knots with x inserted after t_J             *)
(*   boehm t d J x c       == the new control points: c_j up to j = J - d,    *)
(*                            c_(j-1) from j = J + 1 on, and between them     *)
(*                            c_(j-1) and c_j joined with x between the knots *)
(*                            t_j and t_(j+d)                                 *)
(*   controls t d P c      == c_j = blossom of P at t_(j+1) ... t_(j+d), for  *)
(*                            all j: c are the control points of P over t     *)
(*   refine                == several insertions, one after the other         *)
(*                                                                            *)
(* The control point number j carries the label t_(j+1) ... t_(j+d). A label  *)
(* over the new knots either is an old one or contains x; in the second case  *)
(* it differs from two old labels in one knot each, t_j and t_(j+d), and the  *)
(* blossom is affine. After any sequence of insertions the control points are *)
(* the blossom values at consecutive knots of the refined sequence, and these *)
(* depend on the refined knots alone: that is the Oslo algorithm, and the     *)
(* order of insertion does not matter.                                        *)
(*                                                                            *)
(* Statements: derose-boehm-new (corrected), derose-boehm-old (corrected),    *)
(* derose-boehm-repeat, derose-oslo (corrected), hart-deboor.                 *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Blossom Require Import notions existence casteljau progressive.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section Insertion.
Variables (F : fieldType) (d : nat).
Implicit Types (t c : nat -> F) (P : {poly F}) (x : F) (J j : nat).

Definition insert t J x i : F :=
  if (i <= J)%N then t i else if i == J.+1 then x else t i.-1.

Definition boehm t J x c j : F :=
  if (j + d <= J)%N then c j
  else if (j <= J)%N then
    let s := fraction (t j) (t (j + d)%N) x in (1 - s) * c j.-1 + s * c j
  else c j.-1.

Lemma window_before t J x m j : (j + m <= J.+1)%N ->
  window (insert t J x) m j = window t m j.
Proof.
move=> le_m; apply/eq_in_map => i; rewrite mem_iota => /andP[_ lt_i].
by rewrite /insert -ltnS (leq_trans lt_i).
Qed.

Lemma window_after t J x m j : (J < j)%N ->
  window (insert t J x) m j.+1 = window t m j.
Proof.
move=> lt_J; rewrite /window -addn1 addnC iotaDl -map_comp; apply/eq_in_map => i.
rewrite mem_iota => /andP[le_i _]; rewrite /insert /= add1n ltnNge.
by rewrite eqSS (gtn_eqF (leq_trans lt_J le_i)) (ltnW (leq_trans lt_J le_i)).
Qed.

Lemma window_at t J x m j : (j <= J.+1 <= j + m)%N ->
  perm_eq (window (insert t J x) m.+1 j) (x :: window t m j).
Proof.
case/andP=> le_j le_J; have := subnKC le_j; set p := (J.+1 - j)%N => j_p.
have le_pm : (p <= m)%N by rewrite leq_subLR.
have new : iota j m.+1 = iota j p ++ J.+1 :: iota J.+2 (m - p).
  by rewrite -[in LHS](subnKC le_pm) -addnS iotaD j_p.
have old : iota j m = iota j p ++ iota J.+1 (m - p).
  by rewrite -[in LHS](subnKC le_pm) iotaD j_p.
rewrite /window new old !map_cat /=.
have -> : insert t J x J.+1 = x by rewrite /insert ltnn eqxx.
rewrite -/(window _ _ _) window_before ?j_p // -!/(window _ _ _).
by rewrite window_after // -cat1s perm_catCA.
Qed.

(** Boehm's insertion, control point by control point. Only the old points that
    enter are assumed to be blossom values, so that this holds for every segment
    of a spline that the new point influences. *)

Theorem boehm_insertion t J x c P j :
  ((j <= J)%N -> c j = blossom d P (window t d j.+1)) ->
  ((J < j + d)%N -> c j.-1 = blossom d P (window t d j)) ->
  ((0 < d)%N -> (j <= J < j + d)%N -> t j != t (j + d)%N) ->
  boehm t J x c j = blossom d P (window (insert t J x) d j.+1).
Proof.
move=> at_j at_j1 knots; rewrite /boehm.
case: (leqP (j + d) J) => [le_J | lt_J].
  rewrite at_j ?window_before // ?addSn ?ltnS //.
  exact: leq_trans (leq_addr _ _) le_J.
case: (leqP j J) => [le_j | lt_j]; last by rewrite at_j1 // window_after.
rewrite at_j // at_j1 //; move: at_j at_j1 knots lt_J => _ _.
case: d => [|m]; first by move=> _; rewrite addn0 ltnNge le_j.
rewrite le_j => + lt_J; rewrite lt_J => /(_ isT isT) ne.
have ok : (j.+1 <= J.+1 <= j.+1 + m)%N.
  by rewrite !ltnS le_j /=; move: lt_J; rewrite addnS.
rewrite (blossom_perm _ _ (window_at t x ok)).
rewrite -[x :: _]cat0s (blossom_between _ _ _ _ _ ne) /= -[window t m.+1 j]/(_ :: _).
congr (_ * _ + _ * _); apply: blossom_perm.
by rewrite windowSr addSnnS -cats1 perm_catC.
Qed.

(** Refinement by any number of insertions. *)

Definition controls t P c := forall j, c j = blossom d P (window t d j.+1).

Fixpoint refined_knots t (insertions : seq (nat * F)) :=
  if insertions is (J, x) :: rest then refined_knots (insert t J x) rest else t.

Fixpoint refined_points t c (insertions : seq (nat * F)) :=
  if insertions is (J, x) :: rest then
    refined_points (insert t J x) (boehm t J x c) rest
  else c.

Fixpoint admissible t (insertions : seq (nat * F)) : Prop :=
  if insertions is (J, x) :: rest then
    [/\ (d <= J)%N, forall j, (j <= J < j + d)%N -> t j != t (j + d)%N
      & admissible (insert t J x) rest]
  else True.

Theorem repeated_insertion t c P insertions : admissible t insertions ->
  controls t P c ->
  controls (refined_knots t insertions) P (refined_points t c insertions).
Proof.
elim: insertions t c => [|[J x] rest IHrest] t c //= [le_d knots ok] c_P.
apply: IHrest => // j; apply: boehm_insertion => [_|lt_J|_]; first exact: c_P.
  case: j lt_J => [|j _]; last exact: c_P.
  by rewrite add0n ltnNge le_d.
exact: knots.
Qed.

Corollary insertion_order t c P first second :
  admissible t first -> admissible t second -> controls t P c ->
  refined_knots t first =1 refined_knots t second ->
  refined_points t c first =1 refined_points t c second.
Proof.
move=> ok1 ok2 c_P same j; rewrite !(repeated_insertion _ c_P) //.
congr (blossom _ _ _); exact: eq_map.
Qed.

End Insertion.
