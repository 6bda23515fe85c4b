// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/numbers/Integer_faces.h>

#include "meshes.h"
#include "random_history.h"

#include <CGAL/Gmpq.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;
using CGAL::Gmpz;

IT::Input_metric metric_of(const meshes::Mesh& m, double delta = 0) {
  IT::Input_metric input = IT::Input_metric::from_points(m.map(), m.points, 0);
  input.set_delta(delta);
  return input;
}

// 4^e
Gmpq unit(long e) {
  Gmpz power;
  mpz_ui_pow_ui(power.mpz(), 4, static_cast<unsigned long>(std::abs(e)));
  return e < 0 ? Gmpq(Gmpz(1), power) : Gmpq(power);
}

// against the rational arithmetic of the metric
void expect_same(const IT::Input_metric& input, std::uint32_t f, const IT::Integer_face& face) {
  const Gmpq u = unit(face.exponent);
  for (unsigned k = 0; k < 3; ++k)
    EXPECT_EQ(Gmpq(face.squared_lengths[k]), u * input.squared_length<Gmpq>(f, k));
  EXPECT_EQ(Gmpq(face.area_factor * face.area_factor * face.radicand),
            u * u * input.squared_quadruple_area<Gmpq>(f));
}

TEST(Integer_faces, are_exact_in_words_and_beyond_and_with_mollification) {
  meshes::Mesh wide = meshes::rough_grid(4, 2);
  wide.points[5][0] += std::ldexp(1.0, -80); // is rounded away
  wide.points[6][2] = std::ldexp(1.0, -80);  // makes coordinates of more than a word
  for (const meshes::Mesh& m : {meshes::rough_grid(4, 1), wide, meshes::box(2, 1, 1),
                                meshes::scaled(meshes::rough_grid(4, 3), std::ldexp(1.0, 90)),
                                meshes::scaled(meshes::rough_grid(4, 3), std::ldexp(1.0, -90))})
    for (const double delta : {0.0, std::ldexp(1.0, -31)}) {
      const IT::Input_metric input = metric_of(m, delta);
      IT::Integer_faces faces;
      for (std::uint32_t f = 0; f < m.triangles.size(); ++f) expect_same(input, f, faces(input, f));
    }
}

TEST(Integer_faces, reduced_lengths_are_squared_lengths_over_squares) {
  const meshes::Mesh m = meshes::rough_grid(5, 4);
  const IT::Input_metric input = metric_of(m);
  IT::Integer_faces faces;
  for (std::uint32_t f = 0; f < m.triangles.size(); ++f) {
    const IT::Integer_face& face = faces(input, f);
    for (unsigned k = 0; k < 3; ++k) {
      ASSERT_GT(face.reduced_lengths[k], Gmpz(0));
      const Gmpz square = face.squared_lengths[k] / face.reduced_lengths[k];
      EXPECT_EQ(square * face.reduced_lengths[k], face.squared_lengths[k]);
      EXPECT_NE(mpz_perfect_square_p(square.mpz()), 0);
    }
  }
}

TEST(Integer_faces, reduce_sides_along_axes_and_diagonals_of_cubes) {
  // sides (7, 0, 0), (0, 7, 0), (-7, -7, 0) have shortest vectors of squared lengths 1, 1, 2
  const meshes::Mesh m = meshes::scaled(meshes::box(1, 1, 1), 7);
  const IT::Input_metric input = metric_of(m);
  IT::Integer_faces faces;
  for (std::uint32_t f = 0; f < m.triangles.size(); ++f) {
    const IT::Integer_face& face = faces(input, f);
    EXPECT_EQ(face.radicand, Gmpz(1));
    EXPECT_EQ(face.reduced_lengths[0] + face.reduced_lengths[1] + face.reduced_lengths[2], Gmpz(4));
  }
}

TEST(Integer_faces, tell_flat_from_folded_and_degenerate_ones) {
  const auto face = [](const IT::Input_metric& input, std::uint32_t f) {
    IT::Integer_faces faces;
    return faces(input, f);
  };
  meshes::Mesh m{{{0, 0, 0}, {3, 0, 1}, {3, 5, 1}, {0, 5, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  EXPECT_TRUE(IT::Integer_faces::are_flat(face(metric_of(m), 0), face(metric_of(m), 1)));
  EXPECT_EQ(face(metric_of(m), 0).radicand, face(metric_of(m), 1).radicand);
  m.points[3] = {3, 4, 1}; // folded over onto the first face
  EXPECT_FALSE(IT::Integer_faces::are_flat(face(metric_of(m), 0), face(metric_of(m), 1)));
  m.points[3] = {0, 5, std::ldexp(1.0, -1000)};
  EXPECT_FALSE(IT::Integer_faces::are_flat(face(metric_of(m), 0), face(metric_of(m), 1)));
  m.points[1] = m.points[0];
  m.points[3] = m.points[0];
  EXPECT_FALSE(IT::Integer_faces::are_flat(face(metric_of(m), 0), face(metric_of(m), 1)));
}

} // namespace
