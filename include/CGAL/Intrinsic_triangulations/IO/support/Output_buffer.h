// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_OUTPUT_BUFFER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_OUTPUT_BUFFER_H

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <ostream>
#include <string_view>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

template <class T>
concept Arithmetic = std::is_arithmetic_v<T>;

// Writes text and binary data in blocks, whatever the locale and the byte order of the machine. Numbers are
// decimal, the shortest that read back as the same; those with a point hexadecimal if that is asked for, as
// C's %a writes them.
template <bool hexadecimal>
class Basic_output_buffer {
public:
  explicit Basic_output_buffer(std::ostream& out) : out_(out) {}

  // Writes values without anything between them.
  template <class... Values>
  void text(const Values&... values) {
    (put(values), ...);
  }
  // Writes values with a space between them and what is on the line already.
  template <class... Values>
  void words(const Values&... values) {
    (put_word(values), ...);
  }
  // Writes the last values of a line.
  template <class... Values>
  void line(const Values&... values) {
    words(values...);
    put('\n');
    at_start_ = true;
  }

  // Writes a number as it is in memory, its least significant byte first.
  template <Arithmetic T>
  void binary(T value) {
    reserve(sizeof(T));
    std::memcpy(buffer_ + used_, &value, sizeof(T));
    if constexpr (std::endian::native == std::endian::big)
      std::reverse(buffer_ + used_, buffer_ + used_ + sizeof(T));
    used_ += sizeof(T);
  }

  // Writes what is left; false if the stream has failed.
  bool flush() {
    write();
    return static_cast<bool>(out_.flush());
  }

private:
  static constexpr std::size_t longest_number =
      32; // "-1.2345678901234567e-308", "-0x1." 13 digits "p-1022"

  void put(std::string_view word) {
    for (std::size_t done = 0; done < word.size();) {
      reserve(1);
      const std::size_t n = std::min(word.size() - done, sizeof(buffer_) - used_);
      std::memcpy(buffer_ + used_, word.data() + done, n);
      used_ += n;
      done += n;
    }
  }
  void put(char c) {
    reserve(1);
    buffer_[used_++] = c;
  }
  template <Arithmetic T>
  void put(T number) {
    reserve(longest_number);
    const auto write_digits = [this](const auto&... number_and_format) {
      used_ = static_cast<std::size_t>(
          std::to_chars(buffer_ + used_, buffer_ + sizeof(buffer_), number_and_format...).ptr -
          buffer_);
    };
    if constexpr (hexadecimal && std::is_floating_point_v<T>) {
      text(std::signbit(number) ? "-" : "", std::isfinite(number) ? "0x" : "");
      write_digits(std::abs(number), std::chars_format::hex);
    } else
      write_digits(number);
  }
  template <class T>
  void put_word(const T& value) {
    if (!at_start_) put(' ');
    at_start_ = false;
    put(value);
  }

  void reserve(std::size_t n) {
    if (used_ + n > sizeof(buffer_)) write();
  }
  void write() {
    out_.write(buffer_, static_cast<std::streamsize>(used_));
    used_ = 0;
  }

  std::ostream& out_;
  std::size_t used_ = 0;
  bool at_start_ = true;
  char buffer_[1 << 16];
};

using Output_buffer = Basic_output_buffer<false>;

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_OUTPUT_BUFFER_H
