// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "asked_vectors.h"
#include "curve_arrays.h"
#include "fields.h"
#include "kept_heat.h"

#include <CGAL/Intrinsic_geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_operators/distance/Signed_heat_distance.h>
#include <CGAL/Intrinsic_operators/distance/curve_sources.h>
#include <CGAL/Intrinsic_operators/distance/distance_sources.h>
#include <CGAL/Intrinsic_operators/operators/connection_laplacian.h>
#include <CGAL/Intrinsic_operators/vectors/copies_of_rows.h>
#include <CGAL/Intrinsic_operators/vectors/direction_field.h>
#include <CGAL/Intrinsic_operators/vectors/field_singularities.h>
#include <CGAL/Intrinsic_operators/vectors/principal_directions.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>

#include <pybind11/stl.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
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

// A field of directions, and where it is singular.
struct Directions {
  Field field{};
  std::vector<int> index{};          // of each face of the triangulation
  std::vector<std::int64_t> faces{}; // the user's, at centres of singular faces
  std::vector<Point> weights{};
  std::vector<Point> points{};
  std::vector<int> singular{}; // their indices
  std::ptrdiff_t sum = 0;
  int border_turns = 0;
};

constexpr const char* solving = "factorization and solutions";

template <class T>
IT::Direction_field
smooth_field(const T& t, const Surface& s, int degree, const std::optional<double>& strength,
             const std::vector<std::pair<typename T::vertex_descriptor, Complex>>& fixed,
             Watch& watch) {
  Watching visitor{&watch, solving};
  const auto np = IT::parameters::visitor(std::ref(visitor));
  if (!strength) return IT::smoothest_direction_field(t, degree, fixed, np);
  if (degree % 2 != 0)
    refuse("directions of curvature have no sign; with align, give an even degree: 2 for lines, 4 "
           "for crosses");
  if (s.points.empty())
    refuse("a surface with lengths alone has no directions of curvature; leave align out");
  return IT::aligned_direction_field(t, degree, IT::principal_directions(t, s.points), *strength,
                                     fixed, np);
}

// Finds the centres of the faces with an index other than 0.
template <class T>
void add_singularities(const T& t, const std::vector<Point>& points, Directions& d) {
  for (const auto f : faces(t.mesh())) {
    const int i = d.index[t.index(f)];
    if (i == 0) continue;
    const auto p = IT::locate_on_input(
        t, {t.numbers().halfedge(halfedge(f, t.mesh())), {1. / 3, 1. / 3, 1. / 3}});
    if (!p) continue;
    const std::uint32_t face = t.input().face(p->halfedge);
    d.faces.push_back(t.input().names().polygon(face));
    d.weights.push_back(IT::seen_from(t.input(), *p, t.input().halfedge_of_face(face)).weights);
    d.singular.push_back(i);
    if (!points.empty()) d.points.push_back(IT::point_in_space(t, *p, points));
  }
}

template <class T>
Directions cloud_directions(Surface& s, const T& t, int degree,
                            const std::optional<double>& strength, const Asked_vectors& asked,
                            std::size_t neighbors, Watch& watch) {
  if (strength)
    refuse("align needs curvature, which a cloud of points does not have; leave it out");
  const IT::Point_cloud_vectors& cloud = cloud_vectors(s, t, {1, neighbors});
  watch.begin(solving);
  Watching visitor{&watch, solving};
  const auto np = IT::parameters::visitor(std::ref(visitor));
  Directions result;
  result.field.vectors =
      cloud.smoothest_direction_field(degree, vectors_of_cloud(cloud, asked), np).directions();
  return result;
}

Directions directions(Surface& s, int degree, const std::optional<double>& strength,
                      const Asked_vectors& asked, std::size_t neighbors, Watch& watch) {
  return with_triangulation(s, watch, [&](auto& t) {
    if (is_cloud(t)) {
      Directions result = cloud_directions(s, t, degree, strength, asked, neighbors, watch);
      result.field = cloud_field(t, std::move(result.field.vectors));
      return result;
    }
    if (!asked.are_at_vertices()) refuse("directions can be fixed at vertices only");
    Vector_finder find(t, s.points);
    const auto fixed = find.at_vertices(asked);
    const IT::Direction_field f = smooth_field(t, s, degree, strength, fixed, watch);
    const auto singular = IT::singularities(t, f);
    Directions result{
        {find.sheets().averaged(f.directions(), degree, fixed), IT::first_copies_of_rows(t)},
        singular.index};
    result.sum = singular.sum();
    for (const auto& [h, turns] : singular.turns) result.border_turns += turns;
    add_singularities(t, s.points, result);
    return result;
  });
}

py::tuple direction_field(Surface& s, int degree, const std::optional<double>& strength,
                          const Place_arrays& places, const Doubles& vectors, std::size_t neighbors,
                          const py::object& progress) {
  Watch watch(progress);
  Directions d = directions(s, degree, strength, Asked_vectors(places_of(s, places), vectors),
                            neighbors, watch);
  return py::make_tuple(std::move(d.field), array_of(std::move(d.index)),
                        array_of(std::move(d.faces)), array_of(std::move(d.weights)),
                        array_of(std::move(d.points)), array_of(std::move(d.singular)), d.sum,
                        d.border_turns);
}

// ---- Signed distances --------------------------------------------------------------------------

// Calls a function; errors begin with the name of what is wrong.
template <class Function>
auto naming(const std::string& name, const Function& function) {
  try {
    return function();
  } catch (const IT::Invalid_input& e) {
    throw IT::Invalid_input(e.kind(), e.index(), name + ": " + e.what());
  }
}

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

py::array_t<double>
signed_distance(Surface& s, const std::vector<std::variant<Way, Place_arrays, Integers>>& given,
                double time_factor, const py::object& progress) {
  Signed_curves curves;
  for (const auto& c : given)
    if (const Way* way = std::get_if<Way>(&c))
      curves.emplace_back(*way);
    else if (const auto* places = std::get_if<Place_arrays>(&c))
      curves.emplace_back(places_of(s, *places));
    else
      curves.emplace_back(
          numbers_of(std::get<Integers>(c), std::numeric_limits<std::uint32_t>::max(), "vertex"));
  Watch watch(progress);
  return array_of(with_triangulation(s, watch, [&]<class T>(const T& t) {
    using Method = IT::Signed_heat_distance<T>;
    return with_heat<Method>(s, t, time_factor, watch,
                             [&](Method& method) { return signed_distances(t, curves, method); });
  }));
}

} // namespace

void bind_directions(py::module_& m) {
  m.def("connection_laplacian", &connection_laplacian);
  m.def("direction_field", &direction_field);
  m.def("signed_distance", &signed_distance);
}

} // namespace python
