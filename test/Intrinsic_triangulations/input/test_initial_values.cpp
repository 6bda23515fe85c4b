// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "refusals.h"

#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/input/initial_values.h>
#include <CGAL/Intrinsic_triangulations/metric/boost_float_traits.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

using namespace CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;
using Interval = CGAL::Interval_nt<false>;
using Float_200 = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<200, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

namespace {

Input_metric of_points(const meshes::Mesh& m) {
  return Input_metric::from_points(m.map(), m.points, 0);
}

Input_metric of_lengths(double ij, double jk, double ki) {
  const meshes::Mesh m{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, 1, 2}}};
  return Input_metric::from_squared_lengths(m.map(), {ij, jk, ki}, 0);
}

// proper, thin, thinner than rounding, far from the origin, and not there at all
std::vector<Input_metric> metrics() {
  std::vector<Input_metric> all;
  for (int k = 0; k <= 52; k += 4) {
    const double h = std::ldexp(1.0, -k);
    all.push_back(of_points({{{0, 0, 0}, {1, 0.1, 0}, {0.3, 0.03 + h, 0.7 * h}}, {{0, 1, 2}}}));
    all.push_back(of_points({{{9.1, 8, 7}, {9.1 + h, 8, 7}, {0.3, 1e-9, 3}}, {{0, 1, 2}}}));
    all.push_back(of_lengths(1, 1 + h, 4 + h));
  }
  all.push_back(of_points({{{0, 0, 0}, {0.1, 0.2, 0.3}, {0.2, 0.4, 0.6}}, {{0, 1, 2}}}));
  all.push_back(of_lengths(1, 1, 4));
  all.push_back(of_lengths(0, 3, 3));
  return all;
}

// The bound that quadruple_area() states, relative to the area, hence twice that for the square.
template <class FT>
void expect_accurate_areas() {
  const Gmpq bound(0x1p-28);
  for (const Input_metric& m : metrics()) {
    const Gmpq exact = m.squared_quadruple_area<Gmpq>(0);
    const FT a = quadruple_area<FT>(m, 0);
    const Gmpq d = Gmpq(CGAL::to_double(a)) * Gmpq(CGAL::to_double(a)) - exact;
    EXPECT_LE(d, bound * exact);
    EXPECT_GE(d, -bound * exact);
    EXPECT_EQ(a == FT(0), exact == 0);
  }
}

TEST(Initial_values, areas_in_floating_point_are_accurate_on_slivers_and_zero_on_caps) {
  expect_accurate_areas<double>();
  expect_accurate_areas<long double>();
  expect_accurate_areas<Float_200>();
}

TEST(Initial_values, area_intervals_contain_the_area_and_are_narrow) {
  for (const Input_metric& m : metrics()) {
    const Gmpq exact = m.squared_quadruple_area<Gmpq>(0);
    const auto [low, high] = [&m] {
      const CGAL::Protect_FPU_rounding<true> upwards;
      const Interval a = quadruple_area<Interval>(m, 0);
      return std::pair{a.inf(), a.sup()};
    }();
    EXPECT_LE(Gmpq(low) * Gmpq(low), exact);
    EXPECT_GE(Gmpq(high) * Gmpq(high), exact);
    EXPECT_GE(low, 0);
    EXPECT_LE(high - low, 0x1p-29 * high);
    const auto same = quadruple_area<CGAL::Interval_nt<true>>(m, 0);
    EXPECT_EQ(same.inf(), low);
    EXPECT_EQ(same.sup(), high);
  }
}

TEST(Initial_values, wide_floats_get_all_their_bits) {
  // about 2^-190 relative, after the square root of a well-conditioned difference
  const Input_metric m = of_points({{{0, 0, 0}, {0.1, 0.7, 0}, {0.3, 0, 1}}, {{0, 1, 2}}});
  const Float_200 a = quadruple_area<Float_200>(m, 0);
  const Float_200 d = from_rational<Float_200>(m.squared_quadruple_area<Gmpq>(0));
  const Float_200 error = abs(a * a - d) / d;
  EXPECT_LT(error.convert_to<double>(), 0x1p-190);
}

TEST(Initial_values, rational_square_roots_are_found) {
  Gmpq root;
  EXPECT_TRUE(rational_square_root(Gmpq(9, 16), root));
  EXPECT_EQ(root, Gmpq(3, 4));
  EXPECT_TRUE(rational_square_root(Gmpq(0), root));
  EXPECT_EQ(root, 0);
  EXPECT_FALSE(rational_square_root(Gmpq(9, 15), root));
  EXPECT_FALSE(rational_square_root(Gmpq(2), root));
}

TEST(Initial_values, rationals_hold_rational_areas_and_name_the_first_face_with_another) {
  EXPECT_EQ(quadruple_area<Gmpq>(of_points({{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}}), 0),
            24);
  meshes::Mesh m = meshes::box(1, 1, 1);
  m.points.back() = {2, 3, 5};
  try {
    quadruple_areas<Gmpq>(of_points(m));
    FAIL();
  } catch (const Invalid_input& e) {
    EXPECT_EQ(e.kind(), Element_kind::face);
    EXPECT_NE(std::string(e.what()).find("face " + std::to_string(e.index())), std::string::npos);
    EXPECT_GT(e.index(), 0U);
  }
}

template <class FT>
void expect_triangle_inequality_is_checked() {
  for (const double l : {4.5, 4.000001, 1e6}) {
    SCOPED_TRACE(l);
    refusals::expect_invalid([l] { quadruple_area<FT>(of_lengths(1, l, 1), 0); },
                             Element_kind::face, 0);
  }
}

TEST(Initial_values, lengths_that_violate_the_triangle_inequality_name_the_face) {
  expect_triangle_inequality_is_checked<double>();
  expect_triangle_inequality_is_checked<long double>();
  expect_triangle_inequality_is_checked<Interval>();
  expect_triangle_inequality_is_checked<Float_200>();
  expect_triangle_inequality_is_checked<Gmpq>();
}

TEST(Initial_values, squared_lengths_of_edges_are_those_of_the_sides) {
  const meshes::Mesh m = meshes::rough_grid(3, 7);
  const Gluing_map map = m.map();
  Input_metric metric = of_points(m);
  metric.set_delta(0.125);
  const std::vector<Gmpq> lengths = squared_lengths<Gmpq>(metric, map);
  for (std::uint32_t f = 0; f < map.number_of_faces(); ++f) {
    Gluing_map::Halfedge h = map.halfedge(Gluing_map::Face{f});
    for (unsigned k = 0; k < 3; ++k, h = map.next(h))
      EXPECT_EQ(lengths[h.index / 2], metric.squared_length<Gmpq>(f, k));
  }
}

// faces of all shapes at multiples of 2^-40
meshes::Mesh shapes() {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> in(-1, 1);
  meshes::Mesh m;
  for (std::uint32_t i = 0; i < 1500; ++i) {
    const double size = std::ldexp(1., -static_cast<int>(i % 9)),
                 height = std::ldexp(size, -static_cast<int>(i % 23));
    const auto near = [](double x) { return std::ldexp(std::round(std::ldexp(x, 40)), -40); };
    const double x = near(in(random)), y = near(in(random)), z = near(in(random));
    m.points.push_back({x, y, z});
    m.points.push_back({near(x + size), near(y + size / 3), near(z - size / 7)});
    const double t = in(random);
    m.points.push_back({near(x + t * size + height), near(y + t * size / 3 - height),
                        near(z - t * size / 7 + height * in(random))});
    m.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return m;
}

TEST(Initial_values, areas_of_faces_in_space_are_enclosed_to_few_units_whatever_their_shape) {
  const Input_metric m = of_points(shapes());
  const CGAL::Protect_FPU_rounding<true> upwards;
  std::size_t thin = 0;
  for (std::uint32_t f = 0; f < m.number_of_faces(); ++f) {
    const Interval area = quadruple_area<Interval>(m, f);
    const Gmpq squared = m.squared_quadruple_area<Gmpq>(f);
    EXPECT_GE(area.inf(), 0);
    EXPECT_LE(Gmpq(area.inf()) * Gmpq(area.inf()), squared) << f;
    EXPECT_GE(Gmpq(area.sup()) * Gmpq(area.sup()), squared) << f;
    EXPECT_LE(area.sup() - area.inf(), 0x1p-47 * area.sup()) << f;
    const double longest = std::max({m.squared_length<double>(f, 0), m.squared_length<double>(f, 1),
                                     m.squared_length<double>(f, 2)});
    if (area.sup() < 1e-4 * longest) ++thin;
  }
  EXPECT_GT(thin, 300U);
}

} // namespace
