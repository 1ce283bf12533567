(******************************************************************************)
(* Conversion between the monomial, the Taylor and the Bernstein form; change *)
(* of parameter.                                                              *)
(*                                                                            *)
(* Notions: notions.v, casteljau.v.                                           *)
(*   (P^`N(j)).[a]         == P^(j)(a) / j!, the coefficient of (t - a)^j     *)
(*   control_point n P a b k == the k-th Bernstein coefficient over [a, b]    *)
(*   P \Po Q               == P after Q                                       *)
(*                                                                            *)
(* The Taylor coefficients, divided by C(n,j), are the blossom at n - j       *)
(* copies of a and j copies of delta; since b = a + (b - a) delta and         *)
(* delta = (b - a)^(-1) (b - a as points), each kind of coefficient is a      *)
(* binomial expansion of the other. With a = 0 the Taylor coefficients are    *)
(* the monomial ones.                                                         *)
(*                                                                            *)
(* Statements: goldman-eq44, goldman-fig11a, goldman-fig11b, goldman-ex-10a,  *)
(* goldman-ex-10b, goldman-ex-10c, fj-eq10, goldman-ex-2.                     *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Blossom Require Import notions existence uniqueness casteljau homogeneous.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section Conversion.
Variables (F : fieldType) (n : nat) (P : {poly F}).
Hypotheses (n_unit : n`!%:R != 0 :> F) (P_deg : (size P <= n.+1)%N).

Theorem taylor_hblossom a j : (j <= n)%N ->
  (P^`N(j)).[a] =
    'C(n, j)%:R * hblossom n P (nseq (n - j) (point a) ++ nseq j delta).
Proof.
move=> le_j; apply: (mulfI (factorial_unit le_j n_unit)).
rewrite mulrA -natrM mulnC bin_ffact -(derivative_hblossom _ n_unit) //.
by rewrite nderivn_def hornerMn mulr_natl.
Qed.

Theorem taylor_to_bernstein a b k : (k <= n)%N ->
  control_point n P a b k =
    \sum_(j < k.+1) 'C(k, j)%:R * (b - a) ^+ j * ((P^`N(j)).[a] / 'C(n, j)%:R).
Proof.
move=> le_k; rewrite /control_point /blossom map_cat !map_nseq.
have -> : point b = (a + (b - a), 1) by rewrite addrC subrK.
rewrite binomial_expansion; apply: eq_bigr => j _; congr (_ * _).
have le_jk : (j <= k)%N by rewrite -ltnS.
have le_jn := leq_trans le_jk le_k.
rewrite taylor_hblossom // mulrC mulKf ?binomial_unit // catA -nseqD.
by rewrite addnBA // subnK.
Qed.

Theorem bernstein_to_taylor a b j : a != b -> (j <= n)%N ->
  (P^`N(j)).[a] =
    'C(n, j)%:R / (b - a) ^+ j *
      \sum_(i < j.+1) (-1) ^+ i * 'C(j, i)%:R * control_point n P a b (j - i).
Proof.
move=> ab le_j; have ba : b - a != 0 by rewrite subr_eq0 eq_sym.
rewrite taylor_hblossom // -mulrA; congr (_ * _).
apply: (mulfI (expf_neq0 j ba)); rewrite mulVKf ?expf_neq0 //.
rewrite hblossom_difference; apply: eq_bigr => i _; congr (_ * _).
have le_ij : (i <= j)%N by rewrite -ltnS.
rewrite /control_point /blossom map_cat !map_nseq; apply: hblossom_perm.
rewrite catA perm_sym; apply/permP => p.
rewrite !count_cat !count_nseq -addnA [RHS]addnC -addnA -mulnDr.
rewrite addnC; congr (_ + _ * _)%N.
by rewrite subnBA // addnC addnBA // addnC.
Qed.

(** Over [0, 1] the coefficients of P themselves. *)

Corollary monomial_to_bernstein k : (k <= n)%N ->
  control_point n P 0 1 k = \sum_(j < k.+1) 'C(k, j)%:R * (P`_j / 'C(n, j)%:R).
Proof.
move=> le_k; rewrite taylor_to_bernstein //; apply: eq_bigr => j _.
rewrite subr0 expr1n mulr1 horner_coef0 coef_nderivn addn0 binn.
by [].
Qed.

Corollary bernstein_to_monomial j : (j <= n)%N ->
  P`_j = 'C(n, j)%:R *
    \sum_(i < j.+1) (-1) ^+ i * 'C(j, i)%:R * control_point n P 0 1 (j - i).
Proof.
move=> le_j; have := @bernstein_to_taylor 0 1 j; rewrite eq_sym oner_eq0 le_j.
move=> /(_ isT isT); rewrite subr0 expr1n divr1 => <-.
by rewrite horner_coef0 coef_nderivn addn0 binn.
Qed.

(** A change of parameter t -> c t + d moves to the arguments. *)

Theorem reparametrisation (c d : F) us : size us = n ->
  blossom n (P \Po (c *: 'X + d%:P)) us = blossom n P [seq c * u + d | u <- us].
Proof.
move=> size_us; apply/esym.
apply: (blossom_unique (f := fun us => blossom n P [seq c * u + d | u <- us])) => //.
  apply: leq_trans (size_comp_poly_leq _ _) _; rewrite ltnS.
  have le_P : ((size P).-1 <= n)%N by rewrite -subn1 leq_subLR add1n.
  rewrite (leq_trans _ le_P) // -[X in (_ <= X)%N]muln1 leq_mul2l; apply/orP; right.
  have : (size (c *: 'X + d%:P)%R <= 2)%N.
    rewrite (leq_trans (size_add _ _)) // geq_max (leq_trans (size_scale_leq _ _)).
      by rewrite (leq_trans (size_polyC_leq1 _)).
    by rewrite size_polyX.
  by case: (size _) => [|[|[|m]]].
split=> [vs ws _ eq_vs | vs ws x y e _ | t].
- by apply: blossom_perm; apply: perm_map.
- rewrite !map_cat !map_cons -blossom_combination ?subrK //.
  congr (blossom _ _ (_ ++ _ :: _)).
  rewrite !mulrDr addrACA -mulrDl subrK mul1r.
  by congr (_ + _ + _); rewrite mulrCA.
- by rewrite map_nseq blossom_diagonal // horner_comp !hornerE.
Qed.

End Conversion.

(** The powers (t - a)^n have the blossom (u_1 - a) ... (u_n - a). *)

Theorem blossom_power (F : fieldType) n (a : F) us : size us = n ->
  n`!%:R != 0 :> F ->
  blossom n (('X - a%:P) ^+ n) us = \prod_(u <- us) (u - a).
Proof.
move=> size_us n_unit; apply/esym.
apply: (blossom_unique (f := fun us => \prod_(u <- us) (u - a))) => //.
  by rewrite size_exp_XsubC.
split=> [vs ws _ eq_vs | vs ws x y e _ | t]; first exact: perm_big.
- rewrite !big_cat !big_cons /=.
  transitivity (\prod_(u <- vs) (u - a)
      * (((1 - e) * (x - a) + e * (y - a)) * \prod_(u <- ws) (u - a))).
    congr (_ * (_ * _)); apply/esym.
    by rewrite !mulrBr addrACA -opprD -mulrDl subrK mul1r.
  rewrite mulrDl mulrDr -!mulrA mulrCA; congr (_ + _).
  by rewrite mulrCA.
- by rewrite big_nseq -Monoid.iteropE horner_exp hornerXsubC.
Qed.
