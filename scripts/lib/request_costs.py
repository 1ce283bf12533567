#!/usr/bin/env python3
"""request_costs.py BLOSSOM PEER FOLDER [--quick]: measures the cost of requests of `blossom batch` on one core.

Measures the processor time of each family of `request_families.py` at three sizes: processes with many lines and with one line,
alternating with the peer (simdjson and FLINT, the same responses) if it knows the operation, and takes the median. The instructions
are counted by callgrind in the same way. Writes requests.md and instructions.csv into FOLDER.

With --quick it compares the responses of both programs and the instructions of the two smaller sizes with FOLDER/instructions.csv; a
difference of more than 3 % is an error.
"""

import csv
import math
import os
import re
import resource
import statistics
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import request_families

TOLERANCE = 0.03
ROUNDS = 7
SECONDS = 0.15  # of processor time for a run of many lines

program, peer, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
quick = len(sys.argv) > 4
batch = [program, "batch", "--jobs", "1"]


def run(command, text):
    result = subprocess.run(command, input=text, capture_output=True, text=True)
    return result.stdout


def seconds(command, text):
    """The processor time of a process without that of starting its peers."""
    with tempfile.TemporaryFile("w+") as lines:
        lines.write(text)
        lines.flush()
        lines.seek(0)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(command, stdin=lines, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def text_of(family, size, count):
    return "".join(line + "\n" for line in request_families.lines(family, size, count))


def check(family, size):
    """Checks that all lines are answered, and by the peer with the same bytes."""
    text = text_of(family, size, 20)
    responses = run(batch, text)
    refused = [line for line in responses.splitlines() if '"ok": true' not in line]
    if refused:
        sys.exit(f"{family[0]}, {family[1]} {size}: {refused[0]}")
    if family[0] in request_families.PEER_FAMILIES and run([peer], text) != responses:
        sys.exit(f"{family[0]}, {family[1]} {size}: the peer gives another response")


def instructions(family, size):
    """The cost per request: that of 30 further requests after ten that create all tables."""
    few, many = (10, 40) if size == family[2][0] else (2, 6)

    def counted(count):
        result = subprocess.run(
            ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *batch],
            input=text_of(family, size, count), capture_output=True, text=True,
        )
        found = re.search(r"Collected : (\d+)", result.stderr)
        if not found:
            sys.exit(f"callgrind does not count: {result.stderr[-400:]}")
        return int(found[1])

    return round((counted(many) - counted(few)) / (many - few))


def count_of(command, family, size):
    """The number of lines that take SECONDS."""
    count = 16
    while True:
        once = seconds(command, text_of(family, size, 1))
        spent = seconds(command, text_of(family, size, count)) - once
        if spent > SECONDS / 4 or count >= 1 << 17:
            return max(2, min(1 << 17, round(count * SECONDS / max(spent, 1e-3))))
        count *= 4


def times(family, size):
    """Nanoseconds per request of the program, of the peer, and the ratio peer / program."""
    commands = [batch] + ([[peer]] if family[0] in request_families.PEER_FAMILIES else [])
    count = count_of(batch, family, size)
    one, many = text_of(family, size, 1), text_of(family, size, count)
    rounds = [[(seconds(c, many) - seconds(c, one)) / (count - 1) * 1e9 for c in commands] for _ in range(ROUNDS)]
    medians = [statistics.median(column) for column in zip(*rounds)]
    ratio = statistics.median(r[1] / r[0] for r in rounds) if len(commands) == 2 else None
    return medians[0], medians[1] if len(commands) == 2 else None, ratio


def duration(nanoseconds):
    for unit, size in (("ns", 1), ("us", 1e3), ("ms", 1e6)):
        if nanoseconds < 1000 * size:
            return f"{nanoseconds / size:.3g} {unit}"
    return f"{nanoseconds / 1e9:.3g} s"


def has_vectors():
    return " avx2 " in open("/proc/cpuinfo").read()


cases = [(family, size) for family in request_families.FAMILIES for size in family[2][: 2 if quick else None]]
with ThreadPoolExecutor(os.cpu_count()) as pool:
    list(pool.map(lambda case: check(*case), cases))
    if quick and not has_vectors():
        print("requests: instructions are not compared on a processor without AVX2", file=sys.stderr)
        sys.exit()
    counts = dict(zip(((family[0], size) for family, size in cases), pool.map(lambda case: instructions(*case), cases)))

if quick:
    committed = {(row["request"], int(row["size"])): int(row["instructions"]) for row in csv.DictReader(open(folder / "instructions.csv"))}
    wrong = []
    for key, count in counts.items():
        if key not in committed:
            wrong.append(f"{key[0]}, {key[1]}: not in instructions.csv")
        elif abs(count / committed[key] - 1) > TOLERANCE:
            wrong.append(f"{key[0]}, {key[1]}: {count} instructions, {100 * (count / committed[key] - 1):+.1f} % from the {committed[key]} of instructions.csv")
    if wrong:
        sys.exit("\n".join([*wrong, "if this is meant, `scripts/bench --requests` writes new counts"]))
    sys.exit()

with open(folder / "instructions.csv", "w") as out:
    out.write("request,size,instructions\n")
    for (name, size), count in counts.items():
        out.write(f"{name},{size},{count}\n")

rows = [
    "# Requests",
    "",
    "What one request costs in `blossom batch --jobs 1`: processor time, the median of seven runs in turns with the peer, less that of a process",
    "with one line; all lines differ. Instructions are counted by callgrind, where no AVX-512 is used. The growth is the exponent of the time",
    "between a size and the one before. The peer is a program of simdjson and FLINT with the same responses (`bench/request_peer.cpp`); a ratio",
    "above 1 says that `blossom` is faster.",
    "",
    "| request | size | time | instructions | growth | peer | ratio |",
    "| --- | --- | ---: | ---: | ---: | ---: | ---: |",
]
for family in request_families.FAMILIES:
    before = None
    for size in family[2]:
        ours, theirs, ratio = times(family, size)
        growth = f"{math.log(ours / before[1]) / math.log(size / before[0]):.1f}" if before else ""
        rows.append(
            f"| {family[0]} | {family[1]} {size} | {duration(ours)} | {counts[family[0], size]:,} | {growth} | "
            f"{duration(theirs) if theirs else ''} | {f'{ratio:.2f}' if ratio else ''} |"
        )
        before = (size, ours)
(folder / "requests.md").write_text("\n".join(rows) + "\n")
