// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "describe_options.h"

#include <cstddef>
#include <iostream>
#include <set>
#include <string>
#include <vector>

namespace program {

namespace {

// Sets the word or the choices that follow an option, from what help shows, such as `TEXT:FILE`,
// `TEXT:{exact,double}`, `SECONDS:NUMBER` or `UINT:UINT in [1 - 12]`.
void describe_word(const CLI::Option& option, Described_option& described) {
  if (option.get_items_expected_max() == 0) return; // a flag
  const std::string type = option.get_type_name();
  const std::size_t colon = type.find(':');
  std::string word = type.substr(0, colon);
  const bool is_general = word == "TEXT" || word == "FLOAT" || word == "INT" || word == "UINT";
  if (is_general && colon != std::string::npos) word = type.substr(colon + 1);
  if (word.starts_with('{')) {
    described.choices = CLI::detail::split(word.substr(1, word.size() - 2), ',');
    word = "WORD";
  }
  const bool is_number = word == "FLOAT" || word == "UINT" || word == "INT" || word == "POSITIVE" ||
                         word == "NONNEGATIVE" || word.find(" in ") != std::string::npos;
  described.word = is_number ? "NUMBER" : word;
}

std::string help_of(const CLI::Option& option) {
  std::set<std::string> names; // in an order that does not depend on addresses
  for (const CLI::Option* other : option.get_needs()) names.insert(other->get_name());
  std::string needed;
  for (const std::string& name : names) needed += (needed.empty() ? " (needs " : " and ") + name;
  return option.get_description() + (needed.empty() ? "" : needed + ")");
}

} // namespace

std::vector<Described_option> described_options(const CLI::App& command) {
  std::vector<Described_option> result;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty()) continue; // hidden
    Described_option described{{}, {}, {}, help_of(*option), option->get_positional()};
    if (described.is_positional) described.names = {option->get_name(true)};
    for (const std::string& name : option->get_snames()) described.names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) described.names.push_back("--" + name);
    describe_word(*option, described);
    result.push_back(described);
  }
  return result;
}

std::vector<const CLI::App*> described_commands(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

void add_descriptions(CLI::App& app) {
  const std::string hidden;
  app.add_flag_callback("--man",
                        [&app] {
                          std::cout << manual_page(app);
                          throw CLI::Success();
                        })
      ->group(hidden);
  app.add_option_function<std::string>("--completion",
                                       [&app](const std::string& shell) {
                                         std::cout << (shell == "bash" ? bash_completion(app)
                                                                       : zsh_completion(app));
                                         throw CLI::Success();
                                       })
      ->check(CLI::IsMember({"bash", "zsh"}))
      ->group(hidden);
}

} // namespace program
