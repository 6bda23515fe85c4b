// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How far are distances by heat from the exact ones, on the mesh as it is, on its intrinsic Delaunay triangulation, and on refinements of that?
// Usage: heat_accuracy [DIRECTORY [MODEL...]] > heat_accuracy.json; heat_accuracy_table.py makes a table of it

#include "benchmark_support.h"

#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_operators/distance/Heat_distance.h>
#include <CGAL/Intrinsic_operators/operators/reaction_diffusion.h>
#include <CGAL/Intrinsic_operators/operators/residual_indicators.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/adaptive_refine.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <Eigen/Core>

#include <nlohmann/json.hpp>

#include <algorithm>
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
namespace parameters = IT::parameters;

Triangulation::vertex_descriptor first_vertex(const Triangulation& t) {
  for (const auto v : vertices(t.mesh()))
    if (t.input_vertex(v) == 0) return v;
  throw std::runtime_error("no vertex 0");
}

// Of the distances of the user's vertices from the first, by the greatest distance; within a tenth of that, by the distance itself.
nlohmann::json errors(const Triangulation& t, const std::vector<double>& exact) {
  const Eigen::VectorXd d = IT::Heat_distance(t).distances(first_vertex(t));
  double sum = 0, greatest = 0, farthest = 0;
  std::size_t reached = 0;
  for (std::size_t v = 0; v < exact.size(); ++v) {
    if (!std::isfinite(exact[v])) continue;
    const double error = std::abs(d[static_cast<Eigen::Index>(v)] - exact[v]);
    sum += error;
    greatest = std::max(greatest, error);
    farthest = std::max(farthest, exact[v]);
    ++reached;
  }
  double near = 0;
  std::size_t neighbors = 0;
  for (std::size_t v = 0; v < exact.size(); ++v) {
    if (!(exact[v] > 0 && exact[v] <= farthest / 10)) continue;
    near += std::abs(d[static_cast<Eigen::Index>(v)] - exact[v]) / exact[v];
    ++neighbors;
  }
  return {{"vertices", t.number_of_vertices()},
          {"near", neighbors == 0 ? 0 : near / static_cast<double>(neighbors)},
          {"mean", sum / static_cast<double>(reached) / farthest},
          {"greatest", greatest / farthest}};
}

// To where the heat kernel of the first vertex has errors.
Triangulation refined_at_source(Triangulation t, double farthest, std::size_t vertices) {
  const double time = farthest * farthest / 400;
  IT::adaptive_refine(
      t,
      [time](Triangulation& now) {
        const Eigen::VectorXd heat = IT::short_time_heat_kernel(now, 0, time);
        return IT::residual_indicators(now, {.diffusion = time, .reaction = 1}, heat,
                                       Eigen::VectorXd::Zero(heat.size()), IT::Error_norm::L2);
      },
      parameters::maximum_vertices(vertices));
  return t;
}

nlohmann::json measure(const Surface_mesh& mesh) {
  Triangulation t(mesh);
  const std::vector<double> exact = IT::Polyhedral_distance(t, first_vertex(t)).distances();
  nlohmann::json result{{"as_is", errors(t, exact)}};
  double farthest = 0;
  for (const double d : exact)
    if (std::isfinite(d)) farthest = std::max(farthest, d);
  IT::flip_to_delaunay(t);
  result["delaunay"] = errors(t, exact);
  result["at_source"] = errors(refined_at_source(t, farthest, 2 * exact.size()), exact);
  IT::delaunay_refine(t, parameters::minimum_angle(25));
  result["by_angle"] = errors(t, exact);
  IT::delaunay_refine(t, parameters::minimum_angle(25).maximum_edge_length(farthest / 150));
  result["by_size"] = errors(t, exact);
  return result;
}

} // namespace

int main(int argc, char** argv) {
  try {
    std::vector<std::string> names(argv + std::min(argc, 2), argv + argc);
    if (names.empty())
      names = {"mech-holes-shark",
               "anchor",
               "poly2x^2+y^2-0.062500",
               "turbine",
               "mannequin-devil",
               "bull",
               "man",
               "homer",
               "camel",
               "elephant"};
    nlohmann::json result;
    for (const std::string& name : names) {
      result[name] = measure(read_mesh(mesh_directory(argc, argv), name));
      std::cerr << name << ' ' << result[name].dump() << '\n';
    }
    std::cout << result.dump(2) << '\n';
  } catch (const std::exception& e) {
    std::cerr << "heat_accuracy: " << e.what() << '\n';
    return 1;
  }
}
