// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "describe_options.h"
#include "each_input.h"
#include "option_groups.h"
#include "options.h"
#include "output_files.h"
#include "support/command_line.h"
#include "support/input_name.h"
#include "support/nearest_word.h"
#include "time_limit.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <exception>
#include <iostream>
#include <map>
#include <new>
#include <string>
#include <vector>

namespace {

using program::Command;
using program::Options;

// The names of all commands.
std::vector<std::string> names_of_commands() {
  std::vector<std::string> names;
  for (const Command& c : program::commands()) names.emplace_back(c.name);
  return names;
}

// "; --mass is an option of refine and laplacian" if a few commands have an option of that name.
std::string option_of_commands(const CLI::App& app, const std::string& word) {
  std::vector<std::string> having;
  for (const CLI::App* command : program::described_commands(app))
    if (command->get_option_no_throw("--" + word) != nullptr) having.push_back(command->get_name());
  constexpr std::size_t few = 4;
  if (having.empty() || having.size() > few) return {};
  std::string text = "; --" + word + " is an option of ";
  for (const std::string& name : having) text += (&name == &having.front() ? "" : ", ") + name;
  return text;
}

std::string unknown_command(const CLI::App& app, const std::string& word) {
  const std::vector<std::string> names = names_of_commands();
  const std::string nearest = program::nearest_word(word, names);
  const std::string unknown =
      "there is no command \"" + program::legible(word, program::longest_argument) + '"';
  if (const std::string option = option_of_commands(app, word); !option.empty())
    return unknown + option;
  std::string listed;
  for (const std::string& name : names)
    listed += (listed.empty() ? "" : name == names.back() ? " or " : ", ") + name;
  return unknown + "; " +
         (nearest.empty() ? "use " + listed + ", or --help" : "did you mean " + nearest + "?");
}

std::string without_dashes(const std::string& name) {
  return name.substr(std::min(name.find_first_not_of('-'), name.size()));
}

// The option or argument here for which other programs have a certain name; empty if there is none.
std::string own_name_of(const std::string& word) {
  static const std::map<std::string, std::string> own_names = {
      {"output", "-o"}, {"out", "-o"},       {"write", "-o"}, {"save", "-o"},
      {"file", "-o"},   {"json", "--stats"}, {"mesh", "IN"}};
  const auto own = own_names.find(word);
  return own == own_names.end() ? "" : own->second;
}

// The option of a name; null if there is none.
const program::Described_option*
option_of_name(const std::string& name, const std::vector<program::Described_option>& options) {
  for (const program::Described_option& option : options)
    if (std::ranges::count(option.names, name) > 0) return &option;
  return nullptr;
}

// Whether a text has a word that is not part of a longer one, or of the name of an option.
bool has_whole_word(const std::string& text, const std::string& word) {
  const auto is_within = [&](std::size_t i) {
    return i < text.size() &&
           (text[i] == '-' || std::isalnum(static_cast<unsigned char>(text[i])) != 0);
  };
  for (std::size_t i = text.find(word); i != std::string::npos; i = text.find(word, i + 1))
    if ((i == 0 || !is_within(i - 1)) && !is_within(i + word.size())) return true;
  return false;
}

// The only option whose help has a word; null if there are none or several.
const program::Described_option*
option_with_help(const std::string& word, const std::vector<program::Described_option>& options) {
  constexpr std::size_t longer_than_articles = 4;
  if (word.size() < longer_than_articles) return nullptr;
  const program::Described_option* found = nullptr;
  for (const program::Described_option& option : options) {
    if (option.is_positional || !has_whole_word(CLI::detail::to_lower(option.help), word)) continue;
    if (found != nullptr) return nullptr;
    found = &option;
  }
  return found;
}

// What was meant by the name of an option: what other programs mean by it, or the nearest one, or
// the only one whose help has the word.
std::string meant_by(const std::string& name,
                     const std::vector<program::Described_option>& options) {
  const std::string word = CLI::detail::to_lower(without_dashes(name));
  const std::string own_name = own_name_of(word);
  if (own_name.empty()) {
    std::vector<std::string> names, words;
    for (const program::Described_option& option : options)
      for (const std::string& n : option.names) {
        names.push_back(n);
        words.push_back(without_dashes(n));
      }
    const std::string nearest = program::nearest_word(word, words);
    if (!nearest.empty())
      return names[static_cast<std::size_t>(std::ranges::find(words, nearest) - words.begin())];
  }
  const program::Described_option* const meant =
      own_name.empty() ? option_with_help(word, options) : option_of_name(own_name, options);
  return meant == nullptr ? "" : meant->names.front() + ": " + meant->help;
}

// What to say of the first option that a command does not have; empty if it has all.
std::string unknown_option(const CLI::App& command, const std::vector<std::string>& arguments) {
  const std::vector<program::Described_option> options = program::described_options(command);
  std::vector<std::string> names;
  for (const program::Described_option& option : options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  for (const std::string& argument : arguments) {
    const std::string name = argument.substr(0, argument.find('='));
    const bool may_be_option = name.size() > 2 && name.front() == '-' &&
                               std::isdigit(static_cast<unsigned char>(name[1])) == 0;
    if (!may_be_option || std::ranges::count(names, name) > 0) continue;
    const std::string meant = meant_by(name, options);
    return command.get_name() + " has no option " +
           program::legible(name, program::longest_argument) + "; " +
           (meant.empty() ? "intrinsic " + command.get_name() + " --help lists all"
                          : "did you mean " + meant + "?");
  }
  return {};
}

// Reports what is wrong with the command line, or prints the help; returns the exit code.
int report_parse_error(const CLI::App& app, const CLI::ParseError& e,
                       const std::vector<std::string>& arguments) {
  if (arguments.empty()) { // a first look at the program
    std::cerr << app.help();
    return program::misused;
  }
  const std::vector<CLI::App*> commands = app.get_subcommands();
  std::string message;
  if (e.get_name() == "RequiredError" && commands.empty())
    message = unknown_command(app, arguments.front());
  if (dynamic_cast<const CLI::ExtrasError*>(&e) != nullptr && !commands.empty())
    message = unknown_option(*commands.front(), arguments);
  if (message.empty()) return app.exit(e) == 0 ? 0 : program::misused;
  std::cerr << "intrinsic: " << message << '\n';
  return program::misused;
}

void add_commands(CLI::App& app, Options& options) {
  app.set_version_flag("--version", std::string("intrinsic ") + INTRINSIC_TRIANGULATIONS_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(32);
  app.failure_message([](const CLI::App* a, const CLI::Error& e) {
    return program::legible(CLI::FailureMessage::simple(a, e), program::longest_argument);
  });
  program::add_descriptions(app);
  for (const Command& c : program::commands()) {
    CLI::App& command = *app.add_subcommand(c.name, c.help);
    for (const program::Option_group add : c.options) add(command, options);
    program::make_refinement_options_need_refine(command);
  }
}

int run_with_errors_reported(const std::vector<std::string>& arguments, bool is_for_one);

int run_for_one(const std::vector<std::string>& arguments) {
  return run_with_errors_reported(arguments, true);
}

// `help` and `help COMMAND`, as other programs have them, are `--help`. An unknown command is left
// alone, so that it is reported.
std::vector<std::string> with_help(std::vector<std::string> arguments) {
  if (arguments.empty() || arguments.size() > 2 || arguments.front() != "help") return arguments;
  arguments.erase(arguments.begin());
  std::vector<std::string> known = names_of_commands();
  known.emplace_back("help");
  if (arguments.empty() || std::ranges::count(known, arguments.front()) > 0)
    arguments.emplace_back("--help");
  return arguments;
}

// \param is_for_one whether the command line is that of a run for one of several inputs
int run(const std::vector<std::string>& arguments, bool is_for_one) {
  Options options;
  options.arguments = arguments;
  CLI::App app("Intrinsic triangulations of triangle meshes, with exact predicates", "intrinsic");
  add_commands(app, options);
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::ParseError& e) {
    return report_parse_error(app, e, arguments);
  }
  const Command& chosen = *std::ranges::find_if(
      program::commands(), [&](const Command& c) { return app.got_subcommand(c.name); });
  options.command = chosen.name;
  if (!options.inputs.empty()) options.input = options.inputs.front(); // the study has none
  if (options.is_standard_input) program::call_standard_input(options.input);
  std::string misuse = program::misuse(options);
  if (misuse.empty() && chosen.misuse != nullptr) misuse = chosen.misuse(options);
  if (misuse.empty()) misuse = program::shared_file_misuse(options);
  if (!misuse.empty()) {
    std::cerr << "intrinsic: " << program::legible(program::with_input_named(misuse)) << '\n';
    return program::misused;
  }
  if (!is_for_one && program::stands_for_others(options))
    return program::run_each_input(*app.get_subcommands().front(), options, run_for_one);
  if (options.time_limit) program::end_at_time_limit(options);
  chosen.run(options);
  return 0;
}

int run_with_errors_reported(const std::vector<std::string>& arguments, bool is_for_one) {
  try {
    return run(arguments, is_for_one);
  } catch (const std::bad_alloc&) {
    std::cerr << "intrinsic: there is not enough memory; use a machine with more, or a smaller "
                 "mesh\n";
  } catch (const std::exception& e) {
    std::cerr << "intrinsic: " << program::legible(program::with_input_named(e.what())) << '\n';
  }
  return program::failed;
}

} // namespace

int main(int argc, char** argv) {
  program::remove_incomplete_files_on_signals();
  return run_with_errors_reported(with_help(std::vector<std::string>(argv + 1, argv + argc)),
                                  false);
}
