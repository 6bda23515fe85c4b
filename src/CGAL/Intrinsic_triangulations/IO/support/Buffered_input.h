// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_BUFFERED_INPUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_BUFFERED_INPUT_H

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <istream>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

// Reading and writing of text and binary files, for the library and for programs.
namespace CGAL::Intrinsic_triangulations::text {

inline char lower_case(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// The extension of a file in lower case, without its dot.
inline std::string plain_extension(std::string_view extension) {
  if (extension.starts_with('.')) extension.remove_prefix(1);
  std::string result(extension);
  for (char& c : result) c = lower_case(c);
  return result;
}

inline bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// The byte order mark that some editors write before UTF-8.
inline constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

// Takes the next word off the front of `text`; empty at the end.
inline std::string_view next_word(std::string_view& text) {
  std::size_t first = 0;
  while (first < text.size() && is_space(text[first])) ++first;
  std::size_t last = first;
  while (last < text.size() && !is_space(text[last])) ++last;
  const std::string_view word = text.substr(first, last - first);
  text.remove_prefix(last);
  return word;
}

// Whether a word is another one, given in lower case, in any letter case.
inline bool is_word(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
                    [](char c, char l) { return lower_case(c) == l; });
}

// A word of a file for a message: no longer than a line, without what cannot be printed.
inline std::string shown(std::string_view word) {
  constexpr std::size_t most = 40; // half a line of a terminal
  std::string result;
  for (const char c : word.substr(0, most)) result += c >= ' ' && c <= '~' ? c : '?';
  return word.size() > most ? result + "..." : result;
}

// Reads the whole word as the nearest number, whatever the locale. Numbers beyond the range become
// infinite or zero, as with std::strtod.
template <class Number>
bool parse_number(std::string_view word, Number& value) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || result.ptr != word.data() + word.size()) return false;
  if (result.ec == std::errc()) return true;
  if constexpr (std::is_floating_point_v<Number>) {
    if (result.ec != std::errc::result_out_of_range) return false;
    value = static_cast<Number>(std::strtod(std::string(word).c_str(), nullptr));
    return true;
  }
  return false;
}

// Reads an integer, also one written like 3.0, as CGAL's readers accept it.
inline bool parse_integer(std::string_view word, std::int64_t& value) {
  if (parse_number(word, value)) return true;
  double d = 0;
  if (!parse_number(word, d) || !(std::abs(d) < 0x1p62) || std::trunc(d) != d) return false;
  value = static_cast<std::int64_t>(d);
  return true;
}

// Reads lines, words and bytes from a stream in large pieces; memory is bounded by the longest
// line, which has a bound, never by a number in the file. A byte order mark is skipped; lines end
// as the first one does, by LF or, as once on Macs, by CR. The CR of CR LF is a space.
class Buffered_input {
public:
  // Reports a line without an end.
  struct Line_too_long {
    std::size_t line;
    static constexpr const char* message =
        "the line is longer than 64 MiB; the file is no text, or its line ends are lost";
  };

  explicit Buffered_input(std::istream& in) : in_(in), buffer_(std::size_t(1) << 18, '\0') {}

  // The line without its end; false at the end of the file. The view is valid until the next call.
  bool next_line(std::string_view& line) {
    if (line_number_ == 0) begin_text();
    std::size_t scanned = 0;
    for (;;) {
      const char* const start = buffer_.data() + begin_;
      const void* const found = std::memchr(start + scanned, line_end_, end_ - begin_ - scanned);
      scanned = end_ - begin_;
      if (found == nullptr && scanned > longest_line) throw Line_too_long{line_number_ + 1};
      if (found == nullptr && refill()) continue;
      const char* const stop =
          found != nullptr ? static_cast<const char*>(found) : buffer_.data() + end_;
      if (found == nullptr && scanned == 0) return false;
      line = std::string_view(buffer_.data() + begin_,
                              static_cast<std::size_t>(stop - (buffer_.data() + begin_)));
      begin_ += line.size() + (found != nullptr ? 1 : 0);
      ++line_number_;
      return true;
    }
  }

  // The next line that holds more than a comment, without the comment.
  bool next_content_line(std::string_view& line, char comment) {
    while (next_line(line)) {
      if (const auto hash = line.find(comment); hash != std::string_view::npos)
        line = line.substr(0, hash);
      std::string_view rest = line;
      if (!next_word(rest).empty()) return true;
    }
    return false;
  }

  // The next word of the file, and empty at its end, where `line` is what is left of this line.
  std::string_view next_word_of_file(std::string_view& line) {
    for (;;) {
      const std::string_view word = next_word(line);
      if (!word.empty() || !next_line(line)) return word;
    }
  }

  // Copies the next `count` bytes; false if the file ends before.
  bool read(char* out, std::size_t count) {
    while (end_ - begin_ < count)
      if (!refill()) return false;
    std::memcpy(out, buffer_.data() + begin_, count);
    begin_ += count;
    return true;
  }

  // Number of the line last read, from 1.
  std::size_t line_number() const { return line_number_; }

private:
  // the buffer grows with the line: binary files, read as text, must not fill the memory
  static constexpr std::size_t longest_line = std::size_t(1) << 26;

  void begin_text() {
    if (end_ == begin_) refill();
    const std::string_view text(buffer_.data() + begin_, end_ - begin_);
    if (text.starts_with(byte_order_mark)) begin_ += byte_order_mark.size();
    const std::size_t first = text.find_first_of("\r\n");
    if (first != std::string_view::npos && text[first] == '\r' && text.substr(first + 1, 1) != "\n")
      line_end_ = '\r';
  }

  bool refill() {
    if (begin_ > 0) std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
    if (end_ == buffer_.size()) buffer_.resize(2 * buffer_.size());
    in_.read(buffer_.data() + end_, static_cast<std::streamsize>(buffer_.size() - end_));
    end_ += static_cast<std::size_t>(in_.gcount());
    return in_.gcount() > 0;
  }

  std::istream& in_;
  std::string buffer_;
  std::size_t begin_ = 0, end_ = 0, line_number_ = 0;
  char line_end_ = '\n';
};

// Reads one number of type `Number`, as stored with the given byte order.
template <class Number>
bool read_binary(Buffered_input& in, Number& value, std::endian order) {
  char bytes[sizeof(Number)];
  if (!in.read(bytes, sizeof(Number))) return false;
  if (order != std::endian::native) std::reverse(bytes, bytes + sizeof(Number));
  std::memcpy(&value, bytes, sizeof(Number));
  return true;
}

} // namespace CGAL::Intrinsic_triangulations::text

namespace CGAL::Intrinsic_triangulations::internal {

using namespace text;

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_BUFFERED_INPUT_H
