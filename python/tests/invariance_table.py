# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of all public functions of the module, and what each must keep: see `invariance`."""

import tempfile
from pathlib import Path

import intrinsic as it
import invariance as m
from invariance import Left_out, combinatorial, discrete, intrinsic, vertices
from ten_surfaces import ALL, CLOSED, DISKS, MESHES, ORIENTED
from written import RIGID

IN_SPACE = ORIENTED + ("Moebius", "soup", "book")
CURVED = tuple(name for name in ORIENTED if name != "plane")

def through_a_file(make, name, on=MESHES):
    """What a surface is that has been written to a file and read again."""
    def measure(x):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / name
            s = make(x, path)
        return [x.rows(s.distance(int(x.vertex[0]))) / x.scale]
    return measure


def saved(x, path):
    x.d.save(path)
    return it.load(path)


def read(x, path):
    lines = [f"OFF\n{len(x.V)} {len(x.F)} 0", *(" ".join(map(repr, p)) for p in x.V.tolist()),
             *(" ".join(map(str, [3, *f])) for f in x.F.tolist())]
    path.write_text("\n".join(lines))
    return it.read(path)


def lengths_of_copy(x):
    return [x.s.isolines(m.function(x), [0.1, 0.35]).copy().length / x.scale]


def length_of_network(x):
    found = x.s.network([m.spots(x, 0, 1, 2)])
    return [found.length / x.scale, found.lengths / x.scale]


TABLE = {
    # Surfaces
    "Surface": [intrinsic(m.of_lengths, on=ORIENTED)],
    "Surface.delaunay": [combinatorial(m.delaunay), combinatorial(m.flips, changes=tuple(RIGID))],
    # Circumcenters make congruent faces after some steps, which are ties: so few are inserted. The
    # sheets of a soup are congruent, too.
    "Surface.refine": [
        combinatorial(m.refined_by(min_angle=30, order="worst"),
                      on=ORIENTED + ("Moebius", "book")),
        combinatorial(m.refined_by(max_edge_length=0.6, order="largest"), on=ORIENTED + ("book",)),
        combinatorial(m.refined_by(max_circumradius=0.4, order="largest"), on=MESHES),
        combinatorial(m.refined_by(min_angle=20), on=MESHES, changes=tuple(RIGID))],
    "Surface.adapt": [combinatorial(m.adapted, on=CURVED, changes=tuple(RIGID)),
                      combinatorial(m.adapted_enough, on=ORIENTED)],
    "Surface.number_of_vertices": [combinatorial(m.numbers)],
    "Surface.number_of_faces": [combinatorial(m.numbers)],
    "Surface.number_of_input_vertices": [combinatorial(m.numbers)],
    "Surface.number_of_input_faces": [combinatorial(m.numbers)],
    "Surface.faces": [combinatorial(lambda x: [m.triangles(x, x.s.faces)])],
    "Surface.lengths": [vertices(lambda x: m.sides(x, x.s.faces, x.s.lengths))],
    "Surface.glue": [combinatorial(m.glue)],
    "Surface.points": [intrinsic(lambda x: [x.space(x.rows(x.s.points))], on=ALL)],
    "Surface.report": [combinatorial(lambda x: [x.s.report["domain"]["kind"]])],
    "Surface.statistics": [vertices(m.statistics)],
    "Surface.certificate": [intrinsic(lambda x: [x.s.certificate, x.d.certificate])],
    "Surface.copy": [intrinsic(lambda x: [
        x.rows(x.s.copy().distance(int(x.vertex[0]))) / x.scale])],
    "Surface.save": [intrinsic(through_a_file(saved, "t.idt"))],
    "load": [intrinsic(through_a_file(saved, "t.idt"))],
    "read": [intrinsic(through_a_file(read, "t.off"))],
    "points": [vertices(lambda x: [it.points(x.V, neighbors=12).mass().sum() / x.scale**2],
                        on=("cloud",))],
    "map": [intrinsic(lambda x: it.map(lambda s: s.mass().sum() / x.scale**2, [x.s]))],
    "Failure": Left_out("holds what a function of the user's raised"),
    "__version__": Left_out("is of the package"),
    **{f"{kind}.save": Left_out("writes what the result has to a file") for kind in
       ("ConformalMap", "ConvexPolyhedron", "Curve", "Curves", "Cut", "Network", "PlaneMap",
        "Voronoi")},
    "Surface.html": Left_out("draws what delaunay() and common_subdivision() give"),
    "Surface.show": Left_out("opens a browser with html()"),
    "Surface.to_pyvista": Left_out("needs PyVista; it is common_subdivision()"),
    "CommonSubdivision.to_pyvista": Left_out("needs PyVista; it copies the subdivision's arrays"),
    # Matrices
    "Surface.laplacian": [discrete(lambda x: [m.submatrix(x, x.s.laplacian())])],
    # Thirds of faces depend on diagonals of squares, which are ties: the cloud here has none. What
    # does not depend on them is in `test_clouds`, for lattices.
    "Surface.mass": [intrinsic(lambda x: [x.s.mass(k).sum() / x.scale**2
                                          for k in ("lumped", "galerkin", "voronoi")]),
                     discrete(lambda x: [m.submatrix(x, x.s.mass(k)) / x.scale**2
                                         for k in ("lumped", "galerkin", "voronoi")])],
    "Surface.connection_laplacian": [discrete(m.connection, on=MESHES)],
    "Surface.operators": [discrete(m.operators, on=ORIENTED)],
    "Operators": [discrete(m.operators, on=ORIENTED)],
    "Operators.save": [discrete(m.operators, on=ORIENTED)],
    "Operators.load": [discrete(m.operators, on=ORIENTED)],
    "Surface.eigen": [discrete(m.eigen), discrete(m.eigenvalues, on=MESHES, converges=True)],
    # The input and the triangulation
    "Surface.to_input": [discrete(m.transferred, on=MESHES), intrinsic(m.constants)],
    "Surface.from_input": [discrete(m.transferred, on=MESHES), intrinsic(m.constants)],
    "Surface.locate": [intrinsic(m.located, on=ORIENTED)],
    "Surface.common_subdivision": [intrinsic(m.subdivision), discrete(m.subdivision_in_detail,
                                                                      on=MESHES)],
    "CommonSubdivision": [intrinsic(m.subdivision)],
    "CommonSubdivision.polygons": [discrete(m.subdivision_in_detail, on=MESHES)],
    "CommonSubdivision.triangles": [intrinsic(m.subdivision)],
    # Distances
    "Surface.distance": [intrinsic(m.distance),
                         vertices(lambda x: [x.rows(x.s.distance(m.spot(x, 0))) / x.scale],
                                  on=("cloud",)),
                         discrete(m.distance_by_heat, converges=True),
                         discrete(m.distance_by_heat_from_edge)],
    "Surface.distances": [
        intrinsic(lambda x: [x.rows(d) / x.scale for d in x.s.distances(
            [m.spots(x, 0), m.spots(x, 1, 6), m.spots(x, 4)], threads=2)]),
        discrete(lambda x: [x.rows(d) / x.scale for d in x.s.distances(
            [m.spots(x, 0), m.spots(x, 1, 2)], method="heat", threads=2)])],
    "Surface.pair_distances": [
        intrinsic(lambda x: [x.s.pair_distances(m.spots(x, 0, 4, 6, 1),
                                                m.spots(x, 5, 7, 2, 3)) / x.scale]),
        discrete(lambda x: [x.s.pair_distances([int(x.vertex[m.place(x.name, 0)])],
                                               [int(x.vertex[m.place(x.name, 1)])],
                                               method="heat") / x.scale])],
    "Surface.voronoi": [intrinsic(m.voronoi), discrete(m.cells, on=ORIENTED)],
    "Voronoi": [intrinsic(m.voronoi)],
    "Surface.farthest_points": [combinatorial(m.farthest)],
    "FarthestPoints": [combinatorial(m.farthest)],
    # Curves
    "Surface.path": [intrinsic(m.path), discrete(m.path_in_space, on=ORIENTED)],
    "Curve": [intrinsic(m.path)],
    "Curve.places": [intrinsic(m.places_of_path, on=ORIENTED)],
    "Point": [intrinsic(m.places_of_path, on=ORIENTED)],
    "Surface.loop": [intrinsic(m.loop)],
    "Surface.network": [intrinsic(m.network)],
    "Network": [intrinsic(m.network)],
    "Network.length": [intrinsic(length_of_network)],
    "Network.lengths": [intrinsic(length_of_network)],
    "Surface.trace": [intrinsic(m.trace, on=ORIENTED)],
    "Curves": [intrinsic(m.isolines)],
    "Curves.length": [intrinsic(m.lengths_of_lines)],
    "Curves.lengths": [intrinsic(m.lengths_of_lines)],
    "Curves.copy": [intrinsic(lengths_of_copy)],
    "Surface.isolines": [intrinsic(m.isolines)],
    "Surface.cut": [intrinsic(m.cut_along_lines, on=ORIENTED),
                    intrinsic(m.cut_along_path, on=ORIENTED),
                    intrinsic(m.cut_to_disks, on=ORIENTED)],
    "Cut": [intrinsic(m.cut_along_lines, on=ORIENTED)],
    "Cut.surface": [intrinsic(m.cut_along_path, on=ORIENTED)],
    "Cut.number_of_components": [intrinsic(m.cut_along_lines, on=ORIENTED)],
    # Vectors
    "Surface.frames": [vertices(m.axes_of_frames, on=IN_SPACE)],
    "Frames.vertices": [vertices(m.axes_of_frames, on=IN_SPACE)],
    "Frames.faces": [vertices(m.axes_of_frames, on=IN_SPACE)],
    "Frames.angles": [vertices(m.turns, on=MESHES)],
    "Frames.to_space": [discrete(m.to_space)],
    "Surface.log_map": [
        intrinsic(m.logarithm("exact", 0, 4, 6)),
        discrete(m.logarithm("affine", 0)),
        discrete(m.logarithm("affine", 4, 6), on=MESHES),
        discrete(m.logarithm("polar", 0, 4, 6), on=MESHES)],
    "Surface.transport": [discrete(m.transport), discrete(
        m.transport_from_vertex, on=("genus 2", "disk", "plane", "cone"), converges=True)],
    "VectorField.lengths": [discrete(m.transport)],
    "VectorField.vectors": [discrete(m.transport)],
    "VectorField.axes": [discrete(m.axes)],
    "Surface.extend": [discrete(m.extend), discrete(m.extend_from_far, converges=True)],
    "Surface.direction_field": [discrete(m.aligned, on=CURVED),
                                discrete(m.fixed),
                                combinatorial(m.singularities, on=ORIENTED)],
    "DirectionField.vectors": [discrete(m.fixed)],
    "Surface.signed_distance": [
        discrete(m.signed(lambda x: x.s.isolines(m.function(x), [0.1])), on=ORIENTED),
        discrete(m.signed(lambda x: x.s.path(m.spot(x, 0), m.spot(x, 1))), on=ORIENTED),
        discrete(m.signed(m.corners_of_curve), on=ORIENTED)],
    # Maps
    "Surface.parametrize": [discrete(m.mapped(k), on=DISKS)
                            for k in ("harmonic", "lscm", "spectral")] + [
        vertices(m.mapped_conformally(k), on=DISKS) for k in ("delaunay", "input")] + [
        intrinsic(m.flat_map, on=("plane",))] + [  # of others: test_invariance.Conformal_maps
        combinatorial(m.cut_and_mapped, on=CLOSED)],
    "Surface.uniformize": [vertices(m.uniformized(k), on=ORIENTED) for k in ("delaunay", "input")]
    + [vertices(m.with_cones, on=CLOSED), vertices(m.start_of_the_surface, on=CLOSED)],
    "Surface.simplify": [combinatorial(m.coarse, on=CLOSED, changes=tuple(RIGID))],
    "Surface.hierarchy": [combinatorial(m.coarse, on=CLOSED, changes=tuple(RIGID))],
    "Surface.remove_flat_vertices": [combinatorial(m.without_flat, on=ORIENTED, changes=tuple(RIGID))],
    "CoarseSurface": [combinatorial(m.coarse, on=CLOSED, changes=tuple(RIGID))],
    "CoarseSurface.vector_prolongation": [
        combinatorial(m.coarse_vectors, on=CLOSED, changes=tuple(RIGID))],
    **{name: [combinatorial(m.symmetries, on=CURVED)] for name in
       ("Surface.isometries", "Surface.hash", "Isometries", "Isometry", "Isometry.points")},
    "ConvexPolyhedron.surface": [intrinsic(m.hull_again, on=("sphere",))],
    "Surface.embed": [intrinsic(m.embedded, on=("sphere",))],
    "Surface.deform": [discrete(m.deform(k), on=ALL) for k in ("biharmonic", "harmonic")],
}
