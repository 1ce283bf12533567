(******************************************************************************)
(* Blossoms of maps on affine spaces of any dimension.                        *)
(*                                                                            *)
(*   V                     == a vector space over F, read as an affine space  *)
(*   affine l              == l : V -> F keeps combinations (1-a) x + a y     *)
(*   product_map L x       == the product of the n affine functions L i at x  *)
(*   product_blossom L us  == 1/n! times the sum over all permutations s of   *)
(*                            the products of the L (s i) (u_i)               *)
(*                                                                            *)
(* Every polynomial of total degree at most n in any number of variables is a *)
(* sum of products of n affine functions (a monomial is a product of          *)
(* coordinates and constants 1), and blossoms add up; so the blossom of a     *)
(* product is all that is needed for existence. Uniqueness on spaces of any   *)
(* dimension is multiaffine_unique of uniqueness.v, and the inverse formula   *)
(* multiaffine_polarization of polarization.v. Polynomials as such, with      *)
(* coefficients and exponents, follow in multivariate.v.                      *)
(*                                                                            *)
(* Statements: derose-thm3.                                                   *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_fingroup all_algebra.
From Blossom Require Import notions existence.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section AffineSpace.
Variables (F : fieldType) (V : lmodType F) (n : nat).

Definition affine (l : V -> F) : Prop :=
  forall x y a, l ((1 - a) *: x + a *: y) = (1 - a) * l x + a * l y.

Definition product_map (L : 'I_n -> V -> F) (x : V) : F := \prod_i L i x.

Definition product_blossom (L : 'I_n -> V -> F) (us : seq V) : F :=
  (\sum_(s : 'S_n) \prod_(i < n) L (s i) (nth 0 us i)) / n`!%:R.

(** Existence, for a product of n affine functions. *)

Theorem product_blossom_exists L : n`!%:R != 0 :> F -> (forall i, affine (L i)) ->
  [/\ symmetric n (product_blossom L),
      multiaffine n (product_blossom L : seq V -> F^o)
    & diagonal n (product_blossom L) (product_map L)].
Proof.
move=> n_unit aff; split=> [us vs size_us eq_us | us vs x y a size_us | x].
- congr (_ / _).
  have size_vs : size vs == n by rewrite -(perm_size eq_us) size_us.
  have size_us' : size us == n by apply/eqP.
  have /tuple_permP[p us_p] : perm_eq (Tuple size_us') (Tuple size_vs) by [].
  rewrite (reindex_inj (mulgI p)) /=; apply: eq_bigr => s _.
  rewrite [RHS](reindex_inj (@perm_inj _ p)) /=; apply: eq_bigr => i _.
  rewrite permM; congr (L _ _); move: us_p => /= ->.
  by rewrite (nth_map i) ?size_enum_ord // nth_ord_enum (tnth_nth 0).
- have lt_k : (size us < n)%N by rewrite -size_us ltnS leq_addr.
  pose k := Ordinal lt_k.
  have split_off z (s : 'S_n) : \prod_(i < n) L (s i) (nth 0 (us ++ z :: vs) i) =
      L (s k) z * \prod_(i < n | i != k) L (s i) (nth 0 (us ++ 0 :: vs) i).
    rewrite (bigD1 k) //= nth_cat ltnn subnn; congr (_ * _).
    apply: eq_bigr => i ne_ik; congr (L _ _); rewrite !nth_cat.
    case: ltnP => // le_i; have : (0 < i - size us)%N.
      by rewrite subn_gt0 ltn_neqAle le_i andbT eq_sym.
    by case: (i - size us)%N.
  have sums z : product_blossom L (us ++ z :: vs) = (\sum_(s : 'S_n)
      L (s k) z * \prod_(i < n | i != k) L (s i) (nth 0 (us ++ 0 :: vs) i))
      / n`!%:R.
    by congr (_ / _); apply: eq_bigr => s _; apply: split_off.
  rewrite !sums; under eq_bigr do rewrite aff mulrDl -!mulrA.
  by rewrite big_split /= -!mulr_sumr mulrDl -!mulrA.
rewrite /product_blossom (eq_bigr (fun=> product_map L x)) => [|s _].
  rewrite sumr_const (_ : #|_| = n`!); last by rewrite -card_Sn; apply: eq_card.
  by rewrite -[X in X / _]mulr_natr mulfK.
rewrite /product_map [RHS](reindex_inj (@perm_inj _ s)) /=.
by apply: eq_bigr => i _; rewrite nth_nseq ltn_ord.
Qed.

(** Blossoms of maps on V add up: with the product above, every polynomial of
    degree at most n on V has a blossom. *)

Theorem blossom_sum (f g : seq V -> F) (p q : V -> F) (a b : F) :
  symmetric n f -> multiaffine n (f : seq V -> F^o) -> diagonal n f p ->
  symmetric n g -> multiaffine n (g : seq V -> F^o) -> diagonal n g q ->
  let h us := a * f us + b * g us in
  [/\ symmetric n h, multiaffine n (h : seq V -> F^o)
    & diagonal n h (fun x => a * p x + b * q x)].
Proof.
move=> sym_f aff_f diag_f sym_g aff_g diag_g h.
split=> [us vs size_us eq_us | us vs x y e size_us | x]; rewrite /h.
- by rewrite (sym_f us vs) // (sym_g us vs).
- rewrite aff_f // aff_g //.
  have regroup (k l r s u v : F) : a * (k * r + l * s) + b * (k * u + l * v) =
      k * (a * r + b * u) + l * (a * s + b * v).
    by rewrite !mulrDr addrACA !(mulrCA a) !(mulrCA b).
  exact: regroup.
- by rewrite diag_f diag_g.
Qed.

End AffineSpace.
