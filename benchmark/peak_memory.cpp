// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How much memory do building and flipping to Delaunay take on a million faces? One contender per
// process, as the peak of a process never falls.
// Usage: peak_memory double|exact|cgal [DIRECTORY] > result.json

#include "benchmark_support.h"

#include <nlohmann/json.hpp>

#include <exception>
#include <iostream>
#include <map>
#include <string>

namespace IT = CGAL::Intrinsic_triangulations;
using namespace IT::benchmark;

int main(int argc, char** argv) {
  const std::map<std::string, Run (*)(const Surface_mesh&)> contenders = {
      {"double", run_ours<IT::Gluing_map, IT::Euclidean_traits<double>>},
      {"exact", run_ours<IT::Gluing_map, IT::Exact_euclidean_traits>},
      {"cgal", run_cgal}};
  const auto contender = contenders.find(argc > 1 ? argv[1] : "");
  if (contender == contenders.end()) {
    std::cerr << "usage: peak_memory double|exact|cgal [DIRECTORY]\n";
    return 2;
  }
  try {
    const Surface_mesh mesh = split_armadillo(mesh_directory(argc - 1, argv + 1), 1000000);
    const double before = peak_rss_mib();
    const Run run = contender->second(mesh);
    const nlohmann::json result = {{"contender", contender->first},
                                   {"faces", num_faces(mesh)},
                                   {"milliseconds", run.milliseconds},
                                   {"peak_rss_mib_before", before},
                                   {"peak_rss_mib_after", peak_rss_mib()}};
    std::cout << result.dump(2) << '\n';
  } catch (const std::exception& e) {
    std::cerr << "peak_memory: " << e.what() << '\n';
    return 1;
  }
}
