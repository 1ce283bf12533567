"""One request, answered by a separate process, and the time and memory of this process."""

import os
import subprocess
from typing import NamedTuple


class Measured(NamedTuple):
    output: bytes
    status: int
    seconds: float  # of processor time
    size: int  # the peak resident size in bytes


def greatest_size(pid):
    """Measures only the program: the system's counts for a child begin with the size of the parent."""
    try:
        with open(f"/proc/{pid}/status", encoding="ascii") as status:
            return next((int(line.split()[1]) << 10 for line in status if line.startswith("VmHWM:")), 0)
    except OSError:
        return 0


def run_alone(program, options, line):
    """The answers to `line` of `blossom batch` with these options."""
    with subprocess.Popen([program, "batch", *options], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        try:
            process.stdin.write(line + b"\n")
            process.stdin.flush()
        except BrokenPipeError:
            pass
        output = process.stdout.readline()
        size = greatest_size(process.pid)
        try:
            process.stdin.close()
        except BrokenPipeError:
            pass
        output += process.stdout.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    return Measured(output, process.returncode, usage.ru_utime + usage.ru_stime, size)
