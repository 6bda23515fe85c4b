// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "refine.h"

#include <sstream>
#include <stdexcept>

namespace program {

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
  message.precision(10);
  message << "the total area was " << inaccuracy->area_before << " and is "
          << inaccuracy->area_after << "; nothing was written; use --arithmetic exact";
  throw std::runtime_error(message.str());
}

} // namespace program
