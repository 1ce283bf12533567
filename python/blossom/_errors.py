"""The exceptions of the module."""

from __future__ import annotations


def _pointer(place: tuple) -> str:
    return "".join("/" + str(step).replace("~", "~0").replace("/", "~1") for step in place)


class Error(ValueError):
    """A request cannot be answered.

    ``code`` is the word of the protocol for the kind of error, ``message`` one sentence, and ``place`` the
    names and indices that lead to what is wrong: ``("arguments", 1)``. ``at`` is the same as a JSON Pointer.

    >>> import blossom
    >>> try:
    ...     blossom.Polynomial("t^2")("a half")
    ... except blossom.Error as error:
    ...     print(error.code, error.place, error.at)
    not_a_number ('at', 0) /at/0
    """

    def __init__(self, code: str, message: str, place: tuple = (), limit: str = ""):
        super().__init__(message)
        self.code = code
        self.message = message
        self.place = tuple(place)
        self.limit = limit

    def __str__(self) -> str:
        return f"{self.message} [{self.code}{' at ' + self.at if self.place else ''}]"

    def __reduce__(self):
        return type(self), (self.code, self.message, self.place, self.limit)

    @property
    def at(self) -> str:
        return _pointer(self.place)


class LimitExceeded(Error):
    """A limit of work, time, memory or size does not suffice; with a higher one there may be an answer.

    ``limit`` is its name, or "" if the memory of the machine does not suffice.
    """


class InternalError(Error):
    """A defect of the library itself."""


def make_error(code: str, message: str, place: tuple, limit: str) -> Error:
    kinds = {"limit_exceeded": LimitExceeded, "internal": InternalError}
    return kinds.get(code, Error)(code, message, place, limit)
