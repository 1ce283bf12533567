(******************************************************************************)
(* Subdivision: the two outer edges of de Casteljau's triangle.               *)
(*                                                                            *)
(* Notions: notions.v, casteljau.v. Evaluation at t over [a, b] makes the     *)
(* points with labels a^i b^j t^r. Those on the left edge, a^(n-r) t^r, are   *)
(* by their labels the control points over [a, t], those on the right edge,   *)
(* t^r b^(n-r), the control points over [t, b].                               *)
(*                                                                            *)
(* Statements: derose-subdiv-left, derose-subdiv-right, goldman-subdivision,  *)
(* blog-subcurve.                                                             *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Blossom Require Import notions existence casteljau.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section Subdivision.
Variables (F : fieldType) (n : nat) (P : {poly F}) (a b t : F).
Hypothesis ab : a != b.

Theorem subdivision_left r : (r <= n)%N ->
  head 0 (level a b (control_points n P a b) (nseq r t)) =
    control_point n P a t r.
Proof.
move=> le_rn; rewrite (@casteljau_nodes _ n P a b _ (n - r)) //; last first.
  by rewrite size_nseq subnKC.
by rewrite /= cats0 subn0 /control_point (blossom_perm _ _ (permEl (perm_catC _ _))).
Qed.

Theorem subdivision_right r : (r <= n)%N ->
  last 0 (level a b (control_points n P a b) (nseq r t)) =
    control_point n P t b (n - r).
Proof.
move=> le_rn; rewrite (@casteljau_nodes _ n P a b _ (n - r)) //; last first.
  by rewrite size_nseq subnKC.
rewrite -nth_last size_mkseq nth_mkseq // subnn.
by rewrite /control_point subKn.
Qed.

(** The edges control the same curve, over [a, t] and over [t, b]. *)

Theorem subdivision u :
  n`!%:R != 0 :> F -> (size P <= n.+1)%N -> a != t -> t != b ->
  let points := control_points n P a b in
  let left := mkseq (fun r => head 0 (level a b points (nseq r t))) n.+1 in
  let right := mkseq (fun k => last 0 (level a b points (nseq (n - k) t))) n.+1 in
  P.[u] = bezier a t left u /\ P.[u] = bezier t b right u.
Proof.
move=> n_unit P_deg a_t t_b points left right.
have -> : left = control_points n P a t.
  apply: (@eq_from_nth _ 0); rewrite !size_mkseq // => k lt_k.
  by rewrite !nth_mkseq // subdivision_left.
have -> : right = control_points n P t b.
  apply: (@eq_from_nth _ 0); rewrite !size_mkseq // => k lt_k.
  by rewrite !nth_mkseq // subdivision_right ?leq_subr // subKn.
by split; apply: every_polynomial_is_bezier.
Qed.

End Subdivision.
