# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of all commands of the program, and what each must keep: see `invariance`.

A measure takes a `Written`, its file and a folder for results.
"""

import json

import numpy as np
import scipy.io

import intrinsic as it
import invariance as m
import program
from invariance import combinatorial, discrete, intrinsic, vertices
from ten_surfaces import CLOSED, DISKS, MESHES, ORIENTED
from written import RIGID, place


def isometry(x, path, folder):
    found = program.run("isometry", path)["isometry"]
    return [found["answer"], found["count"]]


def simplify(x, path, folder):
    found = program.run("simplify", path, "--vertices", "50%")["simplify"]
    return [found["vertices"], found["status"]]


def embed(x, path, folder):
    return [m.angle_in_error(lambda: program.run("embed", path, "-o", folder / "e.off"))]


def write(x, path):
    """Writes a surface to an OFF file, or to an XYZ file."""
    points = [" ".join(map(repr, p)) for p in x.V.tolist()]
    if x.F is None:
        path.write_text("\n".join(points))
        return
    faces = [" ".join(map(str, [3, *f])) for f in x.F.tolist()]
    path.write_text("\n".join([f"OFF\n{len(points)} {len(faces)} 0", *points, *faces]))


def word(place):
    """A place as an option has it."""
    return ":".join(map(repr, [place.face, *place.barycentric])) if isinstance(place, it.Point) \
        else str(place)


def words(x, *ks):
    return ",".join(word(p) for p in m.spots(x, *ks))


def table(path):
    return np.genfromtxt(path, ndmin=2)


def at_vertex(x, k):
    return int(x.vertex[place(x.name, k)])


def delaunay(x, path, folder):
    out = folder / "t.idt"
    s = program.run("delaunay", path, "-o", out)
    t = it.load(out)
    return [s["certificate"], m.triangles(x, t.faces), *m.sides(x, t.faces, t.lengths),
            s["quality"]["min_angle_deg"]]


def refine(x, path, folder):
    s = program.run("refine", path, "--min-angle", 25, "--order", "worst", "-o",
                    folder / "t.idt")
    t = it.load(folder / "t.idt")
    return [s["quality"]["min_angle_deg"], m.in_order(x.space(t.points))]


def laplacian(x, path, folder):
    program.run("laplacian", path, "-o", folder / "l.mtx", "--mass", folder / "m.mtx")
    L, M = (scipy.io.mmread(folder / n).tocsr() for n in ("l.mtx", "m.mtx"))
    return [m.submatrix(x, L), m.submatrix(x, M) / x.scale**2]


def total_mass(x, path, folder):
    program.run("laplacian", path, "-o", folder / "l.mtx", "--mass", folder / "m.mtx")
    return [scipy.io.mmread(folder / "m.mtx").sum() / x.scale**2]


def transfer(x, path, folder):
    np.savetxt(folder / "u.txt", m.function(x), fmt="%r")
    program.run("transfer", path, folder / "u.txt", "-o", folder / "v.txt")
    return [x.rows(table(folder / "v.txt")[:, 0])]


def geodesic(x, path, folder):
    s = program.run("geodesic", path, "--path", words(x, 0, 1), "--path", words(x, 2, 4),
                    "--path", words(x, 6, 5))
    return [np.array([c["length"] for c in s["geodesic"]["curves"]]) / x.scale]


def cut(x, path, folder):
    np.savetxt(folder / "u.txt", m.function(x), fmt="%r")
    s = program.run("cut", path, "--values", folder / "u.txt", "--levels", "0.1,0.35", "-o",
                    folder / "c.ply")["cut"]
    return [np.sort([c["area"] for c in s["components"]]) / x.scale**2]


def distance(x, path, folder):
    s = program.run("distance", path, "--method", "exact", "--source", words(x, 0, 6), "--targets",
                    words(x, 1, 5, 7), "-o", folder / "d.txt", "--on", "input")["distance"]
    return [np.array(s["targets"]) / x.scale]


def distance_everywhere(x, path, folder):
    program.run("distance", path, "--method", "exact", "--source", words(x, 4), "-o",
                folder / "d.txt", "--on", "input")
    return [x.rows(table(folder / "d.txt")[:, 0]) / x.scale]


def distance_refined(x, path, folder):
    program.run("distance", path, "--method", "exact", "--source", words(x, 4), "--refine", "-o",
                folder / "d.txt", "--on", "input")
    return [x.rows(table(folder / "d.txt")[:, 0]) / x.scale]


def heat(x, path, folder):
    program.run("distance", path, "--method", "heat", "--source", str(at_vertex(x, 0)), "-o",
                folder / "d.txt", "--on", "input")
    return [x.rows(table(folder / "d.txt")[:, 0]) / x.scale]


def parametrize(x, path, folder):
    s = program.run("parametrize", path, "--method", "lscm", "-o", folder / "uv.txt", "--on",
                    "input")["parametrize"]
    return [s["injective"], *m.up_to_similarity(x, table(folder / "uv.txt")[:, :2])]


def uniformize(x, path, folder):
    s = program.run("uniformize", path, "-o", folder / "u.txt")["conformal"]
    shift = np.log(x.scale) if s["target"] in ("disk", "sphere") else 0
    return [s["status"], s["target"], x.rows(table(folder / "u.txt")[:, 0]) + shift]


def transport(x, path, folder):
    (folder / "v.txt").write_text(f"{at_vertex(x, 0)} 30 2\n")
    program.run("transport", path, "--vectors", folder / "v.txt", "-o", folder / "w.txt", "--on",
                "input")
    return [x.rows(table(folder / "w.txt")[:, 0])]


def logmap(x, path, folder):
    program.run("logmap", path, "--source", words(x, 0), "-o", folder / "z.txt", "--on", "input")
    z = m.complexes(x.rows(table(folder / "z.txt")[:, :2])) / x.scale
    return m.without_frame(x, 0, z)


def field(x, path, folder):
    s = program.run("field", path, "--degree", 4)["field"]
    return [s[k] for k in ("index_sum", "singular_faces", "border_turns") if k in s]


def eigen(x, path, folder):
    s = program.run("eigen", path, "--count", 5)["eigen"]
    return [np.array(s["values"]) * x.scale**2]


def edit(x, path, folder):
    moves = "\n".join(" ".join(map(repr, [at_vertex(x, k), *map(float, x.vector(
        m.direction(k)) * x.scale)])) for k in (0, 1, 2))
    (folder / "h.txt").write_text(moves)
    program.run("edit", path, "--handles", folder / "h.txt", "-o", folder / "d.txt", "--on",
                "input")
    return [x.vectors(x.rows(table(folder / "d.txt")[:, :3])) / x.scale]


def info(x, path, folder):
    s = program.run("info", path)
    return [s["domain"]["kind"], s["area"]["input"] / x.scale**2, s["input"]["genus"],
            s["input"]["components"]]


def study(x, path, folder):
    import subprocess
    out = folder / "s.jsonl"
    subprocess.run([program.PROGRAM, "study", path, "--arithmetic", "double,exact", "-o", out],
                   check=True, capture_output=True)
    lines = [json.loads(line) for line in out.read_text().splitlines()]
    return [[[s[k] for k in ("arithmetic", "status", "vertices", "faces", "non_delaunay_edges",
                             "inverted_faces", "different_decisions", "cycles")] for s in lines]]


COMMANDS = {
    "delaunay": [combinatorial(delaunay)],
    "refine": [combinatorial(refine, on=MESHES)],
    "laplacian": [discrete(laplacian), intrinsic(total_mass)],
    "transfer": [discrete(transfer)],
    "geodesic": [intrinsic(geodesic)],
    "cut": [intrinsic(cut, on=ORIENTED)],
    "distance": [intrinsic(distance), intrinsic(distance_everywhere), intrinsic(distance_refined),
                 discrete(heat)],
    "parametrize": [discrete(parametrize, on=DISKS)],
    "uniformize": [vertices(uniformize, on=ORIENTED)],
    "transport": [discrete(transport)],
    "logmap": [intrinsic(logmap), discrete(logmap, on=("cloud",))],
    "field": [combinatorial(field, on=MESHES)],
    "eigen": [discrete(eigen)],
    "edit": [discrete(edit)],
    "embed": [intrinsic(embed, on=("sphere",))],
    "isometry": [combinatorial(isometry, on=CLOSED)],
    "simplify": [combinatorial(simplify, on=CLOSED, changes=tuple(RIGID))],
    "info": [intrinsic(info)],
    "study": [combinatorial(study, on=ORIENTED)],
}
