// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "improve.h"

namespace program {

template Json improve_and_measure(Loaded<Exact_triangulation>&, const Options&, Progress&);
template Json improve_and_measure(Loaded<Double_triangulation>&, const Options&, Progress&);

} // namespace program
