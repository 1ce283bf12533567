#!/usr/bin/env python3
"""Requests of every operation, each field of which is as large as the default limits allow, alone and together.

    check_largest_arguments.py PROGRAM [--full] [--seed S] [--cases N] [--jobs N]

The operations, their fields and the words that these may be are those of `blossom schema`. An operation, field or kind of map for
which largest_arguments.py and largest_maps.py have no values is an error. A request has axes: the degree, the number of points, the
dimension and the digits of its map, and each field. First each axis alone is at its largest, then pairs of them, then all, on every
kind of map. Each request must get one response, which is not `internal`, within the processor time and the memory of the limits. By
default a sample of the requests runs, half a minute long, with a timeout of one second; --full has the default timeout and runs all
requests, but of the pairs only a sample.
"""

import argparse
import json
import multiprocessing.pool
import random
import subprocess
import sys
from typing import NamedTuple

from largest_arguments import FIELDS, OF_OPERATION
from largest_maps import KINDS, MAP_AXES, NUMBERS, Shape
from measured import run_alone


def words_of(schema, field):
    """The words that a field may be, wherever an operation's description lists them."""
    found = []

    def walk(node):
        if isinstance(node, list):
            for part in node:
                walk(part)
        elif isinstance(node, dict):
            own = node.get("properties", {}).get(field)
            if isinstance(own, dict):
                found.extend(own.get("enum", []))
                for alternative in own.get("anyOf", []):
                    found.extend(alternative.get("enum", []))
            for part in node.values():
                walk(part)

    walk(schema)
    return list(dict.fromkeys(found))


class Operation:
    def __init__(self, name, schema):
        self.name, self.schema = name, schema
        self.fields = {}
        self.missing = []
        # Without these, which are needed in one form or another, a request says too little.
        self.required = set(schema["required"]) | {"convert": {"to"}, "audit": {"computed", "at"}, "continuity": {"at"}}.get(name, set())
        for field, description in schema["properties"].items():
            if field in ("op", "map", "maps"):
                continue
            words = words_of(schema, field)
            levels, value = OF_OPERATION.get((name, field), FIELDS.get(field, (None, None)))
            if levels is None and words:
                default = words[0] if field in self.required else None
                levels, value = [], lambda a_map, level, default=default: default
            if levels is None and description.get("type") == "boolean":
                levels, value = [True, False], lambda a_map, level: level
            if levels is None:
                self.missing.append(field)
                continue
            self.fields[field] = ([*words, *levels], value)
        self.takes_maps = [field for field in ("map", "maps") if field in schema["properties"]]

    def find_makers(self, program):
        """Those of maps that the operation takes. What is small must be answered, or the kind be refused."""
        self.makers = []
        problems = []
        for maker in [maker for makers in KINDS.values() for maker in makers] if self.takes_maps else [None]:
            answer = answer_of(run_alone(program, [], self.request(maker, {})).output)
            if answer == "ok":
                self.makers.append(maker)
            elif not answer.startswith("wrong_kind"):
                problems.append(f"{self.name} {maker.__name__ if maker else ''}: a small request: {answer}")
        return problems

    def axes(self):
        """The names of the axes, with the number of levels of each."""
        return ({name: len(levels) for name, levels in MAP_AXES.items()} if self.takes_maps else {}) | {
            name: len(levels) for name, (levels, _) in self.fields.items()
        }

    def request(self, maker, chosen):
        """The line of the request with the chosen levels, as long as it may be. It is made of values that fit together."""
        sizes = {name: MAP_AXES[name][level] for name, level in chosen.items() if name in MAP_AXES}
        for name, most in (("dimension", NUMBERS), ("points of the map", NUMBERS)):
            if name in sizes:
                sizes[name] = min(sizes[name], most)
        a_map = maker(Shape(sizes)) if maker else None
        request = {"op": self.name}
        if "map" in self.takes_maps:
            request["map"] = a_map
        elif "maps" in self.takes_maps:
            second = dict(a_map)
            if a_map["kind"] == "bezier":
                second["interval"] = [1, 2]
            request["maps"] = [a_map, second]
        for field, (levels, value) in self.fields.items():
            if self.name == "audit" and (field in ("document", "format")) != ("document" in chosen or "format" in chosen):
                continue
            if field == "direction" and "directions" in chosen:
                continue
            level = levels[chosen[field]] if field in chosen else None
            is_word = isinstance(level, str) and level in words_of(self.schema, field)
            result = level if is_word else value(a_map or {"kind": "none"}, level)
            if result is not None:
                request[field] = result
        return json.dumps(request, separators=(",", ":")).encode()


def operations(program):
    schema = json.loads(subprocess.run([program, "schema"], capture_output=True, check=True).stdout)["$defs"]
    names = [entry["$ref"].rsplit("/", 1)[1] for entry in schema["request"]["anyOf"]]
    kinds = [entry["$ref"].rsplit("/", 1)[1] for entry in schema["map"]["anyOf"]]
    missing = [f"the kind {kind} of maps" for kind in kinds if kind not in KINDS]
    result, problems = [], []
    for name in names:
        operation = Operation(name.removesuffix("_request"), schema[name])
        missing += [f"the field {field} of {operation.name}" for field in operation.missing]
        if not operation.missing:
            problems += operation.find_makers(program)
        result.append(operation)
    if missing:
        sys.exit("no largest values for " + ", ".join(missing))
    if problems:
        sys.exit("\n".join(problems))
    return result


def cases_of(operation, random_source, pairs):
    """Operation, form of the map, and the levels of the axes that are at their largest."""
    axes = operation.axes()
    for index, maker in enumerate(operation.makers):
        for name, levels in axes.items():
            for level in range(levels):
                # What has nothing to do with the map is tried with one.
                if index == 0 or name not in ("id", "numbers", "format"):
                    yield operation, maker, {name: level}
        for _ in range(2):
            yield operation, maker, {name: random_source.randrange(levels) for name, levels in axes.items() if levels and name != "id"}
    for _ in range(pairs):
        names = random_source.sample([name for name, levels in axes.items() if levels], min(2, len(axes)))
        yield operation, random_source.choice(operation.makers), {name: random_source.randrange(axes[name]) for name in names}


class Result(NamedTuple):
    case: tuple
    name: str
    line_bytes: int
    seconds: float
    size: int
    answer: str  # "ok", or the code and the message of an error
    problem: str  # "" if nothing is wrong


def answer_of(output):
    """Without parsing what may be long: members stand in a fixed order, and an `id` before them or a result after them is long."""
    if b'"ok": true' in output[:200] or b'"ok": true, "result"' in output:
        return "ok"
    tail = output[output.rfind(b'"ok": false, "error"') :].decode(errors="replace")
    error = json.loads("{" + tail)["error"]
    return f"{error['code']}: {error['message'][:120]}"


class Checker:
    def __init__(self, program, full):
        self.program = program
        self.options = [] if full else ["--timeout", "1"]
        floor = run_alone(program, [], b'{"op": "evaluate", "map": {"kind": "polynomial", "text": "t"}, "at": [1]}').size
        # The measures of the system are coarser than the counters of the program.
        self.seconds = 1.25 * (10 if full else 1) + 1
        self.size = floor + 1.25 * (1 << 30)

    def check(self, case):
        operation, maker, chosen = case
        name = f"{operation.name} {maker.__name__ if maker else ''} {', '.join(f'{axis}={level}' for axis, level in chosen.items())}"
        line = operation.request(maker, chosen)
        measured = run_alone(self.program, self.options, line)
        answer, problem = "", ""
        if measured.status not in (0, 1) or measured.output.count(b"\n") != 1:
            problem = f"exit status {measured.status}, {len(measured.output)} bytes"
        else:
            answer = answer_of(measured.output)
            if answer.startswith("internal"):
                problem = answer
            elif measured.seconds > self.seconds:
                problem = f"{measured.seconds:.1f} s"
            elif measured.size > self.size:
                problem = f"{measured.size >> 20} MB"
        return Result(case, name, len(line), measured.seconds, measured.size, answer, problem)


def unreached(results):
    """Fields and axes whose largest values were only ever refused as wrong, so that no limit was tried."""
    reached = {}
    for result in results:
        operation, _, chosen = result.case
        good = result.answer == "ok" or result.answer.startswith("limit_exceeded")
        for name in chosen:
            key = (operation.name, name)
            reached[key] = reached.get(key, False) or good
    return [f"{operation}: {name}" for (operation, name), good in reached.items() if not good]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--full", action="store_true")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--only", default="", help="the operations whose names begin so")
    parser.add_argument("--cases", type=int, help="per operation")
    options = parser.parse_args()
    random_source = random.Random(options.seed)
    cases = []
    for operation in operations(options.program):
        if operation.name.startswith(options.only):
            own = list(cases_of(operation, random_source, 40))
            count = options.cases or (len(own) if options.full else 4)
            cases += random_source.sample(own, min(count, len(own)))
    checker = Checker(options.program, options.full)
    with multiprocessing.pool.ThreadPool(options.jobs) as pool:
        results = []
        for result in pool.imap_unordered(checker.check, cases):
            results.append(result)
            if options.full:
                print(f"{result.seconds:6.2f} s {result.size >> 20:5} MB {result.line_bytes:9} bytes  {result.name}  {result.answer}", flush=True)
    failures = [f"{result.name}: {result.problem}" for result in results if result.problem]
    if options.full:
        failures += [f"no limit is reached by {what}" for what in unreached(results)]
    for failure in failures:
        print(failure)
    print(
        f"seed {options.seed}: {len(cases)} requests, {sum(result.answer == 'ok' for result in results)} answered, "
        f"{sum(result.answer.startswith('limit_exceeded') for result in results)} refused by limits; at most "
        f"{max(result.seconds for result in results):.1f} s, {max(result.size for result in results) >> 20} MB; {len(failures)} failures"
    )
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
