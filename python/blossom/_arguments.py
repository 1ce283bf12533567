"""The arguments of a blossom that are not points."""

from __future__ import annotations



class Vector:
    """A vector, which has mass 0 as an argument of a blossom: a number, or a list of numbers for a simplex.

    >>> from blossom import Polynomial, Vector, delta
    >>> Polynomial("t^3")[Vector(2), 1, 1]
    Fraction(2, 1)
    >>> delta == Vector(1)
    True
    """

    __slots__ = ("value",)

    def __init__(self, value):
        object.__setattr__(self, "value", tuple(value) if isinstance(value, list) else value)

    def __setattr__(self, name, value):
        raise AttributeError(f"a {type(self).__name__} cannot be changed")

    def _key(self):
        return (self.value,)

    def __eq__(self, other):
        return self._key() == other._key() if type(self) is type(other) else NotImplemented

    def __hash__(self):
        return hash((type(self).__name__, *self._key()))

    def __repr__(self):
        return f"{type(self).__name__}({', '.join(map(repr, self._key()))})"

    def __reduce__(self):
        return type(self), self._key()

    def __blossom__(self):
        return {"vector": self.value}


class Weighted(Vector):
    """The pair (u, mass), an argument of any mass.

    >>> from blossom import Polynomial, Weighted
    >>> Polynomial("t^2", degree=2)[Weighted(3, 2), 1]
    Fraction(3, 1)
    """

    __slots__ = ("mass",)

    def __init__(self, value, mass):
        super().__init__(value)
        object.__setattr__(self, "mass", mass)

    def _key(self):
        return (self.value, self.mass)

    def __blossom__(self):
        coordinates = self.value if isinstance(self.value, tuple) else (self.value,)
        return {"homogeneous": [*coordinates, self.mass]}


delta = Vector(1)
"""The unit vector, Goldman's delta: each of them among the arguments differentiates once."""
