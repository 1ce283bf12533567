"""The classes of maps."""

from __future__ import annotations

import inspect
from fractions import Fraction
from types import MappingProxyType

from . import _engine, _operations
from ._arithmetic import Arithmetic
from ._conversions import Conversions
from ._display import Display

_KINDS = {kind["title"]: kind for kind in _engine.kinds()}


def _shown(value) -> str:
    """A number, or lists of numbers, as a call of the constructor has them."""
    if isinstance(value, Fraction):
        return str(value.numerator) if value.denominator == 1 else repr(str(value))
    if isinstance(value, (tuple, list)):
        return f"[{', '.join(map(_shown, value))}]"
    return repr(value)


def _restored(text: str) -> "Map":
    """A map that was pickled."""
    return _engine.map_of_text(text)


class Map(_engine.Map, Arithmetic, Display, Conversions):
    """A curve, a spline or a patch with exact numbers. It cannot be changed.

    A map is called with a parameter, ``p(t)``, a list of them, or of a patch with the coordinates of a point,
    ``p(u, v)``. ``p[1, 2, 3]`` is its blossom. The fields of its description are in ``p.fields``, and they are
    attributes where there is no method of the same name.

    Two maps are equal if their descriptions are: a curve and its control points are different objects.
    """

    __slots__ = ()
    kind = None
    _title = None
    _positional = ()

    def __new__(cls, *arguments, floats=None, **fields):
        if cls._title is None:
            if len(arguments) == 1 and isinstance(arguments[0], Map):
                return arguments[0]
            if len(arguments) == 1 and not fields:
                return _engine.read_map(arguments[0], floats)
            raise TypeError("Map() takes a dictionary as the protocol has it, or a map")
        if len(arguments) > len(cls._positional):
            raise TypeError(f"{cls.__name__}() takes at most {len(cls._positional)} positional arguments")
        for name, value in zip(cls._positional, arguments):
            if name in fields:
                raise TypeError(f"{cls.__name__}() got two values for {name}")
            fields[name] = value
        present = {name: value for name, value in fields.items() if value is not None}
        return _engine.Map.__new__(cls, {"kind": cls.kind, **cls._completed(present)}, floats)

    @classmethod
    def _completed(cls, fields: dict) -> dict:
        return fields

    @property
    def fields(self):
        """All fields of the map, read-only."""
        return MappingProxyType(self._fields)

    @property
    def points(self):
        """The control points or coefficients, the control net of a patch."""
        fields = self._fields
        for name in ("control_points", "control_net", "coefficients", "terms", "values"):
            if name in fields:
                return fields[name]
        raise AttributeError(f"a map of kind {self.kind} has no points")

    def __getattr__(self, name):
        if not name.startswith("_"):
            fields = self._fields
            if name in fields:
                return fields[name]
        raise AttributeError(f"{type(self).__name__} has no attribute {name}")

    def __dir__(self):
        return [*super().__dir__(), *self._fields]

    def _evaluated(self, *parameters, **keywords):
        """The value at a parameter of any form, or the values at a list of them."""
        if not parameters:
            raise TypeError("a parameter is needed")
        is_curve = "degrees" not in self._fields and "variables" not in self._fields and self.kind != "simplex"
        if len(parameters) > 1:
            if is_curve:
                raise TypeError("the parameter of a curve is one number; several are given as a list")
            return self._values([parameters], keywords)[0]
        (parameter,) = parameters
        if hasattr(parameter, "dtype") and getattr(parameter, "ndim", 0) > 0:
            return self._array_of_values(parameter, is_curve, keywords)
        if not hasattr(parameter, "__iter__") or isinstance(parameter, str):
            return self._values([parameter], keywords)[0]
        parameter = list(parameter)
        one_point = not is_curve and not any(
            hasattr(element, "__iter__") and not isinstance(element, str) for element in parameter
        )
        if one_point and parameter:
            return self._values([parameter], keywords)[0]
        return list(self._values(parameter, keywords))

    def _values(self, parameters, keywords):
        if not keywords:
            values = _engine.values_of_map(self, parameters)
            if values is not None:
                return values
        return _operations.BY_NAME["evaluate"].call(self, (parameters,), dict(keywords))

    __iter__ = None  # p[0], p[1], ... are values of a blossom, not elements

    def __repr__(self):
        fields = dict(self._fields)
        fields.pop("kind")
        positional = []
        for name in self._positional:
            if name not in fields:
                break
            positional.append(fields.pop(name))
        if "degree" in fields and fields["degree"] == self._plain_degree():
            del fields["degree"]
        shown = [_shown(value) for value in positional]
        shown += [f"{name}={_shown(value)}" for name, value in fields.items()]
        return f"{type(self).__name__}({', '.join(shown)})"

    def _plain_degree(self):
        """The degree that the constructor assumes where none is given."""
        return None

    def __str__(self):
        return _engine.description_of_map(self)

    def __reduce__(self):
        return _restored, (_engine.text_of_map(self),)

    def __copy__(self):
        return self

    def __deepcopy__(self, memo):
        return self

    def to_dict(self) -> dict:
        """The description of the map in the form of the protocol, with numbers as Fractions."""
        return dict(self._fields)

    def to_json(self) -> str:
        """The map as the protocol writes it.

        >>> import blossom
        >>> blossom.Bezier([0, "1/2"]).to_json()
        '{"kind": "bezier", "degree": 1, "interval": ["0", "1"], "control_points": ["0", "1/2"]}'
        """
        return _engine.text_of_map(self)

    @staticmethod
    def from_json(text: str) -> "Map":
        """The map that a JSON text describes; `Map` itself takes a dictionary."""
        return _engine.map_of_text(text)


_operations.add_methods(Map)


class _Counted:
    """A curve whose degree is one less than the number of its points."""

    __slots__ = ()

    def _plain_degree(self):
        return len(self.points) - 1


class Polynomial(_Counted, Map):
    """A polynomial curve: a text such as "1 + 2t - t^3/4", or its coefficients, lowest power first.

    >>> from blossom import Polynomial, delta
    >>> p = Polynomial("1 + 2t + 4t^2 - t^3")
    >>> p("1/2")
    Fraction(23, 8)
    >>> p[1, 2, 3]
    Fraction(41, 3)
    >>> p.blossom(1, 2, delta)
    Fraction(8, 3)
    >>> p.control_points(interval=[0, 2])
    Bezier([1, '7/3', 9, 13], [0, 2])
    """

    __slots__ = ()
    _positional = ("coefficients",)

    def _plain_degree(self):
        zero = [point if isinstance(point, tuple) else (point,) for point in self.coefficients]
        zero += [(number,) for number in self._fields.get("denominator", ())]
        powers = [k % len(self.coefficients) for k, point in enumerate(zero) if any(point)]
        return max(powers, default=0)

    @classmethod
    def _completed(cls, fields):
        written = fields.get("coefficients")
        texts = isinstance(written, str) or (
            isinstance(written, (list, tuple)) and any(_is_polynomial_text(element) for element in written)
        )
        if texts:
            fields["text"] = fields.pop("coefficients")
        return fields


def _is_polynomial_text(value) -> bool:
    """Whether a text is a polynomial with a variable, and no number: 1e5 is a number, 1t5 is not."""
    if not isinstance(value, str):
        return False
    try:
        _engine.fraction(value, None)
    except ValueError:
        return True
    return False


class Bezier(_Counted, Map):
    """A polynomial curve by its control points; with ``weights`` a rational one.

    >>> from blossom import Bezier
    >>> curve = Bezier([[0, 0], [1, 2], [3, 0]])
    >>> curve("1/2")
    (Fraction(5, 4), Fraction(1, 1))
    >>> left, right = curve.subdivide("1/2")
    >>> left(curve.interval[0]) == curve(0)
    True
    """

    __slots__ = ()
    _positional = ("control_points", "interval")

    def __repr__(self):
        text = super().__repr__()
        return text.replace(", interval=[0, 1]", "").replace("], [0, 1])", "])")


class Taylor(_Counted, Map):
    """A polynomial curve by its expansion at ``center``."""

    __slots__ = ()
    _positional = ("coefficients", "center")


class BSpline(Map):
    """A B-spline curve by knots, control points and degree, in the order of SciPy's t, c and k.

    >>> from blossom import BSpline
    >>> spline = BSpline([0, 0, 0, 1, 2, 2, 2], [0, 1, 3, 2], 2)
    >>> spline("3/2"), spline.segments()[0]
    (Fraction(5, 2), Bezier([0, 1, 2]))
    """

    __slots__ = ()
    _positional = ("knots", "control_points", "degree")


class Nurbs(BSpline):
    """A rational B-spline curve, with one weight per control point.

    >>> from blossom import Nurbs
    >>> arc = Nurbs([0, 0, 0, 1, 1, 1], [[1, 0], [1, 1], [0, 1]], 2, [1, 1, 2])
    >>> x, y = arc("1/2")
    >>> x*x + y*y
    Fraction(1, 1)
    """

    __slots__ = ()
    _positional = ("knots", "control_points", "degree", "weights")


class Progressive(_Counted, Map):
    """One polynomial by blossom values at consecutive knots."""

    __slots__ = ()
    _positional = ("knots", "control_points")


class Hermite(Map):
    """A polynomial curve by its value and derivatives at both ends of an interval."""

    __slots__ = ()
    _positional = ("left", "right", "interval")


class Samples(Map):
    """A map that is known only by values: pairs of a parameter and a point."""

    __slots__ = ()
    _positional = ("values", "degree", "interval")


class PolynomialPatch(Map):
    """A polynomial in several variables: a text and the names of its variables.

    With ``degrees``, one for each variable, it is a tensor product.

    >>> from blossom import PolynomialPatch
    >>> p = PolynomialPatch("x^2 + 3x*y - 2", ["x", "y"])
    >>> p(1, 2), p[[1, 2], [1, 2]]
    (Fraction(5, 1), Fraction(5, 1))
    """

    __slots__ = ()
    _positional = ("text", "variables")

    @classmethod
    def _completed(cls, fields):
        if isinstance(fields.get("variables"), str):
            fields["variables"] = fields["variables"].replace(",", " ").split()
        return fields


class Patch(Map):
    """A control net over a box, with one list of points per direction.

    >>> from blossom import Patch
    >>> patch = Patch([[0, 1], [2, 0], [1, 3]])
    >>> patch.degrees, patch("1/2", "1/2")
    ((2, 1), Fraction(9, 8))
    """

    __slots__ = ()
    _positional = ("control_net", "degrees", "intervals")

    @classmethod
    def _completed(cls, fields):
        net = fields.get("control_net")
        if "degrees" not in fields and isinstance(net, (list, tuple)):
            # Without degrees there are two directions, the usual case.
            fields["degrees"] = [len(net) - 1, len(net[0]) - 1]
        return fields


class Simplex(Map):
    """A control net over a triangle, a tetrahedron, or any simplex: pairs of an index and its point.

    >>> from blossom import Simplex
    >>> triangle = Simplex([[[1, 0, 0], 0], [[0, 1, 0], 4], [[0, 0, 1], 8]], vertices=[[0, 0], [1, 0], [0, 1]])
    >>> triangle.degree, triangle("1/4", "1/2")
    (1, Fraction(5, 1))
    """

    __slots__ = ()
    _positional = ("control_net", "degree", "vertices")

    @classmethod
    def _completed(cls, fields):
        net = fields.get("control_net")
        if isinstance(net, dict):
            net = fields["control_net"] = [[list(index), point] for index, point in net.items()]
        if "degree" not in fields and isinstance(net, (list, tuple)) and net:
            fields["degree"] = sum(net[0][0])
        return fields


class BSplinePatch(Map):
    """A tensor product of B-splines: knots and a degree per direction, and a control net."""

    __slots__ = ()
    _positional = ("knots", "control_net", "degrees")


class NurbsPatch(BSplinePatch):
    """A rational tensor product of B-splines."""

    __slots__ = ()
    _positional = ("knots", "control_net", "degrees", "weights")


_CLASSES = {
    "polynomial": Polynomial,
    "bezier": Bezier,
    "taylor": Taylor,
    "bspline": BSpline,
    "bspline rational": Nurbs,
    "progressive": Progressive,
    "hermite": Hermite,
    "samples": Samples,
    "polynomial with variables": PolynomialPatch,
    "tensor": Patch,
    "simplex": Simplex,
    "bspline with degrees": BSplinePatch,
    "bspline with degrees rational": NurbsPatch,
}


def _described(cls, title: str) -> None:
    """Completes a class by what its kind says of itself."""
    kind = _KINDS[title.removesuffix(" rational")]
    cls.kind, cls._title = kind["word"], title
    names = [field["name"] for field in kind["fields"]]
    fields = [f"{f['name']} : {f['kind']}\n    {f['documentation']}" for f in kind["fields"]]
    cls.__doc__ = inspect.cleandoc(cls.__doc__ or kind["documentation"]) + "\n\nFields\n------\n" + "\n".join(fields)
    kinds = inspect.Parameter
    positional = [kinds(name, kinds.POSITIONAL_OR_KEYWORD, default=None) for name in cls._positional]
    others = [kinds(name, kinds.KEYWORD_ONLY, default=None) for name in [*names, "floats"] if name not in cls._positional]
    cls.__signature__ = inspect.Signature(positional + others)


def _new_class(title: str):
    """A class for a kind that has none above."""
    kind = _KINDS[title]
    positional = tuple(field["name"] for field in kind["fields"] if field["presence"] == "yes")
    name = title.title().replace(" ", "")
    return type(name, (Map,), {"__slots__": (), "_positional": positional, "__module__": __name__})


for _title in _KINDS:
    if _title not in _CLASSES:
        _CLASSES[_title] = _new_class(_title)
for _title, _class in _CLASSES.items():
    _described(_class, _title)
_engine.set_map_classes(_CLASSES)

CLASSES = {cls.__name__: cls for cls in _CLASSES.values()}
