#!/usr/bin/env python3
"""Recomputes every case of the packs with fractions, and checks their doubles, order and checksums.

    check_pack.py PROGRAM [--cases N] [--seed S]
"""

import argparse
import json
import math
import subprocess
import sys
import zlib
from fractions import Fraction

FAMILIES = ["evaluate", "blossom", "derivative", "subdivide", "elevate", "spline", "nurbs", "insert-knots",
            "remove-knot", "triangle", "tensor", "roots"]


def exact(value):
    """The numbers of a request or a result: doubles as they are, exact ones from their texts."""
    if isinstance(value, list):
        return [exact(element) for element in value]
    return Fraction(value)


def blend(s, a, b):
    return [(1 - s) * x + s * y for x, y in zip(a, b)]


def casteljau(points, arguments):
    """The blossom over [0, 1] at pairs (u, mass)."""
    for u, mass in arguments:
        points = [[(mass - u) * x + u * y for x, y in zip(a, b)] for a, b in zip(points, points[1:])]
    return points[0]


def bernstein(n, k, t):
    return math.comb(n, k) * (1 - t) ** (n - k) * t ** k


def basis(degree, knots, i, t, last):
    """Cox and de Boor; the last non-empty span is closed."""
    if degree == 0:
        return int(knots[i] <= t < knots[i + 1] if t < last else knots[i] < knots[i + 1] == last)
    value = Fraction(0)
    if knots[i + degree] > knots[i]:
        value += (t - knots[i]) / (knots[i + degree] - knots[i]) * basis(degree - 1, knots, i, t, last)
    if knots[i + degree + 1] > knots[i + 1]:
        value += ((knots[i + degree + 1] - t) / (knots[i + degree + 1] - knots[i + 1])
                  * basis(degree - 1, knots, i + 1, t, last))
    return value


def spline_value(curve, t):
    degree, knots, points = curve["degree"], exact(curve["knots"]), exact(curve["control_points"])
    points = [point if isinstance(point, list) else [point] for point in points]
    last = knots[len(points)]
    values = [basis(degree, knots, i, t, last) for i in range(len(points))]
    if "weights" in curve:
        values = [value * weight for value, weight in zip(values, exact(curve["weights"]))]
    total = sum(values) if "weights" in curve else Fraction(1)
    return [sum(value * point[j] for value, point in zip(values, points)) / total
            for j in range(len(points[0]))]


def parameters_of(curve):
    """Enough parameters in each span to distinguish curves of this degree."""
    knots, degree = sorted(set(exact(curve["knots"]))), curve["degree"]
    given = exact(curve["knots"])
    begin, end = given[degree], given[-degree - 1]
    spans = [(a, b) for a, b in zip(knots, knots[1:]) if begin <= a and b <= end]
    return [a + Fraction(k, 2 * degree + 2) * (b - a) for a, b in spans[:3] for k in range(2 * degree + 1)]


def sign_changes(coefficients, interval):
    """The number of different roots in an interval without a root at its ends, by Sturm's sequence."""
    def trim(p):
        while p and p[-1] == 0:
            p = p[:-1]
        return p

    def remainder(a, b):
        a = list(a)
        while len(a) >= len(b):
            factor = a[-1] / b[-1]
            for k in range(len(b)):
                a[len(a) - len(b) + k] -= factor * b[k]
            a = trim(a[:-1])
        return a

    sequence = [trim(coefficients), trim([k * c for k, c in enumerate(coefficients)][1:])]
    while sequence[-1]:
        sequence.append(trim([-c for c in remainder(sequence[-2], sequence[-1])]))
    sequence.pop()

    def changes(t):
        signs = [value for value in (sum(c * t ** k for k, c in enumerate(p)) for p in sequence) if value]
        return sum(a * b < 0 for a, b in zip(signs, signs[1:]))

    return changes(interval[0]) - changes(interval[1])


def monomial(points):
    n = len(points) - 1
    return [sum(math.comb(n, k) * math.comb(k, i) * (-1) ** (k - i) * points[i] for i in range(k + 1))
            for k in range(n + 1)]


def check_roots(request, result):
    coefficients = monomial([point for point in exact(request["map"]["control_points"])])
    value = lambda t: sum(c * t ** k for k, c in enumerate(coefficients))
    degree_found = 0
    for root in result["roots"]:
        degree_found += root["multiplicity"]
        if "value" in root:
            assert value(Fraction(root["value"])) == 0
            assert root["double"] == float(Fraction(root["value"]))
            continue
        a, b = exact(root["interval"])
        assert value(a) != 0 and value(b) != 0 and sign_changes(coefficients, (a, b)) == 1
        # The root lies between the middles between its double and the neighbours of this.
        double = root["double"]
        low = max(a, (Fraction(double) + Fraction(math.nextafter(double, -math.inf))) / 2)
        high = min(b, (Fraction(double) + Fraction(math.nextafter(double, math.inf))) / 2)
        assert value(low) * value(high) <= 0 or root["multiplicity"] % 2 == 0
    zeros = sum(value(Fraction(t)) == 0 for t in (0, 1))
    inside = [r for r in result["roots"] if Fraction(r.get("value", "1/2")) not in (0, 1)]
    lower, upper = Fraction(0), Fraction(1)
    step = Fraction(1, 2 ** 2000)
    assert sign_changes(coefficients, (lower + step, upper - step)) == len(inside), "missing roots"
    assert len(result["roots"]) == zeros + len(inside) and degree_found <= len(coefficients) - 1


def check_case(family, request, result):
    if family == "roots":
        return check_roots(request, result)
    if family in ("spline", "nurbs"):
        expected = [spline_value(request["map"], t) for t in exact(request["at"])]
        assert exact(result["values"]) == expected
        return None
    if family in ("insert-knots", "remove-knot"):
        new = result["map"]
        for t in parameters_of(new if family == "insert-knots" else request["map"]):
            assert spline_value(request["map"], t) == spline_value(new, t)
        knots = exact(request["map"]["knots"])
        if family == "insert-knots":
            assert exact(new["knots"]) == sorted(knots + exact(request["knots"]))
        else:
            knots.remove(exact(request["knot"]))
            assert exact(new["knots"]) == knots
        return None
    if family == "triangle":
        n, net = request["map"]["degree"], request["map"]["control_net"]
        for at, value in zip(exact(request["at"]), exact(result["values"])):
            expected = [Fraction(0)] * len(net[0][1])
            for index, point in net:
                weight = Fraction(math.factorial(n))
                for u, k in zip(at, index):
                    weight = weight * u ** k / math.factorial(k)
                expected = [e + weight * x for e, x in zip(expected, exact(point))]
            assert value == expected
        return None
    if family == "tensor":
        m, n = request["map"]["degrees"]
        net = exact(request["map"]["control_net"])
        for (u, v), value in zip(exact(request["at"]), exact(result["values"])):
            expected = [sum(bernstein(m, i, u) * bernstein(n, j, v) * net[i][j][c]
                            for i in range(m + 1) for j in range(n + 1)) for c in range(len(net[0][0]))]
            assert value == expected
        return None

    points = exact(request["map"]["control_points"])
    n = len(points) - 1
    if family == "evaluate":
        assert exact(result["values"]) == [casteljau(points, [(t, 1)] * n) for t in exact(request["at"])]
    elif family == "blossom":
        arguments = [(Fraction(a["vector"]), 0) if isinstance(a, dict) else (Fraction(a), 1)
                     for a in request["arguments"]]
        assert exact(result["value"]) == casteljau(points, arguments)
    elif family == "derivative":
        k = request["order"]
        for t, value in zip(exact(request["at"]), exact(result["values"])):
            expected = [Fraction(0)] * len(points[0])
            if k <= n:
                expected = [math.perm(n, k) * x for x in casteljau(points, [(t, 1)] * (n - k) + [(1, 0)] * k)]
            assert value == expected
    elif family == "subdivide":
        t = Fraction(request["at"])
        for part, (a, b) in zip(result["maps"], [(Fraction(0), t), (t, Fraction(1))]):
            expected = [casteljau(points, [(a, 1)] * (n - k) + [(b, 1)] * k) for k in range(n + 1)]
            assert exact(part["control_points"]) == expected and exact(part["interval"]) == [a, b]
    elif family == "elevate":
        found = exact(result["map"]["control_points"])
        r = request["by"]
        expected = []
        for k in range(n + r + 1):
            terms = [(Fraction(math.comb(n, i) * math.comb(r, k - i), math.comb(n + r, k)), points[i])
                     for i in range(max(0, k - r), min(n, k) + 1)]
            expected.append([sum(w * p[j] for w, p in terms) for j in range(len(points[0]))])
        assert found == expected
    else:
        raise AssertionError(f"no check of {family}")
    return None


def check_doubles(value):
    """The rounded numbers beside the exact ones; returns how many there are."""
    if isinstance(value, list):
        return sum(check_doubles(element) for element in value)
    if not isinstance(value, dict):
        return 0
    count = 0
    for name, member in value.items():
        if name.endswith("_double"):
            count += compare(value[name[:-len("_double")]], member, float)
        elif name.endswith("_hex"):
            compare(value[name[:-len("_hex")]], member, float.fromhex)
        else:
            count += check_doubles(member)
    return count


def compare(numbers, doubles, read):
    if isinstance(doubles, list):
        assert len(numbers) == len(doubles)
        return sum(compare(a, b, read) for a, b in zip(numbers, doubles))
    if numbers != doubles or isinstance(numbers, str):
        assert read(doubles) == float(Fraction(numbers)), (numbers, doubles)
        return 1
    return 0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--cases", type=int, default=60)
    parser.add_argument("--seed", type=int, default=7)
    arguments = parser.parse_args()

    def pack(family, *options):
        return subprocess.run([arguments.program, "pack", family, *options], check=True, capture_output=True,
                              text=True).stdout

    doubles = 0
    for family in FAMILIES:
        text = pack(family, "--seed", str(arguments.seed), "--cases", str(arguments.cases))
        lines = text.splitlines()
        end = json.loads(lines[-1])
        body = "".join(line + "\n" for line in lines[:-1])
        assert end == {"lines": arguments.cases + 1, "crc32": f"{zlib.crc32(body.encode()):08x}"}, family
        header = {"pack": family, "version": 1, "seed": arguments.seed, "cases": arguments.cases}
        assert json.loads(lines[0]) == header
        assert len({line.split('"request"')[1] for line in lines[1:-1]}) > arguments.cases * 9 // 10
        shorter = pack(family, "--seed", str(arguments.seed), "--cases", "3").splitlines()
        assert shorter[1:4] == lines[1:4]
        assert pack(family, "--seed", "99", "--cases", "3").splitlines()[1:4] != lines[1:4]
        for line in lines[1:-1]:
            case = json.loads(line)
            try:
                check_case(family, case["request"], case["result"])
                doubles += check_doubles(case["result"])
            except AssertionError:
                print(f"{family}: {line[:2000]}", file=sys.stderr)
                raise
    assert doubles > 20 * arguments.cases, doubles
    print(f"{len(FAMILIES) * arguments.cases} cases, {doubles} doubles")


if __name__ == "__main__":
    main()
