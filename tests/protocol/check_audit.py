#!/usr/bin/env python3
"""Compares the errors, ulps and roundings of the program with Python's fractions and floats.

usage: check_audit.py PROGRAM
"""

import json
import math
import subprocess
import sys
from fractions import Fraction

program = sys.argv[1]


def text_of(number):
    return str(number.numerator) if number.denominator == 1 else f"{number.numerator}/{number.denominator}"


def power(exponent):
    return Fraction(2) ** exponent


def nearest(exact):
    """The nearest double, with the sign of the exact number; None if it is beyond the doubles."""
    try:
        return math.copysign(exact.numerator / exact.denominator, -1.0 if exact < 0 else 1.0)
    except OverflowError:
        return None


def unit(exact):
    """The unit in the last place of the greatest double that is at most |exact|."""
    size = abs(exact)
    below = nearest(size)
    if below is None:
        below = sys.float_info.max
    if Fraction(below) > size:
        below = math.nextafter(below, 0.0)
    return Fraction(math.ulp(below))


def exact_numbers(exponent):
    for near in (0, -52, -53, -54, -55, -80):
        for sign in (1, -1):
            yield power(exponent) + (sign * power(exponent + near) if near else 0)


def computed_for(exact, zeros):
    rounded = nearest(exact)
    if rounded is None:
        rounded = math.copysign(sys.float_info.max, -1 if exact < 0 else 1)
    yield rounded
    for towards in (math.inf, -math.inf):
        other = math.nextafter(rounded, towards)
        if math.isfinite(other):
            yield other
    if zeros:
        yield 0.0
        yield -0.0


cases = []
for exponent in range(-1080, 1025):
    exact = [sign * number for number in exact_numbers(exponent) for sign in (1, -1)]
    exact += [Fraction(0), 1 - Fraction(1, 10**24)] if exponent % 100 == 0 else []
    pairs = [(number, double) for number in exact for double in computed_for(number, exponent % 16 == 0)]
    inside = [pair for pair in pairs if nearest(pair[0]) is not None]
    if inside:
        cases.append(inside)
    for number, double in pairs:
        if nearest(number) is None:
            cases.append([(number, double)])


def shown(double, i):
    """As a JSON number, a decimal text or a hexadecimal text."""
    return (double, repr(double), double.hex())[i % 3]


requests = []
for pairs in cases:
    points = [text_of(number) for number, _ in pairs]
    given = {"kind": "bezier", "control_points": points}
    computed = {"control_points": [shown(double, i) for i, (_, double) in enumerate(pairs)]}
    requests.append({"op": "audit", "map": given, "computed": computed})
    for rounding in ("double", "hexfloat"):
        requests.append({"op": "control-points", "map": given, "numbers": rounding})
lines = "".join(json.dumps(request) + "\n" for request in requests)
answers = subprocess.run([program, "batch"], input=lines, capture_output=True, text=True, check=False).stdout
responses = [json.loads(line, parse_int=float) for line in answers.splitlines()]
assert len(responses) == len(requests) > 6000, len(responses)

problems = 0


def expect(found, expected, what):
    global problems
    if found != expected:
        problems += 1
        if problems < 20:
            print(what, "expected:", expected, "found:", found)


def bits(double):
    return double.hex()


for i, pairs in enumerate(cases):
    audit, decimal, hexadecimal = responses[3 * i : 3 * i + 3]
    if nearest(pairs[0][0]) is None:
        for response in (audit, decimal, hexadecimal):
            expect(response.get("error", {}).get("code"), "overflow", text_of(pairs[0][0]))
        continue
    result = audit["result"]
    errors = [Fraction(double) - number for number, double in pairs]
    ulps = [abs(error) / unit(number) for error, (number, _) in zip(errors, pairs)]
    expect([Fraction(error) for error in result["errors"]["control_points"]], errors, f"errors of case {i}")
    expect([Fraction(ulp) for ulp in result["ulps"]["control_points"]], ulps, f"ulps of case {i}")
    expect(Fraction(result["greatest_ulps"]), max(ulps), f"greatest of case {i}")
    expect(int(result["numbers"]), len(pairs), f"numbers of case {i}")
    expect(int(result["not_nearest"]), sum(nearest(number) != double for number, double in pairs), f"not nearest of case {i}")
    rounded = [bits(nearest(number)) for number, _ in pairs]
    expect([bits(float(x)) for x in decimal["result"]["map"]["control_points_double"]], rounded, f"doubles of case {i}")
    expect([bits(float.fromhex(x)) for x in hexadecimal["result"]["map"]["control_points_hex"]], rounded, f"hex of case {i}")

print(f"{len(cases)} cases, {problems} problems")
sys.exit(1 if problems else 0)
