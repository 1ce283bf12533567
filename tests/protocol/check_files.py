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

    def with_ends(self):
        """Of degree at least 1, for a mesh whose corners are control points; with weights that are not all 1."""
        if 0 in self.degrees or (self.weights and set(self.weights.values()) == {1.0}):
            return Spline(random_source, len(self.degrees), self.weights is not None, self.dimension).with_ends()
        return self

    def in_order(self, fastest_first):
        """The indices with the direction fastest_first[0] running fastest."""
        return sorted(self.indices, key=lambda index: [index[direction] for direction in reversed(fastest_first)])

    def nested(self, leaf, prefix=()):
        if len(prefix) == len(self.counts):
            return leaf(prefix)
        return [self.nested(leaf, prefix + (i,)) for i in range(self.counts[len(prefix)])]

    def exact(self):
        """The map of the protocol with the exact values of the doubles; `exact_points` may be others than `points`."""
        exact_points = getattr(self, "exact_points", self.points)
        exact_texts = lambda numbers: texts([Fraction(number) for number in numbers])
        points = self.nested(lambda index: exact_texts(exact_points[index]))
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


def mesh_text(dimension, elements, boundary, edges, vertices, rest):
    """The beginning of an MFEM mesh, and what follows it."""
    geometry = [0, 1, 3, 5]
    lines = ["MFEM NURBS mesh v1.0", "", "# a comment", "", "dimension", dimension, "", "elements", len(elements)]
    lines += [" ".join(map(str, [1, geometry[dimension], *element])) for element in elements]
    lines += ["", "boundary", len(boundary)]
    lines += [" ".join(map(str, [1, geometry[dimension - 1], *side])) for side in boundary]
    lines += ["", "edges", len(edges), *[" ".join(map(str, edge)) for edge in edges], "", "vertices", vertices, ""]
    return "\n".join(map(str, lines)) + "\n" + rest


def knot_line(degree, knots):
    return " ".join([str(degree), str(len(knots) - degree - 1), *map(repr, knots)])


def mfem(splines, homogeneous=False):
    """Patches with vertices of their own, in which the first direction runs fastest; see NURBSPatch::operator()."""
    directions = len(splines[0].degrees)
    corners = 2**directions
    pairs = {1: [[0, 1]], 2: [[0, 0, 1], [0, 3, 2], [1, 0, 3], [1, 1, 2]]}.get(directions)
    pairs = [[0, *pair] for pair in pairs] if directions == 1 else pairs
    if directions == 3:
        pairs = [[0, 0, 1], [0, 3, 2], [0, 4, 5], [0, 7, 6], [1, 0, 3], [1, 1, 2], [1, 4, 7], [1, 5, 6]]
        pairs += [[2, i, i + 4] for i in range(4)]
    edges = [[p * directions + d, p * corners + a, p * corners + b] for p in range(len(splines)) for d, a, b in pairs]
    elements = [[p * corners + i for i in range(corners)] for p in range(len(splines))]
    rest = "patches\n"
    for spline in splines:
        rest += f"\nknotvectors\n{directions}\n"
        rest += "".join(knot_line(degree, knots) + "\n" for degree, knots in zip(spline.degrees, spline.knots))
        rest += f"\ndimension\n{spline.dimension}\n\n" + ("controlpoints\n" if homogeneous else "controlpoints_cartesian\n")
        for index in spline.in_order(range(directions)):
            weight = spline.weights[index] if spline.weights else 1.0
            rest += " ".join(repr(number) for number in [*spline.points[index], weight]) + "\n"
    return mesh_text(directions, elements, [], edges, len(splines) * corners, rest)


FORMATS = {
    # name: (writer, most directions, weights, several)
    "geomdl": (geomdl, 3, True, True),
    "splinepy": (splinepy, 4, True, True),
    "mfem": (mfem, 3, True, True),
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
    if name == "mfem":
        splines = [spline.with_ends() for spline in splines]
    made.append((name, splines, writer(splines)))

requests = []
for name, splines, document in made:
    maps = [spline.exact() for spline in splines]
    requests.append({"op": "import", "format": name, "document": document})
    requests.append({"op": "export", "format": name, "maps": maps})
    requests.append({"op": "audit", "format": name, "maps": maps, "document": document})
responses = ask(program, requests)

continue_with = []
for i, (name, splines, document) in enumerate(made):
    imported, exported, audited = responses[3 * i : 3 * i + 3]
    what = f"case {i}, {name}"
    maps = [spline.exact() for spline in splines]
    report.expect(imported.get("result", {}).get("maps") == maps, what, "import", requests[3 * i], imported)
    if name == "mfem":
        # What is exported has a topology with sides, so that it is compared as it is read again.
        requests[3 * i + 1]["again"] = exported.get("result", {}).get("document")
        continue_with.append((i, maps))
        result = audited.get("result", {})
        report.expect(zeros_only(result.get("errors", "none")) and result.get("not_nearest") in (0, "0"), what, "audit", audited)
        continue
    # An exact 0 has no sign, so that of a document is lost.
    report.expect(
        bits(exported.get("result", {}).get("document")) == bits(without_signs_of_zero(document)), what, "export", document, exported
    )
    result = audited.get("result", {})
    report.expect(zeros_only(result.get("errors", "none")) and result.get("not_nearest") in (0, "0"), what, "audit", audited)

again = [{"op": "import", "format": "mfem", "document": requests[3 * i + 1]["again"]} for i, _ in continue_with]
for (i, maps), response in zip(continue_with, ask(program, again)):
    report.expect(response.get("result", {}).get("maps") == maps, "mesh", i, "exported and imported", response)

# The same numbers as homogeneous coordinates: the points are these, divided by the weights.
homogeneous = [splines for name, splines, _ in made if name == "mfem" and all(spline.weights for spline in splines)]
documents = [{"op": "import", "format": "mfem", "document": mfem(splines, True)} for splines in homogeneous]
for splines, response in zip(homogeneous, ask(program, documents)):
    for spline in splines:
        spline.exact_points = {
            index: [Fraction(number) / Fraction(spline.weights[index]) for number in spline.points[index]] for index in spline.indices
        }
    report.expect(response.get("result", {}).get("maps") == [spline.exact() for spline in splines], "homogeneous", response)


class Glued:
    """A grid of patches with common points, numbered as MFEM numbers them: vertices, edges, faces, insides.

    Patches may be turned and reflected, and the vertices have numbers in any order. A point is named by its place in the grid.
    """

    CORNERS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    SIDES = [(3, 2, 1, 0), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (4, 5, 6, 7)]

    def __init__(self, source, directions, dimension, rational):
        self.directions, self.dimension = directions, dimension
        self.cells = [source.randrange(1, 3) for _ in range(directions)]
        # Along each axis a degree and a number of points for each cell; knots are uniform, hence symmetric.
        self.shapes = []
        for cells in self.cells:
            degrees = [source.randrange(1, 4) for _ in range(cells)]
            self.shapes.append([(degree, degree + 1 + source.randrange(0, 3)) for degree in degrees])
        self.starts = []
        for shapes in self.shapes:
            starts = [0]
            for _, points in shapes:
                starts.append(starts[-1] + points - 1)
            self.starts.append(starts)
        grid = list(itertools.product(*[range(starts[-1] + 1) for starts in self.starts]))
        self.points = {place: [source.uniform(-1, 1) for _ in range(dimension)] for place in grid}
        self.weights = {place: source.uniform(0.5, 2) if rational else 1.0 for place in grid}
        corners = list(itertools.product(*self.starts))
        numbers = list(range(len(corners)))
        source.shuffle(numbers)
        self.vertices = dict(zip(corners, numbers))
        self.patches = []
        for cell in itertools.product(*[range(cells) for cells in self.cells]):
            axes = list(range(directions))
            source.shuffle(axes)
            self.patches.append((cell, axes, [source.randrange(2) == 1 for _ in axes]))

    def local_counts(self, patch):
        cell, axes, _ = patch
        return [self.shapes[axis][cell[axis]][1] for axis in axes]

    def place(self, patch, index):
        """The place in the grid of a point of a patch."""
        cell, axes, reversed_axes = patch
        place = [0] * self.directions
        for d, axis in enumerate(axes):
            along = self.local_counts(patch)[d] - 1 - index[d] if reversed_axes[d] else index[d]
            place[axis] = self.starts[axis][cell[axis]] + along
        return tuple(place)

    def corner(self, patch, i):
        return self.place(patch, [self.CORNERS[i][d] * (count - 1) for d, count in enumerate(self.local_counts(patch))])

    def between(self, begin, *ends):
        """The points inside an edge from `begin`, or a face or patch, the direction to the first end running fastest."""
        steps = []
        for end in ends:
            axis = next(a for a in range(self.directions) if begin[a] != end[a])
            sign = 1 if end[axis] > begin[axis] else -1
            steps.append((axis, [sign * i for i in range(1, abs(end[axis] - begin[axis]))]))
        found = []
        for offsets in itertools.product(*[offsets for _, offsets in reversed(steps)]):
            place = list(begin)
            for (axis, _), offset in zip(reversed(steps), offsets):
                place[axis] += offset
            found.append(tuple(place))
        return found

    def document(self, source):
        order = sorted(self.vertices, key=self.vertices.get)
        corner_count = 2**self.directions
        elements = [[self.corner(patch, i) for i in range(corner_count)] for patch in self.patches]
        knot_numbers, edges = {}, []
        for element in elements:
            for i, j in itertools.combinations(range(corner_count), 2):
                differing = [d for d in range(3) if self.CORNERS[i][d] != self.CORNERS[j][d]]
                pair = tuple(sorted((element[i], element[j]), key=self.vertices.get))
                if len(differing) == 1 and pair not in edges:
                    edges.append(pair)
        source.shuffle(edges)
        edge_lines = []
        for begin, end in edges:
            axis = next(a for a in range(self.directions) if begin[a] != end[a])
            cell = self.starts[axis].index(min(begin[axis], end[axis]))
            number = knot_numbers.setdefault((axis, cell), len(knot_numbers))
            listed = [self.vertices[begin], self.vertices[end]]
            edge_lines.append([number, *(reversed(listed) if source.randrange(2) else listed)])
            order += self.between(begin, end)
        if self.directions == 3:
            known = set()
            for element in elements:
                for side in self.SIDES:
                    a, b, c, d = (element[i] for i in side)
                    if frozenset((a, b, c, d)) not in known:
                        known.add(frozenset((a, b, c, d)))
                        order += self.between(a, b, d)
        for element in elements:
            order += self.between(element[0], *[element[i] for i in (1, 3, 4)[: self.directions]])
        assert len(order) == len(set(order)) == len(self.points)
        rest = f"knotvectors\n{len(knot_numbers)}\n"
        rest += "".join(knot_line(self.shapes[axis][cell][0], self.knots(axis, cell)) + "\n" for axis, cell in knot_numbers)
        rest += "\nweights\n" + "".join(f"{self.weights[place]!r}\n" for place in order)
        ordering = source.randrange(2)
        rest += f"\nFiniteElementSpace\nFiniteElementCollection: NURBS\nVDim: {self.dimension}\nOrdering: {ordering}\n\n"
        numbers = [self.points[place] for place in order]
        rest += "\n".join(" ".join(map(repr, row)) for row in (numbers if ordering else zip(*numbers))) + "\n"
        ids = [[self.vertices[corner] for corner in element] for element in elements]
        return mesh_text(self.directions, ids, [], edge_lines, len(self.vertices), rest)

    def knots(self, axis, cell):
        degree, points = self.shapes[axis][cell]
        inner = points - degree - 1
        return [0.0] * (degree + 1) + [float(i + 1) for i in range(inner)] + [float(inner + 1)] * (degree + 1)

    def maps(self):
        maps = []
        for patch in self.patches:
            cell, axes, _ = patch
            spline = Spline.__new__(Spline)
            spline.dimension = self.dimension
            spline.degrees = [self.shapes[axis][cell[axis]][0] for axis in axes]
            spline.knots = [self.knots(axis, cell[axis]) for axis in axes]
            spline.counts = self.local_counts(patch)
            spline.indices = list(itertools.product(*[range(count) for count in spline.counts]))
            spline.points = {index: self.points[self.place(patch, index)] for index in spline.indices}
            weights = {index: self.weights[self.place(patch, index)] for index in spline.indices}
            spline.weights = weights if any(weight != 1.0 for weight in weights.values()) else None
            maps.append(spline.exact())
        return maps


meshes = [Glued(random_source, 2 + case % 2, random_source.randrange(1, 4), case % 3 == 0) for case in range(cases // 20)]
glued = [{"op": "import", "format": "mfem", "document": mesh.document(random_source)} for mesh in meshes]
for mesh, request, response in zip(meshes, glued, ask(program, glued)):
    report.expect(response.get("result", {}).get("maps") == mesh.maps(), "glued", request["document"], response)


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
    if name == "mfem":
        continue
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

print(f"{len(made)} documents, {len(meshes)} glued meshes, {len(changed)} changed, {report.problems} problems")
sys.exit(1 if report.problems else 0)
