// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How even do triangles become if vertices move, and how long does it take, with doubles and
// exactly? Usage: optimal_delaunay PART.off [DIRECTORY [REPETITIONS]] > result.json

#include "benchmark_support.h"

#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure_quality.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/optimization/odt_optimize.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <iostream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>

namespace IT = CGAL::Intrinsic_triangulations;
using namespace IT::benchmark;

namespace {

template <class Traits>
using Triangulation_with = IT::Intrinsic_triangulation<IT::Gluing_map, Traits>;

enum Stage { delaunay, refined, moved, alone };
constexpr std::array<const char*, 4> names{"Delaunay", "refined", "moved", "alone"};

// Seconds per stage, the fastest so far.
using Seconds = std::array<double, 4>;

template <class Triangulation>
nlohmann::json describe(const Triangulation& t) {
  double n = 0, sum = 0, squares = 0;
  for (const auto f : faces(t.mesh())) {
    const double area = t.area(f);
    n += 1;
    sum += area;
    squares += area * area;
  }
  const IT::Quality q = IT::measure_quality(t);
  const auto range = vertices(t.mesh()); // not num_vertices(), which counts removed ones
  const auto number = std::distance(range.begin(), range.end());
  return {{"vertices", number},
          {"spread_of_areas", std::sqrt(n * squares - sum * sum) / sum},
          {"minimum_angle", q.minimum_angle},
          {"maximum_angle", q.maximum_angle},
          {"mean_aspect_ratio", q.mean_aspect_ratio},
          {"energy", IT::odt_energy(t) * static_cast<double>(number) / (sum * sum)}};
}

// Calls `work` and reports the result.
template <class Triangulation, class Work>
nlohmann::json measure(Triangulation& t, double& seconds, const Work& work) {
  const Stopwatch watch;
  work();
  seconds = std::min(seconds, watch.milliseconds() / 1000);
  return describe(t);
}

template <class Triangulation>
double mean_edge(const Triangulation& t) {
  double sum = 0;
  for (const auto e : edges(t.mesh())) sum += std::sqrt(t.squared_length(e));
  return sum / static_cast<double>(num_edges(t.mesh()));
}

template <class Traits>
std::array<nlohmann::json, 4> run(const Surface_mesh& mesh, Seconds& seconds) {
  using Triangulation = Triangulation_with<Traits>;
  std::array<nlohmann::json, 4> result;
  Triangulation t(mesh);
  const double target = 0.6 * mean_edge(t);
  result[delaunay] = measure(t, seconds[delaunay], [&] { IT::flip_to_delaunay(t); });
  result[refined] = measure(t, seconds[refined], [&] {
    IT::delaunay_refine(t, IT::parameters::minimum_angle(25).maximum_edge_length(target));
  });
  result[moved] = measure(t, seconds[moved], [&] { IT::odt_optimize(t); });
  Triangulation other(mesh);
  IT::flip_to_delaunay(other);
  result[alone] = measure(other, seconds[alone], [&] {
    IT::odt_optimize(other, IT::parameters::maximum_edge_length(target));
  });
  return result;
}

nlohmann::json measure_all(const Surface_mesh& mesh, const std::string& name, int repetitions) {
  Seconds with_doubles, exactly;
  with_doubles.fill(std::numeric_limits<double>::infinity());
  exactly = with_doubles;
  std::array<nlohmann::json, 4> rows;
  for (int i = 0; i < repetitions; ++i) {
    rows = run<IT::Euclidean_traits<double>>(mesh, with_doubles);
    run<IT::Exact_euclidean_traits>(mesh, exactly);
  }
  nlohmann::json result;
  for (const std::size_t i : {0U, 1U, 2U, 3U}) {
    rows[i]["seconds"] = {{"double", with_doubles[i]}, {"exact", exactly[i]}};
    result[names[i]] = rows[i];
    std::fprintf(stderr, "| %s, %s | %zu | %.2f | %.1f | %.1f | %.2f | %.2f | %.2f | %.3f |\n",
                 name.c_str(), names[i], rows[i]["vertices"].get<std::size_t>(),
                 rows[i]["spread_of_areas"].get<double>(), rows[i]["minimum_angle"].get<double>(),
                 rows[i]["maximum_angle"].get<double>(), rows[i]["mean_aspect_ratio"].get<double>(),
                 with_doubles[i], exactly[i], rows[i]["energy"].get<double>());
  }
  return result;
}

} // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 2) throw std::runtime_error("give the part of the examples as argument");
    const std::string directory = mesh_directory(argc - 1, argv + 1);
    const int repetitions = argc > 3 ? std::stoi(argv[3]) : 3;
    nlohmann::json result;
    for (const std::string name : {"eight", "fandisk"})
      result[name] = measure_all(read_mesh(directory, name), name, repetitions);
    Surface_mesh part;
    if (!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], part))
      throw std::runtime_error(std::string(argv[1]) + " cannot be read");
    result["part"] = measure_all(part, "part", repetitions);
    std::cout << result.dump(2) << '\n';
  } catch (const std::exception& e) {
    std::cerr << "optimal_delaunay: " << e.what() << '\n';
    return 1;
  }
}
