(******************************************************************************)
(* Tensor products: blossoms of polynomials in two variables, one at a time.  *)
(*                                                                            *)
(*   m, n                  == the formal degrees in x and in y                *)
(*   c i j                 == the coefficient of x^i y^j                      *)
(*   tensor_value m n c x y == P(x, y), the sum of c_ij x^i y^j               *)
(*   tensor m n c us vs    == the blossom in the first variable of the        *)
(*                            polynomial whose coefficients are blossoms in   *)
(*                            the second                                      *)
(*   is_tensor_blossom m n c f == f us vs is symmetric and affine in the m    *)
(*                            numbers us and in the n numbers vs, with P on   *)
(*                            the diagonal                                    *)
(*   control_net i j       == tensor at m - i copies of a and i of b, n - j   *)
(*                            copies of a', j of b'                           *)
(*                                                                            *)
(* A tensor-product blossom is a blossom of blossoms; either variable may     *)
(* come first. So every result on curves holds in each variable alone:        *)
(* uniqueness, polarization, Bezier nets, de Casteljau, degree elevation.     *)
(*                                                                            *)
(* Statements: derose-tensor-def, derose-tensor-props, derose-tensor-asym,    *)
(* derose-tensor-allresults, fj-eq9, fj-tensor-matrix, fj-tensor-inverse.     *)
(******************************************************************************)
From mathcomp Require Import all_ssreflect all_algebra.
From Blossom Require Import notions existence polarization uniqueness casteljau.
From Blossom Require Import polarization_grouped three_constructions elevation.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Section Tensor.
Variables (F : fieldType) (m n : nat) (c : nat -> nat -> F).
Implicit Types (us vs : seq F) (f g : seq F -> seq F -> F).
Hypotheses (m_unit : m`!%:R != 0 :> F) (n_unit : n`!%:R != 0 :> F).

Definition column (i : nat) : {poly F} := \poly_(j < n.+1) c i j.
Definition row (j : nat) : {poly F} := \poly_(i < m.+1) c i j.

Definition tensor (us vs : seq F) : F :=
  blossom m (\poly_(i < m.+1) blossom n (column i) vs) us.

Definition tensor_value (x y : F) : F :=
  \sum_(i < m.+1) \sum_(j < n.+1) c i j * x ^+ i * y ^+ j.

Lemma blossom_poly k (a : nat -> F) us :
  blossom k (\poly_(i < k.+1) a i) us =
    \sum_(i < k.+1) a i * (factors [seq point u | u <- us])`_i / 'C(k, i)%:R.
Proof.
by apply: eq_bigr => i _; rewrite coef_poly ltn_ord.
Qed.

(** The tensor blossom: symmetric and affine in the us, in the vs, and with
    the polynomial on the diagonal. *)

Theorem tensor_symmetric us us' vs vs' :
  perm_eq us us' -> perm_eq vs vs' -> tensor us vs = tensor us' vs'.
Proof.
move=> eq_us eq_vs; rewrite /tensor (blossom_perm _ _ eq_us) !blossom_poly.
by apply: eq_bigr => i _; rewrite (blossom_perm _ _ eq_vs).
Qed.

Theorem tensor_affine_first us us' x y a vs :
  tensor (us ++ ((1 - a) * x + a * y) :: us') vs =
    (1 - a) * tensor (us ++ x :: us') vs + a * tensor (us ++ y :: us') vs.
Proof. by rewrite /tensor blossom_combination ?subrK. Qed.

Theorem tensor_exchange us vs :
  tensor us vs = blossom n (\poly_(j < n.+1) blossom m (row j) us) vs.
Proof.
rewrite /tensor !blossom_poly.
under eq_bigr do rewrite blossom_poly !big_distrl /=.
under [RHS]eq_bigr do rewrite blossom_poly !big_distrl /=.
rewrite exchange_big; apply: eq_bigr => j _; apply: eq_bigr => i _ /=.
rewrite -!mulrA; congr (_ * _).
by rewrite [RHS]mulrA [RHS]mulrC -mulrA.
Qed.

Theorem tensor_affine_second us vs vs' x y a :
  tensor us (vs ++ ((1 - a) * x + a * y) :: vs') =
    (1 - a) * tensor us (vs ++ x :: vs') + a * tensor us (vs ++ y :: vs').
Proof. by rewrite !tensor_exchange blossom_combination ?subrK. Qed.

Theorem tensor_diagonal x y : tensor (nseq m x) (nseq n y) = tensor_value x y.
Proof.
rewrite /tensor blossom_diagonal ?size_poly // horner_poly.
apply: eq_bigr => i _; rewrite blossom_diagonal ?size_poly // horner_poly.
by rewrite big_distrl; apply: eq_bigr => j _; rewrite /= mulrAC.
Qed.

(** Existence and uniqueness. *)

Definition is_tensor_blossom f : Prop :=
  [/\ forall vs, symmetric m (f^~ vs),
      forall vs, multiaffine m (f^~ vs : seq F^o -> F^o),
      forall us, symmetric n (f us),
      forall us, multiaffine n (f us : seq F^o -> F^o)
    & forall x y, f (nseq m x) (nseq n y) = tensor_value x y].

Theorem tensor_exists : is_tensor_blossom tensor.
Proof.
split=> [vs us us' _ | vs us us' x y a _ | us vs vs' _ | us vs vs' x y a _ | x y].
- by move=> eq_us; apply: tensor_symmetric.
- exact: tensor_affine_first.
- by move=> eq_vs; apply: tensor_symmetric.
- exact: tensor_affine_second.
- exact: tensor_diagonal.
Qed.

Theorem tensor_unique f us vs : is_tensor_blossom f ->
  size us = m -> size vs = n -> f us vs = tensor us vs.
Proof.
case=> sym1 aff1 sym2 aff2 diag size_us size_vs.
have [sym1' aff1' sym2' aff2' diag'] := tensor_exists.
have unique k (g h : seq F -> F) : k`!%:R != 0 :> F ->
    symmetric k g -> multiaffine k (g : seq F^o -> F^o) ->
    symmetric k h -> multiaffine k (h : seq F^o -> F^o) ->
    (forall t, g (nseq k t) = h (nseq k t)) -> forall xs, size xs = k -> g xs = h xs.
  exact: (@multiaffine_unique F [lmodType F of F^o] [lmodType F of F^o]).
apply: (unique n) => // y.
by apply: (unique m (f^~ (nseq n y)) (tensor^~ (nseq n y))) => // x; rewrite diag diag'.
Qed.

(** The inverse formula in two steps. *)

Lemma tensor_polynomial us y :
  tensor us (nseq n y) = blossom m (\poly_(i < m.+1) (column i).[y]) us.
Proof.
rewrite /tensor !blossom_poly; apply: eq_bigr => i _.
by rewrite blossom_diagonal ?size_poly.
Qed.

Theorem tensor_polarization us vs : (0 < m)%N -> (0 < n)%N ->
  size us = m -> size vs = n ->
  tensor us vs =
    m`!%:R^-1 * \sum_(1 <= M < m.+1)
      (-1) ^+ (m - M) * M%:R ^+ m * \sum_(S <- subsets M us)
        (n`!%:R^-1 * \sum_(1 <= N < n.+1)
          (-1) ^+ (n - N) * N%:R ^+ n * \sum_(T <- subsets N vs)
            tensor_value (arithmetic_mean S) (arithmetic_mean T)).
Proof.
move=> m_gt0 n_gt0 size_us size_vs.
rewrite {1}/tensor blossom_polarization ?size_poly //; congr (_ * _).
apply: eq_bigr => M _; congr (_ * _); apply: eq_bigr => S _.
have -> x : (\poly_(i < m.+1) blossom n (column i) vs).[x] = tensor (nseq m x) vs.
  by rewrite /tensor blossom_diagonal ?size_poly.
rewrite tensor_exchange blossom_polarization ?size_poly //; congr (_ * _).
apply: eq_bigr => N _; congr (_ * _); apply: eq_bigr => T _.
rewrite -tensor_diagonal tensor_exchange blossom_diagonal ?size_poly //.
Qed.

(** Bezier nets over a rectangle: every polynomial has one, and de Casteljau in
    one variable, then in the other, computes the blossom. *)

Section Net.
Variables (a b a' b' : F).
Hypotheses (ab : a != b) (ab' : a' != b').

Definition control_net i j : F :=
  tensor (nseq (m - i) a ++ nseq i b) (nseq (n - j) a' ++ nseq j b').

Theorem tensor_casteljau us vs : size us = m -> size vs = n ->
  casteljau a b
    (mkseq (fun i => casteljau a' b' (mkseq (control_net i) n.+1) vs) m.+1) us =
  tensor us vs.
Proof.
move=> size_us size_vs; rewrite /tensor -(casteljau_blossom _ ab size_us).
congr (casteljau a b _ us); apply: eq_map => i.
rewrite /control_point -/(tensor _ vs) tensor_exchange.
rewrite -(casteljau_blossom _ ab' size_vs); congr (casteljau a' b' _ vs).
by apply: eq_map => j; rewrite /control_net tensor_exchange.
Qed.

Theorem tensor_bezier x y :
  tensor_value x y =
    \sum_(i < m.+1) \sum_(j < n.+1)
      control_net i j * bernstein m i (fraction a b x)
                      * bernstein n j (fraction a' b' y).
Proof.
have curve k (P : {poly F}) l r t : k`!%:R != 0 :> F -> l != r ->
    (size P <= k.+1)%N ->
    P.[t] = \sum_(i < k.+1) control_point k P l r i * bernstein k i (fraction l r t).
  move=> k_unit lr P_deg; rewrite (every_polynomial_is_bezier t k_unit P_deg lr).
  rewrite /bezier size_mkseq; apply: eq_bigr => i _.
  by rewrite nth_mkseq.
rewrite -tensor_diagonal {1}/tensor blossom_diagonal ?size_poly //.
rewrite (curve m _ a b) ?size_poly //; apply: eq_bigr => i _.
rewrite /control_point -/(tensor _ _) tensor_exchange.
rewrite blossom_diagonal ?size_poly // (curve n _ a' b') ?size_poly // big_distrl.
apply: eq_bigr => j _ /=; rewrite mulrAC; congr (_ * _ * _).
by rewrite /control_net tensor_exchange.
Qed.

End Net.

End Tensor.

(** Degree elevation in the first variable; by tensor_exchange, in either. *)

Theorem tensor_elevation (F : fieldType) m n (c : nat -> nat -> F) us vs :
  m.+1`!%:R != 0 :> F -> (forall j, c m.+1 j = 0) -> size us = m.+1 ->
  tensor m.+1 n c us vs =
    (\sum_(i < m.+1) tensor m n c (omit i us) vs) / m.+1%:R.
Proof.
move=> Sm_unit top size_us; rewrite /tensor -elevation ?size_poly //.
congr (blossom _ _ _); apply/polyP => k; rewrite !coef_poly.
case: (ltngtP k m.+1) => [lt_k | lt_k | ->].
- by rewrite ltnS ltnW.
- by rewrite ltnS leqNgt lt_k.
rewrite ltnSn /blossom /hblossom /functional big1 // => i _.
by rewrite coef_poly top if_same !mul0r.
Qed.

(** The two groups of arguments may not be mixed: for P(x, y) = x. *)

Theorem tensor_asymmetric (F : fieldType) :
  ~ (forall (c : nat -> nat -> F) u v,
       tensor 1 1 c [:: u] [:: v] = tensor 1 1 c [:: v] [:: u]).
Proof.
pose c i j : F := ((i == 1) && (j == 0))%N%:R.
have value u v : tensor 1 1 c [:: u] [:: v] = u.
  rewrite (@tensor_diagonal F 1 1 c _ _ u v) ?oner_neq0 // /tensor_value /c.
  by rewrite !big_ord_recr !big_ord0 /= !mul0r !add0r addr0 expr1 expr0 mulr1 mul1r.
by move=> /(_ c 1 0)/eqP; rewrite !value oner_eq0.
Qed.
