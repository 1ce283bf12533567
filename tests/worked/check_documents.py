#!/usr/bin/env python3
"""Computes every number of worked examples again.

usage: check_documents.py PROGRAM EXAMPLES   (a line of EXAMPLES: what stands behind "blossom explain", or an exercise)
       check_documents.py --files FILE...

Every relation must hold, every value of a table, a pyramid and a picture must be that of its meaning, and no number may stand
where nothing says what it is.
"""

import json
import shlex
import subprocess
import sys
from fractions import Fraction

from evaluate_document import Context, Unknown, added, scaled, total


class Checker:
    def __init__(self, name, document):
        self.name, self.document = name, document
        self.context = Context(document)
        self.checked = 0
        self.problems = []

    def problem(self, what):
        self.problems.append(f"{self.name}: {what}")

    def same(self, left, right, what):
        self.checked += 1
        if left != right:
            self.problem(f"{what}: {left} is not {right}")

    def relation(self, tree, text):
        if tree["name"] == "≠":
            left, right = (self.context.value(side) for side in tree["parts"])
            self.checked += 1
            if left == right:
                self.problem(f"{text}: both sides are {left}")
            return
        if tree["name"] != "=":
            # What is only asked: whether two sides are equal.
            return
        sides = tree["parts"]
        if sides[0]["kind"] == "symbol" and sides[0]["name"] not in (*self.context.symbols, "delta"):
            # The first time a name stands alone on the left it is defined.
            self.context.symbols[sides[0]["name"]] = self.context.value(sides[1])
        try:
            values = [self.context.value(side) for side in sides]
        except Unknown:
            # A point as the sum of another and a vector, 1 = 0 + delta, is true for pairs.
            values = [self.pair_value(side) for side in sides]
        for value in values[1:]:
            self.same(value, values[0], text)

    def pair_value(self, tree):
        context = self.context
        if tree["kind"] != "sum":
            return context.pair(tree)
        pairs = []
        for part in tree["parts"]:
            if part["kind"] == "product" and part["parts"][-1]["kind"] != "symbol":
                factor, of = part["parts"]
                pairs.append(scaled(context.value(factor), context.pair(of)))
            else:
                pairs.append(context.pair(part))
        value = pairs[0]
        for pair in pairs[1:]:
            value = added(value, pair)
        return value

    def formula(self, formula, may_be_bare=False):
        tree = formula["tree"]
        if tree["kind"] == "relation":
            self.relation(tree, formula["text"])
        elif tree["kind"] in ("number", "tuple") and not may_be_bare:
            self.problem(f"{formula['text']}: a number without meaning")

    def text(self, parts, may_be_bare=True):
        for part in parts:
            if isinstance(part, dict):
                self.formula(part, may_be_bare)

    def display(self, formulas):
        for formula in formulas:
            if formula["tree"]["kind"] != "relation":
                self.problem(f"{formula['text']}: on a line of its own, and no relation")
            self.formula(formula)

    def paragraph(self, parts):
        self.text(parts)

    def table(self, table):
        for title in table["header"]:
            self.text(title)
        width = len(table["header"])
        for row in table["rows"]:
            if len(row) != width:
                self.problem(f"{table['caption']}: a row of {len(row)} cells below {width} titles")
            for cell in row:
                self.text(cell["shown"])
                if "meaning" in cell:
                    (shown,) = cell["shown"]
                    self.same(
                        self.context.value(shown["tree"]),
                        self.context.value(cell["meaning"]),
                        f"{table['caption']}: {shown['text']}",
                    )

    def pyramid(self, pyramid):
        levels = pyramid["levels"]
        for r, level in enumerate(levels):
            for i, node in enumerate(level):
                value = self.context.value(node["value"])
                self.same(value, self.context.value(node["label"]["tree"]), node["label"]["text"])
                if r == 0:
                    continue
                before = [self.context.value(levels[r - 1][j]["value"]) for j in (i, i + 1)]
                weights = [self.context.value(node[side + "_weight"]) for side in ("left", "right")]
                made = added(scaled(weights[0], before[0]), scaled(weights[1], before[1]))
                self.same(value, made, f"{node['label']['text']} from its neighbours")

    def picture(self, picture):
        for point in picture["points"]:
            x, y = (Fraction(c) for c in point["place"])
            tree = point["label"]["tree"]
            if tree["kind"] not in ("blossom", "call"):
                continue
            value = self.context.value(tree)
            if "corners" in picture:
                arguments = [self.context.pair(part) for part in tree["parts"]]
                corners = [tuple(map(Fraction, corner)) for corner in picture["corners"]]
                places = [total(scaled(x, c) for x, c in zip(u, corners, strict=True)) for u in arguments]
                self.same((x, y), scaled(Fraction(1, len(places)), total(places)), f"{point['label']['text']} drawn")
            elif "projection" in picture:
                rows = [[Fraction(w) for w in row] for row in picture["projection"]]
                seen = tuple(sum(w * c for w, c in zip(row, value, strict=True)) for row in rows)
                self.same((x, y), seen, f"{point['label']['text']} in the picture")
            elif picture["graph"]:
                arguments = [self.context.value(part) for part in tree["parts"]]
                self.same(x, sum(arguments) / len(arguments), f"{point['label']['text']} in the picture, x")
                self.same(y, value, f"{point['label']['text']} in the picture, y")
            else:
                self.same((x, y), value, f"{point['label']['text']} in the picture")

    def blocks(self, blocks):
        for block in blocks:
            ((kind, content),) = block.items()
            getattr(self, kind)(content)

    def run(self):
        document = self.document
        self.blocks(document["statement"])
        for step in document["steps"]:
            self.blocks(step["blocks"])
        self.blocks(document["result"])
        check = document.get("check", {"blocks": [], "holds": True})
        self.blocks(check["blocks"])
        if not check["holds"]:
            self.problem("its own check does not hold")
        if self.checked < 3 and "check" in document and document["maps"]:
            self.problem(f"only {self.checked} numbers were checked")
        return self.problems


def check_files(names):
    checkers = []
    for name in names:
        with open(name, encoding="utf-8") as file:
            checkers.append(Checker(name, json.load(file)))
    problems = [problem for checker in checkers for problem in checker.run()]
    print("\n".join(problems))
    print(f"{len(names)} documents, {sum(checker.checked for checker in checkers)} numbers checked")
    return 1 if problems or not names else 0


def main(program, examples):
    problems, documents, checked = [], 0, 0
    with open(examples, encoding="utf-8") as file:
        lines = [line.strip() for line in file if line.strip() and not line.startswith("#")]
    for line in lines:
        words = shlex.split(line)
        command = [program, *(words if words[0] == "exercise" else ["explain", *words]), "--format", "json"]
        answer = subprocess.run(command, capture_output=True, text=True, check=False)
        if answer.returncode != 0:
            problems.append(f"{line}: exit status {answer.returncode}: {answer.stderr}")
            continue
        checker = Checker(line, json.loads(answer.stdout))
        problems += checker.run()
        documents += 1
        checked += checker.checked
    print("\n".join(problems))
    print(f"{documents} documents, {checked} numbers checked, {len(problems)} problems")
    return 1 if problems or documents == 0 else 0


if __name__ == "__main__":
    sys.exit(check_files(sys.argv[2:]) if sys.argv[1] == "--files" else main(*sys.argv[1:]))
