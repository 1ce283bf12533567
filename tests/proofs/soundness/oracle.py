#!/usr/bin/env python3
"""An oracle for the identity language: both sides of every claim at random points of a large prime field.

It shares nothing with the prover: it has its own reader (language.py), scopes (names.py) and kinds (kinds.py), and values instead of
expansion (values.py). A claim that holds at random points is true (by Schwartz and Zippel, with an error far below 2^-50), one
that fails has a witness. Hypotheses (hypotheses.py) are satisfied by solving for quantities that are linear in them (map
coefficients, numbers, coordinates), in several orders to reach different components, and for one unknown of degree 2 by a square root.

    decide(block)  ->  a Decision with one Line for each claim and refute

As a program: `oracle.py FILE ...` prints the truth of each line of these files; `oracle.py prove FILE --json` prints it as the prover would.
"""

import json
import random
import sys
import time

import field
from faults import Err, TooBig, ZeroDivisor
from field import FIELDS, PRIME
from hypotheses import Hypotheses
from language import HYPOTHESES, STATEMENTS, parse_text
from names import Scope
from values import Case, difference, parameter_cases, range_cases


class Line:
    """The truth of one claim or refute."""

    def __init__(self, place, kind):
        self.place = place
        self.kind = kind
        self.cases = []  # (params, ranges, status, reason)
        self.witnesses = []  # (case, env, sample)

    def statuses(self):
        return {c[2] for c in self.cases}

    def reasons(self):
        return sorted({c[3] for c in self.cases if c[3]})


class Decision:
    def __init__(self):
        self.lines = []
        self.error = None  # an error of the whole block
        self.points = 0
        self.free = set()  # undeclared names
        self.seen = set()  # the corner cases that occurred


def decide(block, points=4, seed=0, budget=400000, max_cases=4000):
    """The truth of every claim of a block: statuses true, false, error, novalue (no point was found), toobig."""
    out = Decision()
    out.lines = [Line(block.places[at], line[0]) for at, line in block.statements()]
    field.choose(PRIME)
    if block.fault is not None:
        out.error = Err("syntax", str(block.fault))
        return out
    try:
        scope = Scope(block)
        choices = parameter_cases(block, scope)
        if len(choices) > max_cases:
            raise TooBig()
        total = 0
        for params in choices:
            for p in FIELDS:
                field.choose(p)
                total += decide_case(block, scope, params, out, points, seed, budget)
                if total > max_cases:
                    raise TooBig()
                # cases without a point in one field are tried in the next
                if p == FIELDS[-1] or not any(c[0] is params and c[2] == "novalue" for l in out.lines for c in l.cases):
                    break
                if not any(l[0] == "given" for l in block.lines):
                    break
                for l in out.lines:
                    l.cases = [c for c in l.cases if c[0] is not params]
                    l.witnesses = [w for w in l.witnesses if w[0].params is not params]
            field.choose(PRIME)
    except Err as e:
        out.error = e
    except TooBig:
        out.error = Err("too big")
    except RecursionError:
        out.error = Err("recursion")
    finally:
        field.choose(PRIME)
    for l in out.lines:
        if out.error is None and not l.cases:
            l.cases.append(({}, {}, "nocase", "no case"))
    return out


def check_kinds(case, block):
    """Kinds before values: every expression of the block, even if it is not evaluated. The faults of claims by their lines."""
    faults = {}
    for at, line in enumerate(block.lines):
        try:
            check_kinds_of(case, line)
        except Err as e:
            case.members = None
            if line[0] not in STATEMENTS:
                raise
            faults[at] = e
    return faults


def check_kinds_of(case, line):
    base = {name: "i" for name in case.penv}
    if line[0] == "let":
        if line[1][2] is None:
            case.bare_kind(line[1][1])
        else:
            case.family_kind(line[1][1])
    elif line[0] == "poly":
        if case.kind(line[5], {**base, **{v: "n" for v in line[2]}}):
            raise Err("kind", "a poly of points")
    elif line[0] in HYPOTHESES + STATEMENTS:
        env = dict(base)
        for binder, _, _ in line[3]:
            env[binder] = "i"
        for item in line[4]:
            if item[0] == "name" and item[2] is None:
                d = case.decl.get(item[1])
                env[item[1]] = "n" if d is None or d[0] == "number" else ("g", case.count(d[1], case.penv)) if d[0] in ("point", "vector") else "n"
            else:
                base_name = item[1] if item[0] == "name" else item[1][1]
                d = case.decl.get(base_name + "_")
                env[(base_name, "any")] = "n" if d is None or d[0] == "number" else ("g", case.count(d[1], case.penv))
                case.members = True
        a, b = case.kind(line[1], env), case.kind(line[2], env)
        if a is not None and b is not None and a != b:
            raise Err("kind", "sides of two kinds")
        case.members = None


def decide_case(block, scope, params, out, points, seed, budget):
    scope.__dict__.pop("let_kinds", None)
    case = Case(scope, params, budget)
    text = repr(sorted(params.items()))
    rng = random.Random("%s %s %s" % (seed, block.id, text))
    faults = check_kinds(case, block)
    hypotheses = Hypotheses(case)
    work = []
    for (at, line), result in zip(block.statements(), out.lines):
        try:
            if at in faults:
                raise faults[at]
            for env in range_cases(case, line[3], case.penv):
                work.append([line, result, env, None, 0, None])
        except Err as e:
            result.cases.append((params, {}, "error", str(e)))
    if hypotheses.equations:
        plan = [("maps", None)] * points + [("any", None)] * points
        plan += [("any", "pool"), ("maps", "pool"), ("any", "pool")]
    elif hypotheses.assumptions:
        plan = [("maps", None)] * points
    else:
        plan = [("maps", None)] * points
    found = 0
    for order, pool in plan:
        if pool:
            a = rng.randrange(2, field.P)
            pool = [a, rng.randrange(2, field.P), a, 0, 1]
        sample = None
        for _ in range(3):
            try:
                sample = hypotheses.point(rng, order, pool)
            except ZeroDivisor:
                sample = None
                if not hypotheses.equations and not pool:
                    raise
            if sample is not None:
                break
        if sample is None:
            continue
        found += 1
        case.use(sample)
        case.members = None
        last = sample
        for item in work:
            line, result, env, status, good, reason = item
            if status == "error" or status == "false" and (not hypotheses.equations or len(result.witnesses) > 8):
                continue
            try:
                case.depth = 0
                d = difference(case, line, env)
            except ZeroDivisor as e:
                if not hypotheses.equations:
                    item[3], item[5] = "error", str(e)
                continue
            except Err as e:
                item[3], item[5] = "error", str(e)
                continue
            if all(x == 0 for x in d):
                item[4] += 1
            else:
                item[3] = "false"
                result.witnesses.append((case, env, sample, field.P))
    out.points += found
    out.seen |= case.seen
    if any(v == 0 for v in params.values()):
        out.seen.add("a parameter is 0")
    if found:
        for base, index in last.vals:
            if (base if index is None else base + "_") not in case.decl:
                out.free.add((base, index))
    for line, result, env, status, good, reason in work:
        ranges = {k: v[1] for k, v in env.items() if k not in params}
        if status is None:
            status = "true" if good else "novalue"
            reason = None if good else "no value meets the hypotheses"
        result.cases.append((params, ranges, status, reason))
    return max(1, len(work))


def prove(blocks, path, out):
    """What a correct prover would print with --json: `check` must accept all of it."""
    for block in blocks:
        decision = decide(block)
        if block.fault is not None:
            continue
        for l in decision.lines:
            o = {"id": block.id, "file": path, "line": l.place, "kind": l.kind.split()[0], "conditions": []}
            statuses = l.statuses()
            if decision.error is not None or statuses - {"true", "false"}:
                o.update(verdict="undecided", as_expected=False, error=str(decision.error or "; ".join(l.reasons())))
            else:
                proved = statuses == {"true"}
                expected = {"claim": proved, "refute": statuses == {"false"}, "refute some": not proved}[l.kind]
                o.update(verdict="proved" if proved else "refuted", as_expected=expected)
            out.write(json.dumps(o) + "\n")


def main(arguments):
    as_prover = arguments[:1] == ["prove"]
    for path in [a for a in arguments if a not in ("prove", "--json")]:
        with open(path) as f:
            blocks = parse_text(f.read())
        if as_prover:
            prove(blocks, path, sys.stdout)
            continue
        for block in blocks:
            start = time.time()
            decision = decide(block)
            spent = (time.time() - start) * 1000
            if decision.error:
                print("%s: %s (%.1f ms)" % (block.id, decision.error, spent))
            for l in decision.lines:
                print(
                    "%s:%d %s %s %s (%d cases, %.1f ms)"
                    % (block.id, l.place, l.kind, ",".join(sorted(l.statuses())), "; ".join(l.reasons()), len(l.cases), spent)
                )


if __name__ == "__main__":
    main(sys.argv[1:])
