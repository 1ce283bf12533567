#!/usr/bin/env python3
"""Writes documents of the libraries of `import` from random splines, and compares every number with Python's fractions.

A spline is a net in Python, a dictionary from indices to points. The writers below go through it in the order that each library
documents; none of them shares code with the program. What the program imports must be the net, what it exports must be the same
document, and its audit of the document must find no error.

usage: check_files.py PROGRAM [CASES]
"""

import itertools
import json
import math
import random
import struct
import sys
from fractions import Fraction

from spline_oracle import Report, ask, texts

program = sys.argv[1]
cases = int(sys.argv[2]) if len(sys.argv) > 2 else 1000
report = Report()


def double(random_source):
    """A finite double, often an extreme one."""
    kind = random_source.randrange(8)
    if kind == 0:
        return random_source.choice([0.0, -0.0, 5e-324, -5e-324, 2.2250738585072014e-308, sys.float_info.max, -sys.float_info.max, 0.1])
    if kind == 1:
        while True:
            value = struct.unpack("<d", random_source.randbytes(8))[0]
            if math.isfinite(value):
                return value
    return random_source.choice([random_source.randrange(-9, 10) / 1.0, random_source.uniform(-2, 2), random_source.randrange(-64, 65) / 16])


def positive(random_source):
    return abs(double(random_source)) or 1.0


class Spline:
    """Degrees, knots and a net of random doubles; weights are None for a polynomial spline."""

    def __init__(self, random_source, directions, rational, dimension):
        self.dimension = dimension
        self.degrees = [random_source.randrange(0, 4) for _ in range(directions)]
        self.knots = []
        for degree in self.degrees:
            inner = random_source.randrange(0, 3)
            values = sorted({double(random_source) for _ in range(inner + 2)}, key=Fraction)
            while len(values) < 2:
                values = sorted({double(random_source) for _ in range(inner + 2)}, key=Fraction)
            knots = [values[0]] * (degree + 1)
            for value in values[1:-1]:
                knots += [value] * random_source.randrange(1, degree + 2)
            self.knots.append(knots + [values[-1]] * (degree + 1))
        self.counts = [len(knots) - degree - 1 for knots, degree in zip(self.knots, self.degrees)]
        self.indices = list(itertools.product(*[range(count) for count in self.counts]))
        self.points = {index: [double(random_source) for _ in range(dimension)] for index in self.indices}
        self.weights = {index: positive(random_source) for index in self.indices} if rational else None

    def in_order(self, fastest_first):
        """The indices with the direction fastest_first[0] running fastest."""
        return sorted(self.indices, key=lambda index: [index[direction] for direction in reversed(fastest_first)])

    def nested(self, leaf, prefix=()):
        if len(prefix) == len(self.counts):
            return leaf(prefix)
        return [self.nested(leaf, prefix + (i,)) for i in range(self.counts[len(prefix)])]

    def exact(self):
        """The map of the protocol with the exact values of the doubles."""
        exact_texts = lambda numbers: texts([Fraction(number) for number in numbers])
        points = self.nested(lambda index: exact_texts(self.points[index]))
        result = {"kind": "bspline"}
        if len(self.degrees) == 1:
            result.update(degree=self.degrees[0], knots=exact_texts(self.knots[0]), control_points=points)
        else:
            result.update(degrees=self.degrees, knots=[exact_texts(knots) for knots in self.knots], control_net=points)
        if self.weights:
            result["weights"] = self.nested(lambda index: texts([Fraction(self.weights[index])])[0])
        return result


def geomdl(splines):
    """Curves, surfaces and volumes: v runs fastest, then u, then w; see VolumeManager.find_index."""
    directions = len(splines[0].degrees)
    data = []
    for spline in splines:
        order = spline.in_order([0] if directions == 1 else [1, 0, 2][:directions])
        entry = {"type": "spline", "rational": spline.weights is not None, "dimension": spline.dimension}
        for d in range(directions):
            suffix = "" if directions == 1 else "_" + "uvw"[d]
            entry["degree" + suffix] = spline.degrees[d]
            entry["knotvector" + suffix] = spline.knots[d]
            if directions > 1:
                entry["size" + suffix] = spline.counts[d]
        entry["control_points"] = {"points": [spline.points[index] for index in order]}
        if spline.weights:
            entry["control_points"]["weights"] = [spline.weights[index] for index in order]
        data.append(entry)
    return {"shape": {"type": ["curve", "surface", "volume"][directions - 1], "count": len(data), "data": data}}


def splinepy(splines):
    """Splines in any number of directions: the first direction runs fastest; see MultiIndex."""
    entries = []
    for spline in splines:
        order = spline.in_order(range(len(spline.degrees)))
        entry = {
            "degrees": spline.degrees,
            "knot_vectors": spline.knots,
            "control_points": [spline.points[index] for index in order],
            "SplineType": "NURBS" if spline.weights else "BSpline",
            "dim": spline.dimension,
            "para_dim": len(spline.degrees),
        }
        if spline.weights:
            entry["weights"] = [[spline.weights[index]] for index in order]
        entries.append(entry)
    return {"Name": "SplineGroup", "NumberOfSplines": len(entries), "Base64Encoding": False, "SplineList": entries}


def tinyspline(splines):
    (spline,) = splines
    points = [coordinate for index in spline.indices for coordinate in spline.points[index]]
    return {"degree": spline.degrees[0], "dimension": spline.dimension, "control_points": points, "knots": spline.knots[0]}


def fitpack(splines):
    """A list, but an object where the points might be taken for lists of coordinates."""
    (spline,) = splines
    document = [spline.knots[0], [spline.points[index] for index in spline.indices], spline.degrees[0]]
    ambiguous = spline.dimension in (len(spline.indices), len(spline.knots[0]))
    return dict(zip("tck", document)) if ambiguous else document


FORMATS = {
    # name: (writer, most directions, weights, several)
    "geomdl": (geomdl, 3, True, True),
    "splinepy": (splinepy, 4, True, True),
    "tinyspline": (tinyspline, 1, False, False),
    "fitpack": (fitpack, 1, False, False),
}


def bits(value):
    """A document with each float as its bits: -0 is not 0, and 1 is 1.0."""
    if isinstance(value, dict):
        return {name: bits(member) for name, member in value.items()}
    if isinstance(value, list):
        return [bits(element) for element in value]
    if isinstance(value, bool) or isinstance(value, str):
        return value
    return float(value).hex()


def without_signs_of_zero(value):
    if isinstance(value, dict):
        return {name: without_signs_of_zero(member) for name, member in value.items()}
    if isinstance(value, list):
        return [without_signs_of_zero(element) for element in value]
    return 0.0 if isinstance(value, float) and value == 0 else value


def zeros_only(value):
    if isinstance(value, dict):
        return all(zeros_only(member) for member in value.values())
    if isinstance(value, list):
        return all(zeros_only(element) for element in value)
    return value == "0"


random_source = random.Random(19)
made = []
for case in range(cases):
    name = list(FORMATS)[case % len(FORMATS)]
    writer, most, weighted, several = FORMATS[name]
    directions = random_source.randrange(1, most + 1)
    dimension = random_source.randrange(1, 4)
    count = random_source.choice([1, 1, 2, 3]) if several else 1
    splines = [Spline(random_source, directions, weighted and random_source.randrange(2) == 1, dimension) for _ in range(count)]
    made.append((name, splines, writer(splines)))

requests = []
for name, splines, document in made:
    maps = [spline.exact() for spline in splines]
    requests.append({"op": "import", "format": name, "document": document})
    requests.append({"op": "export", "format": name, "maps": maps})
    requests.append({"op": "audit", "format": name, "maps": maps, "document": document})
responses = ask(program, requests)

for i, (name, splines, document) in enumerate(made):
    imported, exported, audited = responses[3 * i : 3 * i + 3]
    what = f"case {i}, {name}"
    maps = [spline.exact() for spline in splines]
    report.expect(imported.get("result", {}).get("maps") == maps, what, "import", requests[3 * i], imported)
    # An exact 0 has no sign, so that of a document is lost.
    report.expect(
        bits(exported.get("result", {}).get("document")) == bits(without_signs_of_zero(document)), what, "export", document, exported
    )
    result = audited.get("result", {})
    report.expect(zeros_only(result.get("errors", "none")) and result.get("not_nearest") in (0, "0"), what, "audit", audited)


def numbers_in(value):
    """The numbers of an answer that are not 0."""
    if isinstance(value, dict):
        value = list(value.values())
    if isinstance(value, list):
        return [number for element in value for number in numbers_in(element)]
    return [] if value in (None, "0") else [Fraction(value)]


def coordinates_of(name, document, spline, number):
    """The list of a document with the coordinates of one point, and where they begin in it."""
    if name == "tinyspline":
        return document["control_points"], number * spline.dimension
    if name == "geomdl":
        return document["shape"]["data"][0]["control_points"]["points"][number], 0
    if name == "splinepy":
        return document["SplineList"][0]["control_points"][number], 0
    return (document["c"] if isinstance(document, dict) else document[1])[number], 0


# With one coordinate of a document changed, its audit finds this one and no other; with a text for it, import names its place.
changes, changed, broken = [], [], []
for name, splines, document in made[: cases // 4]:
    spline = splines[0]
    document = json.loads(json.dumps(document))
    numbers, begin = coordinates_of(name, document, spline, random_source.randrange(len(spline.indices)))
    place = begin + random_source.randrange(spline.dimension)
    before, now = numbers[place], 0.375 if numbers[place] != 0.375 else 0.75
    numbers[place] = now
    changes.append(Fraction(now) - Fraction(before))
    maps = [spline.exact() for spline in splines]
    changed.append({"op": "audit", "format": name, "maps": maps, "document": json.loads(json.dumps(document))})
    numbers[place] = "wrong"
    broken.append({"op": "import", "format": name, "document": json.loads(json.dumps(document))})
for change, request, response in zip(changes, changed, ask(program, changed)):
    report.expect(numbers_in(response.get("result", {}).get("errors")) == [change], "changed", request, response)


def value_at(value, pointer):
    for step in pointer.split("/")[1:]:
        value = value[int(step)] if isinstance(value, list) else value[step]
    return value


for request, response in zip(broken, ask(program, broken)):
    pointer = response.get("error", {}).get("at", "")
    report.expect(pointer and value_at(request, pointer) == "wrong", "broken", request, response)

print(f"{len(made)} documents, {len(changed)} changed, {report.problems} problems")
sys.exit(1 if report.problems else 0)
