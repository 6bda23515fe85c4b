// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How long do building and flipping to Delaunay take, compared with CGAL's intrinsic Delaunay
// triangulation of the heat method? Usage: delaunay_flips [DIRECTORY [REPETITIONS]] > result.json

#include "benchmark_support.h"

#include <nlohmann/json.hpp>

#include <exception>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using namespace IT::benchmark;

namespace {

struct Contender {
  std::string name;
  Run (*run)(const Surface_mesh&);
};

// The first one is the yardstick.
const std::vector<Contender> contenders = {
    {"cgal", run_cgal},
    {"double", run_ours<IT::Gluing_map, IT::Euclidean_traits<double>>},
    {"exact", run_ours<IT::Gluing_map, IT::Exact_euclidean_traits>},
    {"double_surface_mesh", run_ours<Surface_mesh, IT::Euclidean_traits<double>>},
    {"exact_surface_mesh", run_ours<Surface_mesh, IT::Exact_euclidean_traits>}};

struct Workload {
  std::string name;
  std::function<Surface_mesh()> make;
};

std::vector<Workload> workloads(const std::string& directory) {
  std::vector<Workload> result;
  for (const char* name : {"camel", "fandisk_large", "man", "armadillo"}) {
    result.push_back({name, [=] { return read_mesh(directory, name); }});
  }
  result.push_back({"shear_torus", [] {
                      return IT::synthetic::to_surface_mesh<Kernel::Point_3>(
                          IT::synthetic::shear_torus());
                    }});
  for (const bool is_fan : {true, false})
    result.push_back({is_fan ? "plate_of_fans" : "plate_cut_at_random", [=] {
                        return IT::synthetic::to_surface_mesh<Kernel::Point_3>(
                            IT::synthetic::sliver_plate(3000, is_fan ? 1000 : 100, 0.1, is_fan));
                      }});
  result.push_back({"arma_split1M", [=] { return split_armadillo(directory, 1000000); }});
  return result;
}

// Alternates the contenders, so that a slow spell of the machine hits all of them.
nlohmann::json measure(const Surface_mesh& mesh, std::size_t repetitions) {
  std::map<std::string, std::vector<double>> times;
  nlohmann::json result = {{"faces", num_faces(mesh)}, {"repetitions", repetitions}};
  for (const Contender& c : contenders) c.run(mesh); // warm up
  for (std::size_t i = 0; i < repetitions; ++i) {
    for (const Contender& c : contenders) {
      const Run run = c.run(mesh);
      times[c.name].push_back(run.milliseconds);
      if (run.flips) result["flips"][c.name] = *run.flips;
      if (run.checks) result["checks"][c.name] = *run.checks;
    }
  }
  const double yardstick = median(times[contenders.front().name]);
  for (const Contender& c : contenders) {
    const double time = median(times[c.name]);
    result["milliseconds"][c.name] = time;
    result["fastest_milliseconds"][c.name] =
        *std::min_element(times[c.name].begin(), times[c.name].end());
    result["ratio_to_cgal"][c.name] = time / yardstick;
  }
  return result;
}

nlohmann::json measure_all(const std::string& directory, std::size_t repetitions) {
  nlohmann::json result;
  std::map<std::string, std::vector<double>> ratios;
  for (const Workload& w : workloads(directory)) {
    const Surface_mesh mesh = w.make();
    const bool is_long = num_faces(mesh) > 500000;
    result["meshes"][w.name] =
        measure(mesh, is_long ? std::min<std::size_t>(repetitions, 3) : repetitions);
    for (const Contender& c : contenders) {
      ratios[c.name].push_back(result["meshes"][w.name]["ratio_to_cgal"][c.name].get<double>());
    }
    std::cerr << w.name << ' ' << result["meshes"][w.name].dump() << '\n';
  }
  for (const auto& [name, sample] : ratios) {
    result["geometric_mean_ratio_to_cgal"][name] = geometric_mean(sample);
  }
  return result;
}

} // namespace

int main(int argc, char** argv) {
  try {
    const std::size_t repetitions = argc > 2 ? std::stoul(argv[2]) : 7;
    std::cout << measure_all(mesh_directory(argc, argv), repetitions).dump(2) << '\n';
  } catch (const std::exception& e) {
    std::cerr << "delaunay_flips: " << e.what() << '\n';
    return 1;
  }
}
