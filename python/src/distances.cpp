// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"
#include "curve_arrays.h"
#include "places.h"

#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/distance/farthest_points.h>
#include <CGAL/Intrinsic_geodesics/voronoi/voronoi_cells.h>
#include <CGAL/Intrinsic_operators/distance/Distances.h>
#include <CGAL/Intrinsic_operators/distance/divide_among.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

// Distances on surfaces: all on the Delaunay triangulation of a surface.

namespace python {

namespace {

using Method = IT::Distance_options;

// returns what finds distances on the triangulation of a surface, which keeps it.
template <class T>
IT::Distances<T>& distances_on(Surface& s, const T& t) {
  return s.cached<IT::Distances<T>>("distances",
                                    [&] { return std::make_unique<IT::Distances<T>>(t); });
}

// \throws ValueError if there is no source
void expect_sources(const std::vector<Place>& sources) {
  if (sources.empty()) throw py::value_error("distances need a source; give one at least");
}

// Lets a search ask whether to go on.
void watch_steps(Method& method, Watch& watch) {
  method.progress = [&watch](IT::Distance_step step, std::uint64_t done, std::uint64_t all) {
    return watch(step == IT::Distance_step::windows    ? "windows"
                 : step == IT::Distance_step::matrices ? "matrices"
                 : step == IT::Distance_step::cells    ? "cells"
                                                       : "parts",
                 done, all);
  };
}

// Calls a function with what finds the distances of a surface.
template <class Function>
auto with_distances(Surface& s, Method& method, std::size_t threads, Watch& watch,
                    const Function& function) {
  method.number_of_threads = threads;
  watch_steps(method, watch);
  return with_triangulation(s, watch, [&](const auto& t) { return function(distances_on(s, t)); });
}

py::tuple distance(Surface& s, const Place_arrays& sources,
                   const std::optional<Place_arrays>& targets, Method method, Watch& watch) {
  const std::vector<Place> from = places_of(s, sources);
  const std::vector<Place> to = targets ? places_of(s, *targets) : std::vector<Place>();
  IT::Found_distances found =
      with_distances(s, method, 0, watch, [&](auto& find) { return find.from(from, method, to); });
  return py::make_tuple(array_of(std::move(targets ? found.at_targets : found.by_row)),
                        IT::name_of(found.status));
}

template <class Number>
std::string fill(Surface& s, const std::vector<std::vector<Place>>& sets, Method& method,
                 std::size_t threads, py::array_t<Number> out, Watch& watch) {
  if ((out.flags() & py::array::c_style) == 0 || !out.writeable())
    throw py::value_error("out must be a writable array in C order");
  const std::span<Number> numbers(out.mutable_data(), static_cast<std::size_t>(out.size()));
  return IT::name_of(with_distances(
      s, method, threads, watch, [&](auto& find) { return find.columns(sets, numbers, method); }));
}

std::string distances(Surface& s, const Place_arrays& sources, const std::vector<std::size_t>& ends,
                      Method method, std::size_t threads, const py::array& out, Watch& watch) {
  const std::vector<Place> all = places_of(s, sources);
  std::vector<std::vector<Place>> sets;
  auto from = all.begin();
  for (const std::size_t end : ends) {
    const auto to = all.begin() + static_cast<std::ptrdiff_t>(end);
    sets.emplace_back(from, to);
    from = to;
  }
  if (py::isinstance<py::array_t<double>>(out))
    return fill<double>(s, sets, method, threads, out, watch);
  if (py::isinstance<py::array_t<float>>(out))
    return fill<float>(s, sets, method, threads, out, watch);
  throw py::value_error("out must have the type float64 or float32");
}

py::array_t<double> pair_distances(Surface& s, const Place_arrays& first,
                                   const Place_arrays& second, Method method, std::size_t threads,
                                   Watch& watch) {
  const std::vector<Place> from = places_of(s, first), to = places_of(s, second);
  return array_of(with_distances(s, method, threads, watch,
                                 [&](auto& find) { return find.of_pairs(from, to, method); }));
}

// ---- Cells of sources, and samples of vertices --------------------------------------------------

// The cells of sources, and what is drawn of them.
struct Drawn_cells {
  std::shared_ptr<const IT::Input> input;
  IT::Found_cells found;
  std::vector<Way> boundaries;
  std::vector<IT::Surface_point> junctions; // on the input
};

template <class T>
Drawn_cells cells(IT::Distances<T>& find, const T& t, const std::vector<std::vector<Place>>& sets,
                  std::optional<double> tolerance, const Method& method, Watch& watch) {
  Drawn_cells drawn{t.shared_input(), IT::divide_among(find, sets, tolerance, method), {}, {}};
  for (const IT::Cell_boundary& b : drawn.found.cells.boundaries) {
    watch.begin("boundary");
    drawn.boundaries.push_back({IT::trace_boundary(t, b), b.is_closed});
  }
  for (const IT::Cell_junction& j : drawn.found.cells.junctions)
    drawn.junctions.push_back(
        find.exact_search().is_on_faces() ? j.point : IT::locate_on_input(t, j.point).value());
  find.forget_exact_search();
  return drawn;
}

py::dict voronoi(Surface& s, const Place_arrays& sources, const std::vector<std::uint32_t>& cell,
                 std::optional<double> tolerance, Watch& watch) {
  const std::vector<Place> places = places_of(s, sources);
  expect_sources(places);
  std::vector<std::vector<Place>> sets(cell.back() + std::size_t{1});
  for (std::size_t i = 0; i < places.size(); ++i) sets[cell[i]].push_back(places[i]);
  Method method;
  watch_steps(method, watch);
  Drawn_cells drawn = with_triangulation(s, watch, [&](const auto& t) {
    return cells(distances_on(s, t), t, sets, tolerance, method, watch);
  });
  py::list boundaries, junctions;
  for (std::size_t i = 0; i < drawn.boundaries.size(); ++i) {
    py::dict line = curve_arrays(*drawn.input, s.points, drawn.boundaries[i], true);
    line["left"] = drawn.found.cells.boundaries[i].left;
    line["right"] = drawn.found.cells.boundaries[i].right;
    boundaries.append(line);
  }
  for (const IT::Cell_junction& j : drawn.found.cells.junctions)
    junctions.append(py::cast(j.sources));
  py::dict result;
  result["labels"] = array_of(std::move(drawn.found.nearest));
  result["distances"] = array_of(std::move(drawn.found.by_row));
  result["areas"] = array_of(std::move(drawn.found.cells.areas));
  result["boundaries"] = boundaries;
  result["junctions"] = point_arrays(*drawn.input, s.points, drawn.junctions);
  result["cells_at_junctions"] = junctions;
  result["status"] = IT::name_of(drawn.found.cells.status);
  return result;
}

// the vertices that are found, and the radius that they and the sources cover
template <class T>
std::pair<std::vector<std::int64_t>, double> farthest(const T& t, const std::vector<Place>& sources,
                                                      std::size_t count, Watch& watch) {
  auto search = IT::Polyhedral_distance<T>::on_faces(t);
  Watching visitor{&watch, "windows"};
  const auto observed = IT::parameters::visitor(std::ref(visitor));
  if (search.search(Place_finder<T>(t).points(sources), observed) == IT::Status::cancelled)
    return {};
  const auto found = IT::farthest_points(search, count, observed);
  std::vector<std::int64_t> rows;
  for (const auto v : found.vertices) rows.push_back(t.input_vertex(v));
  return {rows, found.radius};
}

py::tuple farthest_points(Surface& s, const Place_arrays& sources, std::size_t count,
                          Watch& watch) {
  const std::vector<Place> places = places_of(s, sources);
  expect_sources(places);
  auto [rows, radius] = with_triangulation(
      s, watch, [&](const auto& t) { return farthest(t, places, count, watch); });
  return py::make_tuple(array_of(std::move(rows)), radius);
}

} // namespace

void bind_distances(py::module_& m) {
  py::class_<Method>(m, "DistanceMethod")
      .def(py::init([](bool is_exact, double maximum, double time_factor) {
        return Method{is_exact ? IT::Distance_method::exact : IT::Distance_method::heat, maximum,
                      time_factor};
      }));
  m.def("distance", distance);
  m.def("distances", distances);
  m.def("pair_distances", pair_distances);
  m.def("voronoi", voronoi);
  m.def("farthest_points", farthest_points);
}

} // namespace python
