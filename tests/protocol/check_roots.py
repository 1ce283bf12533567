#!/usr/bin/env python3
"""Holds `roots` against Sturm's theorem: how many roots there are, where, how often, and their nearest doubles.

usage: check_roots.py PROGRAM
"""

import math
import random
import sys
from fractions import Fraction

from real_roots_oracle import Sturm, multiplicity_in, neighbours, quotient
from spline_oracle import Report, ask, common_factor, control_points, pieces_of, power, text_of, texts, times, value

CASES = 1200

program = sys.argv[1]
choose = random.Random(27)
report = Report()


def number():
    return choose.choice([Fraction(0), Fraction(1), Fraction(choose.randint(-9, 9), choose.randint(1, 5)), Fraction(choose.randint(-99, 99), 32)])


def polynomial(centre=0):
    p = [choose.choice([Fraction(1), Fraction(-2), Fraction(1, 3)])]
    for _ in range(choose.randint(0, 3)):
        r = centre + number()
        factor = choose.choice(
            [
                [-r, Fraction(1)],
                [r * r - choose.choice([2, 3, Fraction(1, 7), Fraction(2, 10**40)]), -2 * r, Fraction(1)],
                [r * r + 1, -2 * r, Fraction(1)],
                [Fraction(-2), Fraction(0), Fraction(0), choose.choice([Fraction(1), Fraction(10) ** 30, Fraction(1, 10**30)])],
            ]
        )
        p = times(p, power(factor, choose.choice([1, 1, 1, 2, 3])))
    return p


def request_of_polynomial():
    p = polynomial()
    a_map = {"kind": "polynomial", "coefficients": texts(p)}
    if choose.random() < 0.3:
        a_map["denominator"] = ["1", "0", "1"]
        common = common_factor([p, [Fraction(1), Fraction(0), Fraction(1)]])
        p = quotient(p, common)
    request = {"op": "roots", "map": a_map}
    ends = [-math.inf, math.inf]
    if choose.random() < 0.7:
        ends = sorted([choose.choice([-math.inf, number()]), choose.choice([math.inf, number()])])
        if ends[0] == ends[1]:
            ends[1] += 1
        shown = ends if choose.random() < 0.8 else [ends[1], ends[0]]
        request["interval"] = [text_of(t) if math.isfinite(t) else str(t) for t in shown]
    return request, [(ends[0], ends[1], p, True)], ends


def request_of_spline():
    n = 3
    knots, points = [Fraction(choose.randint(-2, 2))], []
    for _ in range(choose.randint(1, 4)):
        a, b = knots[-1], knots[-1] + Fraction(choose.randint(1, 3), choose.randint(1, 2))
        p = choose.choice([[], polynomial(a), [-a, Fraction(1)], [-b, Fraction(1)], [-(a + b) / 2, Fraction(1)], power([-b, Fraction(1)], 2)])
        if len(p) > n + 1:
            p = []
        points += control_points(p, n, a, b)
        knots.append(b)
    a_map = {"kind": "bspline", "degree": n, "knots": texts([t for t in knots for _ in range(n + 1)]), "control_points": texts(points)}
    request = {"op": "roots", "map": a_map}
    low, high = knots[0], knots[-1]
    if choose.random() < 0.6:
        low, high = sorted(choose.sample([*knots, knots[0] - 1, knots[-1] + 1, knots[0] + Fraction(1, 2)], 2))
        if low == high:
            high += 1
        request["interval"] = texts([low, high])
    pieces = []
    for i, (a, b, (p,)) in enumerate(pieces_of(a_map)):
        begin, end = max(a, low), min(b, high)
        closed = end < b or i == len(knots) - 2
        if begin < end or (begin == end and closed):
            pieces.append((begin, end, p, closed))
    ends = [max(low, knots[0]), min(high, knots[-1])]
    return request, pieces, ends if ends[0] <= ends[1] else [low, high]


def check_root(request, root, p):
    count = Sturm(p)
    low, high = neighbours(float(root["double"]))
    if "value" in root:
        t = Fraction(root["value"])
        report.expect(value(p, t) == 0 and low <= t <= high, "value", root, request)
        report.expect(multiplicity_in(p, (t, t)) == root["multiplicity"], "multiplicity", root, request)
        return t, t
    a, b = (Fraction(t) for t in root["interval"])
    report.expect(value(p, a) != 0 != value(p, b) and count.between(a, b) == 1, "interval", root, request)
    report.expect(count.between(max(a, low), min(b, high)) == 1, "double", root, request)
    report.expect(multiplicity_in(p, (a, b)) == root["multiplicity"], "multiplicity", root, request)
    return a, b


cases = [request_of_polynomial() if i % 2 else request_of_spline() for i in range(CASES)]
found_roots = found_zeros = 0
for (request, pieces, ends), response in zip(cases, ask(program, [request for request, _, _ in cases])):
    if not response["ok"]:
        report.expect(False, "refused", request, response)
        continue
    result = response["result"]
    said = [float(t) if "inf" in t else Fraction(t) for t in result["interval"]]
    report.expect(said == ends, "said interval", ends, result, request)
    zeros = []
    for a, b, p, _ in pieces:
        if not p and zeros and zeros[-1][1] == a:
            zeros[-1][1] = b
        elif not p:
            zeros.append([a, b])
    report.expect([[Fraction(t) for t in interval] for interval in result.get("zeros", [])] == zeros, "zeros", zeros, result, request)
    found_zeros += len(zeros)
    rest = list(result["roots"])
    last = None
    for a, b, p, closed in pieces:
        if not p:
            continue
        count = Sturm(p)
        number_of_roots = count.between(a, b) if a != b else 0
        if math.isfinite(a) and value(p, a) == 0 and not any(zero[1] == a for zero in zeros):
            number_of_roots += 1
        if a != b and not closed and value(p, b) == 0:
            number_of_roots -= 1
        own, rest = rest[:number_of_roots], rest[number_of_roots:]
        report.expect(len(own) == number_of_roots, "number of roots", number_of_roots, result, request)
        for root in own:
            low, high = check_root(request, root, p)
            report.expect(last is None or last <= low, "order", result, request)
            last = high
            found_roots += 1
    report.expect(not rest, "more roots", rest, request)

assert found_roots > CASES / 2 and found_zeros > CASES / 10
print(f"{len(cases)} cases, {found_roots} roots, {found_zeros} intervals of zeros, {report.problems} problems")
sys.exit(1 if report.problems else 0)
