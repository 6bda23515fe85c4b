// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STUDY_STUDY_H
#define INTRINSIC_STUDY_STUDY_H

#include "options.h"

namespace program {

/*!
\brief runs arithmetics on meshes and appends what they do to a file, but for what the file has already.
\throws std::exception naming what is missing, or wrong with the file
*/
void run_study(const Study_options& study);

} // namespace program

#endif // INTRINSIC_STUDY_STUDY_H
