"""Exact blossoms (polar forms) of polynomials, splines and patches.

>>> from blossom import Polynomial
>>> p = Polynomial("1 + 2t + 4t^2 - t^3")
>>> p[1, 2, 3]
Fraction(41, 3)

Numbers are exact: what comes out are Fractions, and what goes in are ints, Fractions, Decimals, numbers of
SymPy or texts such as "1/3" and "0.1". A float goes in with ``floats="double"``, as its exact value, or with
``floats="decimal"``, as the decimal that it prints.
"""

import builtins as _builtins
from fractions import Fraction

from . import _engine

from ._errors import Error, InternalError, LimitExceeded, make_error

_engine.set_error_type(make_error)

from ._arguments import Vector, Weighted, delta

_engine.set_vector_type(Vector)

from ._maps import CLASSES as _classes
from ._maps import Map
from ._numbers import array, floats, fraction, nearest_double, ulp
from ._results import Result
from . import _operations, operations

__version__ = _engine.__version__

globals().update(_classes)
#: The operations that need no map; the others are methods of maps, and all are in `blossom.operations`.
_functions = [o.python_name for o in _operations.ALL if not o.takes_map or o.map_may_be_absent]
globals().update({name: getattr(operations, name) for name in _functions})
# `from blossom import *` leaves the functions of Python, such as sum, as they are.
_exported = [name for name in _functions if not hasattr(_builtins, name)]

__all__ = [
    "Error", "Fraction", "InternalError", "LimitExceeded", "Map", "Result", "Vector", "Weighted", "answer",
    "array", "delta", "floats", "fraction", "nearest_double", "operations", "ulp", *_classes, *_exported,
]  # fmt: skip


def answer(request: dict, *, timeout=None, max_memory=None, max_work=None, limits=None) -> dict:
    """The response of the protocol to a request, errors included; exact numbers are Fractions.

    >>> import blossom
    >>> blossom.answer({"op": "evaluate", "map": {"kind": "polynomial", "text": "t^2"}, "at": ["1/2"]})
    {'ok': True, 'result': {'values': [Fraction(1, 4)]}}
    """
    given = {"timeout": timeout, "memory": max_memory, "work": max_work, **(limits or {})}
    return _engine.answer(request, given)


def answer_json(request: str, *, timeout=None, max_memory=None, max_work=None, limits=None) -> str:
    """The same from text to text: a line of ``blossom batch``.

    >>> import blossom
    >>> blossom.answer_json('{"op": "evaluate", "map": {"kind": "polynomial", "text": "t^2"}, "at": ["1/2"]}')
    '{"ok": true, "result": {"values": ["1/4"]}}'
    """
    given = {"timeout": timeout, "memory": max_memory, "work": max_work, **(limits or {})}
    return _engine.answer_text(request, given)
