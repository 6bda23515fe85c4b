// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace python {

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Surface_ptr = std::shared_ptr<Surface>;

// ---- Building ----------------------------------------------------------------------------------

IT::Mollification mollification_of(const std::string& name) {
  if (name == "none") return IT::Mollification::none;
  if (name == "lengths") return IT::Mollification::lengths;
  if (name == "squared") return IT::Mollification::squared_lengths;
  if (name == "automatic") return IT::Mollification::automatic;
  refuse("mollification=\"" + name +
         "\" does not exist; give \"automatic\", \"none\", \"lengths\" or \"squared\"");
}

IT::Domain_kind domain_of(const std::string& name) {
  if (name == "auto") return IT::Domain_kind::automatic;
  if (name == "manifold") return IT::Domain_kind::manifold;
  if (name == "orientation-cover") return IT::Domain_kind::orientation_cover;
  if (name == "tufted") return IT::Domain_kind::tufted_cover;
  if (name == "closed") return IT::Domain_kind::closed;
  refuse("domain=\"" + name + "\" does not exist; give \"auto\", \"manifold\", "
         "\"orientation-cover\", \"tufted\" or \"closed\"");
}

bool is_exact(const std::string& arithmetic) {
  if (arithmetic == "exact" || arithmetic == "double") return arithmetic == "exact";
  refuse("arithmetic=\"" + arithmetic + "\" does not exist; give \"exact\" or \"double\"");
}

Surface_ptr surface_of(IT::Intrinsic_input input, bool exact, std::vector<Point> points) {
  auto s = exact ? std::make_shared<Surface>(Exact(std::move(input)))
                 : std::make_shared<Surface>(Double(std::move(input)));
  s->points = std::move(points);
  return s;
}

// The faces, as spans of corners.
class Faces {
public:
  Faces(const Integers& corners, const Integers& begins)
      : corners_(corners.data(), static_cast<std::size_t>(corners.size())),
        begins_(begins.data(), static_cast<std::size_t>(begins.size())) {}

  struct Iterator {
    const Faces* faces;
    std::size_t f;
    std::span<const std::int64_t> operator*() const {
      const auto begin = static_cast<std::size_t>(faces->begins_[f]);
      return faces->corners_.subspan(begin,
                                     static_cast<std::size_t>(faces->begins_[f + 1]) - begin);
    }
    Iterator& operator++() {
      ++f;
      return *this;
    }
    bool operator==(const Iterator&) const = default;
  };
  Iterator begin() const { return {this, 0}; }
  Iterator end() const { return {this, begins_.empty() ? 0 : begins_.size() - 1}; }

private:
  std::span<const std::int64_t> corners_, begins_;
};

Surface_ptr build(const Doubles& points, const Integers& corners, const Integers& begins,
                  const std::string& domain, const std::string& arithmetic,
                  const std::string& mollification) {
  const bool exact = is_exact(arithmetic);
  const IT::Domain_kind kind = domain_of(domain);
  const IT::Mollification m = mollification_of(mollification);
  std::vector<Point> p = points_of(points);
  const Faces faces(corners, begins);
  Watch watch;
  return without_interpreter(watch, [&] {
    IT::Domain made = IT::make_domain(IT::triangle_soup(p, faces), kind, m);
    return surface_of(std::move(made.input), exact, std::move(p));
  });
}

// ---- Flipping ----------------------------------------------------------------------------------

Surface_ptr copy(Surface& s) {
  return with_triangulation(s, [&](auto& t) {
    auto result = std::make_shared<Surface>(t);
    result->points = s.points;
    result->is_flipped = s.is_flipped;
    return result;
  });
}

struct Flip_watch {
  Watch* watch;
  bool progress(const IT::Flip_to_delaunay_result& r) { return (*watch)("flips", r.flips); }
};

Surface_ptr delaunay(Surface& s, const py::object& progress) {
  Watch watch(progress);
  Surface_ptr result = copy(s);
  Flip_watch visitor{&watch};
  with_triangulation(*result, watch, [&](auto& t) {
    IT::flip_to_delaunay(t, IT::parameters::visitor(std::ref(visitor)));
  });
  result->is_flipped = true;
  return result;
}

// ---- Reading -----------------------------------------------------------------------------------

// Rows of matrices: the user's vertices, then those that were inserted.
std::size_t number_of_vertices(Surface& s) {
  return with_triangulation(s, [](auto& t) -> std::size_t { return t.number_of_vertices(); });
}

std::size_t number_of_faces(Surface& s) {
  return with_triangulation(s, [](auto& t) -> std::size_t { return num_faces(t.mesh()); });
}

std::size_t number_of_input_vertices(Surface& s) {
  return with_triangulation(s, [](auto& t) -> std::size_t { return t.input().number_of_rows(); });
}

// Polygons of the user's mesh.
std::size_t number_of_input_faces(Surface& s) {
  return with_triangulation(s, [](auto& t) -> std::size_t {
    const IT::Input& input = t.input();
    const std::vector<std::uint32_t>& polygon = input.names().polygon_of_triangle;
    return polygon.empty() ? input.number_of_faces() : std::size_t{polygon.back()} + 1;
  });
}

py::array_t<std::int64_t> faces(Surface& s) {
  return array_of(with_triangulation(s, [](auto& t) {
    std::vector<std::array<std::int64_t, 3>> rows;
    for (const auto f : faces(t.mesh())) {
      const auto sides = t.mesh().sides(f);
      rows.push_back({});
      for (std::size_t k = 0; k < 3; ++k) rows.back()[k] = t.input_vertex(t.mesh().source(sides[k]));
    }
    return rows;
  }));
}

py::array_t<double> lengths(Surface& s) {
  return array_of(with_triangulation(s, [](auto& t) {
    std::vector<Point> rows;
    for (const auto f : faces(t.mesh())) {
      const auto sides = t.mesh().sides(f);
      rows.push_back({});
      for (std::size_t k = 0; k < 3; ++k) rows.back()[k] = t.length(edge(sides[k], t.mesh()));
    }
    return rows;
  }));
}

py::tuple laplacian(Surface& s) {
  return array_of(with_triangulation(s, [](auto& t) { return IT::cotangent_laplacian(t); }));
}

py::tuple mass(Surface& s, const std::string& kind) {
  return array_of(with_triangulation(s, [&](auto& t) -> Matrix {
    if (kind == "lumped") return IT::lumped_mass_matrix(t);
    if (kind == "galerkin") return IT::galerkin_mass_matrix(t);
    if (kind == "voronoi") return IT::voronoi_mass_matrix(t);
    refuse("kind=\"" + kind + "\" does not exist; give \"lumped\", \"galerkin\" or \"voronoi\"");
  }));
}

} // namespace

void bind_surface(py::module_& m) {
  py::class_<Surface, Surface_ptr>(m, "Surface")
      .def_readonly("is_flipped", &Surface::is_flipped)
      .def_property_readonly("number_of_vertices", &number_of_vertices)
      .def_property_readonly("number_of_faces", &number_of_faces)
      .def_property_readonly("number_of_input_vertices", &number_of_input_vertices)
      .def_property_readonly("number_of_input_faces", &number_of_input_faces);
  m.def("build", &build);
  m.def("copy", &copy);
  m.def("delaunay", &delaunay);
  m.def("faces", &faces);
  m.def("lengths", &lengths);
  m.def("laplacian", &laplacian);
  m.def("mass", &mass);
}

} // namespace python
