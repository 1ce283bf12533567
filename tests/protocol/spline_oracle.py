"""Curves and splines in Python's fractions, from their definitions: what the checks of the program in this folder compare with.

A polynomial is the list of its coefficients, lowest first. A piece is (a, b, [one polynomial per coordinate]), with the weight last
where there are weights.
"""

import json
import subprocess
from fractions import Fraction
from math import comb


def text_of(number):
    return str(number.numerator) if number.denominator == 1 else f"{number.numerator}/{number.denominator}"


def texts(numbers):
    return [text_of(number) for number in numbers]


def ask(program, requests):
    """The responses to requests, one for each."""
    lines = "".join(json.dumps(request) + "\n" for request in requests)
    answers = subprocess.run([program, "batch"], input=lines, capture_output=True, text=True, check=False).stdout.splitlines()
    assert len(answers) == len(requests), (len(answers), len(requests))
    return [json.loads(line) for line in answers]


class Report:
    """Counts what is wrong, and shows the first of it."""

    def __init__(self):
        self.problems = 0

    def expect(self, true, *what):
        if true:
            return
        self.problems += 1
        if self.problems < 10:
            print(*what)


def trimmed(p):
    p = list(p)
    while p and p[-1] == 0:
        p.pop()
    return p


def plus(p, q):
    return trimmed((p[i] if i < len(p) else 0) + (q[i] if i < len(q) else 0) for i in range(max(len(p), len(q))))


def times(p, q):
    product = [Fraction(0)] * max(len(p) + len(q) - 1, 0)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            product[i + j] += a * b
    return trimmed(product)


def scaled(p, factor):
    return trimmed(a * factor for a in p)


def power(p, exponent):
    result = [Fraction(1)]
    for _ in range(exponent):
        result = times(result, p)
    return result


def value(p, t):
    result = Fraction(0)
    for a in reversed(p):
        result = result * t + a
    return result


def composed(p, q):
    """p(q(t))"""
    result = []
    for a in reversed(p):
        result = plus(times(result, q), [a])
    return result


def remainder(p, q):
    p = trimmed(p)
    while len(p) >= len(q):
        p = plus(p, scaled([Fraction(0)] * (len(p) - len(q)) + q, -p[-1] / q[-1]))
    return p


def common_factor(polynomials):
    common = []
    for p in polynomials:
        p = trimmed(p)
        while p:
            common, p = p, remainder(common, p)
    return common


def control_points(p, n, a, b):
    """Of a polynomial over [a, b]: from its coefficients in x = (t - a) / (b - a)."""
    c = composed(p, [a, b - a])
    c += [Fraction(0)] * (n + 1 - len(c))
    return [sum(Fraction(comb(k, i), comb(n, i)) * c[i] for i in range(k + 1)) for k in range(n + 1)]


def bernstein(n, k, a, b):
    return scaled(times(power([b, Fraction(-1)], n - k), power([-a, Fraction(1)], k)), comb(n, k) / (b - a) ** n)


def basis_polynomial(knots, i, degree, span):
    """N_i of a degree on a span, by the recursion of Cox and de Boor."""
    if degree == 0:
        return [Fraction(1)] if i == span else []
    result = []
    if knots[i + degree] != knots[i]:
        rising = scaled([-knots[i], Fraction(1)], 1 / (knots[i + degree] - knots[i]))
        result = times(rising, basis_polynomial(knots, i, degree - 1, span))
    if knots[i + degree + 1] != knots[i + 1]:
        falling = scaled([knots[i + degree + 1], Fraction(-1)], 1 / (knots[i + degree + 1] - knots[i + 1]))
        result = plus(result, times(falling, basis_polynomial(knots, i + 1, degree - 1, span)))
    return result


def points_of(a_map):
    """Homogeneous where there are weights."""
    points = [[Fraction(x) for x in p] if isinstance(p, list) else [Fraction(p)] for p in a_map["control_points"]]
    if "weights" in a_map:
        weights = [Fraction(w) for w in a_map["weights"]]
        return [[x * w for x in p] + [w] for p, w in zip(points, weights)]
    return points


def combined(functions, points):
    polynomials = []
    for j in range(len(points[0])):
        total = []
        for function, point in zip(functions, points):
            total = plus(total, scaled(function, point[j]))
        polynomials.append(total)
    return polynomials


def textbook_knots(a_map):
    """With one knot more at each end where the convention leaves it out; which one does not matter."""
    knots = [Fraction(t) for t in a_map["knots"]]
    if len(knots) == len(a_map["control_points"]) + a_map["degree"] + 1:
        return knots
    return [knots[0] - 1, *knots, knots[-1] + 1]


def pieces_of(a_map):
    points = points_of(a_map)
    if a_map["kind"] == "bezier":
        a, b = (Fraction(t) for t in a_map.get("interval", ["0", "1"]))
        n = len(points) - 1
        return [(min(a, b), max(a, b), combined([bernstein(n, k, a, b) for k in range(n + 1)], points))]
    n = a_map["degree"]
    knots = textbook_knots(a_map)
    pieces = []
    for span in range(n, len(points)):
        if knots[span] == knots[span + 1]:
            continue
        functions = [basis_polynomial(knots, j, n, span) for j in range(span - n, span + 1)]
        pieces.append((knots[span], knots[span + 1], combined(functions, points[span - n : span + 1])))
    return pieces


def series(polynomials, s, length, rational):
    """The Taylor coefficients at s of each coordinate, divided by the weight where there is one."""
    expanded = [composed(p, [s, Fraction(1)]) for p in polynomials]
    expanded = [p[:length] + [Fraction(0)] * (length - len(p)) for p in expanded]
    if not rational:
        return expanded
    *coordinates, weight = expanded
    quotients = []
    for p in coordinates:
        q = []
        for k in range(length):
            q.append((p[k] - sum(q[i] * weight[k - i] for i in range(k))) / weight[0])
        quotients.append(q)
    return quotients


def order_of_contact(left, right, s, rational):
    """None where the two are one curve."""
    length = max(len(p) for p in [*left, [0]]) + max(len(p) for p in [*right, [0]]) + 1
    f = series(left, s, length, rational)
    g = series(right, s, length, rational)
    for k in range(length):
        if any(p[k] != q[k] for p, q in zip(f, g)):
            return k - 1
    return None


def same_map(left, right, rational):
    if not rational:
        return [trimmed(p) for p in left] == [trimmed(p) for p in right]
    return all(times(p, right[-1]) == times(q, left[-1]) for p, q in zip(left[:-1], right[:-1]))


def same_pieces(one, other, rational):
    """Whether two lists of pieces are the same function, however it is divided."""
    if (one[0][0], one[-1][1]) != (other[0][0], other[-1][1]):
        return False
    cuts = sorted({a for a, _, _ in one} | {a for a, _, _ in other})

    def at(pieces, t):
        return next(p for a, b, p in reversed(pieces) if a <= t)

    return all(same_map(at(one, t), at(other, t), rational) for t in cuts)
