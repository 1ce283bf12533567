(******************************************************************************)
(* The polarization formulae: a blossom from values on the diagonal alone.    *)
(*                                                                            *)
(*   subsets N xs          == the N-element subsets of the list xs            *)
(*   \sum_(x <- S) x       == the sum of the points of S                      *)
(*   words m S f us        == the sum of f (us ++ w) over all words w with m  *)
(*                            letters from S                                  *)
(*   alternating xs g      == sum over all subsets S of xs of                 *)
(*                            (-1)^(size xs - size S) g(S)                    *)
(*                                                                            *)
(* The one combinatorial fact is inclusion and exclusion: for any symmetric   *)
(* function f the alternating sum, over the subsets S of xs, of the sums of f *)
(* over all words in S leaves only the words that use every letter once; they *)
(* are n! in number. If f is additive in each argument the words in S add up  *)
(* to q(x_1 + ... + x_N); if f is affine in each argument they add up to N^n  *)
(* times q at the mean, since N times the mean is the sum. Arguments live in  *)
(* any module, so that these are at once the formulae for curves, for         *)
(* triangles, and for simplices of any dimension.                             *)
(*                                                                            *)
(* Statements: fj-thm1, fj-thm2, fj-eq16, fj-alternating, fj-qn-split,        *)
(* fj-eq21, fj-formal-degree.                                                 *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Blossom Require Import notions existence.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section InclusionExclusion.
Variables (R : ringType) (V : eqType) (W : lmodType R).
Implicit Types (xs S us : seq V) (g : seq V -> W) (f : seq V -> W).

Fixpoint words m S f us : W :=
  if m is m'.+1 then \sum_(x <- S) words m' S f (rcons us x) else f us.

Definition alternating xs g : W :=
  \sum_(N < (size xs).+1)
    (-1) ^+ (size xs - N) *: \sum_(S <- subsets N xs) g S.

Lemma alternating_eq xs g h : g =1 h -> alternating xs g = alternating xs h.
Proof. by move=> gh; apply: eq_bigr => N _; under eq_bigr do rewrite gh. Qed.

Lemma alternatingD xs g h :
  alternating xs (fun S => g S + h S) = alternating xs g + alternating xs h.
Proof.
rewrite /alternating -big_split; apply: eq_bigr => N _.
by rewrite /= -scalerDr -big_split.
Qed.

Lemma alternating_sum xs I (r : seq I) (h : I -> seq V -> W) :
  alternating xs (fun S => \sum_(i <- r) h i S) =
    \sum_(i <- r) alternating xs (h i).
Proof.
elim: r => [|i r IHr].
  rewrite big_nil /alternating big1 // => N _.
  by rewrite big1 ?scaler0 // => S _; rewrite big_nil.
rewrite big_cons -IHr -alternatingD; apply: alternating_eq => S.
by rewrite big_cons.
Qed.

Lemma alternatingMn xs g m :
  alternating xs (fun S => g S *+ m) = alternating xs g *+ m.
Proof.
rewrite /alternating -sumrMnl; apply: eq_bigr => N _.
by rewrite scalerMnr -sumrMnl.
Qed.

Lemma subsets_big xs : subsets (size xs).+1 xs = [::].
Proof. by apply: size0nil; rewrite size_subsets bin_small. Qed.

Lemma alternating_cons x xs g :
  alternating (x :: xs) g =
    alternating xs (fun S => g (x :: S)) - alternating xs g.
Proof.
rewrite /alternating big_ord_recl.
under [X in _ + X = _]eq_bigr do rewrite lift0 /= subSS big_cat big_map scalerDr.
rewrite big_split /= addrCA; congr (_ + _).
transitivity (\sum_(N < (size xs).+2) (-1) ^+ ((size xs).+1 - N) *:
  \sum_(S <- subsets N xs) g S); first by rewrite [RHS]big_ord_recl.
rewrite big_ord_recr /= subsets_big big_nil scaler0 addr0 -sumrN.
by apply: eq_bigr => N _; rewrite subSn -1?ltnS // exprS mulN1r scaleNr.
Qed.

Lemma subsets0 xs : subsets 0 xs = [:: [::]].
Proof. by elim: xs. Qed.

Lemma size_in_subsets N xs S : S \in subsets N xs -> size S = N.
Proof.
elim: xs N S => [|x xs IHxs] [|N] S /=; rewrite ?inE ?mem_cat.
- by move/eqP->.
- by [].
- exact: IHxs.
- by case/orP=> [/mapP[T /IHxs <- ->] // | /IHxs].
Qed.

Lemma alternating_from1 xs g : g [::] = 0 ->
  alternating xs g =
    \sum_(1 <= N < (size xs).+1)
      (-1) ^+ (size xs - N) *: \sum_(S <- subsets N xs) g S.
Proof.
move=> g0; rewrite big_add1 /= big_mkord /alternating big_ord_recl subsets0.
by rewrite big_seq1 g0 scaler0 add0r.
Qed.

Lemma words_perm n m S f us vs : symmetric n f ->
  (size us + m = n)%N -> perm_eq us vs -> words m S f us = words m S f vs.
Proof.
move=> sym_f; elim: m us vs => [|m IHm] us vs /=; first by rewrite addn0; auto.
rewrite addnS => size_us eq_us; apply: eq_bigr => x _; apply: IHm.
  by rewrite size_rcons.
by rewrite -!cats1 perm_cat2r.
Qed.

(** The words in x :: S, sorted by the number of letters x they use. *)

Lemma words_cons n m x S f us : symmetric n f -> (size us + m = n)%N ->
  words m (x :: S) f us =
    \sum_(j < m.+1) words (m - j) S f (us ++ nseq j x) *+ 'C(m, j).
Proof.
move=> sym_f; elim: m us => [|m IHm] us size_us.
  by rewrite big_ord_recl big_ord0 /= cats0 addr0.
have size_us' y : (size (rcons us y) + m = n)%N by rewrite size_rcons addSnnS.
rewrite (pascal_sum (fun j => words (m.+1 - j) S f (us ++ nseq j x))) addrC.
rewrite /= big_cons IHm //; congr (_ + _).
  by apply: eq_bigr => j _; rewrite cat_rcons.
under eq_bigr do rewrite IHm //.
rewrite exchange_big; apply: eq_bigr => j _ /=.
rewrite sumrMnl subSn -1?ltnS //=; congr (_ *+ _); apply: eq_bigr => y _.
apply: (words_perm _ sym_f).
  rewrite size_cat size_rcons size_nseq addSnnS -addnA addSn subnKC //.
  by rewrite -ltnS.
by rewrite -!cats1 -!catA perm_cat2l perm_catC.
Qed.

Theorem inclusion_exclusion n f us xs m :
  symmetric n f -> (size us + m = n)%N -> (m <= size xs)%N ->
  alternating xs (fun S => words m S f us) =
    if m == size xs then f (us ++ xs) *+ m`! else 0.
Proof.
move=> sym_f; elim: xs m us => [|x xs IHxs] m us size_us le_m.
  move: le_m; rewrite leqn0 => /eqP->.
  by rewrite /alternating big_ord1 /= expr0 scale1r big_seq1 cats0.
rewrite alternating_cons.
rewrite (alternating_eq _ (fun S => words_cons x S sym_f size_us)).
rewrite alternating_sum big_ord_recl /= subn0 cats0 addrAC.
rewrite (@alternating_eq xs _ (fun S => words m S f us)) => [|S]; last first.
  by rewrite bin0.
rewrite subrr add0r.
case: m le_m size_us => [|m] le_m size_us; first by rewrite big_ord0.
rewrite big_ord_recl big1 => [|j _]; rewrite alternatingMn IHxs ?lift0 ?addr0.
- rewrite subn1 eqSS bin1 -catA /=; case: eqP => [_|_]; last by rewrite mul0rn.
  by rewrite -mulrnA mulnC -factS.
- by rewrite size_cat subn1 addn1 addSnnS.
- by rewrite subn1.
- rewrite /bump add1n subSS; case: eqP => [eq_m|_]; last by rewrite mul0rn.
  have lt_m : (m - j.+1 < m)%N by rewrite ltn_subrL (leq_trans _ (ltn_ord j)).
  by move: le_m; rewrite /= ltnS -eq_m leqNgt lt_m.
- rewrite /bump !add1n size_cat /= size_nseq -addnA subnKC // ltnS.
  exact: ltn_ord.
- by rewrite /bump add1n subSS (leq_trans (leq_subr _ _)).
Qed.

End InclusionExclusion.

(** Theorem 1 of Fernandez-Jambrina: a symmetric multiadditive map from its
    diagonal. It holds between any two modules, before division by n!. *)

Section Multiadditive.
Variables (R : ringType) (V : zmodType) (W : lmodType R) (n : nat).
Variables (f : seq V -> W) (q : V -> W).
Hypotheses (sym_f : symmetric n f) (add_f : multiadditive n f).
Hypothesis diag_f : diagonal n f q.

Lemma additive0 us vs : (size us + size vs).+1 = n -> f (us ++ 0 :: vs) = 0.
Proof.
move=> size_us; apply: (addrI (f (us ++ 0 :: vs))).
by rewrite -add_f // !addr0.
Qed.

Lemma additive_sum S us vs : (size us + size vs).+1 = n ->
  f (us ++ (\sum_(x <- S) x) :: vs) = \sum_(x <- S) f (us ++ x :: vs).
Proof.
move=> size_us; elim: S => [|x S IHS]; first by rewrite !big_nil additive0.
by rewrite !big_cons add_f // IHS.
Qed.

Lemma words_multiadditive m S us : (size us + m)%N = n ->
  words m S f us = f (us ++ nseq m (\sum_(x <- S) x)).
Proof.
elim: m us => [|m IHm] us /=; first by rewrite cats0.
rewrite addnS => size_us; rewrite additive_sum ?size_nseq //.
by apply: eq_bigr => x _; rewrite IHm ?size_rcons // cat_rcons.
Qed.

Theorem multiadditive_polarization xs : (0 < n)%N -> size xs = n ->
  f xs *+ n`! =
    \sum_(1 <= N < n.+1)
      (-1) ^+ (n - N) *: \sum_(S <- subsets N xs) q (\sum_(x <- S) x).
Proof.
move=> n_gt0 size_xs.
have := inclusion_exclusion (us := [::]) (m := n) sym_f erefl.
move=> /(_ xs); rewrite size_xs leqnn eqxx => /(_ isT) /= <-.
rewrite (@alternating_eq _ _ _ xs _ (fun S => q (\sum_(x <- S) x))) => [|S].
  by rewrite alternating_from1 ?size_xs // big_nil -diag_f -(prednK n_gt0)
    (additive0 (us := [::])) //= size_nseq prednK.
by rewrite words_multiadditive //= diag_f.
Qed.

End Multiadditive.

(** Theorem 2: the affine form, with means in place of sums. *)

Section Multiaffine.
Variables (F : fieldType) (V W : lmodType F) (n : nat).
Variables (f : seq V -> W) (q : V -> W).
Hypotheses (sym_f : symmetric n f) (aff_f : multiaffine n f).
Hypotheses (diag_f : diagonal n f q) (n_unit : n`!%:R != 0 :> F).

Definition mean (S : seq V) : V := (size S)%:R^-1 *: \sum_(x <- S) x.

Lemma affine_mean S us vs : (size us + size vs).+1 = n ->
  (0 < size S <= n)%N ->
  (size S)%:R *: f (us ++ mean S :: vs) = \sum_(x <- S) f (us ++ x :: vs).
Proof.
move=> size_us; elim: S => //= x [_ _|y S IHS].
  by rewrite /mean !big_seq1 invr1 !scale1r.
set T := y :: S in IHS *; move=> /= le_S.
have T_unit : (size T)%:R != 0 :> F by rewrite (nat_unit _ n_unit) //= ltnW.
have S_unit : (size T).+1%:R != 0 :> F by rewrite (nat_unit _ n_unit).
have -> : mean (x :: T) = (1 - (size T)%:R / (size T).+1%:R) *: x
                        + ((size T)%:R / (size T).+1%:R) *: mean T.
  rewrite /mean big_cons /= scalerA mulrAC mulfV // mul1r scalerDr.
  congr (_ *: _ + _); apply: (mulIf S_unit); rewrite mulVf // mulrBl mul1r.
  by rewrite mulfVK // -natrB // subSnn.
rewrite aff_f // scalerDr !scalerA mulrBr mulr1 -[(size S).+2]/(size T).+1.
rewrite mulrCA mulfV // mulr1 -natrB // subSnn scale1r big_cons IHS //=.
exact: ltnW.
Qed.

Lemma words_multiaffine m S us : (size us + m)%N = n -> (0 < size S <= n)%N ->
  words m S f us = (size S)%:R ^+ m *: f (us ++ nseq m (mean S)).
Proof.
move=> + S_ok; elim: m us => [|m IHm] us /=.
  by rewrite cats0 expr0 scale1r.
rewrite addnS => size_us; rewrite exprSr -scalerA affine_mean ?size_nseq //.
rewrite scaler_sumr; apply: eq_bigr => x _.
by rewrite IHm ?size_rcons // cat_rcons.
Qed.

Theorem multiaffine_polarization xs : (0 < n)%N -> size xs = n ->
  f xs =
    n`!%:R^-1 *: \sum_(1 <= N < n.+1)
      ((-1) ^+ (n - N) * N%:R ^+ n) *: \sum_(S <- subsets N xs) q (mean S).
Proof.
move=> n_gt0 size_xs; apply: (scalerI n_unit); rewrite scalerA mulfV // scale1r.
have := inclusion_exclusion (us := [::]) (m := n) sym_f erefl.
move=> /(_ xs); rewrite size_xs leqnn eqxx => /(_ isT) /=.
rewrite -scaler_nat => <-; rewrite alternating_from1 ?size_xs; last first.
  by rewrite -(prednK n_gt0) /= big_nil.
apply: eq_big_nat => N /andP[N_gt0 le_N]; rewrite -scalerA; congr (_ *: _).
rewrite scaler_sumr; apply: eq_big_seq => S S_in.
have size_S : size S = N by apply: size_in_subsets S_in.
by rewrite words_multiaffine // size_S -?diag_f // N_gt0.
Qed.

End Multiaffine.
