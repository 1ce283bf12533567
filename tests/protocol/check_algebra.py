#!/usr/bin/env python3
"""Holds the algebra of maps against values of the maps in Python's fractions: each operation is compared with its definition at
random parameters, and the degrees and knots of its results with their rules.

usage: check_algebra.py PROGRAM [CASES [SEED]]
"""

import random
import sys
from collections import Counter
from fractions import Fraction

from map_oracle import degrees_of, determinant, indices, is_rational, point_of, value_at
from spline_oracle import Report, ask, text_of, texts

program = sys.argv[1]
CASES = int(sys.argv[2]) if len(sys.argv) > 2 else 1500
choose = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 19)
report = Report()
seen = Counter()


def number():
    return choose.choice([Fraction(0), Fraction(1), Fraction(-1), Fraction(choose.randint(-9, 9), choose.randint(1, 5))])


def weight():
    return text_of(choose.choice([Fraction(1), Fraction(2), Fraction(1, 3), Fraction(choose.randint(1, 9), choose.randint(1, 4))]))


def point(coordinates):
    """A number for None."""
    return text_of(number()) if coordinates is None else texts(number() for _ in range(coordinates))


class Domain:
    """A kind of domain, with what all maps on it share."""

    def __init__(self):
        self.family = choose.choice(["curve", "curve", "box", "box", "simplex", "barycentric"])
        self.dimension = 1 if self.family == "curve" else choose.choice([1, 2, 2, 3] if self.family == "box" else [1, 2, 2])
        self.box = []
        for _ in range(self.dimension):
            a = Fraction(choose.randint(-3, 3), choose.randint(1, 3))
            self.box.append((Fraction(0), Fraction(1)) if choose.random() < 0.3 else (a, a + Fraction(choose.randint(1, 5), choose.randint(1, 3))))
        self.cuts = [sorted({a + (b - a) * Fraction(choose.randint(1, 5), 6) for _ in range(2)}) for a, b in self.box]
        origin = [Fraction(choose.randint(-2, 2)) for _ in range(self.dimension)]
        self.vertices = [origin] + [[x + (choose.randint(1, 3) if i == j else choose.randint(0, 1) * (j > i)) for j, x in enumerate(origin)] for i in range(self.dimension)]
        self.shared_knots = {}

    def parameter(self):
        if self.family == "curve" or self.family == "box":
            return [choose.choice([a, b, *(a + (b - a) * Fraction(choose.randint(0, 24), 24) for _ in range(4))]) for a, b in self.box]
        parts = [Fraction(choose.randint(0, 6)) for _ in range(self.dimension + 1)]
        parts[0] += sum(parts) == 0
        parts = [x / sum(parts) for x in parts]
        if self.family == "barycentric":
            return parts
        return [sum(x * v[j] for x, v in zip(parts, self.vertices)) for j in range(self.dimension)]

    def degree(self):
        most = {1: 4, 2: 3, 3: 1}[self.dimension]
        return choose.choice([0, 1, 1, choose.randint(0, most)])

    def knots(self, direction, n):
        if (direction, n) in self.shared_knots and choose.random() < 0.5:
            return self.shared_knots[direction, n]
        a, b = self.box[direction]
        inner = [t for t in self.cuts[direction] for _ in range(choose.choice([0, 1, 1, n, n + 1]))]
        clamped = choose.random() < 0.7
        before = [a] * (n + 1) if clamped else sorted(a - choose.randint(0, 2) for _ in range(n)) + [a]
        behind = [b] * (n + 1) if clamped else [b] + sorted(b + choose.randint(0, 2) for _ in range(n))
        knots = before + inner + behind
        if any(knots.count(t) > n + 1 for t in knots):
            return self.knots(direction, n)
        self.shared_knots[direction, n] = knots
        return knots

    def map(self, coordinates, rational):
        """A map of some kind into so many coordinates, None for a scalar."""
        kind = choose.choice({"curve": ["polynomial", "bezier", "bspline", "bspline"], "box": ["polynomial", "tensor", "bspline"], "simplex": ["polynomial", "simplex", "simplex"], "barycentric": ["simplex"]}[self.family])
        seen[f"{self.family} {kind}"] += 1
        degrees = [self.degree() for _ in range(self.dimension)]
        a_map = {"kind": kind}
        if kind == "polynomial" and self.family == "curve":
            n = degrees[0]
            a_map |= {"coefficients": [point(coordinates) for _ in range(n + 1)], "degree": n + choose.choice([0, 0, 1])}
            if rational:
                a_map["denominator"] = [weight(), *(text_of(Fraction(choose.randint(0, 2))) for _ in range(n))]
            return a_map
        if kind == "polynomial":
            a_map["variables"] = ["x", "y", "z"][: self.dimension]
            top = degrees if self.family == "box" else [degrees[0]] * self.dimension
            a_map |= {"degrees": degrees} if self.family == "box" else {"degree": degrees[0]}
            inside = [e for e in exponents(top) if self.family == "box" or sum(e) <= degrees[0]]
            a_map["terms"] = [[e, point(coordinates)] for e in inside if e == [0] * self.dimension or choose.random() < 0.7]
            if rational:
                a_map["denominator"] = [[[0] * self.dimension, weight()]]
            return a_map
        if kind == "simplex":
            net = indices(self.dimension, degrees[0])
            a_map |= {"degree": degrees[0], "control_net": [[i, point(coordinates)] for i in net]}
            if rational:
                a_map["weights"] = [[i, weight()] for i in net]
            if self.family == "simplex":
                vertices = list(self.vertices)
                choose.shuffle(vertices)
                a_map["vertices"] = [texts(v) for v in vertices]
            return a_map
        counts = [n + 1 for n in degrees]
        if kind == "bspline":
            knots = [self.knots(d, n) for d, n in enumerate(degrees)]
            counts = [len(k) - n - 1 for k, n in zip(knots, degrees)]
            a_map["knots"] = texts(knots[0]) if self.family == "curve" else [texts(k) for k in knots]
        else:
            intervals = [texts(ends if choose.random() < 0.8 else reversed(ends)) for ends in self.box]
            a_map |= {"interval": intervals[0]} if kind == "bezier" else {"intervals": intervals}
        a_map |= {"degree": degrees[0]} if self.family == "curve" else {"degrees": degrees}
        name = "control_points" if self.family == "curve" else "control_net"
        a_map[name] = nested(counts, lambda: point(coordinates))
        if rational:
            a_map["weights"] = nested(counts, weight)
        return a_map


def exponents(top):
    result = [[]]
    for n in top:
        result = [[*e, i] for e in result for i in range(n + 1)]
    return result


def nested(counts, leaf):
    return [nested(counts[1:], leaf) for _ in range(counts[0])] if counts else leaf()


def same_weights(left):
    """A map with other points over the weights of another."""
    other = {**left}
    for name in ("control_points", "coefficients"):
        if name in left:
            other[name] = fresh(left[name])
    if "control_net" in left:
        other["control_net"] = [[i, fresh(p)] for i, p in left["control_net"]] if left["kind"] == "simplex" else fresh(left["control_net"])
    return other


def fresh(leaf):
    return [fresh(x) for x in leaf] if isinstance(leaf, list) else text_of(number())


def affine_points(maps, at):
    values = [value_at(m, at) for m in maps]
    return [point_of(v, is_rational(m)) for v, m in zip(values, maps)]


def new_case():
    domain = Domain()
    op = choose.choice(["sum", "sum", "scalar", "scalar", "dot", "cross", "determinant", "quotient", "transform"])
    rational = [choose.random() < 0.3 for _ in range(4)]
    size = choose.choice([None, 1, 2, 3])
    seen[op] += 1
    if op == "sum":
        maps = [domain.map(size, rational[i]) for i in range(choose.choice([1, 2, 2, 3]))]
        if choose.random() < 0.3:
            maps.append(same_weights(maps[0]))
        factors = [number() for _ in maps]
        request = {"op": "sum", "maps": maps}
        if choose.random() < 0.6:
            request["factors"] = texts(factors)
        else:
            factors = [Fraction(1)] * len(maps)
        return domain, request, maps, lambda ps: [sum(c * p[j] for c, p in zip(factors, ps)) for j in range(len(ps[0]))], max
    if op == "scalar":
        maps = [domain.map(None, rational[i]) for i in range(choose.choice([1, 1, 2]))]
        maps.insert(choose.randint(0, len(maps)), domain.map(size, rational[3]))

        def product_of(ps):
            result = [Fraction(1)]
            for p in ps:
                result = [a * b for a in result for b in p]
            return result

        return domain, {"op": "product", "maps": maps}, maps, product_of, sum
    if op == "dot":
        maps = [domain.map(size, rational[0]), domain.map(size, rational[1])]
        if choose.random() < 0.2:
            maps[1] = same_weights(maps[0])
        return domain, {"op": "product", "maps": maps, "as": "dot"}, maps, lambda ps: [sum(a * b for a, b in zip(*ps))], sum
    if op in ("cross", "determinant"):
        n = choose.choice([2, 2, 3] if op == "cross" else [1, 2, 3])
        maps = [domain.map(n, rational[i] and n < 3) for i in range(n - (op == "cross"))]

        def expected(ps):
            units = [[Fraction(int(i == j)) for i in range(n)] for j in range(n)]
            return [determinant([unit, *ps]) for unit in units] if op == "cross" else [determinant(ps)]

        return domain, {"op": "product", "maps": maps, "as": op}, maps, expected, sum
    if op == "quotient":
        maps = [domain.map(size, rational[0]), domain.map(None, rational[1])]
        return domain, {"op": "quotient", "maps": maps}, maps, lambda ps: None if ps[1][0] == 0 else [x / ps[1][0] for x in ps[0]], None
    maps = [domain.map(size, rational[0])]
    columns = size or 1
    rows = choose.choice([1, 2, 3])
    matrix = [[number() for _ in range(columns)] for _ in range(rows)]
    translation = [number() for _ in range(rows)]
    request = {"op": "transform", "map": maps[0], "matrix": [texts(r) for r in matrix]}
    if choose.random() < 0.3:
        matrix, translation = matrix[:1], translation[:1]
        request["matrix"] = texts(matrix[0])
    if choose.random() < 0.7:
        request["translation"] = texts(translation)
    else:
        translation = [Fraction(0)] * len(matrix)
    return domain, request, maps, lambda ps: [sum(m * x for m, x in zip(row, ps[0])) + t for row, t in zip(matrix, translation)], max


def rule_of_knots(maps, result, domain):
    """The multiplicities of inner knots that keep the order of contact."""
    for d in range(domain.dimension):
        lists = []
        for m in maps:
            if m["kind"] == "bspline":
                lists.append((m["knots"] if domain.family == "curve" else m["knots"][d], degrees_of(m)[d]))
        a, b = domain.box[d]
        knots = [Fraction(t) for t in (result["knots"] if domain.family == "curve" else result["knots"][d])]
        n = degrees_of(result)[d]
        expected = {}
        for own, degree in lists:
            own = [Fraction(t) for t in own]
            for t in set(own):
                if a < t < b:
                    expected[t] = max(expected.get(t, 0), own.count(t) + n - degree)
        found = {t: knots.count(t) for t in set(knots) if a < t < b}
        report.expect(found == expected, "knots", expected, result)


def check(case, response):
    domain, request, maps, expected, degree_rule = case
    if not response["ok"]:
        divisor_is_zero = request["op"] == "quotient" and "divisor is 0" in response["error"]["message"]
        report.expect(divisor_is_zero, "refused", request, response)
        return
    result = response["result"]["map"]
    rational = is_rational(result)
    report.expect(rational == (request["op"] == "quotient" or any(is_rational(m) for m in maps)), "rational", request, result)
    if degree_rule and not rational:
        for d, n in enumerate(degrees_of(result)):
            report.expect(n == degree_rule(degrees_of(m)[d] for m in maps), "degree", request, result)
    if result["kind"] == "bspline":
        rule_of_knots(maps, result, domain)
    for _ in range(4):
        at = domain.parameter()
        points = affine_points(maps, at)
        if None in points:
            continue
        wanted = expected(points)
        if wanted is None:
            continue
        found = point_of(value_at(result, at), rational)
        report.expect(found == wanted, "value", texts(at), wanted, found, request, result)


cases = [new_case() for _ in range(CASES)]
for case, response in zip(cases, ask(program, [case[1] for case in cases])):
    check(case, response)

assert min(seen.values()) > CASES / 100 and len(seen) == 16, seen
print(f"{len(cases)} cases, {report.problems} problems")
sys.exit(1 if report.problems else 0)
