"""Maps from and to other libraries."""

from __future__ import annotations


from . import _engine


def _plain(values):
    """Arrays and lists of any kind as lists."""
    if hasattr(values, "tolist"):
        return values.tolist()
    if isinstance(values, (list, tuple)):
        return [_plain(value) for value in values]
    return values


def _with_kind(kind, fields, floats):
    fields = {name: value for name, value in fields.items() if value is not None}
    return _engine.read_map({"kind": kind, **fields}, floats)


def _sympy_number(number):
    import sympy

    return sympy.Rational(number.numerator, number.denominator)


class Conversions:
    """What a map can be made of and turned into."""

    __slots__ = ()

    def _array_of_values(self, parameters, is_curve, keywords):
        """The values at the parameters of a numpy array, as an array of Fractions of the same shape."""
        import numpy

        each = 1 if is_curve else parameters.shape[-1]
        shape = parameters.shape if is_curve else parameters.shape[:-1]
        flat = parameters.reshape(-1).tolist() if is_curve else parameters.reshape(-1, each).tolist()
        values = self._values(flat, keywords)
        result = numpy.array(values, dtype=object)
        return result.reshape(shape + result.shape[1:])

    @staticmethod
    def from_sympy(expression, *variables, degree=None, degrees=None):
        """A polynomial of SymPy, or a list of them, one for each coordinate, in the given symbols.

        >>> import sympy
        >>> from blossom import Map
        >>> t, x, y = sympy.symbols("t x y")
        >>> Map.from_sympy(1 + 2*t + t**2/3, t)
        Polynomial([1, 2, '1/3'])
        >>> Map.from_sympy([x*y, x + 1], x, y)(2, 3)
        (Fraction(6, 1), Fraction(3, 1))
        """
        import sympy

        several = isinstance(expression, (list, tuple, sympy.MatrixBase))
        polynomials = [sympy.Poly(one, *variables) for one in (expression if several else [expression])]
        exponents = sorted({powers for one in polynomials for powers in one.monoms()} | {(0,) * len(variables)})

        def point(powers):
            values = [one.coeff_monomial(powers) for one in polynomials]
            for value in values:
                if not value.is_Rational:
                    raise ValueError(f"the coefficient {value} is not a rational number")
            return values if several else values[0]

        if len(variables) == 1:
            count = exponents[-1][0] + 1
            fields = {"coefficients": [point((k,)) for k in range(count)], "degree": degree}
            return _with_kind("polynomial", fields, None)
        names = [str(variable) for variable in variables]
        terms = [[list(powers), point(powers)] for powers in exponents]
        return _with_kind("polynomial", {"variables": names, "terms": terms, "degree": degree, "degrees": degrees}, None)

    def to_sympy(self, *variables):
        """The map as an expression of SymPy in these symbols, or a tuple of one for each coordinate.

        >>> import sympy
        >>> from blossom import Bezier
        >>> Bezier([0, 0, 1]).to_sympy(sympy.Symbol("t"))
        t**2
        """
        import sympy

        monomials = self if self.kind == "polynomial" else self.convert(to="monomial")
        fields = monomials._fields
        if "denominator" in fields or "homogeneous" in fields:
            raise ValueError("a rational map is not a polynomial")
        terms = fields.get("terms") or [((k,), c) for k, c in enumerate(fields["coefficients"])]
        if not variables:
            variables = sympy.symbols(list(fields.get("variables", ["t"])))
        scalar = not isinstance(terms[0][1], tuple)
        sums = [0] * (1 if scalar else len(terms[0][1]))
        for powers, coefficient in terms:
            product = sympy.Mul(*(variable**power for variable, power in zip(variables, powers)))
            for i, number in enumerate([coefficient] if scalar else coefficient):
                sums[i] += _sympy_number(number) * product
        return sums[0] if scalar else tuple(sums)

    def blossom_to_sympy(self, *symbols):
        """The blossom as an expression of SymPy in one symbol per argument, by default u1, u2, ...

        >>> from blossom import Polynomial
        >>> Polynomial("t^2 + t").blossom_to_sympy()
        u1*u2 + u1/2 + u2/2
        """
        import sympy

        proof = self.agree()
        if not proof:
            raise ArithmeticError("the constructions of the blossom disagree")
        texts = proof.expansion
        count = proof["degree"] if "degree" in proof else sum(proof["degrees"])
        if len(symbols) not in (0, count):
            raise ValueError(f"the blossom has {count} arguments, not {len(symbols)}")
        names = [f"u{i + 1}" for i in range(count)]
        if not symbols:
            symbols = sympy.symbols(names)

        def expression(text):
            if not names:
                return _sympy_number(_engine.fraction(text, None))
            return _with_kind("polynomial", {"text": text, "variables": names}, None).to_sympy(*symbols)

        return expression(texts) if isinstance(texts, str) else tuple(map(expression, texts))

    @staticmethod
    def from_scipy(spline, floats="double"):
        """A BSpline of SciPy, or its tuple (t, c, k), with the exact values of its doubles.

        >>> from scipy.interpolate import BSpline
        >>> from blossom import Map
        >>> Map.from_scipy(BSpline([0, 0, 1, 2, 2], [0, 0.5, 2], 1))
        BSpline([0, 0, 1, 2, 2], [0, '1/2', 2], 1)
        """
        t, c, k = (spline.t, spline.c, spline.k) if hasattr(spline, "t") else spline
        knots, points, degree = _plain(t), _plain(c), int(k)
        if isinstance(c, (list, tuple)) and points and isinstance(points[0], list):
            points = [list(point) for point in zip(*points)]  # splprep has one list per coordinate
        fields = {"knots": knots, "control_points": points[: len(knots) - degree - 1], "degree": degree}
        return _with_kind("bspline", fields, floats)

    def to_scipy(self):
        """The spline as a BSpline of SciPy, with correctly rounded numbers."""
        from scipy.interpolate import BSpline

        from ._numbers import array

        if self.kind != "bspline" or "degrees" in self._fields or "weights" in self._fields:
            return self.convert(to="bspline").to_scipy() if self.kind != "bspline" else _refuse_weights()
        knots = self.knots
        if len(knots) == len(self.points) + self.degree - 1:
            knots = (knots[0], *knots, knots[-1])  # SciPy has the outer knots, on which nothing depends
        return BSpline(array(knots), array(self.points), self.degree)

    @staticmethod
    def from_geomdl(shape, floats="double"):
        """A curve or surface of geomdl, with the exact values of its doubles."""
        if hasattr(shape, "degree_u"):
            net = _plain(shape.ctrlpts2d)
            fields = {
                "degrees": [shape.degree_u, shape.degree_v],
                "knots": [_plain(shape.knotvector_u), _plain(shape.knotvector_v)],
                "control_net": net,
                "homogeneous": True if getattr(shape, "rational", False) else None,
            }
            return _with_kind("bspline", fields, floats)
        rational = getattr(shape, "rational", False)
        fields = {
            "degree": shape.degree,
            "knots": _plain(shape.knotvector),
            "control_points": _plain(shape.ctrlpts),
            "weights": _plain(shape.weights) if rational else None,
        }
        return _with_kind("bspline", fields, floats)

    @staticmethod
    def from_splinepy(shape, floats="double"):
        """A Bezier shape, a B-spline or a NURBS of splinepy, with the exact values of its doubles.

        splinepy lists the control points of a patch with the first direction running fastest.
        """
        degrees = [int(degree) for degree in _plain(shape.degrees)]
        points = _plain(shape.control_points)
        weights = getattr(shape, "weights", None)
        weights = None if weights is None else [w[0] if isinstance(w, list) else w for w in _plain(weights)]
        knots = getattr(shape, "knot_vectors", None)
        knots = None if knots is None else [_plain(list(vector)) for vector in knots]
        if len(degrees) == 1:
            fields = {"degree": degrees[0], "control_points": points, "weights": weights}
            if knots is None:
                return _with_kind("bezier", fields, floats)
            return _with_kind("bspline", {**fields, "knots": knots[0]}, floats)
        counts = [n + 1 for n in degrees] if knots is None else [
            len(vector) - n - 1 for vector, n in zip(knots, degrees)
        ]  # fmt: skip
        fields = {
            "degrees": degrees,
            "control_net": _net(points, counts),
            "weights": None if weights is None else _net(weights, counts),
        }
        if knots is None:
            return _with_kind("tensor", fields, floats)
        return _with_kind("bspline", {**fields, "knots": knots}, floats)


def _net(values, counts):
    """A list with the first direction running fastest as nested lists, the first direction outside."""
    if len(counts) == 1:
        return list(values)
    return [_net(values[i :: counts[0]], counts[1:]) for i in range(counts[0])]


def _refuse_weights():
    raise ValueError("SciPy has no rational splines, and only curves are converted")
