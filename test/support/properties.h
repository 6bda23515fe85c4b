// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_PROPERTIES_H
#define TEST_INTRINSIC_TRIANGULATIONS_PROPERTIES_H

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include "places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

// Properties that do not depend on the history of an intrinsic triangulation, or that moves
// conserve.

namespace properties {

namespace IT = CGAL::Intrinsic_triangulations;

template <class T>
using Halfedge = typename T::halfedge_descriptor;
template <class T>
using Edge = typename T::edge_descriptor;

/// The sum of a range of doubles, small ones first.
inline double sum(std::vector<double> x) {
  std::sort(x.begin(), x.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  double result = 0;
  for (const double v : x) result += v;
  return result;
}

template <class T>
double total_area(const T& t) {
  std::vector<double> areas;
  for (const typename T::face_descriptor f : faces(t.mesh())) areas.push_back(t.area(f));
  return sum(areas);
}

/// Expects values alike up to a relative tolerance.
inline void expect_near(const std::vector<double>& a, const std::vector<double>& b,
                        double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], tolerance * b[i]) << i;
}

/// Lengths of the sides of a face.
template <class T>
std::array<double, 3> sides(const T& t, typename T::face_descriptor f) {
  Halfedge<T> h = halfedge(f, t.mesh());
  std::array<double, 3> l{};
  for (double& x : l) {
    x = t.length(edge(h, t.mesh()));
    h = next(h, t.mesh());
  }
  return l;
}

/// Least angle of a face in degrees, from its sides alone: by the law of cosines, as nothing in the
/// library does.
template <class T>
double least_angle(const T& t, typename T::face_descriptor f) {
  std::array<double, 3> l = sides(t, f);
  std::sort(l.begin(), l.end());
  const double c = (l[1] * l[1] + l[2] * l[2] - l[0] * l[0]) / (2 * l[1] * l[2]);
  return std::acos(std::min(1.0, c)) * 180 / std::numbers::pi;
}

/// Sum of the corner angles at each vertex, by its number in the input.
template <class T>
std::vector<double> cone_angles(const T& t) {
  std::vector<double> angles(num_vertices(t.mesh()), 0);
  for (const typename T::face_descriptor f : faces(t.mesh())) {
    Halfedge<T> h = halfedge(f, t.mesh());
    for (int k = 0; k < 3; ++k, h = next(h, t.mesh())) {
      const Halfedge<T> n = next(h, t.mesh()), p = next(n, t.mesh());
      const auto length = [&](Halfedge<T> x) { return t.squared_length(edge(x, t.mesh())); };
      // 2 |u x v| = 4 area, 2 <u, v> for the sides at the source of h
      angles[t.input_vertex(source(h, t.mesh()))] +=
          std::atan2(4 * t.area(f), length(h) + length(p) - length(n));
    }
  }
  return angles;
}

template <class T>
std::ptrdiff_t euler_characteristic(const T& t) {
  return static_cast<std::ptrdiff_t>(num_vertices(t.mesh()) + num_faces(t.mesh())) -
         static_cast<std::ptrdiff_t>(num_edges(t.mesh()));
}

/// The neighbours of each halfedge: equal iff the connectivity is, number by number.
template <class T>
std::vector<std::array<std::uint32_t, 3>> connectivity(const T& t) {
  const IT::Gluing_map& m = t.mesh();
  std::vector<std::array<std::uint32_t, 3>> result;
  for (std::uint32_t h = 0; h < m.number_of_halfedges(); ++h)
    result.push_back({m.next({h}).index, m.target({h}).index, m.face({h}).index});
  return result;
}

/// Squared lengths of the edges, then areas of the faces.
template <class T>
std::vector<double> values(const T& t) {
  std::vector<double> result;
  for (const Edge<T> e : edges(t.mesh())) result.push_back(t.squared_length(e));
  for (const typename T::face_descriptor f : faces(t.mesh())) result.push_back(t.area(f));
  return result;
}

using Vertex_pair = std::pair<std::uint32_t, std::uint32_t>;

/// The cotangent weights between different vertices of the input, added up; none where all are
/// zero.
template <class T>
std::map<Vertex_pair, double> laplacian(T& t) {
  std::map<Vertex_pair, double> result;
  typename T::Session session(t);
  for (const Edge<T> e : edges(t.mesh())) {
    const auto i = t.input_vertex(source(e, t.mesh())), j = t.input_vertex(target(e, t.mesh()));
    const double w = session.cotangent_weight(e);
    if (i != j && w != 0) result[std::minmax(i, j)] += w;
  }
  return result;
}

/// An edge of the Delaunay tessellation: vertices in the input, squared length.
using Tessellation_edge = std::tuple<std::uint32_t, std::uint32_t, double>;

/// The edges that are no ties, sorted: the same for all Delaunay triangulations of a metric.
template <class T>
std::vector<Tessellation_edge> tessellation(T& t) {
  std::vector<char> is_tie(num_edges(t.mesh()), 0);
  for (const Edge<T> e : IT::check_delaunay(t).cocircular_edges) is_tie[t.index(e)] = 1;
  std::vector<Tessellation_edge> result;
  for (const Edge<T> e : edges(t.mesh())) {
    if (is_tie[t.index(e)]) continue;
    const auto i = t.input_vertex(source(e, t.mesh())), j = t.input_vertex(target(e, t.mesh()));
    result.emplace_back(std::min(i, j), std::max(i, j), t.squared_length(e));
  }
  std::sort(result.begin(), result.end());
  return result;
}

inline void expect_same_tessellation(const std::vector<Tessellation_edge>& a,
                                     const std::vector<Tessellation_edge>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(std::get<0>(a[i]), std::get<0>(b[i])) << "edge " << i;
    EXPECT_EQ(std::get<1>(a[i]), std::get<1>(b[i])) << "edge " << i;
    EXPECT_NEAR(std::get<2>(a[i]), std::get<2>(b[i]), tolerance * std::get<2>(b[i]))
        << "edge " << i;
  }
}

/// Entries that one has and the other lacks count as zero there.
inline void expect_same_laplacian(std::map<Vertex_pair, double> a, std::map<Vertex_pair, double> b,
                                  double tolerance) {
  for (const auto& [ij, w] : b) a.try_emplace(ij, 0.0);
  for (const auto& [ij, w] : a)
    EXPECT_NEAR(w, b.try_emplace(ij, 0.0).first->second, tolerance * std::max(1.0, std::abs(w)))
        << "between " << ij.first << " and " << ij.second;
}

/// The values of the diamond of `h`, exactly, from the input. They refer to the argument of `f` and
/// must not leave it.
template <class T, class Function>
void with_exact_values(const T& t, Halfedge<T> h, const Function& f) {
  const places::Exact_input input(t.input().metric());
  t.decider().with_figure(t.diamond(h), [&](const auto& figure) {
    f(figure.template values<IT::Multiquadratic_number>(input));
  });
}

/// Exact squared length of an inner edge if it is rational, else -1.
template <class T>
CGAL::Gmpq rational_squared_length(const T& t, Halfedge<T> h) {
  CGAL::Gmpq result(-1);
  with_exact_values(t, h, [&result](const auto& d) {
    if (d.ij.is_rational()) result = d.ij.coefficient(0);
  });
  return result;
}

/// Exact square of the quadruple area of the left face of an inner halfedge if rational, else -1.
template <class T>
CGAL::Gmpq rational_squared_area(const T& t, Halfedge<T> h) {
  CGAL::Gmpq result(-1);
  with_exact_values(t, h, [&result](const auto& d) {
    const auto square = d.area_f * d.area_f;
    if (square.is_rational()) result = square.coefficient(0);
  });
  return result;
}

/// The inner edges with a face on each side, as halfedges.
template <class T>
std::vector<Halfedge<T>> flippable_by_connectivity(const T& t) {
  std::vector<Halfedge<T>> result;
  const auto null = boost::graph_traits<typename T::Mesh>::null_face();
  for (const Edge<T> e : edges(t.mesh())) {
    const Halfedge<T> h = halfedge(e, t.mesh());
    const auto f = face(h, t.mesh()), g = face(opposite(h, t.mesh()), t.mesh());
    if (f != null && g != null && f != g) result.push_back(h);
  }
  return result;
}

/// The ends of all edges that are no ties, by number.
template <class Triangulation>
std::vector<std::pair<std::uint32_t, std::uint32_t>> edges_without_ties(const Triangulation& t) {
  const typename Triangulation::Const_session session(t);
  const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_face();
  std::vector<std::pair<std::uint32_t, std::uint32_t>> result;
  for (const auto e : edges(t.mesh())) {
    const auto h = halfedge(e, t.mesh());
    const bool is_border =
        face(h, t.mesh()) == null || face(opposite(h, t.mesh()), t.mesh()) == null;
    if (!is_border && session.delaunay_sign(h) == CGAL::ZERO) continue;
    result.push_back(std::minmax(
        {t.numbers().vertex(source(h, t.mesh())), t.numbers().vertex(target(h, t.mesh()))}));
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace properties

#endif // TEST_INTRINSIC_TRIANGULATIONS_PROPERTIES_H
