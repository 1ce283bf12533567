(******************************************************************************)
(* Streams: certificates written as machine words, as the program writes them.*)
(*                                                                            *)
(* Notions: certificate.v. A machine integer is parsed many times faster than *)
(* a numeral of an integer of Coq, so the program writes a certificate as a   *)
(* list of words below 2^61, and Coq reads the integers from them:            *)
(*                                                                            *)
(*   read ws               == the integer at the front of the words ws, and   *)
(*                            the words after it: the word h is               *)
(*                            4 |x| + 2 [x < 0], for |x| < 2^58, or           *)
(*                            4 k + 2 [x < 0] + 1, and then |x| follows in k  *)
(*                            words of 60 bits, the lowest first              *)
(*   read_many k ws        == k integers                                      *)
(*   read_count ws         == a natural number, no more than there are words  *)
(*                            after it: what is counted follows               *)
(*   read_value, read_map  == a value of a map: its arguments, the multiple,  *)
(*                            the claim; a map: its degree, common            *)
(*                            denominator, coefficients, and all its values   *)
(*   certificates s        == all certificates of the stream s, a list of     *)
(*                            lists of words, and what words are left         *)
(*   check_stream s        == all certificates are right, no word is left     *)
(*   all_hold F cs         == what the certificates cs say, in the field F    *)
(*   certified s           == what the stream s says, for every field of      *)
(*                            characteristic 0                                *)
(*                                                                            *)
(* The computation itself is on the integers of Coq. Machine integers hold    *)
(* the words alone: the soundness theorem rests on no axiom about them, only  *)
(* on the primitive type and the operations that take its bits.               *)
(******************************************************************************)
From Coq Require Import ZArith Uint63.
From mathcomp Require Import all_ssreflect all_algebra.
From Blossom Require Import notions certificate.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition word := PrimInt63.int.
Definition words := seq word.

Fixpoint read_magnitude (k : Z) (ws : words) : Z * words :=
  if Z.leb k Z0 then (Z0, ws) else
  if ws is w :: ws' then
    let: (high, rest) := read_magnitude (Z.pred k) ws' in
    (Z.add (Uint63.to_Z w) (Z.shiftl high (Z.of_nat 60)), rest)
  else (Z0, ws).

Definition read (ws : words) : Z * words :=
  if ws is w :: ws' then
    let h := Uint63.to_Z w in
    let signed z := if Z.odd (Z.div2 h) then Z.opp z else z in
    let quarter := Z.div2 (Z.div2 h) in
    if Z.odd h then
      let: (z, rest) := read_magnitude quarter ws' in (signed z, rest)
    else (signed quarter, ws')
  else (Z0, [::]).

Fixpoint read_many (k : nat) (ws : words) : seq Z * words :=
  if k is k'.+1 then
    let: (z, ws') := read ws in
    let: (zs, rest) := read_many k' ws' in (z :: zs, rest)
  else ([::], ws).

Definition read_count (ws : words) : nat * words :=
  let: (z, rest) := read ws in
  (Z.to_nat (Z.min z (Z.of_nat (size rest))), rest).

Fixpoint triples (zs : seq Z) : seq (Z * Z * Z) :=
  if zs is u :: v :: w :: zs' then ((u, v), w) :: triples zs' else [::].

Definition read_value n p d (ws : words) : certificate * words :=
  let: (args, ws) := read_many (3 * n) ws in
  let: (m, ws) := read ws in
  let: (a, ws) := read ws in
  let: (b, rest) := read ws in (Certificate n p d (triples args) m a b, rest).

Fixpoint read_values (k : nat) n p d (ws : words) : seq certificate * words :=
  if k is k'.+1 then
    let: (c, ws) := read_value n p d ws in
    let: (cs, rest) := read_values k' n p d ws in (c :: cs, rest)
  else ([::], ws).

Definition read_map (ws : words) : seq certificate * words :=
  let: (n, ws) := read_count ws in
  let: (d, ws) := read ws in
  let: (p, ws) := read_many n.+1 ws in
  let: (k, ws) := read_count ws in read_values k n p d ws.

Fixpoint read_maps (k : nat) (ws : words) : seq certificate * words :=
  if k is k'.+1 then
    let: (cs, ws) := read_map ws in
    let: (cs', rest) := read_maps k' ws in (cs ++ cs', rest)
  else ([::], ws).

Definition certificates (s : seq words) : seq certificate * words :=
  let: (k, ws) := read_count (flatten s) in read_maps k ws.

Definition check_stream (s : seq words) : bool :=
  let: (cs, rest) := certificates s in nilp rest && all check cs.

Fixpoint all_hold (F : fieldType) (cs : seq certificate) : Prop :=
  if cs is c :: cs' then holds F c /\ all_hold F cs' else True.

Definition certified (s : seq words) : Prop :=
  forall F : fieldType, [char F]%R =i pred0 -> all_hold F (certificates s).1.

Theorem checked s : check_stream s = true -> certified s.
Proof.
rewrite /check_stream /certified; case: (certificates s) => cs rest /andP[_ ok].
move=> F char0 /=; elim: cs ok => //= c cs IHcs /andP[/(check_sound char0) c_holds ok].
by split=> //; apply: IHcs.
Qed.
