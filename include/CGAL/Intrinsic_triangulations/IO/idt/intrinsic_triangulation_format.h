// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_INTRINSIC_TRIANGULATION_FORMAT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_INTRINSIC_TRIANGULATION_FORMAT_H

#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/metric/Euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

/*!
\file
The text format of intrinsic triangulations, ordinarily with extension `.idt`.

The format keeps a triangulation without loss: connectivity, which vertices were inserted, stored
values bit by bit, and, with exact traits, the input and the history of moves, which define all values
exactly. The manual has its specification, `doc/Intrinsic_triangulations/file_format.md`. See
`write_intrinsic_triangulation()` and `read_intrinsic_triangulation()`.
*/

namespace CGAL::Intrinsic_triangulations {

/// Version of the file format that is written. Version 1, without inserted vertices, is read too.
constexpr int intrinsic_triangulation_format_version = 2;

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

// The words that name moves; weights are given where a vertex is inserted.
inline constexpr std::string_view flip_name = "flip";
struct Vertex_move_name {
  Flip_history::Vertex_move::Kind kind;
  std::string_view name;
  std::size_t weights;
};
inline constexpr std::array<Vertex_move_name, 4> vertex_move_names = {
    {{Flip_history::Vertex_move::Kind::insert_in_face, "insert", 3},
     {Flip_history::Vertex_move::Kind::insert_in_border_edge, "insert_border", 2},
     {Flip_history::Vertex_move::Kind::remove_from_face, "remove", 0},
     {Flip_history::Vertex_move::Kind::remove_from_border_edge, "remove_border", 0}}};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_INTRINSIC_TRIANGULATION_FORMAT_H
