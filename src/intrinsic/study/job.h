// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STUDY_JOB_H
#define INTRINSIC_STUDY_JOB_H

#include "options.h"

// A job of the study: one arithmetic on one mesh, in a process of its own.

namespace program {

/// Exit code of a job that has run out of memory, and must not allocate any more.
constexpr int exit_out_of_memory = 3;

/*!
\brief limits this process, runs a job in it, and writes results to standard output: JSON lines,
each of which contains more than the one before.
\param job one location, one arithmetic, its surface and limits
*/
void run_study_job(const Study_options& job);

} // namespace program

#endif // INTRINSIC_STUDY_JOB_H
