// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_REFUSALS_H
#define INTRINSIC_TRIANGULATIONS_TEST_REFUSALS_H

#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace refusals {

namespace IT = CGAL::Intrinsic_triangulations;

/// Expects `Invalid_input` with an element of this kind, the index if one is given, and all texts
/// in its message.
inline void expect_invalid(const std::function<void()>& make, IT::Element_kind kind,
                           std::optional<std::size_t> index = {},
                           const std::vector<std::string>& texts = {}) {
  try {
    make();
    ADD_FAILURE() << "not refused: " << ::testing::PrintToString(texts);
  } catch (const IT::Invalid_input& e) {
    EXPECT_EQ(e.kind(), kind) << e.what();
    EXPECT_EQ(e.index(), index.value_or(e.index())) << e.what();
    for (const std::string& text : texts)
      EXPECT_NE(std::string(e.what()).find(text), std::string::npos)
          << e.what() << "\nlacks: " << text;
  }
}

/// The message with which something is refused, or nothing.
inline std::string refusal(const std::function<void()>& make) {
  try {
    make();
    return {};
  } catch (const IT::Invalid_input& e) {
    return e.what();
  }
}

/// Expects that something is refused with a text in the message.
inline void expect_refusal(const std::function<void()>& make, const std::string& text) {
  const std::string message = refusal(make);
  EXPECT_NE(message.find(text), std::string::npos)
      << (message.empty() ? "not refused: " + text : message);
}

} // namespace refusals

#endif // INTRINSIC_TRIANGULATIONS_TEST_REFUSALS_H
