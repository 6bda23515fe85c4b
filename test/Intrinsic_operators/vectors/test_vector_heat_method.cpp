// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/vectors/Vector_heat_method.h>
#include <CGAL/Intrinsic_operators/vectors/logarithmic_map.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/vector_field.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include "Following.h"
#include "copies.h"
#include "delaunay.h"
#include "gallery.h"
#include "mesh_types.h"
#include "meshes.h"
#include "operator_test_meshes.h"
#include "soups.h"
#include "surface_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Complex = std::complex<double>;
using Exact = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                          IT::Integer_coordinates>;
using Heat = IT::Vector_heat_method<Exact>;
using Values = std::vector<std::pair<Exact::vertex_descriptor, double>>;
using Vectors = std::vector<std::pair<Exact::vertex_descriptor, Complex>>;
constexpr double pi = std::numbers::pi;

using Point = std::array<double, 3>;

/// The vector in space of one at a vertex, by a short geodesic; an inner vertex in a plane.
template <class T>
Complex in_plane(const T& t, typename T::vertex_descriptor v, Complex z,
                 const std::vector<Point>& points) {
  const IT::Geodesic g = IT::exponential_map(t, v, z / std::abs(z) * 1e-3);
  const auto p = IT::point_in_space(t, *IT::locate_on_input(t, g.points.front()), points);
  const auto q = IT::point_in_space(t, *IT::locate_on_input(t, g.points.back()), points);
  const Complex d(q[0] - p[0], q[1] - p[1]);
  return d / std::abs(d) * std::abs(z);
}

template <class T>
bool is_on_border(const T& t, typename T::vertex_descriptor v) {
  const auto null = boost::graph_traits<typename T::Mesh>::null_face();
  return face(halfedge(v, t.mesh()), t.mesh()) == null;
}

template <class T>
class Vector_heat_on : public testing::Test {};
// Nothing depends on two of mesh type, metric and correspondence at once.
using Vector_heat_choices =
    testing::Types<Exact, IT::Intrinsic_triangulation<OpenMesh_triangles,
                                                      IT::Euclidean_traits<double>, IT::Signposts>>;
TYPED_TEST_SUITE(Vector_heat_on, Vector_heat_choices);

TYPED_TEST(Vector_heat_on, transports_from_vertices_and_points_in_the_plane_exactly) {
  const meshes::Mesh shape = meshes::scaled(meshes::random_planar(60, 1000, 2), 0.01);
  TypeParam t(meshes::surface_mesh<Surface_mesh>(shape));
  IT::delaunay_refine(t, IT::parameters::minimum_angle(25));
  const IT::Vector_heat_method<TypeParam> heat(t);
  const auto expect_parallel = [&](const IT::Tangent_field& field, const Complex& expected) {
    ASSERT_EQ(field.size(), t.number_of_vertices());
    for (const auto w : vertices(t.mesh()))
      if (!is_on_border(t, w)) {
        EXPECT_LE(std::abs(in_plane(t, w, field[t.input_vertex(w)], shape.points) - expected),
                  1e-6);
      }
  };
  for (const auto v : vertices(t.mesh()))
    if (t.index(v) % 7 == 0 && !is_on_border(t, v))
      expect_parallel(heat.transport(v, {1, 2}), in_plane(t, v, {1, 2}, shape.points));
  for (const auto f : faces(t.mesh())) {
    if (t.index(f) % 20 != 0) continue;
    const IT::Surface_point p =
        IT::surface_point(t, IT::Face_location<typename TypeParam::Mesh>(f, {0.2, 0.3, 0.5}));
    const IT::Geodesic g = IT::exponential_map(t, p, 1e-3);
    const auto a = IT::point_in_space(t, *IT::locate_on_input(t, p), shape.points);
    const auto b = IT::point_in_space(t, *IT::locate_on_input(t, g.points.back()), shape.points);
    const Complex x = Complex(b[0] - a[0], b[1] - a[1]) * 1e3;
    expect_parallel(heat.transport(IT::Tangent_vector{p, {1, 2}}), x * Complex(1, 2));
  }
}

TYPED_TEST(Vector_heat_on, can_be_followed_and_cancelled) {
  const TypeParam t(meshes::surface_mesh<Surface_mesh>(meshes::random_planar(60, 100, 2)));
  const auto v = *vertices(t.mesh()).begin(), w = *std::next(vertices(t.mesh()).begin(), 20);
  const IT::Vector_heat_method<TypeParam> heat(t), other(t);
  std::vector<IT::Transport_step> steps;
  const auto follow = IT::parameters::visitor(Following{[&](IT::Transport_step step) {
    steps.push_back(step);
    return steps.size() > 1;
  }});
  EXPECT_EQ(heat.factor(follow), IT::Status::cancelled);
  EXPECT_EQ(heat.factor(follow), IT::Status::done);
  using Step = IT::Transport_step;
  EXPECT_EQ(steps, (std::vector<Step>{Step::functions_factored, Step::functions_factored,
                                      Step::vectors_factored}));
  EXPECT_EQ(heat.factor(), IT::Status::done);
  EXPECT_EQ(heat.transport(v, {1, 2}), other.transport(v, {1, 2}));
  const IT::Vector_heat_method<TypeParam> one_by_one(t);
  EXPECT_FALSE(one_by_one.is_factored(Step::vectors_factored));
  one_by_one.factor(Step::vectors_factored);
  EXPECT_TRUE(one_by_one.is_factored(Step::vectors_factored));
  EXPECT_EQ(heat.transport(v, {1, 2}), one_by_one.transport(v, {1, 2}));
  EXPECT_FALSE(one_by_one.is_factored(Step::functions_factored)); // one vector does not need it
  one_by_one.factor(Step::functions_factored);
  EXPECT_TRUE(one_by_one.is_factored(Step::functions_factored));
  const std::vector<std::pair<typename TypeParam::vertex_descriptor, double>> sources{{v, 1.},
                                                                                      {w, 2.}};
  EXPECT_EQ(heat.extend_scalars(sources), one_by_one.extend_scalars(sources));
}

TEST(Vector_heat_method, does_not_depend_on_the_order_of_sources_nor_change_single_lengths) {
  Exact t = delaunay<Exact>(meshes::potato(3, 5).input());
  const Heat heat(t);
  const auto v = t.numbers().vertex_at(3), w = t.numbers().vertex_at(70);
  const IT::Tangent_field one = heat.transport(v, {3, 4});
  for (const Complex& z : one) EXPECT_NEAR(std::abs(z), 5, 1e-9);
  EXPECT_LE(std::abs(one[3] - Complex(3, 4)), 1e-9);
  const IT::Tangent_field a = heat.transport(Vectors{{v, {3, 4}}, {w, 1}}),
                          b = heat.transport(Vectors{{w, 1}, {v, {3, 4}}});
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_LE(std::abs(a[i] - b[i]), 1e-9);
    EXPECT_LE(std::abs(a[i]), 5 + 1e-9); // between the lengths of sources
    EXPECT_GE(std::abs(a[i]), 1 - 1e-9);
  }
}

/// Along a meridian of the sphere the transported vector keeps its angle with it.
TEST(Vector_heat_method, converges_on_the_sphere) {
  std::vector<double> errors;
  for (const unsigned levels : {3U, 4U, 5U}) {
    const meshes::Mesh shape = meshes::sphere(levels);
    Exact t = delaunay<Exact>(shape.input());
    const Heat heat(t);
    const auto v = t.numbers().vertex_at(0);
    const IT::Tangent_field field = heat.transport(v, 1);
    const auto vectors = IT::vectors_in_space(t, field, meshes::surface_mesh<Surface_mesh>(shape));
    const Point& x = shape.points[0];
    const Point& e = vectors[0];
    double worst = 0;
    for (std::size_t i = 1; i < shape.points.size(); ++i) {
      const Point& y = shape.points[i];
      const auto dot = [](const Point& a, const Point& b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
      };
      const double c = dot(x, y);
      if (c < 0) continue; // beyond a quarter of a great circle
      Point expected;      // the rotation from x to y
      for (std::size_t k = 0; k < 3; ++k) expected[k] = e[k] - dot(e, y) / (1 + c) * (x[k] + y[k]);
      const Point& z = vectors[i];
      const Point cross{expected[1] * z[2] - expected[2] * z[1],
                        expected[2] * z[0] - expected[0] * z[2],
                        expected[0] * z[1] - expected[1] * z[0]};
      const double angle =
          std::atan2(dot(cross, y), dot(expected, z) - dot(expected, y) * dot(z, y));
      worst = std::max(worst, std::abs(angle));
    }
    errors.push_back(worst);
  }
  EXPECT_LT(errors[2], 0.06);
  EXPECT_LT(errors[1], 0.7 * errors[0]);
  EXPECT_LT(errors[2], 0.7 * errors[1]);
}

/// Heat underflows on the way: its values have exponents of their own.
TEST(Vector_heat_method, reaches_the_far_end_of_a_long_strip_exactly) {
  const meshes::Mesh shape = meshes::grid(2000, 2);
  Exact t(shape.input());
  const Heat heat(t);
  const auto v = t.numbers().vertex_at(2001 + 3); // in the middle row
  const Complex expected = in_plane(t, v, {1, 2}, shape.points);
  const IT::Tangent_field field = heat.transport(v, {1, 2});
  const std::vector<Complex> affine = heat.logarithmic_map(v),
                             polar = heat.logarithmic_map(v, IT::Logarithm_method::polar);
  for (std::uint32_t i = 2001 + 1; i < 2 * 2001 - 1; ++i) {
    const Complex z = in_plane(t, t.numbers().vertex_at(i), field[i], shape.points);
    EXPECT_LE(std::abs(z - expected), 1e-5) << i;
    const double r = std::abs(shape.points[i][0] - 3);
    EXPECT_NEAR(std::abs(affine[i]), r, 1e-5 * r) << i;
    EXPECT_NEAR(std::abs(polar[i]), r, 0.1 * r + 1) << i;
  }
  EXPECT_LE((heat.extend_scalars(Values{{v, 7}}).array() - 7).abs().maxCoeff(), 1e-9);
}

/// Tiny and huge values at the ends of a strip; products with the heat in doubles lose both.
TEST(Vector_heat_method,
     keeps_values_of_very_different_size_where_heat_is_below_the_range_of_doubles) {
  const std::uint32_t length = 2000, row = length + 1;
  Exact t(meshes::grid(length, 2).input());
  const Heat heat(t);
  const auto first = t.numbers().vertex_at(row + 2), last = t.numbers().vertex_at(2 * row - 3);
  const Eigen::VectorXd log = heat.log_heat({0, {1, 0, 0}}); // falls by the same factor per edge
  const double fall = log[101] - log[100];
  for (const double large : {1e60, 1e162, 1e200, 1e300}) {
    const double small = 1 / large; // their ratio in doubles or not
    const Eigen::VectorXd values = heat.extend_scalars(Values{{first, small}, {last, large}});
    const IT::Tangent_field field =
        heat.transport(Vectors{{first, {0, small}}, {last, {large, 0}}});
    // a value arrives where heat of the other by so much less does not count
    const double reach = length / 2 + (std::log(large) + 10) / fall;
    for (std::uint32_t i = 0; i < 3 * row; ++i) {
      const std::uint32_t x = i % row;
      if (x > reach && x < 1200) continue;
      const double expected = x <= reach ? small : large;
      EXPECT_NEAR(values[i] / expected, 1, 1e-6) << i << ' ' << large;
      EXPECT_NEAR(std::abs(field[i]) / expected, 1, 1e-6) << i << ' ' << large;
    }
  }
  EXPECT_LT(log[1900], -1500);
  for (std::uint32_t x = 100; x < 1900; ++x) EXPECT_NEAR(log[x + 1] - log[x], fall, 1e-6) << x;
}

// Above 1e8 areas of the surface heat is even. In squares of the mean edge length, which is below
// the area of this surface.
TEST(Vector_heat_method, refuses_times_in_which_heat_is_even_or_does_not_spread) {
  const Exact t(meshes::potato(2, 3).input());
  for (const double time : {1e-90, 1e-3, 1., 1e6})
    EXPECT_NO_THROW(Heat(t, IT::parameters::time_factor(time))) << time;
  for (const double time : {0., -1., 1e-200, 1e20, 1e300, std::numeric_limits<double>::infinity(),
                            std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(Heat(t, IT::parameters::time_factor(time)), std::invalid_argument) << time;
}

TEST(Vector_heat_method, extends_scalars_between_their_extremes_and_by_the_nearest_source) {
  Exact t(meshes::grid(10, 4).input());
  const Heat heat(t);
  const auto at = [&t](std::uint32_t i) { return t.numbers().vertex_at(i); };
  const Eigen::VectorXd one = heat.extend_scalars(Values{{at(3), 7}});
  EXPECT_LE((one.array() - 7).abs().maxCoeff(), 1e-9);
  const Eigen::VectorXd two = heat.extend_scalars(Values{{at(0), 2}, {at(54), -1}});
  EXPECT_LE(two.maxCoeff(), 2 + 1e-9);
  EXPECT_GE(two.minCoeff(), -1 - 1e-9);
  for (const std::uint32_t i : {0U, 1U, 2U, 11U, 22U}) EXPECT_NEAR(two[i], 2, 0.2);
  for (const std::uint32_t i : {54U, 53U, 43U}) EXPECT_NEAR(two[i], -1, 0.2);
}

TEST(Vector_heat_method, knows_nothing_of_components_without_a_source_and_isolated_vertices) {
  constexpr std::uint32_t n = 8;
  operator_test::Shape m = operator_test::beside(operator_test::cube(), operator_test::cube(), 5);
  m.points.push_back({20, 20, 20});
  Exact t(m.input());
  const Heat heat(t);
  const IT::Tangent_field field = heat.transport(t.numbers().vertex_at(0), {0, 1});
  for (std::uint32_t i = 0; i < field.size(); ++i) {
    if (i < n)
      EXPECT_NEAR(std::abs(field[i]), 1, 1e-9) << i;
    else
      EXPECT_TRUE(std::isnan(field[i].real()) && std::isnan(field[i].imag())) << i;
  }
  for (const auto method :
       {IT::Logarithm_method::exact, IT::Logarithm_method::affine, IT::Logarithm_method::polar}) {
    const std::vector<Complex> log = heat.logarithmic_map(t.numbers().vertex_at(0), method);
    for (std::uint32_t i = 0; i < log.size(); ++i) {
      EXPECT_EQ(std::abs(log[i]) > 0, i > 0 && i < n) << i;
      EXPECT_EQ(std::isnan(log[i].real()) && std::isnan(log[i].imag()), i >= n) << i;
    }
  }
  const Eigen::VectorXd values = heat.extend_scalars(Values{{t.numbers().vertex_at(0), 3}});
  for (std::uint32_t i = 0; i < values.size(); ++i)
    EXPECT_TRUE(i < n ? std::abs(values[i] - 3) < 1e-9 : std::isnan(values[i])) << i;
  const auto isolated = t.numbers().vertex_at(2 * n), good = t.numbers().vertex_at(0);
  EXPECT_THROW(heat.transport(Vectors{{isolated, 1}}), std::invalid_argument);
  EXPECT_THROW(heat.transport(Vectors{}), std::invalid_argument);
  EXPECT_THROW(heat.extend_scalars(Values{}), std::invalid_argument);
  EXPECT_THROW(heat.extend_scalars(Values{{good, std::numeric_limits<double>::infinity()}}),
               std::invalid_argument);
  EXPECT_THROW(heat.logarithmic_map(isolated), std::invalid_argument);
  const IT::Surface_point p{0, {0.5, 0.25, 0.25}};
  EXPECT_THROW(heat.logarithm_at(std::vector<Complex>(2 * n), p, p), std::invalid_argument);
}

// Of the copies of each row, the first one and the one with the shortest vector are chosen.
void expect_copies_of_rows(const Exact& t, const std::vector<Complex>& log) {
  const IT::Vertex_copies copies(t);
  const std::vector<std::uint32_t> first = copies.first_of_rows(),
                                   nearest = copies.nearest_of_rows(log);
  ASSERT_EQ(first.size(), t.number_of_vertices());
  ASSERT_EQ(nearest.size(), t.number_of_vertices());
  for (const auto v : vertices(t.mesh())) {
    const std::uint32_t row = t.input_vertex(v);
    EXPECT_LE(first[row], copies(v));
    EXPECT_FALSE(std::abs(log[copies(v)]) < std::abs(log[nearest[row]]));
    EXPECT_TRUE(std::isfinite(std::abs(log[nearest[row]])) ||
                !std::isfinite(std::abs(log[copies(v)])));
  }
}

TEST(Vector_heat_method, is_finite_where_paths_lead_on_covers_and_delta_complexes) {
  std::vector<IT::Intrinsic_input> inputs;
  for (const meshes::Mesh& m : {soups::book(), soups::three_fins(), soups::moebius_strip()})
    inputs.push_back(IT::make_domain(soups::soup(m)).input);
  for (const gallery::Surface& s : gallery::oriented()) inputs.push_back(operator_test::input(s));
  for (IT::Intrinsic_input& input : inputs) {
    Exact t = delaunay<Exact>(std::move(input));
    const Heat heat(t);
    const IT::Vertex_copies copies(t);
    for (const auto v : vertices(t.mesh())) {
      if (copies_test::is_isolated(t, v)) continue;
      const IT::Tangent_field field = heat.transport(v, {1, 1});
      ASSERT_EQ(field.size(), copies.size());
      const std::vector<Complex> paths = heat.logarithmic_map(v);
      expect_copies_of_rows(t, paths);
      const auto expect_known = [&](const std::vector<Complex>& found) {
        for (std::size_t i = 0; i < found.size(); ++i) {
          const bool is_known = std::isfinite(found[i].real()) && std::isfinite(found[i].imag());
          EXPECT_TRUE(is_known || std::isnan(found[i].real() + found[i].imag()));
          EXPECT_TRUE(!is_known || std::isfinite(paths[i].real())) << i;
        }
      };
      expect_known(field); // on symmetric surfaces nothing may be left of vectors
      EXPECT_NEAR(std::abs(field[copies(v)]), std::sqrt(2.), 1e-9);
      for (const auto method : {IT::Logarithm_method::affine, IT::Logarithm_method::polar})
        expect_known(heat.logarithmic_map(v, method));
    }
  }
}

} // namespace
