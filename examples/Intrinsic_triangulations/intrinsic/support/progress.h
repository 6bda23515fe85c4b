// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUPPORT_PROGRESS_H
#define INTRINSIC_SUPPORT_PROGRESS_H

#include <chrono>
#include <string>

namespace program {

/// measures wall clock time.
class Stopwatch {
public:
  /// returns the seconds since construction or the last call.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - start_).count();
    start_ = now;
    return seconds;
  }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/*!
\brief shows what is going on in one line of a terminal at standard error, once work has taken a
second; nothing where standard error is no terminal.
*/
class Progress {
public:
  Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// clears the line.
  ~Progress();

  /// shows what is being done now.
  void show(const std::string& what);

private:
  bool is_terminal_;
  bool is_shown_ = false;
  std::chrono::steady_clock::time_point start_, last_;
};

} // namespace program

#endif // INTRINSIC_SUPPORT_PROGRESS_H
