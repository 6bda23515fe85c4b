// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How long does a Laplacian with masses take to factor and to solve, and by multigrid? How many steps
// does multigrid take for a Poisson problem, on the input and on its Delaunay triangulation? A model
// is a mesh of the data set, the number of faces of a torus with waves, or `all`: every mesh, and a
// summary.
// Usage: linear_systems [DIRECTORY [REPETITIONS [MODEL...]]] > linear_systems.json

#include "benchmark_support.h"

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Multigrid_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using namespace IT::benchmark;

namespace {

using Triangulation = IT::Intrinsic_triangulation<>;

struct System {
  explicit System(const Triangulation& t)
      : laplacian(IT::cotangent_laplacian(t)), areas(IT::lumped_mass_matrix(t).diagonal()),
        masses(1e-6 * areas),
        right(areas.cwiseProduct(
            Eigen::VectorXd::LinSpaced(masses.size(), -1, 1).unaryExpr([](double x) {
              return std::sin(1e3 * x);
            }))) {}

  Eigen::SparseMatrix<double> laplacian;
  Eigen::VectorXd areas, masses, right;
};

// Random values times areas, without their mean in each component.
Eigen::VectorXd poisson_load(const System& s) {
  const std::vector<std::uint32_t> component = IT::components_of_matrix(s.laplacian);
  std::mt19937 random(1);
  Eigen::VectorXd f(s.areas.size()), sum = Eigen::VectorXd::Zero(f.size()), area = sum;
  for (double& x : f) x = static_cast<double>(random()) * 0x1p-31 - 1;
  for (Eigen::Index i = 0; i < f.size(); ++i) {
    sum[component[static_cast<std::size_t>(i)]] += s.areas[i] * f[i];
    area[component[static_cast<std::size_t>(i)]] += s.areas[i];
  }
  for (Eigen::Index i = 0; i < f.size(); ++i)
    if (const auto c = component[static_cast<std::size_t>(i)]; area[c] > 0)
      f[i] -= sum[c] / area[c];
  return s.areas.cwiseProduct(f);
}

nlohmann::json json_of(const IT::Iterations& i) {
  return {{"steps", i.most}, {"residual", i.residual}, {"status", IT::name_of(i.status)}};
}

nlohmann::json poisson_steps(const System& s) {
  IT::Iterations iterations;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(s.areas.size());
  IT::Multigrid_factorization<double>(s.laplacian, none, 1e-8)
      .solve(Eigen::MatrixXd(poisson_load(s)), iterations);
  return json_of(iterations);
}

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
    result["residual"] =
        (s.laplacian * x + s.masses.cwiseProduct(x) - s.right).norm() / s.right.norm();
  }
  return result;
}

nlohmann::json multigrid_times(const System& s, std::size_t repetitions) {
  nlohmann::json result = nlohmann::json::object();
  for (std::size_t i = 0; i < repetitions; ++i) {
    Stopwatch watch;
    const IT::Multigrid_factorization<double> prepared(s.laplacian, s.masses, 1e-8);
    keep_least(result, "prepare", watch);
    IT::Iterations iterations;
    watch = Stopwatch();
    prepared.solve(Eigen::MatrixXd(s.right), iterations);
    keep_least(result, "solve", watch);
    result.update(json_of(iterations));
  }
  return result;
}

bool is_number(const std::string& model) {
  return std::all_of(model.begin(), model.end(),
                     [](unsigned char c) { return std::isdigit(c) != 0; });
}

Triangulation triangulation_of(const std::string& directory, const std::string& model) {
  if (is_number(model))
    return Triangulation(IT::synthetic::to_surface_mesh<Kernel::Point_3>(
        IT::synthetic::torus_of_size(std::stoul(model))));
  return Triangulation(
      IT::make_domain(IT::read_triangle_soup(directory + "/" + model + ".off")).input);
}

nlohmann::json measure(Triangulation t, std::size_t repetitions) {
  nlohmann::json result;
  result["poisson_on_input"] = poisson_steps(System(t));
  IT::flip_to_delaunay(t);
  const System s(t);
  result["rows"] = s.laplacian.rows();
  result["poisson"] = poisson_steps(s);
  result["multigrid"] = multigrid_times(s, repetitions);
  result["direct"] = direct_times(s, repetitions);
  return result;
}

// Of meshes with more than a thousand rows: smaller ones have one level, and take one step.
nlohmann::json summary_of(const nlohmann::json& models) {
  double before = 0, after = 0;
  int meshes = 0, fewer = 0, more = 0, most_before = 0, most_after = 0;
  for (const nlohmann::json& m : models) {
    if (m.value("rows", 0) <= 1000) continue;
    const int b = m["poisson_on_input"]["steps"], a = m["poisson"]["steps"];
    ++meshes;
    before += b;
    after += a;
    most_before = std::max(most_before, b);
    most_after = std::max(most_after, a);
    if (a < b) ++fewer;
    if (a > b) ++more;
  }
  return {{"meshes", meshes},
          {"mean_before", before / meshes},
          {"mean_after", after / meshes},
          {"most_before", most_before},
          {"most_after", most_after},
          {"fewer_after", fewer},
          {"more_after", more}};
}

std::vector<std::string> all_meshes(const std::string& directory) {
  std::vector<std::string> result;
  for (const auto& file : std::filesystem::directory_iterator(directory))
    if (file.path().extension() == ".off") result.push_back(file.path().stem().string());
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace

int main(int argc, char** argv) {
  try {
    const std::string directory = mesh_directory(argc, argv);
    const std::size_t repetitions = argc > 2 ? std::stoul(argv[2]) : 3;
    std::vector<std::string> models{"armadillo", "100000", "300000", "1000000"};
    if (argc > 3) models.assign(argv + 3, argv + argc);
    const bool is_all = models == std::vector<std::string>{"all"};
    if (is_all) models = all_meshes(directory);
    nlohmann::json result;
    for (const std::string& model : models) {
      try {
        result[model] = measure(triangulation_of(directory, model), repetitions);
      } catch (const std::exception& e) { // of a mesh that is no surface, or that has no area
        result[model] = {{"error", e.what()}};
      }
      std::cerr << model << ' ' << result[model].dump() << '\n';
    }
    if (is_all) result["summary"] = summary_of(result);
    std::cout << result.dump(2) << '\n';
    return 0;
  } catch (const std::exception& e) {
    std::cerr << "linear_systems: " << e.what() << '\n';
    return 1;
  }
}
