// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"

#include <CGAL/Intrinsic_triangulations/IO/idt/stored_surface.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/write_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_polygon_soup.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/domains/Point_cloud.h>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/support/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <ranges>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace python {

namespace {

using Surface_ptr = std::shared_ptr<Surface>;

// \param name what messages call it
Surface_ptr surface_of(IT::Read_surface surface, const std::string& name, bool exact) {
  return naming(name, [&] {
    return exact ? std::make_shared<Surface>(IT::build_surface<Exact>(std::move(surface)), name)
                 : std::make_shared<Surface>(IT::build_surface<Double>(std::move(surface)), name);
  });
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
  const IT::Surface_options options = IT::surface_options(domain, mollification, polygons);
  const std::vector<Point> p = points_of(points);
  const auto faces = faces_of(corners, begins);
  Watch watch;
  return without_interpreter(watch, [&] {
    return surface_of(IT::make_surface(IT::triangle_soup(p, faces, options.polygons), options),
                      "the surface", exact);
  });
}

Surface_ptr points(const Doubles& points, std::size_t neighbors, bool exact,
                   const std::string& mollification) {
  IT::Surface_options options = IT::surface_options("points", mollification);
  options.neighbors = neighbors;
  IT::Triangle_soup soup;
  soup.points = points_of(points);
  Watch watch;
  return without_interpreter(watch, [&] {
    return surface_of(IT::make_surface(std::move(soup), options), "the points", exact);
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
                             const IT::Surface_options& options) {
  if (!glue) return IT::make_domain(vertices, faces, lengths, options.kind, options.mollification);
  return IT::make_domain(IT::Gluing_map(gluing_of(vertices, faces, *glue)), lengths, options.kind,
                         options.mollification);
}

Surface_ptr build_abstract(std::uint32_t vertices, const Integers& corners, const Doubles& lengths,
                           const std::optional<Integers>& glue,
                           const std::optional<Doubles>& points, const std::string& domain,
                           bool exact, const std::string& mollification) {
  const IT::Surface_options options = IT::surface_options(domain, mollification);
  Triangles faces(static_cast<std::size_t>(corners.shape(0)));
  for (std::size_t c = 0; c < 3 * faces.size(); ++c)
    faces[c / 3][c % 3] = static_cast<std::uint32_t>(corners.data()[c]);
  const std::vector<Point> sides = points_of(lengths);
  std::vector<Point> shown = points ? points_of(*points) : std::vector<Point>();
  Watch watch;
  return without_interpreter(watch, [&] {
    IT::Domain made = domain_of_lengths(vertices, faces, sides, glue, options);
    IT::Read_surface surface{std::move(made.input)};
    surface.facts.polygons = faces.size();
    surface.facts.domain = std::move(made.report);
    Surface_ptr s = surface_of(std::move(surface), "the surface", exact);
    s->points = std::move(shown); // of pictures only
    return s;
  });
}

// ---- Files -------------------------------------------------------------------------------------

Surface_ptr read(const std::string& path, const std::string& domain,
                 const std::optional<std::string>& arithmetic,
                 const std::optional<std::string>& mollification, const std::string& polygons,
                 std::optional<std::size_t> neighbors, Watch& watch) {
  constexpr std::array<std::string_view, 1> stored{"idt"};
  IT::Surface_options options =
      IT::surface_options(domain, mollification.value_or("automatic"), polygons);
  options.neighbors = neighbors;
  return without_interpreter(watch, [&] {
    watch("reading");
    if (IT::has_extension(path, stored))
      return IT::stored_arithmetic(path, arithmetic, mollification.has_value(), options) == "exact"
                 ? std::make_shared<Surface>(IT::read_stored_surface<Exact>(path), path)
                 : std::make_shared<Surface>(IT::read_stored_surface<Double>(path), path);
    IT::Read_surface surface = IT::read_surface(path, options);
    watch("building");
    return surface_of(std::move(surface), path, arithmetic.value_or("exact") == "exact");
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
    const auto restored = [&](auto t) {
      return std::make_shared<Surface>(IT::stored_surface(std::move(t)), name);
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
  IT::Read_surface surface{std::move(input)};
  const std::vector<std::uint32_t>& polygons = surface.input.names.polygon_of_triangle;
  surface.facts.polygons =
      polygons.empty() ? surface.input.mesh.number_of_faces() : std::size_t{polygons.back()} + 1;
  surface.facts.domain.sheets = surface.input.names.sheets;
  return surface_of(std::move(surface), name, is_exact);
}

void bind_surface(py::module_& m) {
  py::class_<Surface, Surface_ptr>(m, "Surface")
      .def_readonly("is_flipped", &Surface::is_flipped)
      .def_readonly("name", &Surface::name)
      .def("expect_free", &Surface::expect_free)
      .def_property_readonly("is_exact",
                             [](const Surface& s) { return s.triangulation.index() == 0; })
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
