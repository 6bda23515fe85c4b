// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_TRANSFERRED_MESHES_H
#define TEST_INTRINSIC_TRIANGULATIONS_TRANSFERRED_MESHES_H

#include "gallery.h"
#include "meshes.h"

#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Intrinsic triangulations that differ from their inputs, with data on both.

namespace transferred {

namespace IT = CGAL::Intrinsic_triangulations;
using Matrix = Eigen::SparseMatrix<double>;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>,
                                                  IT::Integer_coordinates>;

struct Case {
  /// flips `flips` random edges, after that inserts `insertions` vertices in random faces
  Case(std::string n, IT::Intrinsic_input input, unsigned flips, unsigned insertions = 0)
      : name(std::move(n)), points(input.points), triangulation(std::move(input)),
        input_mass(IT::galerkin_mass_matrix(triangulation)) {
    for (const auto f : faces(triangulation.mesh())) input_areas.push_back(triangulation.area(f));
    std::mt19937 random(flips + insertions);
    const IT::Gluing_map& mesh = triangulation.mesh();
    for (unsigned i = 0; i < flips; ++i)
      triangulation.flip_edge({static_cast<std::uint32_t>(random() % mesh.number_of_halfedges())});
    for (unsigned i = 0; i < insertions; ++i) {
      const IT::Gluing_map::Halfedge h{
          static_cast<std::uint32_t>(random() % mesh.number_of_halfedges())};
      const double a = draw(random), b = i % 4 == 0 ? 0 : draw(random);
      triangulation.insert_vertex(h, {1 - (a + b) / 2, a / 2, b / 2});
    }
    if (flips == 0) IT::flip_to_delaunay(triangulation);
    subdivision = IT::common_subdivision(triangulation);
  }

  bool is_planar() const {
    return !points.empty() &&
           std::all_of(points.begin(), points.end(), [](const auto& p) { return p[2] == 0; });
  }

  template <class Function>
  Eigen::VectorXd values(Function f) const {
    Eigen::VectorXd v(static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
      v[static_cast<Eigen::Index>(i)] = f(points[i][0], points[i][1]);
    return v;
  }

  /// values at all intrinsic vertices, by the locations of those that were inserted
  Eigen::VectorXd inserted(const Eigen::VectorXd& f) const {
    Eigen::VectorXd v = Eigen::VectorXd::Zero(subdivision.number_of_intrinsic_vertices);
    for (const auto& s : subdivision.vertices)
      for (std::size_t i = 0; i < s.on_input.size; ++i)
        v[s.intrinsic] += s.on_input.weights[i] * f[s.on_input.vertices[i]];
    return v;
  }

  static double draw(std::mt19937& random) { return static_cast<double>(random()) / 0x1p32; }

  std::string name;
  std::vector<std::array<double, 3>> points;
  Triangulation triangulation;
  Matrix input_mass; // Galerkin's
  std::vector<double> input_areas;
  IT::Common_subdivision subdivision;
};

inline Eigen::VectorXd random_vector(Eigen::Index n, unsigned seed) {
  std::mt19937 random(seed);
  return Eigen::VectorXd::NullaryExpr(n, [&] { return 2 * Case::draw(random) - 1; });
}

/// Delaunay, after random flips, and with inserted vertices.
inline std::vector<Case> all_cases() {
  const std::pair<const char*, meshes::Mesh> shapes[] = {
      {"grid", meshes::grid(5, 4)},
      {"sheared grid", meshes::sheared_grid(8, 8, 10)},
      {"planar", meshes::random_planar(60, 1000, 1)},
      {"parabola fan", meshes::parabola_fan(12)},
      {"terrain", meshes::integer_terrain(60, 200, 2)},
      {"height field", meshes::integer_height_field(6, 5, 3)},
      {"rough grid", meshes::rough_grid(8, 4)},
      {"box", meshes::box(2, 3, 4)},
      {"potato", meshes::potato(2, 5)},
      {"stairs", meshes::stairs(4, 3, 0.3)},
      {"folded lattice", meshes::folded_lattice(4, 6, 1)},
      {"l shape", meshes::l_shape(3)}};
  std::vector<Case> result;
  for (const auto& [name, mesh] : shapes) {
    result.emplace_back(name, mesh.input(), 0);
    result.emplace_back(std::string(name) + " flipped", mesh.input(), 200);
    result.emplace_back(std::string(name) + " with insertions", mesh.input(), 50, 20);
    result.emplace_back(std::string(name) + " refined", mesh.input(), 0, 20);
  }
  for (const gallery::Surface& s : gallery::oriented())
    if (!s.gluing.origin.empty()) result.emplace_back(s.name, gallery::input(s), 5);
  return result;
}

} // namespace transferred

#endif // TEST_INTRINSIC_TRIANGULATIONS_TRANSFERRED_MESHES_H
