(******************************************************************************)
(* Two certificates written out with numerals, and one with a wrong digit.    *)
(*                                                                            *)
(* Notions: certificate.v. The polynomial is P = 1 + 2 t + 4 t^2 - t^3, read  *)
(* with degree 3. The first certificate states p[1/2, -2/3, 5] = 13/3, the    *)
(* second, with a vector in place of the last point, p[1/2, -2/3, delta] = 7/9.*)
(* The rational numbers stand in comments beside the integers; only the       *)
(* integers count. Each theorem is checked by computation, and one changed    *)
(* digit makes Coq refuse it.                                                 *)
(*                                                                            *)
(* Statements: derose-ex-1-2-4-1, goldman-ex1-cubic.                          *)
(******************************************************************************)
From Coq Require Import ZArith.
From mathcomp Require Import all_ssreflect all_algebra.
From Blossom Require Import notions certificate.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Delimit Scope Z_scope with integer.

Definition three_points : certificate := Certificate 3
  [:: 1; 2; 4; -1]%integer 1%integer               (* 1, 2, 4, -1 over 1 *)
  [:: ((1, 2), 2);                           (* 1/2 *)
      ((-2, 3), 3);                          (* -2/3 *)
      ((5, 1), 1)]%integer                      (* 5 *)
  1%integer 13%integer 3%integer.                      (* 13/3 *)

Theorem three_points_value (F : fieldType) : [char F]%R =i pred0 ->
  holds F three_points.
Proof.
have ok : check three_points by vm_compute.
by move=> char0; apply: (check_sound char0 ok).
Qed.

Definition with_vector : certificate := Certificate 3
  [:: 1; 2; 4; -1]%integer 1%integer               (* 1, 2, 4, -1 over 1 *)
  [:: ((1, 2), 2);                           (* 1/2 *)
      ((-2, 3), 3);                          (* -2/3 *)
      ((1, 0), 1)]%integer                      (* delta *)
  1%integer 7%integer 9%integer.                      (* 7/9 *)

Theorem with_vector_value (F : fieldType) : [char F]%R =i pred0 ->
  holds F with_vector.
Proof.
have ok : check with_vector by vm_compute.
by move=> char0; apply: (check_sound char0 ok).
Qed.

(** A wrong digit is refused. *)

Theorem wrong_digit_refused :
  check (Certificate 3 [:: 1; 2; 4; -1]%integer 1%integer
           [:: ((1, 2), 2); ((-2, 3), 3); ((5, 1), 1)]%integer
           1%integer 14%integer 3%integer) = false.
Proof. by vm_compute. Qed.
