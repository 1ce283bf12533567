"""Every operation of the protocol is a method or a function, described by what it says of itself."""

import builtins
import inspect
import keyword
import re

import pytest

import blossom
from blossom import Bezier, Map, Polynomial, operations

DESCRIPTIONS = blossom._engine.operations()


def python_name(name):
    return name + "_" if keyword.iskeyword(name) else name.replace("-", "_")


@pytest.mark.parametrize("description", DESCRIPTIONS, ids=lambda d: d["name"])
def test_every_operation_is_there_with_its_description(description):
    name = python_name(description["name"])
    fields = [field["name"] for field in description["fields"]]
    found = [getattr(operations, name)]
    assert name in operations.__all__
    if "map" in fields:
        found.append(getattr(Map, name))
    if not any(field["name"] == "map" and field["required"] for field in description["fields"]):
        assert getattr(blossom, name) is getattr(operations, name)
        assert (name in blossom.__all__) != hasattr(builtins, name)
    for function in found:
        documentation = inspect.getdoc(function)
        words = " ".join(documentation.split())
        assert documentation.startswith(description["summary"] + ".")
        assert " ".join(description["documentation"].split()) in words
        parameters = inspect.signature(function).parameters
        for field in description["fields"]:
            if field["name"] == "map":
                continue
            assert python_name(field["name"]) in parameters
            assert re.search(rf"^{python_name(field['name'])} : ", documentation, re.M)
            assert " ".join(field["documentation"].split()) in words
        for member in description["result"]:
            assert re.search(rf"^{python_name(member['name'])} : ", documentation, re.M)
        for common in ("floats", "numbers", "timeout", "max_memory", "max_work", "limits"):
            assert common in parameters


def test_no_class_is_missing():
    titles = {kind["title"] for kind in blossom._engine.kinds()}
    assert {cls._title.removesuffix(" rational") for cls in blossom._maps.CLASSES.values()} == titles
    for cls in blossom._maps.CLASSES.values():
        kind = next(k for k in blossom._engine.kinds() if k["title"] == cls._title.removesuffix(" rational"))
        assert all(f"{field['name']} : " in cls.__doc__ for field in kind["fields"])


def test_functions_and_methods_give_the_same():
    p = Polynomial("t^2")
    assert operations.elevate(p, by=1) == p.elevate(1) == p.elevate(by=1)
    assert operations.blossom(p, 1, 2) == p.blossom(1, 2) == p.blossom(arguments=[1, 2]) == p[1, 2]
    assert operations.elevate({"kind": "bezier", "control_points": [0, 1]}, by=1) == Bezier([0, "1/2", 1])
    assert operations.join([Bezier([0, 1]), Bezier([1, 2], [1, 2])]) == blossom.join(maps=[Bezier([0, 1]), Bezier([1, 2], [1, 2])])


def test_limits_of_one_call():
    p = Polynomial("t^500")
    with pytest.raises(blossom.LimitExceeded) as caught:
        p.control_points(max_work=1000)
    assert caught.value.limit == "work"
    with pytest.raises(blossom.LimitExceeded) as caught:
        p.control_points(max_memory=10_000)
    assert caught.value.limit == "memory"
    with pytest.raises(blossom.LimitExceeded) as caught:
        p.elevate(by=1, limits={"degree": 400})
    assert caught.value.limit == "degree"
    with pytest.raises(blossom.Error) as caught:
        p.elevate(by=1, limits={"degre": 400})
    assert caught.value.code == "unknown_field"
    with pytest.raises(blossom.Error) as caught:
        p.elevate(by=1, timeout=-1)
    assert caught.value.place == ("limits", "timeout")
    assert blossom.answer({"op": "control-points", "map": p}, max_work=1000)["error"]["limit"] == "work"


def test_a_result_of_several_members():
    result = blossom.operations.roots(Polynomial("t^2 - 1"))
    assert [root["value"] for root in result.roots] == [-1, 1]
    assert result["roots"] == result.roots and "roots" in result
    assert dict(result)["roots"] == result.roots
    assert "t = -1" in str(result) or "-1" in str(result)
    with pytest.raises(AttributeError):
        result.root
    with pytest.raises(AttributeError):
        result.roots = ()


def test_statements_are_true_or_false():
    assert blossom.prove("map p degree 2\nclaim p[s, u] == p[u, s]")
    assert not blossom.prove("claim 1 == 2")
