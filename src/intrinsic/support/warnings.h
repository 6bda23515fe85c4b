// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUPPORT_WARNINGS_H
#define INTRINSIC_SUPPORT_WARNINGS_H

#include <string>
#include <vector>

namespace program {

/// notes what a result lacks, to be said after the answer.
void warn(const std::string& message);
/// returns all that was noted since the last call.
std::vector<std::string> take_warnings();

} // namespace program

#endif // INTRINSIC_SUPPORT_WARNINGS_H
