// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How long do distances by heat take on the intrinsic Delaunay triangulation, compared with CGAL's heat method on its own: from the mesh to the distances
// from one vertex, and the distances from another vertex after that? Which share of the latter is solving with the factors? What does a column of a batch
// take?
// Usage: heat_distance [DIRECTORY [REPETITIONS [MODEL...]]] > heat_distance.json

#include "measure_models.h"

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Intrinsic_operators/distance/Heat_distance.h>
#include <CGAL/Intrinsic_operators/distance/heat_distances.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>

#include <Eigen/Core>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using namespace IT::benchmark;

namespace {

using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>>;
using Cgal_heat =
    CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Surface_mesh,
                                                           CGAL::Heat_method_3::Intrinsic_Delaunay>;

struct Times {
  std::vector<double> all, next, solve, column, column_in_threads; // milliseconds
};

// Of one column of a batch of sources, spread over the vertices.
double milliseconds_of_column(const IT::Heat_distance<Triangulation>& heat, const Triangulation& t,
                              std::size_t threads) {
  constexpr std::size_t columns = 32;
  const std::vector<Triangulation::vertex_descriptor> all(vertices(t.mesh()).begin(),
                                                          vertices(t.mesh()).end());
  std::vector<Triangulation::vertex_descriptor> sources;
  for (std::size_t i = 0; i < columns; ++i) sources.push_back(all[i * all.size() / columns]);
  std::vector<double> out(columns * t.number_of_vertices());
  const Stopwatch watch;
  IT::heat_distances(heat, sources, std::span(out), IT::parameters::number_of_threads(threads));
  return watch.milliseconds() / columns;
}

std::vector<double> run_cgal_heat(const Surface_mesh& mesh, Times& times) {
  Stopwatch watch;
  Cgal_heat heat(mesh);
  Surface_mesh copy(mesh);
  const auto map = copy.add_property_map<Surface_mesh::Vertex_index, double>("v:d", 0).first;
  heat.add_source(*vertices(mesh).begin());
  heat.estimate_geodesic_distances(map);
  times.all.push_back(watch.milliseconds());
  std::vector<double> result;
  for (const auto v : vertices(mesh)) result.push_back(map[v]);
  watch = Stopwatch();
  heat.clear_sources();
  heat.add_source(*std::prev(vertices(mesh).end()));
  heat.estimate_geodesic_distances(map);
  times.next.push_back(watch.milliseconds());
  return result;
}

std::vector<double> run_our_heat(const Surface_mesh& mesh, Times& times) {
  Stopwatch watch;
  Triangulation t(mesh);
  IT::flip_to_delaunay(t);
  IT::Heat_distance heat(t);
  auto first = *vertices(t.mesh()).begin(), last = first;
  for (const auto v : vertices(t.mesh())) {
    if (t.input_vertex(v) == 0) first = v;
    if (t.input_vertex(v) + 1 == t.number_of_vertices()) last = v;
  }
  const Eigen::VectorXd d = heat.distances(first);
  times.all.push_back(watch.milliseconds());
  watch = Stopwatch();
  heat.distances(last);
  times.next.push_back(watch.milliseconds());
  times.column.push_back(milliseconds_of_column(heat, t, 1));
  times.column_in_threads.push_back(milliseconds_of_column(heat, t, 0));
  // two solutions with a factor of the same pattern
  const Eigen::SparseMatrix<double> l = IT::cotangent_laplacian(t);
  const IT::Laplacian_factorization factored(l, Eigen::VectorXd::Ones(l.rows()));
  watch = Stopwatch();
  const Eigen::VectorXd x = factored.solve(factored.solve(d));
  times.solve.push_back(watch.milliseconds() + 0 * x[0]);
  return {d.begin(), d.end()};
}

nlohmann::json measure(const Surface_mesh& mesh, std::size_t repetitions) {
  Times cgal, ours;
  std::vector<double> of_cgal, of_ours;
  for (std::size_t i = 0; i < repetitions; ++i) {
    of_cgal = run_cgal_heat(mesh, cgal);
    of_ours = run_our_heat(mesh, ours);
  }
  double farthest = 0, difference = 0;
  for (std::size_t v = 0; v < of_ours.size(); ++v)
    if (std::isfinite(of_ours[v])) {
      farthest = std::max(farthest, of_ours[v]);
      difference = std::max(difference, std::abs(of_ours[v] - of_cgal[v]));
    }
  return {{"vertices", num_vertices(mesh)},
          {"milliseconds",
           {{"cgal", median(cgal.all)},
            {"ours", median(ours.all)},
            {"cgal_next", median(cgal.next)},
            {"ours_next", median(ours.next)},
            {"column_of_batch", median(ours.column)},
            {"column_of_batch_in_threads", median(ours.column_in_threads)},
            {"two_solutions", median(ours.solve)}}},
          {"times_faster", median(cgal.all) / median(ours.all)},
          {"times_faster_next", median(cgal.next) / median(ours.next)},
          {"share_of_solving", median(ours.solve) / median(ours.next)},
          {"greatest_difference", difference / farthest}};
}

} // namespace

int main(int argc, char** argv) {
  return measure_models(argc, argv, "heat_distance", 5,
                        {"armadillo", "camel", "bunny00", "refined_elephant", "man", "fandisk"},
                        measure);
}
