# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A function on many files: order, failures, progress; on threads, processes and a cluster."""

import importlib.util
import os
import tempfile
import threading
import time
import unittest
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor

import intrinsic as it
from support import unit_grid


def area(path):
    return float(it.read(path).mass().sum())


def late_if_first(n):
    if n == 0:
        time.sleep(0.2)
    return 6 // n if n != 3 else {}["a"]


def dies_at_two(n):
    if n == 2:
        os._exit(7)
    return n


class Map(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        V, F = unit_grid(3)
        self.files = []
        for k in range(1, 4):
            self.files.append(os.path.join(directory.name, f"{k}.idt"))
            it.Surface(k * V, F).save(self.files[-1])
        self.files.insert(1, os.path.join(directory.name, "none.off"))

    def check(self, executor):
        seen = []
        found = it.map(area, self.files, executor=executor, progress=lambda *a: seen.append(a))
        self.assertEqual(seen, [("map", k, 4) for k in range(1, 5)])
        self.assertIsInstance(found[1], it.Failure)
        self.assertEqual(found[1].item, self.files[1])
        self.assertIsInstance(found[1].error, FileNotFoundError)
        self.assertIn("in area", found[1].traceback)
        for k, x in zip((1, 2, 3), found[:1] + found[2:]):
            self.assertAlmostEqual(x, k * k)

    def test_here(self):
        self.check(None)

    def test_threads(self):
        with ThreadPoolExecutor(2) as pool:
            self.check(pool)
            found = it.map(late_if_first, range(4), executor=pool)
        self.assertEqual([type(x.error) if isinstance(x, it.Failure) else x for x in found],
                         [ZeroDivisionError, 6, 3, KeyError])
        self.assertEqual(repr(found[3]), "<intrinsic.Failure: 3: KeyError: 'a'>")

    def test_processes_that_may_die(self):
        with ProcessPoolExecutor(1) as pool:
            self.check(pool)
            found = it.map(dies_at_two, [1, 2, 3], executor=pool)
            self.assertIsInstance(found[1], it.Failure)
            self.assertIsInstance(it.map(dies_at_two, [1], executor=pool)[0], it.Failure)

    def test_what_progress_raises_cancels_the_rest(self):
        begun, go = [], threading.Event()

        def slow(n):
            begun.append(n)
            if n > 0:
                go.wait()

        def stop(what, done, total):
            raise InterruptedError(what)
        with ThreadPoolExecutor(1) as pool:
            with self.assertRaises(InterruptedError):
                it.map(slow, range(100), executor=pool, progress=stop)
            go.set()
        self.assertLess(len(begun), 4)
        with self.assertRaises(InterruptedError):
            it.map(len, [""], progress=stop)

    @unittest.skipUnless(importlib.util.find_spec("distributed"), "Dask is not installed")
    def test_cluster_of_dask(self):
        from distributed import Client, LocalCluster

        with LocalCluster(n_workers=1, threads_per_worker=1, processes=True, dashboard_address=None,
                          silence_logs=50) as cluster, Client(cluster) as client:
            self.check(client.get_executor())


if __name__ == "__main__":
    unittest.main()
