(******************************************************************************)
(* Three constructions of the blossom agree.                                  *)
(*                                                                            *)
(* Notions: notions.v, polarization.v, polarization_grouped.v, casteljau.v.   *)
(*   symmetric functions   == blossom n P us: elementary symmetric functions  *)
(*                            of the arguments against P_k / C(n,k)           *)
(*   polarization n P us   == the alternating sum of N^n P(mean S) over the   *)
(*                            non-empty subsets S of us, divided by n!        *)
(*   casteljau a b v us    == de Casteljau with one argument per level, from  *)
(*                            control points v over [a, b]                    *)
(*                                                                            *)
(* Statements: goldman-thm2 with goldman-thm5, fj-cor1, derose-fig6,          *)
(* blog-blossom-recursion, derose-adt-list.                                   *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Blossom Require Import notions existence polarization uniqueness casteljau.
From Blossom Require Import polarization_grouped.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Definition polarization (F : fieldType) n (P : {poly F}) (us : seq F) : F :=
  n`!%:R^-1 * \sum_(1 <= N < n.+1)
    (-1) ^+ (n - N) * N%:R ^+ n *
      \sum_(S <- subsets N us) P.[arithmetic_mean S].

Theorem three_constructions_agree (F : fieldType) n (P : {poly F}) a b us :
  n`!%:R != 0 :> F -> (0 < n)%N -> (size P <= n.+1)%N -> a != b ->
  size us = n ->
  blossom n P us = polarization n P us /\
  blossom n P us = casteljau a b (control_points n P a b) us.
Proof.
move=> n_unit n_gt0 P_deg ab size_us; split.
- exact: blossom_polarization.
- by rewrite casteljau_blossom.
Qed.

(** De Casteljau's algorithm from any points whatever: it is the blossom of the
    curve with these control points, and they are its only control points. *)

Theorem casteljau_is_blossom (F : fieldType) n (P : {poly F}) a b v :
  n`!%:R != 0 :> F -> (size P <= n.+1)%N -> a != b -> size v = n.+1 ->
  (forall t, P.[t] = casteljau a b v (nseq n t)) ->
  (forall us, size us = n -> casteljau a b v us = blossom n P us) /\
  v = control_points n P a b.
Proof.
move=> n_unit P_deg ab size_v P_v.
have agree us : size us = n -> casteljau a b v us = blossom n P us.
  apply: blossom_unique => //; split.
  - by move=> us1 us2 _ eq_us; rewrite /casteljau (level_perm _ _ _ eq_us).
  - move=> us1 us2 x y c size_us; exact: casteljau_affine.
  - by move=> t; rewrite -P_v.
have size_c : size (control_points n P a b) = n.+1 by rewrite size_mkseq.
split=> //; apply: (@eq_from_nth _ 0) => [|k]; rewrite size_v ?size_c // => lt_k.
rewrite nth_mkseq // /control_point -agree; last first.
  by rewrite size_cat !size_nseq subnK.
exact/esym/casteljau_corner.
Qed.
