#!/usr/bin/env python3
"""Answers many requests, a tenth of them bad, by each recipe of docs/scaling.md on this machine, and checks every line.

Usage: check_scaling.py PROGRAM [--count N] [--recipe NAME...] [--workers N]

A scheduler of dask.distributed and its workers run on 127.0.0.1, and one worker is killed in the middle. A recipe whose programs
are not installed is left out.
"""

import argparse
import filecmp
import importlib.util
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from fractions import Fraction
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def requests(count, seed=1):
    """Lines and what their responses must be: of a good line the value, of a bad one None."""
    choice = random.Random(seed)
    bad = ['{"op": "evaluat"}', "not JSON", '{"op": "evaluate", "map": {"kind": "bezier"}, "at": [1]}', "[1, 2"]
    for i in range(count):
        if choice.random() < 0.1:
            line = choice.choice(bad)
            if line.startswith("{"):
                line = '{"id": %d, %s' % (i, line[1:])
            yield line, (i if line.startswith("{") else None, None)
            continue
        points = [choice.randint(-99, 99) for _ in range(choice.randint(1, 6))]
        t = Fraction(choice.randint(-9, 9), choice.randint(1, 9))
        request = {"id": i, "op": "evaluate", "map": {"kind": "bezier", "control_points": points}, "at": [str(t)]}
        values = [Fraction(p) for p in points]
        while len(values) > 1:
            values = [(1 - t) * a + t * b for a, b in zip(values, values[1:])]
        yield json.dumps(request), (i, str(values[0]))


def check(responses, expected):
    """Every line is answered once, in order."""
    with open(responses) as file:
        count = 0
        for line, (identity, value) in zip(file, expected, strict=True):
            response = json.loads(line)
            assert response.get("id") == identity, (line, identity)
            if value is None:
                assert not response["ok"], line
            else:
                assert response["ok"] and response["result"]["values"] == [value], (line, value)
            count += 1
    assert count == len(expected)


def one_process(program, given, written, workers):
    with open(given) as lines, open(written, "w") as responses:
        subprocess.run([program, "batch", "--jobs", "1"], stdin=lines, stdout=responses)


def gnu_parallel(program, given, written, workers):
    command = ["parallel", "--will-cite", "--pipe", "--keep-order", "--block", "1M", "-j", str(workers), f"{program} batch"]
    with open(given) as lines, open(written, "w") as responses:
        subprocess.run(command, stdin=lines, stdout=responses)


def job_array(program, given, written, workers):
    """The script of the job array, run as Slurm runs it; one of its tasks is killed and run again."""
    parts = [f"{given}.{part:05d}.responses" for part in range(1, 2 * workers + 1)]

    def task(part):
        environment = os.environ | {
            "BLOSSOM": program, "REQUESTS": given, "SLURM_ARRAY_TASK_ID": str(part), "SLURM_ARRAY_TASK_MAX": str(len(parts)),
        }  # fmt: skip
        return subprocess.Popen(["bash", str(ROOT / "examples/job-array.sh")], env=environment, start_new_session=True)

    killed = task(1)
    time.sleep(0.05)
    os.killpg(killed.pid, signal.SIGKILL)
    killed.wait()
    assert not os.path.exists(parts[0]) or os.path.getsize(parts[0]) > 0
    for part in range(1, len(parts) + 1):
        if not os.path.exists(parts[part - 1]):
            assert task(part).wait() == 0
    with open(written, "wb") as responses:
        for part in parts:
            with open(part, "rb") as file:
                shutil.copyfileobj(file, responses)


def start(*command):
    return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)


def dask(program, given, written, workers):
    from distributed import Client

    specification = importlib.util.spec_from_file_location("cluster", ROOT / "examples/cluster.py")
    cluster = importlib.util.module_from_spec(specification)
    sys.modules["cluster"] = cluster
    specification.loader.exec_module(cluster)
    os.environ["PYTHONPATH"] = os.pathsep.join([str(ROOT / "examples"), *os.environ.get("PYTHONPATH", "").split(os.pathsep)])
    address = "tcp://127.0.0.1:18786"
    python = [sys.executable, "-m"]
    quiet = ["--no-dashboard"]
    processes = [start(*python, "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "18786", *quiet)]
    try:
        for _ in range(workers):
            processes.append(
                start(*python, "distributed.cli.dask_worker", address, "--nthreads", "1", "--no-nanny", "--host", "127.0.0.1", *quiet)
            )
        with Client(address, timeout=60) as client, open(given) as lines, open(written, "w") as responses:
            client.wait_for_workers(workers, timeout=60)

            def kill_when_half_is_written():
                while responses.tell() < os.path.getsize(given) / 4:
                    time.sleep(0.01)
                processes[1].kill()

            killer = threading.Thread(target=kill_when_half_is_written, daemon=True)
            killer.start()
            cluster.answer_file(client, lines, responses)
            killer.join(10)
            processes[1].wait(10)
    finally:
        for process in processes:
            process.kill()
            process.wait()


RECIPES = {
    "one process": (one_process, lambda: True),
    "GNU parallel": (gnu_parallel, lambda: shutil.which("parallel")),
    "job array": (job_array, lambda: shutil.which("split")),
    "dask.distributed": (dask, lambda: importlib.util.find_spec("distributed")),
}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=10_000)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--recipe", nargs="*", choices=RECIPES, default=list(RECIPES))
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        given = os.path.join(folder, "requests.jsonl")
        expected = []
        with open(given, "w") as file:
            for line, response in requests(options.count):
                file.write(line + "\n")
                expected.append(response)
        for name in options.recipe:
            recipe, is_possible = RECIPES[name]
            if not is_possible():
                print(f"{name}: not installed, left out")
                continue
            written = os.path.join(folder, "responses.jsonl")
            began = time.monotonic()
            recipe(os.path.abspath(options.program), given, written, options.workers)
            seconds = time.monotonic() - began
            check(written, expected)
            if not os.path.exists(first := os.path.join(folder, "first.jsonl")):
                os.rename(written, first)
            else:
                assert filecmp.cmp(written, first, shallow=False), f"{name} does not write what {options.recipe[0]} writes"
            print(f"{name}: {options.count} requests in {seconds:.2f} s, {options.count / seconds:.0f} per second")


if __name__ == "__main__":
    main()
