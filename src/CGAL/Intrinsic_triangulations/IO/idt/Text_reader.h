// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_TEXT_READER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_TEXT_READER_H

#include <CGAL/Intrinsic_triangulations/IO/support/Buffered_input.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Interval_nt.h>

#include <array>
#include <charconv>
#include <cstdint>
#include <istream>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

inline constexpr std::array<std::pair<Mollification, std::string_view>, 3> mollification_names = {
    {{Mollification::none, "none"},
     {Mollification::lengths, "lengths"},
     {Mollification::squared_lengths, "squared_lengths"}}};

// The words for kinds of input: none if the file has only names.
inline constexpr std::string_view points_name = "points", squared_lengths_name = "squared_lengths",
                                  no_input_name = "none", planar_polygons_name = "planar_polygons";

// The words for the part of the input that an inserted vertex is in.
inline constexpr std::string_view in_face_name = "face", on_edge_name = "edge";

// Reads what `write_intrinsic_triangulation()` writes, word by word. Errors name file and line.
class Text_reader {
public:
  Text_reader(std::istream& in, std::string file) : in_(in), file_(std::move(file)) {}

  // Goes to the next line, which must exist.
  void next_line() {
    bool is_there = false;
    try {
      is_there = in_.next_line(rest_);
    } catch (const Buffered_input::Line_too_long& error) {
      throw Invalid_input(Element_kind::none, 0,
                          file_ + ":" + std::to_string(error.line) + ": " + error.message);
    }
    if (!is_there)
      throw Invalid_input(Element_kind::none, 0,
                          file_ + ":" + std::to_string(in_.line_number() + 1) +
                              ": the file ends too early; get a complete copy");
  }

  // Reads lines, each by a functor that is called with its number, to their ends.
  template <class Read>
  void lines(std::uint32_t count, Read read) {
    for (std::uint32_t i = 0; i < count; ++i) {
      next_line();
      read(i);
      finish_line();
    }
  }
  // Reads a line that starts with a keyword.
  template <class Read>
  void line(std::string_view expected, Read read) {
    lines(1, [&](std::uint32_t) {
      keyword(expected);
      read();
    });
  }

  std::string_view word() { return next_word(rest_); }

  void keyword(std::string_view expected) {
    const std::string_view found = word();
    if (found != expected)
      fail("\"" + std::string(expected) + "\" is expected, not \"" + shown(found) + "\"");
  }

  template <class Integer>
  Integer integer(const char* what) {
    Integer i = 0;
    const std::string_view w = word();
    if (!parse_number(w, i)) fail_at_word(w, what);
    return i;
  }

  // A number below `bound`.
  std::uint32_t index(std::uint32_t bound, const char* what) {
    const std::string_view w = word();
    std::uint32_t i = 0;
    if (!parse_number(w, i)) fail_at_word(w, what);
    if (i >= bound)
      fail(std::string(what) + " " + std::to_string(i) + " does not exist; there are " +
           std::to_string(bound));
    return i;
  }

  // A finite number.
  double real(const char* what) {
    const std::string_view w = word();
    double x = 0;
    if (!parse_hexadecimal(w, x)) fail_at_word(w, what);
    return x;
  }

  // A finite number that is not negative.
  void nonnegative(double& x, const char* what) {
    x = real(what);
    if (x < 0) fail(std::string(what) + " is negative");
  }

  // The ends of an interval of nonnegative numbers, of which the upper may be infinite.
  void nonnegative(Interval_nt<false>& x, const char* what) {
    double inf = 0, sup = std::numeric_limits<double>::infinity();
    nonnegative(inf, what);
    const std::string_view w = word();
    if (w != "inf" && !parse_hexadecimal(w, sup)) fail_at_word(w, what);
    if (!(inf <= sup)) fail(std::string(what) + " has a lower bound above the upper one");
    x = Interval_nt<false>(inf, sup);
  }

  // Refuses more words on the line.
  void finish_line() {
    if (const std::string_view w = word(); !w.empty())
      fail("\"" + shown(w) + "\" is more than belongs on this line");
  }

  [[noreturn]] void fail(const std::string& what) const {
    refuse(what + "; the file is damaged: write it again");
  }

  // The same with a remedy of its own.
  [[noreturn]] void refuse(const std::string& what) const {
    throw Invalid_input(Element_kind::none, 0,
                        file_ + ":" + std::to_string(in_.line_number()) + ": " + what);
  }

private:
  [[noreturn]] void fail_at_word(std::string_view w, const char* what) const {
    fail(w.empty() ? std::string(what) + " is missing"
                   : "\"" + shown(w) + "\" is no valid " + what);
  }

  static bool parse_hexadecimal(std::string_view w, double& x) {
    const bool negative = !w.empty() && w[0] == '-';
    if (negative) w.remove_prefix(1);
    if (w.substr(0, 2) != "0x" || w.size() < 3 || w[2] == '-') return false;
    const auto r = std::from_chars(w.data() + 2, w.data() + w.size(), x, std::chars_format::hex);
    if (r.ec != std::errc() || r.ptr != w.data() + w.size() || !std::isfinite(x)) return false;
    if (negative) x = -x;
    return true;
  }

  Buffered_input in_;
  std::string file_;
  std::string_view rest_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_TEXT_READER_H
