"""Arithmetic of maps on one domain."""

from __future__ import annotations

from . import _engine, _operations


def _exact(value):
    """The number as a Fraction, or None if it is none; a float stays an error."""
    if hasattr(value, "__iter__"):
        return None
    try:
        return _engine.fraction(value, None)
    except ValueError as error:
        if getattr(error, "code", "") == "inexact_number":
            raise
        return None


def _call(operation, *maps, **fields):
    return _operations.BY_NAME[operation].call(None, (list(maps),), fields)


class Arithmetic:
    """Sums, multiples, products and quotients.

    >>> from blossom import Bezier, Polynomial
    >>> p, q = Polynomial("1 + t"), Polynomial("t^2")
    >>> p + q, 2 * p - q, p * q
    (Polynomial([1, 1, 1]), Polynomial([2, 2, -1]), Polynomial([0, 0, 1, 1]))
    >>> (p / q)(2)
    Fraction(3, 4)
    >>> Bezier([[0, 1], [2, 3]]) / 2
    Bezier([[0, '1/2'], [1, '3/2']])
    """

    __slots__ = ()

    def __add__(self, other):
        return _call("sum", self, other) if isinstance(other, Arithmetic) else NotImplemented

    def __sub__(self, other):
        return _call("sum", self, other, factors=[1, -1]) if isinstance(other, Arithmetic) else NotImplemented

    def __neg__(self):
        return _call("sum", self, factors=[-1])

    def __mul__(self, other):
        if isinstance(other, Arithmetic):
            return _call("product", self, other)
        number = _exact(other)
        return NotImplemented if number is None else _call("sum", self, factors=[number])

    __rmul__ = __mul__

    def __truediv__(self, other):
        if isinstance(other, Arithmetic):
            return _call("quotient", self, other)
        number = _exact(other)
        return NotImplemented if number is None else _call("sum", self, factors=[1 / number])

    def __matmul__(self, other):
        """The dot product."""
        return _call("product", self, other, as_="dot") if isinstance(other, Arithmetic) else NotImplemented
