// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUPPORT_COMMAND_LINE_H
#define INTRINSIC_SUPPORT_COMMAND_LINE_H

#include <CLI/CLI.hpp>

#include <filesystem>
#include <limits>
#include <string>

// What the command lines of the programs share.

namespace program {

/// Exit code of valid usage that failed.
constexpr int failed = 1;
/// Exit code of usage that is not valid.
constexpr int misused = 2;

/// returns a check of the extension of a file, which is all that can be written of `what`.
inline CLI::Validator extension(const std::string& wanted, const std::string& what) {
  return CLI::Validator(
      [=](std::string& path) {
        return std::filesystem::path(path).extension() == wanted
                   ? std::string()
                   : path + ": this version writes " + what + ", to a file with extension " +
                         wanted + " only";
      },
      "FILE" + wanted);
}

/// returns a check that a number is in a range, which NaN is not.
inline CLI::Validator between(double least, double most) {
  return CLI::Validator(
      [=](std::string& word) {
        double x = 0;
        const bool is_number = CLI::detail::lexical_cast(word, x);
        if (is_number && x >= least && x <= most) return std::string();
        return word + ": give a number from " + CLI::detail::to_string(least) + " to " +
               CLI::detail::to_string(most);
      },
      "NUMBER");
}

/// returns a check that a number is positive and finite.
inline CLI::Validator positive() {
  return between(std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max());
}

} // namespace program

#endif // INTRINSIC_SUPPORT_COMMAND_LINE_H
