#!/usr/bin/env python3
"""Computes every number of worked examples again.

usage: check_documents.py PROGRAM EXAMPLES   (a line of EXAMPLES: the arguments of "blossom explain", or an exercise)
       check_documents.py --files FILE...

General formulas with indices have no numbers. Every other relation must hold, and every value of a table, a pyramid and a picture must
be the value of its meaning. A single number in a table must have a meaning, count the rows, or be an argument of an entry with a
meaning; a single number in a sentence must be a number of the given map, or occur in a checked relation.
"""

import copy
import json
import random
import re
import shlex
import subprocess
import sys
from fractions import Fraction

from evaluate_document import Context, Unknown, added, scaled, total


def numbers_in(tree):
    """All numbers of a formula, or of any other part of a document."""
    if isinstance(tree, list):
        return {number for part in tree for number in numbers_in(part)}
    if isinstance(tree, dict):
        if tree.get("kind") == "number":
            return {Fraction(tree["value"])}
        return {number for key, part in tree.items() if key not in ("text", "latex") for number in numbers_in(part)}
    if isinstance(tree, int):
        return {Fraction(tree)}
    return {Fraction(tree)} if isinstance(tree, str) and re.fullmatch(r"-?\d+(/\d+)?", tree) else set()


def is_bare(tree):
    return tree["kind"] in ("number", "tuple")


def with_other_maps(document):
    """The same document for other maps of the same shape: relations of labels and weights must hold for them too."""
    other = copy.deepcopy(document)
    chosen = random.Random(len(str(document)))
    for entry in other["maps"]:
        for name in ("coefficients", "control_points", "control_net"):
            points = entry["definition"].get(name, [])
            for point in points if entry["definition"]["kind"] != "symbolic" else []:
                point[:] = [str(chosen.randrange(-99, 100)) for _ in point]
    return other


class Checker:
    def __init__(self, name, document):
        self.name, self.document = name, document
        self.context = Context(document)
        self.others = Context(with_other_maps(document))
        self.checked = 0
        self.problems = []
        self.known = numbers_in([entry["definition"] for entry in document["maps"]])
        self.known |= {Fraction(len(entry["definition"].get("coefficients", [0])) - 1) for entry in document["maps"]}
        self.known |= {Fraction(len(entry["definition"].get("control_points", [0])) - 1) for entry in document["maps"]}
        self.stated = []

    def problem(self, what):
        self.problems.append(f"{self.name}: {what}")

    def same(self, left, right, what):
        self.checked += 1
        if left != right:
            self.problem(f"{what}: {left} is not {right}")

    def relation(self, tree, text):
        self.known |= numbers_in(tree)
        if tree["name"] == "≠":
            left, right = (self.context.value(side) for side in tree["parts"])
            self.checked += 1
            if left == right:
                self.problem(f"{text}: both sides are {left}")
            return
        if tree["name"] != "=":
            # Questions, such as whether two sides are equal.
            return
        sides = tree["parts"]
        name = sides[0]["name"] if sides[0]["kind"] == "symbol" else self.context.indexed_name(sides[0])
        if name is not None and name not in (*self.context.symbols, "delta"):
            # The first formula with a single name on the left defines this name.
            self.context.symbols[name] = self.context.value(sides[1])
        try:
            values = [self.context.value(side) for side in sides]
        except Unknown:
            # A point as the sum of a point and a vector, 1 = 0 + delta, is true for pairs.
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

    def formula(self, formula):
        tree = formula["tree"]
        if tree["kind"] == "relation":
            self.relation(tree, formula["text"])
        elif is_bare(tree) or tree["kind"] == "interval":
            self.stated.append(formula)
        elif tree["kind"] in ("blossom", "call", "derivative"):
            self.known |= numbers_in(tree)

    def text(self, parts):
        for part in parts:
            if isinstance(part, dict):
                self.formula(part)

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
        for number, row in enumerate(table["rows"]):
            if len(row) != width:
                self.problem(f"{table['caption']}: a row of {len(row)} cells below {width} titles")
            meanings = [cell["meaning"] for cell in row if "meaning" in cell]
            for cell in row:
                self.cell(cell, number, meanings, table["caption"])

    def cell(self, cell, number, meanings, caption):
        (shown,) = cell["shown"] or [""]
        if "meaning" not in cell:
            counts = shown and not isinstance(shown, str) and shown["tree"] == {"kind": "number", "value": str(number)}
            if isinstance(shown, str) or counts:
                return
            if not is_bare(shown["tree"]):
                self.formula(shown)
            elif not any(one.get("parts") == shown["tree"].get("parts") for one in meanings):
                self.problem(f"{caption}: {shown['text']}: a number without meaning")
        elif cell["meaning"]["kind"] == "relation":
            self.relation(cell["meaning"], f"{caption}: {shown}")
        else:
            tree, meaning = shown["tree"], cell["meaning"]
            self.same(self.context.value(tree), self.context.value(meaning), f"{caption}: {shown['text']}")

    def pyramid(self, pyramid):
        levels = pyramid["levels"]
        self.known |= numbers_in(levels)
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
                before = [self.others.value(levels[r - 1][j]["label"]["tree"]) for j in (i, i + 1)]
                made = added(scaled(weights[0], before[0]), scaled(weights[1], before[1]))
                self.same(self.others.value(node["label"]["tree"]), made, f"the weights of {node['label']['text']}")

    def picture(self, picture):
        for point in picture["points"]:
            x, y = (Fraction(c) for c in point["place"])
            tree = point["label"]["tree"]
            if "meaning" in point:
                self.same((x, y), self.context.value(point["meaning"]), f"{point['label']['text']} in the picture")
                continue
            if tree["kind"] not in ("blossom", "call"):
                self.problem(f"{point['label']['text']} in a picture: a place without meaning")
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
        for formula in self.stated:
            if not numbers_in(formula["tree"]) <= self.known:
                self.problem(f"{formula['text']}: a number without meaning")
            knots = [entry["definition"].get("knots", []) for entry in self.document["maps"]]
            listed = [part.get("value") for part in formula["tree"].get("parts", [])]
            if any(len(one) == len(listed) > 2 for one in knots) and listed not in knots:
                self.problem(f"{formula['text']}: not the knots")
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
        pages = json.loads(answer.stdout)
        for page in pages if isinstance(pages, list) else [pages]:
            checker = Checker(line, page)
            problems += checker.run()
            documents += 1
            checked += checker.checked
    print("\n".join(problems))
    print(f"{documents} documents, {checked} numbers checked, {len(problems)} problems")
    return 1 if problems or documents == 0 else 0


if __name__ == "__main__":
    sys.exit(check_files(sys.argv[2:]) if sys.argv[1] == "--files" else main(*sys.argv[1:]))
