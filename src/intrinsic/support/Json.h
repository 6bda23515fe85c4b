// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUPPORT_JSON_H
#define INTRINSIC_SUPPORT_JSON_H

#include <nlohmann/json.hpp>

namespace program {

/// JSON with keys in the order in which they are set. Numbers that are not finite become null.
using Json = nlohmann::ordered_json;

} // namespace program

#endif // INTRINSIC_SUPPORT_JSON_H
