"""Random identities of polar forms that are true by construction, and similar false ones.

Each begins with a true statement of a family (OLD and NEW below) with random parts that prefer corner cases (n = 0, empty sums,
repeated arguments, equal names). It is rewritten by steps that preserve its truth, and has a variant with one change that the
oracle finds false.

    generate(index, seed, new)  ->  [(Block, expected, features)], expected 'true', 'false' or 'error'
"""

import random

from language import STATEMENTS, parse_expr, parse_text, show
from mutations import (
    changed, copy_of, count_off_by_one, exchange_kind, lost_factor, lost_summand, nodes, number, off_by_one, other_name, replace, sign,
    sum_bound, swap,
)
from oracle import decide

SCALARS = ["a", "b", "c", "s", "t", "u", "v", "w", "x", "y", "z", "h"]
BINDERS = ["i", "j", "k", "t", "n", "m", "x", "N"]


# names within expressions


def free_names(e, bound=frozenset()):
    """Bare names that no binder inside the expression binds."""
    out = set()
    if type(e) is not tuple or not e:
        return out
    kind = e[0]
    if kind == "name":
        if e[2] is None:
            return set() if e[1] in bound else {e[1]}
        for x in e[2]:
            out |= free_names(x, bound)
        return out
    if kind == "agg":
        out |= free_names(e[3], bound)
        return out | free_names(e[4], bound | {e[2]})
    if kind == "det":
        out |= free_names(e[3], bound)
        return out | free_names(e[4], bound | {e[1], e[2]})
    if kind == "fam":
        out |= free_names(e[3], bound)
        inner = bound | {e[2]}
        out |= free_names(e[1], inner)
        for f in e[4]:
            out |= free_names(f[1], inner) | free_names(f[2], inner)
        return out
    if kind == "dif":
        return free_names(e[1], bound) | free_names(e[2], bound) | (free_names(e[3], bound) if e[3] else set())
    if kind in ("val", "blo"):
        out.add(e[1]) if e[1] not in bound else None
    for x in e:
        if type(x) is tuple:
            out |= free_names(x, bound)
    return out


def has_binder(e):
    return any(x[0] in ("agg", "fam", "det", "dif") for _, x in nodes(e))


def substituted(e, name, new):
    """e with a free bare name replaced; None if a binder would capture it or a family of bound members is involved."""
    if type(e) is not tuple or not e:
        return e
    kind = e[0]
    if kind == "name":
        if e[2] is None:
            return new if e[1] == name else e
        return ("name", e[1], substituted(e[2], name, new))
    if kind in ("agg", "fam", "det"):
        binders = {e[2]} if kind != "det" else {e[1], e[2]}
        if kind == "agg":
            body = e[4] if name in binders else substituted(e[4], name, new)
            if name not in binders and name in free_names(e[4]) and binders & free_names(new):
                raise Capture()
            return ("agg", e[1], e[2], substituted(e[3], name, new), body)
        if kind == "fam":
            if name in binders:
                return ("fam", e[1], e[2], substituted(e[3], name, new), e[4])
            if binders & free_names(new):
                raise Capture()
            return ("fam", substituted(e[1], name, new), e[2], substituted(e[3], name, new), substituted(e[4], name, new))
        raise Capture()
    if kind == "dif":
        raise Capture()
    return tuple(substituted(x, name, new) if type(x) is tuple else x for x in e)


class Capture(Exception):
    pass


# random text


class Maker:
    def __init__(self, rng, new):
        self.r = rng
        self.new = new
        self.features = set()
        self.slopes = {}

    def pick(self, *xs):
        return self.r.choice(xs)

    def scalar(self, without=()):
        return self.r.choice([x for x in SCALARS if x not in without])

    def scalars(self, k, without=()):
        return self.r.sample([x for x in SCALARS if x not in without], k)

    def small(self):
        return str(self.r.choice((0, 1, 1, 2, 2, 3)))

    def weight(self, x, without=()):
        """A polynomial or fraction in other names."""
        y, z = self.scalars(2, (x,) + tuple(without))
        return self.pick(y, y, "2*%s" % y, "%s/%s" % (y, z), "(%s - %s)" % (y, z), "(1 + %s)" % y, "3", "1/2", "%s^2" % y)

    def affine(self, x, without=()):
        """An argument such as 2*t/w + 1, affine in x."""
        self.features.add("fraction")
        y, z = self.scalars(2, (x,) + tuple(without))
        text, slope = self.pick(
            ("2*{x}/{z} + 1", "2/{z}"), ("{x}/{z}", "1/{z}"), ("({x} - {y})/({z} - {y})", "1/({z} - {y})"), ("{x} + {y}", "1"), ("{x}", "1"),
            ("1 - {x}", "(-1)"), ("{y}*{x} - 1/{z}", "{y}"), ("-{x}", "(-1)"), ("({x} + {y})/2", "1/2"), ("{x}/3", "1/3"),
            ("(2*{x} + {y})/(1 + {z})", "2/(1 + {z})"), ("3*{x}/({y}*{z})", "3/({y}*{z})"), ("({x}/{y} + 1)/{z}", "1/({y}*{z})"),
        )
        text, slope = text.format(x=x, y=y, z=z), slope.format(x=x, y=y, z=z)
        self.slopes[text, x] = "(" + slope + ")"
        return text

    def slope(self, text, x):
        """The coefficient of x in an argument that was generated."""
        return self.slopes[text, x]

    def range(self, name, low=None, high=None):
        low = self.r.choice((0, 0, 0, 1)) if low is None else low
        high = low + self.r.choice((0, 1, 2, 2)) if high is None else high
        if low == 0:
            self.features.add("n = 0")
        return "for %s in %d..%d" % (name, low, high)

    def arguments(self, n, tag="t"):
        """The text of exactly n arguments, n a name or a sum in parentheses; numbers or pairs of dimension 1."""
        x, y, w = self.scalars(3)
        k = self.r.randrange(9)
        self.features.add("blossom")
        if k == 0:
            return "%s_1..%s_{%s}" % (tag, tag, n)
        if k == 1:
            self.features.add("copies")
            return "%s{%s}" % (self.pick(x, "<%s, %s>" % (x, y), "%s + %s*delta" % (x, y), "delta", "%s/%s" % (x, y), "0", "1"), n)
        if k == 2:
            self.features.add("family")
            return "%s_i : i in 1..%s" % (tag, n)
        if k == 3:
            self.features.add("pairs")
            return "<%s_i, %s_i> : i in 1..%s" % (tag, w, n)
        if k == 4:
            return "%s_{i+1} : i in 0..%s - 1" % (tag, n)
        if k == 5:
            self.features.add("family")
            return "%s_i + %s*delta : i in 1..%s" % (tag, x, n)
        if k == 6:
            return "%s_i/%s : i in 1..%s" % (tag, x, n)
        if k == 7:
            self.features.add("family")
            b = self.r.choice(BINDERS[:1] + ["j", "k"])
            return "%s_%s : %s in 1..%s + 1, %s != %s" % (tag, b, b, n, b, self.pick("1", "%s + 1" % n))
        return "%s*%s_i : i in 1..%s" % (x, tag, n)


# families: each returns (previous lines, claims)


def diagonal(m):
    e = m.affine(m.scalar())
    return [m.range("n"), "map p degree n"], ["p(%s) == p[%s{n}]" % (e, e)]


def symmetric(m):
    d = m.r.randrange(2, 5)
    args = []
    for k in range(d):
        x, y = m.scalars(2)
        args.append(m.pick(x, "t_%d" % (k + 1), "<%s, %s>" % (x, y), "delta", m.affine(x), "0", "1", x))
    other = list(args)
    m.r.shuffle(other)
    m.features.add("blossom")
    return ["map p degree %d" % d], ["p[%s] == p[%s]" % (", ".join(args), ", ".join(other))]


def multiaffine(m):
    x, y, a = m.scalars(3)
    rest = m.arguments("n")
    first = m.pick("(1 - {a})*{x} + {a}*{y}", "{x} + {a}*({y} - {x})", "({x} - {a}*{x} + {a}*{y})").format(x=x, y=y, a=a)
    return [m.range("n"), "map p degree n + 1"], [
        "p[%s, %s] == (1 - %s)*p[%s, %s] + %s*p[%s, %s]" % (first, rest, a, x, rest, a, y, rest)
    ]


def multilinear(m):
    u, v, x, y, c = m.scalars(5)
    rest = m.arguments("n")
    m.features.add("pairs")
    c = m.weight(u)
    return [m.range("n"), "map p degree n + 1"], [
        "p[%s*<%s, %s> + <%s, %s>, %s] == %s*p[<%s, %s>, %s] + p[<%s, %s>, %s]" % (c, u, v, x, y, rest, c, u, v, rest, x, y, rest)
    ]


def homogeneous(m):
    t, w, c = m.scalars(3)
    m.features.add("homogeneous")
    return [m.range("n"), "map p degree n"], [
        m.pick(
            "p(<{t}, {w}>) == {w}^n*p({t}/{w})", "p({c}*<{t}, {w}>) == {c}^n*p(<{t}, {w}>)", "p(<{t}, 1>) == p({t})",
            "p(<{t}, {w}> + <{c}, 0>) == p(<{t} + {c}, {w}>)", "p[<{t}, {w}>{{0}}, <{t}, {w}>{{n}}] == p(<{t}, {w}>)",
        ).format(t=t, w=w, c=c)
    ]


def derivative(m):
    e = m.affine(m.scalar())
    m.features.add("derivative")
    return [m.range("n"), "for k in 0..n", "map p degree n"], [
        "D(p, k)(%s) == factorial(n)/factorial(n - k)*p[%s{n-k}, delta{k}]" % (e, e)
    ]


def beyond(m):
    e = m.affine(m.scalar())
    m.features.add("derivative")
    return [m.range("n"), "map p degree n"], ["D(p, n + 1)(%s) == %s" % (e, m.pick("0", "sum(i, 1, 0, i)", "(%s) - (%s)" % (e, e)))]


def chain(m):
    t, x = m.scalars(2)
    e = m.affine(t, (x,))
    at = m.affine(x)
    k = m.r.choice((0, 1, 1, 2, 3))
    inner = show(substituted(parse_expr(e), t, parse_expr(at)))
    m.features |= {"derivative", "chain", "derivative at a fraction", "nested poly"}
    left = {1: "g'(%s)", 2: "g''(%s)"}.get(k, "D(g, %d)(%%s)" % k) % at
    return [m.range("n"), "map f degree n", "poly g(%s) degree n = f(%s)" % (t, e)], [
        "%s == %s^%d*D(f, %d)(%s)" % (left, m.slope(e, t), k, k, inner)
    ]


def chain_twice(m):
    t, s, x = m.scalars(3)
    e = m.affine(t, (s, x))
    d = m.affine(s, (t, x))
    m.features |= {"derivative", "chain", "nested poly", "derivative at a fraction"}
    twice = show(substituted(parse_expr(e), t, parse_expr(d))) if t not in free_names(parse_expr(d)) else None
    if twice is None:
        raise Capture()
    at = m.affine(x, (s, t))
    inner = show(substituted(parse_expr(twice), s, parse_expr(at)))
    return [m.range("n"), "map f degree n", "poly g(%s) degree n = f(%s)" % (t, e), "poly G(%s) degree n = g(%s)" % (s, d)], [
        "G'(%s) == %s*%s*f'(%s)" % (at, m.slope(e, t), m.slope(d, s), inner),
        "G(%s) == f(%s)" % (at, inner),
    ]


def product_rule(m):
    t, x = m.scalars(2)
    at = m.affine(x)
    m.features |= {"derivative", "nested poly", "derivative at a fraction"}
    return [m.range("n"), "map f, g degree n", "poly p(%s) degree 2*n = f(%s)*g(%s)" % (t, t, t)], [
        "D(p, k)({e}) == sum(i, 0, k, binomial(k, i)*D(f, i)({e})*D(g, k - i)({e})) for k in 0..2".format(e=at)
    ]


def power_rule(m):
    t, x, c = m.scalars(3)
    at = m.affine(x, (c,))
    m.features |= {"derivative", "derivative at a fraction"}
    return [m.range("n", 1), "poly p(%s) degree n = (%s - %s)^n" % (t, t, c)], ["p'(%s) == n*(%s - %s)^(n-1)" % (at, at, c)]


def taylor(m):
    x, h = m.scalars(2)
    e = m.affine(x, (h,))
    m.features |= {"derivative", "derivative at a fraction"}
    h2 = m.pick(h, "2*" + h, h + "/3")
    return [m.range("n"), "map p degree n"], ["p(%s + %s) == sum(k, 0, n, D(p, k)(%s)/factorial(k)*(%s)^k)" % (e, h2, e, h2)]


def let_in_poly(m):
    t, x = m.scalars(2)
    y = m.scalar((t, x))
    body = m.pick(t, "%s + 1" % t, "%s*%s" % (t, y), "1/%s" % t, "sum(i, 1, 2, %s^i)" % t)
    poly = m.pick("w", "w*{t}", "w*{t}^2 + {t}", "w + {t}", "(w + {t})^2").format(t=t)
    m.features |= {"let in poly", "capture"}
    if "w" in (t, x, y):
        raise Capture()
    if "/" in body:
        raise Capture()  # the poly would not be one
    expected = show(substituted(parse_expr(poly.replace("w", "(" + body + ")")), t, parse_expr(x)))
    return ["let w = " + body, "poly P(%s) degree 4 = %s" % (t, poly)], [
        "P(%s) == %s" % (x, expected), "w == " + body, "P[%s{4}] == P(%s)" % (x, x),
    ][: m.r.choice((1, 2, 3))]


def nested_let(m):
    a, b, t = m.scalars(3)
    m.features.add("let")
    return ["let p = %s*q + %s" % (a, b), "let q = %s - r_1" % t, "let r_k = k*%s" % b], [
        "p == %s*(%s - %s) + %s" % (a, t, b, b)
    ]


def hidden(m):
    """Binders that hide names."""
    x, y = m.scalars(2)
    m.features.add("hidden name")
    return [m.range("n")], [
        m.pick(
            "sum({x}, 1, n, {x})*{x} == n*(n + 1)/2*{x}", "sum(n, 1, 3, n) == 6", "sum({x}, 0, 2, {y}*{x}^2) == 5*{y}",
            "sum(i, 0, n, sum(i, 0, n, i)) == (n + 1)*n*(n + 1)/2", "prod({x}, 1, n, {y}) == {y}^n",
            "sum({x}, 0, n, {x}_{x}) == sum(i, 0, n, {x}_i)", "sum(i, 0, n, sum(n, 0, i, n)) == sum(i, 0, n, i*(i + 1)/2)",
            "{x}_n + {x} == {x} + {x}_n",
        ).format(x=x, y=y)
    ]


def poly_variable(m):
    """A poly whose variable has the name of a free name that is also used."""
    t, x = m.scalars(2)
    m.features.add("capture")
    return [m.range("n"), "poly P(%s) degree n + 1 = %s^n*%s + %s" % (t, t, x, t)], [
        "P(%s) == %s^n*%s + %s" % (t, t, x, t),
        "P({a}) == ({a})^n*{x} + {a}".format(a=m.affine(x), x=x),
    ]


def poly_of_poly(m):
    t, s, x = m.scalars(3)
    m.features.add("nested poly")
    return [
        "poly A(%s) degree 1 = %s*%s + 1" % (t, x, t), "poly B(%s) degree 1 = A(%s) - %s" % (t, t, s),
        "poly C(%s) degree 2 = A(B(%s))*%s" % (s, s, m.pick("1", "2^0", "A(%s)^0" % x)),
    ], ["B(%s) == %s*%s + 1 - %s" % (x, x, x, s), "A(B(t_1)) == %s*B(t_1) + 1" % x, "C(t_1) == A(B(t_1))"]


def pairs_sum(m):
    n_low = m.r.choice((0, 0, 1))
    m.features |= {"pairs", "empty sum"}
    rest = m.pick("s", "<s, w>", "delta", "0")
    k = m.r.randrange(4)
    if k == 0:
        return [m.range("n", n_low), "map p degree 2"], ["p[%s, sum(i, 1, n, <x_i, y_i>)] == sum(i, 1, n, p[%s, <x_i, y_i>])" % (rest, rest)]
    if k == 1:
        return [m.range("n", n_low), "map p degree 2"], ["p[%s, sum(i, 1, n, h_i*delta)] == sum(i, 1, n, h_i)*p[%s, delta]" % (rest, rest)]
    if k == 2:
        return [m.range("n", n_low), "map p degree 1"], ["p(sum(i, 1, n, <x_i, y_i>)) == sum(i, 1, n, p(<x_i, y_i>))"]
    return [m.range("n", n_low), "map p degree 2"], ["p(sum(i, 2, n, x_i*delta)) == sum(i, 2, n, x_i)^2*p[delta, delta]"]


def polarization(m):
    m.features |= {"subsets", "pairs", "empty sum"}
    k = m.r.randrange(4)
    if k == 0:
        return [m.range("n", 1, m.r.choice((1, 2, 3))), "map f degree n"], [
            "factorial(n)*f[<u_i, m_i> : i in 1..n] == sum(k, 0, n, sum(S, subsets(n, k), (-1)^(n-k)*f(sum(i, S, <u_i, m_i>))))"
        ]
    if k == 1:
        return [m.range("n", 1, 3), "map b degree n"], [
            "b[t_1..t_n] == sum(N, 1, n, (-1)^(n-N)*N^n*sum(S, subsets(n, N), b(mean(i, S, t_i))))/factorial(n)"
        ]
    if k == 2:
        return [m.range("n", 0, 3), "map f degree n"], [
            "factorial(n)*f[h_i*delta : i in 1..n] == sum(k, 0, n, sum(S, subsets(n, k), (-1)^(n-k)*f(sum(i, S, h_i*delta))))"
        ]
    return [m.range("n", 0, 3), "for k in 0..n", "map p degree n"], [
        "sum(S, subsets(n, k), p[s : i in without(n, S), delta : i in S]) == binomial(n, k)*p[s{n-k}, delta{k}]"
    ]


def subset_sums(m):
    m.features |= {"subsets", "n = 0", "empty sum"}
    x, y = m.scalars(2)
    return [m.range("n", 0, m.r.choice((0, 1, 2, 3)))], [
        m.pick(
            "sum(k, 0, n, sum(S, subsets(n, k), prod(i, S, {x}_i))) == prod(i, 1, n, 1 + {x}_i)",
            "sum(k, 0, n, sum(S, subsets(n, k), {x}^size(S))) == (1 + {x})^n",
            "sum(k, 0, n, sum(S, subsets(n, k), sum(i, S, {x}_i))) == sum(i, 1, n, {x}_i)*2^n/2",
            "sum(S, subsets(n, n + 1), {x}) == sum(S, subsets(n, -1), {y})",
            "sum(k, 0, n, sum(S, subsets(n, k), prod(i, without(n, S), {x}_i)*{y}^k)) == prod(i, 1, n, {x}_i + {y})",
            "sum(S, subsets(n, 0), {x} + sum(i, S, {y}_i)) == {x}",
            "sum(k, 0, n, sum(S, subsets(n, k), (-1)^k)) == 0^n",
            "sum(S, subsets(n, 1), mean(i, S, {x}_i)) == sum(i, 1, n, {x}_i)",
            "prod(i, 1, n, {x}_i)*sum(S, subsets(n, n), 1) == prod(S, subsets(n, 1), prod(i, S, {x}_i))",
            "sum(k, 0, n, binomial(n, k)*{x}^k*{y}^(n-k)) == ({x} + {y})^n",
            "sum(i, 0, n, bernstein(i, n, {x})*{y}^i) == (1 - {x} + {x}*{y})^n",
        ).format(x=x, y=y)
    ]


def empty_kinds(m):
    """The empty sum is the zero of its kind."""
    m.features |= {"empty sum", "points"}
    k = m.r.randrange(5)
    if k == 0:
        return ["map q degree 2 on simplex 2", "point r in 2", "vector d in 2", m.range("n", 0, 1)], [
            "q[r, sum(i, 1, n, d_i)] == sum(i, 1, n, q[r, d_i])"
        ]
    if k == 1:
        return ["map q degree 1 on simplex 3", "point r in 3", m.range("n", 0, 2)], ["q[sum(i, 1, n, x_i*r)] == sum(i, 1, n, x_i)*q(r)"]
    if k == 2:
        return ["map p degree 2"], ["p[s, sum(i, 1, 0, <x_i, y_i>)] == 0"]
    if k == 3:
        return ["map p degree 1"], ["p[sum(S, subsets(2, 3), sum(i, S, <x_i, y_i>))] == %s" % m.pick("0", "sum(i, 2, 1, p(x_i))", "p[0*delta]")]
    return ["map q degree 2 on simplex 2", "point r in 2"], ["q[r + sum(i, 1, 0, x_i*(r_1 - r)), r] == q(r)"]


def space(m):
    s = m.r.choice((2, 2, 3))
    m.features.add("points")
    a, b = m.scalars(2, ("r", "s", "t", "d", "u", "v", "w"))
    k = m.r.randrange(8)
    head = [m.range("n", m.r.choice((0, 1)), m.r.choice((1, 2))), "map q degree n + 1 on simplex %d" % s, "point r, s, u_1..u_4 in %d" % s]
    rest = m.pick("r{n}", "s{n}", "u_1..u_n", "u_i : i in 1..n", "r + %s*(s - r){n}" % a, "(s - r){n}")
    if k == 0:
        return head, ["q[(1 - {a})*r + {a}*s, {R}] == (1 - {a})*q[r, {R}] + {a}*q[s, {R}]".format(a=a, R=rest)]
    if k == 1:
        return head + ["vector d in %d" % s], ["q[r + {a}*d, {R}] == q[r, {R}] + {a}*q[d, {R}]".format(a=a, R=rest)]
    if k == 2:
        return head, ["q(r) == q[r{n+1}]", "q[r, %s] - q[s, %s] == q[r - s, %s]" % (rest, rest, rest)]
    if k == 3:
        return head, ["q(%s*r) == %s^(n+1)*q(r)" % (a, a)]
    if k == 4:
        return head, ["q(r + {a}*(s - r)) == sum(k, 0, n + 1, binomial(n + 1, k)*{a}^k*q[r{{n+1-k}}, s - r{{k}}])".format(a=a)]
    if k == 5:
        return ["map q degree 2 on simplex %d" % s, "vector d, e in %d" % s, "point r in %d" % s], [
            "q(r + d) - q(r - d) == 4*q[r, d]", "q[d, e] == (q(d + e) - q(d - e))/4",
        ]
    if k == 6:
        return ["map q degree n on simplex 2", "for n in 0..2"][::-1] + ["point r, s, t in 2"], [
            "q(a*r + b*s + (1 - a - b)*t) == sum(i, 0, n, sum(j, 0, n - i, factorial(n)/(factorial(i)*factorial(j)*factorial(n - i - j))*a^i*b^j*(1 - a - b)^(n-i-j)*q[r{i}, s{j}, t{n-i-j}]))"
        ]
    return ["map q degree 2 on simplex 2", "point r in 2"] + ["let c = (r_1 + r_2 + r_3)/3"], [
        "q(c) == (q(r_1) + q(r_2) + q(r_3) + 2*q[r_1, r_2] + 2*q[r_2, r_3] + 2*q[r_1, r_3])/9"
    ]


def poly_on_plane(m):
    x, y, a, b = m.scalars(4, ("r", "s"))
    m.features |= {"points", "poly on a simplex"}
    return ["poly F(%s, %s) degree 2 = %s*%s^2 + %s*%s - %s" % (x, y, a, x, x, y, b), "point r, s in 2"], [
        m.pick(
            "F({a}, {b}) == {a}^3 + {a}*{b} - {b}", "F({b}, {a}) == {a}*{b}^2 + {a}*{b} - {b}", "F((r + s)/2) == (F(r) + F(s) + 2*F[r, s])/4",
            "F(r) == F[r, r]", "F({a}, 0) == {a}^3 - {b}",
        ).format(a=a, b=b)
    ]


def raised(m):
    m.features.add("raise")
    k = m.r.randrange(5)
    e = m.affine(m.scalar())
    if k == 0:
        return [m.range("n"), "map p degree n", "raise p to n + 1 as q"], [
            "q[t_1..t_{n+1}] == sum(i, 1, n + 1, p[t_j : j in 1..n + 1, j != i])/(n + 1)"
        ]
    if k == 1:
        return [m.range("n"), "map p degree n", "raise p to n + %d as q" % m.r.choice((0, 1, 2))], ["q(%s) == p(%s)" % (e, e), "q'(%s) == p'(%s)" % (e, e)]
    if k == 2 and m.new:
        m.features.add("tensor")
        return ["for m in 0..1", "for n in 0..1", "map f degrees m, n", "raise f to m + 1, n as g"], [
            "g[x_1..x_{m+1}; y_1..y_n] == sum(i, 1, m + 1, f[x_j : j in 1..m + 1, j != i; y_1..y_n])/(m + 1)",
            "g(%s, v) == f(%s, v)" % (e, e),
        ]
    if k in (2, 3):
        return [m.range("n"), "map p degree n", "raise p to n + 1 as q", "raise q to n + 2 as r"], ["r(%s) == p(%s)" % (e, e)]
    m.features.add("homogeneous")
    return [m.range("n"), "map p degree n", "raise p to n + 1 as q"], ["q(<s, w>) == w*p(<s, w>)", "q[delta{n+1}] == 0"]


def tensor(m):
    m.features.add("tensor")
    x, y, a = m.scalars(3)
    k = m.r.randrange(7)
    head = [m.range("m", 0, 1), m.range("n", 0, 2), "map f degrees m, n"]
    if k == 0:
        return head, ["f(%s, %s) == f[%s{m}; %s{n}]" % (x, y, x, y)]
    if k == 1:
        m.features.add("derivative")
        return head, ["D(f, m, n)({x}, {y}) == factorial(m)*factorial(n)*f[delta{{m}}; delta{{n}}]".format(x=m.affine(x), y=y)]
    if k == 2:
        return ["map f degrees 2, 1"], ["f[x_1, x_2; %s] == f[x_2, x_1; %s]" % (y, y), "f[0, 1; 1] == f[1, 0; 1]"]
    if k == 3:
        return [m.range("n", 0, 1), "map f degrees n + 1, 1"], [
            "f[(1 - {a})*{x} + {a}*{y}, s_1..s_n; t] == (1 - {a})*f[{x}, s_1..s_n; t] + {a}*f[{y}, s_1..s_n; t]".format(a=a, x=x, y=y)
        ]
    if k == 4:
        m.features.add("derivative")
        return ["map f degrees 2, 2"], ["D(f, i, j)({x}, {y}) == factorial(2)/factorial(2 - i)*factorial(2)/factorial(2 - j)*f[{x}{{2-i}}, delta{{i}}; {y}{{2-j}}, delta{{j}}] for i in 0..2 for j in 0..2".format(x=x, y=y)]
    if k == 5:
        return ["poly F({x}, {y}) degrees 1, 2 = {x}*{y}^2 + {a}*{y}".format(x=x, y=y, a=a)], [
            "F[s; t_1, t_2] == s*t_1*t_2 + {a}*(t_1 + t_2)/2".format(a=a)
        ]
    return head, ["f(<%s, %s>, %s) == %s^m*f(%s/%s, %s)" % (x, a, y, a, x, a, y)]


def contact(m):
    m.features |= {"given", "given in values"}
    s = m.affine(m.scalar(("x",)))
    k = m.r.randrange(6)
    if k == 0:
        return [m.range("n", 0, 2), "for k in 0..n", "map f, g degree n", "given D(f, i)({s}) == D(g, i)({s}) for i in 0..k".format(s=s)], [
            "f[x_1..x_k, {s}{{n-k}}] == g[x_1..x_k, {s}{{n-k}}]".format(s=s)
        ]
    if k == 1:
        m.features.add("for all")
        return [m.range("n", 0, 2), "for k in 0..n", "map f, g degree n", "given f[x_1..x_k, s{n-k}] == g[x_1..x_k, s{n-k}] for all x_1..x_k"], [
            "D(f, i)(s) == D(g, i)(s) for i in 0..k"
        ]
    if k == 2:
        return [m.range("n", 1, 3), "map f, g degree n", "given f(s) == g(s)", "given f'(s) == g'(s)"], ["f[x, s{n-1}] == g[x, s{n-1}]"]
    if k == 3:
        return ["map f degree 2", "given f[0, 0] == c_0", "given f[0, 1] == c_1", "given f[1, 1] == c_2"], [
            "f(%s) == sum(i, 0, 2, c_i*bernstein(i, 2, %s))" % (s, s)
        ]
    if k == 4:
        m.features.add("for all")
        return [m.range("n", 0, 2), "map f, g degree n", "given f(t) == g(t) for all t"], ["f[x_1..x_n] == g[x_1..x_n]"]
    return [m.range("n", 0, 2), "map f degree n + 1", "given f(%s) == 0" % s, "given f'(%s) == 0" % s][: m.r.choice((3, 4))], ["f[%s{n+1}] == 0" % s]


def quantified(m):
    m.features |= {"given", "for all", "points", "for all over points"}
    k = m.r.randrange(5)
    d = m.r.choice((2, 3))
    if k == 0:
        return ["map q degree %d on simplex %d" % (m.r.choice((0, 1, 2)), d), "point r, s in %d" % d, "given q(r) == 0 for all r"], ["q(s) == 0"]
    if k == 1:
        return ["map p, q degree 1 on simplex 2", "point r, s in 2", "given p(r) == q(r) for all r"], ["p[s - r] == q[s - r]"]
    if k == 2:
        return ["map q degree 2 on simplex 2", "point r, s in 2", "vector d in 2", "given q[d, r] == 0 for all d, r"], ["q(s) == q(r)"]
    if k == 3:
        return ["map q degree 2 on simplex 2", "point r, u in 2", "given q[u_1, u_2] == 1 for all u_1..u_2"], ["q(r) == 1"]
    return ["map p degree 1", "given p(t) == t for all t"], ["p(x + t) == x + t", "p[t] == t"]


def coefficients(m):
    m.features |= {"given", "for all"}
    x = m.scalar(("c", "d"))
    k = m.r.randrange(4)
    if k == 0:
        return [m.range("n", 0, 2), "given sum(i, 0, n, c_i*{x}^i) == sum(i, 0, n, d_i*{x}^i) for all {x}".format(x=x)], ["c_i == d_i for i in 0..n"]
    if k == 1:
        return [m.range("n", 0, 2), "given sum(i, 0, n, c_i*bernstein(i, n, {x})) == 0 for all {x}".format(x=x)], ["c_i == 0 for i in 0..n"]
    if k == 2:
        m.features.add("let and for all")
        return ["let g = c*%s" % x, "given g == %s for all %s" % (m.pick("d", "1"), m.scalar(("c", "d", x)))], ["c*%s == g" % x]
    return ["given c*{x} + d == {x} - 1 for all {x}".format(x=x)], ["c == 1", "d + %s == %s - 1" % (x, x)]


def scalar_given(m):
    m.features.add("given")
    a, b, c, w = m.scalars(4)
    k = m.r.randrange(8)
    if k == 0:
        return [m.range("n", 1, 3), "given sum(i, 1, n, a_i) == 1"], ["sum(i, 1, n, a_i*(p_i + v)) == sum(i, 1, n, a_i*p_i) + v"]
    if k == 1:
        m.features.add("quadratic")
        return ["given {w}^2 == {c}".format(w=w, c=c)], [m.pick("{w}^4 == {c}^2", "(1 + {w})*(1 - {w}) == 1 - {c}", "({a} + {w})^2 == {a}^2 + 2*{a}*{w} + {c}").format(w=w, c=c, a=a)]
    if k == 2:
        m.features.add("quadratic")
        v = m.pick("2", "1/2", "3", "4", "-1", "5")
        return ["given %s^2 == %s" % (w, v)], [m.pick("({w} - 1)*({w} + 1) == {v} - 1", "{w}^3 == {v}*{w}", "1/{w} == {w}/({v})").format(w=w, v=v)]
    if k == 3:
        return ["given {a} + {b} == {c}".format(a=a, b=b, c=c)], ["{c} - {a} == {b}".format(a=a, b=b, c=c), "({a} + {b})^2 == {c}^2".format(a=a, b=b, c=c)]
    if k == 4:
        return ["assume %s != 0" % a, "given {a}*{b} == {a}*{c}".format(a=a, b=b, c=c)], ["%s == %s" % (b, c)]
    if k == 5:
        m.features.add("components")
        return ["given {a}*{b} == 0".format(a=a, b=b), "given %s == 0" % a], ["{a}*{b} + {c} == {c} + {a}".format(a=a, b=b, c=c)]
    if k == 6:
        m.features.add("quadratic")
        return ["given {a}^2 + {b}^2 == 1".format(a=a, b=b)], ["({a}^2 - {b}^2)^2 + (2*{a}*{b})^2 == 1".format(a=a, b=b)]
    return ["map p degree 1", "given {a}*p(0) + {b}*p(1) == 0".format(a=a, b=b), "given %s + %s == 1" % (a, b)], ["p(%s) == 0" % b]


def conditions(m):
    m.features.add("conditions")
    x, y, z = m.scalars(3)
    return [], [
        m.pick(
            "(1/{x})^0 == {x}/{x}", "{x}^-1*{x} == 1", "({x}^2 - {y}^2)/({x} - {y}) == {x} + {y}", "1/(1/{x}) == {x}", "0/{x} == 0*{y}",
            "1/{x} - 1/{y} == ({y} - {x})/({x}*{y})", "sum(i, 0, 2, 1/({x} + i)) - 1/{x} == sum(i, 1, 2, 1/({x} + i))", "0^0 == {x}^0",
            "({z} - {x})/({y} - {x}) + ({y} - {z})/({y} - {x}) == 1", "prod(i, 1, 2, {x}_i/{x}_i) == 1",
        ).format(x=x, y=y, z=z)
    ]


def casteljau(m):
    m.features |= {"let", "recursive let"}
    arg = m.pick("t", "t_r", "t_r", "(t/w)")
    blossom = "t_1..t_n" if arg == "t_r" else arg + "{n}"
    return [
        m.range("n"), "poly C(t) degree n = sum(i, 0, n, a_i*bernstein(i, n, t))", "let w_{0,i} = a_i",
        "let w_{r,i} = (1 - %s)*w_{r-1,i} + %s*w_{r-1,i+1}" % (arg, arg),
    ], ["w_{n,0} == C[%s]" % blossom]


def bezier(m):
    x, a, b = m.scalars(3)
    e = m.affine(x, (a, b))
    m.features.add("copies")
    return [m.range("n"), "map p degree n"], [
        m.pick(
            "p((1 - {x})*{a} + {x}*{b}) == sum(k, 0, n, p[{a}{{n-k}}, {b}{{k}}]*bernstein(k, n, {x}))",
            "p({e}) == sum(k, 0, n, p[0{{n-k}}, 1{{k}}]*bernstein(k, n, {e}))",
            "p({x}) == sum(k, 0, n, p[{a}{{n-k}}, {b}{{k}}]*binomial(n, k)*(({b} - {x})/({b} - {a}))^(n-k)*(({x} - {a})/({b} - {a}))^k)",
            "p({e}) == sum(k, 0, n, binomial(n, k)*p[0{{n-k}}, delta{{k}}]*({e})^k)",
        ).format(x=x, a=a, b=b, e=e)
    ]


def every_case(m):
    """Lines that hold in some cases only: the false variants for `refute some`."""
    x, y = m.scalars(2)
    m.features.add("cases of both kinds")
    return [], [m.pick("{x} == {x} + i*{y} for i in 0..0", "{x}^i == 1 for i in 0..0", "{x}*i == 0 for i in 0..0", "{x}_i == {x}_0 for i in 0..0").format(x=x, y=y)]


# constructs of the newer language


def conditional(m):
    x, y = m.scalars(2)
    m.features.add("if")
    return [m.range("n", 0, 2)], [
        m.pick(
            "sum(i, 0, n, if(i == 0, {x}, {y})) == {x} + n*{y}", "if(n > 0, n*{x}^(n-1), 0) == n*{x}^n/{x}",
            "sum(S, subsets(n, 1), sum(i, 1, n, if(i in S, {x}_i, 0))) == sum(i, 1, n, {x}_i)",
            "sum(i, 0, n, sum(j, 0, n, if(i <= j, {x}, {y}))) == (n + 1)*(n + 2)/2*{x} + n*(n + 1)/2*{y}",
            "if(n != n, 1/({x} - {x}), {y}) == {y}", "sum(S, subsets(n, n), if(1 not in S, {x}, {y})) == if(n >= 1, {y}, {x})",
        ).format(x=x, y=y)
    ]


def determinants(m):
    x, y = m.scalars(2)
    m.features.add("determinant")
    return [m.range("n", 0, 3)], [
        m.pick(
            "determinant(i, j, n, {x}_i^(j-1)) == prod(i, 1, n, prod(j, i + 1, n, {x}_j - {x}_i))",
            "determinant(i, j, n, if(i == j, {x}_i, 0)) == prod(i, 1, n, {x}_i)",
            "determinant(i, j, n, {x}_{{i,j}}) == sum(P, permutations(n), sign(P)*prod(i, 1, n, {x}_{{i,P(i)}}))",
            "determinant(i, j, n, {x}_{{i,j}}) == determinant(i, j, n, {x}_{{j,i}})",
            "determinant(i, j, n, {y}*{x}_{{i,j}}) == {y}^n*determinant(i, j, n, {x}_{{i,j}})",
            "determinant(i, j, n, if(i <= j, {x}_{{i,j}}, 0)) == prod(i, 1, n, {x}_{{i,i}})",
        ).format(x=x, y=y)
    ]


def partition_sums(m):
    x, y = m.scalars(2)
    m.features.add("partitions")
    return [m.range("n", 0, 3)], [
        m.pick(
            "sum(P, partitions(n + 1), {x}^size(P)) == {x}*sum(k, 0, n, binomial(n, k)*sum(P, partitions(k), {x}^size(P)))",
            "sum(P, partitions(n), prod(B, P, prod(i, B, {x}_i))) == prod(i, 1, n, {x}_i)*sum(P, partitions(n), 1)",
            "sum(P, partitions(n), prod(B, P, -factorial(size(B) - 1))*(-1)^(n - size(P))*(-1)^n) == factorial(n)",
            "sum(P, partitions(n), sum(B, P, sum(i, B, {x}_i))) == sum(i, 1, n, {x}_i)*sum(P, partitions(n), 1)",
            "sum(P, partitions(n), prod(B, P, factorial(size(B) - 1))) == factorial(n)",
        ).format(x=x, y=y)
    ]


def permutation_sums(m):
    x, y = m.scalars(2)
    m.features.add("permutations")
    k = m.r.randrange(4)
    if k == 0:
        return [m.range("n", 0, 3), "map p degree n"], ["sum(P, permutations(n), p[t_{P(i)} : i in 1..n]) == factorial(n)*p[t_1..t_n]"]
    return [m.range("n", 0, 3)], [
        m.pick(
            "sum(P, permutations(n), 1) == factorial(n)", "sum(P, permutations(n), sign(P)) == if(n <= 1, 1, 0)",
            "sum(P, permutations(n), prod(i, 1, n, {x}_{{P(i)}})) == factorial(n)*prod(i, 1, n, {x}_i)",
            "sum(P, permutations(n), sum(i, 1, n, {x}_{{P(i)}}/{y}_i)) == factorial(n)/(n + 0^n)*sum(i, 1, n, {x}_i)*sum(i, 1, n, 1/{y}_i)",
        ).format(x=x, y=y)
    ]


def bsplines(m):
    x = m.scalar(("t",))
    m.features.add("bspline")
    return [m.range("d", 0, 2), "map p degree d"], [
        m.pick(
            "sum(j, 5 - d, 5, bspline(j, d, {x}, 5, t)) == 1",
            "p(t) == sum(j, 5 - d, 5, p[{x}_{{j+1}}..{x}_{{j+d}}]*bspline(j, d, {x}, 5, t))",
            "bspline(0, d, {x}, d + 1, t) == 0", "bspline(2, d, {x}, 1, t) == sum(i, 1, 0, t)",
        ).format(x=x)
    ]


def nets(m):
    m.features.add("net")
    a, b = m.scalars(2, ("c", "r", "s", "t", "x"))
    k = m.r.randrange(4)
    if k == 0:
        return [m.range("n", 0, 3), "map p degree n net c over %s, %s" % (a, b)], ["p[{a}{{n-i}}, {b}{{i}}] == c_i for i in 0..n".format(a=a, b=b)]
    if k == 1:
        return [m.range("n", 0, 3), "map p degree n net c over 0, 1"], ["p(x) == sum(i, 0, n, c_i*bernstein(i, n, x))"]
    if k == 2:
        return [m.range("n", 0, 2), "point r, s, t in 2", "map q degree n on simplex 2 net c over r, s, t"], [
            "q[r{n-i-j}, s{i}, t{j}] == c_{n-i-j,i,j} for i in 0..n for j in 0..n - i"
        ]
    m.features.add("frame")
    return ["frame r, s, t in 2", "map q degree 1 on simplex 2 net c over r, s, t"], ["q(x, y) == (1 - x - y)*c_{1,0,0} + x*c_{0,1,0} + y*c_{0,0,1}"]


def frames(m):
    m.features |= {"frame", "tuples", "points"}
    x, y = m.scalars(2, ("r", "s", "t"))
    k = m.r.randrange(4)
    if k == 0:
        return ["frame r, s, t in 2", "map q degree 2 on simplex 2"], ["q(({x}, {y})) == q((1 - {x} - {y})*r + {x}*s + {y}*t)".format(x=x, y=y)]
    if k == 1:
        return ["map q degree 2 on simplex 2"], ["q(({x}, {y})) == q({x}, {y})".format(x=x, y=y), "q[({x}, 0), (0, {y})] == q[(0, {y}), ({x}, 0)]".format(x=x, y=y)]
    if k == 2:
        return ["poly F(x, y) degree 2 = x*y", "frame r, s, t in 2"], ["F[s, t] == 1/2", "F[s - r, t - r] == 1/2", "F[s, s] == 0"]
    return ["map q degree 1 on simplex 3"], ["q(({x}, {y}, 0)) + q((0, 0, 1)) == q(({x}, {y}, 1)) + q((0, 0, 0))".format(x=x, y=y)]


def expression_derivative(m):
    t, x, y = m.scalars(3)
    m.features |= {"D(e, t)", "derivative"}
    e = m.affine(t, (x, y))
    return [m.range("n", 0, 2), "map f degree n"], [
        m.pick(
            "D(f({t}), {t}) == f'({t})", "D(f({e}), {t}) == {s}*f'({e})", "D({t}^n*{x}, {t}) == n*{x}*{t}^n/{t}", "D(1/{t}, {t}, 2) == 2/{t}^3",
            "D(f({t})*{t}, {t}) == f({t}) + {t}*f'({t})", "D(D({x}*{t}^2, {x}), {t}) == 2*{t}", "D({x}^2, {t}) == 0", "D(sum({t}, 1, n, {t}*{x}), {x}) == n*(n + 1)/2",
            "D({t}_1*{t}, {t}_1) == {t}", "D(f({t}), {t}, n + 1) == 0", "D(({t} - {x})^3, {t}, 2) == 6*({t} - {x})",
        ).format(t=t, x=x, y=y, e=e, s=m.slope(e, t))
    ]


def expression_derivative_through(m):
    t, x = m.scalars(2, ("g",))
    m.features |= {"D(e, t)", "derivative", "let in poly"}
    if "w" in (t, x):
        raise Capture()
    return ["let w = %s^2" % t, "poly g(%s) degree 1 = %s*%s + w" % (x, t, x)], ["D(g(%s), %s) == %s + 2*%s" % (x, t, x, t), "D(w, %s) == 2*%s" % (t, t)]


def directional(m):
    m.features |= {"derivative", "points", "directional"}
    s = m.r.choice((2, 3))
    return [m.range("n", 0, 3), "map q degree n on simplex %d" % s, "point r in %d" % s, "vector d, e in %d" % s], [
        m.pick(
            "D(q, d, e)(r) == D(q, e, d)(r)",
            "D(q, d + e)(r) == D(q, d)(r) + D(q, e)(r)", "D(q, x*d)(r) == x*D(q, d)(r)", "q(r + d) == q(r) + D(q, d)(r) + D(q, d, d)(r)/2 + D(q, d, d, d)(r)/6",
            "D(q, sum(i, 1, 0, d_i))(r) == 0",
        )
    ]


OLD = [
    diagonal, symmetric, multiaffine, multilinear, homogeneous, derivative, beyond, chain, chain, chain_twice, product_rule, power_rule, taylor,
    let_in_poly, let_in_poly, nested_let, hidden, hidden, poly_variable, poly_of_poly, pairs_sum, pairs_sum, polarization, subset_sums,
    subset_sums, empty_kinds, empty_kinds, space, space, space, poly_on_plane, raised, raised, tensor, tensor, contact, contact, quantified,
    coefficients, scalar_given, scalar_given, conditions, casteljau, bezier, every_case,
]
NEW = [
    conditional, determinants, partition_sums, permutation_sums, bsplines, nets, frames, expression_derivative, expression_derivative_through,
    directional,
]


# rewriting that preserves the truth


class Context:
    """The names that are bound at the place of an expression."""

    def __init__(self, block, rng, new):
        self.block = block
        self.rng = rng
        self.new = new
        self.degrees = {}
        self.declared = set(block.declared())
        for line in block.lines:
            if line[0] == "map" and line[2] == "one" and line[4] is None:
                for name in line[1]:
                    self.degrees[name] = line[3][0]
            elif line[0] == "poly" and line[3] == "one" and len(line[2]) == 1:
                self.degrees[line[1]] = line[4][0]
        self.lets = []
        self.used = set(self.declared)
        for line in block.lines:
            for _, e in nodes(line):
                if e[0] in ("name", "agg", "fam"):
                    self.used.update(x for x in e if type(x) is str)
                elif e[0] == "det":
                    self.used.update(e[1:3])
            if line[0] == "poly":
                self.used.update(line[2])

    def fresh(self):
        """An unused name; for a binder, the next one may reuse it."""
        for name in ("e", "g", "l", "o", "r", "A", "B", "E", "G", "H", "L"):
            if name not in self.used:
                self.used.add(name)
                return name
        name = "Z%d" % len(self.used)
        self.used.add(name)
        return name


ONE = ("num", "1")
TWO = ("num", "2")


def numeric(e):
    return e[0] in ("num", "add", "sub", "mul", "div", "neg", "pow", "val", "blo", "agg", "fn")


def rewrite(e, bound, c):
    """An expression of equal value, or None. `bound` are the names that enclosing binders bind; e is a number."""
    r = c.rng
    x = ("name", r.choice([s for s in SCALARS if s not in c.declared and s not in bound] or ["omega"]), None)
    choice = r.randrange(15)
    kind = e[0]
    if kind == "agg" and e[1] == "sum" and e[3][0] == "rng" and choice < 11:
        _, which, binder, (_, low, high), body = e
        k = r.randrange(5)
        b = ("name", binder, None)
        if k == 0:
            return ("agg", which, binder, ("rng", ("add", low, ONE), ("add", high, ONE)), substituted(body, binder, ("sub", b, ONE)))
        if k == 1:
            if binder in free_names(low) | free_names(high):
                return None
            return ("agg", which, binder, ("rng", low, high), substituted(body, binder, ("sub", ("add", low, high), b)))
        if k == 2:
            name = r.choice(BINDERS)
            if name in free_names(body) or name in bound and name in free_names(body):
                return None
            return ("agg", which, name, ("rng", low, high), substituted(body, binder, ("name", name, None)))
        if k == 3 and body[0] in ("add", "sub"):
            return (body[0], ("agg", which, binder, e[3], body[1]), ("agg", which, binder, e[3], body[2]))
        if k == 4 and binder != x[1]:
            return ("div", ("agg", which, binder, e[3], ("mul", x, body)), x)
        return None
    if kind in ("val", "blo") and choice < 11:
        return rewrite_map(e, bound, c, x)
    if kind == "fn" and e[1] == "bernstein" and choice < 6:
        i, n, t = e[2]
        return ("agg", "sum", "L", ("rng", i, i), ("mul", ("mul", ("fn", "binomial", (n, ("name", "L", None))), ("pow", t, i)), ("pow", ("sub", ONE, t), ("sub", n, i)))) if i[0] == "num" else None
    if kind == "pow" and choice < 6 and e[2][0] == "num" and e[2][1].isdigit() and int(e[2][1]) >= 1:
        return ("mul", e[1], ("pow", e[1], number(int(e[2][1]) - 1)))
    if kind in ("add", "mul") and choice < 4:
        return (kind, e[2], e[1])
    if kind == "mul" and e[2][0] in ("add", "sub") and choice < 7:
        return (e[2][0], ("mul", e[1], e[2][1]), ("mul", e[1], e[2][2]))
    if kind == "div" and e[1][0] in ("add", "sub") and choice < 7:
        return (e[1][0], ("div", e[1][1], e[2]), ("div", e[1][2], e[2]))
    if kind == "sub" and choice < 4:
        return ("neg", ("sub", e[2], e[1]))
    if choice == 7:
        return ("sub", ("add", e, x), x)
    if choice == 8:
        return ("div", ("mul", e, x), x)
    if choice == 9:
        return ("mul", e, ("pow", x, ("num", "0")))
    if choice == 10:
        name = r.choice(("i", x[1], "t"))
        if name in free_names(e):
            return None  # it might not be an integer there
        return ("add", e, ("agg", "sum", name, ("rng", ONE, ("num", "0")), e))
    if choice == 11 and free_names(e) & bound == set() and "name" != kind and not has_bound_member(e, c):
        name = c.fresh()
        c.declared.add(name)
        c.lets.append(("let", ("name", name, None), e))
        return ("name", name, None)
    if choice == 12:
        return ("agg", r.choice(("sum", "prod", "mean")), c.fresh(), ("rng", ONE, ONE), e)
    if choice == 13 and c.new:
        k = r.randrange(3)
        if k == 0:
            return ("if", (r.choice(("==", "<=", ">=")), ("num", "2"), ("num", "2")), e, x)
        if k == 1:
            i, j = c.fresh(), c.fresh()
            return ("det", i, j, ONE, e)
        z = c.fresh()
        return ("dif", ("mul", e, ("name", z, None)), ("name", z, None), None)
    if choice == 14:
        return ("div", ("sub", ("mul", TWO, e), ("agg", "sum", c.fresh(), ("rng", ONE, ONE), e)), ONE)
    return None


def has_bound_member(e, c):
    """Members that a hypothesis binds with `for all` are not moved into a let."""
    return any(line[0] == "given" and line[4] for line in c.block.lines) and any(x[0] == "name" and x[2] is not None for _, x in nodes(e))


def rewrite_map(e, bound, c, x):
    r = c.rng
    name = e[1]
    if name not in c.degrees or name in bound:
        return None
    n = c.degrees[name]
    if free_names(n) & bound:
        return None
    if e[0] == "val":
        if e[2] is None:
            return ("blo", name, ((("copies", e[3][0], n),),))
        return None
    args = e[2][0]
    single = [k for k, a in enumerate(args) if a[0] not in ("copies", "run", "fam")]
    k = r.randrange(6)
    if k == 0 and len(args) > 1:
        order = list(args)
        r.shuffle(order)
        return ("blo", name, (tuple(order),))
    if not single:
        return None
    at = r.choice(single)
    a = args[at]

    def with_argument(new):
        return ("blo", name, (args[:at] + (new,) + args[at + 1 :],))

    delta = ("name", "delta", None)
    if "delta" in bound:
        return None
    if k == 1:
        return ("sub", with_argument(("add", a, ("mul", x, delta))), ("mul", x, with_argument(delta)))
    if k == 2:
        if is_geometric(a):
            return ("div", with_argument(("mul", x, a)), x)
        return ("div", with_argument(("pair", ("mul", x, a), x)), x) if is_number(a, c) else None
    if k == 3:
        return ("div", ("add", with_argument(("add", a, ("mul", x, delta))), with_argument(("sub", a, ("mul", x, delta)))), TWO)
    if k == 4:
        return with_argument(("copies", a, ONE))
    if k == 5:
        return with_argument(("fam", a, c.fresh(), ("rng", TWO, TWO), ()))
    return None


def is_geometric(a):
    return a[0] == "pair" or a == ("name", "delta", None)


def positions(line, c):
    """The places of numbers in the sides of a claim: (path, expression, bound names)."""
    out = []

    def walk(e, path, bound):
        if type(e) is not tuple or not e or type(e[0]) is not str:
            return
        kind = e[0]
        if numeric(e):
            out.append((path, e, bound))
        if kind in ("add", "sub", "mul", "div"):
            walk(e[1], path + (1,), bound)
            walk(e[2], path + (2,), bound)
        elif kind in ("neg", "pow"):
            walk(e[1], path + (1,), bound)
        elif kind == "agg":
            walk(e[4], path + (4,), bound | {e[2]})
        elif kind == "val" and e[2] is None:
            for k, a in enumerate(e[3]):
                if a[0] != "name":
                    walk(a, path + (3, k), bound)
        elif kind == "if":
            walk(e[2], path + (2,), bound)
            walk(e[3], path + (3,), bound)

    bound = frozenset(r[0] for r in line[3])
    for side in (1, 2):
        walk(line[side], (side,), bound)
    return out


def is_number(e, c):
    """Whether this is certainly a number: no summand is a point or vector."""
    if e[0] == "name":
        return False
    if e[0] in ("val", "blo", "num", "fn"):
        return True
    if e[0] in ("add", "sub", "mul", "div", "neg", "pow"):
        return all(is_number(x, c) or x[0] == "name" and x[1] not in c.geometric for x in e[1:] if type(x) is tuple) if e[0] != "pow" else True
    if e[0] == "agg":
        return is_number(e[4], c) or e[4][0] == "name" and e[4][1] not in c.geometric
    return False


def rewritten(block, rng, new, steps):
    c = Context(block, rng, new)
    c.geometric = {"delta"}
    for line in block.lines:
        if line[0] in ("point", "vector"):
            for item in line[1]:
                c.geometric.add(item[1] if item[0] == "name" else item[1][1])
        elif line[0] == "frame":
            c.geometric.update(line[1])
        elif line[0] == "let":
            c.geometric.add(line[1][1])
    lines = list(block.lines)
    for _ in range(steps):
        at = rng.choice([k for k, line in enumerate(lines) if line[0] in STATEMENTS])
        found = [p for p in positions(lines[at], c) if is_number(p[1], c)]
        if not found:
            continue
        path, e, bound = rng.choice(found)
        try:
            fresh = rewrite(e, bound, c)
        except Capture:
            continue
        if fresh is not None and len(repr(fresh)) < 4000:
            lines[at] = replace(lines[at], path, fresh)
    # lets may be anywhere: a let may use names that are declared below it
    first = [k for k, line in enumerate(lines) if line[0] in STATEMENTS][0]
    for let in c.lets:
        lines.insert(rng.randrange(first + 1) if not any(l[0] == "for" for l in lines) else first, let)
        first += 1
    return lines


# false variants

def lost_divisor(block, rng):
    """Replaces a quotient in a claim by its numerator."""
    return changed(block, rng, lambda e: e[0] == "div", lambda e: e[1], STATEMENTS)


CHANGES = [lost_divisor, lost_divisor, off_by_one, count_off_by_one, lost_factor, lost_factor, sign, sign, lost_summand, sum_bound, swap, exchange_kind, other_name]


def neighbour(block, rng, id):
    """A block with one change that is false in every case or in some, without an error; or None."""
    claims = [k for k, line in enumerate(block.lines) if line[0] in STATEMENTS]
    for _ in range(12):
        at = rng.choice(claims)
        lines = rng.choice(CHANGES)(block, rng)
        if lines is None or len(lines) != len(block.lines) or lines == list(block.lines):
            continue
        different = [k for k in range(len(lines)) if lines[k] != block.lines[k]]
        if different[0] not in claims and rng.random() < 0.6:
            continue
        if different[0] in claims:
            at = different[0]
        lines = [line for k, line in enumerate(lines) if k not in claims or k == at]
        out = copy_of(block, lines, id, "false: " + block.title)
        decision = decide(out, budget=60000)
        if decision.error is None and decision.lines[0].statuses() <= {"true", "false"} and "false" in decision.lines[0].statuses():
            return out
    return None


def strict_form(block, rng, id):
    """The block with a declaration for every free name, as `strict` requires, and the same without one of them."""
    decision = decide(block, points=1, budget=60000)
    items = sorted(name if index is None else name + "_{" + ",".join(map(str, index)) + "}" for name, index in decision.free)
    if not items or any("-" in item for item in items):
        return []
    first = [k for k, line in enumerate(block.lines) if line[0] not in ("for", "map")][0]
    out = []
    for drop in (False, True):
        chosen = list(items)
        if drop:
            chosen.remove(rng.choice(items))
        lines = list(block.lines)
        if chosen:
            lines.insert(first, parse_text("number " + ", ".join(chosen) + "\n")[0].lines[0])
        made = copy_of(block, lines, id + ("e" if drop else "s"), block.title)
        made.strict = True
        decision = decide(made, points=1, budget=60000)
        ok = decision.error is None and all(l.statuses() == {"true"} for l in decision.lines)
        if drop or ok:
            out.append((made, "error" if drop and not ok else "true"))
    return out


def generate(index, seed, new):
    """The statements with this number, determined by (seed, index). A list of (Block, expected, features)."""
    rng = random.Random("identity %s %s" % (seed, index))
    while True:
        families = NEW if new and rng.random() < 0.3 else OLD
        family = rng.choice(families)
        m = Maker(rng, new)
        try:
            head, claims = family(m)
        except Capture:
            continue
        text = "theorem i%s-%d-t \"%s\"\n" % (seed, index, family.__name__)
        text += "".join(line + "\n" for line in head) + "".join("claim " + claim + "\n" for claim in claims)
        block = parse_text(text)[0]
        if block.fault is not None:
            raise AssertionError("a family wrote what cannot be read: %s\n%s" % (block.fault, text))
        steps = rng.choice((0, 0, 1, 1, 2, 3, 5))
        if steps:
            block = copy_of(block, rewritten(block, rng, new, steps), block.id, block.title)
            m.features.add("rewritten")
        out = [(block, "true", m.features)]
        if new and rng.random() < 0.1:
            for made, expected in strict_form(block, rng, "i%s-%d" % (seed, index)):
                out.append((made, expected, m.features | {"strict" if expected == "true" else "strict, a name missing"}))
        false = neighbour(block, rng, "i%s-%d-f" % (seed, index))
        if false is not None:
            lines = []
            for line in false.lines:
                if line[0] in STATEMENTS and rng.random() < 0.4:
                    line = (rng.choice(("refute", "refute some") if new else ("refute",)),) + line[1:]
                lines.append(line)
            features = m.features | {"neighbour"}
            if any(line[0] == "refute some" for line in lines):
                features.add("refute some")
            out.append((copy_of(false, lines, false.id, false.title), "false", features))
        return out
