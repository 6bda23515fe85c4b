# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The files that a collection has, each with the hash of its contents."""

import glob
import hashlib
import json
import os
import re
from pathlib import Path

from failure import Failure

EXTENSIONS = {".off", ".obj", ".ply", ".stl", ".ts", ".xyz", ".pwn", ".idt"}


def is_generated(word):
    """Tells whether a word names meshes that `intrinsic study` makes itself."""
    return word == "stress" or word.startswith("stress:")


def _files_of(word):
    """Paths that a word stands for: a file, the meshes of a directory, or a pattern."""
    path = Path(word)
    if path.is_dir():
        found = [str(p) for p in sorted(path.iterdir())
                 if p.suffix.lower() in EXTENSIONS and p.is_file()]
    else:
        found = [word] if path.is_file() else sorted(glob.glob(word, recursive=True))
    if not found:
        raise Failure(f"{word}: there is no such file, and no mesh in such a directory; correct "
                      "`files`")
    return found


def _lines_of(path):
    """Pairs of a path and a hash from a file that `sha256sum` has written."""
    for number, line in enumerate(Path(path).read_text(encoding="utf-8").splitlines(), 1):
        found = re.fullmatch(r"([0-9a-f]{64}) [ *](.+)", line)
        if not found:
            raise Failure(f"{path}: line {number} is not one of sha256sum; write it again")
        yield found[2], found[1]


class Hashes:
    """Hashes of files by their size and time of change, kept in a file: only what is new is read.
    """

    def __init__(self, path):
        self._path = Path(path)
        self._known = json.loads(self._path.read_text("utf-8")) if self._path.exists() else {}
        self._used = {}

    def of(self, path):
        status = os.stat(path)
        known = self._known.get(path)
        if known is None or known[:2] != [status.st_size, status.st_mtime_ns]:
            with open(path, "rb") as file:
                digest = hashlib.file_digest(file, "sha256").hexdigest()
            known = [status.st_size, status.st_mtime_ns, digest]
        self._used[path] = known
        return known[2]

    def keep(self):
        """Writes the file, unless it is what it was."""
        if self._used != self._known:
            self._path.parent.mkdir(parents=True, exist_ok=True)
            part = self._path.with_suffix(".part")
            part.write_text(json.dumps(self._used), encoding="utf-8")
            part.replace(self._path)


def hashed_files(words, hashes):
    """Returns pairs of a path and a hash for what words stand for."""
    found = []
    for word in words:
        if is_generated(word):
            found.append((word, hashlib.sha256(word.encode()).hexdigest()))
        elif word.endswith(".sha256"):
            found += _lines_of(word)
        else:
            found += [(path, hashes.of(path)) for path in _files_of(word)]
    return found


def named_files(pairs):
    """Returns paths and hashes by a name that is good for files. Files of the same name with the
    same contents are one."""
    named = {}
    for path, digest in pairs:
        word = path if is_generated(path) else os.path.basename(path)
        named.setdefault(re.sub(r"[^A-Za-z0-9.+-]", "_", word) + "." + digest[:16], (path, digest))
    return named
