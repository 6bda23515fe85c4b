// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_ANSWERS_H
#define INTRINSIC_ANSWERS_H

#include "options.h"
#include "support/Figures.h"

#include <string>
#include <string_view>
#include <vector>

// What commands say on the terminal, as tables.

namespace program {

/// A line of an answer. It is left out if a figure in its text is missing.
struct Answer_line {
  std::string_view title; ///< in the first column
  std::string_view text;  ///< see `Figures::fill()`
  /// Tells whether the line is shown; none: it is.
  bool (*is_shown)(const Figures&) = nullptr;
};

/// returns the lines of the answer of a command.
const std::vector<Answer_line>& answer_of(const std::string& command);
/// returns the lines that describe a surface and its triangulation: the answer of `info`.
const std::vector<Answer_line>& lines_of_surface();

/// returns what a result lacks, in sentences that name the remedy.
std::vector<std::string> warnings_of(const Figures& figures, const Options& options);

} // namespace program

#endif // INTRINSIC_ANSWERS_H
