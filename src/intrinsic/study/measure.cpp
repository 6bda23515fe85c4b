// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "measure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace program {

void note_flips(Json& findings, double build, double flip,
                const IT::Flip_to_delaunay_result& result) {
  findings["seconds"] = {{"build", build}, {"flip", flip}};
  findings["status"] = result.status == IT::Status::done ? "done" : "cap";
  findings["flips"] = result.flips;
  findings["checks"] = result.checks;
  findings["refused_flips"] = result.refused_flips;
}

void note_drift(Study_run& run, const Conserved& after) {
  const long double area = run.before.quadruple_area;
  run.findings["area_drift"] =
      static_cast<double>(std::abs(after.quadruple_area - area) / (area > 0 ? area : 1));
  long double largest = 0;
  for (std::size_t v = 0; v < after.cone_angles.size(); ++v)
    largest = std::max(largest, std::abs(after.cone_angles[v] - run.before.cone_angles[v]));
  run.findings["cone_angle_drift"] = static_cast<double>(largest);
  run.emit();
}

void note_result(Json& findings, const IT::Delaunay_certificate& certificate) {
  findings["inverted_faces"] = certificate.inverted_faces;
  findings["bent_edges"] = certificate.bent_edges;
  findings["non_delaunay_edges"] = certificate.non_delaunay_edges;
  findings["cocircular_edges"] = certificate.ties;
}

void note_comparison(Study_run& run, const Comparison& found) {
  run.findings["different_decisions"] = found.different_decisions;
  run.findings["nonconvex_flips"] = found.nonconvex_flips;
  run.findings["cycles"] = found.cycles;
  run.findings["comparison"] = found.is_complete ? "complete" : "until_nonconvex_flip";
  run.emit();
}

} // namespace program
