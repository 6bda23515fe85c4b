// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_field.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_output.h>
#include <CGAL/Intrinsic_triangulations/IO/support/columns.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

std::vector<Column> vertex_labels(const Common_subdivision& s) {
  constexpr std::uint32_t none = Common_subdivision::none;
  const std::size_t n = s.number_of_vertices(), m = s.vertices.size(); // crossings follow
  const auto vertices = []<std::size_t k>(const Weighted_vertices& w,
                                          std::array<std::int32_t, k> all) {
    for (std::size_t i = 0; i < k; ++i) all[i] = signed_label(i < w.size ? w.vertices[i] : none);
    return all;
  };
  const auto weights = []<std::size_t k>(const Weighted_vertices& w, std::array<double, k> all) {
    for (std::size_t i = 0; i < k; ++i) all[i] = i < w.size ? w.weights[i] : 0;
    return all;
  };
  const auto numbered = [](const std::string& name, std::size_t k) {
    std::vector<std::string> result;
    for (std::size_t i = 0; i < k; ++i) result.push_back(name + std::to_string(i));
    return result;
  };
  using std::array;
  return {
      numbers("kind", n, [&s](std::size_t v) { return static_cast<std::uint8_t>(s.kind(v)); }),
      numbers(
          "input_face", n,
          [&s, m](std::size_t v) { return signed_label(v < m ? s.vertices[v].input_face : none); }),
      numbers("input_edge", n,
              [&s, m](std::size_t v) {
                return signed_label(v < m ? none : s.crossings[v - m].on_input.edge);
              }),
      numbers("intrinsic_edge", n,
              [&s, m](std::size_t v) {
                return signed_label(v < m ? none : s.crossings[v - m].on_intrinsic.edge);
              }),
      tuples("input_vertices", numbered("input_vertex_", 3), n,
             [&s, vertices](std::size_t v) {
               return vertices(s.on_input(v), array<std::int32_t, 3>());
             }),
      tuples("input_weights", numbered("input_weight_", 3), n,
             [&s, weights](std::size_t v) { return weights(s.on_input(v), array<double, 3>()); }),
      tuples("intrinsic_vertices", numbered("intrinsic_vertex_", 2), n,
             [&s, vertices](std::size_t v) {
               return vertices(s.on_intrinsic(v), array<std::int32_t, 2>());
             }),
      tuples(
          "intrinsic_weights", numbered("intrinsic_weight_", 2), n,
          [&s, weights](std::size_t v) { return weights(s.on_intrinsic(v), array<double, 2>()); })};
}

std::vector<std::string> component_names(const Subdivision_field& field) {
  if (field.components == 1) return {field.name};
  return {field.name + "_x", field.name + "_y", field.name + "_z"};
}

namespace {

// Whether files use a name themselves, at vertices or at faces.
bool is_label_name(std::string_view name, Subdivision_field::Place place) {
  constexpr std::array<std::string_view, 9> of_faces{"vertex_indices",
                                                     "input_face",
                                                     "intrinsic_face",
                                                     "intrinsic_edge",
                                                     "sheet",
                                                     "texcoord",
                                                     "red",
                                                     "green",
                                                     "blue"};
  if (place != Subdivision_field::Place::vertices) return std::ranges::count(of_faces, name) != 0;
  bool is_taken = name == "x" || name == "y" || name == "z";
  for (const Column& column : vertex_labels(Common_subdivision()))
    is_taken = is_taken || name == column.name || std::ranges::count(column.components, name) != 0;
  return is_taken;
}

bool is_field_name(const Subdivision_field& field) {
  constexpr std::string_view allowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.-";
  const auto is_taken = [&](const std::string& name) { return is_label_name(name, field.place); };
  return !is_taken(field.name) && std::ranges::none_of(component_names(field), is_taken) &&
         !field.name.empty() && field.name.find_first_not_of(allowed) == std::string::npos;
}

// Whether two fields of one place have a name in common.
bool share_a_name(const Subdivision_field& a, const Subdivision_field& b) {
  const std::vector<std::string> of_a = component_names(a), of_b = component_names(b);
  const auto is_at_vertices = [](const Subdivision_field& f) {
    return f.place == Subdivision_field::Place::vertices;
  };
  return is_at_vertices(a) == is_at_vertices(b) &&
         (a.name == b.name || std::ranges::find_first_of(of_a, of_b) != of_a.end());
}

std::pair<std::size_t, const char*> number_and_name(const Common_subdivision& s,
                                                    Subdivision_field::Place place) {
  if (place == Subdivision_field::Place::faces) return {s.number_of_faces(), "faces"};
  if (place == Subdivision_field::Place::corners) return {s.corner.size(), "corners"};
  return {s.number_of_vertices(), "vertices"};
}

void check_fields(const Subdivision_output& o) {
  for (std::size_t i = 0; i < o.fields.size(); ++i) {
    const Subdivision_field& field = o.fields[i];
    const std::string name = "the field \"" + field.name + "\" ";
    const auto fail = [&name](const std::string& what) {
      throw Invalid_input(Element_kind::none, 0, name + what);
    };
    if (field.components != 1 && field.components != 3)
      fail("has " + std::to_string(field.components) +
           " components; give numbers with 1, or vectors with 3");
    if (!is_field_name(field))
      fail("cannot be written under this name; name it with letters, digits and _.-, and not as "
           "labels of vertices or faces are named");
    for (std::size_t j = 0; j < i; ++j)
      if (share_a_name(o.fields[j], field)) fail("occurs twice; rename one of the two");
    if (field.place == Subdivision_field::Place::corners && field.components != 1)
      fail("has vectors at corners; give numbers there");
    const auto [n, elements] = number_and_name(o.s, field.place);
    if (field.values.size() != n * field.components)
      fail("has " + std::to_string(field.values.size()) + " values; give " +
           (field.components == 1 ? "one" : "three") + " for each of the " + std::to_string(n) +
           ' ' + elements + " of the common subdivision");
  }
}

} // namespace

void check_output(const Subdivision_output& o) {
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

} // namespace CGAL::Intrinsic_triangulations::internal
