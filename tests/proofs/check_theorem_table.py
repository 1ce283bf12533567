#!/usr/bin/env python3
"""Compares the table of proofs/README.md with the files that it names, without Coq.

usage: check_theorem_table.py ROOT

A row is: theorem | statement ids | engine | C++ function (header) | test file: words of a test's name. Each theorem
is in its file of proofs/coq, and each theorem there has one row; each id is in proofs/statements/index.tsv;
"engine" is the greatest degree for which proofs/statements/*.blossom prove one of the ids; each function is declared
in that header; each test is a TEST_CASE of that file. docs/theorems.md names every theorem, and _CoqProject every
file.
"""

import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
problems = []


def text(path):
    return path.read_text(encoding="utf-8")


def one_file(name, folders, pattern):
    found = [path for folder in folders for path in (root / folder).rglob(pattern) if path.name == name]
    return text(found[0]) if found else None


def degrees_of_statements():
    """The greatest degrees of the theorems of each id in the identity language; no entry for a theorem without range."""
    degrees = {}
    for path in (root / "proofs/statements").glob("*.blossom"):
        for block in re.split(r"^theorem ", text(path), flags=re.MULTILINE)[1:]:
            ranges = re.findall(r"^for [a-zA-Z] in \d+\.\.(\d+)", block, re.MULTILINE)
            degrees.setdefault(block.split()[0], []).extend(int(end) for end in ranges)
    return degrees


def proved_by_engine(ids):
    known = [degrees[name] for name in ids if name in degrees]
    greatest = max((degree for ends in known for degree in ends), default=None)
    return "tests" if not known else "single degrees" if greatest is None else f"degrees up to {greatest}"


def row_problems(theorem, ids, engine, function, test):
    file, _, name = theorem.partition(".")
    if (file, name) not in theorems:
        yield "no such theorem"
    statements = ids.removesuffix(" (misprint)").split(", ")
    yield from (f"no statement {statement}" for statement in statements if statement not in index)
    if engine != proved_by_engine(statements):
        yield f"the engine proves it for {proved_by_engine(statements)}"
    match = re.fullmatch(r"`(\w+)` \((\w+\.hpp)\)", function)
    header = one_file(match[2], ["rational", "core", "protocol/src"], "*.hpp") if match else None
    if header is None or not re.search(rf"\b{match[1]}\(", header):
        yield f"no function {function}"
    test_file, _, words = test.partition(": ")
    source = one_file(test_file, ["tests"], "*_test.cpp")
    names = re.findall(r'TEST_CASE\(\s*"((?:[^"\\]|\\.)*)"', source or "")
    if not words or not any(re.search(rf"(?<![\w-]){re.escape(words)}(?![\w-])", other) for other in names):
        yield f"no test {test}"


theorems = {(path.stem, name) for path in (root / "proofs/coq").glob("*.v")
            for name in re.findall(r"^(?:Theorem|Corollary) ([\w']+)", text(path), re.MULTILINE)}
index = {line.split("\t")[0] for line in text(root / "proofs/statements/index.tsv").splitlines()}
degrees = degrees_of_statements()
rows = [[cell.strip() for cell in line.strip("|").split(" | ")]
        for line in text(root / "proofs/README.md").splitlines() if re.match(r"\| `\w+\.\w+` \|", line)]
page = text(root / "docs/theorems.md")
project = text(root / "proofs/coq/_CoqProject").splitlines()

for row in rows:
    theorem = row[0].strip("`")
    found = row_problems(theorem, *row[1:]) if len(row) == 5 else [f"{len(row)} columns"]
    problems += [f"{theorem}: {problem}" for problem in found]
listed = [row[0].strip("`") for row in rows]
problems += [f"{name} has two rows" for name in listed if listed.count(name) > 1]
for file, name in sorted(theorems):
    if f"{file}.{name}" not in listed:
        problems.append(f"{file}.{name} is not in the table of proofs/README.md")
    if not re.search(rf"`{name}`", page):
        problems.append(f"docs/theorems.md does not say what {name} is")
for path in (root / "proofs/coq").glob("*.v"):
    if path.name not in project:
        problems.append(f"_CoqProject does not name {path.name}")

for problem in problems:
    print(f"FAILED: {problem}")
print(f"{len(rows)} theorems, {len(problems)} problems")
sys.exit(not rows or bool(problems))
