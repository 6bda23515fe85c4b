// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"
#include "arrays.h"
#include "kept_edges.h"

#include <CGAL/Intrinsic_operators/improvement/improve_and_measure.h>
#include <CGAL/Intrinsic_simplification/simplification/hierarchy.h>
#include <CGAL/Intrinsic_simplification/simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/simplification/remove_flat_vertices.h>
#include <CGAL/Intrinsic_simplification/simplification/simplify.h>
#include <CGAL/Intrinsic_simplification/simplification/vector_prolongation.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

// Surfaces with fewer vertices.

namespace python {

namespace {

using namespace py::literals;

// Where vertices are: a face and weights of its corners, also for those at a vertex; -1 for none.
struct Places {
  std::vector<std::int64_t> faces;
  std::vector<Point> weights;
};

Places places_of(const IT::Simplification& s) {
  const IT::Gluing_map& mesh = s.surface.mesh;
  std::vector<std::pair<std::uint32_t, std::size_t>> corner(s.kept.size(), {IT::Gluing::none, 0});
  for (std::uint32_t f = 0; f < mesh.number_of_faces(); ++f) {
    const auto sides = mesh.sides(IT::Gluing_map::Face{f});
    for (std::size_t k = 0; k < 3; ++k) corner[mesh.source(sides[k]).index] = {f, k};
  }
  Places places;
  for (const IT::Place& p : s.places) {
    const auto [face, k] = p.is_vertex() ? corner[p.vertex] : std::pair(p.face, std::size_t{3});
    places.faces.push_back(face == IT::Gluing::none ? -1 : std::int64_t{face});
    Point weights = k == 3 && face != IT::Gluing::none ? p.weights : Point{0, 0, 0};
    if (k < 3 && face != IT::Gluing::none) weights[k] = 1;
    places.weights.push_back(weights);
  }
  return places;
}

py::dict dict_of_simplification(const IT::Simplification& s) {
  Places places = places_of(s);
  std::vector<std::array<double, 2>> face_stretch;
  for (const IT::Face_stretch& f : s.face_stretch) face_stretch.push_back({f.lower, f.upper});
  return py::dict("status"_a = IT::name_of(s.status), "kept"_a = whole(s.kept),
                  "faces"_a = array_of(std::move(places.faces)),
                  "weights"_a = array_of(std::move(places.weights)),
                  "stretch"_a = py::make_tuple(s.stretch.lower, s.stretch.upper,
                                               s.stretch.mean_lower, s.stretch.mean_upper),
                  "face_stretch"_a = array_of(std::move(face_stretch)),
                  "prolongation"_a = array_of(IT::prolongation(s)),
                  "counts"_a = py::dict(
                      "removed"_a = s.removed, "newton"_a = s.newton_steps,
                      "most_newton"_a = s.most_newton_steps, "ptolemy_flips"_a = s.ptolemy_flips,
                      "flips"_a = s.flips, "blocked_by_border"_a = s.blocked_by_border,
                      "not_flattened"_a = s.not_flattened, "kept_by_bound"_a = s.kept_by_bound));
}

// What Python gives a function for the cost.
double asked_cost(const py::object& function, const IT::Removal_candidate& c, Watch& watch) {
  return watch.ask(std::numeric_limits<double>::quiet_NaN(),
                   [&] { return function(c).cast<double>(); });
}

// What Python gives for the cost: a word, a function, or masses at vertices.
struct Asked_cost {
  std::string word;
  py::object function;
  std::optional<Doubles> masses; // of functions, a row each, by rows of vertices
};

template <class Triangulation>
IT::Transported_mass cost_of_masses(const Triangulation& t, const Doubles& masses) {
  IT::Transported_mass cost;
  for (py::ssize_t k = 0; k < masses.shape(0); ++k) {
    std::vector<double> values;
    for (const auto v : vertices(t.mesh()))
      values.push_back(masses.at(k, py::ssize_t{t.input_vertex(v)}));
    cost.add(values);
  }
  return cost;
}

// Calls a function with the cost that Python has asked for.
template <class Triangulation, class Function>
std::vector<IT::Simplification> with_cost(const Triangulation& t, const Asked_cost& cost,
                                          Watch& watch, const Function& f) {
  if (!cost.function.is_none())
    return f([&](const IT::Removal_candidate& c) { return asked_cost(cost.function, c, watch); });
  if (cost.masses) return f(cost_of_masses(t, *cost.masses));
  return IT::with_named_cost(cost.word, t, f);
}

std::vector<IT::Simplification> one_surface(IT::Simplification s) {
  std::vector<IT::Simplification> result;
  result.push_back(std::move(s));
  return result;
}

// The coarse surface, with points for pictures.
std::shared_ptr<Surface> coarse_surface(const Surface& fine, const IT::Simplification& s,
                                        const std::vector<Point>& positions, bool is_exact) {
  auto result = surface_of_triangles(s.surface, fine.name, is_exact);
  result->is_in_space = false;
  result->points.clear();
  if (!positions.empty())
    for (const std::uint32_t row : s.kept) result->points.push_back(positions[row]);
  return result;
}

// \param levels with the ratio between them: a hierarchy; else one surface
// \param flat_within only vertices that are so flat are removed; none: others, too
py::list simplify(Surface& s, std::optional<std::size_t> vertices, std::optional<double> part,
                  std::optional<std::pair<std::size_t, double>> levels, double stretch,
                  std::optional<double> flat_within, const std::string& word,
                  const py::object& function, const std::optional<Doubles>& masses,
                  const Integers& kept_vertices, const std::optional<Integers>& keep,
                  std::optional<double> sharp_angle, const std::optional<Doubles>& positions,
                  Watch& watch) {
  const Kept kept_edges = kept(s, keep, sharp_angle);
  IT::Simplify_options options;
  options.vertices = vertices;
  options.part = part;
  options.stretch = stretch;
  const Asked_cost cost{word, function, masses};
  options.kept_vertices = numbers_of(kept_vertices, IT::Gluing::none, "vertex");
  options.progress = [&watch](const IT::Simplify_progress& p) {
    return watch("simplifying", p.removed, p.removed + p.left);
  };
  const std::vector<Point> points = positions ? points_of(*positions) : std::vector<Point>();
  const auto found = with_triangulation(s, watch, [&](auto& t) {
    const auto labels = IT::labelled_input_edges(t, marks_of(t.input(), kept_edges));
    for (const auto e : edges(t.mesh()))
      if (get(labels, e)) options.kept_edges.push_back(t.index(e));
    if (flat_within) return one_surface(IT::remove_flat_vertices(t, *flat_within, options));
    return with_cost(t, cost, watch, [&](auto&& c) {
      if (levels) return IT::hierarchy(t, levels->first, levels->second, options, std::move(c));
      return one_surface(IT::simplify(t, options, std::move(c)));
    });
  });
  py::list result;
  for (const IT::Simplification& f : found)
    result.append(py::make_tuple(coarse_surface(s, f, points, s.triangulation.index() == 0),
                                 dict_of_simplification(f)));
  return result;
}

// The matrix for tangent vectors, of triangulations and of what `dict_of_simplification()` gave.
py::tuple vector_prolongation(Surface& fine, Surface& coarse, const Integers& kept,
                              const Integers& faces, const Doubles& weights,
                              const std::array<double, 4>& stretch, Watch& watch) {
  IT::Simplification s;
  s.kept = numbers_of(kept, IT::Gluing::none, "vertex");
  s.stretch = {stretch[0], stretch[1], stretch[2], stretch[3]};
  const std::vector<Point> points = points_of(weights);
  for (std::size_t v = 0; v < points.size(); ++v) {
    const std::int64_t f = faces.at(static_cast<py::ssize_t>(v));
    s.places.push_back(f < 0 ? IT::Place{}
                             : IT::Place::in_face(static_cast<std::uint32_t>(f), points[v]));
  }
  return array_of(with_triangulation(fine, watch, [&](const auto& t) {
    const Surface_lock lock(coarse, watch);
    return std::visit([&](const auto& c) { return IT::vector_prolongation(t, *c, s); },
                      coarse.triangulation);
  }));
}

} // namespace

void bind_simplify(py::module_& m) {
  py::class_<IT::Removal_candidate>(m, "RemovalCandidate")
      .def_readonly("vertex", &IT::Removal_candidate::vertex)
      .def_readonly("curvature", &IT::Removal_candidate::curvature)
      .def_readonly("area", &IT::Removal_candidate::area)
      .def_readonly("mean_length", &IT::Removal_candidate::mean_length)
      .def_readonly("squared_length", &IT::Removal_candidate::squared_length)
      .def_readonly("stretch", &IT::Removal_candidate::stretch);
  m.def("simplify", &simplify);
  m.def("vector_prolongation", &vector_prolongation);
}

} // namespace python
