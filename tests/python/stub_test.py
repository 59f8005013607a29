"""The type stubs and the docstrings against the compiled module."""
import ast
import pathlib
import re
import unittest

import prelight
from prelight import _prelight

FOLDER = pathlib.Path(prelight.__file__).parent
DUNDERS = {"__init__", "__len__", "__getitem__", "__setitem__", "__delitem__", "__iter__", "__enter__", "__exit__"}
HELPERS = {"_Array", "_Word", "_List", "_EditableList"}


def public(names):
    return {name for name in names if not name.startswith("_") or name in DUNDERS}


def stub_signature(function):
    """Names of arguments; with "=" those that need not be given, after "*" those that have a name only."""
    given = function.args
    positional = given.posonlyargs + given.args
    required = len(positional) - len(given.defaults)
    names = [argument.arg + ("=" if i >= required else "") for i, argument in enumerate(positional)]
    if given.kwonlyargs:
        names.append("*")
    names += [argument.arg + ("=" if default else "") for argument, default in zip(given.kwonlyargs, given.kw_defaults)]
    return [name for name in names if name != "self"]


def module_signature(doc):
    """The same of the first line that pybind11 writes into a docstring."""
    text = doc.splitlines()[0]
    text = text[text.index("(") + 1:text.rindex(") ->")]
    arguments, depth, current = [], 0, ""
    for letter in text + ",":
        depth += (letter in "([{<") - (letter in ")]}>")
        if letter == "," and depth == 0:
            arguments.append(current.strip())
            current = ""
        else:
            current += letter
    names = [argument.split(":")[0] + ("=" if " = " in argument else "") for argument in arguments if argument]
    return [name for name in names if name != "self"]


def read_stubs():
    trees = [ast.parse((FOLDER / name).read_text()) for name in ("_prelight.pyi", "_figures.pyi")]
    return [node for tree in trees for node in tree.body]


class Stub(unittest.TestCase):
    def setUp(self):
        nodes = read_stubs()
        self.classes = {node.name: node for node in nodes if isinstance(node, ast.ClassDef)}
        self.functions = {node.name: node for node in nodes if isinstance(node, ast.FunctionDef)}

    def members(self, node):
        """Name -> function, or None of an attribute; with those of the bases that are stubs alone."""
        found = {}
        for base in node.bases:
            name = base.value.id if isinstance(base, ast.Subscript) else base.id
            if name in HELPERS:
                found |= self.members(self.classes[name])
        for each in node.body:
            if isinstance(each, ast.FunctionDef):
                decorators = {ast.unparse(decorator) for decorator in each.decorator_list}
                attribute = any(word == "property" or word.endswith(".setter") for word in decorators)
                found[each.name] = None if attribute else each
            elif isinstance(each, ast.AnnAssign):
                found[each.target.id] = None
            elif isinstance(each, ast.Assign):
                found[each.targets[0].id] = None
        return found

    def test_names(self):
        self.assertEqual(public(vars(_prelight)), (set(self.classes) - HELPERS) | set(self.functions))
        self.assertEqual(public(vars(_prelight)) - public(vars(prelight)), set())

    def test_functions(self):
        for name, function in self.functions.items():
            self.assertEqual(module_signature(getattr(prelight, name).__doc__), stub_signature(function), name)

    def test_classes(self):
        for name, node in self.classes.items():
            if name in HELPERS:
                continue
            made, members = getattr(prelight, name), self.members(node)
            self.assertEqual(made.__module__, "prelight", name)
            if issubclass(made, str):
                self.assertEqual(set(made.__members__), set(members), name)
                continue
            if not issubclass(made, Exception):  # a class that cannot be made has an __init__ that says so
                there = public(vars(made))
                if not made.__init__.__doc__.startswith("__init__("):
                    there -= {"__init__"}
                self.assertEqual(there, set(members), name)
            for word, function in members.items():
                if function and word not in ("__getitem__", "__enter__", "__exit__"):
                    doc = getattr(made, word).__doc__
                    self.assertEqual(module_signature(doc), stub_signature(function), f"{name}.{word}")

    def test_what_cannot_be_assigned(self):
        for name, node in self.classes.items():
            if name in HELPERS or issubclass(getattr(prelight, name), (str, Exception)):
                continue
            for each in node.body:
                if isinstance(each, ast.AnnAssign):
                    settable = vars(getattr(prelight, name))[each.target.id].fset is not None
                    final = ast.unparse(each.annotation).startswith("Final")
                    self.assertEqual(settable, not final, f"{name}.{each.target.id}")


class Docstrings(unittest.TestCase):
    def test_everything_has_one(self):
        def text(doc):  # without the signatures
            return re.sub(r"(?m)^(\d+\. )?\w+\(.*\) -> .*$|^Overloaded function\.$", "", doc or "").strip()
        for name in public(vars(_prelight)):
            each = getattr(prelight, name)
            self.assertTrue(text(each.__doc__), name)
            if isinstance(each, type) and not issubclass(each, (str, Exception)):
                for word, member in vars(each).items():
                    if isinstance(member, property):
                        self.assertTrue(text(member.__doc__), f"{name}.{word}")

    def test_arrays_say_their_shape(self):
        for name, made in vars(_prelight).items():
            for word, member in vars(made).items() if isinstance(made, type) else ():
                if isinstance(member, property) and "numpy.ndarray" in (member.fget.__doc__ or ""):
                    shape = r"\(\w+(, \w+)*,?\) (float32|float64|uint32|bool)"
                    self.assertRegex(member.__doc__, shape, f"{name}.{word}")


if __name__ == "__main__":
    unittest.main()
