(******************************************************************************)
(* A polynomial has no blossom of lower degree; and the degree must be given. *)
(*                                                                            *)
(* Notions: notions.v; polarization n P us of three_constructions.v is the    *)
(* inverse formula for degree n. Numbers are of characteristic 0 where two    *)
(* polynomials with the same values must be equal.                            *)
(*                                                                            *)
(* If f is affine in each of n arguments, f(t, ..., t) is a polynomial in t   *)
(* of degree at most n: each argument t is (1-t) 0 + t 1. So a polynomial of  *)
(* higher degree is on no such diagonal. For n = 1 this says that a map of    *)
(* degree 2 or more keeps neither affine nor linear combinations. The inverse *)
(* formula yields P on the diagonal whatever the degree of P; so for too low  *)
(* a degree it yields no blossom. The same polynomial read with two degrees   *)
(* has two blossoms: t has the mean of the arguments.                         *)
(*                                                                            *)
(* Statements: derose-thm1-exist (remark), goldman-nonaffine,                 *)
(* fj-reduction-not-multiaffine, fj-diag-consistency, fj-diagonal,            *)
(* blog-unique-form, goldman-degree-decides, hart-linear-scale.               *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Blossom Require Import notions existence polarization polarization_grouped.
From Blossom Require Import three_constructions misprints.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Lemma multiaffine_diagonal (F : fieldType) n (f : seq F -> F) :
  multiaffine n (f : seq F^o -> F^o) ->
  exists2 Q : {poly F}, (size Q <= n.+1)%N & forall t, f (nseq n t) = Q.[t].
Proof.
move=> aff_f; suff gen m us : (size us + m)%N = n ->
    exists2 Q : {poly F}, (size Q <= m.+1)%N & forall t, f (us ++ nseq m t) = Q.[t].
  exact: (gen n [::]).
elim: m us => [|m IHm] us size_us.
  exists (f us)%:P => [|t]; first by rewrite size_polyC leq_b1.
  by rewrite cats0 hornerC.
have end_point x : exists2 Q : {poly F}, (size Q <= m.+1)%N &
    forall t, f (rcons us x ++ nseq m t) = Q.[t].
  by apply: IHm; rewrite size_rcons addSnnS.
have [Q0 deg0 val0] := end_point 0; have [Q1 deg1 val1] := end_point 1.
exists ((1 - 'X) * Q0 + 'X * Q1) => [|t].
  have size_lin (L Q : {poly F}) : (size L <= 2)%N -> (size Q <= m.+1)%N ->
      (size (L * Q)%R <= m.+2)%N.
    move=> L_deg Q_deg; rewrite (leq_trans (size_mul_leq _ _)) //.
    by rewrite -subn1 leq_subLR add1n -[m.+3]/(2 + m.+1)%N leq_add.
  rewrite (leq_trans (size_add _ _)) // geq_max !size_lin ?size_polyX //.
  by rewrite (leq_trans (size_add _ _)) // size_opp size_polyX size_poly1.
have := aff_f us (nseq m t) 0 1 t; rewrite size_nseq -addnS => /(_ size_us).
rewrite scaler0 add0r /GRing.scale /= mulr1 => ->.
by rewrite -!cat_rcons val0 val1 !hornerE.
Qed.

Lemma same_values (F : fieldType) (P Q : {poly F}) : [char F] =i pred0 ->
  (forall t, P.[t] = Q.[t]) -> P = Q.
Proof.
move=> char0 same; apply/eqP; rewrite -subr_eq0; apply/negPn/negP => D_nz.
have inj : injective (fun m => m%:R : F).
  have nat_eq0 m : (m%:R == 0 :> F) = (m == 0)%N by move/charf0P: char0 => ->.
  move=> k l /= eq_kl; wlog le_kl : k l eq_kl / (k <= l)%N => [gen|].
    by case: (leqP k l) => [/(gen _ _ eq_kl) | /ltnW/(gen _ _ (esym eq_kl))].
  apply/eqP; rewrite eqn_leq le_kl -subn_eq0 -nat_eq0 natrB //.
  by rewrite eq_kl subrr eqxx.
have := max_poly_roots D_nz (rs := [seq m%:R | m <- iota 0 (size (P - Q))]).
rewrite size_map size_iota ltnn map_inj_uniq // iota_uniq.
by case/(_ _ isT)/negP=> //; apply/allP => _ /mapP[m _ ->]; rewrite /root !hornerE same subrr.
Qed.

Theorem no_blossom_of_lower_degree (F : fieldType) n (P : {poly F}) :
  [char F] =i pred0 -> (n.+1 < size P)%N -> ~ exists f, is_blossom n P f.
Proof.
move=> char0 P_deg [f [_ aff_f diag_f]].
have [Q Q_deg val] := multiaffine_diagonal aff_f.
have PQ : P = Q by apply: same_values => // t; rewrite -diag_f val.
by move: P_deg; rewrite PQ ltnNge Q_deg.
Qed.

(** goldman-nonaffine: polynomials of degree 2 or more keep no combinations. *)

Theorem polynomial_nonaffine (F : fieldType) (P : {poly F}) :
  [char F] =i pred0 -> (2 < size P)%N ->
  ~ (forall l s t, P.[(1 - l) * s + l * t] = (1 - l) * P.[s] + l * P.[t]).
Proof.
move=> char0 P_deg keeps; apply: (no_blossom_of_lower_degree char0 P_deg).
exists (fun us => P.[head 0 us]); split=> [us vs size_us eq_us | us vs x y a | t] //.
  case: us size_us eq_us => [|x [|]] // _; rewrite perm_sym.
  by move=> eq_us; rewrite (perm_small_eq _ eq_us).
by case: us => [|z us] //= _; apply: keeps.
Qed.

Theorem polynomial_nonlinear (F : fieldType) (P : {poly F}) :
  [char F] =i pred0 -> (2 < size P)%N ->
  ~ (forall k l s t, P.[k * s + l * t] = k * P.[s] + l * P.[t]).
Proof.
by move=> char0 P_deg keeps; apply: (polynomial_nonaffine char0 P_deg).
Qed.

(** fj-reduction-not-multiaffine: the inverse formula for too low a degree has
    P on its diagonal, so it cannot be a blossom. *)

Theorem polarization_diagonal (F : fieldType) n (P : {poly F}) t :
  n`!%:R != 0 :> F -> (0 < n)%N -> polarization n P (nseq n t) = P.[t].
Proof.
move=> n_unit n_gt0.
have value (Q : {poly F}) : polarization n Q (nseq n t) = n`!%:R^-1 * \sum_(1 <= N < n.+1)
    (-1) ^+ (n - N) * N%:R ^+ n * 'C(n, N)%:R * Q.[t].
  congr (_ * _); apply: eq_big_nat => N /andP[N_gt0 le_N].
  have N_unit : N%:R != 0 :> F by rewrite (nat_unit _ n_unit) // N_gt0.
  rewrite sum_subsets_nseq /arithmetic_mean sum_nseq size_nseq.
  by rewrite -[t *+ N]mulr_natr mulfK // -[Q.[t] *+ _]mulr_natl mulrA.
have one : polarization n (1 : {poly F}) (nseq n t) = 1.
  by rewrite -[LHS]blossom_polarization ?size_poly1 ?size_nseq ?blossom_one.
move: one; rewrite !value -!big_distrl /= hornerC mulr1 => one.
by rewrite mulrA one mul1r.
Qed.

Theorem misprint_fj_reduction (F : fieldType) n (P : {poly F}) :
  [char F] =i pred0 -> (0 < n)%N -> (n.+1 < size P)%N ->
  ~ multiaffine n (polarization n P : seq F^o -> F^o).
Proof.
move=> char0 n_gt0 P_deg aff; have [Q Q_deg val] := multiaffine_diagonal aff.
have n_unit : n`!%:R != 0 :> F by move/charf0P: char0 => ->; rewrite -lt0n fact_gt0.
have PQ : P = Q.
  by apply: same_values => // t; rewrite -val polarization_diagonal.
by move: P_deg; rewrite PQ ltnNge Q_deg.
Qed.

(** The blossom of t is the mean of the arguments. *)

Theorem blossom_identity (F : fieldType) n (us : seq F) :
  (0 < n)%N -> blossom n 'X us = (\sum_(u <- us) u) / n%:R.
Proof.
case: n => // n _; have singles : \sum_(S <- subsets 1 us) \prod_(u <- S) u = \sum_(u <- us) u.
  elim: us => [|u us IHus]; first by rewrite !big_nil.
  rewrite /= big_cat big_map IHus big_cons; congr (_ + _).
  by rewrite subsets0 big_seq1 big_seq1.
rewrite blossom_subsets !big_ord_recl /= !coefX !mul0r add0r mul1r singles bin1.
by rewrite [X in _ + X]big1 ?addr0 // => k _; rewrite coefX !mul0r.
Qed.

Section Identity.
Variables (F : fieldType) (n : nat).
Hypotheses (n_unit : n%:R != 0 :> F) (n_gt1 : (1 < n)%N).

Let n_gt0 : (0 < n)%N := ltnW n_gt1.

Let sum_front (a b : F) : \sum_(u <- a :: b :: nseq n.-2 0) u = a + b.
Proof. by rewrite !big_cons big1_seq ?addr0 // => u /andP[_ /nseqP[]]. Qed.

(** blog-unique-form: the blossom is not the same for all formal degrees. *)

Theorem misprint_blog_unique_form m : (1 < m)%N -> m%:R != 0 :> F ->
  n%:R != m%:R :> F ->
  ~ (forall (P : {poly F}) u v,
       blossom n P [:: u, v & nseq n.-2 0] = blossom m P [:: u, v & nseq m.-2 0]).
Proof.
move=> m_gt1 m_unit ne_nm /(_ 'X 1 0).
rewrite !blossom_identity ?(ltnW m_gt1) // sum_front !big_cons big1_seq.
  by rewrite !addr0 !mul1r => /invr_inj/eqP; apply/negP.
by move=> u /andP[_ /nseqP[]].
Qed.

(** fj-diagonal: values at different arguments can lie on the curve. *)

Theorem misprint_fj_diagonal :
  ~ (forall (P : {poly F}) us t, size us = n -> blossom n P us = P.[t] ->
       us = nseq n (head 0 us)).
Proof.
move=> /(_ 'X [:: 1, 0 & nseq n.-2 0] (1 / n%:R)); rewrite /= size_nseq.
rewrite blossom_identity // sum_front addr0 hornerX -[n in RHS](ltn_predK n_gt1).
case: n n_gt1 => [|[|k]] //= _ /(_ erefl erefl)[] /eqP.
by rewrite eq_sym oner_eq0.
Qed.

(** hart-linear-scale, second half: a factor may not move from one argument to
    another. *)

Theorem misprint_hart_linear_move (alpha : F) : alpha != 1 ->
  ~ (forall (P : {poly F}) x y us, size us = n.-2 ->
       blossom n P [:: alpha * x, y & us] = blossom n P [:: x, alpha * y & us]).
Proof.
move=> alpha_ne1 /(_ 'X 1 0 (nseq n.-2 0)); rewrite size_nseq.
rewrite !blossom_identity // !sum_front mulr1 mulr0 !addr0 => /(_ erefl).
by move/(mulIf (invr_neq0 n_unit))/eqP; apply/negP.
Qed.

End Identity.
