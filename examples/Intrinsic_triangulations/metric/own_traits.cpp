// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Gives an intrinsic triangulation your own arithmetic: a metric that wraps another one and counts
// its calls. It inherits the rest of the metric.

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdint>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

//! [traits]
// an exact metric: where it is not certain, the triangulation decides
template <class Metric>
concept Answers_if_certain = requires(const Metric& m, const IT::Diamond& d) {
  m.certain_delaunay(d);
};

template <class Metric>
class Counting_metric : public Metric {
public:
  using Metric::Metric;

  // the one predicate of flip_to_delaunay()
  bool is_locally_delaunay(const IT::Diamond& d) const requires(!Answers_if_certain<Metric>) {
    ++predicates;
    return Metric::is_locally_delaunay(d);
  }
  // the same of an exact metric
  auto certain_delaunay(const IT::Diamond& d) const requires Answers_if_certain<Metric> {
    ++predicates;
    return Metric::certain_delaunay(d);
  }
  auto compute_flip(const IT::Diamond& d) const { // its one construction
    ++constructions;
    return Metric::compute_flip(d);
  }

  mutable std::uint64_t predicates = 0; // mutable: predicates are const
  mutable std::uint64_t constructions = 0;
};

template <class Traits>
struct Counting_traits {
  using FT = typename Traits::FT;
  using Metric = Counting_metric<typename Traits::Metric>;
};
static_assert(IT::IntrinsicTriangulationTraits<Counting_traits<IT::Exact_euclidean_traits>>);
//! [traits]

template <class Traits>
bool flip(const char* name, const Mesh& mesh) {
  IT::Intrinsic_triangulation<IT::Gluing_map, Counting_traits<Traits>> t(mesh);
  const IT::Flip_to_delaunay_result result = IT::flip_to_delaunay(t);
  std::cout << name << ": " << t.metric().predicates << " predicates, " << t.metric().constructions
            << " constructions for " << result.flips << " flips\n";
  // border edges, and edges with one face on both sides, are Delaunay without a call
  return t.metric().predicates <= result.checks && t.metric().predicates > 0 &&
         t.metric().constructions == result.flips + result.refused_flips;
}

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  return flip<IT::Exact_euclidean_traits>("exact ", mesh) &&
                 flip<IT::Euclidean_traits<double>>("double", mesh)
             ? 0
             : 1;
}
