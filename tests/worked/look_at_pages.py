#!/usr/bin/env python3
"""Measures the pages of a folder in headless Chromium.

usage: look_at_pages.py GALLERY WORK [PICTURES]   (WORK: a folder for files in between; PICTURES receives screenshots)
"""

import html
import json
import pathlib
import re
import subprocess
import sys

WIDTHS = {"desk": 1100, "phone": 390}

# Runs in a copy of the page and leaves what it measured in an element that --dump-dom prints.
MEASURE = """
window.addEventListener('load', () => {
  const problems = [...window.measuredErrors];
  const box = (node) => node.getBoundingClientRect();
  const width = document.documentElement.clientWidth;
  if (document.documentElement.scrollWidth > width + 1) problems.push('the page is ' + document.documentElement.scrollWidth + ' wide');
  for (const math of document.querySelectorAll('math')) {
    if (math.closest('details')) continue;
    const {width: w, height: h} = box(math);
    if (w < 2 || h < 5) problems.push('a formula is not laid out: ' + math.textContent);
  }
  for (const fraction of document.querySelectorAll('mfrac')) {
    if (fraction.closest('details')) continue;
    const [above, below] = [...fraction.children].map(box);
    if (above.top >= below.top) problems.push('a fraction lies on its side: ' + fraction.textContent);
  }
  for (const svg of document.querySelectorAll('svg')) {
    const labels = [...svg.querySelectorAll('text')];
    const paper = box(svg);
    labels.forEach((label, i) => {
      const a = box(label);
      if (a.left < paper.left - 1 || a.right > paper.right + 1 || a.top < paper.top - 1 || a.bottom > paper.bottom + 1) {
        problems.push('a label leaves its picture: ' + label.textContent);
      }
      for (const other of labels.slice(i + 1)) {
        const b = box(other);
        // The boxes of letters have some room above and below.
        const across = Math.min(a.right, b.right) - Math.max(a.left, b.left);
        const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
        if (across > 1 && down > 0.3 * Math.min(a.height, b.height)) {
          problems.push('labels on each other: ' + label.textContent + ' and ' + other.textContent);
        }
      }
    });
  }
  for (const node of document.querySelectorAll('svg[role=img]')) {
    if (!node.querySelector('title')?.textContent) problems.push('a picture without title');
  }
  const result = {problems, formulas: document.querySelectorAll('math').length, pictures: document.querySelectorAll('svg').length};
  document.body.innerHTML = '';
  document.body.appendChild(Object.assign(document.createElement('pre'), {id: 'measured', textContent: JSON.stringify(result)}));
});
"""
CATCH = "<script>window.measuredErrors=[];window.addEventListener('error',e=>measuredErrors.push(String(e.message)))</script>"


def chromium(width, *arguments):
    command = ["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars"]
    command += [f"--window-size={width},2400", *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=120, check=True).stdout


def measured(page, width, work):
    # Chromium has a least window width, so that a narrow page stands in a frame of its own.
    text = page.read_text(encoding="utf-8").replace("<head>", "<head>" + CATCH, 1)
    inner = work / "inner.html"
    inner.write_text(text.replace("</body>", f"<script>{MEASURE}</script></body>"), encoding="utf-8")
    outer = work / "outer.html"
    outer.write_text(
        f'<iframe id="page" src="inner.html" style="width:{width}px;height:2000px;border:0"></iframe><script>'
        "window.addEventListener('load',()=>setTimeout(()=>{document.body.innerHTML="
        "document.getElementById('page').contentDocument.getElementById('measured').outerHTML},100))</script>",
        encoding="utf-8",
    )
    dump = chromium(1200, "--allow-file-access-from-files", "--virtual-time-budget=3000", "--dump-dom", f"file://{outer}")
    return json.loads(html.unescape(re.search(r'<pre id="measured">(.*?)</pre>', dump, re.S).group(1)))


def broken_links(page):
    targets = re.findall(r'href="([^"]*)"', page.read_text(encoding="utf-8"))
    return [f"a link to {target} leads nowhere" for target in targets if not (page.parent / target).is_file()]


def picture(page, name, width, work, folder):
    frame = work / "frame.html"
    frame.write_text(
        f'<body style="margin:0"><iframe src="file://{page}" style="width:{width}px;height:2400px;border:0"></iframe>',
        encoding="utf-8",
    )
    chromium(max(width, 500), f"--screenshot={folder}/{page.stem}-{name}.png", f"file://{frame}")


def main(gallery, work, pictures=None):
    pages = sorted(pathlib.Path(gallery).glob("*.html"))
    work = pathlib.Path(work)
    failures = 0
    formulas = 0
    for page in pages:
        problems = broken_links(page)
        if "<script" in page.read_text(encoding="utf-8"):
            problems.append("there is a script")
        for name, width in WIDTHS.items():
            result = measured(page, width, work)
            problems += [f"{name}: {problem}" for problem in result["problems"]]
            formulas += result["formulas"]
            if pictures:
                pathlib.Path(pictures).mkdir(parents=True, exist_ok=True)
                picture(page, name, width, work, pictures)
        for problem in problems:
            print(f"{page.name}: {problem}")
        failures += len(problems)
    print(f"{len(pages)} pages at {len(WIDTHS)} widths, {formulas} formulas, {failures} problems")
    return 1 if failures or not pages or not formulas else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
