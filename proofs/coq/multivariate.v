(******************************************************************************)
(* Blossoms of polynomials in several variables: existence and uniqueness.    *)
(*                                                                            *)
(*   {mpoly F[m]}          == polynomials in m variables over F; P@_e is the  *)
(*                            coefficient of the monomial with exponents e,   *)
(*                            mdeg e is the sum of e, and msize P <= n.+1     *)
(*                            says total degree <= n                          *)
(*   'rV[F]_m              == the points of F^m; x ord0 i is coordinate i     *)
(*   value P x             == P at the point x                                *)
(*   letters e             == the list with e_0 entries 0, e_1 entries 1, ... *)
(*   monomial_factors n e  == n affine functions with the monomial e as their *)
(*                            product: coordinates, then constants 1          *)
(*   mblossom n P us       == the sum over the monomials e of P of P_e times  *)
(*                            the blossom of the product of these functions   *)
(*   is_mblossom n P f     == f is symmetric and affine in each of n points,  *)
(*                            with P on the diagonal                          *)
(*                                                                            *)
(* A monomial of degree at most n is a product of n affine functions: the     *)
(* coordinates that occur, as often as they occur, and constants 1. Such a    *)
(* product has a blossom (several_variables.v), and blossoms add up.          *)
(* Uniqueness holds on spaces of any dimension (uniqueness.v).                *)
(*                                                                            *)
(* Statements: derose-thm3, fj-eq21.                                          *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_fingroup all_algebra.
From SsrMultinomials Require Import mpoly.
From Blossom Require Import notions existence polarization uniqueness.
From Blossom Require Import several_variables.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

(** Exponents as lists of letters. *)

Section Letters.
Variable m : nat.
Implicit Types (e : 'X_{1..m}) (i : 'I_m).

Definition letters e : seq 'I_m := flatten [seq nseq (e i) i | i <- enum 'I_m].

Lemma count_letters e (a : pred 'I_m) : count a (letters e) = (\sum_i e i * a i)%N.
Proof.
rewrite count_flatten sumnE 2!big_map big_enum; apply: eq_bigr => i _.
by rewrite /= count_nseq mulnC.
Qed.

Lemma size_letters e : size (letters e) = mdeg e.
Proof.
rewrite -count_predT count_letters mdegE.
by apply: eq_bigr => i _; rewrite muln1.
Qed.

Lemma letters_add e i : perm_eq (letters (e + U_(i))%MM) (i :: letters e).
Proof.
apply/seq.permP => a; rewrite /= !count_letters.
under eq_bigr do rewrite mnmDE mnm1E mulnDl.
rewrite big_split addnC; congr (_ + _)%N.
rewrite (bigD1 i) //= eqxx mul1n big1 ?addn0 // => j.
by rewrite eq_sym => /negPf->.
Qed.

Lemma big_letters (R : Type) (one : R) (op : Monoid.com_law one) e (g : 'I_m -> R) :
  \big[op/one]_(i <- letters e) g i =
    \big[op/one]_(i < m) \big[op/one]_(g <- nseq (e i) (g i)) g.
Proof.
rewrite big_flatten big_map big_enum; apply: eq_bigr => i _.
by elim: (e i) => [|k IHk]; rewrite /= ?big_nil // !big_cons IHk.
Qed.

End Letters.

Section Multivariate.
Variables (F : fieldType) (m n : nat).
Hypothesis n_unit : n`!%:R != 0 :> F.
Implicit Types (P : {mpoly F[m]}) (x : 'rV[F]_m) (us : seq 'rV[F]_m).

Definition value P x : F := P.@[fun i => x ord0 i].

Definition monomial_factors (e : 'X_{1..m}) (j : 'I_n) : 'rV[F]_m -> F :=
  nth (fun=> 1) [seq (fun x => x ord0 i) | i <- letters e] j.

Definition mblossom P us : F :=
  \sum_(e <- msupp P) P@_e * product_blossom (monomial_factors e) us.

Definition is_mblossom P (f : seq 'rV[F]_m -> F) : Prop :=
  [/\ symmetric n f, multiaffine n (f : seq 'rV[F]_m -> F^o)
    & diagonal n f (value P)].

Lemma monomial_factors_affine e j : affine (monomial_factors e j).
Proof.
rewrite /monomial_factors; elim: (letters e) (j : nat) => [|i l IHl] [|k] //= x y a.
- by rewrite !mulr1 subrK.
- by rewrite !mulr1 subrK.
- by rewrite !mxE.
Qed.

Lemma product_of_factors e x : (mdeg e <= n)%N ->
  product_map (monomial_factors e) x = \prod_i x ord0 i ^+ e i.
Proof.
move=> e_deg; rewrite /product_map /monomial_factors.
set s := map _ _; have size_s : (size s <= n)%N by rewrite size_map size_letters.
transitivity (\prod_(l <- s) l x).
  rewrite (big_nth (fun=> 1)) big_mkord (big_ord_widen _ (fun j => nth _ s j x) size_s).
  rewrite [RHS]big_mkcond /=.
  apply: eq_bigr => j _; case: ltnP => // le_j.
  by rewrite nth_default.
rewrite big_map big_letters; apply: eq_bigr => i _.
by rewrite big_nseq -Monoid.iteropE.
Qed.

(** Existence and uniqueness: Theorem 3 of DeRose, in any number of variables. *)

Theorem mblossom_exists P : (msize P <= n.+1)%N -> is_mblossom P (mblossom P).
Proof.
move=> P_deg.
have product e := product_blossom_exists n_unit (monomial_factors_affine e).
split=> [us vs size_us eq_us | us vs x y a size_us | x]; rewrite /mblossom.
- apply: eq_bigr => e _; congr (_ * _).
  by have [sym _ _] := product e; apply: sym.
- rewrite /GRing.scale /= !mulr_sumr -big_split; apply: eq_bigr => e _ /=.
  have [_ aff _] := product e; rewrite aff // /GRing.scale /=.
  by rewrite mulrDr mulrCA [X in _ + X]mulrCA.
rewrite /value mevalE; apply: eq_big_seq => e e_in; congr (_ * _).
have [_ _ diag] := product e; rewrite diag product_of_factors //.
by rewrite -ltnS (leq_trans (msize_mdeg_lt e_in)).
Qed.

Theorem mblossom_unique P f : (msize P <= n.+1)%N -> is_mblossom P f ->
  forall us, size us = n -> f us = mblossom P us.
Proof.
move=> P_deg [sym_f aff_f diag_f]; have [sym aff diag] := mblossom_exists P_deg.
apply: (@multiaffine_unique _ _ [lmodType F of F^o]) => // x.
by rewrite diag_f diag.
Qed.

(** Formula (21) of Fernandez-Jambrina: the blossom from values of P. *)

Theorem mblossom_polarization P us : (msize P <= n.+1)%N -> (0 < n)%N ->
  size us = n ->
  mblossom P us =
    n`!%:R^-1 * \sum_(1 <= N < n.+1)
      (-1) ^+ (n - N) * N%:R ^+ n * \sum_(S <- subsets N us) value P (mean S).
Proof.
move=> P_deg n_gt0 size_us; have [sym aff diag] := mblossom_exists P_deg.
exact: (@multiaffine_polarization _ _ [lmodType F of F^o] _ _ _ sym aff diag).
Qed.

End Multivariate.
