// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_OUTPUT_FILES_H
#define INTRINSIC_OUTPUT_FILES_H

#include <CGAL/Intrinsic_triangulations/IO/support/Replacing_file.h>

#include <list>
#include <ostream>
#include <string>

namespace program {

/// makes SIGINT, SIGTERM and SIGHUP remove files that are not complete before they end the program.
void remove_incomplete_files_on_signals();

/*!
\brief holds the files that the program writes: none of them appears before all are complete.
*/
class Output_files {
public:
  Output_files() = default;
  Output_files(const Output_files&) = delete;
  Output_files& operator=(const Output_files&) = delete;
  ~Output_files();

  /// opens a file. \throws std::runtime_error naming the file
  std::ostream& open(const std::string& path);
  /// completes all files. \throws std::runtime_error naming the file that cannot be completed
  void commit();

private:
  std::list<CGAL::Intrinsic_triangulations::Replacing_file> files_;
};

} // namespace program

#endif // INTRINSIC_OUTPUT_FILES_H
