// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_DELAUNAY_H
#define TEST_INTRINSIC_TRIANGULATIONS_DELAUNAY_H

#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <utility>

/// The Delaunay triangulation of an input.
template <class Triangulation, class Input>
Triangulation delaunay(Input&& input) {
  Triangulation t(std::forward<Input>(input));
  CGAL::Intrinsic_triangulations::flip_to_delaunay(t);
  return t;
}

#endif // TEST_INTRINSIC_TRIANGULATIONS_DELAUNAY_H
