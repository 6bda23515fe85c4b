// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "improve.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>

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

void expect_covered(double input_area, double area, const Options& options) {
  if (std::abs(area - input_area) <= 1e-6 * input_area) return;
  std::ostringstream message;
  message.precision(10);
  message << options.input << ": rounding has spoilt the common subdivision: its area is " << area
          << ", that of the input " << input_area
          << "; nothing was written; use --arithmetic exact";
  throw std::runtime_error(message.str());
}

} // namespace program
