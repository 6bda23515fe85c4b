// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "become.h"

#include <csignal>
#include <filesystem>
#include <stdexcept>

#include <unistd.h>

namespace program {

void become(const std::string& program, const std::vector<std::string>& arguments) {
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe");
  const std::filesystem::path beside = self.parent_path() / program;
  std::vector<char*> words;
  const auto add = [&words](const std::string& word) {
    words.push_back(const_cast<char*>(word.c_str())); // exec does not change them
  };
  add(program);
  for (const std::string& word : arguments) add(word);
  words.push_back(nullptr);
  // A timer goes on in the other program, where its signal would end the process without a word
  // before there is a handler.
  sigset_t alarm;
  sigemptyset(&alarm);
  sigaddset(&alarm, SIGALRM);
  sigprocmask(SIG_BLOCK, &alarm, nullptr);
  execv(beside.c_str(), words.data());
  execvp(program.c_str(), words.data());
  throw std::runtime_error(
      "the program " + program + " is neither in " + beside.parent_path().string() +
      " nor on PATH; build it: cmake --build BUILD_DIRECTORY --target " + program);
}

} // namespace program
