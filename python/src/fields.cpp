// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"

namespace python {

void bind_fields(py::module_&) {}

} // namespace python
