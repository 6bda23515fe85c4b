#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that headers and sources keep to their rooms.

The packages are in the order of PACKAGES, the rooms of each in that of the headings of its README.md, lowest
first. Headers are in `include/`. Sources, and headers that only sources need, are in the folders of the same
rooms in `src/`. Fails, and says where, if

- a file includes one of a higher room or package (so folders cannot form a cycle either),
- headers of one room include each other in a circle,
- a file lies in no room, or a room has no headers,
- a room has more than 15 headers, or a header or source more than 350 lines,
- a line has more than 100 columns,
- an include guard is not the path of its header,
- an own header is included by a path that is not the full one, or that does not exist,
- `CGAL/PACKAGE_sources.h` does not list the sources of its package, sorted,
- a file of the program or of the Python module, in C++ or in Python, has more than 350 lines, or lines of more than
  100 columns,
- a file of the program includes one of a higher folder by the headings of `src/intrinsic/README.md`,
- the Python module includes a header of the program,
- a file of the program or the module names `internal::` of the library,
- a test names something of a namespace `internal`,
- an exception below is not needed any more.
"""

import collections
import pathlib
import posixpath
import re

import run_check

PACKAGES = ["CGAL/Intrinsic_triangulations", "CGAL/Intrinsic_geodesics", "CGAL/Intrinsic_operators",
            "CGAL/Intrinsic_conformal", "CGAL/Intrinsic_simplification"] # lowest first
PROGRAM, MODULE, PYTHON = "src/intrinsic", "python/src", "python/intrinsic"
MOST_HEADERS = 15
MOST_LINES = 350
MOST_COLUMNS = 100

# What is wrong today and why it stays for now. Shrinks only.
# (header, included header of a higher room): reason
ALLOWED_INCLUDES = {}
# file: reason
TO_SPLIT = "to be split where a reader would cut"
ALLOWED_LENGTHS = {
    "Intrinsic_geodesics/cuts/cut_along.cpp": TO_SPLIT,
    "Intrinsic_geodesics/distance/spread_windows.cpp": TO_SPLIT,
    "Intrinsic_triangulations/exact/proofs/field.cpp": TO_SPLIT,
}
# room: reason
ALLOWED_SIZES = {}
# file: reason
ALLOWED_COLUMNS = {}
# test of something internal: why it is tested at its own door
IN_FEW = "rules that only rare surfaces come to through the functions that users call"
ORACLE = "closed forms for one step of an algorithm, whose result would hide an error of it"
HOSTILE = "input that callers do not make, whose handling they rely on"
ALLOWED_INTERNALS = {
    "Intrinsic_conformal/layout/test_turn_back.cpp": IN_FEW,
    "Intrinsic_operators/solvers/test_factorizations.cpp": "that an analysis is shared shows only in time",
    "Intrinsic_operators/solvers/test_multigrid_factorization.cpp": "the automatic choice iterates only from a million rows on",
    "Intrinsic_operators/solvers/test_nested_dissection.cpp": "orders of rows show only in time",
    "Intrinsic_triangulations/support/test_parameters.cpp": "how functions read the named parameters of users",
    "Intrinsic_triangulations/domains/test_Delaunay_star.cpp": ORACLE,
    "Intrinsic_triangulations/input/metric_scaling/test_side_vectors.cpp": HOSTILE,
    "Intrinsic_triangulations/input/test_Polygon_flattener.cpp": HOSTILE,
    "Intrinsic_triangulations/retriangulation/optimization/test_odt_optimize.cpp": ORACLE,
    "Intrinsic_triangulations/retriangulation/refinement/test_Marked_faces.cpp": ORACLE,
    "Intrinsic_triangulations/retriangulation/refinement/test_Surface_check.cpp": HOSTILE,
    "Intrinsic_triangulations/retriangulation/refinement/test_dijkstra_ball.cpp": ORACLE,
    "Intrinsic_triangulations/tracing/test_geodesic_to_target.cpp": ORACLE,
    "Intrinsic_triangulations/tracing/test_trace_geodesic.cpp": IN_FEW,
    "Intrinsic_triangulations/triangulation/test_archetypes.cpp": "what concepts ask for, and no more",
    "support/triangulation_archetypes.h": "what concepts ask for, and no more",
}


def read_rooms(include, package):
    """Returns the rooms of a package in order: for each its folders and the headers beside the package that it names."""
    rooms = []
    for line in (include / package / "README.md").read_text().splitlines():
        if line.startswith("## "):
            names = re.findall(r"`([^`]+)`", line)
            folders = [f"{package}/{name}".rstrip("/") for name in names if name.endswith("/")]
            headers = [f"CGAL/{name}" for name in names if name.endswith(".h")]
            if folders or headers:
                rooms.append((folders, headers))
    return rooms


def room_numbers(rooms):
    """Returns the place in the order of each folder, and of each header beside the folder."""
    places = {}
    for number, (folders, headers) in enumerate(rooms):
        for name in folders + headers:
            if name in places:
                raise ValueError(f"{name} is named twice")
            places[name] = number
    return places


def place_of(file, places):
    """Returns the place of a header or source in the order of rooms, None if it lies in no room."""
    header = file.removesuffix(".cpp") + ".h" if file.endswith(".cpp") else file
    return places.get(header, places.get(file.rpartition("/")[0]))


def short(header):
    return header.removeprefix("CGAL/")


def own_includes(text):
    """Returns what a file includes of this package, and includes in quotes, as they are written.

    What it includes only with or only without the library is a part of it, whatever its room."""
    text = re.sub(r"^#ifn?def \w+_COMPILED\n#include .*\n#endif$", "", text, flags=re.MULTILINE)
    included = re.findall(r'^[ \t]*#[ \t]*include[ \t]*([<"][^>"]+[>"])', text, re.MULTILINE)
    is_own = re.compile(r'"|<(CGAL/)?(Intrinsic_|Integer_only_triangulation)')
    return [name for name in included if is_own.match(name)]


def check_includes(include, header, text, headers, places, used):
    """Yields what is wrong with the includes of a header; notes in `used` the exceptions that it needs."""
    place = place_of(header, places)
    for written in own_includes(text):
        included = written[1:-1]
        if included.endswith((".html", ".js")) and (include.parent / "src" / included).is_file():
            continue # the text of a string
        if included not in headers:
            yield f"{header} includes {written}, which is not the full path of a header"
            continue
        other = place_of(included, places)
        if place is None or other is None or other <= place:
            continue
        pair = (short(header), short(included))
        used.add(pair)
        if pair not in ALLOWED_INCLUDES:
            yield f"{header} includes {included}, of a higher room"


def expected_guard(header):
    return re.sub(r"[/.]", "_", header).upper()


def check_file(file, text, places, used):
    """Yields what is wrong with a header or source by itself."""
    if place_of(file, places) is None:
        yield f"{file} lies in no room: name its folder in the README.md of its package"
    long = [number for number, line in enumerate(text.splitlines(), 1) if len(line) > MOST_COLUMNS]
    if long:
        used.add(short(file))
        if short(file) not in ALLOWED_COLUMNS:
            lines = ", ".join(map(str, long[:5])) + (", ..." if len(long) > 5 else "")
            yield f"{file} has lines of more than {MOST_COLUMNS} columns: {lines}"
    lines = text.count("\n")
    if lines > MOST_LINES:
        used.add(short(file))
        if short(file) not in ALLOWED_LENGTHS:
            yield f"{file} has {lines} lines, at most {MOST_LINES} are allowed"


def check_header(header, text):
    """Yields what is wrong with a header, besides what may be wrong with any file."""
    guard = re.search(r"^#ifndef (\w+)\n#define (\w+)$", text, re.MULTILINE)
    if not guard or set(guard.groups()) != {expected_guard(header)}:
        yield f"{header} needs the include guard {expected_guard(header)}"


def check_rooms(public, headers, rooms, used):
    """Yields what is wrong with rooms as a whole."""
    count = collections.Counter(header.rpartition("/")[0] for header in public)
    own = {header.rpartition("/")[0] for header in headers}
    for folders, beside in rooms:
        for folder in folders:
            number = count[folder]
            if folder not in own:
                yield f"{folder}/ is named in README.md and has no headers"
            if number > MOST_HEADERS:
                used.add(folder)
                if folder not in ALLOWED_SIZES:
                    yield f"{folder}/ has {number} headers, at most {MOST_HEADERS} are allowed"
        for header in beside:
            if header not in headers:
                yield f"{header} is named in README.md and does not exist"


def find_circle(graph):
    """Returns headers each of which includes the next, and the last the first; None if there are none."""
    done, path = set(), []

    def visit(header):
        if header in path:
            return path[path.index(header):] + [header]
        if header in done:
            return None
        path.append(header)
        circle = next(filter(None, map(visit, graph[header])), None)
        path.pop()
        done.add(header)
        return circle

    return next(filter(None, map(visit, sorted(graph))), None)


def check_circles(headers):
    graph = {header: [name[1:-1] for name in own_includes(text) if name[1:-1] in headers]
             for header, text in headers.items()}
    circle = find_circle(graph)
    if circle:
        yield "headers include each other in a circle: " + " -> ".join(map(short, circle))


def check_lists_of_sources(sources):
    """Yields what is wrong with the headers that list the sources of packages."""
    listed = {package: [name[1:-1] for name in own_includes(sources.get(f"{package}_sources.h", ""))
                        if name.endswith(".cpp>")] for package in PACKAGES}
    for package, names in listed.items():
        existing = sorted(name for name in sources if name.startswith(package + "/") and name.endswith(".cpp"))
        for name in sorted(set(existing) - set(names)):
            yield f"{package}_sources.h does not include {name}"
        for name in sorted(set(names) - set(existing)):
            yield f"{package}_sources.h includes {name}, which is no source of the package"
        if names != sorted(set(names)):
            yield f"{package}_sources.h does not list its sources in their order, each once"


def program_rooms(root):
    """Returns the place in the order of each folder of the program."""
    readme = root / PROGRAM / "README.md"
    headings = re.findall(r"^## .*`([^`]*)/`", readme.read_text() if readme.is_file() else "", re.MULTILINE)
    return {posixpath.normpath(f"{PROGRAM}/{name}"): number for number, name in enumerate(headings)}


def check_program_includes(file, text, files, places, used):
    """Yields what is wrong with the includes of a file of the program or the module."""
    for written in re.findall(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', text, re.MULTILINE):
        included = posixpath.normpath(f"{posixpath.dirname(file)}/{written}")
        if included not in files:
            yield f'{file} includes "{written}", which does not exist'
        elif file.startswith(MODULE) and not included.startswith(MODULE):
            used.add((file, included))
            if (file, included) not in ALLOWED_INCLUDES:
                yield f"{file} includes {included}: the module never needs the program"
        elif file.startswith(PROGRAM):
            place, other = (places.get(posixpath.dirname(name)) for name in (file, included))
            if place is not None and (other is None or other > place):
                yield f"{file} includes {included}, of a higher room"


def check_size(file, text):
    """Yields what is wrong with the size of a file of the program or the module."""
    if text.count("\n") > MOST_LINES:
        yield f"{file} has {text.count(chr(10))} lines, at most {MOST_LINES} are allowed"
    if any(len(line) > MOST_COLUMNS for line in text.splitlines()):
        yield f"{file} has lines of more than {MOST_COLUMNS} columns"


def check_program(root, used):
    """Yields what is wrong with the files of the program and of the Python module."""
    files = {path.relative_to(root).as_posix(): path.read_text() for folder in (PROGRAM, MODULE)
             for path in sorted((root / folder).rglob("*")) if path.suffix in (".h", ".cpp")}
    for path in sorted((root / PYTHON).rglob("*.py")):
        yield from check_size(path.relative_to(root).as_posix(), path.read_text())
    places = program_rooms(root)
    for file, text in files.items():
        folder = posixpath.dirname(file)
        if file.startswith(PROGRAM) and folder not in places:
            yield f"{file} lies in no room: name its folder in {PROGRAM}/README.md"
        yield from check_size(file, text)
        if re.search(r"\binternal::", text):
            yield f"{file} names `internal::`: use what the library has for users, or add to it"
        yield from check_program_includes(file, text, files, places, used)


def check_tests(root, used):
    """Yields the tests that name something of a namespace `internal`, of this package or another one."""
    for path in sorted((root / "test").rglob("*")):
        if path.suffix not in (".h", ".cpp") or not re.search(r"\binternal\s*(::|;|{)", path.read_text()):
            continue
        name = path.relative_to(root / "test").as_posix()
        used.add(name)
        if name not in ALLOWED_INTERNALS:
            yield f"test/{name} names something of a namespace `internal`: test what users see of it"


def check_exceptions(used):
    for name in [*ALLOWED_INCLUDES, *ALLOWED_LENGTHS, *ALLOWED_SIZES, *ALLOWED_COLUMNS, *ALLOWED_INTERNALS]:
        if name not in used:
            yield f"check_rooms.py allows {name}, which is not needed any more: remove it"


def read_files(root, *endings):
    return {path.relative_to(root).as_posix(): path.read_text()
            for path in sorted(root.rglob("CGAL/**/*")) if path.suffix in endings}


def check(include):
    """Yields all that is wrong with the headers below the directory `include` and the sources in `src` beside it."""
    rooms = [room for package in PACKAGES for room in read_rooms(include, package)]
    places = room_numbers(rooms)
    public = read_files(include, ".h")
    sources = read_files(include.parent / "src", ".h", ".cpp")
    lists = [name for name in sources if name.endswith("_sources.h")]
    files = {**public, **{name: text for name, text in sources.items() if name not in lists}}
    headers = {name: text for name, text in files.items() if name.endswith(".h")}
    used = set()
    for file, text in files.items():
        yield from check_file(file, text, places, used)
        yield from check_includes(include, file, text, headers, places, used)
    for header, text in headers.items():
        yield from check_header(header, text)
    yield from check_rooms(public, headers, rooms, used)
    yield from check_circles(headers)
    yield from check_lists_of_sources(sources)
    yield from check_program(include.parent, used)
    yield from check_tests(include.parent, used)
    yield from check_exceptions(used)


if __name__ == "__main__":
    run_check.run(check, __doc__)
