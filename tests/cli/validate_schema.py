#!/usr/bin/env python3
"""Holds the requests and responses of the documents and the golden files against docs/protocol.schema.json.

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


requests = [*documented_requests(), *golden_requests()]
requests += [{**request, "numbers": rounding} for request in requests for rounding in ("double", "hexfloat")]
lines = "".join(json.dumps(request) + "\n" for request in requests)
answers = subprocess.run([program, "batch"], input=lines, capture_output=True, text=True, check=False).stdout
responses = [json.loads(line) for line in answers.splitlines()]
assert len(responses) == len(requests) > 60, len(responses)

# Refused by their form alone, so that the schema must refuse them too.
form_errors = {"inexact_number", "missing_field", "unknown_field", "unknown_op", "wrong_kind"}
problems = 0
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
