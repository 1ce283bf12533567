#!/usr/bin/env python3
"""Checks that no request takes more time or memory than its limits allow, and that a lack of memory is answered with an error.

    check_resources.py PROGRAM [--full]

First costly requests, one per process: each is answered, or refused with the name of a limit, within the processor time and the
memory that the limits allow. Then a batch of mixed lines with less and less memory: each line gets one response, the result or
`limit_exceeded`, and requests that need little memory are answered. By default the limits are low; --full uses the default limits
of the program and more sizes of memory, and takes some minutes.
"""

import json
import resource
import subprocess
import sys

from measured import run_alone

FULL = "--full" in sys.argv[2:]
PROGRAM = sys.argv[1]
SECONDS = 10 if FULL else 1
BYTES = 1 << 30 if FULL else 1 << 26
OPTIONS = [] if FULL else ["--timeout", str(SECONDS), "--max-memory", str(BYTES)]


def nested(levels):
    net = 1
    for _ in range(levels):
        net = [net]
    return net


def long_number(i):
    """A number of 2,000 digits without a pattern that arithmetic could use."""
    return str(pow(2 * i + 3, 4000) % 10**2000 + i)


def costly():
    cubic = {"kind": "bspline", "degree": 3, "knots": list(range(8)), "control_points": [0, 1, 2, 3]}
    continued = "x30"
    for i in range(30):
        continued = f"(x{i} + 1/{continued})"
    yield {"op": "elevate", "map": {"kind": "tensor", "degrees": [1, 1], "control_net": [[0, 1], [2, 5]]}, "by": [2000, 2000]}
    yield {"op": "elevate", "map": cubic, "by": 3000}
    yield {"op": "elevate", "map": {"kind": "bezier", "control_points": [[i, i * i] for i in range(100)]}, "by": 9000}
    yield {"op": "subdivide", "map": {"kind": "tensor", "degrees": [0] * 21, "control_net": nested(21)}, "at": ["1/2"] * 21}
    yield {"op": "inverse-formula", "degree": 300}
    yield {"op": "control-points", "map": {"kind": "polynomial", "variables": [f"x{i}" for i in range(200)], "text": "x0^3"}}
    yield {"op": "control-points", "map": {"kind": "polynomial", "variables": [f"x{i}" for i in range(22)],
                                           "text": "*".join(f"x{i}" for i in range(22)), "degrees": [1] * 22}}
    yield {"op": "prove", "statement": "\n".join(f"given a{i}*b{i} == c{i}" for i in range(31)) + "\nclaim a0*b0*x == c0*x"}
    yield {"op": "prove", "statement": f"claim {continued} == {continued.replace('x3 ', 'x4 ')}"}
    yield {"op": "prove", "statement": "claim x == x\n" * 200000}
    yield {"op": "evaluate", "map": {"kind": "polynomial", "text": "((t+1)^100)^100"}, "at": [2]}
    yield {"op": "derivative", "map": {"kind": "polynomial", "text": "1 + t^3", "denominator": "1 + t^2"}, "order": 10000, "at": ["1/3"]}
    yield {"op": "roots", "map": {"kind": "polynomial", "text": "t^3 - 2"}, "interval": [0, 2], "width": "1e-100000"}
    arguments = [long_number(i) + "/" + long_number(i + 20) for i in range(20)]
    yield {"op": "agree", "map": {"kind": "polynomial", "coefficients": list(range(1, 22))}, "arguments": arguments}
    arguments = [f"{i % 97 + 1}/{i % 89 + 1}" for i in range(10000)]
    yield {"op": "blossom", "map": {"kind": "polynomial", "text": "t^10000 + t^3 + 1"}, "arguments": arguments}
    yield {"op": "segments", "map": {"kind": "bspline", "degree": 200, "knots": list(range(800)), "control_points": [i * i % 19 for i in range(599)]}}
    yield {"op": "roots", "map": {"kind": "polynomial", "coefficients": [pow(7, i, 10**6 + 3) - 500000 for i in range(1500)]}, "interval": [-2, 2]}
    arcs = [{"kind": "bezier", "control_points": [[i, i * i % 61 + k] for i in range(50)]} for k in range(2)]
    yield {"op": "intersections", "map": arcs[0], "with": arcs[1]}
    corners = {"kind": "bspline", "degree": 1, "knots": [0, *range(20001), 20000], "control_points": [[i % 97, i % 89] for i in range(20001)]}
    yield {"op": "self-intersections", "map": corners}


def small():
    """Short requests and results with large parameters: they are never refused."""
    yield {"op": "evaluate", "map": {"kind": "polynomial", "text": "t"}, "at": ["1e999999"]}
    yield {"op": "blossom", "map": {"kind": "polynomial", "text": "1 + t", "degree": 4096}, "arguments": ["1/2"] * 4096}
    yield {"op": "evaluate", "map": {"kind": "polynomial", "text": "1 + t^2", "degree": 4096}, "at": ["1/2"]}
    yield {"op": "subdivide", "map": {"kind": "bezier", "control_points": [i * i % 199 for i in range(801)]}, "at": "1/3"}
    yield {"op": "prove", "statement": "claim x == x\n" * 3000}
    yield {"op": "prove", "statement": "claim " + " + ".join(map(str, range(50000))) + " == 1249975000"}
    if FULL:
        yield {"op": "subdivide", "map": {"kind": "bezier", "control_points": [i * i % 199 for i in range(5000)]}, "at": "1/2"}


def check_costly(failures):
    floor = run_alone(PROGRAM, [], b'{"op": "evaluate", "map": {"kind": "polynomial", "text": "t"}, "at": [1]}').size
    for must_answer, requests in ((False, costly()), (True, small())):
        for request in requests:
            output, status, seconds, size = run_alone(PROGRAM, OPTIONS, json.dumps(request).encode())
            name = f"{request['op']} {json.dumps(request)[:90]}"
            if status not in (0, 1) or output.count(b"\n") != 1:
                failures.append(f"{name}: exit status {status}, {len(output)} bytes")
                continue
            response = json.loads(output)
            error = response.get("error", {})
            if not response["ok"] and (error["code"] != "limit_exceeded" or " the limit " not in error["message"]):
                failures.append(f"{name}: {error}")
            if must_answer and not response["ok"]:
                failures.append(f"{name}: refused, though it is small: {error}")
            # Measurements by the system are coarser than the counters of the program.
            if seconds > 1.25 * SECONDS + 1:
                failures.append(f"{name}: {seconds:.1f} s")
            if size > floor + 1.25 * BYTES:
                failures.append(f"{name}: {size >> 20} MB")
            if FULL:
                print(f"{seconds:6.2f} s {size >> 20:5} MB  {'answered' if response['ok'] else error['message']}: {name}", flush=True)


MIXED = [
    ({"op": "evaluate", "map": {"kind": "polynomial", "text": "t^2"}, "at": ["1/2"]}, True),
    ({"op": "elevate", "map": {"kind": "tensor", "degrees": [1, 1], "control_net": [[0, 1], [2, 5]]}, "by": [300, 300]}, False),
    ({"op": "evaluate", "map": {"kind": "polynomial", "text": "t"}, "at": ["1e999999"]}, False),
    ({"op": "inverse-formula", "degree": 60}, False),
    ({"op": "prove", "statement": "claim (a + b + c + d)^12 == (d + c + b + a)^12"}, False),
    ({"op": "evaluate", "map": {"kind": "polynomial", "text": "t^3"}, "at": ["1/2"]}, True),
]


def check_little_memory(failures):
    """A process that cannot start with so little memory shows nothing about requests; with the largest sizes it must start."""
    sizes = [20, 24, 28, 32, 40, 48, 64, 96, 128, 256, 512, 1024, 3072]
    if FULL:
        sizes = sorted(set(sizes) | set(range(20, 130, 2)) | set(range(140, 700, 40)))
    text = "".join(json.dumps(request) + "\n" for request, _ in MIXED)
    started = 0
    for jobs in ("1", "3"):
        for megabytes in sizes:
            limit = megabytes << 20
            process = subprocess.run([PROGRAM, "batch", "--jobs", jobs, *OPTIONS], input=text.encode(), capture_output=True, check=False,
                                     preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
            place = f"{megabytes} MB, {jobs} jobs"
            responses = process.stdout.decode().splitlines()
            if process.returncode == 127 and not responses:
                continue  # the system's loader could not load the program
            started += 1
            if jobs != "1" and process.returncode == 2 and b"memory" in process.stderr:
                continue  # the other jobs used all the memory: a regular end
            if process.returncode not in (0, 1):
                failures.append(f"{place}: exit status {process.returncode}: {process.stderr.decode()[:200]}")
                continue
            if len(responses) != len(MIXED):
                failures.append(f"{place}: {len(responses)} responses to {len(MIXED)} lines")
                continue
            for (request, is_small), line in zip(MIXED, responses):
                response = json.loads(line)
                if not response["ok"] and response["error"]["code"] != "limit_exceeded":
                    failures.append(f"{place}: {request['op']}: {response['error']}")
                # With several jobs, the others may use the memory.
                if is_small and jobs == "1" and not response["ok"]:
                    failures.append(f"{place}: a small request is refused: {response['error']}")
    if started < len(sizes):
        failures.append(f"only {started} processes of {2 * len(sizes)} have started")


def main():
    failures = []
    check_costly(failures)
    check_little_memory(failures)
    for failure in failures:
        print(failure)
    print(f"{len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
