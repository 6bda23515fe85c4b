// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUPPORT_MESSAGES_H
#define INTRINSIC_SUPPORT_MESSAGES_H

#include <cstddef>
#include <string>

// How the programs end, and what they say.

namespace program {

/// Exit code of valid usage that failed.
constexpr int failed = 1;
/// Exit code of usage that is not valid.
constexpr int misused = 2;

/// returns a text to be shown: what cannot be printed as ?, words no longer than a file name may be, or fewer characters.
inline std::string legible(const std::string& text, std::size_t longest_word = 255) {
  std::string result;
  std::size_t length = 0;
  for (const char c : text) {
    const bool is_control = static_cast<unsigned char>(c) < ' ' || c == '\x7f';
    length = c == ' ' || c == '\n' ? 0 : length + 1;
    if (length == longest_word + 1) result += "...";
    if (length <= longest_word) result += is_control && c != '\n' ? '?' : c;
  }
  return result;
}

} // namespace program

#endif // INTRINSIC_SUPPORT_MESSAGES_H
