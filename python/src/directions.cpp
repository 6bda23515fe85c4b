// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "curve_arrays.h"
#include "fields.h"

#include <CGAL/Intrinsic_geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_operators/distance/Heat_solver.h>
#include <CGAL/Intrinsic_operators/distance/Signed_heat_distance.h>
#include <CGAL/Intrinsic_operators/distance/curve_sources.h>
#include <CGAL/Intrinsic_operators/distance/distance_sources.h>
#include <CGAL/Intrinsic_operators/operators/connection_laplacian.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>

#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

// Direction fields and signed distances.

namespace python {

namespace {

py::tuple connection_laplacian(Surface& s, int degree) {
  return array_of(
      with_triangulation(s, [&](auto& t) { return IT::connection_laplacian(t, degree); }));
}

// ---- Direction fields --------------------------------------------------------------------------

py::tuple direction_field(Surface& s, int degree, const std::optional<double>& strength,
                          const Place_arrays& places, const Doubles& vectors, std::size_t neighbors,
                          const std::string& solver, Watch& watch) {
  const IT::Given_vectors fixed = given_vectors(places_of(s, places), vectors);
  IT::Vector_options options = vector_options(1, neighbors, watch);
  options.solver = IT::solver_named(solver);
  IT::Found_directions found = with_triangulation(s, watch, [&](auto& t) {
    return vectors_on(s, t).directions(degree, strength, fixed, options);
  });
  const IT::Input& input = input_of(s);
  std::vector<std::int64_t> faces; // the user's, at centres of singular faces
  std::vector<Point> weights, points;
  std::vector<int> index;
  for (const auto& [p, i] : found.centres) {
    const std::uint32_t face = input.face(p.halfedge);
    faces.push_back(input.names().polygon(face));
    weights.push_back(IT::seen_from(input, p, input.halfedge_of_face(face)).weights);
    if (!s.points.empty()) points.push_back(IT::point_in_space(input, p, s.points));
    index.push_back(i);
  }
  return py::make_tuple(static_cast<Field>(found), array_of(std::move(found.index)),
                        array_of(std::move(faces)), array_of(std::move(weights)),
                        array_of(std::move(points)), array_of(std::move(index)), found.index_sum,
                        found.border_turns);
}

// ---- Signed distances --------------------------------------------------------------------------

// Curves that the user gives: ways through faces, places to go straight between, or lists of
// vertices to follow edges between.
using Signed_curves =
    std::vector<std::variant<Way, std::vector<Place>, std::vector<std::uint32_t>>>;

// From edges of the triangulation if all are lists of vertices, as the program does, else from
// pieces in its faces.
template <class T>
Eigen::VectorXd signed_distances(const T& t, const Signed_curves& curves,
                                 IT::Signed_heat_distance<T>& method) {
  std::vector<std::vector<typename T::halfedge_descriptor>> edges;
  std::vector<IT::Polyline_source> pieces;
  Place_finder<T> vertices(t);
  const auto append = [&](const std::vector<IT::Polyline_source>& more) {
    pieces.insert(pieces.end(), more.begin(), more.end());
  };
  for (std::size_t i = 0; i < curves.size(); ++i) {
    std::string name = "curves[" + std::to_string(i);
    name += ']';
    if (const Way* way = std::get_if<Way>(&curves[i])) {
      expect_on_input(t.input(), way->curve, name);
      append(IT::polyline_sources(t, way->curve));
    } else if (const auto* places = std::get_if<std::vector<Place>>(&curves[i]))
      append(IT::polyline_sources(t, naming(name, [&] { return IT::curve_through(t, *places); })));
    else {
      std::vector<typename T::vertex_descriptor> points;
      for (const std::uint32_t row : std::get<std::vector<std::uint32_t>>(curves[i]))
        points.push_back(vertices.vertex(row));
      edges.push_back(IT::Edge_path_finder<T>(t).through(points));
    }
  }
  if (edges.size() == curves.size()) return method.distances(edges);
  for (const auto& curve : edges) append(IT::edge_sources(t, curve));
  return method.distances(pieces);
}

// Asks during steps of matrices that a surface keeps, on behalf of the call that uses them.
struct Matrices_watch {
  Surface* surface;
  bool progress(IT::Heat_step) { return (*surface->watch)("matrices"); }
};

py::array_t<double>
signed_distance(Surface& s, const std::vector<std::variant<Way, Place_arrays, Integers>>& given,
                double time_factor, Watch& watch) {
  Signed_curves curves;
  for (const auto& c : given)
    if (const Way* way = std::get_if<Way>(&c))
      curves.emplace_back(*way);
    else if (const auto* places = std::get_if<Place_arrays>(&c))
      curves.emplace_back(places_of(s, *places));
    else
      curves.emplace_back(
          numbers_of(std::get<Integers>(c), std::numeric_limits<std::uint32_t>::max(), "vertex"));
  return array_of(with_triangulation(s, watch, [&]<class T>(const T& t) {
    using Method = IT::Signed_heat_distance<T>;
    struct Kept { // for one time
      double time_factor;
      Method method;
    };
    const std::string key = "signed distance";
    const auto make = [&] {
      const auto factor = IT::parameters::time_factor(time_factor);
      return new Kept{time_factor, Method(t, factor.visitor(Matrices_watch{&s}))};
    };
    if (s.cached<Kept>(key, make).time_factor != time_factor) s.cache.erase(key);
    Method& method = s.cached<Kept>(key, make).method;
    Eigen::VectorXd result = signed_distances(t, curves, method);
    if (method.status() == IT::Status::cancelled) s.cache.erase(key);
    return result;
  }));
}

} // namespace

void bind_directions(py::module_& m) {
  m.def("connection_laplacian", &connection_laplacian);
  m.def("direction_field", &direction_field);
  m.def("signed_distance", &signed_distance);
}

} // namespace python
