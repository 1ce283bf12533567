(******************************************************************************)
(* The homogeneous blossom: points and vectors as arguments; derivatives.     *)
(*                                                                            *)
(* Notions: notions.v. A pair (u,v) has parameter u and mass v; point u is    *)
(* (u,1), and delta is the vector (1,0). P^`(k) is the k-th derivative of P,  *)
(* n ^_ k is n (n-1) ... (n-k+1) = n!/(n-k)!.                                 *)
(*                                                                            *)
(* A vector contributes to the product of factors the factor X. From t on     *)
(* n - k places and delta on k, the product is (1 + t X)^(n-k) X^k, whose     *)
(* coefficients are those of the k-th derivative but for the factor n!/(n-k)!.*)
(* Binomial expansions of the factor of (t + h delta) are Taylor's theorem,   *)
(* and delta = point 1 - point 0 turns derivatives into differences.          *)
(*                                                                            *)
(* Statements: goldman-hblossom-terms, -scale, -dehom, goldman-thm6,          *)
(* goldman-thm7, goldman-thm8 (corrected: multilinear), goldman-thm9,         *)
(* goldman-eq44, goldman-ex-7b, goldman-ex-8b, derose-F1, derose-F2,          *)
(* derose-eq4, blog-derivative (corrected), fj-eq10, goldman-t-plus-h.        *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Blossom Require Import notions existence.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section Homogeneous.
Variable F : fieldType.
Implicit Types (P : {poly F}) (us : seq F) (ws : seq (F * F)) (t h : F).

(** Points of mass one: the affine blossom. *)

Theorem hblossom_points n P us :
  hblossom n P [seq point u | u <- us] = blossom n P us.
Proof. by []. Qed.

(** Scaling one pair scales the value. *)

Theorem hblossom_scale n P ws ws' (c : F) (w : F * F) :
  hblossom n P (ws ++ (c * w.1, c * w.2) :: ws') =
    c * hblossom n P (ws ++ w :: ws').
Proof.
have := hblossom_combination n P ws w w c 0 ws'.
by rewrite !mul0r !addr0.
Qed.

(** Theorem 6 of Goldman: homogenising the blossom, that is, dividing each
    parameter by its mass and multiplying by all masses, gives the blossom of
    the homogenised polynomial. *)

Theorem blossom_homogenize n P ws : all (fun w => w.2 != 0) ws ->
  hblossom n P ws =
    (\prod_(w <- ws) w.2) * blossom n P [seq w.1 / w.2 | w <- ws].
Proof.
move=> masses; rewrite /blossom /hblossom -functionalZ; congr functional.
elim: ws masses => [|w ws IHws] /=.
  by rewrite big_nil scale1r.
case/andP=> w_mass /IHws IH; rewrite !factors_cons big_cons IH /=.
rewrite -scalerAr [w.2 * _]mulrC -[RHS]scalerA [in RHS]scalerAl.
congr (_ *: (_ * _)).
by rewrite scalerDr scalerA mulrCA mulfV // mulr1 polyC1 alg_polyC.
Qed.

Theorem homogenized_mass n P t w : w != 0 -> (size P <= n.+1)%N ->
  homogenized n P t w = w ^+ n * P.[t / w].
Proof.
move=> w_mass P_deg; rewrite (horner_coef_wide _ P_deg) big_distrr.
apply: eq_bigr => k _ /=; rewrite mulrCA -!mulrA; congr (_ * _).
rewrite exprMn exprVn mulrCA; congr (_ * _).
by rewrite expfB_cond ?ltnS // (negPf w_mass) add0n -ltnS.
Qed.

(** Theorem 8 of Goldman, for the homogeneous blossom of P, some arguments kept
    aside. *)

Theorem binomial_expansion n P ws m t h :
  hblossom n P (ws ++ nseq m (t + h, 1)) =
    \sum_(k < m.+1)
      'C(m, k)%:R * h ^+ k
        * hblossom n P (ws ++ nseq (m - k) (point t) ++ nseq k delta).
Proof.
rewrite /hblossom factors_cat factors_nseq /= polyC1.
rewrite scalerDl addrA exprDn big_distrr functional_sum; apply: eq_bigr => k _.
rewrite !factors_cat !factors_nseq /= polyC1 polyC0 add0r scale1r exprZn.
by rewrite -scaler_nat -!scalerAr scalerA functionalZ.
Qed.

Corollary taylor_blossom n P t h : n`!%:R != 0 :> F -> (size P <= n.+1)%N ->
  P.[t + h] = \sum_(k < n.+1)
    'C(n, k)%:R * h ^+ k
      * hblossom n P (nseq (n - k) (point t) ++ nseq k delta).
Proof.
move=> n_unit P_deg; rewrite -(blossom_diagonal _ n_unit P_deg).
by rewrite /blossom map_nseq -(binomial_expansion n P [::] n).
Qed.

(** Theorem 9 of Goldman: derivatives. *)

Lemma falling_binomial n k i : (k <= i <= n)%N ->
  ('C(n - k, i - k) * n ^_ k = i ^_ k * 'C(n, i))%N.
Proof.
case/andP=> le_ki le_in; have le_kn := leq_trans le_ki le_in.
apply/eqP; rewrite -(eqn_pmul2r (fact_gt0 (i - k))).
rewrite -(eqn_pmul2r (fact_gt0 (n - i))); apply/eqP.
have bin_nk := bin_fact (leq_sub2r k le_in).
rewrite subnBA // subnK // in bin_nk.
rewrite -!mulnA mulnCA bin_nk ffact_fact // [RHS]mulnCA.
by rewrite [(i ^_ k * _)%N]mulnA ffact_fact // bin_fact.
Qed.

Theorem derivative_hblossom n P k t :
  n`!%:R != 0 :> F -> (size P <= n.+1)%N -> (k <= n)%N ->
  (P^`(k)).[t] =
    (n ^_ k)%:R * hblossom n P (nseq (n - k) (point t) ++ nseq k delta).
Proof.
move=> n_unit P_deg le_kn; have le_kSn : (k <= n.+1)%N by rewrite ltnW.
have deriv_deg : (size P^`(k) <= n.+1 - k)%N.
  apply/leq_sizeP => j; rewrite leq_subLR => le_j.
  by rewrite coef_derivn nth_default ?mul0rn // (leq_trans P_deg).
rewrite (horner_coef_wide _ deriv_deg) /hblossom /functional.
rewrite factors_cat !factors_nseq /= polyC1 polyC0 add0r scale1r.
rewrite -(big_mkord xpredT (fun i => P`_i * _`_i / 'C(n, i)%:R)).
rewrite (@big_cat_nat _ _ _ k) //=.
rewrite [X in X + _]big_nat_cond [X in X + _]big1 ?add0r; last first.
  by move=> i /andP[/andP[_ lt_ik] _]; rewrite coefMXn lt_ik mulr0 mul0r.
rewrite -[X in \sum_(X <= _ < _) _]add0n big_addn big_mkord big_distrr.
apply: eq_bigr => j _ /=.
have le_jn : (j + k <= n)%N by have := ltn_ord j; rewrite ltn_subRL addnC ltnS.
rewrite coefMXn ltnNge leq_addl addnK coef_factor_power /= expr1n mulr1.
have := @falling_binomial n k (j + k); rewrite leq_addl le_jn addnK.
move=> /(_ isT) fb; apply: (mulIf (binomial_unit le_jn n_unit)).
rewrite coef_derivn [(k + j)%N]addnC -[RHS]mulrA divfK ?binomial_unit //.
rewrite -[P`__ *+ _]mulr_natr -[t ^+ j *+ _]mulr_natr [RHS]mulrC -!mulrA.
congr (_ * _).
by rewrite [LHS]mulrCA -!natrM fb.
Qed.

(** Equation (4) of DeRose: derivatives as differences of blossom values. *)

Theorem hblossom_difference n P ws k a b :
  (b - a) ^+ k * hblossom n P (ws ++ nseq k delta) =
    \sum_(j < k.+1) (-1) ^+ j * 'C(k, j)%:R *
      hblossom n P (ws ++ nseq (k - j) (point b) ++ nseq j (point a)).
Proof.
have split_X : (b - a) *: (0 + 1 *: 'X) =
    (1 + b *: 'X) + (-1) *: (1 + a *: 'X) :> {poly F}.
  by rewrite add0r scale1r scaleN1r opprD addrACA subrr add0r scalerBl.
rewrite /hblossom factors_cat factors_nseq /= polyC0 -functionalZ scalerAr.
rewrite -exprZn split_X exprDn big_distrr functional_sum.
apply: eq_bigr => j _.
rewrite !factors_cat !factors_nseq /= polyC1 exprZn -scaler_nat.
by rewrite -!scalerAr scalerA functionalZ [_%:R * _]mulrC.
Qed.

Theorem derivative_blossom n P k s :
  n`!%:R != 0 :> F -> (size P <= n.+1)%N -> (k <= n)%N ->
  (P^`(k)).[s] =
    (n ^_ k)%:R * \sum_(j < k.+1) (-1) ^+ j * 'C(k, j)%:R *
      blossom n P (nseq (k - j) 1 ++ nseq j 0 ++ nseq (n - k) s).
Proof.
move=> n_unit P_deg le_kn; rewrite (derivative_hblossom _ n_unit) //.
have := hblossom_difference n P (nseq (n - k) (point s)) k 0 1.
rewrite subr0 expr1n mul1r => ->; congr (_ * _); apply: eq_bigr => j _; congr (_ * _).
rewrite /blossom !map_cat !map_nseq; apply: hblossom_perm.
by rewrite perm_catC -catA.
Qed.

(** DeRose, section 4.5: first and second derivatives. *)

Corollary first_derivative_blossom n P s :
  n`!%:R != 0 :> F -> (size P <= n.+1)%N -> (0 < n)%N ->
  P^`().[s] = n%:R * (blossom n P (1 :: nseq n.-1 s)
                        - blossom n P (0 :: nseq n.-1 s)).
Proof.
move=> n_unit P_deg n_gt0; rewrite -derivn1 (derivative_blossom _ n_unit) //.
rewrite ffactn1 !big_ord_recl big_ord0 /= addr0 expr0 expr1 !mul1r mulN1r.
by rewrite bin1 mulN1r subn1.
Qed.

(** Equation (4.4) of Goldman: the coefficients. *)

Theorem coefficient_hblossom n P k :
  n`!%:R != 0 :> F -> (k <= n)%N ->
  P`_k = 'C(n, k)%:R * hblossom n P (nseq (n - k) (point 0) ++ nseq k delta).
Proof.
move=> n_unit le_kn; rewrite /hblossom factors_cat !factors_nseq /=.
rewrite polyC1 polyC0 add0r scale1r scale0r addr0 expr1n mul1r /functional.
have lt_k : (k < n.+1)%N by [].
rewrite (bigD1 (Ordinal lt_k)) //= big1 ?addr0 => [|i ne_i].
  by rewrite coefXn eqxx mulr1 mulrC divfK ?binomial_unit.
by rewrite coefXn (negPf (_ : i != k :> nat)) ?mulr0 ?mul0r.
Qed.

End Homogeneous.

(** Theorem 8 for every symmetric multilinear map, not only for polynomials. *)

Theorem multilinear_binomial (F : ringType) (V W : lmodType F) n
    (f : seq V -> W) (x y : V) (h : F) us m :
  symmetric n f -> multilinear n f -> (size us + m)%N = n ->
  f (us ++ nseq m (x + h *: y)) =
    \sum_(k < m.+1)
      (h ^+ k *: f (us ++ nseq (m - k) x ++ nseq k y)) *+ 'C(m, k).
Proof.
move=> sym_f lin_f; elim: m us => [|m IHm] us size_us.
  by rewrite big_ord1 /= scale1r.
pose T k := h ^+ k *: f (us ++ nseq (m.+1 - k) x ++ nseq k y).
rewrite (pascal_sum T) /=.
have -> : x + h *: y = 1 *: x + h *: y by rewrite scale1r.
rewrite lin_f ?size_nseq; last by rewrite -addnS.
rewrite !scale1r -!cat_rcons !IHm ?size_rcons ?addSnnS // /T.
congr (_ + _); last rewrite scaler_sumr; apply: eq_bigr => k _.
  rewrite subSn -1?ltnS //; congr (_ *: f _ *+ _).
  by rewrite cat_rcons.
rewrite -scalerMnr scalerA -exprS subSS; congr (_ *: _ *+ _).
apply: sym_f; last by rewrite cat_rcons perm_cat2l /= -cat1s perm_catCA.
rewrite cat_rcons size_cat /= size_cat !size_nseq subnK -1?ltnS //.
Qed.
