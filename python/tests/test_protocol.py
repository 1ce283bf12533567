"""Requests of the protocol give the same responses through the module as from the program."""

import json
import os
import re
import subprocess
from fractions import Fraction
from pathlib import Path

import pytest

import blossom

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("BLOSSOM_PROGRAM")


def requests():
    golden = (ROOT / "tests/golden/protocol-examples.jsonl").read_text().splitlines()
    pages = (ROOT / "docs/protocol.md").read_text()
    lines = [line for block in re.findall(r"```jsonl\n(.*?)```", pages, re.S) for line in block.splitlines()]
    # Of the pages, requests are the lines before their responses; the golden file has both in one object.
    for line in golden:
        example = json.loads(line)
        yield example.get("request", example)
    yield from (json.loads(line) for line in lines if '"op"' in line)


def as_the_program_writes(value):
    if isinstance(value, Fraction):
        return str(value)
    if isinstance(value, list):
        return [as_the_program_writes(element) for element in value]
    if isinstance(value, dict):
        return {name: as_the_program_writes(member) for name, member in value.items()}
    return value


REQUESTS = [request for request in requests() if isinstance(request, dict)]


def test_there_are_requests_of_every_operation():
    known = {operation["name"] for operation in blossom._engine.operations()}
    assert known <= {request.get("op") for request in REQUESTS if isinstance(request.get("op"), str)}
    assert len(REQUESTS) > 200


@pytest.mark.skipif(not PROGRAM, reason="BLOSSOM_PROGRAM names no program")
def test_responses_are_those_of_the_program():
    lines = "".join(json.dumps(request) + "\n" for request in REQUESTS)
    printed = subprocess.run([PROGRAM, "batch"], input=lines, capture_output=True, text=True).stdout.splitlines()
    assert len(printed) == len(REQUESTS)
    for request, line in zip(REQUESTS, printed):
        expected = json.loads(line)
        if "error" in expected:
            expected["error"].pop("flag", None)  # an option of the program
        assert as_the_program_writes(blossom.answer(request)) == expected, request
        from_text = json.loads(blossom.answer_json(json.dumps(request)))
        assert from_text == expected, request


def test_numbers_of_requests_may_be_fractions():
    request = {"op": "evaluate", "map": {"kind": "bezier", "control_points": [0, Fraction(1, 3)]}, "at": [Fraction(1, 2)]}
    assert blossom.answer(request) == {"ok": True, "result": {"values": [Fraction(1, 6)]}}


def test_errors_are_responses_too():
    response = blossom.answer({"op": "evaluat"})
    assert response["ok"] is False
    assert response["error"]["code"] == "unknown_op"
    assert response["error"]["at"] == "/op"


def test_an_id_of_any_form_is_returned():
    for identity in ("a", 3, None, [1, {"b": True}], 10**30):
        request = {"id": identity, "op": "prove", "statement": "claim 1 == 1"}
        assert blossom.answer(request)["id"] == identity
