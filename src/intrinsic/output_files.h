// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_OUTPUT_FILES_H
#define INTRINSIC_OUTPUT_FILES_H

#include <CGAL/Intrinsic_triangulations/IO/support/Replacing_file.h>

#include <exception>
#include <filesystem>
#include <list>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace program {

/// makes the signals that end programs first remove files that are not complete.
void remove_incomplete_files_on_signals();
/// makes them remove a file, or a folder that is empty then, until files are complete.
void remove_on_signals(const std::string& path);
/// removes files that are not complete; a signal handler may call it.
void remove_incomplete_files();

/*!
\brief holds the files that the program writes: none of them appears before all are complete.
*/
class Output_files {
public:
  Output_files() = default;
  Output_files(const Output_files&) = delete;
  Output_files& operator=(const Output_files&) = delete;
  ~Output_files();

  /// opens a file, or what goes to standard output. \throws std::runtime_error naming the file
  std::ostream& open(const std::string& path);
  /// writes a file: calls a function with its stream, and with its extension if it takes that.
  /// \throws std::runtime_error naming the file if it is not complete
  template <class Function>
  void write(const std::string& path, const Function& function) {
    std::ostream& out = open(path);
    try {
      if constexpr (std::is_invocable_v<Function, std::ostream&, std::string>)
        function(out, std::filesystem::path(path).extension().string());
      else
        function(out);
    } catch (const std::exception&) {
      if (out) throw;
      throw std::runtime_error(path + ": the file cannot be written completely; is the disk full?");
    }
  }
  /// returns the paths of all files so far.
  const std::vector<std::string>& paths() const { return paths_; }
  /// completes all files. \throws std::runtime_error naming the file that cannot be completed
  void commit();

private:
  std::list<CGAL::Intrinsic_triangulations::Replacing_file> files_;
  std::vector<std::string> paths_;
  std::ostringstream standard_output_; // what goes there when all files are complete
};

} // namespace program

#endif // INTRINSIC_OUTPUT_FILES_H
