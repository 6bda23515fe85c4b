# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How much time do ten tasks on distances and curves take in Python, and in the program intrinsic?

    PYTHONPATH=build/release/python distance_tasks.py MESH.off PROGRAM > table.md

Times are the least of three runs, with all that is built for the task; those of the program are of
its steps, without files. `side_by_side.py` compares with other packages.
"""

import json
import subprocess
import sys
import time

import numpy as np

import intrinsic as it

# task, statements, and what the program does: command, options, steps that count
TASKS = [
    ("exact distances from a vertex", "s.distance(a)",
     ("distance", "--method exact --source {a}", "build delaunay solve")),
    ("distances by heat from a vertex", "s.distance(a, method='heat')",
     ("distance", "--method heat --source {a}", "build delaunay solve")),
    ("distances by heat from 20 vertices, each", "s.distances(many, method='heat')", None),
    ("distance of two vertices", "s.distance(a, targets=b)",
     ("distance", "--method exact --source {a} --targets {b}", "build delaunay solve")),
    ("shortest path", "s.path(a, b).points",
     ("geodesic", "--path {a},{b}", "build paths shorten")),
    ("geodesic path by flips", "s.path(a, b, method='flips').points",
     ("geodesic", "--path {a},{b} --method flips", "build paths shorten")),
    ("closed geodesic", "s.loop([a, b, c], method='flips').points",
     ("geodesic", "--loop {a},{b},{c} --method flips", "build paths shorten")),
    ("geodesic in a direction", "s.trace(a, [1, 2, 3], far).points", None),
    ("cells of 20 vertices, and their boundaries", "s.voronoi(many)", None),
    ("pieces between ten lines of equal distance", "s.cut(s.isolines(s.distance(a), 10))",
     ("cut", "--levels 10 --source {a}", "build curves cut")),
]


def read(path):
    with open(path) as file:
        words = file.read().split()
    n, m = int(words[1]), int(words[2])
    V = np.array(words[4:4 + 3 * n], dtype=float).reshape(n, 3)
    return V, np.array(words[4 + 3 * n:4 + 3 * n + 4 * m], dtype=int).reshape(m, 4)[:, 1:]


def seconds(run):
    times = []
    for _ in range(3):
        begin = time.perf_counter()
        run()
        times.append(time.perf_counter() - begin)
    return min(times)


def of_program(program, path, names, command, options, steps):
    run = [program, command, path, *options.format(**names).split(), "--stats", "-"]
    found = [json.loads(subprocess.run(run, check=True, capture_output=True).stdout)["seconds"]
             for _ in range(3)]
    return min(sum(s[step] for step in steps.split()) for s in found)


def main(path, program):
    V, F = read(path)
    n = len(V)
    names = {"it": it, "V": V, "F": F, "a": 0, "b": n // 2, "c": n // 3,
             "many": list(range(0, n, -(-n // 20))), "far": np.ptp(V, axis=0).max()}
    print("| task | seconds | program |\n|---|---|---|")
    for task, code, steps in TASKS:
        ours = seconds(lambda: exec("s = it.Surface(V, F)\n" + code, names))
        theirs = f"{of_program(program, path, names, *steps):.4f}" if steps else "-"
        print(f"| {task} | {ours:.4f} | {theirs} |", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
