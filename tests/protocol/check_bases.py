#!/usr/bin/env python3
"""Holds basis functions, matrices between bases and interpolation against their definitions, in Python's fractions.

usage: check_bases.py PROGRAM [--cases N] [--seed S]

Polynomials are lists of coefficients, lowest power first. B-splines are those of the recursion of Cox and de Boor, one polynomial per
span. A matrix is right if it gives back each function; an interpolation if it has the values, or if Gauss's elimination finds the
system of equations singular where the program refuses it.
"""

import argparse
import json
import random
import subprocess
import sys
from fractions import Fraction
from math import comb, factorial

parser = argparse.ArgumentParser()
parser.add_argument("program")
parser.add_argument("--cases", type=int, default=300, help="of each kind")
parser.add_argument("--seed", type=int, default=1)
options = parser.parse_args()
rng = random.Random(options.seed)

# Polynomials


def plus(p, q):
    n = max(len(p), len(q))
    return [(p[i] if i < len(p) else 0) + (q[i] if i < len(q) else 0) for i in range(n)]


def times(p, q):
    result = [Fraction(0)] * max(0, len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            result[i + j] += a * b
    return result


def scaled(factor, p):
    return [factor * a for a in p]


def value(p, t):
    total = Fraction(0)
    for a in reversed(p):
        total = total * t + a
    return total


def derived(p, order=1):
    for _ in range(order):
        p = [k * p[k] for k in range(1, len(p))]
    return p


def trimmed(p):
    p = list(p)
    while p and p[-1] == 0:
        p.pop()
    return p


def product(factors):
    result = [Fraction(1)]
    for factor in factors:
        result = times(result, factor)
    return result


# Bases


def full_knots(degree, knots, convention):
    return [knots[0] - 1, *knots, knots[-1] + 1] if convention == "polar" else knots


def splines_on(degree, knots, span):
    """The functions over all knots on one of their non-empty spans."""
    row = [[Fraction(int(i == span))] for i in range(len(knots) - 1)]
    for k in range(1, degree + 1):
        finer = []
        for i in range(len(knots) - k - 1):
            p = []
            if knots[i + k] != knots[i]:
                width = knots[i + k] - knots[i]
                p = plus(p, times([-knots[i] / width, 1 / width], row[i]))
            if knots[i + k + 1] != knots[i + 1]:
                width = knots[i + k + 1] - knots[i + 1]
                p = plus(p, times([knots[i + k + 1] / width, -1 / width], row[i + 1]))
            finer.append(p)
        row = finer
    return row


class Splines:
    def __init__(self, degree, knots, convention="textbook"):
        self.degree, self.given, self.convention = degree, knots, convention
        self.knots = full_knots(degree, knots, convention)
        self.count = len(self.knots) - degree - 1
        self.domain = self.knots[degree], self.knots[self.count]
        self.spans = [i for i in range(degree, self.count) if self.knots[i] < self.knots[i + 1]]

    def json(self):
        return {"basis": "bspline", "degree": self.degree, "knots": texts(self.given), "convention": self.convention}

    def span_at(self, t):
        inside = [i for i in self.spans if self.knots[i] <= t]
        return inside[-1] if t < self.domain[1] else self.spans[-1]

    def on(self, span):
        return splines_on(self.degree, self.knots, span)

    def at(self, t):
        return self.on(self.span_at(t))


class Polynomials:
    def __init__(self, name, degree, fields, functions):
        self.degree, self.count, self.fields, self.functions = degree, degree + 1, {"basis": name, **fields}, functions

    def json(self):
        return self.fields

    def at(self, t):
        return self.functions


def texts(numbers):
    return [str(number) for number in numbers]


# Random data, with many equal, negative and consecutive numbers


def number():
    return Fraction(rng.choice([0, 1, -1, 2, 3, -5, 7, rng.randint(-60, 60)]), rng.choice([1, 1, 1, 2, 3, 7, rng.randint(1, 20)]))


def distinct(count):
    numbers = set()
    while len(numbers) < count:
        numbers.add(number())
    numbers = list(numbers)
    rng.shuffle(numbers)
    return numbers


def knot_vector(degree, domain=None, least=0):
    """Knots with a domain that is given, or any; clamped, with multiplicities up to degree + 1, or free."""
    while True:
        inner = sorted(distinct(rng.randint(2, 5)))
        if domain:
            a, b = domain
            inner = sorted({a + (b - a) * Fraction(rng.randint(1, 11), 12) for _ in range(rng.randint(0, 3))} | {a, b})
        knots = []
        for i, knot in enumerate(inner):
            end = i in (0, len(inner) - 1)
            knots += [knot] * (degree + 1 if end and rng.random() < 0.6 else rng.randint(max(1, least), degree + 1))
        for _ in range(degree + 1 - knots.count(inner[0])):
            knots.insert(0, knots[0] - rng.choice([0, 1, Fraction(1, 2)]) if knots.count(knots[0]) <= degree else knots[0] - 1)
        for _ in range(degree + 1 - knots.count(inner[-1])):
            knots.append(knots[-1] + (0 if knots.count(knots[-1]) <= degree and rng.random() < 0.5 else 1))
        if len(knots) < 2 * degree + 2 or any(knots.count(knot) > degree + 1 for knot in knots):
            continue
        convention = "polar" if degree > 0 and rng.random() < 0.3 else "textbook"
        if convention == "polar":
            knots = knots[1:-1]
        splines = Splines(degree, knots, convention)
        if splines.domain[0] < splines.domain[1] and (not domain or splines.domain == domain):
            return splines


def power_basis(name, degree, center):
    fields = {"degree": degree} | ({"center": str(center)} if name == "taylor" else {})
    return Polynomials(name, degree, fields, [product([[-center, Fraction(1)]] * k) for k in range(degree + 1)])


def polynomial_basis(degree):
    kind = rng.randrange(5)
    if kind == 0:
        return power_basis("monomial", degree, Fraction(0))
    if kind == 1:
        return power_basis("taylor", degree, number())
    if kind == 2:
        a, b = distinct(2)
        s, r = [-a / (b - a), 1 / (b - a)], [b / (b - a), -1 / (b - a)]
        functions = [scaled(comb(degree, k), product([s] * k + [r] * (degree - k))) for k in range(degree + 1)]
        return Polynomials("bernstein", degree, {"degree": degree, "interval": texts([a, b])}, functions)
    if kind == 3:
        nodes = distinct(degree + 1)
        functions = [product([[-x / (y - x), 1 / (y - x)] for x in nodes if x != y]) for y in nodes]
        return Polynomials("lagrange", degree, {"nodes": texts(nodes)}, functions)
    nodes = [number() for _ in range(degree + 1)]
    functions = [product([[-x, Fraction(1)] for x in nodes[:k]]) for k in range(degree + 1)]
    return Polynomials("newton", degree, {"nodes": texts(nodes)}, functions)


# Requests with what checks their answers

requests, checks = [], []
problems = 0
seen = {}


def ask(kind, request, check):
    requests.append(request)
    checks.append((kind, check))


def expect(found, expected, what):
    global problems
    if found != expected:
        problems += 1
        if problems < 10:
            print(what, "expected:", expected, "found:", found)


def note(what):
    seen[what] = seen.get(what, 0) + 1


def fractions(values):
    return [Fraction(x) for x in values]


def quotient_derivative(numerator, denominator, order):
    """As a numerator over a power of the denominator."""
    power = 1
    for _ in range(order):
        numerator = plus(
            times(derived(numerator), denominator), scaled(Fraction(-power), times(numerator, derived(denominator)))
        )
        power += 1
    return numerator, product([denominator] * power)


def basis_functions_case():
    degree = rng.randint(0, 4)
    order = rng.choice([0, 0, 1, 2, degree, degree + 1])
    splines = knot_vector(degree)
    request = {"op": "basis-functions", "degree": degree, "knots": texts(splines.given), "convention": splines.convention}
    if order:
        request["order"] = order
    weights = [rng.choice([1, 2, 3, Fraction(1, 2)]) for _ in range(splines.count)] if rng.random() < 0.4 else None
    if weights:
        request["weights"] = texts(weights)

    def quotients(span):
        functions = splines.on(span)
        if not weights:
            return [(derived(p, order), [Fraction(1)]) for p in functions]
        functions = [scaled(Fraction(w), p) for w, p in zip(weights, functions)]
        total = []
        for p in functions:
            total = plus(total, p)
        return [quotient_derivative(p, total, order) for p in functions]

    shift = 1 if splines.convention == "polar" else 0

    def check_pieces(result):
        for j, pieces in enumerate(result["functions"]):
            expected = [i for i in splines.spans if j <= i <= j + degree]
            expect([piece["segment"] + shift for piece in pieces], expected, request)
            for span, piece in zip(expected, pieces):
                p, q = quotients(span)[j]
                found, divisor = fractions(piece["coefficients"]), fractions(piece.get("denominator", ["1"]))
                expect(trimmed(times(found, q)), trimmed(times(p, divisor)), request)
                expect(fractions(piece["interval"]), splines.knots[span : span + 2], request)

    ask("basis functions", request, check_pieces)
    a, b = splines.domain
    at = [a, b, *rng.choices(splines.knots, k=2), a + (b - a) * Fraction(rng.randint(0, 30), 30)]
    at = [t for t in at if a <= t <= b]

    def check_values(result):
        for t, found in zip(at, result["basis_values"]):
            span = splines.span_at(t)
            expected = [value(p, t) / value(q, t) for p, q in quotients(span)]
            expect(found["first_function"], span - degree, request)
            expect(fractions(found["values"]), expected[span - degree : span + 1], (request, t))

    ask("basis functions", request | {"at": texts(at)}, check_values)


def single_case():
    degree = rng.randint(0, 5)
    while True:
        knots = sorted(rng.choice([number(), Fraction(1), Fraction(0)]) for _ in range(degree + 2))
        if knots[0] < knots[-1]:
            break
    order = rng.choice([0, 0, 1, degree])
    request = {"op": "basis-functions", "degree": degree, "knots": texts(knots), "order": order}
    spans = [i for i in range(degree + 1) if knots[i] < knots[i + 1]]

    def check_pieces(result):
        expect(len(result["functions"]), 1, request)
        expect([piece["segment"] for piece in result["functions"][0]], spans, request)
        for span, piece in zip(spans, result["functions"][0]):
            p = derived(splines_on(degree, knots, span)[0], order)
            expect(trimmed(fractions(piece["coefficients"])), trimmed(p), request)
        if degree:
            expect(fractions(result["greville"]), [sum(knots[1:-1], Fraction(0)) / degree], request)

    ask("one B-spline", request, check_pieces)
    at = [knots[0], knots[-1], *rng.choices(knots, k=2), number()]
    if degree > 0:
        at += [knots[0] - 1, knots[-1] + 1]
    at = [t for t in at if degree > 0 or knots[0] <= t <= knots[-1]]

    def check_values(result):
        for t, found in zip(at, result["basis_values"]):
            expected = Fraction(0)
            if knots[0] <= t <= knots[-1]:
                span = [i for i in spans if knots[i] <= t and (t < knots[i + 1] or i == spans[-1])][-1]
                expected = value(derived(splines_on(degree, knots, span)[0], order), t)
            expect((found["first_function"], fractions(found["values"])), (0, [expected]), (request, t))

    ask("one B-spline", request | {"at": texts(at)}, check_values)


def refusal_of_matrix(source, target):
    """The code and the place of the error, by the definition of the spaces."""
    if source.degree > target.degree:
        return "degree_too_low", "/to"
    if not isinstance(source, Splines):
        return None
    a, b = source.domain
    if not isinstance(target, Splines):
        inner = [i for i, knot in enumerate(source.given) if a < knot < b]
        return ("bad_knots", f"/from/knots/{inner[0]}") if inner else None
    c, d = target.domain
    if c < a or d > b:
        return "outside_domain", "/to/knots"
    for knot in source.given:
        smooth = source.degree - source.given.count(knot)
        if c < knot < d and target.degree - target.given.count(knot) > smooth:
            return "bad_knots", "/to/knots"
    return None


def refine(source, raise_by):
    """A spline space that contains another one, over the same domain."""
    knots = sorted(source.given + [knot for knot in set(source.given) for _ in range(raise_by)])
    a, b = source.domain
    degree = source.degree + raise_by
    for _ in range(rng.randint(0, 3)):
        knot = rng.choice([rng.choice(source.given), a + (b - a) * Fraction(rng.randint(1, 7), 8)])
        if a < knot < b and knots.count(knot) <= degree:
            knots = sorted([*knots, knot])
    # The domain of clamped ends stays; others are clamped to it.
    knots = [a] * (degree + 1) + [knot for knot in knots if a < knot < b] + [b] * (degree + 1)
    return Splines(degree, knots)


def matrix_case():
    degree = rng.randint(0, 4)
    kind = rng.randrange(6)
    if kind == 0:
        source, target = polynomial_basis(degree), polynomial_basis(degree + rng.choice([0, 0, 1, 3, -1 if degree else 0]))
    elif kind == 1:
        source, target = polynomial_basis(degree), knot_vector(degree + rng.choice([0, 1, 2]))
    elif kind == 2:
        source = knot_vector(degree)
        target = polynomial_basis(degree + rng.choice([0, 2]))
    elif kind == 3:
        source = Splines(degree, knots_of_one_span(degree))
        target = polynomial_basis(degree + rng.choice([0, 1]))
    elif kind == 4:
        source = knot_vector(degree)
        target = refine(source, rng.choice([0, 0, 1, 2]))
    else:
        source = knot_vector(degree)
        target = knot_vector(degree + rng.choice([0, 1]), source.domain if rng.random() < 0.8 else None)
    request = {"op": "basis-matrix", "from": source.json(), "to": target.json()}
    refusal = refusal_of_matrix(source, target)
    note("matrix refused" if refusal else "matrix given")

    def check(result):
        matrix = [fractions(row) for row in result["matrix"]]
        expect((len(matrix), {len(row) for row in matrix}), (target.count, {source.count}), request)
        places = [(target.knots[i] + target.knots[i + 1]) / 2 for i in target.spans] if isinstance(target, Splines) else None
        for t in places or [sum(source.domain) / 2 if isinstance(source, Splines) else Fraction(0)]:
            functions, given = target.at(t), source.at(t)
            for j in range(source.count):
                total = []
                for i in range(target.count):
                    total = plus(total, scaled(matrix[i][j], functions[i]))
                expect(trimmed(total), trimmed(given[j]), (request, t, j))

    ask("matrices", request, refusal or check)
    backwards = refusal_of_matrix(target, source)
    independent = not isinstance(source, Splines) or all(
        any(j <= span <= j + source.degree for span in source.spans) for j in range(source.count)
    )

    def check_inverse(result):
        note("inverse")
        matrix, inverse = [fractions(row) for row in result["matrix"]], [fractions(row) for row in result["inverse"]]
        unit = [[sum(a * b for a, b in zip(row, column)) for column in zip(*matrix)] for row in inverse]
        if independent:
            expect(unit, [[Fraction(int(i == j)) for j in range(source.count)] for i in range(source.count)], request)

    if not refusal:
        ask("matrices", request | {"inverse": True}, (backwards[0], "/inverse") if backwards else check_inverse)


def knots_of_one_span(degree):
    a, b = sorted(distinct(2))
    before = sorted([a - rng.choice([0, 1, 2]) for _ in range(degree)] + [a])
    after = sorted([b + rng.choice([0, 1, 2]) for _ in range(degree)] + [b])
    return before + after


# Interpolation


def point(dimension):
    return number() if dimension == 0 else [number() for _ in range(dimension)]


def coordinates(p):
    return p if isinstance(p, list) else [p]


def point_json(p):
    return texts(p) if isinstance(p, list) else str(p)


def bezier_coordinates(a_map):
    """The coordinates of a curve as polynomials."""
    a, b = fractions(a_map["interval"])
    points = [fractions(coordinates(p)) for p in a_map["control_points"]]
    n = len(points) - 1
    s, r = [-a / (b - a), 1 / (b - a)], [b / (b - a), -1 / (b - a)]
    basis = [scaled(comb(n, k), product([s] * k + [r] * (n - k))) for k in range(n + 1)]
    result = []
    for j in range(len(points[0])):
        total = []
        for k in range(n + 1):
            total = plus(total, scaled(points[k][j], basis[k]))
        result.append(total)
    return result


def repeated_nodes(count, choose):
    """Nodes with the order of the derivative that each stands for."""
    pool = [choose() for _ in range(rng.choice([1, 2, count, 2 * count]))]
    nodes = [rng.choice(pool) for _ in range(count)]
    return nodes, [nodes[:i].count(node) for i, node in enumerate(nodes)]


def curve_case():
    count = rng.randint(1, 7)
    dimension = rng.choice([0, 0, 1, 2])
    values = [point(dimension) for _ in range(count)]
    request = {"op": "interpolate", "values": [point_json(p) for p in values]}
    interval = distinct(2) if rng.random() < 0.4 else None
    if interval:
        request["interval"] = texts(interval)
    if rng.random() < 0.25:
        a, b = interval or (Fraction(0), Fraction(1))
        nodes, orders = [a + (b - a) * Fraction(i, max(1, count - 1)) for i in range(count)], [0] * count
    else:
        nodes, orders = repeated_nodes(count, number)
        request["nodes"] = texts(nodes)
    note("hermite data" if any(orders) else "lagrange data")

    def check(result):
        found = bezier_coordinates(result["map"])
        expect(len(result["map"]["control_points"]), count, request)
        for node, order, p in zip(nodes, orders, values):
            expect([value(derived(q, order), node) for q in found], coordinates(p), (request, node, order))

    ask("curves", request, check)


def solved(matrix, right):
    """By Gauss's elimination; None if the matrix is singular."""
    rows = [list(row) + list(extra) for row, extra in zip(matrix, right)]
    n = len(rows)
    for k in range(n):
        pivot = next((i for i in range(k, n) if rows[i][k]), None)
        if pivot is None:
            return None
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [entry / rows[k][k] for entry in rows[k]]
        for i in range(n):
            if i != k and rows[i][k]:
                factor = rows[i][k]
                rows[i] = [x - factor * y for x, y in zip(rows[i], rows[k])]
    return [row[n:] for row in rows]


def spline_nodes(splines):
    a, b = splines.domain
    choose = rng.randrange(4)
    if choose == 0 and splines.degree > 0:
        window = [splines.knots[j + 1 : j + splines.degree + 1] for j in range(splines.count)]
        nodes = [min(max(sum(w) / splines.degree, a), b) for w in window]
    elif choose == 1:
        nodes = [rng.choice([knot for knot in splines.knots if a <= knot <= b]) for _ in range(splines.count)]
    else:
        nodes = [a + (b - a) * Fraction(rng.randint(0, 12 * splines.count), 12 * splines.count) for _ in range(splines.count)]
    if choose == 3:
        nodes = [rng.choice(nodes) if rng.random() < 0.4 else node for node in nodes]
    rng.shuffle(nodes)
    return nodes, [nodes[:i].count(node) for i, node in enumerate(nodes)]


def spline_case():
    splines = knot_vector(rng.randint(0, 4))
    nodes, orders = spline_nodes(splines)
    dimension = rng.choice([0, 0, 2])
    values = [point(dimension) for _ in range(splines.count)]
    request = {"op": "interpolate", "degree": splines.degree, "knots": texts(splines.given), "nodes": texts(nodes)}
    request["values"] = [point_json(p) for p in values]
    matrix = [
        [value(derived(p, order), node) for p in splines.at(node)[: splines.count]] for node, order in zip(nodes, orders)
    ]
    points = solved(matrix, [coordinates(p) for p in values])
    note(("hermite splines " if any(orders) else "splines ") + ("determined" if points else "not determined"))

    def check(result):
        expect([fractions(coordinates(p)) for p in result["map"]["control_points"]], points, request)
        expect(result["map"]["knots"], texts(splines.given), request)

    ask("splines", request, check if points else ("missing_sample", "/nodes"))


def flattened(values, levels):
    return [values] if levels == 0 else [leaf for value in values for leaf in flattened(value, levels - 1)]


def nested(leaves, counts):
    if not counts:
        return next(leaves)
    return [nested(leaves, counts[1:]) for _ in range(counts[0])]


def indices_of(counts):
    return [()] if not counts else [(i, *rest) for i in range(counts[0]) for rest in indices_of(counts[1:])]


def grid_case():
    counts = [rng.randint(1, 4) for _ in range(rng.choice([1, 2, 2, 3]))]
    dimension = rng.choice([0, 0, 2])
    values = {index: point(dimension) for index in indices_of(counts)}
    request = {"op": "interpolate", "values": nested(iter([point_json(p) for p in values.values()]), counts)}
    intervals = [distinct(2) for _ in counts] if rng.random() < 0.5 else None
    if intervals:
        request["intervals"] = [texts(interval) for interval in intervals]
    if rng.random() < 0.3:
        request["degrees"] = [count - 1 for count in counts]
        ends = intervals or [(Fraction(0), Fraction(1))] * len(counts)
        nodes = [[a + (b - a) * Fraction(i, max(1, count - 1)) for i in range(count)] for count, (a, b) in zip(counts, ends)]
        orders = [[0] * count for count in counts]
    else:
        pairs = [repeated_nodes(count, number) for count in counts]
        nodes, orders = [pair[0] for pair in pairs], [pair[1] for pair in pairs]
        request["grid"] = [texts(list_of_nodes) for list_of_nodes in nodes]

    def check(result):
        a_map = result["map"]
        net = dict(zip(values, flattened(a_map["control_net"], len(counts))))
        factors = []
        for d, count in enumerate(counts):
            a, b = fractions(a_map["intervals"][d])
            s, r = [-a / (b - a), 1 / (b - a)], [b / (b - a), -1 / (b - a)]
            n = count - 1
            basis = [scaled(comb(n, k), product([s] * k + [r] * (n - k))) for k in range(count)]
            factors.append([[value(derived(p, order), x) for p in basis] for x, order in zip(nodes[d], orders[d])])
        for index, expected in values.items():
            total = [Fraction(0)] * len(coordinates(expected))
            for k, p in net.items():
                weight = Fraction(1)
                for d in range(len(counts)):
                    weight *= factors[d][index[d]][k[d]]
                total = [x + weight * Fraction(y) for x, y in zip(total, coordinates(p))]
            expect(total, coordinates(expected), (request, index))

    ask("grids", request, check)


def spline_grid_case():
    directions = [knot_vector(rng.randint(0, 2)) for _ in range(2)]
    if directions[0].count * directions[1].count > 60:
        return
    chosen = [spline_nodes(splines) for splines in directions]
    values = [[number() for _ in range(directions[1].count)] for _ in range(directions[0].count)]
    request = {"op": "interpolate", "degrees": [s.degree for s in directions], "knots": [texts(s.given) for s in directions]}
    request |= {"grid": [texts(nodes) for nodes, _ in chosen], "values": [texts(row) for row in values]}
    matrices = [
        [[value(derived(p, order), node) for p in s.at(node)[: s.count]] for node, order in zip(nodes, orders)]
        for s, (nodes, orders) in zip(directions, chosen)
    ]
    rows = solved(matrices[0], values)
    columns = solved(matrices[1], list(zip(*values)))
    if rows and columns:
        points = list(zip(*solved(matrices[1], list(zip(*rows)))))
        ask("grids", request, lambda result: expect([tuple(fractions(r)) for r in result["map"]["control_net"]], points, request))
    else:
        ask("grids", request, ("missing_sample", f"/grid/{0 if columns else 1}"))


def multi_indices(entries, total):
    if entries == 1:
        return [(total,)]
    return [(i, *rest) for i in range(total, -1, -1) for rest in multi_indices(entries - 1, total - i)]


def lattice_case():
    dimension, degree = rng.choice([(0, 2), (1, 4), (2, 0), (2, 1), (2, 3), (2, 5), (3, 2), (3, 3)])
    coordinate_count = rng.choice([0, 0, 2])
    indices = multi_indices(dimension + 1, degree)
    values = {index: point(coordinate_count) for index in indices}
    pairs = [[list(index), point_json(p)] for index, p in values.items()]
    rng.shuffle(pairs)
    request = {"op": "interpolate", "lattice": pairs}

    def check(result):
        a_map = result["map"]
        expect((a_map["kind"], a_map["degree"]), ("simplex", degree), request)
        for index, expected in values.items():
            x = [Fraction(i, degree) if degree else Fraction(int(k == 0)) for k, i in enumerate(index)]
            total = [Fraction(0)] * len(coordinates(expected))
            for exponents, p in a_map["control_net"]:
                weight = Fraction(factorial(degree))
                for i, base in zip(exponents, x):
                    weight *= base**i / factorial(i)
                total = [a + weight * Fraction(b) for a, b in zip(total, coordinates(p))]
            expect(total, coordinates(expected), (request, index))

    ask("lattices", request, check)


for _ in range(options.cases):
    for case in (basis_functions_case, single_case, matrix_case, curve_case, spline_case, grid_case, spline_grid_case, lattice_case):
        case()

lines = "".join(json.dumps(request) + "\n" for request in requests)
answers = subprocess.run([options.program, "batch"], input=lines, capture_output=True, text=True, check=False).stdout
responses = [json.loads(line) for line in answers.splitlines()]
assert len(responses) == len(requests), (len(responses), len(requests))
counts = {}
for request, response, (kind, check) in zip(requests, responses, checks):
    counts[kind] = counts.get(kind, 0) + 1
    if callable(check):
        if response["ok"]:
            check(response["result"])
        else:
            expect(response["error"], "an answer", request)
    else:
        error = response.get("error", {})
        expect((error.get("code"), error.get("at")), check, request)

wanted = ["matrix refused", "matrix given", "inverse", "hermite data", "lagrange data", "splines determined", "splines not determined"]
wanted += ["hermite splines determined", "hermite splines not determined"]
missing = [what for what in wanted if seen.get(what, 0) < options.cases // 30]
print(f"{len(requests)} cases ({counts}), {problems} problems", seen, missing)
sys.exit(1 if problems or missing else 0)
