// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How much time and memory does each step take, from the file of a large mesh to its Laplacian in a
// file? Usage: large_mesh FILE > steps.json

#include "benchmark_support.h"

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/matrix_market.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>

namespace IT = CGAL::Intrinsic_triangulations;
using namespace IT::benchmark;

namespace {

/// Bytes of the process that Linux counts.
struct Memory {
  double now = 0, peak = 0;
};

/// returns the memory now, and the peak since the last call.
Memory take_memory() {
  Memory memory;
  std::ifstream in("/proc/self/status");
  for (std::string word; in >> word;) {
    if (word == "VmRSS:") in >> memory.now;
    if (word == "VmHWM:") in >> memory.peak;
  }
  std::ofstream("/proc/self/clear_refs") << 5; // the next peak counts from here
  return {1024 * memory.now, 1024 * memory.peak};
}

/// Measures steps one after another.
class Steps {
public:
  void end(const char* name) {
    const double time = processor_time() - start_;
    const Memory memory = take_memory();
    json_.push_back({{"step", name},
                     {"nanoseconds", 1e6 * time},
                     {"bytes", memory.now},
                     {"peak_bytes", memory.peak}});
    start_ = processor_time();
  }

  /// returns all per face.
  nlohmann::json per_face(double faces) const {
    nlohmann::json result = json_;
    for (nlohmann::json& step : result)
      for (const char* key : {"nanoseconds", "bytes", "peak_bytes"})
        step[key] = step[key].get<double>() / faces;
    return result;
  }

private:
  double start_ = processor_time();
  nlohmann::json json_ = nlohmann::json::array();
};

nlohmann::json measure(const std::string& file) {
  Steps steps;
  IT::Triangle_soup soup = IT::read_triangle_soup(file);
  const auto faces = static_cast<double>(soup.triangles.size());
  steps.end("read");
  IT::Domain domain = IT::make_domain(std::move(soup));
  steps.end("match edges");
  IT::Intrinsic_triangulation<> t(std::move(domain.input));
  steps.end("build");
  const auto flips = IT::flip_to_delaunay(t);
  steps.end("flip exactly");
  const bool is_delaunay = IT::is_delaunay(t);
  steps.end("certify");
  const Eigen::SparseMatrix<double> laplacian = IT::cotangent_laplacian(t);
  steps.end("Laplacian");
  std::ofstream out("/dev/null");
  IT::write_matrix_market(out, laplacian);
  steps.end("write");
  return {{"file", file},
          {"faces", faces},
          {"flips", flips.flips},
          {"is_delaunay", is_delaunay},
          {"renumbered", t.report().renumbered},
          {"per_face", steps.per_face(faces)}};
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: large_mesh FILE > steps.json\n";
    return 2;
  }
  try {
    std::cout << measure(argv[1]).dump(2) << '\n';
  } catch (const std::exception& e) {
    std::cerr << "large_mesh: " << e.what() << '\n';
    return 1;
  }
}
