// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STUDY_STUDY_H
#define INTRINSIC_STUDY_STUDY_H

#include "options.h"

namespace program {

/*!
\brief runs arithmetics on meshes, and appends the results that a file does not have yet.
\throws std::exception naming what is missing, or what is wrong with the file
*/
void run_study(const Study_options& study);

} // namespace program

#endif // INTRINSIC_STUDY_STUDY_H
