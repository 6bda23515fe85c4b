// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_APPLICATION_ISOMETRY_H
#define INTRINSIC_APPLICATION_ISOMETRY_H

#include "../options.h"

namespace program {

/// describes a mesh or an intrinsic triangulation, as it is, with the hash of its surface.
void run_info_with_hash(const Options& options);

} // namespace program

#endif // INTRINSIC_APPLICATION_ISOMETRY_H
