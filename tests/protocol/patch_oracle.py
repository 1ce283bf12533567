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


# Polynomials in two variables: a dictionary from (i, j) to the coefficient of x^i y^j.


def sum2(*terms):
    """Of pairs of a factor and a polynomial."""
    total = {}
    for factor, p in terms:
        for index, c in p.items():
            total[index] = total.get(index, 0) + factor * c
    return {index: c for index, c in total.items() if c}


def product2(p, q):
    total = {}
    for (i, j), c in p.items():
        for (k, m), d in q.items():
            total[i + k, j + m] = total.get((i + k, j + m), 0) + c * d
    return {index: c for index, c in total.items() if c}


def power2(p, n):
    return product2(p, power2(p, n - 1)) if n else {(0, 0): Fraction(1)}


def value2(p, x, y):
    return sum((c * x**i * y**j for (i, j), c in p.items()), Fraction(0))


def composed2(p, x, y):
    """p(x, y) for polynomials x and y."""
    return sum2(*((c, product2(power2(x, i), power2(y, j))) for (i, j), c in p.items()))


def in_one(p, variable):
    return {((k, 0) if variable == 0 else (0, k)): c for k, c in enumerate(p) if c}


def integral_over_unit_triangle(p):
    return sum((c * Fraction(factorial(i) * factorial(j), factorial(i + j + 2)) for (i, j), c in p.items()), Fraction(0))


def triangle_at(a, b, c):
    """The coordinates of a + s (b - a) + t (c - a) as polynomials in s and t."""
    return [{index: x for index, x in (((0, 0), a[k]), ((1, 0), b[k] - a[k]), ((0, 1), c[k] - a[k])) if x} for k in range(2)]


def integral_over(corners, p):
    """Over a triangle or a convex quadrilateral."""
    total = Fraction(0)
    for b, c in zip(corners[1:], corners[2:]):
        x, y = triangle_at(corners[0], b, c)
        area = abs((b[0] - corners[0][0]) * (c[1] - corners[0][1]) - (b[1] - corners[0][1]) * (c[0] - corners[0][0]))
        total += area * integral_over_unit_triangle(composed2(p, x, y))
    return total


def functions_in(a_map, d, span):
    """The basis functions of a direction on a span, each as a polynomial in one variable."""
    n = a_map["degrees"][d]
    if a_map["kind"] == "tensor":
        a, b = (Fraction(x) for x in a_map.get("intervals", [[0, 1]] * directions_of(a_map))[d])
        return dict(enumerate(bernstein(n, k, a, b) for k in range(n + 1)))
    return dict(zip(range(span - n, span + 1), spline_basis(tuple(knots_of(a_map, d)), n, span)))


def spans_in(a_map, d):
    """Pairs of an interval and its span."""
    if a_map["kind"] == "tensor":
        return [(domain_of(a_map, d), 0)]
    knots, n = knots_of(a_map, d), a_map["degrees"][d]
    return [((knots[i], knots[i + 1]), i) for i in range(n, len(knots) - n - 1) if knots[i] < knots[i + 1]]


def surface_pieces(a_map):
    """The corners of each piece of a map of the plane, and a polynomial for each homogeneous coordinate."""
    if a_map["kind"] == "simplex":
        corners = [tuple(Fraction(x) for x in v) for v in a_map["vertices"]]
        a, b, c = corners
        area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

        def coordinate(p, q):  # 1 at the third corner, 0 on the line from p to q
            return {index: x / area for index, x in (((1, 0), p[1] - q[1]), ((0, 1), q[0] - p[0]), ((0, 0), p[0] * q[1] - q[0] * p[1])) if x}

        x = [coordinate(b, c), coordinate(c, a), coordinate(a, b)]
        weights = [w for _, w in a_map["weights"]] if "weights" in a_map else None
        points = homogeneous([p for _, p in a_map["control_net"]], weights)
        basis = []
        for index, _ in a_map["control_net"]:
            term = {(0, 0): Fraction(factorial(sum(index)), prod(factorial(i) for i in index))}
            for k in range(3):
                term = product2(term, power2(x[k], index[k]))
            basis.append(term)
        return [(corners, [sum2(*((p[j], f) for p, f in zip(points, basis))) for j in range(len(points[0]))])]
    counts, points = grid_of(a_map)
    pieces = []
    for (u, i), (v, k) in product(spans_in(a_map, 0), spans_in(a_map, 1)):
        terms = [[] for _ in points[0]]
        for m, p in functions_in(a_map, 0, i).items():
            for n, q in functions_in(a_map, 1, k).items():
                both = product2(in_one(p, 0), in_one(q, 1))
                for j, c in enumerate(points[m * counts[1] + n]):
                    terms[j].append((c, both))
        corners = [(u[0], v[0]), (u[1], v[0]), (u[1], v[1]), (u[0], v[1])]
        pieces.append((corners, [sum2(*of_coordinate) for of_coordinate in terms]))
    return pieces


def common_segments(one, other):
    """Of the edges of two polygons: the segments with a length that they have in common."""
    found = []
    for a, b in zip(one, one[1:] + one[:1]):
        d = (b[0] - a[0], b[1] - a[1])
        for p, q in zip(other, other[1:] + other[:1]):
            if any(d[0] * (x[1] - a[1]) != d[1] * (x[0] - a[0]) for x in (p, q)):
                continue
            t = sorted(((x[0] - a[0]) * d[0] + (x[1] - a[1]) * d[1]) / (d[0] ** 2 + d[1] ** 2) for x in (p, q))
            begin, end = max(t[0], 0), min(t[1], 1)
            if begin < end:
                found.append([(a[0] + s * d[0], a[1] + s * d[1]) for s in (begin, end)])
    return found


def order_across(f, g, begin, end, rational):
    """The order to which two maps agree on a line; None where they are one map."""
    if rational:
        f, g = [product2(p, g[-1]) for p in f[:-1]], [product2(p, f[-1]) for p in g[:-1]]
    off = (begin[1] - end[1], end[0] - begin[0])
    x, y = triangle_at(begin, end, (begin[0] + off[0], begin[1] + off[1]))
    orders = [j for p, q in zip(f, g) for _, j in composed2(sum2((1, p), (-1, q)), x, y)]
    return min(orders) - 1 if orders else None
