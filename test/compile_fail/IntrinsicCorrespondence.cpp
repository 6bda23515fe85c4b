// expect: satisfaction of .IntrinsicCorrespondence<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// An observer that is told after a flip only cannot know what was there before.

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

struct Hears_too_late {
  template <class Triangulation>
  void after(const Triangulation&, const CGAL::Intrinsic_triangulations::Flip&) {}
};

template <class Triangulation, class Correspondence>
  requires CGAL::Intrinsic_triangulations::IntrinsicCorrespondence<Correspondence, Triangulation>
void use(Correspondence&) {}

int main() {
  Hears_too_late correspondence;
  use<CGAL::Intrinsic_triangulations::Intrinsic_triangulation<>>(correspondence);
}
