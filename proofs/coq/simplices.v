(******************************************************************************)
(* De Casteljau's algorithm on simplices, control nets and degree raising.    *)
(*                                                                            *)
(*   r : 'I_s -> V         == the s vertices of a simplex (three: a triangle) *)
(*   coordinate k u        == the barycentric coordinate number k of u        *)
(*   barycentric           == they add up to 1, and with the vertices to u    *)
(*   'X_{1..s}             == the indices of a net: s numbers; e + U_(k) has  *)
(*                            one more at place k; mdeg e is their sum        *)
(*   vertices e            == e_k copies of each vertex r_k                   *)
(*   net f e               == the control point: f at these copies            *)
(*   simplex_step v u e    == sum over k of coordinate k u times v (e + U_k)  *)
(*   simplex_level v us    == one step for each argument                      *)
(*   raised n f us         == the mean of the f at n of the n + 1 arguments   *)
(*                                                                            *)
(* As on an interval, each level replaces one vertex in the labels of the     *)
(* points by the argument of the level. Everything is said for any symmetric  *)
(* multiaffine map f into any vector space, so for every blossom, whatever    *)
(* the dimension. That f keeps all affine combinations, not only those of two *)
(* points, needs 2 to be invertible.                                          *)
(*                                                                            *)
(* Statements: derose-tri-points, derose-tri-eval, derose-tri-subdiv,         *)
(* derose-tri-raise, derose-tri-raise-points, derose-adt-affinemap,           *)
(* fj-tri-def, fj-tri-blossom, fj-eq23 (corrected: indices from 0).           *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_fingroup all_algebra.
From SsrMultinomials Require Import mpoly.
From Blossom Require Import notions existence polarization uniqueness elevation.
From Blossom Require Import polarization_grouped several_variables multivariate.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

(** An affine map keeps all combinations with coefficients of sum 1. *)

Lemma affine_combination (F : fieldType) (V W : lmodType F) (h : V -> W)
    (I : Type) (ks : seq I) (c : I -> F) (x : I -> V) :
  2%:R != 0 :> F ->
  (forall x y a, h ((1 - a) *: x + a *: y) = (1 - a) *: h x + a *: h y) ->
  \sum_(k <- ks) c k = 1 ->
  h (\sum_(k <- ks) c k *: x k) = \sum_(k <- ks) c k *: h (x k).
Proof.
move=> two aff sum1.
pose g z := h z - h 0; have hE z : h z = g z + h 0 by rewrite subrK.
have scale a y : g (a *: y) = a *: g y.
  have := aff 0 y a; rewrite scaler0 add0r /g => ->.
  by rewrite scalerBr scalerBl scale1r addrC !addrA addNr add0r addrC.
have add y z : g (y + z) = g y + g z.
  have half : 1 - 2%:R^-1 = 2%:R^-1 :> F.
    by apply: (mulIf two); rewrite mulrBl mul1r mulVf // addrK.
  have : g ((1 - 2%:R^-1) *: (2%:R *: y) + 2%:R^-1 *: (2%:R *: z)) =
      (1 - 2%:R^-1) *: g (2%:R *: y) + 2%:R^-1 *: g (2%:R *: z).
    rewrite /g aff !scalerBr addrACA -opprD -scalerDl subrK scale1r //.
  by rewrite half !scale !scalerA mulVf // !scale1r.
rewrite hE (big_morph g add (_ : g 0 = 0)) ?[in g 0 = 0]/g ?subrr //.
rewrite (eq_bigr (fun k => c k *: g (x k) + c k *: h 0)) => [|k _]; last first.
  by rewrite {1}hE scalerDr.
rewrite [RHS]big_split /=; congr (_ + _).
  by apply: eq_bigr => k _; apply: scale.
by rewrite -scaler_suml sum1 scale1r.
Qed.

Section Simplex.
Variables (F : fieldType) (V W : lmodType F) (s n : nat).
Variables (r : 'I_s -> V) (coordinate : 'I_s -> V -> F).
Implicit Types (e : 'X_{1..s}) (k : 'I_s) (u : V) (us vs : seq V).
Implicit Types (v : 'X_{1..s} -> W) (f : seq V -> W).

Definition barycentric : Prop :=
  forall u, \sum_k coordinate k u = 1 /\ \sum_k coordinate k u *: r k = u.

Definition vertices e : seq V := [seq r k | k <- letters e].

Definition net f e : W := f (vertices e).

Definition simplex_step v u : 'X_{1..s} -> W :=
  fun e => \sum_k coordinate k u *: v (e + U_(k))%MM.

Definition simplex_level v us := foldl simplex_step v us.

Definition simplex_casteljau v us : W := simplex_level v us 0%MM.

Lemma size_vertices e : size (vertices e) = mdeg e.
Proof. by rewrite size_map size_letters. Qed.

Section Blossom.
Variable f : seq V -> W.
Hypotheses (two : 2%:R != 0 :> F) (coords : barycentric).
Hypotheses (sym_f : symmetric n f) (aff_f : multiaffine n f).

(** One argument as a combination of the vertices. *)

Theorem blossom_at_vertices us u vs : (size us + size vs).+1 = n ->
  f (us ++ u :: vs) = \sum_k coordinate k u *: f (us ++ r k :: vs).
Proof.
move=> size_us; have [sum1 combination] := coords u; rewrite -{1}combination.
apply: (affine_combination (h := fun x => f (us ++ x :: vs))) => // x y a.
exact: aff_f.
Qed.

(** Every node is the blossom value that its label says. *)

Theorem simplex_nodes us e : (size us + mdeg e)%N = n ->
  simplex_level (net f) us e = f (us ++ vertices e).
Proof.
elim/last_ind: us e => [|us u IHus] e // size_us.
rewrite /simplex_level foldl_rcons -/(simplex_level _ _) cat_rcons.
rewrite size_rcons addSn in size_us.
rewrite blossom_at_vertices ?size_vertices //; apply: eq_bigr => k _.
rewrite IHus ?mdegD ?mdeg1 ?addn1 ?addnS //; congr (_ *: _); apply: sym_f.
  by rewrite size_cat size_vertices mdegD mdeg1 addn1 addnS.
by rewrite perm_cat2l (perm_map r (letters_add e k)).
Qed.

Theorem simplex_casteljau_blossom us : size us = n ->
  simplex_casteljau (net f) us = f us.
Proof.
move=> size_us; rewrite /simplex_casteljau simplex_nodes ?mdeg0 ?addn0 //.
have /size0nil-> : size (vertices 0%MM) = 0%N by rewrite size_vertices mdeg0.
by rewrite cats0.
Qed.

(** After k levels at one point u the nodes are the control points of the
    pieces of the simplex that have u as a vertex, k times. *)

Corollary simplex_subdivision u k e : (k + mdeg e)%N = n ->
  simplex_level (net f) (nseq k u) e = f (nseq k u ++ vertices e).
Proof. by move=> size_k; rewrite simplex_nodes ?size_nseq. Qed.

End Blossom.

(** The algorithm from any net whatever. *)

Lemma simplex_step_eq v w u : v =1 w -> simplex_step v u =1 simplex_step w u.
Proof. by move=> vw e; apply: eq_bigr => k _; rewrite vw. Qed.

Lemma simplex_level_eq v w us : v =1 w ->
  simplex_level v us =1 simplex_level w us.
Proof.
by elim: us v w => //= u us IHus v w vw; apply: IHus; apply: simplex_step_eq.
Qed.

Lemma simplex_step_commute v u w :
  simplex_step (simplex_step v u) w =1 simplex_step (simplex_step v w) u.
Proof.
move=> e; rewrite /simplex_step.
under eq_bigr do rewrite scaler_sumr; under [RHS]eq_bigr do rewrite scaler_sumr.
rewrite exchange_big; apply: eq_bigr => k _; apply: eq_bigr => l _ /=.
rewrite !scalerA mulrC; congr (_ *: v _).
by apply/mnmP => i; rewrite !mnmDE addnAC.
Qed.

Lemma simplex_level_step v u us :
  simplex_level (simplex_step v u) us =1 simplex_step (simplex_level v us) u.
Proof.
elim: us v => //= w us IHus v e; rewrite -IHus.
by apply: simplex_level_eq; apply: simplex_step_commute.
Qed.

Theorem simplex_level_perm v us vs : perm_eq us vs ->
  simplex_level v us =1 simplex_level v vs.
Proof.
elim: us v vs => [|u us IHus] v vs.
  by move/perm_size/esym/size0nil->.
move=> eq_us; have: u \in vs by rewrite -(perm_mem eq_us) mem_head.
move=> u_in; case/splitPr: u_in eq_us => vs1 vs2 eq_us e.
have eq_us' : perm_eq us (vs1 ++ vs2).
  by move: eq_us; rewrite perm_sym perm_catC cat_cons perm_cons perm_catC perm_sym.
rewrite /= (IHus _ _ eq_us') /simplex_level !foldl_cat /=.
by apply: simplex_level_eq => e'; rewrite -!/(simplex_level _ _) simplex_level_step.
Qed.

Lemma simplex_level_linear v w a b us e :
  simplex_level (fun e' => a *: v e' + b *: w e') us e =
    a *: simplex_level v us e + b *: simplex_level w us e.
Proof.
elim: us v w => //= u us IHus v w; rewrite -IHus.
apply: simplex_level_eq => e'; rewrite /simplex_step !scaler_sumr -big_split.
by apply: eq_bigr => k _; rewrite scalerDr !scalerA ![_ * coordinate _ _]mulrC.
Qed.

Theorem simplex_casteljau_affine v us vs x y a :
  (forall k, affine (coordinate k)) ->
  simplex_casteljau v (us ++ ((1 - a) *: x + a *: y) :: vs) =
    (1 - a) *: simplex_casteljau v (us ++ x :: vs)
      + a *: simplex_casteljau v (us ++ y :: vs).
Proof.
move=> aff; rewrite /simplex_casteljau /simplex_level !foldl_cat /=.
rewrite -!/(simplex_level _ _) -simplex_level_linear; apply: simplex_level_eq => e.
rewrite /simplex_step !scaler_sumr -big_split; apply: eq_bigr => k _ /=.
by rewrite aff scalerDl !scalerA.
Qed.

Theorem simplex_casteljau_corner v e :
  (forall j k, coordinate k (r j) = (k == j)%:R) ->
  simplex_casteljau v (vertices e) = v e.
Proof.
move=> corner; suff gen ks e' :
    simplex_level v [seq r k | k <- ks] e' = v (e' + \sum_(k <- ks) U_(k))%MM.
  rewrite /simplex_casteljau gen add0m; congr (v _).
  rewrite big_letters [RHS]multinomUE_id; apply: eq_bigr => i _.
  by rewrite big_nseq -Monoid.iteropE.
elim: ks v e' => [|j ks IHks] v' e'; first by rewrite big_nil addm0.
rewrite /= IHks big_cons /simplex_step (bigD1 j) //= corner eqxx scale1r.
rewrite [X in _ + X]big1 => [|k ne_kj]; last first.
  by rewrite corner (negPf ne_kj) scale0r.
rewrite addr0; congr (v' _); apply/mnmP => i; rewrite !mnmDE.
by rewrite -addnA; congr (_ + _)%N; apply: addnC.
Qed.

(** Control nets are unique: if the algorithm from v has the values of f on
    the diagonal, then it computes f, and v is the net of f. *)

Theorem simplex_is_blossom v f : n`!%:R != 0 :> F ->
  symmetric n f -> multiaffine n f -> (forall k, affine (coordinate k)) ->
  (forall j k, coordinate k (r j) = (k == j)%:R) ->
  (forall u, simplex_casteljau v (nseq n u) = f (nseq n u)) ->
  (forall us, size us = n -> simplex_casteljau v us = f us) /\
  (forall e, mdeg e = n -> v e = net f e).
Proof.
move=> n_unit sym_f aff_f aff corner same.
have agree us : size us = n -> simplex_casteljau v us = f us.
  apply: multiaffine_unique n_unit _ _ sym_f aff_f same us => [us vs _ eq_us|].
    exact: simplex_level_perm.
  by move=> us vs x y a _; apply: simplex_casteljau_affine.
split=> // e e_deg; rewrite /net -agree ?size_vertices //.
by rewrite simplex_casteljau_corner.
Qed.

End Simplex.

(** Degree raising, in any dimension. *)

Section Raising.
Variables (F : fieldType) (V W : lmodType F) (n : nat) (f : seq V -> W).
Hypotheses (n_unit : n.+1%:R != 0 :> F).
Hypotheses (sym_f : symmetric n f) (aff_f : multiaffine n f).

Definition raised (us : seq V) : W :=
  n.+1%:R^-1 *: \sum_(i < n.+1) f (omit i us).

Lemma size_omit (T : Type) i (xs : seq T) : (i < size xs)%N ->
  size (omit i xs) = (size xs).-1.
Proof.
move=> lt_i; rewrite /omit size_cat size_take lt_i size_drop.
by rewrite -{2}(subnKC lt_i).
Qed.

Lemma perm_omit (T : eqType) (x : T) i (xs : seq T) : (i < size xs)%N ->
  perm_eq (nth x xs i :: omit i xs) xs.
Proof.
move=> lt_i; rewrite -{3}(cat_take_drop i xs) (drop_nth x lt_i).
by rewrite -cat1s perm_catCA.
Qed.

Lemma raised_as_sum us : size us = n.+1 ->
  raised us = n.+1%:R^-1 *: \sum_(x <- us) f (rem x us).
Proof.
move=> size_us; congr (_ *: _); rewrite [RHS](big_nth 0) size_us big_mkord.
apply: eq_bigr => i _; have lt_i : (i < size us)%N by rewrite size_us.
apply: sym_f; first by rewrite size_omit // size_us.
rewrite -(perm_cons (nth 0 us i)) (perm_trans (perm_omit 0 lt_i)) //.
by rewrite perm_to_rem // mem_nth.
Qed.

Theorem raised_blossom q : diagonal n f q ->
  [/\ symmetric n.+1 raised, multiaffine n.+1 raised & diagonal n.+1 raised q].
Proof.
move=> diag_f; split=> [us vs size_us eq_us | us vs x y a [size_us] | t].
- have size_vs : size vs = n.+1 by rewrite -(perm_size eq_us).
  rewrite !raised_as_sum // (perm_big _ eq_us); congr (_ *: _).
  apply: eq_big_seq => x x_in; have x_us : x \in us by rewrite (perm_mem eq_us).
  apply: sym_f; first by rewrite size_rem ?size_us.
  rewrite -(perm_cons x) -(permPl (perm_to_rem x_us)) (perm_trans eq_us) //.
  exact: perm_to_rem.
- rewrite /raised ![_ *: (_^-1 *: _)]scalerA ![_ * _^-1]mulrC -!scalerA -scalerDr.
  congr (_ *: _); rewrite !scaler_sumr -big_split; apply: eq_bigr => i _ /=.
  move: (nat_of_ord i) (ltn_ord i) => {}i; rewrite -size_us ltnS => i_small.
  case: (ltnP i (size us)) => [lt_i | le_i].
    rewrite !omit_left // aff_f // size_omit // -size_us.
    by case: (size us) lt_i.
  rewrite -(subnKC le_i); case def_j: (i - size us)%N => [|j].
    by rewrite !omit_right /omit /= !drop0 -scalerDl subrK scale1r.
  have lt_j : (j < size vs)%N.
    by move: i_small; rewrite -(subnKC le_i) def_j leq_add2l.
  rewrite !omit_right /omit /= -/(omit j vs) aff_f // size_omit // -addnS.
  rewrite -size_us; congr (_ + _)%N.
  by case: (size vs) lt_j.
rewrite /raised (eq_bigr (fun=> q t)) => [|i _].
  by rewrite sumr_const card_ord -scaler_nat scalerA mulVf // scale1r.
by rewrite omit_nseq.
Qed.

Theorem raised_unique q g : n.+1`!%:R != 0 :> F -> diagonal n f q ->
  symmetric n.+1 g -> multiaffine n.+1 g -> diagonal n.+1 g q ->
  forall us, size us = n.+1 -> g us = raised us.
Proof.
move=> Sn_unit diag_f sym_g aff_g diag_g.
have [sym aff diag] := raised_blossom diag_f.
by apply: multiaffine_unique Sn_unit sym_g aff_g sym aff _ => t; rewrite diag_g.
Qed.

(** The net of degree n + 1 from that of degree n. *)

Theorem raised_net s (r : 'I_s -> V) (e : 'X_{1..s}) : mdeg e = n.+1 ->
  raised (vertices r e) =
    \sum_k ((e k)%:R / n.+1%:R) *: net r f (e - U_(k))%MM.
Proof.
move=> e_deg; pose g k := net r f (e - U_(k))%MM.
have size_e : size (letters e) = n.+1 by rewrite size_letters.
have omitted (i : 'I_n.+1) k : f (omit i (vertices r e)) = g (nth k (letters e) i).
  have lt_i : (i < size (letters e))%N by rewrite size_e.
  have l_in := mem_nth k lt_i; set l := nth k _ i in l_in *.
  have le_l : (U_(l) <= e)%MM.
    rewrite lep1mP; apply: contraL l_in => /eqP e_l.
    rewrite -has_pred1 has_count count_letters big1 // => x _ /=.
    by case: eqP => [->|_]; rewrite ?e_l ?muln0.
  rewrite /g /net /vertices /omit -map_take -map_drop -map_cat -/(omit i _).
  apply: sym_f; first by rewrite size_map size_omit // size_e.
  apply: perm_map; rewrite -(perm_cons l) (perm_trans (perm_omit k lt_i)) //.
  by rewrite -{1}(submK le_l) letters_add.
rewrite /raised scaler_sumr.
under [RHS]eq_bigr do rewrite mulrC -scalerA scaler_nat.
rewrite -!scaler_sumr; congr (_ *: _).
have [k0 _] : exists k : 'I_s, true by case: (letters e) size_e => // k; exists k.
rewrite (eq_bigr _ (fun i _ => omitted i k0)).
have <- : \sum_(l <- letters e) g l = \sum_(i < n.+1) g (nth k0 (letters e) i).
  by rewrite (big_nth k0) size_e big_mkord.
rewrite big_letters; apply: eq_bigr => k _.
by rewrite big_nseq -Monoid.iteropE.
Qed.

End Raising.

(** Formula (23) of Fernandez-Jambrina: the control points of a triangle from
    values on the triangle. Binomials with J > j or K > k are 0. *)

Theorem triangle_polarization (F : fieldType) (V W : lmodType F) n
    (f : seq V -> W) (q : V -> W) (a b c : V) i j k :
  symmetric n f -> multiaffine n f -> diagonal n f q -> n`!%:R != 0 :> F ->
  (0 < n)%N -> (i + j + k)%N = n ->
  f (nseq i a ++ nseq j b ++ nseq k c) =
    n`!%:R^-1 *: \sum_(1 <= N < n.+1)
      ((-1) ^+ (n - N) * N%:R ^+ n) *:
        \sum_(J < N.+1) \sum_(K < (N - J).+1)
          q (N%:R^-1 *: (a *+ (N - J - K) + b *+ J + c *+ K))
            *+ ('C(j, J) * 'C(k, K) * 'C(i, N - J - K)).
Proof.
move=> sym_f aff_f diag_f n_unit n_gt0 size_ijk.
have -> : f (nseq i a ++ nseq j b ++ nseq k c) =
    f ((nseq i a ++ nseq k c) ++ nseq j b).
  apply: sym_f; first by rewrite !size_cat !size_nseq addnA.
  by rewrite -catA perm_cat2l perm_catC.
rewrite (multiaffine_polarization sym_f aff_f diag_f) //; last first.
  by rewrite !size_cat !size_nseq addnAC.
congr (_ *: _); apply: eq_bigr => N _; congr (_ *: _).
rewrite sum_subsets_cat; apply: eq_bigr => J _.
under eq_bigr do rewrite sum_subsets_nseq.
rewrite sumrMnl sum_subsets_cat -sumrMnl; apply: eq_bigr => K _.
under eq_bigr do rewrite sum_subsets_nseq.
rewrite sumrMnl (sum_subsets_nseq _ _ _ (fun A => q (mean ((A ++ _) ++ _)))).
rewrite -!mulrnA; congr (q _ *+ _); last by rewrite mulnC [('C(k, K) * _)%N]mulnC.
rewrite /mean !size_cat !size_nseq !big_cat !big_nseq -!Monoid.iteropE /=.
rewrite subnK -1?ltnS // subnK -1?ltnS //; congr (_ *: _).
by rewrite addrAC.
Qed.
