// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_THREE_JS_H
#define INTRINSIC_THREE_JS_H

#include <string_view>

namespace program {

/// returns the text of three.js; empty if the program was built without it.
std::string_view three_js();
/// returns the text of TrackballControls.js; empty if the program was built without it.
std::string_view trackball_controls_js();

} // namespace program

#endif // INTRINSIC_THREE_JS_H
