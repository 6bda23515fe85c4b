// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How long does a Laplacian with masses take to factor and to solve, and by multigrid? How many steps does multigrid take on the input, and how many on its
// Delaunay triangulation? A model is a mesh of the data set, or the number of faces of a torus with waves.
// Usage: linear_systems [DIRECTORY [REPETITIONS [MODEL...]]] > linear_systems.json

#include "benchmark_support.h"

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Multigrid_factorization.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using namespace IT::benchmark;

namespace {

using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>>;

struct System {
  explicit System(const Triangulation& t)
      : laplacian(IT::cotangent_laplacian(t)), masses(1e-6 * IT::lumped_mass_matrix(t).diagonal()),
        right(IT::lumped_mass_matrix(t).diagonal().cwiseProduct(
            Eigen::VectorXd::LinSpaced(masses.size(), -1, 1).unaryExpr([](double x) {
              return std::sin(1e3 * x);
            }))) {}
  Eigen::SparseMatrix<double> matrix() const {
    return laplacian + Eigen::SparseMatrix<double>(masses.asDiagonal());
  }

  Eigen::SparseMatrix<double> laplacian;
  Eigen::VectorXd masses, right;
};

void keep_least(nlohmann::json& to, const char* name, const Stopwatch& watch) {
  const double now = watch.milliseconds();
  to[name] = std::min(now, to.value(name, now));
}

nlohmann::json direct_times(const System& s, std::size_t repetitions) {
  nlohmann::json result = nlohmann::json::object();
  for (std::size_t i = 0; i < repetitions; ++i) {
    Stopwatch watch;
    const IT::Laplacian_factorization factored(s.laplacian, s.masses);
    keep_least(result, "factor", watch);
    watch = Stopwatch();
    const Eigen::VectorXd x = factored.solve(s.right);
    keep_least(result, "solve", watch);
    result["residual"] = (s.matrix() * x - s.right).norm() / s.right.norm();
  }
  return result;
}

nlohmann::json multigrid_times(const System& s, std::size_t repetitions) {
  const Eigen::SparseMatrix<double> matrix = s.matrix();
  nlohmann::json result = nlohmann::json::object();
  for (std::size_t i = 0; i < repetitions; ++i) {
    Stopwatch watch;
    const IT::Multigrid_factorization<double> prepared(matrix, 1e-8);
    keep_least(result, "prepare", watch);
    IT::Iterations iterations;
    watch = Stopwatch();
    prepared.solve(Eigen::MatrixXd(s.right), iterations);
    keep_least(result, "solve", watch);
    result["steps"] = iterations.most;
    result["residual"] = iterations.residual;
    result["status"] = IT::name_of(iterations.status);
  }
  return result;
}

Surface_mesh mesh_of(const std::string& directory, const std::string& model) {
  if (std::isdigit(static_cast<unsigned char>(model[0])) == 0 ||
      model.find_first_not_of("0123456789") != std::string::npos)
    return read_mesh(directory, model);
  return IT::synthetic::to_surface_mesh<Kernel::Point_3>(
      IT::synthetic::torus_of_size(std::stoul(model)));
}

nlohmann::json measure(const Surface_mesh& mesh, std::size_t repetitions) {
  Triangulation t(mesh);
  nlohmann::json result;
  result["on_input"] = multigrid_times(System(t), 1);
  IT::flip_to_delaunay(t);
  const System s(t);
  result["rows"] = s.laplacian.rows();
  result["multigrid"] = multigrid_times(s, repetitions);
  result["direct"] = direct_times(s, repetitions);
  return result;
}

} // namespace

int main(int argc, char** argv) {
  try {
    const std::string directory = mesh_directory(argc, argv);
    const std::size_t repetitions = argc > 2 ? std::stoul(argv[2]) : 3;
    std::vector<std::string> models{"armadillo", "100000", "300000", "1000000"};
    if (argc > 3) models.assign(argv + 3, argv + argc);
    nlohmann::json result;
    for (const std::string& model : models) {
      try {
        result[model] = measure(mesh_of(directory, model), repetitions);
      } catch (const std::exception& e) { // of a mesh that is no surface, or that has no area
        result[model] = {{"error", e.what()}};
      }
      std::cerr << model << ' ' << result[model].dump() << '\n';
    }
    std::cout << result.dump(2) << '\n';
    return 0;
  } catch (const std::exception& e) {
    std::cerr << "linear_systems: " << e.what() << '\n';
    return 1;
  }
}
