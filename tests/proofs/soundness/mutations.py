"""Mutations of the statements of the literature: small faults whose truth the oracle computes.

    mutate(block, rng, new)  ->  (mutated Block, kinds of change) or None
"""

import glob
import os
import random

from language import HYPOTHESES, STATEMENTS, Block, parse_text

EXPRESSIONS = {"num", "name", "neg", "add", "sub", "mul", "div", "pow", "pair", "tuple", "agg", "fn", "if", "det", "val", "blo", "dif"}
BODY = STATEMENTS + HYPOTHESES + ("let", "poly")


def nodes(root, path=()):
    """All expressions within a tuple, with their paths, including arguments of blossoms."""
    if type(root) is not tuple:
        return
    if root and type(root[0]) is str and (root[0] in EXPRESSIONS or root[0] in ("copies", "run", "fam")) and len(root) > 1:
        yield path, root
    for k, x in enumerate(root):
        if type(x) is tuple:
            yield from nodes(x, path + (k,))


def replace(root, path, new):
    if not path:
        return new
    k = path[0]
    return root[:k] + (replace(root[k], path[1:], new),) + root[k + 1 :]


def substitute(e, name, new):
    """Replaces a bare name even if a binder binds it, like a careless author."""
    if type(e) is not tuple:
        return e
    if len(e) == 3 and e[0] == "name" and e[1] == name and e[2] is None:
        return new
    return tuple(substitute(x, name, new) for x in e)


def number(k):
    return ("num", str(k)) if k >= 0 else ("neg", ("num", str(-k)))


def step(e, rng):
    """Changes an index or bound by one."""
    by = rng.choice((1, -1))
    if e[0] == "num" and e[1].isdigit():
        k = int(e[1]) + by
        return number(k)
    if e[0] in ("add", "sub") and e[2] == ("num", "1") and rng.random() < 0.7:
        return e[1]
    return ("add" if by > 0 else "sub", e, ("num", "1"))


def names_in(lines):
    """Bare names in use, families in use, binders."""
    bare, families = set(), set()
    for line in lines:
        for _, e in nodes(line):
            if e[0] == "name":
                (bare if e[2] is None else families).add(e[1])
    return bare, families


def is_place_of_name(line, path):
    """Places where the language requires a name, not an expression: the name that a let defines, variables `for all`, the ends of a run."""
    if line[0] == "let" and path == (1,):
        return True
    return line[0] in STATEMENTS + HYPOTHESES and path[0] == 4 and len(path) <= 3


def pick_node(block, rng, test, where=None, names=False):
    found = []
    for at, line in enumerate(block.lines):
        if where is not None and line[0] not in where:
            continue
        for path, e in nodes(line):
            if path and test(e) and (names or not is_place_of_name(line, path)):
                found.append((at, path, e))
    return rng.choice(found) if found else None


def put(block, at, path, new):
    lines = list(block.lines)
    lines[at] = replace(lines[at], path, new)
    return lines


def changed(block, rng, test, new, where=BODY, names=False):
    """The lines with one expression e that passes the test replaced by new(e), or None if there is none."""
    found = pick_node(block, rng, test, where, names)
    if found is None:
        return None
    at, path, e = found
    fresh = new(e)
    return None if fresh is None else put(block, at, path, fresh)


def with_item(items, k, new):
    """A tuple with the item at place k replaced."""
    return items[:k] + (new,) + items[k + 1 :]


def off_by_one(block, rng):
    def new(e):
        k = rng.randrange(len(e[2]))
        return ("name", e[1], with_item(e[2], k, step(e[2][k], rng)))

    return changed(block, rng, lambda e: e[0] == "name" and e[2] is not None, new, names=True)


def count_off_by_one(block, rng):
    def has(e):
        return e[0] in ("copies", "pow") or e[0] == "fn" and e[1] in ("binomial", "factorial", "bernstein", "subsets", "without")

    def new(e):
        if e[0] != "fn":
            return (e[0], e[1], step(e[2], rng))
        k = rng.randrange(min(2, len(e[2])))
        if e[1] == "without":
            k = 0
        return ("fn", e[1], with_item(e[2], k, step(e[2][k], rng)))

    return changed(block, rng, has, new)


def lost_factor(block, rng):
    return changed(block, rng, lambda e: e[0] in ("mul", "div"), lambda e: e[1] if e[0] == "div" else e[rng.choice((1, 2))])


def sign(block, rng):
    def new(e):
        return e[1] if e[0] == "neg" else ("sub" if e[0] == "add" else "add", e[1], e[2])

    return changed(block, rng, lambda e: e[0] in ("add", "sub", "neg"), new)


def lost_summand(block, rng):
    return changed(block, rng, lambda e: e[0] in ("add", "sub"), lambda e: e[rng.choice((1, 2))], STATEMENTS + ("let", "poly"))


def sum_bound(block, rng):
    def new(e):
        k = rng.choice((1, 2))
        return with_item(e, 3, with_item(e[3], k, step(e[3][k], rng)))

    return changed(block, rng, lambda e: e[0] in ("agg", "fam") and e[3][0] == "rng", new)


def empty_range(block, rng):
    """Empties a sum, family, set or run."""

    def new(e):
        zero, one = number(0), number(1)
        if e[0] == "fn" and e[1] == "without":
            return ("fn", "without", (zero, e[2][1]))
        if e[0] == "fn":
            return ("fn", "subsets", (e[2][0], rng.choice((zero, ("neg", one), ("add", e[2][0], one)))))
        low = e[3][1]
        return with_item(e, 3, ("rng", low, zero if low == one else ("sub", low, one)))

    return changed(block, rng, lambda e: e[0] in ("agg", "fam") and e[3][0] == "rng" or e[0] == "fn" and e[1] in ("without", "subsets"), new)


def lower_parameter(block, rng):
    """A parameter or range begins at 0 or one lower, or ends one higher."""
    found = []
    for at, line in enumerate(block.lines):
        if line[0] == "for":
            found.append((at, (2,), line[2]))
            found.append((at, (2,), line[2]))
            found.append((at, (3,), line[3]))
        if line[0] in STATEMENTS + HYPOTHESES:
            for k, r in enumerate(line[3]):
                found.append((at, (3, k, 1), r[1]))
                found.append((at, (3, k, 2), r[2]))
    if not found:
        return None
    at, path, e = rng.choice(found)
    if path[-1] in (2, 1) and (path == (2,) or len(path) == 3 and path[2] == 1):
        new = ("num", "0") if rng.random() < 0.7 else ("sub", e, ("num", "1"))
        if new == e:
            new = ("neg", ("num", "1"))
    else:
        new = ("add", e, ("num", "1")) if e[0] != "num" else number(int(e[1]) + 1)
    return put(block, at, path, new)


def rename_binder(block, rng):
    """A bound name is renamed to a name in use, with its occurrences, so that it may capture, or without them."""
    bare, families = names_in(block.lines)
    pool = sorted(bare | families | {"t", "n", "delta"}) + ["i", "k"]
    found = []
    for at, line in enumerate(block.lines):
        for path, e in nodes(line):
            if e[0] in ("agg", "fam"):
                found.append((at, path, e))
        if line[0] == "poly":
            found.append((at, (), ("poly", 0)))
        if line[0] in STATEMENTS + HYPOTHESES:
            for k in range(len(line[3])):
                found.append((at, (), ("range", k)))
        if line[0] == "let" and line[1][2]:
            found.append((at, (), ("let", 0)))
        if line[0] == "given" and line[4]:
            found.append((at, (), ("all", 0)))
        if line[0] == "for":
            found.append((at, (), ("for", 0)))
    if not found:
        return None
    at, path, e = rng.choice(found)
    fresh = rng.choice(pool)
    with_body = rng.random() < 0.75
    new = ("name", fresh, None)
    line = block.lines[at]

    def body(part):
        return substitute(part, old, new) if with_body else part

    lines = list(block.lines)
    if e[0] in ("agg", "fam"):
        old = e[2]
        lines = put(block, at, path, (e[0], e[1] if e[0] == "agg" else body(e[1]), fresh, e[3], body(e[4])))
    elif e[0] == "poly":
        k = rng.randrange(len(line[2]))
        old = line[2][k]
        lines[at] = line[:2] + (with_item(line[2], k, fresh),) + line[3:5] + (body(line[5]),)
    elif e[0] == "range":
        k = e[1]
        old = line[3][k][0]
        ranges = line[3][:k] + ((fresh,) + line[3][k][1:],) + body(line[3][k + 1 :])
        lines[at] = (line[0], body(line[1]), body(line[2]), ranges, line[4])
    elif e[0] == "let":
        names = [x for x in line[1][2] if x[0] == "name" and x[2] is None]
        if not names:
            return None
        old = rng.choice(names)[1]
        lines[at] = ("let", substitute(line[1], old, new), body(line[2]))
    elif e[0] == "all":
        k = rng.randrange(len(line[4]))
        if line[4][k][0] != "name" or line[4][k][2] is not None:
            return None
        old = line[4][k][1]
        lines[at] = (line[0], body(line[1]), body(line[2]), line[3], with_item(line[4], k, new))
    else:
        old = line[1]
        lines[at] = ("for", fresh) + line[2:]
        lines = lines[: at + 1] + [body(x) for x in lines[at + 1 :]]
    if old == fresh:
        return None
    return lines


def redeclare(block, rng):
    """Adds a second declaration of a name, or a first one of a name that is used."""
    bare, families = names_in(block.lines)
    pool = block.declared() * 3 + sorted(bare | families)
    if not pool:
        return None
    name = rng.choice(pool)
    bare_name = ("name", name, None)
    extra = rng.choice(
        [
            ("map", (name,), "one", (("num", str(rng.randrange(3))),), None, None),
            ("let", bare_name, rng.choice((("num", "2"), ("name", "t", None)))),
            ("point", (bare_name,), ("num", "2")),
            ("vector", (bare_name,), ("num", "1")),
            ("point", (bare_name,), ("num", "1")),
            ("poly", name, ("z",), "one", (("num", "1"),), ("name", "z", None)),
            ("for", name, ("num", "1"), ("num", "2")),
        ]
    )
    at = rng.randrange(len(block.lines) + 1)
    return list(block.lines[:at]) + [extra] + list(block.lines[at:])


def swap(block, rng):
    """Exchanges two arguments."""

    def has(e):
        return e[0] in ("sub", "div", "pair") or e[0] == "blo" and (any(len(d) > 1 for d in e[2]) or len(e[2]) > 1) or e[0] == "val" and len(e[3]) > 1

    def exchanged(items):
        items = list(items)
        i, j = rng.sample(range(len(items)), 2)
        items[i], items[j] = items[j], items[i]
        return tuple(items)

    def new(e):
        if e[0] in ("sub", "div", "pair"):
            return (e[0], e[2], e[1])
        if e[0] == "val":
            return e[:3] + (exchanged(e[3]),)
        if len(e[2]) > 1 and rng.random() < 0.5:
            return ("blo", e[1], exchanged(e[2]))
        k = rng.choice([k for k, d in enumerate(e[2]) if len(d) > 1] or [None])
        return None if k is None else ("blo", e[1], with_item(e[2], k, exchanged(e[2][k])))

    return changed(block, rng, has, new)


def drop_line(block, rng):
    found = [at for at, line in enumerate(block.lines) if line[0] in HYPOTHESES]
    if not found or rng.random() < 0.15:
        found = [at for at, line in enumerate(block.lines) if line[0] in ("let", "point", "vector") + HYPOTHESES]
    if not found:
        return None
    at = rng.choice(found)
    return list(block.lines[:at]) + list(block.lines[at + 1 :])


def exchange_kind(block, rng):
    """A point for a vector, delta for 1, a number for a pair."""
    found = [(at, (), line) for at, line in enumerate(block.lines) if line[0] in ("point", "vector")]
    for at, line in enumerate(block.lines):
        if line[0] in BODY:
            for path, e in nodes(line):
                if path and is_place_of_name(line, path):
                    continue
                if e == ("name", "delta", None) or e[0] == "pair" or path and e[0] in ("num",) and rng.random() < 0.3:
                    found.append((at, path, e))
                elif e[0] == "name" and e[2] is None and rng.random() < 0.2 and path and path[-1] != 1:
                    found.append((at, path, e))
    if not found:
        return None
    at, path, e = rng.choice(found)
    if not path:
        lines = list(block.lines)
        lines[at] = ("vector" if e[0] == "point" else "point",) + e[1:]
        return lines
    if e == ("name", "delta", None):
        new = rng.choice((("num", "1"), ("num", "0"), ("name", "t", None)))
    elif e[0] == "pair":
        new = rng.choice((e[1], ("div", e[1], e[2]), ("pair", e[1], ("num", "1")), ("pair", e[1], ("num", "0"))))
    elif e[0] == "num":
        new = ("name", "delta", None)
    else:
        new = rng.choice((("pair", e, ("num", "1")), ("pair", e, ("name", "w", None)), ("mul", e, ("name", "delta", None))))
    return put(block, at, path, new)


def other_name(block, rng):
    bare, families = names_in(block.lines)

    def new(e):
        pool = sorted((bare if e[2] is None else families) - {e[1]})
        return ("name", rng.choice(pool), e[2]) if pool else None

    return changed(block, rng, lambda e: e[0] == "name", new)


def degree(block, rng):
    places = {"map": 3, "poly": 4, "raise": 2}  # of the degrees in these lines
    found = [
        (at, (places[line[0]], k), e) for at, line in enumerate(block.lines) if line[0] in places for k, e in enumerate(line[places[line[0]]])
    ]
    if not found:
        return None
    at, path, e = rng.choice(found)
    return put(block, at, path, step(e, rng))


def coincide(block, rng):
    """Makes two arguments equal, or replaces a name by a number."""

    def new(e):
        k = rng.choice([k for k, d in enumerate(e[2]) if d] or [None])
        if k is None:
            return None
        d = e[2][k]
        i, j = rng.randrange(len(d)), rng.randrange(len(d))
        fresh = d[j]
        if i == j:
            fresh = number(rng.randrange(2))
            if d[i][0] in ("copies", "fam", "run"):
                return None
        return ("blo", e[1], with_item(e[2], k, with_item(d, i, fresh)))

    return changed(block, rng, lambda e: e[0] == "blo" and sum(map(len, e[2])) > 1, new, STATEMENTS)


def statement_kind(block, rng, new=False):
    found = [at for at, line in enumerate(block.lines) if line[0] in STATEMENTS]
    at = rng.choice(found)
    line = block.lines[at]
    kinds = [k for k in (STATEMENTS if new else STATEMENTS[:2]) if k != line[0]]
    lines = list(block.lines)
    lines[at] = (rng.choice(kinds),) + line[1:]
    return lines


def lifetime(block, rng):
    """Uses the name of a binder outside of it, or a parameter as a binder."""
    bound = set()
    for line in block.lines:
        for _, e in nodes(line):
            if e[0] in ("agg", "fam"):
                bound.add(e[2])
        if line[0] == "poly":
            bound.update(line[2])
        if line[0] == "for":
            bound.add(line[1])
    if not bound:
        return None
    return changed(
        block, rng, lambda e: e[0] == "name" and e[2] is None or e[0] == "num", lambda e: ("name", rng.choice(sorted(bound)), None)
    )


OPERATORS = [
    ("index off by one", off_by_one, 5),
    ("count off by one", count_off_by_one, 5),
    ("lost factor", lost_factor, 5),
    ("sign", sign, 4),
    ("lost summand", lost_summand, 3),
    ("bound of a sum", sum_bound, 4),
    ("empty range", empty_range, 5),
    ("range from 0", lower_parameter, 6),
    ("binder renamed", rename_binder, 7),
    ("redeclared", redeclare, 4),
    ("arguments exchanged", swap, 4),
    ("hypothesis dropped", drop_line, 4),
    ("point for vector", exchange_kind, 5),
    ("another name", other_name, 5),
    ("degree", degree, 3),
    ("arguments coincide", coincide, 3),
    ("claim for refute", statement_kind, 1),
    ("bound name elsewhere", lifetime, 3),
]
WEIGHTS = [w for _, _, w in OPERATORS]


def shrink(block, width):
    """The same block with at most this many values per parameter."""
    lines = []
    for line in block.lines:
        if line[0] == "for" and line[2][0] == "num" and line[3][0] == "num":
            low, high = int(line[2][1]), int(line[3][1])
            line = line[:3] + (number(min(high, low + width)),)
        lines.append(line)
    return lines


def load(folder):
    blocks = []
    for path in sorted(glob.glob(os.path.join(folder, "*.blossom"))):
        with open(path) as f:
            for block in parse_text(f.read()):
                if block.fault is None and any(line[0] in STATEMENTS for line in block.lines):
                    blocks.append(block)
    if not blocks:
        raise SystemExit("no statements in " + folder)
    return blocks


def copy_of(block, lines, id, title):
    out = Block(id, title)
    out.lines = list(lines)
    out.places = list(range(len(lines)))
    out.strict = block.strict
    return out


def mutate(block, rng, changes=1):
    """A changed copy of the lines and the kind of change, or None."""
    kinds = []
    current = block
    for _ in range(changes):
        for _ in range(20):
            name, operator, _ = rng.choices(OPERATORS, WEIGHTS)[0]
            lines = operator(current, rng)
            if lines is not None and lines != list(current.lines):
                break
        else:
            return None
        kinds.append(name)
        current = copy_of(block, lines, block.id, block.title)
    return current, kinds


def generate(index, seed, blocks, attempt=0):
    """The mutation with this number, determined by (seed, index), independent of other mutations. (Block, kinds, source id)"""
    rng = random.Random("mutation %s %s %s" % (seed, index, attempt))
    while True:
        source = blocks[index % len(blocks)] if rng.random() < 0.7 else rng.choice(blocks)
        small = copy_of(source, shrink(source, rng.choice((0, 1, 2, 2))), source.id, source.title)
        changes = rng.choices((0, 1, 2), (3, 80, 17))[0]
        found = mutate(small, rng, changes)
        if found is None:
            continue
        mutated, kinds = found
        return copy_of(mutated, mutated.lines, "m%s-%d" % (seed, index), source.id.replace('"', "")), kinds or ["nothing"], source.id
