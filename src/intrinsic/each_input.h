// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_EACH_INPUT_H
#define INTRINSIC_EACH_INPUT_H

#include "options.h"
#include "support/command_line.h"

#include <functional>
#include <string>
#include <vector>

// One command for several inputs, and for standard input.

namespace program {

/// returns which files several inputs would share, and the remedy; empty: none.
std::string shared_file_misuse(const Options& options);
/// tells whether a command line stands for runs of other ones, see `run_each_input()`.
bool stands_for_others(const Options& options);

/*!
\brief runs a command for each of its inputs, one after another, each in a process of its own: what
ends one of them does not end the others.

In each of these runs, `{}` in the words of options is the name of the input without its folder and
its extension, and `-` is a file that has what came from standard input.
\param command the command as it was parsed
\param options its options
\param run runs a command line, and returns an exit code
\return the greatest exit code
\pre `shared_file_misuse()` is empty
*/
int run_each_input(const CLI::App& command, const Options& options,
                   const std::function<int(const std::vector<std::string>&)>& run);

} // namespace program

#endif // INTRINSIC_EACH_INPUT_H
