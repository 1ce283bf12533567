#!/usr/bin/env python3
"""process_peers.py BENCH_VALUES [--quick]: measures one blossom value in PARI and in SymPy, as their users would write it.

PARI multiplies the linear factors as polynomials over Q by its own product tree and takes the inner product. It runs in one gp
process and measures its own CPU time. SymPy does the same with polynomials over its domain QQ in this process. The values of both
are compared with the engine's before the measurement. Prints CSV: degree,bits,peer,nanoseconds (least of the rounds).
"""

import subprocess
import sys
import time
from fractions import Fraction
from math import comb

from sympy import QQ
from sympy.polys.densearith import dup_mul

program = sys.argv[1]
quick = len(sys.argv) > 2
rounds = 1 if quick else 5


def case(degree, bits):
    lines = subprocess.run([program, "--case", str(degree), str(bits)], check=True, capture_output=True, text=True).stdout.splitlines()
    return lines[0].split(), lines[1].split(), lines[2]


def sympy_value(coefficients, arguments):
    def product(factors):
        if len(factors) == 1:
            return factors[0]
        half = len(factors) // 2
        return dup_mul(product(factors[:half]), product(factors[half:]), QQ)

    elementary = product([[u, QQ(1)] for u in arguments])[::-1]
    degree = len(arguments)
    return sum((c * e / comb(degree, k) for k, (c, e) in enumerate(zip(coefficients, elementary))), QQ(0))


def sympy_seconds(coefficients, arguments, expected):
    def number(text):
        value = Fraction(text)
        return QQ(value.numerator, value.denominator)

    coefficients = [number(text) for text in coefficients]
    arguments = [number(text) for text in arguments]
    assert sympy_value(coefficients, arguments) == number(expected), "SymPy gives another value"
    best = float("inf")
    for _ in range(rounds):
        start = time.process_time()
        count = 0
        while time.process_time() - start < 0.02:
            sympy_value(coefficients, arguments)
            count += 1
        best = min(best, (time.process_time() - start) / count)
    return best


def pari_seconds(coefficients, arguments, expected):
    degree = len(arguments)
    script = f"""
c = [{",".join(coefficients)}]; u = [{",".join(arguments)}]; n = {degree};
w = vector(n + 1, k, c[k] / binomial(n, k - 1));
value() = {{ my(e = Vecrev(vecprod([1 + t * 'x | t <- u]), n + 1)); e * w~ }};
if (value() != {expected}, error("PARI gives another value"));
most = {20 if quick else 100}; m = 1;
while (1, gettime(); for (i = 1, m, value()); t = gettime(); if (t >= most, break); m *= 2);
best = t / m;
for (j = 2, {rounds}, gettime(); for (i = 1, m, value()); best = min(best, gettime() / m));
print(round(best * 1e6));
"""
    output = subprocess.run(["gp", "-q", "-f", "--default", "parisizemax=2G"], input=script, check=True, capture_output=True, text=True)
    return int(output.stdout.split()[-1]) / 1e9


print("degree,bits,peer,nanoseconds")
for bits in (4, 64):
    for degree in (3, 10) if quick else (3, 10, 20, 100, 300):
        given = case(degree, bits)
        for peer, seconds in (("PARI", pari_seconds), ("SymPy", sympy_seconds)):
            if peer == "SymPy" and degree > 100:
                continue
            print(f"{degree},{bits},{peer},{1e9 * seconds(*given):.0f}", flush=True)
