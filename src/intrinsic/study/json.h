// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STUDY_JSON_H
#define INTRINSIC_STUDY_JSON_H

#include <nlohmann/json.hpp>

namespace program {

/// Findings, with keys in the order in which they are set.
using Json = nlohmann::ordered_json;

} // namespace program

#endif // INTRINSIC_STUDY_JSON_H
