# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Unknown arguments: errors name the nearest one that exists."""

from __future__ import annotations

import functools
import inspect
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping
    from ._types import Function


def nearest(word: str, words: Iterable[str], likeness: float = 0.6) -> str | None:
    """Returns the word that is most like another one, if any is: `likeness` is 1 if all letters
    are, in their order."""
    import difflib

    return next(iter(difflib.get_close_matches(word, list(words), 1, likeness)), None)


def _remedy(unknown: str, known: list[str], owners: Mapping[str, list[str]]) -> str:
    """Returns what to do about an unknown argument: other functions may have it."""
    others = owners.get(unknown, [])
    is_of_others = 0 < len(others) < 4  # more would be no answer
    found = nearest(unknown, known, 0.8 if is_of_others else 0.6)
    if is_of_others and not found:
        return f"{' and '.join(f'{o}()' for o in others)} {'have' if others[1:] else 'has'} it"
    return f"did you mean {found}?" if found else f"give some of {', '.join(known)}"


def suggesting(function: Function, owners: Mapping[str, list[str]] | None = None) -> Function:
    """Returns a function whose errors about unknown arguments name the nearest argument, or others
    that have it, whose names `owners` has for each argument."""
    names = [p.name for p in inspect.signature(function).parameters.values()
             if p.kind is not p.VAR_POSITIONAL and p.name != "self"]
    known = frozenset(names)

    @functools.wraps(function)
    def call(*args: Any, **options: Any) -> Any:
        if not known.issuperset(options):
            unknown = next(name for name in options if name not in known)
            who = function.__qualname__.rsplit(".", 2)
            name = who[0] if who[-1] == "__init__" else who[-1]
            raise TypeError(f"{name}() has no argument {unknown}; "
                            f"{_remedy(unknown, names, owners or {})}")
        return function(*args, **options)

    return call  # type: ignore[return-value]


def suggest(kind: type) -> None:
    """Makes all public methods of a class, and of its bases, such functions."""
    found = [(base, name, method) for base in kind.__mro__[:-1]
             for name, method in vars(base).items()
             if inspect.isfunction(method) and (name == "__init__" or not name.startswith("_"))]
    owners: dict[str, list[str]] = {}
    for _, name, method in found:
        for parameter in inspect.signature(method).parameters:
            owners.setdefault(parameter, []).append(kind.__name__ if name == "__init__" else name)
    for base, name, method in found:
        setattr(base, name, suggesting(method, owners))
