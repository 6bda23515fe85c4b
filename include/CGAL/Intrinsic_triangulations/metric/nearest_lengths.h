// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_NEAREST_LENGTHS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_NEAREST_LENGTHS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief computes the lengths of all edges, each the double nearest to the exact one, in scaled units.
\param input, mesh a metric and its connectivity
\throws Invalid_input naming an edge of length zero
\complexity linear
*/
std::vector<double> nearest_lengths(const Input_metric& input, const Gluing_map& mesh);

/*!
\brief checks factors that scale the vertices of a metric.
\param factors the factors
\param number the number of vertices
\throws Invalid_input if their number is another one; naming a vertex whose factor is not positive
or not finite
*/
void check_vertex_factors(std::span<const double> factors, std::uint32_t number);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_METRIC_NEAREST_LENGTHS_H
