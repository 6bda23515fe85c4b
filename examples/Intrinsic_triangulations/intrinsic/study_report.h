// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STUDY_REPORT_H
#define INTRINSIC_STUDY_REPORT_H

#include <nlohmann/json.hpp>

#include <ostream>
#include <vector>

namespace program {

/*!
\brief writes the report of a study: one page of HTML with tables and plots, without scripts, that
needs nothing else.

The order of lines does not matter, except that of lines with the same mesh and arithmetic the last
counts.
\param lines what `intrinsic study` found, one object per mesh and arithmetic
\param html where the page goes
\throws std::invalid_argument if a line has no mesh, arithmetic or status
*/
void write_study_report(const std::vector<nlohmann::ordered_json>& lines, std::ostream& html);

} // namespace program

#endif // INTRINSIC_STUDY_REPORT_H
