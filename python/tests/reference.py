"""Definitions from textbooks with Fractions, which share no code with the module."""

from fractions import Fraction
from itertools import combinations
from math import comb


def value(coefficients, t):
    """A polynomial at t, power by power."""
    return sum((c * t**k for k, c in enumerate(coefficients)), Fraction(0))


def blossom(coefficients, arguments):
    """The polar form of pairs (u, mass): each power is an average of products over all subsets."""
    n = len(coefficients) - 1
    total = Fraction(0)
    for k, c in enumerate(coefficients):
        symmetric = Fraction(0)
        for chosen in combinations(range(n), k):
            product = Fraction(1)
            for i, (u, mass) in enumerate(arguments):
                product *= u if i in chosen else mass
            symmetric += product
        total += c * symmetric / comb(n, k)
    return total


def de_casteljau(points, t, a=Fraction(0), b=Fraction(1)):
    """The point of a Bezier curve by repeated linear interpolation."""
    points = [Fraction(p) for p in points]
    while len(points) > 1:
        points = [((b - t) * p + (t - a) * q) / (b - a) for p, q in zip(points, points[1:])]
    return points[0]


def basis(knots, degree, i, t):
    """A B-spline basis function by its recurrence, right-continuous."""
    if degree == 0:
        return Fraction(int(knots[i] <= t < knots[i + 1]))
    total = Fraction(0)
    if knots[i + degree] != knots[i]:
        total += (t - knots[i]) / (knots[i + degree] - knots[i]) * basis(knots, degree - 1, i, t)
    if knots[i + degree + 1] != knots[i + 1]:
        total += (knots[i + degree + 1] - t) / (knots[i + degree + 1] - knots[i + 1]) * basis(knots, degree - 1, i + 1, t)
    return total


def spline(knots, points, degree, t):
    return sum((Fraction(p) * basis(knots, degree, i, t) for i, p in enumerate(points)), Fraction(0))
