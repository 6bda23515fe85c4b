// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "progress.h"

#include <iostream>

#include <unistd.h>

namespace program {

Progress::Progress()
    : is_terminal_(isatty(STDERR_FILENO) != 0), start_(std::chrono::steady_clock::now()),
      last_(start_) {}

Progress::~Progress() {
  if (is_shown_) std::cerr << "\r\033[K" << std::flush;
}

void Progress::show(const std::string& what) {
  using namespace std::chrono_literals;
  const auto now = std::chrono::steady_clock::now();
  if (!is_terminal_ || now - start_ < 1s || (is_shown_ && now - last_ < 100ms)) return;
  std::cerr << '\r' << what << "\033[K" << std::flush;
  is_shown_ = true;
  last_ = now;
}

} // namespace program
