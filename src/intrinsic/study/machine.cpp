// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "machine.h"

#include <fstream>
#include <string>
#include <thread>

#include <sys/utsname.h>

namespace program {

namespace {

// Empty if the system does not provide it.
std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) {
      const std::size_t value = line.find(": ");
      if (value != std::string::npos) return line.substr(value + 2);
    }
  return "";
}

} // namespace

std::string machine() {
  utsname system{};
  uname(&system);
  const std::string name = processor();
  return (name.empty() ? system.machine : name) + ", " +
         std::to_string(std::thread::hardware_concurrency()) + " processors, " + system.sysname +
         ' ' + system.release;
}

} // namespace program
