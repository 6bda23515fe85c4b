// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"
#include "curve_arrays.h"
#include "places.h"

#include <CGAL/Intrinsic_geodesics/compiled.h>
#include <CGAL/Intrinsic_geodesics/cuts/Cut_surface.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_along.h>
#include <CGAL/Intrinsic_geodesics/cuts/flip_to_geodesic_cut.h>
#include <CGAL/Intrinsic_geodesics/isolines/isolines.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

// Isolines, and surfaces cut open along curves, as the command `cut` does it.

namespace python {

namespace {

struct Cut {
  std::shared_ptr<const IT::Input> input;
  IT::Cut_surface surface;
};

// Inserts curves into a copy of a triangulation, and cuts along them.
template <class T>
Cut cut_along_ways(T t, const std::vector<const Way*>& ways, Watch& watch) {
  IT::expect_one_sheet(t.input());
  std::vector<IT::Traced_curve> curves;
  for (const Way* way : ways) {
    expect_on_input(t.input(), way->curve, "curves[" + std::to_string(curves.size()) + "]");
    curves.push_back(way->curve);
  }
  watch.begin("curves");
  const auto labels = IT::insert_curves(t, curves);
  watch.begin("cut");
  return {t.shared_input(), IT::cut_along(t, labels)};
}

template <class T>
Cut cut_to_disks(T t, const std::vector<Place>& through, Watch& watch) {
  IT::expect_one_sheet(t.input());
  std::vector<typename T::vertex_descriptor> vertices;
  Place_finder<T> find(t);
  for (const Place& p : through) vertices.push_back(find.vertex(p.vertex));
  Watching visitor{&watch, "flips"};
  const auto cut =
      IT::flip_to_geodesic_cut(t, vertices, IT::parameters::visitor(std::ref(visitor)));
  watch.begin("cut");
  return {t.shared_input(), IT::cut_along(t, cut.edges)};
}

// Numbers of elements of the mesh; -1 is none.
py::array_t<std::int64_t> numbers_or_none(const std::vector<IT::Cut_surface::Vertex>& vertices,
                                          std::uint32_t IT::Cut_surface::Vertex::*number) {
  std::vector<std::int64_t> result;
  for (const IT::Cut_surface::Vertex& v : vertices)
    result.push_back(v.*number == IT::Gluing::none ? -1 : std::int64_t{v.*number});
  return array_of(std::move(result));
}

// The places of vertices as entries of a sparse matrix.
py::tuple weights_of(const std::vector<IT::Cut_surface::Vertex>& vertices) {
  std::vector<std::int64_t> rows, columns;
  std::vector<double> weights;
  for (std::size_t v = 0; v < vertices.size(); ++v)
    for (std::size_t k = 0; k < vertices[v].on_input.size; ++k) {
      rows.push_back(static_cast<std::int64_t>(v));
      columns.push_back(vertices[v].on_input.vertices[k]);
      weights.push_back(vertices[v].on_input.weights[k]);
    }
  return py::make_tuple(array_of(std::move(rows)), array_of(std::move(columns)),
                        array_of(std::move(weights)));
}

py::dict cut_arrays(const Cut& cut, const Points& coordinates) {
  const IT::Cut_surface& s = cut.surface;
  py::dict result;
  result["points"] = py::none();
  if (!coordinates.empty()) result["points"] = array_of(IT::positions(s, coordinates, *cut.input));
  const auto triples = [](const auto& numbers) { return whole(numbers).reshape({-1, 3}); };
  std::vector<std::uint32_t> labels;
  for (const IT::Cut_surface::Side& side : s.sides) labels.push_back(side.curve);
  result["faces"] = triples(s.gluing.origin);
  result["curve_of_side"] = triples(labels);
  result["original_vertex"] = whole(s.original_vertex);
  result["input_vertex"] = numbers_or_none(s.vertices, &IT::Cut_surface::Vertex::input_vertex);
  result["input_face"] = whole(s.input_face);
  result["component"] = whole(s.component);
  result["interpolation"] = weights_of(s.vertices);
  return result;
}

py::dict cut_network(const Surface& s, const Curve_edges& edges) {
  const Cut cut = [&] {
    const py::gil_scoped_release released;
    return Cut{edges.input, edges.cut()};
  }();
  return cut_arrays(cut, s.points);
}

py::dict cut_ways(Surface& s, const std::vector<const Way*>& ways, Watch& watch) {
  return cut_arrays(
      with_triangulation(s, watch,
                         [&]<class T>(const T& t) { return cut_along_ways<T>(t, ways, watch); }),
      s.points);
}

py::dict cut_to_disks_through(Surface& s, const Place_arrays& through, Watch& watch) {
  const std::vector<Place> places = places_of(s, through);
  for (const Place& p : places)
    if (!p.is_vertex())
      throw py::value_error("cuts pass through vertices; give no points in faces");
  return cut_arrays(
      with_triangulation(s, watch,
                         [&]<class T>(const T& t) { return cut_to_disks<T>(t, places, watch); }),
      s.points);
}

py::array_t<double> even_levels(const Doubles& u, std::size_t count) {
  return array_of(IT::even_levels({u.data(), static_cast<std::size_t>(u.size())}, count));
}

py::list isolines(Surface& s, const Doubles& u, const Doubles& l, Watch& watch) {
  Watching visitor{&watch, "levels", static_cast<std::uint64_t>(l.size())};
  std::shared_ptr<const IT::Input> input;
  std::vector<IT::Traced_isoline> lines;
  const std::span values(u.data(), static_cast<std::size_t>(u.size()));
  const std::span levels(l.data(), static_cast<std::size_t>(l.size()));
  with_triangulation(s, watch, [&](const auto& t) {
    input = t.shared_input();
    const auto np = IT::parameters::visitor(std::ref(visitor));
    const std::vector<IT::Isoline> found = IT::isolines(t, values, levels, np);
    visitor.stage = "lines";
    lines = IT::trace_isolines(t, found, np);
  });
  py::list result;
  for (IT::Traced_isoline& line : lines) {
    py::dict arrays =
        curve_arrays(*input, s.points, Way{std::move(line.curve), line.is_closed}, true);
    arrays["level"] = line.level;
    arrays["number_of_level"] = line.number_of_level;
    result.append(arrays);
  }
  return result;
}

} // namespace

void bind_cuts(py::module_& m) {
  m.def("isolines", isolines);
  m.def("even_levels", even_levels);
  m.def("cut_network", cut_network);
  m.def("cut_ways", cut_ways);
  m.def("cut_to_disks", cut_to_disks_through);
}

} // namespace python
