# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares isometries of equilateral triangles that are glued at random with nauty's automorphisms
and canonical labels of the coloured graph of flags: darts in both orientations.

Usage: isometries_by_nauty.py [GLUINGS [SEED]]. It needs the program dreadnaut, of nauty.
"""

import re
import shutil
import subprocess
import sys

import numpy as np

import intrinsic as it


def random_gluing(faces, random, folds):
    """A connected gluing of triangles whose vertices are not flat. `folds` copies of one gluing are
    joined in a ring, which has symmetries."""
    while True:
        sides = random.permutation(3 * faces)
        glue = np.empty(3 * faces, int)
        glue[sides[::2]], glue[sides[1::2]] = sides[1::2], sides[::2]
        if folds > 1:  # shift the copy across one pair of sides
            copies = np.arange(folds)[:, None] * 3 * faces
            a, b = sides[:2]
            glue = glue + copies
            glue[:, a] = np.roll(b + copies[:, 0], -1)
            glue[:, b] = np.roll(a + copies[:, 0], 1)
            glue = glue.ravel()
        if is_connected(glue) and 6 not in degrees(glue):
            return glue


def after(h):
    return h - h % 3 + (h + 1) % 3


def is_connected(glue):
    seen, stack = {0}, [0]
    while stack:
        h = stack.pop()
        for g in (after(h), glue[h]):
            if g not in seen:
                seen.add(g)
                stack.append(g)
    return len(seen) == len(glue)


def degrees(glue):
    left, result = set(range(len(glue))), []
    while left:
        h = first = next(iter(left))
        count = 0
        while True:
            left.discard(h)
            count += 1
            h = after(glue[h])
            if h == first:
                break
        result.append(count)
    return result


def surface(glue):
    faces = len(glue) // 3
    pairs = np.stack([glue // 3, glue % 3], axis=1).reshape(faces, 3, 2)
    vertices = np.zeros(len(glue), int)
    number = 0
    for h in range(len(glue)):
        if vertices[h]:
            continue
        number += 1
        while not vertices[h]:
            vertices[h] = number
            h = after(glue[h])
    return it.Surface(number, (vertices - 1).reshape(faces, 3), lengths=np.ones((faces, 3)),
                      glue=pairs)


def dreadnaut(glue):
    """The size of the group, and the canonical graph. Flag 2 h + m is the side h, read backwards if
    m. A path of three vertices stands for each flag: one for each kind of neighbour."""
    n = 2 * len(glue)
    before = {after(h): h for h in range(len(glue))}
    edges = []
    for h in range(len(glue)):
        for m in 0, 1:
            flag = 2 * h + m
            edges += [(flag, n + flag), (n + flag, 2 * n + flag)]
            edges.append((flag, 2 * h + 1 - m))  # the other end
            edges.append((n + flag, n + 2 * glue[h] + 1 - m))  # the face across
            turned = 2 * (before[h] if m == 0 else after(h)) + 1 - m  # the other side at the end
            edges.append((2 * n + flag, 2 * n + turned))
    lists = {}
    for a, b in edges:
        if a != b:
            lists.setdefault(min(a, b), set()).add(max(a, b))
    text = ";".join(f"{a}:{' '.join(map(str, sorted(b)))}" for a, b in lists.items())
    script = f"n={3 * n} g {text}. f=[0:{n - 1}|{n}:{2 * n - 1}|{2 * n}:{3 * n - 1}] c x z q\n"
    out = subprocess.run(["dreadnaut"], input=script, capture_output=True, text=True,
                         check=True).stdout
    size = re.search(r"grpsize=([0-9.e+]+)", out)
    return int(float(size[1])), re.search(r"\[\w+ \w+ \w+\]", out)[0]


def main():
    if shutil.which("dreadnaut") is None:
        sys.exit("dreadnaut is missing; install nauty")
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 200
    random = np.random.default_rng(int(sys.argv[2]) if len(sys.argv) > 2 else 1)
    symmetric, known = 0, []
    for k in range(count):
        faces, folds = int(random.choice([2, 4, 6])), int(random.integers(1, 4))
        glue = random_gluing(faces, random, folds)
        s, (size, label) = surface(glue), dreadnaut(glue)
        found = s.isometries()
        assert found.answer == "isometric" and len(found) == size, (glue, size, found)
        symmetric += size > 1
        for other, its_glue, its_label in known[-20:]:
            same = len(its_glue) == len(glue) and its_label == label
            answer = s.isometries(other).answer
            assert (answer == "isometric") == same, (glue, its_glue, answer)
            assert same or answer == "not_isometric", answer
        known.append((s, glue, label))
    print(f"{count} gluings agree with nauty, {symmetric} of them with symmetries")


if __name__ == "__main__":
    main()
