// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_DESCRIBE_OPTIONS_H
#define INTRINSIC_DESCRIBE_OPTIONS_H

#include "support/command_line.h"

#include <string>
#include <vector>

// Texts about the program that are made from its options: `intrinsic --man`, and
// `intrinsic --completion bash` or `zsh`. The installation writes them to files.

namespace program {

/// An option, as these texts show it.
struct Described_option {
  std::vector<std::string> names;   ///< with their dashes; of a positional one its name
  std::string word;                 ///< what follows, such as FILE; empty: nothing
  std::vector<std::string> choices; ///< the words that may follow; empty: any
  std::string help;                 ///< what it does, and the options that it needs
  bool is_positional;
};

/// returns the options of a command, in the order of its help.
std::vector<Described_option> described_options(const CLI::App& command);
/// returns the commands of the program.
std::vector<const CLI::App*> described_commands(const CLI::App& app);

/// returns the page for `man`.
std::string manual_page(const CLI::App& app);
/// returns the script by which bash completes command lines.
std::string bash_completion(const CLI::App& app);
/// returns the same for zsh.
std::string zsh_completion(const CLI::App& app);

/// adds `--man` and `--completion`, which help does not list.
void add_descriptions(CLI::App& app);

} // namespace program

#endif // INTRINSIC_DESCRIBE_OPTIONS_H
