#!/usr/bin/env python3
"""Measures the pages of a folder in headless Chromium, light and dark, at the widths of a desktop and of a phone.

usage: look_at_pages.py GALLERY WORK [PICTURES]   (WORK: a folder for intermediate files; PICTURES receives screenshots)

First it breaks a page in every way that it checks for, and must detect each.
"""

import html
import json
import pathlib
import re
import shutil
import subprocess
import sys

WIDTHS = {"desk": 1100, "phone": 390}
SCHEMES = {"light": 1, "dark": 0}
MEASURE = pathlib.Path(__file__).with_name("measure_page.js")
# Errors of a page are caught from the beginning.
CATCH = "<head><script>window.pageErrors=[];addEventListener('error',e=>pageErrors.push('error: '+e.message),true)</script>"
# The greatest share of labels that may have a line behind them.
MOST_CROSSED = 0.1

BROKEN = {
    "error: ": ("</body>", "<script>undefinedFunction()</script></body>"),
    "the page is": ("</h1>", '</h1><div style="width:3000px">wide</div>'),
    "a formula does not fit": ('<div class="formula">', '<div class="formula" style="width:9px">'),
    "a formula is not laid out": ("<math", '<math style="display:none"'),
    "a fraction lies on its side": ("<mfrac>", '<mfrac style="display:inline-flex">'),
    "a power is not raised": ("<msup>", '<msup style="display:inline-block;max-width:5px">'),
    "not one heading": ("<h1>", "<h1>again</h1><h1>"),
    "no language": (' lang="en"', ""),
    "a picture without title": ('role="img"', ""),
    "without scope": (' scope="col"', ""),
    "contrast": ("--ink:#1b1b1b", "--ink:#c0c0c0"),
    "labels on each other": ('<text x="', '<text x="200" y="50">over</text><text x="200" y="50">over</text><text x="'),
    "a label leaves its picture": ('<text x="', '<text x="-90" y="5">outside</text><text x="'),
    "a label on a point": ('<circle cx="', '<text x="99" y="99">on</text><circle cx="99" cy="99" r="5"/><circle cx="'),
    "a node is too small": ('class="name">', 'class="name">very long and longer and longer '),
    "scrolls, but not by keys": ('tabindex="0"', ""),
}


def chromium(*arguments):
    command = ["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--enable-logging=stderr"]
    answer = subprocess.run([*command, *arguments], capture_output=True, text=True, timeout=300, check=True)
    return answer.stdout, [line for line in answer.stderr.splitlines() if ":CONSOLE" in line]


def measured(pages, work, scheme):
    """The measurements of each page at each width, and the lines of the console."""
    folder = work / "measured"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for name, text in pages.items():
        (folder / name).write_text(text.replace("<head>", CATCH, 1), encoding="utf-8")
    outer = folder / "all.html"
    call = f"run({json.dumps(list(pages))}, {json.dumps(WIDTHS)})"
    outer.write_text(f"<body><script>{MEASURE.read_text(encoding='utf-8')}\n{call}</script>", encoding="utf-8")
    options = ["--allow-file-access-from-files", f"--blink-settings=preferredColorScheme={SCHEMES[scheme]}"]
    dump, console = chromium(*options, "--window-size=1200,2000", "--virtual-time-budget=60000", "--dump-dom", f"file://{outer}")
    found = re.search(r'<pre id="measured">(.*?)</pre>', dump, re.S)
    if not found:
        sys.exit(f"the pages were not measured: {dump[-500:]} {console}")
    return json.loads(html.unescape(found.group(1))), console


def broken_links(page, text):
    targets = re.findall(r'(?:href|src)="([^"#]*)"', text)
    return [f"a link to {target} leads nowhere" for target in targets if not (page.parent / target).is_file()]


def what_is_not_found(pages, work):
    """Breaks pages on purpose, and returns the names of the faults that were not detected."""
    broken = {}
    for i, (problem, (old, new)) in enumerate(BROKEN.items()):
        text = next((text for text in pages.values() if old in text and "<circle" in text and "<mfrac>" in text), None)
        if text is None:
            return [f"no page has {old}"]
        broken[f"{i}.html"] = text.replace(old, new) if problem in ("contrast", "a formula is not laid out") else text.replace(old, new, 1)
    results, _ = measured(broken, work, "light")
    missed = []
    for i, problem in enumerate(BROKEN):
        found = [one for at in results[f"{i}.html"].values() for one in at["problems"]]
        if not any(one.startswith(problem) or problem in one for one in found):
            missed.append(f"not noticed: {problem}")
    if not broken_links(pathlib.Path(work) / "page.html", '<a href="nowhere.html">'):
        missed.append("not noticed: a broken link")
    return missed


def take_pictures(path, heights, work, folder):
    folder.mkdir(parents=True, exist_ok=True)
    for scheme in SCHEMES:
        for name, width in WIDTHS.items():
            height = min(heights[name], 8000)
            frame = work / "frame.html"
            frame.write_text(
                f'<body style="margin:0"><iframe src="file://{path}" style="width:{width}px;height:{height}px;border:0"></iframe>',
                encoding="utf-8",
            )
            setting = f"--blink-settings=preferredColorScheme={SCHEMES[scheme]}"
            # Chromium has a minimum window width.
            size = f"--window-size={max(width, 500)},{height}"
            chromium(setting, size, f"--screenshot={folder}/{path.stem}-{name}-{scheme}.png", f"file://{frame}")
    chromium(f"--print-to-pdf={folder}/{path.stem}-printed.pdf", "--no-pdf-header-footer", f"file://{path}")


def main(gallery, work, pictures=None):
    paths = sorted(pathlib.Path(gallery).glob("*.html"))
    work = pathlib.Path(work)
    pages = {path.name: path.read_text(encoding="utf-8") for path in paths}
    problems = what_is_not_found(pages, work)
    formulas = labels = 0
    crossed = []
    for path in paths:
        problems += [f"{path.name}: {problem}" for problem in broken_links(path, pages[path.name])]
        if "<script" in pages[path.name]:
            problems.append(f"{path.name}: there is a script")
    for scheme in SCHEMES:
        results, console = measured(pages, work, scheme)
        problems += console
        for page, widths in results.items():
            for name, result in widths.items():
                problems += [f"{page}, {scheme}, {name}: {problem}" for problem in result["problems"]]
                formulas += result["formulas"]
                labels += result["labels"]
                crossed += [f"{page}: {label}" for label in result["crossed"]]
        if pictures and scheme == "light":
            for path in paths:
                take_pictures(path, {name: result["height"] for name, result in results[path.name].items()}, work, pathlib.Path(pictures))
    if len(crossed) > MOST_CROSSED * labels:
        problems.append(f"{len(crossed)} of {labels} labels have a line behind them: {sorted(set(crossed))}")
    print("\n".join(problems))
    print(f"{len(pages)} pages, {len(WIDTHS)} widths, {len(SCHEMES)} schemes: {formulas} formulas, {labels} labels, {len(crossed)} of them on a line")
    print(f"{len(problems)} problems")
    return 1 if problems or not pages or not formulas or not labels else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
