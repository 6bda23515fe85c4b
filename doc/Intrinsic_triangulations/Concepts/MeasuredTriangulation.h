// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class MeasuredTriangulation concepts.h <CGAL/Intrinsic_triangulations/triangulation/concepts.h>
\cgalConcept

The concept `MeasuredTriangulation` describes a triangulation whose edges and faces have lengths,
areas and cotangents. Measures of shapes and matrices need these. The concept requires no flips.

\cgalHasModel{\itc{Intrinsic_triangulation} with traits whose metric is a model of \ref ::EuclideanMetric}

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| \itf{lumped_mass_matrix}, \itf{galerkin_mass_matrix} | `area`, `input_vertex`, `number_of_vertices`, `numbers` |
| \itf{cotangent_laplacian} | also `Const_session::cotangent_weight`, `Metric::is_degenerate`; `input` to name a face without area |
| \itf{solve_reaction_diffusion}, \itf{harmonic_green_function}, \itf{short_time_heat_kernel} | what the matrices need |
| \itf{residual_indicators} | also `squared_length` |
| \itf{cotangent_weight} | `Const_session::cotangent_weight` |
| \itf{total_area}, \itf{gaussian_curvature} | `area`; values of `Metric` |
| \itf{measure_quality} | values of `Metric`, `Const_session::cotangent_weight` |
| \itf{odt_energy} | values of `Metric` |

\cgalHeading{Invariants}

Those of \ref ::EuclideanMetric on values. Rows of different vertices differ and are below
`number_of_vertices()`.

\cgalHeading{Complexity}

Constant time for everything.
*/
class MeasuredTriangulation {
public:
  /// The connectivity: the part of \ref ::MutableDeltaComplex that reads.
  typedef unspecified_type Mesh;
  /// Vertex of the mesh.
  typedef unspecified_type vertex_descriptor;
  /// Halfedge of the mesh.
  typedef unspecified_type halfedge_descriptor;
  /// Edge of the mesh.
  typedef unspecified_type edge_descriptor;
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
    /// tells whether the area of a face is zero.
    bool is_degenerate(std::uint32_t face) const;
  };
  /// Constructed from a reference to the triangulation.
  class Const_session {
  public:
    /// returns half the sum of the cotangents of the angles opposite an edge, one of them on the
    /// border.
    double cotangent_weight(edge_descriptor e) const;
    /// the same; for an edge between two faces exact metrics allow an error, relative to the weight
    /// or to min(1, E), where E is the least Dirichlet energy in the two faces of functions that
    /// change by one along the edge; other metrics ignore `tolerance`.
    double cotangent_weight(edge_descriptor e, double tolerance) const;
  };

  /// returns the connectivity.
  const Mesh& mesh() const;
  /// returns the number of a vertex.
  std::uint32_t index(vertex_descriptor v) const;
  /// returns the number of an edge.
  std::uint32_t index(edge_descriptor e) const;
  /// returns the number of a face.
  std::uint32_t index(face_descriptor f) const;
  /// returns the area of a face, in the units of the input.
  double area(face_descriptor f) const;
  /// returns the row of a vertex in matrices: its number in the user's mesh, or one that follows
  /// those.
  std::uint32_t input_vertex(vertex_descriptor v) const;
  /// returns the number of vertices, which is that of rows.
  std::uint32_t number_of_vertices() const;
  /// returns what defines the surface that the triangulation was built from, for the names of its
  /// elements.
  const CGAL::Intrinsic_triangulations::Input_definition& input() const;
  /// returns the squared length of an edge, in the units of the input.
  double squared_length(edge_descriptor e) const;
  /// returns the metric.
  const Metric& metric() const;
  /// returns an object with members `edge_capacity(mesh)`, `face_capacity(mesh)`: bounds of
  /// numbers.
  unspecified_type numbers() const;
};
