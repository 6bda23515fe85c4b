# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How much longer do methods of the module take than the same calls in C++?

    PYTHONPATH=build/release/python python_calls.py MESH.off build/.../python_calls [REPETITIONS]

Writes a table. `python_calls.cpp` makes the same calls in C++. Times are the least of processor
times in milliseconds: each call on a surface that is new, but for what is named before it, and
where something is kept from call to call, again with another vertex.
"""

import json
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
    ("path", "", "s.path(a, b)"),
    ("path by flips", "", "s.path(a, b, method='flips')"),
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


def main(path, program, repetitions="5"):
    V, F = read(path)
    there = json.loads(subprocess.run([program, path, repetitions], check=True,
                                      capture_output=True).stdout)
    print("| call | C++, ms | Python, ms | ratio |\n|---|---|---|---|")
    for name, before, call in CALLS:
        pairs = [measure(before, call, V, F) for _ in range(int(repetitions))]
        for label, times in (name, [p[0] for p in pairs]), ("again: " + name,
                                                            [p[1] for p in pairs]):
            if label in there:
                print(f"| {label} | {there[label]:.2f} | {min(times):.2f} | "
                      f"{min(times) / there[label]:.2f} |", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
