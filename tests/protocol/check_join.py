#!/usr/bin/env python3
"""Holds `join` against the definitions of its parts, and against `continuity`, which must say the same of every knot.

usage: check_join.py PROGRAM
"""

import random
import sys
from fractions import Fraction

from spline_oracle import (
    Report,
    ask,
    common_factor,
    composed,
    control_points,
    order_of_contact,
    pieces_of,
    plus,
    power,
    same_pieces,
    scaled,
    series,
    text_of,
    texts,
    times,
)

CASES = 1200

program = sys.argv[1]
choose = random.Random(19)
report = Report()


def number():
    return choose.choice([Fraction(0), Fraction(1), Fraction(-1), Fraction(choose.randint(-9, 9), choose.randint(1, 5))])


def next_piece(piece, s, n, rational):
    """A curve of degree at most n that meets `piece` at s: as one curve, with some order, or not."""
    kind = choose.choice(["same", "order", "order", "jump", "other"])
    if kind == "jump" or kind == "other":
        return first_piece(n, len(piece), rational)
    if kind == "same":
        return piece
    k = choose.randint(0, n)
    change = power([-s, Fraction(1)], k)
    return [plus(p, scaled(change, number())) for p in piece]


def first_piece(n, coordinates, rational):
    piece = [[number() for _ in range(n + 1)] for _ in range(coordinates)]
    if rational:
        piece[-1] = [Fraction(choose.randint(1, 4))] + [Fraction(choose.randint(0, 3), 4) for _ in range(n)]
    return piece


def represented(piece, b):
    """The same rational curve by other homogeneous points."""
    factor = [choose.choice([Fraction(1), Fraction(2, 3), Fraction(-3)])]
    if choose.random() < 0.3:
        factor = times(factor, [b + choose.randint(1, 3), Fraction(-1)])
    return [times(p, factor) for p in piece], len(factor) > 1


def map_of(pieces, rational, scalar):
    """A Bezier curve, or a spline whose knots are all n + 1 times there; None where a weight is 0."""
    n = max(max(len(p) for p in polynomials) for _, _, polynomials in pieces) - 1
    n = max(n, 0) + choose.choice([0, 0, 0, 1])
    points = []
    for a, b, polynomials in pieces:
        points += zip(*(control_points(p, n, a, b) for p in polynomials))
    a_map = {}
    if rational:
        weights = [p[-1] for p in points]
        if 0 in weights:
            return None
        points = [[x / p[-1] for x in p[:-1]] for p in points]
        a_map["weights"] = texts(weights)
    a_map["control_points"] = [text_of(p[0]) if scalar else texts(p) for p in points]
    if len(pieces) == 1 and choose.random() < 0.7:
        ends = [pieces[0][0], pieces[0][1]]
        if choose.random() < 0.2:
            ends.reverse()
            for list_of in a_map.values():
                list_of.reverse()
        return {"kind": "bezier", "interval": texts(ends), **a_map}
    knots = [t for t in [pieces[0][0], *(b for _, b, _ in pieces)] for _ in range(n + 1)]
    return {"kind": "bspline", "degree": n, "knots": texts(knots), **a_map}


def moved(pieces, shift):
    return [(a + shift, b + shift, [composed(p, [-shift, Fraction(1)]) for p in polynomials]) for a, b, polynomials in pieces]


def new_case():
    rational = choose.random() < 0.6
    scalar = choose.random() < 0.5
    coordinates = (1 if scalar else choose.randint(1, 2)) + rational
    n = choose.randint(0, 3)
    t = Fraction(choose.randint(-2, 2), choose.randint(1, 2))
    curve = first_piece(n, coordinates, rational)
    groups, factored = [], False
    for i in range(choose.choice([1, 2, 2, 2, 3])):
        group = []
        for j in range(choose.choice([1, 1, 2])):
            if i + j:
                curve = next_piece(curve, t, n, rational)
            end = t + Fraction(choose.randint(1, 4), choose.randint(1, 3))
            piece = curve
            if rational:
                if any(sum(a * x**k for k, a in enumerate(piece[-1])) == 0 for x in (t, end)):
                    return None
                piece, divisible = represented(piece, end)
                factored = factored or divisible or len(common_factor(curve)) > 1
            group.append((t, end, piece))
            t = end
        groups.append(group)
    chain = choose.random() < 0.3
    shown = [moved(group, choose.randint(-3, 3)) if chain and i else group for i, group in enumerate(groups)]
    maps = [map_of(group, rational, scalar) for group in shown]
    if None in maps:
        return None
    request = {"op": "join", "maps": maps}
    if chain:
        request["chain"] = True
    return {"request": request, "pieces": [p for group in groups for p in group], "rational": rational, "factored": factored}


def best_scaled_order(left, right, s):
    """The greatest order with which homogeneous points meet when the right ones are multiplied by a number."""
    length = max(map(len, left + right)) + 1
    f, g = series(left, s, length, False), series(right, s, length, False)
    factor = f[-1][0] / g[-1][0]
    return order_of_contact(left, [scaled(p, factor) for p in right], s, False)


cases = []
while len(cases) < CASES:
    case = new_case()
    if case:
        cases.append(case)

follow_up, meanings = [], []
without_answer = 0
for case, response in zip(cases, ask(program, [case["request"] for case in cases])):
    request, pieces, rational = case["request"], case["pieces"], case["rational"]
    if not response["ok"]:
        without_answer += 1
        report.expect(rational and response["error"]["code"] == "zero_weight", "refused", request, response)
        continue
    joined = response["result"]["map"]
    n = joined["degree"]
    degrees = [m["degree"] if m["kind"] == "bspline" else len(m["control_points"]) - 1 for m in request["maps"]]
    report.expect(n == max(degrees), "degree", request, joined)
    report.expect(same_pieces(pieces, pieces_of(joined), rational), "another map", request, joined)
    knots = [Fraction(t) for t in joined["knots"]]
    joints = [b for _, b, _ in pieces[:-1]]
    inner = [t for t in knots if t not in (knots[0], knots[-1])]
    report.expect(set(inner) <= set(joints), "new knots", request, joined)
    for (_, s, left), (_, _, right) in zip(pieces, pieces[1:]):
        order = order_of_contact(left, right, s, rational)
        times_there = inner.count(s)
        report.expect((order is None) == (times_there == 0), "needed knot", s, order, request, joined)
        if order is None:
            continue
        report.expect(n - times_there <= order, "too few", s, order, request, joined)
        exact = best_scaled_order(left, right, s) if rational else order
        if not case["factored"]:
            report.expect(exact is not None and times_there == n - exact, "multiplicity", s, exact, request, joined)
        follow_up.append({"op": "join", "maps": [joined], "knots": texts(knots), "degree": n})
        meanings.append(("again", joined))
        rougher = sorted(knots)
        rougher.remove(s)
        follow_up.append({**request, "knots": texts(rougher), "degree": n})
        meanings.append(("refused", order >= n + 1 - times_there))
    for (a, s, left), (_, b, right) in zip(pieces, pieces[1:]):
        order = order_of_contact(left, right, s, rational)
        shown = "infinite" if order is None else order
        follow_up.append({"op": "continuity", "map": joined, "at": text_of(s)})
        meanings.append(("order", shown))
        if "chain" not in request and len(request["maps"]) == len(pieces) == 2:
            follow_up.append({"op": "continuity", "maps": request["maps"], "at": text_of(s)})
            meanings.append(("order", shown))

for request, response, (kind, expected) in zip(follow_up, ask(program, follow_up), meanings):
    if kind == "again":
        report.expect(response["ok"] and response["result"]["map"] == expected, "joined again", request, response)
    elif kind == "order":
        report.expect(response["ok"] and response["result"]["order"] == expected, "order", expected, request, response)
    else:
        message = response.get("error", {}).get("message", "")
        report.expect(response.get("error", {}).get("code") == "not_continuous", "not refused", request, response)
        report.expect(("but their homogeneous points" in message) == expected, "reason", request, message)

assert without_answer < CASES / 10, without_answer
print(f"{len(cases)} cases, {len(follow_up)} questions about them, {without_answer} without an answer, {report.problems} problems")
sys.exit(1 if report.problems else 0)
