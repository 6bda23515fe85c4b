// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUPPORT_INPUT_NAME_H
#define INTRINSIC_SUPPORT_INPUT_NAME_H

#include <string>

// What people read in place of the name of a file that they did not name.

namespace program {

/// What users see of a file with the contents of standard input.
inline const std::string standard_input_name = "standard input";

/// says that a file has the contents of standard input.
void call_standard_input(const std::string& path);
/// returns a text for users: with `standard_input_name` in place of the path of that file.
std::string with_input_named(std::string text);

} // namespace program

#endif // INTRINSIC_SUPPORT_INPUT_NAME_H
