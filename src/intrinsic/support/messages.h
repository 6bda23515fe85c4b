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

/// returns a text as UTF-8: bytes that are none as `\xE9`, with their hexadecimal digits.
inline std::string as_utf8(const std::string& text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const unsigned first = byte(i), second = byte(i + 1);
    const std::size_t length = first < 0x80   ? 1
                               : first < 0xC2 ? 0
                               : first < 0xE0 ? 2
                               : first < 0xF0 ? 3
                               : first < 0xF5 ? 4
                                              : 0;
    bool is_whole = length > 0;
    for (std::size_t k = 1; k < length; ++k) is_whole = is_whole && byte(i + k) >> 6 == 2;
    // neither longer than necessary, nor half a pair, nor beyond the last character
    if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
        (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F))
      is_whole = false;
    if (is_whole)
      result.append(text, i, length);
    else
      (result += "\\x").append({"0123456789ABCDEF"[first >> 4], "0123456789ABCDEF"[first & 15]});
    i += is_whole ? length : 1;
  }
  return result;
}

/// returns a text to be shown: `?` in place of what cannot be printed, and words shortened to the
/// length of a file name, or to fewer characters.
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
