// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How long do exact distances from one vertex to all take, and how much memory, compared with CGAL's
// Surface_mesh_shortest_path? Usage:
//   exact_distance [DIRECTORY [REPETITIONS [MODEL...]]] > distance.json
// How do they grow with the mesh? Usage:
//   exact_distance growth [DIRECTORY [MAXIMUM_FACES [MAXIMUM_FACES_OF_CGAL]]] > growth.json

#include "measure_models.h"

#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/distance/batches.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <nlohmann/json.hpp>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <map>
#include <new>
#include <span>
#include <string>
#include <vector>

#include <malloc.h>

namespace {

std::atomic<std::size_t> bytes_now = 0, bytes_peak = 0; // of all threads

void* counted(void* p) {
  if (p == nullptr) throw std::bad_alloc();
  const std::size_t now = bytes_now += malloc_usable_size(p);
  if (now > bytes_peak) bytes_peak = now; // exact while one thread allocates, as where it is read
  return p;
}

} // namespace

// All that both contenders allocate.
void* operator new(std::size_t n) { return counted(std::malloc(n)); }
void operator delete(void* p) noexcept {
  if (p != nullptr) bytes_now -= malloc_usable_size(p);
  std::free(p);
}
void operator delete(void* p, std::size_t) noexcept { operator delete(p); }

namespace IT = CGAL::Intrinsic_triangulations;
using namespace IT::benchmark;

namespace {

using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>>;
using Cgal_paths =
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Surface_mesh>>;

struct Distances {
  double milliseconds = 0;
  double peak_mib = 0; // of what was allocated meanwhile
  std::vector<double> values;
};

class Memory {
public:
  Memory() { bytes_peak = bytes_now.load(); }
  double peak_mib() const { return static_cast<double>(bytes_peak - start_) / 1048576; }

private:
  std::size_t start_ = bytes_now;
};

Distances run_cgal(const Surface_mesh& mesh) {
  const Stopwatch watch;
  const Memory memory;
  Cgal_paths paths(mesh);
  paths.add_source_point(*vertices(mesh).begin());
  paths.build_sequence_tree();
  Distances result{watch.milliseconds(), memory.peak_mib(), {}};
  for (const auto v : vertices(mesh))
    result.values.push_back(paths.shortest_distance_to_source_points(v).first);
  return result;
}

// Of a triangulation that is there, and with its making.
Distances run_ours(const Surface_mesh& mesh, bool from_mesh) {
  const Stopwatch all;
  const Triangulation t(mesh);
  auto from = *vertices(t.mesh()).begin();
  for (const auto v : vertices(t.mesh()))
    if (t.input_vertex(v) == 0) from = v;
  const Stopwatch watch;
  const Memory memory;
  const IT::Polyhedral_distance distance(t, from);
  const double time = from_mesh ? all.milliseconds() : watch.milliseconds();
  return {time, memory.peak_mib(), distance.distances()};
}

// The search alone, which is what programs report that take their tables as given.
double milliseconds_of_search(const Triangulation& t) {
  IT::Polyhedral_distance distance(t);
  const Stopwatch watch;
  distance.search(*vertices(t.mesh()).begin());
  return watch.milliseconds();
}

// Of one column of a batch of sources, spread over the vertices.
double milliseconds_of_column(const Triangulation& t, std::size_t threads) {
  constexpr std::size_t columns = 8;
  std::vector<Triangulation::vertex_descriptor> all(vertices(t.mesh()).begin(),
                                                    vertices(t.mesh()).end()),
      sources;
  for (std::size_t i = 0; i < columns; ++i) sources.push_back(all[i * all.size() / columns]);
  std::vector<double> out(columns * t.number_of_vertices());
  const Stopwatch watch;
  IT::polyhedral_distances(t, sources, std::span(out), IT::parameters::number_of_threads(threads));
  return watch.milliseconds() / columns;
}

// The greatest difference, relative, of ours to CGAL's: negative if ours is shorter.
double greatest_difference(const std::vector<double>& ours, const std::vector<double>& cgal) {
  double result = 0;
  for (std::size_t v = 0; v < ours.size(); ++v)
    if (cgal[v] > 0 && std::abs(ours[v] / cgal[v] - 1) > std::abs(result))
      result = ours[v] / cgal[v] - 1;
  return result;
}

nlohmann::json measure(const Surface_mesh& mesh, std::size_t repetitions) {
  std::vector<double> cgal_times, our_times, times_from_mesh, searches, columns, columns_in_threads;
  const Triangulation t(mesh);
  Distances cgal, ours;
  for (std::size_t i = 0; i < repetitions; ++i) {
    cgal = run_cgal(mesh);
    ours = run_ours(mesh, false);
    cgal_times.push_back(cgal.milliseconds);
    our_times.push_back(ours.milliseconds);
    times_from_mesh.push_back(run_ours(mesh, true).milliseconds);
    searches.push_back(milliseconds_of_search(t));
    columns.push_back(milliseconds_of_column(t, 1));
    columns_in_threads.push_back(milliseconds_of_column(t, 0));
  }
  return {{"faces", num_faces(mesh)},
          {"milliseconds",
           {{"cgal", median(cgal_times)},
            {"ours", median(our_times)},
            {"ours_from_mesh", median(times_from_mesh)},
            {"search", median(searches)},
            {"column_of_batch", median(columns)},
            {"column_of_batch_in_threads", median(columns_in_threads)}}},
          {"peak_mib", {{"cgal", cgal.peak_mib}, {"ours", ours.peak_mib}}},
          {"times_faster", median(cgal_times) / median(times_from_mesh)},
          {"times_less_memory", cgal.peak_mib / ours.peak_mib},
          {"greatest_relative_difference", greatest_difference(ours.values, cgal.values)}};
}

// A torus of about so many faces, or armadillo with random splits.
Surface_mesh mesh_of(const std::string& directory, const std::string& name, std::size_t faces) {
  return name == "torus"
             ? IT::synthetic::to_surface_mesh<Kernel::Point_3>(IT::synthetic::torus_of_size(faces))
             : split_armadillo(directory, faces);
}

// Processor time of one run of each, and its growth. CGAL's memory ends its series earlier.
nlohmann::json measure_growth(const std::string& directory, double maximum,
                              double maximum_of_cgal) {
  nlohmann::json result;
  std::map<std::string, std::vector<Sample>> times, peaks;
  for (const std::string name : {"torus", "armadillo"})
    for (const std::size_t faces : {10000U, 30000U, 100000U, 300000U, 1000000U}) {
      if (static_cast<double>(faces) > maximum || (name == "armadillo" && faces < 52000)) continue;
      const Surface_mesh mesh = mesh_of(directory, name, faces);
      const auto n = static_cast<double>(num_faces(mesh));
      nlohmann::json row = {{"mesh", name}, {"faces", num_faces(mesh)}};
      const auto run = [&](const std::string& contender, const auto& distances) {
        const double start = processor_time();
        const Distances d = distances();
        const double time = processor_time() - start;
        row[contender] = {{"milliseconds", time}, {"peak_mib", d.peak_mib}};
        times[name + ' ' + contender].push_back({n, time});
        peaks[name + ' ' + contender].push_back({n, d.peak_mib});
      };
      run("ours", [&] { return run_ours(mesh, true); });
      if (n <= maximum_of_cgal) run("cgal", [&] { return run_cgal(mesh); });
      std::cerr << row.dump() << '\n';
      result["sizes"].push_back(row);
    }
  for (const auto& [name, samples] : times)
    if (samples.size() > 1)
      result["exponent"][name] = {{"time", exponent(samples)}, {"memory", exponent(peaks[name])}};
  return result;
}

} // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::string(argv[1]) == "growth") {
    const double maximum = argc > 3 ? std::stod(argv[3]) : 1.1e6;
    const double maximum_of_cgal = argc > 4 ? std::stod(argv[4]) : 1.5e5;
    std::cout << measure_growth(mesh_directory(argc - 1, argv + 1), maximum, maximum_of_cgal).dump(2)
              << '\n';
    return 0;
  }
  return measure_models(argc, argv, "exact_distance", 3,
                        {"armadillo", "camel", "refined_elephant", "bunny00", "blade", "man",
                         "fandisk_large", "cylinder_locally_refined", "diplodocus",
                         "ChineseDragon-10kv"},
                        measure);
}
