# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What `intrinsic study` writes as a table, and what follows from it."""

import json
import math

import pandas

from failure import Failure

# From the simplest to exact ones, with the color, marker and dashes of plots; others come last. The
# palette of Okabe and Ito (2008), which color-blind people can tell apart; relatives share a color.
# Yellow is left out: it does not show on white.
ARITHMETICS = {
    "double": ("#000000", "o", "-"),
    "double-1e-12": ("#E69F00", "o", "-"),
    "double-1e-6": ("#E69F00", "s", "--"),
    "double-1e-5": ("#E69F00", "^", ":"),
    "long-double": ("#777777", "D", "--"),
    "interval": ("#56B4E9", "o", ":"),
    "boost-100": ("#009E73", "s", "-"),
    "boost-200": ("#009E73", "D", "--"),
    "gmpq": ("#CC79A7", "^", "-"),
    "core-expr": ("#D55E00", "^", "-"),
    "lazy-core-expr": ("#D55E00", "X", "--"),
    "exact": ("#0072B2", "o", "-"),
    "exact-integer": ("#0072B2", "s", "--"),
}
OTHER_STYLE = ("#999999", "X", ":")
CERTIFIED = ["exact", "exact-integer"]
NAIVE_EXACT = ["gmpq", "core-expr", "lazy-core-expr"]  # without filter and history of our own
STATUSES = {"done": "done", "cap": "cap on flips", "timed_out": "timed out",
            "out_of_memory": "out of memory", "crashed": "crashed",
            "not_applicable": "not applicable", "refused_input": "input refused"}
UNFINISHED = ["timed_out", "out_of_memory", "crashed", "cap"]
WORDS = ["mesh", "family", "arithmetic", "status", "message", "result", "comparison", "version",
         "machine"]
NUMBERS = ["faces", "flips", "checks", "refused_flips", "filter_failures", "integer",
           "certified_zero", "probable_zero", "undecided", "different_decisions", "nonconvex_flips",
           "inverted_faces", "non_delaunay_edges", "cycles", "largest_interval_width", "area_drift",
           "cone_angle_drift", "seconds.build", "seconds.flip", "peak_rss_mib", "limits.seconds",
           "limits.mib"]


def is_result(line):
    return isinstance(line, dict) and all(isinstance(line.get(key), str) and line[key]
                                          for key in ("mesh", "arithmetic", "status"))


def parsed(text):
    try:
        return json.loads(text)
    except ValueError:
        return None


def read_lines(path):
    """The lines of a file; a last one that is not complete, as of a study at work, is left out."""
    try:
        with open(path, encoding="utf-8") as file:
            complete = file.read().split("\n")[:-1]
    except (OSError, UnicodeDecodeError) as e:
        raise Failure(f"{path}: cannot be read: {e}; give files that `intrinsic study` has "
                      "written") from e
    lines = [parsed(text) for text in complete]
    for number, line in enumerate(lines, 1):
        if not is_result(line):
            raise Failure(f"{path}: line {number} is not a result of the study; remove it")
    return lines


def rank(arithmetic):
    known = list(ARITHMETICS)
    return (known.index(arithmetic) if arithmetic in known else len(known), arithmetic)


def value_of(line, key):
    """A value, that of an object by `object.key`; None if there is none."""
    for part in key.split("."):
        line = line.get(part) if isinstance(line, dict) else None
    return line


def number_of(line, key):
    x = value_of(line, key)
    is_number = isinstance(x, (int, float)) and not isinstance(x, bool) and math.isfinite(x)
    return x if is_number else math.nan


def word_of(line, key):
    x = value_of(line, key)
    return x if isinstance(x, str) else ""


def escalations_of(line):
    """How many predicates so many bits have decided."""
    found = value_of(line, "escalations")
    pairs = found.items() if isinstance(found, dict) else []
    return {int(bits): n for bits, n in pairs if bits.isdigit() and isinstance(n, int)}


def row_of(line):
    row = {key: word_of(line, key) for key in WORDS}
    row.update({key: number_of(line, key) for key in NUMBERS})
    return row | {"escalations": escalations_of(line)}


def results_of(lines):
    """One row per mesh and arithmetic, files first, then by family, by name, and arithmetic."""
    frame = pandas.DataFrame([row_of(line) for line in lines])
    frame = frame.drop_duplicates(["mesh", "arithmetic"], keep="last").copy()
    by_mesh = frame.groupby("mesh")
    frame["faces"] = by_mesh["faces"].transform("max").fillna(0)
    frame["seconds"] = frame["seconds.build"] + frame["seconds.flip"]
    frame["is_done"] = frame["status"] == "done"
    frame["is_file"] = by_mesh["family"].transform("max") == "files"
    frame["rank"] = frame["arithmetic"].map(rank)
    frame = frame.sort_values(["is_file", "family", "mesh", "rank"],
                              ascending=[False, True, True, True])
    return frame.reset_index(drop=True)


def meshes_of(results):
    return list(dict.fromkeys(results["mesh"]))


def arithmetics_of(results):
    return sorted(set(results["arithmetic"]), key=rank)


def faces_of(results):
    """Numbers of faces by mesh."""
    return results.drop_duplicates("mesh").set_index("mesh")["faces"]


def of(results, arithmetic):
    """The lines of an arithmetic, by mesh."""
    return results[results["arithmetic"] == arithmetic].set_index("mesh")


def done(results, arithmetic):
    """Those that have finished."""
    lines = of(results, arithmetic)
    return lines[lines["is_done"]]


# ---- What is known of an arithmetic -------------------------------------------------------------


def total(results, arithmetic, key):
    """Sum of a key over the lines of an arithmetic that have it; NaN if none has."""
    return of(results, arithmetic)[key].sum(min_count=1)


def finishing_arithmetics(results):
    """Those that have done at least nine meshes of ten."""
    number = len(meshes_of(results))
    return [a for a in arithmetics_of(results) if 10 * len(done(results, a)) >= 9 * number]


def common_meshes(results):
    """The meshes that all finishing arithmetics have done, with times."""
    common, names = set(meshes_of(results)), finishing_arithmetics(results)
    for a in names:
        common &= set(done(results, a)["seconds"].dropna().index)
    return common if names else set()


def times_beside_double(results, arithmetic, meshes=None):
    """Times of an arithmetic and of double on meshes that both have done, of `meshes` if given."""
    times = pandas.DataFrame({"own": done(results, arithmetic)["seconds"],
                              "double": done(results, "double")["seconds"]}).dropna()
    return times if meshes is None else times[times.index.isin(meshes)]


def ratio(times):
    return times["own"].sum() / times["double"].sum() if times["double"].sum() > 0 else math.nan


def agreement(results, a, b):
    """Of each mesh whose result is known of two arithmetics, whether they are the same."""
    found = pandas.DataFrame({x: done(results, x)["result"] for x in {a, b}}).dropna()
    found = found[(found[a] != "") & (found[b] != "")]
    order = {name: i for i, name in enumerate(meshes_of(results))}
    return (found[a] == found[b]).sort_index(key=lambda index: index.map(order))


def flips_beyond_exact(results, arithmetic):
    return (of(results, arithmetic)["flips"] - done(results, "exact")["flips"]).dropna()


def decided_by(results, arithmetic):
    """Predicates that the filter left open, by what decided them, in order of cost."""
    steps = {"integers": total(results, arithmetic, "integer")}
    for bits in sorted({b for found in results["escalations"] for b in found}):
        steps[f"{bits} bits"] = sum(found.get(bits, 0)
                                    for found in of(results, arithmetic)["escalations"])
    for name, key in (("zero, proven", "certified_zero"), ("zero, probably", "probable_zero"),
                      ("undecided", "undecided")):
        steps[name] = total(results, arithmetic, key)
    return steps
