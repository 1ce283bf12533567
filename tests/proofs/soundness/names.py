"""The names of a block: their declarations, and values for free names."""

import field
from faults import Err
from language import RESERVED


class Scope:
    """The declarations of a block."""

    def __init__(self, block):
        self.block = block
        self.strict = block.strict
        self.decl = {}
        self.lets = {}
        soft = []
        self.runs = {}
        for at, line in enumerate(block.lines):
            word = line[0]
            if word == "for":
                self.declare(line[1], ("param",), at)
            elif word == "map":
                for name in line[1]:
                    self.declare(name, ("map", at), at)
            elif word == "poly":
                self.declare(line[1], ("map", at), at)
            elif word == "raise":
                self.declare(line[3], ("map", at), at)
            elif word == "frame":
                for k, name in enumerate(line[1]):
                    self.declare(name, ("frame", k, line[2]), at)
            elif word in ("point", "vector", "number"):
                for item in line[1]:
                    if item[0] == "name" and item[2] is None:
                        self.declare(item[1], (word, line[2]), at)
                        soft.append((item[1] + "_", (word, line[2])))
                    else:
                        base = item[1] if item[0] == "name" else item[1][1]
                        if item[0] == "run" and (item[1][2] is None or item[2][2] is None or item[2][1] != base):
                            raise Err("run", base)
                        key = base + "_"
                        old = self.decl.get(key)
                        if old is not None and old != (word, line[2]):
                            raise Err("redeclared", key)
                        self.decl[key] = (word, line[2])
                        self.runs.setdefault(key, []).append(item)
            elif word == "let":
                name = line[1]
                if name[2] is None:
                    self.declare(name[1], ("let", line[2]), at)
                else:
                    clauses = self.lets.setdefault(name[1] + "_", [])
                    if any(self.pattern(c[0]) == self.pattern(name[2]) for c in clauses):
                        raise Err("redeclared", name[1])
                    clauses.append((name[2], line[2]))
        for key, entry in soft:
            if key not in self.decl and key not in self.lets:
                self.decl[key] = entry
        self.parameters = {line[1] for line in block.lines if line[0] == "for"}
        for line in block.lines:
            if line[0] == "poly":
                if len(set(line[2])) != len(line[2]):
                    raise Err("redeclared", "a variable twice")
                for v in line[2]:
                    if v == "delta" or v in self.decl and self.decl[v][0] != "number":
                        raise Err("redeclared", "variable " + v)

    def pattern(self, indices):
        """A pattern in which the names that fit any integer are numbered."""
        names = {}

        def walk(e):
            if e[0] == "name" and e[2] is None and self.decl.get(e[1], ("",))[0] != "param":
                return ("any", names.setdefault(e[1], len(names)))
            return e

        return tuple(walk(e) for e in indices)

    def declare(self, name, entry, at):
        if name in RESERVED or name in ("delta", "all"):
            raise Err("redeclared", name + " is a word of the language")
        if name in self.decl:
            raise Err("redeclared", name)
        self.decl[name] = entry


class Sample:
    """Values for free names, created on demand."""

    def __init__(self, rng, pool=None):
        self.vals = {}
        self.coefs = {}
        self.rng = rng
        self.pool = pool

    def number(self):
        if self.pool is not None:
            return self.rng.choice(self.pool) % field.P
        return self.rng.randrange(2, field.P)

    def fresh(self):
        return self.rng.randrange(2, field.P)
