// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUPPORT_PROGRESS_H
#define INTRINSIC_SUPPORT_PROGRESS_H

#include <chrono>
#include <string>

namespace program {

/// returns the current stage; a signal handler may call it.
const char* current_stage();

/// clears the line that shows the current stage, if there is one.
void clear_progress_line();

/*!
\brief shows the current stage on standard error: in one line of a terminal, after the first second;
or in lines of a log, one for each stage and one for every second. Without a log, and if standard
error is not a terminal, it shows nothing.
*/
class Progress {
public:
  /// \param logs whether to write a log
  /// \param is_quiet whether to say nothing
  Progress(bool logs, bool is_quiet);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// clears the line.
  ~Progress();

  /*!
  \brief shows the current stage.
  \param stage a string literal
  \param detail how far that is: a number and of what, if there is a number
  \return true: visitors that return it go on
  */
  bool show(const char* stage, const std::string& detail = {});
  /// writes a line to standard error at once: why what follows takes long.
  void say(const std::string& message);

private:
  using Clock = std::chrono::steady_clock;

  void log(const char* stage, const std::string& detail, Clock::time_point now);

  bool logs_, is_quiet_, is_terminal_;
  Clock::time_point start_, last_;
};

} // namespace program

#endif // INTRINSIC_SUPPORT_PROGRESS_H
