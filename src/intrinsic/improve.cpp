// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "improve.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

namespace program {

namespace {

// Refuses a triangulation that rounding has spoilt.
void expect_accurate(const std::optional<IT::Inaccuracy>& inaccuracy, const Options& options) {
  if (!inaccuracy) return;
  const std::string face = "face " + std::to_string(inaccuracy->face);
  std::ostringstream message;
  message << options.input << ": rounding has spoilt the triangulation: ";
  switch (inaccuracy->kind) {
  case IT::Inaccuracy::Kind::face:
    message << face << " has no positive area or length; ";
    break;
  case IT::Inaccuracy::Kind::shape:
    message << "the sides of " << face << " do not span its area; ";
    break;
  case IT::Inaccuracy::Kind::total_area:
    message << "area was lost or made, most likely at " << face << "; ";
    break;
  case IT::Inaccuracy::Kind::topology:
    message << "the Euler characteristic has changed; ";
    break;
  }
  if (const double before = inaccuracy->area_before, after = inaccuracy->area_after;
      !(std::abs(after - before) <= 1e-9 * before)) {
    message.precision(10);
    message << "the total area was " << before << " and is " << after << "; ";
  }
  message << "nothing was written; use --arithmetic exact";
  throw std::runtime_error(message.str());
}

} // namespace

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

void expect_area_kept(double before, double after, const Options& options) {
  if (std::abs(after - before) <= 1e-6 * before) return; // false for what is not a number
  std::ostringstream message;
  message.precision(10);
  message << options.input << ": rounding has spoilt the triangulation: the total area was "
          << before << " and is " << after << "; nothing was written; use --arithmetic exact";
  throw std::runtime_error(message.str());
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
