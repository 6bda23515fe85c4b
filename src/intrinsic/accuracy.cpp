// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "accuracy.h"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace program {

namespace IT = CGAL::Intrinsic_triangulations;

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
