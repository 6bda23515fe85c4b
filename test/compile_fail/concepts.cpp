// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A case per concept: arguments that are no model of it, and a message that names it.

#include <CGAL/Integer_only_triangulation.h>
#include <CGAL/Intrinsic_conformal/layout/conformal_sphere.h>
#include <CGAL/Intrinsic_geodesics/queries/add_geodesics.h>
#include <CGAL/Intrinsic_operators/operators/connection_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_simplification/simplification/simplify.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Edge_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/follow_signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/mirrored.h>
#include <CGAL/Intrinsic_triangulations/formulas/Expression_steps.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/scale_metric.h>
#include <CGAL/Intrinsic_triangulations/metric/Euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/SparseCore>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

using namespace CGAL::Intrinsic_triangulations;

namespace case_ConnectedTriangulation {
// Integers have no angles to transport vectors by.
// error: satisfaction of .ConnectedTriangulation<
void misuse(const Integer_only_triangulation<>& t) { connection_laplacian(t); }
} // namespace case_ConnectedTriangulation

namespace case_CorrespondingTriangulation {
// Correspondence alone does not answer queries where no values are stored.
// error: satisfaction of .CorrespondingTriangulation<
void misuse(const Integer_only_triangulation<>& t) { common_subdivision(t); }
} // namespace case_CorrespondingTriangulation

namespace case_CurveCoordinates {
// Directions are no curves.
// error: satisfaction of .CurveCoordinates<
void misuse(const Intrinsic_triangulation<Gluing_map, Euclidean_traits<double>, Signposts>& t) {
  edge_crossings(t, t.correspondence());
}
} // namespace case_CurveCoordinates

namespace case_DiamondExpression {
// An expression in faces is not one in a diamond.
// error: satisfaction of .DiamondExpression<
void misuse() { recorded(Wedge_cosine_expression()); }
} // namespace case_DiamondExpression

namespace case_FaceExpression {
// An expression in a diamond is not one in faces.
// error: satisfaction of .FaceExpression<
void misuse() { Recorded_face_expression(Delaunay_expression(), 2); }
} // namespace case_FaceExpression

namespace case_FaceNorm {
// A norm is of a vector in a face, not of a vector alone.
// error: satisfaction of .FaceNorm<
void misuse() {
  scale_by_norm(Gluing_map(), [](Unscaled_vector) { return 1.0; });
}
} // namespace case_FaceNorm

namespace case_FaceRange {
// Points are no faces.
// error: satisfaction of .FaceRange<
void misuse(const std::vector<std::array<double, 3>>& points) {
  triangle_soup(points, std::vector<int>{0, 1, 2});
}
} // namespace case_FaceRange

namespace case_Factorization {
// A matrix is not factored yet.
template <Factorization Factored>
class Solver;
// error: satisfaction of .Factorization<
void misuse(Solver<Eigen::SparseMatrix<double>>* solver);
} // namespace case_Factorization

namespace case_FieldNumber {
// Degrees of polynomials have no quotient.
// error: satisfaction of .FieldNumber<
void misuse(const Expression_degree& length) {
  apex(length, length, length, Expression_degree::area());
}
} // namespace case_FieldNumber

namespace case_GeodesicTriangulation {
// A triangulation without a metric does not compare angles, nor take flips back.
// error: satisfaction of .GeodesicTriangulation<
void misuse(Integer_only_triangulation<>& t) { insert_geodesic(t, {}, {}); }
} // namespace case_GeodesicTriangulation

namespace case_IntegerCorrespondence {
// Signposts are directions.
// error: satisfaction of .IntegerCorrespondence<
template <IntegerCorrespondence Correspondence>
void use(const Correspondence&) {}
void misuse(const Signposts& signposts) { use(signposts); }
} // namespace case_IntegerCorrespondence

namespace case_IntrinsicCorrespondence {
// An observer that is told after a flip only cannot know what was there before.
// error: satisfaction of .IntrinsicCorrespondence<
struct Hears_too_late {
  template <class Triangulation>
  void after(const Triangulation&, const Flip&) {}
};
template <class Triangulation, class Correspondence>
  requires IntrinsicCorrespondence<Correspondence, Triangulation>
void use(Correspondence&) {}
void misuse(Hears_too_late& correspondence) { use<Intrinsic_triangulation<>>(correspondence); }
} // namespace case_IntrinsicCorrespondence

namespace case_Has_horocycles {
// Euclid's lengths have no factors of vertices.
// error: satisfaction of .Has_horocycles<
void misuse(Intrinsic_triangulation<Gluing_map, Euclidean_traits<double>>& t,
            const Sphere_layout& layout) {
  logarithmic_scale(t, layout);
}
} // namespace case_Has_horocycles

namespace case_IntrinsicMetric {
// A metric that decides nothing.
// error: satisfaction of .IntrinsicMetric<
struct Lengths_only {
  using FT = double;
  struct Scope {};
  double squared_length(std::uint32_t) const { return 1; }
};
template <IntrinsicMetric Metric>
void use(Metric&) {}
void misuse(Lengths_only& metric) { use(metric); }
} // namespace case_IntrinsicMetric

namespace case_EuclideanMetric {
// An ideal hyperbolic metric has no lengths.
// error: EuclideanMetric<
using Hyperbolic = Intrinsic_triangulation<Gluing_map, Ideal_hyperbolic_traits<double>>;
double misuse(const Hyperbolic& t) { return t.length(Gluing_map::Edge{0}); }
} // namespace case_EuclideanMetric

namespace case_IndexedTriangulation {
// A mesh has no numbers of elements.
// error: satisfaction of .IndexedTriangulation<
template <IndexedTriangulation Triangulation>
void use(const Triangulation&) {}
void misuse(const Gluing_map& mesh) { use(mesh); }
} // namespace case_IndexedTriangulation

namespace case_IntrinsicTriangulation {
// What has neither a mesh nor a metric has no Delaunay triangulation.
// error: satisfaction of .IntrinsicTriangulation<
struct Nothing {};
void misuse(const Nothing& nothing) { is_delaunay(nothing); }
} // namespace case_IntrinsicTriangulation

namespace case_IntrinsicTriangulationTraits {
// A number type is not yet a traits class.
// error: satisfaction of .IntrinsicTriangulationTraits<
void misuse(Intrinsic_triangulation<Gluing_map, double>*);
} // namespace case_IntrinsicTriangulationTraits

namespace case_MeasuredTriangulation {
// A triangulation that stores no lengths has no cotangents.
// error: satisfaction of .MeasuredTriangulation<
void misuse(const Integer_only_triangulation<>& t) { cotangent_laplacian(t); }
} // namespace case_MeasuredTriangulation

namespace case_MutableDeltaComplex {
// A list of gluings cannot be flipped.
// error: satisfaction of .MutableDeltaComplex<
void misuse(Intrinsic_triangulation<Gluing, Euclidean_traits<double>>*);
} // namespace case_MutableDeltaComplex

namespace case_NamedParameters {
// A word names no option.
// error: satisfaction of .NamedParameters<
void misuse(Intrinsic_triangulation<>& t, const std::string& word) { delaunay_refine(t, word); }
} // namespace case_NamedParameters

namespace case_NormalCoordinates {
// A list of numbers is not read by edges.
// error: satisfaction of .NormalCoordinates<
void misuse(const Input& input) { corner_coordinates(input, std::vector<int>(3), 0); }
} // namespace case_NormalCoordinates

namespace case_NumberedComplex {
// Connectivity without lengths has no geodesics.
// error: satisfaction of .NumberedComplex<
void misuse(const Gluing_map& mesh) { angle_at_source(mesh, 0); }
} // namespace case_NumberedComplex

namespace case_NumberedTriangles {
// A mesh gives halfedges, no numbers.
// error: satisfaction of .NumberedTriangles<
void misuse(const Gluing_map& mesh) { sides_of_face(mesh, 0); }
} // namespace case_NumberedTriangles

namespace case_NumberedTriangulation {
// A mesh has places, but no input that it was built from.
// error: satisfaction of .NumberedTriangulation<
void misuse(const Gluing_map& mesh) { point_in_space(mesh, Surface_point{}, mesh); }
} // namespace case_NumberedTriangulation

namespace case_PointRange {
// Coordinates that are not in points are no points.
// error: satisfaction of .PointRange<
void misuse(const std::vector<std::array<int, 3>>& faces) {
  triangle_soup(std::vector<double>(9), faces);
}
} // namespace case_PointRange

namespace case_ProofOf {
// Reflections prove zeros of diamonds, not of faces.
// error: satisfaction of .ProofOf<
template <class Asked, ProofOf<Asked> Proof>
void use(Proof&) {}
void misuse(Mirrored_proof& proof) {
  use<Question<Unfolded_faces, Recorded_face_expression>>(proof);
}
} // namespace case_ProofOf

namespace case_QueriedCorrespondence {
// Curves have no answers of their own: `Curve_queries` finds them.
// error: satisfaction of .QueriedCorrespondence<
template <class Triangulation, class Correspondence>
  requires QueriedCorrespondence<Correspondence, Triangulation>
void use(const Correspondence&) {}
void misuse(const Integer_coordinates& c) { use<Intrinsic_triangulation<>>(c); }
} // namespace case_QueriedCorrespondence

namespace case_QueriedTriangulation {
// A mesh is on no other surface.
// error: satisfaction of .QueriedTriangulation<
void misuse(const Gluing_map& mesh) { locate_on_input(mesh, Surface_point{}); }
} // namespace case_QueriedTriangulation

namespace case_ReadableFaceGraph {
// A soup of triangles has no halfedges.
// error: satisfaction of .ReadableFaceGraph<
void misuse(const Triangle_soup& soup) { euler_characteristic(soup); }
} // namespace case_ReadableFaceGraph

namespace case_RefinableMetric {
// A metric that only flips.
// error: satisfaction of .RefinableMetric<
struct Only_flips : Euclidean_metric<double> {
  using Euclidean_metric::Euclidean_metric;
  void insert_in_face(const Vertex_star&, const Vertex_move_values<double>&) = delete;
};
template <RefinableMetric Metric>
void use(Metric&) {}
void misuse(Only_flips& metric) { use(metric); }
} // namespace case_RefinableMetric

namespace case_RefinableTriangulation {
// A triangulation whose edges flip, but whose vertices stay, cannot be refined.
// error: satisfaction of .RefinableTriangulation<
void misuse(Integer_only_triangulation<>& t) { delaunay_refine(t); }
} // namespace case_RefinableTriangulation

namespace case_RemovalCost {
// A cost is of a vertex that could be removed, not of its name.
// error: satisfaction of .RemovalCost<
template <RemovalCost Cost>
void use(const Cost&) {}
void misuse() {
  use([](const std::string& name) { return name.size(); });
}
} // namespace case_RemovalCost

namespace case_RepositioningCorrespondence {
// Integers do not follow a vertex within its star.
// error: satisfaction of .RepositioningCorrespondence<
template <class Triangulation, class Correspondence>
  requires RepositioningCorrespondence<Correspondence, Triangulation>
void use(Correspondence&) {}
void misuse(Integer_coordinates& c) { use<Intrinsic_triangulation<>>(c); }
} // namespace case_RepositioningCorrespondence

namespace case_RestorableCorrespondence {
// Signposts are not made from integers.
// error: satisfaction of .RestorableCorrespondence<
template <class Triangulation, class Correspondence>
  requires RestorableCorrespondence<Correspondence, Triangulation>
void use(Correspondence&) {}
void misuse(Signposts& signposts) { use<Intrinsic_triangulation<>>(signposts); }
} // namespace case_RestorableCorrespondence

namespace case_RingNumber {
// Words have sums, but no products.
// error: satisfaction of .RingNumber<
void misuse(const std::string& word) { squared_quadruple_area(word, word, word); }
} // namespace case_RingNumber

namespace case_ScalableSurface {
// A soup of triangles has no metric between its faces.
// error: satisfaction of .ScalableSurface<
void misuse(const Triangle_soup& soup) {
  scale_conformally(soup, [](int) { return 0.0; });
}
} // namespace case_ScalableSurface

namespace case_SignpostDirections {
// Curves have no directions.
// error: satisfaction of .SignpostDirections<
void misuse(
    const Intrinsic_triangulation<Gluing_map, Euclidean_traits<double>, Integer_coordinates>& t) {
  trace_edges(t, t.correspondence());
}
} // namespace case_SignpostDirections

namespace case_TriangleRange {
// Numbers of vertices that are not in triples are no triangles.
// error: satisfaction of .TriangleRange<
void misuse() { gluing_from_triangles(3, std::vector<int>{0, 1, 2}); }
} // namespace case_TriangleRange

namespace case_TriangulationWithMetric {
// A triangulation that stores no lengths has no metric to scale.
// error: satisfaction of .TriangulationWithMetric<
template <TriangulationWithMetric Triangulation>
void use(const Triangulation&) {}
void misuse(const Integer_only_triangulation<>& t) { use(t); }
} // namespace case_TriangulationWithMetric

namespace case_VertexFactors {
// A factor is of a vertex, not of a face.
// error: satisfaction of .VertexFactors<
void misuse(const Gluing_map& mesh) {
  scale_conformally(mesh, [](Gluing_map::Face) { return 0.0; });
}
} // namespace case_VertexFactors

namespace case_WritableFaceGraph {
// A constant mesh is not built.
// error: satisfaction of .WritableFaceGraph<
void misuse(const Gluing_map& mesh) { copy_gluing_map(mesh, mesh); }
} // namespace case_WritableFaceGraph
