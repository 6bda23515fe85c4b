// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_TEXT_WRITER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_TEXT_WRITER_H

#include <CGAL/Interval_nt.h>

#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <ostream>
#include <string_view>

namespace CGAL::Intrinsic_triangulations::internal {

// Writes lines of words and numbers in blocks, whatever the locale. Floating point numbers are
// hexadecimal, as C's %a writes them, so that nothing is rounded.
class Text_writer {
public:
  explicit Text_writer(std::ostream& out) : out_(out) {}

  template <class... Values>
  void words(const Values&... values) {
    (put(values), ...);
  }

  template <class... Values>
  void line(const Values&... values) {
    words(values...);
    append('\n');
    at_start_ = true;
  }

  void flush() {
    out_.write(buffer_, static_cast<std::streamsize>(used_));
    used_ = 0;
  }

private:
  // longest word: "-0x1." 13 digits "p-1022"
  static constexpr std::size_t longest_number = 32;

  void put(std::string_view word) {
    start_word(word.size());
    for (const char c : word) append(c);
  }
  template <std::integral Integer>
  void put(Integer i) {
    start_word(longest_number);
    used_ = static_cast<std::size_t>(
        std::to_chars(buffer_ + used_, buffer_ + sizeof(buffer_), i).ptr - buffer_);
  }
  void put(double x) {
    start_word(longest_number);
    if (std::signbit(x)) append('-');
    if (std::isfinite(x)) {
      append('0');
      append('x');
    }
    used_ = static_cast<std::size_t>(std::to_chars(buffer_ + used_, buffer_ + sizeof(buffer_),
                                                   std::abs(x), std::chars_format::hex)
                                         .ptr -
                                     buffer_);
  }
  void put(const Interval_nt<false>& x) {
    put(x.inf());
    put(x.sup());
  }

  void start_word(std::size_t length) {
    if (used_ + length + 2 > sizeof(buffer_)) flush();
    if (!at_start_) append(' ');
    at_start_ = false;
  }
  void append(char c) {
    if (used_ == sizeof(buffer_)) flush();
    buffer_[used_++] = c;
  }

  std::ostream& out_;
  std::size_t used_ = 0;
  bool at_start_ = true;
  char buffer_[1 << 16];
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_TEXT_WRITER_H
