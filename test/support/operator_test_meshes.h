// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TEST_OPERATOR_TEST_MESHES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TEST_OPERATOR_TEST_MESHES_H

#include "dense_eigenvalues.h"
#include "gallery.h"
#include "mesh_types.h"
#include "torus_gluing.h"

#include <CGAL/Intrinsic_triangulation.h>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

/*!
\file
Surfaces with closed forms, and mesh types, for the tests of operators.
*/

namespace operator_test {

namespace IT = CGAL::Intrinsic_triangulations;

using Matrix = Eigen::SparseMatrix<double>;
using Exact = IT::Intrinsic_triangulation<>;
using Double = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>>;

struct Shape {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  IT::Gluing_map gluing_map() const {
    return IT::Gluing_map(
        IT::gluing_from_triangles(static_cast<std::uint32_t>(points.size()), triangles));
  }
  IT::Intrinsic_input input(IT::Mollification m = IT::Mollification::none) const {
    return {gluing_map(), points, m};
  }
  Eigen::Vector3d point(std::uint32_t v) const { return Eigen::Vector3d(points[v].data()); }
};

/// The square [0, n] x [0, n] in the plane z = 0, vertex (x, y) has number (n + 1) y + x.
inline Shape grid(std::uint32_t n) {
  Shape s;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x)
      s.points.push_back({static_cast<double>(x), static_cast<double>(y), 0});
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t v = (n + 1) * y + x;
      s.triangles.push_back({v, v + 1, v + n + 2});
      s.triangles.push_back({v, v + n + 2, v + n + 1});
    }
  return s;
}

/// A grid whose vertices are moved at random: by up to `plane` within the plane, `height` out of it.
inline Shape rough_grid(std::uint32_t n, double plane, double height, unsigned seed) {
  Shape s = grid(n);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> d(-1, 1);
  for (std::array<double, 3>& p : s.points)
    p = {p[0] + plane * d(random), p[1] + plane * d(random), p[2] + height * d(random)};
  return s;
}

/// The unit cube, each face split by a diagonal; vertex number is x + 2 y + 4 z.
inline Shape cube() {
  Shape s;
  for (unsigned v = 0; v < 8; ++v)
    s.points.push_back({static_cast<double>(v & 1U), static_cast<double>(v >> 1 & 1U),
                        static_cast<double>(v >> 2)});
  const std::uint32_t quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& q : quads) {
    s.triangles.push_back({q[0], q[1], q[2]});
    s.triangles.push_back({q[0], q[2], q[3]});
  }
  return s;
}

/// A regular tetrahedron with edges of length 2 sqrt 2.
inline Shape tetrahedron() {
  return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

/// Two shapes beside each other, the second one moved along the x-axis; its numbers come after those of the first.
inline Shape beside(Shape first, const Shape& second, double x = 10) {
  const auto n = static_cast<std::uint32_t>(first.points.size());
  for (const std::array<double, 3>& p : second.points)
    first.points.push_back({p[0] + x, p[1], p[2]});
  for (const auto& f : second.triangles) first.triangles.push_back({f[0] + n, f[1] + n, f[2] + n});
  return first;
}

/// Two of them, of vertices 0 to 3 and 4 to 7.
inline Shape two_tetrahedra() { return beside(tetrahedron(), tetrahedron()); }

/// A random numbering: `order[v]` is the new number of vertex `v`.
inline std::vector<std::uint32_t> random_order(std::size_t n, unsigned seed) {
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0U);
  std::shuffle(order.begin(), order.end(), std::mt19937(seed));
  return order;
}

/// The same shape with vertices renumbered and triangles shuffled and turned.
inline Shape renumbered(const Shape& s, const std::vector<std::uint32_t>& order, unsigned seed) {
  Shape r = s;
  for (std::size_t v = 0; v < order.size(); ++v) r.points[order[v]] = s.points[v];
  std::mt19937 random(seed);
  std::shuffle(r.triangles.begin(), r.triangles.end(), random);
  for (auto& t : r.triangles) {
    for (std::uint32_t& v : t) v = order[v];
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
  }
  return r;
}

/// The rows and columns of a matrix, permuted by `order`.
inline Matrix renumbered(const Matrix& m, const std::vector<std::uint32_t>& order) {
  Eigen::PermutationMatrix<Eigen::Dynamic> p(m.rows());
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    p.indices()[i] = static_cast<int>(order[static_cast<std::size_t>(i)]);
  return p * m * p.transpose();
}

/*!
The torus of a grid of n x m parallelograms with sides u and v in the plane: an abstract metric.
Vertex (x, y) has number n y + x.
*/
inline IT::Intrinsic_input torus(std::uint32_t n, std::uint32_t m, const std::complex<double>& u,
                                 const std::complex<double>& v) {
  IT::Gluing_map map(torus_gluing(n, m));
  std::vector<double> squared(map.number_of_edges());
  const double length[3] = {std::norm(u), std::norm(v), std::norm(u + v)};
  for (std::uint32_t f = 0; f < map.number_of_faces(); ++f) {
    IT::Gluing_map::Halfedge h = map.halfedge(IT::Gluing_map::Face{f});
    for (const unsigned k : f % 2 == 0 ? std::array{0U, 1U, 2U} : std::array{2U, 0U, 1U}) {
      squared[h.index / 2] = length[k];
      h = map.next(h);
    }
  }
  return {std::move(map), std::move(squared)};
}

/// The same of n x n parallelograms with sides (1, 0) and (shear, 1).
inline IT::Intrinsic_input torus(std::uint32_t n, double shear) {
  return torus(n, n, 1, {shear, 1});
}

using gallery::input;

/// A torus in space of n x n cells, with vertices moved out or in at random by up to `height`.
inline Shape rough_torus(std::uint32_t n, double height, unsigned seed) {
  Shape s;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> d(-height, height);
  for (std::uint32_t v = 0; v < n * n; ++v) {
    const double a = 2 * std::numbers::pi * (v % n) / n, b = 2 * std::numbers::pi * (v / n) / n;
    const double r = 1 + d(random), out = 3 + r * std::cos(b);
    s.points.push_back({out * std::cos(a), out * std::sin(a), r * std::sin(b)});
    const std::uint32_t right = v - v % n + (v + 1) % n, up = n * n;
    s.triangles.push_back({v, right, (right + n) % up});
    s.triangles.push_back({v, (right + n) % up, (v + n) % up});
  }
  return s;
}

/// builds a mesh of any type, with the numbering of the shape
template <class Mesh>
Mesh mesh_of(const Shape& s) {
  Mesh mesh;
  IT::copy_gluing_map(s.gluing_map(), mesh);
  std::size_t i = 0;
  for (const typename boost::graph_traits<Mesh>::vertex_descriptor v : vertices(mesh)) {
    const std::array<double, 3>& p = s.points[i++];
    if constexpr (requires { mesh.set_point(v, OpenMesh::Vec3d(p[0], p[1], p[2])); })
      mesh.set_point(v, OpenMesh::Vec3d(p[0], p[1], p[2]));
    else
      put(get(CGAL::vertex_point, mesh), v, Kernel::Point_3(p[0], p[1], p[2]));
  }
  return mesh;
}

inline Eigen::VectorXd random_vector(Eigen::Index n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> d(-1, 1);
  return Eigen::VectorXd::NullaryExpr(n, [&] { return d(random); });
}

/// The largest entry of |a - b|, in units of the largest entry of |b|.
inline double relative_difference(const Matrix& a, const Matrix& b) {
  const Matrix d = a - b;
  const auto largest = [](const Matrix& m) {
    return m.nonZeros() == 0 ? 0.0 : m.coeffs().abs().maxCoeff();
  };
  return largest(d) / largest(b);
}

inline bool same_pattern(const Matrix& a, const Matrix& b) {
  return a.rows() == b.rows() && a.nonZeros() == b.nonZeros() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.outerSize() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

inline bool is_symmetric_bit_by_bit(const Matrix& m) {
  const Matrix t = m.transpose();
  return same_pattern(m, t) && std::equal(m.valuePtr(), m.valuePtr() + m.nonZeros(), t.valuePtr());
}

inline Eigen::VectorXd eigenvalues(const Matrix& m) {
  return dense_eigenvalues(Eigen::MatrixXd(m));
}

} // namespace operator_test

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TEST_OPERATOR_TEST_MESHES_H
