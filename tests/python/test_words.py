"""Every public name has words, and the types in the .pyi files are those of the extensions."""

import ast
import importlib
import inspect
import pathlib
import re

import pytest

import clearway

FOLDER = pathlib.Path(clearway.__file__).parent


def modules():
    yield clearway
    for name in ("planning", "ompl"):
        try:
            yield importlib.import_module("clearway." + name)
        except ImportError:  # built without OMPL
            pass


def is_own(thing, module):
    return getattr(thing, "__module__", "") == module.__name__ and not thing.__name__.startswith("_")


def words_of(thing):
    """The docstring less pybind11's signature, which is its first line."""
    lines = (inspect.getdoc(thing) or "").splitlines()
    if lines and re.match(r"\w+\(.*\) -> ", lines[0]):
        lines = lines[1:]
    return "\n".join(lines).strip()


def public_members(owner):
    for name, member in vars(owner).items():
        if not name.startswith("_") and (callable(member) or isinstance(member, (property, staticmethod, classmethod))):
            yield name, member


def test_every_public_name_has_words():
    count = 0
    for module in modules():
        assert words_of(module)
        for name in getattr(module, "__all__", [name for name, thing in vars(module).items() if is_own(thing, module)]):
            thing = getattr(module, name)
            if name == "__version__":
                continue
            assert words_of(thing), name
            count += 1
            if inspect.isclass(thing):
                for member_name, member in public_members(thing):
                    assert words_of(getattr(member, "__func__", member)), "%s.%s" % (name, member_name)
                    count += 1
    assert count > 80


def test_every_field_of_a_result_has_words():
    """Python keeps no docstrings of fields: they are read from the source."""
    source = ast.parse((FOLDER / "_results.py").read_text())
    count = 0
    for node in source.body:
        if isinstance(node, ast.ClassDef):
            for field, after in zip(node.body, node.body[1:] + [None]):
                if isinstance(field, ast.AnnAssign):
                    assert isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant), (node.name, field.target.id)
                    count += 1
    assert count > 50


def signature_in_words(function):
    """Names of parameters, and whether they have a default, from the line that pybind11 writes."""
    line = inspect.getdoc(function).splitlines()[0]
    inner = line[line.index("(") + 1:line.rindex(") -> ")]
    inner = re.sub(r"\[[^][]*(\[[^][]*\][^][]*)*\]", "", inner)  # the commas of types
    found = []
    for part in inner.split(", "):
        name = re.match(r"(\w+)", part)
        if name and name[1] != "self":
            found.append((name[1], " = " in part))
    return found


def signature_in_stub(function):
    arguments = function.args
    defaults = [None] * (len(arguments.args) - len(arguments.defaults)) + list(arguments.defaults)
    pairs = list(zip(arguments.args, defaults)) + list(zip(arguments.kwonlyargs, arguments.kw_defaults))
    return [(each.arg, default is not None) for each, default in pairs if each.arg != "self"]


@pytest.mark.parametrize("name", ["_core", "_planning"])
def test_types_are_those_of_the_extension(name):
    module = pytest.importorskip("clearway." + name, reason="clearway was built without OMPL")
    stub = ast.parse((FOLDER / (name + ".pyi")).read_text())
    functions = {node.name: node for node in stub.body if isinstance(node, ast.FunctionDef)}
    classes = {node.name: node for node in stub.body if isinstance(node, ast.ClassDef)}
    public = {each for each in vars(module) if not each.startswith("_")}
    assert set(functions) | set(classes) == public
    for function, node in functions.items():
        if not function.endswith(("_at_state", "_motion")):  # of ompl.py's; their numbers have no names
            assert signature_in_words(getattr(module, function)) == signature_in_stub(node), function
    for class_name, node in classes.items():
        owner = getattr(module, class_name)
        members = {each.name: each for each in node.body if isinstance(each, ast.FunctionDef)}
        assert {each for each in members if not each.startswith("_")} == {each for each, _ in public_members(owner)}, class_name
        for member, declared in members.items():
            if not isinstance(vars(owner)[member], property) and member not in ("__copy__", "__deepcopy__"):
                assert signature_in_words(getattr(owner, member)) == signature_in_stub(declared), class_name + "." + member
        settable = {each.name for each in node.body if isinstance(each, ast.FunctionDef)
                    and any(isinstance(d, ast.Attribute) and d.attr == "setter" for d in each.decorator_list)}
        assert settable == {each for each, member in public_members(owner) if isinstance(member, property) and member.fset}
