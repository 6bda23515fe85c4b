// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../commands.h"
#include "../support/text_lines.h"
#include "application.h"

#include <CGAL/Intrinsic_operators/editing/Surface_deformation.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>

#include <cstdint>
#include <vector>

namespace program {

namespace {

/// Vertices that are moved, and by how much.
struct Handles {
  std::vector<std::uint32_t> rows;
  Eigen::MatrixXd displacements;
};

// On each line the number of a vertex and its displacement.
Handles read_handles(const Options& options, std::size_t vertices) {
  const Number_table table =
      read_numbers(options.application.handles, vertices, "vertices of " + options.input);
  if (table.columns != 4) table.refuse(0, "give the number of a vertex and three coordinates");
  Handles handles{vertex_numbers(table, vertices),
                  Eigen::MatrixXd(static_cast<Eigen::Index>(table.rows()), 3)};
  for (std::size_t i = 0; i < table.rows(); ++i)
    for (Eigen::Index c = 0; c < 3; ++c)
      handles.displacements(static_cast<Eigen::Index>(i), c) =
          table.values[4 * i + 1 + static_cast<std::size_t>(c)];
  return handles;
}

} // namespace

void run_edit(const Options& options) {
  run_application(options, [&](const auto& t, const Sources&, const Points&, Progress&) {
    const bool is_harmonic = options.application.energy == "harmonic";
    const Handles handles = read_handles(options, t.input().number_of_rows());
    const IT::Surface_deformation deformation(t, handles.rows,
                                              is_harmonic ? IT::Deformation_energy::harmonic
                                                          : IT::Deformation_energy::biharmonic,
                                              IT::solver_named(options.application.solver));
    Computed computed{"edit", {}, {}};
    computed.displacements = deformation.displacements(handles.displacements);
    computed.json = {{"handles", handles.rows.size()},
                     {"energy", options.application.energy},
                     {"max_displacement", computed.displacements.rowwise().norm().maxCoeff()}};
    return computed;
  });
}

} // namespace program
