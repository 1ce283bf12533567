(******************************************************************************)
(* When two polynomials meet with k continuous derivatives.                   *)
(*                                                                            *)
(* Notions: notions.v. The right-hand side of the first theorem says that the *)
(* blossoms agree as soon as s stands on n - k places, whatever the other k   *)
(* arguments xs are.                                                          *)
(*                                                                            *)
(* Write each other argument x as s + (x - s) delta: a blossom value with k   *)
(* free arguments is a combination of the values with s on n - i places and   *)
(* delta on i, for i <= k, and these are the derivatives at s but for the     *)
(* factor n!/(n-i)!. Conversely delta is the difference of the points 1 and 0.*)
(* The two curve sections lie on opposite sides of s, F over [r,s] and G over *)
(* [s,t]; the condition is one on their polynomials.                          *)
(*                                                                            *)
(* Statements: derose-thm2 (corrected: F over [r,s], G over [s,t]; k <= n),   *)
(* derose-eq5, derose-eq6, derose-eq7, derose-46-c2cond,                      *)
(* derose-46-general-cd1.                                                     *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Blossom Require Import notions existence homogeneous.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section Contact.
Variables (F : fieldType) (n : nat) (P Q : {poly F}) (s : F).
Hypotheses (n_unit : n`!%:R != 0 :> F).
Hypotheses (P_deg : (size P <= n.+1)%N) (Q_deg : (size Q <= n.+1)%N).

Lemma falling_unit i : (i <= n)%N -> (n ^_ i)%:R != 0 :> F.
Proof.
by move=> /ffact_fact n_i; move: n_unit; rewrite -n_i natrM mulf_eq0; case/norP.
Qed.

Theorem contact k : (k <= n)%N ->
  (forall i, (i <= k)%N -> (P^`(i)).[s] = (Q^`(i)).[s]) <->
  (forall xs, size xs = k ->
     blossom n P (xs ++ nseq (n - k) s) = blossom n Q (xs ++ nseq (n - k) s)).
Proof.
move=> le_kn; split=> [same xs size_xs | same i le_ik].
  suff spread i ys : (size ys + i <= k)%N ->
    hblossom n P ([seq point y | y <- ys] ++ nseq i delta
                    ++ nseq (n - (size ys + i)) (point s)) =
    hblossom n Q ([seq point y | y <- ys] ++ nseq i delta
                    ++ nseq (n - (size ys + i)) (point s)).
    have := spread 0%N xs; rewrite addn0 size_xs => /(_ (leqnn k)).
    by rewrite /blossom !map_cat !map_nseq.
  elim: ys i => [|y ys IHys] i /= le_k.
    have le_in := leq_trans le_k le_kn; apply: (mulfI (falling_unit le_in)).
    have swap := permEl (perm_catC (nseq i delta) (nseq (n - i) (point s))).
    rewrite !(hblossom_perm _ _ swap).
    by rewrite -!(derivative_hblossom _ n_unit) // same.
  have -> : point y = (1 * (point s).1 + (y - s) * delta.1,
                       1 * (point s).2 + (y - s) * delta.2).
    by rewrite /= !mul1r mulr0 addr0 mulr1 addrC subrK.
  rewrite -[_ :: _ in LHS]cat0s -[_ :: _ in RHS]cat0s !hblossom_combination /=.
  congr (_ * _ + _ * _).
    have perm : perm_eq (point s :: [seq point z | z <- ys] ++ nseq i delta
        ++ nseq (n - ((size ys).+1 + i)) (point s))
      ([seq point z | z <- ys] ++ nseq i delta
        ++ nseq (n - (size ys + i)) (point s)).
      have -> : (n - (size ys + i) = (n - ((size ys).+1 + i)).+1)%N.
        by rewrite addSn -subSn ?subSS // (leq_trans le_k).
      apply/permP => p; rewrite /= !count_cat /= addnCA; congr (_ + _)%N.
      by rewrite addnCA.
    by rewrite !(hblossom_perm _ _ perm) IHys // ltnW.
  have perm : perm_eq (delta :: [seq point z | z <- ys] ++ nseq i delta
      ++ nseq (n - ((size ys).+1 + i)) (point s))
    ([seq point z | z <- ys] ++ nseq i.+1 delta
      ++ nseq (n - (size ys + i.+1)) (point s)).
    by apply/permP => p; rewrite /= !count_cat /= !count_cat addnCA addSnnS.
  by rewrite !(hblossom_perm _ _ perm) IHys // addnS.
have le_in := leq_trans le_ik le_kn.
rewrite !(derivative_blossom _ n_unit) //; congr (_ * _).
apply: eq_bigr => j _; congr (_ * _).
have -> : nseq (n - i) s = nseq (k - i) s ++ nseq (n - k) s.
  by rewrite -nseqD addnBAC // subnKC.
by rewrite !catA same // !size_cat !size_nseq subnK ?subnKC // -ltnS.
Qed.

(** Equation (7): contact of order one. *)

Corollary contact_first_order : (0 < n)%N ->
  (P.[s] = Q.[s] /\ P^`().[s] = Q^`().[s]) <->
  (forall x, blossom n P (x :: nseq n.-1 s) = blossom n Q (x :: nseq n.-1 s)).
Proof.
move=> n_gt0; rewrite -subn1; have [to_blossom of_blossom] := contact n_gt0.
split=> [[same0 same1] x | same].
  apply: (to_blossom _ [:: x]) => //; case=> [|[|i]] //.
have same_deriv := of_blossom _; split.
  apply: (same_deriv _ 0%N) => // xs; case: xs => [|x [|y xs]] // _.
  exact: same.
apply: (same_deriv _ 1%N) => // xs; case: xs => [|x [|y xs]] // _.
exact: same.
Qed.

End Contact.
