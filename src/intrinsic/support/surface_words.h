// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUPPORT_SURFACE_WORDS_H
#define INTRINSIC_SUPPORT_SURFACE_WORDS_H

#include <string>
#include <vector>

// What the command line says about surfaces. Apart from what makes them, which takes long to
// compile.

namespace program {

/// The words that name surfaces, see `surface_options()`.
inline const std::vector<std::string> surface_words{"auto",   "manifold", "orientation-cover",
                                                    "tufted", "closed",   "points"};

/// What they mean.
inline const std::string surface_description =
    "surface to make from the file: auto (the first of these that its faces allow; points if it "
    "has none; default), manifold, orientation-cover, tufted, closed (the first of these without "
    "border), or points (ignores faces)";

} // namespace program

#endif // INTRINSIC_SUPPORT_SURFACE_WORDS_H
