(******************************************************************************)
(* A blossom is determined by the polynomial.                                 *)
(*                                                                            *)
(* Notions: notions.v, polarization.v. By the polarization formulae a         *)
(* symmetric map that is affine (additive) in each argument is a combination  *)
(* of its values on the diagonal, so two of them with the same diagonal are   *)
(* equal. This holds on vector spaces of any dimension. The theorems quantify *)
(* over all functions with the stated properties: whatever algorithm yields a *)
(* symmetric multiaffine function with P on the diagonal yields the blossom.  *)
(*                                                                            *)
(* Statements: derose-thm1-unique, goldman-thm5, goldman-hunique (uniqueness),*)
(* blog-unique-form (corrected: for each formal degree).                      *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Blossom Require Import notions existence polarization.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Theorem multiaffine_unique (F : fieldType) (V W : lmodType F) n
    (f g : seq V -> W) :
  n`!%:R != 0 :> F ->
  symmetric n f -> multiaffine n f -> symmetric n g -> multiaffine n g ->
  (forall t, f (nseq n t) = g (nseq n t)) ->
  forall xs, size xs = n -> f xs = g xs.
Proof.
move=> n_unit sym_f aff_f sym_g aff_g same xs.
case: (posnP n) => [n0 | n_gt0] size_xs.
  by move: (same 0); rewrite (size0nil (etrans size_xs n0)) n0.
rewrite (multiaffine_polarization sym_f aff_f (fun t => erefl)) //.
rewrite (multiaffine_polarization sym_g aff_g (fun t => erefl)) //.
congr (_ *: _); apply: eq_bigr => N _; congr (_ *: _).
by apply: eq_bigr => S _; rewrite same.
Qed.

Lemma multilinear_affine (F : ringType) (V W : lmodType F) n (f : seq V -> W) :
  multilinear n f -> multiaffine n f.
Proof. by move=> lin_f us vs x y a; apply: lin_f. Qed.

Theorem multilinear_unique (F : fieldType) (V W : lmodType F) n
    (f g : seq V -> W) :
  n`!%:R != 0 :> F ->
  symmetric n f -> multilinear n f -> symmetric n g -> multilinear n g ->
  (forall t, f (nseq n t) = g (nseq n t)) ->
  forall xs, size xs = n -> f xs = g xs.
Proof.
move=> n_unit sym_f lin_f sym_g lin_g.
by apply: multiaffine_unique => //; apply: multilinear_affine.
Qed.

Theorem blossom_unique (F : fieldType) n (P : {poly F}) (f : seq F -> F) :
  n`!%:R != 0 :> F -> (size P <= n.+1)%N -> is_blossom n P f ->
  forall us, size us = n -> f us = blossom n P us.
Proof.
move=> n_unit P_deg [sym_f aff_f diag_f].
have [sym_b aff_b diag_b] := blossom_exists n_unit P_deg.
apply: (@multiaffine_unique _ [lmodType F of F^o] [lmodType F of F^o]) => //.
by move=> t; rewrite diag_f diag_b.
Qed.

Theorem hblossom_unique (F : fieldType) n (P : {poly F})
    (f : seq (F * F) -> F) :
  n`!%:R != 0 :> F -> is_hblossom n P f ->
  forall ws, size ws = n -> f ws = hblossom n P ws.
Proof.
move=> n_unit [sym_f lin_f diag_f].
have [sym_b lin_b diag_b] := hblossom_exists P n_unit.
apply: (@multilinear_unique _ [lmodType F of F^o * F^o] [lmodType F of F^o]).
- by [].
- exact: sym_f.
- exact: lin_f.
- exact: sym_b.
- exact: lin_b.
- by move=> w; rewrite diag_f diag_b.
Qed.
