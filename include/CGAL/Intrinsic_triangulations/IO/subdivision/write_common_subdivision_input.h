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
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// One number per vertex of a common subdivision, under a name.
struct Vertex_field {
  std::string name;           ///< letters, digits and `_.-`; no name that files use themselves
  std::vector<double> values; ///< one per vertex

  /// is a field without name or values.
  Vertex_field() = default;
  /// takes name and values.
  Vertex_field(std::string its_name, std::vector<double> its_values)
      : name(std::move(its_name)), values(std::move(its_values)) {}
  /// takes a name and copies values. \tparam Range a range of numbers, such as `Eigen::VectorXd`
  template <class Range>
    requires(!std::is_convertible_v<const Range&, std::vector<double>>)
  Vertex_field(std::string its_name, const Range& its_values)
      : name(std::move(its_name)), values(its_values.begin(), its_values.end()) {}
};

namespace internal {

// What is written.
struct Subdivision_output {
  const Common_subdivision& s;
  std::span<const std::array<double, 3>> points;
  std::span<const Vertex_field> fields;
};

// Numbers of elements are written as signed 32 bit integers, `none` as -1: modular by the standard; they are
// below 2^31.
inline std::int32_t signed_label(std::uint32_t i) { return static_cast<std::int32_t>(i); }

/*!
Visits what files tell of each vertex besides its position. The visitor takes a name, that of a component
(which a number follows, where there are several) and a functor from vertices to arrays of components.
*/
template <class Visit>
void for_each_vertex_label(const Common_subdivision& s, Visit visit) {
  constexpr std::uint32_t none = Common_subdivision::none;
  const auto label = [&](std::string_view name, auto value) {
    visit(name, name, [=](std::size_t v) { return std::array{value(v)}; });
  };
  const auto vertices = []<std::size_t n>(const Weighted_vertices& w,
                                          std::array<std::int32_t, n> all) {
    for (std::size_t i = 0; i < n; ++i) all[i] = signed_label(i < w.size ? w.vertices[i] : none);
    return all;
  };
  const auto weights = []<std::size_t n>(const Weighted_vertices& w, std::array<double, n> all) {
    for (std::size_t i = 0; i < n; ++i) all[i] = i < w.size ? w.weights[i] : 0;
    return all;
  };
  const std::size_t m = s.vertices.size(); // crossings follow
  label("kind", [&s](std::size_t v) { return static_cast<std::uint8_t>(s.kind(v)); });
  label("input_face",
        [&s, m](std::size_t v) { return signed_label(v < m ? s.vertices[v].input_face : none); });
  label("input_edge", [&s, m](std::size_t v) {
    return signed_label(v < m ? none : s.crossings[v - m].on_input.edge);
  });
  label("intrinsic_edge", [&s, m](std::size_t v) {
    return signed_label(v < m ? none : s.crossings[v - m].on_intrinsic.edge);
  });
  using std::array;
  visit("input_vertices", "input_vertex_",
        [&](std::size_t v) { return vertices(s.on_input(v), array<std::int32_t, 3>()); });
  visit("input_weights", "input_weight_",
        [&](std::size_t v) { return weights(s.on_input(v), array<double, 3>()); });
  visit("intrinsic_vertices", "intrinsic_vertex_",
        [&](std::size_t v) { return vertices(s.on_intrinsic(v), array<std::int32_t, 2>()); });
  visit("intrinsic_weights", "intrinsic_weight_",
        [&](std::size_t v) { return weights(s.on_intrinsic(v), array<double, 2>()); });
}

// The name of a component of a label.
inline std::string component_name(std::string_view component, std::size_t i,
                                  std::size_t components) {
  return std::string(component) + (components == 1 ? "" : std::to_string(i));
}

inline bool is_field_name(std::string_view name) {
  constexpr std::string_view allowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.-";
  bool is_taken = name == "x" || name == "y" || name == "z";
  const Common_subdivision none;
  for_each_vertex_label(none, [&](std::string_view label, std::string_view component, auto values) {
    constexpr std::size_t components = std::tuple_size_v<decltype(values(0))>;
    is_taken = is_taken || name == label;
    for (std::size_t i = 0; i < components; ++i)
      is_taken = is_taken || name == component_name(component, i, components);
  });
  return !is_taken && !name.empty() && name.find_first_not_of(allowed) == std::string_view::npos;
}

inline void check_fields(const Subdivision_output& o) {
  for (std::size_t i = 0; i < o.fields.size(); ++i) {
    const Vertex_field& field = o.fields[i];
    const std::string name = "the field \"" + field.name + "\" ";
    const auto fail = [&name](const std::string& what) {
      throw Invalid_input(Element_kind::none, 0, name + what);
    };
    if (!is_field_name(field.name))
      fail("cannot be written under this name; name it with letters, digits and _.-, and not as "
           "labels of "
           "vertices are named");
    if (std::ranges::count(o.fields.first(i), field.name, &Vertex_field::name) != 0)
      fail("occurs twice; rename one of the two");
    if (field.values.size() != o.s.number_of_vertices())
      fail("has " + std::to_string(field.values.size()) + " values; give one for each of the " +
           std::to_string(o.s.number_of_vertices()) + " vertices of the common subdivision");
  }
}

inline void check_output(const Subdivision_output& o) {
  if (o.points.empty() && o.s.number_of_vertices() != 0)
    throw Invalid_input(Element_kind::none, 0,
                        "the common subdivision has no positions in space, as the input is an "
                        "abstract metric; give a position for each vertex of the input, or write "
                        "the intrinsic triangulation to a file .idt");
  if (o.points.size() != o.s.number_of_vertices())
    throw Invalid_input(
        Element_kind::none, 0,
        "there are " + std::to_string(o.points.size()) + " positions; give one for each of the " +
            std::to_string(o.s.number_of_vertices()) + " vertices of the common subdivision");
  check_fields(o);
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_INPUT_H
