// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_METRIC_H
#define INTRINSIC_METRIC_H

#include "options.h"

#include <CGAL/Intrinsic_triangulations/IO/soup/read_surface.h>

#include <cstddef>

namespace program {

namespace IT = CGAL::Intrinsic_triangulations;

/// What was done about new lengths that violate the triangle inequality.
struct Metric_report {
  std::size_t violating_faces = 0, changed_edges = 0;
  double largest_relative_change = 0;
};

/*!
\brief gives a mesh the metric of `--metric`, if there is one.
\throws std::runtime_error naming the line of the file that is wrong
\throws Invalid_input naming an edge whose new length is out of range
*/
Metric_report change_metric(IT::Read_surface& file, const Options& options);

} // namespace program

#endif // INTRINSIC_METRIC_H
