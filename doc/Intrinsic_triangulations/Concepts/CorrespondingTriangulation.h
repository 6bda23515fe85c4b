// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class CorrespondingTriangulation CorrespondingTriangulation.h <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
\cgalConcept

The concept `CorrespondingTriangulation` describes a triangulation with a correspondence, which says
where it is on its input. The same queries serve every correspondence: integer coordinates, explicit
crossings, signposts.

\cgalRefines{\ref ::NumberedTriangulation}

\cgalHasModel{\itc{Intrinsic_triangulation} with any correspondence but \itc{No_correspondence}}

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| \itf{locate_on_input}, \itf{locate_on_intrinsic}, \itf{tangent_to_input}, \itf{tangent_to_intrinsic} | `correspondence`, `sign`, `sharpen`, `Metric::Scope` |
| \itf{trace_edge}, \itf{trace_input_edge}, \itf{polyline}, \itf{trace_geodesic_on_input} | `correspondence` |
| \itf{common_subdivision} | `correspondence` |
| \itf{copy_to_intrinsic}, \itf{vectors_in_space}, \itf{tangent_field_to_input}, \itf{tangent_field_to_intrinsic} | also `is_inserted`, `input_vertex` |

\cgalHeading{Invariants}

The correspondence describes the mesh and the metric as they are.

\cgalHeading{Complexity}

Constant time for everything but `sign`.
*/
class CorrespondingTriangulation {
public:
  /// Has a scope.
  class Metric {
  public:
    /// Default constructible; lives around every use of the metric.
    typedef unspecified_type Scope;
    /// Whether signs are exact.
    static bool is_exact;
  };

  /// returns the sign of an expression in the values of faces, which decides on which side of a
  /// curve a point lies; see \ref ::EuclideanMetric.
  template <class Expression>
  CGAL::Sign sign(std::span<const CGAL::Intrinsic_triangulations::Indexed_face> faces,
                  const Expression& expression) const;
  /// makes what is stored of faces as accurate as it can be.
  void sharpen(std::span<const CGAL::Intrinsic_triangulations::Indexed_face> faces) const;

  /// returns the correspondence: a model of \ref ::CurveCoordinates, or of
  /// \ref ::QueriedCorrespondence.
  unspecified_type correspondence() const;
};
