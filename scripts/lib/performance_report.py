#!/usr/bin/env python3
"""performance_report.py VALUES_CSV PROCESSES_CSV FOLDER: writes values.md and one plot per size of numbers into FOLDER."""

import csv
import math
import platform
import sys
from pathlib import Path

values = list(csv.DictReader(open(sys.argv[1])))
processes = list(csv.DictReader(open(sys.argv[2])))
folder = Path(sys.argv[3])
colours = {"engine": "#c0392b", "FLINT": "#2c3e50", "mpq_rational": "#7f8c8d"}


def two_digits(text):
    number = float(text)
    return f"{number:.2g}" if number < 100 else f"{int(round(number, 1 - math.floor(math.log10(number))))}"


def duration(nanoseconds):
    for unit, size in (("ns", 1), ("us", 1e3), ("ms", 1e6)):
        if nanoseconds < 1000 * size:
            return f"{nanoseconds / size:.3g} {unit}"
    return f"{nanoseconds / 1e9:.3g} s"


def machine():
    model = next((line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")), "unknown")
    flags = next((line for line in open("/proc/cpuinfo") if line.startswith("flags")), "")
    vectors = "AVX-512 IFMA" if "avx512ifma" in flags else "AVX2" if "avx2" in flags else "no AVX2"
    return f"{model} ({vectors}), {platform.system()} {platform.release().split('-')[0]}"


def table(rows):
    lines = ["| work | degree | bits | engine | peer | its time | ratio | range |", "| --- | ---: | ---: | ---: | --- | ---: | ---: | --- |"]
    for row in rows:
        lines.append(
            f"| {row['work']} | {row['degree']} | {row['bits']} | {duration(float(row['engine_ns']))} | {row['peer']} | "
            f"{duration(float(row['peer_ns']))} | {two_digits(row['ratio'])} | {two_digits(row['least_ratio'])} to {two_digits(row['greatest_ratio'])} |"
        )
    return lines


def process_table():
    lines = ["| peer | degree | bits | its time | engine, prepared |", "| --- | ---: | ---: | ---: | ---: |"]
    for row in processes:
        engine = [v for v in values if v["work"] == "prepared" and (v["degree"], v["bits"]) == (row["degree"], row["bits"])]
        ours = duration(float(engine[0]["engine_ns"])) if engine else ""
        lines.append(f"| {row['peer']} | {row['degree']} | {row['bits']} | {duration(float(row['nanoseconds']))} | {ours} |")
    return lines


def exponent(a, b, key, times):
    return math.log(float(b[times]) / float(a[times])) / math.log(int(b[key]) / int(a[key]))


def exponents(key, other):
    """The growth of every operation, compared with FLINT, between neighbours in `key`, with `other` fixed."""
    lines = [f"| work | {other} | {key} | engine | FLINT |", "| --- | ---: | --- | ---: | ---: |"]
    rows = [v for v in values if v["peer"] == "FLINT"]
    for work in dict.fromkeys(v["work"] for v in rows):
        for fixed in sorted({int(v[other]) for v in rows if v["work"] == work}):
            series = sorted((v for v in rows if v["work"] == work and int(v[other]) == fixed), key=lambda v: int(v[key]))
            for a, b in zip(series, series[1:]):
                ours, theirs = (exponent(a, b, key, times) for times in ("engine_ns", "peer_ns"))
                lines.append(f"| {work} | {fixed} | {a[key]} to {b[key]} | {ours:.2f} | {theirs:.2f} |")
    return lines


def plot(work, bits, title, stem):
    series = {}
    for v in values:
        if v["work"] == work and int(v["bits"]) == bits and v["peer"] in colours:
            series.setdefault("engine", {})[int(v["degree"])] = float(v["engine_ns"])
            series.setdefault(v["peer"], {})[int(v["degree"])] = float(v["peer_ns"])
    if len(series.get("engine", {})) < 2:
        return
    degrees = sorted(series["engine"])
    low = math.floor(math.log10(min(t for s in series.values() for t in s.values())))
    high = math.ceil(math.log10(max(t for s in series.values() for t in s.values())))
    width, height, left, bottom = 560, 360, 70, 40
    span = math.log(degrees[-1] / degrees[0]) or 1

    def x(degree):
        return left + (width - left - 110) * math.log(degree / degrees[0]) / span

    def y(time):
        return height - bottom - (height - bottom - 30) * (math.log10(time) - low) / (high - low)

    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="12">']
    out.append(f'<rect width="{width}" height="{height}" fill="white"/>')
    out.append(f'<text x="{left}" y="18">{title}</text>')
    for power in range(low, high + 1):
        out.append(f'<path d="M{left} {y(10**power):.1f}H{width - 110}" stroke="#ddd"/>')
        out.append(f'<text x="{left - 8}" y="{y(10**power) + 4:.1f}" text-anchor="end">{duration(10.0**power)}</text>')
    for degree in degrees:
        out.append(f'<text x="{x(degree):.1f}" y="{height - bottom + 18}" text-anchor="middle">{degree}</text>')
    for name, points in series.items():
        line = " ".join(f"{x(d):.1f},{y(t):.1f}" for d, t in sorted(points.items()))
        last = max(points)
        out.append(f'<polyline points="{line}" fill="none" stroke="{colours[name]}" stroke-width="2"/>')
        out.append(f'<text x="{x(last) + 6:.1f}" y="{y(points[last]) + 4:.1f}" fill="{colours[name]}">{name}</text>')
    out.append(f'<text x="{(left + width - 110) / 2}" y="{height - 6}" text-anchor="middle">degree</text></svg>')
    (folder / f"{stem}.svg").write_text("\n".join(out) + "\n")


headings = {
    "values": "Values of a blossom",
    "constructions": "Constructions",
    "operations": "Whole polynomials",
    "curves": "Curves",
    "splines": "Splines",
    "agreement": "Agreement for all arguments",
    "threads": "Two threads",
    "machine": "Distance from the machine",
}
lines = [f"Measured on {machine()}, one thread.", ""]
for family in dict.fromkeys(v["family"] for v in values):
    lines += [f"## {headings.get(family, family)}", ""] + table([v for v in values if v["family"] == family]) + [""]
lines += ["## Processes", ""] + process_table()
lines += ["", "## Growth", "", "The exponent e of degree^e between two degrees, and of bits^e between two sizes:", ""]
lines += exponents("degree", "bits") + [""] + exponents("bits", "degree")
lines += ["", f"Peak memory of the measuring process: {max(int(v['peak_memory_kib']) for v in values) // 1024} MiB."]
(folder / "values.md").write_text("# Measured\n\n" + "\n".join(lines) + "\n")
for size in sorted({int(v["bits"]) for v in values}):
    plot("prepared", size, f"One value of a prepared blossom, numbers of {size} bits", f"values-{size}")
    plot("evaluation", size, f"A thousand values of a polynomial, numbers of {size} bits", f"evaluation-{size}")
plot("Taylor shift", 64, "Taylor shift by 1, coefficients of 64 bits", "taylor-shift")
plot("control points", 7, "All control points over [a, b], ends of 7 bits", "control-points")
