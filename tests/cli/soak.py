#!/usr/bin/env python3
"""Sends many requests, one in ten of them wrong, to processes that are killed and restarted, and reads fast and slowly.

    soak.py PROGRAM [--lines N] [--seed S] [--growth KB]

Every valid line must be answered once, with the value that Python's fractions give, and every wrong line refused with its code, in
the order of the lines. The memory of a process must not grow with the number of lines: by at most 4096 KB, or --growth. 20,000 lines
by default.
"""

import argparse
import json
import os
import random
import signal
import subprocess
import sys
import threading
from fractions import Fraction

BAD = [
    (lambda n: f'{{"id": {n}, "op": "evaluate"', "syntax"),
    (lambda n: f'{{"id": {n}, "op": "evaluat", "map": 1}}', "unknown_op"),
    (lambda n: f'{{"id": {n}, "op": "evaluate", "map": {{"kind": "polynomial", "text": "t"}}}}', "missing_field"),
    (lambda n: f'{{"id": {n}, "op": "evaluate", "map": {{"kind": "polynomial", "text": "t"}}, "at": [0.5]}}', "inexact_number"),
    (lambda n: f'{{"id": {n}, "op": "evaluate", "map": {{"kind": "polynomial", "text": "t^99999999"}}, "at": [1]}}', "limit_exceeded"),
    (lambda n: f'{{"id": {n}, "op": "blossom", "map": {{"kind": "bezier", "control_points": [1, 2]}}, "arguments": [1, 2]}}', "wrong_arity"),
    (lambda n: "[" * 300, "limit_exceeded"),
]


def number(random_source):
    return Fraction(random_source.randint(-99, 99), random_source.randint(1, 99))


class Line:
    """A request with what is expected: the value as text, or the code of the error."""

    def __init__(self, index, random_source):
        self.index = index
        if random_source.randrange(10) == 0:
            make, self.code = random_source.choice(BAD)
            self.text, self.value = make(index), None
            return
        self.code = None
        points = [number(random_source) for _ in range(random_source.randint(1, 8))]
        t = number(random_source)
        row = points
        while len(row) > 1:
            row = [(1 - t) * a + t * b for a, b in zip(row, row[1:])]
        self.value = str(row[0])
        request = {"id": index, "op": "evaluate", "map": {"kind": "bezier", "control_points": [str(p) for p in points]}, "at": [str(t)]}
        self.text = json.dumps(request)

    def accepts(self, answer):
        response = json.loads(answer)
        if self.code:
            return not response["ok"] and response["error"]["code"] == self.code
        return response["ok"] and response["id"] == self.index and response["result"]["values"] == [self.value]


def resident_bytes(pid):
    with open(f"/proc/{pid}/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def serve(program, lines, jobs, kill_after, slow):
    """The answers of one process to `lines`, until it ends or is killed; and the difference of its peaks of memory in the second and
    the first half of the lines. (Peaks, because a process holds varying numbers of lines that wait for each other.)"""
    process = subprocess.Popen([program, "batch", "--jobs", str(jobs)], stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def write():
        try:
            for line in lines:
                process.stdin.write(line.text.encode() + b"\n")
            process.stdin.close()
        except BrokenPipeError:
            pass

    writer = threading.Thread(target=write)
    writer.start()
    answers = []
    peaks = [0, 0]
    rest = b""
    while True:
        # A slow reader takes a few bytes at a time, so that the process waits for it.
        block = os.read(process.stdout.fileno(), 16 if slow and len(answers) < 500 else 1 << 16)
        if not block:
            break
        *whole, rest = (rest + block).split(b"\n")
        answers += whole
        half = len(answers) > len(lines) // 2
        peaks[half] = max(peaks[half], resident_bytes(process.pid))
        if kill_after is not None and len(answers) >= kill_after:
            process.send_signal(signal.SIGKILL)
            kill_after = None
    writer.join()
    process.wait()
    return answers, peaks[1] - peaks[0]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--lines", type=int, default=20_000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--growth", type=int, default=4096)
    options = parser.parse_args()
    random_source = random.Random(options.seed)
    failures = 0
    done = restarts = growth = 0
    while done < options.lines:
        part = [Line(i, random_source) for i in range(done, min(done + 100_000, options.lines))]
        done += len(part)
        jobs = random_source.choice((1, 2, 3))
        kill = random_source.randrange(len(part)) if random_source.randrange(2) else None
        slow = random_source.randrange(2) == 0
        open_lines = part
        while open_lines:
            answers, grown = serve(options.program, open_lines, jobs, kill, slow)
            growth = max(growth, grown)
            if len(answers) > len(open_lines) or (kill is None and len(answers) != len(open_lines)):
                print(f"{len(answers)} answers to {len(open_lines)} lines")
                return 1
            for line, answer in zip(open_lines, answers):
                if not line.accepts(answer):
                    failures += 1
                    print(f"line {line.index}: {line.text}\n  {answer.decode(errors='replace')}")
            open_lines = open_lines[len(answers):]
            restarts += bool(open_lines)
            kill = None
    print(f"seed {options.seed}: {done} lines, {restarts} restarts, {failures} wrong answers; memory of a process grew by {growth >> 10} KB")
    return 1 if failures or growth > options.growth << 10 else 0


if __name__ == "__main__":
    sys.exit(main())
