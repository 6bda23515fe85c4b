// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SOURCES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SOURCES_H

/*!
\file
All sources of the package `Intrinsic_triangulations`, for programs that do not link the library: exactly one of
their sources includes this file.
*/

#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.cpp>

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SOURCES_H
