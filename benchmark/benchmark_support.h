// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_BENCHMARK_BENCHMARK_SUPPORT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_BENCHMARK_BENCHMARK_SUPPORT_H

#include "synthetic_meshes.h"

#include <CGAL/Heat_method_3/internal/Intrinsic_Delaunay_triangulation_3.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/resource.h>

namespace CGAL::Intrinsic_triangulations::benchmark {

/// Kernel of the measured meshes: doubles, as all contenders compute with them.
using Kernel = CGAL::Simple_cartesian<double>;
/// Mesh that all contenders start from.
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
/// CGAL's intrinsic Delaunay triangulation of the heat method.
using Cgal_delaunay = CGAL::Heat_method_3::Intrinsic_Delaunay_triangulation_3<Surface_mesh>;

/// What one run did.
struct Run {
  /// Milliseconds, construction and destruction of temporaries included, that of the result not.
  double milliseconds = 0;
  /// Number of flips; CGAL does not report it.
  std::optional<std::uint64_t> flips = std::nullopt;
  /// Number of tested edges; CGAL does not report it.
  std::optional<std::uint64_t> checks = std::nullopt;
};

/// measures wall clock time from its construction.
class Stopwatch {
public:
  /// returns the milliseconds since construction.
  double milliseconds() const {
    return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

/// returns the milliseconds of the processor that the process has taken, in all of its threads.
inline double processor_time() {
  std::timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

/// builds CGAL's triangulation, which copies the mesh, flips, and lays out the faces.
inline Run run_cgal(const Surface_mesh& mesh) {
  const Stopwatch watch;
  const Cgal_delaunay t(mesh);
  return {watch.milliseconds()};
}

/*!
\brief builds our triangulation and flips it to Delaunay.
\tparam Mesh the mesh type of the triangulation
\tparam Traits the arithmetic
*/
template <class Mesh, class Traits>
Run run_ours(const Surface_mesh& mesh) {
  const Stopwatch watch;
  Intrinsic_triangulation<Mesh, Traits> t(mesh);
  const auto result = flip_to_delaunay(t);
  return {watch.milliseconds(), result.flips, result.checks};
}

/// A size of a problem, and the time that it took.
struct Sample {
  double size, milliseconds;
};

/// returns the slope of the least squares line through (log size, log time): 1 is linear.
inline double exponent(const std::vector<Sample>& samples) {
  const auto n = static_cast<double>(samples.size());
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const Sample& s : samples) {
    const double u = std::log(s.size), v = std::log(s.milliseconds);
    x += u;
    y += v;
    xx += u * u;
    xy += u * v;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

/// returns the median of a nonempty sample.
inline double median(std::vector<double> sample) {
  std::sort(sample.begin(), sample.end());
  const std::size_t n = sample.size();
  return n % 2 == 1 ? sample[n / 2] : (sample[n / 2 - 1] + sample[n / 2]) / 2;
}

/// returns the geometric mean of a nonempty sample of positive numbers.
inline double geometric_mean(const std::vector<double>& sample) {
  double sum = 0;
  for (const double x : sample) sum += std::log(x);
  return std::exp(sum / static_cast<double>(sample.size()));
}

/// reads a mesh of CGAL's data set; throws if that fails.
inline Surface_mesh read_mesh(const std::string& directory, const std::string& name) {
  Surface_mesh mesh;
  const std::string file = directory + "/" + name + ".off";
  if (!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, mesh)) {
    throw std::runtime_error("cannot read " + file + " as a manifold mesh");
  }
  return mesh;
}

/// returns the directory of CGAL's meshes: the first argument, or else what the build found.
inline std::string mesh_directory(int argc, char** argv) {
  if (argc > 1) return argv[1];
#ifdef INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR
  return INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR;
#else
  throw std::runtime_error("give the directory of CGAL's meshes (data/meshes) as argument");
#endif
}

/// returns armadillo with random edge splits until there are `faces` faces.
inline Surface_mesh split_armadillo(const std::string& directory, std::size_t faces) {
  return synthetic::to_surface_mesh<Kernel::Point_3>(
      synthetic::random_edge_splits(synthetic::to_soup(read_mesh(directory, "armadillo")), faces));
}

/// returns the largest resident set of the process so far, in MiB.
inline double peak_rss_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

} // namespace CGAL::Intrinsic_triangulations::benchmark

#endif // CGAL_INTRINSIC_TRIANGULATIONS_BENCHMARK_BENCHMARK_SUPPORT_H
