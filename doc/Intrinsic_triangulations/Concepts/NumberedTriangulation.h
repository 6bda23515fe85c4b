// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class NumberedTriangulation concepts.h <CGAL/Intrinsic_triangulations/triangulation/concepts.h>
\cgalConcept

The concept `NumberedTriangulation` describes a triangulation that finds its elements and their
values by numbers, and whose input names its elements. \itc{Intrinsic_view} reads it.

\cgalRefines{\ref ::IndexedTriangulation}

\cgalHasModel{\itc{Intrinsic_triangulation} with traits whose metric is a model of \ref ::EuclideanMetric}

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| \itf{surface_point}, \itf{face_location}, \itf{point_in_space} | `mesh`, `numbers`, `input` |
| \itf{trace_geodesic} | also values of `Metric` |
| \itf{constrained_input_edges}, \itc{Marked_edges} | `index`, `input`; a correspondence if there is one |
| \itf{subdivision_areas}, \itf{subdivision_mass_matrix}, \itc{L2_transfer}, \itf{L2_distance}, \itc{Face_vector_transfer} | also `area` |
| \itf{copy_to_input} | `input` |

\cgalHeading{Invariants}

Halfedges `2e` and `2e + 1` are the sides of edge `e`. Values are those of \ref ::NumberedComplex.

\cgalHeading{Complexity}

Constant time for everything.
*/
class NumberedTriangulation {
public:
  /// Face of the mesh.
  typedef unspecified_type face_descriptor;

  /// Stores the values, by number.
  class Metric {
  public:
    /// returns a double near the squared length of an edge, in scaled units.
    double approximate_squared_length(std::uint32_t edge) const;
    /// returns a double near four times the area of a face, in scaled units.
    double approximate_quadruple_area(std::uint32_t face) const;
    /// returns the exponent of the power of two that lengths are scaled by.
    int scale_exponent() const;
  };

  /// returns the area of a face, in the units of the input.
  double area(face_descriptor f) const;
  /// returns the metric.
  const Metric& metric() const;
};
