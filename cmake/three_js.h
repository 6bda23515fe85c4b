// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef EMBEDDED_THREE_JS_H
#define EMBEDDED_THREE_JS_H

#include <string_view>

// What the target embedded_three_js has.

namespace embedded {

/// returns the text of three.js; empty if it was not there.
std::string_view three_js();
/// returns the text of TrackballControls.js; empty if it was not there.
std::string_view trackball_controls_js();

} // namespace embedded

#endif // EMBEDDED_THREE_JS_H
