#!/usr/bin/env python3
"""Holds `extrema`, `nearest`, `inflections`, cuts by lines and common roots against Sturm's theorem and narrow enclosures.

usage: check_curve_queries.py PROGRAM [CASES]
"""

import random
import sys
from fractions import Fraction

from real_roots_oracle import derivative, is_number, multiplicity_in, quotient, quotient_bounds, real_roots, without_factors_of
from spline_oracle import Report, ask, common_factor, pieces_of, plus, power, scaled, text_of, texts, times, trimmed, value

program = sys.argv[1]
CASES = int(sys.argv[2]) if len(sys.argv) > 2 else 300
choose = random.Random(19)
report = Report()
TINY = Fraction(1, 10**30)


def number():
    return choose.choice([Fraction(0), Fraction(1), Fraction(choose.randint(-4, 4)), Fraction(choose.randint(-9, 9), choose.randint(1, 4))])


def point(dimension):
    return [number() for _ in range(dimension)]


def points(count, dimension):
    kind = choose.random()
    first, step = point(dimension), point(dimension)
    if kind < 0.1:
        return [first] * count
    if kind < 0.25:  # on a line, with one parametrisation or another
        places = range(count) if choose.random() < 0.5 else [choose.randint(0, 4) for _ in range(count)]
        return [[x + k * y for x, y in zip(first, step)] for k in places]
    made = [point(dimension) for _ in range(count)]
    if kind < 0.5 and count > 2:  # repeated points make cusps and flat points
        made[1] = made[0] if choose.random() < 0.5 else made[1]
        made[-2] = made[-1] if choose.random() < 0.5 else made[-2]
    return made


def curve(dimension):
    """A map and its pieces (a, b, homogeneous polynomials)."""
    kind = choose.choice(["polynomial", "bezier", "bezier", "rational", "bspline", "bspline", "nurbs"])
    written = (lambda p: text_of(p[0])) if dimension == 1 else texts
    if kind == "polynomial":
        coordinates = [trimmed(number() for _ in range(choose.randint(1, 5))) for _ in range(dimension)]
        length = max([1, *(len(p) for p in coordinates)])
        rows = [[p[k] if k < len(p) else Fraction(0) for p in coordinates] for k in range(length)]
        return {"kind": "polynomial", "coefficients": [written(row) for row in rows]}, [(None, None, [*coordinates, [Fraction(1)]])]
    if kind in ("bezier", "rational"):
        n = choose.randint(1, 4)
        a_map = {"kind": "bezier", "control_points": [written(p) for p in points(n + 1, dimension)]}
        if choose.random() < 0.3:
            a_map["interval"] = choose.choice([["-1", "1"], ["1", "0"], ["1/2", "3"]])
    else:
        n = choose.randint(1, 3)
        inner = [Fraction(k) for k in range(1, choose.randint(2, 4)) for _ in range(choose.randint(1, n))]
        last = (inner[-1] if inner else Fraction(0)) + 1
        knots = [Fraction(0)] * (n + 1) + inner + [last] * (n + 1)
        a_map = {"kind": "bspline", "degree": n, "knots": texts(knots), "control_points": [written(p) for p in points(len(knots) - n - 1, dimension)]}
    if kind in ("rational", "nurbs"):
        a_map["weights"] = [str(choose.randint(1, 3)) for _ in a_map["control_points"]]
    pieces = pieces_of(a_map)
    if "weights" not in a_map:
        pieces = [(a, b, [*polynomials, [Fraction(1)]]) for a, b, polynomials in pieces]
    return a_map, [(a, b, reduced(polynomials)) for a, b, polynomials in pieces]


def reduced(polynomials):
    common = common_factor(polynomials)
    return [quotient(p, common) for p in polynomials]


def inside(root, a, b, closed):
    """Whether an enclosure is in [a, b), or in [a, b]."""
    if a is not None and root[1] < a:
        return False
    return b is None or root[1] < b or (closed and root[1] == b)


def roots_of_pieces(pieces, function):
    """(root, multiplicity, piece) and the ranges where the function is 0 of a function of the pieces."""
    found, zeros = [], []
    for i, piece in enumerate(pieces):
        a, b, polynomials = piece
        p = function(polynomials)
        if not p:
            if zeros and zeros[-1][1] == a:
                zeros[-1][1] = b
            else:
                zeros.append([a, b])
            continue
        for root in real_roots(p):
            if inside(root, a, b, i == len(pieces) - 1) and not (zeros and root == (zeros[-1][1], zeros[-1][1])):
                found.append((root, multiplicity_in(p, root), piece))
    return found, zeros


def end_text(t, infinity):
    return infinity if t is None else text_of(t)


def ranges(zeros):
    return [[end_text(a, "-inf"), end_text(b, "inf")] for a, b in zeros]


def is_point(given, polynomials, root):
    *coordinates, weight = polynomials
    return len(given) == len(coordinates) and all(is_number(x, quotient_bounds(p, weight, root)) for x, p in zip(given, coordinates))


def combination(polynomials, numbers):
    total = []
    for p, factor in zip(polynomials, numbers):
        total = plus(total, scaled(p, factor))
    return total


def check_cut(request, pieces, result):
    line = [Fraction(x) for x in request["line"]]
    expected, zeros = roots_of_pieces(pieces, lambda polynomials: without_factors_of(combination(polynomials, line), polynomials[-1]))
    found = result["intersections"]
    overlaps = [[end if isinstance(end, str) else end["value"] for end in o["intervals"][0]] for o in result.get("overlaps", [])]
    report.expect(overlaps == ranges(zeros), "overlaps", zeros, result, request)
    report.expect(len(found) == len(expected), "number of cuts", expected, result, request)
    for cut, (root, multiplicity, piece) in zip(found, expected):
        report.expect(is_number(cut["parameters"][0], root) and cut["multiplicity"] == multiplicity, "cut", root, multiplicity, cut, request)
        report.expect(is_point(cut["point"], piece[2], root), "point of a cut", cut, request)
    return len(found)


def check_common(request, pieces, result, others):
    def function(polynomials):
        return without_factors_of(common_factor([polynomials[0], *others]), polynomials[-1])

    expected, zeros = roots_of_pieces(pieces, function)
    found = result["roots"]
    report.expect(result.get("zeros", []) == ranges(zeros), "common zeros", zeros, result, request)
    report.expect(len(found) == len(expected), "number of common roots", expected, result, request)
    for root, (where, multiplicity, _) in zip(found, expected):
        report.expect(is_number(root, where) and root["multiplicity"] == multiplicity, "common root", where, root, request)
    return len(found)


def sign(x):
    return (x > 0) - (x < 0)


def sign_beside(p, t, side):
    factor = 1
    while p:
        if value(p, t):
            return factor * sign(value(p, t))
        p, factor = derivative(p), factor * side
    return 0


def check_extrema(request, pieces, result, functions):
    """functions: (a, b, numerator, denominator)"""
    candidates, constant, infinite = [], [], []
    for a, b, p, q in functions:
        slope = plus(times(derivative(p), q), scaled(times(p, derivative(q)), -1))

        def at(t, p=p, q=q):
            return value(p, t) / value(q, t)

        if not slope:
            x = value(p, Fraction(0)) / value(q, Fraction(0)) if a is None else at(a)
            if constant and constant[-1][1] == a and constant[-1][2] == x:
                constant[-1][1] = b
            else:
                constant.append([a, b, x])
            ends = [(a, None, 0), (b, 0, None)]
        else:
            inner = [r for r in real_roots(slope) if (a is None or r[0] > a) and (b is None or r[1] < b)]
            signs = []
            last = sign_beside(slope, a, 1) if a is not None else sign(value(slope, min([Fraction(0), *(r[0] for r in inner)]) - 1))
            signs.append(last)
            for r in inner:
                last = -last if multiplicity_in(slope, r) % 2 else last
                signs.append(last)
            ends = [(a, None, signs[0]), (b, signs[-1], None)]
        if a is None:
            limit = None if len(p) > len(q) else (p[-1] / q[-1] if len(p) == len(q) else Fraction(0))
            infinite += [(limit, -ends[0][2]), (limit, ends[1][1])]
            if not slope:
                infinite = []
        elif candidates and candidates[-1][0] == (a, a) and candidates[-1][3] is None and candidates[-1][1] == (at(a), at(a)):
            candidates[-1][3] = ends[0][2]
        else:
            candidates.append([(a, a), (at(a), at(a)), None, ends[0][2]])
        if slope:
            for r, before, behind in zip(inner, signs, signs[1:]):
                candidates.append([r, quotient_bounds(p, q, r), before, behind])
        if b is not None:
            candidates.append([(b, b), (at(b), at(b)), ends[1][1], None])
    expected = []
    for place, x, before, behind in candidates:
        before, behind = (0, 0) if before == behind == 0 else (before, behind)
        if before in (None, -1) and behind in (None, 1):
            expected.append(("minimum", place, x))
        elif before in (None, 1) and behind in (None, -1):
            expected.append(("maximum", place, x))
    if "extrema" in result:
        report.expect(len(expected) == len(result["extrema"]), "number of extrema", expected, result, request)
        for (kind, place, x), given in zip(expected, result["extrema"]):
            right = given["kind"] == kind and is_number(given["parameter"], place) and is_number(given["value"], x)
            report.expect(right, "extremum", kind, place, given, request)
        report.expect(result.get("constant", []) == ranges([c[:2] for c in constant]), "constant", constant, result, request)
    for name, side in (("least", -1), ("greatest", 1)):
        if name not in request["sides"]:
            continue
        values = [x for _, x, _, _ in candidates] + [(c[2], c[2]) for c in constant]
        best = min(values, key=lambda x: -side * x[0], default=None)
        bounded = best is not None and all(falls != side or (limit is not None and side * (limit - best[0]) <= TINY) for limit, falls in infinite)
        given = result.get(name)
        report.expect((given is not None) == bounded, "whether there is the", name, result, request)
        if given is None:
            continue
        report.expect(is_number(given["value"], best), name, best, given, request)
        same = [c for c in constant if abs(c[2] - best[0]) < TINY]
        places = []
        for place, x, _, _ in candidates:
            covered = any(a is None or a <= place[0] <= b for a, b, _ in same)
            if abs(x[0] - best[0]) < TINY and not covered and place not in places:
                places.append(place)
        report.expect(given.get("constant", []) == ranges([c[:2] for c in same]), name, "constant", given, request)
        right = len(places) == len(given["parameters"]) and all(is_number(t, place) for t, place in zip(given["parameters"], places))
        report.expect(right, "places of the", name, places, given, request)
    return len(expected)


def velocity(polynomials):
    *coordinates, weight = polynomials
    return [plus(times(derivative(p), weight), scaled(times(p, derivative(weight)), -1)) for p in coordinates]


def bending(polynomials):
    x, y = velocity(polynomials)
    return plus(times(x, derivative(y)), scaled(times(y, derivative(x)), -1))


def order_at(p, root):
    return multiplicity_in(p, root) if len(p) > 1 else 0


def check_inflections(request, pieces, result):
    expected, straight = [], []
    for i, (a, b, polynomials) in enumerate(pieces):
        p = without_factors_of(bending(polynomials), polynomials[-1])
        stops = common_factor(velocity(polynomials))
        if not p:
            if straight and straight[-1][1] == a:
                straight[-1][1] = b
            else:
                straight.append([a, b])
        roots = [r for r in real_roots(p) if inside(r, a, b, i == len(pieces) - 1)] if p else []
        if i > 0 and pieces[i - 1][1] == a:
            multiplicity = multiplicity_in(p, (a, a)) if p and value(p, a) == 0 else 0
            roots = [r for r in roots if r != (a, a)]
            before = pieces[i - 1][2]
            q = bending(before)
            incoming, outgoing = ([value(c, a) for c in velocity(v)] for v in (before, polynomials))
            left, right = ([value(c, a) / value(v[-1], a) for c in v[:-1]] for v in (before, polynomials))
            cross = incoming[0] * outgoing[1] - incoming[1] * outgoing[0]
            dot = incoming[0] * outgoing[0] + incoming[1] * outgoing[1]
            if multiplicity and value(stops, a) == 0:
                expected.append(("cusp" if order_at(stops, (a, a)) % 2 else "singular", (a, a), multiplicity))
            elif p and q and left == right and cross == 0 and dot > 0:
                if sign_beside(q, a, -1) != sign_beside(bending(polynomials), a, 1):
                    expected.append(("inflection", (a, a), multiplicity))
                elif multiplicity:
                    expected.append(("flat", (a, a), multiplicity))
        for r in roots:
            multiplicity = multiplicity_in(p, r)
            order = order_at(stops, r)
            kind = ("cusp" if order % 2 else "singular") if order else ("inflection" if multiplicity % 2 else "flat")
            expected.append((kind, r, multiplicity))
    found = result["inflections"]
    report.expect(result.get("straight", []) == ranges(straight), "straight", straight, result, request)
    report.expect(len(found) == len(expected), "number of inflections", expected, result, request)
    for given, (kind, root, multiplicity) in zip(found, expected):
        right = given["kind"] == kind and given["multiplicity"] == multiplicity and is_number(given["parameter"], root)
        report.expect(right, "inflection", kind, root, multiplicity, given, request)
    return len(found)


def make_case():
    op = choose.choice(["cut", "cut", "common", "extrema", "extrema", "nearest", "nearest", "inflections", "inflections"])
    dimension = {"cut": choose.choice([1, 2, 2, 3]), "common": 1, "extrema": choose.choice([1, 2]), "nearest": choose.choice([1, 2, 2, 3]), "inflections": 2}[op]
    a_map, pieces = curve(dimension)
    if op == "cut":
        line = point(dimension + 1)
        a, _, polynomials = choose.choice(pieces)
        if choose.random() < 0.5 and any(line[:-1]):  # through a point of the curve
            t = Fraction(1, 2) if a is None else a
            line[-1] = -sum(x * value(p, t) for x, p in zip(line, polynomials[:-1])) / value(polynomials[-1], t)
        return {"op": "intersections", "map": a_map, "line": texts(line)}, pieces, None
    if op == "common":
        others = [times(pieces[0][2][0], [number(), Fraction(1)]) or [Fraction(1), Fraction(0), Fraction(1)], power([-number(), Fraction(1)], 2)]
        others = choose.choice([others, others[:1], [others[0], times(others[0], others[1])]])
        maps = [{"kind": "polynomial", "coefficients": texts(p) or ["0"]} for p in others]
        return {"op": "roots", "map": a_map, "with": maps}, pieces, others
    if op == "extrema":
        direction = point(dimension)
        request = {"op": "extrema", "map": a_map, "direction": texts(direction)}
        return request, pieces, [(a, b, combination(polynomials, direction), polynomials[-1]) for a, b, polynomials in pieces]
    if op == "nearest":
        to = point(dimension)
        a, _, polynomials = choose.choice(pieces)
        if choose.random() < 0.3:  # a point of the curve
            t = Fraction(1, 3) if a is None else a
            to = [value(p, t) / value(polynomials[-1], t) for p in polynomials[:-1]]
        functions = []
        for a, b, polynomials in pieces:
            total = []
            for p, x in zip(polynomials, to):
                total = plus(total, power(plus(p, scaled(polynomials[-1], -x)), 2))
            functions.append((a, b, total, power(polynomials[-1], 2)))
        return {"op": "nearest", "map": a_map, "point": texts(to)}, pieces, functions
    return {"op": "inflections", "map": a_map}, pieces, None


cases = [make_case() for _ in range(CASES)]
found = {}
for (request, pieces, extra), response in zip(cases, ask(program, [request for request, _, _ in cases])):
    if not response["ok"]:
        report.expect(False, "refused", request, response)
        continue
    result, op = response["result"], request["op"]
    a, b = pieces[0][0], pieces[-1][1]
    report.expect(result["interval"] == ranges([[a, b]])[0], "interval", result, request)
    if op == "intersections":
        count = check_cut(request, pieces, result)
    elif op == "roots":
        count = check_common(request, pieces, result, extra)
    elif op == "extrema":
        count = check_extrema({**request, "sides": ["least", "greatest"]}, pieces, result, extra)
    elif op == "nearest":
        least = {"interval": result["interval"]}
        if "squared_distance" in result:
            least["least"] = {"value": result["squared_distance"], "parameters": [n["parameter"] for n in result["nearest"]], "constant": result.get("constant", [])}
            for nearest in result["nearest"]:
                t = nearest["parameter"]
                if "value" in t:
                    t = Fraction(t["value"])
                    near = [[value(p, t) / value(polynomials[-1], t) for p in polynomials[:-1]] for a, b, polynomials in pieces if a is None or a <= t <= b]
                    given = [Fraction(x.get("value", "1/0" if "value" not in x else "0")) for x in nearest["point"]]
                    report.expect(given in near, "nearest point", nearest, request)
        count = check_extrema({**request, "sides": ["least"]}, pieces, least, extra)
        count = len(result.get("nearest", []))
    else:
        count = check_inflections(request, pieces, result)
    found[op] = found.get(op, 0) + count

assert all(found.get(op, 0) > CASES / 40 for op in ["intersections", "roots", "extrema", "nearest", "inflections"]), found
print(f"{len(cases)} cases, {found}, {report.problems} problems")
sys.exit(1 if report.problems else 0)
