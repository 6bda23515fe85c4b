// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STUDY_MACHINE_H
#define INTRINSIC_STUDY_MACHINE_H

#include <string>

namespace program {

/// names the machine, as far as times depend on it: processor, how many of them, system.
std::string machine();

} // namespace program

#endif // INTRINSIC_STUDY_MACHINE_H
