// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_COARSE_OPTIONS_H
#define INTRINSIC_COARSE_OPTIONS_H

#include "option_groups.h"

// Options of the commands that make surfaces coarse, compare them, and embed them.

namespace program {

/// how coarse a surface becomes, and what is written.
void add_simplify_options(CLI::App& command, Options& options);
/// which vertices of a polyhedron count as flat.
void add_embed_options(CLI::App& command, Options& options);

} // namespace program

#endif // INTRINSIC_COARSE_OPTIONS_H
