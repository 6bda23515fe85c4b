// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only: the topics of the reference manual, in the order in which it lists them.
// doc/group_header.awk says which header belongs to which topic.

/*!
\defgroup page_reference Reference manual
\brief All names, by topic.

All names are in the namespace `CGAL::Intrinsic_triangulations` unless they say otherwise. Each of
the three packages has one header with what most programs need: `CGAL/Intrinsic_triangulations.h`,
`CGAL/Intrinsic_geodesics.h` and `CGAL/Intrinsic_operators.h`, which needs Eigen. A few names need
their own header: the adaptors of OpenMesh and `CGAL::Polyhedron_3` in `connectivity/adaptors/`,
`.idt` files in `IO/idt/`, pages in `IO/view/`. The page of each name says which header it is in.

Names that programs use come first. Read the topics whose names begin with *Inside* if you write a
model of a concept, or want to know how the package works. The comments cite sections, figures and
equations of the course *Geometry Processing with Intrinsic Triangulations* (Sharp, Gillespie, Crane
2021).
*/

/*!
\defgroup ref_concepts Concepts
\ingroup page_reference
\brief Requirements on template parameters: meaning, cost, and which operation needs which function.

A C++20 concept of the same name, in `CGAL::Intrinsic_triangulations`, checks the syntax of each.

Concepts of CGAL that pages name:
[Field](https://doc.cgal.org/latest/Algebraic_foundations/classField.html) (numbers with the four
operations), [FaceListGraph](https://doc.cgal.org/latest/BGL/classFaceListGraph.html),
[HalfedgeListGraph](https://doc.cgal.org/latest/BGL/classHalfedgeListGraph.html) and
[MutableFaceGraph](https://doc.cgal.org/latest/BGL/classMutableFaceGraph.html) (meshes by way of the
BGL). *An instance of* a class template is that template with any arguments.
*/

/*!
\defgroup ref_owner Triangulations
\ingroup page_reference
\brief The classes that own connectivity, metric and correspondence, and make moves; options and
results of all functions.

Begin with \itc{Intrinsic_triangulation}, or with \itc{Corresponding_triangulation} if you want
results on the input.
*/

/*!
\defgroup ref_input Input
\ingroup page_reference
\brief What a triangulation is built from, and remembers: meshes, arrays, lengths; names; treatment
of degenerate faces.
*/

/*!
\defgroup ref_arithmetic Arithmetic
\ingroup page_reference
\brief Traits: exact, floating point, with a tolerance; how predicates were decided.
*/

/*!
\defgroup ref_delaunay Flips and quality
\ingroup page_reference
\brief Flips to Delaunay, tests, the certificate; angles and aspect ratios.
*/

/*!
\defgroup ref_measures Measures
\ingroup page_reference
\brief Area, curvature and weights of a surface, its vertices and edges.
*/

/*!
\defgroup ref_refinement Refinement and optimization
\ingroup page_reference
\brief Vertices inserted until faces are good, or where an error is large; moved to an optimal
Delaunay triangulation.
*/

/*!
\defgroup ref_metrics Other metrics
\ingroup page_reference
\brief New lengths for old edges.
*/

/*!
\defgroup ref_correspondence Correspondence
\ingroup page_reference
\brief Where points and edges of one triangulation are on the other.
*/

/*!
\defgroup ref_subdivision Common subdivision
\ingroup page_reference
\brief Both triangulations in one polygon mesh.
*/

/*!
\defgroup ref_tracing Geodesics and tangent vectors
\ingroup page_reference
\brief Straight lines on either triangulation; vectors and fields on the other one.
*/

/*!
\defgroup ref_curves Geodesic curves
\ingroup page_reference
\brief Paths, loops and networks along edges, made geodesic by flips (chapter 5 of the course), and
the geodesics between points.
*/

/*!
\defgroup ref_operators Operators
\ingroup page_reference
\brief Matrices, solvers, estimates of errors, and transfer. They need Eigen.
*/

/*!
\defgroup ref_applications Applications
\ingroup page_reference
\brief Distances by heat, vectors, maps to the plane, editing. They need Eigen.
*/

/*!
\defgroup ref_io Files
\ingroup page_reference
\brief Meshes in; triangulations, subdivisions and pages out.

These pages describe the files: \ref page_file_format, \ref page_output_formats, \ref page_viewer.
*/

/*!
\defgroup ref_connectivity Connectivity
\ingroup page_reference
\brief Triangles that are glued together, from meshes and to meshes; topology, orientation.
*/

/*!
\defgroup ref_formulas Formulas
\ingroup page_reference
\brief The course's Appendix A and §2.3, in forms that lose nothing on needles and caps.
*/

/*!
\defgroup ref_inside Inside moves, algorithms and files
\ingroup page_reference
\brief Records of moves, which correspondences read; parts of refinement; buffers.
*/

/*!
\defgroup ref_inside_correspondence Inside correspondences
\ingroup page_reference
\brief Curves as integers, their crossings, both triangulations by numbers.
*/

/*!
\defgroup ref_inside_tracing Inside geodesics
\ingroup page_reference
\brief Directions at vertices, geodesics step by step.
*/

/*!
\defgroup ref_exact Inside exact arithmetic
\ingroup page_reference
\brief How exact arithmetic finds a sign that intervals leave open.

| step | where |
|---|---|
| the question | expressions such as \itc{Delaunay_expression}, models of \itc{DiamondExpression} |
| the record of its steps, to evaluate it beyond intervals of doubles | \itc{Recorded_diamond_expression}, \itc{Recorded_face_expression} |
| what decides, in which order | \itc{Exact_ladder}, Exact_ladder.cpp |
| the figure that it decides on | \itc{Unfolded_diamond}: input triangles under a diamond; \itc{Replayed_faces}: flips that made faces |
| the interface of a proof | \itc{Question}, \itc{ProofOf} |
| two input faces, in integers of fixed size | `Input_integers_proof`, of the sources |
| diamonds in one plane | \itc{Flat_proof} |
| cylinders and prisms | \itc{Prism_proof}, \itc{Prism_in_field_proof} |
| symmetric ties | \itc{Mirrored_proof} |
| all other zeros | \itc{Field_proof} |
*/

/*!
\defgroup ref_unfolding Inside unfolding
\ingroup page_reference
\brief The input triangles under a diamond or a face, and the flips that made it.
*/

/*!
\defgroup ref_numbers Inside numbers
\ingroup page_reference
\brief Square roots of rationals, and numbers of fixed precision with a bound on their error.
*/
