// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "progress.h"

#include <atomic>
#include <iostream>
#include <sstream>

#include <unistd.h>

namespace program {

namespace {

std::atomic<const char*> stage_now = "starting";
bool is_line_shown = false;
static_assert(std::atomic<const char*>::is_always_lock_free, "a signal handler reads it");

} // namespace

const char* current_stage() { return stage_now; }

void clear_progress_line() {
  if (is_line_shown) std::cerr << "\r\033[K" << std::flush;
  is_line_shown = false;
}

Progress::Progress(bool logs, bool is_quiet)
    : logs_(logs), is_quiet_(is_quiet), is_terminal_(!is_quiet && isatty(STDERR_FILENO) != 0),
      start_(Clock::now()), last_(start_) {}

Progress::~Progress() { clear_progress_line(); }

bool Progress::show(const char* stage, const std::string& detail) {
  using namespace std::chrono_literals;
  const auto now = Clock::now();
  if (logs_) log(stage, detail, now);
  stage_now = stage;
  if (logs_ || !is_terminal_ || now - start_ < 1s || (is_line_shown && now - last_ < 100ms))
    return true;
  std::cerr << '\r' << stage << (detail.empty() ? "" : ": ") << detail << "\033[K" << std::flush;
  is_line_shown = true;
  last_ = now;
  return true;
}

void Progress::say(const std::string& message) {
  if (is_quiet_) return;
  clear_progress_line();
  std::cerr << message << '\n';
}

void Progress::log(const char* stage, const std::string& detail, Clock::time_point now) {
  using namespace std::chrono_literals;
  if (stage == stage_now && now - last_ < 1s) return;
  last_ = now;
  std::ostringstream line;
  line.precision(1);
  line << std::fixed << std::chrono::duration<double>(now - start_).count() << " s: " << stage
       << (detail.empty() ? "" : ": ") << detail << '\n';
  std::cerr << line.str() << std::flush;
}

} // namespace program
