// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_LEVELS_H
#define INTRINSIC_LEVELS_H

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace program {

/// returns what is wrong with levels on the command line, and the remedy; empty: nothing. A whole
/// number is how many levels there are, anything else a list separated by commas.
std::string levels_misuse(const std::string& text);

/// returns how many levels a text asks for, or nothing if it is a list.
std::optional<std::size_t> number_of_levels(std::string_view text);
/// returns the levels of a list; those that are not finite numbers become NaN.
std::vector<double> listed_levels(std::string_view text);

} // namespace program

#endif // INTRINSIC_LEVELS_H
