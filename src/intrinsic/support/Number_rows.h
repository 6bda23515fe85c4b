// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUPPORT_NUMBER_ROWS_H
#define INTRINSIC_SUPPORT_NUMBER_ROWS_H

#include <array>
#include <charconv>
#include <ostream>

namespace program {

/// Writes rows of numbers as text, separated by spaces, with the fewest digits that read back as
/// the same double.
class Number_rows {
public:
  explicit Number_rows(std::ostream& out) : out_(out) {}

  void put(double x) {
    const char* const end = std::to_chars(digits_.data(), digits_.data() + digits_.size(), x).ptr;
    (out_ << separator_).write(digits_.data(), end - digits_.data());
    separator_ = " ";
  }
  void end_row() {
    out_ << '\n';
    separator_ = "";
  }

private:
  std::ostream& out_;
  std::array<char, 32> digits_{};
  const char* separator_ = "";
};

} // namespace program

#endif // INTRINSIC_SUPPORT_NUMBER_ROWS_H
