#!/usr/bin/env python3
"""Answers the requests of a file on a cluster of dask.distributed, each line once and in order.

Usage: cluster.py SCHEDULER REQUESTS RESPONSES [LINES_PER_TASK]

The work of a worker that is lost is done again by others. Memory does not grow with the file: a few tasks per thread are
under way, and the answers of each are written when those before are.
"""

import sys
from collections import deque
from itertools import islice


def answered(lines):
    """The responses to some lines, on a worker."""
    import blossom

    return "".join(blossom.answer_json(line.rstrip("\r\n")) + "\n" for line in lines)


def answer_file(client, requests, responses, lines_per_task=2000):
    """The number of answered lines."""
    under_way = deque()
    count = 0

    def write_first():
        future = under_way.popleft()
        responses.write(future.result())

    lines = (line for line in requests if line.strip())
    while task := list(islice(lines, lines_per_task)):
        # A task whose worker was lost is tried again; it is not the requests that end workers, whose limits hold.
        under_way.append(client.submit(answered, task, pure=False, retries=10))
        count += len(task)
        if len(under_way) > 4 * max(1, sum(client.nthreads().values())):
            write_first()
    while under_way:
        write_first()
    return count


if __name__ == "__main__":
    from dask.distributed import Client

    scheduler, requests, responses = sys.argv[1:4]
    lines_per_task = int(sys.argv[4]) if len(sys.argv) > 4 else 2000
    with Client(scheduler) as client, open(requests) as given, open(responses, "w") as written:
        print(answer_file(client, given, written, lines_per_task), "requests answered")
