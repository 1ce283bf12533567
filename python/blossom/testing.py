"""An oracle for the tests of other libraries.

`assert_exact` compares floats with exact numbers in units in the last place; `blossom.strategies` makes maps
to compare with. This finds what is wrong in a value without any tolerance to choose:

>>> import blossom
>>> from blossom.testing import assert_exact
>>> curve = blossom.Bezier([0, "1/3", 1])
>>> assert_exact([0.0, 0.18750000000000003], curve([0, "1/4"]), ulps="1/2")
Traceback (most recent call last):
    ...
AssertionError: at [1]: 0.18750000000000003 is 1 ulps from 3/16, whose nearest double is 0.1875
"""

from __future__ import annotations

from fractions import Fraction

from ._numbers import nearest_double, ulp

__all__ = ["assert_exact", "error_in_ulps"]


def error_in_ulps(actual: float, expected) -> Fraction:
    """|actual - expected| in units in the last place of `expected`, exactly.

    >>> from fractions import Fraction
    >>> error_in_ulps(1.0, Fraction(1)), error_in_ulps(0.1, Fraction(1, 10))
    (Fraction(0, 1), Fraction(2, 5))
    """
    return abs(Fraction(actual) - Fraction(expected)) / ulp(expected)


def _is_list(value) -> bool:
    return hasattr(value, "__len__") and not isinstance(value, str)


def assert_exact(actual, expected, ulps=1, place="") -> None:
    """Fails unless each number of `actual` is within `ulps` units in the last place of the exact one.

    Both may be numbers or lists, tuples and arrays of the same shape. With ``ulps="1/2"`` each must be the nearest
    double, or one of the two at the same distance.
    """
    if _is_list(actual) or _is_list(expected):
        if not (_is_list(actual) and _is_list(expected)) or len(actual) != len(expected):
            raise AssertionError(f"at {place or 'the top'}: the shapes differ: {actual!r} and {expected!r}")
        for i, (one, other) in enumerate(zip(actual, expected)):
            assert_exact(one, other, ulps, f"{place}[{i}]")
        return
    where = f"at {place}: " if place else ""
    expected = Fraction(expected)
    value = float(actual)
    if value != value or value in (float("inf"), -float("inf")):
        raise AssertionError(f"{where}{value} is no number; {_exact(expected)} is expected")
    error = error_in_ulps(value, expected)
    if error > Fraction(ulps):
        raise AssertionError(
            f"{where}{value!r} is {float(error):.3g} ulps from {_exact(expected)}, "
            f"whose nearest double is {nearest_double(expected)!r}"
        )


def _exact(number: Fraction) -> str:
    text = str(number)
    return text if len(text) <= 60 else f"{text[:28]}...{text[-28:]}"
