"""The integer expressions and sets of a statement."""

from fractions import Fraction

from combinatorics import binomial, factorial, partitions_of, permutations_of, sign_of, subsets_of
from faults import Err, TooBig, ZeroDivisor


class Integers:
    """Integers and sets: bounds, indices, degrees, and the domains of binders. A set is tagged: ("s", integers), ("S", sets of
    integers), ("SS", sets of sets), ("P", permutations)."""

    def int_value(self, n, env):
        kind = n[0]
        if kind == "num":
            text = n[1]
            return int(text) if text.isdigit() else Fraction(text)
        if kind == "name":
            if n[2] is None:
                v = env.get(n[1])
                if v is not None:
                    if v[0] == "i":
                        return v[1]
                    raise Err("integer", n[1])
                d = self.decl.get(n[1])
                if d is not None and d[0] == "let":
                    return self.nested(self.int_value, d[1], self.penv)
                raise Err("integer", n[1])
            index = tuple(self.integer(e, env) for e in n[2])
            clause = self.clause(n[1], index)
            if clause is None:
                raise Err("integer", n[1])
            return self.nested(self.int_value, clause[0], clause[1])
        if kind == "neg":
            return -self.int_value(n[1], env)
        if kind == "add":
            return self.int_value(n[1], env) + self.int_value(n[2], env)
        if kind == "sub":
            return self.int_value(n[1], env) - self.int_value(n[2], env)
        if kind == "mul":
            return self.int_value(n[1], env) * self.int_value(n[2], env)
        if kind == "div":
            a, b = self.int_value(n[1], env), self.int_value(n[2], env)
            if b == 0:
                raise ZeroDivisor()
            return Fraction(a) / b
        if kind == "pow":
            a, k = self.int_value(n[1], env), self.integer(n[2], env)
            if abs(k) > 4000:
                raise TooBig()
            if k < 0 and a == 0:
                raise ZeroDivisor()
            return Fraction(a) ** k if k < 0 else a**k
        if kind == "fn":
            if n[1] == "binomial":
                a, k = self.integer(n[2][0], env), self.integer(n[2][1], env)
                if a < 0:
                    raise Err("negative")
                return binomial(a, k)
            if n[1] == "factorial":
                a = self.integer(n[2][0], env)
                if a < 0:
                    raise Err("negative")
                if a > 500:
                    raise TooBig()
                return factorial(a)
            if n[1] == "size":
                what, items = self.set_value(n[2][0], env)
                if what not in ("s", "S"):
                    raise Err("kind", "size")
                return len(items)
            if n[1] == "sign":
                v = n[2][0]
                p = env.get(v[1]) if v[0] == "name" and v[2] is None else None
                if p is None or p[0] != "p":
                    raise Err("kind", "sign")
                return sign_of(p[1])
        if kind == "val" and n[1] in env and env[n[1]][0] == "p" and n[2] is None and len(n[3]) == 1:
            i = self.integer(n[3][0], env)
            p = env[n[1]][1]
            if not 1 <= i <= len(p):
                raise Err("range", "of a permutation")
            return p[i - 1]
        raise Err("integer", kind)

    def integer(self, n, env):
        v = self.int_value(n, env)
        if type(v) is int:
            return v
        if v.denominator != 1:
            raise Err("integer", "a fraction")
        return int(v)

    def count(self, n, env):
        k = self.integer(n, env)
        if k < 0:
            raise Err("negative")
        if k > 400:
            raise TooBig()
        return k

    def nested(self, evaluate, *arguments):
        """The value of a definition, which must not refer to itself without end."""
        self.depth += 1
        if self.depth > 60:
            self.depth = 0
            raise Err("recursion")
        out = evaluate(*arguments)
        self.depth -= 1
        return out

    def set_value(self, n, env):
        if n[0] == "name" and n[2] is None:
            v = env.get(n[1])
            if v is not None and v[0] in ("s", "S"):
                return v
            if v is not None and v[0] == "p":
                raise Err("kind", "a permutation for a set")
        if n[0] == "fn":
            if n[1] == "without":
                k = self.count(n[2][0], env)
                what, items = self.set_value(n[2][1], env)
                if what != "s":
                    raise Err("kind", "set")
                return ("s", tuple(i for i in range(1, k + 1) if i not in items))
            if n[1] == "subsets":
                k = self.integer(n[2][1], env)
                out = subsets_of(self.base_set(n[2][0], env), k)
                self.spend(len(out))
                return ("S", tuple(out))
            if n[1] == "partitions":
                items = self.base_set(n[2][0], env)
                if len(items) > 6:
                    raise TooBig()
                return ("SS", tuple(partitions_of(items)))
            if n[1] == "permutations":
                k = self.count(n[2][0], env)
                if k > 5:
                    raise TooBig()
                return ("P", tuple(permutations_of(k)))
        raise Err("kind", "a set expected")

    def is_set(self, n, env):
        if n[0] == "name" and n[2] is None:
            return env.get(n[1], ("",))[0] in ("s", "S")
        return n[0] == "fn" and n[1] in ("without", "subsets", "partitions", "permutations")

    def base_set(self, n, env):
        if self.is_set(n, env):
            what, items = self.set_value(n, env)
            if what != "s":
                raise Err("kind", "set")
            return items
        k = self.count(n, env)
        if k > 14:
            raise TooBig()
        return tuple(range(1, k + 1))

    def members_of(self, domain, env):
        """The values of a binder, tagged for the environment."""
        if domain[0] == "rng":
            low, high = self.integer(domain[1], env), self.integer(domain[2], env)
            if high - low > 5000:
                raise TooBig()
            return [("i", i) for i in range(low, high + 1)]
        what, items = self.set_value(domain[1], env)
        tag = {"s": "i", "S": "s", "SS": "S", "P": "p"}[what]
        return [(tag, x) for x in items]

    def holds(self, condition, env):
        op, a, b = condition
        if op in ("in", "notin"):
            x = self.integer(a, env)
            what, items = self.set_value(b, env)
            if what != "s":
                raise Err("kind", "set")
            return (x in items) == (op == "in")
        x, y = self.int_value(a, env), self.int_value(b, env)
        return {"==": x == y, "!=": x != y, "<": x < y, "<=": x <= y, ">": x > y, ">=": x >= y}[op]

    def passes(self, f, env):
        if f[0] == "!=":
            return self.int_value(f[1], env) != self.int_value(f[2], env)
        what, items = self.set_value(f[2], env)
        if what != "s":
            raise Err("kind", "set")
        return self.integer(f[1], env) not in items
