// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "refined_meshes.h"

#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/subdivision_matrices.h>
#include <CGAL/Intrinsic_operators/operators/transfer.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// After refinement in exact arithmetic, on every mesh: areas add up, and functions are taken there and back.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = refined::Triangulation<IT::Integer_coordinates>;

constexpr double tolerance = 1e-12;

void expect_areas(const Triangulation& t, const IT::Common_subdivision& s) {
  const std::vector<double> areas = IT::subdivision_areas(t, s);
  std::vector<double> input(t.input().number_of_faces(), 0),
      intrinsic(t.numbers().face_capacity(t.mesh()), 0);
  for (std::size_t f = 0; f < areas.size(); ++f) {
    input[t.input().names().faces.here(s.input_face[f])] += areas[f];
    intrinsic[s.intrinsic_face[f]] += areas[f];
  }
  for (std::uint32_t f = 0; f < input.size(); ++f) {
    const double area =
        std::ldexp(t.input().quadruple_area(f), -2 * t.input().scale_exponent() - 2);
    EXPECT_NEAR(input[f], area, tolerance * area) << "input face " << f;
  }
  for (const auto f : faces(t.mesh()))
    EXPECT_NEAR(intrinsic[t.index(f)], t.area(f), tolerance * t.area(f)) << "face " << t.index(f);
}

Eigen::VectorXd some_values(Eigen::Index n) {
  Eigen::VectorXd f(n);
  for (Eigen::Index i = 0; i < n; ++i) f[i] = std::sin(13.0 * static_cast<double>(i) + 1);
  return f;
}

TEST(Refined_areas, add_up_to_those_of_all_faces_of_both_triangulations) {
  refined::for_each([](const std::string& name, const auto& source) {
    SCOPED_TRACE(name);
    const auto t = refined::triangulation<IT::Integer_coordinates>(source);
    expect_areas(t, IT::common_subdivision(t));
  });
}

TEST(Refined_transfer, reproduces_constants_and_preserves_integrals) {
  refined::for_each([](const std::string& name, const auto& source) {
    SCOPED_TRACE(name);
    const auto t = refined::triangulation<IT::Integer_coordinates>(source);
    const IT::Common_subdivision s = IT::common_subdivision(t);
    const auto m_intrinsic = IT::galerkin_mass_matrix(t);
    const auto m_input = IT::galerkin_mass_matrix(Triangulation(source));
    const Eigen::VectorXd one = Eigen::VectorXd::Ones(m_intrinsic.rows()),
                          one_there = Eigen::VectorXd::Ones(m_input.rows());
    const double area = one.dot(m_intrinsic * one);
    const IT::L2_transfer to_input(t, s), back(t, s, IT::Transfer_direction::to_intrinsic);
    const auto distance = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
      return (a - b).cwiseAbs().maxCoeff();
    };
    EXPECT_LE(distance(to_input(one), one_there), tolerance);
    EXPECT_LE(distance(back(one_there), one), tolerance);
    EXPECT_LE(distance(IT::copy_to_input(t, one), one_there), tolerance);
    EXPECT_LE(distance(IT::copy_to_intrinsic(t, one_there), one), tolerance);
    const Eigen::VectorXd f = some_values(one.size()), g = some_values(one_there.size());
    EXPECT_NEAR(one_there.dot(m_input * to_input(f)), one.dot(m_intrinsic * f), tolerance * area);
    EXPECT_NEAR(one.dot(m_intrinsic * back(g)), one_there.dot(m_input * g), tolerance * area);
  });
}

} // namespace
