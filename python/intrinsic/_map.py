# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A function on many files."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from . import _arrays
from ._arguments import suggesting

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from concurrent.futures import Future
    from ._types import Executor, Item, Progress, Result


class Failure(NamedTuple):
    """What `map()` has in place of a result where the function raised an error: the `item`, the
    `error`, and the `traceback` as text."""

    item: Any
    error: BaseException
    traceback: str

    def __repr__(self) -> str:
        return f"<intrinsic.Failure: {self.item!r}: {type(self.error).__name__}: {self.error}>"


def _failure(item, error):
    import traceback

    return Failure(item, error, "".join(traceback.format_exception(
        type(error), error, error.__traceback__)))


def _result_of(item, ask):
    try:
        return ask()
    except Exception as error:  # KeyboardInterrupt ends all of it
        return _failure(item, error)


@suggesting
def map(function: Callable[[Item], Result], files: Iterable[Item], *,
        executor: Executor | None = None,
        progress: Progress = None) -> list[Result | Failure]:
    """Calls a function with each of many files, or other things, and returns the results in their
    order; a `Failure` where it raised an error.

    Parameters:
        function: called with one of `files`; it reads the file, and returns what is wanted of it.
            Processes must be able to import it.
        files: paths, or anything else.
        executor: any executor of `concurrent.futures`, such as a `ProcessPoolExecutor`, or that of
            a cluster, such as Dask's `Client.get_executor()`. By default one call follows the other
            here.
        progress: called after each with "map", how many are done, and how many there are. What it
            raises ends the work, as Ctrl-C does.

    >>> it.map(lambda n: 6 // n, [1, 0, 2])
    [6, <intrinsic.Failure: 0: ZeroDivisionError: integer division or modulo by zero>, 3]
    """
    items = _arrays.sequence(files, "files", "a list")
    if executor is None:
        return _here(function, items, progress)
    futures: list[Future[Result]] = []
    try:
        for item in items:
            futures.append(_submitted(executor, function, item))
        return _collected(futures, items, progress)
    except BaseException:
        for future in futures:
            future.cancel()
        raise


def _submitted(executor, function, item):
    from concurrent.futures import BrokenExecutor, Future

    try:
        return executor.submit(function, item)
    except BrokenExecutor as error:  # a process has died
        future = Future()
        future.set_exception(error)
        return future


def _here(function, items, progress):
    results = []
    for item in items:
        results.append(_result_of(item, lambda: function(item)))
        if progress is not None:
            progress("map", len(results), len(items))
    return results


def _collected(futures, items, progress):
    from concurrent.futures import as_completed

    if progress is not None:
        for done, _ in enumerate(as_completed(futures), 1):
            progress("map", done, len(items))
    return [_result_of(item, future.result) for item, future in zip(items, futures)]
