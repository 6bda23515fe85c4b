// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SOURCES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SOURCES_H

/*!
\file
All sources of the package `Intrinsic_simplification` and of those below it, for programs that do not link the library: exactly
one of their sources includes this file.
*/

#include <CGAL/Intrinsic_conformal_sources.h>

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SOURCES_H
