#!/usr/bin/env python3
"""Validates the requests and responses of the documents and the golden files with docs/protocol.schema.json.

usage: validate_schema.py ROOT PROGRAM; the exit status 77 means that jsonschema is not installed.
"""

import json
import pathlib
import subprocess
import sys

try:
    import jsonschema
except ImportError:
    sys.exit(77)

root, program = pathlib.Path(sys.argv[1]), sys.argv[2]
schema = json.loads((root / "docs/protocol.schema.json").read_text(encoding="utf-8"))
jsonschema.Draft202012Validator.check_schema(schema)


def validator(name):
    return jsonschema.Draft202012Validator({"$ref": f"#/$defs/{name}", "$defs": schema["$defs"]})


def documented_requests():
    inside = False
    for line in (root / "docs/protocol.md").read_text(encoding="utf-8").splitlines():
        if line.startswith("```"):
            inside = line == "```jsonl"
        elif inside and '"op"' in line:
            yield json.loads(line)


def golden_requests():
    for line in (root / "tests/golden/protocol-examples.jsonl").read_text(encoding="utf-8").splitlines():
        yield json.loads(line)["request"]


def statements():
    """Every member that an answer to `prove` may have: conditions, roots, open cases, cases of all verdicts, several lines."""
    for text in (
        "theorem one \"title\"\nfor n in 1..2\nclaim x^n/x == x^(n-1)",
        "for n in 1..2\nclaim n == i for i in 1..n",
        "given w^2 == 1/2\nclaim w == 1",
        "given w^2 == 1/2\nclaim w^4 == 1/4\nclaim w == x",
        "given a*x == a\nclaim x == 1",
        "for n in 1..3\nmap b degree n\nrefute b[s, t] == 1",
        "refute some 1 == 2",
        "map q degree 2 on simplex 2 net c over P, Q, R\npoint P, Q, R in 2\nclaim q(P) == c_{0,2,0}",
        "strict\nclaim x == x",
        "claim delta == 1",
        "given 1 == 2\nclaim 1 == 1",
    ):
        yield {"op": "prove", "statement": text}


def audits():
    """Requests with numbers in every form, and with missing or additional members."""
    ends = {"kind": "hermite", "left": ["1"], "right": ["2"], "denominator": {"left": ["1"], "right": ["1/3"]}}
    line = {"kind": "simplex", "degree": 1, "control_net": [[[1, 0], "1"], [[0, 1], "2"]]}
    curve = {"kind": "taylor", "center": "1/2", "coefficients": [["1", "2"]]}
    document = {"degree": 0, "dimension": 2, "control_points": [1, 2], "knots": [0, 1]}
    for map_, rest in (
        (ends, {"computed": {"denominator": {"left": [1], "right": [0.5]}}}),
        (ends, {"computed": {"denominator": {"left": [1]}}}),
        (line, {"computed": {"control_net": [[[0, 1], 0.5], [[1, 0], "0x1p-3"]]}}),
        (line, {"at": [["1/2", "1/2"]], "computed": {"values": [0.5]}}),
        (line, {"at": [["1/2", "1/2"]], "computed": {"control_net": [[[0, 1], 0.5], [[1, 0], 1]]}}),
        (curve, {"computed": {"center": 0.25, "coefficients": [[1, 3]]}}),
        (curve, {"computed": {"points": [[1, 3]]}}),
        (curve, {"format": "tinyspline", "document": document}),
        (curve, {"format": "tinyspline", "document": document, "at": ["0"]}),
    ):
        yield {"op": "audit", "map": map_, **rest}


requests = [*documented_requests(), *golden_requests(), *statements(), *audits()]
requests.append({"op": "inverse-formula", "degree": 1, "interval": [0, 1], "vertices": [["0"], ["1"]]})
requests += [{**request, "numbers": rounding} for request in requests for rounding in ("double", "hexfloat")]
lines = "".join(json.dumps(request) + "\n" for request in requests)
answers = subprocess.run([program, "batch"], input=lines, capture_output=True, text=True, check=False).stdout
responses = [json.loads(line) for line in answers.splitlines()]
assert len(responses) == len(requests) > 60, len(responses)

# Requests whose form alone is wrong, so that the schema must also refuse them.
form_errors = {"inexact_number", "missing_field", "unknown_field", "unknown_op", "wrong_kind"}
problems = 0
members = set()


def collect(value):
    if isinstance(value, dict):
        members.update(value)
        for one in value.values():
            collect(one)
    elif isinstance(value, list):
        for one in value:
            collect(one)


for response in responses:
    collect(response)
for name in ("by_case", "holds_if", "roots", "ranges", "statement", "title", "lines", "error", "counterexample"):
    if name not in members:
        problems += 1
        print("no answer shows", name)

for request, response in zip(requests, responses):
    found = [f"response: {error.message}" for error in validator("response").iter_errors(response)]
    valid = validator("request").is_valid(request)
    refused = response.get("error", {}).get("code") in form_errors
    if valid == refused:
        found.append(f"request: valid is {valid}, but the answer is {json.dumps(response)}")
    for problem in found:
        problems += 1
        print(json.dumps(request), problem, sep="\n  ")

for bad in (
    {},
    {"op": "evaluate"},
    {"op": "evaluate", "map": {"kind": "polynomial", "text": "t"}, "at": [0.5]},
    {"op": "evaluate", "map": {"kind": "polynomial", "text": "t"}, "at": [1], "more": 1},
    {"op": "evaluate", "map": {"kind": "polynomial", "text": "t", "coefficients": ["1"]}, "at": [1]},
    {"op": "blossom", "map": {"kind": "bezier", "control_points": [1]}, "arguments": [{"vector": 1, "x": 1}]},
):
    if validator("request").is_valid(bad):
        problems += 1
        print(json.dumps(bad), "is valid for the schema", sep="\n  ")
for bad in ({}, {"ok": True}, {"ok": False, "error": {"code": "other", "message": "x", "at": ""}}, {"ok": True, "result": {"values": [0.5]}}):
    if validator("response").is_valid(bad):
        problems += 1
        print(json.dumps(bad), "is valid for the schema", sep="\n  ")

sys.exit(1 if problems else 0)
