// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_OUTPUT_BUFFER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_OUTPUT_BUFFER_H

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <ostream>
#include <string_view>
#include <type_traits>

// Reading and writing of text and binary files, for the library and for programs.
namespace CGAL::Intrinsic_triangulations::text {

template <class T>
concept Arithmetic = std::is_arithmetic_v<T>;

// How the numbers of a table are written.
enum class Number_format { text, binary, base64 };

// Writes text and binary data in blocks, whatever the locale and the byte order of the machine.
// Numbers are decimal, the shortest that read back as the same; on request, those with a point are
// hexadecimal as C's %a writes them.
class Output_buffer {
public:
  explicit Output_buffer(std::ostream& out, bool is_hexadecimal = false)
      : out_(out), is_hexadecimal_(is_hexadecimal) {}

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
    used_ += store(value, buffer_ + used_);
  }
  // Writes these bytes in base64, in a block that `finish_base64()` ends.
  template <Arithmetic T>
  void base64(T value) {
    if (raw_used_ + sizeof(T) > sizeof(raw_)) encode_triples();
    raw_used_ += store(value, raw_ + raw_used_);
  }
  // Pads a block with `=` to a multiple of four characters.
  void finish_base64() {
    encode_triples();
    if (raw_used_ == 0) return;
    std::fill(raw_ + raw_used_, raw_ + 3, '\0');
    reserve(4);
    encode(raw_, buffer_ + used_);
    std::fill(buffer_ + used_ + raw_used_ + 1, buffer_ + used_ + 4, '=');
    used_ += 4;
    raw_used_ = 0;
  }
  // Writes a number of a table in the format that is set.
  template <Arithmetic T>
  void number(T value) {
    if (format == Number_format::text)
      put_word(value);
    else if (format == Number_format::binary)
      binary(value);
    else
      base64(value);
  }
  Number_format format = Number_format::text;

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
    if constexpr (std::is_floating_point_v<T>)
      if (is_hexadecimal_) {
        text(std::signbit(number) ? "-" : "", std::isfinite(number) ? "0x" : "");
        write_digits(std::abs(number), std::chars_format::hex);
        return;
      }
    write_digits(number);
  }
  template <class T>
  void put_word(const T& value) {
    if (!at_start_) put(' ');
    at_start_ = false;
    put(value);
  }

  template <class T>
  static std::size_t store(T value, char* to) {
    std::memcpy(to, &value, sizeof(T));
    if constexpr (std::endian::native == std::endian::big) std::reverse(to, to + sizeof(T));
    return sizeof(T);
  }
  static void encode(const char* triple, char* code) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const auto byte = [triple](int i) { return unsigned{static_cast<unsigned char>(triple[i])}; };
    const unsigned x = byte(0) << 16 | byte(1) << 8 | byte(2);
    for (int i = 0; i < 4; ++i) code[i] = digits[(x >> (18 - 6 * i)) & 63];
  }
  void encode_triples() {
    const std::size_t whole = raw_used_ / 3 * 3;
    reserve(whole / 3 * 4);
    for (std::size_t i = 0; i < whole; i += 3, used_ += 4) encode(raw_ + i, buffer_ + used_);
    std::copy(raw_ + whole, raw_ + raw_used_, raw_);
    raw_used_ -= whole;
  }

  void reserve(std::size_t n) {
    if (used_ + n > sizeof(buffer_)) write();
  }
  void write() {
    out_.write(buffer_, static_cast<std::streamsize>(used_));
    used_ = 0;
  }

  std::ostream& out_;
  bool is_hexadecimal_, at_start_ = true;
  std::size_t used_ = 0, raw_used_ = 0;
  char buffer_[1 << 16];
  char raw_[3072]; // what is to be encoded
};

} // namespace CGAL::Intrinsic_triangulations::text

namespace CGAL::Intrinsic_triangulations::internal {

using namespace text;

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_OUTPUT_BUFFER_H
