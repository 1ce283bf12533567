"""Numbers, points and polynomials over a large prime field.

A number is an integer modulo `P`, or a Jet: a truncated power series in one more unknown. A point or vector is a tuple of its
coordinates and its mass; a polynomial is a dictionary from exponents to coefficients.
"""

from fractions import Fraction

from faults import Err, ZeroDivisor

PRIME = (1 << 61) - 1  # 3 mod 4, 7 mod 8


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


P = PRIME  # the current field
# In some of these fields -1, 2, 3, 5 and so on have square roots; a number without one in a field is tried in the next.
FIELDS = [PRIME] + primes_below(1 << 61, 3, 1)


def choose(prime):
    """From now on, computes modulo this prime."""
    global P
    P = prime


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


def rational(text):
    """A number as text."""
    if text.isdigit():
        return int(text) % P
    f = Fraction(text)
    return f.numerator * pow(f.denominator, -1, P) % P


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
    """a times b, where one of them is a number."""
    if type(a) is tuple:
        if type(b) is tuple:
            raise Err("kind", "a product of points")
        return tuple(x * b % P for x in a)
    if type(b) is tuple:
        return tuple(a * x % P for x in b)
    return a * b % P


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


def multiply(a, b):
    out = {}
    for e, x in a.items():
        for f, y in b.items():
            g = tuple(i + j for i, j in zip(e, f))
            out[g] = (out.get(g, 0) + x * y) % P
    return out


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


LAGRANGE = {}
NODES = [pow(7, 1000 + 37 * k, PRIME) for k in range(60)]


def lagrange(m):
    """Nodes, and the matrix that maps the values at the nodes to coefficients."""
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
