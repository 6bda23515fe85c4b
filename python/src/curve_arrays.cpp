// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "curve_arrays.h"

#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>

namespace python {

namespace {

// The vertices of the user at the corners of a face, from a halfedge of it.
std::array<std::int64_t, 3> corners_from(const IT::Input& input, std::uint32_t h) {
  std::array<std::int64_t, 3> result{};
  for (std::int64_t& v : result) {
    v = input.names().row(input.source(h));
    h = input.next(h);
  }
  return result;
}

} // namespace

std::vector<IT::Polyline> polylines_of(const py::handle& curves) {
  std::vector<IT::Polyline> result;
  for (const py::handle item : curves) {
    const auto [points, is_closed, label] = item.cast<std::tuple<Doubles, bool, std::int32_t>>();
    result.push_back({points_of(points), is_closed, label});
  }
  return result;
}

void expect_on_input(const IT::Input& input, const IT::Traced_curve& curve,
                     const std::string& name) {
  const auto is_there = [&](const IT::Surface_point& p) {
    return p.halfedge < input.number_of_halfedges();
  };
  const auto is_face = [&](std::uint32_t f) { return f < input.number_of_faces(); };
  if (curve.faces.size() + 1 < curve.points.size() ||
      !std::ranges::all_of(curve.points, is_there) || !std::ranges::all_of(curve.faces, is_face))
    refuse(name + " is a curve of another surface; give one of this surface");
}

py::dict point_arrays(const IT::Input& input, const Points& coordinates,
                      const std::vector<IT::Surface_point>& points,
                      const std::vector<std::uint32_t>& faces) {
  Points in_space_all, barycentric;
  std::vector<std::array<std::int64_t, 3>> corners;
  std::vector<std::int64_t> polygons, vertices;
  in_space_all.reserve(coordinates.empty() ? 0 : points.size());
  barycentric.reserve(points.size());
  corners.reserve(points.size());
  polygons.reserve(points.size());
  vertices.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t face = faces.empty() ? input.face(points[i].halfedge) : faces[i];
    const IT::Surface_point p = IT::seen_in_face(input, points[i], face);
    if (!coordinates.empty())
      in_space_all.push_back(IT::point_in_space(input, points[i], coordinates));
    polygons.push_back(input.names().polygon(input.face(p.halfedge)));
    corners.push_back(corners_from(input, p.halfedge));
    barycentric.push_back(p.weights);
    std::int64_t vertex = -1; // unless two weights are zero
    for (std::size_t k = 0; k < 3; ++k)
      if (p.weights[(k + 1) % 3] == 0 && p.weights[(k + 2) % 3] == 0) vertex = corners.back()[k];
    vertices.push_back(vertex);
  }
  py::dict result;
  result["points"] =
      coordinates.empty() ? py::object(py::none()) : py::object(array_of(std::move(in_space_all)));
  result["faces"] = array_of(std::move(polygons));
  result["barycentric"] = array_of(std::move(barycentric));
  result["corners"] = array_of(std::move(corners));
  result["vertices"] = array_of(std::move(vertices));
  return result;
}

namespace {

// What a way is made of, for pickle.
py::tuple parts_of(const Way& way) {
  std::vector<std::uint32_t> halfedges;
  Points weights;
  for (const IT::Surface_point& p : way.curve.points) {
    halfedges.push_back(p.halfedge);
    weights.push_back(p.weights);
  }
  return py::make_tuple(static_cast<int>(way.curve.status), way.is_closed, way.curve.length,
                        way.curve.length_enclosure.inf(), way.curve.length_enclosure.sup(),
                        array_of(std::move(halfedges)), array_of(std::move(weights)),
                        array_of(std::vector<std::uint32_t>(way.curve.faces)));
}

Way way_of(const py::tuple& state) {
  const auto numbers = [&](std::size_t i) {
    const Integers a = state[i].cast<Integers>();
    return std::vector<std::uint32_t>(a.data(), a.data() + a.size());
  };
  Way way;
  way.curve.status = static_cast<IT::Status>(state[0].cast<int>());
  way.is_closed = state[1].cast<bool>();
  way.curve.length = state[2].cast<double>();
  way.curve.length_enclosure = {state[3].cast<double>(), state[4].cast<double>()};
  const std::vector<std::uint32_t> halfedges = numbers(5);
  const Points weights = points_of(state[6].cast<Doubles>());
  for (std::size_t i = 0; i < halfedges.size(); ++i)
    way.curve.points.push_back({halfedges[i], weights.at(i)});
  way.curve.faces = numbers(7);
  return way;
}

} // namespace

void bind_way(py::module_& m) {
  const py::class_<Way> way(m, "Way");
  m.def("parts_of_way", &parts_of);
  m.def("way_of_parts", &way_of);
}

// Keeps one of consecutive points that are in the same place: the last, with the face where the
// curve goes on.
static void drop_repetitions(const IT::Input& input, const Points& coordinates, bool is_closed,
                             std::vector<IT::Surface_point>& points,
                             std::vector<std::uint32_t>& faces) {
  std::vector<std::array<double, 3>> places;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::array<double, 3> x = IT::point_in_space(input, points[i], coordinates);
    if (kept == 0 || places.back() != x) {
      places.push_back(x);
      ++kept;
    }
    points[kept - 1] = points[i];
    faces[kept - 1] = faces[i];
  }
  if (is_closed && kept > 1 && places.back() == places.front()) --kept;
  points.resize(kept);
  faces.resize(kept);
}

py::dict curve_arrays(const IT::Input& input, const Points& coordinates, Way way,
                      bool drops_repetitions) {
  std::vector<IT::Surface_point> points = way.curve.points;
  std::vector<std::uint32_t> faces = way.curve.faces;
  if (way.is_closed && points.size() > 1) points.pop_back();
  if (!faces.empty()) faces.resize(points.size(), faces.back());
  if (drops_repetitions && !coordinates.empty() && !faces.empty())
    drop_repetitions(input, coordinates, way.is_closed, points, faces);
  py::dict result = point_arrays(input, coordinates, points, faces);
  result["length"] = way.curve.length;
  result["bounds"] =
      py::make_tuple(way.curve.length_enclosure.inf(), way.curve.length_enclosure.sup());
  result["is_closed"] = way.is_closed;
  result["status"] = IT::name_of(way.curve.status);
  result["way"] = std::move(way);
  return result;
}

} // namespace python
