"""Hypotheses, which are satisfied by solving for quantities that are linear in them, and for one unknown of degree 2 by a square root."""

import field
from faults import Err, TooBig, ZeroDivisor
from field import square_root
from names import Sample
from values import difference, range_cases


class Hypotheses:
    """The equations of a case, and methods to satisfy them."""

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
                env[key] = ("n", rng.randrange(2, field.P))
            else:
                s = self.case.count(d[1], self.case.penv)
                env[key] = ("g", tuple(rng.randrange(2, field.P) for _ in range(s)) + (1 if d[0] == "point" else 0,))
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
        """A sample at which all equations hold, or None."""
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
            c[symbol[2]] = (c[symbol[2]] + by) % field.P
        elif symbol[0] == "v":
            sample.vals[symbol[1]] = (sample.vals[symbol[1]] + by) % field.P
        else:
            v = list(sample.vals[symbol[1]])
            v[symbol[2]] = (v[symbol[2]] + by) % field.P
            sample.vals[symbol[1]] = tuple(v)

    def affine(self, sample, group, instances, base):
        """Whether all residuals are affine along a random direction of these symbols."""
        direction = [(s, sample.rng.randrange(1, field.P)) for s in group]
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
        return all((c - 2 * b + a) % field.P == 0 for a, b, c in zip(base, *found))

    def solve(self, rng, order, instances, given=None):
        """Changes the sample so that the equations hold; a map or number in `given` is not changed."""
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
        # again, with other values of the variables `for all`
        for eq in self.equations:
            for _ in range(2 if eq[2] else 1):
                if any(x != 0 for x in self.fresh_residual(eq)):
                    return False
        return True

    def fresh_residual(self, eq):
        self.case.memo = {}
        return self.residual(self.instance(eq))

    def roots(self, sample, scalars, instances, fixed, rng, order):
        """Solves one equation of degree 2 in a number in which no equation is affine; True if one was solved."""
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
                second = (values[2] - 2 * values[1] + values[0]) % field.P
                third = (values[3] - 3 * values[2] + 3 * values[1] - values[0]) % field.P
                if third == 0 and second == 0 and values[0] != values[1]:
                    candidates = None  # affine in this number: no root is needed
                    if order == "maps":
                        break
                    candidates = []
                    continue
                if third == 0 and second != 0:
                    candidates.append((s, values, second))
            if not candidates:
                continue
            s, values, second = candidates[0]
            a = second * pow(2, -1, field.P) % field.P
            b = (values[1] - values[0] - a) % field.P
            c = values[0]
            root = square_root((b * b - 4 * a * c) % field.P)
            if root is None:
                continue
            if rng.random() < 0.5:
                root = -root
            self.shift(sample, s, (root - b) * pow(2 * a, -1, field.P) % field.P)
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
            """Adds the rows of an instance; 1 if they are independent of the previous rows, 0 if not, -1 if they cannot hold."""
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
                row = [(c[k] - r0[k]) % field.P for c in columns] + [(-r0[k]) % field.P]
                for pivot, other in rows:
                    f = row[pivot]
                    if f:
                        row = [(x - f * y) % field.P for x, y in zip(row, other)]
                for pivot in range(n):
                    if row[pivot]:
                        break
                else:
                    if row[n]:
                        return -1
                    continue
                f = pow(row[pivot], -1, field.P)
                row = [x * f % field.P for x in row]
                for at, (q, other) in enumerate(rows):
                    g = other[pivot]
                    if g:
                        rows[at] = (q, [(x - g * y) % field.P for x, y in zip(other, row)])
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
