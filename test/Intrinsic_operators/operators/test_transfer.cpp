// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "subdivisions.h"
#include "transferred_meshes.h"

#include <CGAL/Intrinsic_operators/operators/transfer.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace {

using namespace transferred;
using Complex = std::complex<double>;
using IT::Transfer_direction;

// Areas and parameters of crossings have relative errors of 1e-11 at most, see
// test_subdivision_matrices.cpp; scaled mass matrices have condition numbers below 4.
constexpr double tolerance = 1e-10;

double norm(const Matrix& mass, const Eigen::VectorXd& v) { return std::sqrt(v.dot(mass * v)); }

double integral(const Matrix& mass, const Eigen::VectorXd& v) { return (mass * v).sum(); }

// The error is orthogonal to all functions there: so it never makes a function larger.
TEST(L2_transfer, to_the_input_is_the_nearest_function_and_preserves_the_integral) {
  for (const Case& c : all_cases()) {
    const Eigen::VectorXd f = random_vector(c.subdivision.number_of_intrinsic_vertices, 1);
    const Eigen::VectorXd g = IT::L2_transfer(c.triangulation, c.subdivision)(f);
    const Matrix m = IT::subdivision_mass_matrix(c.triangulation, c.subdivision);
    const Matrix p = IT::interpolation_from_input(c.subdivision),
                 q = IT::interpolation_from_intrinsic(c.subdivision);
    const Eigen::VectorXd residual = p.transpose() * (m * (q * f - p * g));
    EXPECT_LE(residual.cwiseAbs().maxCoeff(), tolerance * m.sum()) << c.name;
    EXPECT_NEAR(integral(c.input_mass, g), integral(IT::galerkin_mass_matrix(c.triangulation), f),
                tolerance * c.input_mass.sum())
        << c.name;
    const auto distance = [&](const Eigen::VectorXd& h) {
      return IT::L2_distance(c.triangulation, c.subdivision, f, h);
    };
    const double least = distance(g), slack = tolerance * norm(c.input_mass, g);
    EXPECT_LE(least, distance(IT::copy_to_input(c.triangulation, f)) + slack) << c.name;
    const double tiny = 0x1p-700; // whose square is zero
    EXPECT_NEAR(IT::L2_distance(c.triangulation, c.subdivision, tiny * f, tiny * g) / tiny, least,
                slack)
        << c.name;
    for (const unsigned seed : {3U, 4U}) {
      const Eigen::VectorXd d = random_vector(g.size(), seed) / 100;
      // Pythagoras
      EXPECT_NEAR(std::pow(distance(g + d), 2), std::pow(least, 2) + d.dot(c.input_mass * d),
                  tolerance * (1 + c.input_mass.sum()))
          << c.name;
    }
  }
}

TEST(L2_transfer, to_the_intrinsic_triangulation_preserves_the_integral) {
  for (const Case& c : all_cases()) {
    const Eigen::VectorXd g = random_vector(c.input_mass.rows(), 6);
    const IT::L2_transfer there(c.triangulation, c.subdivision, Transfer_direction::to_intrinsic);
    EXPECT_NEAR(integral(IT::galerkin_mass_matrix(c.triangulation), there(g)),
                integral(c.input_mass, g), tolerance * c.input_mass.sum())
        << c.name;
  }
}

TEST(L2_transfer, is_exact_for_functions_that_are_linear_on_both_triangulations) {
  for (const Case& c : all_cases()) {
    const Eigen::VectorXd f = c.is_planar()
                                  ? c.values([](double x, double y) { return 3 + x - 2 * y; })
                                  : Eigen::VectorXd(7 * Eigen::VectorXd::Ones(c.input_mass.rows()));
    const double error = tolerance * f.cwiseAbs().maxCoeff();
    const Eigen::VectorXd on_intrinsic = IT::copy_to_intrinsic(c.triangulation, f);
    const IT::L2_transfer back(c.triangulation, c.subdivision),
        there(c.triangulation, c.subdivision, Transfer_direction::to_intrinsic);
    EXPECT_LE((back(on_intrinsic) - f).cwiseAbs().maxCoeff(), error) << c.name;
    EXPECT_LE((there(f) - on_intrinsic).cwiseAbs().maxCoeff(), error) << c.name;
  }
}

TEST(L2_transfer, loses_nothing_on_a_refinement_of_the_input) {
  // insertions without flips refine: functions of the input are linear on the intrinsic triangulation
  IT::Intrinsic_input input = meshes::rough_grid(5, 7).input();
  Triangulation t(std::move(input));
  std::mt19937 random(8);
  for (int i = 0; i < 30; ++i) {
    const auto h = static_cast<std::uint32_t>(random() % t.mesh().number_of_halfedges());
    t.insert_vertex({h}, {0.25, 0.25, 0.5});
  }
  const IT::Common_subdivision s = IT::common_subdivision(t);
  ASSERT_GT(s.vertices.size(), s.number_of_input_vertices);
  const Eigen::VectorXd f = random_vector(s.number_of_input_vertices, 9);
  const IT::L2_transfer back(t, s), there(t, s, Transfer_direction::to_intrinsic);
  EXPECT_LE((there(f) - IT::copy_to_intrinsic(t, f)).cwiseAbs().maxCoeff(), tolerance);
  EXPECT_LE((back(there(f)) - f).cwiseAbs().maxCoeff(), tolerance);
}

TEST(L2_transfer, takes_several_functions_at_once) {
  const Case c("rough grid", meshes::rough_grid(6, 11).input(), 0);
  const IT::L2_transfer transfer(c.triangulation, c.subdivision);
  Eigen::MatrixXd f(c.input_mass.rows(), 2);
  f.col(0) = random_vector(f.rows(), 12);
  f.col(1) = random_vector(f.rows(), 13);
  const Eigen::MatrixXd g = transfer(f);
  for (int k = 0; k < 2; ++k)
    EXPECT_LE((g.col(k) - transfer(Eigen::VectorXd(f.col(k)))).norm(), 1e-14 * g.norm());
}

TEST(L2_transfer, keeps_the_values_of_isolated_vertices_and_takes_caps) {
  const meshes::Mesh m = [] {
    meshes::Mesh grid = meshes::with_cap(meshes::grid(3, 3), 4);
    grid.points.push_back({9, 9, 9});
    return grid;
  }();
  const Case c("cap", m.input(), 0);
  const Eigen::VectorXd f = random_vector(static_cast<Eigen::Index>(m.points.size()), 14);
  const Eigen::VectorXd g = IT::L2_transfer(c.triangulation, c.subdivision)(f);
  EXPECT_EQ(g[g.size() - 1], f[f.size() - 1]);
  EXPECT_TRUE(g.allFinite());
}

// ---- vectors on faces

// a constant field of the plane in the frames of the faces
template <class View>
Complex in_frame(const View& view, std::uint32_t face, const Complex& v,
                 const std::vector<Complex>& position) {
  const std::uint32_t h = view.halfedge_of_face(face);
  const Complex d = position[view.target(h)] - position[view.source(h)];
  return v * std::conj(d / std::abs(d));
}

TEST(Face_vector_transfer, reproduces_constant_fields_of_the_plane) {
  for (const Case& c : all_cases()) {
    if (!c.is_planar()) continue;
    const auto space = IT::positions(c.subdivision, c.points);
    std::vector<Complex> position(c.subdivision.number_of_intrinsic_vertices);
    for (std::size_t v = 0; v < c.subdivision.vertices.size(); ++v)
      position[c.subdivision.vertices[v].intrinsic] = {space[v][0], space[v][1]};
    const IT::Intrinsic_view<Triangulation> view(c.triangulation);
    const IT::Input& input = c.triangulation.correspondence().input();
    const Complex constant(2, -1);
    std::vector<Complex> there, here;
    for (std::uint32_t f = 0; f < c.triangulation.mesh().number_of_faces(); ++f)
      there.push_back(in_frame(view, f, constant, position));
    for (std::uint32_t f = 0; f < input.mesh().number_of_faces(); ++f)
      here.push_back(in_frame(input, f, constant, position));
    const IT::Face_vector_transfer transfer(c.triangulation, c.subdivision);
    const std::vector<Complex> back = transfer.to_input(there), on = transfer.to_intrinsic(here);
    for (std::size_t f = 0; f < back.size(); ++f)
      EXPECT_LE(std::abs(back[f] - here[f]), 1e-8) << c.name << " face " << f;
    for (std::size_t f = 0; f < on.size(); ++f)
      EXPECT_LE(std::abs(on[f] - there[f]), 1e-8) << c.name << " face " << f;
  }
}

TEST(Face_vector_transfer, in_both_directions_is_adjoint_and_never_makes_a_field_larger) {
  for (const Case& c : all_cases()) {
    const IT::Face_vector_transfer transfer(c.triangulation, c.subdivision);
    std::mt19937 random(15);
    const auto field = [&](std::size_t n) {
      std::vector<Complex> v(n);
      for (Complex& z : v) z = {Case::draw(random) - 0.5, Case::draw(random) - 0.5};
      return v;
    };
    const std::size_t n = c.triangulation.mesh().number_of_faces();
    const std::vector<Complex> f = field(n), g = field(c.input_areas.size());
    const std::vector<Complex> to_input = transfer.to_input(f), there = transfer.to_intrinsic(g);
    Complex left = 0, right = 0;
    double before = 0, after = 0;
    for (std::size_t i = 0; i < g.size(); ++i) {
      left += c.input_areas[i] * std::conj(g[i]) * to_input[i];
      after += c.input_areas[i] * std::norm(to_input[i]);
    }
    for (const auto d : faces(c.triangulation.mesh())) {
      const double area = c.triangulation.area(d);
      right += area * std::conj(there[d.index]) * f[d.index];
      before += area * std::norm(f[d.index]);
    }
    EXPECT_LE(std::abs(left - right), 1e-9 * before) << c.name;
    EXPECT_LE(after, before * (1 + 1e-9)) << c.name;
  }
}

// The rotation in a cell, by taking a vector at its centre to the input. Independent: it unfolds input faces along the
// sides of the intrinsic face, and does not know the subdivision.
Complex rotation_by_query(const Case& c, std::size_t f) {
  const IT::Common_subdivision& s = c.subdivision;
  const IT::Intrinsic_view<Triangulation> view(c.triangulation);
  IT::Surface_point centre{view.halfedge_of_face(s.intrinsic_face[f]), {0, 0, 0}};
  for (std::size_t i = s.face_begin[f]; i < s.face_begin[f + 1]; ++i) {
    const auto w = subdivisions::corner_in_face(view, s, centre.halfedge, i);
    for (std::size_t k = 0; k < 3; ++k)
      centre.weights[k] += w[k] / static_cast<double>(s.face_begin[f + 1] - s.face_begin[f]);
  }
  const IT::Tangent_vector v = *IT::tangent_to_input(c.triangulation, {centre, {1, 0}});
  const IT::Input& input = c.triangulation.input();
  const std::uint32_t face = input.face(v.point.halfedge);
  if (face != input.names().faces.here(s.input_face[f])) return 0; // rounding at a thin cell
  const IT::Geodesic_face to(input, input.halfedge_of_face(face));
  std::size_t k = 0;
  while (to.side[k] != v.point.halfedge) ++k;
  const Complex axis(to.edge[k][0], to.edge[k][1]);
  return Complex(v.vector[0], v.vector[1]) * axis / std::abs(axis);
}

TEST(Face_vector_transfer, turns_vectors_as_queries_do_also_in_faces_with_a_vertex_at_two_corners) {
  for (const Case& c : all_cases()) {
    const IT::Face_vector_transfer transfer(c.triangulation, c.subdivision);
    const std::vector<double> areas = IT::subdivision_areas(c.triangulation, c.subdivision);
    double total = 0, compared = 0;
    for (const double area : areas) total += area;
    for (std::size_t f = 0; f < areas.size(); ++f) {
      if (areas[f] < 1e-4 * total / static_cast<double>(areas.size())) continue;
      const Complex r = rotation_by_query(c, f);
      if (std::abs(r) == 0) continue;
      EXPECT_LE(std::abs(transfer.rotation(f) - r), 1e-7) << c.name << " cell " << f;
      compared += areas[f];
    }
    EXPECT_GT(compared, 0.99 * total) << c.name;
  }
}

TEST(Face_vector_transfer, reproduces_the_constant_fields_of_a_torus_with_one_vertex) {
  // the halfedges of the unit square's torus are (1, 0), (0, 1) and (1, 1), until edges are flipped
  const gallery::Surface s = gallery::one_vertex_torus();
  for (const unsigned flips : {1U, 2U, 5U, 8U}) {
    const Case c(s.name, gallery::input(s), flips, flips / 2);
    const IT::Face_vector_transfer transfer(c.triangulation, c.subdivision);
    // the field (1, 0) in the frame of a face of the input, taken there and back
    std::vector<Complex> parallel{Complex(1, 0), Complex(0, 0)};
    const IT::Input& input = c.triangulation.input();
    // the second frame: its sides are opposite to those of the first face
    const std::uint32_t h = input.halfedge_of_face(0), g = input.halfedge_of_face(1);
    const IT::Geodesic_face a(input, h), b(input, g);
    for (unsigned k = 0; k < 3; ++k)
      for (unsigned l = 0; l < 3; ++l)
        if ((a.side[k] ^ 1U) == b.side[l]) {
          const auto direction = [](const IT::Geodesic_face& face, unsigned i) {
            return Complex(face.edge[i][0], face.edge[i][1]);
          };
          parallel[1] = -direction(b, l) / direction(a, k);
        }
    const std::vector<Complex> there = transfer.to_intrinsic(parallel),
                               back = transfer.to_input(there);
    for (const auto f : faces(c.triangulation.mesh()))
      EXPECT_NEAR(std::abs(there[f.index]), 1, 1e-9) << "an average of equal vectors";
    for (std::size_t f = 0; f < 2; ++f) EXPECT_LE(std::abs(back[f] - parallel[f]), 1e-9) << flips;
  }
}

} // namespace
