#!/usr/bin/env python3
"""Holds the algebra of maps against values of the maps in Python's fractions: each operation is compared with its definition at
random parameters, and the degrees and knots of its results with their rules.

usage: check_algebra.py PROGRAM [CASES [SEED]]
"""

import random
import sys
from collections import Counter
from fractions import Fraction
from math import factorial

from map_oracle import degrees_of, determinant, indices, is_rational, point_of, value_at
from spline_oracle import Report, ask, common_factor, scaled, text_of, texts, times, trimmed

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

    def direction(self):
        return [number() for _ in range(self.dimension)]

    def segments(self, maps):
        """Parameters between which there are no knots, per direction."""
        cuts = []
        for d, (a, b) in enumerate(self.box):
            knots = [k for m in maps if m["kind"] == "bspline" for k in (m["knots"] if self.family == "curve" else m["knots"][d])]
            cuts.append(sorted({a, b, *(Fraction(t) for t in knots if a < Fraction(t) < b)}))
        return cuts

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


def partial_derivatives(a_map, domain, at):
    """The point and its partial derivatives, from divided differences of the polynomial on a segment of the domain."""
    rational = is_rational(a_map)
    columns = []
    for d in range(domain.dimension):
        if domain.family in ("curve", "box"):
            cuts = domain.segments([a_map])[d]
            i = max(k for k in range(len(cuts) - 1) if cuts[k] <= at[d])
            low, high = cuts[i], cuts[i + 1]
        else:
            low, high = at[d] - 1, at[d] + 1
        n = sum(degrees_of(a_map)) if domain.family == "simplex" else degrees_of(a_map)[d]
        nodes = [low + (high - low) * Fraction(k + 1, n + 2) for k in range(n + 1)]
        values = [value_at(a_map, [*at[:d], t, *at[d + 1 :]]) for t in nodes]
        columns.append([lagrange_derivative(nodes, [v[j] for v in values], at[d]) for j in range(len(values[0]))])
    value = value_at(a_map, at)
    if not rational:
        return columns
    if value[-1] == 0:
        return None
    w = value[-1]
    return [[(c * w - x * column[-1]) / w**2 for c, x in zip(column[:-1], value[:-1])] for column in columns]


def lagrange_derivative(nodes, values, t):
    """The derivative at t of the polynomial through these values."""
    total = Fraction(0)
    for i, x in enumerate(nodes):
        others = [y for k, y in enumerate(nodes) if k != i]
        scale = Fraction(1)
        for y in others:
            scale *= x - y
        slope = Fraction(0)
        for k in range(len(others)):
            product = Fraction(1)
            for m, y in enumerate(others):
                product *= 1 if m == k else t - y
            slope += product
        total += values[i] * slope / scale
    return total


def blossom_of(f, n, arguments):
    """Of a polynomial f of degree n along a line, by polarization: f(t), the arguments are points."""
    total = Fraction(0)
    for chosen in range(1, 2 ** len(arguments)):
        part = [u for i, u in enumerate(arguments) if chosen >> i & 1]
        k = len(part)
        total += (-1) ** (n - k) * Fraction(k) ** n * f(sum(part) / k)
    return total / factorial(n) if n else f(Fraction(0))


def polar_case(domain):
    """A curve or polynomial in one direction, with points as arguments."""
    a_map = domain.map(None, False)
    while a_map["kind"] == "bspline" or domain.family != "curve":
        domain = Domain()
        a_map = domain.map(None, False)
    n = degrees_of(a_map)[0]
    k = choose.randint(0, n)
    arguments = [number() for _ in range(k)]
    return domain, {"op": "polar", "map": a_map, "arguments": texts(arguments)}, [a_map], lambda at: [blossom_of(lambda t: value_at(a_map, [t])[0], n, [*arguments, *at * (n - k)])], n - k


def parameters_of_line(vertices, interval, t):
    s = (t - interval[0]) / (interval[1] - interval[0])
    return [p + s * (q - p) for p, q in zip(*vertices)]


def derived_case():
    """Operations on one map or two, whose result is over another domain or has derivatives: the request, and the expected point at a parameter."""
    domain = Domain()
    op = choose.choice(["polar", "restrict", "restrict", "isoparametric", "compose", "jacobian", "jacobian", "normal"])
    rational = choose.random() < 0.3
    size = choose.choice([None, 1, 2])
    seen[op] += 1
    if op == "polar":
        domain, request, maps, expected, n = polar_case(domain)
        return request, domain.parameter, expected, n
    if op == "restrict":
        a_map = domain.map(size, rational)
        vertices = [domain.parameter() for _ in range(2)]
        request = {"op": "restrict", "map": a_map, "vertices": [text_of(v[0]) if domain.family == "curve" else texts(v) for v in vertices]}
        interval = [Fraction(0), Fraction(1)]
        if choose.random() < 0.5:
            interval = [Fraction(2), choose.choice([Fraction(1), Fraction(7, 2)])]
            request["interval"] = texts(interval)
        return request, lambda: [interval[0] + (interval[1] - interval[0]) * Fraction(choose.randint(1, 22), 23)], lambda at: point_of(value_at(a_map, parameters_of_line(vertices, interval, at[0])), rational), None
    if op == "isoparametric":
        while domain.family != "box" or domain.dimension == 1:
            domain = Domain()
        a_map = domain.map(size, rational)
        fixed = domain.parameter()
        free = [choose.random() < 0.5 for _ in fixed]
        if all(free) or not any(free):
            free = [True] + [False] * (len(free) - 1)
        request = {"op": "restrict", "map": a_map, "at": [None if f else text_of(t) for f, t in zip(free, fixed)]}

        def expected(at):
            rest = iter(at)
            return point_of(value_at(a_map, [next(rest) if f else t for f, t in zip(free, fixed)]), rational)

        return request, lambda: [t for f, t in zip(free, domain.parameter()) if f], expected, None
    if op == "compose":
        outer_domain = Domain()
        while outer_domain.family == "barycentric" or outer_domain.dimension == 3:
            outer_domain = Domain()
        outer = outer_domain.map(size, rational)
        while outer["kind"] == "bspline":
            outer = outer_domain.map(size, rational)
        inner_rational = choose.random() < 0.3
        inner = domain.map(outer_domain.dimension, inner_rational)

        def expected(at):
            u = point_of(value_at(inner, at), inner_rational)
            return u and point_of(value_at(outer, u), rational)

        return {"op": "compose", "maps": [outer, inner]}, domain.parameter, expected, None
    while domain.family == "barycentric" or domain.dimension == 3:
        domain = Domain()
    dimension = domain.dimension + (op == "normal")
    a_map = domain.map(dimension, rational)

    def columns(at):
        return partial_derivatives(a_map, domain, at)

    if op == "normal":
        units = [[Fraction(int(i == j)) for i in range(dimension)] for j in range(dimension)]
        return {"op": "normal", "map": a_map}, domain.parameter, lambda at: (lambda c: c and [determinant([unit, *c]) for unit in units])(columns(at)), None
    return {"op": "jacobian", "map": a_map}, domain.parameter, lambda at: (lambda c: c and [determinant(c)])(columns(at)), None


def check_derived(case, response):
    request, parameter, expected, degree = case
    if not response["ok"]:
        report.expect(False, "refused", request, response)
        return
    result = response["result"]["map"]
    if degree is not None:
        report.expect(degrees_of(result) == [degree], "degree", request, result)
    for _ in range(3):
        at = parameter()
        wanted = expected(at)
        if wanted is None:
            continue
        found = point_of(value_at(result, at), is_rational(result))
        report.expect(found == wanted, "value", texts(at), wanted, found, request, result)


def bounds_case():
    """A scalar map, and what its values at many parameters are."""
    domain = Domain()
    while domain.dimension == 3:
        domain = Domain()
    rational = choose.random() < 0.3
    a_map = domain.map(None, rational)
    request = {"op": "bounds", "map": a_map, "depth": choose.choice([0, 2, 4])}
    if choose.random() < 0.6:
        name = next(name for name in ("control_points", "control_net", "coefficients", "terms") if name in a_map)
        a_map[name] = raised(a_map[name], a_map["kind"] == "simplex" or name == "terms")
    if a_map["kind"] == "bezier":
        # Only the control points inside may be negative.
        a_map["control_points"] = [text_of(abs(number()) + 1), *(text_of(number()) for _ in range(choose.randint(1, 3))), text_of(abs(number()) + 1)]
        a_map.pop("weights", None)
        a_map.pop("degree", None)
        request["depth"] = choose.choice([0, 0, 3])
    # A polynomial is bounded over the unit box or simplex.
    if a_map["kind"] == "polynomial":
        domain.box = [(Fraction(0), Fraction(1))] * domain.dimension
        domain.vertices = [[Fraction(0)] * domain.dimension] + [[Fraction(int(i == j)) for j in range(domain.dimension)] for i in range(domain.dimension)]
    return domain, request


def raised(net, pairs):
    if pairs:
        return [[i, raised(p, False)] for i, p in net]
    return [raised(p, False) for p in net] if isinstance(net, list) else text_of(abs(Fraction(net)) + Fraction(1, 2))


def check_bounds(case, response):
    domain, request = case
    a_map = request["map"]
    if not response["ok"]:
        report.expect(False, "refused", request, response)
        return
    result = response["result"]
    seen["bounds " + result["decision"]] += 1
    if result["decision"] == "not positive":
        at = result["at"] if isinstance(result["at"], list) else [result["at"]]
        at = [Fraction(t) for t in at]
        # A vertex of a segment may be the end of one with another value on its other side.
        values = [point_of(value_at(a_map, at), is_rational(a_map))[0]]
        report.expect(a_map["kind"] == "bspline" or values[0] == Fraction(result["value"]), "value", values, request, result)
        report.expect(Fraction(result["value"]) <= 0, "not positive", request, result)
    for _ in range(5):
        value = point_of(value_at(a_map, domain.parameter()), is_rational(a_map))
        if value is None:
            continue
        report.expect(result["decision"] != "positive" or value[0] > 0, "positive", value, request, result)
        if "lower" in result:
            report.expect(Fraction(result["lower"]) <= value[0] <= Fraction(result["upper"]), "bounds", value, request, result)


def random_polynomial(variables, degree):
    names = ["x", "y"][:variables]
    terms = [[e, text_of(number())] for e in exponents([degree] * variables) if sum(e) <= degree]
    return {"kind": "polynomial", "variables": names, "terms": terms, "degree": degree} if variables == 2 else {"kind": "polynomial", "coefficients": [c for _, c in terms]}


def dense(a_map):
    return trimmed(Fraction(c) for c in a_map["coefficients"])


def sylvester(p, q):
    m, n = len(p) - 1, len(q) - 1
    rows = [[Fraction(0)] * i + p[::-1] + [Fraction(0)] * (n - 1 - i) for i in range(n)]
    return rows + [[Fraction(0)] * i + q[::-1] + [Fraction(0)] * (m - 1 - i) for i in range(m)]


def check_factors():
    """gcd and resultant of polynomials in one variable and in two, which have a common factor in half of the cases."""
    requests, wanted = [], []
    for _ in range(CASES // 5):
        p, q, common = (dense(random_polynomial(1, choose.randint(0, n))) for n in (4, 3, 2))
        if choose.random() < 0.5:
            p, q = times(p, common), times(q, common)
        as_map = lambda c: {"kind": "polynomial", "coefficients": texts(c) or ["0"]}
        requests.append({"op": "gcd", "maps": [as_map(p), as_map(q)]})
        divisor = common_factor([p, q])
        wanted.append(texts(scaled(divisor, 1 / divisor[-1])) if divisor else ["0"])
        requests.append({"op": "resultant", "maps": [as_map(p), as_map(q)]})
        wanted.append(text_of(determinant(sylvester(p, q)) if p and q else Fraction(0)))
    for request, response, expected in zip(requests, ask(program, requests), wanted):
        seen[request["op"]] += 1
        found = response.get("result", {})
        found = found.get("value", found.get("map", {}).get("coefficients"))
        report.expect(found == expected, request, response, expected)
    requests, cases = [], []
    for _ in range(CASES // 10):
        p, q = random_polynomial(2, choose.randint(0, 2)), random_polynomial(2, choose.randint(0, 2))
        requests.append({"op": "resultant", "maps": [p, q], "variable": "y"})
        cases.append((p, q))
    for request, response, (p, q) in zip(requests, ask(program, requests), cases):
        seen["resultant in x"] += 1
        degrees = [max([e[1] for e, c in a["terms"] if c != "0"], default=None) for a in (p, q)]
        if None in degrees:
            continue
        for _ in range(2):
            x = Fraction(choose.randint(-5, 5), choose.randint(1, 3))
            columns = [[sum(Fraction(c) * x ** e[0] for e, c in a["terms"] if e[1] == k) for k in range(n + 1)] for a, n in zip((p, q), degrees)]
            found = value_at(response["result"]["map"], [x])[0]
            report.expect(found == determinant(sylvester(*columns)), request, response)


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

derived = [derived_case() for _ in range(CASES)]
for case, response in zip(derived, ask(program, [case[0] for case in derived])):
    check_derived(case, response)

bounded = [bounds_case() for _ in range(CASES // 3)]
for case, response in zip(bounded, ask(program, [case[1] for case in bounded])):
    check_bounds(case, response)

check_factors()

assert min(seen.values()) > CASES / 100 and len(seen) == 28, seen
print(f"{len(cases) + len(derived) + len(bounded) + seen['gcd'] + seen['resultant']} cases, {report.problems} problems")
sys.exit(1 if report.problems else 0)
