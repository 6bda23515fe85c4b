// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STUDY_LINES_H
#define INTRINSIC_STUDY_LINES_H

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace program {

/// Findings, with keys in the order in which they are set.
using Json = nlohmann::ordered_json;

/// returns findings as a line, with keys in the order that is documented.
std::string study_line(const Json& findings);

/*!
\brief reads lines of results.
\param path a file
\param complete set to the size of the file without a last line that is not complete
\return one object per complete line
\throws std::runtime_error naming the file, the line and the remedy
*/
std::vector<Json> read_study_lines(const std::string& path, std::size_t& complete);

/// appends lines to a file, each with one write.
class Study_file {
public:
  /// opens a file. \param complete where to go on: the rest is cut off \throws std::runtime_error
  Study_file(const std::string& path, std::size_t complete);
  ~Study_file();
  Study_file(const Study_file&) = delete;
  Study_file& operator=(const Study_file&) = delete;

  /// appends a line. \throws std::runtime_error
  void append(const std::string& line);

private:
  [[noreturn]] void fail(const char* what) const;

  std::string path_;
  int file_;
};

} // namespace program

#endif // INTRINSIC_STUDY_LINES_H
