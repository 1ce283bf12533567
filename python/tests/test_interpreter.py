"""Threads, signals and memory of the interpreter."""

import gc
import os
import resource
import signal
import subprocess
import sys
import threading
import time
from fractions import Fraction

import pytest

import blossom
from blossom import Bezier, Polynomial, Vector


#: Room for results of high degree.
LARGE = {"output_digits": 10**12, "digits": 10**9, "numbers": 10**9, "memory": 8 << 30, "work": 10**14}


def large_polynomial(degree):
    return Polynomial([Fraction(3**k % 1000003, 7 + k % 50) for k in range(degree + 1)])


def control_points():
    curve = large_polynomial(6000)
    return lambda: curve.control_points(interval=["1/3", "22/7"], timeout=60, limits=LARGE)


def response():
    request = {"op": "control-points", "map": large_polynomial(6000), "interval": ["1/3", "22/7"]}
    return lambda: blossom.answer(request, timeout=60, limits=LARGE)


def proof():
    statement = "map p degree 9\nclaim p(a+b+c+d)^3 == p(a+b+c+d)*p(a+b+c+d)^2"
    return lambda: blossom.prove(statement, timeout=60, limits=LARGE)


def values():
    curve = Polynomial([Fraction(1, 3 + k) for k in range(3000)])
    return lambda: curve([Fraction(k, 997) for k in range(3000)])


@pytest.mark.parametrize("prepare", [control_points, response, proof, values], ids=lambda prepare: prepare.__name__)
def test_an_interrupt_is_honoured(prepare):
    """It comes 0.15 seconds after longer work has begun, and ends it within 0.2 seconds of processor time."""
    work = prepare()
    before = signal.signal(signal.SIGALRM, signal.default_int_handler)
    try:
        start = time.process_time()
        signal.setitimer(signal.ITIMER_REAL, 0.15)
        with pytest.raises(KeyboardInterrupt):
            work()
        assert time.process_time() - start < 0.15 + 0.2
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert Polynomial("t^2")(3) == 9


def test_other_signal_handlers_run_meanwhile():
    seen = []
    before = signal.signal(signal.SIGALRM, lambda number, frame: seen.append(Polynomial("t^2")(3)))
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.05)
        end = time.monotonic() + 0.15
        while time.monotonic() < end:
            Polynomial([Fraction(1, 3 + k) for k in range(300)]).control_points()
        assert seen == [9]
    finally:
        signal.signal(signal.SIGALRM, before)


def test_threads_run_at_once():
    """While one thread computes, others go on: the lock of the interpreter is released."""
    progress = []
    done = threading.Event()

    def count():
        while not done.is_set():
            progress.append(time.monotonic())
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    start = time.monotonic()
    Polynomial([Fraction(3**k % 1000003, 7 + k) for k in range(900)]).control_points(interval=["1/3", "22/7"])
    end = time.monotonic()
    done.set()
    thread.join()
    # The interpreter would make the other thread wait for the whole computation.
    assert end - start < 0.02 or sum(start < at < end for at in progress) >= 3


def test_many_threads_use_one_map():
    p = Polynomial("1 + 2t + 4t^2 - t^3")
    spline = blossom.BSpline([0, 0, 0, 1, 2, 2, 2], [0, 1, 3, 2], 2)
    failures = []

    def work(seed):
        for k in range(300):
            t = Fraction(seed * 300 + k, 7)
            if p[t, t, t] != p(t) or spline([0, 1, 2]) != [spline(0), 2, 2]:
                failures.append(t)
            if p.control_points(interval=[t, t + 1])(t) != p(t):
                failures.append(t)

    threads = [threading.Thread(target=work, args=(seed,)) for seed in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failures


def memory_in_use():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * resource.getpagesize()


def calls(count):
    p = Polynomial("1 + 2t + 4t^2 - t^3")
    large = Fraction(10**40, 7**30)
    for k in range(count):
        t = Fraction(k, 7)
        p(t)
        p[t, 2, 3]
        p(large)
        p([1, t, large])
        if k % 10 == 0:
            p.control_points(interval=[t, t + 1]).elevate(by=1)
            p[1, Vector(t), 3]
            try:
                Bezier([0, k + 0.5])
            except blossom.Error:
                pass
            try:
                p(object())
            except blossom.Error:
                pass
            blossom.answer({"op": "agree", "map": p, "arguments": [1, 2, t]})


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="needs /proc")
def test_memory_stays_flat():
    count = int(os.environ.get("BLOSSOM_CALLS", 4000))
    calls(count)
    gc.collect()
    before = memory_in_use()
    references = sys.gettotalrefcount() if hasattr(sys, "gettotalrefcount") else None
    calls(2 * count)
    gc.collect()
    assert memory_in_use() - before < 2 << 20
    if references is not None:
        assert sys.gettotalrefcount() - references < 1000


def test_threads_that_end_leave_nothing():
    def work():
        calls(20)

    def run(count):
        for _ in range(count):
            thread = threading.Thread(target=work)
            thread.start()
            thread.join()

    run(20)
    before = memory_in_use()
    run(60)
    assert memory_in_use() - before < 2 << 20


def test_the_module_is_imported_quickly():
    def seconds():
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        return used.ru_utime + used.ru_stime

    before = seconds()
    subprocess.run([sys.executable, "-c", "import blossom"], check=True)
    assert seconds() - before < 1
