// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What do the correspondences add to building and flipping, and how long does the common
// subdivision take, with doubles and exactly, in units of CGAL's intrinsic Delaunay triangulation
// of the heat method?
// Usage: correspondence_cost [DIRECTORY [REPETITIONS]] > result.json

#include "benchmark_support.h"

#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using namespace IT::benchmark;

namespace {

// The fastest of the runs so far, in milliseconds, by name.
using Times = std::map<std::string, double>;

void record(Times& times, const std::string& name, double milliseconds) {
  const auto entry = times.emplace(name, std::numeric_limits<double>::infinity()).first;
  entry->second = std::min(entry->second, milliseconds);
}

template <class Traits, class Correspondence>
void measure(const Surface_mesh& mesh, const std::string& arithmetic, Times& times) {
  using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, Traits, Correspondence>;
  const std::string name = arithmetic + ' ' + Correspondence::name;
  const Stopwatch whole;
  Triangulation t(mesh);
  const Stopwatch flips;
  IT::flip_to_delaunay(t);
  record(times, name + " flips", flips.milliseconds());
  record(times, name + " build and flips", whole.milliseconds());
  if constexpr (!std::is_same_v<Correspondence, IT::No_correspondence>) {
    const Stopwatch subdivision;
    const IT::Common_subdivision s = IT::common_subdivision(t);
    record(times, name + " subdivision", subdivision.milliseconds());
  }
}

template <class Traits>
void measure_correspondences(const Surface_mesh& mesh, const std::string& arithmetic,
                             Times& times) {
  measure<Traits, IT::No_correspondence>(mesh, arithmetic, times);
  measure<Traits, IT::Integer_coordinates>(mesh, arithmetic, times);
  measure<Traits, IT::Explicit_crossings>(mesh, arithmetic, times);
  measure<Traits, IT::Signposts>(mesh, arithmetic, times);
}

nlohmann::json measure_all(const Surface_mesh& mesh, std::size_t repetitions) {
  Times times;
  for (std::size_t i = 0; i < repetitions; ++i) {
    record(times, "cgal", run_cgal(mesh).milliseconds);
    measure_correspondences<IT::Euclidean_traits<double>>(mesh, "double", times);
    measure_correspondences<IT::Exact_euclidean_traits>(mesh, "exact", times);
  }
  nlohmann::json result = {{"faces", num_faces(mesh)}, {"repetitions", repetitions}};
  for (const auto& [name, time] : times) {
    result["fastest_milliseconds"][name] = time;
    result["ratio_to_cgal"][name] = time / times.at("cgal");
  }
  for (const std::string arithmetic : {"double", "exact"})
    result["integer_to_none"][arithmetic] = times.at(arithmetic + " integer build and flips") /
                                            times.at(arithmetic + " none build and flips");
  return result;
}

} // namespace

int main(int argc, char** argv) {
  try {
    const std::string directory = mesh_directory(argc, argv);
    const std::size_t repetitions = argc > 2 ? std::stoul(argv[2]) : 5;
    nlohmann::json result;
    for (const std::string name : {"camel", "armadillo", "refined_elephant"})
      result[name] = measure_all(read_mesh(directory, name), repetitions);
    result["shear_torus"] = measure_all(
        IT::synthetic::to_surface_mesh<Kernel::Point_3>(IT::synthetic::shear_torus()), repetitions);
    result["arma_split200k"] = measure_all(split_armadillo(directory, 200000), repetitions);
    std::cout << result.dump(2) << '\n';
  } catch (const std::exception& e) {
    std::cerr << "correspondence_cost: " << e.what() << '\n';
    return 1;
  }
}
