// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The topics of the reference manual, in the order in which it lists them, for doxygen,
// doc/group_header.awk and doc/list_members.py. A line `Headers:` above a topic names folders and
// headers that belong to it, relative to include/CGAL/Intrinsic_triangulations/ or include/CGAL/. The
// longest name that the path of a header starts with decides; others, the owners of a triangulation,
// belong to `ref_owner`.

/*!
\defgroup page_reference Reference manual
\brief All names, by topic.

All names are in the namespace `CGAL::Intrinsic_triangulations` unless they say otherwise. Each of
the five packages has one header with what most programs need: `CGAL/Intrinsic_triangulations.h`,
`CGAL/Intrinsic_geodesics.h`, `CGAL/Intrinsic_operators.h`, `CGAL/Intrinsic_conformal.h` and
`CGAL/Intrinsic_simplification.h`; the last three need Eigen. A few names need their own header: the adaptors of OpenMesh and `CGAL::Polyhedron_3` in `connectivity/adaptors/`,
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

// Headers: support/Invalid_input.h support/Status.h support/parameters.h
// Headers: triangulation/Flip_log.h triangulation/Session.h triangulation/Surface_point.h
/*!
\defgroup ref_owner Triangulations
\ingroup page_reference
\brief The classes that own connectivity, metric and correspondence, and make moves; options and
results of all functions.

Begin with \itc{Intrinsic_triangulation}, or with \itc{Corresponding_triangulation} if you want
results on the input.
*/

// Headers: domains/ input/
/*!
\defgroup ref_input Input
\ingroup page_reference
\brief What a triangulation is built from, and remembers: meshes, arrays, lengths; names; treatment
of degenerate faces.
*/

// Headers: exact/Predicate_statistics.h metric/
/*!
\defgroup ref_arithmetic Arithmetic
\ingroup page_reference
\brief Traits: exact, floating point, with a tolerance; how predicates were decided.
*/

// Headers: retriangulation/covers/restore_input_edges.h retriangulation/delaunay/
/*!
\defgroup ref_delaunay Flips and quality
\ingroup page_reference
\brief Flips to Delaunay, tests, the certificate; angles and aspect ratios.
*/

// Headers: triangulation/measures.h
/*!
\defgroup ref_measures Measures
\ingroup page_reference
\brief Area, curvature and weights of a surface, its vertices and edges.
*/

// Headers: retriangulation/optimization/ retriangulation/refinement/
/*!
\defgroup ref_refinement Refinement and optimization
\ingroup page_reference
\brief Vertices inserted until faces are good, or where an error is large; moved to an optimal
Delaunay triangulation.
*/

// Headers: input/metric_scaling/
/*!
\defgroup ref_metrics Other metrics
\ingroup page_reference
\brief New lengths for old edges.
*/

// Headers: correspondence/ correspondence/models/Explicit_crossings.h
// Headers: correspondence/models/Integer_coordinates.h correspondence/models/No_correspondence.h
// Headers: correspondence/models/Signposts.h
/*!
\defgroup ref_correspondence Correspondence
\ingroup page_reference
\brief Where points and edges of one triangulation are on the other.
*/

// Headers: correspondence/queries/common_subdivision.h correspondence/subdivision/
/*!
\defgroup ref_subdivision Common subdivision
\ingroup page_reference
\brief Both triangulations in one polygon mesh.
*/

// Headers: correspondence/queries/Vertex_frames.h correspondence/queries/Vertex_sectors.h
// Headers: correspondence/queries/tangent.h correspondence/queries/tangent_field.h
// Headers: correspondence/queries/trace_geodesic.h correspondence/queries/vector_field.h
// Headers: tracing/trace_geodesic.h
/*!
\defgroup ref_tracing Geodesics and tangent vectors
\ingroup page_reference
\brief Straight lines on either triangulation; vectors and fields on the other one.
*/

// Headers: Intrinsic_geodesics/
/*!
\defgroup ref_curves Geodesic curves
\ingroup page_reference
\brief Paths, loops and networks along edges, made geodesic by flips (chapter 5 of the course), and
the geodesics between points.
*/

// Headers: Intrinsic_operators/
/*!
\defgroup ref_operators Operators
\ingroup page_reference
\brief Matrices, solvers, estimates of errors, and transfer. They need Eigen.
*/

// Headers: Intrinsic_conformal/ Intrinsic_operators/distance/ Intrinsic_operators/editing/
// Headers: Intrinsic_operators/parametrization/ Intrinsic_operators/vectors/
/*!
\defgroup ref_applications Applications
\ingroup page_reference
\brief Distances by heat, vectors, maps to the plane, editing. They need Eigen.
*/

// Headers: Intrinsic_simplification/
/*!
\defgroup ref_simplification Coarse and equal surfaces
\ingroup page_reference
\brief Simplification with a proven stretch, isometries, convex polyhedra.
*/

// Headers: IO/
/*!
\defgroup ref_io Files
\ingroup page_reference
\brief Meshes in; triangulations, subdivisions and pages out.

These pages describe the files: \ref page_file_format, \ref page_output_formats, \ref page_viewer.
*/

// Headers: connectivity/
/*!
\defgroup ref_connectivity Connectivity
\ingroup page_reference
\brief Triangles that are glued together, from meshes and to meshes; topology, orientation.
*/

// Headers: formulas/
/*!
\defgroup ref_formulas Formulas
\ingroup page_reference
\brief The course's Appendix A and §2.3, in forms that lose nothing on needles and caps.
*/

// Headers: IO/support/ Intrinsic_operators/operators/Connection_graph.h
// Headers: Intrinsic_operators/operators/symmetric_assembly.h
// Headers: Intrinsic_operators/vectors/Direction_problem.h
// Headers: Intrinsic_operators/vectors/Heat_transport.h Intrinsic_operators/vectors/Point_frames.h
// Headers: connectivity/moves.h domains/Delaunay_star.h domains/triangulate_polygons.h
// Headers: domains/tufted_cover.h input/Input_metric.h input/Polygon_shaper.h
// Headers: input/initial_values.h input/position_on_face.h input/renumbering.h input/scaling.h
// Headers: input/triangulate_face_graph.h metric/nearest_lengths.h retriangulation/covers/
// Headers: retriangulation/delaunay/Delaunay_flipper.h retriangulation/optimization/Odt_optimizer.h
// Headers: retriangulation/optimization/Planar_star.h
// Headers: retriangulation/refinement/Constrained_segments.h
// Headers: retriangulation/refinement/Delaunay_refiner.h
// Headers: retriangulation/refinement/Refinement_moves.h
// Headers: retriangulation/refinement/Refinement_test.h retriangulation/refinement/dijkstra_ball.h
// Headers: retriangulation/refinement/locate_circumcenter.h triangulation/
/*!
\defgroup ref_inside Inside moves, algorithms and files
\ingroup page_reference
\brief Records of moves, which correspondences read; parts of refinement; buffers.
*/

// Headers: correspondence/Intrinsic_view.h correspondence/Sheets.h correspondence/curves/
// Headers: correspondence/models/ deciding/
/*!
\defgroup ref_inside_correspondence Inside correspondences
\ingroup page_reference
\brief Curves as integers, their crossings, both triangulations by numbers.
*/

// Headers: tracing/
/*!
\defgroup ref_inside_tracing Inside geodesics
\ingroup page_reference
\brief Directions at vertices, geodesics step by step.
*/

// Headers: exact/ formulas/Expression_steps.h formulas/Recorded_expression.h
// Headers: formulas/nonnegative_intervals.h metric/Enclosed_values.h
/*!
\defgroup ref_exact Inside exact arithmetic
\ingroup page_reference
\brief How exact arithmetic finds a sign that intervals leave open.

| step | where |
|---|---|
| the question | expressions such as \itc{Delaunay_expression}, models of \ref ::DiamondExpression |
| the record of its steps, to evaluate it beyond intervals of doubles | \itc{Recorded_diamond_expression}, \itc{Recorded_face_expression} |
| what decides, in which order | \itc{Exact_ladder}, Exact_ladder.cpp |
| the figure that it decides on | \itc{Unfolded_diamond}: input triangles under a diamond; \itc{Replayed_faces}: flips that made faces |
| the interface of a proof | \itc{Question}, \ref ::ProofOf |
| two input faces, in integers of fixed size | `Input_integers_proof`, of the sources |
| diamonds in one plane | \itc{Flat_proof} |
| cylinders and prisms | \itc{Prism_proof}, \itc{Prism_in_field_proof} |
| symmetric ties | \itc{Mirrored_proof} |
| all other zeros | \itc{Field_proof} |
*/

// Headers: exact/unfolding/
/*!
\defgroup ref_unfolding Inside unfolding
\ingroup page_reference
\brief The input triangles under a diamond or a face, and the flips that made it.
*/

// Headers: exact/numbers/
/*!
\defgroup ref_numbers Inside numbers
\ingroup page_reference
\brief Square roots of rationals, and numbers of fixed precision with a bound on their error.
*/
