"""Writes the type stubs of the package: python -m blossom._stubs > __init__.pyi

The methods are those that the operations describe, so that the stubs are complete in every build.
"""

from __future__ import annotations

from . import _maps, _operations

_HEAD = '''\
# Made from the descriptions of the operations and the kinds of maps.
from decimal import Decimal
from fractions import Fraction as Fraction
from typing import Any, Iterator, Literal, Mapping, Protocol, Sequence, Union

from . import operations as operations

class _Rational(Protocol):
    @property
    def numerator(self) -> Any: ...
    @property
    def denominator(self) -> Any: ...

Number = Union[int, str, Fraction, Decimal, _Rational, float]
Point = Union[Number, Sequence[Number]]
Floats = Literal["double", "decimal"]

__version__: str

class Error(ValueError):
    code: str
    message: str
    place: tuple[str | int, ...]
    limit: str
    @property
    def at(self) -> str: ...

class LimitExceeded(Error): ...
class InternalError(Error): ...

class Vector:
    value: Any
    def __init__(self, value: Point) -> None: ...

class Weighted(Vector):
    mass: Any
    def __init__(self, value: Point, mass: Number) -> None: ...

delta: Vector

class Result:
    def __getattr__(self, name: str) -> Any: ...
    def __getitem__(self, name: str) -> Any: ...
    def __contains__(self, name: object) -> bool: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    def __bool__(self) -> bool: ...
    def keys(self) -> Any: ...

def answer(
    request: Mapping[str, Any], *, timeout: int | None = None, max_memory: int | None = None,
    max_work: int | None = None, limits: Mapping[str, int] | None = None,
) -> dict[str, Any]: ...
def answer_json(
    request: str, *, timeout: int | None = None, max_memory: int | None = None,
    max_work: int | None = None, limits: Mapping[str, int] | None = None,
) -> str: ...
def fraction(value: Number, floats: Floats | None = None) -> Fraction: ...
def nearest_double(value: Number) -> float: ...
def ulp(value: Number) -> Fraction: ...
def floats(value: Any) -> Any: ...
def array(values: Any) -> Any: ...

class Map:
    kind: str
    def __init__(self, description: Mapping[str, Any] | Map, *, floats: Floats | None = None) -> None: ...
    def __call__(self, *parameters: Any, floats: Floats | None = None) -> Any: ...
    def __getitem__(self, arguments: Any) -> Any: ...
    def __getattr__(self, name: str) -> Any: ...
    def __hash__(self) -> int: ...
    def __add__(self, other: Map) -> Map: ...
    def __sub__(self, other: Map) -> Map: ...
    def __neg__(self) -> Map: ...
    def __mul__(self, other: Map | Number) -> Map: ...
    def __rmul__(self, other: Number) -> Map: ...
    def __truediv__(self, other: Map | Number) -> Map: ...
    def __matmul__(self, other: Map) -> Map: ...
    @property
    def fields(self) -> Mapping[str, Any]: ...
    @property
    def points(self) -> tuple[Any, ...]: ...
    def to_dict(self) -> dict[str, Any]: ...
    def to_json(self) -> str: ...
    @staticmethod
    def from_json(text: str) -> Map: ...
    @staticmethod
    def from_sympy(expression: Any, *variables: Any, degree: int | None = None, degrees: Sequence[int] | None = None) -> Map: ...
    def to_sympy(self, *variables: Any) -> Any: ...
    def blossom_to_sympy(self, *symbols: Any) -> Any: ...
    @staticmethod
    def from_scipy(spline: Any, floats: Floats = "double") -> BSpline: ...
    def to_scipy(self) -> Any: ...
    @staticmethod
    def from_geomdl(shape: Any, floats: Floats = "double") -> Map: ...
    @staticmethod
    def from_splinepy(shape: Any, floats: Floats = "double") -> Map: ...
    def worked(self, operation: str, *, format: str = "html", **fields: Any) -> Result: ...
    def plot(self, ax: Any = None, count: int = 200, points: bool = True, **style: Any) -> Any: ...
'''

_TYPES = {
    "count": "int",
    "integer": "int",
    "number": "Number",
    "true or false": "bool",
    "text": "str",
    "map": "Map | Mapping[str, Any]",
    "list of maps": "Sequence[Map | Mapping[str, Any]]",
    "list of numbers": "Sequence[Number]",
    "list of points": "Sequence[Point]",
    "list of counts": "Sequence[int]",
    "interval": "Sequence[Number]",
}
_RESULTS = {
    "map": "Map",
    "list of maps": "tuple[Map, ...]",
    "text": "str",
    "list of points": "tuple[Any, ...]",
    "point": "Any",
}
_COMMON = (
    'floats: Floats | None = None, numbers: Literal["double", "hexfloat"] | None = None, timeout: int | None = None, '
    "max_memory: int | None = None, max_work: int | None = None, limits: Mapping[str, int] | None = None"
)


def _type(field: dict) -> str:
    if field["alternatives"]:
        return f"Literal[{', '.join(repr(word) for word in field['alternatives'])}]"
    return _TYPES.get(field["kind"], "Any")


def _result(operation) -> str:
    if len(operation.result) != 1:
        required = [member for member in operation.result if member["required"]]
        return "Result" if len(required) > 1 else "Any"
    return _RESULTS.get(operation.result[0]["kind"], "Any")


def _signature(operation, of_map: bool) -> str:
    fields = {_operations.python_name(field["name"]): field for field in operation.fields}
    parts = []
    star = False
    for name, parameter in operation.signature(of_map).parameters.items():
        if name in _operations.COMMON:
            continue
        if name == "self":
            parts.append("self")
        elif name == "map":
            absent = parameter.default is None
            parts.append(f"map: {_TYPES['map']}{' | None = None' if absent else ''}")
        elif parameter.kind is parameter.VAR_POSITIONAL:
            parts.append(f"*{name}: Any")
            star = True
        elif parameter.kind is parameter.KEYWORD_ONLY:
            if not star:
                parts.append("*")
                star = True
            parts.append(f"{name}: {_type(fields[name])} | None = None")
        else:
            parts.append(f"{name}: {_type(fields[name])}")
    if not star:
        parts.append("*")
    return f"({', '.join(parts)}, {_COMMON}) -> {_result(operation)}: ..."


def package() -> str:
    """The stub of `blossom`."""
    lines = [_HEAD.rstrip("\n")]
    for operation in _operations.ALL:
        if operation.takes_map:
            lines.append(f"    def {operation.python_name}{_signature(operation, True)}")
    for name, cls in _maps.CLASSES.items():
        fields = [field["name"] for field in _maps._KINDS[cls._title.removesuffix(" rational")]["fields"]]
        positional = ", ".join(f"{field}: Any = None" for field in cls._positional)
        others = ", ".join(f"{field}: Any = None" for field in fields if field not in cls._positional)
        base = cls.__mro__[1].__name__ if cls.__mro__[1].__name__ in _maps.CLASSES else "Map"
        parts = ", ".join(part for part in ("self", positional, "*", others, "floats: Floats | None = None") if part)
        lines += ["", f"class {name}({base}):", f"    def __init__({parts}) -> None: ..."]
    lines.append("")
    for operation in _operations.ALL:
        if not operation.takes_map or operation.map_may_be_absent:
            lines.append(f"def {operation.python_name}{_signature(operation, False)}")
    return "\n".join(lines) + "\n"


def functions() -> str:
    """The stub of `blossom.operations`."""
    lines = ["from typing import Any, Literal, Mapping, Sequence", "", "from . import Floats, Map, Number, Point, Result", ""]
    lines += [f"def {operation.python_name}{_signature(operation, False)}" for operation in _operations.ALL]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    import sys
    from pathlib import Path

    folder = Path(sys.argv[1])
    (folder / "__init__.pyi").write_text(package())
    (folder / "operations.pyi").write_text(functions())
