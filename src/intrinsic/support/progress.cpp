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
static_assert(std::atomic<const char*>::is_always_lock_free, "a signal handler reads it");

} // namespace

const char* current_stage() { return stage_now; }

Progress::Progress(bool logs)
    : logs_(logs), is_terminal_(isatty(STDERR_FILENO) != 0), start_(Clock::now()), last_(start_) {}

Progress::~Progress() {
  if (is_shown_) std::cerr << "\r\033[K" << std::flush;
}

bool Progress::show(const char* stage, const std::string& detail) {
  using namespace std::chrono_literals;
  const auto now = Clock::now();
  if (logs_) log(stage, detail, now);
  stage_now = stage;
  if (logs_ || !is_terminal_ || now - start_ < 1s || (is_shown_ && now - last_ < 100ms))
    return true;
  std::cerr << '\r' << stage << (detail.empty() ? "" : ": ") << detail << "\033[K" << std::flush;
  is_shown_ = true;
  last_ = now;
  return true;
}

void Progress::warn(const std::string& message) { std::cerr << message << '\n'; }

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
