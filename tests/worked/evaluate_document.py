"""Computes a worked example again from its JSON form, with Python's fractions and the textbook definitions.

It shares nothing with the engine: blossoms are computed by de Boor's and de Casteljau's recursions or by sums over subsets, from the
maps that the document names.
"""

import itertools
import random
import re
from fractions import Fraction
from math import comb, factorial, prod


class Unknown(Exception):
    """A formula that contains something without a value, such as the name of a summation index."""


def scaled(factor, value):
    return tuple(factor * x for x in value) if isinstance(value, tuple) else factor * value


def added(a, b):
    if isinstance(a, tuple) != isinstance(b, tuple):
        raise ValueError(f"sum of {a} and {b}")
    return tuple(x + y for x, y in zip(a, b, strict=True)) if isinstance(a, tuple) else a + b


def total(values):
    values = list(values)
    result = values[0]
    for value in values[1:]:
        result = added(result, value)
    return result


def elementary(k, pairs):
    """The sum over the k-subsets of the u inside and the masses outside."""
    n = len(pairs)
    return sum(
        prod((pairs[i][0] if i in subset else pairs[i][1] for i in range(n)), start=Fraction(1))
        for subset in map(set, itertools.combinations(range(n), k))
    )


def point(coordinates):
    numbers = tuple(Fraction(x) for x in coordinates)
    return numbers[0] if len(numbers) == 1 else numbers


class Map:
    vertices = ()


class PolynomialByCoefficients(Map):
    def __init__(self, definition):
        self.coefficients = [point(c) for c in definition["coefficients"]]
        self.degree = len(self.coefficients) - 1

    def blossom(self, pairs, _span):
        n = self.degree
        return total(scaled(elementary(k, pairs) / comb(n, k), c) for k, c in enumerate(self.coefficients))


class PolynomialByNames(Map):
    """With numbers from the context as its coefficients."""

    def __init__(self, definition, context):
        self.trees, self.context = definition["coefficients"], context
        self.degree = len(self.trees) - 1

    def blossom(self, pairs, _span):
        n, value = self.degree, self.context.value
        return sum(value(tree) * elementary(k, pairs) / comb(n, k) for k, tree in enumerate(self.trees))


class PolynomialByControlPoints(Map):
    def __init__(self, definition):
        self.points = [point(p) for p in definition["control_points"]]
        self.a, self.b = (Fraction(x) for x in definition["interval"])
        self.degree = len(self.points) - 1

    def blossom(self, pairs, _span):
        points = self.points
        for u, mass in pairs:
            left, right = (self.b * mass - u) / (self.b - self.a), (u - self.a * mass) / (self.b - self.a)
            points = [added(scaled(left, p), scaled(right, q)) for p, q in zip(points, points[1:])]
        return points[0]


class Spline(Map):
    """Control point j is the value at the n knots after the first of its n + 2; a span is named by its first knot."""

    def __init__(self, definition):
        self.degree = definition["degree"]
        self.knots = [Fraction(t) for t in definition["knots"]]
        self.points = [point(p) for p in definition["control_points"]]
        if len(self.knots) == len(self.points) + self.degree + 1:
            self.knots = self.knots[1:-1]
            self.shift = 1
        else:
            self.shift = 0

    def blossom(self, pairs, span):
        """By de Boor's recursion; without a span the arguments must be consecutive knots."""
        n = self.degree
        if span is None:
            wanted = sorted(u for u, mass in pairs)
            for j, p in enumerate(self.points):
                if self.knots[j : j + n] == wanted:
                    return p
            raise ValueError(f"{pairs} are not consecutive knots")
        first = span - self.shift - n + 1
        t = self.knots[first : first + 2 * n]
        row = self.points[first : first + n + 1]
        for level, (u, mass) in enumerate(pairs):
            row = [
                added(
                    scaled((t[n + j] * mass - u) / (t[n + j] - t[level + j]), row[j]),
                    scaled((u - t[level + j] * mass) / (t[n + j] - t[level + j]), row[j + 1]),
                )
                for j in range(n - level)
            ]
        return row[0]

    def span_at(self, t):
        n, last = self.degree, len(self.points) - 1
        inside = [i for i in range(n - 1, last) if self.knots[i] <= t < self.knots[i + 1]]
        if not inside:
            inside = [i for i in range(n - 1, last) if self.knots[i] < self.knots[i + 1] == t]
        return inside[-1] + self.shift


class Triangle(Map):
    """By the definition: every way to assign a vertex to each argument, with the product of coordinates."""

    def __init__(self, definition):
        self.degree = n = definition["degree"]
        indices = [(i, j, n - i - j) for i in range(n, -1, -1) for j in range(n - i, -1, -1)]
        self.net = dict(zip(indices, (point(p) for p in definition["control_net"]), strict=True))
        self.vertices = [point(v) for v in definition.get("vertices", [])]

    def blossom(self, arguments, _span):
        values = []
        for choice in itertools.product(range(3), repeat=self.degree):
            weight = prod((x[k] for x, k in zip(arguments, choice)), start=Fraction(1))
            values.append(scaled(weight, self.net[tuple(choice.count(k) for k in range(3))]))
        return total(values)

    def barycentric(self, place):
        """By Cramer's rule."""

        def area(p, q, r):
            return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])

        a, b, c = self.vertices
        whole = area(a, b, c)
        return area(place, b, c) / whole, area(a, place, c) / whole, area(a, b, place) / whole


KINDS = {
    "polynomial": PolynomialByCoefficients,
    "bezier": PolynomialByControlPoints,
    "bspline": Spline,
    "triangle": Triangle,
}


class Context:
    def __init__(self, document, seed=0):
        self.random = random.Random(seed)
        self.maps, self.blossoms = {}, {}
        for entry in document["maps"]:
            definition = entry["definition"]
            if definition["kind"] == "symbolic":
                defined = PolynomialByNames(definition, self)
            else:
                defined = KINDS[definition["kind"]](definition)
            self.maps[entry["map"]] = defined
            self.blossoms[entry["blossom"]] = defined
        self.symbols = {"delta": None}
        # "u12" is the letter u with an index.
        self.points = {
            re.sub(r"^([a-z])(\d+)$", r"\1_\2", name): tuple(map(Fraction, place))
            for name, place in document["points"].items()
        }
        for name, place in self.points.items():
            for vertices in (d.vertices for d in self.maps.values() if d.vertices):
                # As a value, a point is its coordinates; as an argument, it has barycentric coordinates.
                self.symbols[name] = total(scaled(x, v) for x, v in zip(place, vertices, strict=True))
            self.symbols.setdefault(name, place)

    def value(self, tree):
        return getattr(self, "value_" + tree["kind"])(tree)

    def parts(self, tree):
        return [self.value(part) for part in tree.get("parts", [])]

    def value_number(self, tree):
        return Fraction(tree["value"])

    def value_symbol(self, tree):
        name = tree["name"]
        if name == "delta":
            raise Unknown("a vector alone has no value")
        if name not in self.symbols:
            self.symbols[name] = Fraction(self.random.randrange(-9, 10), self.random.randrange(1, 6))
        return self.symbols[name]

    @staticmethod
    def indexed_name(tree):
        """ "t_1" for a letter with a number as index, otherwise None."""
        if tree["kind"] != "index":
            return None
        base, subscript = tree["parts"]
        fits = base["kind"] == "symbol" and subscript["kind"] == "number"
        return base["name"] + "_" + subscript["value"] if fits else None

    def value_index(self, tree):
        name = self.indexed_name(tree)
        if name is None:
            raise Unknown("an index that varies")
        return self.value_symbol({"name": name})

    def value_words(self, tree):
        raise Unknown("words")

    value_set = value_summation = value_words

    def value_sum(self, tree):
        return total(self.parts(tree))

    def value_product(self, tree):
        result = Fraction(1)
        for factor in self.parts(tree):
            result = scaled(factor, result) if not isinstance(factor, tuple) else scaled(result, factor)
        return result

    def value_fraction(self, tree):
        numerator, denominator = self.parts(tree)
        return scaled(1 / denominator, numerator)

    def value_power(self, tree):
        base, exponent = tree["parts"]
        if base["kind"] == "tuple" and len(base["parts"]) == 1:
            base = base["parts"][0]
        return self.value(base) ** int(self.value(exponent))

    def value_binomial(self, tree):
        n, k = self.parts(tree)
        return Fraction(comb(int(n), int(k)))

    def value_factorial(self, tree):
        return Fraction(factorial(int(self.parts(tree)[0])))

    def value_tuple(self, tree):
        values = tuple(self.parts(tree))
        return values[0] if len(values) == 1 else values

    def pair(self, tree):
        """An argument as (u, mass), or of a triangle as three coordinates."""
        name = tree["name"] if tree["kind"] == "symbol" else self.indexed_name(tree)
        if name in self.points:
            return self.points[name]
        if tree["kind"] == "symbol" and tree["name"] == "delta":
            return Fraction(1), Fraction(0)
        if tree["kind"] == "product" and tree["parts"][-1] == {"kind": "symbol", "name": "delta"}:
            return self.value(tree["parts"][0]), Fraction(0)
        if tree["kind"] == "tuple":
            return tuple(self.parts(tree))
        return self.value(tree), Fraction(1)

    def pairs(self, tree):
        return [self.pair(part) for part in tree.get("parts", [])]

    def value_elementary(self, tree):
        return elementary(int(tree["value"]), self.pairs(tree))

    def value_blossom(self, tree):
        pairs = self.pairs(tree)
        defined = self.blossoms[tree["name"]]
        if len(pairs) != defined.degree:
            raise ValueError(f"{len(pairs)} arguments for degree {defined.degree}")
        return defined.blossom(pairs, tree.get("span"))

    def at(self, name, pairs):
        """The map, or for a pair its homogeneous form."""
        defined = self.maps[name]
        if isinstance(defined, Triangle):
            place = pairs[0] if len(pairs) == 1 else defined.barycentric([u for u, mass in pairs])
            return defined.blossom([place] * defined.degree, None)
        if len(pairs) == 2:
            pair = (pairs[0][0], pairs[1][0])
        else:
            pair = pairs[0]
        span = defined.span_at(pair[0]) if isinstance(defined, Spline) else None
        return defined.blossom([pair] * defined.degree, span)

    def value_call(self, tree):
        return self.at(tree["name"], self.pairs(tree))

    def value_derivative(self, tree):
        """By the definition: n!/(n-k)! times the homogeneous form, differentiated term by term."""
        defined, order = self.maps[tree["name"]], int(tree["value"])
        t = self.parts(tree)[0]
        n = defined.degree
        span = defined.span_at(t) if isinstance(defined, Spline) else None
        # Newton's divided differences of n + 1 values give the polynomial of any map.
        nodes = [t + i for i in range(n + 1)]
        values = [defined.blossom([(x, Fraction(1))] * n, span) for x in nodes]
        differences = values
        coefficients = []
        for level in range(n + 1):
            coefficients.append(differences[0])
            differences = [
                scaled(Fraction(1, level + 1), added(q, scaled(-1, p))) for p, q in zip(differences, differences[1:])
            ]
        # sum_j c_j (x - t)(x - t - 1)...(x - t - j + 1), expanded at t.
        result = scaled(Fraction(0), values[0])
        basis = [Fraction(1)]
        for j, c in enumerate(coefficients):
            if order < len(basis):
                result = added(result, scaled(basis[order] * factorial(order), c))
            basis = [
                (basis[i - 1] if i > 0 else 0) - j * (basis[i] if i < len(basis) else 0) for i in range(len(basis) + 1)
            ]
        return result
