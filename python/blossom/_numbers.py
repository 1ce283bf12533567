"""Exact numbers and what they are rounded to."""

from __future__ import annotations

from fractions import Fraction

from . import _engine


def fraction(value, floats=None) -> Fraction:
    """The number as a Fraction, read as everywhere in this module.

    >>> import blossom
    >>> blossom.fraction("1.5e-3"), blossom.fraction(0.1, floats="decimal")
    (Fraction(3, 2000), Fraction(1, 10))
    """
    return _engine.fraction(value, floats)


def nearest_double(value) -> float:
    """The double nearest to an exact number, ties to even.

    >>> import blossom
    >>> blossom.nearest_double("1/3")
    0.3333333333333333
    """
    return _engine.nearest_double(value)


def ulp(value) -> Fraction:
    """The distance between neighbouring doubles at a number.

    >>> import blossom
    >>> blossom.ulp(1)
    Fraction(1, 4503599627370496)
    """
    return _engine.unit_in_last_place(value)


def floats(value):
    """Numbers, in lists of any depth, correctly rounded.

    >>> import blossom
    >>> blossom.floats(blossom.Bezier([[0, 1], [1, 2]])("1/3"))
    (0.3333333333333333, 1.3333333333333333)
    """
    if isinstance(value, (list, tuple)):
        return type(value)(map(floats, value))
    return _engine.nearest_double(value)


def array(values):
    """Numbers, in lists of one shape, as a numpy array of correctly rounded doubles.

    >>> import blossom
    >>> blossom.array(blossom.Bezier([[0, 1], [1, 2]])(["1/2", 1]))
    array([[0.5, 1.5],
           [1. , 2. ]])
    """
    import numpy

    return numpy.array(floats(values), dtype=float)
