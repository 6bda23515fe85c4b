// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STUDY_PROCESSES_H
#define INTRINSIC_STUDY_PROCESSES_H

#include "lines.h"
#include "sources.h"
#include "study.h"

#include <functional>
#include <string>
#include <vector>

namespace program {

/// An arithmetic to be run on a mesh.
struct Study_job {
  Study_source source;
  std::string arithmetic;
};

/*!
\brief runs jobs in processes of their own, each with limits.
\param jobs the jobs, which are started in this order
\param parallel how many processes run at a time
\param limits what each may take
\param finished called with the result of each job, in the order in which they end
\throws std::runtime_error if no process can be started
*/
void run_study_jobs(const std::vector<Study_job>& jobs, unsigned parallel,
                    const Study_limits& limits, const std::function<void(const Json&)>& finished);

} // namespace program

#endif // INTRINSIC_STUDY_PROCESSES_H
