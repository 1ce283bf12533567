#!/usr/bin/env python3
"""An oracle for the identity language: both sides of every claim at random points of a large prime field.

It shares nothing with the prover: own reader (language.py), own scopes and kinds, values instead of expansion. A claim that
holds at random points is true (by Schwartz and Zippel, with an error far below 2^-50), one that fails has a witness. Hypotheses
are met by solving for what is linear in them (map coefficients, numbers, coordinates), in several orders, so that different
components are seen, and for one unknown of degree 2 by a square root.

    decide(block)  ->  a Decision with one Line for each claim and refute

As a program: `oracle.py FILE ...` prints the truth of each line of these files; `oracle.py prove FILE --json` prints it as the prover would.
"""

import random
import re
from fractions import Fraction

from language import RESERVED, SyntaxFault, parse_comparison, parse_expr, parse_text

PRIME = (1 << 61) - 1  # 3 mod 4, 7 mod 8


class Err(Exception):
    """A statement that has no meaning, with the kind of its fault."""

    def __init__(self, kind, text=""):
        super().__init__(kind + (": " + text if text else ""))
        self.kind = kind


class ZeroDivisor(Err):
    def __init__(self):
        super().__init__("division by zero")


class TooBig(Exception):
    pass


def is_prime(n):
    for q in (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37):
        if n % q == 0:
            return n == q
    d, s = n - 1, 0
    while d % 2 == 0:
        d, s = d // 2, s + 1
    for a in (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37):
        x = pow(a, d, n)
        if x in (1, n - 1):
            continue
        for _ in range(s - 1):
            x = x * x % n
            if x == n - 1:
                break
        else:
            return False
    return True


def primes_below(n, count, residue):
    out = []
    while len(out) < count:
        n -= 1
        if n % 4 == residue and is_prime(n):
            out.append(n)
    return out


P = PRIME
# In some of these fields -1, 2, 3, 5 and so on have square roots; what has none in one field is tried in the next.
FIELDS = [PRIME] + primes_below(1 << 61, 3, 1)


# numbers: int modulo P, or a Jet: a power series in one more unknown, cut off


class Jet:
    __slots__ = ("tag", "c")

    def __init__(self, tag, c):
        self.tag = tag
        self.c = c

    def __add__(self, o):
        if type(o) is Jet:
            if o.tag == self.tag:
                return Jet(self.tag, [(a + b) % P for a, b in zip(self.c, o.c)])
            if o.tag > self.tag:
                return Jet(o.tag, [(o.c[0] + self) % P] + o.c[1:])
        return Jet(self.tag, [(self.c[0] + o) % P] + self.c[1:])

    __radd__ = __add__

    def __neg__(self):
        return Jet(self.tag, [(-a) % P for a in self.c])

    def __sub__(self, o):
        return self + (-o)

    def __rsub__(self, o):
        return (-self) + o

    def __mul__(self, o):
        if type(o) is Jet:
            if o.tag == self.tag:
                n = len(self.c)
                out = []
                for k in range(n):
                    x = 0
                    for i in range(k + 1):
                        x = x + self.c[i] * o.c[k - i]
                    out.append(x % P)
                return Jet(self.tag, out)
            if o.tag > self.tag:
                return Jet(o.tag, [(a * self) % P for a in o.c])
        return Jet(self.tag, [(a * o) % P for a in self.c])

    __rmul__ = __mul__

    def __mod__(self, p):
        return self

    def inverse(self):
        first = inv(self.c[0])
        out = [first]
        for k in range(1, len(self.c)):
            x = 0
            for i in range(1, k + 1):
                x = x + self.c[i] * out[k - i]
            out.append((-(x * first)) % P)
        return Jet(self.tag, out)


def vanishes(x):
    while type(x) is Jet:
        x = x.c[0]
    return x == 0


def inv(x):
    if type(x) is int:
        if x == 0:
            raise ZeroDivisor()
        return pow(x, -1, P)
    return x.inverse()


def power(x, k):
    if k < 0:
        return power(inv(x), -k)
    if type(x) is int:
        return pow(x, k, P)
    out = 1
    while k:
        if k & 1:
            out = out * x
        x = x * x
        k >>= 1
    return out


def lift(x):
    return (x, 1)


def add(a, b):
    if type(a) is tuple or type(b) is tuple:
        if type(a) is not tuple:
            if len(b) != 2:
                raise Err("kind", "a number and a point of another dimension")
            a = (a, 1)
        elif type(b) is not tuple:
            if len(a) != 2:
                raise Err("kind", "a number and a point of another dimension")
            b = (b, 1)
        if len(a) != len(b):
            raise Err("kind", "different dimensions")
        return tuple((x + y) % P for x, y in zip(a, b))
    return (a + b) % P


def scale(a, b):
    """a times b where one of them is a number."""
    if type(a) is tuple:
        if type(b) is tuple:
            raise Err("kind", "a product of points")
        return tuple(x * b % P for x in a)
    if type(b) is tuple:
        return tuple(a * x % P for x in b)
    return a * b % P


def binomial(n, k):
    if k < 0 or k > n:
        return 0
    out = 1
    for i in range(min(k, n - k)):
        out = out * (n - i) // (i + 1)
    return out


def factorial(n):
    out = 1
    for i in range(2, n + 1):
        out *= i
    return out


def subsets_of(items, k):
    items = list(items)
    n = len(items)
    if k < 0 or k > n:
        return []
    out = []

    def grow(start, chosen):
        if len(chosen) == k:
            out.append(tuple(chosen))
            return
        for i in range(start, n - (k - len(chosen)) + 1):
            chosen.append(items[i])
            grow(i + 1, chosen)
            chosen.pop()

    grow(0, [])
    return out


def partitions_of(items):
    items = sorted(items)
    if not items:
        return [()]
    out = []
    first, rest = items[0], items[1:]
    for k in range(len(rest) + 1):
        for others in subsets_of(rest, k):
            left = [x for x in rest if x not in others]
            for more in partitions_of(left):
                out.append(((first,) + others,) + more)
    return out


def permutations_of(n):
    out = [()]
    for _ in range(n):
        out = [p + (x,) for p in out for x in range(1, n + 1) if x not in p]
    return out


def sign_of(p):
    s = 1
    for i in range(len(p)):
        for j in range(i):
            if p[j] > p[i]:
                s = -s
    return s


EXPONENTS = {}


def exponents(s, n):
    """All exponents of s variables with sum at most n."""
    key = (s, n)
    if key not in EXPONENTS:
        out = [()]
        for _ in range(s):
            out = [e + (k,) for e in out for k in range(n - sum(e) + 1)]
        EXPONENTS[key] = out
    return EXPONENTS[key]


LAGRANGE = {}
NODES = [pow(7, 1000 + 37 * k, PRIME) for k in range(60)]


def lagrange(m):
    """Nodes, and the matrix from values at them to coefficients."""
    key = (P, m)
    if key not in LAGRANGE:
        nodes = [x % P for x in NODES[:m]]
        rows = []
        for j in range(m):
            c = [1]
            d = 1
            for i in range(m):
                if i != j:
                    c = [((c[k - 1] if k else 0) - nodes[i] * (c[k] if k < len(c) else 0)) % P for k in range(len(c) + 1)]
                    d = d * (nodes[j] - nodes[i]) % P
            d = pow(d, -1, P)
            rows.append([x * d % P for x in c])
        LAGRANGE[key] = (nodes, rows)
    return LAGRANGE[key]


def square_root(a):
    """A square root modulo P, or None (Cipolla's algorithm)."""
    a %= P
    if a == 0:
        return 0
    if pow(a, (P - 1) // 2, P) != 1:
        return None
    if P % 4 == 3:
        return pow(a, (P + 1) // 4, P)
    t = 2
    while pow(t * t - a, (P - 1) // 2, P) != P - 1:
        t += 1
    w = (t * t - a) % P
    r, x = (1, 0), (t, 1)
    k = (P + 1) // 2
    while k:
        if k & 1:
            r = ((r[0] * x[0] + r[1] * x[1] % P * w) % P, (r[0] * x[1] + r[1] * x[0]) % P)
        x = ((x[0] * x[0] + x[1] * x[1] % P * w) % P, 2 * x[0] * x[1] % P)
        k >>= 1
    return r[0]


# names


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
        """A pattern where the names that stand for any integer are numbered."""
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
    """Values for what is free, made when asked for."""

    def __init__(self, rng, pool=None):
        self.vals = {}
        self.coefs = {}
        self.rng = rng
        self.pool = pool

    def number(self):
        if self.pool is not None:
            return self.rng.choice(self.pool) % P
        return self.rng.randrange(2, P)

    def fresh(self):
        return self.rng.randrange(2, P)


JET_TAG = [0]


class Case:
    """A block at one choice of its parameters."""

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

    def map_line(self, at, line):
        word = line[0]
        if word == "map":
            degrees = [self.count(e, self.penv) for e in line[3]]
            if line[2] == "one":
                dirs = [(1 if line[4] is None else self.count(line[4], self.penv), degrees[0])]
                if dirs[0][0] < 1:
                    raise Err("dimension")
            else:
                dirs = [(1, d) for d in degrees]
            if line[5] is not None and len(line[5][1]) != dirs[0][0] + 1:
                raise Err("arity", "points of the net")
            for name in line[1]:
                self.maps[name] = (dirs, "free" if line[5] is None else "net", line)
                self.position[name] = at
        elif word == "poly":
            degrees = [self.count(e, self.penv) for e in line[4]]
            if line[3] == "one":
                dirs = [(len(line[2]), degrees[0])]
            else:
                if len(degrees) != len(line[2]):
                    raise Err("arity", "degrees of poly")
                dirs = [(1, d) for d in degrees]
            self.maps[line[1]] = (dirs, "poly", line)
            self.position[line[1]] = at
        elif word == "raise":
            if line[1] not in self.maps:
                raise Err("not a map", line[1])
            old = self.maps[line[1]][0]
            degrees = [self.count(e, self.penv) for e in line[2]]
            if len(degrees) != len(old):
                raise Err("arity", "degrees of raise")
            for (s, n), m in zip(old, degrees):
                if m < n:
                    raise Err("degree", "raised to less")
            self.maps[line[3]] = ([(s, m) for (s, n), m in zip(old, degrees)], "raise", line)
            self.position[line[3]] = at

    def use(self, sample):
        self.a = sample
        self.memo = {}
        self.around = {}

    def spend(self, k=1):
        self.work -= k
        if self.work < 0:
            raise TooBig()

    # integers

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
                    self.deeper()
                    out = self.int_value(d[1], self.penv)
                    self.depth -= 1
                    return out
                raise Err("integer", n[1])
            index = tuple(self.integer(e, env) for e in n[2])
            clause = self.clause(n[1], index)
            if clause is None:
                raise Err("integer", n[1])
            self.deeper()
            out = self.int_value(clause[0], clause[1])
            self.depth -= 1
            return out
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

    def deeper(self):
        self.depth += 1
        if self.depth > 60:
            self.depth = 0
            raise Err("recursion")

    # sets: ('s', integers), ('S', sets of integers or of sets), ('p', permutations)

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

    # numbers and points

    def value(self, n, env):
        return getattr(self, "v_" + n[0])(n, env)

    def number(self, n, env):
        v = getattr(self, "v_" + n[0])(n, env)
        if type(v) is tuple:
            raise Err("kind", "a number expected")
        return v

    def v_num(self, n, env):
        text = n[1]
        if text.isdigit():
            return int(text) % P
        f = Fraction(text)
        return f.numerator * pow(f.denominator, -1, P) % P

    def v_name(self, n, env):
        base, indices = n[1], n[2]
        if indices is None:
            v = env.get(base)
            if v is not None:
                if v[0] == "i":
                    return v[1] % P
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
            key = (base, None)
            vals = self.a.vals
            if key not in vals:
                vals[key] = self.a.number()
            return vals[key]
        what = d[0]
        if what == "let":
            if self.around:
                self.deeper()
                v = self.value(d[1], {**self.penv, **self.around})
                self.depth -= 1
                return v
            memo = self.memo
            if base in memo:
                return memo[base]
            self.deeper()
            v = self.value(d[1], self.penv)
            self.depth -= 1
            memo[base] = v
            return v
        if what == "frame":
            s = self.count(d[2], self.penv)
            return tuple([1 if j == d[1] - 1 else 0 for j in range(s)]) + (1,)
        if what == "map":
            raise Err("a map is no number", base)
        return self.free((base, None), d)

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
                self.deeper()
                if self.around:
                    v = self.value(found[0], {**self.around, **found[1]})
                    self.depth -= 1
                    return v
                v = self.value(found[0], found[1])
                self.depth -= 1
                self.memo[key] = v
                return v
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
            key = (base, index)
            vals = self.a.vals
            if key not in vals:
                vals[key] = self.a.number()
            return vals[key]
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
            return tuple((-x) % P for x in v)
        return (-v) % P

    def v_add(self, n, env):
        a, b = self.value(n[1], env), self.value(n[2], env)
        if type(a) is int and type(b) is int:
            return (a + b) % P
        return add(a, b)

    def v_sub(self, n, env):
        a, b = self.value(n[1], env), self.value(n[2], env)
        if type(a) is int and type(b) is int:
            return (a - b) % P
        if type(b) is tuple:
            return add(a, tuple((-x) % P for x in b))
        if type(a) is tuple:
            if len(a) != 2:
                raise Err("kind", "a number and a point of another dimension")
            return ((a[0] - b) % P, (a[1] - 1) % P)
        return (a - b) % P

    def v_mul(self, n, env):
        a, b = self.value(n[1], env), self.value(n[2], env)
        if type(a) is int and type(b) is int:
            return a * b % P
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
                out = v if out is None else out * v % P
            elif out is None:
                out = v
            else:
                if (type(v) is tuple) != (type(out) is tuple):
                    raise Err("kind", "summands of two kinds")
                out = add(out, v)
        if which == "mean":
            out = scale(out, inv(len(items) % P))
        return out

    def v_fn(self, n, env):
        name, args = n[1], n[2]
        if name == "bernstein":
            i, k = self.integer(args[0], env), self.count(args[1], env)
            t = self.number(args[2], env)
            if i < 0 or i > k:
                return 0
            return binomial(k, i) * power(t, i) * power((1 - t) % P, k - i) % P
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
        return v % P

    def bspline(self, j, d, x, i, t):
        if i < j or i > j + d:
            return 0
        if d == 0:
            return 1
        out = 0
        if j <= i <= j + d - 1:
            low, high = self.knot(x, j), self.knot(x, j + d)
            out = (t - low) * inv((high - low) % P) % P * self.bspline(j, d - 1, x, i, t) % P
        if j + 1 <= i <= j + d:
            low, high = self.knot(x, j + 1), self.knot(x, j + d + 1)
            out = (out + (high - t) * inv((high - low) % P) % P * self.bspline(j + 1, d - 1, x, i, t)) % P
        return out

    def knot(self, x, k):
        v = self.member(x, (k,))
        if type(v) is tuple:
            raise Err("kind", "a knot is a number")
        return v

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
            return v.c[k] * factorial(k) % P
        return 0 if k else v

    def series(self, x, k):
        return [x] + [1] + [0] * (k - 1) if k else [x]

    # maps

    def coefficients(self, name):
        """The coefficients by exponents of a map."""
        dirs, kind, line = self.maps[name]
        if kind == "free":
            c = self.a.coefs.get(name)
            if c is None:
                c = self.a.coefs[name] = {e: self.a.number() for e in self.all_exponents(dirs)}
            return c
        if kind == "raise":
            return self.coefficients(line[1])
        key = ("map", name)
        if key not in self.memo:
            self.deeper()
            self.memo[key] = self.interpolated(name) if kind == "poly" else self.from_net(dirs[0], line[5], name)
            self.depth -= 1
        return self.memo[key]

    def all_exponents(self, dirs):
        if len(dirs) == 1:
            return exponents(*dirs[0])
        out = [()]
        for s, n in dirs:
            out = [a + b for a in out for b in exponents(s, n)]
            if len(out) > 400:
                raise TooBig()
        return out

    def interpolated(self, name):
        dirs, _, line = self.maps[name]
        variables, body = line[2], line[5]
        self.before(body, self.position[name], variables)
        grid = [n + 1 for s, n in dirs for _ in range(s)]
        size = 1
        for m in grid:
            size *= m
        self.spend(size)
        env = dict(self.penv)
        kind = self.kind(body, {**self.kind_env(env), **{v: "n" for v in variables}})
        if kind:
            raise Err("kind", "a poly of points")
        values = {}
        around = self.around
        self.around = {}
        index = [()]
        for m in grid:
            index = [i + (k,) for i in index for k in range(m)]
        tables = [lagrange(m) for m in grid]
        for i in index:
            for v, k, (nodes, _) in zip(variables, i, tables):
                env[v] = ("n", nodes[k])
            self.around = {v: env[v] for v in variables}
            values[i] = self.number(body, env)
        for at, (m, (_, rows)) in enumerate(zip(grid, tables)):
            fresh = {}
            for i in index:
                x = 0
                for k in range(m):
                    x = x + rows[k][i[at]] * values[i[:at] + (k,) + i[at + 1 :]]
                fresh[i] = x % P
            values = fresh
        # what is too high must vanish, and one more point must agree
        if len(dirs) == 1 and dirs[0][0] > 1:
            n = dirs[0][1]
            for i in index:
                if sum(i) > n:
                    if not same(values[i], 0):
                        raise Err("degree", "of poly")
                    del values[i]
        point = [self.a.fresh() for _ in variables]
        for v, x in zip(variables, point):
            env[v] = ("n", x)
        self.around = {v: env[v] for v in variables}
        expected = self.number(body, env)
        self.around = around
        found = 0
        for i, c in values.items():
            for x, k in zip(point, i):
                c = c * pow(x, k, P) % P
            found = (found + c) % P
        if not same(expected, found):
            raise Err("degree", "of poly")
        return values

    def before(self, e, at, bound=()):
        """A poly or net uses maps above it only."""
        for name in map_names(e):
            if name in self.position and self.position[name] >= at:
                raise Err("not declared", "map " + name + " is below")

    def from_net(self, direction, net, name):
        s, n = direction
        control, over = net
        rows = []
        for e in over:
            v = self.value(e, self.penv)
            if type(v) is not tuple:
                if s != 1:
                    raise Err("kind", "a point of the net")
                v = (v, 1)
            if len(v) != s + 1:
                raise Err("kind", "a point of the net")
            if not same(v[-1], 1):
                raise Err("kind", "mass of a point of the net")
            rows.append(v)
        inverse = inverse_matrix(rows)  # u = sum l_k P_k, l = u * inverse
        forms = []
        for k in range(s + 1):
            # l_k as a polynomial in the coordinates, mass 1
            f = {}
            for c in range(s):
                e = tuple(1 if j == c else 0 for j in range(s))
                f[e] = inverse[c][k]
            f[(0,) * s] = inverse[s][k]
            forms.append(f)
        out = {e: 0 for e in exponents(s, n)}
        for e in exponents(s, n):
            i = (n - sum(e),) + e
            index = i if s > 1 else (i[1],)
            c = self.member(control, index)
            if type(c) is tuple:
                raise Err("kind", "a point in a net")
            poly = {(0,) * s: c * multinomial(n, i) % P}
            for k in range(s + 1):
                for _ in range(i[k]):
                    poly = multiply(poly, forms[k])
            for x, y in poly.items():
                out[x] = (out[x] + y) % P
        return out

    def map_of(self, name, env):
        if name in env:
            raise Err("not a map", name)
        if name not in self.maps:
            raise Err("not a map", name)
        return self.maps[name][0]

    def homogeneous(self, v, s):
        if type(v) is not tuple:
            if s != 1:
                raise Err("kind", "a point expected")
            return (v, 1)
        if len(v) != s + 1:
            raise Err("kind", "dimension of an argument")
        return v

    def contract(self, name, dirs, weights):
        c = self.coefficients(name)
        if len(dirs) == 1:
            w = weights[0]
            out = 0
            for e, x in c.items():
                y = w.get(e)
                if y is not None:
                    out = out + x * y
            return out % P
        out = 0
        cuts = []
        at = 0
        for s, _ in dirs:
            cuts.append((at, at + s))
            at += s
        for e, x in c.items():
            for (i, j), w in zip(cuts, weights):
                y = w.get(e[i:j])
                if y is None:
                    x = 0
                    break
                x = x * y % P
            out = out + x
        return out % P

    def value_weights(self, u, s, n):
        if s == 1:
            x, m = u
            xs, ms = [1], [1]
            for _ in range(n):
                xs.append(xs[-1] * x % P)
                ms.append(ms[-1] * m % P)
            return {(k,): xs[k] * ms[n - k] % P for k in range(n + 1)}
        out = {}
        for e in exponents(s, n):
            w = power(u[-1], n - sum(e))
            for x, k in zip(u, e):
                if k:
                    w = w * power(x, k) % P
            out[e] = w
        return out

    def polar_weights(self, args, s, n):
        """The polar form of each monomial: the coefficient in the product of the arguments, over the number of its terms."""
        if s == 1:
            c = [1]
            for x, m in args:
                c = [((c[k] * m if k < len(c) else 0) + (c[k - 1] * x if k else 0)) % P for k in range(len(c) + 1)]
            return {(k,): c[k] * pow(binomial(n, k), -1, P) % P for k in range(n + 1)}
        poly = {(0,) * s: 1}
        for u in args:
            form = {tuple(1 if j == c else 0 for j in range(s)): u[c] for c in range(s)}
            form[(0,) * s] = u[s]
            poly = multiply(poly, form)
        return {e: x * pow(multinomial(n, (n - sum(e),) + e), -1, P) % P for e, x in poly.items()}

    def v_val(self, n, env):
        _, name, order, args = n
        self.spend()
        if name in env and env[name][0] == "p":
            return self.int_value(n, env) % P
        dirs = self.map_of(name, env)
        if order is None:
            if len(dirs) == 1 and dirs[0][0] > 1 and len(args) == dirs[0][0]:
                values = [self.number(a, env) for a in args]
                points = [tuple(values) + (1,)]
            else:
                if len(args) != len(dirs):
                    raise Err("arity", "arguments of " + name)
                points = [self.homogeneous(self.value(a, env), s) for a, (s, _) in zip(args, dirs)]
            return self.contract(name, dirs, [self.value_weights(u, s, d) for u, (s, d) in zip(points, dirs)])
        if order[0] == "primes":
            if len(dirs) != 1 or dirs[0][0] != 1:
                raise Err("kind", "a prime at a map of several variables")
            orders = [order[1]]
        elif len(dirs) == 1 and dirs[0][0] > 1:
            s, d = dirs[0]
            vectors = [self.homogeneous(self.value(e, env), s) for e in order[1]]
            for v in vectors:
                if not same(v[-1], 0):
                    raise Err("kind", "a derivative is along vectors")
            if len(args) != 1:
                raise Err("arity", "arguments of " + name)
            u = self.homogeneous(self.value(args[0], env), s)
            if not same(u[-1], 1):
                raise Err("kind", "a derivative is at a point")
            m = len(vectors)
            if m > d:
                return 0
            w = self.polar_weights([u] * (d - m) + vectors, s, d)
            return self.contract(name, dirs, [w]) * (factorial(d) // factorial(d - m)) % P
        else:
            if len(order[1]) != len(dirs):
                raise Err("arity", "orders of D")
            orders = [self.count(e, env) for e in order[1]]
        if len(args) != len(dirs):
            raise Err("arity", "arguments of " + name)
        weights = []
        for a, (s, d), k in zip(args, dirs, orders):
            u = self.homogeneous(self.value(a, env), 1)
            if not same(u[1], 1):
                raise Err("kind", "a derivative is at a point")
            w = {}
            x = 1
            for e in range(k, d + 1):
                w[(e,)] = x * (factorial(e) // factorial(e - k)) % P
                x = x * u[0] % P
            weights.append(w)
        return self.contract(name, dirs, weights)

    def v_blo(self, n, env):
        _, name, directions = n
        self.spend()
        dirs = self.map_of(name, env)
        if len(directions) != len(dirs):
            raise Err("arity", "directions of " + name)
        weights = []
        for given, (s, d) in zip(directions, dirs):
            args = []
            for a in given:
                self.arguments(a, env, args)
            if len(args) != d:
                raise Err("arity", "arguments of " + name)
            weights.append(self.polar_weights([self.homogeneous(v, s) for v in args], s, d))
        return self.contract(name, dirs, weights)

    def arguments(self, a, env, out):
        kind = a[0]
        if kind == "copies":
            k = self.count(a[2], env)
            if k == 0:
                self.seen.add("no copies")  # of what is not evaluated then
            else:
                out.extend([self.value(a[1], env)] * k)
        elif kind == "run":
            first, last = a[1], a[2]
            if first[0] != "name" or last[0] != "name" or first[2] is None or last[2] is None or first[1] != last[1]:
                raise Err("run", "of arguments")
            low = [self.integer(e, env) for e in first[2]]
            high = [self.integer(e, env) for e in last[2]]
            if low[:-1] != high[:-1] or len(low) != len(high):
                raise Err("run", "of arguments")
            if high[-1] < low[-1]:
                self.seen.add("empty run")
            for k in range(low[-1], high[-1] + 1):
                index = tuple(low[:-1]) + (k,)
                bound = env.get((first[1], index)) if self.members else None
                out.append(bound[1] if bound is not None else self.member(first[1], index))
        elif kind == "fam":
            _, e, binder, domain, filters = a
            inner = dict(env)
            for item in self.members_of(domain, env):
                inner[binder] = item
                if all(self.passes(f, inner) for f in filters):
                    out.append(self.value(e, inner))
        else:
            out.append(self.value(a, env))

    def passes(self, f, env):
        if f[0] == "!=":
            return self.int_value(f[1], env) != self.int_value(f[2], env)
        what, items = self.set_value(f[2], env)
        if what != "s":
            raise Err("kind", "set")
        return self.integer(f[1], env) not in items

    # kinds: 0 a number, d a point, vector or pair of dimension d, None unknown

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
        for _ in range(2):  # the second time with what the first found for the recursion
            for body, pattern in zip(bodies, patterns):
                env = {name: "i" for name in self.penv}
                for e in pattern:
                    if e[0] == "name" and e[2] is None:
                        env[e[1]] = "i"
                k = self.join(k, self.kind(body, env))
            known[key] = k
        return k


def map_names(e):
    if type(e) is tuple:
        if e and e[0] in ("val", "blo") and len(e) > 2 and type(e[1]) is str:
            yield e[1]
        for x in e:
            yield from map_names(x)


def multinomial(n, parts):
    out = factorial(n)
    for k in parts:
        out //= factorial(k)
    return out


def multiply(a, b):
    out = {}
    for e, x in a.items():
        for f, y in b.items():
            g = tuple(i + j for i, j in zip(e, f))
            out[g] = (out.get(g, 0) + x * y) % P
    return out


def same(a, b):
    if type(a) is tuple or type(b) is tuple:
        if type(a) is not tuple:
            a = (a, 1)
        if type(b) is not tuple:
            b = (b, 1)
        if len(a) != len(b):
            raise Err("kind", "sides of two dimensions")
        return all(same(x, y) for x, y in zip(a, b))
    d = (a - b) % P
    if type(d) is Jet:
        return all(same(x, 0) for x in d.c)
    return d == 0


def determinant(rows):
    n = len(rows)
    if n == 1:
        return rows[0][0]
    memo = {}

    def minor(r, columns):
        if r == n:
            return 1
        if columns in memo:
            return memo[columns]
        out = 0
        s = 1
        for k, c in enumerate(columns):
            out = (out + s * rows[r][c] * minor(r + 1, columns[:k] + columns[k + 1 :])) % P
            s = -s
        memo[columns] = out
        return out

    return minor(0, tuple(range(n)))


def inverse_matrix(rows):
    n = len(rows)
    d = determinant([list(r) for r in rows])
    if vanishes(d):
        raise ZeroDivisor()
    f = inv(d)
    if n == 1:
        return [[f]]
    out = [[0] * n for _ in range(n)]
    for i in range(n):
        for j in range(n):
            m = [[rows[r][c] for c in range(n) if c != j] for r in range(n) if r != i]
            x = determinant(m) * f % P
            out[j][i] = (-x) % P if (i + j) % 2 else x
    return out


# hypotheses


class Hypotheses:
    """The equations of a case and how to meet them."""

    def __init__(self, case):
        self.case = case
        self.equations = []
        self.assumptions = []
        for line in case.scope.block.lines:
            if line[0] == "given":
                for env in range_cases(case, line[3], case.penv):
                    self.equations.append((line, env, self.universal(line[4], env)))
            elif line[0] == "assume":
                for env in range_cases(case, line[3], case.penv):
                    self.assumptions.append((line, env))

    def universal(self, items, env):
        case = self.case
        out = []
        for item in items:
            if item[0] == "name" and item[2] is None:
                base = item[1]
                d = case.decl.get(base)
                if base in case.params or base == "delta" or d is not None and d[0] not in ("number", "point", "vector"):
                    raise Err("for all", base)
                out.append((base, d))
                continue
            first, last = (item, item) if item[0] == "name" else (item[1], item[2])
            if first[2] is None or last[2] is None or first[1] != last[1]:
                raise Err("run", "for all")
            low = [case.integer(e, env) for e in first[2]]
            high = [case.integer(e, env) for e in last[2]]
            d = case.decl.get(first[1] + "_")
            for k in range(low[-1], high[-1] + 1):
                index = tuple(low[:-1]) + (k,)
                if case.clause(first[1], index) is not None:
                    raise Err("for all", first[1])
                out.append(((first[1], index), d))
        if len({x[0] for x in out}) != len(out):
            raise Err("redeclared", "for all")
        if any(name in env for name, _ in out):
            raise Err("for all", "a range")
        return out

    def instance(self, equation):
        """An equation with values for its variables `for all`."""
        line, env, universal = equation
        if not universal:
            return (line, env)
        env = dict(env)
        rng = self.case.a.rng
        for key, d in universal:
            if d is None or d[0] == "number":
                env[key] = ("n", rng.randrange(2, P))
            else:
                s = self.case.count(d[1], self.case.penv)
                env[key] = ("g", tuple(rng.randrange(2, P) for _ in range(s)) + (1 if d[0] == "point" else 0,))
            if type(key) is tuple:
                self.case.members = True
        return (line, env)

    def residual(self, instance):
        line, env = instance
        self.case.around = {k: v for k, v in env.items() if v[0] in ("n", "g")}
        try:
            return difference(self.case, line, env)
        finally:
            self.case.around = {}

    def point(self, rng, order, pool=None):
        """A sample where all holds, or None."""
        case = self.case
        sample = Sample(rng, pool)
        case.use(sample)
        instances = []
        for eq in self.equations:
            for _ in range(2 if eq[2] else 1):
                instances.append((eq, self.instance(eq)))
        if self.equations and not self.solve(rng, order, instances):
            return None
        case.use(sample)
        for line, env in self.assumptions:
            if all(x == 0 for x in difference(case, line, env)):
                return None
        return sample

    def residuals(self, instances):
        self.case.memo = {}
        out = []
        for _, instance in instances:
            out.extend(self.residual(instance))
        return out

    def symbols(self, sample):
        maps, scalars = [], []
        for name, c in sample.coefs.items():
            maps.append([("c", name, e) for e in c])
        for key, v in sample.vals.items():
            if type(v) is tuple:
                scalars.extend([[("p", key, j)] for j in range(len(v) - 1)])
            else:
                scalars.append([("v", key)])
        return maps, scalars

    def shift(self, sample, symbol, by):
        if symbol[0] == "c":
            c = sample.coefs[symbol[1]]
            c[symbol[2]] = (c[symbol[2]] + by) % P
        elif symbol[0] == "v":
            sample.vals[symbol[1]] = (sample.vals[symbol[1]] + by) % P
        else:
            v = list(sample.vals[symbol[1]])
            v[symbol[2]] = (v[symbol[2]] + by) % P
            sample.vals[symbol[1]] = tuple(v)

    def affine(self, sample, group, instances, base):
        """Whether all residuals are affine along a random direction of these symbols."""
        direction = [(s, sample.rng.randrange(1, P)) for s in group]
        found = []
        try:
            for _ in range(2):
                for s, by in direction:
                    self.shift(sample, s, by)
                found.append(self.residuals(instances))
        except ZeroDivisor:
            found = None
        if found is None or len(found) < 2:
            raise ZeroDivisor()
        for s, by in direction:
            self.shift(sample, s, -2 * by)
        return all((c - 2 * b + a) % P == 0 for a, b, c in zip(base, *found))

    def solve(self, rng, order, instances, given=None):
        """Changes the sample so that the equations hold; a map or number in `given` stays as it is."""
        sample = self.case.a
        base = self.residuals(instances)
        if all(x == 0 for x in base):
            return True
        maps, scalars = self.symbols(sample)
        if given is not None:
            maps = [g for g in maps if g[0][1] not in given]
            scalars = [g for g in scalars if g[0][1] not in given]
        rng.shuffle(scalars)
        if order == "maps":
            groups = maps + scalars
        else:
            groups = maps + scalars
            rng.shuffle(groups)
        fixed = set()
        for _ in range(len(instances)):
            if not self.roots(sample, scalars, instances, fixed, rng, order):
                break
        base = self.residuals(instances)
        if all(x == 0 for x in base):
            return True
        chosen = []
        for group in groups:
            if group[0] in fixed:
                continue
            if self.affine(sample, chosen + group, instances, base):
                chosen = chosen + group
        if not chosen or not self.eliminate(sample, chosen, instances):
            return False
        # again, at other values of the variables `for all`
        for eq in self.equations:
            for _ in range(2 if eq[2] else 1):
                if any(x != 0 for x in self.fresh_residual(eq)):
                    return False
        return True

    def fresh_residual(self, eq):
        self.case.memo = {}
        return self.residual(self.instance(eq))

    def roots(self, sample, scalars, instances, fixed, rng, order):
        """Solves one equation of degree 2 in a number that no equation has affinely; True when one was solved."""
        for eq, instance in instances:
            if eq[2]:
                continue
            self.case.memo = {}
            r0 = self.residual(instance)
            if len(r0) != 1 or r0[0] == 0:
                continue
            candidates = []
            for group in scalars:
                s = group[0]
                if s in fixed:
                    continue
                values = [r0[0]]
                for k in range(3):
                    self.shift(sample, s, 1)
                    self.case.memo = {}
                    values.append(self.residual(instance)[0])
                self.shift(sample, s, -3)
                second = (values[2] - 2 * values[1] + values[0]) % P
                third = (values[3] - 3 * values[2] + 3 * values[1] - values[0]) % P
                if third == 0 and second == 0 and values[0] != values[1]:
                    candidates = None  # affine in this one: no root is needed
                    if order == "maps":
                        break
                    candidates = []
                    continue
                if third == 0 and second != 0:
                    candidates.append((s, values, second))
            if not candidates:
                continue
            s, values, second = candidates[0]
            a = second * pow(2, -1, P) % P
            b = (values[1] - values[0] - a) % P
            c = values[0]
            root = square_root((b * b - 4 * a * c) % P)
            if root is None:
                continue
            if rng.random() < 0.5:
                root = -root
            self.shift(sample, s, (root - b) * pow(2 * a, -1, P) % P)
            fixed.add(s)
            self.case.memo = {}
            return True
        return False

    def eliminate(self, sample, chosen, instances):
        n = len(chosen)
        if n > 150:
            raise TooBig()
        rows = []  # reduced rows: (pivot, row with n + 1 entries)
        plain = [i for eq, i in instances if not eq[2]]
        universal = [eq for eq in self.equations if eq[2]]

        def take(instance):
            """Adds the rows of an instance; 1 when something was new, 0 when not, -1 when it cannot hold."""
            self.case.memo = {}
            r0 = self.residual(instance)
            columns = []
            for s in chosen:
                self.shift(sample, s, 1)
                self.case.memo = {}
                columns.append(self.residual(instance))
                self.shift(sample, s, -1)
            self.case.memo = {}
            new = 0
            for k in range(len(r0)):
                row = [(c[k] - r0[k]) % P for c in columns] + [(-r0[k]) % P]
                for pivot, other in rows:
                    f = row[pivot]
                    if f:
                        row = [(x - f * y) % P for x, y in zip(row, other)]
                for pivot in range(n):
                    if row[pivot]:
                        break
                else:
                    if row[n]:
                        return -1
                    continue
                f = pow(row[pivot], -1, P)
                row = [x * f % P for x in row]
                for at, (q, other) in enumerate(rows):
                    g = other[pivot]
                    if g:
                        rows[at] = (q, [(x - g * y) % P for x, y in zip(other, row)])
                rows.append((pivot, row))
                new = 1
            return new

        for instance in plain:
            if take(instance) < 0:
                return False
        for eq in universal:
            old = 0
            while old < 2:
                found = take(self.instance(eq))
                if found < 0:
                    return False
                old = 0 if found else old + 1
        for pivot, row in rows:
            self.shift(sample, chosen[pivot], row[n])
        self.case.memo = {}
        return True


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
        return [(a - b) % P]
    if type(a) is not tuple or type(b) is not tuple:
        raise Err("kind", "sides of two kinds")
    if len(a) != len(b):
        raise Err("kind", "sides of two dimensions")
    return [(x - y) % P for x, y in zip(a, b)]


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


class Bounds(Case):
    """Only for the bounds of parameters."""

    def map_line(self, at, line):
        pass


class Line:
    """What is true of one claim or refute."""

    def __init__(self, place, kind):
        self.place = place
        self.kind = kind
        self.cases = []  # (params, ranges, status, reason)
        self.witnesses = []  # (case, env, sample)

    def statuses(self):
        return {c[2] for c in self.cases}

    def reasons(self):
        return sorted({c[3] for c in self.cases if c[3]})


class Decision:
    def __init__(self):
        self.lines = []
        self.error = None  # of the whole block
        self.points = 0
        self.free = set()  # names that nothing declares
        self.seen = set()  # corners that were met


def decide(block, points=4, seed=0, budget=400000, max_cases=4000):
    """The truth of every claim of a block: statuses true, false, error, novalue (no point was found), toobig."""
    global P
    out = Decision()
    out.lines = [Line(p, l[0]) for l, p in zip(block.lines, block.places) if l[0] in ("claim", "refute", "refute some")]
    P = PRIME
    if block.fault is not None:
        out.error = Err("syntax", str(block.fault))
        return out
    try:
        scope = Scope(block)
        choices = parameter_cases(block, scope)
        if len(choices) > max_cases:
            raise TooBig()
        total = 0
        for params in choices:
            for p in FIELDS:
                P = p
                total += decide_case(block, scope, params, out, points, seed, budget)
                if total > max_cases:
                    raise TooBig()
                # what was met in no field so far is tried in the next
                if p == FIELDS[-1] or not any(c[0] is params and c[2] == "novalue" for l in out.lines for c in l.cases):
                    break
                if not any(l[0] == "given" for l in block.lines):
                    break
                for l in out.lines:
                    l.cases = [c for c in l.cases if c[0] is not params]
                    l.witnesses = [w for w in l.witnesses if w[0].params is not params]
            P = PRIME
        if not choices:
            for l in out.lines:
                l.cases.append(({}, {}, "nocase", "no case"))
    except Err as e:
        out.error = e
    except TooBig:
        out.error = Err("too big")
    except RecursionError:
        out.error = Err("recursion")
    finally:
        P = PRIME
    for l in out.lines:
        if out.error is None and not l.cases:
            l.cases.append(({}, {}, "nocase", "no case"))
    return out


def check_kinds(case, block):
    """Kinds before values: every expression of the block, also where nothing is evaluated. The faults of claims by their lines."""
    faults = {}
    for at, line in enumerate(block.lines):
        try:
            check_kinds_of(case, line)
        except Err as e:
            case.members = None
            if line[0] not in ("claim", "refute", "refute some"):
                raise
            faults[at] = e
    return faults


def check_kinds_of(case, line):
    base = {name: "i" for name in case.penv}
    if line[0] == "let":
        if line[1][2] is None:
            case.bare_kind(line[1][1])
        else:
            case.family_kind(line[1][1])
    elif line[0] == "poly":
        if case.kind(line[5], {**base, **{v: "n" for v in line[2]}}):
            raise Err("kind", "a poly of points")
    elif line[0] in ("assume", "given", "claim", "refute", "refute some"):
        env = dict(base)
        for binder, _, _ in line[3]:
            env[binder] = "i"
        for item in line[4]:
            if item[0] == "name" and item[2] is None:
                d = case.decl.get(item[1])
                env[item[1]] = "n" if d is None or d[0] == "number" else ("g", case.count(d[1], case.penv)) if d[0] in ("point", "vector") else "n"
            else:
                base_name = item[1] if item[0] == "name" else item[1][1]
                d = case.decl.get(base_name + "_")
                env[(base_name, "any")] = "n" if d is None or d[0] == "number" else ("g", case.count(d[1], case.penv))
                case.members = True
        a, b = case.kind(line[1], env), case.kind(line[2], env)
        if a is not None and b is not None and a != b:
            raise Err("kind", "sides of two kinds")
        case.members = None


def decide_case(block, scope, params, out, points, seed, budget):
    scope.__dict__.pop("let_kinds", None)
    case = Case(scope, params, budget)
    text = repr(sorted(params.items()))
    rng = random.Random("%s %s %s" % (seed, block.id, text))
    faults = check_kinds(case, block)
    hypotheses = Hypotheses(case)
    work = []
    claims = [(at, l) for at, l in enumerate(block.lines) if l[0] in ("claim", "refute", "refute some")]
    for (at, line), result in zip(claims, out.lines):
        try:
            if at in faults:
                raise faults[at]
            for env in range_cases(case, line[3], case.penv):
                work.append([line, result, env, None, 0, None])
        except Err as e:
            result.cases.append((params, {}, "error", str(e)))
    if hypotheses.equations:
        plan = [("maps", None)] * points + [("any", None)] * points
        plan += [("any", "pool"), ("maps", "pool"), ("any", "pool")]
    elif hypotheses.assumptions:
        plan = [("maps", None)] * points
    else:
        plan = [("maps", None)] * points
    found = 0
    for order, pool in plan:
        if pool:
            a = rng.randrange(2, P)
            pool = [a, rng.randrange(2, P), a, 0, 1]
        sample = None
        for _ in range(3):
            try:
                sample = hypotheses.point(rng, order, pool)
            except ZeroDivisor:
                sample = None
                if not hypotheses.equations and not pool:
                    raise
            if sample is not None:
                break
        if sample is None:
            continue
        found += 1
        case.use(sample)
        case.members = None
        last = sample
        for item in work:
            line, result, env, status, good, reason = item
            if status == "error" or status == "false" and (not hypotheses.equations or len(result.witnesses) > 8):
                continue
            try:
                case.depth = 0
                d = difference(case, line, env)
            except ZeroDivisor as e:
                if not hypotheses.equations:
                    item[3], item[5] = "error", str(e)
                continue
            except Err as e:
                item[3], item[5] = "error", str(e)
                continue
            if all(x == 0 for x in d):
                item[4] += 1
            else:
                item[3] = "false"
                result.witnesses.append((case, env, sample, P))
    out.points += found
    out.seen |= case.seen
    if any(v == 0 for v in params.values()):
        out.seen.add("a parameter is 0")
    if found:
        for base, index in last.vals:
            if (base if index is None else base + "_") not in case.decl:
                out.free.add((base, index))
    for line, result, env, status, good, reason in work:
        ranges = {k: v[1] for k, v in env.items() if k not in params}
        if status is None:
            status = "true" if good else "novalue"
            reason = None if good else "no value meets the hypotheses"
        result.cases.append((params, ranges, status, reason))
    return max(1, len(work))


def readable(text):
    """What a prover prints, as this reader has it: 2 x with its sign, u_1.2 with braces."""
    return re.sub(r"_(\d+)(?=\.\d)", r"_{\1}", re.sub(r"(\d) ([A-Za-z])", r"\1*\2", text))


def conditions_hold(witness, conditions):
    """Whether all conditions, as a prover prints them, hold at a witness; None when one cannot be read."""
    global P
    case, env, sample, p = witness
    keep, P = P, p
    try:
        case.use(sample)
        case.depth = 0
        for text in conditions:
            try:
                op, a, b = parse_comparison(readable(text), dots=True)
                x, y = case.value(a, case.penv), case.value(b, case.penv)
                if op == "!=" and same(x, y):
                    return False
            except ZeroDivisor:
                return False
            except (Err, SyntaxFault, KeyError, IndexError, TooBig):
                return None
        return True
    finally:
        P = keep


def expanded(e, variables, s):
    """A polynomial in these variables as coefficients by exponents."""
    kind = e[0]
    zero = (0,) * s
    if kind == "num":
        f = Fraction(e[1])
        return {zero: f.numerator * pow(f.denominator, -1, P) % P}
    if kind == "name" and e[2] is None and e[1] in variables:
        at = variables.index(e[1])
        return {tuple(1 if j == at else 0 for j in range(s)): 1}
    if kind == "neg":
        return {k: -x % P for k, x in expanded(e[1], variables, s).items()}
    if kind in ("add", "sub"):
        out = dict(expanded(e[1], variables, s))
        f = 1 if kind == "add" else -1
        for k, x in expanded(e[2], variables, s).items():
            out[k] = (out.get(k, 0) + f * x) % P
        return out
    if kind == "mul":
        return multiply(expanded(e[1], variables, s), expanded(e[2], variables, s))
    if kind == "div" and e[2][0] == "num":
        f = pow(int(e[2][1]), -1, P)
        return {k: x * f % P for k, x in expanded(e[1], variables, s).items()}
    if kind == "pow" and e[2][0] == "num":
        out = {zero: 1}
        base = expanded(e[1], variables, s)
        for _ in range(int(e[2][1])):
            out = multiply(out, base)
        return out
    raise Err("a map that cannot be read")


def rational(text):
    f = Fraction(text)
    return f.numerator * pow(f.denominator, -1, P) % P


def check_counterexample(block, place, example, seed=0):
    """Whether the values a prover shows make a line false: True, or a text that says what is wrong; None when they cannot be read."""
    try:
        scope = Scope(block)
        parameters = example.get("parameters", {})
        params = {line[1]: int(parameters[line[1]]) for line in block.lines if line[0] == "for"}
        case = Case(scope, params)
        line = [l for l, p in zip(block.lines, block.places) if p == place][0]
        env = dict(case.penv)
        for binder, _, _ in line[3]:
            if binder in params:
                return None
            env[binder] = ("i", int(parameters[binder]))
        if env not in range_cases(case, line[3], case.penv):
            return "parameters out of their ranges"
        sample = Sample(random.Random("%s counterexample" % seed))
        case.use(sample)
        given = set()
        for name, shown in example.get("maps", {}).items():
            if name not in case.maps:
                return None
            dirs, kind, _ = case.maps[name]
            if kind != "free":
                continue
            s = sum(d for d, _ in dirs)
            text = re.sub(r"(\d) ?([A-Za-z])", r"\1*\2", re.sub(r"([A-Za-z])(\d+)", lambda m: m.group(1) + "QQ" + "ABCDEFGHIJ"[int(m.group(2))], shown["text"]))
            variables = [re.sub(r"([A-Za-z])(\d+)", lambda m: m.group(1) + "QQ" + "ABCDEFGHIJ"[int(m.group(2))], v) for v in shown.get("variables", ["t"])]
            if len(variables) != s:
                return None
            found = expanded(parse_expr(text), variables, s)
            allowed = set(case.all_exponents(dirs))
            if any(x and e not in allowed for e, x in found.items()):
                return "a map of too high a degree"
            sample.coefs[name] = {e: found.get(e, 0) for e in allowed}
            given.add(name)
        points = {}
        for name, text in example.get("variables", {}).items():
            node = parse_expr(readable(name), dots=True)
            value = rational(text)
            if node[0] == "symbol":
                index = None if node[1][2] is None else tuple(case.integer(e, case.penv) for e in node[1][2])
                if index is None and node[1][1] in case.maps:
                    return None
                points.setdefault((node[1][1], index), {})[node[2][0]] = value
            elif node[0] == "name":
                index = None if node[2] is None else tuple(case.integer(e, case.penv) for e in node[2])
                sample.vals[node[1], index] = value
                given.add((node[1], index))
            else:
                return None
        for key, shown in points.items():
            d = case.decl.get(key[0] if key[1] is None else key[0] + "_")
            if d is None or d[0] not in ("point", "vector"):
                return None
            v = list(case.free(key, d))
            for at, x in shown.items():
                v[at - 1] = x
            sample.vals[key] = tuple(v)
            given.add(key)
        hypotheses = Hypotheses(case)
        instances = [(eq, hypotheses.instance(eq)) for eq in hypotheses.equations for _ in range(2 if eq[2] else 1)]
        if instances and not hypotheses.solve(sample.rng, "maps", instances, given):
            missing = bool({k for k in sample.vals if k not in given} | {k for k in sample.coefs if k not in given})
            return None if missing else "a hypothesis does not hold"
        case.use(sample)
        for other, e in hypotheses.assumptions:
            if all(x == 0 for x in difference(case, other, e)):
                return "an assumption does not hold"
        if all(x == 0 for x in difference(case, line, env)):
            return "both sides are equal"
        return True
    except ZeroDivisor:
        return "a divisor vanishes"
    except (Err, SyntaxFault, KeyError, IndexError, ValueError, TooBig):
        return None


def lost_condition(block, decision, line_number, conditions, seed=0, tries=6):
    """A point with small coinciding values where a divisor of a proved claim vanishes and all its conditions hold."""
    rng = random.Random("%s conditions" % seed)
    lines = [(l, r) for l, r in zip([x for x in block.lines if x[0] in ("claim", "refute", "refute some")], decision.lines)]
    scope = Scope(block)
    for params in parameter_cases(block, scope)[-2:]:
        case = Case(scope, params)
        if any(l[0] == "given" for l in block.lines):
            return None
        for line, result in lines:
            if result.place != line_number:
                continue
            for env in range_cases(case, line[3], case.penv)[-3:]:
                for _ in range(tries):
                    a = rng.randrange(2, P)
                    sample = Sample(rng, [0, 0, 1, a, a, -a, rng.randrange(2, P)])
                    case.use(sample)
                    try:
                        case.depth = 0
                        difference(case, line, env)
                        continue
                    except ZeroDivisor:
                        pass
                    except (Err, TooBig):
                        break
                    assumed = True
                    for other in block.lines:
                        if other[0] == "assume":
                            for e in range_cases(case, other[3], case.penv):
                                try:
                                    if all(x == 0 for x in difference(case, other, e)):
                                        assumed = False
                                except ZeroDivisor:
                                    assumed = False
                    if assumed and conditions_hold((case, env, sample, P), conditions):
                        return {k: v for k, v in sample.vals.items()}
    return None


def prove(blocks, path, out):
    """What a prover that is always right would print with --json: `check` must find nothing in it."""
    import json

    for block in blocks:
        decision = decide(block)
        if block.fault is not None:
            continue
        for l in decision.lines:
            o = {"id": block.id, "file": path, "line": l.place, "kind": l.kind.split()[0], "conditions": []}
            statuses = l.statuses()
            if decision.error is not None or statuses - {"true", "false"}:
                o.update(verdict="undecided", as_expected=False, error=str(decision.error or "; ".join(l.reasons())))
            else:
                proved = statuses == {"true"}
                expected = {"claim": proved, "refute": statuses == {"false"}, "refute some": not proved}[l.kind]
                o.update(verdict="proved" if proved else "refuted", as_expected=expected)
            out.write(json.dumps(o) + "\n")


def main(arguments):
    import sys
    import time

    as_prover = arguments[:1] == ["prove"]
    for path in [a for a in arguments if a not in ("prove", "--json")]:
        with open(path) as f:
            blocks = parse_text(f.read())
        if as_prover:
            prove(blocks, path, sys.stdout)
            continue
        for block in blocks:
            start = time.time()
            decision = decide(block)
            spent = (time.time() - start) * 1000
            if decision.error:
                print("%s: %s (%.1f ms)" % (block.id, decision.error, spent))
            for l in decision.lines:
                print(
                    "%s:%d %s %s %s (%d cases, %.1f ms)"
                    % (block.id, l.place, l.kind, ",".join(sorted(l.statuses())), "; ".join(l.reasons()), len(l.cases), spent)
                )


if __name__ == "__main__":
    import sys

    main(sys.argv[1:])
