// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <unistd.h>

namespace program {

// The study takes long to compile, and few need it: it is a program of its own, which this one becomes.
void run_study(const Options& options) {
  const std::string name = "intrinsic-study";
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe");
  const std::filesystem::path beside = self.parent_path() / name;
  std::vector<char*> arguments;
  const auto add = [&arguments](const std::string& word) {
    arguments.push_back(const_cast<char*>(word.c_str())); // exec does not change them
  };
  add(name);
  for (const std::string& word : options.study) add(word);
  arguments.push_back(nullptr);
  execv(beside.c_str(), arguments.data());
  execvp(name.c_str(), arguments.data());
  throw std::runtime_error(
      "the program " + name + " is neither in " + beside.parent_path().string() +
      " nor on PATH; build it: cmake --build BUILD_DIRECTORY --target " + name);
}

} // namespace program
