// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_LEVELS_H
#define INTRINSIC_LEVELS_H

#include <string>
#include <vector>

namespace program {

/// returns what is wrong with levels on the command line, and the remedy; empty: nothing. A whole
/// number is how many levels there are, anything else a list separated by commas.
std::string levels_misuse(const std::string& text);

/// returns the levels that a text without misuse asks for: those of a list, or so many between two
/// values, evenly spaced.
std::vector<double> levels_of(const std::string& text, double least, double greatest);

} // namespace program

#endif // INTRINSIC_LEVELS_H
