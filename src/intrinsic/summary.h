// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUMMARY_H
#define INTRINSIC_SUMMARY_H

#include "options.h"
#include "support/Json.h"

#include <ostream>
#include <string>
#include <vector>

// What a command says when it is done: first its answer, then its files, then its warnings.

namespace program {

/// returns where the answer goes: to standard output, or to standard error if a result goes there.
std::ostream& answer_stream(const Options& options);

/*!
\brief prints the answer of a command and which files it has written, unless options want quiet.
\param json the statistics
\param options the options
\param written the paths of the files
\throws std::runtime_error if standard output cannot be written
*/
void print_answer(const Json& json, const Options& options,
                  const std::vector<std::string>& written);

/// prints the warnings that were noted to standard error, unless options want quiet.
void print_warnings(const Options& options);

} // namespace program

#endif // INTRINSIC_SUMMARY_H
