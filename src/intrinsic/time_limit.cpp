// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "time_limit.h"

#include "output_files.h"
#include "support/input_name.h"
#include "support/messages.h"
#include "support/progress.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>
#include <sstream>
#include <string>

#include <sys/time.h>
#include <unistd.h>

namespace program {

namespace {

// What the handler writes; it may not allocate.
struct Message {
  std::string begin;        // before what was being done
  std::string end;          // after it
  std::string end_refining; // after it, while refining
};
Message message;

void write_to_standard_error(const char* text, std::size_t size) {
  while (size > 0) {
    const ssize_t written = write(STDERR_FILENO, text, size);
    if (written <= 0) return;
    text += written;
    size -= static_cast<std::size_t>(written);
  }
}

extern "C" void end_at_the_limit(int) {
  remove_incomplete_files();
  const char* const stage = current_stage();
  const bool is_refining = std::strcmp(stage, "refining") == 0;
  const std::string& end = is_refining ? message.end_refining : message.end;
  write_to_standard_error(message.begin.data(), message.begin.size());
  write_to_standard_error(stage, std::strlen(stage));
  write_to_standard_error(end.data(), end.size());
  _exit(failed);
}

} // namespace

void end_at_time_limit(const Options& options) {
  const double seconds = *options.time_limit;
  std::ostringstream first;
  // the terminal may show a line of progress
  first << (isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "")
        << "intrinsic: " << with_input_named(options.input) << ": the time limit of " << seconds
        << " s was reached while ";
  message.begin = first.str();
  message.end =
      std::string("; nothing was written; allow more time with --time-limit, or ask for less") +
      (options.arithmetic == "exact" ? "; --arithmetic double is faster on hard meshes\n" : "\n");
  message.end_refining =
      options.refinement.minimum_angle > greatest_safe_angle
          ? "; nothing was written; there is no guarantee above 30 degrees that refinement ends: "
            "ask for --min-angle 30 or less, or stop it with --max-insertions\n"
          : message.end;
  std::signal(SIGALRM, end_at_the_limit);
  sigset_t alarm;
  sigemptyset(&alarm);
  sigaddset(&alarm, SIGALRM);
  itimerval timer{};
  // The program that became this one has started the timer, and blocked its signal, see become().
  if (sigset_t blocked; sigprocmask(SIG_UNBLOCK, &alarm, &blocked) == 0 &&
                        sigismember(&blocked, SIGALRM) == 1 &&
                        getitimer(ITIMER_REAL, &timer) == 0 && timerisset(&timer.it_value))
    return;
  double whole = 0;
  const double fraction = std::modf(seconds, &whole);
  timer.it_value.tv_sec = static_cast<time_t>(whole);
  timer.it_value.tv_usec = std::max<suseconds_t>(static_cast<suseconds_t>(1e6 * fraction),
                                                 whole == 0 ? 1 : 0); // zero would be never
  setitimer(ITIMER_REAL, &timer, nullptr);
}

} // namespace program
