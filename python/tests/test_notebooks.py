"""The notebooks run from the first cell to the last, and each cell that ends in an expression can show its value."""

import ast
import os
import re
from pathlib import Path

import pytest

NOTEBOOKS = sorted((Path(__file__).resolve().parents[1] / "notebooks").glob("*.py"))


def cells(text):
    """(kind, source) of the cells of a notebook in the percent format."""
    parts = re.split(r"^# %%(.*)\n", text, flags=re.M)
    assert parts[0].strip() == ""
    return [("markdown" if "markdown" in kind else "code", source) for kind, source in zip(parts[1::2], parts[2::2])]


def shown(value):
    """What Jupyter asks of a value."""
    found = [repr(value)]
    for form in ("_repr_html_", "_repr_latex_", "_repr_svg_", "_repr_markdown_"):
        if hasattr(type(value), form):
            found.append(getattr(value, form)())
    return [text for text in found if text]


def test_there_are_notebooks():
    assert len(NOTEBOOKS) >= 3


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs(path, capsys):
    names = {"__name__": "notebook"}
    kinds = []
    for kind, source in cells(path.read_text()):
        kinds.append(kind)
        if kind == "markdown":
            assert all(line.startswith("#") for line in source.splitlines() if line)
            continue
        tree = ast.parse(source)
        last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
        exec(compile(tree, str(path), "exec"), names)
        if last is not None:
            value = eval(compile(ast.Expression(last.value), str(path), "eval"), names)
            assert value is None or shown(value)
    assert kinds[0] == "markdown" and kinds.count("code") >= 4
    assert capsys.readouterr().out


@pytest.mark.skipif(not os.environ.get("BLOSSOM_JUPYTER"), reason="runs with BLOSSOM_JUPYTER=1, where Jupyter is installed")
@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs_in_jupyter(path):
    import nbclient
    import nbformat

    notebook = nbformat.v4.new_notebook()
    for kind, source in cells(path.read_text()):
        if kind == "markdown":
            notebook.cells.append(nbformat.v4.new_markdown_cell(re.sub(r"^# ?", "", source, flags=re.M)))
        else:
            notebook.cells.append(nbformat.v4.new_code_cell(source))
    nbclient.NotebookClient(notebook, timeout=60, kernel_name="python3").execute()
    assert any(cell.get("outputs") for cell in notebook.cells)
