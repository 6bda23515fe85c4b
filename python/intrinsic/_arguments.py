# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Unknown arguments: errors name the nearest one that exists."""

from __future__ import annotations

import functools
import inspect
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterable
    from ._types import Function


def nearest(word: str, words: Iterable[str]) -> str | None:
    """Returns the word that is most like another one, if any is."""
    import difflib

    return next(iter(difflib.get_close_matches(word, list(words), 1)), None)


def suggesting(function: Function) -> Function:
    """Returns a function whose errors about unknown arguments name the nearest argument."""
    names = [p.name for p in inspect.signature(function).parameters.values()
             if p.kind is not p.VAR_POSITIONAL and p.name != "self"]
    known = frozenset(names)

    @functools.wraps(function)
    def call(*args: Any, **options: Any) -> Any:
        if not known.issuperset(options):
            unknown = next(name for name in options if name not in known)
            found = nearest(unknown, names)
            remedy = f"did you mean {found}?" if found else f"give some of {', '.join(names)}"
            who = function.__qualname__.rsplit(".", 2)
            name = who[0] if who[-1] == "__init__" else who[-1]
            raise TypeError(f"{name}() has no argument {unknown}; {remedy}")
        return function(*args, **options)

    return call  # type: ignore[return-value]


def suggest(kind: type) -> None:
    """Makes all public methods of a class, and of its bases, such functions."""
    for base in kind.__mro__[:-1]:
        for name, method in list(vars(base).items()):
            if inspect.isfunction(method) and (name == "__init__" or not name.startswith("_")):
                setattr(base, name, suggesting(method))
