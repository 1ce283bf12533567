"""Numbers and points: the value of every expression at a sample."""

import field
from combinatorics import binomial, factorial
from faults import Err, TooBig
from field import Jet, add, determinant, inv, power, rational, scale
from integers import Integers
from kinds import Kinds
from maps import Maps

JET_TAG = [0]
NUMBER = ("number",)  # the kind of an undeclared name


class Case(Integers, Maps, Kinds):
    """A block for one choice of its parameters."""

    def __init__(self, scope, params, budget=400000):
        self.scope = scope
        self.decl = scope.decl
        self.lets = scope.lets
        self.strict = scope.strict
        self.penv = {name: ("i", value) for name, value in params.items()}
        self.params = params
        self.memo = {}
        self.depth = 0
        self.work = budget
        self.a = None
        self.members = None
        self.maps = {}
        self.position = {}
        self.seen = set()
        self.around = {}  # variables of poly and for all that a let sees
        for at, line in enumerate(scope.block.lines):
            self.map_line(at, line)

    def use(self, sample):
        self.a = sample
        self.memo = {}
        self.around = {}

    def spend(self, k=1):
        self.work -= k
        if self.work < 0:
            raise TooBig()

    def value(self, n, env):
        return getattr(self, "v_" + n[0])(n, env)

    def number(self, n, env):
        v = getattr(self, "v_" + n[0])(n, env)
        if type(v) is tuple:
            raise Err("kind", "a number expected")
        return v

    def v_num(self, n, env):
        return rational(n[1])

    def v_name(self, n, env):
        base, indices = n[1], n[2]
        if indices is None:
            v = env.get(base)
            if v is not None:
                if v[0] == "i":
                    return v[1] % field.P
                if v[0] == "n" or v[0] == "g":
                    return v[1]
                raise Err("kind", "a set for a number")
            return self.bare(base)
        index = tuple([self.integer(e, env) for e in indices])
        if self.members:
            v = env.get((base, index))
            if v is not None:
                return v[1]
        return self.member(base, index)

    def v_symbol(self, n, env):
        """A coefficient q.1.0 or a coordinate u.2, as conditions are written."""
        base, indices = n[1][1], n[1][2]
        if indices is None and base in self.maps:
            return self.coefficients(base)[n[2]]
        v = self.v_name(n[1], env)
        return v[n[2][0] - 1]

    def bare(self, base):
        d = self.decl.get(base)
        if d is None:
            if base == "delta":
                return (1, 0)
            if self.strict:
                raise Err("not declared", base)
            return self.free((base, None), NUMBER)
        what = d[0]
        if what == "let":
            return self.defined(base, d[1], self.penv)
        if what == "frame":
            s = self.count(d[2], self.penv)
            return tuple([1 if j == d[1] - 1 else 0 for j in range(s)]) + (1,)
        if what == "map":
            raise Err("a map is no number", base)
        return self.free((base, None), d)

    def defined(self, key, body, env):
        """The value of a let, which depends on the variables at the place of its use."""
        if self.around:
            return self.nested(self.value, body, {**self.around, **env})
        if key not in self.memo:
            self.memo[key] = self.nested(self.value, body, env)
        return self.memo[key]

    def free(self, key, d):
        vals = self.a.vals
        if key not in vals:
            if d[0] == "number":
                vals[key] = self.a.number()
            else:
                s = self.count(d[1], self.penv)
                if s < 1:
                    raise Err("dimension")
                vals[key] = tuple([self.a.number() for _ in range(s)]) + (1 if d[0] == "point" else 0,)
        return vals[key]

    def clause(self, base, index):
        """The let clause for a member: its body and environment."""
        clauses = self.lets.get(base + "_")
        if clauses is None:
            return None
        for pattern, body in clauses:
            if len(pattern) != len(index):
                continue
            bound = {}
            for e, i in zip(pattern, index):
                if e[0] == "name" and e[2] is None and self.decl.get(e[1], ("",))[0] != "param":
                    if bound.setdefault(e[1], i) != i:
                        break
                elif self.integer(e, self.penv) != i:
                    break
            else:
                if not bound:
                    return body, self.penv
                env = dict(self.penv)
                for name, i in bound.items():
                    env[name] = ("i", i)
                return body, env
        return None

    def member(self, base, index):
        family = base + "_"
        if family in self.lets:
            key = (base, index)
            if key in self.memo and not self.around:
                return self.memo[key]
            found = self.clause(base, index)
            if found is not None:
                return self.defined(key, *found)
            if family not in self.decl:
                for pattern, _ in self.lets[family]:
                    if len(pattern) == len(index) and any(self.has_name(e) for e in pattern):
                        raise Err("no clause", base)
                if self.strict:
                    raise Err("not declared", base)
        d = self.decl.get(family)
        if d is None:
            if self.strict:
                raise Err("not declared", base)
            return self.free((base, index), NUMBER)
        if self.strict and not self.in_runs(family, index):
            raise Err("not declared", base)
        return self.free((base, index), d)

    def in_runs(self, family, index):
        runs = self.scope.runs.get(family)
        if runs is None:
            return True
        for item in runs:
            if item[0] == "name":
                if tuple(self.integer(e, self.penv) for e in item[2]) == index:
                    return True
            else:
                low = tuple(self.integer(e, self.penv) for e in item[1][2])
                high = tuple(self.integer(e, self.penv) for e in item[2][2])
                if low[:-1] == index[:-1] and low[-1] <= index[-1] <= high[-1]:
                    return True
        return False

    def has_name(self, e):
        if e[0] == "name":
            return True
        return any(self.has_name(x) for x in e[1:] if type(x) is tuple)

    def v_neg(self, n, env):
        v = self.value(n[1], env)
        if type(v) is tuple:
            return tuple((-x) % field.P for x in v)
        return (-v) % field.P

    def v_add(self, n, env):
        a, b = self.value(n[1], env), self.value(n[2], env)
        if type(a) is int and type(b) is int:
            return (a + b) % field.P
        return add(a, b)

    def v_sub(self, n, env):
        a, b = self.value(n[1], env), self.value(n[2], env)
        if type(a) is int and type(b) is int:
            return (a - b) % field.P
        if type(b) is tuple:
            return add(a, tuple((-x) % field.P for x in b))
        if type(a) is tuple:
            if len(a) != 2:
                raise Err("kind", "a number and a point of another dimension")
            return ((a[0] - b) % field.P, (a[1] - 1) % field.P)
        return (a - b) % field.P

    def v_mul(self, n, env):
        a, b = self.value(n[1], env), self.value(n[2], env)
        if type(a) is int and type(b) is int:
            return a * b % field.P
        return scale(a, b)

    def v_div(self, n, env):
        a, b = self.value(n[1], env), self.value(n[2], env)
        if type(b) is tuple:
            raise Err("kind", "a divisor is a number")
        return scale(a, inv(b))

    def v_pow(self, n, env):
        a, k = self.value(n[1], env), self.integer(n[2], env)
        if type(a) is tuple:
            raise Err("kind", "a power of a point")
        if abs(k) > 4000:
            raise TooBig()
        return power(a, k)

    def v_pair(self, n, env):
        return (self.number(n[1], env), self.number(n[2], env))

    def v_tuple(self, n, env):
        return tuple([self.number(e, env) for e in n[1]]) + (1,)

    def v_agg(self, n, env):
        _, which, binder, domain, body = n
        items = self.members_of(domain, env)
        if binder in env or binder in self.decl:
            self.seen.add("a binder hides a name")
        if which == "mean" and not items:
            raise Err("mean of nothing")
        if not items:
            self.seen.add("empty " + ("set of subsets" if domain[0] == "set" else which))
            kind = self.kind(body, self.kinds(env, binder, self.binder_tag(domain)))
            if which == "prod":
                if kind:
                    raise Err("kind", "a product of points")
                return 1
            return (0,) * (kind + 1) if kind else 0
        self.spend(len(items))
        inner = dict(env)
        out = None
        for item in items:
            inner[binder] = item
            v = self.value(body, inner)
            if which == "prod":
                if type(v) is tuple:
                    raise Err("kind", "a product of points")
                out = v if out is None else out * v % field.P
            elif out is None:
                out = v
            else:
                if (type(v) is tuple) != (type(out) is tuple):
                    raise Err("kind", "summands of two kinds")
                out = add(out, v)
        if which == "mean":
            out = scale(out, inv(len(items) % field.P))
        return out

    def v_fn(self, n, env):
        name, args = n[1], n[2]
        if name == "bernstein":
            i, k = self.integer(args[0], env), self.count(args[1], env)
            t = self.number(args[2], env)
            if i < 0 or i > k:
                return 0
            return binomial(k, i) * power(t, i) * power((1 - t) % field.P, k - i) % field.P
        if name == "bspline":
            j, d = self.integer(args[0], env), self.count(args[1], env)
            if args[2][0] != "name" or args[2][2] is not None:
                raise Err("kind", "knots")
            i = self.integer(args[3], env)
            t = self.number(args[4], env)
            return self.bspline(j, d, args[2][1], i, t)
        if name in ("without", "subsets", "partitions", "permutations"):
            raise Err("kind", "a set for a number")
        v = self.int_value(n, env)
        return v % field.P

    def bspline(self, j, d, x, i, t):
        if i < j or i > j + d:
            return 0
        if d == 0:
            return 1
        out = 0
        if j <= i <= j + d - 1:
            low, high = self.knot(x, j), self.knot(x, j + d)
            out = (t - low) * inv((high - low) % field.P) % field.P * self.bspline(j, d - 1, x, i, t) % field.P
        if j + 1 <= i <= j + d:
            low, high = self.knot(x, j + 1), self.knot(x, j + d + 1)
            out = (out + (high - t) * inv((high - low) % field.P) % field.P * self.bspline(j + 1, d - 1, x, i, t)) % field.P
        return out

    def knot(self, x, k):
        v = self.member(x, (k,))
        if type(v) is tuple:
            raise Err("kind", "a knot is a number")
        return v

    def v_if(self, n, env):
        return self.value(n[2] if self.holds(n[1], env) else n[3], env)

    def v_det(self, n, env):
        _, i, j, size, body = n
        k = self.count(size, env)
        if k > 7:
            raise TooBig()
        if k == 0:
            if self.kind(body, self.kinds(self.kinds(env, i, "i"), j, "i")):
                raise Err("kind", "an entry is a number")
            return 1
        inner = dict(env)
        rows = []
        for r in range(1, k + 1):
            inner[i] = ("i", r)
            row = []
            for c in range(1, k + 1):
                inner[i] = ("i", r)
                inner[j] = ("i", c)
                row.append(self.number(body, inner))
            rows.append(row)
        self.spend(1 << k)
        return determinant(rows)

    def v_dif(self, n, env):
        _, body, name, order = n
        k = 1 if order is None else self.count(order, env)
        JET_TAG[0] += 1
        tag = JET_TAG[0]
        base = name[1]
        index = None if name[2] is None else tuple(self.integer(e, env) for e in name[2])
        key = base if index is None else (base, index)
        bound = env.get(key) if index is None or self.members else None
        if bound is not None:
            if bound[0] != "n":
                raise Err("kind", "differentiation by " + base)
            inner = dict(env)
            inner[key] = ("n", Jet(tag, self.series(bound[1], k)))
            v = self.value(body, inner)
        else:
            d = self.decl.get(base if index is None else base + "_")
            if index is None and base == "delta":
                raise Err("kind", "differentiation by delta")
            if d is not None and d[0] != "number" or index is not None and self.clause(base, index) is not None:
                raise Err("kind", "differentiation by " + base)
            if index is None:
                old = self.bare(base)
            else:
                old = self.member(base, index)
            slot = (base, index)
            memo, self.memo = self.memo, {}
            self.a.vals[slot] = Jet(tag, self.series(old, k))
            try:
                v = self.value(body, env)
            finally:
                self.a.vals[slot] = old
                self.memo = memo
        if type(v) is tuple:
            raise Err("kind", "the derivative of a point")
        if type(v) is Jet and v.tag == tag:
            return v.c[k] * factorial(k) % field.P
        return 0 if k else v

    def series(self, x, k):
        return [x] + [1] + [0] * (k - 1) if k else [x]


class Bounds(Case):
    """Only for the bounds of parameters."""

    def map_line(self, at, line):
        pass


def range_cases(case, ranges, env):
    if not ranges:
        return [env]
    binder, low, high = ranges[0]
    a, b = case.integer(low, env), case.integer(high, env)
    if b - a > 400:
        raise TooBig()
    out = []
    for k in range(a, b + 1):
        inner = dict(env)
        inner[binder] = ("i", k)
        out.extend(range_cases(case, ranges[1:], inner))
    return out


def difference(case, line, env):
    a, b = case.value(line[1], env), case.value(line[2], env)
    if type(a) is not tuple and type(b) is not tuple:
        return [(a - b) % field.P]
    if type(a) is not tuple or type(b) is not tuple:
        raise Err("kind", "sides of two kinds")
    if len(a) != len(b):
        raise Err("kind", "sides of two dimensions")
    return [(x - y) % field.P for x, y in zip(a, b)]


def parameter_cases(block, scope):
    """All choices of the parameters of a block."""
    lines = [line for line in block.lines if line[0] == "for"]

    def grow(k, params):
        if k == len(lines):
            return [params]
        _, name, low, high = lines[k]
        case = Bounds(scope, params)
        a, b = case.integer(low, case.penv), case.integer(high, case.penv)
        if b - a > 400:
            raise TooBig()
        out = []
        for v in range(a, b + 1):
            out.extend(grow(k + 1, {**params, name: v}))
        return out

    return grow(0, {})
