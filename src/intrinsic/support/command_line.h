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
#include <type_traits>
#include <variant>
#include <vector>

// What the command lines of the programs share.

namespace program {

/// Longest word of a command line that messages repeat.
constexpr std::size_t longest_argument = 60;

/// What help calls the word after an option.
struct Type {
  const char* name; ///< such as FILE
};
/// The name of a file.
constexpr Type file_name{"FILE"};

/// Adds options to a command.
class Option_adder {
public:
  /// A check, what help calls the word, or an option without which this one may not be given.
  using How = std::variant<CLI::Validator, Type, CLI::Option*>;

  /// \param command gets them
  explicit Option_adder(CLI::App& command) : command_(command) {}
  /// adds an option, or a flag if its target is a `bool`.
  template <class Target>
  CLI::Option* operator()(const std::string& name, Target& target, const std::string& help) const {
    if constexpr (std::is_same_v<Target, bool>)
      return command_.add_flag(name, target, help);
    else
      return command_.add_option(name, target, help);
  }
  /// adds one with checks and more.
  template <class Target>
  CLI::Option* operator()(const std::string& name, Target& target, const std::vector<How>& how,
                          const std::string& help) const {
    CLI::Option* const option = (*this)(name, target, help);
    for (const How& h : how) {
      if (const auto* check = std::get_if<CLI::Validator>(&h)) option->check(*check);
      if (const auto* type = std::get_if<Type>(&h)) option->type_name(type->name);
      if (const auto* needed = std::get_if<CLI::Option*>(&h)) option->needs(*needed);
    }
    return option;
  }

private:
  CLI::App& command_;
};

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

/// returns a check that a word is a positive number, or none: then it is the name of a file.
inline CLI::Validator positive_or_name() {
  return CLI::Validator(
      [](std::string& word) {
        double x = 0;
        return CLI::detail::lexical_cast(word, x) ? positive()(word) : std::string();
      },
      "NUMBER|FILE");
}

} // namespace program

#endif // INTRINSIC_SUPPORT_COMMAND_LINE_H
