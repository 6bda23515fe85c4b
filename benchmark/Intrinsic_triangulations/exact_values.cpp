// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What do values cost after flips, exactly and with doubles: the Laplacian, areas, lengths, these
// together, and testing and measuring all elements?
// Usage: exact_values [DIRECTORY [REPETITIONS [FILE...]]] > values.json

#include "benchmark_support.h"

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure_quality.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>

namespace IT = CGAL::Intrinsic_triangulations;
using namespace IT::benchmark;

namespace {

// Milliseconds of processor time, by contender and by what is measured; the fastest run.
using Times = std::map<std::string, std::map<std::string, double>>;

template <class Function>
void record(std::map<std::string, double>& times, const std::string& what, const Function& f) {
  const double start = processor_time();
  f();
  const double time = processor_time() - start;
  const auto [entry, is_new] = times.try_emplace(what, time);
  entry->second = std::min(entry->second, time);
}

// Nothing that one measurement makes narrow helps the next one: each gets a copy.
template <class Triangulation>
void measure_values(const Triangulation& t, std::map<std::string, double>& times) {
  const auto measure = [&](const std::string& what, const auto& f) {
    const Triangulation copy = t;
    record(times, what, [&] { f(copy); });
  };
  measure("laplacian", [](const auto& x) { IT::cotangent_laplacian(x); });
  measure("areas", [](const auto& x) { IT::lumped_mass_matrix(x); });
  measure("lengths", [](const auto& x) {
    double sum = 0;
    for (const auto e : edges(x.mesh())) sum += x.length(e);
    return sum;
  });
  measure("together", [](const auto& x) {
    IT::cotangent_laplacian(x);
    IT::lumped_mass_matrix(x);
    double sum = 0;
    for (const auto e : edges(x.mesh())) sum += x.length(e);
    return sum;
  });
  measure("verification", [](const auto& x) {
    IT::check_delaunay(x);
    IT::measure_quality(x);
    IT::cotangent_laplacian(x);
    IT::lumped_mass_matrix(x);
  });
}

template <class Traits, class Correspondence>
void measure(const Surface_mesh& mesh, bool is_refined, std::map<std::string, double>& times) {
  using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, Traits, Correspondence>;
  Triangulation t(mesh);
  record(times, "flips", [&] { IT::flip_to_delaunay(t); });
  if (is_refined) IT::delaunay_refine(t, IT::parameters::default_values());
  measure_values(t, times);
}

nlohmann::json measure_all(const Surface_mesh& mesh, std::size_t repetitions, bool is_refined) {
  using Double = IT::Euclidean_traits<double>;
  using Exact = IT::Exact_euclidean_traits;
  Times times;
  for (std::size_t i = 0; i < repetitions; ++i) {
    measure<Double, IT::No_correspondence>(mesh, false, times["double"]);
    measure<Exact, IT::No_correspondence>(mesh, false, times["exact"]);
    measure<Exact, IT::Integer_coordinates>(mesh, false, times["exact integer"]);
    if (!is_refined) continue;
    measure<Double, IT::Integer_coordinates>(mesh, true, times["double refined"]);
    measure<Exact, IT::Integer_coordinates>(mesh, true, times["exact refined"]);
  }
  return times;
}

void add(nlohmann::json& total, const nlohmann::json& times) {
  for (const auto& [contender, row] : times.items())
    for (const auto& [what, time] : row.items()) {
      nlohmann::json& sum = total[contender][what];
      sum = (sum.is_null() ? 0 : sum.get<double>()) + time.get<double>();
    }
}

// Files that are not manifold meshes of triangles are left out.
nlohmann::json measure_directory(const std::string& directory, std::size_t repetitions) {
  nlohmann::json total;
  for (const auto& file : std::filesystem::directory_iterator(directory)) {
    try {
      Surface_mesh mesh;
      const std::string name = file.path().string();
      if (file.path().extension() != ".off" ||
          !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(name, mesh) ||
          !CGAL::is_triangle_mesh(mesh) || num_faces(mesh) == 0)
        continue;
      add(total, measure_all(mesh, repetitions, false));
    } catch (const std::exception& e) {
      std::cerr << file.path() << ": " << e.what() << '\n';
    }
  }
  return total;
}

} // namespace

int main(int argc, char** argv) {
  try {
    const std::string directory = mesh_directory(argc, argv);
    const std::size_t repetitions = argc > 2 ? std::stoul(argv[2]) : 3;
    nlohmann::json result;
    result["shear_torus"] =
        measure_all(IT::synthetic::to_surface_mesh<Kernel::Point_3>(IT::synthetic::shear_torus()),
                    repetitions, false);
    for (const char* const name : {"camel", "armadillo", "bunny00"})
      result[name] = measure_all(read_mesh(directory, name), repetitions, false);
    result["arma_split200k"] = measure_all(split_armadillo(directory, 200000), repetitions, false);
    result["arma_split1M"] = measure_all(split_armadillo(directory, 1000000), repetitions, false);
    result["all meshes"] = measure_directory(directory, repetitions);
    for (int i = 3; i < argc; ++i) {
      Surface_mesh mesh;
      if (!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(std::string(argv[i]), mesh))
        throw std::runtime_error(std::string("cannot read ") + argv[i]);
      result[argv[i]] = measure_all(mesh, repetitions, true);
    }
    std::cout << result.dump(2) << '\n';
  } catch (const std::exception& e) {
    std::cerr << "exact_values: " << e.what() << '\n';
    return 1;
  }
}
