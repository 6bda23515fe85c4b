// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "places.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace python {

namespace {

std::uint32_t number_of(std::int64_t i, IT::Element_kind kind, const char* name) {
  if (i >= 0 && i < std::int64_t{IT::Gluing::none}) return static_cast<std::uint32_t>(i);
  throw IT::Invalid_input(kind, 0,
                          std::string("there is no ") + name + ' ' + std::to_string(i) +
                              "; numbers begin at 0");
}

[[noreturn]] void refuse_face(std::uint32_t f, const std::string& what) {
  throw IT::Invalid_input(IT::Element_kind::face, f, "face " + std::to_string(f) + what);
}

} // namespace

std::vector<Place> places_of(const Place_arrays& arrays) {
  const auto faces = std::get<0>(arrays).unchecked<1>();
  const auto weights = std::get<1>(arrays).unchecked<2>();
  const auto vertices = std::get<2>(arrays).unchecked<1>();
  if (faces.shape(0) != vertices.shape(0) || weights.shape(0) != vertices.shape(0) ||
      weights.shape(1) != 3)
    throw py::value_error("points need as many faces and triples of weights as vertices");
  std::vector<Place> result;
  for (py::ssize_t i = 0; i < vertices.shape(0); ++i) {
    Place p;
    if (vertices(i) != -1) {
      p.vertex = number_of(vertices(i), IT::Element_kind::vertex, "vertex");
    } else {
      p.face = number_of(faces(i), IT::Element_kind::face, "face");
      for (py::ssize_t k = 0; k < 3; ++k) p.weights[static_cast<std::size_t>(k)] = weights(i, k);
    }
    result.push_back(p);
  }
  return result;
}

IT::Surface_point point_on_input(const IT::Input& input, const Place& p) {
  const IT::Input_names& names = input.names();
  std::uint32_t triangle = p.face;
  if (const std::vector<std::uint32_t>& polygon = names.polygon_of_triangle; !polygon.empty()) {
    const auto [begin, end] = std::equal_range(polygon.begin(), polygon.end(), p.face);
    if (end - begin > names.sheets)
      refuse_face(p.face, " is a polygon, in which barycentric coordinates name no point; "
                          "triangulate it before");
    if (end == begin && p.face <= polygon.back())
      refuse_face(p.face, " has no three different vertices; choose another");
    triangle =
        end == begin ? IT::Gluing::none : static_cast<std::uint32_t>(begin - polygon.begin());
  }
  if (triangle >= input.number_of_faces()) refuse_face(p.face, " does not exist; choose another");
  return {input.halfedge_of_face(names.faces.here(triangle)), p.weights};
}

} // namespace python
