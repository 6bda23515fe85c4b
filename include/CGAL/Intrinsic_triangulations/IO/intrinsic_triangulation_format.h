// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_INTRINSIC_TRIANGULATION_FORMAT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_INTRINSIC_TRIANGULATION_FORMAT_H

#include <CGAL/Intrinsic_triangulations/metric/Euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/mollification.h>

#include <array>
#include <string_view>
#include <utility>

/*!
\file
The text format of intrinsic triangulations, ordinarily with extension `.idt`.

The format keeps a triangulation without loss: connectivity with the number of every element, stored
values bit by bit, and, with exact traits, the input and the history of flips, which define all values
exactly. The manual has its specification, `doc/Intrinsic_triangulations/file_format.md`. See
`write_intrinsic_triangulation()` and `read_intrinsic_triangulation()`.
*/

namespace CGAL::Intrinsic_triangulations {

/// Version of the file format that is written, and read.
constexpr int intrinsic_triangulation_format_version = 1;

namespace internal {

// The word that names the arithmetic of a metric in the file; only these metrics can be written.
template <class Metric>
inline constexpr std::string_view arithmetic_name = {};
template <>
inline constexpr std::string_view arithmetic_name<Euclidean_metric<double>> = "double";
template <>
inline constexpr std::string_view arithmetic_name<Exact_euclidean_metric> = "exact";

inline constexpr std::array<std::pair<Mollification, std::string_view>, 3> mollification_names = {
    {{Mollification::none, "none"},
     {Mollification::lengths, "lengths"},
     {Mollification::squared_lengths, "squared_lengths"}}};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_INTRINSIC_TRIANGULATION_FORMAT_H
