// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How long does `simplify()` take, how tight is the proven stretch, and how far are distances,
// eigenvalues and solutions on the coarse surface from those on the fine one?
// Usage: coarse_surfaces [DIRECTORY [SOURCES [MODEL...]]] > coarse_surfaces.json

#include "measure_models.h"

#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/surface_modes.h>
#include <CGAL/Intrinsic_simplification/simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/points_of_rows.h>

#include <Eigen/SparseCholesky>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using namespace IT::benchmark;

namespace {

using T = IT::Corresponding_triangulation;
using Matrix = Eigen::SparseMatrix<double>;

// Ratios of exact distances from some vertices to all others that stay.
nlohmann::json measure_distances(const T& fine, const T& coarse, const IT::Simplification& s,
                                 std::size_t sources) {
  IT::Polyhedral_distance<T> on_fine(fine), on_coarse(coarse);
  std::mt19937 random(1);
  double least = 1e300, most = 0, squares = 0;
  std::size_t pairs = 0, outside = 0;
  for (std::size_t n = 0; n < sources; ++n) {
    const auto from = static_cast<std::uint32_t>(random() % s.kept.size());
    on_fine.search(IT::vertex_of_row(fine, s.kept[from]));
    on_coarse.search(IT::vertex_of_row(coarse, from));
    const std::vector<double> a = on_fine.distances(), b = on_coarse.distances();
    for (std::size_t c = 0; c < s.kept.size(); ++c) {
      if (c == from || !std::isfinite(a[s.kept[c]])) continue;
      const double ratio = b[c] / a[s.kept[c]];
      least = std::min(least, ratio);
      most = std::max(most, ratio);
      squares += (ratio - 1) * (ratio - 1);
      outside += ratio < s.stretch.lower * (1 - 1e-12) || ratio > s.stretch.upper * (1 + 1e-12);
      ++pairs;
    }
  }
  return {{"least", least},
          {"most", most},
          {"pairs", pairs},
          {"outside_bounds", outside},
          {"root_mean_square", std::sqrt(squares / static_cast<double>(pairs))}};
}

// The relative difference of eigenvalues, in the mean.
double difference_of_eigenvalues(const Eigen::VectorXd& fine, const T& coarse) {
  const auto n = static_cast<std::size_t>(fine.size());
  if (coarse.number_of_vertices() <= n + 1) return -1; // has fewer
  const Eigen::VectorXd values = IT::surface_modes(coarse, n).values;
  return ((values - fine).tail(fine.size() - 1).array() / fine.tail(fine.size() - 1).array())
      .abs()
      .mean();
}

// Solves (L + 10 M / A) u = f.
Eigen::VectorXd solve(const T& t, const Eigen::VectorXd& load) {
  const Matrix mass = IT::lumped_mass_matrix(t);
  const Eigen::SimplicialLDLT<Matrix> solver(IT::cotangent_laplacian(t) + 10 / mass.sum() * mass);
  return solver.solve(load);
}

nlohmann::json measure_quality(const T& fine, const T& coarse, const IT::Simplification& s,
                               const Eigen::VectorXd& eigenvalues, const Eigen::VectorXd& load,
                               const Eigen::VectorXd& solution) {
  const Matrix p = IT::prolongation(s), mass = IT::lumped_mass_matrix(fine);
  const Eigen::VectorXd error = p * solve(coarse, p.transpose() * load) - solution;
  const double of_solution = std::sqrt(error.dot(mass * error) / solution.dot(mass * solution));
  return {{"eigenvalues", difference_of_eigenvalues(eigenvalues, coarse)},
          {"poisson", of_solution}};
}

nlohmann::json measure(const Surface_mesh& mesh, std::size_t sources) {
  const T fine = IT::delaunay_triangulation(mesh);
  const std::size_t n = num_vertices(mesh);
  Eigen::VectorXd height(static_cast<Eigen::Index>(n));
  for (const auto v : vertices(mesh))
    height[static_cast<Eigen::Index>(v.idx())] = mesh.point(v).x();
  const Eigen::VectorXd load = IT::lumped_mass_matrix(fine) * height, solution = solve(fine, load),
                        eigenvalues = IT::surface_modes(fine, 20).values;
  nlohmann::json result;
  for (const auto& [name, order] : {std::pair("stretch", IT::Removal_cost::stretch),
                                    {"curvature", IT::Removal_cost::curvature}})
    for (const std::size_t percent : {20, 10, 5, 1}) {
      IT::Simplify_options options;
      options.order = order;
      options.vertices = n * percent / 100;
      const double begin = processor_time();
      const IT::Simplification s = IT::simplify(fine, options);
      const double milliseconds = processor_time() - begin;
      const T coarse(s.surface);
      nlohmann::json& entry = result[name][std::to_string(percent) + " %"];
      entry = {{"vertices", s.kept.size()},
               {"microseconds_per_vertex", 1e3 * milliseconds / static_cast<double>(s.removed)},
               {"newton_steps", s.newton_steps},
               {"ptolemy_flips", s.ptolemy_flips},
               {"stretch", {s.stretch.lower, s.stretch.upper}},
               {"mean_stretch", {s.stretch.mean_lower, s.stretch.mean_upper}},
               {"distances", measure_distances(fine, coarse, s, sources)},
               {"quality", measure_quality(fine, coarse, s, eigenvalues, load, solution)}};
    }
  return result;
}

} // namespace

int main(int argc, char** argv) {
  return measure_models(argc, argv, "coarse_surfaces", 5,
                        {"elephant", "fandisk", "camel", "homer", "armadillo"}, measure);
}
