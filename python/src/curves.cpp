// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"
#include "curve_arrays.h"
#include "places.h"

#include <CGAL/Intrinsic_geodesics/compiled.h>
#include <CGAL/Intrinsic_geodesics/finding/Repeated_curve_finder.h>
#include <CGAL/Intrinsic_geodesics/finding/find_curves.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Tangents_at_places.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

// Curves on surfaces: geodesics as the command `geodesic` finds them.

namespace python {

namespace {

// What was found, without the triangulation.
struct Found {
  std::shared_ptr<const IT::Input> input;
  std::shared_ptr<IT::Found_curves> curves;
  std::shared_ptr<Curve_edges> edges; // null if curves are no edges, or these are not wanted
};

// Finds curves whose edges are not wanted, by what is kept from call to call.
template <class T>
Found find_ways(Surface& s, const T& t, const std::vector<IT::Wanted_curve>& wanted,
                const IT::Find_curves_options& options) {
  using Finder = IT::Repeated_curve_finder<T>;
  auto& find = s.cached<Finder>("curves", [&] { return std::make_unique<Finder>(t); });
  return {t.shared_input(), std::make_shared<IT::Found_curves>(find(wanted, options)), nullptr};
}

// Finds curves on a copy of a triangulation, which cuts keep.
template <class T>
Found find_on_copy(const T& t, const std::vector<IT::Wanted_curve>& wanted,
                   const IT::Find_curves_options& options) {
  const auto copy = std::make_shared<T>(t);
  const auto found =
      std::make_shared<IT::Curves_along_edges<T>>(IT::find_curves(*copy, wanted, options));
  Found result{copy->shared_input(), found, nullptr};
  if (std::ranges::none_of(found->curves, &IT::Found_curve::is_on_faces))
    result.edges = std::make_shared<Curve_edges>(
        Curve_edges{result.input, [copy, found] { return IT::cut_along(*copy, *found); }});
  return result;
}

// \param keeps_edges whether the curves may be cut along
py::dict curves(Surface& s, const std::vector<std::pair<Place_arrays, bool>>& asked,
                bool is_shortest, bool stays_at_points, bool is_certified, bool keeps_edges,
                Watch& watch) {
  std::vector<IT::Wanted_curve> wanted;
  for (const auto& [points, is_loop] : asked)
    wanted.push_back({places_of(s, points), is_loop, stays_at_points});
  IT::Find_curves_options options;
  options.is_along_edges = !is_shortest;
  options.is_certified = is_certified;
  options.progress = [&](IT::Curve_stage stage, std::uint64_t count) {
    return watch(stage == IT::Curve_stage::paths_on_faces ? "windows" : "flips", count);
  };
  Found found = with_triangulation(s, watch, [&]<class T>(const T& t) {
    return keeps_edges ? find_on_copy(t, wanted, options) : find_ways(s, t, wanted, options);
  });
  py::list list;
  for (IT::Found_curve& c : found.curves->curves) {
    py::dict curve = curve_arrays(*found.input, s.points, {std::move(c.way), c.is_closed()});
    curve["initial_length"] = c.initial_length;
    list.append(curve);
  }
  py::dict result;
  result["curves"] = list;
  result["status"] = IT::name_of(found.curves->shortening.status);
  result["flips"] = found.curves->shortening.flips;
  result["is_certified"] =
      is_certified ? py::object(py::bool_(found.curves->is_certified)) : py::none();
  result["obstacle"] =
      found.curves->obstacle.empty() ? py::object(py::none()) : py::str(found.curves->obstacle);
  result["edges"] = found.edges;
  return result;
}

// ---- Geodesics from a point in a direction ------------------------------------------------------

// A vector in space, or in the tangent plane of the point.
using Direction = std::variant<std::complex<double>, Point>;

py::dict trace(Surface& s, const Place_numbers& from, const Direction& direction, double length) {
  const Place p = place_of(s, from);
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

void bind_cuts(py::module_& m);

void bind_curves(py::module_& m) {
  bind_way(m);
  py::class_<Curve_edges, std::shared_ptr<Curve_edges>>(m, "CurveEdges");
  m.def("curves", curves);
  bind_cuts(m);
  m.def("trace", trace);
}

} // namespace python
