#!/usr/bin/env python3
"""prover_peers.py BLOSSOM FOLDER REPORT [--quick]: compares `blossom prove` with PARI on the identities in FOLDER.

FOLDER holds NAME-N.blossom and, with n for N, NAME.gp, which prints 1 if the identity holds. Both run alternately; a
time is the median CPU time, user and system, of three processes. Every run must prove the identity; the largest one exceeds the default
of the limit expansion_work. Writes a table to REPORT; --quick runs each of the smaller identities once and writes nothing.
"""

import os
import platform
import re
import statistics
import subprocess
import sys
from pathlib import Path

program, folder, report = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
quick = len(sys.argv) > 4
rounds = 1 if quick else 3
titles = {
    "de-boor": "de Boor's algorithm, symbolic knots, one argument per level",
    "polarization": "the blossom from values at means of its arguments",
}


def measured(command, expected, text=None):
    """CPU seconds and peak memory in MiB of a process whose output must contain `expected`."""
    process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if text:
        process.stdin.write(text)
    process.stdin.close()
    output = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0 or not re.search(expected, output, re.MULTILINE):
        sys.exit(f"{' '.join(map(str, command))} proved nothing: {output}{process.stderr.read()}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def machine():
    model = next((line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")), "unknown")
    return f"{model}, {platform.system()} {platform.release().split('-')[0]}"


def peer_version():
    output = subprocess.run(["gp", "-q", "-f"], input="print(version())", check=True, capture_output=True, text=True).stdout
    return ".".join(re.findall(r"\d+", output)[:3])


def row(file):
    name, degree = re.fullmatch(r"(.+)-(\d+)", file.stem).groups()
    script = f"n = {degree};\n" + (folder / f"{name}.gp").read_text()
    ours, theirs = [], []
    for _ in range(rounds):
        ours.append(measured([program, "prove", str(file), "--max-expansion-work", "1000000000"], r"^ *proved "))
        theirs.append(measured(["gp", "-q", "-f"], r"^1$", script))
    (our_time, our_memory), (their_time, their_memory) = (
        (statistics.median(t for t, _ in runs), max(m for _, m in runs)) for runs in (ours, theirs)
    )
    return (
        f"| {titles[name]} | {degree} | {our_time:.3f} s | {their_time:.3f} s | {our_time / their_time:.2f} | "
        f"{our_memory:.0f} MiB | {their_memory:.0f} MiB |"
    )


files = sorted(folder.glob("*.blossom"), key=lambda file: (file.stem.rpartition("-")[0], int(file.stem.rpartition("-")[2])))
lines = [
    f"# The prover beside PARI\n\nMeasured on {machine()}, PARI {peer_version()}, whole processes, CPU time, median of {rounds}.\n",
    "| identity | degree | blossom | PARI | ratio | memory | its memory |",
    "| --- | ---: | ---: | ---: | ---: | ---: | ---: |",
]
print("\n".join(lines))
for file in files:
    if quick and int(file.stem.rpartition("-")[2]) > 10:
        continue
    lines.append(row(file))
    print(lines[-1], flush=True)
if not quick:
    report.write_text("\n".join(lines) + "\n")
