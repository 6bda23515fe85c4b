// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_EXPECTED_CUTS_H
#define TEST_EXPECTED_CUTS_H

#include <CGAL/Intrinsic_geodesics/cuts/Cut_surface.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>

#include "glue_back.h"
#include "meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

// What holds for every cut surface of a mesh in space.

namespace cuts {

namespace IT = CGAL::Intrinsic_triangulations;
using Point = std::array<double, 3>;

inline Point vector_area(const Point& a, const Point& b, const Point& c) {
  Point n;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    n[i] = ((b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j])) / 2;
  }
  return n;
}
inline double norm(const Point& p) { return std::hypot(p[0], p[1], p[2]); }
inline double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Number of faces of each face of the mesh.
inline std::vector<std::size_t> pieces(const IT::Cut_surface& s, std::size_t faces) {
  std::vector<std::size_t> count(faces, 0);
  for (const std::uint32_t f : s.input_face) ++count[f];
  return count;
}

/// Checks labels, areas, places and gluings. \param least the area that the pieces have at least, as
/// a part of that of their face
inline void expect_cut(const IT::Cut_surface& s, const meshes::Mesh& m, double least = 0) {
  IT::validate(s.gluing);
  const std::vector<Point> points = IT::positions(s, m.points);
  ASSERT_EQ(points.size(), s.gluing.number_of_vertices);
  std::vector<double> area(m.triangles.size(), 0);
  for (std::uint32_t f = 0; f < s.gluing.number_of_faces(); ++f) {
    const meshes::Triangle& triangle = m.triangles[s.input_face[f]];
    EXPECT_EQ(s.input_triangle[f], s.input_face[f]);
    const Point whole =
        vector_area(m.points[triangle[0]], m.points[triangle[1]], m.points[triangle[2]]);
    const auto v = s.face(f);
    const Point part = vector_area(points[v[0]], points[v[1]], points[v[2]]);
    const double size = norm(whole);
    area[s.input_face[f]] += dot(whole, part) / size;
    EXPECT_GE(dot(whole, part), least * size * size - 1e-14 * size * size);
    for (std::size_t k = 0; k < 3; ++k) { // the place of each corner in its face
      Point p{0, 0, 0};
      double sum = 0;
      for (std::size_t i = 0; i < 3; ++i) sum += s.weights[3 * std::size_t{f} + k][i];
      EXPECT_NEAR(sum, 1, 1e-14);
      std::size_t shift = 0; // the triangulation starts the triangle at some corner
      double best = 1e300;
      for (std::size_t r = 0; r < 3; ++r) {
        p = {0, 0, 0};
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t c = 0; c < 3; ++c)
            p[c] += s.weights[3 * std::size_t{f} + k][i] * m.points[triangle[(i + r) % 3]][c];
        for (std::size_t c = 0; c < 3; ++c) p[c] -= points[v[k]][c];
        if (norm(p) < best) best = norm(p), shift = r;
      }
      EXPECT_EQ(shift % 3, shift);
      EXPECT_LT(best, 1e-11 * (1 + norm(points[v[k]])));
    }
  }
  for (std::size_t f = 0; f < area.size(); ++f) {
    const meshes::Triangle& t = m.triangles[f];
    const double whole = norm(vector_area(m.points[t[0]], m.points[t[1]], m.points[t[2]]));
    EXPECT_NEAR(area[f], whole, 1e-11 * whole + 1e-300) << f;
  }
}

/// Checks the sides: labels agree across seams; sides glued inside of a face lie on no edge.
inline void expect_sides(const IT::Cut_surface& s) {
  const IT::Gluing back = glue_back(s);
  IT::validate(back);
  for (std::uint32_t h = 0; h < back.glue.size(); ++h) {
    const std::uint32_t other = back.glue[h];
    EXPECT_EQ(s.sides[h].curve != 0, s.gluing.glue[h] == IT::Gluing::none &&
                                         (other != IT::Gluing::none || s.sides[h].curve != 0));
    if (other == IT::Gluing::none) continue;
    EXPECT_EQ(s.sides[h].curve, s.sides[other].curve);
    EXPECT_EQ(s.sides[h].input_edge, s.sides[other].input_edge);
    EXPECT_EQ(s.sides[h].input_edge == IT::Gluing::none,
              s.input_triangle[h / 3] == s.input_triangle[other / 3]);
  }
}

inline std::ptrdiff_t euler_characteristic(const IT::Cut_surface& s) {
  return IT::euler_characteristic(IT::Gluing_map(s.gluing));
}
inline std::size_t border_loops(const IT::Cut_surface& s) {
  return IT::boundary_loops(IT::Gluing_map(s.gluing)).size();
}

} // namespace cuts

#endif // TEST_EXPECTED_CUTS_H
