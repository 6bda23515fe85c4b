// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TIME_LIMIT_H
#define INTRINSIC_TIME_LIMIT_H

#include "options.h"

namespace program {

/*!
\brief ends the program after its limit of time, with a message and the code of failure, unless it is done before.

Whatever it is at, as a single predicate may take long: algorithms ask their visitors in between only. Files
that are not complete are removed; none has appeared, as all do together.
\param options with a limit, and what the message names
*/
void end_at_time_limit(const Options& options);

} // namespace program

#endif // INTRINSIC_TIME_LIMIT_H
