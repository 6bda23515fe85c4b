// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "improve.h"

namespace program {

INTRINSIC_IMPROVEMENTS(template, Exact_triangulation);
INTRINSIC_IMPROVEMENTS(template, Double_triangulation);

} // namespace program
