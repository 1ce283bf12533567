(******************************************************************************)
(* Certificates: values of a blossom checked by computation with integers.    *)
(*                                                                            *)
(* A certificate states one value of a homogeneous blossom over the rational  *)
(* numbers in integers alone, each with its denominator:                      *)
(*                                                                            *)
(*   degree                == the formal degree n                             *)
(*   coefficients, scale   == integers p_0 ... p_n and D: P_k = p_k / D       *)
(*   arguments             == triples (u,v,w): the pair (u/w, v/w); a point   *)
(*                            x = u/w is (u,w,w), a vector is (u,0,w)         *)
(*   numerator, denominator == the claimed value of this many times the       *)
(*   multiple                 blossom; 1 for a value, n!/(n-k)! for the k-th  *)
(*                            derivative                                      *)
(*   check c               == the test: with e_k the coefficient of X^k in    *)
(*                            the product of the v + u X,                     *)
(*             denominator * multiple * sum over k of p_k k! (n-k)! e_k       *)
(*                     = numerator * n! * D * (product of the w),             *)
(*                            the lengths are right and no denominator is 0   *)
(*   value_of c            == the claimed value, in the field F               *)
(*   holds c               == what the certificate says, in the field F       *)
(*   Z_to_F                == an integer as an element of F                   *)
(*                                                                            *)
(* No division and no greatest common divisor occurs: the binomials are       *)
(* cleared by C(n,k) k! (n-k)! = n!, the denominators of the arguments by     *)
(* homogeneity. The check runs on the binary integers of Coq, without axioms; *)
(* its soundness holds over every field of characteristic 0.                  *)
(******************************************************************************)
From Coq Require Import ZArith Lia.
From mathcomp Require Import all_ssreflect all_algebra.
From Blossom Require Import notions existence.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Import GRing.Theory.
Local Open Scope ring_scope.

Record certificate := Certificate {
  degree : nat;
  coefficients : seq Z;
  scale : Z;
  arguments : seq (Z * Z * Z);
  multiple : Z;
  numerator : Z;
  denominator : Z
}.

Fixpoint times_factor (u v previous : Z) (e : seq Z) : seq Z :=
  if e is c :: e' then
    Z.add (Z.mul v c) (Z.mul u previous) :: times_factor u v c e'
  else [:: Z.mul u previous].

Definition product_coefficients (args : seq (Z * Z * Z)) : seq Z :=
  foldr (fun a => times_factor a.1.1 a.1.2 Z0) [:: (Zpos xH)] args.

Definition of_nat (m : nat) : Z := Z.of_nat m.

Fixpoint big_factorial (m : nat) : Z :=
  if m is m'.+1 then Z.mul (of_nat m) (big_factorial m') else (Zpos xH).

Fixpoint weighted_sum (n k : nat) (p e : seq Z) : Z :=
  match p, e with
  | a :: p', b :: e' =>
      Z.add (Z.mul (Z.mul (big_factorial k) (big_factorial (n - k)))
                         (Z.mul a b))
               (weighted_sum n k.+1 p' e')
  | _, _ => Z0
  end.

Definition product_of (s : seq Z) : Z := foldr Z.mul (Zpos xH) s.

Definition nonzero (z : Z) : bool := ~~ Z.eqb z Z0.

Definition check (c : certificate) : bool :=
  let n := degree c in
  [&& size (coefficients c) == n.+1, size (arguments c) == n,
      nonzero (scale c), nonzero (denominator c),
      all (fun a => nonzero a.2) (arguments c)
    & Z.eqb
        (Z.mul (denominator c)
          (Z.mul (multiple c)
            (weighted_sum n 0 (coefficients c)
               (product_coefficients (arguments c)))))
        (Z.mul (numerator c)
          (Z.mul (big_factorial n)
            (Z.mul (scale c) (product_of [seq a.2 | a <- arguments c]))))].

Section Soundness.
Variable F : fieldType.
Hypothesis char0 : [char F] =i pred0.

Definition Z_to_F (z : Z) : F := (Z.to_nat z)%:R - (Z.to_nat (- z))%:R.
Local Notation phi := Z_to_F.

Definition polynomial_of (c : certificate) : {poly F} :=
  Poly [seq phi a / phi (scale c) | a <- coefficients c].

Definition pairs_of (c : certificate) : seq (F * F) :=
  [seq (phi a.1.1 / phi a.2, phi a.1.2 / phi a.2) | a <- arguments c].

Definition value_of (c : certificate) : F :=
  phi (numerator c) / phi (denominator c).

Definition holds (c : certificate) : Prop :=
  phi (multiple c) * hblossom (degree c) (polynomial_of c) (pairs_of c) =
    value_of c.

(** Integers go to F as a ring. *)

Lemma Z_to_FD a b : Z_to_F (a + b) = Z_to_F a + Z_to_F b.
Proof.
rewrite /Z_to_F addrACA -opprD -!natrD; apply/eqP.
rewrite subr_eq addrAC eq_sym subr_eq -!natrD; apply/eqP; congr (_%:R).
rewrite -!plusE; lia.
Qed.

Lemma Z_to_FN a : Z_to_F (- a) = - Z_to_F a.
Proof. by rewrite /Z_to_F Z.opp_involutive opprB. Qed.

Lemma Z_to_F_nat m : Z_to_F (Z.of_nat m) = m%:R.
Proof.
rewrite /Z_to_F Nat2Z.id (_ : Z.to_nat _ = 0%N) ?subr0 //; lia.
Qed.

Lemma Z_to_FM a b : Z_to_F (a * b) = Z_to_F a * Z_to_F b.
Proof.
have sign z : exists m, z = Z.of_nat m \/ z = Z.opp (Z.of_nat m).
  by exists (Z.to_nat (Z.abs z)); lia.
have [m [->|->]] := sign a; have [k [->|->]] := sign b;
  rewrite ?Z.mul_opp_l ?Z.mul_opp_r ?Z_to_FN -?Nat2Z.inj_mul !Z_to_F_nat;
  by rewrite ?mulNr ?mulrN -natrM.
Qed.

Lemma phiD x y : phi (Z.add x y) = phi x + phi y.
Proof. exact: Z_to_FD. Qed.

Lemma phiM x y : phi (Z.mul x y) = phi x * phi y.
Proof. exact: Z_to_FM. Qed.

Lemma phi0 : phi Z0 = 0.
Proof. by rewrite /Z_to_F subrr. Qed.

Lemma phi1 : phi (Zpos xH) = 1.
Proof. exact: (Z_to_F_nat 1). Qed.

Lemma phi_nat m : phi (of_nat m) = m%:R.
Proof. exact: Z_to_F_nat. Qed.

Lemma phi_factorial m : phi (big_factorial m) = m`!%:R.
Proof.
elim: m => [|m IHm]; first exact: phi1.
rewrite -[big_factorial _]/(Z.mul (of_nat m.+1) (big_factorial m)).
by rewrite phiM phi_nat IHm factS natrM.
Qed.

Lemma phi_eqb x y : Z.eqb x y -> phi x = phi y.
Proof. by move/Z.eqb_eq->. Qed.

Lemma phi_nonzero z : nonzero z -> phi z != 0.
Proof.
move=> nz; have ne : z <> Z0.
  by move=> z0; move: nz; rewrite z0.
have nat_eq0 m : (m%:R == 0 :> F) = (m == 0)%N by move/charf0P: char0 => ->.
have [pos | neg] : Z.lt Z0 (z) \/ Z.lt (z) Z0 by lia.
  rewrite /Z_to_F (_ : Z.to_nat (- _) = 0%N) ?subr0 ?nat_eq0; last lia.
  by apply/eqP; lia.
rewrite /Z_to_F (_ : Z.to_nat (z) = 0%N) ?sub0r; last lia.
by rewrite oppr_eq0 nat_eq0; apply/eqP; lia.
Qed.

(** The coefficients of the product of the factors. *)

Lemma times_factorP u v previous e k :
  (map phi (times_factor u v previous e))`_k =
    phi v * (map phi e)`_k
      + phi u * (if k is k'.+1 then (map phi e)`_k' else phi previous).
Proof.
elim: e previous k => [|c e IHe] previous [|k] /=; rewrite ?phiD ?phiM ?mulr0.
- by rewrite add0r.
- by rewrite !nth_nil mulr0 add0r.
- by [].
- by rewrite IHe; case: k.
Qed.

Lemma product_coefficientsP args k :
  (map phi (product_coefficients args))`_k =
    (factors [seq (phi a.1.1, phi a.1.2) | a <- args])`_k.
Proof.
elim: args k => [|a args IHargs] k /=.
  by rewrite factors_nil coef1 phi1; case: k => [|[|k]].
rewrite factors_cons mulrDl coefD coefCM -scalerAl coefZ coefXM times_factorP /=.
by rewrite IHargs; case: k => [|k] /=; rewrite ?phi0 // IHargs.
Qed.

Lemma weighted_sumP n k p e : size p = (n.+1 - k)%N -> size e = size p ->
  phi (weighted_sum n k p e) =
    \sum_(i < size p) (k + i)`!%:R * (n - (k + i))`!%:R
      * ((map phi p)`_i * (map phi e)`_i).
Proof.
elim: p k e => [|a p IHp] k [|b e] //= size_p; first by rewrite big_ord0 phi0.
case=> size_e; rewrite phiD !phiM !phi_factorial big_ord_recl /= addn0.
congr (_ + _); rewrite IHp //; last by rewrite subnS -size_p.
by apply: eq_bigr => i _; rewrite /bump /= add1n addSnnS.
Qed.

Lemma factors_scale args : all (fun a : Z * Z * Z => nonzero a.2) args ->
  factors [seq (phi a.1.1, phi a.1.2) | a <- args] =
    phi (product_of [seq a.2 | a <- args]) *:
      factors [seq (phi a.1.1 / phi a.2, phi a.1.2 / phi a.2) | a <- args].
Proof.
elim: args => [_|a args IHargs] /=; first by rewrite factors_nil phi1 scale1r.
case/andP=> /phi_nonzero a_nz /IHargs IH; rewrite !factors_cons IH phiM /=.
rewrite -scalerAr [phi a.2 * _]mulrC -[RHS]scalerA [in RHS]scalerAl.
congr (_ *: (_ * _)); rewrite scalerDr scalerA -[phi a.2 *: _%:P]mul_polyC -polyCM.
by rewrite ![phi a.2 * (_ / _)]mulrC !divfK.
Qed.

Lemma clear_denominators (C a b D w x y : F) : C != 0 -> D != 0 ->
  C * (a * b) * D * w * (x / D * y / C) = a * b * (x * (w * y)).
Proof.
move=> C_nz D_nz.
have [z ->] : exists z, x = z * D by exists (x / D); rewrite divfK.
have [q ->] : exists q, y = q * C by exists (y / C); rewrite divfK.
rewrite mulfK // [z * _]mulrA mulfK // -!mulrA [LHS]mulrC -!mulrA.
by congr (_ * (_ * _)); rewrite [w * (z * _)]mulrCA mulrCA.
Qed.

(** If the check succeeds, the stated value is the value of the blossom. *)

Theorem check_sound c : check c -> holds c.
Proof.
rewrite /holds; case/and5P=> /eqP size_p /eqP size_args /phi_nonzero D_nz /phi_nonzero den_nz.
case/andP=> args_nz /phi_eqb; rewrite !phiM phi_factorial.
set n := degree c in size_p size_args *.
have nat_eq0 m : (m%:R == 0 :> F) = (m == 0)%N by move/charf0P: char0 => ->.
have n_unit : n`!%:R != 0 :> F by rewrite nat_eq0 -lt0n fact_gt0.
have size_e : size (product_coefficients (arguments c)) = n.+1.
  rewrite -size_args /product_coefficients.
  have size_times u v z e : size (times_factor u v z e) = (size e).+1.
    by elim: e z => //= b e IHe z; rewrite IHe.
  by elim: (arguments c) => //= a args IHargs; rewrite size_times IHargs.
rewrite weighted_sumP ?size_p ?size_e // => equation.
rewrite /value_of; apply/eqP; rewrite -[X in X == _]divr1 eqr_div ?oner_neq0 //.
rewrite mulr1; apply/eqP.
have w_nz : phi (product_of [seq a.2 | a <- arguments c]) != 0.
  elim: (arguments c) args_nz => [_|a args IHargs] /=; first by rewrite phi1 oner_neq0.
  by case/andP=> /phi_nonzero a_nz /IHargs; rewrite phiM mulf_eq0 (negPf a_nz).
apply: (mulfI (mulf_neq0 (mulf_neq0 n_unit D_nz) w_nz)).
rewrite [RHS]mulrC -[in RHS]mulrA -equation [RHS]mulrC mulrA; congr (_ * _).
rewrite mulrCA; congr (_ * _).
rewrite /hblossom /functional big_distrr; apply: eq_bigr => k _ /=.
have le_k : (k <= n)%N by rewrite -ltnS.
have bin_nz : 'C(n, k)%:R != 0 :> F by apply: binomial_unit.
rewrite add0n product_coefficientsP factors_scale // coefZ -/(pairs_of c).
rewrite coef_Poly (nth_map Z0) ?size_p // (nth_map Z0) ?size_p //.
rewrite -{1}(bin_fact le_k) !natrM; exact: clear_denominators.
Qed.

End Soundness.
