// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "text_lines.h"

#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <utility>

namespace program {

namespace text = CGAL::Intrinsic_triangulations::text;

Text_lines::Text_lines(std::string path) : path_(std::move(path)), in_(stream_) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(path_, ignored)) stream_.open(path_, std::ios::binary);
  if (!stream_.is_open())
    throw std::runtime_error(path_ + ": the file does not exist or cannot be opened; check its "
                                     "name and permissions");
}

bool Text_lines::next() {
  std::string_view line;
  words_.clear();
  try {
    if (!in_.next_content_line(line, '#')) return false;
  } catch (const text::Buffered_input::Line_too_long& error) {
    throw std::runtime_error(path_ + ":" + std::to_string(error.line) + ": " + error.message);
  }
  for (std::string_view word = text::next_word(line); !word.empty(); word = text::next_word(line)) {
    if (words_.size() == 1000000) refuse("there are more than 1000000 words; is this the file?");
    words_.push_back(word);
  }
  return true;
}

std::uint32_t Text_lines::element(std::size_t word, const char* kind, std::size_t count) const {
  std::uint32_t i = 0;
  if (!text::parse_number(words_[word], i))
    refuse(std::string("\"") + text::shown(words_[word]) + "\" is not the number of a " + kind +
           "; give whole numbers from 0");
  if (i >= count)
    refuse(std::string(kind) + " " + std::to_string(i) +
           " does not exist; give numbers from 0 to " + std::to_string(count - 1));
  return i;
}

double Text_lines::number(std::size_t word, Infinity infinity) const {
  const bool takes = infinity == Infinity::taken;
  double x = 0;
  if (!text::parse_number(words_[word], x) || std::isnan(x) || (std::isinf(x) && !takes))
    refuse(std::string("\"") + text::shown(words_[word]) + "\" is not a " +
           (takes ? "number" : "finite number") + "; correct it");
  return x;
}

void Text_lines::expect_words(std::size_t count, const char* what) const {
  if (words_.size() != count)
    refuse("there are " + std::to_string(words_.size()) + " words; give " + what + " on each line");
}

void Text_lines::refuse(const std::string& what) const {
  throw std::runtime_error(path_ + ":" + std::to_string(in_.line_number()) + ": " + what);
}

void Number_table::expect_rows(std::size_t count, const std::string& what) const {
  if (rows() != count)
    throw std::runtime_error(path + ": there are " + std::to_string(rows()) +
                             " lines of numbers for " + std::to_string(count) + " " + what +
                             "; give one line for each");
}

void Number_table::refuse(std::size_t row, const std::string& what) const {
  throw std::runtime_error(path + ":" + std::to_string(lines[row]) + ": " + what);
}

Number_table read_numbers(const std::string& path, std::size_t count, const std::string& what,
                          Infinity infinity) {
  constexpr std::size_t most_columns = 10000; // more is a file without line ends
  Text_lines lines(path);
  Number_table table;
  table.path = path;
  while (lines.next()) {
    const std::size_t n = lines.words().size();
    if (n > most_columns)
      lines.refuse("there are more than " + std::to_string(most_columns) +
                   " numbers; give fewer on each line");
    if (table.rows() == count)
      lines.refuse("there are more than " + std::to_string(count) + " lines of numbers for " +
                   std::to_string(count) + " " + what + "; give one line for each");
    if (table.columns == 0) table.columns = n;
    if (n != table.columns)
      lines.refuse("there are " + std::to_string(n) + " numbers, and " +
                   std::to_string(table.columns) + " on the first line; give as many on each line");
    for (std::size_t k = 0; k < n; ++k) table.values.push_back(lines.number(k, infinity));
    table.lines.push_back(lines.line());
  }
  if (table.columns == 0)
    throw std::runtime_error(path + ": the file has no numbers; give one line per element");
  return table;
}

std::vector<std::uint32_t> vertex_numbers(const Number_table& table, std::size_t vertices) {
  std::vector<std::uint32_t> result;
  std::map<std::uint32_t, std::size_t> rows;
  for (std::size_t r = 0; r < table.rows(); ++r) {
    const double number = table.values[table.columns * r];
    if (!(number >= 0) || number >= static_cast<double>(vertices) || number != std::floor(number))
      table.refuse(r, "there is no such vertex; give a number from 0 to " +
                          std::to_string(vertices - 1));
    result.push_back(static_cast<std::uint32_t>(number));
    const auto [first, is_new] = rows.insert({result.back(), r});
    if (!is_new)
      table.refuse(r, "vertex " + std::to_string(result.back()) + " is on line " +
                          std::to_string(table.lines[first->second]) + " already; give it once");
  }
  return result;
}

} // namespace program
