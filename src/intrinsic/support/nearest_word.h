// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUPPORT_NEAREST_WORD_H
#define INTRINSIC_SUPPORT_NEAREST_WORD_H

#include <string>
#include <vector>

namespace program {

/// returns the word that someone may have meant by another one: that from which it differs in the
/// fewest letters, if these are at most a third of it; else one that begins with two thirds of it;
/// else an empty one.
std::string nearest_word(const std::string& word, const std::vector<std::string>& words);

} // namespace program

#endif // INTRINSIC_SUPPORT_NEAREST_WORD_H
