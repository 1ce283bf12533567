// Runs in a frame around each page of a gallery, at each width, and leaves what it found as JSON in the element "measured".
'use strict';

const box = (node) => node.getBoundingClientRect();
const across = (a, b) => Math.min(a.right, b.right) - Math.max(a.left, b.left);
// The boxes of letters have some room above and below.
const middle = (a) => ({left: a.left, right: a.right, top: a.top + 0.2 * (a.bottom - a.top), bottom: a.bottom - 0.2 * (a.bottom - a.top)});
const down = (a, b) => Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
const overlap = (a, b) => across(a, b) > 1 && down(middle(a), middle(b)) > 1;
const inside = (a, b) => a.left >= b.left - 1 && a.right <= b.right + 1 && a.top >= b.top - 1 && a.bottom <= b.bottom + 1;
const shown = (node) => !node.closest('details:not([open])') && !node.closest('title, desc, style, script');

function luminance(color) {
  const part = (x) => (x / 255 <= 0.03928 ? x / 255 / 12.92 : ((x / 255 + 0.055) / 1.055) ** 2.4);
  const [r, g, b] = color.match(/[\d.]+/g).map(Number);
  return 0.2126 * part(r) + 0.7152 * part(g) + 0.0722 * part(b);
}

function contrast(a, b) {
  const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
}

function paperBehind(node, view) {
  for (let one = node; one; one = one.parentElement) {
    const color = view.getComputedStyle(one).backgroundColor;
    if (color !== 'rgba(0, 0, 0, 0)' && color !== 'transparent') return color;
  }
  return 'rgb(255, 255, 255)';
}

function textProblems(page, view) {
  const problems = new Set();
  for (const node of page.querySelectorAll('h1, h2, p, td, th, caption, figcaption, summary, a, li, math, svg text')) {
    if (!shown(node) || !node.textContent.trim()) continue;
    const drawn = node.matches('svg text');
    const behind = drawn && node.matches('.name, .value') ? view.getComputedStyle(node.ownerSVGElement.querySelector('.node')).fill : paperBehind(node, view);
    const ratio = contrast(view.getComputedStyle(node)[drawn ? 'fill' : 'color'], behind);
    if (ratio < 4.5) problems.add(`contrast ${ratio.toFixed(1)} of ${node.tagName} ${node.textContent.slice(0, 30)}`);
  }
  return [...problems];
}

function structureProblems(page) {
  const problems = [];
  if (page.querySelectorAll('h1').length !== 1) problems.push('not one heading of the page');
  if (!page.documentElement.lang) problems.push('the page says no language');
  for (const svg of page.querySelectorAll('svg')) {
    if (svg.getAttribute('role') !== 'img' || !svg.querySelector('title')?.textContent) problems.push('a picture without title');
  }
  for (const cell of page.querySelectorAll('th')) {
    if (!cell.scope) problems.push('a heading of a table without scope');
  }
  return problems;
}

function formulaProblems(page) {
  const problems = [];
  for (const math of page.querySelectorAll('math')) {
    if (!shown(math)) continue;
    const {width, height} = box(math);
    if (width < 2 || height < 5) problems.push('a formula is not laid out: ' + math.textContent);
  }
  for (const fraction of page.querySelectorAll('mfrac')) {
    if (!shown(fraction)) continue;
    const [above, below] = [...fraction.children].map(box);
    if (above.bottom > below.top + 1) problems.push('a fraction lies on its side: ' + fraction.textContent);
  }
  for (const power of page.querySelectorAll('msup')) {
    if (!shown(power)) continue;
    const [base, exponent] = [...power.children].map(box);
    if (exponent.left < base.right - 1 || exponent.top > base.top + base.height / 2) problems.push('a power is not raised: ' + power.textContent);
  }
  return problems;
}

function overflowProblems(page, wide) {
  const problems = [];
  const width = page.documentElement.clientWidth;
  if (page.documentElement.scrollWidth > width + 1) problems.push(`the page is ${page.documentElement.scrollWidth} wide`);
  const outOf = (node) => node.scrollWidth > node.clientWidth + 1;
  for (const node of page.querySelectorAll('.formula')) {
    if (shown(node) && outOf(node)) problems.push('a formula does not fit: ' + node.textContent.slice(0, 60));
  }
  for (const node of page.querySelectorAll('.wide')) {
    // On a phone tables and pyramids may scroll by themselves.
    if (wide && outOf(node)) problems.push('does not fit: ' + node.getAttribute('aria-label'));
    if (outOf(node) && node.tabIndex !== 0) problems.push('scrolls, but not by keys: ' + node.getAttribute('aria-label'));
  }
  for (const node of page.querySelectorAll('h1, h2, p, figcaption, li, nav, svg.picture')) {
    if (shown(node) && !node.closest('.wide') && box(node).right > width + 1) problems.push('leaves the page: ' + node.textContent.slice(0, 40));
  }
  return problems;
}

/// Whether a drawn line runs through a box, by points along it.
function runsThrough(line, target) {
  const matrix = line.getScreenCTM();
  const length = line.getTotalLength();
  for (let at = 0; at <= length; at += 2) {
    const point = line.getPointAtLength(at).matrixTransform(matrix);
    if (point.x > target.left && point.x < target.right && point.y > target.top && point.y < target.bottom) return true;
  }
  return false;
}

function drawingProblems(svg) {
  const problems = [];
  const labels = [...svg.querySelectorAll('text')];
  const paper = box(svg);
  const boxes = labels.map(box);
  labels.forEach((label, i) => {
    if (!inside(boxes[i], paper)) problems.push('a label leaves its picture: ' + label.textContent);
    for (let j = i + 1; j < labels.length; ++j) {
      if (overlap(boxes[i], boxes[j])) problems.push(`labels on each other: ${label.textContent} and ${labels[j].textContent}`);
    }
    for (const dot of svg.querySelectorAll('circle')) {
      if (overlap(boxes[i], box(dot))) problems.push('a label on a point: ' + label.textContent);
    }
  });
  const nodes = [...svg.querySelectorAll('rect.node')].map(box);
  labels.forEach((label, i) => {
    const within = nodes.some((node) => inside(boxes[i], node));
    if (label.matches('.name, .value') && !within) problems.push('a node is too small for ' + label.textContent);
    if (label.matches('.weight') && nodes.some((node) => overlap(boxes[i], node))) problems.push('a weight on a node: ' + label.textContent);
  });
  return problems;
}

/// Labels with a line of the drawing behind them: they have a halo, but should be few.
function crossedLabels(svg) {
  const lines = [...svg.querySelectorAll('path.line, path.curve')];
  return [...svg.querySelectorAll('text.label')].filter((label) => lines.some((line) => runsThrough(line, middle(box(label)))));
}

function measured(frame, wide) {
  const page = frame.contentDocument;
  const problems = [...(frame.contentWindow.pageErrors || []), ...structureProblems(page), ...formulaProblems(page), ...overflowProblems(page, wide), ...textProblems(page, frame.contentWindow)];
  const drawings = [...page.querySelectorAll('svg')];
  for (const svg of drawings) problems.push(...drawingProblems(svg));
  const crossed = drawings.flatMap(crossedLabels).map((label) => label.textContent);
  return {
    problems,
    crossed,
    labels: page.querySelectorAll('svg text.label').length,
    formulas: page.querySelectorAll('math').length,
    height: page.documentElement.scrollHeight,
  };
}

async function run(pages, widths) {
  const frame = document.createElement('iframe');
  frame.style.border = '0';
  document.body.appendChild(frame);
  const results = {};
  for (const page of pages) {
    for (const [name, width] of Object.entries(widths)) {
      frame.style.width = width + 'px';
      frame.style.height = '2000px';
      await new Promise((loaded) => {
        frame.onload = loaded;
        frame.src = page;
      });
      await frame.contentDocument.fonts.ready;
      results[page] ??= {};
      results[page][name] = measured(frame, width >= 800);
    }
  }
  const text = document.createElement('pre');
  text.id = 'measured';
  text.textContent = JSON.stringify(results);
  document.body.replaceChildren(text);
}
