// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_COMPILATION_H

/*!
\file
What takes long to compile is in headers `*_impl.h`, or at the end of the header that declares it. Programs need nothing
but headers. Or it is compiled once: where `CGAL_INTRINSIC_TRIANGULATIONS_COMPILED` is defined, which the target
`Intrinsic_triangulations::Intrinsic_triangulations` does unless it is built without a library, it is left out, and programs
link a library with these definitions and those of the usual triangulations.
*/

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
/// tells, after `#if`, whether a header defines what a source of the library compiles: that source
/// defines `CGAL_INTRINSIC_TRIANGULATIONS_IN_` and its name.
#define CGAL_INTRINSIC_TRIANGULATIONS_DEFINES(source) CGAL_INTRINSIC_TRIANGULATIONS_IN_##source
#else
#define CGAL_INTRINSIC_TRIANGULATIONS_DEFINES(source) 1
#endif

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_BUILDS_LIBRARY
/// precedes functions that the library defines for all.
#define CGAL_INTRINSIC_TRIANGULATIONS_INLINE
#else
#define CGAL_INTRINSIC_TRIANGULATIONS_INLINE inline
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_COMPILATION_H
