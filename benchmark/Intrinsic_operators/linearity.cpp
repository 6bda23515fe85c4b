// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Does the time of building and flipping to Delaunay grow linearly with the mesh? Tori in good order
// with the same number of flips per face. Usage: linearity [MAXIMUM_FACES] > result.json

#include "benchmark_support.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <exception>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using namespace IT::benchmark;

namespace {

struct Contender {
  std::string name;
  Run (*run)(const Surface_mesh&);
};

const std::vector<Contender> contenders = {
    {"double", run_ours<IT::Gluing_map, IT::Euclidean_traits<double>>},
    {"exact", run_ours<IT::Gluing_map, IT::Exact_euclidean_traits>},
    {"cgal", run_cgal}};

nlohmann::json measure_all(double maximum) {
  nlohmann::json result;
  std::map<std::string, std::vector<Sample>> samples;
  for (const double size : {1e4, 3e4, 1e5, 3e5, 1e6, 2e6, 4e6, 1e7}) {
    if (size > maximum) break;
    const Surface_mesh mesh = IT::synthetic::to_surface_mesh<Kernel::Point_3>(
        IT::synthetic::torus_of_size(static_cast<std::size_t>(size)));
    const auto faces = static_cast<double>(num_faces(mesh));
    std::map<std::string, std::vector<double>> times;
    for (int i = 0; i < (size < 5e5 ? 7 : 3); ++i) {
      for (const Contender& c : contenders) times[c.name].push_back(c.run(mesh).milliseconds);
    }
    nlohmann::json row = {{"faces", num_faces(mesh)}};
    for (const Contender& c : contenders) {
      const double time = median(times[c.name]);
      samples[c.name].push_back({faces, time});
      row["nanoseconds_per_face"][c.name] = 1e6 * time / faces;
    }
    std::cerr << row.dump() << '\n';
    result["sizes"].push_back(row);
  }
  for (const auto& [name, sample] : samples) result["exponent"][name] = exponent(sample);
  return result;
}

} // namespace

int main(int argc, char** argv) {
  try {
    std::cout << measure_all(argc > 1 ? std::stod(argv[1]) : 4e6).dump(2) << '\n';
  } catch (const std::exception& e) {
    std::cerr << "linearity: " << e.what() << '\n';
    return 1;
  }
}
