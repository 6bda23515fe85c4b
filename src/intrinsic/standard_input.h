// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STANDARD_INPUT_H
#define INTRINSIC_STANDARD_INPUT_H

#include <filesystem>
#include <string>

namespace program {

/// Holds what came from standard input in a file with the extension of its format, as formats are
/// read by it. The file is gone when this object is.
class Standard_input {
public:
  /// reads standard input to its end.
  /// \param format an extension without its dot; empty: the format is guessed from the contents
  /// \throws std::runtime_error if it cannot be guessed, and says how to name it
  explicit Standard_input(const std::string& format);
  Standard_input(const Standard_input&) = delete;
  Standard_input& operator=(const Standard_input&) = delete;
  ~Standard_input();

  /// returns the path of the file.
  const std::string& path() const { return path_; }

private:
  std::filesystem::path folder_;
  std::string path_;
};

} // namespace program

#endif // INTRINSIC_STANDARD_INPUT_H
