(******************************************************************************)
(* De Casteljau's algorithm with one argument per level.                      *)
(*                                                                            *)
(*   fraction a b u        == (u - a) / (b - a): where u lies between a and b *)
(*   step a b v u          == one level: the points (1 - s) v_j + s v_(j+1),  *)
(*                            with s = fraction a b u                         *)
(*   level a b v us        == the points after one level for each argument of *)
(*                            us, in this order                               *)
(*   casteljau a b v us    == the single point left after size v - 1 levels   *)
(*   control_point n P a b k == the blossom at n - k copies of a, k of b      *)
(*   control_points n P a b  == the list of these for k = 0, ..., n           *)
(*   bernstein n i s       == C(n,i) s^i (1-s)^(n-i)                          *)
(*   bezier a b v t        == sum of v_i times bernstein at fraction a b t    *)
(*                                                                            *)
(* Since the blossom is affine in each argument, an argument u between a and  *)
(* b gives (1-s) times the value with a for u plus s times the value with b;  *)
(* so each level replaces one a or b in the labels of the control points by   *)
(* the argument of the level, whatever it is, and after n levels all labels   *)
(* are arguments. Points with labels a^(n-k) b^k thus carry the blossom.      *)
(*                                                                            *)
(* Statements: derose-fig6, derose-fig6-comment, derose-fig6-dcj, derose-42-* *)
(* blog-blossom-recursion, blog-intermediate, blog-control-point, fj-eq1,     *)
(* fj-eq2, fj-corners, fj-diagonal, fj-symmetric, goldman-dual-functional,    *)
(* goldman-mult-notation, goldman-fig1-2, goldman-thm3, goldman-thm4,         *)
(* goldman-fig3.                                                              *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Blossom Require Import notions existence.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section Algorithm.
Variables (F : fieldType) (a b : F).
Implicit Types (us v : seq F).

Definition fraction (u : F) : F := (u - a) / (b - a).

Definition step v u : seq F :=
  [seq (1 - fraction u) * x.1 + fraction u * x.2 | x <- zip v (behead v)].

Definition level v us : seq F := foldl step v us.

Definition casteljau v us : F := head 0 (level v us).

End Algorithm.

Section Bezier.
Variable F : fieldType.
Implicit Types (P : {poly F}) (us v : seq F) (a b t : F).

Definition control_point n P a b k := blossom n P (nseq (n - k) a ++ nseq k b).

Definition control_points n P a b := mkseq (control_point n P a b) n.+1.

Definition bernstein n i (s : F) : F := s ^+ i * (1 - s) ^+ (n - i) *+ 'C(n, i).

Definition bezier a b v t : F :=
  \sum_(i < size v) v`_i * bernstein (size v).-1 i (fraction a b t).

(** An argument is a combination of a and b. *)

Lemma between a b u : a != b ->
  u = (1 - fraction a b u) * a + fraction a b u * b.
Proof.
move=> ab; rewrite mulrBl mul1r -addrA [- _ + _]addrC -mulrBr divfK.
  by rewrite addrC subrK.
by rewrite subr_eq0 eq_sym.
Qed.

Theorem blossom_between n P a b us u vs : a != b ->
  blossom n P (us ++ u :: vs) =
    (1 - fraction a b u) * blossom n P (us ++ a :: vs)
      + fraction a b u * blossom n P (us ++ b :: vs).
Proof.
by move=> ab; rewrite {1}(between u ab) blossom_combination // subrK.
Qed.

(** Every node is the blossom value that its label says. *)

Lemma step_mkseq a b (g : nat -> F) m u :
  step a b (mkseq g m.+1) u =
    mkseq (fun j => (1 - fraction a b u) * g j + fraction a b u * g j.+1) m.
Proof.
have size_zipped : size (zip (mkseq g m.+1) (behead (mkseq g m.+1))) = m.
  by rewrite size_zip size_behead !size_mkseq minnE subKn.
apply: (@eq_from_nth _ 0); rewrite size_map size_zipped ?size_mkseq // => j lt_j.
rewrite (nth_map (0, 0)) ?size_zipped // nth_zip_cond size_zipped lt_j.
by rewrite nth_behead !nth_mkseq // ltnW.
Qed.

Theorem casteljau_nodes n P a b us m : a != b -> (size us + m)%N = n ->
  level a b (control_points n P a b) us =
    mkseq (fun j => blossom n P (us ++ nseq (m - j) a ++ nseq j b)) m.+1.
Proof.
move=> ab; elim/last_ind: us m => [|us u IHus] m; first by move=> <-.
rewrite size_rcons addSnnS => size_us; rewrite /level foldl_rcons.
rewrite -/(level _ _ _ _) (IHus _ size_us) step_mkseq.
apply: (@eq_from_nth _ 0); rewrite !size_mkseq // => j lt_jm.
rewrite !nth_mkseq // cat_rcons (blossom_between _ _ _ _ _ ab) subSS subSn //.
congr (_ * _ + _ * _); apply: blossom_perm; rewrite perm_cat2l /=.
by rewrite -cat1s perm_catCA.
Qed.

(** After n levels there is one point: the blossom at the arguments. *)

Theorem casteljau_blossom n P a b us : a != b -> size us = n ->
  casteljau a b (control_points n P a b) us = blossom n P us.
Proof.
move=> ab size_us; rewrite /casteljau (@casteljau_nodes n P a b us 0) ?addn0 //.
by rewrite /= cats0.
Qed.

(** The order of the arguments does not matter, for any points at the start. *)

Lemma size_step a b v u : size (step a b v u) = (size v).-1.
Proof. by rewrite size_map size_zip size_behead minnE subKn // leq_pred. Qed.

Lemma step_commute a b v u w :
  step a b (step a b v u) w = step a b (step a b v w) u.
Proof.
case: v => [|x [|y v]] //; set v' := [:: x, y & v].
have -> : v' = mkseq (nth 0 v') (size v).+2 by apply/esym/mkseq_nth.
rewrite !step_mkseq; apply: eq_map => j.
move: (fraction a b u) (fraction a b w) => r s.
rewrite !mulrDr !mulrA [RHS]addrACA.
by congr (_ * _ + _ * _ + (_ * _ + _ * _)); rewrite mulrC.
Qed.

Lemma level_step a b v u us :
  level a b (step a b v u) us = step a b (level a b v us) u.
Proof. by elim: us v => //= w us IHus v; rewrite -IHus step_commute. Qed.

Theorem level_perm a b v us vs : perm_eq us vs ->
  level a b v us = level a b v vs.
Proof.
elim: us v vs => [|u us IHus] v vs; first by move/perm_size/esym/size0nil->.
move=> eq_us; have: u \in vs by rewrite -(perm_mem eq_us) mem_head.
move=> u_in; case/splitPr: u_in eq_us => vs1 vs2 eq_us.
rewrite /= (IHus _ (vs1 ++ vs2)) /level ?foldl_cat /=; last first.
  by move: eq_us; rewrite perm_sym perm_catC cat_cons perm_cons perm_catC perm_sym.
by rewrite -!/(level _ _ _ _) level_step.
Qed.

(** For any points at the start the result is affine in each argument, and at
    n - k copies of a and k copies of b it is the point number k. *)

Lemma nth_step a b v u j : (j.+1 < size v)%N ->
  (step a b v u)`_j = (1 - fraction a b u) * v`_j + fraction a b u * v`_j.+1.
Proof.
case size_v: (size v) => [|m] // lt_j.
have -> : v = mkseq (nth 0 v) m.+1 by rewrite -size_v mkseq_nth.
by rewrite step_mkseq !nth_mkseq // ltnW.
Qed.

Lemma size_level a b v us : size (level a b v us) = (size v - size us)%N.
Proof.
elim: us v => [|u us IHus] v; first by rewrite subn0.
by rewrite /= IHus size_step -subn1 -subnDA.
Qed.

Lemma fraction_affine a b c x y :
  fraction a b ((1 - c) * x + c * y) =
    (1 - c) * fraction a b x + c * fraction a b y.
Proof.
rewrite /fraction !mulrA -mulrDl !mulrBr addrACA; congr (_ / _).
by rewrite -opprD -mulrDl subrK mul1r.
Qed.

Theorem casteljau_affine a b v us vs c x y :
  casteljau a b v (us ++ ((1 - c) * x + c * y) :: vs) =
    (1 - c) * casteljau a b v (us ++ x :: vs)
      + c * casteljau a b v (us ++ y :: vs).
Proof.
have last_level u : level a b v (us ++ u :: vs) = step a b (level a b v (us ++ vs)) u.
  rewrite -level_step -[RHS]/(level a b v (u :: us ++ vs)); apply: level_perm.
  by rewrite -[u :: vs]cat1s -[u :: us ++ vs]cat1s perm_catCA.
rewrite /casteljau !last_level -!nth0; set w := level _ _ _ _.
case: (ltnP 1 (size w)) => [w_gt1 | w_le1]; last first.
  by rewrite !nth_default ?size_step ?mulr0 ?addr0 // -subn1 leq_subLR.
rewrite !nth_step // fraction_affine.
move: (fraction a b x) (fraction a b y) w`_0 w`_1 => r s p q.
have flip z : (1 - z) * p + z * q = p + z * (q - p).
  by rewrite mulrBl mul1r mulrBr -addrA [- _ + _]addrC.
rewrite !flip; move: (q - p) => d.
by rewrite mulrDl !mulrDr !mulrA [RHS]addrACA -[in RHS]mulrDl subrK mul1r.
Qed.

Theorem casteljau_corner a b v n k : a != b -> size v = n.+1 -> (k <= n)%N ->
  casteljau a b v (nseq (n - k) a ++ nseq k b) = v`_k.
Proof.
move=> ab size_v le_kn; rewrite /casteljau (level_perm _ _ _ (permEl (perm_catC _ _))).
have fr_a : fraction a b a = 0 by rewrite /fraction subrr mul0r.
have fr_b : fraction a b b = 1 by rewrite /fraction mulfV // subr_eq0 eq_sym.
have level_b m j : (j + m < size v)%N -> (level a b v (nseq m b))`_j = v`_(j + m).
  elim: m j => [|m IHm] j lt_j; first by rewrite addn0.
  rewrite /= level_step nth_step ?fr_b ?subrr ?mul0r ?add0r ?mul1r.
    by rewrite IHm addSnnS.
  by rewrite size_level size_nseq ltn_subRL addnC addSnnS.
have level_a m w : (m < size w)%N -> (level a b w (nseq m a))`_0 = w`_0.
  elim: m => // m IHm lt_m; rewrite /= level_step nth_step ?fr_a.
    by rewrite subr0 mul1r mul0r addr0 IHm // ltnW.
  by rewrite size_level size_nseq ltn_subRL addn1.
rewrite -nth0 /level foldl_cat -!/(level _ _ _ _) level_a ?level_b ?size_v //.
by rewrite size_level size_v size_nseq subSn.
Qed.

(** The Bernstein form. *)

Theorem blossom_bernstein n P a b m t us : a != b ->
  blossom n P (us ++ nseq m t) =
    \sum_(i < m.+1) bernstein m i (fraction a b t)
      * blossom n P (us ++ nseq (m - i) a ++ nseq i b).
Proof.
move=> ab; set s := fraction a b t.
have split_t : 1 + t *: 'X = (1 - s) *: (1 + a *: 'X) + s *: (1 + b *: 'X).
  rewrite !scalerDr addrACA -scalerDl subrK scale1r !scalerA -scalerDl.
  by rewrite -between.
rewrite /blossom /hblossom map_cat map_nseq factors_cat factors_nseq /=.
rewrite polyC1 split_t exprDn big_distrr functional_sum; apply: eq_bigr => i _.
rewrite !map_cat !map_nseq !factors_cat !factors_nseq /= polyC1 !exprZn.
rewrite -scaler_nat -scalerAl -!scalerAr !scalerA functionalZ mulr_natl.
by rewrite /bernstein -mulrnAr [s ^+ i * _]mulrC.
Qed.

Theorem bezier_blossom n P a b t : a != b ->
  bezier a b (control_points n P a b) t = blossom n P (nseq n t).
Proof.
move=> ab; rewrite -[nseq n t]cat0s (blossom_bernstein _ _ _ _ _ ab).
rewrite /bezier size_mkseq; apply: eq_bigr => i _.
by rewrite nth_mkseq // mulrC.
Qed.

(** Theorem 3 of Goldman: every polynomial is a Bezier curve over [a, b]. *)

Theorem every_polynomial_is_bezier n P a b t :
  n`!%:R != 0 :> F -> (size P <= n.+1)%N -> a != b ->
  P.[t] = bezier a b (control_points n P a b) t.
Proof.
by move=> n_unit P_deg ab; rewrite bezier_blossom // blossom_diagonal.
Qed.

End Bezier.
