// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_ASKED_CURVES_H
#define INTRINSIC_ASKED_CURVES_H

#include "options.h"

#include <CGAL/Intrinsic_geodesics/finding/Wanted_curve.h>

#include <cstddef>
#include <string>
#include <vector>

// The curves that the command line and the file of `--network` name.

namespace program {

namespace IT = CGAL::Intrinsic_triangulations;

/// A curve as the user names it, or a list of points, each by itself: of kind `tree`. Its name says
/// where it comes from: an option, or file and line.
using Asked_curve = IT::Wanted_curve;

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
