// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input_name.h"

#include <cstddef>

namespace program {

namespace {

std::string standard_input_path; // empty: none

} // namespace

void call_standard_input(const std::string& path) { standard_input_path = path; }

std::string with_input_named(std::string text) {
  if (standard_input_path.empty()) return text;
  for (std::size_t i = 0; (i = text.find(standard_input_path, i)) != std::string::npos;
       i += standard_input_name.size())
    text.replace(i, standard_input_path.size(), standard_input_name);
  return text;
}

} // namespace program
