// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_COMMANDS_H
#define INTRINSIC_COMMANDS_H

#include "options.h"

// The program `intrinsic` starts other programs for some of them, see commands_elsewhere.cpp.

namespace program {

/// flips to Delaunay, refines and writes files, as options say.
void run_delaunay(const Options& options);
/// does the same, and takes functions from one triangulation to the other.
void run_transfer(const Options& options);
/// writes a page that shows what was loaded, with values and curves, and opens it.
void run_view(const Options& options);
/// makes curves geodesic, refines with them as constraints and writes files, as options say.
void run_geodesic(const Options& options);
/// cuts the surface open along curves, and writes it with labels, as options say.
void run_cut(const Options& options);
/// computes distances, by heat flow or exactly.
void run_distance(const Options& options);
/// maps a disk to the plane.
void run_parametrize(const Options& options);
/// maps disks to the plane as `run_uniformize` lays them out.
void run_conformal_map(const Options& options);
/// finds a discrete conformal metric with prescribed angles.
void run_uniformize(const Options& options);
/// transports tangent vectors from some vertices to all.
void run_transport(const Options& options);
/// unrolls the surface about a point.
void run_logmap(const Options& options);
/// finds the smoothest field of directions.
void run_field(const Options& options);
/// computes eigenvalues and eigenfunctions of the Laplacian.
void run_eigen(const Options& options);
/// deforms the surface by moving some of its vertices.
void run_edit(const Options& options);
/// makes a surface with fewer vertices, and proves by how much lengths change.
void run_simplify(const Options& options);
/// finds the isometries between two surfaces, or of a surface with itself.
void run_isometry(const Options& options);
/// finds the convex polyhedron of a metric on the sphere.
void run_embed(const Options& options);
/// describes a mesh or an intrinsic triangulation, as it is.
void run_info(const Options& options);
/// starts the program `intrinsic-study` in place of this one.
/// \throws std::runtime_error if that is not found
void run_study(const Options& options);

} // namespace program

#endif // INTRINSIC_COMMANDS_H
