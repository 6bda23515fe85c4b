// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_COMPILATION_H

/*!
\file
What takes long to compile is in headers `*_impl.h`. The headers that declare it include them: programs need nothing but
headers. Or it is compiled once: where `CGAL_INTRINSIC_TRIANGULATIONS_COMPILED` is defined, which the target
`Intrinsic_triangulations::Intrinsic_triangulations` does unless it is built without a library, they are left out, and programs
link a library with these definitions and those of the usual triangulations.
*/

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_BUILDS_LIBRARY
/// precedes functions in headers `*_impl.h`, which the library defines for all.
#define CGAL_INTRINSIC_TRIANGULATIONS_INLINE
#else
#define CGAL_INTRINSIC_TRIANGULATIONS_INLINE inline
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_COMPILATION_H
