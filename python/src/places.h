// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_PLACES_H
#define INTRINSIC_PYTHON_PLACES_H

#include "Surface.h"
#include "arrays.h"

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place_finder.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

// Points that the user gives: vertices, and places in faces of the mesh.

namespace python {

using IT::Place;
using IT::Place_finder;

/// The arrays that Python makes of points: faces, barycentric coordinates (n, 3), and vertices, -1
/// for points in faces.
using Place_arrays = std::tuple<Integers, Doubles, Integers>;

/// The same of one point, as numbers.
using Place_numbers = std::tuple<std::int64_t, std::array<double, 3>, std::int64_t>;

/// returns the number of an element. \throws Invalid_input if no element has it
inline std::uint32_t number_of(std::int64_t i, IT::Element_kind kind, const char* name) {
  if (i >= 0 && i < std::int64_t{IT::Gluing::none}) return static_cast<std::uint32_t>(i);
  throw IT::Invalid_input(kind, 0,
                          std::string("there is no ") + name + ' ' + std::to_string(i) +
                              "; numbers begin at 0");
}

/// returns the input of the triangulation of a surface, which never changes.
inline const IT::Input& input_of(const Surface& s) {
  return std::visit([](const auto& t) -> const IT::Input& { return t->input(); }, s.triangulation);
}

/// returns a point of a surface, normalized.
inline Place place_of(const Surface& s, const Place_numbers& p) {
  const auto& [face, weights, vertex] = p;
  return normalized(input_of(s),
                    vertex != -1
                        ? Place::at_vertex(number_of(vertex, IT::Element_kind::vertex, "vertex"))
                        : Place::in_face(number_of(face, IT::Element_kind::face, "face"), weights));
}

/// reads points of a surface, normalized.
inline std::vector<Place> places_of(const Surface& s, const Place_arrays& arrays) {
  const auto faces = std::get<0>(arrays).unchecked<1>();
  const auto weights = std::get<1>(arrays).unchecked<2>();
  const auto vertices = std::get<2>(arrays).unchecked<1>();
  if (faces.shape(0) != vertices.shape(0) || weights.shape(0) != vertices.shape(0) ||
      weights.shape(1) != 3)
    throw py::value_error("points need as many faces and triples of weights as vertices");
  std::vector<Place> result;
  for (py::ssize_t i = 0; i < vertices.shape(0); ++i)
    result.push_back(
        place_of(s, {faces(i), {weights(i, 0), weights(i, 1), weights(i, 2)}, vertices(i)}));
  return result;
}

} // namespace python

#endif // INTRINSIC_PYTHON_PLACES_H
