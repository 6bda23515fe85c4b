// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "time_limit.h"

#include "output_files.h"
#include "support/messages.h"
#include "support/progress.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstring>
#include <sstream>
#include <string>

#include <sys/time.h>
#include <unistd.h>

namespace program {

namespace {

// What the handler writes, before and after what was being done; it may not allocate.
std::array<std::string, 2> message;

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
  write_to_standard_error(message[0].data(), message[0].size());
  write_to_standard_error(stage, std::strlen(stage));
  write_to_standard_error(message[1].data(), message[1].size());
  _exit(failed);
}

} // namespace

void end_at_time_limit(const Options& options) {
  const double seconds = *options.time_limit;
  std::ostringstream first;
  // the terminal may show a line of progress
  first << (isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "") << "intrinsic: " << options.input
        << ": the time limit of " << seconds << " s was reached while ";
  message = {
      first.str(),
      std::string("; nothing was written; allow more time with --time-limit, or ask for less") +
          (options.arithmetic == "exact" ? "; --arithmetic double is faster on hard meshes\n"
                                         : "\n")};
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
