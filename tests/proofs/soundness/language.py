"""Reader and printer of the identity language, written from its definition and independent of the prover.

A block is a list of lines, a line and an expression are tuples, so that they can be compared, changed and printed back:

    ('num', text)  ('name', base, None or indices)  ('neg', a)  ('add'|'sub'|'mul'|'div'|'pow', a, b)
    ('pair', a, b)  ('tuple', parts)  ('agg', 'sum'|'prod'|'mean', binder, domain, body)
    ('fn', name, args)  ('if', (op, a, b), then, else)  ('det', i, j, n, body)  ('dif', body, name, order or None)
    ('val', map, order, args)    order: None, ('primes', k) or ('D', orders)
    ('blo', map, directions)     arguments: expression, ('copies', e, n), ('run', a, b), ('fam', e, i, domain, filters)
    domain: ('rng', lo, hi) or ('set', e);   filter: ('!=', a, b) or ('notin', a, set)
"""

import re

HYPOTHESES = ("assume", "given")
STATEMENTS = ("claim", "refute", "refute some")


class SyntaxFault(Exception):
    def __init__(self, text, line=0):
        super().__init__(text)
        self.line = line


TOKEN = re.compile(
    r"""[ \t\r]*(?:(?P<num>\d+(?:\.\d+(?:[eE][+-]?\d+)?)?)|(?P<id>[A-Za-z][A-Za-z0-9]*)|(?P<str>"[^"\n]*")"""
    r"""|(?P<op>==|!=|<=|>=|\.\.|[-+*/^(){}\[\]<>=,:;_.'])|(?P<nl>\n)|(?P<comment>\#[^\n]*)|(?P<bad>[^ \t\r]))"""
)
GOES_ON = {"+", "-", "*", "/", "^", "==", "!=", "=", ",", ":", ";", "..", "<", "<=", ">", ">=", "."}
AGGREGATES = ("sum", "prod", "mean")
FUNCTIONS = {
    "binomial": 2, "factorial": 1, "bernstein": 3, "size": 1, "sign": 1, "bspline": 5,
    "without": 2, "subsets": 2, "partitions": 1, "permutations": 1,
}
RESERVED = set(AGGREGATES) | set(FUNCTIONS) | {"if", "determinant"}


def tokens_of(text):
    """The tokens (kind, text, line, glued) of a text; a line ends with a token of kind 'nl'."""
    out = []
    depth = 0
    line = 1
    last = None
    at = 0
    first = True
    pairs = 0
    for match in TOKEN.finditer(text):
        kind = match.lastgroup
        value = match.group(kind)
        if kind == "comment":
            continue
        if kind == "nl":
            if last is not None and depth == 0 and last not in GOES_ON:
                out.append(("nl", "\n", line, False))
                last = None
                pairs = 0
            line += 1
            first = True
            continue
        if first and kind == "id" and value == "theorem":
            if last is not None:
                out.append(("nl", "\n", line, False))
            depth = 0
        first = False
        if kind == "bad":
            raise SyntaxFault("unknown character " + value, line)
        if kind == "op":
            if value in "([{":
                depth += 1
            elif value in ")]}":
                depth = max(0, depth - 1)
            elif value == "<" and (last is None or last in GOES_ON or last in ("(", "[", "{")):
                pairs += 1  # where an operand is expected, it opens a pair
            elif value == ">" and pairs:
                pairs -= 1
                out.append((kind, value, line, False))
                at = match.end()
                last = "> of a pair"
                continue
        out.append((kind, value, line, match.start(kind) == at))
        at = match.end()
        last = value
    out.append(("nl", "\n", line, False))
    return out


class Parser:
    def __init__(self, tokens, dots=False):
        self.t = tokens
        self.i = 0
        self.dots = dots

    def fault(self, what):
        token = self.t[self.i]
        raise SyntaxFault("%r found, expected %s" % (token[1], what), token[2])

    def peek(self, k=0):
        return self.t[self.i + k][1]

    def take(self, value):
        if self.t[self.i][1] == value and self.t[self.i][0] != "str":
            self.i += 1
            return True
        return False

    def need(self, value):
        if not self.take(value):
            self.fault(repr(value))

    def ident(self):
        kind, value, _, _ = self.t[self.i]
        if kind != "id":
            self.fault("a name")
        self.i += 1
        return value

    def end(self):
        if self.t[self.i][0] != "nl":
            self.fault("the end of the line")
        self.i += 1

    # expressions

    def expr(self):
        left = self.term()
        while True:
            op = self.t[self.i][1]
            if op == "+":
                self.i += 1
                left = ("add", left, self.term())
            elif op == "-":
                self.i += 1
                left = ("sub", left, self.term())
            else:
                return left

    def term(self):
        left = self.unary()
        while True:
            op = self.t[self.i][1]
            if op == "*":
                self.i += 1
                left = ("mul", left, self.unary())
            elif op == "/":
                self.i += 1
                left = ("div", left, self.unary())
            else:
                return left

    def unary(self):
        if self.take("-"):
            return ("neg", self.unary())
        return self.power()

    def power(self):
        base = self.primary()
        if self.take("^"):
            return ("pow", base, self.unary())
        return base

    def index(self):
        """The index after `_`."""
        if self.take("{"):
            out = [self.expr()]
            while self.take(","):
                out.append(self.expr())
            self.need("}")
            return tuple(out)
        kind, value, _, _ = self.t[self.i]
        if kind == "num":
            self.i += 1
            return (("num", value),)
        if kind == "id":
            self.i += 1
            return (("name", value, None),)
        self.fault("an index")

    def name(self):
        base = self.ident()
        if self.take("_"):
            return ("name", base, self.index())
        return ("name", base, None)

    def domain(self):
        """`lo, hi` or a set, followed by a comma."""
        first = self.expr()
        self.need(",")
        second = self.expr()
        if self.take(","):
            return ("rng", first, second), self.expr()
        return ("set", first), second

    def args(self):
        out = []
        if not self.take(")"):
            out.append(self.expr())
            while self.take(","):
                out.append(self.expr())
            self.need(")")
        return tuple(out)

    def condition(self):
        left = self.expr()
        op = self.peek()
        if op in ("==", "!=", "<", "<=", ">", ">="):
            self.i += 1
            return (op, left, self.expr())
        if self.take("in"):
            return ("in", left, self.expr())
        if self.take("not"):
            self.need("in")
            return ("notin", left, self.expr())
        self.fault("a comparison")

    def primary(self):
        kind, value, _, _ = self.t[self.i]
        if kind == "num":
            self.i += 1
            return ("num", value)
        if value == "(" and kind == "op":
            self.i += 1
            parts = [self.expr()]
            while self.take(","):
                parts.append(self.expr())
            self.need(")")
            return parts[0] if len(parts) == 1 else ("tuple", tuple(parts))
        if value == "<" and kind == "op":
            self.i += 1
            u = self.expr()
            self.need(",")
            v = self.expr()
            self.need(">")
            return ("pair", u, v)
        if kind != "id":
            self.fault("an expression")
        follows = self.t[self.i + 1][1]
        if follows == "(":
            if value in AGGREGATES:
                self.i += 2
                binder = self.ident()
                self.need(",")
                domain, body = self.domain()
                self.need(")")
                return ("agg", value, binder, domain, body)
            if value == "if":
                self.i += 2
                condition = self.condition()
                self.need(",")
                then = self.expr()
                self.need(",")
                other = self.expr()
                self.need(")")
                return ("if", condition, then, other)
            if value == "determinant":
                self.i += 2
                i = self.ident()
                self.need(",")
                j = self.ident()
                self.need(",")
                n = self.expr()
                self.need(",")
                body = self.expr()
                self.need(")")
                return ("det", i, j, n, body)
            if value in FUNCTIONS:
                self.i += 2
                args = self.args()
                if len(args) != FUNCTIONS[value]:
                    self.fault("%d arguments of %s" % (FUNCTIONS[value], value))
                return ("fn", value, args)
            if value == "D":
                self.i += 2
                args = self.args()
                if self.take("("):
                    if not args or args[0][0] != "name" or args[0][2] is not None or len(args) < 2:
                        self.fault("a map and orders in D")
                    return ("val", args[0][1], ("D", args[1:]), self.args())
                if len(args) not in (2, 3) or args[1][0] != "name":
                    self.fault("D(e, name) or D(e, name, order)")
                return ("dif", args[0], args[1], args[2] if len(args) == 3 else None)
        self.i += 1
        if self.peek() == "_":
            self.i += 1
            node = ("name", value, self.index())
            return self.dotted(node) if self.dots else node
        if self.dots and self.peek() == ".":
            return self.dotted(("name", value, None))
        primes = 0
        while self.take("'"):
            primes += 1
        if self.take("("):
            return ("val", value, ("primes", primes) if primes else None, self.args())
        if primes:
            self.fault('"("')
        if self.take("["):
            directions = [[]]
            while not self.take("]"):
                if self.take(";"):
                    directions.append([])
                    continue
                directions[-1].append(self.argument())
                if self.peek() not in (";", "]"):
                    self.need(",")
                    if self.peek() in (";", "]"):
                        self.fault("an argument")
            return ("blo", value, tuple(tuple(d) for d in directions))
        return ("name", value, None)

    def dotted(self, node):
        parts = []
        while self.take("."):
            parts.append(int(self.t[self.i][1]))
            self.i += 1
        return ("symbol", node, tuple(parts)) if parts else node

    def argument(self):
        e = self.expr()
        if self.take("{"):
            count = self.expr()
            self.need("}")
            return ("copies", e, count)
        if self.take(".."):
            return ("run", e, self.expr())
        if self.take(":"):
            binder = self.ident()
            self.need("in")
            low = self.expr()
            if self.take(".."):
                domain = ("rng", low, self.expr())
            else:
                domain = ("set", low)
            filters = []
            while self.peek() == "," and self.t[self.i + 1][0] == "id":
                keep = self.i
                self.i += 1
                left = self.expr()
                if self.take("!="):
                    filters.append(("!=", left, self.expr()))
                elif self.take("not"):
                    self.need("in")
                    filters.append(("notin", left, self.expr()))
                else:
                    self.i = keep
                    break
            return ("fam", e, binder, domain, tuple(filters))
        return e

    # lines

    def names(self):
        out = [self.ident()]
        while self.take(","):
            out.append(self.ident())
        return tuple(out)

    def items(self):
        """Names, members and runs: x, y_1..y_k."""
        out = []
        while True:
            name = self.name()
            out.append(("run", name, self.name()) if self.take("..") else name)
            if not self.take(","):
                return tuple(out)

    def degrees(self):
        if self.take("degree"):
            out = (self.expr(),)
            return "one", out
        self.need("degrees")
        out = [self.expr()]
        while self.take(","):
            out.append(self.expr())
        return "many", tuple(out)

    def ranges(self):
        ranges = []
        universal = []
        while self.take("for"):
            if self.take("all"):
                universal.extend(self.items())
            else:
                ranges.append(self.range())
        return tuple(ranges), tuple(universal)

    def range(self):
        binder = self.ident()
        self.need("in")
        low = self.expr()
        self.need("..")
        return (binder, low, self.expr())

    def line(self):
        word = self.ident()
        if word == "for":
            out = ("for",) + self.range()
        elif word == "map":
            names = self.names()
            form, degrees = self.degrees()
            simplex = None
            if form == "one" and self.take("on"):
                self.need("simplex")
                simplex = self.expr()
            net = None
            if self.take("net"):
                control = self.ident()
                self.need("over")
                over = [self.expr()]
                while self.take(","):
                    over.append(self.expr())
                net = (control, tuple(over))
            out = ("map", names, form, degrees, simplex, net)
        elif word in ("point", "vector"):
            items = self.items()
            self.need("in")
            out = (word, items, self.expr())
        elif word == "frame":
            names = self.names()
            self.need("in")
            out = ("frame", names, self.expr())
        elif word == "number":
            out = ("number", self.items(), None)
        elif word == "poly":
            name = self.ident()
            self.need("(")
            variables = self.names()
            self.need(")")
            form, degrees = self.degrees()
            self.need("=")
            out = ("poly", name, variables, form, degrees, self.expr())
        elif word == "raise":
            name = self.ident()
            self.need("to")
            degrees = [self.expr()]
            while self.take(","):
                degrees.append(self.expr())
            self.need("as")
            out = ("raise", name, tuple(degrees), self.ident())
        elif word == "let":
            name = self.name()
            self.need("=")
            out = ("let", name, self.expr())
        elif word in ("assume", "given", "claim", "refute"):
            if word == "refute" and self.peek() == "some" and self.t[self.i + 1][1] not in ("==", "+", "*", "/", "^", "[", "_"):
                self.i += 1
                word = "refute some"
            left = self.expr()
            self.need("!=" if word == "assume" else "==")
            right = self.expr()
            ranges, universal = self.ranges()
            if universal and word != "given":
                self.fault("ranges")
            out = (word, left, right, ranges, universal)
        else:
            self.i -= 1
            self.fault("a line of a block")
        self.end()
        return out


class Block:
    """One theorem: its lines and their positions in the text."""

    def __init__(self, id="", title=""):
        self.id = id
        self.title = title
        self.lines = []
        self.places = []
        self.strict = False
        self.fault = None

    def statements(self):
        """The claims and refutations with their numbers among the lines."""
        return [(at, line) for at, line in enumerate(self.lines) if line[0] in STATEMENTS]

    def declared(self):
        """The names that lines declare, without the members of families."""
        out = []
        for line in self.lines:
            word = line[0]
            if word in ("map", "frame"):
                out.extend(line[1])
            elif word in ("for", "poly"):
                out.append(line[1])
            elif word == "raise":
                out.append(line[3])
            elif word == "let":
                out.append(line[1][1])
            elif word in ("point", "vector"):
                out.extend(item[1] for item in line[1] if item[0] == "name")
        return out

    def text(self):
        head = 'theorem %s "%s"\n' % (self.id, self.title) if self.id else ""
        return head + "".join(show_line(line) + "\n" for line in self.lines)


def parse_text(text):
    """The blocks of a text; a block that cannot be read has a fault."""
    parser = Parser(tokens_of(text))
    blocks = []
    current = Block()
    strict = False
    head = re.compile(r'theorem\s+([A-Za-z0-9_.-]+)\s*(?:"([^"]*)")?\s*(?:#.*)?$')
    rows = text.split("\n")
    if parser.peek() == "strict" and parser.peek(1) == "\n":
        parser.i += 2
        strict = True
    while parser.i < len(parser.t):
        kind, value, line, _ = parser.t[parser.i]
        if kind == "nl":
            parser.i += 1
            continue
        if value == "theorem":
            if current.lines or current.id or current.fault:
                blocks.append(current)
            match = head.match(rows[line - 1].strip())
            current = Block(match.group(1), match.group(2) or "") if match else Block("?")
            if not match:
                current.fault = SyntaxFault("the head of a theorem", line)
            while parser.t[parser.i][0] != "nl":
                parser.i += 1
            continue
        try:
            current.lines.append(parser.line())
            current.places.append(line)
        except SyntaxFault as fault:
            current.fault = current.fault or fault
            while parser.t[parser.i][0] != "nl":
                parser.i += 1
    if current.lines or current.id or current.fault:
        blocks.append(current)
    for block in blocks:
        block.strict = strict
    return blocks


def parse_expr(text, dots=False):
    parser = Parser(tokens_of(text), dots)
    out = parser.expr()
    parser.end()
    return out


def parse_comparison(text, dots=False):
    parser = Parser(tokens_of(text), dots)
    out = parser.condition()
    parser.end()
    return out


# printing

LEVEL = {"add": 1, "sub": 1, "mul": 2, "div": 2, "neg": 3, "pow": 4}
SIGN = {"add": " + ", "sub": " - ", "mul": "*", "div": "/"}


def show(node, level=0):
    kind = node[0]
    if kind == "num":
        return node[1]
    if kind == "name":
        return show_name(node)
    if kind in SIGN:
        own = LEVEL[kind]
        right = show(node[2], own + 1)
        text = show(node[1], own) + SIGN[kind] + right
        return "(" + text + ")" if own < level else text
    if kind == "neg":
        text = "-" + show(node[1], 3)
        return "(" + text + ")" if level > 1 else text
    if kind == "pow":
        exponent = node[2]
        simple = exponent[0] in ("num", "name")
        text = show(node[1], 5) + "^" + (show(exponent) if simple else "(" + show(exponent) + ")")
        return "(" + text + ")" if level > 4 else text
    if kind == "pair":
        return "<%s, %s>" % (show(node[1]), show(node[2]))
    if kind == "tuple":
        return "(" + ", ".join(map(show, node[1])) + ")"
    if kind == "agg":
        return "%s(%s, %s, %s)" % (node[1], node[2], show_domain(node[3]), show(node[4]))
    if kind == "fn":
        return "%s(%s)" % (node[1], ", ".join(map(show, node[2])))
    if kind == "if":
        op, a, b = node[1]
        return "if(%s %s %s, %s, %s)" % (show(a), "not in" if op == "notin" else op, show(b), show(node[2]), show(node[3]))
    if kind == "det":
        return "determinant(%s, %s, %s, %s)" % (node[1], node[2], show(node[3]), show(node[4]))
    if kind == "dif":
        return "D(%s, %s%s)" % (show(node[1]), show(node[2]), ", " + show(node[3]) if node[3] else "")
    if kind == "val":
        args = "(" + ", ".join(map(show, node[3])) + ")"
        if node[2] is None:
            return node[1] + args
        if node[2][0] == "primes":
            return node[1] + "'" * node[2][1] + args
        return "D(%s, %s)%s" % (node[1], ", ".join(map(show, node[2][1])), args)
    if kind == "blo":
        return node[1] + "[" + "; ".join(", ".join(map(show_argument, d)) for d in node[2]) + "]"
    raise ValueError(kind)


def show_name(node):
    if node[2] is None:
        return node[1]
    if len(node[2]) == 1:
        one = node[2][0]
        if one[0] == "num" or (one[0] == "name" and one[2] is None):
            return node[1] + "_" + one[1]
    return node[1] + "_{" + ",".join(map(show, node[2])) + "}"


def show_domain(domain):
    if domain[0] == "rng":
        return show(domain[1]) + ", " + show(domain[2])
    return show(domain[1])


def show_argument(a):
    if a[0] == "copies":
        return show(a[1]) + "{" + show(a[2]) + "}"
    if a[0] == "run":
        return show(a[1]) + ".." + show(a[2])
    if a[0] == "fam":
        domain = a[3]
        text = "%s : %s in " % (show(a[1]), a[2])
        text += show(domain[1]) + ".." + show(domain[2]) if domain[0] == "rng" else show(domain[1])
        for f in a[4]:
            text += ", %s %s %s" % (show(f[1]), "!=" if f[0] == "!=" else "not in", show(f[2]))
        return text
    return show(a)


def show_item(item):
    return show_name(item[1]) + ".." + show_name(item[2]) if item[0] == "run" else show_name(item)


def show_degrees(form, degrees):
    return ("degree " if form == "one" else "degrees ") + ", ".join(map(show, degrees))


def show_line(line):
    word = line[0]
    if word == "for":
        return "for %s in %s..%s" % (line[1], show(line[2]), show(line[3]))
    if word == "map":
        text = "map %s %s" % (", ".join(line[1]), show_degrees(line[2], line[3]))
        if line[4] is not None:
            text += " on simplex " + show(line[4])
        if line[5] is not None:
            text += " net %s over %s" % (line[5][0], ", ".join(map(show, line[5][1])))
        return text
    if word in ("point", "vector"):
        return "%s %s in %s" % (word, ", ".join(map(show_item, line[1])), show(line[2]))
    if word == "frame":
        return "frame %s in %s" % (", ".join(line[1]), show(line[2]))
    if word == "number":
        return "number " + ", ".join(map(show_item, line[1]))
    if word == "poly":
        return "poly %s(%s) %s = %s" % (line[1], ", ".join(line[2]), show_degrees(line[3], line[4]), show(line[5]))
    if word == "raise":
        return "raise %s to %s as %s" % (line[1], ", ".join(map(show, line[2])), line[3])
    if word == "let":
        return "let %s = %s" % (show_name(line[1]), show(line[2]))
    text = "%s %s %s %s" % (word, show(line[1]), "!=" if word == "assume" else "==", show(line[2]))
    for binder, low, high in line[3]:
        text += " for %s in %s..%s" % (binder, show(low), show(high))
    if line[4]:
        text += " for all " + ", ".join(map(show_item, line[4]))
    return text
