# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of the report of a study."""

import math

import pandas

from page import (UNKNOWN, details, grouped, paragraph, share, short, table)
from report_lines import (CERTIFIED, NAIVE_EXACT, STATUSES, UNFINISHED, agreement, arithmetics_of,
                          common_meshes, decided_by, done, faces_of, finishing_arithmetics,
                          flips_beyond_exact, meshes_of, of, ratio, times_beside_double, total)

# ---- Arithmetics --------------------------------------------------------------------------------


def ends(results):
    rows = []
    for a in arithmetics_of(results):
        lines = of(results, a)
        rows.append([a, grouped(len(lines)),
                     *(grouped((lines["status"] == s).sum()) for s in STATUSES),
                     short(lines["peak_rss_mib"].max())])
    return table(rows, ["arithmetic", "jobs", *STATUSES.values(), "largest memory (MiB)"])


def times(results):
    finishing, common, rows = finishing_arithmetics(results), common_meshes(results), []
    for a in arithmetics_of(results):
        shared, own = times_beside_double(results, a, common), times_beside_double(results, a)
        on_common = [short(shared["own"].sum()), short(ratio(shared))]
        rows.append([a, *(on_common if a in finishing else [UNKNOWN] * 2), short(ratio(own)),
                     grouped(len(own))])
    text = ("<p>Seconds of building and flipping, without any of the comparisons. <i>Common</i> "
            "meshes are those done by every arithmetic that has done nine meshes in ten; there are "
            f"{grouped(len(common))}.</p>\n")
    return text + table(rows, ["arithmetic", "time on common (s)", "ratio to double",
                               "ratio to double where done", "over so many meshes"])


def decisions(results):
    sums = {"flips": "flips", "different decisions": "different_decisions",
            "flips not convex": "nonconvex_flips", "refused flips": "refused_flips",
            "cycles": "cycles", "inverted faces": "inverted_faces",
            "edges not Delaunay": "non_delaunay_edges"}
    worst = {"area drift": "area_drift", "cone angle drift": "cone_angle_drift",
             "interval width": "largest_interval_width"}
    rows = []
    for a in arithmetics_of(results):
        lines, agree = of(results, a), agreement(results, a, "exact")
        ended = lines["comparison"][lines["comparison"] != ""]
        rows.append([a, *(grouped(total(results, a, key)) for key in sums.values()),
                     grouped((lines["non_delaunay_edges"] > 0).sum()),
                     # comparisons end early where the exact metric cannot follow, or at limits
                     share((ended == "complete").sum(), len(ended)),
                     share(agree.sum(), len(agree)),
                     *(short(lines[key].max(), 2) for key in worst.values())])
    return table(rows, ["arithmetic", *sums, "in so many meshes", "compared to the end",
                        "same result as exact", *worst])


def summary(results):
    return ends(results) + times(results) + decisions(results)


def summaries(results):
    text = "<h2>Summary</h2>\n" + paragraph(
        "All that follows a decision was tested with exact arithmetic: which predicates of an "
        "arithmetic are wrong on the way, which flips were of diamonds that are not convex, and "
        "which edges of the result are not Delaunay. Drifts are the worst over meshes: of the "
        "total area, relative; of cone angles, in radians. Interval widths are relative. A dash: "
        "not known, or without meaning for the arithmetic.") + summary(results)
    files, stress = results[results["is_file"]], results[~results["is_file"]]
    if files.empty or stress.empty:
        return text
    return (text + details("Mesh files only", summary(files))
            + details("Stress families only", summary(stress)))


def escalations(results):
    rows, head = [], []
    for a in arithmetics_of(results):
        failures = total(results, a, "filter_failures")
        if a not in CERTIFIED and not failures > 0:
            continue
        steps = decided_by(results, a)
        head = ["arithmetic", "checks", "filter failures", *steps]
        rows.append([a, grouped(total(results, a, "checks")), grouped(failures),
                     *map(grouped, steps.values())])
    return table(rows, head) if rows else ""


# ---- Meshes by arithmetics ----------------------------------------------------------------------


def cell(value, is_done):
    if math.isnan(value):
        return "?" if is_done else UNKNOWN
    return grouped(value)


def matrix(results, columns, values):
    """Meshes by arithmetics, of the meshes with a value that is not zero, largest first."""
    meshes = meshes_of(results)
    found = pandas.DataFrame({a: values(a).reindex(meshes) for a in columns}, index=meshes)
    largest = found.abs().max(axis=1).fillna(0)
    names = sorted(largest[largest > 0].index, key=lambda mesh: (-largest[mesh], mesh))
    if not names:
        return paragraph("None.")
    faces = faces_of(results)
    finished = {a: set(done(results, a).index) for a in columns}
    rows = [[mesh, grouped(faces[mesh]),
             *(cell(found.at[mesh, a], mesh in finished[a]) for a in columns)] for mesh in names]
    return table(rows, ["mesh", "faces", *columns], shown=25)


def harm(results):
    inexact = [a for a in arithmetics_of(results) if a not in CERTIFIED + NAIVE_EXACT]
    text = "<h2>What inexact arithmetic does</h2>\n" + paragraph(
        "Meshes with the largest numbers first. A question mark is where the exact comparison did "
        "not get that far, a dash where the arithmetic itself did not.")
    for title, values in (
            ("Edges of the result that are not Delaunay", "non_delaunay_edges"),
            ("Flips more, or fewer, than with exact predicates", None),
            ("Cycles: flips that undo the last flip of the same edge", "cycles"),
            ("Flips of diamonds that are not convex", "nonconvex_flips"),
            ("Faces of the result that are inverted", "inverted_faces")):
        text += f"<h3>{title}</h3>\n" + matrix(
            results, inexact, lambda a, key=values: of(results, a)[key] if key else
            flips_beyond_exact(results, a))
    return text


def how_it_ended(lines, mesh):
    if mesh not in lines.index:
        return UNKNOWN
    line = lines.loc[mesh]
    return short(line["seconds"], 2) + " s" if line["is_done"] else line["status"].replace("_", " ")


def unfinished(results):
    text = "<h2>What does not finish</h2>\n" + paragraph(
        "Meshes on which some arithmetic reached its limits, small ones first; times of those that "
        "finish. A dash: not run.")
    stuck = results[results["status"].isin(UNFINISHED)]
    if stuck.empty:
        return text + paragraph("All arithmetics finished everything that they apply to.")
    shown = {"double", "exact"} | set(stuck["arithmetic"])
    columns = {a: of(results, a) for a in arithmetics_of(results) if a in shown}
    faces = faces_of(stuck).sort_values(kind="stable")
    rows = [[mesh, grouped(n), *(how_it_ended(lines, mesh) for lines in columns.values())]
            for mesh, n in faces.items()]
    return text + table(rows, ["mesh", "faces", *columns], shown=25)


def messages(results):
    """What jobs that failed have to say, each message of a mesh once."""
    failed = results[results["status"].isin(["crashed", "refused_input"])]
    if failed.empty:
        return ""
    merged = failed.groupby(["mesh", "status", "message"], sort=False)["arithmetic"].agg(list)
    every = arithmetics_of(results)
    rows = [[mesh, "all" if len(names) == len(every) > 1 else ", ".join(names), status, message or UNKNOWN]
            for (mesh, status, message), names in merged.items()]
    return "<h3>Crashes and refusals</h3>\n" + table(
        rows, ["mesh", "arithmetic", "end", "message"], shown=15, classes="words")
