(******************************************************************************)
(* Misprints about splines: where segments meet, and what is a control point. *)
(*                                                                            *)
(* Notions: notions.v. P and Q are two neighbouring cubic segments of a       *)
(* spline over the knots 0, 1, ..., 6: Q has the parameters between 3 and 4,  *)
(* P those between 2 and 3. Their blossoms agree at the three triples of      *)
(* consecutive knots that they share. Each of these triples contains the      *)
(* joint 3; so the example is P = 0, Q = (t - 3)^3, with the blossom          *)
(* (u - 3) (v - 3) (w - 3).                                                   *)
(*                                                                            *)
(* Statements: derose-46-c2-location, derose-46-piecewise-blossom,            *)
(* derose-boehm-old, derose-fig10-comment2.                                   *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Blossom Require Import notions existence conversion lower_degree progressive.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory Num.Theory.
Local Open Scope ring_scope.

Definition shared_knots : seq (seq rat) :=
  [:: [:: 1; 2%:R; 3%:R]; [:: 2%:R; 3%:R; 4%:R]; [:: 3%:R; 4%:R; 5%:R]].

Definition neighbours (P Q : {poly rat}) : Prop :=
  [/\ (size P <= 4)%N, (size Q <= 4)%N
    & forall us, us \in shared_knots -> blossom 3 P us = blossom 3 Q us].

Definition example : {poly rat} := ('X - 3%:R%:P) ^+ 3.

Lemma blossom_zero (F : fieldType) n (us : seq F) : blossom n 0 us = 0.
Proof.
by rewrite /blossom /hblossom /functional big1 // => k _; rewrite coef0 !mul0r.
Qed.

Lemma neighbours_example : neighbours 0 example.
Proof.
split; rewrite ?size_poly0 ?size_exp_XsubC // => us.
by rewrite blossom_zero !inE => /or3P[] /eqP->; rewrite blossom_power //
  !big_cons big_nil subrr ?mul0r ?mulr0.
Qed.

(** derose-46-c2-location: the segments meet at t_(i+2), not at t_i; here t_i,
    t_(i+1), ... = 1, 2, 3, 4, 5. *)

Theorem misprint_derose_c2_location :
  ~ (forall P Q, neighbours P Q -> P.[1] = Q.[1]).
Proof.
move=> /(_ _ _ neighbours_example); rewrite horner0 horner_exp hornerXsubC.
by move/eqP; vm_compute.
Qed.

(** derose-46-piecewise-blossom: P has the knots 0 to 5 and Q the knots 1 to 6.
    At arguments between 1 and 5 the rule takes the value of either blossom,
    and the two can differ: at (2, 4, 4). *)

Theorem misprint_derose_piecewise_blossom :
  ~ (forall P Q u v w, neighbours P Q ->
       all (fun x => 1 <= x <= 5%:R) [:: u; v; w] ->
       ~~ [&& u == v & v == w] ->
       blossom 3 P [:: u; v; w] = blossom 3 Q [:: u; v; w]).
Proof.
move=> /(_ _ _ 2%:R 4%:R 4%:R neighbours_example isT isT)/eqP.
by rewrite blossom_zero blossom_power // !big_cons big_nil; vm_compute.
Qed.

(** derose-boehm-old: the control point after f(t_(i-1), t_i, t_(i+1)) is
    f(t_i, t_(i+1), t_(i+2)). It is f(t_i, t_i, t_(i+1)) for no knots with
    t_i <> t_(i+2), whatever the field. *)

Theorem misprint_derose_boehm_old (F : fieldType) (t0 t1 t2 : F) :
  3%:R != 0 :> F -> t0 != t2 ->
  ~ (forall P : {poly F}, (size P <= 4)%N ->
       blossom 3 P [:: t0; t1; t2] = blossom 3 P [:: t0; t0; t1]).
Proof.
move=> three ne /(_ 'X); rewrite size_polyX !blossom_identity // => /(_ isT).
move/(mulIf (invr_neq0 three)); rewrite !big_cons !big_nil !addr0 => /addrI.
by rewrite addrC => /addIr/eqP; rewrite eq_sym (negPf ne).
Qed.

(** derose-fig10-comment2: after the first level point l carries the knots from
    t_(l+1) on; from t_l on, as printed, its label is wrong in every degree, for
    all knots with t_l <> t_(l+d). *)

Theorem misprint_derose_fig10_comment2 (F : fieldType) (t : nat -> F) d l u :
  d.+1%:R != 0 :> F -> t l != t (l + d)%N ->
  ~ (forall P : {poly F}, (size P <= d.+2)%N ->
       blossom d.+1 P (u :: window t d l.+1) = blossom d.+1 P (u :: window t d l)).
Proof.
move=> d_unit ne /(_ 'X); rewrite size_polyX !blossom_identity // => /(_ isT).
move/(mulIf (invr_neq0 d_unit)); rewrite !big_cons => /addrI.
have : \sum_(x <- window t d.+1 l) x = \sum_(x <- window t d.+1 l) x by [].
rewrite {1}windowS windowSr -cats1 big_cons big_cat big_seq1 /= [_ + t _]addrC.
by move=> sums same; move: sums; rewrite same => /addIr/eqP; rewrite (negPf ne).
Qed.
