"""Results of several members."""

from __future__ import annotations

import html

from . import _engine

#: Results that are true or false as a whole: those of a proof.
_VERDICTS = {"agree": "agree", "prove": "as_expected"}


class Result:
    """The members of a result as attributes, and by their names: ``result.roots``, ``result["roots"]``.

    ``str(result)`` is the text that the program prints. The result of a proof is true if all agrees.

    >>> import blossom
    >>> proof = blossom.Polynomial("1 + 2t + 4t^2 - t^3").agree()
    >>> bool(proof), proof.elementary
    (True, '1 + 2/3 e1 + 4/3 e2 - e3')
    """

    __slots__ = ("_operation", "_members", "_fields", "_floats")

    def __init__(self, operation, members, fields, floats):
        object.__setattr__(self, "_operation", operation)
        object.__setattr__(self, "_members", members)
        object.__setattr__(self, "_fields", fields)
        object.__setattr__(self, "_floats", floats)

    def __getattr__(self, name):
        members = object.__getattribute__(self, "_members")
        for known in (name, name.replace("_", "-"), name.rstrip("_")):
            if known in members:
                return members[known]
        raise AttributeError(f"the result has no {name}; it has {', '.join(members)}")

    def __setattr__(self, name, value):
        raise AttributeError("a result cannot be changed")

    def __getitem__(self, name):
        return self._members[name]

    def __contains__(self, name):
        return name in self._members

    def __iter__(self):
        return iter(self._members)

    def __len__(self):
        return len(self._members)

    def keys(self):
        return self._members.keys()

    def __eq__(self, other):
        if not isinstance(other, Result):
            return NotImplemented
        return (self._operation, self._members) == (other._operation, other._members)

    def __bool__(self):
        verdict = _VERDICTS.get(self._operation)
        return self._members[verdict] if verdict else True

    def __dir__(self):
        return [*super().__dir__(), *self._members]

    def __reduce__(self):
        return Result, (self._operation, self._members, self._fields, self._floats)

    def __repr__(self):
        return f"Result({', '.join(f'{name}={value!r}' for name, value in self._members.items())})"

    def _document(self, format):
        return self._members["document"] if self._members.get("format") == format else None

    def _repr_html_(self):
        """A worked example or an exercise sheet as a page of its own in the notebook."""
        page = self._document("html")
        if page is None:
            return None
        return f'<iframe srcdoc="{html.escape(page)}" style="width: 100%; height: 40em; border: 0"></iframe>'

    def _repr_markdown_(self):
        return self._document("markdown")

    def _repr_latex_(self):
        return self._document("latex-fragment")

    def __str__(self):
        """The text that the program prints after the same request."""
        return _engine.shown(self._operation, self._fields, self._floats, False)
