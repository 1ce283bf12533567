#!/usr/bin/env python3
"""Holds the operations that change the knots, ends and parameters of curves against the definition of a spline and of its blossom.

usage: check_spline_changes.py PROGRAM
"""

import random
import sys
from fractions import Fraction
from itertools import combinations
from math import comb, prod

from spline_oracle import Report, ask, composed, control_points, order_of_contact, pieces_of, points_of, same_pieces, scaled, text_of, textbook_knots, texts

CASES = 1400

program = sys.argv[1]
choose = random.Random(11)
report = Report()


def number():
    return choose.choice([Fraction(0), Fraction(1), Fraction(-2), Fraction(choose.randint(-9, 9), choose.randint(1, 5))])


def weight():
    return Fraction(choose.randint(1, 4), choose.randint(1, 3))


def with_points(a_map, points, scalar, rational):
    a_map["control_points"] = [text_of(p[0]) if scalar else texts(p) for p in points]
    if rational:
        a_map["weights"] = texts([weight() for _ in points])
    return a_map


def spline():
    """Knots of any multiplicities inside, and clamped or any others at the ends, in either convention."""
    n = choose.randint(0, 3)
    t = Fraction(choose.randint(-2, 2))
    inner = []
    for _ in range(choose.choice([0, 1, 1, 2])):
        t += Fraction(choose.randint(1, 3), choose.randint(1, 2))
        inner += [t] * choose.randint(1, n + 1)
    begin = (inner[0] if inner else t) - Fraction(choose.randint(1, 3), 2)
    end = t + Fraction(choose.randint(1, 3), 2)
    outside = n if n == 0 or choose.random() < 0.7 else n - 1

    def ends(t, direction):
        knots = [t] * choose.choice([1, 1, outside + 1])
        while len(knots) < outside + 1:
            knots.append(knots[-1] + direction * choose.choice([0, 1, 1]) * Fraction(1, 2))
        return knots

    knots = ends(begin, -1)[::-1] + inner + ends(end, 1)
    if any(knots.count(t) > n + 1 for t in knots):
        return spline()
    points = len(knots) - n - 1 if outside == n else len(knots) - n + 1
    scalar, rational = choose.random() < 0.5, choose.random() < 0.4
    dimension = 1 if scalar else choose.randint(1, 2)
    a_map = {"kind": "bspline", "degree": n, "knots": texts(knots)}
    return with_points(a_map, [[number() for _ in range(dimension)] for _ in range(points)], scalar, rational)


def bezier():
    a = number()
    b = a + choose.choice([-1, 1]) * Fraction(choose.randint(1, 4), choose.randint(1, 3))
    points = [[number()] for _ in range(choose.randint(1, 4))]
    return with_points({"kind": "bezier", "interval": texts([a, b])}, points, choose.random() < 0.5, choose.random() < 0.4)


def rational_of(a_map):
    return "weights" in a_map


def is_polar(a_map):
    return len(a_map["knots"]) == len(a_map["control_points"]) + a_map["degree"] - 1


def domain(a_map):
    pieces = pieces_of(a_map)
    return pieces[0][0], pieces[-1][1]


def blossom(p, n, arguments):
    """Of the polynomial of formal degree n: t^k stands for the mean of the products of k arguments."""
    return sum((a * sum(prod(chosen, start=Fraction(1)) for chosen in combinations(arguments, k)) / comb(n, k) for k, a in enumerate(p)), Fraction(0))


def check_points(what, request, a_map, pieces):
    """Every control point is the blossom value at its window, of each piece on which it has influence."""
    n, knots = a_map["degree"], textbook_knots(a_map)
    for j, point in enumerate(points_of(a_map)):
        window = knots[j + 1 : j + n + 1]
        for a, b, polynomials in pieces:
            if any(knots[i] <= a < b <= knots[i + 1] for i in range(max(j, n), min(j + n + 1, len(knots) - n - 1))):
                found = [blossom(p, n, window) for p in polynomials]
                report.expect(found == point, what, "blossom values", j, found, point, request)


def check_clamped(what, request, a_map):
    knots = [Fraction(t) for t in a_map["knots"]]
    count = a_map["degree"] + (0 if is_polar(a_map) else 1)
    a, b = domain(a_map)
    report.expect(knots.count(a) == knots.count(b) == count and knots[0] == a and knots[-1] == b, what, "not clamped", a_map, request)


def part_of(pieces, a, b):
    return [(max(a, c), min(b, d), p) for c, d, p in pieces if max(a, c) < min(b, d)]


def moved(pieces, change, back):
    """The pieces at other parameters: change(t) for t, and back, its inverse as a polynomial."""
    result = [(*sorted([change(a), change(b)]), [composed(p, back) for p in polynomials]) for a, b, polynomials in pieces]
    return sorted(result, key=lambda piece: piece[0])


def affine(from_, to):
    slope = (to[1] - to[0]) / (from_[1] - from_[0])
    return (lambda t: to[0] + slope * (t - from_[0])), [from_[0] - to[0] / slope, 1 / slope]


def clamp():
    a_map = spline()

    def check(request, result):
        check_clamped("clamp", request, result["map"])
        report.expect(is_polar(result["map"]) == is_polar(a_map), "clamp: convention", request)
        return result["map"], pieces_of(a_map)

    return {"op": "clamp", "map": a_map}, check


def trim():
    a_map = choose.choice([spline, spline, bezier])()
    a, b = domain(a_map)
    ends = sorted([a + (b - a) * Fraction(choose.randint(0, 6), 6) for _ in range(2)])
    if ends[0] == ends[1]:
        ends = [a, b]
    if a_map["kind"] == "bspline" and choose.random() < 0.4:
        inner = sorted({Fraction(t) for t in a_map["knots"] if a < Fraction(t) < b})
        ends[0] = choose.choice([a, *[t for t in inner if t < ends[1]]])

    def check(request, result):
        if a_map["kind"] == "bspline":
            check_clamped("trim", request, result["map"])
        return result["map"], part_of(pieces_of(a_map) if a_map["kind"] == "bspline" else [(*ends, pieces_of(a_map)[0][2])], *ends)

    return {"op": "trim", "map": a_map, "interval": texts(ends)}, check


def reverse():
    a_map = choose.choice([spline, bezier])()
    a, b = domain(a_map)

    def check(request, result):
        report.expect(result["map"].get("interval") == a_map.get("interval"), "reverse: interval", request, result)
        return result["map"], moved(pieces_of(a_map), *affine((a, b), (b, a)))

    return {"op": "reverse", "map": a_map}, check


def reparametrise():
    a_map = choose.choice([spline, bezier])()
    from_ = domain(a_map)
    if "interval" in a_map:
        from_ = tuple(Fraction(t) for t in a_map["interval"])
    request = {"op": "reparametrise", "map": a_map}
    to = (Fraction(0), Fraction(1))
    if choose.random() < 0.8:
        c = number()
        to = (c, c + choose.choice([-1, 1, 1]) * weight())
        request["interval"] = texts(to)
    if choose.random() < 0.4:
        c = number()
        from_ = (c, c - choose.choice([-1, 1]) * weight())
        request["from"] = texts(from_)

    def check(request, result):
        return result["map"], moved(pieces_of(a_map), *affine(from_, to))

    return request, check


def raise_multiplicity():
    a_map = spline()
    a, b = domain(a_map)
    n = a_map["degree"]
    knots = [choose.choice([Fraction(t) for t in a_map["knots"] if a <= Fraction(t) <= b] + [(a + b) / 2]) for _ in range(choose.randint(1, 3))]
    m = choose.randint(0, n + 1)

    def check(request, result):
        old = [Fraction(t) for t in a_map["knots"]]
        for t in knots:
            old += [t] * (m - old.count(t))
        report.expect([Fraction(t) for t in result["map"]["knots"]] == sorted(old), "multiplicity", request, result)
        return result["map"], pieces_of(a_map)

    return {"op": "insert-knots", "map": a_map, "knots": texts(knots), "multiplicity": m}, check


def split():
    a_map = spline()
    a, b = domain(a_map)
    at = choose.choice([(a + b) / 2, *[Fraction(t) for t in a_map["knots"] if a < Fraction(t) < b]])

    def check(request, result):
        left, right = result["maps"]
        for half, ends in ((left, (a, at)), (right, (at, b))):
            check_clamped("split", request, half)
            report.expect(same_pieces(pieces_of(half), part_of(pieces_of(a_map), *ends), False), "split: another map", request, half)
        return left, part_of(pieces_of(a_map), a, at)

    return {"op": "subdivide", "map": a_map, "at": text_of(at), "clamped": True}, check


def closed_spline():
    """Over periodic knots; then, where its pieces are given by their own control points, with any factors of rational ones."""
    n = choose.randint(1, 3)
    cycle = []
    t = Fraction(choose.randint(-1, 1))
    for _ in range(choose.randint(1, 3)):
        cycle += [t] * choose.choice([1, 1, choose.randint(1, n)])
        t += Fraction(choose.randint(1, 3), choose.randint(1, 2))
    period, m = t - cycle[0], cycle.count(cycle[0])
    start = m - 1

    def knot(i):
        return cycle[i % len(cycle)] + (i // len(cycle)) * period

    end = next(i for i in range(start + 1, 99) if knot(i) == cycle[0] + period)
    knots = [knot(i) for i in range(start - n, end + n + 1)]
    scalar, rational = choose.random() < 0.5, choose.random() < 0.5
    repeated = [[number()] for _ in cycle]
    points = [repeated[j % len(cycle)] for j in range(len(knots) - n - 1)]
    a_map = with_points({"kind": "bspline", "degree": n, "knots": texts(knots)}, points, scalar, False)
    if rational:
        weights = [weight() for _ in cycle]
        a_map["weights"] = texts([weights[j % len(cycle)] for j in range(len(points))])
    if choose.random() < 0.5:
        return a_map
    own_points, own_weights, own_knots = [], [], [Fraction(t) for t in [knots[n]] * (n + 1)]
    for a, b, polynomials in pieces_of(a_map):
        factor = weight() if rational else 1
        rows = [control_points(scaled(p, factor), n, a, b) for p in polynomials]
        if rational:
            own_weights += rows[-1]
            rows = [[x / w for x, w in zip(row, rows[-1])] for row in rows[:-1]]
        own_points += zip(*rows)
        own_knots += [b] * (n + 1)
    result = with_points({"kind": "bspline", "degree": n, "knots": texts(own_knots)}, own_points, scalar, False)
    if rational:
        result["weights"] = texts(own_weights)
    return result


def seam(a_map):
    pieces = pieces_of(a_map)
    a, b = pieces[0][0], pieces[-1][1]
    first = [composed(p, [a - b, Fraction(1)]) for p in pieces[0][2]]
    return order_of_contact(pieces[-1][2], first, b, rational_of(a_map)), b


def order_text(order):
    return "infinite" if order is None else order


def periodic():
    a_map = closed_spline() if choose.random() < 0.85 else spline()
    order, _ = seam(a_map)
    if order == -1:
        return {"op": "periodic", "map": a_map}, "not_continuous"

    def check(request, result):
        made = result["map"]
        n, knots = made["degree"], [Fraction(t) for t in made["knots"]]
        a, b = domain(made)
        m = knots.count(a)
        points = made["control_points"]
        count = sum(a < t < b for t in knots) + m
        report.expect(result["order"] == order_text(order), "periodic: order", order, request, result)
        if not rational_of(made):
            report.expect(m == (1 if order is None else n - order), "periodic: seam", order, request, result)
        report.expect(all(t + b - a == u for t, u in zip(knots, knots[count:])), "periodic: knots", request, result)
        report.expect(points[count:] == points[: n + 1 - m] and len(points) == count + n + 1 - m, "periodic: points", request, result)
        return made, pieces_of(a_map)

    return {"op": "periodic", "map": a_map}, check


def seam_order():
    a_map = choose.choice([closed_spline, spline])()
    order, _ = seam(a_map)

    def check(request, result):
        report.expect(result["order"] == order_text(order), "seam", order, request, result)
        return None

    return {"op": "continuity", "map": a_map, "at": "seam"}, check


makers = [clamp, trim, reverse, reparametrise, raise_multiplicity, split, periodic, seam_order]
cases = [makers[i % len(makers)]() for i in range(CASES)]
refused = 0
for (request, check), response in zip(cases, ask(program, [request for request, _ in cases])):
    if not response["ok"]:
        refused += 1
        code = response["error"]["code"]
        report.expect(code == check or (code == "zero_weight" and rational_of(request["map"])), "refused", request, response)
        continue
    report.expect(callable(check), "not refused", request, response)
    checked = check(request, response["result"]) if callable(check) else None
    if not checked:
        continue
    made, pieces = checked
    rational = rational_of(made)
    report.expect(same_pieces(pieces_of(made), pieces, rational), request["op"], "another map", request, made)
    if made["kind"] == "bspline" and (not rational or request["op"] != "periodic"):
        check_points(request["op"], request, made, pieces)

assert refused < CASES / 8, refused
print(f"{len(cases)} cases, {refused} refused, {report.problems} problems")
sys.exit(1 if report.problems else 0)
