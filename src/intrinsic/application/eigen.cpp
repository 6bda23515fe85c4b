// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../commands.h"
#include "application.h"

#include <CGAL/Intrinsic_operators/operators/surface_modes.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>

#include <string>
#include <vector>

namespace program {

namespace {

Computed eigenfunctions(const IT::Eigenpairs& pairs) {
  const Eigen::Index n = pairs.values.size();
  Computed computed{"eigen", {}, {}};
  computed.json = {{"count", n},
                   {"values", std::vector<double>(pairs.values.begin(), pairs.values.end())}};
  computed.isolines = 20;
  computed.shown = n > 1 ? 1 : 0; // the first is constant
  for (Eigen::Index k = 0; k < n; ++k)
    computed.functions.push_back({"eigenfunction_" + std::to_string(k), pairs.vectors.col(k)});
  return computed;
}

} // namespace

void run_eigen(const Options& options) {
  run_application(options, [&](const auto& t, const Sources&, const Points&, Progress&) {
    return eigenfunctions(IT::surface_modes(t, options.application.count,
                                            IT::solver_named(options.application.solver)));
  });
}

} // namespace program
