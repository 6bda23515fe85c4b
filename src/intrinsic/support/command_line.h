// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUPPORT_COMMAND_LINE_H
#define INTRINSIC_SUPPORT_COMMAND_LINE_H

#include "messages.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>

// What the command lines of the programs share.

namespace program {

/// Longest word of a command line that messages repeat.
constexpr std::size_t longest_argument = 60;

/// returns a check that a number is in a range, which NaN is not.
inline CLI::Validator between(double least, double most) {
  return CLI::Validator(
      [=](std::string& word) {
        double x = 0;
        const bool is_number = CLI::detail::lexical_cast(word, x);
        if (is_number && x >= least && x <= most) return std::string();
        std::ostringstream message;
        message << word << ": give a number from " << least << " to " << most;
        return message.str();
      },
      "NUMBER");
}

/// returns a check that a number is positive and finite.
inline CLI::Validator positive() {
  return CLI::Validator(
      [](std::string& word) {
        double x = 0;
        const bool is_number = CLI::detail::lexical_cast(word, x);
        return is_number && x > 0 && std::isfinite(x) ? std::string()
                                                      : word + ": give a positive number";
      },
      "NUMBER");
}

} // namespace program

#endif // INTRINSIC_SUPPORT_COMMAND_LINE_H
