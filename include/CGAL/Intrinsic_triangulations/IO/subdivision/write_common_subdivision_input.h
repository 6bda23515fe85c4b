// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_INPUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_INPUT_H

#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace CGAL::Intrinsic_triangulations {

/// One number per vertex of a common subdivision, under a name.
struct Vertex_field {
  std::string name;               ///< letters, digits and `_.-`; no name that files use themselves
  std::span<const double> values; ///< one per vertex
};

/// What the files written by `write_common_subdivision()` contain.
struct Common_subdivision_output {
  /// Whether PLY is binary; the other formats have one encoding here.
  bool binary = true;
  /// Whether VTP contains the intrinsic edges as lines.
  bool lines_in_VTP = true;
  /// Whether OBJ contains the intrinsic edges as lines; `CGAL::IO::read_OBJ()` refuses such files.
  bool lines_in_OBJ = false;
};

namespace internal {

using Subdivision_points = std::span<const std::array<double, 3>>;
using Vertex_fields = std::span<const Vertex_field>;

// Numbers of elements are written as signed 32 bit integers, `none` as -1.
inline std::int32_t signed_label(std::uint32_t i) {
  return static_cast<std::int32_t>(
      i); // modular by the standard; numbers of elements are below 2^31
}

/// Names that the labels of vertices have in files.
inline constexpr std::array<std::string_view, 21> vertex_label_names{"x",
                                                                     "y",
                                                                     "z",
                                                                     "kind",
                                                                     "input_face",
                                                                     "input_edge",
                                                                     "intrinsic_edge",
                                                                     "input_vertices",
                                                                     "input_weights",
                                                                     "intrinsic_vertices",
                                                                     "intrinsic_weights",
                                                                     "input_vertex_0",
                                                                     "input_vertex_1",
                                                                     "input_vertex_2",
                                                                     "input_weight_0",
                                                                     "input_weight_1",
                                                                     "input_weight_2",
                                                                     "intrinsic_vertex_0",
                                                                     "intrinsic_vertex_1",
                                                                     "intrinsic_weight_0",
                                                                     "intrinsic_weight_1"};

inline bool is_field_name(std::string_view name) {
  const auto is_allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '.' || c == '-';
  };
  return !name.empty() && std::all_of(name.begin(), name.end(), is_allowed) &&
         std::find(vertex_label_names.begin(), vertex_label_names.end(), name) ==
             vertex_label_names.end();
}

inline void check_fields(std::size_t number_of_vertices, Vertex_fields fields) {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string name = "the field \"" + fields[i].name + "\" ";
    const auto is_same = [&](const Vertex_field& f) { return f.name == fields[i].name; };
    if (!is_field_name(fields[i].name))
      throw Invalid_input(Element_kind::none, 0,
                          name + "cannot be written under this name; name it with letters, digits "
                                 "and _.-, and not as labels of vertices are named");
    if (std::any_of(fields.begin(), fields.begin() + static_cast<std::ptrdiff_t>(i), is_same))
      throw Invalid_input(Element_kind::none, 0, name + "occurs twice; rename one of the two");
    if (fields[i].values.size() != number_of_vertices)
      throw Invalid_input(Element_kind::none, 0,
                          name + "has " + std::to_string(fields[i].values.size()) +
                              " values; give one for each of the " +
                              std::to_string(number_of_vertices) +
                              " vertices of the common subdivision");
  }
}

inline void check_output(const Common_subdivision& s, Subdivision_points points,
                         Vertex_fields fields) {
  if (points.empty() && s.number_of_vertices() != 0)
    throw Invalid_input(Element_kind::none, 0,
                        "the common subdivision has no positions in space, as the input is an "
                        "abstract metric; give a position for each vertex of the input, or write "
                        "the intrinsic triangulation to a file .idt");
  if (points.size() != s.number_of_vertices())
    throw Invalid_input(
        Element_kind::none, 0,
        "there are " + std::to_string(points.size()) + " positions; give one for each of the " +
            std::to_string(s.number_of_vertices()) + " vertices of the common subdivision");
  check_fields(s.number_of_vertices(), fields);
}

inline void check_written(bool is_good) {
  if (!is_good) throw std::runtime_error("the common subdivision cannot be written completely");
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_INPUT_H
