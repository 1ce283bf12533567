#!/usr/bin/env python3
"""Requests of every operation, each field of which is as large as the default limits allow, alone and together.

    largest_arguments.py PROGRAM [--full] [--seed S] [--cases N] [--jobs N]

The operations, their fields and the words that these may be are those of `blossom schema`; an operation, field or kind of map
that this file has no values for is an error. A request has axes: the degree, the number of points, the dimension, the digits of its
map, and each field. One axis at a time is at its largest, then two, then all, on every kind of map. Each request must get one
response, that is not `internal`, within the processor time and the memory of the limits. A sample by default, which takes half a
minute, with a timeout of one second; --full has the default timeout, and all cases but for the pairs, of which it has a sample.
"""

import argparse
import itertools
import json
import math
import multiprocessing.pool
import random
import re
import subprocess
import sys
from typing import NamedTuple

from measured import run_alone

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
    if shape.points:
        step = max(1, shape.directions)
        terms = [[[(i // (n + 1) ** k) % (n + 1) for k in range(step)], 1] for i in range(min(shape.room // step, (n + 1) ** min(step, 9)))]
    else:
        shape.dimension = max(1, min(shape.dimension, shape.room // shape.directions))
        terms = [[[0] * i + [n] + [0] * (shape.directions - i - 1), point(shape, i, 2 * shape.directions)] for i in range(shape.directions)]
    value = {"kind": "polynomial", "variables": variables, "terms": terms}
    if shape.rational:
        value["denominator"] = f"1 + x0^{n}"
    return value


def polynomial_text_with_variables(shape):
    variables = [f"x{i}" for i in range(shape.directions)]
    total = " + ".join(variables)
    text = f"({total} + {shape.style(2, 4)})^{shape.degree}"
    count = max(1, min(shape.dimension, LINE // 3 // (len(text) + 4)))
    return {"kind": "polynomial", "variables": variables, "text": text if count == 1 else [text] * count}


def polynomial_with_degrees(shape):
    value = polynomial_with_variables(shape)
    value["degrees"] = [shape.degree] * shape.directions
    return value


def taylor_with_variables(shape):
    value = polynomial_with_variables(shape)
    value |= {"kind": "taylor", "center": [shape.style(i, shape.directions) for i in range(shape.directions)]}
    if shape.rational:
        value["denominator"] = [[[0] * shape.directions, 1], [[shape.degree] + [0] * (shape.directions - 1), 1]]
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
    "taylor_with_variables": [taylor_with_variables],
}


CURVES = {maker for kind in ("polynomial", "bezier", "taylor", "bspline", "progressive", "hermite", "samples") for maker in KINDS[kind]}


# What a field must be to fit a map.
def directions_of(a_map):
    """0 for a curve; the coordinates of a point for a simplex, the directions for a tensor product."""
    if a_map["kind"] == "simplex":
        return len(a_map["control_net"][0][0])
    return len(a_map.get("variables", a_map.get("degrees", [])))


def degree_of(a_map):
    if "degree" in a_map:
        return a_map["degree"]
    if "text" in a_map:
        return int(re.search(r"\^(\d+)", str(a_map["text"])).group(1))
    if "terms" in a_map:
        return sum(a_map["terms"][0][0])
    return len(a_map.get("control_points", a_map.get("coefficients", a_map.get("left", []) + a_map.get("right", [])))) - 1


def parameter(a_map, style, i, n):
    """A parameter in the domain: of a B-spline a knot within it if there is one, for others anything but the ends of intervals."""
    directions = directions_of(a_map)
    if a_map["kind"] == "bspline":
        if not directions:
            return a_map["knots"][a_map["degree"] + 1]
        return [a_map["knots"][k][a_map["degrees"][k] + 1] for k in range(directions)]
    if not directions:
        return style(i + 2, n)
    if a_map["kind"] == "simplex":
        return [style(i, 2 * n), f"-{style(i, 2 * n)}", 1] + [0] * (directions - 3)
    return [style(i + k + 2, n * directions) for k in range(directions)]


def several(count, a_map, style):
    count = max(1, min(count, LINE // 12 // max(1, directions_of(a_map)), NUMBERS // 2))
    return [parameter(a_map, style, i, count) for i in range(count)]


def numbers(level):
    count, style = level
    return [style(i, count) for i in range(min(count, LINE // 12))]


def points_of_plane(a_map, level):
    count, style = level or (1, small)
    return [[style(i, 2 * count)] * 2 for i in range(min(count, LINE // 24))]


def parameters(a_map, level):
    count, style = level or (2, small)
    return several(count, a_map, style)


def arguments(a_map, level):
    wrap, style = level or (lambda value: value, small)
    if "degrees" in a_map:
        total = sum(a_map["degrees"])
        return [[wrap(style(i % 500, total)) for i in range(n)] for n in a_map["degrees"]]
    n = degree_of(a_map)
    return [wrap(parameter(a_map, style, i, n)) for i in range(n)]


def segment(a_map, level):
    if level is not None or a_map["kind"] != "bspline":
        return level
    return [n + 1 for n in a_map["degrees"]] if directions_of(a_map) else a_map["degree"] + 1


def homogeneous(value):
    return {"homogeneous": value if isinstance(value, list) else [value, 3]}


def vector(value):
    return {"vector": value}


STYLE_AXIS = [spread_fractions, long, exponents]
MANY = [(NUMBERS, small), (1000, spread_fractions), (12, long), (12, long_fractions), (100_000, exponents), (5, negative_exponents)]
COUNTS = [DEGREE, 200, DIGITS, NUMBERS, 2**63, HUGE]


def count_field(default):
    return COUNTS, lambda a_map, level: default if level is None else level


def inserted_knots(a_map, level):
    """In the domain, where the knots of the map are whole numbers."""
    if a_map["kind"] != "bspline":
        return several(level[0], a_map, level[1]) if level else [1]
    count, style = level or (1, small)
    directions = directions_of(a_map)
    count = max(1, min(count, LINE // 12 // max(1, directions)))
    first, last = (a_map["degrees"][0] if directions else a_map["degree"]), len(a_map["knots"][0] if directions else a_map["knots"])
    knots = [f"{first}.{i + 1}" if style is small else f"{first}.{str(style(i, count)).replace('/', '7').split('e')[0]}" for i in range(count)]
    if style in (exponents, negative_exponents):
        knots = [f"{first + 1}e0"] + [f"{first}.{'0' * 1000}{i + 1}" for i in range(min(count, 10_000) - 1)]
    assert first < last
    return [knots[: max(1, count // directions)]] * directions if directions else knots


def pair(a_map, level):
    style = level or small
    return [style(1, 4), style(2, 4)]


def part(a_map, level):
    """An interval, of a B-spline within its domain."""
    if a_map["kind"] == "bspline" and not directions_of(a_map):
        return a_map["knots"][a_map["degree"] : a_map["degree"] + 2]
    if a_map["kind"] == "bspline":
        return a_map["knots"][0][a_map["degrees"][0] : a_map["degrees"][0] + 2]
    return pair(a_map, level)


def along(default):
    """The index of a direction of a tensor product."""
    return ([DEGREE, HUGE], lambda a_map, level: (level or default) if "degrees" in a_map else None)


def inner_knot(a_map, level):
    if level is None and a_map["kind"] == "bspline":
        return a_map["knots"][0][a_map["degrees"][0] + 1] if directions_of(a_map) else parameter(a_map, small, 0, 1)
    return (level or small)(1, 2)


def vertices(a_map, level):
    """The origin and a multiple of each unit vector."""
    size, style = level or (2, small)
    return [[style(i * size + k, size * size) if i == k + 1 else 0 for k in range(size)] for i in range(size + 1)]


def directions(a_map, level):
    if level is None:
        return None
    count, style = level
    direction = direction_of_patch(a_map, style)
    return [direction] * max(1, min(count, LINE // len(json.dumps(direction))))


def intervals(a_map, level):
    if level is None:
        return None
    count = 4 * directions_of(a_map) + 4
    return [[level(1, count), level(2, count)]] * directions_of(a_map)


def direction_of_patch(a_map, style):
    directions = directions_of(a_map)
    if a_map["kind"] == "simplex":
        return [style(1, 2), f"-{style(1, 2)}"] + [0] * (directions - 2)
    return [style(k + 1, directions) for k in range(directions)]


def document(a_map, level):
    """A file of tinyspline."""
    count, style = level or (4, small)
    number = {small: lambda i: i / 3, exponents: lambda i: 1e308 - i * 1e300, negative_exponents: lambda i: 5e-324 * i}[style]
    degree = min(3 if level is None else DEGREE, count - 1)
    knots = [0.0] * (degree + 1) + [float(i + 1) for i in range(count - degree - 1)] + [float(count)] * (degree + 1)
    return {"degree": degree, "dimension": 1, "control_points": [number(i) for i in range(count)], "knots": knots}


def audited_document(a_map, level):
    """The curve itself where its numbers are short, so that the two fit."""
    if a_map["kind"] != "bspline" or directions_of(a_map) or not isinstance(a_map["knots"][0], int):
        return document(a_map, level)
    flat = [value for p in a_map["control_points"] for value in (p if isinstance(p, list) else [p])]
    dimension = len(flat) // len(a_map["control_points"])
    return {"degree": a_map["degree"], "dimension": dimension, "control_points": flat, "knots": a_map["knots"]}


def dimension_of(a_map):
    """The coordinates of a point without its weight."""
    if "text" in a_map:
        return len(a_map["text"]) if isinstance(a_map["text"], list) else 1
    name = next(name for name in ("control_points", "control_net", "coefficients", "terms", "left", "values") if name in a_map)
    value = a_map[name]
    pairs = name in ("terms", "values") or a_map["kind"] == "simplex"
    for _ in range(1 if pairs or name != "control_net" else len(a_map["degrees"])):
        value = value[0]
    value = value[1] if pairs else value
    return len(value) if isinstance(value, list) else 1


def matrix_of_rows(a_map, level):
    """One row of a style, or so many rows of small numbers."""
    columns = dimension_of(a_map)
    if isinstance(level, int):
        return [[i + j for j in range(columns)] for i in range(min(level, max(1, LINE // 24 // columns)))]
    return [(level or small)(j, columns) for j in range(columns)]


def at_in_one_direction(a_map, level):
    value = parameter(a_map, level or small, 1, 2)
    return [value[0]] + [None] * (len(value) - 1) if isinstance(value, list) else value


def doubles_like(value):
    return [doubles_like(part) for part in value] if isinstance(value, list) else 0.1


def computed(a_map, level):
    if a_map["kind"] == "samples":
        return {"control_points": [0.5] * (a_map["degree"] + 1)}
    for member in ("control_points", "control_net", "coefficients", "terms", "left"):
        if member in a_map:
            value = a_map[member]
            if member == "terms" or (member == "control_net" and a_map["kind"] == "simplex"):
                return {member: [[index, doubles_like(p)] for index, p in value]}
            return {member: doubles_like(value)}
    return {"values": [0.5] * 2}


def wide_sum(count):
    return "claim " + " + ".join(f"x{i}" for i in range(count)) + " == 3"


STATEMENTS = [
    "claim (a + b + c + d + e + f)^40 == 1",
    "claim x^10000 == x",
    "claim (x + 1)^10000 == x",
    "for n in 1..10000\nclaim n == n",
    "for n in 1..1000000000\nclaim n == n",
    "map a degree 10000\nclaim a'(t) == 10000 * a[t{9999}, delta]",
    "map a degree 20\nclaim a[" + ", ".join(f"s{i}" for i in range(20)) + "] == 1",
    f"claim {DIGIT_TEXT} == 1",
    f"claim 1/{DIGIT_TEXT} + 1/{DIGIT_TEXT[1:]} == x",
    f"claim x^{HUGE} == 1",
    wide_sum(200_000),
    "claim " + "(" * 190 + "x" + ")" * 190 + " == x",
    "claim sum(x_i for i in 1..1000000) == 1",
    "\n".join(f"given a{i}^2 == b{i}" for i in range(250)) + "\nclaim a0*a1 == b0",
    "\n".join("claim x == x" for _ in range(200_000)),
    "# " + "x" * (LINE - 200),
    ["claim x == x"] * 200_000,
]


def sub_request(a_map, level):
    return level or {"op": "blossom", "map": {"kind": "bezier", "control_points": [0, 1, 5]}, "arguments": [1, 2]}


def large_requests():
    n = 1000
    yield {"op": "blossom", "map": {"kind": "bezier", "control_points": list(range(DEGREE + 1))}, "arguments": list(range(DEGREE))}
    yield {"op": "blossom", "map": {"kind": "bezier", "control_points": [exponents(i, 3) for i in range(3)]}, "arguments": [1, 2]}
    yield {"op": "blossom", "map": {"kind": "bezier", "control_points": [long(i, 3) for i in range(3)]}, "arguments": [1, "1/3"]}
    yield {"op": "agree", "map": {"kind": "polynomial", "text": "t^20"}}
    yield {"op": "derivative", "map": {"kind": "polynomial", "text": "1 + t^300", "denominator": "1 + t"}, "order": 300, "at": [2]}
    yield {"op": "control-points", "map": {"kind": "polynomial", "text": f"(1 + t/3)^{n}"}, "degree": 3 * n}


def pages():
    yield from large_requests()
    cubic = {"kind": "bspline", "degree": 3, "knots": list(range(10_008)), "control_points": [i % 7 for i in range(10_004)]}
    yield {"op": "segments", "map": cubic}
    yield {"op": "insert-knots", "map": cubic, "knots": [f"{i}/2" for i in range(7, 3001, 2)]}
    yield {"op": "evaluate", "map": {"kind": "bezier", "control_points": [i % 7 for i in range(301)]}, "at": ["1/3"] * 300}
    yield {"op": "elevate", "map": {"kind": "bezier", "control_points": [1, 2, 7]}, "by": 2000}
    yield {"op": "subdivide", "map": {"kind": "bezier", "control_points": [i % 7 for i in range(2001)]}, "at": "1/3"}
    yield {"op": "prove", "statement": "for n in 1..300\nmap a degree n\nclaim a'(t) == n * a[t{n-1}, delta]"}


# The levels of a field beyond its small value, and its value for a map. A value of None leaves the field out.
FIELDS = {
    "arguments": ([(wrap, style) for wrap in (lambda value: value, homogeneous, vector) for style in [small, *STYLE_AXIS]], arguments),
    "at": (MANY, parameters),
    "segment": ([DEGREE, NUMBERS, HUGE, [0] * 1000], segment),
    "order": count_field(None),
    "direction": (STYLE_AXIS, lambda a_map, level: direction_of_patch(a_map, level or small) if directions_of(a_map) else None),
    "directions": ([(n, s) for n in (DEGREE, 12) for s in [small, *STYLE_AXIS]], directions),
    "interval": (STYLES[1:], lambda a_map, level: level and pair(a_map, level)),
    "intervals": (STYLES[1:], intervals),
    "vertices": ([(1000, small), (100, spread_fractions), (2, long), (12, exponents)], lambda a_map, level: level and vertices(a_map, level)),
    "degree": count_field(None),
    "degrees": (COUNTS, lambda a_map, level: level and [level] * directions_of(a_map)),
    "center": (STYLES[1:], lambda a_map, level: level and ([level(i, 2) for i in range(len(a_map["variables"]))] if "variables" in a_map else level(1, 2))),
    "faces": ([], lambda a_map, level: None),
    "counts": ([[DEGREE, 1], [5000, 5000], [HUGE, HUGE], [0, DEGREE]], lambda a_map, level: level),
    "by": count_field(1),
    "to": ([DEGREE, NUMBERS, HUGE, 0], lambda a_map, level: 1 if level is None else level),
    "knots": (MANY, inserted_knots),
    "times": count_field(None),
    "multiplicity": count_field(None),
    "from": (STYLES[1:], lambda a_map, level: level and pair(a_map, level)),
    "clamped": ([], lambda a_map, level: None),
    "width": (["1e-999990", "1e-10000", long(1, 1), "1/" + long(1, 1)], lambda a_map, level: level),
    "statement": (STATEMENTS, lambda a_map, level: level or "claim x == x"),
    "document": ([(700_000, small), (DEGREE + 1, small), (300, exponents), (300, negative_exponents)], document),
    "request": (list(pages()), sub_request),
    "requests": (
        [[request] for request in large_requests()] + [[sub_request(None, None)] * 100_000],
        lambda a_map, level: level or [sub_request(None, None)],
    ),
    "seed": count_field(None),
    "count": ([40, *COUNTS], lambda a_map, level: level),
    "level": ([3, *COUNTS], lambda a_map, level: level),
    "columns": ([1, *COUNTS], lambda a_map, level: level),
    "id": (
        ["x" * (LINE // 2), nested([1] * 190, lambda i: i), list(range(NUMBERS // 4)), int(DIGIT_TEXT[:4000]), {str(i): i for i in range(500_000)}],
        lambda a_map, level: level,
    ),
}

BASES = [
    {"basis": "monomial", "degree": DEGREE},
    {"basis": "bernstein", "degree": 300},
    {"basis": "taylor", "degree": 3, "center": long(1, 1)},
    {"basis": "bernstein", "degree": 2, "interval": [exponents(0, 2), negative_exponents(1, 2)]},
    {"basis": "lagrange", "nodes": numbers((300, spread_fractions))},
    {"basis": "lagrange", "nodes": numbers((4, long_fractions))},
    {"basis": "newton", "nodes": numbers((DEGREE, small))},
    {"basis": "bspline", "degree": 3, "knots": numbers((DEGREE, small))},
    {"basis": "bspline", "degree": 300, "knots": numbers((700, spread_fractions))},
]


def lattice(dimension, degree):
    return [[index, i] for i, index in enumerate(compositions(degree, dimension + 1))]


# Fields that mean something else in one operation.
OF_OPERATION = {
    ("subdivide", "at"): (STYLES[1:], lambda a_map, level: parameter(a_map, level or small, 1, 2)),
    ("continuity", "at"): (STYLES[1:], at_in_one_direction),
    ("trim", "interval"): (STYLES[1:], part),
    ("remove-knot", "knot"): (STYLE_AXIS, inner_knot),
    ("insert-knots", "direction"): along(None),
    ("clamp", "direction"): along(None),
    ("reparametrise", "direction"): along(None),
    ("remove-knot", "direction"): along(0),
    ("join", "direction"): along(0),
    ("trim", "direction"): along(0),
    ("reverse", "direction"): along(0),
    ("periodic", "direction"): along(0),
    ("convert", "to"): ([], lambda a_map, level: "bernstein"),
    ("audit", "at"): (MANY, lambda a_map, level: parameters(a_map, level) if level or "text" in a_map else None),
    ("audit", "computed"): ([], computed),
    ("audit", "document"): ([(700_000, small), (DEGREE + 1, small), (300, exponents), (300, negative_exponents)], audited_document),
    ("join", "chain"): ([], lambda a_map, level: True),
    ("join", "knots"): (MANY, lambda a_map, level: level and numbers(level)),
    ("product", "as"): ([], lambda a_map, level: None),
    ("sum", "factors"): (STYLES[1:], lambda a_map, level: level and [level(1, 2), level(2, 2)]),
    ("transform", "matrix"): ([*STYLES[1:], 1000], matrix_of_rows),
    ("transform", "translation"): ([], lambda a_map, level: None),
    ("restrict", "vertices"): (STYLES[1:], lambda a_map, level: [parameter(a_map, small, 0, 2), parameter(a_map, level or small, 1, 2)]),
    ("restrict", "at"): ([], lambda a_map, level: None),
    ("bounds", "depth"): count_field(None),
    ("roots", "with"): (STYLES[1:], lambda a_map, level: level and [{"kind": "polynomial", "coefficients": [level(1, 2), 1]}]),
    ("nearest", "point"): (STYLES[1:], lambda a_map, level: [(level or small)(i + 1, 4) for i in range(dimension_of(a_map))]),
    ("extrema", "direction"): (STYLES[1:], lambda a_map, level: [(level or small)(i + 1, 4) for i in range(dimension_of(a_map))]),
    ("intersections", "with"): (STYLES[1:], lambda a_map, level: {"kind": "bezier", "control_points": [[(level or small)(i + j, 4) for j in range(2)] for i in range(3)]}),
    ("intersections", "with_interval"): ([], lambda a_map, level: None),
    ("intersections", "line"): ([], lambda a_map, level: None),
    ("resultant", "variable"): ([], lambda a_map, level: a_map.get("variables", [None])[-1]),
    ("export", "format"): ([], lambda a_map, level: "splinepy" if directions_of(a_map) else "tinyspline"),
    ("inverse-formula", "degree"): ([DEGREE, 600, 200, 40, DIGITS, HUGE], lambda a_map, level: level or 3),
    ("basis-functions", "degree"): ([DEGREE, 300, 40, HUGE], lambda a_map, level: level or 2),
    ("basis-functions", "knots"): (MANY, lambda a_map, level: numbers(level or (8, small))),
    ("basis-functions", "weights"): (STYLES[1:], lambda a_map, level: level and [level(i + 1, 6) for i in range(5)]),
    ("basis-matrix", "from"): (BASES, lambda a_map, level: level or {"basis": "monomial", "degree": 3}),
    ("basis-matrix", "to"): (BASES, lambda a_map, level: level or {"basis": "bernstein", "degree": 3}),
    ("interpolate", "values"): (MANY, lambda a_map, level: numbers(level or (3, small))),
    ("interpolate", "nodes"): (STYLES[1:], lambda a_map, level: level and numbers((3, level))),
    ("interpolate", "grid"): (STYLES[1:], lambda a_map, level: level and [numbers((3, level))]),
    ("interpolate", "lattice"): ([(2, 200), (30, 2), (3, 20)], lambda a_map, level: level and lattice(*level)),
    ("interpolate", "degrees"): ([2, *COUNTS], lambda a_map, level: level and [level]),
    ("interpolate", "intervals"): ([], lambda a_map, level: None),
    ("interpolate", "vertices"): ([], lambda a_map, level: None),
    ("interpolate", "knots"): ([], lambda a_map, level: None),
    ("interpolate", "degree"): ([], lambda a_map, level: None),
    ("barycentric", "at"): ([(NUMBERS, small), (1000, spread_fractions), (5, long), (1000, exponents)], points_of_plane),
    ("barycentric", "vertices"): ([(1000, small), (100, spread_fractions), (2, long), (12, exponents)], vertices),
}


def curve_in_domain(a_map):
    ends = [parameter(a_map, small, i, 2) for i in range(2)]
    return {"kind": "bezier", "control_points": ends}


# Operations on several maps over one domain.
ON_ONE_DOMAIN = {"sum", "product", "quotient", "compose", "gcd", "resultant"}


def words_of(schema, field):
    """The words that a field may be, wherever an operation's description lists them."""
    found = []

    def walk(node):
        if isinstance(node, list):
            for part in node:
                walk(part)
        elif isinstance(node, dict):
            own = node.get("properties", {}).get(field)
            if isinstance(own, dict):
                found.extend(own.get("enum", []))
                for alternative in own.get("anyOf", []):
                    found.extend(alternative.get("enum", []))
            for part in node.values():
                walk(part)

    walk(schema)
    return list(dict.fromkeys(found))


class Operation:
    def __init__(self, name, schema):
        self.name, self.schema = name, schema
        self.fields = {}
        self.missing = []
        # Without these, which are needed in one form or another, a request says too little.
        self.required = set(schema["required"]) | {"convert": {"to"}, "audit": {"computed", "at"}, "continuity": {"at"}}.get(name, set())
        for field, description in schema["properties"].items():
            if field in ("op", "map", "maps"):
                continue
            words = words_of(schema, field)
            levels, value = OF_OPERATION.get((name, field), FIELDS.get(field, (None, None)))
            if levels is None and words:
                default = words[0] if field in self.required else None
                levels, value = [], lambda a_map, level, default=default: default
            if levels is None and description.get("type") == "boolean":
                levels, value = [True, False], lambda a_map, level: level
            if levels is None:
                self.missing.append(field)
                continue
            self.fields[field] = ([*words, *levels], value)
        self.takes_maps = [field for field in ("map", "maps") if field in schema["properties"]]

    def find_makers(self, program):
        """Those of maps that the operation takes. What is small must be answered, or the kind be refused."""
        self.makers = []
        problems = []
        for maker in [maker for makers in KINDS.values() for maker in makers] if self.takes_maps else [None]:
            answer = answer_of(run_alone(program, [], self.request(maker, {})).output)
            if answer == "ok":
                self.makers.append(maker)
            elif not answer.startswith("wrong_kind"):
                problems.append(f"{self.name} {maker.__name__ if maker else ''}: a small request: {answer}")
        return problems

    def axes(self):
        """The names of the axes, with the number of levels of each."""
        return ({name: len(levels) for name, levels in MAP_AXES.items()} if self.takes_maps else {}) | {
            name: len(levels) for name, (levels, _) in self.fields.items()
        }

    def request(self, maker, chosen):
        """The line of the request with the chosen levels, as long as it may be. It is made of values that fit together."""
        sizes = {name: MAP_AXES[name][level] for name, level in chosen.items() if self.takes_maps and name in MAP_AXES}
        for name, most in (("dimension", NUMBERS), ("points of the map", NUMBERS)):
            if name in sizes:
                sizes[name] = min(sizes[name], most)
        if self.name in ("jacobian", "normal"):
            sizes.setdefault("dimension", (1 if maker in CURVES else sizes.get("directions of the map", 2)) + (self.name == "normal"))
        if self.name in ("inflections", "intersections", "self-intersections"):
            sizes.setdefault("dimension", 2)
        a_map = maker(Shape(sizes)) if maker else None
        if self.name == "periodic" and "control_points" in a_map:
            a_map["control_points"] = a_map["control_points"][:1] * len(a_map["control_points"])
        if self.name == "periodic" and "control_net" in a_map and "degrees" in a_map:
            a_map["control_net"] = a_map["control_net"][:1] * len(a_map["control_net"])
            if "weights" in a_map:
                a_map["weights"] = a_map["weights"][:1] * len(a_map["weights"])
        request = {"op": self.name}
        if "map" in self.takes_maps:
            request["map"] = a_map
        elif "maps" in self.takes_maps:
            second = dict(a_map)
            if a_map["kind"] == "bezier" and self.name not in ON_ONE_DOMAIN:
                second["interval"] = [1, 2]
            if self.name == "compose":
                second = curve_in_domain(a_map)
            request["maps"] = [a_map, second]
        for field, (levels, value) in self.fields.items():
            if self.name == "audit" and (field in ("document", "format")) != ("document" in chosen or "format" in chosen):
                continue
            if field == "direction" and "directions" in chosen:
                continue
            if self.name == "interpolate" and field == "values" and "lattice" in chosen:
                continue
            level = levels[chosen[field]] if field in chosen else None
            is_word = isinstance(level, str) and level in words_of(self.schema, field)
            result = level if is_word else value(a_map or {"kind": "none"}, level)
            if result is not None:
                request[field] = result
        return json.dumps(request, separators=(",", ":")).encode()


def operations(program):
    schema = json.loads(subprocess.run([program, "schema"], capture_output=True, check=True).stdout)["$defs"]
    names = [entry["$ref"].rsplit("/", 1)[1] for entry in schema["request"]["allOf"][0]["anyOf"]]
    kinds = [entry["$ref"].rsplit("/", 1)[1] for entry in schema["map"]["anyOf"]]
    missing = [f"the kind {kind} of maps" for kind in kinds if kind not in KINDS]
    result, problems = [], []
    for name in names:
        operation = Operation(name.removesuffix("_request"), schema[name])
        missing += [f"the field {field} of {operation.name}" for field in operation.missing]
        if not operation.missing:
            problems += operation.find_makers(program)
        result.append(operation)
    if missing:
        sys.exit("no largest values for " + ", ".join(missing))
    if problems:
        sys.exit("\n".join(problems))
    return result


def cases_of(operation, random_source, pairs):
    """Operation, form of the map, and the levels of the axes that are at their largest."""
    axes = operation.axes()
    for index, maker in enumerate(operation.makers):
        for name, levels in axes.items():
            for level in range(levels):
                # What has nothing to do with the map is tried with one.
                if index == 0 or name not in ("id", "numbers", "format"):
                    yield operation, maker, {name: level}
        for _ in range(2):
            yield operation, maker, {name: random_source.randrange(levels) for name, levels in axes.items() if levels and name != "id"}
    for _ in range(pairs):
        names = random_source.sample([name for name, levels in axes.items() if levels], min(2, len(axes)))
        yield operation, random_source.choice(operation.makers), {name: random_source.randrange(axes[name]) for name in names}


class Result(NamedTuple):
    case: tuple
    name: str
    line_bytes: int
    seconds: float
    size: int
    answer: str  # "ok", or the code and the message of an error
    problem: str  # "" if nothing is wrong


def answer_of(output):
    """Without parsing what may be long: members stand in a fixed order, and an `id` before them or a result after them is long."""
    if b'"ok": true' in output[:200] or b'"ok": true, "result"' in output:
        return "ok"
    tail = output[output.rfind(b'"ok": false, "error"') :].decode(errors="replace")
    error = json.loads("{" + tail)["error"]
    return f"{error['code']}: {error['message'][:120]}"


class Checker:
    def __init__(self, program, full):
        self.program = program
        self.options = [] if full else ["--timeout", "1"]
        floor = run_alone(program, [], b'{"op": "evaluate", "map": {"kind": "polynomial", "text": "t"}, "at": [1]}').size
        # The measures of the system are coarser than the counters of the program.
        self.seconds = 1.25 * (10 if full else 1) + 1
        self.size = floor + 1.25 * (1 << 30)

    def check(self, case):
        operation, maker, chosen = case
        name = f"{operation.name} {maker.__name__ if maker else ''} {', '.join(f'{axis}={level}' for axis, level in chosen.items())}"
        line = operation.request(maker, chosen)
        measured = run_alone(self.program, self.options, line)
        answer, problem = "", ""
        if measured.status not in (0, 1) or measured.output.count(b"\n") != 1:
            problem = f"exit status {measured.status}, {len(measured.output)} bytes"
        else:
            answer = answer_of(measured.output)
            if answer.startswith("internal"):
                problem = answer
            elif measured.seconds > self.seconds:
                problem = f"{measured.seconds:.1f} s"
            elif measured.size > self.size:
                problem = f"{measured.size >> 20} MB"
        return Result(case, name, len(line), measured.seconds, measured.size, answer, problem)


def unreached(results):
    """Fields and axes whose largest values were only ever refused as wrong, so that no limit was tried."""
    reached = {}
    for result in results:
        operation, _, chosen = result.case
        good = result.answer == "ok" or result.answer.startswith("limit_exceeded")
        for name in chosen:
            key = (operation.name, name)
            reached[key] = reached.get(key, False) or good
    return [f"{operation}: {name}" for (operation, name), good in reached.items() if not good]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--full", action="store_true")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--only", default="", help="the operations whose names begin so")
    parser.add_argument("--cases", type=int, help="per operation")
    options = parser.parse_args()
    random_source = random.Random(options.seed)
    cases = []
    for operation in operations(options.program):
        if operation.name.startswith(options.only):
            own = list(cases_of(operation, random_source, 40))
            count = options.cases or (len(own) if options.full else 4)
            cases += random_source.sample(own, min(count, len(own)))
    checker = Checker(options.program, options.full)
    with multiprocessing.pool.ThreadPool(options.jobs) as pool:
        results = []
        for result in pool.imap_unordered(checker.check, cases):
            results.append(result)
            if options.full:
                print(f"{result.seconds:6.2f} s {result.size >> 20:5} MB {result.line_bytes:9} bytes  {result.name}  {result.answer}", flush=True)
    failures = [f"{result.name}: {result.problem}" for result in results if result.problem]
    if options.full:
        failures += [f"no limit is reached by {what}" for what in unreached(results)]
    for failure in failures:
        print(failure)
    print(
        f"seed {options.seed}: {len(cases)} requests, {sum(result.answer == 'ok' for result in results)} answered, "
        f"{sum(result.answer.startswith('limit_exceeded') for result in results)} refused by limits; at most "
        f"{max(result.seconds for result in results):.1f} s, {max(result.size for result in results) >> 20} MB; {len(failures)} failures"
    )
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
