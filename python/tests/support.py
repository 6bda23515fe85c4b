# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the module share: meshes as arrays, a folder for files, threads, a measure of
memory."""

import gc
import os
import tempfile
import threading
import tracemalloc
import unittest
from pathlib import Path

import numpy as np

PART = Path(__file__).resolve().parents[2] / "examples" / "data" / "part.off"
SQUARE = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]]
CUBE = ([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)],
        [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6],
         [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])
TETRAHEDRON = ([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]],
               [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]])
BOOK = ([[0, 0, 0], [0, 0, 1], [1, 0, 0], [-1, 1, 0], [-1, -1, 0]],  # three pages: not manifold
        [[0, 1, 2], [0, 1, 3], [0, 1, 4]])


def without_times(statistics):
    """All that is the same in every run; steps of the ladder have their times, too."""
    if not isinstance(statistics, dict):
        return statistics
    return {key: without_times(value) for key, value in statistics.items()
            if key not in ("seconds", "peak_rss_mib")}


def grid(n=9):
    """A square of n by n vertices with a distance of 1."""
    y, x = np.divmod(np.arange(n * n), n)
    V = np.column_stack([x, y, 0 * x]).astype(float)
    i = np.arange(n * n).reshape(n, n)[:-1, :-1].ravel()
    F = np.column_stack([i, i + 1, i + n + 1, i, i + n + 1, i + n]).reshape(-1, 3)
    return V, F


def unit_grid(n):
    """A unit square of n by n squares, which are all divided along the same diagonal."""
    x, y = np.meshgrid(np.arange(n + 1) / n, np.arange(n + 1) / n, indexing="ij")
    V = np.column_stack([x.ravel(), y.ravel(), 0 * x.ravel()])
    corner = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    a, b, c, d = corner, corner + n + 1, corner + n + 2, corner + 1
    return V, np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


def bumpy(n=12, seed=1):
    """Vertices and triangles of a height field with random places and slivers."""
    random = np.random.default_rng(seed)
    x, y = np.meshgrid(np.arange(n, dtype=float), np.arange(n, dtype=float))
    V = np.column_stack([x.ravel(), 0.2 * y.ravel(), np.zeros(n * n)])
    V += random.uniform(-0.3, 0.3, V.shape) * [1, 0.2, 1]
    i = np.arange(n * n).reshape(n, n)
    a, b, c, d = i[:-1, :-1].ravel(), i[:-1, 1:].ravel(), i[1:, 1:].ravel(), i[1:, :-1].ravel()
    return V, np.vstack([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


class With_folder(unittest.TestCase):
    """Has a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)


def failures_of_threads(work, count, seconds=None):
    """Calls `work(k)` in so many threads at once. Returns what it raised, and the threads that have
    not ended after the time."""
    failures = []

    def attempt(k):
        try:
            work(k)
        except Exception as error:
            failures.append(repr(error))

    threads = [threading.Thread(target=attempt, args=(k,)) for k in range(count)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(seconds)
    return failures + [thread.name for thread in threads if thread.is_alive()]


def has_sanitizer():
    """Whether memory is checked by AddressSanitizer, which keeps what is freed for a while."""
    return "asan" in os.environ.get("LD_PRELOAD", "")


def grown_memory(work, rounds, before=1):
    """The bytes that Python holds more after a function was called so often, and before that."""
    for _ in range(before):
        work()
    tracemalloc.start()
    try:
        gc.collect()  # what refers to itself
        first = tracemalloc.take_snapshot()
        for _ in range(rounds):
            work()
        gc.collect()
        last = tracemalloc.take_snapshot()
    finally:
        tracemalloc.stop()
    return sum(d.size_diff for d in last.compare_to(first, "filename"))
