// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A user's program: includes the library and links what it brings along.

#include <CGAL/Gmpfi.h>
#include <CGAL/Intrinsic_triangulations.h>

int main() {
  namespace IT = CGAL::Intrinsic_triangulations;
  const IT::Invalid_input error(IT::Element_kind::edge, 7, "linked");
  const CGAL::Gmpfi two = CGAL::Gmpfi(1) + CGAL::Gmpfi(1); // calls into MPFI and MPFR
  return error.index() == 7 && two.inf() == 2 && two.sup() == 2 ? 0 : 1;
}
