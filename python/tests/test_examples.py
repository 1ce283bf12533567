"""The examples of the documentation: of every docstring, and of docs/python.md."""

import doctest
import importlib
import pkgutil
from pathlib import Path

import pytest

import blossom

ROOT = Path(__file__).resolve().parents[2]
OPTIONS = doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS
MODULES = [f"blossom.{module.name}" for module in pkgutil.iter_modules(blossom.__path__)]


@pytest.mark.parametrize("name", ["blossom", *(name for name in MODULES if not name.endswith("_engine"))])
def test_docstrings(name):
    failures, tests = doctest.testmod(importlib.import_module(name), optionflags=OPTIONS)
    assert failures == 0


@pytest.mark.parametrize("operation", blossom._operations.ALL, ids=lambda operation: operation.name)
def test_operations(operation):
    """The example of an operation runs; nothing that it gives is compared."""
    functions = [getattr(blossom.operations, operation.python_name)]
    if operation.takes_map and operation.example(True):
        functions.append(getattr(blossom.Map, operation.python_name))
    for function in functions:
        examples = doctest.DocTestFinder().find(function, globs={})
        assert sum(len(test.examples) for test in examples) == 2
        for test in examples:
            assert doctest.DocTestRunner().run(test, clear_globs=False).failed == 0
            assert test.globs["result"] is not None


def test_there_are_examples():
    count = sum(len(test.examples) for name in MODULES if not name.endswith("_engine")
                for test in doctest.DocTestFinder().find(importlib.import_module(name)))  # fmt: skip
    assert count > 40


@pytest.mark.parametrize("page, least", [("python.md", 35)])
def test_pages(page, least):
    failures, tests = doctest.testfile(str(ROOT / "docs" / page), module_relative=False, optionflags=OPTIONS)
    assert failures == 0 and tests >= least
