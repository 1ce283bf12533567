#!/usr/bin/env python3
"""Holds the operations on patches and on tensor products of splines against the definitions of their basis functions.

usage: check_patches.py PROGRAM [CASES]
"""

import random
import sys
from fractions import Fraction
from itertools import combinations, product
from math import comb, prod
from re import sub

from patch_oracle import (
    barycentric,
    breaks,
    common_segments,
    composed2,
    directions_of,
    domain_of,
    grid_of,
    homogeneous,
    homogeneous_value,
    integral_over,
    is_rational,
    lattice,
    order_across,
    power2,
    product2,
    rows,
    same_on_grid,
    sum2,
    surface_pieces,
    value2,
)
from spline_oracle import Report, ask, composed, order_of_contact, pieces_of, text_of, texts

program = sys.argv[1]
CASES = int(sys.argv[2]) if len(sys.argv) > 2 else 1000
choose = random.Random(23)
report = Report()


def number():
    return choose.choice([Fraction(0), Fraction(1), Fraction(-2), Fraction(choose.randint(-9, 9), choose.randint(1, 4))])


def weight():
    return Fraction(choose.randint(1, 4), choose.randint(1, 3))


def nested(values, counts):
    if not counts:
        return next(values)
    return [nested(values, counts[1:]) for _ in range(counts[0])]


def with_net(a_map, counts, scalar, rational, dimension=2):
    def point():
        return text_of(number()) if scalar else texts([number() for _ in range(dimension)])

    size = 1
    for count in counts:
        size *= count
    a_map["control_net"] = nested(iter([point() for _ in range(size)]), counts)
    if rational:
        a_map["weights"] = nested(iter(texts([weight() for _ in range(size)])), counts)
    return a_map


def knot_list(n):
    """Knots of any multiplicities inside, clamped or any others at the ends, and the number of control points."""
    outside = n if n == 0 or choose.random() < 0.7 else n - 1
    t = Fraction(choose.randint(-2, 2))
    inner = []
    for _ in range(choose.choice([0, 0, 1, 1, 2])):
        t += Fraction(choose.randint(1, 3), choose.randint(1, 2))
        inner += [t] * choose.randint(1, n + 1)
    begin = (inner[0] if inner else t) - Fraction(choose.randint(1, 3), 2)
    end = t + Fraction(choose.randint(1, 3), 2)

    def ends(t, direction):
        knots = [t] * choose.choice([1, outside + 1, outside + 1])
        while len(knots) < outside + 1:
            knots.append(knots[-1] + direction * choose.choice([0, 1, 1]) * Fraction(1, 2))
        return knots

    knots = ends(begin, -1)[::-1] + inner + ends(end, 1)
    if any(knots.count(t) > n + 1 for t in knots):
        return knot_list(n)
    return knots, len(knots) - n - 1 if outside == n else len(knots) - n + 1


def tensor_spline(rational=None, most=2):
    directions = choose.choice([1, 2, 2, 2, 2, 3])
    degrees = [choose.randint(0, most if directions < 3 else 1) for _ in range(directions)]
    lists = [knot_list(n) for n in degrees]
    a_map = {"kind": "bspline", "degrees": degrees, "knots": [texts(knots) for knots, _ in lists]}
    rational = choose.random() < 0.3 if rational is None else rational
    return with_net(a_map, [count for _, count in lists], choose.random() < 0.5, rational)


def tensor_patch(rational=None):
    degrees = [choose.randint(0, 3) for _ in range(choose.choice([1, 2, 2, 2]))]
    a_map = {"kind": "tensor", "degrees": degrees}
    if choose.random() < 0.7:
        a_map["intervals"] = []
        for _ in degrees:
            a = number()
            a_map["intervals"].append(texts([a, a + choose.choice([-1, 1, 1]) * weight()]))
    rational = choose.random() < 0.3 if rational is None else rational
    return with_net(a_map, [n + 1 for n in degrees], choose.random() < 0.5, rational)


def direction_in(a_map):
    return choose.randrange(directions_of(a_map))


def is_polar(a_map, d):
    counts, _ = grid_of(a_map)
    return len(a_map["knots"][d]) != counts[d] + a_map["degrees"][d] + 1


def is_clamped(a_map, d):
    knots = [Fraction(t) for t in a_map["knots"][d]]
    count = a_map["degrees"][d] + (0 if is_polar(a_map, d) else 1)
    a, b = domain_of(a_map, d)
    return knots.count(a) == knots.count(b) == count and knots[0] == a and knots[-1] == b


def same_in_others(one, other, d):
    """What belongs to the other directions stays."""
    field = "knots" if one["kind"] == "bspline" else "intervals"
    default = [["0", "1"]] * directions_of(one)
    return all(k == d or one.get(field, default)[k] == other.get(field, default)[k] for k in range(directions_of(one)))


def clamp():
    a_map = tensor_spline()
    request = {"op": "clamp", "map": a_map}
    which = range(directions_of(a_map))
    if choose.random() < 0.5:
        request["direction"] = direction_in(a_map)
        which = [request["direction"]]

    def check(result):
        made = result["map"]
        for d in range(directions_of(a_map)):
            if d in which:
                report.expect(is_clamped(made, d) and is_polar(made, d) == is_polar(a_map, d), "clamp", request, made)
            else:
                report.expect(made["knots"][d] == a_map["knots"][d], "clamp: other direction", request, made)
        report.expect(same_on_grid(a_map, made), "clamp: another map", request, made)

    return request, check


def part(a_map, d):
    a, b = domain_of(a_map, d)
    ends = sorted(a + (b - a) * Fraction(choose.randint(0, 6), 6) for _ in range(2))
    if choose.random() < 0.3:
        ends[choose.randrange(2)] = choose.choice(breaks(a_map, d))
        ends.sort()
    return ends if ends[0] < ends[1] else [a, b]


def trim():
    a_map = choose.choice([tensor_spline, tensor_spline, tensor_patch])()
    d = direction_in(a_map)
    ends = part(a_map, d)
    request = {"op": "trim", "map": a_map, "direction": d, "interval": texts(ends)}

    def check(result):
        made = result["map"]
        report.expect(list(domain_of(made, d)) == ends and same_in_others(a_map, made, d), "trim: domain", request, made)
        report.expect(made["kind"] == "tensor" or is_clamped(made, d), "trim: clamped", request, made)
        report.expect(same_on_grid(made, a_map, lambda at: at), "trim: another map", request, made)

    return request, check


def moved(request, a_map, d, from_, to):
    def change(at):
        slope = (to[1] - to[0]) / (from_[1] - from_[0])
        return [to[0] + slope * (t - from_[0]) if k in d else t for k, t in enumerate(at)]

    def check(result):
        report.expect(same_on_grid(a_map, result["map"], change), request["op"], "another map", request, result)

    return check


def interval_of(a_map, d):
    """As it is written."""
    if a_map["kind"] == "tensor":
        return [Fraction(t) for t in a_map.get("intervals", [[0, 1]] * directions_of(a_map))[d]]
    return list(domain_of(a_map, d))


def reverse():
    a_map = choose.choice([tensor_spline, tensor_patch])()
    d = direction_in(a_map)
    request = {"op": "reverse", "map": a_map, "direction": d}
    a, b = interval_of(a_map, d)
    inner = moved(request, a_map, [d], [a, b], [b, a])

    def check(result):
        report.expect(interval_of(result["map"], d) == [a, b] and same_in_others(a_map, result["map"], d), "reverse", request, result)
        inner(result)

    return request, check


def reparametrise():
    a_map = choose.choice([tensor_spline, tensor_patch])()
    d = direction_in(a_map)
    request = {"op": "reparametrise", "map": a_map, "direction": d}
    to = [Fraction(0), Fraction(1)]
    if choose.random() < 0.7:
        a = number()
        to = [a, a + choose.choice([-1, 1]) * weight()]
        request["interval"] = texts(to)
    from_ = interval_of(a_map, d)
    if choose.random() < 0.4:
        a = number()
        from_ = [a, a + weight()]
        request["from"] = texts(from_)
    return request, moved(request, a_map, [d], from_, to)


def knots_inserted():
    a_map = tensor_spline()
    d = direction_in(a_map)
    n = a_map["degrees"][d]
    a, b = domain_of(a_map, d)
    old = [Fraction(t) for t in a_map["knots"][d]]
    knots = [choose.choice([*breaks(a_map, d), (a + b) / 2, a + (b - a) * Fraction(1, 3)]) for _ in range(choose.choice([1, 2, 9]))]
    request = {"op": "insert-knots", "map": a_map}
    if choose.random() < 0.5:
        m = choose.randint(0, n + 1)
        request["multiplicity"] = m
        wanted = [t for t in set(knots) for _ in range(max(m - old.count(t), 0))]
    else:
        knots = [t for i, t in enumerate(knots) if old.count(t) + knots[:i].count(t) <= n]
        wanted = knots
    if choose.random() < 0.6:
        request["method"] = choose.choice(["boehm", "oslo"])
    lists = [[] for _ in a_map["degrees"]]
    lists[d] = texts(knots)
    request["knots"] = lists
    if choose.random() < 0.5:
        request["direction"], request["knots"] = d, texts(knots)

    def check(result):
        made = result["map"]
        report.expect([Fraction(t) for t in made["knots"][d]] == sorted(old + wanted), "insert-knots", request, made)
        report.expect(same_in_others(a_map, made, d) and same_on_grid(a_map, made), "insert-knots: another map", request, made)

    return request, check


def least_order(a_map, d, t):
    """Of the rows of homogeneous points at t; None where all go on."""
    orders = []
    for row in rows(a_map, d):
        pieces = pieces_of(row)
        left = next(p for a, b, p in pieces if b == t)
        right = next(p for a, b, p in pieces if a == t)
        orders.append(order_of_contact(left, right, t, False))
    finite = [order for order in orders if order is not None]
    return min(finite) if finite else None


def inner_knots(a_map, d):
    return breaks(a_map, d)[1:-1]


def remove_knot():
    a_map = tensor_spline()
    d = direction_in(a_map)
    if not inner_knots(a_map, d):
        return remove_knot()
    if choose.random() < 0.7:  # a knot that can be removed, at least once
        t = choose.choice([*inner_knots(a_map, d), sum(breaks(a_map, d)[:2]) / 2])
        old = [Fraction(u) for u in a_map["knots"][d]]
        times = choose.randint(0, a_map["degrees"][d] + 1 - old.count(t))
        lists = [[] for _ in a_map["degrees"]]
        lists[d] = [text_of(t)] * times
        a_map = ask(program, [{"op": "insert-knots", "map": a_map, "knots": lists}])[0]["result"]["map"]
        if t not in inner_knots(a_map, d):
            return remove_knot()
    else:
        t = choose.choice(inner_knots(a_map, d))
    n, m = a_map["degrees"][d], [Fraction(u) for u in a_map["knots"][d]].count(t)
    times = choose.randint(1, m)
    request = {"op": "remove-knot", "map": a_map, "direction": d, "knot": text_of(t), "times": times}
    order = least_order(a_map, d, t)
    possible = times if order is None else min(times, order - (n - m))

    def check(result):
        made = result["map"]
        report.expect(result["removed"] == possible, "remove-knot: times", possible, request, result)
        report.expect(same_in_others(a_map, made, d) and same_on_grid(a_map, made), "remove-knot: another map", request, made)
        if possible < times:
            found = result["obstruction"]
            left, right = ([Fraction(x) for x in (p if isinstance(p, list) else [p])] for p in (found["from_left"], found["from_right"]))
            report.expect(left != right and len(found["row"]) == directions_of(a_map) - 1, "remove-knot: obstruction", request, result)
            row = found["row"]
            counts, _ = grid_of(made)
            place = 0
            for k, i in zip([k for k in range(len(counts)) if k != d], row):
                report.expect(i < counts[k], "remove-knot: row", request, result)
                place = place * counts[k] + i
            pieces = pieces_of(rows(made, d)[place])
            before = next(p for a, b, p in pieces if b == t)
            behind = next(p for a, b, p in pieces if a == t)
            report.expect(blossom_at(before, n, found["knots"]) == left, "remove-knot: left", request, result)
            report.expect(blossom_at(behind, n, found["knots"]) == right, "remove-knot: right", request, result)

    return request, check


def blossom_at(polynomials, n, arguments):
    u = [Fraction(x) for x in arguments]
    return [
        sum((a * sum(prod(c, start=Fraction(1)) for c in combinations(u, k)) / comb(n, k) for k, a in enumerate(p)), Fraction(0))
        for p in polynomials
    ]


def split():
    a_map = tensor_spline()
    at = [None] * directions_of(a_map)
    for d in range(directions_of(a_map)):
        if choose.random() < 0.6:
            cuts = breaks(a_map, d)
            at[d] = choose.choice([(cuts[0] + cuts[-1]) / 2, *cuts[1:-1]])
    request = {"op": "subdivide", "map": a_map, "at": [None if t is None else text_of(t) for t in at], "clamped": True}

    def check(result):
        boxes = [[(a, t), (t, b)] if t is not None else [(a, b)] for t, (a, b) in zip(at, (domain_of(a_map, d) for d in range(len(at))))]
        report.expect(len(result["maps"]) == len(list(product(*boxes))), "subdivide: count", request, result)
        for half, box in zip(result["maps"], product(*boxes)):
            for d, ends in enumerate(box):
                report.expect(domain_of(half, d) == ends and (at[d] is None or is_clamped(half, d)), "subdivide", request, half)
            report.expect(same_on_grid(half, a_map, lambda at: at), "subdivide: another map", request, half)

    return request, check


def closed_spline():
    """Over periodic knots in one direction, then as it is or clamped."""
    a_map = tensor_spline(most=3)
    d = direction_in(a_map)
    n = choose.randint(1, 3)
    cycle, t = [], Fraction(choose.randint(-1, 1))
    for _ in range(choose.randint(1, 3)):
        cycle += [t] * choose.choice([1, 1, choose.randint(1, n)])
        t += Fraction(choose.randint(1, 3), choose.randint(1, 2))
    period, m = t - cycle[0], cycle.count(cycle[0])

    def knot(i):
        return cycle[i % len(cycle)] + (i // len(cycle)) * period

    end = next(i for i in range(m, 99) if knot(i) == cycle[0] + period)
    knots = [knot(i) for i in range(m - 1 - n, end + n + 1)]
    a_map["degrees"][d], a_map["knots"][d] = n, texts(knots)
    counts = [len(a_map["knots"][k]) - a_map["degrees"][k] + (1 if is_polar_list(a_map, k) else -1) for k in range(directions_of(a_map))]
    counts[d] = len(knots) - n - 1
    scalar = not isinstance(deep(a_map["control_net"], directions_of(a_map)), list)
    one = {}
    with_net(one, [c if k != d else len(cycle) for k, c in enumerate(counts)], scalar, "weights" in a_map)
    for field in ("control_net", "weights"):
        if field in one:
            a_map[field] = repeated(one[field], d, counts[d])
    if choose.random() < 0.5:
        a_map = ask(program, [{"op": "clamp", "map": a_map}])[0]["result"]["map"]
    return a_map, d


def deep(net, depth):
    return net if depth == 0 else deep(net[0], depth - 1)


def is_polar_list(a_map, k):
    counts, net = [], a_map["control_net"]
    for _ in a_map["degrees"]:
        counts.append(len(net))
        net = net[0]
    return len(a_map["knots"][k]) != counts[k] + a_map["degrees"][k] + 1 if k < len(counts) else False


def repeated(net, depth, count):
    if depth == 0:
        return [net[i % len(net)] for i in range(count)]
    return [repeated(entry, depth - 1, count) for entry in net]


def seam_order(a_map, d):
    """Of the projected map at the seam, from differences of its values along the direction: the order in each box."""
    a, b = domain_of(a_map, d)
    orders = []
    for row in rows(a_map, d):
        pieces = pieces_of(row)
        first = [shifted(p, a - b) for p in pieces[0][2]]
        orders.append(order_of_contact(pieces[-1][2], first, b, False))
    finite = [order for order in orders if order is not None]
    return min(finite) if finite else None


def shifted(p, c):
    return composed(p, [c, Fraction(1)])


def order_text(order):
    return "infinite" if order is None else order


def periodic():
    a_map, d = closed_spline() if choose.random() < 0.85 else (lambda m: (m, direction_in(m)))(tensor_spline(rational=False))
    request = {"op": "periodic", "map": a_map, "direction": d}
    order = seam_order(a_map, d)
    if order == -1:
        return request, "not_continuous"

    def check(result):
        made = result["map"]
        n, knots = made["degrees"][d], [Fraction(t) for t in made["knots"][d]]
        a, b = domain_of(made, d)
        m = knots.count(a)
        count = sum(a < t < b for t in knots) + m
        if not is_rational(a_map):
            report.expect(result["order"] == order_text(order), "periodic: order", order, request, result)
            report.expect(m == (1 if order is None else n - order), "periodic: seam", order, request, result)
        report.expect(all(t + b - a == u for t, u in zip(knots, knots[count:])), "periodic: knots", request, result)
        for row in rows(made, d):
            points = row["control_points"]
            if not is_rational(a_map):
                report.expect(points[count:] == points[: n + 1 - m] and len(points) == count + n + 1 - m, "periodic: points", request, result)
        report.expect(same_in_others(a_map, made, d) and same_on_grid(a_map, made), "periodic: another map", request, made)

    return request, check


def at_seam():
    a_map, d = closed_spline() if choose.random() < 0.6 else (lambda m: (m, direction_in(m)))(tensor_spline(rational=False))
    if is_rational(a_map):
        return at_seam()
    request = {"op": "continuity", "map": a_map, "at": ["seam" if k == d else None for k in range(directions_of(a_map))]}
    order = seam_order(a_map, d)

    def check(result):
        report.expect(result["order"] == order_text(order), "seam", order, request, result)

    return request, check


def refined(a_map):
    """The same map with higher degrees and more knots."""
    a_map = ask(program, [{"op": "elevate", "map": a_map, "by": [choose.randint(0, 1) for _ in a_map["degrees"]]}])[0]["result"]["map"]
    if a_map["kind"] == "bspline":
        lists = [[text_of(sum(breaks(a_map, d)[:2]) / 2)] * choose.randint(0, a_map["degrees"][d]) for d in range(directions_of(a_map))]
        a_map = ask(program, [{"op": "insert-knots", "map": a_map, "knots": lists}])[0]["result"]["map"]
    return a_map


def scaled_weights(a_map, factor):
    def by(net):
        return [by(entry) for entry in net] if isinstance(net, list) else text_of(Fraction(net) * factor)

    return {**a_map, "weights": by(a_map["weights"])} if "weights" in a_map else a_map


def join():
    """The parts of a map, changed so that they stay the same maps."""
    a_map = choose.choice([tensor_spline, tensor_spline, tensor_patch])()
    if a_map["kind"] == "tensor":
        a_map["intervals"] = [texts(sorted(interval_of(a_map, d))) for d in range(directions_of(a_map))]
    d = direction_in(a_map)
    cuts = breaks(a_map, d)
    at = choose.choice([(cuts[0] + cuts[-1]) / 2, *cuts[1:-1]])
    parts = ask(program, [{"op": "subdivide", "map": a_map, "at": [text_of(at) if k == d else None for k in range(directions_of(a_map))]}])
    maps = [refined(half) if choose.random() < 0.6 else half for half in parts[0]["result"]["maps"]]
    if is_rational(a_map):
        maps[1] = scaled_weights(maps[1], weight())
    request = {"op": "join", "maps": maps, "direction": d}
    if choose.random() < 0.3:
        request["chain"] = True

    def check(result):
        made = result["map"]
        report.expect(domain_of(made, d) == domain_of(a_map, d), "join: domain", request, made)
        report.expect(same_on_grid(a_map, made), "join: another map", request, made)
        if not is_rational(a_map):
            n, knots = made["degrees"][d], [Fraction(t) for t in made["knots"][d]]
            for t in inner_knots(made, d):
                order = least_order(made, d, t)
                report.expect(order is not None and knots.count(t) == n - order, "join: multiplicity", t, order, request, made)

    return request, check


def plane_patch(scalar=True, rational=False, most=3):
    """A triangle or a rectangle."""
    dimension = 1 if scalar else 2
    if choose.random() < 0.5:
        a_map = tensor_patch(rational)
        while directions_of(a_map) != 2:
            a_map = tensor_patch(rational)
        return a_map
    n = choose.randint(0, most)
    while True:
        vertices = [[number(), number()] for _ in range(3)]
        (a, b), (c, d), (e, f) = vertices
        if (c - a) * (f - b) != (d - b) * (e - a):
            break
    indices = lattice(n, 2)
    choose.shuffle(indices)
    net = [[list(i), text_of(number()) if scalar else texts([number() for _ in range(dimension)])] for i in indices]
    a_map = {"kind": "simplex", "degree": n, "vertices": [texts(v) for v in vertices], "control_net": net}
    if rational:
        a_map["weights"] = [[list(i), text_of(weight())] for i in indices]
    return a_map


def plane_spline(rational=False):
    a_map = tensor_spline(rational)
    while directions_of(a_map) != 2:
        a_map = tensor_spline(rational)
    return a_map


def degrees_in(a_map):
    return a_map["degrees"] if "degrees" in a_map else a_map["degree"]


def reduce():
    a_map = choose.choice([plane_patch, plane_patch, plane_spline])()
    n = degrees_in(a_map)
    if isinstance(n, list):
        to = [choose.randint(max(0, k - 2), k) for k in n]
        monomials = [(i, j) for i in range(to[0] + 1) for j in range(to[1] + 1)]
    else:
        to = choose.randint(max(0, n - 2), n)
        monomials = [(i, j) for i in range(to + 1) for j in range(to + 1 - i)]
    request = {"op": "reduce", "map": a_map, "to": to}
    method = choose.choice(["least-squares"] * 3 + ["inverse-formula"]) if isinstance(n, list) else "least-squares"
    if method != "least-squares" or choose.random() < 0.3:
        request["method"] = method

    def check(result):
        made = result["map"]
        report.expect(degrees_in(made) == to, "reduce: degrees", request, made)
        total = Fraction(0)
        reduced = surface_pieces(made)
        for corners, p in surface_pieces(a_map):
            middle = [sum(x[k] for x in corners) / len(corners) for k in range(2)]
            q = next(q for outer, q in reduced if len(outer) == 3 or (outer[0][0] <= middle[0] <= outer[2][0] and outer[0][1] <= middle[1] <= outer[2][1]))
            rest = [sum2((1, x), (-1, y)) for x, y in zip(p, q)]
            total += sum(integral_over(corners, product2(x, x)) for x in rest)
            if method == "least-squares":
                for index in monomials:
                    found = [integral_over(corners, product2(x, {index: Fraction(1)})) for x in rest]
                    report.expect(not any(found), "reduce: not orthogonal", index, request, made)
        report.expect(Fraction(result["error"]["l2_squared"]) == total and result["exact"] == (total == 0), "reduce: error", total, request, result)

    return request, check


def graph():
    a_map = choose.choice([plane_patch, plane_spline])(rational=choose.random() < 0.4)
    request = {"op": "graph", "map": a_map}

    def check(result):
        made = result["map"]
        x, y = {(1, 0): Fraction(1)}, {(0, 1): Fraction(1)}
        for (corners, p), (others, q) in zip(surface_pieces(a_map), surface_pieces(made)):
            w = p[-1] if is_rational(a_map) else {(0, 0): Fraction(1)}
            report.expect(corners == others and q == [product2(x, w), product2(y, w), *p], "graph", request, made)

    return request, check


def expansion():
    a_map = plane_patch(rational=choose.random() < 0.3)
    center = [number(), number()]
    request = {"op": "convert", "map": a_map, "to": "taylor", "center": texts(center)}

    def check(result):
        made = result["map"]
        report.expect([Fraction(c) for c in made["center"]] == center, "taylor: centre", request, made)
        _, p = surface_pieces(a_map)[0]
        for at in [(Fraction(i), Fraction(j, 2)) for i in range(-4, 5) for j in range(-4, 5)][::4]:
            report.expect(homogeneous_value(made, at) == [value2(q, *at) for q in p], "taylor: value", at, request, made)

    return request, check


def pyramid():
    a_map = choose.choice([plane_patch, plane_spline, tensor_spline])(rational=choose.random() < 0.3)
    if "degrees" in a_map:
        at = [choose.choice([*breaks(a_map, d), sum(breaks(a_map, d)[:2]) / 2]) for d in range(directions_of(a_map))]
        levels = 1 + sum(a_map["degrees"])
        sizes, rest = [], [n + 1 for n in a_map["degrees"]]
        sizes.append(prod(rest))
        for d in reversed(range(len(rest))):
            while rest[d] > 1:
                rest[d] -= 1
                sizes.append(prod(rest))
    else:
        at = [number(), number()]
        levels = 1 + a_map["degree"]
        sizes = [(n + 1) * (n + 2) // 2 for n in range(levels - 1, -1, -1)]
    request = {"op": "evaluate", "map": a_map, "at": [texts(at)], "pyramid": True}

    def check(result):
        found = result["pyramids"][0]
        report.expect([len(level) for level in found] == sizes, "pyramid: sizes", sizes, request, result)
        report.expect(found[-1][0] == result["values"][0], "pyramid: apex", request, result)
        weights = result["pyramid_weights"][0] if is_rational(a_map) else None
        points = [homogeneous(level, weights[r] if weights else None) for r, level in enumerate(found)]
        if a_map["kind"] == "simplex":
            x = barycentric(a_map, at)
            by_index = {tuple(i): p for (i, _), p in zip(a_map["control_net"], homogeneous([p for _, p in a_map["control_net"]], [w for _, w in a_map["weights"]] if weights else None))}
            level = [by_index[i] for i in lattice(levels - 1, 2)]
            for r, expected in enumerate(points):
                report.expect(level == expected, "pyramid: level", r, request, result)
                n = levels - 2 - r
                old = dict(zip(lattice(n + 1, 2), level))
                level = [
                    [sum(x[k] * old[tuple(i[m] + (m == k) for m in range(3))][j] for k in range(3)) for j in range(len(expected[0]))]
                    for i in (lattice(n, 2) if n >= 0 else [])
                ]

    return request, check


def at_face():
    """A triangle divided at a point of an edge or inside, and a simplex of any dimension."""
    s = choose.choice([1, 2, 2, 2, 3])
    n = choose.randint(0, 3 if s < 3 else 2)
    indices = lattice(n, s)
    a_map = {"kind": "simplex", "degree": n, "control_net": [[list(i), text_of(number())] for i in indices]}
    x = [choose.choice([Fraction(0), Fraction(1), Fraction(choose.randint(-3, 5), 2)]) for _ in range(s)]
    x.append(1 - sum(x))
    choose.shuffle(x)
    request = {"op": "subdivide", "map": a_map, "at": texts(x)}
    replaced = [k for k in range(s + 1) if x[k]]
    if len(replaced) == 1:
        return request, "degenerate_simplex"

    def check(result):
        report.expect(len(result["maps"]) == len(replaced), "subdivide: pieces", request, result)
        for k, piece in zip(replaced, result["maps"]):
            for at in lattice(n + 1, s):
                own = [Fraction(i, n + 1) for i in at]
                whole = [own[k] * x[m] + (own[m] if m != k else 0) for m in range(s + 1)]
                report.expect(homogeneous_value(piece, own) == homogeneous_value(a_map, whole), "subdivide: value", at, k, request, piece)

    return request, check


def polynomial_in_plane(n, dimension=1):
    return [{(i, j): number() for i in range(n + 1) for j in range(n + 1 - i)} for _ in range(dimension)]


def as_map(p, domain, spline=False):
    """The polynomials as a control net over a triangle or a box."""
    terms = {index for q in p for index in q} | {(0, 0)}
    source = {"kind": "polynomial", "variables": ["x", "y"], "terms": [[list(i), texts([q.get(i, Fraction(0)) for q in p])] for i in sorted(terms)]}
    n = max(i + j for i, j in terms)
    if len(domain) == 3:
        return ask(program, [{"op": "convert", "map": {**source, "degree": n}, "to": "simplex", "vertices": [texts(v) for v in domain]}])[0]["result"]["map"]
    intervals = [texts([domain[0][0], domain[2][0]]), texts([domain[0][1], domain[2][1]])]
    a_map = ask(program, [{"op": "convert", "map": {**source, "degrees": [n, n]}, "to": "tensor", "intervals": intervals}])[0]["result"]["map"]
    if not spline:
        return a_map
    a_map = ask(program, [{"op": "convert", "map": a_map, "to": "bspline"}])[0]["result"]["map"]
    knots = [[text_of((breaks(a_map, d)[0] + breaks(a_map, d)[-1]) / 2)] * choose.randint(0, min(1, n)) for d in range(2)]
    return ask(program, [{"op": "insert-knots", "map": a_map, "knots": knots}])[0]["result"]["map"]


def box(a, b, c, d):
    return [(a, c), (b, c), (b, d), (a, d)]


def neighbours():
    """Two domains on both sides of the line x = 0 with a part of an edge in common."""
    low, high = choose.choice([(Fraction(0), Fraction(1)), (Fraction(1, 3), Fraction(2)), (Fraction(-1), Fraction(1, 2))])
    left = choose.choice([box(Fraction(-1), Fraction(0), Fraction(0), Fraction(1)), [(Fraction(0), Fraction(0)), (Fraction(0), Fraction(1)), (Fraction(-2), number())]])
    right = choose.choice([box(Fraction(0), Fraction(2), low, high), [(Fraction(0), high), (Fraction(1), number()), (Fraction(0), low)]])
    return left, right


def across_edge():
    """Maps that differ by a multiple of a power of the distance from the edge."""
    left, right = neighbours()
    dimension = choose.randint(1, 2)
    rational = choose.random() < 0.25
    f = polynomial_in_plane(choose.randint(0, 2), dimension)
    order = choose.randint(-1, 2)
    g = [sum2((1, p), (1, product2(power2({(1, 0): Fraction(1)}, order + 1), q))) for p, q in zip(f, polynomial_in_plane(choose.randint(0, 1), dimension))]
    maps = [as_map(f, left, choose.random() < 0.4), as_map(g, right, choose.random() < 0.4)]
    if rational:
        for a_map in maps:
            net = a_map["control_net"]
            if a_map["kind"] == "simplex":
                a_map["weights"] = [[i, text_of(weight())] for i, _ in net]
            else:
                a_map["weights"] = nested(iter(texts([weight() for _ in range(len(net) * len(net[0]))])), [len(net), len(net[0])])
    request = {"op": "continuity", "maps": maps}
    orders = []
    for corners, p in surface_pieces(maps[0]):
        for others, q in surface_pieces(maps[1]):
            for begin, end in common_segments(corners, others):
                orders.append(order_across(p, q, begin, end, rational))
    finite = [o for o in orders if o is not None]
    expected = min(finite) if finite else None
    if not orders:
        return request, "not_adjacent"

    def check(result):
        report.expect(result["order"] == order_text(expected), "contact: order", expected, request, result)

    return request, check


def tangent_planes():
    """A surface, and one that goes on from its edge u = 1 in the same tangent planes, or not quite."""
    p = polynomial_in_plane(2, 3)
    u, v = {(1, 0): Fraction(1)}, {(0, 1): Fraction(1)}
    one = {(0, 0): Fraction(1)}

    def derivative(q, k):
        return {tuple(e - (m == k) for m, e in enumerate(index)): c * index[k] for index, c in q.items() if index[k]}

    edge = [composed2(q, one, v) for q in p]
    across = [composed2(derivative(q, 0), one, v) for q in p]
    along = [composed2(derivative(q, 1), one, v) for q in p]
    c = choose.choice([{(0, 0): Fraction(1)}, {(0, 0): Fraction(2), (0, 1): Fraction(1)}, {(0, 0): Fraction(-1)}, {(0, 0): Fraction(1), (0, 1): Fraction(-2)}])
    e = choose.choice([{}, {(0, 0): number()}, {(0, 1): Fraction(1), (0, 0): Fraction(1)}])
    bend = choose.choice([0, 0, 0, 1])
    q = []
    for k in range(3):
        slope = sum2((1, product2(c, across[k])), (1, product2(e, along[k])), (bend, {(0, 1): number(), (0, 0): number()}))
        q.append(sum2((1, edge[k]), (1, product2(u, slope)), (1, product2(power2(u, 2), {(0, 0): number()}))))
    if choose.random() < 0.1:
        q[0] = sum2((1, q[0]), (1, one))
    left_domain = choose.choice([box(Fraction(0), Fraction(1), Fraction(0), Fraction(1)), [(Fraction(1), Fraction(0)), (Fraction(1), Fraction(1)), (Fraction(0), number())]])
    right_domain = choose.choice([box(Fraction(0), Fraction(1), Fraction(0), Fraction(1)), [(Fraction(0), Fraction(1)), (Fraction(2), number()), (Fraction(0), Fraction(0))]])
    spline = choose.random() < 0.3
    maps = [as_map(p, left_domain, spline), as_map(q, right_domain, choose.random() < 0.2)]
    begin, end = sorted(choose.sample([Fraction(0), Fraction(1), Fraction(1, 3), Fraction(1, 2)], 2))
    faces = [[texts([1, begin]), texts([1, end])], [texts([0, begin]), texts([0, end])]]
    request = {"op": "continuity", "maps": maps, "faces": faces, "geometric": True}
    if choose.random() < 0.3:
        request["faces"] = "found"

    def derivative_along(f, at, vector):
        return [vector[0] * value2(derivative(g, 0), *at) + vector[1] * value2(derivative(g, 1), *at) for g in f]

    def piece_with(a_map, segment, vector):
        """The polynomials of the piece into which a vector leads from the middle of a segment."""
        middle = [(segment[0][k] + segment[1][k]) / 2 + vector[k] / 1000 for k in range(2)]
        for corners, f in surface_pieces(a_map):
            sides = []
            for a, b in zip(corners, corners[1:] + corners[:1]):
                sides.append((b[0] - a[0]) * (middle[1] - a[1]) - (b[1] - a[1]) * (middle[0] - a[0]))
            if all(x >= 0 for x in sides) or all(x <= 0 for x in sides):
                return f
        return None

    def function(text, t):
        expression = sub(r"(\d)\s*(t)", r"\1*\2", text).replace("^", "**")
        expression = sub(r"\d+", lambda number: f"Fraction({number.group()})", expression)
        expression = sub(r"\*\*Fraction\((\d+)\)", r"**\1", expression)
        expression = sub(r"\)\s+t", ")*t", expression)
        return Fraction(eval(expression, {"Fraction": Fraction, "t": t}))

    def check(result):
        found = result["geometric"]
        orders = []
        for joint in found["edges"]:
            segments = [[tuple(Fraction(x) for x in end) for end in joint[side]] for side in ("left", "right")]
            vectors = [[Fraction(x) for x in vector] for vector in joint["across"]]
            pieces = [piece_with(a_map, segment, vector) for a_map, segment, vector in zip(maps, segments, vectors)]
            report.expect(None not in pieces, "tangents: a vector leads out of the domain", request, joint)
            if None in pieces:
                return
            orders.append({"apart": -1, "smooth": 1}.get(joint["kind"], 0))
            meets = True
            for t in [Fraction(k, 9) for k in range(10)]:
                at = [[a + t * (b - a) for a, b in zip(*segment)] for segment in segments]
                meets = meets and [value2(g, *at[0]) for g in pieces[0]] == [value2(g, *at[1]) for g in pieces[1]]
                x, y = (derivative_along(f, p, vector) for f, p, vector in zip(pieces, at, vectors))
                z = derivative_along(pieces[0], at[0], [b - a for a, b in zip(*segments[0])])
                if "alpha" in joint:
                    a, b, c = (function(joint[name], t) for name in ("alpha", "beta", "gamma"))
                    report.expect(all(a * i + b * j + c * k == 0 for i, j, k in zip(x, y, z)), "tangents: relation", t, request, joint)
                    if joint["kind"] == "smooth":
                        report.expect(a * b > 0, "tangents: not smooth", t, request, joint)
                    if joint["kind"] == "folded":
                        report.expect(a * b < 0, "tangents: not folded", t, request, joint)
            report.expect(meets == (joint["kind"] != "apart"), "tangents: meeting", request, joint)
            if joint["kind"] == "bent":
                t = Fraction(joint["parameter"])
                at = [[a + t * (b - a) for a, b in zip(*segment)] for segment in segments]
                x, y = (derivative_along(f, p, vector) for f, p, vector in zip(pieces, at, vectors))
                z = derivative_along(pieces[0], at[0], [b - a for a, b in zip(*segments[0])])
                report.expect([[Fraction(i) for i in vector] for vector in joint["vectors"]] == [x, y, z], "tangents: vectors", request, joint)
                determinant = sum(x[i] * (y[(i + 1) % 3] * z[(i + 2) % 3] - y[(i + 2) % 3] * z[(i + 1) % 3]) for i in range(3))
                report.expect(determinant != 0, "tangents: dependent", request, joint)
        report.expect(found["order"] == min(orders), "tangents: order", request, result)

    return request, check if request["faces"] != "found" else (check, "not_adjacent")


makers = [
    *[clamp, trim, reverse, reparametrise, knots_inserted, remove_knot, split, periodic, at_seam, join],
    *[reduce, graph, expansion, pyramid, at_face, across_edge, tangent_planes, across_edge, tangent_planes],
]


def main():
    cases = [makers[i % len(makers)]() for i in range(CASES)]
    refused = 0
    for (request, check), response in zip(cases, ask(program, [request for request, _ in cases])):
        check, code = check if isinstance(check, tuple) else (check, check)
        if not response["ok"]:
            refused += 1
            report.expect(response["error"]["code"] == code, "refused", request, response)
        else:
            report.expect(callable(check), "not refused", request, response)
            if callable(check):
                check(response["result"])
    assert refused < CASES / 8, refused
    print(f"{len(cases)} cases, {refused} refused, {report.problems} problems")
    return 1 if report.problems else 0


sys.exit(main())
