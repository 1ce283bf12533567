"""The operations of the protocol as functions and methods, made from what the operations say of themselves."""

from __future__ import annotations

import inspect
import keyword
import textwrap

from . import _engine
from ._results import Result

#: What every operation takes besides its own fields.
COMMON = {
    "floats": '"double" or "decimal": floats are taken as their exact values, or as the decimals they print; '
    "without it a float is refused",
    "numbers": '"double" or "hexfloat": the result has its numbers correctly rounded, too',
    "timeout": "seconds of processor time; 0 for no limit",
    "max_memory": "bytes",
    "max_work": "word operations",
    "limits": "other limits by their names, a dictionary",
}


def python_name(name: str) -> str:
    """The name in Python of an operation or a field: "insert-knots" is insert_knots, "import" is import_."""
    name = name.replace("-", "_")
    return name + "_" if keyword.iskeyword(name) else name


def _wrapped(text: str, indent: str) -> str:
    return textwrap.fill(text, 100, initial_indent=indent, subsequent_indent=indent, break_on_hyphens=False)


def _field_lines(fields: list, presence: bool) -> list:
    lines = []
    for field in fields:
        optional = ", optional" if presence and not field["required"] else ""
        lines.append(f"{python_name(field['name'])} : {field['kind']}{optional}")
        lines.append(_wrapped(field["documentation"], "    "))
    return lines


#: For commands whose options are not those of the operation.
_EXAMPLES = {
    "prove": {"statement": "map p degree 2\nclaim p[s, u] == p[u, s]"},
    "explain": {"request": {"op": "evaluate", "map": {"kind": "polynomial", "text": "t^2"}, "at": ["3"]}},
}


def _kind_of(fields: dict) -> str:
    """The kind of map that these fields describe, as the options of the program do."""
    if "control_points" not in fields:
        return "polynomial"
    return "bspline" if "knots" in fields else "bezier"


class Operation:
    """What an operation says of itself, and how it is called."""

    def __init__(self, description: dict):
        self.name = description["name"]
        self.python_name = python_name(self.name)
        self.summary = description["summary"]
        self.documentation = description["documentation"]
        self.result = description["result"]
        names = {field["name"] for field in description["fields"]}
        self.takes_map = "map" in names
        self.map_may_be_absent = not any(f["name"] == "map" and f["required"] for f in description["fields"])
        self.fields = [field for field in description["fields"] if field["name"] != "map"]
        self._wire_names = {python_name(field["name"]): field["name"] for field in self.fields}
        # The arguments of a blossom are written one after the other, p.blossom(1, 2, delta).
        self.spread = "arguments" in names
        self.needs_arguments = any(f["name"] == "arguments" and f["required"] for f in self.fields)

    def example(self, of_map: bool) -> str:
        """A call with the request of the example that the program shows."""
        request = _EXAMPLES.get(self.name) or _engine.example(self.name)
        if request is None:
            return ""
        request = dict(request)
        first, shown = [], []
        if "map" in request:
            fields = dict(request.pop("map"))
            fields = {"kind": fields.pop("kind", _kind_of(fields)), **fields}
            map_ = f"blossom.Map({fields!r})"
            first = [] if of_map else [map_]
        elif of_map:
            return ""
        if self.spread:
            shown += [f"arguments={request.pop('arguments')!r}"] if "arguments" in request else []
        shown += [f"{python_name(name)}={value!r}" for name, value in request.items()]
        called = f"{map_}." if of_map else "blossom.operations."
        return f">>> import blossom\n>>> result = {called}{self.python_name}({', '.join(first + shown)})"

    def docstring(self, of_map: bool) -> str:
        lines = [self.summary + ".", "", _wrapped(self.documentation, ""), "", "Parameters", "----------"]
        if self.takes_map and not of_map:
            lines += ["map : map", "    the map"]
        lines += _field_lines(self.fields, True)
        lines += ["floats, numbers, timeout, max_memory, max_work, limits", _wrapped(
            "see `blossom.operations`", "    ")]
        lines += ["", "Returns", "-------", "The member of the result if there is one, otherwise a `Result` of these:", ""]
        lines += _field_lines(self.result, False)
        if example := self.example(of_map):
            lines += ["", "Examples", "--------", example]
        return "\n".join(lines)

    def signature(self, of_map: bool) -> inspect.Signature:
        kinds = inspect.Parameter
        first = []
        if of_map:
            first = [kinds("self", kinds.POSITIONAL_ONLY)]
        elif self.takes_map:
            absent = {"default": None} if self.map_may_be_absent else {}
            first = [kinds("map", kinds.POSITIONAL_OR_KEYWORD, **absent)]
        required, optional = [], []
        if self.spread:
            required.append(kinds("arguments", kinds.VAR_POSITIONAL))
        for field in self.fields:
            name = python_name(field["name"])
            if self.spread and name == "arguments":
                continue
            if field["required"] and not self.spread and not (first and first[0].default is None):
                required.append(kinds(name, kinds.POSITIONAL_OR_KEYWORD))
            else:
                optional.append(kinds(name, kinds.KEYWORD_ONLY, default=None))
        common = [kinds(name, kinds.KEYWORD_ONLY, default=None) for name in COMMON]
        return inspect.Signature(first + required + optional + common)

    def call(self, map_, arguments: tuple, keywords: dict):
        """Answers a request with these arguments."""
        fields, floats, limits = self.request(map_, arguments, keywords)
        members = _engine.call(self.name, fields, floats, limits)
        if len(members) == 1:
            return next(iter(members.values()))
        return Result(self.name, members, fields, floats)

    def request(self, map_, arguments: tuple, keywords: dict):
        fields = {}
        if map_ is not None:
            fields["map"] = map_
        positional = [field["name"] for field in self.fields if field["required"]] or [
            field["name"] for field in self.fields
        ]
        if self.spread:
            if arguments or (self.needs_arguments and "arguments" not in keywords):
                fields["arguments"] = list(arguments)
        elif len(arguments) > len(positional):
            raise TypeError(
                f"{self.python_name}() takes at most {len(positional)} positional arguments: "
                f"{', '.join(map(python_name, positional)) or 'none'}"
            )
        else:
            fields.update(zip(positional, arguments))
        limits = dict(keywords.pop("limits", None) or {})
        for name, limit in (("timeout", "timeout"), ("max_memory", "memory"), ("max_work", "work")):
            if keywords.get(name) is not None:
                limits[limit] = keywords[name]
            keywords.pop(name, None)
        floats = keywords.pop("floats", None)
        for name, value in keywords.items():
            wire_name = self._wire_names.get(name, name)
            if wire_name in fields:
                raise TypeError(f"{self.python_name}() got two values for {name}")
            if value is not None:
                fields[wire_name] = value
        return fields, floats, limits or None

    def function(self):
        """The operation as a function, whose first argument is the map if it takes one."""
        if self.takes_map:

            def function(map=None, *arguments, **keywords):
                return self.call(map, arguments, keywords)

        else:

            def function(*arguments, **keywords):
                return self.call(None, arguments, keywords)

        return self._finished(function, False)

    def method(self):
        """The operation as a method of a map."""

        def method(self_, *arguments, **keywords):
            return self.call(self_, arguments, keywords)

        return self._finished(method, True)

    def _finished(self, function, of_map: bool):
        function.__name__ = self.python_name
        function.__qualname__ = f"Map.{self.python_name}" if of_map else self.python_name
        function.__module__ = "blossom" if of_map else "blossom.operations"
        function.__doc__ = self.docstring(of_map)
        function.__signature__ = self.signature(of_map)
        return function


ALL = [Operation(description) for description in _engine.operations()]
BY_NAME = {operation.name: operation for operation in ALL}


def add_methods(cls) -> None:
    """Gives the class of maps a method for every operation on a map."""
    for operation in ALL:
        if operation.takes_map:
            setattr(cls, operation.python_name, operation.method())
