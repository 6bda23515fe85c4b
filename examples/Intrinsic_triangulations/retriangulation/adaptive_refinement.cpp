// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes the harmonic Green's function of a vertex, and heat after a short time, with vertices
// where the estimated error is large.

#include <CGAL/Intrinsic_operators/operators/reaction_diffusion.h>
#include <CGAL/Intrinsic_operators/operators/residual_indicators.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <iostream>
#include <string>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>>;

void print(const char* name, const IT::Adaptive_refinement_result& result) {
  std::cout << name << ": " << result.rounds.size() << " rounds, from "
            << result.rounds.front().vertices << " to " << result.rounds.back().vertices
            << " vertices, estimated error from " << result.rounds.front().estimated_error << " to "
            << result.rounds.back().estimated_error << '\n';
}

int main(int argc, char* argv[]) {
  const std::string file = argc > 1 ? argv[1] : "data/part.off";
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << file << ": cannot be read\n";
    return 1;
  }
  double area = 0;
  Triangulation t(mesh), s(mesh);
  for (const auto f : faces(t.mesh())) area += t.area(f);

  //! [adaptive]
  Eigen::VectorXd u; // the Green's function of vertex 0
  const auto estimate = [&](Triangulation& now) {
    u = IT::harmonic_green_function(now, 0);
    const Eigen::VectorXd density = Eigen::VectorXd::Constant(u.size(), -1 / area);
    return IT::residual_indicators(now, {.diffusion = 1}, u, density, IT::Error_norm::L2);
  };
  const auto green =
      IT::adaptive_refine(t, estimate, IT::parameters::tolerance(5e-3 * std::sqrt(area)));
  //! [adaptive]
  print("Green's function", green);

  const double time = 1e-3 * area;
  Eigen::VectorXd heat;
  const auto result = IT::adaptive_refine(
      s,
      [&](Triangulation& now) {
        heat = IT::short_time_heat_kernel(now, 0, time);
        return IT::residual_indicators(now, {.diffusion = time, .reaction = 1}, heat,
                                       Eigen::VectorXd::Zero(heat.size()), IT::Error_norm::L2);
      },
      IT::parameters::tolerance(1 / std::sqrt(area))); // the heat kernel is an inverse area
  print("heat kernel", result);
  return green.status != IT::Status::done || result.status != IT::Status::done;
}
