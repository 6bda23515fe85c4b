// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Faces_in_order.h"
#include "Surface.h"
#include "places.h"

#include <CGAL/Intrinsic_operators/compiled.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace python {

namespace {

// Rows of matrices: the user's vertices, then those that were inserted.
std::size_t number_of_vertices(Surface& s) {
  return with_triangulation(s, [](auto& t) -> std::size_t { return t.number_of_vertices(); });
}

std::size_t number_of_faces(Surface& s) {
  return with_triangulation(s, [](auto& t) -> std::size_t {
    const auto all = faces(t.mesh()); // `num_faces()` is of numbers, also of faces that are gone
    return static_cast<std::size_t>(std::distance(all.begin(), all.end()));
  });
}

std::size_t number_of_input_vertices(Surface& s) {
  return with_triangulation(s, [](auto& t) -> std::size_t { return t.input().number_of_rows(); });
}

// Polygons of the user's mesh.
std::size_t number_of_input_faces(Surface& s) {
  return with_triangulation(s, [](auto& t) { return IT::number_of_polygons(t.input()); });
}

// Three values for each face, from its sides.
template <class Number, class Function>
py::array_t<Number> of_sides(Surface& s, const Function& function) {
  return array_of(with_triangulation(s, [&](auto& t) {
    std::vector<std::array<Number, 3>> rows;
    const Faces_in_order order(t);
    rows.reserve(order.order().size());
    for (const auto f : order.order()) {
      const auto sides = t.mesh().sides(f);
      rows.push_back({function(t, sides[0]), function(t, sides[1]), function(t, sides[2])});
    }
    return rows;
  }));
}

py::array_t<std::int64_t> faces_of(Surface& s) {
  return of_sides<std::int64_t>(s, [](auto& t, IT::Gluing_map::Halfedge h) -> std::int64_t {
    return t.input_vertex(t.mesh().source(h));
  });
}

py::array_t<double> lengths(Surface& s) {
  return of_sides<double>(
      s, [](auto& t, IT::Gluing_map::Halfedge h) -> double { return t.length(edge(h, t.mesh())); });
}

// For each side, the face and the side that it is glued to; -1 on the border.
py::array_t<std::int64_t> glue(Surface& s) {
  auto rows = with_triangulation(s, [](auto& t) {
    const Faces_in_order order(t);
    std::vector<std::array<std::int64_t, 2>> result;
    for (const auto f : order.order())
      for (const auto h : t.mesh().sides(f)) {
        const auto o = t.mesh().opposite(h), null = IT::Gluing_map::Face{};
        const auto g = t.mesh().face(o);
        std::int64_t side = -1;
        for (std::int64_t k = 0; g != null && k < 3; ++k)
          if (t.mesh().sides(g)[static_cast<std::size_t>(k)] == o) side = k;
        result.push_back({g == null ? -1 : order[t.index(g)], side});
      }
    return result;
  });
  const auto faces = static_cast<py::ssize_t>(rows.size() / 3);
  return array_of(std::move(rows)).reshape(std::vector<py::ssize_t>{faces, 3, 2});
}

// The places in space of the vertices that were inserted, by their rows.
py::array_t<double> positions(Surface& s) {
  return array_of(with_triangulation(s, [&](auto& t) {
    std::vector<Point> result = s.points;
    result.resize(t.number_of_vertices());
    for (const auto v : vertices(t.mesh()))
      if (t.is_inserted(v))
        result[t.input_vertex(v)] = IT::position(
            IT::weighted_vertices(t, t.correspondence().location(t.index(v))), s.points);
    return result;
  }));
}

// ---- Matrices ----------------------------------------------------------------------------------

using Matrix = Eigen::SparseMatrix<double>;

py::tuple laplacian(Surface& s) {
  return array_of(with_triangulation(s, [](auto& t) { return IT::cotangent_laplacian(t); }));
}

py::tuple mass(Surface& s, const std::string& kind) {
  return array_of(with_triangulation(s, [&](auto& t) -> Matrix {
    if (kind == "galerkin") return IT::galerkin_mass_matrix(t);
    return kind == "voronoi" ? IT::voronoi_mass_matrix(t) : IT::lumped_mass_matrix(t);
  }));
}

// ---- Places ------------------------------------------------------------------------------------

// Faces, and weights of their corners; the face is -1 where rounding hides a place.
struct Faces_and_weights {
  std::vector<std::int64_t> face;
  std::vector<std::array<double, 3>> weights;

  // \param sides the halfedges of the face, by which Python orders its corners
  void append(std::int64_t f, const std::array<std::uint32_t, 3>& sides,
              const IT::Surface_point& p) {
    face.push_back(f);
    weights.push_back({0, 0, 0});
    const auto first =
        static_cast<std::size_t>(std::find(sides.begin(), sides.end(), p.halfedge) - sides.begin());
    for (std::size_t k = 0; k < 3; ++k) weights.back()[(first + k) % 3] = p.weights[k];
  }
  py::tuple arrays() && {
    return py::make_tuple(array_of(std::move(face)), array_of(std::move(weights)));
  }
};

// Where places on the user's mesh are on the triangulation; on a cover, on the first sheet.
py::tuple locate(Surface& s, const Place_arrays& arrays) {
  const std::vector<Place> places = places_of(s, arrays);
  return with_triangulation(s,
                            [&](auto& t) {
                              const Faces_in_order order(t);
                              Place_finder find(t);
                              Faces_and_weights result;
                              for (const Place& place : places) {
                                const IT::Surface_point p = find.points(place).front();
                                const auto f = t.mesh().face(IT::Gluing_map::Halfedge{p.halfedge});
                                const auto [i, j, k] = t.mesh().sides(f);
                                result.append(order[t.index(f)], {i.index, j.index, k.index}, p);
                              }
                              return result;
                            })
      .arrays();
}

// Where places in faces of the triangulation are on the user's mesh.
py::tuple locate_on_input(Surface& s, const Integers& faces, const Doubles& weights) {
  const std::vector<Point> w = points_of(weights);
  return with_triangulation(
             s,
             [&](auto& t) {
               const Faces_in_order order(t);
               const IT::Input& input = t.input();
               const IT::Input_names& names = input.names();
               Faces_and_weights result;
               for (std::size_t i = 0; i < w.size(); ++i) {
                 const auto f = order.order()[static_cast<std::size_t>(faces.data()[i])];
                 const auto p =
                     IT::locate_on_input(t, IT::Surface_point{t.mesh().halfedge(f).index, w[i]});
                 if (!p) {
                   result.append(-1, {0, 0, 0}, {0, {0, 0, 0}});
                   continue;
                 }
                 const std::uint32_t g = input.face(p->halfedge), h = input.halfedge_of_face(g);
                 const std::uint32_t sheets = names.polygon_of_triangle.empty() ? names.sheets : 1;
                 result.append(names.polygon(g) / sheets,
                               {h, input.next(h), input.next(input.next(h))}, *p);
               }
               return result;
             })
      .arrays();
}

} // namespace

void bind_queries(py::module_& m) {
  py::class_<Surface, std::shared_ptr<Surface>> surface(m.attr("Surface"));
  surface.def_property_readonly("number_of_vertices", &number_of_vertices)
      .def_property_readonly("number_of_faces", &number_of_faces)
      .def_property_readonly("number_of_input_vertices", &number_of_input_vertices)
      .def_property_readonly("number_of_input_faces", &number_of_input_faces);
  m.def("faces", &faces_of);
  m.def("lengths", &lengths);
  m.def("glue", &glue);
  m.def("positions", &positions);
  m.def("laplacian", &laplacian);
  m.def("mass", &mass);
  m.def("locate", &locate);
  m.def("locate_on_input", &locate_on_input);
}

} // namespace python
