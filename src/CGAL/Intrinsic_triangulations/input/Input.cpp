// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/Element_names.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/input/initial_values.h>

#include <cstdint>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

Input_definition::Input_definition() = default;
Input_definition::Input_definition(const Input_definition& other) = default;
Input_definition::Input_definition(Input_definition&& other) noexcept = default;
Input_definition& Input_definition::operator=(const Input_definition& other) = default;
Input_definition& Input_definition::operator=(Input_definition&& other) noexcept = default;
Input_definition::~Input_definition() = default;

Input_definition::Input_definition(Parts parts) : parts_(std::move(parts)) {}

Input::Input() = default;
Input::Input(const Input& other) = default;
Input::Input(Input&& other) noexcept = default;
Input& Input::operator=(const Input& other) = default;
Input& Input::operator=(Input&& other) noexcept = default;
Input::~Input() = default;

Input::Input(Gluing_map mesh, Parts parts)
    : Input_definition(std::move(parts)), mesh_(std::move(mesh)) {}

Input::Input(Gluing_map mesh, Input_metric metric, Input_names names)
    : Input_definition(
          Parts{mesh.number_of_vertices(), std::move(metric), std::move(names), {}, {}}),
      mesh_(std::move(mesh)) {}

bool Input::is_defined_by_metric() const {
  if (metric().number_of_faces() != number_of_faces()) return false;
  for (std::uint32_t f = 0; f < number_of_faces(); ++f) {
    std::uint32_t h = halfedge_of_face(f);
    for (const std::uint32_t name : metric().sides(f)) {
      if (name != metric().name(source(h), h / 2)) return false;
      h = next(h);
    }
  }
  return true;
}

double Input::defined_squared_length(std::uint32_t e) const {
  const std::uint32_t h = is_border(2 * e) ? 2 * e + 1 : 2 * e, first = halfedge_of_face(face(h));
  return metric().squared_length<double>(face(h), h == first ? 0 : h == next(first) ? 1 : 2);
}

double Input::defined_quadruple_area(std::uint32_t f) const {
  return Intrinsic_triangulations::quadruple_area<double>(metric(), f);
}

} // namespace CGAL::Intrinsic_triangulations
