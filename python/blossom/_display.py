"""How maps are shown in a notebook, and plotted."""

from __future__ import annotations

import re

from . import _engine


def _latex(text: str) -> str:
    text = re.sub(r"(\d+)/(\d+)", r"\\frac{\1}{\2}", text)
    text = re.sub(r"\^(\d+)", r"^{\1}", text)
    return text.replace("*", r"\,")


class Display:
    """Representations for Jupyter."""

    __slots__ = ()

    def _repr_latex_(self):
        if self.kind != "polynomial":
            return None
        return f"${_latex(str(self).split(', formal degree')[0])}$"

    def _repr_svg_(self):
        """The picture that the program draws; None where there is none."""
        try:
            return _engine.shown("evaluate", {"map": self, "at": []}, None, True) or None
        except ValueError:
            return None

    def worked(self, operation, *, format="html", **fields):
        """The request worked out step by step: a page in a notebook, and a text when printed.

        >>> from blossom import Polynomial
        >>> print(str(Polynomial("t^2").worked("evaluate", at=[3], format="text")).splitlines()[0])
        Evaluation by de Casteljau's algorithm
        """
        from . import _operations

        op = _operations.BY_NAME[operation.replace("_", "-")]
        request, floats, limits = op.request(self, (), fields)
        request["op"] = op.name
        return _operations.BY_NAME["explain"].call(None, (request,), {"format": format, "floats": floats, "limits": limits})

    def plot(self, ax=None, count=200, points=True, **style):
        """Draws the map with matplotlib, into the axes `ax` or those in use: a curve with its control polygon, or a surface.

        `count` parameters are spread over the domain. The values are exact and then rounded.
        """
        if ax is None:
            from matplotlib import pyplot

            ax = pyplot.gca()
        from ._numbers import floats

        parameters = [self._parameters_of_domain(direction, count) for direction in self._domain(count)]
        if len(parameters) == 2:
            return self._plot_surface(ax, parameters, style)
        (parameters,) = parameters
        values = self(parameters)
        scalar = not isinstance(values[0], tuple)
        columns = [parameters, values] if scalar else zip(*values)
        drawn = ax.plot(*[floats(list(column)) for column in columns], **style)
        fields = self._fields
        if points and not scalar and "control_points" in fields and "homogeneous" not in fields:
            ax.plot(*[floats(list(column)) for column in zip(*fields["control_points"])], "o--", linewidth=0.5)
        return drawn

    def _plot_surface(self, ax, parameters, style):
        import numpy

        grid = [[(u, v) for v in parameters[1][::10]] for u in parameters[0][::10]]
        values = [self(row) for row in grid]
        if not isinstance(values[0][0], tuple):
            values = [[(*place, value) for place, value in zip(row, line)] for row, line in zip(grid, values)]
        from ._numbers import floats

        return ax.plot_surface(*numpy.moveaxis(numpy.array(floats(values)), 2, 0), **style)

    def _domain(self, count):
        """One interval per direction."""
        fields = self._fields
        if "intervals" in fields:
            return fields["intervals"]
        if "degrees" in fields and "knots" in fields:
            return [
                _spline_domain(knots, degree, size)
                for knots, degree, size in zip(fields["knots"], fields["degrees"], _net_shape(fields["control_net"]))
            ]
        if "knots" in fields and self.kind == "bspline":
            return [_spline_domain(fields["knots"], fields["degree"], len(fields["control_points"]))]
        if "variables" in fields:
            return [(0, 1) for _ in fields["variables"]]
        if self.kind == "simplex":
            raise ValueError("a map on a simplex is not plotted")
        return [fields.get("interval", (0, 1))]

    @staticmethod
    def _parameters_of_domain(interval, count):
        from fractions import Fraction

        a, b = interval
        return [a + (b - a) * Fraction(k, count) for k in range(count + 1)]


def _spline_domain(knots, degree, points):
    textbook = len(knots) == points + degree + 1
    return (knots[degree], knots[-degree - 1]) if textbook else (knots[degree - 1], knots[-degree])


def _net_shape(net):
    shape = []
    while isinstance(net, tuple):
        shape.append(len(net))
        net = net[0]
    return shape
