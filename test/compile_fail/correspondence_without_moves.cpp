// expect of templates: the third argument of Intrinsic_triangulation is a model of IntrinsicCorrespondence
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// An observer is told of all moves.

#include <CGAL/Intrinsic_triangulation.h>

namespace IT = CGAL::Intrinsic_triangulations;

struct Hears_of_flips {
  template <class Triangulation>
  void start(const Triangulation&) {}
  template <class Triangulation>
  bool before(const Triangulation&, const IT::Flip&) {
    return true;
  }
  template <class Triangulation>
  void after(const Triangulation&, const IT::Flip&) {}
};

int main() {
  IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, Hears_of_flips> t{
      IT::Intrinsic_input()};
  return static_cast<int>(t.number_of_vertices());
}
