"""Checks what a prover prints: whether its conditions hold, its counterexamples are valid, and no condition is missing."""

import random
import re

import field
from faults import Err, TooBig, ZeroDivisor
from field import multiply, rational, same
from hypotheses import Hypotheses
from language import SyntaxFault, parse_comparison, parse_expr
from names import Sample, Scope
from values import Case, difference, parameter_cases, range_cases


def readable(text):
    """A prover's text in the notation of this reader: 2 x with its sign, u_1.2 with braces."""
    return re.sub(r"_(\d+)(?=\.\d)", r"_{\1}", re.sub(r"(\d) ([A-Za-z])", r"\1*\2", text))


def conditions_hold(witness, conditions):
    """Whether all conditions, as a prover prints them, hold at a witness; None if one cannot be read."""
    case, env, sample, p = witness
    keep = field.P
    field.choose(p)
    try:
        case.use(sample)
        case.depth = 0
        for text in conditions:
            try:
                op, a, b = parse_comparison(readable(text), dots=True)
                x, y = case.value(a, case.penv), case.value(b, case.penv)
                if op == "!=" and same(x, y):
                    return False
            except ZeroDivisor:
                return False
            except (Err, SyntaxFault, KeyError, IndexError, TooBig):
                return None
        return True
    finally:
        field.choose(keep)


def expanded(e, variables, s):
    """A polynomial in these variables as a dictionary from exponents to coefficients."""
    kind = e[0]
    zero = (0,) * s
    if kind == "num":
        return {zero: rational(e[1])}
    if kind == "name" and e[2] is None and e[1] in variables:
        at = variables.index(e[1])
        return {tuple(1 if j == at else 0 for j in range(s)): 1}
    if kind == "neg":
        return {k: -x % field.P for k, x in expanded(e[1], variables, s).items()}
    if kind in ("add", "sub"):
        out = dict(expanded(e[1], variables, s))
        f = 1 if kind == "add" else -1
        for k, x in expanded(e[2], variables, s).items():
            out[k] = (out.get(k, 0) + f * x) % field.P
        return out
    if kind == "mul":
        return multiply(expanded(e[1], variables, s), expanded(e[2], variables, s))
    if kind == "div" and e[2][0] == "num":
        f = pow(int(e[2][1]), -1, field.P)
        return {k: x * f % field.P for k, x in expanded(e[1], variables, s).items()}
    if kind == "pow" and e[2][0] == "num":
        out = {zero: 1}
        base = expanded(e[1], variables, s)
        for _ in range(int(e[2][1])):
            out = multiply(out, base)
        return out
    raise Err("a map that cannot be read")


def check_counterexample(block, place, example, seed=0):
    """Whether the values that a prover prints make a line false: True, or a text that says what is wrong; None if they cannot be read."""
    try:
        scope = Scope(block)
        parameters = example.get("parameters", {})
        params = {line[1]: int(parameters[line[1]]) for line in block.lines if line[0] == "for"}
        case = Case(scope, params)
        line = [l for l, p in zip(block.lines, block.places) if p == place][0]
        env = dict(case.penv)
        for binder, _, _ in line[3]:
            if binder in params:
                return None
            env[binder] = ("i", int(parameters[binder]))
        if env not in range_cases(case, line[3], case.penv):
            return "parameters out of their ranges"
        sample = Sample(random.Random("%s counterexample" % seed))
        case.use(sample)
        given = set()
        for name, shown in example.get("maps", {}).items():
            if name not in case.maps:
                return None
            dirs, kind, _ = case.maps[name]
            if kind != "free":
                continue
            s = sum(d for d, _ in dirs)
            text = re.sub(r"(\d) ?([A-Za-z])", r"\1*\2", re.sub(r"([A-Za-z])(\d+)", lambda m: m.group(1) + "QQ" + "ABCDEFGHIJ"[int(m.group(2))], shown["text"]))
            variables = [re.sub(r"([A-Za-z])(\d+)", lambda m: m.group(1) + "QQ" + "ABCDEFGHIJ"[int(m.group(2))], v) for v in shown.get("variables", ["t"])]
            if len(variables) != s:
                return None
            found = expanded(parse_expr(text), variables, s)
            allowed = set(case.all_exponents(dirs))
            if any(x and e not in allowed for e, x in found.items()):
                return "a map of too high a degree"
            sample.coefs[name] = {e: found.get(e, 0) for e in allowed}
            given.add(name)
        points = {}
        for name, text in example.get("variables", {}).items():
            node = parse_expr(readable(name), dots=True)
            value = rational(text)
            if node[0] == "symbol":
                index = None if node[1][2] is None else tuple(case.integer(e, case.penv) for e in node[1][2])
                if index is None and node[1][1] in case.maps:
                    return None
                points.setdefault((node[1][1], index), {})[node[2][0]] = value
            elif node[0] == "name":
                index = None if node[2] is None else tuple(case.integer(e, case.penv) for e in node[2])
                sample.vals[node[1], index] = value
                given.add((node[1], index))
            else:
                return None
        for key, shown in points.items():
            d = case.decl.get(key[0] if key[1] is None else key[0] + "_")
            if d is None or d[0] not in ("point", "vector"):
                return None
            v = list(case.free(key, d))
            for at, x in shown.items():
                v[at - 1] = x
            sample.vals[key] = tuple(v)
            given.add(key)
        hypotheses = Hypotheses(case)
        instances = [(eq, hypotheses.instance(eq)) for eq in hypotheses.equations for _ in range(2 if eq[2] else 1)]
        if instances and not hypotheses.solve(sample.rng, "maps", instances, given):
            missing = bool({k for k in sample.vals if k not in given} | {k for k in sample.coefs if k not in given})
            return None if missing else "a hypothesis does not hold"
        case.use(sample)
        for other, e in hypotheses.assumptions:
            if all(x == 0 for x in difference(case, other, e)):
                return "an assumption does not hold"
        if all(x == 0 for x in difference(case, line, env)):
            return "both sides are equal"
        return True
    except ZeroDivisor:
        return "a divisor vanishes"
    except (Err, SyntaxFault, KeyError, IndexError, ValueError, TooBig):
        return None


def lost_condition(block, decision, line_number, conditions, seed=0, tries=6):
    """A point with small equal values where a divisor of a proved claim vanishes although all its conditions hold."""
    rng = random.Random("%s conditions" % seed)
    scope = Scope(block)
    for params in parameter_cases(block, scope)[-2:]:
        case = Case(scope, params)
        if any(l[0] == "given" for l in block.lines):
            return None
        for (_, line), result in zip(block.statements(), decision.lines):
            if result.place != line_number:
                continue
            for env in range_cases(case, line[3], case.penv)[-3:]:
                for _ in range(tries):
                    a = rng.randrange(2, field.P)
                    sample = Sample(rng, [0, 0, 1, a, a, -a, rng.randrange(2, field.P)])
                    case.use(sample)
                    try:
                        case.depth = 0
                        difference(case, line, env)
                        continue
                    except ZeroDivisor:
                        pass
                    except (Err, TooBig):
                        break
                    assumed = True
                    for other in block.lines:
                        if other[0] == "assume":
                            for e in range_cases(case, other[3], case.penv):
                                try:
                                    if all(x == 0 for x in difference(case, other, e)):
                                        assumed = False
                                except ZeroDivisor:
                                    assumed = False
                    if assumed and conditions_hold((case, env, sample, field.P), conditions):
                        return {k: v for k, v in sample.vals.items()}
    return None
