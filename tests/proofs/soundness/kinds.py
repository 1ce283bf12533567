"""The kinds of expressions."""

from faults import Err


class Kinds:
    """The kind of an expression, without its value: 0 for a number, d for a point, vector or pair of dimension d, None if unknown."""

    def kind_env(self, env):
        return {k: (("g", len(v[1]) - 1) if v[0] == "g" else v[0]) for k, v in env.items()}

    def kinds(self, env, binder, tag):
        out = {}
        for k, v in env.items():
            out[k] = v if type(v) is str or v[0] == "g" and type(v[1]) is int else (("g", len(v[1]) - 1) if v[0] == "g" else v[0])
        out[binder] = tag
        return out

    def binder_tag(self, domain):
        if domain[0] == "rng":
            return "i"
        e = domain[1]
        if e[0] == "fn":
            return {"without": "i", "subsets": "s", "partitions": "S", "permutations": "p"}.get(e[1], "i")
        return "i?"

    def join(self, a, b):
        if a is None:
            return b
        if b is None or a == b:
            return a
        raise Err("kind", "two kinds")

    def kind(self, n, env):
        what = n[0]
        if what == "num":
            return 0
        if what == "name":
            if n[2] is None:
                v = env.get(n[1])
                if v is not None:
                    if type(v) is tuple:
                        return v[1]
                    if v in ("s", "S", "p"):
                        raise Err("kind", "a set for a number")
                    return 0
                return self.bare_kind(n[1])
            if self.members:
                for key, v in env.items():
                    if type(key) is tuple and key[0] == n[1]:
                        return v[1] if type(v) is tuple else 0
            return self.family_kind(n[1])
        if what in ("neg",):
            return self.kind(n[1], env)
        if what in ("add", "sub"):
            a, b = self.kind(n[1], env), self.kind(n[2], env)
            if a is None or b is None:
                return a or b
            if a == b:
                return a
            if {a, b} == {0, 1}:
                return 1
            raise Err("kind", "a sum of two kinds")
        if what == "mul":
            a, b = self.kind(n[1], env), self.kind(n[2], env)
            if a and b:
                raise Err("kind", "a product of points")
            if a is None or b is None:
                return a or b
            return a or b
        if what == "div":
            a, b = self.kind(n[1], env), self.kind(n[2], env)
            if b:
                raise Err("kind", "a divisor is a number")
            return a
        if what == "pow":
            if self.kind(n[1], env):
                raise Err("kind", "a power of a point")
            return 0
        if what == "pair":
            if self.kind(n[1], env) or self.kind(n[2], env):
                raise Err("kind", "a pair of points")
            return 1
        if what == "tuple":
            if any(self.kind(e, env) for e in n[1]):
                raise Err("kind", "a tuple of points")
            return len(n[1])
        if what == "agg":
            inner = dict(env)
            inner[n[2]] = self.domain_tag(n[3], env)
            k = self.kind(n[4], inner)
            if n[1] == "prod":
                if k:
                    raise Err("kind", "a product of points")
                return 0
            return k
        if what == "if":
            return self.join(self.kind(n[2], env), self.kind(n[3], env))
        if what == "det":
            inner = dict(env)
            inner[n[1]] = inner[n[2]] = "i"
            if self.kind(n[4], inner):
                raise Err("kind", "an entry is a number")
            return 0
        if what == "fn":
            if n[1] in ("without", "subsets", "partitions", "permutations"):
                raise Err("kind", "a set for a number")
            if n[1] == "bernstein" and self.kind(n[2][2], env) or n[1] == "bspline" and self.kind(n[2][4], env):
                raise Err("kind", "a number expected")
            if n[1] == "bspline" and n[2][2][0] == "name" and self.family_kind(n[2][2][1]):
                raise Err("kind", "a knot is a number")
            return 0
        if what == "dif":
            if self.kind(n[1], env):
                raise Err("kind", "the derivative of a point")
            return 0
        if what == "val":
            if env.get(n[1]) == "p":
                return 0
            dirs = self.map_of(n[1], {k: v for k, v in env.items() if k == n[1]})
            if not (n[2] is None and len(dirs) == 1 and dirs[0][0] > 1 and len(n[3]) == dirs[0][0]):
                if len(n[3]) != len(dirs):
                    raise Err("arity", "arguments of " + n[1])
                for a, (s, _) in zip(n[3], dirs):
                    self.argument_kind(self.kind(a, env), s)
            else:
                for a in n[3]:
                    if self.kind(a, env):
                        raise Err("kind", "a number expected")
            return 0
        if what == "blo":
            dirs = self.map_of(n[1], {k: v for k, v in env.items() if k == n[1]})
            if len(n[2]) != len(dirs):
                raise Err("arity", "directions of " + n[1])
            for given, (s, _) in zip(n[2], dirs):
                for a in given:
                    if a[0] == "copies":
                        k = self.kind(a[1], env)
                    elif a[0] == "run":
                        continue
                    elif a[0] == "fam":
                        inner = dict(env)
                        inner[a[2]] = self.domain_tag(a[3], env)
                        k = self.kind(a[1], inner)
                    else:
                        k = self.kind(a, env)
                    self.argument_kind(k, s)
            return 0
        raise Err("kind", what)

    def domain_tag(self, domain, env):
        if domain[0] == "set" and domain[1][0] == "name":
            return {"S": "s"}.get(env.get(domain[1][1]), "i")
        return self.binder_tag(domain)

    def argument_kind(self, k, s):
        if k is not None and k != s and not (k == 0 and s == 1):
            raise Err("kind", "an argument of another dimension")

    def bare_kind(self, base):
        d = self.decl.get(base)
        if d is None:
            if base == "delta":
                return 1
            if self.strict:
                raise Err("not declared", base)
            return 0
        if d[0] == "let":
            return self.let_kind(base, [d[1]], [()])
        if d[0] == "frame":
            return self.count(d[2], self.penv)
        if d[0] in ("point", "vector"):
            return self.count(d[1], self.penv)
        if d[0] == "map":
            raise Err("a map is no number", base)
        return 0

    def family_kind(self, base):
        family = base + "_"
        d = self.decl.get(family)
        declared = None
        if d is not None:
            declared = 0 if d[0] == "number" else self.count(d[1], self.penv)
        if family in self.lets:
            clauses = self.lets[family]
            k = self.let_kind(family, [c[1] for c in clauses], [c[0] for c in clauses])
            return k if declared is None else self.join(declared, k)
        if declared is None and self.strict:
            raise Err("not declared", base)
        return declared or 0

    def let_kind(self, key, bodies, patterns):
        known = self.scope.__dict__.setdefault("let_kinds", {})
        if key in known:
            return known[key]
        known[key] = None
        k = None
        for _ in range(2):  # the second pass uses the kinds that the first found for recursive lets
            for body, pattern in zip(bodies, patterns):
                env = {name: "i" for name in self.penv}
                for e in pattern:
                    if e[0] == "name" and e[2] is None:
                        env[e[1]] = "i"
                k = self.join(k, self.kind(body, env))
            known[key] = k
        return k
