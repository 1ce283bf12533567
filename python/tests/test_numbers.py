"""Numbers cross the border exactly, and only exact numbers without a word for floats."""

import decimal
import time
import timeit
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

import blossom
from blossom import Bezier, Polynomial


@given(st.integers(-(10**60), 10**60), st.integers(1, 10**60))
def test_a_fraction_goes_in_and_out(numerator, denominator):
    number = Fraction(numerator, denominator)
    result = Polynomial([0, 1])(number)
    assert result == number and type(result) is Fraction
    assert (result.numerator, result.denominator) == (number.numerator, number.denominator)
    assert blossom.fraction(number) == number


@pytest.mark.parametrize("bits", [62, 63, 64, 65, 127, 128, 129, 4095, 4096, 4097, 100_000])
@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("offset", [-1, 0, 1])
def test_integers_at_the_ends_of_words(bits, sign, offset):
    number = sign * 2**bits + offset
    assert Polynomial([0, 1])(number) == number
    assert Polynomial([0, 1])(Fraction(1, abs(number))) == Fraction(1, abs(number))
    assert blossom.fraction(number) == number


def test_a_fraction_that_is_not_in_lowest_terms_is_reduced():
    number = Fraction.__new__(Fraction)
    number._numerator, number._denominator = 2, -4
    result = Polynomial([0, 1])(number)
    assert (result.numerator, result.denominator) == (-1, 2)


def test_subclasses_and_truth_values():
    class Count(int):
        pass

    class Ratio(Fraction):
        pass

    assert Polynomial([0, 1])(Count(3)) == 3
    assert Polynomial([0, 1])(Ratio(1, 3)) == Fraction(1, 3)
    with pytest.raises(blossom.Error) as caught:
        Polynomial([0, 1])(True)
    assert caught.value.code == "not_a_number"


@pytest.mark.parametrize(
    "written, value",
    [
        ("1/3", Fraction(1, 3)),
        ("-0.125", Fraction(-1, 8)),
        ("0x1.8p-3", Fraction(3, 16)),
        (decimal.Decimal("0.1"), Fraction(1, 10)),
        (decimal.Decimal("-12.50e3"), -12500),
        (decimal.Decimal("1E+3"), 1000),
    ],
)
def test_texts_and_decimals(written, value):
    assert blossom.fraction(written) == value
    assert Polynomial([0, 1])(written) == value


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_floats_need_a_word(number):
    with pytest.raises(blossom.Error) as caught:
        blossom.fraction(number)
    assert caught.value.code == "inexact_number"
    assert blossom.fraction(number, floats="double") == Fraction(number)
    assert blossom.fraction(number, floats="decimal") == Fraction(repr(number))
    assert blossom.nearest_double(Fraction(number)) == number


@pytest.mark.parametrize("number", [float("nan"), float("inf"), -float("inf"), decimal.Decimal("NaN"), decimal.Decimal("Infinity")])
@pytest.mark.parametrize("floats", [None, "double", "decimal"])
def test_what_is_no_number(number, floats):
    with pytest.raises(blossom.Error) as caught:
        blossom.fraction(number, floats=floats)
    assert caught.value.code == "not_a_number"


def test_the_place_of_a_refused_float():
    with pytest.raises(blossom.Error) as caught:
        Bezier([[0, 1], [2, 0.5]])
    assert caught.value.place == ("control_points", 1, 1)
    assert caught.value.at == "/control_points/1/1"
    with pytest.raises(blossom.Error) as caught:
        Bezier([0, 1])(0.5)
    assert caught.value.code == "inexact_number"
    assert Bezier([0, 1])(0.1, floats="decimal") == Fraction(1, 10)
    assert Bezier([0, 1])(0.1, floats="double") == Fraction(0.1)
    with pytest.raises(blossom.Error) as caught:
        Bezier([0, 0.5], floats="single")
    assert caught.value.place == ("floats",)


def test_numpy_numbers():
    numpy = pytest.importorskip("numpy")
    p = Polynomial("t^2")
    assert p(numpy.int64(3)) == 9
    assert p(numpy.float64(0.5), floats="double") == Fraction(1, 4)
    assert p(numpy.float32(0.1), floats="double") == Fraction(float(numpy.float32(0.1))) ** 2
    assert p(numpy.float32(0.1), floats="decimal") == Fraction(1, 100)
    with pytest.raises(blossom.Error):
        p(numpy.float32(0.5))
    values = p(numpy.array([Fraction(1, 2), 3], dtype=object))
    assert isinstance(values, numpy.ndarray) and values.dtype == object
    assert values.tolist() == [Fraction(1, 4), 9]
    curve = Bezier(numpy.array([[0, 1], [2, 3]]))
    assert curve(numpy.array([[0, 1], [2, 3]])).shape == (2, 2, 2)
    assert Bezier(numpy.array([0.5, 1.0]), floats="double").points == (Fraction(1, 2), 1)


def test_sympy_numbers():
    sympy = pytest.importorskip("sympy")
    assert Polynomial("t^2")(sympy.Rational(1, 3)) == Fraction(1, 9)
    assert Polynomial("t^2")(sympy.Integer(3)) == 9
    assert blossom.fraction(sympy.S.Half) == Fraction(1, 2)
    with pytest.raises(blossom.Error):
        blossom.fraction(sympy.pi)


def test_rounded_numbers_out():
    curve = Bezier([[0, 1], [1, 2]])
    result = curve.evaluate(["1/3"], numbers="double")
    assert result.values_double == ((1 / 3, 4 / 3),)
    assert result.values == ((Fraction(1, 3), Fraction(4, 3)),)
    assert curve.evaluate(["1/3"], numbers="hexfloat").values_hex[0][0] == (1 / 3).hex()
    assert blossom.floats(curve("1/3")) == (1 / 3, 4 / 3)


def test_numbers_without_end_are_refused():
    endless = []
    endless.append(endless)
    with pytest.raises(blossom.LimitExceeded) as caught:
        Bezier(endless)
    assert caught.value.limit == "nesting"
    with pytest.raises(blossom.LimitExceeded) as caught:
        blossom.fraction(1 << 40_000_000)
    assert caught.value.limit == "digits"


def shortest(call, count=20_000):
    """The processor time of one call in microseconds, the least of several measurements."""
    return min(timeit.repeat(call, timer=time.process_time, number=count, repeat=7)) / count * 1e6


def test_small_numbers_cross_quickly():
    half, cubic = Fraction(1, 2), Polynomial("1 + 2t + 4t^2 - t^3")
    many = [Fraction(k, 7) for k in range(1000)]
    assert shortest(lambda: blossom.fraction(half)) < 2 * 0.5  # it goes in and out
    assert shortest(lambda: cubic(half)) < 2
    assert shortest(lambda: cubic[half, 2, 3]) < 2
    assert shortest(lambda: cubic(many), 50) < 1000
