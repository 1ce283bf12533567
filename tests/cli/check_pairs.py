#!/usr/bin/env python3
"""Runs every pair of commands: what one prints with --json is given to the other.

There are two parts. In the first, `PRODUCER ... --json | CONSUMER ... -` runs for each two commands, as processes. In the second, every
map that any operation makes of any kind of map is given to every operation that takes maps, as requests. For each pair it is stated
whether it is meaningful. Where it is, it must work, and the answer must be the one for the same map typed by hand; where it is not, it
must be refused with a message. No pair is left out, and --table prints them all.

usage: check_pairs.py PROGRAM [--table]
"""

import json
import subprocess
import sys
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction

program = sys.argv[1]
show = "--table" in sys.argv
problems = 0
counts = Counter()


def expect(true, *what):
    global problems
    if not true:
        problems += 1
        if problems < 12:
            print(*what)


def ask(requests):
    lines = "".join(json.dumps(request) + "\n" for request in requests)
    answers = subprocess.run([program, "batch"], input=lines, capture_output=True, text=True, check=False).stdout.splitlines()
    assert len(answers) == len(requests), (len(answers), len(requests))
    return [json.loads(line) for line in answers]


def run(arguments, given=""):
    return subprocess.run([program, *arguments], input=given, capture_output=True, text=True, check=False)


def kind_of(made):
    """The class of a map: curve, spline, samples, simplex, barycentric, box or net."""
    kind = made["kind"]
    if kind == "samples":
        return "samples"
    if kind == "bspline":
        return "net" if "degrees" in made else "spline"
    if kind == "simplex":
        return "simplex" if "vertices" in made else "barycentric"
    if kind == "tensor" or "degrees" in made:
        return "box"
    return "polynomial" if "variables" in made else "curve"


def is_rational(made):
    return "weights" in made or "denominator" in made or "homogeneous" in made


def domain(made):
    """The interval of a curve or spline; [0, 1] where it has none."""
    if kind_of(made) != "spline":
        return tuple(map(Fraction, made.get("interval", ["0", "1"])))
    begin = spline_span(made["knots"], made["degree"], len(made["control_points"]))
    return Fraction(made["knots"][begin]), Fraction(made["knots"][begin + len(made["control_points"]) - made["degree"]])


def inside(interval, weight=Fraction(1, 3)):
    a, b = map(Fraction, interval)
    return str(a + (b - a) * weight)


def coordinates(made):
    """A point inside the domain of a patch."""
    kind = kind_of(made)
    if kind == "barycentric":
        return ["1/2", "1/4", "1/4"]
    if kind == "net":
        return [inside((knots[degree], knots[-1 - degree])) for knots, degree in zip(made["knots"], made["degrees"])]
    if kind == "simplex":
        return [str(sum(map(Fraction, column)) / 3) for column in zip(*made["vertices"])]
    return [inside(interval) for interval in made.get("intervals", [["0", "1"]] * 2)]


def one_per_direction(made, one, several):
    return one if kind_of(made) in ("curve", "spline", "samples") else several


def degree_of(made):
    if made["kind"] == "hermite":
        return len(made["left"]) + len(made["right"]) - 1
    if made["kind"] == "polynomial" and "text" in made:
        return 2
    return made.get("degree", len(made.get("control_points", made.get("coefficients", []))) - 1)


def has_degree_0(made):
    return 0 in made["degrees"] if "degrees" in made else degree_of(made) == 0


def blossom_fields(made):
    kind = kind_of(made)
    if kind in ("curve", "spline", "samples"):
        spline = {"segment": spline_span(made["knots"], degree_of(made), len(made["control_points"]))} if kind == "spline" else {}
        return {"arguments": ["1/4"] * degree_of(made), **spline}
    if kind in ("box", "net"):
        spans = [spline_span(knots, degree, None) for knots, degree in zip(made["knots"], made["degrees"])] if kind == "net" else None
        return {"arguments": [["1/4"] * degree for degree in made["degrees"]], **({"segment": spans} if spans else {})}
    return {"arguments": [coordinates(made)] * made.get("degree", 2)}


def spline_span(knots, degree, points):
    """The first span: of the polar convention, where there is a knot fewer at each end."""
    return degree - 1 if points is not None and len(knots) == points + degree - 1 else degree


def inner_knots(made):
    a, b = domain(made)
    knots = made["knots"] if kind_of(made) == "spline" else []
    return [knot for knot in knots if a < Fraction(knot) < b]


# First part: processes.

SPLINE = ["--control-points", "0; 1; 3; 0", "--knots", "0,0,0,1,2,2,2", "--degree", "2"]
CLAIM = "claim 1 == 1"
GEOMDL = '{"shape": {"type": "curve", "data": [{"degree": 1, "knotvector": [0, 0, 1, 2, 2], "control_points": {"points": [[0], [1], [0]]}}]}}'
REQUEST = '{"op": "blossom", "map": {"kind": "polynomial", "text": "t"}, "arguments": ["1"]}'

# What each command prints: "spline" and "curve" are maps, "pieces" several maps, and the others are named.
PRODUCERS = {
    "agree": ("nothing", ["t^2"]),
    "blossom": ("nothing", ["t^2", "--at", "0,1"]),
    "evaluate": ("values", ["t^2", "--at", "0,1/2,1"]),
    "derivative": ("curve", ["t^2"]),
    "control-points": ("curve", ["t^2"]),
    "convert": ("spline", ["t^2", "--to", "bspline"]),
    "graph": ("points", ["t^2"]),
    "subdivide": ("pieces", ["t^2", "--at", "1/2"]),
    "elevate": ("curve", ["t^2", "--by", "1"]),
    "reduce": ("curve", ["t^2", "--to", "1"]),
    "interpolate": ("curve", ["--values", "0,1", "--nodes", "0,1"]),
    "inverse-formula": ("nodes", ["--degree", "2"]),
    "insert-knots": ("spline", [*SPLINE, "--insert", "1/2"]),
    "remove-knot": ("spline", [*SPLINE, "--knot", "1"]),
    "segments": ("pieces", SPLINE),
    "join": ("spline", ['{"kind": "bezier", "control_points": ["0", "1", "0"]}']),
    "continuity": ("nothing", [*SPLINE, "--at", "1"]),
    "clamp": ("spline", SPLINE),
    "trim": ("spline", [*SPLINE, "--over", "1/2,3/2"]),
    "reverse": ("spline", SPLINE),
    "reparametrise": ("spline", SPLINE),
    "periodic": ("spline", SPLINE),
    "basis-functions": ("nothing", ["--knots", "0,0,1,1", "--degree", "1", "--at", "1/2"]),
    "basis-matrix": ("nothing", ["--from", '{"basis": "monomial", "degree": 1}', "--to", '{"basis": "bernstein", "degree": 1}']),
    "roots": ("nothing", ["t^2 - 1"]),
    "prove": ("nothing", ["-e", CLAIM]),
    "audit": ("nothing", ["t", "--at", "1", "--computed", '{"values": [1]}']),
    "import": ("spline", ["--format", "geomdl", "--document", GEOMDL]),
    "export": ("document", ["--format", "geomdl", "t^2"]),
    "certify": ("text", [REQUEST]),
    "explain": ("page", ["evaluate", "t^2", "--at", "1"]),
    "exercise": ("page", ["blossom", "--seed", "1"]),
    "barycentric": ("coordinates", ["--vertices", "0;1", "--at", "1/2"]),
}

# How each command takes what stands in standard input, by what it is.
CURVE, SPLINES, OTHER = ("curve", "spline", "points"), ("spline",), ()
CONSUMERS = {
    "agree": (("curve", "points"), ["--map", "-"]),
    "blossom": (CURVE, {"spline": ["--map", "-", "--at", "ARGUMENTS", "--segment", "SPAN"], "": ["--map", "-", "--at", "ARGUMENTS"]}),
    "evaluate": (CURVE, ["--map", "-", "--at", "1/2"]),
    "derivative": (CURVE, ["--map", "-"]),
    "control-points": (CURVE, ["--map", "-"]),
    "convert": (CURVE, {"spline": ["--map", "-", "--to", "monomial", "--segment", "SPAN"], "": ["--map", "-", "--to", "monomial"]}),
    "graph": (CURVE, ["--map", "-"]),
    "subdivide": (CURVE, ["--map", "-", "--at", "3/4"]),
    "elevate": (CURVE, ["--map", "-", "--by", "1"]),
    "reduce": (CURVE, ["--map", "-", "--to", "0"]),
    "interpolate": (("values",), ["--values", "-", "--nodes", "0,1/2,1"]),
    "inverse-formula": (OTHER, ["--degree", "1"]),
    "insert-knots": (SPLINES, ["--map", "-", "--insert", "3/4"]),
    "remove-knot": (SPLINES, ["--map", "-", "--knot", "INNER"]),
    "segments": (SPLINES, ["--map", "-"]),
    "join": (CURVE + ("pieces",), ["-"]),
    "continuity": (SPLINES + ("pieces",), {"spline": ["--map", "-", "--at", "3/4"], "pieces": ["--maps", "-", "--at", "END"]}),
    "clamp": (SPLINES, ["--map", "-"]),
    "trim": (CURVE, ["--map", "-", "--over", "1/2,3/4"]),
    "reverse": (CURVE, ["--map", "-"]),
    "reparametrise": (CURVE, ["--map", "-"]),
    "periodic": (SPLINES, ["--map", "-"]),
    "basis-functions": (OTHER, ["--knots", "0,0,1,1", "--degree", "1"]),
    "basis-matrix": (OTHER, ["--from", '{"basis": "monomial", "degree": 1}', "--to", '{"basis": "bernstein", "degree": 1}']),
    "roots": (CURVE, ["--map", "-"]),
    "prove": (OTHER, ["-e", CLAIM]),
    "audit": (CURVE + ("values",), {"values": ["t^2", "--at", "0,1/2,1", "--computed", "-"], "": ["--map", "-", "--at", "3/4", "--computed", '{"values": [0]}']}),
    "import": (("document",), ["--format", "geomdl", "--document", "-"]),
    "export": (CURVE + ("pieces",), {"pieces": ["--format", "geomdl", "--maps", "-"], "": ["--format", "geomdl", "--map", "-"]}),
    "certify": (OTHER, [REQUEST]),
    "explain": (OTHER, ["evaluate", "t", "--at", "1"]),
    "exercise": (OTHER, ["blossom"]),
    "barycentric": (OTHER, ["--vertices", "0;1", "--at", "1/2"]),
}

# Commands that take maps with points, and those that take only numbers.
NUMBERS_ONLY = ("roots", "audit")


def printed_map(producer):
    result = json.loads(outputs[producer]).get("result", {})
    return result.get("map") or result.get("maps", [{}])[0] if isinstance(result, dict) else {}


def in_words(argument, made):
    """An argument that depends on the map: as many arguments as the degree, a span, a knot, the end of the interval."""
    if argument == "ARGUMENTS":
        return ",".join(["1/2"] * degree_of(made))
    if argument == "SPAN":
        return str(spline_span(made["knots"], made["degree"], len(made["control_points"])))
    if argument == "INNER":
        return (inner_knots(made) or ["1"])[0]
    return made["interval"][1] if argument == "END" else argument


def consumer_arguments(producer, consumer):
    kind = PRODUCERS[producer][0]
    arguments = CONSUMERS[consumer][1]
    if isinstance(arguments, dict):
        arguments = arguments.get(kind, arguments.get("", next(iter(arguments.values()))))
    given = kind in ("curve", "spline", "points", "pieces")
    return [consumer, *(in_words(argument, printed_map(producer)) if given else argument for argument in arguments)]


def reason_against(producer, consumer):
    """Why the pair is not meaningful; None if it is."""
    kind = PRODUCERS[producer][0]
    taken = CONSUMERS[consumer][0]
    if not taken:
        return "it takes no answer of another command"
    if kind == "points" and consumer in NUMBERS_ONLY:
        return "its points are no numbers"
    if kind == "spline" and consumer == "remove-knot" and not inner_knots(printed_map(producer)):
        return "it has no knot inside"
    points = printed_map(producer).get("control_points", []) if kind == "spline" else []
    if consumer == "periodic" and points and points[0] != points[-1]:
        return "it is not closed"
    if kind in taken:
        return None
    if kind == "pieces":
        return "one map is expected, which --map-index chooses"
    return f"it prints {kind}" if kind not in ("curve", "spline", "points") else f"it takes no map of this kind ({kind})"


def has_clear_refusal(answer):
    """Whether it says what is wrong with what was given, not that something in it could not be read."""
    text = answer.stdout + answer.stderr
    return answer.returncode in (1, 2) and bool(text) and "unknown_field" not in text and '"kind" is missing' not in text


def printed_by(producer):
    arguments = PRODUCERS[producer][1]
    return run([producer, *arguments, *(["--format", "json"] if producer == "explain" else ["--json"])]).stdout


def pair(names):
    producer, consumer = names
    options = [] if consumer in ("prove", "explain") else ["--json"]
    return run(consumer_arguments(producer, consumer) + options, outputs[producer])


help_text = run(["--help"]).stdout.split("Subcommands:")[1].split("A value")[0]
operations = [line.split()[0] for line in help_text.splitlines() if line.startswith("  ") and line[2] != " "]
operations = [name for name in operations if name not in ("check-certificate", "batch", "schema", "completion")]
without_entry = [name for name in operations if name not in PRODUCERS]
for name in without_entry:
    CONSUMERS[name] = (OTHER, ["--map", "-"])

with ThreadPoolExecutor() as workers:
    outputs = dict(zip(PRODUCERS, workers.map(printed_by, PRODUCERS)))
    for name, output in outputs.items():
        expect(output, "nothing is printed by", name)
    pairs = [(producer, consumer) for producer in PRODUCERS for consumer in CONSUMERS if consumer in operations]
    answers = list(workers.map(pair, pairs))

for (producer, consumer), answer in zip(pairs, answers):
    reason = reason_against(producer, consumer)
    takes_nothing = not CONSUMERS[consumer][0]
    if reason is None:
        counts["work"] += 1
        expect(answer.returncode == 0, producer, "|", consumer, "must work:", answer.stdout, answer.stderr)
    elif takes_nothing:
        counts["take nothing"] += 1
        expect(answer.returncode == 0 or has_clear_refusal(answer), producer, "|", consumer, answer.stdout, answer.stderr)
    else:
        counts["refused"] += 1
        expect(has_clear_refusal(answer), producer, "|", consumer, "must be refused:", reason, answer.stdout, answer.stderr)
    if show:
        print(f"{producer:18}| {consumer:18}{reason or 'works'}")

# One of several maps is chosen by its index.
for producer in (name for name, (kind, _) in PRODUCERS.items() if kind == "pieces"):
    maps = json.loads(outputs[producer])["result"]["maps"]
    for i, chosen in enumerate(maps):
        answer = run(["elevate", "--map-index", str(i), "--map", "-", "--by", "1", "--json"], outputs[producer])
        expect(json.loads(answer.stdout) == ask([{"op": "elevate", "map": chosen, "by": 1}])[0], producer, i, answer)
    answer = run(["elevate", "--map-index", str(len(maps)), "--map", "-", "--by", "1"], outputs[producer])
    expect(answer.returncode == 2 and "from 0 to" in answer.stderr, producer, answer)
# Rounded numbers beside the exact ones are left out, and an answer that is an error is named.
for numbers in ("double", "hexfloat"):
    rounded = run(["elevate", "t/3", "--by", "1", "--numbers", numbers, "--json"]).stdout
    expect(run(["evaluate", "--map", "-", "--at", "1"], rounded).stdout.endswith("= 1/3\n"), numbers, rounded)
    values = run(["evaluate", "t/3", "--at", "1", "--numbers", numbers, "--json"]).stdout
    answer = run(["audit", "t/3", "--at", "1", "--computed", "-", "--json"], values)
    expect('"not_nearest": 0' in answer.stdout, numbers, answer)
answer = run(["elevate", "--map", "-", "--by", "1"], run(["evaluate", "t", "--json"]).stdout)
expect(answer.returncode == 2 and "is an error" in answer.stderr, answer)

# Second part: requests about maps of every kind.

SOURCES = [
    {"kind": "polynomial", "text": "1+2t-t^2"},
    {"kind": "polynomial", "text": ["1+2t-t^2", "t"]},
    {"kind": "polynomial", "text": "1-t^2", "denominator": "1+t^2"},
    {"kind": "polynomial", "text": ["1-t^2", "2t"], "denominator": "1+t^2"},
    {"kind": "bezier", "control_points": ["-1", "2", "3"]},
    {"kind": "bezier", "control_points": [["-1"], ["2"]]},
    {"kind": "bezier", "control_points": [["1", "0"], ["1", "1"], ["0", "1"]], "weights": ["1", "1", "2"]},
    {"kind": "bezier", "control_points": [["1", "1"], ["1", "1"], ["0", "2"]], "homogeneous": True},
    {"kind": "taylor", "center": "1/3", "coefficients": ["1", "2", "-1"]},
    {"kind": "bspline", "degree": 2, "knots": ["0", "0", "0", "1/2", "1", "1", "1"], "control_points": ["1", "2", "3", "1"]},
    {"kind": "bspline", "degree": 2, "knots": ["0", "0", "1/2", "1", "1"], "control_points": [["1"], ["2"], ["3"], ["1"]]},
    {
        "kind": "bspline",
        "degree": 2,
        "knots": ["0", "0", "0", "1/2", "1", "1", "1"],
        "control_points": [["1", "0"], ["1", "1"], ["0", "1"], ["1", "0"]],
        "weights": ["1", "1", "2", "1"],
    },
    {"kind": "progressive", "knots": ["0", "0", "1", "1"], "control_points": ["-1", "2", "3"]},
    {"kind": "hermite", "interval": ["0", "1"], "left": ["0", "1"], "right": ["1", "2"]},
    {"kind": "samples", "degree": 1, "values": [["0", "1"], ["1", "3"]]},
    {"kind": "simplex", "degree": 1, "control_net": [[[1, 0, 0], "1"], [[0, 1, 0], "2"], [[0, 0, 1], "5"]]},
    {
        "kind": "simplex",
        "degree": 1,
        "control_net": [[[1, 0, 0], ["1"]], [[0, 1, 0], ["2"]], [[0, 0, 1], ["5"]]],
        "vertices": [["0", "0"], ["1", "0"], ["0", "1"]],
    },
    {"kind": "tensor", "degrees": [1, 2], "control_net": [["0", "1", "2"], ["3", "4", "9"]]},
    {"kind": "tensor", "degrees": [1, 1], "control_net": [[["0"], ["2"]], [["1"], ["4"]]], "weights": [["1", "2"], ["1", "1"]]},
    {"kind": "polynomial", "text": "x*y+1", "variables": ["x", "y"]},
    {"kind": "polynomial", "text": "x*y+1", "variables": ["x", "y"], "degrees": [1, 1]},
    {
        "kind": "bspline",
        "degrees": [1, 1],
        "knots": [["0", "0", "1/2", "1", "1"], ["0", "0", "1", "1"]],
        "control_net": [["0", "1"], ["2", "0"], ["3", "1"]],
    },
    {
        "kind": "bspline",
        "degrees": [1, 1],
        "knots": [["0", "0", "1/2", "1", "1"], ["0", "0", "1", "1"]],
        "control_net": [["0", "1"], ["2", "0"], ["3", "1"]],
        "weights": [["1", "1"], ["2", "1"], ["1", "3"]],
    },
]


ALL = {"curve", "spline", "simplex", "barycentric", "box", "polynomial", "net"}
CURVES = {"curve", "spline"}
# What each operation takes, and its other fields.
OPERATIONS = {
    "agree": (ALL - {"spline", "net"}, lambda made: {}),
    "blossom": (ALL, blossom_fields),
    "evaluate": (ALL, lambda made: {"at": [one_per_direction(made, inside(domain(made)), coordinates(made))]}),
    "derivative": (
        ALL,
        lambda made: {
            "order": 1,
            "at": [one_per_direction(made, inside(domain(made)), coordinates(made))],
            **one_per_direction(made, {}, {"direction": ["1", "-1", "0"] if kind_of(made) == "barycentric" else ["1", "0"]}),
        },
    ),
    "control-points": (ALL | {"samples"}, lambda made: {}),
    "convert": (
        ALL - {"barycentric"} | {"samples"},
        lambda made: {"to": "monomial", **({"segment": blossom_fields(made)["segment"]} if kind_of(made) in ("spline", "net") else {})},
    ),
    "graph": (CURVES, lambda made: {}),
    "subdivide": (ALL, lambda made: {"at": one_per_direction(made, inside(domain(made)), coordinates(made))}),
    "elevate": (ALL, lambda made: {"by": 1}),
    "reduce": (CURVES, lambda made: {"to": 0}),
    "insert-knots": ({"spline", "net"}, lambda made: {"knots": one_per_direction(made, [inside(domain(made))], [coordinates(made)[:1], []])}),
    "remove-knot": ({"spline"}, lambda made: {"knot": (inner_knots(made) or ["1/2"])[0]}),
    "segments": ({"spline", "net"}, lambda made: {}),
    "join": (CURVES, lambda made: None),
    "continuity": ({"spline", "net"}, lambda made: {"at": one_per_direction(made, inside(domain(made)), [*coordinates(made)[:1], None])}),
    "clamp": ({"spline"}, lambda made: {}),
    "trim": (CURVES, lambda made: {"interval": [inside(domain(made), Fraction(1, 8)), inside(domain(made))]}),
    "reverse": (CURVES, lambda made: {}),
    "reparametrise": (CURVES, lambda made: {}),
    "roots": (CURVES, lambda made: {"interval": ["0", "1/4"]}),
    "export": (ALL - {"simplex", "barycentric", "polynomial"}, lambda made: {"format": "splinepy"}),
}
# Refusals that depend on the map, by the operation: the code and what must be in the message.
REFUSALS = {
    "roots": [("wrong_kind", "only a map whose values are numbers has roots")],
    "reduce": [("wrong_kind", "rational")],
    "remove-knot": [("bad_knots", "occurs 0 times")],
}


def request_for(operation, made):
    if operation == "join":
        return {"op": "join", "maps": [made]}
    return {"op": operation, "map": made, **OPERATIONS[operation][1](made)}


def maps_of(response):
    result = response.get("result", {})
    return ([result["map"]] if isinstance(result.get("map"), dict) else []) + list(result.get("maps", []))


first = [(operation, source) for source in SOURCES for operation in OPERATIONS]
made = {}
for (operation, source), response in zip(first, ask([request_for(operation, source) for operation, source in first])):
    for one in [source, *maps_of(response)]:
        made.setdefault(json.dumps(one, sort_keys=True), (operation, one))

second = [(producer, one, consumer) for producer, one in made.values() for consumer in OPERATIONS]
for (producer, one, consumer), response in zip(second, ask([request_for(consumer, one) for _, one, consumer in second])):
    kind = kind_of(one)
    error = response.get("error")
    if kind not in OPERATIONS[consumer][0]:
        counts["kinds refused"] += 1
        # A tensor product has no direction of its own, in which these work.
        needs_direction = error and error["code"] == "missing_field" and '"direction"' in error["message"]
        expect(error is None or error["code"] == "wrong_kind" or needs_direction, consumer, "of", one, error)
    elif error is None:
        counts["kinds work"] += 1
    else:
        counts["maps refused"] += 1
        stated = any(error["code"] == code and part in error["message"] for code, part in REFUSALS.get(consumer, []))
        expect(stated, producer, "->", consumer, "of", one, error)

# Third part: what `export` writes of any map, `import` reads and `audit` finds right, in every format.

FORMATS = {"tinyspline": "curves", "geomdl": "all", "splinepy": "all", "mfem": "all", "fitpack": "curves", "svg": "curves"}
EXPORT_REFUSALS = {"wrong_kind", "bad_knots"}


def may_be_exported(form, one):
    """Whether a format has a place for the map; None where that depends on more than its kind."""
    kind = kind_of(one)
    if kind in ("samples", "simplex", "barycentric", "polynomial") or (FORMATS[form] == "curves" and kind in ("box", "net")):
        return False
    if form == "svg" or (form == "mfem" and kind in ("spline", "net")) or has_degree_0(one):
        return None
    return not (is_rational(one) and form in ("tinyspline", "fitpack") and "homogeneous" not in one)


third = [(form, one) for form in FORMATS for _, one in made.values()]
exports = ask([{"op": "export", "format": form, "map": one} for form, one in third])
written = [(form, one, response) for (form, one), response in zip(third, exports)]
documents = []
for form, one, response in written:
    may = may_be_exported(form, one)
    if "result" in response:
        expect(may is not False, "exported", form, one)
        documents.append((form, one, response["result"]["document"]))
    else:
        counts["exports refused"] += 1
        code = response["error"]["code"]
        expect(may is not True and code in EXPORT_REFUSALS, "not exported", form, one, response)
imports = ask([{"op": "import", "format": form, "document": document} for form, _, document in documents])
audits = ask([{"op": "audit", "format": form, "map": one, "document": document} for form, one, document in documents])
for (form, one, document), imported, audited in zip(documents, imports, audits):
    counts["exports work"] += 1
    expect(imported["ok"], form, one, document, imported)
    expect(audited.get("result", {}).get("not_nearest") in (0, "0"), form, one, document, audited)

print(", ".join(f"{count} {name}" for name, count in counts.items()) + f"; without an entry: {without_entry or 'none'}; {problems} problems")
sys.exit(1 if problems else 0)
