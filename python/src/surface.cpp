// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"

#include <CGAL/Intrinsic_triangulations/IO/idt/write_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_polygon_soup.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/domains/Point_cloud.h>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <ranges>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace python {

namespace {

using program::Options;
using Surface_ptr = std::shared_ptr<Surface>;

// Options with the names that the program has; `_surface.py` checks the words.
Options options_of(const std::string& name, const std::string& domain,
                   const std::string& mollification, const std::string& polygons) {
  Options options;
  options.input = name;
  options.domain = domain;
  options.mollification = mollification;
  options.polygons = polygons;
  return options;
}

template <class Triangulation>
Surface_ptr surface_of(program::Loaded<Triangulation> loaded, const Options& options) {
  std::vector<Point> points = program::input_points(loaded);
  if (!loaded.has_points()) points.clear();
  auto s = std::make_shared<Surface>(std::move(loaded));
  s->points = std::move(points);
  s->name = options.input;
  return s;
}

Surface_ptr surface_of(program::Mesh_file file, const Options& options, bool exact) {
  return exact ? surface_of(program::build<Exact>(std::move(file), options), options)
               : surface_of(program::build<Double>(std::move(file), options), options);
}

// The corners of each face.
// \param corners the corners of all faces
// \param begins where those of each face begin, and their number
auto faces_of(const Integers& corners, const Integers& begins) {
  const std::span all(corners.data(), static_cast<std::size_t>(corners.size()));
  const std::span begin(begins.data(), static_cast<std::size_t>(begins.size()));
  return std::views::iota(std::size_t{1}, begin.size()) | std::views::transform([=](std::size_t f) {
           return all.subspan(static_cast<std::size_t>(begin[f - 1]),
                              static_cast<std::size_t>(begin[f] - begin[f - 1]));
         });
}

Surface_ptr build(const Doubles& points, const Integers& corners, const Integers& begins,
                  const std::string& domain, bool exact, const std::string& mollification,
                  const std::string& polygons) {
  const Options options = options_of("the surface", domain, mollification, polygons);
  const std::vector<Point> p = points_of(points);
  const auto faces = faces_of(corners, begins);
  Watch watch;
  return without_interpreter(watch, [&] {
    const program::Surface_choice choice = program::surface_of(options);
    return surface_of(program::mesh_of(IT::triangle_soup(p, faces, choice.polygons), choice),
                      options, exact);
  });
}

Surface_ptr points(const Doubles& points, std::size_t neighbors, bool exact,
                   const std::string& mollification) {
  Options options = options_of("the points", "points", mollification, "fan");
  options.neighbors = neighbors;
  IT::Triangle_soup soup;
  soup.points = points_of(points);
  Watch watch;
  return without_interpreter(watch, [&] {
    return surface_of(program::mesh_of(std::move(soup), program::surface_of(options)), options,
                      exact);
  });
}

// The triangles at each point of a cloud among its neighbours.
py::array_t<std::uint32_t> triangles_at_points(const Doubles& points, std::size_t neighbors) {
  const std::vector<Point> p = points_of(points);
  Watch watch;
  return array_of(without_interpreter(watch, [&] {
    IT::Point_cloud_report report;
    return IT::triangles_at_points(p, neighbors, report);
  }));
}

// ---- Lengths -----------------------------------------------------------------------------------

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// The square of the length of each edge; both sides of an edge must agree.
std::vector<double> squared_lengths(const IT::Gluing_map& mesh, const std::vector<Point>& lengths) {
  std::vector<double> length(mesh.number_of_edges(), -1);
  for (std::uint32_t f = 0; f < mesh.number_of_faces(); ++f) {
    const auto sides = mesh.sides(IT::Gluing_map::Face{f});
    for (std::size_t side = 0; side < 3; ++side) {
      const double l = lengths[f][side];
      double& known = length[sides[side].index / 2];
      if (known >= 0 && std::abs(l - known) > 1e-9 * std::max(l, known))
        refuse("lengths[" + std::to_string(f) + ", " + std::to_string(side) + "] is " +
               std::to_string(l) + ", but the other side of that edge has the length " +
               std::to_string(known) + "; give both sides of an edge one length");
      if (known < 0) known = l;
    }
  }
  for (double& l : length) l *= l;
  return length;
}

// The gluing of the sides that `glue` names. Faces disagree at sides that run in one direction.
IT::Gluing gluing_of(std::uint32_t vertices, const Triangles& faces, const Integers& glue) {
  IT::Gluing g{vertices, {}, {}};
  for (const auto& f : faces) g.origin.insert(g.origin.end(), f.begin(), f.end());
  for (std::uint32_t h = 0; h < g.origin.size(); ++h) {
    const std::int64_t f = glue.data()[2 * h], side = glue.data()[2 * h + 1];
    const auto other = f < 0 ? IT::Gluing::none : static_cast<std::uint32_t>(3 * f + side);
    const std::uint32_t from = g.origin[h], to = g.origin[IT::Gluing::next(h)];
    const bool disagrees = other < g.origin.size() && from != to && g.origin[other] == from &&
                           g.origin[IT::Gluing::next(other)] == to;
    g.glue.push_back(disagrees ? IT::Gluing::reversed(other) : other);
  }
  return g;
}

// The surface of triangles that are glued as `glue` says, or where sides have the same ends.
IT::Domain domain_of_lengths(std::uint32_t vertices, const Triangles& faces,
                             const std::vector<Point>& lengths, const std::optional<Integers>& glue,
                             const program::Surface_choice& choice) {
  if (!glue) return IT::make_domain(vertices, faces, lengths, choice.kind, choice.mollification);
  IT::Gluing_map mesh(gluing_of(vertices, faces, *glue));
  std::vector<double> squares = squared_lengths(mesh, lengths);
  return IT::make_domain(
      IT::Intrinsic_input(std::move(mesh), std::move(squares), choice.mollification), choice.kind);
}

Surface_ptr build_abstract(std::uint32_t vertices, const Integers& corners, const Doubles& lengths,
                           const std::optional<Integers>& glue,
                           const std::optional<Doubles>& points, const std::string& domain,
                           bool exact, const std::string& mollification) {
  const Options options = options_of("the surface", domain, mollification, "fan");
  Triangles faces(static_cast<std::size_t>(corners.shape(0)));
  for (std::size_t c = 0; c < 3 * faces.size(); ++c)
    faces[c / 3][c % 3] = static_cast<std::uint32_t>(corners.data()[c]);
  const std::vector<Point> sides = points_of(lengths);
  std::vector<Point> shown = points ? points_of(*points) : std::vector<Point>();
  Watch watch;
  return without_interpreter(watch, [&] {
    const program::Surface_choice choice = program::surface_of(options);
    program::Mesh_file file;
    file.polygons = faces.size();
    IT::Domain made = domain_of_lengths(vertices, faces, sides, glue, choice);
    file.input = std::move(made.input);
    file.domain = std::move(made.report);
    Surface_ptr s = surface_of(std::move(file), options, exact);
    s->points = std::move(shown); // of pictures only
    return s;
  });
}

// ---- Files -------------------------------------------------------------------------------------

Surface_ptr read(const std::string& path, const std::string& domain,
                 const std::optional<std::string>& arithmetic,
                 const std::optional<std::string>& mollification, const std::string& polygons,
                 std::optional<std::size_t> neighbors, const py::object& progress) {
  Options options = options_of(path, domain, mollification.value_or("automatic"), polygons);
  options.arithmetic = arithmetic.value_or("exact");
  options.is_arithmetic_given = arithmetic.has_value();
  options.is_mollification_given = mollification.has_value();
  options.neighbors = neighbors;
  Watch watch(progress);
  return without_interpreter(watch, [&] {
    Surface_ptr s;
    program::with_loaded<IT::Integer_coordinates>(
        options, watch, [&](auto& loaded) { s = surface_of(std::move(loaded), options); });
    return s;
  });
}

// Points, the corners of all faces, and where those of each face begin, as they are in a file.
py::tuple read_polygons(const std::string& path) {
  Watch watch;
  IT::Polygon_soup soup = without_interpreter(watch, [&] { return IT::read_polygon_soup(path); });
  std::vector<std::int64_t> corners, begins{0};
  for (const std::vector<std::uint32_t>& face : soup.faces) {
    corners.insert(corners.end(), face.begin(), face.end());
    begins.push_back(static_cast<std::int64_t>(corners.size()));
  }
  return py::make_tuple(array_of(std::move(soup.points)), array_of(std::move(corners)),
                        array_of(std::move(begins)));
}

void save(Surface& s, const std::string& path) {
  with_triangulation(
      s, [&](const auto& t) { IT::write_intrinsic_triangulation(std::filesystem::path(path), t); });
}

// The contents of a file.
py::bytes dump(Surface& s) {
  return with_triangulation(s, [](const auto& t) {
    std::ostringstream out;
    IT::write_intrinsic_triangulation(out, t);
    return out.str();
  });
}

// What `dump()` has written. An abstract metric may have points for pictures.
Surface_ptr restore(const std::string& contents, bool exact, const std::string& name,
                    bool is_flipped, const std::optional<Doubles>& points) {
  std::vector<Point> p;
  if (points) p = points_of(*points);
  Watch watch;
  Surface_ptr s = without_interpreter(watch, [&] {
    std::istringstream in(contents);
    Options options;
    options.input = name;
    const auto restored = [&](auto triangulation) {
      return surface_of(program::stored(std::move(triangulation)), options);
    };
    return exact ? restored(IT::read_intrinsic_triangulation<Exact>(in, name))
                 : restored(IT::read_intrinsic_triangulation<Double>(in, name));
  });
  s->is_flipped = is_flipped;
  if (points) s->points = std::move(p);
  return s;
}

} // namespace

std::shared_ptr<Surface> surface_of_triangles(IT::Intrinsic_input input, const std::string& name,
                                              bool is_exact) {
  Options options;
  options.input = name;
  program::Mesh_file file;
  const std::vector<std::uint32_t>& polygons = input.names.polygon_of_triangle;
  file.polygons =
      polygons.empty() ? input.mesh.number_of_faces() : std::size_t{polygons.back()} + 1;
  file.domain.sheets = input.names.sheets;
  file.input = std::move(input);
  return surface_of(std::move(file), options, is_exact);
}

void bind_surface(py::module_& m) {
  py::class_<Surface, Surface_ptr>(m, "Surface")
      .def_readonly("is_flipped", &Surface::is_flipped)
      .def_readonly("name", &Surface::name)
      .def("expect_free", &Surface::expect_free)
      .def_property_readonly("is_exact", [](const Surface& s) { return s.loaded.index() == 0; })
      .def_property_readonly("points", [](const Surface& s) -> py::object {
        if (s.points.empty()) return py::none();
        return array_of(std::vector<Point>(s.points));
      });
  m.def("build", &build);
  m.def("points", &points);
  m.def("triangles_at_points", &triangles_at_points);
  m.def("build_abstract", &build_abstract);
  m.def("read", &read);
  m.def("read_polygons", &read_polygons);
  m.def("save", &save);
  m.def("dump", &dump);
  m.def("restore", &restore);
}

} // namespace python
