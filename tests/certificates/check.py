#!/usr/bin/env python3
"""Checks certificates of the program with Coq, and certificates with one changed digit.

usage: check.py PROGRAM THEORIES; THEORIES holds the compiled files of proofs/coq. COUNT requests of every kind
are certified, and Coq must accept all certificates. Then one digit of each of CHANGED certificates is changed: Coq must
refuse the certificates that are now false, and accept those that are still true (a derivative does not depend on a
constant). An independent oracle in exact fractions decides which ones these are.
"""

import fractions
import json
import math
import pathlib
import random
import re
import subprocess
import sys

COUNT, CHANGED, GREATEST_DEGREE = 320, 120, 20

program, theories = sys.argv[1], pathlib.Path(sys.argv[2])
draw = random.Random(8)
problems = 0


def number():
    kind = draw.randrange(10)
    if kind == 0:
        return "0"
    digits = 25 if kind == 9 and draw.random() < 0.2 else draw.choice([1, 1, 1, 2, 3])  # 25 digits are two words
    numerator, denominator = (draw.randrange(1, 10**digits) for _ in range(2))
    return f"{draw.choice(['', '-'])}{numerator}/{denominator if draw.random() < 0.6 else 1}"


def numbers(count):
    return [number() for _ in range(count)]


def interval():
    a, b = numbers(2)
    return interval() if fractions.Fraction(a) == fractions.Fraction(b) else [a, b]


def argument():
    kind = draw.randrange(4)
    return {"vector": number()} if kind == 0 else {"homogeneous": numbers(2)} if kind == 1 else number()


def curve(degree):
    dimension = draw.choice([0, 0, 1, 2, 3])
    points = [numbers(dimension) if dimension else number() for _ in range(degree + 1)]
    kind = draw.randrange(7)
    if kind < 3:
        return {"kind": "polynomial", "coefficients": points, "degree": degree}
    if kind == 3:
        return {"kind": "bezier", "control_points": points, "interval": interval()}
    if kind == 4:
        return {"kind": "taylor", "center": number(), "coefficients": points}
    if kind == 5:
        return {"kind": "progressive", "knots": increasing(2 * degree), "control_points": points}
    return {"kind": "bspline", "degree": degree, "knots": increasing(2 * degree + 3),
            "control_points": [*points, points[0]]}


def increasing(count):
    steps = [fractions.Fraction(draw.randrange(1, 9), draw.randrange(1, 9)) for _ in range(count)]
    return [str(sum(steps[:i + 1])) for i in range(count)]


def domain_knots(spline):
    return spline["knots"][spline["degree"]:-spline["degree"] or None]


def request():
    op = draw.choice(["blossom", "blossom", "control-points", "derivative", "agree"])
    degree = min(draw.choice([0, 1, 2, 3, 4, 5, 8, GREATEST_DEGREE]), 8 if op != "blossom" else GREATEST_DEGREE)
    made = {"op": op, "map": curve(degree)}
    spline = made["map"]["kind"] == "bspline"
    if spline and op == "agree":
        made["op"] = op = "blossom"
    if spline and op == "blossom":
        made["segment"] = degree + draw.randrange(2)
    if op == "blossom" or (op == "agree" and draw.random() < 0.5):
        made["arguments"] = [argument() for _ in range(degree)]
    elif op == "agree":
        made["map"] = {"kind": "polynomial", "coefficients": numbers(5)}
    elif op == "control-points":
        if not spline:
            made["interval"] = interval()
        elif draw.random() < 0.5:
            made["interval"] = sorted(draw.sample(domain_knots(made["map"]), 2), key=fractions.Fraction)
        if draw.random() < 0.3:
            made["degree"] = degree + draw.randrange(3)
    else:
        made["order"] = draw.randrange(degree + 2)
        if draw.random() < 0.7:
            count = draw.randrange(1, 4)
            made["at"] = draw.sample(domain_knots(made["map"]), min(count, 3)) if spline else numbers(count)
    return made


class Reader:
    """The integers of a stream of words, by the format of proofs/coq/stream.v."""

    def __init__(self, words):
        self.words = words

    def word(self):
        return self.words.pop(0) if self.words else 0

    def integer(self):
        head = self.word()
        magnitude = head >> 2
        if head & 1:
            parts = [self.word() for _ in range(min(magnitude, len(self.words)))]
            magnitude = sum(part << (60 * i) for i, part in enumerate(parts))
        return -magnitude if head & 2 else magnitude

    def count(self):
        return max(0, min(self.integer(), len(self.words)))


def product_of_factors(arguments):
    product = [1]
    for u, v, _ in arguments:
        product = [v * a + u * b for a, b in zip([*product, 0], [0, *product])]
    return product


def holds(reader, degree, scale, coefficients):
    arguments = [[reader.integer() for _ in range(3)] for _ in range(degree)]
    multiple, numerator, denominator = (reader.integer() for _ in range(3))
    if 0 in (scale, denominator, *(w for _, _, w in arguments)):
        return False
    terms = zip(coefficients, product_of_factors(arguments), range(degree + 1))
    value = sum(fractions.Fraction(p * e, math.comb(degree, k)) for p, e, k in terms)
    value /= scale * math.prod(w for _, _, w in arguments)
    return multiple * value == fractions.Fraction(numerator, denominator)


def is_true(words):
    reader = Reader(list(words))
    right = True
    for _ in range(reader.count()):
        degree, scale = reader.count(), reader.integer()
        coefficients = [reader.integer() for _ in range(degree + 1)]
        for _ in range(reader.count()):
            right = holds(reader, degree, scale, coefficients) and right
    return right and not reader.words


def accepted_by_coq(name, text):
    path = theories / f"{name}.v"
    path.write_text(text, encoding="utf-8")
    coq = subprocess.run(["coqc", "-q", "-w", "none", "-R", ".", "Blossom", path.name], cwd=theories, check=False,
                         capture_output=True, text=True)
    if coq.returncode:
        print(coq.stderr.strip()[-600:], file=sys.stderr)
    return coq.returncode == 0


def require(condition, what):
    global problems
    if not condition:
        problems += 1
        print(f"FAILED: {what}", file=sys.stderr)


def with_one_digit_changed(block):
    begin = block.index(":=") + 2
    end = block.index("%uint63")
    places = [i for i in range(begin, end) if block[i].isdigit()]
    place = draw.choice(places)
    digit = draw.choice([d for d in "0123456789" if d != block[place]])
    return block[:place] + digit + block[place + 1:]


def words_of(block):
    return [int(word) for word in re.findall(r"\d+", block[block.index(":=") + 2:block.index("%uint63")])]


requests = [request() for _ in range(COUNT)]
lines = json.dumps({"op": "certify", "requests": requests}) + "\n"
answer = json.loads(subprocess.run([program, "batch"], input=lines, capture_output=True, text=True,
                                   check=False).stdout)
require("result" in answer, f"the program refuses the requests: {json.dumps(answer.get('error'))}")
document = answer["result"]["document"] if "result" in answer else ""
header, *blocks = re.split(r"\n(?=\(\* [a-z-]+\n)", document)
require(len(blocks) == COUNT, f"{len(blocks)} certificates for {COUNT} requests")
require(all(is_true(words_of(block)) for block in blocks), "the oracle finds a certificate that is false")
require(accepted_by_coq("Certificates", document), "Coq refuses certificates of the program")

refused = 0
changed = [header]
for block in draw.sample(blocks, min(CHANGED, len(blocks))):
    other = with_one_digit_changed(block)
    still_true = is_true(words_of(other))
    refused += not still_true
    theorem = other.rindex("Definition")
    changed.append(other if still_true else other[:theorem] + "Fail " + other[theorem:])
require(refused > CHANGED * 3 // 4, f"only {refused} of {CHANGED} changed digits make a certificate false")
require(accepted_by_coq("Changed", "\n".join(changed)), "Coq accepts a certificate with a wrong digit")

print(f"{len(blocks)} certificates accepted, {refused} of {CHANGED} with one digit changed refused, the others still true")
sys.exit(problems != 0)
