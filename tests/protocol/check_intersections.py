#!/usr/bin/env python3
"""Holds `intersections` of two curves and `self-intersections` against resultants of SymPy and narrow enclosures of all candidates.

usage: check_intersections.py PROGRAM [CASES]
"""

import random
import sys
from fractions import Fraction

from real_roots_oracle import bounds, derivative, is_number, multiplicity_in, quotient, quotient_bounds, real_roots, without_factors_of
from spline_oracle import Report, ask, common_factor, composed, control_points, pieces_of, plus, power, scaled, text_of, texts, times, trimmed, value

from sympy import QQ, Poly, symbols

program = sys.argv[1]
CASES = int(sys.argv[2]) if len(sys.argv) > 2 else 260
choose = random.Random(1977)
report = Report()
S, T = symbols("s t")
TINY = Fraction(1, 10**40)


def number():
    return choose.choice([Fraction(0), Fraction(1), Fraction(choose.randint(-3, 3)), Fraction(choose.randint(-5, 5), choose.randint(1, 2))])


def point():
    return [number(), number()]


# --- curves: maps of the protocol with their pieces (a, b, [x, y, w]) ---


def curve_of(a_map):
    pieces = pieces_of(a_map)
    if "weights" not in a_map:
        pieces = [(a, b, [*polynomials, [Fraction(1)]]) for a, b, polynomials in pieces]
    reduced = []
    for a, b, polynomials in pieces:
        common = common_factor(polynomials)
        reduced.append((a, b, [quotient(p, common) for p in polynomials]))
    return a_map, reduced


def bezier(points, weights=None, interval=None):
    a_map = {"kind": "bezier", "control_points": [texts(p) for p in points]}
    if weights:
        a_map["weights"] = texts(weights)
    if interval:
        a_map["interval"] = texts(interval)
    return curve_of(a_map)


def polynomial_curve(x, y, a, b, n=None):
    """Of polynomials, as control points over [a, b]."""
    n = n or max(len(x), len(y), 2) - 1
    return bezier(list(zip(control_points(x, n, a, b), control_points(y, n, a, b))), interval=[a, b])


def random_points(count):
    kind = choose.random()
    if kind < 0.06:
        return [point()] * count
    if kind < 0.2:
        first, step = point(), point()
        return [[x + k * y for x, y in zip(first, step)] for k in (range(count) if choose.random() < 0.5 else [choose.randint(0, 3) for _ in range(count)])]
    made = [point() for _ in range(count)]
    if kind < 0.3:
        made[-1] = made[0]
    if kind < 0.4 and count > 2:
        made[1] = made[0]
    return made


def random_curve():
    kind = choose.choice(["bezier", "bezier", "rational", "bspline"])
    if kind == "bspline":
        n = choose.randint(1, 2)
        inner = [Fraction(1)] * choose.randint(1, n) + [Fraction(2)] * choose.randint(0, 1)
        knots = [Fraction(0)] * (n + 1) + inner + [Fraction(3)] * (n + 1)
        return curve_of({"kind": "bspline", "degree": n, "knots": texts(knots), "control_points": [texts(p) for p in random_points(len(knots) - n - 1)]})
    n = choose.choice([1, 2, 2, 3])
    weights = [Fraction(choose.randint(1, 3)) for _ in range(min(n, 2) + 1)] if kind == "rational" else None
    return bezier(random_points(min(n, 2) + 1 if weights else n + 1), weights)


def touching_pair():
    """Two graphs over one x that differ by c (t - a)^k times another factor: contact of order k at a."""
    x = choose.choice([[Fraction(0), Fraction(1)], [Fraction(0), Fraction(1), Fraction(1)]])
    y = trimmed(number() for _ in range(3))
    a, k = choose.choice([Fraction(0), Fraction(1, 2), Fraction(1)]), choose.choice([2, 2, 3])
    z = plus(y, scaled(times(power([-a, Fraction(1)], k), choose.choice([[Fraction(1)], [-number(), Fraction(1)]])), number() or 1))
    return polynomial_curve(x, y, Fraction(0), Fraction(1)), polynomial_curve(x, z, Fraction(0), Fraction(1))


def overlapping_pair():
    """Two ranges of one curve, also of higher degree, reversed, or passed twice."""
    x, y = choose.choice(
        [
            ([Fraction(0), Fraction(1)], [Fraction(0), Fraction(0), Fraction(1)]),
            ([Fraction(-1), Fraction(0), Fraction(1)], [Fraction(0), Fraction(-1), Fraction(0), Fraction(1)]),  # a double point at -1 and 1
            ([Fraction(0), Fraction(1)], [Fraction(1), Fraction(2)]),
            ([Fraction(0), Fraction(0), Fraction(1)], [Fraction(0), Fraction(0), Fraction(0), Fraction(1)]),  # a cusp
        ]
    )
    change = choose.choice([[number(), Fraction(1)], [number(), Fraction(-2)], [number(), Fraction(1, 2)], [Fraction(0), Fraction(0), Fraction(1)]])
    if len(change) > 2 and len(y) > 3:
        change = [Fraction(0), Fraction(1)]
    ends = [sorted(choose.sample([Fraction(k, 2) for k in range(-4, 5)], 2)) for _ in range(2)]
    if choose.random() < 0.3:
        ends[1] = [ends[0][1], ends[0][1] + 1] if len(change) == 2 and change == [Fraction(0), Fraction(1)] else ends[1]
    u, v = composed(x, change), composed(y, change)
    return polynomial_curve(x, y, *ends[0]), polynomial_curve(u, v, *ends[1], n=max(len(u), len(v)) - 1 + choose.randint(0, 1))


# --- the oracle ---


def bivariate(rows):
    """Coefficients {(i, j): a} of s^i t^j."""
    return Poly({key: QQ(a.numerator, a.denominator) for key, a in rows.items()} or {(0, 0): 0}, S, T, domain=QQ)


def equations(f, g):
    result = []
    for j in range(2):
        rows = {}
        for i, a in enumerate(f[j]):
            for k, b in enumerate(g[2]):
                rows[i, k] = rows.get((i, k), 0) + a * b
        for i, a in enumerate(f[2]):
            for k, b in enumerate(g[j]):
                rows[i, k] = rows.get((i, k), 0) - a * b
        result.append({key: a for key, a in rows.items() if a})
    return result


def self_equations(f):
    """Divided by s - t, by long division in s."""
    result = []
    for p in equations(f, f):
        quotient_of_p, _ = bivariate(p).div(Poly(S - T, S, T, domain=QQ))
        result.append({key: Fraction(int(a.numerator), int(a.denominator)) for key, a in quotient_of_p.rep.to_dict().items() if a})
    return result


def eliminated(pair, variable):
    """The resultant as a list of coefficients; of a zero equation and another one, that one's content."""
    p, q = (bivariate(rows) for rows in pair)
    if p.is_zero or q.is_zero:
        other = q if p.is_zero else p
        if other.degree(variable) > 0:
            return []
        p = q = other
    r = p.resultant(q) if variable == S else p.reorder(T, S).resultant(q.reorder(T, S))
    coefficients = [Fraction(int(a.numerator), int(a.denominator)) for a in reversed(r.rep.to_list())] if not r.is_ground else [Fraction(str(r.as_expr()))]
    return trimmed(coefficients)


def in_piece(root, piece, is_last):
    a, b, _ = piece
    return a <= root[1] and (root[1] < b or (is_last and root[1] == b))


def enclosed(polynomials, root):
    return [quotient_bounds(p, polynomials[2], root) for p in polynomials[:2]]


def overlap_of(one, other):
    return all(a[0] <= b[1] and b[0] <= a[1] for a, b in zip(one, other))


def is_constant(polynomials):
    return all(len(p) < 2 for p in polynomials)


def candidates(p, weight, piece, is_last):
    return [r for r in real_roots(without_factors_of(p, weight)) if in_piece(r, piece, is_last)]


def velocity(f):
    return [plus(times(derivative(p), f[2]), scaled(times(p, derivative(f[2])), -1)) for p in f[:2]]


def series(p, w, s, length):
    p, w = (composed(q, [s, Fraction(1)]) + [Fraction(0)] * length for q in (p, w))
    result = []
    for k in range(length):
        result.append((p[k] - sum(result[i] * w[k - i] for i in range(k))) / w[0])
    return result


def graph(f, s, along, length):
    """The Taylor coefficients of one coordinate by the other, by undetermined coefficients."""
    x, y = series(f[along], f[2], s, length), series(f[1 - along], f[2], s, length)
    x[0] = Fraction(0)
    coefficients, rest = [], y
    powers = [[Fraction(1)] + [Fraction(0)] * (length - 1)]
    for _ in range(length - 1):
        powers.append((times(powers[-1], x) + [Fraction(0)] * length)[:length])
    for k in range(length):
        c = rest[k] / powers[k][k]
        coefficients.append(c)
        rest = [r - c * q for r, q in zip(rest, powers[k])]
    return coefficients


def multiplicity(f, g, s, t):
    """None for a velocity of 0; exact at rational parameters, else 1 or 2 for 2 and more."""
    speeds = []
    for h, r in ((f, s), (g, t)):
        enclosures = [bounds(v, *r) for v in velocity(h)]
        if all(low <= 0 <= high for low, high in enclosures):
            return None
        speeds.append([(low + high) / 2 for low, high in enclosures])
    (a, b), (c, d) = speeds
    if abs(a * d - b * c) > TINY:
        return 1
    if s[0] != s[1] or t[0] != t[1]:
        return 2
    along = 0 if abs(a) > TINY else 1
    length = 12
    p, q = graph(f, s[0], along, length), graph(g, t[0], along, length)
    return next(k for k in range(length) if k > 0 and p[k] != q[k])


def expected_points(first, second, is_self=False):
    """(s, t, f, g) of all isolated solutions, and whether some pieces overlap."""
    found, overlaps = [], False
    for i, one in enumerate(first):
        for k, other in enumerate(second):
            if is_self and k < i:
                continue
            f, g = one[2], other[2]
            itself = is_self and i == k
            if is_constant(f) or is_constant(g):
                overlaps = True
                continue
            pair = self_equations(f) if itself else equations(f, g)
            p = eliminated(pair, T)
            if not p:
                overlaps = True
                continue
            at_first = candidates(p, f[2], one, i == len(first) - 1)
            if not at_first:
                continue
            at_second = at_first if itself else candidates(eliminated(pair, S), g[2], other, k == len(second) - 1)
            for s in at_first:
                for t in at_second:
                    if (not itself or s < t) and overlap_of(enclosed(f, s), enclosed(g, t)):
                        found.append((s, t, f, g))
    return sorted(found, key=lambda entry: entry[:2]), overlaps


def end_of(number, infinite):
    if isinstance(number, str):
        return infinite
    return Fraction(number["value"]) if "value" in number else Fraction(number["double"])


def covers(overlap, s, t):
    """Whether a pair of parameters is in both intervals; approximate at irrational ends."""
    for ends, root in zip(overlap["intervals"], (s, t)):
        low, high = end_of(ends[0], Fraction(-(10**9))), end_of(ends[1], Fraction(10**9))
        rounding = Fraction(0) if all("interval" not in end for end in ends) else Fraction(1, 10**12)
        if root[1] < low - rounding or high + rounding < root[0]:
            return False
    return True


def partners(f, g, itself, s):
    if itself:
        polynomials = [plus(scaled(p, value(f[2], s)), scaled(f[2], -value(p, s))) for p in f[:2]]
        polynomials = [quotient(p, [-s, Fraction(1)]) for p in polynomials if p]
        return real_roots(common_factor(polynomials)) if polynomials else []
    polynomials = [plus(scaled(p, value(f[2], s)), scaled(g[2], -value(x, s))) for p, x in zip(g[:2], f[:2])]
    return real_roots(common_factor(polynomials))


def check_samples(first, second, is_self, result, request):
    """At rational parameters of the first curve, every partner is in a common part or listed, and common parts have partners."""
    overlaps = result.get("overlaps", [])
    for i, (a, b, f) in enumerate(first):
        for s in {a + (b - a) * Fraction(k, 8) for k in range(9)} | {a + (b - a) * Fraction(choose.randint(1, 96), 97)}:
            if s == b and i < len(first) - 1 or value(f[2], s) == 0:
                continue
            partner_found = []
            for k, (c, d, g) in enumerate(second):
                if is_constant(f) and is_constant(g):
                    same = all(value(p, 0) * value(g[2], 0) == value(q, 0) * value(f[2], 0) for p, q in zip(f[:2], g[:2]))
                    if not same:
                        continue
                    found = [(c, c), (d, d)]
                else:
                    found = partners(f, g, is_self and i == k, s)
                partner_found += [t for t in found if in_piece(t, (c, d, g), k == len(second) - 1) and value(g[2], t[0]) != 0]
            for t in partner_found:
                if is_self and t[0] <= s:
                    continue
                listed = any(is_number(p["parameters"][0], (s, s)) and is_number(p["parameters"][1], t) for p in result["intersections"])
                report.expect(listed or any(covers(o, (s, s), t) for o in overlaps), "a common point is missing", s, t, result, request)
            for overlap in overlaps:
                low, high = (end_of(e, x) for e, x in zip(overlap["intervals"][0], (Fraction(-(10**9)), Fraction(10**9))))
                if low < s < high and not any(is_constant(h) for _, _, h in second):
                    report.expect(any(covers(overlap, (s, s), t) for t in partner_found), "a common part is too long", s, overlap, request)


def check(request, first, second, is_self, result):
    expected, overlaps = expected_points(first, second, is_self)
    given = result["intersections"]
    if overlaps:
        check_samples(first, second, is_self, result, request)
        return len(given), len(result.get("overlaps", []))
    report.expect("overlaps" not in result, "common parts", result, request)
    report.expect(len(expected) == len(given), "number of points", [e[:2] for e in expected], result, request)
    for entry, (s, t, f, g) in zip(given, expected):
        right = is_number(entry["parameters"][0], s) and is_number(entry["parameters"][1], t)
        right = right and all(is_number(x, enclosure) for x, enclosure in zip(entry["point"], enclosed(f, s)))
        report.expect(right, "point", s, t, entry, request)
        times_met = multiplicity(f, g, s, t)
        got = entry.get("multiplicity")
        rational = s[0] == s[1] and t[0] == t[1]
        report.expect(got == times_met or (times_met == 2 and not rational and got > 2), "multiplicity", times_met, entry, request)
        if is_self:
            closed = s == (first[0][0],) * 2 and t == (first[-1][1],) * 2
            report.expect(entry["kind"] == ("closed" if closed else "double"), "kind", entry, request)
    return len(given), 0


def check_cusps(request, pieces, result):
    expected = []
    for i, piece in enumerate(pieces):
        stops = common_factor(velocity(piece[2])) if not is_constant(piece[2]) else []
        expected += [r for r in (real_roots(stops) if stops else []) if in_piece(r, piece, i == len(pieces) - 1) and multiplicity_in(stops, r) % 2]
    report.expect(len(expected) == len(result["cusps"]) and all(is_number(c, r) for c, r in zip(result["cusps"], expected)), "cusps", expected, result, request)


def make_case():
    kind = choose.choice(["random", "random", "random", "touching", "overlapping", "self", "self"])
    if kind == "self":
        a_map, pieces = random_curve() if choose.random() < 0.7 else choose.choice(overlapping_pair())
        return {"op": "self-intersections", "map": a_map}, pieces, pieces, True
    if kind == "random":
        first, second = random_curve(), random_curve()
        if choose.random() < 0.2 and "weights" not in second[0]:  # a common end
            second[0]["control_points"][0] = first[0]["control_points"][-1]
            second = curve_of(second[0])
    else:
        first, second = touching_pair() if kind == "touching" else overlapping_pair()
    if choose.random() < 0.3:
        first, second = second, first
    return {"op": "intersections", "map": first[0], "with": second[0]}, first[1], second[1], False


cases = [make_case() for _ in range(CASES)]
points = parts = 0
for (request, first, second, is_self), response in zip(cases, ask(program, [request for request, _, _, _ in cases])):
    if not response["ok"]:
        report.expect(False, "refused", request, response)
        continue
    result = response["result"]
    report.expect(result["interval"] == texts([first[0][0], first[-1][1]]), "interval", result, request)
    found, common = check(request, first, second, is_self, result)
    points += found
    parts += common
    if is_self:
        check_cusps(request, first, result)

assert points > CASES / 4 and parts > CASES / 20, (points, parts)
print(f"{len(cases)} cases, {points} points, {parts} common parts, {report.problems} problems")
sys.exit(1 if report.problems else 0)
