"""blossom.testing and blossom.strategies, and with them a test of SciPy as its authors could have it."""

import math
from fractions import Fraction

import pytest
from hypothesis import find, given
from hypothesis import strategies as st
from hypothesis.errors import NoSuchExample

import blossom
from blossom import Map, strategies
from blossom.testing import assert_exact, error_in_ulps

numpy = pytest.importorskip("numpy")
interpolate = pytest.importorskip("scipy.interpolate")


@given(st.floats(-1e300, 1e300), st.integers(-3, 3))
def test_ulps_are_steps_between_doubles(number, steps):
    other = number
    for _ in range(abs(steps)):
        other = math.nextafter(other, math.copysign(math.inf, steps))
    if not math.isinf(other) and math.frexp(other)[1] == math.frexp(number)[1]:
        assert error_in_ulps(other, Fraction(number)) == abs(steps)


def test_what_assert_exact_says():
    assert_exact(1 / 3, Fraction(1, 3), ulps="1/2")
    assert_exact(numpy.array([[0.5, 1.0]]), [[Fraction(1, 2), 1]], ulps=0)
    for actual, expected, message in [
        ([1.0, 2.0], [1, 3], r"at \[1\]: 2.0 is 2.25e\+15 ulps from 3, whose nearest double is 3.0"),
        ([1.0], [1, 3], "the shapes differ"),
        (1.0, [1], "the shapes differ"),
        ([[math.nan]], [[1]], r"at \[0\]\[0\]: nan is no number"),
        (math.inf, Fraction(1), "inf is no number"),
        (math.nextafter(1.0, 2.0), 1, "1.0000000000000002 is 1 ulps from 1"),
    ]:
        with pytest.raises(AssertionError, match=message):
            assert_exact(actual, expected, ulps="1/2")


def found(strategy, condition):
    try:
        return find(strategy, condition)
    except NoSuchExample:
        return None


def test_the_strategies_reach_their_corners():
    bsplines = strategies.bsplines()
    assert found(bsplines, lambda s: any(s.knots.count(k) > 1 for k in s.knots[s.degree + 1 : -s.degree - 1]))
    assert found(bsplines, lambda s: len(s.points) == s.degree + 1)
    assert found(strategies.intervals(), lambda ends: ends[0] > ends[1])
    assert found(strategies.beziers(), lambda b: len(set(b.points)) < len(b.points))
    assert found(strategies.polynomials(), lambda p: not any(p.coefficients))
    assert found(strategies.nurbs(), lambda n: len(set(n.weights)) > 1)
    assert found(strategies.patches(), lambda p: p.degrees[0] != p.degrees[1])


@given(strategies.curves(dimension=2), strategies.fractions())
def test_curves_are_graphs_of_themselves(curve, t):
    a, b = strategies.domain(curve)
    t = a + (b - a) * (t % 1)
    assert curve.graph()(t) == (t, *curve(t))


# SciPy: B-splines whose numbers are doubles, so that what SciPy is given is exact.
doubles = st.integers(-64, 64).map(lambda n: Fraction(n, 8))
splines = strategies.bsplines(numbers=doubles, max_degree=3)


@given(splines, st.fractions(0, 1, max_denominator=32).filter(lambda t: t.denominator & (t.denominator - 1) == 0))
def test_scipy_inserts_knots(spline, fraction):
    """The coefficients are right but for rounding: a relative error of a few units of the largest."""
    a, b = strategies.domain(spline)
    t = a + (b - a) * fraction
    if not a < t < b or spline.knots.count(t) > spline.degree or Fraction(float(t)) != t:
        return
    inserted = interpolate.insert(float(t), (*spline.to_scipy().tck[:2], spline.degree))
    exact = spline.insert_knots([t])
    assert_exact(inserted[0], exact.knots, ulps=0)
    largest = max(map(abs, exact.points)) or 1
    for got, wanted in zip(inserted[1], exact.points):
        assert abs(Fraction(got) - wanted) <= 16 * blossom.ulp(largest)


def test_the_oracle_sees_the_rounding_of_scipy():
    """insert loses most digits of a coefficient that is a small difference of large ones."""
    knots, points = [0, 0, 0, 0, 1, 1, 1, 1], [1, -0.7, 0.4, 0.1]
    t = 0.7
    exact = Map.from_scipy((knots, points, 3)).insert_knots([Fraction(t)])
    inserted = interpolate.insert(t, (numpy.array(knots, float), numpy.array(points + [0] * 4), 3))
    worst = max(error_in_ulps(got, wanted) for got, wanted in zip(inserted[1], exact.points))
    assert worst > 0
    with pytest.raises(AssertionError):
        assert_exact(inserted[1][: len(exact.points)], exact.points, ulps=worst / 2)


def test_the_oracle_sees_how_interpolation_loses_digits():
    """make_interp_spline on nodes that lie close together: exact coefficients say how many digits are right."""
    nodes = numpy.array([0.0, 1e-6, 2e-6, 3e-6, 0.5, 0.75, 1.0 - 1e-6, 1.0])
    values = numpy.array([0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0])
    made = interpolate.make_interp_spline(nodes, values, k=5)
    exact = blossom.interpolate(values=values, nodes=nodes, knots=made.t, degree=5, floats="double")
    assert [exact(Fraction(node)) for node in nodes] == values.tolist()
    worst = max(error_in_ulps(got, wanted) for got, wanted in zip(made.c, exact.points) if wanted)
    assert worst > 1_000_000
    with pytest.raises(AssertionError, match="ulps from"):
        assert_exact(made.c, exact.points, ulps=1_000_000)
