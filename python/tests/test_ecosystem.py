"""SymPy, SciPy, numpy, matplotlib and the objects of other spline libraries."""

import subprocess
import sys
from fractions import Fraction
from types import SimpleNamespace

import pytest
from hypothesis import given

import blossom
from blossom import Bezier, BSpline, BSplinePatch, Map, Nurbs, NurbsPatch, Patch, Polynomial, PolynomialPatch, Simplex, strategies

sympy = pytest.importorskip("sympy")
numpy = pytest.importorskip("numpy")


@given(strategies.polynomials(), strategies.fractions())
def test_sympy_there_and_back(p, number):
    t = sympy.Symbol("t")
    expression = p.to_sympy(t)
    assert Map.from_sympy(expression, t)(number) == p(number)
    value = sympy.sympify(expression).subs(t, sympy.Rational(number.numerator, number.denominator))
    assert blossom.fraction(value) == p(number)


def test_sympy_in_several_variables_and_coordinates():
    x, y, t = sympy.symbols("x y t")
    p = Map.from_sympy(x**2 + 3 * x * y - 2, x, y)
    assert p == PolynomialPatch("x^2 + 3x*y - 2", "x y")
    assert sympy.expand(p.to_sympy(x, y) - (x**2 + 3 * x * y - 2)) == 0
    curve = Map.from_sympy([t, t**2 / 3], t, degree=3)
    assert curve.degree == 3 and curve(3) == (3, 3)
    assert curve.to_sympy(t) == (t, t**2 / 3)
    assert Map.from_sympy(sympy.Integer(2), t)(5) == 2
    assert Bezier([1, 2], [0, 2]).to_sympy(t) == t / 2 + 1
    with pytest.raises(ValueError):
        Map.from_sympy(sympy.sqrt(2) * t, t)
    with pytest.raises(ValueError):
        Bezier([1, 2], weights=[1, 2]).to_sympy(t)


def test_the_blossom_as_an_expression():
    u, v, w = sympy.symbols("u v w")
    t = sympy.Symbol("t")
    cubic = Polynomial("1 + 2t + 4t^2 - t^3")
    expression = cubic.blossom_to_sympy(u, v, w)
    # Symmetric, affine in each argument, and the polynomial on the diagonal.
    assert sympy.expand(expression.subs({u: v, v: u}, simultaneous=True) - expression) == 0
    assert sympy.diff(expression, u, 2) == 0
    assert sympy.expand(expression.subs({u: t, v: t, w: t}) - (1 + 2 * t + 4 * t**2 - t**3)) == 0
    assert expression.subs({u: 1, v: 2, w: 3}) == sympy.Rational(41, 3)
    assert Polynomial([3]).blossom_to_sympy() == 3
    assert len(Polynomial(["t", "t^2"]).blossom_to_sympy()) == 2
    with pytest.raises(ValueError):
        cubic.blossom_to_sympy(u, v)


def test_splines_of_scipy():
    interpolate = pytest.importorskip("scipy.interpolate")
    spline = interpolate.BSpline([0, 0, 0, 0.1, 1, 1, 1], [0, 0.3, 2, -1], 2)
    exact = Map.from_scipy(spline)
    assert type(exact) is BSpline and exact.knots[3] == Fraction(0.1)
    back = exact.to_scipy()
    assert back.t.tolist() == spline.t.tolist() and back.c.tolist() == spline.c.tolist() and back.k == 2
    audit = exact.audit(at=[0, Fraction(1, 2), 1], computed={"values": spline([0, 0.5, 1])})
    assert audit.numbers == 3 and audit.greatest_ulps < 10
    tck = interpolate.splrep([0, 1, 2, 3, 4], [0, 1, 4, 9, 16])
    assert len(Map.from_scipy(tck).points) == 5  # its coefficients end in zeros that are none
    curve, _ = interpolate.splprep([[0, 1, 2, 3], [0, 1, 0, 1]], s=0)
    assert len(Map.from_scipy(curve).points[0]) == 2
    assert BSpline([0, 1], [1, 2], 1).to_scipy()(0.5) == 1.5  # without the outer knots
    assert Bezier([0, 1], [0, 2]).to_scipy()(1.0) == 0.5
    with pytest.raises(ValueError):
        Nurbs([0, 0, 1, 1], [0, 1], 1, [1, 2]).to_scipy()


def test_objects_of_geomdl():
    curve = SimpleNamespace(degree=1, knotvector=[0.0, 0.0, 1.0, 1.0], ctrlpts=[[0.0, 1.0], [0.5, 2.0]], rational=False)
    assert Map.from_geomdl(curve) == BSpline([0, 0, 1, 1], [[0, 1], ["1/2", 2]], 1)
    curve.rational, curve.weights = True, [1.0, 0.5]
    assert Map.from_geomdl(curve) == Nurbs([0, 0, 1, 1], [[0, 1], ["1/2", 2]], 1, [1, "1/2"])
    surface = SimpleNamespace(
        degree_u=1, degree_v=1, knotvector_u=[0.0, 0.0, 1.0, 1.0], knotvector_v=[0.0, 0.0, 1.0, 1.0], rational=False,
        ctrlpts2d=[[[0.0, 0.0, 0.0], [0.0, 1.0, 1.0]], [[1.0, 0.0, 2.0], [1.0, 1.0, 5.0]]],
    )  # fmt: skip
    patch = Map.from_geomdl(surface)
    assert type(patch) is BSplinePatch and patch(1, 0) == (1, 0, 2)


def test_objects_of_splinepy():
    curve = SimpleNamespace(degrees=[1], control_points=numpy.array([[0.0, 1.0], [0.5, 2.0]]))
    assert Map.from_splinepy(curve) == Bezier([[0, 1], ["1/2", 2]])
    curve.knot_vectors = [[0.0, 0.0, 1.0, 1.0]]
    curve.weights = numpy.array([[1.0], [0.5]])
    assert Map.from_splinepy(curve) == Nurbs([0, 0, 1, 1], [[0, 1], ["1/2", 2]], 1, [1, "1/2"])
    points = [[x, y, 10 * x + y] for y in (0.0, 1.0) for x in (0.0, 1.0, 2.0)]  # the first direction is fastest
    surface = SimpleNamespace(degrees=[2, 1], control_points=points)
    patch = Map.from_splinepy(surface)
    assert type(patch) is Patch and patch(1, 0) == (2, 0, 20) and patch(0, 1) == (0, 1, 1)
    surface.knot_vectors = [[0, 0, 0, 1, 1, 1], [0, 0, 1, 1]]
    surface.weights = [[1.0]] * 6
    assert type(Map.from_splinepy(surface)) is NurbsPatch


MAPS = [
    Bezier([[0, 0], [1, 2], [3, 0]]),
    Polynomial("t^2 - 1/2t"),
    BSpline([0, 0, 0, 1, 2, 2, 2], [[0, 0], [1, 2], [3, 1], [4, 0]], 2),
    Patch([[[0, 0, 1], [0, 1, 0]], [[1, 0, 0], [1, 1, 2]]]),
    PolynomialPatch("x*y", "x y"),
    BSplinePatch([[0, 0, 1, 1], [0, 1]], [[0, 1], [3, 4]], [1, 1]),
]


@pytest.mark.parametrize("map_", MAPS, ids=repr)
def test_pictures(map_):
    assert map_._repr_svg_().startswith("<svg")


def test_formulas():
    assert Polynomial("1 - 1/2t^12")._repr_latex_() == r"$P(t) = 1 - \frac{1}{2} t^{12}$"
    assert PolynomialPatch("x*y^2", "x y")._repr_latex_() == r"$P(x, y) = x\,y^{2}$"
    assert MAPS[0]._repr_latex_() is None


def test_worked_examples():
    page = MAPS[0].worked("subdivide", at="1/2")
    assert page._repr_html_().startswith("<iframe srcdoc=\"&lt;!DOCTYPE html&gt;")
    assert page._repr_latex_() is None
    assert MAPS[0].worked("subdivide", at="1/2", format="markdown")._repr_markdown_() == MAPS[0].worked("subdivide", at="1/2", format="markdown").document
    assert "P(1/2)" in str(MAPS[1].worked("evaluate", at=["1/2"], format="text"))
    sheet = blossom.exercise("subdivision", count=1, format="html")
    assert "<iframe" in sheet._repr_html_()


class Axes:
    """Stands for matplotlib's axes and notes what is drawn."""

    def __init__(self):
        self.drawn = []

    def plot(self, *columns, **style):
        self.drawn.append(columns)
        return [self]

    def plot_surface(self, *grids, **style):
        self.drawn.append(grids)
        return self


def test_plots():
    for map_ in MAPS[:3]:
        axes = Axes()
        assert map_.plot(axes, count=10) == [axes]
        xs, ys = axes.drawn[0][:2]
        assert len(xs) == len(ys) == 11 and isinstance(xs[3], float)
    assert axes.drawn[1][0] == [0, 1, 3, 4]  # the control polygon
    for map_ in MAPS[3:]:
        axes = Axes()
        map_.plot(axes, count=20)
        assert [grid.shape for grid in axes.drawn[0]] == [(3, 3)] * 3
    with pytest.raises(ValueError):
        Simplex({(1, 0, 0): 0, (0, 1, 0): 1, (0, 0, 1): 2}).plot(Axes())


def test_plots_of_matplotlib():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("agg")
    from matplotlib import pyplot

    MAPS[0].plot()
    assert len(pyplot.gca().lines) == 2
    figure = pyplot.figure()
    MAPS[3].plot(figure.add_subplot(projection="3d"), count=20)
    pyplot.close("all")


def test_the_stubs_name_everything(tmp_path):
    subprocess.run([sys.executable, "-m", "blossom._stubs", str(tmp_path)], check=True)
    stub = (tmp_path / "__init__.pyi").read_text()
    for name in blossom.__all__:
        assert f"{name}" in stub
    for description in blossom._engine.operations():
        name = blossom._operations.python_name(description["name"])
        assert f"def {name}(" in stub
        assert f"def {name}(" in (tmp_path / "operations.pyi").read_text()
    compile(stub, "stub", "exec")
    compile((tmp_path / "operations.pyi").read_text(), "stub", "exec")


def test_the_stubs_suffice_for_a_checker(tmp_path):
    pytest.importorskip("mypy")
    program = tmp_path / "use.py"
    program.write_text(
        "import blossom\n"
        "from blossom import Map, Polynomial, delta\n"
        'p = Polynomial("t^2", degree=3)\n'
        "curve: Map = p.control_points(interval=[0, 1])\n"
        'parts: tuple[Map, ...] = curve.subdivide("1/2")\n'
        'value = p.blossom(1, 2, delta, construction="casteljau", timeout=1)\n'
        "agree: bool = bool(p.agree())\n"
    )
    package = tmp_path / "stubs" / "blossom"
    package.mkdir(parents=True)
    subprocess.run([sys.executable, "-m", "blossom._stubs", str(package)], check=True)
    (package / "py.typed").touch()

    def check():
        command = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(tmp_path / "cache"), str(program)]
        environment = {"MYPYPATH": str(package.parent), "PATH": "/usr/bin"}
        return subprocess.run(command, capture_output=True, text=True, env=environment)

    found = check()
    assert found.returncode == 0, found.stdout
    program.write_text(program.read_text() + "p.elevate(bye=1)\n")
    assert check().returncode == 1
