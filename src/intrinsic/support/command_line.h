// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUPPORT_COMMAND_LINE_H
#define INTRINSIC_SUPPORT_COMMAND_LINE_H

#include "messages.h"

#include <CGAL/Intrinsic_triangulations/support/ranges.h>

#include <CLI/CLI.hpp>

#include <cstddef>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

// What the command lines of the programs share.

namespace program {

namespace IT = CGAL::Intrinsic_triangulations;

/// Longest word of a command line that messages repeat.
constexpr std::size_t longest_argument = 60;

/// What help calls the word after an option.
struct Type {
  const char* name; ///< such as FILE
};
/// The name of a file.
constexpr Type file_name{"FILE"};

/// A check that may also complete the word.
struct Completion {
  CLI::Validator check; ///< may change the word
  Type type;            ///< what help calls the word
};

/// Adds options to a command.
class Option_adder {
public:
  /// A check, what help calls the word, or an option without which this one may not be given.
  using How = std::variant<CLI::Validator, Completion, Type, CLI::Option*>;

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
      if (const auto* completion = std::get_if<Completion>(&h))
        option->transform(completion->check)->type_name(completion->type.name);
      if (const auto* type = std::get_if<Type>(&h)) option->type_name(type->name);
      if (const auto* needed = std::get_if<CLI::Option*>(&h)) option->needs(*needed);
    }
    return option;
  }

private:
  CLI::App& command_;
};

/// returns a check that a word is a number of a range.
inline CLI::Validator in_range(const IT::Number_range& range) {
  return CLI::Validator(
      [range](std::string& word) {
        double x = 0;
        const bool is_number = CLI::detail::lexical_cast(word, x);
        return is_number && range.contains(x) ? std::string()
                                              : word + ": give " + range.description();
      },
      "NUMBER");
}

/// returns a check that a word is a number of a range, or none: then it is the name of a file.
inline CLI::Validator in_range_or_name(const IT::Number_range& range) {
  return CLI::Validator(
      [range](std::string& word) {
        double x = 0;
        return CLI::detail::lexical_cast(word, x) ? in_range(range)(word) : std::string();
      },
      "NUMBER|FILE");
}

/// says in a help what is done without an option.
template <class Value>
std::string default_is(const Value& value) {
  std::ostringstream text;
  text << "default " << value;
  return text.str();
}

/// A word that an option may be, and what it means.
struct Word {
  std::string word;    ///< the word
  std::string meaning; ///< in a few words; empty: what the word says
};

/// The words that an option may be.
class Words {
public:
  /// \param usual the one that is chosen without the option; empty: none
  Words(std::vector<Word> words, std::string usual)
      : words_(std::move(words)), usual_(std::move(usual)) {}

  /// returns a check that a word is one of them.
  CLI::Validator check() const {
    std::vector<std::string> all;
    for (const Word& w : words_) all.push_back(w.word);
    return CLI::IsMember(all);
  }
  /// lists them in a help, such as "exact (certified, default) or double".
  std::string help() const {
    std::string text;
    for (const Word& w : words_) {
      text += (&w == &words_.front() ? "" : &w == &words_.back() ? " or " : ", ") + w.word;
      const bool is_usual = w.word == usual_;
      const std::string told = w.meaning + (!is_usual           ? ""
                                            : w.meaning.empty() ? "default"
                                                                : ", default");
      if (!told.empty()) text += " (" + told + ")";
    }
    return text;
  }

private:
  std::vector<Word> words_;
  std::string usual_;
};

} // namespace program

#endif // INTRINSIC_SUPPORT_COMMAND_LINE_H
