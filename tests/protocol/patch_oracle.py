"""Tensor products and simplices in Python's fractions, from the definitions of their basis functions: what check_patches.py compares with.

A polynomial in several variables is a dictionary from exponents to coefficients. The homogeneous coordinates of a map have its weight last.
"""

from fractions import Fraction
from functools import lru_cache
from itertools import product
from math import factorial, prod

from spline_oracle import basis_polynomial, bernstein, textbook_knots, value


def leaves(net, depth):
    return [net] if depth == 0 else [leaf for entry in net for leaf in leaves(entry, depth - 1)]


def homogeneous(points, weights):
    """Points with their weights as last coordinates, or the points alone."""
    points = [[Fraction(x) for x in p] if isinstance(p, list) else [Fraction(p)] for p in points]
    if weights is None:
        return points
    return [[x * Fraction(w) for x in p] + [Fraction(w)] for p, w in zip(points, weights)]


def is_rational(a_map):
    return "weights" in a_map or "denominator" in a_map


def directions_of(a_map):
    return len(a_map["degrees"])


def grid_of(a_map):
    """The number of points in each direction, and the homogeneous points of a tensor product, the last direction fastest."""
    counts, net = [], a_map["control_net"]
    for _ in a_map["degrees"]:
        counts.append(len(net))
        net = net[0]
    weights = leaves(a_map["weights"], len(counts)) if "weights" in a_map else None
    return counts, homogeneous(leaves(a_map["control_net"], len(counts)), weights)


def knots_of(a_map, d):
    """With one more at each end where the convention leaves it out."""
    counts, _ = grid_of(a_map)
    return textbook_knots({"knots": a_map["knots"][d], "control_points": [0] * counts[d], "degree": a_map["degrees"][d]})


def domain_of(a_map, d):
    if a_map["kind"] == "tensor":
        a, b = a_map.get("intervals", [[0, 1]] * directions_of(a_map))[d]
        return min(Fraction(a), Fraction(b)), max(Fraction(a), Fraction(b))
    knots, n = knots_of(a_map, d), a_map["degrees"][d]
    return knots[n], knots[-n - 1]


@lru_cache(maxsize=None)
def spline_basis(knots, n, span):
    """The functions that are not zero on a span, as polynomials."""
    return [basis_polynomial(knots, j, n, span) for j in range(span - n, span + 1)]


def basis_at(a_map, d, t):
    """The values of the basis functions of a direction, on the last piece at the end of the domain."""
    n = a_map["degrees"][d]
    if a_map["kind"] == "tensor":
        a, b = (Fraction(x) for x in a_map.get("intervals", [[0, 1]] * directions_of(a_map))[d])
        return [value(bernstein(n, k, a, b), t) for k in range(n + 1)]
    knots = knots_of(a_map, d)
    a, b = domain_of(a_map, d)
    assert a <= t <= b
    spans = [i for i in range(n, len(knots) - n - 1) if knots[i] < knots[i + 1]]
    span = max(i for i in spans if knots[i] <= t)
    values = [Fraction(0)] * (len(knots) - n - 1)
    values[span - n : span + 1] = [value(p, t) for p in spline_basis(tuple(knots), n, span)]
    return values


def lattice(n, s):
    """The indices of a simplex of dimension s."""
    return [(n,)] if s == 0 else [(i, *rest) for i in range(n, -1, -1) for rest in lattice(n - i, s - 1)]


def solved(matrix, right):
    """The solution of a system with one solution."""
    rows = [list(row) + [b] for row, b in zip(matrix, right)]
    n = len(rows)
    for i in range(n):
        pivot = next(k for k in range(i, n) if rows[k][i] != 0)
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [x / rows[i][i] for x in rows[i]]
        for k in range(n):
            if k != i and rows[k][i] != 0:
                rows[k] = [x - rows[k][i] * y for x, y in zip(rows[k], rows[i])]
    return [row[-1] for row in rows]


def barycentric(a_map, at):
    if "vertices" not in a_map:
        return list(at)
    vertices = [[Fraction(x) for x in v] for v in a_map["vertices"]]
    return solved([[Fraction(1)] * len(vertices), *zip(*vertices)], [Fraction(1), *at])


def terms_value(terms, at, center):
    """Of pairs of exponents and a point."""
    total = None
    for exponents, point in terms:
        point = [Fraction(x) for x in point] if isinstance(point, list) else [Fraction(point)]
        factor = prod(((t - c) ** k for t, c, k in zip(at, center, exponents)), start=Fraction(1))
        total = [x * factor + y for x, y in zip(point, total or [Fraction(0)] * len(point))]
    return total


def homogeneous_value(a_map, at):
    """The coordinates at a point of the domain, the weight last where there is one."""
    if a_map["kind"] in ("polynomial", "taylor"):
        center = [Fraction(c) for c in a_map.get("center", [0] * len(at))]
        coordinates = terms_value(a_map["terms"], at, center)
        return coordinates + (terms_value(a_map["denominator"], at, center) if "denominator" in a_map else [])
    if a_map["kind"] == "simplex":
        x = barycentric(a_map, at)
        indices = [tuple(index) for index, _ in a_map["control_net"]]
        weights = [w for _, w in a_map["weights"]] if "weights" in a_map else None
        points = homogeneous([p for _, p in a_map["control_net"]], weights)
        factors = [
            Fraction(factorial(sum(index)), prod(factorial(i) for i in index)) * prod((y**i for y, i in zip(x, index)), start=Fraction(1))
            for index in indices
        ]
    else:
        _, points = grid_of(a_map)
        bases = [basis_at(a_map, d, t) for d, t in enumerate(at)]
        factors = [prod(chosen, start=Fraction(1)) for chosen in product(*bases)]
    return [sum((f * p[j] for f, p in zip(factors, points)), Fraction(0)) for j in range(len(points[0]))]


class Values:
    """Of a tensor product, whose points and basis functions are computed once."""

    def __init__(self, a_map):
        self.map = a_map
        _, self.points = grid_of(a_map)
        self.basis = lru_cache(maxsize=None)(lambda d, t: basis_at(a_map, d, t))

    def projected(self, at):
        factors = [prod(chosen, start=Fraction(1)) for chosen in product(*(self.basis(d, t) for d, t in enumerate(at)))]
        used = [(f, p) for f, p in zip(factors, self.points) if f]
        coordinates = [sum((f * p[j] for f, p in used), Fraction(0)) for j in range(len(self.points[0]))]
        if not is_rational(self.map):
            return coordinates
        return None if coordinates[-1] == 0 else [x / coordinates[-1] for x in coordinates[:-1]]


def projected_value(a_map, at):
    coordinates = homogeneous_value(a_map, at)
    if not is_rational(a_map):
        return coordinates
    return None if coordinates[-1] == 0 else [x / coordinates[-1] for x in coordinates[:-1]]


def breaks(a_map, d):
    a, b = domain_of(a_map, d)
    inner = {t for t in knots_of(a_map, d) if a < t < b} if a_map["kind"] == "bspline" else set()
    return [a, *sorted(inner), b]


def sample_parameters(maps, d, count):
    """In every interval on which all the maps are polynomials, enough parameters to tell polynomials apart."""
    cuts = sorted(set().union(*(breaks(a_map, d) for a_map in maps)))
    return [a + (b - a) * Fraction(k, count + 1) for a, b in zip(cuts, cuts[1:]) for k in range(1, count + 1)]


def same_on_grid(one, other, change=None):
    """Whether other(change(t)) is one(t) at enough parameters of the domain of `one`, both tensor products."""
    factor = 2 if is_rational(one) or is_rational(other) else 1
    axes = []
    for d in range(directions_of(one)):
        count = factor * max(one["degrees"][d], other["degrees"][d]) + 1
        if change:
            cuts = breaks(one, d)
            axes.append([a + (b - a) * Fraction(k, count + 1) for a, b in zip(cuts, cuts[1:]) for k in range(1, count + 1)])
        else:
            axes.append(sample_parameters([one, other], d, count))
    values = [Values(one), Values(other)]
    return all(values[0].projected(at) == values[1].projected(change(at) if change else at) for at in product(*axes))


def rows(a_map, direction):
    """The rows of homogeneous points in a direction, as spline curves without weights."""
    counts, points = grid_of(a_map)
    others = [range(c) if d != direction else [0] for d, c in enumerate(counts)]
    found = []
    for index in product(*others):
        row = []
        for i in range(counts[direction]):
            place = 0
            for d, count in enumerate(counts):
                place = place * count + (i if d == direction else index[d])
            row.append(points[place])
        found.append({"kind": "bspline", "degree": a_map["degrees"][direction], "knots": a_map["knots"][direction], "control_points": row})
    return found
