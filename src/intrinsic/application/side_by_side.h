// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_APPLICATION_SIDE_BY_SIDE_H
#define INTRINSIC_APPLICATION_SIDE_BY_SIDE_H

#include "Computed.h"

namespace program {

/// returns two surfaces with functions of the same names, the second one to the right of the first.
Surface_with_fields side_by_side(Surface_with_fields left, const Surface_with_fields& right);

} // namespace program

#endif // INTRINSIC_APPLICATION_SIDE_BY_SIDE_H
