// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"
#include "curve_arrays.h"
#include "places.h"

#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Tangents_at_places.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_geodesic.h>

#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <complex>
#include <memory>
#include <variant>

// Geodesics from a point in a direction.

namespace python {

namespace {

/// A vector in space, or in the tangent plane of the point.
using Direction = std::variant<std::complex<double>, Point>;

py::dict trace(Surface& s, const Place_arrays& from, const Direction& direction, double length) {
  const Place p = places_of(s, from).at(0);
  Watch watch;
  std::shared_ptr<const IT::Input> input;
  const IT::Traced_curve curve = with_triangulation(s, watch, [&](const auto& t) {
    input = t.shared_input();
    IT::Tangents_at_places find(t, s.points);
    const IT::Tangent_vector start =
        std::visit([&](const auto& d) { return find.on_input(p, d); }, direction);
    if (!(std::hypot(start.vector[0], start.vector[1]) > 0))
      throw IT::Invalid_input(IT::Element_kind::none, 0,
                              "the direction is zero, or orthogonal to the face; give another");
    return IT::traced_curve(*input,
                            IT::trace_geodesic_on_input(t, start.point, start.vector, length));
  });
  return curve_arrays(*input, s.points, {curve, false});
}

} // namespace

void bind_traces(py::module_& m) { m.def("trace", trace); }

} // namespace python
