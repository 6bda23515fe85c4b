// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "maps.h"

#include <CGAL/Intrinsic_conformal/angles/Prescribed_angles.h>
#include <CGAL/Intrinsic_conformal/maps/uniformize.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

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

constexpr std::array<std::pair<const char*, IT::Uniform_target>, 4> targets{
    {{"plane", IT::Uniform_target::plane},
     {"sphere", IT::Uniform_target::sphere},
     {"torus", IT::Uniform_target::torus},
     {"disk", IT::Uniform_target::disk}}};

IT::Uniform_target target_of(const std::optional<std::string>& name) {
  if (!name) return IT::Uniform_target::automatic;
  return std::ranges::find(targets, *name, [](const auto& t) { return std::string(t.first); })
      ->second;
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

py::dict cones_of(const IT::Uniformization& found) {
  py::dict cones;
  for (const std::uint32_t v : found.cones()) cones[py::int_(v)] = found.angles.radians(v);
  return cones;
}

py::dict dict_of_map(IT::Uniformization found, const std::vector<Point>& points) {
  py::dict result(
      "target"_a =
          std::ranges::find(targets, found.target, &decltype(targets)::value_type::second)->first,
      "u"_a = array_of(std::move(found.u)),
      "scale_factors"_a = array_of(std::move(found.scale_factors)),
      "status"_a = IT::name_of(found.status), "iterations"_a = found.metric.iterations,
      "flips"_a = found.metric.flips, "residual"_a = found.metric.residual,
      "proven_residual"_a = found.metric.proven_residual, "cones"_a = cones_of(found),
      "period"_a = found.period);
  if (!found.no_layout.empty()) result["no_layout"] = found.no_layout;
  if (found.sphere) result["sphere"] = dict_of_sphere(*found.sphere);
  if (!found.layout) return result;
  result["certificate"] = dict_of(found.layout->certificate);
  result["certificate"]["without_area"] = found.layout->without_area;
  result["distortion"] = dict_of(found.layout->distortion);
  result["layout"] = dict_of_layout(std::move(*found.layout), points);
  return result;
}

py::dict uniformize(Surface& s, const std::optional<std::string>& target, bool starts_from_input,
                    const std::optional<std::size_t>& cones, const Integers& rows,
                    const Doubles& radians, const Integers& numerators,
                    const Integers& denominators, Watch& watch) {
  const Asked_angles asked = asked_angles(rows, radians, numerators, denominators);
  IT::Uniformize_options options;
  options.target = target_of(target);
  options.start = starts_from_input ? IT::Uniform_start::input : IT::Uniform_start::delaunay;
  options.cones = cones;
  if (!asked.rows.empty())
    options.prescribe = [&asked](IT::Prescribed_angles& angles) { asked.prescribe(angles); };
  options.progress = [&watch](const IT::Conformal_progress& p) {
    return watch("iterations", p.iteration);
  };
  return dict_of_map(
      with_triangulation(s, watch, [&](auto& t) { return IT::uniformize(t, options); }), s.points);
}

// Refuses surfaces that are no disks.
void expect_disks(Surface& s) {
  with_triangulation(s, [](auto& t) { IT::expect_disks(t.input()); });
}

} // namespace

void bind_uniformize(py::module_& m) {
  m.def("uniformize", &uniformize);
  m.def("expect_disks", &expect_disks);
}

} // namespace python
