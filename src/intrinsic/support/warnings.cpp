// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "warnings.h"

#include <utility>

namespace program {

namespace {

std::vector<std::string> noted;

} // namespace

void warn(const std::string& message) { noted.push_back(message); }

std::vector<std::string> take_warnings() { return std::exchange(noted, {}); }

} // namespace program
