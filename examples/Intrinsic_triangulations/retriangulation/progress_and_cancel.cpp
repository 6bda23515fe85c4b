// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Refines with a progress bar on standard error, and stops at a deadline, with a valid Delaunay
// triangulation. Usage: progress_and_cancel [SECONDS]

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Clock = std::chrono::steady_clock;

//! [visitor]
struct Progress : IT::Refinement_visitor {
  explicit Progress(std::chrono::duration<double> time)
      : start(Clock::now()), seconds(time.count()) {}

  bool progress(const IT::Refinement_counts& counts) { // about every 256 insertions
    const double part = std::chrono::duration<double>(Clock::now() - start).count() / seconds;
    const auto filled = static_cast<std::size_t>(part < 1 ? 40 * part : 40);
    std::cerr << "\r[" << std::string(filled, '#') << std::string(40 - filled, ' ') << "] "
              << counts.inserted_vertices() << " vertices";
    return part < 1; // false cancels
  }

  Clock::time_point start;
  double seconds;
};
//! [visitor]

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh("data/part.off", mesh)) return 1;
  IT::Intrinsic_triangulation<> t(mesh);
  Progress progress(std::chrono::duration<double>(argc > 1 ? std::atof(argv[1]) : 0.5));
  //! [cancel]
  // edges of 0.01 mm on a part of 12 cm: some hundred million vertices
  const auto result = IT::delaunay_refine(
      t, IT::parameters::minimum_angle(25).maximum_edge_length(0.01).visitor(std::ref(progress)));
  //! [cancel]
  std::cerr << '\n';
  const bool cancelled = result.status == IT::Status::cancelled;
  std::cout << (cancelled ? "cancelled" : "not cancelled") << " with "
            << result.counts.inserted_vertices() << " vertices inserted, "
            << result.unsatisfied.size() << " faces yet to refine\n";
  return cancelled && IT::is_delaunay(t) && !result.unsatisfied.empty() ? 0 : 1;
}
