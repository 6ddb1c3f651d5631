"""What is shipped for editors and type checkers is what is there, and is explained."""
import ast
import inspect
import unittest
from pathlib import Path

import rockstack
from rockstack import _core


class StubsTest(unittest.TestCase):
    def test_stubs_name_all_that_the_core_has(self):
        tree = ast.parse(Path(rockstack.__file__).with_name("_core.pyi").read_text())
        classes = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
        functions = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
        values = {node.target.id for node in tree.body if isinstance(node, ast.AnnAssign)}
        public = {name for name in vars(_core) if not name.startswith("_")}
        self.assertEqual(public - {"InputError"}, set(classes) | functions | values)
        for name, node in classes.items():
            told = {entry.name for entry in node.body if isinstance(entry, ast.FunctionDef)}
            there = {entry for entry in vars(getattr(_core, name)) if not entry.startswith("_")}
            self.assertEqual(told - {"__init__"}, there, name)

    def test_all_that_is_public_is_explained(self):
        for name in rockstack.__all__:
            entry = getattr(rockstack, name)
            if not callable(entry):
                continue
            self.assertTrue(inspect.getdoc(entry), name)
            for member, value in vars(entry).items() if inspect.isclass(entry) else ():
                explained = isinstance(value, (property, classmethod)) or inspect.isfunction(value)
                if explained and not member.startswith("_"):
                    self.assertTrue(inspect.getdoc(getattr(entry, member, value)), f"{name}.{member}")

    def test_functions_state_types(self):
        for name in rockstack.__all__:
            entry = getattr(rockstack, name)
            if inspect.isfunction(entry):
                signature = inspect.signature(entry)
                self.assertIsNot(signature.return_annotation, inspect.Signature.empty, name)
                for parameter in signature.parameters.values():
                    self.assertIsNot(parameter.annotation, inspect.Parameter.empty, f"{name}({parameter})")
        self.assertTrue(Path(rockstack.__file__).with_name("py.typed").is_file())
