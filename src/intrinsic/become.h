// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_BECOME_H
#define INTRINSIC_BECOME_H

#include <string>
#include <vector>

namespace program {

/*!
\brief replaces this program by another one of ours, with other arguments; it does not return.

Parts that take long to compile and that few users need are programs of their own, in the directory
of this one or on PATH.
\throws std::runtime_error if the program is not found, with the command that builds it
*/
[[noreturn]] void become(const std::string& program, const std::vector<std::string>& arguments);

} // namespace program

#endif // INTRINSIC_BECOME_H
