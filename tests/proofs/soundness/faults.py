"""The exceptions that end the evaluation of a statement."""


class Err(Exception):
    """A statement without meaning, with the kind of its fault."""

    def __init__(self, kind, text=""):
        super().__init__(kind + (": " + text if text else ""))
        self.kind = kind


class ZeroDivisor(Err):
    def __init__(self):
        super().__init__("division by zero")


class TooBig(Exception):
    pass
