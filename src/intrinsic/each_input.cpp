// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "each_input.h"
#include "standard_input.h"
#include "summary.h"
#include "support/input_name.h"
#include "support/messages.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace program {

namespace {

const std::string place_of_name = "{}";
const std::string standard_input = "-";

std::string name_of(const std::string& input) {
  return std::filesystem::path(input).stem().string();
}

std::string with_name(std::string word, const std::string& input) {
  const std::string name = name_of(input);
  for (std::size_t i = 0; (i = word.find(place_of_name, i)) != std::string::npos; i += name.size())
    word.replace(i, place_of_name.size(), name);
  return word;
}

// The command line of the run for one input.
// \param is_standard_input whether the file has the contents of standard input
std::vector<std::string> arguments_for(const CLI::App& command, const std::string& input,
                                       bool is_standard_input) {
  std::vector<std::string> arguments{command.get_name(),
                                     input.starts_with('-') ? "./" + input : input};
  if (is_standard_input) arguments.emplace_back("--standard-input");
  for (const CLI::Option* const o : command.get_options())
    if (o->get_positional() && o->get_name() != "IN")
      for (const std::string& word : o->results()) arguments.push_back(with_name(word, input));
  for (const CLI::Option* const o : command.get_options()) {
    if (o->count() == 0 || o->get_positional() || o->get_name() == "--input-format") continue;
    const bool is_flag = o->get_items_expected_max() == 0;
    if (is_flag) arguments.push_back(o->get_name());
    for (const std::string& word : o->results())
      if (!is_flag) arguments.insert(arguments.end(), {o->get_name(), with_name(word, input)});
  }
  return arguments;
}

// Returns the exit code of a run, as a shell does.
int code_of(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0)
    if (errno != EINTR) return failed;
  constexpr int killed = 128;
  return WIFSIGNALED(status) ? killed + WTERMSIG(status) : WEXITSTATUS(status);
}

int in_a_process(const std::function<int()>& run) {
  std::cout.flush();
  const pid_t process = fork();
  if (process < 0) throw std::runtime_error("no process can be started; end some others");
  if (process > 0) return code_of(process);
  prctl(PR_SET_PDEATHSIG, SIGTERM); // it ends with this program
  const int code = run();
  std::cout.flush();
  std::_Exit(code); // what this process has in common with the other one is not its own to remove
}

} // namespace

std::string shared_file_misuse(const Options& options) {
  if (options.inputs.size() == 1) return {};
  const std::vector<Output> files = outputs(options);
  for (const Output& output : files) {
    if (output.path == options.output && is_standard_output(output.path))
      return std::to_string(options.inputs.size()) +
             " inputs cannot share standard output; write files, such as -o {}" +
             output.path.substr(1);
    if (is_standard_output(output.path) || output.path.find(place_of_name) != std::string::npos)
      continue;
    const std::filesystem::path path(output.path);
    return output.path + ": " + std::to_string(options.inputs.size()) +
           " inputs cannot share one file; write {} where the name of each goes, such as " +
           (path.parent_path() / ("{}-" + path.filename().string())).string();
  }
  if (std::ranges::all_of(files, [](const Output& f) { return is_standard_output(f.path); }))
    return {};
  std::set<std::string> names;
  for (const std::string& input : options.inputs)
    if (!names.insert(name_of(input)).second)
      return input + ": another input has the name " + name_of(input) +
             ", too, so that files of results would be the same; run them one by one";
  return {};
}

bool stands_for_others(const Options& options) {
  const auto has_place = [](const std::string& word) {
    return word.find(place_of_name) != std::string::npos;
  };
  return !options.inputs.empty() && // the study has none
         (options.inputs.size() > 1 || options.input == standard_input ||
          std::ranges::any_of(options.arguments, has_place));
}

int run_each_input(const CLI::App& command, const Options& options,
                   const std::function<int(const std::vector<std::string>&)>& run) {
  std::optional<Standard_input> standard;
  int worst = 0;
  for (const std::string& input : options.inputs) {
    if (options.inputs.size() > 1 && !options.is_quiet)
      answer_stream(options) << (&input == &options.inputs.front() ? "" : "\n")
                             << legible(input == standard_input ? standard_input_name : input)
                             << ":\n";
    if (input == standard_input && !standard) standard.emplace(options.input_format);
    const bool is_standard = input == standard_input;
    const std::vector<std::string> arguments =
        arguments_for(command, is_standard ? standard->path() : input, is_standard);
    worst = std::max(worst, in_a_process([&] { return run(arguments); }));
  }
  return worst;
}

} // namespace program
