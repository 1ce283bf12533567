"""Maps: how they are given, and their values at points."""

import field
from combinatorics import binomial, exponents, factorial, multinomial
from faults import Err, TooBig
from field import inverse_matrix, lagrange, multiply, power, same


class Maps:
    """The maps of a case by their coefficients: values, derivatives and blossoms."""

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

    def coefficients(self, name):
        """The coefficients of a map by exponents."""
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
            self.memo[key] = self.nested(self.interpolated, name) if kind == "poly" else self.nested(self.from_net, dirs[0], line[5])
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
        self.before(body, self.position[name])
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
                fresh[i] = x % field.P
            values = fresh
        # coefficients of higher degree must vanish, and one more point must agree
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
                c = c * pow(x, k, field.P) % field.P
            found = (found + c) % field.P
        if not same(expected, found):
            raise Err("degree", "of poly")
        return values

    def before(self, e, at):
        """A poly or net may use only maps above it."""
        for name in map_names(e):
            if name in self.position and self.position[name] >= at:
                raise Err("not declared", "map " + name + " is below")

    def from_net(self, direction, net):
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
            poly = {(0,) * s: c * multinomial(n, i) % field.P}
            for k in range(s + 1):
                for _ in range(i[k]):
                    poly = multiply(poly, forms[k])
            for x, y in poly.items():
                out[x] = (out[x] + y) % field.P
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
            return out % field.P
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
                x = x * y % field.P
            out = out + x
        return out % field.P

    def value_weights(self, u, s, n):
        if s == 1:
            x, m = u
            xs, ms = [1], [1]
            for _ in range(n):
                xs.append(xs[-1] * x % field.P)
                ms.append(ms[-1] * m % field.P)
            return {(k,): xs[k] * ms[n - k] % field.P for k in range(n + 1)}
        out = {}
        for e in exponents(s, n):
            w = power(u[-1], n - sum(e))
            for x, k in zip(u, e):
                if k:
                    w = w * power(x, k) % field.P
            out[e] = w
        return out

    def polar_weights(self, args, s, n):
        """The polar form of each monomial: its coefficient in the product of the arguments, divided by the number of its terms."""
        if s == 1:
            c = [1]
            for x, m in args:
                c = [((c[k] * m if k < len(c) else 0) + (c[k - 1] * x if k else 0)) % field.P for k in range(len(c) + 1)]
            return {(k,): c[k] * pow(binomial(n, k), -1, field.P) % field.P for k in range(n + 1)}
        poly = {(0,) * s: 1}
        for u in args:
            form = {tuple(1 if j == c else 0 for j in range(s)): u[c] for c in range(s)}
            form[(0,) * s] = u[s]
            poly = multiply(poly, form)
        return {e: x * pow(multinomial(n, (n - sum(e),) + e), -1, field.P) % field.P for e, x in poly.items()}

    def v_val(self, n, env):
        _, name, order, args = n
        self.spend()
        if name in env and env[name][0] == "p":
            return self.int_value(n, env) % field.P
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
            return self.contract(name, dirs, [w]) * (factorial(d) // factorial(d - m)) % field.P
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
                w[(e,)] = x * (factorial(e) // factorial(e - k)) % field.P
                x = x * u[0] % field.P
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
                self.seen.add("no copies")  # of arguments that are not evaluated then
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


def map_names(e):
    if type(e) is tuple:
        if e and e[0] in ("val", "blo") and len(e) > 2 and type(e[1]) is str:
            yield e[1]
        for x in e:
            yield from map_names(x)
