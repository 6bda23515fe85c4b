#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the reference of the Python module as pages for doxygen, from its docstrings.

    python_pages.py MODULE PICTURES FOLDER

Each function of the module and each method of `Surface` gets a page, other classes one for all their
members. The picture `py_NAME.png` in PICTURES stands on the page of the function NAME.
"""

import argparse
import ast
import pathlib
import re
import textwrap

TITLE = "Python: "


def parsed(module):
    """The classes and functions of all files, by name."""
    names = {}
    for file in sorted(module.glob("*.py")):
        for node in ast.parse(file.read_text(encoding="utf-8")).body:
            if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
                names.setdefault(node.name, node)
    return names


def exported(module):
    """The classes and functions that `__init__.py` imports, by name."""
    found = {}
    tree = ast.parse((module / "__init__.py").read_text(encoding="utf-8"))
    for line in tree.body:
        file = module / f"{line.module}.py" if isinstance(line, ast.ImportFrom) else None
        if file and file.exists():
            names = {alias.name for alias in line.names}
            for node in ast.parse(file.read_text(encoding="utf-8")).body:
                if getattr(node, "name", None) in names:
                    found[node.name] = node
    return found


def members(cls, classes):
    """The public functions and properties of a class and of its bases without a name of their own."""
    found = {}
    for base in cls.bases:
        if isinstance(base, ast.Name) and base.id.startswith("_") and base.id in classes:
            found.update(members(classes[base.id], classes))
    for node in cls.body:
        if isinstance(node, ast.FunctionDef) and not node.name.startswith("_"):
            found[node.name] = node
    return found


def fields(cls, classes):
    """The annotated fields of a class and of its bases without a name of their own."""
    found = []
    for base in cls.bases:
        if isinstance(base, ast.Name) and base.id.startswith("_") and base.id in classes:
            found += fields(classes[base.id], classes)
    return found + [ast.unparse(n) for n in cls.body if isinstance(n, ast.AnnAssign)]


def is_property(node):
    return any(isinstance(d, ast.Name) and d.id == "property" for d in node.decorator_list)


def signature(node):
    """How a function is called, an argument per line if they need more than one."""
    args = node.args
    own = [a for a in args.args if a.arg not in ("self", "cls")]
    defaults = [None] * (len(own) - len(args.defaults)) + args.defaults
    parts = list(zip(own, defaults))
    texts = [text_of(*part) for part in parts]
    if args.vararg:
        texts.append("*" + args.vararg.arg)
    elif args.kwonlyargs:
        texts.append("*")
    texts += [text_of(*part) for part in zip(args.kwonlyargs, args.kw_defaults)]
    result = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    if is_property(node):
        return node.name + result.replace(" ->", ":")
    line = f"{node.name}({', '.join(texts)}){result}"
    if len(line) <= 80:
        return line
    return f"{node.name}(\n    " + ",\n    ".join(texts) + f"\n){result}"


def text_of(arg, default):
    annotation = f": {ast.unparse(arg.annotation)}" if arg.annotation else ""
    equals = " = " if annotation else "="
    return arg.arg + annotation + (equals + ast.unparse(default) if default else "")


def code(text):
    return f"```py\n{text}\n```\n"


def paragraph(text):
    """Examples become code, and what is listed below a word and a colon a list."""
    if text.startswith(">>>"):
        return code(text)
    if not re.match(r"\w+:\n ", text):
        return text + "\n"
    head, _, rest = text.partition("\n")
    items = re.split(r"\n(?=\S)", textwrap.dedent(rest))
    items = [re.sub(r"^(\w+):", r"`\1`:", " ".join(item.split())) for item in items]
    return f"**{head[:-1]}**\n\n" + "".join(f"- {item}\n" for item in items)


def body(node):
    """A docstring."""
    return "\n".join(paragraph(p) for p in (ast.get_docstring(node) or "").split("\n\n"))


def brief(node):
    return " ".join((ast.get_docstring(node) or "").split("\n\n")[0].split())


class Writer:
    def __init__(self, pictures, folder):
        self.pictures, self.folder, self.rows = pictures, folder, []

    def page(self, title, label, text, node):
        head = f"# {TITLE}{title}\n<a id=\"{label}\"></a>\n\n"
        (self.folder / f"{label}.md").write_text(head + text, encoding="utf-8")
        self.rows.append(f"| \\subpage {label} \"{title}\" | {brief(node)} |")

    def function(self, node, owner=""):
        pictures = [] if is_property(node) else sorted(self.pictures.glob(f"py_{node.name}.*"))
        picture = "".join(f"![]({file.name})\n\n" for file in pictures)
        call = owner + signature(node)
        suffix = "" if is_property(node) else "()"
        label = f"py_{owner.rstrip('.').lower()}_{node.name}"
        self.page(node.name + suffix, label, code(call) + "\n" + picture + body(node), node)

    def cls(self, node, classes):
        parts = [body(node)]
        if own := fields(node, classes):
            parts.append(code("\n".join(own)))
        for member in members(node, classes).values():
            parts.append(f"## {member.name}\n\n{code(signature(member))}\n{body(member)}")
        self.page(node.name, f"py_class_{node.name.lower()}", "\n".join(parts), node)

    def table(self, title):
        rows, self.rows = self.rows, []
        return f"## {title}\n\n| | |\n|---|---|\n" + "\n".join(rows) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name in ("module", "pictures", "folder"):
        parser.add_argument(name, type=pathlib.Path)
    options = parser.parse_args()
    options.folder.mkdir(exist_ok=True)
    for old in options.folder.glob("*.md"):
        old.unlink()
    names, public = parsed(options.module), exported(options.module)
    writer = Writer(options.pictures, options.folder)
    surface = names["Surface"]
    for name in sorted(public):
        if isinstance(public[name], ast.FunctionDef):
            writer.function(public[name], "intrinsic.")
    tables = [writer.table("Functions of the module")]
    for member in sorted(members(surface, names).values(), key=lambda node: node.name):
        writer.function(member, "Surface.")
    tables.append(writer.table("Members of Surface"))
    classes = {name: node for name, node in names.items() if isinstance(node, ast.ClassDef)
               and not name.startswith("_") and node is not surface and ast.get_docstring(node)}
    for name in sorted(classes):
        writer.cls(classes[name], names)
    tables.append(writer.table("Classes of results"))
    text = "# Python reference\n<a id=\"py_reference\"></a>\n\n" + body(surface) + "\n" + "\n".join(tables)
    (options.folder / "py_reference.md").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
