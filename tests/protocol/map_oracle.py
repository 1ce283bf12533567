"""Maps of the protocol in Python's fractions, from the definitions of their bases: values of the maps at parameters.

A value is the list of the homogeneous coordinates of a point, with the weight last where there is one.
"""

from fractions import Fraction
from itertools import product as choices
from math import comb, factorial


def fractions(numbers):
    return [Fraction(x) for x in numbers]


def is_rational(a_map):
    return "weights" in a_map or "denominator" in a_map or a_map.get("homogeneous", False)


def bernstein_values(n, a, b, t):
    x = (t - a) / (b - a)
    return [comb(n, k) * x**k * (1 - x) ** (n - k) for k in range(n + 1)]


def bspline_values(knots, n, points, t):
    """N_0, ..., at t by the recursion of Cox and de Boor, from the right, at the end of the domain from the left."""
    knots = fractions(knots)
    if len(knots) == points + n - 1:
        knots = [knots[0] - 1, *knots, knots[-1] + 1]
    span = next(i for i in range(points - 1, n - 1, -1) if knots[i] <= t and knots[i] < knots[i + 1])
    values = [Fraction(int(i == span)) for i in range(len(knots) - 1)]
    for degree in range(1, n + 1):
        raised = []
        for i in range(len(knots) - 1 - degree):
            total = Fraction(0)
            if knots[i + degree] != knots[i]:
                total += (t - knots[i]) / (knots[i + degree] - knots[i]) * values[i]
            if knots[i + degree + 1] != knots[i + 1]:
                total += (knots[i + degree + 1] - t) / (knots[i + degree + 1] - knots[i + 1]) * values[i + 1]
            raised.append(total)
        values = raised
    return values


def barycentric(vertices, point):
    """The coordinates of a point with respect to vertices, by Cramer's rule."""
    if vertices is None:
        return point
    rows = [[Fraction(1)] * len(vertices)] + [[Fraction(v[j]) for v in vertices] for j in range(len(point))]
    right = [Fraction(1), *point]
    whole = determinant(rows)
    coordinates = []
    for k in range(len(vertices)):
        replaced = [[right[i] if c == k else row[c] for c in range(len(vertices))] for i, row in enumerate(rows)]
        coordinates.append(determinant(replaced) / whole)
    return coordinates


def determinant(rows):
    if not rows:
        return Fraction(1)
    return sum(
        (-1) ** j * rows[0][j] * determinant([row[:j] + row[j + 1 :] for row in rows[1:]])
        for j in range(len(rows))
        if rows[0][j]
    ) + Fraction(0)


def flat(net, levels):
    return net if levels == 0 else [leaf for entry in net for leaf in flat(entry, levels - 1)] if levels > 1 else net


def as_list(value):
    return fractions(value) if isinstance(value, list) else [Fraction(value)]


def weighted(points, weights):
    if weights is None:
        return points
    return [[x * Fraction(w) for x in p] + [Fraction(w)] for p, w in zip(points, weights)]


def combination(basis, points):
    return [sum(b * p[j] for b, p in zip(basis, points)) for j in range(len(points[0]))]


def tensor_basis(bases):
    result = [Fraction(1)]
    for basis in bases:
        result = [a * b for a in result for b in basis]
    return result


def value_at(a_map, at):
    """The value at a parameter, a list of numbers."""
    kind = a_map["kind"]
    if kind == "polynomial" and "variables" in a_map:
        total = None
        for exponents, coefficient in a_map["terms"]:
            monomial = Fraction(1)
            for x, exponent in zip(at, exponents):
                monomial *= x**exponent
            term = [monomial * c for c in as_list(coefficient)]
            total = term if total is None else [a + b for a, b in zip(total, term)]
        if "denominator" in a_map:
            total = (total or [Fraction(0)]) + [value_at({"kind": kind, "variables": a_map["variables"], "terms": a_map["denominator"]}, at)[0]]
        return total or [Fraction(0)]
    if kind == "polynomial":
        points = [as_list(c) for c in a_map["coefficients"]]
        powers = [at[0] ** k for k in range(max(len(points), len(a_map.get("denominator", []))))]
        result = combination(powers, points)
        if "denominator" in a_map:
            result.append(sum(p * Fraction(c) for p, c in zip(powers, a_map["denominator"])))
        return result
    if kind == "simplex":
        coordinates = barycentric(a_map.get("vertices"), at)
        total = None
        weights = [w for _, w in sorted(a_map["weights"])] if "weights" in a_map else None
        entries = sorted(a_map["control_net"])
        points = weighted([as_list(p) for _, p in entries], weights)
        basis = []
        for index, _ in entries:
            basis_value = Fraction(factorial(sum(index)))
            for x, i in zip(coordinates, index):
                basis_value *= x**i / Fraction(factorial(i))
            basis.append(basis_value)
        return combination(basis, points)
    if kind == "bezier":
        points = weighted([as_list(p) for p in a_map["control_points"]], a_map.get("weights"))
        a, b = fractions(a_map.get("interval", ["0", "1"]))
        return combination(bernstein_values(len(points) - 1, a, b, at[0]), points)
    if kind == "bspline" and "degrees" not in a_map:
        points = weighted([as_list(p) for p in a_map["control_points"]], a_map.get("weights"))
        return combination(bspline_values(a_map["knots"], a_map["degree"], len(points), at[0]), points)
    degrees = a_map["degrees"]
    levels = len(degrees)
    points = weighted([as_list(p) for p in flat(a_map["control_net"], levels)], flat(a_map["weights"], levels) if "weights" in a_map else None)
    if kind == "tensor":
        intervals = [fractions(i) for i in a_map.get("intervals", [["0", "1"]] * levels)]
        return combination(tensor_basis([bernstein_values(n, *i, t) for n, i, t in zip(degrees, intervals, at)]), points)
    counts = []
    net = a_map["control_net"]
    for _ in degrees:
        counts.append(len(net))
        net = net[0]
    return combination(tensor_basis([bspline_values(k, n, c, t) for k, n, c, t in zip(a_map["knots"], degrees, counts, at)]), points)


def degrees_of(a_map):
    if "degrees" in a_map:
        return a_map["degrees"]
    return [a_map["degree"]]


def point_of(value, rational):
    """The point, or None at infinity."""
    if not rational:
        return value
    return None if value[-1] == 0 else [x / value[-1] for x in value[:-1]]


def indices(dimension, degree):
    return [list(i) for i in choices(range(degree, -1, -1), repeat=dimension + 1) if sum(i) == degree]
