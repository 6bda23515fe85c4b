// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STUDY_JOB_H
#define INTRINSIC_STUDY_JOB_H

#include "study_json.h"
#include "study_options.h"

#include <string>
#include <vector>

// A job of the study: one arithmetic on one mesh, in a process of its own.

namespace program {

/// returns the names of the arithmetics, in the order of the study.
std::vector<std::string> study_arithmetics();

/// How a job ends that has no memory left: without another allocation.
constexpr int exit_out_of_memory = 3;

/*!
\brief limits this process, runs a job in it, and writes what is found to standard output: JSON lines, each of
which says more than the one before.
*/
void run_study_job(const std::string& location, const std::string& arithmetic,
                   const Study_limits& limits);

} // namespace program

#endif // INTRINSIC_STUDY_JOB_H
