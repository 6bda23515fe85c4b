// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_INTRINSIC_TRIANGULATION_FORMAT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_INTRINSIC_TRIANGULATION_FORMAT_H

#include <CGAL/Intrinsic_triangulations/metric/Euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>

#include <string_view>

/*!
\file
The text format of intrinsic triangulations, usually with extension `.idt`.

The format keeps a triangulation without loss: connectivity, stored values bit by bit, the input,
and how the triangulation lies on it: places of inserted vertices and integer coordinates, which
define all values exactly. `doc/Intrinsic_triangulations/file_format.md` specifies it. See
`write_intrinsic_triangulation()` and `read_intrinsic_triangulation()`.
*/

namespace CGAL::Intrinsic_triangulations {

/// Version of the file format, the only one that is read.
constexpr int intrinsic_triangulation_format_version = 5;

namespace internal {

// The word that names the arithmetic of a metric in the file; only these metrics can be written.
template <class Metric>
inline constexpr std::string_view arithmetic_name = {};
template <>
inline constexpr std::string_view arithmetic_name<Euclidean_metric<double>> = "double";
template <>
inline constexpr std::string_view arithmetic_name<Exact_euclidean_metric> = "exact";

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_INTRINSIC_TRIANGULATION_FORMAT_H
