// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How much better is a Poisson problem solved on the intrinsic Delaunay triangulation, once the solution
// is back on the input? The experiment of §4.11.1 of the course: the unit square, badly triangulated by
// random edge splits. Usage: poisson_transfer [TRIALS] > result.json

#include "benchmark_support.h"

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/transfer.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <iostream>
#include <map>
#include <numbers>

#include <Eigen/SparseCholesky>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using namespace IT::benchmark;

namespace {

using Soup = IT::synthetic::Triangle_soup;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;
using Matrix = Eigen::SparseMatrix<double>;
constexpr double pi = std::numbers::pi;

double source(double x, double y) { return std::sin(pi * x) * std::sin(pi * y); }
// of Laplacian u = source, u = 0 on the border
double solution(double x, double y) { return -source(x, y) / (2 * pi * pi); }

// ---- meshes of the unit square

// n x n cells, each cut by a diagonal
Soup square(std::uint32_t n) {
  Soup s;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x) s.points.push_back({double(x) / n, double(y) / n, 0});
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t v = (n + 1) * y + x;
      s.triangles.push_back({v, v + 1, v + n + 2});
      s.triangles.push_back({v, v + n + 2, v + n + 1});
    }
  return s;
}

/// How a mesh is made: random edges are split at uniform parameters.
struct Construction {
  bool by_length;      // draw edges with probability proportional to their lengths, not uniformly
  std::uint32_t cells; // of the grid to start from, per side
  double margin;       // parameters are between it and 1 minus it
  std::size_t vertices;
};

double length(const IT::synthetic::Edge_splitter& s, std::size_t e) {
  const auto [i, j] = s.ends(e);
  const auto &p = s.soup().points[i], &q = s.soup().points[j];
  return std::hypot(p[0] - q[0], p[1] - q[1]);
}

Soup make_mesh(const Construction& c, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  IT::synthetic::Edge_splitter splitter(square(c.cells));
  while (splitter.soup().points.size() < c.vertices) {
    const auto e = IT::synthetic::draw_index(random, splitter.number_of_edges());
    const double longest = std::numbers::sqrt2 / c.cells;
    if (c.by_length && longest * IT::synthetic::draw_real(random) > length(splitter, e)) continue;
    const double r = IT::synthetic::draw_real(random);
    splitter.split(e, c.margin + (1 - 2 * c.margin) * r);
  }
  return std::move(splitter).take_soup();
}

// ---- the Poisson problem

bool is_on_border(const std::array<double, 3>& p) {
  return p[0] == 0 || p[0] == 1 || p[1] == 0 || p[1] == 1;
}

// solves L u = -M f for the inner vertices; our Laplacian is positive semidefinite
Eigen::VectorXd solve_poisson(Triangulation& t, const Soup& soup) {
  const Matrix l = IT::cotangent_laplacian(t), m = IT::galerkin_mass_matrix(t);
  std::vector<int> inner(soup.points.size(), -1);
  int size = 0;
  Eigen::VectorXd f(l.rows());
  for (std::size_t v = 0; v < inner.size(); ++v) {
    f[static_cast<int>(v)] = source(soup.points[v][0], soup.points[v][1]);
    if (!is_on_border(soup.points[v])) inner[v] = size++;
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (int c = 0; c < l.outerSize(); ++c)
    for (Matrix::InnerIterator i(l, c); i; ++i) {
      const int row = inner[static_cast<std::size_t>(i.row())], column = inner[std::size_t(c)];
      if (row >= 0 && column >= 0) entries.emplace_back(row, column, i.value());
    }
  Matrix reduced(size, size);
  reduced.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd right = -(m * f);
  Eigen::VectorXd b(size), u = Eigen::VectorXd::Zero(l.rows());
  for (int v = 0; v < l.rows(); ++v)
    if (inner[std::size_t(v)] >= 0) b[inner[std::size_t(v)]] = right[v];
  const Eigen::SimplicialLDLT<Matrix> solver(reduced);
  const Eigen::VectorXd x = solver.solve(b);
  for (int v = 0; v < l.rows(); ++v)
    if (inner[std::size_t(v)] >= 0) u[v] = x[inner[std::size_t(v)]];
  return u;
}

// ---- errors

struct Node {
  std::array<double, 3> weights;
  double weight;
};

// Gauss' rule with 8 x 8 nodes in a square collapsed to a triangle: exact up to degree 14
std::vector<Node> quadrature() {
  const double x[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                       0.9602898564975363};
  const double w[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                       0.1012285362903763};
  std::vector<Node> nodes;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) {
      const double u = (1 + (i < 4 ? x[i] : -x[i - 4])) / 2;
      const double v = (1 + (j < 4 ? x[j] : -x[j - 4])) / 2;
      nodes.push_back({{u, (1 - u) * v, (1 - u) * (1 - v)}, w[i % 4] * w[j % 4] * (1 - u) / 2});
    }
  return nodes;
}

// calls function(triangle, area, node, x, y) for each node in each triangle
template <class Function>
void integrate(const Soup& soup, Function function) {
  static const std::vector<Node> nodes = quadrature();
  for (const auto& t : soup.triangles) {
    const auto &a = soup.points[t[0]], &b = soup.points[t[1]], &c = soup.points[t[2]];
    const double area = ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    for (const Node& n : nodes) {
      const auto& w = n.weights;
      function(t, area * n.weight, w, w[0] * a[0] + w[1] * b[0] + w[2] * c[0],
               w[0] * a[1] + w[1] * b[1] + w[2] * c[1]);
    }
  }
}

double error(const Soup& soup, const Eigen::VectorXd& u) {
  double sum = 0;
  integrate(soup, [&](const auto& t, double weight, const auto& w, double x, double y) {
    const double d = w[0] * u[t[0]] + w[1] * u[t[1]] + w[2] * u[t[2]] - solution(x, y);
    sum += weight * d * d;
  });
  return std::sqrt(sum);
}

// the function nearest to the exact solution: no method can be better
Eigen::VectorXd best(const Soup& soup, const Matrix& mass) {
  Eigen::VectorXd b = Eigen::VectorXd::Zero(mass.rows());
  integrate(soup, [&](const auto& t, double weight, const auto& w, double x, double y) {
    for (std::size_t k = 0; k < 3; ++k) b[t[k]] += weight * w[k] * solution(x, y);
  });
  return Eigen::SimplicialLDLT<Matrix>(mass).solve(b);
}

const std::vector<std::string> methods = {"direct", "copied", "l2", "best"};

std::map<std::string, double> trial(const Soup& soup) {
  IT::Intrinsic_input input(IT::Gluing_map(IT::gluing_from_triangles(
                                static_cast<std::uint32_t>(soup.points.size()), soup.triangles)),
                            soup.points, IT::Mollification::none);
  Triangulation t(std::move(input));
  std::map<std::string, double> errors;
  errors["direct"] = error(soup, solve_poisson(t, soup));
  errors["best"] = error(soup, best(soup, IT::galerkin_mass_matrix(t)));
  IT::flip_to_delaunay(t);
  const IT::Common_subdivision s = IT::common_subdivision(t);
  const Eigen::VectorXd f = solve_poisson(t, soup);
  errors["copied"] = error(soup, IT::copy_to_input(t, f));
  errors["l2"] = error(soup, IT::L2_transfer(t, s)(f));
  return errors;
}

double mean(const std::vector<double>& sample) {
  double sum = 0;
  for (const double x : sample) sum += x;
  return sum / static_cast<double>(sample.size());
}

nlohmann::json run(const Construction& c, int trials) {
  std::map<std::string, std::vector<double>> errors, ratios;
  for (int i = 0; i < trials; ++i) {
    std::map<std::string, double> e = trial(make_mesh(c, static_cast<std::uint64_t>(i) + 1));
    for (const std::string& m : methods) {
      errors[m].push_back(e[m]);
      ratios[m].push_back(e["direct"] / e[m]);
    }
  }
  nlohmann::json row = {{"edges", c.by_length ? "by length" : "uniform"},
                        {"cells", c.cells},
                        {"margin", c.margin},
                        {"vertices", c.vertices}};
  for (const std::string& m : methods) {
    row["mean_error"][m] = mean(errors[m]);
    row["geometric_mean_error"][m] = geometric_mean(errors[m]);
    row["ratio_of_means"][m] = mean(errors["direct"]) / mean(errors[m]);
    row["geometric_mean_ratio"][m] = geometric_mean(ratios[m]);
    row["median_ratio"][m] = median(ratios[m]);
  }
  return row;
}

void print(const nlohmann::json& r) {
  std::fprintf(stderr, "| %s | %u x %u | %.1f | %zu |", r["edges"].get<std::string>().c_str(),
               r["cells"].get<unsigned>(), r["cells"].get<unsigned>(), r["margin"].get<double>(),
               r["vertices"].get<std::size_t>());
  for (const char* m : {"direct", "copied", "l2", "best"})
    std::fprintf(stderr, " %.2e |", r["mean_error"][m].get<double>());
  for (const char* m : {"copied", "l2", "best"})
    std::fprintf(stderr, " %.1f (%.1f) |", r["ratio_of_means"][m].get<double>(),
                 r["geometric_mean_ratio"][m].get<double>());
  std::fprintf(stderr, "\n");
}

} // namespace

int main(int argc, char** argv) {
  try {
    const int trials = argc > 1 ? std::stoi(argv[1]) : 100;
    nlohmann::json result = {{"trials", trials}};
    std::fprintf(stderr, "| edges | start | margin | vertices | direct | copied | L2 | best |"
                         " direct/copied | direct/L2 | direct/best |\n"
                         "|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const bool by_length : {false, true})
      for (const auto& [cells, margin] : {std::pair{1U, 0.1}, {1U, 0.3}, {4U, 0.1}})
        for (const std::size_t n : {1000, 4000}) {
          result["rows"].push_back(run({by_length, cells, margin, n}, trials));
          print(result["rows"].back());
        }
    std::cout << result.dump(2) << '\n';
  } catch (const std::exception& e) {
    std::cerr << "poisson_transfer: " << e.what() << '\n';
    return 1;
  }
}
