(******************************************************************************)
(* Polarization for polynomials, and with repeated arguments.                 *)
(*                                                                            *)
(* Notions: notions.v, polarization.v. When an argument is repeated, equal    *)
(* subsets are counted once, with a binomial coefficient: among the N-element *)
(* subsets of p copies of a and r copies of b there are C(p,N-I) C(r,I) with  *)
(* I copies of b. Over two repeated arguments the formula gives the control   *)
(* points of a curve from points on the curve, over three the control points  *)
(* of a triangle; the general form is a recursion over the groups.            *)
(*                                                                            *)
(*   control_point n P a b k  == the control point number k of P over [a, b]: *)
(*                               the blossom at n - k copies of a, k of b     *)
(*   ungroup gs               == for gs = (r_1,x_1), (r_2,x_2), ... the list  *)
(*                               of r_1 copies of x_1, r_2 of x_2, ...        *)
(*   grouped gs N g           == the sum over all j_i <= r_i of sum N of      *)
(*                               C(r_1,j_1) C(r_2,j_2) ... times g at j_1     *)
(*                               copies of x_1, j_2 of x_2, ...               *)
(*                                                                            *)
(* Statements: fj-cor1, fj-cor1-n2, fj-cor1-n3, fj-eq22, fj-eq23 (corrected:  *)
(* indices from 0), fj-diag-consistency.                                      *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Blossom Require Import notions existence polarization casteljau.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section SubsetsOfRepeated.
Variables (T : eqType) (W : zmodType).
Implicit Types (g : seq T -> W).

Lemma sum_subsets_cat N (xs ys : seq T) g :
  \sum_(S <- subsets N (xs ++ ys)) g S =
    \sum_(I < N.+1) \sum_(A <- subsets (N - I) xs) \sum_(B <- subsets I ys)
      g (A ++ B).
Proof.
elim: xs N g => [|x xs IHxs] N g /=.
  rewrite big_ord_recr /= subnn big_seq1 [X in X + _]big1 ?add0r // => I _.
  by move: (ltn_ord I); rewrite -subn_gt0; case: (N - I)%N => // k; rewrite big_nil.
case: N => [|N] /=.
  rewrite IHxs !big_ord1 /=; apply: eq_bigr => A _; exact: eq_bigr.
rewrite big_cat big_map (IHxs N.+1) (IHxs N (fun S => g (x :: S))) /=.
rewrite [RHS]big_ord_recr [X in _ + X = _]big_ord_recr /= addrA; congr (_ + _).
  rewrite -big_split; apply: eq_bigr => I _ /=.
  by rewrite subSn -1?ltnS //= big_cat big_map.
by rewrite subnn.
Qed.

Lemma sum_subsets_nseq N p (a : T) g :
  \sum_(S <- subsets N (nseq p a)) g S = g (nseq N a) *+ 'C(p, N).
Proof.
elim: p N g => [|p IHp] [|N] g /=; rewrite ?big_seq1 ?big_nil ?mulr0n //.
  by rewrite IHp bin0.
by rewrite big_cat big_map !IHp /= -mulrnDr addnC binS.
Qed.

Fixpoint ungroup (gs : seq (nat * T)) : seq T :=
  if gs is (r, x) :: gs' then nseq r x ++ ungroup gs' else [::].

Fixpoint grouped (gs : seq (nat * T)) N g : W :=
  if gs is (r, x) :: gs' then
    \sum_(I < N.+1) grouped gs' I (fun B => g (nseq (N - I) x ++ B))
                      *+ 'C(r, N - I)
  else if N is 0 then g [::] else 0.

Lemma sum_subsets_ungroup gs N g :
  \sum_(S <- subsets N (ungroup gs)) g S = grouped gs N g.
Proof.
elim: gs N g => [|[r x] gs IHgs] N g /=.
  by case: N => [|N]; rewrite ?big_seq1 ?big_nil.
rewrite sum_subsets_cat; apply: eq_bigr => I _.
rewrite (sum_subsets_nseq _ _ _ (fun A => \sum_(B <- _) g (A ++ B))).
by rewrite IHgs.
Qed.

End SubsetsOfRepeated.

(** Grouped form of Theorem 2, for any symmetric multiaffine map. *)

Theorem grouped_polarization (F : fieldType) (V W : lmodType F) n
    (f : seq V -> W) (q : V -> W) (gs : seq (nat * V)) :
  symmetric n f -> multiaffine n f -> diagonal n f q -> n`!%:R != 0 :> F ->
  (0 < n)%N -> size (ungroup gs) = n ->
  f (ungroup gs) =
    n`!%:R^-1 *: \sum_(1 <= N < n.+1)
      ((-1) ^+ (n - N) * N%:R ^+ n) *: grouped gs N (fun S => q (mean S)).
Proof.
move=> sym_f aff_f diag_f n_unit n_gt0 size_gs.
rewrite (multiaffine_polarization sym_f aff_f diag_f) //; congr (_ *: _).
by apply: eq_bigr => N _; rewrite sum_subsets_ungroup.
Qed.

Section Polynomials.
Variables (F : fieldType) (n : nat) (P : {poly F}).
Hypotheses (n_unit : n`!%:R != 0 :> F) (P_deg : (size P <= n.+1)%N).
Hypothesis n_gt0 : (0 < n)%N.

Definition arithmetic_mean (S : seq F) : F := (\sum_(u <- S) u) / (size S)%:R.

(** Corollary 1: the blossom of P from values of P. *)

Theorem blossom_polarization us : size us = n ->
  blossom n P us =
    n`!%:R^-1 * \sum_(1 <= N < n.+1)
      (-1) ^+ (n - N) * N%:R ^+ n *
        \sum_(S <- subsets N us) P.[arithmetic_mean S].
Proof.
move=> size_us; have [sym_b aff_b diag_b] := blossom_exists n_unit P_deg.
rewrite (@multiaffine_polarization _ [lmodType F of F^o] [lmodType F of F^o]
  _ _ _ sym_b aff_b diag_b) //; congr (_ * _).
apply: eq_bigr => N _; congr (_ * _); apply: eq_bigr => S _.
by rewrite /mean /arithmetic_mean mulrC.
Qed.

Lemma sum_nseq m (a : F) : \sum_(u <- nseq m a) u = a *+ m.
Proof. by rewrite big_nseq -Monoid.iteropE. Qed.

(** Corollary 2: the control points from points of the curve. *)

Theorem control_point_polarization a b k : (k <= n)%N ->
  control_point n P a b k =
    n`!%:R^-1 * \sum_(1 <= N < n.+1)
      (-1) ^+ (n - N) * N%:R ^+ n *
        \sum_(I < N.+1)
          'C(k, I)%:R * 'C(n - k, N - I)%:R *
            P.[((N - I)%:R * a + I%:R * b) / N%:R].
Proof.
move=> le_kn; rewrite /control_point blossom_polarization; last first.
  by rewrite size_cat !size_nseq subnK.
congr (_ * _); apply: eq_bigr => N _; congr (_ * _).
rewrite sum_subsets_cat; apply: eq_bigr => I _.
under eq_bigr do rewrite sum_subsets_nseq.
rewrite (sum_subsets_nseq _ _ _ (fun A => P.[arithmetic_mean (A ++ _)] *+ _)).
rewrite /arithmetic_mean big_cat !sum_nseq size_cat !size_nseq /=.
by rewrite subnK -1?ltnS // -mulrA !mulr_natl mulrnAC.
Qed.

End Polynomials.
