"""Maps as objects: what they compute, and that they are values."""

import copy
import pickle
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import blossom
from blossom import strategies
from blossom import (
    Bezier, BSpline, BSplinePatch, Hermite, Map, Nurbs, NurbsPatch, Patch, Polynomial, PolynomialPatch, Progressive,
    Samples, Simplex, Taylor, Vector, Weighted, delta,
)  # fmt: skip

import reference

numbers = st.fractions(-20, 20, max_denominator=50)
lists = st.lists(numbers, min_size=1, max_size=8)

EXAMPLES = [
    Polynomial("1 + 2t + 4t^2 - t^3"),
    Polynomial(["t", "t^2 - 1/2"], degree=4),
    Polynomial(["1 - t^2", "2t"], denominator="1 + t^2"),
    Bezier([0, "1/3", 1], [1, 3]),
    Bezier([[0, 0], [1, 2]], weights=[1, 2]),
    Bezier([[0, 0, 1], [1, 2, 0]], homogeneous=True),
    Taylor([1, 2, 3], "1/2"),
    BSpline([0, 0, 0, 1, 2, 2, 2], [0, 1, 3, 2], 2),
    Nurbs([0, 0, 0, 1, 1, 1], [[1, 0], [1, 1], [0, 1]], 2, [1, 1, 2]),
    Progressive([0, 1, 2, 3], [1, 2, 5]),
    Hermite([[0, 0], [1, 3]], [[1, 0], [1, -3]]),
    Samples([[0, 1], [1, 2]], 1),
    PolynomialPatch("x^2 + 3x*y - 2", "x, y"),
    PolynomialPatch("u^2*v + 1/2v", ["u", "v"], degrees=[2, 1]),
    Patch([[0, 1], [2, 0], [1, 3]]),
    Patch([[[0, 0, 1], [0, 1, 0]], [[1, 0, 0], [1, 1, 2]]], intervals=[[0, 2], [1, 3]], weights=[[1, 2], [3, 4]]),
    Simplex({(2, 0, 0): 0, (1, 1, 0): 0, (1, 0, 1): 1, (0, 2, 0): 2, (0, 1, 1): 0, (0, 0, 2): 0}),
    BSplinePatch([[0, 0, 1, 1], [0, 0, 1, 2, 2]], [[0, 1, 2], [3, 4, 5]], [1, 1]),
    NurbsPatch([[0, 0, 1, 1], [0, 0, 1, 1]], [[0, 1], [3, 4]], [1, 1], [[1, 2], [1, 1]]),
]


@given(lists, numbers)
def test_values_of_polynomials(coefficients, t):
    p = Polynomial(coefficients)
    assert p(t) == reference.value(coefficients, t)
    assert p.evaluate([t]) == (p(t),)
    assert p([t, t]) == [p(t), p(t)]


@settings(deadline=None)
@given(st.lists(numbers, min_size=1, max_size=7), st.data())
def test_blossoms_of_polynomials(coefficients, data):
    n = len(coefficients) - 1
    p = Polynomial(coefficients, degree=n)
    pairs = data.draw(st.lists(st.tuples(numbers, st.sampled_from([0, 1, Fraction(2, 3)])), min_size=n, max_size=n))
    arguments = tuple(u if mass == 1 else Vector(u) if mass == 0 else Weighted(u, mass) for u, mass in pairs)
    expected = reference.blossom(coefficients, pairs)
    assert p[arguments] == expected
    assert p.blossom(*arguments) == expected
    assert p[arguments] == expected  # prepared
    for construction in ("symmetric", "polarization", "casteljau"):
        assert p.blossom(*arguments, construction=construction) == expected


@given(st.lists(numbers, min_size=1, max_size=7), numbers)
def test_values_of_bezier_curves(points, t):
    curve = Bezier(points, [1, 3])
    assert curve(t) == reference.de_casteljau(points, t, 1, 3)
    left, right = curve.subdivide(2)
    assert left(2) == right(2) == curve(2)
    assert curve.elevate(by=2)(t) == curve(t)


@settings(deadline=None)
@given(st.data())
def test_values_of_splines(data):
    degree = data.draw(st.integers(1, 3))
    inner = data.draw(st.lists(st.fractions(1, 9, max_denominator=4), max_size=4, unique=True))
    knots = [Fraction(0)] * (degree + 1) + sorted(inner) + [Fraction(10)] * (degree + 1)
    points = data.draw(st.lists(numbers, min_size=len(knots) - degree - 1, max_size=len(knots) - degree - 1))
    spline = BSpline(knots, points, degree)
    for t in data.draw(st.lists(st.fractions(0, "299/30", max_denominator=30), min_size=1, max_size=12)):
        assert spline(t) == reference.spline(knots, points, degree, t)
    assert spline([0, 1, 2]) == [spline(0), spline(1), spline(2)]


def test_agreement_has_the_three_values():
    p = Polynomial("1 + 2t + 4t^2 - t^3")
    proof = p.agree(1, 2, 3)
    assert proof and proof.agree is True
    assert set(proof["values"].values()) == {Fraction(41, 3)} and len(proof["values"]) >= 3
    for_all = p.agree()
    assert for_all and for_all.for_all_arguments
    assert "The three constructions agree exactly, for all arguments." in str(for_all)


def test_the_blossom_of_patches():
    p = PolynomialPatch("x^2 + 3x*y - 2", "x y")
    assert p[[1, 2], Vector([3, -1])] == Fraction(21, 2)
    assert p((1, 2)) == p([1, 2]) == p(1, 2) == 5
    assert p([[1, 2], [0, 0]]) == [5, -2]
    tensor = PolynomialPatch("u^2*v + 1/2v", ["u", "v"], degrees=[2, 1])
    assert tensor[[1, 3], [delta]] == Fraction(7, 2)
    simplex = EXAMPLES[16]
    assert simplex("1/3", "1/3", "1/3") == Fraction(4, 9)


def test_vectors_of_rational_curves_are_refused():
    arc = Bezier([[0, 0], [1, 2]], weights=[1, 2])
    with pytest.raises(blossom.Error) as caught:
        arc[delta]
    assert caught.value.code == "zero_weight"
    assert arc["1/2"] == arc("1/2")


@pytest.mark.parametrize("map_", EXAMPLES, ids=repr)
def test_maps_are_values(map_):
    again = pickle.loads(pickle.dumps(map_))
    assert again == map_ and hash(again) == hash(map_) and type(again) is type(map_)
    assert copy.copy(map_) == map_ and copy.deepcopy(map_) == map_
    assert Map.from_json(map_.to_json()) == map_
    assert Map(map_.to_dict()) == map_ and Map(map_) is map_
    assert eval(repr(map_)) == map_
    assert map_ != 1 and {map_: 1}[again] == 1
    assert str(map_) and map_.fields["kind"] == map_.kind
    with pytest.raises(AttributeError):
        map_.degree = 3
    with pytest.raises(TypeError):
        map_.fields["degree"] = 3
    with pytest.raises(TypeError):
        iter(map_)
    assert bool(map_)


def test_different_maps():
    assert len(set(EXAMPLES)) == len(EXAMPLES)
    assert Polynomial("t") != Polynomial("t", degree=2)
    assert Polynomial("t") != Bezier([0, 1])
    assert Polynomial("s") == Polynomial([0, 1])


def test_results_are_objects_of_their_kinds():
    p = Polynomial("1 + 2t + 4t^2 - t^3")
    assert type(p.control_points()) is Bezier
    assert type(p.derivative()) is Polynomial
    assert p.derivative(at=["1/2"], order=2) == (5,)
    assert p.convert(to="taylor", center=2) == Taylor([13, 6, -2, -1], 2)
    assert type(EXAMPLES[8].insert_knots(["1/2"])) is Nurbs
    assert all(type(part) is Bezier for part in EXAMPLES[7].segments())
    assert type(EXAMPLES[17].elevate(by=1)) is BSplinePatch
    assert blossom.interpolate(values=[0, 1, 3]).points == (0, Fraction(1, 2), 3)
    assert type(blossom.join([Bezier([0, 1, 4]), Bezier([4, 7, 9], [1, 2])])) is BSpline


def test_fields_are_attributes():
    curve = Bezier([[0, 0], [1, "1/2"]], [1, 3])
    assert curve.degree == 1 and curve.interval == (1, 3)
    assert curve.points == ((0, 0), (1, Fraction(1, 2))) == curve.fields["control_points"]
    assert callable(curve.control_points)
    with pytest.raises(AttributeError):
        curve.knots


def test_wrong_calls():
    p = Polynomial("t^2")
    with pytest.raises(TypeError):
        p()
    with pytest.raises(TypeError):
        p(1, 2)
    with pytest.raises(TypeError):
        p.elevate(1, 2)
    with pytest.raises(TypeError):
        p.elevate(1, by=2)
    with pytest.raises(TypeError):
        Bezier([0, 1], [0, 1], [1, 1])
    with pytest.raises(TypeError):
        Bezier([0, 1], control_points=[0, 1])
    for call, code, place in [
        (lambda: p[1, 2, 3], "wrong_arity", ("arguments",)),
        (lambda: p.elevate(by=-1), "wrong_kind", ("by",)),
        (lambda: p.elevate(by=1, of=2), "unknown_field", ("of",)),
        (lambda: p.insert_knots([1]), "wrong_kind", ("map",)),
        (lambda: Bezier([0, 1], [1, 1]), "empty_interval", ("interval",)),
        (lambda: Bezier(points=[1]), "missing_field", ("control_points",)),
        (lambda: Map({"kind": "bezie"}), "wrong_kind", ("kind",)),
        (lambda: EXAMPLES[7](3), "outside_domain", ("at", 0)),
        (lambda: EXAMPLES[7]([0, 1, 3]), "outside_domain", ("at", 2)),
        (lambda: p(object()), "not_a_number", ("at", 0)),
        (lambda: p.evaluate({1: 2}), "wrong_kind", ("at",)),
    ]:
        with pytest.raises(blossom.Error) as caught:
            call()
        assert (caught.value.code, caught.value.place) == (code, place)
        again = pickle.loads(pickle.dumps(caught.value))
        assert (again.code, again.place, str(again)) == (code, place, str(caught.value))


def test_arguments_are_values():
    assert Vector(2) == Vector(Fraction(2)) and hash(Vector(2)) == hash(Vector(Fraction(2)))
    assert Vector(1) != Weighted(1, 0) and Weighted(1, 2) == pickle.loads(pickle.dumps(Weighted(1, 2)))
    assert repr(delta) == "Vector(1)"
    with pytest.raises(AttributeError):
        delta.value = 2


@given(strategies.polynomials(), strategies.polynomials(), numbers)
def test_arithmetic_of_polynomials(p, q, t):
    assert (p + q)(t) == p(t) + q(t) and (p - q)(t) == p(t) - q(t) and (p * q)(t) == p(t) * q(t)
    assert (-p)(t) == -p(t) and (p * 3)(t) == (3 * p)(t) == 3 * p(t) and (p / Fraction(2, 3))(t) == p(t) * Fraction(3, 2)
    if q(t):
        assert (p / q)(t) == p(t) / q(t)


def test_arithmetic_of_other_maps():
    curve = Bezier([[0, 1], [2, 3]])
    assert (curve @ curve)("1/2") == 5
    for wrong in (lambda: curve + 1, lambda: curve * [1], lambda: curve * "x", lambda: 1 / curve):
        with pytest.raises(TypeError):
            wrong()
    with pytest.raises(blossom.Error) as caught:
        curve * 0.5
    assert caught.value.code == "inexact_number"
    with pytest.raises(ZeroDivisionError):
        curve / 0
