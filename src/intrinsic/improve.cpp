// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "improve.h"

#include <array>
#include <cstdint>
#include <stdexcept>

namespace program {

IT::Improve_options asked_improvement(const Options& options, const std::vector<double>& sizes,
                                      Progress& progress) {
  IT::Improve_options asked;
  asked.flips = !options.no_flip;
  if (options.refines) {
    asked.refine = options.refinement;
    asked.refine->lengths = sizes;
  }
  if (options.is_adaptive) {
    asked.adapt = options.adaptive;
    asked.adapt->minimum_angle = options.refinement.minimum_angle;
  }
  asked.progress = [&progress](IT::Improve_step step, std::uint64_t count) {
    static constexpr std::array<std::array<const char*, 2>, 4> words{
        {{"flipping to Delaunay", " flips"},
         {"refining", " vertices inserted"},
         {"moving vertices", " iterations"},
         {"refining adaptively", " vertices"}}};
    const auto& [stage, counted] = words[static_cast<std::size_t>(step)];
    return progress.show(stage, count == 0 ? "" : std::to_string(count) + counted);
  };
  return asked;
}

void check_improvement(const IT::Improvement& done, const Options& options, Progress& progress) {
  if (done.flips.status == IT::Status::cap)
    throw std::runtime_error(options.input + ": flipping did not end after " +
                             std::to_string(done.flips.flips) +
                             " flips in double arithmetic; use --arithmetic exact");
  expect_accurate(done.inaccuracy, options);
  if (done.refined && done.refined->status == IT::Status::stalled)
    progress.warn(options.input + ": no vertex could be inserted for " +
                  std::to_string(done.refined->unsatisfied[2]) +
                  " faces that do not meet the criteria: rounding hides its place");
}

} // namespace program
