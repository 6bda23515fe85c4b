// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../../src/intrinsic/status_name.h"
#include "maps.h"

#include <CGAL/Intrinsic_operators/conformal/Prescribed_angles.h>
#include <CGAL/Intrinsic_operators/conformal/conformal_metric.h>
#include <CGAL/Intrinsic_operators/conformal/conformal_sphere.h>
#include <CGAL/Intrinsic_operators/conformal/flat_angles.h>
#include <CGAL/Intrinsic_operators/conformal/flat_surface.h>
#include <CGAL/Intrinsic_operators/conformal/flat_torus.h>
#include <CGAL/Intrinsic_operators/conformal/ideal_start.h>
#include <CGAL/Intrinsic_operators/conformal/lay_out_scaled.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Ideal_hyperbolic_traits.h>

#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Discrete conformal maps of surfaces of any topology.

namespace python {

namespace {

using namespace py::literals;

// The angles that vertices shall have: multiples of pi, other angles in radians, or free ones.
struct Asked_angles {
  std::vector<std::uint32_t> rows;
  std::vector<double> radians;          // not a number: free
  std::vector<std::int64_t> numerators; // of pi; the denominator 0: the angle is in radians
  std::vector<std::int64_t> denominators;

  void prescribe(IT::Prescribed_angles& angles) const {
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (denominators[i] > 0)
        angles.set(rows[i], IT::Multiple_of_pi{numerators[i], denominators[i]});
      else if (std::isnan(radians[i]))
        angles.set_free(rows[i]);
      else
        angles.set(rows[i], radians[i]);
  }
};

Asked_angles asked_angles(const Integers& rows, const Doubles& radians, const Integers& numerators,
                          const Integers& denominators) {
  constexpr std::size_t any = std::size_t{1} << 53;
  const auto size = static_cast<std::size_t>(rows.size());
  expect_size(radians, size, "angles");
  expect_size(numerators, size, "angles");
  expect_size(denominators, size, "angles");
  return {numbers_of(rows, IT::Gluing::none, "vertex"),
          std::vector<double>(radians.data(), radians.data() + size),
          numbers_of<std::int64_t>(numerators, any, "angle"),
          numbers_of<std::int64_t>(denominators, any, "angle")};
}

// How a surface shall become flat or round.
struct Asked_map {
  std::string target; // "plane", "sphere", "torus" or "disk"
  bool starts_from_input;
  std::optional<std::size_t> cones; // how many are placed
  Asked_angles angles;
};

struct Found_map {
  IT::Conformal_metric metric{};
  std::vector<double> u{};
  IT::Prescribed_angles angles{};
  std::optional<IT::Conformal_sphere> sphere{};
  std::optional<std::complex<double>> period{};
  std::optional<IT::Scaled_layout> layout{};
};

struct Metric_watch {
  Watch* watch;
  bool progress(const IT::Conformal_progress& p) { return (*watch)("iterations", p.iteration); }
};

template <class Ideal>
Found_map on_sphere(Ideal& ideal) {
  Found_map found;
  found.sphere = IT::conformal_sphere(ideal);
  found.metric = found.sphere->metric;
  found.u = IT::logarithmic_scale(ideal, found.sphere->layout);
  if (!std::ranges::all_of(found.u, [](double x) { return std::isfinite(x); }))
    refuse("vertices fall together on the sphere in doubles; take target=\"plane\" with cones");
  return found;
}

template <class T, class Ideal>
Found_map in_plane(const T& t, Ideal& ideal, const Asked_map& asked, Watch& watch) {
  IT::Flat_surface start = IT::flat_surface(ideal);
  Found_map found;
  found.angles = asked.cones ? IT::place_cones(ideal, *asked.cones) : IT::flat_angles(ideal);
  const bool is_hyperbolic = asked.target == "disk";
  for (std::size_t v = 0; is_hyperbolic && v < found.angles.size(); ++v)
    if (found.angles.is_free(v)) found.angles.set(v, IT::Multiple_of_pi{1, 1}); // geodesic border
  asked.angles.prescribe(found.angles);
  Metric_watch visitor{&watch};
  const auto np = IT::parameters::visitor(std::ref(visitor));
  found.metric = is_hyperbolic ? IT::hyperbolic_metric(ideal, found.angles, np)
                               : IT::conformal_metric(ideal, found.angles, np);
  found.u = found.metric.u;
  std::optional<IT::Flat_torus> torus;
  if (asked.target == "torus") torus = IT::flat_torus(IT::flat_surface(ideal));
  if (torus) found.period = torus->period;
  if (found.metric.status == IT::Status::cancelled) return found;
  IT::Scaled_surface scaled =
      IT::scaled_surface(ideal, std::move(start), found.metric.scale_factors, found.angles,
                         t.input().names(), is_hyperbolic);
  if (!asked.starts_from_input) IT::add_mesh(scaled, t, ideal);
  found.layout = IT::lay_out_scaled(scaled, torus ? &*torus : nullptr);
  return found;
}

template <class T>
Found_map found_map(const T& t, const Asked_map& asked, Watch& watch) {
  using Traits = std::conditional_t<T::Metric::is_exact, IT::Exact_ideal_hyperbolic_traits,
                                    IT::Ideal_hyperbolic_traits<double>>;
  using Ideal = IT::Intrinsic_triangulation<IT::Gluing_map, Traits, IT::Integer_coordinates>;
  if (!asked.starts_from_input && t.number_of_vertices() > t.input().number_of_rows())
    refuse("scale factors belong to the user's vertices, and others were inserted; give "
           "start=\"input\"");
  Ideal ideal(asked.starts_from_input ? IT::ideal_start(t.input()) : IT::ideal_start(t));
  return asked.target == "sphere" ? on_sphere(ideal) : in_plane(t, ideal, asked, watch);
}

py::dict dict_of_sphere(const IT::Conformal_sphere& s) {
  std::vector<Point> positions(s.layout.positions.begin(), s.layout.positions.end());
  return py::dict("positions"_a = array_of(std::move(positions)), "pole"_a = s.layout.pole,
                  "rounds"_a = s.rounds, "convex"_a = s.is_convex,
                  "injective"_a = s.layout.is_injective(),
                  "flipped_faces"_a = s.layout.flipped_faces);
}

// Vertices of the mesh, and where edges cross.
py::dict dict_of_layout(IT::Scaled_layout layout, const std::vector<Point>& points) {
  const IT::Common_subdivision& s = layout.layout.subdivision;
  std::vector<std::int64_t> vertex(s.number_of_vertices(), -1);
  for (std::size_t v = 0; v < s.vertices.size(); ++v)
    if (s.kind(v) == IT::Subdivision_vertex_kind::input)
      vertex[v] = s.vertices[v].on_input.vertices[0];
  std::vector<Point> at;
  if (!points.empty()) at = IT::positions(s, points);
  return py::dict("points"_a = array_of(std::move(at)), "vertices"_a = array_of(std::move(vertex)),
                  "corners"_a = array_of(std::vector<std::uint32_t>(s.corner)),
                  "begins"_a = array_of(std::vector<std::uint32_t>(s.face_begin)),
                  "input_faces"_a = array_of(std::vector<std::uint32_t>(s.input_face)),
                  "uv"_a = array_of(std::move(layout.layout.positions)),
                  "weights"_a = array_of(std::move(layout.layout.weights)),
                  "seams"_a = array_of(std::move(layout.seams)));
}

py::dict cones_of(const IT::Prescribed_angles& angles) {
  py::dict cones;
  for (std::size_t v = 0; v < angles.size(); ++v)
    if (!angles.is_free(v) && angles.radians(v) != IT::Multiple_of_pi().radians())
      cones[py::int_(v)] = angles.radians(v);
  return cones;
}

py::dict uniformize(Surface& s, const std::string& target, bool starts_from_input,
                    const std::optional<std::size_t>& cones, const Integers& rows,
                    const Doubles& radians, const Integers& numerators,
                    const Integers& denominators, const py::object& progress) {
  const Asked_map asked{target, starts_from_input, cones,
                        asked_angles(rows, radians, numerators, denominators)};
  Watch watch(progress);
  Found_map found =
      with_triangulation(s, watch, [&](auto& t) { return found_map(t, asked, watch); });
  const IT::Status status = found.sphere   ? found.sphere->status()
                            : found.layout ? found.layout->status(found.metric.status)
                                           : found.metric.status;
  py::dict result("u"_a = array_of(std::move(found.u)),
                  "scale_factors"_a = array_of(std::move(found.metric.scale_factors)),
                  "status"_a = program::name(status),
                  "iterations"_a = found.metric.iterations, "flips"_a = found.metric.flips,
                  "residual"_a = found.metric.residual,
                  "proven_residual"_a = found.metric.proven_residual,
                  "cones"_a = cones_of(found.angles), "period"_a = found.period);
  if (found.sphere) result["sphere"] = dict_of_sphere(*found.sphere);
  if (!found.layout) return result;
  result["certificate"] = dict_of(found.layout->certificate);
  result["distortion"] = dict_of(found.layout->distortion);
  result["layout"] = dict_of_layout(std::move(*found.layout), s.points);
  return result;
}

// Components with faces, the Euler characteristic of these, the number of border edges, and sheets.
py::tuple topology(Surface& s) {
  const std::array<std::ptrdiff_t, 4> numbers =
      with_triangulation(s, [](auto& t) -> std::array<std::ptrdiff_t, 4> {
        std::ptrdiff_t isolated = 0, border = 0;
        for (const auto v : vertices(t.mesh()))
          if (halfedge(v, t.mesh()).index == IT::Gluing::none) ++isolated;
        for (const auto h : halfedges(t.mesh()))
          if (face(h, t.mesh()).index == IT::Gluing::none) ++border;
        return {static_cast<std::ptrdiff_t>(IT::connected_components(t.mesh()).count),
                IT::euler_characteristic(t.mesh()) - isolated, border,
                static_cast<std::ptrdiff_t>(t.input().names().sheets)};
      });
  return py::make_tuple(numbers[0], numbers[1], numbers[2], numbers[3]);
}

} // namespace

void bind_uniformize(py::module_& m) {
  m.def("uniformize", &uniformize);
  m.def("topology", &topology);
}

} // namespace python
