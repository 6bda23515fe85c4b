// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TIME_LIMIT_H
#define INTRINSIC_TIME_LIMIT_H

#include "options.h"

namespace program {

/*!
\brief ends the program after its time limit, with a message and the code of failure.


It interrupts any step: a single predicate may take long, and algorithms call their visitors only in
between. It removes files that are not complete; no file has its final name yet, since the program
renames all of them together at the end.
\param options with a limit, and what the message names
*/
void end_at_time_limit(const Options& options);

} // namespace program

#endif // INTRINSIC_TIME_LIMIT_H
