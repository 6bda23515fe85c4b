// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How long does `simplify()` take with each cost, how tight is the proven stretch, and how far are
// distances, eigenvalues and solutions on the coarse surface from those on the fine one? Beside it:
// CGAL's edge collapse by quadrics to as many vertices, with the Delaunay triangulation of its mesh.
// Usage: coarse_surfaces [DIRECTORY [SOURCES [MODEL...]]] > coarse_surfaces.json

#include "measure_models.h"

#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_operators/operators/connection_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/surface_modes.h>
#include <CGAL/Intrinsic_simplification/simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/simplification/simplify.h>
#include <CGAL/Intrinsic_simplification/simplification/vector_prolongation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/points_of_rows.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <Eigen/SparseCholesky>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
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

// A coarse surface, and what takes functions to the fine one.
struct Coarse {
  T triangulation;
  Matrix prolongation;
  std::vector<std::uint32_t> kept;                // the fine vertex that stands for each coarse one
  Eigen::VectorXd heights;                        // the function x
  double least_ratio = 0, greatest_ratio = 1e300; // proven for distances
};

// Relative errors of exact distances in 1,000 pairs of vertices that stay.
nlohmann::json measure_distances(const T& fine, const Coarse& c, std::size_t sources) {
  IT::Polyhedral_distance<T> on_fine(fine), on_coarse(c.triangulation);
  std::mt19937 random(1);
  double least = 1e300, most = 0, squares = 0;
  std::size_t pairs = 0, outside = 0;
  const auto any = [&] { return static_cast<std::uint32_t>(random() % c.kept.size()); };
  for (std::size_t n = 0; n < sources; ++n) {
    const std::uint32_t from = any();
    on_fine.search(IT::vertex_of_row(fine, c.kept[from]));
    on_coarse.search(IT::vertex_of_row(c.triangulation, from));
    const std::vector<double> a = on_fine.distances(), b = on_coarse.distances();
    for (std::size_t k = 0; k < 1000 / sources; ++k) {
      const std::uint32_t to = any();
      if (c.kept[to] == c.kept[from] || !std::isfinite(a[c.kept[to]])) continue;
      const double ratio = b[to] / a[c.kept[to]];
      least = std::min(least, ratio);
      most = std::max(most, ratio);
      squares += (ratio - 1) * (ratio - 1);
      outside += ratio < c.least_ratio * (1 - 1e-12) || ratio > c.greatest_ratio * (1 + 1e-12);
      ++pairs;
    }
  }
  return {{"least", least},
          {"most", most},
          {"pairs", pairs},
          {"outside_bounds", outside},
          {"root_mean_square", std::sqrt(squares / static_cast<double>(pairs))}};
}

// Solves (L + 10 M / A) u = f.
Eigen::VectorXd solve(const T& t, const Eigen::VectorXd& load) {
  const Matrix mass = IT::lumped_mass_matrix(t);
  const Eigen::SimplicialLDLT<Matrix> solver(IT::cotangent_laplacian(t) + 10 / mass.sum() * mass);
  return solver.solve(load);
}

constexpr std::size_t modes = 21; // the first one is constant

struct Fine {
  T triangulation;
  Eigen::VectorXd heights, eigenvalues, solution;

  explicit Fine(const Surface_mesh& mesh)
      : triangulation(IT::delaunay_triangulation(mesh)), heights(num_vertices(mesh)) {
    for (const auto v : vertices(mesh))
      heights[static_cast<Eigen::Index>(v.idx())] = mesh.point(v).x();
    eigenvalues = IT::surface_modes(triangulation, modes).values;
    solution = solve(triangulation, IT::lumped_mass_matrix(triangulation) * heights);
  }
};

// The relative difference of eigenvalues 1 to 20, in the mean; -1 if there are fewer.
double difference_of_eigenvalues(const Eigen::VectorXd& fine, const T& coarse) {
  if (coarse.number_of_vertices() <= modes + 1) return -1;
  const Eigen::VectorXd values = IT::surface_modes(coarse, modes).values;
  return ((values - fine).tail(fine.size() - 1).array() / fine.tail(fine.size() - 1).array())
      .abs()
      .mean();
}

nlohmann::json measure_quality(const Fine& fine, const Coarse& c) {
  const Matrix fine_mass = IT::lumped_mass_matrix(fine.triangulation),
               mass = IT::lumped_mass_matrix(c.triangulation);
  const auto error = [&](const Eigen::VectorXd& load) {
    const Eigen::VectorXd e = c.prolongation * solve(c.triangulation, load) - fine.solution;
    return std::sqrt(e.dot(fine_mass * e) / fine.solution.dot(fine_mass * fine.solution));
  };
  return {{"eigenvalues", difference_of_eigenvalues(fine.eigenvalues, c.triangulation)},
          {"poisson", error(mass * c.heights)},
          {"poisson_of_restricted_load",
           error(c.prolongation.transpose() * (fine_mass * fine.heights))}};
}

// The first eigenvalue of the connection Laplacian, by inverse iteration, and its vector.
struct First_field {
  double value = 0;
  Eigen::VectorXcd vector;
};

double rayleigh_quotient(const T& t, const Eigen::VectorXcd& z) {
  const Eigen::VectorXd masses = IT::lumped_mass_matrix(t).diagonal();
  const double energy = z.dot(Eigen::VectorXcd(IT::connection_laplacian(t) * z)).real();
  return energy / z.cwiseAbs2().dot(masses);
}

First_field first_field(const T& t) {
  const Eigen::SparseMatrix<std::complex<double>> l = IT::connection_laplacian(t);
  const Eigen::VectorXd masses = IT::lumped_mass_matrix(t).diagonal();
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<std::complex<double>>> solver(l);
  First_field f;
  f.vector = Eigen::VectorXcd::Ones(l.rows());
  for (int n = 0; n < 100; ++n) f.vector = solver.solve(masses.cwiseProduct(f.vector)).normalized();
  f.value = rayleigh_quotient(t, f.vector);
  return f;
}

// The quotient of the coarse surface's first field, prolonged, by the first eigenvalue.
double measure_vectors(const Fine& fine, double first, const IT::Simplification& s,
                       const T& coarse) {
  const Eigen::VectorXcd z =
      IT::vector_prolongation(fine.triangulation, coarse, s) * first_field(coarse).vector;
  return rayleigh_quotient(fine.triangulation, z) / first;
}

// CGAL's edge collapse by quadrics, Delaunay, with the nearest points of fine vertices on it.
Coarse collapsed(const Surface_mesh& fine, std::size_t wanted) {
  namespace SMS = CGAL::Surface_mesh_simplification;
  namespace PMP = CGAL::Polygon_mesh_processing;
  using Policies = SMS::GarlandHeckbert_policies<Surface_mesh, Kernel>;
  Surface_mesh mesh = fine;
  const Policies policies(mesh);
  SMS::edge_collapse(
      mesh,
      [wanted](double, const auto& profile, std::size_t, std::size_t) {
        return profile.surface_mesh().number_of_vertices() <= wanted; // without removed ones
      },
      CGAL::parameters::get_cost(policies.get_cost()).get_placement(policies.get_placement()));
  mesh.collect_garbage();
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Surface_mesh>>>
      tree;
  PMP::build_AABB_tree(mesh, tree);
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> nearest(num_vertices(mesh), -1);
  Coarse c{IT::delaunay_triangulation(mesh), {}, {}, Eigen::VectorXd(num_vertices(mesh))};
  c.kept.resize(num_vertices(mesh), 0);
  for (const auto v : vertices(mesh))
    c.heights[static_cast<Eigen::Index>(v.idx())] = mesh.point(v).x();
  for (const auto v : vertices(fine)) {
    const auto [f, weights] = PMP::locate_with_AABB_tree(fine.point(v), tree, mesh);
    auto h = halfedge(f, mesh);
    for (std::size_t k = 0; k < 3; ++k, h = next(h, mesh)) {
      const std::uint32_t w = source(h, mesh).idx();
      entries.emplace_back(static_cast<int>(v.idx()), static_cast<int>(w), weights[k]);
      if (weights[k] <= nearest[w]) continue;
      nearest[w] = weights[k];
      c.kept[w] = v.idx();
    }
  }
  c.prolongation.resize(static_cast<int>(num_vertices(fine)), static_cast<int>(num_vertices(mesh)));
  c.prolongation.setFromTriplets(entries.begin(), entries.end());
  return c;
}

nlohmann::json measure_simplification(const Fine& fine, double first_value, std::size_t sources,
                                      std::size_t wanted, const auto& cost) {
  IT::Simplify_options options;
  options.vertices = wanted;
  const double begin = processor_time();
  const IT::Simplification s = IT::simplify(fine.triangulation, options, cost(fine.triangulation));
  const double milliseconds = processor_time() - begin;
  Coarse c{T(s.surface),    IT::prolongation(s), s.kept, Eigen::VectorXd(s.kept.size()),
           s.stretch.lower, s.stretch.upper};
  for (std::size_t v = 0; v < s.kept.size(); ++v)
    c.heights[static_cast<Eigen::Index>(v)] = fine.heights[s.kept[v]];
  return {{"vertices", s.kept.size()},
          {"microseconds_per_vertex", 1e3 * milliseconds / static_cast<double>(s.removed)},
          {"newton_steps", s.newton_steps},
          {"ptolemy_flips", s.ptolemy_flips},
          {"stretch", {s.stretch.lower, s.stretch.upper}},
          {"mean_stretch", {s.stretch.mean_lower, s.stretch.mean_upper}},
          {"distances", measure_distances(fine.triangulation, c, sources)},
          {"vector_quotient", measure_vectors(fine, first_value, s, c.triangulation)},
          {"quality", measure_quality(fine, c)}};
}

nlohmann::json measure_collapse(const Surface_mesh& mesh, const Fine& fine, std::size_t sources,
                                std::size_t wanted) {
  const double begin = processor_time();
  const Coarse c = collapsed(mesh, wanted);
  return {{"vertices", c.kept.size()},
          {"milliseconds", processor_time() - begin},
          {"distances", measure_distances(fine.triangulation, c, sources)},
          {"quality", measure_quality(fine, c)}};
}

nlohmann::json measure(const Surface_mesh& mesh, std::size_t sources) {
  const Fine fine(mesh);
  const double first_value = first_field(fine.triangulation).value;
  nlohmann::json result;
  for (const std::size_t percent : {20, 10, 5, 1}) {
    const std::size_t wanted = num_vertices(mesh) * percent / 100;
    const auto add = [&](const char* name, const auto& cost) {
      result[name][std::to_string(percent) + " %"] =
          measure_simplification(fine, first_value, sources, wanted, cost);
    };
    add("stretch", [](const T&) { return IT::Stretch_cost(); });
    add("curvature", [](const T& t) { return IT::curvature_cost(t); });
    add("area", [](const T& t) { return IT::area_cost(t); });
    add("balanced", [](const T& t) { return IT::balanced_cost(t); });
    result["edge collapse"][std::to_string(percent) + " %"] =
        measure_collapse(mesh, fine, sources, wanted);
  }
  return result;
}

} // namespace

int main(int argc, char** argv) {
  return measure_models(argc, argv, "coarse_surfaces", 5,
                        {"elephant", "fandisk", "camel", "homer", "armadillo"}, measure);
}
