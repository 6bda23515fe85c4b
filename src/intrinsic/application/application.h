// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_APPLICATION_APPLICATION_H
#define INTRINSIC_APPLICATION_APPLICATION_H

#include "../options.h"
#include "../support/progress.h"
#include "Computed.h"

#include <CGAL/Intrinsic_operators/compiled.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>

#include <functional>
#include <vector>

// The common part of all commands that solve a problem on the triangulation.

namespace program {

/// The points of each list on the command line, normalized.
using Sources = std::vector<std::vector<IT::Place>>;

/// A triangulation on which a command solves a problem.
template <class Traits>
using Solved_triangulation =
    IT::Intrinsic_triangulation<IT::Gluing_map, Traits, IT::Integer_coordinates>;

/// Where the vertices of the mesh are, in the order of its file.
using Points = std::vector<Point>;

/// Solves a problem on it, and may refine it for that. It may show progress, also in
/// `Computed::write`.
template <class Traits>
using Solver = std::function<Computed(Solved_triangulation<Traits>&, const Sources&, const Points&,
                                      Progress&)>;

/// loads a mesh, makes its triangulation Delaunay and refines it as options say, solves in the
/// chosen arithmetic, and writes the results.
void run_application(const Options& options, const Solver<IT::Exact_euclidean_traits>& exact,
                     const Solver<IT::Euclidean_traits<double>>& approximate);

/// the same, with a generic function.
template <class Solve>
void run_application(const Options& options, const Solve& solve) {
  run_application(options, Solver<IT::Exact_euclidean_traits>(solve),
                  Solver<IT::Euclidean_traits<double>>(solve));
}

} // namespace program

#endif // INTRINSIC_APPLICATION_APPLICATION_H
