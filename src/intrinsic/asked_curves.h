// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_ASKED_CURVES_H
#define INTRINSIC_ASKED_CURVES_H

#include "options.h"

#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>

#include <cstddef>
#include <string>
#include <vector>

// The curves that the command line and the file of `--network` name.

namespace program {

namespace IT = CGAL::Intrinsic_triangulations;

/// What the points of a curve are for.
enum class Curve_kind {
  joined,         ///< a path or a loop leads through them
  control_points, ///< they are those of a Bezier curve
  source          ///< each one is by itself, as a source or a target
};

/// A path or a loop through points, or another list of points.
struct Asked_curve {
  std::vector<IT::Place> points;
  bool is_loop = false;
  std::string source; ///< where it comes from: an option, or file and line
  Curve_kind kind = Curve_kind::joined;
};

/// returns what is wrong with a list of points, and the remedy; empty: nothing.
/// \param least how many points the list must have at least
std::string curve_points_misuse(const std::string& text, std::size_t least);

/*!
\brief returns the curves of `--path`, `--loop`, `--bezier`, `--source` and `--network`, in order.
\param options the options
\param vertices number of vertices of the mesh file
\param faces number of its faces
\throws std::runtime_error naming the file, or the option, and the element that does not exist
*/
std::vector<Asked_curve> asked_curves(const Options& options, std::size_t vertices,
                                      std::size_t faces);

/// returns the lists of points of `--source`, `--curve` and `--targets`, in this order.
/// \throws std::runtime_error as `asked_curves()` does
std::vector<Asked_curve> asked_points(const Options& options, std::size_t vertices,
                                      std::size_t faces);

} // namespace program

#endif // INTRINSIC_ASKED_CURVES_H
