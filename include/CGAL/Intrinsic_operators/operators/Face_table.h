// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_OPERATORS_FACE_TABLE_H
#define CGAL_INTRINSIC_OPERATORS_OPERATORS_FACE_TABLE_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Metric_values.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A face for solvers: corner k is the source of side k; sides run counterclockwise from
// halfedge(f). Lengths and areas are in scaled units.
struct Table_face {
  std::array<int, 3> rows;                // of the corners
  std::array<std::uint32_t, 3> halfedges; // numbers of the sides
  std::array<double, 3> squared_lengths;  // of the sides
  double quadruple_area;

  double area() const { return quadruple_area / 4; }
  double length(std::size_t side) const { return std::sqrt(squared_lengths[side]); }
  // half the cotangent at the corner opposite a side: the face's part of the side's weight
  double half_cotangent(std::size_t side) const {
    const auto& l = squared_lengths;
    return (l[(side + 1) % 3] + l[(side + 2) % 3] - l[side]) / (2 * quadruple_area);
  }
  // Where the corners are in the frame of side 0, as complex numbers.
  std::array<std::complex<double>, 3> layout() const {
    const auto& l = squared_lengths;
    const double base = length(0), two_l = 2 * base;
    return {0, base, {(l[0] + l[2] - l[1]) / two_l, quadruple_area / two_l}};
  }
};

// The part of a face with vector v in the divergence at its corners: the integral of <v, grad hat
// function>.
// \param v in the frame of side 0
inline std::array<double, 3>
divergence_at_corners(const std::array<std::complex<double>, 3>& corners, std::complex<double> v) {
  std::array<double, 3> result;
  for (std::size_t k = 0; k < 3;
       ++k) { // area times gradient: the opposite side, a quarter turn to the left, by 2
    const std::complex<double> side = corners[(k + 2) % 3] - corners[(k + 1) % 3];
    result[k] = (side.real() * v.imag() - side.imag() * v.real()) / 2;
  }
  return result;
}

// A triangulation as one flat array of faces, for solvers.
struct Face_table {
  std::vector<Table_face> faces;
  std::vector<std::uint32_t> slot; // of a face by its number
  std::size_t number_of_rows = 0;
  std::size_t number_of_edges = 0; // numbers of removed ones included
  int scale_exponent = 0;

  // a length or distance in the units of the input
  double unscaled(double length) const { return std::ldexp(length, -scale_exponent); }

  // calls a function with the face and side of each edge, once
  template <class Function>
  void for_each_edge(const Function& function) const {
    std::vector<char> seen(number_of_edges, 0);
    for (const Table_face& f : faces)
      for (std::size_t k = 0; k < 3; ++k)
        if (char& s = seen[f.halfedges[k] / 2]; s == 0) {
          s = 1;
          function(f, k);
        }
  }

  double mean_edge_length() const {
    return mean_of_edges([](const Table_face& f, std::size_t k) { return f.length(k); });
  }

  double area() const {
    double sum = 0;
    for (const Table_face& f : faces) sum += f.area();
    return sum;
  }

  // the mean over all edges of a function of a face and a side, 1 if there are none
  template <class Function>
  double mean_of_edges(const Function& function) const {
    double sum = 0;
    std::size_t edges = 0;
    for_each_edge([&](const Table_face& f, std::size_t k) {
      sum += function(f, k);
      ++edges;
    });
    return edges == 0 ? 1 : sum / static_cast<double>(edges);
  }

  // Calls a function with the face and side of each border edge.
  template <class Function>
  void for_each_border_side(const Function& function) const {
    std::vector<char> sides(number_of_edges, 0);
    for (const Table_face& f : faces)
      for (const std::uint32_t h : f.halfedges) ++sides[h / 2];
    for (const Table_face& f : faces)
      for (std::size_t k = 0; k < 3; ++k)
        if (sides[f.halfedges[k] / 2] == 1) function(f, k);
  }

  // the least row of the component of each row; isolated vertices are their own
  std::vector<std::uint32_t> components() const {
    return joined_sets(number_of_rows, [this](const auto& join) {
      for (const Table_face& f : faces)
        for (const std::size_t k : {1U, 2U}) join(f.rows[0], f.rows[k]);
    });
  }
};

// Reads a triangulation; with exact traits, narrows values first.
template <NumberedTriangulation Triangulation>
Face_table face_table(const Triangulation& t) {
  const auto& mesh = t.mesh();
  Face_table table;
  table.number_of_rows = t.number_of_vertices();
  table.number_of_edges = t.numbers().edge_capacity(mesh);
  table.scale_exponent = t.metric().scale_exponent();
  table.slot.assign(t.numbers().face_capacity(mesh), Gluing::none);
  table.faces.reserve(num_faces(mesh));
  for (const typename Triangulation::face_descriptor f : faces(mesh)) {
    const Face_values<double> values = accurate_values(t, f);
    Table_face face{{}, {}, values.squared_lengths, values.quadruple_area};
    typename Triangulation::halfedge_descriptor h = halfedge(f, mesh);
    for (std::size_t k = 0; k < 3; ++k, h = next(h, mesh)) {
      face.rows[k] = static_cast<int>(t.input_vertex(source(h, mesh)));
      face.halfedges[k] = t.numbers().halfedge(h);
    }
    table.slot[t.index(f)] = static_cast<std::uint32_t>(table.faces.size());
    table.faces.push_back(face);
  }
  return table;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_OPERATORS_FACE_TABLE_H
