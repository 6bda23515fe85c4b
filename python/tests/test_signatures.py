# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Public functions say the types of their arguments and results, for programs that check them."""

import ast
import builtins
import inspect
import pathlib
import sys
import typing
import unittest

import intrinsic
from intrinsic import _maps, _types

PACKAGE = pathlib.Path(intrinsic.__file__).parent


def public_functions():
    """Yields the functions and methods that users call, with their names."""
    for x in (intrinsic.read, intrinsic.load, intrinsic.map, intrinsic.points):
        yield x.__name__, x
    for name, x in inspect.getmembers(intrinsic.Surface):
        x = x.fget if isinstance(x, property) else x
        if inspect.isfunction(x) and not name.startswith("_"):
            yield f"Surface.{name}", x


class Signatures(unittest.TestCase):
    @unittest.skipIf(sys.version_info < (3, 10), "it cannot evaluate X | None")
    def test_all_arguments_and_results_have_types_that_exist(self):
        names = {**vars(typing), **vars(_types), **vars(_maps), **vars(intrinsic)}
        for name, function in public_functions():
            with self.subTest(name):
                function = inspect.unwrap(function)
                hints = typing.get_type_hints(function, {**names, **function.__globals__})
                expected = set(inspect.signature(function).parameters) - {"self"} | {"return"}
                self.assertEqual(set(hints), expected)

    def test_each_file_imports_the_names_in_its_types(self):
        for path in PACKAGE.glob("_*.py"):
            known, used = set(dir(builtins)), set()
            for node in ast.walk(ast.parse(path.read_text())):
                if isinstance(node, (ast.Import, ast.ImportFrom)):
                    known |= {(a.asname or a.name).split(".")[0] for a in node.names}
                elif isinstance(node, (ast.FunctionDef, ast.ClassDef)):
                    known.add(node.name)
                found = [getattr(node, "annotation", None), getattr(node, "returns", None)]
                used |= {x.id for a in found if a is not None for x in ast.walk(a)
                         if isinstance(x, ast.Name)}
            with self.subTest(path.name):
                self.assertEqual(used - known, set())

    def test_no_class_hides_a_name_of_another(self):
        """A surface has many bases: a helper of one must not take the place of another's."""
        classes = [intrinsic.Surface]
        for c in classes:
            classes += c.__subclasses__()
            first = {}
            for base in c.__mro__[:-1]:
                for name in vars(base):
                    if not name.startswith("__"):
                        with self.subTest(c.__name__, name=name):
                            self.assertIs(first.setdefault(name, base), base)


if __name__ == "__main__":
    unittest.main()
