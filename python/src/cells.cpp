// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"
#include "curve_arrays.h"
#include "places.h"
#include "searches.h"

#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/distance/farthest_points.h>
#include <CGAL/Intrinsic_geodesics/voronoi/voronoi_cells.h>
#include <CGAL/Intrinsic_triangulations/connectivity/status_name.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

// What a surface is divided into by distances: the cells of sources, and samples of vertices.

namespace python {

namespace {

// The cells of sources, and what is drawn of them.
struct Found_cells {
  std::shared_ptr<const IT::Input> input;
  std::vector<double> distances;
  std::vector<std::int64_t> labels; // -1: no source can be reached
  IT::Voronoi_cells cells;
  std::vector<Way> boundaries;
  std::vector<IT::Surface_point> junctions; // on the input
};

template <class T>
Found_cells cells(Surface& s, const T& t, const std::vector<Place>& sources,
                  const std::vector<std::uint32_t>& cell_of_place, std::optional<double> tolerance,
                  Watch& watch) {
  Place_finder<T> find(t);
  std::vector<IT::Surface_point> points;
  std::vector<std::uint32_t> cell_of_source;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    find.append(sources[i], points);
    cell_of_source.resize(points.size(), cell_of_place[i]);
  }
  auto& search = distances_on(s, t).exact_search();
  Search_visitor visitor{&watch};
  search.search(points, IT::parameters::visitor(std::ref(visitor)));
  watch.begin("cells");
  const IT::Twin_points twins(t);
  Found_cells found{t.shared_input(), search.distances(), {}, {}, {}, {}};
  twins.copy(found.distances);
  found.cells =
      tolerance ? IT::voronoi_cells(search, cell_of_source, IT::parameters::tolerance(*tolerance))
                : IT::voronoi_cells(search, cell_of_source);
  found.labels.assign(found.distances.size(), -1);
  for (const auto v : vertices(t.mesh()))
    if (const std::uint32_t i = search.nearest_source(v); i != IT::Gluing::none)
      found.labels[t.input_vertex(v)] = cell_of_source[i];
  twins.copy(found.labels);
  for (const IT::Cell_boundary& b : found.cells.boundaries) {
    watch.begin("boundary");
    found.boundaries.push_back({IT::trace_boundary(t, b), b.is_closed});
  }
  for (const IT::Cell_junction& j : found.cells.junctions)
    found.junctions.push_back(search.is_on_faces() ? j.point
                                                   : IT::locate_on_input(t, j.point).value());
  distances_on(s, t).forget_exact_search();
  return found;
}

py::dict voronoi(Surface& s, const Place_arrays& sources, const std::vector<std::uint32_t>& cell,
                 std::optional<double> tolerance, const py::object& progress) {
  const std::vector<Place> places = places_of(s, sources);
  expect_sources(places);
  Watch watch(progress);
  Found_cells found = with_triangulation(
      s, watch, [&](const auto& t) { return cells(s, t, places, cell, tolerance, watch); });
  py::list boundaries, junctions;
  for (std::size_t i = 0; i < found.boundaries.size(); ++i) {
    py::dict line = curve_arrays(*found.input, s.points, found.boundaries[i], true);
    line["left"] = found.cells.boundaries[i].left;
    line["right"] = found.cells.boundaries[i].right;
    boundaries.append(line);
  }
  for (const IT::Cell_junction& j : found.cells.junctions) junctions.append(py::cast(j.sources));
  py::dict result;
  result["labels"] = array_of(std::move(found.labels));
  result["distances"] = array_of(std::move(found.distances));
  result["areas"] = array_of(std::move(found.cells.areas));
  result["boundaries"] = boundaries;
  result["junctions"] = point_arrays(*found.input, s.points, found.junctions);
  result["cells_at_junctions"] = junctions;
  result["status"] = IT::name_of(found.cells.status);
  return result;
}

// the vertices that are found, and the radius that they and the sources cover
template <class T>
std::pair<std::vector<std::int64_t>, double> farthest(const T& t, const std::vector<Place>& sources,
                                                      std::size_t count, Watch& watch) {
  auto search = IT::Polyhedral_distance<T>::on_faces(t);
  Search_visitor visitor{&watch};
  const auto observed = IT::parameters::visitor(std::ref(visitor));
  if (search.search(Place_finder<T>(t).points(sources), observed) == IT::Status::cancelled)
    return {};
  const auto found = IT::farthest_points(search, count, observed);
  std::vector<std::int64_t> rows;
  for (const auto v : found.vertices) rows.push_back(t.input_vertex(v));
  return {rows, found.radius};
}

py::tuple farthest_points(Surface& s, const Place_arrays& sources, std::size_t count,
                          const py::object& progress) {
  const std::vector<Place> places = places_of(s, sources);
  expect_sources(places);
  Watch watch(progress);
  auto [rows, radius] = with_triangulation(
      s, watch, [&](const auto& t) { return farthest(t, places, count, watch); });
  return py::make_tuple(array_of(std::move(rows)), radius);
}

} // namespace

void bind_cells(py::module_& m) {
  m.def("voronoi", voronoi);
  m.def("farthest_points", farthest_points);
}

} // namespace python
