// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "load.h"
#include "output_files.h"
#include "statistics.h"
#include "support/progress.h"

#include <CGAL/Intrinsic_triangulations/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_triangulations/operators/mass_matrix.h>
#include <CGAL/Intrinsic_triangulations/operators/matrix_market.h>

namespace program {

namespace {

template <class Triangulation>
void write_matrices(Triangulation& t, const Options& options, Output_files& files) {
  const std::string origin = std::string(" by intrinsic ") + INTRINSIC_TRIANGULATIONS_VERSION;
  if (!options.output.empty())
    files.write(options.output, [&](std::ostream& out) {
      IT::write_matrix_market(
          out, IT::cotangent_laplacian(t),
          "cotangent Laplacian, positive semidefinite, rows in the order of the "
          "input's vertices,\n" +
              origin);
    });
  if (options.mass.empty()) return;
  const bool lumped = options.mass_kind == "lumped";
  files.write(options.mass, [&](std::ostream& out) {
    IT::write_matrix_market(out, lumped ? IT::lumped_mass_matrix(t) : IT::galerkin_mass_matrix(t),
                            options.mass_kind +
                                " mass matrix, rows in the order of the input's "
                                "vertices,\n" +
                                origin);
  });
}

template <class Triangulation>
void laplacian(Loaded<Triangulation>& loaded, const Options& options, Progress& progress) {
  Json json = flip_and_measure(loaded, !options.no_flip, options, progress);
  Stopwatch watch;
  Output_files files;
  progress.show("writing");
  try {
    write_matrices(loaded.triangulation, options, files);
  } catch (const IT::Invalid_input& e) {
    throw IT::Invalid_input(e.kind(), e.index(), options.input + ": " + e.what());
  }
  finish(json, options, files, watch);
  print_summary_on_terminal(json);
}

} // namespace

void run_laplacian(const Options& options) {
  Progress progress(options.logs_progress);
  with_loaded(options, progress, [&](auto& loaded) { laplacian(loaded, options, progress); });
}

} // namespace program
