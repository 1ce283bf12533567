"""Real roots in Python's fractions, by Sturm's theorem and bisection."""

import math
from fractions import Fraction

from spline_oracle import common_factor, plus, remainder, scaled, times, trimmed, value


def derivative(p):
    return trimmed(k * a for k, a in enumerate(p) if k)


def quotient(p, q):
    p, result = trimmed(p), []
    while len(p) >= len(q):
        term = [Fraction(0)] * (len(p) - len(q)) + [p[-1] / q[-1]]
        result = plus(result, term)
        p = plus(p, scaled(times(term, q), -1))
    return result


def squarefree(p):
    return quotient(p, common_factor([p, derivative(p)]))


class Sturm:
    """The distinct roots of a polynomial."""

    def __init__(self, p):
        p = quotient(p, common_factor([p, derivative(p)])) if len(p) > 1 else p
        self.chain = [p, derivative(p)]
        while self.chain[-1]:
            self.chain.append(scaled(remainder(self.chain[-2], self.chain[-1]), -1))
        self.chain.pop()

    def changes(self, t):
        if math.isfinite(t):
            signs = [value(p, t) for p in self.chain]
        else:
            signs = [-p[-1] if t < 0 and len(p) % 2 == 0 else p[-1] for p in self.chain]
        signs = [s for s in signs if s]
        return sum(a * b < 0 for a, b in zip(signs, signs[1:]))

    def between(self, a, b):
        """In (a, b]."""
        return self.changes(a) - self.changes(b)


def multiplicity_in(p, root):
    """Of the only root in a closed interval."""
    count = 0
    a, b = root
    while len(p) > 1 and (value(p, a) == 0 if a == b else Sturm(p).between(a, b) == 1):
        p = quotient(p, squarefree(p))
        count += 1
    return count


def neighbours(double):
    """The reals that are rounded to a double lie between these."""
    below, above = math.nextafter(double, -math.inf), math.nextafter(double, math.inf)
    return (Fraction(below) + Fraction(double)) / 2, (Fraction(above) + Fraction(double)) / 2


def without_factors_of(p, q):
    common = common_factor([p, q]) if p else []
    while len(common) > 1:
        p = quotient(p, common)
        common = common_factor([p, common])
    return p


def real_roots(p, width=Fraction(1, 2**200)):
    """All distinct real roots as intervals of this width, whose ends are equal for those that bisection meets."""
    p = trimmed(p)
    if len(p) < 2:
        return []
    p = squarefree(p)
    count = Sturm(p)
    bound = 1 + max(abs(a / p[-1]) for a in p)
    found = []
    pending = [(-bound, bound, count.between(-bound, bound))]
    while pending:
        a, b, roots = pending.pop()
        if roots == 0:
            continue
        if roots == 1:
            found.append(narrowed(p, a, b, width))
            continue
        middle = (a + b) / 2
        left = count.between(a, middle)
        pending += [(a, middle, left), (middle, b, roots - left)]
    return sorted(found)


def narrowed(p, a, b, width):
    """The only root of a squarefree polynomial in (a, b]."""
    if value(p, b) == 0:
        return b, b
    sign = value(p, b) > 0
    while b - a > width:
        middle = (a + b) / 2
        at_middle = value(p, middle)
        if at_middle == 0:
            return middle, middle
        if (at_middle > 0) == sign:
            b = middle
        else:
            a = middle
    # A rational root with a short denominator is what the interval suggests.
    simple = ((a + b) / 2).limit_denominator(10**20)
    if a <= simple <= b and value(p, simple) == 0:
        return simple, simple
    return a, b


def bounds(p, a, b):
    """Of the values of a polynomial between a and b, by Horner's rule."""
    low = high = Fraction(0)
    for coefficient in reversed(p):
        products = (low * a, low * b, high * a, high * b)
        low, high = min(products) + coefficient, max(products) + coefficient
    return low, high


def quotient_bounds(p, q, root):
    low, high = bounds(p, *root)
    least, greatest = bounds(q, *root)
    assert least * greatest > 0
    values = [x / y for x in (low, high) for y in (least, greatest)]
    return min(values), max(values)


def is_number(number, enclosure):
    """Whether a number of an answer agrees with a narrow enclosure, and its double with both."""
    low, high = enclosure
    if "value" in number:
        if not low <= Fraction(number["value"]) <= high:
            return False
    else:
        a, b = (Fraction(t) for t in number["interval"])
        if low == high or not a < low <= high < b:
            return False
    least, greatest = neighbours(float(number["double"]))
    return low <= greatest and least <= high
