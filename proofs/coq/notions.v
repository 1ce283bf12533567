(******************************************************************************)
(* What a blossom is: the three properties, subsets, and the construction.    *)
(*                                                                            *)
(*   F                     == the field of numbers (rationals, reals, ...)    *)
(*   V, W                  == vector spaces over F; F^o is F itself, seen as  *)
(*                            a vector space of dimension one                 *)
(*   us : seq V            == a list of arguments; us ++ x :: vs is the list  *)
(*                            in which x stands at some place                 *)
(*   nseq k x              == k copies of x (the literature writes x^k)       *)
(*   symmetric n f         == f does not see the order of its n arguments     *)
(*   multiaffine n f       == f is affine in each of its n arguments          *)
(*   multilinear n f       == f is linear in each of its n arguments          *)
(*   multiadditive n f     == f is additive in each of its n arguments        *)
(*   diagonal n f q        == q is f with n equal arguments                   *)
(*   is_blossom n P f      == f is symmetric and multiaffine, with P(t) on    *)
(*                            the diagonal: the three axioms of a blossom     *)
(*   homogenized n P t w   == sum over k of P_k t^k w^(n-k)                   *)
(*   is_hblossom n P f     == the axioms of the homogeneous blossom           *)
(*   subsets k xs          == the sublists of xs with k entries, one for each *)
(*                            k-element subset of the places                  *)
(*   omit i xs             == xs without its entry number i (from 0)          *)
(*   P : {poly F}, P`_k, P.[t] == a polynomial, its coefficient of X^k, its   *)
(*                            value at t; size P <= n.+1 says degree <= n     *)
(*   functional n P Q      == sum over k of P_k Q_k / C(n,k)                  *)
(*   factors ws            == product of v + u X over the pairs (u,v) of ws   *)
(*   hblossom n P ws       == the homogeneous blossom of P, formal degree n,  *)
(*                            at n pairs (u,v): u the parameter, v the mass   *)
(*   point u, delta        == the pairs (u,1) and (1,0)                       *)
(*   blossom n P us        == the blossom of P at n numbers                   *)
(*                                                                            *)
(* A blossom takes numbers (masses 1) or, homogenised, pairs: a vector has    *)
(* mass 0. It is built as a linear functional on polynomials that sends X^k   *)
(* to P_k / C(n,k), applied to the product of the factors v + u X of its      *)
(* arguments; then most identities are identities of polynomials. A curve     *)
(* in a space of dimension d is d polynomials, and all that is said here of   *)
(* values holds coordinate by coordinate.                                     *)
(*                                                                            *)
(* Sources: DeRose, Goldman, Lounsbery (1991), sections 3 and 4; Goldman,     *)
(* Lecture 26, sections 2 and 4.                                              *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Definition symmetric (V : eqType) (W : Type) n (f : seq V -> W) :=
  forall us vs : seq V, size us = n -> perm_eq us vs -> f us = f vs.

Definition diagonal (V W : Type) n (f : seq V -> W) (q : V -> W) :=
  forall t : V, f (nseq n t) = q t.

Section Affinity.
Variables (F : ringType) (V W : lmodType F) (n : nat) (f : seq V -> W).

Definition multiaffine := forall (us vs : seq V) (x y : V) (a : F),
  (size us + size vs).+1 = n ->
  f (us ++ ((1 - a) *: x + a *: y) :: vs) =
    (1 - a) *: f (us ++ x :: vs) + a *: f (us ++ y :: vs).

Definition multilinear := forall (us vs : seq V) (x y : V) (a b : F),
  (size us + size vs).+1 = n ->
  f (us ++ (a *: x + b *: y) :: vs) =
    a *: f (us ++ x :: vs) + b *: f (us ++ y :: vs).

End Affinity.

Definition multiadditive (V W : zmodType) n (f : seq V -> W) :=
  forall (us vs : seq V) (x y : V), (size us + size vs).+1 = n ->
  f (us ++ (x + y) :: vs) = f (us ++ x :: vs) + f (us ++ y :: vs).

Section Subsets.
Variable T : Type.

Fixpoint subsets (k : nat) (xs : seq T) : seq (seq T) :=
  if xs is x :: xs' then
    (if k is k'.+1 then [seq x :: S | S <- subsets k' xs'] else [::])
      ++ subsets k xs'
  else if k is 0 then [:: [::]] else [::].

Definition omit (i : nat) (xs : seq T) : seq T := take i xs ++ drop i.+1 xs.

End Subsets.

Section Construction.
Variable F : fieldType.
Implicit Types (P Q : {poly F}) (us : seq F) (ws : seq (F * F)).

Definition functional n P Q : F :=
  \sum_(k < n.+1) P`_k * Q`_k / 'C(n, k)%:R.

Definition factors ws : {poly F} := \prod_(w <- ws) (w.2%:P + w.1 *: 'X).

Definition hblossom n P ws : F := functional n P (factors ws).

Definition point (u : F) : F * F := (u, 1).
Definition delta : F * F := (1, 0).

Definition blossom n P us : F := hblossom n P [seq point u | u <- us].

Definition is_blossom n P (f : seq F -> F) : Prop :=
  [/\ symmetric n f, multiaffine n (f : seq F^o -> F^o)
    & diagonal n f (fun t => P.[t])].

Definition homogenized n P (t w : F) : F :=
  \sum_(k < n.+1) P`_k * t ^+ k * w ^+ (n - k).

Definition is_hblossom n P (f : seq (F * F) -> F) : Prop :=
  [/\ symmetric n f, multilinear n (f : seq (F^o * F^o) -> F^o)
    & diagonal n f (fun w => homogenized n P w.1 w.2)].

End Construction.

Arguments delta {F}.
