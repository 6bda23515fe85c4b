// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output_files.h"
#include "options.h"

#include <array>
#include <climits>
#include <csignal>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>

#include <unistd.h>

namespace program {

namespace {

constexpr std::array<int, 4> handled_signals = {SIGINT, SIGTERM, SIGHUP, SIGPIPE};

// What the signal handler removes: plain arrays, as it may not allocate or lock.
constexpr std::size_t maximal_files = 16;
std::array<std::array<char, PATH_MAX>, maximal_files> incomplete_files;
volatile std::sig_atomic_t number_of_incomplete_files = 0;

// Holds signals back while files and the list of them change together.
class Signals_held_back {
public:
  Signals_held_back() {
    sigset_t set;
    sigemptyset(&set);
    for (const int s : handled_signals) sigaddset(&set, s);
    sigaddset(&set, SIGALRM);
    pthread_sigmask(SIG_BLOCK, &set, &previous_);
  }
  ~Signals_held_back() { pthread_sigmask(SIG_SETMASK, &previous_, nullptr); }
  Signals_held_back(const Signals_held_back&) = delete;
  Signals_held_back& operator=(const Signals_held_back&) = delete;

private:
  sigset_t previous_;
};

extern "C" void remove_and_end(int signal) {
  remove_incomplete_files();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void append_incomplete_file(const std::string& path) {
  const auto i = static_cast<std::size_t>(number_of_incomplete_files);
  if (path.size() >= PATH_MAX || i >= maximal_files)
    throw std::runtime_error(path + ": the path is too long; choose a shorter one");
  std::memcpy(incomplete_files[i].data(), path.c_str(), path.size() + 1);
  number_of_incomplete_files = number_of_incomplete_files + 1;
}

} // namespace

void remove_on_signals(const std::string& path) {
  const Signals_held_back guard;
  append_incomplete_file(path);
}

void remove_incomplete_files() {
  for (int i = 0; i < number_of_incomplete_files; ++i)
    if (const char* const path = incomplete_files[static_cast<std::size_t>(i)].data();
        unlink(path) != 0)
      rmdir(path); // a folder that was made for a file before
}

void remove_incomplete_files_on_signals() {
  for (const int s : handled_signals)
    if (std::signal(s, remove_and_end) == SIG_IGN) std::signal(s, SIG_IGN); // as under nohup
  std::signal(SIGXFSZ, SIG_IGN); // a file that is too large is one that cannot be written
}

Output_files::~Output_files() {
  const Signals_held_back guard;
  files_.clear();
  number_of_incomplete_files = 0;
}

std::ostream& Output_files::open(const std::string& path) {
  paths_.push_back(path);
  if (is_standard_output(path)) return standard_output_;
  const Signals_held_back guard;
  files_.emplace_back(path);
  const std::string temporary = files_.back().temporary().string();
  if (!temporary.empty()) append_incomplete_file(temporary);
  return files_.back().stream();
}

void Output_files::commit() {
  // standard output first: it may block, and if it fails no file is replaced
  std::signal(SIGALRM, SIG_IGN); // the limit of time is met
  const std::string text = std::move(standard_output_).str();
  if (!text.empty() && !(std::cout << text << std::flush))
    throw std::runtime_error("standard output cannot be written; is the disk full?");
  const Signals_held_back guard;
  for (auto& file : files_) file.commit();
  files_.clear();
  number_of_incomplete_files = 0;
}

} // namespace program
