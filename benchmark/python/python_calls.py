# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How much longer do methods of the module take than the same calls in C++?

    PYTHONPATH=build/release/python python_calls.py MESH.off build/.../python_calls [REPETITIONS]

Writes a table. `python_calls.cpp` makes the same calls in C++. Both take turns; times are the least
of processor times in milliseconds: each call on a surface that is new, but for what is named before
it, and where something is kept from call to call, again with another vertex.

Memory that was freed stays with both processes: else the times are those of page faults, which are
a fifth in the one whose calls before were smaller, and depend on what else it does.
"""

import json
import os
import subprocess
import sys
import time

import intrinsic as it
from distance_tasks import read

# name of the call in C++, what is made before, and the call
CALLS = [
    ("Surface", "", "it.Surface(V, F)"),
    ("delaunay", "", "s.delaunay()"),
    ("refine", "", "s.refine()"),
    ("laplacian", "d = s.delaunay()", "d.laplacian()"),
    ("mass", "d = s.delaunay()", "d.mass()"),
    ("galerkin mass", "d = s.delaunay()", "d.mass('galerkin')"),
    ("statistics", "d = s.delaunay()", "d.statistics"),
    ("distance by heat", "s.laplacian()", "s.distance(a, method='heat')"),
    ("distance", "s.laplacian()", "s.distance(a)"),
    ("path", "s.laplacian()", "s.path(a, b)"),
    ("path by flips", "s.laplacian()", "s.path(a, b, method='flips')"),
    ("transport", "s.laplacian()", "s.transport(a, [1, 0])"),
    ("vectors", "z = s.transport(a, [1, 0])", "z.vectors"),
    ("log_map exact", "s.laplacian()", "s.log_map(a)"),
    ("log_map affine", "s.laplacian()", "s.log_map(a, method='affine')"),
    ("log_map polar", "s.laplacian()", "s.log_map(a, method='polar')"),
    ("direction_field", "s.laplacian()", "s.direction_field(4)"),
]


def milliseconds(code, names):
    begin = time.process_time()
    exec(code, names)
    return 1e3 * (time.process_time() - begin)


def measure(before, call, V, F):
    """Returns the times of a call, and of the same again with another vertex."""
    names = {"it": it, "V": V, "F": F, "a": 0, "b": len(V) // 2, "s": it.Surface(V, F)}
    exec(before, names)
    first = compile("first = " + call, "first", "exec")  # which is not destroyed in the time
    again = compile("again = " + call, "again", "exec")
    time_of_first = milliseconds(first, names)
    names["a"] = len(V) // 3
    return time_of_first, milliseconds(again, names)


# What the allocator of glibc reads when a process starts, in bytes; 32 MiB are the most.
KEPT_MEMORY = {"MALLOC_TRIM_THRESHOLD_": str(2**40), "MALLOC_MMAP_THRESHOLD_": str(2**25)}


def main(path, program, repetitions="5"):
    if not KEPT_MEMORY.items() <= os.environ.items():
        os.environ.update(KEPT_MEMORY)
        os.execv(sys.executable, [sys.executable, *sys.argv])
    V, F = read(path)
    there, here = {}, {}
    for _ in range(int(repetitions)):
        # twice, since the first time is that of memory which was never used
        run = subprocess.run([program, path, "2"], check=True, capture_output=True)
        for name, t in json.loads(run.stdout).items():
            there[name] = min(t, there.get(name, t))
        for name, before, call in CALLS:
            for label, t in zip((name, "again: " + name), measure(before, call, V, F)):
                here[label] = min(t, here.get(label, t))
    print("| call | C++, ms | Python, ms | ratio |\n|---|---|---|---|")
    for label, t in here.items():
        if label in there:
            print(f"| {label} | {there[label]:.2f} | {t:.2f} | {t / there[label]:.2f} |")


if __name__ == "__main__":
    main(*sys.argv[1:])
