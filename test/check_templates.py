#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that public templates say in their heads what they ask for.

Reads all headers and lists the documented templates outside of classes and of namespaces `internal`
that have a type parameter without a concept: `class T`, where no requires-clause names `T`. A
parameter that is documented as "any type" needs none. Fails for a template that is not in ALLOWED,
where each has a reason, and for one in ALLOWED that is not needed any more.
"""

import pathlib
import re

import run_check


# Templates that cannot have a concept, and why. A concept asks for a complete class, once and for all:
# one that is checked too early stays false.
ALLOWED = {
    "Indexed_mesh_adaptor: Mesh": "the concepts of meshes are defined by way of adaptors; users derive"
                                  " specialisations from it, before the functions of their mesh if they like",
    "Intrinsic_view: Triangulation": "its argument, which is not complete yet, may have it as a member",
    "Mesh_adaptor: Mesh": "MutableDeltaComplex is defined by it; a specialisation of users would have to"
                          " repeat the concept",
    "Metric_values: Triangulation": "it is a base class of its argument, which is not complete yet",
    "Move_session: Triangulation": "its argument, which is not complete yet, has it as a member type",
    "Predicate_session: Triangulation": "its argument, which is not complete yet, has it as a member type",
}


def closing(text, start, pair):
    """Returns the place after the bracket that closes the one at `start`."""
    depth = 0
    for place in range(start, len(text)):
        depth += {pair[0]: 1, pair[1]: -1}.get(text[place], 0)
        if depth == 0:
            return place + 1
    raise ValueError(f"{pair[0]} is not closed")


def split_parameters(text):
    """Splits at commas outside of brackets."""
    parts, depth = [""], 0
    for char in text:
        depth += {"<": 1, "(": 1, ">": -1, ")": -1}.get(char, 0)
        if char == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += char
    return [part.strip() for part in parts]


def without_comments(text):
    """Blanks comments and strings, so that places stay; returns that and the ends of doc comments."""
    docs = {}

    def blank(match):
        if match[0].startswith(("/*!", "///")):
            docs[match.end()] = match[0]
        return re.sub(r"[^\n]", " ", match[0])

    pattern = r'/\*.*?\*/|//[^\n]*|"(?:[^"\\\n]|\\.)*"|^#(?:[^\n]*\\\n)*[^\n]*'
    return re.sub(pattern, blank, text, flags=re.DOTALL | re.MULTILINE), docs


def scopes(text):
    """Yields place and brace: the names of the scopes around each template at namespace scope."""
    stack, last = [], 0
    for match in re.finditer(r"[{};]|\btemplate\s*<", text):
        if match[0] == "{":
            head = text[last:match.start()].strip()
            name = re.fullmatch(r"(?:inline )?namespace ([\w:]*)", head)
            stack.append(name[1] if name else None)
        elif match[0] == "}":
            stack.pop()
        elif match[0].startswith("template") and None not in stack:
            yield match.start(), "::".join(stack)
        if match[0] in "{};":
            last = match.end()


def doc_before(docs, text, place):
    """Returns the doc comment that ends before a place, with nothing in between."""
    ends = [end for end in docs if end <= place and not text[end:place].strip()]
    if not ends:
        return None
    end = max(ends)
    earlier = doc_before({e: d for e, d in docs.items() if e < end}, text, end - len(docs[end]))
    return (earlier or "") + docs[end]


def end_of_declaration(text, place):
    """Returns the place of the body or semicolon of a declaration; requires-expressions have braces, too."""
    begin = place
    while text[place] != ";":
        if text[place] == "(":
            place = closing(text, place, "()")
        elif text[place] != "{":
            place += 1
        elif re.search(r"\brequires\s*(\((?:[^()]|\([^()]*\))*\))?\s*$", text[begin:place]):
            place = closing(text, place, "{}")
        else:
            break
    return place


def declared(text, place):
    """Returns the parameters of a template, its declaration up to body or semicolon, and its name."""
    begin = text.index("<", place)
    end = closing(text, begin, "<>")
    declaration = text[end:end_of_declaration(text, end)]
    name = re.search(r"(?:class|struct)\s+(\w+)|([\w~]+|operator\S+)\s*(?=\(|=)",
                     re.sub(r"requires\s*\((?:[^()]|\([^()]*\))*\)", " ", declaration))
    return (text[begin + 1:end - 1], declaration,
            next(filter(None, name.groups()), "?") if name else "?")


def unconstrained(text):
    """Yields the names of documented free templates with a parameter without a concept."""
    code, docs = without_comments(text)
    for place, scope in scopes(code):
        doc = doc_before(docs, code, place)
        if doc is None or "internal" in scope or "\\cond" in doc:
            continue
        parameters, declaration, name = declared(code, place)
        if re.match(r"\s*concept\b", declaration):
            continue
        requires = declaration.partition("requires")[2]
        is_specialisation = re.match(r"[^({]*\b(?:class|struct)\s+\w+\s*<", declaration)
        for parameter in split_parameters(parameters):
            bare = re.match(r"(?:class|typename)\b\s*(?:\.\.\.)?\s*(\w+)", parameter)
            if not bare or is_specialisation or re.search(rf"\b{bare[1]}\b", requires):
                continue
            if not re.search(rf"\\tparam {bare[1]} any type", doc):
                yield f"{name}: {bare[1]}"


def check(include):
    """Yields all that is wrong with the headers below the directory `include`."""
    found = {}
    for path in sorted(include.rglob("*.h")):
        for name in sorted(set(unconstrained(path.read_text()))):
            found[name] = path.relative_to(include).as_posix()
    for name in found:
        if name not in ALLOWED:
            yield f"{found[name]}: {name} needs a concept"
    for name in sorted(set(ALLOWED) - set(found)):
        yield f"check_templates.py allows {name}, which is not needed any more: remove it"


if __name__ == "__main__":
    run_check.run(check, __doc__)
