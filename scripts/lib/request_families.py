"""The requests that `scripts/bench --requests` measures: for each operation a function that creates one of a given size.

Each family states the meaning of its size. Everything else is random with a fixed seed, so that all lines are different.
"""

import json
import random


def fraction(rng):
    return f"{rng.randint(-99, 99)}/{rng.randint(1, 20)}"


def fractions(rng, count):
    return [fraction(rng) for _ in range(count)]


def points(rng, count, dimension=2):
    return [fractions(rng, dimension) for _ in range(count)]


def increasing(rng, count, start=0):
    """Increasing rational numbers after `start`."""
    numbers, at = [], 12 * start
    for _ in range(count):
        at += rng.randint(1, 23)
        numbers.append(f"{at}/12")
    return numbers


def polynomial(rng, degree):
    return {"kind": "polynomial", "degree": degree, "coefficients": fractions(rng, degree + 1)}


def bezier(rng, degree):
    return {"kind": "bezier", "control_points": points(rng, degree + 1)}


def clamped(rng, count, degree=3):
    """Knots for `count` control points, clamped at both ends."""
    inner = increasing(rng, count - degree - 1)
    end = f"{12 + (int(inner[-1].split('/')[0]) if inner else 0)}/12"
    return ["0"] * (degree + 1) + inner + [end] * (degree + 1)


def bspline(rng, count, degree=3):
    return {"kind": "bspline", "degree": degree, "knots": clamped(rng, count, degree), "control_points": points(rng, count)}


def inside(rng, spline, count):
    """Parameters inside the domain of a spline."""
    last = int(spline["knots"][-1].split("/")[0])
    return [f"{rng.randint(1, 97 * last - 1)}/{97 * 12}" for _ in range(count)]


def tensor(rng, degree):
    net = [points(rng, degree + 1, 3) for _ in range(degree + 1)]
    return {"kind": "tensor", "degrees": [degree, degree], "control_net": net}


def triangle(rng, degree):
    net = [[[i, j, degree - i - j], fractions(rng, 3)] for i in range(degree + 1) for j in range(degree + 1 - i)]
    return {"kind": "simplex", "degree": degree, "vertices": [["0", "0"], ["1", "0"], ["0", "1"]], "control_net": net}


def insert_knots(rng, size):
    spline = bspline(rng, size)
    return {"map": spline, "knots": sorted(inside(rng, spline, 3), key=lambda text: int(text.split("/")[0]))}


def remove_knot(rng, size):
    spline = bspline(rng, size)
    return {"map": spline, "knot": spline["knots"][4 + rng.randrange(size - 4)]}


def joined(rng, size):
    ends = ["0", *increasing(rng, size)]
    curves, start = [], fractions(rng, 2)
    for a, b in zip(ends, ends[1:]):
        inner = points(rng, 3)
        curves.append({"kind": "bezier", "interval": [a, b], "control_points": [start, *inner]})
        start = inner[-1]
    return {"maps": curves}


def continuity(rng, size):
    control = points(rng, size + 1)
    other = [control[-1], *points(rng, size)]
    return {
        "maps": [
            {"kind": "bezier", "interval": ["0", "1"], "control_points": control},
            {"kind": "bezier", "interval": ["1", "2"], "control_points": other},
        ],
        "at": "1",
    }


def audit(rng, size):
    spline = bspline(rng, size)
    values = [[rng.randint(-99, 99) / 8, rng.randint(-99, 99) / 8] for _ in range(3)]
    return {"map": spline, "at": inside(rng, spline, 3), "computed": {"values": values}}


def wide_roots(rng, size):
    return {"map": {"kind": "polynomial", "coefficients": [str(rng.randint(-999, 999)) for _ in range(size)] + ["1"]}, "interval": ["-10", "10"]}


def affine_step(rng, size):
    """The blossom is affine in its last argument; the others are names."""
    a, b = sorted(rng.sample(range(-99, 99), 2))
    others = "".join(f"u{i}, " for i in range(1, size))
    return {"statement": f"map p degree {size}\nclaim p[{others}u] == ({b}-u)/({b}-({a}))*p[{others}{a}] + (u-({a}))/({b}-({a}))*p[{others}{b}]"}


# Operation and variant, the meaning of the size, the three sizes, and the request without "id" and "op".
FAMILIES = [
    ("blossom", "degree", (3, 20, 100), lambda rng, n: {"map": polynomial(rng, n), "arguments": fractions(rng, n)}),
    ("blossom of a control polygon", "degree", (3, 20, 100), lambda rng, n: {"map": bezier(rng, n), "arguments": fractions(rng, n)}),
    ("control-points", "degree", (3, 20, 100), lambda rng, n: {"map": polynomial(rng, n), "interval": ["0", "1"]}),
    ("derivative", "degree", (3, 10, 100), lambda rng, n: {"map": polynomial(rng, n), "at": fractions(rng, 1)}),
    ("evaluate", "values of a cubic", (1, 30, 1000), lambda rng, n: {"map": polynomial(rng, 3), "at": fractions(rng, n)}),
    ("evaluate a spline", "control points", (8, 64, 512), lambda rng, n: (lambda s: {"map": s, "at": inside(rng, s, 1)})(bspline(rng, n))),
    ("evaluate a tensor patch", "degree", (3, 10, 30), lambda rng, n: {"map": tensor(rng, n), "at": [fractions(rng, 2)]}),
    ("evaluate a triangle", "degree", (3, 10, 30), lambda rng, n: {"map": triangle(rng, n), "at": [fractions(rng, 2)]}),
    ("agree", "degree", (2, 4, 6), lambda rng, n: {"map": polynomial(rng, n)}),
    ("agree at arguments", "degree", (3, 8, 16), lambda rng, n: {"map": polynomial(rng, n), "arguments": fractions(rng, n)}),
    ("convert to monomials", "degree", (3, 20, 100), lambda rng, n: {"map": bezier(rng, n), "to": "monomial"}),
    ("elevate", "degree", (3, 20, 100), lambda rng, n: {"map": bezier(rng, n), "by": 1}),
    ("subdivide", "degree", (3, 20, 100), lambda rng, n: {"map": bezier(rng, n), "at": fraction(rng)}),
    ("reduce", "degree", (3, 10, 30), lambda rng, n: {"map": bezier(rng, n), "to": n - 1}),
    ("graph", "degree", (3, 20, 100), lambda rng, n: {"map": {"kind": "bezier", "control_points": fractions(rng, n + 1)}}),
    ("roots", "degree", (3, 10, 40), wide_roots),
    ("barycentric", "dimension", (2, 4, 8), lambda rng, n: {"vertices": [["0"] * n, *[["1" if i == j else "0" for j in range(n)] for i in range(n)]], "at": [fractions(rng, n)]}),
    ("basis-functions", "control points", (8, 64, 512), lambda rng, n: {"degree": 3, "knots": clamped(rng, n), "at": ["1/24"]}),
    ("insert-knots", "control points", (8, 20, 512), insert_knots),
    ("remove-knot", "control points", (8, 64, 512), remove_knot),
    ("segments", "control points", (8, 64, 512), lambda rng, n: {"map": bspline(rng, n)}),
    ("join", "curves", (2, 16, 128), joined),
    ("continuity", "degree", (3, 10, 30), continuity),
    ("inverse-formula", "degree", (3, 8, 24), lambda rng, n: {"degree": n}),
    ("prove", "degree", (2, 4, 6), affine_step),
    ("explain", "degree", (2, 3, 5), lambda rng, n: {"request": {"op": "blossom", "map": polynomial(rng, n), "arguments": fractions(rng, n)}}),
    ("audit", "control points", (8, 64, 512), audit),
    ("certify", "degree", (2, 4, 8), lambda rng, n: {"requests": [{"op": "blossom", "map": polynomial(rng, n), "arguments": fractions(rng, n)}]}),
    ("exercise", "level", (1, 2, 3), lambda rng, n: {"topic": "blossom", "level": n, "seed": rng.randrange(10**4)}),
    ("export", "control points", (8, 64, 512), lambda rng, n: {"maps": [bspline(rng, n)], "format": "tinyspline"}),
]
PEER_FAMILIES = {"blossom", "control-points", "derivative", "evaluate"}


def lines(family, size, count, seed=1):
    name, _, _, make = family
    rng = random.Random(f"{seed} {name} {size}")
    operation = name.split(" ")[0]
    return [json.dumps({"id": i, "op": operation, **make(rng, size)}) for i in range(count)]
