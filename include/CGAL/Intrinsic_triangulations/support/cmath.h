// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_CMATH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_CMATH_H

/*!
\file
The standard functions of real numbers. Headers and sources of the library include this file in
place of `<cmath>`: the guard of libstdc++'s `<cmath>` does not surround the whole file, so that
compilers read its 1,900 lines again wherever it is included, and g++ keeps 5,900 locations each
time.
*/

#include <cmath>

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_CMATH_H
