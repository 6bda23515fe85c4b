// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "maps.h"
#include "fields.h"

#include <CGAL/Intrinsic_geodesics/cuts/cut_input.h>
#include <CGAL/Intrinsic_operators/compiled.h>
#include <CGAL/Intrinsic_operators/editing/Surface_deformation.h>
#include <CGAL/Intrinsic_operators/operators/surface_modes.h>
#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>
#include <CGAL/Intrinsic_operators/parametrization/map_to_plane.h>
#include <CGAL/Intrinsic_operators/parametrization/measure_distortion.h>
#include <CGAL/Intrinsic_operators/parametrization/parametrize.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_triangulations/input/Input_edges.h>
#include <CGAL/Intrinsic_triangulations/input/definition_of.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <pybind11/stl.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Maps to the plane, eigenfunctions, deformations.

namespace python {

using namespace py::literals;

py::dict dict_of(const IT::Map_certificate& c) {
  return py::dict("injective"_a = c.is_injective(),
                  "locally_injective"_a = c.is_locally_injective(), "faces"_a = c.faces,
                  "flipped_faces"_a = c.flipped, "degenerate_faces"_a = c.degenerate,
                  "border_is_simple"_a = c.border_is_simple);
}

py::dict dict_of(const IT::Map_distortion& d) {
  return py::dict(
      "mean_quasi_conformal"_a = d.mean_quasi_conformal,
      "max_quasi_conformal"_a = d.maximum_quasi_conformal,
      "mean_angle_change"_a = d.mean_angle_change, "max_angle_change"_a = d.maximum_angle_change,
      "min_area_ratio"_a = d.minimum_area_ratio, "max_area_ratio"_a = d.maximum_area_ratio,
      "mean_area_ratio"_a = d.mean_area_ratio);
}

namespace {

// ---- Maps to the plane -------------------------------------------------------------------------

IT::Map_method method_of(const std::string& name) {
  return name == "lscm"       ? IT::Map_method::least_squares
         : name == "spectral" ? IT::Map_method::spectral
                              : IT::Map_method::harmonic;
}

// The surface may be refined.
py::tuple parametrize(Surface& s, const std::string& method, std::size_t neighbors,
                      const std::string& solver, Watch& watch) {
  IT::Map_options options;
  options.method = method_of(method);
  options.neighbors = neighbors;
  options.solver = IT::solver_named(solver);
  const char* const stage = options.method == IT::Map_method::harmonic ? "rounds" : "solutions";
  options.progress = [&](std::uint64_t count) { return watch(stage, count); };
  IT::Map_to_plane map = with_triangulation(s, watch, [&](auto& t) {
    IT::Map_to_plane result = IT::map_to_plane(t, s.points, options);
    if (result.inserted > 0) s.cache.clear(); // it was of the surface before
    return result;
  });
  const bool has_faces = map.has_faces();
  return py::make_tuple(array_of(std::move(map.uv)), IT::name_of(map.status),
                        has_faces ? py::object(dict_of(map.certificate)) : py::none(),
                        has_faces ? py::object(dict_of(*map.distortion)) : py::none(), map.rounds,
                        map.inserted, map.is_injective_on_input);
}

// ---- The surface before its first move ---------------------------------------------------------

py::array_t<double> input_points(Surface& s) { return array_of(std::vector<Point>(s.points)); }

// The user's triangles, in their order, and the user's face that each is a part of.
py::tuple input_triangles(Surface& s) {
  std::vector<std::int64_t> polygons;
  auto triangles = with_triangulation(s, [&](auto& t) {
    const IT::Input& input = t.input();
    const std::uint32_t step = std::max<std::uint32_t>(input.names().sheets, 1);
    std::vector<std::array<std::int64_t, 3>> result(input.number_of_faces() / step);
    for (std::uint32_t f = 0; f < result.size(); ++f) {
      const std::uint32_t here = input.names().faces.here(step * f);
      std::uint32_t h = input.halfedge_of_face(here);
      for (std::int64_t& row : result[f]) {
        row = input.names().row(input.source(h));
        h = input.next(h);
      }
      polygons.push_back(input.names().polygon(here));
    }
    return result;
  });
  return py::make_tuple(array_of(std::move(triangles)), array_of(std::move(polygons)));
}

// ---- Surfaces that are cut open ----------------------------------------------------------------

// Marks edges by their ends. \throws Invalid_input naming one that does not exist
std::vector<char> marks_of(const IT::Intrinsic_input& sheet, const Integers& edges) {
  IT::Input_edges find(sheet);
  std::vector<char> marks = find.no_marks();
  const auto count = static_cast<std::size_t>(edges.size());
  const std::vector<std::uint32_t> ends =
      numbers_of(edges, sheet.mesh.number_of_vertices(), "vertex");
  for (std::size_t k = 0; k < count; k += 2)
    if (!find.mark(ends[k], ends[k + 1], marks))
      refuse("cut[" + std::to_string(k / 2) + "]: no edge joins the vertices " +
             std::to_string(ends[k]) + " and " + std::to_string(ends[k + 1]) +
             "; give edges of the mesh");
  return marks;
}

// The triangles of a surface, cut open along edges, or, without edges, to disks, and the vertex
// that each vertex is a copy of.
py::tuple cut_open(Surface& s, const std::optional<Integers>& edges, Watch& watch) {
  bool is_exact = false;
  IT::Opened_input opened = with_triangulation(s, watch, [&](auto& t) {
    is_exact = std::remove_cvref_t<decltype(t)>::Metric::is_exact;
    const IT::Intrinsic_input sheet = IT::sheet_of_cover(IT::definition_of(t.input()));
    watch.begin("cut");
    return IT::cut_to_disks(sheet, edges ? marks_of(sheet, *edges) : std::vector<char>());
  });
  std::shared_ptr<Surface> result = without_interpreter(
      watch, [&] { return surface_of_triangles(std::move(opened.input), s.name, is_exact); });
  return py::make_tuple(std::move(result), array_of(std::move(opened.original_vertex)));
}

// How many sheets the surface has over each face of the user.
std::uint32_t sheets(Surface& s) {
  return with_triangulation(s, [](auto& t) { return t.input().names().sheets; });
}

// ---- Eigenfunctions ----------------------------------------------------------------------------

py::tuple eigen(Surface& s, std::size_t count, const std::string& solver, Watch& watch) {
  Watching visitor{&watch, "solutions"};
  IT::Eigenpairs pairs = with_triangulation(s, watch, [&](auto& t) {
    return IT::surface_modes(t, count, IT::solver_named(solver),
                             IT::parameters::visitor(std::ref(visitor)));
  });
  return py::make_tuple(array_of(std::move(pairs.values)), array_of(std::move(pairs.vectors)));
}

// ---- Deformations ------------------------------------------------------------------------------

// The deformation that was used last: its handles may move many times.
struct Kept_deformation {
  std::vector<std::uint32_t> rows;
  std::string energy, solver;
  IT::Surface_deformation deformation;
};

IT::Deformation_energy energy_of(const std::string& name) {
  if (name == "biharmonic") return IT::Deformation_energy::biharmonic;
  if (name == "harmonic") return IT::Deformation_energy::harmonic;
  refuse("energy=\"" + name + "\" does not exist; give \"biharmonic\" or \"harmonic\"");
}

py::array_t<double> deform(Surface& s, const Integers& handles, const Doubles& displacements,
                           const std::string& energy, const std::string& solver, Watch& watch) {
  const IT::Deformation_energy minimized = energy_of(energy);
  const Row_matrix given = matrix_of(displacements);
  const std::vector<std::uint32_t> rows = numbers_of(
      handles, with_triangulation(s, [](auto& t) { return t.number_of_vertices(); }), "vertex");
  return array_of(with_triangulation(s, watch, [&](auto& t) -> Row_matrix {
    std::shared_ptr<void>& place = s.cache["deformation"];
    auto* kept = static_cast<Kept_deformation*>(place.get());
    if (kept == nullptr || kept->rows != rows || kept->energy != energy || kept->solver != solver) {
      Watching visitor{&watch, "factorization"};
      auto made = std::make_shared<Kept_deformation>(
          Kept_deformation{rows, energy, solver,
                           IT::Surface_deformation(t, rows, minimized, IT::solver_named(solver),
                                                   IT::parameters::visitor(std::ref(visitor)))});
      if (made->deformation.status() == IT::Status::cancelled) return {};
      kept = made.get();
      place = std::move(made);
      watch.begin("solution");
    }
    return kept->deformation.displacements(given);
  }));
}

} // namespace

void bind_maps(py::module_& m) {
  m.def("parametrize", &parametrize);
  m.def("input_points", &input_points);
  m.def("input_triangles", &input_triangles);
  m.def("cut_open", &cut_open);
  m.def("sheets", &sheets);
  m.def("eigen", &eigen);
  m.def("deform", &deform);
  bind_uniformize(m);
  bind_embed(m);
}

} // namespace python
