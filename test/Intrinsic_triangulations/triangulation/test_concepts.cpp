// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include "archetypes.h"
#include "gallery.h"
#include "mesh_types.h"

#include <CGAL/Integer_only_triangulation.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/No_correspondence.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/metric/Euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Integer_only_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Interval_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Tolerant_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/delaunay_tessellation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <CGAL/Gmpq.h>

#include <gtest/gtest.h>

#include <ratio>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

// ---- MutableDeltaComplex

static_assert(IT::MutableDeltaComplex<IT::Gluing_map>);
static_assert(IT::MutableDeltaComplex<Surface_mesh>);
static_assert(IT::MutableDeltaComplex<Polyhedron>);
static_assert(IT::MutableDeltaComplex<Polyhedron_with_ids>);
static_assert(IT::MutableDeltaComplex<OpenMesh_triangles>);
static_assert(IT::MutableDeltaComplex<OpenMesh_polygons>);
static_assert(!IT::MutableDeltaComplex<int>);
static_assert(!IT::MutableDeltaComplex<std::vector<int>>);
static_assert(!IT::MutableDeltaComplex<IT::Gluing>);
static_assert(!IT::MutableDeltaComplex<const IT::Gluing_map>);

// ---- IntrinsicMetric

struct Metric_that_cannot_flip : archetypes::Metric {
  using archetypes::Metric::Metric;
  void store_flip(const IT::Diamond&, const Flipped&) = delete;
};
struct Metric_that_may_fail : archetypes::Metric {
  using archetypes::Metric::Metric;
  void store_flip(const IT::Diamond&, const Flipped&) {}
};
struct Metric_without_scope : archetypes::Metric {
  using archetypes::Metric::Metric;

private:
  using Scope = void;
};
struct Metric_without_input : archetypes::Metric {};

static_assert(IT::IntrinsicMetric<archetypes::Flipping_metric>);
static_assert(IT::IntrinsicMetric<archetypes::Metric>);
static_assert(IT::IntrinsicMetric<IT::Ideal_hyperbolic_metric<double>>);
static_assert(IT::IntrinsicMetric<IT::Euclidean_metric<double>>);
static_assert(IT::IntrinsicMetric<IT::Euclidean_metric<long double>>);
static_assert(IT::RefinableMetric<IT::Exact_euclidean_metric>);
static_assert(IT::RefinableMetric<IT::Interval_metric>);
static_assert(IT::RefinableMetric<IT::Tolerant_traits<double, std::micro>::Metric>);
static_assert(IT::RefinableMetric<IT::Euclidean_metric<CGAL::Gmpq>>);
static_assert(IT::IntrinsicMetric<IT::Exact_ideal_hyperbolic_metric>);
static_assert(IT::IntrinsicMetric<IT::Integer_only_metric>);
static_assert(!IT::IntrinsicMetric<Metric_that_may_fail>);
static_assert(!IT::IntrinsicMetric<Metric_that_cannot_flip>);
static_assert(!IT::IntrinsicMetric<Metric_without_scope>);
static_assert(!IT::IntrinsicMetric<Metric_without_input>);
static_assert(!IT::IntrinsicMetric<archetypes::Flips>);
static_assert(!IT::IntrinsicMetric<double>);

// ---- EuclideanMetric

static_assert(IT::EuclideanMetric<archetypes::Metric>);
static_assert(IT::EuclideanMetric<IT::Euclidean_metric<double>>);
static_assert(IT::EuclideanMetric<IT::Exact_euclidean_metric>);
static_assert(!IT::EuclideanMetric<archetypes::Flipping_metric>);
static_assert(!IT::EuclideanMetric<IT::Ideal_hyperbolic_metric<double>>);

// ---- IntrinsicTriangulationTraits

struct Traits_of_two_minds {
  using FT = float;
  using Metric = archetypes::Metric;
};

static_assert(IT::IntrinsicTriangulationTraits<archetypes::Traits>);
static_assert(IT::IntrinsicTriangulationTraits<IT::Euclidean_traits<double>>);
static_assert(IT::IntrinsicTriangulationTraits<IT::Exact_euclidean_traits>);
static_assert(!IT::IntrinsicTriangulationTraits<Traits_of_two_minds>);
static_assert(!IT::IntrinsicTriangulationTraits<IT::Exact_euclidean_metric>);
static_assert(!IT::IntrinsicTriangulationTraits<double>);

// ---- IntrinsicTriangulation

using Archetypical =
    IT::Intrinsic_triangulation<IT::Gluing_map, archetypes::Traits, archetypes::Correspondence>;
using Flipping = IT::Intrinsic_triangulation<IT::Gluing_map, archetypes::Flipping_traits,
                                             archetypes::Correspondence>;

struct Triangulation_without_sessions {
  using Mesh = IT::Gluing_map;
  using Metric = archetypes::Triangulation::Metric;
  using halfedge_descriptor = Mesh::Halfedge;
  using edge_descriptor = Mesh::Edge;
  const Mesh& mesh() const;
  std::uint32_t index(edge_descriptor) const;
};

static_assert(IT::IntrinsicTriangulation<archetypes::Triangulation>);
static_assert(IT::IntrinsicTriangulation<Archetypical>);
static_assert(IT::IntrinsicTriangulation<Flipping>);
static_assert(IT::IntrinsicTriangulation<IT::Intrinsic_triangulation<>>);
static_assert(IT::IntrinsicTriangulation<
              IT::Intrinsic_triangulation<Surface_mesh, IT::Euclidean_traits<double>>>);
static_assert(IT::IntrinsicTriangulation<IT::Intrinsic_triangulation<OpenMesh_polygons>>);
static_assert(!IT::IntrinsicTriangulation<Triangulation_without_sessions>);
static_assert(!IT::IntrinsicTriangulation<IT::Gluing_map>);

// ---- IntrinsicCorrespondence

struct Correspondence_that_hears_nothing {};
struct Correspondence_that_hears_too_late {
  template <class Triangulation>
  void after(const Triangulation&, const IT::Flip&) {}
};
struct Correspondence_that_cannot_refuse : archetypes::Correspondence {
  template <class Triangulation>
  void before(const Triangulation&, const IT::Removal_from_face&) const {}
};
struct Correspondence_that_changes_when_asked : archetypes::Correspondence {
  template <class Triangulation, class Move>
  bool before(const Triangulation&, const Move&) {
    return true;
  }
};

struct Correspondence_that_may_fail : archetypes::Correspondence {
  template <class Triangulation, class Move>
  void after(const Triangulation&, const Move&) {}
};
struct Correspondence_without_room : archetypes::Correspondence {
  template <class Triangulation, class Move>
  void make_room(const Triangulation&, const Move&) = delete;
};

static_assert(IT::IntrinsicCorrespondence<archetypes::Correspondence, archetypes::Triangulation>);
static_assert(IT::IntrinsicCorrespondence<IT::No_correspondence, archetypes::Triangulation>);
static_assert(IT::IntrinsicCorrespondence<IT::No_correspondence, IT::Intrinsic_triangulation<>>);
static_assert(!IT::IntrinsicCorrespondence<Correspondence_that_hears_nothing, Archetypical>);
static_assert(!IT::IntrinsicCorrespondence<Correspondence_that_hears_too_late, Archetypical>);
static_assert(!IT::IntrinsicCorrespondence<Correspondence_that_cannot_refuse, Archetypical>);
static_assert(!IT::IntrinsicCorrespondence<Correspondence_that_changes_when_asked, Archetypical>);
static_assert(!IT::IntrinsicCorrespondence<Correspondence_that_may_fail, Archetypical>);
static_assert(!IT::IntrinsicCorrespondence<Correspondence_without_room, Archetypical>);
// what is noexcept in the concepts is so in all models of the package
template <class Correspondence>
constexpr bool follows_moves = IT::IntrinsicCorrespondence<
    Correspondence,
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, Correspondence>>;
static_assert(follows_moves<IT::Integer_coordinates>);
static_assert(follows_moves<IT::Explicit_crossings>);
static_assert(follows_moves<IT::Signposts>);
static_assert(follows_moves<IT::Unfoldable_coordinates>);

// ---- what a correspondence can do besides

using Usual = IT::Intrinsic_triangulation<>;
using With_signposts =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, IT::Signposts>;

static_assert(IT::RepositioningCorrespondence<IT::No_correspondence, Usual>);
static_assert(IT::RepositioningCorrespondence<IT::Signposts, With_signposts>);
static_assert(!IT::RepositioningCorrespondence<IT::Integer_coordinates, Usual>);
static_assert(!IT::RepositioningCorrespondence<archetypes::Correspondence, Archetypical>);

static_assert(IT::RestorableCorrespondence<IT::No_correspondence, Usual>);
static_assert(IT::RestorableCorrespondence<IT::Integer_coordinates, Usual>);
static_assert(!IT::RestorableCorrespondence<IT::Signposts, Usual>);
static_assert(!IT::RestorableCorrespondence<archetypes::Correspondence, Archetypical>);

static_assert(IT::IntegerCorrespondence<IT::Integer_coordinates>);
static_assert(!IT::IntegerCorrespondence<IT::Signposts>);
static_assert(!IT::IntegerCorrespondence<IT::No_correspondence>);

static_assert(IT::QueriedCorrespondence<IT::Signposts, With_signposts>);
static_assert(!IT::QueriedCorrespondence<IT::Integer_coordinates, Usual>);
static_assert(!IT::QueriedCorrespondence<archetypes::Correspondence, Archetypical>);

// ---- the archetypes are enough for the algorithms

TEST(Concepts, flip_to_delaunay_asks_no_more_of_a_triangulation_than_its_concept) {
  archetypes::Triangulation t{IT::Gluing_map(gallery::flat_torus(3, 3).gluing)};
  EXPECT_FALSE(IT::is_delaunay(t));
  EXPECT_EQ(IT::check_delaunay(t).non_delaunay_edges, 27U);
  const IT::Flip_to_delaunay_result r = IT::flip_to_delaunay(t);
  EXPECT_EQ(r.status, IT::Status::done);
  EXPECT_EQ(r.flips, 27U);
  EXPECT_TRUE(IT::is_delaunay(t));
}

TEST(Concepts, owner_asks_no_more_of_metric_and_correspondence_than_their_concepts) {
  const gallery::Surface s = gallery::flat_torus(3, 3);
  Archetypical t(gallery::input(s));
  EXPECT_TRUE(IT::is_delaunay(t));
  EXPECT_TRUE(IT::check_delaunay(t).cocircular_edges.empty());
  EXPECT_EQ(IT::flip_to_delaunay(t).flips, 0U);
  const IT::Gluing_map::Edge e{0};
  EXPECT_EQ(t.flip_edge({0}), IT::Move_status::done);
  EXPECT_EQ(t.squared_length(e), 1.0);
  EXPECT_EQ(t.area({0}), 0.25);
}

TEST(Concepts, flips_and_tessellations_need_neither_lengths_nor_areas) {
  Flipping t(gallery::input(gallery::flat_torus(3, 3)));
  EXPECT_TRUE(IT::is_delaunay(t));
  EXPECT_EQ(IT::flip_to_delaunay(t).flips, 0U);
  EXPECT_EQ(t.flip_edge({0}), IT::Move_status::done);
  IT::Gluing_map cells;
  EXPECT_EQ(IT::delaunay_tessellation(t, cells).number_of_cells, 18U);
}

TEST(Concepts, correspondence_hears_of_each_flip_before_and_after_and_of_no_refused_one) {
  const gallery::Surface s = gallery::self_folded_cone();
  Archetypical t(gallery::input(s));
  for (std::uint32_t h = 0; h < t.mesh().number_of_halfedges(); ++h)
    EXPECT_NE(t.flip_edge({h}), IT::Move_status::done);
  EXPECT_EQ(t.correspondence().announced, 0);
  const gallery::Surface torus = gallery::one_vertex_torus();
  Archetypical u(gallery::input(torus));
  EXPECT_EQ(u.flip_edge({0}), IT::Move_status::done);
  EXPECT_EQ(u.correspondence().announced, 1);
  EXPECT_EQ(u.correspondence().done, 1);
}
