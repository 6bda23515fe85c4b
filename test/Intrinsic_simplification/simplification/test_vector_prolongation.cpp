// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "coarse_meshes.h"
#include "operator_test_meshes.h"

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_operators/operators/connection_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_simplification/simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/simplification/simplify.h>
#include <CGAL/Intrinsic_simplification/simplification/vector_prolongation.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <queue>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace operator_test;
using T = IT::Corresponding_triangulation;
using Complex = std::complex<double>;
using Complex_matrix = Eigen::SparseMatrix<Complex>;
using Field = Eigen::VectorXcd;

struct Prolonged {
  T fine;
  IT::Simplification s;
  T coarse;
  Complex_matrix p;

  Prolonged(IT::Intrinsic_input input, const IT::Simplify_options& options)
      : fine(IT::delaunay_triangulation(std::move(input))), s(IT::simplify(fine, options)),
        coarse(IT::delaunay_triangulation(s.surface)), p(IT::vector_prolongation(fine, coarse, s)) {
  }
};

std::vector<std::uint32_t> border_of(const Shape& shape) {
  const T t = IT::delaunay_triangulation(shape.input());
  std::vector<std::uint32_t> result;
  for (const auto h : halfedges(t.mesh()))
    if (CGAL::is_border(h, t.mesh())) result.push_back(t.input_vertex(target(h, t.mesh())));
  return result;
}

// Where the vertices of a surface are in the plane that it is unrolled to; nothing for those that a
// test leaves out.
using Unrolled = std::vector<std::optional<Complex>>;

// The constant field 1 of the plane, in the polar coordinates of flat vertices.
std::vector<std::optional<Complex>> constant_field(const T& t, const Unrolled& at) {
  std::vector<std::optional<Complex>> z(at.size());
  for (const auto v : vertices(t.mesh())) {
    const auto to = source(halfedge(v, t.mesh()), t.mesh());
    const std::uint32_t i = t.input_vertex(v), j = t.input_vertex(to);
    if (!at[i] || !at[j]) continue;
    const Complex axis = *at[j] - *at[i];
    z[i] = std::abs(axis) / axis;
  }
  return z;
}

// Prolongs the constant field of the plane; returns how many rows could be compared.
std::size_t compare_constant_fields(const Prolonged& x, const Unrolled& at) {
  Unrolled coarse_at;
  for (const std::uint32_t v : x.s.kept) coarse_at.push_back(at[v]);
  const auto fine = constant_field(x.fine, at), coarse = constant_field(x.coarse, coarse_at);
  Field z = Field::Zero(x.p.cols());
  for (std::size_t i = 0; i < coarse.size(); ++i)
    z[static_cast<Eigen::Index>(i)] = coarse[i].value_or(std::nan(""));
  const Eigen::SparseMatrix<Complex, Eigen::RowMajor> rows = x.p;
  std::size_t compared = 0;
  for (Eigen::Index v = 0; v < rows.rows(); ++v) {
    Complex sum = 0;
    for (decltype(rows)::InnerIterator i(rows, v); i; ++i) sum += i.value() * z[i.col()];
    if (!fine[static_cast<std::size_t>(v)] || std::isnan(sum.real())) continue;
    EXPECT_NEAR(std::abs(sum - *fine[static_cast<std::size_t>(v)]), 0, 1e-9);
    ++compared;
  }
  return compared;
}

TEST(VectorProlongation, keeps_a_constant_field_of_the_plane) {
  Shape shape = rough_grid(12, .3, 0, 2);
  IT::Simplify_options options = to(50);
  options.kept_vertices = border_of(shape);
  const Prolonged x(shape.input(), options);
  Unrolled at;
  for (const auto& p : shape.points) at.emplace_back(Complex(p[0], p[1]));
  for (const std::uint32_t v : options.kept_vertices) at[v].reset(); // angles are scaled there
  EXPECT_EQ(x.p.rows(), 169);
  EXPECT_EQ(x.p.cols(), 50);
  // two inner vertices stay: some faces have none of the border
  options = to(70);
  options.kept_vertices = border_of(shape);
  EXPECT_GT(compare_constant_fields(Prolonged(shape.input(), options), at), 20U);
}

// A parallel field of a flat torus, by copies of vertices.
Field parallel_field(const T& t) {
  const std::vector<Complex> r = IT::transport_along_halfedges(t);
  const IT::Vertex_copies<T> copy(t);
  Field z = Field::Zero(static_cast<Eigen::Index>(copy.size()));
  const auto first = *vertices(t.mesh()).begin();
  z[copy(first)] = 1;
  std::queue<T::vertex_descriptor> queue;
  queue.push(first);
  while (!queue.empty()) {
    const auto v = queue.front();
    queue.pop();
    for (const auto in : CGAL::halfedges_around_target(v, t.mesh())) {
      const auto h = opposite(in, t.mesh());
      const auto w = target(h, t.mesh());
      if (z[copy(w)] != Complex(0)) continue;
      z[copy(w)] = r[t.numbers().halfedge(h)] * z[copy(v)];
      queue.push(w);
    }
  }
  return z;
}

// Compares a prolonged parallel field with that of the fine torus; returns how many rows are known.
std::size_t compare_parallel_fields(const Prolonged& x) {
  const Field found = x.p * parallel_field(x.coarse), expected = parallel_field(x.fine);
  const Complex_matrix rows = x.p.adjoint();
  std::optional<Complex> turn;
  std::size_t known = 0;
  for (Eigen::Index v = 0; v < found.size(); ++v) {
    if (rows.col(v).norm() == 0) continue;
    if (!turn) turn = found[v] / expected[v];
    EXPECT_NEAR(std::abs(found[v] - *turn * expected[v]), 0, 1e-9);
    ++known;
  }
  return known;
}

TEST(VectorProlongation, keeps_parallel_fields_of_a_flat_torus) {
  const Prolonged x(torus(9, .4), to(12));
  ASSERT_EQ(x.p.cols(), 12);
  EXPECT_EQ(compare_parallel_fields(x), 81U);
}

// A flat Klein bottle of n times k squares, the last row joined to the first one mirrored: its
// orientation cover is a flat torus. Places are those of the first copy of each vertex.
TEST(VectorProlongation, keeps_parallel_fields_of_the_cover_of_a_flat_klein_bottle) {
  constexpr std::uint32_t n = 9, k = 7;
  const auto at = [](std::uint32_t i, std::uint32_t j) {
    return i < n ? k * i + j % k : (k - j % k) % k;
  };
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::vector<std::array<double, 3>> lengths;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < k; ++j) {
      faces.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      lengths.push_back({1, std::numbers::sqrt2, 1});
      faces.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      lengths.push_back({1, 1, std::numbers::sqrt2});
    }
  const IT::Domain domain = IT::make_domain(n * k, faces, lengths);
  ASSERT_EQ(domain.report.kind, IT::Domain_kind::orientation_cover);
  const Prolonged x(domain.input, to(24));
  EXPECT_EQ(num_vertices(x.fine.mesh()), 2 * n * k);
  ASSERT_EQ(x.p.cols(), static_cast<Eigen::Index>(x.s.kept.size()));
  EXPECT_LE(x.p.cols(), 24);
  EXPECT_EQ(compare_parallel_fields(x), n * k);
}

// Narrow tori, of one column, two or three: edges are loops, and several segments join two
// vertices.
TEST(VectorProlongation, keeps_parallel_fields_of_narrow_flat_tori) {
  std::mt19937 random(3);
  const auto any = [&] { return static_cast<double>(random() % 1000) / 1000; };
  std::size_t known = 0, all = 0;
  for (int n = 0; n < 40; ++n) {
    SCOPED_TRACE(n);
    const std::uint32_t columns = 1 + static_cast<std::uint32_t>(n) % 3,
                        rows = 12 + static_cast<std::uint32_t>(random() % 20);
    const Complex u(.7 + any(), 0), v(any() - .5, .6 + any());
    const Prolonged x(torus(columns, rows, u, v), to(3 + random() % 5));
    known += compare_parallel_fields(x);
    all += x.fine.number_of_vertices();
  }
  EXPECT_EQ(known, all);
}

TEST(VectorProlongation, keeps_parallel_fields_of_a_cone_away_from_its_apex) {
  // z = (|x| + |y|) / 2: four flat quarters that meet at creases, moved along them
  constexpr std::uint32_t n = 16;
  Shape shape = rough_grid(n, .3, 0, 3);
  const double length = std::sqrt(1.25), turn = std::acos(.25 / 1.25);
  Unrolled at;
  for (std::uint32_t v = 0; v < shape.points.size(); ++v) {
    auto& p = shape.points[v];
    const std::uint32_t i = v % (n + 1), j = v / (n + 1);
    const double x = i == n / 2 ? 0 : p[0] - n / 2., y = j == n / 2 ? 0 : p[1] - n / 2.;
    p = {x, y, (std::abs(x) + std::abs(y)) / 2};
    const int quarter = y >= 0 ? (x > 0 ? 0 : 1) : (x < 0 ? 2 : 3);
    const bool is_even = quarter % 2 == 0;
    const double a = is_even ? std::abs(x) : std::abs(y), b = is_even ? std::abs(y) : std::abs(x);
    at.emplace_back(length * std::polar(1., quarter * turn) * (a + b * std::polar(1., turn)));
    // the cut is at the angle 0; lines must not pass the apex on its other side
    const double angle = quarter * turn + std::arg(a + b * std::polar(1., turn));
    if (angle < turn / 2 || angle > 2.1 * turn || i == 0 || j == 0 || i == n || j == n ||
        (x == 0 && y == 0))
      at.back().reset();
  }
  IT::Simplify_options options = to(120);
  options.kept_vertices = border_of(shape);
  options.kept_vertices.push_back(n / 2 * (n + 2)); // the apex
  EXPECT_GT(compare_constant_fields(Prolonged(shape.input(), options), at), 20U);
}

// Two vertices on a diagonal that are 1e-9 apart: a thin face stays, whose stretch has no bound.
TEST(VectorProlongation, knows_turns_though_a_thin_face_has_no_bound) {
  constexpr std::uint32_t n = 7, a = 3 * (n + 1) + 3, b = a + 1, c = b + n + 1, d = c - 1;
  Shape shape = grid(n);
  for (auto& p : shape.points) p[2] = .1 * std::sin(3 * p[0] + 2 * p[1]);
  std::erase_if(shape.triangles, [&](const auto& t) {
    return std::ranges::all_of(t, [&](auto v) { return v == a || v == b || v == c || v == d; });
  });
  const auto v = static_cast<std::uint32_t>(shape.points.size()), w = v + 1;
  const Eigen::Vector3d m = (shape.point(a) + shape.point(c)) / 2;
  shape.points.push_back({m[0], m[1], m[2]});
  shape.points.push_back({m[0] - 1e-9, m[1] + 1e-9, m[2]});
  for (const auto& t : {std::array{a, b, v}, {v, b, c}, {a, v, w}, {v, c, w}, {a, w, d}, {w, c, d}})
    shape.triangles.push_back(t);
  IT::Simplify_options options = to(20);
  options.kept_vertices = {v, w};
  const Prolonged x(shape.input(), options);
  EXPECT_FALSE(std::isfinite(x.s.stretch.mean_upper));
  const Eigen::VectorXd sums = Eigen::MatrixXd(x.p.cwiseAbs()).rowwise().sum();
  EXPECT_EQ((sums.array() > .9).count(), 66);
}

// The energy of prolonged fields, of which axes and numbers change nothing but a unitary matrix.
Eigen::VectorXd energies(const T& fine, const Complex_matrix& p) {
  const Eigen::MatrixXcd a = p.adjoint() * (IT::connection_laplacian(fine) * Eigen::MatrixXcd(p));
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd>(a).eigenvalues();
}

TEST(VectorProlongation, does_not_depend_on_numbers_and_axes) {
  const Shape shape = rough_torus(10, .3, 4);
  const Prolonged x(shape.input(), to(30));
  const Eigen::VectorXd expected = energies(x.fine, x.p);
  T turned(x.s.surface); // two flips of an edge swap its halfedges: the axes are others
  for (const auto e : edges(turned.mesh()))
    if (turned.flip_edge(halfedge(e, turned.mesh())) == IT::Move_status::done)
      turned.flip_edge(halfedge(e, turned.mesh()));
  for (const unsigned seed : {1U, 2U}) {
    const std::vector<std::uint32_t> order = random_order(shape.points.size(), seed);
    const T fine = IT::delaunay_triangulation(renumbered(shape, order, seed).input());
    IT::Simplification s = x.s;
    for (std::uint32_t v = 0; v < order.size(); ++v) s.places[order[v]] = x.s.places[v];
    for (std::uint32_t& v : s.kept) v = order[v];
    const Complex_matrix p = IT::vector_prolongation(fine, turned, s);
    EXPECT_GT((Eigen::MatrixXcd(p) - Eigen::MatrixXcd(x.p)).norm(), 1); // the matrix is another one
    EXPECT_LT((energies(fine, p) - expected).cwiseAbs().maxCoeff(), 1e-8 * expected.maxCoeff());
  }
}

TEST(VectorProlongation, has_the_moduli_of_the_prolongation_of_functions) {
  for (const Shape& shape : {rough_torus(10, .3, 4), rough_grid(9, .3, .6, 4)}) {
    const Prolonged x(shape.input(), to(20));
    const Matrix expected = IT::prolongation(x.s);
    EXPECT_LT((Matrix(x.p.cwiseAbs()) - expected).norm(), 1e-12);
  }
}

// A sphere: a cube of grids, projected.
Shape sphere(int n) {
  Shape s = cube_of_grids(n);
  for (std::array<double, 3>& p : s.points) {
    for (double& x : p) x = std::tan(std::numbers::pi / 4 * (2 * x / n - 1));
    const double r = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    for (double& x : p) x /= r;
  }
  return s;
}

// The part of a constant vector of space that is tangent to the sphere.
Field tangent_part(const T& t, const Shape& shape, const Eigen::Vector3d& w) {
  Field z(t.number_of_vertices());
  for (const auto v : vertices(t.mesh())) {
    const std::uint32_t i = t.input_vertex(v);
    const auto to = source(halfedge(v, t.mesh()), t.mesh());
    const Eigen::Vector3d normal = shape.point(i).normalized();
    Eigen::Vector3d x = shape.point(t.input_vertex(to)) - shape.point(i);
    x = (x - x.dot(normal) * normal).normalized();
    z[i] = {x.dot(w), normal.cross(x).dot(w)};
  }
  return z;
}

TEST(VectorProlongation, takes_smooth_fields_on_spheres_with_errors_that_fall) {
  double before = 1;
  for (const int n : {6, 12, 24}) {
    const Shape shape = sphere(n);
    const Prolonged x(shape.input(), to(shape.points.size() / 4));
    const Field z = tangent_part(x.fine, shape, {1, .3, -.2});
    // the coarse field: the same vectors at the vertices that stay
    Field coarse(x.p.cols());
    for (std::uint32_t c = 0; c < x.s.kept.size(); ++c)
      coarse[c] = z[x.s.kept[c]] / x.p.coeff(x.s.kept[c], static_cast<int>(c));
    const double error = (x.p * coarse - z).norm() / z.norm();
    EXPECT_LT(error, before / 2.5);
    before = error;
  }
  EXPECT_LT(before, .02);
}

TEST(VectorProlongation, goes_over_every_oriented_surface) {
  std::size_t turned = 0, unknown = 0, filled = 0, empty = 0;
  for (const gallery::Surface& surface : gallery::oriented()) {
    if (surface.expected.isolated_vertices > 0 || surface.expected.nonmanifold_vertices > 0)
      continue;
    SCOPED_TRACE(surface.name);
    const Prolonged x(gallery::input(surface), to(1));
    const Eigen::MatrixXcd p = x.p;
    EXPECT_TRUE(p.allFinite());
    EXPECT_LT(p.cwiseAbs().rowwise().sum().maxCoeff(), 1 + 1e-12);
    const Eigen::VectorXd lengths = p.cwiseAbs().rowwise().sum();
    for (Eigen::Index v = 0; v < p.rows(); ++v) ++(lengths[v] == 0 ? empty : filled);
    // vectors of vertices that stay are only turned, unless all edges are loops or cancel
    for (std::size_t i = 0; i < x.s.kept.size(); ++i) {
      const double factor = std::abs(p(x.s.kept[i], static_cast<Eigen::Index>(i)));
      ++(factor == 0 ? unknown : turned);
      if (factor != 0) {
        EXPECT_NEAR(factor, 1, 1e-12);
      }
    }
  }
  EXPECT_GT(turned, 4 * unknown);
  EXPECT_GT(filled, 4 * empty);
}

} // namespace
