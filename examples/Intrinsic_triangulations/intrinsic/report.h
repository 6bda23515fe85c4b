// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_REPORT_H
#define INTRINSIC_REPORT_H

#include "options.h"
#include "output_files.h"
#include "statistics.h"

namespace program {

/*!
\brief completes all outputs: adds the last measurements, writes the statistics, commits the files.
\param json the statistics
\param options where they go
\param files the files written so far
\param watch started when writing began
*/
void finish(Json& json, const Options& options, Output_files& files, Stopwatch& watch);

} // namespace program

#endif // INTRINSIC_REPORT_H
