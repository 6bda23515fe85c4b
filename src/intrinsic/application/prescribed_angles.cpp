// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "prescribed_angles.h"
#include "../support/text_lines.h"

#include <charconv>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace program {

namespace {

namespace IT = CGAL::Intrinsic_triangulations;

// Integers below are exact as doubles, too.
std::optional<std::int64_t> positive_integer(std::string_view word) {
  constexpr std::int64_t most = std::int64_t{1} << 50; // also eight times one
  std::int64_t n = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), n);
  if (error != std::errc() || end != word.data() + word.size() || n < 1 || n > most)
    return std::nullopt;
  return n;
}

// `pi`, `2pi`, `3/2pi`, `3pi/2`; nothing if it is none of these.
std::optional<IT::Multiple_of_pi> multiple_of_pi(std::string_view word) {
  const std::size_t pi = word.find("pi");
  if (pi == std::string_view::npos) return std::nullopt;
  std::string_view before = word.substr(0, pi), after = word.substr(pi + 2);
  if (const std::size_t slash = before.find('/'); slash != std::string_view::npos) {
    if (!after.empty()) return std::nullopt;
    after = before.substr(slash);
    before = before.substr(0, slash);
  }
  const auto numerator = before.empty() ? 1 : positive_integer(before);
  const auto denominator = after.empty()          ? 1
                           : after.front() == '/' ? positive_integer(after.substr(1))
                                                  : std::nullopt;
  if (!numerator || !denominator) return std::nullopt;
  return IT::Multiple_of_pi{*numerator, *denominator};
}

void set(IT::Prescribed_angles& angles, std::size_t vertex, const Text_lines& lines,
         std::size_t word) {
  const std::string_view text = lines.words()[word];
  if (text == "free")
    angles.set_free(vertex);
  else if (const auto multiple = multiple_of_pi(text))
    angles.set(vertex, *multiple);
  else if (text.find("pi") != std::string_view::npos)
    lines.refuse("\"" + std::string(text) + "\" is not an angle; write multiples of pi as 3/2pi");
  else if (const double radians = lines.number(word); radians > 0)
    angles.set(vertex, radians);
  else
    lines.refuse("an angle is not positive; give radians, or multiples of pi as 3/2pi");
}

} // namespace

IT::Prescribed_angles read_angles(const std::string& path, std::size_t vertices) {
  Text_lines lines(path);
  IT::Prescribed_angles angles(vertices);
  std::size_t count = 0;
  for (; lines.next(); ++count) {
    lines.expect_words(1, "an angle");
    if (count < vertices) set(angles, count, lines, 0);
  }
  if (count != vertices)
    throw std::runtime_error(path + ": the file has " + std::to_string(count) +
                             " angles; give one for each of the " + std::to_string(vertices) +
                             " vertices of the mesh");
  return angles;
}

void read_cones(const std::string& path, IT::Prescribed_angles& angles) {
  Text_lines lines(path);
  while (lines.next()) {
    lines.expect_words(2, "the number of a vertex and its angle");
    set(angles, lines.element(0, "vertex", angles.size()), lines, 1);
  }
}

} // namespace program
