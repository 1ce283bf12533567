"""Strategies of Hypothesis for maps, with corners: repeated knots, reversed intervals, points at one place.

>>> from hypothesis import given
>>> from blossom import strategies
>>> @given(strategies.bsplines(), strategies.fractions())
... def a_spline_is_the_same_after_a_knot_is_inserted(spline, t):
...     a, b = strategies.domain(spline)
...     t = a + (b - a) * (t % 1)
...     assert t == a or spline.insert_knots([t])(t) == spline(t)
>>> a_spline_is_the_same_after_a_knot_is_inserted()
"""

from __future__ import annotations

from fractions import Fraction

from hypothesis import strategies as st

from . import _maps

__all__ = [
    "beziers", "bsplines", "curves", "domain", "doubles", "fractions", "intervals", "knot_vectors", "nurbs", "patches",
    "points", "polynomials",
]  # fmt: skip


def fractions(size=20, max_denominator=60):
    """Fractions, often small integers."""
    return st.one_of(
        st.integers(-3, 3).map(Fraction), st.fractions(-size, size, max_denominator=max_denominator)
    )


def doubles(size=100.0):
    """The exact values of doubles, for comparisons with libraries that compute with them."""
    return st.floats(-size, size, allow_subnormal=False).map(Fraction)


def points(dimension=None, numbers=None):
    """Numbers, or with a dimension lists of them."""
    numbers = fractions() if numbers is None else numbers
    return numbers if dimension is None else st.lists(numbers, min_size=dimension, max_size=dimension)


def intervals(numbers=None):
    """[a, b] with a != b; a > b in half of the cases."""
    numbers = fractions() if numbers is None else numbers
    return st.tuples(numbers, numbers).filter(lambda ends: ends[0] != ends[1]).map(list)


@st.composite
def polynomials(draw, max_degree=6, dimension=None, numbers=None):
    count = draw(st.integers(1, max_degree + 1))
    return _maps.Polynomial(draw(st.lists(points(dimension, numbers), min_size=count, max_size=count)))


@st.composite
def beziers(draw, max_degree=6, dimension=None, numbers=None, weights=False):
    count = draw(st.integers(1, max_degree + 1))
    chosen = draw(st.lists(points(dimension, numbers), min_size=count, max_size=count))
    fields = {"interval": draw(intervals(numbers))}
    if weights:
        fields["weights"] = draw(_weights(count))
    return _maps.Bezier(chosen, **fields)


def _weights(count):
    return st.lists(st.fractions(Fraction(1, 8), 8, max_denominator=8), min_size=count, max_size=count)


@st.composite
def knot_vectors(draw, degree, max_inner=5, numbers=None):
    """Clamped knots of the textbook convention, with inner knots of any multiplicity up to the degree."""
    numbers = fractions() if numbers is None else numbers
    distinct = sorted(draw(st.sets(numbers, min_size=2, max_size=max_inner + 2)))
    inner = [knot for knot in distinct[1:-1] for _ in range(draw(st.integers(1, max(1, degree))))]
    return [distinct[0]] * (degree + 1) + inner + [distinct[-1]] * (degree + 1)


@st.composite
def bsplines(draw, max_degree=4, dimension=None, numbers=None, max_inner=5):
    degree = draw(st.integers(1, max_degree))
    knots = draw(knot_vectors(degree, max_inner, numbers))
    count = len(knots) - degree - 1
    chosen = draw(st.lists(points(dimension, numbers), min_size=count, max_size=count))
    return _maps.BSpline(knots, chosen, degree)


@st.composite
def nurbs(draw, max_degree=3, dimension=2, max_inner=3):
    spline = draw(bsplines(max_degree, dimension, max_inner=max_inner))
    return _maps.Nurbs(spline.knots, spline.points, spline.degree, draw(_weights(len(spline.points))))


@st.composite
def patches(draw, max_degree=3, dimension=None):
    rows, columns = draw(st.integers(1, max_degree)) + 1, draw(st.integers(1, max_degree)) + 1
    row = st.lists(points(dimension), min_size=columns, max_size=columns)
    return _maps.Patch(draw(st.lists(row, min_size=rows, max_size=rows)), [rows - 1, columns - 1])


def curves(dimension=None):
    """Curves of several kinds that are one polynomial or one spline."""
    return st.one_of(polynomials(dimension=dimension), beziers(dimension=dimension), bsplines(dimension=dimension))


def domain(curve):
    """The interval [a, b] over which a curve is given; [0, 1] for a polynomial."""
    return tuple(curve._domain(1)[0])
