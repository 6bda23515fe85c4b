// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUPPORT_TEXT_LINES_H
#define INTRINSIC_SUPPORT_TEXT_LINES_H

#include <CGAL/Intrinsic_triangulations/IO/support/Buffered_input.h>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace program {

/// Whether a file may have the word inf, as distances have where no path leads.
enum class Infinity { refused, taken };

/*!
\brief reads a text file of numbers: a record per line, words separated by spaces. A comment begins
with `#`; lines without words do not count. Errors name file and line.
*/
class Text_lines {
public:
  /// opens a file. \throws std::runtime_error naming it if that is impossible
  explicit Text_lines(std::string path);

  /// goes to the next line that has words, a million at most; false at the end of the file.
  bool next();
  /// returns the words of the line.
  const std::vector<std::string_view>& words() const { return words_; }
  /// returns a word as the number of an element, of which there are `count`.
  std::uint32_t element(std::size_t word, const char* kind, std::size_t count) const;
  /// returns a word as a finite number, or infinity where that is taken.
  double number(std::size_t word, Infinity infinity = Infinity::refused) const;
  /// returns the number of the line, from 1.
  std::size_t line() const { return in_.line_number(); }
  /// checks the number of words. \param what what belongs on a line
  void expect_words(std::size_t count, const char* what) const;
  /// \throws std::runtime_error naming file and line
  [[noreturn]] void refuse(const std::string& what) const;

private:
  std::string path_;
  std::ifstream stream_;
  CGAL::Intrinsic_triangulations::text::Buffered_input in_;
  std::vector<std::string_view> words_;
};

/// Numbers in rows and columns.
struct Number_table {
  std::string path;
  std::size_t columns = 0;
  std::vector<double> values;     ///< row by row
  std::vector<std::size_t> lines; ///< of the file, from 1; one per row

  /// returns the number of rows.
  std::size_t rows() const { return lines.size(); }
  /// checks the number of rows. \param what what each row is for, in the plural
  /// \throws std::runtime_error
  void expect_rows(std::size_t count, const std::string& what) const;
  /// \throws std::runtime_error naming file and line of a row
  [[noreturn]] void refuse(std::size_t row, const std::string& what) const;
};

/// returns the numbers of the vertices in the first column.
/// \throws std::runtime_error naming the line of a number that is not a vertex, or occurs twice
std::vector<std::uint32_t> vertex_numbers(const Number_table& table, std::size_t vertices);

/*!
\brief reads a file of numbers, as many on each line as on the first.
\param count how many lines there may be
\param what what each line is for, in the plural
\throws std::runtime_error naming file and line
*/
Number_table read_numbers(const std::string& path, std::size_t count, const std::string& what,
                          Infinity infinity = Infinity::refused);

} // namespace program

#endif // INTRINSIC_SUPPORT_TEXT_LINES_H
