// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_BASE64_H
#define INTRINSIC_TRIANGULATIONS_TEST_BASE64_H

#include <gtest/gtest.h>

#include <string>

namespace base64 {

inline std::string decoded(const std::string& base64) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  EXPECT_EQ(base64.size() % 4, 0u);
  std::string result;
  unsigned bits = 0, count = 0;
  for (const char c : base64) {
    if (c == '=') break;
    EXPECT_NE(digits.find(c), std::string::npos);
    bits = (bits << 6) | static_cast<unsigned>(digits.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    result += static_cast<char>((bits >> count) & 255);
  }
  return result;
}

} // namespace base64

#endif // INTRINSIC_TRIANGULATIONS_TEST_BASE64_H
