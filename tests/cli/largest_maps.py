"""Maps of every kind, whose degree, points, dimension and numbers are as large as the default limits allow."""

import itertools
import math
import random

LINE = 16 << 20
NUMBERS = 1 << 22
DEGREE = 10_000
DIGITS = 1_000_000
VARIABLES = 256
HUGE = 10**30

DIGIT_TEXT = "".join(random.Random(1).choices("123456789", k=DIGITS))


# Numbers in several styles: the number i of n, which together fill a line at most. Each list is strictly increasing.
def small(i, n):
    return i


def spread_fractions(i, n):
    """Denominators without common factors, whose common denominator is long."""
    return f"{i * (2 * i + 3) + 1}/{2 * i + 3}"


def long(i, n):
    """As many digits as a number may have, or as fit on a line."""
    return f"{i + 1}{DIGIT_TEXT[: max(1, min(DIGITS - 8, LINE * 3 // 4 // max(n, 1) - 12))]}"


def long_fractions(i, n):
    length = max(1, min(DIGITS - 8, LINE * 3 // 8 // max(n, 1) - 12))
    return f"{i + 1}{DIGIT_TEXT[:length]}/7{DIGIT_TEXT[length // 2 : length]}"


def exponents(i, n):
    return f"{i + 1}e999990"


def negative_exponents(i, n):
    return f"{i + 1}e-999990"


STYLES = [small, spread_fractions, long, long_fractions, exponents, negative_exponents]


class Shape:
    """The sizes of a map, and the style of its numbers; `names` are the axes that are at their largest."""

    def __init__(self, chosen):
        self.style = chosen.get("numbers of the map", small)
        self.degree = chosen.get("degree of the map", 2)
        self.points = chosen.get("points of the map", 0)
        self.dimension = chosen.get("dimension", 1)
        self.directions = chosen.get("directions of the map", 2)
        self.rational = chosen.get("weights", False)
        self.room = NUMBERS // 2 if self.style is small else NUMBERS // 5 if self.style is spread_fractions else NUMBERS // 8

    def net_degree(self, coordinates_per_point=0):
        """The degree, or what the directions leave of it."""
        most = max(1, self.room // (self.dimension + coordinates_per_point))
        degree = self.degree
        while degree > 1 and (degree + 1) ** self.directions > most:
            degree = degree * 9 // 10
        return degree if (degree + 1) ** self.directions <= most else 0


MAP_AXES = {
    "numbers of the map": STYLES[1:],
    "degree of the map": [DEGREE, 300, 24],
    "points of the map": [NUMBERS],
    "dimension": [NUMBERS, 100],
    "directions of the map": [21, 190, VARIABLES],
    "weights": [True],
}


def point(shape, i, n, style=None):
    style = style or shape.style
    if shape.dimension == 1:
        return style(i, n)
    return [style((i * 7 + k) % 1000 if style is small else i * shape.dimension + k, n * shape.dimension) for k in range(shape.dimension)]


def points(shape, n):
    shape.dimension = max(1, min(shape.dimension, shape.room // n))
    return [point(shape, i, n) for i in range(n)]


def nested(sizes, make):
    count = itertools.count()

    def level(depth):
        return make(next(count)) if depth == len(sizes) else [level(depth + 1) for _ in range(sizes[depth])]

    return level(0)


def bezier(shape):
    value = {"kind": "bezier", "control_points": points(shape, shape.degree + 1)}
    if shape.rational:
        value["weights"] = [i % 5 + 1 for i in range(shape.degree + 1)]
    return value


def polynomial(shape):
    value = {"kind": "polynomial", "coefficients": points(shape, shape.degree + 1)}
    if shape.rational:
        value["denominator"] = [i % 5 + 1 for i in range(shape.degree + 1)]
    return value


def polynomial_text(shape):
    n = shape.degree
    number = shape.style(2, 4)
    count = max(1, min(shape.dimension, LINE // 3 // (len(str(number)) + 30)))
    texts = [f"({number} + t/3)^{n} + {k} t^{n}" for k in range(count)]
    value = {"kind": "polynomial", "text": texts[0] if count == 1 else texts}
    if shape.rational:
        value["denominator"] = f"1 + t^{n}"
    return value


def taylor(shape):
    value = {"kind": "taylor", "center": shape.style(1, 4), "coefficients": points(shape, shape.degree + 1)}
    if shape.rational:
        value["denominator"] = [i % 5 + 1 for i in range(shape.degree + 1)]
    return value


def bspline(shape):
    n = shape.degree
    count = max(n + 3, min(shape.points, shape.room // 2 // shape.dimension))
    total = 2 * count + n + 1
    value = {
        "kind": "bspline",
        "degree": n,
        "knots": [shape.style(i, total) for i in range(count + n + 1)],
        "control_points": points(shape, count),
    }
    if shape.rational:
        value["weights"] = [i % 5 + 1 for i in range(count)]
    return value


def progressive(shape):
    n = shape.degree
    value = {"kind": "progressive", "knots": [shape.style(i, 3 * n + 1) for i in range(2 * n)], "control_points": points(shape, n + 1)}
    if shape.rational:
        value["weights"] = [i % 5 + 1 for i in range(n + 1)]
    return value


def hermite(shape):
    all_points = points(shape, shape.degree + 1)
    half = len(all_points) // 2
    value = {"kind": "hermite", "left": all_points[half:], "right": all_points[:half]}
    if shape.rational:
        value["denominator"] = {"left": [i % 5 + 1 for i in range(len(all_points) - half)], "right": [1] * half}
    return value


def samples(shape):
    """All nodes of the inverse formula, or as many as fit."""
    n = shape.degree
    most = min(n, 900)
    nodes = [(i, k) for k in range(1, most + 1) for i in range(k + 1) if math.gcd(i, k) == 1]
    shape.dimension = max(1, min(shape.dimension, shape.room // len(nodes)))
    return {"kind": "samples", "degree": n, "values": [[f"{i}/{k}", point(shape, j, 2 * len(nodes))] for j, (i, k) in enumerate(nodes)]}


def tensor(shape):
    shape.directions = min(shape.directions, 190)
    n = shape.net_degree()
    sizes = [n + 1] * shape.directions
    count = (n + 1) ** shape.directions
    value = {"kind": "tensor", "degrees": [n] * shape.directions, "control_net": nested(sizes, lambda i: point(shape, i, count))}
    if shape.rational:
        value["weights"] = nested(sizes, lambda i: i % 5 + 1)
    return value


def compositions(total, parts):
    if parts == 1:
        yield [total]
        return
    for first in range(total, -1, -1):
        for rest in compositions(total - first, parts - 1):
            yield [first, *rest]


def simplex_shape(shape):
    """A degree and a count of barycentric coordinates that fit on a line, with the larger degree or the more coordinates."""
    corners = {2: 3, 21: 21, 190: 900, VARIABLES: VARIABLES}[shape.directions]
    degree = shape.degree
    while degree > 1 and (corners + shape.dimension + 2) * math.comb(degree + corners - 1, degree) > shape.room:
        degree = degree * 9 // 10
    return degree, corners


def simplex(shape):
    degree, corners = simplex_shape(shape)
    indices = list(compositions(degree, corners))
    shape.dimension = max(1, min(shape.dimension, shape.room // len(indices)))
    net = [[index, point(shape, i, len(indices))] for i, index in enumerate(indices)]
    value = {"kind": "simplex", "degree": degree, "control_net": net}
    if shape.rational:
        value["weights"] = [[index, i % 5 + 1] for i, index in enumerate(indices)]
    return value


def polynomial_with_variables(shape):
    variables = [f"x{i}" for i in range(shape.directions)]
    n = shape.degree
    terms = [[[0] * i + [n] + [0] * (shape.directions - i - 1), point(shape, i, 2 * shape.directions)] for i in range(shape.directions)]
    if shape.points:
        step = max(1, shape.directions)
        terms = [[[(i // (n + 1) ** k) % (n + 1) for k in range(step)], 1] for i in range(min(shape.room // step, (n + 1) ** min(step, 9)))]
    elif shape.dimension * shape.directions > shape.room:
        shape.dimension = shape.room // shape.directions
        terms = [[exponent, point(shape, i, shape.directions)] for i, (exponent, _) in enumerate(terms)]
    value = {"kind": "polynomial", "variables": variables, "terms": terms}
    if shape.rational:
        value["denominator"] = f"1 + x0^{n}"
    return value


def polynomial_text_with_variables(shape):
    variables = [f"x{i}" for i in range(shape.directions)]
    total = " + ".join(variables)
    return {"kind": "polynomial", "variables": variables, "text": f"({total} + {shape.style(2, 4)})^{shape.degree}"}


def polynomial_with_degrees(shape):
    value = polynomial_with_variables(shape)
    value["degrees"] = [shape.degree] * shape.directions
    return value


def bspline_with_degrees(shape):
    shape.directions = min(shape.directions, 190)
    n = shape.net_degree()
    count = n + 3 if shape.directions < 9 else n + 1
    if shape.points and shape.directions == 2:
        count = max(count, int((shape.room // 2 // shape.dimension) ** 0.5))
    all_points = count**shape.directions
    total = 2 * all_points
    knots = [shape.style(i, 4 * (count + n + 1) * shape.directions) for i in range(count + n + 1)]
    net = nested([count] * shape.directions, lambda i: point(shape, i, total))
    value = {"kind": "bspline", "degrees": [n] * shape.directions, "knots": [knots] * shape.directions, "control_net": net}
    if shape.rational:
        value["weights"] = nested([count] * shape.directions, lambda i: i % 5 + 1)
    return value


# By the names that the schema has for the kinds; some are made in several forms.
KINDS = {
    "polynomial": [polynomial, polynomial_text],
    "bezier": [bezier],
    "taylor": [taylor],
    "bspline": [bspline],
    "progressive": [progressive],
    "hermite": [hermite],
    "samples": [samples],
    "tensor": [tensor],
    "simplex": [simplex],
    "polynomial_with_variables": [polynomial_with_variables, polynomial_text_with_variables, polynomial_with_degrees],
    "bspline_with_degrees": [bspline_with_degrees],
}
